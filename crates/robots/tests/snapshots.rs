//! Snapshots of robots on bases that are fixed and that float, against a dense robot.

#[path = "../../../tests/it/robots/kit.rs"]
mod kit;

use catena::robot::*;
use catena::system::Rate;
use catena_oracle::Noise;
use catena_oracle::space::Vector;
use catena_oracle::space::robot as plain;
use kit::{Drift, agree, drift, fixed, floating, list, plain_fixed};
use nalgebra::{DMatrix, DVector};

const DIRECT: f64 = 1e-13;

/// Rows of six of all coordinates: those of the base first, where it floats.
fn columns<const N: usize>(rows: &SixRows<f64, N>, floats: bool) -> Vec<[f64; 6]> {
    let base = if floats { &rows.base[..] } else { &[] };
    base.iter().chain(&rows.joints).copied().collect()
}

/// A snapshot against the dense robot at the same state, with these rates of all coordinates.
fn check<const N: usize>(
    now: &Snapshot<f64, N>,
    robot: &plain::Robot,
    at: &plain::Instant,
    rates: &[f64],
    noise: &mut Noise,
) -> Result<(), catena::Error> {
    let (floats, offset) = (robot.base.is_some(), robot.offset());
    let size = offset + N;
    let speed = DVector::from_column_slice(rates);

    // Points: places, Jacobians, and what rates alone accelerate.
    let bodies = at.base.iter().map(|body| (None, body)).chain((0..N).map(|k| (Some(k), &at.bodies[k])));
    for (joint, body) in bodies {
        let local: [f64; 3] = list(noise, 0.5);
        let arm = body.attitude * Vector::from(local);
        let [place, velocity] = now.point(joint, local)?;
        agree(place.as_slice(), (body.place + arm).as_slice(), DIRECT);
        agree(velocity.as_slice(), (body.velocity + body.spin.cross(&arm)).as_slice(), DIRECT);
        let jacobian = columns(&now.jacobian(joint, local)?, floats);
        let mut right = vec![];
        for k in 0..size {
            let turn = Vector::from_column_slice(body.of_turn.column(k).as_slice());
            let velocity = Vector::from_column_slice(body.of_place.column(k).as_slice()) + turn.cross(&arm);
            right.extend(velocity.iter().chain(turn.iter()).copied());
        }
        agree(jacobian.as_flattened(), &right, DIRECT);
        let changing = columns(&now.jacobian_rate(joint, local)?, floats);
        let mut sum = [0.0; 6];
        changing.iter().zip(rates).for_each(|(row, rate)| (0..6).for_each(|i| sum[i] += row[i] * rate));
        let linear = body.linear + body.angular.cross(&arm) + body.spin.cross(&body.spin.cross(&arm));
        let mut right: Vec<f64> = linear.iter().chain(body.angular.iter()).copied().collect();
        agree(&sum, &right, DIRECT);
        // And with accelerations of all coordinates.
        let seconds: Vec<f64> = (0..size).map(|_| 2.0 * noise.next()).collect();
        jacobian.iter().zip(&seconds).for_each(|(row, second)| (0..6).for_each(|i| right[i] += row[i] * second));
        let mut of_base = [0.0; 6];
        of_base[..offset].copy_from_slice(&seconds[..offset]);
        let of_joints = std::array::from_fn(|k| seconds[offset + k]);
        let found = now.point_acceleration(joint, local, &of_base, &of_joints)?;
        agree(&found.map(|x| [x.x, x.y, x.z]).concat(), &right, DIRECT);
    }

    // Mass matrix and inverse dynamics, with dampers and reflected inertias.
    let MassMatrix { base, coupling, joints } = now.mass_matrix();
    let mass = DMatrix::from_fn(size, size, |i, k| match (i < offset, k < offset) {
        (true, true) => base[i][k],
        (true, false) => coupling[k - offset][i],
        (false, true) => coupling[i - offset][k],
        (false, false) => joints[i - offset][k - offset],
    });
    agree(mass.as_slice(), at.mass.as_slice(), DIRECT);
    let seconds: Vec<f64> = (0..size).map(|_| 2.0 * noise.next()).collect();
    let mut of_base = [0.0; 6];
    of_base[..offset].copy_from_slice(&seconds[..offset]);
    let of_joints: [f64; N] = std::array::from_fn(|k| seconds[offset + k]);
    let (wrench, torques) = now.inverse_dynamics(&of_base, &of_joints);
    let mut right = &at.mass * DVector::from_vec(seconds.clone()) + &at.bias;
    (0..N).for_each(|k| right[offset + k] += robot.parts[k].damping * rates[offset + k]);
    let found: Vec<f64> = wrench[..offset].iter().chain(&torques).copied().collect();
    agree(&found, right.as_slice(), DIRECT);

    // The regressor times the parameters, without dampers and reflected inertias.
    let (regressor, (of, parameters)) = (now.regressor(&of_base, &of_joints), now.parameters());
    let times = |row: &[f64; 10], by: &[f64; 10]| row.iter().zip(by).map(|(a, b)| a * b).sum::<f64>();
    let of_bodies = |row: &[[f64; 10]; N]| row.iter().zip(&parameters).map(|(row, by)| times(row, by)).sum::<f64>();
    let rows = (0..offset).map(|i| times(&regressor.base[i], &of) + of_bodies(&regressor.on_base[i]));
    let found: Vec<f64> = rows.chain(regressor.joints.iter().map(of_bodies)).collect();
    for k in 0..N {
        let part = &robot.parts[k];
        right[offset + k] -= part.damping * rates[offset + k] + part.armature * of_joints[k];
    }
    agree(&found, right.as_slice(), DIRECT);

    // Mass centre and momentum.
    let (centre, whole) = now.mass_centre();
    agree(centre.as_slice(), at.centre.as_slice(), DIRECT);
    let (base, joints) = now.mass_centre_jacobian();
    let found: Vec<f64> = base[..offset].iter().chain(&joints).flatten().copied().collect();
    agree(&found, at.of_centre.as_slice(), DIRECT);
    let (sum, momentum, angular) = robot.momenta(at);
    let [found, turning] = now.centroidal_momentum();
    agree(&[whole], &[sum], DIRECT);
    agree(found.as_slice(), momentum.as_slice(), DIRECT);
    agree(turning.as_slice(), angular.as_slice(), DIRECT);
    assert!((momentum - (&at.of_centre * speed) * sum).norm() < 1e-12);
    Ok(())
}

