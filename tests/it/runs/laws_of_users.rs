//! Laws that users write for joints: under implicit rules they are the same motion as under any other, stops among them, and rules keep
//! their order where a law is smooth. The truth is an integration of the equations of Lagrange that shares no code with the library.

mod by_lagrange;
mod laws;

use by_lagrange::{GRAVITY, LENGTH, MASS, cart_and_rod, integrate, integrate_to_stops, two_rods};
use catena::loading::Unloaded;
use catena::system::Element;
use catena::system::{Dynamics, MotionOf, Runs, StiffDynamics, System};
use catena::system::{Position, Rate};
use catena::system::{Root, Tip};
use catena::time::{GeneralizedAlpha, Sdirk4};
use catena::{Error, planar, spatial};
use catena_oracle::{has_order, near};
use laws::{Cubic, Stop};

const RK4: f64 = 2e-5; // (s): the truth, to 1e-12

fn rod() -> planar::Rod<f64> {
    planar::Rod::uniform(LENGTH, MASS)
}

fn rod_in_space() -> spatial::Rod<f64> {
    spatial::Rod::uniform(LENGTH, 1e-6, MASS)
}

/// Errors at the end of a run of this rule with steps of each size.
fn errors<S, R, C, P, const N: usize>(
    scene: &System<S, R, C, P>,
    start: MotionOf<S, R, C, P>,
    end: f64,
    steps: [usize; N],
    rule: &str,
    error: impl Fn(&[f64], &[f64]) -> f64,
) -> Result<Vec<(f64, f64)>, Error>
where
    S: catena::system::Space<Scalar = f64>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P> + StiffDynamics<Unloaded> + Dynamics<Unloaded>,
{
    let mut found = vec![];
    for steps in steps {
        let h = end / steps as f64;
        let last = match rule {
            "alpha" => scene.simulate(start.clone(), GeneralizedAlpha::new(0.8).step(h), end, |_| ())?.motion,
            _ => scene.simulate(start.clone(), Sdirk4::new().step(h), end, |_| ())?.motion,
        };
        let (mut position, mut rate) = (vec![], vec![]);
        last.position().visit(&mut |x| position.push(x));
        last.rate().visit(&mut |x| rate.push(x));
        found.push((h, error(&position, &rate)));
    }
    Ok(found)
}

fn largest(errors: [f64; 4]) -> f64 {
    errors.map(f64::abs).into_iter().fold(0.0, f64::max)
}

/// Stiff, strongly curved, and damped by the square of the rate.
const CUBIC: Cubic = Cubic { stiffness: 60.0, cube: 900.0, damping: 0.2, square: 0.3 };

#[test]
fn rules_keep_their_order_on_a_smooth_law_in_a_hinge() -> Result<(), Error> {
    let end = 0.5;
    let truth = integrate([0.2, 0.9, 0.0, 1.0], end, RK4, |s| two_rods(s, |angle, rate| CUBIC.of(angle, rate)));

    let chain = (rod(), planar::ElasticHinge::with(CUBIC), rod());
    let scene = planar::System::new(planar::Pinned::origin(), chain, planar::Free)?.with_gravity(GRAVITY);
    let start = scene.with_rates(scene.at_rest(&[0.2, 0.9])?, &[0.0, 1.0])?;
    let error = |p: &[f64], r: &[f64]| {
        largest([p[0] - truth[0], p[0] + p[1] - truth[1], r[0] - truth[2], r[0] + r[1] - truth[3]])
    };
    let found = errors(&scene, start, end, [200, 400, 800, 1600], "alpha", error)?;
    has_order("generalised alpha, plane", 2.0, 1e-11, &found);
    let found = errors(&scene, start, end, [500, 750, 1125, 1688], "sdirk", error)?;
    has_order("SDIRK4, plane", 4.0, 1e-11, &found);

    let axis = spatial::Revolute::about([0.0, 0.0, 1.0]);
    let chain = (axis, rod_in_space(), axis.with(CUBIC), rod_in_space());
    let scene =
        spatial::System::new(spatial::Clamped::origin(), chain, spatial::Free)?.with_gravity([0.0, -GRAVITY, 0.0]);
    let mut start = scene.with_rates(scene.motion(), &[0.0, 1.0])?;
    *start.position_mut() = ((), (0.2, (), 0.7, ()));
    let error = |p: &[f64], r: &[f64]| {
        largest([p[0] - truth[0], p[0] + p[1] - truth[1], r[0] - truth[2], r[0] + r[1] - truth[3]])
    };
    let found = errors(&scene, start, end, [200, 400, 800, 1600], "alpha", error)?;
    has_order("generalised alpha, space", 2.0, 1e-10, &found);
    let found = errors(&scene, start, end, [500, 750, 1125, 1688], "sdirk", error)?;
    has_order("SDIRK4, space", 4.0, 1e-10, &found);
    Ok(())
}

