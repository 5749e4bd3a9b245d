//! Starts that are assembled and whose joints stick there, and starts at stops: against the same starts over jets, assembled and run.

use super::WIDTH;
use crate::over_jets::weights;
use catena::planar::*;
use catena::scalar::{Jet, Scalar};
use catena::{Error, Lift, spatial};
use std::f64::consts::FRAC_PI_2;

/// The derivative of a sum of last coordinates and rates by a length, backward and over jets.
macro_rules! by_length {
    ($made:ident, $guess:expr, $length:expr) => {{
        type J = Jet<f64, 1>;
        let scene = $made!($length, f64);
        let start = scene.assembled(scene.at_rest(&$guess)?, &Unloaded)?;
        let [mut of_q, of_v] = weights(start.rates().len());
        if start.coordinates().len() != of_q.len() {
            of_q.fill(0.0); // coordinates of balls are others than their derivatives are by
        }
        let mut backward = scene.backward(Dop853).assembled();
        let course = backward.course(&start, Dop853::tolerance(1e-11), 0.3, &[])?;
        let last = course.states().len() - 1;
        let gradient = backward
            .gradient_past(&course, &mut [], |step, _, by| if step == last { by.add(&of_q, &of_v) } else { Ok(()) })?;
        let over = $made!(J::seed($length, 0), J);
        let begun = over.assembled(start.lift(J::of), &Unloaded)?;
        let end = over.simulation(Dop853::tolerance(1e-11)).run(begun, 0.3, |_| ());
        let end = end.map_err(|stopped| stopped.error)?.motion;
        let ends = end.coordinates().into_iter().zip(&of_q).chain(end.rates().into_iter().zip(&of_v));
        let expected = ends.fold(0.0, |sum, (x, weight)| sum + x.eps[0] * weight);
        let [found] = gradient.along(&over)?;
        println!("{}: {found} {expected}", stringify!($made));
        assert!((found - expected).abs() < 1e-9 * (1.0 + expected.abs()), "{found} {expected}");
    }};
}

#[test]
fn linkages_that_rub() -> Result<(), Error> {
    macro_rules! five_bar {
        ($length:expr, $T:ty) => {{
            let of = <$T as Scalar>::literal;
            let (bar, rubs) = (|l: $T| Rod::uniform(l, of(0.8)), Coulomb::new(Revolute::smooth(), of(0.01)));
            let side = (RigidBody::massless([of(0.5), of(0.0)]), rubs, bar(of(0.15)), Pin, bar(of(0.45)));
            let net = Network::new((rubs, bar($length), Pin, bar(of(0.4))), side, Pin);
            System::new(Clamped::at(of(0.0), of(0.0), of(0.0)), net, Free)?.with_gravity(of(9.81))
        }};
    }
    by_length!(five_bar, [1.0, 0.7, 0.5, 2.2], 0.2);
    macro_rules! slider_crank {
        ($length:expr, $T:ty) => {{
            let of = <$T as Scalar>::literal;
            let bar = |l: $T| Rod::uniform(l, of(0.8));
            let block = RigidBody::new(of(1.0), of(0.1), [of(0.0); 2], [of(0.0); 2]);
            let guide = Coulomb::new(Slider::along(of(0.0)), of(0.1));
            let net = Network::new((Pin, bar($length), Pin, bar(of(0.4))), (guide, block), Pin);
            System::new(Clamped::at(of(0.0), of(0.0), of(0.0)), net, Free)?.with_gravity(of(9.81))
        }};
    }
    by_length!(slider_crank, [1.0, -0.4], 0.2);
    macro_rules! held {
        ($length:expr, $T:ty) => {{
            let of = <$T as Scalar>::literal;
            let bar = |l: $T| Rod::uniform(l, of(0.8));
            let rubs = Coulomb::new(Revolute::smooth(), of(0.05));
            let chain = (rubs, bar($length), Pin, bar(of(0.9)), Pin, bar(of(0.6)), Pin, bar(of(0.5)));
            let root = Clamped::at(of(0.0), of(0.0), of(0.0));
            System::new(root, chain, Pinned::at(of(0.8), of(0.2)))?.with_gravity(of(9.81))
        }};
    }
    by_length!(held, [1.0, 0.2, -1.5, -0.5], 0.3);
    Ok(())
}

