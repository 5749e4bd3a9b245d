//! Derivatives against closed forms, part by part: `==` of dual numbers looks at their values only.

use super::*;
use nalgebra::{Const, U1};
use num_dual::{Derivative, Dual, Dual2, Dual2SVec, Dual3, DualSVec, HyperDual, HyperDualVec, HyperHyperDual};

/// A function's value and its derivatives by u, v, uu, uv, vv, uuu, uuv, uvv and vvv.
const U: usize = 1;
const V: usize = 2;
const UU: usize = 3;
const UV: usize = 4;
const VV: usize = 5;
const UUU: usize = 6;
const UUV: usize = 7;
const UVV: usize = 8;
const VVV: usize = 9;

/// A sum and the sum of its terms' magnitudes, to which rounding errors are relative.
type Exact = (f64, f64);

fn sum<const N: usize>(terms: [f64; N]) -> Exact {
    (terms.iter().sum(), terms.iter().map(|term| term.abs()).sum())
}

/// Like `sum`, of multiples of sums.
fn combine<const N: usize>(terms: [(f64, Exact); N]) -> Exact {
    let (values, sizes) =
        (terms.map(|(factor, (value, _))| factor * value), terms.map(|(factor, (_, size))| factor * size));
    (sum(values).0, sum(sizes).1)
}

/// `f(u v)`, given `f` and its derivatives at `u v`.
fn of_product(u: f64, v: f64, [f, d, dd, ddd]: [Exact; 4]) -> [Exact; 10] {
    let p = u * v;
    let times = |factor, exact| combine([(factor, exact)]);
    let mixed = |w: f64| combine([(2.0 * w, dd), (w * p, ddd)]);
    [
        f,
        times(v, d),
        times(u, d),
        times(v * v, dd),
        combine([(1.0, d), (p, dd)]),
        times(u * u, dd),
        times(v * v * v, ddd),
        mixed(v),
        mixed(u),
        times(u * u * u, ddd),
    ]
}

const CASES: usize = 13;

/// All derivatives of the arguments matter: those of sine and cosine have second ones by the same variable, too.
fn computed<T: Scalar>(u: T, v: T) -> [T; CASES] {
    let (sine, cosine) = (u * v * u * v).sin_cos();
    let (root, inverse) = ((u * v).sqrt(), (u * v).recip());
    let scaled = (u * v).scale(T::Real::of(3.0));
    let p = u * v;
    let (power, inverse_power) = (Scalar::powi(p, 5), Scalar::powi(p, -3));
    let functions = [Elementary::exp(p), Elementary::ln(p), Elementary::tanh(p), Scalar::abs(-p), power, inverse_power];
    let others = [sine, cosine, root, inverse, scaled, (u * u * v).mul_add(u * v * v, p), u.atan2(v)];
    core::array::from_fn(|k| others.get(k).copied().unwrap_or_else(|| functions[k - others.len()]))
}

fn exact(u: f64, v: f64) -> [[Exact; 10]; CASES] {
    let p = u * v;
    let ((s, c), w) = ((p * p).sin_cos(), p.sqrt());
    let r = u * u + v * v;
    let (r2, r3) = (r * r, r * r * r);
    let (u2, v2) = (u * u, v * v);
    let (pp, ppp) = (p * p, p * p * p);
    let sine = [sum([s]), sum([2.0 * p * c]), sum([2.0 * c, -4.0 * pp * s]), sum([-12.0 * p * s, -8.0 * ppp * c])];
    let cosine = [sum([c]), sum([-2.0 * p * s]), sum([-2.0 * s, -4.0 * pp * c]), sum([-12.0 * p * c, 8.0 * ppp * s])];
    let (t, t2) = (p.tanh(), p.tanh() * p.tanh());
    let tanh = [sum([t]), sum([1.0, -t2]), sum([-2.0 * t, 2.0 * t * t2]), sum([-2.0, 8.0 * t2, -6.0 * t2 * t2])];
    let single = |jet: [f64; 4]| of_product(u, v, jet.map(|term| sum([term])));
    [
        of_product(u, v, sine),
        of_product(u, v, cosine),
        single([w, 0.5 / w, -0.25 / (w * p), 0.375 / (w * p * p)]),
        single([1.0 / p, -1.0 / pp, 2.0 / ppp, -6.0 / (pp * pp)]),
        single([3.0 * p, 3.0, 0.0, 0.0]),
        of_product(u, v, [sum([ppp, p]), sum([3.0 * pp, 1.0]), sum([6.0 * p]), sum([6.0])]),
        [
            sum([u.atan2(v)]),
            sum([v / r]),
            sum([-u / r]),
            sum([-2.0 * u * v / r2]),
            sum([u2 / r2, -v2 / r2]),
            sum([2.0 * u * v / r2]),
            sum([6.0 * u2 * v / r3, -2.0 * v2 * v / r3]),
            sum([6.0 * u * v2 / r3, -2.0 * u2 * u / r3]),
            sum([2.0 * v2 * v / r3, -6.0 * u2 * v / r3]),
            sum([2.0 * u2 * u / r3, -6.0 * u * v2 / r3]),
        ],
        single([p.exp(); 4]),
        single([p.ln(), 1.0 / p, -1.0 / pp, 2.0 / ppp]),
        of_product(u, v, tanh),
        single([p.abs(), p.signum(), 0.0, 0.0]),
        single([pp * ppp, 5.0 * pp * pp, 20.0 * ppp, 60.0 * pp]),
        single([1.0 / ppp, -3.0 / (pp * pp), 12.0 / (pp * ppp), -60.0 / (ppp * ppp)]),
    ]
}

