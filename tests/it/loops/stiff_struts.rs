//! Struts whose stiffness implicit rules know: against springs in joints, against rigid joints in their place, and against explicit rules.

use catena::scalar::{Jet, Scalar};
use catena::{Error, Fault, planar, spatial};
use catena_oracle::{farthest, has_order, near};

/// A strut along a track is the spring of the slide on it, step by step.
#[test]
fn a_strut_along_a_track_is_the_spring_of_its_slide() -> Result<(), Error> {
    use planar::*;
    let block = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
    let free = System::new(Clamped::origin(), (Slider::along(0.3), block), Free)?.with_gravity(9.81);
    let behind = [-0.3_f64.cos(), -0.3_f64.sin()];
    for k in [1e2, 1e6] {
        let c = 0.01 * k;
        let spring = Spring::new(k).damped(c).resting_at(0.3);
        let sprung = System::new(Clamped::origin(), (Slider::along(0.3).with(spring), block), Free)?.with_gravity(9.81);
        let strut = Strut::to_ground((0, [0.0; 2]), behind).with_stiffness(k).with_damping(c).with_length(1.3);
        let loads = Struts::of([strut]).stiff();
        let (mut one, mut other) = (sprung.motion(), free.motion());
        one.set_coordinates(&[0.5])?;
        other.set_coordinates(&[0.5])?;
        macro_rules! alike {
            ($($rule:expr),*) => {$(
                let expected = sprung.simulation($rule).run(one, 0.2, |_| ())?;
                let found = free.simulation($rule).loads(&loads).run(other, 0.2, |_| ())?;
                near(found.motion.coordinates()[0], expected.motion.coordinates()[0], 1e-12);
                near(found.motion.rates()[0], expected.motion.rates()[0], 1e-11);
                assert_eq!(found.sweeps, expected.sweeps);
            )*};
        }
        alike!(GeneralizedAlpha::new(0.8).step(0.01), Sdirk4::default().step(0.01), Sdirk4::default().tolerance(1e-8));
    }
    Ok(())
}

/// Struts between bodies and to the ground, in the plane: the orders of rules, and steps by which struts as plain loads go astray.
#[test]
fn rules_keep_their_orders() -> Result<(), Error> {
    use planar::*;
    let rod = Rod::uniform(1.0_f64, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod, Pin, rod), Free)?.with_gravity(9.81);
    let across = Strut::between((0, [0.4, 0.1]), (2, [0.3, -0.1])).with_stiffness(300.0).with_damping(4.0);
    let down = Strut::to_ground((1, [0.7, 0.0]), [1.5, 1.2]).with_stiffness(200.0);
    let struts = Struts::of([across.with_length(0.9), down]);
    let start = scene.at_rest(&[0.4, -0.3, 0.5])?;
    let exact = scene.simulation(Dop853::tolerance(1e-12)).loads(&struts).run(start, 0.4, |_| ())?.motion.coordinates();
    let missed = |found: Vec<f64>| farthest(&found, &exact);
    let stiff = struts.stiff();
    let (mut second, mut fourth) = (vec![], vec![]);
    for h in [0.01, 0.005, 0.0025] {
        let run = scene.simulation(GeneralizedAlpha::new(0.8).step(h)).loads(&stiff).run(start, 0.4, |_| ())?;
        second.push((h, missed(run.motion.coordinates())));
        let run = scene.simulation(Sdirk4::default().step(h)).loads(&stiff).run(start, 0.4, |_| ())?;
        fourth.push((h, missed(run.motion.coordinates())));
    }
    println!("{second:?} {fourth:?}");
    has_order("generalised-alpha", 2.0, 1e-11, &second);
    has_order("Sdirk4", 4.0, 1e-11, &fourth);

    // As hard as steel, and not strained where it begins.
    let bodies = scene.body_motions(&start)?;
    let [Some(first), Some(last)] = [bodies.get(0), bodies.get(2)] else { unreachable!() };
    let apart = (last.point([0.3, -0.1]).place - first.point([0.4, 0.1]).place).norm();
    let hard = Struts::of([across.with_stiffness(1e9).with_length(apart)]);
    let rule = Sdirk4::default().step(0.01);
    let held = scene.simulation(rule).loads(&hard.stiff()).run(start, 1.0, |_| ())?;
    assert!(held.motion.rates().iter().all(|rate| rate.abs() < 20.0), "{held:?}");
    let plain = scene.simulation(rule).loads(&hard).run(start, 1.0, |_| ());
    assert!(plain.is_err_and(|stopped| stopped.error.fault == Fault::NonFiniteMotion));
    Ok(())
}

