//! Gradients of runs past changes of mode: against a closed form, against differences of runs, and against the same runs over jets, which go forward
//! by the rule itself.
//!
//! Bounds: differences by 1e-5 of the closed form of a parabola err by 1e-10 of a third derivative and by rounding, 1e-9; those of runs to 1e-13 by 1e-8,
//! grown by what shocks amplify, 1e-6. Jets differ by the order of sums alone, amplified by shocks: 1e-9 of the largest of all derivatives for one or
//! two shocks, 1e-8 for many, and for friction that breaks away, whose pace is that of another step.

use catena::planar::*;
use catena::scalar::{Jet, Scalar};
use catena::{Error, Fault, Lift, robot, spatial};
use catena_oracle::{Noise, near};
use std::f64::consts::FRAC_PI_2;

/// So many derivatives at a time.
const WIDTH: usize = 8;

type Many = Jet<f64, WIDTH>;

/// Derivatives of the last coordinate and the last rate by all numbers, against the same over jets: `$made` makes scene, start, what it is
/// under, the same as loads, and the parts of that which numbers make, and `$more` is the gradient by such parts. Gives how many modes have changed.
macro_rules! as_forward_of {
    ($rule:expr, $method:expr, $end:expr, $bound:expr, $numbers:expr, $made:ident, |$gradient:ident, $parts:ident| $more:expr) => {{
        let numbers: &[f64] = &$numbers;
        let (scene, start, acting, ..) = $made!(numbers, f64);
        let mut backward = scene.backward($method).under(acting);
        let course = backward.course(&start, $rule, $end, &[])?;
        let (last, n) = (course.states().len() - 1, start.rates().len());
        let mut pairs: Vec<(f64, f64)> = vec![];
        for of in 0..2 {
            let mut unit = [vec![0.0; n], vec![0.0; n]];
            unit[of][n - 1] = 1.0;
            let $gradient = backward.gradient_past(&course, &mut [], |step, _, by| {
                if step == last { by.add(&unit[0], &unit[1]) } else { Ok(()) }
            })?;
            for first in (0..numbers.len()).step_by(WIDTH) {
                let seeds: Vec<_> = (0..)
                    .zip(numbers)
                    .map(|(k, x)| $crate::past_changes::Many::seed(*x, usize::wrapping_sub(k, first)))
                    .collect();
                let (scene, start, _, loads, $parts) = $made!(&seeds, $crate::past_changes::Many);
                let (along, by_start) = ($gradient.along(&scene)?, $gradient.along_start(&start)?);
                let by_loads: [f64; WIDTH] = $more;
                let run = scene.simulation($rule).loads(&loads).run(start, $end, |_| ());
                let end = run.map_err(|stopped| stopped.error)?.motion;
                let Some(end) = if of == 0 { end.coordinates() } else { end.rates() }.pop() else { unreachable!() };
                for k in 0..WIDTH.min(numbers.len() - first) {
                    pairs.push((along[k] + by_start[k] + by_loads[k], end.eps[k]));
                }
            }
        }
        let most = pairs.iter().fold(1.0_f64, |most, (_, x)| most.max(x.abs()));
        for (k, (found, expected)) in pairs.iter().enumerate() {
            assert!((found - expected).abs() <= $bound * most, "{k}: {found} {expected}");
        }
        course.changes().count()
    }};
}

/// The same of a scene and a start, under a law of loads on bodies.
macro_rules! as_forward_under {
    ($rule:expr, $method:expr, $end:expr, $bound:expr, $numbers:expr, |$x:ident, $T:ident| $scene:expr) => {{
        macro_rules! made {
            ($list:expr, $Number:ty) => {{
                #[allow(dead_code)]
                type $T = $Number;
                let $x: &[$T] = $list;
                let (scene, start, law) = $scene;
                (scene, start, law, Loads::none().on_bodies_by(law), law)
            }};
        }
        as_forward_of!($rule, $method, $end, $bound, $numbers, made, |gradient, law| {
            let (mut sums, mut by_loads) = ([0.0; WIDTH], gradient.by_loads()?.iter());
            Lift::<$crate::past_changes::Many, f64>::lift(&law, &mut |number: $crate::past_changes::Many| {
                let by = by_loads.next().copied().unwrap_or(f64::NAN);
                sums.iter_mut().zip(number.eps).for_each(|(sum, slope)| *sum += by * slope);
                by
            });
            sums
        })
    }};
}

