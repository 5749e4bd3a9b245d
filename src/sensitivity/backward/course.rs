//! Runs whose joints change their modes, kept for gradients.

use super::Backward;
use super::rules::Staged;
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, RealOf, Unloaded};
use crate::ends::Root;
use crate::error::{Error, Fault, counted};
use crate::loading::{EffortOf, Values};
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::relation::{Additive, Closures};
use crate::scalar::{Elementary, Real, Scalar};
use crate::simulate::anew::Change;
use crate::simulate::{Now, Saved};
use crate::system::{Elements, MotionOf, Runs, System};
use crate::time::{Control, Explicit, IntoRule, Rule};
use alloc::vec::Vec;
use core::cell::RefCell;
use num_traits::One;

/// Loads on bodies and couplings of joints, and efforts in all joints as values.
pub type Acting<S, L> = <L as BodyLaw<S>>::Whole<Values<Vec<EffortOf<S>>>>;

/// A run past changes of mode: its states, and how each follows from that before it. Made by [`Backward::course`].
#[derive(Clone, Debug)]
pub struct Course<M, X, R> {
    /// The start as it was given, and then where the run has begun, the end of each accepted step, and, at the same time, each motion after
    /// modes have changed.
    pub(super) states: Vec<M>,
    /// What has led from each state to the next, and in which interval of efforts.
    pub(super) links: Vec<(Link<R>, usize)>,
    /// Efforts in all joints, held over each interval.
    pub(super) efforts: Vec<X>,
    pub(super) joints: usize,
    pub(super) control: Control<R>,
}

/// A run of a scene.
pub type CourseOf<S, R, C, P> = Course<MotionOf<S, R, C, P>, EffortOf<S>, RealOf<S>>;

/// What has led from a state to the next.
#[derive(Clone, Copy, Debug)]
pub(super) enum Link<R> {
    Step,
    /// Modes have changed, at a time that hangs on the motion.
    Change(Change<R>),
    /// Modes have changed because other efforts act from then on.
    Load,
}

impl<M, X, R> Course<M, X, R> {
    /// The states: the start as it was given, the same with the modes in which the run begins, and what each step ends with; where a mode
    /// changes, the motion before and that after it, at one time.
    pub fn states(&self) -> &[M] {
        &self.states
    }

    /// Numbers of the states in which a change of mode ends, that in which the run begins first.
    pub fn changes(&self) -> impl Iterator<Item = usize> {
        self.links.iter().enumerate().filter(|(_, link)| !matches!(link.0, Link::Step)).map(|(k, _)| k + 1)
    }

    /// Efforts in all joints over an interval.
    pub(super) fn efforts(&self, interval: usize) -> &[X] {
        let first = interval * self.joints;
        self.efforts.get(first..first + self.joints).unwrap_or_default()
    }
}

