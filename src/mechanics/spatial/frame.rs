//! What the walks carry in space.

use super::{Inertia, Rotation, Spatial, Station};
use crate::element::{Budget, Space, SpaceOver};
use crate::error::Fault;
use crate::relation;
use crate::relation::spatial::Empty;
use crate::relation::spatial::algebra::{Columns, cross, dot, is_finite, zero};
use crate::release::{Release, Way};
use crate::scalar::{Real, Scalar};
use crate::space::{self, MovingBody, MovingJoint, Orientation};
use nalgebra::Vector3;

/// Orientation of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn<T> {
    /// The body's axes in inertial axes.
    pub attitude: Columns<T>,
    /// Angular velocity (rad/s), inertial axes.
    pub spin: Vector3<T>,
}

impl<T: Scalar> Orientation<Vector3<T>> for Turn<T> {
    #[inline(always)]
    fn unturned() -> Self {
        Self { attitude: Columns::identity(), spin: zero() }
    }
    fn at_rest(&self) -> Self {
        Self { spin: zero(), ..*self }
    }
    #[inline(always)]
    fn spin(&self) -> Vector3<T> {
        self.spin
    }
    fn all_finite(&self) -> bool {
        let Columns { x, y, z } = self.attitude;
        [x, y, z, self.spin].into_iter().all(is_finite)
    }
}

/// Acceleration of a station.
pub type Acceleration<T> = relation::Acceleration<Vector3<T>, Vector3<T>>;

/// Motion of a station: a point of a body.
pub type Frame<T> = space::Frame<Vector3<T>, Vector3<T>, Turn<T>>;

/// Internal force q (N) and torque m (N·m) at a station: ON a body they act as +q, −m at its inboard and −q, +m at its outboard end.
pub type Internal<T> = relation::Wrench<Vector3<T>, Vector3<T>>;

/// A body and its motion at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyMotion<T> {
    /// Motion of the body's inboard end.
    pub inboard: Frame<T>,
    /// From the inboard to the outboard end (m), inertial axes.
    pub arm: Vector3<T>,
    /// From the inboard end to the mass centre (m), inertial axes.
    pub to_centre: Vector3<T>,
    /// Mass, mass centre and moments of inertia.
    pub inertia: Inertia<T>,
}

impl<T: Scalar> BodyMotion<T> {
    /// Attitude.
    pub fn attitude(&self) -> Rotation<T> {
        Rotation::from_matrix(&self.inboard.turn.attitude)
    }
    /// Angular velocity (rad/s), body axes.
    pub fn rate(&self) -> [T; 3] {
        self.inboard.turn.attitude.transposed(self.inboard.turn.spin).into()
    }
    /// Angular acceleration (rad/s²), body axes.
    pub fn angular_acceleration(&self) -> [T; 3] {
        self.inboard.turn.attitude.transposed(self.inboard.acceleration.angular).into()
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
    pub fn point(&self, at: [T; 3]) -> Frame<T> {
        self.inboard.shifted(self.turned(at))
    }
    /// A vector of body axes in inertial axes.
    pub fn turned(&self, vector: [T; 3]) -> Vector3<T> {
        self.inboard.turn.attitude.apply(Vector3::from(vector))
    }
    /// Angular momentum about the mass centre (kg·m²/s), inertial axes.
    pub fn spin_momentum(&self) -> Vector3<T> {
        let turn = self.inboard.turn;
        turn.attitude.apply(self.inertia.matrix().apply(turn.attitude.transposed(turn.spin)))
    }
    /// Kinetic energy (J).
    pub fn kinetic_energy(&self) -> T {
        let velocity = self.centre().velocity;
        let spinning = dot(self.inboard.turn.spin, self.spin_momentum());
        (self.inertia.mass * dot(velocity, velocity) + spinning).scale(T::Real::of(0.5))
    }
}

/// A joint and its motion at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointMotion<T> {
    /// Motion of the joint's inboard side.
    pub inboard: Frame<T>,
    /// Motion of the joint's outboard side.
    pub outboard: Frame<T>,
    /// Coordinates of the joint: angles (rad) and slides (m), as many as it has; of an elastic hinge its rotation vector (rad), while
    /// its displacement lies between the frames; none of a ball, whose attitudes stand in the frames.
    pub position: [T; 3],
    /// Rates of the coordinates; of a ball or an elastic hinge the relative angular velocity (rad/s) in axes of the outboard body.
    pub rate: [T; 3],
    /// What the joint's springs and dampers exert on its coordinates (N·m, N), ON the outboard body; in a ball a torque in axes of that
    /// body.
    pub effort: [T; 3],
    /// Energy stored in the joint's springs (J).
    pub energy: T,
    /// Reflected inertia of the joint's coordinates (kg·m², kg), where there is any.
    pub inertia: [T; 3],
}

