//! An independent check of accelerations in space: inverse dynamics by hand.
//!
//! From coordinates, rates and accelerations follow the accelerations of all mass centres, and from these the forces and moments in the
//! joints, with 3 × 3 matrices and nothing of the library. Accelerations are right if and only if no moment acts in a ball, and
//! none about the axis of a revolute joint, but for what rounding makes of it.

use nalgebra::{Matrix3, Quaternion, Rotation3, Unit, UnitQuaternion, Vector3};

/// A body: mass, tensor about its mass centre, mass centre and outboard end, in its own axes.
#[derive(Clone)]
pub struct Body {
    pub mass: f64,
    pub about_centre: [[f64; 3]; 3],
    pub centre: [f64; 3],
    pub outboard: [f64; 3],
}

/// The joint at the inboard end of each body.
#[derive(Clone, Copy)]
pub enum Joint {
    /// Coordinates: a quaternion; rates in axes of the body.
    Ball,
    /// About an axis.
    Revolute([f64; 3]),
}

/// Motion of a body.
struct Moving {
    attitude: Matrix3<f64>,
    axis: Option<Vector3<f64>>,
    spin: Vector3<f64>,
    angular: Vector3<f64>,
    /// Acceleration of the inboard end.
    linear: Vector3<f64>,
}

/// The moments that act where none may, in a chain of equal bodies with gravity g along −y: for accelerations `second`.
pub fn moments(body: &Body, joints: &[Joint], g: f64, position: &[f64], rate: &[f64], second: &[f64]) -> Vec<f64> {
    let (centre, outboard) = (Vector3::from(body.centre), Vector3::from(body.outboard));
    let tensor = Matrix3::from(body.about_centre); // symmetric
    let chain = moving(outboard, joints, g, position, rate, second);
    let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
    let mut moments = Vec::new();
    for Moving { attitude, axis, spin, angular, linear } in chain.iter().rev() {
        let (r, d, inertia) = (attitude * centre, attitude * outboard, attitude * tensor * attitude.transpose());
        let own = body.mass * (linear + relative(spin, angular, &r));
        let turning = inertia * angular + spin.cross(&(inertia * spin));
        moment += turning + r.cross(&own) + d.cross(&force);
        force += own;
        match axis {
            Some(n) => moments.push(n.dot(&moment)),
            None => moments.extend_from_slice(moment.as_slice()),
        }
    }
    moments
}

/// Acceleration of a point of a body, at the vector d, relative to its inboard end.
fn relative(spin: &Vector3<f64>, angular: &Vector3<f64>, d: &Vector3<f64>) -> Vector3<f64> {
    angular.cross(d) + spin.cross(&spin.cross(d))
}

fn moving(
    outboard: Vector3<f64>,
    joints: &[Joint],
    g: f64,
    position: &[f64],
    rate: &[f64],
    second: &[f64],
) -> Vec<Moving> {
    let (mut position, mut rate, mut second) = (position.iter(), rate.iter(), second.iter());
    let (mut attitude, mut spin, mut angular) = (Matrix3::identity(), Vector3::zeros(), Vector3::zeros());
    let mut linear = Vector3::new(0.0, g, 0.0);
    let mut chain = Vec::new();
    for joint in joints {
        let mut axis = None;
        match joint {
            Joint::Ball => {
                let [w, x, y, z] = std::array::from_fn(|_| next(&mut position));
                let quaternion = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z));
                attitude = quaternion.to_rotation_matrix().into_inner();
                spin = attitude * Vector3::from_fn(|_, _| next(&mut rate));
                angular = attitude * Vector3::from_fn(|_, _| next(&mut second));
            }
            Joint::Revolute(about) => {
                let about = Unit::new_normalize(Vector3::from(*about));
                let n = attitude * *about;
                let turning = n * next(&mut rate);
                attitude *= Rotation3::from_axis_angle(&about, next(&mut position)).into_inner();
                angular += n * next(&mut second) + spin.cross(&turning);
                spin += turning;
                axis = Some(n);
            }
        }
        chain.push(Moving { attitude, axis, spin, angular, linear });
        linear += relative(&spin, &angular, &(attitude * outboard));
    }
    chain
}

fn next<'a>(numbers: &mut impl Iterator<Item = &'a f64>) -> f64 {
    numbers.next().copied().unwrap_or(f64::NAN)
}
