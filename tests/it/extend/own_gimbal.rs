//! A gimbal of two geared motors, against the library's universal joint, whose joints are told what the rotors do as efforts: τ = −I q̈ − c q̇.

use super::geared::Geared;
use super::gimbal::Gimbal;
use catena::extend::check_element;
use catena::scalar::Jet;
use catena::spatial::*;
use catena::system::{Position, Rate};
use catena::{Error, Scalar};
use catena_oracle::near;
use nalgebra::{Matrix4, Vector4};

const GRAVITY: [f64; 3] = [9.81, 0.5, -0.3];
const ROTOR: f64 = 2e-4;
const RATIOS: [f64; 4] = [60.0, 40.0, 25.0, 30.0];
const FRICTION: f64 = 0.3;
/// Axes of both joints: two of them are neither those of a body nor at right angles.
const AXES: [[f64; 3]; 4] = [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.2, 0.9, 0.3], [0.6, -0.1, 0.8]];
const STATES: [([f64; 4], [f64; 4]); 2] =
    [([0.4, -0.7, 0.9, 0.3], [1.5, -2.0, 0.7, 1.1]), ([-1.1, 0.2, -0.5, 1.3], [-0.8, 1.2, 2.1, -1.7])];

/// Two joints, a rigid body and a rod.
macro_rules! scene {
    ($T:ty, $gravity:expr, $one:expr, $two:expr) => {{
        let of = |x: f64| <$T as Scalar>::literal(x);
        let inertia = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]].map(|row| row.map(of));
        let plate = RigidBody::new(of(1.3), inertia, [0.4, 0.03, -0.02].map(of), [0.8, 0.1, -0.1].map(of));
        let rod = Rod::uniform(of(0.7), of(0.02), of(0.9));
        System::new(Clamped::origin(), ($one, plate, $two, rod), Free).map(|scene| scene.with_gravity($gravity.map(of)))
    }};
}
macro_rules! own {
    ($T:ty, $rotor:expr, $friction:expr, $gravity:expr) => {{
        let of = |x: f64| <$T as Scalar>::literal(x);
        let motor = |k: usize| Geared {
            kinematics: Revolute::about(AXES[k].map(of)),
            rotor: $rotor,
            ratio: of(RATIOS[k]),
            friction: of($friction),
        };
        scene!($T, $gravity, Gimbal::of(motor(0), motor(1)), Gimbal::of(motor(2), motor(3)))
    }};
}
macro_rules! universal {
    ($T:ty, $gravity:expr) => {{
        let axes = AXES.map(|axis| axis.map(<$T as Scalar>::literal));
        scene!($T, $gravity, Universal::about(axes[0], axes[1]), Universal::about(axes[2], axes[3]))
    }};
}
/// A scene in a state.
macro_rules! at {
    ($scene:expr, $places:expr, $rates:expr) => {{
        let mut start = $scene.motion();
        let mut numbers = $places.into_iter();
        Position::replace(start.position_mut(), &mut |old| numbers.next().unwrap_or(old));
        $scene.with_rates(start, &$rates)?
    }};
}

/// The numbers of rates or accelerations.
fn numbers<T: Scalar>(rate: &impl Rate<T>) -> Vec<T> {
    let mut numbers = vec![];
    rate.visit(&mut |x| numbers.push(x));
    numbers
}

fn inertia() -> [f64; 4] {
    RATIOS.map(|ratio| ratio * ratio * ROTOR)
}

/// Efforts in the joints of the scene with universal joints: none at the ground.
fn efforts(tau: [f64; 4]) -> [Effort<f64>; 3] {
    [Effort([0.0; 3]), Effort([tau[0], tau[1], 0.0]), Effort([tau[2], tau[3], 0.0])]
}

