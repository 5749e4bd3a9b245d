//! Every number does what plain `f64` does, derivatives follow closed forms, and lanes do not see each other.

use catena::scalar::{Elementary, Real, Scalar};

mod duals;
mod lanes;

/// Points (y, x) in all quadrants, y being an angle [rad] too; exact in `f32`, so that it can be used for all numbers.
const POINTS: [(f64, f64); 6] = [(0.75, 1.25), (-2.5, 0.5), (3.25, -4.0), (-0.125, -7.5), (1000.5, 3.0), (0.0, 2.0)];

/// The operations of `Scalar` on `T` against those on its plain number, both bit for bit: the same instructions run.
fn computes_like_its_plain_number<T: Scalar>() {
    let same = |number: T, plain: T::Real, what: &str| {
        let (got, want) = (number.real().as_f64(), plain.as_f64());
        assert_eq!(got.to_bits(), want.to_bits(), "{what}: {got} instead of {want}");
    };
    for (y, x) in POINTS {
        let (plain_y, plain_x) = (T::Real::of(y), T::Real::of(x));
        let (y, x) = (T::constant(plain_y), T::literal(x));
        same(y, plain_y, "constant");
        same(x, plain_x, "literal");
        same(y.scale(plain_x), plain_y * plain_x, "scale");
        same(y.mul_add(x, x), plain_y.mul_add(plain_x, plain_x), "mul_add");
        same(x.recip(), plain_x.recip(), "recip");
        same((x * x).sqrt(), (plain_x * plain_x).sqrt(), "sqrt");
        same(y.atan2(x), plain_y.atan2(plain_x), "atan2");
        same(Elementary::exp(y.scale(T::Real::of(0.125))), Elementary::exp(plain_y * T::Real::of(0.125)), "exp");
        same(Elementary::ln(x * x), Elementary::ln(plain_x * plain_x), "ln");
        same(Elementary::tanh(y), Elementary::tanh(plain_y), "tanh");
        same(Scalar::abs(y), Scalar::abs(plain_y), "abs");
        same(Scalar::sign(y), Scalar::sign(plain_y), "sign");
        for exponent in [-3, 0, 1, 2, 7] {
            same(Scalar::powi(x, exponent), Scalar::powi(plain_x, exponent), "powi");
        }
        same(y.sin_cos().0, plain_y.sin_cos().0, "sine");
        same(y.sin_cos().1, plain_y.sin_cos().1, "cosine");
        assert!(y.is_finite() && x.is_finite());
        assert!(!(y / T::zero()).is_finite());
    }
    assert_eq!(T::ANGLE_RANGE.as_f64(), 4e5);
}

#[test]
fn plain_numbers_compute_like_the_standard_library() {
    computes_like_its_plain_number::<f32>();
    computes_like_its_plain_number::<f64>();
    for (y, x) in POINTS {
        assert_eq!(Scalar::scale(y, x), y * x);
        assert_eq!(Scalar::recip(x), 1.0 / x);
        // Root and arctangent come from the standard library, or from `libm` which is held to one ulp.
        assert!((Elementary::sqrt(x * x) - x.abs()).abs() <= f64::EPSILON * x.abs());
        assert!((Elementary::atan2(y, x) - f64::atan2(y, x)).abs() <= 2.0 * f64::EPSILON * f64::atan2(y, x).abs());
        let near = |got: f64, want: f64, ulps: f64| {
            assert!((got - want).abs() <= ulps * f64::EPSILON * want.abs(), "{got:e} instead of {want:e}");
        };
        near(Elementary::exp(0.125 * y), f64::exp(0.125 * y), 2.0);
        near(Elementary::ln(x * x), f64::ln(x * x), 2.0);
        near(Elementary::tanh(y), f64::tanh(y), 2.0);
        assert_eq!(Scalar::abs(y), f64::abs(y));
        assert_eq!(Scalar::sign(y), if y == 0.0 { 0.0 } else { f64::signum(y) });
        // A rounding a product.
        for exponent in [-3, 0, 1, 2, 7] {
            near(Scalar::powi(x, exponent), f64::powi(x, exponent), 4.0);
        }
        // One rounding of the product more or less.
        assert!((Scalar::mul_add(y, x, 0.1) - (y * x + 0.1)).abs() <= f64::EPSILON * (y * x).abs());
        // An ulp each on our and on their side.
        let (sine, cosine) = Elementary::sin_cos(y);
        assert!((sine - y.sin()).abs() <= f64::EPSILON && (cosine - y.cos()).abs() <= f64::EPSILON);
    }
    assert_eq!(Real::powf(2.0_f64, 0.5), core::f64::consts::SQRT_2);
    assert_eq!(Scalar::powi(2.0_f64, i32::MIN), 0.0);
    assert_eq!(Scalar::sign(f64::NAN), 0.0);
    assert_eq!(Real::max(f64::NAN, 1.0), 1.0);
    assert_eq!(Real::min(1.0, f32::NAN), 1.0);
    assert_eq!(<f32 as Real>::of(0.1), 0.1);
}

