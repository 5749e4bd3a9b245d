//! What acts on a scene besides uniform gravity.

mod force_element;
mod laws;
mod loads;
mod responses;

pub use force_element::{ForceElement, ForceLaw};
pub use laws::{Function, InJoints, LoadLaw, OnBodies, OverTime, Seen, SeriesLaw, TimeLaw, Values};
pub use loads::Loads;
pub(crate) use responses::{Each, LARGER, balanced};

/// What acts in a joint of a space.
pub type EffortOf<S> = <<S as Space>::JointMotion as Seen>::Load;

use crate::error::Fault;
use crate::lift::lift;
use crate::mirror::{Position, Rate};
use crate::relation::{Absent, Part, Wrench, WrenchOf};
use crate::scalar::{Elementary, Real, Scalar};
use crate::space::{MovingBody, RealOf, Space};
use crate::sweep::Springs;
use crate::visit::Level;
use num_traits::One;

/// What acts on a scene besides uniform gravity. Its types say what a sweep has to carry: [`Absent`] parts cost nothing.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no loads of a scene",
    label = "no loads of this space",
    note = "a law of a body's motion acts as `Loads::none().on_bodies_by(law)`, one of a joint's as `Loads::none().in_joints_by(law)`; such loads stand beside `Struts` and `Couplings` by their `and`"
)]
pub trait Loading<S: Space> {
    /// Load on a body, or `Absent`.
    type OnBody: Load<S>;
    /// Torque in a joint, or `Absent`.
    type InJoint: Part;

    /// What has to be seen of the whole scene before a load is known: nothing, unless a load on one body depends on another.
    type Seen: Clone;

    /// What forces that hang on the accelerations that they cause move, those of [`Couplings`](crate::planar::Couplings): nothing, where there are
    /// none ([`couples`]).
    type Responses<V: Clone>: Clone + Default;

    /// Whether there is anything to evaluate.
    const ON: bool;
    /// Whether there is anything to see first.
    const SURVEYS: bool = false;
    /// Whether a load depends on time or motion. Where none does, no walk shows the motion to it: loads are
    /// [`listed`](Self::listed).
    const READS: bool = true;

    /// Whether, and how, implicit sweeps know that loads on bodies yield: then they are read where the last sweep has led.
    const YIELDS: Yields = if <Self::OnBody as Load<S>>::YIELDS { Yields::Each } else { Yields::Never };

    /// Whether torques are listed, and [`in_joint`](Self::in_joint) numbers joints, for those of one coordinate alone.
    const BY_COORDINATE: bool = false;

    /// No load, to fill stores with.
    fn nothing() -> (Self::OnBody, Self::InJoint);
    /// Nothing has been seen yet.
    fn unseen(&self) -> Self::Seen;
    /// Sees a body.
    fn survey(&self, seen: &mut Self::Seen, body: usize, motion: &S::BodyMotion) {
        let _ = (seen, body, motion);
    }
    /// The load on body number `body` at a time.
    fn on_body(&self, seen: &Self::Seen, time: RealOf<S>, body: usize, motion: &S::BodyMotion) -> Self::OnBody;
    /// The torque in joint number `joint` (0 is the root's) at a time.
    fn in_joint(&self, time: RealOf<S>, joint: usize, motion: &S::JointMotion) -> Self::InJoint;

    /// Loads on bodies and torques in joints, from the root and its joint on, where no load [`READS`](Self::READS) the motion; empty lists where there are
    /// none.
    fn listed(&self) -> (&[Self::OnBody], &[Self::InJoint]) {
        (&[], &[])
    }

    /// Finds accelerations by a sweep under loads; by several, where forces hang on these. The last one is under the forces found where more is
    /// read of it than accelerations (`read`): what is told of joints with modes, closure forces, what joints remember. A sweep is told whether it is not the first, so that
    /// bodies are posed. What these forces move is kept where it is asked for.
    #[inline(always)]
    fn accelerated<V: Rate<S::Scalar>>(
        &self,
        read: bool,
        responses: Option<&mut Self::Responses<V>>,
        acceleration: &mut V,
        mut sweep: impl FnMut(&Self, bool, &mut V),
    ) {
        let _ = (read, responses);
        sweep(self, false, acceleration);
    }

    /// Finds accelerations by implicit sweeps under loads that yield [together](Yields::Together). They are `read` of a state to which accelerations have
    /// `led`; `springs` is what these make of stiffness and damping, and `see` looks at the place of the sweeps, with accelerations for
    /// rates. A sweep is told whether it is not the first.
    fn yielded<V: Rate<S::Scalar>>(
        &self,
        (read, led): (&Self::Seen, &V),
        springs: impl Springs<S::Scalar>,
        see: impl Fn(&V) -> Self::Seen,
        acceleration: &mut V,
        mut sweep: impl FnMut(&Self, bool, &mut V),
    ) {
        let _ = (read, led, springs, see);
        sweep(self, false, acceleration);
    }

