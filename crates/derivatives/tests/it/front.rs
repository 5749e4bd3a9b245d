//! Both ways of the front door: forward and backward agree, and say what they are; products with the Hessian against differences.

use catena::sensitivity::{Plan, Way};
use core::cell::Cell;

/// Both ways, and a product with the Hessian along a direction against differences of Jacobians.
macro_rules! agree {
    ($run:expr, $x:expr) => {{
        let (run, x): (_, Vec<f64>) = ($run, $x);
        let (forward, backward) =
            (run.jacobian_by(&x, Way::Forward).unwrap(), run.jacobian_by(&x, Way::Backward).unwrap());
        assert_eq!((forward.way, backward.way), (Way::Forward, Way::Backward));
        let alike = |a: &[f64], b: &[f64], tolerance: f64| {
            let size = a.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            assert!(a.len() == b.len() && size > 0.0);
            let far = a.iter().zip(b).find(|(a, b)| (*a - *b).is_nan() || (*a - *b).abs() > tolerance * size);
            assert!(far.is_none(), "{far:?} in {a:?} and {b:?}");
        };
        alike(&forward.values, &backward.values, 1e-13);
        let direction: Vec<f64> = (0..x.len()).map(|k| (2.0 + k as f64).sin()).collect();
        let products = run.hessian_times(&x, &direction).unwrap();
        let at = |e: f64| {
            let x: Vec<f64> = x.iter().zip(&direction).map(|(x, d)| x + e * d).collect();
            run.jacobian(&x).unwrap()
        };
        alike(&forward.values, &products.values, 1e-13);
        let (up, down) = (at(1e-5), at(-1e-5));
        for (k, row) in forward.rows.iter().enumerate() {
            alike(row, &backward.rows[k], 1e-12);
            let slope: Vec<f64> = up.rows[k].iter().zip(&down.rows[k]).map(|(a, b)| (a - b) / 2e-5).collect();
            alike(&products.rows[k], &slope, 1e-7);
        }
    }};
}

#[test]
fn both_ways_in_the_plane() {
    use catena::planar::*;
    let plan = Plan { method: Rk4, step: 0.02, steps: 10, torques: 30, outputs: 2 };
    let seen = &Cell::new(0);
    let run = catena::differentiable!(
        Number,
        plan,
        |x| {
            let (first, second) = (Rod::uniform(x[0], x[1]), RigidBody::new(x[2], x[3], [x[4], x[5]], [x[0], x[6]]));
            let hinge = ElasticHinge::rotary(x[7]).damped(x[8]);
            let scene = System::new(Pinned::at(x[9], x[0]), (first, hinge, second, Pin, first), Free)?;
            let scene = scene.with_gravity(x[10]);
            // A start that depends on a parameter.
            let start = scene.with_rates(scene.at_rest(&[x[11], x[12] * x[0], x[13]])?, &x[14..17])?;
            (scene, start)
        },
        |step, scene, now, y| {
            let tip = scene.stations(now, &Unloaded).unwrap().tip().frame;
            seen.set(seen.get() + 1);
            y[0] += tip.place.x * tip.place.y * Number::literal(0.1 + step as f64);
            if step == 10 {
                y[1] = scene.budget(now).unwrap().kinetic;
            }
        }
    );
    let mut x = vec![0.8, 1.1, 0.7, 0.1, 0.3, -0.1, 0.05, 4.0, 0.2, 0.1, 9.81, -1.0, 0.4, -0.5, 0.2, 0.3, -0.4];
    x.extend((0..30).map(|k| (k as f64).sin()));
    agree!(run, x.clone());
    // Backward, outputs are read of each state once, however many they are: by six numbers of the state, by 17 inputs in eights.
    seen.set(0);
    run.jacobian_by(&x, Way::Backward).unwrap();
    assert_eq!(seen.get(), 11 * (1 + 3));
}

#[test]
fn both_ways_in_space() {
    use catena::spatial::*;
    let plan = Plan { method: Rk4, step: 0.05, steps: 3, torques: 6, outputs: 1 };
    let made = |plan: Plan<Rk4>| {
        catena::differentiable!(
            Number,
            plan,
            |x| {
                let rod = Rod::uniform(x[0], Number::literal(0.2), x[1]);
                let zero = Number::literal(0.0);
                let hinge = Revolute::about([x[2], x[3], Number::literal(1.0)]);
                let root = Pinned::on([zero; 3]);
                let scene = System::new(root, (rod, hinge, rod), Free)?.with_gravity([zero, x[4], x[5]]);
                let start = scene.with_rates(scene.at_rest(&x[6..10])?, &x[10..14])?;
                (scene, start)
            },
            |step, scene, now, y| {
                let place = scene.stations(now, &Unloaded).unwrap().tip().frame.place;
                y[0] += place.dot(&place) * place.z * Number::literal(if step == 3 { 1.0 } else { 0.1 });
            }
        )
    };
    let mut x = vec![0.8, 1.1, 0.3, 0.2, 1.0, -9.0];
    x.extend((0..14).map(|k| 0.5 * (k as f64).sin()));
    agree!(made(plan), x.clone());
    // A number more than one step takes.
    x.push(0.1);
    for way in [Way::Forward, Way::Backward] {
        let fault = made(Plan { torques: 7, ..plan }).jacobian_by(&x, way).unwrap_err().fault;
        assert!(matches!(fault, catena::Fault::Count { expected: 18, given: 7, .. }), "{fault:?}");
    }
}

#[test]
fn counts_decide() {
    assert_eq!(Way::cheaper(0, 10), (Way::Forward, 6.0));
    assert_eq!(Way::cheaper(3, 10).0, Way::Forward);
    assert_eq!(Way::cheaper(3, 1).0, Way::Backward);
    assert_eq!(Way::cheaper(600, 10).0, Way::Backward);
}
