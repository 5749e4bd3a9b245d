//! What acts on planar scenes besides gravity.

use super::load_laws::{BodyLaw, InJoints, JointLaw, OnBodies, Values};
use super::{BodyMotion, Frame, JointMotion, Planar, Station};
use crate::element::{Load, Loading};
use crate::error::Fault;
use crate::relation::plane::algebra::cross;
use crate::relation::{self, Absent, Term};
use crate::scalar::Scalar;
use crate::struts::Points;
use nalgebra::Vector2;

/// A force and a torque on a body, about its inboard end, in inertial axes.
pub type Wrench<T> = relation::Wrench<Vector2<T>, T>;

impl<T: Scalar> Wrench<T> {
    /// A pure torque (N·m).
    pub fn torque(torque: T) -> Self {
        Self { torque, ..Self::default() }
    }
}

impl<T: Scalar> BodyMotion<T> {
    /// The wrench of a force (N, inertial axes) at a point of this body (m, body axes from the inboard end).
    pub fn force_at(&self, point: [T; 2], force: [T; 2]) -> Wrench<T> {
        let force = Vector2::new(force[0], force[1]);
        Wrench { force, torque: cross(self.turned(point), force) }
    }
}

impl<T: Scalar> Load<Planar<T>> for Wrench<T> {
    fn act(self, station: &mut Station<T>) {
        station.inertia_force -= self.force;
        station.inertia_torque -= self.torque;
    }
}

impl<T: Scalar> Points<2> for Planar<T> {
    type Wrench = Wrench<T>;

    fn point(body: &BodyMotion<T>, at: [T; 2]) -> [Vector2<T>; 2] {
        let Frame { place, velocity, .. } = body.point(at);
        [place, velocity]
    }
    fn pull(body: &BodyMotion<T>, at: [T; 2], force: Vector2<T>) -> Wrench<T> {
        body.force_at(at, force.into())
    }
}

/// Loads on a scene, as functions of time and motion or of values handed in: what is not there is [`Absent`], and free.
///
/// Bodies and joints are numbered from 0 at the root; joint 0 is the root's. The motion that a load sees has no
/// accelerations yet (they read zero): these are what the sweep is about to find.
///
/// ```
/// use catena::planar::*;
/// # let rod = Rod::uniform(1.0, 1.0);
/// # let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
/// let torques = [0.3, -0.1];
/// let loads = Loads::none()
///     .in_joints(|_time, joint, motion: &JointMotion<f64>| torques[joint] - 0.05 * motion.rate())
///     .on_bodies(|time: f64, _body, motion: &BodyMotion<f64>| motion.force_at([1.0, 0.0], [time.sin(), 0.0]));
/// let start = pendulum.at_rest(&[0.0, 0.0])?;
/// let start = pendulum.with_accelerations(start, &loads)?;
/// # Ok::<(), catena::Error>(())
/// ```
///
/// # In a struct
///
/// A closure has a type without a name, and each another one. Values handed in have a name, [`InJoints`] with a function pointer has
/// one, and so has a [`JointLaw`] of the user's own:
///
/// ```
/// use catena::planar::*;
/// use catena::stepper::{MotionIn, StepperOf};
///
/// type Arm = System<f64, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free>;
///
/// /// Holds the arm at two angles (rad), by torques that are at most 50 N·m.
/// #[derive(Clone, Copy, Debug)]
/// struct Hold {
///     angles: [f64; 2],
/// }
///
/// impl JointLaw<f64> for Hold {
///     type Value = f64;
///     fn at(&self, _time: f64, joint: usize, motion: &JointMotion<f64>) -> f64 {
///         let wanted = -80.0 * (motion.outboard.turn.angle - self.angles[joint]) - 8.0 * motion.rate();
///         wanted.clamp(-50.0, 50.0)
///     }
/// }
///
/// /// The arm inside a controller that runs at 1 kHz.
/// struct Controller {
///     stepper: StepperOf<Rk4, Arm, Loads<Absent, Hold>>,
///     now: MotionIn<Arm, Loads<Absent, Hold>>,
///     next: MotionIn<Arm, Loads<Absent, Hold>>,
/// }
///
/// impl Controller {
///     fn new(arm: Arm) -> Result<Self, catena::Error> {
///         let now = arm.at_rest(&[0.0, 0.0])?;
///         Ok(Self { stepper: arm.into_stepper(Rk4), now, next: now })
///     }
///     fn cycle(&mut self, angles: [f64; 2]) -> Result<(), catena::Error> {
///         let loads = Loads::none().in_joints_by(Hold { angles });
///         self.stepper.step(&self.now, &loads, 1e-3, &mut self.next)?;
///         core::mem::swap(&mut self.now, &mut self.next);
///         Ok(())
///     }
/// }
///
/// let rod = Rod::uniform(0.5, 1.0);
/// let mut controller = Controller::new(System::new(Pinned::origin(), (rod, Pin, rod), Free)?)?;
/// for _ in 0..2000 {
///     controller.cycle([0.4, 0.9])?;
/// }
/// let (shoulder, ((), elbow, ())) = *controller.now.position();
/// assert!((shoulder - 0.4).abs() < 0.01 && (elbow - 0.9).abs() < 0.01);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Loads<B = Absent, J = Absent> {
    bodies: B,
    joints: J,
}

