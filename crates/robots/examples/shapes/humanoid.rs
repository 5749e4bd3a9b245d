//! The humanoid's shape: what of it can touch the ground, and what a picture shows.

use catena::robot::{Contact, Contacts, Plane};
use catena_robots::humanoid::{self, frame as of};

pub type Ground = Contacts<[(usize, [f64; 3]); POINTS], Plane<f64>, Contact<f64>>;
const POINTS: usize = 28;
/// Angles at which it begins, others are zero: knees a little bent, arms lifted to the front.
pub const START: [(&str, f64); 14] = [
    ("left_hip_pitch", -0.25),
    ("right_hip_pitch", -0.2),
    ("left_knee", 0.5),
    ("right_knee", 0.4),
    ("left_ankle_pitch", -0.25),
    ("right_ankle_pitch", -0.2),
    ("left_shoulder_pitch", -0.3),
    ("right_shoulder_pitch", -0.5),
    ("left_shoulder_roll", 0.25),
    ("right_shoulder_roll", -0.25),
    ("left_elbow", 0.6),
    ("right_elbow", 0.9),
    ("neck_yaw", 0.2),
    ("waist_yaw", 0.1),
];

/// A place in axes of a frame of the description, as a body and a place in its axes. A frame of the ground has no body: contacts refuse it.
pub fn point(frame: humanoid::Frame, place: [f64; 3]) -> (usize, [f64; 3]) {
    let along = |row: [f64; 3]| row.iter().zip(place).map(|(a, b)| a * b).sum::<f64>();
    (frame.body.unwrap_or(usize::MAX), core::array::from_fn(|k| frame.place[k] + along(frame.turn[k])))
}

/// What can touch the ground: corners of the soles, knees, hips, back and front of the trunk, elbows, hands, head.
pub fn ground() -> Ground {
    let sole = |frame, x, y| point(frame, [x, y, 0.0]);
    let points = [
        sole(of::LEFT_SOLE, 0.11, 0.035),
        sole(of::LEFT_SOLE, 0.11, -0.035),
        sole(of::LEFT_SOLE, -0.08, 0.03),
        sole(of::LEFT_SOLE, -0.08, -0.03),
        sole(of::RIGHT_SOLE, 0.11, 0.035),
        sole(of::RIGHT_SOLE, 0.11, -0.035),
        sole(of::RIGHT_SOLE, -0.08, 0.03),
        sole(of::RIGHT_SOLE, -0.08, -0.03),
        point(of::LEFT_SHIN, [0.06, 0.0, 0.0]),
        point(of::RIGHT_SHIN, [0.06, 0.0, 0.0]),
        point(of::LEFT_HIP_BLOCK, [0.0, 0.06, 0.0]),
        point(of::RIGHT_HIP_BLOCK, [0.0, -0.06, 0.0]),
        point(of::PELVIS, [-0.09, 0.0, -0.06]),
        point(of::PELVIS, [0.08, 0.0, -0.04]),
        point(of::CHEST, [0.1, 0.08, 0.22]),
        point(of::CHEST, [0.1, -0.08, 0.22]),
        point(of::CHEST, [-0.09, 0.08, 0.22]),
        point(of::CHEST, [-0.09, -0.08, 0.22]),
        point(of::LEFT_SHOULDER_BLOCK, [0.0, 0.05, 0.0]),
        point(of::RIGHT_SHOULDER_BLOCK, [0.0, -0.05, 0.0]),
        point(of::LEFT_FOREARM, [-0.03, 0.0, 0.0]),
        point(of::RIGHT_FOREARM, [-0.03, 0.0, 0.0]),
        point(of::LEFT_PALM, [0.13, 0.0, 0.0]),
        point(of::RIGHT_PALM, [0.13, 0.0, 0.0]),
        point(of::HEAD, [0.1, 0.0, 0.08]),
        point(of::HEAD, [-0.08, 0.0, 0.09]),
        point(of::HEAD, [0.02, 0.07, 0.1]),
        point(of::HEAD, [0.02, -0.07, 0.1]),
    ];
    // Stiffness (N/m) that sets in over a depth (m), damping (s/m), coefficient of friction and the speed of creeping (m/s).
    Contacts::of(points, Plane::level(0.0), Contact::new(4e4, 1e-3).damped(1.5).rubbing(0.7, 1e-3))
}

/// Lines that show the robot, those farther away first, through origins of links and other points of them.
pub fn strokes() -> [Vec<(usize, [f64; 3])>; 8] {
    let at = |frame| point(frame, [0.0; 3]);
    let sole = |frame| [point(frame, [-0.08, 0.0, 0.0]), point(frame, [0.11, 0.0, 0.0])];
    let foot = |ankle, frame| {
        let [heel, toe] = sole(frame);
        vec![at(ankle), heel, toe, at(ankle)]
    };
    [
        vec![at(of::LEFT_HIP_BLOCK), at(of::LEFT_THIGH), at(of::LEFT_SHIN), at(of::LEFT_ANKLE_CROSS)],
        foot(of::LEFT_ANKLE_CROSS, of::LEFT_SOLE),
        vec![
            at(of::LEFT_SHOULDER_BLOCK),
            at(of::LEFT_UPPER_ARM),
            at(of::LEFT_FOREARM),
            at(of::LEFT_WRIST),
            point(of::LEFT_PALM, [0.13, 0.0, 0.0]),
        ],
        // The trunk: hips, shoulders, and back.
        vec![
            at(of::LEFT_HIP_BLOCK),
            at(of::RIGHT_HIP_BLOCK),
            at(of::WAIST_YOKE),
            at(of::CHEST),
            at(of::RIGHT_SHOULDER_BLOCK),
            at(of::LEFT_SHOULDER_BLOCK),
            at(of::CHEST),
            at(of::WAIST_YOKE),
            at(of::LEFT_HIP_BLOCK),
        ],
        vec![
            point(of::CHEST, [0.0, 0.0, 0.3]),
            at(of::HEAD),
            point(of::HEAD, [-0.08, 0.0, 0.08]),
            point(of::HEAD, [0.02, 0.0, 0.18]),
            point(of::HEAD, [0.1, 0.0, 0.08]),
            at(of::HEAD),
        ],
        vec![at(of::RIGHT_HIP_BLOCK), at(of::RIGHT_THIGH), at(of::RIGHT_SHIN), at(of::RIGHT_ANKLE_CROSS)],
        foot(of::RIGHT_ANKLE_CROSS, of::RIGHT_SOLE),
        vec![
            at(of::RIGHT_SHOULDER_BLOCK),
            at(of::RIGHT_UPPER_ARM),
            at(of::RIGHT_FOREARM),
            at(of::RIGHT_WRIST),
            point(of::RIGHT_PALM, [0.13, 0.0, 0.0]),
        ],
    ]
}
