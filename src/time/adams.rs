//! The predictor and corrector of Adams, Bashforth and Moulton.

use super::{Control, Rule};

/// Adams-Bashforth-Moulton, PECE: a predictor through the accelerations of the last four motions, a corrector through those and the
/// predicted one. Order 5, two sweeps a step, error control, steps of any size, dense output of order 5.
///
/// It remembers the motions it wrote, as long as they are handed back as they were. The first three steps of a run, and of one whose
/// motion was changed (derivative parts of dual numbers among it) or whose loads jumped between steps, are [`Dopri5`](super::Dopri5)'s,
/// which have order 5 as well and take six sweeps; so are steps more than twenty times as long as one of the last three, and steps that
/// turn round. Loads that jump within a step cost it its order, as they do all rules: end steps there.
///
/// It is for loops in real time, where each step has room for two sweeps. In a run that may choose its steps it takes from 0.7 to 1.5
/// times the sweeps of Dopri5 for the same error. Vibration of ω rad/s that nothing damps dies away up to
/// ω ΔT = 0.5 and grows beyond (0.25 a sweep; [`Rk4`](super::Rk4): 0.7): stiff hinges are not for it.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0);
/// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
/// let start = pendulum.at_rest(&[-1.0, -0.5])?;
/// let run = pendulum.simulate(start, Adams::step(0.01), 1.0, |_| ())?;
/// assert_eq!(run.sweeps, 3 * 6 + 97 * 2);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Adams;

impl Adams {
    /// Steps of a fixed size (s).
    pub fn step<R>(size: R) -> Rule<Self, R> {
        Rule { method: Self, control: Control::Fixed(size) }
    }
    /// Steps that keep the error of each within a tolerance, absolute (rad, m) and relative.
    pub fn tolerance<R>(tolerance: R) -> Rule<Self, R> {
        Rule { method: Self, control: Control::Tolerance(tolerance) }
    }
}

/// What accelerations at `K` nodes weigh in rates and, integrated twice, in positions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weights<const K: usize> {
    /// ∫ L_j from 0 to θ.
    pub rate: [f64; K],
    /// ∫ (θ − s) L_j from 0 to θ.
    pub position: [f64; K],
}

impl<const K: usize> Weights<K> {
    /// Of the polynomial through accelerations at `nodes` (shares of the step, no two alike) up to the share `theta`.
    pub fn new(nodes: &[f64; K], theta: f64) -> Self {
        // P = Π (s − s_i) = s^K + Σ all[k] s^k, factor by factor.
        let mut all = [0.0; K];
        for (degree, node) in nodes.iter().enumerate() {
            let mut lower = 0.0;
            for (k, coefficient) in all.iter_mut().enumerate().take(degree + 1) {
                let own = if k == degree { 1.0 } else { *coefficient };
                *coefficient = lower - node * own;
                lower = own;
            }
        }
        let mut weights = Self { rate: [0.0; K], position: [0.0; K] };
        for (j, node) in nodes.iter().enumerate() {
            // P / (s − s_j) by Horner's rule from the highest power down, whose value at s_j is P′(s_j), and its integrals.
            let (mut coefficient, mut slope) = (1.0, 0.0);
            let (mut once, mut twice) = (0.0, 0.0);
            for k in (0..K).rev() {
                slope = slope * node + coefficient;
                once = once * theta + coefficient / (k + 1) as f64;
                twice = twice * theta + coefficient / ((k + 1) * (k + 2)) as f64;
                coefficient = all[k] + node * coefficient;
            }
            weights.rate[j] = once * theta / slope;
            weights.position[j] = twice * theta * theta / slope;
        }
        weights
    }
}

#[cfg(test)]
mod tests {
    use super::Weights;

    fn near(found: f64, expected: f64) {
        assert!((found - expected).abs() < 4.0 * f64::EPSILON, "found {found}, expected {expected}");
    }

    #[test]
    fn equal_steps_have_the_classical_weights() {
        // E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, III.1, (1.5) and (1.9).
        let predictor = Weights::new(&[0.0, -1.0, -2.0, -3.0], 1.0);
        for (found, expected) in predictor.rate.into_iter().zip([55.0, -59.0, 37.0, -9.0]) {
            near(found, expected / 24.0);
        }
        let corrector = Weights::new(&[1.0, 0.0, -1.0, -2.0, -3.0], 1.0);
        for (found, expected) in corrector.rate.into_iter().zip([251.0, 646.0, -264.0, 106.0, -19.0]) {
            near(found, expected / 720.0);
        }
    }

    #[test]
    fn any_steps_integrate_polynomials_exactly() {
        let nodes = [1.0, 0.0, -0.4, -1.7, -2.0];
        for theta in [0.3, 1.0] {
            let Weights { rate, position } = Weights::new(&nodes, theta);
            for degree in 0..5 {
                let sum = |weights: [f64; 5]| -> f64 {
                    weights.iter().zip(nodes).map(|(weight, node)| weight * node.powi(degree)).sum()
                };
                let n = f64::from(degree);
                assert!((sum(rate) - theta.powi(degree + 1) / (n + 1.0)).abs() < 1e-14);
                assert!((sum(position) - theta.powi(degree + 2) / ((n + 1.0) * (n + 2.0))).abs() < 1e-14);
            }
        }
    }
}
