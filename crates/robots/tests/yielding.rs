//! Loads that yield, by a law of the user's own; contacts that are no mechanics; impacts and lists of numbers that are none.

use catena::robot::*;
use catena::{Error, Fault};

type Hopper = System<f64, Base<f64>, (Slide<f64>, Link<f64>), Free>;

/// A body of 1 kg on a vertical slide.
fn hopper() -> Result<Hopper, Error> {
    let link = Link::general(1.0, [0.0; 3], [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]);
    Ok(System::new(Base::origin(), (Slide::level(), link), Free)?.with_gravity([0.0, 0.0, -9.81]))
}

/// Bears the weight, and damps.
#[derive(Clone, Copy)]
struct Held;

impl LoadLaw<BodyMotion<f64>> for Held {
    type Value = Yielding<f64>;
    fn at(&self, _: f64, _: usize, body: &BodyMotion<f64>) -> Yielding<f64> {
        let force = [0.0, 0.0, 9.81 - 100.0 * body.inboard.velocity.z];
        let damping = Block::at([0.0; 3].into(), [0.0, 0.0, 1.0].into(), 100.0, 100.0);
        Yielding::new(body.force_at([0.0; 3], force), Block::zero(), damping)
    }
}

#[test]
fn a_law_that_yields_adds_no_weight() -> Result<(), Error> {
    let (scene, loads) = (hopper()?, Loads::none().on_bodies_by(Held));
    let start = scene.at_joints(&[0.0], &[0.3])?;
    let end = scene.simulation(Sdirk4::new().step(0.01)).loads(&loads).run(start, 1.0, |_| ())?.motion;
    let (mut rates, position) = ([0.0; 1], end.coordinates()[0]);
    end.rates_into(&mut rates)?;
    let mut accelerations = vec![];
    catena::system::Rate::visit(end.acceleration(), &mut |x: f64| accelerations.push(x));
    println!("at {position}, {rates:?}, {accelerations:?}");
    assert!(rates[0].abs() < 1e-10 && accelerations[0].abs() < 1e-8);
    assert!((position - 0.003).abs() < 1e-6); // v₀ m/c
    Ok(())
}

/// Yields by what is no number.
#[derive(Clone, Copy)]
struct Broken(usize);

impl LoadLaw<BodyMotion<f64>> for Broken {
    type Value = Yielding<f64>;
    fn at(&self, _: f64, _: usize, _: &BodyMotion<f64>) -> Yielding<f64> {
        let mut block = Block::zero();
        match self.0 % 3 {
            0 => block.linear[2] = f64::NAN,
            1 => block.coupling[2][1] = f64::INFINITY,
            _ => block.angular[5] = f64::NAN,
        }
        let [stiffness, damping] = if self.0 < 3 { [block, Block::zero()] } else { [Block::zero(), block] };
        Yielding::new(Wrench::default(), stiffness, damping)
    }
}

#[test]
fn slopes_that_are_not_finite_are_named() -> Result<(), Error> {
    let scene = hopper()?;
    for k in 0..6 {
        let loads = Loads::none().on_bodies_by(Broken(k));
        let run =
            scene.simulation(GeneralizedAlpha::new(0.8).step(0.01)).loads(&loads).run(scene.motion(), 1.0, |_| ());
        let fault = run.map(|_| ()).map_err(|stopped| Error::from(stopped).fault);
        println!("{k}: {fault:?}");
        // Those that the slide does not feel do no harm.
        assert!(matches!(fault, Err(Fault::NonFiniteLoad)) || fault.is_ok() && k % 3 != 0, "{k}: {fault:?}");
    }
    Ok(())
}

#[test]
fn surfaces_and_points_that_are_none_are_refused() -> Result<(), Error> {
    let (scene, law) = (hopper()?, Contact::new(1e4, 1e-3).rubbing(0.5, 0.01));
    let fault = |point: [f64; 3], normal: [f64; 3]| {
        let contacts = Contacts::of([(0, point)], Plane::through([0.0; 3], normal), law);
        let refused = scene.with_accelerations(scene.motion(), &Loads::none().on_bodies_by(contacts));
        let plain = scene.with_accelerations(scene.motion(), &Loads::none().on_bodies_by(contacts.plain()));
        let (refused, plain) = (refused.map_err(|error| error.fault).err(), plain.map_err(|error| error.fault).err());
        assert_eq!(refused.is_some(), plain.is_some());
        refused
    };
    assert_eq!(fault([0.0; 3], [-0.6, 0.0, 0.8]), None);
    assert!(matches!(fault([0.0; 3], [0.0, 0.0, 2.0]), Some(Fault::OutOfRange { value: 2.0, .. })));
    assert!(matches!(fault([0.0; 3], [0.0; 3]), Some(Fault::OutOfRange { value: 0.0, .. })));
    assert!(matches!(fault([0.0; 3], [0.0, f64::NAN, 1.0]), Some(Fault::NotFinite { .. })));
    assert!(matches!(fault([0.0, f64::INFINITY, 0.0], [0.0, 0.0, 1.0]), Some(Fault::NotFinite { .. })));
    Ok(())
}

