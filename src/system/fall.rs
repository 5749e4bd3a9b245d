//! What pulls a scene towards rest, and steps that follow it: K δ = M a, and downhill max(|K|, μ D) δ = M a.

use super::differences::differenced;
use super::linear::Linear;
use super::principal::Principal;
use crate::dense::{Factors, Matrix};
use crate::scalar::{Real, Scalar};
use alloc::vec::Vec;
use num_traits::{One, Zero};

/// Steps longer than this many of the longest are no good even for their direction.
const FAR: f64 = 40.0;
/// As a power of ε, the share of stiffness that may be rounding: 4e-10 of `f64`, 7e-5 of `f32`.
pub(super) const ROUNDED: f64 = 0.6;

/// What pulls a scene towards rest, in the directions that its closures leave open.
pub(super) struct Fall<T: Scalar> {
    linear: Linear<T::Real>,
    /// −∂(M a)/∂q, and its symmetric part.
    stiffness: Matrix<T::Real>,
    symmetric: Matrix<T::Real>,
    /// The inertia D that steps are damped by.
    metric: Matrix<T::Real>,
    /// M a.
    force: Vec<T>,
    /// The size of accelerations that a displacement of one radian causes, or of those there are.
    pub(super) scale: T::Real,
}

/// A step towards rest.
pub(super) struct Step<T: Scalar> {
    /// Displacements of all coordinates (rad, m).
    pub(super) displacement: Vec<T>,
    /// The largest displacement (rad, m).
    pub(super) size: T::Real,
    /// All displacements together (rad, m): no body turns further, however many joints turn it.
    pub(super) way: T::Real,
}

impl<T: Scalar> Step<T> {
    /// This step or, if that is too long, one as long as may be in its direction.
    pub(super) fn within(mut self, longest: T::Real) -> Option<Self> {
        if self.size > longest {
            let share = longest / self.size;
            if share * T::Real::of(FAR) < T::Real::one() {
                return None;
            }
            self.displacement.iter_mut().for_each(|x| *x = x.scale(share));
            self.size = longest;
            self.way *= share;
        }
        Some(self)
    }
}

impl<T: Scalar> Fall<T> {
    pub(super) fn of(linear: Linear<T::Real>, [inertial, metric]: [Matrix<T::Real>; 2], acceleration: &[T]) -> Self {
        let (one, mass) = (T::Real::one(), linear.root.gram());
        let stiffness = mass.times(&linear.response).plus(one, &inertial).scaled(-one);
        let symmetric = stiffness.plus(one, &stiffness.transposed()).scaled(T::Real::of(0.5));
        let force = mass.apply(&linear.tangent.components(acceleration));
        let most = acceleration.iter().fold(T::Real::zero(), |most, x| most.max(x.real().abs()));
        let scale = linear.response.norm() + most;
        Self { linear, stiffness, symmetric, metric, force, scale }
    }

    /// Whether nothing but rounding pulls: accelerations are rounding, or, of light coordinates between large forces, forces are.
    pub(super) fn settled(&self, acceleration: T::Real) -> bool {
        let limit = self.scale * T::Real::of(64.0) * T::Real::EPSILON;
        let small = |(j, force): (usize, &T)| force.real().abs() <= limit * self.metric.get(j, j);
        acceleration <= limit || self.force.iter().enumerate().all(small)
    }

    /// Newton's step; none where the matrix is singular or, if that is asked for, not definite.
    pub(super) fn newton(&self, definite: bool) -> Option<Step<T>> {
        // Stiffness that may as well be rounding resists nothing.
        let margin = self.scale * T::Real::EPSILON * T::Real::of(16.0);
        if definite && !self.stiffness.plus(-margin, &self.metric).is_definite() {
            return None;
        }
        self.step(&Factors::of(self.stiffness.clone())?.solve(&self.force))
    }

    /// Directions in which stiffness and inertia are independent. Of stiffness without a potential they leave out what would only lead astray from afar.
    pub(super) fn principal(&self) -> Option<Principal<T::Real>> {
        Principal::of(&self.symmetric, &self.metric)
    }

    /// The step downhill, no longer along any direction than a stiffness μ would let it.
    pub(super) fn damped(&self, principal: &Principal<T::Real>, damping: T::Real) -> Option<Step<T>> {
        self.step(&principal.step(&self.force, damping))
    }

    /// Whether stiffness pushes on from here along some direction, more than rounding would.
    pub(super) fn falls_away(&self, principal: &Principal<T::Real>) -> bool {
        principal.lowest().0 < -self.scale * T::Real::EPSILON.powf(T::Real::of(ROUNDED))
    }

    /// A step along directions that are open; none if it is no number.
    fn step(&self, along: &[T]) -> Option<Step<T>> {
        let displacement = self.linear.tangent.vector(along);
        let (mut size, mut way) = (T::Real::zero(), T::Real::zero());
        for x in &displacement {
            if !x.is_finite() {
                return None;
            }
            (size, way) = (size.max(x.real().abs()), way + x.real().abs());
        }
        Some(Step { displacement, size, way })
    }

    /// Whether forces have a potential, as far as their stiffness says.
    pub(super) fn has_potential(&self) -> bool {
        let asymmetry = self.stiffness.plus(-T::Real::one(), &self.symmetric).norm();
        asymmetry <= differenced::<T::Real>() * self.stiffness.norm()
    }

    /// A displacement of size one in the direction in which stiffness pushes on most.
    pub(super) fn away(&self, principal: &Principal<T::Real>) -> Vec<T> {
        let displacement = self.linear.tangent.vector(principal.lowest().1);
        let size = displacement.iter().fold(T::Real::zero(), |most, x| most.max(x.abs()));
        displacement.iter().map(|x| T::constant(*x * size.recip())).collect()
    }
}
