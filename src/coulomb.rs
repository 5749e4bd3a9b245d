//! Dry friction as it is: a joint that sticks until a force breaks it away, and slips until it comes to rest.

use crate::counts::Counted;
use crate::element::{Condense, Element, Given, Implicit, InJoint, Posture, Reading, Springs, Sweep};
use crate::error::Fault;
use crate::error::checks::positive;
use crate::kinematics::{Acting, Driving, Kinematics, Outboard};
use crate::lift::Lift;
use crate::mirror::{Mode, Slip, Sticking};
use crate::relation::{Absent, AccelerationOf, Closures, Full};
use crate::release::{Freedom, Release, Resistance};
use crate::scalar::{Real, Scalar};
use crate::shape::{Joint, JointPosture, Kept, PerAxes, leaf};
use crate::space::{FrameOf, RealOf, Space};
use crate::spring::{SpringLaw, read};
use num_traits::Zero;
use typenum::{U0, U1};

/// A joint with Coulomb's friction: while it slips a force of constant size against its rate, while it sticks whatever keeps it from moving,
/// up to the force at which it breaks away.
///
/// Sticking and slipping are modes of a motion: a joint that sticks is locked, and has no pivot. Runs ([`simulation`] and all that follows
/// from it) change them where the rate passes zero and where the force breaks the joint away, the earliest first if several joints are
/// about to; they end a step there, so that rules keep their order, and rules that remember motions begin anew. A run finds
/// the modes of its start from its rates; where rates are set by hand they follow from these. Steps of a [`Stepper`] of one's own change no
/// mode, and are refused where a joint has come to move against that in which a run has left it: [`DryFriction`] is the smooth law for these.
///
/// Any joint with one coordinate can have such friction, in the plane and in space, and a spring, damper or law beside it. Runs over numbers
/// with derivatives, and over lanes, are refused: changes of mode have none of these. So are equilibria and modes of vibration, for a joint
/// that sticks rests anywhere within what friction holds, and mechanisms that come to rest with more such joints than they have freedoms: what
/// each of them bears is not determined.
///
/// Under error control, steps in which a joint sticks are looked at in their middle, closer where friction changes by more than a tenth of that
/// at which the joint breaks away, and then grow no further. A load that comes and goes between two looks while all is at rest is not seen:
/// [`longest_step`] is for such loads, and for fixed steps their ends are what is looked at.
///
/// ```
/// use catena::planar::*;
/// // A block of 2 kg on a plane, thrown at 3 m/s: it slides 0.9 m, and stays.
/// let block = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
/// let track = Coulomb::new(Slider::along(0.0), 10.0).breaking_away(12.0); // (N)
/// let scene = System::new(Clamped::origin(), (track, block), Free)?;
/// let start = scene.with_rates(scene.motion(), &[3.0])?;
/// let end = scene.simulation(Dop853::tolerance(1e-9)).run(start, 2.0, |_| ())?.motion;
/// assert!((end.coordinates()[0] - 0.9_f64).abs() < 1e-12);
/// assert_eq!(end.rates(), [0.0]);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// [`simulation`]: crate::system::System::simulation
/// [`longest_step`]: crate::simulate::Simulation::longest_step
/// [`Stepper`]: crate::simulate::Stepper
/// [`DryFriction`]: crate::planar::DryFriction
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Coulomb<J, T, L = Absent> {
    joint: J,
    law: L,
    /// Friction while the joint slips, and at which it breaks away (N·m, N).
    sliding: T,
    breaking: T,
}

impl<J, T: Scalar> Coulomb<J, T> {
    /// A joint with friction (N·m, N).
    pub fn new(joint: J, sliding: T) -> Self {
        Self { joint, law: Absent, sliding, breaking: sliding }
    }
}

impl<J, T: Scalar, L> Coulomb<J, T, L> {
    /// That breaks away at another force (N·m, N), which is no smaller.
    #[must_use]
    pub fn breaking_away(self, breaking: T) -> Self {
        Self { breaking, ..self }
    }

    /// With a spring, a damper or a law along the coordinate.
    pub fn with<M: SpringLaw<T>>(self, law: M) -> Coulomb<J, T, M> {
        let Self { joint, sliding, breaking, .. } = self;
        Coulomb { joint, law, sliding, breaking }
    }

    /// What acts along the coordinate.
    fn acting(&self, position: &Sticking<T>, rate: &Slip<T>, friction: T) -> Acting<T>
    where
        L: SpringLaw<T>,
    {
        let (q, v) = (position.coordinate, rate.rate);
        let law = Resistance::of(&self.law, q, v);
        let friction = match position.mode_at(rate) {
            Mode::Sticks => friction * self.breaking,
            slips => -(slips.sign::<T>() * self.sliding),
        };
        let resistance = Resistance { force: law.force + friction, ..law };
        Acting { resistance, energy: self.law.energy(q), inertia: T::zero() }
    }
}

