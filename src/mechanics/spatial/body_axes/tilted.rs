//! What lies outboard of where body axes begin, still in those: whatever needs it in inertial axes turns it, and a base that floats does not.

use super::relation::Local;
use crate::relation::spatial::algebra::Columns;
use crate::relation::spatial::{Afloat, Full, FullColumn, Point, Rigid, Spatial};
use crate::relation::{
    AccelerationOf, Carry, Close, Closures, Join, Kind, LoopGain, Looped, Open, Own, Promote, Relation, Settle,
    Solvable, Term, Twisted,
};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// A relation in axes of a body, of which `attitude` holds those in inertial ones.
#[derive(Clone, Copy)]
pub struct Tilted<T: Scalar, C: Closures> {
    local: Local<T, C>,
    attitude: Columns<T>,
}

impl<T: Scalar, C: Closures> Tilted<T, C> {
    /// A relation in axes of a body of an attitude.
    #[inline(always)]
    pub(super) fn new(local: Local<T, C>, attitude: Columns<T>) -> Self {
        Self { local, attitude }
    }

    /// An acceleration in inertial axes, from one in those of the body.
    #[inline(always)]
    fn inertial(&self, p: AccelerationOf<Spatial<T>>) -> AccelerationOf<Spatial<T>> {
        AccelerationOf::<Spatial<T>> { linear: self.attitude.apply(p.linear), angular: self.attitude.apply(p.angular) }
    }
}

impl<T: Scalar, C: Closures> Rigid<T> for Tilted<T, C> {
    type Closures = C;

    #[cfg_attr(optimised, inline(always))]
    fn full(self) -> Full<T, C> {
        self.local.turned(&self.attitude)
    }
    #[cfg_attr(optimised, inline(always))]
    fn afloat_with(self, lumped: T) -> Afloat<T, C> {
        let (acceleration, per_closure, cuts) = self.local.full().afloat_with(lumped);
        let turned = |p| self.inertial(p);
        (turned(acceleration), C::map(&per_closure, turned), cuts.mapped(|w| self.attitude.apply(w)))
    }
    #[cfg_attr(optimised, inline(always))]
    fn afloat_under(self, force: Vector3<T>, torque: Vector3<T>) -> AccelerationOf<Spatial<T>> {
        let [force, torque] = [force, torque].map(|v| self.attitude.transposed(v));
        self.inertial(self.local.full().afloat_under(force, torque))
    }
}

impl<T: Scalar, C: Closures> Relation<Spatial<T>> for Tilted<T, C> {
    type Closures = C;
    type WithMass = Full<T, C>;

    #[inline(always)]
    fn with_mass(self, mass: T) -> Full<T, C> {
        self.full().with_mass(mass)
    }
    #[inline(always)]
    fn carried(self, d: Vector3<T>, centripetal: Vector3<T>) -> Full<T, C> {
        self.full().carried(d, centripetal)
    }
}

impl<T: Scalar, C: Solvable> Close<Spatial<T>, C> for Tilted<T, C> {
    #[inline(always)]
    fn multipliers(&self, root: &AccelerationOf<Spatial<T>>) -> C::Each<T> {
        self.full().multipliers(root)
    }
    #[inline(always)]
    fn compliance(&self) -> C::Pairs<T> {
        self.full().compliance()
    }
}

/// Arms that leave one station of a body have that body's axes.
impl<T: Scalar, C: Closures> Join<Tilted<T, Open>> for Tilted<T, C> {
    type Out = Self;
    #[inline(always)]
    fn join(self, arm: Tilted<T, Open>) -> Self {
        Self { local: self.local.join(arm.local), ..self }
    }
}

/// What joins relations of inertial axes.
macro_rules! joined {
    ($([$($bounds:tt)*] $Chain:ty, $Arm:ty => $Out:ty: |$chain:ident, $arm:ident| $sum:expr);*) => {$(
        impl<T: Scalar, C: Closures, $($bounds)*> Join<$Arm> for $Chain {
            type Out = $Out;
            #[inline(always)]
            fn join(self, $arm: $Arm) -> $Out {
                let $chain = self;
                $sum
            }
        }
    )*};
}
joined!(
    [] Tilted<T, C>, Full<T> => Full<T, C>: |chain, arm| chain.full().join(arm);
    [M: Term<Vector3<T>>] Tilted<T, C>, Point<T, M> => Full<T, C>: |chain, arm| chain.full().join(arm);
    [] Full<T, C>, Tilted<T, Open> => Full<T, C>: |chain, arm| chain.join(arm.full());
    [M: Term<Vector3<T>>] Point<T, M, C>, Tilted<T, Open> => Full<T, C>: |chain, arm| chain.join(arm.full())
);

impl<T: Scalar, C: Closures> Promote<Tilted<T, C>> for Full<T, C> {
    fn promote(lesser: Tilted<T, C>) -> Self {
        lesser.full()
    }
}

impl<T: Scalar, C: Closures, O: Own, K: Kind<Spatial<T>>> Carry<Spatial<T>, O, K> for Tilted<T, C>
where
    Full<T, C>: Carry<Spatial<T>, O, K>,
{
    type Out = <Full<T, C> as Carry<Spatial<T>, O, K>>::Out;
    #[inline(always)]
    fn carry(self, columns: O::Each<K::Column>) -> Self::Out {
        self.full().carry(columns)
    }
}

impl<T: Scalar, C: Closures, N: Term<Vector3<T>>> Twisted<N> for Tilted<T, C> {
    type Out = Full<T, C>;
    #[inline(always)]
    fn twisted(self, torque: N) -> Full<T, C> {
        self.full().twisted(torque)
    }
}

/// What a loop makes of arms of which one begins in body axes, or both.
macro_rules! settled {
    ($([$($bounds:tt)*] $Main:ty, $Side:ty: |$main:ident, $side:ident| $pair:expr);*) => {$(
        impl<T: Scalar, C: Closures, O: Own, $($bounds)*> Settle<FullColumn<T>, T, $Side, C, O> for $Main {
            type Out = Full<T, C>;
            #[inline(always)]
            fn settle(self, $side: $Side, measure: O::Measure<T>) -> (Full<T, C>, LoopGain<FullColumn<T>, T, C, O>) {
                let $main = self;
                let (main, side) = $pair;
                Settle::<FullColumn<T>, T, _, C, O>::settle(main, side, measure)
            }
        }
    )*};
}
settled!(
    [] Tilted<T, Looped<C, O>>, Tilted<T, O>: |main, side| (main.full(), side.full());
    [] Tilted<T, Looped<C, O>>, Full<T, O>: |main, side| (main.full(), side);
    [M: Term<Vector3<T>>] Tilted<T, Looped<C, O>>, Point<T, M, O>: |main, side| (main.full(), side);
    [] Full<T, Looped<C, O>>, Tilted<T, O>: |main, side| (main, side.full());
    [M: Term<Vector3<T>>] Point<T, M, Looped<C, O>>, Tilted<T, O>: |main, side| (main, side.full())
);
