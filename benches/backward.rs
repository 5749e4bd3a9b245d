//! What gradients that go backward cost: run and gradient beside the plain run of the same steps.
//!
//! `cargo bench --bench backward` makes runs of 50 steps, plain (`advance`), plain under torques in all joints held over each step, and
//! forward and backward for the gradient of a number by all initial values, all parameters and the torques of each step. Times are the least
//! of many, ways taking turns; instructions are counted by valgrind. Before them steps with their Jacobians (`-- steps`: these alone).

#[path = "parts/clock.rs"]
mod clock;
#[path = "parts/count.rs"]
mod count;

use clock::{median, progress};
use count::count;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

const STEPS: usize = 50;

/// Runs of a scene by a way: plain, under torques, with the gradient.
type Case = Box<dyn FnMut(usize) -> f64>;

struct Row {
    name: &'static str,
    /// Bodies times stages of a run.
    sweeps: usize,
    make: fn() -> Case,
}

/// A scene, its angles at the start, the efforts in its joints, a rule, and which of its steps are those under torques.
macro_rules! row {
    ($rows:ident, $name:literal, $bodies:literal, $method:expr, $stages:literal, $dt:literal, $scene:expr, $angles:expr, $effort:expr) => {
        row!($rows, $name, $bodies, $method, $stages, $dt, $scene, $angles, $effort, advance)
    };
    ($rows:ident, $name:literal, $bodies:literal, $method:expr, $stages:literal, $dt:literal, $scene:expr, $angles:expr, $effort:expr, $step:ident) => {
        $rows.push(Row {
            name: $name,
            sweeps: $bodies * $stages * STEPS,
            make: || {
                let system = Box::leak(Box::new($scene));
                let start = system.at_rest(&$angles).unwrap();
                let start = system.with_accelerations(start, &Unloaded).unwrap();
                let torques = &*vec![$effort; STEPS * system.joints()].leak();
                let (mut by_torques, mut states) = (torques.to_vec(), vec![start.clone(); STEPS + 1]);
                let joints = system.joints();
                let (mut past, mut next) = (start.clone(), start.clone());
                let (mut stepper, mut driven, mut backward) =
                    (system.stepper($method), system.stepper($method), system.backward($method));
                let weights = vec![1.0; start.rates().len()];
                Box::new(move |way| match way {
                    0 => {
                        past.clone_from(&start);
                        for _ in 0..STEPS {
                            stepper.advance(&past, &Unloaded, $dt, &mut next).unwrap();
                            core::mem::swap(&mut past, &mut next);
                        }
                        past.rates()[0]
                    }
                    1 => {
                        past.clone_from(&start);
                        for k in 0..STEPS {
                            let loads = Loads::none().efforts(&torques[k * joints..][..joints]);
                            driven.$step(&past, &loads, $dt, &mut next).unwrap();
                            core::mem::swap(&mut past, &mut next);
                        }
                        past.rates()[0]
                    }
                    _ => {
                        backward.run(&start, $dt, STEPS, torques, &mut states).unwrap();
                        let gradient = backward.gradient(torques, &states, &mut by_torques, |step, _, by| {
                            if step == STEPS { by.add(&weights, &weights) } else { Ok(()) }
                        });
                        gradient.unwrap().by_position()[0]
                    }
                })
            },
        });
    };
}

/// Rods on pins, all but the first in an array.
macro_rules! pins {
    ($N:literal) => {{
        let rod = Rod::uniform(black_box(1.0 / $N as f64), 1.0 / $N as f64);
        System::new(Pinned::origin(), (rod, [(Pin, rod); $N - 1]), Free).unwrap().with_gravity(9.81)
    }};
}

/// Two rods on pins, none in an array.
macro_rules! pair {
    () => {{
        let rod = Rod::uniform(black_box(0.5), 0.5);
        System::new(Pinned::origin(), (rod, Pin, rod), Free).unwrap().with_gravity(9.81)
    }};
}

