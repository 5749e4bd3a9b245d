//! The overall transfer equation, (16) and (17), as printed: matrices multiplied up, boundary conditions, matrices again.
//!
//! For short chains and not too short steps: entries of the product grow like exp(L (ρA χ₁ / 4EI)^¼) while states stay bounded, so
//! that *smaller* steps lose *more* digits.

use super::hinge::Linear;
use super::link::{End, Law, Link, conjugate};
use super::orient::Orient;
use super::parts::{Part, Parts, Springs};
use crate::error::{Error, Fault, Place};
use crate::scalar::Scalar;
use crate::state::{StateVector, TransferMatrix};
use crate::transfer::solve_dense;
use num_traits::Zero;

/// How a space forms (35) and (40).
pub trait Hinges<T: Scalar, const N: usize, const P: usize, const A: usize> {
    /// (35), rotary part.
    fn elastic(law: &Law<T, A>) -> TransferMatrix<T, N>;
    /// (35), linear part.
    fn sprung(linear: &[Linear<T>; P]) -> TransferMatrix<T, N>;
    /// (36) to (40), from the matrix of the section outboard, the torques in this joint and at the section's end, and the size of
    /// its inertia.
    ///
    /// # Errors
    /// [`Fault::CentreOfPercussion`].
    fn smooth(
        section: &TransferMatrix<T, N>,
        torques: [[T; A]; 2],
        inertia: T::Real,
    ) -> Result<TransferMatrix<T, N>, Error>;
}

/// Refuses what has no matrix, whatever the step: (40) of a joint next to a tip whose attitude is held would have to know the torque there,
/// (35) needs something that pushes along each axis.
///
/// # Errors
/// [`Fault::Unsupported`] with the station of the outermost such joint.
pub fn check<T, M, E, const N: usize, const H: usize, const P: usize, const A: usize>(
    parts: &Parts<T, M, E, N, P, A>,
    tip: &End<T, H>,
) -> Result<(), Error>
where
    T: Scalar,
    M: Copy,
    E: Orient<T, N, P, A>,
{
    let turned = |axis: &[T; H]| axis[P..].iter().any(|x| x.real() != T::Real::zero());
    let clamped = tip.axes.iter().zip(tip.held).any(|(axis, held)| held && turned(axis));
    for (k, part) in parts.order.iter().enumerate().skip(1).rev() {
        let Part::Joint(number) = *part else { continue };
        let Some(joint) = parts.joints.get(number) else { continue };
        let springs = joint.springs.and_then(|springs| parts.springs.get(springs));
        let what = if clamped && joint.turns && joint.is_smooth() {
            "a smooth joint next to a tip that is clamped, by the product: solve by Riccati"
        } else if springs.is_some_and(Springs::leave_free) {
            "an axis along which nothing pushes, by the product: solve by Riccati"
        } else {
            continue;
        };
        return Err(Error::new(Fault::Unsupported { what }).at_station(k - 1));
    }
    Ok(())
}

