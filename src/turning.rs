//! How joints turn bodies: orientations and angular velocities in the plane and in space alike, as vectors.

use crate::mirror::Rate;
use crate::scalar::{Elementary, Scalar};
use crate::shape::Joint;
use crate::space::{FrameOf, RealOf, Space};
use num_traits::{One, Zero};

/// A space whose orientations can be compared. Turns and angular velocities are vectors in inertial axes; in the plane they point along z.
pub trait Turning: Space {
    /// An absolute orientation: an angle (rad), or a rotation.
    type Orientation: Copy;
    /// An angular velocity (rad/s): one number in the plane, three in space.
    type Spin: Copy;

    /// A frame at rest that is turned so, but for its angular velocity.
    fn facing(turn: Self::Turn) -> FrameOf<Self>;
    /// An orientation at rest: the turn without its angular velocity.
    fn still(turn: Self::Turn) -> Self::Turn;
    /// Angular velocity.
    fn spin(turn: &Self::Turn) -> [Self::Scalar; 3];
    /// An angular velocity that is given in inertial axes.
    fn in_inertial_axes(spin: Self::Spin) -> [Self::Scalar; 3];
    /// An angular velocity that is given in axes of a body.
    fn in_axes_of(body: &Self::Turn, spin: Self::Spin) -> [Self::Scalar; 3];
    /// The turn (rad) that leads from here to an orientation.
    fn towards(here: &Self::Turn, there: &Self::Orientation) -> [Self::Scalar; 3];
    /// The orientation that one body must have for another, fixed to it, to have the orientation wanted.
    fn carrying(wanted: Self::Orientation, one: &Self::Turn, other: &Self::Turn) -> Self::Orientation;
    /// Whether an orientation is finite.
    fn orientation_is_finite(orientation: &Self::Orientation) -> bool;
}

/// The largest number of coordinates by which a joint turns its body.
const MOST: usize = 3;

/// How the rates of a joint turn its outboard body against one that rests: ω = Σ axis q̇.
pub struct Axes<T> {
    /// The number of the rate among those of the joint, and its axis.
    list: [(usize, [T; 3]); MOST],
    count: usize,
}

/// The orientation and angular velocity of the outboard body.
pub fn outboard<S: Turning, J: Joint<S>>(
    joint: &J,
    inboard: S::Turn,
    position: &J::Position,
    rate: &J::Rate,
) -> S::Turn {
    joint.motion(S::facing(inboard), position, rate, &J::still().1).1.turn
}

fn dot<T: Scalar>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The length of a vector.
pub fn length<T: Scalar>(v: &[T; 3]) -> T::Real {
    dot(v, v).real().sqrt()
}

/// a − b.
pub fn minus<T: Scalar>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a + b.
pub fn plus<T: Scalar>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

impl<T: Scalar> Axes<T> {
    /// Axes of a joint's rates.
    pub fn of<S: Turning<Scalar = T>, J: Joint<S>>(joint: &J, inboard: S::Turn, position: &J::Position) -> Self {
        let mut axes = Self { list: [(0, [T::zero(); 3]); MOST], count: 0 };
        let (mut unit, mut rates) = (J::still().1, 0);
        unit.visit(&mut |_| rates += 1);
        for k in 0..rates {
            let mut i = 0;
            unit.replace(&mut |_| {
                i += 1;
                if i == k + 1 { T::one() } else { T::zero() }
            });
            let axis = S::spin(&outboard(joint, S::still(inboard), position, &unit));
            if length(&axis) > RealOf::<S>::zero() && axes.count < MOST {
                axes.list[axes.count] = (k, axis);
                axes.count += 1;
            }
        }
        axes
    }

    /// By how many coordinates the joint turns its body.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Rates whose angular velocity is nearest to one.
    pub fn rates_for(&self, spin: &[T; 3]) -> [T; 3] {
        let n = self.count;
        let axis = |k: usize| &self.list[k].1;
        // Normal equations: axes of joints are never nearly parallel.
        let mut rows = [[T::zero(); MOST + 1]; MOST];
        for (i, row) in rows.iter_mut().enumerate().take(n) {
            for (j, entry) in row.iter_mut().enumerate().take(n) {
                *entry = dot(axis(i), axis(j));
            }
            row[MOST] = dot(axis(i), spin);
        }
        for i in 0..n {
            let pivot = rows[i];
            for row in rows.iter_mut().take(n).skip(i + 1) {
                let share = row[i] / pivot[i];
                row.iter_mut().zip(pivot).for_each(|(x, above)| *x -= share * above);
            }
        }
        let mut rates = [T::zero(); MOST];
        for i in (0..n).rev() {
            let known = (i + 1..n).fold(T::zero(), |sum, j| sum + rows[i][j] * rates[j]);
            rates[i] = (rows[i][MOST] - known) / rows[i][i];
        }
        rates
    }

    /// Angular velocity Σ axis q̇ (rad/s) of the outboard body against one that rests.
    pub fn spin_of(&self, rates: &[T; 3]) -> [T; 3] {
        let own = self.list[..self.count].iter().zip(rates);
        own.fold([T::zero(); 3], |sum, ((_, axis), rate)| plus(sum, axis.map(|x| x * *rate)))
    }

    /// Puts these rates in the place of a joint's.
    pub fn put<R: Rate<T>>(&self, rates: &[T; 3], into: &mut R) {
        let mut k = 0;
        into.replace(&mut |old| {
            let own = self.list[..self.count].iter().zip(rates).find(|((at, _), _)| *at == k);
            k += 1;
            own.map_or(old, |(_, rate)| *rate)
        });
    }

    /// A step of coordinates (rad) whose turn is nearest to one, none by several coordinates longer than 1 rad: turns do not add up.
    pub fn step_for(&self, turn: &[T; 3]) -> ([T; 3], T::Real) {
        let step = self.rates_for(turn);
        let size = length(&step);
        if self.count > 1 && size > T::Real::one() {
            return (step.map(|x| x.scale(T::Real::one() / size)), size);
        }
        (step, size)
    }
}
