//! Joints with names that close loops, backward: as those without.

use super::Named;
use crate::adjoint::{OfEach, Outboard, Reversed, ReversibleClosing};
use crate::element::Level;
use crate::loading::EffortOf;
use crate::relation::{Closures, Looped, WrenchOf};
use crate::shape::Ends;

impl<S: Reversed, K: ReversibleClosing<S>> ReversibleClosing<S> for Named<K> {
    fn pose(
        &self,
        side: S::Turn,
        main: S::Turn,
        x: &mut K::PerAxes<S::X>,
        y: &mut K::PerAxes<S::Y>,
        p: &mut K::PerAxes<S::P>,
        q: &mut K::PerAxes<S::Q>,
    ) {
        self.item.pose(side, main, x, y, p, q);
    }
    #[cfg_attr(optimised, inline(always))]
    fn close_off<C: Closures>(
        &self,
        outer: Outboard<S, C>,
        effort: &EffortOf<S>,
        axes: Ends<'_, S, Self>,
        pivot: &mut S::Pivot,
    ) -> (Outboard<S, Looped<C, K::Closures>>, Outboard<S, K::Closures>, WrenchOf<S>) {
        self.item.close_off(outer, effort, axes.of_item(), pivot)
    }
    fn columns(&self, axes: Ends<'_, S, Self>) -> <K::Closures as Closures>::Each<WrenchOf<S>> {
        self.item.columns(axes.of_item())
    }
    fn of_effort(&self, axes: Ends<'_, S, Self>, ends: [&S::Stirred; 2], sum: &mut EffortOf<S>) {
        self.item.of_effort(axes.of_item(), ends, sum);
    }
    fn pulled(
        &self,
        axes: Ends<'_, S, Self>,
        forces: (&OfEach<S, K>, &OfEach<S, K>),
        pivot: Option<&S::Pivot>,
        ends: &S::AtEnds,
        sums: &mut S::OfJoint,
    ) -> [S::Pulled; 2] {
        self.item.pulled(axes.of_item(), forces, pivot, ends, sums)
    }
    fn felt(
        &self,
        axes: Ends<'_, S, Self>,
        weights: &OfEach<S, K>,
        turns: &[S::Turn; 2],
        level: Level,
        sums: &mut S::OfJoint,
    ) -> [S::Felt; 2] {
        self.item.felt(axes.of_item(), weights, turns, level, sums)
    }
}