/// A user's own number: plain `f64`, except that sine and cosine are those of the system.
mod own {
    use super::*;
    use core::ops::*;

    #[derive(Clone, Copy, PartialEq, Debug)]
    pub struct SystemSine(pub f64);

    impl Elementary for SystemSine {
        fn sqrt(self) -> Self {
            Self(self.0.sqrt())
        }
        fn sin_cos(self) -> (Self, Self) {
            let (sine, cosine) = f64::sin_cos(self.0);
            (Self(sine), Self(cosine))
        }
        fn atan2(self, x: Self) -> Self {
            Self(self.0.atan2(x.0))
        }
        fn exp(self) -> Self {
            Self(self.0.exp())
        }
        fn ln(self) -> Self {
            Self(self.0.ln())
        }
        fn tanh(self) -> Self {
            Self(self.0.tanh())
        }
    }

    impl Scalar for SystemSine {
        type Real = f64;
        const ANGLE_RANGE: f64 = 1e9;

        fn constant(value: f64) -> Self {
            Self(value)
        }
        fn real(self) -> f64 {
            self.0
        }
        fn is_finite(self) -> bool {
            self.0.is_finite()
        }
        fn scale(self, factor: f64) -> Self {
            Self(self.0 * factor)
        }
        fn mul_add(self, factor: Self, addend: Self) -> Self {
            Self(Scalar::mul_add(self.0, factor.0, addend.0))
        }
        fn recip(self) -> Self {
            Self(1.0 / self.0)
        }
        fn abs(self) -> Self {
            Self(self.0.abs())
        }
        fn sign(self) -> Self {
            Self(Scalar::sign(self.0))
        }
    }

    impl num_traits::Zero for SystemSine {
        fn zero() -> Self {
            Self(0.0)
        }
        fn is_zero(&self) -> bool {
            self.0 == 0.0
        }
    }

    impl num_traits::One for SystemSine {
        fn one() -> Self {
            Self(1.0)
        }
    }

    impl Neg for SystemSine {
        type Output = Self;
        fn neg(self) -> Self {
            Self(-self.0)
        }
    }

    macro_rules! operators {
        ($($operator:ident $method:ident, $assign:ident $assign_method:ident;)*) => {$(
            impl $operator for SystemSine {
                type Output = Self;
                fn $method(self, other: Self) -> Self {
                    Self(self.0.$method(other.0))
                }
            }
            impl $assign for SystemSine {
                fn $assign_method(&mut self, other: Self) {
                    self.0.$assign_method(other.0);
                }
            }
        )*};
    }

    operators! {
        Add add, AddAssign add_assign;
        Sub sub, SubAssign sub_assign;
        Mul mul, MulAssign mul_assign;
        Div div, DivAssign div_assign;
    }
}

#[test]
fn a_number_of_ones_own_needs_nothing_but_the_trait() {
    fn height<T: Scalar>(angle: T, length: T) -> T {
        -(length * angle.sin_cos().1)
    }
    let (angle, length) = (0.3, 2.0);
    let system = height(own::SystemSine(angle), own::SystemSine(length));
    assert_eq!(system.real(), -(length * f64::cos(angle)));
    // An ulp of the cosine on either side, times the length.
    assert!((system.real() - height(angle, length)).abs() <= length * f64::EPSILON);
}
