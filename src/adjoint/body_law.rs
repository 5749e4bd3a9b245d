//! What acts on bodies in runs that go backward.

use super::Reversed;
use crate::error::Fault;
use crate::loading::{Load, LoadLaw, Loading, Loads, Seen as _};
use crate::relation::Closures;
use crate::relation::{Additive, WrenchOf};
use crate::shape::Takes;
use crate::space::{FrameOf, RealOf};
use crate::walks::burden::Burden;
use crate::walks::pull_loads::{LAW, PullLoads};

/// What acts on bodies: a law of time, number and motion of each, or [`Struts`](crate::struts::Struts) between them.
#[diagnostic::on_unimplemented(
    message = "no gradient of a run goes backward under `{Self}`",
    label = "neither a law of loads on bodies nor struts",
    note = "it goes backward under a `LoadLaw` of each body's motion, and under `Struts`, alone or beside such a law: `Struts::of(..).and(Loads::none().on_bodies_by(..))`",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait BodyLaw<S: Reversed>: Copy {
    /// What is seen of all bodies before a load is known.
    type Seen: Clone;
    /// Costates of the numbers it is made of.
    type OfNumbers: Clone;
    /// These loads beside efforts in joints.
    type Beside<J: LoadLaw<S::JointMotion>>: Loading<S>;

    /// Whether there is a load.
    const ON: bool;
    /// Whether a load depends on other bodies than the one it acts on.
    const SURVEYS: bool = false;

    /// Nothing has been seen yet.
    fn unseen() -> Self::Seen;
    /// No derivatives yet.
    fn of_nothing() -> Self::OfNumbers;
    /// Sees a body.
    fn survey(&self, seen: &mut Self::Seen, body: usize, motion: &S::BodyMotion) {
        let _ = (seen, body, motion);
    }
    /// The load on a body.
    fn on_body(&self, seen: &Self::Seen, time: RealOf<S>, body: usize, motion: &S::BodyMotion) -> WrenchOf<S>;
    /// What of it depends on that body, and on time, alone.
    fn on_that_body(&self, time: RealOf<S>, body: usize, motion: &S::BodyMotion) -> WrenchOf<S>;
    /// Puts efforts in joints beside it.
    fn beside<J: LoadLaw<S::JointMotion>>(self, efforts: J) -> Self::Beside<J>;
    /// Refuses what does not fit a scene with so many bodies.
    ///
    /// # Errors
    /// [`Fault::Count`], [`Fault::NoSuchBody`] and what is wrong with parameters.
    fn check(&self, bodies: usize) -> Result<(), Fault>;
    /// Derivatives by numbers of a law of one body's motion, and how many it has.
    fn listed(of_numbers: &Self::OfNumbers) -> &OfLaw<S::Scalar>;
}

/// Costates of the numbers of a law of one body's motion, and how many it has.
pub type OfLaw<T> = ([T; LAW], usize);

impl<S: Reversed, L: LoadLaw<S::BodyMotion, Value: Load<S>> + Copy> BodyLaw<S> for L {
    type Seen = ();
    type OfNumbers = OfLaw<S::Scalar>;
    type Beside<J: LoadLaw<S::JointMotion>> = Loads<L, J>;
    const ON: bool = L::ON;

    fn unseen() {}
    fn of_nothing() -> OfLaw<S::Scalar> {
        ([S::Scalar::null(); LAW], 0)
    }
    #[inline(always)]
    fn on_body(&self, (): &(), time: RealOf<S>, body: usize, motion: &S::BodyMotion) -> WrenchOf<S> {
        self.at(time, body, &motion.unaccelerated()).wrench()
    }
    fn on_that_body(&self, time: RealOf<S>, body: usize, motion: &S::BodyMotion) -> WrenchOf<S> {
        self.on_body(&(), time, body, motion)
    }
    fn beside<J: LoadLaw<S::JointMotion>>(self, efforts: J) -> Loads<L, J> {
        Loads::none().on_bodies_by(self).in_joints_by(efforts)
    }
    fn check(&self, bodies: usize) -> Result<(), Fault> {
        LoadLaw::check(self, bodies)
    }
    fn listed(of_numbers: &OfLaw<S::Scalar>) -> &OfLaw<S::Scalar> {
        of_numbers
    }
}

/// Costates through what acts on bodies.
pub trait ReversibleLoads<S: Reversed>: BodyLaw<S> {
    /// What W·f + w·m changes by with what the load on the body met last reads, for the virtual velocity W of the body's inboard end and
    /// its w: costates of that end; adds to those of the numbers of the body and of the law.
    fn felt(
        walk: &mut PullLoads<Self, S>,
        numbers: S::OfNumbers,
        frame: &FrameOf<S>,
        stirred: (S::Vector, S::Angular),
        sums: &mut S::OfNumbers,
    ) -> S::Felt;
}

/// Elements through which costates go backward under loads on bodies.
pub trait Burdened<S: Reversed, L: BodyLaw<S>, C: Closures>:
    Takes<S, Burden<S::Scalar, C>> + Takes<S, PullLoads<L, S>>
{
}

impl<S: Reversed, L: BodyLaw<S>, C: Closures, E> Burdened<S, L, C> for E where
    E: Takes<S, Burden<S::Scalar, C>> + Takes<S, PullLoads<L, S>>
{
}
