//! Derivatives of runs whose joints strike stops, stick and slip: against closed forms over the same numbers, against differences of runs, and
//! what has none.
//!
//! Bounds: rules are exact for parabolas and cubics, so that closed forms of these are met to the rounding of instants found, amplified by a few
//! shocks, 1e-11 to 1e-9; a cosine to what the rule errs. Differences by 1e-5 err by 1e-10 of a third derivative and, where runs err by 1e-13, by
//! 1e-8, grown by what shocks amplify: 1e-6. Those of random arms by 1e-6 err ten times as much: 1e-4.

use catena::num_dual::Dual64;
use catena::planar::*;
use catena::scalar::{Elementary, Jet, Pack, Scalar};
use catena::{Error, Fault, spatial};
use catena_oracle::{Noise, has_order, near};
use std::f64::consts::{FRAC_PI_2, PI};

/// Compares numbers and their derivatives, these relative to the largest of one and themselves.
fn agree<const K: usize>(found: Jet<f64, K>, expected: Jet<f64, K>, bound: f64) {
    near(found.re, expected.re, bound);
    for (found, expected) in found.eps.iter().zip(&expected.eps) {
        near(*found, *expected, bound * (1.0 + expected.abs()));
    }
}

/// The last coordinates of a scene by a number, over plain numbers and over jets, agree in differences.
macro_rules! by_differences {
    ($bound:expr, [$($at:expr),*], |$x:ident, $T:ident| $run:expr) => {{
        fn plain($x: f64) -> Result<Vec<f64>, Error> {
            #[allow(dead_code)]
            type $T = f64;
            $run
        }
        fn derived($x: Jet<f64, 1>) -> Result<Vec<Jet<f64, 1>>, Error> {
            #[allow(dead_code)]
            type $T = Jet<f64, 1>;
            $run
        }
        for at in [$($at),*] {
            let by = 1e-5;
            let (found, [above, below]) = (derived(Jet::seed(at, 0))?, [plain(at + by)?, plain(at - by)?]);
            for (k, found) in found.iter().enumerate() {
                let expected = (above[k] - below[k]) / (2.0 * by);
                near(found.eps[0], expected, $bound * (1.0 + expected.abs()));
            }
        }
    }};
}

/// Height and rate of what falls from a height and gives back a share of its speed, after a time.
fn bounced<T: Scalar<Real = f64>>(height: T, restitution: T, gravity: T, time: f64) -> [T; 2] {
    let half = T::literal(0.5);
    let first = ((height + height) / gravity).sqrt();
    if time < first.real() {
        return [height - half * gravity * T::literal(time * time), -gravity * T::literal(time)];
    }
    let (mut left, mut speed) = (T::literal(time) - first, restitution * gravity * first);
    while left.real() > 2.0 * speed.real() / gravity.real() {
        left -= (speed + speed) / gravity;
        speed *= restitution;
    }
    [speed * left - half * gravity * left * left, speed - gravity * left]
}

#[test]
fn a_block_that_bounces() -> Result<(), Error> {
    type T = Jet<f64, 3>;
    let [height, restitution, gravity] = [T::seed(1.0, 0), T::seed(0.7, 1), T::seed(9.81, 2)];
    let block = RigidBody::new(T::of(2.0), T::of(0.1), [T::of(0.0); 2], [T::of(0.0); 2]);
    let range = [T::of(0.0), T::of(f64::INFINITY)];
    let fall = HardStops::between(Slider::along(T::of(FRAC_PI_2)), range).rebounding(restitution);
    let scene = System::new(Clamped::origin(), (fall, block), Free)?.with_gravity(gravity);
    let mut start = scene.motion();
    start.set_coordinates(&[height])?;
    macro_rules! runs {
        ($($rule:expr, $bound:expr);*) => {$(
            for time in [0.3, 0.6, 1.3, 1.9] {
                let end = scene.simulation($rule).run(start, time, |_| ())?.motion;
                let [place, rate] = bounced(height, restitution, gravity, time);
                agree(end.coordinates()[0], place, $bound);
                agree(end.rates()[0], rate, $bound);
            }
        )*};
    }
    runs!(Rk4::step(0.02), 1e-11; Dop853::tolerance(1e-10), 1e-11; Dopri5::step(0.01), 1e-11; Sdirk4::new().step(0.02), 1e-11);
    runs!(Adams::step(0.01), 1e-11; Vcabm::new().tolerance(1e-10), 1e-11; GeneralizedAlpha::new(0.8).step(0.01), 1e-11);
    // At rest on its stop nothing hangs on anything but where that is.
    let end = scene.simulation(Dop853::tolerance(1e-10)).run(start, 4.0, |_| ())?.motion;
    agree(end.coordinates()[0], T::of(0.0), 1e-12);
    agree(end.rates()[0], T::of(0.0), 1e-12);
    Ok(())
}

