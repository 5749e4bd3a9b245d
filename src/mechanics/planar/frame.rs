//! What the walks carry in the plane.

use super::{Inertia, Planar, Station};
use crate::element::{Budget, Space, SpaceOver};
use crate::error::Fault;
use crate::relation;
use crate::relation::planar::Empty;
use crate::relation::planar::algebra::{add_scaled, cross, dot, normal};
use crate::release::Release;
use crate::scalar::{Real, Scalar};
use crate::space::{self, MovingBody, MovingJoint, Orientation};
use nalgebra::Vector2;

/// Orientation of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn<T> {
    /// Absolute angle (rad).
    pub angle: T,
    /// Angular velocity (rad/s).
    pub rate: T,
}

impl<T: Scalar> Orientation<T> for Turn<T> {
    #[inline(always)]
    fn unturned() -> Self {
        Self { angle: T::zero(), rate: T::zero() }
    }
    fn at_rest(&self) -> Self {
        Self { rate: T::zero(), ..*self }
    }
    #[inline(always)]
    fn spin(&self) -> T {
        self.rate
    }
    fn all_finite(&self) -> bool {
        self.angle.is_finite() && self.rate.is_finite()
    }
}

/// Acceleration of a station.
pub type Acceleration<T> = relation::Acceleration<Vector2<T>, T>;

/// Motion of a station: a point of a body.
pub type Frame<T> = space::Frame<Vector2<T>, T, Turn<T>>;

impl<T: Scalar> Frame<T> {
    /// The frame of a point that moves relative to the body: its displacement from here, the rate and the acceleration of that
    /// as seen from the body (m, m/s, m/s²; inertial axes).
    #[cfg_attr(optimised, inline(always))]
    pub fn displaced(&self, [d, rate, acceleration]: [Vector2<T>; 3]) -> Self {
        let frame = self.shifted(d);
        let spin = self.turn.rate;
        let linear = add_scaled(frame.acceleration.linear + acceleration, spin + spin, normal(rate));
        Self { velocity: frame.velocity + rate, acceleration: Acceleration { linear, ..frame.acceleration }, ..frame }
    }
}

/// Internal force q (N) and torque m (N·m) at a station: ON a body they act as +q, −m at its inboard and −q, +m at its outboard end.
pub type Internal<T> = relation::Wrench<Vector2<T>, T>;

/// A body and its motion at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyMotion<T> {
    /// Motion of the body's inboard end.
    pub inboard: Frame<T>,
    /// From the inboard to the outboard end (m), inertial axes.
    pub arm: Vector2<T>,
    /// From the inboard end to the mass centre (m), inertial axes.
    pub to_centre: Vector2<T>,
    /// Direction cosine and sine of the body.
    pub direction: Vector2<T>,
    /// Mass, mass centre and moment of inertia.
    pub inertia: Inertia<T>,
}

impl<T: Scalar> BodyMotion<T> {
    /// Absolute angle (rad).
    pub fn angle(&self) -> T {
        self.inboard.turn.angle
    }
    /// Angular velocity (rad/s).
    pub fn rate(&self) -> T {
        self.inboard.turn.rate
    }
    /// Motion of the outboard end.
    pub fn outboard(&self) -> Frame<T> {
        self.inboard.shifted(self.arm)
    }
    /// Motion of the mass centre.
    pub fn centre(&self) -> Frame<T> {
        self.inboard.shifted(self.to_centre)
    }
    /// Motion of a point given in body axes from the inboard end (m).
    pub fn point(&self, at: [T; 2]) -> Frame<T> {
        self.inboard.shifted(self.turned(at))
    }
    /// A vector of body axes in inertial axes.
    pub fn turned(&self, [x, y]: [T; 2]) -> Vector2<T> {
        let (cos, sin) = (self.direction.x, self.direction.y);
        Vector2::new(cos * x - sin * y, sin * x + cos * y)
    }
    /// Kinetic energy (J).
    pub fn kinetic_energy(&self) -> T {
        let velocity = self.centre().velocity;
        let rate = self.rate();
        (self.inertia.mass * dot(velocity, velocity) + self.inertia.about_centre * rate * rate).scale(T::Real::of(0.5))
    }
}

