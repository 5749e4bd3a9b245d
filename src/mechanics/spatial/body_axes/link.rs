//! A rigid body in its own axes.

use super::loaded::OnLink;
use super::number::{
    Number, Triangle, Triple, apply_onto, cross_onto, dot_onto, masked, more, rows, scaled, triangle, triple, values,
};
use super::relation::{Alone, Local};
use super::through::Solid;
use crate::counts::Counted;
use crate::element::{Condense, Element, Given, Loading, OnBody, Posture, Sweep};
use crate::error::Fault;
use crate::error::checks::largest;
use crate::lift::Lift;
use crate::mechanics::spatial::{Acceleration, BodyMotion, Frame, Inertia, Spatial, Turn};
use crate::relation::Closures;
use crate::relation::spatial::Empty;
use crate::relation::spatial::algebra::{Columns, zero};
use crate::scalar::{Real, Scalar, apart};
use crate::shape::PostureOf;
use nalgebra::Vector3;
use num_traits::Zero;
use typenum::{U0, U1};

/// A rigid body of a robot. Its axes start at the joint that carries it, z along the axis of that joint; other joints sit on it wherever
/// they say, so that it has no outboard end of its own.
///
/// `MOMENT` and `TENSOR` say which numbers are there: of the mass centre x, y, z (bits 0 to 2), of the inertia tensor *about the origin*
/// xx, yy, zz, yz, xz, xy (bits 0 to 5). What is not there is zero and costs nothing; the defaults leave everything there.
///
/// ```
/// use catena::robot::Link;
/// // Mass (kg), mass centre (m), inertia tensor about it (kg·m²).
/// let plain = Link::general(4.0, [0.0, 0.03, 0.12], [[0.1, 0.0, 0.0], [0.0, 0.09, 0.0], [0.0, 0.0, 0.02]]);
/// // The same: of σ = m r_C only y and z are there, of J all moments and the product yz.
/// let link = Link::<f64, 0b110, 0b1111>::new(4.0, [0.0, 0.03, 0.12], [[0.1, 0.0, 0.0], [0.0, 0.09, 0.0], [0.0, 0.0, 0.02]]);
/// assert_eq!(link.inertia(), plain.inertia());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "T: Scalar + serde::Serialize", deserialize = "T: Scalar + serde::Deserialize<'de>"))
)]
#[cfg_attr(feature = "serde", serde(from = "Inertia<T>", into = "Inertia<T>"))]
pub struct Link<T, const MOMENT: u8 = 7, const TENSOR: u8 = 63> {
    inertia: Inertia<T>,
    /// m r_C (kg·m).
    moment: [T; 3],
    /// About the origin (kg·m²): xx, yy, zz, yz, xz, xy.
    tensor: [T; 6],
}

#[cfg(feature = "serde")]
impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> From<Inertia<T>> for Link<T, MOMENT, TENSOR> {
    fn from(Inertia { mass, centre, about_centre }: Inertia<T>) -> Self {
        Self::new(mass, centre, about_centre)
    }
}

#[cfg(feature = "serde")]
impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> From<Link<T, MOMENT, TENSOR>> for Inertia<T> {
    fn from(link: Link<T, MOMENT, TENSOR>) -> Self {
        link.inertia
    }
}

impl<T: Scalar> Link<T> {
    /// A body of which nothing is known to be zero: mass (kg), mass centre (m), inertia tensor about it (kg·m²).
    pub fn general(mass: T, centre: [T; 3], about_centre: [[T; 3]; 3]) -> Self {
        Self::new(mass, centre, about_centre)
    }
}

