//! What bodies and joints say of themselves.

use crate::element::{Space, Watch};
use crate::mirror::Rate;
use crate::relation::WrenchOf;
use crate::release::Release;
use crate::space::Balance;
use crate::system::Inertial;
use crate::transfer::Exact;
use std::vec::Vec;

/// How many of the numbers of a force are no torques.
pub(super) const fn places(entries: usize) -> usize {
    if entries == 7 { 2 } else { 3 }
}

/// Joints as they describe themselves.
pub(super) struct Releases<S: Space>(pub(super) Vec<Release<S>>);

impl<S: Space> Watch<S> for Releases<S> {
    fn joint_with(&mut self, _: &S::JointMotion, release: &dyn Fn() -> Release<S>) {
        self.0.push(release());
    }
}

/// Of each body its inertia force about its inboard end and the acceleration of that; joints as they describe themselves.
pub(super) struct Census<S: Space, const N: usize> {
    pub(super) gravity: S::Vector,
    pub(super) bodies: Vec<([f64; N], [f64; N])>,
    pub(super) joints: Vec<Release<S>>,
}

impl<S: Inertial + Exact<N> + Space<Scalar = f64>, const N: usize> Watch<S> for Census<S, N> {
    fn body(&mut self, body: &S::BodyMotion) {
        let internal = S::Station::of_body(body, self.gravity).close(WrenchOf::<S>::none());
        let mut force = [0.0; N];
        let mut entries = force.iter_mut();
        S::numbers(internal).visit(&mut |x| {
            if let Some(entry) = entries.next() {
                *entry = x;
            }
        });
        let state = S::acceleration_state(&S::inboard(body));
        self.bodies.push((force, core::array::from_fn(|i| state[i])));
    }
    fn joint_with(&mut self, _: &S::JointMotion, release: &dyn Fn() -> Release<S>) {
        self.joints.push(release());
    }
}
