//! Hard stops with modes: a bouncing block against its closed form, a double pendulum that bounces against pieces put together by hand, shocks
//! against dense impulses, orders of rules across shocks, several stops at once, what leaves its stop, what is refused.

use catena::planar::*;
use catena::scalar::Jet;
use catena::simulate::Chosen;
use catena::{Error, Fault, spatial};
use catena_oracle::{Noise, has_order, near};
use std::f64::consts::{FRAC_PI_2, PI};

const GRAVITY: f64 = 9.81; // (m/s²)

/// Height of what falls from 1 m and gives back a share of its speed, after a time.
fn bounced(restitution: f64, mut time: f64) -> f64 {
    let first = (2.0 / GRAVITY).sqrt();
    if time < first {
        return 1.0 - 0.5 * GRAVITY * time * time;
    }
    time -= first;
    let mut speed = restitution * GRAVITY * first;
    while time > 2.0 * speed / GRAVITY && speed > 1e-9 {
        time -= 2.0 * speed / GRAVITY;
        speed *= restitution;
    }
    if speed > 1e-9 { speed * time - 0.5 * GRAVITY * time * time } else { 0.0 }
}

macro_rules! block {
    ($restitution:expr) => {{
        let block = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
        let fall = HardStops::between(Slider::along(FRAC_PI_2), [0.0, f64::INFINITY]).rebounding($restitution);
        System::new(Clamped::origin(), (fall, block), Free)?.with_gravity(GRAVITY)
    }};
}

#[test]
fn a_block_bounces_as_its_closed_form_and_comes_to_rest() -> Result<(), Box<dyn std::error::Error>> {
    let scene = block!(0.7);
    let mut start = scene.motion();
    start.set_coordinates(&[1.0])?;
    macro_rules! heights {
        ($($rule:expr),*) => {$(
            for time in [0.4, 0.9, 1.3, 1.9, 2.1] {
                let run = scene.simulation($rule).run(start, time, |_| ())?;
                let (found, expected) = (run.motion.coordinates()[0], bounced(0.7, time));
                println!("at {time} s: {found:.12} m in {} steps, error {:.1e}", run.steps, found - expected);
                near(found, expected, 1e-9);
            }
        )*};
    }
    heights!(Dop853::tolerance(1e-10), Vcabm::new().tolerance(1e-10), Rk4::step(0.02), Sdirk4::new().tolerance(1e-10));
    heights!(Adams::step(0.01), Auto::tolerance(1e-10), GeneralizedAlpha::new(0.8).step(0.01));
    // All bounces take (1 + 2 e / (1 − e)) times the first fall.
    let whole = (1.0 + 2.0 * 0.7 / 0.3) * (2.0 / GRAVITY).sqrt();
    let (mut energies, mut rested) = (vec![], None);
    let run = scene.simulation(Dop853::tolerance(1e-10)).run(start, whole + 1.0, |now| {
        energies.push(now.energy());
        if rested.is_none() && now.motion().rates()[0] == 0.0 && now.time() > 0.0 {
            rested = Some(now.time());
        }
    })?;
    near(rested.ok_or("it never rests")?, whole, 1.1); // at the end of the step that begins there
    assert!(energies.windows(2).all(|pair| pair[1] <= pair[0] + 1e-12));
    assert_eq!(run.motion.rates(), [0.0]);
    near(run.motion.coordinates()[0], 0.0, 1e-12);
    // The stop bears the weight.
    let end = scene.with_accelerations(run.motion, &Unloaded)?;
    let force = scene.stations(&end, &Unloaded)?.joint(scene.joint(0)?).map_or(f64::NAN, |at| at.internal.force.y);
    near(f64::abs(force), 2.0 * GRAVITY, 1e-12);
    assert_eq!(scene.describe().to_string().matches("HardStops").count(), 1);
    Ok(())
}

