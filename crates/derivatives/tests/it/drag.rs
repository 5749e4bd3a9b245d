//! A load that goes backward.

use catena::loading::LoadLaw;
use catena::planar::{BodyMotion, Wrench};
use catena::scalar::Scalar;

/// Drag in proportion to the velocity of the outboard end (N·s/m).
#[derive(Clone, Copy)]
pub struct Drag<T> {
    pub drag: T,
}
catena::lift!(Drag { drag });
impl<T: Scalar> LoadLaw<BodyMotion<T>> for Drag<T> {
    type Value = Wrench<T>;
    fn at(&self, _: T::Real, _: usize, motion: &BodyMotion<T>) -> Wrench<T> {
        let force = motion.outboard().velocity * -self.drag;
        Wrench { force, torque: motion.arm.perp(&force) }
    }
}
