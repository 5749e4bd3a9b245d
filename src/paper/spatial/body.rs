//! The rigid body in space, (18) to (31).

use super::algebra::{Matrix, Vector, apply, columns, cross, from_fn, sum, tilde, times};
use super::attitude::Attitude;
use super::{ANGLES, FORCE, ONE, PLACE, TORQUE};
use crate::paper::link::Given;
use crate::scalar::{Real, Scalar};
use crate::state::TransferMatrix;

/// What is constant in a body, in its own axes, whose origin is its inboard end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rigid<T> {
    /// Mass (kg).
    pub mass: T,
    /// r_{2,C} (m).
    pub centre: Vector<T>,
    /// r_{2,O} (m).
    pub outboard: Vector<T>,
    /// J about the *inboard end* (kg·m²): (20) is about I, so the "inertia matrix" of (29) is this one.
    pub about_inboard: Matrix<T>,
}

/// χ₁, χ₃, and χ₂ and χ₄ of a body's coordinates in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step<T: Scalar> {
    /// χ₁ (1/s²).
    pub chi1: T::Real,
    /// χ₃ (1/s).
    pub chi3: T::Real,
    /// χ₂ of r_I (m/s²).
    pub inboard: Vector<T>,
    /// χ₂ of r_C (m/s²).
    pub centre: Vector<T>,
    /// χ₂ of θ (rad/s²).
    pub angles: Vector<T>,
    /// χ₄ of θ (rad/s).
    pub angle_rates: Vector<T>,
}

/// External force on the mass centre (N) and external torque (N·m), inertial axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct External<T> {
    /// f_C (N).
    pub force: Vector<T>,
    /// m_C (N·m).
    pub torque: Vector<T>,
}

/// (31): the transfer matrix of a rigid body moving in space.
pub fn rigid_body<T: Scalar>(
    body: &Rigid<T>,
    at: &Attitude<T>,
    step: &Step<T>,
    external: &External<T>,
) -> TransferMatrix<T, 13> {
    let known = Given {
        inboard: step.inboard,
        centre: step.centre,
        angles: step.angles,
        rates: step.angle_rates,
        arms: [body.centre, body.outboard].map(|arm| at.phi(arm)),
    };
    let shape = Shape {
        psi: [body.centre, body.outboard].map(|arm| at.psi(arm)),
        barred: at.barred,
        gyration: gyration(body, at, [step.chi1, step.chi3], &known),
    };
    shape.matrix(body, step.chi1, &known, external)
}

/// A lumped mass: (31) of a body without extent, q_O = q_I + f − m (χ₁ r + χ₂).
pub fn lumped_mass<T: Scalar>(mass: T, chi1: T::Real, chi2: Vector<T>, force: Vector<T>) -> TransferMatrix<T, 13> {
    let mut u = TransferMatrix::identity();
    for k in 0..3 {
        u[(FORCE + k, PLACE + k)] = -mass.scale(chi1);
        u[(FORCE + k, ONE)] = force[k] - mass * chi2[k];
    }
    u
}

/// What orientations bring to (31).
pub(super) struct Shape<T> {
    /// Ψ of mass centre and outboard end, (22).
    pub psi: [Matrix<T>; 2],
    /// Ā.
    pub barred: Matrix<T>,
    /// κ₄ and κ₅ of (29).
    pub gyration: (Matrix<T>, Vector<T>),
}

