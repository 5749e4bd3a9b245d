//! Functions of power series, by the differential equations that they obey (R. E. Moore, Interval Analysis, 1966, chapter 11).

use super::Powers;
use crate::scalar::{Elementary, Real, Scalar};
use num_traits::One;

impl<T: Scalar, const N: usize> Elementary for Powers<T, N> {
    fn sqrt(self) -> Self {
        let first = self.first().sqrt();
        let half = first.recip().scale(T::Real::of(0.5));
        let rest = |k: usize, root: &[T; N]| (1..k).fold(self.terms[k], |sum, j| sum - root[j] * root[k - j]);
        Self::solved(self.composed(), self.asked, first, |k, root| rest(k, root) * half)
    }
    fn sin_cos(self) -> (Self, Self) {
        let (mut sine, mut cosine, count) = ([T::zero(); N], [T::zero(); N], self.composed());
        let slope = self.derivative();
        for k in 0..count {
            (sine[k], cosine[k]) = match k {
                0 => self.first().sin_cos(),
                _ => (slope.chained(&cosine, k), -slope.chained(&sine, k)),
            };
        }
        (Self { terms: sine, count, ..self }, Self { terms: cosine, count, ..self })
    }
    fn atan2(self, x: Self) -> Self {
        let slope = (x * self.derivative() - self * x.derivative()) / (x * x + self * self);
        Self::integral(self.first().atan2(x.first()), slope)
    }
    fn exp(self) -> Self {
        let slope = self.derivative();
        Self::solved(self.composed(), self.asked, self.first().exp(), |k, all| slope.chained(all, k))
    }
    fn ln(self) -> Self {
        Self::integral(self.first().ln(), self.derivative() / self)
    }
    fn tanh(self) -> Self {
        // y′ = x′ (1 − y²), whose coefficients up to k − 1 are known where y's are.
        let (mut terms, mut rest, count) = ([T::zero(); N], [T::zero(); N], self.composed());
        let slope = self.derivative();
        for k in 0..count {
            terms[k] = if k == 0 { self.first().tanh() } else { slope.chained(&rest, k) };
            let square = (0..=k).fold(T::zero(), |sum, j| terms[j].mul_add(terms[k - j], sum));
            rest[k] = if k == 0 { (T::one() - terms[0]) * (T::one() + terms[0]) } else { -square };
        }
        Self { terms, count, ..self }
    }
}

impl<T: Scalar, const N: usize> Scalar for Powers<T, N> {
    type Real = T::Real;
    const ANGLE_RANGE: T::Real = T::ANGLE_RANGE;
    const LANES: bool = T::LANES;

    fn constant(value: T::Real) -> Self {
        Self::of(T::constant(value))
    }
    fn real(self) -> T::Real {
        self.first().real()
    }
    fn is_finite(self) -> bool {
        self.terms.iter().all(|x| x.is_finite())
    }
    fn scale(self, factor: T::Real) -> Self {
        self.map(|x| x.scale(factor))
    }
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
    fn recip(self) -> Self {
        Self::one() / self
    }
    fn if_negative(self, then: Self, otherwise: Self) -> Self {
        then.zip(otherwise, |then, otherwise| self.first().if_negative(then, otherwise))
    }
    fn abs(self) -> Self {
        self.map(|x| x * self.first().sign())
    }
    fn sign(self) -> Self {
        Self::of(self.first().sign())
    }
}

#[cfg(test)]
mod tests {
    use super::{Elementary, One, Powers, Scalar};

    type Ten = Powers<f64, 10>;

    fn full(terms: [f64; 10]) -> Ten {
        Powers { terms, count: 10, asked: 10 }
    }

    fn near(name: &str, a: Ten, b: Ten) {
        for (k, (a, b)) in a.terms.iter().zip(b.terms).enumerate() {
            assert!((a - b).abs() < 1e-13 * (1.0 + b.abs()), "{name}, {k}: {a} {b}");
        }
    }

    #[test]
    fn known_series_are_found() {
        let t = Ten::variable(0.0, 10);
        let mut factorial = 1.0;
        for (k, coefficient) in t.exp().terms.iter().enumerate() {
            factorial *= k.max(1) as f64;
            assert!((coefficient * factorial - 1.0).abs() < 1e-15);
        }
        near("geometric", (Ten::one() - t).recip(), full([1.0; 10]));
        let (sine, cosine) = t.sin_cos();
        near(
            "sine",
            sine,
            full([0.0, 1.0, 0.0, -1.0 / 6.0, 0.0, 1.0 / 120.0, 0.0, -1.0 / 5040.0, 0.0, 1.0 / 362_880.0]),
        );
        near("sine's slope", sine.derivative(), cosine.cut());
        let third = 1.0 / 3.0;
        near(
            "tangent",
            t.tanh(),
            full([0.0, 1.0, 0.0, -third, 0.0, 2.0 / 15.0, 0.0, -17.0 / 315.0, 0.0, 62.0 / 2835.0]),
        );
    }

    impl Ten {
        /// Without the last coefficient, which a derivative does not know.
        fn cut(mut self) -> Self {
            self.terms[9] = 0.0;
            self
        }
    }

    /// What is left out where there are few coefficients is zero.
    #[test]
    fn polynomials_are_series_of_few_terms() {
        let (x, one) = (Ten::variable(0.7, 10), Ten::one());
        let line = x.scale(3.0) - one;
        let parabola = line * line + x;
        assert_eq!([one.count, line.count, parabola.count, (one / one).count, (line / one).count], [1, 2, 3, 1, 2]);
        let cubic = parabola * line;
        assert_eq!((cubic.count, cubic * cubic * cubic * cubic), (4, full((cubic * cubic * cubic * cubic).terms)));
        let short = (Ten::variable(0.7, 4) * x).exp();
        assert_eq!((short.count, &short.terms[..4]), (4, &(x * x).exp().terms[..4]));
        let whole = |x: Ten| full(x.terms);
        for (name, few) in [("line", line), ("parabola", parabola), ("one", one)] {
            let all = whole(few);
            near(name, few.exp(), all.exp());
            near(name, few.sqrt(), all.sqrt());
            near(name, few.ln(), all.ln());
            near(name, few.tanh(), all.tanh());
            near(name, few.sin_cos().0, all.sin_cos().0);
            near(name, few.sin_cos().1, all.sin_cos().1);
            near(name, few.atan2(x), all.atan2(whole(x)));
            near(name, few / parabola, all / whole(parabola));
            near(name, few.recip(), all.recip());
            near(name, few * cubic, all * whole(cubic));
            near(name, few.abs() - x, all.abs() - whole(x));
            near(name, few.if_negative(x, parabola), all.if_negative(whole(x), whole(parabola)));
        }
    }

    #[test]
    fn inverse_functions_lead_back() {
        let x = full([0.7, -1.1, 0.4, 0.3, -0.2, 0.1, 0.5, -0.6, 0.2, 0.1]);
        near("root", x.sqrt() * x.sqrt(), x);
        near("logarithm", x.ln().exp(), x);
        near("quotient", x / (x + Ten::one()) * (x + Ten::one()), x);
        let (sine, cosine) = x.sin_cos();
        near("angle", sine.atan2(cosine), x);
        near("circle", sine * sine + cosine * cosine, Ten::one());
        let square = (x + x).exp();
        near("hyperbola", x.tanh(), (square - Ten::one()) / (square + Ten::one()));
        near("magnitude", (-x).abs(), x);
        near("power", x.powi(3), x * x * x);
    }
}
