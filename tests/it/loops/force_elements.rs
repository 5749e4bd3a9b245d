//! Force elements: as struts between the same points, over time, beside other loads; what is refused.

use catena::scalar::{Jet, Scalar};
use catena::{Error, Fault, planar, robot, spatial};
use catena_oracle::{farthest, near};

/// A spring (N/m), a damper (N·s/m) and a length (m).
const STRUT: [f64; 3] = [80.0, 2.0, 0.6];

/// Places and velocities of two points, as a force on the first.
fn pull<T: Scalar, const D: usize>([stiffness, damping, length]: [T; 3], [a, b]: [[[T; D]; 2]; 2]) -> [T; D] {
    let between = |k: usize| -> [T; D] { core::array::from_fn(|i| b[k][i] - a[k][i]) };
    let dot = |a: [T; D], b: [T; D]| (0..D).fold(T::zero(), |sum, i| sum + a[i] * b[i]);
    let (apart, parting) = (between(0), between(1));
    let distance = dot(apart, apart).sqrt();
    let along = apart.map(|x| x / distance);
    let force = stiffness * (distance - length) + damping * dot(along, parting);
    along.map(|x| x * force)
}

/// Ends in body axes, of bodies 0 and 2.
const PLANE: [[f64; 2]; 2] = [[0.4, 0.1], [0.3, -0.1]];

/// The force element of a strut in the plane.
macro_rules! in_plane {
    ($T:ty, $strut:expr) => {{
        let (strut, [a, b]) = ($strut, PLANE.map(|end| end.map(<$T as Scalar>::literal)));
        planar::ForceElement::between([0, 2], move |_, [first, last]: &[planar::BodyMotion<$T>; 2]| {
            let ends = [first.point(a), last.point(b)].map(|point| [point.place.into(), point.velocity.into()]);
            let force = pull(strut, ends);
            [first.force_at(a, force), last.force_at(b, force.map(|x| -x))]
        })
    }};
}

#[test]
fn in_the_plane_they_are_as_struts() -> Result<(), Error> {
    use planar::*;
    let (rod, turn) = (Rod::uniform(1.0, 1.0), Revolute::smooth());
    let scene = System::new(Clamped::origin(), (turn, rod, turn, rod, turn, rod), Free)?.with_gravity(9.81);
    let start = scene.at_rest(&[0.4, -0.3, 0.8])?;
    let [stiffness, damping, length] = STRUT;
    let strut = Strut::between((0, PLANE[0]), (2, PLANE[1])).with_stiffness(stiffness).with_damping(damping);
    let (struts, element) = (Struts::of([strut.with_length(length)]), in_plane!(f64, STRUT));
    let drag = Loads::none().on_bodies(|_, _, body: &BodyMotion<f64>| body.force_at([0.5, 0.0], [-0.1, 0.2]));
    let gears = Couplings::of(&scene, [Coupling::new(2, 1).ratio(-0.7)])?;
    macro_rules! alike {
        ($start:expr, $one:expr, $other:expr) => {{
            let (one, other) = ($one, $other);
            let rule = || Dop853::tolerance(1e-10);
            let expected = scene.simulation(rule()).loads(&one).run($start, 1.0, |_| ())?.motion.coordinates();
            let found = scene.simulation(rule()).loads(&other).run($start, 1.0, |_| ())?.motion.coordinates();
            assert!(farthest(&found, &expected) < 1e-9, "{found:?} {expected:?}");
            let step = || GeneralizedAlpha::new(0.8).step(0.002);
            let expected = scene.simulation(step()).loads(&one).run($start, 1.0, |_| ())?.motion.coordinates();
            let found = scene.simulation(step()).loads(&other).run($start, 1.0, |_| ())?.motion.coordinates();
            assert!(farthest(&found, &expected) < 1e-9, "{found:?} {expected:?}");
        }};
    }
    alike!(start, struts, element);
    alike!(start, struts.and(drag), element.and(drag));
    alike!(start, Struts::of([strut; 2]), in_plane!(f64, [stiffness, damping, 0.0]).and(Struts::of([strut])));
    let joined = gears.joined(start);
    alike!(joined, gears.and(struts), gears.and(element));
    Ok(())
}

#[test]
fn derivatives_go_forward() -> Result<(), Error> {
    use planar::*;
    type T = Jet<f64, 3>;
    let seeded: [T; 3] = core::array::from_fn(|k| Jet::seed(STRUT[k], k));
    let of = <T as Scalar>::literal;
    let (rod, turn) = (Rod::uniform(of(1.0), of(1.0)), Revolute::smooth());
    let root = Clamped::at(of(0.0), of(0.0), of(0.0));
    let scene = System::new(root, (turn, rod, turn, rod, turn, rod), Free)?.with_gravity(of(9.81));
    let start = scene.at_rest(&[0.4, -0.3, 0.8].map(of))?;
    let [a, b] = PLANE.map(|end| end.map(of));
    let strut = Strut::between((0, a), (2, b)).with_stiffness(seeded[0]).with_damping(seeded[1]).with_length(seeded[2]);
    let (struts, element) = (Struts::of([strut]), in_plane!(T, seeded));
    let expected = scene.simulation(Rk4::step(0.01)).loads(&struts).run(start, 0.5, |_| ())?.motion.coordinates();
    let found = scene.simulation(Rk4::step(0.01)).loads(&element).run(start, 0.5, |_| ())?.motion.coordinates();
    for (found, expected) in found.iter().zip(&expected) {
        near(found.re, expected.re, 1e-12);
        assert!(farthest(&found.eps, &expected.eps) < 1e-12, "{found:?} {expected:?}");
    }
    Ok(())
}

