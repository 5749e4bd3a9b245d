//! Ready-made observers: what a run is shown to.

use crate::element::{Element, Loading, Space};
use crate::ends::{Root, Tip};
#[cfg(feature = "std")]
use crate::mirror::{Position, Rate};
use crate::scalar::{Real, Scalar};
use crate::simulate::Now;

/// Looks at the instants of a run.
///
/// Closures do this too: [`Simulation::run`](crate::simulate::Simulation::run) takes one, and this trait's implementors fit in:
/// `|now| trace.observe(now)`.
pub trait Observe<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L: Loading<S>> {
    /// Looks at an instant.
    fn observe(&mut self, now: &Now<'_, S, R, C, P, L>);
}

/// How far the energy of a run strays from its first value.
///
/// ```
/// use catena::simulate::{EnergyDrift, Observe};
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0);
/// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
/// let mut drift = EnergyDrift::default();
/// pendulum.simulate(pendulum.at_rest(&[-1.0, -0.5])?, Dop853::tolerance(1e-12), 1.0, |now| drift.observe(now))?;
/// assert!(drift.largest() < 1e-11);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct EnergyDrift {
    start: Option<f64>,
    largest: f64,
}

impl EnergyDrift {
    /// The largest deviation so far (J).
    pub fn largest(&self) -> f64 {
        self.largest
    }
}

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L: Loading<S>> Observe<S, R, C, P, L> for EnergyDrift {
    fn observe(&mut self, now: &Now<'_, S, R, C, P, L>) {
        let energy = now.energy().real().as_f64();
        let start = *self.start.get_or_insert(energy);
        self.largest = f64::max(self.largest, (energy - start).abs());
    }
}

/// Writes each instant as a line of CSV: time, then position, rate and acceleration of every joint coordinate, then energy.
///
/// Numbers are written so that they read back exactly. Dual numbers and lanes write their real part.
///
/// ```
/// use catena::simulate::{Observe, Trace};
/// use catena::planar::*;
/// let pendulum = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?.with_gravity(9.81);
/// let mut trace = Trace::new(Vec::new());
/// let start = pendulum.at_rest(&[-1.0])?;
/// pendulum.simulation(Rk4::step(1e-2)).every(0.1).run(start, 0.2, |now| trace.observe(now))?;
/// let text = String::from_utf8(trace.finish()?)?;
/// assert!(text.starts_with("time,position_0,rate_0,acceleration_0,energy\n0,-1,0,"));
/// assert_eq!(text.lines().count(), 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[cfg(feature = "std")]
#[derive(Debug)]
pub struct Trace<W> {
    writer: W,
    started: bool,
    outcome: std::io::Result<()>,
}

#[cfg(feature = "std")]
impl<W: std::io::Write> Trace<W> {
    /// A trace written to `writer`, for example a buffered file.
    pub fn new(writer: W) -> Self {
        Self { writer, started: false, outcome: Ok(()) }
    }

    /// The writer, flushed.
    ///
    /// # Errors
    /// The first error that writing met; nothing was written after it.
    pub fn finish(mut self) -> std::io::Result<W> {
        self.outcome?;
        self.writer.flush()?;
        Ok(self.writer)
    }
}

#[cfg(feature = "std")]
impl<W: std::io::Write, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L: Loading<S>> Observe<S, R, C, P, L>
    for Trace<W>
{
    fn observe(&mut self, now: &Now<'_, S, R, C, P, L>) {
        if self.outcome.is_err() {
            return;
        }
        let motion = now.motion();
        let mut numbers = std::vec![now.time().as_f64()];
        let mut names = std::vec![std::string::String::from("time")];
        let mut note = |name: &str, k: &mut usize, x: S::Scalar| {
            numbers.push(x.real().as_f64());
            names.push(std::format!("{name}_{k}"));
            *k += 1;
        };
        let (mut p, mut r, mut a) = (0, 0, 0);
        motion.position().visit(&mut |x| note("position", &mut p, x));
        motion.rate().visit(&mut |x| note("rate", &mut r, x));
        motion.acceleration().visit(&mut |x| note("acceleration", &mut a, x));
        numbers.push(now.energy().real().as_f64());
        names.push("energy".into());
        let line: std::vec::Vec<_> = numbers.iter().map(std::string::ToString::to_string).collect();
        self.outcome = (|| {
            if !self.started {
                writeln!(self.writer, "{}", names.join(","))?;
                self.started = true;
            }
            writeln!(self.writer, "{}", line.join(","))
        })();
    }
}