/// The same without loads.
macro_rules! as_forward {
    ($rule:expr, $method:expr, $end:expr, $bound:expr, $numbers:expr, |$x:ident, $T:ident| $scene:expr) => {
        as_forward_under!($rule, $method, $end, $bound, $numbers, |$x, $T| {
            let (scene, start) = $scene;
            (scene, start, Absent)
        })
    };
}

mod between;
mod starts;
mod wind;

/// A body that hangs from its inboard end.
fn hanging<T: Scalar>(mass: T, [x, y, z]: [T; 3]) -> spatial::RigidBody<T> {
    let (zero, of) = (T::zero(), T::literal);
    let tensor = [[x, zero, zero], [zero, y, zero], [zero, zero, z]];
    spatial::RigidBody::new(mass, tensor, [zero, zero, of(-0.2)], [zero, zero, of(-0.4)])
}

#[test]
fn a_block_that_bounces() -> Result<(), Error> {
    let end = |time: f64, [height, share, gravity]: [f64; 3]| {
        // Past the first shock, before the second one.
        let first = f64::sqrt(2.0 * height / gravity);
        let (left, speed) = (time - first, share * gravity * first);
        speed * left - 0.5 * gravity * left * left
    };
    macro_rules! fall {
        ($x:expr, $T:ty) => {{
            let (x, of): (&[$T], _) = (&$x, <$T as Scalar>::literal);
            let block = RigidBody::new(of(2.0), of(0.1), [of(0.0); 2], [of(0.0); 2]);
            let slide = HardStops::between(Slider::along(of(FRAC_PI_2)), [of(0.0), of(f64::INFINITY)]).rebounding(x[1]);
            let scene = System::new(Clamped::origin(), (slide, block), Free)?.with_gravity(x[2]);
            let mut start = scene.motion();
            start.set_coordinates(&[x[0]])?;
            (scene, start)
        }};
    }
    let at = [1.0, 0.7, 9.81];
    let (scene, start) = fall!(at, f64);
    macro_rules! runs {
        ($($method:expr, $rule:expr);*) => {$(
            let mut backward = scene.backward($method);
            let course = backward.course(&start, $rule, 0.9, &[])?;
            assert_eq!(course.changes().count(), 2); // it begins, and strikes once
            let last = course.states().len() - 1;
            let gradient = backward.gradient_past(&course, &mut [], |step, _, by| {
                if step == last { by.add(&[1.0], &[0.0]) } else { Ok(()) }
            })?;
            let (seeded, begun) = fall!([0, 1, 2].map(|k| Jet::<f64, 3>::seed(at[k], k)), Jet<f64, 3>);
            let (along, by_start) = (gradient.along(&seeded)?, gradient.along_start(&begun)?);
            for k in 0..3 {
                let [mut above, mut below] = [at; 2];
                (above[k], below[k]) = (at[k] + 1e-5, at[k] - 1e-5);
                near(along[k] + by_start[k], (end(0.9, above) - end(0.9, below)) / 2e-5, 1e-9);
            }
            near(gradient.by_position()[0], along[0] + by_start[0], 1e-14);
        )*};
    }
    runs!(Rk4, Rk4::step(0.02); Dopri5, Dopri5::tolerance(1e-9); Dop853, Dop853::tolerance(1e-10));
    Ok(())
}

