//! Derivatives of squared frequencies: against closed forms, and against differences of the modes of scenes of plain numbers.

use catena::scalar::{Jet, Scalar};
use catena::{Error, planar, spatial};
use catena_oracle::near;
use std::f64::consts::FRAC_PI_2;

/// Squares of all modes and their derivatives by numbers, against central differences of squares of scenes of other numbers: `$made` makes scene, guess
/// of its rest, and loads.
macro_rules! as_differences {
    ($numbers:expr, $bound:expr, |$x:ident, $T:ident| $made:expr) => {{
        const N: usize = $numbers.len();
        macro_rules! squares {
            ($list:expr, $Number:ty) => {{
                #[allow(dead_code)]
                type $T = $Number;
                let $x: &[$T] = $list;
                let (scene, guess, loads) = $made;
                let rest = scene.equilibrium(guess, &loads)?;
                let modes = scene.modes(&rest, &loads)?;
                modes.iter().map(|mode| (mode.square(), mode.square_with_derivatives())).collect::<Vec<_>>()
            }};
        }
        let seeds: Vec<_> = (0..).zip($numbers).map(|(k, x)| Jet::<f64, N>::seed(x, k)).collect();
        let found = squares!(&seeds, Jet<f64, N>);
        assert!(!found.is_empty());
        for k in 0..N {
            let step = 1e-4 * f64::max(1.0, $numbers[k].abs());
            let at = |share: f64| {
                let mut numbers = $numbers;
                numbers[k] += share * step;
                Ok::<_, Error>(squares!(&numbers, f64))
            };
            let [one, other, two, others] = [at(1.0)?, at(-1.0)?, at(2.0)?, at(-2.0)?];
            for (mode, (square, jet)) in found.iter().enumerate() {
                let slope = (8.0 * (one[mode].1 - other[mode].1) - (two[mode].1 - others[mode].1)) / (12.0 * step);
                assert_eq!(jet.re, *square);
                println!("mode {mode}, by number {k}: {} {slope}", jet.eps[k]);
                near(jet.eps[k], slope, $bound * square.abs().max(1.0));
            }
        }
    }};
}

#[test]
fn of_a_double_pendulum_by_length_and_gravity() -> Result<(), Error> {
    use planar::*;
    let (length, gravity) = (Jet::<f64, 2>::seed(0.7, 0), Jet::seed(9.81, 1));
    let bob = PointMass::new(length, Jet::of(1.0));
    let scene = System::new(Pinned::origin(), (bob, Pin, bob), Free)?.with_gravity(gravity);
    let modes = scene.modes(&scene.at_rest(&[Jet::of(-FRAC_PI_2); 2])?, &Unloaded)?;
    for (mode, share) in modes.iter().zip([2.0 - 2f64.sqrt(), 2.0 + 2f64.sqrt()]) {
        let square = mode.square_with_derivatives();
        near(square.eps[0], -share * 9.81 / 0.49, 1e-10);
        near(square.eps[1], share / 0.7, 1e-11);
        let frequency = mode.frequency_with_derivatives();
        near(frequency.re, mode.frequency(), 1e-13);
        near(frequency.eps[1], 0.5 * (share / 0.7 / 9.81).sqrt(), 1e-12);
    }
    Ok(())
}

/// Of a stiff beam squares are in proportion to its stiffness, over four decades of frequencies, in double and in single precision.
#[test]
fn of_a_stiff_beam_by_its_stiffness() -> Result<(), Error> {
    use planar::*;
    macro_rules! squares {
        ($T:ty) => {{
            let (stiffness, of) = (Jet::<$T, 1>::seed(1e7, 0), Jet::<$T, 1>::of);
            let hinge = ElasticHinge::rotary(stiffness);
            let beam = System::new(Clamped::origin(), [(hinge, Rod::uniform(of(0.1), of(0.5))); 12], Free)?;
            let modes = beam.modes(&beam.motion(), &Unloaded)?;
            modes
                .iter()
                .map(|mode| (mode.square(), f64::from(mode.square_with_derivatives().eps[0])))
                .collect::<Vec<_>>()
        }};
    }
    for (list, bound) in [(squares!(f64), 1e-12), (squares!(f32), 1e-4)] {
        let largest = list.iter().fold(0.0_f64, |most, (square, _)| most.max(*square));
        assert!(list.len() == 12 && largest > 1e8);
        list.iter().for_each(|(square, slope)| near(*slope, square / 1e7, bound * largest / 1e7));
    }
    Ok(())
}

