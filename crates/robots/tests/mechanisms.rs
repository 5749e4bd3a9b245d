//! Mechanisms that a driven crank leads, at constant speed: a slider-crank and a four-bar against their closed forms.

use catena::planar::*;

const CRANK: f64 = 0.3; // (m)
const CONROD: f64 = 0.8; // (m)
const MASSES: [f64; 3] = [1.0, 1.5, 2.0]; // crank, connecting rod, piston (kg)
const RATE: f64 = 7.0; // of the crank (rad/s)

/// Kinetic energy of a slider-crank over ½ ω², a function of the crank's angle: by the velocities of mass centres for ω = 1.
fn inertia(angle: f64) -> f64 {
    let (s, c) = angle.sin_cos();
    let (sine, span) = (CRANK * s / CONROD, (CONROD * CONROD - CRANK * CRANK * s * s).sqrt());
    let turning = -CRANK * c / span; // of the connecting rod, whose angle is −asin(sine)
    let piston = -CRANK * s + CONROD * sine * turning;
    let centre = [-CRANK * s + 0.5 * CONROD * sine * turning, CRANK * c + 0.5 * span * turning];
    MASSES[0] * CRANK * CRANK / 3.0
        + MASSES[1] * (centre[0] * centre[0] + centre[1] * centre[1] + CONROD * CONROD / 12.0 * turning * turning)
        + MASSES[2] * piston * piston
}

#[test]
fn a_slider_crank_at_constant_speed_is_its_closed_form() -> Result<(), Box<dyn std::error::Error>> {
    let crank = Driven::new(Revolute::smooth(), |time: f64| [RATE * time, RATE, 0.0]).named("crank");
    let piston = RigidBody::new(MASSES[2], 0.02, [0.0; 2], [0.0; 2]);
    let chain = (crank, Rod::uniform(CRANK, MASSES[0]), Pin, Rod::uniform(CONROD, MASSES[1]), Pin, piston);
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Guided::at(0.0, 0.0, 0.0))?;
    let joint = scene.joint("crank")?;
    let start = scene.with_rates(scene.at_rest(&[0.0, 0.0])?, &[-RATE * CRANK / CONROD, 0.0])?;
    let (mut places, mut torques, mut seen) = (0.0_f64, 0.0_f64, 0);
    scene.simulation(Dop853::tolerance(1e-11)).every(0.01).run(start, 2.0, |now| {
        let angle = RATE * now.time();
        let (s, c) = angle.sin_cos();
        let place = CRANK * c + (CONROD * CONROD - CRANK * CRANK * s * s).sqrt();
        let h = 1e-3;
        let slope = (8.0 * (inertia(angle + h) - inertia(angle - h)) - inertia(angle + 2.0 * h)
            + inertia(angle - 2.0 * h))
            / (12.0 * h);
        let stations = now.stations();
        let torque = stations.joint(joint).map_or(f64::NAN, |station| -station.internal.torque);
        let found = now.bodies().get(2).map_or(f64::NAN, |body| body.inboard.place.x);
        places = places.max((found - place).abs());
        torques = torques.max((torque - 0.5 * RATE * RATE * slope).abs());
        seen += 1;
    })?;
    println!(
        "slider-crank: place to {places:.1e} m, torque to {torques:.1e} N·m of {:.0}",
        MASSES[2] * RATE * RATE * CRANK * CRANK
    );
    assert!(seen == 201 && places < 1e-12 && torques < 1e-8);
    Ok(())
}

const BARS: [f64; 4] = [0.2, 0.5, 0.4, 0.55]; // crank, coupler, rocker, ground (m), of as many kilogrammes

/// Angles of coupler and rocker of a four-bar whose crank has an angle: where two circles meet, above.
fn four_bar(crank: f64) -> [f64; 2] {
    let [a, b, c, d] = BARS;
    let (x, y) = (a * crank.cos() - d, a * crank.sin()); // from the rocker's pin to the crank's end
    let far = x.hypot(y);
    let rocker = y.atan2(x) - ((far * far + c * c - b * b) / (2.0 * far * c)).acos();
    [(c * rocker.sin() - y).atan2(c * rocker.cos() - x), rocker]
}

/// Slope by differences of fourth order.
fn slope_of(f: &dyn Fn(f64) -> f64, at: f64, h: f64) -> f64 {
    (8.0 * (f(at + h) - f(at - h)) - f(at + 2.0 * h) + f(at - 2.0 * h)) / (12.0 * h)
}

