//! Motions closed by moving what the user did not fix.

use super::dynamics::Dynamics;
use super::hold::{CORRECTIONS, shorten};
use super::least_change::least_change;
use super::lists::{numbers, set, unit};
use super::{MotionOf, Runs, System, coordinates};
use crate::element::{Element, Level, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::loading::couples;
use crate::mirror::{Position, Rate};
use crate::observe::each_residual;
use crate::relation::{Closures, Geometry};
use crate::scalar::{Real, Scalar};
use alloc::vec;
use alloc::vec::Vec;
use num_traits::{One, Zero};

/// What stays where it is given while a motion is assembled: numbers of coordinates, counted from 0 as those of
/// [`System::with_rates`] are, root to tip. In the plane a pin has one, the absolute angle of its outboard body. Of a ball all three
/// belong together.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Holding<'a> {
    /// Coordinates whose positions stay.
    pub positions: &'a [usize],
    /// Coordinates whose rates stay.
    pub rates: &'a [usize],
}

impl<'a> Holding<'a> {
    /// Holds the positions and the rates of these coordinates.
    pub const fn both(coordinates: &'a [usize]) -> Self {
        Self { positions: coordinates, rates: coordinates }
    }

    /// Which of so many are held.
    fn of(held: &[usize], count: usize) -> Result<Vec<bool>, Error> {
        let mut of = vec![false; count];
        for k in held {
            let Some(of) = of.get_mut(*k) else {
                let (value, most) = (*k as f64, count as f64 - 1.0);
                let outside = "the scene has no such coordinate";
                let fault =
                    Fault::OutOfRange { parameter: "number of a held coordinate", value, least: 0.0, most, outside };
                return Err(Error::new(fault));
            };
            *of = true;
        }
        Ok(of)
    }
}

/// A motion that has been assembled, and what had to move.
#[derive(Clone, Debug)]
pub struct Assembled<M, T> {
    /// The motion.
    pub motion: M,
    /// By how much each coordinate was moved (rad or m), numbered as in [`Holding`]; zero where it was held.
    pub displacements: Vec<T>,
    /// By how much each rate was changed (rad/s or m/s).
    pub rate_changes: Vec<T>,
}

/// A motion of a scene that has been assembled.
pub type AssembledOf<S, R, C, P> = Assembled<MotionOf<S, R, C, P>, <S as Geometry>::Scalar>;

