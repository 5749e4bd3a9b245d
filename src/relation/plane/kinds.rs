//! The lesser relations, and what a body does with any of them.

use super::algebra::{Symmetric2, dot, minus_dot, normal, plus_dot};
use super::{Full, FullColumn, Slides};
use crate::relation::{Absent, Closures, Cuts, Meet, Minus, Open, Promote, Term};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// Nothing outboard: F = 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Empty;

/// A point mass outboard: q = m a.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lump<T> {
    /// Mass (kg).
    pub mass: T,
}

/// A pin outboard: q = S a + e + W λ, and the moment is the torque M that acts in the pin, if there is one.
#[derive(Clone, Copy)]
pub struct Point<T: Copy, M = Absent, C: Closures = Open> {
    /// S (kg).
    pub stiffness: Symmetric2<T>,
    /// e (N).
    pub offset: Vector2<T>,
    /// Torque on the outboard part (N·m).
    pub torque: M,
    /// Columns of closure forces.
    pub cuts: Cuts<Vector2<T>, T, C>,
}

/// What a body can do with the relation it meets, whatever that is.
pub trait Relation<T: Scalar>: Copy {
    /// Closure forces it carries.
    type Closures: Closures;
    /// The relation with a point mass added at its station.
    type WithMass: Relation<T, Closures = Self::Closures>;

    /// Adds a point mass (kg) at the station.
    fn with_mass(self, mass: T) -> Self::WithMass;

    /// Moves the station inboard by −d on a rigid body, whose outboard end has the centripetal acceleration −ω² d; where it slides
    /// on the body, that of Coriolis is added, and what lies outboard is more than a lump:
    /// p_O = (a + α n − ω² d, α), hence F_I = Xᵀ F_O with X = [[1, n], [0, 1]].
    fn carried(self, d: Vector2<T>, centripetal: Vector2<T>) -> Full<T, Self::Closures>;

    /// The same on a body with a rotary inertia (kg·m²); it may be negative when it only completes that of point masses.
    #[inline(always)]
    fn carried_by(self, inertia: T, d: Vector2<T>, centripetal: Vector2<T>) -> Full<T, Self::Closures> {
        self.carried(d, centripetal).with_inertia(inertia)
    }
}

fn zero<T: Scalar>() -> Vector2<T> {
    Vector2::new(T::zero(), T::zero())
}

impl<T: Scalar> Relation<T> for Empty {
    type Closures = Open;
    type WithMass = Lump<T>;

    #[inline(always)]
    fn with_mass(self, mass: T) -> Lump<T> {
        Lump { mass }
    }
    #[inline(always)]
    fn carried(self, _: Vector2<T>, _: Vector2<T>) -> Full<T> {
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
    fn carried(self, d: Vector2<T>, centripetal: Vector2<T>) -> Full<T> {
        let n = normal(d);
        let coupling = n * self.mass;
        Full {
            linear: Symmetric2::diagonal(self.mass),
            coupling,
            angular: dot(n, coupling),
            force: centripetal * self.mass,
            torque: T::zero(), // only bodies meet lumps, and their centripetal force has no moment about the station: n · d = 0
            cuts: Cuts::none(),
        }
    }
    #[inline(always)]
    fn carried_by(self, inertia: T, d: Vector2<T>, centripetal: Vector2<T>) -> Full<T> {
        let full = self.carried(d, centripetal);
        Full { angular: plus_dot(inertia, normal(d), full.coupling), ..full }
    }
}

impl<T: Scalar, M: Term<T>, C: Closures> Relation<T> for Point<T, M, C> {
    type Closures = C;
    type WithMass = Self;

