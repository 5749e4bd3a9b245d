//! How the axes of a body are turned against those of its parent while its joint is at zero.

use super::number::{Number, Rows};
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
    /// Axes of the body in those of its parent, as columns, but for what is [added](Self::ahead) to the coordinate: the rows of that matrix.
    fn rows(&self) -> Rows<T>;
    /// An angle (rad) about the joint's own axis, to be added to its coordinate before sine and cosine are taken.
    #[inline(always)]
    fn ahead(&self) -> Number<T> {
        Number::zero()
    }
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

/// A turn, and then one about the axis of the hinge itself, which is [added](super::Hinge::ahead) to its coordinate and costs no more.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ahead<T, C> {
    turn: C,
    angle: T,
}

/// Any turn.
///
/// `KNOWN` says of its matrix, whose columns are the body's axes, which entries are zero, one or minus one: two bits for each, row by row, 1, 2 or 3;
/// 0 where nothing is known, as by default. What is known costs nothing: of a turn about one axis most is.
///
/// ```
/// use catena::robot::{Rotation, Turned};
/// let lean = Rotation::from_angles([0.0, 0.0, 0.3_f64]); // about z
/// const ABOUT_Z: u32 = Turned::<f64>::code([[0, 0, 1], [0, 0, 1], [1, 1, 2]]);
/// let turned = Turned::by(lean).known::<ABOUT_Z>();
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "Columns<T>: serde::Serialize", deserialize = "Columns<T>: serde::Deserialize<'de>"))
)]
pub struct Turned<T, const KNOWN: u32 = 0> {
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

impl<T, C> Ahead<T, C> {
    /// A turn, and then one by an angle (rad).
    pub(super) fn of(turn: C, angle: T) -> Self {
        Self { turn, angle }
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

    /// What is known of the entries of a matrix, row by row: 1 of a zero, 2 of a one, 3 of a minus one, 0 of others.
    pub const fn code(rows: [[u8; 3]; 3]) -> u32 {
        let (mut code, mut entry) = (0, 9);
        while entry > 0 {
            entry -= 1;
            code = code << 2 | rows[entry / 3][entry % 3] as u32;
        }
        code
    }

    /// This turn, of a type that says what is known of its entries: [`System::new`](crate::system::System::new) refuses it where one is another
    /// number.
    pub fn known<const KNOWN: u32>(self) -> Turned<T, KNOWN> {
        Turned { axes: self.axes }
    }
}

impl<T: Scalar, const KNOWN: u32> Turned<T, KNOWN> {
    /// Entries, row by row.
    #[inline(always)]
    fn entries(&self) -> [[T; 3]; 3] {
        let Columns { x, y, z } = self.axes;
        [[x.x, y.x, z.x], [x.y, y.y, z.y], [x.z, y.z, z.z]]
    }

    /// An entry as it is known.
    #[cfg_attr(optimised, inline(always))]
    fn entry(i: usize, k: usize, value: T) -> Number<T> {
        match KNOWN >> (2 * (3 * i + k)) & 3 {
            0 => Number::of(value),
            1 => Number::zero(),
            2 => Number::one(),
            _ => Number::one().negated(),
        }
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

impl<T: Scalar, const KNOWN: u32> Offset<T> for Turned<T, KNOWN> {
    const NUMBERED: bool = true;

    #[cfg_attr(optimised, inline(always))]
    fn rows(&self) -> Rows<T> {
        let [a, b, c] = self.entries();
        [
            [Self::entry(0, 0, a[0]), Self::entry(0, 1, a[1]), Self::entry(0, 2, a[2])],
            [Self::entry(1, 0, b[0]), Self::entry(1, 1, b[1]), Self::entry(1, 2, b[2])],
            [Self::entry(2, 0, c[0]), Self::entry(2, 1, c[1]), Self::entry(2, 2, c[2])],
        ]
    }
    fn check(&self) -> Result<(), Fault> {
        let entries = self.entries();
        entries.iter().try_for_each(|row| finite("turn of a body's axes", row))?;
        if !orthonormal(&self.axes) {
            return Err(Fault::NotZero { parameter: "what a turn's axes miss to be orthonormal and right-handed" });
        }
        let as_known =
            |i: usize, k: usize| (Self::entry(i, k, entries[i][k]).value() - entries[i][k]).is_identical(T::zero());
        let all = (0..9).all(|entry| as_known(entry / 3, entry % 3));
        if all { Ok(()) } else { Err(Fault::NotZero { parameter: "turn's entries, less what its type says they are" }) }
    }
}

impl<T: Scalar, C: Offset<T>> Offset<T> for Ahead<T, C> {
    const NUMBERED: bool = true;

    #[inline(always)]
    fn rows(&self) -> Rows<T> {
        self.turn.rows()
    }
    #[inline(always)]
    fn ahead(&self) -> Number<T> {
        self.turn.ahead().plus(Number::of(self.angle))
    }
    fn check(&self) -> Result<(), Fault> {
        finite("angle that a hinge is ahead by", &[self.angle])?;
        self.turn.check()
    }
}

lift!(Level);
lift!(Leaning { cosine, sine });

impl<T: Scalar, U: Scalar, const CODE: u8> Lift<T, U> for Quarter<CODE> {
    type Over = Self;
    fn lift(&self, _: &mut impl FnMut(T) -> U) -> Self {
        *self
    }
}

impl<T: Scalar, U: Scalar, C: Lift<T, U>> Lift<T, U> for Ahead<T, C> {
    type Over = Ahead<U, C::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Ahead { turn: self.turn.lift(number), angle: self.angle.lift(number) }
    }
}

impl<T: Scalar, U: Scalar, const KNOWN: u32> Lift<T, U> for Turned<T, KNOWN> {
    type Over = Turned<U, KNOWN>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Turned { axes: self.axes.lift(number) }
    }
}
