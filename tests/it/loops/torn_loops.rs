//! Loops that are held too often and cannot close, or come apart on their way: refused by what is missing, rather than shared out.

use catena::loading::Unloaded;
use catena::planar;
use catena::spatial::*;
use catena::{Cause, Error, Fault, Place};
use catena_oracle::near;

fn hinge() -> Revolute<f64> {
    Revolute::about([0.0, 0.0, 1.0])
}

fn rod(length: f64) -> Rod<f64> {
    Rod::uniform(length, 0.02, length)
}

/// A flat four-bar whose far pivot stands out of its plane (m), about an axis that leans towards x (rad).
macro_rules! four_bar {
    ($out:expr, $lean:expr) => {{
        let leaning = Revolute::about([f64::sin($lean), 0.0, f64::cos($lean)]);
        let side = (RigidBody::massless([1.0, 0.0, $out]), leaning, rod(0.8));
        let net = Network::new((hinge(), rod(0.5), hinge(), rod(1.0)), side, LeastNorm(hinge()));
        System::new(Clamped::origin(), net, Free)?.with_gravity([0.0, -9.81, 0.0])
    }};
}

/// Angles at which the flat one closes, its crank at this angle: by the triangle beyond the crank.
fn closed(crank: f64) -> [f64; 3] {
    let (a, b, c, d) = (0.5, 1.0, 0.8, 1.0);
    let [x, y] = [d - a * crank.cos(), -a * crank.sin()];
    let across = x.hypot(y);
    let coupler = y.atan2(x) + ((b * b + across * across - c * c) / (2.0 * b * across)).acos();
    let end = [a * crank.cos() + b * coupler.cos(), a * crank.sin() + b * coupler.sin()];
    [crank, coupler - crank, end[1].atan2(end[0] - d)]
}

fn not_closed(outcome: Result<(), Error>, station: usize) -> f64 {
    let error = outcome.expect_err("what cannot close is refused");
    println!("{error}");
    assert_eq!(error.place, Some(Place::Station(station)));
    let Fault::NotClosed { residual } = error.fault else { panic!("{error}") };
    residual
}

/// The far pivot is out of the plane: nothing that moves in the plane changes that. Nor does it start, or rest.
#[test]
fn a_pivot_out_of_the_plane_is_refused() -> Result<(), Error> {
    for out in [0.05, 1e-3, 1e-4] {
        let scene = four_bar!(out, 0.0);
        for guess in [closed(1.2), [1.5, -1.4, 1.6]] {
            let guess = scene.at_rest(&guess)?;
            near(not_closed(scene.assembled(guess, &Unloaded).map(|_| ()), 7), out, 1e-12);
            near(not_closed(scene.equilibrium(guess, &Unloaded).map(|_| ()), 7), out, 1e-12);
        }
        let start = scene.at_rest(&closed(1.2))?;
        near(
            not_closed(scene.simulate(start, Dop853::tolerance(1e-9), 0.1, |_| ()).map(|_| ()).map_err(|x| x.error), 7),
            out,
            1e-12,
        );
        near(
            not_closed(scene.simulate(start, Rk4::step(1e-3), 0.1, |_| ()).map(|_| ()).map_err(|x| x.error), 7),
            out,
            1e-12,
        );
    }
    // What numbers of six digits leave open stays so.
    let scene = four_bar!(1e-6, 0.0);
    let start = scene.assembled(scene.at_rest(&closed(1.2))?, &Unloaded)?;
    let end = scene.simulate(start, Dop853::tolerance(1e-9), 1.0, |_| ())?.motion;
    let bodies = scene.body_motions(&end)?;
    let ends = [1, 3].map(|k| bodies.get(k).expect("a last body").outboard().place);
    near((ends[0] - ends[1]).norm(), 1e-6, 1e-12);
    Ok(())
}

/// One axis leans: all others ask for what is normal to theirs.
#[test]
fn an_axis_that_leans_is_refused() -> Result<(), Error> {
    for lean in [1e-2, 1e-3, 1e-4] {
        let scene = four_bar!(0.0, lean);
        let residual = not_closed(scene.assembled(scene.at_rest(&closed(1.2))?, &Unloaded).map(|_| ()), 7);
        // Its rod ends out of the plane by lean · 0.8 cos; and the last axis leans as the first does, in the rod's axes.
        assert!(residual > 0.5 * lean && residual < 2.0 * lean);
    }
    let scene = four_bar!(0.0, 1e-6);
    let start = scene.assembled(scene.at_rest(&closed(1.2))?, &Unloaded)?;
    scene.simulate(start, Dop853::tolerance(1e-9), 1.0, |_| ())?;
    Ok(())
}

