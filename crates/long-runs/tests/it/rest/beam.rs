//! Beams of segments against closed forms: frequencies of Euler and Bernoulli and of bars, deflections, circles.

use catena::loading::Unloaded;
use catena::modes::Modes;
use catena::planar::*;
use catena::{Error, Fault, Real, Scalar};
use catena_oracle::{has_order, near};
use core::f64::consts::{PI, TAU};

/// Numbers of segments.
const COUNTS: [usize; 4] = [10, 20, 40, 80];

/// L, EI, ρA, EA: nothing is one, and where K² matters nothing is far from it.
const L: f64 = 1.5;
const EI: f64 = 2.0;
const RHO_A: f64 = 0.8;
const EA: f64 = 50.0;

/// √(EI/ρA) / L² (rad/s), by which (βL)² become frequencies.
fn unit() -> f64 {
    (EI / RHO_A).sqrt() / (L * L)
}

fn beam() -> Beam<f64> {
    Beam::new(L, EI, RHO_A)
}

/// Frequencies that swing, without those of rigid motions.
fn elastic(modes: &Modes, rigid: usize) -> Vec<f64> {
    modes.frequencies().skip(rigid).collect()
}

/// Relative errors of frequencies fall with this order of the length of a segment.
#[track_caller]
fn converge<const N: usize>(name: &str, order: f64, exact: [f64; N], found: &[(usize, Vec<f64>)], skip: [usize; N]) {
    for (k, exact) in exact.into_iter().enumerate() {
        let errors: Vec<(f64, f64)> =
            found.iter().map(|(n, found)| (1.0 / *n as f64, (found[k] / exact - 1.0).abs())).collect();
        // Higher modes are not yet in their order with few segments. Rounding is some 1e-16 of the largest ω².
        has_order(&format!("{name}, mode {}", k + 1), order, 1e-9, &errors[skip[k]..]);
    }
}

#[test]
fn clamped_beams_converge_at_second_order() -> Result<(), Error> {
    // Clamped-free: cos βL cosh βL = −1.
    let exact = [1.8751040687, 4.6940911330, 7.8547574382].map(|x: f64| x * x * unit());
    let mut found = vec![];
    for n in COUNTS {
        let scene = System::new(Clamped::at(0.2, -0.1, 0.3), beam().segments_in_vec(n), Free)?;
        found.push((n, elastic(&scene.modes(&scene.at_rest(&vec![0.3; n])?, &Unloaded)?, 0)));
        println!(
            "{n} segments: highest frequency {:.4} n² √(EI/ρA)/L²",
            found.last().unwrap().1[n - 1] / unit() / (n * n) as f64
        );
    }
    converge("clamped-free", 2.0, exact, &found, [0, 0, 1]);
    Ok(())
}

#[test]
fn pinned_beams_converge_at_fourth_order() -> Result<(), Error> {
    // Pinned-free: tan βL = tanh βL, beside the rotation as a whole, which nothing drives back.
    let exact = [3.9266023120, 7.0685827456].map(|x: f64| x * x * unit());
    let mut found = vec![];
    for n in COUNTS {
        let scene = System::new(Pinned::origin(), beam().segments_in_vec(n), Free)?;
        found.push((n, elastic(&scene.modes(&scene.at_rest(&vec![0.3; n + 1])?, &Unloaded)?, 1)));
    }
    converge("pinned-free", 4.0, exact, &found[..3], [0, 0]); // 80 segments are at rounding
    Ok(())
}

