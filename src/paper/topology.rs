//! Overall equations of systems that are no chains, (47) to (60): closed loops, branches and networks in the plane.
//!
//! Subsystems are chains with overall matrices (17) each; where they meet, places are common, forces balance, and a smooth pin has no
//! torque. These are small dense systems of equations, good for short chains as (17) is, and independent of the sweeps of the rest of this
//! crate: unknown are whole states, known is what the ends say.
//!
//! Corrections, each where it stands: the first factor of (49) is U_l; with smooth pins alone a row of U − I in (48) vanishes; U_II⁻¹ of
//! (55) does not exist where branch II has a smooth pin inside; (60) has a sign wrong in its first row and lacks an equation.

use crate::error::{Error, Fault};
use crate::mechanics::planar::index::{M, ONE, QX, QY, THETA, X, Y};
use crate::scalar::Scalar;
use crate::state::{StateVector, TransferMatrix};
use crate::transfer::solve_dense;

/// What an end makes known: three entries of its state, by their place in it.
pub type Boundary<T> = [(usize, T); 3];

/// An end that is free: no torque, no force.
pub fn free<T: Scalar>() -> Boundary<T> {
    [M, QX, QY].map(|entry| (entry, T::zero()))
}

/// An end that a smooth pin holds at a place (m).
pub fn pinned<T: Scalar>(x: T, y: T) -> Boundary<T> {
    [(X, x), (Y, y), (M, T::zero())]
}

/// An end held at a place (m) and an angle (rad).
pub fn clamped<T: Scalar>(x: T, y: T, angle: T) -> Boundary<T> {
    [(X, x), (Y, y), (THETA, angle)]
}

/// U_b1 of (53): forces.
const FORCES: [usize; 2] = [QX, QY];
/// U_b2 of (53): places.
const PLACES: [usize; 2] = [X, Y];

/// Linear equations for the entries of states, each state with its one.
struct Equations<T, const K: usize> {
    left: [[T; K]; K],
    right: [T; K],
    count: usize,
}

impl<T: Scalar, const K: usize> Equations<T, K> {
    fn new() -> Self {
        Self { left: [[T::zero(); K]; K], right: [T::zero(); K], count: 0 }
    }

    /// Σ ± (U_k z_k)(entry) = value, over states by their number.
    fn push(&mut self, entry: usize, terms: &[(usize, &TransferMatrix<T, 7>, bool)], value: T) {
        let row = self.count;
        self.right[row] = value;
        for (state, matrix, minus) in terms {
            let sign = |x: T| if *minus { -x } else { x };
            for column in 0..ONE {
                self.left[row][6 * state + column] += sign(matrix[(entry, column)]);
            }
            self.right[row] -= sign(matrix[(entry, ONE)]);
        }
        self.count += 1;
    }

    /// The states.
    fn solve<const S: usize>(self) -> Result<[StateVector<T, 7>; S], Error> {
        let found = solve_dense(self.left, self.right).ok_or(Error::new(Fault::SingularTransfer))?;
        let state = |k: usize| core::array::from_fn(|i| if i == ONE { T::one() } else { found[6 * k + i] });
        Ok(core::array::from_fn(|k| StateVector::new(state(k))))
    }
}

/// (47) to (49): the state at the cut of a closed loop, z = U z, for U = U_l U_{l−1} .. U_1 (its first factor is printed U_1), from
/// the cut round to it.
///
/// Where `smooth`, all joints are smooth pins with matrices (40). Then a row of U − I vanishes, for U passes m as it is; m = 0 stands in
/// its place. Angles are absolute, so that they close by themselves; rest angles of elastic hinges add up to a turn, or not at all, as the
/// angles of the bodies do.
///
/// # Errors
/// [`Fault::SingularTransfer`] where the equations are singular.
pub fn closed_loop<T: Scalar>(around: &TransferMatrix<T, 7>, smooth: bool) -> Result<StateVector<T, 7>, Error> {
    let one = TransferMatrix::identity();
    let mut equations = Equations::<T, 6>::new();
    for entry in 0..ONE {
        if entry == M && smooth {
            equations.push(M, &[(0, &one, false)], T::zero());
        } else {
            equations.push(entry, &[(0, around, false), (0, &one, true)], T::zero());
        }
    }
    equations.solve::<1>().map(|[z]| z)
}

/// (50) to (55): three chains that meet in a smooth pin. I runs to the pin, from a root; II sets out from it, to an end; III runs to it,
/// from an end. Gives z_{2,1} at the root, z_{j+1,j} where II sets out, and z_{n+3,n+2} at the end of III.
///
/// (54) takes the state at the end of II for unknown, which needs U_II⁻¹: that does not exist where a smooth pin is inside II. The state
/// where II sets out does as well.
///
/// # Errors
/// [`Fault::SingularTransfer`] where the equations are singular.
pub fn branched<T: Scalar>(
    [first, second, third]: [&TransferMatrix<T, 7>; 3],
    [root, end, tip]: [&Boundary<T>; 3],
) -> Result<[StateVector<T, 7>; 3], Error> {
    let one = &TransferMatrix::identity();
    let none = T::zero();
    let mut equations = Equations::<T, 18>::new();
    for q in FORCES {
        equations.push(q, &[(0, first, false), (1, one, true), (2, third, false)], none);
    }
    for r in PLACES {
        equations.push(r, &[(0, first, false), (1, one, true)], none);
        equations.push(r, &[(0, first, false), (2, third, true)], none);
    }
    equations.push(M, &[(0, first, false)], none);
    equations.push(M, &[(1, one, false)], none);
    equations.push(M, &[(2, third, false)], none);
    for (state, matrix, boundary) in [(0, one, root), (1, second, end), (2, one, tip)] {
        for (entry, value) in boundary {
            equations.push(*entry, &[(state, matrix, false)], *value);
        }
    }
    equations.solve()
}

/// (56) to (60): a chain I that runs from a root to a smooth pin, and a loop II that sets out from it and comes back. Gives z_{2,1} at the
/// root and z_{j+1,j} where the loop sets out.
///
/// (58) has U_b1 U_I z_{2,1} = U_b1 z_{j+1,j} − U_b1 U_II z_{j+1,j}, so the first row of (60) must be [U_b1 U_I, U_b1 (U_II − I)]; it is
/// printed with (I − U_II). Eight equations are printed where nine are needed: m = 0 where the loop sets out is missing.
///
/// # Errors
/// [`Fault::SingularTransfer`] where the equations are singular.
pub fn network<T: Scalar>(
    [first, second]: [&TransferMatrix<T, 7>; 2],
    root: &Boundary<T>,
) -> Result<[StateVector<T, 7>; 2], Error> {
    let one = &TransferMatrix::identity();
    let none = T::zero();
    let mut equations = Equations::<T, 12>::new();
    for q in FORCES {
        equations.push(q, &[(0, first, false), (1, second, false), (1, one, true)], none);
    }
    for r in PLACES {
        equations.push(r, &[(0, first, false), (1, one, true)], none);
        equations.push(r, &[(1, one, false), (1, second, true)], none);
    }
    equations.push(M, &[(0, first, false)], none);
    equations.push(M, &[(1, second, false)], none);
    equations.push(M, &[(1, one, false)], none);
    for (entry, value) in root {
        equations.push(*entry, &[(0, one, false)], *value);
    }
    equations.solve()
}
