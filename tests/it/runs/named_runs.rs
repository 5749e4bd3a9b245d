//! Names change nothing: runs, internal forces and derivatives of scenes with and without them are the same, bit by bit.

use catena::{Error, planar, spatial};

/// Bits of a motion.
macro_rules! bits {
    ($motion:expr) => {{
        let motion = $motion;
        let lists = [motion.coordinates(), motion.rates(), motion.accelerations()];
        lists.map(|list| list.into_iter().map(f64::to_bits).collect::<Vec<_>>())
    }};
}

#[test]
fn in_the_plane() -> Result<(), Error> {
    use planar::*;
    let rod = Rod::uniform(0.5, 1.0);
    let pair = Network::new((Pin, rod, Pin, rod), (Pin, rod, Pin, rod), Pin);
    let plain = System::new(Pinned::origin(), (rod, Branch((Pin, rod)), [(Pin, rod)], pair), Free)?;
    let named = {
        let rod = rod.named("rod");
        let arm = Branch((Pin.named("wrist"), rod)).named("arm");
        let pair =
            Network::new((Pin, rod, Pin.named("knee"), rod), (Pin, rod, Pin, rod).named("side"), Pin.named("lock"));
        let chain = (rod, arm, [(Pin, rod).named("link")], pair.named("pair")).named("all");
        System::new(Pinned::origin().named("root"), chain, Free)?
    };
    let angles = [-1.5, -0.3, -1.2, -1.0, -2.0, -2.0, -1.0];
    let (plain, named) = (plain.with_gravity(9.81), named.with_gravity(9.81));
    let start = plain.assembled(plain.at_rest(&angles)?, &Unloaded)?;
    let end = plain.simulate(start, Rk4::step(1e-3), 0.05, |_| ())?.motion;
    let start = named.assembled(named.at_rest(&angles)?, &Unloaded)?;
    let other = named.simulate(start, Rk4::step(1e-3), 0.05, |_| ())?.motion;
    assert_eq!(bits!(&end), bits!(&other));
    assert_ne!(bits!(&start), bits!(&other));
    let (found, expected) = (named.stations(&other, &Unloaded)?, plain.stations(&end, &Unloaded)?);
    let forces = |station: &Station<f64>| {
        [station.internal.force.x, station.internal.force.y, station.internal.torque].map(f64::to_bits)
    };
    assert!(found.iter().map(forces).eq(expected.iter().map(forces)));
    let (knee, by_number) = (found.joint(named.joint("knee")?), expected.joint(plain.joint(4)?));
    assert_eq!(knee.map(forces), by_number.map(forces));
    assert_eq!(found.joint(named.joint("root")?).map(forces), Some(forces(expected.root())));
    Ok(())
}

#[test]
fn in_space() -> Result<(), Error> {
    use spatial::*;
    let (rod, hinge) = (Rod::uniform(0.5, 0.02, 1.0), Revolute::about([0.0, 1.0, 0.0]));
    let plain = System::new(Pinned::origin(), (rod, Branch((Ball, rod)), [(hinge, rod)]), Free)?;
    let named = {
        let arm = Branch((Ball.named("wrist"), rod.named("hand")));
        System::new(Pinned::origin().named("root"), (rod.named("base"), arm, [(hinge, rod).named("link")]), Free)?
    };
    let angles = [0.1, 0.2, -0.3, 0.5, -0.4, 0.3, 0.7];
    let gravity = [0.0, -9.81, 0.0];
    let (plain, named) = (plain.with_gravity(gravity), named.with_gravity(gravity));
    let end = plain.simulate(plain.at_rest(&angles)?, Rk4::step(1e-3), 0.05, |_| ())?.motion;
    let other = named.simulate(named.at_rest(&angles)?, Rk4::step(1e-3), 0.05, |_| ())?.motion;
    assert_eq!(bits!(&end), bits!(&other));
    Ok(())
}

