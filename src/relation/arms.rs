//! Relations with the columns of a loop, and their elimination where its arms meet.

use super::{
    Absent, Additive, Closures, Cuts, Empty, Full, Geometry, Join, LoopGain, Looped, Lump, Own, Point, Settle,
    Symmetric, Term, Twisted, VectorSpace, Wrench, WrenchOf,
};
use crate::scalar::Scalar;

/// What the forces of a loop are where it is cut.
pub trait Kind<G: Geometry> {
    /// A column of W.
    type Column: Copy;
}

/// Forces without torques.
#[derive(Clone, Copy, Debug)]
pub struct Forces;

/// Forces and torques.
#[derive(Clone, Copy, Debug)]
pub struct Wrenches;

impl<G: Geometry> Kind<G> for Forces {
    type Column = G::Vector;
}

impl<G: Geometry> Kind<G> for Wrenches {
    type Column = WrenchOf<G>;
}

/// A relation that can carry the columns of a loop which is cut at its station.
pub trait Carry<G: Geometry, O: Own, K: Kind<G>> {
    /// The relation with these columns.
    type Out: Copy;
    /// Adds columns.
    fn carry(self, columns: O::Each<K::Column>) -> Self::Out;
}

impl<G: Geometry, M: Copy, C: Closures, O: Own> Carry<G, O, Forces> for Point<G, M, C> {
    type Out = Point<G, M, Looped<C, O>>;
    #[inline(always)]
    fn carry(self, columns: O::Each<G::Vector>) -> Self::Out {
        let Self { mass, offset, torque, cuts } = self;
        Point { mass, offset, torque, cuts: cuts.around(columns) }
    }
}

impl<G: Geometry, C: Closures, O: Own> Carry<G, O, Wrenches> for Full<G, C> {
    type Out = Full<G, Looped<C, O>>;
    #[inline(always)]
    fn carry(self, columns: O::Each<WrenchOf<G>>) -> Self::Out {
        let Self { linear, coupling, angular, force, torque, cuts } = self;
        Full { linear, coupling, angular, force, torque, cuts: cuts.around(columns) }
    }
}

impl<G: Geometry, C: Closures, O: Own> Carry<G, O, Forces> for Full<G, C> {
    type Out = Full<G, Looped<C, O>>;
    #[inline(always)]
    fn carry(self, columns: O::Each<G::Vector>) -> Self::Out {
        Carry::<G, O, Wrenches>::carry(self, O::map(&columns, Wrench::of_force))
    }
}

impl<G: Geometry, M: Term<G::Angular>, C: Closures, O: Own> Carry<G, O, Wrenches> for Point<G, M, C> {
    type Out = Full<G, Looped<C, O>>;
    #[inline(always)]
    fn carry(self, columns: O::Each<WrenchOf<G>>) -> Self::Out {
        Carry::<G, O, Wrenches>::carry(self.whole(), columns)
    }
}

fn lump<G: Geometry>(mass: G::Scalar) -> Point<G> {
    Point { mass: G::Mass::diagonal(mass), offset: G::Vector::null(), torque: Absent, cuts: Cuts::none() }
}

impl<G: Geometry, O: Own, K: Kind<G>> Carry<G, O, K> for Empty
where
    Point<G>: Carry<G, O, K>,
{
    type Out = <Point<G> as Carry<G, O, K>>::Out;
    #[inline(always)]
    fn carry(self, columns: O::Each<K::Column>) -> Self::Out {
        lump(G::Scalar::null()).carry(columns)
    }
}

impl<T: Scalar, G: Geometry<Scalar = T>, O: Own, K: Kind<G>> Carry<G, O, K> for Lump<T>
where
    Point<G>: Carry<G, O, K>,
{
    type Out = <Point<G> as Carry<G, O, K>>::Out;
    #[inline(always)]
    fn carry(self, columns: O::Each<K::Column>) -> Self::Out {
        lump(self.mass).carry(columns)
    }
}

/// The gain of a loop.
type Gain<G, C, O> = LoopGain<WrenchOf<G>, <G as Geometry>::Scalar, C, O>;

