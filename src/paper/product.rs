//! The overall transfer equation, (16) and (17), as printed: matrices multiplied up, boundary conditions, matrices again.
//!
//! For short chains and not too short steps: entries of the product grow like exp(L (ρA χ₁ / 4EI)^¼) while states stay bounded, so
//! that *smaller* steps lose *more* digits.

use super::hinge::rotary_hinge;
use super::link::{Base, Link};
use super::pin::smooth_pin;
use crate::error::{Error, Fault};
use crate::planar::index::{M, ONE, QX, QY, THETA, X, Y};
use crate::scalar::Scalar;
use crate::state::{StateVector, TransferMatrix};
use crate::transfer::solve_dense;
use num_traits::Zero;

/// Solves a chain by the product of its matrices, which it leaves in `matrices` (that of the root's joint is left out); writes the
/// states of all stations, the inboard ends of all links and the tip.
///
/// # Errors
/// [`Fault::CentreOfPercussion`] at a pin that has no matrix.
pub fn solve<T: Scalar>(
    links: &[Link<T>],
    base: Base<T>,
    matrices: &mut [TransferMatrix<T, 7>],
    states: &mut [StateVector<T, 7>],
) -> Result<TransferMatrix<T, 7>, Error> {
    let identity = TransferMatrix::identity();
    // (17), from the tip inward; the section is the product up to the next pin outboard, sections 3.4.1 to 3.4.3.
    let (mut whole, mut section) = (identity, identity);
    let (mut inertia, mut outer_torque) = (T::Real::zero(), T::zero());
    let (mut bodies, mut percussive) = (0, false);
    for (k, link) in links.iter().enumerate().skip(1).rev() {
        let matrix = match link {
            Link::Body { matrix, inertia: own, percussive: alone } => {
                inertia += *own;
                bodies += 1;
                percussive = *alone;
                *matrix
            }
            Link::Turning { law, smooth: false } => rotary_hinge(law),
            Link::Turning { law, smooth: true } => {
                let singular = Error::new(Fault::CentreOfPercussion);
                let pin = if bodies == 1 && percussive {
                    Err(singular)
                } else {
                    smooth_pin(&section, [law.offset, outer_torque], inertia)
                };
                outer_torque = law.offset;
                pin.map_err(|error| error.at_station(k - 1))?
            }
            Link::Rigid(angle) => {
                let mut matrix = identity;
                matrix[(THETA, ONE)] = *angle;
                matrix
            }
        };
        matrices[k] = matrix;
        whole = matrix.then(&whole);
        if let Link::Turning { smooth: true, .. } = link {
            (section, inertia, bodies) = (identity, T::Real::zero(), 0);
        } else {
            section = matrix.then(&section);
        }
    }

    // Step 5: what the ends leave unknown, from the tip's m = q = 0. Everything known goes into z, zeros stand for the rest.
    let zero = T::zero();
    let mut z = StateVector::new([zero, zero, zero, zero, zero, zero, T::one()]);
    let unknown = match (base, links.first()) {
        (Base::Free([m, qx, qy]), _) => {
            (z[M], z[QX], z[QY]) = (-m, -qx, -qy);
            [X, Y, THETA]
        }
        (Base::Held([x, y, _]), Some(Link::Turning { law, .. })) => {
            (z[X], z[Y], z[M]) = (x, y, law.offset);
            [THETA, QX, QY]
        }
        (Base::Held([x, y, angle]), first) => {
            let ahead = if let Some(Link::Rigid(ahead)) = first { *ahead } else { zero };
            (z[X], z[Y], z[THETA]) = (x, y, angle + ahead);
            [M, QX, QY]
        }
    };
    let left = whole * z;
    let rows = [M, QX, QY];
    // m at the tip is that of its free end, which an applied torque cannot change: section 3.4.2.
    let a = rows.map(|row| unknown.map(|column| whole[(row, column)]));
    let found = solve_dense(a, rows.map(|row| -left[row])).ok_or(Error::new(Fault::SingularTransfer))?;
    for (index, value) in unknown.into_iter().zip(found) {
        z[index] = value;
    }
    // Step 6, (15).
    if let Base::Held([x, y, angle]) = base {
        states[0] = StateVector::new([x, y, angle, z[M], z[QX], z[QY], T::one()]);
    } else {
        states[0] = z;
    }
    for k in 1..links.len() {
        states[k] = z;
        z = matrices[k] * z;
    }
    states[links.len()] = z;
    Ok(whole)
}
