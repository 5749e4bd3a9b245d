//! The acceleration of a joint with modes that has none of its own.

use super::{Guard, Guarded};
use crate::element::Springs;
use crate::mirror::Mode;
use crate::relation::Absent;
use crate::scalar::Scalar;

impl<J, G, L> Guarded<J, G, L> {
    /// The acceleration of a joint that has none of its own, and what is told of it meanwhile. Within a step h it goes by h² for each unit of
    /// that, and its rate by h.
    pub(super) fn given<T: Scalar>(
        &self,
        mode: Mode,
        (coordinate, rate): (T, T),
        springs: impl Springs<T>,
    ) -> (T, [T; 3])
    where
        G: Guard<T>,
    {
        let second = match mode {
            Mode::Lands | Mode::Rebounds => {
                let told = self.guard.free(coordinate);
                let [_, restitution, apart] = told;
                let rebounds = -(T::one() + restitution) * rate / springs.pivot(Absent, T::one());
                let lands = apart / springs.pivot(T::one(), Absent);
                return (if mode == Mode::Lands { lands } else { rebounds }, told);
            }
            Mode::Halts => {
                let second = -rate / springs.pivot(Absent, T::one());
                return (second, self.guard.free(coordinate + second * springs.pivot(T::one(), Absent)));
            }
            Mode::Struck => T::one(),
            _ => T::zero(),
        };
        (second, [T::zero(); 3])
    }

    /// What rubs against the way of a joint whose acceleration is given by its stop.
    pub(super) fn on_the_way<T: Scalar>(&self, mode: Mode, rate: T, second: T, springs: impl Springs<T>) -> T
    where
        G: Guard<T>,
    {
        let after = || rate + second * springs.pivot(Absent, T::one());
        if matches!(mode, Mode::Lands | Mode::Rebounds) { self.guard.resists(Mode::of(after())) } else { T::zero() }
    }
}
