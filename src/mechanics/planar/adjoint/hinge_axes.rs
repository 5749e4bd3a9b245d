//! The costate sweep in the plane: axes along which linear springs of a hinge push.
//!
//! The outboard point O moves by two coordinates s along axes e of the inboard body, as two [sliders](super::slider) would. With
//! d = Σ s e, u = Σ ṡ e, b = Σ s̈ e and c = Σ w_s e,
//!
//! ```text
//! A_O = A_I + α ẑ×d − ω² d + 2 ω ẑ×u + b        W_O = W_I + w ẑ×d + c
//! ```
//!
//! Along axes that do not turn, of a hinge that is not balanced, only b and c are there. Of one that is balanced the inboard body carries the
//! outboard point nevertheless, so that the elimination knows ξ̈ = s̈ − α ẑ×d for s̈, and virtual velocities along it:
//!
//! ```text
//! A_O = A_I + α ẑ×d + ξ̈        W_O = W_I + w ẑ×d + c        λ·s̈ = λ·ξ̈ + (λ·ẑ×d) α
//! ```
//!
//! By d, the last of these has the slope −α ẑ×λ, and λ is G at O where springs enter explicitly: what the first of them leaves, α ẑ×G, it takes.

use super::loads::Felt;
use super::{Pulled, Turning, sum};
use crate::element::{Explicit, Implicit};
use crate::mechanics::planar::axes::{Fixed, Inboard, Offset, across};
use crate::mechanics::planar::linear::HingeAxes;
use crate::mechanics::planar::{Unbalanced, Wrench};
use crate::relation::Additive;
use crate::relation::planar::algebra::{add_scaled, dot, normal, plus_dot};
use crate::relation::planar::along;
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// How the outboard point of a hinge moves: second derivatives by two coordinates along its axes.
pub struct Moved<T> {
    /// u, b and c, in the axes.
    pub(super) rate: Vector2<T>,
    pub(super) acceleration: Vector2<T>,
    pub(super) own: Vector2<T>,
    /// Of the inboard body.
    pub(super) turning: Turning<T>,
}

/// Axes through which costates go.
#[diagnostic::on_unimplemented(
    message = "no gradient of a run goes backward through linear springs along axes `{Self}`",
    label = "not axes that the costate sweep knows",
    note = "it knows springs along axes of the inboard body, along fixed ones, and those that are not balanced (`in_unbalanced_axes`)",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait ReversingAxes: HingeAxes {
    /// What acts at the outboard point, at the inboard one.
    fn inward<T: Scalar>(at: Wrench<T>, offset: Self::Offset<T>) -> Wrench<T>;
    /// A torque on the inboard body, for costates of the second derivatives of the coordinates, which its angular acceleration changes.
    fn swung<T: Scalar>(costate: Vector2<T>, offset: Self::Offset<T>) -> T {
        let _ = (costate, offset);
        T::zero()
    }
    /// Costates of the coordinates and of their rates, and what goes inward, from G and F at the outboard point.
    fn pull_back<T: Scalar>(offset: Self::Offset<T>, moved: &Moved<T>, at: Pulled<T>) -> ([Vector2<T>; 2], Pulled<T>);
    /// Pulls back what loads and closures read, likewise: what is carried at the outboard point goes on as it is, but for turns of the inboard body.
    fn felt<T: Scalar>(offset: Self::Offset<T>, moved: &Moved<T>, felt: &Felt<T>) -> ([Vector2<T>; 2], [T; 2]);
}

impl ReversingAxes for Unbalanced {
    #[inline(always)]
    fn inward<T: Scalar>(at: Wrench<T>, (): ()) -> Wrench<T> {
        at
    }
    #[inline(always)]
    fn pull_back<T: Scalar>((): (), _: &Moved<T>, at: Pulled<T>) -> ([Vector2<T>; 2], Pulled<T>) {
        ([Vector2::null(); 2], at)
    }
    #[inline(always)]
    fn felt<T: Scalar>((): (), _: &Moved<T>, felt: &Felt<T>) -> ([Vector2<T>; 2], [T; 2]) {
        ([felt.place, felt.velocity], [T::zero(); 2])
    }
}

