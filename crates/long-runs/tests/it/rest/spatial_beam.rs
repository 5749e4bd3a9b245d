//! Beams of segments in space: frequencies of both planes of bending and of torsion, deflections, elastica, derivatives.

mod shapes;
mod sweeps;

use catena::spatial::*;
use catena::{Error, Fault, Real, Scalar};
use catena_oracle::{has_order, near};
use core::f64::consts::PI;
use sweeps::frequencies;

/// L, EI about y and z, GJ, ρA, ρI_p, EA, GA along y and z: nothing is one.
const L: f64 = 1.5;
const EI: [f64; 2] = [2.0, 3.3];
const GJ: f64 = 1.7;
const RHO_A: f64 = 0.8;
/// So slender that the rotary inertia of its sections is no more than 1e-8 of a frequency of bending.
const RHO_I: f64 = 1e-8;
const EA: f64 = 50.0;
const GA: [f64; 2] = [40.0, 60.0];

fn beam() -> Beam<f64> {
    Beam::new(L, EI, GJ, RHO_A, RHO_I)
}

/// Relative errors of frequencies fall with 1/K².
#[track_caller]
fn converge(name: &str, exact: &[f64], found: &[(usize, Vec<f64>)], from: &[usize]) {
    for (k, exact) in exact.iter().enumerate() {
        let errors: Vec<(f64, f64)> =
            found.iter().map(|(n, found)| (1.0 / *n as f64, (found[k] / exact - 1.0).abs())).collect();
        has_order(&format!("{name}, mode {}", k + 1), 2.0, 1e-8, &errors[from[k]..]);
    }
}

#[test]
fn cantilevers_bend_in_both_planes_and_twist_at_second_order() -> Result<(), Error> {
    let mut found = [vec![], vec![], vec![]];
    for n in [5, 10, 20, 40] {
        // Turned anyhow: nothing depends on it.
        let root = Clamped::at([0.2, -0.1, 0.3], Rotation::from_angles([0.4, -0.7, 1.1]));
        let scene = System::new(root, beam().segments_in_vec(n), Free)?;
        let modes = frequencies(&scene, &scene.motion())?;
        // A straight beam either twists, or bends about y, or about z.
        for (axis, found) in found.iter_mut().enumerate() {
            let own = |shape: &Vec<f64>| {
                let others = shape.iter().enumerate().filter(|(i, _)| i % 3 != axis).map(|(_, x)| x.abs());
                others.fold(0.0, f64::max) < 1e-5
            };
            let own: Vec<f64> = modes.iter().filter(|(_, shape)| own(shape)).map(|(frequency, _)| *frequency).collect();
            assert_eq!(own.len(), n);
            found.push((n, own));
        }
    }
    // Clamped-free: cos βL cosh βL = −1.
    let bending = |ei: f64| {
        [1.8751040687, 4.6940911330, 7.8547574382].map(|x: f64| x * x * (ei / RHO_A).sqrt() / (L * L)).to_vec()
    };
    let twist: Vec<f64> = [1.0, 3.0, 5.0].map(|odd| 0.5 * odd * PI * (GJ / RHO_I).sqrt() / L).to_vec();
    converge("torsion", &twist, &found[0], &[0, 0, 1]);
    converge("bending about y", &bending(EI[0]), &found[1], &[0, 1, 1]);
    converge("bending about z", &bending(EI[1]), &found[2], &[0, 1, 1]);
    Ok(())
}

#[test]
fn bars_stretch_at_second_order() -> Result<(), Error> {
    let mut found = vec![];
    for n in [5, 10, 20, 40] {
        let scene = System::new(Clamped::origin(), beam().with_extension(EA).segments_in_vec(n), Free)?;
        let modes = frequencies(&scene, &scene.motion())?;
        let is_bar = |shape: &Vec<f64>| shape.iter().enumerate().all(|(i, x)| i % 4 == 0 || x.abs() < 1e-5);
        let bar: Vec<f64> = modes.iter().filter(|(_, shape)| is_bar(shape)).map(|mode| mode.0).collect();
        assert_eq!(bar.len(), n);
        found.push((n, bar));
    }
    let exact = [1.0, 3.0].map(|odd| 0.5 * odd * PI * (EA / RHO_A).sqrt() / L);
    converge("bar", &exact, &found, &[0, 1]);
    Ok(())
}

