//! Joints that follow others: sweeps against inverse dynamics and closed forms, runs under all rules, derivatives, what is refused.

use catena::planar::*;
use catena::scalar::{Jet, Pack};
use catena::simulate::EnergyDrift;
use catena::system::{Holding, Position};
use catena::{Error, Fault, Place, robot, spatial};
use catena_oracle::{Noise, farthest, has_order, near};
use catena_robots::cart;

/// Three numbers from −1 to 1.
fn three(noise: &mut Noise) -> [f64; 3] {
    std::array::from_fn(|_| noise.between(-1.0, 1.0))
}

/// Two plates that hang side by side from the ground, on joints of one's choice.
macro_rules! hand {
    ($left:expr, $right:expr) => {
        System::new(Clamped::origin(), (Branch(($left, plate(LEFT))), $right, plate(RIGHT)), Free)?
            .with_gravity(GRAVITY)
    };
}

const GRAVITY: f64 = 9.81;
const RATIO: f64 = -1.7;
const OFFSET: f64 = 0.4;
const LEFT: [f64; 4] = [1.3, 0.02, 0.21, 0.05];
const RIGHT: [f64; 4] = [0.7, 0.03, 0.34, -0.02];

/// A body by its mass, its inertia about the mass centre, and where that is.
fn plate([mass, inertia, x, y]: [f64; 4]) -> RigidBody<f64> {
    RigidBody::new(mass, inertia, [x, y], [0.5, 0.0])
}

/// Its inertia about its joint, and the torque of its weight there.
fn about_joint([mass, inertia, x, y]: [f64; 4], angle: f64) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    [inertia + mass * (x * x + y * y), -mass * GRAVITY * (x * cosine - y * sine)]
}

#[test]
fn two_plates_move_as_the_one_that_they_are() -> Result<(), Error> {
    let scene = hand!(Revolute::smooth().named("left"), Revolute::smooth().named("right"));
    let couplings = Couplings::of(&scene, [Coupling::new("right", "left").ratio(RATIO).offset(OFFSET)])?;
    let mut noise = Noise::new(11);
    for _ in 0..100 {
        let [angle, rate, torque] = three(&mut noise);
        let mut start = scene.motion();
        start.set_coordinates(&[angle, 0.0])?;
        start.set_rates(&[rate, 0.0])?;
        let start = couplings.joined(start);
        let other = RATIO * angle + OFFSET;
        assert_eq!((start.coordinates(), start.rates()), (vec![angle, other], vec![rate, RATIO * rate]));
        let loads = couplings.and(Loads::none().torques([0.0, torque, 0.0]));
        let motion = scene.with_accelerations(start, &loads)?;
        let ([inertia, weight], [other_inertia, other_weight]) = (about_joint(LEFT, angle), about_joint(RIGHT, other));
        let exact = (torque + weight + RATIO * other_weight) / (inertia + RATIO * RATIO * other_inertia);
        let found = motion.accelerations();
        near(found[0], exact, 1e-14 * (1.0 + exact.abs()));
        near(found[1], RATIO * exact, 1e-14 * (1.0 + exact.abs()));
        // What the joints exert: of the follower all but its weight is the coupling's.
        let stations = scene.stations(&motion, &loads)?;
        let exerted = |name| -> Result<f64, Error> {
            Ok(-stations.joint(scene.joint(name)?).expect("a station").internal.torque)
        };
        let force = other_inertia * found[1] - other_weight;
        near(exerted("right")?, force, 1e-13 * (1.0 + force.abs()));
        near(exerted("left")?, torque - RATIO * force, 1e-13 * (1.0 + force.abs()));
    }
    Ok(())
}

/// Masses on a rope over a pulley, of all sizes.
#[test]
fn masses_on_a_rope_fall_as_atwood_has_it() -> Result<(), Error> {
    for exponent in -12..=12 {
        let (heavy, light) = (3.0 * 10f64.powi(exponent), 2.0);
        let mass = |mass| RigidBody::new(mass, 0.1, [0.0; 2], [0.0; 2]);
        let line = Slider::along(std::f64::consts::FRAC_PI_2);
        let scene = System::new(Clamped::origin(), (Branch((line, mass(heavy))), line, mass(light)), Free)?
            .with_gravity(GRAVITY);
        let couplings = Couplings::of(&scene, [Coupling::new(2, 1).ratio(-1.0)])?;
        let found = scene.with_accelerations(scene.motion(), &couplings)?.accelerations();
        let exact = -GRAVITY * (heavy - light) / (heavy + light);
        near(found[0], exact, 4e-15 * GRAVITY);
        near(found[1], -exact, 4e-15 * GRAVITY);
    }
    Ok(())
}