#[test]
fn blocks_that_rub_and_strike() -> Result<(), Error> {
    // Mass, friction, what gives back, both stops, speed, place, and a spring with damper and rest.
    let drawer = [2.0, 4.0, 0.5, 0.0, 0.4, -2.0, 0.3, 3.0, 0.2, 0.1];
    let changes = as_forward!(Dop853::tolerance(1e-11), Dop853, 2.0, 1e-9, drawer, |x, T| {
        let of = <T as Scalar>::literal;
        let law = Spring::new(x[7]).damped(x[8]).resting_at(x[9]);
        let rail = Coulomb::new(Slider::along(of(0.0)), x[1]).between([x[3], x[4]]).rebounding(x[2]).with(law);
        let scene =
            System::new(Clamped::origin(), (rail, RigidBody::new(x[0], of(0.1), [of(0.0); 2], [of(0.0); 2])), Free)?;
        let mut start = scene.with_rates(scene.motion(), &[x[5]])?;
        start.set_coordinates(&[x[6]])?;
        (scene, start)
    });
    assert!(changes >= 3, "{changes}");
    // Half a period at a time, about a place that friction moves.
    let track = [2.0, 50.0, 1.5, 0.5];
    for end in [0.2, 0.9, 2.0, 6.0] {
        as_forward!(Dop853::tolerance(1e-12), Dop853, end, 1e-9, track, |x, T| {
            let of = <T as Scalar>::literal;
            let block = RigidBody::new(x[0], of(0.1), [of(0.0); 2], [of(0.0); 2]);
            let track = Coulomb::new(Slider::along(of(0.0)), x[2]).with(Spring::new(x[1]));
            let scene = System::new(Clamped::origin(), (track, block), Free)?;
            let mut start = scene.motion();
            start.set_coordinates(&[x[3]])?;
            (scene, start)
        });
    }
    Ok(())
}

#[test]
fn a_double_pendulum_against_differences() -> Result<(), Error> {
    // By length, restitution, friction of the shoulder and gravity, over shocks, slips and halts.
    macro_rules! pendulum {
        ($x:expr, $T:ty) => {{
            let (x, of): ([$T; 4], _) = ($x, <$T as Scalar>::literal);
            let rod = Rod::uniform(x[0], of(1.0));
            let shoulder = Coulomb::new(Revolute::smooth(), x[2]);
            let elbow = HardStops::between(Revolute::smooth(), [of(0.0), of(FRAC_PI_2)]).rebounding(x[1]);
            let whole = System::new(Clamped::origin(), (shoulder, rod, elbow, rod), Free)?.with_gravity(x[3]);
            let mut start = whole.motion();
            start.set_coordinates(&[of(-0.2), of(0.9)])?;
            (whole, start)
        }};
    }
    let (at, rule, end) = ([1.0, 0.8, 0.3, 9.81], Dop853::tolerance(1e-13), 2.0);
    let (whole, start) = pendulum!(at, f64);
    let mut backward = whole.backward(Dop853);
    let course = backward.course(&start, rule, end, &[])?;
    assert!(course.changes().count() > 5, "{}", course.changes().count());
    let last = course.states().len() - 1;
    let seeded = pendulum!([0, 1, 2, 3].map(|k| Jet::<f64, 4>::seed(at[k], k)), Jet<f64, 4>).0;
    for of in 0..4 {
        let mut unit = [0.0; 4];
        unit[of] = 1.0;
        let found = backward.gradient_past(&course, &mut [], |step, _, by| {
            if step == last { by.add(&unit[..2], &unit[2..]) } else { Ok(()) }
        })?;
        for (k, found) in found.along(&seeded)?.into_iter().enumerate() {
            let number = |by: f64| -> Result<f64, Error> {
                let mut other = at;
                other[k] += by;
                let (whole, start) = pendulum!(other, f64);
                let end = whole.simulation(rule).run(start, end, |_| ())?.motion;
                Ok([end.coordinates(), end.rates()].concat()[of])
            };
            let expected = (number(1e-5)? - number(-1e-5)?) / 2e-5;
            near(found, expected, 1e-6 * (1.0 + expected.abs()));
        }
    }
    Ok(())
}

