//! Numbers of which some are known to be zero, one or minus one, and vectors and matrices of them.
//!
//! What is known is a constant of the types that a kernel is compiled for. Where the kernel is inlined, as all here are, nothing is left
//! of the question, and no product with a zero either: compilers may fold neither `x * 0.0` nor `x + 0.0`.

use crate::scalar::Scalar;

/// What is known of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Known {
    Zero,
    One,
    Minus,
    Nothing,
}

/// A number that may be known to be zero, one or minus one.
#[derive(Clone, Copy, Debug)]
pub struct Number<T> {
    known: Known,
    value: T,
}

/// Three numbers.
pub type Triple<T> = [Number<T>; 3];
/// Rows of a matrix.
pub type Rows<T> = [Triple<T>; 3];
/// One triangle of a symmetric matrix: xx, yy, zz, yz, xz, xy.
pub type Triangle<T> = [Number<T>; 6];

impl<T: Scalar> Number<T> {
    /// Zero. Its value is −0, which compilers do fold in sums.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { known: Known::Zero, value: -T::zero() }
    }
    /// One.
    #[inline(always)]
    pub fn one() -> Self {
        Self { known: Known::One, value: T::one() }
    }
    /// A number of which nothing is known.
    #[inline(always)]
    pub fn of(value: T) -> Self {
        Self { known: Known::Nothing, value }
    }
    /// A number where a mask says so; else zero.
    #[inline(always)]
    pub fn masked(mask: u8, bit: usize, value: T) -> Self {
        if mask >> bit & 1 == 1 { Self::of(value) } else { Self::zero() }
    }
    /// The number.
    #[inline(always)]
    pub fn value(self) -> T {
        self.value
    }
    /// −self.
    #[cfg_attr(optimised, inline(always))]
    pub fn negated(self) -> Self {
        match self.known {
            Known::Zero => self,
            Known::One => Self { known: Known::Minus, value: -self.value },
            Known::Minus => Self { known: Known::One, value: -self.value },
            Known::Nothing => Self::of(-self.value),
        }
    }
    /// self · other.
    #[cfg_attr(optimised, inline(always))]
    pub fn times(self, other: Self) -> Self {
        match (self.known, other.known) {
            (Known::Zero, _) | (_, Known::Zero) => Self::zero(),
            (Known::One, _) => other,
            (_, Known::One) => self,
            (Known::Minus, _) => other.negated(),
            (_, Known::Minus) => self.negated(),
            (Known::Nothing, Known::Nothing) => Self::of(self.value * other.value),
        }
    }
    /// self + other.
    #[cfg_attr(optimised, inline(always))]
    pub fn plus(self, other: Self) -> Self {
        match (self.known, other.known) {
            (Known::Zero, _) => other,
            (_, Known::Zero) => self,
            _ => Self::of(self.value + other.value),
        }
    }
    /// self − other.
    #[cfg_attr(optimised, inline(always))]
    pub fn minus(self, other: Self) -> Self {
        match (self.known, other.known) {
            (_, Known::Zero) => self,
            (Known::Zero, _) => other.negated(),
            _ => Self::of(self.value - other.value),
        }
    }
    /// self · factor + sum.
    #[cfg_attr(optimised, inline(always))]
    pub fn times_onto(self, factor: Self, sum: Self) -> Self {
        match (self.known, factor.known, sum.known) {
            (Known::Nothing, Known::Nothing, Known::One | Known::Minus | Known::Nothing) => {
                Self::of(self.value.mul_add(factor.value, sum.value))
            }
            _ => sum.plus(self.times(factor)),
        }
    }
    /// sum − self · factor.
    #[inline(always)]
    pub fn times_off(self, factor: Self, sum: Self) -> Self {
        self.negated().times_onto(factor, sum)
    }
}

/// Three numbers of which nothing is known.
#[inline(always)]
pub fn triple<T: Scalar>([x, y, z]: [T; 3]) -> Triple<T> {
    [Number::of(x), Number::of(y), Number::of(z)]
}

/// One triangle, those numbers zero that a mask does not name.
#[cfg_attr(optimised, inline(always))]
pub fn triangle<T: Scalar>(mask: u8, [a, b, c, d, e, f]: [T; 6]) -> Triangle<T> {
    [
        Number::masked(mask, 0, a),
        Number::masked(mask, 1, b),
        Number::masked(mask, 2, c),
        Number::masked(mask, 3, d),
        Number::masked(mask, 4, e),
        Number::masked(mask, 5, f),
    ]
}

/// The values of a triangle.
#[inline(always)]
pub fn triangle_values<T: Scalar>([a, b, c, d, e, f]: Triangle<T>) -> [T; 6] {
    [a.value, b.value, c.value, d.value, e.value, f.value]
}

/// The sum of two triangles.
#[inline(always)]
pub fn triangle_sum<T: Scalar>(a: &Triangle<T>, b: &Triangle<T>) -> Triangle<T> {
    [a[0].plus(b[0]), a[1].plus(b[1]), a[2].plus(b[2]), a[3].plus(b[3]), a[4].plus(b[4]), a[5].plus(b[5])]
}

