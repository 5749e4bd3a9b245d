//! Elastic hinges (33) to (35) and smooth balls (36) to (40) in space.

use super::algebra::{Matrix, Vector, apply, from_fn, inverse, size, times};
use super::attitude::Attitude;
use super::{ANGLES, FORCE, ONE, PLACE, TORQUE};
use crate::error::{Error, Fault};
use crate::paper::hinge::Linear;
use crate::paper::link::Law;
use crate::scalar::Scalar;
use crate::state::TransferMatrix;

/// Rotary springs and dampers about the inertial axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotary<T> {
    /// k′ (N·m/rad).
    pub stiffness: Vector<T>,
    /// c′ (N·m·s/rad).
    pub damping: Vector<T>,
}

/// (35), rotary part, with a rigid translation: (34) printed for the differences of the angles and of A ω.
///
/// Its springs act along inertial axes and on differences of angles: turning the whole system changes their torques, and going round a
/// loop of orientations they do work. It is good for small relative angles, or for motion about one inertial axis.
///
/// # Errors
/// [`Fault::SingularTransfer`] where k′ + c′ A_O H_O χ₃ cannot be inverted: a direction without spring and damper.
pub fn rotary_hinge<T: Scalar>(
    hinge: &Rotary<T>,
    sides: [&Attitude<T>; 2],
    chi3: T::Real,
    chi4: [Vector<T>; 2],
) -> Result<TransferMatrix<T, 13>, Error> {
    let zero = T::zero();
    // c′ A H of both sides, at t_i.
    let [inner, outer] = sides.map(|side| {
        let spin = side.spin();
        from_fn(|i, j| hinge.damping[i] * spin[i][j])
    });
    let with_spring =
        |damper: &Matrix<T>| from_fn(|i, j| damper[i][j].scale(chi3) + if i == j { hinge.stiffness[i] } else { zero });
    let whole = with_spring(&outer);
    inverse(&whole, size(&whole)).ok_or(Error::new(Fault::SingularTransfer))?;
    let (from_inner, from_outer) = (apply(&inner, chi4[0]), apply(&outer, chi4[1]));
    let offset = core::array::from_fn(|i| from_outer[i] - from_inner[i]);
    Ok(elastic_hinge(&Law { outer: whole, inner: with_spring(&inner), offset }))
}

/// [`rotary_hinge`] for m = K_O θ_O − K_I θ_I + μ.
pub(super) fn elastic_hinge<T: Scalar>(law: &Law<T, 3>) -> TransferMatrix<T, 13> {
    let u23 = crate::paper::link::inverse(&law.outer);
    let u22 = times(&u23, &law.inner);
    let u25 = apply(&u23, law.offset.map(|x| -x));
    let mut u = TransferMatrix::identity();
    for i in 0..3 {
        for j in 0..3 {
            u[(ANGLES + i, ANGLES + j)] = u22[i][j];
            u[(ANGLES + i, TORQUE + j)] = u23[i][j];
        }
        u[(ANGLES + i, ONE)] = u25[i];
    }
    u
}

/// (33) and (35), linear part: as in the [plane](crate::paper::linear_hinge), along inertial axes.
///
/// No scene runs with it: linear springs of scenes in space push along axes of the inboard body, and their force has a moment.
pub fn linear_hinge<T: Scalar>(axes: [Option<Linear<T>>; 3]) -> TransferMatrix<T, 13> {
    let mut u = TransferMatrix::identity();
    for (k, axis) in axes.into_iter().enumerate() {
        if let Some(Linear { slope, offset }) = axis {
            let compliance = slope.recip();
            u[(PLACE + k, FORCE + k)] = -compliance; // U14
            u[(PLACE + k, ONE)] = -(compliance * offset); // U15
        }
    }
    u
}

/// (40): the transfer matrix of a smooth ball-and-socket hinge, from that of its section: what lies outboard of it, up to the next
/// ball or the free end (sections 3.4.1 to 3.4.3).
///
/// Ū₃₂ is singular where the outboard end is the centre of percussion of the ball, and at θ₂ = ±π/2. `inertia` is the size of its terms,
/// of J_I + m |r_C| |r_O| times χ₁; `torques` are m known in this ball and at the outboard end of the section, zero unless applied.
///
/// # Errors
/// [`Fault::CentreOfPercussion`] there.
pub fn smooth_ball<T: Scalar>(
    section: &TransferMatrix<T, 13>,
    [here, outer]: [Vector<T>; 2],
    inertia: T::Real,
) -> Result<TransferMatrix<T, 13>, Error> {
    let block = |column: usize| from_fn(|i, j| section[(TORQUE + i, column + j)]);
    let pivot = block(ANGLES);
    let inverted = inverse(&pivot, inertia).ok_or(Error::new(Fault::CentreOfPercussion))?;
    let mut u = TransferMatrix::identity();
    let (of_place, of_force) = (times(&inverted, &block(PLACE)), times(&inverted, &block(FORCE)));
    // The paper's torques are zero.
    let passed = apply(&block(TORQUE), here);
    let known = apply(&inverted, core::array::from_fn(|i| section[(TORQUE + i, ONE)] + passed[i] - outer[i]));
    for i in 0..3 {
        for j in 0..3 {
            u[(ANGLES + i, PLACE + j)] = -of_place[i][j];
            u[(ANGLES + i, ANGLES + j)] = T::zero();
            u[(ANGLES + i, FORCE + j)] = -of_force[i][j];
        }
        u[(ANGLES + i, ONE)] = -known[i];
    }
    Ok(u)
}
