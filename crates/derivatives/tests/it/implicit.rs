//! Gradients of runs by an implicit rule, backward: against jets through the same steps, central differences, and numbers of a dense system.

use super::held::share;
use crate::drag::Drag;
use catena::Scalar;
use catena::planar::*;
use catena::scalar::Jet;
use catena::sensitivity::Costate;

/// Rods and rigid bodies on pins, hinges, a slider, a weld and an arm, from stiff to hardly sprung.
#[test]
fn chains() {
    let kinds = [("bodies", 10), ("springs", 8), ("angles", 2), ("gravity", 1)];
    let parameters = |k: f64| {
        let mut numbers = vec![0.4, 0.5, 0.15, 0.01, 0.7, 0.03, 0.12, 0.02, 0.35, -0.05];
        numbers.extend([k, 0.01 * k, 0.2, 0.1 * k, 3.0 * k, 0.02 * k, 0.05, 0.3]);
        numbers.extend([0.4, 0.7, 9.81]);
        numbers
    };
    macro_rules! of {
        ($name:expr, $method:expr, $stiffness:literal) => {
            let (numbers, angles) = (parameters($stiffness), vec![-0.3, 0.1, -0.8, 0.2, -0.2, 0.1]);
            gradients!($name, kinds, numbers, angles, 7, $method, 4, 0.02, |x| {
                let rod = Rod::<N>::new(x(0), x(1), x(2), x(3));
                let rigid = RigidBody::<N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
                let hinge = ElasticHinge::rotary(x(10)).damped(x(11)).resting_at(x(12));
                let stiff = ElasticHinge::rotary(x(13)).damped(x(17));
                let slider = Slider::along(x(18)).with(Spring::new(x(14)).damped(x(15)).resting_at(x(16)));
                let chain = (
                    rod,
                    hinge,
                    rigid,
                    Branch((Pin, rod)),
                    slider,
                    rod,
                    stiff,
                    (rigid, Weld::at(x(19)), rod),
                    Pin,
                    rigid,
                );
                System::new(Pinned::origin(), chain, Free).unwrap().with_gravity(x(20))
            });
        };
    }
    of!("one sweep", Sdirk4::new().with_sweeps(1), 10.0);
    of!("three sweeps, stiff", Sdirk4::new().with_sweeps(3), 1e4);
    of!("generalised-α, one sweep", GeneralizedAlpha::new(0.8).with_sweeps(1), 10.0);
    of!("generalised-α", GeneralizedAlpha::new(0.8), 10.0);
    of!("generalised-α, three sweeps, stiff", GeneralizedAlpha::new(0.3).with_sweeps(3), 1e4);
    of!("Newmark", GeneralizedAlpha::newmark(0.3, 0.6), 10.0);
    of!("trapezoidal rule, stiff", GeneralizedAlpha::trapezoidal(), 1e4);
}

