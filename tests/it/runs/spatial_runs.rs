//! Conservation on long runs, chains of any length, tips that are held, what a sweep allocates and costs.

use catena::Error;
use catena::spatial::*;
use catena_oracle::Noise;
use nalgebra::Vector3;

fn body() -> RigidBody<f64> {
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
    RigidBody::new(1.0, tensor, [0.5, 0.03, -0.02], [1.0, 0.0, 0.0])
}

/// Two bodies on a ball tumble through space for 100 s.
#[test]
fn a_tumbling_pair_keeps_momentum_and_energy() -> Result<(), Error> {
    let system = System::new(Free, (body(), Ball, body()), Free)?;
    let start = system.at_rest(&[0.3, 0.2, -0.4, 1.0, -0.6, 0.5])?;
    let rates = [0.0, 0.0, 0.0, 1.0, -0.6, 0.5, 0.3, 1.1, -0.8];
    let mut start = system.with_rates(start, &rates)?;
    // At rest as a whole, so that momentum is measured against that of its parts.
    let momentum = system.budget(&start)?.momentum;
    start.rate_mut().0.0 = (-momentum / 2.0).into();
    let first = system.budget(&start)?;
    let (mut energy, mut linear, mut angular) = (0.0_f64, 0.0_f64, 0.0_f64);
    let run = system.simulation(Dop853::tolerance(1e-14)).every(1.0).run(start, 100.0, |now| {
        let budget = system.budget(now.motion()).unwrap();
        energy = energy.max((budget.energy() - first.energy()).abs() / first.energy());
        linear = linear.max((budget.momentum - first.momentum).norm());
        let size = first.angular_momentum.norm();
        angular = angular.max((budget.angular_momentum - first.angular_momentum).norm() / size);
    });
    let run = run.map_err(|interrupted| interrupted.error)?;
    println!("energy {energy:.1e}, momentum {linear:.1e}, angular momentum {angular:.1e}, {} steps", run.steps);
    assert!(energy < 1e-12 && linear < 1e-12 && angular < 1e-12);
    Ok(())
}

/// A spring in a ball, of different stiffness about its axes: it stores what it takes, and its torques balance.
#[test]
fn an_elastic_ball_keeps_energy_and_momentum() -> Result<(), Error> {
    let joint = ElasticBall::rotary([3.0, 8.0, 5.0]);
    let system = System::new(Free, (body(), joint, body()), Free)?;
    let start = system.at_rest(&[0.3, 0.2, -0.4, 1.3, -0.9, 0.9])?;
    let start = system.with_rates(start, &[0.0, 0.0, 0.0, 1.0, -0.6, 0.5, 0.3, 1.1, -0.8])?;
    let first = system.budget(&start)?;
    let (mut energy, mut angular, mut stored) = (0.0_f64, 0.0_f64, 0.0_f64);
    system.simulate(start, Dop853::tolerance(1e-13), 5.0, |now| {
        let budget = system.budget(now.motion()).unwrap();
        energy = energy.max((budget.energy() - first.energy()).abs());
        angular = angular.max((budget.angular_momentum - first.angular_momentum).norm());
        stored = stored.max(budget.potential);
    })?;
    println!("energy {energy:.1e} of {:.1} J, angular momentum {angular:.1e}, stored {stored:.1} J", first.energy());
    assert!(stored > 1.0 && energy < 1e-11 && angular < 1e-11);

    // The same scene seen from other axes does the same.
    let accelerations = |base: Rotation<f64>| {
        let mut turned = start;
        turned.position_mut().0.1 = base.after(&start.position().0.1);
        system.with_accelerations(turned, &Unloaded).map(|motion| *motion.acceleration())
    };
    let (plain, turned) =
        (accelerations(Rotation::identity())?, accelerations(Rotation::from_angles([0.7, -1.1, 2.0]))?);
    for k in 0..3 {
        assert!((plain.1.1[k] - turned.1.1[k]).abs() < 1e-12 && (plain.0.1[k] - turned.0.1[k]).abs() < 1e-12);
    }
    // A damper takes energy and leaves momentum.
    let system = System::new(Free, (body(), joint.damped(0.1), body()), Free)?;
    let last = system.budget(&system.simulate(start, Dop853::tolerance(1e-13), 5.0, |_| ())?.motion)?;
    let lost = first.energy() - last.energy();
    assert!(lost > 0.1 && (last.angular_momentum - first.angular_momentum).norm() < 1e-11);
    Ok(())
}

/// What Newton's and Euler's laws leave of the torque at smooth balls, which transmit none.
///
/// Inverse dynamics has no balls to start anew from: what is left at a ball is the sum of the residuals of all bodies outboard of it.
/// So a body's own residual, the difference from one ball to the next, is measured by a body's length, and the sum by the length of
/// the chain, both times the largest force.
fn residuals(n: usize) -> Result<[f64; 2], Error> {
    let mut noise = Noise::new(n as u64);
    let links: Vec<(Ball, RigidBody<f64>)> = vec![(Ball, body()); n - 1];
    let system = System::new(Pinned::origin(), (body(), links), Free)?.with_gravity([0.0, -9.81, 0.0]);
    let angles: Vec<f64> = (0..3 * n).map(|_| noise.next()).collect();
    let rates: Vec<f64> = (0..3 * n).map(|_| noise.next()).collect();
    let motion = system.with_rates(system.at_rest(&angles)?, &rates)?;
    let motion = system.with_accelerations(motion, &Unloaded)?;
    let stations = system.stations(&motion, &Unloaded)?;
    let (mut own, mut sum, mut force) = (0.0_f64, 0.0_f64, 0.0_f64);
    let mut inner = None;
    for k in 0..n {
        if let Some(station) = stations.get(2 * k) {
            let torque = station.internal.torque;
            own = own.max((torque - inner.unwrap_or(torque)).norm());
            sum = sum.max(torque.norm());
            force = force.max(station.internal.force.norm());
            inner = Some(torque);
        }
    }
    let residuals = [own / force, sum / (force * n as f64)];
    println!("{n} bodies: own {:.1e}, sum {:.1e}, force {force:.1e}", residuals[0], residuals[1]);
    Ok(residuals)
}

