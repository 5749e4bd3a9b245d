//! The contract between elements, the composition of elements and the solver.
//!
//! # One sweep
//!
//! A *sweep* is one evaluation of a scene's accelerations. It walks the chain four times (five where loads survey the whole scene
//! first: [`Loading::SURVEYS`]), and nothing goes back:
//!
//! ```text
//! orient    root → tip   each body's angle and rate                        Element::pose
//! load      root → tip   loads, with the motion they depend on (if any)    walks::travel
//!                        lists of forces (if any), without kinematics      walks::spread
//! condense  tip → root   F = S p + e at each station                       Condense::condense
//! recover   root → tip   accelerations of the joint coordinates            walks::recover
//! ```
//!
//! Joints own coordinates, bodies own none. What a walk carries from element to element has a type, and an element maps
//! the type it takes to the type it hands on: [`Condense`] is generic over the relation met. That is how a pin gets away
//! with a 2 × 2 block, how a free tip costs nothing, and why a pin with no body outboard of it does not compile.
//!
//! Which bodies and joints there are, what is stored beside them and in which order they are met, a composite says once ([`Shape`]).
//! Walks are values with a file each ([`walks`](crate::walks)), of which neither composites nor bodies and joints know. Two
//! are still methods, of [`Condense`] and [`Element`]:
//!
//! * Condensation, because what it carries changes type from element to element: that takes a trait with the relation as a parameter.
//! * Poses, because of arguments alone a compiler knows that they do not overlap: stores in a bundle, as walks have them, keep sines of
//!   long tuples from vectorising.
//!
//! # Why this shape
//!
//! The contract was tried on paper against what is to come, and the choices follow from that.
//!
//! * **A pin chain in the plane** must not pay for anything else. What a sweep has to carry (loads, implicit springs, closure
//!   forces) is a type, [`Sweep`], and what lies outboard is a type too, the relation; a part that is not there is a type without
//!   size. Postures are kept as stores of numbers, not of structs, so that sines vectorise for tuples as well as for arrays (in
//!   space, whose attitudes need no sines, as stores of vectors).
//! * **A ball chain in space.** Nothing here mentions a plane: [`Space`] names what a walk carries (two numbers that turn in the
//!   plane, a rotation and a vector in space), and a ball hands on a 3 × 3 point relation as a pin hands on a 2 × 2 one. What
//!   a posture is, each space says: an arm and its centripetal acceleration in the plane, vectors and inertias in space.
//! * **A held tip with λ columns.** W, Λ and y₀ ride inside the relation as fields that a free tip's type does not have
//!   ([`Closures`](crate::relation::Closures)); kernels treat e and W as right-hand sides of one elimination, and a joint keeps one more number for each of its
//!   coordinates and each closure force. The ground's condition at the root turns Λ into λ, and the outward walk uses it.
//! * **An implicit rule.** Only a joint's pivot gains K̂ and its torque an affine term. A stiff joint is the same element
//!   condensed for another type of springs, [`Implicit`], after which the relation is full; rods and pins neither know nor pay.
//!   Springs are read where coordinates would be without the acceleration sought, which makes a linear law exact; those of
//!   rotations and laws of users, which are not linear, where the last sweep has led ([`Reading`]).
//! * **Projections and a tangent sweep through stored gains.** [`Kept`] holds what the outward walk needs of each
//!   elimination, one value per joint in the order of the chain, and outlives the sweep: [`respond`](crate::walks::respond) walks it again for
//!   corrections of positions and rates, and other right-hand sides can.
//! * **The paper's displacement level** builds matrices from the same elements: it reads them by one [`travel`](crate::walks::travel), and
//!   shares no other walk with this one.
//! * **Branches** are elements whose condensation adds the relation of an arm to that of the chain at one station; walks inward
//!   add what comes from both ([`Gather`]), walks outward set out from that station twice.
//!
//! Joint coordinates are the joint's business: a pin stores the absolute angle of its outboard body, so that a chain of pins
//! needs no running sums; a hinge with a spring stores the relative angle, because the difference of two absolute angles loses
//! digits when bodies are short.

pub use crate::loading::{Load, Loading, Unloaded};
pub use crate::relation::Close;
pub use crate::space::{Budget, RealOf, Space, SpaceOver};
pub use crate::sweep::{Carrying, Explicit, Implicit, Reading, Springs, Sweep};
pub use crate::turning::Turning;
pub use crate::visit::{Closed, Gather, Level, Visit, Watch, look};

use crate::mirror::{Position, Rate};
use crate::shape::{Kept, PerAxes, PerBody, PerJoint, Positions, Rates, Shape};
use crate::walks::count;

