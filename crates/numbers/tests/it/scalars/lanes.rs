//! Lanes against plain numbers, bit for bit.

use super::*;
use catena::scalar::{Elementary, WideF32x16, WideF64x8};
use simba::simd::{WideF32x4, WideF32x8, WideF64x4};

/// Every lane of a result has the bits of a plain computation; angles from 1e-3 to beyond the range, both signs.
macro_rules! lanes_compute_alone {
    ($lanes:ident, $number:ident, $count:literal) => {
        computes_like_its_plain_number::<$lanes>();
        let same = |lanes: $lanes, plain: [$number; $count]| {
            assert_eq!(lanes.into_arr().map($number::to_bits), plain.map($number::to_bits));
        };
        for step in 0..3000 {
            let y: [$number; $count] = core::array::from_fn(|lane| {
                let size = 1e-3 * $number::powf(1.007, (step + lane) as $number);
                if lane % 2 == 0 { size } else { -size }
            });
            let x = y.map(|y| 1.25 - y * 0.5);
            let (all_y, all_x) = ($lanes::from(y), $lanes::from(x));
            let each = |f: fn($number, $number) -> $number| core::array::from_fn(|lane| f(y[lane], x[lane]));
            same(all_y.sin_cos().0, each(|y, _| Elementary::sin_cos(y).0));
            same(all_y.sin_cos().1, each(|y, _| Elementary::sin_cos(y).1));
            same(all_y.atan2(all_x), each(Elementary::atan2));
            same(all_y.recip(), each(|y, _| Scalar::recip(y)));
            same((all_y * all_y).sqrt(), each(|y, _| Elementary::sqrt(y * y)));
            same(all_y.mul_add(all_x, all_y), each(|y, x| Scalar::mul_add(y, x, y)));
            same(all_y.scale(3.0), each(|y, _| y * 3.0));
            same(Elementary::exp(all_y), each(|y, _| Elementary::exp(y)));
            same(Elementary::ln(all_x), each(|_, x| Elementary::ln(x)));
            same(Elementary::tanh(all_y), each(|y, _| Elementary::tanh(y)));
            same(Scalar::abs(all_y), each(|y, _| Scalar::abs(y)));
            same(Scalar::sign(all_y), each(|y, _| Scalar::sign(y)));
            same(Scalar::powi(all_x, 5), each(|_, x| Scalar::powi(x, 5)));
            same(Scalar::powi(all_x, -2), each(|_, x| Scalar::powi(x, -2)));
        }
    };
}

#[test]
fn every_lane_computes_what_a_plain_number_does() {
    lanes_compute_alone!(WideF64x4, f64, 4);
    lanes_compute_alone!(WideF32x4, f32, 4);
    lanes_compute_alone!(WideF32x8, f32, 8);
    lanes_compute_alone!(WideF64x8, f64, 8);
    lanes_compute_alone!(WideF32x16, f32, 16);
}

#[test]
fn the_lane_of_largest_magnitude_decides() {
    assert_eq!(WideF64x4::from([1.0, -3.0, 2.0, 0.0]).real(), -3.0);
    assert_eq!(WideF32x8::from([0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]).real(), 7.0);
    for lane in 0..4 {
        let mut numbers = [1.0, 5.0, 2.0, 3.0];
        numbers[lane] = f64::NAN;
        assert!(WideF64x4::from(numbers).real().is_nan());
    }
}

#[test]
fn one_lane_that_is_not_finite_makes_the_bundle_not_finite() {
    assert!(WideF64x4::constant(1.0).is_finite());
    for lane in 0..4 {
        for bad in [f64::NAN, f64::INFINITY] {
            let mut numbers = [1.0; 4];
            numbers[lane] = bad;
            assert!(!WideF64x4::from(numbers).is_finite());
        }
    }
}

#[test]
fn joints_with_modes_are_refused_in_lanes() -> Result<(), catena::Error> {
    use catena::Fault;
    use catena::planar::*;
    let of = |x: f64| WideF64x4::from([x; 4]);
    let stop = HardStops::between(Slider::along(of(0.0)), [of(0.0), of(1.0)]);
    let body = RigidBody::new(of(1.0), of(0.1), [of(0.0); 2], [of(0.0); 2]);
    let scene = System::new(Clamped::origin(), (stop, body), Free)?;
    let fault = scene.simulation(Rk4::step(0.1)).run(scene.motion(), 1.0, |_| ()).expect_err("lanes").error.fault;
    assert!(matches!(fault, Fault::Unsupported { what } if what.contains("lanes")), "{fault}");
    Ok(())
}
