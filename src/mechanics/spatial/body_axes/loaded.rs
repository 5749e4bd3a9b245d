//! Loads on links in a sweep: wrenches, and forces that yield.

use super::number::triple;
use super::relation::{Alone, Local, LocalCuts, Outboard};
use super::sparse::Sparse;
use crate::element::{Load, Springs};
use crate::mechanics::spatial::{BodyMotion, Spatial, Wrench};
use crate::relation::spatial::algebra::{cross, zero};
use crate::relation::{Absent, Additive, Closures, Cuts, Join, Open, Part};
use crate::scalar::Scalar;
use core::ops::Add;
use nalgebra::Vector3;

/// A load on a link, in axes of the link about its origin, or none.
pub trait OnLink<T: Scalar>: Part {
    /// What a link that carries no others makes of it.
    type Alone<const MOMENT: u8, const TENSOR: u8>: Outboard<T, Closures = Open>;
    /// The load on a link that carries no others.
    fn on_alone<K: Springs<T>, const MOMENT: u8, const TENSOR: u8>(
        self,
        link: Alone<T, MOMENT, TENSOR>,
        springs: K,
    ) -> Self::Alone<MOMENT, TENSOR>;
    /// The load on a link that carries others.
    fn on_others<K: Springs<T>, Q: Closures>(self, relation: Local<T, Q>, springs: K) -> Local<T, Q>;
}

impl<T: Scalar> OnLink<T> for Absent {
    type Alone<const MOMENT: u8, const TENSOR: u8> = Alone<T, MOMENT, TENSOR>;
    #[cfg_attr(optimised, inline(always))]
    fn on_alone<K: Springs<T>, const MOMENT: u8, const TENSOR: u8>(
        self,
        link: Alone<T, MOMENT, TENSOR>,
        _: K,
    ) -> Alone<T, MOMENT, TENSOR> {
        link
    }
    #[inline(always)]
    fn on_others<K: Springs<T>, Q: Closures>(self, relation: Local<T, Q>, _: K) -> Local<T, Q> {
        relation
    }
}

/// The relation of a link that carries none and bears a load: force and torque are there, whatever zeros its inertia has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bearing<T, const MOMENT: u8, const TENSOR: u8>(Alone<T, MOMENT, TENSOR>);

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> Outboard<T> for Bearing<T, MOMENT, TENSOR> {
    type Closures = Open;
    #[inline(always)]
    fn sparse(self) -> Sparse<T> {
        let (force, torque) = (triple(self.0.force), triple(self.0.torque));
        Sparse { force, torque, ..self.0.parts() }
    }
    #[inline(always)]
    fn cuts(self) -> LocalCuts<T, Open> {
        Cuts::none()
    }
}

/// a − b.
#[inline(always)]
fn less<T: Scalar>(a: [T; 3], b: Vector3<T>) -> [T; 3] {
    [a[0] - b.x, a[1] - b.y, a[2] - b.z]
}

impl<T: Scalar> OnLink<T> for Wrench<T> {
    type Alone<const MOMENT: u8, const TENSOR: u8> = Bearing<T, MOMENT, TENSOR>;
    #[cfg_attr(optimised, inline(always))]
    fn on_alone<K: Springs<T>, const MOMENT: u8, const TENSOR: u8>(
        self,
        link: Alone<T, MOMENT, TENSOR>,
        _: K,
    ) -> Bearing<T, MOMENT, TENSOR> {
        // Without a first moment no force is stored.
        let still = if MOMENT & 7 == 0 { [T::zero(); 3] } else { link.force };
        Bearing(Alone { force: less(still, self.force), torque: less(link.torque, self.torque), ..link })
    }
    #[inline(always)]
    fn on_others<K: Springs<T>, Q: Closures>(self, relation: Local<T, Q>, _: K) -> Local<T, Q> {
        let (force, torque) = (less(relation.force, self.force), less(relation.torque, self.torque));
        Local { force, torque, ..relation }
    }
}

/// A symmetric form of six, of forces and torques about a body's origin by motions of the body, in its axes: how a load yields to them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block<T> {
    /// Force by displacement: xx, yy, zz, yz, xz, xy.
    pub linear: [T; 6],
    /// Force by turn, row by row.
    pub coupling: [[T; 3]; 3],
    /// Torque by turn: xx, yy, zz, yz, xz, xy.
    pub angular: [T; 6],
}

impl<T: Scalar> Block<T> {
    /// Zero.
    pub fn zero() -> Self {
        let o = T::zero();
        Self { linear: [o; 6], coupling: [[o; 3]; 3], angular: [o; 6] }
    }

