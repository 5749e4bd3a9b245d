//! One sweep under loads; several, where loads are found with the accelerations.

use super::{Elements, PositionOf, RateOf, System};
use crate::element::{Close, Condense, Coordinates, Element, Loading, Reading, RealOf, Space, Springs, Sweep};
use crate::ends::{Root, Tip};
use crate::loading::couples;
use crate::mirror::Position;
use crate::shape::Kept;
use crate::solve::riccati::{Site, Spring, Workspace, sweep};
use crate::visit::survey;
use crate::walks::copy::copy;

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// One sweep; several, where loads are found with the accelerations.
    #[inline(always)]
    #[allow(clippy::type_complexity)] // the types are those of the scene
    pub(super) fn sweep_under<W: Sweep<S>>(
        &self,
        time: RealOf<S>,
        (position, rate): (&PositionOf<S, R, C>, &RateOf<S, R, C>),
        spring: &Spring<'_, PositionOf<S, R, C>, RateOf<S, R, C>, W::Springs>,
        loads: &W::Loads,
        workspace: &mut Workspace<S, Elements<S, R, C>, W>,
        acceleration: &mut RateOf<S, R, C>,
    ) where
        Elements<S, R, C>: Condense<S, P::Relation, W, Out: Close<S, W::Closures>>,
    {
        // The plain sweep apart from all others: within a closure a compiler makes more instructions of it, up to 1 %.
        if const { !couples::<S, W::Loads>() && !(W::Loads::YIELDS.together() && <W::Springs as Springs<S::Scalar>>::STIFF) }
        {
            sweep(&self.chain, &self.site(time, loads), position, rate, spring, workspace, acceleration);
            return;
        }
        let (stiff, yields) = const { (<W::Springs as Springs<S::Scalar>>::STIFF, W::Loads::YIELDS.together()) };
        // What joints remember of the sweep before, which is none of those that ask what forces cause.
        let remembered = (stiff && (yields || couples::<S, W::Loads>())).then(|| workspace.kept.clone());
        // What couplings move is asked for where motions are put back.
        let mut responses = core::mem::take(&mut workspace.responses);
        let kept = (Self::CLOSED > 0).then_some(&mut responses);
        let mut swept = |loads: &W::Loads, again: bool, acceleration: &mut RateOf<S, R, C>| {
            if again && let Some(remembered) = &remembered {
                copy::<S, _, Kept<W::Closures>>(&self.chain, remembered, &mut workspace.kept);
            }
            let site = Site { again, ..self.site(time, loads) };
            sweep(&self.chain, &site, position, rate, spring, workspace, acceleration);
        };
        let read = PositionOf::<S, R, C>::MODES || Self::CLOSED > 0 || stiff; // joints may remember the last sweep
        // Constants ask, for behind a call of `accelerated` a sweep is compiled otherwise: 1 % more instructions of some.
        if const { W::Loads::YIELDS.together() && <W::Springs as Springs<S::Scalar>>::STIFF } {
            let &Spring { reading, springs, .. } = spring;
            let see = |motion: Coordinates<'_, S, Elements<S, R, C>>| {
                survey(&self.chain, self.root.ground(time), motion, loads)
            };
            let Reading { position: place, rate: speed, acceleration: led } = reading;
            let before = &see(Coordinates { position: place, rate: speed, acceleration: led });
            let see = |a: &RateOf<S, R, C>| see(Coordinates { position, rate: a, acceleration: a });
            let mut yielded = |loads: &W::Loads, again: bool, acceleration: &mut RateOf<S, R, C>| {
                let swept = |loads: &W::Loads, more: bool, a: &mut RateOf<S, R, C>| swept(loads, again || more, a);
                loads.yielded((before, led), springs, see, acceleration, swept);
            };
            if const { couples::<S, W::Loads>() } {
                loads.accelerated(read, kept, acceleration, yielded);
            } else {
                yielded(loads, false, acceleration);
            }
        } else {
            loads.accelerated(read, kept, acceleration, swept);
        }
        workspace.responses = responses;
    }
}
