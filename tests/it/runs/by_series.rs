//! What tests of Taylor series share: coefficients beside files, runs beside order eight, steps beside steps that begin anew.

use catena::loading::TimeLaw;
use catena::{Error, Scalar};
use catena_oracle::near;

/// Drives all joints.
pub struct Drive;

impl TimeLaw<f64> for Drive {
    fn at<X: Scalar<Real = f64>>(&self, time: X, joint: usize) -> X {
        let (sine, _) = (X::literal(3.0) * time + X::literal(joint as f64)).sin_cos();
        X::literal(2.0) * sine / (X::one() + time * time) * (X::literal(-0.5) * time).exp()
    }
}

/// By how much two lists are apart.
pub fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
}

/// Whether coefficients of rates, one list for each order from 1 on, are those of a scene in a file such as `series.csv`, but for a share
/// of the largest of that order.
pub fn are_coefficients_of(file: &str, scene: &str, found: &[Vec<f64>], share: f64) {
    let lines = file.lines().skip_while(|line| *line != scene).skip(1);
    let expected: Vec<Vec<f64>> = lines.map_while(|line| line.split(',').map(|x| x.parse().ok()).collect()).collect();
    assert_eq!(expected.len(), found.len());
    for (k, (found, expected)) in found.iter().zip(&expected).enumerate() {
        let largest = expected.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let miss = apart(found, expected);
        println!("{scene}, order {}: {largest:.3e}, miss {:.1e}", k + 1, miss / largest);
        assert!(miss <= share * largest, "{scene}, order {}: {found:?}, {expected:?}", k + 1);
    }
}

/// What a step by so many orders expands, as [`are_coefficients_of`] takes it, and how the step went. It may miss where ends are not where
/// they are held: coefficients are those of what closures demand of accelerations.
macro_rules! expansion {
    ($order:literal, $scene:expr, $start:expr, $loads:expr, $dt:expr) => {{
        let (scene, start) = (&$scene, &$start);
        let mut stepper = scene.stepper(Taylor::<$order>);
        let mut next = start.clone();
        let stepped = stepper.step(start, &$loads, $dt, &mut next);
        let mut found = vec![vec![]; $order];
        for (k, row) in found.iter_mut().enumerate() {
            stepper.coefficients(k, |x| row.push(x / (k + 1) as f64)); // those of rates
        }
        (found, stepped)
    }};
}
pub(super) use expansion;

/// How a run by so many orders ends, and how one by order eight does.
macro_rules! beside_dop853 {
    ($order:literal, $scene:expr, $loads:expr, $start:expr, $end:expr) => {{
        let (scene, loads, start) = (&$scene, &$loads, $start);
        let by_series = Taylor::<$order>::tolerance(1e-13);
        let series = scene.simulation(by_series).loads(loads).run(start.clone(), $end, |_| ())?;
        let other = scene.simulation(Dop853::tolerance(1e-13)).loads(loads).run(start, $end, |_| ())?;
        (series, other)
    }};
}
pub(super) use beside_dop853;

/// Whether a scene moves so, with the same forces at all stations. A torque has a size by `$size`.
macro_rules! beside_dop853_with_forces {
    ($name:expr, $scene:expr, $loads:expr, $start:expr, $end:expr, $size:ident) => {{
        let (scene, loads) = (&$scene, &$loads);
        let (series, other) = beside_dop853!(24, *scene, *loads, $start, $end);
        let (a, b) = (&series.motion, &other.motion);
        let mut of_force = 0.0_f64;
        for (a, b) in scene.stations(a, loads)?.iter().zip(scene.stations(b, loads)?.iter()) {
            let d = a.internal - b.internal;
            of_force = of_force.max(d.force.norm()).max(d.torque.$size());
        }
        let of_acceleration = apart(&a.accelerations(), &b.accelerations());
        let off = [apart(&a.coordinates(), &b.coordinates()), of_acceleration, of_force];
        move_alike($name, [series.steps, other.steps], off);
        assert!(series.rejected == 0);
    }};
}
pub(super) use beside_dop853_with_forces;

