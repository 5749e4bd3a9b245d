//! What a stepper needs of a scene.

use crate::element::{Element, Implicit, Reading, Space};
use crate::ends::{Root, Tip};
use crate::error::Error;
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::relation::Closures;
use crate::scalar::Scalar;
use crate::system::{PositionOf, RateOf, System};

/// Forces that hold the tip of a scene.
pub type Held<D, L> = <<D as Dynamics<L>>::Closures as Closures>::Each<<D as Dynamics<L>>::Scalar>;

/// What a stepper needs of a scene with loads of type `L`: one implementor, [`System`], whose bounds are long.
pub trait Dynamics<L> {
    /// The space.
    type Space: Space<Scalar = Self::Scalar>;
    /// The numbers.
    type Scalar: Scalar;
    /// Positions of the joint coordinates.
    type Position: Position<Self::Scalar, Rate = Self::Rate>;
    /// Rates of the joint coordinates.
    type Rate: Rate<Self::Scalar>;
    /// Forces that hold the tip.
    type Closures: Closures;
    /// Room for sweeps.
    type Workspace;

    /// Whether a tip is held or loops are closed, so that [`project`](Self::project) does something.
    const CLOSED: bool = false;

    /// Room for sweeps.
    fn workspace(&self) -> Self::Workspace;

    /// A motion with all coordinates zero.
    fn still(&self) -> Motion<Self::Scalar, Self::Position, Self::Closures>;

    /// Refuses loads that do not fit the scene's bodies and joints.
    ///
    /// # Errors
    /// [`Count`](crate::error::Fault::Count), [`NoSuchBody`](crate::error::Fault::NoSuchBody).
    fn admits(&self, loads: &L) -> Result<(), Error>;

    /// One sweep: accelerations from time, positions and rates; returns the forces that hold the tip.
    fn accelerations(
        &self,
        time: <Self::Scalar as Scalar>::Real,
        position: &Self::Position,
        rate: &Self::Rate,
        loads: &L,
        workspace: &mut Self::Workspace,
        acceleration: &mut Self::Rate,
    ) -> Held<Self, L>;

    /// Puts the tip of a motion back where it is held, position and velocity, by the least correction of its coordinates, through
    /// the gains of the last sweep (which took place near this motion), and where loads couple joints these, too. Nothing where the tip is free.
    fn project(
        &self,
        motion: &mut Motion<Self::Scalar, Self::Position, Self::Closures>,
        loads: &L,
        workspace: &mut Self::Workspace,
    );

    /// A Newton step of assembly, shortened: moves a motion whose loops are far from closed as [`project`](Self::project) does, but no
    /// coordinate by more than 0.3 (rad, m).
    fn assembly_step(
        &self,
        motion: &mut Motion<Self::Scalar, Self::Position, Self::Closures>,
        loads: &L,
        workspace: &mut Self::Workspace,
    );

    /// Whether the closures that hold the tip and close loops are independent, after a sweep at this motion; reports entries (0 is the
    /// root's joint) and names of those that need not be. Those that are all but dependent count as such, too, down to the `least` share
    /// of what a free body would yield.
    ///
    /// # Errors
    /// [`RedundantClosures`](crate::error::Fault::RedundantClosures), which names one that follows from the others (or cannot be met): a clamped tip on two rods, a
    /// straight chain of rods between two pins.
    fn independent(
        &self,
        motion: &Motion<Self::Scalar, Self::Position, Self::Closures>,
        workspace: &Self::Workspace,
        least: f64,
        report: &mut impl FnMut(usize, &'static str),
    ) -> Result<(), Error>;

    /// Whether a motion may stand: finite, and no angle out of range.
    ///
    /// # Errors
    /// [`NonFiniteMotion`](crate::error::Fault::NonFiniteMotion) or [`AngleOutOfRange`](crate::error::Fault::AngleOutOfRange).
    fn accept(&self, motion: &Motion<Self::Scalar, Self::Position, Self::Closures>) -> Result<(), Error>;

    /// Where and why the sweep at a motion failed, for a motion that came out not finite.
    fn diagnose(
        &self,
        motion: &Motion<Self::Scalar, Self::Position, Self::Closures>,
        loads: &L,
        workspace: &mut Self::Workspace,
    ) -> Error;
}

/// What an implicit stepper needs besides. It is a trait of its own, so that a scene of many types that only takes explicit steps
/// does not make a compiler think about implicit ones.
pub trait StiffDynamics<L>: Dynamics<L> {
    /// Whether no law of a spring or damper has to be read where the last sweep has led.
    const LINEAR: bool;

