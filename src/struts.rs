//! Springs and dampers between any two points of a scene, or a point and the ground.

mod by_body;
mod readings;
mod stiff;
mod strut;

pub use readings::StrutReading;
pub use stiff::StiffStruts;
pub use strut::Strut;
pub(crate) use strut::{Acts, End, dot, is_absent, norm};

use crate::element::{Load, Loading, RealOf, Space};
use crate::error::Fault;
use crate::error::checks::{finite, not_negative, positive};
use crate::lift::Lift;
use crate::loading::{Yields, couples};
use crate::relation::{Absent, Wrench, WrenchOf};
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use by_body::ByBody;
use nalgebra::SVector;
use num_traits::Zero;

/// A space of `D` dimensions, in which points of bodies can be pulled at.
pub trait Points<const D: usize>: Space {
    /// Place (m) and velocity (m/s) of a point given in body axes from the inboard end (m).
    fn point(body: &Self::BodyMotion, at: [Self::Scalar; D]) -> [SVector<Self::Scalar, D>; 2];
    /// A force (N, inertial axes) at such a point.
    fn pull(body: &Self::BodyMotion, at: [Self::Scalar; D], force: SVector<Self::Scalar, D>) -> WrenchOf<Self>;
}

/// Struts of a scene, beside other loads.
///
/// They are loads: explicit rules take them as they are, and implicit ones where the geometry of a sweep is, so that a strut's
/// stiffness does not enter the pivots of joints as that of a hinge does. A step must resolve its vibration: h ω < 2.8 for `Rk4`, and, unless struts
/// are made [`stiff`](Self::stiff), h ω < 1 for implicit rules: beyond, motions grow, by `Sdirk4` slowly, by `GeneralizedAlpha::new(0.8)` from h ω = 2
/// on, by `GeneralizedAlpha::new(0.0)` from 1.5 on. A strut sees the whole scene, which costs a walk more in each sweep, and nothing where there are none.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "[Strut<T, D, W>; N]: serde::Serialize, L: serde::Serialize",
        deserialize = "[Strut<T, D, W>; N]: serde::Deserialize<'de>, L: serde::Deserialize<'de>"
    ))
)]
pub struct Struts<T, const D: usize, const N: usize, L = crate::loading::Unloaded, W = Absent> {
    struts: [Strut<T, D, W>; N],
    others: L,
}

impl<T, const D: usize, const N: usize, W> Struts<T, D, N, crate::loading::Unloaded, W> {
    /// Loads by these struts, and no others.
    pub const fn of(struts: [Strut<T, D, W>; N]) -> Self {
        Self { struts, others: crate::loading::Unloaded }
    }

    /// Other loads besides. Loads that yield, as contacts do, do not compile here: make them [`plain`](crate::spatial::Contacts::plain).
    /// Nor do [`Torques`](crate::robot::Torques), which number joints of one coordinate: take [`Loads::efforts`](crate::loading::Loads::efforts).
    pub fn and<L>(self, others: L) -> Struts<T, D, N, L, W> {
        Struts { struts: self.struts, others }
    }
}

impl<T, const D: usize, const N: usize, L, W> Struts<T, D, N, L, W> {
    /// The struts.
    pub fn struts(&self) -> &[Strut<T, D, W>; N] {
        &self.struts
    }

    /// What acts besides.
    pub(crate) fn others(&self) -> &L {
        &self.others
    }
}

/// Places and velocities of the ends of struts.
pub(crate) type Ends<T, const D: usize, const N: usize> = [[[SVector<T, D>; 2]; 2]; N];

/// What has been seen of struts.
#[derive(Clone, Copy, Debug)]
pub struct Sight<T, const D: usize, const N: usize> {
    pub(crate) ends: Ends<T, D, N>,
    /// Forces (N) on first ends, of struts both of whose ends have been seen.
    forces: [SVector<T, D>; N],
    by_body: ByBody<N>,
}

impl<T, const D: usize, const N: usize> Sight<T, D, N> {
    /// Numbers of struts that may be on a body.
    #[inline(always)]
    pub(crate) fn on(&self, body: usize) -> impl Iterator<Item = usize> {
        self.by_body.on(body)
    }
}

impl<T: Scalar, const D: usize, const N: usize, L, W> Struts<T, D, N, L, W> {
    /// What struts with such forces (N, on their first ends) and other loads exert on a body.
    #[cfg_attr(optimised, inline(always))]
    fn exerted<S: Points<D, Scalar = T>>(
        &self,
        (sight, others): &(Sight<T, D, N>, L::Seen),
        forces: &[SVector<T, D>; N],
        time: T::Real,
        body: usize,
        motion: &S::BodyMotion,
    ) -> WrenchOf<S>
    where
        L: Loading<S>,
    {
        let mut sum = Wrench::none();
        for strut in sight.on(body) {
            for (end, sign) in self.struts[strut].ends.iter().zip([1.0, -1.0]) {
                if let End::Body(k, at) = end
                    && *k == body
                {
                    sum = sum + S::pull(motion, *at, forces[strut] * S::Scalar::literal(sign));
                }
            }
        }
        if L::ON { sum + self.others.on_body(others, time, body, motion).wrench() } else { sum }
    }
}