/// Lists of loads, an implicit rule, and derivatives through gains.
#[test]
fn by_other_walks() -> Result<(), Error> {
    use catena::scalar::Jet;
    use planar::*;
    let (rod, hinge) = (Rod::uniform(0.5, 1.0), ElasticHinge::rotary(5.0));
    let plain = System::new(Pinned::origin(), (rod, hinge, rod), Free)?.with_gravity(9.81);
    let chain = (rod.named("a"), hinge.named("b"), rod).named("all");
    let named = System::new(Pinned::origin().named("root"), chain, Free)?.with_gravity(9.81);
    let loads = Loads::none().torques([0.3, -0.2]);
    let (rule, start) = (GeneralizedAlpha::new(0.8).step(1e-3), plain.at_rest(&[-1.0, -0.5])?);
    let one = plain.simulation(rule).loads(&loads).run(start, 0.02, |_| ())?.motion;
    let rule = GeneralizedAlpha::new(0.8).step(1e-3);
    let other = named.simulation(rule).loads(&loads).run(named.at_rest(&[-1.0, -0.5])?, 0.02, |_| ())?.motion;
    assert_eq!(bits!(&one), bits!(&other));

    let (plain, named) = (plain.lift(Jet::<f64, 2>::of), named.lift(Jet::<f64, 2>::of));
    let angles = [Jet::seed(-1.0, 0), Jet::seed(-0.5, 1)];
    let one = plain.simulate(plain.at_rest(&angles)?, Rk4::step(1e-3).through_gains(), 0.02, |_| ())?.motion;
    let other = named.simulate(named.at_rest(&angles)?, Rk4::step(1e-3).through_gains(), 0.02, |_| ())?.motion;
    let bits = |list: Vec<Jet<f64, 2>>| {
        list.iter().flat_map(|x| [x.re, x.eps[0], x.eps[1]]).map(f64::to_bits).collect::<Vec<_>>()
    };
    assert_eq!(bits(one.coordinates()), bits(other.coordinates()));
    assert_eq!(bits(one.rates()), bits(other.rates()));
    Ok(())
}

/// The names of positions in a trace are all different, whatever joints are called.
#[test]
fn columns_of_traces() -> Result<(), Error> {
    use catena::simulate::Trace;
    use planar::*;
    let rod = Rod::uniform(0.5, 1.0);
    let pin = |name| (Pin.named(name), rod);
    let names = ["arm", "arm", "arm_1", "joint_5", "arm_1"];
    let chain = (rod, (names.map(pin), Pin, rod));
    let scene = System::new(Pinned::origin(), chain, Free)?;
    let mut trace = Trace::new(vec![]);
    scene.simulate(scene.motion(), Rk4::step(0.1), 0.1, |now| trace.observe(now))?;
    let text = String::from_utf8(trace.finish().unwrap()).unwrap();
    let head: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let positions = ["joint_0", "arm_1", "arm_2", "arm_1_3", "joint_5", "arm_1_5", "joint_6"];
    assert_eq!(head[1..8], positions.map(|name| format!("{name}_position")));
    for (k, name) in head.iter().enumerate() {
        assert!(!head[..k].contains(name), "{name}");
    }
    // Beside a joint that has the name of another's number.
    let chain = (rod, (Pin.named("joint_2"), rod), (Pin, rod));
    let scene = System::new(Pinned::origin(), chain, Free)?;
    let mut trace = Trace::new(vec![]);
    scene.simulate(scene.motion(), Rk4::step(0.1), 0.1, |now| trace.observe(now))?;
    let text = String::from_utf8(trace.finish().unwrap()).unwrap();
    assert!(text.starts_with("time,joint_0_position,joint_2_position,joint_2_2_position,joint_0_rate"), "{text}");
    // Rows of another scene do not stand under them.
    let mut trace = Trace::new(vec![]);
    scene.simulate(scene.motion(), Rk4::step(0.1), 0.1, |now| trace.observe(now))?;
    let other = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
    other.simulate(other.motion(), Rk4::step(0.1), 0.1, |now| trace.observe(now))?;
    assert_eq!(trace.finish().unwrap_err().kind(), std::io::ErrorKind::InvalidInput);
    Ok(())
}