/// In space, and on links, which take loads in axes of their own.
#[test]
fn in_space_they_are_as_struts() -> Result<(), Error> {
    const ENDS: [[f64; 3]; 2] = [[0.1, 0.05, 0.3], [-0.05, 0.02, 0.2]];
    let [stiffness, damping, length] = STRUT;
    let strut = spatial::Strut::between((0, ENDS[0]), (1, ENDS[1])).with_stiffness(stiffness).with_damping(damping);
    let struts = spatial::Struts::of([strut.with_length(0.2 * length)]);
    let element = spatial::ForceElement::between([0, 1], |_, [first, last]: &[spatial::BodyMotion<f64>; 2]| {
        let [a, b] = ENDS;
        let ends = [first.point(a), last.point(b)].map(|point| [point.place.into(), point.velocity.into()]);
        let force = pull([stiffness, damping, 0.2 * length], ends);
        [first.force_at(a, force), last.force_at(b, force.map(|x| -x))]
    });
    macro_rules! alike {
        ($scene:expr, $rates:expr) => {{
            let scene = $scene;
            let mut start = scene.motion();
            start.set_rates(&$rates)?;
            let run = || scene.simulation(spatial::Dop853::tolerance(1e-10));
            let expected = run().loads(&struts).run(start, 1.0, |_| ())?.motion.rates();
            let found = run().loads(&element).run(start, 1.0, |_| ())?.motion.rates();
            assert!(farthest(&found, &expected) < 1e-8, "{found:?} {expected:?}");
        }};
    }
    let rod = spatial::Rod::uniform(0.5, 0.05, 1.0);
    let chain = (rod, spatial::Ball, rod);
    let scene = spatial::System::new(spatial::Pinned::origin(), chain, spatial::Free)?;
    alike!(scene.with_gravity([0.3, -9.81, 0.1]), [0.3, 0.5, -0.2, 1.0, 0.4, 0.2]);
    let link = robot::Link::general(1.0, [0.02, 0.01, 0.2], [[0.06, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.02]]);
    let elbow = robot::Hinge::at::<0b111>([0.05, -0.02, 0.4]).turned(robot::Quarter::<30>);
    let chain = (robot::Hinge::level().grounded(), link, elbow, link);
    let scene = robot::System::new(robot::Base::origin(), chain, spatial::Free)?;
    alike!(scene.with_gravity([0.3, -9.81, 0.1]), [1.0, -0.5]);
    Ok(())
}

/// An excitation over time, of one turn of a wheel, whose end is a closed form; and what is refused.
#[test]
fn they_know_the_time() -> Result<(), Error> {
    use planar::*;
    let wheel = RigidBody::new(1.0, 0.5, [0.0; 2], [0.0; 2]);
    let scene = System::new(Clamped::origin(), (Branch((Revolute::smooth(), wheel)), Revolute::smooth(), wheel), Free)?;
    let twist = |time: f64, _: &[BodyMotion<f64>; 2]| {
        let torque = 3.0 * (2.0 * time).cos();
        [torque, -torque].map(Wrench::torque)
    };
    let element = ForceElement::between([0, 1], twist);
    let end = scene.simulation(Dop853::tolerance(1e-12)).loads(&element).run(scene.motion(), 1.3, |_| ())?.motion;
    // φ̈ = τ / J: φ = (3 / 0.5) (1 − cos 2t) / 4.
    let angle = 1.5 * (1.0 - 2.6_f64.cos());
    near(end.coordinates()[0], angle, 1e-11);
    near(end.coordinates()[1], -angle, 1e-11);
    let beyond = ForceElement::between([0, 2], twist);
    let error = scene.with_accelerations(scene.motion(), &beyond).expect_err("a body that is not there");
    assert!(matches!(error.fault, Fault::NoSuchBody { body: 2, bodies: 2 }), "{error}");
    let nothing = ForceElement::between([0], |_, _: &[BodyMotion<f64>; 1]| [Wrench::torque(f64::NAN)]);
    let run = scene.simulation(Rk4::step(0.1)).loads(&nothing).run(scene.motion(), 1.0, |_| ());
    let error = run.expect_err("no number").error;
    assert!(matches!(error.fault, Fault::NonFiniteLoad), "{error}");
    Ok(())
}
