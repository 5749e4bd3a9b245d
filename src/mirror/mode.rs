//! What a joint with modes does: friction, stops.

use super::Position;
use crate::scalar::{Elementary, Real, Scalar};
use num_traits::Zero;

/// What a joint with dry friction or with hard stops does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Mode {
    /// The joint does not move, for friction holds it.
    #[default]
    Sticks,
    /// A slip at positive rate.
    SlipsForward,
    /// A slip at negative rate.
    SlipsBack,
    /// The joint moves between its stops.
    Swings,
    /// The joint rests against its lower stop.
    RestsBelow,
    /// The joint rests against its upper stop.
    RestsAbove,
    /// The joint accelerates by one, whatever acts: what a shock does to all others is asked so.
    Struck,
    /// The joint comes to rest within the step under way ([`MoreauJean`](crate::time::MoreauJean)), for friction does it.
    Halts,
    /// The joint comes to its nearest stop within the step under way.
    Lands,
    /// The joint ends the step under way at the rate that its stop gives back.
    Rebounds,
}

impl Mode {
    /// The mode of a rate under friction; one that is zero sticks.
    pub(crate) fn of<T: Scalar>(rate: T) -> Self {
        match rate.real() {
            rate if rate > T::Real::zero() => Self::SlipsForward,
            rate if rate < T::Real::zero() => Self::SlipsBack,
            _ => Self::Sticks,
        }
    }

    /// The mode of a joint that breaks away from this friction: it goes where that does not hold it.
    pub(crate) fn broken_away<T: Scalar>(friction: T) -> Self {
        Self::of(-friction)
    }

    /// The mode of a joint that slips, the other way.
    pub(crate) fn turned_round(self) -> Self {
        match self {
            Self::SlipsForward => Self::SlipsBack,
            Self::SlipsBack => Self::SlipsForward,
            other => other,
        }
    }

    /// The sign of the rate, of a joint that slips.
    pub(crate) fn sign<T: Scalar>(self) -> T {
        match self {
            Self::SlipsForward => T::one(),
            Self::SlipsBack => -T::one(),
            _ => T::zero(),
        }
    }

    /// Whether the joint moves against friction.
    pub(crate) fn slips(self) -> bool {
        matches!(self, Self::SlipsForward | Self::SlipsBack)
    }

    /// Where the joint rests against a stop: −1 at the lower one, 1 at the upper one.
    pub(crate) fn stop(self) -> Option<f64> {
        match self {
            Self::RestsBelow => Some(-1.0),
            Self::RestsAbove => Some(1.0),
            _ => None,
        }
    }

    /// Whether the joint's acceleration is given.
    pub(crate) fn is_locked(self) -> bool {
        !matches!(self, Self::SlipsForward | Self::SlipsBack | Self::Swings)
    }

    /// The mode of such a joint at this rate, whatever it did.
    pub(crate) fn at<T: Scalar>(rate: T, rubs: bool) -> Self {
        if rubs { Self::of(rate) } else { Self::Swings }
    }

    /// The mode of such a joint where it moves: away from a stop at which it rests, with friction of whichever sign otherwise.
    pub(crate) fn moving(self, rubs: bool) -> Self {
        match self {
            _ if !rubs => Self::Swings,
            Self::RestsAbove => Self::SlipsBack,
            _ => Self::SlipsForward,
        }
    }

    /// The mode of such a joint that rests against the stop of a side.
    pub(crate) fn resting(side: f64) -> Self {
        if side < 0.0 { Self::RestsBelow } else { Self::RestsAbove }
    }

    /// The mode of such a joint of which nothing is known but its rate.
    pub(crate) fn forgotten(rubs: bool) -> Self {
        if rubs { Self::Sticks } else { Self::Swings }
    }

    /// Up to so far from its stop a joint touches it, as a share of 1 and where that is, and a rebound that rises no higher (rad, m) is none:
    /// some hundred roundings.
    pub(crate) fn touch<R: Real>() -> R {
        R::EPSILON * R::of(256.0)
    }

    /// A joint that would leave its stop at no more than this (rad/s², m/s²) stays: what leaves it for rounding comes back.
    pub(crate) fn reluctance<R: Real>() -> R {
        R::of(64.0 * Elementary::sqrt(R::EPSILON).as_f64())
    }

    /// All modes.
    const ALL: [Self; 10] = [
        Self::Sticks,
        Self::SlipsForward,
        Self::SlipsBack,
        Self::Swings,
        Self::RestsBelow,
        Self::RestsAbove,
        Self::Struck,
        Self::Halts,
        Self::Lands,
        Self::Rebounds,
    ];

    /// The mode as a number.
    pub(crate) fn number<T: Scalar>(self) -> T {
        T::literal(f64::from(self as u8))
    }

    /// The mode of a [`number`](Self::number).
    pub(crate) fn numbered<T: Scalar>(number: T) -> Self {
        let is = |mode: &&Self| mode.number::<T>().real() == number.real();
        Self::ALL.iter().find(is).copied().unwrap_or_default()
    }
}

/// What is told of a joint with modes: its acceleration, with that of [`GuardedRate`](super::GuardedRate), and what it has.
#[derive(Clone, Copy, Debug)]
pub struct Told<T> {
    /// The acceleration (rad/s², m/s²).
    pub rate: T,
    /// How near a change of mode is.
    pub guard: T,
    /// What the mode answers.
    pub answer: T,
    /// From the coordinate to the nearest stop (rad, m).
    pub apart: T,
    /// Whether the joint has dry friction.
    pub rubs: bool,
    /// Whether the joint has hard stops.
    pub stops: bool,
}

/// Lets all joints with modes go.
pub(crate) fn let_all_go<T: Scalar, P: Position<T>>(position: &mut P, rate: &mut P::Rate, found: &P::Rate) {
    position.each_mode(rate, found, &mut |mode, _, told| *mode = mode.moving(told.rubs));
}

/// Does something with the joint of a number, of those with modes.
pub(crate) fn with_joint<T: Scalar, P: Position<T>>(
    position: &mut P,
    rate: &mut P::Rate,
    found: &P::Rate,
    joint: usize,
    change: &mut dyn FnMut(&mut Mode, &mut T, Told<T>),
) {
    let mut count = 0;
    position.each_mode(rate, found, &mut |mode, rate, told| {
        if count == joint {
            change(mode, rate, told);
        }
        count += 1;
    });
}

/// Lets the last of the joints go that are held as one asks; whether there is one.
pub(crate) fn let_last_go<T: Scalar, P: Position<T>>(
    position: &mut P,
    rate: &mut P::Rate,
    found: &P::Rate,
    is_held: fn(Mode) -> bool,
) -> bool {
    let (mut last, mut count) = (None, 0);
    position.each_mode(rate, found, &mut |mode, _, _| {
        if is_held(*mode) {
            last = Some(count);
        }
        count += 1;
    });
    let Some(last) = last else { return false };
    with_joint(position, rate, found, last, &mut |mode, _, told| *mode = mode.moving(told.rubs));
    true
}
