//! Derivatives through kept gains in space: what is carried outward and inward.

mod axial;
mod bodies;
pub(super) mod columns;
mod floating;
mod joints;
mod prismatic;

use crate::mechanics::spatial::loads::Effort;
use crate::mechanics::spatial::{Acceleration, Frame, Spatial, Turn};
use crate::relation::spatial::algebra::{Columns, zero};
use crate::scalar::{Jet, Scalar};
use crate::sensitive::Varied;
use columns::*;
use nalgebra::Vector3;

/// A motion on its way outward.
#[derive(Clone, Copy, Debug)]
pub struct Passing<T, const K: usize> {
    /// Orientation of the body on the inboard side.
    pub(super) turn: Turn<T>,
    /// Acceleration of the station, in a frame that falls freely, and of that body.
    pub(super) acceleration: Acceleration<T>,
    /// Columns of φ.
    pub(super) angle: Vectors<T, K>,
    /// Columns of ω.
    pub(super) spin: Vectors<T, K>,
    /// Columns of the accelerations.
    pub(super) linear: Vectors<T, K>,
    pub(super) angular: Vectors<T, K>,
}

/// A force on its way inward.
#[derive(Clone, Copy, Debug)]
pub struct Pulling<T, const K: usize> {
    /// Force (N) and torque (N·m) on the outboard part.
    pub(super) force: Vector3<T>,
    pub(super) torque: Vector3<T>,
    /// Columns of the force and of the torque.
    pub(super) forces: Vectors<T, K>,
    pub(super) torques: Vectors<T, K>,
}

/// Columns of an acceleration on their way outward.
#[derive(Clone, Copy, Debug)]
pub struct Answering<T, const K: usize> {
    pub(super) linear: Vectors<T, K>,
    pub(super) angular: Vectors<T, K>,
}

impl<T: Scalar, const K: usize> Varied for Spatial<Jet<T, K>> {
    type Number = T;
    type Plain = Spatial<T>;
    type Outward = Passing<T, K>;
    type Inward = Pulling<T, K>;
    type Response = Answering<T, K>;

    #[cfg_attr(optimised, inline(always))]
    fn ground(frame: &Frame<Jet<T, K>>, gravity: Vector3<Jet<T, K>>) -> Passing<T, K> {
        let Acceleration { linear, angular } = frame.falling(gravity);
        Passing {
            turn: Self::plain_turn(frame),
            acceleration: Acceleration { linear: value(&linear), angular: value(&angular) },
            angle: turned(&frame.turn.attitude),
            spin: parts(&frame.turn.spin),
            linear: parts(&linear),
            angular: parts(&angular),
        }
    }
    fn plain_turn(frame: &Frame<Jet<T, K>>) -> Turn<T> {
        let Columns { x, y, z } = frame.turn.attitude;
        Turn { attitude: Columns { x: value(&x), y: value(&y), z: value(&z) }, spin: value(&frame.turn.spin) }
    }
    fn ground_turns(_: &Frame<Jet<T, K>>) -> bool {
        false // it is carried in any case
    }
    #[inline(always)]
    fn no_pull() -> Pulling<T, K> {
        Pulling { force: zero(), torque: zero(), forces: none(), torques: none() }
    }
    #[inline(always)]
    fn stillness() -> Answering<T, K> {
        Answering { linear: none(), angular: none() }
    }
    #[cfg_attr(optimised, inline(always))]
    fn pull(chain: &mut Pulling<T, K>, arm: &Pulling<T, K>) {
        chain.force += arm.force;
        chain.torque += arm.torque;
        add(&mut chain.forces, &arm.forces);
        add(&mut chain.torques, &arm.torques);
    }
}

impl<T: Scalar, const K: usize> crate::sensitive::Effort<Spatial<Jet<T, K>>> for Effort<Jet<T, K>> {
    fn effort(self) -> Self {
        self
    }
}

/// A torque about the one axis, or a force along it.
impl<T: Scalar, const K: usize> crate::sensitive::Effort<Spatial<Self>> for Jet<T, K> {
    fn effort(self) -> Effort<Self> {
        let none = Jet::of(T::zero());
        Effort([self, none, none])
    }
}

/// Columns of the φ by which axes turn, ½ Σ r × dr over the axes r.
pub(super) fn turned<T: Scalar, const K: usize>(axes: &Columns<Jet<T, K>>) -> Vectors<T, K> {
    let mut angle = none();
    for axis in [&axes.x, &axes.y, &axes.z] {
        apply(&mut angle, &crossed(value(axis) * T::literal(0.5)), &parts(axis));
    }
    angle
}