#[test]
fn stops_move_with_their_numbers() -> Result<(), Error> {
    // A stop at a height: what rests there goes with it, and what has bounced, too.
    let (stop, tall) = (Dual64::from(0.2).derivative(), Dual64::from(1.0));
    let zero = Dual64::from(0.0);
    let block = RigidBody::new(tall, tall, [zero; 2], [zero; 2]);
    let fall = HardStops::between(Slider::along(Dual64::from(FRAC_PI_2)), [stop, Dual64::from(f64::INFINITY)]);
    let scene = System::new(Clamped::origin(), (fall.rebounding(Dual64::from(0.5)), block), Free)?;
    let scene = scene.with_gravity(Dual64::from(9.81));
    let mut start = scene.motion();
    start.set_coordinates(&[tall])?;
    for time in [0.6, 0.8, 3.0] {
        let end = scene.simulation(Dop853::tolerance(1e-10)).run(start, time, |_| ())?.motion;
        let [place, rate] = bounced(tall - stop, Dual64::from(0.5), Dual64::from(9.81), time.min(1.2));
        let (found, turned) = (end.coordinates()[0], end.rates()[0]);
        let [place, rate] = if time > 2.0 { [stop, zero] } else { [place + stop, rate] };
        near(found.re, place.re, 1e-11);
        near(found.eps, place.eps, 1e-11);
        near(turned.re, rate.re, 1e-11);
        near(turned.eps, rate.eps, 1e-11);
    }
    Ok(())
}

#[test]
fn a_block_on_a_spring_that_rubs() -> Result<(), Error> {
    // Half a period at a time, about a place that friction moves; each half ends 2 F / k nearer.
    type T = Jet<f64, 4>;
    let [mass, stiffness, friction, reach] = [T::seed(2.0, 0), T::seed(50.0, 1), T::seed(1.5, 2), T::seed(0.5, 3)];
    let block = RigidBody::new(mass, T::of(0.1), [T::of(0.0); 2], [T::of(0.0); 2]);
    let track = Coulomb::new(Slider::along(T::of(0.0)), friction).with(Spring::new(stiffness));
    let scene = System::new(Clamped::origin(), (track, block), Free)?;
    let mut start = scene.motion();
    start.set_coordinates(&[reach])?;
    let frequency = (stiffness / mass).sqrt();
    let place = |time: f64| {
        let (shift, mut left, mut from) = (friction / stiffness, T::of(time), reach);
        let half = T::of(PI) / frequency;
        while left.re > half.re && from.re.abs() > shift.re {
            let about = shift * T::of(from.re.signum());
            (from, left) = (about + about - from, left - half);
        }
        let about = shift * T::of(from.re.signum());
        let still = from.re.abs() <= shift.re;
        if still { from } else { about + (from - about) * (frequency * left).sin_cos().1 }
    };
    for time in [0.2, 0.5, 0.9, 1.4, 2.0, 2.5, 6.0] {
        for (end, bound) in [
            (scene.simulation(Dop853::tolerance(1e-12)).run(start, time, |_| ())?.motion, 1e-9),
            (scene.simulation(Rk4::step(1e-3)).run(start, time, |_| ())?.motion, 1e-8),
            (scene.simulation(Vcabm::new().tolerance(1e-12)).run(start, time, |_| ())?.motion, 1e-8),
        ] {
            agree(end.coordinates()[0], place(time), bound);
        }
    }
    Ok(())
}

