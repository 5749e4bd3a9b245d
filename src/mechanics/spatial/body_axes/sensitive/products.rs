//! What is quadratic in an angular velocity ω, as linear in the products of its components: so it is in their changes.

use super::super::link::Link;
use super::super::number::{Number, Rows, Triple, apply_onto};
use crate::scalar::Scalar;

/// How products of ω (xx, yy, zz, yz, xz, xy) change with it.
#[inline(always)]
pub fn products_varied<T: Scalar>([x, y, z]: [T; 3], [dx, dy, dz]: [T; 3]) -> [T; 6] {
    let twice = |a: T, b: T| {
        let product = a * b;
        product + product
    };
    let both = |a: T, db: T, b: T, da: T| a.mul_add(db, b * da);
    [twice(x, dx), twice(y, dy), twice(z, dz), both(y, dz, z, dy), both(x, dz, z, dx), both(x, dy, y, dx)]
}

/// ω ωᵀ − ω² 1: what takes a place on a body to its centripetal acceleration.
#[cfg_attr(optimised, inline(always))]
pub fn swirl<T: Scalar>([xx, yy, zz, yz, xz, xy]: [T; 6]) -> Rows<T> {
    let (yz, xz, xy) = (Number::of(yz), Number::of(xz), Number::of(xy));
    [[Number::of(-(yy + zz)), xy, xz], [xy, Number::of(-(xx + zz)), yz], [xz, yz, Number::of(-(xx + yy))]]
}

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> Link<T, MOMENT, TENSOR> {
    /// Force ω × (ω × σ) and torque ω × J ω about the origin.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn stirred_by(&self, products: [T; 6]) -> [Triple<T>; 2] {
        let [xx, yy, zz, yz, xz, xy] = products;
        let (yz, xz, xy) = (Number::of(yz), Number::of(xz), Number::of(xy));
        let force = apply_onto(&swirl(products), self.first_moment(), [Number::zero(); 3]);
        let [jxx, jyy, jzz, jyz, jxz, jxy] = self.about_origin();
        // (ω × J ω)_x = (J_zz − J_yy) yz + J_yz (yy − zz) + J_xz xy − J_xy xz, and so on around.
        let torque = [
            around(jzz.minus(jyy), yz, jyz, yy - zz, [jxz, xy], [jxy, xz]),
            around(jxx.minus(jzz), xz, jxz, zz - xx, [jxy, yz], [jyz, xy]),
            around(jyy.minus(jxx), xy, jxy, xx - yy, [jyz, xz], [jxz, yz]),
        ];
        [force, torque]
    }
}

/// One component of ω × J ω.
#[cfg_attr(optimised, inline(always))]
fn around<T: Scalar>(
    moments: Number<T>,
    product: Number<T>,
    own: Number<T>,
    squares: T,
    [plus, with]: [Number<T>; 2],
    [minus, by]: [Number<T>; 2],
) -> Number<T> {
    let sum = own.times_onto(Number::of(squares), moments.times(product));
    minus.times_off(by, plus.times_onto(with, sum))
}