    #[inline(always)]
    fn with_mass(self, mass: T) -> Self {
        Self { stiffness: self.stiffness.plus_diagonal(mass), ..self }
    }
    #[inline(always)]
    fn carried(self, d: Vector2<T>, centripetal: Vector2<T>) -> Full<T, C> {
        let n = normal(d);
        let coupling = self.stiffness.apply(n);
        let force = self.stiffness.apply_onto(centripetal, self.offset);
        Full {
            linear: self.stiffness,
            coupling,
            angular: dot(n, coupling),
            force,
            torque: self.torque.add_to(dot(n, force)),
            cuts: self
                .cuts
                .turned(|w| FullColumn { force: w, torque: dot(n, w) }, |sum, w| minus_dot(sum, w, centripetal)),
        }
    }
    #[inline(always)]
    fn carried_by(self, inertia: T, d: Vector2<T>, centripetal: Vector2<T>) -> Full<T, C> {
        let full = self.carried(d, centripetal);
        Full { angular: plus_dot(inertia, normal(d), full.coupling), ..full }
    }
}

impl<T: Scalar, M: Term<T>> Promote<Empty> for Point<T, M> {
    fn promote(_: Empty) -> Self {
        let stiffness = Symmetric2::diagonal(T::zero());
        Self { stiffness, offset: zero(), torque: M::none(), cuts: Cuts::none() }
    }
}

impl<T: Scalar, M: Term<T>, C: Closures> Promote<Full<T, C>> for Point<T, M, C> {
    /// A point relation cannot stand for a full one: links that end with a pin are missing between a clamp and what needs the
    /// pin. The sweep reports that nothing came of it.
    fn promote(_: Full<T, C>) -> Self {
        let never = T::literal(f64::NAN);
        let cuts = Cuts::at_tip(C::each(|_| Vector2::new(never, never)), C::each(|_| never));
        let stiffness = Symmetric2::diagonal(never);
        Self { stiffness, offset: Vector2::new(never, never), torque: M::none(), cuts }
    }
}

impl<T: Scalar> Promote<Empty> for Full<T> {
    fn promote(_: Empty) -> Self {
        Self::massless()
    }
}

/// What a pinned tip demands, where a chain hands on more: links with springs, or with sliders.
impl<T: Scalar, M: Term<T>, C: Closures> Promote<Point<T, M, C>> for Full<T, C> {
    fn promote(lesser: Point<T, M, C>) -> Self {
        Slides::full(lesser)
    }
}

impl<T: Scalar, C: Closures> Promote<Point<T, Absent, C>> for Point<T, Minus<T>, C> {
    fn promote(lesser: Point<T, Absent, C>) -> Self {
        let Point { stiffness, offset, cuts, .. } = lesser;
        Self { stiffness, offset, torque: Minus::none(), cuts }
    }
}

impl<T: Scalar, C: Closures> Promote<Point<T, Absent, C>> for Point<T, T, C> {
    fn promote(lesser: Point<T, Absent, C>) -> Self {
        let Point { stiffness, offset, cuts, .. } = lesser;
        Self { stiffness, offset, torque: T::zero(), cuts }
    }
}

impl<T: Scalar, C: Closures> Promote<Point<T, Minus<T>, C>> for Point<T, T, C> {
    fn promote(other: Point<T, Minus<T>, C>) -> Self {
        let Point { stiffness, offset, torque: Minus(torque), cuts } = other;
        Self { stiffness, offset, torque: -torque, cuts }
    }
}

impl<T: Scalar, C: Closures> Promote<Point<T, T, C>> for Point<T, Minus<T>, C> {
    fn promote(other: Point<T, T, C>) -> Self {
        let Point { stiffness, offset, torque, cuts } = other;
        Self { stiffness, offset, torque: Minus(-torque), cuts }
    }
}

/// Links that end with a pin, inboard of a joint with a spring or a torque.
macro_rules! meet {
    ($($Torque:ty),*) => {$(
        impl<T: Scalar, C: Closures> Meet<Point<T, $Torque, C>> for Point<T, Absent, C> {
            type Both = Point<T, $Torque, C>;
            #[inline(always)]
            fn of_links(own: Self) -> Self::Both {
                Promote::promote(own)
            }
            #[inline(always)]
            fn of_none(outer: Self::Both) -> Self::Both {
                outer
            }
        }
    )*};
}
meet!(T, Minus<T>);
