//! The motion of a scene at an instant: the user's value.

#[cfg(feature = "serde")]
mod data;
mod flat;

use crate::lift::Lift;
use crate::mirror::{Mode, Position, Rate};
use crate::relation::{Closures, Open};
use crate::scalar::{Real, Scalar};
use core::fmt::{self, DebugList};
use num_traits::Zero;

/// Time, and positions, rates and accelerations of all joint coordinates, in the shape of their scene.
///
/// It holds no parameters and no workspace: clone it, store it, compare it, differentiate it, hand it back. A step reads one
/// motion and writes another, so a failed step loses nothing.
///
/// # What rates are
///
/// Rates are those of the coordinates that a joint stores. A joint that knows nothing of the body inboard of it stores what its outboard
/// body does, absolutely; one with springs or axes on the inboard body stores what the outboard body does against that. An angular
/// velocity in space is in axes of the outboard body, a velocity in the axes in which its place is measured.
///
/// | joint | coordinates | rates |
/// |---|---|---|
/// | planar `Pin` | angle of the outboard body, absolute | its angular velocity, absolute |
/// | planar `ElasticHinge` | displacement if it has linear springs, relative angle | rates of these |
/// | planar `Slider` | displacement | its rate |
/// | planar root `Free` | place and angle of the first body, absolute | velocity and angular velocity, absolute |
/// | `Ball` | attitude of the outboard body, absolute | angular velocity, absolute |
/// | spatial `ElasticHinge` | displacement if it has linear springs, relative attitude | rate of that, relative angular velocity |
/// | `Revolute`, `Universal`, `Prismatic`, `Cylindrical` | relative angles (rad) and displacements (m) | rates of these |
/// | spatial root `Free` | place and attitude of the first body, absolute | velocity, inertial axes; angular velocity, body axes |
/// | `Weld`, what closes a loop, `Driven` | none | none |
/// | `Coulomb`, `HardStops` | those of its joint | those of its joint |
///
/// Set by what bodies do, whatever their joints store, motions are by [`with_body_orientation`](crate::system::System::with_body_orientation)
/// and [`with_body_spin`](crate::system::System::with_body_spin) (one body, by number or name), by
/// [`at_rest`](crate::system::System::at_rest) or, in space, `at_attitudes`, and `with_body_rates` (all of them); by what joints do
/// against their inboard bodies, by [`with_joint_rates`](crate::system::System::with_joint_rates).
#[derive(Clone)]
pub struct Motion<T: Scalar, P: Position<T>, C: Closures = Open> {
    pub(crate) time: T::Real,
    pub(crate) position: P,
    pub(crate) rate: P::Rate,
    pub(crate) acceleration: P::Rate,
    /// Forces that hold the tip, ON the last body; they belong to the accelerations.
    pub(crate) multipliers: C::Each<T>,
}

impl<T: Scalar, P: Position<T>, C: Closures> Motion<T, P, C> {
    /// Time (s).
    pub fn time(&self) -> T::Real {
        self.time
    }

    /// Sets the time (s).
    #[must_use]
    pub fn at_time(mut self, time: T::Real) -> Self {
        self.set_time(time);
        self
    }

    /// Sets the time (s), also where driven coordinates keep it.
    pub(crate) fn set_time(&mut self, time: T::Real) {
        self.time = time;
        self.position.set_clocks(time);
    }

    /// Positions of the joint coordinates, in the shape of the scene.
    pub fn position(&self) -> &P {
        &self.position
    }

    /// Positions, to be set. The accelerations no longer belong to them until they are found anew: then driven coordinates, which keep a time,
    /// are given that of the motion.
    pub fn position_mut(&mut self) -> &mut P {
        &mut self.position
    }

    /// Rates of the joint coordinates, in the shape of the scene.
    pub fn rate(&self) -> &P::Rate {
        &self.rate
    }

    /// Rates, to be set. The accelerations no longer belong to them until they are found anew, and joints with modes move as these
    /// rates say, whatever they did.
    pub fn rate_mut(&mut self) -> &mut P::Rate {
        self.forget_modes();
        &mut self.rate
    }

    /// Lets what joints with modes do follow from their rates.
    pub(crate) fn forget_modes(&mut self) {
        self.position
            .each_mode(&mut self.rate, &self.acceleration, &mut |mode, _, told| *mode = Mode::forgotten(told.rubs));
    }

    /// Accelerations of the joint coordinates, in the shape of the scene.
    pub fn acceleration(&self) -> &P::Rate {
        &self.acceleration
    }