/// What a body yields at a point, J M⁻¹ Jᵀ by dense algebra, and its inverse, where it has one.
fn yields(found: [[f64; 6]; 6], inertia: Result<[[f64; 6]; 6], catena::Error>, rows: &[[f64; 6]], mass: &DMatrix<f64>) {
    let jacobian = DMatrix::from_fn(6, rows.len(), |i, k| rows[k][i]);
    let solved = mass.clone().lu().solve(&jacobian.transpose()).expect("a regular matrix");
    let right = &jacobian * solved;
    // Rounding times the condition of the mass matrix, and of the inverse of what came of it.
    agree(found.as_flattened(), right.as_slice(), 1e-11);
    match inertia {
        Ok(inertia) => {
            let product = DMatrix::from_fn(6, 6, |i, k| inertia[i][k]) * &right;
            agree(product.as_slice(), DMatrix::identity(6, 6).as_slice(), 1e-9);
        }
        Err(error) => {
            let rank = jacobian.rank(1e-9);
            assert!(matches!(error.fault, catena::Fault::Unsupported { .. }) && rank < 6, "{error} at rank {rank}");
        }
    }
}

#[test]
fn on_the_ground() -> Result<(), catena::Error> {
    let (scene, plain, mut noise) = (fixed()?, plain_fixed(), Noise::new(31));
    for _ in 0..20 {
        let [q, v]: [[f64; 6]; 2] = std::array::from_fn(|_| list(&mut noise, 2.0));
        let now = scene.snapshot(&q, &v)?;
        check(&now, &plain, &plain.at(&q, &v), &v, &mut noise)?;
        for joint in 0..6 {
            let (point, right) = ([0.2, -0.1, 0.3], now.jacobian(Some(joint), [0.2, -0.1, 0.3])?.joints);
            agree(scene.jacobian(&q, joint, point)?.as_flattened(), right.as_flattened(), DIRECT);
            let (compliance, inertia) =
                (scene.operational_compliance(&q, joint, point)?, scene.operational_inertia(&q, joint, point));
            yields(compliance, inertia, &right, &plain.at(&q, &v).mass);
        }
    }
    assert!(scene.snapshot(&[0.0; 5], &[0.0; 5]).is_err());
    assert!(scene.snapshot(&[0.0; 6], &[0.0; 6])?.jacobian(Some(6), [0.0; 3]).is_err());
    Ok(())
}

/// The ground moves as a given function of time: what a snapshot says that accelerations take is what the scene says.
#[test]
fn on_ground_that_moves() -> Result<(), catena::Error> {
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
    let link = Link::general(1.3, [0.1, -0.05, 0.2], [[0.3, 0.01, 0.02], [0.01, 0.4, 0.03], [0.02, 0.03, 0.2]]);
    let chain = (BodyAxes, Hinge::level(), link, Slide::at::<7>([0.2, 0.1, 0.3]).turned(Quarter::<8>), link);
    let scene = System::new(Clamped::on(place, attitude), chain, Free)?.with_gravity(kit::GRAVITY);
    let mut noise = Noise::new(33);
    for _ in 0..10 {
        let [q, v, a]: [[f64; 2]; 3] = std::array::from_fn(|_| list(&mut noise, 2.0));
        let (_, found) = scene.snapshot(&q, &v)?.inverse_dynamics(&[0.0; 6], &a);
        agree(&found, &scene.inverse_dynamics(&q, &v, &a)?, DIRECT);
    }
    Ok(())
}

