//! Taylor series of a scene's motion.

use super::dynamics::Held;
use super::{Dynamics, Elements, PositionOf, RateOf, Runs, System};
use crate::element::{Coordinates, Element, RealOf, Space};
use crate::ends::{ExpandTip, Resting, Root, Tip};
use crate::loading::LoadLaw;
use crate::relation::{Acceleration, AccelerationOf, Closures, Cuts, Geometry, LoopGain, Open, Own, Wrench, WrenchOf};
use crate::scalar::Scalar;
use crate::series::{BorneOf, Expand, ExpandLoad, ExpandLoads, Expandable, Order, Setting};
use crate::shape::{Columns, PerAxes, PerBody, PerJoint, Shape, Takes};
use crate::walks::series::{Articulate, Begin, Push, Recite, SetOut, Swing, Weigh};
use crate::walks::size::sizes;
use crate::walks::travel::travel;
use core::marker::PhantomData;
use num_traits::Zero;

/// What a stepper by Taylor series of order `N` needs of a scene besides.
pub trait SeriesDynamics<L, const N: usize>: Dynamics<L> {
    /// Whether there are loads, which may be others in the next step.
    const LOADED: bool;
    /// Whether efforts are functions of time.
    const OVER_TIME: bool;
    /// Whether all laws along coordinates are linear, and loads on bodies do not depend on motion.
    const LINEAR: bool;

    /// Room for a series.
    type Series;

    /// Room for a series.
    fn series(&self) -> Self::Series;

    /// Begins a series where a motion is, of which so many coefficients are asked for, and finds the accelerations there, its
    /// coefficients of order 0; returns the forces that hold the tip.
    fn begin(
        &self,
        time: <Self::Scalar as Scalar>::Real,
        motion: (&Self::Position, &Self::Rate),
        loads: &L,
        asked: usize,
        series: &mut Self::Series,
        acceleration: &mut Self::Rate,
    ) -> Held<Self, L>;

    /// Finds coefficients of the accelerations from order 1 on, one order after the other, under the loads that the series began with at a time;
    /// gives whether those of loads are finite.
    fn expand(
        &self,
        time: <Self::Scalar as Scalar>::Real,
        loads: &L,
        series: &mut Self::Series,
        accelerations: &mut [Self::Rate],
    ) -> bool;

    /// Whether a series that began at a time is that under these loads, which it is from now on, as far as coefficients are asked for.
    fn agrees(&self, time: <Self::Scalar as Scalar>::Real, loads: &L, asked: usize, series: &mut Self::Series) -> bool;
}

/// The forces that hold a tip.
type EachOf<S, P> = <<P as Tip<S>>::Closures as Closures>::Each<<S as Geometry>::Scalar>;

/// The measure of closures whose pivots all count.
fn unmeasured<S: Space, O: Own>() -> O::Measure<S::Scalar> {
    O::measure(|| O::each(|_| S::Scalar::zero()))
}

/// Room for the series of a scene under loads.
pub struct SeriesRoom<S: Expandable, E: Shape<S>, L: ExpandLoads<S, N>, O: Own, const N: usize> {
    sizes: E::Store<PerAxes<S::Size>>,
    x: E::Store<PerAxes<S::X>>,
    y: E::Store<PerAxes<S::Y>>,
    p: E::Store<PerAxes<S::P>>,
    q: E::Store<PerAxes<S::Q>>,
    axes: E::Store<PerAxes<S::AxesSeries<N>>>,
    joints: E::Store<PerJoint<S::JointSeries<N>>>,
    efforts: E::Store<PerJoint<[L::InJoint; N]>>,
    bodies: E::Store<PerBody<BorneOf<S, L, N>>>,
    columns: E::Store<Columns<O>>,
    /// Of the forces that hold the tip.
    gain: LoopGain<WrenchOf<S>, S::Scalar, Open, O>,
}

