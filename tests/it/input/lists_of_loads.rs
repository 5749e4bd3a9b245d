//! Loads handed in as lists: refused where a list has not one value for each body or joint, and spread over the scene without a walk,
//! whatever its form.

use catena::loading::{Loading, Unloaded};
use catena::planar::{Pin, Planar, Rod};
use catena::simulate::Stepper;
use catena::spatial::{Effort, Revolute};
use catena::system::Element;
use catena::system::Rate;
use catena::system::{Dynamics, MotionOf, Runs};
use catena::{Error, Fault, planar, spatial};
use core::cell::Cell;

fn refused<X: core::fmt::Debug>(outcome: Result<X, Error>, expected: usize, given: usize) {
    match outcome {
        Err(Error { fault: Fault::Count { expected: all, given: some, .. }, .. }) => {
            assert_eq!([all, some], [expected, given]);
        }
        Err(error) => panic!("{error}"),
        Ok(found) => panic!("accepted: {found:?}"),
    }
}

fn rod() -> Rod<f64> {
    Rod::uniform(0.5, 1.0)
}

type Arm = planar::System<f64, planar::Pinned<[f64; 2]>, (Rod<f64>, [(Pin, Rod<f64>); 2]), planar::Free>;
type ArmMotion = MotionOf<Planar<f64>, planar::Pinned<[f64; 2]>, (Rod<f64>, [(Pin, Rod<f64>); 2]), planar::Free>;

fn arm() -> Result<(Arm, ArmMotion), Error> {
    let chain = (rod(), [(Pin, rod()); 2]);
    let arm = planar::System::new(planar::Pinned::origin(), chain, planar::Free)?.with_gravity(9.81);
    let start = arm.at_rest(&[0.1, 0.4, -0.3])?;
    Ok((arm, start))
}

/// Whatever takes loads refuses these, for their `given` values where three are needed, and writes no motion.
fn refused_everywhere<L: Loading<Planar<f64>>>(loads: &L, given: usize) -> Result<(), Error>
where
    Arm: Runs<L, Planar<f64>, planar::Pinned<[f64; 2]>, (Rod<f64>, [(Pin, Rod<f64>); 2]), planar::Free>
        + catena::system::StiffDynamics<L>,
{
    use catena::planar::{Adams, Dop853, Dopri5, GeneralizedAlpha, Rk4, Sdirk4};
    let (arm, start) = arm()?;
    refused(arm.with_accelerations(start, loads), 3, given);
    refused(arm.assembled(start, loads), 3, given);
    refused(arm.stations(&start, loads).map(|_| ()), 3, given);
    macro_rules! steps {
        ($($method:expr),*) => {$(
            let (mut stepper, mut next) = (arm.stepper($method), start);
            refused(stepper.step(&start, loads, 1e-3, &mut next), 3, given);
            refused(stepper.advance(&start, loads, 1e-3, &mut next), 3, given);
        )*};
    }
    steps!(Rk4, Dopri5, Dop853, Adams, GeneralizedAlpha::new(0.8), Sdirk4::new());
    let run = arm.simulation(Rk4::step(0.01)).loads(loads).run(start, 0.1, |_| ());
    refused(run.map_err(Error::from).map(|run| run.motion), 3, given);
    let run = arm.simulation(Sdirk4::new().tolerance(1e-6)).loads(loads).run(start, 0.1, |_| ());
    refused(run.map_err(Error::from).map(|run| run.motion), 3, given);
    Ok(())
}

#[test]
fn lists_of_another_length_are_refused() -> Result<(), Error> {
    use catena::planar::{Loads, Strut, Struts, Wrench};
    let strut = Strut::to_ground((0, [0.5, 0.0]), [1.0, 1.0]).with_stiffness(3.0);
    for given in [0, 1, 2, 4, 7] {
        let (torques, wrenches) = (vec![0.5; given], vec![Wrench::torque(0.5); given]);
        refused_everywhere(&Loads::none().torques(&torques), given)?;
        refused_everywhere(&Loads::none().wrenches(&wrenches), given)?;
        refused_everywhere(&Loads::none().wrenches(vec![Wrench::torque(0.5); 3]).torques(&torques), given)?;
        refused_everywhere(&Loads::none().wrenches(&wrenches).torques([0.5; 3]), given)?;
        refused_everywhere(&Struts::of([strut]).and(Loads::none().torques(&torques)), given)?;
        let damped = Loads::none().in_joints(|_: f64, _, motion: &planar::JointMotion<f64>| -motion.rate());
        refused_everywhere(&damped.wrenches(&wrenches), given)?;
    }
    let (arm, start) = arm()?;
    refused(arm.root_state(&start, &Loads::none().torques([0.5; 2])), 3, 2);
    refused(arm.transfer_matrix(&start, &Loads::none().wrenches([Wrench::torque(0.5); 4]), |_, _| ()), 3, 4);
    assert!(arm.with_accelerations(start, &Loads::none().torques([0.5; 3])).is_ok());
    assert!(arm.with_accelerations(start, &Loads::none().wrenches([Wrench::torque(0.5); 3])).is_ok());
    Ok(())
}

