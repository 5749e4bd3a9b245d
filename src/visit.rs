//! What walks over a scene do at its bodies, at its joints and where arms leave.

use crate::element::{Coordinates, Posture};
use crate::loading::Loading;
use crate::relation::WrenchOf;
use crate::release::Release;
use crate::scalar::Scalar;
use crate::shape::{Body, PerBody, PerJoint, Shape};
use crate::space::{FrameOf, MovingBody, Space};
pub use crate::walks::look::look;
use crate::walks::posed::travel_posed;
use crate::walks::travel::{show, travel};
use num_traits::Zero;

/// A visitor of [`travel`](crate::walks::travel::travel).
pub trait Visit<S: Space> {
    /// Entry written for each body.
    type OnBody: Copy + 'static;
    /// Entry written for each joint.
    type InJoint: Copy + 'static;

    /// Meets a body.
    fn body(&mut self, body: &S::BodyMotion) -> Self::OnBody;
    /// Meets a body, for those who want to know what it is.
    #[inline(always)]
    fn body_with<B: Body<S>>(&mut self, motion: &S::BodyMotion) -> Self::OnBody {
        self.body(motion)
    }
    /// Meets a joint.
    fn joint(&mut self, joint: &S::JointMotion) -> Self::InJoint;
    /// Meets a joint, for those who want to know what it lets move.
    #[inline(always)]
    fn joint_with(&mut self, joint: &S::JointMotion, release: impl Fn() -> Release<S>) -> Self::InJoint {
        let _ = release;
        self.joint(joint)
    }

    /// Meets what closes a loop: a joint too.
    fn closing(&mut self, closed: &Closed<S>) -> Self::InJoint {
        self.joint(&closed.joint)
    }

    /// Leaves the chain for an arm of it.
    fn enter_arm(&mut self) {}
    /// Comes back to where that arm began.
    fn leave_arm(&mut self) {}
}

/// What meets the bodies and joints of a scene and writes no entries. It is met through a table of functions, so that a walk is compiled
/// once for all of them: these are readings, which no sweep waits for.
pub trait Watch<S: Space> {
    /// Meets a body.
    fn body(&mut self, body: &S::BodyMotion) {
        let _ = body;
    }
    /// Meets a joint.
    fn joint(&mut self, joint: &S::JointMotion) {
        let _ = joint;
    }
    /// Meets a joint, for those who want to know what it lets move.
    fn joint_with(&mut self, joint: &S::JointMotion, release: &dyn Fn() -> Release<S>) {
        let _ = release;
        self.joint(joint);
    }
    /// Meets what closes a loop: a joint too.
    fn closing(&mut self, closed: &Closed<S>) {
        self.joint(&closed.joint);
    }
    /// Leaves the chain for an arm of it.
    fn enter_arm(&mut self) {}
    /// Comes back to where that arm began.
    fn leave_arm(&mut self) {}
}

/// A visitor that is wanted back.
impl<S: Space, V: Visit<S>> Visit<S> for &mut V {
    type OnBody = V::OnBody;
    type InJoint = V::InJoint;

    #[inline(always)]
    fn body(&mut self, body: &S::BodyMotion) -> V::OnBody {
        (**self).body(body)
    }
    #[inline(always)]
    fn body_with<B: Body<S>>(&mut self, motion: &S::BodyMotion) -> V::OnBody {
        (**self).body_with::<B>(motion)
    }
    #[inline(always)]
    fn joint(&mut self, joint: &S::JointMotion) -> V::InJoint {
        (**self).joint(joint)
    }
    #[inline(always)]
    fn joint_with(&mut self, joint: &S::JointMotion, release: impl Fn() -> Release<S>) -> V::InJoint {
        (**self).joint_with(joint, release)
    }
    #[inline(always)]
    fn closing(&mut self, closed: &Closed<S>) -> V::InJoint {
        (**self).closing(closed)
    }
    #[inline(always)]
    fn enter_arm(&mut self) {
        (**self).enter_arm();
    }
    #[inline(always)]
    fn leave_arm(&mut self) {
        (**self).leave_arm();
    }
}

/// A joint that closes a loop.
pub struct Closed<S: Space> {
    /// The joint, from the side arm to the main one.
    pub joint: S::JointMotion,
    /// The force and torque that the joint passes on.
    pub internal: WrenchOf<S>,
    /// Number of conditions that the joint imposes.
    #[cfg_attr(not(feature = "alloc"), allow(dead_code))] // read where there is an allocator
    pub conditions: usize,
    /// Residuals of these conditions, in place and in velocity; the numbers after them are zero.
    pub residual: [S::Numbers; 2],
}

