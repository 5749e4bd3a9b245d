//! Gradients of runs in the plane, along whatever parameters a scene is made of.

use super::Gradient;
use super::gradient::Asked;
use crate::adjoint::laws::{NUMBERS, ROTARY_NUMBERS};
use crate::adjoint::{BodyLaw, ReversibleTip};
use crate::driven::{Driven, MotionLaw};
use crate::element::Element;
use crate::ends::Root;
use crate::error::{Error, Fault};
use crate::guarded::{Guard, Guarded};
use crate::inner::{Drivable, Guardable};
use crate::lift::Lift;
use crate::mechanics::planar::adjoint::{BODY, LAW_NUMBERS, NUMBERS_OF_JOINT, numbers};
use crate::mechanics::planar::{
    Acceleration, Base, Body, ElasticHinge, Frame, HingeAxes, Linear, Pin, Planar, PointMass, RigidBody, Rod, Slider,
    Weld,
};
use crate::mirror::Mode;
use crate::scalar::{Elementary, Jet, Real, Scalar};
use crate::shape::{
    Around, AtClosing, Closing, Of, PerBody, PerJoint, Ref, Selective, Shape, Takes, Walk, alike_in_arms,
};
use crate::spring::SpringLaw;
use crate::system::{Elements, System};
use num_traits::{One, Zero};

/// Sums up what derivatives of parameters do to a cost.
pub struct Along<T, const K: usize> {
    pub(super) sum: [T; K],
    /// How many bodies and joints have been met.
    pub(super) met: usize,
    /// How many numbers of a joint costates know, and how many one has that has more.
    pub(super) beyond: Option<[usize; 2]>,
}

impl<T: Scalar, const K: usize> Along<T, K> {
    #[inline]
    pub(super) fn add(&mut self, costate: T, parameter: Jet<T, K>) {
        for (sum, part) in self.sum.iter_mut().zip(parameter.eps) {
            *sum += costate * part;
        }
    }

    /// Adds what a joint or a law does, number by number, as [`Lift`] meets them, of which so many are known, others among them; gives how many
    /// it has.
    pub(super) fn add_numbers(
        &mut self,
        item: &impl Lift<Jet<T, K>, T>,
        by: &[T],
        known: usize,
        others: usize,
    ) -> usize {
        let mut numbers = 0;
        item.lift(&mut |number: Jet<T, K>| {
            by.get(numbers).into_iter().for_each(|costate| self.add(*costate, number));
            numbers += 1;
            number.re
        });
        if numbers + others > known {
            self.beyond = self.beyond.or(Some([known, numbers + others]));
        }
        numbers
    }

    /// Adds what a joint does.
    pub(super) fn add_joint(&mut self, joint: &impl Lift<Jet<T, K>, T>, by: &[T]) {
        self.add_numbers(joint, by, NUMBERS, 0);
        self.met += 1;
    }

    /// Adds what a joint with two laws does: each has half of the numbers.
    pub(super) fn add_two(&mut self, laws: (&impl Lift<Jet<T, K>, T>, &impl Lift<Jet<T, K>, T>), by: &[T; NUMBERS]) {
        let (one, other) = by.split_at(LAW_NUMBERS);
        self.add_law(laws.0, one);
        self.add_law(laws.1, other);
        self.met += 1;
    }

    /// Adds what one of several laws of a joint does: each has a share of its numbers.
    pub(super) fn add_law(&mut self, law: &impl Lift<Jet<T, K>, T>, by: &[T]) {
        self.add_numbers(law, by, NUMBERS, NUMBERS - LAW_NUMBERS);
    }

    /// Adds what a joint with modes does while they stay: the friction of its slip, and its law. What a change of mode does is besides.
    pub(super) fn add_guarded(&mut self, friction: Jet<T, K>, law: &impl Lift<Jet<T, K>, T>, by: &[T]) {
        let Some((of_friction, of_law)) = by.split_first() else { return };
        self.add(*of_friction, friction);
        self.add_numbers(law, of_law, of_law.len().min(NUMBERS), 0);
    }

