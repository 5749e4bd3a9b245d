//! An instant of a run, and what is read of it.

use crate::element::{Budget, Element, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::observe::{PerBody, Stations};
use crate::system::{Dynamics, Elements, MotionOf, Runs, System};
use core::cell::OnceCell;

/// An instant of a run, to be read.
///
/// Accelerations and forces are those that positions, rates and loads cause. Implicit rules step by others, those of their last
/// iteration: then a sweep finds the true ones, once, for whoever reads them.
pub struct Now<'a, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L> {
    pub(super) system: &'a System<S, R, C, P>,
    pub(super) stepped: &'a MotionOf<S, R, C, P>,
    pub(super) loads: &'a L,
    pub(super) event: bool,
    /// Finds accelerations anew, where those of the method are others.
    pub(super) find: Option<Find<S, R, C, P, L>>,
    pub(super) found: OnceCell<MotionOf<S, R, C, P>>,
}

/// Finds a motion with the accelerations that belong to it.
pub(super) type Find<S, R, C, P, L> = fn(&System<S, R, C, P>, &L, &MotionOf<S, R, C, P>) -> MotionOf<S, R, C, P>;

/// A motion with the accelerations that it causes.
pub(super) fn settled<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L: Loading<S>>(
    system: &System<S, R, C, P>,
    loads: &L,
    stepped: &MotionOf<S, R, C, P>,
) -> MotionOf<S, R, C, P>
where
    System<S, R, C, P>: Runs<L, S, R, C, P>,
{
    let mut found = stepped.clone();
    let (position, rate) = (&stepped.position, &stepped.rate);
    let (workspace, acceleration) = (&mut system.workspace(), &mut found.acceleration);
    found.multipliers = system.accelerations(stepped.time, position, rate, loads, workspace, acceleration);
    found
}

impl<'a, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L: Loading<S>> Now<'a, S, R, C, P, L> {
    /// The scene.
    pub fn system(&self) -> &'a System<S, R, C, P> {
        self.system
    }
    /// Time (s).
    pub fn time(&self) -> RealOf<S> {
        self.stepped.time()
    }
    /// The motion of the joint coordinates.
    pub fn motion(&self) -> &MotionOf<S, R, C, P> {
        match self.find {
            Some(find) => self.found.get_or_init(|| find(self.system, self.loads, self.stepped)),
            None => self.stepped,
        }
    }
    /// The motion as the method has left it, to go on from: positions and rates are the same, accelerations are those of the last
    /// iteration of an implicit rule. Where joints are so stiff that steps do not resolve them, forces are those of welds with these,
    /// while true accelerations let what is left of the iteration shake the joints.
    pub fn stepped(&self) -> &'a MotionOf<S, R, C, P> {
        self.stepped
    }
    /// Whether this instant is an event: the zero of the event function.
    pub fn is_event(&self) -> bool {
        self.event
    }
    /// Orientation of every body, root to tip: in the plane absolute angles (rad).
    pub fn angles(&self) -> PerBody<'a, S, Elements<S, R, C>, S::Angles> {
        self.system.angles_of(self.stepped)
    }
    /// Motion of every body.
    pub fn bodies(&self) -> PerBody<'a, S, Elements<S, R, C>, S::BodyMotion> {
        self.system.body_motions_of(self.motion())
    }
    /// Motion, internal force and torque at every station.
    pub fn stations(&self) -> Stations<'a, S, Elements<S, R, C>> {
        self.system.stations_of(self.motion(), self.loads)
    }
    /// Energy and momentum of bodies and of springs in joints, without that of loads, as of struts.
    pub fn budget(&self) -> Budget<S> {
        self.system.budget_of(self.stepped)
    }
    /// Mechanical energy (J) of bodies and of springs in joints, without that of loads, as of struts.
    pub fn energy(&self) -> S::Scalar {
        self.budget().energy()
    }
}
