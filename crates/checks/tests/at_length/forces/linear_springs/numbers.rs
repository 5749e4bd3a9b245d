//! Linear springs, a slider and a guided tip with every kind of number. Derivative parts are compared by themselves: `==` and
//! `near` see only the value of a dual number.

use catena::loading::Unloaded;
use catena::planar::Absent;
use catena::planar::*;
use catena::simulate::Method;
use catena::time::{Control, Rule, Sdirk4};
use catena::{Error, Real, Scalar};
use catena_oracle::near;
use nalgebra::{Const, U1};
use num_dual::{Dual64, DualSVec64, HyperDual64};
use simba::simd::WideF64x4;

/// Springs along x and y of the hinge, and along the line of the slider.
const NAMES: [&str; 9] = [
    "stiffness x",
    "damping x",
    "rest value x",
    "stiffness y",
    "damping y",
    "rest value y",
    "stiffness of the slider",
    "damping of the slider",
    "rest value of the slider",
];
const AT: [f64; 9] = [300.0, 1.2, 0.1, 150.0, 0.7, -0.05, 80.0, 0.9, 0.2];
const READINGS: [&str; 4] = ["place of the tip", "root force x", "root force y", "force across the line"];
/// Absolute angles (rad) of the bodies that turn.
const ANGLES: [f64; 4] = [-0.4, 0.3, -0.9, 0.8];

type Full<T> = Spring<T, T, T>;
type Chain<T> = (
    Rod<T>,
    ElasticHinge<Absent, Linear<T, Full<T>, Full<T>>>,
    Rod<T>,
    Slider<T, Full<T>>,
    RigidBody<T>,
    Pin,
    Rod<T>,
    Pin,
    Rod<T>,
);
type Scene<T> = System<T, Pinned<[T; 2]>, Chain<T>, Guided<[T; 2], T, T>>;

fn chain<T: Scalar>(p: [T; 9]) -> Chain<T> {
    let number = T::literal;
    let rod = |length| Rod::uniform(number(length), number(0.8));
    let plate = RigidBody::new(number(0.9), number(0.05), [0.3, 0.1].map(number), [0.7, -0.2].map(number));
    let spring = |i: usize| Spring::new(p[i]).damped(p[i + 1]).resting_at(p[i + 2]);
    let slider = Slider::along(number(0.6)).with(spring(6));
    (rod(0.5), ElasticHinge::linear(spring(0), spring(3)), rod(0.7), slider, plate, Pin, rod(0.6), Pin, rod(0.4))
}

/// The line of the tip goes through where the chain ends at first.
fn guide() -> Result<[f64; 3], Error> {
    let free = System::new(Pinned::origin(), chain(AT), Free)?;
    let frame = free.stations(&free.at_rest(&ANGLES)?, &Unloaded)?.tip().frame;
    Ok([frame.place.x, frame.place.y, frame.turn.angle])
}

/// A few steps of 5 ms by a method.
fn run<T: Scalar, M>(parameters: [T; 9], method: M, steps: f64) -> Result<[T; 4], Error>
where
    M: for<'s> Method<&'s Scene<T>, Unloaded>,
{
    let number = T::literal;
    let [x, y, angle] = guide()?.map(number);
    let tip = Guided::on(Clamped::at(x, y, angle), number(0.5));
    let scene: Scene<T> = System::new(Pinned::origin(), chain(parameters), tip)?.with_gravity(number(9.81));
    let of = <T::Real as Real>::of;
    let rule = Rule { method, control: Control::Fixed(of(0.005)) };
    let motion = scene.simulate(scene.at_rest(&ANGLES.map(number))?, rule, of(0.005 * steps), |_| ())?.motion;
    let stations = scene.stations(&motion, &Unloaded).unwrap();
    let force = stations.root().internal.force;
    Ok([stations.tip().frame.place.x, force.x, force.y, motion.multipliers()[0]])
}

fn seeded<T: Scalar>(seed: impl Fn(usize, T) -> T) -> [T; 9] {
    core::array::from_fn(|i| seed(i, T::literal(AT[i])))
}

fn derivative<M>(method: M, i: usize, steps: f64) -> Result<[f64; 4], Error>
where
    M: for<'s> Method<&'s Scene<Dual64>, Unloaded>,
{
    let parameters = seeded(|k, x: Dual64| if k == i { x.derivative() } else { x });
    Ok(run(parameters, method, steps)?.map(|x| x.eps))
}

/// Central differences of fourth order: h⁴ = 1e-12 times fifth derivatives, and rounding of 1e-14/h = 1e-11 times readings.
fn difference<M>(method: M, i: usize, steps: f64) -> Result<[f64; 4], Error>
where
    M: for<'s> Method<&'s Scene<f64>, Unloaded> + Copy,
{
    let h = 1e-3 * AT[i];
    let at = |by: f64| run(core::array::from_fn(|k| AT[k] + if k == i { by } else { 0.0 }), method, steps);
    let [b, a, c, d] = [at(-2.0 * h)?, at(-h)?, at(h)?, at(2.0 * h)?];
    Ok(core::array::from_fn(|k| (8.0 * (c[k] - a[k]) - (d[k] - b[k])) / (12.0 * h)))
}

