//! The paper's scheme on linear springs and dampers, (33) and (35): against order 8, a closed form and itself.
#![cfg(feature = "std")]

use catena::loading::Unloaded;
use catena::paper::{At, GeneralizedAlpha, JointScheme, Midpoint, Newmark, Scheme, Solver, Wilson};
use catena::planar::Absent;
use catena::planar::index::{M, QX, QY, THETA, X, Y};
use catena::planar::*;
use catena::{Error, Fault, Place};
use catena_oracle::{has_order, near};

/// Errors of angles, of the places of all stations, and of all forces relative to their largest, against order 8 at three steps.
macro_rules! orders {
    ($name:expr, $scene:expr, $start:expr, $loads:expr, $end:expr, $order:expr, $scheme:expr) => {{
        let (scene, loads) = (&$scene, &$loads);
        let start = scene.with_accelerations($start.clone(), loads)?;
        let exact = scene.simulation(Dop853::tolerance(1e-12)).loads(loads).run(start.clone(), $end, |_| ())?.motion;
        let (stations, expected) = (scene.stations(&exact, loads).unwrap(), scene.angles(&exact).unwrap());
        let (mut angles, mut places, mut forces) = (vec![], vec![], vec![]);
        for dt in [0.002, 0.001, 0.0005] {
            let mut run = $scheme.start(scene, &start, loads, dt)?;
            run.run_to($end)?;
            let angle = run.angles().zip(expected.iter()).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()));
            let (mut place, mut force, mut largest) = (0.0_f64, 0.0_f64, 0.0_f64);
            for (k, z) in run.stations()[1..].iter().enumerate() {
                let state = stations.get(k).unwrap().state();
                for i in [X, Y] {
                    place = place.max((z[i] - state[i]).abs());
                }
                for i in [M, QX, QY] {
                    force = force.max((z[i] - state[i]).abs());
                    largest = largest.max(state[i].abs());
                }
                assert!((z[THETA] - state[THETA]).abs() < 10.0 * dt, "{} {k}: {z:?} {state:?}", $name);
            }
            angles.push((dt, angle));
            places.push((dt, place));
            forces.push((dt, force / largest));
        }
        has_order(&format!("{}, angles", $name), $order, 1e-11, &angles);
        has_order(&format!("{}, places", $name), $order, 1e-11, &places);
        has_order(&format!("{}, forces", $name), $order, 1e-10, &forces);
    }};
}

/// The formulations of second order.
macro_rules! all_orders {
    ($scene:expr, $start:expr, $loads:expr, $end:expr) => {{
        let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).solved_by(Solver::Riccati);
        for at in [At::Previous, At::Predictor, At::Iterated] {
            orders!(format!("{at:?}"), $scene, $start, $loads, $end, 2.0, scheme.linearized(at));
        }
        let newmark = Scheme::new(Newmark::damped(0.6)).solved_by(Solver::Riccati);
        orders!("Newmark 0.6", $scene, $start, $loads, $end, 1.0, newmark);
    }};
}

fn plate() -> RigidBody<f64> {
    RigidBody::new(0.9, 0.05, [0.3, 0.1], [0.7, -0.2])
}

type Full = ElasticHinge<Spring<f64, f64, f64>, Linear<f64, Spring<f64, f64, f64>, Spring<f64, f64, f64>, Unbalanced>>;

/// All that a hinge may have.
fn full() -> Full {
    ElasticHinge::rotary(3.0)
        .damped(0.2)
        .resting_at(0.4)
        .with_linear(Spring::new(60.0).damped(0.8).resting_at(0.1), Spring::new(40.0).damped(0.3).resting_at(-0.05))
        .in_unbalanced_axes()
}

type Shock = ElasticHinge<Absent, Linear<f64, Spring<f64>, Spring<f64, f64>, Unbalanced>>;

/// A spring along x and a damper alone along y, between bodies that turn freely.
fn shock() -> Shock {
    ElasticHinge::linear(Spring::new(50.0), Spring::new(0.0).damped(6.0)).in_unbalanced_axes()
}

