//! Loads that have series.
//!
//! A load on a body depends on its motion, and coefficient k of the load on those of places and rates up to number k: all are known before
//! the walks of order k. So laws are asked for power series of the motion known by then, once for each order.

use super::{Expandable, Order};
use crate::lift::Lift;
use crate::loading::{LoadLaw, Loading, Loads, OverTime, Seen, SeriesLaw, Unloaded, Values};
use crate::mirror::Rate;
use crate::relation::{Absent, Acceleration, AccelerationOf, Additive, Geometry, Part, WrenchOf};
use crate::scalar::{Powers, Scalar};
use crate::space::{RealOf, Space, SpaceOver};

/// Loads that have a series of order `N`.
#[diagnostic::on_unimplemented(
    message = "`Taylor` knows no series of loads `{Self}`",
    label = "loads without a series",
    note = "it runs scenes under gravity, springs and dampers, under efforts in joints that are values or functions of time (`Loads::in_joints_over_time`), and under loads on bodies that are values or laws written for any number (`Loads::on_bodies_over_time`); `Dop853` runs all"
)]
pub trait ExpandLoads<S: Expandable, const N: usize>: Loading<S> {
    /// Whether loads are functions of time or motion.
    const OVER_TIME: bool;
    /// What acts on bodies.
    type OnBodies: ExpandLoad<S, N>;

    /// What acts on bodies.
    fn on_bodies(&self) -> &Self::OnBodies;
    /// The first coefficients of the effort in the joint of a number, of powers of time (s) around a time: as many as are asked for.
    fn in_joint_over_time(&self, time: RealOf<S>, joint: usize, asked: usize) -> [Self::InJoint; N];
}

impl<S: Expandable, const N: usize> ExpandLoads<S, N> for Unloaded {
    const OVER_TIME: bool = false;
    type OnBodies = Absent;

    fn on_bodies(&self) -> &Absent {
        &Absent
    }
    fn in_joint_over_time(&self, _: RealOf<S>, _: usize, _: usize) -> [Absent; N] {
        [Absent; N]
    }
}

impl<S, B, J, const N: usize> ExpandLoads<S, N> for Loads<B, J>
where
    S: Expandable,
    B: ExpandLoad<S, N>,
    J: SeriesLaw<S::JointMotion>,
    Self: Loading<S, InJoint = J::Value>,
{
    const OVER_TIME: bool = B::READS || J::OVER_TIME;
    type OnBodies = B;

    fn on_bodies(&self) -> &B {
        self.bodies()
    }
    fn in_joint_over_time(&self, time: RealOf<S>, joint: usize, asked: usize) -> [J::Value; N] {
        self.joints().series(time, joint, asked)
    }
}

/// A law of loads on bodies that have a series of order `N`.
#[diagnostic::on_unimplemented(
    message = "`Taylor` knows no series of loads `{Self}` on bodies",
    label = "loads without a series",
    note = "a law written for any number, `impl<T: Scalar> LoadLaw<BodyMotion<T>> for Law<T>` with `catena::lift!(Law<T> {{ .. }})`, has one by `Loads::on_bodies_over_time`; `Dop853` runs all"
)]
pub trait ExpandLoad<S: Expandable, const N: usize>: LoadLaw<S::BodyMotion> {
    /// What is kept of the load on a body.
    type Borne: Borne<S>;
    /// The law over power series.
    type Lifted;

    /// Of a load that has not set out.
    fn unborne() -> Self::Borne;
    /// The law over power series.
    fn lifted(&self) -> Self::Lifted;
    /// The load at a time, where a body of a number is.
    fn set_out(&self, time: RealOf<S>, body: usize, motion: &S::BodyMotion) -> Self::Borne;
    /// Finds so many coefficients more, and those before again: gives whether these are as they were.
    fn go_on(&self, lifted: &Self::Lifted, at: &Setting<S>, body: usize, more: usize, borne: &mut Self::Borne) -> bool;
}

/// What is kept of a load on a body, of loads `L`.
pub type BorneOf<S, L, const N: usize> = <<L as ExpandLoads<S, N>>::OnBodies as ExpandLoad<S, N>>::Borne;

/// Where loads have set out.
pub struct Setting<S: Space> {
    /// At which time (s).
    pub time: RealOf<S>,
    /// In which field of gravity (m/s²).
    pub gravity: S::Vector,
}

/// What is kept of the load on a body: of none, nothing.
pub trait Borne<S: Expandable>: Copy + 'static {
    /// The coefficient of an order, if there is a load.
    fn load(&self, order: &Order<RealOf<S>>) -> Option<WrenchOf<S>>;

    /// Takes it from what is carried inward.
    #[inline(always)]
    fn relieve(&self, order: &Order<RealOf<S>>, pushed: S::Pushed) -> S::Pushed {
        match self.load(order) {
            None => pushed,
            Some(load) => S::relieved(pushed, load),
        }
    }

    /// Whether all coefficients found are finite.
    fn is_finite(&self) -> bool {
        true
    }

    /// Notes the acceleration of the body, of an order.
    #[inline(always)]
    fn note(&mut self, order: &Order<RealOf<S>>, swung: S::Swung) {
        let _ = (order, swung);
    }
}

impl<S: Expandable> Borne<S> for Absent {
    #[inline(always)]
    fn load(&self, _: &Order<RealOf<S>>) -> Option<WrenchOf<S>> {
        None
    }
}

impl<S: Expandable, const N: usize> ExpandLoad<S, N> for Absent {
    type Borne = Self;
    type Lifted = ();

