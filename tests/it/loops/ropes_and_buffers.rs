//! Struts that only pull, or only push: against the closed form of a block that bounces on a rope, and on a buffer.

use catena::Error;
use catena::planar::*;
use catena_oracle::near;
use core::f64::consts::{FRAC_PI_2, PI};

const G: f64 = 9.81;

/// From where it falls freely by 0.5 m until a spring decelerates it and throws it back: the time of a round, in which it returns.
fn round(mass: f64, stiffness: f64) -> f64 {
    let (omega, free) = ((stiffness / mass).sqrt(), (1.0 / G).sqrt());
    let phase = (G * free / omega).atan2(mass * G / stiffness);
    2.0 * free + (2.0 * PI - 2.0 * phase) / omega
}

#[test]
fn a_block_bounces_on_a_rope_and_on_a_buffer() -> Result<(), Error> {
    let (mass, stiffness) = (2.0, 800.0);
    let block = RigidBody::new(mass, 0.1, [0.0; 2], [0.0; 2]);
    let fall = System::new(Clamped::origin(), (Slider::along(FRAC_PI_2), block), Free)?.with_gravity(G);
    let spring = |place| Strut::to_ground((0, [0.0; 2]), [0.0, place]).with_stiffness(stiffness);
    // Taut, or pressed, half a metre further down.
    let (rope, buffer) = (spring(1.0).with_length(1.5).pulling(), spring(-2.0).with_length(1.5).pushing());
    for strut in [rope, buffer] {
        let (loads, rounds) = (Struts::of([strut]), 3.0 * round(mass, stiffness));
        for (tolerance, bound) in [(1e-6, 1e-3), (1e-9, 1e-6), (1e-12, 1e-8)] {
            let run = fall.simulation(Dop853::tolerance(tolerance)).loads(&loads).run(fall.motion(), rounds, |_| ())?;
            near(run.motion.coordinates()[0], 0.0, bound);
            near(run.motion.rates()[0], 0.0, bound);
            let [reading] = loads.readings(&fall, &run.motion)?;
            assert_eq!((reading.tension, reading.energy), (0.0, 0.0));
        }
        // By an implicit rule that knows its stiffness, the same steps as by one that resolves its vibration.
        let rule = Sdirk4::new().step(1e-3);
        let plain = fall.simulation(rule).loads(&loads).run(fall.motion(), rounds, |_| ())?.motion;
        let stiff = fall.simulation(rule).loads(&loads.stiff()).run(fall.motion(), rounds, |_| ())?.motion;
        near(stiff.coordinates()[0], plain.coordinates()[0], 1e-10);
        near(stiff.coordinates()[0], 0.0, 1e-4);
    }
    // A hard rope with a damper catches it.
    let hard = Struts::of([spring(1.0).with_stiffness(1e8).with_damping(1e5).with_length(1.5).pulling()]).stiff();
    let run = fall.simulation(Sdirk4::new().tolerance(1e-7)).loads(&hard).run(fall.motion(), 2.0, |_| ())?;
    near(run.motion.coordinates()[0], -0.5 - mass * G / 1e8, 1e-11);
    assert!(run.steps < 400, "{}", run.steps);
    let run = fall.simulation(MoreauJean::step(1e-3)).loads(&hard).run(fall.motion(), 2.0, |_| ())?;
    near(run.motion.coordinates()[0], -0.5 - mass * G / 1e8, 1e-11);
    Ok(())
}

/// Where it is taut a rope is a spring that pushes, too; a rope without a length always is.
#[test]
fn a_taut_rope_is_a_spring() -> Result<(), Error> {
    let rod = Rod::uniform(1.0_f64, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(G);
    let start = scene.at_rest(&[-0.3, 0.4])?;
    let strut = Strut::to_ground((1, [0.6, 0.0]), [1.8, 0.4]).with_stiffness(40.0);
    for (strut, length) in [(strut.with_damping(3.0), 0.1), (strut, 0.0)] {
        let strut = strut.with_length(length);
        let accelerations = |strut| {
            let found = scene.with_accelerations(start, &Struts::of([strut]))?;
            Ok::<_, Error>([found.acceleration().0, found.acceleration().1.1])
        };
        assert_eq!(accelerations(strut)?, accelerations(strut.pulling())?);
        // And a buffer does nothing there; it needs a length.
        if length == 0.0 {
            let refused = accelerations(strut.pushing()).unwrap_err().fault;
            assert!(matches!(refused, catena::Fault::NotPositive { parameter: "length of a buffer", .. }));
            continue;
        }
        let none = scene.with_accelerations(start, &Unloaded)?;
        let pushed = accelerations(strut.pushing())?;
        near(pushed[0], none.acceleration().0, 1e-12);
        near(pushed[1], none.acceleration().1.1, 1e-12);
    }
    Ok(())
}
