//! Gradients of chains and trees of rods and bodies on pins; what lists must be.

use super::names::*;
use catena::sensitivity::Costate;
use catena::{Error, Fault};

/// Numbers of a chain of rods: lengths, masses, centres, inertias, gravity, angles, rates, torques.
fn rods(n: usize, steps: usize, quiet: bool) -> Vec<f64> {
    let mut noise = Noise::new(n as u64);
    let mut list = vec![];
    list.extend((0..n).map(|_| noise.between(0.5, 1.5)));
    list.extend((0..n).map(|_| noise.between(0.5, 1.5)));
    (0..n).for_each(|i| list.push(list[i] * 0.4));
    list.extend((0..n).map(|_| noise.between(0.05, 0.1)));
    list.push(9.81);
    list.extend((0..n).map(|_| if quiet { -0.5 * core::f64::consts::PI } else { noise.between(-1.5, 0.5) }));
    list.extend((0..n).map(|_| if quiet { 0.0 } else { noise.between(-1.0, 1.0) }));
    list.extend((0..n * steps).map(|_| if quiet { 0.0 } else { noise.between(-0.5, 0.5) }));
    list
}

macro_rules! chain_of_rods {
    ($n:expr, $method:expr, $steps:expr, $h:expr) => {{
        let (n, steps) = ($n, $steps);
        let kinds = [
            ("lengths", n),
            ("masses", n),
            ("centres", n),
            ("inertias", n),
            ("gravity", 1),
            ("angles", n),
            ("rates", n),
            ("torques", n * steps),
        ];
        gradients!(
            &format!("{n} rods, {:?}", $method),
            &kinds,
            rods(n, steps, false),
            [n, n],
            $method,
            steps,
            $h,
            |x| {
                let rod = |i: usize| Rod::<N>::new(x(i), x(n + i), x(2 * n + i), x(3 * n + i));
                let links: Vec<(Pin, Rod<N>)> = (1..n).map(|i| (Pin, rod(i))).collect();
                System::new(Pinned::origin(), (rod(0), links), Free).unwrap().with_gravity(x(4 * n))
            }
        )
    }};
}

#[test]
fn chains_of_rods_have_the_gradients_of_jets() {
    chain_of_rods!(2, Rk4, 25, 0.02);
    chain_of_rods!(5, Rk4, 10, 0.02);
    chain_of_rods!(20, Rk4, 4, 0.01);
    chain_of_rods!(2, Dop853, 6, 0.06);
    chain_of_rods!(5, Dop853, 3, 0.05);
}

/// Bodies with first moments, point masses, welds with angles, arms at a station and arms on arms, a clamped root that is turned.
#[test]
fn trees_have_the_gradients_of_jets() {
    let (steps, angles, joints) = (8, 6, 9);
    let mut noise = Noise::new(14);
    let mut list: Vec<f64> = (0..3).flat_map(|_| [1.3, 0.2, 0.4, 0.1, 0.8, -0.2]).collect(); // three rigid bodies
    list.iter_mut().for_each(|x| *x *= 1.0 + 0.1 * noise.next());
    list.extend([0.7, 1.1, 0.3, 0.08, 0.9, 0.6]); // a rod, a bob
    list.extend([0.3, -0.2, 0.1]); // two welds, the root
    list.push(9.81);
    let parameters = list.len();
    list.extend((0..angles).map(|_| noise.between(-1.5, 0.5)));
    list.extend((0..angles).map(|_| noise.next()));
    list.extend((0..steps * joints).map(|_| 0.5 * noise.next()));
    let kinds = [
        ("bodies", 24),
        ("angles of welds", 3),
        ("gravity", 1),
        ("angles", angles),
        ("rates", angles),
        ("torques", steps * joints),
    ];
    assert_eq!(parameters, 28);
    gradients!("a tree", &kinds, list, [angles, joints], Rk4, steps, 0.02, |x| {
        let rigid = |i: usize| RigidBody::<N>::new(x(i), x(i + 1), [x(i + 2), x(i + 3)], [x(i + 4), x(i + 5)]);
        let rod = Rod::<N>::new(x(18), x(19), x(20), x(21));
        let bob = PointMass::<N>::new(x(22), x(23));
        let arm = (Pin, rigid(6), Branch((Pin, rod)), Weld::at(x(25)), bob);
        let chain = (
            rigid(0),
            Pin,
            rod,
            Weld::at(x(24)),
            rigid(12),
            Branch(arm),
            Branch([(Pin, rod); 1]),
            Pin,
            bob,
            Pin,
            rigid(0),
        );
        System::new(Clamped::at(N::constant(0.2), N::constant(0.1), x(26)), chain, Free).unwrap().with_gravity(x(27))
    });
}

