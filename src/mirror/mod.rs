//! Motions have the shape of their scene: a joint's coordinates where the scene has the joint, nothing where it has a body.
//!
//! A chain `(rod, Pin, rod)` moves with coordinates of type `((), T, ())`, an array of links with an array of them. Time
//! rules need only two things of such a value: linear combinations of rates ([`Rate::mix_2`]) and positions displaced
//! by them ([`Position::drift_2`]). In the plane positions are numbers like rates; a rotation in space turns by them instead: for
//! rules of an order above two it also says how coordinates of a step change with the rates ([`Retraction::CURVED`]).
//!
//! Combinations are written out for each number of terms. One function over an array of terms would have to take the array
//! apart at every item of every tuple, and a compiler spends more time on that than on all mechanics of a long chain.

mod clock;
mod fieldwise;
mod guarded;
mod items;
pub(crate) mod margin;
mod mode;
mod number;
mod tied;
mod tuple;

pub use clock::Clock;
pub use guarded::{Guarded, GuardedRate, Guarding, Rubs, RubsBetweenStops, Stops};
pub use mode::{Mode, Told};
pub(crate) use mode::{let_all_go, let_last_go, with_joint};
pub use tied::{Tied, TiedPosition};

use crate::scalar::Scalar;

/// A rate or an acceleration with its weight in a sum.
pub type Term<'a, T, A> = (<T as Scalar>::Real, &'a A);

/// Rates or accelerations of all joint coordinates: a linear space.
///
/// Terms of a sum are added one by one from left to right, however many a function takes.
pub trait Rate<T: Scalar>: Clone {
    /// How many numbers are stored; of a vector, which nobody knows before it is made, as many as can be.
    const LENGTH: usize;
    /// How many of them stand in fields of their own: of an array those of one item.
    const FIELDS: usize = Self::LENGTH;

    /// `self = base`: a copy that allocates nothing.
    fn set(&mut self, base: &Self);

