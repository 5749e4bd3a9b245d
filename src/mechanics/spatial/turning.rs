//! Turns in space.

use super::{Frame, Rotation, Spatial, Turn};
use crate::relation::spatial::algebra::zero;
use crate::scalar::Scalar;
use crate::turning::Turning;
use nalgebra::Vector3;

impl<T: Scalar> Turning for Spatial<T> {
    type Orientation = Rotation<T>;
    type Spin = [T; 3];

    fn facing(turn: Turn<T>) -> Frame<T> {
        Frame { turn, ..Frame::resting(zero()) }
    }
    fn still(turn: Turn<T>) -> Turn<T> {
        Turn { spin: zero(), ..turn }
    }
    fn spin(turn: &Turn<T>) -> [T; 3] {
        turn.spin.into()
    }
    fn in_inertial_axes(spin: [T; 3]) -> [T; 3] {
        spin
    }
    fn in_axes_of(body: &Turn<T>, spin: [T; 3]) -> [T; 3] {
        body.attitude.apply(Vector3::from(spin)).into()
    }
    fn towards(here: &Turn<T>, there: &Rotation<T>) -> [T; 3] {
        there.after(&Rotation::from_matrix(&here.attitude).inverse()).shortest().log()
    }
    fn carrying(wanted: Rotation<T>, one: &Turn<T>, other: &Turn<T>) -> Rotation<T> {
        // Parts of derivatives are compared too.
        let same = |a: &Vector3<T>, b: &Vector3<T>| a.iter().zip(b).all(|(a, b)| a.is_identical(*b));
        let (a, b) = (&one.attitude, &other.attitude);
        if same(&a.x, &b.x) && same(&a.y, &b.y) && same(&a.z, &b.z) {
            return wanted;
        }
        let [one, other] = [one, other].map(|turn| Rotation::from_matrix(&turn.attitude));
        wanted.after(&one.relative_to(&other))
    }
    fn orientation_is_finite(orientation: &Rotation<T>) -> bool {
        orientation.quaternion().iter().all(|x| x.is_finite())
    }
}
