//! The full relation, and how it moves along a body.

use super::{Additive, Angular, Closures, Cuts, Geometry, Open, Relation, Symmetric, VectorSpace, Wrench, WrenchOf};

/// A full relation: q = L a + K α + e_q, −m = Kᵀ a + H α + e_m, and columns for closure forces.
#[derive(Clone, Copy)]
pub struct Full<G: Geometry, C: Closures = Open> {
    /// L (kg).
    pub linear: G::Mass,
    /// K, the coupling of force and angular acceleration (kg·m).
    pub coupling: G::Coupling,
    /// H (kg·m²).
    pub angular: G::Inertia,
    /// e_q (N).
    pub force: G::Vector,
    /// e_m (N·m), of the torque on the outboard part.
    pub torque: G::Angular,
    /// Columns of closure forces.
    pub cuts: Cuts<WrenchOf<G>, G::Scalar, C>,
}

impl<G: Geometry> Full<G> {
    /// Nothing that has mass.
    #[cfg_attr(optimised, inline(always))]
    pub fn massless() -> Self {
        Self {
            linear: G::Mass::null(),
            coupling: G::Coupling::null(),
            angular: G::Inertia::null(),
            force: G::Vector::null(),
            torque: G::Angular::null(),
            cuts: Cuts::none(),
        }
    }

    /// This relation with closure forces.
    #[inline(always)]
    pub fn cut<C: Closures>(self, cuts: Cuts<WrenchOf<G>, G::Scalar, C>) -> Full<G, C> {
        let Self { linear, coupling, angular, force, torque, .. } = self;
        Full { linear, coupling, angular, force, torque, cuts }
    }
}

impl<G: Geometry, C: Closures> Full<G, C> {
    /// Where the station has an angular acceleration besides that of the station that takes its place.
    #[cfg_attr(optimised, inline(always))]
    pub fn turning(self, angular: G::Angular) -> Self {
        Self {
            force: G::coupled_onto(&self.coupling, angular, self.force),
            torque: self.angular.apply_onto(angular, self.torque),
            cuts: self.cuts.turned(|w| w, |gap, w| gap - G::Angular::dot(w.torque, angular)),
            ..self
        }
    }
}

impl<G: Geometry, C: Closures> Relation<G> for Full<G, C> {
    type Closures = C;
    type WithMass = Self;

    #[inline(always)]
    fn with_mass(self, mass: G::Scalar) -> Self {
        Self { linear: self.linear.plus_diagonal(mass), ..self }
    }

    #[cfg_attr(optimised, inline(always))]
    fn carried(self, d: G::Vector, centripetal: G::Vector) -> Self {
        let k = self.coupling;
        let coupling = G::levered_onto(self.linear, d, k);
        let angular = G::steiner(d, &k, &coupling, self.angular);
        let force = self.linear.apply_onto(centripetal, self.force);
        Self {
            linear: self.linear,
            coupling,
            angular,
            force,
            torque: G::Angular::moment_onto(d, force, G::transposed_onto(&k, centripetal, self.torque)),
            cuts: self.cuts.turned(
                |w| Wrench { force: w.force, torque: G::Angular::moment_onto(d, w.force, w.torque) },
                |gap, w| VectorSpace::minus_dot(gap, w.force, centripetal),
            ),
        }
    }
}
