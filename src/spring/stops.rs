//! Compliant stops at both ends of a coordinate's range.

use super::{Compression, SpringLaw, above};
use crate::element::Springs;
use crate::error::Fault;
use crate::error::checks::{not_negative, positive};
use crate::lift::lift;
use crate::relation::{Absent, Coefficient};
use crate::scalar::{Real, Scalar};

/// Stops at both ends of the range of a joint's coordinate, compliant ones: beyond by x (rad, m) the coordinate is pushed back by
/// k d(x) (1 + c ẋ), and never pulled (K. H. Hunt and F. R. E. Crossley, *Coefficient of restitution interpreted as damping in
/// vibroimpact*, Journal of Applied Mechanics 42, 1975). With the stiffness k (N·m/rad, N/m) and the damping c (s/rad, s/m; none unless
/// [`damped`](Self::damped)), a rebound from the speed v has lost some ⅔ c v of it.
///
/// The stiffness sets in over a depth w (rad, m): d′ rises from 0 to 1 as 3 (x/w)² − 2 (x/w)³, and d = x − w/2 beyond it. So the force
/// has two continuous derivatives, and rules up to order four keep their order where steps resolve the depth. Explicit steps are stable
/// below some 2.8 √(m/k); implicit ones know the slope. Energy only falls.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(0.5, 1.0);
/// let stops = Stops::between([-0.3, 2.0], 2e3, 0.02).damped(0.5); // (rad), (N·m/rad), (rad), (s/rad)
/// let leg = System::new(Pinned::origin(), (rod, ElasticHinge::with(stops), rod), Free)?.with_gravity(9.81);
/// let mut least = 0.0_f64;
/// let run = leg.simulate(leg.at_rest(&[0.0, 0.2])?, Sdirk4::new().tolerance(1e-6), 2.0, |now| {
///     least = least.min(now.motion().position().1.1); // relative angle of the hinge
/// })?;
/// assert!(-0.4 < least && least < -0.3);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Stops<T, C = Absent> {
    lower: T,
    upper: T,
    stiffness: T,
    depth: T,
    damping: C,
}

impl<T: Scalar> Stops<T> {
    /// At the ends of a range (rad, m), of a stiffness (N·m/rad, N/m) that sets in over a depth (rad, m).
    pub fn between([lower, upper]: [T; 2], stiffness: T, depth: T) -> Self {
        Self { lower, upper, stiffness, depth, damping: Absent }
    }
}

impl<T: Scalar, C> Stops<T, C> {
    /// With damping c (s/rad, s/m), zero or more.
    pub fn damped(self, damping: T) -> Stops<T, T> {
        let Self { lower, upper, stiffness, depth, .. } = self;
        Stops { lower, upper, stiffness, depth, damping }
    }

    /// The side (−1, 1; 0 within the range), and what is pressed in there: each end has its own rounding, however far the other one is.
    #[inline(always)]
    fn beyond(&self, position: T) -> (T, Compression<T>) {
        let over = above(position - self.upper) - above(self.lower - position);
        (over.sign(), Compression::of(over.abs(), self.depth))
    }
}

impl<T: Scalar, C: Coefficient<T>> SpringLaw<T> for Stops<T, C> {
    #[cfg_attr(optimised, inline(always))]
    fn force(&self, position: T, rate: T) -> T {
        let (side, pressed) = self.beyond(position);
        let push = above(self.damping.times_onto(side * rate, T::one()));
        -(side * self.stiffness * pressed.force() * push)
    }
    fn energy(&self, position: T) -> T {
        self.stiffness * self.beyond(position).1.energy()
    }
    #[cfg_attr(optimised, inline(always))]
    fn pivot(&self, position: T, rate: T, springs: impl Springs<T>) -> T {
        let (side, pressed) = self.beyond(position);
        let push = above(self.damping.times_onto(side * rate, T::one()));
        // Where the damper would pull, nothing acts, and nothing changes.
        let damping = self.damping.times_onto(self.stiffness * pressed.force() * push.sign(), T::zero());
        springs.pivot(self.stiffness * pressed.stiffness() * push, damping)
    }
    fn check(&self) -> Result<(), Fault> {
        if !(self.lower.is_finite() && self.upper.is_finite()) {
            return Err(Fault::NotFinite { parameter: "range between stops" });
        }
        // Halves, for the ends may be as far apart as numbers go.
        let [lower, upper] = [self.lower, self.upper].map(|end| end.scale(T::Real::of(0.5)));
        positive("half the range between stops", upper - lower)?;
        positive("depth over which stops set in", self.depth)?;
        not_negative("stiffness of stops", self.stiffness)?;
        not_negative("damping of stops", self.damping.times_onto(T::one(), T::zero()))
    }
}

lift!(Stops<T, C> { lower, upper, stiffness, depth, damping });
