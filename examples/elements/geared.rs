//! A motor in a joint: its rotor turns `ratio` times as fast as the joint, and its bearings rub.

use catena::Scalar;
use catena::extend::{JointModel, Kinematics, Resistance};
use catena::system::Space;
use std::fmt::Debug;

/// A geared motor on any kinematics with one coordinate: a hinge or a slide, in the plane or in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geared<T, K> {
    pub kinematics: K,
    /// Moment of inertia of the rotor (kg·m²).
    pub rotor: T,
    /// Turns of the rotor for one of the joint.
    pub ratio: T,
    /// Viscous friction (N·m·s/rad).
    pub friction: T,
}

catena::joint!([T: Scalar, K: Copy + Debug + 'static] Geared<T, K>);
catena::lift!(Geared<T, K> { kinematics, rotor, ratio, friction });

impl<S: Space, K: Kinematics<S>> JointModel<S> for Geared<S::Scalar, K> {
    type Kinematics = K;
    fn kinematics(&self) -> &K {
        &self.kinematics
    }
    fn kinematics_mut(&mut self) -> &mut K {
        &mut self.kinematics
    }
    fn resistance(&self, _: S::Scalar, rate: S::Scalar) -> Resistance<S::Scalar> {
        Resistance::viscous(self.friction, rate)
    }
    fn reflected_inertia(&self) -> S::Scalar {
        self.ratio * self.ratio * self.rotor
    }
}
