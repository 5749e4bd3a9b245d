//! Inverse dynamics, mass matrix, mass centre and momentum of a robot at an instant.

use super::massive::Inertial;
use super::screws::{Pair, along};
use super::{Moving, SixRows, Snapshot, six, units};
use crate::mechanics::spatial::body_axes::Place;
use crate::relation::spatial::algebra::{Columns, centripetal, cross, dot, zero};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// The mass matrix of a robot: of the base, between base and joints, and of the joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassMatrix<T, const N: usize> {
    /// Of the base, for its velocity in inertial axes and its angular velocity in its own.
    pub base: [[T; 6]; 6],
    /// Force and torque on the base for the acceleration of each joint.
    pub coupling: [[T; 6]; N],
    /// Of the joints, with reflected inertias.
    pub joints: [[T; N]; N],
}

impl<T: Scalar, const N: usize> MassMatrix<T, N> {
    /// Zeros.
    #[inline(always)]
    pub fn zero() -> Self {
        let o = T::zero();
        Self { base: [[o; 6]; 6], coupling: [[o; 6]; N], joints: [[o; N]; N] }
    }
}

impl<T: Scalar, const N: usize> Snapshot<T, N> {
    /// What a force and a torque about the origin of the body on a joint are along the joint.
    pub(super) fn along(&self, joint: usize, [force, torque]: [Vector3<T>; 2]) -> T {
        dot(self.bodies[joint].place.attitude.z, if self.slides[joint] { force } else { torque })
    }

    /// From the parent's origin to the body's.
    pub(super) fn arm(&self, joint: usize) -> Vector3<T> {
        self.bodies[joint].place.place - self.parent(joint).place.place
    }

    /// Force (inertial axes) and torque (axes of the base) on the base.
    pub(super) fn on_base(&self, [force, torque]: [Vector3<T>; 2]) -> [T; 6] {
        six([force, self.base.place.attitude.transposed(torque)])
    }

