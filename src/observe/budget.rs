//! Energy and momentum, added up over bodies and joints.

use crate::element::{Budget, Coordinates, Element, Space, Watch};
use crate::space::{FrameOf, MovingBody, MovingJoint};
use crate::walks::travel::show;

/// Energy and momentum of a motion.
pub(crate) fn budget<S: Space, E: Element<S>>(
    chain: &E,
    ground: FrameOf<S>,
    gravity: S::Vector,
    motion: Coordinates<'_, S, E>,
) -> Budget<S> {
    let mut audit = Audit { gravity, sum: Budget::none() };
    show(chain, ground, motion, &mut audit);
    audit.sum
}

/// Adds up energy and momentum.
struct Audit<S: Space> {
    gravity: S::Vector,
    sum: Budget<S>,
}

impl<S: Space> Watch<S> for Audit<S> {
    fn body(&mut self, body: &S::BodyMotion) {
        self.sum = self.sum + body.budget(self.gravity);
    }
    fn joint(&mut self, joint: &S::JointMotion) {
        let [kinetic, potential] = joint.stored();
        self.sum =
            Budget { kinetic: self.sum.kinetic + kinetic, potential: self.sum.potential + potential, ..self.sum };
    }
}