    /// `self = base + a`.
    fn mix_1(&mut self, base: &Self, a: Term<'_, T, Self>);

    /// `self = base + a + b`.
    fn mix_2(&mut self, base: &Self, a: Term<'_, T, Self>, b: Term<'_, T, Self>);

    /// `self = base + a + b + c`.
    fn mix_3(&mut self, base: &Self, a: Term<'_, T, Self>, b: Term<'_, T, Self>, c: Term<'_, T, Self>);

    /// `self = self + a + b + c + d`.
    fn add_4(&mut self, a: Term<'_, T, Self>, b: Term<'_, T, Self>, c: Term<'_, T, Self>, d: Term<'_, T, Self>);

    /// `self = self + step`.
    fn add(&mut self, step: &Self);

    /// `self = base + u self`: in place.
    fn scale_onto(&mut self, u: T::Real, base: &Self);

    /// Squares of shares of sizes, each coordinate by itself: `self = (of / (|size| + 1))²`.
    fn square_shares(&mut self, of: &Self, size: &Self);

    /// Calls `visit` with each coordinate, root to tip.
    fn visit(&self, visit: &mut impl FnMut(T));

    /// Replaces each coordinate, root to tip.
    fn replace(&mut self, make: &mut impl FnMut(T) -> T);

    /// Replaces each coordinate by what comes of it and of that of another at the same place.
    fn join(&mut self, other: &Self, make: &mut impl FnMut(T, T) -> T);

    /// Whether `test` holds for each pair of numbers at the same place, and there are as many (only a `Vec` can differ).
    fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool;
}

/// How ⊕ bends: the differential of the retraction, its second derivative, and the transposes of both. Where positions are numbers, nothing does.
pub trait Retraction<T: Scalar>: Sized {
    /// The rates of these coordinates.
    type Rate: Rate<T>;

    /// Whether ⊕ is more than a sum: then the numbers displaced by are coordinates of the step, whose time derivatives a rule sums
    /// up and these two methods translate. Positions that are numbers need neither.
    const CURVED: bool = false;

    /// Turns derivatives ṡ of the coordinates of the step that led here from `from` into rates: the differential of the retraction,
    /// v = D(from ⊕ s) ṡ.
    #[inline(always)]
    fn retract_rate(&self, from: &Self, rate: &mut Self::Rate) {
        let _ = (from, rate);
    }

    /// Turns accelerations here into second derivatives s̈ of the coordinates of the step from `from`: the inverse of what two
    /// derivatives of the retraction do.
    #[inline(always)]
    fn inverse_retract_acceleration(&self, from: &Self, rate: &Self::Rate, acceleration: &mut Self::Rate) {
        let _ = (from, rate, acceleration);
    }

    /// Turns costates of second derivatives s̈ of the coordinates of the step from `from` into those of accelerations here: the transpose
    /// of what [`inverse_retract_acceleration`](Self::inverse_retract_acceleration) does to these.
    #[inline(always)]
    fn transposed_acceleration(&self, from: &Self, costate: &mut Self::Rate) {
        let _ = (from, costate);
    }

    /// Turns costates of positions and rates here, and of s̈, into those of the coordinates s of the step from `from` and of ṡ, and adds
    /// that of `from`. Of s̈ only what positions and rates change of it, for these accelerations.
    #[cfg_attr(optimised, inline(always))]
    fn transposed_step(
        &self,
        from: &Self,
        (rate, acceleration): (&Self::Rate, &Self::Rate),
        of_second: &Self::Rate,
        (of_position, of_rate): (&mut Self::Rate, &mut Self::Rate),
        of_from: &mut Self::Rate,
    ) {
        let _ = (from, rate, acceleration, of_second, of_rate);
        of_from.add(of_position);
    }

    /// Adds what s̈ of the step from `from` changes by with positions and rates here, and with `from`, to their costates, for these
    /// accelerations: where positions here have been put elsewhere than the step led.
    #[cfg_attr(optimised, inline(always))]
    fn transposed_second(
        &self,
        from: &Self,
        (rate, acceleration): (&Self::Rate, &Self::Rate),
        of_second: &Self::Rate,
        (of_position, of_rate): (&mut Self::Rate, &mut Self::Rate),
        of_from: &mut Self::Rate,
    ) {
        let _ = (from, rate, acceleration, of_second, of_position, of_rate, of_from);
    }

    /// Shows the rates of each attitude: steps in its coordinates end at half a turn.
    #[inline(always)]
    fn each_turn(&self, rate: &Self::Rate, visit: &mut impl FnMut([T; 3])) {
        let _ = (rate, visit);
    }
}

/// Positions of all joint coordinates, with rates of type `Rate`. ⊕ is the retraction: it adds numbers, and turns attitudes by the step.
pub trait Position<T: Scalar>: Retraction<T> + Clone {
    /// `self = from ⊕ rate`: displaced by a rate that lasts for a time (s).
    fn drift_0(&mut self, from: &Self, rate: Term<'_, T, Self::Rate>);

    /// `self = from ⊕ (rate + a)`: and by accelerations, whose weights (s²) a time rule knows.
    fn drift_1(&mut self, from: &Self, rate: Term<'_, T, Self::Rate>, a: Term<'_, T, Self::Rate>);

    /// `self = from ⊕ (rate + a + b)`.
    fn drift_2(
        &mut self,
        from: &Self,
        rate: Term<'_, T, Self::Rate>,
        a: Term<'_, T, Self::Rate>,
        b: Term<'_, T, Self::Rate>,
    );

    /// `self = self ⊕ step`.
    fn displace(&mut self, step: &Self::Rate);

    /// Sets the displacement that leads here from `from`: the inverse of [`displace`](Self::displace).
    fn apart(&self, from: &Self, displacement: &mut Self::Rate);

    /// Calls `note` with each number of a displacement from here, root to tip, and the size by which to measure it relatively
    /// (that of the coordinate).
    fn measure(&self, displacement: &Self::Rate, note: &mut impl FnMut(T, T));

    /// Squares of a displacement from here, each number as a share of one and the size by which [`measure`](Self::measure) measures it.
    fn square_shares(&self, displacement: &Self::Rate, squares: &mut Self::Rate);

    /// Calls `visit` with each number stored, root to tip.
    fn visit(&self, visit: &mut impl FnMut(T));

    /// Replaces each number stored, root to tip.
    fn replace(&mut self, make: &mut impl FnMut(T) -> T);

    /// Whether `test` holds for each pair of numbers at the same place, and there are as many (only a `Vec` can differ).
    fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool;

    /// Brings numbers that were replaced to what they must be, a quaternion to length one; whether that can be done.
    fn normalise(&mut self) -> bool {
        true
    }

    /// Sets the clocks of driven coordinates to the time (s) of the motion.
    #[inline(always)]
    fn set_clocks(&mut self, time: T::Real) {
        let _ = time;
    }

    /// Whether coordinates are driven.
    const CLOCKED: bool = false;

    /// Lets driven coordinates stand where they are, at rest.
    fn stop_clocks(&mut self) {}

    /// Whether joints have modes.
    const MODES: bool = false;

    /// Shows each coordinate whose joint has modes: its mode and rate, to be changed, and its acceleration with what is told of the mode.
    fn each_mode(
        &mut self,
        rate: &mut Self::Rate,
        acceleration: &Self::Rate,
        visit: &mut impl FnMut(&mut Mode, &mut T, Told<T>),
    ) {
        let _ = (rate, acceleration, visit);
    }
}
