//! The contract of the costate sweep: the gradient of one number, computed from a whole run, by everything at once.
//!
//! A *costate* x̄ of a quantity x is the derivative of that number, the cost, by x. Accelerations solve R(q, v, a, p) = M a + c − τ = 0.
//! Given the costate λ of accelerations, M w = λ is solved by the elimination that found them, with another right-hand side; w is a
//! *virtual velocity*, and P = w · R the virtual power of all forces, inertial ones included, over it. With a and w held fixed
//!
//! ```text
//! q̄ = −∂P/∂q        v̄ = −∂P/∂v        p̄ = −∂P/∂p        τ̄ = +w
//! ```
//!
//! P is a sum over bodies. Two vectors carried inward say all that outboard bodies have to do with a body: F = ∂P/∂W, the force of plain
//! inverse dynamics, and G = ∂P/∂A, the momentum of the virtual motion, where W and A are the virtual velocity and the acceleration of the
//! station. So there is no division, no sine and no inertia in
//!
//! ```text
//! factor       tip → root   S and e, gains and inverse pivots                       walks::factor
//! burden       tip → root   what loads on bodies add to gains, if there are any     walks::burden
//! reach        root → tip   accelerations                                           walks::reach
//! meet         tip → root   λ through the gains                                     walks::meet
//! stir         root → tip   W; w of each joint; costates of torques                 walks::stir
//! pull back    tip → root   G and F; costates of positions, rates, parameters       walks::pull_back
//! pull loads   tip → root   the same of what loads read, if there are any           walks::pull_loads
//! ```
//!
//! Where springs enter implicitly, M is that of the sweep, with their stiffness, and laws are read apart from the geometry
//! ([`strain`](crate::walks::strain)).
//!
//! These are [selective](crate::shape::Selective) walks: what they do at a body or a joint stands with its physics
//! (`mechanics/planar/adjoint/`, `mechanics/spatial/adjoint/`).

mod body_law;
pub mod by_strut;
pub mod force_elements;
pub mod jets;
pub mod laws;
mod outboard;
mod rigid;
mod space;
pub mod struts;
mod ties;

use crate::element::{Element, Level, Springs};
use crate::ends::Tip;
use crate::loading::EffortOf;
use crate::relation::{Acceleration, AccelerationOf, Additive, Closures, Geometry, Looped, Wrench, WrenchOf};
use crate::shape::{Closing, Ends, Takes};
use crate::space::{Frame, FrameOf, RealOf};
use crate::walks::{Factor, Meet, PullBack, Reach, Stir, Strain};
pub use body_law::{ActsOnBodies, BodyLaw, Burdened, OfLaw, ReversibleLoads, Surveyed, felt_beside};
pub use outboard::{Kind, Outboard};
pub(crate) use rigid::passes;
pub use space::{Costates, LoadCostates, Reversed, VirtualMotion, unless_rows};
pub use ties::Ties;

/// Elements that take all walks of the costate sweep.
pub trait Reversible<S: Reversed, C: Closures, By: Springs<S::Scalar>>:
    Element<S>
    + Takes<S, S::Poses>
    + Takes<S, Factor<C, By>>
    + Takes<S, Reach<S::Scalar, C>>
    + Takes<S, Meet<S::Scalar, C>>
    + Takes<S, Stir<S::Scalar, C>>
    + Takes<S, PullBack>
    + Takes<S, Strain<S::Scalar>>
{
}

impl<S: Reversed, C: Closures, By: Springs<S::Scalar>, E> Reversible<S, C, By> for E where
    E: Element<S>
        + Takes<S, S::Poses>
        + Takes<S, Factor<C, By>>
        + Takes<S, Reach<S::Scalar, C>>
        + Takes<S, Meet<S::Scalar, C>>
        + Takes<S, Stir<S::Scalar, C>>
        + Takes<S, PullBack>
        + Takes<S, Strain<S::Scalar>>
{
}

