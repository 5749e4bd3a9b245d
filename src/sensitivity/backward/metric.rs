//! What springs and dampers do in the matrix by which an implicit rule closes what is held.

use super::again::paired;
use crate::adjoint::Reversed;
use crate::element::{Element, RealOf};
use crate::mirror::{Position, Rate};
use crate::shape::{PerJoint, Positions, Takes};
use crate::walks::strain::Strain;
use num_traits::One;

/// Where laws that are not linear have been read, and costates of that.
type Led<'s, E, P, V> = ((&'s P, &'s V), (&'s mut E, &'s mut E));

/// What the springs and dampers of W = M + B K + Γ C do in −w · W x: adds to costates of their numbers, and to those of where laws that are not
/// linear have been read; gives that of the size of the step, by which B and Γ have derivatives.
#[allow(clippy::type_complexity)] // two in one argument
pub(super) fn metric<S: Reversed, E: Element<S> + Takes<S, Strain<S::Scalar>>>(
    elements: &E,
    [[in_position, in_rate], by_size]: [[RealOf<S>; 2]; 2],
    (correction, w): (&E::Rate, &E::Rate),
    zero: &E::Rate,
    sums: &mut E::Store<PerJoint<S::OfJoint>>,
    (of_position, of_rate): (&mut E::Rate, &mut E::Rate),
    (led, of_led): Led<'_, E::Rate, E::Position, E::Rate>,
) -> S::Scalar {
    let (mut place, mut rate, mut against) = (elements.store::<Positions>(()), zero.clone(), w.clone());
    let (mut change, mut of_change) = (zero.clone(), zero.clone());
    let mut walk = Strain::by([[in_position, in_rate], by_size]);
    of_position.set(zero);
    of_rate.set(zero);
    against.replace(&mut |x| -x);
    // Laws are linear: their difference from what they do at rest. Of others, force + K̂ × change, the difference from what they do unchanged.
    let of_read = (&mut *of_led.0, &mut *of_led.1, &mut of_change);
    let stores =
        (&place, &rate, &against, &mut *sums, &mut *of_position, &mut *of_rate, (led.0, led.1, &change), of_read);
    elements.take(&mut walk, (), stores);
    let from = place.clone();
    place.drift_0(&from, (in_position, correction));
    rate.mix_1(zero, (in_rate, correction));
    change.mix_1(zero, (-RealOf::<S>::one(), correction));
    of_position.set(zero);
    of_rate.set(zero);
    let of_read = (of_led.0, of_led.1, &mut of_change);
    let stores = (&place, &rate, w, sums, &mut *of_position, &mut *of_rate, (led.0, led.1, &change), of_read);
    elements.take(&mut walk, (), stores);
    paired::<S, E>(by_size, (of_position, of_rate), correction) + walk.of_size
}