    /// Adds what a joint with a rotary law does.
    pub(super) fn add_rotary(&mut self, law: &impl Lift<Jet<T, K>, T>, by: &[T; ROTARY_NUMBERS]) {
        self.add_numbers(law, by, ROTARY_NUMBERS, 0);
        self.met += 1;
    }

    /// Adds what a tip does, number by number.
    pub(super) fn add_tip(&mut self, by: &[T], numbers: &[Jet<T, K>]) {
        by.iter().zip(numbers).for_each(|(costate, number)| self.add(*costate, *number));
    }

    /// Refuses scenes of another shape, and joints of more numbers than costates know.
    pub(super) fn complete(&self, entries: usize, met: usize) -> Result<(), Error> {
        if self.met != entries || self.met != met {
            return Err(Error::new(Fault::Shape));
        }
        match self.beyond {
            Some([expected, given]) => Err(Error::new(Fault::Count { list: "numbers of a joint", expected, given })),
            None => Ok(()),
        }
    }
}

/// Refuses ground over jets whose motion depends on seeds, but for an offset of its place and orientation that is the same at all times: gradients
/// know no more of it. `at` gives numbers of both kinds, offsets first.
pub(super) fn offset_alone<T: Scalar, const K: usize, const N: usize, const M: usize>(
    asked: Option<Asked<T::Real>>,
    at: impl Fn(T::Real) -> ([Jet<T, K>; N], [Jet<T, K>; M]),
) -> Result<(), Error> {
    let Some(asked) = asked else { return Ok(()) };
    let (offset, _) = at(asked.first);
    let slack = T::Real::EPSILON.sqrt();
    let alike = |a: T, b: T| (a - b).real().abs() <= slack * (T::Real::one() + a.real().abs());
    for time in asked.within() {
        let (now, moving) = at(time);
        let still = moving.iter().all(|x| x.eps.iter().all(|x| x.is_identical(T::zero())));
        if !(still && now.iter().zip(&offset).all(|(a, b)| a.eps.iter().zip(b.eps).all(|(a, b)| alike(*a, b)))) {
            return Err(Error::new(Fault::Unsupported { what: "the gradient by what moves the ground" }));
        }
    }
    Ok(())
}

/// Place and angle of the ground, and what has it move.
fn offset_and_motion<T: Scalar>(ground: Frame<T>) -> ([T; 3], [T; 6]) {
    let Frame { place, velocity, acceleration: Acceleration { linear, angular }, turn } = ground;
    ([place.x, place.y, turn.angle], [velocity.x, velocity.y, linear.x, linear.y, angular, turn.rate])
}

impl<T: Scalar, const K: usize> Walk<Planar<Jet<T, K>>> for Along<T, K> {
    type Carried = ();
    type Stores = (Ref<PerBody<Base<T>>>, Ref<PerBody<[T; BODY]>>, Ref<PerJoint<[T; NUMBERS_OF_JOINT]>>);
}

impl<T: Scalar, const K: usize> Selective<Planar<Jet<T, K>>> for Along<T, K> {
    alike_in_arms!();
}

impl<T: Scalar, K: Closing<Planar<Jet<T, N>>> + Lift<Jet<T, N>, T>, const N: usize> Around<Planar<Jet<T, N>>, K>
    for Along<T, N>
{
    fn around(
        &mut self,
        closing: &K,
        (): (),
        ((), (), by): AtClosing<'_, Planar<Jet<T, N>>, Self, K>,
        main: impl FnOnce(&mut Self, ()),
        side: impl FnOnce(&mut Self, ()),
    ) {
        main(self, ());
        side(self, ());
        self.add_joint(closing, by);
    }
}