/// Inertia of the four-bar, as of the slider-crank, and its energy of place.
fn four_bar_energies(crank: f64) -> [f64; 2] {
    let [a, b, c, d] = BARS;
    let centres: [&dyn Fn(f64) -> [f64; 3]; 3] = [
        &|at| [0.5 * a * at.cos(), 0.5 * a * at.sin(), at],
        &|at| {
            let coupler = four_bar(at)[0];
            [a * at.cos() + 0.5 * b * coupler.cos(), a * at.sin() + 0.5 * b * coupler.sin(), coupler]
        },
        &|at| {
            let rocker = four_bar(at)[1];
            [d + 0.5 * c * rocker.cos(), 0.5 * c * rocker.sin(), rocker]
        },
    ];
    let (mut inertia, mut place) = (0.0, 0.0);
    for (centre, mass) in centres.into_iter().zip(BARS) {
        let [x, y, turn] = [0, 1, 2].map(|k| slope_of(&|at| centre(at)[k], crank, 1e-3));
        inertia += mass * (x * x + y * y + mass * mass / 12.0 * turn * turn); // as long as heavy
        place += 9.81 * mass * centre(crank)[1];
    }
    [inertia, place]
}

#[test]
fn a_driven_crank_leads_a_loop() -> Result<(), Box<dyn std::error::Error>> {
    let [crank, coupler, rocker, ground] = BARS;
    let rod = |length: f64| Rod::uniform(length, length);
    let drive = Driven::new(Revolute::smooth(), |time: f64| [0.4 + RATE * time, RATE, 0.0]).named("crank");
    let main = (drive, rod(crank), Pin, rod(coupler));
    let side = (RigidBody::massless([ground, 0.0]), Pin, rod(rocker));
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), Network::new(main, side, Pin), Free)?.with_gravity(9.81);
    let angles = |time: f64| four_bar(0.4 + RATE * time);
    let rates = [0, 1].map(|k| slope_of(&|time| angles(time)[k], 0.0, 1e-4));
    let start = scene.with_rates(scene.at_rest(&angles(0.0))?, &rates)?;
    let joint = scene.joint("crank")?;
    let (mut places, mut torques) = (0.0_f64, 0.0_f64);
    scene.simulation(Dop853::tolerance(1e-11)).every(0.05).run(start, 2.0, |now| {
        let (angle, found) = (0.4 + RATE * now.time(), now.motion().coordinates());
        for (found, expected) in found.iter().zip(four_bar(angle)) {
            places = places.max((found.sin() - expected.sin()).abs().max((found.cos() - expected.cos()).abs()));
        }
        let [inertia, weight] = [0, 1].map(|k| slope_of(&|at| four_bar_energies(at)[k], angle, 2e-3));
        let torque = now.stations().joint(joint).map_or(f64::NAN, |station| -station.internal.torque);
        torques = torques.max((torque - 0.5 * RATE * RATE * inertia - weight).abs());
    })?;
    println!("four-bar: angles to {places:.1e}, torque to {torques:.1e} N·m");
    assert!(places < 1e-9 && torques < 1e-6);
    Ok(())
}

/// A crank-rocker whose crank goes as a function of time says, with friction in the other pins: what the drive does is what energy gains and
/// friction takes, and pins turn round, which leaves nothing to stick.
#[test]
fn friction_turns_round_with_the_pins_of_a_driven_mechanism() -> Result<(), Box<dyn std::error::Error>> {
    const FRICTION: f64 = 0.3;
    let bar = |length: f64| Rod::uniform(length, 2.0 * length);
    macro_rules! balance {
        ($name:literal, $law:expr, $rule:expr, $small:expr) => {{
            let law = $law;
            let pin = || Coulomb::new(Revolute::smooth(), FRICTION);
            let chain = (Driven::new(Revolute::smooth(), law), bar(0.2), pin(), bar(0.7), pin(), bar(0.5));
            let scene = System::new(Clamped::origin(), chain, Pinned::at(0.8, 0.0))?.with_gravity(9.81);
            let start = scene.assembled(scene.at_rest(&[0.7, -1.5])?, &Unloaded)?;
            let (mut work, mut last, mut energies, mut turns) = (0.0, None, vec![], [0; 2]);
            let mut signs = [0.0_f64; 2];
            let run = scene.simulation($rule).every(1e-4).run(start, 2.0, |now| {
                let turn: Vec<f64> = now.bodies().iter().map(|body| body.inboard.turn.rate).collect();
                let rates = [turn[1] - turn[0], turn[2] - turn[1]];
                for (k, rate) in rates.into_iter().enumerate() {
                    turns[k] += usize::from(rate * signs[k] < 0.0);
                    signs[k] = if rate == 0.0 { signs[k] } else { rate };
                }
                let torque = now.stations().get(0).map_or(f64::NAN, |station| -station.internal.torque);
                let power = torque * turn[0] - FRICTION * (rates[0].abs() + rates[1].abs());
                if let Some((time, before)) = last {
                    work += 0.5 * (power + before) * (now.time() - time);
                }
                last = Some((now.time(), power));
                energies.push(now.energy());
            })?;
            let gained = energies[energies.len() - 1] - energies[0];
            println!("{}: {} steps, turns {turns:?}, work {work:.7}, gained {gained:.7}", $name, run.steps);
            assert!((work - gained).abs() < $small && turns.iter().any(|turns| *turns > 0));
            run.motion.coordinates()
        }};
    }
    let steady = |t: f64| [0.5 + 4.0 * t, 4.0, 0.0];
    let from_rest = |t: f64| [1.5 - (3.0 * t).cos(), 3.0 * (3.0 * t).sin(), 9.0 * (3.0 * t).cos()];
    let ends = [
        balance!("steady", steady, Dop853::tolerance(1e-10), 1e-6),
        balance!("steady, SDIRK4", steady, Sdirk4::new().tolerance(1e-8), 1e-6),
        balance!("steady, Moreau and Jean", steady, MoreauJean::step(1e-4), 1e-3),
    ];
    let others = [
        balance!("from rest", from_rest, Dop853::tolerance(1e-10), 1e-6),
        balance!("from rest, Moreau and Jean", from_rest, MoreauJean::step(1e-4), 1e-3),
    ];
    for ends in [&ends[..], &others] {
        for end in ends {
            assert!(end.iter().zip(&ends[0]).all(|(a, b)| (a - b).abs() < 1e-7), "{end:?}");
        }
    }
    Ok(())
}

