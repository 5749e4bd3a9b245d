//! The predictor and corrector of Adams, Bashforth and Moulton of variable order.

use super::{Control, Rule};

/// The highest order of a predictor. Its corrector has one more.
pub(crate) const MOST: usize = 12;

/// Coefficients of a step: as many as differences a predictor and the estimate of one order more can read, and one.
pub(crate) const TERMS: usize = MOST + 2;

/// Adams-Bashforth-Moulton with variable coefficients, of order 1 to 12 as the motion asks for: one sweep a step. For few sweeps where
/// sweeps are dear.
///
/// Under error control a predictor through accelerations of up to twelve motions, one sweep where it leads, and a corrector of one order
/// more; size and order of the next step follow from the errors that orders beside its own would have had. Its accelerations are those
/// where the predictor has led: a run finds the true ones for whoever reads them, and
/// [`with_accelerations`](crate::system::System::with_accelerations) those of its last motion. Dense output of the corrector's order.
///
/// Sweeps that a run takes for an error (rad) of its coordinates, as a share of those by [`Dop853`](super::Dop853):
///
/// | error | 1e-3 | 1e-5 | 1e-7 | 1e-9 | 1e-11 |
/// |---|---|---|---|---|---|
/// | two rods on pins, released from the horizontal, 2 s | 0.42 | 0.42 | 0.44 | 0.37 | 0.32 |
/// | twenty such rods, 0.5 s | 0.39 | 0.35 | 0.39 | 0.39 | 0.39 |
/// | three rods, a motor and dampers in their joints | 0.60 | 0.57 | 0.70 | 0.48 | 0.42 |
/// | three rods on springs that vibrate | 0.52 | 0.48 | 0.44 | 0.34 | 0.27 |
/// | a four-bar, closed by a network | 0.25 | 0.30 | 0.37 | 0.37 | 0.34 |
/// | three rods on balls in space | 0.34 | 0.48 | 0.40 | 0.34 | 0.34 |
///
/// What a step does beside its sweep is not little: some 1400 instructions, whatever the scene, and 90 a body of the plane (x86-64-v3);
/// tips and loops are put back where they are held at each step, and attitudes turned to the axes of each step. So twenty rods take 0.6 to
/// 0.7 of the time of a run by `Dop853`, three revolutes in space 0.7 to 1, but **two or three bodies 1.3 to 2.5 times as long**: there
/// `Dop853` is quicker unless loads are dear. Damping that is stiff holds it to short steps as it does any explicit rule: as many sweeps.
///
/// Steps of a given size (one that a program chooses, or `step`) take two sweeps and have the highest order allowed, with a corrector of
/// one more; while too little is remembered they are `Dop853`'s. Vibration limits them: the higher the order, the shorter they must be.
///
/// It remembers motions as long as they are handed back as they were, and begins anew where loads have jumped. Near places where closures
/// become dependent of each other `Dop853` makes the steps in its stead. Ladders of windows that fold up three times in two seconds, of 240
/// starts: none ends in an error at 1e-6 to 1e-13 (by `Dop853` none, either; at 1e-14 some do by both), with 0.94, 0.77, 0.59 of its sweeps
/// at 1e-6, 1e-9, 1e-12 in the mean, and at most 2.1, 1.0, 0.8.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0_f64, 1.0);
/// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
/// let start = pendulum.at_rest(&[-1.0, -0.5])?;
/// let run = pendulum.simulate(start, Vcabm::new().tolerance(1e-9), 2.0, |_| ())?;
/// let other = pendulum.simulate(start, Dop853::tolerance(1e-9), 2.0, |_| ())?;
/// assert!(2 * run.sweeps < other.sweeps);
/// assert!((run.motion.position().0 - other.motion.position().0).abs() < 1e-7);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(from = "UpTo", into = "UpTo"))]
pub struct Vcabm {
    most: usize,
}

/// The method as it is written.
#[cfg(feature = "serde")]
#[derive(serde::Serialize, serde::Deserialize)]
struct UpTo {
    order: usize,
}

#[cfg(feature = "serde")]
impl From<UpTo> for Vcabm {
    fn from(UpTo { order }: UpTo) -> Self {
        Self::new().up_to(order)
    }
}

#[cfg(feature = "serde")]
impl From<Vcabm> for UpTo {
    fn from(method: Vcabm) -> Self {
        Self { order: method.most }
    }
}

impl Default for Vcabm {
    fn default() -> Self {
        Self::new()
    }
}

