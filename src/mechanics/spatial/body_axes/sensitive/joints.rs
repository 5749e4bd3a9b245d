//! Derivatives through kept gains in body axes: what hinges and slides do.
//!
//! With v′ = Rᵀ v a vector of the parent in axes of the body, and a coordinate q of a hinge, d(Rᵀ v) = Rᵀ dv + v′ × z dq. At a fixed q̈
//!
//! ```text
//! dω = Rᵀ dω + ω × z dq + z dq̇
//! dα = Rᵀ dα + α′ × z dq + d(q̇ ω × z)
//! da = Rᵀ [da + dα × r + d(ω × (ω × r))] + a × z dq
//! ```
//!
//! and of a slide, whose axes do not turn, da = Rᵀ [..] + d(α × z q + 2 q̇ ω × z + q ω × (ω × z)). What parameters of the joint do is found
//! by its own kinematics on numbers with derivatives.

use super::super::axis::{Armature, Axis, Bearing, Mode};
use super::super::closures::ClosedGains;
use super::super::number::{Number, Triple, apply, cross_onto, sum, triple, values};
use super::super::relation::{Gains, Local};
use super::super::standing::{Stand, Standing};
use super::super::turns::Offset;
use super::jets;
use super::products::{products_varied, swirl};
use crate::lift::Lift;
use crate::mechanics::spatial::loads::Effort;
use crate::mechanics::spatial::sensitive::columns::parts;
use crate::mechanics::spatial::sensitive::{Answering, Passing, Pulling};
use crate::mechanics::spatial::{Acceleration, Spatial};
use crate::relation::spatial::Full;
use crate::scalar::{Jet, Scalar, columns};
use crate::sensitive::{At, Derived, Seeds, Sensitive};
use crate::spring::SpringLaw;
use nalgebra::Vector3;

/// What a joint in body axes keeps.
#[derive(Clone, Copy)]
pub struct AxisStore<T: Scalar, const K: usize> {
    kept: ClosedGains<T>,
    /// 1 / D.
    inverse: T,
    /// Effort handed in.
    load: Jet<T, K>,
    /// Whether place or turn of the joint have derivatives.
    seeded: bool,
}

/// A joint and its motion, of which columns are derivatives.
struct Moving<'a, T, J> {
    joint: &'a J,
    stand: Stand<T>,
    rate: T,
    /// Angular velocity of the parent, in its axes.
    inboard: [T; 3],
    /// Of the body, in its own.
    spin: [T; 3],
    /// Acceleration of the body's origin and of the body, in its own axes.
    linear: [T; 3],
    angular: [T; 3],
}

/// v + z × w f.
#[inline(always)]
fn swept<T: Scalar>([x, y, z]: [T; 3], w: [T; 3], f: T) -> [T; 3] {
    [(-w[1]).mul_add(f, x), w[0].mul_add(f, y), z]
}

impl<T: Scalar, J: Standing<T>> Moving<'_, T, J> {
    /// A column of ω, a and α on the other side of the joint, from that of the parent and those of position and rate.
    #[cfg_attr(optimised, inline(always))]
    fn column(&self, [spin, linear, angular]: [[T; 3]; 3], of_position: T, of_rate: T) -> [[T; 3]; 3] {
        let Self { joint, stand, rate, .. } = *self;
        let inward = |v: [T; 3]| values(joint.inward(stand, triple(v)));
        let swung = apply(&swirl(products_varied(self.inboard, spin)), joint.arm());
        let linear = values(joint.inward(stand, cross_onto(triple(angular), joint.arm(), sum(triple(linear), swung))));
        let (spin, angular) = (inward(spin), inward(angular));
        let [x, y, z] = self.spin;
        if const { J::TURNS } {
            // ω × z q̇ is no part of what turns with the body, but follows from its ω.
            let [u, v, _] = self.angular;
            let carried = [rate.mul_add(-y, u), rate.mul_add(x, v), T::zero()];
            let mut spin = swept(spin, self.spin, -of_position);
            spin[2] += of_rate;
            let angular = swept(swept(angular, carried, -of_position), self.spin, -of_rate);
            return [spin, swept(linear, self.linear, -of_position), swept(angular, spin, -rate)];
        }
        let ([dx, dy, dz], way) = (spin, stand[1]);
        let (radial, of_radial) = (way * z, of_position.mul_add(z, way * dz));
        let square = x.mul_add(x, y * y);
        let of_square = x.mul_add(dx, y * dy);
        let linear = swept(swept(linear, angular, -way), self.angular, -of_position);
        let linear = swept(swept(linear, self.spin, -(of_rate + of_rate)), spin, -(rate + rate));
        let [a, b, c] = linear;
        let a = x.mul_add(of_radial, dx.mul_add(radial, a));
        let b = y.mul_add(of_radial, dy.mul_add(radial, b));
        [spin, [a, b, c - of_position.mul_add(square, (way + way) * of_square)], angular]
    }
}

