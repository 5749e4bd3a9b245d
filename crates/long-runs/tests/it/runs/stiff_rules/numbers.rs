//! Implicit steps with every kind of number. Derivative parts are compared by themselves: `==` and `near` see only the value of
//! a dual number.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::simulate::Method;
use catena::time::Sdirk4;
use catena::{Error, Real, Scalar};
use catena_oracle::near;
use nalgebra::{Const, U1};
use num_dual::{Dual64, DualSVec64, HyperDual64};
use simba::simd::WideF64x4;

/// Stiffness, damping and rest angle of the first hinge, stiffness of the second.
const NAMES: [&str; 4] = ["stiffness", "damping", "rest angle", "second stiffness"];
const AT: [f64; 4] = [60.0, 0.4, 0.3, 25.0];
const READINGS: [&str; 4] = ["first angle", "last angle", "root force x", "root force y"];

type Chain<T> = (Rod<T>, ElasticHinge<Spring<T, T, T>>, Rod<T>, ElasticHinge<Spring<T>>, Rod<T>);
type Scene<T> = System<T, Pinned<[T; 2]>, Chain<T>, Free>;

/// A few steps of 10 ms by a method.
fn run<T: Scalar, M>([stiffness, damping, rest, second]: [T; 4], method: M, steps: f64) -> Result<[T; 4], Error>
where
    M: for<'s> Method<&'s Scene<T>, Unloaded>,
{
    let number = T::literal;
    let rod = |length| Rod::uniform(number(length), number(0.8));
    let hinge = ElasticHinge::rotary(stiffness).damped(damping).resting_at(rest);
    let chain = (rod(0.5), hinge, rod(0.7), ElasticHinge::rotary(second), rod(0.4));
    let system: Scene<T> = System::new(Pinned::origin(), chain, Free)?.with_gravity(number(9.81));
    let start = system.with_rates(system.at_rest(&[-0.4, -0.1, -0.3].map(number))?, &[1.0, -0.5, 0.7].map(number))?;
    let of = <T::Real as Real>::of;
    let rule = catena::time::Rule { method, control: catena::time::Control::Fixed(of(0.01)) };
    let motion = system.simulate(start, rule, of(0.01 * steps), |_| ())?.motion;
    let force = system.stations(&motion, &Unloaded).unwrap().root().internal.force;
    let angles = system.angles(&motion).unwrap();
    let angle = |k| angles.get(k).copied().unwrap_or(T::zero());
    Ok([angle(0), angle(2), force.x, force.y])
}

fn seeded<T: Scalar>(seed: impl Fn(usize, T) -> T) -> [T; 4] {
    core::array::from_fn(|i| seed(i, T::literal(AT[i])))
}

fn derivative<M>(method: M, i: usize, steps: f64) -> Result<[f64; 4], Error>
where
    M: for<'s> Method<&'s Scene<Dual64>, Unloaded>,
{
    let parameters = seeded(|k, x: Dual64| if k == i { x.derivative() } else { x });
    Ok(run(parameters, method, steps)?.map(|x| x.eps))
}

/// Central differences of fourth order: h⁴ = 1e-12 times fifth derivatives, and rounding of 1e-15/h = 1e-12 times readings.
fn difference<M>(method: M, i: usize, steps: f64) -> Result<[f64; 4], Error>
where
    M: for<'s> Method<&'s Scene<f64>, Unloaded> + Copy,
{
    let h = 1e-3 * AT[i];
    let at = |by: f64| run(core::array::from_fn(|k| AT[k] + if k == i { by } else { 0.0 }), method, steps);
    let [b, a, c, d] = [at(-2.0 * h)?, at(-h)?, at(h)?, at(2.0 * h)?];
    Ok(core::array::from_fn(|k| (8.0 * (c[k] - a[k]) - (d[k] - b[k])) / (12.0 * h)))
}