    /// What resists at a point of the body (m, its axes) by `along` along a unit vector (its axes), and by `across` across it.
    pub fn at(point: Vector3<T>, direction: Vector3<T>, along: T, across: T) -> Self {
        let (n, m) = (direction, cross(point, direction));
        let (more, o) = (along - across, T::zero());
        let (p, square) = (point, point.x * point.x + point.y * point.y + point.z * point.z);
        let dyad = |a: Vector3<T>, b: Vector3<T>, i: usize, k: usize| more * a[i] * b[k];
        let tilde = [[o, p.z, -p.y], [-p.z, o, p.x], [p.y, -p.x, o]]; // −p~
        let pairs = [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
        let same = |i: usize, k: usize, x: T| if i == k { x } else { o };
        Self {
            linear: pairs.map(|(i, k)| same(i, k, across) + dyad(n, n, i, k)),
            coupling: core::array::from_fn(|i| core::array::from_fn(|k| across * tilde[i][k] + dyad(n, m, i, k))),
            angular: pairs.map(|(i, k)| across * (same(i, k, square) - p[i] * p[k]) + dyad(m, m, i, k)),
        }
    }

    /// Number by number of two.
    #[cfg_attr(optimised, inline(always))]
    fn with(self, other: Self, each: impl Fn(T, T) -> T) -> Self {
        let all = |a: [T; 6], b: [T; 6]| core::array::from_fn(|k| each(a[k], b[k]));
        let rows = core::array::from_fn(|i| core::array::from_fn(|k| each(self.coupling[i][k], other.coupling[i][k])));
        Self { linear: all(self.linear, other.linear), coupling: rows, angular: all(self.angular, other.angular) }
    }
}

/// A load on a body that says how it yields: a wrench (inertial axes, about the inboard end), and by how much it falls as the body moves
/// and gains velocity, as if both were small. Implicit sweeps take it linearly implicitly, explicit ones as the wrench that it is. The
/// forms may leave out what is not symmetric: sweeps that repeat converge to the wrench in any case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Yielding<T> {
    /// The load.
    pub wrench: Wrench<T>,
    /// By displacement (N/m, N, N·m).
    pub stiffness: Block<T>,
    /// By velocity (N·s/m, N·s, N·m·s).
    pub damping: Block<T>,
    /// Acceleration of the origin and of the body that led to where the load was read, in axes of the body.
    led: [Vector3<T>; 2],
    /// Whether there is a load: most bodies bear none of what acts on some.
    bears: bool,
}

impl<T: Scalar> Yielding<T> {
    /// A load with what it yields.
    pub fn new(wrench: Wrench<T>, stiffness: Block<T>, damping: Block<T>) -> Self {
        Self { wrench, stiffness, damping, led: [zero(); 2], bears: true }
    }
}

impl<T: Scalar> Add for Yielding<T> {
    type Output = Self;
    #[cfg_attr(optimised, inline(always))]
    fn add(self, other: Self) -> Self {
        match [self.bears, other.bears] {
            [_, false] => return self,
            [false, true] => return other,
            [true, true] => {}
        }
        Self {
            wrench: self.wrench + other.wrench,
            stiffness: self.stiffness.with(other.stiffness, |a, b| a + b),
            damping: self.damping.with(other.damping, |a, b| a + b),
            ..self
        }
    }
}

impl<T: Scalar> Additive for Yielding<T> {
    fn null() -> Self {
        Self { bears: false, ..Self::new(Wrench::default(), Block::zero(), Block::zero()) }
    }
}

impl<T: Scalar> Part for Yielding<T> {
    fn is_finite(self) -> bool {
        let finite = |list: &[T]| list.iter().all(|x| Scalar::is_finite(*x));
        let slopes = [self.stiffness, self.damping];
        let slopes =
            slopes.iter().all(|b| finite(&b.linear) && finite(b.coupling.as_flattened()) && finite(&b.angular));
        Part::is_finite(self.wrench) && slopes
    }
}

impl<T: Scalar> Load<Spatial<T>> for Yielding<T> {
    const YIELDS: bool = true;
    #[inline(always)]
    fn wrench(self) -> Wrench<T> {
        self.wrench
    }
    #[cfg_attr(optimised, inline(always))]
    fn in_own_axes(self, body: &BodyMotion<T>) -> Self {
        if !self.bears {
            return self;
        }
        let frame = &body.inboard;
        let led = [frame.acceleration.linear, frame.acceleration.angular].map(|a| frame.turn.attitude.transposed(a));
        Self { wrench: Load::<Spatial<T>>::in_own_axes(self.wrench, body), led, ..self }
    }
}

impl<T: Scalar> OnLink<T> for Yielding<T> {
    type Alone<const MOMENT: u8, const TENSOR: u8> = Local<T>;
    #[cfg_attr(optimised, inline(always))]
    fn on_alone<K: Springs<T>, const MOMENT: u8, const TENSOR: u8>(
        self,
        link: Alone<T, MOMENT, TENSOR>,
        springs: K,
    ) -> Local<T> {
        self.on_others(link.parts().dense(), springs)
    }
    #[cfg_attr(optimised, inline(always))]
    fn on_others<K: Springs<T>, Q: Closures>(self, relation: Local<T, Q>, springs: K) -> Local<T, Q> {
        if !self.bears {
            return relation;
        }
        let relation = self.wrench.on_others(relation, springs);
        if const { !K::STIFF } {
            return relation;
        }
        let Block { linear, coupling, angular } = self.stiffness.with(self.damping, |k, c| springs.pivot(k, c));
        let none = [T::zero(); 3];
        let yielding = Local { linear, coupling, angular, force: none, torque: none, cuts: Cuts::none() };
        // What it yields to the acceleration sought, less to that which led there.
        let [force, torque] = yielding.answer(self.led);
        let (force, torque) = (less(relation.force, force), less(relation.torque, torque));
        Local { force, torque, ..relation }.join(yielding)
    }
}
