//! Taylor series under loads on bodies that depend on their motion and on time: coefficients, runs, changes from step to step.
//!
//! Coefficients are found a second time by one sweep over power series, which knows nothing of the walks of a series; those of one body on
//! a track by the equation of its motion.

use super::by_series::{
    apart, beside_dop853, beside_dop853_with_forces, closed_beside_dop853, expansion, move_alike, slope,
};
use catena::loading::LoadLaw;
use catena::scalar::{Jet, Powers, Scalar};
use catena::{Cause, Error, Fault, planar, spatial};
use catena_oracle::near;

/// Air that resists the mass centre by c v |v| and gusts along an axis, a jet along the body, and what brakes its turning.
#[derive(Clone, Copy)]
struct Air<T> {
    resistance: T,
    gust: T,
    thrust: T,
}
catena::lift!(Air<T> { resistance, gust, thrust });

impl<T: Scalar> Air<T> {
    fn of(mut number: impl FnMut(f64) -> T) -> Self {
        Self { resistance: number(0.3), gust: number(1.5), thrust: number(0.4) }
    }
}

impl<T: Scalar> LoadLaw<planar::BodyMotion<T>> for Air<T> {
    type Value = planar::Wrench<T>;
    fn at(&self, time: T::Real, body: usize, motion: &planar::BodyMotion<T>) -> planar::Wrench<T> {
        self.over_time(T::constant(time), body, motion)
    }
    fn over_time(&self, time: T, body: usize, motion: &planar::BodyMotion<T>) -> planar::Wrench<T> {
        let (centre, number) = (motion.inertia.centre, T::literal(1.0 + body as f64));
        let velocity = motion.centre().velocity;
        let (x, y) = (velocity.x - self.gust * (T::literal(2.0) * time).sin_cos().0, velocity.y);
        let drag = -self.resistance * number * (x * x + y * y + T::literal(0.01)).sqrt();
        let along = motion.direction * self.thrust;
        let jet = motion.force_at([T::literal(0.3), T::literal(0.1)], along.into());
        let braked = motion.rate() * self.resistance * T::literal(-0.02);
        motion.force_at(centre, [drag * x, drag * y]) + jet + planar::Wrench::torque(braked)
    }
}

impl<T: Scalar> LoadLaw<spatial::BodyMotion<T>> for Air<T> {
    type Value = spatial::Wrench<T>;
    fn at(&self, time: T::Real, body: usize, motion: &spatial::BodyMotion<T>) -> spatial::Wrench<T> {
        self.over_time(T::constant(time), body, motion)
    }
    fn over_time(&self, time: T, body: usize, motion: &spatial::BodyMotion<T>) -> spatial::Wrench<T> {
        let (centre, number) = (motion.inertia.centre, T::literal(1.0 + body as f64));
        let velocity = motion.centre().velocity;
        let (x, y, z) = (velocity.x - self.gust * (T::literal(2.0) * time).sin_cos().0, velocity.y, velocity.z);
        let drag = -self.resistance * number * (x * x + y * y + z * z + T::literal(0.01)).sqrt();
        let along = motion.turned([self.thrust, T::zero(), self.thrust]);
        let braked = motion.inboard.turn.spin * (-self.resistance * T::literal(0.02));
        motion.force_at(centre, [drag * x, drag * y, drag * z])
            + motion.force_at([T::literal(0.3), T::literal(0.1), T::zero()], along.into())
            + spatial::Wrench::torque(braked.into())
    }
}

/// Air at a time that is a power series.
struct At<T>(T, Air<T>);

macro_rules! at_a_series {
    ($($space:ident),*) => {$(
        impl<T: Scalar> LoadLaw<$space::BodyMotion<T>> for At<T> {
            type Value = $space::Wrench<T>;
            fn at(&self, _: T::Real, body: usize, motion: &$space::BodyMotion<T>) -> $space::Wrench<T> {
                self.1.over_time(self.0, body, motion)
            }
        }
    )*};
}
at_a_series!(planar, spatial);

