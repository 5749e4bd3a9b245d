//! What a space must say for its elements to have exact transfer matrices: the inspection view of a sweep.

use crate::element::{Load, Space};
use crate::loading::{EffortOf, Seen};
use crate::relation::{Absent, Geometry};
use crate::release::Release;
use crate::scalar::{Real, Scalar};
use crate::space::FrameOf;
use crate::state::{StateVector, TransferMatrix};
use num_traits::Zero;

/// A space whose elements have exact transfer matrices for states with `N` entries: as many accelerations as forces, and a one.
pub trait Exact<const N: usize>: Space {
    /// The matrix of a body under a load, (32) at acceleration level.
    fn body_matrix(
        body: &Self::BodyMotion,
        gravity: Self::Vector,
        load: impl Load<Self>,
    ) -> TransferMatrix<Self::Scalar, N>;

    /// What a joint under efforts (on its coordinates, in their order) does to a state.
    fn passage(
        joint: &Self::JointMotion,
        release: &Release<Self>,
        efforts: [Self::Scalar; 3],
    ) -> Passage<Self::Scalar, N>;

    /// The acceleration state of a station without force and torque.
    fn acceleration_state(frame: &FrameOf<Self>) -> StateVector<Self::Scalar, N>;
}

/// What acts in a joint, as numbers.
pub trait Efforts<S: Space>: Copy {
    /// Generalised forces ON the outboard body, one for each coordinate.
    fn efforts(self) -> [S::Scalar; 3];
}

/// A space in which what acts in a joint is made of numbers: the inverse of [`Efforts`].
pub trait FromEfforts: Space<JointMotion: Seen<Load: Efforts<Self>>> {
    /// What generalised forces ON the outboard body, one for each coordinate, are together.
    fn of_efforts(efforts: [Self::Scalar; 3]) -> EffortOf<Self>;
}

impl<S: Space> Efforts<S> for Absent {
    fn efforts(self) -> [S::Scalar; 3] {
        [S::Scalar::zero(); 3]
    }
}

/// The overall matrix of a chain, and what the joint at its root does.
pub type Whole<S, const N: usize> = (TransferMatrix<<S as Geometry>::Scalar, N>, Passage<<S as Geometry>::Scalar, N>);

/// Most coordinates that a joint can have.
const MOST: usize = 6;

/// A joint as it acts on the state at its inboard side: that at its outboard side is `fixed` z and what the accelerations of its
/// coordinates add.
#[derive(Clone, Copy, Debug)]
pub struct Passage<T, const N: usize> {
    /// The matrix of the joint where its coordinates do not accelerate.
    pub fixed: TransferMatrix<T, N>,
    freedoms: [Option<Freedom<T, N>>; MOST],
}

/// A coordinate of a joint.
#[derive(Clone, Copy, Debug)]
struct Freedom<T, const N: usize> {
    /// What a unit of the coordinate's acceleration adds to the state outboard.
    push: [T; N],
    /// The row that reads the generalised force on the coordinate in the state outboard,
    row: [T; N],
    /// what that force is where the coordinate does not accelerate,
    effort: T,
    /// and what a unit of its acceleration takes away from it: reflected inertia.
    inertia: T,
}

impl<T: Scalar, const N: usize> Passage<T, N> {
    /// A joint that lets nothing move.
    pub fn of(fixed: TransferMatrix<T, N>) -> Self {
        Self { fixed, freedoms: [None; MOST] }
    }

    /// This joint with another coordinate: what a unit of its acceleration adds to the state outboard, the row that reads the
    /// generalised force on it there, that force, and what a unit of the acceleration takes away from it.
    #[must_use]
    pub fn with(mut self, push: [T; N], row: [T; N], [effort, inertia]: [T; 2]) -> Self {
        if let Some(free) = self.freedoms.iter_mut().find(|freedom| freedom.is_none()) {
            *free = Some(Freedom { push, row, effort, inertia });
        }
        self
    }

    /// Number of coordinates.
    pub fn coordinates(&self) -> usize {
        self.freedoms.iter().flatten().count()
    }

    /// The condition of a coordinate on the state at the joint's inboard side, `row` z = 0: that a generalised force is what it is.
    fn condition(&self, freedom: &Freedom<T, N>) -> [T; N] {
        let mut row = through(&freedom.row, &self.fixed);
        row[N - 1] -= freedom.effort;
        row
    }

    /// The matrix of the joint, (40), from that of everything outboard, whose bodies have inertias (kg, kg·m, kg·m²) of this size.
    ///
    /// Which accelerations its coordinates have is decided by what lies outboard, and in the end by the tip, where nothing pulls. Of
    /// the forces at the tip those that correspond to the coordinates are made to equal what this joint's own are off by: so they
    /// vanish at the tip if its own are right, and conditions of all joints arrive at the tip. `None` where these forces do not depend
    /// on the coordinates but for rounding, at a centre of percussion.
    pub fn matrix(&self, outboard: &TransferMatrix<T, N>, inertia: T::Real) -> Option<TransferMatrix<T, N>> {
        let mut pivots = identity();
        let mut demands = [[T::zero(); N]; MOST];
        for (k, freedom) in self.freedoms.iter().flatten().enumerate() {
            let at_tip = through(&freedom.row, outboard);
            let own = self.condition(freedom);
            let moved = through(&at_tip, &self.fixed);
            demands[k] = core::array::from_fn(|j| own[j] - moved[j]);
            pivots[k] = core::array::from_fn(|j| match &self.freedoms[j] {
                // What is off by reflected inertia is so at the tip, too.
                Some(other) if j == k => product(&at_tip, &other.push) - other.inertia,
                Some(other) => product(&at_tip, &other.push),
                None => T::zero(),
            });
        }
        let mut matrix = self.fixed;
        let least = inertia * T::Real::EPSILON * T::Real::of(64.0);
        for column in 0..N {
            let found = solve_unless(pivots, demands.map(|row| row[column]), least)?;
            for (freedom, second) in self.freedoms.iter().flatten().zip(found) {
                for (row, push) in freedom.push.iter().enumerate() {
                    matrix[(row, column)] += *push * second;
                }
            }
        }
        Some(matrix)
    }
}

