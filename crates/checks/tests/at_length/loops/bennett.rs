//! Bennett's linkage: four revolutes that count as fixed three times over, and one freedom. Lengths a, b of links across from each other
//! and twists α, β with a sin β = b sin α.
//!
//! Its rotations, R for axes, close as R_z(θ₁) R_x(α) R_z(θ₂) R_x(β) = R_x(−β) R_z(θ₂) R_x(−α) R_z(θ₁). With p = (α+β)/2, q = (α−β)/2
//! and half tangents t the x component of where z goes says (t₂ cos q + t₁ cos p)(sin p + t₁ t₂ sin q) = 0: the linkage moves by the
//! second factor.

use catena::loading::Unloaded;
use catena::spatial::{self, *};
use catena::{Error, Fault};
use catena_oracle::near;
use nalgebra::{Rotation3, Vector3};

const LENGTHS: [f64; 2] = [0.4, 0.7];
const ALPHA: f64 = 0.5;
/// Mass (kg), moments of inertia along and across (kg·m²) of each link, and its mass centre as a share of its length.
const MASSES: [f64; 3] = [1.0, 1.5, 0.8];
const ALONG: f64 = 0.01;
const ACROSS: f64 = 0.06;
const CENTRE: f64 = 0.4;
const GRAVITY: [f64; 3] = [0.5, -2.0, -9.0];
/// Angle (rad) and rate (rad/s) of the crank at the start, end of the run (s).
const START: f64 = 1.0;
const RATE: f64 = 2.0;
const END: f64 = 3.0;

fn beta() -> f64 {
    (LENGTHS[1] * ALPHA.sin() / LENGTHS[0]).asin()
}

/// The second angle and its derivative, for the first.
fn second(first: f64) -> [f64; 2] {
    let product = -(0.5 * (ALPHA + beta())).sin() / (0.5 * (ALPHA - beta())).sin();
    let (s, c) = (0.5 * first).sin_cos();
    [2.0 * (product * c).atan2(s), -product / (s * s + product * product * c * c)]
}

fn about_x(angle: f64) -> Rotation3<f64> {
    Rotation3::from_axis_angle(&Vector3::x_axis(), angle)
}

fn about_z(angle: f64) -> Rotation3<f64> {
    Rotation3::from_axis_angle(&Vector3::z_axis(), angle)
}

/// Inertia of the one freedom (kg·m²) and potential (J) at an angle of the crank, and by how far crank and coupler miss the rocker (m).
fn alone(first: f64) -> [f64; 3] {
    let ([a, b], [second, slope]) = (LENGTHS, second(first));
    let crank = about_z(first);
    let axis = crank * about_x(ALPHA) * Vector3::z();
    let coupler = crank * about_x(ALPHA) * about_z(second);
    let hinge = about_x(-beta());
    let rocker = hinge * about_z(second);
    let (on_crank, on_rocker) = (crank * Vector3::x() * a, Vector3::x() * -b);
    // Begin and velocity of it, link, angular velocity, for a unit rate.
    let links = [
        (Vector3::zeros(), Vector3::zeros(), on_crank, Vector3::z()),
        (on_crank, Vector3::z().cross(&on_crank), coupler * Vector3::x() * b, Vector3::z() + axis * slope),
        (on_rocker, Vector3::zeros(), rocker * Vector3::x() * -a, hinge * Vector3::z() * slope),
    ];
    let (mut inertia, mut potential) = (0.0, 0.0);
    for ((begin, velocity, link, spin), mass) in links.iter().zip(MASSES) {
        let centre = link * CENTRE;
        let along = spin.dot(&link.normalize()).powi(2);
        inertia += mass * (velocity + spin.cross(&centre)).norm_squared() + ALONG * along;
        inertia += ACROSS * (spin.norm_squared() - along);
        potential -= mass * Vector3::from(GRAVITY).dot(&(begin + centre));
    }
    [inertia, potential, (links[1].0 + links[1].2 - links[2].0 - links[2].2).norm()]
}

/// Angle and rate of the crank by the equation of the one freedom, I φ'' = −½ I' φ'² − V', with derivatives by differences. The classical
/// rule in so many steps.
fn by_hand(steps: usize) -> [f64; 2] {
    let slope = |[angle, rate]: [f64; 2]| {
        let at = |x: f64| alone(angle + 1e-3 * x);
        let [far, near] = [[at(2.0), at(-2.0)], [at(1.0), at(-1.0)]];
        let by = |k: usize| (8.0 * (near[0][k] - near[1][k]) - (far[0][k] - far[1][k])) / 12e-3;
        [rate, -(0.5 * by(0) * rate * rate + by(1)) / alone(angle)[0]]
    };
    let plus = |y: [f64; 2], h: f64, k: [f64; 2]| [y[0] + h * k[0], y[1] + h * k[1]];
    let h = END / steps as f64;
    (0..steps).fold([START, RATE], |y, _| {
        let k = slope(y);
        let l = slope(plus(y, 0.5 * h, k));
        let m = slope(plus(y, 0.5 * h, l));
        let n = slope(plus(y, h, m));
        core::array::from_fn(|i| y[i] + h / 6.0 * (k[i] + 2.0 * (l[i] + m[i]) + n[i]))
    })
}

type Crank = (Revolute<f64>, RigidBody<f64>, Revolute<f64>, RigidBody<f64>);
type Rocker = (RigidBody<f64>, Weld<f64>, Revolute<f64>, RigidBody<f64>);
type Scene<K> = spatial::System<f64, Clamped<[f64; 3], Rotation<f64>>, Network<Crank, Rocker, K>, Free>;

