//! Taylor series of scenes whose laws are not linear: coefficients beside recursions of their own, runs beside order eight.
//!
//! Bounds: coefficients pass through some hundred sums of terms of either sign, 1e-12; slopes of runs to 1e-11 by a thousandth, 1e-8.

use super::by_series::{
    Drive, apart, beside_dop853, beside_dop853_with_forces, errors_within_steps, expansion, move_alike, slope,
};
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

/// Whether a scene of one coordinate, of this inertia, has the coefficients of the law and of friction.
macro_rules! follows {
    ($name:literal, $inertia:expr, $scene:expr) => {{
        let (scene, state) = ($scene?, [0.7, -0.9]);
        let mut start = scene.motion();
        start.set_coordinates(&[state[0]])?;
        let start = scene.with_rates(start, &[state[1]])?;
        let (found, stepped) = expansion!(16, scene, start, Unloaded, 0.01);
        stepped?;
        are_these($name, &found, &coefficients($inertia, LAW, FRICTION, state));
    }};
}

#[test]
fn coefficients_follow_from_the_law_alone() -> Result<(), Error> {
    let (mass, length, radius) = (1.5, 0.8, 0.05);
    {
        use planar::*;
        let (laws, rod) = ((LAW, DryFriction::new(FRICTION[0], FRICTION[1])), Rod::uniform(length, mass));
        let across = mass * length * length / 3.0;
        follows!("hinge", across, System::new(Clamped::origin(), (ElasticHinge::with(laws), rod), Free));
        follows!("slider", mass, System::new(Clamped::origin(), (Slider::along(0.3).with(laws), rod), Free));
    }
    use spatial::*;
    let (laws, rod) = ((LAW, DryFriction::new(FRICTION[0], FRICTION[1])), Rod::uniform(length, radius, mass));
    let (hinge, slide) = (Revolute::about([0.0, 0.0, 1.0]).with(laws), Prismatic::along([0.6, 0.0, 0.8]).with(laws));
    let across = mass * (length * length / 3.0 + radius * radius / 4.0);
    follows!("revolute", across, System::new(Clamped::origin(), (hinge, rod), Free));
    follows!("prismatic", mass, System::new(Clamped::origin(), (slide, rod), Free));
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

/// The start of a run of so many coordinates.
macro_rules! begun {
    ($scene:expr, $count:literal) => {{
        let mut start = $scene.motion();
        start.set_coordinates(&[0.3; $count])?;
        $scene.with_rates(start, &[0.8, -0.5, 0.4, 0.2][..$count])?
    }};
}

#[test]
fn runs_are_those_of_dop853() -> Result<(), Error> {
    macro_rules! compare {
        ($space:ident, $name:literal, $scene:expr, $count:literal, $size:ident) => {{
            use $space::{Dop853, Loads, Taylor, Unloaded};
            let scene = $scene;
            let start = begun!(scene, $count);
            beside_dop853_with_forces!($name, scene, Unloaded, start, 1.0, $size);
            let driven = Loads::none().in_joints_over_time(Drive);
            beside_dop853_with_forces!(concat!("driven ", $name), scene, driven, start, 1.0, $size);
        }};
    }
    compare!(planar, "tree", tree!(LAW), 4, abs);
    compare!(spatial, "arm", arm!(LAW), 3, norm);
    Ok(())
}

#[test]
fn orders_are_those_of_the_series() -> Result<(), Error> {
    use planar::*;
    let scene = tree!(LAW);
    let start = begun!(scene, 4);
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
    for (k, jet) in jets.iter().enumerate() {
        let slope = slope(1e-3, |e| Ok(of(3.0 + e)?[k]))?;
        println!("coordinate {k}: {} by {slope}", jet.eps[0]);
        assert!(slope.abs() > 1e-3);
        near(jet.eps[0], slope, 1e-8);
    }
    Ok(())
}
