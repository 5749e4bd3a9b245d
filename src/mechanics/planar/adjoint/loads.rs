//! The costate sweep in the plane: loads on bodies that depend on the motion.
//!
//! A load f, m about the inboard end I takes W_I·f + w m from the virtual power P. Its derivatives by what it reads, the place p and the
//! velocity v of I, the angle and the rate of the body, by the numbers of the body and by its own come from jets of just these. With X, Y and
//! F the costates of place, velocity and virtual velocity of a station, all that lies outboard of a body reads its arm d by
//!
//! ```text
//! X·(p + d) + Y·(v + ω ẑ×d) + F·(W_I + w ẑ×d)
//! ```
//!
//! Closures are read by the same walk, without loads.

use crate::adjoint::jets::seeded;
use crate::adjoint::laws::ReversibleLaw;
use crate::adjoint::{BodyLaw, ReversibleLoads};
use crate::lift::Lift;
use crate::loading::{Load, LoadLaw};
use crate::mechanics::planar::axes::{Axes, Inboard};
use crate::mechanics::planar::body::{Body, Inertia, Pose};
use crate::mechanics::planar::{
    Acceleration, BodyMotion, ElasticHinge, Frame, Pin, Planar, PointMass, RigidBody, Rod, Slider, Turn, Weld, Wrench,
};
use crate::relation::planar::algebra::{add_scaled, dot, normal, plus_dot};
use crate::relation::{Additive, Closures};
use crate::scalar::{Jet, Scalar};
use crate::shape::{Of, Takes};
use crate::walks::{Burden, LAW, PullLoads};
use core::ops::Add;
use nalgebra::Vector2;

/// Place, velocity, angle, rate.
const MOTION: usize = 6;
/// The numbers of a body that loads read: outboard end, mass, mass centre and moment of inertia about it, body axes.
pub(crate) const BODY: usize = 6;
/// What a load may read.
pub(super) const READ: usize = MOTION + BODY + LAW;
/// A number with derivatives by all that.
pub(super) type Read<T> = Jet<T, READ>;

/// Costates of a station, by what loads outboard of it read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Felt<T> {
    /// Of its place, of its velocity, of its virtual velocity.
    pub(super) place: Vector2<T>,
    pub(super) velocity: Vector2<T>,
    pub(super) stirring: Vector2<T>,
    /// Of angle and rate of what turns with the inboard body.
    pub(super) turn: [T; 2],
}

impl<T: Scalar> Add for Felt<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            place: self.place + other.place,
            velocity: self.velocity + other.velocity,
            stirring: self.stirring + other.stirring,
            turn: [self.turn[0] + other.turn[0], self.turn[1] + other.turn[1]],
        }
    }
}

impl<T: Scalar> Additive for Felt<T> {
    fn null() -> Self {
        let none = Vector2::null();
        Self { place: none, velocity: none, stirring: none, turn: [T::zero(); 2] }
    }
}

/// The numbers of a body that loads read.
pub(crate) fn numbers<T: Scalar>(body: &impl Body<T>) -> [T; BODY] {
    let ([x, y], Inertia { mass, centre: [a, b], about_centre }) = (body.outboard(), body.inertia());
    [x, y, mass, a, b, about_centre]
}

/// The motion of a body, by what loads read of it.
pub(super) fn read<T: Scalar>(frame: &Frame<T>, numbers: [T; BODY]) -> BodyMotion<Read<T>> {
    let at = |v: Vector2<T>, first: usize| Vector2::new(Read::seed(v.x, first), Read::seed(v.y, first + 1));
    let turn = Turn { angle: Read::seed(frame.turn.angle, 4), rate: Read::seed(frame.turn.rate, 5) };
    let [x, y, mass, a, b, about_centre] = core::array::from_fn(|k| Read::seed(numbers[k], MOTION + k));
    let inertia = Inertia { mass, centre: [a, b], about_centre };
    moved([at(frame.place, 0), at(frame.velocity, 2)], turn, [x, y], inertia)
}

/// A motion of a body without derivatives.
pub(super) fn still<T: Scalar>(motion: &BodyMotion<T>) -> BodyMotion<Read<T>> {
    let (Frame { place, velocity, turn, .. }, of) = (motion.inboard, |v: Vector2<T>| v.map(Read::of));
    let turn = Turn { angle: Read::of(turn.angle), rate: Read::of(turn.rate) };
    let inertia = motion.inertia.lift(&mut Read::of);
    let still = moved([of(place), of(velocity)], turn, [Read::of(T::zero()); 2], inertia);
    BodyMotion { arm: of(motion.arm), ..still }
}

