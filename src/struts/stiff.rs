//! Struts whose stiffness implicit rules know: their forces go with the accelerations that they cause, f = f(q, v) + K̂ J (a − a₀).

use super::strut::line;
use super::{Points, Strut, Struts, dot, is_absent};
use crate::element::{Loading, RealOf, Springs};
use crate::error::Fault;
use crate::lift::Lift;
use crate::loading::{Each, LARGER, Yields, balanced};
use crate::mirror::Rate;
use crate::relation::{Absent, WrenchOf};
use crate::scalar::{Real, Scalar};
use crate::spring::SpringLaw;
use nalgebra::SVector;
use num_traits::{One, Zero};

/// [`Struts`] that may be as stiff as they like under implicit rules: made by [`Struts::stiff`].
///
/// Where a rule is implicit, the force of each strut is that of the end of the step, as that of a spring in a joint is, along the strut and, as far
/// as it pulls, across. It is found with the accelerations, from a sweep for each direction of a strut and two more where it would be one: of
/// use for a few struts that are stiff, as suspensions and buffers are. [`GeneralizedAlpha`](crate::planar::GeneralizedAlpha) keeps its order at
/// any stiffness; [`Sdirk4`](crate::planar::Sdirk4) has order 4 where steps resolve the vibration, and falls to order 1 in rates where they are far
/// longer and the strut turns, for its stages lie on no common curve. Explicit rules, equilibria, modes and readings are those of [`Struts`].
/// Counts of sweeps count them as one. Loads beside them are `Copy`: torques in arrays, not in vectors. Gradients backward take [`Struts`]. Joints that follow others stand before them: `couplings.and(struts.stiff())`, which takes so many sweeps for each of theirs.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0);
/// let scene = System::new(Pinned::origin(), rod, Free)?.with_gravity(9.81);
/// // A rod on a hard buffer with a damper: some 5500 rad/s, and steps of 2 ms.
/// let buffer = Strut::to_ground((0, [1.0, 0.0]), [1.0, -0.2]).with_stiffness(1e7).with_damping(1e3).with_length(0.2);
/// let rule = GeneralizedAlpha::new(0.5).step(2e-3);
/// let run = scene.simulation(rule).loads(&Struts::of([buffer]).stiff()).run(scene.at_rest(&[0.0])?, 1.0, |_| ())?;
/// let expected: f64 = -0.5 * 9.81 / 1e7; // it bears half of the weight
/// assert!((run.motion.coordinates()[0] - expected).abs() < 1e-10);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "Struts<T, D, N, L, W>: serde::Serialize",
        deserialize = "Struts<T, D, N, L, W>: serde::Deserialize<'de>"
    ))
)]
pub struct StiffStruts<T, const D: usize, const N: usize, L = crate::loading::Unloaded, W = Absent> {
    struts: Struts<T, D, N, L, W>,
    /// Forces (N) on first ends, while sweeps ask what they cause.
    #[cfg_attr(feature = "serde", serde(skip, default = "no_forces"))]
    given: Option<[SVector<T, D>; N]>,
}

#[cfg(feature = "serde")]
fn no_forces<T, const D: usize, const N: usize>() -> Option<[SVector<T, D>; N]> {
    None
}

impl<T, const D: usize, const N: usize, L, W> Struts<T, D, N, L, W> {
    /// Struts whose stiffness implicit rules know, of these.
    pub fn stiff(self) -> StiffStruts<T, D, N, L, W> {
        StiffStruts { struts: self, given: None }
    }
}

impl<T, const D: usize, const N: usize, L, W> StiffStruts<T, D, N, L, W> {
    /// The struts, and what acts besides.
    pub fn plain(&self) -> &Struts<T, D, N, L, W> {
        &self.struts
    }
}

/// The directions in which a strut yields, the first one along it, and K̂ in each.
fn yielding<T: Scalar, const D: usize, W: SpringLaw<T>>(
    strut: &Strut<T, D, W>,
    ends: [[SVector<T, D>; 2]; 2],
    springs: impl Springs<T>,
) -> ([SVector<T, D>; D], [T; D]) {
    let Strut { stiffness, damping, length, .. } = *strut;
    let unit = |k| SVector::from_fn(|row, _| if row == k { T::one() } else { T::zero() });
    if strut.has_no_direction() {
        return (core::array::from_fn(unit), [springs.pivot(stiffness, T::zero()); D]);
    }
    let (direction, far, rate) = line(ends);
    // One that hangs slack does not yield.
    let (stretch, tension) = (far - length, strut.tension(far, rate));
    let acting = |x| strut.acting(stretch, tension, x);
    let along = springs.pivot(stiffness, damping);
    let along = acting(if W::ON { along + strut.law.pivot(far, rate, springs) } else { along });
    let along = along.if_negative(T::zero(), along); // what drives on is no resistance
    // The reflection that takes the first axis to the strut, or against it: not where both nearly agree.
    let lead = direction[0].if_negative(-T::one(), T::one());
    let normal = direction + unit(0) * lead;
    let share = (T::one() + direction[0] * lead).recip();
    let axes = core::array::from_fn(|k| unit(k) - normal * (normal[k] * share));
    // A strut that pulls is drawn back across, too; one that pushes would drive further.
    let mut across = stiffness - stiffness * length * far.recip();
    if W::ON {
        across -= strut.law.force(far, T::zero()) * far.recip();
    }
    let across = springs.pivot(acting(across.if_negative(T::zero(), across)), T::zero());
    (axes, core::array::from_fn(|k| if k == 0 { along } else { across }))
}

