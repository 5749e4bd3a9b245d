//! What an element of a chain is in one step, the links that a solver joins, and what is known at the ends.
//!
//! A state has N = 2H + 1 entries: p, which is P places and A angles, then A torques and P forces, and one. The plane has
//! N, H, P, A = 7, 3, 2, 1, space 13, 6, 3, 3.

use super::hinge::{Linear, Rotary};
use crate::scalar::Scalar;
use crate::state::TransferMatrix;

/// (34) in one step, m = K_O θ_O − K_I θ_I + μ.
#[derive(Clone, Copy, Debug)]
pub struct Law<T, const A: usize> {
    /// K_O (N·m/rad).
    pub outer: [[T; A]; A],
    /// K_I (N·m/rad).
    pub inner: [[T; A]; A],
    /// μ (N·m).
    pub offset: [T; A],
}

impl<T: Scalar> From<Rotary<T>> for Law<T, 1> {
    fn from(Rotary { slope, offset }: Rotary<T>) -> Self {
        Self { outer: [[slope]], inner: [[slope]], offset: [offset] }
    }
}

impl<T: Scalar, const A: usize> Law<T, A> {
    /// A joint that turns freely but for a torque.
    pub fn smooth(offset: [T; A]) -> Self {
        let none = [[T::zero(); A]; A];
        Self { outer: none, inner: none, offset }
    }
}

/// An element in one step.
#[derive(Clone, Copy, Debug)]
pub enum Link<T: Scalar, const N: usize, const P: usize, const A: usize> {
    /// A body.
    Body {
        /// (32), (31).
        matrix: TransferMatrix<T, N>,
        /// The size of the terms of u₄₃, of Ū₃₂: (J_I + m |d_C| |d_O|) χ₁.
        inertia: T::Real,
        /// Whether a smooth joint at the body's inboard end has no matrix (40).
        percussive: bool,
    },
    /// A joint that turns: an elastic hinge, or a pin or ball where it is smooth.
    Turning {
        /// Torque of the joint.
        law: Law<T, A>,
        /// Whether K_O and K_I are zero by construction.
        smooth: bool,
    },
    /// A joint that turns and whose points part: an elastic hinge with linear springs.
    Parting {
        /// Torque of the joint.
        law: Law<T, A>,
        /// Whether K_O and K_I are zero by construction.
        smooth: bool,
        /// Force of the joint, axis by axis of the ground.
        linear: [Linear<T>; P],
    },
    /// A joint that does not turn, θ_O = R θ_I + `ahead`.
    Rigid {
        /// R; none where it is one.
        turn: Option<[[T; A]; A]>,
        /// By how much (rad) the outboard side is ahead; not at all in increments.
        ahead: [T; A],
    },
}

impl<T: Scalar, const N: usize, const P: usize, const A: usize> Link<T, N, P, A> {
    /// A joint that changes nothing, as that of the root, which the boundary conditions speak for.
    pub fn nothing() -> Self {
        Self::Rigid { turn: None, ahead: [T::zero(); A] }
    }
}

/// What is known at an end: along each of H directions either the motion or the force.
#[derive(Clone, Copy, Debug)]
pub struct End<T, const H: usize> {
    /// The directions of p in which motion is read.
    pub axes: [[T; H]; H],
    /// The directions in which motion is written, the dual basis: p = Σ (axes · p) bases.
    pub bases: [[T; H]; H],
    /// The directions of force and torque, orthonormal, in the order of p. Coordinates of attitudes are not turns about fixed axes; else all
    /// three are the same.
    pub pulls: [[T; H]; H],
    /// Directions along which the motion is known.
    pub held: [bool; H],
    /// What is known at the end: along each direction a component of p, or of the force and torque (q, m).
    pub known: [T; H],
}

impl<T: Scalar, const H: usize> End<T, H> {
    /// An end along the axes of the ground.
    pub fn along_axes(held: [bool; H], known: [T; H]) -> Self {
        let axes = core::array::from_fn(|i| core::array::from_fn(|j| if i == j { T::one() } else { T::zero() }));
        Self { axes, bases: axes, pulls: axes, held, known }
    }

    /// An end that nothing holds and nothing pulls.
    pub fn free() -> Self {
        Self::along_axes([false; H], [T::zero(); H])
    }

    /// Whether anything holds the end.
    pub fn is_held(&self) -> bool {
        self.held.iter().any(|held| *held)
    }

    /// Directions that are not orthonormal axes yet made such: those given are held.
    pub fn holding(directions: &[[T; H]], known: &[T]) -> Self {
        let mut end = Self::free();
        let mut count = 0;
        for (direction, known) in directions.iter().zip(known).take(H) {
            (end.axes[count], end.held[count], end.known[count]) = (*direction, true, *known);
            count += 1;
        }
        // The rest: of the unit vectors, those that lie farthest from what is there (Gram and Schmidt).
        while count < H {
            let left = (0..H).map(|k| {
                let unit: [T; H] = core::array::from_fn(|i| if i == k { T::one() } else { T::zero() });
                end.axes[..count].iter().fold(unit, |rest, axis| {
                    let along = dot(&unit, axis);
                    core::array::from_fn(|i| rest[i] - along * axis[i])
                })
            });
            let longest = left.reduce(|a, b| if dot(&b, &b).real() > dot(&a, &a).real() { b } else { a });
            let rest = longest.unwrap_or([T::zero(); H]);
            let length = dot(&rest, &rest).sqrt().recip();
            (end.axes[count], end.held[count], end.known[count]) = (rest.map(|x| x * length), false, T::zero());
            count += 1;
        }
        (end.bases, end.pulls) = (end.axes, end.axes);
        end
    }
}

/// a · b.
pub fn dot<T: Scalar, const H: usize>(a: &[T; H], b: &[T; H]) -> T {
    (0..H).fold(T::zero(), |sum, i| sum + a[i] * b[i])
}

/// The place in f = (m, q) of what is conjugate to entry `k` of p.
pub fn conjugate<const P: usize, const A: usize>(k: usize) -> usize {
    if k < P { A + k } else { k - P }
}

/// The inverse of a number or of three by three, by cofactors: not finite where it is singular.
pub fn inverse<T: Scalar, const A: usize>(a: &[[T; A]; A]) -> [[T; A]; A] {
    if A == 1 {
        return a.map(|row| row.map(T::recip));
    }
    let minor = |i: usize, j: usize| {
        let (i1, i2, j1, j2) = ((i + 1) % A, (i + 2) % A, (j + 1) % A, (j + 2) % A);
        a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1]
    };
    let determinant = (0..A).fold(T::zero(), |sum, j| sum + a[0][j] * minor(0, j));
    let reciprocal = determinant.recip();
    core::array::from_fn(|i| core::array::from_fn(|j| minor(j, i) * reciprocal))
}

/// The last column of a body's matrix comes from these: what is known at t_i of each coordinate and point.
///
/// In absolute coordinates they are χ₂, χ₄ and what (21) and (25) add to r_I where the angles are zero; in increments what unchanged
/// coordinates would bring.
#[derive(Clone, Copy, Debug)]
pub struct Given<T, const P: usize, const A: usize> {
    /// Of r_I.
    pub inboard: [T; P],
    /// Of r_C.
    pub centre: [T; P],
    /// Of the angles, second derivatives.
    pub angles: [T; A],
    /// Of the angles, rates.
    pub rates: [T; A],
    /// Of the arms to mass centre and outboard end.
    pub arms: [[T; P]; 2],
}
