//! Steps with their Jacobians, several rows at a time: those found row by row.

use catena::planar::*;
use catena::scalar::Pack;

/// Both ways, with `N` rows at a time.
fn both<const N: usize>() {
    type P<const N: usize> = Pack<f64, N>;
    let rod = Rod::uniform(0.8, 1.3);
    let hinge = ElasticHinge::rotary(4.0).damped(0.2);
    let scene = System::new(Pinned::origin(), (rod, hinge, rod, Pin, rod), Free).unwrap().with_gravity(9.81);
    let mut now = scene.at_rest(&[-1.0, -0.5, 0.3]).unwrap().at_time(0.7);
    now.set_rates(&[0.5, -1.0, 0.8]).unwrap();
    let torques = [0.3, -0.8, 0.2];
    let (mut next, mut a, mut b) = (now, [0.0_f64; 36], [0.0; 18]);
    scene.backward(Dopri5).linearised_step(&now, 0.04, &torques, &mut next, &mut a, &mut b).unwrap();
    let (packed, start) = (scene.lift(P::<N>::of), now.lift(P::<N>::of));
    let (mut end, mut by_state, mut by_torques) = (start, [f64::NAN; 36], [f64::NAN; 18]);
    let mut backward = packed.backward(Dopri5);
    let torques = torques.map(Pack::of);
    for _ in 0..2 {
        backward.linearised_step_in_rows(&start, 0.04, &torques, &mut end, &mut by_state, &mut by_torques).unwrap();
        let far = a
            .iter()
            .zip(&by_state)
            .chain(b.iter().zip(&by_torques))
            .find(|(x, y)| (*x - *y).is_nan() || (*x - *y).abs() >= 1e-13);
        assert!(far.is_none(), "{N}: {far:?} in {a:?}, {by_state:?}");
        let ends =
            end.coordinates().into_iter().chain(end.rates()).zip(next.coordinates().into_iter().chain(next.rates()));
        ends.for_each(|(x, y)| assert!(x.0.iter().all(|x| (x - y).abs() < 1e-14)));
    }
    let fault = backward.linearised_step_in_rows(&start, 0.04, &torques, &mut end, &mut [0.0; 35], &mut []);
    assert!(matches!(fault.unwrap_err().fault, catena::Fault::Count { expected: 36, given: 35, .. }));
}

#[test]
fn rows_at_a_time_are_rows_one_by_one() {
    both::<1>();
    both::<4>();
}

/// In space, where three numbers act in a joint: a ball, a hinge and links.
#[test]
fn rows_at_a_time_are_rows_one_by_one_in_space() {
    use catena::{robot, spatial};
    type P = Pack<f64, 4>;
    macro_rules! both {
        ($scene:expr, $rates:expr, $rows:literal, $joints:literal) => {{
            let scene = $scene;
            let mut now = scene.motion();
            now.set_rates(&$rates).unwrap();
            let torques: [_; $joints] = core::array::from_fn(|k| spatial::Effort([0.3 - 0.1 * k as f64, 0.2, -0.1]));
            let (mut next, mut a) = (now, [0.0_f64; $rows * $rows]);
            let mut b = [spatial::Effort([0.0; 3]); $rows * $joints];
            scene.backward(Rk4).linearised_step(&now, 0.04, &torques, &mut next, &mut a, &mut b).unwrap();
            let (packed, start) = (scene.lift(P::of), now.lift(P::of));
            let (mut end, mut by_state, mut by_torques) =
                (start, [f64::NAN; $rows * $rows], b.map(|_| spatial::Effort([f64::NAN; 3])));
            let torques = torques.map(|torque| spatial::Effort(torque.0.map(P::of)));
            let mut backward = packed.backward(Rk4);
            backward.linearised_step_in_rows(&start, 0.04, &torques, &mut end, &mut by_state, &mut by_torques).unwrap();
            assert!(a.iter().zip(&by_state).all(|(x, y)| (x - y).abs() < 1e-13), "{a:?} {by_state:?}");
            let mut largest = 0.0_f64;
            for (x, y) in b.iter().zip(&by_torques).flat_map(|(x, y)| x.0.iter().zip(&y.0)) {
                assert!((x - y).abs() < 1e-13, "{x} {y}");
                largest = largest.max(x.abs());
            }
            assert!(largest > 1e-3, "{largest}");
        }};
    }
    let rod = spatial::Rod::uniform(0.5, 0.05, 1.0);
    let hinge = spatial::Revolute::about([0.0, 1.0, 0.0]);
    let chain = (rod, spatial::Ball, rod, hinge, rod);
    let scene = spatial::System::new(spatial::Pinned::origin(), chain, spatial::Free).unwrap();
    both!(scene.with_gravity([0.3, -9.81, 0.1]), [0.3, 0.5, -0.2, 1.0, 0.4, 0.2, -0.5], 14, 3);
    let link = robot::Link::general(1.0, [0.02, 0.01, 0.2], [[0.06, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.02]]);
    let elbow = robot::Hinge::at::<0b111>([0.05, -0.02, 0.4]).turned(robot::Quarter::<30>);
    let chain = (robot::Hinge::level().grounded(), link, elbow, link);
    let scene = robot::System::new(robot::Base::origin(), chain, spatial::Free).unwrap();
    both!(scene.with_gravity([0.3, -9.81, 0.1]), [1.0, -0.5], 4, 3);
}

/// Dual numbers are equal where their real parts are: sines know better.
#[test]
fn sines_of_packs_keep_derivatives_apart() {
    use catena::num_dual::Dual64;
    use catena::{Elementary, Scalar};
    let x = Pack([Dual64::new(0.5, 1.0), Dual64::new(0.5, 2.0)]);
    let (sine, cosine) = x.sin_cos();
    for k in 0..2 {
        let (by_sine, by_cosine) = (0.5_f64.cos() * x.0[k].eps, -0.5_f64.sin() * x.0[k].eps);
        assert!((sine.0[k].eps - by_sine).abs() < 1e-15 && (cosine.0[k].eps - by_cosine).abs() < 1e-15);
    }
    assert!(!x.is_identical(Pack::of(x.0[0])) && x.is_identical(x));
}

/// Numbers that differ side by side would be rows of different steps.
#[test]
fn rows_of_different_steps_are_refused() {
    let rod = Rod::uniform(1.0_f64, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free).unwrap().lift(Pack::<f64, 2>::of);
    let now = scene.at_rest(&[0.3, 0.1].map(Pack::of)).unwrap();
    let (mut next, mut a, mut backward) = (now, [0.0; 16], scene.backward(Rk4));
    let mut refused = |now: &_, torques: &[Pack<f64, 2>]| {
        let found = backward.linearised_step_in_rows(now, 0.01, torques, &mut next, &mut a, &mut []).unwrap_err();
        assert!(matches!(found.fault, catena::Fault::Unsupported { .. }), "{found}");
    };
    refused(&now, &[Pack::of(0.0), Pack([0.0, 1.0])]);
    let mut other = now;
    other.rate_mut().0 = Pack([0.0, 1.0]);
    refused(&other, &[]);
}
