//! Chains as types and values of the library's elements. All that the module says of elements stands here.

use super::names::{Scope, comment};
use super::plan::{Part, Plan};
use super::{constants, laws, list, number, structure};
use crate::algebra::{Matrix, Vector, quaternion};
use crate::inertia::Inertia;
use crate::options::Elements;
use crate::robot::{Body, Carrier, Robot};
use std::fmt::Write;

/// Names of the chains' types and constructors.
struct Names {
    types: Vec<String>,
    functions: Vec<String>,
}

impl Names {
    fn of(robot: &Robot, plan: &Plan) -> Self {
        let (mut types, mut functions) = (Scope::new(), Scope::new());
        let joint = |first: Option<usize>| first.map_or("", |first| robot.bodies[first].joint.as_str());
        let mut names = Self { types: Vec::new(), functions: Vec::new() };
        for arm in &plan.arms[..plan.arms.len() - 1] {
            names.types.push(types.of_type(joint(arm.first)));
            names.functions.push(functions.of_function(joint(arm.first)));
        }
        names.types.push("Chain".to_owned());
        names.functions.push("chain".to_owned());
        names
    }
}

/// What the module uses of the library.
pub fn imports(robot: &Robot, plan: &Plan) -> String {
    if robot.elements != Elements::Inertial {
        return local_imports(robot, plan);
    }
    let parts = || plan.arms.iter().flat_map(|arm| &arm.parts);
    let slides = |slides: bool| robot.bodies.iter().any(|body| body.slides == slides);
    let welds = parts().any(|part| matches!(part, Part::Weld(_)));
    let fixed = robot.base.is_none();
    let law = |name: &str| laws::uses(robot, name);
    let wraps = |name: &str| laws::wraps(robot, name);
    let used = [
        ("Absent", law("Spring")),
        ("BoundedCoulomb", wraps("BoundedCoulomb")),
        ("Branch", parts().any(|part| matches!(part, Part::Arm(_)))),
        ("Clamped", fixed),
        ("Coulomb", wraps("Coulomb")),
        ("Coupling", constants::couples(robot)),
        ("DryFriction", law("DryFriction")),
        ("Effort", true),
        ("Free", true),
        ("HardStops", wraps("HardStops")),
        ("Motor", robot.laws.has_motors()),
        ("Prismatic", slides(true)),
        ("Revolute", slides(false)),
        ("RigidBody", true),
        ("Rotation", fixed || welds),
        ("Spring", law("Spring")),
        ("Stops", law("Stops")),
        ("System", true),
        ("Weld", welds),
    ];
    let used: Vec<_> = used.iter().filter(|(_, used)| *used).map(|(name, _)| *name).collect();
    format!("use catena::spatial::{{{}}};\nuse catena::{{Error, Scalar}};\n", used.join(", "))
}

/// What a module in body axes uses of the library.
fn local_imports(robot: &Robot, plan: &Plan) -> String {
    let parts = || plan.arms.iter().flat_map(|arm| &arm.parts);
    let slides = |slides: bool| robot.bodies.iter().any(|body| body.slides == slides);
    let [any, quarter, level, ahead] = structure::kinds(robot, robot.is_general());
    let law = |name: &str| laws::uses(robot, name);
    let wraps = |name: &str| laws::wraps(robot, name);
    let used = [
        ("Absent", robot.base.is_none() || law("Spring")),
        ("Ahead", ahead),
        ("Base", robot.base.is_none()),
        ("BodyAxes", robot.base.is_some()),
        ("BoundedCoulomb", wraps("BoundedCoulomb")),
        ("Branch", parts().any(|part| matches!(part, Part::Arm(_)))),
        ("Coulomb", wraps("Coulomb")),
        ("Coupling", constants::couples(robot)),
        ("DryFriction", law("DryFriction")),
        ("Effort", true),
        ("Free", true),
        ("HardStops", wraps("HardStops")),
        ("Hinge", slides(false)),
        ("Level", level),
        ("Link", true),
        ("Motor", robot.laws.has_motors()),
        ("OnGround", robot.base.is_none()),
        ("Quarter", quarter),
        ("Slide", slides(true)),
        ("Spring", law("Spring") || robot.bodies.iter().any(|body| names_a_law(robot, body))),
        ("Stops", law("Stops")),
        ("System", true),
        ("Turned", any),
    ];
    let used: Vec<_> = used.iter().filter(|(_, used)| *used).map(|(name, _)| *name).collect();
    format!("use catena::robot::{{{}}};\nuse catena::{{Error, Scalar}};\n", used.join(", "))
}

/// The type of a link.
fn link_type(robot: &Robot, inertia: &Inertia) -> String {
    let [moment, tensor] = structure::masks(inertia, robot.is_general());
    format!("Link<T, 0b{moment:03b}, 0b{tensor:06b}>")
}

/// Whether a joint of body axes stands on the ground.
fn is_grounded(robot: &Robot, body: &Body) -> bool {
    robot.base.is_none() && body.parent.is_none()
}

