//! The lesser relations, and what a body does with any of them.

use super::algebra::{Columns, Symmetric3, cross, dot, zero};
use super::full::levered;
use super::{Full, FullColumn};
use crate::relation::{Absent, Closures, Cuts, Meet, Open, Part, Promote, Reacting, Term};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// Nothing outboard: F = 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Empty;

/// A point mass outboard: q = m a.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lump<T> {
    /// Mass (kg).
    pub mass: T,
}

/// A ball outboard: q = S a + e + W λ, and the moment is the torque M that acts in the ball, if there is one.
#[derive(Clone, Copy)]
pub struct Point<T: Copy, M = Absent, C: Closures = Open> {
    /// S (kg).
    pub stiffness: Symmetric3<T>,
    /// e (N).
    pub offset: Vector3<T>,
    /// Torque on the outboard part (N·m).
    pub torque: M,
    /// Columns of closure forces.
    pub cuts: Cuts<Vector3<T>, T, C>,
}

/// A torque vector (N·m), inertial axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Couple<T>(pub Vector3<T>);

impl<T: Scalar> Part for Couple<T> {
    fn is_finite(self) -> bool {
        super::algebra::is_finite(self.0)
    }
}

impl<T: Scalar> Term<Vector3<T>> for Couple<T> {
    fn none() -> Self {
        Self(zero())
    }
    #[inline(always)]
    fn add_to(self, sum: Vector3<T>) -> Vector3<T> {
        sum + self.0
    }
    #[inline(always)]
    fn take_from(self, sum: Vector3<T>) -> Vector3<T> {
        sum - self.0
    }
}

impl<T: Scalar> Reacting for Couple<T> {
    type Reaction = Self;
    #[inline(always)]
    fn reaction(self) -> Self {
        Self(-self.0)
    }
}

/// What a body can do with the relation it meets, whatever that is.
pub trait Relation<T: Scalar>: Copy {
    /// Closure forces it carries.
    type Closures: Closures;
    /// The relation with a point mass added at its station.
    type WithMass: Relation<T, Closures = Self::Closures>;

    /// Adds a point mass (kg) at the station.
    fn with_mass(self, mass: T) -> Self::WithMass;

    /// Moves the station inboard by −d on a rigid body, whose outboard end has the centripetal acceleration c = ω × (ω × d):
    /// p_O = (a + α × d + c, α), hence F_I = Xᵀ F_O with X = [[1, −d~], [0, 1]].
    fn carried(self, d: Vector3<T>, centripetal: Vector3<T>) -> Full<T, Self::Closures>;
}

impl<T: Scalar> Relation<T> for Empty {
    type Closures = Open;
    type WithMass = Lump<T>;

    #[inline(always)]
    fn with_mass(self, mass: T) -> Lump<T> {
        Lump { mass }
    }
    #[inline(always)]
    fn carried(self, _: Vector3<T>, _: Vector3<T>) -> Full<T> {
        Full::massless()
    }
}

impl<T: Scalar> Relation<T> for Lump<T> {
    type Closures = Open;
    type WithMass = Self;

    #[inline(always)]
    fn with_mass(self, mass: T) -> Self {
        Self { mass: self.mass + mass }
    }
    #[inline(always)]
    fn carried(self, d: Vector3<T>, centripetal: Vector3<T>) -> Full<T> {
        let (o, moment) = (T::zero(), d * self.mass);
        let force = centripetal * self.mass;
        let square = dot(d, moment);
        Full {
            linear: Symmetric3::diagonal(self.mass),
            coupling: Columns {
                x: Vector3::new(o, -moment.z, moment.y),
                y: Vector3::new(moment.z, o, -moment.x),
                z: Vector3::new(-moment.y, moment.x, o),
            },
            // m (d² 1 − d dᵀ)
            angular: Symmetric3::diagonal(square).plus_outer(-d, moment),
            force,
            torque: cross(d, force),
            cuts: Cuts::none(),
        }
    }
}

impl<T: Scalar, M: Term<Vector3<T>>, C: Closures> Relation<T> for Point<T, M, C> {
    type Closures = C;
    type WithMass = Self;

    #[inline(always)]
    fn with_mass(self, mass: T) -> Self {
        Self { stiffness: self.stiffness.plus_diagonal(mass), ..self }
    }

    #[inline(always)]
    fn carried(self, d: Vector3<T>, centripetal: Vector3<T>) -> Full<T, C> {
        let coupling = levered(self.stiffness, d, Columns::zero());
        let (nx, ny, nz) = (cross(d, coupling.x), cross(d, coupling.y), cross(d, coupling.z));
        let force = self.stiffness.apply_onto(centripetal, self.offset);
        Full {
            linear: self.stiffness,
            coupling,
            angular: Symmetric3 { xx: nx.x, xy: nx.y, xz: nx.z, yy: ny.y, yz: ny.z, zz: nz.z },
            force,
            torque: self.torque.add_to(cross(d, force)),
            cuts: self
                .cuts
                .turned(|w| FullColumn { force: w, torque: cross(d, w) }, |gap, w| gap - dot(w, centripetal)),
        }
    }
}

/// A point relation of which nothing is known.
fn blank_point<T: Scalar, M: Term<Vector3<T>>, C: Closures>(value: T) -> Point<T, M, C> {
    let vector = Vector3::new(value, value, value);
    Point {
        stiffness: Symmetric3 { xx: value, xy: value, xz: value, yy: value, yz: value, zz: value },
        offset: vector,
        torque: M::none(),
        cuts: Cuts::at_tip(C::each(|_| vector), C::each(|_| value)),
    }
}

impl<T: Scalar, M: Term<Vector3<T>>> Promote<Empty> for Point<T, M> {
    fn promote(_: Empty) -> Self {
        blank_point(T::zero())
    }
}

impl<T: Scalar, M: Term<Vector3<T>>, C: Closures> Promote<Full<T, C>> for Point<T, M, C> {
    /// A point relation cannot stand for a full one: links that end with a ball are missing between a clamp and what needs the
    /// ball. The sweep reports that nothing came of it.
    fn promote(_: Full<T, C>) -> Self {
        blank_point(T::literal(f64::NAN))
    }
}

impl<T: Scalar> Promote<Empty> for Full<T> {
    fn promote(_: Empty) -> Self {
        Self::massless()
    }
}

impl<T: Scalar, M: Term<Vector3<T>>, C: Closures> Promote<Point<T, M, C>> for Full<T, C> {
    fn promote(point: Point<T, M, C>) -> Self {
        point.carried(zero(), zero())
    }
}

impl<T: Scalar, C: Closures> Promote<Point<T, Absent, C>> for Point<T, Couple<T>, C> {
    fn promote(lesser: Point<T, Absent, C>) -> Self {
        let Point { stiffness, offset, cuts, .. } = lesser;
        Self { stiffness, offset, torque: Couple(zero()), cuts }
    }
}

/// Links that end with a ball, inboard of a joint with a spring or a torque.
impl<T: Scalar, C: Closures> Meet<Point<T, Couple<T>, C>> for Point<T, Absent, C> {
    type Both = Point<T, Couple<T>, C>;
    #[inline(always)]
    fn of_links(own: Self) -> Self::Both {
        Promote::promote(own)
    }
    #[inline(always)]
    fn of_none(outer: Self::Both) -> Self::Both {
        outer
    }
}