#[test]
fn springs_and_dampers_between_bodies_have_order_two() -> Result<(), Error> {
    let rod = Rod::new(0.8, 1.3, 0.3, 0.07);
    let scene = System::new(Pinned::origin(), (plate(), full(), rod, shock(), plate(), Pin, rod), Free)?;
    let scene = scene.with_gravity(9.81);
    let mut start = scene.motion();
    *start.position_mut() = (-0.3, ((), (0.15, -0.1, 0.3), (), (-0.1, 0.05, 0.2), (), 0.9, ()));
    *start.rate_mut() = (1.0, ((), (0.2, -0.3, 0.5), (), (0.1, 0.2, -0.5), (), 0.3, ()));
    all_orders!(scene, start, Unloaded, 0.4);
    let loads = Loads::none()
        .in_joints(|t, joint, motion: &JointMotion<f64>| 0.3 * f64::sin(t + joint as f64) - 0.05 * motion.rate())
        .on_bodies(|t, body, motion: &BodyMotion<f64>| {
            motion.force_at([0.1, 0.2], [f64::cos(3.0 * t), 0.2 * body as f64 - 0.1 * motion.rate()])
        });
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(At::Predictor);
    orders!("loads, Riccati", scene, start, loads, 0.4, 2.0, scheme.solved_by(Solver::Riccati));
    Ok(())
}

/// By the product, at steps at which it keeps its digits.
#[test]
fn product_has_order_two_on_springs() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 0.8);
    let scene = System::new(Pinned::origin(), (plate(), full(), rod), Free)?.with_gravity(9.81);
    let mut start = scene.motion();
    *start.position_mut() = (-0.3, ((), (0.15, -0.1, 0.3), ()));
    *start.rate_mut() = (1.0, ((), (0.2, -0.3, 0.5), ()));
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8));
    orders!("as printed, product", scene, start, Unloaded, 0.4, 2.0, scheme);
    orders!("predictor, product", scene, start, Unloaded, 0.4, 2.0, scheme.linearized(At::Predictor));
    orders!("Newmark 0.6, product", scene, start, Unloaded, 0.4, 1.0, Scheme::new(Newmark::damped(0.6)));
    Ok(())
}

/// A hinge on ground that moves and turns, and chains that float.
#[test]
fn springs_on_the_ground_and_of_floating_chains_have_order_two() -> Result<(), Error> {
    let rod = Rod::uniform(0.4, 0.5);
    let shaken = Clamped {
        place: Moving(|t: f64| GroundMotion {
            place: [0.1 * (4.0 * t).sin(), 0.2],
            velocity: [0.4 * (4.0 * t).cos(), 0.0],
            acceleration: [-1.6 * (4.0 * t).sin(), 0.0],
        }),
        attitude: Turning(|t: f64| [0.2 * (3.0 * t).sin(), 0.6 * (3.0 * t).cos(), -1.8 * (3.0 * t).sin()]),
    };
    let scene = System::new(shaken, (full(), plate(), Pin, rod), Free)?.with_gravity(9.81);
    let mut start = scene.motion();
    *start.position_mut() = ((), ((0.15, -0.1, 0.3), (), -0.4, ()));
    *start.rate_mut() = ((), ((0.2, -0.3, 0.5), (), 1.0, ()));
    all_orders!(scene, start, Unloaded, 0.4);

    let scene = System::new(Free, (plate(), full(), rod, Pin, rod), Free)?.with_gravity(1.0);
    let mut start = scene.motion();
    *start.position_mut() = ((0.1, 0.2, 0.5), ((), (0.15, -0.1, 0.3), (), -0.4, ()));
    *start.rate_mut() = ((0.3, -0.1, 1.0), ((), (0.2, -0.3, 0.5), (), 1.0, ()));
    all_orders!(scene, start, Unloaded, 0.4);
    Ok(())
}