/// A gatherer of [`gather`](crate::walks::gather::gather): internal forces that add up from the tips to the root, for example.
pub trait Gather {
    /// What the gatherer reads or writes of each body and joint.
    type Entry: Copy + 'static;
    /// What the gatherer carries inward.
    type Carried: Copy;

    /// Meets a body or a joint, with what comes from its outboard side; gives what goes on inward.
    fn meet(&mut self, entry: &mut Self::Entry, outer: Self::Carried) -> Self::Carried;
    /// What comes from beyond the tip of an arm.
    fn beyond_arm(&mut self) -> Self::Carried;
    /// What comes from the other side of what closes a loop.
    fn opposite(&mut self, closing: Self::Carried) -> Self::Carried;
    /// What goes on inward where an arm joins the chain.
    fn join(&mut self, chain: Self::Carried, arm: Self::Carried) -> Self::Carried;
}

/// What is to be corrected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Positions.
    Place,
    /// Rates.
    Velocity,
}

/// The last body of a chain that has mass: what lies beyond it is part of it.
pub(crate) fn last_body<S: Space, E: Shape<S>>(
    chain: &E,
    ground: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
) -> Option<S::BodyMotion> {
    let mut last = Last::<S> { arms: 0, body: None };
    show(chain, ground, motion, &mut last);
    last.body
}

/// Keeps the last body that is not part of an arm.
struct Last<S: Space> {
    /// How many arms deep the walk is.
    arms: usize,
    body: Option<S::BodyMotion>,
}

impl<S: Space> Watch<S> for Last<S> {
    fn body(&mut self, body: &S::BodyMotion) {
        if self.arms == 0 && body.mass().real() > Zero::zero() {
            self.body = Some(*body);
        }
    }
    fn enter_arm(&mut self) {
        self.arms += 1;
    }
    fn leave_arm(&mut self) {
        self.arms -= 1;
    }
}

/// What loads have to see of a whole scene first.
pub(crate) fn survey<S: Space, E: Shape<S>, L: Loading<S>>(
    chain: &E,
    ground: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    loads: &L,
) -> L::Seen {
    surveyed(chain, loads, |surveyor, (bodies, joints)| {
        travel(chain, ground, motion, surveyor, bodies, joints);
    })
}

/// What loads have to see of a whole scene first, where bodies stand as a posture says.
pub(crate) fn survey_posed<S: Space, E: Shape<S>, L: Loading<S>>(
    chain: &E,
    ground: FrameOf<S>,
    posture: Posture<'_, S, E>,
    motion: Coordinates<'_, S, E>,
    loads: &L,
) -> L::Seen {
    surveyed(chain, loads, |surveyor, (bodies, joints)| {
        travel_posed(chain, ground, posture, motion, surveyor, bodies, joints);
    })
}

/// What loads see of a scene by a way to travel through it.
#[cfg_attr(optimised, inline(always))]
fn surveyed<S: Space, E: Shape<S>, L: Loading<S>>(
    chain: &E,
    loads: &L,
    travel: impl FnOnce(&mut Surveyor<'_, S, L>, (&mut E::Store<PerBody<()>>, &mut E::Store<PerJoint<()>>)),
) -> L::Seen {
    let mut surveyor = Surveyor { loads, seen: loads.unseen(), body: 0 };
    // A constant, so that a compiler does not even look at what follows where there is nothing to see.
    if const { L::SURVEYS } {
        travel(&mut surveyor, (&mut chain.store::<PerBody<()>>(()), &mut chain.store::<PerJoint<()>>(())));
    }
    surveyor.seen
}

/// Lets loads see each body.
struct Surveyor<'a, S: Space, L: Loading<S>> {
    loads: &'a L,
    seen: L::Seen,
    body: usize,
}

impl<S: Space, L: Loading<S>> Visit<S> for Surveyor<'_, S, L> {
    type OnBody = ();
    type InJoint = ();

    #[cfg_attr(optimised, inline(always))]
    fn body(&mut self, body: &S::BodyMotion) {
        self.loads.survey(&mut self.seen, self.body, body);
        self.body += 1;
    }
    fn joint(&mut self, _: &S::JointMotion) {}
}
