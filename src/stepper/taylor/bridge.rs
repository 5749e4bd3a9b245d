//! Where steps of another rule lead over a place at which closures depend on each other.

use crate::scalar::Real;

/// So many steps another rule makes at most before a series is tried again.
const BRIDGE: usize = 8;

/// An end of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct End<R> {
    /// The time (s).
    time: R,
    /// Whether closures are all but dependent there, if that is known.
    loose: Option<bool>,
    /// How many steps from there on another rule makes.
    bridge: usize,
}

/// What [`TaylorStepper`](super::TaylorStepper) carries from step to step: whether closures are all but dependent of each other, and whether
/// another rule leads, where the last step begins and where it ends.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TaylorMemory<R> {
    ends: [Option<End<R>>; 2],
}

impl<R: Real> TaylorMemory<R> {
    /// Of no step yet.
    pub(in crate::stepper) fn new() -> Self {
        Self { ends: [None; 2] }
    }

    /// What is known of a time.
    fn at(&self, time: R) -> Option<End<R>> {
        self.ends.iter().rev().flatten().find(|end| end.time == time).copied()
    }

    /// Whether another rule makes steps from a time.
    pub(super) fn leads(&self, time: R) -> bool {
        self.at(time).is_some_and(|end| end.bridge > 0)
    }

    /// Whether closures are all but dependent at a time, if that is known.
    pub(super) fn is_loose(&self, time: R) -> Option<bool> {
        self.at(time)?.loose
    }

    /// Whether closures are known to be held at a time.
    pub(super) fn holds(&self, time: R) -> bool {
        self.is_loose(time) == Some(false)
    }

    /// The size (s) of the step that ended at a time, if it was one of a series.
    pub(super) fn size_before(&self, time: R) -> Option<R> {
        match self.ends {
            [Some(start), Some(end)] if end.time == time && start.bridge == 0 => Some(time - start.time),
            _ => None,
        }
    }

    /// Has another rule make the next steps, from a time at which closures are all but dependent, or are not yet.
    pub(super) fn lead_over(&mut self, time: R, loose: bool) {
        self.ends = [Some(End { time, loose: Some(loose), bridge: BRIDGE }), None];
    }

    /// Keeps a step between two times, at the end of which closures are all but dependent, or are not.
    pub(super) fn write(&mut self, from: R, time: R, loose: bool) {
        let start = self.at(from).unwrap_or(End { time: from, loose: None, bridge: 0 });
        let passed = !loose && start.loose == Some(true);
        let bridge = if passed { 0 } else { start.bridge.min(BRIDGE).saturating_sub(1) };
        self.ends = [Some(start), Some(End { time, loose: Some(loose), bridge })];
    }
}
