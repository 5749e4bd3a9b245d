//! Joints whose coordinate is a given function of time.

pub(crate) mod backward;

use crate::counts::Counted;
use crate::element::{Condense, Element, Given, Implicit, Posture, Springs, Sweep};
use crate::error::Fault;
use crate::inner::{Drivable, Eliminates};
use crate::lift::lift;
use crate::mirror::Clock;
use crate::relation::{AccelerationOf, Closures};
use crate::release::Release;
use crate::scalar::Scalar;
use crate::shape::{Joint, JointPosture, Kept, PerAxes, leaf};
use crate::space::{FrameOf, RealOf, Space};
use core::fmt;
use num_traits::Zero;
use typenum::U0;

/// A coordinate as a given function of time. Functions are such laws; a type of one's own has a name.
pub trait MotionLaw<T: Scalar>: Copy + 'static {
    /// At a time (s): the coordinate (rad, m), its rate and its second derivative.
    fn at(&self, time: T::Real) -> [T; 3];
}

impl<T: Scalar, F: Fn(T::Real) -> [T; 3] + Copy + 'static> MotionLaw<T> for F {
    fn at(&self, time: T::Real) -> [T; 3] {
        self(time)
    }
}

/// A joint that is driven: its coordinate is a given function of time, and no freedom of the scene. A crank, a winch, a spindle.
///
/// Any joint with one coordinate can be driven: `planar::Revolute::smooth()` and `planar::Slider::along(..)`,
/// `spatial::Revolute::about(..)` and `spatial::Prismatic::along(..)`, [`Hinge`](crate::robot::Hinge) and
/// [`Slide`](crate::robot::Slide) of robots, kinematics of one's own. It stands anywhere in a scene, also in
/// arms and loops. A coordinate is that of the joint (relative angle, displacement); the law must give its true derivatives.
///
/// What the drive exerts is the internal force of its station: ON the outboard body the torque −m, the force q along the line. Springs
/// of the joint and loads in it move nothing: they are part of that force. Its power is that force times the rate. A robot's joint begins
/// at the origin of its parent: what its drive exerts is read a station further, at the link that it carries, about or along z of that;
/// reflected inertia takes I q̈ besides.
///
/// ```
/// use catena::planar::*;
/// // A crank at a constant rate (rad/s) that swings a rod.
/// let crank = Driven::new(Revolute::smooth(), |time: f64| [3.0 * time, 3.0, 0.0]);
/// let rod = Rod::uniform(0.5, 1.0);
/// let scene = System::new(Clamped::origin(), (crank.named("crank"), rod, Pin, rod), Free)?.with_gravity(9.81);
/// let start = scene.at_rest(&[-1.5])?; // the angle of the second rod: that of the crank is no coordinate
/// let run = scene.simulation(Dop853::tolerance(1e-9)).run(start, 0.5, |_| ())?;
/// assert_eq!(scene.angles(&run.motion)?.get(0), Some(&1.5));
/// let joint = scene.joint("crank")?;
/// let torque = scene.stations(&run.motion, &Unloaded)?.joint(joint).map(|station| -station.internal.torque);
/// # assert!(torque.is_some_and(|torque: f64| torque.is_finite()));
/// # Ok::<(), catena::Error>(())
/// ```
///
/// Gradients of runs go backward through it, and by the numbers of its law, six at most, those of the joint in the plane among them. Numbers
/// of closures are hidden: for that the law is a struct.
///
/// ```
/// use catena::planar::*;
/// use catena::scalar::{Elementary, Jet, Scalar};
/// /// A coordinate a sin ω t.
/// #[derive(Clone, Copy)]
/// struct Shake<T> {
///     amplitude: T,
///     frequency: T,
/// }
/// catena::lift!(Shake { amplitude, frequency });
/// impl<T: Scalar<Real = f64>> MotionLaw<T> for Shake<T> {
///     fn at(&self, time: f64) -> [T; 3] {
///         let Self { amplitude: a, frequency: w } = *self;
///         let (sine, cosine) = w.scale(time).sin_cos();
///         [a * sine, a * w * cosine, -a * w * w * sine]
///     }
/// }
/// /// A rod that hangs from one that is shaken.
/// macro_rules! pendulum {
///     ($amplitude:expr, $frequency:expr, $number:expr) => {{
///         let crank = Driven::new(Revolute::smooth(), Shake { amplitude: $amplitude, frequency: $frequency });
///         let rod = Rod::uniform($number(0.5), $number(1.0));
///         System::new(Clamped::origin(), (crank, rod, Pin, rod), Free)?.with_gravity($number(9.81))
///     }};
/// }
/// # let end_of = |amplitude: f64| -> Result<f64, catena::Error> {
/// #     let plain = pendulum!(amplitude, 4.0, |x: f64| x);
/// #     let start = plain.at_rest(&[-1.0])?;
/// #     Ok(plain.simulate(start, Rk4::step(0.01), 1.0, |_| ())?.motion.coordinates()[0])
/// # };
/// let plain = pendulum!(0.1, 4.0, |x: f64| x);
/// let start = plain.at_rest(&[-1.0])?;
/// let (mut backward, mut states) = (plain.backward(Rk4), [start; 101]);
/// backward.run(&start, 0.01, 100, &[], &mut states)?;
/// let at_end = |step, _: &_, by: &mut catena::sensitivity::Costate<_>| {
///     if step == 100 { by.add(&[1.0], &[0.0]) } else { Ok(()) }
/// };
/// let gradient = backward.gradient(&[], &states, &mut [], at_end)?;
/// let seeded = pendulum!(Jet::<f64, 2>::seed(0.1, 0), Jet::seed(4.0, 1), Jet::of);
/// let [by_amplitude, by_frequency] = gradient.along(&seeded)?; // of the angle at the end
/// # assert!((by_amplitude - (end_of(0.1 + 1e-5)? - end_of(0.1 - 1e-5)?) / 2e-5).abs() < 1e-7 && by_frequency != 0.0);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Driven<J, F> {
    joint: J,
    law: F,
}

