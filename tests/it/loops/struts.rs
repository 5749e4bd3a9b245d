//! Springs and dampers between points of a scene.

use catena::{Error, Fault, planar, spatial};
use catena_oracle::{has_order, near};
use num_dual::Dual64;

/// Two point masses on strings so long that gravity does nothing: a spring between them, along x.
#[test]
fn two_masses_vibrate_as_their_reduced_mass_does() -> Result<(), Error> {
    use planar::*;
    // A body that floats, and one that slides along it.
    let (heavy, light) =
        (RigidBody::new(3.0_f64, 0.5, [0.0, 0.0], [0.0, 0.0]), RigidBody::new(1.0, 0.2, [0.0, 0.0], [0.0, 0.0]));
    let scene = System::new(Free, (heavy, Slider::along(0.0), light), Free)?;
    let (k, length) = (48.0, 0.6);
    let struts = Struts::of([Strut::between((0, [0.0, 0.0]), (1, [0.0, 0.0])).with_stiffness(k).with_length(length)]);
    let mut start = scene.at_rest(&[0.0])?;
    start.position_mut().1.1 = length + 0.1;
    let time = 0.37;
    let motion = scene.simulation(Dop853::tolerance(1e-12)).loads(&struts).run(start, time, |_| ())?.motion;
    let omega = (k / (3.0 * 1.0 / 4.0)).sqrt();
    near(motion.position().1.1, length + 0.1 * (omega * time).cos(), 1e-11);
    Ok(())
}

/// Three bodies that float in space, joined by balls and by struts that cross them.
#[test]
fn forces_come_in_pairs_and_energy_is_kept() -> Result<(), Error> {
    use spatial::*;
    let body = Rod::uniform(0.7, 0.1, 1.2);
    let scene = System::new(Free, (body, Ball, body, Ball, body), Free)?;
    let struts = [
        Strut::between((0, [0.1, 0.2, 0.0]), (2, [0.5, -0.1, 0.3])).with_stiffness(30.0).with_length(0.8),
        Strut::between((2, [0.7, 0.0, 0.0]), (1, [0.0, 0.3, 0.0])).with_stiffness(12.0),
    ];
    let loads = Struts::of(struts);
    let start = scene.at_rest(&[0.1, 0.2, 0.3, -0.4, 0.5, 0.9, 1.3, -0.2, 0.4])?;
    let start = scene.with_rates(start, &[0.3, 0.1, -0.2, 0.5, 1.0, -0.7, 0.2, 0.9, 0.4, -1.1, 0.6, 0.8])?;
    let points = |motion: &_, k: usize, at| {
        scene
            .body_motions(motion)
            .unwrap()
            .get(k)
            .map(|body: &BodyMotion<f64>| body.point(at).place)
            .unwrap_or_default()
    };
    let energy = |motion: &_| {
        let [first, second] = struts;
        scene.budget(motion).unwrap().energy()
            + first.energy(points(motion, 0, [0.1, 0.2, 0.0]), points(motion, 2, [0.5, -0.1, 0.3]))
            + second.energy(points(motion, 2, [0.7, 0.0, 0.0]), points(motion, 1, [0.0, 0.3, 0.0]))
    };
    let before = (energy(&start), scene.budget(&start)?);
    let mut errors = vec![];
    for h in [0.01, 0.005, 0.0025] {
        let end = scene.simulation(Rk4::step(h)).loads(&loads).run(start, 2.0, |_| ())?.motion;
        errors.push((h, (scene.budget(&end)?.momentum - before.1.momentum).norm()));
    }
    println!("{errors:?}");
    has_order("momentum", 4.0, 1e-11, &errors);
    let end = scene.simulation(Dop853::tolerance(1e-12)).loads(&loads).run(start, 2.0, |_| ())?.motion;
    near(energy(&end), before.0, 1e-9);
    let stored: f64 = loads.readings(&scene, &end)?.iter().map(|strut| strut.energy).sum();
    near(scene.budget(&end)?.energy() + stored, energy(&end), 1e-13);
    let after = scene.budget(&end)?;
    for k in 0..3 {
        near(after.momentum[k], before.1.momentum[k], 1e-9);
        near(after.angular_momentum[k], before.1.angular_momentum[k], 1e-9);
    }
    Ok(())
}