#[test]
fn random_arms() -> Result<(), Error> {
    let mut most = 0;
    // All of 224 agree (0 to 23, 100 to 299).
    for seed in 0..3 {
        let mut random = Noise::new(seed);
        let mut numbers = vec![];
        let mut between = |least: f64, most: f64| numbers.push(random.between(least, most));
        (0..4).for_each(|_| {
            between(0.4, 1.0);
            between(0.5, 1.5);
        });
        // Friction of the shoulder and by how much more it breaks away, stops of the elbow, and of the wrist, which rubs.
        for (least, most) in [(0.05, 0.8), (1.0, 1.5), (-1.0, -0.2), (0.2, 1.0), (0.2, 0.9), (0.02, 0.4), (-1.0, -0.2)]
        {
            between(least, most);
        }
        for (least, most) in
            [(0.2, 1.0), (0.2, 0.9), (8.0, 10.0), (-0.5, 0.5), (-1.0, 1.0), (-0.19, 0.19), (-0.19, 0.19)]
        {
            between(least, most);
        }
        (0..4).for_each(|_| between(-2.0, 2.0));
        let changes = as_forward!(Dop853::tolerance(1e-11), Dop853, 0.9, 1e-8, numbers, |x, T| {
            let rods = [0, 2, 4, 6].map(|k| Rod::uniform(x[k], x[k + 1]));
            let shoulder = Coulomb::new(Revolute::smooth(), x[8]).breaking_away(x[8] * x[9]);
            let elbow = HardStops::between(Revolute::smooth(), [x[10], x[11]]).rebounding(x[12]);
            let wrist = Coulomb::new(Revolute::smooth(), x[13]).between([x[14], x[15]]).rebounding(x[16]);
            let chain = (rods[0], shoulder, rods[1], elbow, rods[2], wrist, rods[3]);
            let arm = System::new(Pinned::origin(), chain, Free)?.with_gravity(x[17]);
            let mut start = arm.motion();
            start.set_coordinates(&x[18..22])?;
            let start = arm.with_rates(start, &x[22..26])?;
            (arm, start)
        });
        most = most.max(changes);
    }
    assert!(most > 10, "{most}");
    Ok(())
}

#[test]
fn arms_in_space() -> Result<(), Error> {
    use spatial::{Ball, Coulomb, Free, HardStops, Pinned, Prismatic, Revolute, System};
    // A shoulder that is free, an elbow between stops, a slide that rubs between stops, a wrist that rubs.
    let numbers = [0.9, 0.02, 0.03, 0.01, -0.3, 0.5, 0.6, 0.1, 0.7, -0.1, 0.12, 0.4, -9.81];
    let changes = as_forward!(Dop853::tolerance(1e-11), Dop853, 0.8, 1e-8, numbers, |x, T| {
        let of = <T as Scalar>::literal;
        let zero = of(0.0);
        let body = hanging(x[0], [x[1], x[2], x[3]]);
        let elbow = HardStops::between(Revolute::about([of(1.0), zero, zero]), [x[4], x[5]]).rebounding(x[6]);
        let slide =
            Coulomb::new(Prismatic::along([zero, of(0.6), of(0.8)]), x[8]).between([x[9], x[10]]).rebounding(x[11]);
        let wrist = Coulomb::new(Revolute::about([zero, of(1.0), zero]), x[7]).with(Spring::damping(of(0.02)));
        let scene = System::new(Pinned::origin(), (body, elbow, body, Ball, body, slide, body, wrist, body), Free)?;
        let scene = scene.with_gravity([zero, zero, x[12]]);
        let rates = [0.3, 0.5, 0.2, 2.0, 0.1, 0.2, 0.3, -0.4, 1.5].map(of);
        let start = scene.with_rates(scene.motion(), &rates)?;
        (scene, start)
    });
    assert!(changes > 3, "{changes}");
    Ok(())
}

