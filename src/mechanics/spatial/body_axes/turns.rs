//! How the axes of a body are turned against those of its parent while its joint is at zero.

use super::number::{Number, Rows, triple};
use crate::error::Fault;
use crate::error::checks::finite;
use crate::lift::{Lift, lift};
use crate::mechanics::spatial::Rotation;
use crate::mechanics::spatial::axial::{check_length, orthonormal};
use crate::relation::spatial::algebra::Columns;
use crate::scalar::Scalar;
use core::fmt::Debug;
use nalgebra::Vector3;

/// A constant turn between a body and its parent: what is known of it by type costs nothing.
pub trait Offset<T: Scalar>: Copy + Debug + 'static {
    /// Whether numbers say what it is, and not the type alone.
    const NUMBERED: bool;
    /// Axes of the body in those of its parent, as columns: the rows of that matrix.
    fn rows(&self) -> Rows<T>;
    /// Rejects numbers that make no turn.
    ///
    /// # Errors
    /// [`Fault::NotFinite`]; [`Fault::NotZero`] for axes that are not orthonormal.
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

/// No turn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Level;

/// One of the 24 turns of a cube: the body's x axis points along an axis of the parent, and so do the two others.
///
/// `CODE` is x + 6 y, where x and y number the directions of the body's x and y axes in axes of the parent: 0, 1, 2 for +x, +y, +z and
/// 3, 4, 5 for −x, −y, −z.
///
/// ```
/// use catena::robot::Quarter;
/// type LayZAlongY = Quarter<{ Quarter::<0>::code([0, 5]) }>; // x stays, y points along −z, so that z points along y
/// # let _: LayZAlongY = Quarter::<30>;
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Quarter<const CODE: u8>;

/// A turn by an angle (rad) about the parent's x axis: what is left of any turn once axes are chosen as Denavit and Hartenberg do.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Leaning<T> {
    cosine: T,
    sine: T,
}

/// Any turn.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "Columns<T>: serde::Serialize", deserialize = "Columns<T>: serde::Deserialize<'de>"))
)]
pub struct Turned<T> {
    axes: Columns<T>,
}

impl<const CODE: u8> Quarter<CODE> {
    /// The code of a turn, from the directions of the body's x and y axes: 0 to 5 for +x, +y, +z, −x, −y, −z of the parent.
    pub const fn code([x, y]: [u8; 2]) -> u8 {
        x + 6 * y
    }

    /// Directions of the axes, as the code numbers them.
    const DIRECTIONS: [u8; 3] = {
        let (x, y) = (CODE % 6, CODE / 6);
        assert!(y < 6 && x % 3 != y % 3, "the code of a turn is x + 6 y, of directions 0 to 5 that are not parallel");
        // z = x × y: the third axis, positive where x and y follow each other.
        let follows = (x % 3 + 1) % 3 == y % 3;
        let positive = ((x < 3) == (y < 3)) == follows;
        let third = 3 - x % 3 - y % 3;
        [x, y, if positive { third } else { third + 3 }]
    };
}

impl<T: Scalar> Leaning<T> {
    /// By an angle (rad).
    pub fn by(angle: T) -> Self {
        let (sine, cosine) = angle.sin_cos();
        Self { cosine, sine }
    }
}

impl<T: Scalar> Turned<T> {
    /// By a rotation.
    pub fn by(rotation: Rotation<T>) -> Self {
        Self { axes: rotation.matrix() }
    }

    /// With the body's axes as columns, in axes of the parent: orthonormal and right-handed to half of the digits, which the scene checks.
    pub fn axes([x, y, z]: [[T; 3]; 3]) -> Self {
        Self { axes: Columns { x: Vector3::from(x), y: Vector3::from(y), z: Vector3::from(z) } }
    }
}

impl<T: Scalar> Offset<T> for Level {
    const NUMBERED: bool = false;

    #[inline(always)]
    fn rows(&self) -> Rows<T> {
        let (o, i) = (Number::zero(), Number::one());
        [[i, o, o], [o, i, o], [o, o, i]]
    }
}

/// A component of a direction.
#[cfg_attr(optimised, inline(always))]
fn along<T: Scalar>(direction: u8, axis: u8) -> Number<T> {
    if direction == axis {
        Number::one()
    } else if direction == axis + 3 {
        Number::one().negated()
    } else {
        Number::zero()
    }
}

impl<T: Scalar, const CODE: u8> Offset<T> for Quarter<CODE> {
    const NUMBERED: bool = false;

    #[cfg_attr(optimised, inline(always))]
    fn rows(&self) -> Rows<T> {
        let [x, y, z] = const { Self::DIRECTIONS };
        [
            [along(x, 0), along(y, 0), along(z, 0)],
            [along(x, 1), along(y, 1), along(z, 1)],
            [along(x, 2), along(y, 2), along(z, 2)],
        ]
    }
}

impl<T: Scalar> Offset<T> for Leaning<T> {
    const NUMBERED: bool = true;

    #[cfg_attr(optimised, inline(always))]
    fn rows(&self) -> Rows<T> {
        let (o, i) = (Number::zero(), Number::one());
        let (c, s) = (Number::of(self.cosine), Number::of(self.sine));
        [[i, o, o], [o, c, s.negated()], [o, s, c]]
    }
    fn check(&self) -> Result<(), Fault> {
        finite("turn of a body's axes", &[self.cosine, self.sine])?;
        check_length("turn of a body's axes", self.cosine * self.cosine + self.sine * self.sine)
    }
}

impl<T: Scalar> Offset<T> for Turned<T> {
    const NUMBERED: bool = true;

    #[inline(always)]
    fn rows(&self) -> Rows<T> {
        let Columns { x, y, z } = self.axes;
        [triple([x.x, y.x, z.x]), triple([x.y, y.y, z.y]), triple([x.z, y.z, z.z])]
    }
    fn check(&self) -> Result<(), Fault> {
        let Columns { x, y, z } = self.axes;
        [x, y, z].into_iter().try_for_each(|axis| finite("turn of a body's axes", &[axis.x, axis.y, axis.z]))?;
        let fault = Fault::NotZero { parameter: "what a turn's axes miss to be orthonormal and right-handed" };
        if orthonormal(&self.axes) { Ok(()) } else { Err(fault) }
    }
}

lift!(Level);
lift!(Leaning { cosine, sine }, Turned { axes });

impl<T: Scalar, U: Scalar, const CODE: u8> Lift<T, U> for Quarter<CODE> {
    type Over = Self;
    fn lift(&self, _: &mut impl FnMut(T) -> U) -> Self {
        *self
    }
}