#[test]
fn beams_held_at_both_ends_converge_at_second_order() -> Result<(), Error> {
    // Clamped-clamped: cos βL cosh βL = 1.
    let exact = [4.7300407449, 7.8532046241].map(|x: f64| x * x * unit());
    // Stiff along it: what stretches comes last.
    let (mut stretching, mut sliding) = (vec![], vec![]);
    for n in COUNTS {
        let (root, tip) = (Clamped::at(0.0, 0.0, 0.0), Clamped::at(L, 0.0, 0.0));
        let scene = System::new(root, beam().with_extension(1e4).segments_in_vec(n), tip)?;
        stretching.push((n, elastic(&scene.modes(&scene.motion(), &Unloaded)?, 0)));
        // A beam that does not stretch, with an end that may come nearer.
        let scene = System::new(root, beam().segments_in_vec(n), Guided::at(L, 0.0, 0.0))?;
        sliding.push((n, elastic(&scene.modes(&scene.motion(), &Unloaded)?, 0)));
    }
    converge("clamped-clamped", 2.0, exact, &stretching, [0, 1]);
    converge("clamped-guided", 2.0, exact, &sliding, [0, 1]);
    Ok(())
}

#[test]
fn a_beam_between_pins_converges_at_fourth_order() -> Result<(), Error> {
    let mut found = vec![];
    for n in COUNTS {
        let scene = System::new(Pinned::origin(), beam().with_extension(1e4).segments_in_vec(n), Pinned::at(L, 0.0))?;
        found.push((n, elastic(&scene.modes(&scene.motion(), &Unloaded)?, 0)));
    }
    converge("pinned-pinned", 4.0, [PI * PI * unit()], &found[..3], [0]); // 80 segments are at rounding
    Ok(())
}

#[test]
fn bars_stretch_at_second_order() -> Result<(), Error> {
    let mut found = vec![];
    for n in COUNTS {
        let scene = System::new(Clamped::at(0.0, 0.0, 0.4), beam().with_extension(EA).segments_in_vec(n), Free)?;
        let modes = scene.modes(&scene.at_rest(&vec![0.4; n])?, &Unloaded)?;
        // Coordinates are a stretch and an angle in turn. A straight beam either stretches or bends.
        let along =
            |mode: &&catena::modes::Mode| mode.shape().iter().skip(1).step_by(2).all(|angle| angle.abs() < 1e-6);
        let bar: Vec<f64> = modes.iter().filter(along).map(|mode| mode.frequency()).collect();
        assert_eq!(bar.len(), n);
        // n springs EA/ℓ, n − 1 masses ρAℓ and half of one at the end.
        let wave = (EA / RHO_A).sqrt() / L;
        for (k, found) in bar.iter().enumerate() {
            let exact = 2.0 * n as f64 * wave * ((2 * k + 1) as f64 * PI / (4 * n) as f64).sin();
            near(*found, exact, 1e-9 * exact);
        }
        found.push((n, bar));
    }
    let exact = [1.0, 3.0, 5.0].map(|odd| 0.5 * odd * PI * (EA / RHO_A).sqrt() / L);
    converge("bar", 2.0, exact, &found, [0, 0, 0]);
    Ok(())
}

#[test]
fn a_force_at_the_tip_deflects_it_at_second_order() -> Result<(), Error> {
    const P: f64 = 1e-6; // (N): what is not linear is P² of the deflection
    let exact = P * L.powi(3) / (3.0 * EI);
    let mut errors = vec![];
    for n in COUNTS {
        let beam = beam();
        let last = 0.5 * L / n as f64;
        let push = Loads::none().on_bodies(move |_: f64, body, motion: &BodyMotion<f64>| {
            motion.force_at([last, 0.0], [0.0, if body == n { P } else { 0.0 }])
        });
        let scene = System::new(Clamped::at(0.0, 0.0, 0.0), beam.segments_in_vec(n), Free)?;
        let rest = scene.equilibrium(scene.motion(), &push)?;
        let tip = scene.stations(&rest, &push)?.tip().frame.place;
        near(tip.y / exact, 1.0 - 0.25 / (n * n) as f64, 1e-9); // sums of squares of odd numbers; 1e-15 m is 1e-9 of it
        errors.push((1.0 / n as f64, (tip.y / exact - 1.0).abs()));
    }
    has_order("tip deflection", 2.0, 1e-9, &errors);
    Ok(())
}

