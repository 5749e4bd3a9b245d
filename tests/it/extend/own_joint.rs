//! A geared motor: a rotor of inertia J that turns n times as fast as the joint, I = n² J.

use super::geared::Geared;
use catena::loading::Unloaded;
use catena::paper::{GeneralizedAlpha, Scheme};
use catena::planar::{self, Clamped, Dop853, Free, Pin, Rod, System};
use catena::scalar::Jet;
use catena::{Error, Fault, Scalar, spatial};
use catena_oracle::near;
use core::f64::consts::FRAC_PI_2;

const GRAVITY: f64 = 9.81;
const ROTOR: f64 = 2e-4;
const RATIOS: [f64; 2] = [60.0, 40.0];
const FRICTION: f64 = 0.3;

/// A motor of ratio `n` on kinematics of a kind.
fn motor<T: Scalar, K>(kinematics: K, rotor: T, ratio: f64, friction: f64) -> Geared<T, K> {
    Geared { kinematics, rotor, ratio: T::literal(ratio), friction: T::literal(friction) }
}

/// Two uniform links of one metre and one kilogram, driven in the plane.
macro_rules! arm {
    ($T:ty, $rotor:expr, $friction:expr) => {{
        let one = <$T as Scalar>::literal(1.0);
        let zero = <$T as Scalar>::literal(0.0);
        let hinge = planar::Revolute::smooth();
        let [first, second] = RATIOS.map(|ratio| motor::<$T, _>(hinge, $rotor, ratio, $friction));
        let rod = Rod::uniform(one, one);
        System::new(Clamped::at(zero, zero, zero), (first, rod, second, rod), Free)
            .map(|arm| arm.with_gravity(<$T as Scalar>::literal(GRAVITY)))
    }};
}

/// The same about z in space.
macro_rules! arm_in_space {
    ($friction:expr) => {{
        let hinge = spatial::Revolute::about([0.0, 0.0, 1.0]);
        let [first, second] = RATIOS.map(|ratio| motor(hinge, ROTOR, ratio, $friction));
        let tensor = [[0.01, 0.0, 0.0], [0.0, 1.0 / 12.0, 0.0], [0.0, 0.0, 1.0 / 12.0]];
        let link = spatial::RigidBody::new(1.0, tensor, [0.5, 0.0, 0.0], [1.0, 0.0, 0.0]);
        spatial::System::new(spatial::Clamped::origin(), (first, link, second, link), spatial::Free)
            .map(|arm| arm.with_gravity([0.0, -GRAVITY, 0.0]))
    }};
}

/// Lagrange's equations of that arm in relative angles: mass matrix, and all other forces.
fn by_hand([p, q]: [f64; 2], [u, v]: [f64; 2], rotor: f64, friction: f64) -> ([[f64; 2]; 2], [f64; 2]) {
    let (angle, rate) = (p + q, u + v); // of the outer link, absolute
    let (s, c) = q.sin_cos();
    let [i, j] = RATIOS.map(|n| rotor * n * n);
    let (a, b, d) = (4.0 / 3.0, 0.5 * c, 1.0 / 3.0);
    let inner = 0.5 * s * rate * rate - 1.5 * GRAVITY * p.cos();
    let outer = -0.5 * s * u * u - 0.5 * GRAVITY * angle.cos();
    let mass = [[a + 2.0 * b + d + i, b + d], [b + d, d + j]];
    (mass, [inner + outer - friction * u, outer - friction * v])
}