impl<G: Geometry, M: Join<N>, N: Copy, C: Closures, O: Own> Settle<WrenchOf<G>, G::Scalar, Point<G, N, O>, C, O>
    for Point<G, M, Looped<C, O>>
where
    M::Out: Copy,
{
    type Out = Point<G, M::Out, C>;
    #[cfg_attr(optimised, inline(always))]
    fn settle(self, side: Point<G, N, O>, measure: O::Measure<G::Scalar>) -> (Self::Out, Gain<G, C, O>) {
        let mut mass = self.mass + side.mass;
        let mut offset = self.offset + side.offset;
        let torque = self.torque.join(side.torque);
        let (cuts, gain) = O::eliminate(
            self.cuts.joined(&side.cuts, |a, b| a + b),
            measure,
            |v: G::Vector, factor, w| v.plus_scaled(factor, w),
            |w: G::Vector, inverse, gap: G::Scalar| {
                mass = mass.plus_outer(w, w.times(inverse));
                offset = offset.plus_scaled(-gap, w);
            },
        );
        (Point { mass, offset, torque, cuts }, gain.mapped(Wrench::of_force))
    }
}

impl<G: Geometry, C: Closures, O: Own> Settle<WrenchOf<G>, G::Scalar, Full<G, O>, C, O> for Full<G, Looped<C, O>> {
    type Out = Full<G, C>;
    #[cfg_attr(optimised, inline(always))]
    fn settle(self, side: Full<G, O>, measure: O::Measure<G::Scalar>) -> (Full<G, C>, Gain<G, C, O>) {
        let mut linear = self.linear + side.linear;
        let mut coupling = self.coupling + side.coupling;
        let mut angular = self.angular + side.angular;
        let mut force = self.force + side.force;
        let mut torque = self.torque + side.torque;
        let (cuts, gain) = O::eliminate(
            self.cuts.joined(&side.cuts, |a, b| a + b),
            measure,
            Wrench::plus_scaled,
            |w, inverse, gap: G::Scalar| {
                let share = w.torque.times(inverse);
                linear = linear.plus_outer(w.force, w.force.times(inverse));
                coupling = G::plus_outer(coupling, w.force, share);
                angular = angular.plus_outer(w.torque, share);
                force = force.plus_scaled(-gap, w.force);
                torque = torque.plus_scaled(-gap, w.torque);
            },
        );
        (Full { linear, coupling, angular, force, torque, cuts }, gain)
    }
}

impl<G: Geometry, N: Term<G::Angular>, C: Closures, O: Own> Settle<WrenchOf<G>, G::Scalar, Point<G, N, O>, C, O>
    for Full<G, Looped<C, O>>
{
    type Out = Full<G, C>;
    #[inline(always)]
    fn settle(self, side: Point<G, N, O>, measure: O::Measure<G::Scalar>) -> (Full<G, C>, Gain<G, C, O>) {
        self.settle(side.whole(), measure)
    }
}

impl<G: Geometry, M: Term<G::Angular>, C: Closures, O: Own> Settle<WrenchOf<G>, G::Scalar, Full<G, O>, C, O>
    for Point<G, M, Looped<C, O>>
{
    type Out = Full<G, C>;
    #[inline(always)]
    fn settle(self, side: Full<G, O>, measure: O::Measure<G::Scalar>) -> (Full<G, C>, Gain<G, C, O>) {
        self.whole().settle(side, measure)
    }
}

impl<G: Geometry, M: Join<N>, N, C: Closures> Twisted<N> for Point<G, M, C>
where
    M::Out: Copy,
{
    type Out = Point<G, M::Out, C>;
    #[inline(always)]
    fn twisted(self, torque: N) -> Self::Out {
        let Self { mass, offset, torque: own, cuts } = self;
        Point { mass, offset, torque: own.join(torque), cuts }
    }
}

impl<G: Geometry, N: Term<G::Angular>, C: Closures> Twisted<N> for Full<G, C> {
    type Out = Self;
    #[inline(always)]
    fn twisted(self, torque: N) -> Self {
        Self { torque: torque.add_to(self.torque), ..self }
    }
}
