//! The race of rules by their pace, time of the motion for a sweep: which one makes the next step.

use crate::scalar::Real;

/// The least and the most time that explicit rules lead a motion in a sweep where stability limits them, as a multiple of that in which the
/// fastest vibration turns by a radian: 0.39 was measured of `Dop853`, 0.6 to 1 of `Vcabm`, whose sums count.
const REACH: [f64; 2] = [0.4, 0.7];
/// What a sweep by `Vcabm` takes, sums and all, as a multiple of one by other rules.
const SUMS: f64 = 1.4;
/// What a step by a series takes, in sweeps: of two to twenty rods 9 to 6 at order 8, 13 to 8 at order 12 and 26 to 18 at order 24. Implicit
/// steps are worth theirs where tolerances are coarse and orders low.
const SERIES: usize = 8;
/// Sweeps of an implicit step, and how many steps that are worth them win its trial.
const IMPLICIT: f64 = 16.0;
const CONVINCING: usize = 4;
/// So many steps that look limited before the implicit rule is tried; two that do not undo one that does.
const SUSPICIONS: usize = 5;
/// Steps and sweeps of a rule before its pace is measured, and those over which it is.
const SETTLING: [usize; 2] = [3, 36];
const WINDOW: [usize; 2] = [4, 48];
/// Sweeps before a rule that has lost is tried again: at first, of the implicit one, whose trials are short, and of an explicit one; at most.
const PATIENCE: [usize; 2] = [100, 400];
const MOST_PATIENCE: usize = 20_000;

/// The rules that [`Auto`](crate::time::Auto) chooses from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Chosen {
    /// [`Dop853`](crate::time::Dop853).
    Dop853,
    /// [`Vcabm`](crate::time::Vcabm).
    Vcabm,
    /// [`Sdirk4`](crate::time::Sdirk4).
    Sdirk4,
    /// [`Taylor`](crate::time::Taylor), of [`AutoTaylor`](crate::time::AutoTaylor).
    Taylor,
}

impl Chosen {
    /// What a step takes in which so many sweeps were made, in sweeps. A series is made where the step is proposed.
    pub(super) fn work(self, sweeps: usize) -> usize {
        if self == Self::Taylor { SERIES } else { sweeps }
    }
}

/// What is known of the pace of rules.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Race<R> {
    pub(super) chosen: Chosen,
    /// The rule where nothing is stiff.
    pub(super) plain: Chosen,
    /// When the present motion and the last one written were, and whose they are.
    pub(super) from: (Option<R>, Chosen),
    pub(super) written: (Option<R>, Chosen),
    /// How many steps have been accepted since the rule was chosen or the measurement began, and twice how many look limited by stability,
    /// less those that do not.
    taken: usize,
    suspicious: usize,
    /// Whether the last step looks so.
    pub(super) limited: bool,
    /// Work of steps, in sweeps; those before the rule was chosen; where the measurement began, if it did: time, and sweeps.
    pub(super) sweeps: usize,
    since: usize,
    mark: Option<(R, usize)>,
    /// Time of the motion (s) a sweep, of the plain rule and of the implicit one, and size (s) of the last step by the plain one.
    pace: [f64; 2],
    pub(super) size: Option<R>,
    /// The fastest rate (1/s) of springs and dampers, once it is known.
    pub(super) fastest: Option<f64>,
    /// Whether the rule is on trial, and sweeps before the other one is tried again.
    trial: bool,
    patience: usize,
}

impl<R: Real> Race<R> {
    /// No step yet, by the rule for what is not stiff.
    pub(super) fn of(plain: Chosen) -> Self {
        Self {
            chosen: plain,
            plain,
            from: (None, plain),
            written: (None, plain),
            taken: 0,
            suspicious: 0,
            limited: false,
            sweeps: 0,
            since: 0,
            mark: None,
            pace: [0.0; 2],
            size: None,
            fastest: None,
            trial: false,
            patience: PATIENCE[0] / 2,
        }
    }

    /// Whether a race can go on: what was read as data may be anything.
    pub(super) fn is_sound(&self, single: impl Fn(Chosen) -> bool) -> bool {
        let Self { taken, suspicious, sweeps, since, mark, pace, size, fastest, patience, .. } = self;
        let plain = self.plain == Chosen::Vcabm || single(self.plain);
        let rules = plain && [self.plain, Chosen::Sdirk4].contains(&self.chosen);
        rules
            && [taken, suspicious, sweeps].iter().all(|count| **count <= usize::MAX / 2)
            && *since <= *sweeps
            && mark.is_none_or(|(time, begun)| time.is_finite() && begun <= *sweeps)
            && pace.iter().all(|pace| pace.is_finite())
            && size.is_none_or(|size| size.is_finite() && size > R::zero())
            && fastest.is_none_or(|rate| rate.is_finite() && rate >= 0.0)
            && *patience <= MOST_PATIENCE
    }

