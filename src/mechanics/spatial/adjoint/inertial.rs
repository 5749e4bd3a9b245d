//! Base parameters of bodies in space, and what inertia does to the virtual power.
//!
//! The point mass at O is a matter of the way to O ([`bodies`](super::bodies)). What is left is the first moment σ and the inertia tensor J,
//! both about I: with ω, α and w of the body and W, A of I
//!
//! ```text
//! P = W·(α × σ + ω × (ω × σ)) + w·(σ × A) + w·(J α + ω × J ω)
//! ```
//!
//! For a rod σ = 0 and J = J⊥ 1 + (J∥ − J⊥) x xᵀ, so that J⊥ has no part in ω × J ω.

use super::{OnBody, Pulled, Turning};
use crate::mechanics::spatial::body::{Body, Pose};
use crate::mechanics::spatial::{PointMass, RigidBody, Rod};
use crate::relation::spatial::algebra::{Symmetric3, add_scaled, cross, cross_onto, dot, dot_onto};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// Base parameters of a body in body axes, or costates of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Base<T> {
    /// The outboard end (m).
    pub outboard: [T; 3],
    /// First moment about the inboard end of what is not lumped (kg·m).
    pub moment: [T; 3],
    /// Inertia tensor about the inboard end of what is not lumped (kg·m²): xx, xy, xz, yy, yz, zz. Of a rod the moment across, then that
    /// along its axis.
    pub inertia: [T; 6],
    /// Point mass at the outboard end (kg).
    pub lumped: T,
}

impl<T: Scalar> Base<T> {
    /// Nothing.
    pub fn null() -> Self {
        let o = T::zero();
        Self { outboard: [o; 3], moment: [o; 3], inertia: [o; 6], lumped: o }
    }
}

/// What P has to do with an arm: F, G and the two vectors that they meet, w × d and α × d + ω × (ω × d).
pub struct Arm<T> {
    /// w × d.
    pub stirred: Vector3<T>,
    /// α × d + ω × (ω × d).
    pub moved: Vector3<T>,
    /// F at O, point mass included.
    pub force: Vector3<T>,
    /// G at O, point mass included.
    pub momentum: Vector3<T>,
    /// A of O.
    pub acceleration: Vector3<T>,
}

/// A body as the costate sweep meets it.
pub trait Inertial<T: Scalar>: Body<T> {
    /// Base parameters.
    fn base(&self) -> Base<T>;

    /// Point mass at the outboard end.
    fn lumped(&self) -> T;

    /// Adds what the body has besides its point mass to what is carried, which has reached I, and to costates of parameters.
    fn pull_back(
        &self,
        pose: &Pose<T>,
        arm: Arm<T>,
        met: &OnBody<T>,
        carried: Pulled<T>,
        sums: &mut Base<T>,
    ) -> Pulled<T>;
}

/// Adds ∂/∂ω of p · (ω × (ω × d)): d (ω·p) + p (ω·d) − 2 ω (d·p).
#[inline(always)]
pub fn swept<T: Scalar>(spin: Vector3<T>, d: Vector3<T>, p: Vector3<T>, sum: Vector3<T>) -> Vector3<T> {
    let across = dot(d, p);
    add_scaled(add_scaled(add_scaled(sum, dot(spin, p), d), dot(spin, d), p), -(across + across), spin)
}

/// ∂P/∂d of a vector d of the body whose acceleration α × d + ω × (ω × d) meets p, and whose virtual velocity w × d meets q.
#[cfg_attr(optimised, inline(always))]
pub fn per_vector<T: Scalar>(turning: &Turning<T>, p: Vector3<T>, q: Vector3<T>) -> Vector3<T> {
    let Turning { spin, acceleration, stirring } = *turning;
    let centripetal = add_scaled(spin * dot(spin, p), -dot(spin, spin), p);
    cross_onto(p, acceleration, cross_onto(q, stirring, centripetal))
}

impl<T: Scalar> Turning<T> {
    /// What inertia adds to M, H and Ω where the body turns so, J α + ω × J ω, J w and J ω × w + J (w × ω), and to costates of its numbers,
    /// all in axes of the body.
    #[cfg_attr(optimised, inline(always))]
    pub fn pull_inertia(&self, inertia: &Symmetric3<T>, sums: &mut [T; 6]) -> [Vector3<T>; 3] {
        let Self { spin, acceleration, stirring } = *self;
        let gyration = cross(stirring, spin);
        let outer = |i: usize, j: usize| stirring[i].mul_add(acceleration[j], gyration[i] * spin[j]);
        for (sum, (i, j)) in sums.iter_mut().zip([(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)]) {
            *sum -= if i == j { outer(i, i) } else { outer(i, j) + outer(j, i) };
        }
        let spinning = inertia.apply(spin);
        let torque = cross_onto(spin, spinning, inertia.apply(acceleration));
        [torque, inertia.apply(stirring), cross_onto(spinning, stirring, inertia.apply(gyration))]
    }
}

