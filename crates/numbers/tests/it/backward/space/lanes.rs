//! Axes that lie otherwise in each lane: gradients by them are those of each lane by itself.

use super::*;
use catena::scalar::WideF64x4;
use catena::sensitivity::Costate;

/// A joint about or along an axis between two bodies.
macro_rules! scene {
    ($of:expr, $joint:expr) => {{
        let of = $of;
        let tensor = [[0.2, 0.02, 0.0], [0.02, 0.3, 0.01], [0.0, 0.01, 0.25]].map(|row| row.map(of));
        let body = RigidBody::new(of(1.2), tensor, [0.3, 0.1, -0.1].map(of), [0.7, -0.2, 0.1].map(of));
        let ground = Clamped::at([0.0; 3].map(of), Rotation::from_angles([0.1, 0.2, 0.3].map(of)));
        System::new(ground, (body, $joint, body), Free).unwrap().with_gravity([0.5, -9.0, 1.0].map(of))
    }};
}

/// The gradient of its coordinate and rate by the axis.
macro_rules! by_axis {
    ($N:ty, $axis:expr, $joint:expr) => {{
        let axis: [$N; 3] = $axis;
        let of = <$N>::literal;
        let scene = scene!(of, $joint(axis));
        let mut start = scene.motion();
        start.set_coordinates(&[of(0.3)]).unwrap();
        start.set_rates(&[of(0.7)]).unwrap();
        let mut states = [start; 11];
        let mut backward = scene.backward(Rk4);
        backward.run(&start, 0.02, 10, &[], &mut states).unwrap();
        let cost = |step: usize, _: &_, by: &mut Costate<_, _>| match step {
            10 => by.add(&[of(1.0)], &[of(0.5)]),
            _ => Ok(()),
        };
        let gradient = backward.gradient(&[], &states, &mut [], cost).unwrap();
        let seeded = core::array::from_fn(|k| Jet::<$N, 3>::seed(axis[k], k));
        gradient.along(&scene!(Jet::<$N, 3>::literal, $joint(seeded))).unwrap()
    }};
}

#[test]
fn axes_of_each_lane_have_their_own_gradients() {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.5, 0.7, 0.2]];
    let lanes: [WideF64x4; 3] = core::array::from_fn(|k| WideF64x4::from(axes.map(|axis| axis[k])));
    macro_rules! alone {
        ($joint:expr) => {
            let found = by_axis!(WideF64x4, lanes, $joint).map(|x| x.into_arr());
            for (lane, axis) in axes.into_iter().enumerate() {
                let expected: [f64; 3] = by_axis!(f64, axis, $joint);
                (0..3).for_each(|k| near(found[k][lane], expected[k], 1e-14));
            }
        };
    }
    alone!(Revolute::about);
    alone!(Prismatic::along);
}
