//! The costate sweep in space: hinges with linear springs.
//!
//! The outboard point O is at d = E s from I in the axes E of the inboard body, which turns with ω, α and w, and turns there as in an
//! [elastic ball](super::elastic_ball). With u = E ṡ, and G and F at O those of the point mass μ there included,
//!
//! ```text
//! A_O = A_I + α × d + ω × (ω × d) + 2 ω × u + E s̈        W_O = W_I + w × d + E w_s
//!
//! Θ ← Θ + F × (W_O − W_I) + G × (A_O − A_I)        M ← M + d × F        H ← H + d × G        Ω ← Ω + ∂/∂ω G·A_O
//! s̄ = −Eᵀ [G × α + ω (ω·G) − ω² G + F × w]        ṡ̄ = −2 Eᵀ (G × ω)        μ̄ = −A_O·W_O
//! ```
//!
//! as of three [slides](super::steps) in a row.

use super::inertial::swept;
use super::rotary::{HingeRule, ReversibleRotary, add, strain};
use super::{Felt, OfJoint, Outboard, Pulled, Stirred, Turning};
use crate::adjoint::BodyLaw;
use crate::adjoint::laws::{self, ReversibleLaw};
use crate::element::{Element, Reading};
use crate::mechanics::spatial::elastic_hinge::Place;
use crate::mechanics::spatial::{Acceleration, ElasticHinge, Joint, Linear, Spatial, Turn, Wrench};
use crate::relation::Closures;
use crate::relation::spatial::algebra::{add_scaled, centripetal, cross, cross_onto, dot};
use crate::relation::spatial::{BallGain, Gain, Relation};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Burden, Factor, Led, Meet, Orient, PullBack, PullLoads, Reach, Stir, Strain};
use nalgebra::Vector3;

/// Most numbers of each law along an axis.
pub(crate) const ALONG: usize = 3;

impl<T: Scalar> OfJoint<T> {
    /// Costates of the numbers of laws along three axes.
    pub(crate) fn of_linear(&mut self) -> [&mut [T]; 3] {
        let (one, rest) = self.linear.split_at_mut(ALONG);
        let (two, three) = rest.split_at_mut(ALONG);
        [one, two, three]
    }
}

/// What each law does along its axis.
macro_rules! each_law {
    ($linear:expr, $sums:expr, |$k:ident, $law:ident, $own:ident| $does:expr) => {{
        let [one, two, three] = $sums.of_linear();
        {
            let ($k, $law, $own) = (0, &$linear.x, one);
            $does;
        }
        {
            let ($k, $law, $own) = (1, &$linear.y, two);
            $does;
        }
        {
            let ($k, $law, $own) = (2, &$linear.z, three);
            $does;
        }
    }};
}

/// What hinges with linear springs do in a walk.
macro_rules! takes {
    ([$($bounds:tt)*] $Walk:ty, |$hinge:ident, $walk:ident, $carried:ident: $Carried:ty, $stores:pat_param| $does:expr) => {
        impl<T, R, X, Y, Z, $($bounds)*> Takes<Spatial<T>, $Walk> for ElasticHinge<R, Linear<T, X, Y, Z>>
        where
            T: Scalar,
            R: ReversibleRotary<T>,
            X: ReversibleLaw<T>,
            Y: ReversibleLaw<T>,
            Z: ReversibleLaw<T>,
        {
            fn take(&self, $walk: &mut $Walk, $carried: $Carried, $stores: Of<'_, Spatial<T>, $Walk, Self>) -> $Carried {
                let $hinge = self;
                $does
            }
        }
    };
}

takes!([] Orient, |hinge, _walk, turn: Turn<T>, (position, rate, x, y, p, q)| hinge.orient(position, rate, turn, x, y, p, q));

