//! Gradients of runs whose joints are coupled where tips are held and loops are closed: against the same steps, the projection of both included, by all
//! that scene, couplings and start are made of; and through the assembly of starts.

use super::over_jets::weights;
use catena::planar::*;
use catena::scalar::{Jet, Scalar};
use catena::{Error, Fault, robot, spatial};

/// Explicit and implicit rules, in steps so long that what is put back is far more than rounding.
macro_rules! by_all_rules {
    ($numbers:expr, $made:ident) => {
        as_jets!(Rk4, 0.04, 8, $numbers, $made, |gradient, couplings| gradient.along_couplings(&couplings));
        as_jets!(Dop853, 0.1, 3, $numbers, $made, |gradient, couplings| gradient.along_couplings(&couplings));
        as_jets!(Sdirk4::new(), 0.04, 5, $numbers, $made, |gradient, couplings| gradient.along_couplings(&couplings));
        as_jets!(GeneralizedAlpha::new(0.7), 0.04, 6, $numbers, $made, |gradient, couplings| gradient
            .along_couplings(&couplings));
    };
}

/// Four bars to a pin, the last of which follows the second; where it begins closes with the numbers.
macro_rules! bars {
    ($x:expr, $T:ty) => {{
        let (x, of) = ($x, <$T as Scalar>::literal);
        let bar = |k: usize| RigidBody::new(x[k], of(0.05), [of(0.4), x[4]], [x[5], of(0.0)]);
        let j = Revolute::smooth();
        let chain = (j, bar(0), j, bar(1), Pin, bar(2), j.named("last"), bar(3));
        let scene = System::new(Clamped::at(x[6], of(0.1), of(0.2)), chain, Pinned::at(x[7], x[8]))?.with_gravity(x[9]);
        let couplings = Couplings::of(&scene, [Coupling::new("last", 2).ratio(x[10]).offset(x[11])])?;
        let mut guess = scene.motion();
        guess.set_coordinates(&[x[12], of(0.42), of(-0.62), of(-0.6)])?;
        guess.set_rates(&[x[13], of(-0.2), of(0.1), of(0.5)])?;
        let start = scene.assembled(couplings.joined(guess), &couplings)?;
        (scene, start, couplings, couplings)
    }};
}

const BARS: [f64; 14] = [1.0, 1.2, 0.9, 1.1, 0.05, 0.8, 0.1, 1.6, 0.2, 9.81, -0.7, -0.3, 0.92, 0.3];

#[test]
fn bars_to_a_pin() -> Result<(), Error> {
    by_all_rules!(BARS, bars);
    Ok(())
}

/// A loop of two freedoms in an arm, one of whose cranks follows the arm's shoulder; springs besides.
macro_rules! swing {
    ($x:expr, $T:ty) => {{
        let (x, of) = ($x, <$T as Scalar>::literal);
        let (rod, j) = (|length: $T| Rod::uniform(length, length * x[0]), Revolute::smooth());
        let sprung = ElasticHinge::rotary(x[1]).damped(x[2]);
        let chain = (j.named("shoulder"), RigidBody::new(x[3], of(0.1), [of(0.3), of(0.05)], [of(0.6), of(0.0)]));
        let cranks = (j.named("crank"), rod(x[4]), sprung, rod(of(0.7)), j, rod(of(0.7)), j, rod(of(0.5)));
        let swing = ClosedLoop::ending_at([x[5], of(0.0)], cranks, Pin);
        let root = Clamped::at(of(0.0), of(0.0), of(0.0));
        let scene = System::new(root, (chain, swing, j, rod(of(0.3))), Free)?.with_gravity(x[6]);
        let couplings = Couplings::of(&scene, [Coupling::new("crank", "shoulder").ratio(x[7]).offset(x[8])])?;
        let mut guess = scene.motion();
        guess.set_coordinates(&[x[9], of(0.9), of(0.3), of(-1.1), of(-0.9), of(0.4)])?;
        guess.set_rates(&[x[10], of(0.0), of(0.5), of(0.0), of(0.0), of(-0.3)])?;
        let start = scene.assembled(couplings.joined(guess), &couplings)?;
        (scene, start, couplings, couplings)
    }};
}