/// A tree of the plane with an arm, of all bodies and joints that have series.
macro_rules! tree {
    () => {{
        use planar::*;
        let (rod, body) = (Rod::uniform(0.5, 0.5), RigidBody::new(0.8, 0.05, [0.2, 0.1], [0.4, -0.1]));
        let hinge = ElasticHinge::rotary(3.0).damped(0.1).resting_at(0.2);
        let arm = Branch((hinge, rod, Weld::at(0.4), body));
        let track = Slider::along(0.2).with(Spring::new(50.0).damped(0.5).resting_at(0.1));
        let chain = (body, arm, Pin, (PointMass::new(0.3, 0.2), track, rod, hinge, [(rod, Pin); 2], body));
        let scene = System::new(Clamped::at(0.1, 0.2, 0.3), chain, Free)?.with_gravity(9.81);
        let mut start = scene.motion();
        start.set_coordinates(&[0.3, -0.2, 0.1, 0.5, 0.4, 0.7])?;
        let start = scene.with_rates(start.at_time(0.7), &[0.3, -0.2, 0.5, 0.1, 0.7, -0.4])?;
        (scene, start)
    }};
}

/// A tree in space likewise, with joints of a kind.
macro_rules! tree_in_space {
    ($joint:expr, $angles:expr, $rates:expr) => {{
        use spatial::*;
        let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
        let body = RigidBody::new(1.0, tensor, [0.25, 0.03, -0.02], [0.5, 0.1, 0.05]);
        let (rod, bob) = (Rod::uniform(0.5, 0.05, 1.0), PointMass::new(0.3, 0.2));
        let hinge = Revolute::about([0.3, 1.0, 0.2]).with(Spring::new(3.0).damped(0.1).resting_at(0.2));
        let arm = Branch((hinge, rod, Weld::at(Rotation::from_angles([0.4, 0.1, 0.0])), body));
        let slide = Prismatic::along([0.6, 0.0, 0.8]).with(Spring::new(40.0).damped(0.2));
        let chain = (body, arm, $joint, rod, (hinge, bob, slide, rod, [($joint, body); 1]));
        let scene = System::new(Hinged::origin([0.0, 1.0, 0.0]), chain, Free)?.with_gravity([0.0, 0.0, -9.81]);
        let start = scene.at_rest(&$angles)?.at_time(0.7);
        let start = scene.with_rates(start, &$rates)?;
        (scene, start)
    }};
}

/// The largest share by which coefficients of accelerations miss those of one sweep over power series.
macro_rules! misses_a_sweep {
    ($scene:expr, $start:expr, $order:literal) => {{
        type Series = Powers<f64, $order>;
        let (scene, start) = ($scene, $start);
        let mut stepper = scene.stepper(Taylor::<$order>);
        let (loads, mut end) = (Loads::none().on_bodies_over_time(Air::of(|x| x)), start.clone());
        stepper.step(&start, &loads, 1e-3, &mut end)?;
        let over = scene.lift(Series::constant);
        let time = Series::variable(start.time(), $order);
        let loads = Loads::none().on_bodies_by(At(time, Air::of(Series::constant)));
        let swept = over.with_accelerations(stepper.motion_series(), &loads)?;
        let mut largest = 0.0_f64;
        let swept = swept.accelerations();
        for k in 0..$order {
            let (mut found, expected) = (vec![], swept.iter().map(|x| x.terms()[k]).collect::<Vec<f64>>());
            stepper.coefficients(k, |x| found.push(x));
            let size = expected.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            println!("order {k}: {size:.2e}, miss {:.1e}", apart(&found, &expected) / size);
            largest = largest.max(apart(&found, &expected) / size);
        }
        largest
    }};
}

#[test]
fn coefficients_are_those_of_a_sweep_over_power_series() -> Result<(), Error> {
    let of_plane = {
        use planar::*;
        let (scene, start) = tree!();
        misses_a_sweep!(scene, start, 16)
    };
    use spatial::*;
    // Coordinates of a ball within a step are not those of its rates.
    let crooked = Revolute::about([0.5, -0.6, 0.4]);
    let (scene, start) = tree_in_space!(crooked, [0.3, -0.2, 0.4, 0.1, 0.2], [0.5, -0.4, 0.9, -0.3, 0.6, 0.7]);
    let of_space = misses_a_sweep!(scene, start, 16);
    println!("missed by {of_plane:.1e}, {of_space:.1e}");
    assert!(of_plane < 1e-12 && of_space < 1e-12);
    Ok(())
}

/// A block on a track: m s̈ = f sin ω t − c ṡ − k s.
#[derive(Clone, Copy)]
struct Shaken<T> {
    amplitude: T,
    damping: T,
    stiffness: T,
}
catena::lift!(Shaken<T> { amplitude, damping, stiffness });

