//! Runs that go on from where they were saved, refused or ended: at events, after errors, after their last step.

use crate::record::{bits, read, same};
use catena::planar::*;
use catena::simulate::Stepper;
use catena::{Error, Fault};
use std::cell::Cell;
use std::f64::consts::PI;

type Rods = System<f64, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free>;

fn rods() -> Result<Rods, Error> {
    let rod = Rod::uniform(1.0, 2.0);
    Ok(System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81))
}

#[test]
fn a_run_has_a_time_to_start_from() -> Result<(), Error> {
    let scene = rods()?;
    for time in [f64::NAN, f64::NEG_INFINITY] {
        let start = scene.at_rest(&[-1.0, -0.5])?.at_time(time);
        let refused = scene.simulation(Rk4::step(0.01)).begin(start, 1.0, |_| ()).err();
        assert!(refused.is_some_and(|refused| matches!(refused.error.fault, Fault::NotFinite { .. })), "{time}");
        let refused = scene.simulation(Dop853::tolerance(1e-6)).begin(start, 1.0, |_| ()).err();
        assert!(refused.is_some_and(|refused| matches!(refused.error.fault, Fault::NotFinite { .. })), "{time}");
    }
    Ok(())
}

#[test]
fn a_first_step_can_be_read() -> Result<(), Error> {
    let scene = rods()?;
    let mut run = scene.simulation(Vcabm::new().tolerance(1e-6)).begin(scene.at_rest(&[-1.0, -0.5])?, 1.0, |_| ())?;
    run.step()?;
    read(&run.save());
    Ok(())
}

#[test]
fn trials_that_failed_can_be_read() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 2.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod, Pin, rod), Pinned::at(1.0, 0.0))?.with_gravity(9.81);
    let start = scene.at_rest(&[-1.2, 0.0, PI - 1.2])?;
    let loads = Loads::none().in_joints(|time, _, _: &JointMotion<f64>| if time < 0.3 { 0.0 } else { f64::NAN });
    let mut run = scene.simulation(Dopri5::tolerance(1e-6)).loads(&loads).begin(start, 1.0, |_| ())?;
    while run.step().is_ok() {}
    read(&run.save());
    Ok(())
}

#[test]
fn a_run_after_a_rejection_goes_on_by_its_tolerance() -> Result<(), Error> {
    let scene = rods()?;
    let simulation = || scene.simulation(Vcabm::new().tolerance(1e-8));
    let mut run = simulation().begin(scene.at_rest(&[-1.0, -0.5])?, 1.0, |_| ())?;
    run.until(0.5)?;
    let text = serde_json::to_string(&run.save()).unwrap();
    let rejected = text.replacen("\"careful\":false", "\"careful\":true", 1);
    assert_ne!(rejected, text);
    let mut resumed = simulation().resume(serde_json::from_str(&rejected).unwrap(), 1.0, |_| ())?;
    resumed.step()?;
    // One a trial, where a step of a given size takes twelve.
    assert!((1..=3).contains(&resumed.stepper().sweeps()), "{}", resumed.stepper().sweeps());
    Ok(())
}

#[test]
fn a_finished_run_goes_on_by_steps_of_its_size() -> Result<(), Error> {
    let scene = rods()?;
    let mut run = scene.simulation(Rk4::step(0.3)).begin(scene.at_rest(&[-1.0, -0.5])?, 1.0, |_| ())?;
    while run.step()? {}
    let mut further = scene.simulation(Rk4::step(0.3)).resume(run.save(), 2.0, |_| ())?;
    further.step()?;
    assert_eq!(further.motion().time(), 1.3);
    Ok(())
}

#[test]
fn an_event_is_found_once() -> Result<(), Error> {
    let scene = rods()?;
    for place in 0..20 {
        // A value that jumps: rounding decides on which side of it an event is found.
        let place = 1.1 + 0.01 * f64::from(place);
        let rule = Dop853::tolerance(1e-9);
        let simulation = || {
            let events = scene.simulation(rule).event(move |now| {
                let position = now.motion().position();
                f64::signum(position.0 + place)
            });
            events.stopping()
        };
        let mut run = simulation().begin(scene.at_rest(&[-1.0, -0.5])?, 2.0, |_| ())?;
        while run.step()? {}
        let time = run.motion().time();
        assert!(time < 1.0, "{time}");
        let resumed = simulation().resume(run.save(), time + 0.1, |_| ())?;
        let [read, _] = read(&resumed.save());
        let again = simulation().resume(read, time + 0.1, |_| ())?.finish()?;
        assert_eq!(again.motion.time(), time + 0.1, "{place}");
        same("event", &again.motion, &resumed.finish()?.motion);
    }
    Ok(())
}

