//! Taylor series in space: products of series, four numbers at a time.

use super::AxesSeries;
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// Three rows of four numbers: of one coefficient, or of sums of products.
pub type Rows<T> = [[T; 4]; 3];

/// Nothing.
#[inline(always)]
pub fn none<T: Scalar>() -> Rows<T> {
    [[T::zero(); 4]; 3]
}

/// `sum` + a b.
#[inline(always)]
fn add<T: Scalar>(sum: [T; 4], a: T, b: [T; 4]) -> [T; 4] {
    core::array::from_fn(|i| a.mul_add(b[i], sum[i]))
}

/// `sum` + a b, number by number.
#[inline(always)]
fn add_each<T: Scalar>(sum: [T; 4], a: [T; 4], b: [T; 4]) -> [T; 4] {
    core::array::from_fn(|i| a[i].mul_add(b[i], sum[i]))
}

/// The difference, number by number.
#[inline(always)]
fn minus<T: Scalar>(a: [T; 4], b: [T; 4]) -> [T; 4] {
    core::array::from_fn(|i| a[i] - b[i])
}

/// The vector as a row.
#[inline(always)]
pub fn row<T: Scalar>(v: Vector3<T>) -> [T; 4] {
    [v.x, v.y, v.z, T::zero()]
}

/// Rows to be multiplied by the entries of a vector, for its cross products with two others: see [`crossed`].
#[inline(always)]
pub fn across<T: Scalar>(u: Vector3<T>, v: Vector3<T>) -> Rows<T> {
    [[u.y, u.z, v.y, v.z], [u.z, u.x, v.z, v.x], [u.x, u.y, v.x, v.y]]
}

/// The cross product of the vector with the first of two (`at` 0) or with the second (`at` 2), from its products with the rows of
/// [`across`].
#[inline(always)]
pub fn crossed<T: Scalar>([x, y, z]: &Rows<T>, at: usize) -> Vector3<T> {
    Vector3::new(y[at] - z[at + 1], z[at] - x[at + 1], x[at] - y[at + 1])
}

/// Sums up products of all coefficients whose numbers add up to that of the last ones. Those of the newest come last: others need not wait
/// for them.
#[inline(always)]
fn convolve<T: Copy, X>(
    turned: &[Rows<T>],
    turning: &[Rows<T>],
    sum: X,
    mut add: impl FnMut(X, &Rows<T>, &Rows<T>) -> X,
) -> X {
    let (Some((first, turned)), Some((last, turning))) = (turned.split_first(), turning.split_first()) else {
        return sum;
    };
    let (Some((newest, turned)), Some((recent, turning))) = (turned.split_last(), turning.split_last()) else {
        return add(sum, first, last);
    };
    let mut sum = sum;
    for (a, b) in turned.iter().zip(turning.iter().rev()) {
        sum = add(sum, a, b);
    }
    sum = add(sum, first, recent);
    add(sum, newest, last)
}

/// Each entry of the vector that turns times its row.
///
/// A function of its own, with its sums in memory: so a compiler keeps four of them in one register.
#[inline(never)]
fn sweep<T: Scalar>(turned: &[Rows<T>], turning: &[Rows<T>]) -> Rows<T> {
    convolve(turned, turning, none(), |[x, y, z], [v, ..], [a, b, c]| {
        [add(x, v[0], *a), add(y, v[1], *b), add(z, v[2], *c)]
    })
}

/// Each entry of the vector that turns times the one row.
#[inline(never)]
fn spread<T: Scalar>(turned: &[Rows<T>], turning: &[Rows<T>]) -> Rows<T> {
    convolve(turned, turning, none(), |[x, y, z], [v, ..], [a, ..]| {
        [add(x, v[0], *a), add(y, v[1], *a), add(z, v[2], *a)]
    })
}

/// Cross products of three vectors side by side, whose entries are rows, with three others, and of the angular velocity, the last column of
/// these, with each of them; what adds to them and what is taken from them.
#[inline(never)]
fn cross<T: Scalar>(turned: &[Rows<T>], turning: &[Rows<T>]) -> [Rows<T>; 4] {
    convolve(turned, turning, [none(); 4], |[plus, less, ahead, behind], [x, y, z], [u, v, w]| {
        let [p, q, r] = [u[3], v[3], w[3]];
        [
            [add_each(plus[0], *y, *w), add_each(plus[1], *z, *u), add_each(plus[2], *x, *v)],
            [add_each(less[0], *z, *v), add_each(less[1], *x, *w), add_each(less[2], *y, *u)],
            [add(ahead[0], q, *z), add(ahead[1], r, *x), add(ahead[2], p, *y)],
            [add(behind[0], r, *y), add(behind[1], p, *z), add(behind[2], q, *x)],
        ]
    })
}

impl<T: Scalar, const N: usize> AxesSeries<T, N> {
    /// Coefficients up to a number.
    #[inline(always)]
    fn known(&self, k: usize) -> (&[Rows<T>], &[Rows<T>]) {
        let count = (k + 1).min(N);
        (&self.turned[..count], &self.turning[..count])
    }

    /// Each entry of the vector that turns times its row.
    #[inline(always)]
    pub(super) fn swept(&self, k: usize) -> Rows<T> {
        let (turned, turning) = self.known(k);
        sweep(turned, turning)
    }

    /// Each entry of the vector that turns times the one row.
    #[inline(always)]
    pub(super) fn spread(&self, k: usize) -> Rows<T> {
        let (turned, turning) = self.known(k);
        spread(turned, turning)
    }

    /// Of three vectors side by side, whose entries are rows: the sum of their cross products with three others, and those of the angular
    /// velocity, the last column of these, with each of them.
    #[inline(always)]
    pub(super) fn crossed(&self, k: usize) -> (Vector3<T>, Rows<T>) {
        let (turned, turning) = self.known(k);
        let [plus, less, ahead, behind] = cross(turned, turning);
        let sum = |i: usize| {
            let [a, b, c, _] = minus(plus[i], less[i]);
            a + b + c
        };
        (Vector3::new(sum(0), sum(1), sum(2)), core::array::from_fn(|i| minus(ahead[i], behind[i])))
    }
}
