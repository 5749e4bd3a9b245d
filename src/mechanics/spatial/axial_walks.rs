//! Elimination and recovery of joints that turn about axes or slide along them.

use super::Joint;
use super::axial::{Axial, Listed};
use super::axial_motion::{moved, oriented, pushed};
use super::loads::Drive;
use super::release::{self, Release};
use super::spring::PivotRule;
use super::stored::{One, Stored};
use super::{Acceleration, Cylindrical, Frame, JointMotion, Prismatic, Revolute, Spatial, Turn, Universal};
use crate::element::{Condense, Given, InJoint, Posture, Reading, Springs, Sweep};
use crate::error::Fault;
use crate::relation::spatial::algebra::{Columns, add_scaled};
use crate::relation::spatial::{Full, Pivot, Relation, Rigid, Slides, Way};
use crate::relation::{Closures, Coefficient, Term};
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use nalgebra::Vector3;

#[inline(always)]
fn axis<T: Scalar>(stored: &Columns<T>, k: usize) -> Vector3<T> {
    if k == 0 { stored.x } else { stored.y }
}

#[cfg_attr(optimised, inline(always))]
#[allow(clippy::too_many_arguments)] // what an element is given, one value each
fn condense<T: Scalar, J, R, W, const K: usize>(
    joint: &J,
    outer: R,
    posture: (&Columns<T>, &[Vector3<T>; 2]),
    drive: InJoint<Spatial<T>, W>,
    (position, rate): (&J::Coordinates, &J::Coordinates),
    led: Reading<'_, J::Coordinates, J::Coordinates>,
    springs: W::Springs,
    kept: &mut [Pivot<T, R::Closures>; K],
) -> Full<T, R::Closures>
where
    J: Axial<T, K>,
    R: Rigid<T>,
    W: Sweep<Spatial<T>, Springs: PivotRule<T>>,
    InJoint<Spatial<T>, W>: Drive<T>,
{
    // Laws that are not linear are read where the last sweep has led.
    let follows = const { !J::LINEAR && <W::Springs as Springs<T>>::STIFF };
    let (position, rate) = if follows { (led.position, led.rate) } else { (position, rate) };
    let (position, rate) = (position.list(), rate.list());
    let acts = |k: usize| {
        let mut force = drive.onto(k, joint.force(k, position[k], rate[k]));
        let stiffness = springs.stiffness(|springs| joint.pivot(k, position[k], rate[k], springs));
        if follows {
            force = stiffness.times_onto(led.acceleration.list()[k], force);
        }
        (force, stiffness)
    };
    loosened(joint, outer.full(), posture, acts, kept)
}

/// Lets all coordinates go, each against a force and what stiffness or inertia adds to its pivot.
#[cfg_attr(optimised, inline(always))]
pub(super) fn loosened<T: Scalar, J: Axial<T, K>, C: Closures, M: Term<T>, const K: usize>(
    joint: &J,
    outer: Full<T, C>,
    (stored, bias): (&Columns<T>, &[Vector3<T>; 2]),
    acts: impl Fn(usize) -> (T, M),
    kept: &mut [Pivot<T, C>; K],
) -> Full<T, C> {
    let mut relation = outer;
    if J::SLIDES {
        relation = relation.with_mass(joint.lumped());
    }
    for k in (0..K).rev() {
        let (force, stiffness) = acts(k);
        (relation, kept[k]) = relation.released(J::WAYS[k], axis(stored, k), force, stiffness);
    }
    if J::TURNS {
        relation = relation.turning(bias[1]);
    }
    if J::SLIDES {
        relation = relation.carried(stored.z, bias[0]);
    }
    relation
}

