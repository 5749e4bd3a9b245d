//! What a stepper needs of a scene.

use crate::element::{
    Carrying, Close, Condense, Coordinates, Element, Explicit, Implicit, Loading, RealOf, Space, Sweep, Visit,
};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::observe::each_body;
use crate::relation::Closures;
use crate::scalar::{Real, Scalar};
use crate::solve::riccati::{Spring, Workspace, broken_load, correction, sweep};
use crate::system::{Elements, MotionOf, PositionOf, RateOf, System, coordinates};

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
    /// Their rates.
    type Rate: Rate<Self::Scalar>;
    /// Forces that hold the tip.
    type Closures: Closures;
    /// Room for sweeps.
    type Workspace;

    /// Room for sweeps.
    fn workspace(&self) -> Self::Workspace;

    /// A motion with all coordinates zero.
    fn still(&self) -> Motion<Self::Scalar, Self::Position, Self::Closures>;

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
    /// the gains of the last sweep (which took place near this motion). Nothing where the tip is free.
    fn project(
        &self,
        motion: &mut Motion<Self::Scalar, Self::Position, Self::Closures>,
        workspace: &mut Self::Workspace,
    );

    /// Whether the closures that hold the tip are independent, after a sweep at this motion.
    ///
    /// # Errors
    /// [`Fault::RedundantClosures`], which names one that follows from the others (or cannot be met): a clamped tip on two rods, a
    /// straight chain of rods between two pins.
    fn independent(
        &self,
        motion: &Motion<Self::Scalar, Self::Position, Self::Closures>,
        workspace: &Self::Workspace,
    ) -> Result<(), Error>;

    /// Whether a motion may stand: finite, and no angle out of range.
    ///
    /// # Errors
    /// [`Fault::NonFiniteMotion`] or [`Fault::AngleOutOfRange`].
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
    /// Room for implicit sweeps.
    type StiffWorkspace;

    /// Room for implicit sweeps.
    fn stiff_workspace(&self) -> Self::StiffWorkspace;

    /// One linearly implicit sweep: accelerations from the geometry `at` (positions, rates) and springs that stand at `spring`
    /// (positions, rates) without, and move with, the accelerations sought.
    #[allow(clippy::too_many_arguments)] // the data flow of the method, one value each
    fn implicit_accelerations(
        &self,
        time: <Self::Scalar as Scalar>::Real,
        at: (&Self::Position, &Self::Rate),
        spring: (&Self::Position, &Self::Rate),
        springs: Implicit<<Self::Scalar as Scalar>::Real>,
        loads: &L,
        workspace: &mut Self::StiffWorkspace,
        acceleration: &mut Self::Rate,
    ) -> Held<Self, L>;

    /// The same through the gains of the last implicit sweep.
    fn project_stiff(
        &self,
        motion: &mut Motion<Self::Scalar, Self::Position, Self::Closures>,
        workspace: &mut Self::StiffWorkspace,
    );
}

/// A system whose chain can be swept with loads of type `L`: the bound to write in code that is generic over scenes.
///
/// It suffices for explicit rules. Code that hands a generic scene to an implicit rule bounds it by [`StiffDynamics`] too.
///
/// ```
/// use catena::element::{Element, Unloaded};
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
///     Ok(system.angles(&run.motion).iter().last().copied().unwrap_or(T::zero()))
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

