//! Exact transfer matrices of spatial elements at acceleration level: z = [r̈, ω̇, m, q, 1] in inertial axes, no linearisation.
//!
//! They are (20)-(31) and (36)-(40) of the paper with χ₁ → 1, angular accelerations for second derivatives of angles, and velocity
//! terms exact instead of extrapolated. (40) is generalised from balls to all joints; see [`Passage::matrix`].

use super::index::{M, ONE, Q, R, THETA};
use super::{BodyMotion, Effort, Frame, JointMotion, Release, Spatial, Station};
use crate::element::Load;
use crate::relation::Additive;
use crate::relation::spatial::algebra::{Columns, centripetal, cross};
use crate::release::{Freedom, Way};
use crate::scalar::Scalar;
use crate::state::{StateVector, TransferMatrix};
use crate::transfer::{Efforts, Exact, FromEfforts, Passage};
use nalgebra::Vector3;

impl<T: Scalar> Efforts<Spatial<T>> for Effort<T> {
    fn efforts(self) -> [T; 3] {
        self.0
    }
}

impl<T: Scalar> FromEfforts for Spatial<T> {
    fn of_efforts(efforts: [T; 3]) -> Effort<T> {
        Effort(efforts)
    }
}

/// The matrix of v × .
fn tilde<T: Scalar>(v: Vector3<T>) -> Columns<T> {
    let Columns { x, y, z } = Columns::identity();
    Columns { x: cross(v, x), y: cross(v, y), z: cross(v, z) }
}

fn scaled<T: Scalar>(block: Columns<T>, factor: T) -> Columns<T> {
    Columns { x: block.x * factor, y: block.y * factor, z: block.z * factor }
}

/// Sets the block that begins at a row and a column.
fn set<T: Scalar>(u: &mut TransferMatrix<T, 13>, (row, column): (usize, usize), block: Columns<T>) {
    for (j, entries) in [block.x, block.y, block.z].into_iter().enumerate() {
        set_column(u, (row, column + j), entries);
    }
}

fn set_column<T: Scalar>(u: &mut TransferMatrix<T, 13>, (row, column): (usize, usize), entries: Vector3<T>) {
    entries.iter().enumerate().for_each(|(i, entry)| u[(row + i, column)] = *entry);
}

/// A row or column with a vector.
fn with<T: Scalar>(at: usize, v: Vector3<T>) -> [T; 13] {
    core::array::from_fn(|i| if (at..at + 3).contains(&i) { v[i - at] } else { T::zero() })
}

impl<T: Scalar> Exact<13> for Spatial<T> {
    fn body_matrix(body: &BodyMotion<T>, gravity: Vector3<T>, load: impl Load<Self>) -> TransferMatrix<T, 13> {
        let mass = body.inertia.mass;
        let (o, c, turn) = (body.arm, body.to_centre, body.inboard.turn);
        let about_inboard = body.inertia.about_inboard().turned(&turn.attitude);
        // f_C, and the external torque about I: m_C + r_C × f_C.
        let external = load.wrench();
        let weight = gravity * mass;
        let force = weight + external.force;
        let torque = cross(c, weight) + external.torque;

        let mut u = TransferMatrix::identity();
        set(&mut u, (R, THETA), tilde(-o)); // U12
        set_column(&mut u, (R, ONE), centripetal(turn.spin, o)); // U15
        set(&mut u, (Q, R), scaled(Columns::identity(), -mass)); // U41
        set(&mut u, (Q, THETA), tilde(c * mass)); // U42
        let u45 = force - centripetal(turn.spin, c) * mass;
        set_column(&mut u, (Q, ONE), u45);
        set(&mut u, (M, R), tilde((c - o) * mass)); // U31
        let levered = scaled(tilde(o).times(&tilde(c)), mass);
        set(&mut u, (M, THETA), about_inboard.columns() + levered); // U32
        set(&mut u, (M, Q), tilde(o)); // U34
        let gyroscopic = cross(turn.spin, about_inboard.apply(turn.spin));
        set_column(&mut u, (M, ONE), gyroscopic - torque + cross(o, u45)); // U35
        u
    }

    fn passage(joint: &JointMotion<T>, release: &Release<T>, efforts: [T; 3]) -> Passage<T, 13> {
        let Release { carries, linear, angular, .. } = *release;
        let d = joint.outboard.place - joint.inboard.place;
        let mut fixed = TransferMatrix::identity();
        set(&mut fixed, (R, THETA), tilde(-d));
        set_column(&mut fixed, (R, ONE), linear);
        if !carries {
            set(&mut fixed, (THETA, THETA), Columns::null());
        }
        set_column(&mut fixed, (THETA, ONE), angular);
        set(&mut fixed, (M, Q), tilde(d)); // m_O = m_I + d × q
        let mut passage = Passage::of(fixed);
        for (Freedom { way, axis, resistance, inertia, .. }, applied) in release.under(efforts) {
            // A torque on the outboard body is −m, a force on it q.
            passage = match way {
                Way::Turn => passage.with(with(THETA, axis), with(M, axis), [-(resistance.force + applied), -inertia]),
                Way::Slide => passage.with(with(R, axis), with(Q, axis), [resistance.force + applied, inertia]),
            };
        }
        passage
    }

    fn acceleration_state(frame: &Frame<T>) -> StateVector<T, 13> {
        Station::massless(*frame).acceleration_state()
    }
}