    /// Accelerations, to be set: the input of inverse dynamics.
    pub fn acceleration_mut(&mut self) -> &mut P::Rate {
        &mut self.acceleration
    }

    /// This motion over another scalar, `number` replacing each coordinate, rate and acceleration: over jets, or in single precision.
    pub fn lift<U: Scalar>(&self, mut number: impl FnMut(T) -> U) -> Motion<U, P::Over, C>
    where
        P: Lift<T, U, Over: Position<U, Rate = <P::Rate as Lift<T, U>>::Over>>,
        P::Rate: Lift<T, U>,
    {
        Motion {
            time: U::Real::of(self.time.as_f64()),
            position: self.position.lift(&mut number),
            rate: self.rate.lift(&mut number),
            acceleration: self.acceleration.lift(&mut number),
            multipliers: C::map(&self.multipliers, &mut number),
        }
    }

    /// Forces that hold the tip, ON the last body, in the order of the conditions it imposes (N, N·m).
    pub fn multipliers(&self) -> &C::Each<T> {
        &self.multipliers
    }

    /// Whether every number of the motion is finite.
    pub fn is_finite(&self) -> bool {
        let mut finite = true;
        self.position.visit(&mut |x| finite &= x.is_finite());
        self.rate.visit(&mut |x| finite &= x.is_finite());
        self.acceleration.visit(&mut |x| finite &= x.is_finite());
        C::map(&self.multipliers, |x| finite &= x.is_finite());
        finite
    }

    /// Copies time, positions and rates, without accelerations; allocates nothing.
    pub(crate) fn copy_state(&mut self, from: &Self) {
        self.time = from.time;
        self.position.drift_0(&from.position, (T::Real::zero(), &from.rate));
        self.rate.set(&from.rate);
    }

    /// Whether this is the motion at a time, of these positions and rates. Dual numbers with other derivative parts are other numbers.
    pub(crate) fn has_state(&self, time: T::Real, position: &P, rate: &P::Rate) -> bool {
        // All are compared, whatever comes of the first: a loop without a way out is put in lanes.
        let mut same = self.time == time;
        let mut test = |a: T, b: T| {
            same &= a.is_identical(b);
            true
        };
        let fits = self.position.all(position, &mut test) && self.rate.all(rate, &mut test);
        fits && same
    }

    /// Whether these are the accelerations of this motion, as numbers are compared there.
    pub(crate) fn has_acceleration(&self, acceleration: &P::Rate) -> bool {
        let mut same = true;
        let fits = self.acceleration.all(acceleration, &mut |a, b| {
            same &= a.is_identical(b);
            true
        });
        fits && same
    }

    /// Whether `other` moves the same coordinates (only vectors of elements can differ in number).
    pub fn fits(&self, other: &Self) -> bool {
        self.all(other, &mut |_, _| true)
    }

    fn all(&self, other: &Self, test: &mut impl FnMut(T, T) -> bool) -> bool {
        self.position.all(&other.position, test)
            && self.rate.all(&other.rate, test)
            && self.acceleration.all(&other.acceleration, test)
    }
}

impl<T: Scalar, P: Position<T> + Copy, C: Closures> Copy for Motion<T, P, C> where P::Rate: Copy {}

impl<T: Scalar, P: Position<T>, C: Closures> PartialEq for Motion<T, P, C> {
    /// Compares as the scalar does: dual numbers by their real part only.
    fn eq(&self, other: &Self) -> bool {
        let mut held = true;
        C::zip(&self.multipliers, &other.multipliers, |a, b| held &= a == b);
        self.time == other.time && held && self.all(other, &mut |a, b| a == b)
    }
}

impl<T: Scalar, P: Position<T>, C: Closures> fmt::Debug for Motion<T, P, C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        struct List<F>(F);
        impl<F: Fn(&mut DebugList<'_, '_>)> fmt::Debug for List<F> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let mut list = f.debug_list();
                (self.0)(&mut list);
                list.finish()
            }
        }
        f.debug_struct("Motion")
            .field("time", &self.time)
            .field("position", &List(|list: &mut DebugList<'_, '_>| self.position.visit(&mut |x| _ = list.entry(&x))))
            .field("rate", &List(|list: &mut DebugList<'_, '_>| self.rate.visit(&mut |x| _ = list.entry(&x))))
            .field(
                "acceleration",
                &List(|list: &mut DebugList<'_, '_>| self.acceleration.visit(&mut |x| _ = list.entry(&x))),
            )
            .field(
                "multipliers",
                &List(|list: &mut DebugList<'_, '_>| _ = C::map(&self.multipliers, |x| _ = list.entry(&x))),
            )
            .finish()
    }
}
