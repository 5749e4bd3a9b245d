//! The costate sweep in space: what the joint of a chain that floats does.
//!
//! Nothing that lies inboard of it moves: S (W, w) = (λ, A λ_ω) is solved for all of the virtual velocity, first for the turn, then for the
//! place. The attitude turns all that has been met since the last balls, as that of a [ball](super::ball) does, and no torque acts. The place
//! and its rate do nothing but where loads read them.

use super::{Felt, Outboard, Pulled, Stirred, Turning};
use crate::adjoint::BodyLaw;
use crate::element::{Element, Springs};
use crate::mechanics::spatial::{Acceleration, Floating, Spatial, Turn, Wrench};
use crate::relation::spatial::Relation;
use crate::relation::spatial::algebra::{add_scaled, dot, zero};
use crate::relation::{Additive, Open};
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Burden, Factor, Meet, Orient, PullBack, PullLoads, Reach, Stir};
use nalgebra::Vector3;

impl<T: Scalar> Takes<Spatial<T>, Orient> for Floating<T> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Orient,
        turn: Turn<T>,
        (position, rate, x, y, p, q): Of<'_, Spatial<T>, Orient, Self>,
    ) -> Turn<T> {
        self.orient(position, rate, turn, x, y, p, q)
    }
}

impl<T: Scalar, By: Springs<T>> Takes<Spatial<T>, Factor<Open, By>> for Floating<T> {
    fn take(
        &self,
        _: &mut Factor<Open, By>,
        outer: Outboard<T>,
        (.., kept, _): Of<'_, Spatial<T>, Factor<Open, By>, Self>,
    ) -> Outboard<T> {
        let relation = outer.relation.with_mass(self.lumped());
        kept.factor = relation.factor();
        let (linear, angular) = kept.factor.solve(-relation.force, -relation.torque);
        kept.acceleration = Acceleration { linear, angular };
        Outboard::nothing()
    }
}

impl<T: Scalar> Takes<Spatial<T>, Reach<T, Open>> for Floating<T> {
    fn take(
        &self,
        _: &mut Reach<T, Open>,
        inner: Acceleration<T>,
        (attitude, .., kept, acceleration, (_, reached, _)): Of<'_, Spatial<T>, Reach<T, Open>, Self>,
    ) -> Acceleration<T> {
        let found = kept.acceleration;
        *acceleration = ((found.linear - inner.linear).into(), attitude.transposed(found.angular).into());
        *reached = found.linear;
        found
    }
}

impl<T: Scalar> Takes<Spatial<T>, Meet<T, Open>> for Floating<T> {
    /// What is left in place of the costates is W and w, in inertial axes.
    fn take(
        &self,
        _: &mut Meet<T, Open>,
        outer: Wrench<T>,
        (attitude, .., kept, _, costate, _): Of<'_, Spatial<T>, Meet<T, Open>, Self>,
    ) -> Wrench<T> {
        let (force, torque) = (Vector3::from(costate.0), attitude.apply(Vector3::from(costate.1)));
        let (linear, angular) = kept.factor.solve(force - outer.force, torque - outer.torque);
        *costate = (linear.into(), angular.into());
        Wrench::none()
    }
}

impl<T: Scalar> Takes<Spatial<T>, Stir<T, Open>> for Floating<T> {
    fn take(
        &self,
        _: &mut Stir<T, Open>,
        inner: Stirred<T>,
        (attitude, .., (_, rate, acceleration, free), ((), kept, _), _): Of<'_, Spatial<T>, Stir<T, Open>, Self>,
    ) -> Stirred<T> {
        let (velocity, stirring) = (Vector3::from(free.0), Vector3::from(free.1));
        free.1 = attitude.transposed(stirring).into();
        kept.velocity = velocity;
        kept.turning = inner.turning;
        let [spin, acceleration] = [rate.1, acceleration.1].map(|list| attitude.apply(Vector3::from(list)));
        Stirred { velocity, turning: Turning { spin, acceleration, stirring } }
    }
}

impl<T: Scalar> Takes<Spatial<T>, PullBack> for Floating<T> {
    fn take(
        &self,
        _: &mut PullBack,
        outer: Pulled<T>,
        (attitude, .., (_, a, _, kept, ..), (_, sums), (of_position, of_rate)): Of<'_, Spatial<T>, PullBack, Self>,
    ) -> Pulled<T> {
        let none = [T::zero(); 3];
        *of_position = (none, attitude.transposed(outer.turn).into());
        *of_rate = (none, attitude.transposed(-outer.spin).into());
        sums.more[0] -= dot(*a, kept.velocity);
        let momentum = add_scaled(outer.momentum, self.lumped(), kept.velocity);
        Pulled { momentum, force: add_scaled(outer.force, self.lumped(), *a), ..Pulled::null() }
    }
}

impl<T: Scalar> Takes<Spatial<T>, Burden<T, Open>> for Floating<T> {
    fn take(
        &self,
        walk: &mut Burden<T, Open>,
        outer: Wrench<T>,
        (x, y, p, q, (), kept, pivot): Of<'_, Spatial<T>, Burden<T, Open>, Self>,
    ) -> Wrench<T> {
        let mut more = ([T::zero(); 3], [T::zero(); 3]);
        let inner = self.take(&mut walk.0, outer, (x, y, p, q, &*kept, pivot, &mut more, &mut ()));
        kept.acceleration.linear += Vector3::from(more.0);
        kept.acceleration.angular += Vector3::from(more.1);
        inner
    }
}

impl<T: Scalar, L: BodyLaw<Spatial<T>>> Takes<Spatial<T>, PullLoads<L, Spatial<T>>> for Floating<T> {
    fn take(
        &self,
        _: &mut PullLoads<L, Spatial<T>>,
        outer: Felt<T>,
        (attitude, .., (of_position, of_rate)): Of<'_, Spatial<T>, PullLoads<L, Spatial<T>>, Self>,
    ) -> Felt<T> {
        let add = |sum: &mut [T; 3], more: Vector3<T>| *sum = (Vector3::from(*sum) + more).into();
        add(&mut of_position.0, outer.place);
        add(&mut of_rate.0, outer.velocity);
        add(&mut of_position.1, attitude.transposed(outer.turn));
        add(&mut of_rate.1, attitude.transposed(outer.spin));
        Felt { turn: zero(), spin: zero(), torque: zero(), ..outer }
    }
}