/// Accelerations of the scene with universal joints under efforts.
fn under(places: [f64; 4], rates: [f64; 4], tau: [f64; 4], gravity: [f64; 3]) -> Result<Vector4<f64>, Error> {
    let scene = universal!(f64, gravity)?;
    let motion = scene.with_accelerations(at!(scene, places, rates), &Loads::none().efforts(efforts(tau)))?;
    Ok(Vector4::from_column_slice(&numbers(motion.acceleration())))
}

/// M⁻¹ of the scene with universal joints, by what unit efforts do.
fn inverse_mass(places: [f64; 4], gravity: [f64; 3]) -> Result<Matrix4<f64>, Error> {
    let none = under(places, [0.0; 4], [0.0; 4], gravity)?;
    let mut inverse = Matrix4::zeros();
    for k in 0..4 {
        let mut tau = [0.0; 4];
        tau[k] = 1.0;
        inverse.set_column(k, &(under(places, [0.0; 4], tau, gravity)? - none));
    }
    Ok(inverse)
}

/// Solves (1 + M⁻¹ I) x = b.
fn with_rotors(inverse: &Matrix4<f64>, b: Matrix4<f64>) -> Matrix4<f64> {
    let whole = Matrix4::identity() + inverse * Matrix4::from_diagonal(&inertia().into());
    whole.lu().solve(&b).unwrap_or(b * f64::NAN)
}

#[test]
fn it_moves_and_pulls_as_a_universal_joint_with_the_rotors_efforts() -> Result<(), Error> {
    let (own, other) = (own!(f64, ROTOR, FRICTION, GRAVITY)?, universal!(f64, GRAVITY)?);
    for (places, rates) in STATES {
        let moving = own.with_accelerations(at!(own, places, rates), &Unloaded)?;
        let a = numbers(moving.acceleration());
        let free = under(places, rates, rates.map(|rate| -FRICTION * rate), GRAVITY)?;
        let expected = with_rotors(&inverse_mass(places, GRAVITY)?, Matrix4::from_columns(&[free; 4]));
        for k in 0..4 {
            near(a[k], expected[(k, 0)], 1e-11 * (1.0 + free.amax()));
        }
        let tau = core::array::from_fn(|k| -inertia()[k] * a[k] - FRICTION * rates[k]);
        let loads = Loads::none().efforts(efforts(tau));
        let same = other.with_accelerations(at!(other, places, rates), &loads)?;
        let (found, expected) = (own.stations(&moving, &Unloaded)?, other.stations(&same, &loads)?);
        let [found, expected] = [found.root().internal, expected.root().internal];
        near((found.force - expected.force).norm(), 0.0, 1e-10);
        near((found.torque - expected.torque).norm(), 0.0, 1e-10);
        let (budget, without) = (own.budget(&moving)?, other.budget(&same)?);
        let of_rotors: f64 = inertia().iter().zip(rates).map(|(inertia, rate)| 0.5 * inertia * rate * rate).sum();
        near(budget.kinetic, without.kinetic + of_rotors, 1e-12);
        near(budget.potential, without.potential, 1e-12);
    }
    Ok(())
}

#[test]
fn it_passes_the_check_of_elements() -> Result<(), Error> {
    assert_eq!(check_element(&own!(f64, ROTOR, FRICTION, GRAVITY)?, 8), Ok(()));
    Ok(())
}

/// (M + I) a = f, so ∂a/∂J = −(M + I)⁻¹ diag(n²) a.
#[test]
fn derivatives_by_the_inertia_of_the_rotors() -> Result<(), Error> {
    type Dual = Jet<f64, 1>;
    let own = own!(Dual, Dual::seed(ROTOR, 0), FRICTION, GRAVITY)?;
    for (places, rates) in STATES {
        let moving = own.with_accelerations(at!(own, places.map(Dual::of), rates.map(Dual::of)), &Unloaded)?;
        let found = numbers(moving.acceleration());
        let inverse = inverse_mass(places, GRAVITY)?;
        let pushed = Vector4::from_fn(|k, _| -RATIOS[k] * RATIOS[k] * found[k].real());
        let expected = with_rotors(&inverse, Matrix4::from_columns(&[inverse * pushed; 4]));
        for k in 0..4 {
            near(found[k].eps[0], expected[(k, 0)], 1e-10 * (1.0 + expected.amax()));
        }
    }
    Ok(())
}

