//! Tips that are held: the forces that hold them in a stage.
//!
//! The accelerations of a stage solve M a + c − τ − Γᵀλ = 0, Γ a + γ = target, and costates the same system with other right-hand sides:
//!
//! ```text
//! M w + Γᵀν = λ_a        Γ w = 0        P = w · R + ν · (Γ a + γ − target)
//! ```
//!
//! so that at the tip the costate sweep begins with G = ν and F = −λ. Both are solved by the elimination of the open chain: Γᵀ is a wrench at
//! the tip, which an inward walk begins with, and Λ = Γ M⁻¹ Γᵀ comes of one for each force.

use super::steps::Stage;
use crate::adjoint::{EachOf, Reversed, Reversible, ReversibleTip};
use crate::element::Element;
use crate::ends::Root;
use crate::loading::EffortOf;
use crate::mirror::Rate;
use crate::relation::{Acceleration, AccelerationOf, Additive, Closures, Solvable, Wrench, WrenchOf};
use crate::sensitivity::Gradient;
use crate::shape::{PerAxes, PerBody, PerJoint, Rates, Takes};
use crate::space::FrameOf;
use crate::system::{Elements, System};
use crate::walks::burden::Burden;
use crate::walks::meet::Meet;
use crate::walks::reach::Reach;
use crate::walks::size::sizes;
use crate::walks::stir::Stir;
use num_traits::{One, Zero};

/// Room for walks that find what holds a tip.
pub(super) struct Room<S: Reversed, E: Element<S>> {
    /// A posture besides those of stages.
    pub(super) sizes: E::Store<PerAxes<S::Size>>,
    pub(super) x: E::Store<PerAxes<S::X>>,
    pub(super) y: E::Store<PerAxes<S::Y>>,
    pub(super) p: E::Store<PerAxes<S::P>>,
    pub(super) q: E::Store<PerAxes<S::Q>>,
    zero: E::Rate,
    /// Costates, and what is solved for.
    pub(super) costates: E::Rate,
    pub(super) solved: E::Rate,
    pub(super) correction: E::Rate,
    pub(super) of_position: E::Rate,
    pub(super) of_rate: E::Rate,
    /// Costates of the positions of the last stage, by which the end of the step was put back.
    pub(super) of_stage: E::Rate,
    pub(super) on_bodies: E::Store<PerBody<S::OnBody>>,
    pub(super) in_joints: E::Store<PerJoint<S::InJoint>>,
    pub(super) at_bodies: E::Store<PerBody<S::Vector>>,
    pub(super) at_joints: E::Store<PerJoint<S::Vector>>,
    unloaded: E::Store<PerBody<Loaded<S>>>,
    pub(super) efforts: E::Store<PerJoint<EffortOf<S>>>,
}

/// Where a body is, and the wrench on it.
type Loaded<S> = (FrameOf<S>, WrenchOf<S>);

/// Σ ν c.
pub(super) fn wrench<S: Reversed, P: ReversibleTip<S>>(tip: &P, weights: &EachOf<S, P>) -> WrenchOf<S> {
    let mut sum = Wrench::none();
    P::Closures::zip(&tip.columns(), weights, |column, weight| sum = WrenchOf::<S>::plus_scaled(sum, weight, column));
    sum
}

/// c · A for each c.
fn along<S: Reversed, P: ReversibleTip<S>>(tip: &P, acceleration: &AccelerationOf<S>) -> EachOf<S, P> {
    P::Closures::map(&tip.columns(), |column| column.work(acceleration))
}

/// What the costate sweep begins with at a tip weighed by ν and −λ, and what these do to gravity and to the numbers of the tip.
pub(super) fn weigh<S, R, C, P>(
    scene: &System<S, R, C, P>,
    (weight, force): (&EachOf<S, P>, &EachOf<S, P>),
    (reached, still): (AccelerationOf<S>, AccelerationOf<S>),
    stirred: &AccelerationOf<S>,
    gradient: &mut Gradient<S, Elements<S, R, C>>,
) -> S::Pulled
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
{
    let (tip, weights) = (scene.tip(), wrench(scene.tip(), weight));
    // The acceleration demanded of the tip is that of the ground.
    gradient.gravity = gradient.gravity - weights.force;
    let against = Acceleration { linear: reached.linear - still.linear, angular: reached.angular - still.angular };
    add(&mut gradient.tip, tip.of_columns((weight, &against), (force, stirred)));
    P::pulled(weights, wrench(tip, force))
}

/// Adds up.
pub(super) fn add<T: Additive, const K: usize>(sums: &mut [T; K], more: [T; K]) {
    sums.iter_mut().zip(more).for_each(|(sum, more)| *sum = *sum + more);
}

