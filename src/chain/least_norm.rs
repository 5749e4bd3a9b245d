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
/// these are shared out. Of loops within loops the forces of the outer one are chosen first.
///
/// **Near dead points** closures that are needed hold down to about 1e-5 rad (in single precision 1e-2 rad): there what the loop yields to them
/// is no more than axes given to six digits leave of those that follow from others. Nearer than that accelerations are those of the dead point itself,
/// where a closure less holds: what passes strays by a few 1e-5 rad at most before it is held again, what is to rest there chatters so, in very many steps, or
/// ends in an error. Where closures follow from others in closed postures alone,
/// as in Bennett's linkage, they also do so where the loop is open, as far as that explains what it yields.
///
/// **Loops that cannot close**, for a pivot out of the plane, an axis that leans, or two drives that contradict each other, are no such loops: where corrections
/// leave more open than 1e-5 of the way around the loop (of turns, rad), which numbers of six digits do not, `assembled`, `equilibrium` and the start of a run are
/// [`NotClosed`](crate::Fault::NotClosed); a run ends so where they come apart by 1e-4 of that (in single precision 1e-4 each), under error control as the
/// [`Cause`](crate::Cause) of steps that have become too small. Axes that disagree by more than some millionths, where the loop still closes, hold it as they would:
/// it stands still.
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
