//! Gradients of runs in space, along whatever parameters a scene is made of.

use super::Gradient;
use super::along::{Along, offset_alone};
use crate::adjoint::laws::NUMBERS;
use crate::adjoint::{BodyLaw, ReversibleTip};
use crate::chain::Named;
use crate::driven::{Driven, MotionLaw};
use crate::element::Element;
use crate::ends::Root;
use crate::error::Error;
use crate::guarded::{Guard, Guarded};
use crate::inner::{Drivable, Guardable};
use crate::lift::Lift;
use crate::mechanics::spatial::adjoint::{BODY, numbers};
use crate::mechanics::spatial::axial::{Axial, aside};
use crate::mechanics::spatial::{
    Acceleration, Ball, Base, Cylindrical, ElasticHinge, Floating, Frame, Inertial, Linear, OfJoint, PointMass,
    Prismatic, Revolute, RigidBody, Rod, RotaryLaw, Spatial, Universal, Weld,
};
use crate::mirror::Mode;
use crate::relation::spatial::algebra::{Columns, cross, dot};
use crate::scalar::{Jet, Scalar};
use crate::shape::{
    Around, AtClosing, Closing, Of, PerBody, PerJoint, Ref, Selective, Shape, Takes, Walk, alike_in_arms,
};
use crate::spring::SpringLaw;
use crate::system::{Elements, System};
use nalgebra::Vector3;
use num_traits::Zero;

/// How an attitude turns with the seeds: a rotation vector in its own axes.
pub(super) fn turn<T: Scalar, const K: usize>(attitude: &Columns<Jet<T, K>>) -> Vector3<Jet<T, K>> {
    let still = |v: Vector3<Jet<T, K>>| v.map(|x| Jet::of(x.re));
    let Columns { x, y, z } = *attitude;
    Vector3::new(dot(still(z), y), dot(still(x), z), dot(still(y), x))
}

/// Place and turn of the ground, and what has it move.
fn offset_and_motion<T: Scalar, const K: usize>(ground: Frame<Jet<T, K>>) -> ([Jet<T, K>; 6], [Jet<T, K>; 12]) {
    let Frame { place, velocity: v, acceleration: Acceleration { linear: a, angular: b }, turn: at } = ground;
    let (turned, w) = (turn(&at.attitude), at.spin);
    let offset = [place.x, place.y, place.z, turned.x, turned.y, turned.z];
    (offset, [v.x, v.y, v.z, a.x, a.y, a.z, b.x, b.y, b.z, w.x, w.y, w.z])
}

impl<T: Scalar, const K: usize> Along<T, K> {
    /// Adds what an axis does, whose costates are by turns along the column beside it, and across that.
    fn add_axis(&mut self, axis: Vector3<Jet<T, K>>, [by_aside, by_across]: [T; 2]) {
        let still = |v: Vector3<Jet<T, K>>| v.map(|x| Jet::of(x.re));
        let (own, Columns { x, y, .. }) = (still(axis), Columns::identity());
        let [aside] = aside(axis, [x], [y]);
        let across = cross(own, aside);
        let turned = cross(own, axis) * dot(across, across).recip();
        self.add(by_aside, dot(turned, aside));
        self.add(by_across, dot(turned, across));
    }

    pub(super) fn add_vector(&mut self, costate: Vector3<T>, parameter: Vector3<Jet<T, K>>) {
        (0..3).for_each(|i| self.add(costate[i], parameter[i]));
    }
}

impl<T: Scalar, const K: usize> Walk<Spatial<Jet<T, K>>> for Along<T, K> {
    type Carried = ();
    type Stores = (Ref<PerBody<Base<T>>>, Ref<PerBody<[T; BODY]>>, Ref<PerJoint<OfJoint<T>>>);
}

impl<T: Scalar, const K: usize> Selective<Spatial<Jet<T, K>>> for Along<T, K> {
    alike_in_arms!();
}

