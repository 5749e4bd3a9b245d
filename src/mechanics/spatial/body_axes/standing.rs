//! What a joint makes of vectors of its parent and of its body.

use super::axis::{Armature, Axis, Bearing, Mode};
use super::link::centripetal;
use super::number::{Number, Rows, Triple, apply, cross_onto, masked, sum, transposed, triple, values};
use super::turns::Offset;
use crate::release::slopes;
use crate::scalar::Scalar;
use crate::spring::SpringLaw;

/// What a coordinate makes of a joint: sine and cosine of an angle, or zero and the way.
pub type Stand<T> = [T; 2];

/// All that a joint has besides: what its methods need.
pub trait Standing<T: Scalar>: Copy {
    /// Whether the coordinate turns.
    const TURNS: bool;
    /// Where the joint sits, in axes of the parent.
    fn arm(&self) -> Triple<T>;
    /// Axes of the body, while the coordinate and what is added to it are zero, in those of the parent.
    fn offset(&self) -> Rows<T>;
    /// What is added to an angle.
    fn ahead(&self) -> Number<T>;
    /// Reflected inertia.
    fn inertia(&self) -> Number<T>;
    /// What spring and damper exert.
    fn law(&self, position: T, rate: T) -> T;
    /// How that changes: −∂force/∂position and −∂force/∂rate.
    fn slopes(&self, position: T, rate: T) -> [T; 2];
    /// Energy of the spring.
    fn energy(&self, position: T) -> T;

    /// The angle that a coordinate stands for.
    #[inline(always)]
    fn angle(&self, position: T) -> T {
        self.ahead().plus(Number::of(position)).value()
    }

    /// What the coordinate makes of it.
    #[cfg_attr(optimised, inline(always))]
    fn stand(&self, position: T) -> Stand<T> {
        if const { Self::TURNS } {
            let (sine, cosine) = self.angle(position).sin_cos();
            [sine, cosine]
        } else {
            [T::zero(), position]
        }
    }

    /// A vector of the parent's axes in those of the body.
    #[cfg_attr(optimised, inline(always))]
    fn inward(&self, [sine, cosine]: Stand<T>, vector: Triple<T>) -> Triple<T> {
        let [x, y, z] = apply(&transposed(&self.offset()), vector);
        if const { Self::TURNS } {
            let (s, c) = (Number::of(sine), Number::of(cosine));
            [s.times_onto(y, c.times(x)), s.times_off(x, c.times(y)), z]
        } else {
            [x, y, z]
        }
    }

    /// A vector of the body's axes in those of the parent.
    #[cfg_attr(optimised, inline(always))]
    fn outward(&self, [sine, cosine]: Stand<T>, [x, y, z]: Triple<T>) -> Triple<T> {
        let turned = if const { Self::TURNS } {
            let (s, c) = (Number::of(sine), Number::of(cosine));
            [s.times_off(y, c.times(x)), s.times_onto(x, c.times(y)), z]
        } else {
            [x, y, z]
        };
        apply(&self.offset(), turned)
    }

    /// Angular velocity of the body, from that of the parent, each in its own axes.
    #[inline(always)]
    fn spun(&self, stand: Stand<T>, rate: T, spin: [T; 3]) -> [T; 3] {
        let [x, y, z] = values(self.inward(stand, triple(spin)));
        if const { Self::TURNS } { [x, y, z + rate] } else { [x, y, z] }
    }

    /// What accelerates the joint's place besides the parent's origin, in axes of the parent.
    #[inline(always)]
    fn swung(&self, spin: [T; 3]) -> Triple<T> {
        centripetal(triple(spin), self.arm())
    }

    /// What accelerates the body besides, in its own axes, at its angular velocity: angular for a hinge (z is zero), linear for a slide.
    #[cfg_attr(optimised, inline(always))]
    fn bias(&self, [_, way]: Stand<T>, rate: T, [x, y, z]: [T; 3]) -> [T; 3] {
        if const { Self::TURNS } {
            [rate * y, -(rate * x), T::zero()]
        } else {
            // 2 q̇ ω × z + q ω × (ω × z)
            let twice = rate + rate;
            let radial = way * z;
            [x.mul_add(radial, twice * y), y.mul_add(radial, -(twice * x)), -(way * x.mul_add(x, y * y))]
        }
    }

    /// Acceleration of the body's origin but for the coordinate, and of the body, from that of the parent.
    #[cfg_attr(optimised, inline(always))]
    fn accelerated(
        &self,
        stand: Stand<T>,
        [swung, bias]: [Triple<T>; 2],
        [a, angular]: [Triple<T>; 2],
    ) -> [Triple<T>; 2] {
        let at_joint = cross_onto(angular, self.arm(), sum(a, swung));
        let (a, angular) = (self.inward(stand, at_joint), self.inward(stand, angular));
        if const { Self::TURNS } {
            [a, [angular[0].plus(bias[0]), angular[1].plus(bias[1]), angular[2]]]
        } else {
            let out = [Number::zero(), Number::zero(), Number::of(stand[1])];
            [cross_onto(angular, out, sum(a, bias)), angular]
        }
    }

    /// With the coordinate's own acceleration or rate.
    #[cfg_attr(optimised, inline(always))]
    fn moved(&self, second: T, [mut a, mut angular]: [Triple<T>; 2]) -> [Triple<T>; 2] {
        let moved = if const { Self::TURNS } { &mut angular[2] } else { &mut a[2] };
        *moved = moved.plus(Number::of(second));
        [a, angular]
    }

    /// Force and torque at the parent's origin, from those at the body's.
    #[cfg_attr(optimised, inline(always))]
    fn carried(&self, stand: Stand<T>, [force, torque]: [Triple<T>; 2]) -> [Triple<T>; 2] {
        let torque = if const { Self::TURNS } {
            torque
        } else {
            cross_onto([Number::zero(), Number::zero(), Number::of(stand[1])], force, torque)
        };
        let (force, torque) = (self.outward(stand, force), self.outward(stand, torque));
        [force, cross_onto(self.arm(), force, torque)]
    }

    /// Generalised force of a force and torque at the body's origin.
    #[inline(always)]
    fn along(&self, [force, torque]: [Triple<T>; 2]) -> T {
        if const { Self::TURNS } { torque[2].value() } else { force[2].value() }
    }
}

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>, B: Bearing> Standing<T>
    for Axis<T, M, C, PLACE, L, A, B>
{
    const TURNS: bool = M::TURNS;

    #[inline(always)]
    fn arm(&self) -> Triple<T> {
        masked(PLACE, self.place)
    }
    #[inline(always)]
    fn offset(&self) -> Rows<T> {
        self.offset.rows()
    }
    #[inline(always)]
    fn ahead(&self) -> Number<T> {
        self.offset.ahead()
    }
    #[inline(always)]
    fn inertia(&self) -> Number<T> {
        self.armature.number()
    }
    #[inline(always)]
    fn law(&self, position: T, rate: T) -> T {
        self.law.force(position, rate)
    }
    #[inline(always)]
    fn slopes(&self, position: T, rate: T) -> [T; 2] {
        slopes::<T, _>(|springs| self.law.pivot(position, rate, springs))
    }
    #[inline(always)]
    fn energy(&self, position: T) -> T {
        self.law.energy(position)
    }
}