/// A tip on a pin; a joint that nothing holds along one axis, of which there is no transfer matrix.
#[test]
fn held_tips_and_free_axes_have_order_two() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 0.4);
    let scene = System::new(Pinned::origin(), (rod, Pin, plate(), full(), rod), Pinned::at(1.5, 0.1))?;
    let scene = scene.with_gravity(9.81);
    let mut guess = scene.motion();
    *guess.position_mut() = (-0.9, ((), 0.1, (), (0.05, -0.1, 0.4), ()));
    let start = scene.assembled(guess, &Unloaded)?;
    all_orders!(scene, start, Unloaded, 0.3);

    let free = ElasticHinge::rotary(3.0).with_linear(Absent, Spring::new(40.0)).in_unbalanced_axes();
    let scene = System::new(Pinned::origin(), (rod, free, plate()), Free)?.with_gravity(9.81);
    let mut start = scene.motion();
    *start.position_mut() = (-0.9, ((), (0.05, -0.1, 0.4), ()));
    all_orders!(scene, start, Unloaded, 0.3);
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8));
    let error = scheme.start(&scene, &start, &Unloaded, 0.01).map(|_| ()).unwrap_err();
    println!("{error}");
    assert!(matches!(error.fault, Fault::Unsupported { what } if what.contains("solve by Riccati")));
    assert_eq!(error.place, Some(Place::Station(1)));
    Ok(())
}

/// Where forces balance elsewhere than at t_i.
#[test]
fn other_rules_keep_order_two_on_springs() -> Result<(), Error> {
    // Without rigid joints the midpoint rule lives.
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), (full(), plate()), Free)?.with_gravity(9.81);
    let mut start = scene.motion();
    *start.position_mut() = ((), ((0.15, -0.1, 0.3), ()));
    let exact = scene.simulate(start, Dop853::tolerance(1e-12), 0.4, |_| ())?.motion;
    let exact = *scene.angles(&exact)?.get(0).unwrap();
    macro_rules! rule {
        ($rule:expr) => {{
            let scheme = Scheme::new($rule).linearized(At::Predictor).solved_by(Solver::Riccati);
            let points = [0.002, 0.001, 0.0005].map(|dt| -> Result<(f64, f64), Error> {
                let mut run = scheme.start(&scene, &start, &Unloaded, dt)?;
                run.run_to(0.4)?;
                Ok((dt, (run.turn(0).unwrap()[0] - exact).abs()))
            });
            let points: Result<Vec<_>, Error> = points.into_iter().collect();
            has_order(&format!("{:?}", $rule), 2.0, 1e-11, &points?);
        }};
    }
    rule!(Wilson::new(1.42));
    rule!(Midpoint);
    Ok(())
}

#[test]
fn product_and_transform_agree_on_springs() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 0.8);
    let scene = System::new(Pinned::origin(), (plate(), full(), rod, shock(), plate()), Free)?.with_gravity(9.81);
    let mut start = scene.motion();
    *start.position_mut() = (-0.3, ((), (0.15, -0.1, 0.3), (), (-0.1, 0.05, 0.2), ()));
    for at in [At::Previous, At::Predictor, At::Iterated] {
        let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(at);
        let mut product = scheme.start(&scene, &start, &Unloaded, 0.01)?;
        let mut transform = scheme.solved_by(Solver::Riccati).start(&scene, &start, &Unloaded, 0.01)?;
        for _ in 0..5 {
            product.step()?;
            transform.step()?;
        }
        let (mut place, mut force) = (0.0_f64, 0.0_f64);
        for (a, b) in product.stations().iter().zip(transform.stations()) {
            place = [X, Y, THETA].into_iter().fold(place, |worst, i| worst.max((a[i] - b[i]).abs()));
            force = [M, QX, QY].into_iter().fold(force, |worst, i| worst.max((a[i] - b[i]).abs()));
        }
        println!("{at:?}: places {place:.1e}, forces {force:.1e}");
        // Terms of χ₁ m of 4e4: one unit in the last place of a stiffness moves places between 5e-12 and 1.8e-10.
        assert!(place < 4e-10 && force < 1e-7);
    }
    Ok(())
}

/// Rods that hang on springs stretched by the weight of all below stay there.
#[test]
fn hanging_springs_stay_in_equilibrium() -> Result<(), Error> {
    let (mass, weight, k) = (0.5, 0.5 * 9.81, 80.0);
    let hinge = ElasticHinge::linear(Spring::new(30.0), Spring::new(k)).in_unbalanced_axes();
    let rod = Rod::uniform(0.2, mass);
    let scene = System::new(Clamped::at(0.0, 1.0, 0.0), (hinge, rod, hinge, rod, hinge, rod), Free)?;
    let scene = scene.with_gravity(9.81);
    let down = -core::f64::consts::FRAC_PI_2;
    let sag = |below: f64| -below * weight / k;
    let mut start = scene.motion();
    *start.position_mut() = ((), ((0.0, sag(3.0), down), (), (0.0, sag(2.0), 0.0), (), (0.0, sag(1.0), 0.0), ()));
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(At::Predictor).solved_by(Solver::Riccati);
    let mut run = scheme.start(&scene, &start, &Unloaded, 0.01)?;
    run.run_to(5.0)?;
    let mut y = 1.0;
    for body in 0..3 {
        let z = run.stations()[2 * body + 2];
        y += sag(3.0 - body as f64);
        near(z[X], 0.0, 1e-13);
        near(z[Y], y, 1e-13);
        near(z[QY], (3.0 - body as f64) * weight, 1e-11);
        y -= 0.2;
    }
    Ok(())
}

