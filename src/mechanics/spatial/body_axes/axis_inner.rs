//! Joints in body axes inside of those that are driven or have modes.

use super::axis::{Armature, Axis, Bearing, Mode};
use super::closures::{ClosedGains, accelerated};
use super::number::{Number, Triple, values};
use super::relation::{Gains, LocalCuts, Outboard};
use super::sparse::Sparse;
use super::standing::Standing;
use super::turns::Offset;
use crate::element::{Element, Sweep};
use crate::inner::{Drivable, Eliminates, Guardable};
use crate::kinematics::Acting;
use crate::mechanics::spatial::{JointMotion, Spatial, Turn};
use crate::relation::spatial::algebra::Columns;
use crate::scalar::Scalar;
use crate::shape::JointPosture;
use crate::spring::{Spring, SpringLaw};
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
    #[cfg_attr(optimised, inline(always))]
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

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>, B: Bearing>
    Axis<T, M, C, PLACE, L, A, B>
{
    /// The relation at the body's origin where the coordinate accelerates as given; gains that give that acceleration are kept.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn led<R: Outboard<T>>(
        outer: R,
        [x, y, z]: Triple<T>,
        acceleration: T,
        kept: &mut ClosedGains<T, R::Closures>,
    ) -> (Sparse<T>, LocalCuts<T, R::Closures>) {
        *kept = ClosedGains::unmoved(Gains { free: acceleration, ..Gains::blank() });
        let (second, o) = (Number::of(acceleration), Number::zero());
        let besides = if const { M::TURNS } { [[o; 3], [x, y, second]] } else { [[x, y, z.plus(second)], [o; 3]] };
        (outer.sparse().accelerated(besides), accelerated(outer.cuts(), besides.map(values)))
    }
}

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, A: Armature<T>, B: Bearing> Guardable<Spatial<T>>
    for Axis<T, M, C, PLACE, Spring, A, B>
{
    fn under(motion: JointMotion<T>, Acting { resistance, energy, .. }: Acting<T>) -> JointMotion<T> {
        JointMotion { effort: [resistance.force, T::zero(), T::zero()], energy, ..motion }
    }
}

impl<T, M, C, const PLACE: u8, L, A, B, R, W> Eliminates<Spatial<T>, R, W> for Axis<T, M, C, PLACE, L, A, B>
where
    T: Scalar,
    M: Mode,
    C: Offset<T>,
    L: SpringLaw<T>,
    A: Armature<T>,
    B: Bearing,
    R: Outboard<T>,
    W: Sweep<Spatial<T>, Closures = R::Closures>,
{
    type Out = B::Relation<T, R::Closures>;

    #[cfg_attr(optimised, inline(always))]
    fn eliminate(
        &self,
        outer: R,
        (x, y, ..): JointPosture<'_, Spatial<T>, Self>,
        force: T,
        resistance: T,
        kept: &mut ClosedGains<T, R::Closures>,
    ) -> B::Relation<T, R::Closures> {
        let more = self.inertia().plus(Number::of(resistance));
        self.let_go(outer, force, more, Self::posture(x, y), (kept, true))
    }
    #[cfg_attr(optimised, inline(always))]
    fn drive(
        &self,
        outer: R,
        (x, y, ..): JointPosture<'_, Spatial<T>, Self>,
        acceleration: T,
        kept: &mut ClosedGains<T, R::Closures>,
    ) -> B::Relation<T, R::Closures> {
        let (stand, [swung, bias]) = Self::posture(x, y);
        let (relation, cuts) = Self::led(outer, bias, acceleration, kept);
        self.handed_on(relation.at_joint(M::TURNS, stand), cuts, (stand, swung))
    }
}
