//! Joints whose coordinates turn about axes or slide along them: what each has to say of itself.

use super::Turn;
use crate::element::Implicit;
use crate::error::Fault;
use crate::error::checks::finite;
use crate::mirror::{Position, Rate};
use crate::relation::spatial::Way;
use crate::relation::spatial::algebra::{Columns, cross, dot, zero};
use crate::scalar::{Elementary, Real, Scalar};
use core::fmt::Debug;
use nalgebra::Vector3;
use num_traits::{One, Zero};

/// Coordinates as a list: a number, or an array of numbers.
pub trait Listed<T: Scalar, const K: usize>: Position<T, Rate = Self> + Rate<T> + Copy {
    /// The coordinates.
    fn list(&self) -> [T; K];
    /// Coordinates from a list.
    fn from_list(list: [T; K]) -> Self;
}

impl<T: Scalar> Listed<T, 1> for T {
    #[inline(always)]
    fn list(&self) -> [T; 1] {
        [*self]
    }
    #[inline(always)]
    fn from_list([x]: [T; 1]) -> T {
        x
    }
}

impl<T: Scalar> Listed<T, 2> for [T; 2] {
    #[inline(always)]
    fn list(&self) -> [T; 2] {
        *self
    }
    #[inline(always)]
    fn from_list(list: [T; 2]) -> Self {
        list
    }
}

/// What a joint does with its coordinates, in inertial axes.
pub struct Relative<T, const K: usize> {
    /// Axes of the outboard body.
    pub attitude: Columns<T>,
    /// Axes of the coordinates, innermost first.
    pub axes: [Vector3<T>; K],
    /// Relative angular velocity.
    pub spin: Vector3<T>,
    /// From the inboard to the outboard point.
    pub arm: Vector3<T>,
    /// Rate of the arm as seen from the inboard body.
    pub sliding: Vector3<T>,
    /// Angular acceleration besides ω × ω_rel that rates cause.
    pub extra: Vector3<T>,
}

/// A joint that turns about axes or slides along them, at most two.
pub trait Axial<T: Scalar, const K: usize>: Copy + Debug + 'static {
    /// Coordinates of the joint.
    type Coordinates: Listed<T, K>;
    /// What the coordinates do, innermost first: turn or slide.
    const WAYS: [Way; K];
    /// Whether the joint's points slide apart.
    const SLIDES: bool;
    /// Whether the joint's bodies turn.
    const TURNS: bool;
    /// Whether the joint's springs and dampers are linear.
    const LINEAR: bool = false;

    /// What the coordinates do on an inboard body that is turned like this.
    fn relative(&self, inboard: &Turn<T>, position: [T; K], rate: [T; K]) -> Relative<T, K>;
    /// Adds the generalised force of the spring and damper of coordinate `k` to a sum.
    fn force(&self, k: usize, position: T, rate: T) -> T;
    /// K̂ of coordinate `k` in an implicit sweep.
    fn pivot(&self, k: usize, position: T, rate: T, springs: Implicit<T::Real>) -> T;
    /// Energy stored in springs (J).
    fn energy(&self, position: [T; K]) -> T;
    /// Takes the point mass (kg) that its outboard neighbour lumps at the joint, and hands it on unless its points slide apart.
    fn lump(&mut self, mass: T) -> T {
        mass
    }
    /// Point mass (kg) that the joint has not handed on.
    fn lumped(&self) -> T {
        T::zero()
    }
    /// Rejects parameters that make no mechanics.
    ///
    /// # Errors
    /// What is wrong with them.
    fn verify(&self) -> Result<(), Fault>;
}

/// Columns of which of a body's own axes is not along another: the first one, or the second. Lanes decide each for itself.
#[cfg_attr(optimised, inline(always))]
pub(crate) fn aside<T: Scalar, const N: usize>(
    axis: Vector3<T>,
    first: [Vector3<T>; N],
    second: [Vector3<T>; N],
) -> [Vector3<T>; N] {
    let most = T::Real::of(0.6);
    if const { !T::LANES } {
        return if axis.x.real().abs() < most { first } else { second };
    }
    let beyond = axis.x.abs() - T::constant(most);
    core::array::from_fn(|k| first[k].zip_map(&second[k], |first, second| beyond.if_negative(first, second)))
}

/// A direction with length one; one without length stays so, for [`check_axis`] to find.
pub(super) fn unit<T: Scalar>(axis: [T; 3]) -> Vector3<T> {
    let axis = Vector3::from(squarable(axis));
    let square = dot(axis, axis);
    if square.real() > T::Real::zero() { axis * square.sqrt().recip() } else { axis * T::zero() }
}

/// A list of numbers of which squares have all their digits: divided by the largest, where that is so large or so small that they might not.
pub(super) fn squarable<T: Scalar, const N: usize>(list: [T; N]) -> [T; N] {
    let largest = list.iter().fold(T::Real::zero(), |most, x| most.max(x.real().abs()));
    let extreme = largest.is_finite() && largest > T::Real::zero() && !(1e-12..=1e12).contains(&largest.as_f64());
    if extreme { list.map(|x| x / T::constant(largest)) } else { list }
}

/// Rejects directions that are none.
pub(super) fn check_axis<T: Scalar>(axis: Vector3<T>) -> Result<(), Fault> {
    finite("axis", &[axis.x, axis.y, axis.z])?;
    if axis == zero::<Vector3<T>>() {
        return Err(Fault::NotPositive { parameter: "length of the axis", value: 0.0 });
    }
    check_length("length of the axis", dot(axis, axis))
}

/// Rejects directions and quaternions whose length is not one, but for rounding, given its square: those that were read, and those whose
/// square was too small for all its digits.
pub(super) fn check_length<T: Scalar>(parameter: &'static str, square: T) -> Result<(), Fault> {
    let worst = if T::LANES { (square - T::one()).real() + T::Real::one() } else { square.real() };
    let (value, slack) = (worst.sqrt(), T::Real::EPSILON.sqrt());
    if (value - T::Real::one()).abs() <= slack {
        return Ok(());
    }
    let outside = "turns would stretch bodies";
    Err(Fault::OutOfRange { parameter, value: value.as_f64(), least: 1.0, most: 1.0, outside })
}

/// Whether these are axes at right angles, right-handed and of length one, but for rounding.
pub(crate) fn orthonormal<T: Scalar>(Columns { x, y, z }: &Columns<T>) -> bool {
    // Rounding of any kind passes, a digit left out does not.
    let slack = T::Real::EPSILON.sqrt();
    let third = cross(*x, *y) - z;
    let misses = [dot(*x, *x) - T::one(), dot(*y, *y) - T::one(), dot(*x, *y), third.x, third.y, third.z];
    misses.into_iter().all(|miss| miss.real().abs() <= slack)
}
