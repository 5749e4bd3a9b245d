//! Tips that are held and loops that are closed: the forces that do it in a stage.
//!
//! The accelerations of a stage solve M a + c − τ − Γᵀλ = 0, Γ a + γ = target, and costates the same system with other right-hand sides:
//!
//! ```text
//! M w + Γᵀν = λ_a        Γ w = 0        P = w · R + ν · (Γ a + γ − target)
//! ```
//!
//! so that where something is held the costate sweep begins with G = ν and F = −λ: at a tip, at the end of the side arm of a loop, and with
//! the opposite at the end of the main arm. Both systems are solved by one elimination, whose relations carry columns for closure forces as
//! those of a sweep do.

use super::GradientOf;
use super::record::Stage;
use crate::adjoint::{BodyLaw, EachOf, Reversed, ReversibleTip, Ties, total};
use crate::element::Element;
use crate::ends::Root;
use crate::loading::EffortOf;
use crate::relation::{Acceleration, AccelerationOf, Additive, Closures, Solvable, Wrench};
use crate::shape::{PerAxes, PerBody, PerClosure, PerJoint, PerLoop, Positions, Rates, Takes};
use crate::space::{FrameOf, Orientation};
use crate::system::System;
use crate::walks::missed::Turns;
use crate::walks::singled::loops;
use crate::walks::size::sizes;
use crate::walks::{Meet, Stir};

/// Room for walks that close what is to be closed.
pub(super) struct Room<S: Reversed, E: Element<S>> {
    /// What postures read of bodies; that of the stage at rest, and that before a correction.
    pub(super) sizes: E::Store<PerAxes<S::Size>>,
    pub(super) rest: Posed<S, E>,
    pub(super) before: Posed<S, E>,
    zero: E::Rate,
    /// Positions at which the stage stands at rest.
    pub(super) still: E::Position,
    /// Costates, and what is solved for.
    pub(super) costates: E::Rate,
    pub(super) solved: E::Rate,
    pub(super) correction: E::Rate,
    pub(super) of_position: E::Rate,
    pub(super) of_rate: E::Rate,
    /// Costates of the positions of the last stage, by which the end of the step was put back.
    pub(super) of_stage: E::Rate,
    /// Costates of its rates, which laws that are not linear read.
    pub(super) of_speed: E::Rate,
    /// Costates of where it was free, where laws that stay there were read.
    pub(super) of_free: (E::Rate, E::Rate),
    pub(super) on_bodies: E::Store<PerBody<S::OnBody>>,
    pub(super) in_joints: E::Store<PerJoint<S::InJoint>>,
    pub(super) at_ends: E::Store<PerLoop<S::AtEnds>>,
    pub(super) at_bodies: E::Store<PerBody<S::Vector>>,
    pub(super) at_joints: E::Store<PerJoint<S::Vector>>,
    pub(super) efforts: E::Store<PerJoint<EffortOf<S>>>,
    /// Number of loops.
    pub(super) loops: usize,
    /// Of loops: nothing; by what their ends miss each other, and how they are turned; by what costates part them; forces of a correction
    /// and of its costate; costates of what they miss.
    pub(super) nothing: E::Store<PerClosure>,
    pub(super) missed: E::Store<PerClosure>,
    pub(super) turns: E::Store<Turns<S>>,
    pub(super) parted: E::Store<PerClosure>,
    pub(super) forces: E::Store<PerClosure>,
    pub(super) of_forces: E::Store<PerClosure>,
    pub(super) weights: E::Store<PerClosure>,
}

/// A posture besides those of stages.
pub(super) struct Posed<S: Reversed, E: Element<S>> {
    pub(super) x: E::Store<PerAxes<S::X>>,
    pub(super) y: E::Store<PerAxes<S::Y>>,
    pub(super) p: E::Store<PerAxes<S::P>>,
    pub(super) q: E::Store<PerAxes<S::Q>>,
}

impl<S: Reversed, E: Element<S>> Posed<S, E> {
    fn new(elements: &E) -> Self {
        let (x, y, p, q) = S::blank();
        Self {
            x: elements.store::<PerAxes<_>>(x),
            y: elements.store::<PerAxes<_>>(y),
            p: elements.store::<PerAxes<_>>(p),
            q: elements.store::<PerAxes<_>>(q),
        }
    }
}