fn solve([[a, b], [c, d]]: [[f64; 2]; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    let determinant = a * d - b * c;
    [(d * x - b * y) / determinant, (a * y - c * x) / determinant]
}

const STATES: [([f64; 2], [f64; 2]); 3] =
    [([-1.0, 0.5], [0.0, 0.0]), ([0.3, -2.0], [1.0, -2.5]), ([2.1, 1.1], [-0.7, 3.0])];

#[test]
fn accelerations_are_those_of_equations_by_hand() -> Result<(), Error> {
    let (plane, space) = (arm!(f64, ROTOR, FRICTION)?, arm_in_space!(FRICTION)?);
    for (angles, rates) in STATES {
        let (mass, forces) = by_hand(angles, rates, ROTOR, FRICTION);
        let expected = solve(mass, forces);
        let mut start = plane.motion();
        (start.position_mut().1.0, start.position_mut().1.2) = (angles[0], angles[1]);
        let motion = plane.with_accelerations(plane.with_rates(start, &rates)?, &Unloaded)?;
        let start = space.with_rates(space.at_rest(&angles)?, &rates)?;
        let other = space.with_accelerations(start, &Unloaded)?;
        let found = [motion.acceleration().1, other.acceleration().1].map(|a| [a.0, a.2]);
        for (k, x) in expected.into_iter().enumerate() {
            near(found[0][k], x, 1e-13 * (1.0 + x.abs()));
            near(found[1][k], x, 1e-13 * (1.0 + x.abs()));
        }
    }
    Ok(())
}

/// The torque that a joint passes on is friction less what its rotor takes to accelerate, and a motor may be told which it must be.
#[test]
fn forces_are_those_of_the_equations() -> Result<(), Error> {
    let arm = arm!(f64, ROTOR, FRICTION)?;
    for (angles, rates) in STATES {
        let mut start = arm.motion();
        (start.position_mut().1.0, start.position_mut().1.2) = (angles[0], angles[1]);
        let motion = arm.with_accelerations(arm.with_rates(start, &rates)?, &Unloaded)?;
        let a = motion.acceleration().1;
        let stations = arm.stations(&motion, &Unloaded)?;
        for (k, (station, a)) in [(0, a.0), (2, a.2)].into_iter().enumerate() {
            let torque = stations.get(station).map_or(f64::NAN, |station| station.torque_outboard());
            near(torque, -FRICTION * rates[k] - ROTOR * RATIOS[k] * RATIOS[k] * a, 1e-12);
        }
    }
    Ok(())
}

/// Torques of drives act on the coordinates; transfer matrices know them and the rotors.
#[test]
fn drives_and_matrices_know_of_the_rotors() -> Result<(), Error> {
    let arm = arm!(f64, ROTOR, FRICTION)?;
    let drives = [0.0, 3.0, -1.5]; // the root's joint is a weld
    let loads = planar::Loads::none().in_joints(|_, joint, _: &planar::JointMotion<f64>| drives[joint]);
    for (angles, rates) in STATES {
        let (mass, [f, g]) = by_hand(angles, rates, ROTOR, FRICTION);
        let expected = solve(mass, [f + drives[1], g + drives[2]]);
        let mut start = arm.motion();
        (start.position_mut().1.0, start.position_mut().1.2) = (angles[0], angles[1]);
        let motion = arm.with_accelerations(arm.with_rates(start, &rates)?, &loads)?;
        let a = motion.acceleration().1;
        near(a.0, expected[0], 1e-13 * (1.0 + expected[0].abs()));
        near(a.2, expected[1], 1e-13 * (1.0 + expected[1].abs()));
        let (found, stations) = (arm.root_state(&motion, &loads)?, arm.stations(&motion, &loads)?);
        let expected = stations.get(0).map(|station| station.acceleration_state());
        for index in 0..6 {
            near(found[index], expected.map_or(f64::NAN, |state| state[index]), 1e-11);
        }
    }
    Ok(())
}

/// With the tip of its arm on a pin, closure forces pass through the motor, too.
#[test]
fn a_motor_in_a_loop_is_a_flywheel_there() -> Result<(), Error> {
    let (rod, hinge, tip) = (Rod::uniform(1.0, 1.0), planar::Revolute::smooth(), planar::Pinned::at(1.5, 0.3));
    let flywheel = planar::RigidBody::new(0.0, ROTOR * RATIOS[0] * RATIOS[0], [0.0; 2], [0.0; 2]);
    let clamp = Clamped::at(0.0, 0.0, 0.0);
    let own =
        System::new(clamp, (motor(hinge, ROTOR, RATIOS[0], 0.0), rod, Pin, rod, Pin, rod), tip)?.with_gravity(GRAVITY);
    let composed = System::new(clamp, (hinge, flywheel, rod, Pin, rod, Pin, rod), tip)?.with_gravity(GRAVITY);
    let one = own.with_accelerations(own.assembled(own.at_rest(&[-1.0, 0.2, 1.3])?, &Unloaded)?, &Unloaded)?;
    let two =
        composed.with_accelerations(composed.assembled(composed.at_rest(&[-1.0, 0.2, 1.3])?, &Unloaded)?, &Unloaded)?;
    assert!(one.acceleration().1.0.abs() > 0.1);
    near(one.position().1.0, two.position().1.0, 1e-12);
    near(one.acceleration().1.0, two.acceleration().1.0, 1e-11);
    for (found, expected) in one.multipliers().iter().zip(two.multipliers()) {
        near(*found, *expected, 1e-11);
    }
    Ok(())
}

/// The formulation of 2005 has no matrix for reflected inertia, and says so.
#[test]
fn the_paper_refuses_rotors() -> Result<(), Error> {
    let arm = arm!(f64, ROTOR, FRICTION)?;
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).start(&arm, &arm.motion(), &Unloaded, 0.01);
    let error = scheme.map(|_| ()).unwrap_err();
    assert_eq!(error.fault, Fault::Unsupported { what: "reflected inertia in a joint" });
    Ok(())
}

