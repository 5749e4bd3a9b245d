//! Static equilibrium: the position at which a sweep finds no accelerations.

use super::fall::{Fall, ROUNDED, Step};
use super::inertial::Inertial;
use super::lists::{numbers, set};
use super::{Dynamics, MotionOf, PositionOf, Runs, StiffDynamics, System};
use crate::element::{Element, Loading, RealOf};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mirror::{Position, Rate};
use crate::scalar::{Real, Scalar};
use num_traits::Zero;

/// Steps before a guess counts as one that leads nowhere.
const STEPS: usize = 500;
/// Longest step of a coordinate (rad, m).
const LONGEST: f64 = 0.5;
/// A guess so near to an equilibrium (rad, m, of all coordinates together) is meant, whether that is stable or not.
const NEAR: f64 = 0.01;
/// How far a coordinate (rad, m) is led off a saddle.
const OFF: f64 = 0.05;
/// Share of the work expected of a step that it must do.
const GAIN: f64 = 0.2;
/// Steps once real parts have come to rest, each of which settles another order of derivatives.
const ORDERS: usize = 3;
/// Steps so short (rad, m) need no proof that they lead downhill.
const SHORT: f64 = 1e-4;

impl<S: Inertial, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// The static equilibrium near a guess: the motion at rest with the time of the guess at which the accelerations of all
    /// coordinates vanish under gravity, springs and loads. Its forces λ at a held tip are in its
    /// [`multipliers`](crate::Motion::multipliers), internal forces in its [`stations`](Self::stations).
    ///
    /// Newton's method on sweeps, K δ = M a, with the mass matrix M and accelerations a. K is how the forces M a change with
    /// position, which near rest is that of [`modes`](Self::modes). Far from equilibrium max(|K|, μ D) δ = M a leads downhill, as the work done on the way
    /// proves: D is the inertia of each coordinate by itself (about all axes of a ball alike), μ as large as it takes, and |K| turns back along the
    /// principal directions in which K drives on. Near a stable equilibrium digits double. A heavy load on a rope of 50 segments in space falls from the
    /// horizontal to rest in 27 steps. An unstable equilibrium is found from a guess within 0.01 rad of it, in all coordinates together; one that
    /// steps downhill lead to, as a straight guess to that of a beam which should buckle, is left on one of its sides. What is stiff along itself and
    /// hardly so across, as a cable that stretches, may take a hundred steps or more. A
    /// tip that the guess does not put where it is held is put there first, as by [`assembled`](Self::assembled), and so are joints that follow
    /// others ([`Couplings`](crate::planar::Couplings)). Loads are arbitrary functions of the motion, with a potential or without. What the ground and
    /// drives move goes on moving at the time of the guess: dampers there and centrifugal forces count.
    ///
    /// A step takes sixteen sweeps for each coordinate and dense algebra, so this is for some hundreds of coordinates. What is
    /// left is rounding: 4e-15 rad for a hundred links with springs, 1e-13 rad for a catenary of 150. Over dual numbers the
    /// equilibrium has derivatives to third order, to 12 digits. Lanes each have an equilibrium of their own, and are not supported.
    ///
    /// ```
    /// use catena::loading::Unloaded;
    /// use catena::planar::*;
    /// let rod = Rod::uniform(0.1_f64, 0.1);
    /// let chain = System::new(Pinned::origin(), (rod, [(Pin, rod); 9]), Pinned::at(0.8, 0.0))?.with_gravity(9.81);
    /// let guess = chain.at_rest(&[-0.5, -0.5, -0.5, -0.5, -0.5, 0.5, 0.5, 0.5, 0.5, 0.5])?;
    /// let rest = chain.equilibrium(guess, &Unloaded)?;
    /// assert!((rest.multipliers()[1] - 0.5 * 1.0 * 9.81).abs() < 1e-12); // the tip carries half of the weight (N)
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::NoEquilibrium`] with the acceleration left (a scene that falls freely has no equilibrium);
    /// [`Fault::NotClosed`] where the tip does not reach, or couplings contradict each other; [`Fault::Shape`]; [`Fault::Unsupported`] where joints stick and over lanes; those
    /// of a sweep.
    pub fn equilibrium<L: Loading<S>>(
        &self,
        guess: MotionOf<S, R, C, P>,
        loads: &L,
    ) -> Result<MotionOf<S, R, C, P>, Error>
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        Self::rests_alone()?;
        let real = RealOf::<S>::of;
        let mut workspace = self.workspace();
        let mut stiff = self.stiff_workspace();
        let mut now = guess;
        now.rate.replace(&mut |_| S::Scalar::zero());
        self.settle(&mut now, loads, &mut workspace)?;
        let (small, tiny) = (RealOf::<S>::EPSILON.powf(real(ROUNDED)), real(2.0) * RealOf::<S>::EPSILON);
        let (mut last, mut damping) = (RealOf::<S>::INFINITY, RealOf::<S>::zero());
        // Whether the equilibrium that steps lead to is meant, stable or not.
        let (mut meant, mut orders) = (false, None);
        for step in 0..STEPS {
            let linear = self.linearise(&now, loads, &mut stiff);
            let inertial = self.inertial_forces(&now, &linear.tangent, &linear.root);
            let fall = Fall::of(linear, inertial, &numbers(&now.acceleration));
            if fall.scale.is_zero() {
                return Ok(now); // nothing pulls, wherever it is
            }
            // Steps to what is near become shorter.
            meant = (meant || step == 0) && fall.newton(false).is_some_and(|step| step.way <= real(NEAR));
            let moved = fall.newton(!meant).and_then(|step| step.within(real(LONGEST))).and_then(|found| {
                self.moved(&now, &found, meant, loads, &mut workspace).map(|next| (found, next, RealOf::<S>::zero()))
            });
            let mut away = None;
            let (found, next, ladder) = match moved {
                Some(moved) => moved,
                None => {
                    let principal = fall.principal().ok_or_else(|| self.unsettled(&now))?;
                    away = fall.falls_away(&principal).then(|| fall.away(&principal));
                    // Any larger damping will do where a smaller one fails: steps become short.
                    let mut ladder = (real(64.0) * RealOf::<S>::EPSILON * fall.scale).max(damping * real(0.01));
                    loop {
                        if let Some(found) = fall.damped(&principal, ladder).filter(|found| found.size <= real(LONGEST))
                            && let Some(next) = self.moved(&now, &found, meant, loads, &mut workspace)
                        {
                            break (found, next, ladder);
                        }
                        ladder *= real(2.0);
                        if ladder > real(1e6) * fall.scale || !ladder.is_finite() {
                            return Err(self.unsettled(&now));
                        }
                    }
                }
            };
            damping = ladder;
            let settled = fall.settled(residual(&now.acceleration));
            let free = away.is_none() && ladder <= small * fall.scale;
            let stalled = found.size + found.size >= last && (found.size <= small || settled);
            (now, last) = (next, found.size);
            if settled && !(free || meant) {
                // Nothing pulls at a saddle. Without a potential stiffness does not say what one is: it is the equilibrium that was asked for.
                meant = !fall.has_potential();
                last = RealOf::<S>::INFINITY;
                if let Some(aside) = away.filter(|_| !meant)
                    && let Some(next) = self.off_saddle(&now, &aside, loads, &mut workspace)
                {
                    now = next;
                }
            }
            // Not the first step, even if it is short: the derivatives of dual numbers follow real parts.
            let rests = step > 0 && free && (found.size <= tiny || stalled);
            orders = match orders {
                Some(1) => return Ok(now),
                Some(left) => Some(left - 1),
                None if rests && is_plain(&now.position) => return Ok(now),
                None => rests.then_some(ORDERS),
            };
        }
        Err(self.unsettled(&now))
    }

    /// Refuses scenes in which joints have modes, for these rest anywhere within what friction and stops hold, and lanes, each of which rests elsewhere.
    pub(crate) fn rests_alone() -> Result<(), Error> {
        let refuse = |what| Err(Error::new(Fault::Unsupported { what }));
        match (PositionOf::<S, R, C>::MODES, S::Scalar::LANES) {
            (true, _) => refuse("equilibria and modes of vibration of joints that stick or have hard stops"),
            (_, true) => refuse("equilibria and modes of vibration of several lanes"),
            _ => Ok(()),
        }
    }

    /// Puts the tip where it is held and joints where they are coupled, without rates, and finds the accelerations.
    fn settle<L: Loading<S>>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        loads: &L,
        workspace: &mut <Self as Dynamics<L>>::Workspace,
    ) -> Result<(), Error>
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        self.hold(motion, loads, workspace)?;
        // A tip whose ground moves has given it rates.
        motion.rate.replace(&mut |_| S::Scalar::zero());
        self.accelerate(motion, loads, workspace)
    }

    /// The motion after a step, unless it leads uphill and not to what is meant.
    fn moved<L: Loading<S>>(
        &self,
        from: &MotionOf<S, R, C, P>,
        step: &Step<S::Scalar>,
        meant: bool,
        loads: &L,
        workspace: &mut <Self as Dynamics<L>>::Workspace,
    ) -> Option<MotionOf<S, R, C, P>>
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        let mut next = from.clone();
        let mut displacement = from.rate.clone();
        set(&mut displacement, step.displacement.iter().copied());
        next.position.displace(&displacement);
        self.settle(&mut next, loads, workspace).ok()?;
        if meant || step.size <= RealOf::<S>::of(SHORT) {
            return Some(next);
        }
        // The work of all forces, M a, on the way that it really went, by the trapezoidal rule.
        next.position.apart(&from.position, &mut displacement);
        let work = |at: &MotionOf<S, R, C, P>| {
            let (along, force) = (self.weighted(at, &displacement), self.weighted(at, &at.acceleration));
            along.iter().zip(force).fold(RealOf::<S>::zero(), |sum, (a, b)| sum + *a * b)
        };
        let (start, end) = (work(from), work(&next));
        (start + end > start.abs() * RealOf::<S>::of(GAIN)).then_some(next)
    }

    /// The motion a little way off a saddle, on one of its sides, to where its stiffness drives further.
    fn off_saddle<L: Loading<S>>(
        &self,
        saddle: &MotionOf<S, R, C, P>,
        aside: &[S::Scalar],
        loads: &L,
        workspace: &mut <Self as Dynamics<L>>::Workspace,
    ) -> Option<MotionOf<S, R, C, P>>
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        [OFF, -OFF].into_iter().find_map(|by| {
            let (mut next, mut displacement) = (saddle.clone(), saddle.rate.clone());
            set(&mut displacement, aside.iter().map(|x| x.scale(RealOf::<S>::of(by))));
            next.position.displace(&displacement);
            self.settle(&mut next, loads, workspace).ok().map(|()| next)
        })
    }

    fn unsettled(&self, motion: &MotionOf<S, R, C, P>) -> Error {
        Error::new(Fault::NoEquilibrium { residual: residual(&motion.acceleration).as_f64() })
            .at_time(motion.time.as_f64())
    }
}

/// Whether no number has derivatives.
fn is_plain<T: Scalar, Q: Position<T>>(position: &Q) -> bool {
    let mut plain = true;
    position.visit(&mut |x| plain &= x.is_identical(T::constant(x.real())));
    plain
}

/// The largest acceleration.
fn residual<T: Scalar, V: Rate<T>>(acceleration: &V) -> T::Real {
    let mut most = T::Real::zero();
    acceleration.visit(&mut |x| most = most.max(x.real().abs()));
    most
}
