//! The rigid body in the plane, (18) to (32).

use super::expansion::Expansion;
use crate::mechanics::planar::Inertia;
use crate::mechanics::planar::index::{M, ONE, QX, QY, THETA, X, Y};
use crate::scalar::Scalar;
use crate::state::TransferMatrix;

/// What is constant in a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rigid<T> {
    /// Mass, mass centre r_{2,C} and moment of inertia about it.
    pub inertia: Inertia<T>,
    /// Outboard end r_{2,O} (m), body axes.
    pub outboard: [T; 2],
}

impl<T: Scalar> Rigid<T> {
    /// J_I, about the inboard end: (20) is about I, so the J of (29) and (32) is this one.
    pub fn about_inboard(&self) -> T {
        let Inertia { mass, centre: [x, y], about_centre } = self.inertia;
        about_centre + mass * (x * x + y * y)
    }
}

/// External force on the mass centre (N) and external torque (N·m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct External<T> {
    /// f_C (N), inertial axes.
    pub force: [T; 2],
    /// m_C (N·m).
    pub torque: T,
}

/// The last column of (32) comes from these: what is known at t_i of each coordinate and point.
///
/// In absolute coordinates `acceleration` are χ₂, and `outboard` and `centre` are what (21) and (25) add to r_I at θ = 0. In
/// increments they are what an unchanged coordinate would bring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known<T> {
    /// χ₂ of x_I and y_I.
    pub inboard: [T; 2],
    /// χ₂ of x_C and y_C.
    pub centre: [T; 2],
    /// χ₂ of θ.
    pub angle: T,
    /// Φ r_{2,O} of (21): x G₁ − y G₂ and x G₂ + y G₁.
    pub to_outboard: [T; 2],
    /// Φ r_{2,C} of (25).
    pub to_centre: [T; 2],
}

impl<T: Scalar> Known<T> {
    /// In absolute coordinates, from the five χ₂ of a body, in the order x_I, y_I, x_C, y_C, θ.
    pub fn absolute(body: &Rigid<T>, at: &Expansion<T>, [xi, yi, xc, yc, angle]: [T; 5]) -> Self {
        let [g1, g2] = at.constants();
        let shifted = |[x, y]: [T; 2]| [x * g1 - y * g2, x * g2 + y * g1];
        Self {
            inboard: [xi, yi],
            centre: [xc, yc],
            angle,
            to_outboard: shifted(body.outboard),
            to_centre: shifted(body.inertia.centre),
        }
    }
}

/// (32): the transfer matrix of a rigid body moving in the plane. The paper writes χ₁ as χ₁ I; it is a number.
pub fn rigid_body<T: Scalar>(
    body: &Rigid<T>,
    at: &Expansion<T>,
    chi1: T::Real,
    known: &Known<T>,
    external: &External<T>,
) -> TransferMatrix<T, 7> {
    let mass = body.inertia.mass;
    let inertia = body.about_inboard();
    let [o, c] = [body.outboard, body.inertia.centre].map(|vector| at.turned(vector));
    // x_IO, y_IO, x_IC, y_IC: by c̄ and s̄, because they multiply other unknowns.
    let [[x_io, y_io], [x_ic, y_ic]] = [body.outboard, body.inertia.centre].map(|vector| at.turned_barred(vector));
    let External { force: [fx, fy], torque } = *external;
    let heavy = mass.scale(chi1); // m χ₁

    let mut u = TransferMatrix::identity();
    u[(X, THETA)] = -o[1]; // u13
    u[(Y, THETA)] = o[0]; // u23
    u[(X, ONE)] = known.to_outboard[0]; // u17
    u[(Y, ONE)] = known.to_outboard[1]; // u27
    u[(QX, X)] = -heavy; // u51
    u[(QY, Y)] = -heavy; // u62
    u[(QX, THETA)] = heavy * c[1]; // u53
    u[(QY, THETA)] = -(heavy * c[0]); // u63
    u[(QX, ONE)] = fx - heavy * known.to_centre[0] - mass * known.centre[0]; // u57
    // u67: printed with x G₂ + y G₂; the derivation gives x G₂ + y G₁.
    u[(QY, ONE)] = fy - heavy * known.to_centre[1] - mass * known.centre[1];
    u[(M, X)] = heavy * (y_io - y_ic); // u41
    u[(M, Y)] = heavy * (x_ic - x_io); // u42
    u[(M, THETA)] = u[(QY, THETA)] * x_io - u[(QX, THETA)] * y_io + inertia.scale(chi1); // u43
    u[(M, QX)] = -y_io; // u45
    u[(M, QY)] = x_io; // u46
    // u47: printed without its last product, [mχ_{2,xI} − f_x] y_IC.
    u[(M, ONE)] = -torque + u[(QY, ONE)] * x_io - u[(QX, ONE)] * y_io
        + inertia * known.angle
        + (mass * known.inboard[1] - fy) * x_ic
        - (mass * known.inboard[0] - fx) * y_ic;
    u
}

/// A lumped mass: (32) of a body without extent, q_O = q_I + f − m (χ₁ r + χ₂).
pub fn lumped_mass<T: Scalar>(mass: T, chi1: T::Real, chi2: [T; 2], force: [T; 2]) -> TransferMatrix<T, 7> {
    let mut u = TransferMatrix::identity();
    for ((q, r), (chi2, force)) in [(QX, X), (QY, Y)].into_iter().zip(chi2.into_iter().zip(force)) {
        u[(q, r)] = -mass.scale(chi1); // u51, u62
        u[(q, ONE)] = force - mass * chi2; // u57, u67
    }
    u
}
