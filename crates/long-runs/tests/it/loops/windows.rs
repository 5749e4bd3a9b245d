//! Motions through places where closures become dependent: a ladder of windows, all of whose bars come to lie on one line.

use catena::Error;
use catena::planar::*;
use catena::simulate::Method;
use catena::system::Element;
use catena::system::{MotionOf, Runs};
use catena::time::Rule;
use catena_oracle::Noise;
use core::f64::consts::FRAC_PI_2;

/// A crank that begins at the ground.
type Crank = (RigidBody<f64>, Pin, Rod<f64>);
/// One, two and three windows, closed by joints of a type.
type One<K> = Network<(Pin, Rod<f64>, Pin, Rod<f64>), Crank, K>;
type Two<K> = Network<(One<K>, Pin, Rod<f64>), Crank, K>;
type Three<K> = Network<(Two<K>, Pin, Rod<f64>), Crank, K>;

type Ground = Clamped<[f64; 2], f64>;
type Scene<C> = System<f64, Ground, C, Free>;

fn rod() -> Rod<f64> {
    Rod::uniform(1.0, 1.0)
}

fn crank(k: f64) -> Crank {
    (RigidBody::massless([k, 0.0]), Pin, rod())
}

fn one<K>(closing: K) -> One<K> {
    Network::new((Pin, rod(), Pin, rod()), crank(1.0), closing)
}

fn two<K: Copy>(closing: K) -> Two<K> {
    Network::new((one(closing), Pin, rod()), crank(2.0), closing)
}

fn three<K: Copy>(closing: K) -> Three<K> {
    Network::new((two(closing), Pin, rod()), crank(3.0), closing)
}

/// Angle and rate of the cranks of so many windows at a time, by the equation of the one freedom there is:
/// ((N+1)/3 + N) φ'' = −9.81 ((N+1)/2 + N) cos φ. The classical rule in steps of 0.1 ms.
fn alone(windows: usize, rate: f64, end: f64) -> [f64; 2] {
    let n = windows as f64;
    let fall = -9.81 * ((n + 1.0) / 2.0 + n) / ((n + 1.0) / 3.0 + n);
    let slope = |[angle, rate]: [f64; 2]| [rate, fall * angle.cos()];
    let plus = |y: [f64; 2], h: f64, k: [f64; 2]| [y[0] + h * k[0], y[1] + h * k[1]];
    let steps = (end * 1e4).round() as usize;
    let h = end / steps as f64;
    (0..steps).fold([FRAC_PI_2, rate], |y, _| {
        let k = slope(y);
        let l = slope(plus(y, 0.5 * h, k));
        let m = slope(plus(y, 0.5 * h, l));
        let n = slope(plus(y, h, m));
        core::array::from_fn(|i| y[i] + h / 6.0 * (k[i] + 2.0 * (l[i] + m[i]) + n[i]))
    })
}

/// Upright, with cranks that fall.
fn start<C: Element<Planar<f64>>>(
    scene: &Scene<C>,
    windows: usize,
    rate: f64,
) -> Result<MotionOf<Planar<f64>, Ground, C, Free>, Error> {
    // The first crank and coupler; the other couplers, from inside out; the other cranks, each after its loop's main arm.
    let mut angles = vec![FRAC_PI_2, 0.0, FRAC_PI_2];
    (1..windows).for_each(|_| angles.extend([0.0, FRAC_PI_2]));
    let rates: Vec<f64> = angles.iter().map(|angle| if *angle == 0.0 { 0.0 } else { rate }).collect();
    scene.with_rates(scene.at_rest(&angles)?, &rates)
}

/// Runs for two seconds, through the singular place several times: trial steps, and how far the first crank is from the truth.
fn run<C, M>(chain: C, (windows, rate): (usize, f64), rule: Rule<M, f64>) -> Result<(usize, [f64; 2]), Error>
where
    C: Element<Planar<f64>>,
    M: for<'s> Method<&'s Scene<C>, catena::loading::Unloaded>,
    Scene<C>: Runs<catena::loading::Unloaded, Planar<f64>, Ground, C, Free>,
{
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Free)?.with_gravity(9.81);
    let run = scene.simulate(start(&scene, windows, rate)?, rule, 2.0, |_| ())?;
    let [angle, spin] = alone(windows, rate, 2.0);
    let mut first = (None, None);
    catena::system::Position::visit(run.motion.position(), &mut |x: f64| first.0 = first.0.or(Some(x)));
    catena::system::Rate::visit(run.motion.rate(), &mut |x: f64| first.1 = first.1.or(Some(x)));
    let (found, turning) = (first.0.unwrap_or(f64::NAN), first.1.unwrap_or(f64::NAN));
    Ok((run.steps + run.rejected, [(found - angle).abs(), (turning - spin).abs()]))
}