/// What the elimination of a joint that sticks or slips keeps.
#[derive(Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Grip<K> {
    /// Gains by which the coordinate goes on.
    own: K,
    /// Of a joint that sticks: gains by which it would go without friction, and with that at which it breaks away.
    loose: Option<[K; 2]>,
}

impl<J, T, L> Counted for Coulomb<J, T, L> {
    type Bodies = U0;
    type Freedoms = U1;
}

impl<T: Scalar, U: Scalar, J: Lift<T, U>, L: Lift<T, U>> Lift<T, U> for Coulomb<J, T, L> {
    type Over = Coulomb<J::Over, U, L::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Coulomb {
            joint: self.joint.lift(number),
            law: self.law.lift(number),
            sliding: number(self.sliding),
            breaking: number(self.breaking),
        }
    }
}

impl<S: Space, J: Kinematics<S>, L: SpringLaw<S::Scalar>> Joint<S> for Coulomb<J, S::Scalar, L> {
    type Position = Sticking<S::Scalar>;
    type Rate = Slip<S::Scalar>;
    type Kept<C: Closures> = Grip<J::Kept<C>>;
    type Per<X: Copy> = J::Per<X>;

    const LINEAR: bool = L::LINEAR;

    fn position() -> Self::Position {
        Sticking { coordinate: S::Scalar::zero(), mode: Mode::Sticks }
    }
    fn rate() -> Self::Rate {
        Slip::none()
    }
    fn kept<C: Closures>() -> Self::Kept<C> {
        Grip { own: J::kept::<C>(), loose: None }
    }
    fn per<X: Copy>(fill: X) -> J::Per<X> {
        J::per(fill)
    }
    fn is_finite<C: Closures>(kept: &Self::Kept<C>) -> bool {
        J::is_finite::<C>(&kept.own)
    }
    fn configure(
        &self,
        position: &mut Self::Position,
        inboard: S::Turn,
        next: &mut impl FnMut(S::Turn) -> S::Scalar,
    ) -> S::Turn {
        self.joint.configure(&mut position.coordinate, inboard, next)
    }
    #[inline(always)]
    fn recover<C: Closures, By: Springs<S::Scalar>>(
        &self,
        inboard: AccelerationOf<S>,
        posture: JointPosture<'_, S, Self>,
        kept: &mut Self::Kept<C>,
        multipliers: &C::Each<S::Scalar>,
        rate: &mut Self::Rate,
    ) -> AccelerationOf<S> {
        let second = |gains: &mut J::Kept<C>| {
            let mut rate = S::Scalar::zero();
            let out = self.joint.recover::<C, Implicit<RealOf<S>>>(inboard, posture, gains, multipliers, &mut rate);
            (rate, out)
        };
        // What it takes to keep the coordinate from accelerating, by how much it would with and without.
        let mut free = S::Scalar::zero();
        rate.friction = free;
        if let Some([loose, pushed]) = &mut kept.loose {
            free = second(loose).0;
            rate.friction = free / (free - second(pushed).0);
        }
        let (own, out) = second(&mut kept.own);
        // Nothing else would tell of a load that is not finite where the joint sticks.
        rate.rate = own + free.scale(Zero::zero());
        out
    }
    #[inline(always)]
    fn respond<C: Closures>(
        &self,
        inboard: AccelerationOf<S>,
        posture: JointPosture<'_, S, Self>,
        kept: &Self::Kept<C>,
        multipliers: &C::Each<S::Scalar>,
        rate: &mut Self::Rate,
    ) -> AccelerationOf<S> {
        self.joint.respond::<C>(inboard, posture, &kept.own, multipliers, &mut rate.rate)
    }
    #[inline(always)]
    fn motion(
        &self,
        inboard: FrameOf<S>,
        position: &Self::Position,
        rate: &Self::Rate,
        acceleration: &Self::Rate,
    ) -> (S::JointMotion, FrameOf<S>) {
        let (motion, outboard) = self.joint.motion(inboard, &position.coordinate, &rate.rate, &acceleration.rate);
        (J::under(motion, self.acting(position, rate, acceleration.friction)), outboard)
    }
    fn release(&self, motion: &S::JointMotion, position: &Self::Position, rate: &Self::Rate) -> Release<S> {
        let mut release = self.joint.release(motion, &position.coordinate, &rate.rate);
        if position.mode_at(rate) == Mode::Sticks {
            return release.driven(S::Scalar::zero());
        }
        if let Some(coordinate) = &mut release.coordinates[0] {
            let preload = self.law.force(S::Scalar::zero(), S::Scalar::zero());
            let resistance = self.acting(position, rate, S::Scalar::zero()).resistance;
            *coordinate = Freedom { linear: L::LINEAR, ..coordinate.against(resistance, preload) };
        }
        release
    }
    fn check(&self) -> Result<(), Fault> {
        self.joint.check()?;
        self.law.check()?;
        positive("friction", self.sliding)?;
        positive("friction at which a joint breaks away", self.breaking)?;
        let (value, least) = (self.breaking.real().as_f64(), self.sliding.real().as_f64());
        let (most, parameter) = (f64::INFINITY, "friction at which a joint breaks away");
        let outside = "a joint would stick and slip at once";
        if value >= least { Ok(()) } else { Err(Fault::OutOfRange { parameter, value, least, most, outside }) }
    }
}

