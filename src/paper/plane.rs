//! The scheme in the plane: one angle, at the angle itself.

use super::body::{External, Known, Rigid, rigid_body};
use super::expansion::{At, Expansion};
use super::hinge::{Linear, Rotary, linear_hinge, rotary_hinge};
use super::link::{Given, Law};
use super::orient::{Bodies, Expanded, Joints, Side, Spring};
use super::pin::{is_percussive, smooth_pin};
use super::product::Hinges;
use super::rule::{Coordinate, Linearization};
use crate::error::{Error, Fault};
use crate::mechanics::planar::{BodyMotion, Frame, Turn};
use crate::scalar::{Real, Scalar};
use crate::state::TransferMatrix;
use nalgebra::Vector2;

impl<T: Scalar> Hinges<T, 7, 2, 1> for Expansion<T> {
    fn elastic(law: &Law<T, 1>) -> TransferMatrix<T, 7> {
        rotary_hinge(&Rotary { slope: law.outer[0][0], offset: law.offset[0] })
    }
    fn sprung(linear: &[Linear<T>; 2]) -> TransferMatrix<T, 7> {
        linear_hinge(linear.map(Some))
    }
    fn smooth(
        section: &TransferMatrix<T, 7>,
        [[here], [outer]]: [[T; 1]; 2],
        inertia: T::Real,
    ) -> Result<TransferMatrix<T, 7>, Error> {
        smooth_pin(section, [here, outer], inertia)
    }
}

impl<T: Scalar> Expanded<T, 2, 1> for Expansion<T> {
    type Base = ();

    fn first(at: At, (): &(), past: &[[T; 3]; 1], _: &[Linearization<T>; 1], span: T::Real) -> (Self, [T; 1]) {
        let [[angle, rate, acceleration]] = *past;
        let ahead = rate.scale(span).add_scaled(T::Real::of(0.5) * span * span, acceleration);
        let expansion = match at {
            At::Previous => Self::printed(angle, rate, acceleration, span),
            At::Predictor | At::Iterated => Self::about(angle + ahead),
        };
        (expansion, [ahead])
    }
    fn again((): &(), [step]: &[Linearization<T>; 1], [found]: &[T; 1]) -> Self {
        Self::about(step.past + *found)
    }
    fn residual(&self, [angle]: &[T; 1]) -> T::Real {
        (*angle - self.angle).real().abs()
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
    const SINGULAR: bool = false;
    fn follow(_: &[T; 1], _: &[T; 1]) -> Result<(), Fault> {
        Ok(())
    }
    fn psi(&self, point: [T; 2]) -> [[T; 1]; 2] {
        let [x, y] = Expansion::turned(self, point);
        [[-y], [x]]
    }
    fn phi(&self, [x, y]: [T; 2]) -> [T; 2] {
        let [g1, g2] = self.constants();
        [x * g1 - y * g2, x * g2 + y * g1]
    }
    #[inline(always)]
    fn remainder(&self, (): &(), point: [T; 2], [angle]: &[T; 1]) -> [T; 2] {
        Expansion::remainder(self, point, *angle)
    }
    fn turned((): &(), point: [T; 2], [angle]: &[T; 1]) -> [T; 2] {
        Expansion::turned(&Self::about(*angle), point)
    }
    fn retract<M: Copy>((): &mut (), _: &mut [Coordinate<T, M>; 1]) {}
    fn shown((): &(), angles: &[T; 1], _: &[T; 1]) -> [T; 1] {
        *angles
    }
}

impl<T: Scalar> Bodies<T, 7, 2, 1> for Expansion<T> {
    type Rigid = Rigid<T>;
    type Motion = BodyMotion<T>;
    type External = External<T>;

    fn arms(rigid: &Rigid<T>) -> [[T; 2]; 2] {
        [rigid.inertia.centre, rigid.outboard]
    }
    fn inertia(rigid: &Rigid<T>) -> T::Real {
        let size = |[x, y]: [T; 2]| x.real().abs() + y.real().abs();
        let arms = size(rigid.inertia.centre) * size(rigid.outboard);
        rigid.about_inboard().real().abs() + rigid.inertia.mass.real().abs() * arms
    }
    fn is_percussive(rigid: &Rigid<T>) -> bool {
        is_percussive(rigid)
    }
    fn matrix(
        &self,
        rigid: &Rigid<T>,
        step: &Linearization<T>,
        given: &Given<T, 2, 1>,
        external: &External<T>,
    ) -> TransferMatrix<T, 7> {
        let Given { inboard, centre, angles: [angle], arms: [to_centre, to_outboard], .. } = *given;
        rigid_body(rigid, self, step.chi1, &Known { inboard, centre, angle, to_outboard, to_centre }, external)
    }
    fn is_finite(external: &External<T>) -> bool {
        external.torque.is_finite() && external.force.iter().all(|x| x.is_finite())
    }
    fn motion(&self, rigid: &Rigid<T>, place: [T; 2], velocity: [T; 2], [[angle, rate]]: [[T; 2]; 1]) -> BodyMotion<T> {
        let still = Frame::resting(Vector2::from(place));
        let frame = Frame { velocity: Vector2::from(velocity), turn: Turn { angle, rate }, ..still };
        rigid.moving(frame, self.barred)
    }
}

impl<T: Scalar> Joints<T, 2, 1> for Expansion<T> {
    type Ahead = T;
    type Frame = Frame<T>;

    fn law(
        spring: &Spring<T, 1>,
        [elastic]: &[T; 1],
        [inner, outer]: [&Side<T, Self, 1>; 2],
        absolute: bool,
    ) -> Law<T, 1> {
        let Spring { stiffness: [stiffness], damping: [damping], preload: [preload] } = *spring;
        let ([inner], [outer]) = (&inner.step, &outer.step);
        let offset = if absolute {
            damping * (outer.chi4() - inner.chi4()) - preload
        } else {
            damping * (outer.rate - inner.rate) + *elastic
        };
        Rotary { slope: stiffness + damping.scale(outer.chi3), offset }.into()
    }
    fn ground((): &(), [before, now]: [&Frame<T>; 2], step: &Linearization<T>) -> Side<T, Self, 1> {
        let (past, turn) = (before.turn.angle, now.turn);
        let Linearization { chi1, chi3, .. } = *step;
        let rate = turn.rate - (turn.angle - past).scale(chi3);
        let step = Linearization { past, chi1, chi3, acceleration: T::zero(), rate };
        Side { expansion: Self::about(turn.angle), step: [step] }
    }
    fn grounded((): &(), frames: [&Frame<T>; 2]) -> [[T; 1]; 2] {
        frames.map(|frame| [frame.turn.angle])
    }
    fn rigid(ahead: &T) -> (Option<[[T; 1]; 1]>, [T; 1]) {
        (None, [*ahead])
    }
    fn clamped((): &(), _: &[T; 1], ahead: &T, ground: &Frame<T>) -> [T; 1] {
        [ground.turn.angle + *ahead]
    }
    fn place(frame: &Frame<T>) -> [T; 2] {
        frame.place.into()
    }
    fn angles(frame: &Frame<T>, _: &[T; 1]) -> [T; 1] {
        [frame.turn.angle]
    }
}