/// A loop of one freedom with a stop in one joint and friction in another: where the one rests the other one is held, too, whichever way it slips.
#[test]
fn a_loop_rests_at_the_stop_of_one_joint_with_friction_in_another() -> Result<(), Box<dyn std::error::Error>> {
    let (bar, pin) = (|length: f64| Rod::uniform(length, length), Revolute::smooth());
    for (restitution, friction) in [(0.0, 0.4), (0.3, 1e-6), (0.3, 0.01), (0.3, 0.4)] {
        let crank = HardStops::between(pin, [-1.0, 1.3]).rebounding(restitution);
        let side = (RigidBody::massless([1.0, 0.0]), Coulomb::new(pin, friction), bar(0.9));
        let net = Network::new((crank, bar(0.5), Pin, bar(1.2)), side, Pin);
        let scene = System::new(Clamped::origin(), net, Free)?.with_gravity(9.81);
        let start = scene.assembled(scene.at_rest(&[1.0, 0.3, 1.2])?, &Unloaded)?;
        macro_rules! rests {
            ($rule:expr) => {{
                let (mut last, mut rise) = (f64::INFINITY, 0.0_f64);
                let run = scene.simulation($rule).run(start, 3.0, |now| {
                    rise = rise.max(now.energy() - last);
                    last = now.energy();
                })?;
                let (places, rates) = (run.motion.coordinates(), run.motion.rates());
                println!("{restitution}, {friction}: {} steps, {places:?}, {rates:?}, rises by {rise:.1e}", run.steps);
                assert!((places[0] + 1.0).abs() < 1e-12 && rates.iter().all(|rate| rate.abs() < 1e-12));
                rise
            }};
        }
        assert!(rests!(Dop853::tolerance(1e-6)) < 1e-6);
        assert!(rests!(Dop853::tolerance(1e-9)) < 1e-9);
        rests!(MoreauJean::step(0.01));
        rests!(MoreauJean::step(0.001));
    }
    Ok(())
}

/// More joints stick at rest than the mechanism has freedoms: it is assembled, with or without what is held, and steps in real time begin there.
#[test]
fn a_mechanism_whose_pins_all_stick_is_assembled_and_stepped() -> Result<(), Box<dyn std::error::Error>> {
    let (bar, pin) =
        (|length: f64| Rod::uniform(length, length), |friction| Coulomb::new(Revolute::smooth(), friction));
    for friction in [0.2, 20.0] {
        let side = (RigidBody::massless([1.0, 0.0]), pin(friction), bar(0.9));
        let net = Network::new((pin(friction), bar(0.5), Pin, bar(1.2)), side, Pin);
        let scene = System::new(Clamped::origin(), net, Free)?.with_gravity(9.81);
        let guess = scene.at_rest(&[1.0, 0.3, 1.2])?;
        let held = scene.assembled_holding(guess, catena::system::Holding::both(&[0]), &Unloaded)?.motion;
        let start = scene.assembled(guess, &Unloaded)?;
        assert_eq!(held.coordinates()[0], 1.0);
        for start in [held, start] {
            let end = scene.simulation(MoreauJean::step(1e-3)).run(start, 0.1, |_| ())?.motion;
            let moved = end
                .coordinates()
                .iter()
                .zip(start.coordinates())
                .fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
            println!("friction {friction}: moves by {moved:.1e}");
            assert_eq!(moved > 1e-3, friction < 1.0);
        }
    }
    Ok(())
}
