//! Ready-made observers: what a run is shown to.

use crate::element::{Element, Loading, Space};
use crate::ends::{Root, Tip};
#[cfg(feature = "std")]
use crate::mirror::{Position, Rate};
use crate::scalar::{Real, Scalar};
use crate::simulate::Now;
#[cfg(feature = "std")]
use crate::walks::parts::{Sort, parts};
#[cfg(feature = "std")]
use std::{format, string::String, vec::Vec};

/// How far the energy of a run strays from its first value, with the scene's kind of number: that of bodies and of springs in joints, so that what
/// struts and other loads take up and give back counts as if it were lost.
///
/// ```
/// use catena::simulate::EnergyDrift;
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0);
/// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
/// let mut drift = EnergyDrift::default();
/// pendulum.simulate(pendulum.at_rest(&[-1.0, -0.5])?, Dop853::tolerance(1e-12), 1.0, |now| drift.observe(now))?;
/// assert!(drift.largest() < 1e-11);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct EnergyDrift<T = f64> {
    start: Option<T>,
    largest: f64,
}

impl<T> Default for EnergyDrift<T> {
    fn default() -> Self {
        Self { start: None, largest: 0.0 }
    }
}

impl<T> EnergyDrift<T> {
    /// The largest deviation so far (J), of lanes that of any; NaN since an energy was no number.
    pub fn largest(&self) -> f64 {
        self.largest
    }
}

impl<T: Scalar> EnergyDrift<T> {
    /// Looks at an instant of a run: `|now| drift.observe(now)`.
    pub fn observe<S, R, C, P, L>(&mut self, now: &Now<'_, S, R, C, P, L>)
    where
        S: Space<Scalar = T>,
        R: Root<S>,
        C: Element<S>,
        P: Tip<S>,
        L: Loading<S>,
    {
        let energy = now.energy();
        let drift = (energy - *self.start.get_or_insert(energy)).real().as_f64().abs();
        if drift.is_nan() || drift > self.largest {
            self.largest = drift;
        }
    }
}

/// Writes each instant as a line of CSV: time, then position, rate and acceleration of every joint coordinate, then energy.
///
/// Columns are named after joints: by their names, by `joint_` and their numbers where they have none, and by both where several have
/// the same, no two alike. Where a joint has several coordinates, these are numbered. Numbers are written so that they read back exactly. Dual numbers
/// write their real part. Of lanes none stands for the others: they are an error.
///
/// ```
/// use catena::simulate::Trace;
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0);
/// let pendulum = System::new(Pinned::origin(), (rod, Pin.named("elbow"), rod), Free)?.with_gravity(9.81);
/// let mut trace = Trace::new(Vec::new());
/// let start = pendulum.at_rest(&[-1.0, -0.5])?;
/// pendulum.simulation(Rk4::step(1e-2)).every(0.1).run(start, 0.2, |now| trace.observe(now))?;
/// let text = String::from_utf8(trace.finish()?)?;
/// assert!(text.starts_with("time,joint_0_position,elbow_position,joint_0_rate,elbow_rate,joint_0_acceleration,"));
/// assert_eq!(text.lines().count(), 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[cfg(feature = "std")]
#[derive(Debug)]
pub struct Trace<W> {
    writer: W,
    /// The type of the scene that it is of, and how many numbers that has, once a line is written.
    of: Option<(&'static str, usize)>,
    outcome: std::io::Result<()>,
}

#[cfg(feature = "std")]
impl<W: std::io::Write> Trace<W> {
    /// A trace written to `writer`, for example a buffered file.
    pub fn new(writer: W) -> Self {
        Self { writer, of: None, outcome: Ok(()) }
    }

    /// The writer, flushed.
    ///
    /// # Errors
    /// The first error that writing met, or that a scene of another type or size was shown; nothing was written after it.
    pub fn finish(mut self) -> std::io::Result<W> {
        self.outcome?;
        self.writer.flush()?;
        Ok(self.writer)
    }
}

#[cfg(feature = "std")]
impl<W: std::io::Write> Trace<W> {
    /// Writes a line, and the names of its columns before the first.
    fn line<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>, L: Loading<S>>(
        &mut self,
        now: &Now<'_, S, R, C, P, L>,
    ) -> std::io::Result<()> {
        let Self { writer, of, .. } = self;
        if S::Scalar::LANES {
            return Err(std::io::Error::new(std::io::ErrorKind::Unsupported, "a trace of lanes"));
        }
        let (motion, mut outcome) = (now.motion(), Ok(()));
        let own = (core::any::type_name::<(S, R, C, P)>(), motion.coordinate_count() + motion.rate_count());
        match *of {
            None => writeln!(writer, "{}", columns(now.system().elements()))?,
            Some(of) if of == own => (),
            Some(_) => return Err(std::io::Error::new(std::io::ErrorKind::InvalidInput, "a trace of two scenes")),
        }
        *of = Some(own);
        write!(writer, "{}", now.time().as_f64())?;
        let mut note = |x: S::Scalar| {
            if outcome.is_ok() {
                outcome = write!(writer, ",{}", x.real().as_f64());
            }
        };
        motion.position().visit(&mut note);
        motion.rate().visit(&mut note);
        motion.acceleration().visit(&mut note);
        outcome?;
        writeln!(writer, ",{}", now.energy().real().as_f64())
    }
}

/// The names of all columns.
#[cfg(feature = "std")]
fn columns<S: Space, E: Element<S>>(elements: &E) -> String {
    let mut named = Vec::new();
    parts(elements, &mut |part| {
        if let Sort::Joint { coordinates, rates } = part.sort {
            named.push((part.name, coordinates, rates));
        }
    });
    let mut joints: Vec<(String, usize, usize)> = Vec::new();
    for (number, (name, coordinates, rates)) in named.iter().enumerate() {
        let alone = named.iter().filter(|(other, ..)| other == name).count() == 1;
        let mut label = match name {
            Some(name) if alone => String::from(*name),
            Some(name) => format!("{name}_{number}"),
            None => format!("joint_{number}"),
        };
        // A joint may have the name that another is given.
        while joints.iter().any(|(other, ..)| *other == label) {
            label = format!("{label}_{number}");
        }
        joints.push((label, *coordinates, *rates));
    }
    let mut text = String::from("time");
    for what in ["position", "rate", "acceleration"] {
        for (label, coordinates, rates) in &joints {
            let count = if what == "position" { *coordinates } else { *rates };
            for k in 0..count {
                let column = if count == 1 { format!("{label}_{what}") } else { format!("{label}_{what}_{k}") };
                text.push(',');
                text.push_str(&quoted(column));
            }
        }
    }
    text + ",energy"
}

/// A field of CSV, between quotation marks where it needs them.
#[cfg(feature = "std")]
fn quoted(field: String) -> String {
    if field.contains([',', '"', '\n', '\r']) { format!("\"{}\"", field.replace('"', "\"\"")) } else { field }
}

#[cfg(feature = "std")]
impl<W: std::io::Write> Trace<W> {
    /// Writes an instant of a run: `|now| trace.observe(now)`.
    pub fn observe<S, R, C, P, L>(&mut self, now: &Now<'_, S, R, C, P, L>)
    where
        S: Space,
        R: Root<S>,
        C: Element<S>,
        P: Tip<S>,
        L: Loading<S>,
    {
        if self.outcome.is_err() {
            return;
        }
        self.outcome = self.line(now);
    }
}
