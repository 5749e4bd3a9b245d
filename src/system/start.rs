//! Initial motions from angles of joints in the plane.

use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::{Error, counted, ensure_finite};
use crate::mechanics::planar::{Planar, Turn};
use crate::mirror::Position;
use crate::scalar::{Real, Scalar};
use crate::system::{MotionOf, System};
use crate::walks::configure::configure;
use num_traits::One;

/// A planar scene's motion.
type PlaneMotion<T, R, C, P> = MotionOf<Planar<T>, R, C, P>;

/// Hands out numbers in turn, and counts how many were asked for.
pub(super) struct Feed<'a, T> {
    numbers: &'a [T],
    asked: usize,
}

impl<'a, T: Scalar> Feed<'a, T> {
    pub(super) fn of(numbers: &'a [T]) -> Self {
        Self { numbers, asked: 0 }
    }

    pub(super) fn next(&mut self) -> T {
        self.asked += 1;
        self.numbers.get(self.asked - 1).copied().unwrap_or(T::zero())
    }

    pub(super) fn check(&self, list: &'static str, parameter: &'static str) -> Result<(), Error> {
        counted(list, self.asked, self.numbers.len())?;
        ensure_finite(self.numbers.iter().all(|x| x.is_finite()), parameter)
    }
}

impl<T: Scalar, R: Root<Planar<T>>, C: Element<Planar<T>>, P: Tip<Planar<T>>> System<Planar<T>, R, C, P> {
    /// A motion at rest with these joint angles (rad): one number for each rotary coordinate, root to tip, the angle of the body
    /// outboard of the joint relative to the one inboard of it (for the root's joint, relative to the ground).
    ///
    /// A hinge with a spring gets its angle to the last digit. Angles of welds are parameters, and not among the numbers.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let arm = System::new(Pinned::origin(), (rod, Weld::at(0.5), rod, Pin, rod), Free)?;
    /// let start = arm.at_joint_angles(&[0.25, -1.0])?;
    /// assert_eq!(start, arm.at_rest(&[0.25, -0.25])?);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::Count`](crate::Fault::Count) when there are more or fewer numbers than rotary coordinates,
    /// [`Fault::NotFinite`](crate::Fault::NotFinite).
    pub fn at_joint_angles(&self, angles: &[T]) -> Result<PlaneMotion<T, R, C, P>, Error> {
        let mut motion = self.motion();
        let ground = self.ground(motion.time);
        let chain = self.elements();
        // What is no angle is marked, to be left alone.
        let mark = T::constant(T::Real::INFINITY);
        motion.position.replace(&mut |_| mark);
        let (mut feed, mut largest) = (Feed::of(angles), T::Real::one());
        configure(chain, &mut motion.position, ground.turn, &mut |inboard: Turn<T>| {
            let absolute = inboard.angle + feed.next();
            largest = largest.max(absolute.real().abs());
            absolute
        });
        feed.check("joint angles", "joint angle")?;
        // A relative coordinate was found as a difference of absolute angles: the number given has the digits lost there. An absolute one
        // may be that number, too, and has derivatives by those inboard: of the miss a large number swallows the value, in each lane, alone.
        let lost = largest * T::Real::EPSILON * T::Real::of(4.0);
        let large = T::constant(largest * T::Real::of(64.0));
        let mut feed = Feed::of(angles);
        motion.position.replace(&mut |x| {
            if !x.real().is_finite() {
                return T::zero();
            }
            let angle = feed.next();
            let miss = x - angle;
            if miss.real().abs() <= lost { angle + ((miss + large) - large) } else { x }
        });
        Ok(motion)
    }
}