/// Rods on pins in an arch, whose tip is pinned.
macro_rules! held {
    ($N:literal) => {{
        let rod = Rod::uniform(black_box(1.0 / $N as f64), 1.0 / $N as f64);
        let (x, y) = (0..$N).fold((0.0, 0.0), |(x, y), i| {
            let angle = arch::<$N>()[i];
            (x + rod.length() * angle.cos(), y + rod.length() * angle.sin())
        });
        System::new(Pinned::origin(), (rod, [(Pin, rod); $N - 1]), Pinned::at(x, y)).unwrap().with_gravity(9.81)
    }};
}

/// Rods on stiff hinges, which hang from a pin.
macro_rules! hinges {
    ($N:literal) => {{
        let rod = Rod::uniform(black_box(1.0 / $N as f64), 1.0 / $N as f64);
        let hinge = ElasticHinge::rotary(black_box(100.0)).damped(0.1);
        System::new(Pinned::origin(), (rod, [(hinge, rod); $N - 1]), Free).unwrap().with_gravity(9.81)
    }};
}

/// A four-bar linkage, and its angles.
macro_rules! four_bar {
    () => {{
        let rod = |length: f64| Rod::uniform(black_box(length), length);
        let rocker = (RigidBody::massless([1.0, 0.0]), Pin, rod(0.9));
        let net = Network::new((Pin, rod(0.5), Pin, rod(1.2)), rocker, Pin);
        System::new(Clamped::at(0.0, 0.0, 0.0), net, Free).unwrap().with_gravity(9.81)
    }};
}
const FOUR_BAR: [f64; 3] =
    [core::f64::consts::FRAC_PI_3, 0.3211050148305652, core::f64::consts::PI - 2.017338833372132];

/// Windows of four equal rods in a row, behind a rod.
macro_rules! windows {
    ($N:literal) => {{
        let rod = Rod::uniform(black_box(1.0 / $N as f64), 1.0 / $N as f64);
        let window = Network::new((Pin, rod, Pin, rod), (Pin, rod, Pin, rod), Pin);
        System::new(Pinned::origin(), (rod, [window; $N]), Free).unwrap().with_gravity(9.81)
    }};
}

/// A rod, and parallelograms.
fn lattice<const N: usize>() -> [f64; N] {
    core::array::from_fn(|i| if i == 0 { -1.0 } else { [-0.4, -1.6, -1.6, -0.4][(i - 1) % 4] })
}

/// Angles of an arch.
fn arch<const N: usize>() -> [f64; N] {
    core::array::from_fn(|i| 1.0 - 2.0 * (i as f64 + 0.5) / N as f64)
}

/// Rods on balls.
macro_rules! balls {
    ($N:literal) => {{
        let rod = Rod::uniform(black_box(1.0 / $N as f64), 0.1 / $N as f64, 1.0 / $N as f64);
        System::new(Pinned::origin(), (rod, [(Ball, rod); $N - 1]), Free).unwrap().with_gravity([0.0, 0.0, -9.81])
    }};
}

/// Rods on balls in an arch, whose tip is held by a ball.
macro_rules! held_by_a_ball {
    ($N:literal) => {{
        let rod = Rod::uniform(black_box(1.0 / $N as f64), 0.1 / $N as f64, 1.0 / $N as f64);
        let (x, y) = arch::<$N>().iter().fold((0.0, 0.0), |(x, y), angle| (x + angle.cos(), y + angle.sin()));
        let tip = Pinned::at([x / $N as f64, y / $N as f64, 0.0]);
        System::new(Pinned::origin(), (rod, [(Ball, rod); $N - 1]), tip).unwrap().with_gravity([0.0, 0.0, -9.81])
    }};
}

/// A rod on a ball, and a window of four that a ball closes.
macro_rules! window_on_balls {
    () => {{
        let rod = Rod::uniform(black_box(0.5), 0.05, 0.5);
        let window = Network::new((Ball, rod, Ball, rod), (Ball, rod, Ball, rod), Ball);
        System::new(Pinned::origin(), (rod, window), Free).unwrap().with_gravity([0.0, 0.0, -9.81])
    }};
}

/// Turns about z.
fn about_z<const N: usize>(angles: &[f64]) -> [f64; N] {
    core::array::from_fn(|i| if i % 3 == 2 { angles[i / 3] } else { 0.0 })
}

