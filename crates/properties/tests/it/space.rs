//! Scenes in space, and robots in axes of their bodies.

use crate::draws::*;
use catena::robot::{BodyAxes, Hinge, Link, Slide};
use catena::spatial::*;
use proptest::prelude::*;

/// A tensor, symmetric and possible more often than not.
fn tensor(m: &[f64], x: &[f64]) -> [[f64; 3]; 3] {
    let (a, b, c) = (m[0], m[1], m[2]);
    let [p, q, r] = [x[0], x[1], x[2]].map(|x| 0.05 * x);
    [[b + c, p, q], [p, a + c, r], [q, r, a + b]]
}

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn chains_of_anything((x, m) in (numbers(), sizes()), q in numbers(), (h, tolerance) in rule(), end in positive(), every in positive()) {
        let body = RigidBody::new(m[0], tensor(&m[1..], &x), [x[3], x[4], x[5]], [x[6], x[7], x[8]]);
        let chain = (
            (Revolute::about([x[9], x[10], x[11]]).with(Spring::new(x[12]).damped(x[13])), body),
            (Universal::about([x[14], x[15], 1.0], [x[16], 1.0, x[17]]), Rod::uniform(m[4], m[5], m[6])),
            (Prismatic::along([x[18], x[19], 1.0]).with(Spring::new(m[7])), body),
            (Cylindrical::on([1.0, x[20], x[21]]), PointMass::new(m[8], m[9])),
        );
        let made = System::new(Clamped::on([x[22], x[23], x[24]], Rotation::from_angles([x[25], x[26], x[27]])), chain, Free);
        probe!(made, &q, [x[28], x[29], x[30]], end, every, [Rk4::step(h), Dop853::tolerance(tolerance)]);
    }

    #[test]
    fn balls_and_springs((x, m) in (numbers(), sizes()), q in numbers(), (h, tolerance) in rule(), end in positive(), every in positive()) {
        let rod = Rod::uniform(m[0], m[1], m[2]);
        let hinge = ElasticHinge::rotary([m[3], m[4], x[0]]).with_linear(Spring::new(m[5]), Spring::new(x[1]), Spring::new(m[6]));
        let body = RigidBody::new(m[7], tensor(&m[8..], &x[2..]), [x[5], x[6], x[7]], [x[8], x[9], x[10]]);
        let made = System::new(Free, (rod, Ball, rod, hinge, body), Free);
        probe!(made, &q, [x[11], x[12], x[13]], end, every, [Vcabm::new().tolerance(tolerance), GeneralizedAlpha::new(0.8).step(h)]);
    }

    #[test]
    fn robots((x, m) in (numbers(), sizes()), q in numbers(), (h, tolerance) in rule(), end in positive(), every in positive()) {
        let link = |k: usize| Link::general(m[k], [x[k], x[k + 1], x[k + 2]], tensor(&m[k + 1..], &x[k + 3..]));
        let chain = (
            BodyAxes,
            (Hinge::at::<7>([x[10], x[11], x[12]]).with(Spring::new(m[8])), link(0)),
            (Slide::at::<7>([x[13], x[14], x[15]]), link(4)),
        );
        let made = System::new(Clamped::origin(), chain, Free);
        if let Ok(robot) = &made {
            // Forces are what numbers give, as written; accelerations are checked.
            match robot.forward_dynamics(&[q[0], q[1]], &[q[2], q[3]], &[q[4], q[5]]) {
                Ok(list) => prop_assert!(list.iter().all(|x| x.is_finite())),
                Err(error) => crate::probe::told(&error),
            }
            prop_assert!(robot.inverse_dynamics(&[q[0], q[1], 0.0], &[q[2], q[3], 0.0], &[0.0; 3]).is_err());
        }
        probe!(made, &q, [x[16], x[17], x[18]], end, every, [Dop853::tolerance(tolerance), Rk4::step(h)]);
    }

    /// What nobody would refuse conserves its energy: garbage does not.
    #[test]
    fn everyday_chains_conserve_energy((x, m) in plain()) {
        let rod = Rod::uniform(m[0], 0.1, m[1]);
        let body = RigidBody::new(m[2], tensor(&m[3..], &x), [x[3], x[4], x[5]], [x[6], x[7], x[8]]);
        let chain = (rod, Ball, body, Revolute::about([x[9], x[10], 2.0]).with(Spring::new(m[6])), body);
        let scene = System::new(Pinned::origin(), chain, Free).unwrap().with_gravity([x[11], -9.81, x[12]]);
        let mut start = scene.at_rest(&x[13..20]).unwrap();
        start.set_rates(&x[20..27]).unwrap();
        let energy = |motion: &_| scene.budget(motion).unwrap().energy();
        let (first, most) = (energy(&start), scene.budget(&start).unwrap().kinetic + 50.0);
        let run = scene.simulate(start, Dop853::tolerance(1e-9), 0.2, |_| ()).unwrap();
        prop_assert!((energy(&run.motion) - first).abs() < 1e-6 * most, "{} of {most}", energy(&run.motion) - first);
    }
}