#[test]
fn afloat() -> Result<(), catena::Error> {
    let (scene, mut noise) = (floating()?, Noise::new(32));
    for _ in 0..20 {
        let Drift { start, plain, q, v } = drift(&scene, &mut noise)?;
        let mut rates = vec![];
        start.rate().visit(&mut |x: f64| rates.push(x));
        let base = scene.body_motions(&start)?.get(0).map(Afloat::of).expect("a base");
        check(&scene.snapshot_afloat(base, &q, &v)?, &plain, &plain.at(&q, &v), &rates, &mut noise)?;
        for joint in [None, Some(0), Some(2), Some(4)] {
            let (place, point) = (base.place, [0.2, -0.1, 0.3]);
            let rows = scene.jacobian_afloat(place, &q, joint, point)?;
            let inertia = scene.operational_inertia_afloat(place, &q, joint, point);
            assert!(inertia.is_ok());
            let compliance = scene.operational_compliance_afloat(place, &q, joint, point)?;
            yields(compliance, inertia, &columns(&rows, true), &plain.at(&q, &v).mass);
        }
        // In one walk out and one in.
        let seconds: [f64; 11] = list(&mut noise, 2.0);
        let (of_base, of_joints): ([f64; 6], [f64; 5]) =
            (std::array::from_fn(|k| seconds[k]), std::array::from_fn(|k| seconds[6 + k]));
        let at = plain.at(&q, &v);
        let mut right = &at.mass * DVector::from_column_slice(&seconds) + &at.bias;
        (0..5).for_each(|k| right[6 + k] += plain.parts[k].damping * rates[6 + k]);
        let (wrench, torques) = scene.inverse_dynamics_afloat(base, &q, &v, &of_base, &of_joints)?;
        let found: Vec<f64> = wrench.iter().chain(&torques).copied().collect();
        agree(&found, right.as_slice(), DIRECT);
    }
    Ok(())
}

/// Against central differences of the dense robot: h² of the third derivative, and rounding over h.
#[test]
fn derivatives_by_states_and_torques() -> Result<(), catena::Error> {
    const STEP: f64 = 1e-5;
    const TOLERANCE: f64 = 1e-8;
    let (scene, plain, mut noise) = (fixed()?, plain_fixed(), Noise::new(33));
    for _ in 0..10 {
        let [q, v, x]: [[f64; 6]; 3] = std::array::from_fn(|_| list(&mut noise, 2.0));
        let moved = |list: [f64; 6], k: usize, by: f64| {
            let mut moved = list;
            moved[k] += by;
            moved
        };
        let forward = |q: &[f64; 6], v: &[f64; 6], x: &[f64; 6]| plain.forward_dynamics(q, v, x);
        let inverse = |q: &[f64; 6], v: &[f64; 6]| {
            let (now, dampers) = (plain.at(q, v), plain.parts.iter().zip(v).map(|(part, v)| part.damping * v));
            &now.mass * DVector::from_column_slice(&x) + now.bias + DVector::from_iterator(6, dampers)
        };
        let (state, by_torques) = scene.forward_dynamics_derivatives(&q, &v, &x)?;
        let taken = scene.inverse_dynamics_derivatives(&q, &v, &x)?;
        for k in 0..6 {
            let column = |rows: &[[f64; 6]; 6]| rows.map(|row| row[k]);
            let change = |f: &dyn Fn(f64) -> DVector<f64>| (f(STEP) - f(-STEP)) / (2.0 * STEP);
            let pairs = [
                (column(&state.positions), change(&|h| forward(&moved(q, k, h), &v, &x))),
                (column(&state.rates), change(&|h| forward(&q, &moved(v, k, h), &x))),
                (column(&by_torques), change(&|h| forward(&q, &v, &moved(x, k, h)))),
                (column(&taken.positions), change(&|h| inverse(&moved(q, k, h), &v))),
                (column(&taken.rates), change(&|h| inverse(&q, &moved(v, k, h)))),
            ];
            for (found, right) in pairs {
                let size = 1.0 + right.amax();
                found.iter().zip(right.iter()).for_each(|(x, y)| catena_oracle::near(*x, *y, TOLERANCE * size));
            }
        }
    }
    Ok(())
}
