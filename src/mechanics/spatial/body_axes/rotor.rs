//! A rotor that sits on a body and that a hinge turns by gears, exactly: T = ½ I (ω + n q̇)².
//!
//! ω is what its body turns by about the joint's axis, ω' = ω + q̇ what the body beyond the joint does. Then
//!
//! ```text
//! ½ I (ω + n q̇)² = ½ I ω² − ½ n I ω² + ½ n I ω'² + ½ (n² − n) I q̇²
//! ```
//!
//! of which the first is that of a rotor at rest on its body, and the others are those of an inertia about the axis, which is fixed in both
//! bodies, and of one along the coordinate. So links and a joint with other numbers are the rotor: no walk knows of it, nothing is dearer
//! than reflected inertia, and energy, momentum, modes and derivatives are right.

use super::axis::{AboutZ, Armature, Axis};
use super::link::Link;
use super::number::{Number, apply, triple, values};
use super::turns::Offset;
use crate::error::checks::{finite, not_negative};
use crate::error::{Error, Fault};
use crate::lift::lift;
use crate::relation::Absent;
use crate::scalar::Scalar;

/// A rotor that a hinge turns by gears, with all that its spin does to the bodies on both sides, where
/// [reflected inertia](Axis::geared) counts along the coordinate alone.
///
/// Its axis is parallel to the hinge's. Relative to the link on which it sits it turns n times as fast as the joint, n < 0: the other way
/// round. Mass and inertia of the rotor at rest are part of that link.
///
/// Links that share in a rotor are no bodies by themselves: their moments may be negative, [`System::doubts`](crate::system::System::doubts)
/// may name them, and a station between them tells a torque that counts n I about the axis with the body outboard, as if gears and rotor
/// were there.
///
/// ```
/// use catena::robot::*;
/// let link = Link::<f64>::general(4.0, [0.0, 0.0, 0.2], [[0.06, 0.0, 0.0], [0.0, 0.06, 0.0], [0.0, 0.0, 0.01]]);
/// let (waist, elbow) = (Hinge::level().grounded(), Hinge::at::<0b001>([0.4, 0.0, 0.0]));
/// let plain = System::new(Base::origin(), (waist, link, elbow, link), Free)?;
/// // 0.3 kg·cm², a hundred times as fast as the joint.
/// let (upper, elbow, fore) = Rotor::new(3e-5, 100.0).between(link, elbow, link)?;
/// let arm = System::new(Base::origin(), (waist, upper, elbow, fore), Free)?;
/// let (before, after) = (plain.mass_matrix(&[0.0, 0.3])?, arm.mass_matrix(&[0.0, 0.3])?);
/// // n² I of the elbow, and n I between elbow and waist, which reflected inertia leaves out.
/// assert!((after[1][1] - before[1][1] - 0.3).abs() < 1e-14);
/// assert!((after[1][0] - before[1][0] - 0.003).abs() < 1e-14);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Rotor<T> {
    inertia: T,
    ratio: T,
}

lift!(Rotor { inertia, ratio });

/// A link that may share in rotors: all of its tensor is there.
pub type Sharing<T, const MOMENT: u8 = 7> = Link<T, MOMENT, { 63 | super::link::SHARING }>;

#[allow(clippy::type_complexity)] // links and a joint as they came, but for what they share
impl<T: Scalar> Rotor<T> {
    /// Moment of inertia about its axis (kg·m²), and how many times as fast as the joint it turns.
    pub fn new(inertia: T, ratio: T) -> Self {
        Self { inertia, ratio }
    }

    /// On a link, turned by a hinge between that and another.
    ///
    /// # Errors
    /// What is wrong with the links, the turn of the hinge or the rotor.
    pub fn between<C, const PLACE: u8, L, B, const M: u8, const S: u8, const N: u8, const R: u8>(
        self,
        inboard: Link<T, M, S>,
        hinge: Axis<T, AboutZ, C, PLACE, L, Absent, B>,
        outboard: Link<T, N, R>,
    ) -> Result<(Sharing<T, M>, Axis<T, AboutZ, C, PLACE, L, Self, B>, Sharing<T, N>), Error>
    where
        C: Offset<T>,
    {
        Armature::check(&self).and_then(|()| hinge.offset.check()).map_err(Error::new)?;
        let [o, i] = [T::zero(), T::one()];
        let axis = values(apply(&hinge.offset.rows(), triple([o, o, i])));
        let inboard = inboard.sharing(-self.coupling(), axis).map_err(Error::new)?;
        let (hinge, outboard) = self.on_ground(hinge, outboard)?;
        Ok((inboard, hinge, outboard))
    }

    /// On the ground, or on a base that moves along a given way, turned by a hinge that carries a link.
    ///
    /// # Errors
    /// What is wrong with the link or the rotor.
    pub fn on_ground<C, const PLACE: u8, L, B, const N: u8, const R: u8>(
        self,
        hinge: Axis<T, AboutZ, C, PLACE, L, Absent, B>,
        outboard: Link<T, N, R>,
    ) -> Result<(Axis<T, AboutZ, C, PLACE, L, Self, B>, Sharing<T, N>), Error> {
        Armature::check(&self).map_err(Error::new)?;
        let [o, i] = [T::zero(), T::one()];
        let outboard = outboard.sharing(self.coupling(), [o, o, i]).map_err(Error::new)?;
        Ok((hinge.reflecting(self), outboard))
    }

    /// n I.
    fn coupling(self) -> T {
        self.inertia * self.ratio
    }
}

impl<T: Scalar> Armature<T> for Rotor<T> {
    const ON: bool = true;
    /// What moves with the coordinate alone: (n² − n) I.
    #[inline(always)]
    fn number(self) -> Number<T> {
        Number::of(self.coupling() * (self.ratio - T::one()))
    }
    fn check(&self) -> Result<(), Fault> {
        not_negative("inertia of a rotor", self.inertia)?;
        finite("ratio of a gear", &[self.ratio])
    }
}
