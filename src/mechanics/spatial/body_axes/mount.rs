//! The way from inertial axes to those of bodies.

use super::relation::{Borne, Local, Settled};
use super::tilted::Tilted;
use crate::counts::Counted;
use crate::element::{Condense, Element, Given, Posture, Springs, Sweep};
use crate::ends::{Held, Root};
use crate::error::checks::finite;
use crate::error::{Error, Fault, Place};
use crate::lift::lift;
use crate::mechanics::spatial::{Acceleration, Frame, JointMotion, Spatial, Turn};
use crate::relation::Closures;
use crate::relation::spatial::algebra::Columns;
use crate::release::Release;
use crate::scalar::Scalar;
use crate::shape::{Joint, JointPosture};
use nalgebra::Vector3;
use typenum::U0;

/// From here on outward, relations and accelerations are in axes of bodies: what comes first in the chain of a robot, and where a robot
/// stands on bodies of [`spatial`](crate::spatial). It holds what follows fast: a [`Hinge`](super::Hinge) or a [`Slide`](super::Slide) on
/// it sits on the ground (or the body inboard), a [`Link`](super::Link) is the ground's (or moves with the root `Free`: a floating base).
///
/// ```
/// use catena::robot::*;
/// let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
/// let arm = (BodyAxes, Hinge::level(), link, Hinge::at::<4>([0.0, 0.0, 0.4]).turned(Quarter::<30>), link);
/// let fixed = System::new(Clamped::origin(), arm, Free)?;
/// let legs = [Branch((Hinge::at::<7>([0.3, 0.2, -0.1]), link)), Branch((Hinge::at::<7>([-0.3, 0.2, -0.1]), link))];
/// let floating = System::new(Free, (BodyAxes, link, legs), Free)?;
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct BodyAxes;

/// The joint of a [`Base`], whose axes are inertial ones.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Upright;

/// Makes what leads into body axes a joint: from axes that are turned anyhow, or from those of a base that are the same.
macro_rules! mount {
    ($Mount:ident, $upright:literal) => {
        crate::shape::leaf!(joint [T: Scalar] $Mount: Spatial<T>);

        impl<T: Scalar> Joint<Spatial<T>> for $Mount {
            type Position = ();
            type Rate = ();
            type Kept<C: Closures> = ();
            type Per<X: Copy> = X;

            const LINEAR: bool = true;

            fn still() -> ((), ()) {
                ((), ())
            }
            fn kept<C: Closures>() {}
            fn per<X: Copy>(fill: X) -> X {
                fill
            }
            fn is_finite<C: Closures>((): &()) -> bool {
                true
            }
            fn configure(&self, (): &mut (), inboard: Turn<T>, _: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
                inboard
            }
            #[cfg_attr(optimised, inline(always))]
            fn recover<C: Closures, By: Springs<T>>(
                &self,
                inboard: Acceleration<T>,
                posture: JointPosture<'_, Spatial<T>, Self>,
                (): &mut (),
                multipliers: &C::Each<T>,
                (): &mut (),
            ) -> Acceleration<T> {
                self.respond::<C>(inboard, posture, &(), multipliers, &mut ())
            }
            #[cfg_attr(optimised, inline(always))]
            fn respond<C: Closures>(
                &self,
                Acceleration { linear, angular }: Acceleration<T>,
                (attitude, _, _, _): JointPosture<'_, Spatial<T>, Self>,
                (): &(),
                _: &C::Each<T>,
                (): &mut (),
            ) -> Acceleration<T> {
                if const { $upright } {
                    return Acceleration { linear, angular };
                }
                Acceleration { linear: attitude.transposed(linear), angular: attitude.transposed(angular) }
            }
            fn motion(&self, inboard: Frame<T>, (): &(), (): &(), (): &()) -> (JointMotion<T>, Frame<T>) {
                let none = [T::zero(); 3];
                let (outboard, energy) = (inboard, T::zero());
                (JointMotion { inboard, outboard, position: none, rate: none, effort: none, energy, inertia: none }, inboard)
            }
            fn release(&self, _: &JointMotion<T>, (): &(), (): &()) -> Release<Spatial<T>> {
                Release::nothing()
            }
            fn check(&self) -> Result<(), Fault> {
                Ok(())
            }
        }

        impl<T: Scalar> Element<Spatial<T>> for $Mount {
            type Position = ();
            type Rate = ();

            const ABSOLUTE: bool = false;

            fn lump(&mut self, mass: T) -> T {
                mass
            }
            #[inline(always)]
            fn turned(&self, (): &(), (): &(), turn: Turn<T>) -> Turn<T> {
                if const { $upright } { turn } else { Turn { spin: turn.attitude.transposed(turn.spin), ..turn } }
            }
            #[cfg_attr(optimised, inline(always))]
            fn orient(
                &self,
                (): &(),
                (): &(),
                turn: Turn<T>,
                x: &mut Columns<T>,
                _: &mut [Vector3<T>; 2],
                _: &mut Vector3<T>,
                _: &mut Vector3<T>,
            ) -> Turn<T> {
                if const { $upright } {
                    return turn;
                }
                *x = turn.attitude;
                Turn { spin: turn.attitude.transposed(turn.spin), ..turn }
            }
            #[inline(always)]
            fn resolve((): &(), _: &mut Columns<T>, _: &mut [Vector3<T>; 2], _: &mut Vector3<T>, _: &mut Vector3<T>) {}
        }

        impl Counted for $Mount {
            type Bodies = U0;
            type Freedoms = U0;
        }
        lift!($Mount);
    };
}
mount!(BodyAxes, false);
mount!(Upright, true);

