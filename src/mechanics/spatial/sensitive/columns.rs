//! Columns of vectors.

use crate::relation::spatial::algebra::Columns;
use crate::scalar::{Jet, Scalar, columns};
use nalgebra::Vector3;

/// Columns of a vector.
pub(in crate::mechanics::spatial) type Vectors<T, const K: usize> = [[T; K]; 3];

/// No columns.
pub(in crate::mechanics::spatial) fn none<T: Scalar, const K: usize>() -> Vectors<T, K> {
    [[T::zero(); K]; 3]
}

/// Derivatives of a vector.
#[inline(always)]
pub(in crate::mechanics::spatial) fn parts<T: Scalar, const K: usize>(v: &Vector3<Jet<T, K>>) -> Vectors<T, K> {
    [v.x.eps, v.y.eps, v.z.eps]
}

/// Value of a vector.
#[inline(always)]
pub(in crate::mechanics::spatial) fn value<T: Scalar, const K: usize>(v: &Vector3<Jet<T, K>>) -> Vector3<T> {
    Vector3::new(v.x.re, v.y.re, v.z.re)
}

/// v~, so that v~ u = v × u.
#[inline(always)]
pub(in crate::mechanics::spatial) fn crossed<T: Scalar>(v: Vector3<T>) -> Columns<T> {
    let o = T::zero();
    Columns { x: Vector3::new(o, v.z, -v.y), y: Vector3::new(-v.z, o, v.x), z: Vector3::new(v.y, -v.x, o) }
}

/// Mᵀ.
#[inline(always)]
pub(in crate::mechanics::spatial) fn transposed<T: Scalar>(Columns { x, y, z }: &Columns<T>) -> Columns<T> {
    Columns { x: Vector3::new(x.x, y.x, z.x), y: Vector3::new(x.y, y.y, z.y), z: Vector3::new(x.z, y.z, z.z) }
}

#[inline(always)]
pub(in crate::mechanics::spatial) fn minus<T: Scalar>(m: Columns<T>) -> Columns<T> {
    Columns { x: -m.x, y: -m.y, z: -m.z }
}

#[inline(always)]
pub(in crate::mechanics::spatial) fn times<T: Scalar>(m: Columns<T>, factor: T) -> Columns<T> {
    Columns { x: m.x * factor, y: m.y * factor, z: m.z * factor }
}

/// `sum += v`.
#[cfg_attr(optimised, inline(always))]
pub(in crate::mechanics::spatial) fn add<T: Scalar, const K: usize>(sum: &mut Vectors<T, K>, v: &Vectors<T, K>) {
    let [x, y, z] = sum;
    columns!(K; a = v[0], b = v[1], c = v[2]; k:
        mut x = *x => x[k] + a[k],
        mut y = *y => y[k] + b[k],
        mut z = *z => z[k] + c[k]
    );
}

/// `sum += n f` for columns of a number f.
#[cfg_attr(optimised, inline(always))]
pub(in crate::mechanics::spatial) fn add_along<T: Scalar, const K: usize>(
    sum: &mut Vectors<T, K>,
    n: Vector3<T>,
    f: &[T; K],
) {
    let [x, y, z] = sum;
    columns!(K; f = *f; k:
        mut x = *x => f[k].mul_add(n.x, x[k]),
        mut y = *y => f[k].mul_add(n.y, y[k]),
        mut z = *z => f[k].mul_add(n.z, z[k])
    );
}

/// `sum += M v`.
#[cfg_attr(optimised, inline(always))]
pub(in crate::mechanics::spatial) fn apply<T: Scalar, const K: usize>(
    sum: &mut Vectors<T, K>,
    m: &Columns<T>,
    v: &Vectors<T, K>,
) {
    let [x, y, z] = sum;
    let Columns { x: p, y: q, z: r } = *m;
    columns!(K; a = v[0], b = v[1], c = v[2]; k:
        mut x = *x => a[k].mul_add(p.x, b[k].mul_add(q.x, c[k].mul_add(r.x, x[k]))),
        mut y = *y => a[k].mul_add(p.y, b[k].mul_add(q.y, c[k].mul_add(r.y, y[k]))),
        mut z = *z => a[k].mul_add(p.z, b[k].mul_add(q.z, c[k].mul_add(r.z, z[k])))
    );
}

/// `sum += n · v`.
#[cfg_attr(optimised, inline(always))]
pub(in crate::mechanics::spatial) fn project<T: Scalar, const K: usize>(
    sum: &mut [T; K],
    n: Vector3<T>,
    v: &Vectors<T, K>,
) {
    columns!(K; a = v[0], b = v[1], c = v[2]; k:
        mut sum = *sum => a[k].mul_add(n.x, b[k].mul_add(n.y, c[k].mul_add(n.z, sum[k])))
    );
}

/// `sum += factor · v`.
#[cfg_attr(optimised, inline(always))]
pub(in crate::mechanics::spatial) fn add_scaled_vectors<T: Scalar, const K: usize>(
    sum: &mut Vectors<T, K>,
    factor: T,
    v: &Vectors<T, K>,
) {
    let [x, y, z] = sum;
    columns!(K; a = v[0], b = v[1], c = v[2]; k:
        mut x = *x => a[k].mul_add(factor, x[k]),
        mut y = *y => b[k].mul_add(factor, y[k]),
        mut z = *z => c[k].mul_add(factor, z[k])
    );
}