#[test]
fn energy_stays_and_friction_takes_what_it_says() -> Result<(), Error> {
    let (plane, space) = (arm!(f64, ROTOR, 0.0)?, arm_in_space!(0.0)?);
    let rule = || Dop853::tolerance(1e-13);
    let start = plane.at_rest(&[-0.4, 0.9])?;
    let (energy, mut drift) = (plane.budget(&start)?.energy(), 0.0_f64);
    plane.simulate(start, rule(), 10.0, |now| drift = drift.max((now.budget().energy() - energy).abs()))?;
    let start = space.at_rest(&[-0.4, 1.3])?;
    let (energy, mut other) = (space.budget(&start)?.energy(), 0.0_f64);
    space.simulate(start, rule(), 10.0, |now| other = other.max((now.budget().energy() - energy).abs()))?;
    println!("energy drifts by {drift:e} J in the plane and {other:e} J in space in 10 s");
    assert!(drift < 1e-11 && other < 1e-11);
    Ok(())
}

/// ω² of M⁻¹ K at rest, hanging: K = g [[3/2 + 1/2, 1/2], [1/2, 1/2]].
#[test]
fn modes_know_of_the_rotors() -> Result<(), Error> {
    let ([[a, b], [c, d]], _) = by_hand([-FRAC_PI_2, 0.0], [0.0; 2], ROTOR, 0.0);
    let stiffness = [[2.0 * GRAVITY, 0.5 * GRAVITY], [0.5 * GRAVITY, 0.5 * GRAVITY]];
    let determinant = a * d - b * c;
    let trace = (d * stiffness[0][0] - 2.0 * b * stiffness[0][1] + a * stiffness[1][1]) / determinant;
    let product = (stiffness[0][0] * stiffness[1][1] - stiffness[0][1] * stiffness[1][0]) / determinant;
    let root = (0.25 * trace * trace - product).sqrt();
    let expected = [0.5 * trace - root, 0.5 * trace + root].map(f64::sqrt);
    let (plane, space) = (arm!(f64, ROTOR, 0.0)?, arm_in_space!(0.0)?);
    let in_plane = plane.modes(&plane.at_rest(&[-FRAC_PI_2; 2])?, &Unloaded)?;
    let in_space = space.modes(&space.at_rest(&[-FRAC_PI_2, 0.0])?, &Unloaded)?;
    for (k, omega) in expected.into_iter().enumerate() {
        for modes in [&in_plane, &in_space] {
            let found = modes.get(k).map_or(f64::NAN, |mode| mode.frequency());
            println!("mode {k}: {found} {omega}");
            near(found, omega, 1e-10 * omega);
        }
    }
    Ok(())
}