#[test]
fn rules_keep_their_order_on_a_smooth_law_along_a_line() -> Result<(), Error> {
    let (end, law) = (0.5, Cubic { stiffness: 200.0, cube: 4000.0, damping: 1.0, square: 3.0 });
    let truth = integrate([0.3, -0.4, 0.5, 0.0], end, RK4, |s| cart_and_rod(s, |x, v| law.of(x, v)));

    let cart = planar::RigidBody::new(by_lagrange::CART, 0.1, [0.0; 2], [0.0; 2]);
    let chain = (planar::Slider::along(0.0).with(law), cart, planar::Pin, rod());
    let scene = planar::System::new(planar::Clamped::at(0.0, 0.0, 0.0), chain, planar::Free)?.with_gravity(GRAVITY);
    let mut start = scene.with_rates(scene.motion(), &[0.5, 0.0])?;
    *start.position_mut() = ((), (0.3, (), -0.4, ()));
    let error = |p: &[f64], r: &[f64]| largest([p[0] - truth[0], p[1] - truth[1], r[0] - truth[2], r[1] - truth[3]]);
    let found = errors(&scene, start, end, [200, 400, 800, 1600], "alpha", error)?;
    has_order("generalised alpha, plane", 2.0, 1e-11, &found);
    let found = errors(&scene, start, end, [80, 120, 180, 270], "sdirk", error)?;
    has_order("SDIRK4, plane", 4.0, 1e-11, &found);

    let tensor = [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]];
    let cart = spatial::RigidBody::new(by_lagrange::CART, tensor, [0.0; 3], [0.0; 3]);
    let track = spatial::Prismatic::along([1.0, 0.0, 0.0]).with(law);
    let chain = (track, cart, spatial::Revolute::about([0.0, 0.0, 1.0]), rod_in_space());
    let scene =
        spatial::System::new(spatial::Clamped::origin(), chain, spatial::Free)?.with_gravity([0.0, -GRAVITY, 0.0]);
    let mut start = scene.with_rates(scene.motion(), &[0.5, 0.0])?;
    *start.position_mut() = ((), (0.3, (), -0.4, ()));
    let found = errors(&scene, start, end, [200, 400, 800, 1600], "alpha", error)?;
    has_order("generalised alpha, space", 2.0, 1e-10, &found);
    let found = errors(&scene, start, end, [80, 120, 180, 270], "sdirk", error)?;
    has_order("SDIRK4, space", 4.0, 1e-10, &found);
    Ok(())
}

