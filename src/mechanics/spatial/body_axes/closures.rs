//! What joints in body axes make of closure forces: columns of a relation are further pairs of force and torque.

use super::axis::{Armature, Axis, Bearing, Mode};
use super::number::{Triple, triple, values};
use super::relation::{Gains, LocalCuts};
use super::standing::{Stand, Standing};
use super::turns::Offset;
use crate::relation::spatial::FullColumn;
use crate::relation::spatial::algebra::dot;
use crate::relation::{Closures, Open};
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use nalgebra::Vector3;

/// What a sweep keeps of a joint: its gains, and the acceleration of its coordinate for each closure force.
#[derive(Clone, Copy)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: serde::Serialize, C::Each<T>: serde::Serialize",
        deserialize = "T: serde::Deserialize<'de>, C::Each<T>: serde::Deserialize<'de>"
    ))
)]
pub struct ClosedGains<T: Copy, C: Closures = Open> {
    /// Gains of the joint.
    pub gains: Gains<T>,
    /// Acceleration of the coordinate for each closure force.
    pub per_closure: C::Each<T>,
}

impl<T: Scalar, C: Closures> ClosedGains<T, C> {
    /// Gains that no closure force moves.
    pub fn unmoved(gains: Gains<T>) -> Self {
        Self { gains, per_closure: C::each(|_| T::zero()) }
    }
}

/// A force and torque as three numbers each.
#[inline(always)]
fn pair<T: Scalar>([force, torque]: [Triple<T>; 2]) -> FullColumn<T> {
    FullColumn { force: Vector3::from(values(force)), torque: Vector3::from(values(torque)) }
}

/// The other side of a joint accelerates by (c, γ) besides.
#[inline(always)]
pub(super) fn accelerated<T: Scalar, C: Closures>(cuts: LocalCuts<T, C>, [c, gamma]: [[T; 3]; 2]) -> LocalCuts<T, C> {
    let (c, gamma) = (Vector3::from(c), Vector3::from(gamma));
    cuts.turned(|w| w, |gap, w| gap - dot(w.force, c) - dot(w.torque, gamma))
}

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>, B: Bearing>
    Axis<T, M, C, PLACE, L, A, B>
{
    /// The coordinate goes, with whole gains U / D, 1 / D, and what accelerates the other side besides; what it does for each force is kept.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn loosed<Q: Closures>(
        cuts: LocalCuts<T, Q>,
        (gains, inverse): (&Gains<T>, T),
        bias: Triple<T>,
        per_closure: &mut Q::Each<T>,
    ) -> LocalCuts<T, Q> {
        let share = |w: FullColumn<T>| if M::TURNS { w.torque.z } else { w.force.z };
        let (linear, angular) = (Vector3::from(gains.linear), Vector3::from(gains.angular));
        let (cuts, row) = cuts.eliminated(-inverse, gains.free, share, |w, _| {
            let share = share(w);
            FullColumn { force: w.force - linear * share, torque: w.torque - angular * share }
        });
        *per_closure = row;
        let (none, bias) = ([T::zero(); 3], values(bias));
        accelerated(cuts, if M::TURNS { [none, [bias[0], bias[1], T::zero()]] } else { [bias, none] })
    }

    /// At the parent's origin, in its axes, from the body's; the joint's place accelerates besides.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn carried_cuts<Q: Closures>(
        &self,
        cuts: LocalCuts<T, Q>,
        stand: Stand<T>,
        swung: Triple<T>,
    ) -> LocalCuts<T, Q> {
        let carried = cuts.mapped(|w| pair(self.carried(stand, [triple(w.force.into()), triple(w.torque.into())])));
        accelerated(carried, [values(swung), [T::zero(); 3]])
    }
}
