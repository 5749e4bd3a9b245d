//! Attitudes and axes that are held are not met by half a turn, where n sin θ and axis × axis vanish, too.

use catena::loading::Unloaded;
use catena::spatial::*;
use catena::system::Tip;
use catena::{Error, Fault};
use catena_oracle::near;
use core::f64::consts::PI;
use nalgebra::Vector3;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

fn rod(length: f64) -> Rod<f64> {
    Rod::uniform(length, 0.05, 1.0)
}

/// A guess: attitudes of three rods by angles, the last along x and rolled by half a turn; of a fourth, which is not turned.
const ROLLED: [f64; 12] = [0.3, 0.2, 0.7, -0.5, 0.4, -0.9, PI, 0.0, 0.0, 0.0, 0.0, 0.0];

/// Where three rods end at that guess.
fn end() -> Result<[f64; 3], Error> {
    let chain = System::new(Pinned::origin(), (rod(0.5), Ball, rod(0.6), Ball, rod(0.7)), Free)?;
    Ok(chain.stations(&chain.at_rest(&ROLLED[..9])?, &Unloaded)?.tip().frame.place.into())
}

/// How far an axis of the last of three rods is from that of the ground, or of a fourth rod, at the start and at the end of a run, where the
/// guess closes at all.
macro_rules! apart {
    ($scene:expr, $angles:expr, $axis:expr) => {{
        let (scene, angles): (_, &[f64]) = (&$scene, &$angles);
        match scene.assembled(scene.at_rest(angles)?, &Unloaded) {
            Ok(start) => {
                let end = scene.simulate(start.clone(), Rk4::step(0.01), 0.5, |_| ())?.motion;
                let mut apart = [0.0; 2];
                for (apart, motion) in apart.iter_mut().zip([start, end]) {
                    let bodies = scene.body_motions(&motion)?;
                    let axis = |body: &BodyMotion<f64>| body.outboard().turn.attitude.apply(Vector3::from($axis));
                    let held = bodies.get(4).map_or(Vector3::from($axis), axis);
                    *apart = bodies.get(2).map_or(f64::NAN, |body| (axis(body) - held).norm());
                }
                apart
            }
            Err(Error { fault: Fault::NotClosed { residual }, .. }) if residual > 1.0 => [0.0; 2],
            Err(error) => return Err(error),
        }
    }};
}

#[test]
fn tips_are_not_held_upside_down() -> Result<(), Error> {
    let chain = (rod(0.5), Ball, rod(0.6), Ball, rod(0.7));
    let clamped = System::new(Pinned::origin(), chain, Clamped::at(end()?, Rotation::identity()))?;
    let hinged = System::new(Pinned::origin(), chain, Hinged::at(end()?, Z))?;
    let angles = &ROLLED[..9];
    for [start, end] in [apart!(clamped, angles, X), apart!(clamped, angles, Z), apart!(hinged, angles, Z)] {
        near(start, 0.0, 1e-13);
        near(end, 0.0, 1e-12);
    }
    Ok(())
}

#[test]
fn loops_are_not_closed_upside_down() -> Result<(), Error> {
    let main = (Ball, rod(0.5), Ball, rod(0.6), Ball, rod(0.7));
    let [x, y, z] = end()?;
    let side = (RigidBody::massless([x - 0.4, y, z]), Ball, rod(0.4));
    let (weld, hinge) = (Weld::at(Rotation::identity()), Revolute::about(Z));
    let welded = System::new(Clamped::origin(), Network::new(main, side, weld), Free)?;
    let hinged = System::new(Clamped::origin(), Network::new(main, side, hinge), Free)?;
    for [start, end] in [apart!(welded, ROLLED, X), apart!(welded, ROLLED, Z), apart!(hinged, ROLLED, Z)] {
        near(start, 0.0, 1e-13);
        near(end, 0.0, 1e-12);
    }
    Ok(())
}

/// Nearby, what a tip misses is linear in its axes. The paper's scheme asks so of derivatives of axes, which are no rotation: half of them
/// are farther than a third of a turn from any, by the sign of what rounding left.
#[test]
fn residuals_nearby_are_linear_in_axes() {
    let held = Rotation::from_angles([0.3, -0.2, 0.1]);
    let (clamp, hinge) = (Clamped::at([0.0; 3], held), Hinged::on(Clamped::at([0.0; 3], held), X));
    let of_ground = Rotation::matrix(&held);
    let own = [[0.3, -0.9, 0.2], [-0.7, 0.1, 0.4], [0.5, 0.6, -0.8]].map(Vector3::from);
    for sign in [1.0, -1.0] {
        let [x, y, z] = own.map(|axis| axis * sign);
        let still = Frame::resting(Vector3::from([0.1, 0.2, 0.3]));
        let tip = Frame { turn: Turn { attitude: Columns { x, y, z }, ..still.turn }, ..still };
        let sine = (of_ground.x.cross(&x) + of_ground.y.cross(&y) + of_ground.z.cross(&z)) * 0.5;
        let clamped = Tip::<Spatial<f64>>::linear_residual(&clamp, 0.0, &tip);
        let hinged = Tip::<Spatial<f64>>::linear_residual(&hinge, 0.0, &tip);
        for k in 0..3 {
            near(clamped[k], still.place[k], 1e-16);
            near(hinged[k], still.place[k], 1e-16);
            near(clamped[3 + k], sine[k], 1e-15);
        }
        for (k, found) in hinged.into_iter().enumerate().skip(3) {
            let unit = core::array::from_fn(|j| if j == k { 1.0 } else { 0.0 });
            let normal = Tip::<Spatial<f64>>::internal(&hinge, 0.0, &unit).torque;
            near(found, normal.dot(&of_ground.x.cross(&x)), 1e-15);
        }
    }
}
