//! Bodies whose moments of inertia no distribution of mass has, as robot description files do: taken, listed, and repaired on request.

use catena::internals::walks::check::check;
use catena::spatial::*;
use catena::{Error, Fault, Place};
use catena_oracle::{Noise, near};
use nalgebra::{Matrix3, Vector3};

/// Mass (kg), mass centre (m), and moments and products xx, xy, xz, yy, yz, zz about it (kg·m²) of links as an identification printed
/// them. Of the first two one moment exceeds the sum of the others, by far of the first and by little of the second.
const LINKS: [(f64, [f64; 3], [f64; 6]); 4] = [
    (2.6, [0.01, -0.04, 0.03], [0.0311, -0.0004, 0.0012, 0.0090, 0.0007, 0.0102]),
    (0.646926, [-0.003141, -0.02872, 0.003495], [0.007962, -0.003925, 0.010254, 0.028, 0.000704, 0.025895]),
    (3.228604, [0.027518, 0.039252, -0.066502], [0.037242, -0.004761, -0.011396, 0.036155, -0.012805, 0.01083]),
    (1.666555, [0.060149, -0.014117, -0.010517], [0.001964, 0.000109, -0.001158, 0.004354, 0.000341, 0.005433]),
];

fn link(k: usize) -> RigidBody<f64> {
    let (mass, centre, [xx, xy, xz, yy, yz, zz]) = LINKS[k];
    RigidBody::new(mass, [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], centre, [0.1, 0.0, 0.2])
}

fn matrix(inertia: &Inertia<f64>) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| inertia.about_centre[i][j])
}

/// Second moments ½ tr J 1 − J.
fn second(tensor: Matrix3<f64>) -> Matrix3<f64> {
    Matrix3::from_diagonal_element(0.5 * tensor.trace()) - tensor
}

#[test]
fn bodies_in_doubt_are_listed() -> Result<(), Error> {
    let hinge = Revolute::about([0.0, 0.0, 1.0]);
    let none = RigidBody::new(0.0, [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]], [0.0; 3], [0.1, 0.0, 0.0]);
    let arm =
        (hinge, link(0), Branch((Ball, link(1))), Ball, [(hinge, link(2)), (hinge, link(0))], (hinge, link(3), none));
    let scene = System::new(Clamped::origin(), arm, Free)?;
    let mut told = vec![];
    scene.doubts(|doubt| told.push(doubt));
    let excess = |k: usize| {
        let moments = matrix(&link(k).inertia()).symmetric_eigenvalues();
        2.0 * moments.max() - moments.sum()
    };
    println!("{:.2e} {:.2e}, {:.2e} {:.2e}", excess(0), excess(1), excess(2), excess(3));
    // The body after a joint stands one station further.
    let expected = [(1, 0), (3, 1), (8, 0)];
    assert_eq!(told.len(), 4);
    for (doubt, (station, k)) in told.iter().zip(expected) {
        println!("{doubt}");
        let Fault::ImpossibleInertia { excess: found } = doubt.fault else { panic!("{doubt}") };
        assert_eq!(doubt.place, Some(Place::Station(station)));
        near(found, excess(k), 1e-16);
    }
    let without_mass = Error::new(Fault::NotPositive { parameter: "mass", value: 0.0 }).at_station(11);
    assert_eq!(told.last(), Some(&without_mass));
    // Single precision rounds before it judges.
    let single = scene.lift(|x| x as f32);
    let mut count = 0;
    single.doubts(|_| count += 1);
    assert_eq!(count, 4);
    Ok(())
}

/// Torques that joints exert, from Newton's and Euler's equations of all bodies beyond them, vanish.
#[test]
fn arms_of_such_bodies_move_as_newton_and_euler_say() -> Result<(), Error> {
    let gravity = Vector3::new(0.3, -1.0, -9.81);
    let axes = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.3], [1.0, 0.0, 0.2], [0.0, 0.0, 1.0]];
    let [a, b, c, d] = [0, 1, 2, 3].map(|k| (Revolute::about(axes[k]), link(k)));
    let scene = System::new(Clamped::origin(), (a, b, c, d), Free)?.with_gravity_vector(gravity);
    let start = scene.at_rest(&[0.4, -0.8, 1.1, 0.3])?;
    let start = scene.with_rates(start, &[1.0, -2.0, 0.5, 3.0])?;
    let start = scene.with_accelerations(start, &Unloaded)?;
    let energy = scene.budget(&start)?.energy();
    let motion = scene.simulate(start, Dop853::tolerance(1e-12), 1.0, |_| ())?.motion;
    near(scene.budget(&motion)?.energy(), energy, 1e-9);
    let bodies: Vec<_> = scene.body_motions(&motion)?.iter().copied().collect();
    for (k, axis) in axes.into_iter().enumerate() {
        let (mut torque, mut size) = (0.0, 0.0_f64);
        let (about, place) = (Vector3::from(axis).normalize(), bodies[k].inboard.place);
        let about = bodies[k].turned(about.into());
        for body in &bodies[k..] {
            let turn =
                Matrix3::from_columns(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|e| body.turned(e)));
            let tensor = turn * matrix(&body.inertia) * turn.transpose();
            let centre = turn * Vector3::from(body.inertia.centre);
            let (spin, turning) = (body.inboard.turn.spin, body.inboard.acceleration.angular);
            let linear = body.inboard.acceleration.linear + turning.cross(&centre) + spin.cross(&spin.cross(&centre));
            let force = body.inertia.mass * (linear - gravity);
            let part =
                (body.inboard.place + centre - place).cross(&force) + tensor * turning + spin.cross(&(tensor * spin));
            torque += about.dot(&part);
            size = size.max(part.norm());
        }
        println!("joint {k}: {torque:.1e} of {size:.1e} N m");
        assert!(torque.abs() < 1e-12 * size.max(1.0), "{torque:.1e}");
    }
    Ok(())
}

