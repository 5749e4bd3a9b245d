//! Derivatives of inverse and forward dynamics, against jets through inverse dynamics and against central differences.

#[path = "../../../tests/it/robots/kit.rs"]
#[allow(dead_code)] // each test needs some of it
mod kit;

use catena::Error;
use catena::robot::*;
use catena::scalar::Jet;
use catena_oracle::Noise;
use kit::{agree, list};

/// Relative to the largest number of each list: some tens of roundings, times the condition of the mass matrix where it is inverted.
const DIRECT: f64 = 1e-13;
const INVERTED: f64 = 1e-12;

type Dual = Jet<f64, 1>;

/// A list of which number k changes.
fn seeded<const N: usize>(list: &[f64; N], k: usize) -> [Dual; N] {
    let mut moved = list.map(Jet::of);
    moved[k] = Jet::seed(list[k], 0);
    moved
}

/// −M⁻¹ times a matrix.
fn solved<const N: usize>(inverse: &[[f64; N]; N], by: &[[f64; N]; N]) -> [[f64; N]; N] {
    std::array::from_fn(|i| std::array::from_fn(|k| -(0..N).map(|j| inverse[i][j] * by[j][k]).sum::<f64>()))
}

/// All derivatives of a scene against jets through inverse dynamics, which knows nothing of them.
macro_rules! against_jets {
    ($scene:expr, $joints:literal, $seed:literal) => {{
        const N: usize = $joints;
        let (scene, mut noise) = ($scene, Noise::new($seed));
        let over = scene.lift(Dual::of);
        for _ in 0..50 {
            let [q, v, x]: [[f64; N]; 3] = std::array::from_fn(|_| list(&mut noise, 2.0));
            let plain = |list: &[f64; N]| list.map(Dual::of);
            let by = |seconds: &[f64; N]| -> Result<[[[f64; N]; N]; 2], Error> {
                let mut found = [[[0.0; N]; N]; 2];
                for k in 0..N {
                    let by_position = over.inverse_dynamics(&seeded(&q, k), &plain(&v), &plain(seconds))?;
                    let by_rate = over.inverse_dynamics(&plain(&q), &seeded(&v, k), &plain(seconds))?;
                    for i in 0..N {
                        (found[0][i][k], found[1][i][k]) = (by_position[i].eps[0], by_rate[i].eps[0]);
                    }
                }
                Ok(found)
            };
            let [positions, rates] = by(&x)?;
            let found = scene.inverse_dynamics_derivatives(&q, &v, &x)?;
            agree(found.positions.as_flattened(), positions.as_flattened(), DIRECT);
            agree(found.rates.as_flattened(), rates.as_flattened(), DIRECT);
            let [positions, rates] = by(&scene.forward_dynamics(&q, &v, &x)?)?;
            let (found, by_torques) = scene.forward_dynamics_derivatives(&q, &v, &x)?;
            let inverse = scene.mass_inverse(&q)?;
            agree(by_torques.as_flattened(), inverse.as_flattened(), INVERTED);
            agree(found.positions.as_flattened(), solved(&inverse, &positions).as_flattened(), INVERTED);
            agree(found.rates.as_flattened(), solved(&inverse, &rates).as_flattened(), INVERTED);
        }
    }};
}

/// Hinges and slides, all turns, an arm of two, dampers and reflected inertias.
#[test]
fn of_a_tree() -> Result<(), Error> {
    against_jets!(kit::fixed()?, 6, 41);
    Ok(())
}

/// Springs, and laws that are not linear: dry friction and stops, within and beyond their range.
#[test]
fn of_joints_with_laws() -> Result<(), Error> {
    let laws = (Spring::new(3.0).damped(0.4).resting_at(0.3), DryFriction::new(1.5, 0.2).breaking_away(2.0));
    let stops = Stops::between([-0.5, 0.7], 40.0, 0.2).damped(0.3);
    let link = |k| kit::general(kit::body(k));
    let chain = (
        Hinge::level().with(laws).grounded(),
        link(1),
        Branch((Slide::at::<7>([0.1, 0.2, 0.3]).turned(Quarter::<8>).with(stops), link(2))),
        Hinge::at::<4>([0.0, 0.0, 0.4]).turned(Quarter::<30>).with(stops).geared(0.2),
        link(3),
    );
    against_jets!(System::new(Base::at([0.3, -0.2, 0.5]), chain, Free)?.with_gravity(kit::GRAVITY), 3, 42);
    Ok(())
}

/// On ground that turns and accelerates, by central differences: h² of the third derivative, and rounding over h.
#[test]
fn on_ground_that_moves() -> Result<(), Error> {
    const STEP: f64 = 1e-5;
    let place = Moving(|t: f64| GroundMotion {
        place: [0.1, 0.2, 0.3],
        velocity: [0.4, -0.3, 0.2],
        acceleration: [1.5 + t, -2.0, 0.7],
    });
    let attitude = Turning(|t: f64| AttitudeMotion {
        attitude: Rotation::from_angles([0.3, 0.2, -0.4]),
        spin: [0.5, -0.8, 1.2],
        acceleration: [2.0 + t, 1.0, -3.0],
    });
    let link = |k| kit::general(kit::body(k));
    let slide = Slide::at::<7>([0.2, 0.1, 0.3]).turned(Quarter::<8>);
    let chain =
        (BodyAxes, Hinge::at::<3>([0.3, 0.4, 0.0]), link(1), slide, link(2), Hinge::at::<1>([0.3, 0.0, 0.0]), link(3));
    let scene = System::new(Clamped::on(place, attitude), chain, Free)?.with_gravity(kit::GRAVITY);
    let mut noise = Noise::new(43);
    for _ in 0..10 {
        let [q, v, x]: [[f64; 3]; 3] = std::array::from_fn(|_| list(&mut noise, 2.0));
        let found = scene.inverse_dynamics_derivatives(&q, &v, &x)?;
        for k in 0..3 {
            let moved = |list: [f64; 3], by: f64| std::array::from_fn(|i| if i == k { list[i] + by } else { list[i] });
            let difference = |at: &dyn Fn(f64) -> Result<[f64; 3], Error>| -> Result<[f64; 3], Error> {
                let [one, two] = [at(-STEP)?, at(STEP)?];
                Ok(std::array::from_fn(|i| (two[i] - one[i]) / (2.0 * STEP)))
            };
            let positions = difference(&|h| scene.inverse_dynamics(&moved(q, h), &v, &x))?;
            let rates = difference(&|h| scene.inverse_dynamics(&q, &moved(v, h), &x))?;
            agree(&found.positions.map(|row| row[k]), &positions, 1e-8);
            agree(&found.rates.map(|row| row[k]), &rates, 1e-8);
        }
    }
    Ok(())
}

/// What is no number is refused; the robot falls over itself, but not silently.
#[test]
fn of_what_is_not_finite() -> Result<(), Error> {
    let scene = kit::fixed()?;
    let (mut q, x) = ([0.1; 6], [0.2; 6]);
    q[2] = f64::NAN;
    let refused = scene.forward_dynamics_derivatives(&q, &x, &x).unwrap_err().fault;
    assert!(matches!(refused, catena::Fault::NonFiniteMotion), "{refused:?}");
    assert!(scene.inverse_dynamics_derivatives(&[0.0; 5], &[0.0; 5], &[0.0; 5]).is_err());
    Ok(())
}
