//! Joints in body axes whose coordinate is a given function of time.

use super::axis::{Armature, Axis, Bearing, Mode};
use super::number::Number;
use super::relation::{Gains, Outboard};
use super::turns::Offset;
use crate::driven::{Drivable, Driven, MotionLaw};
use crate::element::{Condense, Element, Given, Posture, Sweep};
use crate::mechanics::spatial::{Spatial, Turn};
use crate::relation::Open;
use crate::relation::spatial::algebra::Columns;
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use nalgebra::Vector3;

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>, B: Bearing>
    Drivable<Spatial<T>> for Axis<T, M, C, PLACE, L, A, B>
{
    fn lump(&mut self, mass: T) -> T {
        Element::lump(self, mass)
    }
    #[inline(always)]
    fn turned(&self, position: &T, rate: &T, inboard: Turn<T>) -> Turn<T> {
        Element::turned(self, position, rate, inboard)
    }
    #[inline(always)]
    fn orient(
        &self,
        position: &T,
        rate: &T,
        inboard: Turn<T>,
        x: &mut Columns<T>,
        y: &mut [Vector3<T>; 2],
        p: &mut Vector3<T>,
        q: &mut Vector3<T>,
    ) -> Turn<T> {
        Element::orient(self, position, rate, inboard, x, y, p, q)
    }
    #[inline(always)]
    fn resolve(_: &mut Columns<T>, _: &mut [Vector3<T>; 2], _: &mut Vector3<T>, _: &mut Vector3<T>) {}
}

impl<T, M, C, const PLACE: u8, L, A, B, F, R, W> Condense<Spatial<T>, R, W> for Driven<Axis<T, M, C, PLACE, L, A, B>, F>
where
    T: Scalar,
    M: Mode,
    C: Offset<T>,
    L: SpringLaw<T>,
    A: Armature<T>,
    B: Bearing,
    F: MotionLaw<T>,
    R: Outboard<T>,
    W: Sweep<Spatial<T>, Closures = Open>,
{
    type Out = B::Relation<T>;

    #[inline(always)]
    fn condense(
        &self,
        outer: R,
        posture: Posture<'_, Spatial<T>, Self>,
        given: Given<'_, Spatial<T>, Self, W>,
        kept: &mut Gains<T>,
    ) -> B::Relation<T> {
        let [.., second] = self.law().at(given.position.0);
        *kept = Gains { free: second, ..Gains::blank() };
        let (stand, [swung, [x, y, z]]) = Axis::<T, M, C, PLACE, L, A, B>::posture(posture.x, posture.y);
        let (relation, second, o) = (outer.sparse(), Number::of(second), Number::zero());
        let relation = if const { M::TURNS } {
            relation.accelerated([[o; 3], [x, y, second]]).turned_about_z(stand[0], stand[1])
        } else {
            relation.accelerated([[x, y, z.plus(second)], [o; 3]]).shifted([o, o, Number::of(stand[1])], [o; 3])
        };
        self.joint().handed_on(relation, swung)
    }
}
