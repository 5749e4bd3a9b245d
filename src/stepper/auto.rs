//! Steps by the rule that leads a motion farthest for its sweeps.

mod race;
mod stiffness;

use super::{ExplicitStepper, Method, MotionIn, SdirkStepper, Stepper, TimeIn, VcabmStepper};
use crate::error::Error;
use crate::mirror::{Position, Rate, Retraction};
use crate::scalar::{Elementary, Real, Scalar};
use crate::system::StiffDynamics;
use crate::time::{Auto, Dop853, Sdirk4, Vcabm};
pub use race::Chosen;
use race::Race;

/// From so many coordinates on what a multistep method does beside its sweeps is worth their number; where some are turns in space, at
/// tolerances from this one on.
const MANY: usize = 7;
const COARSE: f64 = 1e-3;
/// Share of the limit of stability from which on steps by DOP853 look limited by it: h λ, which is about 6 there.
const LIMITED: f64 = 2.5;
/// The first step of a trial of the implicit rule, as a multiple of one that is worth its sweeps, and the longest one of a run.
const GENEROUS: f64 = 2.0;
const LONGEST: f64 = 16.0;
/// Multistep methods that stiffness limits fall to orders up to this one.
const LOW: usize = 3;

/// Steps by [`Auto`].
pub struct AutoStepper<D: StiffDynamics<L>, L> {
    single: ExplicitStepper<D, L, Dop853>,
    multi: VcabmStepper<D, L>,
    stiff: SdirkStepper<D, L>,
    race: Race<TimeIn<D, L>>,
    resumed: bool,
    /// Whether what was carried has been put back since a step was proposed.
    restored: bool,
    room: D::Rate,
}

impl<D: StiffDynamics<L> + Clone, L> Method<D, L> for Auto {
    type Stepper = AutoStepper<D, L>;

    fn stepper(&self, scene: D) -> AutoStepper<D, L> {
        let still = scene.still();
        let plain = plain::<D, L>(&still.rate, None);
        AutoStepper {
            single: Dop853.stepper(scene.clone()),
            multi: Vcabm::new().stepper(scene.clone()),
            stiff: Sdirk4::new().stepper(scene),
            race: Race::of(plain),
            resumed: false,
            restored: false,
            room: still.rate,
        }
    }
}

/// The rule for what is not stiff, at a tolerance if there is one.
fn plain<D: StiffDynamics<L>, L>(rate: &D::Rate, tolerance: Option<TimeIn<D, L>>) -> Chosen {
    let mut count = 0;
    rate.visit(&mut |_| count += 1);
    let coarse = tolerance.is_some_and(|tolerance| tolerance.as_f64() >= COARSE);
    if count >= MANY && (!D::Position::CURVED || coarse) { Chosen::Vcabm } else { Chosen::Dop853 }
}

/// Calls the stepper of a rule.
macro_rules! of {
    ($chosen:expr, $self:ident, |$stepper:ident| $call:expr) => {
        match $chosen {
            Chosen::Dop853 => {
                let $stepper = &mut $self.single;
                $call
            }
            Chosen::Vcabm => {
                let $stepper = &mut $self.multi;
                $call
            }
            Chosen::Sdirk4 => {
                let $stepper = &mut $self.stiff;
                $call
            }
        }
    };
}

impl<D: StiffDynamics<L> + Clone, L> AutoStepper<D, L> {
    /// The rule that makes the next step.
    pub fn chosen(&self) -> Chosen {
        self.race.chosen
    }

    /// The size (s) of a first step by the rule chosen, as tolerance and accelerations say, and of the implicit one not so long that fast
    /// vibration is sure to shorten it.
    fn first(&self, past: &MotionIn<D, L>, tolerance: TimeIn<D, L>) -> TimeIn<D, L> {
        let real = TimeIn::<D, L>::of;
        let mut slope = real(1e-6);
        past.acceleration.all(&past.rate, &mut |acceleration, rate| {
            slope = slope.max(acceleration.real().abs() / (real(1.0) + rate.real().abs()));
            true
        });
        let smooth = (real(0.01) * tolerance / slope).powf(real(1.0 / self.error_order() as f64));
        if self.race.is_stiff() { smooth.min(real(LONGEST * self.race.paying())) } else { smooth }
    }