/// Conditions of a motion, and how they change with its coordinates.
struct Conditions<T> {
    /// Residuals of the conditions, in place and in velocity.
    residuals: Vec<[T; 2]>,
    /// Changes of velocity for unit rates.
    rows: Vec<Vec<T>>,
}

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// [`assembled`](Self::assembled) with some coordinates and rates held as they are given, while the others are changed as little as
    /// possible (by the sum of squares, rad and m alike), and with a report of what had to move.
    ///
    /// With nothing held it is what `assembled` finds, which measures changes by the inertia of the scene.
    ///
    /// ```
    /// use catena::loading::Unloaded;
    /// use catena::planar::*;
    /// use catena::system::Holding;
    /// let rod = |length| Rod::uniform(length, 1.0);
    /// let four_bar = System::new(Pinned::origin(), (rod(0.5), Pin, rod(1.2), Pin, rod(0.9)), Pinned::at(1.0, 0.0))?;
    /// // The crank stands at 60 degrees and turns at 5 rad/s; of the other two only the way they bend is known.
    /// let guess = four_bar.with_rates(four_bar.at_rest(&[60_f64.to_radians(), 0.3, -2.0])?, &[5.0, 0.0, 0.0])?;
    /// let start = four_bar.assembled_holding(guess, Holding::both(&[0]), &Unloaded)?;
    /// assert_eq!(four_bar.angles(&start.motion)?.body::<0>(), Some(&60_f64.to_radians()));
    /// assert_eq!((start.displacements[0], start.rate_changes[0]), (0.0, 0.0));
    /// println!("coupler and rocker turned by {:?} rad", &start.displacements[1..]);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::ImpossibleHold`] where nothing closes, or no rates do, with what is held, at the place that misses most: from this guess;
    /// [`Fault::OutOfRange`] for a coordinate that there is none; those of [`assembled`](Self::assembled).
    pub fn assembled_holding<L: Loading<S>>(
        &self,
        guess: MotionOf<S, R, C, P>,
        holding: Holding<'_>,
        loads: &L,
    ) -> Result<AssembledOf<S, R, C, P>, Error>
    where
        Self: Runs<L, S, R, C, P>,
    {
        self.fits(&guess)?;
        let freedoms = numbers(&guess.rate).len();
        let [positions, rates] = [Holding::of(holding.positions, freedoms)?, Holding::of(holding.rates, freedoms)?];
        let mut motion = guess.clone();
        if (Self::CLOSED == 0 && !couples::<S, L>()) || holding == Holding::default() {
            motion = self.assembled(motion, loads)?;
        } else {
            self.close_places(&mut motion, &positions, loads)?;
            self.close_rates(&mut motion, &rates, loads)?;
            self.accelerate_held(&mut motion, loads, &mut self.workspace())?;
        }
        let mut displacement = guess.rate.clone();
        motion.position.apart(&guess.position, &mut displacement);
        let changes = numbers(&motion.rate).into_iter().zip(numbers(&guess.rate));
        let rate_changes = changes.map(|(after, before)| after - before).collect();
        Ok(Assembled { motion, displacements: numbers(&displacement), rate_changes })
    }

    /// All conditions: of the tip, of loops, and of joints that are coupled.
    fn conditions<L: Loading<S>>(&self, motion: &MotionOf<S, R, C, P>, loads: &L) -> Conditions<S::Scalar> {
        let residuals = |motion: &MotionOf<S, R, C, P>| {
            let mut residuals = vec![];
            let [place, velocity] = self.residual(motion);
            P::Closures::zip(&place, &velocity, |place, velocity| residuals.push([place, velocity]));
            each_residual(&self.chain, self.root.ground(motion.time), coordinates(motion), |residual| {
                residuals.push(residual)
            });
            let mut apart = S::Scalar::zero();
            loads.each_miss(&motion.position, &motion.rate, &mut |level, _, [missed, _]| match level {
                Level::Place => apart = missed,
                Level::Velocity => residuals.push([apart, missed]),
            });
            residuals
        };
        let mut moving = motion.clone();
        let freedoms = numbers(&motion.rate).len();
        set(&mut moving.rate, core::iter::empty());
        let still = residuals(&moving);
        let mut rows = vec![Vec::with_capacity(freedoms); still.len()];
        for j in 0..freedoms {
            set(&mut moving.rate, unit(freedoms, j));
            for (row, ([_, with], [_, without])) in rows.iter_mut().zip(residuals(&moving).into_iter().zip(&still)) {
                row.push(with - *without);
            }
        }
        Conditions { residuals: residuals(motion), rows }
    }

    /// Moves the coordinates that are not held until residuals are nothing but rounding.
    fn close_places<L: Loading<S>>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        held: &[bool],
        loads: &L,
    ) -> Result<(), Error> {
        let (small, tiny) = Self::tolerances();
        let mut step = motion.rate.clone();
        let mut last = RealOf::<S>::INFINITY;
        for pass in 0..CORRECTIONS {
            let Conditions { residuals, rows } = self.conditions(motion, loads);
            let wanted: Vec<_> = residuals.iter().map(|[place, _]| -*place).collect();
            let change = least_change(rows, &wanted, held);
            set(&mut step, change);
            shorten(&mut step);
            let mut length = RealOf::<S>::zero();
            motion.position.measure(&step, &mut |x, size| {
                length = length.max(x.real().abs() / size.real().max(RealOf::<S>::one()));
            });
            motion.position.displace(&step);
            if pass > 0 && (length <= tiny || (length <= small && length + length >= last)) {
                break;
            }
            last = length;
        }
        let (residual, place) = self.largest_residual(motion, Level::Place);
        if residual <= small {
            let mut still = motion.clone();
            set(&mut still.rate, core::iter::empty()); // rates are not joined yet
            return self.joined(&still, loads, |residual| Fault::ImpossibleHold { what: "coordinates", residual });
        }
        let fault = Fault::ImpossibleHold { what: "coordinates", residual: residual.as_f64() };
        Err(Error::new(fault).at(place).at_time(motion.time.as_f64()))
    }

    /// Changes the rates that are not held until the ends of what is closed move together.
    fn close_rates<L: Loading<S>>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        held: &[bool],
        loads: &L,
    ) -> Result<(), Error> {
        let mut change = motion.rate.clone();
        // They are linear in the rates: the second time is for rounding.
        for _ in 0..2 {
            let Conditions { residuals, rows } = self.conditions(motion, loads);
            let wanted: Vec<_> = residuals.iter().map(|[_, velocity]| -*velocity).collect();
            set(&mut change, least_change(rows, &wanted, held));
            motion.rate.add(&change);
        }
        let mut size = RealOf::<S>::one();
        motion.rate.visit(&mut |x| size = size.max(x.real().abs()));
        let (residual, place) = self.largest_residual(motion, Level::Velocity);
        if residual <= Self::tolerances().0 * size {
            return self.joined(motion, loads, |residual| Fault::ImpossibleHold { what: "rates", residual });
        }
        let fault = Fault::ImpossibleHold { what: "rates", residual: residual.as_f64() };
        Err(Error::new(fault).at(place).at_time(motion.time.as_f64()))
    }
}
