//! Loads on bodies in a stage of a step.

use crate::adjoint::{BodyLaw, Reversed};
use crate::element::{Coordinates, Element, RealOf, Space};
use crate::loading::{Load, Seen as _};
use crate::mirror::Rate;
use crate::relation::{Wrench, WrenchOf};
use crate::scalar::Scalar;
use crate::shape::{PerBody, PerJoint};
use crate::space::FrameOf;
use crate::visit::{Visit, Watch};
use crate::walks::travel::{show, travel};

/// A law of loads, and what it was last told.
pub(super) struct Seen<S: Space, E: Element<S>, L> {
    pub(super) law: L,
    /// Frames of bodies and the loads on them.
    #[allow(clippy::type_complexity)] // two in one entry
    pub(super) on_bodies: E::Store<PerBody<(FrameOf<S>, WrenchOf<S>)>>,
    /// What a visitor keeps of joints.
    in_joints: E::Store<PerJoint<()>>,
}

impl<S: Reversed, E: Element<S>, L: BodyLaw<S>> Seen<S, E, L> {
    pub(super) fn new(elements: &E, law: L, ground: FrameOf<S>) -> Self {
        let on_bodies = elements.store::<PerBody<_>>((ground, Wrench::none()));
        Self { law, on_bodies, in_joints: elements.store::<PerJoint<_>>(()) }
    }

    /// Finds frames of bodies, and the loads on them; gives the frame of the tip.
    pub(super) fn see(
        &mut self,
        elements: &E,
        ground: FrameOf<S>,
        motion: Coordinates<'_, S, E>,
        time: RealOf<S>,
    ) -> FrameOf<S> {
        let visit = Telling { law: self.law, time, body: 0 };
        travel(elements, ground, motion, visit, &mut self.on_bodies, &mut self.in_joints)
    }
}

/// Whether a law gives other loads for one motion at other times: its gradient lacks what these change.
pub(super) fn depend_on_time<S: Reversed, E: Element<S>, L: BodyLaw<S>>(
    law: L,
    elements: &E,
    ground: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    times: &[RealOf<S>],
) -> bool {
    let mut compared = Compared { law, times, body: 0, differ: false };
    show(elements, ground, motion, &mut compared);
    compared.differ
}

/// Compares what a law gives at several times.
struct Compared<'t, L, R> {
    law: L,
    times: &'t [R],
    body: usize,
    differ: bool,
}

impl<S: Reversed, L: BodyLaw<S>> Watch<S> for Compared<'_, L, RealOf<S>> {
    fn body(&mut self, motion: &S::BodyMotion) {
        let at = |time: &RealOf<S>| S::numbers(self.law.at(*time, self.body, &motion.unaccelerated()).wrench());
        for pair in self.times.windows(2) {
            at(&pair[0]).all(&at(&pair[1]), &mut |one, other| {
                self.differ |= one.real() != other.real();
                true
            });
        }
        self.body += 1;
    }
}

/// Tells the law of each body.
struct Telling<S: Space, L> {
    law: L,
    time: RealOf<S>,
    body: usize,
}

impl<S: Reversed, L: BodyLaw<S>> Visit<S> for Telling<S, L> {
    type OnBody = (FrameOf<S>, WrenchOf<S>);
    type InJoint = ();

    fn body(&mut self, motion: &S::BodyMotion) -> (FrameOf<S>, WrenchOf<S>) {
        self.body += 1;
        (S::inboard(motion), self.law.at(self.time, self.body - 1, &motion.unaccelerated()).wrench())
    }
    fn joint(&mut self, _: &S::JointMotion) {}
}
