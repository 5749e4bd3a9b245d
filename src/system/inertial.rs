//! Kinetic energy of bodies as sums of squares, and what the ground carries.

use crate::element::{RealOf, Space};
use crate::mechanics::planar::{self, Planar};
use crate::mechanics::spatial::{self, Spatial};
use crate::scalar::{Elementary, Real, Scalar};
use crate::space::FrameOf;
use nalgebra::Vector3;
use num_traits::Zero;

/// A space in which the kinetic energy of a body is half a sum of squares.
pub trait Inertial: Space {
    /// Notes velocities of a body times the roots of what resists them, so that their squares add up to twice its kinetic
    /// energy.
    fn weighted(body: &Self::BodyMotion, note: &mut impl FnMut(RealOf<Self>));
    /// Notes rates of a joint's coordinates times the roots of their reflected inertias, √I q̇, where there are any.
    fn reflected(joint: &Self::JointMotion, note: &mut impl FnMut(RealOf<Self>));
    /// The motion of the inboard end of a body.
    fn inboard(body: &Self::BodyMotion) -> FrameOf<Self>;
    /// Velocity and momentum of a body.
    fn carried(body: &Self::BodyMotion) -> Carried<RealOf<Self>>;
}

/// Velocity and momentum of a body, inertial axes (in the plane with z across it).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carried<R> {
    /// Velocity of the mass centre (m/s).
    pub velocity: Vector3<R>,
    /// Angular velocity (rad/s).
    pub spin: Vector3<R>,
    /// Momentum (N·s).
    pub momentum: Vector3<R>,
    /// Angular momentum about the mass centre (N·m·s).
    pub angular: Vector3<R>,
}

impl<R: Real> Carried<R> {
    /// Takes away what another one is.
    #[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
    pub(crate) fn less(&mut self, other: Self) {
        self.velocity -= other.velocity;
        self.spin -= other.spin;
        self.momentum -= other.momentum;
        self.angular -= other.angular;
    }
}

impl<T: Scalar> Inertial for Planar<T> {
    fn weighted(body: &planar::BodyMotion<T>, note: &mut impl FnMut(T::Real)) {
        // A moment of inertia may be negative by rounding.
        let root = |x: T| x.real().max(T::Real::zero()).sqrt();
        let (mass, about_centre) = (root(body.inertia.mass), root(body.inertia.about_centre));
        let velocity = body.centre().velocity;
        note(mass * velocity.x.real());
        note(mass * velocity.y.real());
        note(about_centre * body.rate().real());
    }

    fn reflected(joint: &planar::JointMotion<T>, note: &mut impl FnMut(T::Real)) {
        let inertia = joint.inertia.real();
        if inertia > T::Real::zero() {
            note(inertia.sqrt() * joint.driven_rate().real());
        }
    }

    fn inboard(body: &planar::BodyMotion<T>) -> planar::Frame<T> {
        body.inboard
    }

    fn carried(body: &planar::BodyMotion<T>) -> Carried<T::Real> {
        let zero = T::Real::zero();
        let centre = body.centre().velocity;
        let (velocity, spin) =
            (Vector3::new(centre.x.real(), centre.y.real(), zero), Vector3::new(zero, zero, body.rate().real()));
        let [mass, about_centre] = [body.inertia.mass, body.inertia.about_centre].map(|x| x.real());
        Carried { velocity, spin, momentum: velocity * mass, angular: spin * about_centre }
    }
}

impl<T: Scalar> Inertial for Spatial<T> {
    fn weighted(body: &spatial::BodyMotion<T>, note: &mut impl FnMut(T::Real)) {
        let mass = body.inertia.mass.real().max(T::Real::zero()).sqrt();
        body.centre().velocity.iter().for_each(|v| note(mass * v.real()));
        // J = L Lᵀ, column by column; what has no moment about an axis (or less than none, by rounding) has no column.
        let mut rest = body.inertia.about_centre.map(|row| row.map(|x| x.real()));
        let spin = body.rate().map(|x| x.real());
        for k in 0..3 {
            let mut column = [T::Real::zero(); 3];
            if rest[k][k] > T::Real::zero() {
                let inverse = rest[k][k].sqrt().recip();
                (k..3).for_each(|i| column[i] = rest[i][k] * inverse);
            }
            for i in k..3 {
                (k..3).for_each(|j| rest[i][j] -= column[i] * column[j]);
            }
            note((k..3).fold(T::Real::zero(), |sum, i| sum + column[i] * spin[i]));
        }
    }

    fn reflected(joint: &spatial::JointMotion<T>, note: &mut impl FnMut(T::Real)) {
        for (inertia, rate) in joint.inertia.iter().zip(joint.rate).map(|(inertia, rate)| (inertia.real(), rate.real()))
        {
            if inertia > T::Real::zero() {
                note(inertia.sqrt() * rate);
            }
        }
    }

    fn inboard(body: &spatial::BodyMotion<T>) -> spatial::Frame<T> {
        body.inboard
    }

    fn carried(body: &spatial::BodyMotion<T>) -> Carried<T::Real> {
        let rate = body.rate();
        let own = body.inertia.about_centre.map(|row| (0..3).fold(T::zero(), |sum, i| sum + row[i] * rate[i]));
        let [spin, angular] = [rate, own].map(|of_body| body.turned(of_body).map(|x| x.real()));
        let velocity = body.centre().velocity.map(|x| x.real());
        Carried { velocity, spin, momentum: velocity * body.inertia.mass.real(), angular }
    }
}