#[test]
fn a_block_that_breaks_away_under_a_growing_force() -> Result<(), Error> {
    type T = Jet<f64, 3>;
    let [mass, friction, growth] = [T::seed(2.0, 0), T::seed(3.0, 1), T::seed(5.0, 2)];
    let scene = |breaking: T| {
        let block = RigidBody::new(mass, T::of(0.1), [T::of(0.0); 2], [T::of(0.0); 2]);
        let track = Coulomb::new(Slider::along(T::of(0.0)), friction).breaking_away(breaking);
        System::new(Clamped::origin(), (track, block), Free)
    };
    let pull = |time: f64, joint: usize, _: &JointMotion<T>| if joint == 1 { growth * T::of(time) } else { T::of(0.0) };
    let (plain, loads) = (scene(friction)?, Loads::none().in_joints(pull));
    let end = plain.simulation(Dop853::tolerance(1e-11)).loads(&loads).run(plain.motion(), 1.5, |_| ())?.motion;
    // It goes once the force is as large as friction: m q̈ = g (t − F / g).
    let later = T::of(1.5) - friction / growth;
    agree(end.coordinates()[0], growth * later * later * later / (mass * T::of(6.0)), 1e-9);
    // From more friction than it slips with, it jumps: m q̈ = g t − F from t = 1.2 F / g on.
    let (jumps, time, six) = (scene(friction * T::of(1.2))?, T::of(1.5), T::of(6.0));
    let [from, half] = [friction * T::of(1.2) / growth, T::of(0.5)];
    let pulled = time * time * time / six - half * from * from * time + from * from * from * T::of(1.0 / 3.0);
    let place = (growth * pulled - friction * half * (time - from) * (time - from)) / mass;
    let speed = (growth * half * (time * time - from * from) - friction * (time - from)) / mass;
    macro_rules! runs {
        ($($rule:expr, $bound:expr);*) => {$(
            let end = jumps.simulation($rule).loads(&loads).run(jumps.motion(), 1.5, |_| ())?.motion;
            agree(end.coordinates()[0], place, $bound);
            agree(end.rates()[0], speed, $bound);
        )*};
    }
    runs!(Dop853::tolerance(1e-11), 1e-10; Rk4::step(0.01), 1e-10; Vcabm::new().tolerance(1e-11), 1e-9; Sdirk4::new().step(0.01), 1e-9);
    Ok(())
}

#[test]
fn a_block_that_sticks_and_slips_behind_a_spring() -> Result<(), Error> {
    // A spring whose other end goes steadily on draws a block, which sticks by more friction than it slips with.
    by_differences!(1e-6, [0.9, 1.0, 1.1], |factor, T| {
        let of = <T as Scalar>::literal;
        let zero = of(0.0);
        let block = RigidBody::new(of(1.0), of(0.1), [zero; 2], [zero; 2]);
        let stiffness = of(40.0) * factor;
        let track = Coulomb::new(Slider::along(zero), of(2.0)).breaking_away(of(3.0)).with(Spring::new(stiffness));
        let scene = System::new(Clamped::origin(), (track, block), Free)?;
        let pull = move |time: f64, joint: usize, _: &JointMotion<T>| {
            if joint == 1 { stiffness * of(0.2 * time) } else { zero }
        };
        let loads = Loads::none().in_joints(pull);
        let mut found = vec![];
        for time in [0.7, 1.3, 2.6] {
            let end = scene.simulation(Dop853::tolerance(1e-13)).loads(&loads).run(scene.motion(), time, |_| ())?;
            found.extend([end.motion.coordinates()[0], end.motion.rates()[0]]);
        }
        Ok(found)
    });
    Ok(())
}

#[test]
fn a_drawer_that_rubs_and_strikes() -> Result<(), Error> {
    type T = Jet<f64, 4>;
    let [mass, friction, speed, restitution] = [T::seed(2.0, 0), T::seed(4.0, 1), T::seed(2.0, 2), T::seed(0.5, 3)];
    let rail = Coulomb::new(Slider::along(T::of(0.0)), friction).between([T::of(0.0), T::of(0.4)]);
    let drawer = RigidBody::new(mass, T::of(0.1), [T::of(0.0); 2], [T::of(0.0); 2]);
    let scene = System::new(Clamped::origin(), (rail.rebounding(restitution), drawer), Free)?;
    let mut start = scene.with_rates(scene.motion(), &[-speed])?;
    start.set_coordinates(&[T::of(0.3)])?;
    let end = scene.simulation(Dop853::tolerance(1e-10)).run(start, 2.0, |_| ())?.motion;
    let slowed = friction / mass;
    let arrives = speed * speed - slowed * T::of(0.6);
    agree(end.coordinates()[0], restitution * restitution * arrives / (slowed + slowed), 1e-11);
    agree(end.rates()[0], T::of(0.0), 1e-12);
    Ok(())
}

