//! The costate sweep in body axes: what links do.
//!
//! With W, A of the origin, ω, α, w, mass m, first moment σ and tensor J about the origin
//!
//! ```text
//! F ← F + m A + α × σ + ω × (ω × σ)        M ← M + σ × A + J α + ω × J ω
//! G ← G + m W + w × σ                      H ← H + σ × W + J w
//! Ω ← Ω + σ (ω·W) + W (ω·σ) − 2 ω (σ·W) + J ω × w + J (w × ω)
//! m̄ = −A·W        σ̄ = −[W × α + ω (ω·W) − ω² W + A × w]        J̄ = −sym(w αᵀ + (w × ω) ωᵀ)
//! ```

use super::super::link::Link;
use super::super::number::{
    Number, Triple, apply, apply_onto, cross_onto, dot_onto, rows, triangle_values, triple, values,
};
use super::super::relation::Local;
use super::super::through::Solid;
use super::swept_known;
use crate::adjoint::{Reversed, ReversibleLoads, unless_rows};
use crate::element::{Element, Springs};
use crate::mechanics::spatial::adjoint::{BODY, Base, Felt, OnBody, Outboard, Pulled, Stirred, Turning, per_vector};
use crate::mechanics::spatial::{Acceleration, Inertia, Spatial, Turn, Wrench};
use crate::relation::Closures;
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Burden, Factor, Meet, Orient, PullBack, PullLoads, Reach, Stir, Strain};
use nalgebra::Vector3;

/// What costates know of a link.
pub fn base<T: Scalar, const MOMENT: u8, const TENSOR: u8>(link: &Link<T, MOMENT, TENSOR>) -> Base<T> {
    let [xx, yy, zz, yz, xz, xy] = triangle_values(link.tensor());
    Base { moment: values(link.moment()), inertia: [xx, xy, xz, yy, yz, zz], lumped: link.mass(), ..Base::null() }
}

/// The numbers of a link that loads read: it has no outboard end.
pub fn numbers<T: Scalar, const MOMENT: u8, const TENSOR: u8>(link: &Link<T, MOMENT, TENSOR>) -> [T; BODY] {
    let Inertia { mass, centre: [a, b, c], about_centre: [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] } = link.inertia();
    let o = T::zero();
    [o, o, o, mass, a, b, c, xx, xy, xz, yx, yy, yz, zx, zy, zz]
}

/// What a link does in a walk.
macro_rules! takes {
    ([$($bounds:tt)*] $Walk:ty, |$link:ident, $walk:ident, $carried:ident: $Carried:ty, $stores:pat_param| $does:expr) => {
        impl<T: Scalar, const MOMENT: u8, const TENSOR: u8, $($bounds)*> Takes<Spatial<T>, $Walk>
            for Link<T, MOMENT, TENSOR>
        {
            #[cfg_attr(optimised, inline(always))]
            fn take(&self, $walk: &mut $Walk, $carried: $Carried, $stores: Of<'_, Spatial<T>, $Walk, Self>) -> $Carried {
                let $link = self;
                $does
            }
        }
    };
}

takes!([] Orient, |link, _walk, turn: Turn<T>, (position, rate, x, y, p, q)| link.orient(position, rate, turn, x, y, p, q));

takes!([C: Closures, By: Springs<T>] Factor<C, By>, |link, _walk, outer: Outboard<T, C>, (_, y, ..)| {
    let [force, torque] = [y[0], y[1]];
    // Without a first moment no force is stored.
    let force = if MOMENT & 7 == 0 { [T::zero(); 3] } else { force.into() };
    Outboard::rigid(Local::of_own(&outer.relation).with(link.alone([force, torque.into()])).full())
});

takes!([C: Closures] Reach<T, C>, |_link, _walk, inner: Acceleration<T>, (.., (reached, (), ()))| {
    *reached = inner.linear;
    inner
});

takes!([C: Closures] Meet<T, C>, |_link, _walk, outer: Wrench<T>, _| outer);

takes!([C: Closures] Stir<T, C>, |_link, _walk, inner: Stirred<T>, (.., (met, (), _), _)| {
    *met = OnBody { velocity: inner.velocity, turning: inner.turning };
    inner
});