/// A mass between two springs across each other: x = a cos ωt, and the energy of an undamped rule.
#[test]
fn a_mass_on_springs_swings_as_it_should() -> Result<(), Error> {
    let (mass, k, offset) = (0.7, [50.0_f64, 20.0], [0.2, -0.1]);
    let hinge = ElasticHinge::rotary(1.0).with_linear(Spring::new(k[0]), Spring::new(k[1])).in_unbalanced_axes();
    let body = RigidBody::new(mass, 0.1, [0.0; 2], [0.0; 2]);
    let scene = System::new(Clamped::at(0.3, 0.0, 0.0), (hinge, body), Free)?;
    let mut start = scene.motion();
    *start.position_mut() = ((), ((offset[0], offset[1], 0.1), ()));
    let at = |axis: usize, t: f64| offset[axis] * ((k[axis] / mass).sqrt() * t).cos();
    // Every coordinate of a body that nothing holds is its own, so γ = ½ rings nowhere.
    let scheme = Scheme::new(Newmark::new(0.25, 0.5)).solved_by(Solver::Riccati);
    let mut points = vec![];
    for dt in [0.004, 0.002, 0.001] {
        let mut run = scheme.start(&scene, &start, &Unloaded, dt)?;
        run.run_to(2.0)?;
        let z = run.stations()[2];
        points.push((dt, (z[X] - 0.3 - at(0, 2.0)).abs().max((z[Y] - at(1, 2.0)).abs())));
        near(z[QX], -k[0] * (z[X] - 0.3), 1e-11);
        near(z[QY], -k[1] * z[Y], 1e-11);
    }
    has_order("oscillator", 2.0, 1e-12, &points);

    // The trapezoidal rule keeps the energy of linear springs: ½ k x² returns to its start.
    let mut run = scheme.start(&scene, &start, &Unloaded, 0.01)?;
    let mut largest = 0.0_f64;
    for _ in 0..20_000 {
        run.step()?;
        largest = largest.max((run.stations()[2][X] - 0.3).abs());
    }
    assert!(largest <= offset[0] * (1.0 + 1e-10) && largest > 0.999 * offset[0], "{largest}");
    Ok(())
}

/// Two plates that float, on springs with a large rest length: what the rule dissipates or adds falls with its order.
#[test]
fn energy_of_floating_plates_drifts_with_order_two() -> Result<(), Error> {
    let (k, rest) = ([60.0, 40.0], [0.3, -0.1]);
    let spring = |i: usize| Spring::new(k[i]).resting_at(rest[i]);
    let hinge = ElasticHinge::rotary(2.0).with_linear(spring(0), spring(1)).in_unbalanced_axes();
    let scene = System::new(Free, (plate(), hinge, plate()), Free)?;
    let mut start = scene.motion();
    *start.position_mut() = ((0.0, 0.0, 0.2), ((), (0.4, 0.0, 0.3), ()));
    *start.rate_mut() = ((0.1, 0.2, 0.3), ((), (0.2, -0.3, 0.5), ()));
    let exact = scene.simulate(start, Dop853::tolerance(1e-13), 0.6, |_| ())?.motion;
    let potential = |stations: &[catena::StateVector<f64, 7>]| {
        let (i, o) = (stations[2], stations[3]);
        let bend: f64 = o[THETA] - i[THETA];
        bend * bend + (0..2).map(|axis| 0.5 * k[axis] * (o[axis] - i[axis] - rest[axis]).powi(2)).sum::<f64>()
    };
    let expected = scene.budget(&exact)?.potential;
    let mut points = vec![];
    for dt in [0.004, 0.002, 0.001] {
        let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(At::Predictor).solved_by(Solver::Riccati);
        let mut run = scheme.start(&scene, &start, &Unloaded, dt)?;
        run.run_to(0.6)?;
        points.push((dt, (potential(run.stations()) - expected).abs()));
    }
    has_order("energy stored", 2.0, 1e-11, &points);
    Ok(())
}

