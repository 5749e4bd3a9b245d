//! Taylor series of a scene's motion.

use super::{Dynamics, Elements, PositionOf, RateOf, Runs, System};
use crate::element::{Element, Posture, RealOf};
use crate::ends::Root;
use crate::relation::{Acceleration, AccelerationOf, Wrench};
use crate::scalar::Scalar;
use crate::series::{AtRest, Expand, ExpandLoads, Expandable, Instant, Order, Origin, Unheld};
use crate::shape::{PerAxes, Shape};
use crate::walks::size::sizes;

/// What a stepper by Taylor series of order `N` needs of a scene besides.
pub trait SeriesDynamics<L, const N: usize>: Dynamics<L> {
    /// Room for a series.
    type Series;

    /// Room for a series.
    fn series(&self) -> Self::Series;

    /// Begins a series where a motion is, and finds the accelerations there.
    fn begin(
        &self,
        time: <Self::Scalar as Scalar>::Real,
        position: &Self::Position,
        rate: &Self::Rate,
        series: &mut Self::Series,
        acceleration: &mut Self::Rate,
    );

    /// Finds the other coefficients; `scratch` is overwritten.
    fn expand(&self, series: &mut Self::Series, scratch: &mut Self::Rate);

    /// Positions and rates of the series expanded last after a time, from where it began (position, rate, acceleration).
    fn sum(
        &self,
        series: &Self::Series,
        at: Instant<'_, <Self::Scalar as Scalar>::Real>,
        origin: (&Self::Position, &Self::Rate, &Self::Rate),
        position: &mut Self::Position,
        rate: &mut Self::Rate,
    );

    /// Shows the coefficients of each rate, root to tip, from that of the second power of time on.
    fn coefficients(&self, series: &Self::Series, each: &mut impl FnMut(&[Self::Scalar]));
}

/// Room for the series of a scene.
#[derive(Clone)]
pub struct SeriesRoom<S: Expandable, E: Expand<S, N>, const N: usize> {
    sizes: E::Store<PerAxes<S::Size>>,
    x: E::Store<PerAxes<S::X>>,
    y: E::Store<PerAxes<S::Y>>,
    p: E::Store<PerAxes<S::P>>,
    q: E::Store<PerAxes<S::Q>>,
    room: E::Room,
}

impl<S: Expandable, R: Root<S>, C: Element<S>, P> System<S, R, C, P> {
    /// The walks of one order, for a ground that accelerates like this: one copy for all.
    #[inline(never)]
    fn coefficients_of<const N: usize>(
        &self,
        order: &Order<RealOf<S>>,
        ground: AccelerationOf<S>,
        room: &mut <Elements<S, R, C> as Expand<S, N>>::Room,
        acceleration: &mut RateOf<S, R, C>,
    ) where
        Elements<S, R, C>: Expand<S, N>,
    {
        self.chain.push(order, Wrench::none(), room);
        self.chain.swing(order, ground, room, acceleration);
    }
}

impl<S, R, C, P, L, const N: usize> SeriesDynamics<L, N> for System<S, R, C, P>
where
    S: Expandable,
    R: AtRest<S>,
    C: Element<S>,
    P: Unheld<S>,
    L: ExpandLoads<S>,
    Elements<S, R, C>: Expand<S, N>,
    Self: Runs<L, S, R, C, P>,
{
    type Series = SeriesRoom<S, Elements<S, R, C>, N>;

    fn series(&self) -> Self::Series {
        let (chain, (x, y, p, q)) = (&self.chain, S::blank());
        SeriesRoom {
            sizes: sizes(chain),
            x: chain.store::<PerAxes<_>>(x),
            y: chain.store::<PerAxes<_>>(y),
            p: chain.store::<PerAxes<_>>(p),
            q: chain.store::<PerAxes<_>>(q),
            room: chain.room(),
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
    ) {
        let ground = Root::ground(&self.root, time);
        let SeriesRoom { sizes, x, y, p, q, room } = series;
        self.chain.pose(position, rate, ground.turn, sizes, x, y, p, q);
        self.chain.begin(Posture { x, y, p, q }, position, rate, ground.turn, room);
        self.chain.factor(S::nothing(), room);
        self.coefficients_of(&Order::of(0), ground.falling(self.gravity), room, acceleration);
    }

    #[inline(never)]
    fn expand(&self, series: &mut Self::Series, scratch: &mut RateOf<S, R, C>) {
        for k in 1..N {
            self.coefficients_of(&Order::of(k), Acceleration::zero(), &mut series.room, scratch);
        }
    }

    #[inline(never)]
    fn sum(
        &self,
        series: &Self::Series,
        at: Instant<'_, RealOf<S>>,
        (from, v, acceleration): (&PositionOf<S, R, C>, &RateOf<S, R, C>, &RateOf<S, R, C>),
        position: &mut PositionOf<S, R, C>,
        rate: &mut RateOf<S, R, C>,
    ) {
        let origin = Origin { position: from, rate: v, acceleration };
        Elements::<S, R, C>::sum(&series.room, at, origin, position, rate);
    }

    fn coefficients(&self, series: &Self::Series, each: &mut impl FnMut(&[S::Scalar])) {
        Elements::<S, R, C>::show(&series.room, each);
    }
}

impl<D: SeriesDynamics<L, N>, L, const N: usize> SeriesDynamics<L, N> for &D {
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
    ) {
        D::begin(self, time, position, rate, series, acceleration);
    }
    fn expand(&self, series: &mut Self::Series, scratch: &mut Self::Rate) {
        D::expand(self, series, scratch);
    }
    fn sum(
        &self,
        series: &Self::Series,
        at: Instant<'_, <Self::Scalar as Scalar>::Real>,
        origin: (&Self::Position, &Self::Rate, &Self::Rate),
        position: &mut Self::Position,
        rate: &mut Self::Rate,
    ) {
        D::sum(self, series, at, origin, position, rate);
    }
    fn coefficients(&self, series: &Self::Series, each: &mut impl FnMut(&[Self::Scalar])) {
        D::coefficients(self, series, each);
    }
}