    fn unborne() -> Self {
        Self
    }
    fn lifted(&self) {}
    fn set_out(&self, _: RealOf<S>, _: usize, _: &S::BodyMotion) -> Self {
        Self
    }
    fn go_on(&self, (): &(), _: &Setting<S>, _: usize, _: usize, _: &mut Self) -> bool {
        true
    }
}

/// A load that is a value: all coefficients but the first are zero.
#[derive(Clone, Copy, Debug)]
pub struct Given<W>(W);

impl<S: Expandable> Borne<S> for Given<WrenchOf<S>> {
    #[inline(always)]
    fn load(&self, order: &Order<RealOf<S>>) -> Option<WrenchOf<S>> {
        if order.k == 0 { Some(self.0) } else { None }
    }
}

impl<S: Expandable, V: AsRef<[WrenchOf<S>]>, const N: usize> ExpandLoad<S, N> for Values<V> {
    type Borne = Given<WrenchOf<S>>;
    type Lifted = ();

    fn unborne() -> Self::Borne {
        Given(Additive::null())
    }
    fn lifted(&self) {}
    fn set_out(&self, time: RealOf<S>, body: usize, motion: &S::BodyMotion) -> Self::Borne {
        Given(self.at(time, body, motion))
    }
    fn go_on(&self, (): &(), _: &Setting<S>, body: usize, _: usize, borne: &mut Self::Borne) -> bool {
        let value = self.0.as_ref().get(body).copied().unwrap_or_else(Additive::null);
        is_same::<S>(core::mem::replace(borne, Given(value)).0, value)
    }
}

/// A load that depends on motion or time, and what it has seen.
#[derive(Clone, Copy, Debug)]
pub struct Laden<S: Expandable, const N: usize> {
    /// The body where the series begins.
    start: S::BodyMotion,
    /// Accelerations of the body, as one sees them that falls freely.
    accelerations: [AccelerationOf<S>; N],
    /// Coefficients of the load, and how many of them there are.
    loads: [WrenchOf<S>; N],
    found: usize,
}

impl<S: Expandable, const N: usize> Borne<S> for Option<Laden<S, N>> {
    #[inline(always)]
    fn load(&self, order: &Order<RealOf<S>>) -> Option<WrenchOf<S>> {
        self.as_ref().map(|laden| order.among(&laden.loads))
    }
    fn is_finite(&self) -> bool {
        self.as_ref().is_none_or(|laden| laden.loads[..laden.found].iter().all(|load| Part::is_finite(*load)))
    }
    #[inline(always)]
    fn note(&mut self, order: &Order<RealOf<S>>, swung: S::Swung) {
        if let Some(place) = self.as_mut().and_then(|laden| laden.accelerations.get_mut(order.k)) {
            *place = S::acceleration(swung);
        }
    }
}

impl<S, L, const N: usize> ExpandLoad<S, N> for OverTime<L>
where
    S: ExpandBody<N>,
    L: Lift<S::Scalar, Powers<S::Scalar, N>, Over: LoadLaw<MotionOver<S, N>, Value = WrenchOf<S::Over>>>,
    Self: LoadLaw<S::BodyMotion, Value = WrenchOf<S>>,
{
    type Borne = Option<Laden<S, N>>;
    type Lifted = L::Over;

    fn unborne() -> Self::Borne {
        None
    }
    fn lifted(&self) -> L::Over {
        self.0.lift(&mut Powers::of)
    }
    fn set_out(&self, time: RealOf<S>, body: usize, motion: &S::BodyMotion) -> Self::Borne {
        let start = motion.unaccelerated();
        let mut loads = [Additive::null(); N];
        if let Some(load) = loads.first_mut() {
            *load = self.at(time, body, &start);
        }
        Some(Laden { start, accelerations: [Acceleration::zero(); N], loads, found: 1 })
    }
    fn go_on(&self, lifted: &L::Over, at: &Setting<S>, body: usize, more: usize, borne: &mut Self::Borne) -> bool {
        let Some(Laden { start, accelerations, loads, found }) = borne else { return false };
        let (before, known) = (*found, N.min(*found + more));
        let time = Powers::variable(S::Scalar::constant(at.time), known);
        let motion = S::body_series(start, &accelerations[..known - 1], at.gravity);
        let now = if known == 1 {
            let mut first = *loads;
            first[0] = self.at(at.time, body, start);
            first
        } else {
            S::terms(lifted.over_time(time, body, &motion))
        };
        let same = now.iter().zip(&*loads).take(before).all(|(now, then)| is_same::<S>(*now, *then));
        (*loads, *found) = (now, known);
        same
    }
}

/// What is seen of a body over power series.
pub type MotionOver<S, const N: usize> =
    <<S as SpaceOver<Powers<<S as Geometry>::Scalar, N>>>::Over as Space>::BodyMotion;

/// A space in which the motion of a body is written over power series.
pub trait ExpandBody<const N: usize>: Expandable + SpaceOver<Powers<<Self as Geometry>::Scalar, N>> {
    /// The motion of a body from where it starts: one coefficient more than there are of accelerations, which one sees that falls freely. Of
    /// accelerations themselves laws see nothing.
    fn body_series(
        start: &Self::BodyMotion,
        accelerations: &[AccelerationOf<Self>],
        gravity: Self::Vector,
    ) -> MotionOver<Self, N>;
    /// The coefficients of a load.
    fn terms(load: WrenchOf<Self::Over>) -> [WrenchOf<Self>; N];
}

/// Whether two loads are the same, derivative parts included.
fn is_same<S: Space>(a: WrenchOf<S>, b: WrenchOf<S>) -> bool {
    S::numbers(a).all(&S::numbers(b), &mut |a, b| a.is_identical(b))
}