/// Under forces that sweeps find, what inverse dynamics ask of joints acts in them: nothing but torques where nothing is coupled, and of
/// each coupling λ in the follower and −r λ in the leader. On a tree with a leader that follows another one, and two followers of one.
#[test]
fn forces_of_couplings_do_no_work_and_nothing_else_acts() -> Result<(), Error> {
    use robot::*;
    let mut noise = Noise::new(5);
    for _ in 0..50 {
        let links: [_; 5] = std::array::from_fn(|_| {
            let [a, b, c] = three(&mut noise).map(|x| 0.3 + 0.2 * x);
            let tensor = [[0.04, 0.002, 0.001], [0.002, 0.05, 0.003], [0.001, 0.003, 0.03]];
            Link::general(0.5 + a, [0.1 * b, 0.1 * c, 0.2 * a], tensor)
        });
        let [first, second, third, fourth, fifth] = links;
        let mut joint = || Hinge::at::<0b111>(three(&mut noise).map(|x| 0.3 * x)).turned(Quarter::<30>);
        let (a, b, c) = (joint(), joint(), joint());
        let slide = Slide::at::<0b111>(three(&mut noise)).turned(Quarter::<20>);
        let (arm, short) = (Branch((a, second, slide, third)), Branch((b, fourth)));
        let scene = System::new(Base::origin(), (Hinge::level().grounded(), first, arm, short, c, fifth), Free)?;
        let scene = scene.with_gravity([0.3, -0.2, -9.81]);
        // Joints: ground 0, arm 1 and 2, 3, and the last 4.
        let pairs = [([3, 1], 0.8), ([4, 3], -1.3), ([2, 1], 0.25)];
        let couplings =
            pairs.map(|([follower, leader], ratio)| Coupling::by_coordinate(follower, leader).ratio(ratio).offset(0.1));
        let couplings = Couplings::of(&scene, couplings)?;
        let (mut q, mut v, mut torques) = ([0.0; 5], [0.0; 5], [0.0; 5]);
        [&mut q, &mut v, &mut torques].into_iter().for_each(|list| list.fill_with(|| noise.between(-1.0, 1.0)));
        let start = couplings.joined(scene.at_joints(&q, &v)?);
        let efforts: Vec<_> = core::iter::once(0.0).chain(torques).map(|torque| Effort([torque, 0.0, 0.0])).collect();
        let loads = couplings.and(Loads::none().efforts(efforts));
        let motion = scene.with_accelerations(start, &loads)?;
        let list = |numbers: Vec<f64>| -> [f64; 5] { numbers.try_into().expect("five") };
        let (q, v, a) = (list(motion.coordinates()), list(motion.rates()), list(motion.accelerations()));
        for ([follower, leader], ratio) in pairs {
            near(q[follower], ratio * q[leader] + 0.1, 1e-15);
            near(a[follower], ratio * a[leader], 1e-12 * (1.0 + a[leader].abs()));
        }
        let listed = scene.forward_dynamics_coupled(&q, &v, &torques, &couplings)?;
        listed.iter().zip(a).for_each(|(listed, a)| near(*listed, a, 1e-12 * (1.0 + a.abs())));
        let asked = scene.inverse_dynamics(&q, &v, &a)?;
        let rest: Vec<_> = asked.iter().zip(torques).map(|(asked, torque)| asked - torque).collect();
        // λ of the couplings, from the followers inward.
        let (of_last, of_slide) = (rest[4], rest[2]);
        let of_branch = rest[3] + -1.3 * of_last;
        let size = rest.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        near(rest[0], 0.0, 1e-13 * size);
        near(rest[1], -0.8 * of_branch - 0.25 * of_slide, 1e-13 * size);
    }
    Ok(())
}

/// The end of a run from rest at an angle of the leader, by steps of RK4 through the closed form: angle and rate.
fn reduced(stiffness: [f64; 2], end: f64) -> [f64; 2] {
    let acceleration = |[angle, _]: [f64; 2]| {
        let other = RATIO * angle + OFFSET;
        let ([inertia, weight], [other_inertia, other_weight]) = (about_joint(LEFT, angle), about_joint(RIGHT, other));
        let force = weight - stiffness[0] * angle + RATIO * (other_weight - stiffness[1] * other);
        force / (inertia + RATIO * RATIO * other_inertia)
    };
    let steps = 20_000;
    let (dt, mut now) = (end / steps as f64, [0.5, 0.0]);
    for _ in 0..steps {
        let ahead = |slope: [f64; 2], share: f64| [now[0] + share * dt * slope[0], now[1] + share * dt * slope[1]];
        let slope = |state: [f64; 2]| [state[1], acceleration(state)];
        let a = slope(now);
        let b = slope(ahead(a, 0.5));
        let c = slope(ahead(b, 0.5));
        let d = slope(ahead(c, 1.0));
        now = std::array::from_fn(|k| now[k] + dt / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]));
    }
    now
}

