//! Gradients of runs under struts.

use super::{Gradient, lifted};
use crate::adjoint::BodyLaw;
use crate::adjoint::by_strut::ByStrut;
use crate::adjoint::struts::{OfStruts, ReversiblePoints};
use crate::element::Element;
use crate::lift::Lift;
use crate::scalar::{Jet, Scalar};
use crate::struts::{Strut, Struts};

impl<S, E, L, W, const D: usize, const N: usize> Gradient<S, E, Struts<S::Scalar, D, N, L, W>>
where
    S: ReversiblePoints<D>,
    E: Element<S>,
    Struts<S::Scalar, D, N, L, W>: BodyLaw<S, OfNumbers = OfStruts<S::Scalar, D, N>>,
{
    /// By the numbers of each strut. Where its ends meet, those by its damping and its length read zero, if it has neither: there they have no
    /// derivative.
    pub fn by_struts(&self) -> &[ByStrut<S::Scalar, D>; N] {
        &self.law.0
    }

    /// The gradient along the seeds of the same struts over jets: by stiffnesses, places, or whatever else makes them.
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::scalar::{Jet, Scalar};
    /// /// Two rods, and a cable of a stiffness (N/m) from the tip to the ground.
    /// fn cable<T: Scalar>(stiffness: T) -> [Strut<T, 2>; 1] {
    ///     let at = [1.0, 0.0].map(T::literal);
    ///     [Strut::to_ground((1, at), [2.0, 1.0].map(T::literal)).with_stiffness(stiffness).with_length(T::literal(0.5))]
    /// }
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let mut states = [scene.at_rest(&[-1.0, -0.5])?; 101];
    /// let (start, mut backward) = (states[0], scene.backward(Rk4).under(Struts::of(cable(40.0))));
    /// backward.run(&start, 0.01, 100, &[], &mut states)?;
    /// let gradient = backward.gradient(&[], &states, &mut [], |step, _, by| {
    ///     if step == 100 { by.add(&[0.0, 1.0], &[0.0, 0.0]) } else { Ok(()) }
    /// })?;
    /// let [by_stiffness] = gradient.along_struts(&cable(Jet::<f64, 1>::seed(40.0, 0)));
    /// assert_eq!(by_stiffness, gradient.by_struts()[0].stiffness);
    /// # let end_of = |stiffness: f64| -> Result<f64, catena::Error> {
    /// #     let loads = Struts::of(cable(stiffness));
    /// #     let run = scene.simulation(Rk4::step(0.01)).loads(&loads).run(start, 1.0, |_| ())?;
    /// #     Ok(run.motion.coordinates()[1])
    /// # };
    /// # assert!((by_stiffness - (end_of(40.01)? - end_of(39.99)?) / 0.02).abs() < 1e-6 * by_stiffness.abs());
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn along_struts<V, const K: usize>(&self, struts: &[Strut<Jet<S::Scalar, K>, D, V>; N]) -> [S::Scalar; K]
    where
        V: Lift<Jet<S::Scalar, K>, S::Scalar, Over = W>,
    {
        along(self.by_struts(), struts)
    }
}

/// Derivatives by numbers of struts, along the seeds of the same over jets.
pub(super) fn along<T: Scalar, V: Lift<Jet<T, K>, T>, const D: usize, const N: usize, const K: usize>(
    by_struts: &[ByStrut<T, D>; N],
    struts: &[Strut<Jet<T, K>, D, V>; N],
) -> [T; K] {
    let mut all = *by_struts;
    lifted::along(all.iter_mut().flat_map(ByStrut::each_number).map(|by| *by), struts)
}
