//! What a spatial body has to say of itself, and how that makes it an element.

use super::{Acceleration, BodyMotion, Frame, Inertia, Spatial, Turn};
use crate::counts::Counted;
use crate::element::{Condense, Element, Given, OnBody, Posture, Sweep};
use crate::error::Fault;
use crate::relation::Term;
use crate::relation::spatial::algebra::{Columns, centripetal};
use crate::relation::spatial::{Full, Relation};
use crate::scalar::Scalar;
use crate::shape::{Native, PostureOf};
use core::fmt::Debug;
use nalgebra::Vector3;
use typenum::{U0, U1};

/// A rigid body in space, between an inboard end I (the origin of its axes) and an outboard end O.
///
/// With these methods a type is a body; the macro `body!` in this file, which is not exported, makes it an element.
pub trait Body<T: Scalar>: Copy + Debug + 'static {
    /// Mass, mass centre and inertia tensor of the body.
    fn inertia(&self) -> Inertia<T>;

    /// O (m), body axes.
    fn outboard(&self) -> [T; 3];

    /// Takes the point mass that its outboard neighbour lumps at O, hands on its own at I.
    fn lump(&mut self, mass: T) -> T;

    /// Whether [`condense`](Self::condense) reads the attitude of the pose: if not, it is not stored.
    const AXES: bool;

    /// What an orientation and an angular velocity make of the body.
    fn pose(&self, turn: &Turn<T>) -> Pose<T>;

    /// The relation at I from that at O.
    fn condense<R: Relation<Spatial<T>>>(&self, outer: R, pose: &Pose<T>) -> Full<T, R::Closures>;

    /// Rejects parameters that make no mechanics.
    ///
    /// # Errors
    /// What is wrong with them.
    fn check(&self) -> Result<(), Fault>;
}

/// What the orientation and the angular velocity of a body make of it, in inertial axes: formed on the way outward, read on the way
/// inward.
#[derive(Clone, Copy, Debug)]
pub struct Pose<T> {
    /// The body's axes.
    pub attitude: Columns<T>,
    /// Angular velocity ω (rad/s), or what else a body needs of it: a rod its gyroscopic torque (N·m).
    pub turning: Vector3<T>,
    /// From the inboard to the outboard end, d (m).
    pub arm: Vector3<T>,
    /// ω × (ω × d) (m/s²).
    pub centripetal: Vector3<T>,
}

impl<T: Scalar> Pose<T> {
    /// With the arm d.
    #[inline(always)]
    pub fn with_arm(turn: &Turn<T>, d: Vector3<T>) -> Self {
        Self { attitude: turn.attitude, turning: turn.spin, arm: d, centripetal: centripetal(turn.spin, d) }
    }
}

impl<T: Scalar, B: Body<T> + Native> crate::shape::Body<Spatial<T>> for B {
    fn size(&self) {}
    #[cfg_attr(optimised, inline(always))]
    fn shifted(
        &self,
        inboard: Acceleration<T>,
        (_, _, &arm, &centripetal): PostureOf<'_, Spatial<T>>,
    ) -> Acceleration<T> {
        inboard.shifted(arm, centripetal)
    }
    #[inline(always)]
    fn swung(&self, inboard: Acceleration<T>, (_, _, &arm, _): PostureOf<'_, Spatial<T>>) -> Acceleration<T> {
        inboard.swung(arm)
    }
    #[cfg_attr(optimised, inline(always))]
    fn motion(&self, inboard: Frame<T>) -> (BodyMotion<T>, Frame<T>) {
        let inertia = Body::inertia(self);
        let turned = |at: [T; 3]| inboard.turn.attitude.apply(Vector3::from(at));
        let arm = turned(Body::outboard(self));
        let motion = BodyMotion { inboard, arm, to_centre: turned(inertia.centre), inertia };
        (motion, motion.outboard())
    }
    fn check(&self) -> Result<(), Fault> {
        Body::check(self)
    }
}

/// Makes spatial bodies elements.
macro_rules! body {
    ($($Body:ident),*) => {$(
        crate::shape::leaf!(body [T: Scalar] super::$Body<T>: Spatial<T>);

        impl<T: Scalar> super::$Body<T> {
            /// Mass, mass centre and moment of inertia.
            #[inline(always)]
            pub fn inertia(&self) -> Inertia<T> {
                Body::inertia(self)
            }
            /// From its inboard to its outboard end (m), body axes.
            #[inline(always)]
            pub fn outboard(&self) -> [T; 3] {
                Body::outboard(self)
            }
        }

        impl<T: Scalar> Element<Spatial<T>> for super::$Body<T> {
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
                x: &mut Columns<T>,
                y: &mut [Vector3<T>; 2],
                p: &mut Vector3<T>,
                q: &mut Vector3<T>,
            ) -> Turn<T> {
                let pose = Body::pose(self, &turn);
                if <Self as Body<T>>::AXES {
                    *x = pose.attitude;
                }
                (y[0], *p, *q) = (pose.turning, pose.arm, pose.centripetal);
                turn
            }
            #[cfg_attr(optimised, inline(always))]
            fn resolve(
                (): &(),
                _: &mut Columns<T>,
                _: &mut [Vector3<T>; 2],
                _: &mut Vector3<T>,
                _: &mut Vector3<T>,
            ) {
            }
        }

        impl<T> Native for super::$Body<T> {}

        impl<T> Counted for super::$Body<T> {
            type Bodies = U1;
            type Freedoms = U0;
        }

        impl<T: Scalar, R: Relation<Spatial<T>>, W: Sweep<Spatial<T>>> Condense<Spatial<T>, R, W> for super::$Body<T>
        where
            OnBody<Spatial<T>, W>: Term<Full<T, R::Closures>>,
        {
            type Out = Full<T, R::Closures>;

            #[cfg_attr(optimised, inline(always))]
            fn condense(
                &self,
                outer: R,
                posture: Posture<'_, Spatial<T>, Self>,
                given: Given<'_, Spatial<T>, Self, W>,
                _: &mut (),
            ) -> Full<T, R::Closures> {
                let pose = Pose { attitude: *posture.x, turning: posture.y[0], arm: *posture.p, centripetal: *posture.q };
                given.on_bodies.take_from(Body::condense(self, outer, &pose))
            }
        }
    )*};
}
body!(Rod, RigidBody, PointMass);
