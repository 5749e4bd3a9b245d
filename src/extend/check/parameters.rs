//! Derivatives by the numbers that a scene is made of.

use super::trial::Trial;
use super::{Doubt, Dual, Over, Varied};
use crate::element::{Element, Space, SpaceOver, Unloaded};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::lift::Lift;
use crate::system::{Inertial, Runs, StiffDynamics, System, numbers};
use std::vec::Vec;

/// By which share of it a number is moved, or one that is zero by how much, and how derivatives may differ from differences.
const STEP: f64 = 1e-6;
const DIFFERENCES: f64 = 1e-5;

impl<S, R, C, P> Trial<'_, S, R, C, P>
where
    S: Inertial + Space<Scalar = f64> + SpaceOver<Dual>,
    R: Root<S> + Lift<f64, Dual, Over: Root<S::Over>>,
    C: Element<S> + Lift<f64, Dual, Over: Element<S::Over>>,
    P: Tip<S> + Lift<f64, Dual, Over: Tip<S::Over>>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P> + StiffDynamics<Unloaded>,
    Varied<S, R, C, P>: Runs<Unloaded, S::Over, Over<R>, Over<C>, Over<P>>,
{
    /// Derivatives of accelerations and energy by each number, and differences. At a kink those to one side will do.
    pub(super) fn parameters(&self) -> Result<(), Doubt> {
        let mut list = Vec::new();
        self.scene.lift(|x| {
            list.push(x);
            Dual::of(x)
        });
        for (k, number) in list.into_iter().enumerate().filter(|(_, number)| number.is_finite()) {
            let measure = if number == 0.0 { 1.0 } else { number.abs() };
            let step = STEP * measure;
            let [exact, ahead, back] = [[0.0, 1.0], [step, 0.0], [-step, 0.0]].map(|by| self.told(k, by));
            // A number that cannot be moved, of those that belong together, is no parameter.
            let (Ok(exact), Ok(ahead), Ok(back)) = (exact, ahead, back) else { continue };
            let size = exact.iter().fold(1.0_f64, |most, x| most.max(x.re.abs()).max(measure * x.eps[0].abs()));
            let what = "derivative by a number of the scene against differences: a number whose derivatives are lost";
            for (j, exact) in exact.iter().enumerate() {
                let (now, [ahead, back]) = (exact.re, [ahead[j].re, back[j].re]);
                let slopes = [0.5 * (ahead - back) / step, (ahead - now) / step, (now - back) / step];
                let error = DIFFERENCES * size / measure;
                let near = |slope: &&f64| (exact.eps[0] - **slope).abs() <= error;
                let expected = slopes.iter().find(near).unwrap_or(&slopes[0]);
                self.same(what, j, [exact.eps[0], *expected], error)?;
            }
        }
        Ok(())
    }

    /// Accelerations, and then the energy, of the scene with number `k` changed by a value and a derivative.
    fn told(&self, k: usize, [value, slope]: [f64; 2]) -> Result<Vec<Dual>, Error> {
        let mut number = 0;
        let scene = self.scene.lift(|x| {
            number += 1;
            if number == k + 1 { Dual { re: x + value, eps: [slope] } } else { Dual::of(x) }
        });
        let none: Vec<f64> = numbers(&self.motion.rate).iter().map(|_| 0.0).collect();
        let motion = scene.with_accelerations(self.seeded(&none, &none), &Unloaded)?;
        let mut told = numbers(&motion.acceleration);
        told.push(scene.budget(&motion)?.energy());
        Ok(told)
    }
}
