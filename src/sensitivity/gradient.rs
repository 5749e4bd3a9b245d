//! The gradient of a run.

use crate::adjoint::{BodyLaw, Reversed};
use crate::element::{Element, RealOf};
use crate::error::{Error, Fault, counted};
use crate::lift::Lift;
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::relation::{Absent, Additive, Closures};
use crate::scalar::{Jet, Real, Scalar};
use crate::shape::{PerBody, PerJoint};
use crate::walks::pull_loads::LAW;
#[cfg(feature = "alloc")]
use alloc::vec::Vec;
use num_traits::Zero;

/// Derivatives of a cost by the positions and rates of a motion, in the shape of the scene, and by its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Costate<R, T = f64> {
    /// By displacements of positions.
    pub position: R,
    /// By rates.
    pub rate: R,
    /// By the time (s) that the cost itself reads, not by that which loads read: it matters where a run ends at an event, and where a mode changes.
    pub time: T,
}

impl<R, T: Scalar> Costate<R, T> {
    /// Adds other ones.
    #[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
    pub(super) fn and(&mut self, others: &Self)
    where
        R: Rate<T>,
    {
        self.position.add(&others.position);
        self.rate.add(&others.rate);
        self.time += others.time;
    }

    /// Adds derivatives by positions and rates, plain lists of all joints from the root on.
    ///
    /// # Errors
    /// [`Fault::Count`](crate::Fault::Count) for lists of another length.
    pub fn add(&mut self, by_position: &[T], by_rate: &[T]) -> Result<(), Error>
    where
        R: Rate<T>,
    {
        for (costate, list) in [(&mut self.position, by_position), (&mut self.rate, by_rate)] {
            let mut expected = 0;
            costate.visit(&mut |_| expected += 1);
            counted("derivatives of the cost", expected, list.len())?;
            let mut list = list.iter();
            costate.replace(&mut |x| list.next().map_or(x, |more| x + *more));
        }
        Ok(())
    }
}

/// Times (s) of one after another asking, backward.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Asked<R> {
    pub(crate) last: R,
    pub(crate) first: R,
    /// The shortest time between two of them.
    shortest: R,
}

impl<R: Real> Asked<R> {
    /// These and one more.
    pub(super) fn and(before: Option<Self>, time: R) -> Self {
        let Some(Self { last, first, shortest }) = before else {
            return Self { last: time, first: time, shortest: R::INFINITY };
        };
        let apart = (time - first).abs();
        Self { last, first: time, shortest: if apart > R::zero() { shortest.min(apart) } else { shortest } }
    }

    /// Times of which two lie within any step, as far as there are no more than many.
    pub(super) fn within(self) -> impl Iterator<Item = R> {
        let range = self.last - self.first;
        let count = (2.0 * (range / self.shortest).as_f64()).clamp(FEW, MANY) as usize;
        // Shares that no period shares.
        (0..count).map(move |k| self.first + range * R::of((k as f64 + 0.618_033_988_749_895) / count as f64))
    }
}

/// Times at which ground over jets is looked at, at least and at most.
const FEW: f64 = 9.0;
const MANY: f64 = 65536.0;

/// The gradient of a cost by all that a run depends on, under loads `L` on bodies.
pub struct Gradient<S: Reversed, E: Element<S>, L: BodyLaw<S> = Absent> {
    /// By initial positions and rates; by the time of all motions at once.
    pub start: Costate<E::Rate, S::Scalar>,
    pub(crate) gravity: S::Vector,
    /// When ground that moves was asked where it is.
    pub(crate) asked: Option<Asked<RealOf<S>>>,
    /// By the place and the orientation of the ground.
    pub(crate) place: S::Vector,
    pub(crate) ground: S::Angular,
    /// By base parameters of bodies.
    pub(crate) bodies: E::Store<PerBody<S::OfBody>>,
    /// By numbers of bodies that loads read.
    pub(crate) numbers: E::Store<PerBody<S::OfNumbers>>,
    /// By numbers of the law of loads.
    pub(crate) law: L::OfNumbers,
    /// By parameters of joints.
    pub(crate) joints: E::Store<PerJoint<S::OfJoint>>,
    /// By numbers of the tip.
    pub(crate) tip: S::OfTip,
    /// Number of bodies and joints.
    pub(crate) entries: usize,
}

impl<S: Reversed, E: Element<S>, L: BodyLaw<S>> Gradient<S, E, L> {
    /// Nothing yet.
    pub(super) fn none(elements: &E, zero: &E::Rate, law: &L) -> Self {
        let (of_body, of_number, of_joint) = S::of_nothing();
        Self {
            start: Costate { position: zero.clone(), rate: zero.clone(), time: Additive::null() },
            gravity: S::Vector::null(),
            asked: None,
            place: S::Vector::null(),
            ground: S::Angular::null(),
            tip: S::no_tip(),
            law: law.of_nothing(),
            bodies: elements.store::<PerBody<_>>(of_body),
            numbers: elements.store::<PerBody<_>>(of_number),
            joints: elements.store::<PerJoint<_>>(of_joint),
            entries: elements.bodies() + elements.joints(),
        }
    }

