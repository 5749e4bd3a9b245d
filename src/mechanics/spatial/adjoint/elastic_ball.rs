//! The costate sweep in space: what balls with a rotary spring do, under explicit rules.
//!
//! The coordinate is the attitude of the outboard body relative to the inboard one, its rate q̇ and its torque in axes A of the outboard body. With
//! u = A q̇, ω = ω_I + u, α = α_I + ω_I × u + A q̈ and w = w_I + A q̇_w,
//!
//! ```text
//! Ψ̄ = Aᵀ(Θ + w_I × M + α_I × H + ω_I × (Ω + u × H))        q̇⁻ = −Aᵀ(Ω + H × ω_I)        τ̄ = q̇_w        then Ω ← Ω + u × H
//! ```
//!
//! for a turn Ψ of what lies outboard takes u along and leaves ω_I, α_I and w_I. The law acts as a torque does, and goes backward by jets of a small
//! turn, of the rate and of its numbers.

use super::{OfJoint, Outboard, Pivot, Pulled, Stirred, Turning};
use crate::adjoint::BodyLaw;
use crate::adjoint::jets::seeded;
use crate::adjoint::laws::{NUMBERS, ROTARY_NUMBERS};
use crate::element::{Element, Explicit, Springs};
use crate::lift::Lift;
use crate::mechanics::spatial::adjoint::Felt;
use crate::mechanics::spatial::{Acceleration, ElasticHinge, RotaryLaw, Rotation, Spatial, Turn, Wrench};
use crate::relation::Closures;
use crate::relation::spatial::algebra::cross_onto;
use crate::relation::spatial::{BallGain, Couple, Gain};
use crate::scalar::{Jet, Real, Scalar};
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

/// A small turn, a rate and the numbers of a law.
const INPUTS: usize = 6 + ROTARY_NUMBERS;
/// A number with derivatives by all these.
pub type ReadRotary<T> = Jet<T, INPUTS>;

/// A rotary law through which costates go backward: any that is generic over the scalar and can be [lifted](crate::lift!).
#[diagnostic::on_unimplemented(
    message = "no gradient of a run goes backward through the rotary law `{Self}`",
    label = "not a law that the costate sweep knows",
    note = "it knows `RotarySpring`, and laws of the user's own that are generic over the scalar and can be lifted: `catena::lift!`",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait ReversibleRotary<T: Scalar>: RotaryLaw<T> {
    /// Costates of a turn (axes of the outboard body) and of the rate, given that of the torque; those of the law's numbers, in the order in
    /// which [`Lift`] meets them.
    fn pull_back(&self, position: &Rotation<T>, rate: &[T; 3], of_torque: &[T; 3]) -> [[T; 3]; 2 + ROTARY_NUMBERS / 3];
}

impl<T: Scalar, L> ReversibleRotary<T> for L
where
    L: RotaryLaw<T> + Lift<T, ReadRotary<T>, Over: RotaryLaw<ReadRotary<T>>>,
{
    fn pull_back(&self, position: &Rotation<T>, rate: &[T; 3], of_torque: &[T; 3]) -> [[T; 3]; 2 + ROTARY_NUMBERS / 3] {
        let (law, _) = seeded(self, 6);
        // R exp(ψ~) near ψ = 0.
        let half = T::Real::of(0.5);
        let turn = core::array::from_fn::<_, 3, _>(|k| Jet::seed(T::zero(), k).scale(half));
        let turn = Rotation { w: Jet::of(T::one()), v: Vector3::from(turn) };
        let position = position.lift(&mut Jet::of).after(&turn);
        let rate = core::array::from_fn(|k| Jet::seed(rate[k], 3 + k));
        let torque = law.torque(&position, &rate);
        let along = |k: usize| (0..3).fold(T::zero(), |sum, i| of_torque[i].mul_add(torque[i].eps[k], sum));
        core::array::from_fn(|group| core::array::from_fn(|k| along(3 * group + k)))
    }
}

impl<T: Scalar> OfJoint<T> {
    /// Costates of the numbers of a rotary law: beside six the three of a place, which balls have not.
    pub(crate) fn of_rotary(&self) -> [T; ROTARY_NUMBERS] {
        core::array::from_fn(|k| if k < NUMBERS { self.law[k] } else { self.place[k - NUMBERS] })
    }
}

impl<T: Scalar, R: ReversibleRotary<T>> Takes<Spatial<T>, Orient> for ElasticHinge<R> {
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

/// Ways in which rotary springs enter that costates know: as torques.
#[diagnostic::on_unimplemented(
    message = "no gradient of a run by an implicit rule goes backward through an `ElasticBall`",
    label = "a rule whose pivots know springs",
    note = "explicit rules go backward through rotary springs: `Rk4`, `Dopri5`, `Dop853`",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait AsTorques<T: Scalar>: Springs<T> {}

impl<T: Scalar> AsTorques<T> for Explicit {}

impl<T: Scalar, C: Closures, R: ReversibleRotary<T>, By: AsTorques<T>> Takes<Spatial<T>, Factor<C, By>>
    for ElasticHinge<R>
{
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        _: &mut Factor<C, By>,
        outer: Outboard<T, C>,
        (attitude, .., (position, rate, _), torque, gain, pivot): Of<'_, Spatial<T>, Factor<C, By>, Self>,
    ) -> Outboard<T, C> {
        let of_law = self.rotary.torque(position, rate);
        let torque = attitude.apply(Vector3::from(torque.0) + of_law);
        // The same factors as in the elimination: they are formed once.
        *pivot = Pivot { factor: outer.relation.angular.factor(), torque };
        let (relation, found) = outer.relation.balled(Couple(torque));
        *gain = BallGain::absolute(found);
        Outboard::of_ball(relation)
    }
}