#[test]
fn runs_by_all_rules_are_those_of_one_freedom() -> Result<(), Error> {
    let springs = [40.0, 25.0];
    let spring = |stiffness| ElasticHinge::rotary(stiffness);
    let (smooth, sprung) =
        (hand!(Revolute::smooth(), Revolute::smooth()), hand!(spring(springs[0]), spring(springs[1])));
    macro_rules! ends {
        ($scene:ident, $stiffness:expr, $rule:expr, $tolerance:expr) => {{
            let couplings = Couplings::of(&$scene, [Coupling::new(2, 1).ratio(RATIO).offset(OFFSET)])?;
            let mut start = $scene.motion();
            start.set_coordinates(&[0.5, 0.0])?;
            let (mut drift, mut apart) = (EnergyDrift::default(), 0.0_f64);
            let run =
                $scene.simulation($rule).loads(&couplings).every(0.05).run(couplings.joined(start), 2.0, |now| {
                    drift.observe(now);
                    let (q, v) = (now.motion().coordinates(), now.motion().rates());
                    apart = apart.max((q[1] - RATIO * q[0] - OFFSET).abs()).max((v[1] - RATIO * v[0]).abs());
                })?;
            let [angle, rate] = reduced($stiffness, 2.0);
            println!("{}: drift {:.1e}, apart {apart:.1e}", stringify!($rule), drift.largest());
            near(run.motion.coordinates()[0], angle, $tolerance);
            near(run.motion.rates()[0], rate, 20.0 * $tolerance);
            assert!(apart < 1e-12 && drift.largest() < 60.0 * $tolerance);
        }};
    }
    ends!(smooth, [0.0; 2], Dop853::tolerance(1e-12), 1e-10);
    ends!(smooth, [0.0; 2], Dopri5::tolerance(1e-10), 1e-8);
    ends!(smooth, [0.0; 2], Rk4::step(1e-3), 1e-8);
    ends!(smooth, [0.0; 2], Adams::tolerance(1e-10), 1e-8);
    ends!(smooth, [0.0; 2], Vcabm::new().tolerance(1e-11), 1e-9);
    ends!(smooth, [0.0; 2], Auto::tolerance(1e-10), 1e-8);
    ends!(sprung, springs, Dop853::tolerance(1e-12), 1e-10);
    ends!(sprung, springs, Sdirk4::new().tolerance(1e-9), 1e-6);
    ends!(sprung, springs, GeneralizedAlpha::new(0.9).step(1e-4), 1e-5);
    ends!(sprung, springs, Auto::tolerance(1e-10), 1e-7);
    Ok(())
}

/// Beside a hinge whose linear springs, along fixed axes, remember a sweep: that under the forces that were found, in a chain and where a tip is held.
#[test]
fn joints_remember_the_sweep_that_counts() -> Result<(), Error> {
    let (rod, turn) = (Rod::uniform(1.0_f64, 1.0), Revolute::smooth());
    let hinge = ElasticHinge::linear(Spring::new(2e3).damped(5.0), Spring::new(3e3).damped(4.0)).in_fixed_axes();
    macro_rules! orders {
        ($chain:expr, $tip:expr, $angles:expr, $steps:expr) => {{
            let scene = System::new(Pinned::<[f64; 2]>::origin(), $chain, $tip)?.with_gravity(GRAVITY);
            let couplings = Couplings::of(&scene, [Coupling::new(3, 1).ratio(RATIO)])?;
            let mut guess = scene.motion();
            guess.set_coordinates(&$angles)?;
            let start = scene.assembled(couplings.joined(guess), &couplings)?;
            let run = scene.simulation(Dop853::tolerance(1e-12)).loads(&couplings).run(start, 0.5, |_| ())?;
            let exact = run.motion.coordinates();
            let missed = |found: Vec<f64>| farthest(&found, &exact);
            let (mut second, mut fourth) = (vec![], vec![]);
            for h in $steps {
                let run =
                    scene.simulation(GeneralizedAlpha::new(0.8).step(h)).loads(&couplings).run(start, 0.5, |_| ())?;
                second.push((h, missed(run.motion.coordinates())));
                let run = scene.simulation(Sdirk4::default().step(h)).loads(&couplings).run(start, 0.5, |_| ())?;
                fourth.push((h, missed(run.motion.coordinates())));
            }
            has_order("generalised-alpha", 2.0, 1e-11, &second);
            has_order("Sdirk4", 4.0, 1e-12, &fourth);
        }};
    }
    let arm = (rod, turn, rod, hinge, rod, turn, rod);
    orders!(arm, Free, [0.0; 6], [4e-3, 2e-3, 1e-3]);
    let held = (rod, turn, rod, hinge, rod, turn, rod, Pin, rod);
    orders!(held, Pinned::at(3.0, 0.0), [0.9, -0.5, 0.0, 0.0, -0.2, 0.85, -0.7], [1e-3, 5e-4, 2.5e-4]);
    Ok(())
}

/// Masses on a rope over a pulley, one of them on a strut along its track: as on a spring in its slide, step by step, at stiffnesses that no step resolves.
#[test]
fn stiff_struts_stand_beside_couplings() -> Result<(), Error> {
    let mass = |mass| RigidBody::new(mass, 0.1, [0.0; 2], [0.0; 2]);
    let line = Slider::along(std::f64::consts::FRAC_PI_2);
    for k in [1e2, 1e6] {
        let c = 1e-3 * k;
        macro_rules! scene {
            ($line:expr) => {
                System::new(Clamped::origin(), (Branch((line, mass(3.0))), $line, mass(2.0)), Free)?
                    .with_gravity(GRAVITY)
            };
        }
        let (sprung, free) = (scene!(line.with(Spring::new(k).damped(c).resting_at(0.1))), scene!(line));
        let strut = Strut::to_ground((1, [0.0; 2]), [0.0, -2.0]).with_stiffness(k).with_damping(c).with_length(2.1);
        let (one, other) =
            (Couplings::of(&sprung, [Coupling::new(2, 1).ratio(-1.0)])?, [Coupling::new(2, 1).ratio(-1.0)]);
        let other = Couplings::of(&free, other)?.and(Struts::of([strut]).stiff());
        macro_rules! alike {
            ($($rule:expr),*) => {$(
                let expected = sprung.simulation($rule).loads(&one).run(sprung.motion(), 0.5, |_| ())?.motion;
                let found = free.simulation($rule).loads(&other).run(free.motion(), 0.5, |_| ())?.motion;
                near(found.coordinates()[1], expected.coordinates()[1], 1e-11);
                near(found.rates()[1], expected.rates()[1], 1e-10);
                near(found.coordinates()[0], -found.coordinates()[1], 1e-13);
            )*};
        }
        alike!(GeneralizedAlpha::new(0.8).step(0.01), Sdirk4::default().step(0.01), Sdirk4::default().tolerance(1e-8));
    }
    Ok(())
}

