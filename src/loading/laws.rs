//! What loads are made of: values, functions, and laws of the user's own.

use super::count;
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::{Absent, Additive, Geometry, Part};
use crate::scalar::{Real, Scalar};
use crate::sealed::Sealed;
use crate::space::{MovingBody, RealOf, Space};

/// The motion of a body or joint at an instant, which tells the space that it belongs to and what can act there.
pub trait Seen: Sealed + Copy {
    /// The space.
    type Space: Space;
    /// What acts: on a body a wrench, in a joint an effort.
    type Load: Part + Additive;
    /// This motion with the accelerations left out.
    fn unaccelerated(&self) -> Self;
}

/// The law of a load that acts where motions `M` are seen: on bodies, whose motion is `BodyMotion<T>`, or in joints, whose motion is
/// `JointMotion<T>`. Implement it for a type that has a name: see [`Loads`](super::Loads).
pub trait LoadLaw<M: Seen> {
    /// What acts: [`Seen::Load`] or [`Absent`].
    type Value: Part + Additive;
    /// Whether there is a load.
    const ON: bool = true;
    /// Whether the load depends on time or motion, or is a [`list`](Self::list).
    const READS: bool = true;
    /// The load on the body or in the joint of a number.
    fn at(&self, time: RealOf<M::Space>, number: usize, motion: &M) -> Self::Value;
    /// The load at a time that is a number as those of the motion are: a power series, where a run by [`Taylor`](crate::time::Taylor) asks for one
    /// ([`Loads::on_bodies_over_time`](super::Loads::on_bodies_over_time)). A law that depends on time has to be written here, and [`at`](Self::at)
    /// by it; any other has nothing to add: it is asked at a time that is no number, so that one which does look at it makes a load that is none.
    fn over_time(&self, time: <M::Space as Geometry>::Scalar, number: usize, motion: &M) -> Self::Value {
        let _ = time;
        self.at(RealOf::<M::Space>::of(f64::NAN), number, motion)
    }
    /// Loads where they are a list.
    fn list(&self) -> &[Self::Value] {
        &[]
    }
    /// Refuses a list that is not as long as the scene has bodies or joints, and parameters that make no load. A law around another one
    /// hands this on: else nothing checks the one inside.
    ///
    /// # Errors
    /// [`Fault::Count`], [`Fault::NoSuchBody`] and what is wrong with parameters.
    fn check(&self, count: usize) -> Result<(), Fault> {
        let _ = count;
        Ok(())
    }
}

/// Loads given as values: an array, a slice, a vector.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Values<V>(pub V);

lift!(Values<V> { 0 });

/// A function of time, number and motion as the law of what acts on bodies or in joints.
///
/// ```
/// use catena::planar::*;
/// type Torque = fn(f64, usize, &JointMotion<f64>) -> f64;
/// fn brake(_: f64, _: usize, motion: &JointMotion<f64>) -> f64 {
///     -3.0 * motion.rate()
/// }
/// fn push(_: f64, joint: usize, _: &JointMotion<f64>) -> f64 {
///     if joint == 0 { 2.0 } else { 0.0 }
/// }
/// /// What may be chosen while a program runs: two laws, one type, one stepper.
/// fn loads(moving: bool) -> Loads<Absent, InJoints<Torque>> {
///     let law: Torque = if moving { brake } else { push };
///     Loads::none().in_joints(law)
/// }
///
/// let rod = Rod::uniform(0.5, 1.0);
/// let arm = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
/// let mut stepper = arm.stepper(Rk4);
/// let (mut now, mut next) = (arm.at_rest(&[0.0, 0.0])?, arm.motion());
/// for cycle in 0..100 {
///     stepper.step(&now, &loads(cycle % 2 == 1), 1e-3, &mut next)?;
///     core::mem::swap(&mut now, &mut next);
/// }
/// # Ok::<(), catena::Error>(())
/// ```
///
/// Named by a function pointer or a boxed function, it is one type for many laws, which one stepper can take in turn.
#[derive(Clone, Copy, Debug)]
pub struct Function<F>(pub(super) F);

/// A function as the law of what acts on bodies.
pub type OnBodies<F> = Function<F>;
/// A function as the law of what acts in joints.
pub type InJoints<F> = Function<F>;

impl<F> Function<F> {
    pub(super) const fn new(law: F) -> Self {
        Self(law)
    }
}

