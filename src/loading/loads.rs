//! Loads on a scene: what acts on bodies and what acts in joints.

use super::laws::{InJoints, OnBodies, OverTime, Values};
use super::{Load, LoadLaw, Loading, Seen};
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::{Absent, Additive};
use crate::space::{RealOf, Space};

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
/// In space:
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
///
/// What acts on bodies is said once, and so is what acts in joints: a second law would take the place of the first, and does not compile. One
/// that adds up both does.
///
/// ```compile_fail,E0599
/// use catena::planar::*;
/// let loads = Loads::none().torques([5.0, 0.0]).in_joints(|_, _, motion: &JointMotion<f64>| -0.1 * motion.rate());
/// ```
///
/// # In a struct
///
/// A closure has a type without a name, and each another one. Values handed in have a name, [`InJoints`] with a function pointer has
/// one, and so has a [`LoadLaw`] of the user's own:
///
/// ```
/// use catena::planar::*;
/// use catena::simulate::{MotionIn, StepperOf};
///
/// type Arm = System<f64, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free>;
///
/// /// Holds the arm at two angles (rad), by torques that are at most 50 N·m.
/// #[derive(Clone, Copy, Debug)]
/// struct Hold {
///     angles: [f64; 2],
/// }
///
/// impl LoadLaw<JointMotion<f64>> for Hold {
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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Loads<B = Absent, J = Absent> {
    bodies: B,
    joints: J,
}

lift!(Loads<B, J> { bodies, joints });

impl Loads {
    /// No loads.
    pub const fn none() -> Self {
        Self { bodies: Absent, joints: Absent }
    }
}

/// On bodies, of whom nothing has been said yet.
impl<J> Loads<Absent, J> {
    /// Forces and torques on bodies: a function of time (s), body number and motion.
    pub fn on_bodies<M, F>(self, law: F) -> Loads<OnBodies<F>, J>
    where
        M: Seen<Space: Space<BodyMotion = M>>,
        F: Fn(RealOf<M::Space>, usize, &M) -> M::Load,
    {
        self.on_bodies_by(OnBodies::new(law))
    }

    /// Forces and torques on bodies as a function of motion and time, which [`Taylor`](crate::time::Taylor) knows: by a law that is
    /// analytic and written for any number.
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::scalar::{Elementary, Scalar};
    ///
    /// /// Air that resists the middle of each body by c v |v| (N), and gusts along x.
    /// #[derive(Clone, Copy)]
    /// struct Wind<T> {
    ///     resistance: T,
    ///     gust: T,
    /// }
    /// catena::lift!(Wind<T> { resistance, gust });
    ///
    /// impl<T: Scalar> LoadLaw<BodyMotion<T>> for Wind<T> {
    ///     type Value = Wrench<T>;
    ///     fn at(&self, time: T::Real, body: usize, motion: &BodyMotion<T>) -> Wrench<T> {
    ///         self.over_time(T::constant(time), body, motion)
    ///     }
    ///     fn over_time(&self, time: T, _: usize, motion: &BodyMotion<T>) -> Wrench<T> {
    ///         let middle = motion.inertia.centre;
    ///         let velocity = motion.point(middle).velocity;
    ///         let (x, y) = (velocity.x - self.gust * time.sin_cos().0, velocity.y);
    ///         let drag = -self.resistance * (x * x + y * y + T::literal(1e-6)).sqrt();
    ///         motion.force_at(middle, [drag * x, drag * y])
    ///     }
    /// }
    ///
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let loads = Loads::none().on_bodies_over_time(Wind { resistance: 0.4, gust: 2.0 });
    /// let start = pendulum.at_rest(&[-1.0, -0.5])?;
    /// let series = pendulum.simulation(Taylor::<20>::tolerance(1e-11)).loads(&loads).run(start, 1.0, |_| ())?;
    /// let other = pendulum.simulation(Dop853::tolerance(1e-11)).loads(&loads).run(start, 1.0, |_| ())?;
    /// assert!((series.motion.position().0 - other.motion.position().0).abs() < 1e-9);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// Each product in such a law is one of series, of k products of numbers for coefficient k and all before it: unless the law is short,
    /// [`Dop853`](crate::time::Dop853) is many times as fast, and so [`AutoTaylor`](crate::time::AutoTaylor) leaves such loads to it. Loads that
    /// are [values](Self::wrenches) cost a series nothing. A law with cases (`if`, [`abs`](crate::scalar::Scalar::abs) of what passes zero)
    /// has no series where they change.
    pub fn on_bodies_over_time<L>(self, law: L) -> Loads<OverTime<L>, J> {
        self.on_bodies_by(OverTime(law))
    }