#[test]
fn a_couple_bends_a_beam_into_a_circle_with_any_number_of_segments() -> Result<(), Error> {
    for n in [3, 8, 25] {
        let scene = System::new(Clamped::at(0.3, -0.2, 0.5), beam().with_extension(EA).segments_in_vec(n), Free)?;
        let roll = Loads::none().on_bodies(move |_: f64, body, _: &BodyMotion<f64>| {
            Wrench::torque(if body == n { TAU * EI / L } else { 0.0 })
        });
        let guess: Vec<f64> = (1..=n).map(|k| 0.5 + 0.8 * TAU * k as f64 / n as f64).collect();
        let rest = scene.equilibrium(scene.at_rest(&guess)?, &roll)?;
        let stations = scene.stations(&rest, &roll)?;
        let tip = stations.tip().frame;
        println!("{n} segments: ({:.1e}, {:.1e}) m from closed", tip.place.x - 0.3, tip.place.y + 0.2);
        near(tip.place.x, 0.3, 1e-13 * n as f64); // rounding of n angles
        near(tip.place.y, -0.2, 1e-13 * n as f64);
        near(tip.turn.angle, 0.5 + TAU, 1e-13 * n as f64);
    }
    Ok(())
}

#[test]
fn a_straight_beam_held_twice_along_itself_is_named() -> Result<(), Error> {
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), beam().segments::<8>(), Clamped::at(L, 0.0, 0.0))?;
    let error = scene.with_accelerations(scene.motion(), &Unloaded).unwrap_err();
    println!("{error}");
    assert!(matches!(error.fault, Fault::RedundantClosures { closure: "x of the tip", independent: 2, of: 3 }));
    Ok(())
}

#[test]
fn parameters_that_make_no_mechanics_are_refused() {
    let fault = |beam: Beam<f64, f64, f64>| {
        let scene = System::new(Clamped::at(0.0, 0.0, 0.0), beam.segments::<4>(), Free);
        scene.map(|_| ()).unwrap_err().fault
    };
    let make = |[length, ei, density, ea, time]: [f64; 5]| {
        fault(Beam::new(length, ei, density).with_extension(ea).damped(time))
    };
    assert!(matches!(make([0.0, 1.0, 1.0, 1.0, 0.1]), Fault::NotPositive { parameter: "length", .. }));
    assert!(matches!(make([1.0, -1.0, 1.0, 1.0, 0.1]), Fault::Negative { parameter: "stiffness", .. }));
    assert!(matches!(make([1.0, 1.0, 0.0, 1.0, 0.1]), Fault::NotPositive { parameter: "mass", .. }));
    assert!(matches!(make([1.0, 1.0, 1.0, f64::NAN, 0.1]), Fault::NotFinite { .. } | Fault::Negative { .. }));
    assert!(matches!(make([1.0, 1.0, 1.0, 1.0, -0.1]), Fault::Negative { parameter: "damping", .. }));
}

#[test]
fn arrays_vectors_and_lifted_beams_are_the_same_chain() -> Result<(), Error> {
    let beam = beam().with_extension(EA).damped(0.01);
    let (first, links) = beam.segments::<5>();
    let (same, vector) = beam.segments_in_vec(5);
    assert_eq!((first, &links[..]), (same, &vector[..]));
    use catena::Lift;
    assert_eq!(beam.lift(&mut |x: f64| x).segments::<5>(), (first, links));
    // None make a rigid rod.
    assert_eq!(beam.segments::<0>(), (Rod::uniform(L, RHO_A * L), []));
    Ok(())
}