impl<S: Reversed, E: Reversible<S>> Room<S, E> {
    pub(super) fn new(elements: &E, ground: FrameOf<S>) -> Self {
        let ((x, y, p, q), (on_body, in_joint)) = (S::blank(), S::untouched());
        let zero = elements.store::<Rates>(());
        Self {
            sizes: sizes(elements),
            x: elements.store::<PerAxes<_>>(x),
            y: elements.store::<PerAxes<_>>(y),
            p: elements.store::<PerAxes<_>>(p),
            q: elements.store::<PerAxes<_>>(q),
            costates: zero.clone(),
            solved: zero.clone(),
            correction: zero.clone(),
            of_position: zero.clone(),
            of_rate: zero.clone(),
            of_stage: zero.clone(),
            zero,
            on_bodies: elements.store::<PerBody<_>>(on_body),
            in_joints: elements.store::<PerJoint<_>>(in_joint),
            at_bodies: elements.store::<PerBody<_>>(S::Vector::null()),
            at_joints: elements.store::<PerJoint<_>>(S::Vector::null()),
            unloaded: elements.store::<PerBody<_>>((ground, Wrench::none())),
            efforts: elements.store::<PerJoint<_>>(EffortOf::<S>::null()),
        }
    }

    /// Solves M w = λ for the costates in `solved`, less a wrench at the tip; gives W and w of the tip.
    pub(super) fn stir<P: ReversibleTip<S>>(
        &mut self,
        elements: &E,
        ground: &FrameOf<S>,
        stage: &Stage<S, E, P::Closures>,
        wrench: WrenchOf<S>,
    ) -> AccelerationOf<S> {
        let Stage { x, y, p, q, kept, pivots, .. } = stage;
        let Self { zero, solved, correction, on_bodies, in_joints, efforts, .. } = self;
        elements.take(&mut Meet, wrench, (x, y, p, q, kept, pivots, &mut *solved));
        let stores = (x, y, p, q, kept, (&*zero, &*correction, &mut *solved), (on_bodies, in_joints), efforts);
        P::stirred(&elements.take(&mut Stir, S::at_ground(ground), stores))
    }

    /// Finds λ of a stage whose tip would accelerate by `reached` without, and the accelerations with it.
    pub(super) fn hold<P: ReversibleTip<S>>(
        &mut self,
        (elements, tip): (&E, &P),
        ground: (&FrameOf<S>, AccelerationOf<S>),
        stage: &mut Stage<S, E, P::Closures>,
        acceleration: &mut E::Rate,
    ) where
        E: Takes<S, Burden>,
    {
        stage.compliance = P::Closures::no_pairs();
        for j in 0..P::Closures::COUNT {
            let mut count = 0;
            let unit: EachOf<S, P> = P::Closures::each(|_| {
                count += 1;
                if count == j + 1 { S::Scalar::one() } else { S::Scalar::zero() }
            });
            self.solved.set(&self.zero);
            let yielded = self.stir::<P>(elements, ground.0, stage, -wrench(tip, &unit));
            let minus = P::Closures::map(&along(tip, &yielded), |x| -x);
            stage.compliance = P::Closures::minus_outer(&stage.compliance, &minus, &unit);
        }
        let (demand, free) = (along(tip, &ground.1), along(tip, &stage.reached));
        let demand = P::Closures::zip(&demand, &free, |demand, free| demand - free);
        stage.force = P::Closures::solve(&stage.compliance, &demand);
        let Stage { x, y, p, q, kept, pivots, at_bodies, at_joints, .. } = stage;
        let beyond = -wrench(tip, &stage.force);
        elements.take(&mut Burden, beyond, (x, y, p, q, &self.unloaded, &mut *kept, pivots));
        let stores = (&*x, &*y, &*p, &*q, &*kept, acceleration, (at_bodies, at_joints));
        stage.reached = elements.take(&mut Reach, ground.1, stores);
    }

    /// ν for the costates in the room, and the wrench at the tip with which an inward walk begins.
    pub(super) fn weights<P: ReversibleTip<S>>(
        &mut self,
        (elements, tip): (&E, &P),
        ground: &FrameOf<S>,
        stage: &Stage<S, E, P::Closures>,
    ) -> (WrenchOf<S>, EachOf<S, P>) {
        self.solved.set(&self.costates);
        let yielded = self.stir::<P>(elements, ground, stage, Wrench::none());
        let weights = P::Closures::solve(&stage.compliance, &along(tip, &yielded));
        (wrench(tip, &weights), weights)
    }
}