    /// Wrenches on bodies as values handed in, one for each body from the root on: as many as
    /// [`System::bodies`](crate::system::System::bodies) says.
    pub fn wrenches<V>(self, wrenches: V) -> Loads<Values<V>, J> {
        self.on_bodies_by(Values(wrenches))
    }

    /// What a law of the user's own exerts on bodies: a type that has a name, see [`LoadLaw`].
    pub fn on_bodies_by<L>(self, law: L) -> Loads<L, J> {
        Loads { bodies: law, joints: self.joints }
    }
}

/// In joints, of which nothing has been said yet.
impl<B> Loads<B> {
    /// Efforts in joints, ON the outboard body: a function of time (s), joint number and motion. In the plane torques (N·m), and forces
    /// along the lines of sliders (N).
    ///
    /// Joint 0 is that of the root, and acts from the ground. Of a root that is `Free` it is a torque from outside on the first body in the
    /// plane, and does nothing in space: there take [`on_bodies`](Self::on_bodies).
    pub fn in_joints<M, F>(self, law: F) -> Loads<B, InJoints<F>>
    where
        M: Seen<Space: Space<JointMotion = M>>,
        F: Fn(RealOf<M::Space>, usize, &M) -> M::Load,
    {
        self.in_joints_by(InJoints::new(law))
    }

    /// Efforts in joints as a function of time written for any number, in the plane and in space, which [`Taylor`](crate::time::Taylor) knows: see
    /// [`TimeLaw`](super::TimeLaw).
    pub fn in_joints_over_time<F>(self, law: F) -> Loads<B, OverTime<F>> {
        self.in_joints_by(OverTime(law))
    }

    /// Efforts in joints as values handed in, one for each joint from the root's on: as many as
    /// [`System::joints`](crate::system::System::joints) says.
    ///
    /// Values see no motion, so no walk shows it to them: they cost a copy and two additions a joint, 1.05 of a sweep of rods on
    /// pins and 1.02 of one in space.
    pub fn efforts<V>(self, efforts: V) -> Loads<B, Values<V>> {
        self.in_joints_by(Values(efforts))
    }

    /// Efforts in joints of the plane, where they are torques (N·m; N in a slider), as [values](Self::efforts).
    pub fn torques<V>(self, torques: V) -> Loads<B, Values<V>> {
        self.efforts(torques)
    }

    /// What a law of the user's own exerts in joints: a type that has a name, see [`LoadLaw`].
    pub fn in_joints_by<L>(self, law: L) -> Loads<B, L> {
        Loads { bodies: self.bodies, joints: law }
    }
}

impl<B, J> Loads<B, J> {
    /// What acts on bodies.
    pub fn bodies(&self) -> &B {
        &self.bodies
    }

    /// What acts in joints.
    pub fn joints(&self) -> &J {
        &self.joints
    }
}

impl<S: Space, B: LoadLaw<S::BodyMotion, Value: Load<S>>, J: LoadLaw<S::JointMotion>> Loading<S> for Loads<B, J> {
    type OnBody = B::Value;
    type InJoint = J::Value;
    type Seen = ();
    type Responses<V: Clone> = ();
    const ON: bool = B::ON || J::ON;
    const READS: bool = B::READS || J::READS;

    fn unseen(&self) {}
    fn nothing() -> (B::Value, J::Value) {
        (B::Value::null(), J::Value::null())
    }
    #[inline(always)]
    fn on_body(&self, (): &(), time: RealOf<S>, body: usize, motion: &S::BodyMotion) -> B::Value {
        self.bodies.at(time, body, &motion.unaccelerated())
    }
    #[inline(always)]
    fn in_joint(&self, time: RealOf<S>, joint: usize, motion: &S::JointMotion) -> J::Value {
        self.joints.at(time, joint, &motion.unaccelerated())
    }
    #[inline(always)]
    fn listed(&self) -> (&[B::Value], &[J::Value]) {
        (self.bodies.list(), self.joints.list())
    }
    fn check(&self, bodies: usize, joints: usize) -> Result<(), Fault> {
        let of = |list: &'static str| {
            move |fault| match fault {
                Fault::Count { expected, given, .. } => Fault::Count { list, expected, given },
                other => other,
            }
        };
        self.bodies.check(bodies).map_err(of("wrenches on bodies"))?;
        self.joints.check(joints).map_err(of("efforts in joints"))
    }
}
