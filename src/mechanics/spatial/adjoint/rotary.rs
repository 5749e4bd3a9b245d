//! The costate sweep in space: laws that resist turns, and how the rule of a sweep treats them.
//!
//! With the torque τ on the outboard body, K̂ and relative accelerations β in its axes, w the virtual velocity in the joint, and β′ the
//! acceleration that has led to where an implicit rule reads the law,
//!
//! ```text
//! P = −w · (τ + K̂ (β′ − β))
//! ```
//!
//! by jets of a small turn there, of the rate and of the law's numbers.

use super::{OfJoint, Outboard, Pivot};
use crate::adjoint::jets::seeded;
use crate::adjoint::laws::{NUMBERS, ROTARY_NUMBERS};
use crate::element::{Explicit, Implicit};
use crate::lift::Lift;
use crate::mechanics::spatial::elastic_hinge::{BallRule, Place};
use crate::mechanics::spatial::hinge_elimination::SlideRule;
use crate::mechanics::spatial::{RotaryLaw, Rotation};
use crate::relation::Closures;
use crate::relation::spatial::algebra::{Columns, Factor3, Symmetric3};
use crate::relation::spatial::{BallGain, Couple, Full, Point};
use crate::scalar::{Jet, Real, Scalar};
use crate::walks::strain::Strain;
use nalgebra::Vector3;

/// A small turn, a rate and the numbers of a law.
const INPUTS: usize = 6 + ROTARY_NUMBERS;
/// A number with derivatives by all these.
pub type ReadRotary<T> = Jet<T, INPUTS>;
/// Costates of a turn (axes of the outboard body), of a rate and of the numbers of a law.
pub type OfRotary<T> = [[T; 3]; INPUTS / 3];

/// A rotary law through which costates go backward: any that is generic over the scalar and can be [lifted](crate::lift!).
#[diagnostic::on_unimplemented(
    message = "no gradient of a run goes backward through the rotary law `{Self}`",
    label = "not a law that the costate sweep knows",
    note = "it knows `RotarySpring`, and laws of the user's own that are generic over the scalar and can be lifted: `catena::lift!`",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait ReversibleRotary<T: Scalar>: RotaryLaw<T> {
    /// Costates of a turn and of the rate, given that of the torque; those of the law's numbers, in the order in which [`Lift`] meets them.
    fn pull_back(&self, position: &Rotation<T>, rate: &[T; 3], of_torque: &[T; 3]) -> OfRotary<T>;
    /// Costates likewise, given that of torque + K̂ × change, and that of the change.
    fn pull_back_led(
        &self,
        at: (&Rotation<T>, &[T; 3], &[T; 3]),
        of_torque: &[T; 3],
        springs: Implicit<T::Real>,
    ) -> (OfRotary<T>, [T; 3]);
}

/// R exp(ψ~) near ψ = 0, and a rate.
fn read<T: Scalar>(position: &Rotation<T>, rate: &[T; 3]) -> (Rotation<ReadRotary<T>>, [ReadRotary<T>; 3]) {
    let half = T::Real::of(0.5);
    let turn = core::array::from_fn::<_, 3, _>(|k| Jet::seed(T::zero(), k).scale(half));
    let turn = Rotation { w: Jet::of(T::one()), v: Vector3::from(turn) };
    (position.lift(&mut Jet::of).after(&turn), core::array::from_fn(|k| Jet::seed(rate[k], 3 + k)))
}

/// By each of what is read, derivatives of w · torque.
fn slopes<T: Scalar>(torque: &Vector3<ReadRotary<T>>, w: &[T; 3]) -> OfRotary<T> {
    let along = |k: usize| (0..3).fold(T::zero(), |sum, i| w[i].mul_add(torque[i].eps[k], sum));
    core::array::from_fn(|group| core::array::from_fn(|k| along(3 * group + k)))
}

/// K̂ β, both in axes of the outboard body.
fn pivoted<T: Scalar>(
    law: &impl RotaryLaw<T>,
    (position, rate): (&Rotation<T>, &[T; 3]),
    springs: Implicit<T::Real>,
    change: Vector3<T>,
) -> Vector3<T> {
    let axes = position.matrix();
    axes.transposed(law.pivot(position, rate, springs).apply(axes.apply(change)))
}

impl<T: Scalar, L> ReversibleRotary<T> for L
where
    L: RotaryLaw<T> + Lift<T, ReadRotary<T>, Over: RotaryLaw<ReadRotary<T>>>,
{
    fn pull_back(&self, position: &Rotation<T>, rate: &[T; 3], of_torque: &[T; 3]) -> OfRotary<T> {
        let (position, rate) = read(position, rate);
        slopes(&seeded(self, 6).0.torque(&position, &rate), of_torque)
    }
    fn pull_back_led(
        &self,
        (position, rate, change): (&Rotation<T>, &[T; 3], &[T; 3]),
        of_torque: &[T; 3],
        springs: Implicit<T::Real>,
    ) -> (OfRotary<T>, [T; 3]) {
        let of_change = pivoted(self, (position, rate), springs, Vector3::from(*of_torque));
        let (law, (position, rate)) = (seeded(self, 6).0, read(position, rate));
        let torque =
            law.torque(&position, &rate) + pivoted(&law, (&position, &rate), springs, change.map(Jet::of).into());
        (slopes(&torque, of_torque), of_change.into())
    }
}

