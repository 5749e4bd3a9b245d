//! The eliminations that joints make in a full relation.
//!
//! A joint with several coordinates is a row of joints with one each at the same station, the outermost eliminated first: every
//! elimination changes S by one rank, in one triangle, and its pivot Δ = Φᵀ S Φ is the inertia of what lies outboard against that
//! coordinate.

use super::algebra::{Columns, Symmetric3, add_scaled, dot, dot_onto, is_finite, zero};
use super::{Full, FullColumn, Point};
use crate::relation::{Additive, Closures, Cuts, Open, Symmetric, Term, Way};
use crate::scalar::Scalar;
use nalgebra::Vector3;

impl<T: Scalar, C: Closures> Full<T, C> {
    /// Lets the station move along or about the axis `n` under a generalised force τ̂ − K̂ q̈ (N or N·m): only the pivot knows of K̂.
    #[cfg_attr(optimised, inline(always))]
    pub fn released(self, way: Way, n: Vector3<T>, force: T, stiffness: impl Term<T>) -> (Self, Pivot<T, C>) {
        // U = S Φ, e·Φ
        let (linear, angular, offset) = match way {
            Way::Turn => (self.coupling.apply(n), self.angular.apply(n), dot(n, self.torque)),
            Way::Slide => (self.linear.apply(n), self.coupling.transposed(n), dot(n, self.force)),
        };
        let pivot = match way {
            Way::Turn => dot(n, angular),
            Way::Slide => dot(n, linear),
        };
        let minus_inverse = -stiffness.add_to(pivot).recip();
        let free = (offset - force) * minus_inverse;
        let (per_linear, per_angular) = (linear * minus_inverse, angular * minus_inverse);
        let share = |w: FullColumn<T>| match way {
            Way::Turn => dot(n, w.torque),
            Way::Slide => dot(n, w.force),
        };
        let reduce = |w: FullColumn<T>, row: T| FullColumn {
            force: add_scaled(w.force, row, linear),
            torque: add_scaled(w.torque, row, angular),
        };
        let (cuts, per_closure) = self.cuts.eliminated(minus_inverse, free, share, reduce);
        let k = self.coupling;
        let relation = Self {
            linear: self.linear.plus_outer(linear, per_linear),
            coupling: Columns {
                x: add_scaled(k.x, per_angular.x, linear),
                y: add_scaled(k.y, per_angular.y, linear),
                z: add_scaled(k.z, per_angular.z, linear),
            },
            angular: self.angular.plus_outer(angular, per_angular),
            force: add_scaled(self.force, free, linear),
            torque: add_scaled(self.torque, free, angular),
            cuts,
        };
        (relation, Pivot { per_linear, per_angular, free, per_closure })
    }

    /// Lets the station turn freely under the torque that acts in the ball: the rotation is eliminated.
    #[cfg_attr(optimised, inline(always))]
    pub fn balled<M: Term<Vector3<T>>>(self, torque: M) -> (Point<T, M, C>, Gain<T, C>) {
        let factor = self.angular.factor();
        let k = self.coupling;
        // Rows of K: α = free − H⁻¹ Kᵀ a, one column for each entry of a.
        let row = |x: T, y: T, z: T| -factor.solve(Vector3::new(x, y, z));
        let per_acceleration =
            Columns { x: row(k.x.x, k.y.x, k.z.x), y: row(k.x.y, k.y.y, k.z.y), z: row(k.x.z, k.y.z, k.z.z) };
        let free = -factor.solve(torque.take_from(self.torque));
        let g = per_acceleration;
        let rows = Columns {
            x: Vector3::new(g.x.x, g.y.x, g.z.x),
            y: Vector3::new(g.x.y, g.y.y, g.z.y),
            z: Vector3::new(g.x.z, g.y.z, g.z.z),
        };
        let (cuts, per_closure) =
            turned_out(&self.cuts, |w| w.torque, free, |w| -factor.solve(w), |w, row| k.apply_onto(row, w.force));
        let relation =
            Point { mass: self.linear.plus_product(&k, &rows), offset: k.apply_onto(free, self.force), torque, cuts };
        (relation, Gain { per_acceleration, free, per_closure })
    }

