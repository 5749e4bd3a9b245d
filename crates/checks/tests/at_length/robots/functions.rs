//! Functions of lists: dynamics, mass matrix, places, Jacobians, energy.

use super::kit::{agree, fixed, list, plain_fixed};
use catena::robot::*;
use catena_oracle::Noise;
use catena_oracle::space::Vector;

/// Relative to the largest number of each list: some tens of roundings, times the condition of the mass matrix where it is inverted.
const DIRECT: f64 = 1e-13;
const INVERTED: f64 = 1e-12;

#[test]
fn dynamics_of_lists() -> Result<(), catena::Error> {
    let (scene, plain, mut noise) = (fixed()?, plain_fixed(), Noise::new(3));
    for _ in 0..100 {
        let [q, v, x]: [[f64; 6]; 3] = std::array::from_fn(|_| list(&mut noise, 2.0));
        let now = plain.at(&q, &v);
        agree(&scene.forward_dynamics(&q, &v, &x)?, plain.forward_dynamics(&q, &v, &x).as_slice(), INVERTED);
        let dampers: Vec<f64> = plain.parts.iter().zip(v).map(|(part, v)| part.damping * v).collect();
        let bias = &now.bias + nalgebra::DVector::from_vec(dampers);
        agree(&scene.bias(&q, &v)?, bias.as_slice(), DIRECT);
        let moved = &bias + &now.mass * nalgebra::DVector::from_column_slice(&x);
        agree(&scene.inverse_dynamics(&q, &v, &x)?, moved.as_slice(), DIRECT);
        agree(&scene.gravity_torques(&q)?, plain.at(&q, &[0.0; 6]).bias.as_slice(), DIRECT);
        agree(scene.mass_matrix(&q)?.as_flattened(), now.mass.as_slice(), DIRECT);
        let inverse = now.mass.clone().try_inverse().expect("masses are positive");
        agree(scene.mass_inverse(&q)?.as_flattened(), inverse.as_slice(), INVERTED);
        let solved = &inverse * nalgebra::DVector::from_column_slice(&x);
        agree(&scene.mass_solved(&q, &x)?, solved.as_slice(), INVERTED);
        agree(&scene.joint_energy(&q, &v)?, &[now.kinetic, now.potential], DIRECT);
        let (centre, mass) = scene.mass_centre(&q)?;
        agree(centre.as_slice(), now.centre.as_slice(), DIRECT);
        agree(&[mass], &[plain.parts.iter().map(|part| part.mass).sum()], DIRECT);
        for (joint, (place, body)) in scene.places(&q)?.iter().zip(&now.bodies).enumerate() {
            agree(place.place.as_slice(), body.place.as_slice(), DIRECT);
            let Columns { x, y, z } = place.attitude;
            let axes = nalgebra::Matrix3::from_columns(&[x, y, z]);
            agree(axes.as_slice(), body.attitude.as_slice(), DIRECT);
            let point = Vector::new(0.2, -0.3, 0.5);
            let arm = body.attitude * point;
            let mut columns = vec![];
            for k in 0..6 {
                let (of_place, of_turn) = (body.of_place.column(k), body.of_turn.column(k).into_owned());
                let velocity = of_place + Vector::from_column_slice(of_turn.as_slice()).cross(&arm);
                columns.extend(velocity.iter().chain(of_turn.iter()));
            }
            agree(scene.jacobian(&q, joint, point.into())?.as_flattened(), &columns, DIRECT);
        }
    }
    Ok(())
}

#[test]
fn lists_of_another_length_are_refused() -> Result<(), catena::Error> {
    let scene = fixed()?;
    let refused = scene.forward_dynamics(&[0.0; 5], &[0.0; 5], &[0.0; 5]);
    assert!(matches!(refused, Err(catena::Error { fault: catena::Fault::Count { expected: 6, given: 5 }, .. })));
    assert!(scene.jacobian(&[0.0; 6], 6, [0.0; 3]).is_err());
    assert!(scene.with_accelerations(scene.motion(), &Torques([0.0; 5])).is_err());
    Ok(())
}