impl<T: Scalar> LoadLaw<planar::BodyMotion<T>> for Shaken<T> {
    type Value = planar::Wrench<T>;
    fn at(&self, time: T::Real, body: usize, motion: &planar::BodyMotion<T>) -> planar::Wrench<T> {
        self.over_time(T::constant(time), body, motion)
    }
    fn over_time(&self, time: T, _: usize, motion: &planar::BodyMotion<T>) -> planar::Wrench<T> {
        let catena::planar::BodyMotion { inboard, .. } = motion;
        let force = self.amplitude * (T::literal(3.0) * time).sin_cos().0
            - self.damping * inboard.velocity.x
            - self.stiffness * inboard.place.x;
        motion.force_at([T::zero(); 2], [force, T::zero()])
    }
}

#[test]
fn a_block_on_a_track_moves_as_its_equation_says() -> Result<(), Error> {
    use planar::*;
    const ORDER: usize = 20;
    let (mass, time, state) = (1.7, 0.4, [0.3, -0.8]);
    let block = RigidBody::new(mass, 0.1, [0.0; 2], [0.0; 2]);
    let scene = System::new(Clamped::origin(), (Slider::along(0.0), block), Free)?.with_gravity(9.81);
    let mut start = scene.motion();
    start.set_coordinates(&[state[0]])?;
    let start = scene.with_rates(start.at_time(time), &[state[1]])?;
    let law = Shaken { amplitude: 2.0, damping: 0.9, stiffness: 11.0 };
    let (found, stepped) = expansion!(20, scene, start, Loads::none().on_bodies_over_time(law), 1e-3);
    stepped?;
    let (mut place, mut rate, mut drive) = (state[0], state[1], law.amplitude);
    for (k, row) in found.iter().enumerate() {
        // f ωᵏ / k! times the sine of ω t + k π / 2.
        let angle = 3.0 * time + 0.5 * core::f64::consts::PI * k as f64;
        let force = drive * angle.sin() - law.damping * rate - law.stiffness * place;
        let next = force / mass / (k + 1) as f64;
        near(row[0] / next, 1.0, 1e-12);
        (place, rate, drive) = (rate / (k + 1) as f64, next, drive * 3.0 / (k + 1) as f64);
    }
    assert_eq!(found.len(), ORDER);
    Ok(())
}

#[test]
fn scenes_move_as_under_dop853() -> Result<(), Error> {
    {
        use planar::*;
        let air = || Loads::none().on_bodies_over_time(Air::of(|x| x));
        let (scene, start) = tree!();
        beside_dop853_with_forces!("tree", scene, air(), start, 1.7, abs);
        let torques = air().torques([0.0, 0.3, 0.0, 0.1, 0.2, 0.3, 0.1, 0.2]);
        beside_dop853_with_forces!("tree under torques", scene, torques, start, 1.7, abs);
        let wind: Vec<_> = (0..8).map(|k| Wrench { force: [0.3 * k as f64, 0.5].into(), torque: 0.1 }).collect();
        beside_dop853_with_forces!("tree under forces", scene, Loads::none().wrenches(&wind[..]), start, 1.7, abs);
        let rod = Rod::uniform(0.6, 0.5);
        let bridge = System::new(Pinned::origin(), (rod, Pin, rod, Pin, rod), Pinned::at(1.2, 0.2))?.with_gravity(9.81);
        closed_beside_dop853!("bridge", bridge, air(), bridge.at_rest(&[-0.9, 0.1, 0.8])?, 0.7, abs);
        let net = Network::new((Pin, rod, Pin, rod), (RigidBody::massless([0.8, 0.0]), Pin, rod), Pin);
        let four_bar = System::new(Clamped::origin(), net, Free)?.with_gravity(9.81);
        closed_beside_dop853!("four-bar", four_bar, air(), four_bar.at_rest(&[1.05, 0.32, 1.12])?, 0.7, abs);
    }
    use spatial::*;
    let air = || Loads::none().on_bodies_over_time(Air::of(|x| x));
    let angles = [0.2, 0.1, 0.3, -0.2, 0.1, 0.2, 0.1, 0.2, -0.1];
    let rates = [0.5, -0.4, 0.9, -0.3, 0.6, 0.7, -0.8, 0.4, 0.1, -0.5];
    let (scene, start) = tree_in_space!(Ball, angles, rates);
    beside_dop853_with_forces!("tree in space", scene, air(), start, 1.7, norm);
    let rod = Rod::uniform(0.6, 0.05, 0.5);
    let bridge = System::new(Pinned::origin(), (rod, Ball, rod, Ball, rod), Pinned::at([1.2, 0.1, 0.2]))?;
    let bridge = bridge.with_gravity([0.0, 0.0, -9.81]);
    let start = bridge.at_rest(&[0.0, 0.9, 0.1, 0.1, -0.1, 0.0, 0.0, -0.8, 0.2])?;
    closed_beside_dop853!("bridge in space", bridge, air(), start, 0.5, norm);
    Ok(())
}

