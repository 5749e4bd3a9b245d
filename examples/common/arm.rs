//! An arm with six revolute joints on a turntable, and a way from pose to pose that it is to go.

use catena::spatial::*;
use catena::system::MotionOf;
use nalgebra::Vector3;

pub type Hinge = Named<Revolute<f64>>;
/// Shoulder, upper arm, forearm, two links of the wrist and the hand, with what it holds.
pub type Chain = (
    RigidBody<f64>,
    Hinge,
    RigidBody<f64>,
    Hinge,
    RigidBody<f64>,
    Hinge,
    RigidBody<f64>,
    Hinge,
    RigidBody<f64>,
    Hinge,
    (Named<RigidBody<f64>>, PointMass<f64>),
);
/// The arm stands on a turntable.
pub type Turntable = Named<Hinged<[f64; 3], Rotation<f64>, f64>>;
pub type Arm = System<f64, Turntable, Chain, Free>;
pub type ArmMotion = MotionOf<Spatial<f64>, Turntable, Chain, Free>;
pub type Joints = [f64; 6];

pub const LEG: f64 = 1.2; // from one pose to the next (s)
/// Axes of the joints, each in axes of the link before it, which all coincide where all angles are zero.
pub const AXES: [[f64; 3]; 6] =
    [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
pub const NAMES: [&str; 6] = ["turntable", "shoulder", "elbow", "forearm", "wrist", "hand"];
/// Angles of the joints (rad): ready, above, at the load, across, and down.
pub const POSES: [Joints; 5] = [
    [0.0, -1.2, 1.6, 0.0, 0.4, 0.0],
    [0.8, -0.6, 1.3, 0.5, 0.7, -0.5],
    [0.8, -0.1, 1.0, 0.5, 0.9, -0.5],
    [-0.9, -0.9, 1.4, -0.6, 0.5, 1.0],
    [-0.9, -0.2, 1.1, 0.0, 0.8, 1.5],
];
/// A cylinder along the way to the next joint: way (m), radius (m), mass (kg).
fn link(way: [f64; 3], radius: f64, mass: f64) -> RigidBody<f64> {
    let way = Vector3::from(way);
    let (square, along) = (way.norm_squared(), way.normalize());
    let tensor = core::array::from_fn(|i| {
        core::array::from_fn(|k| {
            let (one, both) = (if i == k { 1.0 } else { 0.0 }, along[i] * along[k]);
            mass * (0.5 * radius * radius * both + (0.25 * radius * radius + square / 12.0) * (one - both))
        })
    });
    RigidBody::new(mass, tensor, (way * 0.5).into(), way.into())
}

pub fn arm(load: f64) -> Result<Arm, catena::Error> {
    let joint = |k: usize| Revolute::about(AXES[k]).named(NAMES[k]);
    let hand = (link([0.12, 0.0, 0.0], 0.04, 0.8).named("hand"), PointMass::new(0.05, load));
    let chain = (
        link([0.0, 0.0, 0.45], 0.12, 15.0),
        joint(1),
        link([0.55, 0.0, 0.0], 0.08, 9.0),
        joint(2),
        link([0.3, 0.0, 0.0], 0.07, 5.0),
        joint(3),
        link([0.2, 0.0, 0.0], 0.06, 2.5),
        joint(4),
        link([0.1, 0.0, 0.0], 0.05, 1.2),
        joint(5),
        hand,
    );
    Ok(System::new(Hinged::at([0.0; 3], AXES[0]).named(NAMES[0]), chain, Free)?.with_gravity([0.0, 0.0, -9.81]))
}

/// Angles, rates and accelerations wanted at a time: from pose to pose by polynomials of fifth degree, at rest in each.
pub fn wanted(time: f64) -> [Joints; 3] {
    let leg = ((time / LEG) as usize).min(POSES.len() - 2);
    let s = (time / LEG - leg as f64).min(1.0);
    let way = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
    let rate = 30.0 * s * s * (1.0 - s) * (1.0 - s) / LEG;
    let second = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / (LEG * LEG);
    let step = |k: usize| POSES[leg + 1][k] - POSES[leg][k];
    let of = |factor: f64| core::array::from_fn(|k| factor * step(k));
    [core::array::from_fn(|k| POSES[leg][k] + way * step(k)), of(rate), of(second)]
}

/// Positions and rates of the joints.
pub fn state(motion: &ArmMotion) -> Result<[Joints; 2], catena::Error> {
    let (mut angles, mut rates) = ([0.0; 6], [0.0; 6]);
    motion.coordinates_into(&mut angles)?;
    motion.rates_into(&mut rates)?;
    Ok([angles, rates])
}