/// An arm whose joints are geared, on a strut that turns and a law in it: the order of rules, at steps that resolve it.
#[test]
fn rules_keep_their_orders_under_stiff_struts_and_couplings() -> Result<(), Error> {
    let (rod, turn) = (Rod::uniform(1.0_f64, 1.0), Revolute::smooth());
    let scene = System::new(Pinned::<[f64; 2]>::origin(), (rod, turn, rod, turn, rod), Free)?.with_gravity(GRAVITY);
    let across = Strut::between((0, [0.4, 0.1]), (2, [0.3, -0.1])).with_stiffness(300.0).with_damping(4.0);
    let struts = Struts::of([across.with_length(0.9).with_law(Spring::new(50.0).damped(1.0).resting_at(0.8))]);
    let gears = Couplings::of(&scene, [Coupling::new(2, 1).ratio(-0.7)])?;
    let (plain, stiff) = (gears.and(struts), gears.and(struts.stiff()));
    let start = gears.joined(scene.at_rest(&[0.4, -0.3, 0.0])?);
    let exact = scene.simulation(Dop853::tolerance(1e-12)).loads(&plain).run(start, 0.4, |_| ())?.motion.coordinates();
    let same = scene.simulation(Dop853::tolerance(1e-12)).loads(&stiff).run(start, 0.4, |_| ())?.motion.coordinates();
    assert_eq!(exact, same); // explicit rules take struts as they are
    let missed = |found: Vec<f64>| farthest(&found, &exact);
    let (mut second, mut fourth) = (vec![], vec![]);
    for h in [0.01, 0.005, 0.0025] {
        let run = scene.simulation(GeneralizedAlpha::new(0.8).step(h)).loads(&stiff).run(start, 0.4, |_| ())?;
        second.push((h, missed(run.motion.coordinates())));
        let run = scene.simulation(Sdirk4::default().step(h)).loads(&stiff).run(start, 0.4, |_| ())?;
        fourth.push((h, missed(run.motion.coordinates())));
    }
    has_order("generalised-alpha", 2.0, 1e-11, &second);
    has_order("Sdirk4", 4.0, 1e-11, &fourth);
    Ok(())
}

/// A crank against a stop, with a flywheel that it turns by a gear: as one body of the inertia of both, bounces and rest included; and under
/// friction in the crank.
#[test]
fn stops_and_friction_hold_followers_too() -> Result<(), Error> {
    let (mass, light, ratio) = (2.0, 0.3, -3.0);
    let block = |mass| RigidBody::new(mass, 0.1, [0.0; 2], [0.0; 2]);
    let line = Slider::along(std::f64::consts::FRAC_PI_2);
    let both = mass + ratio * ratio * light;
    let weight = (mass + ratio * light) * GRAVITY / both; // what pulls the one body
    macro_rules! alike {
        ($leader:expr, $start:expr, $rate:expr) => {
            alike!($leader, line, $leader, $start, $rate)
        };
        ($leader:expr, $follower:expr, $both:expr, $start:expr, $rate:expr) => {{
            let chain = (Branch(($leader, block(mass))), $follower, block(light));
            let scene = System::new(Clamped::origin(), chain, Free)?.with_gravity(GRAVITY);
            let one = System::new(Clamped::origin(), ($both, block(both)), Free)?.with_gravity(weight);
            let couplings = Couplings::of(&scene, [Coupling::new(2, 1).ratio(ratio)])?;
            let (mut start, mut alone) = (scene.motion(), one.motion());
            start.set_coordinates(&[$start, 0.0])?;
            start.set_rates(&[$rate, 0.0])?;
            alone.set_coordinates(&[$start])?;
            alone.set_rates(&[$rate])?;
            let start = couplings.joined(start);
            for end in [0.2, 0.5, 0.9, 2.0] {
                let run = scene.simulation(Dop853::tolerance(1e-11)).loads(&couplings).run(start, end, |_| ())?;
                let single = one.simulation(Dop853::tolerance(1e-11)).run(alone, end, |_| ())?;
                let (found, expected) = (&run.motion, &single.motion);
                near(found.coordinates()[0], expected.coordinates()[0], 1e-9);
                near(found.rates()[0], expected.rates()[0], 1e-8);
                near(found.coordinates()[1], ratio * expected.coordinates()[0], 3e-9);
                near(found.rates()[1], ratio * expected.rates()[0], 3e-8);
            }
        }};
    }
    alike!(HardStops::between(line, [0.0, f64::INFINITY]).rebounding(0.6), 0.5, 0.0);
    alike!(Coulomb::new(line, 9.0), 0.5, 1.5);
    alike!(Coulomb::new(line, 60.0), 0.5, 1.5);
    // Friction in both is friction in one, also where it would hold neither alone.
    for (leader, follower) in [(9.0, 1.0), (60.0, 1.0), (60.0, 60.0), (5.0, 3.0), (9.0, 60.0), (5.0, 20.0)] {
        alike!(
            Coulomb::new(line, leader),
            Coulomb::new(line, follower),
            Coulomb::new(line, leader - ratio * follower),
            0.5,
            1.5
        );
        alike!(
            Coulomb::new(line, leader),
            Coulomb::new(line, follower),
            Coulomb::new(line, leader - ratio * follower),
            0.5,
            0.0
        );
    }
    Ok(())
}

