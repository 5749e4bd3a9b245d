//! Sine and cosine of our own, without branches, so that a loop over angles becomes vector code.
//!
//! # Method
//!
//! 1. The nearest multiple `k` of π/2 is found by adding and subtracting 1.5·2⁵², which rounds to an integer and leaves
//!    `k`'s lowest bits in the lowest bits of the sum.
//! 2. π/2 is held in three pieces. The first two have 35 bits each, so that `k` times either is exact for |k| ≤ 2¹⁸
//!    even without a fused multiply-add; the pieces together are π/2 to 2⁻¹³⁰. What subtracting the second piece rounds
//!    off is kept, so that the reduced angle is known to twice the working precision even where nearly all of it
//!    cancels.
//! 3. Two minimax polynomials give sine and cosine of the reduced angle, with its low part to first order. Their
//!    coefficients are weighted for relative error: 2⁻⁵⁷·⁹ (sine) and 2⁻⁶³·⁹ (cosine).
//! 4. The two lowest bits of `k` exchange the two results and set their signs, by masks.
//!
//! For `f32` the same is done in `f64` with shorter polynomials, and rounded at the end.
//!
//! # Errors
//!
//! Largest error of sine and cosine found [ulp, the spacing of numbers at the exact value], rounded up; half an ulp is
//! unavoidable. `fma` stands for targets with a fused multiply-add, which feature `std` makes use of. Each range
//! excludes those above it and was searched with 2.5·10⁸ random angles, in `f32` with all there are. The last row holds
//! the numbers on either side of every multiple of π/2 up to 254 648·π/2, where nearly all digits of the angle cancel.
//!
//! | angle, rad   | f64  | f64 fma | f32  |
//! |--------------|------|---------|------|
//! | up to π/4    | 0.99 | 0.99    | 0.57 |
//! | up to 33     | 1.02 | 1.02    | 0.57 |
//! | up to 1e5    | 1.02 | 1.02    | 0.57 |
//! | up to 4e5    | 1.03 | 1.02    | 0.57 |
//! | next to kπ/2 | 0.51 | 0.51    | 0.51 |
//!
//! Sine is odd and cosine even to the last bit, signed zeros included. NaN and infinities give NaN.
//!
//! Beyond [`ANGLE_RANGE`](super::Scalar::ANGLE_RANGE), multiples of the pieces of π/2 are no longer exact. Without
//! `fma` the absolute error grows as if the angle had been rounded once more, to |x|·2⁻⁵³, up to 10¹⁵ rad; with `fma`
//! it stays below a thousandth of that, but the relative error next to multiples of π/2 grows too. Beyond 10¹⁵ the
//! results mean nothing, and may exceed one.
#![cfg(any(feature = "std", feature = "libm"))]

use super::Scalar;
use core::f64::consts::FRAC_2_PI;

/// Largest magnitude of an angle in rad for which the table of errors holds; 2¹⁸·π/2 ≈ 411 774 bounds it.
pub(super) const ANGLE_RANGE: f64 = 4e5;

/// 1.5·2⁵²: numbers added to it are rounded to integers, whose lowest bits become the lowest bits of the sum. The 1.5
/// keeps the sum's exponent for negative numbers. It is even, so that ties are rounded alike for both signs.
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// π/2 in pieces of 35, 35 and 53 bits.
const HALF_PI: [f64; 3] = [1.5707963267923333, 2.5633441515839558e-12, 1.0562999066987428e-23];

/// π/2 without its first piece, in one number: enough for `f32`.
const HALF_PI_REST: f64 = 2.563344151594519e-12;

/// `(r - sin r) / r³` as a polynomial of `r²`, |r| ≤ π/4.
const SINE: [f64; 6] = [
    0.1666666666666663,
    -0.00833333333332184,
    0.00019841269829358522,
    -2.7557313538511096e-6,
    2.5050734388647712e-8,
    -1.5895433249212314e-10,
];

/// `(cos r - 1 + r²/2) / r⁴` as a polynomial of `r²`, |r| ≤ π/4.
const COSINE: [f64; 6] = [
    0.041666666666666595,
    -0.0013888888888873342,
    2.48015872890021e-5,
    -2.755731421705157e-7,
    2.087570539866114e-9,
    -1.1358749419773784e-11,
];

