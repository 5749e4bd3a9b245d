//! Stages of an implicit rule: each solves W x = τ(free + B x, free + Γ x) − c at a geometry that follows the sweep before, with
//! W = M + B K + Γ C.
//!
//! Backward, M w = λ becomes W w = x̄ through the gains of the same sweep, and
//!
//! ```text
//! geometry, at rest of springs:  Q_g, V_g, as in an explicit sweep        laws, at free + B x, free + Γ x:  F
//! free ← F + (Q_g, V_g)        x̄ of the sweep before ← B Q_g + Γ V_g
//! ```
//!
//! and, as B = (γ h)² and Γ = γ h, the costate of the size h takes 2 γ² h Q + γ V, times x, of laws, and times x of the sweep before, of the
//! geometry.
//!
//! A law that is not linear is read where the sweep before has led, at q′ and v′ by its acceleration a′, and that is where the geometry is taken:
//!
//! ```text
//! τ = f(q′, v′) + K̂ (a′ − x)        F = w ∂/∂(q′, v′) [f + K̂ (a′ − x)], to Q_g, V_g        x̄ of the sweep before ← K̂ w more
//! ```
//!
//! with K̂ = B k + Γ c by the law's slopes there, so that F has second derivatives. A prediction without accelerations is geometry alone: such laws
//! are read at free then. A linear law of turns in space is linear in a rotation vector alone: along curved positions it is read so, too, but for
//! rules that remember, by which it is read at free.
//!
//! The geometry of a stage's first sweep follows the stage before, that of a step's the motion at its start; of a rule that
//! [remembers](super::memory) it is a prediction without accelerations. Where something is held or closed, that of each further sweep may be
//! put back by the one before it ([`projection`](super::projection)). Sweeps before the last of a stage are made once more on the way back.

use super::GradientOf;
use super::again::{Again, follow, paired, unfollow};
use super::projection::Projection;
use super::record::{Place, RecordOf, StageOf};
use super::rules::Staged;
use super::steps::Steps;
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, RealOf};
use crate::ends::Root;
use crate::mirror::{Position, Rate, Retraction};
use crate::scalar::Real;
use crate::shape::{Shape, Takes};
use crate::system::{Elements, MotionOf, RateOf};
use crate::walks::strain::Strain;