/// A body with its mass centre, axes of inertia and outboard end anywhere.
fn body(share: f64) -> catena::spatial::RigidBody<f64> {
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]]
        .map(|row| row.map(|x| x * share * share * share));
    catena::spatial::RigidBody::new(
        share,
        tensor,
        [0.5 * share, 0.03 * share, -0.02 * share],
        [share, 0.1 * share, 0.05 * share],
    )
}

/// Bodies on balls.
macro_rules! bodies {
    ($N:literal) => {{
        let body = body(black_box(1.0 / $N as f64));
        System::new(Pinned::origin(), (body, [(Ball, body); $N - 1]), Free).unwrap().with_gravity([0.0, 0.0, -9.81])
    }};
}

/// An arm of bodies on revolute joints, about axes that alternate.
macro_rules! arm {
    ($N:literal) => {{
        let body = body(black_box(1.0 / $N as f64));
        let link = |i: usize| (Revolute::about([0.0, (i % 2) as f64, ((i + 1) % 2) as f64]), body);
        let links: [_; $N] = core::array::from_fn(link);
        System::new(Clamped::origin(), links, Free).unwrap().with_gravity([0.0, 0.0, -9.81])
    }};
}

/// An arm of links on hinges in axes of the bodies, each turned by a right angle against the one before.
macro_rules! robot {
    ($N:literal) => {{
        let tensor = [[0.05, 0.0, 0.0], [0.0, 0.04, 0.0], [0.0, 0.0, 0.01]];
        let link = Link::<f64, 0b110, 0b1111>::new(black_box(2.0), [0.0, 0.02, 0.1], tensor);
        let joint = Hinge::at::<0b100>([0.0, 0.0, 0.3]).turned(Quarter::<30>);
        let chain = (Hinge::level().grounded(), link, [(joint, link); $N - 1]);
        System::new(Base::origin(), chain, Free).unwrap().with_gravity([0.0, 0.0, -9.81])
    }};
}

