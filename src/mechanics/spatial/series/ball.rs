//! Taylor series in space: what balls do.
//!
//! The attitude is P(t) A₀ with A₀ that where the series begins. Coordinates of the step are v = A₀ᵀ u, twice the vector part of P's
//! quaternion (√(1 − u²/4), u/2), which with its first entry p₀ obeys
//!
//! ```text
//! ṗ₀ = −¼ ω · u      u̇ = p₀ ω + ½ ω × u
//! ```
//!
//! Coefficients of v̈ are what the walk gives: those of accelerations of coordinates of the step. A torque ε in axes of the body is
//! A₀ε + u × w in inertial ones, with w = p₀ A₀ε + ½ u × A₀ε.

use super::products::{columns, row, vector};
use super::rods::scaled;
use super::{AxesSeries, Swung, parted};
use crate::mechanics::spatial::loads::{Drive, Effort};
use crate::mechanics::spatial::{Acceleration, Ball, Internal, Spatial};
use crate::relation::spatial::algebra::{add_scaled, cross_onto, dot, zero};
use crate::relation::spatial::{Full, Gain};
use crate::relation::{Absent, Closures};
use crate::scalar::Scalar;
use crate::series::ExpandLoads;
use crate::shape::{Of, Takes};
use crate::walks::series::{Articulate, Begin, Push, Swing};
use nalgebra::Vector3;

/// A coefficient of what is applied in a joint.
pub trait Applied<T: Scalar>: Drive<T> {
    /// A torque in a ball, axes of the outboard body, if there is any.
    fn torque(&self) -> Option<Vector3<T>>;
}

impl<T: Scalar> Applied<T> for Absent {
    #[inline(always)]
    fn torque(&self) -> Option<Vector3<T>> {
        None
    }
}

impl<T: Scalar> Applied<T> for Effort<T> {
    #[inline(always)]
    fn torque(&self) -> Option<Vector3<T>> {
        Some(Vector3::from(self.0))
    }
}

impl<T: Scalar, const N: usize> AxesSeries<T, N> {
    /// Coefficient `k` of the torque, inertial axes, from that in axes of the body.
    fn couple(&mut self, k: usize, torque: Vector3<T>) -> Vector3<T> {
        let (half, torque) = (T::literal(0.5), columns(&self.axes).apply(torque));
        let (Some(turned), Some(turning)) = (self.turned.get_mut(..=k), self.turning.get(..k)) else {
            return torque;
        };
        // Beside ω: A₀ε, w.
        let (mut couple, mut around) = (torque, torque);
        for (attitude, known) in turning.iter().zip(turned[..k].iter().rev()) {
            let [p, x, y, z] = attitude[0];
            let (u, [_, given, w]) = (Vector3::new(x, y, z), known);
            couple = cross_onto(u, vector(*w), couple);
            let given = vector(*given);
            around = cross_onto(u * half, given, add_scaled(around, p, given));
        }
        if let Some([_, given, w]) = turned.last_mut() {
            (*given, *w) = (row(torque), row(around));
        }
        couple
    }
}

impl<T: Scalar, const N: usize> Takes<Spatial<T>, Begin<N>> for Ball {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Begin<N>,
        _: Vector3<T>,
        (attitude, _, _, (_, rate), (room, _)): Of<'_, Spatial<T>, Begin<N>, Self>,
    ) -> Vector3<T> {
        room.axes = [row(attitude.x), row(attitude.y), row(attitude.z)];
        let spin = attitude.apply(Vector3::from(*rate));
        room.turned[0][0] = row(spin);
        room.turning[0][0] = [T::zero(), spin.x, spin.y, spin.z];
        spin
    }
}

impl<T: Scalar, C: Closures, const N: usize> Takes<Spatial<T>, Articulate<Spatial<T>, N, C>> for Ball {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Articulate { cuts }: &mut Articulate<Spatial<T>, N, C>,
        outer: Full<T>,
        (_, room, rows): Of<'_, Spatial<T>, Articulate<Spatial<T>, N, C>, Self>,
    ) -> Full<T> {
        // The same factors as in the elimination: they are formed once.
        room.factor = outer.angular.factor();
        let (point, Gain { per_acceleration, per_closure, .. }) = outer.cut(*cuts).balled(Absent);
        room.gain.per_acceleration = per_acceleration;
        // Of each closure force the angular acceleration.
        *rows = C::map(&per_closure, |torque| Internal { force: zero(), torque });
        parted(point.whole(), cuts)
    }
}

impl<T: Scalar, A: ExpandLoads<Spatial<T>, N, InJoint: Applied<T>>, C: Closures, const N: usize>
    Takes<Spatial<T>, Push<Spatial<T>, A, N, C>> for Ball
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Push { order, gaps, .. }: &mut Push<Spatial<T>, A, N, C>,
        outer: Internal<T>,
        ((axes, room, rows), efforts, ()): Of<'_, Spatial<T>, Push<Spatial<T>, A, N, C>, Self>,
    ) -> Internal<T> {
        let [x, y, z] = axes.spread(order.k);
        let (half, quarter) = (T::literal(0.5), T::literal(-0.25));
        let turned = Vector3::new(
            half.mul_add(y[3] - z[2], x[0]),
            half.mul_add(z[1] - x[3], y[0]),
            half.mul_add(x[2] - y[1], z[0]),
        );
        let [p, q, r]: [T; 3] = scaled(turned, order.next).into();
        axes.curls[0] = [p, q, r, ((x[1] + y[2] + z[3]) * quarter).scale(order.next)];
        let (missed, torque) = match order.among(efforts).torque() {
            Some(torque) => {
                let couple = axes.couple(order.k, torque);
                (outer.torque - couple, couple)
            }
            None => (outer.torque, zero()),
        };
        room.gain.free = -room.factor.solve(missed);
        *gaps = C::zip(gaps, rows, |gap, w| gap - dot(w.torque, missed));
        Internal { force: room.gain.per_acceleration.transposed_onto(missed, outer.force), torque }
    }
}

impl<T: Scalar, A: ExpandLoads<Spatial<T>, N>, C: Closures, const N: usize>
    Takes<Spatial<T>, Swing<Spatial<T>, A, N, C>> for Ball
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        Swing { order, forces, .. }: &mut Swing<Spatial<T>, A, N, C>,
        inboard: Swung<T>,
        ((axes, room, rows), acceleration, ()): Of<'_, Spatial<T>, Swing<Spatial<T>, A, N, C>, Self>,
    ) -> Swung<T> {
        let mut angular = match inboard {
            Swung::At(Acceleration { linear, .. }) => room.gain.angular(linear, &()),
            Swung::Still | Swung::Turning(_) => room.gain.free,
        };
        C::zip(rows, forces, |w, by| angular = add_scaled(angular, by, w.torque));
        let turned = angular + vector(axes.curls[0]);
        *acceleration = columns(&axes.axes).transposed(turned).into();
        let number = order.k + 1;
        if let (Some(spin), Some(attitude)) = (axes.turned.get_mut(number), axes.turning.get_mut(number)) {
            spin[0] = row(scaled(angular, order.once));
            let [x, y, z]: [T; 3] = scaled(turned, order.twice).into();
            attitude[0] = [axes.curls[0][3].scale(order.twice), x, y, z];
        }
        inboard.turning(angular)
    }
}