/// The bit of a tensor's mask that says that a link shares in rotors: its tensor may then be no body's.
pub const SHARING: u8 = 64;

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> Link<T, MOMENT, TENSOR> {
    /// Mass (kg), mass centre (m), inertia tensor about it (kg·m²). What the masks leave out must be zero but for rounding:
    /// [`System::new`](crate::system::System::new) refuses other bodies.
    pub fn new(mass: T, centre: [T; 3], about_centre: [[T; 3]; 3]) -> Self {
        let inertia = Inertia { mass, centre, about_centre };
        let about = inertia.about_inboard();
        let tensor = [about.xx, about.yy, about.zz, about.yz, about.xz, about.xy];
        Self { inertia, moment: centre.map(|x| x * mass), tensor }
    }

    /// This link, of a type that says of mass centre and tensor what is there: [`System::new`](crate::system::System::new)
    /// refuses it where a number is left out that is not zero, and without the bit 64 of `TENSOR` a link that shares in a
    /// [`Rotor`](super::Rotor), if no body is like it.
    pub fn masked<const M: u8, const S: u8>(self) -> Link<T, M, S> {
        let Self { inertia, moment, tensor } = self;
        Link { inertia, moment, tensor }
    }

    /// With a moment of inertia about an axis, which may be negative, once the body as it is has been found to be one.
    pub(super) fn sharing<const S: u8>(self, share: T, axis: [T; 3]) -> Result<Link<T, MOMENT, S>, Fault> {
        crate::shape::Body::<Spatial<T>>::check(&self)?;
        let Inertia { mass, centre, mut about_centre } = self.inertia;
        for (i, row) in about_centre.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry += share * axis[i.min(j)] * axis[i.max(j)];
            }
        }
        Ok(Link::new(mass, centre, about_centre))
    }

    /// Mass, mass centre and inertia tensor about it.
    pub fn inertia(&self) -> Inertia<T> {
        self.inertia
    }

    /// m r_C (kg·m), with what is known.
    #[inline(always)]
    pub(super) fn first_moment(&self) -> Triple<T> {
        masked(MOMENT, self.moment)
    }

    /// J about the origin (kg·m²), with what is known.
    #[inline(always)]
    pub(super) fn about_origin(&self) -> Triangle<T> {
        triangle(TENSOR, self.tensor)
    }

    /// Force ω × (ω × σ) (N) and torque ω × J ω (N·m) about the origin.
    #[cfg_attr(optimised, inline(always))]
    fn stirred(&self, spin: [T; 3]) -> [Triple<T>; 2] {
        let (spin, o) = (triple(spin), [Number::zero(); 3]);
        let momentum = apply_onto(&rows(&self.about_origin()), spin, o);
        [centripetal(spin, self.first_moment()), cross_onto(spin, momentum, o)]
    }

    #[inline(always)]
    pub(super) fn alone(&self, [force, torque]: [[T; 3]; 2]) -> Alone<T, MOMENT, TENSOR> {
        Alone { mass: self.inertia.mass, moment: self.moment, tensor: self.tensor, force, torque }
    }
}

/// ω × (ω × r) = ω (ω·r) − ω² r, whose square a link and what sits on it share.
#[cfg_attr(optimised, inline(always))]
pub(super) fn centripetal<T: Scalar>(spin: Triple<T>, r: Triple<T>) -> Triple<T> {
    let (along, square) = (dot_onto(spin, r, Number::zero()), dot_onto(spin, spin, Number::zero()));
    let [x, y, z] = scaled(spin, along);
    [square.times_off(r[0], x), square.times_off(r[1], y), square.times_off(r[2], z)]
}

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> Solid<T> for Link<T, MOMENT, TENSOR> {
    #[inline(always)]
    fn mass(&self) -> T {
        self.inertia.mass
    }
    #[inline(always)]
    fn moment(&self) -> Triple<T> {
        self.first_moment()
    }
    #[inline(always)]
    fn tensor(&self) -> Triangle<T> {
        self.about_origin()
    }
    #[inline(always)]
    fn gyroscopic(&self, spin: [T; 3]) -> [Triple<T>; 2] {
        self.stirred(spin)
    }
    #[cfg_attr(optimised, inline(always))]
    fn resisted(&self, [a, angular]: [Triple<T>; 2], [force, torque]: [Triple<T>; 2]) -> [Triple<T>; 2] {
        let (moment, mass) = (self.first_moment(), Number::of(self.inertia.mass));
        let force = cross_onto(angular, moment, more(force, mass, a));
        [force, cross_onto(moment, a, apply_onto(&rows(&self.about_origin()), angular, torque))]
    }
}

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> crate::shape::Body<Spatial<T>> for Link<T, MOMENT, TENSOR> {
    const OWN_AXES: bool = true;

    fn size(&self) {}
    #[inline(always)]
    fn shifted(&self, inboard: Acceleration<T>, _: PostureOf<'_, Spatial<T>>) -> Acceleration<T> {
        inboard
    }
    #[inline(always)]
    fn swung(&self, inboard: Acceleration<T>, _: PostureOf<'_, Spatial<T>>) -> Acceleration<T> {
        inboard
    }
    #[cfg_attr(optimised, inline(always))]
    fn motion(&self, inboard: Frame<T>) -> (BodyMotion<T>, Frame<T>) {
        let inertia = self.inertia;
        let to_centre = inboard.turn.attitude.apply(Vector3::from(inertia.centre));
        (BodyMotion { inboard, arm: zero(), to_centre, inertia }, inboard)
    }
    fn check(&self) -> Result<(), Fault> {
        if const { TENSOR & SHARING == 0 } {
            self.inertia.check()?
        } else {
            self.inertia.check_entries()?
        }
        let left_out = |mask: u8, list: &[T]| {
            let slack = largest(list.iter().copied()).scale(T::Real::EPSILON * T::Real::of(64.0)); // rounding of what makes them
            // Of a number that is zero derivatives count too; those of one that is rounding are rounding.
            let within = |x: T| (slack - x.abs()).if_negative(T::one(), T::zero()).real() == T::Real::zero();
            let none = |x: T| within(x) && (x.real() != T::Real::zero() || x.is_identical(T::zero()));
            list.iter().enumerate().all(|(bit, x)| mask >> bit & 1 == 1 || none(*x))
        };
        if !left_out(MOMENT, &self.moment) {
            return Err(Fault::NotZero { parameter: "mass centre, where its mask says so" });
        }
        if !left_out(TENSOR, &self.tensor) {
            return Err(Fault::NotZero { parameter: "inertia tensor, where its mask says so" });
        }
        Ok(())
    }
}