fn derivatives_are_those_of_differences<M>(name: &str, method: M) -> Result<(), Error>
where
    M: for<'s> Method<&'s Scene<f64>, Unloaded> + for<'s> Method<&'s Scene<Dual64>, Unloaded> + Copy,
{
    let mut worst = 0.0_f64;
    for (i, parameter) in NAMES.into_iter().enumerate() {
        let (found, expected) = (derivative(method, i, 40.0)?, difference(method, i, 40.0)?);
        for k in 0..4 {
            // As changes of readings (m, N) for a change of the parameter by its own size.
            let [found, expected] = [found[k], expected[k]].map(|x| x * AT[i]);
            let error = (found - expected).abs() / expected.abs().max(1e-3);
            worst = worst.max(error);
            assert!(error < 1e-6, "{} by {parameter}: {found} instead of {expected}", READINGS[k]);
            assert!(found.abs() > 1e-6, "{parameter} must matter to {}", READINGS[k]);
        }
    }
    println!("{name}: largest relative difference {worst:.1e}");
    Ok(())
}

#[test]
fn derivatives_by_every_spring_parameter_are_those_of_differences() -> Result<(), Error> {
    derivatives_are_those_of_differences("generalised-alpha", GeneralizedAlpha::new(0.8))?;
    derivatives_are_those_of_differences("trapezoidal, 3 sweeps", GeneralizedAlpha::trapezoidal().with_sweeps(3))?;
    derivatives_are_those_of_differences("SDIRK4", Sdirk4::new())?;
    derivatives_are_those_of_differences("RK4", Rk4)
}

fn every_number<M>(method: M) -> Result<(), Error>
where
    M: for<'s> Method<&'s Scene<f32>, Unloaded> + for<'s> Method<&'s Scene<f64>, Unloaded>,
    M: for<'s> Method<&'s Scene<Dual64>, Unloaded> + for<'s> Method<&'s Scene<DualSVec64<4>>, Unloaded>,
    M: for<'s> Method<&'s Scene<HyperDual64>, Unloaded> + for<'s> Method<&'s Scene<WideF64x4>, Unloaded> + Copy,
{
    let steps = 4.0;
    let plain: [f64; 4] = run(AT, method, steps)?;
    let single: [f32; 4] = run(AT.map(|x| x as f32), method, steps)?;
    let gradient = run(seeded(|k, x: DualSVec64<4>| if k < 4 { x.derivative(k) } else { x }), method, steps)?;
    let second = |k: usize, x: HyperDual64| match k {
        0 => x.derivative1(),
        1 => x.derivative2(),
        _ => x,
    };
    let hyper = run(seeded(second), method, steps)?;
    let scaled = |i: usize, lane: usize| AT[i] * (1.0 + 0.1 * lane as f64);
    let lanes: [WideF64x4; 9] = core::array::from_fn(|i| WideF64x4::from(core::array::from_fn(|lane| scaled(i, lane))));
    let lanes = run(lanes, method, steps)?;
    let mut firsts = vec![];
    for i in 0..4 {
        firsts.push(derivative(method, i, steps)?);
    }
    let by_damping = |by: f64| {
        let seed = |k: usize, x: Dual64| match k {
            0 => x.derivative(),
            1 => x + by,
            _ => x,
        };
        run(seeded(seed), method, steps).map(|x| x.map(|x| x.eps))
    };
    let (above, below) = (by_damping(1e-4)?, by_damping(-1e-4)?);
    for k in 0..4 {
        let size = plain[k].abs().max(1.0);
        near(f64::from(single[k]), plain[k], 1e-4 * size); // stiff springs times 6e-8
        for value in [gradient[k].re, hyper[k].re, lanes[k].into_arr()[0]] {
            near(value, plain[k], 1e-12 * size);
        }
        let gradient = gradient[k].eps.unwrap_generic(Const::<4>, U1);
        let like = |found: f64, i: usize| near(found, firsts[i][k], 1e-10 * firsts[i][k].abs().max(1e-2));
        (0..4).for_each(|i| like(gradient[i], i));
        like(hyper[k].eps1, 0);
        like(hyper[k].eps2, 1);
        // The mixed derivative, by differences of the first one.
        let mixed = (above[k] - below[k]) / 2e-4;
        near(hyper[k].eps1eps2, mixed, 1e-6 * mixed.abs().max(1e-2));
    }
    for lane in 0..4 {
        let alone: [f64; 4] = run(core::array::from_fn(|i| scaled(i, lane)), method, steps)?;
        for k in 0..4 {
            near(lanes[k].into_arr()[lane], alone[k], 1e-12 * alone[k].abs().max(1.0));
        }
    }
    Ok(())
}

#[test]
fn every_number_slides_along_springs_and_lines() -> Result<(), Error> {
    every_number(GeneralizedAlpha::new(0.8))?;
    every_number(Sdirk4::new())?;
    every_number(Rk4)
}