/// The projection onto positive semidefinite matrices is the only one of them from which the difference is one, too, and orthogonal.
#[test]
fn repaired_bodies_are_the_nearest_there_are() {
    let mut noise = Noise::new(7);
    let mut repaired = 0;
    for _ in 0..200 {
        let root = Matrix3::from_fn(|_, _| noise.next());
        let shift = noise.between(0.0, 1.0);
        let moments = root * root.transpose() - Matrix3::from_diagonal_element(0.3 * shift);
        let tensor = Matrix3::from_diagonal_element(moments.trace()) - moments;
        let rows: [[f64; 3]; 3] = core::array::from_fn(|i| core::array::from_fn(|j| tensor[(i.min(j), i.max(j))]));
        let given = Inertia { mass: 1.0, centre: [0.1, 0.2, 0.3], about_centre: rows };
        let found = given.repaired();
        assert_eq!((found.mass, found.centre), (given.mass, given.centre));
        let (before, after) = (second(matrix(&given)), second(matrix(&found)));
        let size = before.norm();
        if before.symmetric_eigenvalues().min() >= 0.0 {
            assert_eq!(found, given);
            continue;
        }
        repaired += 1;
        let difference = after - before;
        assert!(after.symmetric_eigenvalues().min() > -1e-14 * size);
        assert!(difference.symmetric_eigenvalues().min() > -1e-14 * size);
        near((after.transpose() * difference).trace(), 0.0, 1e-14 * size * size);
        assert_eq!(found.doubt(), None);
        assert_eq!(found.check(), Ok(()));
    }
    println!("{repaired} of 200 repaired");
    assert!((50..200).contains(&repaired));
}

#[test]
fn what_is_repaired_can_be_built() -> Result<(), Error> {
    // A negative moment is refused, with its value, and taken when it is repaired.
    let tensor = [[-0.001, 0.0, 0.0], [0.0, 0.02, 0.0], [0.0, 0.0, 0.03]];
    let body = RigidBody::new(1.0, tensor, [0.1, 0.0, 0.0], [0.2, 0.0, 0.0]);
    let Err(refused) = System::new(Pinned::<[f64; 3]>::origin(), body, Free) else {
        panic!("a negative moment is taken")
    };
    assert_eq!(refused.place, Some(Place::Station(0)));
    let Fault::Negative { parameter: "principal moment of inertia", value } = refused.fault else {
        panic!("{refused}")
    };
    near(value, -0.001, 1e-17);
    let fixed = System::new(Pinned::<[f64; 3]>::origin(), body.repaired(), Free)?;
    fixed.doubts(|doubt| panic!("{doubt}"));
    // A body that is well is left alone, bit by bit.
    assert_eq!(link(2).repaired(), link(2));
    // What does not resist a rotation is found where it matters: on a ball, not on a hinge across.
    let thin = RigidBody::new(1.0, [[0.0; 3], [0.0, 0.02, 0.0], [0.0, 0.0, 0.03]], [0.1, 0.0, 0.0], [0.2, 0.0, 0.0]);
    let on_ball = System::new(Pinned::<[f64; 3]>::origin(), thin, Free)?;
    let error = on_ball.with_accelerations(on_ball.motion(), &Unloaded).expect_err("nothing resists the spin");
    assert_eq!((error.fault, error.place), (Fault::SingularJoint, Some(Place::Root)));
    let on_hinge = System::new(Clamped::origin(), (Revolute::about([0.0, 0.0, 1.0]), thin), Free)?;
    assert!(on_hinge.with_accelerations(on_hinge.motion(), &Unloaded).is_ok());
    assert_eq!(check::<Spatial<f64>, _>(&thin), Ok(()));
    Ok(())
}
