//! The contract for Taylor series through kept gains.
//!
//! Accelerations solve linear equations whose matrix depends on positions alone. Differentiated k times in time, the equations have the
//! same matrix and other right-hand sides: products of coefficients that are known. So one elimination, one division and one sine a
//! body serve a whole step of any order, and a coefficient costs four convolutions a body in the plane. The walks are
//!
//! ```text
//! pose      root → tip   as in a sweep                                                   Element::pose
//! begin     root → tip   orientations and rates: the coefficients of order 0             Expand::begin
//! factor    tip → root   F = S p, and the gains                                          Expand::factor
//! push      tip → root   convolutions; forces that coefficients known so far cause       Expand::push        once for each order
//! swing     root → tip   accelerations of that order, and what follows from them         Expand::swing       once for each order
//! sum       any          positions and rates at the end of the step, or within           Expand::sum
//! ```
//!
//! Coefficients are those of powers of time (s). A series of a rate v̇₀, v₁, … holds v(t) = Σ v_k tᵏ; the first two are rate and
//! acceleration of the motion from which the step sets out, and are not stored again.

use crate::element::{Element, Posture, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::loading::{Loading, Unloaded};
use crate::relation::{AccelerationOf, Open, WrenchOf};
use crate::scalar::Real;

/// A space whose elements have Taylor series.
#[diagnostic::on_unimplemented(
    message = "`Taylor` knows no motion in `{Self}`",
    label = "no Taylor series in this space",
    note = "`Taylor` runs scenes of the plane; `Dop853` runs all"
)]
pub trait Expandable: Space {
    /// F = S p of what lies outboard.
    type Articulated: Copy;

    /// What lies beyond a free tip.
    fn nothing() -> Self::Articulated;
    /// With what lies outboard of an arm.
    fn join(chain: Self::Articulated, arm: Self::Articulated) -> Self::Articulated;
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
    #[inline(always)]
    pub fn of(k: usize) -> Self {
        let (one, next) = (R::one(), R::of((k + 1) as f64));
        let once = one / next;
        Self { k, next, once, twice: once / (next + one) }
    }
}

/// A time from the start of a step, and what coefficients of rates are divided by to be those of positions.
#[derive(Clone, Copy, Debug)]
pub struct Instant<'a, R> {
    /// The time (s).
    pub time: R,
    /// 1 / (k + 1) for the coefficient number k of a rate, from k = 0 on.
    pub shares: &'a [R],
}

/// Where a series sets out: the motion of an element.
pub struct Origin<'a, S: Space, E: Element<S>> {
    /// Positions.
    pub position: &'a E::Position,
    /// Rates.
    pub rate: &'a E::Rate,
    /// Accelerations.
    pub acceleration: &'a E::Rate,
}

impl<S: Space, E: Element<S>> Clone for Origin<'_, S, E> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<S: Space, E: Element<S>> Copy for Origin<'_, S, E> {}

/// An element whose motion has a Taylor series of order `N` through kept gains.
#[diagnostic::on_unimplemented(
    message = "`Taylor` knows no series of the motion of `{Self}`",
    label = "no Taylor series through the gains of this element",
    note = "it knows rods, rigid bodies, point masses, pins, welds and rotary springs and dampers of the plane, in tuples, arrays, vectors and branches; `Dop853` runs all scenes"
)]
pub trait Expand<S: Expandable, const N: usize>: Element<S> {
    /// What the walks keep.
    type Room: Clone;

    /// Room for what the walks keep.
    fn room(&self) -> Self::Room;

    /// Keeps the coefficients of order 0, of a posture.
    fn begin(
        &self,
        posture: Posture<'_, S, Self>,
        position: &Self::Position,
        rate: &Self::Rate,
        turn: S::Turn,
        room: &mut Self::Room,
    ) -> S::Turn;

    /// Condenses what lies outboard, and keeps gains.
    fn factor(&self, outer: S::Articulated, room: &mut Self::Room) -> S::Articulated;

    /// Carries inward the force and torque on what lies outboard, as far as coefficients known so far and springs cause them.
    fn push(&self, order: &Order<RealOf<S>>, outer: WrenchOf<S>, room: &mut Self::Room) -> WrenchOf<S>;

    /// Finds the accelerations of an order from that of the inboard station, and coefficients that follow from them.
    fn swing(
        &self,
        order: &Order<RealOf<S>>,
        inboard: AccelerationOf<S>,
        room: &mut Self::Room,
        acceleration: &mut Self::Rate,
    ) -> AccelerationOf<S>;

    /// Positions and rates after a time.
    fn sum(
        room: &Self::Room,
        at: Instant<'_, RealOf<S>>,
        origin: Origin<'_, S, Self>,
        position: &mut Self::Position,
        rate: &mut Self::Rate,
    );

    /// Shows the coefficients of each rate, root to tip, from that of the second power of time on.
    fn show(room: &Self::Room, each: &mut impl FnMut(&[S::Scalar]));
}

/// A root on ground that rests, so that its series is known.
#[diagnostic::on_unimplemented(
    message = "`Taylor` knows no series of the ground of `{Self}`",
    label = "a ground that may move, or a root that floats",
    note = "it knows `Pinned` and `Clamped` at places and angles that are numbers; `Dop853` runs all scenes"
)]
pub trait AtRest<S: Space>: Root<S> {}

/// A tip that nothing holds.
#[diagnostic::on_unimplemented(
    message = "`Taylor` knows no series of the forces of `{Self}`",
    label = "a tip that is held",
    note = "it knows chains and trees whose tip is `Free`; `Dop853` runs all scenes"
)]
pub trait Unheld<S: Space>: Tip<S, Closures = Open> {}

/// Loads that have a series.
#[diagnostic::on_unimplemented(
    message = "`Taylor` knows no series of loads `{Self}`",
    label = "loads without a series",
    note = "it runs scenes under gravity, springs and dampers alone; `Dop853` runs all"
)]
pub trait ExpandLoads<S: Space>: Loading<S> {}

impl<S: Space> ExpandLoads<S> for Unloaded {}
