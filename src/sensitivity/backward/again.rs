//! Room for the sweeps of a stage of an implicit rule, and where their accelerations lead.

use super::apart::Apart;
use super::record::Stage;
use crate::adjoint::{BodyLaw, Reversed, Ties};
use crate::element::{Element, RealOf};
use crate::ends::Tip;
use crate::mirror::{Position, Rate};
use crate::relation::Closures;
use crate::scalar::Scalar;
use crate::shape::Positions;
use crate::system::Elements;
use num_traits::Zero;

/// Room for the sweeps of a stage.
pub(super) struct Again<S: Reversed, E: Element<S>, X: Closures, Y: Ties<S>> {
    /// Positions and rates without the acceleration sought, and where laws are read.
    pub(super) free: (E::Position, E::Rate),
    pub(super) read: (E::Position, E::Rate),
    /// A sweep, and what it has found.
    pub(super) stage: Stage<S, E, X, Y>,
    pub(super) slope: E::Rate,
    /// Costates of `free`; of the acceleration from which the geometry of the next stage set out; of geometries that are no more than where
    /// accelerations lead, or of the one that was predicted.
    pub(super) of_free: (E::Rate, E::Rate),
    pub(super) of_before: E::Rate,
    pub(super) of_geometry: (E::Rate, E::Rate),
    /// The acceleration that led to where the last sweep has read laws that are not linear, less that which it found.
    pub(super) led: E::Rate,
    /// Costates of what they have read: positions, rates and that acceleration.
    pub(super) of_read: (E::Rate, E::Rate),
    pub(super) of_led: E::Rate,
}

impl<S: Reversed, E: Element<S>, X: Closures, Y: Ties<S>> Again<S, E, X, Y> {
    pub(super) fn new(elements: &E, zero: &E::Rate) -> Self {
        let motion = (elements.store::<Positions>(()), zero.clone());
        Self {
            free: motion.clone(),
            read: motion,
            stage: Stage::new(elements, zero),
            slope: zero.clone(),
            of_free: (zero.clone(), zero.clone()),
            of_before: zero.clone(),
            of_geometry: (zero.clone(), zero.clone()),
            led: zero.clone(),
            of_read: (zero.clone(), zero.clone()),
            of_led: zero.clone(),
        }
    }
}

/// The room of a scene.
pub(super) type AgainOf<S, R, C, P, L> =
    Apart<Again<S, Elements<S, R, C>, <P as Tip<S>>::Closures, <L as BodyLaw<S>>::Ties>>;

/// Where accelerations lead.
pub(super) fn follow<S: Reversed, E: Element<S>>(
    (position, rate): (&E::Position, &E::Rate),
    [of_position, of_rate]: [RealOf<S>; 2],
    acceleration: &E::Rate,
    zero: &E::Rate,
    into: (&mut E::Position, &mut E::Rate),
) {
    into.0.drift_1(position, (RealOf::<S>::zero(), zero), (of_position, acceleration));
    into.1.mix_1(rate, (of_rate, acceleration));
}

/// From the costate of a position to that of the step that led there, which it becomes, and to that of where this one began, to which it adds.
pub(super) fn unfollow<T: Scalar, P: Position<T>>(
    (to, from): (&P, &P),
    (zero, room): (&P::Rate, &mut P::Rate),
    of_position: &mut P::Rate,
    of_from: &mut P::Rate,
) {
    room.set(zero);
    to.transposed_step(from, (zero, zero), zero, (of_position, room), of_from);
}

/// Σ of costates of positions and rates, times an acceleration with a weight in each.
pub(super) fn paired<S: Reversed, E: Element<S>>(
    [in_position, in_rate]: [RealOf<S>; 2],
    (of_position, of_rate): (&E::Rate, &E::Rate),
    acceleration: &E::Rate,
) -> S::Scalar {
    let mut sum = S::Scalar::zero();
    for (costate, factor) in [(of_position, in_position), (of_rate, in_rate)] {
        costate.all(acceleration, &mut |costate, acceleration| {
            sum += (costate * acceleration).scale(factor);
            true
        });
    }
    sum
}