/// F·(w × d) + G·(α × d + ω × (ω × d)), which is d · ∂P/∂d.
#[inline(always)]
fn along_arm<T: Scalar>(arm: &Arm<T>) -> T {
    dot_onto(arm.force, arm.stirred, dot(arm.momentum, arm.moved))
}

impl<T: Scalar> Inertial<T> for Rod<T> {
    fn base(&self) -> Base<T> {
        let (o, none) = (T::zero(), Base::null());
        let inertia = [self.rest, self.axial, o, o, o, o];
        Base { outboard: [self.length, o, o], inertia, lumped: self.lumped, ..none }
    }
    #[inline(always)]
    fn lumped(&self) -> T {
        self.lumped
    }
    #[cfg_attr(optimised, inline(always))]
    fn pull_back(
        &self,
        pose: &Pose<T>,
        arm: Arm<T>,
        met: &OnBody<T>,
        carried: Pulled<T>,
        sums: &mut Base<T>,
    ) -> Pulled<T> {
        let Turning { spin, acceleration, stirring } = met.turning;
        let (d, excess) = (pose.arm, self.excess);
        let gyration = cross(stirring, spin);
        let (turns, around) = (dot(d, spin), dot(d, gyration));
        let (swings, stirs) = (dot(d, acceleration), dot(d, stirring));
        let across = dot(stirring, acceleration);
        let share = self.length.recip();
        // (x·w)(x·α) + (x·ω) x·(w × ω)
        let axial = stirs.mul_add(swings, turns * around) * (share * share);
        sums.inertia[0] += axial - across;
        sums.inertia[1] -= axial;
        sums.outboard[0] -= along_arm(&arm) * share;
        // J α + ω × J ω, J w, J ω × w + J (w × ω).
        let torque = add_scaled(carried.torque, self.rest, acceleration);
        let torque = add_scaled(add_scaled(torque, excess * swings, d), excess * turns, cross(spin, d));
        let angular = add_scaled(add_scaled(carried.angular, self.rest, stirring), excess * stirs, d);
        let turned = add_scaled(carried.spin, excess * around, d);
        Pulled { torque, angular, spin: add_scaled(turned, -(excess * turns), arm.stirred), ..carried }
    }
}

impl<T: Scalar> Inertial<T> for PointMass<T> {
    fn base(&self) -> Base<T> {
        let (o, none) = (T::zero(), Base::null());
        Base { outboard: [self.length, o, o], lumped: self.lumped, ..none }
    }
    #[inline(always)]
    fn lumped(&self) -> T {
        self.lumped
    }
    #[inline(always)]
    fn pull_back(&self, _: &Pose<T>, arm: Arm<T>, _: &OnBody<T>, carried: Pulled<T>, sums: &mut Base<T>) -> Pulled<T> {
        sums.outboard[0] -= along_arm(&arm) * self.length.recip();
        carried
    }
}

impl<T: Scalar> Inertial<T> for RigidBody<T> {
    fn base(&self) -> Base<T> {
        let Symmetric3 { xx, xy, xz, yy, yz, zz } = self.about_inboard;
        let inertia = [xx, xy, xz, yy, yz, zz];
        Base { outboard: Body::outboard(self), moment: self.moment, inertia, lumped: self.lumped }
    }
    #[inline(always)]
    fn lumped(&self) -> T {
        self.lumped
    }
    #[cfg_attr(optimised, inline(always))]
    fn pull_back(
        &self,
        pose: &Pose<T>,
        arm: Arm<T>,
        met: &OnBody<T>,
        carried: Pulled<T>,
        sums: &mut Base<T>,
    ) -> Pulled<T> {
        let OnBody { velocity, turning } = met;
        let Turning { spin, acceleration, stirring } = *turning;
        let axes = &pose.attitude;
        let take = |sum: &mut [T; 3], v: Vector3<T>| *sum = (Vector3::from(*sum) - axes.transposed(v)).into();
        take(&mut sums.outboard, per_vector(turning, arm.momentum, arm.force));
        // First moment.
        let (w, a) = (velocity - arm.stirred, arm.acceleration - arm.moved);
        take(&mut sums.moment, per_vector(turning, w, a));
        let moment = axes.apply(Vector3::from(self.moment));
        let moved = cross_onto(acceleration, moment, cross(spin, cross(spin, moment)));
        let stirred = cross(stirring, moment);
        // Inertia tensor, in body axes.
        let met = turning.mapped(|v| axes.transposed(v));
        let [torque, angular, turned] = met.pull_inertia(&self.about_inboard, &mut sums.inertia);
        Pulled {
            momentum: carried.momentum + stirred,
            force: carried.force + moved,
            turn: cross_onto(w, moved, cross_onto(a, stirred, carried.turn)),
            torque: cross_onto(moment, a, axes.apply_onto(torque, carried.torque)),
            angular: cross_onto(moment, w, axes.apply_onto(angular, carried.angular)),
            spin: swept(spin, moment, w, axes.apply_onto(turned, carried.spin)),
        }
    }
}
