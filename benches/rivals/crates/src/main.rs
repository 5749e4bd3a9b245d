//! Run time against error of phyz and ode_solvers on pins, a line a run: library, rule, step or tolerance, error (rad), seconds.
//!
//! `cargo run --release -- BODIES END REFERENCE`

use catena_rivals::{ByHand, last_angle, phyz_chain, timed};
use nalgebra::DVector;
use ode_solvers::{Dop853, Dopri5, OutputType, Rk4};
use phyz::Simulator;

fn main() {
    let given: Vec<f64> = std::env::args().skip(1).map(|x| x.parse().expect("numbers")).collect();
    let [bodies, end, reference] = given[..] else { panic!("BODIES END REFERENCE") };
    let bodies = bodies as usize;
    let tell = |library: &str, rule: &str, setting: f64, (angle, seconds): (f64, f64)| {
        let error = (angle - reference).abs();
        if error < 1.0 {
            println!("{library},{rule},{setting:e},{error:e},{seconds:e}");
        } else {
            eprintln!("{library} with {rule} at {setting:e}: diverged (error {error:.1e})");
        }
    };
    let simulator = Simulator::rk4();
    for step in [5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5] {
        let model = phyz_chain(bodies, step);
        let steps = (end / step).round() as usize;
        let run = || {
            let mut state = model.default_state();
            simulator.simulate(&model, &mut state, steps);
            last_angle(&state)
        };
        tell("phyz", "RK4", step, timed(run));
    }
    let (start, scene) = (DVector::zeros(2 * bodies), ByHand { bodies });
    for k in 2..=14 {
        let tolerance = 10f64.powi(-k);
        // No more output than the last state.
        macro_rules! run {
            ($rule:ident) => {
                timed(|| {
                    let mut run = $rule::new(scene, 0.0, end, end, start.clone(), tolerance, tolerance);
                    run.set_output(OutputType::Sparse);
                    run.integrate().ok().and_then(|_| Some(run.y_out().last()?[bodies - 1])).unwrap_or(f64::NAN)
                })
            };
        }
        tell("ode_solvers by hand", "DOP853", tolerance, run!(Dop853));
        tell("ode_solvers by hand", "DOPRI5", tolerance, run!(Dopri5));
    }
    for step in [1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4] {
        let run = || {
            let mut run = Rk4::new(scene, 0.0, start.clone(), end, step);
            run.integrate().ok().and_then(|_| Some(run.y_out().last()?[bodies - 1])).unwrap_or(f64::NAN)
        };
        tell("ode_solvers by hand", "RK4", step, timed(run));
    }
}
