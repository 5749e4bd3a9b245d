//! How a joint moves, apart from what resists it there: the two halves of a joint of a user's own ([`extend`](crate::extend)).
//!
//! [`Kinematics`] are how one coordinate moves the outboard side, and the elimination that follows from it: a revolute or prismatic joint
//! without springs, each written once. A [`JointModel`] is such kinematics and what acts along the coordinate: a force with its slopes,
//! energy, reflected inertia. No model knows of relations or gains, no kinematics of springs.

use crate::element::Reading;
use crate::error::Fault;
use crate::error::checks::not_negative;
use crate::relation::{AccelerationOf, Closures, Full, Part};
pub use crate::release::Resistance;
use crate::release::{Freedom, Release};
use crate::scalar::Scalar;
use crate::shape::{Joint, JointPosture};
use crate::space::{FrameOf, RealOf, Space};
use crate::sweep::{Implicit, Springs, Sweep};
use core::fmt::Debug;
use num_traits::Zero;

/// A relation that resists a joint: that of a body, alone or with what lies outboard of it.
#[diagnostic::on_unimplemented(
    message = "a joint needs a body on its outboard side, but meets `{Self}`",
    label = "no body outboard of a joint",
    note = "end a chain with a body, and put a body between two joints"
)]
pub trait Outboard<S: Space>: Copy {
    /// Closure forces that the relation carries.
    type Closures: Closures;
    /// The relation in full.
    fn whole(self) -> Full<S, Self::Closures>;
}

/// What acts in a joint with one coordinate: a generalised force (N·m, N), or nothing.
pub trait Driving<S: Space>: Part {
    /// Adds the generalised force to a sum.
    fn onto(self, sum: S::Scalar) -> S::Scalar;
}

/// How one coordinate moves the outboard side of a joint against the inboard one.
///
/// The library's own are `planar::Revolute`, `planar::Slider`, `spatial::Revolute` and `spatial::Prismatic` without springs. One of a
/// user's own says the same: its motion as any joint does ([`Joint`]), and the elimination of its coordinate.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no joint that can be driven, stick or strike stops",
    label = "not the bare motion of one coordinate",
    note = "`Driven`, `Coulomb` and `HardStops` take `Revolute` and `Slider` of the plane, `Revolute` and `Prismatic` of space, `Hinge` and `Slide` of robots, kinematics of one's own",
    note = "springs, dampers and laws go beside friction and stops, not into the joint inside: `Coulomb::new(..).with(..)`"
)]
pub trait Kinematics<S: Space>: Joint<S, Position = S::Scalar, Rate = S::Scalar> + Debug {
    /// Takes the point mass (kg) that its outboard neighbour lumps at the joint. Where the points of a joint coincide it hands it on.
    fn lump(&mut self, mass: S::Scalar) -> S::Scalar;
    /// The orientation of the outboard body.
    fn turned(&self, position: &S::Scalar, rate: &S::Scalar, inboard: S::Turn) -> S::Turn;
    /// The orientation of the outboard body; what the other walks read is stored.
    #[allow(clippy::too_many_arguments)] // one store each
    fn orient(
        &self,
        position: &S::Scalar,
        rate: &S::Scalar,
        inboard: S::Turn,
        x: &mut Self::Per<S::X>,
        y: &mut Self::Per<S::Y>,
        p: &mut Self::Per<S::P>,
        q: &mut Self::Per<S::Q>,
    ) -> S::Turn;
    /// Turns what [`orient`](Self::orient) stored into what the other walks read, where that is left to many joints at once.
    fn resolve(x: &mut Self::Per<S::X>, y: &mut Self::Per<S::Y>, p: &mut Self::Per<S::P>, q: &mut Self::Per<S::Q>);
    /// Lets the coordinate q go against a generalised force τ̂ − K̂ q̈ ON the outboard body, and keeps the gains by which
    /// [`recover`](crate::shape::Joint::recover) finds q̈ after an implicit sweep.
    fn eliminate<C: Closures>(
        &self,
        outer: Full<S, C>,
        posture: JointPosture<'_, S, Self>,
        force: S::Scalar,
        resistance: S::Scalar,
        kept: &mut Self::Kept<C>,
    ) -> Full<S, C>;
    /// Lets the coordinate accelerate as given, whatever acts: the relation of the inboard side, and gains by which
    /// [`recover`](crate::shape::Joint::recover) gives that q̈ after an implicit sweep.
    fn drive<C: Closures>(
        &self,
        outer: Full<S, C>,
        posture: JointPosture<'_, S, Self>,
        acceleration: S::Scalar,
        kept: &mut Self::Kept<C>,
    ) -> Full<S, C>;
    /// The motion of such a joint under a model.
    fn under(motion: S::JointMotion, model: Acting<S::Scalar>) -> S::JointMotion;
}

/// What a model does in a joint at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Acting<T> {
    /// Generalised force of the joint's law ON the outboard body, with slopes.
    pub resistance: Resistance<T>,
    /// Energy stored (J).
    pub energy: T,
    /// Reflected inertia (kg·m², kg).
    pub inertia: T,
}

