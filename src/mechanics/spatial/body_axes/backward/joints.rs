//! The costate sweep in body axes: what hinges and slides do.
//!
//! The coordinate is that of a [revolute joint or a slide](crate::mechanics::spatial::adjoint) along z. Inboard of it motions are those of
//! the parent: in its axes the offset turns all that lies outboard, as a weld does, and the place of the joint is an arm of the parent.
//! Of reflected inertia I, whose force is −I q̈, P has the share I q̈ q̇_w. A hinge's costate is
//!
//! ```text
//! q̄ = z·(Δ + W × F + A × G + w × M + α × H + ω × Ω)
//! ```

use super::super::axis::{Armature, Axis, Bearing, Mode};
use super::super::number::{Number, Triple, cross_onto, sum, triple, values};
use super::super::relation::Local;
use super::super::standing::{Stand, Standing};
use super::super::turns::Offset;
use super::swept_known;
use crate::adjoint::laws::{ReversibleLaw, force, strain};
use crate::adjoint::{BodyLaw, Reversed, unless_rows};
use crate::element::{Element, Springs};
use crate::mechanics::spatial::adjoint::{Felt, Outboard, Pulled, Step, Stirred, Turning, per_vector};
use crate::mechanics::spatial::{Acceleration, Spatial, Turn, Wrench};
use crate::relation::Closures;
use crate::relation::spatial::algebra::{Columns, add_scaled, dot_onto, zero};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Burden, Factor, Meet, Orient, PullBack, PullLoads, Reach, Stir, Strain};
use nalgebra::Vector3;

/// A coordinate along or about z.
fn step<T: Scalar>(rate: T, acceleration: T, own: T) -> Step<T> {
    let z = Vector3::new(T::zero(), T::zero(), T::one());
    Step { axes: Columns { x: z, y: zero(), z: zero() }, rate, acceleration, own }
}

/// From the origin of the parent's joint to that of the body, in axes of the body: what a slide has slid.
fn slid<T: Scalar>(position: T) -> Vector3<T> {
    Vector3::new(T::zero(), T::zero(), position)
}

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: ReversibleLaw<T>, A: Armature<T>, B: Bearing>
    Axis<T, M, C, PLACE, L, A, B>
{
    /// A vector of the body's axes in those of the parent.
    fn in_parent(&self, stand: Stand<T>, v: Vector3<T>) -> Vector3<T> {
        Vector3::from(values(self.outward(stand, triple(v.into()))))
    }

    /// A rotation vector of the body's axes in those that they have while the angle is zero.
    fn of_offset(&self, [sine, cosine]: Stand<T>, v: Vector3<T>) -> Vector3<T> {
        if const { !M::TURNS } {
            return v;
        }
        Vector3::new(cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z)
    }
}

/// What a joint in body axes does in a walk.
macro_rules! takes {
    ([$($bounds:tt)*] $Walk:ty, |$joint:ident, $walk:ident, $carried:ident: $Carried:ty, $stores:pat_param| $does:expr) => {
        impl<T, M, C, const PLACE: u8, L, A, B, $($bounds)*> Takes<Spatial<T>, $Walk> for Axis<T, M, C, PLACE, L, A, B>
        where
            T: Scalar,
            M: Mode,
            C: Offset<T>,
            L: ReversibleLaw<T>,
            A: Armature<T>,
            B: Bearing,
        {
            #[cfg_attr(optimised, inline(always))]
            fn take(&self, $walk: &mut $Walk, $carried: $Carried, $stores: Of<'_, Spatial<T>, $Walk, Self>) -> $Carried {
                let $joint = self;
                $does
            }
        }
    };
}

takes!([] Orient, |joint, _walk, turn: Turn<T>, (position, rate, x, y, p, q)| joint.orient(position, rate, turn, x, y, p, q));