impl<S, R, C, P, L> Dynamics<L> for System<S, R, C, P>
where
    S: Space,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    L: Loading<S>,
    Elements<S, R, C>: Condense<S, P::Relation, Carrying<L, Explicit, P::Closures>, Out: Close<S, P::Closures>>,
{
    type Space = S;
    type Scalar = S::Scalar;
    type Position = <Elements<S, R, C> as Element<S>>::Position;
    type Rate = RateOf<S, R, C>;
    type Closures = P::Closures;
    type Workspace = Workspace<S, Elements<S, R, C>, Carrying<L, Explicit, P::Closures>>;

    fn workspace(&self) -> Self::Workspace {
        Workspace::new(&self.chain)
    }

    fn still(&self) -> MotionOf<S, R, C, P> {
        self.motion()
    }

    #[inline(never)] // one copy, however many stages and rules call it: a scene of sixty bodies is a large function
    fn accelerations(
        &self,
        time: RealOf<S>,
        position: &Self::Position,
        rate: &Self::Rate,
        loads: &L,
        workspace: &mut Self::Workspace,
        acceleration: &mut Self::Rate,
    ) -> Held<Self, L> {
        let site = self.site(time, loads);
        let spring = Spring { position, rate, springs: Explicit };
        sweep(&self.chain, &site, position, rate, &spring, workspace, acceleration);
        workspace.multipliers
    }

    fn project(&self, motion: &mut MotionOf<S, R, C, P>, workspace: &mut Self::Workspace) {
        self.project_by(motion, workspace);
    }

    fn independent(&self, motion: &MotionOf<S, R, C, P>, workspace: &Self::Workspace) -> Result<(), Error> {
        if P::Closures::COUNT == 0 {
            return Ok(());
        }
        let mut measure = None;
        let ground = self.root.ground(motion.time);
        each_body(&self.chain, ground, coordinates(motion), |body| {
            measure = Some(self.tip.free_compliance(motion.time, body)); // that of the last body stays
        });
        let dependent = measure.and_then(|measure| P::Closures::dependent(workspace.compliance(), &measure));
        let Some((row, independent)) = dependent else {
            return Ok(());
        };
        let (mut closure, mut number) = ("", 0);
        P::Closures::map(&self.tip.names(), |name| {
            if number == row {
                closure = name;
            }
            number += 1;
        });
        let fault = Fault::RedundantClosures { closure, independent, of: P::Closures::COUNT };
        Err(Error::new(fault).at_time(motion.time.as_f64()).at(Place::Tip))
    }

    fn accept(&self, motion: &MotionOf<S, R, C, P>) -> Result<(), Error> {
        let (mut finite, mut far) = (true, false);
        motion.position.visit(&mut |x| {
            finite &= x.is_finite();
            far |= x.real().abs() > S::Scalar::ANGLE_RANGE;
        });
        motion.rate.visit(&mut |x| finite &= x.is_finite());
        motion.acceleration.visit(&mut |x| finite &= x.is_finite());
        let error = |fault| Err(Error::new(fault).at_time(motion.time.as_f64()));
        if !finite {
            return error(Fault::NonFiniteMotion);
        }
        if far {
            let mut angle = None;
            let ground = self.root.ground(motion.time);
            each_body(&self.chain, ground, coordinates(motion), |body| angle = angle.or(S::angle_out_of_range(body)));
            if let Some(angle) = angle {
                return error(Fault::AngleOutOfRange { angle });
            }
        }
        Ok(())
    }

    fn diagnose(&self, motion: &MotionOf<S, R, C, P>, loads: &L, workspace: &mut Self::Workspace) -> Error {
        let time = motion.time;
        let error = |fault| Error::new(fault).at_time(time.as_f64());
        let place = |entry: usize| entry.checked_sub(1).map_or(Place::Root, Place::Station); // entry 0: the root's joint
        let mut finite = true;
        motion.position.visit(&mut |x| finite &= x.is_finite());
        motion.rate.visit(&mut |x| finite &= x.is_finite());
        if !finite {
            return error(Fault::NonFiniteMotion);
        }
        if !S::is_finite(self.gravity) {
            return error(Fault::NotFinite { parameter: "gravity" });
        }
        let ground = self.root.ground(time);
        if !S::frame_is_finite(&ground) {
            return error(Fault::NotFinite { parameter: "motion of the ground" }).at(Place::Root);
        }
        let coordinates =
            Coordinates { position: &motion.position, rate: &motion.rate, acceleration: &motion.acceleration };
        if let Some(entry) = broken_load(&self.chain, &ground, loads, time, coordinates) {
            return error(Fault::NonFiniteLoad).at(place(entry));
        }
        let mut acceleration = motion.acceleration.clone();
        self.accelerations(time, &motion.position, &motion.rate, loads, workspace, &mut acceleration);
        match self.chain.broken::<P::Closures>(&workspace.kept, 0) {
            Some(entry) => error(Fault::SingularJoint).at(place(entry)),
            None => error(Fault::NonFiniteMotion),
        }
    }
}

impl<S, R, C, P, L> StiffDynamics<L> for System<S, R, C, P>
where
    S: Space,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    L: Loading<S>,
    Self: Runs<L, S, R, C, P>,
    Elements<S, R, C>:
        Condense<S, P::Relation, Carrying<L, Implicit<RealOf<S>>, P::Closures>, Out: Close<S, P::Closures>>,
{
    type StiffWorkspace = Workspace<S, Elements<S, R, C>, Carrying<L, Implicit<RealOf<S>>, P::Closures>>;

    fn stiff_workspace(&self) -> Self::StiffWorkspace {
        Workspace::new(&self.chain)
    }

    #[inline(never)]
    fn implicit_accelerations(
        &self,
        time: RealOf<S>,
        (position, rate): (&Self::Position, &Self::Rate),
        spring: (&Self::Position, &Self::Rate),
        springs: Implicit<RealOf<S>>,
        loads: &L,
        workspace: &mut Self::StiffWorkspace,
        acceleration: &mut Self::Rate,
    ) -> Held<Self, L> {
        let site = self.site(time, loads);
        let spring = Spring { position: spring.0, rate: spring.1, springs };
        sweep(&self.chain, &site, position, rate, &spring, workspace, acceleration);
        workspace.multipliers
    }

    fn project_stiff(&self, motion: &mut MotionOf<S, R, C, P>, workspace: &mut Self::StiffWorkspace) {
        self.project_by(motion, workspace);
    }
}

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    fn project_by<W: Sweep<S, Closures = P::Closures>>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        workspace: &mut Workspace<S, Elements<S, R, C>, W>,
    ) {
        // A constant, so that a compiler does not even look at what follows where the tip is free.
        if const { P::Closures::COUNT == 0 } {
            return;
        }
        // The gains belong to a configuration nearby, so one correction leaves an error of second order: two passes.
        for _ in 0..2 {
            let [place, _] = self.miss(motion);
            if let Some(step) = correction(&self.chain, workspace, &place) {
                motion.position.displace(step);
            }
        }
        let [_, velocity] = self.miss(motion);
        if let Some(step) = correction(&self.chain, workspace, &velocity) {
            motion.rate.add(step);
        }
    }

    /// By how much the tip misses its place and velocity.
    pub(super) fn miss(&self, motion: &MotionOf<S, R, C, P>) -> [<P::Closures as Closures>::Each<S::Scalar>; 2] {
        let (mut bodies, mut joints) = (self.chain.per_body(()), self.chain.per_joint(()));
        let ground = self.root.ground(motion.time);
        let frame = self.chain.travel(ground, coordinates(motion), &mut Look, &mut bodies, &mut joints);
        self.tip.miss(motion.time, &frame)
    }
}

/// Looks at nothing: for the frame at the end of the walk.
struct Look;

impl<S: Space> Visit<S> for Look {
    type OnBody = ();
    type InJoint = ();
    fn body(&mut self, _: &S::BodyMotion) {}
    fn joint(&mut self, _: &S::JointMotion) {}
}
