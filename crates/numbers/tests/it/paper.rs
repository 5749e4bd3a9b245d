//! The paper's scheme with every kind of number, and derivatives through it.

use catena::loading::Unloaded;
use catena::paper::*;
use catena::planar::index::{X, Y};
use catena::planar::{ElasticHinge, Free, Pinned, Rod, System};
use catena::{Error, Scalar};
use nalgebra::SVector;
use num_dual::{Derivative, Dual64, DualSVec64, HyperDual64};
use simba::simd::WideF64x4;

/// Example 2: the tip (m) of a flexible pendulum of 20 rods after 0.2 s, by one formulation; derivatives are those of the steps taken.
macro_rules! tip {
    ($T:ty, $stiffness:expr, $scheme:expr) => {{
        let number = <$T as Scalar>::literal;
        let rod = Rod::uniform(number(0.05), number(0.05));
        let chain = (rod, [(ElasticHinge::rotary($stiffness), rod); 19]);
        let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(number(9.81));
        let start = scene.at_rest(&[number(-1.0); 20])?;
        let dt = <<$T as Scalar>::Real as catena::Real>::of(0.004);
        let mut run = $scheme.start(&scene, &start, &Unloaded, dt)?;
        for _ in 0..50 {
            run.step()?;
        }
        let tip = run.stations()[40];
        Ok::<[$T; 2], Error>([tip[X], tip[Y]])
    }};
}

macro_rules! each_formulation {
    ($test:ident) => {{
        let alpha = Scheme::new(GeneralizedAlpha::new(0.8)).solved_by(Solver::Riccati);
        $test!("as printed", alpha);
        $test!("predictor", alpha.linearized(At::Predictor));
        $test!("iterated", alpha.linearized(At::Iterated));
        $test!("Newmark 0.6", Scheme::new(Newmark::damped(0.6)).solved_by(Solver::Riccati));
        $test!("Park", Scheme::new(Multistep::PARK).solved_by(Solver::Riccati));
        $test!("Wilson", Scheme::new(Wilson::new(1.42)).solved_by(Solver::Riccati));
        $test!("joints", JointScheme::new(Newmark::new(0.25, 0.5)));
        $test!("joints, one sweep", JointScheme::new(GeneralizedAlpha::new(0.8)).with_sweeps(1));
    }};
}

#[test]
fn derivative_with_respect_to_the_hinges_stiffness() -> Result<(), Error> {
    macro_rules! test {
        ($name:expr, $scheme:expr) => {{
            let dual = tip!(Dual64, Dual64::from(20.0).derivative(), $scheme)?;
            let plain = tip!(f64, 20.0, $scheme)?;
            let [more, less] = [tip!(f64, 20.0 + 1e-3, $scheme)?, tip!(f64, 20.0 - 1e-3, $scheme)?];
            for i in 0..2 {
                let difference = (more[i] - less[i]) / 2e-3;
                let error = (dual[i].eps / difference - 1.0).abs();
                println!("{}: {:.9e} {difference:.9e} {error:.1e}", $name, dual[i].eps);
                // A central difference is good to h² = 1e-6 of third derivatives / 6, and to rounding / h = 1e-12.
                assert!(error < 1e-6 && (dual[i].re - plain[i]).abs() < 1e-11, "{}", $name);
            }
        }};
    }
    each_formulation!(test);
    Ok(())
}

/// Several derivatives at once are those taken one by one.
#[test]
fn vectors_of_derivatives_do_what_single_ones_do() -> Result<(), Error> {
    macro_rules! test {
        ($name:expr, $scheme:expr) => {{
            let seeds = Derivative::some(SVector::from([1.0, -3.0]));
            let several = tip!(DualSVec64<2>, DualSVec64::new(20.0, seeds), $scheme)?;
            let single = tip!(Dual64, Dual64::from(20.0).derivative(), $scheme)?;
            for (several, single) in several.into_iter().zip(single) {
                let parts = several.eps.unwrap_generic(nalgebra::Const::<2>, nalgebra::Const::<1>);
                let errors = [parts[0] - single.eps, parts[1] + 3.0 * single.eps];
                assert!(errors.iter().all(|e| e.abs() < 1e-12), "{}: {errors:?}", $name); // of 1e-3
                assert_eq!(several.re, single.re);
            }
        }};
    }
    each_formulation!(test);
    Ok(())
}

/// Second derivatives, through the plain product too.
#[test]
fn second_derivative_of_the_printed_scheme() -> Result<(), Error> {
    macro_rules! angle {
        ($T:ty, $stiffness:expr, $solver:expr) => {{
            let number = <$T as Scalar>::literal;
            let rod = Rod::uniform(number(0.5), number(0.5));
            let scene = System::new(Pinned::origin(), (rod, ElasticHinge::rotary($stiffness), rod), Free)?
                .with_gravity(number(9.81));
            let start = scene.at_rest(&[number(-1.0), number(-0.5)])?;
            let scheme = Scheme::new(Newmark::damped(0.6)).solved_by($solver);
            let mut run = scheme.start(&scene, &start, &Unloaded, 0.01)?;
            run.run_to(0.3)?;
            Ok::<$T, Error>(run.turn(1).unwrap()[0])
        }};
    }
    let seeded = HyperDual64::new(5.0, 1.0, 1.0, 0.0);
    let [product, riccati] = [Solver::Product, Solver::Riccati].map(|solver| angle!(HyperDual64, seeded, solver));
    let (product, riccati) = (product?, riccati?);
    let first = |stiffness: f64| -> Result<f64, Error> {
        Ok(angle!(Dual64, Dual64::from(stiffness).derivative(), Solver::Riccati)?.eps)
    };
    let difference = (first(5.001)? - first(4.999)?) / 2e-3;
    println!("{} {} {difference}", product.eps1eps2, riccati.eps1eps2);
    assert!((product.eps1eps2 - riccati.eps1eps2).abs() < 1e-8 * difference.abs());
    assert!((riccati.eps1eps2 / difference - 1.0).abs() < 1e-6);
    Ok(())
}

