//! What a planar body has to say of itself, and how that makes it an element.

use super::{Acceleration, BodyMotion, Frame, Planar, Turn};
use crate::counts::Counted;
use crate::element::{Condense, Element, Given, OnBody, Posture, Sweep};
use crate::error::Fault;
use crate::error::checks::{finite, not_negative};
use crate::lift::lift;
use crate::relation::Term;
use crate::relation::planar::{Full, Relation};
use crate::scalar::{Real, Scalar};
use crate::shape::{PerAxes, PostureOf, Shape};
use core::fmt::Debug;
use nalgebra::Vector2;
use typenum::{U0, U1};

/// Mass, mass centre and moment of inertia of a planar body.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Inertia<T> {
    /// Mass (kg).
    pub mass: T,
    /// Mass centre from the inboard end (m), body axes.
    pub centre: [T; 2],
    /// Moment of inertia about the mass centre (kg·m²).
    pub about_centre: T,
}

impl<T: Scalar> Inertia<T> {
    /// Rejects negative or non-finite values. A body without mass is allowed: its joint tells if it is needed.
    pub fn check(&self) -> Result<(), Fault> {
        let Self { mass, centre, about_centre } = self;
        not_negative("mass", *mass)?;
        finite("mass centre", centre)?;
        // The moment of inertia may have been rounded when a body was built from its base parameters.
        let scale = *mass * (centre[0] * centre[0] + centre[1] * centre[1]);
        let slack = scale.scale(T::Real::EPSILON * T::Real::of(8.0));
        match not_negative("moment of inertia", *about_centre) {
            Err(Fault::Negative { .. }) if not_negative("", *about_centre + slack).is_ok() => Ok(()),
            checked => checked,
        }
    }

    /// What may be wrong with an inertia that a sweep can do with: a moment of inertia without mass.
    pub fn doubt(&self) -> Option<Fault> {
        let idle = (-self.mass).if_negative(T::zero(), self.about_centre.abs());
        let value = self.mass.if_negative(self.mass, T::zero()).real().as_f64();
        (idle.real() > T::Real::of(0.0)).then_some(Fault::NotPositive { parameter: "mass", value })
    }
}

/// A rigid body in the plane, between an inboard end I (the origin of its axes) and an outboard end O.
///
/// With these methods a type is a body; the macro `body!` in this file, which is not exported, makes it an element.
pub trait Body<T: Scalar>: Copy + Debug + 'static {
    /// Mass, mass centre and moment of inertia of the body.
    fn inertia(&self) -> Inertia<T>;

    /// O (m), body axes.
    fn outboard(&self) -> [T; 2];

    /// Takes the point mass that its outboard neighbour lumps at O, hands on its own at I.
    fn lump(&mut self, mass: T) -> T;

    /// What `pose` reads of the body's shape.
    fn size(&self) -> T;

    /// What the walks read of a body of a size at an angle (rad), turning with −ω² (rad²/s²).
    fn pose(size: T, angle: T, minus_spin2: T) -> Pose<T>;

    /// From I to O (m), inertial axes, and the centripetal acceleration of O (m/s²).
    fn arm(&self, pose: Pose<T>) -> [Vector2<T>; 2];

    /// What a sweep reads of the body's parameters.
    fn base(&self) -> Base<T>;

    /// Direction of the body's axes.
    fn direction(&self, pose: Pose<T>) -> Vector2<T>;

    /// Whether the body may have a first moment: all other bodies have none.
    const MOMENT: bool = false;

    /// Condenses the relation at O to one at I, without the point mass at I, with that at O.
    fn condense<R: Relation<Planar<T>>>(&self, outer: R, pose: Pose<T>) -> Full<T, R::Closures>;

    /// Rejects parameters that make no mechanics.
    fn check(&self) -> Result<(), Fault>;
}

/// What a sweep reads of a body's parameters, in body axes: the base parameters of its dynamics. Its point mass at the inboard end
/// counts as its inboard neighbour's.
#[derive(Clone, Copy, Debug)]
pub struct Base<T> {
    /// O (m).
    pub outboard: [T; 2],
    /// First moment about I (kg·m) of what is not lumped at the ends.
    pub moment: [T; 2],
    /// Moment of inertia about I of that (kg·m²).
    pub inertia: T,
    /// Point mass at O (kg), with what the outboard neighbour lumps there.
    pub lumped: T,
}

/// What the walks read of the orientation and angular velocity of a body: four numbers that each type of body chooses for
/// itself.
#[derive(Clone, Copy, Debug)]
pub struct Pose<T> {
    /// Of a rod: x of the arm (m).
    pub x: T,
    /// Of a rod: y of the arm (m).
    pub y: T,
    /// Of a rod: x of the centripetal acceleration of its outboard end (m/s²).
    pub p: T,
    /// Of a rod: y of that acceleration (m/s²).
    pub q: T,
}

impl<T: Scalar> Pose<T> {
    /// The pose of a straight link of a length (m) along the body's x axis: its arm d and the centripetal acceleration −ω² d.
    #[cfg_attr(optimised, inline(always))]
    pub fn of_link(length: T, angle: T, minus_spin2: T) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let (x, y) = (length * cosine, length * sine);
        Self { x, y, p: minus_spin2 * x, q: minus_spin2 * y }
    }

    #[inline(always)]
    pub(super) fn of<E: Shape<Planar<T>, Store<PerAxes<T>> = T>>(posture: Posture<'_, Planar<T>, E>) -> Self {
        Self { x: *posture.x, y: *posture.y, p: *posture.p, q: *posture.q }
    }

    /// Arm and centripetal acceleration of a straight link.
    #[inline(always)]
    pub fn link(self) -> [Vector2<T>; 2] {
        [Vector2::new(self.x, self.y), Vector2::new(self.p, self.q)]
    }
}

