//! Gradients of runs past changes of mode, along whatever parameters a scene is made of.

use super::PastGradient;
use super::along::Along;
use super::backward::Acting;
use super::front::parts::OfNumbers;
use crate::adjoint::by_strut::ByStrut;
use crate::adjoint::force_elements::OfForce;
use crate::adjoint::struts::{OfStruts, ReversiblePoints};
use crate::adjoint::{BodyLaw, Costates, LoadCostates, Reversed, ReversibleTip};
use crate::couplings::Couplings;
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::lift::Lift;
use crate::loading::EffortOf;
use crate::loading::ForceElement;
use crate::mechanics::planar::Planar;
use crate::mechanics::spatial::Spatial;
use crate::mirror::Position;
use crate::motion::Motion;
use crate::relation::Closures;
use crate::scalar::{Jet, Scalar};
use crate::shape::{PerBody, PerJoint, Shape, Takes};
use crate::struts::{Strut, Struts};
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

/// Under struts.
impl<S, R, C, P, M, L, W, const D: usize, const N: usize> PastGradient<'_, S, R, C, P, M, Struts<S::Scalar, D, N, L, W>>
where
    S: ReversiblePoints<D>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    Struts<S::Scalar, D, N, L, W>: BodyLaw<S, OfNumbers = OfStruts<S::Scalar, D, N>>,
{
    /// By the numbers of each strut: [`Gradient::by_struts`](crate::sensitivity::Gradient::by_struts).
    pub fn by_struts(&self) -> &[ByStrut<S::Scalar, D>; N] {
        self.steps.by_struts()
    }

    /// The gradient along the seeds of the same struts over jets: [`Gradient::along_struts`](crate::sensitivity::Gradient::along_struts).
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::scalar::{Jet, Scalar};
    /// /// A hatch between two stops, and a strut of a stiffness (N/m) that lifts it onto the upper one.
    /// macro_rules! hatch {
    ///     ($stiffness:expr, $number:expr) => {{
    ///         let range = [-1.5, -0.2].map($number);
    ///         let hinge = HardStops::between(Revolute::smooth(), range).rebounding($number(0.4));
    ///         let lid = Rod::uniform($number(1.0), $number(6.0));
    ///         let scene = System::new(Clamped::origin(), (hinge, lid), Free)?.with_gravity($number(9.81));
    ///         let strut = Strut::to_ground((0, [0.4, 0.0].map($number)), [0.0, 0.3].map($number));
    ///         (scene, [strut.with_stiffness($stiffness).with_damping($number(20.0))])
    ///     }};
    /// }
    /// let (scene, struts) = hatch!(400.0, |x: f64| x);
    /// let mut backward = scene.backward(Dop853).under(Struts::of(struts));
    /// let course = backward.course(&scene.at_rest(&[-1.0])?, Dop853::tolerance(1e-12), 0.7, &[])?;
    /// let last = course.states().len() - 1;
    /// let gradient = backward.gradient_past(&course, &mut [], |step, _, by| {
    ///     if step == last { by.add(&[1.0], &[0.0]) } else { Ok(()) }
    /// })?;
    /// let [by_stiffness] = gradient.along_struts(&hatch!(Jet::<f64, 1>::seed(400.0, 0), Jet::<f64, 1>::of).1);
    /// # assert!(course.changes().count() > 1);
    /// # let end_of = |stiffness: f64| -> Result<f64, catena::Error> {
    /// #     let (scene, struts) = hatch!(stiffness, |x: f64| x);
    /// #     let loads = Struts::of(struts);
    /// #     let run = scene.simulation(Dop853::tolerance(1e-12)).loads(&loads);
    /// #     Ok(run.run(scene.at_rest(&[-1.0])?, 0.7, |_| ())?.motion.coordinates()[0])
    /// # };
    /// # let expected = (end_of(400.1)? - end_of(399.9)?) / 0.2;
    /// # assert!((by_stiffness - expected).abs() < 1e-5 * expected.abs(), "{by_stiffness} {expected}");
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn along_struts<V, const K: usize>(&self, struts: &[Strut<Jet<S::Scalar, K>, D, V>; N]) -> [S::Scalar; K]
    where
        V: Lift<Jet<S::Scalar, K>, S::Scalar, Over = W>,
    {
        self.steps.along_struts(struts)
    }
}

/// Where joints are coupled.
impl<S, R, C, P, M, L, X, const K: usize> PastGradient<'_, S, R, C, P, M, Couplings<S::Scalar, K, L>>
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    X: Clone,
    Couplings<S::Scalar, K, L>: BodyLaw<S, OfNumbers = ([[S::Scalar; K]; 2], X)>,
{
    /// By the ratio of each coupling, for one start: [`Gradient::by_ratios`](crate::sensitivity::Gradient::by_ratios).
    pub fn by_ratios(&self) -> &[S::Scalar; K] {
        self.steps.by_ratios()
    }

    /// By the offset of each coupling, for one start: [`Gradient::by_offsets`](crate::sensitivity::Gradient::by_offsets).
    pub fn by_offsets(&self) -> &[S::Scalar; K] {
        self.steps.by_offsets()
    }

    /// The gradient along the seeds of the same couplings over jets: [`Gradient::along_couplings`](crate::sensitivity::Gradient::along_couplings).
    pub fn along_couplings<Q, const J: usize>(&self, couplings: &Couplings<Jet<S::Scalar, J>, K, Q>) -> [S::Scalar; J] {
        self.steps.along_couplings(couplings)
    }
}

/// Where joints are coupled, under struts besides.
impl<S, R, C, P, M, L, W, const K: usize, const D: usize, const N: usize>
    PastGradient<'_, S, R, C, P, M, Couplings<S::Scalar, K, Struts<S::Scalar, D, N, L, W>>>
where
    S: ReversiblePoints<D>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    Couplings<S::Scalar, K, Struts<S::Scalar, D, N, L, W>>:
        BodyLaw<S, OfNumbers = ([[S::Scalar; K]; 2], OfStruts<S::Scalar, D, N>)>,
{
    /// By the numbers of each strut, as without couplings.
    pub fn by_struts(&self) -> &[ByStrut<S::Scalar, D>; N] {
        self.steps.by_struts()
    }

    /// The gradient along the seeds of the same struts over jets, as without couplings.
    pub fn along_struts<V, const J: usize>(&self, struts: &[Strut<Jet<S::Scalar, J>, D, V>; N]) -> [S::Scalar; J]
    where
        V: Lift<Jet<S::Scalar, J>, S::Scalar, Over = W>,
    {
        self.steps.along_struts(struts)
    }
}

/// Under a force element.
impl<S, R, C, P, M, F, L, X, const N: usize> PastGradient<'_, S, R, C, P, M, ForceElement<F, N, L>>
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    X: Clone,
    ForceElement<F, N, L>: BodyLaw<S, OfNumbers = (OfForce<S::Scalar>, X)>,
{
    /// By the numbers of its law: [`Gradient::by_force`](crate::sensitivity::Gradient::by_force).
    pub fn by_force(&self) -> &[S::Scalar] {
        self.steps.by_force()
    }

    /// The gradient along the seeds of the same law over jets: [`Gradient::along_force`](crate::sensitivity::Gradient::along_force).
    pub fn along_force<V, const K: usize>(&self, law: &V) -> [S::Scalar; K]
    where
        V: Lift<Jet<S::Scalar, K>, S::Scalar, Over = F>,
    {
        self.steps.along_force(law)
    }
}