impl<T: Scalar, Q: Closures, W: Sweep<Spatial<T>>> Condense<Spatial<T>, Local<T, Q>, W> for BodyAxes {
    type Out = Tilted<T, Q>;

    #[inline(always)]
    fn condense(
        &self,
        outer: Local<T, Q>,
        posture: Posture<'_, Spatial<T>, Self>,
        _: Given<'_, Spatial<T>, Self, W>,
        (): &mut (),
    ) -> Tilted<T, Q> {
        Tilted::new(outer, *posture.x)
    }
}

impl<T: Scalar, Q: Closures, W: Sweep<Spatial<T>>> Condense<Spatial<T>, Borne<T, Q>, W> for BodyAxes {
    type Out = Settled<T, Q>;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: Borne<T, Q>,
        posture: Posture<'_, Spatial<T>, Self>,
        _: Given<'_, Spatial<T>, Self, W>,
        (): &mut (),
    ) -> Settled<T, Q> {
        outer.settled(posture.x)
    }
}

/// On a base alone: what it hands on is nothing that a joint of inertial axes takes, for whose axes may be turned.
macro_rules! upright {
    ($($Outer:ident: |$outer:ident| $bear:expr),*) => {$(
        impl<T: Scalar, Q: Closures, W: Sweep<Spatial<T>>> Condense<Spatial<T>, $Outer<T, Q>, W> for Upright {
            type Out = Borne<T, Q>;

            #[cfg_attr(optimised, inline(always))]
            fn condense(
                &self,
                $outer: $Outer<T, Q>,
                _: Posture<'_, Spatial<T>, Self>,
                _: Given<'_, Spatial<T>, Self, W>,
                (): &mut (),
            ) -> Borne<T, Q> {
                $bear
            }
        }
    )*};
}
upright!(Local: |outer| Borne::of(|| outer), Borne: |outer| outer);

/// The base of a robot, fixed to the ground: its axes are inertial ones, and the robot begins there, without [`BodyAxes`]. A base that
/// is tilted is [`Clamped`](crate::spatial::Clamped) at a place and an attitude, with [`BodyAxes`] first in the chain:
///
/// ```
/// use catena::robot::*;
/// let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
/// let arm = System::new(Base::at([0.0, 0.0, 1.0]), (Hinge::level().grounded(), link), Free)?;
///
/// let wall = Clamped::at([0.0, 0.0, 1.0], Rotation::from_angles([std::f64::consts::FRAC_PI_2, 0.0, 0.0]));
/// let on_a_wall = System::new(wall, (BodyAxes, Hinge::level().grounded(), link), Free)?;
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Base<T> {
    /// Where the robot begins (m).
    pub place: [T; 3],
}

impl<T: Scalar> Base<T> {
    /// At the origin.
    pub fn origin() -> Self {
        Self::at([T::zero(); 3])
    }
    /// At a place (m).
    pub fn at(place: [T; 3]) -> Self {
        Self { place }
    }
}

impl<T: Scalar> Root<Spatial<T>> for Base<T> {
    type Pairs = (Held, Held, Held, Held, Held, Held);
    type Joint = Upright;

    const RESTS: bool = true;

    fn joint(&self) -> Upright {
        Upright
    }
    #[inline(always)]
    fn ground(&self, _: T::Real) -> Frame<T> {
        Frame::resting(Vector3::from(self.place))
    }
    fn check(&self) -> Result<(), Error> {
        finite("place of the base", &self.place).map_err(|fault| Error::new(fault).at(Place::Root))
    }
}

lift!(Base { place });
