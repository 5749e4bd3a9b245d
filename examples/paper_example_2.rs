//! Numerical example 2 of the paper: the large motion of a flexible pendulum, by the paper's scheme and by this crate's defaults.
//!
//! The paper divides the beam into twenty rigid bodies with rotary springs between them; so does this. Its other parameters stand in its
//! figure 3(a), which its text does not repeat. Here: length 1 m, mass 1 kg, EI = 1 N·m², so that springs have EI/ℓ = 20 N·m/rad (the
//! number of its section 5.5), released at rest, straight, 60° below the horizontal, g = 9.81 m/s².
//!
//! ```text
//! cargo run --release --example paper_example_2
//! ```

mod common;

use catena::loading::Unloaded;
use catena::paper::*;
use catena::planar::index::{QY, X, Y};
use catena::planar::{Dop853, ElasticHinge, Free, Pinned, Rod, Spring as HingeSpring, System};
use common::{BLUE, Drawn, FAINT, GREEN, GREY, ORANGE, blend, line};
use std::f64::consts::FRAC_PI_3;
use std::path::PathBuf;

const N: usize = 20;
type Pendulum = System<f64, Pinned<[f64; 2]>, (Rod<f64>, [(ElasticHinge<HingeSpring<f64>>, Rod<f64>); N - 1]), Free>;

/// Tip (m) at t = 1 s: an order-8 integration of dense equations at 1e-13.
const REFERENCE: [f64; 2] = [-0.43225486262, -0.90061862755];

/// Times, the tip (m), and the vertical force of the ground (N).
type Tips = Vec<(f64, [f64; 2], f64)>;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rod = Rod::uniform(1.0 / N as f64, 1.0 / N as f64); // length (m), mass (kg)
    let pendulum: &Pendulum =
        &System::new(Pinned::origin(), (rod, [(ElasticHinge::rotary(20.0), rod); N - 1]), Free)?.with_gravity(9.81);
    let start = pendulum.at_rest(&[-FRAC_PI_3; N])?;
    let miss = |tip: [f64; 2]| (tip[0] - REFERENCE[0]).hypot(tip[1] - REFERENCE[1]);

    println!("Example 2: flexible pendulum of {N} rods. Error of the tip (m) at t = 1 s, and how long the run lasts.");
    println!("The division is the paper's, length, mass and stiffness are stand-ins.\n");
    println!("  scheme                                           step     tip error    sweeps   to 10 s");
    macro_rules! row {
        ($name:expr, $scheme:expr, $dt:expr) => {{
            let mut run = $scheme.start(pendulum, &start, &Unloaded, $dt)?;
            let (mut tips, mut swept, mut error): (Tips, _, _) = (vec![], 0, f64::NAN);
            let mut fate = String::from("yes");
            while run.time() < 10.0 - 0.5 * $dt {
                if let Err(broken) = run.step() {
                    fate = format!("{broken}");
                    break;
                }
                let tip = run.stations()[2 * N];
                if tip[X].hypot(tip[Y]) > 1.1 {
                    fate = format!("torn apart at {:.2} s", run.time());
                    break;
                }
                tips.push((run.time(), [tip[X], tip[Y]], run.stations()[0][QY]));
                if (run.time() - 1.0).abs() < 0.5 * $dt {
                    (swept, error) = (run.sweeps(), miss([tip[X], tip[Y]]));
                }
            }
            println!("  {:44} {:8} {error:13.1e} {swept:9}   {fate}", $name, $dt);
            tips
        }};
    }
    let printed = row!("as printed: γ = ½, product", Scheme::new(Newmark::new(0.25, 0.5)), 0.002);
    row!("as printed: γ = ½, product", Scheme::new(Newmark::new(0.25, 0.5)), 0.001);
    row!("γ = 0.6, product", Scheme::new(Newmark::damped(0.6)), 0.002);
    let riccati = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(At::Predictor).solved_by(Solver::Riccati);
    let damped = row!("γ = 0.6, Riccati", Scheme::new(Newmark::damped(0.6)).solved_by(Solver::Riccati), 0.002);
    row!("generalised-α at the predictor, Riccati", riccati, 0.01);
    row!("generalised-α at the predictor, Riccati", riccati, 0.002);
    row!("joint coordinates, γ = ½", JointScheme::new(Newmark::new(0.25, 0.5)), 0.01);
    row!("joint coordinates, γ = ½", JointScheme::new(Newmark::new(0.25, 0.5)), 0.002);

    // This crate's own rules for stiff scenes, and what it uses by default.
    for dt in [0.01, 0.002] {
        let run = pendulum.simulate(start, catena::planar::GeneralizedAlpha::new(0.8).step(dt), 1.0, |_| ())?;
        let tip = pendulum.stations(&run.motion, &Unloaded)?.tip().frame.place;
        println!(
            "  {:44} {dt:8} {:13.1e} {:9}   yes",
            "this crate: generalised-α, acceleration level",
            miss([tip.x, tip.y]),
            run.sweeps
        );
    }
    let (mut exact, mut shapes): (Tips, Vec<Vec<(f64, f64)>>) = (vec![], vec![]);
    let rule = Dop853::tolerance(1e-10);
    pendulum.simulation(rule).every(0.01).run(start, 3.0, |now| {
        let stations = now.stations();
        let tip = stations.tip().frame.place;
        exact.push((now.time(), [tip.x, tip.y], stations.root().internal.force.y));
        shapes.push(stations.iter().map(|station| (station.frame.place.x, station.frame.place.y)).collect());
    })?;
    let run = pendulum.simulate(start, rule, 1.0, |_| ())?;
    let tip = pendulum.stations(&run.motion, &Unloaded)?.tip().frame.place;
    println!(
        "  {:44} {:>8} {:13.1e} {:9}   yes",
        "this crate: DOP853 at 1e-10",
        "free",
        miss([tip.x, tip.y]),
        run.sweeps
    );

    println!("\nPicture: {}", draw(&exact, &shapes, &printed, &damped)?.display());
    Ok(())
}

