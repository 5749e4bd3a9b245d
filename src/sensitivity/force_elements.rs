//! Gradients of runs under force elements.

use super::Gradient;
use super::lifted::along;
use crate::adjoint::force_elements::OfForce;
use crate::adjoint::{BodyLaw, Reversed};
use crate::couplings::Couplings;
use crate::element::Element;
use crate::lift::Lift;
use crate::loading::ForceElement;
use crate::scalar::Jet;

impl<S, E, F, L, X, const N: usize> Gradient<S, E, ForceElement<F, N, L>>
where
    S: Reversed,
    E: Element<S>,
    ForceElement<F, N, L>: BodyLaw<S, OfNumbers = (OfForce<S::Scalar>, X)>,
    X: Clone,
{
    /// By the numbers of the law of a force element, in the order in which [`Lift`] meets them: 32 at most, for a run under a law of more has no gradient.
    pub fn by_force(&self) -> &[S::Scalar] {
        self.law.0.list()
    }

    /// The gradient along the seeds of the same law over jets.
    ///
    /// ```
    /// use catena::loading::ForceLaw;
    /// use catena::planar::*;
    /// use catena::scalar::{Jet, Scalar};
    /// /// Two magnets, in the middle of two bodies, that attract each other by a strength (N·m²) over their distance squared, switched on slowly.
    /// #[derive(Clone, Copy)]
    /// struct Magnets<T> {
    ///     strength: T,
    ///     pace: T,
    /// }
    /// catena::lift!(Magnets { strength, pace });
    /// impl<T: Scalar<Real = f64>> ForceLaw<Planar<T>, 2> for Magnets<T> {
    ///     fn loads(&self, time: f64, [a, b]: &[BodyMotion<T>; 2]) -> [Wrench<T>; 2] {
    ///         let middle = [T::literal(0.5), T::literal(0.0)];
    ///         let apart = b.point(middle).place - a.point(middle).place;
    ///         let square = apart.x * apart.x + apart.y * apart.y;
    ///         let on = T::literal(1.0) - (-self.pace * T::literal(time)).exp();
    ///         let pull = [apart.x, apart.y].map(|x| on * self.strength * x / (square * square.sqrt()));
    ///         [a.force_at(middle, pull), b.force_at(middle, pull.map(|x| -x))]
    ///     }
    /// }
    /// let (rod, law) = (Rod::uniform(1.0, 1.0), Magnets { strength: 2.0, pace: 3.0 });
    /// let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let mut states = [scene.at_rest(&[-1.0, -0.5])?; 51];
    /// let (start, mut backward) = (states[0], scene.backward(Rk4).under(ForceElement::by([0, 1], law)));
    /// backward.run(&start, 0.01, 50, &[], &mut states)?;
    /// let gradient = backward.gradient(&[], &states, &mut [], |step, _, by| {
    ///     if step == 50 { by.add(&[0.0, 1.0], &[0.0, 0.0]) } else { Ok(()) }
    /// })?;
    /// let [by_pace] = gradient.along_force(&Magnets { strength: Jet::<f64, 1>::of(2.0), pace: Jet::seed(3.0, 0) });
    /// assert_eq!(by_pace, gradient.by_force()[1]);
    /// # let end_of = |pace: f64| -> Result<f64, catena::Error> {
    /// #     let loads = ForceElement::by([0, 1], Magnets { pace, ..law });
    /// #     Ok(scene.simulation(Rk4::step(0.01)).loads(&loads).run(start, 0.5, |_| ())?.motion.coordinates()[1])
    /// # };
    /// # assert!((by_pace - (end_of(3.001)? - end_of(2.999)?) / 0.002).abs() < 1e-6 * by_pace.abs());
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn along_force<V: Lift<Jet<S::Scalar, K>, S::Scalar, Over = F>, const K: usize>(
        &self,
        law: &V,
    ) -> [S::Scalar; K] {
        along(self.by_force().iter().copied(), law)
    }
}

/// Beside couplings.
impl<S, E, F, L, X, const N: usize, const J: usize> Gradient<S, E, Couplings<S::Scalar, J, ForceElement<F, N, L>>>
where
    S: Reversed,
    E: Element<S>,
    Couplings<S::Scalar, J, ForceElement<F, N, L>>:
        BodyLaw<S, OfNumbers = ([[S::Scalar; J]; 2], (OfForce<S::Scalar>, X))>,
    X: Clone,
{
    /// By the numbers of the law of a force element, as without couplings.
    pub fn by_force(&self) -> &[S::Scalar] {
        self.law.1.0.list()
    }

    /// The gradient along the seeds of the same law over jets, as without couplings.
    pub fn along_force<V: Lift<Jet<S::Scalar, K>, S::Scalar, Over = F>, const K: usize>(
        &self,
        law: &V,
    ) -> [S::Scalar; K] {
        along(self.by_force().iter().copied(), law)
    }
}