/// Of loads that have changed a series knows, where the first coefficient of the load is the same, too.
#[test]
fn loads_may_be_others_in_each_step() -> Result<(), Error> {
    use planar::*;
    let (scene, start) = tree!();
    let still = scene.with_rates(start, &[0.0; 6])?.at_time(0.0);
    let loads = |resistance: f64| Loads::none().on_bodies_over_time(Air { resistance, gust: 0.0, thrust: 0.4 });
    let (mut whole, mut now, mut next) = (scene.stepper(Taylor::<16>), still, still);
    for step in 0..6 {
        let loads = loads(if step % 3 == 2 { 2.0 } else { 0.3 });
        let mut fresh = now;
        whole.step(&now, &loads, 0.004, &mut next)?;
        scene.stepper(Taylor::<16>).step(&now, &loads, 0.004, &mut fresh)?;
        assert_eq!(fresh.coordinates(), next.coordinates(), "step {step}");
        assert_eq!(fresh.accelerations(), next.accelerations(), "step {step}");
        core::mem::swap(&mut now, &mut next);
    }
    Ok(())
}

#[test]
fn no_step_expands_twice() -> Result<(), Error> {
    use planar::*;
    let (scene, start) = tree!();
    let loads = Loads::none().on_bodies_over_time(Air::of(|x| x));
    let run = scene.simulation(Taylor::<20>::tolerance(1e-10)).loads(&loads).run(start, 1.7, |_| ())?;
    println!("{} steps, {} sweeps", run.steps, run.sweeps);
    assert!(run.sweeps == run.steps && run.rejected == 0);
    Ok(())
}

/// A law that looks at the time, but says nothing of power series.
#[derive(Clone, Copy)]
struct Timed;
catena::lift!(Timed);

impl<T: Scalar> LoadLaw<planar::BodyMotion<T>> for Timed {
    type Value = planar::Wrench<T>;
    fn at(&self, time: T::Real, _: usize, _: &planar::BodyMotion<T>) -> planar::Wrench<T> {
        planar::Wrench::torque(T::constant(time))
    }
}

#[test]
fn laws_of_time_that_are_not_written_over_series_are_refused() -> Result<(), Error> {
    use planar::*;
    let (scene, start) = tree!();
    let loads = Loads::none().on_bodies_over_time(Timed);
    let run = scene.simulation(Taylor::<12>::tolerance(1e-8)).loads(&loads).run(start, 0.8, |_| ());
    let error = run.err().map(|error| (error.error.fault, error.error.time));
    assert!(matches!(error, Some((Fault::StepTooSmall { cause: Cause::NonFiniteLoad, .. }, Some(0.7)))), "{error:?}");
    let (mut stepper, mut next) = (scene.stepper(Taylor::<12>), start);
    let error = stepper.step(&start, &loads, 0.01, &mut next).err().map(|error| error.fault);
    assert_eq!(error, Some(Fault::NonFiniteLoad));
    scene.simulation(Dop853::tolerance(1e-8)).loads(&loads).run(start, 0.8, |_| ())?;
    Ok(())
}

#[test]
fn derivatives_by_a_load_are_slopes_of_runs() -> Result<(), Error> {
    use planar::*;
    macro_rules! ends {
        ($resistance:expr, $of:expr) => {{
            let rod = Rod::uniform($of(0.5), $of(0.5));
            let scene = System::new(Pinned::at($of(0.0), $of(0.0)), (rod, Pin, rod), Free)?.with_gravity($of(9.81));
            let loads = Loads::none().on_bodies_over_time(Air { resistance: $resistance, ..Air::of($of) });
            let start = scene.at_rest(&[$of(0.3), $of(0.6)])?;
            scene.simulation(Taylor::<16>::tolerance(1e-11)).loads(&loads).run(start, 0.5, |_| ())?.motion.coordinates()
        }};
    }
    let of = |resistance: f64| -> Result<Vec<f64>, Error> { Ok(ends!(resistance, |x: f64| x)) };
    let jets: Vec<Jet<f64, 1>> = ends!(Jet::seed(0.7, 0), Jet::<f64, 1>::of);
    for (k, jet) in jets.iter().enumerate() {
        let slope = slope(1e-3, |e| Ok(of(0.7 + e)?[k]))?;
        println!("coordinate {k}: {} by {slope}", jet.eps[0]);
        assert!(slope.abs() > 1e-3);
        near(jet.eps[0], slope, 1e-8);
    }
    Ok(())
}
