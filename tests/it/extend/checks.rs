//! `check_element` passes what is right, and names what is wrong.

use super::geared::Geared;
use super::tank::{Liquid, Tank};
use catena::extend::{Acting, Doubt, JointModel, Kinematics, Release, Resistance, check_element};
use catena::extend::{Implicit, Springs};
use catena::internals::relation::Closures;
use catena::internals::relation::planar::{Full, RelativeGain};
use catena::internals::shape::{self, JointPosture};
use catena::nalgebra::Vector3;
use catena::planar::{
    Acceleration, Frame, Free, Ground, GroundMotion, JointMotion, Pin, Pinned, Planar, RigidBody, Rod, System, Turn,
};
use catena::{Fault, Scalar, planar, spatial};

/// What a joint may do wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Wrong {
    Nothing,
    /// An energy that is not that of the force.
    Energy,
    /// Slopes that are not the force's.
    Stiffness,
    Damping,
    /// An energy that is no number.
    NoEnergy,
    /// A stiffness that is read without its derivatives.
    Lost,
}

/// A hinge with a spring that stiffens, k (φ + φ³), and a damper.
#[derive(Clone, Copy, Debug)]
struct Stiffening<T, K> {
    kinematics: K,
    stiffness: T,
    damping: T,
    inertia: T,
    wrong: Wrong,
}

