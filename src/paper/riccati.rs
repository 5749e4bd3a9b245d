//! The Riccati transform of section 5.5: f = S p + e, with p = (x, y, θ) and f = (m, q_x, q_y).
//!
//! Tip to root each link turns the relation at its outboard end into one at its inboard end; root to tip p is recovered, and f from
//! it. Nothing is ever multiplied up, so nothing overflows, and no force is propagated. Worked in increments it keeps three to
//! five digits more than in absolute coordinates.
//!
//! At displacement level S is not symmetric: (32) mixes c̄ with c. All its entries are kept.

use super::link::{Base, Link};
use crate::error::{Error, Fault};
use crate::planar::index::{M, ONE, QX, QY, THETA, X, Y};
use crate::scalar::Scalar;
use crate::state::{StateVector, TransferMatrix};
use crate::transfer::solve_dense;

/// f = S p + e at a station.
#[derive(Clone, Copy, Debug)]
pub struct Relation<T> {
    /// S: rows m, q_x, q_y; columns x, y, θ.
    pub matrix: [[T; 3]; 3],
    /// e.
    pub offset: [T; 3],
}

/// θ_O = b · (x, y, θ_I) + b₃ in a joint.
#[derive(Clone, Copy, Debug)]
pub struct Gain<T>([T; 4]);

impl<T: Scalar> Relation<T> {
    /// A free tip: f = 0.
    pub fn free() -> Self {
        Self { matrix: [[T::zero(); 3]; 3], offset: [T::zero(); 3] }
    }

    /// f for p.
    pub fn force(&self, [x, y, angle]: [T; 3]) -> [T; 3] {
        core::array::from_fn(|i| {
            let [sx, sy, st] = self.matrix[i];
            sx * x + sy * y + st * angle + self.offset[i]
        })
    }

    /// Inward through a body: D f_I = (S A − C) p_I + S a + e − d, with the blocks of its matrix [A B; C D] and B = 0.
    #[must_use]
    pub fn through_body(&self, u: &TransferMatrix<T, 7>) -> Self {
        let mut s = self.matrix;
        let mut e = self.offset;
        for (row, offset) in s.iter_mut().zip(&mut e) {
            *offset += row[0] * u[(X, ONE)] + row[1] * u[(Y, ONE)];
            row[2] += row[0] * u[(X, THETA)] + row[1] * u[(Y, THETA)];
        }
        for (i, q) in [(1, QX), (2, QY)] {
            for (j, column) in [X, Y, THETA].into_iter().enumerate() {
                s[i][j] -= u[(q, column)];
            }
            e[i] -= u[(q, ONE)];
        }
        // D⁻¹: the sign of u45 and u46 changes.
        let (arm_x, arm_y) = (u[(M, QX)], u[(M, QY)]);
        for (j, column) in [X, Y, THETA].into_iter().enumerate() {
            s[0][j] -= u[(M, column)] + arm_x * s[1][j] + arm_y * s[2][j];
        }
        e[0] -= u[(M, ONE)] + arm_x * e[1] + arm_y * e[2];
        Self { matrix: s, offset: e }
    }

    /// Inward through a joint with m = κ (θ_O − θ_I) + μ. A smooth pin is κ = 0; its pivot −S_mθ is the inertia outboard about it,
    /// times χ₁.
    #[must_use]
    pub fn through_joint(&self, slope: T, offset: T) -> (Self, Gain<T>) {
        let [sx, sy, st] = self.matrix[0];
        let pivot = (slope - st).recip();
        let b = [sx * pivot, sy * pivot, slope * pivot, (self.offset[0] - offset) * pivot];
        let mut s = self.matrix;
        let mut e = self.offset;
        for i in [1, 2] {
            let turned = s[i][2];
            s[i] = [s[i][0] + turned * b[0], s[i][1] + turned * b[1], turned * b[2]];
            e[i] += turned * b[3];
        }
        // b₂ − 1 = S_mθ / (κ − S_mθ)
        s[0] = [slope * b[0], slope * b[1], slope * st * pivot];
        e[0] = slope * b[3] + offset;
        (Self { matrix: s, offset: e }, Gain(b))
    }
}

/// Solves a chain: writes the states of all stations, the inboard ends of all links (that of the first is the ground's) and the tip.
/// `relations` and `gains` are room for the transform.
///
/// # Errors
/// [`Fault::SingularJoint`] at a joint in which nothing resists rotation, or at a root that nothing holds and no mass resists.
pub fn solve<T: Scalar>(
    links: &[Link<T>],
    base: Base<T>,
    relations: &mut [Relation<T>],
    gains: &mut [Gain<T>],
    states: &mut [StateVector<T, 7>],
) -> Result<(), Error> {
    let mut relation = Relation::free();
    for (k, link) in links.iter().enumerate().rev() {
        match link {
            Link::Body { matrix, .. } => relation = relation.through_body(matrix),
            Link::Turning { law, .. } => {
                let (inner, gain) = relation.through_joint(law.slope, law.offset);
                if !gain.0.iter().all(|x| x.is_finite()) {
                    let known = relation.matrix.iter().flatten().chain(&relation.offset).all(|x| x.is_finite());
                    let fault = if known { Fault::SingularJoint } else { Fault::NonFiniteMotion };
                    // Links are counted from the root's joint, stations from the first element outboard of it.
                    return Err(Error::new(fault).at_station(k.saturating_sub(1)));
                }
                relation = inner;
                gains[k] = gain;
            }
            Link::Rigid(_) => (),
        }
        relations[k] = relation;
    }
    let mut p = match base {
        Base::Held(p) => p,
        Base::Free(left) => {
            let load = core::array::from_fn(|i| -(relation.offset[i] + left[i]));
            solve_dense(relation.matrix, load).ok_or(Error::new(Fault::SingularJoint))?
        }
    };
    for (k, link) in links.iter().enumerate() {
        states[k] = state(p, relations[k].force(p));
        p = match link {
            Link::Body { matrix: u, .. } => {
                let [x, y, angle] = p;
                [x + u[(X, THETA)] * angle + u[(X, ONE)], y + u[(Y, THETA)] * angle + u[(Y, ONE)], angle]
            }
            Link::Turning { .. } => {
                let Gain([bx, by, bt, free]) = gains[k];
                [p[0], p[1], bx * p[0] + by * p[1] + bt * p[2] + free]
            }
            Link::Rigid(_) => p,
        };
    }
    states[links.len()] = state(p, [T::zero(); 3]);
    Ok(())
}

impl<T: Scalar> Gain<T> {
    /// Room.
    pub fn blank() -> Self {
        Self([T::zero(); 4])
    }
}

fn state<T: Scalar>([x, y, angle]: [T; 3], [m, qx, qy]: [T; 3]) -> StateVector<T, 7> {
    StateVector::new([x, y, angle, m, qx, qy, T::one()])
}
