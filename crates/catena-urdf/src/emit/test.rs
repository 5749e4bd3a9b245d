//! The test of a module: mass matrix and forces at one state, as numbers.

use super::plan::Plan;
use super::{number, numbers};
use crate::algebra::quaternion;
use crate::dynamics::{sample, solve};
use crate::robot::Robot;
use std::fmt::Write;

/// How far accelerations of a right module may be off: 1e-8, or rounding of the forces, of which columns of the mass matrix are part, over
/// the inertia that they move, where that is very small.
fn tolerance(mass: &[Vec<f64>], forces: &[f64]) -> f64 {
    let unit = |k: usize| (0..forces.len()).map(|i| if i == k { 1.0 } else { 0.0 }).collect::<Vec<_>>();
    let mut errors = vec![0.0; forces.len()];
    for (k, force) in forces.iter().enumerate() {
        let size = mass[k].iter().fold(force.abs(), |size, x| size.max(x.abs()));
        for (error, x) in errors.iter_mut().zip(solve(mass, &unit(k)).unwrap_or_default()) {
            *error += 64.0 * f64::EPSILON * size * x.abs();
        }
    }
    errors.into_iter().fold(1e-8, f64::max)
}

/// The test.
pub fn module(robot: &Robot, plan: &Plan) -> String {
    let state = sample(robot);
    let offset = robot.base_freedoms();
    let count = offset + robot.bodies.len();
    // Accelerations unlike each other.
    let accelerations: Vec<f64> = (0..count).map(|k| 1.0 - 0.37 * (k % 7) as f64).collect();
    let mut forces = robot.inverse_dynamics(&state, &accelerations, robot.gravity);
    let laws = robot.law_forces(&state.q, &state.rates);
    forces[offset..].iter_mut().zip(laws).for_each(|(force, law)| *force -= law);
    let mass = robot.mass_matrix(&state);
    let error = tolerance(&mass, &forces);
    let attitude = quaternion(&state.attitude);
    let (mut positions, mut rates) = (Vec::new(), Vec::new());
    if offset == 6 {
        positions.extend(state.place.into_iter().chain(attitude));
        rates.extend(state.base_rates.into_iter().flatten());
    }
    positions.extend(&state.q);
    rates.extend(&state.rates);

    let mut text = "#[cfg(test)]\nmod tests {\n    use catena::system::{Position, Rate};\n".to_owned();
    text += if offset == 6 {
        "    use catena::spatial::{Loads, Rotation, Wrench};\n\n    \
         /// Place, attitude (a quaternion) and joints.\n"
    } else {
        "    use catena::spatial::Loads;\n\n    /// Joints.\n"
    };
    let mut constant = |title: &str, name: &str, values: &[f64]| {
        let title = if title.is_empty() { String::new() } else { format!("    /// {title}\n") };
        let _ = writeln!(text, "{title}    const {name}: [f64; {}] = {};", values.len(), numbers(values));
    };
    constant("", "POSITIONS", &positions);
    constant("Their rates.", "RATES", &rates);
    constant("And accelerations.", "ACCELERATIONS", &accelerations);
    constant("What these accelerations take, by a recursion that shares nothing with the library.", "FORCES", &forces);
    let rows: Vec<_> = mass.iter().map(|row| format!("        {},\n", numbers(row))).collect();
    let _ = writeln!(
        text,
        "    /// The mass matrix.\n    const MASS: [[f64; {count}]; {count}] = [\n{}    ];\n",
        rows.concat()
    );
    let (split, loads) = if offset == 6 {
        let ([w, x, y, z], bodies) = (attitude.map(number), plan.given);
        (
            format!(
                "            // A force in axes of the ground, a torque in axes of the base.\n            \
                 let attitude = Rotation::from_quaternion([{w}, {x}, {y}, {z}])?;\n            \
                 let [fx, fy, fz, tx, ty, tz, torques @ ..] = forces;\n            \
                 let mut wrenches = [Wrench {{ force: [0.0; 3].into(), torque: [0.0; 3].into() }}; {bodies}];\n            \
                 wrenches[0] = Wrench {{ force: [fx, fy, fz].into(), torque: attitude.turned([tx, ty, tz]).into() }};\n"
            ),
            "Loads::none().efforts(super::efforts(torques)).wrenches(wrenches)",
        )
    } else {
        (String::new(), "Loads::none().efforts(super::efforts(forces))")
    };
    let _ = write!(
        text,
        "    #[test]\n    fn forces_cause_the_accelerations_that_they_take() -> Result<(), catena::Error> {{\n        \
         let scene = super::scene::<f64>()?;\n        let mut motion = scene.motion();\n        \
         let (mut positions, mut rates) = (POSITIONS.into_iter(), RATES.into_iter());\n        \
         Position::replace(motion.position_mut(), &mut |x| positions.next().unwrap_or(x));\n        \
         Rate::replace(motion.rate_mut(), &mut |x| rates.next().unwrap_or(x));\n        \
         // A column of the mass matrix more is one acceleration more by one. What is off is rounding of the forces over the\n        \
         // least inertia that a joint moves.\n        \
         for more in 0..=MASS.len() {{\n            \
         let column = MASS.get(more).copied().unwrap_or([0.0; {count}]);\n            \
         let forces: [f64; {count}] = core::array::from_fn(|k| FORCES[k] + column[k]);\n{split}            \
         let moved = scene.with_accelerations(motion, &{loads})?;\n            \
         let mut k = 0;\n            \
         Rate::visit(moved.acceleration(), &mut |x: f64| {{\n                \
         let right = ACCELERATIONS[k] + if k == more {{ 1.0 }} else {{ 0.0 }};\n                \
         assert!((x - right).abs() < {error:e}, \"coordinate {{k}}, column {{more}}: {{x}}, not {{right}}\");\n                \
         k += 1;\n            }});\n        }}\n        Ok(())\n    }}\n}}\n"
    );
    text
}