#[test]
fn lists_of_another_length_are_refused_in_space() -> Result<(), Error> {
    use catena::spatial::{Clamped, Free, Loads, RigidBody, System, Wrench};
    let link = (
        Revolute::about([0.0, 1.0, 0.0]),
        RigidBody::new(1.0, [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]], [0.1, 0.0, 0.0], [0.2, 0.0, 0.0]),
    );
    let scene = System::new(Clamped::origin(), [link; 2], Free)?;
    let start = scene.motion();
    for given in [0, 1, 2, 4] {
        // The joint of the root is a weld, and one of three.
        refused(
            scene.with_accelerations(start, &Loads::none().efforts(vec![Effort([1.0, 0.0, 0.0]); given])),
            3,
            given,
        );
        if given != 2 {
            let wrenches = vec![Wrench::torque([1.0, 0.0, 0.0]); given];
            refused(scene.with_accelerations(start, &Loads::none().wrenches(wrenches)), 2, given);
        }
    }
    Ok(())
}

#[test]
fn positions_and_rates_of_another_length_are_refused() -> Result<(), Error> {
    let (arm, start) = arm()?;
    for given in [0, 1, 2, 4] {
        let list = vec![0.1; given];
        refused(arm.at_rest(&list), 3, given);
        refused(arm.at_joint_angles(&list), 3, given);
        refused(arm.with_rates(start, &list), 3, given);
        refused(arm.with_body_rates(start, &list), 3, given);
    }
    Ok(())
}

/// A list that counts how often it is asked for.
struct Asked<X, const N: usize>([X; N], Cell<usize>);

impl<X, const N: usize> AsRef<[X]> for Asked<X, N> {
    fn as_ref(&self) -> &[X] {
        self.1.set(self.1.get() + 1);
        &self.0
    }
}

fn asked<X, const N: usize>(values: [X; N]) -> Asked<X, N> {
    Asked(values, Cell::new(0))
}

/// Accelerations under torques in all joints, which a sweep asks for at once: neither joint by joint nor on a walk.
fn in_the_plane<C>(chain: C) -> Result<Vec<f64>, Error>
where
    C: Element<Planar<f64>>,
    planar::System<f64, planar::Pinned<[f64; 2]>, C, planar::Free>: Runs<
            planar::Loads<catena::planar::Absent, planar::Values<Asked<f64, 5>>>,
            Planar<f64>,
            planar::Pinned<[f64; 2]>,
            C,
            planar::Free,
        > + Runs<Unloaded, Planar<f64>, planar::Pinned<[f64; 2]>, C, planar::Free>,
{
    let scene = planar::System::new(planar::Pinned::origin(), chain, planar::Free)?;
    let values = [0.3, -0.2, 0.5, 0.7, -0.4];
    let list = asked(values);
    let start = scene.with_rates(scene.at_rest(&[0.1, 0.5, -0.3, 1.1, 0.8])?, &[1.0, -1.0, 2.0, 0.5, -3.0])?;
    let loads = planar::Loads::none().torques(list);
    let mut workspace = Dynamics::<planar::Loads<_, planar::Values<Asked<f64, 5>>>>::workspace(&scene);
    let mut found = start.clone();
    scene.accelerate(&mut found, &loads, &mut workspace)?;
    let before = calls(&loads);
    scene.accelerations(0.0, start.position(), start.rate(), &loads, &mut workspace, found.acceleration_mut());
    assert_eq!(calls(&loads) - before, 1);
    let mut list = vec![];
    found.acceleration().visit(&mut |x| list.push(x));
    Ok(list)
}