impl<T: Scalar> OfJoint<T> {
    /// Costates of the numbers of a rotary law: beside six the three of a place, which such joints have not.
    pub(crate) fn of_rotary(&self) -> [T; ROTARY_NUMBERS] {
        core::array::from_fn(|k| if k < NUMBERS { self.law[k] } else { self.place[k - NUMBERS] })
    }

    /// Adds to these.
    pub(super) fn add_rotary(&mut self, more: &[[T; 3]]) {
        let numbers = self.law.iter_mut().chain(self.place.iter_mut());
        numbers.zip(more.as_flattened()).for_each(|(sum, more)| *sum += *more);
    }
}

/// What a rotary law does where it is read apart from the geometry, over w, at a place and a rate to which an acceleration has led that differs
/// by a change: costates of these three.
pub(super) fn strain<T: Scalar, L: ReversibleRotary<T>>(
    law: &L,
    walk: &mut Strain<T>,
    at: (&Rotation<T>, &[T; 3], &[T; 3]),
    w: &[T; 3],
    sums: &mut OfJoint<T>,
) -> [[T; 3]; 3] {
    let ([of_turn, of_rate, of_law @ ..], of_change) = law.pull_back_led(at, w, walk.springs);
    sums.add_rotary(&of_law);
    walk.of_size += pivoted(law, (at.0, at.1), walk.by_size, Vector3::from(*at.2)).dot(&Vector3::from(*w));
    [of_turn, of_rate, of_change]
}

/// How the rule of a sweep eliminates the turn and the displacement of a hinge with what other right-hand sides need.
pub trait HingeRule<T: Scalar>: BallRule<T> + SlideRule<T> {
    /// The pivot: an inertia, or that and the K̂ of springs.
    fn pivot_of(self, inertia: Symmetric3<T>, stiffness: impl FnOnce(Implicit<T::Real>) -> Symmetric3<T>)
    -> Factor3<T>;
    /// What lies outboard of a ball.
    fn beyond<C: Closures>(relation: Self::Out<C>) -> Outboard<T, C>;

    /// The relation with the turn eliminated against a law and a torque (inertial axes), its gain and its pivot; `bias` is the angular
    /// acceleration that rates alone cause.
    #[cfg_attr(optimised, inline(always))]
    fn turned_out<C: Closures>(
        self,
        outer: Outboard<T, C>,
        law: &impl RotaryLaw<T>,
        torque: Vector3<T>,
        place: Place<'_, T>,
        bias: Vector3<T>,
    ) -> (Outboard<T, C>, BallGain<T, C>, Pivot<T>) {
        // The same factors as in the elimination: they are formed once.
        let factor = self.pivot_of(outer.relation.angular, |springs| place.stiffness(law, springs));
        let (relation, gain) = self.ball(outer.relation, law, Couple(torque), place, bias);
        (Self::beyond(relation), gain, Pivot { factor, torque })
    }
    /// The relation with a displacement eliminated as [`SlideRule::slide`] does, its gain and its pivot.
    fn slid_out<C: Closures>(
        self,
        outer: Full<T, C>,
        axes: &Columns<T>,
        force: Vector3<T>,
        led: Option<Vector3<T>>,
        pivots: impl Fn(Implicit<T::Real>) -> Vector3<T>,
    ) -> (Full<T, C>, BallGain<T, C>, Factor3<T>) {
        let factor = self.pivot_of(outer.linear, |springs| Symmetric3::of_diagonal(pivots(springs)).turned(axes));
        let (relation, gain) = self.slide(outer, axes, force, led, pivots);
        (relation, gain, factor)
    }
}

impl<T: Scalar> HingeRule<T> for Explicit {
    #[inline(always)]
    fn pivot_of(self, inertia: Symmetric3<T>, _: impl FnOnce(Implicit<T::Real>) -> Symmetric3<T>) -> Factor3<T> {
        inertia.factor()
    }
    #[inline(always)]
    fn beyond<C: Closures>(relation: Point<T, Couple<T>, C>) -> Outboard<T, C> {
        Outboard::of_ball(relation)
    }
}

impl<T: Scalar> HingeRule<T> for Implicit<T::Real> {
    #[inline(always)]
    fn pivot_of(self, inertia: Symmetric3<T>, stiffness: impl FnOnce(Self) -> Symmetric3<T>) -> Factor3<T> {
        (inertia + stiffness(self)).factor()
    }
    #[inline(always)]
    fn beyond<C: Closures>(relation: Full<T, C>) -> Outboard<T, C> {
        Outboard::rigid(relation)
    }
}

/// Adds to three numbers.
pub(super) fn add<T: Scalar>(sum: &mut [T; 3], more: impl Into<[T; 3]>) {
    sum.iter_mut().zip(more.into()).for_each(|(sum, more)| *sum += more);
}