macro_rules! bodies {
    ($($Body:ident),*) => {$(
        impl<T: Scalar, const K: usize> Takes<Spatial<Jet<T, K>>, Along<T, K>> for $Body<Jet<T, K>> {
            fn take(
                &self,
                walk: &mut Along<T, K>,
                (): (),
                (by, by_numbers, ()): Of<'_, Spatial<Jet<T, K>>, Along<T, K>, Self>,
            ) {
                let Base { outboard, moment, inertia, lumped } = self.base();
                by.outboard.iter().zip(by_numbers).zip(outboard).for_each(|((by, more), x)| walk.add(*by + *more, x));
                by_numbers.iter().zip(numbers(self)).skip(3).for_each(|(by, x)| walk.add(*by, x));
                by.moment.iter().zip(moment).for_each(|(by, x)| walk.add(*by, x));
                by.inertia.iter().zip(inertia).for_each(|(by, x)| walk.add(*by, x));
                walk.add(by.lumped, lumped);
                walk.met += 1;
            }
        }
    )*};
}
bodies!(Rod, RigidBody, PointMass);

/// A joint, between two bodies or to close a loop: what its numbers do to a cost.
pub trait Numbered<T: Scalar, const K: usize> {
    /// Adds what the numbers of the joint do.
    fn add_to(&self, walk: &mut Along<T, K>, by: &OfJoint<T>);
}

impl<T: Scalar, const K: usize> Numbered<T, K> for Ball {
    fn add_to(&self, walk: &mut Along<T, K>, _: &OfJoint<T>) {
        walk.met += 1;
    }
}

impl<T: Scalar, const K: usize, R: RotaryLaw<Jet<T, K>> + Lift<Jet<T, K>, T>> Numbered<T, K> for ElasticHinge<R> {
    fn add_to(&self, walk: &mut Along<T, K>, by: &OfJoint<T>) {
        walk.add_rotary(self.law(), &by.of_rotary());
    }
}

impl<T: Scalar, R, X, Y, Z, const K: usize> Numbered<T, K> for ElasticHinge<R, Linear<Jet<T, K>, X, Y, Z>>
where
    R: RotaryLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
    X: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
    Y: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
    Z: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
{
    fn add_to(&self, walk: &mut Along<T, K>, by: &OfJoint<T>) {
        let (mut of, (rotary, linear)) = (*by, self.parts());
        let ([of_x, of_y, of_z], (x, y, z)) = (of.of_linear(), linear.laws());
        walk.add_law(x, of_x);
        walk.add_law(y, of_y);
        walk.add_law(z, of_z);
        walk.add(by.more[0], linear.lumped());
        walk.add_rotary(rotary, &by.of_rotary());
    }
}

impl<T: Scalar, const K: usize> Numbered<T, K> for Floating<Jet<T, K>> {
    fn add_to(&self, walk: &mut Along<T, K>, by: &OfJoint<T>) {
        walk.add(by.more[0], self.lumped());
        walk.met += 1;
    }
}

impl<T: Scalar, const K: usize> Numbered<T, K> for Weld<Jet<T, K>> {
    fn add_to(&self, walk: &mut Along<T, K>, by: &OfJoint<T>) {
        walk.add_vector(by.turn, turn(self.attitude()));
        walk.met += 1;
    }
}

impl<T: Scalar, const K: usize, J: Numbered<T, K>> Numbered<T, K> for Named<J> {
    fn add_to(&self, walk: &mut Along<T, K>, by: &OfJoint<T>) {
        self.item.add_to(walk, by);
    }
}

impl<T: Scalar, const K: usize, L> Numbered<T, K> for Revolute<Jet<T, K>, L>
where
    L: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
{
    /// An axis that turns takes what lies outboard with it, but for the turn about it: there and, on the other side, back.
    fn add_to(&self, walk: &mut Along<T, K>, by: &OfJoint<T>) {
        let (axis, law) = self.parts();
        walk.add_axis(axis, [by.turn.x, by.turn.y]);
        walk.add_joint(law, &by.law);
    }
}

impl<T: Scalar, const K: usize, L> Numbered<T, K> for Prismatic<Jet<T, K>, L>
where
    L: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
{
    fn add_to(&self, walk: &mut Along<T, K>, by: &OfJoint<T>) {
        walk.add_axis(self.axis(), [by.turn.x, by.turn.y]);
        walk.add(by.more[0], Axial::lumped(self));
        walk.add_joint(self.law(), &by.law);
    }
}

impl<T: Scalar, const K: usize, L, M> Numbered<T, K> for Cylindrical<Jet<T, K>, L, M>
where
    L: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
    M: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
{
    fn add_to(&self, walk: &mut Along<T, K>, by: &OfJoint<T>) {
        walk.add_axis(self.axis(), [by.turn.x, by.turn.y]);
        walk.add(by.more[0], Axial::lumped(self));
        walk.add_two(self.laws(), &by.law);
    }
}

