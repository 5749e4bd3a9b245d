//! A robot as the text of a Rust module.

mod constants;
mod elements;
mod laws;
mod names;
mod plan;
mod structure;
mod test;

use crate::algebra::Vector;
use crate::options::Elements;
use crate::robot::Robot;
use plan::Plan;
use std::fmt::Write;

/// The module of a robot, as the text of a Rust file for a program to include; `name` becomes that of the module, as Rust writes names of
/// modules: `arm_2dof` for `2dof`, `loop_2` for `loop`.
pub fn module(robot: &Robot, name: &str) -> String {
    let plan = Plan::of(robot);
    let mut text = elements::imports(robot, &plan);
    text += "\n";
    text += &elements::types(robot, &plan);
    text += &constants::joints(robot);
    text += &constants::frames(robot, &plan);
    text += &elements::constructors(robot, &plan);
    text += &laws::motors(robot);
    text += "fn vector<T: Scalar>(numbers: [f64; 3]) -> [T; 3] {\n    numbers.map(T::literal)\n}\n\n";
    text += "fn tensor<T: Scalar>(rows: [[f64; 3]; 3]) -> [[T; 3]; 3] {\n    rows.map(vector)\n}\n";
    if robot.test {
        text += "\n";
        text += &test::module(robot, &plan);
    }
    let joints = robot.bodies.len();
    let base = if robot.base.is_some() { ", and a floating base" } else { "" };
    let title = names::comment(&robot.name);
    let mut whole = String::new();
    let _ = writeln!(
        whole,
        "/// Robot `{title}`: {joints} joints{base}. Written from its description; change that instead."
    );
    whole += match robot.elements {
        Elements::Inertial => {
            "///\n/// The origin of a body is at its joint. While all joints are at zero, its axes are those of its parent, but for a\n\
             /// turn that stands before the joint. SI units.\n"
        }
        Elements::Local | Elements::LocalGeneral => {
            "///\n/// The z axis of a body is that of its joint, its origin on it; where links of the description stand is in [`frame`]. SI units.\n"
        }
    };
    whole += "#[allow(dead_code, clippy::approx_constant, clippy::excessive_precision)]\n";
    let _ = writeln!(whole, "pub mod {} {{", names::Scope::of_language().of_function(name));
    for line in text.lines() {
        let indent = if line.is_empty() { "" } else { "    " };
        let _ = writeln!(whole, "{indent}{line}");
    }
    whole + "}\n"
}

/// A number as Rust writes it, to the last bit; zero without a sign.
fn number(x: f64) -> String {
    match x {
        _ if x == 0.0 => "0.0".to_owned(),
        _ if x == f64::INFINITY => "f64::INFINITY".to_owned(),
        _ if x == f64::NEG_INFINITY => "f64::NEG_INFINITY".to_owned(),
        _ if x.is_nan() => "f64::NAN".to_owned(),
        _ => format!("{x:?}"),
    }
}

fn list(x: Vector) -> String {
    numbers(&x)
}

fn numbers(list: &[f64]) -> String {
    let list: Vec<_> = list.iter().map(|x| number(*x)).collect();
    format!("[{}]", list.join(", "))
}