#[test]
fn robots() -> Result<(), Error> {
    use robot::{Base, Coulomb, Free, HardStops, Hinge, Link, Slide, System};
    // An arm whose joints are geared, rub and strike, and a slide between them.
    let numbers = [2.0, 0.3, 0.4, 0.25, -0.2, 0.6, 0.5, 1.5, -0.05, 0.3, 0.4, 0.2, -9.81, 1.2, -0.8];
    let changes = as_forward!(Dop853::tolerance(1e-11), Dop853, 1.5, 1e-8, numbers, |x, T| {
        let of = <T as Scalar>::literal;
        let zero = of(0.0);
        let link = |mass: T| {
            let tensor = [[of(0.04), zero, zero], [zero, of(0.03), zero], [zero, zero, of(0.02)]];
            Link::<T>::new(mass, [of(0.02), of(0.03), of(0.15)], tensor)
        };
        let place = [zero, of(0.1), of(0.3)];
        let elbow =
            HardStops::between(Hinge::at::<0b110>(place).turned(robot::Quarter::<4>).geared(x[11]), [x[4], x[5]]);
        let slide = Coulomb::new(Slide::at::<0b110>(place), x[7]).between([x[8], x[9]]).rebounding(x[10]);
        let wrist =
            Coulomb::new(Hinge::at::<0b110>(place).turned(robot::Quarter::<8>), x[3]).breaking_away(x[3] * of(1.3));
        let chain =
            (Hinge::level(), link(x[0]), elbow.rebounding(x[6]), link(x[1]), slide, link(x[2]), wrist, link(of(0.5)));
        let scene = System::new(Base::origin(), chain, Free)?.with_gravity([zero, of(2.0), x[12]]);
        let start = scene.with_rates(scene.motion(), &[x[13], x[14], of(0.3), of(2.0)])?;
        (scene, start)
    });
    assert!(changes > 2, "{changes}");
    Ok(())
}

#[test]
fn a_mechanism_whose_joint_rubs_and_strikes() -> Result<(), Error> {
    let numbers = [1.0, 2.0, 0.7, 0.6, 0.9, -2.4, 0.1, 0.3, 9.81];
    let [crank, coupler, rocker] = [(0.5, 1.0), (1.2, 2.0), (0.9, 1.0)].map(|(long, mass)| Rod::uniform(long, mass));
    let plain = System::new(Pinned::origin(), (crank, Revolute::smooth(), coupler, Pin, rocker), Pinned::at(1.0, 0.0))?;
    let moving = plain.with_rates(plain.at_rest(&[1.0, 0.3, -2.0])?, &[2.0, 0.0, 0.0])?;
    let moving = plain.assembled(moving, &Unloaded)?;
    let (closed, rates) = (moving.coordinates(), moving.rates());
    let changes = as_forward!(Dop853::tolerance(1e-11), Dop853, 1.5, 1e-8, numbers, |x, T| {
        let of = <T as Scalar>::literal;
        let [crank, coupler, rocker] =
            [(0.5, x[0]), (1.2, x[1]), (0.9, x[0])].map(|(long, mass)| Rod::uniform(of(long), mass));
        let joint =
            Coulomb::new(Revolute::smooth(), x[2]).breaking_away(x[3] + x[2]).between([x[5], x[6]]).rebounding(x[7]);
        let chain = (crank, joint, coupler, HardStops::between(Revolute::smooth(), [of(-4.0), x[4]]), rocker);
        let scene = System::new(Pinned::origin(), chain, Pinned::at(of(1.0), of(0.0)))?.with_gravity(x[8]);
        let mut start = scene.motion();
        let [crank, coupler, rocker] = [0, 1, 2].map(|k| closed[k]);
        start.set_coordinates(&[crank, coupler, rocker - crank - coupler].map(of))?;
        let [crank, coupler, rocker] = [0, 1, 2].map(|k| rates[k]);
        let start = scene.with_rates(start, &[crank, coupler, rocker - crank - coupler].map(of))?;
        (scene, start)
    });
    assert!(changes > 1, "{changes}");
    Ok(())
}