impl<S: Expandable, R: Root<S>, C: Element<S>, P: ExpandTip<S>> System<S, R, C, P> {
    /// The walks of one order, for a ground that accelerates like this: one copy for the first one, and one for all others, in which it does not.
    /// Returns the forces that hold the tip.
    #[inline(never)]
    fn coefficients_of<L: ExpandLoads<S, N>, const N: usize, const FIRST: bool>(
        &self,
        k: usize,
        ground: AccelerationOf<S>,
        series: &mut SeriesRoom<S, Elements<S, R, C>, L, P::Closures, N>,
        accelerations: &mut RateOf<S, R, C>,
    ) -> EachOf<S, P>
    where
        Elements<S, R, C>: Expand<S, L, N, P::Closures>,
    {
        let (order, SeriesRoom { axes, joints, efforts, bodies, columns, gain, .. }) = (Order::of(k), series);
        // What holds the tip stands on the same ground.
        let gaps = P::Closures::map(&self.tip.columns(), |w| w.work(&ground));
        let mut push = Push::<S, L, N, P::Closures> { order, gaps, loads: PhantomData };
        self.chain.take(&mut push, S::unpushed(), ((axes, joints, columns), efforts, bodies));
        let gaps = P::Closures::reduced(gain, &push.gaps);
        let forces = P::Closures::forces(gain, |w| w.work(&ground), &(), &gaps);
        let mut swing = Swing::<S, L, N, P::Closures> { order, forces, loads: PhantomData };
        let ground = if FIRST { S::accelerated(ground) } else { S::still() };
        self.chain.take(&mut swing, ground, ((axes, joints, columns), accelerations, bodies));
        forces
    }

    /// Finds so many coefficients more of loads on bodies; gives whether those before are as they were, and whether all are finite.
    fn weigh<L: ExpandLoads<S, N>, const N: usize>(
        &self,
        time: RealOf<S>,
        loads: &L,
        more: usize,
        series: &mut SeriesRoom<S, Elements<S, R, C>, L, P::Closures, N>,
    ) -> (bool, bool) {
        if const { !L::OnBodies::ON } {
            return (true, true);
        }
        let loads = loads.on_bodies();
        let (lifted, at) = (loads.lifted(), Setting { time, gravity: self.gravity });
        let mut walk = Weigh::<S, L, N> { loads, lifted: &lifted, at: &at, more, body: 0, same: true, finite: true };
        self.chain.outward(&mut walk, (), (&mut series.bodies,));
        (walk.same, walk.finite)
    }
}