/// At rest and straight, hanging and without gravity: finite, and right.
#[test]
fn a_straight_chain_at_rest_has_a_gradient() {
    for gravity in [9.81, 0.0] {
        let rod = |_| (Pin, Rod::uniform(1.0_f64, 1.0));
        let chain = (Rod::uniform(1.0_f64, 1.0), (0..3).map(rod).collect::<Vec<_>>());
        let system = System::new(Pinned::origin(), chain, Free).unwrap().with_gravity(gravity);
        let start = system.at_rest(&[-0.5 * core::f64::consts::PI; 4]).unwrap();
        let mut states = vec![start.clone(); 11];
        let mut backward = system.backward(Rk4);
        backward.run(&start, 0.02, 10, &[], &mut states).unwrap();
        let cost = |step: usize, _: &_, by: &mut Costate<_>| {
            if step == 10 { by.add(&[0.0, 0.0, 0.0, 1.0], &[0.0; 4]) } else { Ok(()) }
        };
        let found = backward.gradient(&[], &states, &mut [], cost).unwrap();
        let lifted = system.lift(Jet::<f64, 4>::of);
        let jets = lifted.with_seeds(lifted.at_rest(&[Jet::of(-0.5 * core::f64::consts::PI); 4]).unwrap(), 0);
        let end = lifted.simulation(Rk4::step(0.02)).run(jets, 0.2, |_| ()).unwrap().motion;
        let expected = end.coordinates()[3].eps;
        found.by_position().iter().zip(expected).for_each(|(found, expected)| near(*found, expected, ROUNDING));
        assert!(found.by_rate().iter().all(|x| x.is_finite()) && found.by_gravity().y.is_finite());
    }
}

/// Two uniform rods with torques in both joints, a cost of the tip: the numbers are of a dense system, differentiated by complex steps.
macro_rules! yardstick {
    ($method:expr, $h:expr, $steps:expr, $cost:expr, $numbers:expr) => {{
        let (h, steps): (f64, usize) = ($h, $steps);
        let rod = Rod::uniform(1.0_f64, 1.0);
        let system = System::new(Pinned::origin(), (rod, Pin, rod), Free).unwrap().with_gravity(9.81);
        let start = system.at_rest(&[-1.0, -0.5]).unwrap();
        let torques: Vec<f64> =
            (0..steps).flat_map(|k| [0.3 * (0.1 * k as f64).sin(), -0.2 * (0.1 * k as f64).cos()]).collect();
        let mut states = vec![start; steps + 1];
        let mut by_torques = vec![0.0; 2 * steps];
        let mut backward = system.backward($method);
        backward.run(&start, h, steps, &torques, &mut states).unwrap();
        let q: [f64; 2] = states[steps].coordinates().try_into().unwrap();
        let miss = [q[0].cos() + q[1].cos() - 0.4, q[0].sin() + q[1].sin() + 0.7];
        let end = |step: usize, _: &_, by: &mut Costate<_>| match step {
            k if k < steps => Ok(()),
            _ => by.add(&q.map(|q| 2.0 * (miss[1] * q.cos() - miss[0] * q.sin())), &[0.0; 2]),
        };
        let gradient = backward.gradient(&torques, &states, &mut by_torques, end).unwrap();
        let effort = 0.025 * h * torques.iter().map(|u| u * u).sum::<f64>();
        near(miss[0] * miss[0] + miss[1] * miss[1] + effort, $cost, 1e-12);
        // Lengths, of which the cost itself reads the tip, and masses.
        let of = |x: f64, k: usize| Jet::<f64, 4>::seed(x, k);
        let [first, second] = [0, 1].map(|i| Rod::uniform(of(1.0, i), of(1.0, 2 + i)));
        let seeded = System::new(Pinned::origin(), (first, Pin, second), Free).unwrap().with_gravity(Jet::of(9.81));
        let by = gradient.along(&seeded).unwrap();
        let of_tip = q.map(|q| 2.0 * (miss[0] * q.cos() + miss[1] * q.sin()));
        let [by_first, by_half] = [0, steps / 2]
            .map(|k| [0, 1].map(|i| 2 * k + i))
            .map(|places| places.map(|place| by_torques[place] + 0.05 * h * torques[place]));
        let mut found = vec![by[0] + of_tip[0], by[1] + of_tip[1], by[2], by[3], -gradient.by_gravity().y];
        found.extend(gradient.by_position().into_iter().chain(gradient.by_rate()).chain(by_first).chain(by_half));
        let expected: [f64; 13] = $numbers;
        found.iter().zip(expected).for_each(|(found, expected)| near(*found, expected, 2e-12));
    }};
}