/// A joint that closes loops: of each of its forces λ a wrench c acts on the end of the side arm, and the opposite on that of the main one.
#[diagnostic::on_unimplemented(
    message = "no gradient of a run goes backward around a loop that `{Self}` closes",
    label = "not a joint that the costate sweep knows to close loops",
    note = "it knows `Pin` and `Weld` of the plane, `Ball`, `Revolute` and `Weld` of space",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait ReversibleClosing<S: Reversed>: Closing<S> {
    /// Keeps what the joint and its costates need of the orientations of both ends.
    #[allow(clippy::too_many_arguments)] // one store each
    fn pose(
        &self,
        side: S::Turn,
        main: S::Turn,
        x: &mut Self::PerAxes<S::X>,
        y: &mut Self::PerAxes<S::Y>,
        p: &mut Self::PerAxes<S::P>,
        q: &mut Self::PerAxes<S::Q>,
    ) {
        self.orient(side, main, x, y, p, q);
    }
    /// What lies beyond the ends of the main arm and of the side arm, under a torque in the joint, of which the pivot may know; and what the
    /// joint passes on but for λ.
    #[allow(clippy::type_complexity)] // three of them
    fn close_off<C: Closures>(
        &self,
        outer: Outboard<S, C>,
        effort: &EffortOf<S>,
        axes: Ends<'_, S, Self>,
        pivot: &mut S::Pivot,
    ) -> (Outboard<S, Looped<C, Self::Closures>>, Outboard<S, Self::Closures>, WrenchOf<S>);
    /// The wrench c of each unit force.
    fn columns(&self, axes: Ends<'_, S, Self>) -> <Self::Closures as Closures>::Each<WrenchOf<S>>;
    /// Adds the costate of the torque in the joint, for virtual velocities of both ends.
    fn of_effort(&self, axes: Ends<'_, S, Self>, ends: [&S::Stirred; 2], sum: &mut EffortOf<S>);
    /// What is carried inward from the ends of the side arm and of the main one, weighed by ν in accelerations and by −λ in virtual velocities,
    /// one against the other, under the torque that the pivot knows of, if it acts; adds to costates of the numbers of the joint.
    fn pulled(
        &self,
        axes: Ends<'_, S, Self>,
        (weights, forces): (&OfEach<S, Self>, &OfEach<S, Self>),
        pivot: Option<&S::Pivot>,
        ends: &S::AtEnds,
        sums: &mut S::OfJoint,
    ) -> [S::Pulled; 2] {
        let _ = (pivot, ends, sums);
        let (columns, still) = (self.columns(axes), Acceleration::zero());
        let [weight, force] = [weights, forces].map(|each| total::<S, Self::Closures>(&columns, each));
        [S::pulled((weight, &still), (force, &still)), S::pulled((-weight, &still), (-force, &still))]
    }
    /// What is carried inward from both ends where their [residual](Closing::residual) has the costates ν; adds to those of the numbers of the
    /// joint.
    fn felt(
        &self,
        axes: Ends<'_, S, Self>,
        weights: &OfEach<S, Self>,
        turns: &[S::Turn; 2],
        level: Level,
        sums: &mut S::OfJoint,
    ) -> [S::Felt; 2];
}

/// One number for each force that closes a loop.
pub type OfEach<S, K> = <<K as Closing<S>>::Closures as Closures>::Each<<S as Geometry>::Scalar>;

/// Σ x c, of wrenches c and a number for each.
pub fn total<S: Reversed, C: Closures>(columns: &C::Each<WrenchOf<S>>, numbers: &C::Each<S::Scalar>) -> WrenchOf<S> {
    let mut sum = Wrench::none();
    C::zip(columns, numbers, |column, number| sum = WrenchOf::<S>::plus_scaled(sum, number, column));
    sum
}

/// One number for each force that holds a tip.
pub type EachOf<S, P> = <<P as Tip<S>>::Closures as Closures>::Each<<S as Geometry>::Scalar>;

/// A tip that nothing holds, or the ground: what is said here of a free one is nothing.
///
/// Each of the forces λ that hold it acts on the last body by a wrench c; the tip accelerates so that c · A is that of the ground.
#[diagnostic::on_unimplemented(
    message = "no gradient of a run goes backward through the tip `{Self}`",
    label = "not a tip that the costate sweep knows",
    note = "it knows `Free`, and `Pinned` and `Clamped`, of space at an attitude that does not move; in the plane `Guided`, in space `Hinged`, at a place that does not move",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait ReversibleTip<S: Reversed>: Tip<S> {
    /// What there is of its relation.
    const KIND: Kind;
    /// Whether nothing holds it, or ground that is known to rest.
    const RESTS: bool = true;

    /// The motion of the ground that holds it.
    fn ground(&self, _: RealOf<S>) -> FrameOf<S> {
        Frame::resting(S::Vector::null())
    }
    /// The wrench c of each unit force.
    fn columns(&self) -> <Self::Closures as Closures>::Each<WrenchOf<S>>;
    /// The numbers it is made of, at a time.
    fn numbers(&self, _: RealOf<S>) -> S::OfTip {
        S::no_tip()
    }
    /// Costates of these numbers, of what they change of the wrenches c in Σ ν c · A − λ c · W.
    fn of_columns(
        &self,
        (weight, a): (&EachOf<S, Self>, &AccelerationOf<S>),
        (force, w): (&EachOf<S, Self>, &AccelerationOf<S>),
    ) -> S::OfTip {
        let _ = (weight, a, force, w);
        S::no_tip()
    }
    /// Derivatives of Σ ν y by these numbers, y being the [residual](Tip::residual) in place, or that in velocity.
    fn of_residual(&self, weight: &EachOf<S, Self>, frame: &FrameOf<S>, level: Level) -> S::OfTip {
        let _ = (weight, frame, level);
        S::no_tip()
    }
    /// The derivative of Σ ν y, in place, by turns of the tip: of Σ ν c where angles are all that is missed.
    fn of_turn(&self, weight: &EachOf<S, Self>, frame: &FrameOf<S>) -> S::Angular {
        let _ = frame;
        total::<S, Self::Closures>(&self.columns(), weight).torque
    }
    /// What is carried inward from a tip whose residual has the costates ν.
    fn felt(&self, weight: &EachOf<S, Self>, frame: &FrameOf<S>, level: Level) -> S::Felt {
        let (sum, none) = (total::<S, Self::Closures>(&self.columns(), weight), Wrench::none());
        match level {
            Level::Place => S::felt(Wrench { torque: self.of_turn(weight, frame), ..sum }, none, &frame.turn),
            Level::Velocity => S::felt(none, sum, &frame.turn),
        }
    }
}
