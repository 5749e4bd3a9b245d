//! Taylor series of a scene's motion.

use super::dynamics::Held;
use super::{Dynamics, Elements, PositionOf, RateOf, Runs, System};
use crate::element::{Element, RealOf, Space};
use crate::ends::{ExpandTip, Resting, Root, Tip};
use crate::relation::{
    Acceleration, AccelerationOf, Closures, Cuts, Geometry, LoopGain, Open, Own, Part, Wrench, WrenchOf,
};
use crate::scalar::Scalar;
use crate::series::{Expand, ExpandLoads, Expandable, Order};
use crate::shape::{Columns, PerAxes, PerJoint, Shape, Takes};
use crate::walks::series::{Articulate, Begin, Push, Recite, Swing};
use crate::walks::size::sizes;
use core::marker::PhantomData;
use num_traits::Zero;

/// What a stepper by Taylor series of order `N` needs of a scene besides.
pub trait SeriesDynamics<L, const N: usize>: Dynamics<L> {
    /// Whether there are loads, which may be others in the next step.
    const LOADED: bool;
    /// Whether efforts are functions of time.
    const OVER_TIME: bool;
    /// Whether all laws along coordinates are linear.
    const LINEAR: bool;

    /// Room for a series.
    type Series;

    /// Room for a series.
    fn series(&self) -> Self::Series;

    /// Begins a series where a motion is, under efforts that have been [recited](Self::recite), and finds the accelerations there, its
    /// coefficients of order 0; returns the forces that hold the tip.
    fn begin(
        &self,
        time: <Self::Scalar as Scalar>::Real,
        position: &Self::Position,
        rate: &Self::Rate,
        series: &mut Self::Series,
        acceleration: &mut Self::Rate,
    ) -> Held<Self, L>;

    /// Finds coefficients of the accelerations from order 1 on, one order after the other.
    fn expand(&self, series: &mut Self::Series, accelerations: &mut [Self::Rate]);

    /// Whether the efforts of a series that began at a time are those of these loads, which they are from now on, as far as coefficients are
    /// asked for.
    fn recite(&self, time: <Self::Scalar as Scalar>::Real, loads: &L, asked: usize, series: &mut Self::Series) -> bool;
}

/// The forces that hold a tip.
type EachOf<S, P> = <<P as Tip<S>>::Closures as Closures>::Each<<S as Geometry>::Scalar>;

/// The measure of closures whose pivots all count.
fn unmeasured<S: Space, O: Own>() -> O::Measure<S::Scalar> {
    O::measure(|| O::each(|_| S::Scalar::zero()))
}

/// Room for the series of a scene.
#[derive(Clone)]
pub struct SeriesRoom<S: Expandable, E: Shape<S>, Q: Part, O: Own, const N: usize> {
    sizes: E::Store<PerAxes<S::Size>>,
    x: E::Store<PerAxes<S::X>>,
    y: E::Store<PerAxes<S::Y>>,
    p: E::Store<PerAxes<S::P>>,
    q: E::Store<PerAxes<S::Q>>,
    axes: E::Store<PerAxes<S::AxesSeries<N>>>,
    joints: E::Store<PerJoint<S::JointSeries<N>>>,
    efforts: E::Store<PerJoint<[Q; N]>>,
    columns: E::Store<Columns<O>>,
    /// Of the forces that hold the tip.
    gain: LoopGain<WrenchOf<S>, S::Scalar, Open, O>,
}

impl<S: Expandable, R: Root<S>, C: Element<S>, P: ExpandTip<S>> System<S, R, C, P> {
    /// The walks of one order, for a ground that accelerates like this: one copy for the first one, and one for all others, in which it does not.
    /// Returns the forces that hold the tip.
    #[inline(never)]
    fn coefficients_of<Q: Part, const N: usize, const FIRST: bool>(
        &self,
        k: usize,
        ground: AccelerationOf<S>,
        series: &mut SeriesRoom<S, Elements<S, R, C>, Q, P::Closures, N>,
        accelerations: &mut RateOf<S, R, C>,
    ) -> EachOf<S, P>
    where
        Elements<S, R, C>: Expand<S, Q, N, P::Closures>,
    {
        let (order, SeriesRoom { axes, joints, efforts, columns, gain, .. }) = (Order::of(k), series);
        // What holds the tip stands on the same ground.
        let gaps = P::Closures::map(&self.tip.columns(), |w| w.work(&ground));
        let mut push = Push::<S, Q, N, P::Closures> { order, gaps, efforts: PhantomData };
        self.chain.take(&mut push, S::unpushed(), ((axes, joints, columns), efforts));
        let gaps = P::Closures::reduced(gain, &push.gaps);
        let forces = P::Closures::forces(gain, |w| w.work(&ground), &(), &gaps);
        let mut swing = Swing::<S, N, P::Closures> { order, forces };
        let ground = if FIRST { S::accelerated(ground) } else { S::still() };
        self.chain.take(&mut swing, ground, ((axes, joints, columns), accelerations));
        forces
    }
}

impl<S, R, C, P, L, const N: usize> SeriesDynamics<L, N> for System<S, R, C, P>
where
    S: Expandable,
    R: Resting<S>,
    C: Element<S>,
    P: ExpandTip<S>,
    L: ExpandLoads<S>,
    Elements<S, R, C>: Expand<S, L::InJoint, N, P::Closures>,
    Self: Runs<L, S, R, C, P>,
{
    const LOADED: bool = L::ON;
    const OVER_TIME: bool = L::OVER_TIME;
    const LINEAR: bool = <Elements<S, R, C> as Shape<S>>::LINEAR;

    type Series = SeriesRoom<S, Elements<S, R, C>, L::InJoint, P::Closures, N>;

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
            columns: chain.store::<Columns<_>>(()),
            gain: LoopGain::blank(Wrench::none(), unmeasured::<S, P::Closures>()),
        }
    }

    #[inline(never)]
    fn begin(
        &self,
        time: RealOf<S>,
        position: &PositionOf<S, R, C>,
        rate: &RateOf<S, R, C>,
        series: &mut Self::Series,
        acceleration: &mut RateOf<S, R, C>,
    ) -> EachOf<S, P> {
        let ground = Root::ground(&self.root, time);
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
    fn expand(&self, series: &mut Self::Series, accelerations: &mut [RateOf<S, R, C>]) {
        for (k, acceleration) in accelerations.iter_mut().enumerate() {
            self.coefficients_of::<_, N, false>(k + 1, Acceleration::zero(), series, acceleration);
        }
    }

    fn recite(&self, time: RealOf<S>, loads: &L, asked: usize, series: &mut Self::Series) -> bool {
        let mut recital = Recite::<S, L, N> { loads, time, asked, joint: 0, same: true };
        self.chain.outward(&mut recital, (), (&mut series.efforts,));
        recital.same
    }
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
        position: &Self::Position,
        rate: &Self::Rate,
        series: &mut Self::Series,
        acceleration: &mut Self::Rate,
    ) -> Held<Self, L> {
        D::begin(self, time, position, rate, series, acceleration)
    }
    fn expand(&self, series: &mut Self::Series, accelerations: &mut [Self::Rate]) {
        D::expand(self, series, accelerations);
    }
    fn recite(&self, time: <Self::Scalar as Scalar>::Real, loads: &L, asked: usize, series: &mut Self::Series) -> bool {
        D::recite(self, time, loads, asked, series)
    }
}
