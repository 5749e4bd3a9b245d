//! Laws of joints as types and values, and motors.

use super::number;
use crate::laws::{Laws, Motor, Stops};
use crate::robot::{Body, Robot};
use std::fmt::Write;

/// Types and values of the laws of a joint.
fn laws(laws: Laws, body: &Body) -> Vec<(&'static str, String)> {
    let literal = |x: f64| format!("T::literal({})", number(x));
    let mut list = Vec::new();
    if let Some(damping) = laws.damping_of(&body.furniture) {
        list.push(("Spring<Absent, T>", format!("Spring::damping({})", literal(damping))));
    }
    if let Some([force, speed]) = laws.friction_of(&body.furniture, body.slides) {
        list.push(("DryFriction<T>", format!("DryFriction::new({}, {})", literal(force), literal(speed))));
    }
    if let Some(Stops { range, stiffness, depth, damping }) = laws.stops_of(&body.furniture, body.slides) {
        let ([lower, upper], [k, w, c]) = (range.map(literal), [stiffness, depth, damping].map(literal));
        list.push(("Stops<T, T>", format!("Stops::between([{lower}, {upper}], {k}, {w}).damped({c})")));
    }
    list
}

/// One, or a tuple.
fn several<S: AsRef<str>>(list: &[S]) -> Option<String> {
    match list {
        [] => None,
        [one] => Some(one.as_ref().to_owned()),
        list => Some(format!("({})", list.iter().map(AsRef::as_ref).collect::<Vec<_>>().join(", "))),
    }
}

/// The type of a joint's law, if it has one.
pub fn kind(robot: &Robot, body: &Body) -> Option<String> {
    several(&laws(robot.laws, body).iter().map(|(kind, _)| *kind).collect::<Vec<_>>())
}

/// What gives a joint its law.
fn with(robot: &Robot, body: &Body) -> String {
    let value = several(&laws(robot.laws, body).into_iter().map(|(_, value)| value).collect::<Vec<_>>());
    value.map_or(String::new(), |value| format!(".with({value})"))
}

/// What is around a joint that has modes.
pub enum Guard {
    /// Friction, that holds it.
    Friction(f64),
    /// Stops, and the share of a rate that they give back.
    Range([f64; 2], f64),
    /// Both.
    Both(f64, [f64; 2], f64),
}

impl Guard {
    /// The names that its type and its value use, its type first.
    fn names(&self) -> &'static [&'static str] {
        match self {
            Self::Friction(_) => &["Coulomb"],
            Self::Range(..) => &["HardStops"],
            Self::Both(..) => &["BoundedCoulomb", "Coulomb"],
        }
    }

    /// The value of a joint that has it.
    fn around(&self, joint: &str) -> String {
        let literal = |x: f64| format!("T::literal({})", number(x));
        let stops = |[lower, upper]: [f64; 2]| format!("[{}, {}]", literal(lower), literal(upper));
        match *self {
            Self::Friction(force) => format!("Coulomb::new({joint}, {})", literal(force)),
            Self::Range(range, back) => {
                format!("HardStops::between({joint}, {}).rebounding({})", stops(range), literal(back))
            }
            Self::Both(force, range, back) => {
                let (force, range, back) = (literal(force), stops(range), literal(back));
                format!("Coulomb::new({joint}, {force}).between({range}).rebounding({back})")
            }
        }
    }
}

/// What is around a joint, if it has modes.
pub fn guard(robot: &Robot, body: &Body) -> Option<Guard> {
    match (robot.laws.sticking_of(&body.furniture), robot.laws.hard_stops_of(&body.furniture)) {
        (Some(force), Some((range, back))) => Some(Guard::Both(force, range, back)),
        (Some(force), None) => Some(Guard::Friction(force)),
        (None, Some((range, back))) => Some(Guard::Range(range, back)),
        (None, None) => None,
    }
}

/// The type of a joint with its law, around which is what gives it modes: from a type without its last parameters, what follows
/// its law there, and the law that it must name in any case.
pub fn joint_type(robot: &Robot, body: &Body, [open, after, least]: [&str; 3]) -> String {
    let law = kind(robot, body).map(|law| format!(", {law}"));
    if let Some(guard) = guard(robot, body) {
        return format!("{}<{open}{least}{after}>, T{}>", guard.names()[0], law.unwrap_or_default());
    }
    format!("{open}{}{after}>", law.as_deref().unwrap_or(least))
}

/// The value of a joint with its law, around which is what gives it modes; `after` is what is said after the law.
pub fn joint(robot: &Robot, body: &Body, made: &str, after: &str) -> String {
    let law = with(robot, body);
    match guard(robot, body) {
        Some(guard) => format!("{}{law}", guard.around(&format!("{made}{after}"))),
        None => format!("{made}{law}{after}"),
    }
}

/// Whether something of this name is around a joint, as a type or as what makes it.
pub fn wraps(robot: &Robot, name: &str) -> bool {
    robot.bodies.iter().filter_map(|body| guard(robot, body)).any(|guard| guard.names().contains(&name))
}

/// Whether a law of this name is used: `Spring` and `Absent` by dampers.
pub fn uses(robot: &Robot, name: &str) -> bool {
    robot.bodies.iter().any(|body| laws(robot.laws, body).iter().any(|(kind, _)| kind.contains(name)))
}

/// The function that gives motors.
pub fn motors(robot: &Robot) -> String {
    let mut text = String::new();
    if !robot.laws.has_motors() {
        return text;
    }
    let count = robot.bodies.len();
    let _ = writeln!(text, "/// Motors of the joints, where limits of effort and velocity are known.");
    let _ = writeln!(text, "pub fn motors<T: Scalar>() -> [Option<Motor<T>>; {count}] {{\n    [");
    for body in &robot.bodies {
        let Some(Motor { peak, free, stall, ratio }) = robot.laws.motor_of(&body.furniture) else {
            text += "        None,\n";
            continue;
        };
        let [peak, free, stall, ratio] = [peak, free, stall, ratio].map(number);
        let _ = writeln!(
            text,
            "        Some(Motor::new(T::literal({peak}), T::literal({free})).stalling_at(T::literal({stall})).geared(T::literal({ratio}))),"
        );
    }
    text += "    ]\n}\n\n";
    text
}
