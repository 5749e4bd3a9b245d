//! Hard stops: a joint whose coordinate has a range, strikes its ends, and rests against them.

use super::{Guard, Guarded};
use crate::error::Fault;
use crate::error::checks::{finite, not_negative};
use crate::lift::lift;
use crate::mirror::{Mode, Stops};
use crate::relation::Absent;
use crate::scalar::{Real, Scalar};
use num_traits::One;

/// A joint between hard stops: its coordinate goes no farther than to the ends of a range. Where it strikes one its rate v becomes −e v, by
/// Newton's law of restitution, at one instant, and all other rates jump by what the shock does to them; where it does not rebound it
/// rests against its stop, locked, as long as that pushes.
///
/// Between its stops, and resting against one, are modes of a motion. Runs ([`simulation`] and all that follows from it) change them: a step
/// ends where the coordinate meets its stop, or where the force of that is zero, so that rules keep their order, and rules that remember
/// motions begin anew. Where several joints meet their stops at one instant, or rest against them while another strikes, the one that is
/// fastest goes first, until none moves into its stop; what is not over after 256 blows, as where a long body at a short one strikes, is brought to
/// rest at once, by stops that push. ([`MoreauJean`] takes all that strike or rest within a step at once, each by its own share: another law, and other
/// rates after, wherever it is more than one.) A shock goes over friction: joints that stick ([`Coulomb`]) move by it. A rebound
/// that would rise no higher than 6e-14 (rad, m; in `f32` 3e-5) is none, so that a joint which bounces ever less comes to rest; it leaves its
/// stop where it would do so at more than 1e-6 (rad/s², m/s²; in `f32` 0.02). What has come as near to its
/// stop as that stands at it. Shocks take energy and are seen in no force. An accepted step that ends at a shock is shown as it is before it.
///
/// Any joint with one coordinate can have stops, in the plane, in space and of robots, and a spring, damper or law beside them; an end at infinity is
/// none. A step of a [`Stepper`] of one's own changes no mode, and is refused where the step before has brought a joint beyond its stop: [`Stops`]
/// is the compliant law for these, [`MoreauJean`] the rule for steps of one size that do, in real time. As data an end at infinity needs a format that has infinity; JSON has none. Runs over lanes are refused, and so are equilibria and modes of vibration. A
/// joint that passes its stop and comes back within one step is seen under error control, where rates at both ends tell of it; by fixed steps it is not, and
/// [`longest_step`] is for such.
///
/// Runs over jets and dual numbers have the first derivatives of what happens: when a joint strikes hangs on all that is differentiated, and what
/// that changes is added where the mode changes, exact but for the error of the step that ends there. Second derivatives past such a time are
/// refused, steps of [`MoreauJean`], whose derivatives would be others, joints that are driven beside, and a start at a stop, by how it stands there. Where two joints
/// strike at one instant, derivatives are those of the order in which they do; where one only just touches its stop, they grow without bound.
///
/// ```
/// use catena::planar::*;
/// // A block of 2 kg that falls 1 m, and gives back half of its speed.
/// let block = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
/// let fall = HardStops::between(Slider::along(std::f64::consts::FRAC_PI_2), [0.0, f64::INFINITY]).rebounding(0.5);
/// let scene = System::new(Clamped::origin(), (fall, block), Free)?.with_gravity(9.81);
/// let mut start = scene.motion();
/// start.set_coordinates(&[1.0])?;
/// let first = f64::sqrt(2.0 / 9.81); // (s)
/// let top = scene.simulation(Dop853::tolerance(1e-10)).run(start, 1.5 * first, |_| ())?.motion;
/// assert!((top.coordinates()[0] - 0.25).abs() < 1e-12);
/// let end = scene.simulation(Dop853::tolerance(1e-10)).run(start, 4.0 * first, |_| ())?.motion; // it rests from 3 times on
/// assert_eq!(end.rates(), [0.0]);
/// assert!(end.coordinates()[0].abs() < 1e-12);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// How much higher it bounces from higher up, by a jet: e² times as much.
///
/// ```
/// use catena::planar::*;
/// use catena::scalar::Jet;
/// let [zero, one] = [0.0, 1.0].map(Jet::<f64, 1>::of);
/// let fall = HardStops::between(Slider::along(Jet::of(std::f64::consts::FRAC_PI_2)), [zero, Jet::of(f64::INFINITY)]);
/// let chain = (fall.rebounding(Jet::of(0.5)), RigidBody::new(one, one, [zero; 2], [zero; 2]));
/// let scene = System::new(Clamped::origin(), chain, Free)?.with_gravity(Jet::of(9.81));
/// let mut start = scene.motion();
/// start.set_coordinates(&[Jet::seed(1.0, 0)])?;
/// let top = scene.simulation(Dop853::tolerance(1e-10)).run(start, 1.5 * f64::sqrt(2.0 / 9.81), |_| ())?.motion;
/// assert!((top.coordinates()[0].eps[0] - 0.25).abs() < 1e-9);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// [`simulation`]: crate::system::System::simulation
/// [`longest_step`]: crate::simulate::Simulation::longest_step
/// [`Stepper`]: crate::simulate::Stepper
/// [`Stops`]: crate::planar::Stops
/// [`Coulomb`]: crate::planar::Coulomb
/// [`MoreauJean`]: crate::planar::MoreauJean
pub type HardStops<J, T, L = Absent> = Guarded<J, Range<T>, L>;

