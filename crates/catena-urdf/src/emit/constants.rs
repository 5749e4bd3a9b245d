//! Names, limits and furniture of joints, and frames, as constants of a module.

use super::names::{Scope, comment};
use super::plan::Plan;
use super::{list, number};
use crate::robot::{Carrier, Robot};
use std::fmt::Write;

/// Constants of joints.
pub fn joints(robot: &Robot) -> String {
    let count = robot.bodies.len();
    let mut text = String::new();
    let names: Vec<_> = robot.bodies.iter().map(|body| format!("{:?}", body.joint)).collect();
    let _ = writeln!(text, "/// Names of the joints, in the order of their coordinates.");
    let _ = writeln!(text, "pub const JOINTS: [&str; {count}] = [{}];\n", names.join(", "));
    let _ = writeln!(
        text,
        "/// Joints by name: numbers in [`JOINTS`] and in all lists of the joints. (Loads and readings number the root's joint, too, and welds:\n/// `describe` of the scene has these numbers.)\npub mod joint {{"
    );
    let mut scope = Scope::new();
    for (number, body) in robot.bodies.iter().enumerate() {
        let kind = if body.slides { "slides (m)" } else { "turns (rad)" };
        let _ = writeln!(text, "    /// `{}`, line {}: {kind}.", comment(&body.joint), body.line);
        let _ = writeln!(text, "    pub const {}: usize = {number};", scope.of_constant(&body.joint));
    }
    text += "}\n\n";
    let furniture = || robot.bodies.iter().map(|body| &body.furniture);
    let mut numbers = |name: &str, title: &str, values: Vec<f64>| {
        let values: Vec<_> = values.into_iter().map(number).collect();
        let _ = writeln!(text, "/// {title}\npub const {name}: [f64; {count}] = [{}];\n", values.join(", "));
    };
    numbers("LOWER", "Lower limits of the joints (rad, m).", furniture().map(|f| f.lower).collect());
    numbers("UPPER", "Upper limits of the joints (rad, m).", furniture().map(|f| f.upper).collect());
    numbers("EFFORT", "Largest torques and forces (N·m, N).", furniture().map(|f| f.effort).collect());
    numbers("VELOCITY", "Largest speeds (rad/s, m/s).", furniture().map(|f| f.velocity).collect());
    numbers("DAMPING", "Viscous damping (N·m·s/rad, N·s/m).", furniture().map(|f| f.damping).collect());
    numbers("FRICTION", "Dry friction (N·m, N).", furniture().map(|f| f.friction).collect());
    if furniture().any(|f| f.reduction.is_some()) {
        let value = |reduction: Option<f64>| reduction.map_or("None".to_owned(), |x| format!("Some({})", number(x)));
        let values: Vec<_> = furniture().map(|f| value(f.reduction)).collect();
        let _ = writeln!(text, "/// Turns of the motor a turn of the joint, where a transmission says it.");
        let _ = writeln!(text, "pub const REDUCTION: [Option<f64>; {count}] = [{}];\n", values.join(", "));
    }
    text += &mimics(robot);
    text
}

fn mimics(robot: &Robot) -> String {
    let mut text = String::new();
    let followers = || robot.bodies.iter().filter_map(|body| Some((body, body.furniture.mimic.as_ref()?)));
    if followers().next().is_none() {
        return text;
    }
    text += "/// A joint that follows another one: q = multiplier · q of the other + offset.\n\
             #[derive(Clone, Copy, Debug, PartialEq)]\npub struct Mimic {\n    /// The joint.\n    pub joint: &'static str,\n    \
             /// The joint followed.\n    pub of: &'static str,\n    /// Factor.\n    pub multiplier: f64,\n    \
             /// Offset (rad, m).\n    pub offset: f64,\n}\n\n";
    let but = if couples(robot) { ", but under [`couplings`]" } else { "" };
    let _ = writeln!(text, "/// Joints that follow others. In the scene they move by themselves{but}.");
    let _ = writeln!(text, "pub const MIMICS: [Mimic; {}] = [", followers().count());
    for (body, mimic) in followers() {
        let (multiplier, offset) = (number(mimic.multiplier), number(mimic.offset));
        let _ = writeln!(
            text,
            "    Mimic {{ joint: {:?}, of: {:?}, multiplier: {multiplier}, offset: {offset} }},",
            body.joint, mimic.joint
        );
    }
    text += "];\n\n";
    text + &couplings(robot)
}

