//! Dry friction in a joint between hard stops.

use super::friction::Friction;
use super::range::Range;
use super::{Guard, Guarded};
use crate::error::Fault;
use crate::lift::lift;
use crate::mirror::{Mode, RubsBetweenStops};
use crate::relation::Absent;
use crate::scalar::{Real, Scalar};

/// A joint with dry friction between hard stops: [`Coulomb`] and [`HardStops`] in one, as joints of robots are.
///
/// Such a joint sticks, slips, and rests against a stop, where friction holds it as well: it leaves only where that is overcome. A shock goes
/// over friction. What both say of runs, steps and refusals holds.
///
/// ```
/// use catena::planar::*;
/// // A drawer of 2 kg that is thrown shut at 2 m/s from 0.3 m, rubs by 4 N, and gives back half its speed at the end.
/// let rail = Coulomb::new(Slider::along(0.0), 4.0).between([0.0, 0.4]).rebounding(0.5);
/// let scene = System::new(Clamped::origin(), (rail, RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2])), Free)?;
/// let mut start = scene.with_rates(scene.motion(), &[-2.0])?;
/// start.set_coordinates(&[0.3])?;
/// let end = scene.simulation(Dop853::tolerance(1e-10)).run(start, 2.0, |_| ())?.motion;
/// let arrives = 2.0 * 2.0 - 2.0 * 2.0 * 0.3; // (m²/s²), slowed down by 2 m/s²
/// let stays = 0.25 * arrives / (2.0 * 2.0_f64);
/// assert!((end.coordinates()[0] - stays).abs() < 1e-12);
/// assert_eq!(end.rates(), [0.0]);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// [`Coulomb`]: crate::planar::Coulomb
/// [`HardStops`]: crate::planar::HardStops
pub type BoundedCoulomb<J, T, L = Absent> = Guarded<J, Bounded<T>, L>;

/// Friction, and the range it is in.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Bounded<T> {
    friction: Friction<T>,
    range: Range<T>,
}

impl<J, T: Scalar, L> Guarded<J, Friction<T>, L> {
    /// Between stops (rad, m) that give nothing back.
    #[must_use]
    pub fn between(self, range: [T; 2]) -> BoundedCoulomb<J, T, L> {
        let Self { joint, guard: friction, law } = self;
        Guarded { joint, guard: Bounded { friction, range: Range::of(range) }, law }
    }
}

impl<J, T: Scalar, L> BoundedCoulomb<J, T, L> {
    /// Whose stops give back a share of the rate, from 0 to 1: the coefficient of restitution.
    #[must_use]
    pub fn rebounding(self, restitution: T) -> Self {
        let Bounded { friction, range } = self.guard;
        Self { guard: Bounded { friction, range: range.giving_back(restitution) }, ..self }
    }
}

lift!(Bounded { friction, range });

impl<T: Scalar> Guard<T> for Bounded<T> {
    const KIND: &'static str = "BoundedCoulomb";
    type Guarding = RubsBetweenStops;

    fn resists(&self, mode: Mode) -> T {
        self.friction.resists(mode)
    }
    /// Of a size that shows beside other forces, however small friction is.
    fn trial(&self) -> T {
        T::one() + self.friction.trial()
    }
    fn free(&self, coordinate: T) -> [T; 3] {
        self.range.free(coordinate)
    }
    /// At a stop friction holds as well; what halts beyond a stop is thrown back.
    fn held(&self, mode: Mode, told: [T; 3], [free, tried]: [T; 2]) -> [T; 3] {
        let (answer, breaking) = (free / (free - tried) * self.trial(), self.friction.trial());
        let touching = T::Real::of(1.0) + Mode::touch();
        match mode {
            Mode::Lands | Mode::Rebounds => [told[0], answer, told[2]],
            Mode::Halts if told[0].real().abs() > touching => [-told[0] - told[0], answer, told[2]],
            _ => match mode.stop() {
                Some(side) => {
                    let outward = (answer * T::literal(side) - breaking) * (tried - free) / self.trial();
                    [outward, answer, T::zero()]
                }
                None => [answer / breaking, answer, T::zero()],
            },
        }
    }
    fn check(&self) -> Result<(), Fault> {
        self.friction.check()?;
        self.range.check()
    }
}