#[test]
fn of_chains_with_springs_and_struts() -> Result<(), Error> {
    use planar::*;
    as_differences!([0.4, 0.9, 30.0, 9.81, 0.3, 25.0], 1e-7, |x, T| {
        let rod = Rod::uniform(x[0], x[1]);
        let hinge = ElasticHinge::rotary(x[2]);
        let scene = System::new(Clamped::origin(), (hinge, rod, hinge, rod, hinge, rod), Free)?.with_gravity(x[3]);
        let zero = <T as Scalar>::literal(0.0);
        let strut = Strut::to_ground((1, [x[4], zero]), [x[0], x[0]]).with_stiffness(x[5]).with_length(x[4]);
        let guess = scene.motion();
        (scene, guess, Struts::of([strut]))
    });
    Ok(())
}

/// What holds a tip, and closes a loop, changes with the numbers, and the directions left open with it.
#[test]
fn of_held_tips_and_loops() -> Result<(), Error> {
    {
        use planar::*;
        as_differences!([0.3, 0.5, 9.81, 0.9, -0.1], 1e-7, |x, T| {
            let rod = Rod::uniform(x[0], x[1]);
            let scene = System::new(Pinned::origin(), (rod, Pin, rod, Pin, rod, Pin, rod), Pinned::at(x[3], x[4]))?;
            let guess = scene.at_rest(&[-0.9, -0.4, 0.4, 0.9].map(<T as Scalar>::literal))?;
            (scene.with_gravity(x[2]), guess, Unloaded)
        });
        as_differences!([0.5, 1.0, 0.6, 1.2, 9.81, 3.0], 1e-7, |x, T| {
            let of = <T as Scalar>::literal;
            let rod = |length: T| Rod::uniform(length, length);
            let crank = (ElasticHinge::rotary(x[5]), rod(x[0]), Pin, rod(x[1]));
            let net = Network::new(crank, (RigidBody::massless([x[3], of(0.0)]), Pin, rod(x[2])), Pin);
            let scene = System::new(Clamped::origin(), net, Free)?.with_gravity(x[4]);
            let guess = scene.at_rest(&[-1.9, 0.1, -1.3].map(of))?;
            (scene, guess, Unloaded)
        });
        // Parallel cranks, one of which is redundant.
        as_differences!([1.0, 1.0, 9.81], 1e-7, |x, T| {
            let of = <T as Scalar>::literal;
            let rod = Rod::uniform(x[0], x[1]);
            let reach = |share: f64| RigidBody::massless([x[0].scale(share), of(0.0)]);
            let inner = Network::new((Pin, rod, Pin, rod), (reach(1.0), Pin, rod), Pin);
            let net = Network::new((inner, rod), (reach(2.0), Pin, rod), LeastNorm(Pin));
            let scene = System::new(Clamped::origin(), net, Free)?.with_gravity(x[2]);
            let guess = scene.at_rest(&[-1.5, 0.0, -1.5, -1.5].map(of))?;
            (scene, guess, Unloaded)
        });
    }
    use spatial::*;
    as_differences!([0.3, 0.5, 0.1, 9.81, 0.7], 1e-6, |x, T| {
        let of = <T as Scalar>::literal;
        let zero = of(0.0);
        let tensor = [[of(0.02), zero, zero], [zero, x[2], zero], [zero, zero, of(0.05)]];
        let body = RigidBody::new(x[1], tensor, [x[0] * of(0.5), zero, of(0.02)], [x[0], zero, zero]);
        let scene = System::new(Pinned::origin(), (body, Ball, body, Ball, body), Pinned::at([x[4], zero, zero]))?;
        let guess = scene.at_rest(&[0.0, 0.5, 0.0, 0.0, -0.5, 0.0, 0.0, -0.5, 0.0].map(of))?;
        (scene.with_gravity([zero, zero, -x[3]]), guess, Unloaded)
    });
    Ok(())
}