/// Whether a joint of body axes has to name a law though it has none.
fn names_a_law(robot: &Robot, body: &Body) -> bool {
    is_grounded(robot, body) && (laws::guard(robot, body).is_some() || laws::kind(robot, body).is_none())
}

/// Types of all chains and of the scene.
pub fn types(robot: &Robot, plan: &Plan) -> String {
    let names = Names::of(robot, plan);
    let mut text = String::new();
    for (number, arm) in plan.arms.iter().enumerate() {
        let from = arm.first.map(|first| comment(&robot.bodies[first].joint));
        let title = match from {
            _ if number + 1 == plan.arms.len() => "All elements, from root to tip.".to_owned(),
            Some(joint) => format!("What begins with joint `{joint}`."),
            None => "What goes on.".to_owned(),
        };
        let _ = writeln!(text, "/// {title}\npub type {}<T> = (", names.types[number]);
        for (k, part) in arm.parts.iter().enumerate() {
            let local = robot.elements != Elements::Inertial;
            let (open, close) = arm.nested(k);
            let (kind, remark) = match part {
                Part::Axes => ("BodyAxes".to_owned(), String::new()),
                Part::Base(_) if local => {
                    (link_type(robot, &robot.base.unwrap_or(Inertia::NONE)), title_of(robot, Carrier::Base))
                }
                Part::Body(body, _) if local => {
                    (link_type(robot, &robot.bodies[*body].inertia), title_of(robot, Carrier::Body(*body)))
                }
                Part::Joint(joint) if local => {
                    let body = &robot.bodies[*joint];
                    let structure::Joint { mask, offset, .. } = structure::joint(body, robot.is_general());
                    let kind = if body.slides { "Slide" } else { "Hinge" };
                    let open = format!("{kind}<T, {offset}, 0b{mask:03b}");
                    let [least, ground] =
                        if is_grounded(robot, body) { [", Spring", ", Absent, OnGround"] } else { [""; 2] };
                    let kind = laws::joint_type(robot, body, [&open, ground, least]);
                    (kind, format!("joint {}", comment(&body.joint)))
                }
                Part::Base(_) => ("RigidBody<T>".to_owned(), title_of(robot, Carrier::Base)),
                Part::Body(body, _) => ("RigidBody<T>".to_owned(), title_of(robot, Carrier::Body(*body))),
                Part::Massless(_) => ("RigidBody<T>".to_owned(), "a way without mass".to_owned()),
                Part::Weld(_) => ("Weld<T>".to_owned(), "a turn".to_owned()),
                Part::Joint(joint) => {
                    let body = &robot.bodies[*joint];
                    let kind = if body.slides { "Prismatic" } else { "Revolute" };
                    let kind = laws::joint_type(robot, body, [&format!("{kind}<T"), "", ""]);
                    (kind, format!("joint {}", comment(&body.joint)))
                }
                Part::Arm(arm) => (format!("Branch<{}<T>>", names.types[*arm]), String::new()),
                Part::Rest(arm) => (format!("{}<T>", names.types[*arm]), String::new()),
            };
            let remark = if remark.is_empty() { remark } else { format!(" // {remark}") };
            let close = if close.is_empty() { close } else { format!("\n    {close},") };
            let comma = if close.is_empty() { "," } else { "" };
            let _ = writeln!(text, "    {open}{kind}{comma}{remark}{close}");
        }
        text += ");\n\n";
    }
    let root = match robot.base {
        Some(_) => "Free",
        None if robot.elements == Elements::Inertial => "Clamped<[T; 3], Rotation<T>>",
        None => "Base<T>",
    };
    let _ = writeln!(text, "/// The robot.\npub type Scene<T> = System<T, {root}, Chain<T>, Free>;\n");
    text
}