/// Takes the outboard side along where the one coordinate accelerates as given.
#[cfg_attr(optimised, inline(always))]
pub(super) fn carried<T: Scalar, J: Axial<T, 1>, C: Closures>(
    joint: &J,
    outer: Full<T, C>,
    (stored, bias): (&Columns<T>, &[Vector3<T>; 2]),
    acceleration: T,
) -> Full<T, C> {
    match J::WAYS {
        [Way::Turn] => outer.turning(add_scaled(bias[1], acceleration, stored.x)),
        [Way::Slide] => outer.with_mass(joint.lumped()).carried(stored.z, add_scaled(bias[0], acceleration, stored.x)),
    }
}

#[cfg_attr(optimised, inline(always))]
fn recovered<T: Scalar, J: Axial<T, K>, C: Closures, const K: usize>(
    inboard: Acceleration<T>,
    (stored, bias): (&Columns<T>, &[Vector3<T>; 2]),
    kept: &[Pivot<T, C>; K],
    multipliers: &C::Each<T>,
    rate: &mut J::Coordinates,
) -> Acceleration<T> {
    let mut p = if J::SLIDES { inboard.shifted(stored.z, bias[0]) } else { inboard };
    if J::TURNS {
        p.angular += bias[1];
    }
    let mut seconds = [T::zero(); K];
    for k in 0..K {
        seconds[k] = kept[k].acceleration(p.linear, p.angular, multipliers);
        p = pushed(p, J::WAYS[k], axis(stored, k), seconds[k]);
    }
    *rate = J::Coordinates::from_list(seconds);
    p
}

#[cfg_attr(optimised, inline(always))]
fn responded<T: Scalar, J: Axial<T, K>, C: Closures, const K: usize>(
    inboard: Acceleration<T>,
    (stored, _): (&Columns<T>, &[Vector3<T>; 2]),
    kept: &[Pivot<T, C>; K],
    multipliers: &C::Each<T>,
    rate: &mut J::Coordinates,
) -> Acceleration<T> {
    let kept = kept.map(|pivot| Pivot { free: T::zero(), ..pivot });
    let mut p = if J::SLIDES { inboard.swung(stored.z) } else { inboard };
    let mut seconds = [T::zero(); K];
    for k in 0..K {
        seconds[k] = kept[k].acceleration(p.linear, p.angular, multipliers);
        p = pushed(p, J::WAYS[k], axis(stored, k), seconds[k]);
    }
    *rate = J::Coordinates::from_list(seconds);
    p
}

