//! Taylor series in space: products of series, four numbers at a time.

use super::AxesSeries;
use crate::relation::spatial::algebra::Columns;
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

/// `sum` − a b, number by number.
#[inline(always)]
fn take_each<T: Scalar>(sum: [T; 4], a: [T; 4], b: [T; 4]) -> [T; 4] {
    core::array::from_fn(|i| (-a[i]).mul_add(b[i], sum[i]))
}

/// The vector as a row.
#[inline(always)]
pub fn row<T: Scalar>(v: Vector3<T>) -> [T; 4] {
    [v.x, v.y, v.z, T::zero()]
}

/// The first three of a row.
#[inline(always)]
pub fn vector<T: Scalar>([x, y, z, _]: [T; 4]) -> Vector3<T> {
    Vector3::new(x, y, z)
}

/// The matrix whose columns are rows here.
#[inline(always)]
pub fn columns<T: Scalar>([x, y, z]: &Rows<T>) -> Columns<T> {
    Columns { x: vector(*x), y: vector(*y), z: vector(*z) }
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
#[cfg_attr(optimised, inline(always))]
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

/// Each entry of the axis times its row; and, of the arm and the force beside it, the cross product: entries of the arm, of the next axis and of
/// the one after that, are the other rows.
#[inline(never)]
fn slide<T: Scalar>(turned: &[Rows<T>], turning: &[Rows<T>]) -> (Rows<T>, [T; 4]) {
    let nothing = (none(), [T::zero(); 4]);
    convolve(turned, turning, nothing, |([x, y, z], moment), [v, next, after], [a, b, c]| {
        let sums = [add(x, v[0], *a), add(y, v[1], *b), add(z, v[2], *c)];
        let ([p, q, r], o) = ([a[0], b[0], c[0]], T::zero());
        (sums, take_each(add_each(moment, *next, [r, p, q, o]), *after, [q, r, p, o]))
    })
}

/// `sum` and cross products of three vectors side by side with three others.
#[inline(always)]
fn add_cross<T: Scalar>(sum: Rows<T>, [x, y, z]: &Rows<T>, [u, v, w]: &Rows<T>) -> Rows<T> {
    let [a, b, c] = [add_each(sum[0], *y, *w), add_each(sum[1], *z, *u), add_each(sum[2], *x, *v)];
    [take_each(a, *z, *v), take_each(b, *x, *w), take_each(c, *y, *u)]
}

/// `sum` and cross products of a vector with three others side by side.
#[inline(always)]
fn add_turned<T: Scalar>(sum: Rows<T>, [x, y, z]: &Rows<T>, [p, q, r]: [T; 3]) -> Rows<T> {
    let [a, b, c] = [add(sum[0], q, *z), add(sum[1], r, *x), add(sum[2], p, *y)];
    [add(a, -r, *y), add(b, -p, *z), add(c, -q, *x)]
}

/// Rows by a number of the clock.
#[inline(always)]
pub fn scaled<T: Scalar>(rows: &Rows<T>, factor: T::Real) -> Rows<T> {
    core::array::from_fn(|i| core::array::from_fn(|j| rows[i][j].scale(factor)))
}

/// Sums of three vectors side by side, for each column of a symmetric matrix.
#[cfg_attr(optimised, inline(always))]
fn weighed<T: Scalar>(sums: Rows<T>, vectors: &Rows<T>, [x, y, z]: &Rows<T>) -> Rows<T> {
    core::array::from_fn(|i| {
        let [a, b, c, _] = vectors[i];
        add(add(add(sums[i], a, *x), b, *y), c, *z)
    })
}

/// Of three vectors side by side, entries as rows, that turn: p of each, and their cross products with forces along each, of what is known
/// of an order, which follow from p by second moments.
#[inline(never)]
pub fn curl<T: Scalar>(
    (turned, turning): (&[Rows<T>], &[Rows<T>]),
    (axes, moments): (&Rows<T>, &Rows<T>),
    next: T::Real,
) -> [Rows<T>; 2] {
    let [crossed, turns] = convolve(turned, turning, [none(); 2], |[crossed, turns], vectors, forces| {
        let [u, v, w] = forces;
        [add_cross(crossed, vectors, forces), add_turned(turns, vectors, [u[3], v[3], w[3]])]
    });
    let curls = scaled(&turns, next);
    [curls, add_cross(crossed, axes, &weighed(none(), &curls, moments))]
}

/// Second derivatives of three vectors that turn, entries as rows, for an angular acceleration, and the forces along each: those that their
/// second moments cause, and shares of two others.
#[inline(never)]
pub fn swing<T: Scalar>(
    (axes, moments, curls): (&Rows<T>, &Rows<T>, &Rows<T>),
    angular: Vector3<T>,
    ([some, others], force, other): (&[[T; 4]; 2], Vector3<T>, Vector3<T>),
) -> [Rows<T>; 2] {
    let turned = add_turned(*curls, axes, angular.into());
    let shared = |a: T, b: T| add(add([T::zero(); 4], a, *some), b, *others);
    let forces = [shared(force.x, other.x), shared(force.y, other.y), shared(force.z, other.z)];
    [turned, weighed(forces, &turned, moments)]
}

impl<T: Scalar, const N: usize> AxesSeries<T, N> {
    /// Coefficients up to a number.
    #[inline(always)]
    pub(super) fn known(&self, k: usize) -> (&[Rows<T>], &[Rows<T>]) {
        let count = (k + 1).min(N);
        (&self.turned[..count], &self.turning[..count])
    }

    /// Each entry of the vector that turns times its row.
    #[inline(always)]
    pub(super) fn swept(&self, k: usize) -> Rows<T> {
        let (turned, turning) = self.known(k);
        sweep(turned, turning)
    }

    /// Each entry of the axis times its row, and the cross product of arm and force.
    #[inline(always)]
    pub(super) fn slid(&self, k: usize) -> (Rows<T>, Vector3<T>) {
        let (turned, turning) = self.known(k);
        let (sums, moment) = slide(turned, turning);
        (sums, vector(moment))
    }

    /// Each entry of the vector that turns times the one row.
    #[inline(always)]
    pub(super) fn spread(&self, k: usize) -> Rows<T> {
        let (turned, turning) = self.known(k);
        spread(turned, turning)
    }
}