/// ∂(tip)/∂k against central differences.
#[cfg(feature = "num-dual")]
#[test]
fn derivatives_by_stiffness_agree_with_differences() -> Result<(), Error> {
    use num_dual::Dual64;
    macro_rules! tip {
        ($T:ty, $k:expr, $of:expr, $solver:expr) => {{
            let of = $of;
            let rod = Rod::uniform(of(0.5), of(0.8));
            let spring = Spring::new($k).damped(of(0.4)).resting_at(of(0.05));
            let hinge = ElasticHinge::rotary(of(3.0)).with_linear(spring, spring).in_unbalanced_axes();
            let scene = System::new(Pinned::on([of(0.0); 2]), (rod, hinge, rod), Free)?.with_gravity(of(9.81));
            let start = scene.at_rest(&[of(-0.5), of(0.3)])?;
            let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(At::Predictor).solved_by($solver);
            let mut run = scheme.start(&scene, &start, &Unloaded, 0.01)?;
            run.run_to(0.3)?;
            let z = run.stations().last().unwrap();
            [z[X], z[Y], run.stations()[0][QX]]
        }};
    }
    for solver in [Solver::Riccati, Solver::Product] {
        let dual = tip!(Dual64, Dual64::new(60.0, 1.0), Dual64::from_re, solver);
        let plain = |k: f64| -> Result<[f64; 3], Error> { Ok(tip!(f64, k, |x: f64| x, solver)) };
        // Of fourth order, at a step so long that the rounding of the product, 1e-11, does not show.
        let h = 0.05;
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| plain(60.0 + k * h));
        let (a, b, c, d) = (a?, b?, c?, d?);
        for i in 0..3 {
            let difference = (8.0 * (c[i] - b[i]) - (d[i] - a[i])) / (12.0 * h);
            println!("{solver:?}: {:e} {difference:e}", dual[i].eps);
            assert!(dual[i].eps.abs() > 1e-4);
            near(dual[i].eps, difference, 1e-6 * difference.abs() + 1e-9);
        }
    }
    Ok(())
}

#[test]
fn other_linear_springs_are_refused_with_their_cure() -> Result<(), Error> {
    let rod = Rod::uniform(0.3, 0.4);
    let spring = Spring::new(100.0);
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8));
    macro_rules! refused {
        ($scheme:expr, $scene:expr, $words:expr, $place:expr) => {{
            let scene = $scene?;
            let error = $scheme.start(&scene, &scene.motion(), &Unloaded, 0.01).map(|_| ()).unwrap_err();
            println!("{error}");
            assert!(matches!(error.fault, Fault::Unsupported { what } if what.contains($words)), "{error}");
            assert_eq!(error.place, $place);
        }};
    }
    let hinge = ElasticHinge::rotary(3.0).with_linear(spring, spring);
    let station = |k| Some(Place::Station(k));
    let cure = "in_unbalanced_axes";
    refused!(scheme, System::new(Pinned::origin(), (rod, hinge, rod), Free), cure, station(1));
    refused!(scheme, System::new(Pinned::origin(), (rod, hinge.in_fixed_axes(), rod), Free), cure, station(1));
    let hinge = hinge.in_unbalanced_axes();
    let slider = Slider::along(0.0);
    refused!(scheme, System::new(Pinned::origin(), (rod, slider, rod), Free), "slides", station(1));
    refused!(scheme, System::new(Clamped::at(0.0, 0.0, 0.0), (slider, rod), Free), "slides", station(0));
    let beside = "next to another joint";
    refused!(scheme, System::new(Pinned::origin(), (rod, Weld::at(0.2), hinge, rod), Free), beside, station(2));
    let joints = JointScheme::new(GeneralizedAlpha::new(0.8));
    refused!(joints, System::new(Pinned::origin(), (rod, hinge, rod), Free), "take `Scheme`", None);
    Ok(())
}
