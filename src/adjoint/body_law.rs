//! What acts on bodies in runs that go backward.

use super::{Reversed, Ties};
use crate::error::Fault;
use crate::loading::{EffortOf, Load, LoadLaw, Loading, Loads, Unloaded};
use crate::relation::{Absent, Additive, Closures};
use crate::shape::Takes;
use crate::space::{FrameOf, RealOf};
use crate::visit::Level;
use crate::walks::{Burden, LAW, PullLoads};

/// What acts on bodies: a law of time, number and motion of each, or [`Struts`](crate::struts::Struts) between them; and
/// [`Couplings`](crate::planar::Couplings) of joints.
#[diagnostic::on_unimplemented(
    message = "no gradient of a run goes backward under `{Self}`",
    label = "no law of loads on bodies, struts or couplings",
    note = "it goes backward under a `LoadLaw` of each body's motion, under `Struts`, under a `ForceElement::by(..)` whose law is a struct that can be lifted, and under `Couplings`, alone or beside such a law: `Struts::of(..).and(Loads::none().on_bodies_by(..))`",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait BodyLaw<S: Reversed>: Copy {
    /// These loads beside efforts in joints, without ties.
    type Beside<J: LoadLaw<S::JointMotion> + Clone>: Loading<S, InJoint = J::Value> + Clone;
    /// These loads and ties beside efforts in joints.
    type Whole<J: LoadLaw<S::JointMotion, Value = EffortOf<S>> + Clone>: Loading<S>;
    /// Costates of the numbers they are made of.
    type OfNumbers: Clone;
    /// What is seen of virtual velocities of all bodies before costates are known: nothing, unless loads survey.
    type Stirred: Clone;
    /// Ties between joints besides, if there are any.
    type Ties: Ties<S>;

    /// Whether there is a load.
    const ON: bool = <Alone<S, Self> as Loading<S>>::ON;
    /// Whether a load depends on other bodies than the one it acts on.
    const SURVEYS: bool = <Alone<S, Self> as Loading<S>>::SURVEYS;

    /// Puts efforts in joints beside these loads, without ties.
    fn beside<J: LoadLaw<S::JointMotion> + Clone>(self, efforts: J) -> Self::Beside<J>;
    /// Puts efforts in joints beside these loads and ties.
    fn whole<J: LoadLaw<S::JointMotion, Value = EffortOf<S>> + Clone>(self, efforts: J) -> Self::Whole<J>;
    /// No derivatives yet.
    fn of_nothing(&self) -> Self::OfNumbers;
    /// Refuses derivatives that are none: by laws of more numbers than costates know, and by forces that have jumped.
    ///
    /// # Errors
    /// What it is.
    fn known(&self, of_numbers: &Self::OfNumbers) -> Result<(), Fault> {
        let _ = of_numbers;
        Ok(())
    }
    /// Nothing is stirred yet.
    fn unstirred() -> Self::Stirred;
    /// The ties between joints.
    fn ties(&self) -> Self::Ties;
    /// Derivatives by the ratios of ties and by their offsets.
    fn of_ties(of_numbers: &mut Self::OfNumbers) -> [&mut [S::Scalar]; 2];
    /// Derivatives by numbers of a law of one body's motion, and how many it has.
    fn listed(of_numbers: &Self::OfNumbers) -> &OfLaw<S::Scalar>;
    /// Meets the derivatives by all numbers of these loads in the order in which [`Lift`](crate::Lift) meets the numbers.
    fn each_number(of_numbers: &mut Self::OfNumbers, meet: &mut impl FnMut(&mut S::Scalar));
}

/// Loads on bodies without efforts in joints.
pub type Alone<S, L> = <L as BodyLaw<S>>::Beside<Absent>;
/// What such loads have seen of all bodies.
pub type Surveyed<S, L> = <Alone<S, L> as Loading<S>>::Seen;

/// Costates of the numbers of a law of one body's motion, and how many it has.
pub type OfLaw<T> = ([T; LAW], usize);

impl<S: Reversed, L: LoadLaw<S::BodyMotion, Value: Load<S>> + Copy> BodyLaw<S> for L {
    type Beside<J: LoadLaw<S::JointMotion> + Clone> = Loads<L, J>;
    type Whole<J: LoadLaw<S::JointMotion, Value = EffortOf<S>> + Clone> = Loads<L, J>;
    type OfNumbers = OfLaw<S::Scalar>;
    type Stirred = ();
    type Ties = ();

    fn beside<J: LoadLaw<S::JointMotion> + Clone>(self, efforts: J) -> Loads<L, J> {
        Loads::none().on_bodies_by(self).in_joints_by(efforts)
    }
    fn whole<J: LoadLaw<S::JointMotion, Value = EffortOf<S>> + Clone>(self, efforts: J) -> Loads<L, J> {
        self.beside(efforts)
    }
    fn of_nothing(&self) -> OfLaw<S::Scalar> {
        ([S::Scalar::null(); LAW], 0)
    }
    fn unstirred() {}
    fn ties(&self) {}
    fn of_ties(_: &mut OfLaw<S::Scalar>) -> [&mut [S::Scalar]; 2] {
        [&mut [], &mut []]
    }
    fn listed(of_numbers: &OfLaw<S::Scalar>) -> &OfLaw<S::Scalar> {
        of_numbers
    }
    fn each_number((list, _): &mut OfLaw<S::Scalar>, meet: &mut impl FnMut(&mut S::Scalar)) {
        if const { <Self as BodyLaw<S>>::ON } {
            list.iter_mut().for_each(meet);
        }
    }
}

/// Loads on bodies alone, as they stand beside struts or couplings in runs that go backward.
pub trait ActsOnBodies<S: Reversed>: Loading<S> + Copy {
    /// What acts on bodies.
    type Law: BodyLaw<S, Ties = ()>;
    /// The law.
    fn law(&self) -> Self::Law;
}

impl<S: Reversed> ActsOnBodies<S> for Unloaded {
    type Law = Absent;
    fn law(&self) -> Absent {
        Absent
    }
}

impl<S: Reversed, B: LoadLaw<S::BodyMotion, Value: Load<S>> + Copy> ActsOnBodies<S> for Loads<B, Absent> {
    type Law = B;
    fn law(&self) -> B {
        *self.bodies()
    }
}

/// Costates through what acts on bodies.
#[diagnostic::on_unimplemented(
    message = "no gradient of a run goes backward under `{Self}`",
    label = "loads that gradients do not know",
    note = "beside struts and couplings a law stands as loads: `struts.and(Loads::none().on_bodies_by(law))`",
    note = "in struts a law of your own stands as `Custom(law)`, generic over the scalar and lifted by `catena::lift!`"
)]
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

/// What a law of one body's motion, which sees no other, adds beside loads that see several bodies: at a time (s), on a body, at a level.
pub fn felt_beside<S: Reversed, L: ReversibleLoads<S, OfNumbers = OfLaw<S::Scalar>>>(
    law: L,
    (time, body, level): (RealOf<S>, usize, Level),
    of_law: &mut OfLaw<S::Scalar>,
    numbers: S::OfNumbers,
    frame: &FrameOf<S>,
    stirred: (S::Vector, S::Angular),
    sums: &mut S::OfNumbers,
) -> S::Felt {
    let seen = (law.beside(Absent).unseen(), L::unstirred());
    let mut walk = PullLoads { law, seen, surveys: false, time, body, level, of_law: *of_law };
    let felt = L::felt(&mut walk, numbers, frame, stirred, sums);
    *of_law = walk.of_law;
    felt
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