takes!([] PullBack, |link, _walk, outer: Pulled<T>, (_, posture, .., (a, (), met, ..), (sums, ()), _)| {
    let (mut unread, ..) = Spatial::of_nothing();
    let sums = unless_rows::<T, _>(sums, &mut unread);
    let Turning { spin, acceleration, stirring } = met.turning;
    let (none, vector) = ([Number::zero(); 3], |v: Triple<T>| Vector3::from(values(v)));
    // One by one: what a loop reads is not known by type.
    let (w, a) = (triple(met.velocity.into()), triple((*a).into()));
    let (spin, acceleration, stirring) = (triple(spin.into()), triple(acceleration.into()), triple(stirring.into()));
    let (moment, tensor) = (link.moment(), link.tensor());
    // What inertia makes of both motions.
    let still = if MOMENT & 7 == 0 { none } else { triple(posture[0].into()) };
    let [force, torque] = link.resisted([a, acceleration], [still, triple(posture[1].into())]);
    let [momentum, angular] = link.resisted([w, stirring], [none; 2]);
    // J ω × w + J (w × ω).
    let gyration = cross_onto(stirring, spin, none);
    let turned = apply_onto(&rows(&tensor), gyration, cross_onto(apply(&rows(&tensor), spin), stirring, none));
    // Costates of the numbers that there are.
    sums.lumped -= dot_onto(a, w, Number::zero()).value();
    macro_rules! take {
        ($($sum:ident: $mask:ident, $bit:literal, $by:expr;)*) => {$(if const { $mask >> $bit & 1 == 1 } { *$sum -= $by })*};
    }
    let by_moment = per_vector(&met.turning, met.velocity, vector(a));
    let [x, y, z] = &mut sums.moment;
    take! { x: MOMENT, 0, by_moment.x; y: MOMENT, 1, by_moment.y; z: MOMENT, 2, by_moment.z; }
    let own = |i: usize| gyration[i].times_onto(spin[i], stirring[i].times(acceleration[i])).value();
    let both = |i: usize, j: usize| {
        let one = gyration[i].times_onto(spin[j], stirring[i].times(acceleration[j]));
        gyration[j].times_onto(spin[i], stirring[j].times_onto(acceleration[i], one)).value()
    };
    let [xx, xy, xz, yy, yz, zz] = &mut sums.inertia;
    take! {
        xx: TENSOR, 0, own(0); yy: TENSOR, 1, own(1); zz: TENSOR, 2, own(2);
        yz: TENSOR, 3, both(1, 2); xz: TENSOR, 4, both(0, 2); xy: TENSOR, 5, both(0, 1);
    }
    Pulled {
        momentum: outer.momentum + vector(momentum),
        force: outer.force + vector(force),
        turn: outer.turn,
        torque: outer.torque + vector(torque),
        angular: outer.angular + vector(angular),
        spin: swept_known(met.turning.spin, moment, w, outer.spin + vector(turned)),
    }
});

takes!([C: Closures] Burden<T, C>, |_link, _walk, outer: Wrench<T>, (.., (frame, load), _, _)| {
    let axes = &frame.turn.attitude;
    Wrench {
        force: outer.force - axes.transposed(load.force),
        torque: outer.torque - axes.transposed(load.torque),
    }
});

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> Takes<Spatial<T>, Strain<T>> for Link<T, MOMENT, TENSOR> {
    fn take(&self, _: &mut Strain<T>, (): (), _: Of<'_, Spatial<T>, Strain<T>, Self>) {}
}

impl<T: Scalar, L: ReversibleLoads<Spatial<T>>, const MOMENT: u8, const TENSOR: u8>
    Takes<Spatial<T>, PullLoads<L, Spatial<T>>> for Link<T, MOMENT, TENSOR>
{
    fn take(
        &self,
        walk: &mut PullLoads<L, Spatial<T>>,
        outer: Felt<T>,
        (.., ((frame, _), met, ..), (sums, ()), _): Of<'_, Spatial<T>, PullLoads<L, Spatial<T>>, Self>,
    ) -> Felt<T> {
        if const { !L::ON } {
            return outer;
        }
        walk.body = walk.body.saturating_sub(1);
        let axes = &frame.turn.attitude;
        let stirred = (axes.apply(met.velocity), axes.apply(met.turning.stirring));
        let more = L::felt(walk, numbers(self), frame, stirred, sums);
        let own = |v: Vector3<T>| axes.transposed(v);
        Felt {
            place: outer.place + own(more.place),
            velocity: outer.velocity + own(more.velocity),
            stirring: outer.stirring + own(more.stirring),
            turn: outer.turn + own(more.turn),
            spin: outer.spin + own(more.spin),
            torque: outer.torque + own(more.torque),
        }
    }
}