#[test]
fn balls_of_long_chains_transmit_no_torque() -> Result<(), Error> {
    for n in [10, 100, 1000, 10_000] {
        for residual in residuals(n)? {
            assert!(residual < 1e-10, "{residual:.1e}");
        }
    }
    Ok(())
}

/// The same bodies as a tuple, nested, as an array and as a vector move alike to the last bit.
#[test]
fn forms_of_a_scene_are_bit_identical() -> Result<(), Error> {
    let b = body();
    let h = Revolute::about([0.0, 1.0, 1.0]);
    macro_rules! run {
        ($chain:expr) => {{
            use catena::system::Position;
            let system = System::new(Pinned::origin(), $chain, Free)?.with_gravity([0.0, -9.81, 0.0]);
            let start = system.at_rest(&[0.3, 0.2, -0.4, 1.0, 0.5, 0.1, -0.2, 0.7])?;
            let end = system.simulate(start, Rk4::step(1e-2), 0.5, |_| ())?.motion;
            let mut numbers = vec![];
            end.position().visit(&mut |x: f64| numbers.push(x));
            numbers
        }};
    }
    let flat = run!((b, Ball, b, h, b, h, b));
    assert_eq!(flat, run!(((b, (Ball, b)), ((h, b), h), b)));
    assert_eq!(flat, run!((b, Ball, b, [(h, b); 2])));
    assert_eq!(flat, run!((b, Ball, b, vec![(h, b); 2])));
    Ok(())
}

/// A chain held at its tip by a ball, and one clamped: closed to rounding after every step, and without loss of energy.
#[test]
fn held_tips_stay_where_they_are() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 0.05, 1.0);
    let chain = (rod, Ball, rod, Universal::about([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]), rod);
    let free = System::new(Pinned::origin(), chain, Free)?;
    let start = free.at_rest(&[0.0, 0.3, 0.8, 0.0, -0.2, -0.4, 0.3, -0.6])?;
    let place = free.stations(&start, &Unloaded)?.tip().frame.place;
    let system =
        System::new(Pinned::origin(), chain, Pinned::at([place.x, place.y, place.z]))?.with_gravity([0.0, -9.81, 0.0]);
    let start = system.at_rest(&[0.0, 0.3, 0.8, 0.0, -0.2, -0.4, 0.3, -0.6])?;
    let energy = system.budget(&start)?.energy();
    let (mut gap, mut drift) = (0.0_f64, 0.0_f64);
    let run = system.simulate(start, Dop853::tolerance(1e-11), 2.0, |now| {
        let tip = system.stations(now.motion(), &Unloaded).unwrap().tip().frame.place;
        gap = gap.max((tip - place).norm());
        drift = f64::max(drift, f64::abs(now.energy() - energy));
    })?;
    println!("ball: gap {gap:.1e}, energy {drift:.1e}, {} steps", run.steps);
    assert!(gap < 1e-14 && drift < 1e-9);

    // Clamped at both ends, with seven freedoms less six.
    let chain = (
        Ball,
        rod,
        Universal::about([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]),
        rod,
        Revolute::about([0.0, 0.0, 1.0]),
        rod,
        Revolute::about([0.0, 1.0, 0.2]),
        rod,
    );
    let root = Clamped::origin();
    let free = System::new(root, chain, Free)?;
    let angles = [0.0, 0.3, 0.8, -0.2, -0.9, 0.5, -0.8];
    let start = free.at_rest(&angles)?;
    let tip = free.stations(&start, &Unloaded)?.tip().frame;
    let attitude = Rotation::from_matrix(&tip.turn.attitude);
    let system = System::new(root, chain, Clamped::at(tip.place.into(), attitude))?.with_gravity([0.0, -9.81, 0.0]);
    let start = system.at_rest(&angles)?;
    let energy = system.budget(&start)?.energy();
    let (mut gap, mut turn, mut drift) = (0.0_f64, 0.0_f64, 0.0_f64);
    let run = system.simulate(start, Dop853::tolerance(1e-11), 1.0, |now| {
        let found = system.stations(now.motion(), &Unloaded).unwrap().tip().frame;
        gap = gap.max((found.place - tip.place).norm());
        let relative = Rotation::from_matrix(&found.turn.attitude).relative_to(&attitude).shortest();
        turn = turn.max(Vector3::from(relative.log()).norm());
        drift = f64::max(drift, f64::abs(now.energy() - energy));
    })?;
    println!("clamp: gap {gap:.1e}, turn {turn:.1e}, energy {drift:.1e}, {} steps", run.steps);
    assert!(gap < 1e-14 && turn < 1e-14 && drift < 1e-9);
    Ok(())
}
