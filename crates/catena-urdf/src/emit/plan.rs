//! A robot as a chain of elements with arms, numbered as a scene numbers them.
//!
//! Children of a body stand in the order of the description; all but the last are arms, and with the last the chain goes on. So
//! the order of joints in the scene is that of [`Robot::bodies`].

use crate::algebra::{IDENTITY, Vector, ZERO, subtract};
use crate::options::Elements;
use crate::robot::Robot;

/// Tuples of the library end at sixteen.
const LONGEST: usize = 16;
/// Parts of an arm that is written as pairs: three joints with their links.
const SHORT: usize = 6;

/// An element of a chain, bodies and joints by number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Part {
    /// From inertial axes to those of bodies.
    Axes,
    /// The floating base, and where its chain goes on.
    Base(Vector),
    /// A body, and where its chain goes on.
    Body(usize, Vector),
    /// A way to a joint that is not where the body ends.
    Massless(Vector),
    /// The constant turn before a joint.
    Weld(usize),
    /// The joint of a body.
    Joint(usize),
    /// An arm, by number.
    Arm(usize),
    /// What goes on, by number of the arm: tuples are not longer.
    Rest(usize),
}

/// A chain: the arm of a branch, or what goes on.
pub struct Arm {
    pub parts: Vec<Part>,
    /// First joint of the chain; none if it has none, as the base alone.
    pub first: Option<usize>,
    /// Whether the arm is in axes of its bodies and not the whole robot.
    in_pairs: bool,
}

impl Arm {
    /// What opens before a part of this number and closes after the last one: short arms in axes of their bodies are pairs of pairs.
    ///
    /// Legs have equal types, and compilers call what is used twice; pairs are inlined anyhow, so that relations need not pass through
    /// memory. Longer arms stay tuples, for what they would take to compile.
    pub fn nested(&self, part: usize) -> (&'static str, String) {
        let (count, plain) = (self.parts.len(), |part: &Part| matches!(part, Part::Body(..) | Part::Joint(_)));
        if !self.in_pairs || count > SHORT || !self.parts.iter().all(plain) {
            return ("", String::new());
        }
        let inner = count.saturating_sub(2);
        let open = if (1..=inner).contains(&part) { "(" } else { "" };
        (open, if part + 1 == count { ")".repeat(inner) } else { String::new() })
    }
}

/// All chains, and the numbers that a scene gives to bodies and joints.
pub struct Plan {
    /// Inner ones first, so that the last is the whole.
    pub arms: Vec<Arm>,
    /// Where the root's end stands.
    pub root: Vector,
    /// Number of each moving body among bodies of the scene.
    pub bodies: Vec<usize>,
    /// Number of each joint among joints of the scene, the root's being 0.
    pub joints: Vec<usize>,
    /// Joints of the scene, the root's included.
    pub slots: usize,
    /// Bodies of the scene, as many as are given so far.
    pub given: usize,
    /// Whether joints sit anywhere on their bodies, and turn these.
    local: bool,
}

impl Plan {
    pub fn of(robot: &Robot) -> Self {
        let count = robot.bodies.len();
        let mut children = vec![Vec::new(); count + 1];
        for (number, body) in robot.bodies.iter().enumerate() {
            children[body.parent.map_or(count, |parent| parent)].push(number);
        }
        let end = |of: usize| children[of].last().map_or(ZERO, |last: &usize| robot.bodies[*last].pose.place);
        let (arms, bodies, joints) = (Vec::new(), vec![0; count], vec![0; count]);
        let local = robot.elements != Elements::Inertial;
        let mut plan = Self { arms, root: end(count), bodies, joints, slots: 1, given: 0, local };
        let mut parts = Vec::new();
        if local {
            plan.root = ZERO;
            if robot.base.is_some() {
                plan.slots = 2;
                parts.push(Part::Axes);
            }
        }
        if robot.base.is_some() {
            plan.given = 1;
            parts.push(Part::Base(plan.root));
            plan.root = ZERO;
        }
        let whole = plan.chain(robot, &children, parts, count, end(count));
        let whole = plan.close(whole);
        plan.arms[whole].in_pairs = false;
        plan
    }

    /// The chain from what carries children on, as far as it goes, after what there is.
    fn chain(
        &mut self,
        robot: &Robot,
        children: &[Vec<usize>],
        mut parts: Vec<Part>,
        mut carrier: usize,
        mut end: Vector,
    ) -> Vec<Part> {
        while let Some((last, arms)) = children[carrier].split_last() {
            for arm in arms {
                let start = subtract(robot.bodies[*arm].pose.place, end);
                let mut inner = Vec::new();
                let next = self.link(robot, children, *arm, start, &mut inner);
                let inner = self.chain(robot, children, inner, *arm, next);
                let number = self.close(inner);
                parts.push(Part::Arm(number));
            }
            end = self.link(robot, children, *last, subtract(robot.bodies[*last].pose.place, end), &mut parts);
            carrier = *last;
        }
        parts
    }

    /// A joint and its body, that ends where its last child begins.
    fn link(
        &mut self,
        robot: &Robot,
        children: &[Vec<usize>],
        body: usize,
        start: Vector,
        parts: &mut Vec<Part>,
    ) -> Vector {
        if start != ZERO && !self.local {
            self.given += 1;
            parts.push(Part::Massless(start));
        }
        if robot.bodies[body].pose.turn != IDENTITY && !self.local {
            self.slots += 1;
            parts.push(Part::Weld(body));
        }
        let end = children[body].last().map_or(ZERO, |last| robot.bodies[*last].pose.place);
        parts.extend([Part::Joint(body), Part::Body(body, end)]);
        (self.joints[body], self.bodies[body]) = (self.slots, self.given);
        self.slots += 1;
        self.given += 1;
        end
    }

    /// Keeps a chain, in tuples that are short enough, and tells its number.
    fn close(&mut self, mut parts: Vec<Part>) -> usize {
        while parts.len() > LONGEST {
            // Rests are cut off from the tip on, each beginning with a joint if it can; the first one cut is as long as a tuple.
            let least = parts.len() - LONGEST;
            let begins = |at: &usize| matches!(parts[*at], Part::Weld(_) | Part::Joint(_));
            let turned = |at: usize| at > 0 && matches!(parts[at - 1], Part::Weld(_));
            let cut = (least.max(1)..parts.len()).find(|at| begins(at) && !turned(*at)).unwrap_or(least.max(1));
            let rest = parts.split_off(cut);
            let number = self.keep(rest);
            parts.push(Part::Rest(number));
        }
        self.keep(parts)
    }

    fn keep(&mut self, parts: Vec<Part>) -> usize {
        let first = parts.iter().find_map(|part| match part {
            Part::Joint(joint) => Some(*joint),
            _ => None,
        });
        self.arms.push(Arm { parts, first, in_pairs: self.local });
        self.arms.len() - 1
    }
}