/// A straight toggle whose ends are further apart than it is long.
#[test]
fn a_toggle_out_of_reach_is_refused() -> Result<(), Error> {
    let bar = planar::Rod::uniform(0.5, 1.0);
    let side = (planar::RigidBody::massless([1.05, 0.0]), planar::Pin, bar);
    let net = planar::Network::new((planar::Pin, bar), side, planar::LeastNorm(planar::Pin));
    let scene = planar::System::new(planar::Clamped::at(0.0, 0.0, 0.0), net, planar::Free)?;
    let straight = scene.assembled(scene.at_rest(&[0.0, core::f64::consts::PI])?, &Unloaded);
    near(not_closed(straight.map(|_| ()), 5), 0.05, 1e-12);
    let bent = scene.assembled(scene.at_rest(&[0.1, 3.0])?, &Unloaded);
    assert!(not_closed(bent.map(|_| ()), 5) >= 0.05 - 1e-12);
    Ok(())
}

/// Two drives that agree at first and then ask for what the coupler between them is too short for.
#[test]
fn drives_that_contradict_each_other_end_a_run() -> Result<(), Error> {
    use planar::*;
    const ANGLES: [f64; 2] = [1.3162334928118415, 1.3603674281113283];
    let rod = |length: f64| Rod::uniform(length, length);
    let crank = |angle: f64| Driven::new(Revolute::smooth(), move |t: f64| [angle + t, 1.0, 0.0]);
    let side = (RigidBody::massless([0.8, 0.0]), crank(ANGLES[1]), rod(0.6));
    let net = Network::new((crank(ANGLES[0]), rod(0.3), Pin, rod(0.9)), side, LeastNorm(Pin));
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), net, Free)?;
    let start = scene.assembled(scene.at_rest(&[0.3356360395243808])?, &Unloaded)?;
    // By how much the ends of the cranks are too far apart.
    let missing = |time: f64| {
        let [a, b] = [ANGLES[0] + time, ANGLES[1] + time];
        ((0.8 + 0.6 * b.cos() - 0.3 * a.cos()).hypot(0.6 * b.sin() - 0.3 * a.sin()) - 0.9).abs()
    };
    near(missing(0.0), 0.0, 1e-12);
    macro_rules! ends {
        ($($rule:expr),*) => {$({
            let error = scene.simulate(start.clone(), $rule, 0.5, |_| ()).unwrap_err().error;
            println!("{error}");
            let residual = match error.fault {
                Fault::NotClosed { residual } | Fault::StepTooSmall { cause: Cause::NotClosed { residual }, .. } => residual,
                _ => panic!("{error}"),
            };
            let most = missing(error.time.expect("a time"));
            // 1e-4 of the way around, 2.6 m; of which a step of a size may find more. Along the coupler, of which the residual has the larger component.
            assert!(residual >= 2.6e-4 * core::f64::consts::FRAC_1_SQRT_2 - 1e-9);
            assert!(residual <= most + 1e-9 && residual >= most * core::f64::consts::FRAC_1_SQRT_2 - 1e-9);
            assert_eq!(error.place, Some(catena::Place::Station(7)));
        })*};
    }
    ends!(Dop853::tolerance(1e-9), Rk4::step(1e-3), Sdirk4::new().step(1e-3), GeneralizedAlpha::new(0.8).step(1e-3));
    Ok(())
}

/// Bennett's linkage with one of two links that are to be alike longer by so much (m).
#[test]
fn bennetts_linkage_of_wrong_lengths_is_refused() -> Result<(), Error> {
    let ([a, b], alpha) = ([0.4_f64, 0.7], 0.5_f64);
    let beta = (b * alpha.sin() / a).asin();
    let both = alpha + beta;
    let product = -(0.5 * both).sin() / (0.5 * (alpha - beta)).sin();
    let second = 2.0 * (product * 0.5_f64.cos()).atan2(0.5_f64.sin());
    let hinge = |turned: f64| Revolute::about([0.0, -turned.sin(), turned.cos()]);
    let link = |length: f64| {
        let tensor = [[0.01, 0.0, 0.0], [0.0, 0.06, 0.0], [0.0, 0.0, 0.06]];
        RigidBody::new(1.0, tensor, [0.4 * length, 0.0, 0.0], [length, 0.0, 0.0])
    };
    for (wrong, closes) in [(1e-2, false), (1e-3, false), (1e-4, false), (1e-6, true), (0.0, true)] {
        let main = (hinge(0.0), link(a), hinge(alpha), link(b + wrong));
        let turned = Weld::at(Rotation::from_angles([-2.0 * both, 0.0, 0.0]));
        let side = (RigidBody::massless([-b, 0.0, 0.0]), turned, hinge(2.0 * both - beta), link(-a));
        let net = Network::new(main, side, LeastNorm(hinge(both)));
        let scene = System::new(Clamped::origin(), net, Free)?.with_gravity([0.5, -2.0, -9.0]);
        let start = scene.assembled(scene.at_rest(&[1.0, second, second])?, &Unloaded);
        if closes {
            scene.simulate(start?, Dop853::tolerance(1e-9), 1.0, |_| ())?;
        } else {
            let residual = not_closed(start.map(|_| ()), 8);
            assert!(residual > 0.1 * wrong && residual < 2.0 * wrong);
        }
    }
    Ok(())
}
