//! A scene: root, chain and tip, validated once, and its forward and inverse dynamics.

#[cfg(feature = "alloc")]
mod assembly;
mod corrections;
#[cfg(feature = "serde")]
mod data;
mod describe;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod differences;
mod doubts;
mod dynamics;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod fall;
mod fitting;
mod gravity;
mod hold;
#[cfg(feature = "alloc")]
mod inertial;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod inertial_forces;
mod inspect;
mod joined;
#[cfg(feature = "alloc")]
mod least_change;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod linear;
#[cfg(feature = "alloc")]
mod lists;
mod nearly_closed;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod principal;
mod projection;
mod readings;
mod reference;
mod series;
mod start;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod statics;
mod strut_readings;
mod sweeps;
mod torn;
mod turning;
mod under_loads;

#[cfg(feature = "alloc")]
pub use assembly::{Assembled, AssembledOf, Holding};
pub(crate) use corrections::{Corrections, MOST_CORRECTIONS};
pub use describe::Description;
#[cfg(feature = "std")]
pub(crate) use differences::{GRAVITY, Keeps, Way, differenced, stencil, step};
pub use dynamics::{Dynamics, Runs, StiffDynamics};
pub use gravity::Gravity;
#[cfg(feature = "alloc")]
pub use inertial::{Carried, Inertial};
#[cfg(feature = "std")]
pub(crate) use linear::Linear;
#[cfg(feature = "std")]
pub(crate) use lists::{numbers, set, unit};
pub use series::SeriesDynamics;
pub use turning::AngularVelocity;

// What bounds of functions over scenes are made of.
pub use crate::counts::Counted;
pub use crate::element::Element;
pub use crate::ends::{Root, Tip};
pub use crate::mirror::{Position, Rate, Retraction};
pub use crate::names::{BodyNumbers, JointNumbers, Label, Which};
pub use crate::space::{RealOf, Space};

use crate::element::{Coordinates, Loading, SpaceOver, Unloaded};
use crate::error::{Error, Fault, counted, ensure_finite};
use crate::lift::Lift;
use crate::motion::Motion;
use crate::relation::{Additive, Closures, Geometry};
use crate::scalar::{Real, Scalar};
use crate::shape::{Positions, Rates, Shape};
use crate::solve::riccati::Site;
use crate::space::FrameOf;
use crate::walks::check::check;
use crate::walks::configure::configure;
use crate::walks::fits::fits;
use crate::walks::loose::loose;
use num_traits::Zero;

/// A mechanical scene. It holds parameters only; its motion is a value of its own ([`Motion`]).
///
/// `planar::System` is this type in the plane.
#[derive(Clone, Debug)]
pub struct System<S: Space, R: Root<S>, C, P> {
    root: R,
    /// The root's joint and the chain: to a sweep the ground is outside, and the joint is an element.
    chain: (R::Joint, C),
    tip: P,
    gravity: S::Vector,
}

/// The elements of a scene.
pub type Elements<S, R, C> = (<R as Root<S>>::Joint, C);
/// The motion of a scene.
pub type MotionOf<S, R, C, P> = Motion<<S as Geometry>::Scalar, PositionOf<S, R, C>, <P as Tip<S>>::Closures>;
/// The accelerations of a scene.
pub type RateOf<S, R, C> = <Elements<S, R, C> as Element<S>>::Rate;
/// A part of a scene over another scalar.
type Over<X, S, U> = <X as Lift<<S as Geometry>::Scalar, U>>::Over;
/// The positions of a scene.
pub type PositionOf<S, R, C> = <Elements<S, R, C> as Element<S>>::Position;

/// The elements of a scene, point masses that meet in a station added up.
fn lumped<S: Space, J: Element<S>, C: Element<S>>(joint: J, chain: C) -> (J, C) {
    let mut elements = (joint, chain);
    elements.lump(S::Scalar::zero()); // what comes out at the ground does not move
    elements
}