#[test]
fn a_step_that_its_event_function_refuses_is_not_counted() -> Result<(), Error> {
    let (scene, broken) = (rods()?, Cell::new(false));
    let simulation =
        scene.simulation(Rk4::step(0.1)).event(|now| if broken.get() { f64::NAN } else { now.time() + 1.0 });
    let mut run = simulation.begin(scene.at_rest(&[-1.0, -0.5])?, 1.0, |_| ())?;
    run.step()?;
    broken.set(true);
    assert!(run.step().is_err());
    broken.set(false);
    run.step()?;
    assert_eq!(run.motion().time(), 0.2);
    assert_eq!(run.finish()?.steps, 10);
    Ok(())
}

#[test]
fn sweeps_have_a_bound() {
    let most = format!("{{\"sweeps\":{}}}", usize::MAX);
    let read: Sdirk4 = serde_json::from_str(&most).unwrap();
    assert_eq!(serde_json::to_string(&read).unwrap(), "{\"sweeps\":1000}");
    let text = serde_json::to_string(&GeneralizedAlpha::new(0.8)).unwrap();
    let most = text.replace("\"sweeps\":2", &format!("\"sweeps\":{}", usize::MAX));
    let read: GeneralizedAlpha = serde_json::from_str(&most).unwrap();
    assert_eq!(serde_json::to_string(&read).unwrap(), text.replace("\"sweeps\":2", "\"sweeps\":1000"));
}

#[test]
fn a_race_that_none_has_run_does_not_go_on() -> Result<(), Error> {
    let scene = rods()?;
    let simulation = || scene.simulation(Auto::tolerance(1e-6));
    let mut run = simulation().begin(scene.at_rest(&[-1.0, -0.5])?, 1.0, |_| ())?;
    run.until(0.3)?;
    let text = serde_json::to_string(&run.save()).unwrap();
    for (field, new) in [
        ("taken", u64::MAX.to_string()),
        ("suspicious", u64::MAX.to_string()),
        ("patience", u64::MAX.to_string()),
        ("since", u64::MAX.to_string()),
        ("plain", "\"Sdirk4\"".into()),
        ("size", "-1.0".into()),
    ] {
        let at = text.find("\"race\"").unwrap();
        let from = at + text[at..].find(&format!("\"{field}\":")).unwrap() + field.len() + 3;
        let to = from + text[from..].find([',', '}']).unwrap();
        let saved = serde_json::from_str(&format!("{}{new}{}", &text[..from], &text[to..])).unwrap();
        let refused = simulation().resume(saved, 1.0, |_| ()).err();
        assert!(refused.is_some_and(|refused| refused.error.fault == Fault::Shape), "{field}");
    }
    Ok(())
}

#[test]
fn samples_do_not_decide_a_race() -> Result<(), Error> {
    let (rod, hinge) = (Rod::uniform(0.3, 0.3), ElasticHinge::rotary(1e5).damped(6.0));
    let scene = System::new(Pinned::origin(), (rod, [(hinge, rod); 3]), Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[-0.5; 4])?;
    let alone = scene.simulation(Auto::tolerance(1e-5)).run(start, 0.3, |_| ())?;
    let sampled = scene.simulation(Auto::tolerance(1e-5)).every(3e-4).run(start, 0.3, |_| ())?;
    assert!(sampled.sweeps > alone.sweeps + 900);
    assert_eq!((sampled.steps, bits(&sampled.motion)), (alone.steps, bits(&alone.motion)));
    Ok(())
}

#[test]
fn a_series_is_that_of_the_loads_handed_in() -> Result<(), Error> {
    let scene = rods()?;
    let (none, some) = (Loads::none().torques([0.0, 0.0]), Loads::none().torques([0.0, 1.0]));
    let start = scene.with_accelerations(scene.at_rest(&[-1.0, -0.5])?, &none)?;
    let (mut stepper, mut next) = (scene.stepper(Taylor::<12>), start);
    stepper.step(&start, &none, 0.01, &mut next)?;
    let now = scene.with_accelerations(next, &some)?;
    stepper.advance(&now, &some, 0.01, &mut next)?;
    let (mut other, mut expected) = (scene.stepper(Taylor::<12>), start);
    other.step(&now, &some, 0.01, &mut expected)?;
    same("series", &next, &expected);
    Ok(())
}

#[test]
fn a_run_that_goes_on_keeps_to_the_order_allowed() -> Result<(), Error> {
    let scene = rods()?;
    let mut run = scene.simulation(Vcabm::new().tolerance(1e-10)).begin(scene.at_rest(&[-1.0, -0.5])?, 2.0, |_| ())?;
    run.until(0.5)?;
    let made = |text: &str| -> usize {
        let from = text.find("\"made\":").unwrap() + 7;
        text[from..][..text[from..].find(',').unwrap()].parse().unwrap()
    };
    assert!(made(&serde_json::to_string(&run.save()).unwrap()) > 3);
    let mut run = scene.simulation(Vcabm::new().up_to(3).tolerance(1e-10)).resume(run.save(), 2.0, |_| ())?;
    for _ in 0..5 {
        run.step()?;
        let order = made(&serde_json::to_string(&run.save()).unwrap());
        assert!(order <= 3, "{order}");
    }
    Ok(())
}