    /// By gravity (m/s²), component by component.
    pub fn by_gravity(&self) -> S::Vector {
        self.gravity
    }

    /// By the numbers of the law of loads on bodies, in the order in which [`Lift`](crate::Lift) meets them; none where the
    /// run has no step.
    ///
    /// # Errors
    /// [`Fault::Count`](crate::Fault::Count) for a law of more than six.
    pub fn by_loads(&self) -> Result<&[S::Scalar], Error> {
        let (list, given) = L::listed(&self.law);
        list.get(..*given).ok_or(Error::new(Fault::Count { list: "numbers of a law", expected: LAW, given: *given }))
    }

    /// The gradient along the seeds of a start over jets, as far as that depends on them: by lengths at which it is
    /// [assembled](crate::system::System::assembled), by parameters of an equilibrium, or whatever else makes it. What
    /// [`along`](Self::along) finds of the scene is besides.
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::scalar::{Jet, Scalar};
    /// /// A pendulum, and where it begins: its second rod half a metre of arc below the horizontal, whatever the length of both.
    /// macro_rules! pendulum {
    ///     ($length:expr, $number:expr) => {{
    ///         let rod = Rod::uniform($length, $number(1.0));
    ///         let root = Pinned::at($number(0.0), $number(0.0));
    ///         let scene = System::new(root, (rod, Pin, rod), Free)?.with_gravity($number(9.81));
    ///         let start = scene.at_rest(&[$number(-1.0), $number(-0.5) / $length])?;
    ///         (scene, start)
    ///     }};
    /// }
    /// # let end_of = |length: f64| -> Result<f64, catena::Error> {
    /// #     let (scene, start) = pendulum!(length, |x: f64| x);
    /// #     Ok(scene.simulate(start, Rk4::step(0.01), 0.5, |_| ())?.motion.coordinates()[1])
    /// # };
    /// let (scene, start) = pendulum!(1.0, |x: f64| x);
    /// let (mut backward, mut states) = (scene.backward(Rk4), [start; 51]);
    /// backward.run(&start, 0.01, 50, &[], &mut states)?;
    /// let gradient = backward.gradient(&[], &states, &mut [], |step, _, by| {
    ///     if step == 50 { by.add(&[0.0, 1.0], &[0.0, 0.0]) } else { Ok(()) }
    /// })?;
    /// let (scene, start) = pendulum!(Jet::<f64, 1>::seed(1.0, 0), Jet::of);
    /// let by_length = gradient.along(&scene)?[0] + gradient.along_start(&start)?[0];
    /// # assert!((by_length - (end_of(1.0 + 1e-5)? - end_of(1.0 - 1e-5)?) / 2e-5).abs() < 1e-7);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::Shape`] for the motion of another scene.
    pub fn along_start<P, X, const K: usize>(
        &self,
        start: &Motion<Jet<S::Scalar, K>, P, X>,
    ) -> Result<[S::Scalar; K], Error>
    where
        P: Position<Jet<S::Scalar, K>, Rate: Lift<Jet<S::Scalar, K>, S::Scalar, Over = E::Rate>>,
        X: Closures,
    {
        let (mut still, mut displacement) = (start.position.clone(), start.rate.clone());
        still.replace(&mut |x| Jet::of(x.re));
        start.position.apart(&still, &mut displacement);
        let (mut sum, mut fits) = ([S::Scalar::zero(); K], true);
        for (list, by) in [(&displacement, &self.start.position), (&start.rate, &self.start.rate)] {
            for (k, sum) in sum.iter_mut().enumerate() {
                fits &= by.all(&list.lift(&mut |x| x.eps[k]), &mut |by, slope| {
                    *sum += by * slope;
                    true
                });
            }
        }
        if fits { Ok(sum) } else { Err(Error::new(Fault::Shape)) }
    }

    /// By the initial positions of all joints, root to tip, as a list.
    #[cfg(feature = "alloc")]
    pub fn by_position(&self) -> Vec<S::Scalar> {
        let mut list = Vec::new();
        self.start.position.visit(&mut |x| list.push(x));
        list
    }

    /// By their initial rates.
    #[cfg(feature = "alloc")]
    pub fn by_rate(&self) -> Vec<S::Scalar> {
        let mut list = Vec::new();
        self.start.rate.visit(&mut |x| list.push(x));
        list
    }
}