#[test]
fn a_double_pendulum_that_bounces() -> Result<(), Error> {
    // By a length, over seven shocks or so; motions jump for all joints.
    by_differences!(1e-6, [0.8, 1.0, 1.1], |length, T| {
        let of = <T as Scalar>::literal;
        let rod = Rod::uniform(length, of(1.0));
        let elbow = HardStops::between(Revolute::smooth(), [of(0.0), of(FRAC_PI_2)]).rebounding(of(0.8));
        let whole = System::new(Pinned::origin(), (rod, elbow, rod), Free)?.with_gravity(of(9.81));
        let start = whole.at_rest(&[of(-0.2), of(0.7)])?;
        let end = whole.simulation(Dop853::tolerance(1e-13)).run(start, 2.0, |_| ())?.motion;
        Ok(end.coordinates().into_iter().chain(end.rates()).collect())
    });
    Ok(())
}

#[test]
fn arms_in_space_that_bounce_and_stick() -> Result<(), Error> {
    use spatial::{Ball, Coulomb, Free, HardStops, Pinned, Revolute, RigidBody, System};
    // A shoulder that is free, an elbow between stops, a wrist that rubs.
    by_differences!(1e-6, [0.9, 1.2], |mass, T| {
        let of = <T as Scalar>::literal;
        let zero = of(0.0);
        let tensor = [[of(0.02), zero, zero], [zero, of(0.03), zero], [zero, zero, of(0.01)]];
        let body = RigidBody::new(mass, tensor, [zero, zero, of(-0.2)], [zero, zero, of(-0.4)]);
        let elbow = HardStops::between(Revolute::about([of(1.0), zero, zero]), [of(-0.3), of(0.5)]).rebounding(of(0.6));
        let wrist = Coulomb::new(Revolute::about([zero, of(1.0), zero]), of(0.1));
        let scene = System::new(Pinned::origin(), (body, elbow, body, wrist, body, Ball, body), Free)?;
        let scene = scene.with_gravity([zero, zero, of(-9.81)]);
        let rates = [0.3, 0.5, 0.2, 2.0, 1.5, 0.1, 0.2, 0.3].map(of);
        let start = scene.with_rates(scene.motion(), &rates)?;
        let end = scene.simulation(Dop853::tolerance(1e-13)).run(start, 0.8, |_| ())?.motion;
        let mut found: Vec<T> = vec![];
        for body in scene.body_motions(&end)?.iter() {
            let place = body.centre().place;
            found.extend([place.x, place.y, place.z]);
        }
        Ok(found)
    });
    Ok(())
}

/// The end of a random arm whose joints rub, strike and do both, by a factor of one of its numbers: coordinates and rates.
macro_rules! random_arm {
    ($T:ident, $seed:expr, $varied:expr, $factor:expr) => {{
        let mut random = Noise::new($seed);
        let (mut number, of) = (0, <$T as Scalar>::literal);
        let mut between = |least: f64, most: f64| {
            number += 1;
            let value = of(random.between(least, most));
            if number == $varied + 1 { value * $factor } else { value }
        };
        let rods = [0; 4].map(|_| Rod::uniform(between(0.4, 1.0), between(0.5, 1.5)));
        let friction = between(0.05, 0.8);
        let shoulder = Coulomb::new(Revolute::smooth(), friction).breaking_away(friction * between(1.0, 1.5));
        let range = [between(-1.0, -0.2), between(0.2, 1.0)];
        let elbow = HardStops::between(Revolute::smooth(), range).rebounding(between(0.2, 0.9));
        let (friction, range) = (between(0.02, 0.4), [between(-1.0, -0.2), between(0.2, 1.0)]);
        let wrist = Coulomb::new(Revolute::smooth(), friction).between(range).rebounding(between(0.2, 0.9));
        let chain = (rods[0], shoulder, rods[1], elbow, rods[2], wrist, rods[3]);
        let arm = System::new(Pinned::origin(), chain, Free)?.with_gravity(between(8.0, 10.0));
        let mut start = arm.motion();
        start.set_coordinates(&[between(-0.5, 0.5), between(-1.0, 1.0), between(-0.19, 0.19), between(-0.19, 0.19)])?;
        let rates = [between(-2.0, 2.0), between(-2.0, 2.0), between(-2.0, 2.0), between(-2.0, 2.0)];
        let start = arm.with_rates(start, &rates)?;
        let run = arm.simulation(Dop853::tolerance(1e-13)).run(start, 0.9, |_| ());
        let motion = run.map_err(|stopped| stopped.error)?.motion;
        Ok(motion.coordinates().into_iter().chain(motion.rates()).collect())
    }};
}