leaf!(joint [S: Space, J: Kinematics<S>, L: SpringLaw<S::Scalar>] Coulomb<J, S::Scalar, L>: S);

impl<S: Space, J: Kinematics<S>, L: SpringLaw<S::Scalar>> Element<S> for Coulomb<J, S::Scalar, L> {
    type Position = Sticking<S::Scalar>;
    type Rate = Slip<S::Scalar>;
    const ABSOLUTE: bool = false;

    fn lump(&mut self, mass: S::Scalar) -> S::Scalar {
        self.joint.lump(mass)
    }
    #[inline(always)]
    fn turned(&self, position: &Self::Position, rate: &Self::Rate, turn: S::Turn) -> S::Turn {
        self.joint.turned(&position.coordinate, &rate.rate, turn)
    }
    #[inline(always)]
    fn orient(
        &self,
        position: &Self::Position,
        rate: &Self::Rate,
        turn: S::Turn,
        x: &mut Self::Store<PerAxes<S::X>>,
        y: &mut Self::Store<PerAxes<S::Y>>,
        p: &mut Self::Store<PerAxes<S::P>>,
        q: &mut Self::Store<PerAxes<S::Q>>,
    ) -> S::Turn {
        self.joint.orient(&position.coordinate, &rate.rate, turn, x, y, p, q)
    }
    #[inline(always)]
    fn resolve(
        _: &Self::Store<PerAxes<S::Size>>,
        x: &mut Self::Store<PerAxes<S::X>>,
        y: &mut Self::Store<PerAxes<S::Y>>,
        p: &mut Self::Store<PerAxes<S::P>>,
        q: &mut Self::Store<PerAxes<S::Q>>,
    ) {
        <J as Kinematics<S>>::resolve(x, y, p, q);
    }
}

impl<S, J, L, Outer, W> Condense<S, Outer, W> for Coulomb<J, S::Scalar, L>
where
    S: Space,
    J: Kinematics<S>,
    L: SpringLaw<S::Scalar>,
    Outer: Outboard<S>,
    W: Sweep<S, Closures = Outer::Closures>,
    InJoint<S, W>: Driving<S>,
{
    type Out = Full<S, Outer::Closures>;

    #[inline(always)]
    fn condense(
        &self,
        outer: Outer,
        posture: Posture<'_, S, Self>,
        given: Given<'_, S, Self, W>,
        kept: &mut Self::Store<Kept<Outer::Closures>>,
    ) -> Self::Out {
        let Given { in_joints, position, rate, reading, springs, .. } = given;
        let posture = (posture.x, posture.y, posture.p, posture.q);
        let Reading { position: led, rate: led_rate, acceleration } = reading;
        let led = Reading { position: &led.coordinate, rate: &led_rate.rate, acceleration: &acceleration.rate };
        let [force, pivot] = read(&self.law, (position.coordinate, rate.rate), led, springs);
        let (force, outer, none) = (in_joints.onto(force), outer.whole(), S::Scalar::zero());
        let mode = position.mode_at(rate);
        if mode == Mode::Sticks {
            let mut loose = [(); 2].map(|()| J::kept::<Outer::Closures>());
            let [free, pushed] = &mut loose;
            self.joint.eliminate::<Outer::Closures>(outer, posture, force, none, free);
            self.joint.eliminate::<Outer::Closures>(outer, posture, force + self.breaking, none, pushed);
            kept.loose = Some(loose);
            return self.joint.drive::<Outer::Closures>(outer, posture, none, &mut kept.own);
        }
        kept.loose = None;
        let force = force - mode.sign::<S::Scalar>() * self.sliding;
        self.joint.eliminate::<Outer::Closures>(outer, posture, force, pivot, &mut kept.own)
    }
}