/// Shapes on the left, the tip over time on the right.
fn draw(exact: &Tips, shapes: &[Vec<(f64, f64)>], printed: &Tips, damped: &Tips) -> Drawn<PathBuf> {
    common::picture("paper_example_2", (1000, 520), |area| {
        let subtitle = "Twenty rods of 5 cm and 50 g with springs of 20 N·m/rad between them, released at rest 60° below the horizontal.";
        let area = common::heading(area, "Example 2: flexible pendulum", subtitle)?;
        let (left, right) = area.split_horizontally(common::pixels(420.0));
        let mut path = common::chart(&left, "First swing (every 50 ms, places in m)", "", -0.75..0.65, -1.1..0.3)?;
        let swing: Vec<_> = shapes.iter().take(101).step_by(5).collect();
        for (k, shape) in swing.iter().enumerate() {
            let share = k as f64 / (swing.len() - 1) as f64;
            common::links(&mut path, (*shape).clone(), line(blend(FAINT, BLUE, 0.1 + 0.9 * share), 2.0))?;
        }
        let names = [("DOP853", GREY), ("as printed, γ = ½, 2 ms", ORANGE), ("γ = 0.6, 2 ms", GREEN)];
        let (upper, lower) = right.split_vertically(common::pixels(220.0));
        let mut tip = common::chart(&upper, "Tip, x (m)", "time (s)", 0.0..3.0, -1.0..1.0)?;
        common::legend(&upper, &names)?;
        let until = |tips: &Tips| tips.iter().filter(|(t, ..)| *t <= 3.0).copied().collect::<Tips>();
        let title = "Vertical force at the root (N): with γ = ½ it alternates";
        let mut force = common::chart(&lower, title, "time (s)", 0.0..3.0, -20.0..40.0)?;
        for (tips, style) in [(printed, line(ORANGE, 1.2)), (exact, line(GREY, 6.0)), (damped, line(GREEN, 1.8))] {
            let tips = until(tips);
            common::curve(&mut force, tips.iter().map(|(t, _, y)| (*t, y.clamp(-20.0, 40.0))), style)?;
        }
        for (tips, style) in [(exact, line(GREY, 7.0)), (damped, line(GREEN, 4.0)), (printed, line(ORANGE, 1.4))] {
            common::curve(&mut tip, until(tips).iter().map(|(t, [x, _], _)| (*t, *x)), style)?;
        }
        Ok(())
    })
}