/// A triangle less the product of a column and a row, of which it is known to be symmetric.
#[cfg_attr(optimised, inline(always))]
pub fn triangle_less<T: Scalar>(s: &Triangle<T>, u: Triple<T>, g: Triple<T>) -> Triangle<T> {
    [
        u[0].times_off(g[0], s[0]),
        u[1].times_off(g[1], s[1]),
        u[2].times_off(g[2], s[2]),
        u[1].times_off(g[2], s[3]),
        u[0].times_off(g[2], s[4]),
        u[0].times_off(g[1], s[5]),
    ]
}

/// Three numbers times a factor.
#[inline(always)]
pub fn scaled<T: Scalar>(a: Triple<T>, factor: Number<T>) -> Triple<T> {
    [a[0].times(factor), a[1].times(factor), a[2].times(factor)]
}

/// `start` − factor · a.
#[inline(always)]
pub fn less<T: Scalar>(start: Triple<T>, factor: Number<T>, a: Triple<T>) -> Triple<T> {
    [factor.times_off(a[0], start[0]), factor.times_off(a[1], start[1]), factor.times_off(a[2], start[2])]
}

/// `start` + factor · a.
#[inline(always)]
pub fn more<T: Scalar>(start: Triple<T>, factor: Number<T>, a: Triple<T>) -> Triple<T> {
    [factor.times_onto(a[0], start[0]), factor.times_onto(a[1], start[1]), factor.times_onto(a[2], start[2])]
}

/// Three numbers, those zero that a mask does not name.
#[inline(always)]
pub fn masked<T: Scalar>(mask: u8, [x, y, z]: [T; 3]) -> Triple<T> {
    [Number::masked(mask, 0, x), Number::masked(mask, 1, y), Number::masked(mask, 2, z)]
}

/// The values of three numbers.
#[inline(always)]
pub fn values<T: Scalar>([x, y, z]: Triple<T>) -> [T; 3] {
    [x.value, y.value, z.value]
}

/// a + b.
#[inline(always)]
pub fn sum<T: Scalar>(a: Triple<T>, b: Triple<T>) -> Triple<T> {
    [a[0].plus(b[0]), a[1].plus(b[1]), a[2].plus(b[2])]
}

/// `start` + a · b.
#[inline(always)]
pub fn dot_onto<T: Scalar>(a: Triple<T>, b: Triple<T>, start: Number<T>) -> Number<T> {
    a[2].times_onto(b[2], a[1].times_onto(b[1], a[0].times_onto(b[0], start)))
}

/// `start` + a × b.
#[cfg_attr(optimised, inline(always))]
pub fn cross_onto<T: Scalar>(a: Triple<T>, b: Triple<T>, start: Triple<T>) -> Triple<T> {
    [
        a[2].times_off(b[1], a[1].times_onto(b[2], start[0])),
        a[0].times_off(b[2], a[2].times_onto(b[0], start[1])),
        a[1].times_off(b[0], a[0].times_onto(b[1], start[2])),
    ]
}

/// `start` + R v.
#[inline(always)]
pub fn apply_onto<T: Scalar>(rows: &Rows<T>, v: Triple<T>, start: Triple<T>) -> Triple<T> {
    [dot_onto(rows[0], v, start[0]), dot_onto(rows[1], v, start[1]), dot_onto(rows[2], v, start[2])]
}

/// R v.
#[inline(always)]
pub fn apply<T: Scalar>(rows: &Rows<T>, v: Triple<T>) -> Triple<T> {
    apply_onto(rows, v, [Number::zero(); 3])
}

/// Rᵀ.
#[inline(always)]
pub fn transposed<T: Scalar>(rows: &Rows<T>) -> Rows<T> {
    let [a, b, c] = rows;
    [[a[0], b[0], c[0]], [a[1], b[1], c[1]], [a[2], b[2], c[2]]]
}

/// A B.
#[inline(always)]
pub fn product<T: Scalar>(a: &Rows<T>, b: &Rows<T>) -> Rows<T> {
    let columns = transposed(b);
    [apply(&columns, a[0]), apply(&columns, a[1]), apply(&columns, a[2])]
}

/// The rows of a symmetric matrix.
#[inline(always)]
pub fn rows<T: Scalar>(s: &Triangle<T>) -> Rows<T> {
    [[s[0], s[5], s[4]], [s[5], s[1], s[3]], [s[4], s[3], s[2]]]
}

/// R S Rᵀ.
#[cfg_attr(optimised, inline(always))]
pub fn congruent<T: Scalar>(turn: &Rows<T>, s: &Triangle<T>) -> Triangle<T> {
    let (half, o) = (product(turn, &rows(s)), Number::zero());
    [
        dot_onto(half[0], turn[0], o),
        dot_onto(half[1], turn[1], o),
        dot_onto(half[2], turn[2], o),
        dot_onto(half[1], turn[2], o),
        dot_onto(half[0], turn[2], o),
        dot_onto(half[0], turn[1], o),
    ]
}

/// The matrix of a × .
#[inline(always)]
pub fn tilde<T: Scalar>([x, y, z]: Triple<T>) -> Rows<T> {
    let o = Number::zero();
    [[o, z.negated(), y], [z, o, x.negated()], [y.negated(), x, o]]
}