#[test]
fn rules_keep_their_order_across_shocks() -> Result<(), Box<dyn std::error::Error>> {
    // On a spring that draws it to 1 m beyond its stop: a cosine between shocks.
    let (mass, stiffness, e, reach) = (2.0, 50.0, 0.8, 0.5);
    let block = RigidBody::new(mass, 0.1, [0.0; 2], [0.0; 2]);
    let law = Spring::new(stiffness).resting_at(-0.2);
    let joint = HardStops::between(Slider::along(0.0), [0.0, f64::INFINITY]).rebounding(e).with(law);
    let scene = System::new(Clamped::origin(), (joint, block), Free)?;
    let mut start = scene.motion();
    start.set_coordinates(&[reach])?;
    let w = f64::sqrt(stiffness / mass);
    // x + 0.2 = a cos(wt − φ); speed at the stop √(a² − 0.04) w.
    let (mut amplitude, mut at): (f64, f64) = (reach + 0.2, 0.0);
    at += (0.2 / amplitude).acos() / w;
    for _ in 0..2 {
        let speed = e * (amplitude * amplitude - 0.04).sqrt();
        amplitude = (speed * speed + 0.04).sqrt();
        at += 2.0 * (0.2 / amplitude).acos() / w;
    }
    let speed = e * (amplitude * amplitude - 0.04).sqrt();
    amplitude = (speed * speed + 0.04).sqrt();
    let later = 0.8 * (0.2 / amplitude).acos() / w;
    let (time, expected) = (at + later, amplitude * (w * later - (0.2 / amplitude).acos()).cos() - 0.2);
    macro_rules! errors {
        ($name:expr, $order:expr, [$($count:expr),*], |$step:ident| $rule:expr) => {{
            let points = [$({
                let $step = time / $count;
                let end = scene.simulation($rule).run(start, time, |_| ())?.motion;
                ($step, (end.coordinates()[0] - expected).abs())
            }),*];
            has_order($name, $order, 1e-15, &points);
        }};
    }
    errors!("RK4", 4.0, [80.0, 160.0, 320.0, 640.0], |h| Rk4::step(h));
    errors!("DOP853", 8.0, [20.0, 28.0, 40.0], |h| Dop853::step(h));
    errors!("SDIRK4", 4.0, [80.0, 160.0, 320.0, 640.0], |h| Sdirk4::new().step(h));
    errors!("generalised α", 2.0, [400.0, 800.0, 1600.0], |h| GeneralizedAlpha::new(0.8).step(h));
    Ok(())
}

/// The mass matrix of two rods of length and mass one on pins, by their absolute angles.
fn masses(angles: [f64; 2]) -> [[f64; 2]; 2] {
    let mixed = 0.5 * (angles[0] - angles[1]).cos();
    [[4.0 / 3.0, mixed], [mixed, 1.0 / 3.0]]
}

