//! Scenes in space, and a run of the paper's scheme.

use crate::record::Record;
use catena::Error;
use catena::loading::Unloaded;
use catena::spatial::*;
use nalgebra::Vector3;

const TENSOR: [[f64; 3]; 3] = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];

fn rod() -> Rod<f64> {
    Rod::uniform(0.7, 0.02, 1.3)
}

fn body() -> RigidBody<f64> {
    RigidBody::new(1.1, TENSOR, [0.3, 0.03, -0.02], [0.7, 0.05, -0.1])
}

pub fn record(record: &mut Record) -> Result<(), Error> {
    open(record)?;
    stiff(record)?;
    closed(record)?;
    paper(record)
}

fn gravity() -> Vector3<f64> {
    Vector3::new(0.5, -2.0, -9.0)
}

/// Chains and trees.
fn open(record: &mut Record) -> Result<(), Error> {
    let angles = [0.1, 0.2, -0.5, 0.0, -0.1, 0.3, 0.1, 0.2, 0.4];
    let scene = System::new(Pinned::origin(), (rod(), Ball, rod(), Ball, rod()), Free)?.with_gravity(gravity());
    golden!(record, "rods on balls, DOP853", scene, scene.at_rest(&angles)?, Dop853::tolerance(1e-9), 0.3);
    let scene = System::new(Pinned::origin(), (body(), vec![(Ball, body()); 2]), Free)?.with_gravity(gravity());
    golden!(record, "vector of bodies on balls, RK4", scene, scene.at_rest(&angles)?, Rk4::step(2e-3), 0.2);
    let joints = (
        (Revolute::about([0.0, 0.0, 1.0]), body(), Universal::about([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]), rod()),
        (Prismatic::along([1.0, 0.2, 0.0]), body(), Cylindrical::on([1.0, 0.1, 0.0]), body()),
    );
    let scene = System::new(Clamped::origin(), joints, Free)?.with_gravity(gravity());
    golden!(
        record,
        "joints about axes, DOPRI5",
        scene,
        scene.at_rest(&[0.4, -0.3, 0.2, 0.5])?,
        Dopri5::step(2e-3),
        0.2
    );
    let tree =
        (body(), Branch((Ball, rod())), Ball, body(), Branch((Revolute::about([0.0, 1.0, 0.0]), body())), Ball, rod());
    let scene = System::new(Free, tree, Free)?.with_gravity(gravity());
    let angles = [0.1, 0.2, -0.5, 0.0, -0.1, 0.3, 0.1, 0.2, 0.4, 0.7, 0.3, 0.2, 0.1];
    golden!(record, "floating tree, Adams", scene, scene.at_rest(&angles)?, Adams::step(1e-3), 0.1);
    let single = Rod::uniform(0.7_f32, 0.02, 1.3);
    let scene = System::new(Pinned::origin(), (single, Ball, single), Free)?.with_gravity([0.0, -9.81, 0.0]);
    golden!(
        record,
        "rods on balls in f32, RK4",
        scene,
        scene.at_rest(&[0.1, 0.2, -0.5, 0.0, -0.1, 0.3])?,
        Rk4::step(2e-3),
        0.2
    );
    Ok(())
}

/// Springs under explicit and implicit rules.
fn stiff(record: &mut Record) -> Result<(), Error> {
    let ball = ElasticBall::rotary([30.0, 20.0, 25.0]).damped(0.1);
    let scene = System::new(Clamped::origin(), (ball, rod(), ball, body()), Free)?.with_gravity(gravity());
    let start = || scene.at_rest(&[0.1, 0.2, -0.5, 0.0, -0.1, 0.3]);
    golden!(record, "elastic balls, DOP853", scene, start()?, Dop853::tolerance(1e-9), 0.2);
    golden!(record, "elastic balls, generalised-alpha", scene, start()?, GeneralizedAlpha::new(0.8).step(5e-3), 0.1);
    golden!(record, "elastic balls, SDIRK4", scene, start()?, Sdirk4::new().step(1e-2), 0.1);
    let spring = Spring::stiffness(60.0).damped(0.3);
    let hinge = ElasticHinge::rotary([3.0, 8.0, 5.0]).with_linear(spring, spring, spring);
    let scene = System::new(Clamped::origin(), (hinge, body(), hinge, body()), Free)?.with_gravity(gravity());
    golden!(record, "elastic hinges, SDIRK4", scene, scene.motion(), Sdirk4::new().step(1e-2), 0.1);
    let slider = Prismatic::along([1.0, 0.0, 0.0]).with(Spring::stiffness(100.0).damped(0.2));
    let scene = System::new(Clamped::origin(), (slider, body(), Revolute::about([0.0, 0.0, 1.0]), body()), Free)?;
    let scene = scene.with_gravity(gravity());
    golden!(
        record,
        "sprung slider, generalised-alpha",
        scene,
        scene.at_rest(&[0.4])?,
        GeneralizedAlpha::new(0.8).step(5e-3),
        0.1
    );
    Ok(())
}

/// Held tips and loops.
fn closed(record: &mut Record) -> Result<(), Error> {
    let tip = Pinned::at([1.5, 0.2, -0.3]);
    let scene = System::new(Pinned::origin(), (rod(), Ball, body(), Ball, rod()), tip)?.with_gravity(gravity());
    let start = scene.assembled(scene.at_rest(&[0.1, 0.5, -0.3, 0.0, 0.2, 0.3, 0.1, -0.6, 0.4])?, &Unloaded)?;
    golden!(record, "held by balls, DOP853", scene, start, Dop853::tolerance(1e-8), 0.2);
    let link = |length: f64| Rod::uniform(length, 0.02, length);
    let (crank, rocker) = (Revolute::about([0.0, 0.0, 1.0]), Revolute::about([0.3, 1.0, 0.2]));
    let main = (crank, link(0.3), Ball, link(0.9));
    let net = Network::new(main, (RigidBody::massless([0.7, 0.1, 0.3]), rocker, link(0.8)), Ball);
    let scene = System::new(Clamped::origin(), net, Free)?.with_gravity(gravity());
    let start = scene.assembled(scene.at_rest(&[0.4, 0.0, -0.5, 0.3, -1.1])?, &Unloaded)?;
    golden!(record, "spatial four-bar, RK4", scene, start, Rk4::step(2e-3), 0.2);
    Ok(())
}

/// The paper's scheme in the plane.
fn paper(record: &mut Record) -> Result<(), Error> {
    use catena::paper::{GeneralizedAlpha, Scheme, Solver};
    use catena::planar::{ElasticHinge, Free, Pin, Pinned, Rod, System};
    let rod = Rod::uniform(0.2, 0.3);
    let chain = (rod, Pin, rod, ElasticHinge::rotary(5.0).damped(0.1), rod);
    let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[-1.0, -0.5, -0.2])?;
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).solved_by(Solver::Riccati);
    golden_states!(record, "the paper's scheme by Riccati", scene, start, |scene, start| {
        let mut run = scheme.start(scene, start, &Unloaded, 5e-3)?;
        run.run_to(0.1)?;
        run.stations().iter().flat_map(|state| state.as_vector().iter().copied()).collect()
    });
    Ok(())
}
