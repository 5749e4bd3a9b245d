//! Mass matrix and inverse dynamics of a robot, against Lagrange's equations of the links that its text has.

mod lagrange;

use catena_urdf::{Base, Frames, Options, Robot, State};
use lagrange::Lagrange;

const ARM: &str = include_str!("../robots/arm7.urdf");
const QUADRUPED: &str = include_str!("../robots/quadruped.urdf");
const HUMANOID: &str = include_str!("../robots/humanoid.urdf");
const CART: &str = include_str!("../robots/cart.urdf");

/// A state like no other, and accelerations.
fn state(robot: &Robot, seed: f64) -> (State, Vec<f64>) {
    let number = |k: usize, of: f64| (1.3 * k as f64 + seed * of).sin();
    let mut state = State::zero(robot);
    let n = robot.bodies().len();
    state.q = (0..n).map(|k| 1.2 * number(k, 1.0)).collect();
    state.rates = (0..n).map(|k| 1.5 * number(k, 2.7)).collect();
    (state, (0..n).map(|k| 2.0 * number(k, 4.1)).collect())
}

fn largest(list: &[f64]) -> f64 {
    list.iter().fold(0.0, |most, x| f64::max(most, x.abs()))
}

fn agrees(text: &str, options: &Options) {
    let robot = options.read(text).expect("a robot");
    let lagrange = Lagrange::of(text);
    assert_eq!(lagrange.joints, robot.bodies().len());
    let (mut mass_off, mut torques_off) = (0.0_f64, 0.0_f64);
    for seed in 1..=5 {
        let (state, accelerations) = state(&robot, f64::from(seed));
        let (mass, expected) = (robot.mass_matrix(&state), lagrange.mass_matrix(&state.q));
        let size = expected.iter().map(|row| largest(row)).fold(0.0, f64::max);
        for (row, expected) in mass.iter().zip(&expected) {
            for (x, expected) in row.iter().zip(expected) {
                mass_off = mass_off.max((x - expected).abs() / size);
            }
        }
        let torques = robot.inverse_dynamics(&state, &accelerations, robot.gravity());
        let expected = lagrange.torques(&state.q, &state.rates, &accelerations, robot.gravity());
        let size = largest(&expected);
        for (x, expected) in torques.iter().zip(&expected) {
            torques_off = torques_off.max((x - expected).abs() / size);
        }
    }
    println!("{}: mass matrix {mass_off:.1e}, torques {torques_off:.1e}", robot.name());
    // Rounding; and what differences of sixth order with a step of 0.02 leave of the second harmonic, 0.04⁶/140 = 3e-11.
    assert!(mass_off < 1e-14 && torques_off < 1e-10, "{mass_off:e} {torques_off:e}");
}

#[test]
fn the_arm_obeys_lagrange() {
    for frames in [Frames::AlongHinges, Frames::Parallel, Frames::AsWritten] {
        agrees(ARM, &Options::new().frames(frames));
    }
}

#[test]
fn the_humanoid_on_a_stand_obeys_lagrange() {
    for frames in [Frames::AlongHinges, Frames::Parallel, Frames::AsWritten] {
        agrees(HUMANOID, &Options::new().frames(frames));
    }
}

#[test]
fn legs_on_a_held_trunk_obey_lagrange() {
    agrees(&QUADRUPED.replace("\"floating\"", "\"fixed\""), &Options::new());
}

#[test]
fn a_cart_that_slides_twice_and_turns_obeys_lagrange() {
    // A planar joint is two slides and a hinge: written out for the oracle.
    let planar = CART.find("  <joint name=\"drive\"").expect("the drive");
    let end = planar + CART[planar..].find("</joint>").expect("its end") + "</joint>".len();
    let joint = |name: &str, kind: &str, parent: &str, child: &str, axis: &str| {
        format!(
            "<joint name=\"{name}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
             <axis xyz=\"{axis}\"/></joint>"
        )
    };
    let written_out = [
        "<link name=\"x\"/><link name=\"y\"/>".to_owned(),
        joint("drive_x", "prismatic", "floor", "x", "1 0 0"),
        joint("drive_y", "prismatic", "x", "y", "0 1 0"),
        joint("drive", "continuous", "y", "cart", "0 0 1"),
    ];
    let text = format!("{}{}{}", &CART[..planar], written_out.concat(), &CART[end..]);
    let robot = Options::new().read(CART).expect("a robot");
    let lagrange = Lagrange::of(&text);
    let (state, accelerations) = state(&robot, 1.0);
    let torques = robot.inverse_dynamics(&state, &accelerations, robot.gravity());
    let expected = lagrange.torques(&state.q, &state.rates, &accelerations, robot.gravity());
    for (x, expected) in torques.iter().zip(&expected) {
        assert!((x - expected).abs() < 1e-10 * largest(&torques), "{torques:?} {expected:?}");
    }
}

#[test]
fn a_floating_base_moves_as_six_joints_do() {
    // Three slides and three hinges that stand at zero: rates are the velocity and, for small turns, the angular velocity.
    let mut chain = String::new();
    let axes = ["1 0 0", "0 1 0", "0 0 1"];
    let mut parent = "ground".to_owned();
    chain += "<link name=\"ground\"/>";
    for (k, axis) in axes.iter().chain(&axes).enumerate() {
        let child = if k == 5 { "pelvis".to_owned() } else { format!("between{k}") };
        if k < 5 {
            chain += &format!("<link name=\"{child}\"/>");
        }
        let kind = if k < 3 { "prismatic" } else { "continuous" };
        chain += &format!(
            "<joint name=\"base{k}\" type=\"{kind}\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
             <axis xyz=\"{axis}\"/></joint>"
        );
        parent = child;
    }
    let text = HUMANOID.replace("</robot>", &(chain + "</robot>"));
    let robot = Options::new().base(Base::Floating).read(HUMANOID).expect("a robot");
    let lagrange = Lagrange::of(&text);
    let (mut state, _) = state(&robot, 1.0);
    // Hinges 1-2-3 at zero angles: ω = (a, b, c) to first order, and the accelerations of angles are α less products of rates;
    // without spin of the base both say the same.
    state.base_rates = [[0.3, -0.2, 0.5], [0.0; 3]];
    let n = robot.bodies().len();
    let q: Vec<_> = [0.0; 6].into_iter().chain(state.q.clone()).collect();
    let v: Vec<_> = [0.3, -0.2, 0.5, 0.0, 0.0, 0.0].into_iter().chain(state.rates.clone()).collect();
    let a: Vec<_> = (0..n + 6).map(|k| (0.7 * k as f64 + 0.2).cos()).collect();
    let (mass, expected) = (robot.mass_matrix(&state), lagrange.mass_matrix(&q));
    for (row, expected) in mass.iter().zip(&expected) {
        for (x, expected) in row.iter().zip(expected) {
            assert!((x - expected).abs() < 1e-12);
        }
    }
    let torques = robot.inverse_dynamics(&state, &a, robot.gravity());
    let expected = lagrange.torques(&q, &v, &a, robot.gravity());
    for (x, expected) in torques.iter().zip(&expected) {
        assert!((x - expected).abs() < 1e-10 * largest(&torques), "{x} {expected}");
    }
}
