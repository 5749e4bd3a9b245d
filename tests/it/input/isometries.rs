//! Attitudes and places from nalgebra's types and back: bits of quaternions, points seen through frames, derivatives.

use catena::nalgebra::{Isometry3, Matrix3, Point3, Rotation3, Translation3, UnitQuaternion, Vector3};
use catena::num_dual::Dual64;
use catena::spatial::Columns;
use catena::spatial::*;
use catena::{Elementary, Scalar};
use std::error::Error;

use catena_oracle::Noise;

fn quaternion(noise: &mut Noise) -> UnitQuaternion<f64> {
    UnitQuaternion::from_scaled_axis(Vector3::from_fn(|_, _| 3.0 * noise.next()))
}

#[test]
fn quaternions_come_and_go_bit_by_bit() {
    let mut noise = Noise::new(1);
    for _ in 0..100 {
        let theirs = quaternion(&mut noise);
        let ours = Rotation::from(theirs);
        assert_eq!(ours.quaternion(), [theirs.w, theirs.i, theirs.j, theirs.k]);
        assert_eq!(UnitQuaternion::from(ours), theirs);
        // Theirs turns vectors by its own formula.
        let vector = Vector3::from_fn(|_, _| noise.next());
        assert!((Vector3::from(ours.turned(vector.into())) - theirs * vector).norm() < 1e-15);
        let matrix = Rotation3::from(theirs);
        assert!((Rotation3::from(ours).matrix() - matrix.matrix()).norm() < 1e-15);
        assert!(UnitQuaternion::from(Rotation::from(matrix)).angle_to(&theirs) < 1e-7); // an arc cosine near one
        let columns = Columns::from(*matrix.matrix());
        assert_eq!(columns.y, matrix * Vector3::y());
        assert_eq!(&Matrix3::from(columns), matrix.matrix());
    }
    let angles: [f64; 3] = [0.4, -0.7, 1.1]; // theirs are roll, pitch and yaw: the same 1-2-3
    let theirs = UnitQuaternion::from_euler_angles(angles[0], angles[1], angles[2]);
    for (ours, angle) in Rotation::from(theirs).angles().into_iter().zip(angles) {
        assert!((ours - angle).abs() < 1e-15);
    }
}

#[test]
fn a_scene_hangs_where_an_isometry_puts_it_and_is_read_as_one() -> Result<(), Box<dyn Error>> {
    let mut noise = Noise::new(2);
    let rod = Rod::uniform(0.7, 0.05, 1.0);
    for _ in 0..20 {
        let place = Translation3::new(noise.next(), noise.next(), noise.next());
        let wall = Isometry3::from_parts(place, quaternion(&mut noise));
        let bent = quaternion(&mut noise);
        let scene = System::new(Clamped::from(wall), (rod, Weld::at(bent.into()), rod), Free)?;
        let bodies = scene.body_motions(&scene.motion())?;
        let outer = bodies.get(1).ok_or("two bodies")?;
        let expected = wall * Translation3::new(0.7, 0.0, 0.0) * bent;
        let found = Isometry3::from(*outer);
        let corner = Point3::new(0.3, -0.2, 0.5);
        assert!((found * corner - expected * corner).norm() < 1e-15);
        let tip = Isometry3::from(outer.outboard());
        assert!((tip * corner - expected * (corner + Vector3::new(0.7, 0.0, 0.0))).norm() < 1e-15);
        // A frame of it rests there.
        let frame = Frame::from(expected);
        assert!((frame.place - outer.inboard.place).norm() < 1e-15 && frame.velocity == Vector3::zeros());
        assert!((frame.turn.attitude.z - outer.inboard.turn.attitude.z).norm() < 1e-15);
    }
    Ok(())
}

#[test]
fn positions_of_bodies_that_float_or_hang_on_balls_are_set_by_them() -> Result<(), Box<dyn Error>> {
    let pose = Isometry3::new(Vector3::new(0.1, -0.4, 2.0), Vector3::new(0.3, 0.2, -1.0));
    let plate = RigidBody::new(1.0, [[0.2, 0.0, 0.0], [0.0, 0.3, 0.0], [0.0, 0.0, 0.4]], [0.0; 3], [0.1, 0.0, 0.0]);
    let scene = System::new(Free, plate, Free)?;
    let mut start = scene.motion();
    start.position_mut().0 = (pose.translation.into(), pose.rotation.into());
    let found = Isometry3::from(*scene.body_motions(&start)?.get(0).ok_or("a body")?);
    assert!((found.translation.vector - pose.translation.vector).norm() < 1e-15);
    assert!((found.rotation.coords.abs() - pose.rotation.coords.abs()).norm() < 1e-15);

    let scene = System::new(Pinned::from(pose.translation.vector), plate, Free)?;
    let mut start = scene.motion();
    start.position_mut().0 = pose.rotation.into();
    let found = Isometry3::from(*scene.body_motions(&start)?.get(0).ok_or("a body")?);
    assert!((found.inverse() * pose).translation.vector.norm() < 1e-15);
    Ok(())
}

#[test]
fn numbers_with_derivatives_come_over_too() {
    let angle = Dual64::from(0.3).derivative();
    let half = angle.scale(0.5).sin_cos();
    let o = Dual64::from(0.0);
    let Ok(ours) = Rotation::from_quaternion([half.1, o, o, half.0]) else { panic!("a unit quaternion") };
    let theirs = UnitQuaternion::from(ours);
    // Normalising multiplies a few roundings into numbers of 0.5.
    assert!((theirs.w.eps - -0.5 * 0.15_f64.sin()).abs() < 4e-16);
    assert!((theirs.k.eps - 0.5 * 0.15_f64.cos()).abs() < 4e-16);
    assert!(Scalar::is_identical(Rotation::from(theirs).quaternion()[3], theirs.k));
}