impl<T: Scalar, C: Closures, R: ReversibleRotary<T>> Takes<Spatial<T>, Reach<T, C>> for ElasticHinge<R> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Reach<T, C>,
        inner: Acceleration<T>,
        (attitude, bias, .., gain, acceleration, _): Of<'_, Spatial<T>, Reach<T, C>, Self>,
    ) -> Acceleration<T> {
        let angular = gain.absolute.angular(inner.linear, &walk.forces);
        *acceleration = attitude.transposed(angular - inner.angular - bias[1]).into();
        Acceleration { angular, ..inner }
    }
}

impl<T: Scalar, C: Closures, R: ReversibleRotary<T>> Takes<Spatial<T>, Meet<T, C>> for ElasticHinge<R> {
    /// H w + Kᵀ W + e_m = A λ is what the inboard body meets; w of the outboard body is found from that as in a ball.
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Meet<T, C>,
        outer: Wrench<T>,
        (attitude, .., gain, pivot, costate, _): Of<'_, Spatial<T>, Meet<T, C>, Self>,
    ) -> Wrench<T> {
        let torque = attitude.apply(Vector3::from(*costate));
        let (left, gain) = (torque - outer.torque, &gain.absolute);
        *costate = pivot.factor.solve(left).into();
        walk.part_along(&gain.per_closure, left);
        Wrench { force: outer.force - gain.per_acceleration.transposed(left), torque }
    }
}

impl<T: Scalar, C: Closures, R: ReversibleRotary<T>> Takes<Spatial<T>, Stir<T, C>> for ElasticHinge<R> {
    #[cfg_attr(optimised, inline(always))]
    fn take(
        &self,
        walk: &mut Stir<T, C>,
        Stirred { velocity, turning: inner }: Stirred<T>,
        (attitude, bias, .., gain, (_, rate, acceleration, free), ((), kept, _), torque): Of<
            '_,
            Spatial<T>,
            Stir<T, C>,
            Self,
        >,
    ) -> Stirred<T> {
        let stirring = Gain { free: Vector3::from(*free), ..gain.absolute }.angular(velocity, &walk.forces);
        let own = attitude.transposed(stirring - inner.stirring);
        *free = own.into();
        torque.0 = (Vector3::from(torque.0) + own).into();
        kept.turning = inner;
        let [rate, acceleration] = [rate, acceleration].map(|list| attitude.apply(Vector3::from(*list)));
        let acceleration = inner.acceleration + bias[1] + acceleration;
        Stirred { velocity, turning: Turning { spin: inner.spin + rate, acceleration, stirring } }
    }
}

impl<T: Scalar, R: ReversibleRotary<T>> Takes<Spatial<T>, PullBack> for ElasticHinge<R> {
    fn take(
        &self,
        walk: &mut PullBack,
        outer: Pulled<T>,
        (attitude, .., (position, rate, _, own), (_, _, _, kept, ..), (_, sums), (of_position, of_rate)): Of<
            '_,
            Spatial<T>,
            PullBack,
            Self,
        >,
    ) -> Pulled<T> {
        let (inner, moved) = (kept.turning, attitude.apply(Vector3::from(*rate)));
        let inboard = Pulled { spin: cross_onto(moved, outer.angular, outer.spin), ..outer };
        let mut found = [inboard.turned(inner), -cross_onto(outer.angular, inner.spin, outer.spin)]
            .map(|sum| attitude.transposed(sum));
        if walk.laws {
            let [turn, rate, of_law @ ..] = self.rotary.pull_back(position, rate, own);
            found = [found[0] + Vector3::from(turn), found[1] + Vector3::from(rate)];
            let numbers = sums.law.iter_mut().chain(sums.place.iter_mut());
            numbers.zip(of_law.as_flattened()).for_each(|(sum, more)| *sum += *more);
        }
        [*of_position, *of_rate] = found.map(Into::into);
        inboard
    }
}

/// A law acts where the geometry is: no rule that takes it apart goes backward through it.
impl<T: Scalar, R: ReversibleRotary<T>> Takes<Spatial<T>, Strain<T>> for ElasticHinge<R> {
    #[inline(always)]
    fn take(&self, _: &mut Strain<T>, (): (), _: Of<'_, Spatial<T>, Strain<T>, Self>) {}
}

impl<T: Scalar, C: Closures, R: ReversibleRotary<T>> Takes<Spatial<T>, Burden<T, C>> for ElasticHinge<R> {
    fn take(
        &self,
        walk: &mut Burden<T, C>,
        outer: Wrench<T>,
        (x, y, p, q, (), gain, pivot): Of<'_, Spatial<T>, Burden<T, C>, Self>,
    ) -> Wrench<T> {
        let mut more = [T::zero(); 3];
        let inner = self.take(&mut walk.0, outer, (x, y, p, q, gain, pivot, &mut more, &mut ()));
        gain.absolute.free += Vector3::from(more);
        inner
    }
}

impl<T: Scalar, L: BodyLaw<Spatial<T>>, R: ReversibleRotary<T>> Takes<Spatial<T>, PullLoads<L, Spatial<T>>>
    for ElasticHinge<R>
{
    fn take(
        &self,
        _: &mut PullLoads<L, Spatial<T>>,
        outer: Felt<T>,
        (attitude, .., (.., kept, _), _, (of_position, of_rate)): Of<'_, Spatial<T>, PullLoads<L, Spatial<T>>, Self>,
    ) -> Felt<T> {
        let turned = outer.turned_under::<L>(&kept.turning);
        *of_position = attitude.transposed_onto(turned, Vector3::from(*of_position)).into();
        *of_rate = attitude.transposed_onto(outer.spin, Vector3::from(*of_rate)).into();
        outer
    }
}