takes!([C: Closures, By: HingeRule<T>] Factor<C, By>, |hinge, walk, outer: Outboard<T, C>,
    ([outboard, inboard], [[linear, bias], [arm, _]], .., (position, rate, led), torque, kept, pivot)| {
    let reading = Reading { position: &led.0.1, rate: &led.1.1, acceleration: &led.2.1 };
    let place = Place { attitude: *outboard, state: (&position.1, &rate.1), reading };
    let torque = outboard.apply(Vector3::from(torque.0));
    let outer = Outboard { relation: outer.relation.with_mass(hinge.linear.lumped()), ..outer };
    let turned: Outboard<T, C>;
    (turned, kept.rotation, *pivot) = walk.springs.turned_out(outer, &hinge.rotary, torque, place, *bias);
    // Laws that are not linear are read where the last sweep has led.
    let follows = const { !(X::LINEAR && Y::LINEAR && Z::LINEAR) && By::STIFF };
    let (place, sliding) = if follows { (led.0.0, led.1.0) } else { (position.0, rate.0) };
    let (force, led) = (hinge.linear.force(place, sliding), follows.then(|| Vector3::from(led.2.0)));
    let pivots = |springs| hinge.linear.pivots(place, sliding, springs);
    let relation;
    (relation, kept.displacement, kept.factor) = walk.springs.slid_out(turned.relation, inboard, force, led, pivots);
    Outboard::rigid(relation.carried(*arm, *linear))
});

takes!([C: Closures] Reach<T, C>, |hinge, walk, inner: Acceleration<T>,
    (x, y, .., kept, acceleration, (_, reached, _))| {
    let outer = Joint::recovered(hinge, inner, (x, y), kept, &walk.forces, acceleration);
    *reached = outer.linear;
    outer
});

takes!([C: Closures] Meet<T, C>, |_hinge, walk, outer: Wrench<T>,
    ([outboard, inboard], [_, [arm, _]], .., kept, pivot, costate, _)| {
    let mut met = outer;
    let mut meet = |gain: &BallGain<T, C>, left: Vector3<T>| {
        walk.part_along(&gain.absolute.per_closure, left);
        met.force -= gain.absolute.per_acceleration.transposed(left);
        met.torque -= gain.per_angular.transposed(left);
        met.force
    };
    let left = outboard.apply(Vector3::from(costate.1)) - outer.torque;
    costate.1 = pivot.factor.solve(left).into();
    let force = meet(&kept.rotation, left);
    let left = inboard.apply(Vector3::from(costate.0)) - force;
    costate.0 = kept.factor.solve(left).into();
    meet(&kept.displacement, left);
    Wrench { torque: cross_onto(*arm, met.force, met.torque), ..met }
});

takes!([C: Closures] Burden<T, C>, |hinge, walk, outer: Wrench<T>, (x, y, p, q, (), kept, pivot)| {
    let mut more = ([T::zero(); 3], [T::zero(); 3]);
    let inner = hinge.take(&mut walk.0, outer, (x, y, p, q, &*kept, pivot, &mut more, &mut ()));
    kept.displacement.absolute.free += Vector3::from(more.0);
    kept.rotation.absolute.free += Vector3::from(more.1);
    inner
});

takes!([C: Closures] Stir<T, C>, |_hinge, walk, inner: Stirred<T>,
    ([outboard, inboard], [[_, bias], [arm, _]], .., kept, (_, rate, acceleration, free), ((), met, _), torque)| {
    let Stirred { velocity, turning: Turning { spin, acceleration: turning, stirring } } = inner;
    let moved = |gain: &BallGain<T, C>, free: [T; 3], linear: Vector3<T>| {
        let gain = BallGain { absolute: Gain { free: Vector3::from(free), ..gain.absolute }, ..*gain };
        gain.relative(linear, stirring, &walk.forces)
    };
    let carried = cross_onto(stirring, *arm, velocity);
    let slid = moved(&kept.displacement, free.0, carried);
    let velocity = carried + slid;
    let turned = moved(&kept.rotation, free.1, velocity);
    *free = (inboard.transposed(slid).into(), outboard.transposed(turned).into());
    add(&mut torque.0, free.1);
    met.velocity = velocity;
    met.turning = inner.turning;
    let [rate, acceleration] = [rate.1, acceleration.1].map(|list| outboard.apply(Vector3::from(list)));
    let turning = Turning { spin: spin + rate, acceleration: turning + *bias + acceleration, stirring: stirring + turned };
    Stirred { velocity, turning }
});