    /// Lets the station turn against a stiff torque τ̂ − K̂ β, with β relative to the inboard body: only the pivot of the elimination,
    /// H + K̂, knows of it.
    #[cfg_attr(optimised, inline(always))]
    pub fn sprung(self, torque: Vector3<T>, stiffness: Symmetric3<T>) -> (Self, BallGain<T, C>) {
        let (k, h) = (self.coupling, self.angular);
        let factor = (h + stiffness).factor();
        let row = |x: T, y: T, z: T| -factor.solve(Vector3::new(x, y, z));
        let g = Columns { x: row(k.x.x, k.y.x, k.z.x), y: row(k.x.y, k.y.y, k.z.y), z: row(k.x.z, k.y.z, k.z.z) };
        let rows = Columns {
            x: Vector3::new(g.x.x, g.y.x, g.z.x),
            y: Vector3::new(g.x.y, g.y.y, g.z.y),
            z: Vector3::new(g.x.z, g.y.z, g.z.z),
        };
        let own = h.columns();
        let per_angular = Columns { x: -factor.solve(own.x), y: -factor.solve(own.y), z: -factor.solve(own.z) };
        let free = factor.solve(torque - self.torque);
        // What is left of the rotational part, I_a Φ = U Δ⁻¹ K̂: no difference of large numbers.
        let stiff = stiffness.columns();
        let left = Columns { x: factor.solve(stiff.x), y: factor.solve(stiff.y), z: factor.solve(stiff.z) };
        let turned = own.times(&left);
        let reduce = |w: FullColumn<T>, row: Vector3<T>| FullColumn {
            force: k.apply_onto(row, w.force),
            torque: -stiffness.apply(row),
        };
        let (cuts, per_closure) = turned_out(&self.cuts, |w| w.torque, free, |w| -factor.solve(w), reduce);
        let relation = Self {
            linear: self.linear.plus_product(&k, &rows),
            coupling: k.times(&left),
            angular: Symmetric3 {
                xx: turned.x.x,
                xy: turned.x.y,
                xz: turned.x.z,
                yy: turned.y.y,
                yz: turned.y.z,
                zz: turned.z.z,
            },
            force: k.apply_onto(free, self.force),
            torque: h.apply_onto(free, self.torque),
            cuts,
        };
        (relation, BallGain { absolute: Gain { per_acceleration: g, free, per_closure }, per_angular })
    }
}

/// The angular acceleration for each closure force.
pub(super) type Rows<T, C> = <C as Closures>::Each<Vector3<T>>;

/// Columns of closure forces where three coordinates are eliminated at once, whose share of a column `share` reads: each reduced to
/// what stays of it.
#[cfg_attr(optimised, inline(always))]
pub(super) fn turned_out<T: Scalar, C: Closures, V: Copy, X: Copy>(
    cuts: &Cuts<V, T, C>,
    share: impl Fn(V) -> Vector3<T>,
    free: Vector3<T>,
    minus_solve: impl Fn(Vector3<T>) -> Vector3<T>,
    reduce: impl FnMut(V, Vector3<T>) -> X,
) -> (Cuts<X, T, C>, Rows<T, C>) {
    let rows = C::map(&cuts.columns, |w| minus_solve(share(w)));
    let part = |read: fn(Vector3<T>) -> T| (C::map(&cuts.columns, |w| read(share(w))), C::map(&rows, read));
    let (x, y, z) = (part(|v| v.x), part(|v| v.y), part(|v| v.z));
    let compliance = C::minus_outer(&cuts.compliance, &x.0, &x.1);
    let compliance = C::minus_outer(&compliance, &y.0, &y.1);
    let compliance = C::minus_outer(&compliance, &z.0, &z.1);
    let reduced = Cuts {
        columns: C::zip(&cuts.columns, &rows, reduce),
        compliance,
        gap: C::zip(&cuts.gap, &cuts.columns, |gap, w| gap - dot(share(w), free)),
    };
    (reduced, rows)
}

/// What eliminating a rotation leaves behind: α = free + G a + rows · λ.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "Columns<T>: serde::Serialize, Vector3<T>: serde::Serialize, C::Each<Vector3<T>>: serde::Serialize",
        deserialize = "Columns<T>: serde::Deserialize<'de>, Vector3<T>: serde::Deserialize<'de>, C::Each<Vector3<T>>: serde::Deserialize<'de>"
    ))
)]
pub struct Gain<T: Copy, C: Closures = Open> {
    /// G = −H⁻¹ Kᵀ (rad/m).
    pub per_acceleration: Columns<T>,
    /// Angular acceleration of a station that does not accelerate (rad/s²).
    pub free: Vector3<T>,
    /// Angular acceleration for each closure force.
    pub per_closure: C::Each<Vector3<T>>,
}

impl<T: Scalar, C: Closures> Gain<T, C> {
    /// No gain yet.
    pub fn blank() -> Self {
        Self { per_acceleration: Columns::null(), free: zero(), per_closure: C::each(|_| zero()) }
    }