impl<S, R, C, P, M, L> Steps<'_, S, R, C, P, M, L>
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Staged,
    L: BodyLaw<S>,
    Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>> + Burdened<S, L, P::Closures>,
{
    /// Whether geometries of sweeps are put back.
    pub(super) const RESTORED: bool = M::RESTORES && Self::CLOSED > 0;
    /// Whether rules sum up coordinates of the step, and positions are curved; a rule that remembers displaces positions one after the other.
    pub(super) const CHARTED: bool = Self::CURVED && !M::REMEMBERS;
    /// Whether laws are read where the last sweep has led, or, of turns in space, where they are free.
    pub(super) const FOLLOWS: bool =
        M::IMPLICIT && (!<Elements<S, R, C> as Shape<S>>::LINEAR || <Elements<S, R, C> as Shape<S>>::ROTARY);
    /// Whether these are read where they are free: by a rule that remembers, where all laws are linear.
    pub(super) const STAYS: bool = M::REMEMBERS && <Elements<S, R, C> as Shape<S>>::LINEAR;

    /// Sweeps of a stage up to one of them, which stands in `stage` and `slope`.
    #[allow(clippy::type_complexity)] // two in one argument
    fn sweeps(
        &mut self,
        (row, sweeps): (usize, usize),
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        (slopes, stages): (&[RateOf<S, R, C>], &[StageOf<S, R, C, P, L>]),
        (free, led, mut between): (
            &mut Place<S, R, C>,
            &mut RateOf<S, R, C>,
            Option<&mut Projection<S, Elements<S, R, C>>>,
        ),
        (stage, slope): (&mut StageOf<S, R, C, P, L>, &mut RateOf<S, R, C>),
    ) {
        let (springs, node) = (self.rule.springs::<S::Scalar>(row, step), M::node(row));
        if const { M::REMEMBERS } {
            self.remember(past, step, slopes, free);
        } else {
            let sums = (&self.zero, &mut self.sum);
            Self::displace(row, past, slopes, step, sums, (&mut free.0, &mut free.1));
        }
        for sweep in 0..sweeps {
            // A prediction without accelerations, or where they lead.
            let predicted = M::REMEMBERS && sweep == 0;
            let before = row.checked_sub(1).filter(|_| !predicted && sweep == 0);
            let last = if sweep > 0 { &*slope } else { &self.zero };
            let by = before.and_then(|before| slopes.get(before)).unwrap_or(last);
            if Self::FOLLOWS {
                let last = if sweep > 0 { Self::found(stage, slope) } else { &self.zero };
                let found = before.and_then(|row| Some(Self::found(stages.get(row)?, slopes.get(row)?)));
                led.set(if Self::STAYS { &self.zero } else { found.unwrap_or(last) });
            }
            if predicted {
                stage.position.drift_0(&past.position, (step, &past.rate));
                stage.rate.set(&past.rate);
            } else {
                self.lead((past, step), row, free, by, (&mut stage.position, &mut stage.rate));
            }
            let time = past.time + RealOf::<S>::of(node) * step;
            if let (true, Some(between), true) = (Self::RESTORED, &mut between, sweep > 0) {
                between.places[0].clone_from(&stage.position);
                between.rates[0].set(&stage.rate);
                self.project(time, stage, between);
                stage.position.clone_from(between.place());
                stage.rate.set(between.rate());
            }
            self.sweep(None, Some((&*free, &*led, predicted || Self::STAYS)), springs, time, stage, slope);
            if Self::CHARTED {
                stage.acceleration.set(slope);
                stage.position.inverse_retract_acceleration(&past.position, &stage.rate, slope);
            }
        }
    }

    /// Exchanges the costates of a row for those of the motion.
    fn exchange(&mut self, row: usize, gradient: &mut GradientOf<S, R, C, L>) {
        core::mem::swap(&mut self.of_position.as_mut()[row], &mut gradient.start.position);
        core::mem::swap(&mut self.of_rate.as_mut()[row], &mut gradient.start.rate);
    }

    /// Solves a stage: its last sweep is kept.
    pub(super) fn solve(
        &mut self,
        row: usize,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        record: &mut RecordOf<S, R, C, P, M, L>,
    ) {
        let (slopes, rest) = record.accelerations.as_mut().split_at_mut(row);
        let [slope, ..] = rest else { return };
        let sweeps = self.rule.sweeps(row);
        let (stages, rest) = record.stages.as_mut().split_at_mut(row);
        let [stage, ..] = rest else { return };
        // Taken last, for what is taken has to be put back.
        let Some(mut room) = self.again.take() else { return };
        let again = &mut *room;
        let mut between = None;
        if const { Self::RESTORED } {
            between = self.between.take();
        }
        self.sweeps(
            (row, sweeps),
            past,
            step,
            (slopes, stages),
            (&mut again.free, &mut again.led, between.as_deref_mut()),
            (stage, slope),
        );
        if const { Self::RESTORED } {
            self.between = between;
        }
        self.again = Some(room);
    }

    /// From the costates of the accelerations of a stage to those of the positions and rates where it would be without.
    pub(super) fn pull_back_solution(
        &mut self,
        row: usize,
        past: &MotionOf<S, R, C, P>,
        step: RealOf<S>,
        record: &RecordOf<S, R, C, P, M, L>,
        gradient: &mut GradientOf<S, R, C, L>,
    ) {
        let (last, [own, by_size]) = (self.rule.sweeps(row), self.rule.own::<S::Scalar>(step));
        let ([in_position, in_rate], one) = (own, RealOf::<S>::of(1.0));
        let by_own = |of: (&_, &_), slope: &_| paired::<S, Elements<S, R, C>>(by_size, of, slope);
        let time = past.time + RealOf::<S>::of(M::node(row)) * step;
        let Some(mut taken) = self.again.take() else { return };
        let again = &mut *taken;
        if row + 1 < M::STAGES {
            self.of_acceleration.add(&again.of_before);
        }
        again.of_free.0.set(&self.zero);
        again.of_free.1.set(&self.zero);
        again.of_geometry.0.set(&self.zero);
        again.of_geometry.1.set(&self.zero);
        if let (true, Some(room)) = (Self::STAYS, &self.room) {
            again.of_free.0.set(&room.of_free.0);
            again.of_free.1.set(&room.of_free.1);
        }
        let mut between = None;
        if const { Self::RESTORED } {
            between = self.between.take();
        }
        for sweep in (1..=last).rev() {
            let Again { free, read, stage, slope, of_free, of_geometry, led, of_read, of_led, .. } = &mut *again;
            // The last sweep is known, but not where it was free, nor what led there.
            let known = sweep == last && !Self::FOLLOWS;
            let sweeps = if known { 0 } else { sweep };
            let kept = (record.accelerations.as_ref(), record.stages.as_ref());
            let room = (&mut *free, &mut *led, between.as_deref_mut());
            self.sweeps((row, sweeps), past, step, kept, room, (&mut *stage, &mut *slope));
            let kept = (&record.stages.as_ref()[row], &record.accelerations.as_ref()[row]);
            let (stage, slope) = if sweep == last { kept } else { (&*stage, &*slope) };
            if sweep < last {
                // The geometry of the sweep after this one.
                if let Some(between) = &mut between {
                    let Projection { places: [place, ..], rates: [rate, ..], .. } = &mut **between;
                    self.lead((past, step), row, free, slope, (place, rate));
                    self.project(time, stage, between);
                    self.exchange(row, gradient);
                    self.pull_back_projection((time, step), (stage, &stage.position, None), between, gradient);
                    self.exchange(row, gradient);
                    if Self::CHARTED {
                        self.unlead((past, row), (&between.places[0], &between.rates[0]), gradient);
                    }
                }
                let (of_place, of_speed) = (&mut self.of_position.as_mut()[row], &self.of_rate.as_ref()[row]);
                if const { M::REMEMBERS } {
                    let (from, into) = ((&free.0, &free.1), (&mut read.0, &mut read.1));
                    follow::<S, Elements<S, R, C>>(from, own, slope, &self.zero, into);
                    unfollow((&read.0, &free.0), (&self.zero, &mut self.sum), of_place, &mut of_free.0);
                    of_free.1.add(of_speed);
                } else {
                    of_geometry.0.add(of_place);
                    of_geometry.1.add(of_speed);
                }
                self.of_acceleration.mix_2(&self.zero, (in_position, of_place), (in_rate, of_speed));
            }
            if let Some(sum) = &mut self.of_own {
                // By the geometry of the sweep after this one, and below by what laws add to `of_free`.
                if sweep < last {
                    *sum += by_own((&self.of_position.as_ref()[row], &self.of_rate.as_ref()[row]), slope);
                }
                *sum -= by_own((&of_free.0, &of_free.1), slope);
            }
            if Self::CHARTED {
                self.of_second.set(&self.of_acceleration);
                stage.position.transposed_acceleration(&past.position, &mut self.of_acceleration);
            }
            if Self::FOLLOWS && !Self::STAYS && (sweep < last || row + 1 < M::STAGES) {
                // Of the sweep after this one, in this stage or the next.
                self.of_acceleration.add(of_led);
            }
            self.pull_back_stage(None, (row, false), time, (stage, slope), gradient);
            let restored = if sweep == last { row + 1 == M::STAGES } else { M::RESTORES };
            if let (Some(room), true) = (&self.room, restored) {
                self.of_position.as_mut()[row].add(&room.of_stage);
                if Self::FOLLOWS {
                    self.of_rate.as_mut()[row].add(&room.of_speed);
                }
            }
            follow::<S, Elements<S, R, C>>((&free.0, &free.1), own, slope, &self.zero, (&mut read.0, &mut read.1));
            let predicted = M::REMEMBERS && sweep == 1;
            if Self::FOLLOWS {
                of_led.set(led);
                led.mix_2(&self.zero, (one, of_led), (-one, Self::found(stage, slope)));
                of_read.0.set(&self.zero);
                of_read.1.set(&self.zero);
                of_led.set(&self.zero);
            }
            let stays = predicted || Self::STAYS;
            let at = if stays { (&free.0, &free.1, &*led) } else { (&stage.position, &stage.rate, &*led) };
            let (w, of_position, of_rate) = (&self.of_acceleration, &mut of_free.0, &mut of_free.1);
            let of_at = (&mut of_read.0, &mut of_read.1, &mut *of_led);
            let stores = (&read.0, &read.1, w, &mut gradient.joints, &mut *of_position, &mut *of_rate, at, of_at);
            let mut walk = Strain::by([own, by_size]);
            self.scene.elements().take(&mut walk, (), stores);
            if let Some(sum) = &mut self.of_own {
                *sum += by_own((&*of_position, &*of_rate), slope) + walk.of_size;
            }
            if Self::FOLLOWS && stays {
                of_free.0.add(&of_read.0);
                of_free.1.add(&of_read.1);
            } else if Self::FOLLOWS {
                self.of_position.as_mut()[row].add(&of_read.0);
                self.of_rate.as_mut()[row].add(&of_read.1);
            }
            if Self::CHARTED {
                let (here, of_past) = ((&stage.rate, &stage.acceleration), &mut gradient.start.position);
                let of_here = (&mut self.of_position.as_mut()[row], &mut self.of_rate.as_mut()[row]);
                stage.position.transposed_second(&past.position, here, &self.of_second, of_here, of_past);
                // What has been put back is led there by the sweep before.
                if !Self::RESTORED || sweep == 1 {
                    self.unlead((past, row), (&stage.position, &stage.rate), gradient);
                }
            }
        }
        if const { Self::RESTORED } {
            self.between = between;
        }
        let (of_place, of_speed) = (&self.of_position.as_ref()[row], &self.of_rate.as_ref()[row]);
        if const { M::REMEMBERS } {
            again.of_geometry.0.set(of_place);
            again.of_geometry.1.set(of_speed);
        } else {
            if Self::CHARTED {
                // What laws read; geometries have given the motion before the step its share.
                gradient.start.position.add(&again.of_free.0);
            }
            again.of_free.0.add(&again.of_geometry.0);
            again.of_free.1.add(&again.of_geometry.1);
            again.of_free.0.add(of_place);
            again.of_free.1.add(of_speed);
            again.of_before.mix_2(&self.zero, (in_position, of_place), (in_rate, of_speed));
        }
        if let (Some(sum), Some(before), false) = (&mut self.of_own, row.checked_sub(1), M::REMEMBERS) {
            let (of_geometry, slopes) =
                ((&self.of_position.as_ref()[row], &self.of_rate.as_ref()[row]), record.accelerations.as_ref());
            *sum += by_own(of_geometry, &slopes[before]);
        }
        self.of_position.as_mut()[row].set(&again.of_free.0);
        self.of_rate.as_mut()[row].set(&again.of_free.1);
        self.again = Some(taken);
    }
}