impl<T: Scalar> Shape<T> {
    /// (31).
    pub fn matrix(
        &self,
        body: &Rigid<T>,
        chi1: T::Real,
        known: &Given<T, 3, 3>,
        external: &External<T>,
    ) -> TransferMatrix<T, 13> {
        let heavy = body.mass.scale(chi1); // m χ₁
        let [psi_c, psi_o] = &self.psi;
        let [r_io, r_ic] = [body.outboard, body.centre].map(|point| apply(&self.barred, point));
        let (io, ic) = (tilde(r_io), tilde(r_ic));

        // (26), (27)
        let u42 = psi_c.map(|row| row.map(|x| -(heavy * x)));
        let [to_centre, to_outboard] = known.arms;
        let u45: Vector<T> =
            core::array::from_fn(|i| external.force[i] - heavy * to_centre[i] - body.mass * known.centre[i]);

        // (28), (29)
        let (kappa4, kappa5) = &self.gyration;
        let arm = times(&io, &u42);
        let pull: Vector<T> = core::array::from_fn(|i| body.mass * known.inboard[i] - external.force[i]);
        let lever = sum(cross(r_ic, pull), cross(r_io, u45));
        let u35: Vector<T> = core::array::from_fn(|i| kappa5[i] - external.torque[i] + lever[i]);

        let mut u = TransferMatrix::identity();
        for i in 0..3 {
            for j in 0..3 {
                u[(PLACE + i, ANGLES + j)] = psi_o[i][j];
                u[(TORQUE + i, PLACE + j)] = (ic[i][j] - io[i][j]) * heavy;
                u[(TORQUE + i, ANGLES + j)] = kappa4[i][j] + arm[i][j];
                u[(TORQUE + i, FORCE + j)] = io[i][j];
                u[(FORCE + i, ANGLES + j)] = u42[i][j];
            }
            u[(FORCE + i, PLACE + i)] = -heavy;
            u[(PLACE + i, ONE)] = to_outboard[i];
            u[(TORQUE + i, ONE)] = u35[i];
            u[(FORCE + i, ONE)] = u45[i];
        }
        u
    }
}

/// κ₄ and κ₅ of (29): Ġ_I = κ₄ θ + κ₅.
pub(super) fn gyration<T: Scalar>(
    body: &Rigid<T>,
    at: &Attitude<T>,
    [chi1, chi3]: [T::Real; 2],
    step: &Given<T, 3, 3>,
) -> (Matrix<T>, Vector<T>) {
    let inertia = &body.about_inboard;
    let [t1, t2, t3] = at.barred_tangents;
    let of = |t: Vector<T>| apply(inertia, t);
    let turned = |x: Vector<T>| apply(&at.barred, x);
    // H₁ and H₂: (29) lacks the tildes of the first factors.
    let h1 = columns([cross(t1, of(t1)), cross(t2, of(t2)), cross(t3, of(t3))].map(turned));
    let mixed = |bend: Vector<T>, a: Vector<T>, b: Vector<T>| sum(of(bend), sum(cross(a, of(b)), cross(b, of(a))));
    let [t12, t23, t31] = at.barred_bends;
    let h2 = columns([mixed(t12, t1, t2), mixed(t23, t2, t3), mixed(t31, t3, t1)].map(turned));
    // κ₁ and κ₂ of (12)
    let ([r1, r2, r3], zero) = (at.rates, T::zero());
    let two = T::Real::of(2.0);
    let kappa1 = [[r1.scale(two), zero, zero], [zero, r2.scale(two), zero], [zero, zero, r3.scale(two)]];
    let kappa2 = [[r2, r1, zero], [zero, r3, r2], [r3, zero, r1]];
    let (first, second) = (times(&h1, &kappa1), times(&h2, &kappa2));
    let products = from_fn(|i, j| first[i][j] + second[i][j]);
    // κ₃
    let half = T::Real::of(0.5);
    let kappa3: Vector<T> = core::array::from_fn(|k| step.rates[k] - at.rates[k].scale(half));

    let ajh = times(&times(&at.barred, inertia), &columns(at.barred_tangents));
    let kappa4 = from_fn(|i, j| ajh[i][j].scale(chi1) + products[i][j].scale(chi3));
    // (29) prints first derivatives in the last two products; (12) has the second ones.
    let [d1, d2, d3] = at.change;
    let squares = sum(apply(&h1, [d1 * d1, d2 * d2, d3 * d3]), apply(&h2, [d1 * d2, d2 * d3, d3 * d1]));
    let kappa5 = sum(sum(apply(&ajh, step.angles), apply(&products, kappa3)), squares);
    (kappa4, kappa5)
}