impl ReversingAxes for Fixed {
    #[inline(always)]
    fn inward<T: Scalar>(at: Wrench<T>, arm: Vector2<T>) -> Wrench<T> {
        Wrench { torque: plus_dot(at.torque, normal(arm), at.force), ..at }
    }
    #[inline(always)]
    fn swung<T: Scalar>(costate: Vector2<T>, arm: Vector2<T>) -> T {
        dot(costate, normal(arm))
    }
    #[inline(always)]
    fn pull_back<T: Scalar>(_: Vector2<T>, moved: &Moved<T>, at: Pulled<T>) -> ([Vector2<T>; 2], Pulled<T>) {
        ([normal(at.force) * moved.turning.stirring, Vector2::null()], at)
    }
    #[inline(always)]
    fn felt<T: Scalar>(_: Vector2<T>, moved: &Moved<T>, felt: &Felt<T>) -> ([Vector2<T>; 2], [T; 2]) {
        let of_position = felt.place - normal(felt.stirring) * moved.turning.stirring;
        ([of_position, felt.velocity], [T::zero(); 2])
    }
}

/// How springs along axes `A` may enter sweeps through which costates go.
#[diagnostic::on_unimplemented(
    message = "no gradient of a run by an implicit rule goes backward through linear springs along axes `{A}`",
    label = "not axes that the costate sweep knows under such a rule",
    note = "it knows springs along axes of the inboard body and those that are not balanced (`in_unbalanced_axes`); by explicit rules also those along fixed axes",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait Along<A> {}

impl<A> Along<A> for Explicit {}
impl<R> Along<Inboard> for Implicit<R> {}
/// Not along fixed ones: there the inboard body's angular acceleration is that of the sweep before.
impl<R> Along<Unbalanced> for Implicit<R> {}

impl ReversingAxes for Inboard {
    #[inline(always)]
    fn inward<T: Scalar>(at: Wrench<T>, offset: Offset<T>) -> Wrench<T> {
        Wrench { torque: plus_dot(at.torque, normal(offset.arm), at.force), ..at }
    }
    fn pull_back<T: Scalar>(offset: Offset<T>, moved: &Moved<T>, at: Pulled<T>) -> ([Vector2<T>; 2], Pulled<T>) {
        let Offset { direction, arm: d, .. } = offset;
        let Turning { rate, acceleration, stirring } = moved.turning;
        let [momentum, force] = [at.momentum, at.force].map(|v| along(v, direction));
        let (beside, twice) = (normal(momentum), rate + rate);
        // −G·ẑ×e is ẑ×G·e.
        let of_position = add_scaled(beside * acceleration, rate * rate, momentum) + normal(force) * stirring;
        let turns = twice * dot(moved.rate, momentum) + dot(moved.acceleration, beside) + dot(moved.own, normal(force));
        let whirls = dot(moved.rate, beside);
        let pulled = Pulled {
            along: dot(d, at.momentum),
            across: dot(normal(d), at.momentum),
            lever: dot(d, at.force),
            angular: plus_dot(at.angular, normal(d), at.momentum),
            beyond: sum(at.beyond, Some([turns, whirls + whirls])),
            ..at
        };
        ([of_position, beside * twice], pulled)
    }
    fn felt<T: Scalar>(offset: Offset<T>, moved: &Moved<T>, felt: &Felt<T>) -> ([Vector2<T>; 2], [T; 2]) {
        let Offset { direction, arm: d, .. } = offset;
        let Turning { rate, stirring, .. } = moved.turning;
        let [place, velocity, stirred] = [felt.place, felt.velocity, felt.stirring].map(|v| along(v, direction));
        let of_position = place - normal(add_scaled(velocity * rate, stirring, stirred));
        let [u, c] = [moved.rate, moved.own].map(|v| normal(across(v, direction)));
        let (swept, stirring) = (add_scaled(u, -rate, d), add_scaled(c, -stirring, d));
        let turned = plus_dot(plus_dot(dot(normal(d), felt.place), swept, felt.velocity), stirring, felt.stirring);
        ([of_position, velocity], [turned, dot(normal(d), felt.velocity)])
    }
}
