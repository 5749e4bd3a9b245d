//! Residuals of loops: by how much their ends miss each other.

use crate::element::{Closed, Coordinates, Element, Level, RealOf, Space, Watch};
use crate::mirror::Rate;
use crate::scalar::Scalar;
use crate::space::FrameOf;
use crate::walks::travel::show;
use num_traits::Zero;

/// The largest residual of a loop (m, rad, or these a second), and the station of the joint that should close it.
pub(crate) fn loop_residual<S: Space, E: Element<S>>(
    chain: &E,
    ground: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    level: Level,
) -> (RealOf<S>, usize) {
    let mut open = OpenLoop::<S> { level, entries: 0, worst: (Zero::zero(), 0) };
    show(chain, ground, motion, &mut open);
    open.worst
}

/// Calls `note` with the residual of each condition that closes a loop: in place (m, rad) and in velocity.
#[cfg(feature = "alloc")] // for statics and assembly
pub(crate) fn each_residual<S: Space, E: Element<S>>(
    chain: &E,
    ground: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    note: impl FnMut([S::Scalar; 2]),
) {
    show(chain, ground, motion, &mut Residuals(note));
}

/// Shows the residuals of loops.
#[cfg(feature = "alloc")]
struct Residuals<F>(F);

#[cfg(feature = "alloc")]
impl<S: Space, F: FnMut([S::Scalar; 2])> Watch<S> for Residuals<F> {
    fn closing(&mut self, closed: &Closed<S>) {
        let [place, velocity] = &closed.residual;
        let mut count = 0;
        place.all(velocity, &mut |place, velocity| {
            if count < closed.conditions {
                (self.0)([place, velocity]);
            }
            count += 1;
            true
        });
    }
}

/// Keeps the loop with the largest residual.
struct OpenLoop<S: Space> {
    level: Level,
    /// Bodies and joints met; the first is the root's joint.
    entries: usize,
    worst: (RealOf<S>, usize),
}

impl<S: Space> Watch<S> for OpenLoop<S> {
    fn body(&mut self, _: &S::BodyMotion) {
        self.entries += 1;
    }
    fn joint(&mut self, _: &S::JointMotion) {
        self.entries += 1;
    }
    fn closing(&mut self, closed: &Closed<S>) {
        self.entries += 1;
        let [place, velocity] = &closed.residual;
        let residual = if self.level == Level::Place { place } else { velocity };
        residual.visit(&mut |x| {
            if x.real().abs() > self.worst.0 {
                self.worst = (x.real().abs(), self.entries - 2);
            }
        });
    }
}
