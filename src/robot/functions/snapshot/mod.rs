//! A robot at an instant, on a base that is fixed or floats: what is asked of its motion, its inertia and its parameters.

mod blocks;
mod dynamics;
mod factor;
mod massive;
mod partials;
mod regressor;
mod screws;

pub use blocks::Blocks;
pub use dynamics::MassMatrix;
pub(super) use factor::{Factor, Floating, inverted};
pub(super) use partials::Moved;
pub use regressor::Regressor;

use super::{FixedBase, Resisting, S, Tasks, checked, finite, resisting};
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mechanics::spatial::body_axes::Place;
use crate::mechanics::spatial::body_axes::places::Places;
use crate::mechanics::spatial::body_axes::solids::{Parameters, Solids};
use crate::mechanics::spatial::{BodyMotion, Frame, Free};
use crate::relation::spatial::algebra::{Columns, add_scaled, centripetal, cross, zero};
use crate::scalar::Scalar;
use crate::shape::Takes;
use crate::system::System;
use nalgebra::Vector3;
use num_traits::Zero;

/// Where a base is that floats, and how it moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Afloat<T> {
    /// Place and attitude of the base.
    pub place: Place<T>,
    /// Velocity of its origin (m/s), inertial axes.
    pub velocity: Vector3<T>,
    /// Angular velocity (rad/s), axes of the base.
    pub spin: Vector3<T>,
}

impl<T: Scalar> Afloat<T> {
    /// As a body moves: the first of a scene, by [`System::body_motions`].
    pub fn of(body: &BodyMotion<T>) -> Self {
        let Frame { place, velocity, turn, .. } = body.inboard;
        let spin = turn.attitude.transposed(turn.spin);
        Self { place: Place { place, attitude: turn.attitude }, velocity, spin }
    }
}

/// A body at an instant, in inertial axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moving<T> {
    place: Place<T>,
    velocity: Vector3<T>,
    spin: Vector3<T>,
    /// In its own axes.
    parameters: Parameters<T>,
}

/// Six numbers for each coordinate: of the base (its velocity in inertial axes, its angular velocity in its own), and of the joints. For a
/// robot whose base is fixed the former are what a motion of its base would do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SixRows<T, const N: usize> {
    /// Of the base.
    pub base: [[T; 6]; 6],
    /// Of the joints.
    pub joints: [[T; 6]; N],
}

/// A robot at an instant: one walk finds where all bodies are and how they move, and each question is answered from that in inertial axes,
/// in time proportional to the number of joints, or to that of the numbers that it gives. Nothing allocates.
///
/// Functions of the scene itself ([`System::forward_dynamics`], [`System::mass_matrix_afloat`] and so on) are faster where there is one. Velocities
/// of a base that floats are those of its origin in inertial axes, and its angular velocity in its own, as scenes have them.
///
/// ```
/// use catena::robot::*;
/// let link = Link::general(3.0_f64, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
/// let legs = [Branch((Hinge::at::<7>([0.3, 0.2, -0.1]), link)), Branch((Hinge::at::<7>([-0.3, 0.2, -0.1]), link))];
/// let robot = System::new(Free, (BodyAxes, link, legs), Free)?.with_gravity([0.0, 0.0, -9.81]);
/// let start = robot.motion();
/// let base = Afloat::of(robot.body_motions(&start)?.get(0).unwrap());
/// let now = robot.snapshot_afloat(base, &[0.3, -0.2], &[1.0, 0.5])?;
/// let (centre, mass) = now.mass_centre();
/// let [momentum, angular] = now.centroidal_momentum(); // (kg·m/s, N·m·s), about the mass centre
/// // What holds it in the air: a force on the base, a torque, and torques in the joints.
/// let (wrench, torques) = now.inverse_dynamics(&[0.0; 6], &[0.0; 2]);
/// assert!((wrench[2] - 9.81 * mass).abs() < 10.0);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snapshot<T, const N: usize> {
    base: Moving<T>,
    bodies: [Moving<T>; N],
    parents: [usize; N],
    slides: [bool; N],
    rates: [T; N],
    /// Forces of the joints' laws, and reflected inertias.
    laws: [T; N],
    inertias: [T; N],
    /// Acceleration of the ground that carries a fixed base, and its angular acceleration, less gravity.
    carried: [Vector3<T>; 2],
    gravity: Vector3<T>,
}