/// A strut to the ground, with a damper, does what the same force written by hand does; in every reading of the scene.
#[test]
fn a_strut_to_the_ground_is_a_force() -> Result<(), Error> {
    use planar::*;
    let rod = Rod::uniform(1.0_f64, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let (k, c, length, place) = (40.0, 3.0, 0.7, [1.8, 0.4]);
    let strut = Strut::to_ground((1, [0.6, 0.0]), place).with_stiffness(k).with_damping(c).with_length(length);
    let by_hand = Loads::none().on_bodies(|_, body, motion: &BodyMotion<f64>| {
        if body != 1 {
            return Wrench::default();
        }
        let point = motion.point([0.6, 0.0]);
        let apart = nalgebra::Vector2::from(place) - point.place;
        let direction = apart / apart.norm();
        let force = direction * (k * (apart.norm() - length) - c * direction.dot(&point.velocity));
        motion.force_at([0.6, 0.0], force.into())
    });
    let torques = [0.3, -0.2];
    let start = scene.with_rates(scene.at_rest(&[-0.3, 0.4])?, &[0.5, -2.0])?;
    let one = scene.with_accelerations(start, &Struts::of([strut]))?;
    let other = scene.with_accelerations(start, &by_hand)?;
    near(one.acceleration().0, other.acceleration().0, 1e-12);
    near(one.acceleration().1.1, other.acceleration().1.1, 1e-11);
    let (a, b) = (scene.stations(&one, &Struts::of([strut]))?, scene.stations(&other, &by_hand)?);
    near(a.root().internal.force.x, b.root().internal.force.x, 1e-11);
    near(a.root().internal.force.y, b.root().internal.force.y, 1e-11);
    near(a.tip().internal.force.y, 0.0, 1e-11);
    // Beside other loads.
    let one = scene.with_accelerations(start, &Struts::of([strut]).and(Loads::none().torques(torques)))?;
    let other = scene.with_accelerations(start, &by_hand.torques(torques))?;
    near(one.acceleration().1.1, other.acceleration().1.1, 1e-11);
    // What it does in this motion.
    let [reading] = Struts::of([strut]).readings(&scene, &start)?;
    let bodies = scene.body_motions(&start)?;
    let Some(point) = bodies.get(1).map(|body| body.point([0.6, 0.0])) else { unreachable!() };
    let apart = nalgebra::Vector2::from(place) - point.place;
    let parting = -apart.dot(&point.velocity) / apart.norm();
    near(reading.length, apart.norm(), 1e-14);
    near(reading.rate, parting, 1e-14);
    near(reading.tension, k * (apart.norm() - length) + c * parting, 1e-12);
    // And under implicit rules.
    let exact = scene.simulation(Dop853::tolerance(1e-12)).loads(&Struts::of([strut])).run(start, 1.0, |_| ())?;
    let mut errors = vec![];
    for h in [0.01, 0.005, 0.0025] {
        let rule = GeneralizedAlpha::new(0.8).step(h);
        let run = scene.simulation(rule).loads(&Struts::of([strut])).run(start, 1.0, |_| ())?;
        errors.push((h, (run.motion.position().1.1 - exact.motion.position().1.1).abs()));
    }
    has_order("angle", 2.0, 1e-11, &errors);
    Ok(())
}

#[test]
fn a_strut_on_no_body_is_refused_and_stiffness_has_a_derivative() -> Result<(), Error> {
    use planar::*;
    let scene = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?.with_gravity(9.81);
    let lost = Struts::of([Strut::between((0, [1.0, 0.0]), (7, [0.0, 0.0])).with_stiffness(1.0)]);
    let error = scene.with_accelerations(scene.at_rest(&[0.0])?, &lost).unwrap_err();
    assert_eq!(error.fault, Fault::NoSuchBody { body: 7, bodies: 1 }, "{error}");
    let strut = Strut::to_ground((0, [1.0, 0.0]), [2.0, 0.0]).with_length(0.5);
    for wrong in [
        strut.with_stiffness(-1.0),
        strut.with_damping(f64::NAN),
        strut.with_length(f64::INFINITY),
        strut.with_length(-0.5),
        Strut::to_ground((0, [f64::NAN, 0.0]), [2.0, 0.0]),
        strut.with_damping(-1.0),
    ] {
        let error = scene.with_accelerations(scene.at_rest(&[0.0])?, &Struts::of([wrong])).unwrap_err();
        assert!(matches!(error.fault, Fault::Negative { .. } | Fault::NotFinite { .. }), "{error}");
    }
    // Ends that meet: the line between them has no direction.
    let met = Struts::of([Strut::to_ground((0, [1.0, 0.0]), [1.0, 0.0]).with_stiffness(1.0).with_length(0.5)]);
    assert_eq!(scene.with_accelerations(scene.at_rest(&[0.0])?, &met).unwrap_err().fault, Fault::NonFiniteLoad);

    // θ̈ of a rod at rest along x: (k d − m g/2) / (m/3) for a strut of no length straight up at its tip.
    let k = Dual64::new(5.0, 1.0);
    let rod = Rod::uniform(Dual64::from(1.0), Dual64::from(1.0));
    let scene = System::new(Pinned::origin(), rod, Free)?.with_gravity(Dual64::from(9.81));
    let one = Dual64::from(1.0);
    let up = Struts::of([Strut::to_ground((0, [one, one * 0.0]), [one, one * 0.25]).with_stiffness(k)]);
    let found = scene.with_accelerations(scene.at_rest(&[Dual64::from(0.0)])?, &up)?.acceleration().0;
    near(found.re, 3.0 * (5.0 * 0.25 - 9.81 / 2.0), 1e-12);
    near(found.eps, 3.0 * 0.25, 1e-13);
    Ok(())
}

/// A damper and a length that are zero have derivatives, without which nothing would identify them.
#[test]
fn struts_that_are_not_there_have_derivatives() -> Result<(), Error> {
    use planar::*;
    let (one, o) = (Dual64::new(1.0, 0.0), Dual64::new(0.0, 0.0));
    let scene = System::new(Pinned::origin(), Rod::uniform(one, one), Free)?;
    let start = scene.with_rates(scene.at_rest(&[Dual64::new(0.4, 0.0)])?, &[Dual64::new(0.7, 0.0)])?;
    let strut = Strut::to_ground((0, [one, o]), [Dual64::new(1.5, 0.0), Dual64::new(0.3, 0.0)])
        .with_stiffness(Dual64::new(5.0, 0.0));
    let acceleration = |strut| -> Result<f64, Error> {
        Ok(scene.with_accelerations(start, &Struts::of([strut]))?.acceleration().0.eps)
    };
    // By hand: d/dc of the torque of the damping force about the pin, by the rod's inertia of 1/3.
    let (sine, cosine) = 0.4_f64.sin_cos();
    let (x, y) = (1.5 - cosine, 0.3 - sine);
    let length = x.hypot(y);
    let lever = (cosine * y - sine * x) / length;
    let parting = -0.7 * (-sine * x + cosine * y) / length;
    near(acceleration(strut.with_damping(Dual64::new(0.0, 1.0)))?, 3.0 * lever * parting, 1e-13);
    near(acceleration(strut.with_length(Dual64::new(0.0, 1.0)))?, -3.0 * lever * 5.0, 1e-13);
    let energy = strut.energy([one, o].into(), [Dual64::new(1.0, 1.0), o].into());
    assert_eq!((energy.re, energy.eps), (0.0, 0.0));
    Ok(())
}

/// Struts at bodies whose numbers differ by 64, one of them between two such, one between points of one body: as many as have lists, and in
/// lists of a few.
#[test]
fn many_struts_do_what_they_do_a_few_at_a_time() -> Result<(), Error> {
    use planar::*;
    const N: usize = 71;
    let rod = Rod::uniform(0.1, 0.2);
    let scene = System::new(Pinned::origin(), (rod, [(Pin, rod); N - 1]), Free)?.with_gravity(9.81);
    let angles: Vec<f64> = (0..N).map(|k| (0.3 * k as f64).sin() - 0.8).collect();
    let rates: Vec<f64> = (0..N).map(|k| (0.7 * k as f64).cos()).collect();
    let start = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
    let strut = |a: usize, b: usize| {
        Strut::between((a, [0.03, 0.01]), (b, [0.1, -0.02])).with_stiffness(30.0).with_damping(0.4).with_length(0.2)
    };
    let ground = |a: usize| Strut::to_ground((a, [0.1, 0.0]), [0.4, 0.7]).with_stiffness(12.0).with_length(0.5);
    let [a, b, c, d, e, f] = [strut(1, 65), strut(65, 30), strut(66, 2), strut(5, 5), ground(1), ground(65)];
    macro_rules! under {
        ($struts:expr) => {{
            let (found, mut list) = (scene.with_accelerations(start, &$struts)?, vec![]);
            catena::system::Rate::<f64>::visit(found.acceleration(), &mut |x| list.push(x));
            list
        }};
    }
    let together = under!(Struts::of([a, b, c, d, e, f]));
    let apart = under!(Struts::of([a, b, c]).and(Struts::of([d, e, f])));
    let size = apart.iter().fold(0.0_f64, |size, x: &f64| size.max(x.abs()));
    assert!(size > 1.0);
    together.iter().zip(&apart).for_each(|(one, other)| near(*one, *other, 1e-11 * size));
    // And nothing of them is left out.
    let without = under!(Struts::of([a, b, c, d, e]));
    assert!(without.iter().zip(&apart).any(|(one, other)| (one - other).abs() > 1e-3 * size));
    Ok(())
}
