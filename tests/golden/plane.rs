//! Scenes in the plane.

use crate::record::Record;
use catena::Error;
use catena::loading::Unloaded;
use catena::planar::*;

pub fn record(record: &mut Record) -> Result<(), Error> {
    open(record)?;
    stiff(record)?;
    held(record)?;
    loaded(record)?;
    branched(record)
}

fn rod() -> Rod<f64> {
    Rod::uniform(0.7, 1.3)
}

fn plate() -> RigidBody<f64> {
    RigidBody::new(0.9, 0.05, [0.3, 0.1], [0.7, -0.2])
}

/// Ground that drives off sideways and falls.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Lift;

impl Ground<f64, GroundMotion<f64>> for Lift {
    fn at(&self, t: f64) -> GroundMotion<f64> {
        GroundMotion { place: [0.1 * t, -t * t], velocity: [0.1, -2.0 * t], acceleration: [0.0, -2.0] }
    }
}

/// Chains with a free tip.
fn open(record: &mut Record) -> Result<(), Error> {
    let scene = System::new(Pinned::origin(), (rod(), Pin, rod()), Free)?.with_gravity(9.81);
    golden!(record, "tuple of rods, DOP853", scene, scene.at_rest(&[-1.0, -0.5])?, Dop853::tolerance(1e-10), 1.0);
    let scene = System::new(Pinned::origin(), (rod(), [(Pin, rod()); 6]), Free)?.with_gravity(9.81);
    let angles = [-0.1, -0.3, 0.2, -0.6, -1.0, 0.4, 0.1];
    golden!(record, "array of rods, RK4", scene, scene.at_rest(&angles)?, Rk4::step(2e-3), 0.2);
    let scene = System::new(Pinned::origin(), (plate(), vec![(Pin, plate()); 5]), Free)?.with_gravity(9.81);
    golden!(record, "vector of plates, DOPRI5", scene, scene.at_rest(&angles[..6])?, Dopri5::step(2e-3), 0.2);
    let point = PointMass::new(0.4, 0.6);
    let nest = ((rod(), Pin, (plate(), Pin)), (point, Pin, (rod(), Weld::at(0.3), rod())));
    let scene = System::new(Pinned::origin(), nest, Free)?.with_gravity(9.81);
    golden!(record, "nest with a weld and a point, RK4", scene, scene.at_rest(&angles[..4])?, Rk4::step(2e-3), 0.2);
    let scene = System::new(Free, (rod(), Pin, plate()), Free)?;
    let start = scene.with_body_rates(scene.at_rest(&[0.3, -0.4])?, &[1.0, -2.0])?;
    golden!(record, "floating pair, Adams", scene, start, Adams::step(1e-3), 0.2);
    let single = Rod::uniform(0.7_f32, 1.3);
    let scene = System::new(Pinned::origin(), (single, [(Pin, single); 3]), Free)?.with_gravity(9.81);
    golden!(record, "rods in f32, RK4", scene, scene.at_rest(&[-1.0, -0.5, 0.2, 0.1])?, Rk4::step(2e-3), 0.2);
    let scene = System::new(Pinned::on(Lift), (rod(), Pin, rod()), Free)?.with_gravity(9.81);
    golden!(record, "root that moves, RK4", scene, scene.at_rest(&[-1.0, -0.5])?, Rk4::step(2e-3), 0.2);
    Ok(())
}

/// Springs under explicit and implicit rules.
fn stiff(record: &mut Record) -> Result<(), Error> {
    let hinge = ElasticHinge::rotary(30.0).damped(0.2).resting_at(0.1);
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), (hinge, rod(), [(hinge, plate()); 3]), Free)?;
    let scene = scene.with_gravity(9.81);
    let start = || scene.at_rest(&[0.1, -0.2, 0.3, 0.0]);
    golden!(record, "rotary springs, DOP853", scene, start()?, Dop853::tolerance(1e-9), 0.2);
    golden!(record, "rotary springs, generalised-alpha", scene, start()?, GeneralizedAlpha::new(0.8).step(5e-3), 0.2);
    golden!(record, "rotary springs, SDIRK4", scene, start()?, Sdirk4::new().step(1e-2), 0.2);
    let spring = Spring::new(80.0).damped(0.3);
    let slider = Slider::along(0.2).with(spring);
    let chain = (rod(), ElasticHinge::rotary(20.0).with_linear(spring, spring), rod(), slider, plate(), Pin, rod());
    let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
    let start = || scene.at_rest(&[-1.0, -0.8, -1.2]);
    golden!(record, "linear springs and a slider, RK4", scene, start()?, Rk4::step(2e-3), 0.2);
    golden!(record, "linear springs and a slider, SDIRK4", scene, start()?, Sdirk4::new().step(1e-2), 0.2);
    let beam = Beam::new(1.0, 2.0, 0.5).segments::<8>();
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), beam, Free)?.with_gravity(9.81);
    golden!(record, "beam, generalised-alpha", scene, scene.motion(), GeneralizedAlpha::new(0.7).tolerance(1e-5), 0.1);
    Ok(())
}