catena::joint!([T: Scalar, K: Copy + core::fmt::Debug + 'static] Stiffening<T, K>);

impl<T: Scalar, U: Scalar, K: catena::Lift<T, U>> catena::Lift<T, U> for Stiffening<T, K> {
    type Over = Stiffening<U, K::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Stiffening {
            kinematics: self.kinematics.lift(number),
            stiffness: number(self.stiffness),
            damping: number(self.damping),
            inertia: number(self.inertia),
            wrong: self.wrong,
        }
    }
}

impl<S: catena::system::Space, K: Kinematics<S>> JointModel<S> for Stiffening<S::Scalar, K> {
    type Kinematics = K;
    fn kinematics(&self) -> &K {
        &self.kinematics
    }
    fn kinematics_mut(&mut self) -> &mut K {
        &mut self.kinematics
    }
    fn resistance(&self, position: S::Scalar, rate: S::Scalar) -> Resistance<S::Scalar> {
        let (square, of) = (position * position, |x: f64| S::Scalar::literal(x));
        let lost = S::Scalar::constant(self.stiffness.real());
        let stiffness = if self.wrong == Wrong::Lost { lost } else { self.stiffness };
        let force = -(stiffness * position * (of(1.0) + square) + self.damping * rate);
        let cubic = of(if self.wrong == Wrong::Stiffness { 1.0 } else { 3.0 });
        let damping = if self.wrong == Wrong::Damping { -self.damping } else { self.damping };
        Resistance { force, stiffness: stiffness * (of(1.0) + cubic * square), damping }
    }
    fn energy(&self, position: S::Scalar) -> S::Scalar {
        let (square, of) = (position * position, |x: f64| S::Scalar::literal(x));
        if self.wrong == Wrong::NoEnergy {
            return of(f64::NAN);
        }
        let fourth = of(if self.wrong == Wrong::Energy { 0.5 } else { 0.25 });
        self.stiffness * square * (of(0.5) + fourth * square)
    }
    fn reflected_inertia(&self) -> S::Scalar {
        self.inertia
    }
}

/// A pin whose gains are those of an elimination with a pivot that is off by a share.
#[derive(Clone, Copy, Debug)]
struct Mismatched<T> {
    pin: planar::Revolute,
    off: T,
}
catena::lift!(Mismatched<T> { pin, off });

impl<T: Scalar> shape::Joint<Planar<T>> for Mismatched<T> {
    type Position = T;
    type Rate = T;
    type Kept<C: Closures> = RelativeGain<T, C>;
    type Per<X: Copy> = ();
    const LINEAR: bool = true;

    fn still() -> (T, T) {
        (T::zero(), T::zero())
    }
    fn kept<C: Closures>() -> RelativeGain<T, C> {
        RelativeGain::blank()
    }
    fn per<X: Copy>(_: X) {}
    fn is_finite<C: Closures>(kept: &RelativeGain<T, C>) -> bool {
        kept.is_finite()
    }
    fn configure(&self, position: &mut T, inboard: Turn<T>, next: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
        shape::Joint::configure(&self.pin, position, inboard, next)
    }
    fn recover<C: Closures, By: Springs<T>>(
        &self,
        inboard: Acceleration<T>,
        posture: JointPosture<'_, Planar<T>, Self>,
        kept: &mut RelativeGain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut T,
    ) -> Acceleration<T> {
        shape::Joint::recover::<C, By>(&self.pin, inboard, posture, kept, multipliers, rate)
    }
    fn respond<C: Closures>(
        &self,
        inboard: Acceleration<T>,
        posture: JointPosture<'_, Planar<T>, Self>,
        kept: &RelativeGain<T, C>,
        multipliers: &C::Each<T>,
        rate: &mut T,
    ) -> Acceleration<T> {
        shape::Joint::respond::<C>(&self.pin, inboard, posture, kept, multipliers, rate)
    }
    fn motion(&self, inboard: Frame<T>, position: &T, rate: &T, acceleration: &T) -> (JointMotion<T>, Frame<T>) {
        shape::Joint::motion(&self.pin, inboard, position, rate, acceleration)
    }
    fn release(&self, motion: &JointMotion<T>, position: &T, rate: &T) -> Release<Planar<T>> {
        shape::Joint::release(&self.pin, motion, position, rate)
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

impl<T: Scalar> Kinematics<Planar<T>> for Mismatched<T> {
    fn lump(&mut self, mass: T) -> T {
        mass
    }
    fn turned(&self, position: &T, rate: &T, inboard: Turn<T>) -> Turn<T> {
        Kinematics::turned(&self.pin, position, rate, inboard)
    }
    fn orient(
        &self,
        position: &T,
        rate: &T,
        inboard: Turn<T>,
        (): &mut (),
        (): &mut (),
        (): &mut (),
        (): &mut (),
    ) -> Turn<T> {
        Kinematics::turned(&self.pin, position, rate, inboard)
    }
    fn resolve((): &mut (), (): &mut (), (): &mut (), (): &mut ()) {}
    fn eliminate<C: Closures>(
        &self,
        outer: Full<T, C>,
        posture: JointPosture<'_, Planar<T>, Self>,
        force: T,
        resistance: T,
        kept: &mut RelativeGain<T, C>,
    ) -> Full<T, C> {
        let relation = self.pin.eliminate::<C>(outer, posture, force, resistance, kept);
        let one_more = self.off + T::literal(1.0);
        kept.free *= one_more;
        relation
    }
    fn drive<C: Closures>(
        &self,
        outer: Full<T, C>,
        posture: JointPosture<'_, Planar<T>, Self>,
        acceleration: T,
        kept: &mut RelativeGain<T, C>,
    ) -> Full<T, C> {
        self.pin.drive::<C>(outer, posture, acceleration, kept)
    }
    fn under(motion: JointMotion<T>, model: Acting<T>) -> JointMotion<T> {
        <planar::Revolute as Kinematics<Planar<T>>>::under(motion, model)
    }
}

/// A scene in the plane with a joint between two plates.
macro_rules! in_plane {
    ($joint:expr) => {{
        let (rod, plate) = (Rod::uniform(0.7_f64, 1.0), RigidBody::new(0.9, 0.05, [0.3, 0.1], [0.7, -0.2]));
        System::new(Pinned::origin(), (plate, $joint, plate, Pin, rod), Free).map(|scene| scene.with_gravity(9.81))
    }};
}
macro_rules! in_space {
    ($joint:expr) => {{
        let tensor = [[0.3, 0.02, -0.01], [0.02, 0.25, 0.03], [-0.01, 0.03, 0.4]];
        let body = spatial::RigidBody::new(1.5_f64, tensor, [0.2, 0.1, -0.1], [0.4, 0.1, 0.05]);
        spatial::System::new(spatial::Pinned::origin(), (body, $joint, body, spatial::Ball, body), spatial::Free)
            .map(|scene| scene.with_gravity([1.0, 2.0, -9.81]))
    }};
}

fn stiffening<K>(kinematics: K, wrong: Wrong) -> Stiffening<f64, K> {
    Stiffening { kinematics, stiffness: 30.0, damping: 0.4, inertia: 0.2, wrong }
}

#[test]
fn what_is_right_passes() -> Result<(), Box<dyn std::error::Error>> {
    let hinge = planar::Revolute::smooth();
    check_element(&in_plane!(Geared { kinematics: hinge, rotor: 1e-4, ratio: 50.0, friction: 0.2 })?, 20)?;
    check_element(&in_plane!(stiffening(planar::Slider::along(0.4), Wrong::Nothing))?, 20)?;
    let spring = planar::Spring::new(70.0).damped(0.5);
    let liquid = Liquid { mass: 1.7, place: [0.5, 0.2], direction: 0.3, spring };
    let scene = in_plane!((Pin, Tank::new((3.0, 0.4, [0.4, 0.05]), liquid, [0.9, -0.1])))?;
    check_element(&scene, 20)?;
    let axis = [0.3, 0.5, -0.2];
    check_element(&in_space!(stiffening(spatial::Revolute::about(axis), Wrong::Nothing))?, 20)?;
    let slide = Geared { kinematics: spatial::Prismatic::along(axis), rotor: 1e-4, ratio: 50.0, friction: 0.2 };
    check_element(&in_space!(slide)?, 20)?;
    check_element(
        &in_space!(spatial::Cylindrical::on(axis).with(spatial::Spring::stiffness(20.0), spatial::Spring::none()))?,
        20,
    )?;
    Ok(())
}

/// A table that shakes along x.
#[derive(Clone, Copy, Debug)]
struct Shaker<T> {
    amplitude: T,
}

catena::lift!(Shaker<T> { amplitude });

impl<T: Scalar> Ground<T, GroundMotion<T>> for Shaker<T> {
    fn at(&self, time: T::Real) -> GroundMotion<T> {
        let (s, c) = (T::constant(time) * T::literal(20.0)).sin_cos();
        let place = |x: T, scale: f64| [self.amplitude * x * T::literal(scale), T::zero()];
        GroundMotion { place: place(s, 1.0), velocity: place(c, 20.0), acceleration: place(s, -400.0) }
    }
}

#[test]
fn ground_and_drives_that_move_have_a_power_of_their_own() -> Result<(), Box<dyn std::error::Error>> {
    let joint = Geared { kinematics: planar::Revolute::smooth(), rotor: 1e-4, ratio: 50.0, friction: 0.2 };
    let rod = Rod::uniform(0.7_f64, 1.0);
    let root = Pinned::on(Shaker { amplitude: 0.02 });
    check_element(&System::new(root, (rod, joint, rod), Free)?.with_gravity(9.81), 20)?;
    // Other errors are still found.
    let wrong = Stiffening {
        kinematics: planar::Revolute::smooth(),
        stiffness: 30.0,
        damping: 0.4,
        inertia: 0.2,
        wrong: Wrong::Stiffness,
    };
    let scene = System::new(root, (rod, wrong, rod), Free)?.with_gravity(9.81);
    assert!(words(check_element(&scene, 10)).contains("stiffness of a law"));
    Ok(())
}

/// What a check says of a scene.
fn words(found: Result<(), Doubt>) -> &'static str {
    match found {
        Err(Doubt::Disagreement(disagreement)) => {
            println!("{disagreement}");
            disagreement.what
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_is_wrong_is_named() -> Result<(), catena::Error> {
    let hinge = planar::Revolute::smooth();
    let mismatched = |off: f64| stiffening(Mismatched { pin: hinge, off }, Wrong::Nothing);
    assert_eq!(check_element(&in_plane!(mismatched(0.0))?, 10), Ok(()));
    assert!(words(check_element(&in_plane!(mismatched(1e-6))?, 10)).contains("a gain that does not match"));
    for (wrong, word) in [
        (Wrong::Energy, "energy that does not match force"),
        (Wrong::Stiffness, "stiffness of a law against"),
        (Wrong::Damping, "damping of a law against"),
        (Wrong::NoEnergy, "it is no number"),
        (Wrong::Lost, "a number whose derivatives are lost"),
    ] {
        let said = words(check_element(&in_plane!(stiffening(hinge, wrong))?, 10));
        assert!(said.contains(word), "{wrong:?}: {said}");
        let about = spatial::Revolute::about([0.3, 0.5, -0.2]);
        let said = words(check_element(&in_space!(stiffening(about, wrong))?, 10));
        assert!(said.contains(word), "{wrong:?}: {said}");
    }
    Ok(())
}

#[test]
fn what_cannot_be_checked_is_refused() -> Result<(), catena::Error> {
    let fault = |found: Result<(), Doubt>| match found {
        Err(Doubt::Failure(error)) => error.fault,
        other => panic!("{other:?}"),
    };
    let rod = Rod::uniform(0.7_f64, 1.0);
    let held = System::new(Pinned::origin(), (rod, Pin, rod), Pinned::at(1.0, 0.0))?;
    assert!(matches!(fault(check_element(&held, 3)), Fault::Unsupported { .. }));
    let arm = (RigidBody::massless([1.0, 0.0]), Pin, rod);
    let looped = System::new(Pinned::origin(), planar::Network::new((rod, Pin, rod), arm, Pin), Free)?;
    assert!(matches!(fault(check_element(&looped, 3)), Fault::Unsupported { .. }));
    let chain = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
    assert!(matches!(fault(check_element(&chain, 0)), Fault::NotPositive { .. }));
    assert_eq!(check_element(&chain, 3), Ok(()));
    Ok(())
}

/// A spring that stiffens with the turn of a joint of three, −k (1 + φ²) φ, whose pivot may forget by what springs move.
#[derive(Clone, Copy, Debug)]
struct Turning<T> {
    stiffness: T,
    forgets: bool,
}

impl<T: Scalar, U: Scalar> catena::Lift<T, U> for Turning<T> {
    type Over = Turning<U>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Turning<U> {
        Turning { stiffness: number(self.stiffness), forgets: self.forgets }
    }
}

impl<T: Scalar> Turning<T> {
    /// k (1 + φ²), and φ.
    fn stiffened(&self, position: &spatial::Rotation<T>) -> (T, Vector3<T>) {
        let phi = Vector3::from(position.log());
        (self.stiffness * (T::one() + phi.x * phi.x + phi.y * phi.y + phi.z * phi.z), phi)
    }
}

impl<T: Scalar> spatial::RotaryLaw<T> for Turning<T> {
    fn torque(&self, position: &spatial::Rotation<T>, _: &[T; 3]) -> Vector3<T> {
        let (stiffened, phi) = self.stiffened(position);
        phi * -stiffened
    }
    fn pivot(&self, position: &spatial::Rotation<T>, _: &[T; 3], springs: Implicit<T::Real>) -> spatial::Symmetric3<T> {
        let (stiffened, _) = self.stiffened(position);
        let pivot = if self.forgets { stiffened } else { stiffened.scale(springs.position) };
        spatial::Symmetric3::of_diagonal(Vector3::repeat(pivot))
    }
    fn energy(&self, position: &spatial::Rotation<T>) -> T {
        let (stiffened, phi) = self.stiffened(position);
        let square = phi.x * phi.x + phi.y * phi.y + phi.z * phi.z;
        (stiffened + self.stiffness) * square * T::literal(0.25)
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

#[test]
fn a_rotary_pivot_that_forgets_by_what_springs_move_is_named() -> Result<(), catena::Error> {
    let scene = |forgets| in_space!(spatial::ElasticHinge::with(Turning { stiffness: 8.0, forgets }));
    assert_eq!(check_element(&scene(false)?, 10), Ok(()));
    assert!(words(check_element(&scene(true)?, 10)).contains("does not grow with `springs`"));
    Ok(())
}
