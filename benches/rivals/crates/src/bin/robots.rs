//! Functions of robots by dynibo, at the states that Catena went through: whether the numbers are the same, and nanoseconds a call.
//!
//! ```text
//! robots check DESCRIPTION STATES    # the largest difference of a function, relative to the largest number
//! robots time DESCRIPTION STATES     # nanoseconds a call, a function a line
//! ```
//!
//! dynibo's gravity is a constant, 9.80665 m/s²: what weights make is completed to 9.81.

use catena_rivals::{GRAVITY, timed};
use dynibo::{BaseState, FloatingRobot, Frame, LinkId, Robot, Twist};
use nalgebra::{DMatrix, Quaternion, Translation3, UnitQuaternion, Vector3};
use std::collections::HashMap;
use std::error::Error;
use std::hint::black_box;

/// By how much more than dynibo's weights are.
const MORE: f64 = GRAVITY / 9.80665 - 1.0;
/// Calls of a batch for each state.
const CALLS: usize = 8;

/// Numbers of a state by name; several lists have the name of a function.
type Lists = HashMap<String, Vec<Vec<f64>>>;

/// A robot of dynibo with its base.
enum Model {
    Fixed(Robot),
    Floating(FloatingRobot),
}

/// What a state is for dynibo, in its order of joints.
struct State {
    base: BaseState,
    q: Vec<f64>,
    v: Vec<f64>,
    seconds: Vec<f64>,
    torques: Vec<f64>,
}

/// Calls a function of a robot, with the base where that floats.
macro_rules! of {
    ($model:expr, $base:expr, $name:ident($($argument:expr),*)) => {
        match $model {
            Model::Fixed(robot) => robot.$name($($argument),*),
            Model::Floating(robot) => robot.$name($base, $($argument),*),
        }
    };
}

/// Of both kinds of robots.
macro_rules! both {
    ($model:expr, |$robot:ident| $call:expr) => {
        match $model {
            Model::Fixed($robot) => $call,
            Model::Floating($robot) => $call,
        }
    };
}

impl Model {
    fn joints(&self) -> Result<Vec<String>, dynibo::Error> {
        both!(self, |robot| (0..robot.joint_count()).map(|k| robot.joint_name(k).map(str::to_owned)).collect())
    }
    fn freedoms(&self) -> usize {
        both!(self, |robot| robot.generalized_count())
    }
}

/// The state of a number.
fn state(lists: &Lists, order: &[usize], k: usize) -> Result<State, Box<dyn Error>> {
    let list = |name: &str| lists.get(name).and_then(|lists| lists.get(k)).ok_or("a state too few");
    let (q, v, seconds) = (list("q")?, list("v")?, list("seconds")?);
    let from = v.len() - order.len();
    let joints = |list: &[f64]| order.iter().map(|joint| list[list.len() - order.len() + joint]).collect();
    let mut base = BaseState::stationary(Frame::identity())?;
    if from > 0 {
        let attitude = UnitQuaternion::new_normalize(Quaternion::new(q[3], q[4], q[5], q[6]));
        let vector = |list: &[f64], at: usize| Vector3::new(list[at], list[at + 1], list[at + 2]);
        // Angular ones of the base are in its axes, in Catena.
        let twist = |list: &[f64]| Twist::new(attitude * vector(list, 3), vector(list, 0));
        base = BaseState::new(Frame::from_parts(Translation3::from(vector(q, 0)), attitude), twist(v), twist(seconds))?;
    }
    Ok(State { base, q: joints(q), v: joints(v), seconds: joints(seconds), torques: joints(list("torques")?) })
}

/// The largest difference of the joints' numbers, relative to the largest.
fn difference(found: &[f64], expected: &[f64], order: &[usize]) -> f64 {
    let (found, expected) = (&found[found.len() - order.len()..], &expected[expected.len() - order.len()..]);
    let largest = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let off = order.iter().zip(found).map(|(joint, x)| (x - expected[*joint]).abs());
    off.fold(0.0, f64::max) / largest
}