/// What rounding leaves open of a position where closures are dependent (rad): its root.
const ROOT: f64 = 1.5e-8;
macro_rules! through {
    ($([$windows:literal, $chain:expr, $rule:expr, $most:expr]),* $(,)?) => {{
        let mut missed = vec![];
        $(
            let name = concat!(stringify!($chain), " ", stringify!($rule));
            match run($chain, ($windows, -1.0), $rule) {
                Ok((trials, [angle, rate])) => {
                    println!("{name}: {trials} trial steps, errors {angle:.1e} {rate:.1e}");
                    if !(angle <= $most && rate <= 10.0 * $most && trials < 1000 * 2) {
                        missed.push(name);
                    }
                }
                Err(error) => {
                    println!("{name}: {error}");
                    missed.push(name);
                }
            }
        )*
        assert!(missed.is_empty(), "{missed:?}");
    }};
}

#[test]
fn ladders_pass_through_the_line() {
    through!(
        [1, one(Pin), Dop853::tolerance(1e-12), ROOT],
        [2, two(Pin), Dop853::tolerance(1e-12), ROOT],
        [3, three(Pin), Dop853::tolerance(1e-12), ROOT],
        [1, one(Pin), Dop853::tolerance(1e-9), 1e-7],
        [2, two(Pin), Dop853::tolerance(1e-9), 1e-7],
        [3, three(Pin), Dop853::tolerance(1e-9), 1e-7],
        [1, one(Pin), Dopri5::tolerance(1e-9), 1e-7],
        [2, two(Pin), Dopri5::tolerance(1e-9), 1e-7],
        [3, three(Pin), Dopri5::tolerance(1e-9), 1e-7],
        [2, two(Pin), Dopri5::tolerance(1e-6), 1e-4],
        [2, two(Pin), Adams::tolerance(1e-9), 1e-7],
        [1, one(Pin), Sdirk4::new().tolerance(1e-8), 1e-6],
        [2, two(Pin), Sdirk4::new().tolerance(1e-8), 1e-6],
        [3, three(Pin), Sdirk4::new().tolerance(1e-8), 1e-6],
        [2, two(Pin), Sdirk4::new().tolerance(1e-5), 1e-3],
        [1, one(LeastNorm(Pin)), Dop853::tolerance(1e-12), ROOT],
        [2, two(LeastNorm(Pin)), Dop853::tolerance(1e-12), ROOT],
        [3, three(LeastNorm(Pin)), Dop853::tolerance(1e-12), ROOT],
        [2, two(LeastNorm(Pin)), Dopri5::tolerance(1e-9), 1e-7],
    );
}

/// Windows with forty rates at the start (rad/s), and more at random, so that steps and stages fall anywhere about the line: none ends there,
/// and none goes another way.
#[test]
fn ladders_pass_from_anywhere() -> Result<(), Error> {
    let mut noise = Noise::new(7);
    let mut rates: Vec<f64> = (0..40).map(|k| -1.0 - 0.013 * f64::from(k)).collect();
    rates.extend((0..200).map(|_| -noise.between(0.2, 3.0)));
    let mut good = true;
    macro_rules! passed {
        ($windows:literal, $chain:expr, $rule:expr, $most:expr, $starts:expr) => {{
            let name = concat!(stringify!($chain), " ", stringify!($rule));
            let (mut worst, mut trials, mut stuck) = (0.0_f64, 0, 0);
            for rate in &rates[..$starts] {
                match run($chain, ($windows, *rate), $rule) {
                    Ok((steps, [angle, rate])) => {
                        worst = worst.max(angle.max(0.1 * rate));
                        trials = trials.max(steps);
                    }
                    Err(error) => {
                        println!("{name}, {rate}: {error}");
                        stuck += 1;
                    }
                }
            }
            println!("{name}: worst {worst:.1e}, at most {trials} trial steps, {stuck} of {} stuck", $starts);
            good &= worst <= $most && trials < 3000 && stuck == 0;
        }};
    }
    // A step of a fine tolerance must not end near the line: accelerations there are rounding.
    passed!(2, two(Pin), Dop853::tolerance(1e-12), ROOT, 240);
    passed!(2, two(Pin), Dop853::tolerance(1e-9), 1e-6, 240);
    passed!(3, three(Pin), Dop853::tolerance(1e-12), ROOT, 240);
    passed!(2, two(Pin), Dopri5::tolerance(1e-9), 1e-6, 40);
    // So must not what remembers accelerations there.
    passed!(2, two(Pin), Vcabm::new().tolerance(1e-12), ROOT, 240);
    passed!(2, two(Pin), Vcabm::new().tolerance(1e-9), 1e-6, 240);
    passed!(2, two(Pin), Sdirk4::new().tolerance(1e-8), 1e-5, 40);
    passed!(2, two(LeastNorm(Pin)), Dop853::tolerance(1e-12), ROOT, 40);
    passed!(2, two(LeastNorm(Pin)), Sdirk4::new().tolerance(1e-8), 1e-5, 40);
    assert!(good);
    Ok(())
}