impl<T: Scalar, R: Root<S<T>>, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, R, C, P> {
    fn seen<const N: usize>(
        &self,
        Afloat { place, velocity, spin }: Afloat<T>,
        [linear, angular]: [Vector3<T>; 2],
        q: &[T; N],
        v: &[T; N],
    ) -> Result<Snapshot<T, N>, Error>
    where
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        let Columns { x, y, z } = place.attitude;
        for vector in [place.place, x, y, z, velocity, spin, linear, angular] {
            finite(vector.as_slice())?;
        }
        finite(q).and(finite(v))?;
        let chain = self.chain();
        let Resisting { stands, laws, inertias, .. } = resisting(chain, q, v);
        let mut walk = Places { stands, places: [place; N], parents: [usize::MAX; N], slides: [false; N], next: 0 };
        Takes::<S<T>, Places<T, N>>::take(chain, &mut walk, (place, usize::MAX), ());
        let Places { places, parents, slides, .. } = walk;
        let mut solids = Solids { base: [T::zero(); 10], bodies: [[T::zero(); 10]; N], next: 0 };
        Takes::<S<T>, Solids<T, N>>::take(chain, &mut solids, usize::MAX, ());
        let spin = place.attitude.apply(spin);
        let base = Moving { place, velocity, spin, parameters: solids.base };
        let (mut bodies, rates, carried) = ([base; N], *v, [linear - self.gravity(), angular]);
        for k in 0..N {
            let parent = bodies.get(parents[k]).copied().unwrap_or(base);
            let (place, axis, rate) = (places[k], places[k].attitude.z, rates[k]);
            let swung = parent.velocity + cross(parent.spin, place.place - parent.place.place);
            let (velocity, spin) = match slides[k] {
                true => (add_scaled(swung, rate, axis), parent.spin),
                false => (swung, add_scaled(parent.spin, rate, axis)),
            };
            bodies[k] = Moving { place, velocity, spin, parameters: solids.bodies[k] };
        }
        Ok(Snapshot { base, bodies, parents, slides, rates, laws, inertias, carried, gravity: self.gravity() })
    }

    /// A robot whose base is fixed, at positions and rates of its joints.
    ///
    /// # Errors
    /// [`Fault::Count`] where `N` is not the number of joints, [`Fault::NonFiniteMotion`] for numbers that are not finite.
    pub fn snapshot<const N: usize>(&self, q: &[T; N], v: &[T; N]) -> Result<Snapshot<T, N>, Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        let ground = self.ground(T::Real::zero());
        let Frame { place, velocity, turn, acceleration } = ground;
        let spin = turn.attitude.transposed(turn.spin);
        let base = Afloat { place: Place { place, attitude: turn.attitude }, velocity, spin };
        self.seen(base, [acceleration.linear, acceleration.angular], q, v)
    }
}

impl<T: Scalar, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, Free, C, P> {
    /// A robot whose base floats, at positions and rates of its joints.
    ///
    /// # Errors
    /// [`Fault::Count`] where `N` is not the number of joints, [`Fault::NonFiniteMotion`] for numbers that are not finite,
    /// [`Fault::NotZero`] for a base whose axes are not orthonormal and right-handed.
    pub fn snapshot_afloat<const N: usize>(
        &self,
        base: Afloat<T>,
        q: &[T; N],
        v: &[T; N],
    ) -> Result<Snapshot<T, N>, Error>
    where
        C: Tasks<T, N>,
    {
        checked(&base.place)?;
        self.seen(base, [zero(); 2], q, v)
    }
}

/// A vector and another one as six numbers.
pub(super) fn six<T: Scalar>([a, b]: [Vector3<T>; 2]) -> [T; 6] {
    [a.x, a.y, a.z, b.x, b.y, b.z]
}

/// Unit vectors.
fn units<T: Scalar>() -> [Vector3<T>; 3] {
    let Columns { x, y, z } = Columns::identity();
    [x, y, z]
}

impl<T: Scalar, const N: usize> Snapshot<T, N> {
    fn body(&self, joint: Option<usize>) -> Result<&Moving<T>, Error> {
        let Some(joint) = joint else { return Ok(&self.base) };
        self.bodies.get(joint).ok_or_else(|| Error::new(Fault::NoSuchJoint { joint, joints: N }))
    }

    /// The joint inboard of each.
    pub(super) fn parents(&self) -> &[usize; N] {
        &self.parents
    }

    fn parent(&self, joint: usize) -> &Moving<T> {
        self.bodies.get(self.parents[joint]).unwrap_or(&self.base)
    }

    /// Axes of the base.
    fn axes(&self) -> [Vector3<T>; 3] {
        let Columns { x, y, z } = self.base.place.attitude;
        [x, y, z]
    }

    /// Place (m) and velocity (m/s) of a point (m, axes of its body) of the body on a joint, or of the base.
    ///
    /// # Errors
    /// [`Fault::NoSuchJoint`] for the number of no joint.
    pub fn point(&self, joint: Option<usize>, point: [T; 3]) -> Result<[Vector3<T>; 2], Error> {
        let body = self.body(joint)?;
        let arm = body.place.attitude.apply(Vector3::from(point));
        Ok([body.place.place + arm, body.velocity + cross(body.spin, arm)])
    }