    /// Adds to a correction of positions, or of rates, what moves joints to where these loads hold them, or makes them as fast: along what forces
    /// between them move.
    fn rejoin<P: Position<S::Scalar>>(
        &self,
        responses: &Self::Responses<P::Rate>,
        level: Level,
        motion: (&P, &P::Rate),
        correction: &mut P::Rate,
    ) {
        let _ = (responses, level, motion, correction);
    }

    /// Tells by how much coordinates are not where these loads hold them, or not as fast, the numbers of their joints, and the coordinates or their
    /// rates.
    fn each_miss<P: Position<S::Scalar>>(
        &self,
        position: &P,
        rate: &P::Rate,
        tell: &mut impl FnMut(Level, usize, [S::Scalar; 2]),
    ) {
        let _ = (position, rate, tell);
    }

    /// Refuses loads that do not fit a scene with so many bodies and joints: lists of another length, bodies that do not exist.
    ///
    /// # Errors
    /// [`Fault::Count`], [`Fault::NoSuchBody`].
    fn check(&self, bodies: usize, joints: usize) -> Result<(), Fault> {
        let _ = (bodies, joints);
        Ok(())
    }
}

/// Whether there are forces that hang on the accelerations that they cause.
pub const fn couples<S: Space, L: Loading<S>>() -> bool {
    size_of::<L::Responses<u8>>() > 1 // no list of none, either
}

/// How loads on bodies yield to the accelerations that they cause, as implicit sweeps see it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Yields {
    /// Not at all.
    Never,
    /// Each to those of its own body: a [`Load`] with an inertia of its own, as of a contact.
    Each,
    /// To those of several bodies: [`StiffStruts`](crate::planar::StiffStruts).
    Together,
}

impl Yields {
    /// Whether loads yield to their own bodies alone.
    pub(crate) const fn each(self) -> bool {
        matches!(self, Self::Each)
    }
    /// Whether loads yield to several bodies.
    pub(crate) const fn together(self) -> bool {
        matches!(self, Self::Together)
    }
}

/// Refuses positions and rates that are not as loads hold them, beyond rounding; with the number of the joint that misses most. What is no number
/// passes: sweeps say so.
pub(crate) fn suits<S: Space, P: Position<S::Scalar>>(
    loads: &impl Loading<S>,
    position: &P,
    rate: &P::Rate,
) -> Result<(), (Fault, usize)> {
    let (mut most, mut worst) = (RealOf::<S>::EPSILON.sqrt(), None);
    loads.each_miss(position, rate, &mut |_, joint, numbers| {
        let [missed, own] = numbers.map(|x| x.real().abs());
        let share = missed / (RealOf::<S>::one() + own);
        if share > most {
            (most, worst) = (share, Some((missed, joint)));
        }
    });
    worst.map_or(Ok(()), |(missed, joint)| Err((Fault::NotAssembled { residual: missed.as_f64() }, joint)))
}

/// Refuses a list that is not as long as it must be.
fn count(list: &'static str, expected: usize, given: usize) -> Result<(), Fault> {
    if given == expected { Ok(()) } else { Err(Fault::Count { list, expected, given }) }
}

/// A load on a body, or [`Absent`].
pub trait Load<S: Space>: Part {
    /// Whether the load says how it yields.
    const YIELDS: bool = false;
    /// The load as a force (N) and a torque (N·m) about the body's inboard end.
    fn wrench(self) -> WrenchOf<S>;
    /// The load in axes of its body, for bodies that take it so.
    fn in_own_axes(self, body: &S::BodyMotion) -> Self;
}

impl<S: Space> Load<S> for Absent {
    #[inline(always)]
    fn wrench(self) -> WrenchOf<S> {
        Wrench::none()
    }
    #[inline(always)]
    fn in_own_axes(self, _: &S::BodyMotion) -> Self {
        self
    }
}

impl<S: Space> Load<S> for WrenchOf<S> {
    #[inline(always)]
    fn wrench(self) -> Self {
        self
    }
    #[inline(always)]
    fn in_own_axes(self, body: &S::BodyMotion) -> Self {
        body.in_own_axes(self)
    }
}

/// No loads but gravity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Unloaded;

lift!(Unloaded);

impl<S: Space> Loading<S> for Unloaded {
    type OnBody = Absent;
    type InJoint = Absent;
    type Seen = ();
    type Responses<V: Clone> = ();
    const ON: bool = false;
    const READS: bool = false;

    fn unseen(&self) {}
    fn nothing() -> (Absent, Absent) {
        (Absent, Absent)
    }
    fn on_body(&self, (): &(), _: RealOf<S>, _: usize, _: &S::BodyMotion) -> Absent {
        Absent
    }
    fn in_joint(&self, _: RealOf<S>, _: usize, _: &S::JointMotion) -> Absent {
        Absent
    }
}