impl<S, L, const D: usize, const N: usize, W> Loading<S> for Struts<S::Scalar, D, N, L, W>
where
    S: Points<D>,
    L: Loading<S>,
    W: SpringLaw<S::Scalar>,
{
    type OnBody = WrenchOf<S>;
    type InJoint = L::InJoint;
    type Seen = (Sight<S::Scalar, D, N>, L::Seen);
    type Responses<V: Clone> = ();
    const ON: bool = true;
    const SURVEYS: bool = true;

    fn nothing() -> (WrenchOf<S>, L::InJoint) {
        const { assert!(N < u16::MAX as usize / 2, "one list has 32766 struts at most") }
        const {
            assert!(
                matches!(L::YIELDS, Yields::Never),
                "beside struts loads do not yield: take contacts as `plain` ones, and struts that are stiff in one list, last: `struts.and(loads).stiff()`"
            )
        }
        const { assert!(!couples::<S, L>(), "couplings stand before struts: `couplings.and(struts)`") }
        const { assert!(!L::BY_COORDINATE, "beside struts joints are numbered from the root's on: take `Loads::efforts`") }
        (Wrench::none(), L::nothing().1)
    }
    #[cfg_attr(optimised, inline(always))]
    fn unseen(&self) -> Self::Seen {
        // Until a body has been seen it is nowhere.
        let (nowhere, still) = (SVector::repeat(S::Scalar::literal(f64::NAN)), SVector::repeat(S::Scalar::zero()));
        let mut ends = [[[nowhere; 2]; 2]; N];
        for (end, seen) in self.struts.iter().flat_map(|strut| &strut.ends).zip(ends.as_flattened_mut()) {
            if let End::Ground(place) = end {
                *seen = [SVector::from(*place), still];
            }
        }
        (Sight { ends, forces: [nowhere; N], by_body: ByBody::of(&self.struts) }, self.others.unseen())
    }
    #[cfg_attr(optimised, inline(always))]
    fn survey(&self, (sight, others): &mut Self::Seen, body: usize, motion: &S::BodyMotion) {
        let Sight { ends, forces, by_body } = sight;
        for k in by_body.on(body) {
            let (strut, ends) = (&self.struts[k], &mut ends[k]);
            for (end, seen) in strut.ends.iter().zip(&mut *ends) {
                if let End::Body(k, at) = end
                    && *k == body
                {
                    *seen = S::point(motion, *at);
                }
            }
            // Bodies are seen in the order of their numbers.
            if strut.last_body() == Some(body) {
                forces[k] = strut.force(*ends);
            }
        }
        if L::SURVEYS {
            self.others.survey(others, body, motion);
        }
    }
    #[cfg_attr(optimised, inline(always))]
    fn on_body(&self, seen: &Self::Seen, time: RealOf<S>, body: usize, motion: &S::BodyMotion) -> WrenchOf<S> {
        self.exerted(seen, &seen.0.forces, time, body, motion)
    }
    fn in_joint(&self, time: RealOf<S>, joint: usize, motion: &S::JointMotion) -> L::InJoint {
        self.others.in_joint(time, joint, motion)
    }
    fn check(&self, bodies: usize, joints: usize) -> Result<(), Fault> {
        for Strut { ends, stiffness, damping, length, acts, law } in &self.struts {
            law.check()?;
            not_negative("stiffness of a strut", *stiffness)?;
            not_negative("damping of a strut", *damping)?;
            not_negative("length of a strut", *length)?;
            if let Acts::Pushes = acts {
                positive("length of a buffer", *length)?;
            }
            for End::Body(_, at) | End::Ground(at) in ends {
                finite("end of a strut", at)?;
            }
            let body =
                ends.iter().find_map(|end| if let End::Body(k, _) = *end { (k >= bodies).then_some(k) } else { None });
            body.map_or(Ok(()), |body| Err(Fault::NoSuchBody { body, bodies }))?;
        }
        self.others.check(bodies, joints)
    }
}

impl<T: Scalar, U: Scalar, const D: usize, const N: usize, L: Lift<T, U>, W: Lift<T, U>> Lift<T, U>
    for Struts<T, D, N, L, W>
{
    type Over = Struts<U, D, N, L::Over, W::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Struts { struts: self.struts.lift(number), others: self.others.lift(number) }
    }
}
