//! Chains in space held at both ends: by balls, clamps and hinges, on ground that rests, moves and turns.

use catena::internals::relation::Cut;
use catena::loading::Unloaded;
use catena::spatial::*;
use catena::{Error, Fault, Motion, Place, Scalar};
use catena_oracle::has_order;
use core::f64::consts::FRAC_PI_3;
use nalgebra::Vector3;
use num_dual::Dual64;

/// A body without symmetry, and the same body with its ends exchanged.
fn body(length: f64) -> [RigidBody<f64>; 2] {
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
    let (centre, outboard) = ([0.45 * length, 0.03, -0.02], [length, 0.1, 0.0]);
    let back = core::array::from_fn(|k| centre[k] - outboard[k]);
    [RigidBody::new(1.0, tensor, centre, outboard), RigidBody::new(1.0, tensor, back, outboard.map(|x| -x))]
}

/// A crank about z, a ball, a coupler, a universal joint, and a rocker about a slanted axis: one freedom.
macro_rules! linkage {
    () => {{
        let cardan = Universal::about([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
        let chain = (body(0.3)[0], Ball, body(1.0)[0], cardan, body(0.8)[0]);
        let rocker = Hinged::at([0.9, 0.1, -0.2], [0.0, 1.0, 0.2]);
        System::new(Hinged::at([0.0; 3], [0.0, 0.0, 1.0]), chain, rocker)
    }};
}
/// A guess of its position.
const GUESS: [f64; 6] = [1.2, 0.0, -0.64, -0.22, 2.2, 0.1];

macro_rules! start {
    ($linkage:expr) => {
        $linkage.assembled($linkage.at_rest(&GUESS)?, &Unloaded)
    };
}

#[test]
fn closure_holds_over_twenty_seconds() -> Result<(), Error> {
    let linkage = linkage!()?.with_gravity([0.0, -9.81, 0.0]);
    let axis = Vector3::new(0.0, 1.0, 0.2).normalize();
    let place = Vector3::new(0.9, 0.1, -0.2);
    let start = start!(linkage)?;
    let mut moved = 0.0_f64;
    for explicit in [true, false] {
        let mut worst = [0.0_f64; 2];
        let mut look = |frame: Frame<f64>, crank: f64| {
            let turned = frame.turn.attitude.apply(axis) - axis;
            worst = [worst[0].max((frame.place - place).amax()), worst[1].max(turned.amax())];
            moved = moved.max((crank - start.position().0).abs());
        };
        if explicit {
            let rule = Dop853::tolerance(1e-10);
            linkage.simulate(start, rule, 20.0, |now| look(now.stations().tip().frame, now.motion().position().0))?;
        } else {
            let rule = GeneralizedAlpha::new(0.8).step(0.002);
            linkage.simulate(start, rule, 20.0, |now| look(now.stations().tip().frame, now.motion().position().0))?;
        }
        println!(
            "explicit {explicit}: place {:.1e} m, axis {:.1e}; the crank turns by {moved:.2} rad",
            worst[0], worst[1]
        );
        assert!(worst[0] < 1e-13 && worst[1] < 1e-13 && moved > 1.0); // round-off of three bodies
    }
    Ok(())
}

#[test]
fn energy_is_kept_by_a_hinge_that_rests() -> Result<(), Error> {
    let linkage = linkage!()?.with_gravity([0.0, -9.81, 0.0]);
    let start = start!(linkage)?;
    let energy = linkage.budget(&start)?.energy();
    let run = linkage.simulate(start, Dop853::tolerance(1e-12), 5.0, |_| ())?;
    let change = linkage.budget(&run.motion)?.energy() - energy;
    println!("energy {energy:.3} J changes by {change:.1e} J");
    assert!(change.abs() < 1e-9); // 1e-12 a step, some hundred steps
    Ok(())
}

#[test]
fn projection_keeps_the_order_of_a_rule() -> Result<(), Error> {
    let linkage = linkage!()?.with_gravity([0.0, -9.81, 0.0]);
    let start = start!(linkage)?;
    let reference = linkage.simulate(start, Dop853::tolerance(1e-13), 0.4, |_| ())?.motion;
    let [mut cranks, mut forces, mut stiff_cranks, mut stiff_forces] = [vec![], vec![], vec![], vec![]];
    // The last of the closure forces, a torque across the axis.
    let force = |motion: &[f64; 5]| (motion[4] - reference.multipliers()[4]).abs();
    for h in [0.02, 0.01, 0.005] {
        let motion = linkage.simulate(start, Rk4::step(h), 0.4, |_| ())?.motion;
        cranks.push((h, (motion.position().0 - reference.position().0).abs()));
        forces.push((h, force(motion.multipliers())));
    }
    for h in [0.004, 0.002, 0.001] {
        let motion = linkage.simulate(start, GeneralizedAlpha::new(0.8).step(h), 0.4, |_| ())?.motion;
        stiff_cranks.push((h, (motion.position().0 - reference.position().0).abs()));
        stiff_forces.push((h, force(motion.multipliers())));
    }
    has_order("RK4, crank", 4.0, 1e-12, &cranks);
    has_order("RK4, closure torque", 4.0, 1e-12, &forces);
    has_order("generalised-alpha, crank", 2.0, 1e-12, &stiff_cranks);
    has_order("generalised-alpha, closure torque", 2.0, 1e-10, &stiff_forces);
    Ok(())
}

/// The same mechanism, told from either end: a hinge at its root is a hinge at its tip.
#[test]
fn a_chain_told_backwards_moves_alike() -> Result<(), Error> {
    let axis = [0.2, -0.1, 1.0];
    let unit = Vector3::from(axis).normalize();
    let [[a, a_back], [b, b_back], [c, c_back]] = [body(0.5), body(0.7), body(0.6)];
    // Attitudes that close, found in one of them.
    let hinge = Hinged::at([0.0; 3], axis);
    let ball = Pinned::at([1.0, 0.3, -0.2]);
    let forward = System::new(hinge, (a, Ball, b, Ball, c), ball)?.with_gravity([0.0, -9.81, 0.0]);
    let guess = forward.at_rest(&[0.5, 0.1, 0.2, -0.9, 0.4, -0.3, 0.8])?;
    let start = forward.assembled(guess, &Unloaded)?;
    let backward = System::new(ball, (c_back, Ball, b_back, Ball, a_back), hinge)?.with_gravity([0.0, -9.81, 0.0]);
    let mut other = backward.motion();
    let (angle, rest) = start.position();
    let turned = Rotation::exp((unit * *angle).into());
    *other.position_mut() = (rest.3, ((), rest.1, (), turned, ()));
    let other = backward.assembled(other, &Unloaded)?;

    let rule = Dop853::tolerance(1e-12);
    let one = forward.simulate(start, rule, 1.5, |_| ())?.motion;
    let two = backward.simulate(other, rule, 1.5, |_| ())?.motion;
    let (bodies, others) = (forward.body_motions(&one)?, backward.body_motions(&two)?);
    for k in 0..3 {
        let attitude = |body: Option<&BodyMotion<f64>>| body.map(|body| body.inboard.turn.attitude);
        let (found, expected) = (attitude(others.get(2 - k)), attitude(bodies.get(k)));
        let (Some(found), Some(expected)) = (found, expected) else { panic!("three bodies") };
        let difference = (found.x - expected.x).amax().max((found.y - expected.y).amax());
        println!("body {k}: attitudes differ by {difference:.1e}");
        assert!(difference < 1e-9); // a tolerance of 1e-12 over some hundred steps of an unsteady motion
    }
    // What the ground exerts at the hinge, once as the state at a root, once as forces λ.
    let root = forward.stations(&one, &Unloaded)?.root().internal;
    let tip = backward.stations(&two, &Unloaded)?.tip().internal;
    let (force, torque) = ((root.force + tip.force).amax(), (root.torque + tip.torque).amax());
    println!("force of the hinge {:.3} N, differs by {force:.1e} N, torque by {torque:.1e} N·m", root.force.norm());
    assert!(force < 1e-8 && torque < 1e-8);
    assert!(tip.torque.dot(&unit).abs() < 1e-15 && tip.torque.norm() > 0.01); // smooth, and not idle
    Ok(())
}

/// A ground that moves, and turns about a fixed slanted axis.
fn ground() -> (impl Ground<f64, GroundMotion<f64>> + Copy, impl Ground<f64, AttitudeMotion<f64>> + Copy) {
    let moving = Moving(|t: f64| GroundMotion {
        place: [0.9 + 0.1 * t.sin(), 0.1, -0.2 + 0.05 * (2.0 * t).sin()],
        velocity: [0.1 * t.cos(), 0.0, 0.1 * (2.0 * t).cos()],
        acceleration: [-0.1 * t.sin(), 0.0, -0.2 * (2.0 * t).sin()],
    });
    // A turn about a fixed slanted axis that starts from rest and stops again.
    let slant = Vector3::new(0.3, -0.4, 0.5);
    let turning = Turning(move |t: f64| {
        let (angle, rate, second) = (1.0 - t.cos(), t.sin(), t.cos());
        AttitudeMotion {
            attitude: Rotation::exp((slant * angle).into()),
            spin: (slant * rate).into(),
            acceleration: (slant * second).into(),
        }
    });
    (moving, turning)
}

/// The ground of all kinds of tips moves, and turns where that matters. The tip follows, and the work of the forces that move it is
/// what the scene gains.
#[test]
fn tips_follow_ground_that_moves_and_turns() -> Result<(), Error> {
    let (moving, turning) = ground();
    let clamp = Clamped { place: moving, attitude: turning };
    let chain = (body(0.5)[0], Ball, body(0.8)[0], Ball, body(0.6)[0]);
    let axis = Vector3::new(0.3, 1.0, 0.2).normalize();
    macro_rules! follow {
        ($name:literal, $tip:expr, $turn:expr) => {{
            let scene = System::new(Pinned::origin(), chain, $tip)?.with_gravity([0.0, -9.81, 0.0]);
            let guess = scene.at_rest(&[0.2, 0.1, -0.8, 0.1, -0.3, 0.4, 0.0, 0.1, 0.3])?;
            let start = scene.assembled(guess, &Unloaded)?;
            let energy = scene.budget(&start).unwrap().energy();
            let (mut worst, mut power) = (0.0_f64, vec![]);
            let run = scene.simulation(Dop853::tolerance(1e-12)).every(0.005).run(start, 2.0, |now| {
                let tip = *now.stations().tip();
                let (ground, held) = (moving.at(now.time()), turning.at(now.time()));
                worst = worst.max((tip.frame.place - Vector3::from(ground.place)).amax());
                let turned: f64 = $turn(&tip.frame.turn.attitude, &held.attitude);
                worst = worst.max(turned);
                let push = -tip.internal.force.dot(&Vector3::from(ground.velocity));
                power.push(push + tip.internal.torque.dot(&Vector3::from(held.spin)));
            })?;
            // Simpson's rule over 400 intervals: an error of some 1e-8 of the power.
            let last = power.len() - 1;
            let weight = |k: usize| if k == 0 || k == last { 1.0 } else { 2.0 + 2.0 * (k % 2) as f64 };
            let work = power.iter().enumerate().map(|(k, p)| weight(k) * p).sum::<f64>() * 0.005 / 3.0;
            let gain = scene.budget(&run.motion).unwrap().energy() - energy;
            println!("{}: the tip strays by {worst:.1e}; work {work:.9} J, gain {gain:.9} J", $name);
            assert!(power.len() == 401 && worst < 1e-11 && work.abs() > 0.01 && (work - gain).abs() < 1e-6, $name);
        }};
    }
    type Axes = catena::spatial::Columns<f64>;
    follow!("ball", Pinned::on(moving), |_: &Axes, _: &Rotation<f64>| 0.0);
    follow!("clamp", clamp, |own: &Axes, held: &Rotation<f64>| {
        let held = held.matrix();
        (own.x - held.x).amax().max((own.y - held.y).amax())
    });
    follow!("hinge", Hinged::on(clamp, axis.into()), |own: &Axes, held: &Rotation<f64>| {
        (own.apply(axis) - held.matrix().apply(axis)).amax()
    });
    Ok(())
}

/// A hinge on ground that turns demands accelerations that depend on how fast its body turns on it.
#[test]
fn rules_keep_their_order_on_ground_that_moves_and_turns() -> Result<(), Error> {
    let (place, attitude) = ground();
    let chain = (body(0.5)[0], Ball, body(0.8)[0], Ball, body(0.6)[0]);
    let hinge = Hinged::on(Clamped { place, attitude }, [0.3, 1.0, 0.2]);
    let scene = System::new(Pinned::origin(), chain, hinge)?.with_gravity([0.0, -9.81, 0.0]);
    let guess = scene.at_rest(&[0.2, 0.1, -0.8, 0.1, -0.3, 0.4, 0.0, 0.1, 0.3])?;
    let start = scene.assembled(guess, &Unloaded)?;
    let reference = scene.simulate(start, Dop853::tolerance(1e-13), 0.5, |_| ())?.motion;
    let [mut attitudes, mut torques, mut stiff_attitudes, mut stiff_torques] = [vec![], vec![], vec![], vec![]];
    let look = |attitude: Rotation<f64>, multipliers: &[f64; 5]| {
        let turned = Vector3::from(attitude.relative_to(&reference.position().0).shortest().log()).norm();
        let off = |k: usize| (multipliers[k] - reference.multipliers()[k]).powi(2);
        (turned, (0..5).map(off).sum::<f64>().sqrt())
    };
    for h in [0.02, 0.01, 0.005] {
        let motion = scene.simulate(start, Rk4::step(h), 0.5, |_| ())?.motion;
        let (turned, torque) = look(motion.position().0, motion.multipliers());
        attitudes.push((h, turned));
        torques.push((h, torque));
    }
    for h in [0.005, 0.0025, 0.00125] {
        let motion = scene.simulate(start, GeneralizedAlpha::new(0.8).step(h), 0.5, |_| ())?.motion;
        let (turned, torque) = look(motion.position().0, motion.multipliers());
        stiff_attitudes.push((h, turned));
        stiff_torques.push((h, torque));
    }
    has_order("RK4, attitude", 4.0, 1e-12, &attitudes);
    has_order("RK4, closure forces", 4.0, 1e-12, &torques);
    has_order("generalised-alpha, attitude", 2.0, 1e-12, &stiff_attitudes);
    has_order("generalised-alpha, closure forces", 2.0, 1e-12, &stiff_torques);
    Ok(())
}

/// Closure forces of a hinge differentiate, by gravity and by the direction of its axis.
#[test]
fn closure_forces_of_a_hinge_have_derivatives() -> Result<(), Error> {
    type Position<T> = (Rotation<T>, ((), Rotation<T>, (), Rotation<T>, ()));
    // From a closed position, so that corrections are small: from afar they are measured, and measures have no derivatives.
    fn closed<T: Scalar<Real = f64>>(
        x: T,
        near: Option<&Motion<f64, Position<f64>, Cut<5>>>,
    ) -> Result<Motion<T, Position<T>, Cut<5>>, Error> {
        let number = T::literal;
        let rod = |length: f64| Rod::uniform(number(length), number(0.02), number(1.0));
        let chain = (rod(0.5), Ball, rod(0.8), Ball, rod(0.6));
        let hinge = Hinged::at([0.9, 0.1, -0.2].map(number), [number(0.3) + x, number(1.0), number(0.2)]);
        let scene =
            System::new(Pinned::origin(), chain, hinge)?.with_gravity([T::zero(), -(number(9.81) + x), T::zero()]);
        let guess = match near {
            Some(near) => near.lift(T::literal),
            None => scene.at_rest(&[0.2, 0.1, -0.8, 0.1, -0.3, 0.4, 0.0, 0.1, 0.3].map(number))?,
        };
        let rates = [0.3, -0.4, 0.5, 1.0, -0.3, 0.2, 0.1, 0.7, -0.5].map(number);
        scene.assembled(scene.with_rates(guess, &rates)?, &Unloaded)
    }
    fn forces<T: Scalar<Real = f64>>(x: T) -> Result<[T; 5], Error> {
        let near = closed(0.0, None)?;
        closed(x, Some(&near)).map(|motion| *motion.multipliers())
    }
    let own = forces(Dual64::from(0.0).derivative())?;
    let h = 1e-3;
    let [a, b, c, d] = [forces(-2.0 * h)?, forces(-h)?, forces(h)?, forces(2.0 * h)?];
    for k in 0..5 {
        let difference = (a[k] - 8.0 * b[k] + 8.0 * c[k] - d[k]) / (12.0 * h);
        println!("force {k}: derivative {:.9}, difference {difference:.9}", own[k].eps);
        assert!((own[k].eps - difference).abs() < 1e-8 * difference.abs().max(1.0)); // h⁴, 1e-15 / h
    }
    Ok(())
}

/// Hinges with parallel axes hold more than a plane mechanism needs; one that follows from the others is named.
#[test]
fn parallel_hinges_are_redundant() -> Result<(), Error> {
    let (along, rod) = ([0.0, 0.0, 1.0], |length| Rod::uniform(length, 0.02, 1.0));
    let chain = (rod(0.5), Revolute::about(along), rod(1.2), Revolute::about(along), rod(0.9));
    let four_bar = System::new(Hinged::at([0.0; 3], along), chain, Hinged::at([1.0, 0.0, 0.0], along))?;
    let start = four_bar.at_rest(&[FRAC_PI_3, -0.726092536365, -2.338443848203])?;
    let error = four_bar.with_accelerations(start, &Unloaded).err();
    let fault = error.map(|error| (error.fault, error.place));
    println!("{error:?}");
    let Some((Fault::RedundantClosures { independent, of, .. }, place)) = fault else { panic!("{fault:?}") };
    assert_eq!((independent, of, place), (2, 5, Some(Place::Tip)));
    Ok(())
}
