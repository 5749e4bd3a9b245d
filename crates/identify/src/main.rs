//! Six parameters of a chain from noisy angles: stiffnesses and dampings of two hinges, and two masses.
//!
//! Three links swing from a pin and hinges between them; encoders read all angles every 20 ms, to a few milliradians. The Levenberg-Marquardt
//! method fits a model, whose residuals come with all their derivatives from one run over jets: forward, for there are hundreds of
//! residuals and six parameters. How far estimates may be off follows from the Jacobian; the truth, which the fit does not know, is within.
//!
//! ```text
//! cargo run --release -p catena-identify
//! ```

#[path = "../../../examples/common/mod.rs"]
mod common;

use catena::planar::*;
use catena::scalar::{Elementary, Jet};
use catena_oracle::Noise;
use common::{BLUE, Drawn, GREY, ORANGE, line};
use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra::{Dyn, OMatrix, OVector, U6, VecStorage, Vector6};
use std::path::PathBuf;

/// A number with its derivatives by all parameters.
type Number = Jet<f64, 6>;

const NAMES: [&str; 6] =
    ["stiffness, first hinge", "damping", "stiffness, second hinge", "damping", "second mass", "third mass"];
const UNITS: [&str; 6] = ["N·m/rad", "N·m·s/rad", "N·m/rad", "N·m·s/rad", "kg", "kg"];
const TRUTH: [f64; 6] = [6.0, 0.08, 2.5, 0.03, 0.8, 0.5];
const GUESS: [f64; 6] = [3.0, 0.2, 5.0, 0.1, 1.2, 0.3];
const STEP: f64 = 5e-3; // (s)
const EVERY: usize = 4; // steps from sample to sample
const SAMPLES: usize = 100;
const NOISE: f64 = 5e-3; // (rad)

/// Angle of the first link and those of the hinges (rad) at all samples, for logarithms of parameters, which are the seeds: so no mass that
/// is tried is negative.
fn angles(logarithms: &[f64]) -> Result<Vec<Number>, catena::Error> {
    let p = |k: usize| Number::seed(logarithms[k], k).exp();
    let [one, length] = [1.0, 0.4].map(Number::of);
    let hinge = |k: usize| ElasticHinge::rotary(p(k)).damped(p(k + 1));
    let link = |mass: Number| Rod::uniform(length, mass);
    let chain = (link(one), hinge(0), link(p(4)), hinge(2), link(p(5)));
    let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(Number::of(9.81));
    let mut start = scene.motion();
    start.set_coordinates(&[-0.4, 0.9, -1.1].map(Number::of))?;
    let (mut list, mut steps) = (vec![], 0);
    scene.simulate(start, Rk4::step(STEP).through_gains(), STEP * (EVERY * SAMPLES) as f64, |now| {
        if steps % EVERY == 0 {
            list.extend(now.stepped().coordinates());
        }
        steps += 1;
    })?;
    Ok(list)
}

/// Measured angles, logarithms of parameters that are tried, and the model's angles for them.
struct Fit {
    measured: Vec<f64>,
    logarithms: Vector6<f64>,
    model: Option<Vec<Number>>,
}

impl LeastSquaresProblem<f64, Dyn, U6> for Fit {
    type ResidualStorage = VecStorage<f64, Dyn, nalgebra::U1>;
    type JacobianStorage = VecStorage<f64, Dyn, U6>;
    type ParameterStorage = nalgebra::Owned<f64, U6>;

    fn set_params(&mut self, logarithms: &Vector6<f64>) {
        self.logarithms = *logarithms;
        self.model = angles(logarithms.as_slice()).ok();
    }
    fn params(&self) -> Vector6<f64> {
        self.logarithms
    }
    fn residuals(&self) -> Option<OVector<f64, Dyn>> {
        let model = self.model.as_ref()?;
        Some(OVector::<f64, Dyn>::from_iterator(model.len(), model.iter().zip(&self.measured).map(|(x, y)| x.re - y)))
    }
    fn jacobian(&self) -> Option<OMatrix<f64, Dyn, U6>> {
        let model = self.model.as_ref()?;
        Some(OMatrix::<f64, Dyn, U6>::from_row_iterator(model.len(), model.iter().flat_map(|x| x.eps)))
    }
}