#[test]
fn a_double_pendulum_bounces_as_pieces_put_together() -> Result<(), Box<dyn std::error::Error>> {
    // The elbow goes no farther than a stretched arm and a right angle, and gives back 0.8.
    let (rod, e) = (Rod::uniform(1.0, 1.0), 0.8);
    let elbow = HardStops::between(Revolute::smooth(), [0.0, FRAC_PI_2]).rebounding(e);
    let whole = System::new(Pinned::origin(), (rod, elbow, rod), Free)?.with_gravity(GRAVITY);
    let plain = System::new(Pinned::origin(), (rod, Revolute::smooth(), rod), Free)?.with_gravity(GRAVITY);
    let rule = || Dop853::tolerance(1e-12);
    let end = 2.0;
    let run = whole.simulation(rule()).run(whole.at_rest(&[-0.2, 0.7])?, end, |_| ())?;
    // By hand: run to each touch, and turn rates there by a dense impulse.
    let (mut now, mut touches) = (plain.at_rest(&[-0.2, 0.7])?, 0);
    loop {
        let range = |q: f64| q.min(FRAC_PI_2 - q);
        let touch = plain.simulation(rule()).event(|now| range(now.motion().coordinates()[1])).stopping();
        let stopped = touch.run(now, end, |_| ())?.motion;
        if stopped.time() >= end {
            now = stopped;
            break;
        }
        let (q, v) = (stopped.coordinates(), stopped.rates());
        let m = masses([q[0], q[0] + q[1]]);
        // Rates of absolute angles; an impulse p in the elbow: M Δω = (−p, p).
        let inverse = 1.0 / (m[0][0] * m[1][1] - m[0][1] * m[1][0]);
        let unit = [(-m[1][1] - m[0][1]) * inverse, (m[1][0] + m[0][0]) * inverse];
        let impulse = -(1.0 + e) * v[1] / (unit[1] - unit[0]);
        let after = plain.with_rates(stopped, &[v[0] + impulse * unit[0], -e * v[1]])?;
        println!("at {:.4} s: {:?} becomes {:?}", stopped.time(), v, after.rates());
        // Away from the zero of the event.
        now = plain.simulation(rule()).run(after, stopped.time() + 2e-3, |_| ())?.motion;
        assert!(range(now.coordinates()[1]) > 0.0);
        touches += 1;
    }
    println!("{touches} touches, {} steps", run.steps);
    assert!(touches >= 4);
    for k in 0..2 {
        near(run.motion.coordinates()[k], now.coordinates()[k], 1e-9);
        near(run.motion.rates()[k], now.rates()[k], 1e-8);
    }
    Ok(())
}

#[test]
fn a_shock_in_a_loop_and_in_space_is_that_of_multipliers() -> Result<(), Box<dyn std::error::Error>> {
    // A four-bar whose crank strikes a stop: the loop leaves one freedom, so all rates are those before times −e.
    let crank = HardStops::between(Revolute::smooth(), [-3.0, 1.4]).rebounding(0.5);
    let chain = (crank, Rod::uniform(0.3, 1.0), Pin, Rod::uniform(0.8, 1.5), Pin, Rod::uniform(0.6, 1.0));
    let scene = System::new(Clamped::origin(), chain, Pinned::at(0.9, 0.0))?.with_gravity(GRAVITY);
    let start = scene.assembled(scene.with_rates(scene.at_rest(&[1.0, -0.1, -2.0])?, &[5.0, 0.0, 0.0])?, &Unloaded)?;
    let (mut before, mut energies): (Option<Vec<f64>>, _) = (None, vec![]);
    scene.simulation(Dop853::tolerance(1e-11)).run(start, 0.5, |now| {
        energies.push(now.energy());
        let [q, v] = [now.motion().coordinates(), now.motion().rates()];
        if f64::abs(q[0] - 1.4) < 1e-10 && v[0] > 0.0 {
            before = Some(v);
        }
    })?;
    let before = before.ok_or("it never strikes")?;
    assert!(before[0] > 1.0);
    let struck = scene.simulation(Dop853::tolerance(1e-11));
    let mut running = struck.begin(start, 0.5, |_| ())?;
    while running.motion().rates()[0] > 0.0 {
        assert!(running.step()?);
    }
    running.motion().rates().iter().zip(&before).for_each(|(after, before)| near(*after, -0.5 * before, 1e-9));
    let drops = energies.windows(2).filter(|pair| pair[1] < pair[0] - 1e-6).count();
    println!("{drops} shocks in 0.5 s");
    // Two bars in space on crossed axes: momentum of the free hinge about its axis is kept by a shock in the other.
    let bar = spatial::Rod::uniform(0.5, 0.05, 1.0);
    let knee = HardStops::between(spatial::Revolute::about([0.0, 1.0, 0.0]), [-0.5, 0.5]).rebounding(1.0);
    let chain = (spatial::Revolute::about([0.0, 0.0, 1.0]), bar, knee, bar);
    let scene = spatial::System::new(spatial::Clamped::origin(), chain, spatial::Free)?;
    let start = scene.with_rates(scene.motion(), &[2.0, 3.0])?;
    let (mut momenta, mut energies, mut turns) = (vec![], vec![], 0);
    let mut last = 3.0;
    scene.simulation(Dop853::tolerance(1e-12)).run(start, 2.0, |now| {
        momenta.push(now.budget().angular_momentum.z);
        energies.push(now.energy());
        let rate = now.motion().rates()[1];
        turns += usize::from(rate * last < 0.0);
        last = rate;
    })?;
    assert!(turns >= 4, "{turns}");
    momenta.iter().for_each(|x| near(*x, momenta[0], 1e-10));
    energies.iter().for_each(|x| near(*x, energies[0], 1e-10));
    Ok(())
}

