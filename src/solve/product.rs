//! The plain product of transfer matrices, (16) and (17): a view for inspection on short chains.
//!
//! It is exact where it exists and loses all digits in f64 beyond some tens of bodies, for entries of the product grow
//! exponentially while the states stay bounded. Sweeps never use it.

use crate::element::{Coordinates, Element, Gather, Load, Loading, RealOf, Space, Visit};
use crate::error::{Error, Fault};
use crate::relation::Term;
use crate::scalar::Scalar;
use crate::state::{StateVector, TransferMatrix};
use crate::transfer::Exact;
use crate::visit::survey;
use core::marker::PhantomData;
use num_traits::Zero;

/// The matrix of one element, before its neighbours are known.
#[derive(Clone, Copy)]
enum Entry<S: Space, const N: usize> {
    /// Not yet visited.
    Blank,
    Body(TransferMatrix<S::Scalar, N>),
    /// A joint, and the torque in it.
    Joint(S::JointMotion, S::Scalar),
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
    L::OnBody: Load<S>,
    L::InJoint: Term<S::Scalar>,
{
    type OnBody = Entry<S, N>;
    type InJoint = Entry<S, N>;

    fn body(&mut self, body: &S::BodyMotion) -> Entry<S, N> {
        let load = self.loads.on_body(&self.seen, self.time, self.body, body);
        self.body += 1;
        Entry::Body(S::body_matrix(body, self.gravity, load))
    }
    fn joint(&mut self, joint: &S::JointMotion) -> Entry<S, N> {
        let torque = self.loads.in_joint(self.time, self.joint, joint);
        self.joint += 1;
        Entry::Joint(*joint, torque.add_to(S::Scalar::zero()))
    }
}

/// The overall transfer matrix of a chain, from the outboard side of the root's joint to the tip, and the torque in the root's
/// joint. `each` is shown every element's number (from the tip inward) and matrix.
#[allow(clippy::too_many_arguments)] // the data flow of the method, one value each
pub fn product<S: Exact<N>, E: Element<S>, L: Loading<S>, const N: usize>(
    chain: &E,
    ground: &S::Frame,
    gravity: S::Vector,
    loads: &L,
    time: RealOf<S>,
    motion: Coordinates<'_, S, E>,
    each: &mut impl FnMut(usize, &TransferMatrix<S::Scalar, N>),
) -> Result<(TransferMatrix<S::Scalar, N>, S::Scalar), Error>
where
    L::InJoint: Term<S::Scalar>,
{
    let (mut bodies, mut joints) = (chain.per_body(Entry::Blank), chain.per_joint(Entry::Blank));
    let seen = survey(chain, *ground, motion, loads);
    let mut form = Form { loads, seen, time, gravity, body: 0, joint: 0, space: PhantomData };
    chain.travel(*ground, motion, &mut form, &mut bodies, &mut joints);

    let identity = TransferMatrix::identity();
    let mut multiply = Multiply {
        whole: identity,
        section: identity,
        outer_torque: S::Scalar::zero(),
        outcome: Ok(()),
        number: chain.bodies() + chain.joints(),
        each,
        space: PhantomData::<S>,
    };
    chain.inward(&mut bodies, &mut joints, (), &mut multiply);
    let Multiply { whole, outer_torque, outcome, .. } = multiply;
    outcome.map(|()| (whole, outer_torque))
}

/// Multiplies the matrices, inward.
struct Multiply<'a, S: Space, F, const N: usize> {
    whole: TransferMatrix<S::Scalar, N>,
    /// The product up to the next turning joint outboard.
    section: TransferMatrix<S::Scalar, N>,
    outer_torque: S::Scalar,
    outcome: Result<(), Error>,
    /// That of the entry met last: from the tip to the root's joint, which is number 0 and stays outside the product.
    number: usize,
    each: &'a mut F,
    space: PhantomData<S>,
}

impl<S: Exact<N>, F: FnMut(usize, &TransferMatrix<S::Scalar, N>), const N: usize> Gather for Multiply<'_, S, F, N> {
    type Entry = Entry<S, N>;
    type Carried = ();

    fn meet(&mut self, entry: &mut Entry<S, N>, (): ()) {
        self.number -= 1;
        let identity = TransferMatrix::identity();
        let mut turning = false;
        let matrix = match entry {
            Entry::Body(matrix) => *matrix,
            Entry::Joint(joint, applied) => match S::joint_torque(joint, *applied) {
                None => identity,
                Some(torque) => {
                    let outer = core::mem::replace(&mut self.outer_torque, torque);
                    if self.number == 0 {
                        return;
                    }
                    turning = true;
                    S::joint_matrix(joint, torque, &self.section, outer).unwrap_or_else(|error| {
                        self.outcome = self.outcome.and(Err(error.at_station(self.number - 1)));
                        identity
                    })
                }
            },
            Entry::Blank => identity,
        };
        self.whole = matrix.then(&self.whole);
        self.section = if turning { identity } else { matrix.then(&self.section) };
        (self.each)(self.number - 1, &matrix);
    }
    fn beyond_arm(&mut self) {}
    fn opposite(&mut self, (): ()) {}
    fn join(&mut self, (): (), (): ()) {
        // The state at the tip of the chain is a function of that at its root, but no product of its elements' matrices.
        let error = Error::new(Fault::Unsupported { what: "a chain that branches" });
        self.outcome = Err(error.at_station(self.number.saturating_sub(1)));
    }
}

/// Closes the ends of a pinned or floating chain with a free tip: the state at the chain's inboard end.
///
/// `motion` says which of the three conjugate pairs the root holds (as the state at acceleration level).
pub fn close<T: Scalar>(
    whole: &TransferMatrix<T, 7>,
    known: StateVector<T, 7>,
    held: &[bool],
) -> Result<StateVector<T, 7>, Error> {
    // Position i is conjugate to force (4, 5 for x, y; 3 for the angle).
    const CONJUGATE: [usize; 3] = [4, 5, 3];
    let singular = Error::new(Fault::SingularTransfer);
    let mut unknown = [0; 3];
    for (pair, slot) in unknown.iter_mut().enumerate() {
        *slot = if *held.get(pair).ok_or(singular)? { CONJUGATE[pair] } else { pair };
    }
    let mut z = known;
    for index in unknown {
        z[index] = T::zero();
    }
    // The tip's force and torque vanish.
    let residual = *whole * z;
    let rows = [3, 4, 5];
    let a = rows.map(|row| unknown.map(|column| whole[(row, column)]));
    let b = rows.map(|row| -residual[row]);
    let x = crate::transfer::solve_dense(a, b).ok_or(singular)?;
    for (index, value) in unknown.into_iter().zip(x) {
        z[index] = value;
    }
    Ok(z)
}
