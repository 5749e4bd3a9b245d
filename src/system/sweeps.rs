//! The sweeps of a scene, and what went wrong where.

use super::dynamics::{Dynamics, Held, Runs, StiffDynamics};
use super::hold::shorten;
use crate::element::{
    Carrying, Close, Condense, Coordinates, Element, Explicit, Implicit, Level, Loading, Reading, RealOf, Space, Watch,
};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::loading::Yields;
use crate::mirror::{Position, Rate};
use crate::relation::{Closures, Solvable, VectorSpace};
use crate::release::Release;
use crate::scalar::{Real, Scalar};
use crate::shape::{Kept, Shape};
use crate::solve::riccati::{Spring, Workspace, broken_load};
use crate::space::{MovingBody, MovingJoint};
use crate::system::{Elements, MotionOf, RateOf, System, coordinates};
use crate::visit::last_body;
use crate::walks::broken::{broken, unled};
use crate::walks::copy::copy;
use crate::walks::fits::gains_fit;
use crate::walks::independent::independent;
use crate::walks::travel::show;

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

    const CLOSED: bool = Self::CLOSED > 0;

    fn workspace(&self) -> Self::Workspace {
        Workspace::new(&self.chain)
    }

    fn still(&self) -> MotionOf<S, R, C, P> {
        self.motion()
    }

    fn admits(&self, loads: &L) -> Result<(), Error> {
        self.loadable(loads)
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
        let reading = Reading { position, rate, acceleration: rate };
        let spring = Spring { position, rate, reading, springs: Explicit };
        self.sweep_under(time, (position, rate), &spring, loads, workspace, acceleration);
        workspace.multipliers
    }

    fn project(&self, motion: &mut MotionOf<S, R, C, P>, loads: &L, workspace: &mut Self::Workspace) {
        self.project_by(motion, loads, workspace);
    }

    fn assembly_step(&self, motion: &mut MotionOf<S, R, C, P>, loads: &L, workspace: &mut Self::Workspace) {
        let responses = core::mem::take(&mut workspace.responses);
        if let Some(step) = self.correct(Level::Place, motion, (loads, &responses), workspace) {
            let mut step = step.clone();
            shorten(&mut step);
            motion.position.displace(&step);
        }
        workspace.responses = responses;
    }

    fn independent(
        &self,
        motion: &MotionOf<S, R, C, P>,
        workspace: &Self::Workspace,
        least: f64,
        report: &mut impl FnMut(usize, &'static str),
    ) -> Result<(), Error> {
        let ground = self.root.ground(motion.time);
        if const { <Elements<S, R, C> as Shape<S>>::LOOPS > 0 } {
            independent::<S, _, P::Closures>(&self.chain, ground, coordinates(motion), &workspace.kept, least, report)
                .map_err(|error| error.at_time(motion.time.as_f64()).beyond_root())?;
        }
        if P::Closures::COUNT == 0 {
            return Ok(());
        }
        let last = last_body(&self.chain, ground, coordinates(motion));
        let measure = last.map(|body| self.tip.free_compliance(motion.time, &body));
        let dependent = measure.and_then(|measure| P::Closures::dependent(workspace.compliance(), &measure, least));
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
        self.stands(motion)?;
        self.holds_together(motion)
    }

    fn diagnose(&self, motion: &MotionOf<S, R, C, P>, loads: &L, workspace: &mut Self::Workspace) -> Error {
        let time = motion.time;
        let place = |entry: usize| entry.checked_sub(1).map_or(Place::Root, Place::Station); // entry 0: the root's joint
        let error = |fault| Error::new(fault).at_time(time.as_f64());
        let mut finite = true;
        // So far away pivots would overflow too.
        motion.position.visit(&mut |x| finite &= x.is_finite() && (x * x * x * x).real().is_finite());
        motion.rate.visit(&mut |x| finite &= x.is_finite());
        if !finite {
            return error(Fault::NonFiniteMotion);
        }
        if !self.gravity.all_finite() {
            return error(Fault::NotFinite { parameter: "gravity" });
        }
        if let Err(lost) = self.stands_on_ground(time) {
            return lost;
        }
        let ground = self.root.ground(time);
        if let Some(entry) = unled(&self.chain, ground, &motion.position, &motion.rate) {
            return error(Fault::NotFinite { parameter: "driven coordinate" }).at(place(entry));
        }
        let coordinates =
            Coordinates { position: &motion.position, rate: &motion.rate, acceleration: &motion.acceleration };
        if let Some(entry) = broken_load(&self.chain, &ground, loads, time, coordinates) {
            return error(Fault::NonFiniteLoad).at(place(entry));
        }
        if let Some(angle) = self.angle_out_of_range(motion) {
            return error(Fault::AngleOutOfRange { angle });
        }
        let (mut acceleration, mut rate) = (motion.acceleration.clone(), motion.rate.clone());
        self.accelerations(time, &motion.position, &rate, loads, workspace, &mut acceleration);
        if let Err(redundant) = self.independent(motion, workspace, 0.0, &mut |_, _| ()) {
            return redundant;
        }
        if broken::<S, _, P::Closures>(&self.chain, &workspace.kept).is_none() {
            return error(Fault::NonFiniteMotion);
        }
        // A joint that nothing resists does not move at rest either; one at which the forces of velocities overflow does.
        rate.replace(&mut |_| S::Scalar::constant(RealOf::<S>::of(0.0)));
        self.accelerations(time, &motion.position, &rate, loads, workspace, &mut acceleration);
        match broken::<S, _, P::Closures>(&self.chain, &workspace.kept) {
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
    const LINEAR: bool = <Elements<S, R, C> as Shape<S>>::LINEAR && matches!(L::YIELDS, Yields::Never);

    type StiffWorkspace = Workspace<S, Elements<S, R, C>, Carrying<L, Implicit<RealOf<S>>, P::Closures>>;

    type Gains = <Elements<S, R, C> as Shape<S>>::Store<Kept<P::Closures>>;

    fn gains<'w>(&self, workspace: &'w Self::StiffWorkspace) -> &'w Self::Gains {
        &workspace.kept
    }

    fn gains_mut<'w>(&self, workspace: &'w mut Self::StiffWorkspace) -> &'w mut Self::Gains {
        &mut workspace.kept
    }

    fn gains_fit(&self, gains: &Self::Gains) -> bool {
        gains_fit::<S, _, P::Closures>(&self.chain, gains)
    }

    fn copy_gains(&self, from: &Self::Gains, to: &mut Self::Gains) {
        copy::<S, _, Kept<P::Closures>>(&self.chain, from, to);
    }

    fn stiff_workspace(&self) -> Self::StiffWorkspace {
        Workspace::new(&self.chain)
    }

    #[inline(never)]
    fn implicit_accelerations(
        &self,
        time: RealOf<S>,
        (position, rate): (&Self::Position, &Self::Rate),
        spring: (&Self::Position, &Self::Rate),
        reading: Reading<'_, Self::Position, Self::Rate>,
        springs: Implicit<RealOf<S>>,
        loads: &L,
        workspace: &mut Self::StiffWorkspace,
        acceleration: &mut Self::Rate,
    ) -> Held<Self, L> {
        let spring = Spring { position: spring.0, rate: spring.1, reading, springs };
        self.sweep_under(time, (position, rate), &spring, loads, workspace, acceleration);
        workspace.multipliers
    }

    fn project_stiff(&self, motion: &mut MotionOf<S, R, C, P>, loads: &L, workspace: &mut Self::StiffWorkspace) {
        self.project_by(motion, loads, workspace);
    }
}

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Whether there are loops.
    pub(crate) const LOOPED: bool = <Elements<S, R, C> as Shape<S>>::LOOPS > 0;
    /// How deep closures are nested: loops, and the ground to which a tip is held.
    pub(crate) const CLOSED: usize = C::LOOPS + (P::Closures::COUNT > 0) as usize;

    /// Whether forces of a loop are shared out.
    pub(crate) const SHARES: bool = <Elements<S, R, C> as Shape<S>>::SHARES;

    /// Refuses a motion that is not finite, or an angle out of range.
    pub(crate) fn stands(&self, motion: &MotionOf<S, R, C, P>) -> Result<(), Error> {
        let (mut finite, mut far) = (true, false);
        motion.position.visit(&mut |x| {
            finite &= x.is_finite();
            far |= x.exceeds(S::Scalar::ANGLE_RANGE);
        });
        motion.rate.visit(&mut |x| finite &= x.is_finite());
        motion.acceleration.visit(&mut |x| finite &= x.is_finite());
        let error = |fault| Err(Error::new(fault).at_time(motion.time.as_f64()));
        if !finite {
            return error(Fault::NonFiniteMotion);
        }
        if far && let Some(angle) = self.angle_out_of_range(motion) {
            return error(Fault::AngleOutOfRange { angle });
        }
        self.stands_on_ground(motion.time)
    }

    /// Refuses a ground whose motion is no number.
    fn stands_on_ground(&self, time: RealOf<S>) -> Result<(), Error> {
        if R::RESTS || self.root.ground(time).is_finite() {
            return Ok(());
        }
        let fault = Fault::NotFinite { parameter: "motion of the ground" };
        Err(Error::new(fault).at_time(time.as_f64()).at(Place::Root))
    }

    /// The angle of a body or joint that is too large for accurate sines, if there is one.
    fn angle_out_of_range(&self, motion: &MotionOf<S, R, C, P>) -> Option<f64> {
        let (mut look, ground) = (LookForAngles(None), self.root.ground(motion.time));
        show(&self.chain, ground, coordinates(motion), &mut look);
        look.0
    }
}

/// Looks for an angle out of range.
struct LookForAngles(Option<f64>);

impl<S: Space> Watch<S> for LookForAngles {
    fn body(&mut self, body: &S::BodyMotion) {
        self.0 = self.0.or_else(|| body.angle_out_of_range());
    }
    fn joint_with(&mut self, joint: &S::JointMotion, release: &dyn Fn() -> Release<S>) {
        self.0 = self.0.or_else(|| joint.turn_out_of_range(&release()));
    }
}
