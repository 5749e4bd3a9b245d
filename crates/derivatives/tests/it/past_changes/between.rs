//! Under struts between bodies and couplings between joints, by all their numbers: against the same runs over jets, which go forward by the rule itself.

use super::{Many, WIDTH, hanging};
use crate::drag::Drag;
use catena::planar::*;
use catena::scalar::Scalar;
use catena::{Error, spatial};
use std::f64::consts::FRAC_PI_2;

/// An arm with friction in its shoulder and stops in its elbow.
macro_rules! arm {
    ($x:expr, $T:ty) => {{
        let (x, of): (&[$T], _) = ($x, <$T as Scalar>::literal);
        let rod = Rod::uniform(x[0], x[1]);
        let shoulder = Coulomb::new(Revolute::smooth(), x[2]).breaking_away(x[2] * of(1.4));
        let elbow = HardStops::between(Revolute::smooth(), [of(0.0), of(FRAC_PI_2)]).rebounding(x[3]);
        let scene = System::new(Clamped::origin(), (shoulder, rod, elbow, rod), Free)?.with_gravity(x[4]);
        let start = scene.at_rest(&[x[5], x[6]])?;
        (scene, start)
    }};
}

/// Its numbers.
const ARM: [f64; 7] = [0.8, 1.0, 0.3, 0.8, 9.81, -0.2, 0.9];

/// A number's derivative along its seeds.
fn along(by: f64, number: Many) -> [f64; WIDTH] {
    number.eps.map(|slope| by * slope)
}

fn sum<const N: usize>(lists: [[f64; WIDTH]; N]) -> [f64; WIDTH] {
    core::array::from_fn(|k| lists.iter().map(|list| list[k]).sum())
}

#[test]
fn struts_of_an_arm_with_stops_and_friction() -> Result<(), Error> {
    macro_rules! under {
        ($x:expr, $T:ty) => {{
            let ((scene, start), x) = (arm!($x, $T), &$x[ARM.len()..]);
            let across = Strut::between((0, [x[0], x[1]]), (1, [x[2], x[3]])).with_stiffness(x[4]).with_damping(x[5]);
            let down = Strut::to_ground((1, [x[7], x[8]]), [x[9], x[10]]).with_stiffness(x[11]);
            let of_law = [Spring::new(x[13]).damped(x[14]), Spring::new(x[15]).damped(x[16])];
            let (struts, drag) = ([across.with_length(x[6]).with_law(of_law[0]), down.with_law(of_law[1])], x[12]);
            let loads = Struts::of(struts).and(Loads::none().on_bodies_by(Drag { drag }));
            (scene, start, loads, loads, (struts, drag))
        }};
    }
    let struts = [0.3, 0.05, 0.5, -0.04, 30.0, 2.0, 0.35, 0.7, 0.02, 1.0, -0.4, 12.0, 0.15, 3.0, 0.2, 2.0, 0.3];
    let numbers = [&ARM[..], &struts].concat();
    let changes = as_forward_of!(Dop853::tolerance(1e-11), Dop853, 1.5, 1e-8, numbers, under, |gradient, parts| {
        let [by_drag] = *gradient.by_loads()? else { unreachable!() };
        sum([gradient.along_struts(&parts.0), along(by_drag, parts.1)])
    });
    assert!(changes > 3, "{changes}");
    Ok(())
}

/// Two fingers that close on each other, the one with friction and the other with stops, under a drag, with a strut between them.
#[test]
fn couplings_of_a_hand_with_stops_and_friction() -> Result<(), Error> {
    macro_rules! hand {
        ($x:expr, $T:ty) => {{
            let (x, of): (&[$T], _) = (&$x, <$T as Scalar>::literal);
            let finger = Rod::uniform(x[0], x[1]);
            let left = Coulomb::new(Revolute::smooth(), x[2]).breaking_away(x[2] * of(1.4)).named("left");
            let right = HardStops::between(Revolute::smooth(), [x[3], x[4]]).rebounding(x[5]).named("right");
            let scene = System::new(Clamped::origin(), (Branch((left, finger)), right, finger), Free)?;
            let scene = scene.with_gravity(x[6]);
            let coupling = Coupling::new("right", "left").ratio(x[7]).offset(x[8]);
            let couplings = Couplings::of(&scene, [coupling])?;
            let start = couplings.joined(scene.at_rest(&[x[9], of(0.0)])?);
            let strut =
                Strut::between((0, [x[11], x[12]]), (1, [x[11], -x[12]])).with_stiffness(x[13]).with_damping(x[14]);
            let (struts, drag) = ([strut.with_length(x[15])], Loads::none().on_bodies_by(Drag { drag: x[10] }));
            let loads = couplings.and(Struts::of(struts).and(drag));
            (scene, start, loads, loads, (couplings, x[10], struts))
        }};
    }
    let numbers = [0.8, 1.0, 0.3, -2.0, 0.2, 0.7, 9.81, -0.6, 0.1, 0.4, 0.05, 0.3, 0.02, 1.5, 0.05, 0.3];
    let changes = as_forward_of!(Dop853::tolerance(1e-11), Dop853, 1.5, 1e-8, numbers, hand, |gradient, parts| {
        let [by_drag] = *gradient.by_loads()? else { unreachable!() };
        sum([gradient.along_couplings(&parts.0), along(by_drag, parts.1), gradient.along_struts(&parts.2)])
    });
    assert!(changes > 3, "{changes}");
    Ok(())
}

