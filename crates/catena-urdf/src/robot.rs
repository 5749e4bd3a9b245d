//! A robot as a scene needs it: moving bodies, fixed links lumped into them, frames by name.

use crate::algebra::{Matrix, Vector, ZERO, add, apply, subtract, times, transpose};
use crate::inertia::Inertia;
use crate::laws::Laws;
use crate::model::{Furniture, Pose};
use crate::note::Note;
use crate::options::Elements;

/// A robot: bodies that move against each other, from the root on, with all that is constant.
#[derive(Clone, Debug, PartialEq)]
pub struct Robot {
    pub(crate) name: String,
    pub(crate) base: Option<Inertia>,
    pub(crate) bodies: Vec<Body>,
    pub(crate) frames: Vec<Frame>,
    pub(crate) notes: Vec<Note>,
    pub(crate) gravity: Vector,
    pub(crate) test: bool,
    pub(crate) elements: Elements,
    pub(crate) laws: Laws,
}

/// A body with the joint that moves it against its parent.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Name of the joint that moves the body.
    pub joint: String,
    /// Line of the joint in the description.
    pub line: usize,
    /// Whether the joint slides along its axis; else it turns about it.
    pub slides: bool,
    /// The joint's axis, a unit vector in the body's axes.
    pub axis: Vector,
    /// The body inboard of the joint; the base or the ground where there is none.
    pub parent: Option<usize>,
    /// Where the body stands on its parent while the joint is at zero.
    pub pose: Pose,
    /// Inertia of the body about the mass centre, in its own axes, whose origin is on the joint's axis.
    pub inertia: Inertia,
    /// Limits, damping, friction, reduction, mimic.
    pub furniture: Furniture,
}

/// What carries a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carrier {
    /// The ground.
    Ground,
    /// The floating base.
    Base,
    /// A body, by number.
    Body(usize),
}

/// A link of the description as a frame of the body that carries it.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Name of the link.
    pub name: String,
    /// What carries the link.
    pub carrier: Carrier,
    /// Where the link stands, in axes of the carrier.
    pub pose: Pose,
}

impl Robot {
    /// Name of the robot.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Bodies, each after its parent, in the order of the scene's coordinates.
    pub fn bodies(&self) -> &[Body] {
        &self.bodies
    }

    /// The floating base, if there is one.
    pub fn base(&self) -> Option<&Inertia> {
        self.base.as_ref()
    }

    /// All links as frames.
    pub fn frames(&self) -> &[Frame] {
        &self.frames
    }

    /// What the module leaves out or has changed.
    pub fn notes(&self) -> &[Note] {
        &self.notes
    }

    /// Gravity (m/s²).
    pub fn gravity(&self) -> Vector {
        self.gravity
    }

    /// Coordinates of the base: six (place, then turn) or none. Those of the joints come after.
    pub fn base_freedoms(&self) -> usize {
        if self.base.is_some() { 6 } else { 0 }
    }

    /// Whether zeros of the robot are to be no types.
    pub(crate) fn is_general(&self) -> bool {
        self.elements == Elements::LocalGeneral
    }

    /// Moves the origins of bodies: body i by `shifts[i]`, in its axes. What is left of a place is nothing where it is rounding.
    pub(crate) fn shift(&mut self, shifts: &[Vector]) {
        let left = |x: Vector, terms: [Vector; 2]| {
            let size = terms.iter().chain([&x]).flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
            let sum = subtract(add(x, terms[0]), terms[1]);
            sum.map(|x| if x.abs() <= 4.0 * f64::EPSILON * size { 0.0 } else { x })
        };
        for (number, body) in self.bodies.iter_mut().enumerate() {
            let (own, parents) = (shifts[number], body.parent.map_or(ZERO, |parent| shifts[parent]));
            if own != ZERO || parents != ZERO {
                body.pose.place = left(body.pose.place, [apply(&body.pose.turn, own), parents]);
            }
            if own != ZERO && body.inertia.mass != 0.0 {
                body.inertia.centre = left(body.inertia.centre, [ZERO, own]);
            }
        }
        for frame in &mut self.frames {
            if let Carrier::Body(body) = frame.carrier
                && shifts[body] != ZERO
            {
                frame.pose.place = left(frame.pose.place, [ZERO, shifts[body]]);
            }
        }
    }

    /// Puts all axes of bodies elsewhere: column k of `turns[i]` is the k-th new axis of body i, in its old axes.
    pub(crate) fn reframe(&mut self, turns: &[Matrix]) {
        for (number, body) in self.bodies.iter_mut().enumerate() {
            let own = &turns[number];
            if let Some(parent) = body.parent {
                let back = transpose(&turns[parent]);
                body.pose = Pose { place: apply(&back, body.pose.place), turn: times(&back, &body.pose.turn) };
            }
            body.pose.turn = times(&body.pose.turn, own);
            body.axis = apply(&transpose(own), body.axis);
            body.inertia = body.inertia.in_axes(own);
        }
        for frame in &mut self.frames {
            if let Carrier::Body(body) = frame.carrier {
                let back = transpose(&turns[body]);
                frame.pose = Pose { place: apply(&back, frame.pose.place), turn: times(&back, &frame.pose.turn) };
            }
        }
    }
}