/// Efforts in joints as functions of time, written for any number: a run by [`Taylor`](crate::time::Taylor) series hands it power series.
///
/// ```
/// use catena::loading::TimeLaw;
/// use catena::planar::*;
/// use catena::scalar::Scalar;
///
/// /// Shakes the second joint (N·m).
/// struct Shake;
///
/// impl TimeLaw<f64> for Shake {
///     fn at<X: Scalar<Real = f64>>(&self, time: X, joint: usize) -> X {
///         if joint == 1 { X::literal(0.5) * (X::literal(7.0) * time).sin_cos().0 } else { X::zero() }
///     }
/// }
///
/// let rod = Rod::uniform(1.0, 1.0);
/// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
/// let (start, loads) = (pendulum.at_rest(&[-1.0, -0.5])?, Loads::none().in_joints_over_time(Shake));
/// let series = pendulum.simulation(Taylor::<20>::tolerance(1e-12)).loads(&loads).run(start, 1.0, |_| ())?;
/// let other = pendulum.simulation(Dop853::tolerance(1e-12)).loads(&loads).run(start, 1.0, |_| ())?;
/// assert!((series.motion.position().0 - other.motion.position().0).abs() < 1e-10);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// In space joints have up to three coordinates ([`in_space`](Self::in_space)).
///
/// ```
/// use catena::loading::TimeLaw;
/// use catena::scalar::Scalar;
/// use catena::spatial::*;
///
/// /// Wags a body on a ball about its second and third axes (N·m).
/// struct Wag;
///
/// impl TimeLaw<f64> for Wag {
///     fn at<X: Scalar<Real = f64>>(&self, _: X, _: usize) -> X {
///         X::zero()
///     }
///     fn in_space<X: Scalar<Real = f64>>(&self, time: X, _: usize) -> [X; 3] {
///         let (sine, cosine) = (X::literal(5.0) * time).sin_cos();
///         [X::zero(), sine, X::literal(0.5) * cosine]
///     }
/// }
///
/// let rod = Rod::uniform(1.0, 0.1, 1.0);
/// let pendulum = System::new(Pinned::origin(), (rod, Ball, rod), Free)?.with_gravity([0.0, 0.0, -9.81]);
/// let (start, loads) = (pendulum.at_rest(&[0.1; 6])?, Loads::none().in_joints_over_time(Wag));
/// let series = pendulum.simulation(Taylor::<20>::tolerance(1e-12)).loads(&loads).run(start, 0.5, |_| ())?;
/// let other = pendulum.simulation(Dop853::tolerance(1e-12)).loads(&loads).run(start, 0.5, |_| ())?;
/// let miss = series.motion.rates().into_iter().zip(other.motion.rates()).map(|(a, b): (f64, f64)| (a - b).abs());
/// assert!(miss.fold(0.0, f64::max) < 1e-9);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// A law that jumps or bends is one law up to there and another beyond: end runs there.
pub trait TimeLaw<R: Real> {
    /// The effort on the outboard body (N·m; N in a slider) in the joint of a number, 0 at the root, at a time (s).
    fn at<X: Scalar<Real = R>>(&self, time: X, joint: usize) -> X;

    /// The efforts in a joint of space, along each of its coordinates: of a ball a torque (N·m) in axes of the outboard body. That
    /// [`at`](Self::at) a time alone, along the first, unless it is said otherwise.
    fn in_space<X: Scalar<Real = R>>(&self, time: X, joint: usize) -> [X; 3] {
        [self.at(time, joint), X::zero(), X::zero()]
    }
}

/// A [`TimeLaw`] as the law of what acts in joints; a [`LoadLaw`] written for any number as that of what acts on bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OverTime<F>(pub F);

impl<M: Seen + MovingBody<M::Space>, L: LoadLaw<M>> LoadLaw<M> for OverTime<L> {
    type Value = L::Value;
    fn at(&self, time: RealOf<M::Space>, body: usize, motion: &M) -> L::Value {
        self.0.at(time, body, motion)
    }
    fn over_time(&self, time: <M::Space as Geometry>::Scalar, body: usize, motion: &M) -> L::Value {
        self.0.over_time(time, body, motion)
    }
    fn check(&self, bodies: usize) -> Result<(), Fault> {
        self.0.check(bodies)
    }
}

/// Laws of efforts in joints whose values have power series in time.
pub trait SeriesLaw<M: Seen>: LoadLaw<M> {
    /// Whether values are functions of time: whether there is more to a series than its first coefficient.
    const OVER_TIME: bool = true;

    /// The first coefficients of the powers of time (s) around a time, in the joint of a number: as many as are asked for, and no others.
    fn series<const N: usize>(&self, time: RealOf<M::Space>, joint: usize, asked: usize) -> [Self::Value; N];
}

impl<M: Seen> SeriesLaw<M> for Absent {
    const OVER_TIME: bool = false;

    fn series<const N: usize>(&self, _: RealOf<M::Space>, _: usize, _: usize) -> [Absent; N] {
        [Absent; N]
    }
}

impl<M: Seen, V: AsRef<[M::Load]>> SeriesLaw<M> for Values<V> {
    const OVER_TIME: bool = false;

    fn series<const N: usize>(&self, _: RealOf<M::Space>, joint: usize, _: usize) -> [M::Load; N] {
        let value = self.0.as_ref().get(joint).copied().unwrap_or_else(M::Load::null);
        core::array::from_fn(|k| if k == 0 { value } else { M::Load::null() })
    }
}

impl<M: Seen> LoadLaw<M> for Absent {
    type Value = Absent;
    const ON: bool = false;
    const READS: bool = false;
    fn at(&self, _: RealOf<M::Space>, _: usize, _: &M) -> Absent {
        Absent
    }
}

impl<M: Seen, F: Fn(RealOf<M::Space>, usize, &M) -> M::Load> LoadLaw<M> for Function<F> {
    type Value = M::Load;
    fn at(&self, time: RealOf<M::Space>, number: usize, motion: &M) -> M::Load {
        (self.0)(time, number, motion)
    }
}

impl<M: Seen, V: AsRef<[M::Load]>> LoadLaw<M> for Values<V> {
    type Value = M::Load;
    const READS: bool = false;
    #[inline(always)]
    fn at(&self, _: RealOf<M::Space>, number: usize, _: &M) -> M::Load {
        self.0.as_ref().get(number).copied().unwrap_or_else(M::Load::null)
    }
    #[inline(always)]
    fn list(&self) -> &[M::Load] {
        self.0.as_ref()
    }
    fn check(&self, expected: usize) -> Result<(), Fault> {
        count("loads", expected, self.0.as_ref().len())
    }
}
