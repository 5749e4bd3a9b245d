//! What costs hang on at a change of mode.

use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::relation::Closures;
use crate::scalar::{Jet, Real, Scalar};
use crate::sensitivity::Costate;
use crate::simulate::anew::Changed;
use alloc::vec::Vec;

/// Costates at a change of mode, of positions and then of rates.
pub(super) struct AtChange<T> {
    /// Of the motion past it, at a fixed time.
    pub(super) later: Vec<T>,
    /// Of the motions just before and just after, at the time of the change, and of that.
    here: [Vec<T>; 2],
    time: T,
}

impl<T: Scalar> AtChange<T> {
    pub(super) fn of<V: Rate<T>>(later: &Costate<V, T>, here: [&Costate<V, T>; 2]) -> Self {
        let [later, before, after] = [later, here[0], here[1]].map(|all| costates(&all.position, &all.rate));
        Self { later, here: [before, after], time: here[0].time + here[1].time }
    }

    /// These times the derivatives of the motions, by each seed.
    ///
    /// # Errors
    /// [`Fault::Unsupported`] for costs that hang on a time that is not known.
    pub(super) fn contracted<Q: Position<Jet<T, K>>, D: Closures, const K: usize>(
        &self,
        found: &Changed<Motion<Jet<T, K>, Q, D>, Jet<T, K>>,
    ) -> Result<[T; K], Error> {
        let mut sum = contracted(&self.later, &found.next);
        let mut add = |more: [T; K]| sum.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
        // A time that is not known does not matter where nobody asks for it.
        for (costates, motion) in self.here.iter().zip([&found.before, &found.after]) {
            if costates.iter().any(|x| !x.is_zero()) {
                add(contracted(costates, motion));
            }
        }
        if !self.time.is_zero() {
            add(found.delay.eps.map(|slope| self.time * slope));
        }
        let what = "the gradient of a cost where a joint breaks away that was hardly, or not steadily, pulled before";
        let refused = Error::new(Fault::Unsupported { what }).at_time(found.next.time.as_f64());
        if sum.iter().all(|x| x.is_finite()) { Ok(sum) } else { Err(refused) }
    }
}

/// Costates of positions, and then of rates, as a list.
fn costates<T: Scalar, V: Rate<T>>(position: &V, rate: &V) -> Vec<T> {
    let mut list = Vec::new();
    [position, rate].into_iter().for_each(|costate| costate.visit(&mut |x| list.push(x)));
    list
}

/// Costates times the derivatives of a motion, by each seed.
fn contracted<T: Scalar, Q: Position<Jet<T, K>>, D: Closures, const K: usize>(
    after: &[T],
    found: &Motion<Jet<T, K>, Q, D>,
) -> [T; K] {
    let (mut still, mut displacement) = (found.position.clone(), found.rate.clone());
    still.replace(&mut |x| Jet::of(x.re));
    found.position.apart(&still, &mut displacement);
    let mut sum = [T::zero(); K];
    for (costate, slopes) in after.iter().zip(costates(&displacement, &found.rate)) {
        sum.iter_mut().zip(slopes.eps).for_each(|(sum, slope)| *sum += *costate * slope);
    }
    sum
}
