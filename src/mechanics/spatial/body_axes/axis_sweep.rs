//! Joints in body axes in a sweep: what they store on the way outward, what they eliminate on the way inward.

use super::axis::{Armature, Axis, Bearing, Mode};
use super::closures::ClosedGains;
use super::number::{Number, Triple, values};
use super::relation::{Local, LocalCuts, Outboard};
use super::sparse::Sparse;
use super::standing::{Stand, Standing};
use super::turns::Offset;
use crate::element::{Condense, Element, Given, InJoint, Posture, Springs, Sweep};
use crate::mechanics::spatial::spring::PivotRule;
use crate::mechanics::spatial::{Drive, Spatial, Turn};
use crate::relation::spatial::algebra::Columns;
use crate::relation::{Closures, Term};
use crate::scalar::{Scalar, apart};
use crate::spring::SpringLaw;
use nalgebra::Vector3;

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>, B: Bearing> Element<Spatial<T>>
    for Axis<T, M, C, PLACE, L, A, B>
{
    type Position = T;
    type Rate = T;

    const ABSOLUTE: bool = false;

    fn lump(&mut self, _: T) -> T {
        T::zero() // links hand on none
    }
    #[inline(always)]
    fn turned(&self, position: &T, rate: &T, turn: Turn<T>) -> Turn<T> {
        Turn { spin: Vector3::from(self.spun(self.stand(*position), *rate, turn.spin.into())), ..turn }
    }
    #[cfg_attr(optimised, inline(always))]
    fn orient(
        &self,
        position: &T,
        rate: &T,
        turn: Turn<T>,
        x: &mut Columns<T>,
        y: &mut [Vector3<T>; 2],
        _: &mut Vector3<T>,
        _: &mut Vector3<T>,
    ) -> Turn<T> {
        apart::<T, _>(
            #[cfg_attr(optimised, inline(always))]
            || {
                if const { !M::TURNS } {
                    [x.x.x, x.x.y] = self.stand(*position);
                }
                let stand = [x.x.x, x.x.y];
                if const { PLACE & 7 != 0 } {
                    y[0] = Vector3::from(values(self.swung(turn.spin.into())));
                }
                let spin = self.spun(stand, *rate, turn.spin.into());
                let bias = self.bias(stand, *rate, spin);
                (y[1].x, y[1].y) = (bias[0], bias[1]);
                if const { !M::TURNS } {
                    y[1].z = bias[2];
                }
                Turn { spin: Vector3::from(spin), ..turn }
            },
        )
    }
    #[inline(always)]
    fn resolve((): &(), _: &mut Columns<T>, _: &mut [Vector3<T>; 2], _: &mut Vector3<T>, _: &mut Vector3<T>) {}
}

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>, B: Bearing>
    Axis<T, M, C, PLACE, L, A, B>
{
    /// The relation at the parent's origin, from that at the joint's place in axes that are turned by the offset alone, and from what the body's
    /// own says of closure forces.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn handed_on<Q: Closures>(
        &self,
        relation: Sparse<T>,
        cuts: LocalCuts<T, Q>,
        (stand, swung): (Stand<T>, Triple<T>),
    ) -> B::Relation<T, Q> {
        B::relation(
            #[cfg_attr(optimised, inline(always))]
            || self.at_parent(relation, cuts, (stand, swung)),
        )
    }

    /// That, whatever the joint sits on.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn at_parent<Q: Closures>(
        &self,
        relation: Sparse<T>,
        cuts: LocalCuts<T, Q>,
        (stand, swung): (Stand<T>, Triple<T>),
    ) -> Local<T, Q> {
        let (turn, arm, swung) = (self.offset.rows(), self.arm(), Self::known_swung(swung));
        relation.turned(&turn).shifted(arm, swung).dense().cut(self.carried_cuts(cuts, stand, swung))
    }

    /// The relation at the parent's origin with the coordinate gone, which went under an effort against what else adds to the pivot; its gains
    /// are kept, that of its own axis where something `stiffened` the pivot.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn let_go<R: Outboard<T>>(
        &self,
        outer: R,
        effort: T,
        more: Number<T>,
        (stand, [swung, bias]): (Stand<T>, [Triple<T>; 2]),
        (kept, stiffened): (&mut ClosedGains<T, R::Closures>, bool),
    ) -> B::Relation<T, R::Closures> {
        let (relation, cuts, _) = Self::loose(outer, effort, more, bias, (kept, stiffened));
        self.handed_on(relation.at_joint(M::TURNS, stand), cuts, (stand, swung))
    }

    /// The relation at the body's origin with the coordinate gone, and the inverse of its pivot.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn loose<R: Outboard<T>>(
        outer: R,
        effort: T,
        more: Number<T>,
        bias: Triple<T>,
        (kept, stiffened): (&mut ClosedGains<T, R::Closures>, bool),
    ) -> (Sparse<T>, LocalCuts<T, R::Closures>, T) {
        let (relation, cuts) = (outer.sparse(), outer.cuts());
        let (relation, gains, inverse) = if const { M::TURNS } {
            relation.hinged(effort, more, [bias[0].value(), bias[1].value()])
        } else {
            relation.slid(effort, more, values(bias))
        };
        kept.gains.set(gains, M::TURNS, stiffened);
        (relation, Self::loosed(cuts, (&gains, inverse), bias, &mut kept.per_closure), inverse)
    }
}

impl<T, M, C, const PLACE: u8, L, A, B, R, W> Condense<Spatial<T>, R, W> for Axis<T, M, C, PLACE, L, A, B>
where
    T: Scalar,
    M: Mode,
    C: Offset<T>,
    L: SpringLaw<T>,
    A: Armature<T>,
    B: Bearing,
    R: Outboard<T>,
    W: Sweep<Spatial<T>, Springs: PivotRule<T>, Closures = R::Closures>,
    InJoint<Spatial<T>, W>: Drive<T>,
{
    type Out = B::Relation<T, R::Closures>;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: R,
        posture: Posture<'_, Spatial<T>, Self>,
        given: Given<'_, Spatial<T>, Self, W>,
        kept: &mut ClosedGains<T, R::Closures>,
    ) -> B::Relation<T, R::Closures> {
        apart::<T, _>(
            #[cfg_attr(optimised, inline(always))]
            || {
                // Laws that are not linear are read where the last sweep has led.
                let stiff = const { <W::Springs as Springs<T>>::STIFF };
                let follows = const { !L::LINEAR && <W::Springs as Springs<T>>::STIFF };
                let (position, rate) = match follows {
                    true => (*given.reading.position, *given.reading.rate),
                    false => (*given.position, *given.rate),
                };
                let mut effort = given.in_joints.onto(0, self.law.force(position, rate));
                let mut more = self.inertia();
                if stiff {
                    let stiffness = given.springs.stiffness(|springs| self.law.pivot(position, rate, springs));
                    let stiffness = stiffness.add_to(T::zero());
                    if follows {
                        effort = stiffness.mul_add(*given.reading.acceleration, effort);
                    }
                    more = more.plus(Number::of(stiffness));
                }
                let stiffened = const { A::ON || <W::Springs as Springs<T>>::STIFF };
                self.let_go(outer, effort, more, Self::posture(posture.x, posture.y), (kept, stiffened))
            },
        )
    }
}