impl<S, L, const D: usize, const N: usize, W> Loading<S> for StiffStruts<S::Scalar, D, N, L, W>
where
    S: Points<D>,
    L: Loading<S> + Copy,
    W: SpringLaw<S::Scalar>,
{
    type OnBody = WrenchOf<S>;
    type InJoint = L::InJoint;
    type Seen = <Struts<S::Scalar, D, N, L, W> as Loading<S>>::Seen;
    type Responses<V: Clone> = ();
    const ON: bool = true;
    const SURVEYS: bool = true;
    const YIELDS: Yields = Yields::Together;

    fn nothing() -> (WrenchOf<S>, L::InJoint) {
        const {
            assert!(
                !L::SURVEYS,
                "struts that are stiff stand in one array, and beside it neither others nor force elements"
            )
        }
        Struts::<S::Scalar, D, N, L, W>::nothing()
    }
    #[cfg_attr(optimised, inline(always))]
    fn unseen(&self) -> Self::Seen {
        self.struts.unseen()
    }
    #[cfg_attr(optimised, inline(always))]
    fn survey(&self, seen: &mut Self::Seen, body: usize, motion: &S::BodyMotion) {
        self.struts.survey(seen, body, motion);
    }
    #[cfg_attr(optimised, inline(always))]
    fn on_body(&self, seen: &Self::Seen, time: RealOf<S>, body: usize, motion: &S::BodyMotion) -> WrenchOf<S> {
        self.struts.exerted(seen, self.given.as_ref().unwrap_or(&seen.0.forces), time, body, motion)
    }
    fn in_joint(&self, time: RealOf<S>, joint: usize, motion: &S::JointMotion) -> L::InJoint {
        self.struts.in_joint(time, joint, motion)
    }
    fn check(&self, bodies: usize, joints: usize) -> Result<(), Fault> {
        Loading::<S>::check(&self.struts, bodies, joints)
    }
    fn yielded<V: Rate<S::Scalar>>(
        &self,
        (read, led): (&Self::Seen, &V),
        springs: impl Springs<S::Scalar>,
        see: impl Fn(&V) -> Self::Seen,
        acceleration: &mut V,
        mut sweep: impl FnMut(&Self, bool, &mut V),
    ) {
        let (zero, real) = (S::Scalar::zero(), RealOf::<S>::of);
        let ends = &read.0.ends;
        let ways: [_; N] = core::array::from_fn(|k| yielding(&self.struts.struts[k], ends[k], springs));
        // What accelerations part the ends of struts by, along the ways of each.
        let parting = |a: &V| -> Each<S::Scalar, D, N> {
            let seen = see(a);
            core::array::from_fn(|k| {
                let [[_, from], [_, to]] = seen.0.ends[k];
                ways[k].0.map(|way| dot(way, to - from))
            })
        };
        let less = |a: Each<S::Scalar, D, N>, b: &Each<S::Scalar, D, N>| -> Each<S::Scalar, D, N> {
            core::array::from_fn(|k| core::array::from_fn(|d| a[k][d] - b[k][d]))
        };
        let start = read.0.forces;
        let mut swept = |forces, again, acceleration: &mut V| {
            sweep(&Self { given: Some(forces), ..*self }, again, acceleration);
        };
        swept(start, false, acceleration);
        let first = parting(acceleration);
        let missed = less(first, &parting(led));
        let asked: Each<_, D, N> = core::array::from_fn(|k| core::array::from_fn(|d| ways[k].1[d] * missed[k][d]));
        let mut size = RealOf::<S>::one();
        asked.as_flattened().iter().chain(start.iter().flatten()).for_each(|x| size += x.real().abs());
        let size = size * real(LARGER);
        let columns: Each<Each<_, D, N>, D, N> = core::array::from_fn(|j| {
            core::array::from_fn(|e| {
                let mut own = [[zero; D]; N];
                own[j][e] = S::Scalar::one();
                if is_absent(ways[j].1[e]) {
                    return own; // its force is that of the start
                }
                let mut forces = start;
                forces[j] += ways[j].0[e] * S::Scalar::constant(size);
                swept(forces, true, acceleration);
                let response = less(parting(acceleration), &first);
                let inverse = size.recip();
                core::array::from_fn(|k| {
                    core::array::from_fn(|d| own[k][d] - ways[k].1[d] * response[k][d].scale(inverse))
                })
            })
        });
        // Of 1 + K̂ G, with G not negative, all leading minors are one at least.
        let more = balanced(columns, |_| RealOf::<S>::zero(), asked);
        let forces = core::array::from_fn(|k| (0..D).fold(start[k], |force, d| force + ways[k].0[d] * more[k][d]));
        swept(forces, true, acceleration);
    }
}

impl<T: Scalar, U: Scalar, const D: usize, const N: usize, L: Lift<T, U>, W: Lift<T, U>> Lift<T, U>
    for StiffStruts<T, D, N, L, W>
{
    type Over = StiffStruts<U, D, N, L::Over, W::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        self.struts.lift(number).stiff()
    }
}
