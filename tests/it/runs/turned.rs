//! Motions set by orientations and angular velocities of bodies, against what readings show of the bodies.

use catena::scalar::Jet;
use catena::spatial::*;
use catena::system::AngularVelocity::{self, Body, Inertial, Relative};
use catena::{Error, Fault, Place, planar};
use catena_oracle::{Noise, near};
use nalgebra::Vector3;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Y: [f64; 3] = [0.0, 1.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// A floating base; on it, in a loop within which arms begin with balls, a hinge with a spring, a welded plate, axes.
macro_rules! scene {
    () => {{
        let rod = Rod::uniform(0.5, 0.02, 1.0);
        let weld = Weld::at(Rotation::exp([0.4, -0.2, 0.9]));
        let main = (Ball, rod.named("main"), ElasticHinge::rotary([5.0; 3]), rod.named("sprung"));
        let side = (Ball, rod, weld, rod.named("plate"), Revolute::about(Y), rod.named("flap"));
        let after = (Universal::about(Y, Z), rod.named("cross"), Prismatic::along(X), rod.named("slid"));
        System::new(
            Free,
            (rod.named("base"), Network::new(main, side, Ball), Branch((Revolute::about(Z), rod)), after),
            Free,
        )?
    }};
}

fn vector(noise: &mut Noise, size: f64) -> [f64; 3] {
    [(); 3].map(|()| size * noise.next())
}

fn close(found: Vector3<f64>, expected: Vector3<f64>, tolerance: f64) {
    assert!((found - expected).norm() <= tolerance, "found {found:?}, expected {expected:?}");
}

#[test]
fn bodies_turn_as_they_were_told() -> Result<(), Error> {
    let scene = scene!();
    let mut noise = Noise::new(7);
    let mut motion = scene.motion();
    let list: Vec<f64> = (0..motion.coordinate_count()).map(|_| noise.next()).collect();
    motion.set_coordinates(&list)?;
    let list: Vec<f64> = (0..motion.rate_count()).map(|_| noise.next()).collect();
    motion.set_rates(&list)?;

    // The body against which a relative velocity is measured.
    let relations = [("base", None), ("main", Some("base")), ("sprung", Some("main")), ("plate", Some("base"))];
    for (name, against) in relations {
        let spin = vector(&mut noise, 3.0);
        for kind in [Inertial, Body, Relative] {
            let before = motion.rates();
            motion = scene.with_body_spin(motion, name, kind(spin))?;
            let bodies = scene.body_motions(&motion)?;
            let turn = |name: &str| -> Result<_, Error> {
                bodies.get(scene.body(name)?.body).map(|body| body.inboard.turn).ok_or(Error::new(Fault::Shape))
            };
            let found = turn(name)?;
            let inboard = match against {
                Some(name) => turn(name)?.spin,
                None => Vector3::zeros(),
            };
            let expected = match kind(spin) {
                Inertial(spin) => spin.into(),
                Body(spin) => found.attitude.apply(spin.into()),
                Relative(spin) => inboard + found.attitude.apply(spin.into()),
            };
            close(found.spin, expected, 3e-15 * (1.0 + expected.norm()));
            let changed = before.iter().zip(motion.rates()).filter(|(old, new)| **old != *new).count();
            assert!(changed <= 3, "{name}"); // those of one joint
        }

        let before = motion.coordinates();
        for size in [0.1, 1.0, 3.1] {
            let axis = Vector3::from(vector(&mut noise, 1.0)).normalize();
            let attitude = Rotation::exp((axis * size).into());
            motion = scene.with_body_orientation(motion, name, attitude)?;
            let found = scene.body_motions(&motion)?.get(scene.body(name)?.body).map(|body| body.attitude());
            let off = found.map(|found| found.relative_to(&attitude).shortest().log());
            near(off.map_or(f64::NAN, |off| Vector3::from(off).norm()), 0.0, 3e-15);
        }
        let changed = before.iter().zip(motion.coordinates()).filter(|(old, new)| **old != *new).count();
        assert!(changed <= 4, "{name}");
    }
    Ok(())
}

#[test]
fn axes_let_bodies_turn_as_far_as_they_go() -> Result<(), Error> {
    let scene = scene!();
    let (mut noise, mut motion) = (Noise::new(9), scene.motion());
    let list: Vec<f64> = (0..motion.rate_count()).map(|_| noise.next()).collect();
    motion.set_rates(&list)?;
    motion = scene.with_body_orientation(motion, "plate", Rotation::exp([0.3, 0.1, -0.2]))?;

    // By a relative angle of 0.8 rad and a relative rate of 1.5 rad/s about the axis.
    let plate = scene.body_motions(&motion)?.get(scene.body("plate")?.body).copied().ok_or(Error::new(Fault::Shape))?;
    let flap = plate.attitude().after(&Rotation::exp([0.0, 0.8, 0.0]));
    motion = scene.with_body_orientation(motion, "flap", flap)?;
    motion = scene.with_body_spin(motion, "flap", Relative([0.0, 1.5, 0.0]))?;
    let joint = scene.joint(scene.joints() - 5)?; // before what closes the loop, the arm and two more
    near(motion.coordinates_of::<1>(joint)?[0], 0.8, 2e-15);
    near(motion.rates_of::<1>(joint)?[0], 1.5, 2e-15);

    // Not about another axis: at the station of the joint.
    let station = Some(Place::Station(joint.station.unwrap_or(0)));
    let failed = scene.with_body_spin(motion, "flap", Relative([0.1, 1.5, 0.0])).err();
    let Some(Error { place, fault: Fault::ImpossibleTurn { residual }, .. }) = failed else {
        panic!("{failed:?}");
    };
    assert_eq!(place, station);
    near(residual, 0.1, 1e-15);
    let failed = scene.with_body_orientation(motion, "flap", flap.after(&Rotation::exp([0.0, 0.0, 0.2]))).err();
    assert!(
        matches!(failed, Some(Error { place, fault: Fault::ImpossibleTurn { residual }, .. }) if place == station && residual > 0.1)
    );

    // Two axes reach what they reach; what slides is carried along.
    let cross = scene.joint(scene.joints() - 2)?;
    motion.set_coordinates_of(cross, &[0.4, -0.9])?;
    let bodies = scene.body_motions(&motion)?;
    let wanted = bodies.get(scene.body("slid")?.body).map(|body| body.attitude()).ok_or(Error::new(Fault::Shape))?;
    motion.set_coordinates_of(cross, &[-0.6, 0.7])?;
    motion = scene.with_body_orientation(motion, "slid", wanted)?;
    let [one, two] = motion.coordinates_of(cross)?;
    near(one, 0.4, 1e-14);
    near(two, -0.9, 1e-14);
    let rod = Rod::uniform(0.5, 0.02, 1.0);
    let fixed = System::new(Clamped::origin(), (rod, Revolute::about(Z), rod), Free)?;
    let failed = fixed.with_body_spin(fixed.motion(), 0, Inertial(X)).err();
    assert!(matches!(failed, Some(Error { place: Some(Place::Station(0)), fault: Fault::Unsupported { .. }, .. })));
    let none = scene.with_body_spin(motion, "nobody", Inertial(X)).err();
    assert!(matches!(none, Some(Error { fault: Fault::NoSuchName { .. }, .. })));
    let nan = scene.with_body_spin(motion, "base", Inertial([f64::NAN; 3])).err();
    assert_eq!(nan, Some(Error::new(Fault::NotFinite { parameter: "angular velocity" })));
    Ok(())
}

#[test]
fn all_bodies_at_once() -> Result<(), Error> {
    let scene = scene!();
    let (mut noise, rest) = (Noise::new(11), scene.motion());
    let mut motion = rest;
    let list: Vec<f64> = (0..motion.coordinate_count()).map(|_| noise.next()).collect();
    motion.set_coordinates(&list)?;
    let rates: Vec<f64> = (0..motion.rate_count()).map(|_| noise.next()).collect();
    motion.set_rates(&rates)?;

    // What the bodies outboard of joints that turn do, read, gives the motion back, but for what slides.
    let bodies = scene.body_motions(&motion)?;
    let outboard = [0, 1, 2, 3, 5, 6, 7];
    let read = |k: usize| bodies.get(k).copied().ok_or(Error::new(Fault::Shape));
    let attitudes = outboard.iter().map(|k| read(*k).map(|body| body.attitude())).collect::<Result<Vec<_>, _>>()?;
    let mut found = scene.at_attitudes(&attitudes)?;
    for rail in [0, scene.joints() - 1] {
        let joint = scene.joint(rail)?;
        found.set_coordinates_of(joint, &motion.coordinates()[joint.coordinates()])?;
        found.set_rates_of(joint, &motion.rates()[joint.rates()])?;
    }
    let spins = |axes: fn([f64; 3]) -> AngularVelocity<[f64; 3]>| {
        outboard
            .iter()
            .map(|k| {
                let turn = read(*k)?.inboard.turn;
                Ok(match axes([0.0; 3]) {
                    Body(_) => turn.attitude.transposed(turn.spin),
                    _ => turn.spin,
                }
                .into())
            })
            .collect::<Result<Vec<[f64; 3]>, Error>>()
    };
    for axes in [Inertial, Body] {
        let turned = scene.with_body_rates(found, &spins(axes)?, axes)?;
        for (found, rate) in turned.rates().iter().zip(&rates) {
            near(*found, *rate, 1e-14);
        }
    }
    for joint in 0..scene.joints() {
        let range = scene.joint(joint)?.coordinates();
        let (found, given) = (&found.coordinates()[range.clone()], &motion.coordinates()[range]);
        // A quaternion and its opposite are one attitude.
        let start = if given.len() == 7 { 3 } else { 0 };
        let turns = given.len() - start == 4;
        let sign = if turns {
            found[start..].iter().zip(&given[start..]).map(|(a, b)| a * b).sum::<f64>().signum()
        } else {
            1.0
        };
        for (k, (found, given)) in found.iter().zip(given).enumerate() {
            near(*found, if k >= start { sign * given } else { *given }, 1e-14);
        }
    }

    // Relative rates: those of axes as they are, of balls against the body inboard.
    let own: Vec<f64> = (0..16).map(|_| noise.next()).collect();
    let turned = scene.with_joint_rates(motion, &own)?;
    let bodies = scene.body_motions(&turned)?;
    let turn = |k: usize| bodies.get(k).map(|body| body.inboard.turn).ok_or(Error::new(Fault::Shape));
    for (k, against, own) in [(1, 0, &own[3..6]), (2, 1, &own[6..9]), (3, 0, &own[9..12])] {
        let relative = turn(k)?.attitude.transposed(turn(k)?.spin - turn(against)?.spin);
        close(relative, Vector3::new(own[0], own[1], own[2]), 3e-15);
    }
    let last = scene.joints() - 2;
    assert_eq!(turned.rates_of(scene.joint(last)?)?, [own[14], own[15]]);
    assert_eq!(turned.rates_of::<1>(scene.joint(last - 1)?)?, [own[13]]);

    let count = |list, expected, given| Some(Error::new(Fault::Count { list, expected, given }));
    assert_eq!(scene.at_attitudes(&attitudes[1..]).err(), count("attitudes", 7, 6));
    assert_eq!(scene.with_body_rates(rest, &[X; 8], Inertial).err(), count("rates", 7, 8));
    assert_eq!(scene.with_joint_rates(rest, &own[1..]).err(), count("rates", 16, 15));
    Ok(())
}

#[test]
fn the_plane_has_loops_too() -> Result<(), Error> {
    use planar::{Branch, ElasticHinge, Free, Network, Pin, Rod, Slider, System, Weld};
    let (rod, hinge) = (Rod::uniform(0.5, 1.0), ElasticHinge::rotary(5.0));
    let main = (Pin, rod, hinge, rod.named("main"));
    let net = Network::new(main, (hinge, rod, Weld::at(0.4), rod.named("plate")), Pin);
    let scene = System::new(Free, (rod, net, Branch((Pin, rod)), Slider::along(0.1), rod), Free)?;
    let mut noise = Noise::new(3);
    // Of the joints that turn: the body outboard, and the one inboard.
    let turning = [(0, None), (1, Some(0)), (2, Some(1)), (3, Some(0)), (5, Some(2))];
    let (angles, rates) = ([(); 5].map(|()| noise.next()), [(); 5].map(|()| noise.next()));
    let start = scene.at_joint_angles(&angles)?;
    for relative in [false, true] {
        let motion = match relative {
            false => scene.with_body_rates(start, &rates)?,
            true => scene.with_joint_rates(start, &rates)?,
        };
        let bodies = scene.body_motions(&motion)?;
        let turn = |k: usize| bodies.get(k).map(|body| body.inboard.turn).ok_or(Error::new(Fault::Shape));
        for ((body, inboard), (angle, rate)) in turning.iter().zip(angles.iter().zip(&rates)) {
            let base = inboard.map_or(Ok((0.0, 0.0)), |k| turn(k).map(|turn| (turn.angle, turn.rate)))?;
            near(turn(*body)?.angle - base.0, *angle, 3e-16);
            near(turn(*body)?.rate - if relative { base.1 } else { 0.0 }, *rate, 3e-16);
        }
    }
    let motion = scene.with_body_orientation(start, "plate", 7.5)?;
    let motion = scene.with_body_spin(motion, "plate", Inertial(2.0))?;
    let motion = scene.with_body_spin(motion, "main", Relative(1.0))?;
    let bodies = scene.body_motions(&motion)?;
    let turn = |k: usize| bodies.get(k).map(|body| body.inboard.turn).ok_or(Error::new(Fault::Shape));
    near(turn(4)?.angle, 7.5, 1e-15);
    near(turn(4)?.rate, 2.0, 0.0);
    assert_eq!(motion.rates_of(scene.joint(2)?)?, [1.0]);
    Ok(())
}

#[test]
fn derivatives_follow() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 0.02, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Revolute::about(Z), rod.named("forearm")), Free)?;
    let scene = scene.lift(Jet::<f64, 1>::of);
    let zero = Jet::of(0.0);
    let base = Rotation::exp([zero, zero, Jet::of(0.5)]);
    let turned = Rotation::exp([zero, zero, Jet::seed(1.3, 0)]);
    let motion = scene.at_attitudes(&[base, turned])?;
    let [angle] = motion.coordinates_of(scene.joint(1)?)?;
    near(angle.re, 0.8, 1e-15);
    near(angle.eps[0], 1.0, 1e-14);
    // A quaternion about z: (cos φ/2, 0, 0, sin φ/2).
    let tilted = scene.with_body_orientation(scene.motion(), 0, turned)?;
    let [w, .., z] = tilted.coordinates_of::<4>(scene.joint(0)?)?;
    near(w.eps[0], -0.5 * 0.65_f64.sin(), 1e-15);
    near(z.eps[0], 0.5 * 0.65_f64.cos(), 1e-15);
    Ok(())
}
