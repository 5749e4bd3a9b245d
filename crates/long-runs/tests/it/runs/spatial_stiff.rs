//! Implicit rules on spatial joints with springs: orders, stiffness without end, floating chains.

use catena::simulate::Method;
use catena::spatial::*;
use catena::time::Rule;
use catena::{Error, Motion};
use catena_oracle::has_order;
use nalgebra::Vector3;

type Hinge = Revolute<f64, Spring<f64, f64>>;
type Slider = Cylindrical<f64, Spring<f64, f64>, Spring<f64>>;
type Chain = (RigidBody<f64>, Ball, RigidBody<f64>, Hinge, RigidBody<f64>, Slider, RigidBody<f64>);
type Scene = System<f64, Pinned<[f64; 3]>, Chain, Free>;
type State = Motion<f64, (Rotation<f64>, ((), Rotation<f64>, (), f64, (), [f64; 2], ()))>;

fn scene(stiffness: f64) -> Result<(Scene, State), Error> {
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
    let body = RigidBody::new(1.0, tensor, [0.5, 0.03, -0.02], [1.0, 0.0, 0.0]);
    let damper = 0.02 * stiffness.sqrt();
    let hinge = Revolute::about([0.2, 1.0, 0.3]).with(Spring::stiffness(stiffness).damped(damper));
    let slider = Cylindrical::on([1.0, 0.1, 0.0])
        .with(Spring::stiffness(stiffness).damped(damper), Spring::stiffness(0.5 * stiffness));
    let system = System::new(Pinned::origin(), (body, Ball, body, hinge, body, slider, body), Free)?
        .with_gravity([0.0, -3.0, 0.0]);
    let start = system.at_rest(&[0.3, 0.2, -0.4, 1.0, -0.6, 0.5, 0.1, -0.2])?;
    let start = system.with_rates(start, &[1.0, -1.0, 0.5, 2.0, 1.0, -1.0, 0.3, 0.2, -0.4])?;
    Ok((system, start))
}

/// Largest difference of attitudes and joint coordinates, and of the force at the root.
fn errors(system: &Scene, found: &State, exact: &State) -> [f64; 2] {
    let forces = [found, exact].map(|motion| system.stations(motion, &Unloaded).unwrap().root().internal.force);
    let (a, b) = (found.position(), exact.position());
    let angle = |a: Rotation<f64>, b: Rotation<f64>| Vector3::from(a.relative_to(&b).shortest().log()).norm();
    let all = [
        angle(a.0, b.0),
        angle(a.1.1, b.1.1),
        (a.1.3 - b.1.3).abs(),
        (a.1.5[0] - b.1.5[0]).abs(),
        (a.1.5[1] - b.1.5[1]).abs(),
    ];
    [all.into_iter().fold(0.0, f64::max), (forces[0] - forces[1]).norm()]
}

const END: f64 = 1.0;

fn convergence<'s, M>(
    steps: &[usize],
    rule: impl Fn(f64) -> Rule<M, f64>,
    (system, start): &'s (Scene, State),
    exact: &State,
) -> Result<[Vec<(f64, f64)>; 2], Error>
where
    M: Method<&'s Scene, Unloaded>,
{
    let mut points: [Vec<(f64, f64)>; 2] = Default::default();
    for n in steps {
        let h = END / *n as f64;
        let run = system.simulate(*start, rule(h), END, |_| ())?;
        for (points, error) in points.iter_mut().zip(errors(system, &run.motion, exact)) {
            points.push((h, error));
        }
    }
    Ok(points)
}

#[test]
fn implicit_rules_have_their_orders_on_attitudes_and_forces() -> Result<(), Error> {
    let scene = scene(20.0)?;
    let exact = scene.0.simulate(scene.1, Dop853::tolerance(1e-13), END, |_| ())?.motion;
    let points = convergence(&[200, 400, 800], |h| GeneralizedAlpha::new(0.8).step(h), &scene, &exact)?;
    has_order("generalised-α, attitude", 2.0, 1e-12, &points[0]);
    has_order("generalised-α, force", 2.0, 1e-12, &points[1]);
    let points = convergence(&[100, 160, 250], |h| Sdirk4::new().step(h), &scene, &exact)?;
    has_order("SDIRK4, attitude", 4.0, 1e-12, &points[0]);
    has_order("SDIRK4, force", 4.0, 1e-12, &points[1]);
    Ok(())
}

