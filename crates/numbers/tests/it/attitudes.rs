//! Attitudes on lanes, each of which decides for itself, and on dual numbers.

use catena::scalar::{Elementary, Jet, Scalar, WideF32x4, WideF64x4};
use catena::spatial::*;
use catena::{Error, Fault};
use catena_oracle::near;
use core::f64::consts::{FRAC_PI_2, PI};
use num_dual::Dual64;

/// Four numbers in lanes, and one list of lists the other way round.
fn lanes<const N: usize>(each: [[f64; N]; 4]) -> [WideF64x4; N] {
    core::array::from_fn(|i| each.map(|one| one[i]).into())
}

fn same<const N: usize>(found: [WideF64x4; N], expected: [[f64; N]; 4]) {
    for (i, found) in found.into_iter().enumerate() {
        assert_eq!(found.into_arr(), expected.map(|one| one[i]), "number {i}");
    }
}

#[test]
fn each_lane_has_a_quaternion_of_length_one() -> Result<(), Error> {
    fn set<T: Scalar>(quaternion: [T; 4]) -> Result<[T; 4], Error> {
        let rod = RigidBody::new(
            T::one(),
            [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]].map(|row| row.map(T::literal)),
            [T::zero(); 3],
            [T::zero(); 3],
        );
        let mut motion = System::new(Pinned::origin(), (rod,), Free)?.motion();
        motion.set_coordinates(&quaternion)?;
        let mut found = [T::zero(); 4];
        found.copy_from_slice(&motion.coordinates());
        Ok(found)
    }
    let each = [[1.0, 0.0, 0.0, 0.0], [0.5, 0.5, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 3.0, 0.0]];
    let mut alone = [[0.0; 4]; 4];
    for (found, given) in alone.iter_mut().zip(each) {
        *found = set(given)?;
    }
    same(set(lanes(each))?, alone);
    let none = set(lanes([each[0], [0.0; 4], each[0], each[0]])).map_err(|error| error.fault);
    assert!(matches!(none, Err(Fault::NotPositive { .. })), "{none:?}");
    Ok(())
}

#[test]
fn each_lane_turns_the_shorter_way() {
    let turns = [0.17, 6.1, -3.0, 2.0 * PI - 1e-3];
    let found = Rotation::exp(lanes(turns.map(|turn| [0.0, 0.0, turn]))).shortest().log();
    for (found, turn) in found[2].into_arr().into_iter().zip(turns) {
        // How often a vector is halved is what the longest needs.
        near(found, Rotation::exp([0.0, 0.0, turn]).shortest().log()[2], 1e-14);
    }
}

#[test]
fn each_lane_has_its_attitude_and_angles_from_its_matrix() {
    let attitudes = [[0.0; 3], [PI, 0.0, 0.0], [0.0, FRAC_PI_2, 0.3], [-0.4, 2.9, 0.8]];
    let alone = attitudes.map(Rotation::exp);
    let together = Rotation::exp(lanes(attitudes));
    same(together.angles(), alone.map(|one| one.angles()));
    same(
        Rotation::from_matrix(&together.matrix()).quaternion(),
        alone.map(|one| Rotation::from_matrix(&one.matrix()).quaternion()),
    );
    let near = [[0.1, -0.1, 20.0], [-15.0, 4.0, 2.0], [1.0, 1.5, 7.0], [0.0, 0.0, -70.0]];
    let expected: Vec<_> = alone.iter().zip(near).map(|(one, near)| one.angles_near(near)).collect();
    for (found, expected) in together
        .angles_near(lanes(near))
        .into_iter()
        .enumerate()
        .map(|(i, found)| (found, expected.iter().map(move |one| one[i])))
    {
        assert!(found.into_arr().into_iter().eq(expected));
    }
}

/// Three rods whose end the ground holds about an axis: forces across axes that differ from lane to lane.
#[test]
fn each_lane_is_held_across_its_own_axis() -> Result<(), Error> {
    macro_rules! scene {
        ($axis:expr, $number:expr) => {{
            let [o, one, thin, away, side, down] = [0.0, 1.0, 0.05, 1.2, 0.3, -9.81].map($number);
            let rod = Rod::uniform(one, thin, one);
            let scene = System::new(Pinned::on([o; 3]), (rod, Ball, rod, Ball, rod), Hinged::at([away, o, o], $axis))?;
            scene.with_gravity([side, down, o])
        }};
    }
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.5, -0.6, 0.7]];
    let (mut starts, mut alone) = ([[0.0; 12]; 4], [[0.0; 9]; 4]);
    for (lane, axis) in axes.into_iter().enumerate() {
        let scene = scene!(axis, |x: f64| x);
        let guess = scene.at_rest(&[0.2, 0.1, 0.9, 0.1, -0.2, -0.4, 0.0, 0.1, -1.0])?;
        let start = scene.assembled(guess, &Unloaded)?;
        start.coordinates_into(&mut starts[lane])?;
        scene.simulate(start, Rk4::step(0.01), 0.1, |_| ())?.motion.rates_into(&mut alone[lane])?;
    }
    let scene = scene!(lanes(axes), WideF64x4::literal);
    let mut start = scene.motion();
    start.set_coordinates(&lanes(starts))?;
    let found = scene.simulate(start, Rk4::step(0.01), 0.1, |_| ())?.motion.rates();
    for (i, found) in found.into_iter().enumerate() {
        let expected = alone.map(|one| one[i]);
        found.into_arr().into_iter().zip(expected).for_each(|(found, alone)| near(found, alone, 1e-9));
    }
    assert!(alone.iter().all(|one| one.iter().any(|rate| rate.abs() > 0.01)), "{alone:?}");
    Ok(())
}

#[test]
fn directions_have_derivatives_beside_longer_ones() {
    let at = |x: [f32; 4]| Jet::<WideF32x4, 1> { re: x.into(), eps: [[1.0; 4].into()] };
    let angle = at([1e-25, 1.0, 1.0, 1.0]).atan2(at([1e-25, 1.0, 2.0, 3.0]));
    // d atan2(y, x) = (x − y) / (x² + y²), for both grow alike.
    assert_eq!(angle.eps[0].into_arr()[0], 0.0);
    assert!((angle.eps[0].into_arr()[2] - 0.2).abs() < 1e-7);
}

#[test]
fn a_weld_that_turns_nothing_has_derivatives() -> Result<(), Error> {
    let one = |x: f64| Dual64::from_re(x);
    let rod = Rod::uniform(one(0.5), one(0.02), one(1.0));
    let weld = Weld::at(Rotation::exp([one(0.0), one(0.0), Dual64::new(0.0, 1.0)]));
    let hinge = Revolute::about([one(0.0), one(0.0), one(1.0)]);
    let arm = System::new(Pinned::origin(), (rod, hinge, rod, weld, rod.named("last")), Free)?;
    let turned = arm.with_body_orientation(arm.motion(), "last", Rotation::exp([one(0.0), one(0.0), one(0.7)]))?;
    let [angle] = turned.coordinates_of(arm.joint(1)?)?;
    assert!((angle.re - 0.7).abs() < 1e-15 && (angle.eps + 1.0).abs() < 1e-14, "{angle:?}");
    Ok(())
}