    /// Twist of what a joint carries for a rate of one.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn unit(&self, joint: usize) -> Pair<T> {
        let Place { place, attitude } = &self.bodies[joint].place;
        let axis = attitude.z;
        if self.slides[joint] { [axis, zero()] } else { [cross(*place - self.base.place.place, axis), axis] }
    }

    /// What accelerations take, with gravity: a force on the base (N, inertial axes) and a torque about its origin (N·m, its axes), and torques
    /// (N·m, N) of the joints, less what their laws exert, with reflected inertias. Accelerations of the base are those of its velocity
    /// in inertial axes and of its angular velocity in its own; of a fixed base those beyond the motion of its ground, zeros.
    pub fn inverse_dynamics(&self, base: &[T; 6], seconds: &[T; N]) -> ([T; 6], [T; N]) {
        let (of_base, all) = self.accelerations(base, seconds);
        let taken = |body: &Moving<T>, p: [Vector3<T>; 2]| {
            let inertial = Inertial::own(body);
            let [force, torque] = inertial.moved(p);
            let gyroscopic = cross(body.spin, inertial.tensor.apply(body.spin));
            [force + centripetal(body.spin, inertial.moment), torque + gyroscopic]
        };
        let mut loads: [_; N] = core::array::from_fn(|k| taken(&self.bodies[k], all[k]));
        let (mut whole, mut torques) = (taken(&self.base, of_base), [T::zero(); N]);
        for k in (0..N).rev() {
            let [force, torque] = loads[k];
            torques[k] = self.inertias[k].mul_add(seconds[k], self.along(k, loads[k])) - self.laws[k];
            let sum = loads.get_mut(self.parents[k]).unwrap_or(&mut whole);
            *sum = [sum[0] + force, sum[1] + torque + cross(self.arm(k), force)];
        }
        (self.on_base(whole), torques)
    }

    /// Inertias of the base and of bodies with all that they carry.
    fn composites(&self) -> (Inertial<T>, [Inertial<T>; N]) {
        let of = |body: &Moving<T>| Inertial::of(body, body.place.place - self.base.place.place).0;
        let mut all: [_; N] = core::array::from_fn(|k| of(&self.bodies[k]));
        let mut whole = of(&self.base);
        for k in (0..N).rev() {
            let outboard = all[k];
            let sum = all.get_mut(self.parents[k]).unwrap_or(&mut whole);
            *sum = *sum + outboard;
        }
        (whole, all)
    }

    /// Motions of the base for rates of one.
    fn units_of_base(&self) -> [Pair<T>; 6] {
        let ([x, y, z], [a, b, c], o) = (units(), self.axes(), zero());
        [[x, o], [y, o], [z, o], [o, a], [o, b], [o, c]]
    }

    /// Force and torque that accelerations of one take of the base with all that it carries.
    pub(super) fn inertia_of_base(&self, whole: &Inertial<T>) -> [[T; 6]; 6] {
        self.units_of_base().map(|unit| self.on_base(whole.moved(unit)))
    }

    /// Meets a joint and those inboard of it.
    #[inline(always)]
    pub(super) fn inboard(&self, joint: usize, mut meet: impl FnMut(usize)) {
        let mut next = joint;
        while next < N {
            meet(next);
            next = self.parents[next];
        }
    }

    /// The mass matrix (kg, kg·m, kg·m²): with forces and torques as in [`inverse_dynamics`](Self::inverse_dynamics).
    pub fn mass_matrix(&self) -> MassMatrix<T, N> {
        let (whole, all) = self.composites();
        let (o, base) = (T::zero(), self.inertia_of_base(&whole));
        let mut matrix = MassMatrix { base, coupling: [[o; 6]; N], joints: [[o; N]; N] };
        let units: [_; N] = core::array::from_fn(|k| self.unit(k));
        for (k, outboard) in all.into_iter().enumerate() {
            let wrench = outboard.moved(units[k]);
            self.inboard(k, |i| {
                let entry = along(units[i], wrench);
                (matrix.joints[k][i], matrix.joints[i][k]) = (entry, entry);
            });
            matrix.coupling[k] = self.on_base(wrench);
            matrix.joints[k][k] += self.inertias[k];
        }
        matrix
    }

    /// The mass centre of all links (m), and their mass (kg).
    /// Links without mass have no centre: NaN, where `System::mass_centre` is an error.
    pub fn mass_centre(&self) -> (Vector3<T>, T) {
        let (whole, _) = self.composites();
        (self.base.place.place + whole.moment * whole.mass.recip(), whole.mass)
    }

    /// The matrix of centroidal momentum: momentum (kg·m/s) and angular momentum about the mass centre (N·m·s), inertial axes, for a rate of one.
    /// Links without mass have no centre: NaN, where `System::mass_centre` is an error.
    pub fn momentum_matrix(&self) -> SixRows<T, N> {
        let (whole, all) = self.composites();
        let centre = self.base.place.place + whole.moment * whole.mass.recip();
        let about = |[p, angular]: Pair<T>| six([p, angular + cross(self.base.place.place - centre, p)]);
        SixRows {
            base: self.units_of_base().map(|unit| about(whole.moved(unit))),
            joints: core::array::from_fn(|k| about(all[k].moved(self.unit(k)))),
        }
    }

    /// The Jacobian of the mass centre (m/s, inertial axes): of the base, and of the joints.
    /// Links without mass have no centre: NaN, where `System::mass_centre` is an error.
    pub fn mass_centre_jacobian(&self) -> ([[T; 3]; 6], [[T; 3]; N]) {
        let (SixRows { base, joints }, (_, mass)) = (self.momentum_matrix(), self.mass_centre());
        let of = |[x, y, z, ..]: [T; 6]| [x, y, z].map(|x| x / mass);
        (base.map(of), joints.map(of))
    }

    /// Momentum (kg·m/s), and angular momentum about the mass centre (N·m·s), of all links, inertial axes.
    /// Links without mass have no centre: NaN, where `System::mass_centre` is an error.
    pub fn centroidal_momentum(&self) -> [Vector3<T>; 2] {
        let SixRows { base, joints } = self.momentum_matrix();
        let Columns { x, y, z } = self.base.place.attitude;
        let (v, w) = (self.base.velocity, self.base.spin);
        let rates = [v.x, v.y, v.z, dot(x, w), dot(y, w), dot(z, w)];
        let mut sum = [T::zero(); 6];
        for (column, rate) in base.iter().zip(&rates).chain(joints.iter().zip(&self.rates)) {
            sum.iter_mut().zip(column).for_each(|(sum, entry)| *sum = entry.mul_add(*rate, *sum));
        }
        let [a, b, c, d, e, f] = sum;
        [Vector3::new(a, b, c), Vector3::new(d, e, f)]
    }
}