/// On the ground a motor is the same as a flywheel with the inertia n² J on its link.
#[test]
fn on_the_ground_it_is_a_flywheel() -> Result<(), Error> {
    let (rod, hinge) = (Rod::uniform(1.0, 1.0), planar::Revolute::smooth());
    let reflected = ROTOR * RATIOS[0] * RATIOS[0];
    let flywheel = planar::RigidBody::new(0.0, reflected, [0.0; 2], [0.0; 2]);
    let clamp = Clamped::at(0.0, 0.0, 0.0);
    let own = System::new(clamp, (motor(hinge, ROTOR, RATIOS[0], 0.0), rod, Pin, rod), Free)?.with_gravity(GRAVITY);
    let composed = System::new(clamp, (hinge, flywheel, rod, Pin, rod), Free)?.with_gravity(GRAVITY);
    let rates = [1.5, -2.0];
    let one = own.with_accelerations(own.with_rates(own.at_rest(&[-0.4, 0.9])?, &rates)?, &Unloaded)?;
    let two = composed.with_accelerations(composed.with_rates(composed.at_rest(&[-0.4, 0.9])?, &rates)?, &Unloaded)?;
    near(one.acceleration().1.0, two.acceleration().1.0, 1e-13);
    near(one.acceleration().1.2, two.acceleration().1.3, 1e-13);
    let (budget, other) = (own.budget(&one)?, composed.budget(&two)?);
    near(budget.kinetic, other.kinetic, 1e-13);
    near(budget.potential, other.potential, 1e-13);
    let (force, expected) =
        (own.stations(&one, &Unloaded)?.root().internal, composed.stations(&two, &Unloaded)?.root().internal);
    near((force.force - expected.force).norm(), 0.0, 1e-12);
    near(-force.torque, -expected.torque - reflected * one.acceleration().1.0, 1e-12);
    let hanging = [-FRAC_PI_2; 2];
    let rest = own.equilibrium(own.at_rest(&[-1.5, -1.7])?, &Unloaded)?;
    near(own.angles(&rest)?.body::<1>().copied().unwrap_or(f64::NAN), -FRAC_PI_2, 1e-13);
    let (modes, expected) =
        (own.modes(&own.at_rest(&hanging)?, &Unloaded)?, composed.modes(&composed.at_rest(&hanging)?, &Unloaded)?);
    for (found, expected) in modes.frequencies().zip(expected.frequencies()) {
        println!("{found} {expected}");
        near(found, expected, 1e-10 * expected);
    }
    Ok(())
}

/// M a = f, so ∂a/∂J = −M⁻¹ diag(n²) a.
#[test]
fn derivatives_by_the_inertia_of_the_rotor() -> Result<(), Error> {
    type Dual = Jet<f64, 1>;
    let arm = arm!(Dual, Dual::seed(ROTOR, 0), FRICTION)?;
    for (angles, rates) in STATES {
        let (mass, forces) = by_hand(angles, rates, ROTOR, FRICTION);
        let a = solve(mass, forces);
        let expected = solve(mass, [-RATIOS[0] * RATIOS[0] * a[0], -RATIOS[1] * RATIOS[1] * a[1]]);
        let mut start = arm.motion();
        (start.position_mut().1.0, start.position_mut().1.2) = (Dual::of(angles[0]), Dual::of(angles[1]));
        let motion = arm.with_accelerations(arm.with_rates(start, &rates.map(Dual::of))?, &Unloaded)?;
        let found = motion.acceleration().1;
        for (found, expected) in [found.0, found.2].into_iter().zip(expected) {
            near(found.eps[0], expected, 1e-12 * (1.0 + expected.abs()));
        }
    }
    Ok(())
}