/// Compares functions at all states.
fn check(
    model: &mut Model,
    lists: &Lists,
    order: &[usize],
    states: &[State],
    target: LinkId,
) -> Result<(), Box<dyn Error>> {
    let (n, joints) = (model.freedoms(), order.len());
    let (mut found, mut weights, mut mass, mut jacobian) =
        (vec![0.0; n], vec![0.0; n], vec![0.0; n * n], vec![0.0; 6 * n]);
    let mut off = [0.0_f64; 4];
    for (k, state) in states.iter().enumerate() {
        let answers = |name: &str| lists.get(name).and_then(|lists| lists.get(k)).ok_or("an answer too few");
        let mut note = |function: usize, difference: f64| off[function] = off[function].max(difference);
        let State { base, q, v, seconds, torques } = state;
        of!(model, base, gravity(q, &[], &mut weights))?;
        of!(model, base, inverse_dynamics(q, v, seconds, &[], &mut found))?;
        found.iter_mut().zip(&weights).for_each(|(x, weight)| *x += MORE * weight);
        note(0, difference(&found, answers("inverse_dynamics")?, order));
        let mut forces = vec![0.0; n - joints];
        forces.extend(torques);
        forces.iter_mut().zip(&weights).for_each(|(x, weight)| *x -= MORE * weight);
        of!(model, base, forward_dynamics(q, v, &forces, &[], &mut found))?;
        note(1, difference(&found, answers("sweep")?, order));
        of!(model, base, mass_matrix(q, &mut mass))?;
        let (theirs, ours) = (DMatrix::from_column_slice(n, n, &mass), answers("mass_matrix")?);
        let ours = DMatrix::from_row_slice(n, n, ours);
        for row in 0..joints {
            let (own, other) = (n - joints + order[row], n - joints + row);
            let row = |matrix: &DMatrix<f64>, row: usize| matrix.row(row).transpose().as_slice().to_vec();
            note(2, difference(&row(&theirs, other), &row(&ours, own), order));
        }
        of!(model, base, jacobian(q, target, &mut jacobian))?;
        // Turns first, there; a joint a row, here.
        let theirs: Vec<f64> =
            (0..6 * joints).map(|i| jacobian[6 * (n - joints + i % joints) + (i / joints + 3) % 6]).collect();
        let ours = answers("jacobian")?;
        let ours = DMatrix::from_row_slice(joints, 6, &ours[ours.len() - 6 * joints..]);
        let expected = DMatrix::from_fn(joints, 6, |k, row| ours[(order[k], row)]);
        note(3, (DMatrix::from_column_slice(joints, 6, &theirs) - &expected).amax() / expected.amax());
    }
    for (name, off) in ["rnea", "aba", "crba", "jacobian"].iter().zip(off) {
        println!("dynibo_{name} {off:e}");
    }
    Ok(())
}

/// Times functions over all states.
fn time(model: &mut Model, states: &[State], target: LinkId) -> Result<(), Box<dyn Error>> {
    let n = model.freedoms();
    let (mut found, mut mass, mut jacobian) = (vec![0.0; n], vec![0.0; n * n], vec![0.0; 6 * n]);
    let forces: Vec<Vec<f64>> =
        states.iter().map(|state| [&vec![0.0; n - state.torques.len()][..], &state.torques].concat()).collect();
    macro_rules! timed {
        ($name:literal, |$state:ident, $forces:ident| $call:expr) => {{
            let ((), seconds) = timed(|| {
                for _ in 0..CALLS {
                    for ($state, $forces) in states.iter().zip(&forces) {
                        $call.expect("an answer");
                        black_box((&found, &mass, &jacobian, $forces));
                    }
                }
            });
            println!(concat!("dynibo_", $name, " {:.2}"), 1e9 * seconds / (CALLS * states.len()) as f64);
        }};
    }
    timed!("rnea", |s, forces| of!(model, &s.base, inverse_dynamics(&s.q, &s.v, &s.seconds, &[], &mut found)));
    timed!("aba", |s, forces| of!(model, &s.base, forward_dynamics(&s.q, &s.v, forces, &[], &mut found)));
    timed!("crba", |s, forces| of!(model, &s.base, mass_matrix(&s.q, &mut mass)));
    timed!("jacobian", |s, forces| of!(model, &s.base, jacobian(&s.q, target, &mut jacobian)));
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [what, description, file] = &words[..] else { return Err("check or time, a description, states".into()) };
    let (text, mut lists, mut names, mut of) = (std::fs::read_to_string(file)?, Lists::new(), vec![], "");
    for line in text.lines() {
        let (name, rest) = line.split_once(' ').unwrap_or((line, ""));
        match name {
            "joints" => names = rest.split(' ').collect(),
            "of" => of = rest,
            _ => {
                let numbers = rest.split(' ').map(str::parse).collect::<Result<_, _>>()?;
                lists.entry(name.to_owned()).or_default().push(numbers);
            }
        }
    }
    let states = lists.get("q").ok_or("no states")?;
    let floats = states.iter().any(|q| q.len() > names.len());
    let mut model = if floats {
        Model::Floating(FloatingRobot::from_urdf(description)?)
    } else {
        Model::Fixed(Robot::from_urdf(description)?)
    };
    let order: Vec<usize> = model
        .joints()?
        .iter()
        .map(|joint| names.iter().position(|name| name == joint).ok_or_else(|| format!("no joint {joint}")))
        .collect::<Result<_, _>>()?;
    let states: Vec<State> = (0..states.len()).map(|k| state(&lists, &order, k)).collect::<Result<_, _>>()?;
    // The link that the joint moves: of the description alone.
    let robot = std::fs::read_to_string(description)?;
    let (_, after) = robot.split_once(&format!("<joint name=\"{of}\"")).ok_or("no such joint")?;
    let (_, after) = after.split_once("<child link=\"").ok_or("no child")?;
    let link = after.split('"').next().unwrap_or_default();
    let target = both!(&model, |robot| robot.link_id(link))?;
    match what.as_str() {
        "check" => check(&mut model, &lists, &order, &states, target),
        "time" => time(&mut model, &states, target),
        _ => Err(what.as_str().into()),
    }
}