#[test]
fn impacts_that_are_none_are_refused() -> Result<(), Error> {
    let scene = hopper()?;
    let fault = |joint, restitution| {
        scene.impact(&[0.0], &[1.0], joint, restitution).map(|(rates, _)| rates).map_err(|error| error.fault)
    };
    assert_eq!(fault(0, 0.5), Ok([-0.5]));
    assert_eq!(fault(1, 0.5), Err(Fault::NoSuchJoint { joint: 1, joints: 1 }));
    for restitution in [-0.1, 1.1] {
        assert!(matches!(fault(0, restitution), Err(Fault::OutOfRange { value, .. }) if value == restitution));
    }
    assert!(matches!(fault(0, f64::NAN), Err(Fault::OutOfRange { .. })));
    let missing = Some(Fault::NoSuchJoint { joint: 1, joints: 1 });
    assert_eq!(scene.jacobian(&[0.0], 1, [0.0; 3]).map_err(|error| error.fault).err(), missing);
    assert_eq!(scene.snapshot(&[0.0], &[0.0])?.point(Some(1), [0.0; 3]).map_err(|error| error.fault).err(), missing);
    Ok(())
}

type Arm = (Hinge<f64>, Link<f64>, Hinge<f64, Level, 1>, Link<f64>);

/// An arm whose last joint is resisted by `last` (kg) alone.
fn arm(last: f64) -> Result<System<f64, Base<f64>, Arm, Free>, Error> {
    let link = |mass: f64| {
        let inertia = [[0.1 * mass, 0.0, 0.0], [0.0, 0.1 * mass, 0.0], [0.0, 0.0, 0.1 * mass]];
        Link::general(mass, [0.2, 0.0, 0.0], inertia)
    };
    let chain = (Hinge::level(), link(3.0), Hinge::at::<1>([0.4, 0.0, 0.0]), link(last));
    Ok(System::new(Base::origin(), chain, Free)?.with_gravity([0.0, -9.81, 0.0]))
}

#[test]
fn functions_of_lists_refuse_what_comes_out_not_finite() -> Result<(), Error> {
    let (light, arm, nan) = (arm(0.0)?, arm(1.0)?, f64::NAN);
    let (q, v) = ([0.3, -0.4], [1.0, 0.5]);
    let refused = Err(Fault::NonFiniteMotion);
    // Nothing resists the last joint.
    assert_eq!(light.forward_dynamics(&q, &v, &v).map(|_| ()).map_err(|error| error.fault), refused);
    assert_eq!(light.mass_solved(&q, &v).map(|_| ()).map_err(|error| error.fault), refused);
    assert_eq!(light.mass_inverse(&q).map(|_| ()).map_err(|error| error.fault), refused);
    assert_eq!(light.impact(&q, &v, 1, 0.5).map(|_| ()).map_err(|error| error.fault), refused);
    assert_eq!(light.forward_dynamics_derivatives(&q, &v, &v).map(|_| ()).map_err(|error| error.fault), refused);
    assert!(light.mass_matrix(&q).is_ok() && light.inverse_dynamics(&q, &v, &v).is_ok());
    // Positions and rates that are none.
    for list in [[0.3, nan], [0.3, f64::INFINITY]] {
        let faults = [
            arm.mass_solved(&list, &v).map(|_| ()),
            arm.mass_solved(&q, &list).map(|_| ()),
            arm.mass_inverse(&list).map(|_| ()),
            arm.mass_matrix(&list).map(|_| ()),
            arm.impact(&list, &v, 1, 0.5).map(|_| ()),
            arm.impact(&q, &list, 1, 0.5).map(|_| ()),
            arm.inverse_dynamics(&list, &v, &v).map(|_| ()),
            arm.inverse_dynamics(&q, &list, &v).map(|_| ()),
            arm.inverse_dynamics(&q, &v, &list).map(|_| ()),
            arm.inverse_dynamics_derivatives(&q, &list, &v).map(|_| ()),
            arm.bias(&q, &list).map(|_| ()),
            arm.gravity_torques(&list).map(|_| ()),
            arm.places(&list).map(|_| ()),
            arm.jacobian(&list, 0, [0.0; 3]).map(|_| ()),
            arm.mass_centre(&list).map(|_| ()),
            arm.joint_energy(&list, &v).map(|_| ()),
            arm.joint_energy(&q, &list).map(|_| ()),
            arm.snapshot(&list, &v).map(|_| ()),
            arm.snapshot(&q, &list).map(|_| ()),
        ];
        for (k, fault) in faults.into_iter().enumerate() {
            assert_eq!(fault.map_err(|error| error.fault), refused, "{k}");
        }
    }
    Ok(())
}

#[test]
fn gravity_torques_know_gravity_alone() -> Result<(), Error> {
    let link = Link::general(2.0, [0.2, 0.1, 0.3], [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]);
    let chain = (BodyAxes, Hinge::level(), link);
    let shaken = Moving(|_: f64| GroundMotion { place: [0.0; 3], velocity: [1.0; 3], acceleration: [3.0, -2.0, 1.0] });
    let gravity = [0.0, -9.81, 0.0];
    let shaken = System::new(Clamped::on(shaken, Rotation::identity()), chain, Free)?.with_gravity(gravity);
    let resting = System::new(Clamped::origin(), chain, Free)?.with_gravity(gravity);
    assert_eq!(shaken.gravity_torques(&[0.4])?, resting.gravity_torques(&[0.4])?);
    let bias: [f64; 2] = [shaken.bias(&[0.4], &[0.0])?[0], resting.bias(&[0.4], &[0.0])?[0]];
    assert!((bias[0] - bias[1]).abs() > 0.1, "{bias:?}");
    Ok(())
}