impl<'s, S, R, C, P, M, L> Backward<'s, S, R, C, P, M, L>
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Explicit + Staged,
    L: BodyLaw<S>,
    Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>> + Burdened<S, L, P::Closures>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
{
    /// Runs a scene whose joints have modes, [`Coulomb`](crate::planar::Coulomb) or [`HardStops`](crate::planar::HardStops), to a time (s) by a rule of this
    /// method, past all that they strike, and where they stick and slip, and keeps its states for [`gradient_past`](Self::gradient_past).
    /// `torques` are those in all joints (the root's first), held over the run, or those over the first of several equal intervals, then those over the
    /// second, and so on; or none.
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::scalar::{Jet, Scalar};
    /// /// A block that falls onto a stop, which gives back a share of its speed.
    /// macro_rules! fall {
    ///     ($share:expr, $number:expr) => {{
    ///         let [zero, one, up] = [0.0, 1.0, std::f64::consts::FRAC_PI_2].map($number);
    ///         let slide = HardStops::between(Slider::along(up), [zero, $number(f64::INFINITY)]).rebounding($share);
    ///         let block = RigidBody::new(one, one, [zero; 2], [zero; 2]);
    ///         System::new(Clamped::origin(), (slide, block), Free)?.with_gravity($number(9.81))
    ///     }};
    /// }
    /// let scene = fall!(0.5, |x: f64| x);
    /// let mut start = scene.motion();
    /// start.set_coordinates(&[1.0])?;
    /// let mut backward = scene.backward(Rk4);
    /// let course = backward.course(&start, Rk4::step(0.01), 1.5 * f64::sqrt(2.0 / 9.81), &[])?; // the block is at its top again
    /// let last = course.states().len() - 1;
    /// let gradient = backward.gradient_past(&course, &mut [], |step, _, by| {
    ///     if step == last { by.add(&[1.0], &[0.0]) } else { Ok(()) }
    /// })?;
    /// // It rises to e² times where it has fallen from.
    /// assert!((gradient.by_position()[0] - 0.25).abs() < 1e-9);
    /// let [by_share] = gradient.along(&fall!(Jet::<f64, 1>::seed(0.5, 0), Jet::of))?;
    /// assert!((by_share - 1.0).abs() < 1e-9);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of the run; [`Fault::Count`] for torques of another number; what [`run`](Self::run) refuses.
    pub fn course(
        &mut self,
        start: &MotionOf<S, R, C, P>,
        rule: impl IntoRule<RealOf<S>, Method = M>,
        end: RealOf<S>,
        torques: &[EffortOf<S>],
    ) -> Result<CourseOf<S, R, C, P>, Error>
    where
        System<S, R, C, P>: Runs<Acting<S, L>, S, R, C, P>,
    {
        let joints = self.steps.scene.joints();
        let intervals = torques.len().div_ceil(joints.max(1)).max(1);
        if !torques.len().is_multiple_of(joints) {
            counted("torques of intervals, one for each joint in each", joints * intervals, torques.len())?;
        }
        self.suits(intervals, torques.len())?;
        if !self.fits(start) {
            return Err(Error::new(Fault::Shape));
        }
        if System::<S, R, C, P>::CLOSED > 0 {
            self.steps.scene.led(start)?;
        }
        let Rule { control, .. } = rule.into_rule();
        let mut efforts = torques.to_vec();
        efforts.resize(joints * intervals, EffortOf::<S>::null());
        let mut course = Course { states: Vec::new(), links: Vec::new(), efforts, joints, control };
        course.states.push(start.clone());
        let mut left = None;
        for interval in 0..intervals {
            let loads = self.steps.loads.law.whole(Values(course.efforts(interval).to_vec()));
            let simulation = self.steps.scene.simulation(Rule { method: self.method, control }).loads(&loads);
            let share = RealOf::<S>::of((interval + 1) as f64 / intervals as f64);
            let until = if interval + 1 == intervals { end } else { start.time + (end - start.time) * share };
            let seen = RefCell::new(None);
            let see = |now: &Now<'_, S, R, C, P, _>| *seen.borrow_mut() = Some(now.stepped().clone());
            let stood = left.as_ref().map(|saved: &Saved<MotionOf<S, R, C, P>, _, _>| saved.motion.clone());
            let (begun, link) = match left.take() {
                None => (simulation.begin(start.clone(), until, see), Link::Change(Change::Begins)),
                Some(saved) => (simulation.resume(saved, until, see), Link::Load),
            };
            let mut run = begun.map_err(|interrupted| interrupted.error)?;
            let mut add = |link, state| {
                course.links.push((link, interval));
                course.states.push(state);
            };
            match &stood {
                Some(stood) if same(stood, run.motion()) => (),
                Some(stood) if !goes_on(stood, run.motion()) => {
                    let what = "the gradient of a run in which a joint strikes just where other torques act";
                    return Err(Error::new(Fault::Unsupported { what }).at_time(run.motion().time.as_f64()));
                }
                _ => add(link, run.motion().clone()),
            }
            loop {
                let before = run.motion().clone();
                if !run.step()? {
                    break;
                }
                let (began, after) = (run.began(), run.motion());
                let size = after.time - began.time;
                if !same(&before, began) {
                    add(Link::Change(Change::Goes(size)), began.clone());
                }
                // What is shown of a step is where it ends, before modes change.
                let ended = seen.take().unwrap_or_else(|| after.clone());
                let changes = !same(&ended, after);
                add(Link::Step, ended);
                if changes {
                    add(Link::Change(Change::Ends(size)), after.clone());
                }
            }
            left = Some(run.save());
        }
        Ok(course)
    }
}

/// Whether a motion goes on from another one without a shock, whatever modes do.
fn goes_on<T: Scalar, P: Position<T>, C: Closures>(from: &Motion<T, P, C>, motion: &Motion<T, P, C>) -> bool {
    let slack = Elementary::sqrt(T::Real::EPSILON);
    from.rate.all(&motion.rate, &mut |a, b| (a - b).real().abs() <= slack * (T::Real::one() + a.real().abs()))
}

/// Whether two motions are of the same numbers and modes.
fn same<T: Scalar, P: Position<T>, C: Closures>(one: &Motion<T, P, C>, other: &Motion<T, P, C>) -> bool {
    one.has_state(other.time, &other.position, &other.rate)
}