/// So many random arms.
const ARMS: u64 = 50;

fn plain_arm(seed: u64, varied: usize, factor: f64) -> Result<Vec<f64>, Error> {
    random_arm!(f64, seed, varied, factor)
}

fn derived_arm(seed: u64, varied: usize) -> Result<Vec<Jet<f64, 1>>, Error> {
    type T = Jet<f64, 1>;
    random_arm!(T, seed, varied, T::seed(1.0, 0))
}

#[test]
fn random_arms_by_random_numbers() -> Result<(), Error> {
    let mut smooth = 0;
    for seed in 0..ARMS {
        let varied = seed as usize % 27;
        let (found, plain) = (derived_arm(seed, varied)?, plain_arm(seed, varied, 1.0)?);
        let mut slopes = vec![];
        for by in [2e-6, 1e-6] {
            let [above, below] = [1.0 + by, 1.0 - by].map(|factor| plain_arm(seed, varied, factor));
            slopes.push(above?.iter().zip(&below?).map(|(a, b)| (a - b) / (2.0 * by)).collect::<Vec<_>>());
        }
        // Where another joint strikes first, or one more, within the difference, there is none.
        let agree = |a: f64, b: f64, bound: f64| (a - b).abs() <= bound * (1.0 + a.abs().max(b.abs()));
        if slopes[0].iter().zip(&slopes[1]).any(|(a, b)| !agree(*a, *b, 1e-5)) {
            continue;
        }
        smooth += 1;
        for (k, found) in found.iter().enumerate() {
            near(found.re, plain[k], 1e-8);
            assert!(agree(found.eps[0], slopes[1][k], 1e-4), "{seed}: {k}: {} {}", found.eps[0], slopes[1][k]);
        }
    }
    println!("{smooth} of {ARMS} arms compared");
    assert!(smooth * 10 >= ARMS * 9);
    Ok(())
}

#[test]
fn steps_that_change_modes_within() -> Result<(), Error> {
    // Derivatives are those of the steps, and tend to those of the motion.
    type T = Jet<f64, 3>;
    let [mass, friction, speed] = [T::seed(2.0, 0), T::seed(3.0, 1), T::seed(2.0, 2)];
    let block = RigidBody::new(mass, T::of(0.1), [T::of(0.0); 2], [T::of(0.0); 2]);
    let scene = System::new(Clamped::origin(), (Coulomb::new(Slider::along(T::of(0.0)), friction), block), Free)?;
    let start = scene.with_rates(scene.motion(), &[speed])?;
    let way = speed * speed * mass / (friction + friction);
    let mut errors = vec![];
    for step in [4e-3, 2e-3, 1e-3] {
        let end = scene.simulation(MoreauJean::step(step)).run(start, 2.0, |_| ())?.motion;
        let missed = end.coordinates()[0] - way;
        errors.push((step, missed.eps.iter().fold(missed.re.abs(), |most, x| most.max(x.abs()))));
        assert_eq!(end.rates(), [T::of(0.0)]);
    }
    has_order("derivatives of a halt", 1.0, 1e-15, &errors);
    // An arm that rubs in its elbow, sticks there and slips again.
    macro_rules! arm {
        ($T:ident, $length:expr) => {{
            let of = <$T as Scalar>::literal;
            let rod = Rod::uniform($length, of(1.0));
            let chain = (rod, Coulomb::new(Revolute::smooth(), of(1.5)), rod);
            let arm = System::new(Pinned::origin(), chain, Free)?.with_gravity(of(9.81));
            let end = arm.simulation(MoreauJean::step(1e-3)).run(arm.at_rest(&[of(-0.2), of(0.7)])?, 1.5, |_| ())?;
            [end.motion.coordinates()[0], end.motion.coordinates()[1]]
        }};
    }
    type One = Jet<f64, 1>;
    let by = 1e-6;
    let (found, [above, below]) = (arm!(One, One::seed(1.0, 0)), [arm!(f64, 1.0 + by), arm!(f64, 1.0 - by)]);
    for k in 0..2 {
        near(found[k].eps[0], (above[k] - below[k]) / (2.0 * by), 1e-6);
    }
    Ok(())
}