/// A column of force and torque at the parent's origin, from that at the body's, where `forces` are the values.
#[cfg_attr(optimised, inline(always))]
fn carried_column<T: Scalar, J: Standing<T>>(
    (joint, stand): (&J, Stand<T>),
    [force, torque]: [[T; 3]; 2],
    forces: [[T; 3]; 2],
    of_position: T,
) -> [[T; 3]; 2] {
    let column = if const { J::TURNS } {
        [swept(force, forces[0], of_position), swept(torque, forces[1], of_position)]
    } else {
        [force, swept(torque, forces[0], of_position)]
    };
    joint.carried(stand, column.map(triple)).map(values)
}

/// A place with derivatives: of a hinge at an angle φ, d(sine) = cosine dφ, d(cosine) = −sine dφ.
fn stand_of<T: Scalar, J: Standing<Jet<T, K>>, const K: usize>(
    joint: &J,
    [sine, cosine]: Stand<T>,
    position: &Jet<T, K>,
) -> Stand<Jet<T, K>> {
    if !J::TURNS {
        return [Jet::of(sine), *position];
    }
    let angle = joint.angle(*position);
    let of = |re: T, slope: T| Jet { re, eps: angle.eps.map(|x| x * slope) };
    [of(sine, cosine), of(cosine, -sine)]
}

impl<T, M, C, D, const PLACE: u8, L, P, A, Q, B, const K: usize> Sensitive<Spatial<Jet<T, K>>>
    for Axis<Jet<T, K>, M, C, PLACE, L, A, B>
