//! What joints leave open of their bodies' axes, chosen so that zeros show: the angle about each joint's axis, and the place along it.
//!
//! Both move a body's axes without another coordinate: the angle is added to that of the hinge, the place to that of the joint on its parent
//! and, with the other sign, to those of all that sits on the body. Denavit and Hartenberg use them to leave four numbers of six; here they
//! make as little work as such moves of one body after the other can.

use crate::algebra::{IDENTITY, Matrix, Vector, about, add, apply, dot, matrix, scale, subtract, transpose, turned};
use crate::inertia::Inertia;
use crate::robot::{Body, Robot};

/// Passes over all bodies; the moves of one body matter to its neighbours alone.
const PASSES: usize = 8;
/// Bodies on a body that it is moved to suit, the first ones: more are on no robot, and would take their square.
const SUITED: usize = 16;
/// Below this share of what it is made of, a number is rounding.
const ROUNDED: f64 = 16.0 * f64::EPSILON;

/// Operations of a sweep, roughly, for what is not zero: the first component of a place, each of them, turns about a coordinate axis and about
/// any, components of a mass centre, products of inertia.
const PLACE: usize = 18;
const COMPONENT: usize = 21;
const ABOUT_AXIS: usize = 90;
const ABOUT_ANY: usize = 220;
const CENTRE: usize = 6;
const PRODUCT: usize = 7;
/// How many times that is saved where nothing else is carried, whose elimination would fill zeros.
const ALONE: usize = 2;

/// How the axes of a body are moved: turned about its joint's axis (rad), and shifted along it (m).
#[derive(Clone, Copy, PartialEq)]
struct Move {
    angle: f64,
    shift: f64,
}

/// A robot whose joints' axes are along coordinate axes, and how the axes of its bodies are moved.
struct Moves<'r> {
    robot: &'r Robot,
    children: Vec<Vec<usize>>,
    moves: Vec<Move>,
}

/// Moves axes of bodies so that zeros show.
pub fn show(robot: &mut Robot) {
    let count = robot.bodies.len();
    let mut children = vec![Vec::new(); count];
    for (number, body) in robot.bodies.iter().enumerate() {
        if let Some(parent) = body.parent {
            children[parent].push(number);
        }
    }
    let mut all = Moves { robot, children, moves: vec![Move { angle: 0.0, shift: 0.0 }; count] };
    for _ in 0..PASSES {
        let before = all.moves.clone();
        (0..count).for_each(|body| all.improve(body));
        if all.moves == before {
            break;
        }
    }
    let moves = all.moves;
    let axes: Vec<Vector> = robot.bodies.iter().map(|body| body.axis).collect();
    let of_each = || moves.iter().zip(&axes);
    robot.shift(&of_each().map(|(of, axis)| scale(of.shift, *axis)).collect::<Vec<_>>());
    robot.reframe(&of_each().map(|(of, axis)| turn(*axis, of.angle)).collect::<Vec<_>>());
    // Which turns about themselves leave, but for rounding.
    robot.bodies.iter_mut().zip(axes).for_each(|(body, axis)| body.axis = axis);
}

/// A turn about a signed coordinate axis; none is exact.
fn turn(axis: Vector, angle: f64) -> Matrix {
    if angle == 0.0 { IDENTITY } else { about(axis, angle) }
}

/// Components that are more than rounding.
fn count(x: Vector, size: f64) -> usize {
    x.iter().filter(|x| x.abs() > ROUNDED * size).count()
}

fn largest(x: impl IntoIterator<Item = f64>) -> f64 {
    x.into_iter().fold(0.0, |most, x| f64::max(most, x.abs()))
}

