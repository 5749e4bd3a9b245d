//! Gradients of runs past changes of mode, along whatever parameters a scene is made of.

use super::PastGradient;
use super::along::Along;
use super::backward::Acting;
use super::front::parts::OfNumbers;
use crate::adjoint::{BodyLaw, Costates, LoadCostates, Reversed, ReversibleTip};
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::lift::Lift;
use crate::loading::EffortOf;
use crate::mechanics::planar::Planar;
use crate::mechanics::spatial::Spatial;
use crate::mirror::Position;
use crate::motion::Motion;
use crate::relation::Closures;
use crate::scalar::{Jet, Scalar};
use crate::shape::{PerBody, PerJoint, Shape, Takes};
use crate::system::{Elements, RateOf, Runs, System};
use crate::time::Explicit;

/// Derivatives of the elements of a scene, one for each body or joint.
type Bodies<S, R, C> = <Elements<S, R, C> as Shape<S>>::Store<PerBody<<S as Costates>::OfBody>>;
type Numbers<S, R, C> = <Elements<S, R, C> as Shape<S>>::Store<PerBody<<S as LoadCostates>::OfNumbers>>;
type Joints<S, R, C> = <Elements<S, R, C> as Shape<S>>::Store<PerJoint<<S as Costates>::OfJoint>>;

macro_rules! along {
    ($($Space:ident),*) => {$(
        impl<T, R, C, P, M, L> PastGradient<'_, $Space<T>, R, C, P, M, L>
        where
            T: Scalar,
            R: Root<$Space<T>>,
            C: Element<$Space<T>>,
            P: Tip<$Space<T>>,
            M: Explicit,
            L: BodyLaw<$Space<T>>,
        {
            /// The gradient along the seeds of a scene over jets, the same scene as that of the run: by whatever its constructor makes of them, as
            /// [`Gradient::along`](crate::sensitivity::Gradient::along), and by friction at which joints break away, by stops and what these give back.
            ///
            /// # Errors
            /// As [`Gradient::along`](crate::sensitivity::Gradient::along) and [`Backward::gradient_past`](crate::sensitivity::Backward::gradient_past).
            pub fn along<Y, Z, W, const K: usize>(
                &self,
                scene: &System<$Space<Jet<T, K>>, Y, Z, W>,
            ) -> Result<[T; K], Error>
            where
                Y: Root<$Space<Jet<T, K>>>,
                Z: Element<$Space<Jet<T, K>>>,
                W: ReversibleTip<$Space<Jet<T, K>>>,
                Elements<$Space<Jet<T, K>>, Y, Z>: Takes<$Space<Jet<T, K>>, Along<T, K>>
                    + Shape<$Space<Jet<T, K>>, Store<PerBody<<$Space<T> as Costates>::OfBody>> = Bodies<$Space<T>, R, C>>
                    + Shape<$Space<Jet<T, K>>, Store<PerBody<<$Space<T> as LoadCostates>::OfNumbers>> = Numbers<$Space<T>, R, C>>
                    + Shape<$Space<Jet<T, K>>, Store<PerJoint<<$Space<T> as Costates>::OfJoint>> = Joints<$Space<T>, R, C>>,
                L: Lift<T, Jet<T, K>, Over: BodyLaw<$Space<Jet<T, K>>>>,
                System<$Space<Jet<T, K>>, Y, Z, W>:
                    Runs<Acting<$Space<Jet<T, K>>, <L as Lift<T, Jet<T, K>>>::Over>, $Space<Jet<T, K>>, Y, Z, W>,
                EffortOf<$Space<T>>: OfNumbers<T>,
                EffortOf<$Space<Jet<T, K>>>: OfNumbers<Jet<T, K>>,
            {
                let (mut sum, more) = (self.steps.along(scene)?, self.changes_along(scene)?);
                sum.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
                Ok(sum)
            }
        }
    )*};
}
along!(Planar, Spatial);

impl<S: Reversed, R: Root<S>, C: Element<S>, P: Tip<S>, M, L: BodyLaw<S>> PastGradient<'_, S, R, C, P, M, L> {
    /// The gradient along the seeds of a start over jets, as far as that depends on them:
    /// [`Gradient::along_start`](crate::sensitivity::Gradient::along_start).
    ///
    /// # Errors
    /// As there.
    pub fn along_start<Q, X, const K: usize>(
        &self,
        start: &Motion<Jet<S::Scalar, K>, Q, X>,
    ) -> Result<[S::Scalar; K], Error>
    where
        Q: Position<Jet<S::Scalar, K>, Rate: Lift<Jet<S::Scalar, K>, S::Scalar, Over = RateOf<S, R, C>>>,
        X: Closures,
    {
        self.steps.along_start(start)
    }
}
