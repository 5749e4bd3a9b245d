//! What is compared at one state.

use super::census::{Census, Releases, places};
use super::{Disagreement, Doubt, Dual, Over, Varied};
use crate::element::{Element, Implicit, Reading, Space, SpaceOver, Unloaded};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::lift::Lift;
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::release::Release;
use crate::system::{Inertial, MotionOf, RateOf, Runs, StiffDynamics, System, coordinates, numbers, set, unit};
use crate::transfer::Exact;
use crate::walks::travel::show;
use std::vec::Vec;

/// How forces may differ, as a share of the largest term, and how derivatives may from differences.
const SHARE: f64 = 1e-9;
const DIFFERENCES: f64 = 1e-5;

/// A random state.
pub(super) struct Trial<'a, S: SpaceOver<Dual, Scalar = f64>, R, C, P>
where
    R: Root<S> + Lift<f64, Dual, Over: Root<S::Over>>,
    C: Element<S> + Lift<f64, Dual, Over: Element<S::Over>>,
    P: Tip<S> + Lift<f64, Dual, Over: Tip<S::Over>>,
{
    pub(super) scene: &'a System<S, R, C, P>,
    pub(super) varied: &'a Varied<S, R, C, P>,
    pub(super) motion: &'a MotionOf<S, R, C, P>,
    pub(super) trial: usize,
}

