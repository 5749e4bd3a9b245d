//! What a space says of the costate sweep: what its walks carry and keep.

use crate::element::{Element, Space};
use crate::relation::{AccelerationOf, Additive, WrenchOf};
use crate::scalar::Scalar;
use crate::shape::{PerAxes, Selective, Takes};
use crate::space::FrameOf;

/// A space whose elements know the costate sweep.
pub trait Reversed: VirtualMotion + Costates + LoadCostates {
    /// The inverse of the pivot of a joint.
    type Pivot: Copy + 'static;
    /// The walk by which [`pose`](Self::pose) goes, if it goes by one of its own.
    type Poses: Selective<Self>;

    /// Poses all elements as sweeps do, and stores what only costates read.
    #[allow(clippy::too_many_arguments)] // one store each
    fn pose<E: Element<Self> + Takes<Self, Self::Poses>>(
        elements: &E,
        position: &E::Position,
        rate: &E::Rate,
        turn: Self::Turn,
        sizes: &E::Store<PerAxes<Self::Size>>,
        x: &mut E::Store<PerAxes<Self::X>>,
        y: &mut E::Store<PerAxes<Self::Y>>,
        p: &mut E::Store<PerAxes<Self::P>>,
        q: &mut E::Store<PerAxes<Self::Q>>,
    );

    /// No pivot yet.
    fn no_pivot() -> Self::Pivot;
    /// No derivatives yet.
    fn of_nothing() -> (Self::OfBody, Self::OfNumbers, Self::OfJoint);
}

/// Sums of derivatives by parameters, or, where numbers are rows of Jacobians that know none of these, others that nobody reads: a compiler leaves
/// out what is added to them.
#[inline(always)]
pub fn unless_rows<'s, T: Scalar, X>(sums: &'s mut X, unread: &'s mut X) -> &'s mut X {
    if const { T::ROWS } { unread } else { sums }
}

/// The outward walk of virtual velocities ([`stir`](crate::walks::stir)).
pub trait VirtualMotion: Space {
    /// What is carried outward: virtual velocity, and what turns the body on the inboard side.
    type Stirred: Copy;
    /// What that walk keeps of a body.
    type OnBody: Copy + 'static;
    /// What that walk keeps of a joint.
    type InJoint: Copy + 'static;
    /// What that walk keeps of both ends of a loop.
    type AtEnds: Copy + 'static;

    /// Where the outward walk begins: a ground that does not move virtually.
    fn at_ground(frame: &FrameOf<Self>) -> Self::Stirred;
    /// Nothing has been kept.
    fn untouched() -> (Self::OnBody, Self::InJoint, Self::AtEnds);
    /// What is kept of the ends of the side arm and of the main one.
    fn at_ends(side: &Self::Stirred, main: &Self::Stirred) -> Self::AtEnds;
    /// The virtual velocity W, w of a station.
    fn stirred(stirred: &Self::Stirred) -> AccelerationOf<Self>;
    /// Virtual velocity of the outboard end of a body.
    fn of_body(kept: &Self::OnBody) -> Self::Vector;
    /// Virtual velocity of the outboard side of a joint, where it is another than that of the inboard side.
    fn of_joint(kept: &Self::InJoint) -> Self::Vector;
}

/// The inward walk of costates ([`pull_back`](crate::walks::pull_back)).
pub trait Costates: Space {
    /// What is carried inward: G and F, and what turning all that has been met does to P.
    type Pulled: Additive;
    /// Costates of the base parameters of a body.
    type OfBody: Copy + 'static;
    /// Costates of the numbers of a joint, in the order in which [`Lift`](crate::lift::Lift) meets them.
    type OfJoint: Copy + 'static;

    /// What is carried inward from an end that is weighed by ν in accelerations A, α and by −λ in virtual velocities W, w.
    fn pulled(
        weight: (WrenchOf<Self>, &AccelerationOf<Self>),
        force: (WrenchOf<Self>, &AccelerationOf<Self>),
    ) -> Self::Pulled;
    /// The costates of gravity and of the orientation of the ground, from what is left there.
    fn of_ground(pulled: &Self::Pulled, frame: &FrameOf<Self>) -> (Self::Vector, Self::Angular);
    /// Costates of the base parameters as they are, from sums that left out what depends on the size of the body alone.
    fn complete(size: &Self::Size, sums: &mut Self::OfBody);
}

/// The inward walk of costates of what loads and closures read ([`pull_loads`](crate::walks::pull_loads)).
pub trait LoadCostates: Space {
    /// What loads on bodies and closures carry inward: costates of a station, by what lies outboard.
    type Felt: Additive;
    /// Costates of the numbers of a body that loads and closures read.
    type OfNumbers: Copy + 'static;
    /// Costates of the numbers of a tip, or these numbers: zeros beyond those that it has.
    type OfTip: AsRef<[Self::Scalar]> + AsMut<[Self::Scalar]> + Copy + 'static;

    /// No numbers of a tip.
    fn no_tip() -> Self::OfTip;
    /// Motion of the inboard end of a body.
    fn inboard(motion: &Self::BodyMotion) -> FrameOf<Self>;
    /// What is carried inward from an end whose place and attitude, and whose velocities have these costates.
    fn felt(of_place: WrenchOf<Self>, of_velocity: WrenchOf<Self>, turn: &Self::Turn) -> Self::Felt;
    /// The costates of place and orientation of the ground, from what loads and closures have carried there.
    fn of_place(felt: &Self::Felt, frame: &FrameOf<Self>) -> (Self::Vector, Self::Angular);
}
