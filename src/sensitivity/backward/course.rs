//! Runs whose joints change their modes, kept for gradients.

use super::Backward;
use super::rules::Staged;
use crate::adjoint::{Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, RealOf, Unloaded};
use crate::ends::Root;
use crate::error::{Error, Fault};
use crate::loading::{EffortOf, Loads, Values};
use crate::mirror::Position;
use crate::motion::Motion;
use crate::relation::{Absent, Additive, Closures};
use crate::scalar::Scalar;
use crate::sensitivity::CourseOf;
use crate::simulate::anew::Change;
use crate::system::{Elements, MotionOf, Runs, System};
use crate::time::{Control, Explicit, IntoRule, Rule};
use alloc::vec::Vec;
use core::cell::RefCell;

/// Efforts in all joints, as values.
pub type Efforts<X> = Loads<Absent, Values<Vec<X>>>;

/// A run past changes of mode: its states, and how each follows from that before it. Made by [`Backward::course`].
#[derive(Clone, Debug)]
pub struct Course<M, X, R> {
    /// The start as it was given, and then where the run has begun, the end of each accepted step, and, at the same time, each motion after
    /// modes have changed.
    pub(super) states: Vec<M>,
    /// What has led from each state to the next: a step, or a change of mode.
    pub(super) links: Vec<Option<Change<R>>>,
    /// Efforts in all joints, held over the run.
    pub(super) efforts: Vec<X>,
    pub(super) control: Control<R>,
}

impl<M, X, R> Course<M, X, R> {
    /// The states: the start as it was given, the same with the modes in which the run begins, and what each step ends with; where a mode
    /// changes, the motion before and that after it, at one time.
    pub fn states(&self) -> &[M] {
        &self.states
    }

    /// Numbers of the states in which a change of mode ends, that in which the run begins first.
    pub fn changes(&self) -> impl Iterator<Item = usize> {
        self.links.iter().enumerate().filter_map(|(k, link)| link.as_ref().map(|_| k + 1))
    }

    fn add(&mut self, link: Option<Change<R>>, state: M) {
        self.links.push(link);
        self.states.push(state);
    }
}

impl<'s, S, R, C, P, M> Backward<'s, S, R, C, P, M>
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Explicit + Staged,
    Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>> + Burdened<S, Absent, P::Closures>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
    EffortOf<S>: Additive,
{
    /// Runs a scene whose joints have modes, [`Coulomb`](crate::planar::Coulomb) or [`HardStops`](crate::planar::HardStops), to a time (s) by a rule of this
    /// method, past all that they strike, and where they stick and slip, and keeps its states for [`gradient_past`](Self::gradient_past).
    /// `torques` are those in all joints, held over the run, or none.
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
        System<S, R, C, P>: Runs<Efforts<EffortOf<S>>, S, R, C, P>,
    {
        self.suits(1, torques.len())?;
        if !self.fits(start) {
            return Err(Error::new(Fault::Shape));
        }
        let Rule { control, .. } = rule.into_rule();
        let mut efforts = torques.to_vec();
        efforts.resize(self.steps.scene.joints(), EffortOf::<S>::null());
        let loads = Loads::none().efforts(efforts.clone());
        let seen = RefCell::new(None);
        let simulation = self.steps.scene.simulation(Rule { method: self.method, control }).loads(&loads);
        let mut run = simulation
            .begin(start.clone(), end, |now| *seen.borrow_mut() = Some(now.stepped().clone()))
            .map_err(|interrupted| interrupted.error)?;
        let mut course = Course { states: Vec::new(), links: Vec::new(), efforts, control };
        course.states.push(start.clone());
        course.add(Some(Change::Begins), run.motion().clone());
        loop {
            let before = run.motion().clone();
            if !run.step()? {
                return Ok(course);
            }
            let (began, after) = (run.began(), run.motion());
            let size = after.time - began.time;
            if !same(&before, began) {
                course.add(Some(Change::Goes(size)), began.clone());
            }
            // What is shown of a step is where it ends, before modes change.
            let ended = seen.take().unwrap_or_else(|| after.clone());
            let changes = !same(&ended, after);
            course.add(None, ended);
            if changes {
                course.add(Some(Change::Ends(size)), after.clone());
            }
        }
    }
}

/// Whether two motions are of the same numbers and modes.
fn same<T: Scalar, P: Position<T>, C: Closures>(one: &Motion<T, P, C>, other: &Motion<T, P, C>) -> bool {
    one.has_state(other.time, &other.position, &other.rate)
}