#[test]
fn a_cradle_of_blocks_hands_its_shock_on_and_stacks_rest() -> Result<(), Box<dyn std::error::Error>> {
    // Three blocks on one track, each at least 0.2 m from the one before it: the coordinate of a joint is that distance.
    let block = RigidBody::new(1.0, 0.1, [0.0; 2], [0.0; 2]);
    let gap = |e: f64| HardStops::between(Slider::along(0.0), [0.2, f64::INFINITY]).rebounding(e);
    let cradle = System::new(Clamped::origin(), (Slider::along(0.0), block, gap(1.0), block, gap(1.0), block), Free)?;
    let mut start = cradle.motion();
    start.set_coordinates(&[0.0, 0.5, 0.2])?;
    let start = cradle.with_rates(start, &[1.0, -1.0, 0.0])?; // the first moves, the others rest and touch
    let end = cradle.simulation(Dop853::tolerance(1e-10)).run(start, 1.0, |_| ())?.motion;
    // After 0.3 s the first stands and the last moves.
    let places = [0.3, 0.2, 0.2 + 0.7];
    end.coordinates().iter().zip(places).for_each(|(found, expected)| near(*found, expected, 1e-10));
    end.rates().iter().zip([0.0, 0.0, 1.0]).for_each(|(found, expected)| near(*found, expected, 1e-10));
    // A stack falls, and lies.
    let lies = |e: f64| HardStops::between(Slider::along(0.0), [0.2, f64::INFINITY]).rebounding(e);
    let chain = (lies(0.3), block, lies(0.3), block, lies(0.3), block);
    let stack = System::new(Clamped::at(0.0, 0.0, FRAC_PI_2), chain, Free)?.with_gravity(GRAVITY);
    let mut start = stack.motion();
    start.set_coordinates(&[0.7, 0.3, 0.4])?;
    let mut energies = vec![];
    let run = stack.simulation(Dop853::tolerance(1e-9)).run(start, 6.0, |now| energies.push(now.energy()))?;
    println!("a stack at rest after {} steps", run.steps);
    assert!(energies.windows(2).all(|pair| pair[1] <= pair[0] + 1e-9));
    assert_eq!(run.motion.rates(), [0.0; 3]);
    run.motion.coordinates().iter().for_each(|place| near(*place, 0.2, 1e-11));
    Ok(())
}

