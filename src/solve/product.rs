//! The plain product of transfer matrices, (16) and (17): a view for inspection on short chains.
//!
//! It is exact where it exists and loses all digits in f64 beyond some tens of bodies, for entries of the product grow
//! exponentially while the states stay bounded. Sweeps never use it.

use crate::element::{Coordinates, Element, Gather, Loading, RealOf, Space, Visit};
use crate::error::{Error, Fault};
use crate::release::Release;
use crate::scalar::{Real, Scalar};
use crate::shape::{PerBody, PerJoint};
use crate::space::FrameOf;
use crate::state::TransferMatrix;
use crate::transfer::{Efforts, Exact, Passage, Whole};
use crate::visit::survey;
use crate::walks::gather::gather;
use crate::walks::travel::travel;
use core::marker::PhantomData;
use num_traits::Zero;

/// What an element does to the state, before its neighbours are known.
#[derive(Clone, Copy)]
enum Entry<S: Space, const N: usize> {
    /// Not yet visited, or not known to this view.
    Blank,
    Body(TransferMatrix<S::Scalar, N>),
    Joint(Passage<S::Scalar, N>),
}

/// Forms the entries, outward.
struct Form<'a, S: Space, L: Loading<S>, const N: usize> {
    loads: &'a L,
    seen: L::Seen,
    time: RealOf<S>,
    gravity: S::Vector,
    body: usize,
    joint: usize,
    space: PhantomData<S>,
}

impl<S: Exact<N>, L: Loading<S>, const N: usize> Visit<S> for Form<'_, S, L, N>
where
    L::InJoint: Efforts<S>,
{
    type OnBody = Entry<S, N>;
    type InJoint = Entry<S, N>;

    fn body(&mut self, body: &S::BodyMotion) -> Entry<S, N> {
        let load = self.loads.on_body(&self.seen, self.time, self.body, body);
        self.body += 1;
        Entry::Body(S::body_matrix(body, self.gravity, load))
    }
    fn joint(&mut self, _: &S::JointMotion) -> Entry<S, N> {
        Entry::Blank
    }
    fn joint_with(&mut self, joint: &S::JointMotion, release: impl Fn() -> Release<S>) -> Entry<S, N> {
        let efforts = self.loads.in_joint(self.time, self.joint, joint).efforts();
        self.joint += 1;
        Entry::Joint(S::passage(joint, &release(), efforts))
    }
}

/// The overall transfer matrix of a chain with a free tip, from the outboard side of the root's joint to the tip, and what that joint
/// does. `each` is shown every element's number (from the tip inward) and matrix.
#[allow(clippy::too_many_arguments)] // the data flow of the method, one value each
pub fn product<S: Exact<N>, E: Element<S>, L: Loading<S>, const N: usize>(
    chain: &E,
    ground: &FrameOf<S>,
    gravity: S::Vector,
    loads: &L,
    time: RealOf<S>,
    motion: Coordinates<'_, S, E>,
    each: &mut impl FnMut(usize, &TransferMatrix<S::Scalar, N>),
) -> Result<Whole<S, N>, Error>
where
    L::InJoint: Efforts<S>,
{
    let (mut bodies, mut joints) = (chain.store::<PerBody<_>>(Entry::Blank), chain.store::<PerJoint<_>>(Entry::Blank));
    let seen = survey(chain, *ground, motion, loads);
    let mut form = Form { loads, seen, time, gravity, body: 0, joint: 0, space: PhantomData };
    travel(chain, *ground, motion, &mut form, &mut bodies, &mut joints);

    let identity = TransferMatrix::identity();
    let mut multiply = Multiply {
        whole: identity,
        root: Passage::of(identity),
        outcome: Ok(()),
        inertia: RealOf::<S>::zero(),
        number: chain.bodies() + chain.joints(),
        each,
        space: PhantomData::<S>,
    };
    gather(chain, &mut bodies, &mut joints, (), &mut multiply);
    let Multiply { whole, root, outcome, .. } = multiply;
    outcome.map(|()| (whole, root))
}

/// Multiplies the matrices, inward.
struct Multiply<'a, S: Space, F, const N: usize> {
    whole: TransferMatrix<S::Scalar, N>,
    /// The joint that stays outside the product.
    root: Passage<S::Scalar, N>,
    outcome: Result<(), Error>,
    /// The largest force or torque for a unit acceleration that a body has (kg, kg·m, kg·m²).
    inertia: RealOf<S>,
    /// Number of the entry met last: from the tip to the root's joint, which is number 0.
    number: usize,
    each: &'a mut F,
    space: PhantomData<S>,
}

impl<S: Exact<N>, F: FnMut(usize, &TransferMatrix<S::Scalar, N>), const N: usize> Gather for Multiply<'_, S, F, N> {
    type Entry = Entry<S, N>;
    type Carried = ();

    fn meet(&mut self, entry: &mut Entry<S, N>, (): ()) {
        self.number -= 1;
        let found = match entry {
            Entry::Body(matrix) => {
                for (force, motion) in (N / 2..N - 1).flat_map(|i| (0..N / 2).map(move |j| (i, j))) {
                    self.inertia = self.inertia.max(matrix[(force, motion)].real().abs());
                }
                Ok(*matrix)
            }
            Entry::Joint(passage) if self.number == 0 => {
                self.root = *passage;
                return;
            }
            Entry::Joint(passage) => passage.matrix(&self.whole, self.inertia).ok_or(Fault::SingularTransfer),
            Entry::Blank => Err(Fault::Unsupported { what: "a joint like this" }),
        };
        match found {
            Ok(matrix) => {
                self.whole = matrix.then(&self.whole);
                (self.each)(self.number.saturating_sub(1), &matrix);
            }
            Err(fault) => {
                let error = Error::new(fault).at_station(self.number.saturating_sub(1));
                self.outcome = self.outcome.and(Err(error));
            }
        }
    }
    fn beyond_arm(&mut self) {}
    fn opposite(&mut self, (): ()) {}
    fn join(&mut self, (): (), (): ()) {
        // The state at the tip of the chain is a function of that at its root, but no product of its elements' matrices.
        let error = Error::new(Fault::Unsupported { what: "a chain that branches" });
        self.outcome = Err(error.at_station(self.number.saturating_sub(1)));
    }
}