/// A vector does not say how many joints it has, so that their sines are found one by one; an array of the same does.
#[test]
fn arms_in_vectors_are_those_in_arrays() -> Result<(), catena::Error> {
    let (mass, centre, tensor) = super::kit::body(1);
    let link = Link::general(mass, centre, tensor);
    let joint = Hinge::at::<0b100>([0.0, 0.0, 0.3]).turned(Quarter::<30>);
    let first = Hinge::level().grounded();
    let array = System::new(Base::origin(), (first, link, [(joint, link); 2]), Free)?;
    let vector = System::new(Base::origin(), (first, link, vec![(joint, link); 2]), Free)?;
    let (q, v, torques) = ([0.3, -0.4, 1.2], [0.5, -0.2, 0.3], [1.0, -2.0, 0.5]);
    agree(&vector.forward_dynamics(&q, &v, &torques)?, &array.forward_dynamics(&q, &v, &torques)?, DIRECT);
    Ok(())
}

#[test]
fn axes_that_are_no_turn_are_refused() {
    let (mass, centre, tensor) = super::kit::body(1);
    let link = Link::general(mass, centre, tensor);
    let with = |axes| {
        System::new(Base::origin(), (Hinge::level().turned(Turned::axes(axes)).grounded(), link), Free).map(|_| ())
    };
    let (s, c) = 0.4_f64.sin_cos();
    assert!(with([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]).is_ok());
    for [x, y, z] in [[c, 1.0, 1.0], [1.0, 1.01, 1.0], [1.0, 1.0, -1.0]] {
        let fault = with([[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]).unwrap_err().fault;
        assert!(matches!(fault, catena::Fault::NotZero { .. }), "{fault:?}");
    }
}

/// Of a turn about one axis five entries are known; a scene that says so moves alike, and one that says too much is refused.
#[test]
fn turns_may_say_which_entries_they_know() -> Result<(), catena::Error> {
    const ABOUT_Z: u32 = Turned::<f64>::code([[0, 0, 1], [0, 0, 1], [1, 1, 2]]);
    let (mass, centre, tensor) = super::kit::body(1);
    let link = Link::general(mass, centre, tensor);
    let (s, c) = 0.4_f64.sin_cos();
    let lean = Turned::axes([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]);
    let any = Turned::by(Rotation::from_angles([0.3, 0.0, 0.4]));
    let first = Hinge::level().turned(Quarter::<30>).grounded();
    let joint = Hinge::at::<0b101>([0.1, 0.0, 0.3]);
    let plain = System::new(Base::origin(), (first, link, joint.turned(lean), link), Free)?;
    let known = System::new(Base::origin(), (first, link, joint.turned(lean.known::<ABOUT_Z>()), link), Free)?;
    let (q, v, torques) = ([0.3, -0.4], [0.5, -0.2], [1.0, -2.0]);
    agree(&known.forward_dynamics(&q, &v, &torques)?, &plain.forward_dynamics(&q, &v, &torques)?, DIRECT);
    let wrong = System::new(Base::origin(), (first, link, joint.turned(any.known::<ABOUT_Z>()), link), Free);
    assert!(matches!(wrong.map(|_| ()).unwrap_err().fault, catena::Fault::NotZero { .. }));
    Ok(())
}

/// A torque that is not finite is found in its joint: the second, two stations out; not at the root, which takes none.
#[test]
fn torques_that_are_not_finite_name_their_joint() -> Result<(), catena::Error> {
    let scene = fixed()?;
    let mut torques = [0.0; 6];
    torques[1] = f64::NAN;
    let found = scene.with_accelerations(scene.motion(), &Torques(torques)).unwrap_err();
    assert_eq!((found.fault, found.place), (catena::Fault::NonFiniteLoad, Some(catena::Place::Station(2))));
    Ok(())
}