impl Vcabm {
    /// Of orders up to 12.
    pub const fn new() -> Self {
        Self { most: MOST }
    }

    /// Of orders up to this one, from 1 to 12.
    #[must_use]
    pub const fn up_to(self, order: usize) -> Self {
        let most = if order < 1 { 1 } else { order };
        Self { most: if most > MOST { MOST } else { most } }
    }

    /// The highest order.
    pub const fn most(self) -> usize {
        self.most
    }

    /// Steps of a fixed size (s), of the highest order.
    pub fn step<R>(self, size: R) -> Rule<Self, R> {
        Rule { method: self, control: Control::Fixed(size) }
    }

    /// Steps that keep the error of each within a tolerance, absolute (rad, m) and relative.
    pub fn tolerance<R>(self, tolerance: R) -> Rule<Self, R> {
        Rule { method: self, control: Control::Tolerance(tolerance) }
    }
}

/// 1, 1/2, 1/3 and so on: as many as there are coefficients and one, in blocks of four.
const RECIPROCALS: [f64; 17] = {
    let (mut all, mut q) = ([0.0; 17], 0);
    while q < 17 {
        all[q] = 1.0 / (q + 1) as f64;
        q += 1;
    }
    all
};

/// Coefficients of a step from n to n + 1 after steps of any size (L. F. Shampine, M. K. Gordon, Computer Solution of Ordinary
/// Differential Equations, 1975, chapter 5): of modified divided differences φᵢ of accelerations. ψᵢ is the time from the end of a step
/// back over i steps; c₁ = 1, c₂ = s, cᵢ₊₁(s) = (1 − (1 − s) h / ψᵢ) cᵢ(s) at the share s of the step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Coefficients {
    /// Sizes of the steps: the one to be made, then those before, newest first.
    sizes: [f64; TERMS],
    /// For how many differences.
    count: usize,
    /// βᵢ = ∏ ψⱼ(n + 1) / ψⱼ(n), j < i: what a difference weighs in those of the next step.
    pub scale: [f64; TERMS],
    /// h / ψᵢ(n + 1).
    share: [f64; TERMS],
    /// ∫ cᵢ and ∫∫ cᵢ over the step.
    pub whole: Integrals,
}

/// Integrals of cᵢ up to a share of the step, once and twice.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Integrals {
    pub once: [f64; TERMS],
    pub twice: [f64; TERMS],
}

impl Coefficients {
    pub const fn none() -> Self {
        let zero = [0.0; TERMS];
        let whole = Integrals { once: zero, twice: zero };
        Self { sizes: zero, count: 0, scale: zero, share: zero, whole }
    }

    /// Takes those of a step of this size after `sizes`, newest first, for `count` differences and the integrals of one more. Steps of one
    /// size share theirs.
    pub fn update(&mut self, size: f64, sizes: &[f64], count: usize) {
        let mut all = [0.0; TERMS];
        all[0] = size;
        for (to, from) in all[1..count.min(TERMS)].iter_mut().zip(sizes) {
            *to = *from;
        }
        if self.sizes == all && self.count == count {
            return;
        }
        (self.sizes, self.count) = (all, count);
        // Loops of one length, which registers hold side by side; what lies beyond the count is never read.
        let (mut after, mut before) = ([0.0; TERMS], [0.0; TERMS]);
        (after[0], before[0]) = (all[0], all[1]);
        for i in 1..TERMS {
            after[i] = after[i - 1] + all[i];
            before[i] = after[i - 1] + all[i] - all[0] + if i + 1 < TERMS { all[i + 1] } else { 0.0 };
        }
        let mut ratio = [0.0; TERMS];
        for i in 0..TERMS {
            self.share[i] = size / after[i];
            ratio[i] = after[i] / before[i];
        }
        self.scale[0] = 1.0;
        for i in 1..TERMS {
            self.scale[i] = self.scale[i - 1] * ratio[i - 1];
        }
        // Nor is it kept: of one difference it would be infinite, which is no data.
        self.scale[count.clamp(1, TERMS)..].fill(0.0);
        self.whole = self.all();
    }