takes!([Q: Closures, By: Springs<T>] Factor<Q, By>, |joint, walk, outer: Outboard<T, Q>,
    (x, y, .., (position, rate, led), torque, kept, pivot)| {
    let (stand, [swung, bias]) = Self::posture(x, y);
    let at = [*position, *rate];
    let [of_law, stiffness] = force(&joint.law, at, [*led.0, *led.1, *led.2], walk.springs);
    let more = if const { By::STIFF } { joint.inertia().plus(Number::of(stiffness)) } else { joint.inertia() };
    let stiffened = const { A::ON || By::STIFF };
    let outer = Local::of_own(&outer.relation);
    let effort = torque.0[0] + of_law;
    let (relation, cuts, inverse) = Self::loose(outer, effort, more, bias, (kept, stiffened));
    pivot.factor.set_number(inverse);
    Outboard::rigid(joint.at_parent(relation.at_joint(M::TURNS, stand), cuts, (stand, swung)).full())
});

takes!([Q: Closures] Reach<T, Q>, |joint, walk, inner: Acceleration<T>,
    (x, y, .., kept, acceleration, (_, reached, _))| {
    let (stand, [swung, bias]) = Self::posture(x, y);
    let p = [triple(inner.linear.into()), triple(inner.angular.into())];
    let p = joint.accelerated(stand, [Self::known_swung(swung), bias], p);
    let free = Q::plus_dot(kept.gains.free, &kept.per_closure, &walk.forces);
    let outer = joint.released(p, &kept.gains, free, true, acceleration);
    *reached = outer.linear;
    outer
});

takes!([Q: Closures] Meet<T, Q>, |joint, walk, outer: Wrench<T>, (x, y, .., kept, pivot, costate, _)| {
    let (stand, _) = Self::posture(x, y);
    let left = *costate - if M::TURNS { outer.torque.z } else { outer.force.z };
    *costate = left * pivot.factor.number();
    walk.part(&kept.per_closure, left);
    let force = outer.force + Vector3::from(kept.gains.linear) * left;
    let torque = outer.torque + Vector3::from(kept.gains.angular) * left;
    let [force, torque] = joint.carried(stand, [triple(force.into()), triple(torque.into())]);
    Wrench { force: Vector3::from(values(force)), torque: Vector3::from(values(torque)) }
});

takes!([Q: Closures] Stir<T, Q>, |joint, walk, inner: Stirred<T>,
    (x, y, .., kept, (_, rate, acceleration, free), ((), met, _), torque)| {
    let (stand, [_, bias]) = Self::posture(x, y);
    let (none, Turning { spin, acceleration: turning, stirring }) = ([Number::zero(); 3], inner.turning);
    let p = [triple(inner.velocity.into()), triple(stirring.into())];
    let p = joint.accelerated(stand, [none; 2], p);
    let mut own = Q::plus_dot(*free, &kept.per_closure, &walk.forces);
    let outer = joint.released(p, &kept.gains, own, true, &mut own);
    torque.0[0] += own;
    *free = own;
    let mut turned = joint.inward(stand, triple(turning.into()));
    if const { M::TURNS } {
        turned = sum(turned, [bias[0], bias[1], Number::of(*acceleration)]);
    }
    let spin = Vector3::from(joint.spun(stand, *rate, spin.into()));
    met.velocity = outer.linear;
    met.turning = Turning { spin, acceleration: Vector3::from(values(turned)), stirring: outer.angular };
    Stirred { velocity: met.velocity, turning: met.turning }
});

