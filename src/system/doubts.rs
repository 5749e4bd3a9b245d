//! Bodies of a scene whose inertia may be wrong.

use super::{System, coordinates};
use crate::element::{Element, Space};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::observe::doubts;

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Tells which bodies have an inertia that no distribution of mass has, where and what is wrong:
    /// [`ImpossibleInertia`](crate::Fault::ImpossibleInertia) in space, and also in the plane [`NotPositive`](crate::Fault::NotPositive)
    /// for a moment of inertia without mass. Robot description files are full of them. The motion of such a scene is well defined;
    /// whether it is meant is for the user to say, and [`repaired`](crate::spatial::RigidBody::repaired) finds the nearest inertia that
    /// there is.
    ///
    /// ```
    /// use catena::spatial::*;
    /// let tensor = |x| [[x, 0.0, 0.0], [0.0, 0.012, 0.0], [0.0, 0.0, 0.004]];
    /// let link = |x| RigidBody::new(0.8, tensor(x), [0.05, 0.0, 0.0], [0.1, 0.0, 0.0]);
    /// let hinge = Revolute::about([0.0, 0.0, 1.0]);
    /// let arm = System::new(Clamped::origin(), (hinge, link(0.0155), hinge, link(0.0161)), Free)?;
    /// arm.doubts(|doubt| println!("{doubt}")); // no body has these moments of inertia: … at station 3
    /// let arm = System::new(Clamped::origin(), (hinge, link(0.0155), hinge, link(0.0161).repaired()), Free)?;
    /// arm.doubts(|_| unreachable!());
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn doubts(&self, report: impl FnMut(Error)) {
        let motion = self.motion();
        doubts(&self.chain, self.root.ground(motion.time), coordinates(&motion), report);
    }
}