/// Against a dense system, differentiated by complex steps.
#[test]
fn numbers_of_a_dense_system() {
    const STEPS: usize = 20;
    macro_rules! scene {
        ($N:ty, $x:expr) => {{
            let (x, of) = ($x, |x: f64| <$N>::constant(x));
            let hinge = |k: usize| ElasticHinge::rotary(x(k, 100.0)).damped(x(k + 1, 0.1));
            let rod = |k: usize, length: f64, mass: f64| Rod::<$N>::uniform(x(k, length), of(mass));
            let chain = (rod(0, 0.4, 0.5), hinge(3), rod(1, 0.3, 0.3), hinge(5), rod(2, 0.3, 0.3));
            System::new(Pinned::at(of(0.0), of(0.0)), chain, Free).unwrap().with_gravity(of(9.81))
        }};
    }
    let scene = scene!(f64, |_: usize, x: f64| x);
    let start = scene.at_rest(&[-0.3; 3]).unwrap();
    let (mut states, mut backward) = (vec![start; STEPS + 1], scene.backward(Sdirk4::new()));
    backward.run(&start, 0.02, STEPS, &[], &mut states).unwrap();
    let (mut value, mut direct, lengths) = (0.0, [0.0; 3], [0.4, 0.3, 0.3]);
    let gradient = backward
        .gradient(&[], &states, &mut [], |step, state, by| {
            if step < STEPS {
                return Ok(());
            }
            let sums = |list: Vec<f64>| [list[0], list[0] + list[1], list[0] + list[1] + list[2]];
            let (angles, rates) = (sums(state.coordinates()), sums(state.rates()));
            let part = |of: fn(f64) -> f64| angles.iter().zip(lengths).map(|(a, l)| l * of(*a)).sum::<f64>();
            let (x, y) = (part(f64::cos) - 0.4, part(f64::sin) + 0.7);
            value = x * x + y * y + 0.05 * rates.iter().map(|v| v * v).sum::<f64>();
            direct = angles.map(|a| 2.0 * (x * a.cos() + y * a.sin()));
            let slopes: [f64; 3] =
                core::array::from_fn(|i| 2.0 * lengths[i] * (y * angles[i].cos() - x * angles[i].sin()));
            let outboard = |of: [f64; 3]| [of[0] + of[1] + of[2], of[1] + of[2], of[2]];
            by.add(&outboard(slopes), &outboard(rates.map(|v| 0.1 * v)))
        })
        .unwrap();
    let by = gradient.along(&scene!(Jet<f64, 7>, |k, x| Jet::seed(x, k))).unwrap();
    let q = gradient.by_position();
    for (found, expected) in [
        (value, 3.1644445868585),
        (by[0] + direct[0], -6.1011401525986),
        (by[1] + direct[1], -5.3791173973015),
        (by[2] + direct[2], -3.517288873127),
        (by[3], 0.0042528125471),
        (by[4], 0.1379713660333),
        (q[0] - q[1], -0.9092437419827),
        (q[1] - q[2], 2.4033643122605),
        (q[2], 2.0611987285182),
    ] {
        println!("{found} {expected} {:.1e}", (found - expected).abs());
        assert!((found - expected).abs() < 1e-11, "{found} not {expected}");
    }
}

/// Loads are read at the geometry of each sweep; a tape keeps what the last sweep of a stage has found.
macro_rules! under_loads {
    ($method:expr) => {{
        const STEPS: usize = 4;
        let rod = Rod::uniform(0.5, 0.6);
        let chain = (rod, ElasticHinge::rotary(20.0).damped(0.1), rod);
        let scene = System::new(Pinned::origin(), chain, Free).unwrap().with_gravity(9.81);
        let start = scene.at_rest(&[-0.5, -0.2]).unwrap();
        let end = |step: usize, _: &_, by: &mut Costate<_, f64>| {
            if step == STEPS { by.add(&[1.0, 0.5], &[0.2, 0.0]) } else { Ok(()) }
        };
        let (mut backward, mut states) = (scene.backward($method).under(Drag { drag: 0.7 }), vec![start; STEPS + 1]);
        backward.run(&start, 0.03, STEPS, &[], &mut states).unwrap();
        let gradient = backward.gradient(&[], &states, &mut [], end).unwrap();
        let (mut tape, mut last) = (vec![backward.tape(); STEPS], start);
        backward.run_on_tape(&start, 0.03, STEPS, &[], &mut tape, &mut last).unwrap();
        let taped = backward.gradient_on_tape(STEPS, &tape, &last, &mut [], end).unwrap();
        assert_eq!(taped.by_position(), gradient.by_position());
        assert_eq!(taped.by_loads().unwrap(), gradient.by_loads().unwrap());
        let value = |drag: f64| {
            let (mut now, mut next, mut stepper) = (start, start, scene.stepper($method));
            for _ in 0..STEPS {
                stepper.step(&now, &Loads::none().on_bodies_by(Drag { drag }), 0.03, &mut next).unwrap();
                core::mem::swap(&mut now, &mut next);
            }
            now.coordinates()[0] + 0.5 * now.coordinates()[1] + 0.2 * now.rates()[0]
        };
        let slope = (value(0.7001) - value(0.6999)) / 2e-4;
        let found = gradient.by_loads().unwrap()[0];
        assert!((found - slope).abs() < 1e-7 * slope.abs(), "{found} not {slope}");
    }};
}

#[test]
fn under_loads_and_on_a_tape() {
    under_loads!(Sdirk4::new());
    under_loads!(GeneralizedAlpha::new(0.8));
}