fn main() -> Drawn {
    let mut noise = Noise::new(14);
    // Twelve numbers that are evenly distributed, added up: all but a normal distribution.
    let mut error = || NOISE * (0..12).map(|_| 0.5 * noise.next()).sum::<f64>();
    let measured: Vec<f64> = angles(&TRUTH.map(f64::ln))?.iter().map(|angle| angle.re + error()).collect();
    let mut fit = Fit { measured, logarithms: Vector6::zeros(), model: None };
    fit.set_params(&Vector6::from(GUESS.map(f64::ln)));
    let at_first: Vec<f64> = fit.model.iter().flatten().map(|x| x.re).collect();
    let (fit, report) = LevenbergMarquardt::new().minimize(fit);
    let (Some(residuals), Some(jacobian)) = (fit.residuals(), fit.jacobian()) else {
        return Err("the model cannot be run".into());
    };
    let variance = residuals.norm_squared() / (residuals.len() - 6) as f64;
    let Some(covariance) = (jacobian.transpose() * jacobian).try_inverse() else {
        return Err("these angles do not tell the parameters".into());
    };
    println!(
        "{} residuals, {} runs over jets; {:?}",
        residuals.len(),
        report.number_of_evaluations,
        report.termination
    );
    println!("root mean square of what is left: {:.2} mrad of {:.2}\n", 1e3 * variance.sqrt(), 1e3 * NOISE);
    println!("{:<24} {:>9} {:>9} {:>18}", "", "guess", "truth", "found");
    for k in 0..6 {
        let found = fit.logarithms[k].exp();
        let off = found * (variance * covariance[(k, k)]).sqrt();
        println!("{:<24} {:>9.3} {:>9.3} {found:>9.4} ± {off:.4} {}", NAMES[k], GUESS[k], TRUTH[k], UNITS[k]);
        if (found - TRUTH[k]).abs() > 4.0 * off {
            return Err(format!("{}: {found}, which is not {} within four deviations", NAMES[k], TRUTH[k]).into());
        }
    }
    println!("\n{}", draw(&fit, &at_first)?.display());
    Ok(())
}

/// Measured angles and those of the model, at first and fitted.
fn draw(fit: &Fit, at_first: &[f64]) -> Drawn<PathBuf> {
    common::picture("identify", (760, 620), |area| {
        let subtitle = "Angles measured, of the model as it was guessed, and of the model that fits them best.";
        let mut rest = common::heading(area, "Six parameters from noisy angles", subtitle)?;
        for (joint, title) in ["First link (rad)", "First hinge (rad)", "Second hinge (rad)"].into_iter().enumerate() {
            let (panel, below) = rest.split_vertically(common::pixels(180.0));
            let time = |k: usize| STEP * (EVERY * k) as f64;
            let part = |list: &[f64]| -> Vec<(f64, f64)> {
                list.chunks_exact(3).enumerate().map(|(k, angles)| (time(k), angles[joint])).collect()
            };
            let fitted: Vec<f64> = fit.model.iter().flatten().map(|x| x.re).collect();
            let (dots, guess, model) = (part(&fit.measured), part(at_first), part(&fitted));
            let all = dots.iter().chain(&guess).map(|point| point.1);
            let mut chart = common::chart(&panel, title, "time (s)", 0.0..time(SAMPLES), common::range(all, 0.08))?;
            if joint == 0 {
                common::legend(&panel, &[("measured", GREY), ("guessed", BLUE), ("fitted", ORANGE)])?;
            }
            common::curve(&mut chart, guess, line(BLUE, 1.4))?;
            common::curve(&mut chart, model, line(ORANGE, 2.2))?;
            common::dots(&mut chart, dots, 1.8, GREY)?;
            rest = below;
        }
        Ok(())
    })
}