#[test]
fn what_rests_leaves_its_stop_where_that_no_longer_pushes() -> Result<(), Box<dyn std::error::Error>> {
    // A block of 2 kg on a plate that is drawn up by 30 sin(πt) N: it leaves where that is its weight.
    let scene = block!(0.0);
    let loads =
        Loads::none().in_joints(|t, joint, _: &JointMotion<f64>| if joint == 1 { 30.0 * (PI * t).sin() } else { 0.0 });
    let away = (2.0 * GRAVITY / 30.0_f64).asin() / PI;
    let rate = |t: f64| 15.0 / PI * ((PI * away).cos() - (PI * t).cos()) - GRAVITY * (t - away);
    let place = |t: f64| {
        15.0 / PI * ((PI * away).cos() * (t - away) - ((PI * t).sin() - (PI * away).sin()) / PI)
            - 0.5 * GRAVITY * (t - away).powi(2)
    };
    macro_rules! lifted {
        ($($rule:expr),*) => {$(
            let end = scene.simulation($rule).loads(&loads).run(scene.motion(), 0.8, |_| ())?.motion;
            near(end.coordinates()[0], place(0.8), 1e-8);
            near(end.rates()[0], rate(0.8), 1e-7);
        )*};
    }
    lifted!(Dop853::tolerance(1e-10), Vcabm::new().tolerance(1e-11), Sdirk4::new().tolerance(1e-10), Rk4::step(0.005));
    // It falls back, and rests; a saved run goes on bit by bit.
    let simulation = || scene.simulation(Dop853::tolerance(1e-10)).loads(&loads);
    let whole = simulation().run(scene.motion(), 1.9, |_| ())?;
    assert_eq!((whole.motion.rates(), whole.motion.coordinates()[0].abs() < 1e-12), (vec![0.0], true));
    let mut run = simulation().begin(scene.motion(), 1.9, |_| ())?;
    run.until(0.7)?;
    let resumed = simulation().resume(run.save(), 1.9, |_| ())?.finish()?;
    assert_eq!((resumed.motion, resumed.steps), (whole.motion, whole.steps));
    // Without weight it stays where it touches, and leaves where it is pushed.
    let weightless = block!(0.0).with_gravity(0.0);
    let run = weightless.simulation(Dop853::tolerance(1e-9)).run(weightless.motion(), 5.0, |_| ())?;
    assert_eq!(run.motion.coordinates(), [0.0]);
    let start = weightless.with_rates(weightless.motion(), &[0.5])?;
    near(weightless.simulation(Dop853::tolerance(1e-9)).run(start, 2.0, |_| ())?.motion.coordinates()[0], 1.0, 1e-12);
    Ok(())
}

#[test]
fn shocks_go_over_friction() -> Result<(), Box<dyn std::error::Error>> {
    // A sleigh of 1 kg that sticks, and in it a block of 2 kg at 3 m/s that strikes its front wall and stays there: both at 2 m/s.
    let sleigh = RigidBody::new(1.0, 0.1, [0.0; 2], [0.0; 2]);
    let block = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
    let rubs = Coulomb::new(Slider::along(0.0), 6.0).breaking_away(8.0);
    let inside = HardStops::between(Slider::along(0.0), [-0.6, 0.6]);
    let scene = System::new(Clamped::origin(), (rubs, sleigh, inside, block), Free)?;
    let start = scene.with_rates(scene.motion(), &[0.0, 3.0])?;
    let end = scene.simulation(Dop853::tolerance(1e-10)).run(start, 0.3, |_| ())?.motion;
    // From 0.2 s on the sleigh is braked by 6 N and the block goes on at 2 m/s: it stays at the wall, which decelerates less.
    near(end.rates()[0], 2.0 - 0.1 * 2.0, 1e-9);
    near(end.coordinates()[1], 0.6, 1e-11);
    let end = scene.simulation(Dop853::tolerance(1e-10)).run(start, 3.0, |_| ())?.motion;
    assert_eq!(end.rates(), [0.0; 2]);
    near(end.coordinates()[0], 1.0, 1e-9); // v²/2a = 4 / (2 · 2)
    Ok(())
}

#[test]
fn a_step_that_a_shock_cuts_is_by_the_rule_that_made_it() -> Result<(), Box<dyn std::error::Error>> {
    // A stiff damped hinge brings the implicit rule on trial, and the first step of that ends at a stop.
    let rod = Rod::uniform(0.5, 1.0);
    let stiff = ElasticHinge::with(Spring::new(1e5).damped(20.0));
    let knee = HardStops::between(Revolute::smooth(), [-1.0, 1e-5]).rebounding(0.5);
    let scene = System::new(Clamped::origin(), (stiff, rod, knee, rod), Free)?;
    let start = scene.with_rates(scene.motion(), &[0.0, 1.0])?;
    let mut run = scene.simulation(Auto::tolerance(1e-3)).begin(start, 0.1, |_| ())?;
    assert!(run.step()?);
    assert!(run.motion().rates()[1] < 0.0, "the first step ends at the stop");
    near(run.motion().coordinates()[1], 1e-5, 1e-12);
    assert_eq!(run.stepper().chosen(), Chosen::Sdirk4);
    Ok(())
}