impl Loads {
    /// No loads.
    pub const fn none() -> Self {
        Self { bodies: Absent, joints: Absent }
    }
}

impl<B, J> Loads<B, J> {
    /// Forces and torques on bodies: a function of time (s), body number and motion.
    pub fn on_bodies<T: Scalar, F: Fn(T::Real, usize, &BodyMotion<T>) -> Wrench<T>>(
        self,
        law: F,
    ) -> Loads<OnBodies<F>, J> {
        Loads { bodies: OnBodies(law), joints: self.joints }
    }

    /// Torques in joints (N·m), ON the outboard body, and forces along the lines of sliders (N): a function of time (s), joint number and
    /// motion.
    pub fn in_joints<T: Scalar, F: Fn(T::Real, usize, &JointMotion<T>) -> T>(self, law: F) -> Loads<B, InJoints<F>> {
        Loads { bodies: self.bodies, joints: InJoints(law) }
    }
}

impl<B, J> Loads<B, J> {
    /// Torques in joints (N·m; N in a slider) as values handed in, one for each joint from the root's on: as many as [`System::joints`](super::System::joints) says.
    ///
    /// Values see no motion, so no walk shows it to them: they cost a copy and two additions a joint, 1.05 of a sweep of rods on
    /// pins and 1.02 of one in space.
    pub fn torques<V>(self, torques: V) -> Loads<B, Values<V>> {
        Loads { bodies: self.bodies, joints: Values(torques) }
    }

    /// Wrenches on bodies as values handed in, one for each body from the root on: as many as [`System::bodies`](super::System::bodies) says.
    pub fn wrenches<V>(self, wrenches: V) -> Loads<Values<V>, J> {
        Loads { bodies: Values(wrenches), joints: self.joints }
    }
}

impl<B, J> Loads<B, J> {
    /// What a law of the user's own exerts on bodies: a type that has a name, see [`BodyLaw`].
    pub fn on_bodies_by<L>(self, law: L) -> Loads<L, J> {
        Loads { bodies: law, joints: self.joints }
    }

    /// What a law of the user's own exerts in joints: a type that has a name, see [`JointLaw`].
    pub fn in_joints_by<L>(self, law: L) -> Loads<B, L> {
        Loads { bodies: self.bodies, joints: law }
    }

    /// What acts on bodies.
    pub fn bodies(&self) -> &B {
        &self.bodies
    }

    /// What acts in joints.
    pub fn joints(&self) -> &J {
        &self.joints
    }
}

impl<T: Scalar, B: BodyLaw<T>, J: JointLaw<T>> Loading<Planar<T>> for Loads<B, J> {
    type OnBody = B::Value;
    type InJoint = J::Value;
    type Seen = ();
    const ON: bool = B::ON || J::ON;
    const READS: bool = B::READS || J::READS;

    fn unseen() {}
    fn nothing() -> (B::Value, J::Value) {
        (B::nothing(), J::Value::none())
    }
    #[inline(always)]
    fn on_body(&self, (): &(), time: T::Real, body: usize, motion: &BodyMotion<T>) -> B::Value {
        self.bodies.at(time, body, &BodyMotion { inboard: motion.inboard.without_acceleration(), ..*motion })
    }
    #[inline(always)]
    fn in_joint(&self, time: T::Real, joint: usize, motion: &JointMotion<T>) -> J::Value {
        let motion = JointMotion {
            inboard: motion.inboard.without_acceleration(),
            outboard: motion.outboard.without_acceleration(),
            ..*motion
        };
        self.joints.at(time, joint, &motion)
    }
    #[inline(always)]
    fn on_bodies_listed(&self) -> &[B::Value] {
        self.bodies.list()
    }
    #[inline(always)]
    fn in_joints_listed(&self) -> &[J::Value] {
        self.joints.list()
    }
    fn check(&self, bodies: usize, joints: usize) -> Result<(), Fault> {
        self.bodies.check(bodies)?;
        self.joints.check(joints)
    }
}