const SWING: [f64; 11] = [2.0, 3.0, 0.2, 1.0, 0.5, 0.8, 9.81, -1.5, 0.05, -0.6, 1.0];

#[test]
fn a_loop_in_an_arm() -> Result<(), Error> {
    by_all_rules!(SWING, swing);
    Ok(())
}

/// An arm of space on the ground whose tip is held, with two couplings, one of which follows a follower.
macro_rules! arm {
    ($x:expr, $T:ty) => {{
        use robot::{Base, Flange, Hinge, Link, Quarter, System};
        let (x, of) = ($x, <$T as Scalar>::literal);
        let link = |mass: $T| {
            let tensor = [[0.06, 0.002, 0.0], [0.002, 0.05, 0.001], [0.0, 0.001, 0.02]].map(|row| row.map(of));
            Link::general(mass, [of(0.02), of(0.01), of(0.2)], tensor)
        };
        let hinge = |z: $T| Hinge::at::<0b111>([of(0.05), of(-0.02), z]).turned(Quarter::<30>);
        let chain = (
            (Hinge::level().grounded(), link(x[0]), hinge(x[1]), link(of(1.2)), hinge(of(0.45)), link(of(1.3))),
            (hinge(of(0.4)), link(of(1.0)), hinge(of(0.5)), link(of(1.2)), hinge(of(0.3)), link(of(0.7))),
            Flange::at([of(0.03), of(0.0), of(0.3)]),
        );
        let tip = spatial::Pinned::at([x[2], of(0.47), of(0.12)]);
        let scene = System::new(Base::origin(), chain, tip)?.with_gravity([of(0.3), of(-0.2), x[3]]);
        let follows =
            [Coupling::by_coordinate(3, 2).ratio(x[4]).offset(x[5]), Coupling::by_coordinate(4, 3).ratio(of(-0.8))];
        let couplings = Couplings::of(&scene, follows)?;
        let mut guess = scene.motion();
        guess.set_coordinates(&[of(0.2), of(0.5), of(-0.8), of(0.0), of(0.4), x[6]])?;
        guess.set_rates(&[x[7], of(-0.2), of(0.5), of(0.0), of(0.1), of(0.3)])?;
        let start = scene.assembled(couplings.joined(guess), &couplings)?;
        (scene, start, couplings, couplings)
    }};
}

const ARM: [f64; 8] = [1.1, 0.4, 0.15, -9.81, 0.6, 0.1, 0.3, 0.3];

#[test]
fn an_arm_of_space_to_a_ball() -> Result<(), Error> {
    as_jets!(Rk4, 0.04, 8, ARM, arm, |gradient, couplings| gradient.along_couplings(&couplings));
    Ok(())
}

#[test]
fn an_arm_of_space_to_a_ball_by_an_implicit_rule() -> Result<(), Error> {
    as_jets!(Sdirk4::new(), 0.04, 5, ARM, arm, |gradient, couplings| gradient.along_couplings(&couplings));
    Ok(())
}