impl<S, R, C, P> Trial<'_, S, R, C, P>
where
    S: Inertial + Space<Scalar = f64> + SpaceOver<Dual>,
    R: Root<S> + Lift<f64, Dual, Over: Root<S::Over>>,
    C: Element<S> + Lift<f64, Dual, Over: Element<S::Over>>,
    P: Tip<S> + Lift<f64, Dual, Over: Tip<S::Over>>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P> + StiffDynamics<Unloaded>,
    Varied<S, R, C, P>: Runs<Unloaded, S::Over, Over<R>, Over<C>, Over<P>>,
{
    /// Fails where two numbers differ by more than an error.
    pub(super) fn same(
        &self,
        what: &'static str,
        coordinate: usize,
        [found, expected]: [f64; 2],
        error: f64,
    ) -> Result<(), Doubt> {
        if (found - expected).abs() <= error {
            return Ok(());
        }
        Err(Doubt::Disagreement(Disagreement { what, found, expected, trial: self.trial, coordinate }))
    }

    /// What bodies and joints are at a motion.
    fn census<const N: usize>(&self, motion: &MotionOf<S, R, C, P>) -> Census<S, N>
    where
        S: Exact<N>,
    {
        let mut census = Census { gravity: self.scene.gravity(), bodies: Vec::new(), joints: Vec::new() };
        show(self.scene.elements(), self.scene.ground(motion.time), coordinates(motion), &mut census);
        census
    }

    /// Virtual power: for a unit rate of each coordinate that of inertia forces, and of what the law of that coordinate exerts on it,
    /// where the laws are read at `state` or at the motion itself.
    pub(super) fn power<const N: usize>(
        &self,
        what: &'static str,
        state: Option<&MotionOf<S, R, C, P>>,
    ) -> Result<(), Doubt>
    where
        S: Exact<N>,
    {
        let motion = self.motion;
        let (here, read) = (self.census::<N>(motion), self.census::<N>(state.unwrap_or(motion)));
        let accelerations = numbers(&motion.acceleration);
        let mut still = motion.clone();
        still.rate.replace(&mut |_| 0.0);
        still.acceleration.replace(&mut |_| 0.0);
        let ground = self.census::<N>(&still);
        let whole: f64 = here.bodies.iter().flat_map(|(force, _)| force).map(|x| x.abs()).sum();
        let freedoms = read.joints.iter().flat_map(|joint| {
            let own = joint.coordinates.iter().flatten().count();
            joint.coordinates.iter().flatten().map(move |freedom| (own, freedom))
        });
        for (j, (own, freedom)) in freedoms.enumerate() {
            // Springs of rotations are linear in other numbers than those that an implicit sweep seeks.
            if own > 2 && state.is_some() {
                continue;
            }
            set(&mut still.acceleration, unit(accelerations.len(), j));
            let moved = self.census::<N>(&still);
            let (mut sum, mut size) = (0.0, whole);
            for ((force, _), (with, without)) in
                here.bodies.iter().zip(moved.bodies.iter().zip(&ground.bodies).map(|(a, b)| (a.1, b.1)))
            {
                for i in 0..N / 2 {
                    // m is minus the torque on the outboard part.
                    let sign = if i < places(N) { 1.0 } else { -1.0 };
                    let term = sign * force[i] * (with[i] - without[i]);
                    (sum, size) = (sum + term, size + term.abs());
                }
            }
            let reflected = freedom.inertia * accelerations[j];
            let law = freedom.resistance.force;
            size += reflected.abs() + law.abs();
            self.same(what, j, [sum + reflected, law], SHARE * size)?;
        }
        Ok(())
    }

    /// A linearly implicit sweep, repeated until laws are read where it leads.
    pub(super) fn implicit<const N: usize>(&self) -> Result<(), Doubt>
    where
        S: Exact<N>,
    {
        let springs = Implicit { position: 2e-3, rate: 5e-2 };
        let mut workspace = self.scene.stiff_workspace();
        let (mut sought, mut led) = (self.motion.clone(), self.motion.clone());
        sought.acceleration.replace(&mut |_| 0.0);
        for _ in 0..60 {
            led.position.drift_0(&sought.position, (springs.position, &sought.acceleration));
            led.position.set_clocks(sought.time);
            led.rate.mix_1(&sought.rate, (springs.rate, &sought.acceleration));
            let here = (&sought.position, &sought.rate);
            let acceleration = sought.acceleration.clone();
            let reading = Reading { position: &led.position, rate: &led.rate, acceleration: &acceleration };
            let found = &mut led.acceleration;
            let time = sought.time;
            self.scene.implicit_accelerations(time, here, here, reading, springs, &Unloaded, &mut workspace, found);
            sought.acceleration.set(&led.acceleration);
        }
        led.position.drift_0(&sought.position, (springs.position, &sought.acceleration));
        led.position.set_clocks(sought.time);
        led.rate.mix_1(&sought.rate, (springs.rate, &sought.acceleration));
        let what =
            "implicit sweep against virtual power: a pivot that does not match, or slopes that are not the law's";
        Trial { scene: self.scene, varied: self.varied, motion: &sought, trial: self.trial }
            .power::<N>(what, Some(&led))
    }

    /// An implicit sweep whose springs move with nothing, whatever acceleration is said to have led to where laws are read.
    pub(super) fn unmoved(&self, along: &RateOf<S, R, C>) -> Result<(), Doubt> {
        let (springs, mut workspace) = (Implicit { position: 0.0, rate: 0.0 }, self.scene.stiff_workspace());
        let Motion { time, position, rate, acceleration, .. } = self.motion;
        let (mut found, reading) = (acceleration.clone(), Reading { position, rate, acceleration: along });
        let here = (position, rate);
        self.scene.implicit_accelerations(*time, here, here, reading, springs, &Unloaded, &mut workspace, &mut found);
        let what = "implicit sweep without a step against explicit sweep: a pivot that does not grow with `springs`";
        let [found, expected] = [&found, acceleration].map(numbers);
        let size = expected.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
        let mut pairs = found.into_iter().zip(expected).enumerate();
        pairs.try_for_each(|(j, (found, expected))| self.same(what, j, [found, expected], SHARE * size))
    }

    /// Whether ground or drives move bodies, given the motion without rates: they have a power of their own then.
    fn is_carried(&self, still: &MotionOf<S, R, C, P>) -> Result<bool, Doubt> {
        let mut later = self.motion.clone();
        later.time += 1e-3;
        later.position.set_clocks(later.time);
        let [now, then, still] = [self.motion, &later, still].map(|motion| self.scene.budget(motion));
        Ok(now?.energy() != then?.energy() || still?.kinetic != 0.0)
    }

    /// dE/dt along the motion, and the power of dampers, where nothing else has any.
    pub(super) fn energy(&self) -> Result<(), Doubt> {
        let (rate, acceleration) = (numbers(&self.motion.rate), numbers(&self.motion.acceleration));
        let moving = self.seeded(&rate, &acceleration);
        let budget = self.varied.budget(&moving)?;
        let found = budget.energy().eps[0];
        self.same("energy: it is no number", 0, [budget.energy().re; 2], 0.0)?;
        let mut still = self.motion.clone();
        still.rate.replace(&mut |_| 0.0);
        if self.is_carried(&still)? {
            return Ok(());
        }
        let (with, without) = (self.releases(self.motion), self.releases(&still));
        let forces = |joints: &[Release<S>]| -> Vec<f64> {
            let freedoms = joints.iter().flat_map(|joint| joint.coordinates.iter().flatten());
            freedoms.map(|freedom| freedom.resistance.force).collect()
        };
        let mut damped = 0.0;
        for ((with, without), rate) in forces(&with).iter().zip(forces(&without)).zip(&rate) {
            damped += (with - without) * rate;
        }
        let energies = [budget.kinetic, budget.potential];
        let size = energies.iter().map(|x| x.re.abs() + x.eps[0].abs()).sum::<f64>() + damped.abs();
        let what = "rate of energy against power: energy that does not match force or inertia, or motion that is no derivative";
        self.same(what, 0, [found, damped], SHARE * size)
    }

    /// Slopes of laws of one coordinate, and derivatives of their forces.
    pub(super) fn slopes(&self) -> Result<(), Doubt> {
        let count = numbers(&self.motion.rate).len();
        let joints = self.releases(self.motion);
        let owners = joints.iter().enumerate().flat_map(|(k, joint)| {
            let own = joint.coordinates.iter().flatten().count();
            (0..own).map(move |_| (k, own))
        });
        for (j, (k, own)) in owners.enumerate() {
            let Some(freedom) = joints[k].coordinates[0].filter(|_| own == 1) else { continue };
            let (unit, none): (Vec<f64>, Vec<f64>) = (unit(count, j).collect(), (0..count).map(|_| 0.0).collect());
            let slope = |position: &[f64], rate: &[f64]| {
                let varied = self.varied_releases(position, rate);
                varied
                    .get(k)
                    .and_then(|joint| joint.coordinates[0])
                    .map_or(f64::NAN, |own| -own.resistance.force.eps[0])
            };
            let [stiffness, damping] = [slope(&unit, &none), slope(&none, &unit)];
            let size = stiffness.abs() + damping.abs();
            let what = "stiffness of a law against the derivative of its force";
            self.same(what, j, [freedom.resistance.stiffness, stiffness], SHARE * size)?;
            let what = "damping of a law against the derivative of its force";
            self.same(what, j, [freedom.resistance.damping, damping], SHARE * size)?;
        }
        Ok(())
    }

    /// The force at the root by transfer matrices, and what inertia asks for.
    pub(super) fn matrices<const N: usize>(&self) -> Result<(), Doubt>
    where
        S: Exact<N>,
    {
        let state = match self.scene.root_state(self.motion, &Unloaded) {
            Ok(state) => state,
            Err(Error { fault: Fault::Unsupported { .. } | Fault::SingularTransfer, .. }) => return Ok(()),
            Err(error) => return Err(error.into()),
        };
        let bodies = self.census::<N>(self.motion).bodies;
        for i in 0..places(N) {
            let expected = bodies.iter().map(|(force, _)| force[i]).sum();
            let size: f64 =
                bodies.iter().map(|(force, _)| force[..places(N)].iter().map(|x| x.abs()).sum::<f64>()).sum();
            let found = state[N - 1 - places(N) + i];
            // Products lose digits.
            let what = "force at the root by transfer matrices: a joint whose description does not match its gains";
            self.same(what, i, [found, expected], 1e3 * SHARE * size)?;
        }
        Ok(())
    }

    /// Derivatives of accelerations in a direction, and differences.
    pub(super) fn derivatives(&self, along: &<(R::Joint, C) as Element<S>>::Rate) -> Result<(), Doubt> {
        let direction = numbers(along);
        let turned: Vec<f64> = direction.iter().rev().copied().collect();
        let found = self.varied.with_accelerations(self.seeded(&direction, &turned), &Unloaded)?;
        let mut across = along.clone();
        set(&mut across, turned.iter().copied());
        let step = 1e-5;
        let at = |reach: f64| {
            let mut there = self.motion.clone();
            there.position.drift_0(&self.motion.position, (reach, along));
            there.position.set_clocks(self.motion.time);
            there.rate.mix_1(&self.motion.rate, (reach, &across));
            self.scene.with_accelerations(there, &Unloaded).map(|there| numbers(&there.acceleration))
        };
        let (ahead, back) = (at(step)?, at(-step)?);
        let derivatives: Vec<f64> = numbers(&found.acceleration).iter().map(|x| x.eps[0]).collect();
        let differences = ahead.iter().zip(&back).map(|(a, b)| (a - b) / (step + step));
        let size =
            derivatives.iter().chain(&numbers(&self.motion.acceleration)).fold(1.0, |most: f64, x| most.max(x.abs()));
        for (j, (found, expected)) in derivatives.iter().zip(differences).enumerate() {
            let what = "derivative of an acceleration against differences: a number that was not lifted";
            self.same(what, j, [*found, expected], DIFFERENCES * size)?;
        }
        Ok(())
    }

    /// The motion over numbers with one derivative, along these changes of positions and rates.
    pub(super) fn seeded(&self, position: &[f64], rate: &[f64]) -> MotionOf<S::Over, Over<R>, Over<C>, Over<P>> {
        let mut motion = self.varied.motion().at_time(self.motion.time);
        let mut stored = Vec::new();
        self.motion.position.visit(&mut |x| stored.push(x));
        let mut stored = stored.into_iter();
        motion.position.replace(&mut |_| Dual::of(stored.next().unwrap_or(f64::NAN)));
        let seeded = |re: f64, eps: f64| Dual { re, eps: [eps] };
        let mut step = motion.rate.clone();
        set(&mut step, position.iter().map(|x| seeded(0.0, *x)));
        motion.position.displace(&step);
        let rates = numbers(&self.motion.rate);
        set(&mut motion.rate, rates.iter().zip(rate).map(|(v, a)| seeded(*v, *a)));
        motion
    }

    fn releases(&self, motion: &MotionOf<S, R, C, P>) -> Vec<Release<S>> {
        let mut releases = Releases(Vec::new());
        show(self.scene.elements(), self.scene.ground(motion.time), coordinates(motion), &mut releases);
        releases.0
    }

    fn varied_releases(&self, position: &[f64], rate: &[f64]) -> Vec<Release<S::Over>> {
        let motion = self.seeded(position, rate);
        let mut releases = Releases(Vec::new());
        let ground = self.varied.ground(motion.time);
        show(self.varied.elements(), ground, coordinates(&motion), &mut releases);
        releases.0
    }
}