/// The range of a coordinate (rad, m), and the share of a rate that its ends give back.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Range<T> {
    lower: T,
    upper: T,
    restitution: T,
}

impl<J, T: Scalar> Guarded<J, Range<T>> {
    /// A joint between stops (rad, m) that give nothing back.
    pub fn between(joint: J, range: [T; 2]) -> Self {
        Self { joint, guard: Range::of(range), law: Absent }
    }
}

impl<J, T: Scalar, L> Guarded<J, Range<T>, L> {
    /// Whose stops give back a share of the rate, from 0 to 1: the coefficient of restitution.
    #[must_use]
    pub fn rebounding(self, restitution: T) -> Self {
        Self { guard: self.guard.giving_back(restitution), ..self }
    }
}

impl<T: Scalar> Range<T> {
    /// A range whose ends give nothing back.
    pub(super) fn of([lower, upper]: [T; 2]) -> Self {
        Self { lower, upper, restitution: T::zero() }
    }

    /// Whose ends give back this share.
    pub(super) fn giving_back(self, restitution: T) -> Self {
        Self { restitution, ..self }
    }
}

lift!(Range { lower, upper, restitution });

impl<T: Scalar> Guard<T> for Range<T> {
    const KIND: &'static str = "HardStops";
    type Guarding = Stops;

    fn resists(&self, _: Mode) -> T {
        T::zero()
    }
    fn trial(&self) -> T {
        T::one()
    }
    /// A coordinate that is far from both stops is as near as zero: what lies at infinity has no distance.
    fn free(&self, coordinate: T) -> [T; 3] {
        let [below, above] = [coordinate - self.lower, self.upper - coordinate];
        let near = |distance: T, end: T| {
            let share = distance / (T::one() + end.abs());
            if share.real() < T::Real::one() { T::one() - share } else { T::zero() }
        };
        if below.real() < above.real() {
            [-near(below, self.lower), self.restitution, -below]
        } else {
            [near(above, self.upper), self.restitution, above]
        }
    }
    fn held(&self, mode: Mode, told: [T; 3], [free, tried]: [T; 2]) -> [T; 3] {
        let answer = free / (free - tried);
        if let Mode::Lands | Mode::Rebounds = mode {
            return [told[0], answer, told[2]];
        }
        let outward = mode.stop().map_or(T::zero(), |side| T::literal(-side));
        [free * outward, answer, T::zero()]
    }
    fn check(&self) -> Result<(), Fault> {
        let [lower, upper] = [self.lower, self.upper].map(|end| end.real().as_f64());
        if lower.is_nan() || upper.is_nan() {
            return Err(Fault::NotFinite { parameter: "hard stop" });
        }
        if lower >= upper {
            return Err(Fault::NotPositive { parameter: "range between hard stops", value: upper - lower });
        }
        finite("restitution", &[self.restitution])?;
        not_negative("restitution", self.restitution)?;
        let (value, parameter, outside) = (self.restitution.real().as_f64(), "restitution", "a stop would give energy");
        if value <= 1.0 { Ok(()) } else { Err(Fault::OutOfRange { parameter, value, least: 0.0, most: 1.0, outside }) }
    }
}
