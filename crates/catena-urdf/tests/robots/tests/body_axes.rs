//! Robots in body axes: accelerations under random torques against M⁻¹ (τ − bias) of the description's own plain dynamics, functions of
//! lists, and the same robot with no zero known by type.

use catena::system::Rate;
use catena_urdf::{Base, Elements, Options, Robot, State, solve};
use catena_urdf_robots::{
    arm7, arm7_general, arm7_local, cart_general, cart_local, humanoid_general, humanoid_local, quadruped_general,
    quadruped_local,
};
use std::error::Error;

const STATES: usize = 100;
/// Relative to the largest acceleration: rounding, 2e-16, times the condition of mass matrices of thirty joints.
const TOLERANCE: f64 = 1e-11;

/// Numbers in (−1, 1), by the multiplier of L'Ecuyer for 64 bits.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(3_935_559_000_370_003_845).wrapping_add(2_691_343_689_449_507_681);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
    fn list<const N: usize>(&mut self, size: f64) -> [f64; N] {
        std::array::from_fn(|_| size * self.next())
    }
}

/// The largest difference relative to the largest number.
fn off(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(f64::MIN_POSITIVE, |most, x| most.max(x.abs()));
    found.iter().zip(expected).fold(0.0, |worst, (x, y)| f64::max(worst, (x - y).abs() / largest))
}

/// A state of the joints, and of a base that floats.
fn state(robot: &Robot, noise: &mut Noise) -> (State, Vec<f64>, Vec<f64>) {
    let mut state = State::zero(robot);
    let (mut positions, mut rates) = (vec![], vec![]);
    if robot.base().is_some() {
        state.place = noise.list(1.0);
        let list = noise.list::<4>(1.0);
        let length = list.iter().map(|x| x * x).sum::<f64>().sqrt();
        let [w, x, y, z] = list.map(|number| number / length);
        state.attitude = [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ];
        state.base_rates = [noise.list(2.0), noise.list(2.0)];
        positions.extend(state.place.into_iter().chain([w, x, y, z]));
        rates.extend(state.base_rates.into_iter().flatten());
    }
    state.q.fill_with(|| 3.0 * noise.next());
    state.rates.fill_with(|| 3.0 * noise.next());
    positions.extend(&state.q);
    rates.extend(&state.rates);
    (state, positions, rates)
}

/// Accelerations of a module's scene.
macro_rules! accelerations {
    ($name:ident, $positions:expr, $rates:expr, $torques:expr) => {{
        let scene = $name::scene::<f64>()?;
        let mut motion = scene.motion();
        motion.set_coordinates($positions)?;
        let motion = scene.with_rates(motion, $rates)?;
        let moved = scene.with_accelerations(motion, &catena::robot::Torques($torques))?;
        let mut found = vec![];
        Rate::visit(moved.acceleration(), &mut |x: f64| found.push(x));
        found
    }};
}

macro_rules! agrees {
    ($($test:ident: $file:literal $local:ident $general:ident, $options:expr;)*) => {$(
        #[test]
        fn $test() -> Result<(), Box<dyn Error>> {
            let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../robots/", $file, ".urdf");
            let robot = $options.elements(Elements::Local).read(&std::fs::read_to_string(path)?)?;
            let (mut noise, mut worst, mut apart) = (Noise(7), 0.0_f64, 0.0_f64);
            for _ in 0..STATES {
                let (state, positions, rates) = state(&robot, &mut noise);
                let torques: [f64; $local::JOINTS.len()] = noise.list(20.0);
                let bias = robot.inverse_dynamics(&state, &vec![0.0; rates.len()], robot.gravity());
                let forces = std::iter::repeat_n(0.0, robot.base_freedoms()).chain(torques);
                let right: Vec<_> = forces.zip(bias).map(|(force, bias)| force - bias).collect();
                let expected = solve(&robot.mass_matrix(&state), &right).map_err(|row| format!("no pivot in row {row}"))?;
                let found = accelerations!($local, &positions, &rates, torques);
                let other = accelerations!($general, &positions, &rates, torques);
                worst = worst.max(off(&found, &expected));
                apart = apart.max(off(&found, &other));
            }
            println!("{}: {} joints, {worst:.1e}, with no zeros known {apart:.1e}", robot.name(), robot.bodies().len());
            assert!(worst < TOLERANCE && apart < TOLERANCE, "{worst:e} {apart:e}");
            Ok(())
        }
    )*};
}

agrees! {
    the_arm_accelerates: "arm7" arm7_local arm7_general, Options::new();
    the_quadruped_accelerates: "quadruped" quadruped_local quadruped_general, Options::new().snap(1e-4);
    the_humanoid_accelerates: "humanoid" humanoid_local humanoid_general, Options::new().base(Base::Floating);
    the_cart_accelerates: "cart" cart_local cart_general, Options::new().repair();
}

#[test]
fn functions_of_lists_are_those_of_the_description() -> Result<(), Box<dyn Error>> {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../robots/arm7.urdf"))?;
    let robot = Options::new().elements(Elements::Local).read(&text)?;
    let (scene, mut noise) = (arm7_local::scene::<f64>()?, Noise(9));
    for _ in 0..STATES {
        let (state, ..) = state(&robot, &mut noise);
        let (q, v): ([f64; 7], [f64; 7]) =
            (state.q.clone().try_into().unwrap(), state.rates.clone().try_into().unwrap());
        let x: [f64; 7] = noise.list(5.0);
        let forces = robot.inverse_dynamics(&state, &x, robot.gravity());
        assert!(off(&scene.inverse_dynamics(&q, &v, &x)?, &forces) < 1e-13);
        assert!(off(scene.mass_matrix(&q)?.as_flattened(), &robot.mass_matrix(&state).concat()) < 1e-13);
        let torques: [f64; 7] = forces.clone().try_into().unwrap();
        assert!(off(&scene.forward_dynamics(&q, &v, &torques)?, &x) < TOLERANCE);
    }
    Ok(())
}

#[test]
fn a_run_in_body_axes_is_that_in_inertial_axes() -> Result<(), Box<dyn Error>> {
    use catena::spatial::Dop853;
    let (local, inertial) = (arm7_local::scene::<f64>()?, arm7::scene::<f64>()?);
    let (q, v) = ([0.3, 0.8, -0.4, 1.1, 0.2, -0.7, 0.5], [0.1; 7]);
    let first = local.simulate(local.at_joints(&q, &v)?, Dop853::tolerance(1e-13), 0.2, |_| ())?;
    let second = inertial.simulate(inertial.at_joints(&q, &v)?, Dop853::tolerance(1e-13), 0.2, |_| ())?;
    let apart = off(&first.motion.coordinates(), &second.motion.coordinates());
    println!("{apart:.1e}");
    assert!(apart < 1e-12, "{apart:e}");
    Ok(())
}
