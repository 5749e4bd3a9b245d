//! The regressor: inverse dynamics as a linear function of inertial parameters.

use super::{Moving, Snapshot};
use crate::mechanics::spatial::body_axes::solids::Parameters;
use crate::relation::spatial::algebra::{centripetal, cross, zero};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// What inverse dynamics takes for each inertial parameter of each body: mass, first moment x, y, z, and tensor xx, yy, zz, yz, xz, xy about
/// the body's origin, in its axes. Laws of joints and reflected inertias are no part of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Regressor<T, const N: usize> {
    /// Force and torque on the base by parameters of the base.
    pub base: [Parameters<T>; 6],
    /// Force and torque on the base by parameters of the bodies.
    pub on_base: [[Parameters<T>; N]; 6],
    /// Torques of the joints by parameters of the bodies: `joints[i][k]` is that of joint i by body k.
    pub joints: [[Parameters<T>; N]; N],
}

/// Force and torque about the origin, in axes of the body, for parameters of one: from acceleration, angular acceleration and velocity there.
fn taken<T: Scalar>(a: Vector3<T>, angular: Vector3<T>, spin: Vector3<T>) -> [[Vector3<T>; 2]; 10] {
    let unit = super::units();
    let moment = |k: usize| [cross(angular, unit[k]) + centripetal(spin, unit[k]), cross(unit[k], a)];
    // Symmetric, with ones in row i and column k.
    let product = |v: Vector3<T>, i: usize, k: usize| {
        let mut product: Vector3<T> = zero();
        (product[i], product[k]) = (v[k], v[i]);
        product
    };
    let tensor = |i: usize, k: usize| [zero(), product(angular, i, k) + cross(spin, product(spin, i, k))];
    let [x, y, z] = core::array::from_fn(moment);
    [[a, zero()], x, y, z, tensor(0, 0), tensor(1, 1), tensor(2, 2), tensor(1, 2), tensor(0, 2), tensor(0, 1)]
}

impl<T: Scalar, const N: usize> Snapshot<T, N> {
    /// The regressor of accelerations: [`inverse_dynamics`](Self::inverse_dynamics) is its product with [`parameters`](Self::parameters), but for
    /// laws of joints and reflected inertias.
    pub fn regressor(&self, base: &[T; 6], seconds: &[T; N]) -> Regressor<T, N> {
        let (of_base, all) = self.accelerations(base, seconds);
        // In inertial axes, about the origin of the body.
        let each = |body: &Moving<T>, [a, angular]: [Vector3<T>; 2]| {
            let attitude = &body.place.attitude;
            let [a, angular, spin] = [a, angular, body.spin].map(|vector| attitude.transposed(vector));
            taken(a, angular, spin).map(|forces| forces.map(|vector| attitude.apply(vector)))
        };
        let (none, one) = ([T::zero(); 10], each(&self.base, of_base));
        let mut regressor = Regressor { base: [none; 6], on_base: [[none; N]; 6], joints: [[none; N]; N] };
        for (parameter, forces) in one.into_iter().enumerate() {
            let column = self.on_base(forces);
            (0..6).for_each(|row| regressor.base[row][parameter] = column[row]);
        }
        for (k, motion) in all.into_iter().enumerate() {
            for (parameter, [force, mut torque]) in each(&self.bodies[k], motion).into_iter().enumerate() {
                let mut next = k;
                while next < N {
                    regressor.joints[next][k][parameter] = self.along(next, [force, torque]);
                    torque += cross(self.arm(next), force);
                    next = self.parents[next];
                }
                let column = self.on_base([force, torque]);
                (0..6).for_each(|row| regressor.on_base[row][k][parameter] = column[row]);
            }
        }
        regressor
    }

    /// Inertial parameters of the base and of the bodies on the joints, as the [regressor](Self::regressor) has them.
    pub fn parameters(&self) -> (Parameters<T>, [Parameters<T>; N]) {
        (self.base.parameters, core::array::from_fn(|k| self.bodies[k].parameters))
    }
}
