//! One step of the printed scheme on the chain of the paper's section 5.5, by every way of solving it, against double-double arithmetic.
//!
//! Base scene: 20 rods of 0.05 m and 0.05 kg on springs of 20 N·m/rad, bent and moving, a step of 10 ms. Errors are those of the
//! increments Δθ, as shares of the largest.

use crate::remedies::{delta, modified, reordered, scaled};
use crate::table::Table;
use crate::transformed::transformed;
use crate::twice::Twice;
use catena::loading::Unloaded;
use catena::paper::*;
use catena::planar::{ElasticHinge, Free, Pinned, Rod, System};
use catena::{Real, Scalar, TransferMatrix};

/// What is varied.
#[derive(Clone, Copy)]
struct Chain {
    bodies: usize,
    dt: f64,
    stiffness: f64,
    /// Mass of every other rod, as a multiple of that of its neighbours.
    ratio: f64,
    /// Length of the chain (m).
    length: f64,
}

const BASE: Chain = Chain { bodies: 20, dt: 1e-2, stiffness: 20.0, ratio: 1.0, length: 1.0 };
/// Beyond, matrices of all elements are not kept, and ways that need them are left out: they have failed long before.
const MATRICES: usize = 100_000;

/// Increments of all angles by the crate's solver, and the matrices that the product multiplies.
type Solved<T> = Result<(Vec<f64>, Vec<TransferMatrix<T, 7>>, Vec<T>), String>;

/// A number with the digits of `f32`, so that all scalars solve the same scene.
fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

fn step<T: Scalar>(chain: Chain, solver: Solver) -> Solved<T>
where
    T::Real: Real,
{
    let n = chain.bodies;
    let number = |x: f64| T::literal(single(x));
    let real = |x: f64| T::Real::of(single(x));
    let rod = |k: usize| {
        let mass = if k % 2 == 1 { chain.ratio } else { 1.0 };
        Rod::uniform(number(chain.length / n as f64), number(mass / n as f64))
    };
    let spring = ElasticHinge::rotary(number(chain.stiffness));
    let links: Vec<_> = (1..n).map(|k| (spring, rod(k))).collect();
    let say = |error: catena::Error| error.to_string();
    let scene = System::new(Pinned::origin(), (rod(0), links), Free).map_err(say)?.with_gravity(number(9.81));
    let angles: Vec<T> = (0..n).map(|k| number(-1.0 + 0.3 * k as f64 / n as f64)).collect();
    let mut rates = vec![number(1.0)];
    rates.extend((1..n).map(|k| number(0.5 / n as f64 * (k as f64).cos())));
    let start = scene.with_rates(scene.at_rest(&angles).map_err(say)?, &rates).map_err(say)?;
    let rule = Newmark::new(0.25, 0.5);
    let mut run = Scheme::new(rule).solved_by(solver).start(&scene, &start, &Unloaded, real(chain.dt)).map_err(say)?;
    let before: Vec<[T; 3]> = run.turns().collect();
    let outcome = run.step();
    let matrices = if n <= MATRICES { run.matrices().to_vec() } else { vec![] };
    // (2) the other way round: differences of angles near 1 rad round to 1e-16 by themselves.
    let increment = |([value, rate, acceleration], [_, now, _]): ([T; 3], [T; 3])| {
        let linear =
            Rule::<T>::linearize(&rule, &rule.start(value, rate, acceleration, real(chain.dt)), real(chain.dt));
        ((now - linear.rate) / number(2.0) * number(chain.dt)).real().as_f64()
    };
    let found = match outcome {
        Ok(()) => before.into_iter().zip(run.turns()).map(increment).collect(),
        Err(_) => vec![f64::NAN; n],
    };
    Ok((found, matrices, angles))
}

/// Largest error as a share of the largest increment.
fn error(found: &[f64], exact: &[f64]) -> Result<f64, String> {
    let size = exact.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    if !size.is_finite() || found.len() != exact.len() {
        return Err("no reference".to_owned());
    }
    if found.iter().any(|x| !x.is_finite()) {
        return Err("not finite".to_owned());
    }
    Ok(found.iter().zip(exact).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs())) / size)
}

/// All ways in one precision.
fn ways<T: Scalar>(
    table: &mut Table,
    axis: &'static str,
    value: f64,
    chain: Chain,
    scalar: &'static str,
    exact: &[f64],
) {
    let mut add = |way: &str, outcome: Result<f64, String>| {
        table.add("step", "paper's chain", axis, value, way, scalar, outcome);
    };
    let increments = step::<T>(chain, Solver::Riccati).and_then(|(found, ..)| error(&found, exact));
    if chain.bodies > MATRICES {
        return add("Riccati, increments", increments);
    }
    match step::<T>(chain, Solver::Product) {
        Err(text) => add("product", Err(text)),
        Ok((found, matrices, angles)) => {
            add("product", error(&found, exact));
            // The first one is that of the root's joint, and not used.
            let matrices = matrices.get(1..).unwrap_or(&[]);
            type Way<T> = fn(&[TransferMatrix<T, 7>]) -> Vec<T>;
            let absolute: [(&str, Way<T>); 5] = [
                ("scaled product", scaled::<T>),
                ("reordered product", reordered::<T>),
                ("modified matrices", modified::<T>),
                ("Delta matrix", delta::<T>),
                ("Riccati, absolute", transformed::<T>),
            ];
            for (way, solve) in absolute {
                let after = solve(matrices);
                let differences = after.iter().step_by(2).zip(&angles).map(|(a, b)| (*a - *b).real().as_f64());
                add(way, error(&differences.collect::<Vec<f64>>(), exact));
            }
        }
    }
    add("Riccati, increments", increments);
}

fn case(table: &mut Table, axis: &'static str, value: f64, chain: Chain) {
    crate::progress(&format!("step, {axis} {value:.0e}"));
    let exact = step::<Twice>(chain, Solver::Riccati).map_or(vec![], |(found, ..)| found);
    ways::<f64>(table, axis, value, chain, "f64", &exact);
    ways::<f32>(table, axis, value, chain, "f32", &exact);
}

pub fn run(table: &mut Table, quick: bool) {
    let most = if quick { 1000.0 } else { 1e6 };
    for bodies in [2.0, 5.0, 20.0, 100.0, 1e3, 1e4, 1e5, 1e6].into_iter().filter(|n| *n <= most) {
        case(table, "bodies", bodies, Chain { bodies: bodies as usize, ..BASE });
    }
    for dt in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5] {
        case(table, "step (s)", dt, Chain { dt, ..BASE });
    }
    for ratio in [1e-12, 1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9, 1e12] {
        case(table, "mass of every other rod", ratio, Chain { ratio, ..BASE });
    }
    for stiffness in [1.0, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14] {
        case(table, "stiffness (N·m/rad)", stiffness, Chain { stiffness, ..BASE });
    }
    for length in [1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6] {
        case(table, "length (m)", length, Chain { length, ..BASE });
    }
}