/// Whether a scene that is closed moves so, and is held by the same forces at all stations, those through the joints that close loops among
/// them.
macro_rules! closed_beside_dop853 {
    ($name:expr, $scene:expr, $loads:expr, $start:expr, $end:expr, $size:ident) => {{
        let start = $scene.assembled($start, &Unloaded)?;
        beside_dop853_with_forces!($name, $scene, $loads, start, $end, $size);
    }};
}
pub(super) use closed_beside_dop853;

/// Whether runs of so many steps are near each other in places, accelerations and forces.
pub fn move_alike(name: &str, [steps, others]: [usize; 2], off: [f64; 3]) {
    let [of_place, of_acceleration, of_force] = off;
    println!("{name}: {steps} steps for {others}, apart by {of_place:.1e}, {of_acceleration:.1e}, {of_force:.1e}");
    assert!(of_place < 1e-11 && of_acceleration < 1e-9 && of_force < 1e-9);
}

/// Whether steps by so many orders that go on are those that begin anew, in what is named of motions.
macro_rules! goes_on {
    ($order:literal, $scene:expr, $start:expr, $($of:ident),*) => {{
        let (scene, start) = (&$scene, $start);
        let (mut whole, mut now, mut next) = (scene.stepper(Taylor::<$order>), start, start);
        for _ in 0..5 {
            whole.step(&now, &Unloaded, 0.02, &mut next)?;
            let mut fresh = now;
            scene.stepper(Taylor::<$order>).step(&now, &Unloaded, 0.02, &mut fresh)?;
            $(assert!(fresh.$of() == next.$of());)*
            core::mem::swap(&mut now, &mut next);
        }
    }};
}
pub(super) use goes_on;

/// Errors of positions and of rates within steps of some sizes (s), by eight orders beside thirty. What is left out begins with the power
/// P + 2 of positions, P + 1 of rates.
macro_rules! errors_within_steps {
    ($scene:expr, $start:expr, $sizes:expr) => {{
        let (scene, start) = (&$scene, $start);
        let (mut few, mut many) = (scene.stepper(Taylor::<8>), scene.stepper(Taylor::<30>));
        let (mut next, mut exact, mut end) = (start, start, start);
        let mut errors = [vec![], vec![]];
        for dt in $sizes {
            few.step(&start, &Unloaded, dt, &mut next)?;
            many.step(&start, &Unloaded, dt, &mut end)?;
            few.interpolate(&start, &Unloaded, dt, &next.clone(), 0.7, &mut next);
            many.interpolate(&start, &Unloaded, dt, &end, 0.7, &mut exact);
            errors[0].push((dt, apart(&next.coordinates(), &exact.coordinates())));
            errors[1].push((dt, apart(&next.rates(), &exact.rates())));
        }
        errors
    }};
}
pub(super) use errors_within_steps;

/// Whether a pendulum that is released from the horizontal, of whose swing this is a quarter (s), hangs at these times.
pub fn hangs_at_odd_quarters(found: &[f64], quarter: f64) {
    assert_eq!(found.len(), 4);
    for (i, time) in found.iter().enumerate() {
        near(*time, (2 * i + 1) as f64 * quarter, 2e-12);
    }
}

/// The slope of a function at zero, by central differences of order four.
pub fn slope(h: f64, at: impl Fn(f64) -> Result<f64, Error>) -> Result<f64, Error> {
    Ok((8.0 * (at(h)? - at(-h)?) - (at(2.0 * h)? - at(-2.0 * h)?)) / (12.0 * h))
}

/// Whether a run in single precision, of so many steps, ends where it does in double.
pub fn ends_in_single_precision(steps: usize, found: Vec<f32>, exact: &[f64]) {
    let found: Vec<f64> = found.into_iter().map(f64::from).collect();
    println!("{steps} steps, {:.1e}", apart(&found, exact));
    assert!(apart(&found, exact) < 2e-5);
}