/// All three coordinates of a hinge, in the plane and (with a rotary spring) in space: beside an explicit rule, which reads no slopes.
#[test]
fn rules_keep_their_order_on_smooth_laws_of_displacement() -> Result<(), Error> {
    let end = 0.3;
    let law = Cubic { stiffness: 800.0, cube: 3e5, damping: 4.0, square: 10.0 };
    // Of all rates: positions in space are quaternions.
    macro_rules! distance {
        ($truth:expr) => {{
            let mut truth = vec![];
            Rate::visit($truth.rate(), &mut |x: f64| truth.push(x));
            move |_: &[f64], rates: &[f64]| {
                rates.iter().zip(&truth).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()))
            }
        }};
    }

    let hinge = planar::ElasticHinge::with(CUBIC).with_linear(law, law);
    let scene =
        planar::System::new(planar::Clamped::at(0.0, 0.0, 0.2), (rod(), hinge, rod(), hinge, rod()), planar::Free)?;
    let scene = scene.with_gravity(GRAVITY);
    let start = scene.motion();
    let truth = scene.simulate(start, planar::Dop853::tolerance(1e-13), end, |_| ())?.motion;
    let found = errors(&scene, start, end, [200, 400, 800], "alpha", distance!(truth))?;
    has_order("generalised alpha, plane", 2.0, 1e-10, &found);
    let found = errors(&scene, start, end, [120, 180, 270], "sdirk", distance!(truth))?;
    has_order("SDIRK4, plane", 4.0, 1e-10, &found);

    let hinge = spatial::ElasticHinge::rotary([60.0, 40.0, 50.0]).damped(0.2).with_linear(law, law, law);
    let rod = spatial::Rod::uniform(LENGTH, 0.05, MASS);
    let scene = spatial::System::new(spatial::Clamped::origin(), (rod, hinge, rod, hinge, rod), spatial::Free)?;
    let scene = scene.with_gravity([0.0, -GRAVITY, 0.0]);
    let start = scene.motion();
    let truth = scene.simulate(start, planar::Dop853::tolerance(1e-13), end, |_| ())?.motion;
    let found = errors(&scene, start, end, [200, 400, 800], "alpha", distance!(truth))?;
    has_order("generalised alpha, space", 2.0, 1e-10, &found);
    let found = errors(&scene, start, end, [120, 180, 270], "sdirk", distance!(truth))?;
    has_order("SDIRK4, space", 4.0, 1e-10, &found);
    Ok(())
}

/// The largest angle between two rods whose hinge meets a stop, and where they are at the end. The torque jumps at the stop, by 20 N·m·s
/// times the rate: a step of an implicit rule meets the stop before its first stage or after it, and error control does not see which.
#[test]
fn a_stop_acts_where_it_is_touched_and_nowhere_else() -> Result<(), Error> {
    let end = 1.0;
    for stiffness in [1e3, 1e5] {
        let stop = Stop { at: 0.5, stiffness, damping: 20.0 };
        let (truth, highest) = integrate_to_stops([0.0, 0.4, 0.0, 0.0], end, 1e-5, stop.at, |s, touching| {
            two_rods(s, |angle, rate| if touching { stop.touched(angle, rate) } else { 0.0 })
        });

        let chain = (rod(), planar::ElasticHinge::with(stop), rod());
        let scene = planar::System::new(planar::Pinned::origin(), chain, planar::Free)?.with_gravity(GRAVITY);
        let start = scene.at_rest(&[0.0, 0.4])?;
        let mut turned = 0.0_f64;
        let run = scene.simulate(start, Sdirk4::new().tolerance(1e-8), end, |now| {
            turned = turned.max(now.motion().position().1.1);
        })?;
        let (first, ((), second, ())) = *run.motion.position();
        println!(
            "plane, k = {stiffness:e}: {} steps, {} rejected, turns back at {turned}, truth {highest}",
            run.steps, run.rejected
        );
        near(turned, highest, 1e-4);
        near(first, truth[0], 1e-3);
        near(first + second, truth[1], 1e-3);
        let run = scene.simulate(start, GeneralizedAlpha::new(0.8).tolerance(1e-8), end, |_| ())?;
        let (first, ((), second, ())) = *run.motion.position();
        println!("generalised alpha: {} steps, {} rejected, off by {:e}", run.steps, run.rejected, first - truth[0]);
        near(first, truth[0], 5e-3);
        near(first + second, truth[1], 5e-3);

        let axis = spatial::Revolute::about([0.0, 0.0, 1.0]);
        let chain = (axis, rod_in_space(), axis.with(stop), rod_in_space());
        let scene =
            spatial::System::new(spatial::Clamped::origin(), chain, spatial::Free)?.with_gravity([0.0, -GRAVITY, 0.0]);
        let mut start = scene.motion();
        *start.position_mut() = ((), (0.0, (), 0.4, ()));
        let mut turned = 0.0_f64;
        let run = scene.simulate(start, Sdirk4::new().tolerance(1e-8), end, |now| {
            turned = turned.max(now.motion().position().1.2);
        })?;
        let ((), (first, (), second, ())) = *run.motion.position();
        println!("space, k = {stiffness:e}: {} steps, {} rejected, turns back at {turned}", run.steps, run.rejected);
        near(turned, highest, 1e-4);
        near(first, truth[0], 1e-3);
        near(first + second, truth[1], 1e-3);
    }
    Ok(())
}