/// Seeds `u` and `v`, computes, and compares the parts which `parts` names.
fn follows<T: Scalar, const N: usize>(seed: impl Fn(T, T) -> (T, T), parts: impl Fn(T) -> [(usize, T::Real); N]) {
    // A few roundings: 1e-15 for f64 is 4.5 spacings above one.
    let tolerance = 1e-15 / f64::EPSILON * T::Real::EPSILON.as_f64();
    for (u, v) in [(0.75, 1.25), (2.5, 0.125), (-1.5, -3.0)] {
        let (dual_u, dual_v) = seed(T::literal(u), T::literal(v));
        for (case, (got, want)) in computed(dual_u, dual_v).into_iter().zip(exact(u, v)).enumerate() {
            for (part, got) in parts(got).into_iter().chain([(0, got.real())]) {
                let (want, size) = want[part];
                let error = (got.as_f64() - want).abs();
                let kind = core::any::type_name::<T>();
                assert!(error <= tolerance * size, "{kind} {case} {part}: {got} not {want}, {:e}", error / size);
            }
        }
    }
}

fn kinds<R: Real + num_dual::DualNum>() {
    follows(|u: Dual<R>, v| (u.derivative(), v), |f| [(U, f.eps)]);
    follows(|u, v: Dual<R>| (u, v.derivative()), |f| [(V, f.eps)]);
    follows(|u: Dual2<R>, v| (u.derivative(), v), |f| [(U, f.v1), (UU, f.v2)]);
    follows(|u, v: Dual2<R>| (u, v.derivative()), |f| [(V, f.v1), (VV, f.v2)]);
    follows(|u: Dual3<R>, v| (u.derivative(), v), |f| [(U, f.v1), (UU, f.v2), (UUU, f.v3)]);
    follows(|u, v: Dual3<R>| (u, v.derivative()), |f| [(V, f.v1), (VV, f.v2), (VVV, f.v3)]);
    let mixed = |f: HyperDual<R>| [(U, f.eps1), (V, f.eps2), (UV, f.eps1eps2)];
    follows(|u: HyperDual<R>, v| (u.derivative1(), v.derivative2()), mixed);
    let twice = |f: HyperDual<R>| [(U, f.eps1), (U, f.eps2), (UU, f.eps1eps2)];
    follows(|u: HyperDual<R>, v| (u.derivative1().derivative2(), v), twice);
    follows(
        |u: HyperHyperDual<R>, v| (u.derivative1().derivative2(), v.derivative3()),
        |f| {
            let first = [(U, f.eps1), (U, f.eps2), (V, f.eps3)];
            let second = [(UU, f.eps1eps2), (UV, f.eps1eps3), (UV, f.eps2eps3)];
            [first[0], first[1], first[2], second[0], second[1], second[2], (UUV, f.eps1eps2eps3)]
        },
    );
    follows(
        |u: HyperHyperDual<R>, v| (u.derivative1(), v.derivative2().derivative3()),
        |f| [(UV, f.eps1eps2), (UV, f.eps1eps3), (VV, f.eps2eps3), (UVV, f.eps1eps2eps3)],
    );
    follows(
        |u: DualSVec<R, 2>, v| (u.derivative(0), v.derivative(1)),
        |f| {
            let gradient = f.eps.unwrap_generic(Const::<2>, U1);
            [(U, gradient[0]), (V, gradient[1])]
        },
    );
    follows(
        |u: Dual2SVec<R, 2>, v| (u.derivative(0), v.derivative(1)),
        |f| {
            let gradient = f.v1.unwrap_generic(U1, Const::<2>);
            let hessian = f.v2.unwrap_generic(Const::<2>, Const::<2>);
            let [uu, uv, vu, vv] = [hessian[0], hessian[1], hessian[2], hessian[3]];
            [(U, gradient[0]), (V, gradient[1]), (UU, uu), (UV, uv), (UV, vu), (VV, vv)]
        },
    );
    follows(
        |u: HyperDualVec<R, Const<2>, Const<1>>, v| (u.derivative1(0), v.derivative1(1).derivative2(0)),
        |f| {
            let gradient = f.eps1.unwrap_generic(Const::<2>, U1);
            let hessian = f.eps1eps2.unwrap_generic(Const::<2>, U1);
            [(U, gradient[0]), (V, gradient[1]), (UV, hessian[0]), (VV, hessian[1])]
        },
    );
    // Duals of duals, too.
    let inner = |number: R| Dual::new(number, R::one());
    follows(
        |u: Dual<Dual<R>>, v| (u.derivative(), Dual::from_re(inner(v.re.re))),
        |f| [(U, f.eps.re), (V, f.re.eps), (UV, f.eps.eps)],
    );
}

