//! Powers for the choice of steps: exact enough for that, and cheap.

use num_traits::pow;

/// The logarithm to base 2 of a positive number, to a hundredth: a parabola between powers of two.
#[inline]
pub(super) fn log2(x: f64) -> f64 {
    let bits = x.to_bits();
    let power = (bits >> 52) as f64 - 1023.0;
    let share = f64::from_bits((bits & ((1 << 52) - 1)) | (1023 << 52));
    power + (2.0 - share / 3.0) * share - 5.0 / 3.0
}

/// Two to the power `x`, to three thousandths, likewise; as large as numbers are where it overflows.
#[inline]
pub(super) fn exp2(x: f64) -> f64 {
    let x = x.clamp(-1000.0, 1000.0) + 1023.0;
    let power = x as u64;
    let share = x - power as f64;
    f64::from_bits(power << 52) * (1.0 + share * (0.6565 + 0.3435 * share))
}

/// A positive number to the power −1 / `order`, to rounding: two steps of fourth order from what [`power`] says. Where a compiler knows the
/// order that takes half the instructions of the platform's power.
#[inline(always)]
pub(crate) fn inverse_root(x: f64, order: usize) -> f64 {
    let once = 1.0 / order as f64;
    let mut root = power(x, -once);
    for _ in 0..2 {
        let residual = 1.0 - x * pow(root, order);
        let third = 1.0 + residual * ((2.0 + once) / 3.0);
        root += root * (residual * once) * (1.0 + residual * (0.5 + 0.5 * once) * third);
    }
    root
}

/// A positive number to the power `exponent`.
#[inline]
pub(crate) fn power(x: f64, exponent: f64) -> f64 {
    exp2(log2(x) * exponent)
}

#[cfg(test)]
mod tests {
    use super::inverse_root;

    #[test]
    fn inverse_roots_are_those_of_logarithms() {
        for order in 2..=30 {
            for k in -120..=300 {
                let x = 10.0_f64.powf(0.1 * k as f64 + 0.03);
                let expected = (-x.ln() / order as f64).exp();
                assert!((inverse_root(x, order) / expected - 1.0).abs() < 1e-13, "{x} {order}");
            }
        }
    }
}