#[test]
fn long_falls_end_at_their_stop() -> Result<(), Box<dyn std::error::Error>> {
    let scene = block!(0.5);
    for number in 0..60 {
        let height = 300.0 * 1.1_f64.powi(number);
        let (mut start, first) = (scene.motion(), (2.0 * height / GRAVITY).sqrt());
        start.set_coordinates(&[height])?;
        let end = scene.simulation(Dop853::tolerance(1e-9)).run(start, 1.5 * first, |_| ())?.motion;
        near(end.coordinates()[0] / height, 0.25, 1e-9);
    }
    Ok(())
}

#[test]
fn what_makes_no_run_with_stops_is_refused() -> Result<(), Error> {
    let body = RigidBody::new(1.0, 0.1, [0.0; 2], [0.0; 2]);
    let between = |range: [f64; 2]| HardStops::between(Slider::along(0.0), range);
    for (joint, parameter) in [
        (between([1.0, 0.0]), "range between hard stops"),
        (between([0.0, f64::NAN]), "hard stop"),
        (between([0.0, 1.0]).rebounding(1.5), "restitution"),
        (between([0.0, 1.0]).rebounding(-0.5), "restitution"),
    ] {
        let fault = System::new(Clamped::origin(), (joint, body), Free).map(|_| ()).map_err(|error| error.fault);
        let named = match fault {
            Err(
                Fault::OutOfRange { parameter, .. }
                | Fault::NotFinite { parameter }
                | Fault::NotPositive { parameter, .. }
                | Fault::Negative { parameter, .. },
            ) => parameter,
            _ => "accepted",
        };
        assert_eq!(named, parameter);
    }
    // A start beyond a stop.
    let scene = System::new(Clamped::origin(), (between([0.0, 1.0]), body), Free)?;
    let mut start = scene.motion();
    start.set_coordinates(&[1.25])?;
    let refused = scene.simulation(Rk4::step(0.1)).run(start, 1.0, |_| ()).map(|_| ()).map_err(|end| end.error.fault);
    assert!(matches!(refused, Err(Fault::OutOfRange { value: 0.25, most: 0.0, .. })), "{refused:?}");
    // Also where a run goes on from there.
    let mut run = scene.simulation(Rk4::step(0.1)).begin(scene.motion(), 1.0, |_| ())?;
    run.until(0.5)?;
    let mut moved = run.save();
    moved.motion.set_coordinates(&[1.25])?;
    moved.motion.set_rates(&[-1.0])?;
    let refused =
        scene.simulation(Rk4::step(0.1)).resume(moved, 1.0, |_| ()).map(|_| ()).map_err(|end| end.error.fault);
    assert!(matches!(refused, Err(Fault::OutOfRange { value: 0.25, most: 0.0, .. })), "{refused:?}");
    // Steps by hand past one.
    let mut now = scene.with_rates(scene.motion(), &[4.0])?;
    let (mut stepper, mut next, mut refused) = (scene.stepper(Rk4), now, None);
    for _ in 0..10 {
        match stepper.step(&now, &Unloaded, 0.1, &mut next) {
            Ok(()) => core::mem::swap(&mut now, &mut next),
            Err(error) => refused = Some(error.fault),
        }
    }
    assert!(
        matches!(refused, Some(Fault::Unsupported { what }) if what.contains("beyond its hard stop")),
        "{refused:?}"
    );
    // Derivatives in steps that change modes within, equilibria.
    let one = Jet::<f64, 1>::seed(1.0, 0);
    let stop = HardStops::between(Slider::along(Jet::of(0.0)), [Jet::of(0.0), one]);
    let body = RigidBody::new(one, one, [Jet::of(0.0); 2], [Jet::of(0.0); 2]);
    let jets = System::new(Clamped::origin(), (stop, body), Free)?;
    let refused = jets
        .simulation(MoreauJean::step(0.1))
        .run(jets.motion(), 1.0, |_| ())
        .map(|_| ())
        .map_err(|end| end.error.fault);
    assert!(matches!(refused, Err(Fault::Unsupported { what }) if what.contains("derivatives")));
    let rest = scene.equilibrium(scene.motion(), &Unloaded).map(|_| ()).map_err(|error| error.fault);
    assert!(matches!(rest, Err(Fault::Unsupported { .. })));
    Ok(())
}

