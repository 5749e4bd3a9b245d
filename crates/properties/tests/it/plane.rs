//! Scenes in the plane.

use crate::draws::*;
use catena::planar::*;
use proptest::prelude::*;

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn chains_of_anything((x, m) in (numbers(), sizes()), q in numbers(), (h, tolerance) in rule(), end in positive(), every in positive()) {
        let spring = |k: usize| Spring::new(x[k]).damped(x[k + 1]);
        let chain = (
            Rod::new(m[0], m[1], m[0] * x[20], m[2]),
            Pin,
            RigidBody::new(m[3], m[4], [x[0], x[1]], [x[2], x[3]]),
            Weld::at(x[4]),
            Rod::uniform(m[5], m[6]),
            Slider::along(x[5]).with(spring(6)),
            PointMass::new(m[7], m[8]),
            ElasticHinge::rotary(m[9]).damped(m[10]).resting_at(x[8]).with_linear(spring(9), spring(11)),
            Rod::uniform(m[11], m[12]),
        );
        let made = System::new(Pinned::at(x[13], x[14]), chain, Free);
        probe!(made, &q, 10.0 * x[15], end, every, [Rk4::step(h), Dop853::tolerance(tolerance), Sdirk4::new().step(h)]);
    }

    #[test]
    fn held_and_guided_chains((x, m) in (numbers(), sizes()), q in numbers(), (h, tolerance) in rule(), end in positive(), every in positive()) {
        let links = vec![(Pin, Rod::uniform(m[0], m[1])); 1 + (x[0].abs() * 2.0).min(4.0) as usize];
        let chain = (Rod::uniform(m[2], m[3]), Branch((Pin, Rod::uniform(m[4], m[5]))), links);
        let made = System::new(Guided::at(x[1], x[2], x[3]), chain, Pinned::at(x[4], x[5]));
        if let Ok(scene) = &made {
            let start = scene.at_rest(&q[..scene.joints() - 1]);
            match start.and_then(|start| scene.assembled(start, &Unloaded)) {
                Err(error) => crate::probe::told(&error),
                Ok(start) => {
                    prop_assert!(start.is_finite());
                    run!(scene, Dop853::tolerance(tolerance), start, end, every);
                    run!(scene, Adams::tolerance(tolerance), start, end, every);
                }
            }
        }
        probe!(made, &q, 10.0 * x[15], end, every, [Vcabm::new().tolerance(tolerance), Rk4::step(h)]);
    }

    #[test]
    fn lists_of_any_length((x, m) in (numbers(), sizes()), lengths in prop::array::uniform4(0..7_usize), body in 0..5_usize) {
        let rod = Rod::uniform(1.0, if m[0].is_finite() { m[0].clamp(0.1, 10.0) } else { 1.0 });
        let scene = System::new(Pinned::origin(), (rod, vec![(Pin, rod); 3]), Free).unwrap().with_gravity(9.81);
        let told = |error: catena::Error| crate::probe::told(&error);
        let [a, b, c, d] = lengths;
        let start = scene.at_rest(&x[..a]).map_err(told).unwrap_or(scene.motion());
        let start = scene.with_rates(start.clone(), &x[..b]).map_err(told).unwrap_or(start);
        let start = scene.with_body_rates(start.clone(), &x[..c]).map_err(told).unwrap_or(start);
        let torques = Loads::none().torques(x[..d].to_vec());
        let _ = scene.with_accelerations(start.clone(), &torques).map_err(told).map(|motion| assert!(motion.is_finite()));
        let strut = Strut::between((body, [x[8], x[9]]), (a, [x[10], x[11]])).with_stiffness(x[12]).with_length(x[13]).with_damping(x[14]);
        let _ = scene.with_accelerations(start.clone(), &Struts::of([strut])).map_err(told).map(|motion| assert!(motion.is_finite()));
        let _ = scene.joint(a).map_err(told).map(|joint| start.coordinates_of::<1>(joint).map_err(told));
        let _ = scene.body(b).map_err(told);
        let _ = scene.equilibrium(start.clone(), &Unloaded).map_err(told).map(|motion| assert!(motion.is_finite()));
    }

    #[test]
    fn beams_of_any_stiffness(m in sizes(), x in numbers(), count in 0..9_usize, h in positive()) {
        let beam = Beam::new(m[0], m[1], m[2]).segments_in_vec(count);
        let made = System::new(Clamped::at(x[0], x[1], x[2]), beam, Free);
        let q = vec![0.01; 32];
        probe!(made, &q, x[3], 0.1, h, [GeneralizedAlpha::new(m[4]).tolerance(1e-4), GeneralizedAlpha::newmark(x[5], x[6]).step(h)]);
    }

    /// What nobody would refuse conserves its energy: garbage does not.
    #[test]
    fn everyday_chains_conserve_energy((x, m) in plain()) {
        let chain = (
            RigidBody::new(m[0], m[1], [x[0], x[1]], [1.0 + x[2] / 2.0, x[3]]),
            Pin,
            Rod::uniform(m[2], m[3]),
            ElasticHinge::rotary(m[4]).with_linear(Spring::new(20.0 * m[5]), Spring::new(20.0 * m[6])),
            RigidBody::new(m[7], m[8], [x[4], x[5]], [x[6], x[7]]),
        );
        let scene = System::new(Pinned::origin(), chain, Free).unwrap().with_gravity(9.81);
        let mut start = scene.at_rest(&x[8..11]).unwrap();
        start.set_rates(&x[11..16]).unwrap();
        let energy = |motion: &_| scene.budget(motion).unwrap().energy();
        let (first, most) = (energy(&start), scene.budget(&start).unwrap().kinetic + 50.0);
        let run = scene.simulate(start, Dop853::tolerance(1e-9), 0.3, |_| ()).unwrap();
        prop_assert!((energy(&run.motion) - first).abs() < 1e-6 * most, "{} of {most}", energy(&run.motion) - first);
    }
}