/// The motion of a body whose inboard end moves with `inboard`.
#[cfg_attr(optimised, inline(always))]
pub(super) fn body_motion<T: Scalar, B: Body<T>>(body: &B, inboard: Frame<T>) -> BodyMotion<T> {
    let (sine, cosine) = inboard.turn.angle.sin_cos();
    body_along(body, inboard, Vector2::new(cosine, sine))
}

/// The motion of a body whose axes have a direction.
#[cfg_attr(optimised, inline(always))]
fn body_along<T: Scalar, B: Body<T>>(body: &B, inboard: Frame<T>, direction: Vector2<T>) -> BodyMotion<T> {
    let inertia = body.inertia();
    let zero = Vector2::new(T::zero(), T::zero());
    let motion = BodyMotion { inboard, arm: zero, to_centre: zero, direction, inertia };
    BodyMotion { arm: motion.turned(body.outboard()), to_centre: motion.turned(inertia.centre), ..motion }
}

impl<T: Scalar, B: Body<T>> crate::shape::Body<Planar<T>> for B {
    fn size(&self) -> T {
        Body::size(self)
    }
    #[inline(always)]
    fn shifted(&self, inboard: Acceleration<T>, (&x, &y, &p, &q): PostureOf<'_, Planar<T>>) -> Acceleration<T> {
        let [arm, centripetal] = self.arm(Pose { x, y, p, q });
        inboard.shifted(arm, centripetal)
    }
    #[inline(always)]
    fn swung(&self, inboard: Acceleration<T>, (&x, &y, &p, &q): PostureOf<'_, Planar<T>>) -> Acceleration<T> {
        inboard.swung(self.arm(Pose { x, y, p, q })[0])
    }
    #[inline(always)]
    fn motion(&self, inboard: Frame<T>) -> (BodyMotion<T>, Frame<T>) {
        let motion = body_motion(self, inboard);
        (motion, motion.outboard())
    }
    #[inline(always)]
    fn posed(&self, inboard: Frame<T>, (&x, &y, &p, &q): PostureOf<'_, Planar<T>>) -> (BodyMotion<T>, Frame<T>) {
        let motion = body_along(self, inboard, self.direction(Pose { x, y, p, q }));
        (motion, motion.outboard())
    }
    fn check(&self) -> Result<(), Fault> {
        Body::check(self)
    }
}

/// Makes planar bodies elements.
macro_rules! body {
    ($($Body:ident),*) => {$(
        crate::shape::leaf!(body [T: Scalar] super::$Body<T>: Planar<T>);

        impl<T: Scalar> super::$Body<T> {
            /// Mass, mass centre and moment of inertia.
            #[inline(always)]
            pub fn inertia(&self) -> Inertia<T> {
                Body::inertia(self)
            }
            /// From its inboard to its outboard end (m), body axes.
            #[inline(always)]
            pub fn outboard(&self) -> [T; 2] {
                Body::outboard(self)
            }
        }

        impl<T: Scalar> Element<Planar<T>> for super::$Body<T> {
            type Position = ();
            type Rate = ();

            const ABSOLUTE: bool = false;

            fn lump(&mut self, mass: T) -> T {
                Body::lump(self, mass)
            }
            #[cfg_attr(optimised, inline(always))]
            fn orient(
                &self,
                _: &(),
                _: &(),
                turn: Turn<T>,
                x: &mut T,
                y: &mut T,
                _: &mut T,
                _: &mut T,
            ) -> Turn<T> {
                *x = turn.angle;
                *y = turn.rate;
                turn
            }
            #[cfg_attr(optimised, inline(always))]
            fn resolve(size: &T, x: &mut T, y: &mut T, p: &mut T, q: &mut T) {
                // The square is left to this pass, which goes many bodies at a time where rates add up along the chain.
                let pose = <Self as Body<T>>::pose(*size, *x, -(*y * *y));
                (*x, *y, *p, *q) = (pose.x, pose.y, pose.p, pose.q);
            }
        }

        impl<T> Counted for super::$Body<T> {
            type Bodies = U1;
            type Freedoms = U0;
        }

        impl<T: Scalar, R: Relation<Planar<T>>, W: Sweep<Planar<T>>> Condense<Planar<T>, R, W> for super::$Body<T>
        where
            OnBody<Planar<T>, W>: Term<Full<T, R::Closures>>,
        {
            type Out = Full<T, R::Closures>;

            #[cfg_attr(optimised, inline(always))]
            fn condense(
                &self,
                outer: R,
                posture: Posture<'_, Planar<T>, Self>,
                given: Given<'_, Planar<T>, Self, W>,
                _: &mut (),
            ) -> Full<T, R::Closures> {
                given.on_bodies.take_from(Body::condense(self, outer, Pose::of(posture)))
            }
        }
    )*};
}
body!(Rod, RigidBody, PointMass);

lift!(Inertia { mass, centre, about_centre });