impl<T: Scalar, const K: usize, L, M> Numbered<T, K> for Universal<Jet<T, K>, L, M>
where
    L: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
    M: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
{
    fn add_to(&self, walk: &mut Along<T, K>, by: &OfJoint<T>) {
        let [first, second] = self.axes();
        walk.add_axis(first, [by.turn.x, by.turn.y]);
        walk.add_axis(second, by.more);
        walk.add_two(self.laws(), &by.law);
    }
}

impl<T: Scalar, J, F, const K: usize> Takes<Spatial<Jet<T, K>>, Along<T, K>> for Driven<J, F>
where
    J: Drivable<Spatial<Jet<T, K>>> + Numbered<T, K>,
    F: MotionLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
{
    fn take(&self, walk: &mut Along<T, K>, (): (), ((), (), by): Of<'_, Spatial<Jet<T, K>>, Along<T, K>, Self>) {
        self.joint().add_to(walk, by);
        walk.add_numbers(self.law(), &by.law, NUMBERS, 0);
    }
}

impl<T: Scalar, J, G, L, const K: usize> Takes<Spatial<Jet<T, K>>, Along<T, K>> for Guarded<J, G, L>
where
    J: Guardable<Spatial<Jet<T, K>>> + Numbered<T, K>,
    G: Guard<Jet<T, K>>,
    L: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
{
    fn take(&self, walk: &mut Along<T, K>, (): (), ((), (), by): Of<'_, Spatial<Jet<T, K>>, Along<T, K>, Self>) {
        self.joint().add_to(walk, by);
        walk.add_guarded(self.guard().resists(Mode::SlipsForward), self.law(), &by.law);
    }
}

macro_rules! joints {
    ($([$($L:ident)*] $Joint:ty),*) => {$(
        impl<T: Scalar, const K: usize $(, $L)*> Takes<Spatial<Jet<T, K>>, Along<T, K>> for $Joint
        where
            $($L: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,)*
        {
            fn take(&self, walk: &mut Along<T, K>, (): (), ((), (), by): Of<'_, Spatial<Jet<T, K>>, Along<T, K>, Self>) {
                self.add_to(walk, by);
            }
        }
    )*};
}
joints!([] Ball, [] Floating<Jet<T, K>>, [] Weld<Jet<T, K>>, [L] Revolute<Jet<T, K>, L>, [L] Prismatic<Jet<T, K>, L>);
joints!([L M] Cylindrical<Jet<T, K>, L, M>, [L M] Universal<Jet<T, K>, L, M>);

impl<T: Scalar, const K: usize, R: RotaryLaw<Jet<T, K>> + Lift<Jet<T, K>, T>> Takes<Spatial<Jet<T, K>>, Along<T, K>>
    for ElasticHinge<R>
{
    fn take(&self, walk: &mut Along<T, K>, (): (), ((), (), by): Of<'_, Spatial<Jet<T, K>>, Along<T, K>, Self>) {
        self.add_to(walk, by);
    }
}

impl<T: Scalar, R, X, Y, Z, const K: usize> Takes<Spatial<Jet<T, K>>, Along<T, K>>
    for ElasticHinge<R, Linear<Jet<T, K>, X, Y, Z>>
where
    R: RotaryLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
    X: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
    Y: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
    Z: SpringLaw<Jet<T, K>> + Lift<Jet<T, K>, T>,
{
    fn take(&self, walk: &mut Along<T, K>, (): (), ((), (), by): Of<'_, Spatial<Jet<T, K>>, Along<T, K>, Self>) {
        self.add_to(walk, by);
    }
}

impl<T: Scalar, J: Closing<Spatial<Jet<T, K>>> + Numbered<T, K>, const K: usize> Around<Spatial<Jet<T, K>>, J>
    for Along<T, K>
{
    fn around(
        &mut self,
        closing: &J,
        (): (),
        ((), (), by): AtClosing<'_, Spatial<Jet<T, K>>, Self, J>,
        main: impl FnOnce(&mut Self, ()),
        side: impl FnOnce(&mut Self, ()),
    ) {
        main(self, ());
        side(self, ());
        closing.add_to(self, by);
    }
}