takes!([] PullBack, |joint, walk, outer: Pulled<T>,
    (x, y, _, _, (position, rate, acceleration, own), (_, a, _, met, _, _), (_, sums), (of_position, of_rate))| {
    let (_, _, mut unread) = Spatial::of_nothing();
    let sums = unless_rows::<T, _>(sums, &mut unread);
    let (stand, _) = Self::posture(x, y);
    let (mut carried, mut turning, step) = (outer, met.turning, step(*rate, *acceleration, *own));
    let [by_law, by_rate] =
        if walk.laws { joint.law.pull_back(*position, *rate, *own, &mut sums.law) } else { [T::zero(); 2] };
    let ([of, of_speed], [velocity, a]) = if const { M::TURNS } {
        let of = carried.in_own(met.velocity, *a, &turning).z;
        let beside = Vector3::new(-carried.angular.y, carried.angular.x, T::zero());
        let of_speed = -dot_onto(turning.spin, beside, carried.spin.z);
        carried.spin = add_scaled(carried.spin, *rate, beside);
        turning = step.before(turning);
        ([of, of_speed], [met.velocity, *a])
    } else {
        let arm = slid(*position);
        let (of, _) = step.slid(*position, arm, &mut carried, &turning);
        carried.turn = outer.turn; // axes do not turn
        (of, step.before_slide(arm, [met.velocity, *a], &turning))
    };
    (*of_position, *of_rate) = (by_law + of, by_rate + of_speed);
    if const { A::ON } {
        sums.more[0] -= *acceleration * *own;
    }
    if const { C::NUMBERED } {
        sums.turn += joint.of_offset(stand, carried.in_own(velocity, a, &turning));
    }
    let carried = carried.mapped(|v| joint.in_parent(stand, v));
    if const { PLACE & 7 == 0 } {
        return carried;
    }
    let turning = turning.mapped(|v| joint.in_parent(stand, v));
    let (g, f) = (triple(carried.momentum.into()), triple(carried.force.into()));
    let by_place = per_vector(&turning, carried.momentum, carried.force);
    macro_rules! take {
        ($($axis:ident: $bit:literal),*) => {$(if const { PLACE >> $bit & 1 == 1 } { sums.place.$axis -= by_place.$axis })*};
    }
    take!(x: 0, y: 1, z: 2);
    let vector = |v: Triple<T>| Vector3::from(values(v));
    Pulled {
        torque: vector(cross_onto(joint.arm(), f, triple(carried.torque.into()))),
        angular: vector(cross_onto(joint.arm(), g, triple(carried.angular.into()))),
        spin: swept_known(turning.spin, joint.arm(), g, carried.spin),
        ..carried
    }
});

takes!([N: BodyLaw<Spatial<T>>] PullLoads<N, Spatial<T>>, |joint, _walk, outer: Felt<T>,
    (x, y, _, _, (position, rate, own), (.., met, _), (_, sums), (of_position, of_rate))| {
    let (stand, _) = Self::posture(x, y);
    let (mut felt, mut turning, step) = (outer, met.turning, step(*rate, T::zero(), *own));
    let (of, _) = if const { M::TURNS } {
        let found = step.turned_felt::<N>(&felt, &turning);
        turning = step.before(turning);
        found
    } else {
        step.slid_felt(*position, slid(*position), &mut felt, &turning)
    };
    (*of_position, *of_rate) = (*of_position + of[0], *of_rate + of[1]);
    sums.turn += joint.of_offset(stand, felt.turned_under::<N>(&turning));
    let felt = felt.mapped(|v| joint.in_parent(stand, v));
    let turning = turning.mapped(|v| joint.in_parent(stand, v));
    felt.over(Vector3::from(values(joint.arm())), &turning, &mut sums.place)
});

takes!([Q: Closures] Burden<T, Q>, |joint, walk, outer: Wrench<T>, (x, y, p, q, (), kept, pivot)| {
    let mut more = T::zero();
    let inner = joint.take(&mut walk.0, outer, (x, y, p, q, &*kept, pivot, &mut more, &mut ()));
    kept.gains.free += more;
    inner
});

takes!([] Strain<T>, |joint, walk, _carried: (), (position, rate, w, sums, of_position, of_rate, led, of_led)| {
    let at = ([*position, *rate, *w], [*led.0, *led.1, *led.2]);
    let ([more, also], [q, v, a]) = strain(const { !L::LINEAR }, &joint.law, walk, at, &mut sums.law);
    (*of_position, *of_rate) = (*of_position + more, *of_rate + also);
    if const { !L::LINEAR } {
        (*of_led.0, *of_led.1, *of_led.2) = (*of_led.0 + q, *of_led.1 + v, *of_led.2 + a);
    }
});

/// What a joint has, as costates know it: its offset's axes, what is added to its angle, its place, its reflected inertia.
pub fn parts<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L, A: Armature<T>, B: Bearing>(
    joint: &Axis<T, M, C, PLACE, L, A, B>,
) -> (Columns<T>, T, Vector3<T>, T, &L) {
    let [x, y, z] = joint.offset.rows().map(values);
    let column = |k: usize| Vector3::new(x[k], y[k], z[k]);
    let axes = Columns { x: column(0), y: column(1), z: column(2) };
    let ahead = joint.offset.ahead().value();
    (axes, ahead, Vector3::from(joint.place), joint.armature.number().value(), &joint.law)
}