    /// Whether the pivots of the gain resist: what velocities, loads and springs contribute may overflow where they do.
    pub fn is_finite(&self) -> bool {
        let Columns { x, y, z } = self.per_acceleration;
        [x, y, z].into_iter().all(is_finite)
    }

    /// The angular acceleration (rad/s²) of the eliminated rotation where its station accelerates by `a`.
    #[cfg_attr(optimised, inline(always))]
    pub fn angular(&self, a: Vector3<T>, multipliers: &C::Each<T>) -> Vector3<T> {
        let open = self.per_acceleration.apply_onto(a, self.free);
        let part = |read: fn(Vector3<T>) -> T| C::map(&self.per_closure, read);
        Vector3::new(
            C::plus_dot(open.x, &part(|v| v.x), multipliers),
            C::plus_dot(open.y, &part(|v| v.y), multipliers),
            C::plus_dot(open.z, &part(|v| v.z), multipliers),
        )
    }
}

/// What eliminating a rotation relative to the inboard body leaves behind: β = free + G a + G_α α + rows · λ.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "Gain<T, C>: serde::Serialize, Columns<T>: serde::Serialize",
        deserialize = "Gain<T, C>: serde::Deserialize<'de>, Columns<T>: serde::Deserialize<'de>"
    ))
)]
pub struct BallGain<T: Copy, C: Closures = Open> {
    /// All but G_α.
    pub absolute: Gain<T, C>,
    /// G_α, for the angular acceleration of the inboard body.
    pub per_angular: Columns<T>,
}

impl<T: Scalar, C: Closures> BallGain<T, C> {
    /// No gain yet.
    pub fn blank() -> Self {
        Self::absolute(Gain::blank())
    }

    /// The gain of an absolute rotation, as one relative to the inboard body: G_α = −1.
    #[inline(always)]
    pub fn absolute(absolute: Gain<T, C>) -> Self {
        let Columns { x, y, z } = Columns::identity();
        Self { absolute, per_angular: Columns { x: -x, y: -y, z: -z } }
    }

    /// This gain without what velocities, loads and springs contribute.
    #[inline(always)]
    pub fn homogeneous(&self) -> Self {
        Self { absolute: Gain { free: zero(), ..self.absolute }, ..*self }
    }

    /// Whether the pivots of the gain resist: what velocities, loads and springs contribute may overflow where they do.
    pub fn is_finite(&self) -> bool {
        let Columns { x, y, z } = self.per_angular;
        self.absolute.is_finite() && [x, y, z].into_iter().all(is_finite)
    }

    /// The relative angular acceleration (rad/s²) where the inboard body's end accelerates by (`linear`, `angular`).
    #[inline(always)]
    pub fn relative(&self, linear: Vector3<T>, angular: Vector3<T>, multipliers: &C::Each<T>) -> Vector3<T> {
        self.per_angular.apply_onto(angular, self.absolute.angular(linear, multipliers))
    }
}

/// What eliminating one coordinate leaves behind: q̈ = free + w · (a, α) + row · λ.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "Vector3<T>: serde::Serialize, T: serde::Serialize, C::Each<T>: serde::Serialize",
        deserialize = "Vector3<T>: serde::Deserialize<'de>, T: serde::Deserialize<'de>, C::Each<T>: serde::Deserialize<'de>"
    ))
)]
pub struct Pivot<T: Copy, C: Closures = Open> {
    /// w for the acceleration of the station.
    pub per_linear: Vector3<T>,
    /// w for its angular acceleration.
    pub per_angular: Vector3<T>,
    /// Acceleration of the coordinate where the station does not accelerate.
    pub free: T,
    /// Acceleration of the coordinate for each closure force.
    pub per_closure: C::Each<T>,
}

impl<T: Scalar, C: Closures> Pivot<T, C> {
    /// No gain yet.
    pub fn blank() -> Self {
        Self { per_linear: zero(), per_angular: zero(), free: T::zero(), per_closure: C::each(|_| T::zero()) }
    }

    /// Whether the pivot of the gain resists: what velocities, loads and springs contribute may overflow where it does.
    pub fn is_finite(&self) -> bool {
        is_finite(self.per_linear) && is_finite(self.per_angular)
    }

    /// The acceleration of the coordinate where its station accelerates by (`linear`, `angular`).
    #[inline(always)]
    pub fn acceleration(&self, linear: Vector3<T>, angular: Vector3<T>, multipliers: &C::Each<T>) -> T {
        let open = dot_onto(self.per_linear, linear, dot_onto(self.per_angular, angular, self.free));
        C::plus_dot(open, &self.per_closure, multipliers)
    }
}
