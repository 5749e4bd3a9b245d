//! The costate sweep in space: what a load on a body reads.
//!
//! A load f, m about the inboard end I takes W_I·f + w·m from the virtual power P. Its derivatives by what it reads come from jets of just
//! these: the place p and the velocity v of I, turns of the body's axes and its ω, the numbers of the body and those of its own law.

use super::felt::Felt;
use crate::adjoint::ReversibleLoads;
use crate::adjoint::jets::seeded;
use crate::lift::Lift;
use crate::loading::{Load, LoadLaw};
use crate::mechanics::spatial::body::Body;
use crate::mechanics::spatial::{Acceleration, BodyMotion, Frame, Inertia, Spatial, Turn, Wrench};
use crate::relation::spatial::algebra::{Columns, cross_onto, dot, zero};
use crate::scalar::{Jet, Scalar};
use crate::walks::{LAW, PullLoads};
use nalgebra::Vector3;

/// Place, velocity, turn, angular velocity.
const MOTION: usize = 12;
/// The numbers of a body that loads read: outboard end, mass, mass centre and inertia tensor about it, body axes.
pub const BODY: usize = 16;
/// What a load may read.
pub(super) const READ: usize = MOTION + BODY + LAW;
/// A number with derivatives by all that.
pub type Read<T> = Jet<T, READ>;

/// The numbers of a body that loads read.
pub fn numbers<T: Scalar>(body: &impl Body<T>) -> [T; BODY] {
    let ([x, y, z], Inertia { mass, centre: [a, b, c], about_centre: [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] }) =
        (body.outboard(), body.inertia());
    [x, y, z, mass, a, b, c, xx, xy, xz, yx, yy, yz, zx, zy, zz]
}

/// A vector whose components are seeds.
fn seeds<T: Scalar>(v: Vector3<T>, first: usize) -> Vector3<Read<T>> {
    Vector3::new(Read::seed(v.x, first), Read::seed(v.y, first + 1), Read::seed(v.z, first + 2))
}

/// Axes that turn: δθ × c of each column c.
fn turning<T: Scalar>(attitude: &Columns<T>, first: usize) -> Columns<Read<T>> {
    let column = |c: Vector3<T>| {
        let entry = |value: T, slopes: [T; 3]| {
            let mut jet = Read::of(value);
            jet.eps[first..].iter_mut().zip(slopes).for_each(|(slope, x)| *slope = x);
            jet
        };
        let o = T::zero();
        Vector3::new(entry(c.x, [o, c.z, -c.y]), entry(c.y, [-c.z, o, c.x]), entry(c.z, [c.y, -c.x, o]))
    };
    Columns { x: column(attitude.x), y: column(attitude.y), z: column(attitude.z) }
}

/// The motion of a body, by what loads read of it.
pub(super) fn read<T: Scalar>(frame: &Frame<T>, numbers: [T; BODY]) -> BodyMotion<Read<T>> {
    let turn = Turn { attitude: turning(&frame.turn.attitude, 6), spin: seeds(frame.turn.spin, 9) };
    let acceleration = Acceleration { linear: zero(), angular: zero() };
    let inboard = Frame { place: seeds(frame.place, 0), velocity: seeds(frame.velocity, 3), acceleration, turn };
    let [x, y, z, mass, a, b, c, xx, xy, xz, yx, yy, yz, zx, zy, zz]: [Read<T>; BODY] =
        core::array::from_fn(|k| Read::seed(numbers[k], MOTION + k));
    let turned = |x, y, z| turn.attitude.apply(Vector3::new(x, y, z));
    let inertia = Inertia { mass, centre: [a, b, c], about_centre: [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] };
    BodyMotion { inboard, arm: turned(x, y, z), to_centre: turned(a, b, c), inertia }
}

/// A motion of a body without derivatives.
pub(super) fn still<T: Scalar>(motion: &BodyMotion<T>) -> BodyMotion<Read<T>> {
    let (Frame { place, velocity, turn, .. }, of) = (motion.inboard, |v: Vector3<T>| v.map(Read::of));
    let Columns { x, y, z } = turn.attitude;
    let turn = Turn { attitude: Columns { x: of(x), y: of(y), z: of(z) }, spin: of(turn.spin) };
    let acceleration = Acceleration { linear: zero(), angular: zero() };
    let inboard = Frame { place: of(place), velocity: of(velocity), acceleration, turn };
    let inertia = motion.inertia.lift(&mut Read::of);
    BodyMotion { inboard, arm: of(motion.arm), to_centre: of(motion.to_centre), inertia }
}

/// What a load does over virtual velocities of the inboard end and of its body, by a seed.
pub(super) fn slope<T: Scalar>((weight, stirring): (Vector3<T>, Vector3<T>), load: &Wrench<Read<T>>, k: usize) -> T {
    dot(weight, load.force.map(|x| x.eps[k])) + dot(stirring, load.torque.map(|x| x.eps[k]))
}

/// A load without derivatives.
pub(super) fn value<T: Scalar>(load: &Wrench<Read<T>>) -> Wrench<T> {
    Wrench { force: load.force.map(|x| x.re), torque: load.torque.map(|x| x.re) }
}

/// Adds to costates of the numbers of a body.
pub(super) fn add_numbers<T: Scalar>(sums: &mut [T; BODY], slope: impl Fn(usize) -> T) {
    sums.iter_mut().zip(MOTION..).for_each(|(sum, k)| *sum += slope(k));
}

/// What is carried inward where all that is done by loads has such slopes, and this one is the body's own.
pub(super) fn felt_by<T: Scalar>(
    slope: impl Fn(usize) -> T,
    own: Wrench<T>,
    frame: &Frame<T>,
    stirring: Vector3<T>,
) -> Felt<T> {
    let three = |first: usize| Vector3::new(slope(first), slope(first + 1), slope(first + 2));
    let (Wrench { force, torque }, spin) = (own, three(9));
    // With turns of the body, its ω and its w.
    let turn = cross_onto(frame.turn.spin, spin, cross_onto(stirring, torque, three(6)));
    Felt { place: three(0), velocity: three(3), stirring: force, turn, spin, torque }
}

impl<T, L> ReversibleLoads<Spatial<T>> for L
where
    T: Scalar,
    L: LoadLaw<BodyMotion<T>, Value: Load<Spatial<T>>> + Copy,
    L: Lift<T, Read<T>, Over: LoadLaw<BodyMotion<Read<T>>, Value: Load<Spatial<Read<T>>>>>,
{
    fn felt(
        walk: &mut PullLoads<L, Spatial<T>>,
        numbers: [T; BODY],
        frame: &Frame<T>,
        (weight, stirring): (Vector3<T>, Vector3<T>),
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
