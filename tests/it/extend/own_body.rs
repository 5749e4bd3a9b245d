//! A tank in which liquid sloshes, against the same thing composed in another way.

use super::tank::{Liquid, Tank};
use catena::loading::Unloaded;
use catena::planar::*;
use catena::scalar::Jet;
use catena::{Error, Scalar};
use catena_oracle::near;

const GRAVITY: f64 = 9.81;
/// Of the tank: mass, moment of inertia, mass centre and outboard end; of the liquid: mass, place, direction, stiffness, damping.
const RIGID: (f64, f64, [f64; 2]) = (3.0, 0.4, [0.4, 0.05]);
const END: [f64; 2] = [0.9, -0.1];
const PLACE: [f64; 2] = [0.5, 0.2];
const DIRECTION: f64 = 0.3;
const STIFFNESS: f64 = 80.0;

/// A tank on a pin that carries a rod.
macro_rules! own {
    ($T:ty, $mass:expr, $damping:expr) => {{
        let of = |x: f64| <$T as Scalar>::literal(x);
        let spring = Spring::new(of(STIFFNESS)).damped(of($damping));
        let liquid = Liquid { mass: $mass, place: PLACE.map(of), direction: of(DIRECTION), spring };
        let tank = Tank::new((of(RIGID.0), of(RIGID.1), RIGID.2.map(of)), liquid, END.map(of));
        let rod = Rod::uniform(of(0.7), of(1.1));
        System::new(Pinned::at(of(0.0), of(0.0)), (tank, Pin, rod), Free).map(|scene| scene.with_gravity(of(GRAVITY)))
    }};
}

/// The same of other elements: the liquid is a point mass on a link that sets out from elsewhere on a massless body, and the tank's own
/// mass belongs to what lies beyond.
macro_rules! composed {
    ($T:ty, $mass:expr, $damping:expr) => {{
        let of = |x: f64| <$T as Scalar>::literal(x);
        const LINK: f64 = 0.3;
        let spring = Spring::new(of(STIFFNESS)).damped(of($damping));
        let begin = [PLACE[0] - LINK, PLACE[1]];
        let arm = (Slider::along(of(DIRECTION)).with(spring), PointMass::new(of(LINK), $mass));
        let [centre, end] = [RIGID.2, END].map(|at| [0, 1].map(|k| of(at[k] - begin[k])));
        let rest = RigidBody::new(of(RIGID.0), of(RIGID.1), centre, end);
        let rod = Rod::uniform(of(0.7), of(1.1));
        System::new(
            Pinned::at(of(0.0), of(0.0)),
            (RigidBody::massless(begin.map(of)), Branch(arm), rest, Pin, rod),
            Free,
        )
        .map(|scene| scene.with_gravity(of(GRAVITY)))
    }};
}

/// Numbers of coordinates: the angle of the tank, the liquid, the angle of the rod.
const PLACES: [f64; 3] = [-0.8, 0.12, 0.4];
const RATES: [f64; 3] = [1.3, -0.6, -2.0];

macro_rules! moving {
    ($scene:expr, $T:ty) => {{
        let of = |x: f64| <$T as Scalar>::literal(x);
        let mut start = $scene.motion();
        let mut numbers = PLACES.into_iter();
        catena::system::Position::replace(start.position_mut(), &mut |_| of(numbers.next().unwrap_or(f64::NAN)));
        $scene.with_accelerations($scene.with_rates(start, &RATES.map(of))?, &Unloaded)?
    }};
}

/// The numbers of rates or accelerations.
fn numbers<T: Scalar>(rate: &impl catena::system::Rate<T>) -> Vec<T> {
    let mut numbers = vec![];
    rate.visit(&mut |x| numbers.push(x));
    numbers
}

#[test]
fn it_moves_as_what_it_is_composed_of() -> Result<(), Error> {
    let (own, composed) = (own!(f64, 1.7, 0.9)?, composed!(f64, 1.7, 0.9)?);
    let (one, two) = (moving!(own, f64), moving!(composed, f64));
    let (found, expected) = (numbers(one.acceleration()), numbers(two.acceleration()));
    assert_eq!(found.len(), 3);
    for (found, expected) in found.iter().zip(&expected) {
        near(*found, *expected, 1e-12 * (1.0 + expected.abs()));
    }
    let (budget, other) = (own.budget(&one)?, composed.budget(&two)?);
    near(budget.kinetic, other.kinetic, 1e-12);
    near(budget.potential, other.potential, 1e-12);
    near(budget.angular_momentum, other.angular_momentum, 1e-12);
    let root = |force: Internal<f64>| [force.force.x, force.force.y, force.torque];
    let found = root(own.stations(&one, &Unloaded)?.root().internal);
    let expected = root(composed.stations(&two, &Unloaded)?.root().internal);
    found.into_iter().zip(expected).for_each(|(found, expected)| near(found, expected, 1e-11));
    Ok(())
}

