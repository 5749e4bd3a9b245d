//! Which of its motions a run under way shows, to functions and to its observer.

use super::drive::Running;
use super::now::{Find, settled};
use super::{EventFunction, Now};
use crate::element::{Element, Loading, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::scalar::{Real, Scalar};
use crate::stepper::Stepper;
use crate::system::{Runs, System};
use core::cell::OnceCell;

/// One of the motions of a run under way.
#[derive(Clone, Copy)]
pub(super) enum Shown {
    Past,
    Next,
    Between,
}

impl Shown {
    fn of<'m, M>(self, past: &'m M, next: &'m M, between: &'m M) -> &'m M {
        match self {
            Self::Past => past,
            Self::Next => next,
            Self::Between => between,
        }
    }
}

impl<'a, S, R, C, P, L, M, E, K, O> Running<'a, S, R, C, P, L, M, E, K, O>
where
    S: Space,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    L: Loading<S>,
    System<S, R, C, P>: Runs<L, S, R, C, P>,
    K: Stepper<&'a System<S, R, C, P>, L>,
    E: for<'n> EventFunction<Now<'n, S, R, C, P, L>, S::Scalar>,
    O: FnMut(&Now<'_, S, R, C, P, L>),
{
    /// How readings find accelerations, if the method leaves others.
    const FIND: Option<Find<S, R, C, P, L>> = if K::SETTLED { None } else { Some(settled) };

    /// The value of the event function, if there is one.
    ///
    /// # Errors
    /// [`Fault::NotFinite`] where it is not a number, whose sign says nothing.
    pub(super) fn value(&mut self, which: Shown) -> Result<Option<f64>, Error> {
        let value =
            self.seen(which, false, |functions, _, now| functions.value(now)).map(|value| value.real().as_f64());
        value.map(|value| self.a_number(which, value, "value of the event function")).transpose()
    }

    /// This value of a function of a motion.
    ///
    /// # Errors
    /// [`Fault::NotFinite`] where it is not a number, whose sign says nothing.
    pub(super) fn a_number(&self, which: Shown, value: f64, parameter: &'static str) -> Result<f64, Error> {
        let time = which.of(&self.past, &self.next, &self.between).time.as_f64();
        if value.is_nan() { Err(Error::new(Fault::NotFinite { parameter }).at_time(time)) } else { Ok(value) }
    }

    pub(super) fn show(&mut self, which: Shown, event: bool) {
        self.seen(which, event, |_, observe, now| observe(now));
    }

    /// Lets functions or the observer see one of the motions.
    pub(super) fn seen<X>(
        &mut self,
        which: Shown,
        event: bool,
        see: impl FnOnce(&mut E, &mut O, &Now<'_, S, R, C, P, L>) -> X,
    ) -> X {
        let Self { plan, past, next, between, observe, .. } = self;
        let stepped = which.of(past, next, between);
        let (find, found) = (Self::FIND, OnceCell::new());
        see(&mut plan.event, observe, &Now { system: plan.system, stepped, loads: plan.loads, event, find, found })
    }
}
