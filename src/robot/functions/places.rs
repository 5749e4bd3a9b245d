//! Where bodies are and how they move.

use super::{Afloat, FixedBase, S, Tasks, checked, finite, resisting};
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mechanics::spatial::body_axes::places::{Moving, Parents, Places, Tally, Way};
use crate::mechanics::spatial::body_axes::{Place, Stand};
use crate::mechanics::spatial::{Frame, Free};
use crate::relation::spatial::algebra::{cross, dot, zero};
use crate::scalar::{Real, Scalar};
use crate::shape::Takes;
use crate::system::System;
use nalgebra::Vector3;
use num_traits::Zero;

impl<T: Scalar, R: Root<S<T>>, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, R, C, P> {
    /// The base.
    fn standing(&self) -> Place<T> {
        let Frame { place, turn, .. } = self.ground(T::Real::zero());
        Place { place, attitude: turn.attitude }
    }

    fn placed<const N: usize>(&self, q: &[T; N]) -> Places<T, N>
    where
        C: Tasks<T, N>,
    {
        let stands = resisting(self.chain(), q, q).stands;
        let base = self.standing();
        let mut walk = Places { stands, places: [base; N], parents: [usize::MAX; N], slides: [false; N], next: 0 };
        Takes::<S<T>, Places<T, N>>::take(self.chain(), &mut walk, (base, usize::MAX), ());
        walk
    }

    /// Which joints slide.
    pub(super) fn slides<const N: usize>(&self) -> [bool; N]
    where
        C: Tasks<T, N>,
    {
        self.placed(&[T::zero(); N]).slides
    }