/// Two arms that are geared to each other and rub both: they come to rest and turn at one instant.
#[test]
fn geared_arms_that_both_rub_stick_and_slip_together() -> Result<(), Box<dyn std::error::Error>> {
    let (rod, rubs) = (Rod::uniform(0.5, 1.0), Coulomb::new(Revolute::smooth(), 0.4));
    let scene = System::new(Clamped::origin(), (rubs, rod, rubs, rod), Free)?.with_gravity(GRAVITY);
    let couplings = Couplings::of(&scene, [Coupling::new(2, 1).ratio(-0.5)])?;
    let start = couplings.joined(scene.motion());
    for end in [1.0, 2.5, 12.0] {
        let run = scene.simulation(Dop853::tolerance(1e-10)).loads(&couplings).run(start, end, |_| ())?.motion;
        let small = scene.simulation(MoreauJean::step(1e-4)).loads(&couplings).run(start, end, |_| ())?.motion;
        let [leader, follower] = run.coordinates()[..] else { unreachable!() };
        near(follower, -0.5 * leader, 1e-11);
        near(small.coordinates()[0], leader, 2e-3);
        assert!(end < 12.0 || run.rates().iter().all(|rate| rate.abs() < 1e-11), "{:?}", run.rates());
    }
    Ok(())
}

#[test]
fn derivatives_go_through_couplings() -> Result<(), Error> {
    type T = Jet<f64, 2>;
    let scene = hand!(Revolute::smooth(), Revolute::smooth());
    let varied = scene.lift(T::of);
    let (angle, ratio) = (0.3, RATIO);
    let seeded = |x: f64, k: usize| T { re: x, eps: std::array::from_fn(|i| if i == k { 1.0 } else { 0.0 }) };
    let coupling = Coupling::new(2, 1).ratio(seeded(ratio, 1)).offset(T::of(OFFSET));
    let couplings = Couplings::of(&varied, [coupling])?;
    let mut start = varied.motion();
    start.set_coordinates(&[seeded(angle, 0), T::of(0.0)])?;
    let start = couplings.joined(start);
    let found = varied.with_accelerations(start, &couplings)?.accelerations()[0];
    let exact = |angle: f64, ratio: f64| {
        let other = ratio * angle + OFFSET;
        let ([inertia, weight], [other_inertia, other_weight]) = (about_joint(LEFT, angle), about_joint(RIGHT, other));
        (weight + ratio * other_weight) / (inertia + ratio * ratio * other_inertia)
    };
    let h = 1e-5;
    near(found.re, exact(angle, ratio), 1e-13);
    near(found.eps[0], (exact(angle + h, ratio) - exact(angle - h, ratio)) / (2.0 * h), 1e-8);
    near(found.eps[1], (exact(angle, ratio + h) - exact(angle, ratio - h)) / (2.0 * h), 1e-8);
    // Through kept gains, where scenes have them: the same.
    let pins = spatial::System::new(
        spatial::Clamped::origin(),
        (Branch((spatial_joint(), box_of(1.0))), spatial_joint(), box_of(0.4)),
        spatial::Free,
    )?
    .with_gravity([0.0, -9.81, 0.0])
    .lift(T::of);
    let couplings = Couplings::of(&pins, [Coupling::new(2, 1).ratio(seeded(ratio, 1)).offset(T::of(OFFSET))])?;
    let mut start = pins.motion();
    start.set_coordinates(&[seeded(angle, 0), T::of(0.0)])?;
    let start = couplings.joined(start);
    let plain = pins.with_accelerations(start, &couplings)?.accelerations();
    let (sensitivity, mut kept) = (pins.sensitivity(), start);
    let mut workspace = catena::system::Dynamics::<Couplings<T, 1>>::workspace(&sensitivity);
    sensitivity.accelerate(&mut kept, &couplings, &mut workspace)?;
    for (kept, plain) in kept.accelerations().iter().zip(plain) {
        near(kept.re, plain.re, 1e-13);
        kept.eps.iter().zip(plain.eps).for_each(|(kept, plain)| near(*kept, plain, 1e-12 * (1.0 + plain.abs())));
    }
    Ok(())
}