crate::shape::leaf!(body [T: Scalar, const MOMENT: u8, const TENSOR: u8] Link<T, MOMENT, TENSOR>: Spatial<T>);

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> Element<Spatial<T>> for Link<T, MOMENT, TENSOR> {
    type Position = ();
    type Rate = ();

    const ABSOLUTE: bool = false;

    fn lump(&mut self, _: T) -> T {
        T::zero() // joints on it have none to hand on
    }
    #[cfg_attr(optimised, inline(always))]
    fn orient(
        &self,
        _: &(),
        _: &(),
        turn: Turn<T>,
        _: &mut Columns<T>,
        y: &mut [Vector3<T>; 2],
        _: &mut Vector3<T>,
        _: &mut Vector3<T>,
    ) -> Turn<T> {
        apart::<T, _>(
            #[cfg_attr(optimised, inline(always))]
            || {
                let [force, torque] = self.stirred(turn.spin.into()).map(values);
                y[1] = Vector3::from(torque);
                if const { MOMENT & 7 != 0 } {
                    y[0] = Vector3::from(force);
                }
                turn
            },
        )
    }
    #[inline(always)]
    fn resolve((): &(), _: &mut Columns<T>, _: &mut [Vector3<T>; 2], _: &mut Vector3<T>, _: &mut Vector3<T>) {}
}

impl<T, const MOMENT: u8, const TENSOR: u8> Counted for Link<T, MOMENT, TENSOR> {
    type Bodies = U1;
    type Freedoms = U0;
}

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8, W> Condense<Spatial<T>, Empty, W> for Link<T, MOMENT, TENSOR>
where
    W: Sweep<Spatial<T>, Loads: Loading<Spatial<T>, OnBody: OnLink<T>>>,
{
    type Out = <OnBody<Spatial<T>, W> as OnLink<T>>::Alone<MOMENT, TENSOR>;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        _: Empty,
        posture: Posture<'_, Spatial<T>, Self>,
        given: Given<'_, Spatial<T>, Self, W>,
        (): &mut (),
    ) -> Self::Out {
        given.on_bodies.on_alone(self.alone([posture.y[0].into(), posture.y[1].into()]), given.springs)
    }
}

impl<T: Scalar, Q: Closures, const MOMENT: u8, const TENSOR: u8, W> Condense<Spatial<T>, Local<T, Q>, W>
    for Link<T, MOMENT, TENSOR>
where
    W: Sweep<Spatial<T>, Loads: Loading<Spatial<T>, OnBody: OnLink<T>>>,
{
    type Out = Local<T, Q>;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: Local<T, Q>,
        posture: Posture<'_, Spatial<T>, Self>,
        given: Given<'_, Spatial<T>, Self, W>,
        (): &mut (),
    ) -> Local<T, Q> {
        apart::<T, _>(
            #[cfg_attr(optimised, inline(always))]
            || {
                let relation = outer.with(self.alone([posture.y[0].into(), posture.y[1].into()]));
                given.on_bodies.on_others(relation, given.springs)
            },
        )
    }
}

impl<T: Scalar, U: Scalar, const MOMENT: u8, const TENSOR: u8> Lift<T, U> for Link<T, MOMENT, TENSOR> {
    type Over = Link<U, MOMENT, TENSOR>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        let Self { inertia, moment, tensor } = self;
        Link { inertia: inertia.lift(number), moment: moment.lift(number), tensor: tensor.lift(number) }
    }
}
