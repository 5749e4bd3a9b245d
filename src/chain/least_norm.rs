//! Loops that are held more often than they can move.

use crate::element::Space;
use crate::error::Fault;
use crate::lift::lift;
use crate::relation::{Cut, Shared, WrenchOf};
use crate::shape::{Closing, Ends};
use crate::space::FrameOf;

/// A joint that closes a loop where some of its closures follow from others, as in a planar linkage of revolutes in space. It moves as
/// with the joint itself; of all forces that cause this motion those of least norm are taken (the sum of squares in N² and (N·m)²).
/// [`System::shared_forces`](crate::system::System::shared_forces) says which of them are not unique: rigid bodies do not decide how
/// these are shared out. Of loops within loops the forces of the outer one are chosen first. A closure counts as one that follows from others where a
/// posture within 3e-3 rad of the present one has it so: as near to a dead point as that it is not told from there.
///
/// ```
/// use catena::loading::Unloaded;
/// use catena::spatial::*;
/// // A four-bar linkage: revolutes about z hold it in its plane, and so would the last one.
/// let (hinge, rod) = (Revolute::about([0.0, 0.0, 1.0]), Rod::uniform(0.5_f64, 0.02, 0.5));
/// let arms = (hinge, rod, hinge, Rod::uniform(1.0, 0.02, 1.0));
/// let (reach, last) = (RigidBody::massless([1.0, 0.0, 0.0]), LeastNorm(hinge));
/// let scene = System::new(Clamped::origin(), Network::new(arms, (reach, hinge, rod), last), Free)?.with_gravity([0.0, -9.81, 0.0]);
/// let start = scene.assembled(scene.at_rest(&[1.5, -1.4, 1.6])?, &Unloaded)?;
/// let mut shared = 0;
/// scene.shared_forces(&start, &Unloaded, |_station, _name| shared += 1)?;
/// assert_eq!(shared, 3); // z of the ends, and both torques across the axis
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct LeastNorm<K>(pub K);

impl<S: Space, K: Closing<S, Closures = Cut<L>>, const L: usize> Closing<S> for LeastNorm<K> {
    type Closures = Shared<L>;
    type PerAxes<X: Copy> = K::PerAxes<X>;

    fn per_axes<X: Copy>(fill: X) -> K::PerAxes<X> {
        K::per_axes(fill)
    }
    #[cfg_attr(optimised, inline(always))]
    fn orient(
        &self,
        side: S::Turn,
        main: S::Turn,
        x: &mut K::PerAxes<S::X>,
        y: &mut K::PerAxes<S::Y>,
        p: &mut K::PerAxes<S::P>,
        q: &mut K::PerAxes<S::Q>,
    ) {
        self.0.orient(side, main, x, y, p, q);
    }
    fn joint(&self, side: &FrameOf<S>, main: &FrameOf<S>) -> S::JointMotion {
        self.0.joint(side, main)
    }
    fn internal(&self, forces: &[S::Scalar; L], axes: Ends<'_, S, Self>) -> WrenchOf<S> {
        self.0.internal(forces, axes.of())
    }
    fn residual(&self, side: &FrameOf<S>, main: &FrameOf<S>) -> [[S::Scalar; L]; 2] {
        self.0.residual(side, main)
    }
    fn free_compliance(&self, body: &S::BodyMotion) -> [S::Scalar; L] {
        self.0.free_compliance(body)
    }
    fn names(&self) -> [&'static str; L] {
        self.0.names()
    }
    fn check(&self) -> Result<(), Fault> {
        self.0.check()
    }
}

impl<'a, S: Space, K: Closing<S>> Ends<'a, S, LeastNorm<K>>
where
    LeastNorm<K>: Closing<S, PerAxes<S::X> = K::PerAxes<S::X>>
        + Closing<S, PerAxes<S::Y> = K::PerAxes<S::Y>>
        + Closing<S, PerAxes<S::P> = K::PerAxes<S::P>>
        + Closing<S, PerAxes<S::Q> = K::PerAxes<S::Q>>,
{
    /// What the joint itself has kept.
    #[inline(always)]
    pub fn of(self) -> Ends<'a, S, K> {
        Ends { x: self.x, y: self.y, p: self.p, q: self.q }
    }
}

lift!(LeastNorm<K> { 0 });
