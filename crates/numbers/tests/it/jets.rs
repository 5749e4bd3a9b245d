//! Jets against dual numbers of another library, operation by operation, derivative parts by themselves.

use catena::Scalar;
use catena::scalar::{Elementary, Jet};
use nalgebra::{Const, U1};
use num_dual::DualSVec64;
use num_traits::{One, Zero};

const K: usize = 13; // blocks of eight, of four and of one

type Parts = (f64, [f64; K]);

fn jet((re, eps): Parts) -> Jet<f64, K> {
    Jet { re, eps }
}

fn dual((re, eps): Parts) -> DualSVec64<K> {
    let seeds = (0..K).fold(DualSVec64::from_re(re), |sum, k| {
        sum + DualSVec64::<K>::from_re(0.0).derivative(k) * DualSVec64::from_re(eps[k])
    });
    DualSVec64::new(re, seeds.eps)
}

/// Both numbers agree to some roundings.
#[track_caller]
fn same(name: &str, jet: Jet<f64, K>, dual: DualSVec64<K>) {
    let eps = dual.eps.unwrap_generic(Const::<K>, U1);
    for (found, expected) in [jet.re].iter().chain(&jet.eps).zip([dual.re].iter().chain(&eps)) {
        assert!((found - expected).abs() <= 4e-15 * expected.abs().max(1.0), "{name}: {found} not {expected}");
    }
}

#[test]
fn every_operation_has_the_derivatives_of_dual_numbers() {
    let of = |re: f64, by: f64| (re, core::array::from_fn(|k| (by + k as f64).sin()));
    let (a, b, c) = (of(0.7, 0.3), of(-1.3, 2.0), of(0.4, -1.0));
    macro_rules! both {
        ($name:literal, |$a:ident, $b:ident, $c:ident| $value:expr) => {{
            let jets = {
                let ($a, $b, $c) = (jet(a), jet(b), jet(c));
                $value
            };
            let duals = {
                let ($a, $b, $c) = (dual(a), dual(b), dual(c));
                $value
            };
            same($name, jets, duals);
        }};
    }
    both!("sum", |a, b, _c| a + b);
    both!("difference", |a, b, _c| a - b);
    both!("product", |a, b, _c| a * b);
    both!("quotient", |a, b, _c| a / b);
    both!("opposite", |a, _b, _c| -a);
    both!("multiply and add", |a, b, c| Scalar::mul_add(a, b, c));
    both!("scale", |a, _b, _c| Scalar::scale(a, 0.3));
    both!("add scaled", |a, b, _c| Scalar::add_scaled(a, 0.3, b));
    both!("reciprocal", |_a, b, _c| Scalar::recip(b));
    both!("root", |a, _b, _c| Elementary::sqrt(a));
    both!("sine", |a, _b, _c| Elementary::sin_cos(a).0);
    both!("cosine", |a, _b, _c| Elementary::sin_cos(a).1);
    both!("arctangent", |a, b, _c| Elementary::atan2(a, b));
    both!("exponential", |a, _b, _c| Elementary::exp(a));
    both!("logarithm", |a, _b, _c| Elementary::ln(a));
    both!("hyperbolic tangent", |_a, b, _c| Elementary::tanh(b));
    both!("magnitude", |_a, b, _c| Scalar::abs(b));
    both!("sign", |_a, b, _c| Scalar::sign(b));
    both!("power", |_a, b, _c| Scalar::powi(b, 7));
    both!("inverse power", |a, _b, _c| Scalar::powi(a, -3));
    both!("combination", |a, b, c| {
        let mut sum = c;
        Scalar::combine(&mut sum, &a, [(0.3, &b), (-2.0, &c)]);
        sum
    });
    both!("accumulation", |a, b, c| {
        let mut sum = c;
        Scalar::accumulate(&mut sum, [(0.3, &b), (-2.0, &a)]);
        sum
    });
    same("zero", Jet::zero(), dual((0.0, [0.0; K])));
    same("one", Jet::one(), dual((1.0, [0.0; K])));
    assert!(!Jet::<f64, 2> { re: 1.0, eps: [0.0, f64::NAN] }.is_finite());
    assert_ne!(Jet::<f64, 1>::seed(1.0, 0), Jet::of(1.0));
}

#[test]
fn long_vectors_have_angles_too() {
    let (y, x) = (Jet::<f64, 1>::seed(3e200, 0), Jet::of(4e200));
    assert!((y.atan2(x).eps[0] - 4.0 / 25.0 * 1e-200).abs() < 1e-215);
}

/// Closed forms, by no other library: at 0.7, and at zero, where laws of friction turn round.
#[test]
fn functions_have_the_slopes_of_closed_forms() {
    let slope = |f: fn(Jet<f64, 2>) -> Jet<f64, 2>, at: f64| {
        let Jet { eps: [own, other], .. } = f(Jet::seed(at, 0));
        assert_eq!(other, 0.0);
        own
    };
    /// A function, where, and its slope there.
    type Case = (fn(Jet<f64, 2>) -> Jet<f64, 2>, f64, f64);
    let cases: [Case; 13] = [
        (Elementary::exp, 0.7, 0.7_f64.exp()),
        (Elementary::ln, 0.7, 1.0 / 0.7),
        (Elementary::tanh, 0.7, 0.7_f64.cosh().powi(-2)),
        (Scalar::abs, 0.7, 1.0),
        (Scalar::abs, -0.7, -1.0),
        (Scalar::abs, 0.0, 0.0),
        (Scalar::sign, 0.7, 0.0),
        (Elementary::tanh, 0.0, 1.0),
        (|x| Scalar::powi(x, 3), 0.7, 3.0 * 0.49),
        (|x| Scalar::powi(x, -2), 0.7, -2.0 / 0.343),
        (|x| Scalar::powi(x, 0), 0.0, 0.0),
        (|x| Scalar::powi(x, 1), 0.0, 1.0),
        (|x| Scalar::powi(x, 2), 0.0, 0.0),
    ];
    for (case, (f, at, expected)) in cases.into_iter().enumerate() {
        let found = slope(f, at);
        assert!((found - expected).abs() <= 1e-15 * expected.abs(), "case {case}: {found} not {expected}");
    }
}
