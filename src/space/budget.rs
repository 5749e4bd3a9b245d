//! Energy and momentum.

use super::Space;
use crate::relation::Additive;
use core::ops::Add;

/// Energy and momentum of bodies.
#[derive(Clone, Copy, Debug)]
pub struct Budget<S: Space> {
    /// Kinetic energy (J).
    pub kinetic: S::Scalar,
    /// Potential energy of springs and in uniform gravity, zero at the origin (J).
    pub potential: S::Scalar,
    /// Linear momentum (kg·m/s).
    pub momentum: S::Vector,
    /// Angular momentum about the origin (kg·m²/s).
    pub angular_momentum: S::Angular,
}

impl<S: Space> Budget<S> {
    /// The budget of nothing.
    pub fn none() -> Self {
        let (kinetic, potential) = (Additive::null(), Additive::null());
        Self { kinetic, potential, momentum: Additive::null(), angular_momentum: Additive::null() }
    }

    /// Mechanical energy (J).
    pub fn energy(&self) -> S::Scalar {
        self.kinetic + self.potential
    }
}

impl<S: Space> Add for Budget<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            kinetic: self.kinetic + other.kinetic,
            potential: self.potential + other.potential,
            momentum: self.momentum + other.momentum,
            angular_momentum: self.angular_momentum + other.angular_momentum,
        }
    }
}