    /// Whether stability seems to have limited the last step by DOP853, whose last stage and end are at one time: by how much accelerations
    /// differ there as positions and rates do (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.2, for systems of first
    /// order).
    fn limited(&mut self, next: &MotionIn<D, L>, dt: TimeIn<D, L>) -> bool {
        let Self { single, room, .. } = self;
        let square = |a: &D::Rate, b: &D::Rate| {
            let mut sum = 0.0;
            a.all(b, &mut |x, y| {
                let difference = (x - y).real().as_f64();
                sum += difference * difference;
                true
            });
            sum
        };
        let (slopes, (position, rate)) = (single.slopes.as_ref(), &single.stage);
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

impl<D: StiffDynamics<L> + Clone, L> Stepper<D, L> for AutoStepper<D, L> {
    const SETTLED: bool = false;

    fn admit(&self, past: &MotionIn<D, L>, loads: &L, dt: TimeIn<D, L>, next: &MotionIn<D, L>) -> Result<(), Error> {
        self.stiff.admit(past, loads, dt, next)
    }

    fn begin(&mut self, _: &MotionIn<D, L>, _: &L) {
        self.resumed = false;
    }

    fn resume(&mut self, _: &MotionIn<D, L>) {
        self.resumed = true;
    }

    fn make(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &mut MotionIn<D, L>,
    ) -> Result<(), Error> {
        let now = Some(past.time);
        // A step that was made, and is made anew to end earlier, says nothing of the race: it is one by the same rule.
        if !(self.restored && self.race.from.0 == now && self.race.written.0 != now) {
            self.race.meet(dt);
        }
        let Race { chosen, plain, from, written, .. } = &mut self.race;
        if written.0 == now {
            *from = *written;
        } else if from.0 != now {
            // A start is as it is said to be; an instant within a step is as the rule of that step left it.
            *from = (now, if written.0.is_none() { *plain } else { written.1 });
        }
        // Implicit steps leave other accelerations than the true ones.
        let settled = self.resumed && from.1 != Chosen::Sdirk4;
        *written = (Some(past.time + dt), *chosen);
        // Samples take sweeps, too, whatever the rule.
        of!(*chosen, self, |stepper| {
            let before = stepper.sweeps();
            if settled {
                stepper.resume(past);
            } else {
                stepper.begin(past, loads);
            }
            let made = stepper.make(past, loads, dt, next);
            self.race.sweeps += stepper.sweeps() - before;
            made
        })
    }

    fn propose(&mut self, past: &MotionIn<D, L>, loads: &L, tolerance: TimeIn<D, L>) -> Option<TimeIn<D, L>> {
        self.restored = false;
        let (before, accepted) = (self.race.chosen, self.race.written.0 == Some(past.time));
        if self.race.wonders() && (accepted || self.race.fastest.is_none()) {
            self.race.fastest = Some(self.stiff.fastest(past, loads));
        }
        if accepted {
            self.race.judge(past.time);
        } else if self.race.written.0.is_none() {
            self.race.open(plain::<D, L>(&past.rate, Some(tolerance)));
        }
        let Race { chosen, size, written, .. } = self.race;
        let proposed = of!(chosen, self, |stepper| stepper.propose(past, loads, tolerance));
        if chosen == before {
            return proposed;
        }
        match (written.0, self.race.is_stiff()) {
            (None, _) => Some(self.first(past, tolerance)),
            (_, false) => size,
            (_, true) => Some(TimeIn::<D, L>::of(GENEROUS * self.race.paying())),
        }
    }

    fn error(
        &mut self,
        past: &MotionIn<D, L>,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        tolerance: TimeIn<D, L>,
    ) -> Option<TimeIn<D, L>> {
        let chosen = self.race.chosen;
        let error = of!(chosen, self, |stepper| stepper.error(past, dt, next, tolerance));
        self.race.limited = match chosen {
            Chosen::Dop853 => self.limited(next, dt),
            Chosen::Vcabm => self.multi.is_low(LOW),
            Chosen::Sdirk4 => false,
        };
        if chosen == self.race.plain {
            self.race.size = Some(dt);
        }
        error
    }

    fn error_order(&self) -> usize {
        match self.race.chosen {
            Chosen::Dop853 => self.single.error_order(),
            Chosen::Vcabm => self.multi.error_order(),
            Chosen::Sdirk4 => self.stiff.error_order(),
        }
    }

    fn firm(&self, next: &MotionIn<D, L>, least: f64) -> bool {
        match self.race.chosen {
            Chosen::Dop853 => self.single.firm(next, least),
            Chosen::Vcabm => self.multi.firm(next, least),
            Chosen::Sdirk4 => true,
        }
    }

    fn interpolate(
        &mut self,
        past: &MotionIn<D, L>,
        loads: &L,
        dt: TimeIn<D, L>,
        next: &MotionIn<D, L>,
        theta: f64,
        between: &mut MotionIn<D, L>,
    ) {
        let made = self.race.written.1;
        of!(made, self, |stepper| stepper.interpolate(past, loads, dt, next, theta, between));
    }

    fn sweeps(&self) -> usize {
        self.single.sweeps() + self.multi.sweeps() + self.stiff.sweeps()
    }

    /// The race, and what multistep and implicit methods carry.
    type Memory = AutoMemory<
        TimeIn<D, L>,
        <VcabmStepper<D, L> as Stepper<D, L>>::Memory,
        <SdirkStepper<D, L> as Stepper<D, L>>::Memory,
    >;

    fn memory(&self) -> Self::Memory {
        AutoMemory { race: self.race, multi: self.multi.memory(), stiff: self.stiff.memory() }
    }

    fn remembers(&self, memory: &Self::Memory, motion: &MotionIn<D, L>) -> bool {
        let remembered = self.multi.remembers(&memory.multi, motion) && self.stiff.remembers(&memory.stiff, motion);
        remembered && memory.race.is_sound()
    }

    fn restore(&mut self, memory: &Self::Memory) {
        (self.race, self.restored) = (memory.race, true);
        self.multi.restore(&memory.multi);
        self.stiff.restore(&memory.stiff);
    }
}

/// What [`AutoStepper`] carries from step to step.
#[derive(Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AutoMemory<R, M, G> {
    race: Race<R>,
    multi: M,
    stiff: G,
}
