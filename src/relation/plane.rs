//! Relations in the plane, F = S p + e with F = (q, −m) the force on the outboard part and p = (a, α).
//!
//! | type | outboard of it | stored |
//! |---|---|---|
//! | [`Empty`] | nothing: a free tip | 0 numbers |
//! | [`Lump`] | a point mass | 1 |
//! | [`Point`] | a pin: the moment does not depend on the motion | 5 (and the pin's torque, if it has one) |
//! | [`Full`] | a body, a weld, a spring | 9 |
//!
//! Moments are taken about the station; d is the vector to the next station outboard, n = ẑ × d its normal.

use super::{Absent, Promote, Term};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// a · b.
#[inline(always)]
pub fn dot<T: Scalar>(a: Vector2<T>, b: Vector2<T>) -> T {
    a.x.mul_add(b.x, a.y * b.y)
}

/// a × b, the component along ẑ.
#[inline(always)]
pub fn cross<T: Scalar>(a: Vector2<T>, b: Vector2<T>) -> T {
    a.x.mul_add(b.y, -(a.y * b.x))
}

/// ẑ × d.
#[inline(always)]
pub fn normal<T: Scalar>(d: Vector2<T>) -> Vector2<T> {
    Vector2::new(-d.y, d.x)
}

/// `sum + factor · v`, fused where the target can.
#[inline(always)]
pub fn add_scaled<T: Scalar>(sum: Vector2<T>, factor: T, v: Vector2<T>) -> Vector2<T> {
    Vector2::new(v.x.mul_add(factor, sum.x), v.y.mul_add(factor, sum.y))
}

/// A symmetric 2 × 2 matrix, one triangle stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Symmetric2<T> {
    /// Row x, column x.
    pub xx: T,
    /// Row x, column y, and its mirror.
    pub xy: T,
    /// Row y, column y.
    pub yy: T,
}

impl<T: Scalar> Symmetric2<T> {
    /// `value` on the diagonal.
    #[inline(always)]
    pub fn diagonal(value: T) -> Self {
        Self { xx: value, xy: T::zero(), yy: value }
    }

    /// S v.
    #[inline(always)]
    pub fn apply(self, v: Vector2<T>) -> Vector2<T> {
        Vector2::new(self.xx.mul_add(v.x, self.xy * v.y), self.xy.mul_add(v.x, self.yy * v.y))
    }

    /// `sum` + S v.
    #[inline(always)]
    pub fn apply_onto(self, v: Vector2<T>, sum: Vector2<T>) -> Vector2<T> {
        Vector2::new(
            self.xx.mul_add(v.x, self.xy.mul_add(v.y, sum.x)),
            self.xy.mul_add(v.x, self.yy.mul_add(v.y, sum.y)),
        )
    }

    /// S⁻¹ v, by elimination of x.
    #[inline(always)]
    pub fn solve(self, v: Vector2<T>) -> Vector2<T> {
        let inverse = self.xx.recip();
        let ratio = self.xy * inverse;
        let y = ratio.mul_add(-v.x, v.y) / ratio.mul_add(-self.xy, self.yy);
        Vector2::new((v.x - self.xy * y) * inverse, y)
    }

    /// S + value·1.
    #[inline(always)]
    pub fn plus_diagonal(self, value: T) -> Self {
        Self { xx: self.xx + value, xy: self.xy, yy: self.yy + value }
    }

    /// S − u wᵀ for parallel u and w, so that the result is symmetric.
    #[inline(always)]
    pub fn minus_outer(self, u: Vector2<T>, w: Vector2<T>) -> Self {
        Self { xx: (-u.x).mul_add(w.x, self.xx), xy: (-u.x).mul_add(w.y, self.xy), yy: (-u.y).mul_add(w.y, self.yy) }
    }
}

/// Nothing outboard: F = 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Empty;

/// A point mass outboard: q = m a.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lump<T> {
    /// Mass (kg).
    pub mass: T,
}

/// A pin outboard: q = S a + e, and the moment is the torque M that acts in the pin, if there is one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point<T, M = Absent> {
    /// S (kg).
    pub stiffness: Symmetric2<T>,
    /// e (N).
    pub offset: Vector2<T>,
    /// Torque on the outboard part (N·m).
    pub torque: M,
}

/// A full relation: q = S_qq a + s α + e_q, −m = s·a + S_mm α + e_m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Full<T> {
    /// S_qq (kg).
    pub linear: Symmetric2<T>,
    /// s, the coupling of force and angular acceleration (kg·m).
    pub coupling: Vector2<T>,
    /// S_mm (kg·m²).
    pub angular: T,
    /// e_q (N).
    pub force: Vector2<T>,
    /// e_m (N·m), of the torque on the outboard part.
    pub torque: T,
}

impl<T: Scalar, M: Term<T>> Promote<Empty> for Point<T, M> {
    fn promote(_: Empty) -> Self {
        let zero = Vector2::new(T::zero(), T::zero());
        Self { stiffness: Symmetric2::diagonal(T::zero()), offset: zero, torque: M::none() }
    }
}

impl<T: Scalar> Promote<Empty> for Full<T> {
    fn promote(empty: Empty) -> Self {
        let zero = Vector2::new(T::zero(), T::zero());
        empty.carried(zero, T::zero())
    }
}

/// What a body can do with the relation it meets, whatever that is.
pub trait Relation<T: Scalar>: Copy {
    /// The relation with a point mass added at its station.
    type WithMass: Relation<T>;

