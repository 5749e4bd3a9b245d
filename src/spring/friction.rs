//! Dry friction without a jump.

use super::SpringLaw;
use crate::element::Springs;
use crate::error::Fault;
use crate::error::checks::{not_negative, positive};
use crate::lift::lift;
use crate::relation::{Absent, Coefficient};
use crate::scalar::{Real, Scalar};

/// Dry friction along a coordinate of a joint, without a jump: −F tanh(u̇/v) of the rate u̇, with the force F of sliding (N·m, N) and a
/// speed v (rad/s, m/s) below which it sets in. At rest there is none: what pulls by P < F creeps, by about v P/F.
///
/// With [`breaking_away`](Self::breaking_away) a greater force B holds at low speeds (the Stribeck effect), as in P. Brown and J. McPhee,
/// *A continuous velocity-based friction model for dynamics and control with physically meaningful parameters*, Journal of Computational
/// and Nonlinear Dynamics 11 (2016): (B − F) w / (¼ w² + ¾)² more, with w = u̇/(4 v), which is largest, B, at u̇ = 4 v.
///
/// The force is smooth, so all rules keep their order where steps resolve v. Explicit steps h are stable while h F/(v m) stays below 2 to
/// 3, with the inertia m that the coordinate moves; implicit ones know the slope, and are as stable as on a damper. Where the force of
/// breaking away falls off, from 4 v on, the slope is negative, by (B − F)/(9 v) at most (at 4√3 v): there h (B − F)/(9 v m) must stay well
/// below 1 for any rule. No energy comes of it.
///
/// ```
/// use catena::planar::*;
/// let (rod, friction) = (Rod::uniform(0.5, 1.0), DryFriction::new(0.2, 0.01)); // (N·m), (rad/s)
/// let chain = (rod, ElasticHinge::with((Spring::damping(0.05), friction)), rod);
/// let pendulum = System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81);
/// let run = pendulum.simulate(pendulum.at_rest(&[0.0, 0.5])?, Sdirk4::new().step(0.01), 2.0, |_| ())?;
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct DryFriction<T, B = Absent> {
    sliding: T,
    speed: T,
    /// By how much the force of breaking away exceeds that of sliding.
    excess: B,
}

impl<T: Scalar> DryFriction<T> {
    /// Of a force of sliding (N·m, N; zero or more) that sets in over a speed (rad/s, m/s).
    pub fn new(sliding: T, speed: T) -> Self {
        Self { sliding, speed, excess: Absent }
    }

    /// With a force at which it breaks away (N·m, N), not less than that of sliding.
    pub fn breaking_away(self, force: T) -> DryFriction<T, T> {
        DryFriction { sliding: self.sliding, speed: self.speed, excess: force - self.sliding }
    }
}

impl<T: Scalar, B: Coefficient<T>> SpringLaw<T> for DryFriction<T, B> {
    const ANALYTIC: bool = true;

    #[cfg_attr(optimised, inline(always))]
    fn force(&self, _: T, rate: T) -> T {
        let ratio = rate / self.speed;
        let w = ratio.scale(T::Real::of(0.25));
        let well = w.mul_add(w.scale(T::Real::of(0.25)), T::literal(0.75));
        self.excess.times_onto(-(w / (well * well)), -(self.sliding * ratio.tanh()))
    }
    fn energy(&self, _: T) -> T {
        T::zero()
    }
    #[cfg_attr(optimised, inline(always))]
    fn pivot(&self, _: T, rate: T, springs: impl Springs<T>) -> T {
        let ratio = rate / self.speed;
        let tanh = ratio.tanh();
        let w = ratio.scale(T::Real::of(0.25));
        let square = w * w;
        let well = square.scale(T::Real::of(0.25)) + T::literal(0.75);
        let bump = (T::one() - square).scale(T::Real::of(0.75)) / (well * well * well);
        let slope = self.sliding * (T::one() - tanh) * (T::one() + tanh);
        springs.pivot(Absent, self.excess.times_onto(bump.scale(T::Real::of(0.25)), slope) / self.speed)
    }
    fn check(&self) -> Result<(), Fault> {
        not_negative("dry friction", self.sliding)?;
        not_negative(
            "what dry friction breaks away at, beyond its force of sliding",
            self.excess.times_onto(T::one(), T::zero()),
        )?;
        positive("speed over which dry friction sets in", self.speed)
    }
}

lift!(DryFriction<T, B> { sliding, speed, excess });
