//! Any text is read or refused, without panic and in bounded time; and what is read does not depend on the choice of axes.

use catena_urdf::{Base, Elements, Frames, Options, Robot, State, module};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

const ROBOTS: [&str; 4] = [
    include_str!("../robots/arm7.urdf"),
    include_str!("../robots/quadruped.urdf"),
    include_str!("../robots/humanoid.urdf"),
    include_str!("../robots/cart.urdf"),
];

/// What puts readers to the test.
const PIECES: [&str; 28] = [
    "nan",
    "inf",
    "-1",
    "1e308",
    "-1e308",
    "1e-320",
    "0",
    "",
    " ",
    "0 0 0",
    "1 2",
    "<",
    ">",
    "\"",
    "&lt;",
    "&#10;",
    "<link/>",
    "<joint/>",
    "<robot>",
    "</robot>",
    "</link>",
    "floating",
    "planar",
    "prismatic",
    "fixed",
    "<mimic joint=\"lift\"/>",
    "<!--",
    "é\u{1F916}",
];

/// So many cases, or as many as the environment says.
fn bounded(cases: u32) -> ProptestConfig {
    let cases = std::env::var("CATENA_CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(cases);
    ProptestConfig { cases, max_shrink_iters: 128, failure_persistence: None, ..ProptestConfig::default() }
}

/// Reads in every way there is; what is read is written, too, and has no number that is none.
fn try_all(text: &str) {
    for base in [Base::Written, Base::Fixed, Base::Floating] {
        let repaired = Options::new().snap(1e-3).repair();
        for options in [Options::new(), repaired.clone().frames(Frames::Parallel), repaired.elements(Elements::Local)] {
            match options.base(base).read(text) {
                Ok(robot) => {
                    let text = module(&robot, "robot");
                    assert!(!text.contains("f64::NAN"), "{text}");
                    robot.notes().iter().for_each(|note| assert!(!note.to_string().is_empty()));
                }
                Err(error) => assert!(!error.to_string().is_empty()),
            }
        }
    }
}

/// A text with pieces put in place of others.
fn spoilt() -> impl Strategy<Value = String> {
    let change = (any::<prop::sample::Index>(), 0..40_usize, 0..PIECES.len());
    (0..ROBOTS.len(), prop::collection::vec(change, 1..4)).prop_map(|(robot, changes)| {
        let mut text = ROBOTS[robot].to_owned();
        for (at, length, piece) in changes {
            // Words and tags begin where a quotation mark or a bracket stands: there it hurts most.
            let places: Vec<_> = text.match_indices(['"', '<', ' ']).map(|(at, _)| at + 1).collect();
            let from = places[at.index(places.len())];
            let to = (from..=text.len()).find(|to| *to >= from + length && text.is_char_boundary(*to)).unwrap_or(from);
            text.replace_range(from..to, PIECES[piece]);
        }
        text
    })
}

/// A random tree: for each link but the first its parent, kind, place, angles, axis, mass and a box's sides.
fn tree() -> impl Strategy<Value = String> {
    let number = || -1.0..1.0_f64;
    let vector = move || prop::array::uniform3(number());
    let angle = prop_oneof![Just(0.0), Just(FRAC_PI_2), Just(-FRAC_PI_2 - 4e-6), Just(PI), -3.0..3.0_f64];
    let axis = prop_oneof![Just([0.0, 0.0, 1.0]), Just([0.0, -1.0, 0.0]), Just([1.0, 0.0, 0.0]), vector()];
    let kind = prop::sample::select(vec!["continuous", "continuous", "prismatic", "fixed", "planar"]);
    let link = (any::<prop::sample::Index>(), kind, vector(), prop::array::uniform3(angle), axis, 0.1..5.0_f64);
    prop::collection::vec(link, 1..12).prop_map(|links| {
        // A root with mass: one without, that floats on a hinge, turns about it as the hinge does, and has no inertia of its own.
        let mut text = "<robot name=\"tree\"><link name=\"l0\"><inertial><mass value=\"1\"/><inertia ixx=\"0.1\" ixy=\"0\" ixz=\"0\" iyy=\"0.2\" \
                        iyz=\"0\" izz=\"0.3\"/></inertial></link>"
            .to_owned();
        let list = |x: [f64; 3]| format!("{} {} {}", x[0], x[1], x[2]);
        for (k, (parent, kind, place, angles, axis, mass)) in links.into_iter().enumerate() {
            let (child, parent) = (k + 1, parent.index(k + 1));
            let axis = if axis.iter().all(|x| x.abs() < 1e-3) { [1.0, 0.0, 0.0] } else { axis };
            let [x, y, z] = place.map(|side| 0.05 + side * side);
            let moments = [y + z, x + z, x + y].map(|sum| mass * sum / 12.0);
            text += &format!(
                "<link name=\"l{child}\"><inertial><origin xyz=\"{}\" rpy=\"{}\"/><mass value=\"{mass}\"/><inertia ixx=\"{}\" ixy=\"0\" \
                 ixz=\"0\" iyy=\"{}\" iyz=\"0\" izz=\"{}\"/></inertial></link><joint name=\"j{child}\" type=\"{kind}\"><parent \
                 link=\"l{parent}\"/><child link=\"l{child}\"/><origin xyz=\"{}\" rpy=\"{}\"/><axis xyz=\"{}\"/></joint>",
                list(place.map(|x| 0.3 * x)), list(place), moments[0], moments[1], moments[2], list(place), list(angles), list(axis)
            );
        }
        text + "</robot>"
    })
}

/// Mass matrix and forces at a state that depends on numbers of coordinates only.
fn dynamics(robot: &Robot) -> (Vec<Vec<f64>>, Vec<f64>) {
    let mut state = State::zero(robot);
    let n = robot.bodies().len();
    state.q = (0..n).map(|k| (1.7 * k as f64 + 0.3).sin()).collect();
    state.rates = (0..n).map(|k| (2.3 * k as f64 + 0.9).cos()).collect();
    let accelerations: Vec<_> = (0..n + robot.base_freedoms()).map(|k| (0.9 * k as f64).cos()).collect();
    (robot.mass_matrix(&state), robot.inverse_dynamics(&state, &accelerations, robot.gravity()))
}

proptest! {
    #![proptest_config(bounded(300))]

    #[test]
    fn any_text_is_read_or_refused(text in ".{0,300}") {
        try_all(&text);
        try_all(&format!("<robot>{text}</robot>"));
    }

    #[test]
    fn a_spoilt_description_is_read_or_refused(text in spoilt()) {
        try_all(&text);
    }
}

proptest! {
    #![proptest_config(bounded(200))]

    #[test]
    fn dynamics_do_not_depend_on_axes(text in tree(), floats in any::<bool>()) {
        let base = if floats { Base::Floating } else { Base::Fixed };
        let read = |frames| Options::new().base(base).frames(frames).read(&text);
        let in_body_axes = || Options::new().base(base).elements(Elements::Local).read(&text);
        // Trees of fixed joints alone do not move.
        let Ok(written) = read(Frames::AsWritten) else { return Ok(()) };
        let (mass, forces) = dynamics(&written);
        let size = mass.iter().flatten().chain(&forces).fold(0.0_f64, |most, x| most.max(x.abs()));
        for frames in [Some(Frames::Parallel), Some(Frames::AlongHinges), None] {
            let robot = frames.map_or_else(in_body_axes, read).expect("the same robot");
            let (other, others) = dynamics(&robot);
            for (x, y) in mass.iter().flatten().chain(&forces).zip(other.iter().flatten().chain(&others)) {
                prop_assert!((x - y).abs() < 1e-12 * size, "{x} {y} {size}");
            }
            if frames != Some(Frames::Parallel) {
                prop_assert!(robot.bodies().iter().all(|body| body.axis.iter().filter(|x| **x == 0.0).count() == 2));
            }
        }
        // M is symmetric.
        for (i, row) in mass.iter().enumerate() {
            for (k, x) in row.iter().enumerate() {
                prop_assert!((x - mass[k][i]).abs() < 1e-13 * size);
            }
        }
    }
}

#[test]
fn deep_and_long_texts_end() {
    let count = 100_000;
    try_all(&format!("<robot>{}{}</robot>", "<a>".repeat(count), "</a>".repeat(count)));
    try_all(&"<robot>".repeat(count));
    // A chain of links, all fixed but one.
    let mut text = "<robot><link name=\"l0\"/>".to_owned();
    for k in 1..=20_000 {
        let (kind, parent) = (if k == 7 { "prismatic" } else { "fixed" }, k - 1);
        text += &format!(
            "<link name=\"l{k}\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/>\
             </inertial></link>\n<joint name=\"j{k}\" type=\"{kind}\"><parent link=\"l{parent}\"/><child link=\"l{k}\"/></joint>\n"
        );
    }
    text += "</robot>";
    let robot = Options::new().read(&text).expect("a robot");
    assert_eq!(robot.bodies()[0].inertia.mass, 19_994.0);
    let error = Options::new().read(&text.replace("fixed", "continuous")).expect_err("too many joints");
    assert_eq!(error.to_string(), "20000 moving joints are more than 512");
}

/// As many arms on one body as a robot may have joints: what is done for pairs of them would show.
#[test]
fn bodies_that_carry_many_end() {
    let inertial = "<inertial><origin xyz=\"0.1 0.2 0.3\"/><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial>";
    let mut text = format!("<robot><link name=\"l0\"/><link name=\"l1\">{inertial}</link>");
    for k in 2..=512 {
        let x = f64::from(k);
        text += &format!(
            "<link name=\"l{k}\">{inertial}</link><joint name=\"j{k}\" type=\"continuous\"><origin xyz=\"{x} {} 1\" rpy=\"0.{k} 0 {x}\"/>\
             <parent link=\"l1\"/><child link=\"l{k}\"/></joint>\n",
            1.0 / x
        );
    }
    text += "<joint name=\"j1\" type=\"continuous\"><parent link=\"l0\"/><child link=\"l1\"/></joint></robot>";
    let robot = Options::new().elements(Elements::Local).read(&text).expect("a robot");
    assert_eq!(robot.bodies().len(), 512);
}