    /// Integrals over the whole step: q of cᵢ₊₁, times (q − 1)!, are those of cᵢ less h/ψᵢ of the next.
    fn all(&self) -> Integrals {
        let mut integrals = Integrals { once: [0.0; TERMS], twice: [0.0; TERMS] };
        let mut of = RECIPROCALS;
        // In blocks that registers hold, of which the last rounds need two: nothing is read that was written in the same round.
        let rounds = (self.count + 1).min(TERMS);
        let wide = rounds.saturating_sub(8);
        macro_rules! rounds {
            ($range:expr, $blocks:expr) => {
                for i in $range {
                    (integrals.once[i], integrals.twice[i]) = (of[0], of[1]);
                    let share = self.share[i];
                    for block in $blocks {
                        let next: [f64; 5] = core::array::from_fn(|q| of[block + q]);
                        for q in 0..4 {
                            of[block + q] = next[q] - share * next[q + 1];
                        }
                    }
                }
            };
        }
        rounds!(0..wide, [0, 4, 8, 12]);
        rounds!(wide..rounds, [0, 4]);
        integrals
    }

    /// Integrals up to a share: I_q of cᵢ₊₁, q times, is (1 − (1 − θ) h/ψᵢ) I_q − q h/ψᵢ I_{q+1} of cᵢ.
    pub fn up_to(&self, theta: f64) -> Integrals {
        let mut integrals = Integrals { once: [0.0; TERMS], twice: [0.0; TERMS] };
        let mut of = [0.0; TERMS + 3];
        let mut power = 1.0;
        for (q, integral) in of.iter_mut().enumerate().skip(1) {
            power *= theta / q as f64;
            *integral = power;
        }
        (integrals.once[0], integrals.twice[0]) = (of[1], of[2]);
        for i in 1..(self.count + 1).min(TERMS) {
            let share = self.share[i - 1];
            let kept = 1.0 - share * (1.0 - theta);
            for q in 1..=self.count + 2 - i {
                of[q] = kept * of[q] - share * q as f64 * of[q + 1];
            }
            (integrals.once[i], integrals.twice[i]) = (of[1], of[2]);
        }
        integrals
    }
}

#[cfg(test)]
mod tests {
    use super::{Coefficients, MOST, TERMS};

    /// Newton's polynomials Π (s − s_k) over past nodes s_k ≤ 0, each of which has one modified divided difference that is not zero, are
    /// integrated exactly: their coefficients are positive, and their own integrals lose no digits.
    #[test]
    fn any_steps_integrate_polynomials_exactly() {
        let sizes = [0.7, 1.0, 1.3, 0.5, 0.9, 1.1, 0.8, 1.0, 1.2, 0.6, 1.0, 0.9, 1.4]; // the step, and those before
        let mut coefficients = Coefficients::none();
        coefficients.update(sizes[0], &sizes[1..], MOST);
        let mut nodes = [0.0; MOST]; // as shares of the step
        for i in 1..MOST {
            nodes[i] = nodes[i - 1] - sizes[i] / sizes[0];
        }
        let (mut polynomial, mut length) = ([0.0; TERMS], 1.0);
        polynomial[0] = 1.0;
        for level in 0..MOST {
            if level > 0 {
                length *= nodes[0] - nodes[level];
                for q in (0..=level).rev() {
                    let lower = if q > 0 { polynomial[q - 1] } else { 0.0 };
                    polynomial[q] = lower - nodes[level - 1] * polynomial[q];
                }
            }
            for theta in [0.3_f64, 1.0] {
                let integrals = coefficients.up_to(theta);
                let (mut once, mut twice) = (0.0, 0.0);
                for (q, coefficient) in polynomial.iter().enumerate() {
                    let (n, power) = (q as f64, theta.powi(q as i32 + 1));
                    once += coefficient * power / (n + 1.0);
                    twice += coefficient * power * theta / ((n + 1.0) * (n + 2.0));
                }
                for (weight, exact) in [(integrals.once[level], once), (integrals.twice[level], twice)] {
                    let found = weight * coefficients.scale[level] * length;
                    assert!((found - exact).abs() < 1e-12 * exact, "{level} {theta}: {found} {exact}");
                }
            }
        }
    }

    #[test]
    fn equal_steps_have_the_classical_coefficients() {
        // E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, III.1, table 1.1: γ of the explicit methods.
        let mut coefficients = Coefficients::none();
        coefficients.update(0.1, &[0.1; TERMS], 8);
        let gamma =
            [1.0, 1.0 / 2.0, 5.0 / 12.0, 3.0 / 8.0, 251.0 / 720.0, 95.0 / 288.0, 19087.0 / 60480.0, 5257.0 / 17280.0];
        for (found, expected) in coefficients.whole.once.iter().zip(gamma) {
            assert!((found - expected).abs() < 1e-14);
        }
        assert!(coefficients.scale[..8].iter().all(|scale| (scale - 1.0).abs() < 1e-14));
    }
}