/// Solves a chain by the product of its matrices, which it leaves in `matrices` (that of the root's joint is left out); writes the
/// states of all stations, the inboard ends of all links and the tip.
///
/// # Errors
/// [`Fault::CentreOfPercussion`] at a pin or ball that has no matrix; [`Fault::SingularTransfer`] where the ends leave something open;
/// [`Fault::NonFiniteMotion`].
pub fn solve<X, T, const N: usize, const H: usize, const P: usize, const A: usize>(
    links: &[Link<T, N, P, A>],
    [root, tip]: [&End<T, H>; 2],
    matrices: &mut [TransferMatrix<T, N>],
    states: &mut [StateVector<T, N>],
) -> Result<(), Error>
where
    T: Scalar,
    X: Hinges<T, N, P, A>,
{
    let identity = TransferMatrix::identity();
    let zero = T::zero();
    // (17), from the tip inward; the section is the product up to the next pin outboard, sections 3.4.1 to 3.4.3.
    let (mut whole, mut section) = (identity, identity);
    let (mut inertia, mut outer_torque) = (T::Real::zero(), [zero; A]);
    let (mut bodies, mut percussive) = (0, false);
    for (k, link) in links.iter().enumerate().skip(1).rev() {
        let matrix = match link {
            Link::Body { matrix, inertia: own, percussive: alone } => {
                inertia += *own;
                bodies += 1;
                percussive = *alone;
                *matrix
            }
            Link::Turning { law, smooth: false } | Link::Parting { law, smooth: false, .. } => X::elastic(law),
            Link::Turning { law, smooth: true } | Link::Parting { law, smooth: true, .. } => {
                let singular = Error::new(Fault::CentreOfPercussion);
                let pin = if bodies == 1 && percussive {
                    Err(singular)
                } else {
                    X::smooth(&section, [law.offset, outer_torque], inertia)
                };
                outer_torque = law.offset;
                pin.map_err(|error| error.at_station(k - 1))?
            }
            Link::Rigid { turn, ahead } => {
                let mut matrix = identity;
                for i in 0..A {
                    matrix[(P + i, N - 1)] = ahead[i];
                    if let Some(turn) = turn {
                        for j in 0..A {
                            matrix[(P + i, P + j)] = turn[i][j];
                        }
                    }
                }
                matrix
            }
        };
        let mut matrix = matrix;
        if let Link::Turning { smooth: true, .. } | Link::Parting { smooth: true, .. } = link {
            (section, inertia, bodies) = (identity, T::Real::zero(), 0);
        } else {
            section = matrix.then(&section);
        }
        if let Link::Parting { linear, .. } = link {
            let sprung = X::sprung(linear);
            (matrix, section) = (sprung.then(&matrix), sprung.then(&section));
        }
        matrices[k] = matrix;
        whole = matrix.then(&whole);
    }

    // Step 5: what the ends leave unknown. Everything known of the root goes into z, zeros stand for the rest.
    let mut z = StateVector::new([zero; N]);
    z[N - 1] = T::one();
    // Along a direction of the root: a state of motion, or of force.
    let along = |k: usize, force: bool| {
        let mut basis = StateVector::<T, N>::new([zero; N]);
        let axes = if force { &root.pulls } else { &root.bases };
        for (i, x) in axes[k].iter().enumerate() {
            basis[if force { H + conjugate::<P, A>(i) } else { i }] = *x;
        }
        basis
    };
    for k in 0..H {
        let (known, basis) = (root.known[k], along(k, !root.held[k]));
        (0..2 * H).for_each(|i| z[i] += known * basis[i]);
    }
    // What is known along a direction of the tip.
    let read = |k: usize, state: &StateVector<T, N>| {
        let axis = if tip.held[k] { &tip.axes[k] } else { &tip.pulls[k] };
        (0..H).fold(zero, |sum, i| sum + axis[i] * state[if tip.held[k] { i } else { H + conjugate::<P, A>(i) }])
    };
    let reached = whole * z;
    let moved: [StateVector<T, N>; H] = core::array::from_fn(|k| whole * along(k, root.held[k]));
    // m at the tip is that of its free end, which an applied torque cannot change: section 3.4.2.
    let a = core::array::from_fn(|row| core::array::from_fn(|k| read(row, &moved[k])));
    let b = core::array::from_fn(|row| tip.known[row] - read(row, &reached));
    let singular = Error::new(Fault::SingularTransfer).at(Place::Root);
    let found: [T; H] = solve_dense(a, b).ok_or(singular)?;
    for (k, found) in found.into_iter().enumerate() {
        let basis = along(k, root.held[k]);
        (0..2 * H).for_each(|i| z[i] += found * basis[i]);
    }
    // Step 6, (15).
    states[0] = z;
    for k in 1..links.len() {
        states[k] = z;
        z = matrices[k] * z;
    }
    states[links.len()] = z;
    if !states.iter().all(|z| (0..N).all(|i| z[i].is_finite())) {
        return Err(Error::new(Fault::NonFiniteMotion));
    }
    Ok(())
}
