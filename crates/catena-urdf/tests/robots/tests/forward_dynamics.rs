//! Accelerations of the scenes that the modules make, against M⁻¹ (τ − bias) of the description's own plain dynamics, at random states
//! under random torques.

use catena::spatial::{Loads, Wrench};
use catena::system::{Position, Rate};
use catena_urdf::{Base, Laws, Options, Robot, State, solve};
use catena_urdf_robots::{arm7, cart, humanoid, odd_names, quadruped};
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

/// A unit quaternion, and its axes as columns.
fn attitude(noise: &mut Noise) -> ([f64; 4], [[f64; 3]; 3]) {
    let [w, x, y, z] = noise.list::<4>(1.0);
    let length = (w * w + x * x + y * y + z * z).sqrt();
    let [w, x, y, z] = [w, x, y, z].map(|number| number / length);
    let turn = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ];
    ([w, x, y, z], turn)
}

/// What a scene says: accelerations from positions, rates, a wrench on its first body, torques.
type Answer = Result<Vec<f64>, catena::Error>;

/// The largest difference, relative to the largest acceleration.
fn compare(
    robot: &Robot,
    scene: impl Fn(&[f64], &[f64], Wrench<f64>, &[f64]) -> Answer,
) -> Result<f64, Box<dyn Error>> {
    let mut noise = Noise(1);
    let mut worst = 0.0_f64;
    let joints = robot.bodies().len();
    for _ in 0..STATES {
        let mut state = State::zero(robot);
        state.q.fill_with(|| 3.0 * noise.next());
        state.rates.fill_with(|| 3.0 * noise.next());
        let (mut positions, mut rates, mut forces) = (vec![], vec![], vec![]);
        let mut wrench = Wrench::default();
        if robot.base().is_some() {
            let (quaternion, turn) = attitude(&mut noise);
            state.place = noise.list(2.0);
            state.attitude = turn;
            state.base_rates = [noise.list(2.0), noise.list(2.0)];
            positions.extend(state.place.into_iter().chain(quaternion));
            rates.extend(state.base_rates.into_iter().flatten());
            let (force, torque): ([f64; 3], [f64; 3]) = (noise.list(100.0), noise.list(30.0));
            forces.extend(force.into_iter().chain(torque));
            let turned: [f64; 3] = std::array::from_fn(|i| (0..3).map(|k| turn[i][k] * torque[k]).sum());
            wrench = Wrench { force: force.into(), torque: turned.into() };
        }
        positions.extend(&state.q);
        rates.extend(&state.rates);
        let torques: Vec<_> = (0..joints).map(|_| 20.0 * noise.next()).collect();
        forces.extend(torques.iter().zip(robot.law_forces(&state.q, &state.rates)).map(|(torque, law)| torque + law));

        let bias = robot.inverse_dynamics(&state, &vec![0.0; forces.len()], robot.gravity());
        let right: Vec<_> = forces.iter().zip(bias).map(|(force, bias)| force - bias).collect();
        let expected = solve(&robot.mass_matrix(&state), &right).map_err(|row| format!("no pivot in row {row}"))?;
        let answer = scene(&positions, &rates, wrench, &torques)?;
        assert_eq!(answer.len(), expected.len());
        let largest = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        for (x, right) in answer.iter().zip(&expected) {
            worst = worst.max((x - right).abs() / largest);
        }
    }
    Ok(worst)
}

macro_rules! agrees {
    ($($test:ident: $file:literal $name:ident, $options:expr;)*) => {$(
        #[test]
        fn $test() -> Result<(), Box<dyn Error>> {
            let path = concat!(env!("CARGO_MANIFEST_DIR"), "/", $file, ".urdf");
            let robot = $options.read(&std::fs::read_to_string(path)?)?;
            let scene = $name::scene::<f64>()?;
            let worst = compare(&robot, |positions, rates, wrench, torques| {
                let mut motion = scene.motion();
                let (mut positions, mut rates) = (positions.iter(), rates.iter());
                Position::replace(motion.position_mut(), &mut |x: f64| *positions.next().unwrap_or(&x));
                Rate::replace(motion.rate_mut(), &mut |x: f64| *rates.next().unwrap_or(&x));
                let efforts = $name::efforts(std::array::from_fn(|k| torques[k]));
                let mut wrenches = vec![Wrench { force: [0.0; 3].into(), torque: [0.0; 3].into() }; scene.bodies()];
                wrenches[0] = wrench;
                let moved = scene.with_accelerations(motion, &Loads::none().efforts(efforts).wrenches(wrenches))?;
                let mut found = vec![];
                Rate::visit(moved.acceleration(), &mut |x: f64| found.push(x));
                Ok(found)
            })?;
            println!("{}: {} joints, {worst:.1e}", robot.name(), robot.bodies().len());
            assert!(worst < TOLERANCE, "{worst:e}");
            Ok(())
        }
    )*};
}

agrees! {
    the_arm_accelerates_as_its_description_says: "../../robots/arm7" arm7, Options::new();
    the_quadruped_accelerates_as_its_description_says: "../../robots/quadruped" quadruped, Options::new().snap(1e-4);
    the_humanoid_accelerates_as_its_description_says: "../../robots/humanoid" humanoid, Options::new().base(Base::Floating);
    the_cart_accelerates_as_its_description_says: "../../robots/cart" cart, Options::new().repair();
    odd_names_and_many_fingers_change_nothing: "odd.names" odd_names,
        Options::new().laws(Laws::none().damping().friction([0.1; 2]).stops([0.02; 2], [1.0; 2]));
}

#[test]
fn a_scene_in_single_precision_is_the_same_scene() -> Result<(), Box<dyn Error>> {
    let (single, double) = (arm7::scene::<f32>()?, arm7::scene::<f64>()?);
    let (single, double) = (
        single.with_accelerations(single.motion(), &Loads::none().efforts(arm7::efforts([1.0; 7])))?,
        double.with_accelerations(double.motion(), &Loads::none().efforts(arm7::efforts([1.0; 7])))?,
    );
    let (mut found, mut expected) = (vec![], vec![]);
    Rate::visit(single.acceleration(), &mut |x: f32| found.push(f64::from(x)));
    Rate::visit(double.acceleration(), &mut |x: f64| expected.push(x));
    let largest = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (x, right) in found.iter().zip(&expected) {
        assert!((x - right).abs() < 1e-3 * largest, "{found:?} {expected:?}");
    }
    Ok(())
}