/// Two arms that carry each other, the one of which follows the other, with friction in a shoulder and stops in an elbow.
#[test]
fn couplings_of_arms_that_carry_each_other() -> Result<(), Error> {
    macro_rules! arms {
        ($x:expr, $T:ty) => {{
            let (x, of): (&[$T], _) = (&$x, <$T as Scalar>::literal);
            let (bar, j) = (|k: usize| Rod::uniform(x[k], x[2]), Revolute::smooth());
            let shoulder = Coulomb::new(j, x[3]).breaking_away(x[3] * of(1.4));
            let elbow = HardStops::between(j, [x[4], of(3.0)]).rebounding(x[5]).named("left");
            let chain = (shoulder, bar(0), elbow, bar(1), j, bar(1), j.named("right"), bar(0));
            let scene = System::new(Clamped::origin(), chain, Pinned::at(x[6], of(0.0)))?.with_gravity(x[7]);
            let couplings = Couplings::of(&scene, [Coupling::new("right", "left").ratio(x[8]).offset(x[9])])?;
            let mut guess = scene.motion();
            guess.set_coordinates(&[2.3, -1.1, -1.0, -1.1].map(of))?;
            let start = scene.assembled(couplings.joined(guess), &couplings)?;
            (scene, start, couplings, couplings, couplings)
        }};
    }
    let numbers = [0.5, 0.9, 1.0, 0.4, -1.6, 0.5, 0.8, 9.81, 1.0, 0.02];
    let changes = as_forward_of!(Dop853::tolerance(1e-11), Dop853, 1.5, 1e-8, numbers, arms, |gradient, parts| {
        gradient.along_couplings(&parts)
    });
    assert!(changes > 3, "{changes}");
    Ok(())
}

/// Gears that rub on both shafts, one of which strikes stops: both come to rest at once, and stay.
#[test]
fn gears_that_come_to_rest() -> Result<(), Error> {
    macro_rules! gears {
        ($x:expr, $T:ty) => {{
            let (x, of): (&[$T], _) = (&$x, <$T as Scalar>::literal);
            let shaft = |friction| Coulomb::new(Revolute::smooth(), friction);
            let wheel = |inertia| RigidBody::new(of(1.0), inertia, [of(0.0); 2], [of(0.0); 2]);
            let chain = (Branch((shaft(x[0]).named("first"), wheel(x[1]))), shaft(x[2]).named("second"), wheel(x[3]));
            let scene = System::new(Clamped::origin(), chain, Free)?;
            let couplings = Couplings::of(&scene, [Coupling::new("second", "first").ratio(x[4])])?;
            let mut start = scene.at_rest(&[of(0.0); 2])?;
            start.set_rates(&[x[5], of(0.0)])?;
            let start = couplings.joined(start);
            (scene, start, couplings, couplings, couplings)
        }};
    }
    // They turn by ω² J / 2 M, with J and M as the first shaft feels them.
    let numbers = [0.4, 0.2, 0.3, 0.1, -2.0, 3.0];
    let changes = as_forward_of!(Dop853::tolerance(1e-11), Dop853, 2.5, 1e-8, numbers, gears, |gradient, parts| {
        gradient.along_couplings(&parts)
    });
    assert!(changes > 1, "{changes}");
    Ok(())
}

#[test]
fn struts_of_an_arm_in_space() -> Result<(), Error> {
    use spatial::{Ball, Coulomb, Free, HardStops, Pinned, Revolute, Strut, Struts, System};
    macro_rules! arm {
        ($x:expr, $T:ty) => {{
            let (x, of): (&[$T], _) = (&$x, <$T as Scalar>::literal);
            let zero = of(0.0);
            let body = hanging(x[0], [x[1], of(0.03), of(0.01)]);
            let elbow = HardStops::between(Revolute::about([of(1.0), zero, zero]), [x[2], x[3]]).rebounding(x[4]);
            let wrist = Coulomb::new(Revolute::about([zero, of(1.0), zero]), x[5]).breaking_away(x[5] * of(1.3));
            let scene = System::new(Pinned::origin(), (body, elbow, body, Ball, body, wrist, body), Free)?;
            let scene = scene.with_gravity([zero, zero, x[6]]);
            let rates = [0.3, 0.5, 0.2, 2.0, 0.1, 0.2, 0.3, 1.5].map(of);
            let start = scene.with_rates(scene.motion(), &rates)?;
            let inside = Strut::between((0, [x[7], x[8], x[9]]), (2, [x[10], x[11], x[12]]));
            let struts = [inside.with_stiffness(x[13]).with_damping(x[14]).with_length(x[15])];
            (scene, start, Struts::of(struts), Struts::of(struts), struts)
        }};
    }
    let arm = [0.9, 0.02, -0.3, 0.5, 0.6, 0.1, -9.81];
    let strut = [0.1, 0.02, -0.1, -0.05, 0.04, -0.3, 20.0, 1.5, 0.3];
    let numbers = [&arm[..], &strut].concat();
    let changes = as_forward_of!(Dop853::tolerance(1e-11), Dop853, 1.5, 1e-8, numbers, arm, |gradient, struts| {
        gradient.along_struts(&struts)
    });
    assert!(changes > 2, "{changes}");
    Ok(())
}
