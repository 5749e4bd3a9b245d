//! Complete kinematics from the root to the tips, shown to a visitor.

use crate::element::Coordinates;
use crate::mirror::Rate;
use crate::relation::{Closures, Wrench};
use crate::release::Release;
use crate::shape::{
    AtBody, AtClosing, AtJoint, Body, Closing, Joint, Mut, Of, Outward, Parallel, PerBody, PerJoint, Positions, Rates,
    Ref, Shape, Slot, Walk, Way,
};
use crate::space::{FrameOf, Space};
use crate::visit::{Closed, Visit, Watch};

/// Walks outward with complete kinematics and lets a visitor (or a reference to one) write an entry for each body and joint; gives the
/// frame of the tip.
#[cfg_attr(optimised, inline(always))]
pub fn travel<S: Space, E: Shape<S>, V: Visit<S>>(
    chain: &E,
    frame: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    visit: V,
    on_bodies: &mut E::Store<PerBody<V::OnBody>>,
    in_joints: &mut E::Store<PerJoint<V::InJoint>>,
) -> FrameOf<S> {
    let Coordinates { position, rate, acceleration } = motion;
    chain.outward(&mut Travel(visit), frame, (position, rate, acceleration, on_bodies, in_joints))
}

/// Shows the motions of bodies and joints to what writes nothing.
pub fn show<S: Space, E: Shape<S>>(
    chain: &E,
    frame: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    watch: &mut dyn Watch<S>,
) -> FrameOf<S> {
    let (bodies, joints) = (&mut chain.store::<PerBody<()>>(()), &mut chain.store::<PerJoint<()>>(()));
    travel(chain, frame, motion, Shown(watch), bodies, joints)
}

/// What writes nothing, as a visitor.
struct Shown<'w, S: Space>(&'w mut dyn Watch<S>);

impl<S: Space> Visit<S> for Shown<'_, S> {
    type OnBody = ();
    type InJoint = ();

    fn body(&mut self, body: &S::BodyMotion) {
        self.0.body(body);
    }
    fn joint(&mut self, joint: &S::JointMotion) {
        self.0.joint(joint);
    }
    fn joint_with(&mut self, joint: &S::JointMotion, release: impl Fn() -> Release<S>) {
        self.0.joint_with(joint, &release);
    }
    fn closing(&mut self, closed: &Closed<S>) {
        self.0.closing(closed);
    }
    fn enter_arm(&mut self) {
        self.0.enter_arm();
    }
    fn leave_arm(&mut self) {
        self.0.leave_arm();
    }
}

/// Shows bodies and joints to a visitor.
struct Travel<V>(V);

impl<S: Space, V: Visit<S>> Walk<S> for Travel<V> {
    type Carried = FrameOf<S>;
    type Stores = (Ref<Positions>, Ref<Rates>, Ref<Rates>, Mut<PerBody<V::OnBody>>, Mut<PerJoint<V::InJoint>>);
}

impl<S: Space, V: Visit<S>> Outward<S> for Travel<V> {
    type In<Y: Way> = Self;

    #[cfg_attr(optimised, inline(always))]
    fn enter<Y: Way, X>(&mut self, go: impl FnOnce(&mut Self) -> X) -> X {
        self.0.enter_arm();
        let out = go(self);
        self.0.leave_arm();
        out
    }
    #[cfg_attr(optimised, inline(always))]
    fn body<B: Body<S>>(
        &mut self,
        body: &B,
        frame: FrameOf<S>,
        (_, _, _, on_body, _): AtBody<'_, S, Self, B>,
    ) -> FrameOf<S> {
        let (motion, outboard) = body.motion(frame);
        *on_body = self.0.body_with::<B>(&motion);
        outboard
    }
    #[cfg_attr(optimised, inline(always))]
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        frame: FrameOf<S>,
        (position, rate, acceleration, _, in_joint): AtJoint<'_, S, Self, J>,
    ) -> FrameOf<S> {
        let (motion, outboard) = joint.motion(frame, position, rate, acceleration);
        *in_joint = self.0.joint_with(&motion, || joint.release(&motion, position, rate));
        outboard
    }
    fn closing<K: Closing<S>>(
        &mut self,
        closing: &K,
        [side, main]: [FrameOf<S>; 2],
        (_, _, internal, _, in_joint): AtClosing<'_, S, Self, K>,
    ) {
        *in_joint = self.0.closing(&Closed {
            joint: closing.joint(&side, &main),
            internal: S::internal(*internal),
            conditions: K::Closures::COUNT,
            residual: closing.residual(&side, &main).map(|residual| padded::<S, K::Closures>(&residual)),
        });
    }
    /// The side arm, with the joint that closes the loop, is an arm to the visitor; the main one is the chain.
    #[cfg_attr(optimised, inline(always))]
    fn parallel<N: Parallel<S>>(&mut self, net: &N, frame: FrameOf<S>, stores: Of<'_, S, Self, N>) -> FrameOf<S> {
        let (main, side, closing) = <Self as Walk<S>>::Stores::fork::<N>(stores);
        let main = net.main_arm().outward(self, frame, main);
        self.0.enter_arm();
        let side = net.side_arm().outward(self, frame, side);
        self.closing(net.closing_joint(), [side, main], closing);
        self.0.leave_arm();
        main
    }
}

/// One number for each closure force, and zeros after them.
fn padded<S: Space, C: Closures>(each: &C::Each<S::Scalar>) -> S::Numbers {
    let (mut numbers, mut k) = (S::numbers(Wrench::none()), 0);
    C::map(each, |x| {
        let mut at = 0;
        numbers.replace(&mut |old| {
            at += 1;
            if at == k + 1 { x } else { old }
        });
        k += 1;
    });
    numbers
}
