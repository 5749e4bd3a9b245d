//! Tips and loops that are open: what is out of reach says by how much, and no run begins from what its steps would not close.

use catena::loading::Unloaded;
use catena::planar::*;
use catena::{Error, Fault, Place, spatial};
use catena_oracle::near;

fn rod() -> Rod<f64> {
    Rod::uniform(1.0, 1.0)
}

/// Two rods reach two metres: the residual is what is missing, if the guess is drawn straight towards the place.
#[test]
fn a_tip_out_of_reach_says_by_how_much() -> Result<(), Error> {
    for [x, y] in [[3.0, 0.0], [0.0, 3.0], [-3.0, 0.1], [2.0001, 0.0]] {
        let scene = System::new(Pinned::origin(), (rod(), Pin, rod()), Pinned::at(x, y))?;
        let error = scene.assembled(scene.at_rest(&[0.3, -0.3])?.at_time(0.5), &Unloaded).unwrap_err();
        println!("{error}");
        let Fault::NotClosed { residual } = error.fault else { panic!("{error}") };
        assert!(residual >= x.hypot(y) - 2.0 && residual < x.hypot(y) - 1.9, "{residual}");
        assert_eq!((error.place, error.time), (Some(Place::Tip), Some(0.5)));
    }
    // Where it can be reached, but straight: closed, and nothing says where to bend.
    let scene = System::new(Pinned::origin(), (rod(), Pin, rod()), Pinned::at(2.0, 0.0))?;
    let error = scene.assembled(scene.at_rest(&[0.3, -0.3])?, &Unloaded).unwrap_err();
    assert!(matches!(error.fault, Fault::RedundantClosures { independent: 1, of: 2, .. }), "{error}");
    // Too many closures for the chain are so wherever it is.
    let scene = System::new(Pinned::origin(), rod(), Pinned::at(0.9, 0.0))?;
    let error = scene.assembled(scene.at_rest(&[0.3])?, &Unloaded).unwrap_err();
    assert!(matches!(error.fault, Fault::RedundantClosures { independent: 1, of: 2, .. }), "{error}");
    Ok(())
}

/// The tip stands at 1.91 m.
#[test]
fn runs_do_not_begin_from_open_chains() -> Result<(), Error> {
    for place in [1.5, 1.0, 0.2, 2.5] {
        let scene = System::new(Pinned::origin(), (rod(), Pin, rod()), Pinned::at(place, 0.0))?;
        let start = scene.at_rest(&[0.3, -0.3])?;
        let mut shown = 0;
        let stopped = scene.simulate(start, Rk4::step(0.01), 0.1, |_| shown += 1).unwrap_err();
        let Fault::NotAssembled { residual } = stopped.error.fault else { panic!("{}", stopped.error) };
        near(residual, (2.0 * 0.3_f64.cos() - place).abs(), 1e-14);
        assert!(shown == 0 && stopped.last == start && stopped.error.place == Some(Place::Tip));
    }
    Ok(())
}

#[test]
fn runs_do_not_begin_from_open_loops() -> Result<(), Error> {
    let side = (RigidBody::massless([1.0, 0.0]), Pin, rod());
    let loops = Network::new((Pin, rod(), Pin, rod()), side, Pin);
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), loops, Free)?.with_gravity(9.81);
    let error =
        scene.simulate(scene.at_rest(&[1.0, -0.5, 0.3])?, Sdirk4::new().step(0.01), 0.1, |_| ()).unwrap_err().error;
    assert!(matches!((error.fault, error.place), (Fault::NotAssembled { .. }, Some(Place::Station(7)))), "{error}");
    let start = scene.assembled(scene.at_rest(&[1.0, -0.5, 0.3])?, &Unloaded)?;
    scene.simulate(start, Sdirk4::new().step(0.01), 0.1, |_| ())?;
    Ok(())
}

