//! Loops in space: relations with the columns of a loop, and their elimination where its arms meet.

use super::algebra::{Columns, Symmetric3, add_scaled, zero};
use super::{Empty, Full, FullColumn, Lump, Point, Relation};
use crate::relation::{Absent, Carry, Closures, Cuts, Join, LoopGain, Looped, Own, Settle, Term, Twisted};
use crate::scalar::Scalar;
use nalgebra::Vector3;

impl<T: Scalar, M: Copy, C: Closures, O: Own> Carry<T, O, Vector3<T>> for Point<T, M, C> {
    type Out = Point<T, M, Looped<C, O>>;
    #[inline(always)]
    fn carry(self, columns: O::Each<Vector3<T>>) -> Self::Out {
        let Self { stiffness, offset, torque, cuts } = self;
        Point { stiffness, offset, torque, cuts: cuts.around(columns) }
    }
}

impl<T: Scalar, C: Closures, O: Own> Carry<T, O, FullColumn<T>> for Full<T, C> {
    type Out = Full<T, Looped<C, O>>;
    #[inline(always)]
    fn carry(self, columns: O::Each<FullColumn<T>>) -> Self::Out {
        let Self { linear, coupling, angular, force, torque, cuts } = self;
        Full { linear, coupling, angular, force, torque, cuts: cuts.around(columns) }
    }
}

impl<T: Scalar, C: Closures, O: Own> Carry<T, O, Vector3<T>> for Full<T, C> {
    type Out = Full<T, Looped<C, O>>;
    #[inline(always)]
    fn carry(self, columns: O::Each<Vector3<T>>) -> Self::Out {
        Carry::<T, O, FullColumn<T>>::carry(self, O::map(&columns, FullColumn::of_force))
    }
}

impl<T: Scalar, M: Term<Vector3<T>>, C: Closures, O: Own> Carry<T, O, FullColumn<T>> for Point<T, M, C> {
    type Out = Full<T, Looped<C, O>>;
    #[inline(always)]
    fn carry(self, columns: O::Each<FullColumn<T>>) -> Self::Out {
        Carry::<T, O, FullColumn<T>>::carry(self.carried(zero(), zero()), columns)
    }
}

fn lump<T: Scalar>(mass: T) -> Point<T> {
    Point { stiffness: Symmetric3::diagonal(mass), offset: zero(), torque: Absent, cuts: Cuts::none() }
}

impl<T: Scalar, O: Own, V: Copy> Carry<T, O, V> for Empty
where
    Point<T>: Carry<T, O, V>,
{
    type Out = <Point<T> as Carry<T, O, V>>::Out;
    #[inline(always)]
    fn carry(self, columns: O::Each<V>) -> Self::Out {
        lump(T::zero()).carry(columns)
    }
}

impl<T: Scalar, O: Own, V: Copy> Carry<T, O, V> for Lump<T>
where
    Point<T>: Carry<T, O, V>,
{
    type Out = <Point<T> as Carry<T, O, V>>::Out;
    #[inline(always)]
    fn carry(self, columns: O::Each<V>) -> Self::Out {
        lump(self.mass).carry(columns)
    }
}

impl<T: Scalar> FullColumn<T> {
    /// A force without a torque.
    #[inline(always)]
    pub fn of_force(force: Vector3<T>) -> Self {
        Self { force, torque: zero() }
    }

    /// `self + factor · other`.
    #[inline(always)]
    fn plus(self, factor: T, other: Self) -> Self {
        Self {
            force: add_scaled(self.force, factor, other.force),
            torque: add_scaled(self.torque, factor, other.torque),
        }
    }

    #[inline(always)]
    fn sum(self, other: Self) -> Self {
        Self { force: self.force + other.force, torque: self.torque + other.torque }
    }
}

/// The gain of a loop in space.
type Gain<T, C, O> = LoopGain<FullColumn<T>, T, C, O>;