/// Chains held at both ends.
fn held(record: &mut Record) -> Result<(), Error> {
    let angles = [-0.8, -0.4, 0.0, 0.4, 0.8];
    let scene = System::new(Pinned::origin(), (rod(), vec![(Pin, rod()); 4]), Pinned::at(2.9, 0.0))?.with_gravity(9.81);
    let start = scene.assembled(scene.at_rest(&angles)?, &Unloaded)?;
    golden!(record, "hanging chain, DOP853", scene, start, Dop853::tolerance(1e-9), 0.3);
    let hinge = ElasticHinge::rotary(10.0);
    let scene = System::new(Pinned::origin(), (rod(), hinge, rod(), hinge, rod()), Guided::at(0.0, -0.3, 0.4))?;
    let start = scene.assembled(scene.at_rest(&[-0.3, 0.1, 0.0])?, &Unloaded)?;
    golden!(
        record,
        "guided tip on springs, generalised-alpha",
        scene,
        start,
        GeneralizedAlpha::new(0.8).step(2e-3),
        0.1
    );
    Ok(())
}

/// Forces, torques and struts.
fn loaded(record: &mut Record) -> Result<(), Error> {
    let scene = System::new(Pinned::origin(), (rod(), Pin, plate(), Pin, rod()), Free)?.with_gravity(9.81);
    let start = || scene.at_rest(&[-1.0, -0.5, 0.3]);
    let loads = Loads::none()
        .on_bodies(|time: f64, _, motion: &BodyMotion<f64>| motion.force_at([0.1, 0.2], [time, 1.0]))
        .in_joints(|_, _, motion: &JointMotion<f64>| -0.1 * motion.rate());
    golden!(record, "loads of the motion, RK4", scene, start()?, Rk4::step(2e-3), 0.2, &loads);
    let torques = Loads::none().torques([1.0, -0.5, 0.2]);
    golden!(record, "torques, DOPRI5", scene, start()?, Dopri5::tolerance(1e-7), 0.2, &torques);
    let struts = Struts::of([Strut::between((0, [0.1, 0.0]), (2, [0.2, 0.0])).with_stiffness(30.0).with_length(0.5)]);
    golden!(record, "strut, RK4", scene, start()?, Rk4::step(2e-3), 0.2, &struts);
    Ok(())
}

/// Trees, loops and networks.
fn branched(record: &mut Record) -> Result<(), Error> {
    let tree = (rod(), Branch((Pin, rod(), Branch((Pin, plate())))), Pin, plate(), Branch((Pin, rod())), Pin, rod());
    let scene = System::new(Pinned::origin(), tree, Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[-1.0, -0.5, 0.3, 0.1, -0.2, -2.0])?;
    golden!(record, "tree, Adams", scene, start, Adams::tolerance(1e-7), 0.2);
    let (crank, coupler, rocker) = (Rod::uniform(0.3, 0.3), Rod::uniform(0.9, 0.9), Rod::uniform(0.6, 0.6));
    let scene = System::new(Pinned::origin(), (crank, Pin, coupler, Pin, rocker), Pinned::at(0.8, 0.0))?;
    let scene = scene.with_gravity(9.81);
    let start = scene.assembled(scene.at_rest(&[1.0, 0.2, -1.5])?, &Unloaded)?;
    golden!(record, "four-bar, RK4", scene, start, Rk4::step(2e-3), 0.2);
    let half = Rod::uniform(0.4, 0.5);
    let inner = Network::new((Pin, half, Pin, half), (Pin, half, Pin, half), Pin);
    let net = Network::new((inner, Pin, half), (Pin, half, Pin, rod(), Pin, half), Pin);
    let scene = System::new(Pinned::origin(), (rod(), net), Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[-1.5, -1.0, -0.8, -2.0, -1.8, -1.2, -2.5, -1.0, -0.5])?;
    let start = scene.assembled(start, &Unloaded)?;
    golden!(record, "nested networks, DOP853", scene, start, Dop853::tolerance(1e-8), 0.1);
    Ok(())
}
