//! Joints with modes: what keeps the coordinate of a joint from moving at times, and what it does when it moves.

pub(crate) mod backward;
mod bounded;
mod friction;
mod given;
mod range;

use crate::counts::Counted;
use crate::element::{Condense, Element, Given, Implicit, InJoint, Posture, Reading, Springs, Sweep};
use crate::error::Fault;
use crate::inner::{Drivable, Eliminates, Guardable};
use crate::kinematics::{Acting, Driving};
use crate::lift::lift;
use crate::mirror::{self, GuardedRate, Guarding, Mode};
use crate::relation::{Absent, AccelerationOf, Closures};
use crate::release::{Freedom, Release, Resistance};
use crate::scalar::Scalar;
use crate::shape::{Joint, JointPosture, Kept, PerAxes, leaf};
use crate::space::{FrameOf, RealOf, Space};
use crate::spring::{SpringLaw, read};
pub use bounded::BoundedCoulomb;
pub use friction::Coulomb;
use num_traits::Zero;
pub use range::HardStops;
use typenum::{U0, U1};

/// What a joint with modes does in each: friction, stops.
pub trait Guard<T: Scalar>: Copy + 'static {
    /// Name of such joints.
    const KIND: &'static str;
    /// Which modes the joint has.
    type Guarding: Guarding;

    /// The force against the coordinate of a joint that moves (N·m, N).
    fn resists(&self, mode: Mode) -> T;
    /// A force by which the acceleration of a joint that does not move is tried.
    fn trial(&self) -> T;
    /// What is told of a joint that moves, in the order of [`GuardedRate`].
    fn free(&self, coordinate: T) -> [T; 3];
    /// What is told of a joint whose acceleration is given, of what would be told at the end of the step, if it moved: by how much it would
    /// accelerate beside that, and under the force on trial.
    fn held(&self, mode: Mode, free: [T; 3], accelerations: [T; 2]) -> [T; 3];
    /// Rejects parameters that make no mechanics.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<(), Fault>;
}

/// A joint with modes: kinematics, a guard, and a law along the coordinate.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Guarded<J, G, L = Absent> {
    joint: J,
    guard: G,
    law: L,
}

impl<J, G> Guarded<J, G> {
    /// With a spring, a damper or a law along the coordinate, or several as a tuple.
    pub fn with<M>(self, law: M) -> Guarded<J, G, M> {
        let Self { joint, guard, .. } = self;
        Guarded { joint, guard, law }
    }
}

impl<J, G, L> Guarded<J, G, L> {
    /// The joint inside.
    pub(crate) fn joint(&self) -> &J {
        &self.joint
    }

    /// What guards its coordinate.
    pub(crate) fn guard(&self) -> &G {
        &self.guard
    }

    /// The law along the coordinate.
    pub(crate) fn law(&self) -> &L {
        &self.law
    }

    /// What acts along the coordinate.
    fn acting<T: Scalar>(
        &self,
        position: &mirror::Guarded<T, G::Guarding>,
        rate: &GuardedRate<T>,
        answer: T,
    ) -> Acting<T>
    where
        G: Guard<T>,
        L: SpringLaw<T>,
    {
        let (q, v) = (position.coordinate, rate.rate);
        let law = Resistance::of(&self.law, q, v);
        let mode = position.mode_at(rate);
        let guard = if mode.is_locked() { answer } else { -self.guard.resists(mode) };
        let resistance = Resistance { force: law.force + guard, ..law };
        Acting { resistance, energy: self.law.energy(q), inertia: T::zero() }
    }
}

/// What the elimination of a joint with modes keeps.
#[derive(Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Grip<T, K> {
    /// Gains by which the coordinate goes on.
    pub(crate) own: K,
    /// What is told of a joint that moves.
    told: [T; 3],
    /// Of a joint whose acceleration is given: its mode, that acceleration, gains by which it would go otherwise, and under the force on trial.
    loose: Option<(Mode, T, [K; 2])>,
}

impl<J, G, L> Counted for Guarded<J, G, L> {
    type Bodies = U0;
    type Freedoms = U1;
}

lift!(Guarded<J, G, L> { joint, guard, law });

impl<S: Space, J: Guardable<S>, G: Guard<S::Scalar>, L: SpringLaw<S::Scalar>> Joint<S> for Guarded<J, G, L> {
    type Position = mirror::Guarded<S::Scalar, G::Guarding>;
    type Rate = GuardedRate<S::Scalar>;
    type Kept<C: Closures> = Grip<S::Scalar, J::Kept<C>>;
    type Per<X: Copy> = J::Per<X>;

    const LINEAR: bool = L::LINEAR;
    const SINES: usize = J::SINES;

    #[inline(always)]
    fn angle(&self, position: &Self::Position) -> S::Scalar {
        self.joint.angle(&position.coordinate)
    }
    #[inline(always)]
    fn set_sine(&self, x: &mut J::Per<S::X>, sine_cosine: [S::Scalar; 2]) {
        self.joint.set_sine(x, sine_cosine);
    }