/// Struts of no length draw a tip to where a pin would hold it, in the plane and in space, also across: what they exert is what holds the pin.
#[test]
fn struts_of_no_length_are_pins_when_they_are_hard() -> Result<(), Error> {
    {
        use planar::*;
        let rod = Rod::uniform(1.0_f64, 1.0);
        let (free, held) = (Free, Pinned::at(1.2, 0.0));
        let loose = System::new(Pinned::origin(), (rod, Pin, rod, Pin, rod), free)?.with_gravity(9.81);
        let tied = System::new(Pinned::origin(), (rod, Pin, rod, Pin, rod), held)?.with_gravity(9.81);
        let begin = tied.assembled(tied.at_rest(&[1.0, -0.2, -1.0])?, &Unloaded)?;
        let start = loose.at_rest(&begin.coordinates())?;
        let pin = Struts::of([Strut::to_ground((2, [1.0, 0.0]), [1.2, 0.0]).with_stiffness(1e10)]).stiff();
        let rule = Sdirk4::default().step(2e-3);
        let expected = tied.simulation(rule).run(begin, 0.5, |_| ())?.motion;
        let found = loose.simulation(rule).loads(&pin).run(start, 0.5, |_| ())?.motion;
        for (a, b) in found.coordinates().iter().zip(expected.coordinates()) {
            near(*a, b, 1e-6); // it begins without the stretch that bears the rods, which is a jerk within the first step
        }
    }
    use spatial::*;
    let rod = Rod::uniform(0.7, 0.1, 1.2);
    let place = [0.9, 0.2, -0.6];
    let loose = System::new(Pinned::origin(), (rod, Ball, rod, Ball, rod), Free)?.with_gravity([0.0, 0.0, -9.81]);
    let tied = System::new(Pinned::origin(), (rod, Ball, rod, Ball, rod), Pinned::at(place))?;
    let tied = tied.with_gravity([0.0, 0.0, -9.81]);
    let begin = tied.assembled(tied.at_rest(&[0.1, 0.4, -0.3, 0.2, 0.5, 0.1, -0.2, 0.3, 0.6])?, &Unloaded)?;
    let mut start = loose.motion();
    *start.position_mut() = *begin.position();
    let pin = Struts::of([Strut::to_ground((2, [0.7, 0.0, 0.0]), place).with_stiffness(1e9)]).stiff();
    let expected = tied.simulation(Dop853::tolerance(1e-12)).run(begin, 0.3, |_| ())?.motion.rates();
    let mut missed = vec![];
    for h in [4e-3, 2e-3, 1e-3] {
        let found = loose.simulation(GeneralizedAlpha::new(0.5).step(h)).loads(&pin).run(start, 0.3, |_| ())?.motion;
        let tip = loose.stations(&found, &pin)?.tip().frame.place;
        tip.iter().zip(place).for_each(|(a, b)| near(*a, b, 1e-7));
        let rates = found.rates();
        missed.push((h, farthest(&rates, &expected)));
    }
    has_order("rates", 2.0, 1e-11, &missed);
    Ok(())
}

/// Beside hinges whose linear springs, along fixed axes, remember a sweep.
#[test]
fn sweeps_that_ask_what_forces_cause_are_not_remembered() -> Result<(), Error> {
    use planar::*;
    let rod = Rod::uniform(1.0_f64, 1.0);
    let hinge = ElasticHinge::linear(Spring::new(2e3).damped(5.0), Spring::new(3e3).damped(4.0)).in_fixed_axes();
    let scene = System::new(Pinned::origin(), (rod, hinge, rod), Free)?.with_gravity(9.81);
    let strut = Strut::to_ground((1, [0.7, 0.0]), [1.5, 1.2]).with_stiffness(300.0).with_damping(2.0).with_length(1.0);
    let (struts, start) = (Struts::of([strut]), scene.motion());
    let exact = scene.simulation(Dop853::tolerance(1e-12)).loads(&struts).run(start, 0.5, |_| ())?.motion.coordinates();
    let missed = |found: Vec<f64>| farthest(&found, &exact);
    let (mut second, mut fourth, stiff) = (vec![], vec![], struts.stiff());
    for h in [4e-3, 2e-3, 1e-3] {
        let run = scene.simulation(GeneralizedAlpha::new(0.8).step(h)).loads(&stiff).run(start, 0.5, |_| ())?;
        second.push((h, missed(run.motion.coordinates())));
        let run = scene.simulation(Sdirk4::default().step(h)).loads(&stiff).run(start, 0.5, |_| ())?;
        fourth.push((h, missed(run.motion.coordinates())));
    }
    has_order("generalised-alpha", 2.0, 1e-11, &second);
    has_order("Sdirk4", 4.0, 1e-12, &fourth);
    Ok(())
}

