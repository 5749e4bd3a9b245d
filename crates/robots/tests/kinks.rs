//! Runs under loads with kinks, whose steps end there: a car between two buffers and a wheel under a limited motor, against closed forms.

use catena::planar::*;
use catena::simulate::Run;
use catena::system::MotionOf;
use catena::{Error, Fault, Real, Scalar};
use catena_oracle::{has_order, near};
use core::f64::consts::PI;

/// A spring (N/m) at both ends of the range from −1 m to 1 m.
#[derive(Clone, Copy, Debug)]
struct Buffers<T>(T);

impl<T: Scalar<Real = T> + Real> SpringLaw<T> for Buffers<T> {
    fn force(&self, position: T, _: T) -> T {
        let one = T::one();
        let beyond = |depth: T| depth.max(T::zero());
        self.0 * (beyond(-one - position) - beyond(position - one))
    }
    fn energy(&self, position: T) -> T {
        let force = self.force(position, T::zero());
        force * force / (self.0 + self.0)
    }
    fn pivot(&self, position: T, _: T, springs: impl Springs<T>) -> T {
        let touches = position > T::one() || position < -T::one();
        springs.pivot(if touches { self.0 } else { T::zero() }, T::zero())
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

const MASS: f64 = 2.0; // (kg)
const STIFFNESS: f64 = 50.0; // (N/m)
const SPEED: f64 = 3.0; // (m/s)

type Car<T> = System<T, Clamped<[T; 2], T>, (Slider<T, Buffers<T>>, RigidBody<T>), Free>;

fn car<T: Scalar<Real = T> + Real>() -> Result<Car<T>, Error> {
    let o = T::zero();
    let slider = Slider::along(o).with(Buffers(T::of(STIFFNESS)));
    System::new(Clamped::at(o, o, o), (slider, RigidBody::new(T::of(MASS), T::one(), [o; 2], [o; 2])), Free)
}

type CarMotion<T> = MotionOf<Planar<T>, Clamped<[T; 2], T>, (Slider<T, Buffers<T>>, RigidBody<T>), Free>;

/// The car in the middle.
fn start<T: Scalar<Real = T> + Real>(car: &Car<T>) -> Result<CarMotion<T>, Error> {
    let mut start = car.motion();
    start.set_rates(&[T::of(SPEED)])?;
    Ok(start)
}

/// Place (m) and velocity (m/s) of the car at a time.
fn exact(time: f64) -> [f64; 2] {
    let omega = (STIFFNESS / MASS).sqrt();
    let (flight, contact) = (2.0 / SPEED, PI / omega);
    let passed = time + 0.5 * flight;
    let (round, since) = ((passed / (flight + contact)).floor(), passed % (flight + contact));
    let side = if round % 2.0 == 0.0 { 1.0 } else { -1.0 };
    if since < flight {
        return [side * (SPEED * since - 1.0), side * SPEED];
    }
    let phase = omega * (since - flight);
    [side * (1.0 + SPEED / omega * phase.sin()), side * SPEED * phase.cos()]
}

fn place<T: Scalar<Real = T> + Real>(motion: &CarMotion<T>) -> T {
    motion.position().1.0
}

/// The distances of a car from both buffers.
fn apart<T: Scalar<Real = T> + Real>(motion: &CarMotion<T>) -> [T; 2] {
    [place(motion) - T::one(), place(motion) + T::one()]
}

const END: f64 = 5.0; // (s), after four contacts
const TOLERANCE: f64 = 1e-9;

/// Runs by a rule, with kinks told or not, and how far the car is from where it should be (m, m/s: the larger one).
macro_rules! off {
    ($rule:expr, $told:expr) => {{
        let car = car::<f64>()?;
        let run: Run<CarMotion<f64>> = if $told {
            car.simulation($rule).kinks(|now| apart(now.stepped())).run(start(&car)?, END, |_| ())?
        } else {
            car.simulation($rule).run(start(&car)?, END, |_| ())?
        };
        let [x, v] = exact(END);
        let off = (place(&run.motion) - x).abs().max((run.motion.rates()[0] - v).abs());
        Ok::<_, Error>((off, run))
    }};
}

#[test]
fn the_closed_form_is_a_motion_of_the_car() {
    for k in 0..200 {
        let (time, h) = (0.0251 * f64::from(k), 1e-6);
        let ([x, v], [before, _], [after, _]) = (exact(time), exact(time - h), exact(time + h));
        near((after - before) / (2.0 * h), v, 1e-4);
        let beyond = (x.abs() - 1.0).max(0.0);
        near(0.5 * MASS * v * v + 0.5 * STIFFNESS * beyond * beyond, 0.5 * MASS * SPEED * SPEED, 1e-12);
    }
}

#[test]
fn rules_keep_their_order_across_kinks() -> Result<(), Error> {
    macro_rules! order {
        ($name:literal, $order:literal, $floor:literal, $steps:expr, $rule:expr) => {{
            let (mut points, mut better) = (vec![], true);
            for step in $steps {
                let (off, run) = off!($rule(step), true)?;
                let (hunting, _) = off!($rule(step), false)?;
                println!("{} {step}: {off:.2e}, not told {hunting:.2e}, {} steps", $name, run.steps);
                better &= hunting > 5.0 * off;
                points.push((step, off));
            }
            has_order($name, $order, $floor, &points);
            assert!(better);
        }};
    }
    order!("RK4", 4.0, 1e-12, [0.01, 0.005, 0.0025, 0.00125], Rk4::step);
    order!("DOPRI5", 5.0, 1e-13, [0.01, 0.005, 0.0025], Dopri5::step);
    order!("DOP853", 8.0, 1e-14, [0.16, 0.08, 0.04, 0.02], Dop853::step);
    order!("SDIRK4", 4.0, 1e-13, [0.01, 0.005, 0.0025, 0.00125], |step| Sdirk4::new().step(step));
    Ok(())
}

#[test]
fn under_error_control_no_rule_hunts_for_kinks() -> Result<(), Error> {
    macro_rules! cheap {
        ($name:literal, $rule:expr) => {{
            let ((off, told), (hunting, hunts)) = (off!($rule, true)?, off!($rule, false)?);
            println!("{}: {off:.1e} in {} sweeps, not told {hunting:.1e} in {}", $name, told.sweeps, hunts.sweeps);
            // Some sixty steps, each of which errs by the tolerance at most.
            assert!(off < 60.0 * TOLERANCE && off < 0.6 * hunting, "{off:e} {hunting:e}");
            assert!(told.rejected < hunts.rejected && 10 * told.sweeps < 11 * hunts.sweeps);
        }};
    }
    cheap!("DOPRI5", Dopri5::tolerance(TOLERANCE));
    cheap!("DOP853", Dop853::tolerance(TOLERANCE));
    cheap!("Adams", Adams::tolerance(TOLERANCE));
    cheap!("VCABM", Vcabm::new().tolerance(TOLERANCE));
    cheap!("SDIRK4", Sdirk4::new().tolerance(TOLERANCE));
    cheap!("Auto", Auto::tolerance(TOLERANCE));
    Ok(())
}

/// The wheel of the motor's example, over the whole range: its torque grows, is limited, falls with speed; then it brakes.
#[test]
fn a_motor_that_saturates_keeps_the_order() -> Result<(), Error> {
    let motor = Motor::new(2.0, 6.0).stalling_at(4.0);
    // Limited from 1 s, falls from 2 s, less than its limit is asked for from 3 s; reversed, it brakes with its peak from 4 s.
    let speed = 6.0 - 3.0 * (-2.0_f64 / 3.0).exp();
    let limit = 4.0 * (1.0 - speed / 6.0);
    let wanted = move |time: f64| if time < 2.5 { 2.0 * time } else { 5.0 - (5.0 - limit) * (time - 2.5) / 0.5 };
    let wheel = System::new(Pinned::origin(), RigidBody::new(1.0, 1.0, [0.0; 2], [0.0; 2]), Free)?;
    let loads =
        Loads::none().in_joints(move |time, _, motion: &JointMotion<f64>| motor.torque(wanted(time), motion.rate()));
    // ∫ of what is asked for from 3 s on, up to −2 N·m at 3 s + a, and −2 N·m from then on.
    let slope = (5.0 - limit) / 0.5;
    let a = (limit + 2.0) / slope;
    let exact = speed + limit * a - 0.5 * slope * a * a - 2.0 * (1.0 - a);
    let run = |step: f64| {
        let simulation = wheel.simulation(Dop853::step(step)).loads(&loads).kinks(|now| {
            let [a, b, c, d, e, f] = motor.kinks(wanted(now.time()), now.motion().rates()[0]);
            [a, b, c, d, e, f, now.time() - 2.5] // where what is asked for turns
        });
        Ok::<_, Error>(simulation.run(wheel.motion(), 4.0, |_| ())?.motion.rates()[0])
    };
    for step in [0.37, 0.093] {
        near(run(step)?, exact, if step > 0.2 { 1e-9 } else { 1e-12 });
    }
    let hunting =
        wheel.simulation(Dop853::step(0.093)).loads(&loads).run(wheel.motion(), 4.0, |_| ())?.motion.rates()[0];
    assert!((hunting - exact).abs() > 1e-5);
    Ok(())
}

#[test]
fn several_kinks_within_a_step_are_met_in_turn() -> Result<(), Error> {
    let car = car::<f64>()?;
    let mut times = vec![];
    let marks = [0.9, 0.3, 0.6, 0.301];
    let simulation = car.simulation(Rk4::step(1.0)).kinks(|now| marks.map(|mark| place(now.stepped()) - mark));
    let mut start = start(&car)?;
    start.set_rates(&[0.95])?;
    simulation.run(start, 1.0, |now| times.push(now.time()))?;
    let expected = [0.0, 0.3 / 0.95, 0.301 / 0.95, 0.6 / 0.95, 0.9 / 0.95, 1.0];
    assert_eq!(times.len(), expected.len(), "{times:?}");
    times.iter().zip(expected).for_each(|(time, expected)| near(*time, expected, 1e-12));
    Ok(())
}

#[test]
fn a_run_that_begins_at_a_kink_does_not_meet_that_one() -> Result<(), Error> {
    let car = car::<f64>()?;
    for speed in [SPEED, -SPEED] {
        let (mut start, mut ends) = (start(&car)?, vec![]);
        start.set_coordinates(&[1.0])?;
        start.set_rates(&[speed])?;
        let simulation = car.simulation(Dop853::tolerance(TOLERANCE)).kinks(|now| apart(now.stepped()));
        simulation.run(start, 0.8, |now| ends.push((now.time(), place(now.stepped()))))?;
        let met = ends[1..].iter().filter(|end| (end.1.abs() - 1.0).abs() < 1e-9).count();
        assert_eq!(met, 1, "{ends:?}");
    }
    Ok(())
}

#[test]
fn events_are_seen_beside_kinks_whichever_is_told_first() -> Result<(), Error> {
    let car = car::<f64>()?;
    let expected = [0.5 / SPEED, 1.5 / SPEED + PI / (STIFFNESS / MASS).sqrt()]; // through 0.5 m
    for first in [true, false] {
        let mut times = vec![];
        let mut observe = |now: &catena::simulate::Now<'_, _, _, _, _, _>| {
            if now.is_event() {
                times.push(now.time());
            }
        };
        let simulation = || car.simulation(Vcabm::new().tolerance(TOLERANCE));
        if first {
            let watched = simulation().event(|now| place(now.stepped()) - 0.5).kinks(|now| apart(now.stepped()));
            watched.run(start(&car)?, 1.2, &mut observe)?;
        } else {
            let watched = simulation().kinks(|now| apart(now.stepped())).event(|now| place(now.stepped()) - 0.5);
            watched.run(start(&car)?, 1.2, &mut observe)?;
        }
        assert_eq!(times.len(), 2, "{times:?}");
        times.iter().zip(expected).for_each(|(time, expected)| near(*time, expected, 1e-7));
    }
    Ok(())
}

#[test]
fn a_run_with_kinks_that_is_saved_goes_on_bit_by_bit() -> Result<(), Error> {
    macro_rules! resumed {
        ($rule:expr) => {{
            let car = car::<f64>()?;
            let simulation = || car.simulation($rule).kinks(|now| apart(now.stepped()));
            let whole = simulation().run(start(&car)?, END, |_| ())?;
            for step in 1..whole.steps {
                let mut run = simulation().begin(start(&car)?, END, |_| ())?;
                for _ in 0..step {
                    run.step()?;
                }
                let rest = simulation().resume(run.save(), END, |_| ())?.finish()?;
                assert_eq!((rest.motion, rest.steps), (whole.motion, whole.steps), "after {step} steps");
            }
        }};
    }
    resumed!(Rk4::step(0.1));
    resumed!(Dop853::tolerance(1e-6));
    resumed!(Vcabm::new().tolerance(1e-6));
    resumed!(Adams::tolerance(1e-6));
    Ok(())
}

#[test]
fn in_single_precision_too() -> Result<(), Error> {
    let car = car::<f32>()?;
    let run = car.simulation(Dop853::tolerance(1e-5_f32)).kinks(|now| apart(now.stepped()));
    let end = run.run(start(&car)?, 5.0, |_| ())?.motion;
    near(f64::from(place(&end)), exact(END)[0], 3e-4);
    Ok(())
}

#[test]
fn a_value_that_is_no_number_is_refused() -> Result<(), Error> {
    let car = car::<f64>()?;
    let simulation = car.simulation(Rk4::step(0.1)).kinks(|now| [(0.5 - place(now.stepped())).sqrt()]);
    let refused = simulation.run(start(&car)?, 1.0, |_| ()).map_err(Error::from);
    let fault = Fault::NotFinite { parameter: "value of a function of kinks" };
    assert_eq!(refused.map(|_| ()).map_err(|error| error.fault), Err(fault));
    Ok(())
}

/// A function that jumps, where a step begins and within one: runs go on.
#[test]
fn a_function_that_jumps_ends_a_step_once() -> Result<(), Error> {
    let car = car::<f64>()?;
    for (at, ends) in [(0.5, 11), (0.53, 12)] {
        let mut times = vec![];
        let simulation = car.simulation(Rk4::step(0.125)).kinks(|now| [if now.time() <= at { -1.0 } else { 1.0 }]);
        simulation.run(start(&car)?, 1.25, |now| times.push(now.time()))?;
        assert_eq!(times.len(), ends, "{times:?}");
    }
    let simulation = car.simulation(Dop853::tolerance(1e-6)).kinks(|now| [if now.time() <= 0.5 { -1.0 } else { 1.0 }]);
    assert!(simulation.run(start(&car)?, 1.25, |_| ())?.steps < 60);
    Ok(())
}

/// A payload that falls into a rope: steps far longer than the rope's vibration do not creep up to kinks that dense output of them has in the air.
#[test]
fn a_stiff_rope_is_caught_in_few_steps() -> Result<(), Error> {
    let payload = System::new(Free, RigidBody::new(20.0_f64, 0.7, [0.0; 2], [0.0; 2]), Free)?.with_gravity(9.81);
    let mut start = payload.motion();
    start.set_coordinates(&[1.0, -0.5, 0.0])?;
    start.set_rates(&[0.5, 1.0, 0.0])?;
    for (stiffness, most) in [(1e4, 110), (1e5, 140)] {
        let rope = Strut::to_ground((0, [0.0; 2]), [0.0; 2]).with_stiffness(stiffness).with_length(2.0).pulling();
        let rope = Struts::of([rope]);
        let (mut exact, mut worst) = (None, 0.0_f64);
        for tolerance in [1e-12, 1e-10, 1e-8, 1e-6, 1e-4] {
            let taut = |now: &catena::simulate::Now<'_, _, _, _, _, _>| {
                let place: Vec<f64> = now.stepped().coordinates();
                [place[0].hypot(place[1]) - 2.0]
            };
            let simulation = payload.simulation(Dop853::tolerance(tolerance)).loads(&rope).kinks(taut);
            let run = simulation.run(start, 3.0, |_| ())?;
            assert!(run.steps < most, "{stiffness:e}, {tolerance:e}: {} steps", run.steps);
            let found = run.motion.coordinates()[0];
            worst = worst.max((found - *exact.get_or_insert(found)).abs() / tolerance);
        }
        println!("{stiffness:e}: off by {worst:.0} tolerances at most");
        assert!(worst < 500.0);
    }
    Ok(())
}

/// A function that is zero all along tells of nothing, and one that is no number is refused as such.
#[test]
fn functions_without_a_zero() -> Result<(), Error> {
    let body = RigidBody::new(2.0, 1.0, [0.0; 2], [0.0; 2]);
    let spring = Slider::along(0.0).with(Spring::new(30.0));
    let car = System::new(Clamped::origin(), (spring, body), Free)?;
    let mut start = car.motion();
    start.set_rates(&[3.0])?;
    let simulation = || car.simulation(Dop853::tolerance(1e-9));
    let (plain, still) =
        (simulation().run(start, 5.0, |_| ())?, simulation().kinks(|_| [0.0]).run(start, 5.0, |_| ())?);
    assert_eq!((still.motion, still.steps, still.sweeps), (plain.motion, plain.steps, plain.sweeps));
    for fault in [
        simulation().kinks(|_| [f64::NAN]).run(start, 5.0, |_| ()).expect_err("no number").error,
        car.simulation(Rk4::step(0.1)).kinks(|_| [f64::NAN]).run(start, 5.0, |_| ()).expect_err("no number").error,
    ] {
        assert!(matches!(fault.fault, Fault::NotFinite { .. }) && fault.time == Some(0.0), "{fault}");
    }
    Ok(())
}