/// A body, a joint, or a chain of them, as a sweep sees it: a [`Shape`] with coordinates that time rules can move, and poses.
///
/// Bodies and joints of both spaces are elements, and tuples, arrays and vectors of elements, arms and networks. Users make elements by
/// the macros of [`extend`](crate::extend); by hand it takes, beside this trait, [`Shape`], `AsBody` or `AsJoint`, which say where its entry of a store is, and `Condense`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not an element of the chain's space `{S}`",
    label = "not an element of `{S}`",
    note = "a chain consists of bodies and joints of one space and one scalar: tuples (to 16), arrays or vectors of them"
)]
// Two bounds of one trait: Rust 1.89 takes no bound that binds `Store` twice (E0719).
pub trait Element<S: Space>:
    Shape<S, Store<Positions> = <Self as Element<S>>::Position> + Shape<S, Store<Rates> = <Self as Element<S>>::Rate>
{
    /// Positions of the joint coordinates inside.
    type Position: Position<S::Scalar, Rate = Self::Rate>;
    /// Rates and accelerations of the joint coordinates inside.
    type Rate: Rate<S::Scalar>;

    /// Number of bodies inside.
    fn bodies(&self) -> usize {
        count::bodies::<S, Self>(self)
    }
    /// Number of joints inside.
    fn joints(&self) -> usize {
        count::joints::<S, Self>(self)
    }

    /// Moves point masses inboard, tip to root, once for a scene: takes the mass (kg) that its outboard neighbour lumps at the
    /// station between them, and hands on what it lumps at its own inboard end instead of adding it in every sweep.
    fn lump(&mut self, mass: S::Scalar) -> S::Scalar;

    /// Whether the orientations inside do not depend on what lies inboard: then bodies that follow each other in an array need
    /// not be turned one after the other.
    const ABSOLUTE: bool;
    /// Whether the orientation handed on does not depend on what lies inboard.
    const TURNS_ANEW: bool = false;
    /// Whether postures inside are better found one by one, each just before its item is condensed, than all before
    /// ([`Condense::pose_and_condense`]).
    const POSED_LATE: bool = false;

    /// The orientation handed on: that of the inboard end, unless a joint inside turns it.
    #[inline(always)]
    fn turned(&self, position: &Self::Position, rate: &Self::Rate, turn: S::Turn) -> S::Turn {
        let _ = (position, rate);
        turn
    }

    /// Carries the orientation outward and stores, for each set of axes, what `resolve` needs.
    #[allow(clippy::too_many_arguments)] // one store each
    fn orient(
        &self,
        position: &Self::Position,
        rate: &Self::Rate,
        turn: S::Turn,
        x: &mut Self::Store<PerAxes<S::X>>,
        y: &mut Self::Store<PerAxes<S::Y>>,
        p: &mut Self::Store<PerAxes<S::P>>,
        q: &mut Self::Store<PerAxes<S::Q>>,
    ) -> S::Turn;

    /// Turns what `orient` stored into postures, without regard to order. It reads nothing but stores of numbers, so that the
    /// loop vectorises.
    fn resolve(
        sizes: &Self::Store<PerAxes<S::Size>>,
        x: &mut Self::Store<PerAxes<S::X>>,
        y: &mut Self::Store<PerAxes<S::Y>>,
        p: &mut Self::Store<PerAxes<S::P>>,
        q: &mut Self::Store<PerAxes<S::Q>>,
    );

    /// `orient` and `resolve` at once.
    #[cfg_attr(optimised, inline(always))]
    #[allow(clippy::too_many_arguments)] // one store each: of arguments alone the compiler knows that they do not overlap
    fn pose(
        &self,
        position: &Self::Position,
        rate: &Self::Rate,
        turn: S::Turn,
        sizes: &Self::Store<PerAxes<S::Size>>,
        x: &mut Self::Store<PerAxes<S::X>>,
        y: &mut Self::Store<PerAxes<S::Y>>,
        p: &mut Self::Store<PerAxes<S::P>>,
        q: &mut Self::Store<PerAxes<S::Q>>,
    ) -> S::Turn {
        let turn = self.orient(position, rate, turn, x, y, p, q);
        Self::resolve(sizes, x, y, p, q);
        turn
    }
}

/// An element that can condense a relation of type `R` in a sweep that carries `L`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot take what lies outboard of it: `{R}`",
    label = "nothing outboard of this holds it",
    note = "a pin needs a body on its outboard side: end a chain with a body, and put a body between two pins; after `BodyAxes` stand `Hinge`s, `Slide`s and `Link`s, one joint at least",
    note = "only elements of the chain's space `{S}` can"
)]
pub trait Condense<S: Space, R, W: Sweep<S>>: Element<S> {
    /// The relation handed on to the inboard neighbour.
    type Out: Copy;