#[test]
fn random_arms_between_stops_never_gain_energy_nor_leave_their_ranges() -> Result<(), Box<dyn std::error::Error>> {
    let mut random = Noise::new(20);
    let (mut steps, mut resting) = (0, 0);
    for number in 0..40 {
        let mut knee = |least: f64| {
            let range = [random.between(-1.5, -least), random.between(least, 1.5)];
            let restitution = if random.between(0.0, 1.0) < 0.3 { 0.0 } else { random.between(0.0, 0.95) };
            (range, HardStops::between(Revolute::smooth(), range).rebounding(restitution))
        };
        let [one, two, three] = [knee(0.1), knee(0.1), knee(0.1)];
        let rod = Rod::uniform(0.5, 1.0);
        let scene = System::new(Clamped::origin(), (one.1, rod, two.1, rod, three.1, rod), Free)?.with_gravity(GRAVITY);
        let rates = [random.between(-3.0, 3.0), random.between(-3.0, 3.0), random.between(-3.0, 3.0)];
        let start = scene.with_rates(scene.motion(), &rates)?;
        let (mut last, mut seen, mut shown) = (scene.budget(&start)?.energy(), Ok(()), 0);
        let run = scene.simulation(Dop853::tolerance(1e-9)).run(start, 4.0, |now| {
            let inside = now
                .motion()
                .coordinates()
                .iter()
                .zip([one.0, two.0, three.0])
                .all(|(q, [lower, upper])| (lower - 1e-9..=upper + 1e-9).contains(q));
            let energy = now.energy();
            shown += 1;
            assert!(shown < 20_000, "scene {number} hardly advances at {} s", now.time());
            if seen.is_ok() && (!inside || energy > last + 1e-7) {
                seen = Err(format!(
                    "scene {number} at {} s: {:?}, {last} J, {energy} J",
                    now.time(),
                    now.motion().coordinates()
                ));
            }
            last = energy;
        });
        seen?;
        let run = run.map_err(|end| format!("scene {number}: {} after {:?}", end.error, end.last.time()))?;
        steps += run.steps;
        resting += run.motion.rates().iter().filter(|rate| **rate == 0.0).count();
    }
    println!("{steps} steps; {resting} of 120 joints rest");
    assert!(resting > 40);
    Ok(())
}

/// A chain of rods (length, mass) between stops that give nothing back, all but the last at the lower ones, which the last strikes.
fn struck(rods: &[[f64; 2]], rate: f64) -> Result<Run, Error> {
    let link =
        |[length, mass]: &[f64; 2]| (HardStops::between(Revolute::smooth(), [-0.3, 0.5]), Rod::uniform(*length, *mass));
    let chain = System::new(Clamped::origin(), rods.iter().map(link).collect::<Vec<_>>(), Free)?;
    let (mut start, count) = (chain.motion(), rods.len());
    let (mut places, mut rates) = (vec![-0.3; count], vec![0.0; count]);
    (places[count - 1], rates[count - 1]) = (0.0, rate);
    start.set_coordinates(&places)?;
    let start = chain.with_rates(start, &rates)?;
    let (mut energy, mut last) = (vec![], f64::INFINITY);
    let run = chain.simulation(Dop853::tolerance(1e-9)).run(start, 0.3, |now| {
        energy.push(now.energy() <= last * (1.0 + 1e-9));
        last = now.energy();
    })?;
    Ok(Run { rates: run.motion.rates(), places: run.motion.coordinates(), falls: energy.iter().all(|x| *x) })
}

