//! Gradients of runs whose joints are coupled.

use super::Gradient;
use super::struts::along;
use crate::adjoint::by_strut::ByStrut;
use crate::adjoint::struts::{OfStruts, ReversiblePoints};
use crate::adjoint::{BodyLaw, Reversed};
use crate::couplings::Couplings;
use crate::element::Element;
use crate::lift::Lift;
use crate::scalar::Jet;
use crate::struts::{Strut, Struts};
use num_traits::Zero;

impl<S, E, L, X, const K: usize> Gradient<S, E, Couplings<S::Scalar, K, L>>
where
    S: Reversed,
    E: Element<S>,
    X: Clone,
    Couplings<S::Scalar, K, L>: BodyLaw<S, OfNumbers = ([[S::Scalar; K]; 2], X)>,
{
    /// By the ratio of each coupling, for one start. By ratios as far as they make the start it is [`along_start`](Self::along_start).
    pub fn by_ratios(&self) -> &[S::Scalar; K] {
        &self.law.0[0]
    }

    /// By the offset of each coupling, for one start: zero but where something is held or closed, for there steps put followers back. As far as
    /// offsets make the start it is [`along_start`](Self::along_start).
    pub fn by_offsets(&self) -> &[S::Scalar; K] {
        &self.law.0[1]
    }

    /// The gradient along the seeds of the same couplings over jets.
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::scalar::{Jet, Scalar};
    /// /// Two fingers that close on each other by a ratio, and how they begin.
    /// macro_rules! hand {
    ///     ($ratio:expr, $number:expr) => {{
    ///         let (finger, joint) = (Rod::uniform($number(0.05), $number(0.02)), Revolute::smooth());
    ///         let chain = (Branch((joint.named("left"), finger)), joint.named("right"), finger);
    ///         let scene = System::new(Clamped::origin(), chain, Free)?.with_gravity($number(9.81));
    ///         let couplings = Couplings::of(&scene, [Coupling::new("right", "left").ratio($ratio)])?;
    ///         let start = couplings.joined(scene.at_rest(&[$number(0.3), $number(0.0)])?);
    ///         (scene, couplings, start)
    ///     }};
    /// }
    /// let (scene, couplings, start) = hand!(-0.9, |x: f64| x);
    /// let (mut backward, mut states) = (scene.backward(Rk4).under(couplings), [start; 51]);
    /// backward.run(&start, 1e-3, 50, &[], &mut states)?;
    /// let gradient = backward.gradient(&[], &states, &mut [], |step, _, by| {
    ///     if step == 50 { by.add(&[0.0, 1.0], &[0.0, 0.0]) } else { Ok(()) }
    /// })?;
    /// let (_, seeded, start) = hand!(Jet::<f64, 1>::seed(-0.9, 0), Jet::of);
    /// let by_ratio = gradient.along_couplings(&seeded)[0] + gradient.along_start(&start)?[0];
    /// # let end_of = |ratio: f64| -> Result<f64, catena::Error> {
    /// #     let (scene, couplings, start) = hand!(ratio, |x: f64| x);
    /// #     Ok(scene.simulation(Rk4::step(1e-3)).loads(&couplings).run(start, 0.05, |_| ())?.motion.coordinates()[1])
    /// # };
    /// # assert!((by_ratio - (end_of(-0.9 + 1e-5)? - end_of(-0.9 - 1e-5)?) / 2e-5).abs() < 1e-7);
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn along_couplings<Q, const J: usize>(&self, couplings: &Couplings<Jet<S::Scalar, J>, K, Q>) -> [S::Scalar; J] {
        let mut sum = [S::Scalar::zero(); J];
        let [by_ratios, by_offsets] = &self.law.0;
        for (numbers, by) in couplings.numbers().zip(by_ratios.iter().zip(by_offsets)) {
            for (number, by) in numbers.into_iter().zip([by.0, by.1]) {
                sum.iter_mut().zip(number.eps).for_each(|(sum, part)| *sum += *by * part);
            }
        }
        sum
    }
}

/// Beside struts.
impl<S, E, L, W, const K: usize, const D: usize, const N: usize>
    Gradient<S, E, Couplings<S::Scalar, K, Struts<S::Scalar, D, N, L, W>>>
where
    S: ReversiblePoints<D>,
    E: Element<S>,
    Couplings<S::Scalar, K, Struts<S::Scalar, D, N, L, W>>:
        BodyLaw<S, OfNumbers = ([[S::Scalar; K]; 2], OfStruts<S::Scalar, D, N>)>,
{
    /// By the numbers of each strut, as without couplings.
    pub fn by_struts(&self) -> &[ByStrut<S::Scalar, D>; N] {
        &self.law.1.0
    }

    /// The gradient along the seeds of the same struts over jets, as without couplings.
    pub fn along_struts<V, const J: usize>(&self, struts: &[Strut<Jet<S::Scalar, J>, D, V>; N]) -> [S::Scalar; J]
    where
        V: Lift<Jet<S::Scalar, J>, S::Scalar, Over = W>,
    {
        along(self.by_struts(), struts)
    }
}
