//! Motions with their tip where it is held and their loops closed.

use crate::element::{Element, Level, Loading, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::loading::couples;
use crate::mirror::{Mode, Position, Rate, let_all_go};
use crate::observe::loop_residual;
use crate::relation::{Closures, Solvable, largest};
use crate::scalar::{Elementary, Real, Scalar};
use crate::system::{Dynamics, MotionOf, PositionOf, Runs, System, coordinates};
use num_traits::{One, Zero};

/// Corrections of a guess before it counts as one that leads nowhere.
pub(super) const CORRECTIONS: usize = 60;
/// The longest correction of a coordinate (rad, m) at once.
const SHARE: f64 = 0.3;

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// This motion with its loops closed and its tip where it is held: the least correction of positions and rates, as measured
    /// by the inertia of the scene (of a chain without loops from afar, by the angles), and the accelerations that belong to them. A
    /// scene with neither is left as it is, but for its accelerations and for joints that loads [couple](crate::planar::Couplings). What must not move is held by
    /// [`assembled_holding`](Self::assembled_holding), which also tells what did (feature `alloc`). A straight chain or loop cannot tell where to bend: bend it.
    ///
    /// Corrections from afar (a coordinate by more than 0.3 rad or m) are cut short, over lanes each by itself. Which of them are is decided by all
    /// lanes together: from afar one of them may find another start than it would alone, where several are next to the guess.
    ///
    /// ```
    /// use catena::loading::Unloaded;
    /// use catena::planar::*;
    /// let rod = |length| Rod::uniform(length, 1.0);
    /// let four_bar = System::new(Pinned::origin(), (rod(0.5), Pin, rod(1.2), Pin, rod(0.9)), Pinned::at(1.0, 0.0))?;
    /// let start = four_bar.assembled(four_bar.at_rest(&[1.0, 0.3, -2.0])?, &Unloaded)?;
    /// let tip = four_bar.stations(&start, &Unloaded)?.tip().frame.place;
    /// assert!((tip.x - 1.0_f64).abs() < 1e-15 && tip.y.abs() < 1e-15);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::NotClosed`] where no correction leads there, at the place that misses most, or where loops that [`LeastNorm`](crate::chain::LeastNorm)
    /// closes stay open by more than 1e-5 of their size; those of [`with_accelerations`](Self::with_accelerations).
    pub fn assembled<L: Loading<S>>(
        &self,
        mut motion: MotionOf<S, R, C, P>,
        loads: &L,
    ) -> Result<MotionOf<S, R, C, P>, Error>
    where
        Self: Runs<L, S, R, C, P>,
    {
        let mut workspace = self.workspace();
        self.hold(&mut motion, loads, &mut workspace)?;
        Ok(motion)
    }

    /// Tells which closure forces the motion does not decide, by the station of the joint that closes the loop and by what they hold:
    /// those of loops that are held more often than they can move, where [`LeastNorm`](crate::chain::LeastNorm) has chosen among them.
    ///
    /// # Errors
    /// Those of [`with_accelerations`](Self::with_accelerations).
    pub fn shared_forces<L: Loading<S>>(
        &self,
        motion: &MotionOf<S, R, C, P>,
        loads: &L,
        mut report: impl FnMut(usize, &'static str),
    ) -> Result<(), Error>
    where
        Self: Runs<L, S, R, C, P>,
    {
        let (mut motion, mut workspace) = (motion.clone(), self.workspace());
        self.accelerate(&mut motion, loads, &mut workspace)?;
        self.independent(&motion, &workspace, 0.0, &mut |entry, name| report(entry.saturating_sub(1), name))
    }

    /// [`assembled`](Self::assembled) in place: joints move that stick or rest in the run to come.
    pub(crate) fn hold<L: Loading<S>>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        loads: &L,
        workspace: &mut <Self as Dynamics<L>>::Workspace,
    ) -> Result<(), Error>
    where
        Self: Runs<L, S, R, C, P>,
    {
        if const { !PositionOf::<S, R, C>::MODES } {
            return self.close(motion, loads, workspace);
        }
        let mut modes = motion.rate.clone();
        motion.position.each_mode(&mut modes, &motion.acceleration, &mut |mode, kept, told| {
            *kept = mode.number();
            *mode = mode.moving(told.rubs);
        });
        let outcome = self.close(motion, loads, workspace);
        motion.position.each_mode(&mut modes, &motion.acceleration, &mut |mode, kept, _| *mode = Mode::numbered(*kept));
        outcome?;
        self.accelerate_held(motion, loads, workspace)
    }

    /// Finds the accelerations of a motion that is closed. Where more joints stick than closures leave free to move all are let go: what they do
    /// is for the run to find.
    pub(super) fn accelerate_held<L: Loading<S>>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        loads: &L,
        workspace: &mut <Self as Dynamics<L>>::Workspace,
    ) -> Result<(), Error>
    where
        Self: Runs<L, S, R, C, P>,
    {
        let accelerated = self.accelerate(motion, loads, workspace);
        let overlocked = matches!(accelerated, Err(Error { fault: Fault::RedundantClosures { .. }, .. }));
        if !(PositionOf::<S, R, C>::MODES && overlocked) {
            return accelerated;
        }
        let_all_go(&mut motion.position, &mut motion.rate, &motion.acceleration);
        self.accelerate(motion, loads, workspace)
    }

    fn close<L: Loading<S>>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        loads: &L,
        workspace: &mut <Self as Dynamics<L>>::Workspace,
    ) -> Result<(), Error>
    where
        Self: Runs<L, S, R, C, P>,
    {
        if Self::CLOSED == 0 {
            self.join(motion, loads, workspace)?;
            return self.accelerate(motion, loads, workspace);
        }
        self.accelerate(motion, loads, workspace)?;
        let (coupled, real) = (const { couples::<S, L>() }, RealOf::<S>::of);
        let (small, tiny) = Self::tolerances();
        let mut last = RealOf::<S>::INFINITY;
        for pass in 0..CORRECTIONS {
            let mut corrected = motion.clone();
            self.project(&mut corrected, loads, workspace);
            let step = self.correction(motion, &corrected);
            if step <= real(SHARE) {
                *motion = corrected;
            } else if Self::LOOPED || coupled {
                self.assembly_step(motion, loads, workspace);
            } else {
                self.approach(motion);
            }
            let outcome = self.accelerate(motion, loads, workspace);
            // On the way a loop may be where it could not stay.
            let passing = (Self::LOOPED || coupled)
                && step > real(SHARE)
                && matches!(outcome, Err(Error { fault: Fault::RedundantClosures { .. }, .. }));
            if !passing {
                outcome.map_err(|error| self.unreached(motion, error))?;
            }
            // Corrections fall until nothing but rounding is left of them. Not the first one, even if it is small: derivatives of
            // dual numbers follow real parts.
            if pass > 0 && (step <= tiny || (step <= small && step + step >= last)) {
                self.closes(motion)?;
                return self.joined(motion, loads, |residual| Fault::NotClosed { residual });
            }
            last = step;
        }
        self.joined(motion, loads, |residual| Fault::NotClosed { residual })?;
        let (residual, place) = self.largest_residual(motion, Level::Place);
        Err(Error::new(Fault::NotClosed { residual: residual.as_f64() }).at(place).at_time(motion.time.as_f64()))
    }

    /// The largest correction of a coordinate, relative to it where it is larger than one; infinite where there is none.
    pub(super) fn correction(&self, motion: &MotionOf<S, R, C, P>, corrected: &MotionOf<S, R, C, P>) -> RealOf<S> {
        let (mut step, mut displacement) = (RealOf::<S>::zero(), motion.rate.clone());
        corrected.position.apart(&motion.position, &mut displacement);
        motion.position.measure(&displacement, &mut |x, size| {
            let share = x.real().abs() / size.real().max(RealOf::<S>::one());
            // A rotation by more than half a turn has no coordinates, and corrections that do not close a loop are not finite.
            step = if share.is_finite() { step.max(share) } else { RealOf::<S>::INFINITY };
        });
        step
    }

    /// What is wrong where closures came to depend on each other on the way: a guess that is drawn to what it cannot reach is stretched.
    fn unreached(&self, motion: &MotionOf<S, R, C, P>, error: Error) -> Error {
        let (residual, place) = self.largest_residual(motion, Level::Place);
        let open = residual > RealOf::<S>::EPSILON.sqrt() && matches!(error.fault, Fault::RedundantClosures { .. });
        if open { Error { fault: Fault::NotClosed { residual: residual.as_f64() }, ..error }.at(place) } else { error }
    }

    /// Corrections (relative to coordinates) that are small enough to be the last ones when they fall no more, and those that are
    /// rounding.
    pub(crate) fn tolerances() -> (RealOf<S>, RealOf<S>) {
        (RealOf::<S>::EPSILON.powf(RealOf::<S>::of(0.6)), RealOf::<S>::EPSILON)
    }

    /// The largest residual of all that is held (m, rad, or these a second), and its place.
    pub(crate) fn largest_residual(&self, motion: &MotionOf<S, R, C, P>, level: Level) -> (RealOf<S>, Place) {
        let [place, velocity] = self.residual(motion);
        let at_tip = largest::<S::Scalar, P::Closures>(match level {
            Level::Place => &place,
            Level::Velocity => &velocity,
        });
        let (in_loop, station) = loop_residual(&self.chain, self.root.ground(motion.time), coordinates(motion), level);
        if in_loop > at_tip { (in_loop, Place::Station(station)) } else { (at_tip, Place::Tip) }
    }

    /// Moves the tip towards where it is held by the least change of all coordinates alike, and not too far at once. From afar
    /// this is better than the least effort: the last links of a long chain are so light that they would do all the turning.
    fn approach(&self, motion: &mut MotionOf<S, R, C, P>) {
        let mut moving = motion.clone();
        let mut freedoms = 0;
        moving.rate.replace(&mut |_| {
            freedoms += 1;
            S::Scalar::zero()
        });
        let [place, drift] = self.residual(&moving);
        let mut lever = |j: usize| {
            let mut i = 0;
            moving.rate.replace(&mut |_| {
                i += 1;
                if i == j + 1 { S::Scalar::one() } else { S::Scalar::zero() }
            });
            let [_, velocity] = self.residual(&moving);
            P::Closures::zip(&velocity, &drift, |with, without| with - without)
        };
        let mut pairs = P::Closures::no_pairs();
        for j in 0..freedoms {
            let lever = lever(j);
            pairs = P::Closures::minus_outer(&pairs, &lever, &lever);
        }
        let pull = P::Closures::solve(&pairs, &place);
        let (mut step, mut j) = (motion.rate.clone(), 0);
        step.replace(&mut |_| {
            let x = P::Closures::plus_dot(S::Scalar::zero(), &lever(j), &pull);
            j += 1;
            x
        });
        shorten(&mut step);
        motion.position.displace(&step);
    }
}

/// Makes a correction that is too far for one which is linear as long as one may be, with the derivatives of that, and each lane by itself.
pub(super) fn shorten<T: Scalar>(step: &mut impl Rate<T>) {
    let share = T::constant(T::Real::of(SHARE));
    let mut most = share;
    step.visit(&mut |x| most = (x.abs() - most).if_negative(most, x.abs()));
    let factor = share / most;
    step.replace(&mut |x| x * factor);
}