/// Constructors of all chains and of the scene.
pub fn constructors(robot: &Robot, plan: &Plan) -> String {
    let names = Names::of(robot, plan);
    let mut text = String::new();
    let root = match robot.base {
        Some(_) => "Free".to_owned(),
        None if robot.elements == Elements::Inertial => {
            format!("Clamped::at({}, Rotation::identity())", vector(plan.root))
        }
        None => "Base::origin()".to_owned(),
    };
    let fails = plan.arms.iter().any(|arm| arm.parts.iter().any(|part| matches!(part, Part::Weld(_))));
    let [x, y, z] = robot.gravity;
    let _ = writeln!(
        text,
        "/// The robot, in gravity of {} m/s².\n///\n/// # Errors\n/// Where a body has moments of inertia that no body has.\n\
         pub fn scene<T: Scalar>() -> Result<Scene<T>, Error> {{\n    let scene = System::new({root}, chain(){}, Free)?;\n    \
         Ok(scene.with_gravity_vector({}.into()))\n}}\n",
        list([x, y, z]),
        if fails { "?" } else { "" },
        vector(robot.gravity),
    );
    let slots: Vec<_> = plan.joints.iter().map(usize::to_string).collect();
    let (count, all) = (slots.len(), plan.slots);
    let _ = writeln!(
        text,
        "/// Torques (N·m) and forces (N) in the joints, in the order of [`JOINTS`], as efforts of the scene:\n\
         /// `Loads::none().efforts(efforts(torques))`.\n\
         pub fn efforts<T: Scalar>(torques: [T; {count}]) -> [Effort<T>; {all}] {{\n    \
         let slots: [usize; {count}] = [{}];\n    let mut efforts = [Effort::default(); {all}];\n    \
         for (slot, torque) in slots.into_iter().zip(torques) {{\n        \
         efforts[slot] = Effort([torque, T::literal(0.0), T::literal(0.0)]);\n    }}\n    efforts\n}}\n",
        slots.join(", ")
    );
    for (number, arm) in plan.arms.iter().enumerate() {
        let (kind, name) = (&names.types[number], &names.functions[number]);
        let (kind, open, close) = match fails {
            true => (format!("Result<{kind}<T>, Error>"), "Ok((", "))"),
            false => (format!("{kind}<T>"), "(", ")"),
        };
        let ask = if fails { "?" } else { "" };
        if number + 1 == plan.arms.len() {
            text += "/// All elements, from root to tip: for a scene of one's own.\n";
            text += if fails { "///\n/// # Errors\n/// Where a turn is none.\n" } else { "" };
            text += "pub ";
        }
        let _ = writeln!(text, "fn {name}<T: Scalar>() -> {kind} {{\n    {open}");
        for (k, part) in arm.parts.iter().enumerate() {
            let local = robot.elements != Elements::Inertial;
            let (before, after) = arm.nested(k);
            let element = match part {
                Part::Axes => "BodyAxes".to_owned(),
                Part::Base(_) if local => structure::link(&robot.base.unwrap_or(Inertia::NONE)),
                Part::Body(number, _) if local => structure::link(&robot.bodies[*number].inertia),
                Part::Joint(joint) if local => {
                    let body = &robot.bodies[*joint];
                    let structure::Joint { mask, place, turned, .. } = structure::joint(body, robot.is_general());
                    let kind = if body.slides { "Slide" } else { "Hinge" };
                    let ground = if is_grounded(robot, body) { ".grounded()" } else { "" };
                    let made = format!("{kind}::at::<0b{mask:03b}>({}){turned}", vector(place));
                    format!("{}, // {}", laws::joint(robot, body, &made, ground), comment(&body.joint))
                }
                Part::Base(end) => body(&robot.base.unwrap_or(Inertia::NONE), *end),
                Part::Body(number, end) => body(&robot.bodies[*number].inertia, *end),
                Part::Massless(way) => format!("RigidBody::massless({})", vector(*way)),
                Part::Weld(body) => {
                    let [w, x, y, z] = quaternion(&robot.bodies[*body].pose.turn).map(super::number);
                    format!("Weld::at(Rotation::from_quaternion([{w}, {x}, {y}, {z}].map(T::literal))?)")
                }
                Part::Joint(joint) => {
                    let body = &robot.bodies[*joint];
                    let make = if body.slides { "Prismatic::along" } else { "Revolute::about" };
                    let made = format!("{make}({})", vector(body.axis));
                    format!("{}, // {}", laws::joint(robot, body, &made, ""), comment(&body.joint))
                }
                Part::Arm(arm) => format!("Branch({}(){ask})", names.functions[*arm]),
                Part::Rest(arm) => format!("{}(){ask}", names.functions[*arm]),
            };
            let comma = if matches!(part, Part::Joint(_)) { "" } else { "," };
            let _ = writeln!(text, "        {before}{element}{comma}");
            if !after.is_empty() {
                let _ = writeln!(text, "        {after},");
            }
        }
        let _ = writeln!(text, "    {close}\n}}\n");
    }
    text
}

fn vector(x: Vector) -> String {
    format!("vector({})", list(x))
}

fn matrix(rows: &Matrix) -> String {
    let [x, y, z] = rows.map(list);
    format!("tensor([{x}, {y}, {z}])")
}

/// A body with its mass, tensor, mass centre and outboard end.
fn body(inertia: &Inertia, end: Vector) -> String {
    if *inertia == Inertia::NONE {
        return format!("RigidBody::massless({})", vector(end));
    }
    let Inertia { mass, centre, tensor } = inertia;
    let (mass, tensor) = (number(*mass), matrix(tensor));
    let inner = [format!("T::literal({mass})"), tensor, vector(*centre), vector(end)];
    format!("RigidBody::new(\n            {},\n        )", inner.join(",\n            "))
}

/// The link that a body is.
fn title_of(robot: &Robot, carrier: Carrier) -> String {
    robot.frames.iter().find(|frame| frame.carrier == carrier).map(|frame| comment(&frame.name)).unwrap_or_default()
}