/// The coordinates of a motion.
pub(crate) fn coordinates<S: Space, E: Element<S>, X: Closures>(
    motion: &Motion<S::Scalar, E::Position, X>,
) -> Coordinates<'_, S, E> {
    Coordinates { position: &motion.position, rate: &motion.rate, acceleration: &motion.acceleration }
}

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// A scene from its inboard end to its outboard end.
    ///
    /// # Errors
    /// A parameter that makes no mechanics (a negative or NaN mass, a zero length) with its station, or a chain that has no
    /// body.
    pub fn new(root: R, chain: C, tip: P) -> Result<Self, Error>
    where
        Self: Runs<Unloaded, S, R, C, P>,
    {
        root.check()?;
        check(&chain)?;
        tip.check()?;
        if chain.bodies() == 0 {
            return Err(Error::new(Fault::NoBodies));
        }
        Ok(Self { chain: lumped(root.joint(), chain), root, tip, gravity: Additive::null() })
    }

    /// This scene in a uniform field of gravity (m/s²).
    #[must_use]
    pub fn with_gravity_vector(self, gravity: S::Vector) -> Self {
        Self { gravity, ..self }
    }

    /// Gravity (m/s²).
    pub fn gravity(&self) -> S::Vector {
        self.gravity
    }

    /// The chain between the ends.
    pub fn chain(&self) -> &C {
        &self.chain.1
    }

    /// The outboard end.
    pub(crate) fn tip(&self) -> &P {
        &self.tip
    }

    /// All elements as a sweep sees them: the root's joint and the chain.
    pub(crate) fn elements(&self) -> &Elements<S, R, C> {
        &self.chain
    }

    /// The motion of the ground at the root.
    pub(crate) fn ground(&self, time: RealOf<S>) -> FrameOf<S> {
        self.root.ground(time)
    }

    /// The far end.
    #[cfg(feature = "alloc")]
    pub(crate) fn tip_end(&self) -> &P {
        &self.tip
    }

    /// Where a sweep at a time takes place.
    pub(crate) fn site<'l, L>(&'l self, time: RealOf<S>, loads: &'l L) -> Site<'l, S, R, P, L> {
        Site { root: &self.root, gravity: self.gravity, tip: &self.tip, loads, time, again: false }
    }

    /// Number of bodies.
    pub fn bodies(&self) -> usize {
        self.chain.bodies()
    }

    /// Number of joints, the root's included.
    pub fn joints(&self) -> usize {
        self.chain.joints()
    }

    /// A motion at time zero with all coordinates, rates and accelerations zero.
    pub fn motion(&self) -> MotionOf<S, R, C, P> {
        let (position, rate) = (self.chain.store::<Positions>(()), self.chain.store::<Rates>(()));
        let multipliers = P::Closures::each(|_| S::Scalar::zero());
        Motion { time: Zero::zero(), position, acceleration: rate.clone(), rate, multipliers }
    }

    /// A motion at rest with these absolute orientations: one number for each rotary coordinate, root to tip. In the plane
    /// it is the angle (rad) of the body outboard of each joint.
    ///
    /// Its accelerations are not yet known (zero): see [`with_accelerations`](Self::with_accelerations).
    ///
    /// # Errors
    /// [`Fault::Count`] when there are more or fewer numbers than rotary coordinates, [`Fault::NotFinite`].
    pub fn at_rest(&self, orientations: &[S::Scalar]) -> Result<MotionOf<S, R, C, P>, Error> {
        let mut motion = self.motion();
        let ground = self.root.ground(motion.time);
        let mut expected = 0;
        let mut next = |_| {
            expected += 1;
            orientations.get(expected - 1).copied().unwrap_or(S::Scalar::zero())
        };
        configure(&self.chain, &mut motion.position, ground.turn, &mut next);
        counted("orientations", expected, orientations.len())?;
        ensure_finite(orientations.iter().all(|x| x.is_finite()), "orientation")?;
        Ok(motion)
    }

    /// Rates of the joint coordinates, one number each, root to tip (for pins in the plane, the angular velocities of the
    /// bodies (rad/s)).
    ///
    /// # Errors
    /// [`Fault::Count`] when there are more or fewer numbers than coordinates, [`Fault::NotFinite`]; [`Fault::Shape`] for a motion of
    /// another scene.
    pub fn with_rates(
        &self,
        mut motion: MotionOf<S, R, C, P>,
        rates: &[S::Scalar],
    ) -> Result<MotionOf<S, R, C, P>, Error> {
        self.fits(&motion)?;
        let mut expected = 0;
        motion.rate_mut().replace(&mut |_| {
            expected += 1;
            rates.get(expected - 1).copied().unwrap_or(S::Scalar::zero())
        });
        counted("rates", expected, rates.len())?;
        ensure_finite(rates.iter().all(|x| x.is_finite()), "rate")?;
        Ok(motion)
    }
}

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// This scene over another scalar, `number` replacing each of its parameters.
    ///
    /// A parameter that is to have a derivative is better set when the scene is built.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let single = pendulum.lift(|x| x as f32);
    /// let start = single.at_rest(&[-1.0_f32, -0.5])?;
    /// # Ok::<(), catena::Error>(())
    /// ```
    #[allow(clippy::type_complexity)] // the types are those of the scene
    pub fn lift<U: Scalar>(
        &self,
        mut number: impl FnMut(S::Scalar) -> U,
    ) -> System<S::Over, Over<R, S, U>, Over<C, S, U>, Over<P, S, U>>
    where
        S: SpaceOver<U>,
        R: Lift<S::Scalar, U, Over: Root<S::Over>>,
        C: Lift<S::Scalar, U, Over: Element<S::Over>>,
        P: Lift<S::Scalar, U>,
    {
        let root = self.root.lift(&mut number);
        System {
            chain: lumped(root.joint(), self.chain.1.lift(&mut number)),
            root,
            tip: self.tip.lift(&mut number),
            gravity: S::lift_vector(self.gravity, &mut number),
        }
    }
}

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Forward dynamics: the same motion with the accelerations that its positions, rates and loads cause.
    ///
    /// # Errors
    /// [`Fault::SingularJoint`], [`Fault::NonFiniteLoad`] or [`Fault::NonFiniteMotion`], with time and station;
    /// [`Fault::RedundantClosures`] where a tip is held twice in the same way; [`Fault::Shape`] for a motion of another scene;
    /// [`Fault::Count`] for lists of loads of another length than the scene has bodies or joints; [`Fault::NotAssembled`] for a motion that
    /// is not as [`Couplings`](crate::planar::Couplings) have it.
    pub fn with_accelerations<L: Loading<S>>(
        &self,
        mut motion: MotionOf<S, R, C, P>,
        loads: &L,
    ) -> Result<MotionOf<S, R, C, P>, Error>
    where
        Self: Runs<L, S, R, C, P>,
    {
        let mut workspace = self.workspace();
        self.accelerate(&mut motion, loads, &mut workspace)?;
        self.suited(&motion, loads)?;
        Ok(motion)
    }

    /// [`with_accelerations`](Self::with_accelerations) in place, in a workspace of the caller's.
    ///
    /// # Errors
    /// As there.
    pub fn accelerate<L: Loading<S>>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        loads: &L,
        workspace: &mut <Self as Dynamics<L>>::Workspace,
    ) -> Result<(), Error>
    where
        Self: Runs<L, S, R, C, P>,
    {
        motion.set_time(motion.time);
        let Motion { time, position, rate, acceleration, multipliers } = motion;
        if !(fits(&self.chain, position, rate) && fits(&self.chain, position, acceleration)) {
            return Err(Error::new(Fault::Shape));
        }
        self.admits(loads)?;
        *multipliers = self.accelerations(*time, position, rate, loads, workspace, acceleration);
        self.independent(motion, workspace, 0.0, &mut |_, _| ())?;
        let mut finite = true;
        motion.acceleration.visit(&mut |x| finite &= x.is_finite());
        if !finite {
            return Err(self.diagnose(motion, loads, workspace));
        }
        if const { S::TURNS_ABOUT_LINES }
            && let Some(entry) =
                loose(&self.chain, self.ground(motion.time), coordinates(motion), P::Closures::COUNT == 0)
        {
            let error = Error::new(Fault::SingularJoint).at_station(entry).beyond_root();
            return Err(error.at_time(motion.time.as_f64()));
        }
        Ok(())
    }
}
