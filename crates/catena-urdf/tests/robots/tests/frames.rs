//! Frames of the modules stand in the scenes where the description puts their links, at joints that are not at zero.

use catena::system::Position;
use catena_urdf::{Carrier, Frames, Options, Robot};
use catena_urdf_robots::{arm7, arm7_local, humanoid, humanoid_local, quadruped, quadruped_local};
use std::error::Error;

type Vector = [f64; 3];
type Matrix = [[f64; 3]; 3];

fn angle(joint: usize) -> f64 {
    0.9 * (1.9 * joint as f64 + 0.4).sin()
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|k| (0..3).map(|j| a[i][j] * b[j][k]).sum()))
}

fn moved(place: Vector, turn: &Matrix, by: Vector) -> Vector {
    std::array::from_fn(|i| place[i] + (0..3).map(|k| turn[i][k] * by[k]).sum::<f64>())
}

/// Rodrigues' formula.
fn about([x, y, z]: Vector, angle: f64) -> Matrix {
    let (s, c) = angle.sin_cos();
    let d = 1.0 - c;
    [
        [c + d * x * x, d * x * y - s * z, d * x * z + s * y],
        [d * x * y + s * z, c + d * y * y, d * y * z - s * x],
        [d * x * z - s * y, d * y * z + s * x, c + d * z * z],
    ]
}

/// Place and axes of a link, joint by joint in the axes that the description gives.
fn expected(robot: &Robot, link: &str) -> Option<(Vector, Matrix)> {
    let one = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mut bodies: Vec<(Vector, Matrix)> = vec![];
    for (k, body) in robot.bodies().iter().enumerate() {
        let (place, turn) = body.parent.map_or(([0.0; 3], one), |parent| bodies[parent]);
        let place = moved(place, &turn, body.pose.place);
        let turn = product(&turn, &body.pose.turn);
        bodies.push(match body.slides {
            true => (moved(place, &turn, body.axis.map(|x| angle(k) * x)), turn),
            false => (place, product(&turn, &about(body.axis, angle(k)))),
        });
    }
    let frame = robot.frames().iter().find(|frame| frame.name == link)?;
    let (place, turn) = match frame.carrier {
        Carrier::Body(body) => bodies[body],
        Carrier::Base | Carrier::Ground => ([0.0; 3], one),
    };
    Some((moved(place, &turn, frame.pose.place), product(&turn, &frame.pose.turn)))
}

macro_rules! stand {
    ($($test:ident: $file:literal $name:ident, $options:expr, $skip:literal, $($frame:ident),*;)*) => {$(
        #[test]
        fn $test() -> Result<(), Box<dyn Error>> {
            let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../robots/", $file, ".urdf");
            let robot = $options.frames(Frames::AsWritten).read(&std::fs::read_to_string(path)?)?;
            let scene = $name::scene::<f64>()?;
            let mut motion = scene.motion();
            // Place and attitude of a floating base stay.
            let mut count = 0;
            Position::replace(motion.position_mut(), &mut |x: f64| {
                count += 1;
                if count > $skip { angle(count - $skip - 1) } else { x }
            });
            let bodies = scene.body_motions(&motion)?;
            for frame in [$($name::frame::$frame),*] {
                let (place, turn) = expected(&robot, frame.name).ok_or("no such link")?;
                let body = bodies.get(frame.body.ok_or("on the ground")?).ok_or("no such body")?;
                let found = body.point(frame.place).place;
                let columns = [0, 1, 2].map(|k| body.turned(frame.turn.map(|row| row[k])));
                for i in 0..3 {
                    assert!((found[i] - place[i]).abs() < 1e-14, "{}: {found:?} {place:?}", frame.name);
                    for k in 0..3 {
                        assert!((columns[k][i] - turn[i][k]).abs() < 1e-14, "{}: {columns:?} {turn:?}", frame.name);
                    }
                }
            }
            Ok(())
        }
    )*};
}

stand! {
    tools_stand_on_their_arm: "arm7" arm7, Options::new(), 0, FOREARM_HIGH, CAMERA, TOOL_TIP;
    tools_stand_on_their_arm_in_body_axes: "arm7" arm7_local, Options::new(), 0, SHOULDER, FOREARM_HIGH, CAMERA, TOOL_TIP;
    feet_stand_on_their_legs: "quadruped" quadruped, Options::new().snap(1e-4), 7, IMU, LF_FOOT, RH_FOOT;
    feet_stand_on_their_legs_in_body_axes: "quadruped" quadruped_local, Options::new().snap(1e-4), 7, IMU, LF_FOOT, RH_FOOT;
    eyes_and_soles_stand_where_they_should:
        "humanoid" humanoid, Options::new().base(catena_urdf::Base::Floating), 7, LEFT_SOLE, LEFT_FINGER, RIGHT_PALM, EYES;
    eyes_and_soles_stand_there_in_body_axes:
        "humanoid" humanoid_local, Options::new().base(catena_urdf::Base::Floating), 7, LEFT_SOLE, LEFT_FINGER, RIGHT_PALM, EYES;
}