    fn still() -> (Self::Position, Self::Rate) {
        (mirror::Guarded::new(S::Scalar::zero(), Mode::forgotten(G::Guarding::RUBS)), GuardedRate::none())
    }
    fn kept<C: Closures>() -> Self::Kept<C> {
        Grip { own: J::kept::<C>(), told: [S::Scalar::zero(); 3], loose: None }
    }
    fn per<X: Copy>(fill: X) -> J::Per<X> {
        J::per(fill)
    }
    fn kind() -> &'static str {
        G::KIND
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
    #[cfg_attr(optimised, inline(always))]
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
        // By how much the coordinate would accelerate if it could.
        let (mut free, mut told) = (S::Scalar::zero(), kept.told);
        if let Some((mode, given, [loose, tried])) = &mut kept.loose {
            free = second(loose).0;
            told = self.guard.held(*mode, told, [free, second(tried).0].map(|second| second - *given));
        }
        let (own, out) = second(&mut kept.own);
        // Nothing else would tell of a load that is not finite where the joint does not move.
        *rate = GuardedRate::telling(own + free.scale(Zero::zero()), told);
        out
    }
    #[cfg_attr(optimised, inline(always))]
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
    #[cfg_attr(optimised, inline(always))]
    fn motion(
        &self,
        inboard: FrameOf<S>,
        position: &Self::Position,
        rate: &Self::Rate,
        acceleration: &Self::Rate,
    ) -> (S::JointMotion, FrameOf<S>) {
        let (motion, outboard) = self.joint.motion(inboard, &position.coordinate, &rate.rate, &acceleration.rate);
        (J::under(motion, self.acting(position, rate, acceleration.answer)), outboard)
    }
    fn release(&self, motion: &S::JointMotion, position: &Self::Position, rate: &Self::Rate) -> Release<S> {
        let mut release = self.joint.release(motion, &position.coordinate, &rate.rate);
        if position.mode_at(rate).is_locked() {
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
        self.guard.check()
    }
}

leaf!(joint [S: Space, J: Guardable<S>, G: Guard<S::Scalar>, L: SpringLaw<S::Scalar>] Guarded<J, G, L>: S);

impl<S: Space, J: Guardable<S>, G: Guard<S::Scalar>, L: SpringLaw<S::Scalar>> Element<S> for Guarded<J, G, L> {
    type Position = mirror::Guarded<S::Scalar, G::Guarding>;
    type Rate = GuardedRate<S::Scalar>;
    const ABSOLUTE: bool = false;

    fn lump(&mut self, mass: S::Scalar) -> S::Scalar {
        self.joint.lump(mass)
    }
    #[inline(always)]
    fn turned(&self, position: &Self::Position, rate: &Self::Rate, turn: S::Turn) -> S::Turn {
        self.joint.turned(&position.coordinate, &rate.rate, turn)
    }
    #[cfg_attr(optimised, inline(always))]
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

impl<S, J, G, L, Outer, W> Condense<S, Outer, W> for Guarded<J, G, L>
where
    S: Space,
    J: Guardable<S> + Eliminates<S, Outer, W>,
    G: Guard<S::Scalar>,
    L: SpringLaw<S::Scalar>,
    Outer: Copy,
    W: Sweep<S>,
    InJoint<S, W>: Driving<S>,
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
        let Given { in_joints, position, rate, reading, springs, .. } = given;
        let posture = (posture.x, posture.y, posture.p, posture.q);
        let Reading { position: led, rate: led_rate, acceleration } = reading;
        let led = Reading { position: &led.coordinate, rate: &led_rate.rate, acceleration: &acceleration.rate };
        let [force, pivot] = read(&self.law, (position.coordinate, rate.rate), led, springs);
        let (force, none) = (in_joints.onto(force), S::Scalar::zero());
        let mode = position.mode_at(rate);
        if mode.is_locked() {
            let (second, told) = self.given(mode, (position.coordinate, rate.rate), springs);
            let force =
                if G::Guarding::STOPS { force - self.on_the_way(mode, rate.rate, second, springs) } else { force };
            let mut loose = [(); 2].map(|()| J::kept::<W::Closures>());
            let [free, tried] = &mut loose;
            self.joint.eliminate(outer, posture, force, none, free);
            self.joint.eliminate(outer, posture, force + self.guard.trial(), none, tried);
            (kept.loose, kept.told) = (Some((mode, second, loose)), told);
            return self.joint.drive(outer, posture, second, &mut kept.own);
        }
        (kept.loose, kept.told) = (None, self.guard.free(position.coordinate));
        let force = force - self.guard.resists(mode);
        self.joint.eliminate(outer, posture, force, pivot, &mut kept.own)
    }
}
