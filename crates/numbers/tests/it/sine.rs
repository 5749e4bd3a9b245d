//! Sine and cosine against 106 exact bits, from `sine.csv`. Its head tells how the file was made: with
//! Python's mpmath at 60 digits, from random angles, the worst found in searches, and the numbers next to multiples of
//! π/2.
//!
//! What is claimed is read from the table in the documentation of `src/scalar/trig.rs`.

use catena::scalar::{Elementary, Scalar};
use core::f64::consts::FRAC_PI_4;

/// A value as the double nearest to it and the double nearest to the remainder.
#[derive(Clone, Copy)]
struct Exact(f64, f64);

impl Exact {
    /// Error of `value` in the spacing, at the exact value, of numbers with `digits` binary digits and smallest spacing
    /// `floor`. Exact to 1e-15 or so: `value` and `self.0` are neighbours, whose difference has no rounding error.
    fn ulps(self, value: f64, digits: i32, floor: f64) -> f64 {
        let Exact(near, rest) = self;
        let mut power = f64::from_bits(near.to_bits() & (0x7ff << 52));
        if near.abs() == power && near * rest < 0.0 {
            // The exact value is just below a power of two, where numbers are closer together.
            power *= 0.5;
        }
        let spacing = (power * 0.5_f64.powi(digits - 1)).max(floor);
        ((value - near) - rest).abs() / spacing
    }
}

struct Row {
    kind: &'static str,
    angle: f64,
    sine: Exact,
    cosine: Exact,
}

fn rows(kind: &str) -> Vec<Row> {
    let lines = include_str!("sine.csv").lines().filter(|line| !line.starts_with('#'));
    let rows = lines.map(|line| {
        let (kind, numbers) = line.split_once(',').unwrap();
        let numbers: Vec<f64> =
            numbers.split(',').map(|bits| f64::from_bits(u64::from_str_radix(bits, 16).unwrap())).collect();
        let [angle, sine, sine_rest, cosine, cosine_rest] = numbers[..] else { panic!("{line}") };
        Row { kind, angle, sine: Exact(sine, sine_rest), cosine: Exact(cosine, cosine_rest) }
    });
    rows.filter(|row| row.kind == kind).collect()
}

/// Larger error of sine and cosine [ulp], as computed in `f64`.
fn double(row: &Row) -> f64 {
    let (sine, cosine) = Elementary::sin_cos(row.angle);
    let ulps = |exact: Exact, value: f64| exact.ulps(value, 53, f64::from_bits(1));
    ulps(row.sine, sine).max(ulps(row.cosine, cosine))
}

/// Larger error of sine and cosine [ulp], as computed in `f32`.
fn single(row: &Row) -> f64 {
    let (sine, cosine) = Elementary::sin_cos(row.angle as f32);
    let ulps = |exact: Exact, value: f32| exact.ulps(value.into(), 24, f32::from_bits(1).into());
    ulps(row.sine, sine).max(ulps(row.cosine, cosine))
}

/// The claimed error [ulp] in a row of the table.
fn claimed(row: &str, column: &str) -> f64 {
    let table: Vec<Vec<&str>> = include_str!("../../../../src/scalar/trig.rs")
        .lines()
        .filter_map(|line| line.strip_prefix("//! |"))
        .map(|line| line.split('|').map(str::trim).collect())
        .collect();
    let column = table[0].iter().position(|head| *head == column).unwrap();
    let row = table.iter().find(|cells| cells[0] == row).unwrap();
    row[column].parse().unwrap()
}

/// Whether multiply-adds are fused, as the crate decides it.
const FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));
const DOUBLE: &str = if FUSED { "f64 fma" } else { "f64" };

/// The largest error stays below the claim, which in turn is no larger than it has to be.
fn honours_its_claim(claim: f64, errors: impl Iterator<Item = f64>) {
    let worst = errors.inspect(|error| assert!(!error.is_nan())).fold(0.0, f64::max);
    println!("claimed {claim}, measured {worst:.4}");
    assert!(worst <= claim, "claimed {claim}, measured {worst}");
    // The file holds the worst angles of long searches, and the claim is rounded up to a hundredth.
    assert!(worst >= 0.95 * claim, "claimed {claim}, but measured {worst} only");
}