/// A block that falls h onto a stop which gives back a share e: when it strikes, and how fast before and after, against closed forms.
#[test]
fn costs_where_a_block_strikes() -> Result<(), Error> {
    const SHARE: f64 = 0.5;
    let slide = HardStops::between(Slider::along(FRAC_PI_2), [0.0, f64::INFINITY]).rebounding(SHARE);
    let scene = System::new(Clamped::origin(), (slide, RigidBody::new(1.0, 1.0, [0.0; 2], [0.0; 2])), Free)?;
    let (scene, g, h) = (scene.with_gravity(9.81), 9.81, 1.0_f64);
    let mut start = scene.motion();
    start.set_coordinates(&[h])?;
    let mut backward = scene.backward(Dop853);
    let course = backward.course(&start, Dop853::tolerance(1e-11), 0.8, &[])?;
    let Some(hit) = course.changes().nth(1) else { panic!("it strikes") };
    let mut by_height = |cost: &dyn Fn(usize) -> [f64; 3]| {
        let gradient = backward.gradient_past(&course, &mut [], |step, _, by| {
            let [place, rate, time] = cost(step);
            by.time += time;
            by.add(&[place], &[rate])
        });
        gradient.map(|gradient| gradient.by_position()[0])
    };
    let at = |state: usize, cost: [f64; 3]| move |step: usize| if step == state { cost } else { [0.0; 3] };
    let [of_time, before] = [1.0 / (2.0 * g * h).sqrt(), -(0.5 * g / h).sqrt()];
    for (state, cost, exact) in [
        (hit - 1, [0.0, 0.0, 1.0], of_time),
        (hit, [0.0, 0.0, 1.0], of_time),
        (hit - 1, [0.0, 1.0, 0.0], before),
        (hit, [0.0, 1.0, 0.0], -SHARE * before),
        (hit - 1, [1.0, 0.0, 0.0], 0.0),
        (hit, [1.0, 0.0, 0.0], 0.0),
    ] {
        near(by_height(&at(state, cost))?, exact, 1e-10);
    }
    // With a cost at the end besides: after a time T it is at e v t − g t² / 2 for t = T − v / g, v = √(2 g h).
    let last = course.states().len() - 1;
    let (v, of_v) = ((2.0 * g * h).sqrt(), (0.5 * g / h).sqrt());
    let later = 0.8 - v / g;
    let of_end = SHARE * of_v * later - (SHARE * v - g * later) * of_v / g;
    let found = by_height(&|step| {
        let end = if step == last { 3.0 } else { 0.0 };
        if step == hit { [end, 2.0, 5.0] } else { [end, 0.0, 0.0] }
    })?;
    near(found, 3.0 * of_end - 2.0 * SHARE * before + 5.0 * of_time, 1e-9);
    Ok(())
}

/// A four-bar with friction in more joints than it has freedoms: until it rests, and while it does.
#[test]
fn a_mechanism_whose_joints_all_rub() -> Result<(), Error> {
    for (end, changes) in [(0.9, 2), (3.0, 3)] {
        let numbers = [0.4, 0.3, 0.35, 0.5, 1.2, 0.9, 9.81, 1.0];
        let found = as_forward!(Dop853::tolerance(1e-12), Dop853, end, 1e-8, numbers, |x, T| {
            let of = <T as Scalar>::literal;
            let (bar, pin) =
                (|length: T| Rod::uniform(length, length), |friction: T| Coulomb::new(Revolute::smooth(), friction));
            let side = (RigidBody::massless([x[7], of(0.0)]), pin(x[2]), bar(x[5]));
            let net = Network::new((pin(x[0]), bar(x[3]), pin(x[1]), bar(x[4])), side, Pin);
            let scene = System::new(Clamped::origin(), net, Free)?.with_gravity(x[6]);
            let start = scene.assembled(scene.at_rest(&[of(1.0), of(0.3), of(1.2)])?, &Unloaded)?;
            (scene, start)
        });
        println!("until {end} s: {found} changes");
        assert!(found >= changes);
    }
    Ok(())
}