/// ω² are eigenvalues of (M + I)⁻¹ K, and M⁻¹ K = −∂a/∂q where nothing moves.
#[test]
fn it_rests_and_vibrates_as_a_universal_joint_with_rotors() -> Result<(), Error> {
    type Dual = Jet<f64, 4>;
    let (own, other) = (own!(f64, ROTOR, 0.0, GRAVITY)?, universal!(f64, GRAVITY)?);
    let rest = own.equilibrium(at!(own, [0.1, -0.1, 0.1, 0.2], [0.0; 4]), &Unloaded)?;
    let expected = other.equilibrium(at!(other, [0.1, -0.1, 0.1, 0.2], [0.0; 4]), &Unloaded)?;
    let (mut places, mut others) = (vec![], vec![]);
    Position::visit(rest.position(), &mut |x: f64| places.push(x));
    Position::visit(expected.position(), &mut |x: f64| others.push(x));
    for (found, expected) in places.iter().zip(&others) {
        near(*found, *expected, 1e-11);
    }
    let places: [f64; 4] = core::array::from_fn(|k| others[k]);
    let varied = universal!(Dual, GRAVITY)?;
    let seeds: [Dual; 4] = core::array::from_fn(|k| Dual::seed(places[k], k));
    let moving = varied.with_accelerations(at!(varied, seeds, [Dual::of(0.0); 4]), &Unloaded)?;
    let slopes = numbers(moving.acceleration());
    let slopes = Matrix4::from_fn(|i, k| -slopes[i].eps[k]);
    let squares = with_rotors(&inverse_mass(places, GRAVITY)?, slopes).complex_eigenvalues();
    let mut expected: Vec<f64> = squares.iter().map(|square| square.re.sqrt()).collect();
    expected.sort_by(f64::total_cmp);
    let modes = own.modes(&rest, &Unloaded)?;
    assert_eq!(modes.len(), 4);
    for (found, expected) in modes.frequencies().zip(expected) {
        println!("{found} {expected}");
        near(found, expected, 1e-10 * expected);
    }
    Ok(())
}

/// A strut across the joint couples both coordinates: the same as across a universal joint, in motion, at rest and in its modes.
#[test]
fn a_strut_across_it_couples_its_coordinates() -> Result<(), Error> {
    let (own, other) = (own!(f64, 0.0, 0.0, GRAVITY)?, universal!(f64, GRAVITY)?);
    let across = |inner, outer| {
        let strut = Strut::between((inner, [0.3, 0.2, 0.0]), (outer, [0.3, 0.1, 0.2]));
        Struts::of([strut.with_stiffness(80.0).with_length(0.5)])
    };
    // Crosspieces are bodies 0 and 2 of the one.
    let (loads, same) = (across(1, 3), across(0, 1));
    for (places, rates) in STATES {
        let found = own.with_accelerations(at!(own, places, rates), &loads)?;
        let expected = other.with_accelerations(at!(other, places, rates), &same)?;
        for (found, expected) in numbers(found.acceleration()).iter().zip(numbers(expected.acceleration())) {
            near(*found, expected, 1e-11 * (1.0 + expected.abs()));
        }
    }
    let rest = own.equilibrium(at!(own, [0.1, -0.1, 0.1, 0.2], [0.0; 4]), &loads)?;
    let expected = other.equilibrium(at!(other, [0.1, -0.1, 0.1, 0.2], [0.0; 4]), &same)?;
    let (modes, expected) = (own.modes(&rest, &loads)?, other.modes(&expected, &same)?);
    for (found, expected) in modes.frequencies().zip(expected.frequencies()) {
        println!("{found} {expected}");
        near(found, expected, 1e-10 * expected);
    }
    Ok(())
}
