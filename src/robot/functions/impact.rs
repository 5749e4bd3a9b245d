//! Impacts of joints against hard stops.

use super::{Afloat, FixedBase, S, Tasks, finite};
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mechanics::spatial::Free;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use nalgebra::Vector3;

/// Refuses a restitution outside of 0 to 1.
pub(super) fn restitutes<T: Scalar>(restitution: T) -> Result<(), Error> {
    // Of lanes any that is not.
    let (low, high) = (restitution, T::one() - restitution);
    let each = [low.if_negative(low, T::zero()), high.if_negative(restitution, T::zero()), restitution];
    match each.map(|x| x.real().as_f64()).into_iter().find(|x| !(0.0..=1.0).contains(x)) {
        Some(value) => {
            let (parameter, outside) = ("restitution", "a stop would pull, or give energy");
            Err(Error::new(Fault::OutOfRange { parameter, value, least: 0.0, most: 1.0, outside }))
        }
        None => Ok(()),
    }
}

/// A one for the joint that strikes a stop.
fn struck<T: Scalar, const N: usize>(joint: usize, restitution: T) -> Result<[T; N], Error> {
    restitutes(restitution)?;
    let mut unit = [T::zero(); N];
    *unit.get_mut(joint).ok_or_else(|| Error::new(Fault::NoSuchJoint { joint, joints: N }))? = T::one();
    Ok(unit)
}

impl<T: Scalar, R: Root<S<T>>, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, R, C, P> {
    /// The rates after joint `joint` has struck a hard stop, and the impulse of the stop (N·m·s, N·s): the rate v of the joint becomes −e v by
    /// Newton's law of restitution e, the others follow by M⁻¹. Energy falls for e below one. Which of its stops it is nobody asks: a joint that
    /// leaves one would be turned back.
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
        let unit = struck(joint, restitution)?;
        let column = self.mass_solved(q, &unit)?;
        let impulse = -(T::one() + restitution) * v[joint] / column[joint];
        let after = core::array::from_fn(|k| column[k].mul_add(impulse, v[k]));
        finite(&after).map(|()| (after, impulse))
    }
}

impl<T: Scalar, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, Free, C, P> {
    /// How the base and the joints of a robot whose base floats move after joint `joint` has struck a hard stop, and the impulse of the stop
    /// (N·m·s, N·s), as [`impact`](Self::impact) has them: momentum and angular momentum stay, for the stop acts between two links.
    ///
    /// # Errors
    /// As [`impact`](Self::impact); [`Fault::NotZero`] for an attitude of the base that is none.
    pub fn impact_afloat<const N: usize>(
        &self,
        base: Afloat<T>,
        q: &[T; N],
        v: &[T; N],
        joint: usize,
        restitution: T,
    ) -> Result<(Afloat<T>, [T; N], T), Error>
    where
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        let unit = struck(joint, restitution)?;
        let (of_base, column) = self.mass_solved_afloat(base.place, q, &[T::zero(); 6], &unit)?;
        let impulse = -(T::one() + restitution) * v[joint] / column[joint];
        let after = core::array::from_fn(|k| column[k].mul_add(impulse, v[k]));
        let [x, y, z, a, b, c] = of_base.map(|of_base| of_base * impulse);
        let velocity = base.velocity + Vector3::new(x, y, z);
        let base = Afloat { velocity, spin: base.spin + Vector3::new(a, b, c), ..base };
        let of_base = finite(base.velocity.as_slice()).and(finite(base.spin.as_slice()));
        of_base.and(finite(&after)).map(|()| (base, after, impulse))
    }
}
