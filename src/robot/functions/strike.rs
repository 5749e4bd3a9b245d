//! Impacts of a point of a body against a plane: v⁺ = v⁻ + M⁻¹ Jᵀ n λ with n·J v⁺ = −e n·J v⁻.

use super::impact::restitutes;
use super::{Afloat, FixedBase, S, SixRows, Tasks, finite};
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::mechanics::spatial::Free;
use crate::scalar::Scalar;
use crate::system::System;
use nalgebra::Vector3;

/// How fast columns of a Jacobian move their point along a normal.
fn along<T: Scalar, const N: usize>(columns: &[[T; 6]; N], [x, y, z]: [T; 3]) -> [T; N] {
    columns.map(|[a, b, c, ..]| x.mul_add(a, y.mul_add(b, z * c)))
}

/// Σ aᵢ bᵢ.
fn paired<T: Scalar>(a: &[T], b: &[T]) -> T {
    a.iter().zip(b).fold(T::zero(), |sum, (a, b)| a.mul_add(*b, sum))
}

/// The impulse by which a plane turns over an approach, for what yields to it: one that leaves the plane is not struck.
fn struck<T: Scalar>(approach: T, yielded: T, restitution: T) -> T {
    let impulse = -(T::one() + restitution) * approach / yielded;
    approach.if_negative(impulse, impulse * T::zero()) // no number where nothing yields
}

fn length<T: Scalar>(vector: [T; 3]) -> T {
    paired(&vector, &vector).sqrt()
}

impl<T: Scalar, R: Root<S<T>>, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, R, C, P> {
    /// The rates after a point (m, axes of its body) of the body on joint `joint` has struck a smooth plane that stands with the base, and the
    /// impulse ON the body along the normal (N·s). The normal, in inertial axes and of any length, points away from the plane to where the
    /// body may be: the velocity of the point along it, if negative, is turned over and multiplied by the restitution. A point that leaves
    /// the plane, or slides along it, is not struck: rates stay, and the impulse is zero. Energy falls for restitutions below one.
    ///
    /// A run that [stops at an event](crate::simulate::Simulation::stopping) where the point meets the plane, this, and a run that goes on from
    /// there are exact, as with [`impact`](Self::impact).
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(3.0, [0.2, 0.0, 0.0], [[0.01, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.05]]);
    /// let chain = (Hinge::level(), link, Hinge::at::<1>([0.4, 0.0, 0.0]), link);
    /// let arm = System::new(Base::origin(), chain, Free)?.with_gravity([0.0, -9.81, 0.0]);
    /// // Its tip comes down, against a floor that carries no friction.
    /// let (q, v, tip, up) = ([-0.4, 0.3], [-1.0, 0.5], [0.4, 0.0, 0.0], [0.0, 1.0, 0.0]);
    /// let (after, impulse) = arm.impact_of_point(&q, &v, (1, tip), up, 0.0)?;
    /// let way = arm.jacobian(&q, 1, tip)?;
    /// let rising = |v: &[f64; 2]| way[0][1] * v[0] + way[1][1] * v[1];
    /// assert!(rising(&v) < -0.1 && rising(&after).abs() < 1e-12 && impulse > 0.0);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`impact`](Self::impact); [`Fault::NonFiniteMotion`](crate::Fault::NonFiniteMotion), too, where no joint moves the point along the
    /// normal.
    pub fn impact_of_point<const N: usize>(
        &self,
        q: &[T; N],
        v: &[T; N],
        (joint, point): (usize, [T; 3]),
        normal: [T; 3],
        restitution: T,
    ) -> Result<([T; N], T), Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        restitutes(restitution)?;
        let row = along(&self.jacobian(q, joint, point)?, normal);
        let column = self.mass_solved(q, &row)?;
        let impulse = struck(paired(&row, v), paired(&row, &column), restitution);
        let after: [T; N] = core::array::from_fn(|k| column[k].mul_add(impulse, v[k]));
        let impulse = impulse * length(normal);
        finite(&after).and(finite(&[impulse])).map(|()| (after, impulse))
    }
}

impl<T: Scalar, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, Free, C, P> {
    /// How the base and the joints of a robot whose base floats move after a point (m, axes of its body) of the body on a joint, or of the
    /// base, has struck a smooth plane at rest, and the impulse on the body, as [`impact_of_point`](Self::impact_of_point) has them.
    ///
    /// # Errors
    /// As [`impact_of_point`](Self::impact_of_point); [`Fault::NotZero`](crate::Fault::NotZero) for an attitude of the base that is none.
    pub fn impact_of_point_afloat<const N: usize>(
        &self,
        base: Afloat<T>,
        [q, v]: [&[T; N]; 2],
        (joint, point): (Option<usize>, [T; 3]),
        normal: [T; 3],
        restitution: T,
    ) -> Result<(Afloat<T>, [T; N], T), Error>
    where
        C: Tasks<T, N>,
    {
        restitutes(restitution)?;
        let SixRows { base: of_base, joints } = self.jacobian_afloat(base.place, q, joint, point)?;
        let rows = (along(&of_base, normal), along(&joints, normal));
        let columns = self.mass_solved_afloat(base.place, q, &rows.0, &rows.1)?;
        let ([x, y, z], [a, b, c]): ([T; 3], [T; 3]) = (base.velocity.into(), base.spin.into());
        let approach = paired(&rows.0, &[x, y, z, a, b, c]) + paired(&rows.1, v);
        let yielded = paired(&rows.0, &columns.0) + paired(&rows.1, &columns.1);
        let impulse = struck(approach, yielded, restitution);
        let after: [T; N] = core::array::from_fn(|k| columns.1[k].mul_add(impulse, v[k]));
        let [x, y, z, a, b, c] = columns.0.map(|of_base| of_base * impulse);
        let velocity = base.velocity + Vector3::new(x, y, z);
        let base = Afloat { velocity, spin: base.spin + Vector3::new(a, b, c), ..base };
        let impulse = impulse * length(normal);
        let of_base = finite(base.velocity.as_slice()).and(finite(base.spin.as_slice()));
        of_base.and(finite(&after)).and(finite(&[impulse])).map(|()| (base, after, impulse))
    }
}