#[test]
fn parameters_that_make_no_mechanics_are_refused() {
    let make = |[length, ei, gj, density, polar, ea, ga, time]: [f64; 8]| {
        let beam =
            Beam::new(length, [1.0, ei], gj, density, polar).with_extension_and_shear(ea, [1.0, ga]).damped(time);
        System::new(Clamped::origin(), beam.segments::<4>(), Free).map(|_| ()).map_err(|error| error.fault)
    };
    let good = [1.0, 1.0, 1.0, 1.0, 0.01, 1.0, 1.0, 0.1];
    let with = |k: usize, x: f64| make(core::array::from_fn(|i| if i == k { x } else { good[i] }));
    assert_eq!(make(good), Ok(()));
    assert!(matches!(with(0, 0.0), Err(Fault::NotPositive { parameter: "length", .. })));
    for k in [1, 2, 5, 6] {
        assert!(matches!(with(k, -1.0), Err(Fault::Negative { parameter: "stiffness", .. })), "{k}");
        assert!(matches!(with(k, f64::NAN), Err(Fault::NotFinite { parameter: "stiffness" })), "{k}");
        assert_eq!(with(k, 0.0), Ok(()));
    }
    assert!(matches!(with(3, 0.0), Err(Fault::NotPositive { parameter: "mass", .. })));
    assert!(matches!(with(4, -0.1), Err(Fault::Negative { parameter: "moment of inertia", .. })));
    assert!(matches!(with(7, -0.1), Err(Fault::Negative { parameter: "damping", .. })));
}

#[test]
fn arrays_vectors_and_lifted_beams_are_the_same_chain() {
    use catena::Lift;
    macro_rules! compare {
        ($beam:expr) => {
            let beam = $beam;
            let (first, links) = beam.segments::<5>();
            let (same, vector) = beam.segments_in_vec(5);
            assert_eq!((first, &links[..]), (same, &vector[..]));
            assert_eq!(beam.lift(&mut |x: f64| x).segments::<5>(), (first, links));
            assert_eq!(beam.segments::<0>().1, []); // a rigid rod
            assert_eq!(beam.segments::<0>().0.length(), L);
        };
    }
    compare!(beam());
    compare!(beam().with_extension(EA));
    compare!(beam().with_extension_and_shear(EA, GA).damped(0.01));
}

/// Beams of ten segments before and after other elements, in tuples, arrays and vectors.
#[test]
fn beams_stand_anywhere_in_a_chain() -> Result<(), Error> {
    let thick = Beam::new(L, EI, GJ, RHO_A, 0.01);
    let (beam, hub) = (thick.with_extension(EA).damped(0.01), Rod::uniform(0.3, 0.05, 0.4));
    let pin = Revolute::about([0.0, 1.0, 0.2]);
    let array =
        System::new(Pinned::origin(), (hub, beam.segments::<10>(), pin, hub), Free)?.with_gravity([0.0, -9.81, 0.0]);
    let vector =
        System::new(Pinned::origin(), (hub, beam.segments_in_vec(10), pin, hub), Free)?.with_gravity([0.0, -9.81, 0.0]);
    let (first, [l0, l1, l2, l3, l4, l5, l6, l7, l8, l9]) = beam.segments::<10>();
    let links = (l0, l1, (l2, l3), l4, [l5, l6, l7], l8, l9);
    let tuple = System::new(Pinned::origin(), ((hub, first), links, pin, hub), Free)?.with_gravity([0.0, -9.81, 0.0]);
    macro_rules! tip {
        ($system:expr, $rule:expr) => {{
            let angles: Vec<f64> = (0..34).map(|k| 0.05 * f64::from(k).sin()).collect();
            let run = $system.simulate($system.at_rest(&angles)?, $rule, 0.02, |_| ())?;
            let stations = $system.stations(&run.motion, &Unloaded).unwrap();
            (stations.tip().frame.place, stations.root().internal.force)
        }};
    }
    macro_rules! compare {
        ($rule:expr) => {
            let found = tip!(array, $rule);
            assert!(found.0.norm() > 0.5 && found.1.norm().is_finite());
            assert_eq!(found, tip!(vector, $rule));
            assert_eq!(found, tip!(tuple, $rule));
        };
    }
    compare!(Sdirk4::new().step(0.002));
    compare!(GeneralizedAlpha::new(0.8).step(0.002));
    Ok(())
}