#[test]
fn its_energy_stays() -> Result<(), Error> {
    let own = own!(f64, 1.7, 0.0)?;
    let start = moving!(own, f64);
    let (energy, mut drift) = (own.budget(&start)?.energy(), 0.0_f64);
    own.simulate(start, Dop853::tolerance(1e-13), 10.0, |now| {
        drift = drift.max((now.budget().energy() - energy).abs());
    })?;
    println!("energy drifts by {drift:e} J of {energy} J in 10 s");
    assert!(drift < 1e-11);
    Ok(())
}

#[test]
fn its_rest_and_modes_are_those_of_what_it_is_composed_of() -> Result<(), Error> {
    let (own, composed) = (own!(f64, 1.7, 0.0)?, composed!(f64, 1.7, 0.0)?);
    let one = own.equilibrium(own.at_rest(&[-1.5, -1.5])?, &Unloaded)?;
    let two = composed.equilibrium(composed.at_rest(&[-1.5, -1.5])?, &Unloaded)?;
    let place =
        |motion: &[f64; 2], other: &[f64; 2]| near((motion[0] - other[0]).hypot(motion[1] - other[1]), 0.0, 1e-12);
    let end = |frame: Frame<f64>| [frame.place.x, frame.place.y];
    place(&end(own.stations(&one, &Unloaded)?.tip().frame), &end(composed.stations(&two, &Unloaded)?.tip().frame));
    let (modes, expected) = (own.modes(&one, &Unloaded)?, composed.modes(&two, &Unloaded)?);
    assert_eq!(modes.len(), 3);
    for (found, expected) in modes.frequencies().zip(expected.frequencies()) {
        println!("{found} {expected}");
        near(found, expected, 1e-10 * expected);
    }
    Ok(())
}

#[test]
fn its_derivatives_are_those_of_what_it_is_composed_of() -> Result<(), Error> {
    type Dual = Jet<f64, 1>;
    let (own, composed) = (own!(Dual, Dual::seed(1.7, 0), 0.9)?, composed!(Dual, Dual::seed(1.7, 0), 0.9)?);
    let (one, two) = (moving!(own, Dual), moving!(composed, Dual));
    for (found, expected) in numbers(one.acceleration()).iter().zip(numbers(two.acceleration())) {
        assert!(expected.eps[0].abs() > 1e-3, "{expected:?}");
        near(found.eps[0], expected.eps[0], 1e-11 * (1.0 + expected.eps[0].abs()));
    }
    Ok(())
}

/// What goes through its parts goes through the whole: gradients backward, by the mass of the liquid, and Taylor series.
#[test]
fn gradients_go_backward_through_it_and_series_through_its_motion() -> Result<(), Error> {
    let scene = own!(f64, 1.7, 0.5)?;
    let start = moving!(scene, f64);
    let (mut backward, mut states) = (scene.backward(Rk4), [start; 101]);
    backward.run(&start, 5e-3, 100, &[], &mut states)?;
    let gradient = backward.gradient(&[], &states, &mut [], |step, _, by| {
        if step == 100 { by.add(&[0.0, 1.0, 0.0], &[0.0; 3]) } else { Ok(()) }
    })?;
    type Number = Jet<f64, 1>;
    let seeded = own!(Number, Number::seed(1.7, 0), 0.5)?;
    let run = seeded.simulate(moving!(seeded, Number), Rk4::step(Number::of(5e-3).re), 0.5, |_| ())?;
    let expected = run.motion.coordinates()[1].eps[0];
    let [by_mass] = gradient.along(&seeded)?;
    assert!(expected.abs() > 1e-4);
    near(by_mass, expected, 1e-12);
    let by_steps = scene.simulate(start, Dop853::tolerance(1e-12), 2.0, |_| ())?.motion.coordinates();
    let by_series = scene.simulate(start, Taylor::<24>::tolerance(1e-12), 2.0, |_| ())?.motion.coordinates();
    by_steps.iter().zip(by_series).for_each(|(a, b)| near(*a, b, 1e-10));
    Ok(())
}
