//! What joints in body axes say of themselves, as all joints do: in inertial axes but for accelerations.

use super::axis::{Armature, Axis, Bearing, Mode};
use super::closures::ClosedGains;
use super::number::{Number, Triple, apply, triple, values};
use super::relation::Gains;
use super::standing::{Stand, Standing};
use super::turns::Offset;
use crate::element::Springs;
use crate::error::Fault;
use crate::error::checks::finite;
use crate::mechanics::spatial::{Acceleration, Frame, JointMotion, Spatial, Turn};
use crate::relation::Closures;
use crate::relation::spatial::algebra::{Columns, add_scaled, cross};
use crate::release::{Freedom, Release, Resistance, Way, slopes};
use crate::scalar::{Scalar, apart};
use crate::shape::{Joint, JointPosture};
use crate::spring::SpringLaw;
use nalgebra::Vector3;

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>, B: Bearing>
    Axis<T, M, C, PLACE, L, A, B>
{
    /// What a posture holds: sine and cosine (or zero and the way), the acceleration of its place, that of the body.
    #[inline(always)]
    pub(super) fn posture(x: &Columns<T>, y: &[Vector3<T>; 2]) -> (Stand<T>, [Triple<T>; 2]) {
        ([x.x.x, x.x.y], [triple(y[0].into()), triple(y[1].into())])
    }

    /// The place's acceleration as stored, with what is known of it.
    #[inline(always)]
    pub(super) fn known_swung(swung: Triple<T>) -> Triple<T> {
        if const { PLACE & 7 == 0 } { [Number::zero(); 3] } else { swung }
    }

    /// The attitude of the body on a parent of an attitude.
    pub(super) fn attitude(&self, stand: Stand<T>, parent: &Columns<T>) -> Columns<T> {
        let axis = |k: usize| {
            let mut unit = [T::zero(); 3];
            unit[k] = T::one();
            parent.apply(Vector3::from(values(self.outward(stand, triple(unit)))))
        };
        Columns { x: axis(0), y: axis(1), z: axis(2) }
    }

    /// From the parent's origin to the body's, and the joint's axis, in inertial axes.
    fn reach(&self, position: T, parent: &Columns<T>) -> [Vector3<T>; 2] {
        let o = T::zero();
        let axis = values(apply(&self.offset.rows(), triple([o, o, T::one()])));
        let (arm, axis) = (parent.apply(Vector3::from(values(self.arm()))), parent.apply(Vector3::from(axis)));
        [if M::TURNS { arm } else { add_scaled(arm, position, axis) }, axis]
    }
}

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>, B: Bearing> Joint<Spatial<T>>
    for Axis<T, M, C, PLACE, L, A, B>
{
    type Position = T;
    type Rate = T;
    type Kept<X: Closures> = ClosedGains<T, X>;
    type Per<X: Copy> = X;

    const LINEAR: bool = L::LINEAR;
    const SINES: usize = M::TURNS as usize;

    #[inline(always)]
    fn angle(&self, position: &T) -> T {
        Standing::angle(self, *position)
    }
    #[inline(always)]
    fn set_sine(&self, x: &mut Columns<T>, [sine, cosine]: [T; 2]) {
        (x.x.x, x.x.y) = (sine, cosine);
    }

    fn still() -> (T, T) {
        (T::zero(), T::zero())
    }
    fn kept<X: Closures>() -> ClosedGains<T, X> {
        ClosedGains::unmoved(Gains::along(M::TURNS))
    }
    fn per<X: Copy>(fill: X) -> X {
        fill
    }
    fn is_finite<X: Closures>(kept: &ClosedGains<T, X>) -> bool {
        kept.gains.is_finite()
    }
    /// The angle of the joint; its way stays.
    fn configure(&self, position: &mut T, inboard: Turn<T>, next: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
        if M::TURNS {
            *position = next(inboard);
        }
        Turn { attitude: self.attitude(self.stand(*position), &inboard.attitude), ..inboard }
    }
    #[cfg_attr(optimised, inline(always))]
    fn recover<X: Closures, By: Springs<T>>(
        &self,
        inboard: Acceleration<T>,
        (x, y, _, _): JointPosture<'_, Spatial<T>, Self>,
        kept: &mut ClosedGains<T, X>,
        multipliers: &X::Each<T>,
        rate: &mut T,
    ) -> Acceleration<T> {
        apart::<T, _>(
            #[cfg_attr(optimised, inline(always))]
            || {
                let (stand, [swung, bias]) = Self::posture(x, y);
                let p = [triple(inboard.linear.into()), triple(inboard.angular.into())];
                let p = self.accelerated(stand, [Self::known_swung(swung), bias], p);
                let free = X::plus_dot(kept.gains.free, &kept.per_closure, multipliers);
                self.released(p, &kept.gains, free, const { A::ON || By::STIFF }, rate)
            },
        )
    }
    #[cfg_attr(optimised, inline(always))]
    fn respond<X: Closures>(
        &self,
        inboard: Acceleration<T>,
        (x, y, _, _): JointPosture<'_, Spatial<T>, Self>,
        kept: &ClosedGains<T, X>,
        multipliers: &X::Each<T>,
        rate: &mut T,
    ) -> Acceleration<T> {
        apart::<T, _>(
            #[cfg_attr(optimised, inline(always))]
            || {
                let (stand, _) = Self::posture(x, y);
                let p = [triple(inboard.linear.into()), triple(inboard.angular.into())];
                let p = self.accelerated(stand, [[Number::zero(); 3]; 2], p);
                let free = X::plus_dot(T::zero(), &kept.per_closure, multipliers);
                self.released(p, &kept.gains, free, true, rate)
            },
        )
    }
    #[cfg_attr(optimised, inline(always))]
    fn motion(&self, inboard: Frame<T>, position: &T, rate: &T, acceleration: &T) -> (JointMotion<T>, Frame<T>) {
        apart::<T, _>(
            #[cfg_attr(optimised, inline(always))]
            || {
                let (q, v, turn) = (*position, *rate, inboard.turn);
                let [arm, n] = self.reach(q, &turn.attitude);
                let mut outboard = inboard.shifted(arm);
                outboard.turn.attitude = self.attitude(self.stand(q), &turn.attitude);
                let swept = cross(turn.spin, n);
                if M::TURNS {
                    outboard.turn.spin = add_scaled(turn.spin, v, n);
                    let angular = &mut outboard.acceleration.angular;
                    *angular = add_scaled(add_scaled(*angular, v, swept), *acceleration, n);
                } else {
                    outboard.velocity = add_scaled(outboard.velocity, v, n);
                    let linear = &mut outboard.acceleration.linear;
                    *linear = add_scaled(add_scaled(*linear, v + v, swept), *acceleration, n);
                }
                let only = |x| [x, T::zero(), T::zero()];
                let motion = JointMotion {
                    inboard,
                    outboard,
                    position: only(q),
                    rate: only(v),
                    effort: only(self.law.force(q, v)),
                    energy: self.law.energy(q),
                    inertia: only(self.armature.number().value()),
                };
                (motion, outboard)
            },
        )
    }
    fn release(&self, motion: &JointMotion<T>, position: &T, rate: &T) -> Release<Spatial<T>> {
        let (q, v, turn) = (*position, *rate, motion.inboard.turn);
        let [arm, n] = self.reach(q, &turn.attitude);
        let centripetal = cross(turn.spin, cross(turn.spin, arm));
        let swept = cross(turn.spin, n);
        let none = Release::nothing();
        let (release, way) = if M::TURNS {
            (Release { linear: centripetal, angular: swept * v, ..none }, Way::Turn)
        } else {
            (Release { linear: add_scaled(centripetal, v + v, swept), ..none }, Way::Slide)
        };
        let [stiffness, damping] = slopes::<T, _>(|springs| self.law.pivot(q, v, springs));
        let resistance = Resistance { force: self.law.force(q, v), stiffness, damping };
        let preload = self.law.force(T::zero(), T::zero());
        let freedom = Freedom::smooth(way, n).against(resistance, preload);
        release.with(Freedom { inertia: self.armature.number().value(), linear: L::LINEAR, ..freedom })
    }
    fn check(&self) -> Result<(), Fault> {
        finite("place of a joint", &self.place)?;
        if (0..3).any(|k| PLACE >> k & 1 == 0 && !self.place[k].is_identical(T::zero())) {
            return Err(Fault::NotZero { parameter: "place of a joint, where its mask says so" });
        }
        self.armature.check()?;
        self.offset.check()?;
        self.law.check()
    }
}

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>, B: Bearing>
    Axis<T, M, C, PLACE, L, A, B>
{
    /// The coordinate's acceleration, and that of the body: where nothing adds to the pivot, the share of its own axis is one.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn released(
        &self,
        p: [Triple<T>; 2],
        kept: &Gains<T>,
        free: T,
        stiffened: bool,
        rate: &mut T,
    ) -> Acceleration<T> {
        let (a, angular) = (values(p[0]), values(p[1]));
        let (la, ga) = (kept.linear, kept.angular);
        let mut total = free;
        for k in 0..3 {
            if M::TURNS || k < 2 || stiffened {
                total = (-la[k]).mul_add(a[k], total);
            }
            if !M::TURNS || k < 2 || stiffened {
                total = (-ga[k]).mul_add(angular[k], total);
            }
        }
        let own = if M::TURNS { angular[2] } else { a[2] };
        // Without, what is left is the acceleration along the axis itself.
        let (second, whole) = if stiffened { (total, total + own) } else { (total - own, total) };
        *rate = second;
        let (mut linear, mut angular) = (Vector3::from(a), Vector3::from(angular));
        if M::TURNS {
            angular.z = whole
        } else {
            linear.z = whole
        }
        Acceleration { linear, angular }
    }
}
