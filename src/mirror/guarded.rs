//! The mirror of a coordinate whose joint has modes: what is kept with it, and told with an acceleration.

use super::fieldwise::fieldwise_rate;
use super::{Mode, Position, Rate, Retraction, Term, Told};
use crate::lift::Lift;
use crate::scalar::Scalar;
use core::fmt::Debug;
use core::marker::PhantomData;
use num_traits::Zero;

/// What guards a coordinate, so that its joint has modes.
pub trait Guarding: Copy + Debug + 'static {
    /// Whether the joint has dry friction.
    const RUBS: bool;
    /// Whether the joint has hard stops.
    const STOPS: bool;
}

/// Dry friction alone.
#[derive(Clone, Copy, Debug)]
pub struct Rubs;

/// Hard stops alone.
#[derive(Clone, Copy, Debug)]
pub struct Stops;

/// Dry friction between hard stops.
#[derive(Clone, Copy, Debug)]
pub struct RubsBetweenStops;

impl Guarding for Rubs {
    const RUBS: bool = true;
    const STOPS: bool = false;
}

impl Guarding for Stops {
    const RUBS: bool = false;
    const STOPS: bool = true;
}

impl Guarding for RubsBetweenStops {
    const RUBS: bool = true;
    const STOPS: bool = true;
}

/// A coordinate whose joint has modes, by what guards it.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "T: serde::Serialize", deserialize = "T: serde::Deserialize<'de>"))
)]
pub struct Guarded<T, K> {
    /// The coordinate (rad, m).
    pub coordinate: T,
    /// What the joint does: kept through steps, changed between them.
    pub mode: Mode,
    #[cfg_attr(feature = "serde", serde(skip))]
    guarding: PhantomData<K>,
}

/// The rate of a coordinate whose joint has modes, or its acceleration.
///
/// What is told of the mode belongs to the acceleration: it is not counted, visited or replaced, and sums leave it as it is.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct GuardedRate<T> {
    /// Of the coordinate.
    pub rate: T,
    /// With an acceleration, how near a change of mode is. Of a joint that sticks the friction that makes it stick, ON the outboard body, as a
    /// share of that at which it breaks away; of one between its stops −1 at the lower and 1 at the upper one, nearer to zero by the
    /// distance (rad, m) from the nearest as a share of 1 and where that is; of one that rests the acceleration with which it would leave.
    pub guard: T,
    /// With an acceleration, what the mode answers. Of a joint that does not move what is exerted ON the outboard body (N·m, N); of one
    /// between its stops the share of its rate that they give back.
    pub answer: T,
    /// With an acceleration, of a joint between its stops: from the coordinate to the nearest (rad, m).
    pub apart: T,
}

impl<T: Scalar, K: Guarding> Guarded<T, K> {
    pub(crate) fn new(coordinate: T, mode: Mode) -> Self {
        Self { coordinate, mode, guarding: PhantomData }
    }

    /// What the joint does at a rate: what moves does not stick or rest, whatever a motion says that was made by hand.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn mode_at(&self, rate: &GuardedRate<T>) -> Mode {
        match self.mode {
            Mode::Sticks => Mode::of(rate.rate),
            Mode::RestsBelow | Mode::RestsAbove if !rate.rate.real().is_zero() => Mode::at(rate.rate, K::RUBS),
            mode => mode,
        }
    }
}

impl<T: Scalar> GuardedRate<T> {
    pub(crate) fn telling(rate: T, [guard, answer, apart]: [T; 3]) -> Self {
        Self { rate, guard, answer, apart }
    }

    pub(crate) fn none() -> Self {
        Self::telling(T::zero(), [T::zero(); 3])
    }
}

impl<T: Scalar> Rate<T> for GuardedRate<T> {
    const LENGTH: usize = 1;

    fieldwise_rate!([rate guard answer apart] [rate] [rate]);
}

impl<T: Scalar, K: Guarding> Retraction<T> for Guarded<T, K> {
    type Rate = GuardedRate<T>;
}

impl<T: Scalar, K: Guarding> Position<T> for Guarded<T, K> {
    const MODES: bool = true;

    #[inline(always)]
    fn drift_0(&mut self, from: &Self, (time, rate): Term<'_, T, GuardedRate<T>>) {
        self.mode = from.mode;
        self.coordinate.drift_0(&from.coordinate, (time, &rate.rate));
    }
    #[inline(always)]
    fn drift_1(&mut self, from: &Self, (time, rate): Term<'_, T, GuardedRate<T>>, (u, a): Term<'_, T, GuardedRate<T>>) {
        self.mode = from.mode;
        self.coordinate.drift_1(&from.coordinate, (time, &rate.rate), (u, &a.rate));
    }
    #[cfg_attr(optimised, inline(always))]
    fn drift_2(
        &mut self,
        from: &Self,
        (time, rate): Term<'_, T, GuardedRate<T>>,
        (u, a): Term<'_, T, GuardedRate<T>>,
        (v, b): Term<'_, T, GuardedRate<T>>,
    ) {
        self.mode = from.mode;
        self.coordinate.drift_2(&from.coordinate, (time, &rate.rate), (u, &a.rate), (v, &b.rate));
    }
    #[inline(always)]
    fn displace(&mut self, step: &GuardedRate<T>) {
        self.coordinate += step.rate;
    }
    #[inline(always)]
    fn apart(&self, from: &Self, displacement: &mut GuardedRate<T>) {
        displacement.rate = self.coordinate - from.coordinate;
    }
    #[inline(always)]
    fn measure(&self, displacement: &GuardedRate<T>, note: &mut impl FnMut(T, T)) {
        self.coordinate.measure(&displacement.rate, note);
    }
    #[inline(always)]
    fn square_shares(&self, displacement: &GuardedRate<T>, squares: &mut GuardedRate<T>) {
        Position::square_shares(&self.coordinate, &displacement.rate, &mut squares.rate);
    }
    #[inline(always)]
    fn visit(&self, visit: &mut impl FnMut(T)) {
        visit(self.coordinate);
    }
    #[inline(always)]
    fn replace(&mut self, make: &mut impl FnMut(T) -> T) {
        self.coordinate = make(self.coordinate);
    }
    /// Of other modes is another motion.
    #[inline(always)]
    fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool {
        test(self.coordinate, other.coordinate) && test(self.mode.number(), other.mode.number())
    }
    fn each_mode(
        &mut self,
        rate: &mut GuardedRate<T>,
        acceleration: &GuardedRate<T>,
        visit: &mut impl FnMut(&mut Mode, &mut T, Told<T>),
    ) {
        let GuardedRate { rate: second, guard, answer, apart } = *acceleration;
        visit(
            &mut self.mode,
            &mut rate.rate,
            Told { rate: second, guard, answer, apart, rubs: K::RUBS, stops: K::STOPS },
        );
    }
}

impl<T: Scalar, U: Scalar, K: Guarding> Lift<T, U> for Guarded<T, K> {
    type Over = Guarded<U, K>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Guarded<U, K> {
        Guarded::new(number(self.coordinate), self.mode)
    }
}

impl<T: Scalar, U: Scalar> Lift<T, U> for GuardedRate<T> {
    type Over = GuardedRate<U>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> GuardedRate<U> {
        GuardedRate::telling(number(self.rate), [self.guard, self.answer, self.apart].map(number))
    }
}