/// The motion of a body whose outboard end is there, body axes.
fn moved<T: Scalar>(
    [place, velocity]: [Vector2<T>; 2],
    turn: Turn<T>,
    outboard: [T; 2],
    inertia: Inertia<T>,
) -> BodyMotion<T> {
    let acceleration = Acceleration { linear: Vector2::null(), angular: Additive::null() };
    let inboard = Frame { place, velocity, acceleration, turn };
    let ((sine, cosine), none) = (turn.angle.sin_cos(), Vector2::null());
    let motion = BodyMotion { inboard, arm: none, to_centre: none, direction: Vector2::new(cosine, sine), inertia };
    BodyMotion { arm: motion.turned(outboard), to_centre: motion.turned(inertia.centre), ..motion }
}

/// What a load does over virtual velocities of the inboard end and of its body, by a seed.
pub(super) fn slope<T: Scalar>((weight, stirring): (Vector2<T>, T), load: &Wrench<Read<T>>, k: usize) -> T {
    let Wrench { force, torque } = load;
    weight.x.mul_add(force.x.eps[k], weight.y.mul_add(force.y.eps[k], stirring * torque.eps[k]))
}

/// A load without derivatives.
pub(super) fn value<T: Scalar>(load: &Wrench<Read<T>>) -> Wrench<T> {
    Wrench { force: load.force.map(|x| x.re), torque: load.torque.re }
}

/// Adds to costates of the numbers of a body.
pub(super) fn add_numbers<T: Scalar>(sums: &mut [T; BODY], slope: impl Fn(usize) -> T) {
    sums.iter_mut().zip(MOTION..).for_each(|(sum, k)| *sum += slope(k));
}

/// What is carried inward where all that is done by loads has such slopes, and this one is the body's own.
pub(super) fn felt_by<T: Scalar>(slope: impl Fn(usize) -> T, own: Wrench<T>, _: &Frame<T>, _: T) -> Felt<T> {
    let two = |first: usize| Vector2::new(slope(first), slope(first + 1));
    Felt { place: two(0), velocity: two(2), stirring: own.force, turn: [slope(4), slope(5)] }
}

impl<T, L> ReversibleLoads<Planar<T>> for L
where
    T: Scalar,
    L: LoadLaw<BodyMotion<T>, Value: Load<Planar<T>>> + Copy,
    L: Lift<T, Read<T>, Over: LoadLaw<BodyMotion<Read<T>>, Value: Load<Planar<Read<T>>>>>,
{
    fn felt(
        walk: &mut PullLoads<L, Planar<T>>,
        numbers: [T; BODY],
        frame: &Frame<T>,
        (weight, stirring): (Vector2<T>, T),
        sums: &mut [T; BODY],
    ) -> Felt<T> {
        let (law, count) = seeded(&walk.law, MOTION + BODY);
        let load = law.at(walk.time, walk.body, &read(frame, numbers)).wrench();
        let slope = |k: usize| slope((weight, stirring), &load, k);
        add_numbers(sums, slope);
        walk.of_law.1 = count;
        walk.of_law.0.iter_mut().zip(MOTION + BODY..).for_each(|(sum, k)| *sum += slope(k));
        felt_by(slope, value(&load), frame, stirring)
    }
}

macro_rules! bodies {
    ($($Body:ident),*) => {$(
        impl<T: Scalar, C: Closures> Takes<Planar<T>, Burden<T, C>> for $Body<T> {
            fn take(
                &self,
                walk: &mut Burden<T, C>,
                outer: Wrench<T>,
                (x, y, p, q, (_, load), ..): Of<'_, Planar<T>, Burden<T, C>, Self>,
            ) -> Wrench<T> {
                let inner = self.take(&mut walk.0, outer, (x, y, p, q, &(), &(), &mut (), &mut ()));
                inner - *load
            }
        }

        impl<T: Scalar, L: ReversibleLoads<Planar<T>>> Takes<Planar<T>, PullLoads<L, Planar<T>>> for $Body<T> {
            fn take(
                &self,
                walk: &mut PullLoads<L, Planar<T>>,
                outer: Felt<T>,
                (&x, &y, &p, &q, _, ((frame, _), met, ..), (sums, ()), _): Of<'_, Planar<T>, PullLoads<L, Planar<T>>, Self>,
            ) -> Felt<T> {
                let pose = Pose { x, y, p, q };
                let ([arm, _], direction, spin) = (self.arm(pose), self.direction(pose), frame.turn.rate);
                let Felt { place, velocity, stirring, turn: [turn, of_rate] } = outer;
                let across = normal(arm);
                // What the arm is weighed by.
                let lever = add_scaled(place, -spin, normal(velocity));
                let lever =
                    if const { L::ON } { add_scaled(lever, -met.stirring, normal(stirring)) } else { lever };
                sums[0] = plus_dot(sums[0], direction, lever);
                sums[1] = plus_dot(sums[1], normal(direction), lever);
                let turn = [plus_dot(turn, across, lever), plus_dot(of_rate, across, velocity)];
                if const { !L::ON } {
                    return Felt { turn, ..outer };
                }
                walk.body = walk.body.saturating_sub(1);
                let inner = add_scaled(met.velocity, -met.stirring, across);
                Felt { turn, ..outer } + L::felt(walk, numbers(self), frame, (inner, met.stirring), sums)
            }
        }
    )*};
}
bodies!(Rod, RigidBody, PointMass);

