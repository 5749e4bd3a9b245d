//! What acts on spatial scenes besides gravity.

use super::load_laws::{BodyLaw, InJoints, JointLaw, OnBodies, Values};
use super::{BodyMotion, Frame, JointMotion, Spatial, Station};
use crate::element::{Load, Loading};
use crate::error::Fault;
use crate::relation::space::Couple;
use crate::relation::space::algebra::{Columns, cross};
use crate::relation::{self, Absent, Part, Term};
use crate::scalar::Scalar;
use crate::struts::Points;
use nalgebra::Vector3;

/// A force and a torque on a body, about its inboard end, in inertial axes.
pub type Wrench<T> = relation::Wrench<Vector3<T>, Vector3<T>>;

impl<T: Scalar> Wrench<T> {
    /// A pure torque (N·m), inertial axes.
    pub fn torque(torque: [T; 3]) -> Self {
        Self { torque: Vector3::from(torque), ..Self::default() }
    }
}

impl<T: Scalar> BodyMotion<T> {
    /// The wrench of a force (N, inertial axes) at a point of this body (m, body axes from the inboard end).
    pub fn force_at(&self, point: [T; 3], force: [T; 3]) -> Wrench<T> {
        let force = Vector3::from(force);
        Wrench { force, torque: cross(self.turned(point), force) }
    }
}

impl<T: Scalar> Load<Spatial<T>> for Wrench<T> {
    fn act(self, station: &mut Station<T>) {
        station.inertia_force -= self.force;
        station.inertia_torque -= self.torque;
    }
}

impl<T: Scalar> Points<3> for Spatial<T> {
    type Wrench = Wrench<T>;

    fn point(body: &BodyMotion<T>, at: [T; 3]) -> [Vector3<T>; 2] {
        let Frame { place, velocity, .. } = body.point(at);
        [place, velocity]
    }
    fn pull(body: &BodyMotion<T>, at: [T; 3], force: Vector3<T>) -> Wrench<T> {
        body.force_at(at, force.into())
    }
}

/// Generalised forces on the coordinates of a joint, in the order of its rates, ON the outboard body: torques (N·m) about axes,
/// forces (N) along them; in a ball a torque in axes of the outboard body. What exceeds the coordinates has no effect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort<T>(pub [T; 3]);

impl<T: Scalar> Default for Effort<T> {
    fn default() -> Self {
        Self([T::zero(); 3])
    }
}

impl<T: Scalar> Part for Effort<T> {
    fn is_finite(self) -> bool {
        self.0.iter().all(|x| x.is_finite())
    }
}

/// What is applied in a joint: an [`Effort`], or nothing.
pub trait Drive<T: Scalar>: Part {
    /// A torque in a ball, or nothing.
    type Couple: Term<Vector3<T>>;
    /// Nothing.
    fn none() -> Self;
    /// Adds the generalised force on coordinate `k` to a sum.
    fn onto(self, k: usize, sum: T) -> T;
    /// The torque (inertial axes) in a ball, for an outboard body of this attitude.
    fn couple(self, attitude: &Columns<T>) -> Self::Couple;
}

impl<T: Scalar> Drive<T> for Absent {
    type Couple = Absent;
    fn none() -> Self {
        Self
    }
    #[inline(always)]
    fn onto(self, _: usize, sum: T) -> T {
        sum
    }
    #[inline(always)]
    fn couple(self, _: &Columns<T>) -> Absent {
        Absent
    }
}

impl<T: Scalar> Drive<T> for Effort<T> {
    type Couple = Couple<T>;
    fn none() -> Self {
        Self::default()
    }
    #[inline(always)]
    fn onto(self, k: usize, sum: T) -> T {
        sum + self.0[k]
    }
    #[inline(always)]
    fn couple(self, attitude: &Columns<T>) -> Couple<T> {
        Couple(attitude.apply(Vector3::from(self.0)))
    }
}

/// Loads on a scene, as functions of time and motion or of values handed in: what is not there is [`Absent`], and free.
///
/// Bodies and joints are numbered from 0 at the root; joint 0 is the root's. The motion that a load sees has no
/// accelerations yet (they read zero): these are what the sweep is about to find.
///
/// ```
/// use catena::spatial::*;
/// # let rod = Rod::uniform(1.0, 0.1, 1.0);
/// # let pendulum = System::new(Pinned::origin(), (rod, Ball, rod), Free)?;
/// let loads = Loads::none()
///     .in_joints(|_time, _joint, motion: &JointMotion<f64>| Effort(motion.rate.map(|rate| -0.05 * rate)))
///     .on_bodies(|time: f64, _body, motion: &BodyMotion<f64>| motion.force_at([1.0, 0.0, 0.0], [time.sin(), 0.0, 0.0]));
/// let start = pendulum.with_accelerations(pendulum.motion(), &loads)?;
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

    /// Efforts in joints, ON the outboard body: a function of time (s), joint number and motion.
    pub fn in_joints<T: Scalar, F: Fn(T::Real, usize, &JointMotion<T>) -> Effort<T>>(
        self,
        law: F,
    ) -> Loads<B, InJoints<F>> {
        Loads { bodies: self.bodies, joints: InJoints(law) }
    }

    /// Efforts in joints as values handed in, one for each joint from the root's on: as many as [`System::joints`](super::System::joints) says.
    ///
    /// Values see no motion, so no walk shows it to them: they cost 0.02 of a sweep.
    pub fn efforts<V>(self, efforts: V) -> Loads<B, Values<V>> {
        Loads { bodies: self.bodies, joints: Values(efforts) }
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

impl<T: Scalar, B: BodyLaw<T>, J: JointLaw<T>> Loading<Spatial<T>> for Loads<B, J> {
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
