//! Springs and dampers between any two points of a scene, or a point and the ground.

mod by_body;
mod readings;
mod stiff;

pub use readings::StrutReading;
pub use stiff::StiffStruts;

use crate::element::{Load, Loading, RealOf, Space};
use crate::error::Fault;
use crate::error::checks::{finite, not_negative};
use crate::lift::Lift;
use crate::loading::Yields;
use crate::relation::{Wrench, WrenchOf};
use crate::scalar::Scalar;
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

/// An end of a strut: a point of a body (its number, and the point in its axes from its inboard end), or of the ground (m).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "[T; D]: serde::Serialize", deserialize = "[T; D]: serde::Deserialize<'de>"))
)]
pub(crate) enum End<T, const D: usize> {
    Body(usize, [T; D]),
    Ground([T; D]),
}

/// A massless spring and damper between two points. Its force acts along the line between them: k (ℓ − ℓ₀) + c ℓ̇ pulls the ends
/// together. Where they meet the line has no direction: a strut with a length or a damper must keep them apart, or its force is NaN, which
/// sweeps refuse as [`Fault::NonFiniteLoad`] at a body where it ends. [`Struts::readings`] tells lengths, tensions and energies.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0);
/// let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
/// // From the middle of the first rod to the tip of the second, and from there to the ground.
/// let inside = Strut::between((0, [0.5, 0.0]), (1, [1.0, 0.0])).with_stiffness(40.0).with_length(1.0);
/// let outside = Strut::to_ground((1, [1.0, 0.0]), [2.5, 0.0]).with_stiffness(20.0).with_damping(0.5);
/// let loads = Struts::of([inside, outside]);
/// let start = scene.at_rest(&[0.0, 0.3])?;
/// let run = scene.simulation(Dop853::tolerance(1e-10)).loads(&loads).run(start, 1.0, |_| ())?;
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "[T; D]: serde::Serialize, T: serde::Serialize",
        deserialize = "[T; D]: serde::Deserialize<'de>, T: serde::Deserialize<'de>"
    ))
)]
pub struct Strut<T, const D: usize> {
    pub(crate) ends: [End<T, D>; 2],
    pub(crate) stiffness: T,
    pub(crate) damping: T,
    pub(crate) length: T,
}

impl<T: Scalar, const D: usize> Strut<T, D> {
    /// Between points of two bodies: the number of each, and the point in its axes from its inboard end (m).
    pub fn between((body, at): (usize, [T; D]), (other, there): (usize, [T; D])) -> Self {
        Self::new(End::Body(body, at), End::Body(other, there))
    }

    /// Between a point of a body and a place in inertial axes (m): it stays where it is where the ground of the scene moves.
    pub fn to_ground((body, at): (usize, [T; D]), place: [T; D]) -> Self {
        Self::new(End::Body(body, at), End::Ground(place))
    }

    fn new(from: End<T, D>, to: End<T, D>) -> Self {
        Self { ends: [from, to], stiffness: T::zero(), damping: T::zero(), length: T::zero() }
    }

    /// With a stiffness (N/m).
    #[must_use]
    pub fn with_stiffness(self, stiffness: T) -> Self {
        Self { stiffness, ..self }
    }

    /// With a damping (N·s/m).
    #[must_use]
    pub fn with_damping(self, damping: T) -> Self {
        Self { damping, ..self }
    }

    /// With a length (m) at which the spring does not pull; else it always does.
    #[must_use]
    pub fn with_length(self, length: T) -> Self {
        Self { length, ..self }
    }

    /// The last body that it ends at.
    fn last_body(&self) -> Option<usize> {
        let body = |end: &End<T, D>| if let End::Body(k, _) = end { Some(*k) } else { None };
        let [from, to] = self.ends.each_ref().map(body);
        from.max(to)
    }

    /// Energy stored (J), for the places of its ends (m).
    pub fn energy(&self, from: SVector<T, D>, to: SVector<T, D>) -> T {
        let (apart, half) = (to - from, crate::scalar::Real::of(0.5));
        if is_absent(self.length) {
            return (self.stiffness * dot(apart, apart)).scale(half);
        }
        let stretch = norm(apart) - self.length;
        (self.stiffness * stretch * stretch).scale(half)
    }