/// Makes axial joints joints that can condense.
macro_rules! axial {
    ([$($generics:ident $(: $bound:ident)?),*] $Joint:ty, $K:literal, $Takes:ident, |$outer:ident| $rigid:expr) => {
        impl<$($generics $(: $bound<T>)?),*> Joint<T> for $Joint where T: Scalar {
            type Position = <Self as Axial<T, $K>>::Coordinates;
            type Rate = <Self as Axial<T, $K>>::Coordinates;
            type Kept<C: Closures> = [Pivot<T, C>; $K];
            type Sets = One;

            const LINEAR: bool = <Self as Axial<T, $K>>::LINEAR;

            fn still() -> (Self::Position, Self::Rate) {
                (Listed::from_list([T::zero(); $K]), Listed::from_list([T::zero(); $K]))
            }
            fn kept<C: Closures>() -> Self::Kept<C> {
                [Pivot::blank(); $K]
            }
            fn is_finite<C: Closures>(kept: &Self::Kept<C>) -> bool {
                kept.iter().all(Pivot::is_finite)
            }
            /// Angles of the joint; its slides stay.
            fn configure(&self, position: &mut Self::Position, inboard: Turn<T>, next: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
                let mut list = Listed::<T, $K>::list(position);
                for (x, way) in list.iter_mut().zip(<Self as Axial<T, $K>>::WAYS) {
                    if way == Way::Turn {
                        *x = next(inboard);
                    }
                }
                *position = Listed::from_list(list);
                oriented(self, position, &<Self as Joint<T>>::still().1, inboard).0
            }
            fn lump(&mut self, mass: T) -> T {
                Axial::lump(self, mass)
            }
            #[cfg_attr(optimised, inline(always))]
            fn oriented(
                &self,
                position: &Self::Position,
                rate: &Self::Rate,
                inboard: Turn<T>,
            ) -> (Turn<T>, Stored<T>) {
                oriented(self, position, rate, inboard)
            }
            #[cfg_attr(optimised, inline(always))]
            fn store((axes, bias): Stored<T>, x: &mut Columns<T>, y: &mut [Vector3<T>; 2]) {
                x.x = axes.x;
                if $K > 1 {
                    x.y = axes.y;
                }
                if <Self as Axial<T, $K>>::SLIDES {
                    (x.z, y[0]) = (axes.z, bias[0]);
                }
                if <Self as Axial<T, $K>>::TURNS {
                    y[1] = bias[1];
                }
            }
            #[inline(always)]
            fn release(&self, motion: &JointMotion<T>, position: &Self::Position, rate: &Self::Rate) -> Release<T> {
                release::axial(self, motion, position, rate)
            }
            #[cfg_attr(optimised, inline(always))]
            fn moved(
                &self,
                inboard: Frame<T>,
                position: &Self::Position,
                rate: &Self::Rate,
                acceleration: &Self::Rate,
            ) -> JointMotion<T> {
                moved(self, inboard, position, rate, acceleration)
            }
            fn check(&self) -> Result<(), Fault> {
                self.verify()
            }
            #[cfg_attr(optimised, inline(always))]
            fn recovered<C: Closures>(
                &self,
                inboard: Acceleration<T>,
                stored: (&Columns<T>, &[Vector3<T>; 2]),
                kept: &Self::Kept<C>,
                multipliers: &C::Each<T>,
                rate: &mut Self::Rate,
            ) -> Acceleration<T> {
                recovered::<T, Self, C, $K>(inboard, stored, kept, multipliers, rate)
            }
            #[cfg_attr(optimised, inline(always))]
            fn responded<C: Closures>(
                &self,
                inboard: Acceleration<T>,
                stored: (&Columns<T>, &[Vector3<T>; 2]),
                kept: &Self::Kept<C>,
                multipliers: &C::Each<T>,
                rate: &mut Self::Rate,
            ) -> Acceleration<T> {
                responded::<T, Self, C, $K>(inboard, stored, kept, multipliers, rate)
            }
        }

        impl<Outer, W, $($generics $(: $bound<T>)?),*> Condense<Spatial<T>, Outer, W> for $Joint
        where
            T: Scalar,
            Outer: $Takes<T>,
            W: Sweep<Spatial<T>, Springs: PivotRule<T>, Closures = Outer::Closures>,
            InJoint<Spatial<T>, W>: Drive<T>,
        {
            type Out = Full<T, Outer::Closures>;

            #[cfg_attr(optimised, inline(always))]
            fn condense(
                &self,
                outer: Outer,
                posture: Posture<'_, Spatial<T>, Self>,
                given: Given<'_, Spatial<T>, Self, W>,
                kept: &mut [Pivot<T, Outer::Closures>; $K],
            ) -> Self::Out {
                let Given { in_joints, position, rate, reading, springs, .. } = given;
                let (posture, state) = ((posture.x, posture.y), (position, rate));
                let rigid = |$outer: Outer| $rigid;
                condense::<T, Self, _, W, $K>(self, rigid(outer), posture, *in_joints, state, reading, springs, kept)
            }
        }
    };
}
axial!([T, L: SpringLaw] Revolute<T, L>, 1, Rigid, |outer| outer);
// A ball resists no rotation, but displacement.
axial!([T, L: SpringLaw] Prismatic<T, L>, 1, Slides, |outer| outer.whole());
axial!([T, L: SpringLaw, M: SpringLaw] Universal<T, L, M>, 2, Rigid, |outer| outer);
axial!([T, L: SpringLaw, M: SpringLaw] Cylindrical<T, L, M>, 2, Rigid, |outer| outer);