macro_rules! bodies {
    ($($Body:ident),*) => {$(
        impl<T: Scalar, const K: usize> Takes<Planar<Jet<T, K>>, Along<T, K>> for $Body<Jet<T, K>> {
            fn take(
                &self,
                walk: &mut Along<T, K>,
                (): (),
                (by, by_numbers, ()): Of<'_, Planar<Jet<T, K>>, Along<T, K>, Self>,
            ) {
                let Base { outboard, moment, inertia, lumped } = self.base();
                for i in 0..2 {
                    walk.add(by.outboard[i], outboard[i]);
                    walk.add(by.moment[i], moment[i]);
                }
                walk.add(by.inertia, inertia);
                walk.add(by.lumped, lumped);
                by_numbers.iter().zip(numbers(self)).for_each(|(by, number)| walk.add(*by, number));
                walk.met += 1;
            }
        }
    )*};
}
bodies!(Rod, RigidBody, PointMass);

macro_rules! joints {
    ($([$($L:ident)?] $Joint:ty),*) => {$(
        impl<T: Scalar, const K: usize $(, $L)?> Takes<Planar<Jet<T, K>>, Along<T, K>> for $Joint
        where
            $($L: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,)?
        {
            fn take(&self, walk: &mut Along<T, K>, (): (), ((), (), by): Of<'_, Planar<Jet<T, K>>, Along<T, K>, Self>) {
                walk.add_joint(self, by);
            }
        }
    )*};
}

impl<T: Scalar, J, F, const K: usize> Takes<Planar<Jet<T, K>>, Along<T, K>> for Driven<J, F>
where
    J: Drivable<Planar<Jet<T, K>>> + Lift<Jet<T, K>, T>,
    F: MotionLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
{
    fn take(&self, walk: &mut Along<T, K>, (): (), ((), (), by): Of<'_, Planar<Jet<T, K>>, Along<T, K>, Self>) {
        walk.add_joint(self, by);
    }
}

impl<T: Scalar, J, G, L, const K: usize> Takes<Planar<Jet<T, K>>, Along<T, K>> for Guarded<J, G, L>
where
    J: Guardable<Planar<Jet<T, K>>> + Lift<Jet<T, K>, T>,
    G: Guard<Jet<T, K>>,
    L: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
{
    fn take(&self, walk: &mut Along<T, K>, (): (), ((), (), by): Of<'_, Planar<Jet<T, K>>, Along<T, K>, Self>) {
        let own = walk.add_numbers(self.joint(), by, NUMBERS, 0);
        walk.met += 1;
        walk.add_guarded(self.guard().resists(Mode::SlipsForward), self.law(), &by[own..]);
    }
}

joints!([] Pin, [] Weld<Jet<T, K>>, [L] ElasticHinge<L>, [L] Slider<Jet<T, K>, L>);

impl<T, R, X, Y, A, const K: usize> Takes<Planar<Jet<T, K>>, Along<T, K>>
    for ElasticHinge<R, Linear<Jet<T, K>, X, Y, A>>
where
    T: Scalar,
    R: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
    X: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
    Y: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
    A: HingeAxes,
{
    fn take(&self, walk: &mut Along<T, K>, (): (), ((), (), by): Of<'_, Planar<Jet<T, K>>, Along<T, K>, Self>) {
        let ((rotary, x, y), mass) = self.parts();
        let mut shares = by.chunks(LAW_NUMBERS);
        let mut next = || shares.next().unwrap_or_default();
        let (of_rotary, of_x, of_y) = (next(), next(), next());
        walk.add_law(rotary, of_rotary);
        walk.add_law(x, of_x);
        walk.add_law(y, of_y);
        next().iter().for_each(|by| walk.add(*by, mass));
        walk.met += 1;
    }
}