impl<T: Scalar> JointMotion<T> {
    /// Attitude of the outboard body relative to the inboard one.
    pub fn relative(&self) -> Rotation<T> {
        let of = |frame: &Frame<T>| Rotation::from_matrix(&frame.turn.attitude);
        of(&self.outboard).relative_to(&of(&self.inboard))
    }
}

impl<T: Scalar> Space for Spatial<T> {
    const PLACES: usize = 3;

    /// Nothing: bodies form their postures while they are oriented.
    type Size = ();
    /// Axes of a body that needs them; for a joint its axes and its arm.
    type X = Columns<T>;
    /// Angular velocity of a body, or what follows from it; for a joint the linear and angular acceleration that rates alone cause.
    type Y = [Vector3<T>; 2];
    /// Arm of a body.
    type P = Vector3<T>;
    /// Centripetal acceleration of a body's outboard end.
    type Q = Vector3<T>;
    type Turn = Turn<T>;
    type Station = Station<T>;
    type Angles = [T; 3];
    type BodyMotion = BodyMotion<T>;
    type JointMotion = JointMotion<T>;
    type Numbers = [T; 6];
    type Nothing = Empty;

    fn blank() -> (Columns<T>, [Vector3<T>; 2], Vector3<T>, Vector3<T>) {
        (Columns::identity(), [zero(); 2], zero(), zero())
    }
    fn no_size() {}
    const TURNS_ABOUT_LINES: bool = true;
    #[inline(always)]
    fn numbers(Internal { force: q, torque: m }: Internal<T>) -> [T; 6] {
        [q.x, q.y, q.z, m.x, m.y, m.z]
    }
    #[inline(always)]
    fn internal([a, b, c, d, e, f]: [T; 6]) -> Internal<T> {
        Internal { force: Vector3::new(a, b, c), torque: Vector3::new(d, e, f) }
    }
}

impl<T: Scalar> MovingBody<Spatial<T>> for BodyMotion<T> {
    fn mass(&self) -> T {
        self.inertia.mass
    }
    fn doubt(&self) -> Option<Fault> {
        self.inertia.doubt()
    }
    fn spins_about_its_line(&self) -> bool {
        let line = self.inboard.turn.attitude.transposed(self.arm);
        let inertia = self.inertia.about_inboard();
        let length = dot(line, line);
        let whole = (inertia.xx + inertia.yy + inertia.zz) * length;
        let resists = dot(line, inertia.apply(line)) - whole.scale(T::Real::EPSILON * T::Real::of(0.25));
        let spins = (-resists).if_negative(T::zero(), T::one());
        (-length).if_negative(spins, T::zero()).real() > T::Real::of(0.0)
    }
    fn angles(&self) -> [T; 3] {
        super::angles::angles(&self.inboard.turn.attitude)
    }
    fn angle_out_of_range(&self) -> Option<f64> {
        None // attitudes are quaternions
    }
    #[inline(always)]
    fn in_own_axes(&self, load: Internal<T>) -> Internal<T> {
        let attitude = &self.inboard.turn.attitude;
        Internal { force: attitude.transposed(load.force), torque: attitude.transposed(load.torque) }
    }
    fn budget(&self, gravity: Vector3<T>) -> Budget<Spatial<T>> {
        let centre = self.centre();
        let momentum = centre.velocity * self.inertia.mass;
        Budget {
            kinetic: self.kinetic_energy(),
            potential: -(dot(gravity, centre.place) * self.inertia.mass),
            momentum,
            angular_momentum: cross(centre.place, momentum) + self.spin_momentum(),
        }
    }
}

impl<T: Scalar> MovingJoint<Spatial<T>> for JointMotion<T> {
    fn turn_out_of_range(&self, release: &Release<Spatial<T>>) -> Option<f64> {
        let coordinates = release.coordinates.iter().flatten().filter(|freedom| freedom.driven).zip(self.position);
        let mut turns = coordinates.filter(|(freedom, _)| freedom.way == Way::Turn).map(|(_, angle)| angle.real());
        turns.find(|angle| angle.abs() > T::ANGLE_RANGE).map(Real::as_f64)
    }
    fn stored(&self) -> [T; 2] {
        let twice = self.inertia.iter().zip(self.rate).fold(T::zero(), |sum, (inertia, v)| sum + *inertia * v * v);
        [twice.scale(T::Real::of(0.5)), self.energy]
    }
}

impl<T: Scalar, U: Scalar> SpaceOver<U> for Spatial<T> {
    type Over = Spatial<U>;
    fn lift_vector(vector: Vector3<T>, number: &mut impl FnMut(T) -> U) -> Vector3<U> {
        vector.map(number)
    }
}