/// A law of one's own that is linear is the spring that the library has, to rounding.
#[test]
fn a_linear_law_is_a_spring() -> Result<(), Error> {
    let own = Cubic { stiffness: 900.0, cube: 0.0, damping: 0.4, square: 0.0 };
    let (root, free) = (planar::Pinned::origin(), planar::Free);
    let scene = planar::System::new(root, (rod(), planar::ElasticHinge::with(own), rod()), free)?.with_gravity(GRAVITY);
    let spring = planar::ElasticHinge::rotary(900.0).damped(0.4);
    let same = planar::System::new(root, (rod(), spring, rod()), free)?.with_gravity(GRAVITY);
    for sdirk in [true, false] {
        macro_rules! end {
            ($scene:expr) => {{
                let start = $scene.at_rest(&[0.2, 0.5])?;
                if sdirk {
                    *$scene.simulate(start, Sdirk4::new().step(0.01), 1.0, |_| ())?.motion.position()
                } else {
                    *$scene.simulate(start, GeneralizedAlpha::new(0.8).step(0.01), 1.0, |_| ())?.motion.position()
                }
            }};
        }
        let ((a, ((), b, ())), (c, ((), d, ()))) = (end!(scene), end!(same));
        near(a, c, 1e-11);
        near(b, d, 1e-11);
    }
    Ok(())
}

/// A damper alone, the same in the plane and in space, lets a cart run out as x = v₀ m/c (1 − e^(−c t/m)).
#[test]
fn a_damper_alone_lets_a_cart_run_out() -> Result<(), Error> {
    let (damping, speed, end) = (0.8_f64, 1.5, 1.0);
    let decay = (-damping * end / MASS).exp();
    let truth = [speed * MASS / damping * (1.0 - decay), speed * decay];
    let error = |p: &[f64], r: &[f64]| (p[0] - truth[0]).abs().max((r[0] - truth[1]).abs());
    let damper = planar::Spring::damping(damping);

    let chain = (planar::Slider::along(0.0).with(damper), rod());
    let scene = planar::System::new(planar::Clamped::at(0.0, 0.0, 0.0), chain, planar::Free)?;
    let start = scene.with_rates(scene.motion(), &[speed])?;
    let found = errors(&scene, start, end, [200], "sdirk", error)?;
    near(found[0].1, 0.0, 1e-12);

    let chain = (spatial::Prismatic::along([1.0, 0.0, 0.0]).with(damper), rod_in_space());
    let scene = spatial::System::new(spatial::Clamped::origin(), chain, spatial::Free)?;
    let start = scene.with_rates(scene.motion(), &[speed])?;
    let found = errors(&scene, start, end, [200], "sdirk", error)?;
    near(found[0].1, 0.0, 1e-12);
    Ok(())
}
