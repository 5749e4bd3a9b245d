//! The costate sweep in the plane: axes along which linear springs of a hinge push.
//!
//! The outboard point O moves by two coordinates s along axes e of the inboard body, as two [sliders](super::slider) would. With
//! d = Σ s e, u = Σ ṡ e, b = Σ s̈ e and c = Σ w_s e,
//!
//! ```text
//! A_O = A_I + α ẑ×d − ω² d + 2 ω ẑ×u + b        W_O = W_I + w ẑ×d + c
//! ```
//!
//! Along axes that do not turn, of a hinge that is not balanced, only b and c are there.

use super::loads::Felt;
use super::{Pulled, Turning, sum};
use crate::mechanics::planar::axes::{Inboard, Offset, across};
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
    note = "it knows springs along axes of the inboard body, and those that are not balanced (`in_unbalanced_axes`)",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait ReversingAxes: HingeAxes {
    /// What acts at the outboard point, at the inboard one.
    fn inward<T: Scalar>(at: Wrench<T>, offset: Self::Offset<T>) -> Wrench<T>;
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
