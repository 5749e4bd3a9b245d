//! The method of one step that a race begins with: when steps by it look limited by stability, and when a multistep method is quicker.

use super::Chosen;
use crate::mirror::{Position, Rate, Retraction};
use crate::scalar::{Elementary, Real, Scalar};
use crate::stepper::{ExplicitStepper, MotionIn, Stepper, TaylorMemory, TaylorStepper, TimeIn};
use crate::system::{Dynamics, SeriesDynamics};
use crate::time::Dop853;

/// From so many coordinates on what a multistep method does beside its sweeps is worth their number; where some are turns in space, at
/// tolerances from this one on.
const MANY: usize = 7;
const COARSE: f64 = 1e-3;
/// Share of the limit of stability from which on steps by DOP853 look limited by it: h λ, which is about 6 there.
const LIMITED: f64 = 2.5;
/// By how much (rad) the fastest vibration turns in a step from which on one by a series looks limited.
const SLOW: f64 = 1.0;

/// A method of one step, for what is not stiff.
pub trait Single<D: Dynamics<L>, L>: Stepper<D, L> {
    /// Name of the method in a race, at a tolerance if there is one.
    fn chosen(tolerance: Option<f64>) -> Chosen;

    /// Whether the method is ever one of this name.
    fn makes(chosen: Chosen) -> bool {
        chosen == Self::chosen(None)
    }

    /// Takes the method of a name, where there are several.
    fn take(&mut self, chosen: Chosen) {
        let _ = chosen;
    }

    /// Memory of a method of series, from step to step.
    fn carried(&self) -> TaylorMemory<TimeIn<D, L>> {
        TaylorMemory::new()
    }

    /// Goes on from that.
    fn carry(&mut self, memory: &TaylorMemory<TimeIn<D, L>>) {
        let _ = memory;
    }

    /// Whether a multistep method is quicker for so many coordinates, at a tolerance if there is one.
    fn leaves_to_multistep(coordinates: usize, tolerance: Option<f64>) -> bool;

    /// Whether stability seems to have limited its last step, of a scene whose springs and dampers are this fast (1/s), if that is known.
    fn limited(&mut self, next: &MotionIn<D, L>, dt: TimeIn<D, L>, fastest: Option<f64>, room: &mut D::Rate) -> bool;
}

impl<D: Dynamics<L>, L> Single<D, L> for ExplicitStepper<D, L, Dop853> {
    fn chosen(_: Option<f64>) -> Chosen {
        Chosen::Dop853
    }

    fn leaves_to_multistep(coordinates: usize, tolerance: Option<f64>) -> bool {
        coordinates >= MANY && (!D::Position::CURVED || tolerance.is_some_and(|tolerance| tolerance >= COARSE))
    }

    /// By how much accelerations differ at the end and in the last stage, which is at the same time, as positions and rates do (E. Hairer,
    /// G. Wanner, Solving Ordinary Differential Equations II, IV.2, for systems of first order).
    fn limited(&mut self, next: &MotionIn<D, L>, dt: TimeIn<D, L>, _: Option<f64>, room: &mut D::Rate) -> bool {
        let square = |a: &D::Rate, b: &D::Rate| {
            let mut sum = 0.0;
            a.all(b, &mut |x, y| {
                let difference = (x - y).real().as_f64();
                sum += difference * difference;
                true
            });
            sum
        };
        let (slopes, (position, rate)) = (self.slopes.as_ref(), &self.stage);
        let [.., last, end] = &slopes[..=12] else { return false };
        next.position.apart(position, room);
        let mut moved = 0.0;
        room.visit(&mut |x| moved += x.real().as_f64() * x.real().as_f64());
        let root = |x: f64| Elementary::sqrt(TimeIn::<D, L>::of(x)).as_f64();
        let dt = dt.as_f64();
        let (pushed, moved, turned) = (root(square(last, end)), root(moved), root(square(rate, &next.rate)));
        dt * dt * pushed > LIMITED * (moved + dt * turned)
    }
}

impl<D: SeriesDynamics<L, P>, L, const P: usize> Single<D, L> for TaylorStepper<D, L, P> {
    fn chosen(_: Option<f64>) -> Chosen {
        Chosen::Taylor
    }

    fn leaves_to_multistep(coordinates: usize, tolerance: Option<f64>) -> bool {
        coordinates >= MANY && tolerance.is_some_and(|tolerance| tolerance >= COARSE)
    }

    fn limited(&mut self, _: &MotionIn<D, L>, dt: TimeIn<D, L>, fastest: Option<f64>, _: &mut D::Rate) -> bool {
        fastest.is_some_and(|rate| rate * dt.as_f64() > SLOW)
    }
}