fn rows() -> Vec<Row> {
    let mut rows = vec![];
    {
        use catena::planar::*;
        row!(rows, "2 rods on pins, RK4", 2, Rk4, 4, 1e-3, pins!(2), [0.0; 2], 1e-3);
        row!(rows, "2 rods in a tuple, RK4", 2, Rk4, 4, 1e-3, pair!(), [0.0; 2], 1e-3);
        row!(rows, "20 rods on pins, RK4", 20, Rk4, 4, 1e-3, pins!(20), [0.0; 20], 1e-3);
        row!(rows, "100 rods on pins, RK4", 100, Rk4, 4, 1e-3, pins!(100), [0.0; 100], 1e-3);
        row!(rows, "2 + 1 rods, tip pinned, RK4", 3, Rk4, 4, 1e-3, held!(3), arch::<3>(), 1e-3);
        row!(rows, "20 rods, tip pinned, RK4", 20, Rk4, 4, 1e-3, held!(20), arch::<20>(), 1e-3);
        row!(rows, "four-bar, RK4", 3, Rk4, 4, 1e-3, four_bar!(), FOUR_BAR, 1e-3);
        row!(rows, "four-bar, DOP853", 3, Dop853, 12, 1e-3, four_bar!(), FOUR_BAR, 1e-3);
        row!(rows, "rod and window, RK4", 5, Rk4, 4, 1e-3, windows!(1), lattice::<5>(), 1e-3);
        row!(rows, "rod and two windows, RK4", 9, Rk4, 4, 1e-3, windows!(2), lattice::<9>(), 1e-3);
        row!(rows, "rod and five windows, RK4", 21, Rk4, 4, 1e-3, windows!(5), lattice::<21>(), 1e-3);
        row!(rows, "2 rods, stiff hinge, SDIRK4", 2, Sdirk4::new(), 16, 1e-2, hinges!(2), [0.0; 2], 1e-3);
        row!(rows, "20 rods, stiff hinges, SDIRK4", 20, Sdirk4::new(), 16, 1e-2, hinges!(20), [0.0; 20], 1e-3);
        row!(
            rows,
            "2 rods, stiff hinge, generalised-α",
            2,
            GeneralizedAlpha::new(0.8),
            2,
            1e-2,
            hinges!(2),
            [0.0; 2],
            1e-3,
            step
        );
        row!(
            rows,
            "20 rods, stiff hinges, generalised-α",
            20,
            GeneralizedAlpha::new(0.8),
            2,
            1e-2,
            hinges!(20),
            [0.0; 20],
            1e-3,
            step
        );
        row!(rows, "2 rods on pins, DOP853", 2, Dop853, 12, 1e-3, pins!(2), [0.0; 2], 1e-3);
        row!(rows, "2 rods in a tuple, DOP853", 2, Dop853, 12, 1e-3, pair!(), [0.0; 2], 1e-3);
        row!(rows, "20 rods on pins, DOP853", 20, Dop853, 12, 1e-3, pins!(20), [0.0; 20], 1e-3);
        row!(rows, "100 rods on pins, DOP853", 100, Dop853, 12, 1e-3, pins!(100), [0.0; 100], 1e-3);
    }
    use catena::spatial::*;
    row!(rows, "3 rods on balls, RK4", 3, Rk4, 4, 1e-3, balls!(3), angles::<9>(), Effort([1e-5; 3]));
    row!(rows, "3 rods on balls, DOP853", 3, Dop853, 12, 1e-3, balls!(3), angles::<9>(), Effort([1e-5; 3]));
    row!(rows, "20 rods on balls, RK4", 20, Rk4, 4, 1e-3, balls!(20), angles::<60>(), Effort([1e-7; 3]));
    row!(rows, "20 rods on balls, DOP853", 20, Dop853, 12, 1e-3, balls!(20), angles::<60>(), Effort([1e-7; 3]));
    row!(
        rows,
        "3 rods on balls, tip held, RK4",
        3,
        Rk4,
        4,
        1e-3,
        held_by_a_ball!(3),
        about_z::<9>(&arch::<3>()),
        Effort([1e-5; 3])
    );
    row!(
        rows,
        "20 rods on balls, tip held, RK4",
        20,
        Rk4,
        4,
        1e-3,
        held_by_a_ball!(20),
        about_z::<60>(&arch::<20>()),
        Effort([1e-7; 3])
    );
    row!(
        rows,
        "rod and window on balls, RK4",
        5,
        Rk4,
        4,
        1e-3,
        window_on_balls!(),
        about_z::<15>(&lattice::<5>()),
        Effort([1e-5; 3])
    );
    row!(rows, "3 bodies on balls, RK4", 3, Rk4, 4, 1e-3, bodies!(3), angles::<9>(), Effort([1e-5; 3]));
    row!(rows, "20 bodies on balls, RK4", 20, Rk4, 4, 1e-3, bodies!(20), angles::<60>(), Effort([1e-7; 3]));
    row!(rows, "7 bodies on revolutes, RK4", 7, Rk4, 4, 1e-3, arm!(7), angles::<7>(), Effort([1e-5; 3]));
    row!(rows, "7 bodies on revolutes, DOP853", 7, Dop853, 12, 1e-3, arm!(7), angles::<7>(), Effort([1e-5; 3]));
    {
        use catena::robot::*;
        row!(rows, "7 links on hinges, body axes, RK4", 7, Rk4, 4, 1e-3, robot!(7), angles::<7>(), Effort([1e-5; 3]));
    }
    rows
}