/// Does the same with all methods.
macro_rules! with_every_method {
    (|$method:ident| $what:expr) => {{
        {
            let $method = GeneralizedAlpha::new(0.8);
            $what
        }
        {
            let $method = GeneralizedAlpha::trapezoidal().with_sweeps(3);
            $what
        }
        {
            let $method = Sdirk4::new();
            $what
        }
    }};
}

#[test]
fn derivatives_through_implicit_steps_are_those_of_differences() -> Result<(), Error> {
    with_every_method!(|method| {
        let mut worst = 0.0_f64;
        for (i, name) in NAMES.into_iter().enumerate() {
            let (found, expected) = (derivative(method, i, 50.0)?, difference(method, i, 50.0)?);
            println!("{method:?} by {name}: {found:.3?}");
            for k in 0..4 {
                let error = (found[k] - expected[k]).abs() / expected[k].abs().max(1e-3);
                worst = worst.max(error);
                assert!(error < 1e-6, "{} by {name}: {} instead of {}", READINGS[k], found[k], expected[k]);
                assert!(found[k].abs() > 1e-6, "{name} must matter to {}", READINGS[k]);
            }
        }
        println!("largest relative difference {worst:.1e}");
    });
    Ok(())
}

#[test]
fn every_number_makes_implicit_steps() -> Result<(), Error> {
    with_every_method!(|method| {
        let plain = run(AT, method, 3.0)?;
        let single = run(AT.map(|x| x as f32), method, 3.0)?;
        let dual = run(seeded(|k, x: Dual64| if k == 0 { x.derivative() } else { x }), method, 3.0)?;
        let gradient = run(seeded(|k, x: DualSVec64<4>| x.derivative(k)), method, 3.0)?;
        let second = |k: usize, x: HyperDual64| match k {
            0 => x.derivative1(),
            1 => x.derivative2(),
            _ => x,
        };
        let hyper = run(seeded(second), method, 3.0)?;
        let lanes: [WideF64x4; 4] =
            core::array::from_fn(|i| WideF64x4::from(core::array::from_fn(|lane| AT[i] * (1.0 + 0.1 * lane as f64))));
        let lanes = run(lanes, method, 3.0)?;
        let firsts: [[f64; 4]; 4] = [0, 1, 2, 3].map(|i| derivative(method, i, 3.0).unwrap_or([f64::NAN; 4]));
        for k in 0..4 {
            let size = plain[k].abs().max(1.0);
            near(f64::from(single[k]), plain[k], 1e-4 * size); // stiff springs times 6e-8
            for value in [dual[k].re, gradient[k].re, hyper[k].re, lanes[k].into_arr()[0]] {
                near(value, plain[k], 1e-12 * size);
            }
            let gradient = gradient[k].eps.unwrap_generic(Const::<4>, U1);
            for (i, first) in firsts.iter().enumerate() {
                near(gradient[i], first[k], 1e-11 * first[k].abs().max(1e-3));
            }
            near(dual[k].eps, firsts[0][k], 1e-11 * firsts[0][k].abs().max(1e-3));
            near(hyper[k].eps1, firsts[0][k], 1e-11 * firsts[0][k].abs().max(1e-3));
            near(hyper[k].eps2, firsts[1][k], 1e-11 * firsts[1][k].abs().max(1e-3));
            // The mixed derivative, by differences of the first one.
            let by_damping = |by: f64| {
                let at = [AT[0], AT[1] + by, AT[2], AT[3]].map(Dual64::literal);
                run([at[0].derivative(), at[1], at[2], at[3]], method, 3.0).map(|x| x[k].eps)
            };
            let mixed = (by_damping(1e-4)? - by_damping(-1e-4)?) / 2e-4;
            near(hyper[k].eps1eps2, mixed, 1e-6 * mixed.abs().max(1e-2));
        }
        for lane in 0..4 {
            let alone = run(AT.map(|x| x * (1.0 + 0.1 * lane as f64)), method, 3.0)?;
            for k in 0..4 {
                near(lanes[k].into_arr()[lane], alone[k], 1e-13 * alone[k].abs().max(1.0));
            }
        }
    });
    Ok(())
}