    /// The Jacobian of a point (m, axes of its body) of the body on a joint, or of the base: velocity (m/s) of the point and angular velocity
    /// (rad/s) of the body, inertial axes, for a rate of one.
    ///
    /// # Errors
    /// [`Fault::NoSuchJoint`] for the number of no joint.
    pub fn jacobian(&self, joint: Option<usize>, point: [T; 3]) -> Result<SixRows<T, N>, Error> {
        let [place, _] = self.point(joint, point)?;
        let none = zero();
        let mut rows = SixRows { base: [[T::zero(); 6]; 6], joints: [[T::zero(); 6]; N] };
        let (unit, axes, from) = (units(), self.axes(), place - self.base.place.place);
        for k in 0..3 {
            rows.base[k] = six([unit[k], none]);
            rows.base[3 + k] = six([cross(axes[k], from), axes[k]]);
        }
        let mut next = joint.unwrap_or(usize::MAX);
        while let Some(body) = self.bodies.get(next) {
            let n = body.place.attitude.z;
            let turning = [cross(n, place - body.place.place), n];
            rows.joints[next] = six(if self.slides[next] { [n, none] } else { turning });
            next = self.parents[next];
        }
        Ok(rows)
    }

    /// How fast the [Jacobian](Self::jacobian) changes: the acceleration of the point is J q̈ + J̇ q̇.
    ///
    /// # Errors
    /// [`Fault::NoSuchJoint`] for the number of no joint.
    pub fn jacobian_rate(&self, joint: Option<usize>, point: [T; 3]) -> Result<SixRows<T, N>, Error> {
        let [place, velocity] = self.point(joint, point)?;
        let none = zero();
        let mut rows = SixRows { base: [[T::zero(); 6]; 6], joints: [[T::zero(); 6]; N] };
        // ṅ × r + n × ṙ of an axis that turns with its body.
        let changing = |n: Vector3<T>, body: &Moving<T>| {
            let (turned, from, away) = (cross(body.spin, n), place - body.place.place, velocity - body.velocity);
            [cross(turned, from) + cross(n, away), turned]
        };
        for (k, axis) in self.axes().into_iter().enumerate() {
            rows.base[3 + k] = six(changing(axis, &self.base));
        }
        let mut next = joint.unwrap_or(usize::MAX);
        while let Some(body) = self.bodies.get(next) {
            let n = body.place.attitude.z;
            rows.joints[next] = six(if self.slides[next] { [cross(body.spin, n), none] } else { changing(n, body) });
            next = self.parents[next];
        }
        Ok(rows)
    }

    /// Acceleration (m/s²) of a point (m, axes of its body) of the body on a joint, or of the base, and angular acceleration (rad/s²) of the body,
    /// inertial axes, for accelerations of the base as [`inverse_dynamics`](Self::inverse_dynamics) has them and of the joints: J q̈ + J̇ q̇.
    ///
    /// # Errors
    /// [`Fault::NoSuchJoint`] for the number of no joint.
    pub fn point_acceleration(
        &self,
        joint: Option<usize>,
        point: [T; 3],
        base: &[T; 6],
        seconds: &[T; N],
    ) -> Result<[Vector3<T>; 2], Error> {
        let body = self.body(joint)?;
        let (of_base, all) = self.accelerations(base, seconds);
        let [felt, angular] = joint.map_or(of_base, |joint| all[joint]);
        let arm = body.place.attitude.apply(Vector3::from(point));
        Ok([felt + self.gravity + cross(angular, arm) + centripetal(body.spin, arm), angular])
    }

    /// Accelerations of all bodies' origins, as felt (less gravity), and of the bodies.
    fn accelerations(&self, base: &[T; 6], seconds: &[T; N]) -> ([Vector3<T>; 2], [[Vector3<T>; 2]; N]) {
        let [ax, ay, az, bx, by, bz] = *base;
        let angular = self.base.place.attitude.apply(Vector3::new(bx, by, bz));
        let [felt, carried] = self.carried;
        let base = [Vector3::new(ax, ay, az) + felt, angular + carried];
        let mut all = [base; N];
        for k in 0..N {
            let (parent, [a, angular]) = (self.parent(k), all.get(self.parents[k]).copied().unwrap_or(base));
            let (axis, rate) = (self.bodies[k].place.attitude.z, self.rates[k]);
            let arm = self.bodies[k].place.place - parent.place.place;
            let carried = a + cross(angular, arm) + centripetal(parent.spin, arm);
            let swept = cross(parent.spin, axis);
            all[k] = match self.slides[k] {
                true => [add_scaled(add_scaled(carried, rate + rate, swept), seconds[k], axis), angular],
                false => [carried, add_scaled(add_scaled(angular, rate, swept), seconds[k], axis)],
            };
        }
        (base, all)
    }
}
