//! Numbers of a run that would be no run, or none that ends.

use crate::error::{Error, Fault};
use crate::scalar::Real;
use crate::time::Control;

/// So many steps of a given size, or samples, a run may have at most: at a tenth of a microsecond each they take hours.
pub(super) const MOST: f64 = 1e11;

/// Refuses times, steps, tolerances and intervals that make no run from `start` to `end` (s).
pub(crate) fn check<R: Real>(
    [start, end]: [R; 2],
    control: Control<R>,
    every: Option<R>,
    longest: Option<R>,
) -> Result<(), Error> {
    if !start.is_finite() {
        return Err(Error::new(Fault::NotFinite { parameter: "start of the run" }));
    }
    if !end.is_finite() {
        return Err(Error::new(Fault::NotFinite { parameter: "end of the run" }));
    }
    at_least("end of the run", end.as_f64(), start.as_f64(), "it lies before where the run begins, or goes on")?;
    let (Control::Fixed(chosen) | Control::Tolerance(chosen)) = control;
    let chosen_as = if let Control::Fixed(_) = control { "step size" } else { "tolerance" };
    let numbers = [(chosen_as, Some(chosen)), ("interval between samples", every), ("longest step", longest)];
    for (parameter, number) in numbers {
        if let Some(number) = number
            && !(number.is_finite() && number > R::zero())
        {
            return Err(Error::new(Fault::NotPositive { parameter, value: number.as_f64() }));
        }
    }
    if let (Control::Fixed(step), Some(longest)) = (control, longest)
        && step > longest
    {
        let outside = "it is longer than the longest step";
        let (value, most) = (step.as_f64(), longest.as_f64());
        return Err(Error::new(Fault::OutOfRange { parameter: "step size", value, least: 0.0, most, outside }));
    }
    if let Control::Tolerance(tolerance) = control {
        let outside = "numbers are rounded by more";
        at_least("tolerance", tolerance.as_f64(), R::EPSILON.as_f64(), outside)?;
    }
    // A duration of the scalar may be rounded to nothing; that of its times as f64 is exact enough.
    let endless = ((end.as_f64() - start.as_f64()) / MOST, "a run of more than 1e11 instants does not end");
    // Times would round to each other.
    let late = start.abs().max(end.abs()).as_f64();
    let still = (2.0 * R::EPSILON.as_f64() * late, "times are rounded by about as much");
    let fixed = match control {
        Control::Fixed(step) => Some(step),
        Control::Tolerance(_) => None,
    };
    for (parameter, number) in [("step size", fixed), ("interval between samples", every), ("longest step", longest)] {
        for (least, outside) in [still, endless] {
            number.map_or(Ok(()), |number| at_least(parameter, number.as_f64(), least, outside))?;
        }
    }
    Ok(())
}

/// Refuses a number below a least one.
pub(super) fn at_least(parameter: &'static str, value: f64, least: f64, outside: &'static str) -> Result<(), Error> {
    if value >= least {
        return Ok(());
    }
    Err(Error::new(Fault::OutOfRange { parameter, value, least, most: f64::INFINITY, outside }))
}