/// Joints of any stiffness are welds but for the reciprocal of it.
#[test]
fn stiff_joints_are_welds() -> Result<(), Error> {
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
    let body = RigidBody::new(1.0, tensor, [0.5, 0.03, -0.02], [1.0, 0.0, 0.0]);
    let weld = Weld::at(Rotation::identity());
    let welded =
        System::new(Pinned::origin(), (body, Ball, body, weld, body, weld, body), Free)?.with_gravity([0.0, -3.0, 0.0]);
    let angles = [0.3, 0.2, -0.4, 1.0, -0.6, 0.5];
    let exact = welded.simulate(welded.at_rest(&angles)?, Dop853::tolerance(1e-13), END, |_| ())?.motion;
    let force = welded.stations(&exact, &Unloaded)?.root().internal.force;
    for stiffness in [1e6, 1e8, 1e10] {
        let (system, _) = scene(stiffness)?;
        let start = system.at_rest(&[0.3, 0.2, -0.4, 1.0, -0.6, 0.5, 0.0, 0.0])?;
        let found = [
            system.simulate(start, GeneralizedAlpha::new(0.8).step(0.0025), END, |_| ())?.motion,
            system.simulate(start, Sdirk4::new().step(0.005), END, |_| ())?.motion,
        ]
        .map(|motion| (system.stations(&motion, &Unloaded).unwrap().root().internal.force - force).norm());
        println!("k = {stiffness:.0e}: generalised-α {:.1e}, SDIRK4 {:.1e}", found[0], found[1]);
        // Of second order, and of fourth order or 1/k.
        assert!(found[0] < 5e-4 && found[1] < 2e-5 + 100.0 / stiffness);
    }
    Ok(())
}

/// Springs in joints of a chain that floats change neither momentum nor, by more than the rule, energy.
#[test]
fn a_floating_chain_with_springs_keeps_its_momentum() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 0.05, 1.0);
    let hinge = Revolute::about([0.0, 1.0, 0.0]).with(Spring::stiffness(200.0));
    let slider = Prismatic::along([1.0, 0.0, 0.0]).with(Spring::stiffness(1000.0));
    let system = System::new(Free, (rod, hinge, rod, slider, rod), Free)?;
    let start = system.at_rest(&[0.3, 0.2, -0.4, 0.1])?;
    let start = system.with_rates(start, &[0.0, 0.1, 0.0, 1.0, -0.6, 0.5, 0.3, 0.1])?;
    let first = system.budget(&start)?;
    let run = system.simulate(start, Sdirk4::new().step(0.002), 2.0, |_| ())?;
    let last = system.budget(&run.motion)?;
    let lost = [
        (last.momentum - first.momentum).norm(),
        (last.angular_momentum - first.angular_momentum).norm(),
        f64::abs(last.energy() - first.energy()),
    ];
    println!("momentum {:.1e}, angular momentum {:.1e}, energy {:.1e}", lost[0], lost[1], lost[2]);
    assert!(lost.iter().all(|lost| *lost < 1e-5));
    Ok(())
}