/// Two plates on a spring rest where its torque and both weights balance, and swing as one body: equilibria, their derivatives, and modes.
#[test]
fn plates_rest_and_swing_as_the_one_that_they_are() -> Result<(), Error> {
    const STIFFNESS: f64 = 12.0;
    macro_rules! rest {
        ($number:expr, $ratio:expr) => {{
            let left = ElasticHinge::rotary($number(STIFFNESS)).resting_at($number(0.1));
            let plate = |[mass, inertia, x, y]: [f64; 4]| {
                RigidBody::new($number(mass), $number(inertia), [x, y].map($number), [0.5, 0.0].map($number))
            };
            let chain = (Branch((left, plate(LEFT))), Revolute::smooth(), plate(RIGHT));
            let ground = Clamped::at($number(0.0), $number(0.0), $number(0.0));
            let scene = System::new(ground, chain, Free)?.with_gravity($number(GRAVITY));
            let couplings = Couplings::of(&scene, [Coupling::new(2, 1).ratio($ratio).offset($number(OFFSET))])?;
            let rest = scene.equilibrium(couplings.joined(scene.motion()), &couplings)?;
            (scene, couplings, rest)
        }};
    }
    let (scene, couplings, rest) = rest!(|x: f64| x, RATIO);
    let [angle, other] = rest.coordinates()[..] else { unreachable!() };
    near(other, RATIO * angle + OFFSET, 1e-15);
    let ([inertia, weight], [other_inertia, other_weight]) = (about_joint(LEFT, angle), about_joint(RIGHT, other));
    near(-STIFFNESS * (angle - 0.1) + weight + RATIO * other_weight, 0.0, 1e-13);
    // Slopes of weights' torques: m g (x sin φ + y cos φ).
    let slope = |[mass, _, x, y]: [f64; 4], angle: f64| mass * GRAVITY * (x * angle.sin() + y * angle.cos());
    let stiffness = STIFFNESS - slope(LEFT, angle) - RATIO * RATIO * slope(RIGHT, other);
    let modes = scene.modes(&rest, &couplings)?;
    let frequency = (stiffness / (inertia + RATIO * RATIO * other_inertia)).sqrt();
    assert_eq!(modes.len(), 1);
    for mode in modes.iter() {
        near(mode.frequency(), frequency, 1e-12 * frequency);
        near(mode.shape()[1] / mode.shape()[0], RATIO, 1e-14);
    }
    type T = Jet<f64, 1>;
    let (.., seeded) = rest!(T::of, T::seed(RATIO, 0));
    let by_ratio = (other_weight + RATIO * slope(RIGHT, other) * angle) / stiffness;
    near(seeded.coordinates()[0].eps[0], by_ratio, 1e-12);
    Ok(())
}

fn spatial_joint() -> spatial::Revolute<f64> {
    spatial::Revolute::about([0.0, 0.0, 1.0])
}

fn box_of(mass: f64) -> spatial::RigidBody<f64> {
    let tensor = [[0.02, 0.0, 0.0], [0.0, 0.03, 0.0], [0.0, 0.0, 0.04]];
    spatial::RigidBody::new(mass, tensor, [0.2, 0.05, 0.0], [0.4, 0.0, 0.0])
}

/// Lanes hold scenes of their own, each as coupled as alone.
#[test]
fn lanes_are_coupled_each_by_itself() -> Result<(), Error> {
    type T = Pack<f64, 4>;
    let scene = hand!(Revolute::smooth(), Revolute::smooth());
    let couplings = |ratio| Couplings::of(&scene, [Coupling::new(2, 1).ratio(ratio).offset(OFFSET)]);
    let (angles, ratios) = ([0.3, -0.9, 1.4, 0.0], [RATIO, 0.0, 2.5, 1.0]);
    let wide = scene.lift(T::of);
    let (mut angle, mut ratio) = (T::of(0.0), T::of(0.0));
    (angle.0, ratio.0) = (angles, ratios);
    let together = Couplings::of(&wide, [Coupling::new(2, 1).ratio(ratio).offset(T::of(OFFSET))])?;
    let mut start = wide.motion();
    start.set_coordinates(&[angle, T::of(0.0)])?;
    let found = wide.with_accelerations(together.joined(start), &together)?.accelerations();
    for lane in 0..4 {
        let alone = couplings(ratios[lane])?;
        let mut start = scene.motion();
        start.set_coordinates(&[angles[lane], 0.0])?;
        let expected = scene.with_accelerations(alone.joined(start), &alone)?.accelerations();
        for (found, expected) in found.iter().zip(expected) {
            near(found.0[lane], expected, 1e-13 * (1.0 + expected.abs()));
        }
    }
    Ok(())
}

/// A description's gripper: its module says which joint follows which.
#[test]
fn a_gripper_closes_by_both_of_its_fingers() -> Result<(), Error> {
    let scene = cart::scene::<f64>()?;
    let couplings = spatial::Couplings::of(&scene, cart::couplings())?;
    let mut start = scene.motion();
    start.set_coordinates(&[0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 0.02, 0.0])?;
    let start = couplings.joined(start);
    let mut torques = [0.0; 8];
    torques[cart::joint::LEFT_GRIP] = -3.0; // one finger is driven
    let loads = couplings.and(spatial::Loads::none().efforts(cart::efforts(torques)));
    let [left, right] = [cart::joint::LEFT_GRIP, cart::joint::RIGHT_GRIP];
    let mut apart = 0.0_f64;
    let run = scene.simulation(Sdirk4::new().tolerance(1e-6)).loads(&loads).run(start, 0.2, |now| {
        let q = now.motion().coordinates();
        apart = apart.max((q[left] - q[right]).abs());
    })?;
    let q = run.motion.coordinates();
    println!("apart {apart:.1e}, at {:.2e}", q[left]);
    assert!(apart < 1e-15 && q[left] < 1e-3);
    // Without the coupling the other finger stays.
    let free = scene.simulation(Sdirk4::new().tolerance(1e-6)).loads(&loads_of(torques)).run(start, 0.2, |_| ())?;
    assert!(free.motion.coordinates()[right] > 0.015);
    Ok(())
}