impl<T: Scalar, M: Join<N>, N: Copy, C: Closures, O: Own> Settle<FullColumn<T>, T, Point<T, N, O>, C, O>
    for Point<T, M, Looped<C, O>>
where
    M::Out: Copy,
{
    type Out = Point<T, M::Out, C>;
    #[inline(always)]
    fn settle(self, side: Point<T, N, O>, measure: O::Measure<T>) -> (Self::Out, Gain<T, C, O>) {
        let mut stiffness = self.stiffness.plus(side.stiffness);
        let mut offset = self.offset + side.offset;
        let torque = self.torque.join(side.torque);
        let (cuts, gain) = O::eliminate(
            self.cuts.joined(&side.cuts, |a, b| a + b),
            measure,
            |v, factor, w| add_scaled(v, factor, w),
            |w, inverse, gap| {
                stiffness = stiffness.plus_outer(w, w * inverse);
                offset = add_scaled(offset, -gap, w);
            },
        );
        (Point { stiffness, offset, torque, cuts }, gain.mapped(FullColumn::of_force))
    }
}

impl<T: Scalar, C: Closures, O: Own> Settle<FullColumn<T>, T, Full<T, O>, C, O> for Full<T, Looped<C, O>> {
    type Out = Full<T, C>;
    #[inline(always)]
    fn settle(self, side: Full<T, O>, measure: O::Measure<T>) -> (Full<T, C>, Gain<T, C, O>) {
        let mut linear = self.linear.plus(side.linear);
        let mut coupling = self.coupling.plus(side.coupling);
        let mut angular = self.angular.plus(side.angular);
        let mut force = self.force + side.force;
        let mut torque = self.torque + side.torque;
        let (cuts, gain) = O::eliminate(
            self.cuts.joined(&side.cuts, FullColumn::sum),
            measure,
            FullColumn::plus,
            |w, inverse, gap| {
                let share = w.torque * inverse;
                linear = linear.plus_outer(w.force, w.force * inverse);
                coupling = coupling.plus(Columns { x: w.force * share.x, y: w.force * share.y, z: w.force * share.z });
                angular = angular.plus_outer(w.torque, share);
                force = add_scaled(force, -gap, w.force);
                torque = add_scaled(torque, -gap, w.torque);
            },
        );
        (Full { linear, coupling, angular, force, torque, cuts }, gain)
    }
}

impl<T: Scalar, N: Term<Vector3<T>>, C: Closures, O: Own> Settle<FullColumn<T>, T, Point<T, N, O>, C, O>
    for Full<T, Looped<C, O>>
{
    type Out = Full<T, C>;
    #[inline(always)]
    fn settle(self, side: Point<T, N, O>, measure: O::Measure<T>) -> (Full<T, C>, Gain<T, C, O>) {
        self.settle(side.carried(zero(), zero()), measure)
    }
}

impl<T: Scalar, M: Term<Vector3<T>>, C: Closures, O: Own> Settle<FullColumn<T>, T, Full<T, O>, C, O>
    for Point<T, M, Looped<C, O>>
{
    type Out = Full<T, C>;
    #[inline(always)]
    fn settle(self, side: Full<T, O>, measure: O::Measure<T>) -> (Full<T, C>, Gain<T, C, O>) {
        self.carried(zero(), zero()).settle(side, measure)
    }
}

impl<T: Scalar, M: Join<N>, N, C: Closures> Twisted<N> for Point<T, M, C>
where
    M::Out: Copy,
{
    type Out = Point<T, M::Out, C>;
    #[inline(always)]
    fn twisted(self, torque: N) -> Self::Out {
        let Self { stiffness, offset, torque: own, cuts } = self;
        Point { stiffness, offset, torque: own.join(torque), cuts }
    }
}

impl<T: Scalar, N: Term<Vector3<T>>, C: Closures> Twisted<N> for Full<T, C> {
    type Out = Self;
    #[inline(always)]
    fn twisted(self, torque: N) -> Self {
        Self { torque: torque.add_to(self.torque), ..self }
    }
}
