//! A tank: a rigid body in which a part of the liquid sloshes along a line, held back by a spring.

use catena::Scalar;
use catena::planar::{Branch, RigidBody, Slider, Spring};

/// The tank as far as the liquid's place, the liquid on its line, and what is left to the outboard end.
type Parts<T> = (RigidBody<T>, Branch<(Slider<T, Spring<T, T>>, RigidBody<T>)>, RigidBody<T>);

/// A tank between an inboard end, the origin of its axes, and an outboard one; its inner coordinate is how far the liquid has moved (m).
#[derive(Clone, Copy, Debug)]
pub struct Tank<T> {
    parts: Parts<T>,
}

catena::compound!([T: Scalar] Tank<T> { parts: Parts<T> });
catena::lift!(Tank<T> { parts });

/// What sloshes: mass (kg), place at rest (m) and direction (rad) in axes of the tank, spring and damper along it.
#[derive(Clone, Copy, Debug)]
pub struct Liquid<T> {
    pub mass: T,
    pub place: [T; 2],
    pub direction: T,
    pub spring: Spring<T, T>,
}

impl<T: Scalar> Tank<T> {
    /// All that is rigid has a mass (kg), a moment of inertia about its mass centre (kg·m²) and that centre (m).
    pub fn new((mass, inertia, centre): (T, T, [T; 2]), liquid: Liquid<T>, outboard: [T; 2]) -> Self {
        let (zero, [x, y]) = (T::zero(), liquid.place);
        let rigid = RigidBody::new(mass, inertia, centre, liquid.place);
        let line = Slider::along(liquid.direction).with(liquid.spring);
        let drop = RigidBody::new(liquid.mass, zero, [zero; 2], [zero; 2]);
        Self { parts: (rigid, Branch((line, drop)), RigidBody::massless([outboard[0] - x, outboard[1] - y])) }
    }
}