where
    T: Scalar,
    M: Mode,
    C: Offset<Jet<T, K>> + Lift<Jet<T, K>, T, Over = D>,
    D: Offset<T>,
    L: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T, Over = P>,
    P: SpringLaw<T>,
    A: Armature<Jet<T, K>> + Lift<Jet<T, K>, T, Over = Q>,
    Q: Armature<T>,
    B: Bearing,
{
    type Plain = Axis<T, M, D, PLACE, P, Q, B>;
    type Room = AxisStore<T, K>;

    fn room(&self) -> Self::Room {
        let numbers = self.offset().into_iter().chain([self.arm()]).flatten().chain([self.ahead()]);
        AxisStore {
            kept: ClosedGains::unmoved(Gains::along(M::TURNS)),
            inverse: T::zero(),
            load: Jet::of(T::zero()),
            seeded: !numbers.map(Number::value).all(Jet::is_constant),
        }
    }
    #[inline(always)]
    fn read(position: &Jet<T, K>, rate: &Jet<T, K>, plain_position: &mut T, plain_rate: &mut T) {
        (*plain_position, *plain_rate) = (position.re, rate.re);
    }
    fn load(&self, (): &(), in_joint: &Effort<Jet<T, K>>, store: &mut Self::Room) {
        store.load = in_joint.0[0];
    }
    #[cfg_attr(optimised, inline(always))]
    fn factor<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        outer: Full<T>,
        store: &mut Self::Room,
    ) -> Full<T> {
        let (stand, [swung, bias]) = Self::Plain::posture(at.posture.x, at.posture.y);
        let effort = at.plain.law(at.position.re, at.rate.re);
        let effort = if N::LOADS { effort + store.load.re } else { effort };
        let kept = (&mut store.kept, A::ON);
        let outer = Local::of_own(&outer);
        let (relation, cuts, inverse) = Self::Plain::loose(outer, effort, at.plain.inertia(), bias, kept);
        store.inverse = inverse;
        at.plain.at_parent(relation.at_joint(M::TURNS, stand), cuts, (stand, swung)).full()
    }
    #[inline(never)]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        store: &mut Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        let (stand, [swung, bias]) = Self::Plain::posture(at.posture.x, at.posture.y);
        let (joint, rate, gains) = (at.plain, at.rate.re, &store.kept.gains);
        let Acceleration { linear, angular } = carried.acceleration;
        let p = [triple(linear.into()), triple(angular.into())];
        let p = joint.accelerated(stand, [Self::Plain::known_swung(swung), bias], p);
        let outer = joint.released(p, gains, gains.free, A::ON, &mut acceleration.re);
        let inboard: [T; 3] = carried.turn.spin.into();
        let spin = joint.spun(stand, rate, inboard);
        if N::PARAMETERS && store.seeded {
            let stand = stand_of(self, stand, at.position);
            let inboard = jets(carried.turn.spin, &carried.spin);
            let spin = self.spun(stand, *at.rate, inboard);
            let bias = triple(self.bias(stand, *at.rate, spin));
            let p = [triple(jets(linear, &carried.linear)), triple(jets(angular, &carried.angular))];
            let p = self.accelerated(stand, [self.swung(inboard), bias], p);
            carried.spin = parts(&Vector3::from(spin));
            [carried.linear, carried.angular] = p.map(|v| parts(&Vector3::from(values(v))));
        } else {
            let moving = Moving {
                joint,
                stand,
                rate,
                inboard,
                spin,
                linear: outer.linear.into(),
                angular: outer.angular.into(),
            };
            let Passing { spin: [wx, wy, wz], linear: [ax, ay, az], angular: [bx, by, bz], .. } = carried;
            columns!(K; q = at.position.eps, v = at.rate.eps; k:
                let old = [[wx[k], wy[k], wz[k]], [ax[k], ay[k], az[k]], [bx[k], by[k], bz[k]]],
                let new = moving.column(old, q[k], v[k]),
                mut wx = *wx => new[0][0],
                mut wy = *wy => new[0][1],
                mut wz = *wz => new[0][2],
                mut ax = *ax => new[1][0],
                mut ay = *ay => new[1][1],
                mut az = *az => new[1][2],
                mut bx = *bx => new[2][0],
                mut by = *by => new[2][1],
                mut bz = *bz => new[2][2]
            );
        }
        carried.turn.spin = Vector3::from(spin);
        carried.acceleration = outer;
    }
    #[inline(never)]
    fn gather<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Pulling<T, K>,
        store: &mut Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        let (stand, _) = Self::Plain::posture(at.posture.x, at.posture.y);
        let (joint, forces) = (at.plain, [carried.force.into(), carried.torque.into()]);
        let effort = SpringLaw::force(&self.law, *at.position, *at.rate);
        let effort = if N::LOADS { effort + store.load } else { effort };
        let effort = if const { A::ON } && N::PARAMETERS {
            effort - self.inertia().value() * Jet::of(acceleration.re)
        } else {
            effort
        };
        let AxisStore { kept: ClosedGains { gains: Gains { linear, angular, .. }, .. }, inverse, .. } = *store;
        let plain = |v: Triple<T>| Vector3::from(values(v));
        let [force, torque] = joint.carried(stand, forces.map(triple));
        (carried.force, carried.torque) = (plain(force), plain(torque));
        let ([fx, fy, fz], [tx, ty, tz]) = (&mut carried.forces, &mut carried.torques);
        let seeded = N::PARAMETERS && store.seeded;
        columns!(K; q = at.position.eps, effort = effort.eps; k:
            let left = effort[k] - if const { M::TURNS } { tz[k] } else { fz[k] },
            let force = [linear[0].mul_add(left, fx[k]), linear[1].mul_add(left, fy[k]), linear[2].mul_add(left, fz[k])],
            let torque =
                [angular[0].mul_add(left, tx[k]), angular[1].mul_add(left, ty[k]), angular[2].mul_add(left, tz[k])],
            let new = if seeded { [force, torque] } else { carried_column((joint, stand), [force, torque], forces, q[k]) },
            mut free = acceleration.eps => left * inverse,
            mut fx = *fx => new[0][0],
            mut fy = *fy => new[0][1],
            mut fz = *fz => new[0][2],
            mut tx = *tx => new[1][0],
            mut ty = *ty => new[1][1],
            mut tz = *tz => new[1][2]
        );
        if seeded {
            let [force, torque] = forces.map(Vector3::from);
            let pair = [triple(jets(force, &carried.forces)), triple(jets(torque, &carried.torques))];
            let pair = self.carried(stand_of(self, stand, at.position), pair);
            [carried.forces, carried.torques] = pair.map(|v| parts(&Vector3::from(values(v))));
        }
    }
    #[inline(never)]
    fn answer(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Answering<T, K>,
        store: &Self::Room,
        acceleration: &mut Jet<T, K>,
    ) {
        let (stand, _) = Self::Plain::posture(at.posture.x, at.posture.y);
        let (joint, gains) = (at.plain, &store.kept.gains);
        let still = [[Number::zero(); 3]; 2];
        let Answering { linear: [ax, ay, az], angular: [bx, by, bz] } = carried;
        columns!(K; ; k:
            let p = joint.accelerated(stand, still, [triple([ax[k], ay[k], az[k]]), triple([bx[k], by[k], bz[k]])]),
            let found = {
                let mut second = free[k];
                (joint.released(p, gains, free[k], A::ON, &mut second), second)
            },
            mut free = acceleration.eps => found.1,
            mut ax = *ax => found.0.linear.x,
            mut ay = *ay => found.0.linear.y,
            mut az = *az => found.0.linear.z,
            mut bx = *bx => found.0.angular.x,
            mut by = *by => found.0.angular.y,
            mut bz = *bz => found.0.angular.z
        );
    }
}
