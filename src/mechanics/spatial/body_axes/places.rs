//! Where bodies are and how they move: places, Jacobians, mass centre, energy.

use super::number::{Number, Triple, dot_onto, triple, values};
use super::standing::{Stand, Standing};
use super::through::{Solid, Through, through};
use crate::relation::spatial::algebra::Columns;
use crate::scalar::Scalar;
use nalgebra::Vector3;

/// Where a body is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place<T> {
    /// The body's origin, on the axis of its joint (m).
    pub place: Vector3<T>,
    /// The body's axes in inertial axes, as columns; the joint's axis is z.
    pub attitude: Columns<T>,
}

/// Places of bodies, by their joints; the joint inboard of each; whether it slides.
pub struct Places<T, const N: usize> {
    pub stands: [Stand<T>; N],
    pub places: [Place<T>; N],
    pub parents: [usize; N],
    pub slides: [bool; N],
    pub next: usize,
}

through!([const N: usize] Places<T, N>, (Place<T>, usize), outward);

impl<T: Scalar> Place<T> {
    /// Where a point of the body is, which is given in its axes: such as a frame of a description.
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    /// let arm = System::new(Base::origin(), (Hinge::level().grounded(), link), Free)?;
    /// let [forearm] = arm.places(&[core::f64::consts::FRAC_PI_2])?;
    /// let found = forearm.point([0.3, 0.0, 0.5]);
    /// assert!((found - catena::nalgebra::Vector3::new(0.0, 0.3, 0.5)).norm() < 1e-15);
    /// # Ok::<(), catena::Error>(())
    /// ```
    #[inline(always)]
    pub fn point(&self, at: [T; 3]) -> Vector3<T> {
        self.attitude.apply_onto(Vector3::from(at), self.place)
    }

    /// The body on a joint.
    #[cfg_attr(optimised, inline(always))]
    pub fn beyond<A: Standing<T>>(&self, axis: &A, stand: Stand<T>) -> Self {
        let o = Number::zero();
        let out = if const { A::TURNS } { [o; 3] } else { axis.outward(stand, [o, o, Number::of(stand[1])]) };
        let arm = super::number::sum(axis.arm(), out);
        let (i, unit) =
            (Number::one(), |[x, y, z]: [Number<T>; 3]| Vector3::from(values(axis.outward(stand, [x, y, z]))));
        let axes = Columns { x: unit([i, o, o]), y: unit([o, i, o]), z: unit([o, o, i]) };
        Self {
            place: self.attitude.apply_onto(Vector3::from(values(arm)), self.place),
            attitude: self.attitude.times(&axes),
        }
    }
}

impl<T: Scalar, const N: usize> Through<T> for Places<T, N> {
    #[cfg_attr(optimised, inline(always))]
    fn axis<A: Standing<T>>(&mut self, axis: &A, (place, parent): (Place<T>, usize)) -> (Place<T>, usize) {
        let own = self.next;
        self.next += 1;
        let place = place.beyond(axis, self.stands[own]);
        (self.places[own], self.parents[own], self.slides[own]) = (place, parent, !A::TURNS);
        (place, own)
    }
    #[inline(always)]
    fn link<B: Solid<T>>(&mut self, _: &B, carried: (Place<T>, usize)) -> (Place<T>, usize) {
        carried
    }
}

/// The joint inboard of each.
pub struct Parents<const N: usize> {
    pub parents: [usize; N],
    pub next: usize,
}

through!([const N: usize] Parents<N>, usize, outward);

impl<T: Scalar, const N: usize> Through<T> for Parents<N> {
    #[cfg_attr(optimised, inline(always))]
    fn axis<A: Standing<T>>(&mut self, _: &A, parent: usize) -> usize {
        let own = self.next;
        self.next += 1;
        self.parents[own] = parent;
        own
    }
    #[inline(always)]
    fn link<B: Solid<T>>(&mut self, _: &B, own: usize) -> usize {
        own
    }
}

/// Joints on the way to a body: their places and axes, whether they slide, and where the body is; others are passed by.
pub struct Way<T, const N: usize> {
    pub positions: [T; N],
    pub met: [bool; N],
    pub joints: [[Vector3<T>; 2]; N],
    pub slides: [bool; N],
    pub end: Place<T>,
    pub next: usize,
}

through!([const N: usize] Way<T, N>, Place<T>, outward);

impl<T: Scalar, const N: usize> Through<T> for Way<T, N> {
    #[cfg_attr(optimised, inline(always))]
    fn axis<A: Standing<T>>(&mut self, axis: &A, place: Place<T>) -> Place<T> {
        let own = self.next;
        self.next += 1;
        if !self.met[own] {
            return place;
        }
        let place = place.beyond(axis, axis.stand(self.positions[own]));
        (self.joints[own], self.slides[own], self.end) = ([place.place, place.attitude.z], !A::TURNS, place);
        place
    }
    #[inline(always)]
    fn link<B: Solid<T>>(&mut self, _: &B, place: Place<T>) -> Place<T> {
        place
    }
}

/// Mass, first moment about the origin (inertial axes) and twice the kinetic energy of all links that move.
pub struct Tally<T, const N: usize> {
    pub stands: [Stand<T>; N],
    pub rates: [T; N],
    pub mass: T,
    pub moment: Vector3<T>,
    pub twice_kinetic: T,
    pub next: usize,
}

/// Place, velocity and angular velocity of a body, the two in its own axes.
pub type Moving<T> = (Place<T>, [[T; 3]; 2]);

through!([const N: usize] Tally<T, N>, Moving<T>, outward);

impl<T: Scalar, const N: usize> Through<T> for Tally<T, N> {
    #[cfg_attr(optimised, inline(always))]
    fn axis<A: Standing<T>>(&mut self, axis: &A, (place, [velocity, spin]): Moving<T>) -> Moving<T> {
        let (stand, rate) = (self.stands[self.next], self.rates[self.next]);
        self.next += 1;
        // Velocities are carried as accelerations are, without what rates alone cause.
        let none: Triple<T> = [Number::zero(); 3];
        let carried = axis.accelerated(stand, [none; 2], [triple(velocity), triple(spin)]);
        let [velocity, spin] = axis.moved(rate, carried);
        self.twice_kinetic += axis.inertia().value() * rate * rate;
        (place.beyond(axis, stand), [values(velocity), values(spin)])
    }
    #[cfg_attr(optimised, inline(always))]
    fn link<B: Solid<T>>(&mut self, link: &B, (place, [velocity, spin]): Moving<T>) -> Moving<T> {
        let moment = Vector3::from(values(link.moment()));
        self.mass += link.mass();
        self.moment = place.attitude.apply_onto(moment, place.place * link.mass() + self.moment);
        let (v, w, none) = (triple(velocity), triple(spin), [[Number::zero(); 3]; 2]);
        let [momentum, angular] = link.resisted([v, w], none);
        self.twice_kinetic += dot_onto(v, momentum, dot_onto(w, angular, Number::zero())).value();
        (place, [velocity, spin])
    }
}