    /// Room for implicit sweeps.
    type StiffWorkspace;
    /// What joints keep from sweep to sweep.
    type Gains: Clone;

    /// The gains of a workspace: with them, what comes next in another workspace is the same, bit by bit.
    fn gains<'w>(&self, workspace: &'w Self::StiffWorkspace) -> &'w Self::Gains;

    /// The gains of a workspace, to be written.
    fn gains_mut<'w>(&self, workspace: &'w mut Self::StiffWorkspace) -> &'w mut Self::Gains;

    /// Whether gains are of a scene of this shape: only vectors can differ, in length.
    fn gains_fit(&self, gains: &Self::Gains) -> bool;

    /// Copies gains of this shape; allocates nothing.
    fn copy_gains(&self, from: &Self::Gains, to: &mut Self::Gains);

    /// Room for implicit sweeps.
    fn stiff_workspace(&self) -> Self::StiffWorkspace;

    /// One linearly implicit sweep: accelerations from the geometry `at` (positions, rates) and springs that stand at `spring`
    /// (positions, rates) without, and move with, the accelerations sought. Laws that are not linear in their coordinates are read
    /// at a `reading` instead.
    #[allow(clippy::too_many_arguments)] // the data flow of the method, one value each
    fn implicit_accelerations(
        &self,
        time: <Self::Scalar as Scalar>::Real,
        at: (&Self::Position, &Self::Rate),
        spring: (&Self::Position, &Self::Rate),
        reading: Reading<'_, Self::Position, Self::Rate>,
        springs: Implicit<<Self::Scalar as Scalar>::Real>,
        loads: &L,
        workspace: &mut Self::StiffWorkspace,
        acceleration: &mut Self::Rate,
    ) -> Held<Self, L>;

    /// Corrects positions and rates as [`project`](Dynamics::project) does, through the gains of the last implicit sweep.
    fn project_stiff(
        &self,
        motion: &mut Motion<Self::Scalar, Self::Position, Self::Closures>,
        loads: &L,
        workspace: &mut Self::StiffWorkspace,
    );
}

/// A system whose chain can be swept with loads of type `L`: the bound to write in code that is generic over scenes.
///
/// It suffices for explicit rules. Code that hands a generic scene to an implicit rule bounds it by [`StiffDynamics`] too.
///
/// ```
/// use catena::loading::Unloaded;
/// use catena::system::Element;
/// use catena::planar::*;
/// use catena::system::Runs;
/// use catena::{Error, Scalar};
///
/// /// The last angle of a hanging chain after a second.
/// fn last_angle<T: Scalar<Real = f64>, C>(chain: C, angles: &[T]) -> Result<T, Error>
/// where
///     C: Element<Planar<T>>,
///     System<T, Pinned<[T; 2]>, C, Free>: Runs<Unloaded, Planar<T>, Pinned<[T; 2]>, C, Free>,
/// {
///     let system = System::new(Pinned::origin(), chain, Free)?.with_gravity(T::literal(9.81));
///     let run = system.simulate(system.at_rest(angles)?, Rk4::step(0.01), 1.0, |_| ())?;
///     Ok(system.angles(&run.motion)?.iter().last().copied().unwrap_or(T::zero()))
/// }
/// let rod = Rod::uniform(1.0, 1.0);
/// assert!(last_angle((rod, Pin, rod), &[0.0, 0.0])? < 0.0);
/// # Ok::<(), Error>(())
/// ```
pub trait Runs<L, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>>:
    Dynamics<
        L,
        Space = S,
        Scalar = S::Scalar,
        Position = PositionOf<S, R, C>,
        Rate = RateOf<S, R, C>,
        Closures = P::Closures,
    >
{
}

impl<L, S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> Runs<L, S, R, C, P> for System<S, R, C, P> where
    Self: Dynamics<
            L,
            Space = S,
            Scalar = S::Scalar,
            Position = PositionOf<S, R, C>,
            Rate = RateOf<S, R, C>,
            Closures = P::Closures,
        >
{
}