/// The linkage on the ground link, of length b, closed between coupler and rocker.
macro_rules! linkage {
    ($closing:expr) => {{
        let ([a, b], both) = (LENGTHS, ALPHA + beta());
        let link = |length: f64, mass: f64| {
            let tensor = [[ALONG, 0.0, 0.0], [0.0, ACROSS, 0.0], [0.0, 0.0, ACROSS]];
            RigidBody::new(mass, tensor, [CENTRE * length, 0.0, 0.0], [length, 0.0, 0.0])
        };
        let hinge = |turned: f64| Revolute::about([0.0, -turned.sin(), turned.cos()]);
        let main = (hinge(0.0), link(a, MASSES[0]), hinge(ALPHA), link(b, MASSES[1]));
        // The rocker's axes are turned so that the last hinge stands in them as it stands in the coupler's.
        let turned = Weld::at(Rotation::from_angles([-2.0 * both, 0.0, 0.0]));
        let side = (RigidBody::massless([-b, 0.0, 0.0]), turned, hinge(2.0 * both - beta()), link(-a, MASSES[2]));
        System::new(Clamped::origin(), Network::new(main, side, $closing(hinge(both))), Free)?.with_gravity(GRAVITY)
    }};
}

#[test]
fn bennetts_linkage_turns() -> Result<(), Error> {
    let scene: Scene<LeastNorm<Revolute<f64>>> = linkage!(LeastNorm);
    let [angle, slope] = second(START);
    near(alone(START)[2].max(alone(4.0)[2]), 0.0, 1e-15);
    let angles = [START, angle, angle];
    let start = scene.with_rates(scene.at_rest(&angles)?, &[RATE, slope * RATE, slope * RATE])?;
    let start = scene.with_accelerations(start, &Unloaded)?;
    let energy = scene.budget(&start)?.energy();
    near(energy, 0.5 * alone(START)[0] * RATE * RATE + alone(START)[1], 1e-14);

    let [coarse, expected] = [3_000, 6_000].map(by_hand);
    println!("by hand {expected:?}, {:.1e}", (coarse[0] - expected[0]).abs());
    for (tolerance, most) in [(1e-6, 1e-5), (1e-12, 1e-10)] {
        let (mut related, mut lost, mut open) = (0.0_f64, 0.0_f64, 0.0_f64);
        let run = scene.simulation(Dop853::tolerance(tolerance)).run(start, END, |now| {
            let mut found = vec![];
            catena::system::Position::visit(now.motion().position(), &mut |x: f64| found.push(x));
            let [angle, slope] = second(found[0]);
            let apart = |x: f64| (0.5 * (x - angle)).sin().abs();
            let mut rates = vec![];
            catena::system::Rate::visit(now.motion().rate(), &mut |x: f64| rates.push(x));
            related = related.max(apart(found[1])).max(apart(found[2])).max((rates[1] - slope * rates[0]).abs());
            lost = lost.max((now.energy() - energy).abs());
            let bodies = now.bodies();
            let ends = [1, 3].map(|k| bodies.get(k).map(|body| body.outboard().place).unwrap());
            open = open.max((ends[0] - ends[1]).norm());
        })?;
        let (mut angle, mut rate) = (None, None);
        catena::system::Position::visit(run.motion.position(), &mut |x: f64| angle = angle.or(Some(x)));
        catena::system::Rate::visit(run.motion.rate(), &mut |x: f64| rate = rate.or(Some(x)));
        let missed = [angle.unwrap() - expected[0], rate.unwrap() - expected[1]];
        println!("{tolerance:e}: {} steps, misses {missed:?}", run.steps + run.rejected);
        println!("  relation {related:.1e}, energy {lost:.1e}, closure {open:.1e}");
        assert!(missed.iter().all(|x| x.abs() <= most) && lost <= most);
        assert!(related <= 1e-13 && open <= 1e-14);
    }
    // Stages of steps of one size are off the places where closures follow from each other, by what the rule leaves out.
    macro_rules! misses {
        ($($rule:expr),*) => {
            [$({
                let run = scene.simulation($rule).run(start, END, |_| ())?;
                let mut angle = None;
                catena::system::Position::visit(run.motion.position(), &mut |x: f64| angle = angle.or(Some(x)));
                println!("{}: misses {:.1e}", stringify!($rule), angle.unwrap() - expected[0]);
                (angle.unwrap() - expected[0]).abs()
            }),*]
        };
    }
    let fourth = misses![Rk4::step(0.02), Rk4::step(0.01), Rk4::step(0.005), Sdirk4::new().step(0.01)];
    assert!(fourth[0] < 1e-3 && fourth[1] < 0.1 * fourth[0] && fourth[2] < 0.1 * fourth[1] && fourth[3] < 1e-5);
    let second = misses![GeneralizedAlpha::new(0.8).step(0.004), GeneralizedAlpha::new(0.8).step(0.002)];
    assert!(second[0] < 1e-2 && second[1] < 0.3 * second[0]);
    Ok(())
}

/// Three of five closures follow from the others.
#[test]
fn bennetts_linkage_is_held_too_often() -> Result<(), Error> {
    let scene: Scene<Revolute<f64>> = linkage!(|hinge| hinge);
    let start = scene.at_rest(&[START, second(START)[0], second(START)[0]])?;
    let refused = scene.with_accelerations(start, &Unloaded).map(|_| ()).unwrap_err();
    println!("{refused}");
    assert!(matches!(refused.fault, Fault::RedundantClosures { independent: 2, of: 5, .. }));
    Ok(())
}