    /// Where bodies are, by the joints that carry them.
    ///
    /// # Errors
    /// [`Fault::Count`] where `N` is not the number of joints, [`Fault::NonFiniteMotion`] for numbers that are not finite.
    pub fn places<const N: usize>(&self, q: &[T; N]) -> Result<[Place<T>; N], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        finite(q)?;
        Ok(self.placed(q).places)
    }

    /// The Jacobian of a point (m, axes of its body) of the body on joint `joint` (0 is the first beyond the base): for each joint the velocity (m/s) of the point and the
    /// angular velocity (rad/s) of the body, inertial axes, for a rate of one.
    ///
    /// # Errors
    /// [`Fault::Count`] where `N` is not the number of joints, [`Fault::NoSuchJoint`] where `joint` is no number of one,
    /// [`Fault::NonFiniteMotion`] for numbers that are not finite.
    pub fn jacobian<const N: usize>(&self, q: &[T; N], joint: usize, point: [T; 3]) -> Result<[[T; 6]; N], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        finite(q).and(finite(&point))?;
        if joint >= N {
            return Err(Error::new(Fault::NoSuchJoint { joint, joints: N }));
        }
        let (joints, _) = self.columns(self.standing(), q, joint, point);
        Ok(joints)
    }

    /// The joint inboard of each.
    pub(super) fn parents<const N: usize>(&self) -> [usize; N]
    where
        C: Tasks<T, N>,
    {
        let mut walk = Parents { parents: [usize::MAX; N], next: 0 };
        Takes::<S<T>, Parents<N>>::take(self.chain(), &mut walk, usize::MAX, ());
        walk.parents
    }

    /// Columns of the joints on the way to a body, if it is not the base, and where the point is. Nothing else is found.
    pub(super) fn columns<const N: usize>(
        &self,
        base: Place<T>,
        q: &[T; N],
        joint: usize,
        point: [T; 3],
    ) -> ([[T; 6]; N], Vector3<T>)
    where
        C: Tasks<T, N>,
    {
        let (parents, mut met, mut next) = (self.parents(), [false; N], joint);
        while let Some(own) = met.get_mut(next) {
            *own = true;
            next = parents[next];
        }
        let joints = [[zero(); 2]; N];
        let mut way = Way { positions: *q, met, joints, slides: [false; N], end: base, next: 0 };
        Takes::<S<T>, Way<T, N>>::take(self.chain(), &mut way, base, ());
        let point = way.end.attitude.apply_onto(Vector3::from(point), way.end.place);
        let (mut columns, mut next) = ([[T::zero(); 6]; N], joint);
        while let (Some([place, axis]), Some(column)) = (way.joints.get(next), columns.get_mut(next)) {
            let turning = [cross(*axis, point - *place), *axis];
            let [velocity, spin] = if way.slides[next] { [*axis, zero()] } else { turning };
            *column = [velocity.x, velocity.y, velocity.z, spin.x, spin.y, spin.z];
            next = parents[next];
        }
        (columns, point)
    }

    fn tallied<const N: usize>(&self, base: Moving<T>, stands: [Stand<T>; N], v: &[T; N]) -> Tally<T, N>
    where
        C: Tasks<T, N>,
    {
        let (mass, moment, twice_kinetic) = (T::zero(), zero(), T::zero());
        let mut walk = Tally { stands, rates: *v, mass, moment, twice_kinetic, next: 0 };
        Takes::<S<T>, Tally<T, N>>::take(self.chain(), &mut walk, base, ());
        walk
    }

    /// How the ground of a fixed base moves.
    fn on_ground(&self) -> Moving<T> {
        let Frame { velocity, turn, .. } = self.ground(T::Real::zero());
        let of = |vector: Vector3<T>| turn.attitude.transposed(vector).into();
        (self.standing(), [of(velocity), of(turn.spin)])
    }

    /// Kinetic and potential energy (J) on a base that moves like this.
    fn energies<const N: usize>(&self, base: Moving<T>, q: &[T; N], v: &[T; N]) -> Result<[T; 2], Error>
    where
        C: Tasks<T, N>,
    {
        let own = resisting(self.chain(), q, v);
        let Tally { moment, twice_kinetic, .. } = self.tallied(base, own.stands, v);
        let springs = own.energies.iter().fold(T::zero(), |sum, energy| sum + *energy);
        let energies = [twice_kinetic.scale(T::Real::of(0.5)), springs - dot(self.gravity(), moment)];
        finite(&energies).map(|()| energies)
    }

    /// The mass centre of all links (m), and their mass (kg).
    ///
    /// # Errors
    /// As [`forward_dynamics`](Self::forward_dynamics): links without mass have no centre.
    pub fn mass_centre<const N: usize>(&self, q: &[T; N]) -> Result<(Vector3<T>, T), Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        let Tally { mass, moment, .. } =
            self.tallied(self.on_ground(), resisting(self.chain(), q, q).stands, &[T::zero(); N]);
        let centre = moment * mass.recip();
        finite(centre.as_slice()).map(|()| (centre, mass))
    }

    /// Kinetic energy (J), with that of reflected inertias, and potential energy in gravity (zero at the origin) and in springs.
    ///
    /// # Errors
    /// [`Fault::Count`] where `N` is not the number of joints, [`Fault::NonFiniteMotion`] for numbers that are not finite.
    pub fn joint_energy<const N: usize>(&self, q: &[T; N], v: &[T; N]) -> Result<[T; 2], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        self.energies(self.on_ground(), q, v)
    }
}

impl<T: Scalar, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, Free, C, P> {
    /// Kinetic energy (J) of a robot whose base floats, with that of the base and of reflected inertias, and potential energy in gravity (zero at
    /// the origin) and in springs.
    ///
    /// # Errors
    /// As [`forward_dynamics_afloat`](Self::forward_dynamics_afloat).
    pub fn joint_energy_afloat<const N: usize>(&self, base: Afloat<T>, q: &[T; N], v: &[T; N]) -> Result<[T; 2], Error>
    where
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        let Afloat { place, velocity, spin } = base;
        checked(&place)?;
        self.energies((place, [place.attitude.transposed(velocity).into(), spin.into()]), q, v)
    }
}