impl<J, F> Driven<J, F> {
    /// A joint whose coordinate follows a law: at a time (s) the coordinate, its rate and its second derivative.
    pub const fn new(joint: J, law: F) -> Self {
        Self { joint, law }
    }

    /// The joint.
    pub const fn joint(&self) -> &J {
        &self.joint
    }

    /// The law.
    pub const fn law(&self) -> &F {
        &self.law
    }
}

impl<J, F> Driven<J, F> {
    /// The coordinate, its rate and its second derivative at the time of a clock.
    #[inline(always)]
    pub(crate) fn told<T: Scalar>(&self, clock: &Clock<T::Real>) -> [T; 3]
    where
        F: MotionLaw<T>,
    {
        clock.told(self.law.at(clock.time()))
    }
}

impl<J: fmt::Debug, F> fmt::Debug for Driven<J, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Driven").field("joint", &self.joint).finish_non_exhaustive()
    }
}

impl<J, F> Counted for Driven<J, F> {
    type Bodies = U0;
    type Freedoms = U0;
}

lift!(Driven<J, F> { joint, law });

impl<S: Space, J: Drivable<S>, F: MotionLaw<S::Scalar>> Joint<S> for Driven<J, F> {
    type Position = Clock<RealOf<S>>;
    type Rate = ();
    type Kept<C: Closures> = J::Kept<C>;
    type Per<X: Copy> = J::Per<X>;

    const LINEAR: bool = true;
    const SINES: usize = J::SINES;

    #[inline(always)]
    fn angle(&self, clock: &Self::Position) -> S::Scalar {
        let [position, ..] = self.told(clock);
        self.joint.angle(&position)
    }
    #[inline(always)]
    fn set_sine(&self, x: &mut J::Per<S::X>, sine_cosine: [S::Scalar; 2]) {
        self.joint.set_sine(x, sine_cosine);
    }