/// Place of the tip of a cantilever that falls from the horizontal and is twisted, by an implicit rule.
macro_rules! falls {
    ($name:ident, $rule:expr) => {
        fn $name<T: Scalar<Real: Real>>(
            [length, y, z, gj, density, polar, ea, ga, time]: [T; 9],
        ) -> Result<[T; 3], Error> {
            let (of, n) = (<T::Real as Real>::of, T::literal);
            let beam =
                Beam::new(length, [y, z], gj, density, polar).with_extension_and_shear(ea, [ga, ga]).damped(time);
            let scene = System::new(Clamped::origin(), beam.segments::<4>(), Free)?;
            let scene = scene.with_gravity_vector(nalgebra::Vector3::new(n(1.0), n(-9.0), n(4.0)));
            let twist = Loads::none().on_bodies(|_: T::Real, body, motion: &BodyMotion<T>| {
                let on = if body == 4 { 1.0 } else { 0.0 };
                motion.force_at([T::zero(), n(0.05), T::zero()], [T::zero(), T::zero(), n(3.0 * on)])
            });
            let rule = $rule;
            let run = scene.simulation(rule.step(of(0.01))).loads(&twist).run(scene.motion(), of(0.2), |_| ());
            let motion = run.map_err(|stop| stop.error)?.motion;
            Ok(scene.stations(&motion, &twist)?.tip().frame.place.into())
        }
    };
}
falls!(by_generalised_alpha, GeneralizedAlpha::new(0.8));
falls!(by_sdirk4, Sdirk4::new());

#[test]
fn tips_have_the_derivatives_that_differences_say() -> Result<(), Error> {
    use num_dual::Dual64;
    let at = [L, EI[0], EI[1], GJ, RHO_A, 0.002, EA, GA[0], 0.01];
    let mut worst = 0.0_f64;
    for (i, name) in ["L", "EI_y", "EI_z", "GJ", "ρA", "ρI_p", "EA", "GA", "τ"].into_iter().enumerate() {
        let seeded = core::array::from_fn(|k| Dual64::new(at[k], if k == i { 1.0 } else { 0.0 }));
        let h = 1e-3 * at[i];
        let moved = |by: f64| core::array::from_fn(|k| if k == i { at[k] + by * h } else { at[k] });
        for (plain, found) in [
            (by_generalised_alpha as fn([f64; 9]) -> _, by_generalised_alpha(seeded)?),
            (by_sdirk4, by_sdirk4(seeded)?),
        ] {
            let (a, b, c, d) = (plain(moved(-2.0))?, plain(moved(-1.0))?, plain(moved(1.0))?, plain(moved(2.0))?);
            let expected: [f64; 3] = core::array::from_fn(|k| (a[k] - 8.0 * b[k] + 8.0 * c[k] - d[k]) / (12.0 * h));
            let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            assert!(size * at[i] > 1e-6, "{name} must matter: {expected:?}");
            for k in 0..3 {
                worst = worst.max((found[k].eps - expected[k]).abs() / size);
            }
        }
    }
    println!("worst relative error of a derivative {worst:.1e}");
    assert!(worst < 1e-6);
    Ok(())
}
