//! Accelerations and reactions of trees, in the plane and in space, against a dense system of Newton-Euler equations in which the
//! plane is nothing special.

mod plane;
mod space;

use catena::planar::Branch;
use catena_oracle::Noise;
use catena_oracle::space as oracle;
use catena_oracle::space::{Answer, Vector};

/// Relative to the largest acceleration or reaction: a hundred times what rounding leaves in dense systems of 400 equations.
const TOLERANCE: f64 = 1e-12;

/// Joints and bodies without arms.
type Twig<J, B> = Vec<(J, B)>;
/// Joints and bodies with twigs.
type Bough<J, B> = Vec<(J, B, Vec<Branch<Twig<J, B>>>)>;
/// Joints and bodies with boughs.
type Trunk<J, B> = Vec<(J, B, Vec<Branch<Bough<J, B>>>)>;

/// Grows a tree at random, and its twin for the oracle.
struct Grower<J, B> {
    noise: Noise,
    joint: J,
    make: fn(&mut Noise) -> (B, oracle::Body),
    parents: Vec<Option<usize>>,
    twins: Vec<oracle::Body>,
}

impl<J: Copy, B> Grower<J, B> {
    fn new(seed: u64, joint: J, make: fn(&mut Noise) -> (B, oracle::Body)) -> Self {
        Self { noise: Noise::new(seed), joint, make, parents: vec![], twins: vec![] }
    }

    /// A number from `least` to `most`.
    fn count(&mut self, least: usize, most: usize) -> usize {
        least + (self.noise.between(0.0, (most - least) as f64 + 0.999) as usize)
    }

    /// A body on another one, and its number.
    fn body(&mut self, parent: Option<usize>) -> (B, usize) {
        let (body, twin) = (self.make)(&mut self.noise);
        self.parents.push(parent);
        self.twins.push(twin);
        (body, self.twins.len() - 1)
    }

    fn twig(&mut self, mut at: usize) -> Branch<Twig<J, B>> {
        let links = self.count(1, 3);
        let mut link = || {
            let (body, number) = self.body(Some(at));
            at = number;
            (self.joint, body)
        };
        Branch((0..links).map(|_| link()).collect())
    }

    fn bough(&mut self, mut at: usize) -> Branch<Bough<J, B>> {
        let links = self.count(1, 3);
        let mut link = || {
            let (body, number) = self.body(Some(at));
            at = number;
            let twigs = self.count(0, 2);
            (self.joint, body, (0..twigs).map(|_| self.twig(number)).collect())
        };
        Branch((0..links).map(|_| link()).collect())
    }

    /// The first body, the trunk on it, and the number of its last body.
    fn tree(&mut self) -> (B, Trunk<J, B>, usize) {
        let (first, mut at) = self.body(None);
        let links = self.count(2, 4);
        let mut link = || {
            let (body, number) = self.body(Some(at));
            at = number;
            let boughs = self.count(0, 2);
            (self.joint, body, (0..boughs).map(|_| self.bough(number)).collect())
        };
        let trunk = (0..links).map(|_| link()).collect();
        (first, trunk, at)
    }
}

/// What a scene finds, as vectors of space.
struct Found {
    linear: Vec<Vector>,
    angular: Vec<Vector>,
    /// Force, torque ON the outboard part and place of every station of the chain.
    stations: Vec<[Vector; 3]>,
    root: [Vector; 2],
    tip: [Vector; 2],
}

impl Found {
    /// The largest difference from the oracle, relative to the largest number there. `inboard` are the stations at the inboard ends of
    /// bodies; the one before each is that of its joint, if it has one.
    fn difference(&self, answer: &Answer, inboard: &[usize]) -> f64 {
        let size = answer.linear.iter().chain(&answer.angular).chain(&answer.forces).chain(&answer.torques);
        let size = size.fold(1.0_f64, |size, v| size.max(v.amax()));
        let mut worst = 0.0_f64;
        let mut note = |found: Vector, expected: Vector| worst = worst.max((found - expected).amax() / size);
        assert_eq!((self.linear.len(), inboard.len()), (answer.linear.len(), answer.linear.len()));
        for (k, at) in inboard.iter().copied().enumerate() {
            note(self.linear[k], answer.linear[k]);
            note(self.angular[k], answer.angular[k]);
            let [force, torque, place] = self.stations[at];
            note(force, answer.forces[k]);
            note(torque, answer.torques[k]);
            let joint = at.checked_sub(1).filter(|at| !inboard.contains(at));
            let [joint_force, joint_torque, joint_place] = joint.map_or(self.stations[at], |at| self.stations[at]);
            note(joint_force, answer.forces[k]);
            note(joint_torque, answer.torques[k] + (place - joint_place).cross(&answer.forces[k]));
        }
        note(self.root[0], answer.forces[0]);
        note(self.root[1], answer.torques[0]);
        note(self.tip[0], answer.tip[0]);
        note(self.tip[1], answer.tip[1]);
        worst
    }
}

/// Stations at the inboard ends of bodies where each but the first has a joint of its own.
fn alternating(bodies: usize) -> Vec<usize> {
    (0..bodies).map(|k| 2 * k).collect()
}

/// Ends a test that knows its largest difference.
#[track_caller]
fn conclude(worst: f64) {
    println!("largest relative difference {worst:.1e}");
    assert!(worst < TOLERANCE, "{worst:.1e}");
}