/// A joint and its motion at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointMotion<T> {
    /// Motion of the joint's inboard side.
    pub inboard: Frame<T>,
    /// Motion of the joint's outboard side.
    pub outboard: Frame<T>,
    /// From the joint's inboard to its outboard point (m), as far as its force has a moment about the former; zero where the points
    /// coincide.
    pub arm: Vector2<T>,
    /// Torque, force and energy of the joint's spring and damper.
    pub spring: SpringState<T>,
    /// Whether the outboard body turns relative to the inboard one.
    pub turns: bool,
    /// How far the outboard point stands from the inboard one (m) along the axes in which it moves: of a slider the coordinate along
    /// its line, of a hinge with linear springs both displacements; zero where the points coincide.
    pub slide: [T; 2],
    /// Rates of these displacements (m/s).
    pub sliding: [T; 2],
    /// Reflected inertia of the coordinate on which a drive acts (kg·m², kg), where there is any.
    pub inertia: T,
}

/// What the spring and damper of a joint do at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpringState<T> {
    /// Torque on the outboard body (N·m).
    pub torque: T,
    /// Forces on the outboard body (N) along the axes of the linear ones.
    pub force: [T; 2],
    /// Energy stored (J).
    pub energy: T,
}

impl<T: Scalar> JointMotion<T> {
    /// A joint without springs whose points coincide.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn coincident(inboard: Frame<T>, outboard: Frame<T>, turns: bool) -> Self {
        let (zero, none) = (T::zero(), [T::zero(); 2]);
        let spring = SpringState { torque: zero, force: none, energy: zero };
        let arm = Vector2::new(zero, zero);
        Self { inboard, outboard, arm, spring, turns, slide: none, sliding: none, inertia: zero }
    }

    /// Angle of the outboard body relative to the inboard one (rad).
    pub fn angle(&self) -> T {
        self.outboard.turn.angle - self.inboard.turn.angle
    }
    /// Rate of that angle (rad/s).
    pub fn rate(&self) -> T {
        self.outboard.turn.rate - self.inboard.turn.rate
    }
    /// The coordinate on which a drive in the joint acts: the relative angle (rad), or the distance along the line of a slider (m).
    pub fn driven(&self) -> T {
        if self.turns { self.angle() } else { self.slide[0] }
    }
    /// Rate of the driven coordinate (rad/s, m/s).
    pub fn driven_rate(&self) -> T {
        if self.turns { self.rate() } else { self.sliding[0] }
    }
}

impl<T: Scalar> Space for Planar<T> {
    const PLACES: usize = 2;

    type Size = T;
    type X = T;
    type Y = T;
    type P = T;
    type Q = T;
    type Turn = Turn<T>;
    type Station = Station<T>;
    type Angles = T;
    type BodyMotion = BodyMotion<T>;
    type JointMotion = JointMotion<T>;
    type Numbers = [T; 3];
    type Nothing = Empty;

    fn blank() -> (T, T, T, T) {
        (T::one(), T::zero(), T::zero(), T::zero())
    }
    fn no_size() -> T {
        T::zero()
    }
    #[inline(always)]
    fn numbers(internal: Internal<T>) -> [T; 3] {
        [internal.force.x, internal.force.y, internal.torque]
    }
    #[inline(always)]
    fn internal([x, y, torque]: [T; 3]) -> Internal<T> {
        Internal { force: Vector2::new(x, y), torque }
    }
}

impl<T: Scalar> MovingBody<Planar<T>> for BodyMotion<T> {
    fn mass(&self) -> T {
        self.inertia.mass
    }
    fn doubt(&self) -> Option<Fault> {
        self.inertia.doubt()
    }
    fn angles(&self) -> T {
        self.angle()
    }
    fn angle_out_of_range(&self) -> Option<f64> {
        let angle = self.angle().real();
        (angle.abs() > T::ANGLE_RANGE).then(|| angle.as_f64())
    }
    fn budget(&self, gravity: Vector2<T>) -> Budget<Planar<T>> {
        let centre = self.centre();
        let momentum = centre.velocity * self.inertia.mass;
        let spin = self.inertia.about_centre * self.rate();
        Budget {
            kinetic: self.kinetic_energy(),
            potential: -(dot(gravity, centre.place) * self.inertia.mass),
            momentum,
            angular_momentum: cross(centre.place, momentum) + spin,
        }
    }
}

impl<T: Scalar> MovingJoint<Planar<T>> for JointMotion<T> {
    fn turn_out_of_range(&self, _: &Release<Planar<T>>) -> Option<f64> {
        None // sines are taken of the angles of bodies
    }
    fn stored(&self) -> [T; 2] {
        let rate = self.driven_rate();
        [(self.inertia * rate * rate).scale(T::Real::of(0.5)), self.spring.energy]
    }
}

impl<T: Scalar, U: Scalar> SpaceOver<U> for Planar<T> {
    type Over = Planar<U>;
    fn lift_vector(vector: Vector2<T>, number: &mut impl FnMut(T) -> U) -> Vector2<U> {
        vector.map(number)
    }
}