impl<S, R, C, P, L, const N: usize> SeriesDynamics<L, N> for System<S, R, C, P>
where
    S: Expandable,
    R: Resting<S>,
    C: Element<S>,
    P: ExpandTip<S>,
    L: ExpandLoads<S, N>,
    Elements<S, R, C>: Expand<S, L, N, P::Closures>,
    Self: Runs<L, S, R, C, P>,
{
    const LOADED: bool = L::ON;
    const OVER_TIME: bool = L::OVER_TIME;
    const LINEAR: bool = <Elements<S, R, C> as Shape<S>>::LINEAR && !L::OnBodies::READS;

    type Series = SeriesRoom<S, Elements<S, R, C>, L, P::Closures, N>;

    fn series(&self) -> Self::Series {
        let (chain, (x, y, p, q), (axes, joints)) = (&self.chain, S::blank(), S::untouched::<N>());
        SeriesRoom {
            sizes: sizes(chain),
            x: chain.store::<PerAxes<_>>(x),
            y: chain.store::<PerAxes<_>>(y),
            p: chain.store::<PerAxes<_>>(p),
            q: chain.store::<PerAxes<_>>(q),
            axes: chain.store::<PerAxes<_>>(axes),
            joints: chain.store::<PerJoint<_>>(joints),
            efforts: chain.store::<PerJoint<_>>([L::nothing().1; N]),
            bodies: chain.store::<PerBody<_>>(L::OnBodies::unborne()),
            columns: chain.store::<Columns<_>>(()),
            gain: LoopGain::blank(Wrench::none(), unmeasured::<S, P::Closures>()),
        }
    }

    #[inline(never)]
    fn begin(
        &self,
        time: RealOf<S>,
        (position, rate): (&PositionOf<S, R, C>, &RateOf<S, R, C>),
        loads: &L,
        asked: usize,
        series: &mut Self::Series,
        acceleration: &mut RateOf<S, R, C>,
    ) -> EachOf<S, P> {
        let ground = Root::ground(&self.root, time);
        recite::<S, _, L, N>(&self.chain, time, loads, asked, &mut series.efforts);
        if const { L::OnBodies::ON } {
            let set_out = SetOut { loads: loads.on_bodies(), time, body: 0 };
            let (motion, none) =
                (Coordinates { position, rate, acceleration: rate }, &mut self.chain.store::<PerJoint<()>>(()));
            travel(&self.chain, ground, motion, set_out, &mut series.bodies, none);
        }
        let SeriesRoom { sizes, x, y, p, q, axes, joints, columns, gain, .. } = series;
        self.chain.pose(position, rate, ground.turn, sizes, x, y, p, q);
        self.chain.take(&mut Begin::<N>, S::begun(ground.turn), (x, y, p, (position, rate), (axes, joints)));
        let cuts = Cuts::at_tip(self.tip.columns(), P::Closures::each(|_| S::Scalar::zero()));
        let mut articulate = Articulate::<S, N, P::Closures> { cuts };
        self.chain.take(&mut articulate, S::nothing(), (axes, joints, columns));
        let cuts = Cuts::none().around(P::Closures::each(|_| Wrench::none())).joined(&articulate.cuts, |a, b| a + b);
        (_, *gain) = P::Closures::eliminate(cuts, gain.measure(), WrenchOf::<S>::plus_scaled, |_, _, _| ());
        self.coefficients_of::<_, N, true>(0, ground.falling(self.gravity), series, acceleration)
    }

    #[inline(never)]
    fn expand(
        &self,
        time: RealOf<S>,
        loads: &L,
        series: &mut Self::Series,
        accelerations: &mut [RateOf<S, R, C>],
    ) -> bool {
        let mut finite = true;
        for (k, acceleration) in accelerations.iter_mut().enumerate() {
            finite &= self.weigh(time, loads, 1, series).1;
            self.coefficients_of::<L, N, false>(k + 1, Acceleration::zero(), series, acceleration);
        }
        finite
    }

    fn agrees(&self, time: RealOf<S>, loads: &L, asked: usize, series: &mut Self::Series) -> bool {
        let same = recite::<S, _, L, N>(&self.chain, time, loads, asked, &mut series.efforts);
        self.weigh(time, loads, 0, series).0 && same
    }
}

/// Finds coefficients of efforts, as many as are asked for; gives whether they are those that were there.
fn recite<S: Expandable, E: Shape<S>, L: ExpandLoads<S, N>, const N: usize>(
    chain: &E,
    time: RealOf<S>,
    loads: &L,
    asked: usize,
    efforts: &mut E::Store<PerJoint<[L::InJoint; N]>>,
) -> bool {
    if const { !L::ON } {
        return true;
    }
    let mut recital = Recite::<S, L, N> { loads, time, asked, joint: 0, same: true };
    chain.outward(&mut recital, (), (efforts,));
    recital.same
}

impl<D: SeriesDynamics<L, N>, L, const N: usize> SeriesDynamics<L, N> for &D {
    const LOADED: bool = D::LOADED;
    const OVER_TIME: bool = D::OVER_TIME;
    const LINEAR: bool = D::LINEAR;

    type Series = D::Series;

    fn series(&self) -> Self::Series {
        D::series(self)
    }
    fn begin(
        &self,
        time: <Self::Scalar as Scalar>::Real,
        motion: (&Self::Position, &Self::Rate),
        loads: &L,
        asked: usize,
        series: &mut Self::Series,
        acceleration: &mut Self::Rate,
    ) -> Held<Self, L> {
        D::begin(self, time, motion, loads, asked, series, acceleration)
    }
    fn expand(
        &self,
        time: <Self::Scalar as Scalar>::Real,
        loads: &L,
        series: &mut Self::Series,
        accelerations: &mut [Self::Rate],
    ) -> bool {
        D::expand(self, time, loads, series, accelerations)
    }
    fn agrees(&self, time: <Self::Scalar as Scalar>::Real, loads: &L, asked: usize, series: &mut Self::Series) -> bool {
        D::agrees(self, time, loads, asked, series)
    }
}