impl Moves<'_> {
    /// How a body's joint has been shifted along its axis, in axes of the parent.
    fn shifted(&self, body: usize) -> Vector {
        let Body { pose, axis, .. } = &self.robot.bodies[body];
        scale(self.moves[body].shift, apply(&pose.turn, *axis))
    }

    /// Where a body's joint sits on its parent, in axes of that before they are moved.
    fn reach(&self, body: usize) -> Vector {
        add(self.robot.bodies[body].pose.place, self.shifted(body))
    }

    /// Where a body's joint sits on its parent, in axes of that as they are moved, with the size of what it is made of.
    fn place(&self, body: usize) -> (Vector, f64) {
        let Body { pose, parent, .. } = &self.robot.bodies[body];
        let size = largest(pose.place) + largest(self.shifted(body));
        let Some(parent) = *parent else {
            return (self.reach(body), size);
        };
        let (Move { angle, shift }, axis) = (self.moves[parent], self.robot.bodies[parent].axis);
        let parents = scale(shift, axis);
        let place = apply(&transpose(&turn(axis, angle)), subtract(self.reach(body), parents));
        (place, size + largest(parents))
    }

    /// A joint's axis in axes of its parent as they are moved.
    fn axis(&self, body: usize) -> Vector {
        let Body { pose, axis, parent, .. } = &self.robot.bodies[body];
        let axis = apply(&pose.turn, *axis);
        parent.map_or(axis, |parent| {
            apply(&transpose(&turn(self.robot.bodies[parent].axis, self.moves[parent].angle)), axis)
        })
    }

    /// What a joint costs: a sweep leaves out what lies inboard of one on the ground.
    fn joint_cost(&self, body: usize) -> usize {
        if self.robot.base.is_none() && self.robot.bodies[body].parent.is_none() {
            return 0;
        }
        let (place, size) = self.place(body);
        let components = count(place, size);
        let turn = [0, 0, ABOUT_AXIS, ABOUT_ANY][count(self.axis(body), 1.0)];
        turn + if components > 0 { PLACE + COMPONENT * components } else { 0 }
    }

    /// What a body's own inertia costs.
    fn inertia_cost(&self, body: usize) -> usize {
        let (Body { axis, inertia, .. }, Move { angle, shift }) = (&self.robot.bodies[body], self.moves[body]);
        let Inertia { mass, centre, tensor } = *inertia;
        let (shift, back) = (scale(shift, *axis), transpose(&turn(*axis, angle)));
        let (size, centre) = (largest(centre) + largest(shift), apply(&back, subtract(centre, shift)));
        let tensor = turned(&back, &tensor);
        let about = matrix(|i, k| {
            tensor[i][k] + mass * (if i == k { dot(centre, centre) } else { 0.0 } - centre[i] * centre[k])
        });
        let of_tensor = largest(about.into_iter().flatten()) + mass * size * size;
        let products = count([about[1][2], about[0][2], about[0][1]], of_tensor);
        let alone = if self.children[body].is_empty() { ALONE } else { 1 };
        alone * (CENTRE * count(centre, size) + PRODUCT * products)
    }

    /// What depends on how a body's axes are moved.
    fn cost(&self, body: usize) -> usize {
        let outboard: usize = self.children[body].iter().map(|child| self.joint_cost(*child)).sum();
        self.inertia_cost(body) + self.joint_cost(body) + outboard
    }

    /// Takes the best of some moves of a body, the present one where none is better.
    fn take_best(&mut self, body: usize, candidates: Vec<Move>) {
        let (mut best, mut least) = (self.moves[body], self.cost(body));
        for candidate in candidates {
            self.moves[body] = candidate;
            let cost = self.cost(body);
            if cost < least {
                (best, least) = (candidate, cost);
            }
        }
        self.moves[body] = best;
    }

    /// Moves the axes of one body.
    fn improve(&mut self, body: usize) {
        let own = &self.robot.bodies[body];
        let (now, axis) = (self.moves[body], own.axis);
        if !own.slides {
            let mut list = vec![0.0];
            list.extend(onto_axis(axis, own.inertia.centre));
            for child in self.children[body].iter().take(SUITED) {
                let Body { pose, axis: of_child, .. } = &self.robot.bodies[*child];
                let vectors = [apply(&pose.turn, *of_child), self.reach(*child)];
                list.extend(vectors.into_iter().filter_map(|x| onto_axis(axis, x)));
            }
            self.take_best(body, list.into_iter().map(|angle| Move { angle, ..now }).collect());
        }
        // Shifts that make a component of a place nothing, or bring the mass centre beside the origin.
        let now = self.moves[body];
        let mut list = vec![0.0, dot(axis, own.inertia.centre)];
        let ((place, _), along) = (self.place(body), self.axis(body));
        list.extend((0..3).filter(|k| along[*k].abs() > 0.1).map(|k| now.shift - place[k] / along[k]));
        list.extend(self.children[body].iter().take(SUITED).map(|child| dot(axis, self.reach(*child))));
        self.take_best(body, list.into_iter().map(|shift| Move { shift, ..now }).collect());
    }
}

/// The least angle about a signed coordinate axis that axes must be turned by for a vector to lie in a plane of two of them that holds the axis;
/// none for a vector along the axis.
fn onto_axis(axis: Vector, x: Vector) -> Option<f64> {
    let along = (0..3).find(|k| axis[*k] != 0.0)?;
    let (first, second) = ((along + 1) % 3, (along + 2) % 3);
    let (a, b) = (x[first], axis[along] * x[second]);
    if largest([a, b]) <= ROUNDED * largest(x) {
        return None;
    }
    let angle = b.atan2(a);
    let quarter = std::f64::consts::FRAC_PI_2;
    let least = angle - quarter * (angle / quarter).round();
    Some(if least.abs() <= ROUNDED { 0.0 } else { least })
}