#[test]
fn what_sticks_loses_a_rate_at_once() -> Result<(), Error> {
    // An elbow that sticks: by the rate with which it begins nothing moves but what its halt throws about, as where it is welded.
    type T = Jet<f64, 1>;
    let of = T::of;
    let rod = Rod::uniform(of(1.0), of(1.0));
    let elbow = Coulomb::new(Revolute::smooth(), of(50.0));
    let arm = System::new(Pinned::origin(), (rod, elbow, rod), Free)?.with_gravity(of(9.81));
    let mut start = arm.motion();
    start.set_coordinates(&[of(-0.4), of(0.6)])?;
    let start = arm.with_rates(start, &[of(0.5), T::seed(0.0, 0)])?;
    // Angular momentum about the root stays: I dω = (share of the outer rod) dq̇.
    let (elbow_to_root, cosine) = (1.0, 0.6_f64.cos());
    let outer = 1.0 / 3.0 + 0.5 * elbow_to_root * cosine;
    let whole = 1.0 / 3.0 + 1.0 / 3.0 + elbow_to_root + cosine;
    let halted = |motion: &[T]| (motion[0].eps[0], motion[1].eps[0]);
    let soon = arm.simulation(Dop853::tolerance(1e-12)).run(start, 1e-6, |_| ())?.motion;
    let (turned, stuck) = halted(&soon.rates());
    near(turned, outer / whole, 1e-5); // after a microsecond
    near(stuck, 0.0, 1e-15);
    // Later as the same arm that begins with that rate.
    let mut other = arm.with_rates(arm.motion(), &[Jet { re: 0.5, eps: [outer / whole] }, of(0.0)])?;
    other.set_coordinates(&[of(-0.4), of(0.6)])?;
    let found = arm.simulation(Dop853::tolerance(1e-12)).run(start, 1.0, |_| ())?.motion;
    let expected = arm.simulation(Dop853::tolerance(1e-12)).run(other, 1.0, |_| ())?.motion;
    for (found, expected) in found.coordinates().into_iter().zip(expected.coordinates()) {
        agree(found, expected, 1e-12);
    }
    // Steps of one size do the same, to their order.
    let stepped = arm.simulation(MoreauJean::step(1e-4)).run(start, 1.0, |_| ())?.motion;
    near(stepped.coordinates()[0].eps[0], expected.coordinates()[0].eps[0], 1e-2);
    Ok(())
}