fn every_range_honours_its_claim(kind: &str, column: &str, error: fn(&Row) -> f64) {
    let rows = rows(kind);
    let ends = [FRAC_PI_4, 33.0, 1e5, 4e5];
    let mut start = -1.0;
    for (end, name) in ends.into_iter().zip(["up to π/4", "up to 33", "up to 1e5", "up to 4e5"]) {
        let inside: Vec<&Row> = rows.iter().filter(|row| row.angle.abs() > start && row.angle.abs() <= end).collect();
        assert!(inside.len() > 50, "too few angles {name}");
        honours_its_claim(claimed(name, column), inside.into_iter().map(error));
        start = end;
    }
}

#[test]
fn sine_and_cosine_are_as_accurate_as_claimed() {
    every_range_honours_its_claim("double", DOUBLE, double);
}

#[test]
fn sine_and_cosine_of_f32_are_as_accurate_as_claimed() {
    every_range_honours_its_claim("single", "f32", single);
}

#[test]
fn sine_is_accurate_next_to_multiples_of_half_pi() {
    let hard = rows("next");
    assert!(hard.len() > 500);
    // In the worst of them less than a hundredth of a spacing of the angle is left, so that nothing but an exact
    // reduction gives any correct digit.
    let closest = hard.iter().map(|row| row.sine.0.abs().min(row.cosine.0.abs()) / row.angle.abs()).fold(1.0, f64::min);
    assert!(closest < 0.01 * f64::EPSILON / 2.0);
    honours_its_claim(claimed("next to kπ/2", DOUBLE), hard.iter().map(double));
}

#[test]
fn sine_of_f32_is_accurate_next_to_multiples_of_half_pi() {
    honours_its_claim(claimed("next to kπ/2", "f32"), rows("single next").iter().map(single));
}

#[test]
fn the_table_reaches_as_far_as_the_stated_range() {
    assert_eq!(<f64 as Scalar>::ANGLE_RANGE, 4e5);
    assert_eq!(<f32 as Scalar>::ANGLE_RANGE, 4e5);
}

#[test]
fn beyond_the_range_the_error_is_that_of_a_rounded_angle() {
    for row in rows("beyond") {
        let (sine, cosine) = Elementary::sin_cos(row.angle);
        // The angle rounded once more (half its spacing, at most 2^-53 of it), and the results' own errors.
        let tolerance = row.angle.abs() * f64::EPSILON / 2.0 + 2.0 * f64::EPSILON;
        for (value, Exact(near, rest)) in [(sine, row.sine), (cosine, row.cosine)] {
            assert!(((value - near) - rest).abs() <= tolerance, "at {}", row.angle);
        }
    }
}

#[test]
fn sine_is_odd_and_cosine_even_to_the_last_bit() {
    let tabulated = ["double", "next", "single", "single next", "beyond"].into_iter().flat_map(rows);
    // From 1e-9 to 4e5 in equal ratios.
    let others = (0..20_000).map(|step| 1e-9 * 1.001_683_f64.powi(step));
    for angle in tabulated.map(|row| row.angle).chain(others) {
        let (plus, minus) = (Elementary::sin_cos(angle), Elementary::sin_cos(-angle));
        assert_eq!(minus.0.to_bits(), (-plus.0).to_bits(), "sine at {angle}");
        assert_eq!(minus.1.to_bits(), plus.1.to_bits(), "cosine at {angle}");
        let angle = angle as f32;
        let (plus, minus) = (Elementary::sin_cos(angle), Elementary::sin_cos(-angle));
        assert_eq!(minus.0.to_bits(), (-plus.0).to_bits(), "sine at {angle}");
        assert_eq!(minus.1.to_bits(), plus.1.to_bits(), "cosine at {angle}");
    }
}

#[test]
fn tiny_angles_and_signed_zeros_are_their_own_sine() {
    for angle in [0.0, -0.0, 5e-324, -1e-310, f64::MIN_POSITIVE, 1e-30, -1e-9] {
        let (sine, cosine) = Elementary::sin_cos(angle);
        assert_eq!((sine.to_bits(), cosine), (angle.to_bits(), 1.0), "{angle:e}");
    }
    for angle in [0.0, -0.0, 1e-45, -1e-40, f32::MIN_POSITIVE, 1e-20, -1e-5] {
        let (sine, cosine) = Elementary::sin_cos(angle);
        assert_eq!((sine.to_bits(), cosine), (angle.to_bits(), 1.0), "{angle:e}");
    }
}

#[test]
fn angles_that_are_not_finite_give_nan() {
    for angle in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (sine, cosine) = Elementary::sin_cos(angle);
        assert!(sine.is_nan() && cosine.is_nan(), "{angle}");
        let (sine, cosine) = Elementary::sin_cos(angle as f32);
        assert!(sine.is_nan() && cosine.is_nan(), "{angle} in f32");
    }
}
