//! The mass matrix, by composite inertias.

use super::number::{
    Number, Rows, Triangle, Triple, congruent, dot_onto, more, product, scaled, sum, triangle, triangle_less,
    triangle_sum, triangle_values, triple, values,
};
use super::standing::{Stand, Standing};
use super::through::{Solid, Through, through};
use crate::scalar::Scalar;

/// The mass matrix as far as it is known, and what its columns are at the present body.
pub struct Composite<'m, T, const N: usize> {
    pub positions: [T; N],
    /// Sines and cosines of all positions, which slides do not read.
    pub sines: [Stand<T>; N],
    pub columns: [[[T; 3]; 2]; N],
    pub matrix: &'m mut [[T; N]; N],
    pub next: usize,
}

/// What lies outboard as one body: mass, first moment and tensor about the present origin, and the number after its last joint.
#[derive(Clone, Copy)]
pub struct Whole<T> {
    pub mass: T,
    pub moment: [T; 3],
    pub tensor: [T; 6],
    pub end: usize,
}

impl<T: Scalar> Whole<T> {
    /// Nothing, beyond the joints up to a number.
    #[inline(always)]
    pub fn nothing(end: usize) -> Self {
        Self { mass: T::zero(), moment: [T::zero(); 3], tensor: [T::zero(); 6], end }
    }

    #[cfg_attr(optimised, inline(always))]
    fn with(self, mass: T, moment: Triple<T>, tensor: &Triangle<T>) -> Self {
        Self {
            mass: self.mass + mass,
            moment: values(sum(triple(self.moment), moment)),
            tensor: triangle_values(triangle_sum(&triangle(63, self.tensor), tensor)),
            end: self.end,
        }
    }
}

through!([const N: usize] Composite<'_, T, N>, Whole<T>, inward, |walk, chain, go| {
    let beyond = Whole::nothing(walk.next);
    let arm = go(walk, beyond);
    chain.with(arm.mass, triple(arm.moment), &triangle(63, arm.tensor))
});

/// First moment and tensor about the point at −d.
#[cfg_attr(optimised, inline(always))]
fn shifted<T: Scalar>(
    mass: Number<T>,
    moment: Triple<T>,
    tensor: Triangle<T>,
    d: Triple<T>,
) -> (Triple<T>, Triangle<T>) {
    // J + 2 d·σ 1 − d σᵀ − σ dᵀ + m (d² 1 − d dᵀ) with s = 2 σ + m d: J + d·s 1 − ½ d sᵀ − ½ s dᵀ.
    let s = more(sum(moment, moment), mass, d);
    let half = scaled(d, Number::of(T::literal(0.5)));
    let trace = dot_onto(d, s, Number::zero());
    let [xx, yy, zz, yz, xz, xy] = tensor;
    let tensor = [xx.plus(trace), yy.plus(trace), zz.plus(trace), yz, xz, xy];
    let tensor = triangle_less(&triangle_less(&tensor, half, s), s, half);
    (more(moment, mass, d), tensor)
}

/// The turn of a hinge.
#[inline(always)]
fn about_z<T: Scalar>([sine, cosine]: Stand<T>) -> Rows<T> {
    let (s, c, o, i) = (Number::of(sine), Number::of(cosine), Number::zero(), Number::one());
    [[c, s.negated(), o], [s, c, o], [o, o, i]]
}

impl<T: Scalar, const N: usize> Through<T> for Composite<'_, T, N> {
    #[cfg_attr(optimised, inline(always))]
    fn axis<A: Standing<T>>(&mut self, axis: &A, whole: Whole<T>) -> Whole<T> {
        self.next -= 1;
        let own = self.next;
        let stand = if const { A::TURNS } { self.sines[own] } else { [T::zero(), self.positions[own]] };
        let (mass, [x, y, z], tensor) = (whole.mass, whole.moment, whole.tensor);
        let o = T::zero();
        self.columns[own] = if const { A::TURNS } {
            [[-y, x, o], [tensor[4], tensor[3], tensor[2]]]
        } else {
            [[o, o, mass], [y, -x, o]]
        };
        for k in own..whole.end.min(N) {
            let [force, torque] = self.columns[k];
            let column = [triple(force), triple(torque)];
            let entry = axis.along(column);
            (self.matrix[own][k], self.matrix[k][own]) = (entry, entry);
            let [force, torque] = axis.carried(stand, column);
            self.columns[k] = [values(force), values(torque)];
        }
        self.matrix[own][own] += axis.inertia().value();
        let (mut moment, mut tensor) = (triple([x, y, z]), triangle(63, tensor));
        let turn = if const { A::TURNS } {
            product(&axis.offset(), &about_z(stand))
        } else {
            let out = [Number::zero(), Number::zero(), Number::of(stand[1])];
            (moment, tensor) = shifted(Number::of(mass), moment, tensor, out);
            axis.offset()
        };
        let (moment, tensor) = (super::number::apply(&turn, moment), congruent(&turn, &tensor));
        let (moment, tensor) = shifted(Number::of(mass), moment, tensor, axis.arm());
        Whole { mass, moment: values(moment), tensor: triangle_values(tensor), end: whole.end }
    }
    #[inline(always)]
    fn link<B: Solid<T>>(&mut self, link: &B, whole: Whole<T>) -> Whole<T> {
        whole.with(link.mass(), link.moment(), &link.tensor())
    }
}