#[test]
fn vectors_of_segments_end_at_a_pin_as_tuples_do() -> Result<(), Error> {
    // Too short a span, so that it bulges. The last link of a vector hands on more than the pin it meets; in a tuple types tell.
    let (first, links) = beam().segments::<6>();
    let [inner @ .., last] = links;
    let (root, tip) = (Pinned::origin(), Pinned::at(0.8 * L, 0.0));
    let vector = System::new(root, (first, links.to_vec()), tip)?.with_gravity(9.81);
    let tuple = System::new(root, (first, inner, last), tip)?.with_gravity(9.81);
    let guess = [-1.0, -0.7, -0.3, 0.0, 0.3, 0.7, 1.0];
    let starts =
        (vector.assembled(vector.at_rest(&guess)?, &Unloaded)?, tuple.assembled(tuple.at_rest(&guess)?, &Unloaded)?);
    let rule = Dop853::tolerance(1e-10);
    let explicit = (
        vector.simulate(starts.0.clone(), rule, 0.2, |_| ())?.motion,
        tuple.simulate(starts.1, rule, 0.2, |_| ())?.motion,
    );
    assert_eq!(explicit.0.multipliers(), explicit.1.multipliers());
    let rule = Sdirk4::new().step(0.01);
    let implicit =
        (vector.simulate(starts.0, rule, 0.2, |_| ())?.motion, tuple.simulate(starts.1, rule, 0.2, |_| ())?.motion);
    assert_eq!(implicit.0.multipliers(), implicit.1.multipliers());
    Ok(())
}

/// Place of the tip of a cantilever that falls from the horizontal, by an implicit rule.
macro_rules! falls {
    ($name:ident, $rule:expr) => {
        fn $name<T: Scalar>([length, ei, density, ea, time]: [T; 5]) -> Result<[T; 2], Error> {
            let of = <T::Real as Real>::of;
            let beam = Beam::new(length, ei, density).with_extension(ea).damped(time);
            let root = Clamped::at(T::zero(), T::zero(), T::zero());
            let scene = System::new(root, beam.segments::<6>(), Free)?.with_gravity(T::literal(9.81));
            let rule = $rule;
            let run = scene.simulate(scene.motion(), rule.step(of(0.005)), of(0.3), |_| ())?;
            let tip = scene.stations(&run.motion, &Unloaded)?.tip().frame.place;
            Ok([tip.x, tip.y])
        }
    };
}
falls!(by_generalised_alpha, GeneralizedAlpha::new(0.8));
falls!(by_sdirk4, Sdirk4::new());

#[test]
fn tips_have_the_derivatives_that_differences_say() -> Result<(), Error> {
    use num_dual::Dual64;
    let at = [L, EI, RHO_A, EA, 0.004];
    for (i, name) in ["L", "EI", "ρA", "EA", "τ"].into_iter().enumerate() {
        let seeded = core::array::from_fn(|k| {
            let x = Dual64::from_re(at[k]);
            if k == i { x.derivative() } else { x }
        });
        let h = 1e-4 * at[i];
        let moved = |by: f64| core::array::from_fn(|k| if k == i { at[k] + by } else { at[k] });
        for (rule, found, below, above) in [
            (
                "generalised-alpha",
                by_generalised_alpha(seeded)?,
                by_generalised_alpha(moved(-h))?,
                by_generalised_alpha(moved(h))?,
            ),
            ("SDIRK4", by_sdirk4(seeded)?, by_sdirk4(moved(-h))?, by_sdirk4(moved(h))?),
        ] {
            for k in 0..2 {
                let expected = (above[k] - below[k]) / (2.0 * h);
                let error = (found[k].eps / expected - 1.0).abs();
                println!("{rule}, ∂{}/∂{name}: {:.6e}, off by {error:.1e}", ["x", "y"][k], found[k].eps);
                assert!(expected.abs() * at[i] > 1e-6, "{name} must matter");
                assert!(error < 1e-6, "{rule}, {name}: {:e} not {expected:e}", found[k].eps); // h² of a third derivative
            }
        }
    }
    Ok(())
}