impl<T: Scalar, E: Element<Spatial<T>>, L: BodyLaw<Spatial<T>>> Gradient<Spatial<T>, E, L> {
    /// The gradient along the seeds of a scene over jets, the same scene as that of the run: by whatever its constructor makes of them,
    /// lengths, tensors, axes, attitudes of welds and of the ground, gravity.
    /// Its numbers have to be those of the run, which is not checked: a gradient keeps none.
    ///
    /// ```
    /// use catena::scalar::{Jet, Scalar};
    /// use catena::spatial::*;
    /// /// Two rods of a length, over plain numbers and over jets.
    /// macro_rules! pendulum {
    ///     ($length:expr, $number:expr) => {{
    ///         let rod = Rod::uniform($length, $number(0.05), $number(1.0));
    ///         System::new(Pinned::on([0.0; 3].map($number)), (rod, Ball, rod), Free)?.with_gravity([0.0, 0.0, -9.81].map($number))
    ///     }};
    /// }
    /// # let end_of = |length: f64| -> Result<f64, catena::Error> {
    /// #     let plain = pendulum!(length, |x: f64| x);
    /// #     let start = plain.at_rest(&[0.1, 0.2, 0.3, -0.1, 0.4, 0.0])?;
    /// #     Ok(plain.simulate(start, Rk4::step(0.01), 0.5, |_| ())?.motion.rates()[4])
    /// # };
    /// let plain = pendulum!(1.0, |x: f64| x);
    /// let start = plain.at_rest(&[0.1, 0.2, 0.3, -0.1, 0.4, 0.0])?;
    /// let (mut backward, mut states) = (plain.backward(Rk4), [start; 51]);
    /// backward.run(&start, 0.01, 50, &[], &mut states)?;
    /// // Of a rate of the second ball at the end: attitudes have three derivatives each, by rotation vectors in axes of the body.
    /// let gradient = backward.gradient(&[], &states, &mut [], |step, _, by| {
    ///     if step == 50 { by.add(&[0.0; 6], &[0.0, 0.0, 0.0, 0.0, 1.0, 0.0]) } else { Ok(()) }
    /// })?;
    /// let [by_length] = gradient.along(&pendulum!(Jet::<f64, 1>::seed(1.0, 0), Jet::of))?;
    /// # assert!((by_length - (end_of(1.0 + 1e-5)? - end_of(1.0 - 1e-5)?) / 2e-5).abs() < 1e-6);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::Shape`](crate::Fault::Shape) for another scene; [`Fault::Count`](crate::Fault::Count) for a law of more than six numbers;
    /// [`Fault::Unsupported`](crate::Fault::Unsupported) where the ground moves, and how it does depends on seeds: only a place that is added to that
    /// may, and a turn before it.
    pub fn along<R, C, P, const K: usize>(&self, scene: &System<Spatial<Jet<T, K>>, R, C, P>) -> Result<[T; K], Error>
    where
        R: Root<Spatial<Jet<T, K>>>,
        C: Element<Spatial<Jet<T, K>>>,
        P: ReversibleTip<Spatial<Jet<T, K>>>,
        Elements<Spatial<Jet<T, K>>, R, C>: Takes<Spatial<Jet<T, K>>, Along<T, K>>
            + Shape<Spatial<Jet<T, K>>, Store<PerBody<Base<T>>> = E::Store<PerBody<Base<T>>>>
            + Shape<Spatial<Jet<T, K>>, Store<PerBody<[T; BODY]>> = E::Store<PerBody<[T; BODY]>>>
            + Shape<Spatial<Jet<T, K>>, Store<PerJoint<OfJoint<T>>> = E::Store<PerJoint<OfJoint<T>>>>,
    {
        let mut walk = Along { sum: [T::zero(); K], met: 0, beyond: None };
        scene.elements().take(&mut walk, (), (&self.bodies, &self.numbers, &self.joints));
        walk.complete(self.entries, scene.bodies() + scene.joints())?;
        let last = self.asked.map_or(Zero::zero(), |asked| asked.last);
        let ground = scene.ground(last);
        if const { !R::RESTS } {
            offset_alone(self.asked, |time| offset_and_motion(scene.ground(time)))?;
        }
        if const { !P::RESTS } {
            offset_alone(self.asked, |time| offset_and_motion(scene.tip().ground(time)))?;
        }
        walk.add_vector(self.ground, turn(&ground.turn.attitude));
        walk.add_vector(self.place, ground.place);
        walk.add_tip(&self.tip, &scene.tip().numbers(last));
        walk.add_vector(self.gravity, scene.gravity());
        Ok(walk.sum)
    }
}
