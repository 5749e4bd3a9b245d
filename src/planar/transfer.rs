//! Exact transfer matrices of planar elements at acceleration level: z = [ẍ, ÿ, θ̈, m, q_x, q_y, 1], no linearisation.
//!
//! They are (32) and (40) of the paper with χ₁ → 1 and velocity terms exact instead of extrapolated. Two entries are
//! corrected: (32) prints y·G₂ for y·G₁ in u₆₇, and it lacks the x component of the last product in u₄₇.

use super::index::{M, ONE, QX, QY, THETA, X, Y};
use super::{BodyMotion, Frame, JointMotion, Planar, Station};
use crate::element::Load;
use crate::error::{Error, Fault};
use crate::relation::plane::algebra::cross;
use crate::scalar::Scalar;
use crate::state::{StateVector, TransferMatrix};
use crate::transfer::Exact;
use nalgebra::Vector2;
use num_traits::Zero;

impl<T: Scalar> Exact<7> for Planar<T> {
    fn body_matrix(body: &BodyMotion<T>, gravity: Vector2<T>, load: impl Load<Self>) -> TransferMatrix<T, 7> {
        let mass = body.inertia.mass;
        let (o, c) = (body.arm, body.to_centre);
        let spin2 = body.rate() * body.rate();
        let about_inboard = body.inertia.about_centre + mass * (c.x * c.x + c.y * c.y);
        // f and the external torque about I, which is m_C + d_C × f.
        let mut external = Station::massless(body.inboard);
        load.act(&mut external);
        let weight = gravity * mass;
        let force = weight - external.inertia_force;
        let torque = cross(c, weight) - external.inertia_torque;

        let mut u = TransferMatrix::identity();
        u[(X, THETA)] = -o.y; // u13
        u[(Y, THETA)] = o.x; // u23
        u[(X, ONE)] = -(spin2 * o.x); // u17
        u[(Y, ONE)] = -(spin2 * o.y); // u27
        u[(QX, X)] = -mass; // u51
        u[(QY, Y)] = -mass; // u62
        u[(QX, THETA)] = mass * c.y; // u53
        u[(QY, THETA)] = -(mass * c.x); // u63
        u[(QX, ONE)] = force.x + mass * spin2 * c.x; // u57
        u[(QY, ONE)] = force.y + mass * spin2 * c.y; // u67
        u[(M, X)] = mass * (o.y - c.y); // u41
        u[(M, Y)] = mass * (c.x - o.x); // u42
        u[(M, THETA)] = about_inboard + o.x * u[(QY, THETA)] - o.y * u[(QX, THETA)]; // u43
        u[(M, QX)] = -o.y; // u45
        u[(M, QY)] = o.x; // u46
        u[(M, ONE)] = o.x * u[(QY, ONE)] - o.y * u[(QX, ONE)] - torque; // u47
        u
    }

    fn joint_matrix(
        joint: &JointMotion<T>,
        torque: T,
        section: &TransferMatrix<T, 7>,
        outer_torque: T,
    ) -> Result<TransferMatrix<T, 7>, Error> {
        if !joint.turns {
            return Ok(TransferMatrix::identity());
        }
        let pivot = section[(M, THETA)]; // Ū₄₃
        if pivot.real().is_zero() || !pivot.is_finite() {
            return Err(Error::new(Fault::SingularTransfer));
        }
        // (40): m at the outboard end of the section is −τ of the joint there; it fixes θ̈ outboard of this one.
        let mut u = TransferMatrix::identity();
        for column in [X, Y, QX, QY] {
            u[(THETA, column)] = -(section[(M, column)] / pivot);
        }
        u[(THETA, THETA)] = T::zero();
        u[(THETA, M)] = T::zero();
        u[(THETA, ONE)] = -((section[(M, ONE)] + outer_torque - section[(M, M)] * torque) / pivot);
        Ok(u)
    }

    fn joint_torque(joint: &JointMotion<T>, applied: T) -> Option<T> {
        joint.turns.then(|| joint.spring.torque + applied)
    }

    fn acceleration_state(frame: &Frame<T>) -> StateVector<T, 7> {
        Station::massless(*frame).acceleration_state()
    }
}