#[test]
fn what_has_no_derivative_is_refused() -> Result<(), Error> {
    type T = Jet<f64, 1>;
    let [zero, one] = [T::of(0.0), T::of(1.0)];
    let body = |mass: T| RigidBody::new(mass, one, [zero; 2], [zero; 2]);
    let stop = |range| HardStops::between(Slider::along(T::of(FRAC_PI_2)), range);
    let far = T::of(f64::INFINITY);
    // A start that strikes, by where it is.
    let scene = System::new(Clamped::origin(), (stop([zero, far]), body(one)), Free)?;
    let falling = scene.with_rates(scene.motion(), &[-one])?;
    let mut varied = falling;
    varied.set_coordinates(&[T::seed(0.0, 0)])?;
    let fault = scene.simulation(Rk4::step(0.1)).run(varied, 1.0, |_| ()).expect_err("a start").error.fault;
    assert!(matches!(fault, Fault::Unsupported { what } if what.contains("touches its stop")), "{fault}");
    // Steps across shocks.
    let fault = scene.simulation(MoreauJean::step(0.1)).run(falling, 1.0, |_| ()).expect_err("shocks").error.fault;
    assert!(matches!(fault, Fault::Unsupported { what } if what.contains("across shocks")), "{fault}");
    scene.simulation(Rk4::step(0.1)).run(falling, 1.0, |_| ())?;
    // Second derivatives, where a time hangs on what is differentiated; elsewhere not.
    type Second = Jet<Jet<f64, 1>, 1>;
    let of = |x: f64| Second::of(T::of(x));
    let body = RigidBody::new(of(1.0), of(1.0), [of(0.0); 2], [of(0.0); 2]);
    let fall = HardStops::between(Slider::along(of(FRAC_PI_2)), [of(0.0), of(f64::INFINITY)]);
    let scene = System::new(Clamped::origin(), (fall, body), Free)?.with_gravity(of(9.81));
    let mut start = scene.motion();
    start.set_coordinates(&[of(1.0)])?;
    scene.simulation(Rk4::step(0.1)).run(start, 1.0, |_| ())?;
    start.set_coordinates(&[Second::seed(Jet::seed(1.0, 0), 0)])?;
    let fault = scene.simulation(Rk4::step(0.1)).run(start, 1.0, |_| ()).expect_err("second").error.fault;
    assert!(matches!(fault, Fault::Unsupported { what } if what.contains("above the first")), "{fault}");
    // Break-away too, whose slopes jump.
    let track = Coulomb::new(Slider::along(of(0.0)), Second::seed(Jet::seed(3.0, 0), 0));
    let scene = System::new(Clamped::origin(), (track, body), Free)?;
    let pull = |time: f64, joint: usize, _: &JointMotion<Second>| if joint == 1 { of(5.0 * time) } else { of(0.0) };
    let loads = Loads::none().in_joints(pull);
    let fault = scene.simulation(Rk4::step(0.1)).loads(&loads).run(scene.motion(), 1.0, |_| ()).expect_err("second");
    let fault = fault.error.fault;
    assert!(matches!(fault, Fault::Unsupported { what } if what.contains("above the first")), "{fault}");
    Ok(())
}

#[test]
fn what_hangs_on_times_that_nothing_tells_is_refused() -> Result<(), Error> {
    // Drawn by a force that jumps beyond what holds at rest: it breaks away then, but how fast the force grows says nothing.
    type T = Jet<f64, 1>;
    let of = T::of;
    let block = || RigidBody::new(of(1.0), of(0.1), [of(0.0); 2], [of(0.0); 2]);
    let track = Coulomb::new(Slider::along(of(0.0)), of(2.0)).breaking_away(T::seed(3.0, 0));
    let scene = System::new(Clamped::origin(), (track, block()), Free)?;
    let pull = |time: f64, joint: usize, _: &JointMotion<T>| of(if joint == 1 && time > 0.5 { 5.0 } else { 1.0 });
    let loads = Loads::none().in_joints(pull);
    let fault = scene.simulation(Rk4::step(0.1)).loads(&loads).run(scene.motion(), 1.0, |_| ()).expect_err("a jump");
    let fault = fault.error.fault;
    assert!(matches!(fault, Fault::Unsupported { what } if what.contains("steadily")), "{fault}");
    // Beside a joint that is driven.
    let crank = Driven::new(Revolute::smooth(), move |time: f64| [of(time), of(1.0), of(0.0)]);
    let fall = HardStops::between(Slider::along(of(0.0)), [T::seed(-0.1, 0), of(0.1)]);
    let scene = System::new(Pinned::origin(), (block(), crank, block(), fall, block()), Free)?.with_gravity(of(9.81));
    let fault = scene.simulation(Rk4::step(0.01)).run(scene.motion(), 2.0, |_| ()).expect_err("driven").error.fault;
    assert!(matches!(fault, Fault::Unsupported { what } if what.contains("driven")), "{fault}");
    // Numbers side by side, that strike at several times.
    type Two = Pack<f64, 2>;
    let of = Two::of;
    let block = RigidBody::new(of(1.0), of(0.1), [of(0.0); 2], [of(0.0); 2]);
    let fall = HardStops::between(Slider::along(of(FRAC_PI_2)), [of(0.0), of(f64::INFINITY)]);
    let scene = System::new(Clamped::origin(), (fall, block), Free)?.with_gravity(of(9.81));
    let mut start = scene.motion();
    start.set_coordinates(&[Pack([1.0, 1.1])])?;
    let fault = scene.simulation(Rk4::step(0.01)).run(start, 1.0, |_| ()).expect_err("two").error.fault;
    assert!(matches!(fault, Fault::Unsupported { what } if what.contains("side by side")), "{fault}");
    Ok(())
}
