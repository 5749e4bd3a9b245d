//! The contract for Taylor series through kept gains.
//!
//! Accelerations solve linear equations whose matrix depends on positions alone. Differentiated k times in time, the equations have the
//! same matrix and other right-hand sides: products of coefficients that are known. So one elimination, one division and one sine a
//! body serve a whole step of any order, and a coefficient costs four convolutions a body in the plane, in space 12 a rod and 36 a rigid
//! body, and 12 more a joint. The walks are
//!
//! ```text
//! pose         root → tip   as in a sweep                                                   Element::pose
//! begin        root → tip   orientations and rates: the coefficients of order 0             walks::series::Begin
//! articulate   tip → root   F = S p, and the gains                                          walks::series::Articulate
//! weigh        root → tip   loads on bodies, if any: what laws make of the motion so far    walks::series::Weigh    once for each order
//! push         tip → root   convolutions; forces that coefficients known so far cause       walks::series::Push     once for each order
//! swing        root → tip   accelerations of that order, and what follows from them         walks::series::Swing    once for each order
//! ```
//!
//! These are [selective](crate::shape::Selective) walks: what they do at a body or a joint stands with its physics
//! (`mechanics/planar/series/`, `mechanics/spatial/series/`).
//!
//! Coefficients are those of powers of time (s): the acceleration of a coordinate is Σ a_k tᵏ from a step's start.

mod laws;
mod loads;

pub use laws::{ExpandLaw, Strain};
pub use loads::{Borne, BorneOf, ExpandBody, ExpandLoad, ExpandLoads, Setting};

use crate::element::{Element, Space};
use crate::relation::{AccelerationOf, Closures, Open, WrenchOf};
use crate::scalar::Real;
use crate::shape::{Closing, Takes};
use crate::walks::series::{Articulate, Begin, Push, Swing};

/// A space whose elements have Taylor series.
pub trait Expandable: Space {
    /// F = S p of what lies outboard.
    type Articulated: Copy;
    /// What the walks keep of a set of axes (that of a body, and those of joints that keep some) in a series of order `N`.
    type AxesSeries<const N: usize>: Copy + 'static;
    /// What the walks keep of a joint in such a series.
    type JointSeries<const N: usize>: Copy + 'static;
    /// What is carried outward where a series begins.
    type Begun: Copy;
    /// What is carried inward of forces: of these what there is to know yet.
    type Pushed: Copy;
    /// What is carried outward of accelerations.
    type Swung: Copy;

    /// What lies beyond a free tip.
    fn nothing() -> Self::Articulated;
    /// With what lies outboard of an arm.
    fn join(chain: Self::Articulated, arm: Self::Articulated) -> Self::Articulated;
    /// Stiffened by a closure force that acts by a wrench: S + w wᵀ / Λ.
    fn closed(open: Self::Articulated, wrench: WrenchOf<Self>, inverse: Self::Scalar) -> Self::Articulated;
    /// What the ground hands on where a series begins.
    fn begun(ground: Self::Turn) -> Self::Begun;
    /// What is carried inward where nothing lies outboard.
    fn unpushed() -> Self::Pushed;
    /// A force and torque on what lies outboard, to be carried inward.
    fn pushed(felt: WrenchOf<Self>) -> Self::Pushed;
    /// What is carried, less a load that acts where it is felt.
    fn relieved(pushed: Self::Pushed, load: WrenchOf<Self>) -> Self::Pushed;
    /// The force and torque that is carried.
    fn felt(pushed: Self::Pushed) -> WrenchOf<Self>;
    /// An acceleration, to be carried outward.
    fn accelerated(acceleration: AccelerationOf<Self>) -> Self::Swung;
    /// No acceleration, to be carried outward.
    fn still() -> Self::Swung;
    /// The acceleration that is carried.
    fn acceleration(swung: Self::Swung) -> AccelerationOf<Self>;
    /// Nothing has been kept.
    fn untouched<const N: usize>() -> (Self::AxesSeries<N>, Self::JointSeries<N>);
}

/// Which coefficient is found: its number, and what its neighbours are divided by.
#[derive(Clone, Copy, Debug)]
pub struct Order<R> {
    /// k, that of the accelerations.
    pub k: usize,
    /// k + 1.
    pub next: R,
    /// 1 / (k + 1): accelerations to rates.
    pub once: R,
    /// 1 / (k + 1) (k + 2): accelerations to positions.
    pub twice: R,
}

impl<R: Real> Order<R> {
    /// Order number `k`.
    #[cfg_attr(optimised, inline(always))]
    pub fn of(k: usize) -> Self {
        let (one, next) = (R::one(), R::of((k + 1) as f64));
        let once = one / next;
        Self { k, next, once, twice: once / (next + one) }
    }

    /// The coefficient of this order of a list; of a shorter one, which nobody asks for, the last.
    #[inline(always)]
    pub fn among<Q: Copy, const N: usize>(&self, coefficients: &[Q; N]) -> Q {
        coefficients[self.k.min(N - 1)]
    }
}

/// Elements whose motion has a Taylor series of order `N` through kept gains, under loads `L` and closure forces `C`.
pub trait Expand<S: Expandable, L: ExpandLoads<S, N>, const N: usize, C: Closures = Open>:
    Element<S>
    + Takes<S, Begin<N>>
    + Takes<S, Articulate<S, N, C>>
    + Takes<S, Push<S, L, N, C>>
    + Takes<S, Swing<S, L, N, C>>
{
}

impl<S: Expandable, L: ExpandLoads<S, N>, E, C: Closures, const N: usize> Expand<S, L, N, C> for E where
    E: Element<S>
        + Takes<S, Begin<N>>
        + Takes<S, Articulate<S, N, C>>
        + Takes<S, Push<S, L, N, C>>
        + Takes<S, Swing<S, L, N, C>>
{
}

/// A joint that closes loops whose motion has a Taylor series, by forces of directions that rest.
pub trait ExpandClosing<S: Expandable>: Closing<S> {
    /// W where the side arm ends: the opposite of the wrench by which each unit force acts on its last body.
    fn columns(&self) -> <Self::Closures as Closures>::Each<WrenchOf<S>>;
}

/// A joint that closes such loops, under efforts `Q`.
#[diagnostic::on_unimplemented(
    message = "`Taylor` knows no series of loops that `{Self}` closes, under efforts `{Q}`",
    label = "not a joint that closes loops with a series",
    note = "it knows loops that a `Pin` or a `Weld` of the plane closes, or of space a `Weld`, or a `Ball` where no efforts act in joints",
    note = "`Dop853` runs all scenes"
)]
pub trait ExertClosing<S: Expandable, Q>: ExpandClosing<S> {
    /// The force and torque by which an effort acts on what lies outboard of the side arm: on the main one.
    fn exerted(&self, effort: Q) -> WrenchOf<S>;
}
