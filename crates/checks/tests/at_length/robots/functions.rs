//! Functions of lists: dynamics, mass matrix, places, Jacobians, energy.

use super::kit::{agree, fixed, list, plain_fixed};
use catena::robot::*;
use catena::scalar::{Jet, Scalar};
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
    assert!(matches!(refused, Err(catena::Error { fault: catena::Fault::Count { expected: 6, given: 5, .. }, .. })));
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

/// A wrist of 4e-6 kg·m², its mass centre off its axis and far from the base, that a torque turns at 5e6 rad/s²: derivatives of inverse dynamics
/// about the base lose some digits to what cancels there, those of numbers through a sweep in axes of the bodies none. 1e-15 is five roundings
/// of the largest one; about the base 4e-14 is lost.
#[test]
fn derivatives_keep_their_digits_where_a_joint_has_next_to_no_inertia() -> Result<(), catena::Error> {
    const N: usize = 4;
    macro_rules! arm {
        ($T:ty) => {{
            let x = <$T as Scalar>::literal;
            let link = |mass: f64, [a, b, c]: [f64; 3]| {
                let o = x(0.0);
                Link::general(x(mass), [x(0.003), x(-0.002), x(0.1)], [[x(a), o, o], [o, x(b), o], [o, o, x(c)]])
            };
            let upper = link(3.0, [0.05, 0.05, 0.01]);
            let lift = Slide::at::<0b111>([x(0.2), x(0.1), x(0.9)]);
            let elbow = Hinge::at::<0b101>([x(0.4), x(0.0), x(0.3)]).turned(Quarter::<30>);
            let wrist = Hinge::at::<0b111>([x(0.5), x(0.1), x(0.2)]).turned(Quarter::<30>);
            let hand = Link::<_, 0b001, 0b111>::new(x(0.1), [x(0.002), x(0.0), x(0.0)], {
                [[x(1e-4), x(0.0), x(0.0)], [x(0.0), x(1e-4), x(0.0)], [x(0.0), x(0.0), x(4e-6)]]
            });
            let chain = (Hinge::level().grounded(), upper, lift, upper, elbow, upper, wrist, hand);
            System::new(Base::origin(), chain, Free)?.with_gravity([x(0.0), x(0.0), x(-9.81)])
        }};
    }
    let (q, v, torques) = ([0.4, 0.2, -0.7, 1.1], [0.5, -0.2, 0.9, 1.3], [5.0, 30.0, -8.0, 20.0]);
    let (state, by_torques) = arm!(f64).forward_dynamics_derivatives(&q, &v, &torques)?;
    let seeds =
        |list: &[f64; N], first: usize| core::array::from_fn::<_, N, _>(|k| Jet::<f64, 12>::seed(list[k], first + k));
    let expected = arm!(Jet<f64, 12>).forward_dynamics(&seeds(&q, 0), &seeds(&v, N), &seeds(&torques, 2 * N))?;
    let largest = expected.iter().flat_map(|x| x.eps).fold(0.0_f64, |most, x| most.max(x.abs()));
    for (i, expected) in expected.iter().enumerate() {
        for (k, found) in [state.positions[i], state.rates[i], by_torques[i]].as_flattened().iter().enumerate() {
            let off = (found - expected.eps[k]).abs() / largest;
            assert!(
                off < 1e-15,
                "of joint {i} by number {k}: {found} instead of {}, {off:.1e} of the largest",
                expected.eps[k]
            );
        }
    }
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