/// Joints that stick, or rest against their stops, hold nothing open.
#[test]
fn nor_where_joints_stick() -> Result<(), Error> {
    let side = (RigidBody::massless([1.0, 0.0]), Pin, rod());
    let stuck = Coulomb::new(Revolute::smooth(), 0.5);
    let loops = Network::new((stuck, rod(), HardStops::between(Revolute::smooth(), [-2.0, 2.0]), rod()), side, Pin);
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), loops, Free)?.with_gravity(9.81);
    let guess = scene.at_rest(&[1.0, -0.5, 0.3])?;
    let error = scene.simulate(guess, Rk4::step(0.01), 0.1, |_| ()).unwrap_err().error;
    assert!(matches!((error.fault, error.place), (Fault::NotAssembled { .. }, Some(Place::Station(7)))), "{error}");
    scene.simulate(scene.assembled(guess, &Unloaded)?, Rk4::step(0.01), 0.1, |_| ())?;
    Ok(())
}

#[test]
fn nor_in_space() -> Result<(), Error> {
    use spatial::*;
    let rod = Rod::uniform(1.0, 0.05, 1.0);
    let scene = System::new(Clamped::origin(), (Ball, rod, Ball, rod), Pinned::at([1.0, 0.5, 0.0]))?;
    let guess = scene.at_rest(&[0.1, 0.3, 0.2, 0.0, -0.4, 0.1])?;
    let error = scene.simulate(guess, Rk4::step(0.01), 0.1, |_| ()).unwrap_err().error;
    assert!(matches!((error.fault, error.place), (Fault::NotAssembled { .. }, Some(Place::Tip))), "{error}");
    scene.simulate(scene.assembled(guess, &Unloaded)?, Rk4::step(0.01), 0.1, |_| ())?;
    Ok(())
}

/// Angles of three digits are near enough: the motion closes, and stays so.
#[test]
fn a_start_of_few_digits_is_closed_by_its_steps() -> Result<(), Error> {
    let chain = (Rod::uniform(0.3, 0.3), Pin, Rod::uniform(0.9, 0.9), Pin, Rod::uniform(0.6, 0.6));
    let scene = System::new(Pinned::origin(), chain, Pinned::at(0.8, 0.0))?.with_gravity(9.81);
    let exact = scene.assembled(scene.at_rest(&[1.0_f64, 0.2, -1.5])?, &Unloaded)?;
    let rounded: Vec<f64> = exact.coordinates().iter().map(|angle: &f64| (1e3 * angle).round() / 1e3).collect();
    let run = scene.simulate(scene.at_rest(&rounded)?, Rk4::step(0.01), 0.5, |_| ())?;
    let tip = scene.stations(&run.motion, &Unloaded)?.tip().frame.place;
    near(tip.x, 0.8, 1e-14);
    near(tip.y, 0.0, 1e-14);
    Ok(())
}

/// Rates that closures do not allow, as of a crank alone: the run is that from the nearest that they do, whatever its first step.
#[test]
fn rates_that_nothing_allows_become_the_nearest_before_the_first_step() -> Result<(), Error> {
    let bar = |length: f64| Rod::uniform(length, length);
    let chain = (bar(0.5), Pin, bar(1.2), Pin, bar(0.9));
    let held = System::new(Pinned::origin(), chain, Pinned::at(1.0, 0.0))?.with_gravity(9.81);
    let side = (RigidBody::massless([1.0, 0.0]), Coulomb::new(Revolute::smooth(), 0.01), bar(0.9));
    let net = Network::new((HardStops::between(Revolute::smooth(), [-9.0, 9.0]), bar(0.5), Pin, bar(1.2)), side, Pin);
    let closed = System::new(Clamped::origin(), net, Free)?.with_gravity(9.81);
    macro_rules! same {
        ($scene:expr, $guess:expr) => {{
            let mut start = $scene.assembled($scene.at_rest(&$guess)?, &Unloaded)?;
            start.set_rates(&[2.0, 0.0, 0.0])?;
            let assembled = $scene.assembled(start, &Unloaded)?;
            for tolerance in [1e-6, 1e-9] {
                let mut first = None;
                let [set, assembled_end] = [start, assembled].map(|start| {
                    let run = $scene.simulate(start, Dop853::tolerance(tolerance), 0.8, |now| {
                        first = first.or(Some(now.motion().rates()[0]));
                    });
                    run.map(|run| run.motion.coordinates()[0]).map_err(|stopped| stopped.error)
                });
                near(first.unwrap_or(f64::NAN), assembled.rates()[0], 1e-12);
                near(set?, assembled_end?, 10.0 * tolerance);
            }
        }};
    }
    same!(held, [1.05, 0.3, -2.0]);
    same!(closed, [1.0, 0.3, 1.2]);
    Ok(())
}