/// Where a run ends, and whether energy has fallen.
struct Run {
    rates: Vec<f64>,
    places: Vec<f64>,
    falls: bool,
}

/// Blows one after another converge as the ratio of lengths allows: by 256 of them what a long rod does to a short one is not over.
#[test]
fn shocks_that_go_on_and_on_bring_to_rest_at_once() -> Result<(), Error> {
    let short = [0.1, 1.0];
    for ratio in [1.0, 5.0, 10.0, 20.0, 50.0, 200.0] {
        let long = [0.1 * ratio, 1.0];
        for rods in [&[short, long][..], &[short, short, long], &[short, long, short, long]] {
            let run = struck(rods, -10.0)?;
            println!("{ratio} times as long, {} joints: {:?}", rods.len(), run.rates);
            assert!(run.rates.iter().all(|rate| *rate == 0.0), "{:?}", run.rates);
            assert!(run.places.iter().all(|place| (place + 0.3).abs() < 1e-13) && run.falls);
        }
    }
    for count in [4, 5, 6, 8] {
        let run = struck(&vec![[0.2, 1.0]; count], -10.0)?;
        assert!(run.rates.iter().all(|rate| *rate == 0.0) && run.falls, "{count} joints: {:?}", run.rates);
    }
    // Of more joints 256 blows throw some off their stops.
    assert!(struck(&[[0.2, 1.0]; 12], -10.0)?.falls);
    // Upward it throws the chain off its stops, and strikes others.
    let run = struck(&[short, [1.0, 1.0], short], 30.0)?;
    assert!(run.falls && run.places.iter().all(|place| (-0.3 - 1e-13..=0.5 + 1e-13).contains(place)));
    Ok(())
}

/// A joint that slips the faint way it was let go is turned round within a step, back again by its end: it had been beyond its stop.
#[test]
fn what_turns_round_twice_within_a_step_is_seen() -> Result<(), Error> {
    let joint = |[sliding, breaking, restitution]: [f64; 3], range: [f64; 2]| {
        Coulomb::new(Revolute::smooth(), sliding).breaking_away(breaking).between(range).rebounding(restitution)
    };
    const UPPER: f64 = 0.1359349497431922;
    let chain = (
        joint([1.4084175093031963, 1.8597198900565746, 0.2574707094085479], [-0.7305595850800726, 0.8027246735846666]),
        Rod::uniform(0.22253382309187744, 1.6824986688880312),
        joint([0.31010755767886167, 1.863410484415524, 0.8878601479244156], [-0.4382183374737516, 0.309285135512942]),
        Rod::uniform(0.13657367870755252, 0.39419659623548703),
        joint(
            [0.4073524274202677, 1.7600191742795868, 0.36485690648357316],
            [-0.5464863837254813, 0.13014476018777446],
        ),
        Rod::uniform(0.2548947442122079, 1.5929945840732083),
        joint([0.6425340703530664, 1.7441952483307928, 0.04565570164803231], [-0.10984252754218807, UPPER]),
        Rod::uniform(0.22311437760485012, 1.1169068825635902),
    );
    let arm = System::new(Clamped::origin(), chain, Free)?.with_gravity(GRAVITY);
    let mut start = arm.motion();
    start.set_coordinates(&[0.22008621605920375, -0.09077951459304173, -0.4978035260352621, 0.06705046396516517])?;
    let rates = [-3.212489449054986, -2.265082787448538, -1.686914030231319, 0.569783075901249];
    let start = arm.with_rates(start, &rates)?;
    for tolerance in [1e-6, 1e-7, 1e-8, 1e-9] {
        let mut beyond = f64::NEG_INFINITY;
        arm.simulate(start, Dop853::tolerance(tolerance), 0.2, |now| {
            beyond = beyond.max(now.motion().coordinates()[3] - UPPER);
        })?;
        assert!(beyond < 1e-13, "{tolerance:e}: {beyond:e}");
    }
    Ok(())
}
