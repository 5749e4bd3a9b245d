//! Parameters that make no mechanics, and where.

use crate::error::{Error, Fault};
use crate::shape::{AtBody, AtClosing, AtJoint, Body, Closing, Joint, Outward, Shape, Walk, alike};
use crate::space::Space;

/// Rejects parameters that make no mechanics; stations count from 0, the inboard end of the chain.
///
/// # Errors
/// What is wrong with the first body or joint that is, and its station.
pub fn check<S: Space, E: Shape<S>>(chain: &E) -> Result<(), Error> {
    let mut check = Check { station: 0, outcome: Ok(()) };
    chain.outward(&mut check, (), ());
    check.outcome
}

/// What has been found so far, and the station met next.
struct Check {
    station: usize,
    outcome: Result<(), Error>,
}

impl Check {
    fn note(&mut self, check: impl FnOnce() -> Result<(), Fault>) {
        if self.outcome.is_ok() {
            self.outcome = check().map_err(|fault| Error::new(fault).at_station(self.station));
        }
        self.station += 1;
    }
}

impl<S: Space> Walk<S> for Check {
    type Carried = ();
    type Stores = ();
}

impl<S: Space> Outward<S> for Check {
    alike!();

    fn body<B: Body<S>>(&mut self, body: &B, (): (), _: AtBody<'_, S, Self, B>) {
        self.note(|| body.check());
    }
    fn joint<J: Joint<S>>(&mut self, joint: &J, (): (), _: AtJoint<'_, S, Self, J>) {
        self.note(|| joint.check());
    }
    fn closing<K: Closing<S>>(&mut self, closing: &K, _: [(); 2], _: AtClosing<'_, S, Self, K>) {
        self.note(|| closing.check());
    }
}