/// Where a tip is held, too, generalised-α keeps its order far beyond the vibration of a strut: 1e8 N/m, some 1e4 rad/s, at steps of milliseconds.
#[test]
fn hard_struts_leave_closures_closed() -> Result<(), Error> {
    use planar::*;
    let rod = Rod::uniform(1.0_f64, 1.0);
    let chain = (rod, Pin, rod, Pin, rod, Pin, rod);
    let scene = System::new(Pinned::origin(), chain, Pinned::at(1.6, 0.0))?.with_gravity(9.81);
    let start = scene.assembled(scene.at_rest(&[1.0, 0.3, -0.4, -1.0])?, &Unloaded)?;
    let bodies = scene.body_motions(&start)?;
    let [Some(second), Some(last)] = [bodies.get(1), bodies.get(3)] else { unreachable!() };
    let length = (second.point([0.5, 0.1]).place - last.point([0.4, 0.0]).place).norm();
    let strut = Strut::between((1, [0.5, 0.1]), (3, [0.4, 0.0])).with_stiffness(1e8).with_length(length);
    let stiff = Struts::of([strut]).stiff();
    let end = |h: f64| {
        let run = scene.simulation(GeneralizedAlpha::new(0.5).step(h)).loads(&stiff).run(start, 0.3, |_| ())?;
        let [reading] = stiff.plain().readings(&scene, &run.motion)?;
        near(reading.length - length, reading.tension / 1e8, 1e-12);
        Ok::<_, Error>(run.motion.coordinates())
    };
    let fine = end(2.5e-4)?;
    let mut missed = vec![];
    for h in [4e-3, 2e-3, 1e-3] {
        let found = end(h)?;
        missed.push((h, farthest(&found, &fine)));
    }
    has_order("coordinates", 2.0, 1e-11, &missed);
    Ok(())
}

/// Over jets, by stiffness, length and place: as an explicit rule to a tight tolerance.
#[test]
fn derivatives_follow() -> Result<(), Error> {
    use planar::*;
    macro_rules! run {
        ($rule:expr, |$struts:ident| $loads:expr) => {{
            let numbers: [Jet<f64, 3>; 3] = [Jet::seed(800.0, 0), Jet::seed(0.9, 1), Jet::seed(0.3, 2)];
            let of = |x: f64| <Jet<f64, 3> as Scalar>::literal(x);
            let rod = Rod::uniform(of(1.0), of(1.0));
            let scene =
                System::new(Pinned::origin(), (rod, Pin, rod), Pinned::at(of(1.2), of(0.0)))?.with_gravity(of(9.81));
            let strut = Strut::between((0, [numbers[2], of(0.1)]), (1, [of(0.6), of(0.0)]));
            let strut = strut.with_stiffness(numbers[0]).with_damping(of(2.0)).with_length(numbers[1]);
            let start = scene.assembled(scene.at_rest(&[of(0.8), of(-1.0)])?, &Unloaded)?;
            let $struts = Struts::of([strut]);
            scene.simulation($rule).loads(&$loads).run(start, 0.5, |_| ())?.motion.coordinates()
        }};
    }
    let expected = run!(Dop853::tolerance(1e-12), |struts| struts);
    let found = run!(Sdirk4::default().step(1e-3), |struts| struts.stiff());
    for (a, b) in found.iter().zip(&expected) {
        near(a.re, b.re, 1e-9);
        for k in 0..3 {
            near(a.eps[k], b.eps[k], 1e-8);
        }
    }
    Ok(())
}
