//! Exact transfer matrices of planar elements at acceleration level: z = [ẍ, ÿ, θ̈, m, q_x, q_y, 1], no linearisation.
//!
//! They are (32) and (40) of the paper with χ₁ → 1 and velocity terms exact instead of extrapolated. Two entries are
//! corrected: (32) prints y·G₂ for y·G₁ in u₆₇, and it lacks the x component of the last product in u₄₇.

use super::index::{M, ONE, QX, QY, THETA, X, Y};
use super::{BodyMotion, Frame, JointMotion, Planar, Station};
use crate::element::Load;
use crate::relation::planar::algebra::cross;
use crate::release::{Freedom, Release, Way};
use crate::scalar::Scalar;
use crate::state::{StateVector, TransferMatrix};
use crate::transfer::{Efforts, Exact, FromEfforts, Passage};
use nalgebra::Vector2;

impl<T: Scalar> Efforts<Planar<T>> for T {
    fn efforts(self) -> [T; 3] {
        [self, T::zero(), T::zero()]
    }
}

impl<T: Scalar> FromEfforts for Planar<T> {
    fn of_efforts([effort, ..]: [T; 3]) -> T {
        effort
    }
}

/// A row or column with a one.
fn unit<T: Scalar>(at: usize) -> [T; 7] {
    core::array::from_fn(|i| if i == at { T::one() } else { T::zero() })
}

impl<T: Scalar> Exact<7> for Planar<T> {
    fn body_matrix(body: &BodyMotion<T>, gravity: Vector2<T>, load: impl Load<Self>) -> TransferMatrix<T, 7> {
        let mass = body.inertia.mass;
        let (o, c) = (body.arm, body.to_centre);
        let spin2 = body.rate() * body.rate();
        let about_inboard = body.inertia.about_centre + mass * (c.x * c.x + c.y * c.y);
        // f and the external torque about I, which is m_C + d_C × f.
        let external = load.wrench();
        let weight = gravity * mass;
        let force = weight + external.force;
        let torque = cross(c, weight) + external.torque;

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

    fn passage(joint: &JointMotion<T>, release: &Release<Self>, efforts: [T; 3]) -> Passage<T, 7> {
        let d = joint.outboard.place - joint.inboard.place;
        let mut fixed = TransferMatrix::identity();
        if release.swings {
            fixed[(X, THETA)] = -d.y;
            fixed[(Y, THETA)] = d.x;
        }
        (fixed[(X, ONE)], fixed[(Y, ONE)], fixed[(THETA, ONE)]) = (release.linear.x, release.linear.y, release.angular);
        if !release.carries {
            fixed[(THETA, THETA)] = T::zero();
        }
        if release.balanced {
            fixed[(M, QX)] = -d.y; // m_O = m_I + d × q
            fixed[(M, QY)] = d.x;
        }
        let mut passage = Passage::of(fixed);
        for (Freedom { way, axis, resistance, inertia, .. }, applied) in release.under(efforts) {
            // A torque on the outboard body is −m, a force on it q.
            passage = match way {
                Way::Turn => passage.with(unit(THETA), unit(M), [-(resistance.force + applied), -inertia]),
                Way::Slide => {
                    let along = |x: usize, y: usize| {
                        core::array::from_fn(|i| {
                            if i == x {
                                axis.x
                            } else if i == y {
                                axis.y
                            } else {
                                T::zero()
                            }
                        })
                    };
                    passage.with(along(X, Y), along(QX, QY), [resistance.force + applied, inertia])
                }
            };
        }
        passage
    }

    fn acceleration_state(frame: &Frame<T>) -> StateVector<T, 7> {
        Station::massless(*frame).acceleration_state()
    }
}
