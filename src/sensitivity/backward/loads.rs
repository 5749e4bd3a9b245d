//! Loads on bodies, in runs and in a stage of a step.

use super::Backward;
use super::rules::Staged;
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip, Surveyed};
use crate::element::{Coordinates, Element, Level, Posture, RealOf, Space, Unloaded};
use crate::ends::Root;
use crate::loading::{Load, Loading};
use crate::mirror::Rate;
use crate::relation::{Absent, Wrench, WrenchOf};
use crate::scalar::Scalar;
use crate::shape::{PerBody, PerJoint};
use crate::space::FrameOf;
use crate::system::{Elements, Runs, System};
use crate::visit::{Visit, Watch, survey, survey_posed};
use crate::walks::posed::travel_posed;
use crate::walks::pull_loads::PullLoads;
use crate::walks::travel::show;

/// A law of loads, and what it was last told.
pub(super) struct Seen<S: Reversed, E: Element<S>, L: BodyLaw<S>> {
    pub(super) law: L,
    /// What the law has seen of all bodies.
    seen: Surveyed<S, L>,
    /// Frames of bodies and the loads on them.
    #[allow(clippy::type_complexity)] // two in one entry
    pub(super) on_bodies: E::Store<PerBody<(FrameOf<S>, WrenchOf<S>)>>,
    /// What a visitor keeps of joints.
    in_joints: E::Store<PerJoint<()>>,
}

impl<S: Reversed, E: Element<S>, L: BodyLaw<S>> Seen<S, E, L> {
    pub(super) fn new(elements: &E, law: L, ground: FrameOf<S>) -> Self {
        let on_bodies = elements.store::<PerBody<_>>((ground, Wrench::none()));
        let (seen, in_joints) = (law.beside(Absent).unseen(), elements.store::<PerJoint<_>>(()));
        Self { law, seen, on_bodies, in_joints }
    }

    /// Finds frames of bodies that are posed, and the loads on them; gives the frame of the tip.
    pub(super) fn see(
        &mut self,
        elements: &E,
        ground: FrameOf<S>,
        posture: Posture<'_, S, E>,
        motion: Coordinates<'_, S, E>,
        time: RealOf<S>,
    ) -> FrameOf<S> {
        let loads = self.law.beside(Absent);
        self.seen = survey_posed(elements, ground, posture, motion, &loads);
        let visit = Telling { loads, seen: &self.seen, time, body: 0 };
        travel_posed(elements, ground, posture, motion, visit, &mut self.on_bodies, &mut self.in_joints)
    }

    /// The walk that finds costates of what it was told.
    pub(super) fn pull(&self, elements: &E, time: RealOf<S>, level: Level, of_law: L::OfNumbers) -> PullLoads<L, S> {
        let (law, seen) = (self.law, (self.seen.clone(), L::unstirred()));
        PullLoads { law, seen, surveys: false, time, body: elements.bodies(), level, of_law }
    }
}

/// Whether a law gives other loads for one motion at other times: its gradient lacks what these change.
pub(super) fn depend_on_time<S: Reversed, E: Element<S>, L: BodyLaw<S>>(
    law: L,
    elements: &E,
    ground: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    times: &[RealOf<S>],
) -> bool {
    let loads = law.beside(Absent);
    let seen = survey(elements, ground, motion, &loads);
    let mut compared = Compared { loads, seen, times, body: 0, differ: false };
    show(elements, ground, motion, &mut compared);
    compared.differ
}

/// Compares what a law gives at several times.
struct Compared<'t, S: Space, L: Loading<S>> {
    loads: L,
    seen: L::Seen,
    times: &'t [RealOf<S>],
    body: usize,
    differ: bool,
}

impl<S: Reversed, L: Loading<S>> Watch<S> for Compared<'_, S, L> {
    fn body(&mut self, motion: &S::BodyMotion) {
        let at = |time: &RealOf<S>| S::numbers(self.loads.on_body(&self.seen, *time, self.body, motion).wrench());
        for pair in self.times.windows(2) {
            at(&pair[0]).all(&at(&pair[1]), &mut |one, other| {
                self.differ |= one.real() != other.real();
                true
            });
        }
        self.body += 1;
    }
}

/// Tells the law of each body.
struct Telling<'s, S: Space, L: Loading<S>> {
    loads: L,
    seen: &'s L::Seen,
    time: RealOf<S>,
    body: usize,
}

impl<S: Reversed, L: Loading<S>> Visit<S> for Telling<'_, S, L> {
    type OnBody = (FrameOf<S>, WrenchOf<S>);
    type InJoint = ();

    fn body(&mut self, motion: &S::BodyMotion) -> (FrameOf<S>, WrenchOf<S>) {
        self.body += 1;
        (S::inboard(motion), self.loads.on_body(self.seen, self.time, self.body - 1, motion).wrench())
    }
    fn joint(&mut self, _: &S::JointMotion) {}
}