    /// Takes a rule.
    fn choose(&mut self, chosen: Chosen, trial: bool) {
        (self.chosen, self.trial, self.since, self.mark) = (chosen, trial, self.sweeps, None);
        (self.taken, self.suspicious, self.limited) = (0, 0, false);
    }

    /// Whether the implicit rule makes the steps.
    pub(super) fn is_stiff(&self) -> bool {
        self.chosen != self.plain
    }

    /// Waits for longer before the other rule is tried again.
    fn wait(&mut self) {
        (self.since, self.patience) = (self.sweeps, (2 * self.patience).min(MOST_PATIENCE));
    }

    /// Returns from a trial that is lost.
    fn lose(&mut self) {
        self.wait();
        self.choose(if self.is_stiff() { self.plain } else { Chosen::Sdirk4 }, false);
    }

    /// Ends a trial that is won.
    fn win(&mut self) {
        (self.trial, self.since, self.patience) = (false, self.sweeps, PATIENCE[usize::from(self.is_stiff())]);
    }

    /// Whether the other rule may be tried again.
    fn is_rested(&self) -> bool {
        !self.trial && self.sweeps - self.since >= self.patience
    }

    /// Whether steps of the plain rule look limited by stability, and its pace is known.
    fn suspects(&self) -> bool {
        self.suspicious >= 2 * SUSPICIONS && self.pace[0] > 0.0
    }

    /// Whether the rate of springs and dampers is to be found before [`judge`](Self::judge): at first, and where a trial hangs on it.
    pub(super) fn wonders(&self) -> bool {
        self.fastest.is_none() || (self.is_rested() && (self.is_stiff() || self.suspects()))
    }

    /// The size (s) from which on an implicit step is worth its sweeps; infinite without springs and dampers.
    pub(super) fn paying(&self) -> f64 {
        let [least, _] = REACH;
        match self.fastest {
            Some(rate) if rate > 0.0 => IMPLICIT * if self.pace[0] > 0.0 { self.pace[0] } else { least / rate },
            _ => f64::INFINITY,
        }
    }

    /// Before the first step, with the rule for what is not stiff: the implicit one is on trial where there are springs or dampers.
    pub(super) fn open(&mut self, plain: Chosen) {
        (self.plain, self.chosen) = (plain, plain);
        if self.paying().is_finite() {
            self.choose(Chosen::Sdirk4, true);
        }
    }

    /// Before a step of a size (s): the implicit rule has lost its trial where that is not worth its sweeps.
    pub(super) fn meet(&mut self, size: R) {
        let size = size.as_f64();
        if self.trial && self.is_stiff() && size < self.paying() {
            self.pace[1] = size / IMPLICIT;
            self.lose();
        }
    }

    /// After a step that was accepted: goes on, tries the other rule, or returns from a trial that has lost.
    pub(super) fn judge(&mut self, time: R) {
        self.taken += 1;
        self.suspicious = if self.limited { self.suspicious + 2 } else { self.suspicious.saturating_sub(1) };
        let stiff = self.is_stiff();
        if self.trial && stiff && self.taken >= CONVINCING {
            self.win();
        }
        let (begun, [steps, least]) = match self.mark {
            None => (self.since, SETTLING),
            Some((_, begun)) => (begun, WINDOW),
        };
        if self.taken >= steps && self.sweeps - begun >= least {
            let measured = self.mark.replace((time, self.sweeps));
            self.taken = 0;
            if let Some((start, begun)) = measured {
                let work = if self.chosen == Chosen::Vcabm { SUMS } else { 1.0 };
                self.pace[usize::from(stiff)] = (time - start).as_f64() / (work * (self.sweeps - begun).max(1) as f64);
                if self.trial && self.pace[0] < self.pace[1] {
                    return self.lose();
                }
                if self.trial {
                    self.win();
                }
            }
        }
        if !self.is_rested() {
            return;
        }
        let [_, most] = REACH;
        match (stiff, self.suspects()) {
            (false, true) if self.paying().is_finite() => self.choose(Chosen::Sdirk4, true),
            (false, true) => self.wait(), // there are no springs
            (false, false) => {}
            (true, _) if self.pace[1] * self.fastest.unwrap_or(0.0) > most => self.wait(), // no explicit rule is as quick
            (true, _) => self.choose(self.plain, true),
        }
    }
}