/// The state at the inboard end of a chain with a free tip, from its overall matrix, the joint at its root and the acceleration
/// state of the ground there. `None` at a centre of percussion.
pub(crate) fn close<T: Scalar, const N: usize>(
    whole: &TransferMatrix<T, N>,
    root: &Passage<T, N>,
    ground: StateVector<T, N>,
) -> Option<StateVector<T, N>> {
    let half = N / 2;
    let basis = |i: usize| core::array::from_fn(|j| if i == j { T::one() } else { T::zero() });
    // Forces of the ground and accelerations of the joint's coordinates, as they enter the state outboard of the joint.
    let mut columns = [[T::zero(); N]; 2 * MOST];
    for (k, column) in columns.iter_mut().enumerate().take(half) {
        *column = core::array::from_fn(|i| root.fixed[(i, half + k)]);
    }
    let known = root.fixed * ground;
    let known: [T; N] = core::array::from_fn(|i| known[i]);
    let (mut a, mut b) = (identity(), [T::zero(); 2 * MOST]);
    let mut rows = [[T::zero(); N]; 2 * MOST];
    // Nothing pulls at the tip; the joint's own forces are what they are.
    for (k, row) in rows.iter_mut().enumerate().take(half) {
        *row = through(&basis(half + k), whole);
    }
    for (k, freedom) in root.freedoms.iter().flatten().enumerate() {
        columns[half + k] = freedom.push;
        rows[half + k] = freedom.row;
        b[half + k] = freedom.effort;
    }
    let unknowns = half + root.coordinates();
    for k in 0..unknowns {
        b[k] -= product(&rows[k], &known);
        a[k] = core::array::from_fn(|j| if j < unknowns { product(&rows[k], &columns[j]) } else { T::zero() });
    }
    for (k, freedom) in root.freedoms.iter().flatten().enumerate() {
        a[half + k][half + k] += freedom.inertia;
    }
    let found = solve_dense(a, b)?;
    let mut state = known;
    for (column, x) in columns.iter().zip(found) {
        state.iter_mut().zip(column).for_each(|(sum, entry)| *sum += *entry * x);
    }
    Some(StateVector::new(state))
}

fn identity<T: Scalar, const K: usize>() -> [[T; K]; K] {
    core::array::from_fn(|i| core::array::from_fn(|j| if i == j { T::one() } else { T::zero() }))
}

fn product<T: Scalar, const N: usize>(row: &[T; N], column: &[T; N]) -> T {
    row.iter().zip(column).fold(T::zero(), |sum, (a, b)| sum + *a * *b)
}

/// A row times a matrix.
fn through<T: Scalar, const N: usize>(row: &[T; N], matrix: &TransferMatrix<T, N>) -> [T; N] {
    core::array::from_fn(|j| row.iter().enumerate().fold(T::zero(), |sum, (i, x)| sum + *x * matrix[(i, j)]))
}

/// Solves A x = b for a small dense system by elimination with row pivoting; `None` where it is singular.
///
/// For inspection only: pivoting compares values, which a sweep never does.
pub(crate) fn solve_dense<T: Scalar, const K: usize>(a: [[T; K]; K], b: [T; K]) -> Option<[T; K]> {
    solve_unless(a, b, T::Real::zero())
}

/// Solves A x = b by elimination with row pivoting; `None` where a pivot is not above `least`.
fn solve_unless<T: Scalar, const K: usize>(mut a: [[T; K]; K], mut b: [T; K], least: T::Real) -> Option<[T; K]> {
    for i in 0..K {
        let magnitude = |row: &usize| a[*row][i].real().abs();
        let pivot = (i..K).max_by(|p, q| magnitude(p).as_f64().total_cmp(&magnitude(q).as_f64()))?;
        a.swap(i, pivot);
        b.swap(i, pivot);
        let size = a[i][i].real().abs();
        if size <= least || !size.is_finite() {
            return None;
        }
        let inverse = a[i][i].recip();
        for row in i + 1..K {
            let factor = a[row][i] * inverse;
            let above = a[i];
            for (entry, above) in a[row].iter_mut().zip(above) {
                *entry -= factor * above;
            }
            let above = b[i];
            b[row] -= factor * above;
        }
    }
    for i in (0..K).rev() {
        let sum = (i + 1..K).fold(b[i], |sum, j| sum - a[i][j] * b[j]);
        b[i] = sum / a[i][i];
    }
    Some(b)
}