#[test]
fn yardstick() {
    // Lengths (masses held), masses, gravity, angles, rates, torques of the first step and of that in the middle.
    yardstick!(
        Rk4,
        0.01,
        100,
        3.3385302285409,
        [
            2.0588091449144,
            2.8744716760431,
            0.0877470237123,
            -0.1239878480174,
            0.1695725944126,
            1.7838074488877,
            0.4237652625968,
            -0.3158755958008,
            -0.2685975292274,
            0.0004173649125,
            -0.0091869796423,
            -0.0054226313817,
            0.0033965026247,
        ]
    );
    yardstick!(
        Dop853,
        0.05,
        20,
        3.2516923331141,
        [
            1.9910285040875,
            2.7881245079814,
            0.0427648487492,
            0.000491581652,
            0.1944274539793,
            1.9856603043112,
            0.3133128067504,
            -0.2732404447306,
            -0.3032228799833,
            0.0056422726519,
            -0.060022431497,
            -0.0277705352333,
            0.0233027034237,
        ]
    );
}

/// A slice that is too short says how many states are needed.
#[test]
fn lists_have_the_length_they_need() {
    let rod = Rod::uniform(1.0_f64, 1.0);
    let system = System::new(Pinned::origin(), (rod, Pin, rod), Free).unwrap();
    let start = system.at_rest(&[-1.0, -0.5]).unwrap();
    let mut backward = system.backward(Rk4);
    let fault = |result: Result<(), Error>| result.unwrap_err().fault;
    let found = fault(backward.run(&start, 0.01, 10, &[], &mut [start; 10]));
    assert!(matches!(found, Fault::Count { expected: 11, given: 10, .. }), "{found:?}");
    let found = fault(backward.run(&start, 0.01, 10, &[0.0; 19], &mut [start; 11]));
    assert!(matches!(found, Fault::Count { expected: 20, given: 19, .. }), "{found:?}");
    let found = fault(backward.run(&start, f64::NAN, 10, &[], &mut [start; 11]));
    assert!(matches!(found, Fault::NotPositive { parameter: "step size", .. }), "{found:?}");
    let found = fault(backward.gradient(&[], &[start; 3], &mut [0.0; 3], |_, _, _| Ok(())).map(|_| ()));
    assert!(matches!(found, Fault::Count { expected: 4, given: 3, .. }), "{found:?}");
    let found = fault(backward.gradient(&[], &[start; 3], &mut [], |_, _, by| by.add(&[1.0], &[])).map(|_| ()));
    assert!(matches!(found, Fault::Count { expected: 2, given: 1, .. }), "{found:?}");
}

/// Room that has served under torques serves without them as if it were new.
#[test]
fn torques_of_an_earlier_run_are_forgotten() {
    let rod = Rod::uniform(1.0_f64, 1.0);
    let system = System::new(Pinned::origin(), (rod, Pin, rod), Free).unwrap().with_gravity(9.81);
    let start = system.at_rest(&[-1.0, -0.5]).unwrap();
    let mut states = [start; 11];
    let cost =
        |step: usize, _: &_, by: &mut Costate<_>| if step == 10 { by.add(&[0.0, 1.0], &[0.5, 0.0]) } else { Ok(()) };
    let mut backward = system.backward(Rk4);
    let mut gradient = |under: &[f64], wanted: usize| {
        let mut by_torques = [0.0; 20];
        backward.run(&start, 0.05, 10, under, &mut states).unwrap();
        let found = backward.gradient(under, &states, &mut by_torques[..wanted], cost).unwrap();
        (states[10].coordinates(), found.by_position(), found.by_rate(), found.by_gravity().y, by_torques)
    };
    let fresh = gradient(&[], 20);
    let driven = gradient(&[3.0; 20], 0);
    assert!(driven.0 != fresh.0 && driven.1 != fresh.1);
    assert!(gradient(&[], 20) == fresh);
}
