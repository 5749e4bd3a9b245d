//! Dry friction as it is: a joint that sticks until a force breaks it away, and slips until it comes to rest.

use super::{Guard, Guarded};
use crate::error::Fault;
use crate::error::checks::positive;
use crate::lift::lift;
use crate::mirror::{Mode, Rubs};
use crate::relation::Absent;
use crate::scalar::{Real, Scalar};

/// A joint with Coulomb's friction: while it slips a force of constant size against its rate, while it sticks whatever keeps it from moving,
/// up to the force at which it breaks away.
///
/// Sticking and slipping are modes of a motion: a joint that sticks is locked, and has no pivot. Runs ([`simulation`] and all that follows
/// from it) change them where the rate passes zero and where the force breaks the joint away, the earliest first if several joints are
/// about to; they end a step there, so that rules keep their order, and rules that remember motions begin anew. A run finds
/// the modes of its start from its rates; where rates are set by hand they follow from these. Steps of a [`Stepper`] of one's own change no
/// mode, and are refused where a joint has come to move against that in which a run has left it: [`DryFriction`] is the smooth law for these.
/// [`MoreauJean`] is the rule for steps of one size that do, in real time. With `.between(..)` hard stops come to it ([`BoundedCoulomb`]).
///
/// Any joint with one coordinate can have such friction, in the plane, in space and of robots, and a spring, damper or law beside it. Runs over
/// lanes are refused, for each would change modes at times of its own. So are equilibria and modes of vibration, for a joint
/// that sticks rests anywhere within what friction holds. Where drives leave nothing free to move, joints slip on as these say.
///
/// Mechanisms may come to rest with more such joints than they have freedoms. As many stick as there are freedoms, the others bear all of the friction
/// of their slips, one way or the other, which is one of many answers: that it holds, and when it breaks away, is the same for all of them, if a joint breaks away at
/// what it slips with. Where it takes more to break a joint away, this counts for those that stick, which are others by [`MoreauJean`]. Friction of
/// zero is refused: such a joint has no modes.
///
/// Runs over jets and dual numbers have the first derivatives of what happens, as those of [`HardStops`], and so do
/// [gradients backward](crate::sensitivity::Backward::course). Where a joint breaks away from more
/// friction than it slips with, accelerations jump at a time that hangs on how fast forces grow: that is taken from how they have grown within the step,
/// to order four in its size, and a run whose derivatives hang on it is refused where they have hardly, or not steadily, grown. Derivatives of the rate
/// of a joint that sticks where a run begins are lost at once, as in a shock: friction halts in no time what there is of them.
///
/// Under error control, steps in which a joint sticks are looked at in their middle, closer where friction changes by more than a tenth of that
/// at which the joint breaks away, and then grow no further. A joint that comes to rest and slips on within a step is seen where accelerations at both ends tell of it. A load that comes and goes between two looks while all is at rest is not seen:
/// [`longest_step`] is for such loads, and for fixed steps their ends are what is looked at.
///
/// ```
/// use catena::planar::*;
/// // A block of 2 kg on a plane, thrown at 3 m/s: it slides 0.9 m, and stays.
/// let block = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
/// let track = Coulomb::new(Slider::along(0.0), 10.0).breaking_away(12.0); // (N)
/// let scene = System::new(Clamped::origin(), (track, block), Free)?;
/// let start = scene.with_rates(scene.motion(), &[3.0])?;
/// let end = scene.simulation(Dop853::tolerance(1e-9)).run(start, 2.0, |_| ())?.motion;
/// assert!((end.coordinates()[0] - 0.9_f64).abs() < 1e-12);
/// assert_eq!(end.rates(), [0.0]);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// [`simulation`]: crate::system::System::simulation
/// [`longest_step`]: crate::simulate::Simulation::longest_step
/// [`Stepper`]: crate::simulate::Stepper
/// [`DryFriction`]: crate::planar::DryFriction
/// [`MoreauJean`]: crate::planar::MoreauJean
/// [`BoundedCoulomb`]: crate::planar::BoundedCoulomb
/// [`HardStops`]: crate::planar::HardStops
pub type Coulomb<J, T, L = Absent> = Guarded<J, Friction<T>, L>;

/// Friction while a joint slips, and at which it breaks away (N·m, N).
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Friction<T> {
    sliding: T,
    breaking: T,
}

impl<J, T: Scalar> Guarded<J, Friction<T>> {
    /// A joint with friction (N·m, N).
    pub fn new(joint: J, sliding: T) -> Self {
        Self { joint, guard: Friction { sliding, breaking: sliding }, law: Absent }
    }
}

impl<J, T: Scalar, L> Guarded<J, Friction<T>, L> {
    /// That breaks away at another force (N·m, N), which is no smaller.
    #[must_use]
    pub fn breaking_away(self, breaking: T) -> Self {
        Self { guard: Friction { breaking, ..self.guard }, ..self }
    }
}

lift!(Friction { sliding, breaking });

impl<T: Scalar> Guard<T> for Friction<T> {
    const KIND: &'static str = "Coulomb";
    type Guarding = Rubs;

    fn resists(&self, mode: Mode) -> T {
        mode.sign::<T>() * self.sliding
    }
    fn trial(&self) -> T {
        self.breaking
    }
    fn free(&self, _: T) -> [T; 3] {
        [T::zero(); 3]
    }
    fn held(&self, _: Mode, _: [T; 3], [free, tried]: [T; 2]) -> [T; 3] {
        let share = free / (free - tried);
        [share, share * self.breaking, T::zero()]
    }
    fn check(&self) -> Result<(), Fault> {
        positive("friction", self.sliding)?;
        positive("friction at which a joint breaks away", self.breaking)?;
        let (value, least) = (self.breaking.real().as_f64(), self.sliding.real().as_f64());
        let (most, parameter) = (f64::INFINITY, "friction at which a joint breaks away");
        let outside = "a joint would stick and slip at once";
        if value >= least { Ok(()) } else { Err(Fault::OutOfRange { parameter, value, least, most, outside }) }
    }
}