/// What the costate sweep begins with at a tip weighed by ν and −λ, and what these do to gravity and to the numbers of the tip.
pub(super) fn weigh<S, R, C, P, L>(
    scene: &System<S, R, C, P>,
    (weight, force): (&EachOf<S, P>, &EachOf<S, P>),
    (reached, still): (AccelerationOf<S>, AccelerationOf<S>),
    stirred: &AccelerationOf<S>,
    gradient: &mut GradientOf<S, R, C, L>,
) -> S::Pulled
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    L: BodyLaw<S>,
{
    let tip = scene.tip();
    let (columns, of) = (tip.columns(), total::<S, P::Closures>);
    let weights = of(&columns, weight);
    // The acceleration demanded of the tip is that of the ground.
    gradient.gravity = gradient.gravity - weights.force;
    let against = Acceleration { linear: reached.linear - still.linear, angular: reached.angular - still.angular };
    add::<S>(&mut gradient.tip, tip.of_columns((weight, &against), (force, stirred)));
    S::pulled((weights, &against), (of(&columns, force), stirred))
}

/// Adds to the costates of the numbers of a tip.
pub(super) fn add<S: Reversed>(sums: &mut S::OfTip, more: S::OfTip) {
    sums.as_mut().iter_mut().zip(more.as_ref()).for_each(|(sum, more)| *sum += *more);
}

/// −x for each.
pub(super) fn opposite<S: Reversed, C: Closures>(each: &C::Each<S::Scalar>) -> C::Each<S::Scalar> {
    C::map(each, |x| -x)
}

/// Ends of loops that are not turned.
pub(super) fn unturned<S: Reversed, E: Element<S>>(elements: &E) -> E::Store<Turns<S>> {
    elements.store::<PerLoop<_>>([S::Turn::unturned(); 2])
}

impl<S: Reversed, E: Element<S>> Room<S, E> {
    pub(super) fn new(elements: &E) -> Self {
        let (on_body, in_joint, at_ends) = S::untouched();
        let (zero, nothing) = (elements.store::<Rates>(()), elements.store::<PerClosure>(()));
        Self {
            sizes: sizes(elements),
            rest: Posed::new(elements),
            before: Posed::new(elements),
            costates: zero.clone(),
            solved: zero.clone(),
            correction: zero.clone(),
            of_position: zero.clone(),
            of_rate: zero.clone(),
            of_stage: zero.clone(),
            of_speed: zero.clone(),
            of_free: (zero.clone(), zero.clone()),
            zero,
            still: elements.store::<Positions>(()),
            on_bodies: elements.store::<PerBody<_>>(on_body),
            in_joints: elements.store::<PerJoint<_>>(in_joint),
            at_ends: elements.store::<PerLoop<_>>(at_ends),
            at_bodies: elements.store::<PerBody<_>>(S::Vector::null()),
            at_joints: elements.store::<PerJoint<_>>(S::Vector::null()),
            efforts: elements.store::<PerJoint<_>>(EffortOf::<S>::null()),
            loops: loops(elements),
            missed: nothing.clone(),
            turns: unturned::<S, E>(elements),
            parted: nothing.clone(),
            forces: nothing.clone(),
            of_forces: nothing.clone(),
            weights: nothing.clone(),
            nothing,
        }
    }

    /// The inward half of M w + Γᵀν = x̄ for the costates in the room, which they become; gives what a tip that is held needs of −ν for it to
    /// stay.
    pub(super) fn meet<P: ReversibleTip<S>, Y: Ties<S>>(
        &mut self,
        elements: &E,
        stage: &Stage<S, E, P::Closures, Y>,
    ) -> EachOf<S, P>
    where
        E: Takes<S, Meet<S::Scalar, P::Closures>>,
    {
        let Stage { x, y, p, q, kept, pivots, .. } = stage;
        let mut walk = Meet::nothing();
        elements.take(&mut walk, Wrench::none(), (x, y, p, q, kept, pivots, &mut self.costates, &mut self.parted));
        P::Closures::solve(&stage.compliance, &opposite::<S, P::Closures>(&walk.gaps))
    }

    /// The outward half, of what is solved for, by the posture in the room, that of the stage at rest, where these forces act at the tip, and of
    /// the forces of loops or of those of their costates; gives W and w of the tip.
    pub(super) fn stir<P: ReversibleTip<S>, Y: Ties<S>>(
        &mut self,
        elements: &E,
        ground: &FrameOf<S>,
        stage: &Stage<S, E, P::Closures, Y>,
        forces: EachOf<S, P>,
        of_costates: bool,
    ) -> AccelerationOf<S>
    where
        E: Takes<S, Stir<S::Scalar, P::Closures>>,
    {
        let kept = &stage.kept;
        let Self {
            rest: Posed { x, y, p, q },
            zero,
            still,
            solved,
            correction,
            on_bodies,
            in_joints,
            at_ends,
            efforts,
            ..
        } = self;
        let in_loops = if of_costates { &mut self.of_forces } else { &mut self.forces };
        let motion = (&*still, &*zero, &*correction, &mut *solved);
        let stores = (&*x, &*y, &*p, &*q, kept, motion, (on_bodies, in_joints, (in_loops, at_ends)), efforts);
        S::stirred(&elements.take(&mut Stir { forces }, S::at_ground(ground), stores))
    }
}