#[test]
fn torques_and_costs_on_the_way() -> Result<(), Error> {
    macro_rules! arm {
        ($T:ty) => {{
            let of = <$T as Scalar>::literal;
            let rod = Rod::uniform(of(0.7), of(1.0));
            let shoulder = Coulomb::new(Revolute::smooth(), of(0.4)).breaking_away(of(0.5));
            let elbow = HardStops::between(Revolute::smooth(), [of(-0.4), of(0.4)]).rebounding(of(0.5));
            let arm = System::new(Pinned::origin(), (rod, shoulder, rod, elbow, rod), Free)?.with_gravity(of(9.81));
            let start = arm.with_rates(arm.motion(), &[of(0.2), of(0.0), of(1.0)])?;
            (arm, start)
        }};
    }
    let torques = [0.3, -0.2, 0.5];
    let (arm, start) = arm!(f64);
    let (mut backward, mut by_torques) = (arm.backward(Dop853), [0.0; 3]);
    let course = backward.course(&start, Dop853::tolerance(1e-11), 1.2, &torques)?;
    assert!(course.changes().count() > 4);
    // The square of the last coordinate at the end.
    backward.gradient_past(&course, &mut by_torques, |step, now, by| {
        let twice = if step + 1 == course.states().len() { 2.0 } else { 0.0 };
        by.add(&[0.0, 0.0, twice * now.coordinates()[2]], &[0.0; 3])
    })?;
    let (varied, still) = arm!(Jet<f64, 3>);
    let seeds = [0, 1, 2].map(|k| Jet::<f64, 3>::seed(torques[k], k));
    let loads = Loads::none().torques(seeds);
    let end =
        varied.simulation(Dop853::tolerance(1e-11)).loads(&loads).run(still, 1.2, |_| ())?.motion.coordinates()[2];
    by_torques.iter().zip((end * end).eps).for_each(|(found, expected)| near(*found, expected, 1e-8));
    // Costs of states in order: those before and after a change of mode stand at one time.
    let mut met = vec![];
    backward.gradient_past(&course, &mut [], |step, now, _| {
        met.push((step, now.time()));
        Ok(())
    })?;
    assert!(met.windows(2).all(|pair| pair[0].0 == pair[1].0 + 1 && pair[0].1 >= pair[1].1));
    assert_eq!((met.len(), met[0].1), (course.states().len(), 1.2));
    for number in course.changes() {
        assert_eq!(course.states()[number].time(), course.states()[number - 1].time());
    }
    Ok(())
}

#[test]
fn torques_of_intervals() -> Result<(), Error> {
    // Torques in three joints over each of five intervals, which break joints away and press others against their stops; the last number is a mass.
    macro_rules! arm {
        ($T:ty, $mass:expr) => {{
            let of = <$T as Scalar>::literal;
            let rod = Rod::uniform(of(0.7), $mass);
            let shoulder = Coulomb::new(Revolute::smooth(), of(0.8)).breaking_away(of(0.9));
            let elbow = Coulomb::new(Revolute::smooth(), of(0.1)).between([of(-0.3), of(0.3)]).rebounding(of(0.3));
            System::new(Pinned::origin(), (rod, shoulder, rod, elbow, rod), Free)?
        }};
    }
    const INTERVALS: usize = 5;
    const COUNT: usize = 3 * INTERVALS + 1;
    type T = Jet<f64, COUNT>;
    let mut random = Noise::new(7);
    let torques: Vec<f64> = (0..3 * INTERVALS).map(|_| random.between(-2.0, 2.0)).collect();
    for (control, bound) in [(1e-11, 1e-8), (1e-6, 1e-8)] {
        let (rule, end) = (Dop853::tolerance(control), 1.5);
        let arm = arm!(f64, 1.0);
        let (mut backward, start) = (arm.backward(Dop853), arm.motion());
        let course = backward.course(&start, rule, end, &torques)?;
        let (last, mut by_torques) = (course.states().len() - 1, torques.clone());
        let gradient = backward.gradient_past(&course, &mut by_torques, |step, _, by| {
            if step == last { by.add(&[0.0, 0.0, 1.0], &[0.0; 3]) } else { Ok(()) }
        })?;
        let varied = arm!(T, T::seed(1.0, COUNT - 1));
        let mut saved = None;
        for interval in 0..INTERVALS {
            let until = if interval + 1 == INTERVALS { end } else { end * ((interval + 1) as f64 / INTERVALS as f64) };
            let held = [0, 1, 2].map(|k| T::seed(torques[3 * interval + k], 3 * interval + k));
            let loads = Loads::none().torques(held);
            let simulation = varied.simulation(rule).loads(&loads);
            saved = Some(match saved.take() {
                None => {
                    let mut run = simulation.begin(varied.motion(), until, |_| ())?;
                    run.until(until)?;
                    run.save()
                }
                Some(saved) => {
                    let mut run = simulation.resume(saved, until, |_| ())?;
                    run.until(until)?;
                    run.save()
                }
            });
        }
        let expected = saved.map(|saved| saved.motion.coordinates()[2]).unwrap_or(T::of(0.0));
        let [by_mass] = gradient.along(&arm!(Jet<f64, 1>, Jet::seed(1.0, 0)))?;
        let most = expected.eps.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
        for (found, expected) in by_torques.iter().chain([&by_mass]).zip(expected.eps) {
            near(*found, expected, bound * most);
        }
        assert!(course.changes().count() > 10, "{}", course.changes().count());
        // Summed up over all intervals.
        let mut sums = [0.0; 3];
        backward.gradient_past(&course, &mut sums, |step, _, by| {
            if step == last { by.add(&[0.0, 0.0, 1.0], &[0.0; 3]) } else { Ok(()) }
        })?;
        for (k, sum) in sums.into_iter().enumerate() {
            near(sum, by_torques.iter().skip(k).step_by(3).sum(), 1e-12 * most);
        }
    }
    Ok(())
}