fn loads_of(torques: [f64; 8]) -> spatial::Loads<Absent, catena::loading::Values<[spatial::Effort<f64>; 12]>> {
    spatial::Loads::none().efforts(cart::efforts(torques))
}

#[test]
fn what_is_no_coupling_is_refused() -> Result<(), Error> {
    let refused = |outcome: Result<Couplings<f64, 1>, Error>| outcome.expect_err("no coupling");
    let unsupported = |error: Error| matches!(error.fault, Fault::Unsupported { .. });
    let scene = hand!(Pin, Revolute::smooth());
    let error = refused(Couplings::of(&scene, [Coupling::new(2, 1)]));
    assert!(unsupported(error) && error.place == Some(Place::Station(0)), "{error}");
    assert!(unsupported(refused(Couplings::of(&scene, [Coupling::new(2, 2)]))));
    assert!(unsupported(refused(Couplings::of(&scene, [Coupling::new(2, 0)])))); // the ground's weld
    assert_eq!(refused(Couplings::of(&scene, [Coupling::new(2, 3)])).fault, Fault::NoSuchJoint { joint: 3, joints: 3 });
    assert!(matches!(refused(Couplings::of(&scene, [Coupling::new("thumb", 2)])).fault, Fault::NoSuchName { .. }));
    let scene = hand!(Revolute::smooth(), Revolute::smooth());
    let error = refused(Couplings::of(&scene, [Coupling::new(2, 1).ratio(f64::NAN)]));
    assert!(matches!(error.fault, Fault::NotFinite { .. }), "{error}");
    let couplings = Couplings::of(&scene, [Coupling::new(2, 1).ratio(RATIO).offset(OFFSET)])?;
    // A start that is not as the coupling has it.
    for (q, v) in [([0.0; 2], [0.0; 2]), ([0.0, OFFSET], [1.0, 0.0])] {
        let mut start = scene.motion();
        start.set_coordinates(&q)?;
        start.set_rates(&v)?;
        let error = scene.with_accelerations(start, &couplings).expect_err("apart");
        assert!(matches!(error.fault, Fault::NotAssembled { .. }), "{error}");
        let error =
            scene.simulation(Rk4::step(0.01)).loads(&couplings).run(start, 0.1, |_| ()).expect_err("apart").error;
        assert!(matches!(error.fault, Fault::NotAssembled { .. }), "{error}");
    }
    // What is no number is not said to be apart.
    let mut start = scene.motion();
    start.set_rates(&[1.0, RATIO])?;
    Position::replace(start.position_mut(), &mut |_| f64::NAN);
    let error = scene.with_accelerations(start, &couplings).expect_err("no number");
    assert_eq!(error.fault, Fault::NonFiniteMotion);
    // Far and fast in single precision a joint follows within its roundings.
    let single = scene.lift(|x| x as f32);
    let geared = Couplings::of(&single, [Coupling::new(2, 1).ratio(0.3_f32)])?;
    let mut start = single.motion();
    start.set_coordinates(&[2e3 + 0.1, 0.0])?;
    start.set_rates(&[7e4 + 0.3, 0.0])?;
    let mut start = geared.joined(start);
    let [leader, follower] = start.rates()[..] else { unreachable!() };
    start.set_rates(&[leader, follower * (1.0 + 4.0 * f32::EPSILON)])?;
    single.with_accelerations(start, &geared)?;
    let mut apart = scene.motion();
    apart.set_coordinates(&[0.3, 0.0])?;
    let error = scene.modes(&apart, &couplings).expect_err("modes");
    assert!(matches!(error.fault, Fault::NotAssembled { .. }), "{error}");
    let rest = scene.equilibrium(apart, &couplings)?.coordinates(); // it is put together first
    near(rest[1], RATIO * rest[0] + OFFSET, 1e-14);
    // By one and the same ratio to two places at once.
    let both = Couplings::of(&scene, [0.0, 0.1].map(|offset| Coupling::new(2, 1).offset(offset)))?;
    let error = scene.equilibrium(scene.motion(), &both).expect_err("two places");
    assert!(matches!(error.fault, Fault::NotClosed { .. }), "{error}");
    let start = couplings.joined(scene.motion());
    let error = scene.transfer_matrix::<_, 7>(&start, &couplings, |_, _| ()).expect_err("a matrix");
    assert!(error.to_string().contains("couplings"), "{error}");
    // In another scene of the same type.
    let row = |links: usize| {
        System::new(
            Pinned::origin(),
            (Rod::uniform(1.0, 1.0), vec![(Revolute::smooth(), Rod::uniform(1.0, 1.0)); links]),
            Free,
        )
    };
    let (short, long) = (row(2)?, row(3)?);
    let error =
        long.with_accelerations(long.motion(), &Couplings::of(&short, [Coupling::new(2, 1)])?).expect_err("others");
    assert_eq!(error.fault, Fault::Shape);
    Ok(())
}

