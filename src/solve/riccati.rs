//! The Riccati sweep: a scene's accelerations in one walk inward and one outward.
//!
//! Symmetric at acceleration level, so one triangle of S is stored and no pivot is ever needed: every pivot is the inertia
//! of what lies outboard about a joint.

use crate::element::{Applied, Condense, Coordinates, Element, Loading, Posture, RealOf, Space, Visit};
use crate::relation::Part;

/// Room for the sweeps of one scene: reused, never reallocated.
#[derive(Clone)]
pub struct Workspace<S: Space, E: Element<S>, L: Loading<S>> {
    cosine: E::PerBody<S::Cosine>,
    sine: E::PerBody<S::Sine>,
    spin: E::PerBody<S::Spin>,
    on_bodies: E::PerBody<L::OnBody>,
    in_joints: E::PerJoint<L::InJoint>,
    pub(crate) kept: E::Kept,
}

impl<S: Space, E: Element<S>, L: Loading<S>> Workspace<S, E, L> {
    /// Room for the sweeps of `chain`.
    pub fn new(chain: &E) -> Self {
        let (cosine, sine, spin) = S::blank();
        let (on_body, in_joint) = L::nothing();
        Self {
            cosine: chain.per_body(cosine),
            sine: chain.per_body(sine),
            spin: chain.per_body(spin),
            on_bodies: chain.per_body(on_body),
            in_joints: chain.per_joint(in_joint),
            kept: chain.kept(),
        }
    }
}

/// One sweep: the accelerations of all joint coordinates, from their positions and rates.
///
/// `ground` is the motion of the ground at the root, `tip` the relation that the last element meets. Gravity enters as an
/// acceleration of the ground: the sweep takes place in a frame that falls freely.
#[inline]
#[allow(clippy::too_many_arguments)] // the data flow of the method, one value each
pub fn sweep<S: Space, E, L, R>(
    chain: &E,
    ground: &S::Frame,
    gravity: S::Vector,
    tip: R,
    loads: &L,
    time: RealOf<S>,
    position: &E::Position,
    rate: &E::Rate,
    workspace: &mut Workspace<S, E, L>,
    acceleration: &mut E::Rate,
) where
    E: Condense<S, R, L>,
    L: Loading<S>,
{
    let Workspace { cosine, sine, spin, on_bodies, in_joints, kept } = workspace;
    chain.orient(position, rate, S::turn(ground), cosine, spin);
    chain.resolve(cosine, sine);
    if L::ON {
        let mut pass = LoadPass { loads, time, body: 0, joint: 0 };
        let motion = Coordinates { position, rate, acceleration };
        chain.travel(*ground, motion, &mut pass, on_bodies, in_joints);
    }
    let posture = Posture { cosine, sine, spin };
    chain.condense(tip, posture, Applied { on_bodies, in_joints }, kept);
    chain.recover(S::falling(ground, gravity), posture, kept, acceleration);
}

/// Evaluates the loads, body by body and joint by joint.
struct LoadPass<'a, S: Space, L> {
    loads: &'a L,
    time: RealOf<S>,
    body: usize,
    joint: usize,
}

impl<S: Space, L: Loading<S>> Visit<S> for LoadPass<'_, S, L> {
    type OnBody = L::OnBody;
    type InJoint = L::InJoint;

    #[inline(always)]
    fn body(&mut self, motion: &S::BodyMotion) -> L::OnBody {
        let load = self.loads.on_body(self.time, self.body, motion);
        self.body += 1;
        load
    }
    #[inline(always)]
    fn joint(&mut self, motion: &S::JointMotion) -> L::InJoint {
        let torque = self.loads.in_joint(self.time, self.joint, motion);
        self.joint += 1;
        torque
    }
}

/// The outermost body or joint (counted together from the root) with a load that is not finite.
pub(crate) fn broken_load<S: Space, E: Element<S>, L: Loading<S>>(
    chain: &E,
    ground: &S::Frame,
    loads: &L,
    time: RealOf<S>,
    motion: Coordinates<'_, S, E>,
) -> Option<usize> {
    let mut check = LoadCheck { pass: LoadPass { loads, time, body: 0, joint: 0 }, broken: None };
    chain.travel(*ground, motion, &mut check, &mut chain.per_body(()), &mut chain.per_joint(()));
    check.broken
}

struct LoadCheck<'a, S: Space, L> {
    pass: LoadPass<'a, S, L>,
    broken: Option<usize>,
}

impl<S: Space, L: Loading<S>> LoadCheck<'_, S, L> {
    fn note(&mut self, finite: bool) {
        if !finite {
            self.broken = Some(self.pass.body + self.pass.joint - 1);
        }
    }
}

impl<S: Space, L: Loading<S>> Visit<S> for LoadCheck<'_, S, L> {
    type OnBody = ();
    type InJoint = ();

    fn body(&mut self, motion: &S::BodyMotion) {
        let load = self.pass.body(motion);
        self.note(load.is_finite());
    }
    fn joint(&mut self, motion: &S::JointMotion) {
        let torque = self.pass.joint(motion);
        self.note(torque.is_finite());
    }
}