takes!([] PullBack, |hinge, walk, outer: Pulled<T>,
    ([outboard, inboard], [_, [d, u]], .., (position, rate, acceleration, own), (_, a, _, met, ..), (_, sums), (of_position, of_rate))| {
    let (inner, mass) = (met.turning, hinge.linear.lumped());
    sums.more[0] -= dot(*a, met.velocity);
    // The turn, as in an elastic ball.
    let turned = outboard.apply(Vector3::from(rate.1));
    let momentum = add_scaled(outer.momentum, mass, met.velocity);
    let force = add_scaled(outer.force, mass, *a);
    let spin = cross_onto(turned, outer.angular, outer.spin);
    let at = Pulled { momentum, force, spin, ..outer };
    let of_turn = [at.turned(inner), -cross_onto(outer.angular, inner.spin, outer.spin)].map(|sum| outboard.transposed(sum));
    // The displacement.
    let Turning { spin, acceleration: turning, stirring } = inner;
    let sliding = *u + *u;
    let [b, c] = [acceleration.0, own.0].map(|list| inboard.apply(Vector3::from(list)));
    let moved = cross_onto(spin, sliding, cross_onto(turning, *d, centripetal(spin, *d))) + b;
    let reach = add_scaled(cross(momentum, turning) + spin * dot(spin, momentum), -dot(spin, spin), momentum);
    let whirled = cross(momentum, spin);
    let of_slide = [-cross_onto(force, stirring, reach), -(whirled + whirled)].map(|sum| inboard.transposed(sum));
    [of_position.0, of_rate.0] = of_slide.map(Into::into);
    [of_position.1, of_rate.1] = of_turn.map(Into::into);
    if walk.laws {
        let [turn, turning, of_law @ ..] = hinge.rotary.pull_back(&position.1, &rate.1, &own.1);
        sums.add_rotary(&of_law);
        add(&mut of_position.1, turn);
        add(&mut of_rate.1, turning);
        each_law!(hinge.linear, sums, |k, law, own_sums| {
            let [of, of_speed] = law.pull_back(position.0[k], rate.0[k], own.0[k], own_sums);
            of_position.0[k] += of;
            of_rate.0[k] += of_speed;
        });
    }
    Pulled {
        turn: cross_onto(force, cross_onto(stirring, *d, c), cross_onto(momentum, moved, at.turn)),
        torque: cross_onto(*d, force, at.torque),
        angular: cross_onto(*d, momentum, at.angular),
        spin: swept(spin, *d, momentum, cross_onto(sliding, momentum, at.spin)),
        ..at
    }
});

takes!([] Strain<T>, |hinge, walk, _carried: (), (position, rate, w, sums, of_position, of_rate, led, of_led)| {
    let at = (&led.0.1, &led.1.1, &led.2.1);
    let [q, v, a] = strain(&hinge.rotary, walk, at, &w.1, sums);
    add(&mut of_led.0.1, q);
    add(&mut of_led.1.1, v);
    add(&mut of_led.2.1, a);
    let follows = const { !(X::LINEAR && Y::LINEAR && Z::LINEAR) };
    each_law!(hinge.linear, sums, |k, law, own_sums| {
        let there: Led<T> = [led.0.0[k], led.1.0[k], led.2.0[k]];
        let at = ([position.0[k], rate.0[k], w.0[k]], there);
        let ([of, of_speed], [q, v, a]) = laws::strain(follows, law, walk, at, own_sums);
        of_position.0[k] += of;
        of_rate.0[k] += of_speed;
        of_led.0.0[k] += q;
        of_led.1.0[k] += v;
        of_led.2.0[k] += a;
    });
});

takes!([L: BodyLaw<Spatial<T>>] PullLoads<L, Spatial<T>>, |_hinge, _walk, outer: Felt<T>,
    ([outboard, inboard], [_, [d, u]], .., (_, _, own), (.., met, _), _, (of_position, of_rate))| {
    let Turning { spin, stirring, .. } = met.turning;
    add(&mut of_position.1, outboard.transposed(outer.turned_under::<L>(&met.turning)));
    add(&mut of_rate.1, outboard.transposed(outer.spin));
    let Felt { place, velocity, stirring: force, .. } = outer;
    let c = inboard.apply(Vector3::from(own.0));
    let mut of_slide = place - cross(spin, velocity);
    let mut turn = cross_onto(*d, place, cross_onto(cross_onto(spin, *d, *u), velocity, outer.turn));
    if const { L::ON } {
        of_slide -= cross(stirring, force);
        turn = cross_onto(cross_onto(stirring, *d, c), force, turn);
    }
    add(&mut of_position.0, inboard.transposed(of_slide));
    add(&mut of_rate.0, inboard.transposed(velocity));
    let (spin, torque) = (cross_onto(*d, velocity, outer.spin), cross_onto(*d, force, outer.torque));
    Felt { turn, spin, torque, ..outer }
});
