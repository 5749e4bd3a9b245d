//! How fast springs and dampers are: what limits the steps of explicit rules, and not those of implicit ones.

use crate::element::{Implicit, Reading};
use crate::mirror::{Position, Rate};
use crate::scalar::{Elementary, Real, Scalar};
use crate::stepper::{MotionIn, SdirkStepper, TimeIn};
use crate::system::StiffDynamics;
use num_traits::{One, Zero};

/// So many times stiffness is applied to a displacement: each lets the fastest vibration stand out more.
const APPLIED: usize = 3;

/// What a sweep displaces springs by.
#[derive(Clone, Copy)]
enum Displaced {
    Nothing,
    Positions,
    Rates,
}

impl<D: StiffDynamics<L>, L> SdirkStepper<D, L> {
    /// The fastest rate (1/s) of springs and dampers at a motion, zero where there are none: √|M⁻¹K|, or that at which damping |M⁻¹D| lets
    /// it creep or die where this is faster, by power iteration on differences of sweeps. Springs alone are displaced and the geometry is
    /// not: what gravity and tension restore implicit rules do not know.
    pub(super) fn fastest(&mut self, past: &MotionIn<D, L>, loads: &L) -> f64 {
        self.scene.copy_gains(self.scene.gains(&self.stiff), &mut self.kept);
        self.push(past, loads, Displaced::Nothing);
        self.led.set(&self.slopes[0]);
        self.roughen();
        let mut square = 0.0;
        for _ in 0..APPLIED {
            square = self.push(past, loads, Displaced::Positions);
            if square == 0.0 {
                self.roughen();
                break;
            }
        }
        let damping = self.push(past, loads, Displaced::Rates);
        core::mem::swap(self.scene.gains_mut(&mut self.stiff), &mut self.kept);
        let root = |x: f64| Elementary::sqrt(TimeIn::<D, L>::of(x)).as_f64();
        let over = damping * damping - 4.0 * square;
        let rate = if over > 0.0 { 0.5 * (damping + root(over)) } else { root(square) };
        if rate.is_finite() { rate } else { 0.0 }
    }

    /// A displacement that changes its sign from each coordinate to the next.
    fn roughen(&mut self) {
        let mut sign = TimeIn::<D, L>::one();
        self.room.replace(&mut |_| {
            sign = -sign;
            D::Scalar::constant(sign)
        });
    }

    /// How many times its size the displacement becomes by what springs or dampers do to accelerations.
    fn push(&mut self, past: &MotionIn<D, L>, loads: &L, displaced: Displaced) -> f64 {
        let (none, one) = (TimeIn::<D, L>::zero(), TimeIn::<D, L>::one());
        let largest = |rate: &D::Rate| {
            let mut largest = none;
            rate.visit(&mut |x| largest = largest.max(x.real().abs()));
            largest
        };
        let small = Elementary::sqrt(<TimeIn<D, L> as Real>::EPSILON);
        let share = small / largest(&self.room);
        let (of_position, of_rate) = match displaced {
            Displaced::Nothing => (none, none),
            Displaced::Positions => (share, none),
            Displaced::Rates => (none, share),
        };
        let (position, rate) = &mut self.free;
        position.drift_0(&past.position, (of_position, &self.room));
        rate.mix_1(&past.rate, (of_rate, &self.room));
        let (at, free) = ((&past.position, &past.rate), (&*position, &*rate));
        let reading = Reading { position: free.0, rate: free.1, acceleration: &self.zero };
        let (springs, found) = (Implicit { position: none, rate: none }, &mut self.slopes[0]);
        self.scene.implicit_accelerations(past.time, at, free, reading, springs, loads, &mut self.stiff, found);
        self.sweeps += 1;
        self.room.mix_2(&self.zero, (one, &self.slopes[0]), (-one, &self.led));
        (largest(&self.room) / small).as_f64()
    }
}