/// `sin r / r` as a polynomial of `r²`, to 2⁻²⁸.
const SINE_SHORT: [f64; 4] = [1.0, -0.16666654609711729, 0.008332160765479442, -0.0001951528329685483];

/// `cos r` as a polynomial of `r²`, to 2⁻³³.
const COSINE_SHORT: [f64; 5] = [1.0, -0.5, 0.04166664568315745, -0.0013887316263152584, 2.4433157972546602e-5];

/// What the kernel needs beyond arithmetic.
pub(super) trait Quadrant: Scalar<Real = f64> {
    /// Takes the sine, the negative sine and the cosine of a reduced angle into the quadrant which the two lowest bits
    /// of `self` name: sine and cosine of the whole angle.
    fn turn(self, sine: Self, negative_sine: Self, cosine: Self) -> (Self, Self);
}

impl Quadrant for f64 {
    #[cfg_attr(optimised, inline(always))]
    fn turn(self, sine: f64, negative_sine: f64, cosine: f64) -> (f64, f64) {
        const SIGN: u64 = 1 << 63;
        // A selection costs one instruction where vectors can be blended. Plain x86-64 cannot, and is better off with
        // exclusive ors under a mask.
        const BLENDS: bool =
            cfg!(any(target_feature = "sse4.1", not(any(target_arch = "x86", target_arch = "x86_64"))));
        let bits = self.to_bits();
        let sign = (bits << 62) & SIGN;
        let (sine, cosine) = if BLENDS {
            let odd = ((bits << 63) as i64) < 0;
            let turned = if odd { (cosine, negative_sine) } else { (sine, cosine) };
            (turned.0.to_bits(), turned.1.to_bits())
        } else {
            let odd = 0_u64.wrapping_sub(bits & 1);
            let (sine, cosine) = (sine.to_bits(), cosine.to_bits());
            let swap = (sine ^ cosine) & odd;
            (sine ^ swap, cosine ^ swap ^ (odd & SIGN))
        };
        (f64::from_bits(sine ^ sign), f64::from_bits(cosine ^ sign))
    }
}

/// Sine and cosine of an angle in rad, or of every lane.
#[cfg_attr(optimised, inline(always))]
pub(super) fn sin_cos<T: Quadrant>(angle: T) -> (T, T) {
    let number = T::constant;
    let rounded = angle.mul_add(number(FRAC_2_PI), number(ROUNDER));
    let k = rounded - number(ROUNDER);
    // Exact: a multiple of 2⁻⁵³ below 1.
    let coarse = k.mul_add(number(-HALF_PI[0]), angle);
    let r = k.mul_add(number(-HALF_PI[1]), coarse);
    // The reduced angle is r - rest. `r - coarse` is exact, as is its sum with the product.
    let rest = k.mul_add(number(HALF_PI[2]), k.mul_add(number(HALF_PI[1]), r - coarse));
    let z = r * r;
    // For r = ±0 the rest is +0, so that `less` is +0 and the sine keeps the sign of r. With other signs -0 would be
    // lost.
    let less = (r * z).mul_add(polynomial(SINE, z), rest);
    let more = (z * z).mul_add(polynomial(COSINE, z), r * rest);
    rounded.turn(r - less, less - r, number(1.0) - (z * number(0.5) - more))
}

/// Sine and cosine of an angle in rad.
#[cfg_attr(optimised, inline(always))]
pub(super) fn sin_cos_single(angle: f32) -> (f32, f32) {
    let angle = f64::from(angle);
    let rounded = Scalar::mul_add(angle, FRAC_2_PI, ROUNDER);
    let k = rounded - ROUNDER;
    let r = Scalar::mul_add(k, -HALF_PI_REST, Scalar::mul_add(k, -HALF_PI[0], angle));
    let z = r * r;
    let sine = r * polynomial(SINE_SHORT, z);
    let (sine, cosine) = rounded.turn(sine, -sine, polynomial(COSINE_SHORT, z));
    (sine as f32, cosine as f32)
}

/// The polynomial with the given coefficients, lowest power first.
#[cfg_attr(optimised, inline(always))]
fn polynomial<T: Scalar<Real = f64>, const N: usize>(coefficients: [f64; N], z: T) -> T {
    let mut sum = T::constant(coefficients[N - 1]);
    for coefficient in coefficients[..N - 1].iter().rev() {
        sum = sum.mul_add(z, T::constant(*coefficient));
    }
    sum
}
