//! The costate sweep in body axes: what links do.
//!
//! The mass at the origin is to the way there what a [body](crate::mechanics::spatial::adjoint) has at its outboard end; first moment and
//! tensor are as there.

use super::super::link::Link;
use super::super::number::{triangle_values, values};
use super::super::relation::Local;
use super::super::through::Solid;
use crate::element::{Element, Springs};
use crate::lift::Lift;
use crate::loading::{Load, LoadLaw};
use crate::mechanics::spatial::adjoint::{
    BODY, Base, Felt, OnBody, Outboard, Pulled, Read, Stirred, Turning, per_vector, read, swept,
};
use crate::mechanics::spatial::{Acceleration, BodyMotion, Inertia, Spatial, Turn, Wrench};
use crate::relation::Closures;
use crate::relation::spatial::algebra::{Symmetric3, add_scaled, cross, cross_onto, dot};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::burden::Burden;
use crate::walks::factor::Factor;
use crate::walks::meet::Meet;
use crate::walks::orient::Orient;
use crate::walks::pull_back::PullBack;
use crate::walks::pull_loads::PullLoads;
use crate::walks::reach::Reach;
use crate::walks::stir::Stir;
use crate::walks::strain::Strain;
use nalgebra::Vector3;

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> Link<T, MOMENT, TENSOR> {
    /// First moment, and tensor about the origin.
    fn moments(&self) -> (Vector3<T>, Symmetric3<T>) {
        let [xx, yy, zz, yz, xz, xy] = triangle_values(self.tensor());
        (Vector3::from(values(self.moment())), Symmetric3 { xx, xy, xz, yy, yz, zz })
    }
}

/// What costates know of a link.
pub fn base<T: Scalar, const MOMENT: u8, const TENSOR: u8>(link: &Link<T, MOMENT, TENSOR>) -> Base<T> {
    let (moment, Symmetric3 { xx, xy, xz, yy, yz, zz }) = link.moments();
    Base { moment: moment.into(), inertia: [xx, xy, xz, yy, yz, zz], lumped: link.mass(), ..Base::null() }
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

takes!([] PullBack, |link, _walk, outer: Pulled<T>, (.., (a, (), met, ..), (sums, ()), _)| {
    let (w, a, turning) = (met.velocity, *a, &met.turning);
    let Turning { spin, acceleration, stirring } = *turning;
    let (moment, inertia) = link.moments();
    sums.lumped -= dot(a, w);
    sums.moment = (Vector3::from(sums.moment) - per_vector(turning, w, a)).into();
    let moved = cross_onto(acceleration, moment, cross(spin, cross(spin, moment)));
    let stirred = cross(stirring, moment);
    let [torque, angular, turned] = turning.pull_inertia(&inertia, &mut sums.inertia);
    Pulled {
        momentum: add_scaled(outer.momentum + stirred, link.mass(), w),
        force: add_scaled(outer.force + moved, link.mass(), a),
        turn: cross_onto(w, moved, cross_onto(a, stirred, outer.turn)),
        torque: cross_onto(moment, a, torque + outer.torque),
        angular: cross_onto(moment, w, angular + outer.angular),
        spin: swept(spin, moment, w, turned + outer.spin),
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

impl<T: Scalar, L, const MOMENT: u8, const TENSOR: u8> Takes<Spatial<T>, PullLoads<L, T>> for Link<T, MOMENT, TENSOR>
where
    L: LoadLaw<BodyMotion<T>> + Lift<T, Read<T>, Over: LoadLaw<BodyMotion<Read<T>>, Value: Load<Spatial<Read<T>>>>>,
{
    fn take(
        &self,
        walk: &mut PullLoads<L, T>,
        outer: Felt<T>,
        (.., ((frame, _), met, ..), (sums, ()), _): Of<'_, Spatial<T>, PullLoads<L, T>, Self>,
    ) -> Felt<T> {
        if const { !L::ON } {
            return outer;
        }
        walk.body = walk.body.saturating_sub(1);
        let axes = &frame.turn.attitude;
        let turning = met.turning.mapped(|v| axes.apply(v));
        let more = read(numbers(self), frame, (axes.apply(met.velocity), &turning), walk, sums);
        let own = |v: Vector3<T>| axes.transposed(v);
        Felt {
            place: outer.place + own(more.place),
            velocity: outer.velocity + own(more.velocity),
            stirring: outer.stirring + own(more.load.force),
            turn: outer.turn + own(more.turn),
            spin: outer.spin + own(more.spin),
            torque: outer.torque + own(more.load.torque),
        }
    }
}
