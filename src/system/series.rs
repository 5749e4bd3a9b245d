//! Taylor series of a scene's motion.

use super::{Dynamics, Elements, PositionOf, RateOf, Runs, System};
use crate::element::{Element, RealOf};
use crate::ends::{Resting, Root, Unheld};
use crate::relation::{Acceleration, AccelerationOf, Part, Wrench};
use crate::scalar::Scalar;
use crate::series::{Expand, ExpandLoads, Expandable, Order};
use crate::shape::{PerAxes, PerJoint, Shape, Takes};
use crate::walks::series::{Articulate, Begin, Push, Recite, Swing};
use crate::walks::size::sizes;
use core::marker::PhantomData;

/// What a stepper by Taylor series of order `N` needs of a scene besides.
pub trait SeriesDynamics<L, const N: usize>: Dynamics<L> {
    /// Whether there are loads, which may be others in the next step.
    const LOADED: bool;

    /// Room for a series.
    type Series;

    /// Room for a series.
    fn series(&self) -> Self::Series;

    /// Begins a series where a motion is, and finds the accelerations there, its coefficients of order 0.
    fn begin(
        &self,
        time: <Self::Scalar as Scalar>::Real,
        position: &Self::Position,
        rate: &Self::Rate,
        loads: &L,
        series: &mut Self::Series,
        acceleration: &mut Self::Rate,
    );

    /// Finds coefficients of the accelerations from order 1 on, one order after the other.
    fn expand(&self, series: &mut Self::Series, accelerations: &mut [Self::Rate]);

    /// Whether the efforts of a series that began at a time are those of these loads, which they are from now on.
    fn recite(&self, time: <Self::Scalar as Scalar>::Real, loads: &L, series: &mut Self::Series) -> bool;
}

/// Room for the series of a scene.
#[derive(Clone)]
pub struct SeriesRoom<S: Expandable, E: Shape<S>, Q: Part, const N: usize> {
    sizes: E::Store<PerAxes<S::Size>>,
    x: E::Store<PerAxes<S::X>>,
    y: E::Store<PerAxes<S::Y>>,
    p: E::Store<PerAxes<S::P>>,
    q: E::Store<PerAxes<S::Q>>,
    axes: E::Store<PerAxes<S::AxesSeries<N>>>,
    joints: E::Store<PerJoint<S::JointSeries>>,
    efforts: E::Store<PerJoint<[Q; N]>>,
}

impl<S: Expandable, R: Root<S>, C: Element<S>, P> System<S, R, C, P> {
    /// The walks of one order, for a ground that accelerates like this: one copy for all.
    #[inline(never)]
    fn coefficients_of<Q: Part, const N: usize>(
        &self,
        k: usize,
        ground: AccelerationOf<S>,
        series: &mut SeriesRoom<S, Elements<S, R, C>, Q, N>,
        accelerations: &mut RateOf<S, R, C>,
    ) where
        Elements<S, R, C>: Expand<S, Q, N>,
    {
        let (order, SeriesRoom { axes, joints, efforts, .. }) = (Order::of(k), series);
        self.chain.take(&mut Push::<S, Q, N>(order, PhantomData), Wrench::none(), ((axes, joints), efforts));
        self.chain.take(&mut Swing::<S, N>(order), ground, ((axes, joints), accelerations));
    }
}

impl<S, R, C, P, L, const N: usize> SeriesDynamics<L, N> for System<S, R, C, P>
where
    S: Expandable,
    R: Resting<S>,
    C: Element<S>,
    P: Unheld<S>,
    L: ExpandLoads<S>,
    Elements<S, R, C>: Expand<S, L::InJoint, N>,
    Self: Runs<L, S, R, C, P>,
{
    const LOADED: bool = L::ON;

    type Series = SeriesRoom<S, Elements<S, R, C>, L::InJoint, N>;

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
        }
    }

    #[inline(never)]
    fn begin(
        &self,
        time: RealOf<S>,
        position: &PositionOf<S, R, C>,
        rate: &RateOf<S, R, C>,
        loads: &L,
        series: &mut Self::Series,
        acceleration: &mut RateOf<S, R, C>,
    ) {
        let ground = Root::ground(&self.root, time);
        if L::ON {
            SeriesDynamics::<L, N>::recite(self, time, loads, series);
        }
        let SeriesRoom { sizes, x, y, p, q, axes, joints, .. } = series;
        self.chain.pose(position, rate, ground.turn, sizes, x, y, p, q);
        self.chain.take(&mut Begin::<N>, S::begun(ground.turn), (x, y, p, (position, rate), (axes, joints)));
        self.chain.take(&mut Articulate::<N>, S::nothing(), (axes, joints));
        self.coefficients_of(0, ground.falling(self.gravity), series, acceleration);
    }

    #[inline(never)]
    fn expand(&self, series: &mut Self::Series, accelerations: &mut [RateOf<S, R, C>]) {
        for (k, acceleration) in accelerations.iter_mut().enumerate() {
            self.coefficients_of(k + 1, Acceleration::zero(), series, acceleration);
        }
    }

    fn recite(&self, time: RealOf<S>, loads: &L, series: &mut Self::Series) -> bool {
        let mut recital = Recite::<S, L, N> { loads, time, joint: 0, same: true };
        self.chain.outward(&mut recital, (), (&mut series.efforts,));
        recital.same
    }
}

impl<D: SeriesDynamics<L, N>, L, const N: usize> SeriesDynamics<L, N> for &D {
    const LOADED: bool = D::LOADED;

    type Series = D::Series;

    fn series(&self) -> Self::Series {
        D::series(self)
    }
    fn begin(
        &self,
        time: <Self::Scalar as Scalar>::Real,
        position: &Self::Position,
        rate: &Self::Rate,
        loads: &L,
        series: &mut Self::Series,
        acceleration: &mut Self::Rate,
    ) {
        D::begin(self, time, position, rate, loads, series, acceleration);
    }
    fn expand(&self, series: &mut Self::Series, accelerations: &mut [Self::Rate]) {
        D::expand(self, series, accelerations);
    }
    fn recite(&self, time: <Self::Scalar as Scalar>::Real, loads: &L, series: &mut Self::Series) -> bool {
        D::recite(self, time, loads, series)
    }
}