impl<T: Scalar, E: Element<Planar<T>>, L: BodyLaw<Planar<T>>> Gradient<Planar<T>, E, L> {
    /// The gradient along the seeds of a scene over jets, the same scene as that of the run: by whatever its constructor makes of them, lengths,
    /// masses, gravity, one thickness in sixty rods. The scene is built over jets once, whatever the length of the run.
    /// Its numbers have to be those of the run, which is not checked: a gradient keeps none.
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::scalar::{Jet, Scalar};
    /// /// Two rods of a length, in a field of gravity: over plain numbers, and over jets.
    /// macro_rules! pendulum {
    ///     ($length:expr, $mass:expr, $gravity:expr) => {{
    ///         let rod = Rod::uniform($length, $mass);
    ///         System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity($gravity)
    ///     }};
    /// }
    /// # let end_of = |length: f64| -> Result<f64, catena::Error> {
    /// #     let plain = pendulum!(length, 1.0, 9.81);
    /// #     let start = plain.at_rest(&[-1.0, -0.5])?;
    /// #     Ok(plain.simulate(start, Rk4::step(0.01), 1.0, |_| ())?.motion.coordinates()[1])
    /// # };
    /// let plain = pendulum!(1.0, 1.0, 9.81);
    /// let start = plain.at_rest(&[-1.0, -0.5])?;
    /// let (mut backward, mut states) = (plain.backward(Rk4), [start; 101]);
    /// backward.run(&start, 0.01, 100, &[], &mut states)?;
    /// let gradient = backward.gradient(&[], &states, &mut [], |step, _, by| {
    ///     if step == 100 { by.add(&[0.0, 1.0], &[0.0, 0.0]) } else { Ok(()) }
    /// })?;
    /// let seeded = pendulum!(Jet::<f64, 2>::seed(1.0, 0), Jet::of(1.0), Jet::seed(9.81, 1));
    /// let [by_length, by_gravity] = gradient.along(&seeded)?;
    /// # assert!((by_length - (end_of(1.0 + 1e-5)? - end_of(1.0 - 1e-5)?) / 2e-5).abs() < 1e-7);
    /// # assert!((by_gravity + gradient.by_gravity().y).abs() < 1e-14);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::Shape`] for another scene; [`Fault::Count`] for a joint of more than six numbers; [`Fault::Unsupported`] where the ground moves, and
    /// how it does depends on seeds: only a place and an angle that are added to that may.
    pub fn along<R, C, P, const K: usize>(&self, scene: &System<Planar<Jet<T, K>>, R, C, P>) -> Result<[T; K], Error>
    where
        R: Root<Planar<Jet<T, K>>>,
        C: Element<Planar<Jet<T, K>>>,
        P: ReversibleTip<Planar<Jet<T, K>>>,
        Elements<Planar<Jet<T, K>>, R, C>: Takes<Planar<Jet<T, K>>, Along<T, K>>
            + Shape<Planar<Jet<T, K>>, Store<PerBody<Base<T>>> = E::Store<PerBody<Base<T>>>>
            + Shape<Planar<Jet<T, K>>, Store<PerBody<[T; BODY]>> = E::Store<PerBody<[T; BODY]>>>
            + Shape<Planar<Jet<T, K>>, Store<PerJoint<[T; NUMBERS_OF_JOINT]>> = E::Store<PerJoint<[T; NUMBERS_OF_JOINT]>>>,
    {
        let mut walk = Along { sum: [T::zero(); K], met: 0, beyond: None };
        let elements = scene.elements();
        elements.take(&mut walk, (), (&self.bodies, &self.numbers, &self.joints));
        walk.complete(self.entries, scene.bodies() + scene.joints())?;
        let last = self.asked.map_or(Zero::zero(), |asked| asked.last);
        let ground = scene.ground(last);
        if const { !R::RESTS } {
            offset_alone(self.asked, |time| offset_and_motion(scene.ground(time)))?;
        }
        if const { !P::RESTS } {
            offset_alone(self.asked, |time| offset_and_motion(scene.tip().ground(time)))?;
        }
        walk.add(self.ground, ground.turn.angle);
        walk.add(self.place.x, ground.place.x);
        walk.add(self.place.y, ground.place.y);
        walk.add_tip(&self.tip, &scene.tip().numbers(last));
        walk.add(self.gravity.x, scene.gravity().x);
        walk.add(self.gravity.y, scene.gravity().y);
        Ok(walk.sum)
    }
}
