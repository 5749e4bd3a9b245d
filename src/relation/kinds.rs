//! The relations, from none to the full one, and what a body does with any of them.

use super::{
    Absent, Additive, Angular, Closures, Cuts, Geometry, Open, Promote, Symmetric, Term, VectorSpace, Wrench, WrenchOf,
};
use crate::scalar::Scalar;

/// Nothing outboard: F = 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Empty;

/// A point mass outboard: q = m a.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lump<T> {
    /// Mass (kg).
    pub mass: T,
}

/// A pin or ball outboard: q = S a + e + W λ, and the moment is the torque M that acts in it, if there is one.
#[derive(Clone, Copy)]
pub struct Point<G: Geometry, M = Absent, C: Closures = Open> {
    /// S (kg).
    pub mass: G::Mass,
    /// e (N).
    pub offset: G::Vector,
    /// Torque on the outboard part (N·m).
    pub torque: M,
    /// Columns of closure forces.
    pub cuts: Cuts<G::Vector, G::Scalar, C>,
}

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

/// What a body can do with the relation it meets, whatever that is.
#[diagnostic::on_unimplemented(
    message = "an element of inertial axes meets `{Self}`, which is none of their relations",
    label = "what is outboard of this is not in inertial axes",
    note = "among body axes joints say themselves how they are turned on their parent: `Hinge::turned`",
    note = "`BodyAxes` leads there, first in the chain on a `Clamped` root, tilted or not; what is `grounded` sits on ground"
)]
pub trait Relation<G: Geometry>: Copy {
    /// Closure forces that the relation carries.
    type Closures: Closures;
    /// The relation with a point mass added at its station.
    type WithMass: Relation<G, Closures = Self::Closures>;

    /// Adds a point mass (kg) at the station.
    fn with_mass(self, mass: G::Scalar) -> Self::WithMass;

    /// Moves the station inboard by −d on a rigid body, whose outboard end has the centripetal acceleration c = ω × (ω × d); where it
    /// slides on the body, that of Coriolis is added, and what lies outboard is more than a lump:
    /// p_O = (a + α × d + c, α), hence F_I = Xᵀ F_O with X = [[1, −d~], [0, 1]].
    fn carried(self, d: G::Vector, centripetal: G::Vector) -> Full<G, Self::Closures>;

    /// The relation carried along a body with moments of inertia (kg·m²); they may be negative when they only complete those of point masses.
    #[inline(always)]
    fn carried_by(self, inertia: G::Inertia, d: G::Vector, centripetal: G::Vector) -> Full<G, Self::Closures> {
        let full = self.carried(d, centripetal);
        Full { angular: full.angular + inertia, ..full }
    }
}

impl<G: Geometry> Relation<G> for Empty {
    type Closures = Open;
    type WithMass = Lump<G::Scalar>;

    #[inline(always)]
    fn with_mass(self, mass: G::Scalar) -> Lump<G::Scalar> {
        Lump { mass }
    }
    #[inline(always)]
    fn carried(self, _: G::Vector, _: G::Vector) -> Full<G> {
        Full::massless()
    }
}

impl<T: Scalar, G: Geometry<Scalar = T>> Relation<G> for Lump<T> {
    type Closures = Open;
    type WithMass = Self;

    #[inline(always)]
    fn with_mass(self, mass: T) -> Self {
        Self { mass: self.mass + mass }
    }
    #[inline(always)]
    fn carried(self, d: G::Vector, centripetal: G::Vector) -> Full<G> {
        G::of_lump(self.mass, d, centripetal)
    }
    #[inline(always)]
    fn carried_by(self, inertia: G::Inertia, d: G::Vector, centripetal: G::Vector) -> Full<G> {
        let full: Full<G> = G::of_lump(self.mass, d, centripetal);
        Full { angular: G::swung_onto(d, &full.coupling, inertia), ..full }
    }
}

impl<G: Geometry, M: Term<G::Angular>, C: Closures> Relation<G> for Point<G, M, C> {
    type Closures = C;
    type WithMass = Self;

    #[inline(always)]
    fn with_mass(self, mass: G::Scalar) -> Self {
        Self { mass: self.mass.plus_diagonal(mass), ..self }
    }
    #[cfg_attr(optimised, inline(always))]
    fn carried(self, d: G::Vector, centripetal: G::Vector) -> Full<G, C> {
        let coupling = G::levered(self.mass, d);
        let angular = G::swung(d, &coupling);
        let force = self.mass.apply_onto(centripetal, self.offset);
        Full {
            linear: self.mass,
            coupling,
            angular,
            force,
            torque: self.torque.add_to(G::Angular::moment(d, force)),
            cuts: self.cuts.turned(
                |w| Wrench { force: w, torque: G::Angular::moment(d, w) },
                |gap, w| VectorSpace::minus_dot(gap, w, centripetal),
            ),
        }
    }
    #[inline(always)]
    fn carried_by(self, inertia: G::Inertia, d: G::Vector, centripetal: G::Vector) -> Full<G, C> {
        let full = self.carried(d, centripetal);
        Full { angular: G::swung_onto(d, &full.coupling, inertia), ..full }
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

impl<G: Geometry, M: Term<G::Angular>, C: Closures> Point<G, M, C> {
    /// This relation in full.
    #[cfg_attr(optimised, inline(always))]
    pub fn whole(self) -> Full<G, C> {
        Full {
            linear: self.mass,
            coupling: G::Coupling::null(),
            angular: G::Inertia::null(),
            force: self.offset,
            torque: self.torque.add_to(G::Angular::null()),
            cuts: self.cuts.mapped(Wrench::of_force),
        }
    }

    /// A relation that says nothing but `value`: zero, or that it is not known.
    fn blank(value: G::Scalar) -> Self {
        let vector = G::Vector::null().times(value);
        let cuts = Cuts::at_tip(C::each(|_| vector), C::each(|_| value));
        Self { mass: G::Mass::diagonal(value), offset: vector, torque: M::none(), cuts }
    }
}

impl<G: Geometry, M: Term<G::Angular>> Promote<Empty> for Point<G, M> {
    fn promote(_: Empty) -> Self {
        Self::blank(G::Scalar::null())
    }
}

impl<G: Geometry, M: Term<G::Angular>, C: Closures> Promote<Full<G, C>> for Point<G, M, C> {
    /// A point relation cannot stand for a full one: links that end with a pin or ball are missing between a clamp and what needs
    /// it. The sweep reports that nothing came of it.
    fn promote(_: Full<G, C>) -> Self {
        Self::blank(G::Scalar::literal(f64::NAN))
    }
}

impl<G: Geometry> Promote<Empty> for Full<G> {
    fn promote(_: Empty) -> Self {
        Self::massless()
    }
}

/// What a pinned tip demands, where a chain hands on more: links with springs, or with sliders.
impl<G: Geometry, M: Term<G::Angular>, C: Closures> Promote<Point<G, M, C>> for Full<G, C> {
    fn promote(lesser: Point<G, M, C>) -> Self {
        lesser.whole()
    }
}
