//! Time stepping after Moreau and Jean, linearly implicit, of order one: for real time.

use super::{Control, Rule};

/// Time stepping after J. J. Moreau and M. Jean (V. Acary, B. Brogliato, *Numerical Methods for Nonsmooth Dynamical Systems*, 2008, ch. 10):
/// order one, fixed steps, one sweep a step. For real time, with friction, stops and contacts.
///
/// ```text
/// v₁ = v₀ + h a(q₀, v₀)        q₁ = q₀ + h v₁
/// ```
///
/// with geometry and velocity terms of the start of the step, and springs, dampers, laws of joints and [`Contacts`] as at its end, by their
/// slopes: symplectic Euler where nothing is stiff, backward Euler where something is. Springs and contacts may be as stiff as they like:
/// vibration that steps do not resolve dies out within a few. How bodies turn has to be resolved, above all by chains that whip: forty links of 0.1 m
/// that fall by their own weight break at steps of 10 ms, not at 1 ms.
///
/// # Friction and stops
///
/// No step is cut where a mode changes. What joints with [`Coulomb`], [`HardStops`] and both ([`BoundedCoulomb`]) do is found for the step as a whole: impulses of
/// friction are at most h times it, and bring a joint to rest where they suffice; one that would pass its stop ends the step there, and, if it
/// gives back a share e of its rate, leaves with −e times that. All these joints are a linear complementarity problem, which is solved by
/// pivoting, exactly: each pass is one more sweep, and most steps take none. (Random arms with two joints that rub and two that
/// strike take 1.09 sweeps a step, chains of forty such joints 1.5 to 2.7, and 18 at most.) Several joints may strike or stick at once, and in mechanisms more than are free to move:
/// what each of them bears is then one of many answers, the motion is not. A joint that rebounds does so from where the step began, and looks at no
/// other stop: what it leaves behind in a step, e v h, has to be less than its range. A run refuses a start beyond a stop; a step by hand takes what
/// stands there back to it, at a rate that it keeps.
///
/// # What it costs
///
/// Errors of one step grow with h, all of them: steps of 1 ms miss the angles of a double pendulum by 9e-4 rad after 0.8 s, and its
/// energy by up to 9 % of what swings it over in 10 s; a bounce at 1 ms by some 2 mm. A humanoid of 29 joints with contacts takes a fifteenth
/// of the time of [`Sdirk4`](super::Sdirk4) a step: 12 µs for 1 ms. For digits take rules of higher order, which end steps at events.
///
/// Steps by a [`Stepper`](crate::simulate::Stepper) of one's own do the same as those of runs. Dense output is a shorter step. Over lanes
/// it steps scenes without such joints, and gradients backward do not go through it.
///
/// Over jets and dual numbers derivatives, of any order, are those of the steps as they are computed. With friction these tend to those of the motion. Across
/// shocks they would not, for when a joint strikes hangs on all that is differentiated, and steps do not: a block that falls 1 m and gives
/// back 0.7 of its speed would be 1 m higher after 0.7 s for each metre that it falls from higher up, in steps however short, where it is 0.24. So joints
/// with hard stops are refused; runs with events, by any other rule, have their derivatives.
///
/// ```
/// use catena::planar::*;
/// // A gate that falls against its stop and stays, with a latch that rubs: half a second in steps of a millisecond.
/// let gate = (HardStops::between(Revolute::smooth(), [-0.5, 0.0]).rebounding(0.3), Rod::uniform(1.0, 4.0));
/// let latch = (Coulomb::new(Revolute::smooth(), 0.2), Rod::uniform(0.2, 0.3));
/// let scene = System::new(Clamped::origin(), (gate, latch), Free)?.with_gravity(9.81);
/// let mut stepper = scene.stepper(MoreauJean);
/// let (mut now, mut next) = (scene.motion(), scene.motion());
/// for _ in 0..1500 {
///     stepper.step(&now, &Unloaded, 1e-3, &mut next)?;
///     core::mem::swap(&mut now, &mut next);
/// }
/// assert_eq!(now.coordinates()[0], -0.5); // at its stop
/// assert_eq!(now.rates()[0], 0.0);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// [`Contacts`]: crate::spatial::Contacts
/// [`Coulomb`]: crate::planar::Coulomb
/// [`HardStops`]: crate::planar::HardStops
/// [`BoundedCoulomb`]: crate::planar::BoundedCoulomb
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MoreauJean;

impl MoreauJean {
    /// Steps of a fixed size (s).
    pub fn step<R>(size: R) -> Rule<Self, R> {
        Rule { method: Self, control: Control::Fixed(size) }
    }
}