/// Steps that error control chooses for a gradient are those of the scene whose joints follow others.
#[test]
fn adaptive_steps_for_gradients_are_coupled() -> Result<(), Error> {
    let finger = Rod::uniform(0.3, 0.5);
    let hand = (Branch((Revolute::smooth().named("left"), finger)), Revolute::smooth().named("right"), finger);
    let scene = System::new(Clamped::origin(), hand, Free)?.with_gravity(9.81);
    let couplings = Couplings::of(&scene, [Coupling::new("right", "left").ratio(-0.5)])?;
    let start = couplings.joined(scene.at_rest(&[0.3, 0.0])?);
    let run = scene.simulation(Dop853::tolerance(1e-10)).loads(&couplings).run(start, 0.3, |_| ())?.motion;
    let (mut states, mut backward) = (vec![start; 101], scene.backward(Dop853).under(couplings));
    let steps = backward.run_adaptive(&start, 1e-10, 0.3, &[], &mut states)?;
    for (found, expected) in states[steps].coordinates().iter().zip(run.coordinates()) {
        near(*found, expected, 1e-12);
    }
    let gradient = backward.gradient(&[], &states[..=steps], &mut [], |step, _, by| {
        if step == steps { by.add(&[1.0, 0.0], &[0.0; 2]) } else { Ok(()) }
    })?;
    let end = |gravity: f64| {
        let pulled = scene.clone().with_gravity(gravity);
        let run = pulled.simulation(Dop853::tolerance(1e-12)).loads(&couplings).run(start, 0.3, |_| ());
        run.map(|run| run.motion.coordinates()[0]).map_err(|stopped| stopped.error)
    };
    near(-gradient.by_gravity().y, (end(9.81 + 1e-4)? - end(9.81 - 1e-4)?) / 2e-4, 1e-8);
    Ok(())
}

/// Shafts that are not as gears have them: they are turned there by the least change, as measured by their inertias, and made as fast.
#[test]
fn shafts_are_assembled_on_gears() -> Result<(), Error> {
    let (inertias, ratio, offset) = ([0.2, 0.1], -2.0, 0.3);
    let wheel = |inertia| RigidBody::new(1.0, inertia, [0.0; 2], [0.0; 2]);
    let (shaft, [a, b]) = (Revolute::smooth(), inertias.map(wheel));
    let scene = System::new(Clamped::origin(), (Branch((shaft.named("first"), a)), shaft.named("second"), b), Free)?;
    let follows = Coupling::new("second", "first").ratio(ratio).offset(offset);
    let gears = Couplings::of(&scene, [follows])?;
    let mut guess = scene.motion();
    guess.set_coordinates(&[0.5, 0.4])?;
    guess.set_rates(&[1.0, 3.0])?;
    let start = scene.assembled(guess, &gears)?;
    let yields = ratio * ratio / inertias[0] + 1.0 / inertias[1];
    for (found, [first, second], offset) in
        [(start.coordinates(), [0.5, 0.4], offset), (start.rates(), [1.0, 3.0], 0.0)]
    {
        let force = -(second - ratio * first - offset) / yields;
        near(found[0], first - ratio * force / inertias[0], 1e-14);
        near(found[1], second + force / inertias[1], 1e-14);
    }
    // Accelerations belong to where they have been turned.
    let heavy = [0.3, -0.2].map(|x| RigidBody::new(1.0, 0.1, [x, 0.05], [0.0; 2]));
    let hung = (Branch((shaft.named("first"), heavy[0])), shaft.named("second"), heavy[1]);
    let hung = System::new(Clamped::origin(), hung, Free)?.with_gravity(GRAVITY);
    let geared = Couplings::of(&hung, [follows])?;
    let mut apart = hung.motion();
    apart.set_coordinates(&[0.5, 0.4])?;
    let start = hung.assembled(apart, &geared)?;
    let found = hung.with_accelerations(start, &geared)?.accelerations();
    assert_eq!(start.accelerations(), found);
    // A shaft that is to stay as it is and as fast.
    let held = scene.assembled_holding(guess, Holding::both(&[0]), &gears)?.motion;
    near(held.coordinates()[0], 0.5, 0.0);
    near(held.coordinates()[1], ratio * 0.5 + offset, 1e-15);
    near(held.rates()[1], ratio, 1e-15);
    let fault = scene.assembled_holding(guess, Holding::both(&[0, 1]), &gears).map(|_| ()).map_err(|error| error.fault);
    assert!(
        matches!(fault, Err(Fault::ImpossibleHold { what: "coordinates", residual }) if residual > 1.0),
        "{fault:?}"
    );
    // What gears say of each other.
    let twice = Couplings::of(&scene, [follows, Coupling::new("first", "second").ratio(-0.5).offset(0.15)])?;
    scene.assembled(guess, &twice)?;
    let held_twice = scene.assembled_holding(guess, Holding::both(&[0]), &twice)?.motion;
    near(held_twice.coordinates()[1], ratio * 0.5 + offset, 1e-14);
    let against = Couplings::of(&scene, [follows, Coupling::new("first", "second").ratio(-0.5)])?;
    let error = scene.assembled(guess, &against).map(|_| ()).expect_err("gears that say different things");
    assert!(matches!(error.fault, Fault::NotClosed { residual } if residual > 0.1), "{error}");
    // No run begins apart, and the joint that is farthest apart is named.
    let run = scene.simulation(Rk4::step(0.01)).loads(&gears).run(guess, 0.1, |_| ());
    let error = run.map(|_| ()).expect_err("shafts apart").error;
    assert_eq!(error.place, scene.joint("second")?.station.map(Place::Station), "{error}");
    Ok(())
}
