//! Bodies whose inertia may be wrong.

use crate::element::{Coordinates, Element, Space, Watch};
use crate::error::Error;
use crate::space::{FrameOf, MovingBody};
use crate::walks::travel::show;

/// Calls `report` with what may be wrong with the inertia of a body, and at which station.
pub(crate) fn doubts<S: Space, E: Element<S>>(
    chain: &E,
    ground: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    report: impl FnMut(Error),
) {
    let mut doubts = Doubts { entries: 0, report };
    show(chain, ground, motion, &mut doubts);
}

/// Shows bodies whose inertia may be wrong.
struct Doubts<F> {
    /// Bodies and joints met; the first is the root's joint.
    entries: usize,
    report: F,
}

impl<S: Space, F: FnMut(Error)> Watch<S> for Doubts<F> {
    fn body(&mut self, body: &S::BodyMotion) {
        self.entries += 1;
        if let Some(doubt) = body.doubt() {
            (self.report)(Error::new(doubt).at_station(self.entries - 2));
        }
    }
    fn joint(&mut self, _: &S::JointMotion) {
        self.entries += 1;
    }
}