/// Nanoseconds of a step of RK4 of rods on pins: plain, under torques, with all Jacobians row by row, four and eight rows at a time.
macro_rules! linearised {
    ($N:literal) => {{
        use catena::planar::*;
        use catena::scalar::Pack;
        let system = pins!($N);
        let mut now = system.at_rest(&core::array::from_fn::<_, $N, _>(|i| -1.0 + 0.1 * i as f64)).unwrap();
        now.set_rates(&[0.3; $N]).unwrap();
        let now = system.with_accelerations(now, &Unloaded).unwrap();
        let (four, eight) = (system.clone().lift(Pack::<f64, 4>::of), system.clone().lift(Pack::<f64, 8>::of));
        let (start_4, start_8) = (now.clone().lift(Pack::<f64, 4>::of), now.clone().lift(Pack::<f64, 8>::of));
        let (mut next, mut next_4, mut next_8) = (now.clone(), start_4.clone(), start_8.clone());
        let (mut stepper, mut driven) = (system.stepper(Rk4), system.stepper(Rk4));
        let (mut rows, mut fours, mut eights) = (system.backward(Rk4), four.backward(Rk4), eight.backward(Rk4));
        let (mut a, mut b, torques) = (vec![0.0; 4 * $N * $N], vec![0.0; 2 * $N * $N], [1e-3; $N]);
        let (torques_4, torques_8) = (torques.map(Pack::of), torques.map(Pack::of));
        let mut least = [f64::INFINITY; 5];
        for _ in 0..400 {
            for way in 0..5 {
                let start = Instant::now();
                for _ in 0..20 {
                    match way {
                        0 => stepper.advance(&now, &Unloaded, 1e-3, &mut next),
                        1 => driven.advance(&now, &Loads::none().efforts(&torques), 1e-3, &mut next),
                        2 => rows.linearised_step(&now, 1e-3, &torques, &mut next, &mut a, &mut b),
                        3 => fours.linearised_step_in_rows(&start_4, 1e-3, &torques_4, &mut next_4, &mut a, &mut b),
                        _ => eights.linearised_step_in_rows(&start_8, 1e-3, &torques_8, &mut next_8, &mut a, &mut b),
                    }
                    .unwrap();
                    black_box((&next, &a, &b));
                }
                least[way] = least[way].min(start.elapsed().as_nanos() as f64 / 20.0);
            }
        }
        println!(
            "| {} | {:.0} | {:.2} | {:.1} | {:.1} | {:.1} |",
            $N,
            least[0],
            least[1] / least[0],
            least[2] / least[0],
            least[3] / least[0],
            least[4] / least[0]
        );
    }};
}

/// Steps with their Jacobians.
fn steps() {
    println!("| rods, RK4 | plain step (ns) | under torques | row by row | four rows | eight rows |");
    println!("|---|---:|---:|---:|---:|---:|");
    linearised!(2);
    linearised!(7);
    linearised!(20);
}

/// Angles that differ.
fn angles<const N: usize>() -> [f64; N] {
    core::array::from_fn(|i| 0.1 * (i % 10) as f64)
}

/// Instructions of a run: what further runs add.
fn instructions(program: &Path, row: usize, way: usize) -> Option<f64> {
    let runs = |runs: &str| count(program, &["repeat", &row.to_string(), &way.to_string(), runs]).ok();
    Some((runs("4")? - runs("1")?) as f64 / 3.0)
}

/// Nanoseconds of a run by each way, the least of many; ways take turns. Beside it the middle one of the ratios of gradient and plain run.
fn wall(row: &Row) -> ([f64; 3], f64) {
    let mut case = (row.make)();
    let (mut least, mut ratios) = ([f64::INFINITY; 3], vec![]);
    for _ in 0..400 {
        let mut round = [0.0; 3];
        for (way, time) in round.iter_mut().enumerate() {
            let start = Instant::now();
            black_box(case(way));
            *time = start.elapsed().as_nanos() as f64;
            least[way] = least[way].min(*time);
        }
        ratios.push(round[2] / round[0]);
    }
    (least, median(&mut ratios))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rows = rows();
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let ["repeat", row, way, runs] = arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        if let Some(row) = rows.get(row.parse::<usize>()?) {
            let (mut case, way) = ((row.make)(), way.parse()?);
            (0..runs.parse::<usize>()?).for_each(|_| {
                black_box(case(way));
            });
        }
        return Ok(());
    }
    steps();
    if arguments.iter().any(|argument| argument == "steps") {
        return Ok(());
    }
    let program = std::env::current_exe()?;
    println!(
        "| {STEPS} steps | gradient : plain, time | middle | instructions | : under torques | plain, a body and stage |"
    );
    println!("|---|---:|---:|---:|---:|---:|");
    for (number, row) in rows.iter().enumerate() {
        progress(row.name);
        let counts = [0, 1, 2].map(|way| instructions(&program, number, way).unwrap_or(f64::NAN));
        let (times, middle) = wall(row);
        progress("");
        println!(
            "| {} | {:.2} | {middle:.2} | {:.2} | {:.2} | {:.0} |",
            row.name,
            times[2] / times[0],
            counts[2] / counts[0],
            counts[2] / counts[1],
            counts[0] / row.sweeps as f64
        );
    }
    Ok(())
}