    /// Condenses the relation `outer` at the outboard end to one at the inboard end, and keeps the gains.
    fn condense(
        &self,
        outer: R,
        posture: Posture<'_, S, Self>,
        given: Given<'_, S, Self, W>,
        kept: &mut Self::Store<Kept<W::Closures>>,
    ) -> Self::Out;

    /// `pose` and `condense` at once, in a sweep whose springs are explicit: `given` has the positions and rates.
    ///
    /// The condensation of a chain waits for most of its time, each item for the relation of the next. Where numbers are lanes, each item of
    /// an array has sines of its own to find, which a processor does meanwhile if they come next (twenty rods: a fifth of a sweep). Plain
    /// numbers do better all at once, for sines of several items fill a register.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)] // those of `pose` and `condense`
    fn pose_and_condense(
        &self,
        outer: R,
        turn: S::Turn,
        sizes: &Self::Store<PerAxes<S::Size>>,
        x: &mut Self::Store<PerAxes<S::X>>,
        y: &mut Self::Store<PerAxes<S::Y>>,
        p: &mut Self::Store<PerAxes<S::P>>,
        q: &mut Self::Store<PerAxes<S::Q>>,
        given: Given<'_, S, Self, W>,
        kept: &mut Self::Store<Kept<W::Closures>>,
    ) -> Self::Out {
        self.pose(given.position, given.rate, turn, sizes, x, y, p, q);
        self.condense(outer, Posture { x, y, p, q }, given, kept)
    }
}

/// What the walks read of the orientations and angular velocities inside an element: four values for each set of axes, whose
/// meaning is up to the body or joint that owns them. Each of the four has a store of its own, so that sines vectorise for
/// tuples as well as for arrays.
///
/// In the plane a rod keeps its arm (x, y) and the centripetal acceleration (p, q) of its outboard end.
pub struct Posture<'a, S: Space, E: Shape<S>> {
    /// First values.
    pub x: &'a E::Store<PerAxes<S::X>>,
    /// Second values.
    pub y: &'a E::Store<PerAxes<S::Y>>,
    /// Third values.
    pub p: &'a E::Store<PerAxes<S::P>>,
    /// Fourth values.
    pub q: &'a E::Store<PerAxes<S::Q>>,
}

/// What acts in an element besides inertia.
pub struct Given<'a, S: Space, E: Shape<S>, W: Sweep<S>> {
    /// Loads on bodies.
    pub on_bodies: &'a E::Store<PerBody<OnBody<S, W>>>,
    /// Torques in joints.
    pub in_joints: &'a E::Store<PerJoint<InJoint<S, W>>>,
    /// Positions of the joint coordinates for springs; in an implicit sweep those that no acceleration would give.
    pub position: &'a E::Store<Positions>,
    /// Rates of the joint coordinates for dampers; in an implicit sweep those that no acceleration would give.
    pub rate: &'a E::Store<Rates>,
    /// Where laws that are not linear in the coordinates are read in an implicit sweep.
    pub reading: Reading<'a, E::Store<Positions>, E::Store<Rates>>,
    /// How springs enter.
    pub springs: W::Springs,
}

/// The load on a body in a sweep.
pub type OnBody<S, W> = <<W as Sweep<S>>::Loads as Loading<S>>::OnBody;
/// The torque in a joint in a sweep.
pub type InJoint<S, W> = <<W as Sweep<S>>::Loads as Loading<S>>::InJoint;

/// Positions, rates and accelerations of the joint coordinates of an element.
pub struct Coordinates<'a, S: Space, E: Shape<S>> {
    /// Positions.
    pub position: &'a E::Store<Positions>,
    /// Rates.
    pub rate: &'a E::Store<Rates>,
    /// Accelerations.
    pub acceleration: &'a E::Store<Rates>,
}

macro_rules! copy_references {
    ($($name:ident<$($extra:ident: $bound:ident),*>),*) => {$(
        impl<S: Space, E: Shape<S>, $($extra: $bound<S>),*> Clone for $name<'_, S, E, $($extra),*> {
            #[inline(always)]
            fn clone(&self) -> Self {
                *self
            }
        }
        impl<S: Space, E: Shape<S>, $($extra: $bound<S>),*> Copy for $name<'_, S, E, $($extra),*> {}
    )*};
}
copy_references!(Posture<>, Given<W: Sweep>, Coordinates<>);