/// A joint of a user's own: kinematics, and what acts along their coordinate. Only `kinematics` have to be said; see
/// [`extend`](crate::extend).
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no joint model in `{S}`",
    label = "not a joint of the chain's space",
    note = "`catena::joint!` makes an element of a type that implements `JointModel` for the chain's space"
)]
pub trait JointModel<S: Space>: Copy + Debug + 'static {
    /// How the joint's coordinate moves its outboard side.
    type Kinematics: Kinematics<S>;

    /// Whether the joint's force is affine in position and rate: then slopes are the same everywhere, and implicit rules need not read it
    /// twice.
    const LINEAR: bool = false;

    /// The kinematics of the joint.
    fn kinematics(&self) -> &Self::Kinematics;
    /// The kinematics of the joint, for the scene to note point masses in.
    fn kinematics_mut(&mut self) -> &mut Self::Kinematics;

    /// What acts along the coordinate. Explicit rules read its force; implicit ones take it linearly implicitly by its slopes, which
    /// should not be negative by much: a step must resolve what they drive apart.
    fn resistance(&self, position: S::Scalar, rate: S::Scalar) -> Resistance<S::Scalar> {
        let _ = (position, rate);
        Resistance::none()
    }
    /// Energy stored (J): the potential of the part of the force that has one.
    fn energy(&self, position: S::Scalar) -> S::Scalar {
        let _ = position;
        S::Scalar::zero()
    }
    /// Reflected inertia I (kg·m², kg): a part of the joint moves with the coordinate alone and has the kinetic energy ½ I q̇².
    fn reflected_inertia(&self) -> S::Scalar {
        S::Scalar::zero()
    }
    /// Rejects parameters that make no mechanics. Kinematics and reflected inertia are checked in any case.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

/// Where the coordinate of a joint is in a sweep, and where the last sweep has led.
pub type Sought<'a, T> = ((T, T), Reading<'a, T, T>);

/// Condenses the relation outboard of a joint with a model; what [`joint!`](crate::joint) calls.
#[cfg_attr(optimised, inline(always))]
pub fn condense<S: Space, J: JointModel<S>, W: Sweep<S>>(
    model: &J,
    outer: Full<S, W::Closures>,
    posture: JointPosture<'_, S, J::Kinematics>,
    load: impl Driving<S>,
    ((position, rate), led): Sought<'_, S::Scalar>,
    springs: W::Springs,
    kept: &mut <J::Kinematics as Joint<S>>::Kept<W::Closures>,
) -> Full<S, W::Closures> {
    // Laws that are not linear are read where the last sweep has led.
    let follows = const { !J::LINEAR && <W::Springs as Springs<S::Scalar>>::STIFF };
    let (position, rate) = if follows { (*led.position, *led.rate) } else { (position, rate) };
    let Resistance { force, stiffness, damping } = model.resistance(position, rate);
    let pivot = springs.pivot(stiffness, damping);
    let force = if follows { pivot.mul_add(*led.acceleration, force) } else { force };
    let resistance = pivot + model.reflected_inertia();
    model.kinematics().eliminate::<W::Closures>(outer, posture, load.onto(force), resistance, kept)
}

/// Recovers the acceleration of a joint with a model; what [`joint!`](crate::joint) calls.
#[cfg_attr(optimised, inline(always))]
pub fn recover<S: Space, J: JointModel<S>, C: Closures>(
    model: &J,
    inboard: AccelerationOf<S>,
    posture: JointPosture<'_, S, J::Kinematics>,
    kept: &mut <J::Kinematics as Joint<S>>::Kept<C>,
    multipliers: &C::Each<S::Scalar>,
    rate: &mut S::Scalar,
) -> AccelerationOf<S> {
    // Reflected inertia makes the gains of all sweeps those of relative coordinates, as springs make those of implicit ones.
    model.kinematics().recover::<C, Implicit<RealOf<S>>>(inboard, posture, kept, multipliers, rate)
}

/// The motion of a joint with a model; what [`joint!`](crate::joint) calls.
#[cfg_attr(optimised, inline(always))]
pub fn motion<S: Space, J: JointModel<S>>(
    model: &J,
    inboard: FrameOf<S>,
    [position, rate, acceleration]: [&S::Scalar; 3],
) -> (S::JointMotion, FrameOf<S>) {
    let (motion, outboard) = model.kinematics().motion(inboard, position, rate, acceleration);
    let acting = Acting {
        resistance: model.resistance(*position, *rate),
        energy: model.energy(*position),
        inertia: model.reflected_inertia(),
    };
    (J::Kinematics::under(motion, acting), outboard)
}

/// What a joint with a model lets move; what [`joint!`](crate::joint) calls.
#[cfg_attr(optimised, inline(always))]
pub fn release<S: Space, J: JointModel<S>>(
    model: &J,
    motion: &S::JointMotion,
    position: &S::Scalar,
    rate: &S::Scalar,
) -> Release<S> {
    let mut release = model.kinematics().release(motion, position, rate);
    if let Some(coordinate) = &mut release.coordinates[0] {
        let preload = model.resistance(S::Scalar::zero(), S::Scalar::zero()).force;
        let inertia = model.reflected_inertia();
        let resisted = coordinate.against(model.resistance(*position, *rate), preload);
        *coordinate = Freedom { inertia, linear: J::LINEAR, ..resisted };
    }
    release
}

/// Checks a joint with a model; what [`joint!`](crate::joint) calls.
///
/// # Errors
/// What is wrong with its parameters.
pub fn check<S: Space, J: JointModel<S>>(model: &J) -> Result<(), Fault> {
    model.kinematics().check()?;
    not_negative("reflected inertia", model.reflected_inertia())?;
    model.check()
}
