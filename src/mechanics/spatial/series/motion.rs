//! Taylor series in space: the motion of a body, as laws of loads see it.

use super::rods::scaled;
use crate::mechanics::spatial::{Acceleration, BodyMotion, Frame, Inertia, Internal, Spatial, Turn};
use crate::relation::spatial::algebra::{Columns, cross_onto, zero};
use crate::scalar::{Powers, Real, Scalar};
use crate::series::ExpandBody;
use nalgebra::Vector3;

/// What turns with a body: (k + 1) v_{k+1} = Σ ω_j × v_{k−j}.
fn turning<T: Scalar, const N: usize>(first: Vector3<T>, spins: &[Vector3<T>]) -> Vector3<Powers<T, N>> {
    let mut terms = [zero(); N];
    if let Some(place) = terms.first_mut() {
        *place = first;
    }
    for k in 0..spins.len().min(N).saturating_sub(1) {
        let sum = (0..=k).fold(zero(), |sum, j| cross_onto(spins[j], terms[k - j], sum));
        terms[k + 1] = scaled(sum, T::Real::of(1.0 / (k + 1) as f64));
    }
    entries(&terms[..spins.len().min(N)])
}

/// The entries of vectors as series.
fn entries<T: Scalar, const N: usize>(terms: &[Vector3<T>]) -> Vector3<Powers<T, N>> {
    Vector3::from_fn(|i, _| Powers::polynomial(terms.len(), terms.len(), |k| terms[k][i]))
}

/// A vector of which the first value is known, and the slope.
fn integral<T: Scalar, const N: usize>(first: Vector3<T>, slope: Vector3<Powers<T, N>>) -> Vector3<Powers<T, N>> {
    Vector3::from_fn(|i, _| Powers::integral(first[i], slope[i]))
}

impl<T: Scalar, const N: usize> ExpandBody<N> for Spatial<T> {
    fn body_series(
        start: &BodyMotion<T>,
        accelerations: &[Acceleration<T>],
        gravity: Vector3<T>,
    ) -> BodyMotion<Powers<T, N>> {
        let BodyMotion { inboard, arm, inertia: Inertia { mass, centre, about_centre }, .. } = *start;
        let count = N.min(accelerations.len() + 1);
        let (mut velocities, mut spins) = ([inboard.velocity; N], [inboard.turn.spin; N]);
        for (k, Acceleration { linear, angular }) in accelerations.iter().take(count - 1).enumerate() {
            let share = T::Real::of(1.0 / (k + 1) as f64);
            let falling = if k == 0 { *linear + gravity } else { *linear };
            (velocities[k + 1], spins[k + 1]) = (scaled(falling, share), scaled(*angular, share));
        }
        let (velocity, spins) = (entries(&velocities[..count]), &spins[..count]);
        let attitude = inboard.turn.attitude;
        let turned =
            Columns { x: turning(attitude.x, spins), y: turning(attitude.y, spins), z: turning(attitude.z, spins) };
        let frame = Frame {
            place: integral(inboard.place, velocity),
            velocity,
            turn: Turn { attitude: turned, spin: entries(spins) },
            acceleration: Acceleration::zero(),
        };
        let inertia = Inertia {
            mass: Powers::of(mass),
            centre: centre.map(Powers::of),
            about_centre: about_centre.map(|row| row.map(Powers::of)),
        };
        let mut motion = BodyMotion { inboard: frame, arm: velocity, to_centre: velocity, inertia };
        motion.arm = motion.turned(<[T; 3]>::from(attitude.transposed(arm)).map(Powers::of));
        motion.to_centre = motion.turned(inertia.centre);
        motion
    }

    fn terms(load: Internal<Powers<T, N>>) -> [Internal<T>; N] {
        let vectors = |v: Vector3<Powers<T, N>>| <[_; 3]>::from(v).map(Powers::terms);
        let ([x, y, z], [u, v, w]) = (vectors(load.force), vectors(load.torque));
        core::array::from_fn(|k| Internal {
            force: Vector3::new(x[k], y[k], z[k]),
            torque: Vector3::new(u[k], v[k], w[k]),
        })
    }
}