#[test]
fn a_linkage_of_space_that_rubs() -> Result<(), Error> {
    use spatial::{Ball, Clamped, Coulomb, Free, Network, Revolute, RigidBody, Rod, Rotation, System};
    macro_rules! linkage {
        ($length:expr, $T:ty) => {{
            let of = <$T as Scalar>::literal;
            let at = |x: [f64; 3]| x.map(of);
            let rod = |l: $T, m: f64| Rod::uniform(l, of(0.15), of(m));
            let rocker = Coulomb::new(Revolute::about(at([0.3, 1.0, 0.2])), of(0.01));
            let main = (Revolute::about(at([0.0, 0.0, 1.0])), rod($length, 0.3), Ball, rod(of(0.9), 0.9));
            let side = (RigidBody::massless(at([0.7, 0.1, 0.3])), rocker, rod(of(0.8), 0.8));
            let root = Clamped::at(at([0.0; 3]), Rotation::identity());
            System::new(root, Network::new(main, side, Ball), Free)?.with_gravity(at([0.5, -2.0, -9.0]))
        }};
    }
    by_length!(linkage, [0.4, 0.0, -0.5, 0.3, -1.1], 0.3);
    Ok(())
}

/// A body on a spring that stands on its foot, and jumps; the floor may be anywhere.
macro_rules! jump {
    ($x:expr, $T:ty, $above:expr) => {{
        let (x, of): (&[$T], _) = ($x, <$T as Scalar>::literal);
        let block = |mass: $T| RigidBody::new(mass, of(1.0), [of(0.0); 2], [of(0.0); 2]);
        let line = || Slider::along(of(FRAC_PI_2));
        let foot = HardStops::between(line(), [x[0], of(f64::INFINITY)]).rebounding(of(0.2));
        let leg = line().with(Spring::new(x[1]).damped(x[2]).resting_at(x[3]));
        let scene = System::new(Clamped::origin(), (foot, block(x[4]), leg, block(x[5])), Free)?.with_gravity(x[6]);
        let mut start = scene.motion();
        start.set_coordinates(&[x[0] + of($above), x[7]])?;
        (scene, start)
    }};
}

const JUMP: [f64; 8] = [0.1, 2e4, 20.0, 0.55, 2.0, 50.0, 9.81, 0.4];

#[test]
fn a_jump_from_a_stop() -> Result<(), Error> {
    let changes = as_forward!(Dop853::tolerance(1e-11), Dop853, 0.6, 1e-8, JUMP, |x, T| jump!(x, T, 0.0));
    assert!(changes > 1, "{changes}"); // it begins, and leaves the floor
    // By what pulls the leg: as from a hair above the floor.
    let by_pull = |above: f64| -> Result<f64, Error> {
        let (scene, start) = jump!(&JUMP[..], f64, above);
        let mut backward = scene.backward(Dop853);
        let course = backward.course(&start, Dop853::tolerance(1e-11), 0.3, &[0.0, 0.0, 100.0])?;
        let (last, mut by_torques) = (course.states().len() - 1, [0.0; 3]);
        let gradient = backward.gradient_past(&course, &mut by_torques, |step, _, by| {
            if step == last { by.add(&[1.0, 1.0], &[0.0; 2]) } else { Ok(()) }
        })?;
        assert_eq!(gradient.by_position()[0] == 0.0, above == 0.0);
        Ok(by_torques[2])
    };
    let [on, above] = [by_pull(0.0)?, by_pull(1e-12)?];
    assert!(on > 1e-5 && (on - above).abs() < 1e-8 * on, "{on} {above}");
    Ok(())
}