#[test]
fn what_has_no_gradient_is_refused() -> Result<(), Error> {
    let body = RigidBody::new(1.0, 0.1, [0.0; 2], [0.0; 2]);
    let fall = HardStops::between(Slider::along(FRAC_PI_2), [0.0, 1.0]);
    let scene = System::new(Clamped::origin(), (fall, body), Free)?.with_gravity(9.81);
    let (start, mut backward) = (scene.motion(), scene.backward(Rk4));
    let refused = |error: Error, why: &str| {
        assert!(matches!(error.fault, Fault::Unsupported { what } if what.contains(why)), "{error}");
    };
    // Steps alone know no change of mode.
    let mut states = [start; 3];
    refused(backward.run(&start, 0.1, 2, &[], &mut states).expect_err("steps"), "course");
    refused(backward.gradient(&[], &states, &mut [], |_, _, _| Ok(())).err().expect("steps"), "course");
    let (mut next, mut by_state, none) = (start, [0.0; 4], &mut [][..]);
    refused(backward.linearised_step(&start, 0.1, &[], &mut next, &mut by_state, none).expect_err("a step"), "course");
    // A start that strikes a stop: which side of it is another matter.
    let mut falling = start;
    falling.set_rates(&[-1.0])?;
    let course = backward.course(&falling, Rk4::step(0.1), 0.3, &[])?;
    refused(backward.gradient_past(&course, &mut [], |_, _, _| Ok(())).err().expect("a stop"), "touches its stop");
    // Lists of another length, and what is not of this scene.
    let error = backward.course(&start, Rk4::step(0.1), 0.3, &[0.0; 3]).expect_err("torques");
    assert!(matches!(error.fault, Fault::Count { expected: 4, given: 3, .. }), "{error}");
    let counted = |error: Error| assert!(matches!(error.fault, Fault::Count { expected: 2, given: 3, .. }), "{error}");
    let mut above = start;
    above.set_coordinates(&[0.5])?;
    let course = backward.course(&above, Rk4::step(0.1), 0.1, &[])?;
    counted(backward.gradient_past(&course, &mut [0.0; 3], |_, _, _| Ok(())).err().expect("torques"));
    // Vectors of another number.
    let lists = |count: usize| {
        let body = RigidBody::new(1.0, 0.1, [0.0; 2], [0.0; 2]);
        System::new(Clamped::origin(), vec![(Coulomb::new(Slider::along(0.0), 1.0), body); count], Free)
    };
    let (two, three) = (lists(2)?, lists(3)?);
    let mut backward = two.backward(Rk4);
    let course = backward.course(&two.with_rates(two.motion(), &[1.0, 0.5])?, Rk4::step(0.1), 0.3, &[])?;
    let shape = |error: Error| assert!(matches!(error.fault, Fault::Shape), "{error}");
    shape(three.backward(Rk4).gradient_past(&course, &mut [], |_, _, _| Ok(())).err().expect("another scene"));
    shape(backward.course(&three.motion(), Rk4::step(0.1), 0.3, &[]).expect_err("another scene"));
    let gradient = backward.gradient_past(&course, &mut [], |_, _, _| Ok(()))?;
    shape(gradient.along(&three.lift(Jet::<f64, 1>::of)).expect_err("another scene"));
    // An error of the cost is the gradient's.
    let fault = backward.gradient_past(&course, &mut [], |_, _, by| by.add(&[1.0], &[])).err().expect("a cost").fault;
    assert!(matches!(fault, Fault::Count { expected: 2, given: 1, .. }), "{fault}");
    Ok(())
}