/// A chain with springs that is held at its tip by a ball: closed after every step, by either kind of rule, and both agree.
#[test]
fn held_chains_stay_closed_under_implicit_rules() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 0.05, 1.0);
    let hinge = Universal::about([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let hinge = hinge.with(Spring::stiffness(30.0).damped(0.05), Spring::stiffness(20.0));
    let chain = (rod, hinge, rod, hinge, rod, Ball, rod);
    let free = System::new(Pinned::origin(), chain, Free)?;
    let angles = [0.0, 0.3, 0.8, -0.2, -0.4, 0.3, -0.6, 0.2, -0.1, -0.9];
    let place = free.stations(&free.at_rest(&angles)?, &Unloaded)?.tip().frame.place;
    let system =
        System::new(Pinned::origin(), chain, Pinned::at([place.x, place.y, place.z]))?.with_gravity([0.0, -9.81, 0.0]);
    let start = system.at_rest(&angles)?;
    let exact = system.simulate(start, Dop853::tolerance(1e-12), END, |_| ())?.motion;
    let mut gap = 0.0_f64;
    let mut force = |rule: Rule<Sdirk4, f64>| {
        let run = system.simulate(start, rule, END, |now| {
            gap = gap.max((now.stations().tip().frame.place - place).norm());
        })?;
        Ok::<_, Error>(Vector3::from(*run.motion.multipliers()))
    };
    let expected = Vector3::from(*exact.multipliers());
    let mut points = vec![];
    for n in [400, 600, 900] {
        let h = END / f64::from(n);
        points.push((h, (force(Sdirk4::new().step(h))? - expected).norm()));
    }
    has_order("SDIRK4, force that holds the tip", 4.0, 1e-11, &points);
    println!("gap {gap:.1e}");
    assert!(gap < 1e-13);

    // Before the chain lashes out, for a rule of second order.
    let end = 0.3;
    let exact = system.simulate(start, Dop853::tolerance(1e-12), end, |_| ())?.motion;
    let expected = Vector3::from(*exact.multipliers());
    let mut points = vec![];
    for n in [150, 300, 600] {
        let h = end / f64::from(n);
        let motion = system.simulate(start, GeneralizedAlpha::new(0.8).step(h), end, |_| ())?.motion;
        points.push((h, (Vector3::from(*motion.multipliers()) - expected).norm()));
    }
    has_order("generalised-α, force that holds the tip", 2.0, 1e-11, &points);
    Ok(())
}

/// A spring in a ball, soft and stiff.
#[test]
fn elastic_balls_have_the_order_of_their_rule_and_become_welds() -> Result<(), Error> {
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
    let body = RigidBody::new(1.0, tensor, [0.5, 0.03, -0.02], [1.0, 0.0, 0.0]);
    let ball = |k: f64| ElasticBall::rotary([k, 0.5 * k, 2.0 * k]).damped(0.02 * k.sqrt());
    let system = |k: f64| {
        System::new(Pinned::origin(), (body, ball(k), body, ball(k), body), Free)
            .map(|scene| scene.with_gravity([0.0, -3.0, 0.0]))
    };
    let soft = system(5.0)?;
    let start = soft.at_rest(&[0.3, 0.2, -0.4, 1.0, -0.6, 0.5, 0.1, -0.2, 0.4])?;
    let start = soft.with_rates(start, &[1.0, -1.0, 0.5, 2.0, 1.0, -1.0, 0.3, 0.2, -0.4])?;
    let exact = soft.simulate(start, Dop853::tolerance(1e-13), END, |_| ())?.motion;
    macro_rules! force {
        ($system:expr, $motion:expr) => {
            $system.stations(&$motion, &Unloaded).unwrap().root().internal.force
        };
    }
    // Of the last body's attitude (rad), and of the force at the root (N).
    let errors = |motion: &_| {
        let attitude =
            |motion| Rotation::from_matrix(&soft.stations(motion, &Unloaded).unwrap().tip().frame.turn.attitude);
        let turned = attitude(motion).relative_to(&attitude(&exact)).shortest().log();
        [Vector3::from(turned).norm(), (force!(soft, *motion) - force!(soft, exact)).norm()]
    };
    let mut points = [(); 4].map(|()| vec![]);
    for n in [200, 400, 800] {
        let h = END / f64::from(n);
        let [attitude, force] = errors(&soft.simulate(start, GeneralizedAlpha::new(0.8).step(h), END, |_| ())?.motion);
        points[0].push((h, attitude));
        points[1].push((h, force));
    }
    for n in [100, 160, 250] {
        let h = END / f64::from(n);
        let [attitude, force] = errors(&soft.simulate(start, Sdirk4::new().step(h), END, |_| ())?.motion);
        points[2].push((h, attitude));
        points[3].push((h, force));
    }
    has_order("generalised-α, attitude", 2.0, 1e-11, &points[0]);
    has_order("generalised-α, force", 2.0, 1e-11, &points[1]);
    has_order("SDIRK4, attitude", 4.0, 1e-12, &points[2]);
    has_order("SDIRK4, force", 4.0, 1e-11, &points[3]);

    let weld = Weld::at(Rotation::identity());
    let welded = System::new(Pinned::origin(), (body, weld, body, weld, body), Free)?.with_gravity([0.0, -3.0, 0.0]);
    let exact = welded.simulate(welded.at_rest(&[0.3, 0.2, -0.4])?, Dop853::tolerance(1e-13), END, |_| ())?.motion;
    let expected = force!(welded, exact);
    for k in [1e6, 1e8, 1e10] {
        let stiff = system(k)?;
        let angles = [0.3, 0.2, -0.4];
        let start = stiff.at_rest(&[angles, angles, angles].concat())?;
        let second = stiff.simulate(start, GeneralizedAlpha::new(0.8).step(0.0025), END, |_| ())?.motion;
        let fourth = stiff.simulate(start, Sdirk4::new().step(0.005), END, |_| ())?.motion;
        let errors = [force!(stiff, second), force!(stiff, fourth)].map(|force| (force - expected).norm());
        println!("k = {k:.0e}: generalised-α {:.1e}, SDIRK4 {:.1e}", errors[0], errors[1]);
        assert!(errors[0] < 5e-4 && errors[1] < 2e-5 + 100.0 / k);
    }
    Ok(())
}
