//! Steps by the rule that leads a motion farthest for its sweeps.

mod pair;
mod race;
mod single;
mod stiffness;

use super::{ExplicitStepper, Method, MotionIn, SdirkStepper, Stepper, TaylorMemory, TimeIn, VcabmStepper};
use crate::error::Error;
use crate::mirror::Rate;
use crate::scalar::{Real, Scalar};
use crate::system::{SeriesDynamics, StiffDynamics};
use crate::time::{Auto, AutoTaylor, Dop853, Sdirk4, Vcabm};
use pair::PairStepper;
pub use race::Chosen;
use race::Race;
use single::Single;

/// The first step of a trial of the implicit rule, as a multiple of one that is worth its sweeps, and the longest one of a run.
const GENEROUS: f64 = 2.0;
const LONGEST: f64 = 16.0;
/// Multistep methods that stiffness limits fall to orders up to this one.
const LOW: usize = 3;

/// Steps by [`Auto`], or, with another method of single steps, by [`AutoTaylor`].
pub struct AutoStepper<D: StiffDynamics<L>, L, K = ExplicitStepper<D, L, Dop853>> {
    single: K,
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
        AutoStepper::of(Dop853.stepper(scene.clone()), scene)
    }
}

impl<D, L, const P: usize> Method<D, L> for AutoTaylor<P>
where
    D: StiffDynamics<L> + SeriesDynamics<L, P> + Clone,
{
    type Stepper = AutoStepper<D, L, PairStepper<D, L, P>>;

    fn stepper(&self, scene: D) -> Self::Stepper {
        AutoStepper::of(PairStepper::of(scene.clone()), scene)
    }
}

/// Calls the stepper of a rule.
macro_rules! of {
    ($chosen:expr, $self:ident, |$stepper:ident| $call:expr) => {
        match $chosen {
            Chosen::Dop853 | Chosen::Taylor => {
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

impl<D: StiffDynamics<L> + Clone, L, K: Single<D, L>> AutoStepper<D, L, K> {
    /// A race that begins with a method of single steps.
    fn of(single: K, scene: D) -> Self {
        let room = scene.still().rate;
        Self {
            race: Race::of(Self::plain(&room, None)),
            single,
            multi: Vcabm::new().stepper(scene.clone()),
            stiff: Sdirk4::new().stepper(scene),
            resumed: false,
            restored: false,
            room,
        }
    }

    /// The rule for what is not stiff, at a tolerance if there is one.
    fn plain(rate: &D::Rate, tolerance: Option<TimeIn<D, L>>) -> Chosen {
        let mut count = 0;
        rate.visit(&mut |_| count += 1);
        let tolerance = tolerance.map(Real::as_f64);
        if K::leaves_to_multistep(count, tolerance) { Chosen::Vcabm } else { K::chosen(tolerance) }
    }

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
}

impl<D: StiffDynamics<L> + Clone, L, K: Single<D, L>> Stepper<D, L> for AutoStepper<D, L, K> {
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
            self.race.sweeps += chosen.work(stepper.sweeps() - before);
            if made.is_ok() {
                self.race.written.0 = Some(next.time); // it may have ended early
            }
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
            let plain = Self::plain(&past.rate, Some(tolerance));
            self.single.take(plain);
            self.race.open(plain);
        }
        let Race { chosen, size, written, .. } = self.race;
        let proposed = of!(chosen, self, |stepper| stepper.propose(past, loads, tolerance));
        // A series knows how far it reaches, whoever made the steps before.
        if chosen == before || chosen == Chosen::Taylor || [before, chosen].into_iter().all(K::makes) {
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
            Chosen::Dop853 | Chosen::Taylor => self.single.limited(next, dt, self.race.fastest, &mut self.room),
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
            Chosen::Dop853 | Chosen::Taylor => self.single.error_order(),
            Chosen::Vcabm => self.multi.error_order(),
            Chosen::Sdirk4 => self.stiff.error_order(),
        }
    }

    fn firm(&self, next: &MotionIn<D, L>, least: f64) -> bool {
        match self.race.chosen {
            Chosen::Dop853 | Chosen::Taylor => self.single.firm(next, least),
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

    /// The race, and what its methods carry.
    type Memory = AutoMemory<
        TimeIn<D, L>,
        <VcabmStepper<D, L> as Stepper<D, L>>::Memory,
        <SdirkStepper<D, L> as Stepper<D, L>>::Memory,
    >;

    fn memory(&self) -> Self::Memory {
        let (single, multi, stiff) = (self.single.carried(), self.multi.memory(), self.stiff.memory());
        AutoMemory { race: self.race, single, multi, stiff }
    }

    fn remembers(&self, memory: &Self::Memory, motion: &MotionIn<D, L>) -> bool {
        let remembered = self.multi.remembers(&memory.multi, motion) && self.stiff.remembers(&memory.stiff, motion);
        remembered && memory.race.is_sound(K::makes)
    }

    fn restore(&mut self, memory: &Self::Memory) {
        (self.race, self.restored) = (memory.race, true);
        self.single.take(self.race.plain);
        self.single.carry(&memory.single);
        self.multi.restore(&memory.multi);
        self.stiff.restore(&memory.stiff);
    }

    fn restart(&mut self) {
        self.multi.restart();
    }
}

/// What [`AutoStepper`] carries from step to step.
#[derive(Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct AutoMemory<R, M, G> {
    race: Race<R>,
    single: TaylorMemory<R>,
    multi: M,
    stiff: G,
}