    /// Force (N) on the strut's first end, for place and velocity of both.
    pub(crate) fn force(&self, [from, to]: [[SVector<T, D>; 2]; 2]) -> SVector<T, D> {
        let (apart, parting) = (to[0] - from[0], to[1] - from[1]);
        // A spring without length and a damper that is not there have no need of a direction: their ends may meet.
        if is_absent(self.damping) && (is_absent(self.length) || is_absent(self.stiffness)) {
            return apart * self.stiffness;
        }
        let direction = apart * norm(apart).recip();
        let stretch = norm(apart) - self.length;
        direction * self.damping.mul_add(dot(direction, parting), self.stiffness * stretch)
    }
}

/// Whether a parameter is zero, and all its derivatives: one that is zero where something is differentiated by it acts.
pub(crate) fn is_absent<T: Scalar>(x: T) -> bool {
    x.is_identical(T::zero())
}

pub(crate) fn dot<T: Scalar, const D: usize>(a: SVector<T, D>, b: SVector<T, D>) -> T {
    a.iter().zip(b.iter()).fold(T::zero(), |sum, (a, b)| a.mul_add(*b, sum))
}

pub(crate) fn norm<T: Scalar, const D: usize>(a: SVector<T, D>) -> T {
    dot(a, a).sqrt()
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
        serialize = "[Strut<T, D>; N]: serde::Serialize, L: serde::Serialize",
        deserialize = "[Strut<T, D>; N]: serde::Deserialize<'de>, L: serde::Deserialize<'de>"
    ))
)]
pub struct Struts<T, const D: usize, const N: usize, L = crate::loading::Unloaded> {
    struts: [Strut<T, D>; N],
    others: L,
}

impl<T, const D: usize, const N: usize> Struts<T, D, N> {
    /// Loads by these struts, and no others.
    pub const fn of(struts: [Strut<T, D>; N]) -> Self {
        Self { struts, others: crate::loading::Unloaded }
    }

    /// Other loads besides. Loads that yield, as contacts do, do not compile here: make them [`plain`](crate::spatial::Contacts::plain).
    /// Nor do [`Torques`](crate::robot::Torques), which number joints of one coordinate: take [`Loads::efforts`](crate::loading::Loads::efforts).
    pub fn and<L>(self, others: L) -> Struts<T, D, N, L> {
        Struts { struts: self.struts, others }
    }
}

impl<T, const D: usize, const N: usize, L> Struts<T, D, N, L> {
    /// The struts.
    pub fn struts(&self) -> &[Strut<T, D>; N] {
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

impl<T: Scalar, const D: usize, const N: usize, L> Struts<T, D, N, L> {
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

impl<S, L, const D: usize, const N: usize> Loading<S> for Struts<S::Scalar, D, N, L>
where
    S: Points<D>,
    L: Loading<S>,
{
    type OnBody = WrenchOf<S>;
    type InJoint = L::InJoint;
    type Seen = (Sight<S::Scalar, D, N>, L::Seen);
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
        const { assert!(!L::COUPLED, "couplings stand before struts: `couplings.and(struts)`") }
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
        for Strut { ends, stiffness, damping, length } in &self.struts {
            not_negative("stiffness of a strut", *stiffness)?;
            not_negative("damping of a strut", *damping)?;
            not_negative("length of a strut", *length)?;
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

impl<T: Scalar, U: Scalar, const D: usize, const N: usize, L: Lift<T, U>> Lift<T, U> for Struts<T, D, N, L> {
    type Over = Struts<U, D, N, L::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Struts { struts: self.struts.lift(number), others: self.others.lift(number) }
    }
}

impl<T: Scalar, U: Scalar, const D: usize> Lift<T, U> for Strut<T, D> {
    type Over = Strut<U, D>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Strut<U, D> {
        let ends = self.ends.map(|end| match end {
            End::Body(k, at) => End::Body(k, at.map(&mut *number)),
            End::Ground(place) => End::Ground(place.map(&mut *number)),
        });
        let [stiffness, damping, length] = [self.stiffness, self.damping, self.length].map(&mut *number);
        Strut { ends, stiffness, damping, length }
    }
}