impl<'s, S, R, C, P, M> Backward<'s, S, R, C, P, M>
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Staged,
    Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
{
    /// Runs and gradients under loads on bodies, forces of a medium or of springs to fixed points: a law that is generic over the scalar and
    /// [`lift!`](crate::lift!)ed, which goes backward by itself, by jets of what a body tells it and of its own numbers, six or less.
    ///
    /// ```
    /// use catena::loading::LoadLaw;
    /// use catena::planar::*;
    /// use catena::{Scalar, sensitivity::Costate};
    /// /// Drag in proportion to the velocity of the outboard end (N·s/m).
    /// #[derive(Clone, Copy)]
    /// struct Drag<T> {
    ///     drag: T,
    /// }
    /// catena::lift!(Drag { drag });
    /// impl<T: Scalar> LoadLaw<BodyMotion<T>> for Drag<T> {
    ///     type Value = Wrench<T>;
    ///     fn at(&self, _time: T::Real, _body: usize, motion: &BodyMotion<T>) -> Wrench<T> {
    ///         let force = motion.outboard().velocity * -self.drag;
    ///         Wrench { force, torque: motion.arm.perp(&force) } // about the inboard end
    ///     }
    /// }
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let mut states = [pendulum.at_rest(&[-1.0, -0.5])?; 101];
    /// let (start, mut backward) = (states[0], pendulum.backward(Rk4).under(Drag { drag: 0.2 }));
    /// backward.run(&start, 0.01, 100, &[], &mut states)?;
    /// let end = |step: usize, _: &_, by: &mut Costate<_>| match step {
    ///     100 => by.add(&[0.0; 2], &[0.0, 1.0]),
    ///     _ => Ok(()),
    /// };
    /// let gradient = backward.gradient(&[], &states, &mut [], end)?;
    /// let [by_drag] = *gradient.by_loads()? else { unreachable!() };
    /// # let speed = |drag: f64| -> Result<f64, catena::Error> {
    /// #     let law = Drag { drag };
    /// #     let run = pendulum.simulation(Rk4::step(0.01)).loads(&Loads::none().on_bodies_by(law)).run(start, 1.0, |_| ())?;
    /// #     Ok(run.motion.rates()[1])
    /// # };
    /// # assert!((by_drag - (speed(0.2001)? - speed(0.1999)?) / 2e-4).abs() < 1e-6 * by_drag.abs());
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// Under [`Struts`](crate::struts::Struts), too, alone or beside such a law
    /// ([`Struts::and`](crate::struts::Struts::and)): derivatives by their numbers are in
    /// [`Gradient::by_struts`](crate::sensitivity::Gradient::by_struts), and along whatever makes them in
    /// [`Gradient::along_struts`](crate::sensitivity::Gradient::along_struts). A strut reads the motions of both bodies: gradients walk over all
    /// bodies once more. Run and gradient take the instructions of 7.0 plain runs under the same struts (RK4, twenty rods on pins, ten struts;
    /// x86-64-v3).
    ///
    /// Under [`Couplings`](crate::planar::Couplings) of joints, too, alone or beside a law or struts
    /// ([`Couplings::and`](crate::planar::Couplings::and)); derivatives by their ratios and offsets are in
    /// [`Gradient::by_ratios`](crate::sensitivity::Gradient::by_ratios) and [`by_offsets`](crate::sensitivity::Gradient::by_offsets), and along whatever makes them in
    /// [`Gradient::along_couplings`](crate::sensitivity::Gradient::along_couplings). A sweep of `K` of them is an elimination more and `K` solutions
    /// through its gains; costates take one more.
    ///
    /// Under a [`ForceElement`](crate::planar::ForceElement) whose law is a struct, too, alone, beside such a law or after couplings: derivatives by its
    /// numbers are in [`Gradient::by_force`](crate::sensitivity::Gradient::by_force).
    ///
    /// What a law reads of a body, the place of its mass centre, say, is in [`Gradient::along`](crate::sensitivity::Gradient::along).
    /// A law that does not fit the scene ([`LoadLaw::check`](crate::loading::LoadLaw::check)) is refused by whatever runs or differentiates.
    /// Run and gradient take the instructions of 6.3 plain runs under the same loads (RK4, twenty rods on pins, drag on each; x86-64-v3). Room is
    /// made anew.
    pub fn under<N: BodyLaw<S>>(self, law: N) -> Backward<'s, S, R, C, P, M, N>
    where
        Elements<S, R, C>: Burdened<S, N, P::Closures>,
    {
        Backward { assembled: self.assembled, ..Backward::new(self.steps.scene, self.method, law) }
    }
}
