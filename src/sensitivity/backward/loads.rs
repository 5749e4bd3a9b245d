//! Loads on bodies in a stage of a step.

use crate::adjoint::{BodyLaw, Reversed};
use crate::element::{Coordinates, Element, RealOf, Space};
use crate::loading::{Load, Seen as _};
use crate::relation::{Wrench, WrenchOf};
use crate::shape::{PerBody, PerJoint};
use crate::space::FrameOf;
use crate::visit::Visit;
use crate::walks::travel::travel;

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

    /// Finds frames of bodies, and the loads on them.
    pub(super) fn see(&mut self, elements: &E, ground: FrameOf<S>, motion: Coordinates<'_, S, E>, time: RealOf<S>) {
        let visit = Telling { law: self.law, time, body: 0 };
        travel(elements, ground, motion, visit, &mut self.on_bodies, &mut self.in_joints);
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