    /// Adds a point mass (kg) at the station.
    fn with_mass(self, mass: T) -> Self::WithMass;

    /// Moves the station inboard by −d on a rigid body that turns at a rate with the square `spin2` (rad²/s²):
    /// p_O = (a + α n − ω² d, α), hence F_I = Xᵀ F_O with X = [[1, n], [0, 1]].
    fn carried(self, d: Vector2<T>, spin2: T) -> Full<T>;
}

impl<T: Scalar> Relation<T> for Empty {
    type WithMass = Lump<T>;

    #[inline(always)]
    fn with_mass(self, mass: T) -> Lump<T> {
        Lump { mass }
    }

    #[inline(always)]
    fn carried(self, _: Vector2<T>, _: T) -> Full<T> {
        let zero = Vector2::new(T::zero(), T::zero());
        let linear = Symmetric2::diagonal(T::zero());
        Full { linear, coupling: zero, angular: T::zero(), force: zero, torque: T::zero() }
    }
}

impl<T: Scalar> Relation<T> for Lump<T> {
    type WithMass = Self;

    #[inline(always)]
    fn with_mass(self, mass: T) -> Self {
        Self { mass: self.mass + mass }
    }

    #[inline(always)]
    fn carried(self, d: Vector2<T>, spin2: T) -> Full<T> {
        let n = normal(d);
        let coupling = n * self.mass;
        Full {
            linear: Symmetric2::diagonal(self.mass),
            coupling,
            angular: dot(n, coupling),
            force: d * -(self.mass * spin2),
            torque: T::zero(), // the centripetal force has no moment about the station: n · d = 0
        }
    }
}

impl<T: Scalar, M: Term<T>> Relation<T> for Point<T, M> {
    type WithMass = Self;

    #[inline(always)]
    fn with_mass(self, mass: T) -> Self {
        Self { stiffness: self.stiffness.plus_diagonal(mass), ..self }
    }

    #[inline(always)]
    fn carried(self, d: Vector2<T>, spin2: T) -> Full<T> {
        let n = normal(d);
        let coupling = self.stiffness.apply(n);
        let force = self.stiffness.apply_onto(d * -spin2, self.offset);
        Full {
            linear: self.stiffness,
            coupling,
            angular: dot(n, coupling),
            force,
            torque: self.torque.add_to(dot(n, force)),
        }
    }
}

impl<T: Scalar> Relation<T> for Full<T> {
    type WithMass = Self;

    #[inline(always)]
    fn with_mass(self, mass: T) -> Self {
        Self { linear: self.linear.plus_diagonal(mass), ..self }
    }

    #[inline(always)]
    fn carried(self, d: Vector2<T>, spin2: T) -> Full<T> {
        let n = normal(d);
        let centripetal = d * -spin2;
        let coupling = self.linear.apply_onto(n, self.coupling);
        let force = self.linear.apply_onto(centripetal, self.force);
        Full {
            linear: self.linear,
            coupling,
            angular: dot(n, self.coupling + coupling) + self.angular,
            force,
            torque: dot(n, force) + dot(self.coupling, centripetal) + self.torque,
        }
    }
}

impl<T: Scalar> Full<T> {
    /// Adds a rotary inertia (kg·m²); it may be negative when it only completes that of point masses.
    #[inline(always)]
    pub fn with_inertia(self, inertia: T) -> Self {
        Self { angular: self.angular + inertia, ..self }
    }

    /// Adds a first moment σ = m d_C (kg·m) about the station, of a body that turns at a rate with square `spin2`.
    #[inline(always)]
    pub fn with_first_moment(self, moment: Vector2<T>, spin2: T) -> Self {
        Self { coupling: self.coupling + normal(moment), force: add_scaled(self.force, -spin2, moment), ..self }
    }

    /// Lets the station turn freely under the torque that acts in the pin: the rotation is eliminated, and what the
    /// outward pass needs to find it again is returned beside the relation.
    #[inline(always)]
    pub fn pinned<M: Term<T>>(self, torque: M) -> (Point<T, M>, Gain<T>) {
        let inverse = self.angular.recip();
        let per_acceleration = self.coupling * inverse;
        let free = torque.add_to(-self.torque) * inverse;
        let relation = Point {
            stiffness: self.linear.minus_outer(self.coupling, per_acceleration),
            offset: add_scaled(self.force, free, self.coupling),
            torque,
        };
        (relation, Gain { per_acceleration, free })
    }
}

impl<T: Scalar> Full<T> {
    /// The acceleration (a, α) of a station on which nothing acts: S p + e = 0, by block elimination.
    #[inline(always)]
    pub fn free(self) -> (Vector2<T>, T) {
        let (Point { stiffness, offset, .. }, gain) = self.pinned(Absent);
        let linear = stiffness.solve(-offset);
        (linear, gain.angular(linear))
    }
}

/// What eliminating a rotation leaves behind: α = free − w · a.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gain<T> {
    /// w = s / S_mm (rad/m).
    pub per_acceleration: Vector2<T>,
    /// Angular acceleration of a station that does not accelerate (rad/s²).
    pub free: T,
}

impl<T: Scalar> Gain<T> {
    /// The angular acceleration (rad/s²) of the eliminated rotation where its station accelerates by `a`.
    #[inline(always)]
    pub fn angular(&self, a: Vector2<T>) -> T {
        let w = self.per_acceleration;
        (-w.x).mul_add(a.x, (-w.y).mul_add(a.y, self.free))
    }
}