#[test]
fn derivatives_follow_closed_forms() {
    kinds::<f64>();
    kinds::<f32>();
}

/// Where laws of friction and stops turn round, nothing of a number is NaN: value, slope and the two derivatives that follow.
#[test]
fn at_zero_derivatives_are_those_of_either_side_or_between() {
    let parts = |f: fn(Dual3<f64>) -> Dual3<f64>| {
        let Dual3 { re, v1, v2, v3, .. } = f(Dual3::from_re(0.0).derivative());
        [re, v1, v2, v3]
    };
    assert_eq!(parts(Scalar::abs), [0.0; 4]);
    assert_eq!(parts(Scalar::sign), [0.0; 4]);
    assert_eq!(parts(Elementary::exp), [1.0; 4]);
    assert_eq!(parts(Elementary::tanh), [0.0, 1.0, 0.0, -2.0]);
    assert_eq!(parts(|x| Scalar::powi(x, 0)), [1.0, 0.0, 0.0, 0.0]);
    assert_eq!(parts(|x| Scalar::powi(x, 1)), [0.0, 1.0, 0.0, 0.0]);
    assert_eq!(parts(|x| Scalar::powi(x, 2)), [0.0, 0.0, 2.0, 0.0]);
    assert_eq!(parts(|x| Scalar::powi(x, 3)), [0.0, 0.0, 0.0, 6.0]);
    // |x| x has a slope everywhere.
    assert_eq!(parts(|x| Scalar::abs(x) * x)[..2], [0.0, 0.0]);
    // Far out a hyperbolic tangent is flat, not lost.
    let far = Elementary::tanh(Dual3::from_re(-1e3).derivative());
    assert_eq!([far.re, far.v1, far.v2, far.v3], [-1.0, 0.0, 0.0, 0.0]);
}

#[test]
fn values_of_duals_are_those_of_plain_numbers() {
    computes_like_its_plain_number::<Dual<f64>>();
    computes_like_its_plain_number::<Dual<f32>>();
    computes_like_its_plain_number::<DualSVec<f64, 3>>();
    computes_like_its_plain_number::<Dual2<f64>>();
    computes_like_its_plain_number::<Dual2SVec<f32, 2>>();
    computes_like_its_plain_number::<Dual3<f64>>();
    computes_like_its_plain_number::<HyperDual<f64>>();
    computes_like_its_plain_number::<HyperDualVec<f64, Const<2>, Const<3>>>();
    computes_like_its_plain_number::<HyperHyperDual<f64>>();
    computes_like_its_plain_number::<Dual<DualSVec<f64, 2>>>();
}

#[test]
fn constants_have_no_derivatives() {
    assert_eq!(Dual::<f64>::constant(2.0).eps, 0.0);
    assert_eq!(DualSVec::<f64, 3>::constant(2.0).eps, Derivative::none());
    let number = HyperDual::<f64>::constant(2.0);
    assert_eq!([number.eps1, number.eps2, number.eps1eps2], [0.0; 3]);
    assert_eq!(Dual2SVec::<f64, 2>::constant(2.0).v2, Derivative::none());
    // Nor do they gain any, or lose others'.
    let number = DualSVec::<f64, 2>::constant(2.0);
    assert_eq!(number.mul_add(number, number).sin_cos().0.eps, Derivative::none());
    let (absent, present) = (number.mul_add(number, number.derivative(1)), number.derivative(1));
    assert_eq!(absent.eps, present.eps);
}

#[test]
fn a_derivative_that_is_not_a_number_makes_a_dual_not_finite() {
    const NAN: f64 = f64::NAN;
    assert!(!Dual::new(1.0, NAN).is_finite());
    assert!(!Dual::new(NAN, 1.0).is_finite());
    assert!(!Dual2::new(1.0, 1.0, f64::INFINITY).is_finite());
    assert!(!Dual3::new(1.0, 1.0, 1.0, NAN).is_finite());
    assert!(!HyperDual::new(1.0, 1.0, 1.0, NAN).is_finite());
    assert!(!HyperHyperDual::new(1.0, 1.0, 1.0, 1.0, 1.0, 1.0, NAN, 1.0).is_finite());
    let mut number = DualSVec::<f64, 3>::constant(1.0).derivative(0);
    assert!(number.is_finite());
    number.eps.0.as_mut().unwrap()[2] = NAN;
    assert!(!number.is_finite());
}