/// Joints and their leaders, by number, with the factor and the offset.
fn followed(robot: &Robot) -> impl Iterator<Item = (usize, usize, f64, f64)> {
    let number = |name: &str| robot.bodies.iter().position(|body| body.joint == name);
    robot.bodies.iter().enumerate().filter_map(move |(follower, body)| {
        let mimic = body.furniture.mimic.as_ref()?;
        Some((follower, number(&mimic.joint)?, mimic.multiplier, mimic.offset))
    })
}

/// Whether there are joints to be coupled.
pub fn couples(robot: &Robot) -> bool {
    followed(robot).next().is_some()
}

/// The function of couplings.
fn couplings(robot: &Robot) -> String {
    let mut text = String::new();
    if couples(robot) {
        let count = followed(robot).count();
        text += "/// What makes joints follow others: `Couplings::of(&scene, couplings())?` are loads of the scene.\n";
        let _ = writeln!(text, "pub fn couplings<T: Scalar>() -> [Coupling<'static, T>; {count}] {{\n    [");
        for (follower, leader, multiplier, offset) in followed(robot) {
            let (multiplier, offset) = (number(multiplier), number(offset));
            let _ = writeln!(
                text,
                "        Coupling::by_coordinate({follower}, {leader}).ratio(T::literal({multiplier})).offset(T::literal({offset})), \
                 // {}",
                comment(&robot.bodies[follower].joint)
            );
        }
        text += "    ]\n}\n\n";
    }
    text
}

/// Constants of frames.
pub fn frames(robot: &Robot, plan: &Plan) -> String {
    let mut text = "/// A link of the description: where it stands on the body that carries it.\n\
                    #[derive(Clone, Copy, Debug, PartialEq)]\npub struct Frame {\n    /// Name of the link.\n    pub name: &'static str,\n    \
                    /// The body that carries it, among the bodies of the scene; none for the ground.\n    \
                    pub body: Option<usize>,\n    \
                    /// The joint that moves this body, as functions of lists number joints (`snapshot.point(frame.joint, frame.place)`); none for\n    \
                    /// the base and the ground.\n    pub joint: Option<usize>,\n    /// Origin of the link (m), in axes of the body.\n    pub place: [f64; 3],\n    \
                    /// Axes of the link as columns (row by row), in axes of the body.\n    pub turn: [[f64; 3]; 3],\n}\n\n\
                    /// Links of the description by name.\npub mod frame {\n    use super::Frame;\n"
        .to_owned();
    let mut scope = Scope::new();
    for frame in &robot.frames {
        let (body, joint) = match frame.carrier {
            Carrier::Ground => ("None".to_owned(), "None".to_owned()),
            Carrier::Base => ("Some(0)".to_owned(), "None".to_owned()),
            Carrier::Body(body) => (format!("Some({})", plan.bodies[body]), format!("Some({body})")),
        };
        let place = list(frame.pose.place);
        let [x, y, z] = frame.pose.turn.map(list);
        let name = scope.of_constant(&frame.name);
        let _ = writeln!(text, "    /// `{}`.\n    pub const {name}: Frame = Frame {{", comment(&frame.name));
        let _ = writeln!(
            text,
            "        name: {:?},\n        body: {body},\n        joint: {joint},\n        place: {place},",
            frame.name
        );
        let _ = writeln!(text, "        turn: [{x}, {y}, {z}],\n    }};");
    }
    text += "}\n\n";
    text
}
