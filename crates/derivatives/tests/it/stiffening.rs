//! A law of the user's own that is not linear, and goes backward.

use catena::planar::{SpringLaw, Springs};
use catena::{Fault, Scalar};

/// A spring and a damper that stiffen with the strain u beyond rest: −k (u + u³) − c (1 + u²) u̇.
#[derive(Clone, Copy, Debug)]
pub struct Stiffening<T> {
    pub stiffness: T,
    pub damping: T,
    pub rest: T,
}
catena::lift!(Stiffening { stiffness, damping, rest });

impl<T: Scalar> SpringLaw<T> for Stiffening<T> {
    fn force(&self, position: T, rate: T) -> T {
        let strain = position - self.rest;
        -(self.stiffness * strain + self.damping * rate) * (strain * strain + T::one())
    }
    fn energy(&self, position: T) -> T {
        let square = (position - self.rest) * (position - self.rest);
        self.stiffness * square * (T::literal(0.5) + T::literal(0.25) * square)
    }
    fn pivot(&self, position: T, rate: T, springs: impl Springs<T>) -> T {
        let (strain, two) = (position - self.rest, T::literal(2.0));
        let square = strain * strain;
        let slope = self.stiffness * (T::one() + T::literal(3.0) * square) + two * self.damping * strain * rate;
        springs.pivot(slope, self.damping * (T::one() + square))
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}