#[test]
fn lanes_do_what_plain_numbers_do() -> Result<(), Error> {
    let stiffness = [15.0, 20.0, 25.0, 30.0];
    macro_rules! test {
        ($name:expr, $scheme:expr) => {{
            let [x, y] = tip!(WideF64x4, WideF64x4::from(stiffness), $scheme)?;
            for (lane, stiffness) in stiffness.into_iter().enumerate() {
                let plain = tip!(f64, stiffness, $scheme)?;
                let errors = [x.into_arr()[lane] - plain[0], y.into_arr()[lane] - plain[1]];
                // Where sweeps are counted by the worst lane, the others take more of them than alone.
                assert!(errors.iter().all(|e| e.abs() < 1e-11), "{}: {errors:?}", $name);
            }
        }};
    }
    each_formulation!(test);
    Ok(())
}

/// Increments keep what single precision has.
#[test]
fn single_precision_follows_double() -> Result<(), Error> {
    macro_rules! test {
        ($name:expr, $scheme:expr) => {{
            let (single, double) = (tip!(f32, 20.0_f32, $scheme)?, tip!(f64, 20.0, $scheme)?);
            let error = (f64::from(single[0]) - double[0]).abs().max((f64::from(single[1]) - double[1]).abs());
            println!("{}: {error:.1e} m", $name);
            assert!(error < 5e-6, "{}: {error:e}", $name); // 50 steps of rounding of 6e-8
        }};
    }
    each_formulation!(test);
    Ok(())
}

/// In space: the tip (m) of three rods with springs between after 0.2 s, by one formulation.
macro_rules! tip_in_space {
    ($T:ty, $stiffness:expr, $scheme:expr) => {{
        use catena::spatial;
        let number = <$T as Scalar>::literal;
        let rod = spatial::Rod::uniform(number(0.3), number(0.1), number(0.4));
        let hinge = spatial::ElasticBall::rotary([$stiffness; 3]).damped(number(0.02));
        let chain = (rod, hinge, rod, spatial::Ball, rod);
        let scene = spatial::System::new(spatial::Pinned::origin(), chain, spatial::Free)?
            .with_gravity([0.0, -9.81, 0.0].map(number));
        let start = scene.at_rest(&[0.3, 0.2, -0.4, -0.2, 0.1, 0.3, 0.1, -0.2, 0.5].map(number))?;
        let dt = <<$T as Scalar>::Real as catena::Real>::of(0.004);
        let mut run = $scheme.start(&scene, &start, &Unloaded, dt)?;
        for _ in 0..50 {
            run.step()?;
        }
        let tip = run.stations()[6];
        Ok::<[$T; 3], Error>([tip[0], tip[1], tip[2]])
    }};
}

/// Dual numbers, lanes and single precision in space, in both slots.
#[test]
fn every_number_runs_in_space() -> Result<(), Error> {
    for slots in [Slots::Angles, Slots::RotationVectors] {
        for at in [At::Previous, At::Predictor, At::Iterated] {
            let scheme =
                Scheme::new(GeneralizedAlpha::new(0.8)).solved_by(Solver::Riccati).turning_by(slots).linearized(at);
            let dual = tip_in_space!(Dual64, Dual64::from(5.0).derivative(), scheme)?;
            let plain = tip_in_space!(f64, 5.0, scheme)?;
            let [more, less] = [tip_in_space!(f64, 5.001, scheme)?, tip_in_space!(f64, 4.999, scheme)?];
            let single = tip_in_space!(f32, 5.0_f32, scheme)?;
            let stiffness = [5.0, 4.0, 6.0, 8.0];
            let lanes = tip_in_space!(WideF64x4, WideF64x4::from(stiffness), scheme)?;
            let largest = (0..3).fold(0.0_f64, |largest, i| largest.max(((more[i] - less[i]) / 2e-3).abs()));
            for i in 0..3 {
                let difference = (more[i] - less[i]) / 2e-3;
                let error = (dual[i].eps - difference).abs() / largest;
                println!("{slots:?} {at:?}: {:.9e} {difference:.9e} {error:.1e}", dual[i].eps);
                assert!(error < 1e-6 && (dual[i].re - plain[i]).abs() < 1e-11);
            }
            // Ā, formed of absolute angles, rounds to 6e-8 in every one of 50 steps, and turns forces by that.
            let rounding = (0..3).fold(0.0_f64, |worst, i| worst.max((f64::from(single[i]) - plain[i]).abs()));
            println!("{slots:?} {at:?}: single precision off by {rounding:.1e} m");
            assert!(rounding < 1e-4);
            for (lane, stiffness) in stiffness.into_iter().enumerate() {
                let alone = tip_in_space!(f64, stiffness, scheme)?;
                assert!((0..3).all(|i| (lanes[i].into_arr()[lane] - alone[i]).abs() < 1e-11));
            }
        }
    }
    Ok(())
}