/// Joints with one coordinate: what they eliminate of a costate they eliminate of a load.
macro_rules! joints {
    ($([$($L:ident)?] $Joint:ty),*) => {$(
        impl<T: Scalar, C: Closures $(, $L: ReversibleLaw<T>)?> Takes<Planar<T>, Burden<T, C>> for $Joint {
            fn take(
                &self,
                walk: &mut Burden<T, C>,
                outer: Wrench<T>,
                (x, y, p, q, (), gain, pivot): Of<'_, Planar<T>, Burden<T, C>, Self>,
            ) -> Wrench<T> {
                let mut more = T::zero();
                let inner = self.take(&mut walk.0, outer, (x, y, p, q, gain, pivot, &mut more, &mut ()));
                gain.free += more;
                inner
            }
        }
    )*};
}
joints!([] Pin, [R] ElasticHinge<R>, [R] Slider<T, R>);

impl<T: Scalar, C: Closures> Takes<Planar<T>, Burden<T, C>> for Weld<T> {
    fn take(&self, _: &mut Burden<T, C>, outer: Wrench<T>, _: Of<'_, Planar<T>, Burden<T, C>, Self>) -> Wrench<T> {
        outer
    }
}

impl<T: Scalar, L: BodyLaw<Planar<T>>> Takes<Planar<T>, PullLoads<L, Planar<T>>> for Pin {
    fn take(
        &self,
        _: &mut PullLoads<L, Planar<T>>,
        outer: Felt<T>,
        (.., (of_position, of_rate)): Of<'_, Planar<T>, PullLoads<L, Planar<T>>, Self>,
    ) -> Felt<T> {
        *of_position += outer.turn[0];
        *of_rate += outer.turn[1];
        Felt { turn: [T::zero(); 2], ..outer }
    }
}

impl<T: Scalar, L: BodyLaw<Planar<T>>> Takes<Planar<T>, PullLoads<L, Planar<T>>> for Weld<T> {
    fn take(
        &self,
        _: &mut PullLoads<L, Planar<T>>,
        outer: Felt<T>,
        (.., (_, sums), _): Of<'_, Planar<T>, PullLoads<L, Planar<T>>, Self>,
    ) -> Felt<T> {
        sums[0] += outer.turn[0];
        outer
    }
}

impl<T: Scalar, L: BodyLaw<Planar<T>>, R: ReversibleLaw<T>> Takes<Planar<T>, PullLoads<L, Planar<T>>>
    for ElasticHinge<R>
{
    fn take(
        &self,
        _: &mut PullLoads<L, Planar<T>>,
        outer: Felt<T>,
        (.., (of_position, of_rate)): Of<'_, Planar<T>, PullLoads<L, Planar<T>>, Self>,
    ) -> Felt<T> {
        *of_position += outer.turn[0];
        *of_rate += outer.turn[1];
        outer
    }
}

impl<T: Scalar, L: BodyLaw<Planar<T>>, R: ReversibleLaw<T>> Takes<Planar<T>, PullLoads<L, Planar<T>>> for Slider<T, R> {
    /// The arm s e of the inboard body, whose rate is ω ẑ×d + ṡ e, and whose virtual velocity w ẑ×d + w_s e.
    fn take(
        &self,
        _: &mut PullLoads<L, Planar<T>>,
        outer: Felt<T>,
        (x, y, p, q, (_, rate, w), (.., kept, _), (_, sums), (of_position, of_rate)): Of<
            '_,
            Planar<T>,
            PullLoads<L, Planar<T>>,
            Self,
        >,
    ) -> Felt<T> {
        let offset = Inboard::offset(x, y, p, q);
        let (line, d, turning) = (offset.direction, offset.arm, kept.turning);
        let (beside, n) = (normal(line), normal(d));
        let Felt { place, velocity, stirring, turn } = outer;
        *of_position += plus_dot(
            turning.rate.mul_add(dot(beside, velocity), turning.stirring * dot(beside, stirring)),
            line,
            place,
        );
        *of_rate += dot(line, velocity);
        // ẑ× of the arm, of its rate and of its virtual velocity.
        let rates = add_scaled(beside * *rate, -turning.rate, d);
        let stirred = add_scaled(beside * *w, -turning.stirring, d);
        let turned = plus_dot(plus_dot(dot(n, place), rates, velocity), stirred, stirring);
        sums[0] += turned;
        Felt { turn: [turn[0] + turned, turn[1] + dot(n, velocity)], ..outer }
    }
}