/// Starts that are assembled with the numbers: as over jets, where scene, couplings and start are made of them.
#[test]
fn assembled_starts() -> Result<(), Error> {
    const STEPS: usize = 10;
    const N: usize = BARS.len();
    let (scene, start, couplings, _) = bars!(&BARS, f64);
    let [of_q, of_v] = weights(4);
    let (mut backward, mut states) = (scene.backward(Rk4).under(couplings).assembled(), [start; STEPS + 1]);
    backward.run(&start, 0.02, STEPS, &[], &mut states)?;
    let gradient = backward
        .gradient(&[], &states, &mut [], |step, _, by| if step == STEPS { by.add(&of_q, &of_v) } else { Ok(()) })?;
    type J = Jet<f64, N>;
    let seeded: [J; N] = core::array::from_fn(|k| Jet::seed(BARS[k], k));
    let (over, _, coupled, _) = bars!(&seeded, J);
    let mut still = over.motion();
    still.set_coordinates(&start.coordinates().into_iter().map(Jet::of).collect::<Vec<_>>())?;
    still.set_rates(&start.rates().into_iter().map(Jet::of).collect::<Vec<_>>())?;
    let end = over.simulation(Rk4::step(0.02)).loads(&coupled);
    let end = end.run(over.assembled(still, &coupled)?, 0.02 * STEPS as f64, |_| ())?.motion;
    let ends = end.coordinates().into_iter().zip(&of_q).chain(end.rates().into_iter().zip(&of_v));
    let expected = ends.fold([0.0; N], |sum, (x, weight)| core::array::from_fn(|k| sum[k] + weight * x.eps[k]));
    let parts = [gradient.along(&over)?, gradient.along_couplings(&coupled)];
    let found: [f64; N] = core::array::from_fn(|k| parts.iter().map(|part| part[k]).sum());
    let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found - expected).abs() < 1e-12 * size, "{found} {expected}");
    }
    Ok(())
}

/// Springs along fixed axes of a hinge, where something is closed: what forces move there is not what virtual velocities are.
#[test]
fn fixed_axes_are_refused() -> Result<(), Error> {
    let (rod, j, spring) = (Rod::uniform(0.8, 1.0), Revolute::smooth(), Spring::new(500.0));
    let fixed = ElasticHinge::rotary(3.0).with_linear(spring, spring).in_fixed_axes();
    let chain = (j, rod, j, rod, fixed, rod, j.named("last"), rod);
    let scene = System::new(Clamped::origin(), chain, Pinned::at(1.6, 0.2))?;
    let couplings = Couplings::of(&scene, [Coupling::new("last", 2).ratio(-0.7)])?;
    let mut guess = scene.motion();
    guess.set_coordinates(&[0.92, 0.42, -1.96, 0.0, 0.0, -0.6])?;
    let mut states = [scene.assembled(couplings.joined(guess), &couplings)?; 2];
    let start = states[0];
    let refused = scene.backward(Rk4).under(couplings).run(&start, 0.01, 1, &[], &mut states).map_err(|e| e.fault);
    assert!(matches!(refused, Err(Fault::Unsupported { what }) if what.contains("fixed axes")), "{refused:?}");
    scene.backward(Rk4).run(&start, 0.01, 1, &[], &mut states)
}

/// In a scene with nothing to be closed steps put nothing back: offsets stand in the start, and its assembly is made over jets.
#[test]
fn open_scenes_have_offsets_in_their_starts() -> Result<(), Error> {
    let (rod, j) = (Rod::uniform(0.8, 1.0), Revolute::smooth());
    let scene = System::new(Clamped::origin(), (j, rod, j.named("last"), rod), Free)?.with_gravity(9.81);
    let couplings = Couplings::of(&scene, [Coupling::new("last", 1).ratio(-0.7).offset(0.2)])?;
    let mut states = [scene.assembled(scene.at_rest(&[0.3, 0.1])?, &couplings)?; 5];
    let start = states[0];
    let mut gradient = |mut backward: catena::sensitivity::Backward<'_, _, _, _, _, _, _>| {
        backward.run(&start, 0.01, 4, &[], &mut states)?;
        let gradient = backward.gradient(&[], &states, &mut [], |step, _, by| {
            if step == 4 { by.add(&[1.0, 0.5], &[0.0; 2]) } else { Ok(()) }
        })?;
        Ok::<_, Error>((*gradient.by_ratios(), *gradient.by_offsets()))
    };
    let ([by_ratio], [by_offset]) = gradient(scene.backward(Rk4).under(couplings))?;
    assert!(by_ratio != 0.0 && by_offset == 0.0, "{by_ratio} {by_offset}");
    let refused = gradient(scene.backward(Rk4).under(couplings).assembled()).map_err(|error| error.fault);
    assert!(matches!(refused, Err(Fault::Unsupported { what }) if what.contains("along_start")), "{refused:?}");
    Ok(())
}
