//! What a space says of orientations, and what the scheme therefore does not know: how a body's angles enter a step, made linear.

use super::expansion::At;
use super::link::{Given, Law};
use super::product::Hinges;
use super::rule::{Coordinate, Linearization};
use crate::error::Fault;
use crate::scalar::Scalar;
use crate::state::TransferMatrix;
use core::fmt::Debug;

/// The coordinates in the slot of the angles: what bodies, joints and hinges of a space say of a step.
pub trait Orient<T: Scalar, const N: usize, const P: usize, const A: usize>:
    Hinges<T, N, P, A> + Expanded<T, P, A> + Bodies<T, N, P, A> + Joints<T, P, A> + Debug
{
}

impl<T: Scalar, E, const N: usize, const P: usize, const A: usize> Orient<T, N, P, A> for E where
    E: Hinges<T, N, P, A> + Expanded<T, P, A> + Bodies<T, N, P, A> + Joints<T, P, A> + Debug
{
}

/// An orientation made linear in its coordinates for one step.
pub trait Expanded<T: Scalar, const P: usize, const A: usize>: Copy {
    /// What a run keeps of the orientation at t_{i−1} besides the coordinates.
    type Base: Copy + Debug;

    /// The linearisation of a step over `span` (s), from ξ, ξ̇, ξ̈ of the coordinates, and the increments where it is taken.
    fn first(
        at: At,
        base: &Self::Base,
        past: &[[T; 3]; A],
        step: &[Linearization<T>; A],
        span: T::Real,
    ) -> (Self, [T; A]);
    /// The linearisation about increments found.
    fn again(base: &Self::Base, step: &[Linearization<T>; A], found: &[T; A]) -> Self;
    /// Residual of the linearisation: by how much coordinates miss where it was taken (rad).
    fn residual(&self, angles: &[T; A]) -> T::Real;
    /// Refuses orientations that these coordinates cannot say.
    ///
    /// # Errors
    /// [`Fault::SingularAngles`].
    fn check(&self) -> Result<(), Fault>;

    /// Whether coordinates of this space may be singular somewhere.
    const SINGULAR: bool;
    /// Refuses increments of coordinates that turn faster than the orientation does, as they do where they are nearly singular.
    ///
    /// # Errors
    /// [`Fault::SingularAngles`].
    fn follow(past: &[T; A], found: &[T; A]) -> Result<(), Fault>;

    /// (22): how the place of a point of the body depends on the coordinates.
    fn psi(&self, point: [T; P]) -> [[T; A]; P];
    /// Φ r of (21): the place of a point where coordinates are zero.
    fn phi(&self, point: [T; P]) -> [T; P];
    /// By how much a vector as expanded differs from the true one at given coordinates, to all its digits.
    fn remainder(&self, base: &Self::Base, point: [T; P], angles: &[T; A]) -> [T; P];
    /// A vector of body axes, turned.
    fn turned(base: &Self::Base, point: [T; P], angles: &[T; A]) -> [T; P];
    /// Retracts a step: the attitude reached becomes the base, and coordinates counted from it begin at zero anew.
    fn retract<M: Copy>(base: &mut Self::Base, angles: &mut [Coordinate<T, M>; A]);
    /// The angles of a body, for a reader, near earlier ones.
    fn shown(base: &Self::Base, angles: &[T; A], near: &[T; A]) -> [T; A];
}

/// Bodies in a step.
pub trait Bodies<T: Scalar, const N: usize, const P: usize, const A: usize> {
    /// What is constant in a body.
    type Rigid: Copy + Debug;
    /// Motion of a body of this space.
    type Motion: Copy + Debug;
    /// Force and torque on a body.
    type External: Copy + Debug;

    /// Mass centre and outboard end of a body, body axes from its inboard end.
    fn arms(rigid: &Self::Rigid) -> [[T; P]; 2];
    /// The size of the terms of (32) u₄₃: J_I + m |d_C| |d_O|.
    fn inertia(rigid: &Self::Rigid) -> T::Real;
    /// Whether a smooth joint at a body's inboard end has no matrix (40).
    fn is_percussive(rigid: &Self::Rigid) -> bool;
    /// (32), (31).
    fn matrix(
        &self,
        rigid: &Self::Rigid,
        step: &Linearization<T>,
        given: &Given<T, P, A>,
        external: &Self::External,
    ) -> TransferMatrix<T, N>;
    /// Whether force and torque on a body are finite.
    fn is_finite(external: &Self::External) -> bool;
    /// A body near where it will be, for loads to be read there.
    fn motion(&self, rigid: &Self::Rigid, place: [T; P], velocity: [T; P], turn: [[T; 2]; A]) -> Self::Motion;
}

/// Joints and the ground in a step.
pub trait Joints<T: Scalar, const P: usize, const A: usize>: Expanded<T, P, A> {
    /// The attitude of one side of a rigid joint to the other.
    type Ahead: Copy + Debug;
    /// Motion of a station of this space.
    type Frame: Copy + Debug;

    /// (34) of an elastic joint. The offset holds in absolute coordinates or in increments.
    fn law(spring: &Spring<T, A>, elastic: &[T; A], sides: [&Side<T, Self, A>; 2], absolute: bool) -> Law<T, A>;
    /// The ground as a side of a joint.
    fn ground(base: &Self::Base, frames: [&Self::Frame; 2], step: &Linearization<T>) -> Side<T, Self, A>;
    /// The coordinates of the ground itself at t_{i−1} and where forces balance.
    fn grounded(base: &Self::Base, frames: [&Self::Frame; 2]) -> [[T; A]; 2];
    /// A joint that does not turn: R, and by how much its outboard side is ahead in absolute coordinates.
    fn rigid(ahead: &Self::Ahead) -> (Option<[[T; A]; A]>, [T; A]);
    /// The coordinates of a body that the ground holds, with this attitude to it.
    fn clamped(base: &Self::Base, past: &[T; A], ahead: &Self::Ahead, ground: &Self::Frame) -> [T; A];
    /// The place of a frame.
    fn place(frame: &Self::Frame) -> [T; P];
    /// The angles of a frame, for a reader, near those of another.
    fn angles(frame: &Self::Frame, near: &[T; A]) -> [T; A];
}

/// A rotary spring and damper between two bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring<T, const A: usize> {
    /// k′ (N·m/rad).
    pub stiffness: [T; A],
    /// c′ (N·m·s/rad).
    pub damping: [T; A],
    /// k′φ₀ (N·m).
    pub preload: [T; A],
}

impl<T: Scalar, const A: usize> Spring<T, A> {
    /// Nothing.
    pub fn none() -> Self {
        Self { stiffness: [T::zero(); A], damping: [T::zero(); A], preload: [T::zero(); A] }
    }
}

/// The axes of a body as a step expands them: where each points, and how that depends on the coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Axes<T, const P: usize, const A: usize> {
    /// Where the axes point if coordinates stay, or, in absolute coordinates, where these are zero.
    pub points: [[T; P]; P],
    /// (22) of each.
    pub slopes: [[[T; A]; P]; P],
}

/// One side of a joint in a step.
#[derive(Clone, Copy, Debug)]
pub struct Side<T: Scalar, E, const A: usize> {
    /// Where the side's orientation is linearised.
    pub expansion: E,
    /// (1) and (2) of the side's angles.
    pub step: [Linearization<T>; A],
}

/// Coordinate by coordinate.
pub fn each<T: Scalar, M: Copy, X, const K: usize>(
    coordinates: &[Coordinate<T, M>; K],
    of: impl Fn(&Coordinate<T, M>) -> X,
) -> [X; K] {
    coordinates.each_ref().map(of)
}
