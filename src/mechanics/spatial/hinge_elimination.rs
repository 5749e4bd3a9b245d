//! How a sweep eliminates the rotation and the displacement of an elastic hinge in space, by its rule and by what springs there are.

use super::elastic_hinge::{BallRule, Place};
use super::rotary_spring::{RotaryDamper, RotaryLaw, RotarySpring};
use crate::element::{Explicit, Implicit, Springs};
use crate::relation::spatial::algebra::{Columns, Symmetric3};
use crate::relation::spatial::{BallGain, Full, Point, Slides};
use crate::relation::{Absent, Closures, Term};
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// How the rule of a sweep treats the linear springs of a hinge.
pub trait SlideRule<T: Scalar>: Springs<T> {
    /// Eliminates the displacement against a force, and what springs add to the pivots, along these axes. Where the force was read at
    /// a state to which an acceleration has led, that is given.
    fn slide<R: Slides<T>>(
        self,
        outer: R,
        axes: &Columns<T>,
        force: Vector3<T>,
        led: Option<Vector3<T>>,
        pivots: impl FnOnce(Implicit<T::Real>) -> Vector3<T>,
    ) -> (R, BallGain<T, R::Closures>);
}

impl<T: Scalar> SlideRule<T> for Explicit {
    #[cfg_attr(optimised, inline(always))]
    fn slide<R: Slides<T>>(
        self,
        outer: R,
        axes: &Columns<T>,
        force: Vector3<T>,
        _: Option<Vector3<T>>,
        _: impl FnOnce(Implicit<T::Real>) -> Vector3<T>,
    ) -> (R, BallGain<T, R::Closures>) {
        outer.loosed(axes.apply(force))
    }
}

impl<T: Scalar> SlideRule<T> for Implicit<T::Real> {
    #[cfg_attr(optimised, inline(always))]
    fn slide<R: Slides<T>>(
        self,
        outer: R,
        axes: &Columns<T>,
        force: Vector3<T>,
        led: Option<Vector3<T>>,
        pivots: impl FnOnce(Self) -> Vector3<T>,
    ) -> (R, BallGain<T, R::Closures>) {
        let pivots = pivots(self);
        let force = led.map_or(force, |led| force + pivots.component_mul(&led));
        outer.slid(axes.apply(force), Symmetric3::of_diagonal(pivots).turned(axes))
    }
}

/// The rotation of a hinge in a sweep whose springs enter by `K`: against a spring, or free.
pub trait RotaryElimination<T: Scalar, K: BallRule<T>>: RotaryLaw<T> {
    /// The relation with the rotation eliminated, where a drive exerts a torque of type `M`.
    type Out<M: Term<Vector3<T>>, C: Closures>: Slides<T, Closures = C>;
    /// Eliminates the rotation; `bias` is the angular acceleration that rates alone cause.
    fn turn<M: Term<Vector3<T>>, C: Closures>(
        &self,
        springs: K,
        outer: Full<T, C>,
        drive: M,
        place: Place<'_, T>,
        bias: Vector3<T>,
    ) -> (Self::Out<M, C>, BallGain<T, C>);
}

impl<T: Scalar, K: BallRule<T>> RotaryElimination<T, K> for Absent {
    type Out<M: Term<Vector3<T>>, C: Closures> = Point<T, M, C>;

    #[cfg_attr(optimised, inline(always))]
    fn turn<M: Term<Vector3<T>>, C: Closures>(
        &self,
        _: K,
        outer: Full<T, C>,
        drive: M,
        _: Place<'_, T>,
        _: Vector3<T>,
    ) -> (Point<T, M, C>, BallGain<T, C>) {
        let (relation, gain) = outer.balled(drive);
        (relation, BallGain::absolute(gain))
    }
}

impl<T: Scalar, K: BallRule<T>, D: RotaryDamper<T>, P: Term<Vector3<T>>> RotaryElimination<T, K>
    for RotarySpring<T, D, P>
{
    type Out<M: Term<Vector3<T>>, C: Closures> = K::Out<C>;

    #[cfg_attr(optimised, inline(always))]
    fn turn<M: Term<Vector3<T>>, C: Closures>(
        &self,
        springs: K,
        outer: Full<T, C>,
        drive: M,
        place: Place<'_, T>,
        bias: Vector3<T>,
    ) -> (K::Out<C>, BallGain<T, C>) {
        springs.ball(outer, self, drive, place, bias)
    }
}
