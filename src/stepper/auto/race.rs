//! The race of rules by their pace, time of the motion for a sweep: which one makes the next step.

use crate::scalar::Real;

/// So many steps that look limited before another rule is tried; two that do not undo one that does.
const SUSPICIONS: usize = 5;
/// Steps and sweeps of a rule before its pace is measured, and those over which it is.
const SETTLING: [usize; 2] = [3, 36];
const WINDOW: [usize; 2] = [4, 48];
/// Sweeps before a rule that has lost is tried again: at first, and at most.
const PATIENCE: usize = 400;
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
    /// Sweeps that steps have taken; those before the rule was chosen; where the measurement began, if it did: time, and sweeps.
    pub(super) sweeps: usize,
    since: usize,
    mark: Option<(R, usize)>,
    /// Time (s) a sweep, of the plain rule and of the other one, and size (s) of the last step by the plain one.
    pace: [f64; 2],
    pub(super) size: Option<R>,
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
            trial: false,
            patience: PATIENCE,
        }
    }

    /// Whether a race can go on: what was read as data may be anything.
    pub(super) fn is_sound(&self) -> bool {
        let Self { taken, suspicious, sweeps, since, mark, pace, size, patience, .. } = self;
        [taken, suspicious, sweeps].iter().all(|count| **count <= usize::MAX / 2)
            && *since <= *sweeps
            && mark.is_none_or(|(time, begun)| time.is_finite() && begun <= *sweeps)
            && pace.iter().all(|pace| pace.is_finite())
            && size.is_none_or(|size| size.is_finite() && size > R::zero())
            && *patience <= MOST_PATIENCE
    }

    /// Takes a rule.
    fn choose(&mut self, chosen: Chosen, trial: bool) {
        (self.chosen, self.trial, self.since, self.mark) = (chosen, trial, self.sweeps, None);
        (self.taken, self.suspicious, self.limited) = (0, 0, false);
    }

    /// After a step that was accepted: goes on, tries the other rule, or returns from a trial that has lost.
    pub(super) fn judge(&mut self, time: R) {
        let sweeps = self.sweeps;
        self.taken += 1;
        self.suspicious = if self.limited { self.suspicious + 2 } else { self.suspicious.saturating_sub(1) };
        let (stiff, plain) = (self.chosen == Chosen::Sdirk4, self.plain);
        let (begun, [steps, least]) = match self.mark {
            None => (self.since, SETTLING),
            Some((_, begun)) => (begun, WINDOW),
        };
        if self.taken >= steps && sweeps - begun >= least {
            let measured = self.mark.replace((time, sweeps));
            self.taken = 0;
            if let Some((start, begun)) = measured {
                let pace = (time - start).as_f64() / (sweeps - begun).max(1) as f64;
                self.pace[usize::from(stiff)] = pace;
                if self.trial && pace < self.pace[usize::from(!stiff)] {
                    self.patience = (2 * self.patience).min(MOST_PATIENCE);
                    return self.choose(if stiff { plain } else { Chosen::Sdirk4 }, false);
                }
                if self.trial {
                    (self.trial, self.patience) = (false, PATIENCE);
                }
            }
        }
        let rested = !self.trial && sweeps - self.since >= self.patience;
        let limited = self.suspicious >= 2 * SUSPICIONS && (rested || self.pace[1] == 0.0);
        if stiff && rested {
            self.choose(plain, true);
        } else if !stiff && limited && self.pace[0] > 0.0 {
            self.choose(Chosen::Sdirk4, true);
        }
    }
}