    fn still() -> (Self::Position, ()) {
        (Clock::at(Zero::zero()), ())
    }
    fn kept<C: Closures>() -> J::Kept<C> {
        J::kept::<C>()
    }
    fn per<X: Copy>(fill: X) -> J::Per<X> {
        J::per(fill)
    }
    fn is_finite<C: Closures>(kept: &J::Kept<C>) -> bool {
        J::is_finite::<C>(kept)
    }
    fn configure(
        &self,
        clock: &mut Self::Position,
        inboard: S::Turn,
        _: &mut impl FnMut(S::Turn) -> S::Scalar,
    ) -> S::Turn {
        let [position, ..] = self.told(clock);
        self.joint.turned(&position, &S::Scalar::zero(), inboard)
    }
    #[cfg_attr(optimised, inline(always))]
    fn recover<C: Closures, By: Springs<S::Scalar>>(
        &self,
        inboard: AccelerationOf<S>,
        posture: JointPosture<'_, S, Self>,
        kept: &mut J::Kept<C>,
        multipliers: &C::Each<S::Scalar>,
        (): &mut (),
    ) -> AccelerationOf<S> {
        // Gains that give the law's acceleration whatever the inboard side does, of the relative coordinate.
        let second = &mut S::Scalar::zero();
        self.joint.recover::<C, Implicit<RealOf<S>>>(inboard, posture, kept, multipliers, second)
    }
    #[cfg_attr(optimised, inline(always))]
    fn respond<C: Closures>(
        &self,
        inboard: AccelerationOf<S>,
        posture: JointPosture<'_, S, Self>,
        kept: &J::Kept<C>,
        multipliers: &C::Each<S::Scalar>,
        (): &mut (),
    ) -> AccelerationOf<S> {
        self.joint.respond::<C>(inboard, posture, kept, multipliers, &mut S::Scalar::zero())
    }
    #[inline(always)]
    fn motion(&self, inboard: FrameOf<S>, clock: &Self::Position, (): &(), (): &()) -> (S::JointMotion, FrameOf<S>) {
        let [position, rate, second] = self.told(clock);
        self.joint.motion(inboard, &position, &rate, &second)
    }
    fn release(&self, motion: &S::JointMotion, clock: &Self::Position, (): &()) -> Release<S> {
        let [position, rate, second] = self.told(clock);
        self.joint.release(motion, &position, &rate).driven(second)
    }
    fn check(&self) -> Result<(), Fault> {
        self.joint.check() // the law at the times of runs, which may begin anywhere
    }
}

leaf!(joint [S: Space, J: Drivable<S>, F: MotionLaw<S::Scalar>] Driven<J, F>: S);

impl<S: Space, J: Drivable<S>, F: MotionLaw<S::Scalar>> Element<S> for Driven<J, F> {
    type Position = Clock<RealOf<S>>;
    type Rate = ();
    const ABSOLUTE: bool = false;

    fn lump(&mut self, mass: S::Scalar) -> S::Scalar {
        self.joint.lump(mass)
    }
    #[inline(always)]
    fn turned(&self, clock: &Self::Position, (): &(), turn: S::Turn) -> S::Turn {
        let [position, rate, _] = self.told(clock);
        self.joint.turned(&position, &rate, turn)
    }
    #[cfg_attr(optimised, inline(always))]
    fn orient(
        &self,
        clock: &Self::Position,
        (): &(),
        turn: S::Turn,
        x: &mut Self::Store<PerAxes<S::X>>,
        y: &mut Self::Store<PerAxes<S::Y>>,
        p: &mut Self::Store<PerAxes<S::P>>,
        q: &mut Self::Store<PerAxes<S::Q>>,
    ) -> S::Turn {
        let [position, rate, _] = self.told(clock);
        self.joint.orient(&position, &rate, turn, x, y, p, q)
    }
    #[cfg_attr(optimised, inline(always))]
    fn resolve(
        _: &Self::Store<PerAxes<S::Size>>,
        x: &mut Self::Store<PerAxes<S::X>>,
        y: &mut Self::Store<PerAxes<S::Y>>,
        p: &mut Self::Store<PerAxes<S::P>>,
        q: &mut Self::Store<PerAxes<S::Q>>,
    ) {
        <J as Drivable<S>>::resolve(x, y, p, q);
    }
}

impl<S, J, F, Outer, W> Condense<S, Outer, W> for Driven<J, F>
where
    S: Space,
    J: Eliminates<S, Outer, W>,
    F: MotionLaw<S::Scalar>,
    Outer: Copy,
    W: Sweep<S>,
{
    type Out = J::Out;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: Outer,
        posture: Posture<'_, S, Self>,
        given: Given<'_, S, Self, W>,
        kept: &mut Self::Store<Kept<W::Closures>>,
    ) -> J::Out {
        let [.., second] = self.told(given.position);
        self.joint.drive(outer, (posture.x, posture.y, posture.p, posture.q), second, kept)
    }
}
