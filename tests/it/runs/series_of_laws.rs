//! Taylor series of scenes whose laws are not linear: coefficients beside recursions of their own, runs beside order eight.

use super::by_series::{Drive, apart, beside_dop853, errors_within_steps, expansion};
use catena::scalar::{Jet, Scalar};
use catena::{Error, Fault, planar, spatial};
use catena_oracle::{has_order, near};

/// −k (u + u³) − c u̇.
#[derive(Clone, Copy, Debug)]
struct Stiffening<T> {
    stiffness: T,
    damping: T,
}

catena::lift!(Stiffening<T> { stiffness, damping });

impl<T: Scalar> planar::SpringLaw<T> for Stiffening<T> {
    const ANALYTIC: bool = true;

    fn force(&self, position: T, rate: T) -> T {
        -self.stiffness * (position + position * position * position) - self.damping * rate
    }
    fn energy(&self, position: T) -> T {
        let square = position * position;
        self.stiffness * square * (T::literal(0.5) + T::literal(0.25) * square)
    }
    fn pivot(&self, position: T, _: T, springs: impl planar::Springs<T>) -> T {
        springs.pivot(self.stiffness * (T::one() + T::literal(3.0) * position * position), self.damping)
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

/// Σ a_j b_{k−j}.
fn product(a: &[f64], b: &[f64], k: usize) -> f64 {
    (0..=k).map(|j| a[j] * b[k - j]).sum()
}

/// Coefficients of the rate from 1 on, of a coordinate of this inertia under such a law and under friction −F tanh(u̇ / v).
fn coefficients(inertia: f64, law: Stiffening<f64>, [sliding, speed]: [f64; 2], [place, rate]: [f64; 2]) -> Vec<f64> {
    let (mut u, mut w, mut tanh) = (vec![place], vec![rate], vec![(rate / speed).tanh()]);
    let mut square = vec![];
    for k in 0..16 {
        if k > 0 {
            // y′ = (1 − y²) x′ of x = u̇ / v.
            let mut rest: Vec<f64> = (0..k).map(|j| -product(&tanh, &tanh, j)).collect();
            rest[0] += 1.0;
            let sum: f64 = (1..=k).map(|j| j as f64 * w[j] / speed * rest[k - j]).sum();
            tanh.push(sum / k as f64);
        }
        square.push(product(&u, &u, k));
        let cube = product(&square, &u, k);
        let force = -law.stiffness * (u[k] + cube) - law.damping * w[k] - sliding * tanh[k];
        w.push(force / inertia / (k + 1) as f64);
        u.push(w[k] / (k + 1) as f64);
    }
    w.split_off(1)
}

const LAW: Stiffening<f64> = Stiffening { stiffness: 3.0, damping: 0.2 };
const FRICTION: [f64; 2] = [0.4, 0.8];

/// Whether coefficients of the rates of one coordinate are these, to a share of their size.
fn are_these(name: &str, found: &[Vec<f64>], expected: &[f64]) {
    assert_eq!((found.len(), expected.len()), (16, 16));
    for (k, (found, expected)) in found.iter().zip(expected).enumerate() {
        let miss = (found[0] - expected).abs() / expected.abs();
        println!("{name}, order {}: {expected:.3e}, miss {miss:.1e}", k + 1);
        assert!(miss < 1e-12, "{name}, order {}: {} for {expected}", k + 1, found[0]);
    }
}

#[test]
fn coefficients_follow_from_the_law_alone() -> Result<(), Error> {
    let state = [0.7, -0.9];
    {
        use planar::*;
        let laws = (LAW, DryFriction::new(FRICTION[0], FRICTION[1]));
        let turning = System::new(Clamped::origin(), (ElasticHinge::with(laws), Rod::uniform(0.8, 1.5)), Free)?;
        let start = turning.with_rates(turning.at_rest(&[state[0]])?, &[state[1]])?;
        let (found, stepped) = expansion!(16, turning, start, Unloaded, 0.01);
        stepped?;
        are_these("hinge", &found, &coefficients(1.5 * 0.64 / 3.0, LAW, FRICTION, state));
        let sliding = System::new(Clamped::origin(), (Slider::along(0.3).with(laws), Rod::uniform(0.8, 1.5)), Free)?;
        let mut start = sliding.motion();
        start.set_coordinates(&[state[0]])?;
        let start = sliding.with_rates(start, &[state[1]])?;
        let (found, stepped) = expansion!(16, sliding, start, Unloaded, 0.01);
        stepped?;
        are_these("slider", &found, &coefficients(1.5, LAW, FRICTION, state));
    }
    use spatial::*;
    let (laws, rod) = ((LAW, DryFriction::new(FRICTION[0], FRICTION[1])), Rod::uniform(0.8, 0.05, 1.5));
    let turning = System::new(Clamped::origin(), (Revolute::about([0.0, 0.0, 1.0]).with(laws), rod), Free)?;
    let start = turning.with_rates(turning.at_rest(&[state[0]])?, &[state[1]])?;
    let (found, stepped) = expansion!(16, turning, start, Unloaded, 0.01);
    stepped?;
    let inertia = turning.budget(&turning.with_rates(turning.motion(), &[1.0])?)?.kinetic * 2.0;
    are_these("revolute", &found, &coefficients(inertia, LAW, FRICTION, state));
    let sliding = System::new(Clamped::origin(), (Prismatic::along([0.6, 0.0, 0.8]).with(laws), rod), Free)?;
    let mut start = sliding.motion();
    start.set_coordinates(&[state[0]])?;
    let start = sliding.with_rates(start, &[state[1]])?;
    let (found, stepped) = expansion!(16, sliding, start, Unloaded, 0.01);
    stepped?;
    are_these("prismatic", &found, &coefficients(1.5, LAW, FRICTION, state));
    Ok(())
}

/// A tree of the plane with such laws in hinges and on a track.
macro_rules! tree {
    ($law:expr) => {{
        use planar::*;
        let (rod, law) = (Rod::uniform(0.5, 0.5), $law);
        let knee = ElasticHinge::with((law, DryFriction::new(0.1, 0.5).breaking_away(0.15)));
        let arm = Branch((ElasticHinge::with(law), rod));
        let chain = (rod, knee, rod, arm, Slider::along(0.4).with(law), rod);
        System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81)
    }};
}

/// An arm in space with such laws in joints that turn and slide.
macro_rules! arm {
    ($law:expr) => {{
        use spatial::*;
        let (rod, law) = (Rod::uniform(0.5, 0.05, 0.5), $law);
        let chain = (
            Revolute::about([0.0, 0.0, 1.0]).with((law, DryFriction::new(0.1, 0.5))),
            rod,
            Revolute::about([0.0, 1.0, 0.0]).with(law),
            rod,
            Prismatic::along([0.0, 0.6, 0.8]).with(law),
            rod,
        );
        System::new(Clamped::origin(), chain, Free)?.with_gravity([0.0, -9.81, 0.0])
    }};
}

#[test]
fn runs_are_those_of_dop853() -> Result<(), Error> {
    use catena::time::{Dop853, Taylor};
    macro_rules! compare {
        ($name:literal, $scene:expr, $loads:expr, $count:literal) => {{
            let scene = $scene;
            let mut start = scene.motion();
            start.set_coordinates(&[0.3; $count])?;
            let start = scene.with_rates(start, &[0.8, -0.5, 0.4, 0.2][..$count])?;
            let (series, other) = beside_dop853!(24, scene, $loads, start, 1.0);
            let (a, b) = (&series.motion, &other.motion);
            let miss = [apart(&a.coordinates(), &b.coordinates()), apart(&a.accelerations(), &b.accelerations())];
            println!(
                "{}: {} steps for {}, apart by {:.1e}, {:.1e}",
                $name, series.steps, other.steps, miss[0], miss[1]
            );
            assert!(miss[0] < 1e-11 && miss[1] < 1e-9 && series.rejected == 0);
        }};
    }
    compare!("tree", tree!(LAW), planar::Unloaded, 4);
    compare!("driven tree", tree!(LAW), planar::Loads::none().in_joints_over_time(Drive), 4);
    compare!("arm", arm!(LAW), spatial::Unloaded, 3);
    compare!("driven arm", arm!(LAW), spatial::Loads::none().in_joints_over_time(Drive), 3);
    Ok(())
}

#[test]
fn orders_are_those_of_the_series() -> Result<(), Error> {
    use planar::*;
    let scene = tree!(LAW);
    let mut start = scene.motion();
    start.set_coordinates(&[0.3; 4])?;
    let start = scene.with_rates(start, &[0.8, -0.5, 0.4, 0.2])?;
    let [positions, rates] = errors_within_steps!(scene, start, [0.022, 0.018, 0.015, 0.012]);
    has_order("position within a step", 10.0, 1e-15, &positions);
    has_order("rate within a step", 9.0, 1e-15, &rates);
    Ok(())
}

/// Where two rods on a hinge end by a law of this stiffness, over numbers that `$of` makes.
macro_rules! ends {
    ($stiffness:expr, $of:expr) => {{
        use planar::*;
        let (rod, damping) = (Rod::uniform($of(0.5), $of(0.5)), $of(0.2));
        let hinge = ElasticHinge::with(Stiffening { stiffness: $stiffness, damping });
        let scene = System::new(Pinned::at($of(0.0), $of(0.0)), (rod, hinge, rod), Free)?.with_gravity($of(9.81));
        let start = scene.at_rest(&[$of(0.3), $of(0.6)])?;
        scene.simulation(Taylor::<16>::tolerance(1e-11)).run(start, 0.5, |_| ())?.motion.coordinates()
    }};
}

#[test]
fn derivatives_by_a_law_are_slopes_of_runs() -> Result<(), Error> {
    let of = |stiffness: f64| -> Result<Vec<f64>, Error> { Ok(ends!(stiffness, |x: f64| x)) };
    let jets: Vec<Jet<f64, 1>> = ends!(Jet::seed(3.0, 0), Jet::<f64, 1>::of);
    let h = 1e-3;
    let [back, ahead, far_back, far_ahead] = [of(3.0 - h)?, of(3.0 + h)?, of(3.0 - 2.0 * h)?, of(3.0 + 2.0 * h)?];
    for (k, jet) in jets.iter().enumerate() {
        let slope = (8.0 * (ahead[k] - back[k]) - (far_ahead[k] - far_back[k])) / (12.0 * h);
        println!("coordinate {k}: {} by {slope}", jet.eps[0]);
        assert!(slope.abs() > 1e-3);
        near(jet.eps[0], slope, 1e-8);
    }
    Ok(())
}
