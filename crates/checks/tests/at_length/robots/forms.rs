//! Robots as tuples and arrays, over dual numbers, and with masks that do not fit.

use super::kit::{agree, body};
use catena::robot::*;
use catena::{Fault, Scalar};
use num_dual::Dual64;

type Pair<T> = (Hinge<T, Quarter<30>, 0b101>, Link<T>);

fn pair<T: Scalar>(k: usize) -> Pair<T> {
    let (mass, centre, tensor) = body(k);
    let (of, rows) = (T::literal, tensor.map(|row| row.map(T::literal)));
    let hinge = Hinge::at::<0b101>([0.3, 0.0, -0.1].map(of)).turned(Quarter::<30>);
    (hinge, Link::general(of(mass), centre.map(of), rows))
}

type Arm<T> = System<T, Base<T>, (Pair<T>, Pair<T>, Pair<T>), Free>;

fn tuple<T: Scalar>() -> Result<Arm<T>, catena::Error> {
    Ok(System::new(Base::origin(), (pair(0), pair(1), pair(2)), Free)?.with_gravity([0.0, 0.0, -9.81].map(T::literal)))
}

const STATE: [[f64; 3]; 3] = [[0.3, -0.7, 1.1], [0.5, 0.2, -0.4], [1.0, -2.0, 0.5]];

#[test]
fn an_array_of_pairs_moves_as_their_tuple() -> Result<(), catena::Error> {
    let array = System::new(Base::origin(), [pair(0), pair(1), pair(2)], Free)?.with_gravity([0.0, 0.0, -9.81]);
    let ([q, v, x], tuple) = (STATE, tuple::<f64>()?);
    // Another order of sums at the tip, which an array carries as a full relation.
    agree(&array.forward_dynamics(&q, &v, &x)?, &tuple.forward_dynamics(&q, &v, &x)?, 1e-14);
    agree(array.mass_matrix(&q)?.as_flattened(), tuple.mass_matrix(&q)?.as_flattened(), 1e-14);
    Ok(())
}

#[test]
fn accelerations_by_torques_are_the_inverse_mass_matrix() -> Result<(), catena::Error> {
    let ([q, v, x], scene) = (STATE, tuple::<f64>()?);
    let inverse = scene.mass_inverse(&q)?;
    let dual = tuple::<Dual64>()?;
    for k in 0..3 {
        let mut torques = x.map(Dual64::from);
        torques[k].eps = 1.0;
        let found = dual.forward_dynamics(&q.map(Dual64::from), &v.map(Dual64::from), &torques)?;
        agree(&found.map(|second| second.eps), &inverse[k], 1e-13);
        agree(&found.map(|second| second.re), &scene.forward_dynamics(&q, &v, &x)?, 1e-13);
    }
    Ok(())
}

#[test]
fn masks_that_leave_out_what_is_there_are_refused() {
    let (mass, centre, tensor) = body(1);
    let refused = System::new(Base::origin(), (Hinge::level(), Link::<_, 0b011, 63>::new(mass, centre, tensor)), Free);
    assert!(matches!(refused.err().map(|error| error.fault), Some(Fault::NotZero { .. })));
    let link = Link::general(mass, centre, tensor);
    let refused = System::new(Base::origin(), (Hinge::at::<0b100>([0.1, 0.0, 0.2]), link), Free);
    assert!(matches!(refused.err().map(|error| error.fault), Some(Fault::NotZero { .. })));
    // Zeros with derivatives are there too.
    let [seeded, zero, height] = [Dual64::new(0.0, 1.0), Dual64::from(0.0), Dual64::from(0.2)];
    let (mass, tensor) = (Dual64::from(mass), tensor.map(|row| row.map(Dual64::from)));
    let link = Link::<_, 0b100, 63>::new(mass, [seeded, zero, height], tensor);
    let refused = System::new(Base::origin(), (Hinge::level(), link), Free);
    assert!(matches!(refused.err().map(|error| error.fault), Some(Fault::NotZero { .. })));
    let link = Link::general(mass, [zero, zero, height], tensor);
    let refused = System::new(Base::origin(), (Hinge::at::<0b100>([seeded, zero, height]), link), Free);
    assert!(matches!(refused.err().map(|error| error.fault), Some(Fault::NotZero { .. })));
    let link = Link::<_, 0b100, 63>::new(mass, [zero, zero, height], tensor);
    assert!(System::new(Base::origin(), (Hinge::at::<0b100>([zero, zero, height]), link), Free).is_ok());
}