/// How often a list of torques has been asked for.
fn calls(loads: &planar::Loads<catena::planar::Absent, planar::Values<Asked<f64, 5>>>) -> usize {
    loads.joints().0.1.get()
}

#[test]
fn a_list_is_spread_without_a_walk_in_every_form() -> Result<(), Error> {
    let link = (Pin, rod());
    let forms = [
        in_the_plane((rod(), Pin, rod(), Pin, rod(), Pin, rod(), Pin, rod()))?,
        in_the_plane((rod(), link, link, link, link))?,
        in_the_plane((rod(), [link; 4]))?,
        in_the_plane((rod(), vec![link; 4]))?,
        in_the_plane((rod(), [[link; 2]; 2]))?,
        in_the_plane((rod(), (link, [link]), vec![(link, link)]))?,
    ];
    // By a law, joint by joint on the walk.
    let scene = planar::System::new(planar::Pinned::origin(), (rod(), [link; 4]), planar::Free)?;
    let start = scene.with_rates(scene.at_rest(&[0.1, 0.5, -0.3, 1.1, 0.8])?, &[1.0, -1.0, 2.0, 0.5, -3.0])?;
    let law = |_: f64, joint: usize, _: &planar::JointMotion<f64>| [0.3, -0.2, 0.5, 0.7, -0.4][joint];
    let mut want = vec![];
    let moving = scene.with_accelerations(start, &planar::Loads::none().in_joints(law))?;
    moving.acceleration().visit(&mut |x| want.push(x));
    let size = want.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    for found in forms {
        assert_eq!(found.len(), want.len());
        found.iter().zip(&want).for_each(|(found, want)| catena_oracle::near(*found, *want, 1e-12 * size));
    }
    Ok(())
}

/// Arms, networks and beams take their shares of a list in the order in which bodies and joints are numbered.
#[test]
fn arms_and_loops_take_their_shares() -> Result<(), Error> {
    use catena::planar::{Branch, Clamped, Free, JointMotion, Loads, Network, RigidBody, Slider, System, Weld, Wrench};
    let plate = RigidBody::new(1.0, 0.1, [0.2, 0.1], [0.3, 0.0]);
    let loop_ = Network::new((Pin, rod()), (Pin, rod(), Pin, rod()), Pin);
    let chain = (Slider::along(0.3), plate, Branch(([(Pin, rod()); 2], Weld::at(0.2), rod())), Pin, plate, loop_);
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Free)?.with_gravity(9.81);
    let start = scene.assembled(scene.at_rest(&[0.3, -0.2, 0.4, 0.8, 0.2, 1.0])?, &Unloaded)?;
    let torques: Vec<f64> = (0..scene.joints()).map(|k| (0.7 * k as f64 + 0.2).sin()).collect();
    let wrenches: Vec<_> = (0..scene.bodies())
        .map(|k| Wrench { force: nalgebra::Vector2::new((k as f64).cos(), 0.5), torque: 0.1 * k as f64 })
        .collect();
    let listed = scene.with_accelerations(start, &Loads::none().torques(&torques).wrenches(&wrenches))?;
    let laws = Loads::none()
        .in_joints(|_: f64, joint, _: &JointMotion<f64>| torques[joint])
        .on_bodies(|_: f64, body, _: &planar::BodyMotion<f64>| wrenches[body]);
    assert_eq!(listed, scene.with_accelerations(start, &laws)?);
    let _ = spatial::Loads::none();
    Ok(())
}

/// The joint of a root that is free: in the plane a torque on the first body from outside, in space nothing.
#[test]
fn efforts_in_the_joint_of_a_free_root_do_what_its_page_says() -> Result<(), Error> {
    let plane = {
        use catena::planar::*;
        let scene = System::new(Free, RigidBody::new(2.0, 0.5, [0.0; 2], [1.0, 0.0]), Free)?;
        scene.with_accelerations(scene.motion(), &Loads::none().torques([3.0]))?.accelerations()
    };
    assert_eq!(plane, [0.0, 0.0, 6.0]);
    use catena::spatial::*;
    let scene = System::new(Free, Rod::uniform(1.0, 0.1, 1.0), Free)?;
    let loads = Loads::none().in_joints(|_, _, _: &JointMotion<f64>| Effort([0.0, 0.0, 2.0]));
    assert_eq!(scene.with_accelerations(scene.motion(), &loads)?.accelerations(), [0.0; 6]);
    Ok(())
}
