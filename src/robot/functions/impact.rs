//! Impacts of joints against hard stops.

use super::{FixedBase, S, Tasks, finite};
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::System;

impl<T: Scalar, R: Root<S<T>>, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, R, C, P> {
    /// The rates after joint `joint` has struck a hard stop, and the impulse of the stop (N·m·s, N·s): the rate v of the joint becomes −e v by
    /// Newton's law of restitution e, the others follow by M⁻¹. Energy falls for e below one.
    ///
    /// A run that [stops at an event](crate::simulate::Simulation::stopping) where a joint meets its limit, this, and a run that goes on from
    /// there are exact: rules keep their order across. Of several limits the event is the zero of the least distance.
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(3.0, [0.2, 0.0, 0.0], [[0.01, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.05]]);
    /// let chain = (Hinge::level(), link, Hinge::at::<1>([0.4, 0.0, 0.0]), link);
    /// let arm = System::new(Base::origin(), chain, Free)?.with_gravity([0.0, -9.81, 0.0]);
    /// let start = arm.at_joints(&[0.0, 0.5], &[0.0; 2])?;
    /// // The elbow may go from −0.2 to 1 rad.
    /// let distance = |q: &[f64]| (q[1] + 0.2).min(1.0 - q[1]);
    /// let touch = arm.simulation(Dop853::tolerance(1e-10)).event(|now| distance(&now.motion().coordinates())).stopping();
    /// let now = touch.run(start, 2.0, |_| ())?.motion;
    /// let (q, mut v) = ([now.coordinates()[0], now.coordinates()[1]], [0.0; 2]);
    /// now.rates_into(&mut v)?;
    /// let (after, impulse) = arm.impact(&q, &v, 1, 0.5)?;
    /// assert!((after[1] + 0.5 * v[1]).abs() < 1e-12 && impulse * v[1] < 0.0);
    /// assert!(arm.joint_energy(&q, &after)?[0] < arm.joint_energy(&q, &v)?[0]);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::Count`] where `N` is not the number of joints, [`Fault::NoSuchJoint`] where `joint` is no number of one,
    /// [`Fault::OutOfRange`] for a restitution outside of 0 to 1, [`Fault::NonFiniteMotion`] where something came out not finite.
    pub fn impact<const N: usize>(
        &self,
        q: &[T; N],
        v: &[T; N],
        joint: usize,
        restitution: T,
    ) -> Result<([T; N], T), Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        let value = restitution.real().as_f64();
        if !(0.0..=1.0).contains(&value) {
            let (parameter, outside) = ("restitution", "a stop would pull, or give energy");
            return Err(Error::new(Fault::OutOfRange { parameter, value, least: 0.0, most: 1.0, outside }));
        }
        let mut unit = [T::zero(); N];
        let (Some(own), Some(rate)) = (unit.get_mut(joint), v.get(joint)) else {
            return Err(Error::new(Fault::NoSuchJoint { joint, joints: N }));
        };
        *own = T::one();
        let column = self.mass_solved(q, &unit)?;
        let impulse = column.get(joint).map_or(T::zero(), |own| -(T::one() + restitution) * *rate / *own);
        let after = core::array::from_fn(|k| column[k].mul_add(impulse, v[k]));
        finite(&after).map(|()| (after, impulse))
    }
}
