//! Loads on bodies, of a motion's Taylor series.

use crate::series::{Borne, BorneOf, ExpandLoad, ExpandLoads, Expandable, Setting};
use crate::shape::{AtBody, AtJoint, Body, Joint, Mut, Outward, PerBody, Walk, alike};
use crate::space::RealOf;
use crate::visit::Visit;

/// Finds where loads on bodies set out.
pub struct SetOut<'l, S: Expandable, L, const N: usize> {
    /// What acts on bodies.
    pub loads: &'l L,
    /// At which time (s).
    pub time: RealOf<S>,
    /// The number of the next body.
    pub body: usize,
}

impl<S: Expandable, L: ExpandLoad<S, N>, const N: usize> Visit<S> for SetOut<'_, S, L, N> {
    type OnBody = L::Borne;
    type InJoint = ();

    fn body(&mut self, motion: &S::BodyMotion) -> L::Borne {
        let borne = self.loads.set_out(self.time, self.body, motion);
        self.body += 1;
        borne
    }
    fn joint(&mut self, _: &S::JointMotion) {}
}

/// Finds coefficients of loads on bodies: one more, or those once more that there are.
pub struct Weigh<'l, S: Expandable, L: ExpandLoads<S, N>, const N: usize> {
    /// What acts on bodies.
    pub loads: &'l L::OnBodies,
    /// What acts on bodies, over power series.
    pub lifted: &'l <L::OnBodies as ExpandLoad<S, N>>::Lifted,
    /// Where loads have set out.
    pub at: &'l Setting<S>,
    /// How many coefficients more.
    pub more: usize,
    /// The number of the next body.
    pub body: usize,
    /// Whether all coefficients before were there.
    pub same: bool,
    /// Whether all that it has found are finite.
    pub finite: bool,
}

impl<S: Expandable, L: ExpandLoads<S, N>, const N: usize> Walk<S> for Weigh<'_, S, L, N> {
    type Carried = ();
    type Stores = (Mut<PerBody<BorneOf<S, L, N>>>,);
}

impl<S: Expandable, L: ExpandLoads<S, N>, const N: usize> Outward<S> for Weigh<'_, S, L, N> {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), (borne,): AtBody<'_, S, Self, B>) {
        self.same &= self.loads.go_on(self.lifted, self.at, self.body, self.more, borne);
        self.finite &= borne.is_finite();
        self.body += 1;
    }
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {}
}
