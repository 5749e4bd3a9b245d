//! The contract for derivatives through kept gains.
//!
//! A scene over [`Jet`](crate::scalar::Jet)s moves with values and columns of derivatives. To send all of it through a sweep would
//! differentiate the inertia of what lies outboard, and every elimination. But accelerations q̈ solve R(q, q̇, q̈) = 0, the
//! residuals of inverse dynamics in the joints, so that dq̈ = −(∂R/∂q̈)⁻¹ dR with dR taken at fixed q̈. This dR is local, a few products
//! a body, and (∂R/∂q̈)⁻¹ is a sweep with other right-hand sides through gains that are already there: no division, no sine. The walks
//! are
//!
//! ```text
//! pose      root → tip   as in a sweep of plain numbers                            Element::pose
//! factor    tip → root   F = S p + e, and one number more kept for each pivot      Sensitive::factor
//! vary      root → tip   accelerations; columns of p at fixed q̈                    Sensitive::vary
//! gather    tip → root   columns of residuals, eliminated through the gains        Sensitive::gather
//! answer    root → tip   columns of q̈                                              Sensitive::answer
//! ```
//!
//! All columns of an element are treated in one loop, so that it vectorises; only values are carried in registers.

use crate::element::{Element, Posture, RealOf, Space, SpaceOver};
use crate::loading::EffortOf;
use crate::relation::{Absent, Additive, Full, Geometry, Part, WrenchOf};
use crate::scalar::{Jet, Scalar};
use crate::shape::{PerBody, PerJoint};
use crate::space::FrameOf;

/// A number with derivatives.
pub trait Derived: Scalar {
    /// The number behind it.
    type Number: Scalar<Real = Self::Real>;

    /// The number without derivatives.
    fn plain(self) -> Self::Number;
    /// Whether no derivative is other than zero.
    fn is_constant(self) -> bool;
    /// The number with derivative 1 with respect to seed `k`.
    fn seeded(self, k: usize) -> Self;
}

impl<T: Scalar, const K: usize> Derived for Jet<T, K> {
    type Number = T;

    fn plain(self) -> T {
        self.re
    }
    fn is_constant(self) -> bool {
        self.eps.iter().all(|x| x.is_identical(T::zero()))
    }
    fn seeded(self, k: usize) -> Self {
        Self::seed(self.re, k)
    }
}

/// F = S p + e of what lies outboard, values alone.
pub type RelationOf<S> = Full<<S as Varied>::Plain>;

/// A space of jets.
pub trait Varied:
    SpaceOver<Self::Number, Over = Self::Plain> + Geometry<Scalar: Derived<Number = Self::Number>>
{
    /// The numbers that jets hold.
    type Number: Scalar<Real = RealOf<Self>>;
    /// This space over plain numbers.
    type Plain: Space<Scalar = Self::Number>;
    /// What [`Sensitive::vary`] carries: values and columns of a motion.
    type Outward: Copy;
    /// What [`Sensitive::gather`] carries: values and columns of a force.
    type Inward: Copy;
    /// What [`Sensitive::answer`] carries: columns of an acceleration.
    type Response: Copy;

    /// Where the outward walk begins: the ground, in a frame that falls freely.
    fn ground(frame: &FrameOf<Self>, gravity: Self::Vector) -> Self::Outward;
    /// The force of what lies beyond a free tip.
    fn no_pull() -> Self::Inward;
    /// A ground that does not answer.
    fn stillness() -> Self::Response;
    /// The orientation of a frame, in plain numbers.
    fn plain_turn(frame: &FrameOf<Self>) -> <Self::Plain as Space>::Turn;
    /// Whether the angular acceleration of the ground has derivatives.
    fn ground_turns(frame: &FrameOf<Self>) -> bool;
    /// Adds the force of an arm.
    fn pull(chain: &mut Self::Inward, arm: &Self::Inward);
}

/// What acts in a joint, or [`Absent`].
pub trait Effort<S: Varied>: Part {
    /// The effort as a walk reads it.
    fn effort(self) -> EffortOf<S>;
}

impl<S: Varied> Effort<S> for Absent {
    fn effort(self) -> EffortOf<S> {
        Additive::null()
    }
}

/// Which columns may be other than zero besides those of positions and rates, decided by type.
pub trait Seeds: Copy {
    /// Parameters of elements and ends, gravity among them.
    const PARAMETERS: bool;
    /// Whether there are loads.
    const LOADS: bool;
}

/// Columns of parameters too, or of positions and rates alone; with loads or without.
#[derive(Clone, Copy, Debug)]
pub struct Columns<const PARAMETERS: bool, const LOADS: bool>;

impl<const PARAMETERS: bool, const LOADS: bool> Seeds for Columns<PARAMETERS, LOADS> {
    const PARAMETERS: bool = PARAMETERS;
    const LOADS: bool = LOADS;
}

/// An element over jets whose derivatives go through kept gains.
#[diagnostic::on_unimplemented(
    message = "derivatives do not go through the gains of `{Self}`",
    label = "no derivatives through gains here",
    note = "run the same scene over jets or dual numbers by the rule itself, without `through_gains`"
)]
pub trait Sensitive<S: Varied>: Element<S> {
    /// This element over plain numbers.
    type Plain: Element<S::Plain>;
    /// What the walks keep.
    type Room: Clone;

    /// Room for what the walks keep.
    fn room(&self) -> Self::Room;

    /// Plain coordinates of coordinates over jets.
    fn read(
        position: &Self::Position,
        rate: &Self::Rate,
        plain_position: &mut <Self::Plain as Element<S::Plain>>::Position,
        plain_rate: &mut <Self::Plain as Element<S::Plain>>::Rate,
    );

    /// Keeps loads.
    fn load(
        &self,
        on_bodies: &Self::Store<PerBody<WrenchOf<S>>>,
        in_joints: &Self::Store<PerJoint<EffortOf<S>>>,
        store: &mut Self::Room,
    );

    /// Condenses the values of what lies outboard, and keeps gains.
    fn factor<N: Seeds>(&self, at: At<'_, S, Self>, outer: RelationOf<S>, store: &mut Self::Room) -> RelationOf<S>;

    /// Recovers the values of accelerations, and carries columns of the motion outward as they are at fixed accelerations of the joint
    /// coordinates.
    fn vary<N: Seeds>(
        &self,
        at: At<'_, S, Self>,
        carried: &mut S::Outward,
        store: &mut Self::Room,
        acceleration: &mut Self::Rate,
    );

    /// Carries columns of forces inward, and turns their residuals in joints into columns of their accelerations where the inboard
    /// station stays as it is.
    fn gather<N: Seeds>(
        &self,
        at: At<'_, S, Self>,
        carried: &mut S::Inward,
        store: &mut Self::Room,
        acceleration: &mut Self::Rate,
    );

    /// Adds to these what the inboard station does.
    fn answer(&self, at: At<'_, S, Self>, carried: &mut S::Response, store: &Self::Room, acceleration: &mut Self::Rate);
}

/// Where an element is.
pub struct At<'a, S: Varied, E: Sensitive<S>> {
    /// The element over plain numbers.
    pub plain: &'a E::Plain,
    /// Posture of the element.
    pub posture: Posture<'a, S::Plain, E::Plain>,
    /// Positions of the element's coordinates.
    pub position: &'a E::Position,
    /// Rates of the element's coordinates.
    pub rate: &'a E::Rate,
}

impl<S: Varied, E: Sensitive<S>> Clone for At<'_, S, E> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<S: Varied, E: Sensitive<S>> Copy for At<'_, S, E> {}
