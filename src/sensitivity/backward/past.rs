//! Gradients of runs past changes of mode.
//!
//! Between two steps a change of mode takes a motion x⁻ to x⁺, at a time that hangs on x⁻, on the scene and on what acts. Its derivative J = ∂x⁺/∂x⁻
//! at a fixed time has the jump terms of that time in it (`src/simulate/jump.rs`), and costates go back by x̄⁻ = Jᵀ x̄⁺. A change is made once more
//! over jets, whose seeds are eight numbers of x⁻ or torques at a time, or those of the scene that the gradient is asked for along.

use super::at_change::AtChange;
use super::course::{Acting, Course, CourseOf, Link};
use super::rules::Staged;
use super::{Backward, CostateOf, GradientOf};
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, Loading, Space, Unloaded};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::lift::Lift;
use crate::loading::{EffortOf, Values};
use crate::mirror::{Mode, Position, Rate};
use crate::motion::Motion;
use crate::relation::{Absent, Closures, Geometry};
use crate::scalar::{Elementary, Jet, Real, Scalar};
use crate::sensitive::Varied;
use crate::sensitivity::Costate;
use crate::sensitivity::front::parts::{NO_SEEDS, OfNumbers, seeded};
use crate::sensitivity::front::{self, WIDTH};
use crate::simulate::anew::{Change, ChangedOf};
use crate::space::SpaceOver;
use crate::system::{Elements, MotionOf, Runs, System};
use crate::time::{Explicit, Rule};
use alloc::vec::Vec;
use core::marker::PhantomData;
use num_traits::{One, Zero};

/// Numbers with derivatives, and a scene over them.
type Seeded<S> = front::Seeded<<S as Geometry>::Scalar>;
type Over<S> = <S as SpaceOver<Seeded<S>>>::Over;
type Part<S, X> = <X as Lift<<S as Geometry>::Scalar, Seeded<S>>>::Over;

/// The gradient of a cost by all that a run past changes of mode depends on.
pub struct PastGradient<'c, S: Reversed, R: Root<S>, C: Element<S>, P: Tip<S>, M, L: BodyLaw<S> = Absent> {
    /// What steps do.
    pub(in crate::sensitivity) steps: GradientOf<S, R, C, L>,
    course: &'c CourseOf<S, R, C, P>,
    /// What costs hang on at each change of mode, the last change first.
    costates: Vec<(usize, AtChange<S::Scalar>)>,
    method: M,
    law: L,
    of: PhantomData<P>,
}

impl<S, R, C, P, M, L> Backward<'_, S, R, C, P, M, L>
where
    S: Reversed + SpaceOver<Seeded<S>, Over: Varied + Reversed>,
    R: Root<S> + Lift<S::Scalar, Seeded<S>, Over: Root<Over<S>>>,
    C: Element<S> + Lift<S::Scalar, Seeded<S>, Over: Element<Over<S>>>,
    P: ReversibleTip<S> + Lift<S::Scalar, Seeded<S>, Over: Tip<Over<S>>>,
    M: Explicit + Staged,
    L: BodyLaw<S> + Lift<S::Scalar, Seeded<S>, Over: BodyLaw<Over<S>>>,
    Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>> + Burdened<S, L, P::Closures>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
    System<Over<S>, Part<S, R>, Part<S, C>, Part<S, P>>:
        Runs<Acting<Over<S>, Part<S, L>>, Over<S>, Part<S, R>, Part<S, C>, Part<S, P>>,
    EffortOf<S>: OfNumbers<S::Scalar>,
    EffortOf<Over<S>>: OfNumbers<Seeded<S>>,
{
    /// The gradient of a cost by everything, for a run past changes of mode: `cost` is told the number of each of the course's
    /// [states](Course::states), the last first, and adds the derivatives of the cost by its position and rate: of the states on both sides of a
    /// change also by its [time](crate::sensitivity::Costate::time), for these are the states where a mode changes, whenever that is; all others are states at
    /// fixed times. `by_torques` becomes the gradient by the
    /// torques of each interval, or of all summed up; it may be empty. Of what acts on bodies and couples joints ([`under`](Self::under)) the gradient has
    /// [`by_loads`](PastGradient::by_loads), [`by_struts`](PastGradient::by_struts) and [`by_ratios`](PastGradient::by_ratios).
    ///
    /// The steps are those that were accepted, their sizes held, but those that end where a mode changes: when that is hangs on everything. So a
    /// gradient is that of the motion, shocks included, but for what steps err. A step that begins in a mode keeps it: derivatives of the rate of a joint
    /// that does not move are zero, and so are those by the coordinate of one that rests at its stop in the start, for it begins there wherever the stop is.
    ///
    /// # Errors
    /// As [`gradient`](Self::gradient); [`Fault::Unsupported`], with the time, where there are no jump terms ([`Coulomb`](crate::planar::Coulomb) says
    /// where), for a scene over numbers with derivatives, and where it hangs on rounding which modes follow.
    pub fn gradient_past<'c>(
        &mut self,
        course: &'c CourseOf<S, R, C, P>,
        by_torques: &mut [EffortOf<S>],
        mut cost: impl FnMut(usize, &MotionOf<S, R, C, P>, &mut CostateOf<S, R, C>) -> Result<(), Error>,
    ) -> Result<PastGradient<'c, S, R, C, P, M, L>, Error> {
        let Course { states, links, efforts, .. } = course;
        let Some(last) = states.last().filter(|last| self.fits(last)) else { return Err(Error::new(Fault::Shape)) };
        self.suits(efforts.len() / course.joints.max(1), by_torques.len())?;
        let (scene, law) = (self.steps.scene.lift(Jet::of), self.steps.loads.law);
        let (still, method) = (law.lift(&mut Jet::of), self.method);
        let again = |k, change, loads: &_, before| {
            course.changed::<Over<S>, _, _, _, _, _, WIDTH>(k, change, method, &scene, loads, before)
        };
        let mut gradient = self.begin(by_torques);
        let (mut past_changes, mut of_torques) =
            (Vec::new(), alloc::vec![S::Scalar::zero(); numbers_of(efforts).len()]);
        // What the last state asked for adds: as long as it is not known whether that is a state at a fixed time.
        let nothing = {
            let mut rate = last.rate.clone();
            rate.replace(&mut |_| S::Scalar::zero());
            Costate { position: rate.clone(), rate, time: S::Scalar::zero() }
        };
        let mut asked = nothing.clone();
        cost(links.len(), last, &mut asked)?;
        let mut pulled = None;
        for (k, (link, interval)) in links.iter().enumerate().rev() {
            let (past, next) = (&states[k], &states[k + 1]);
            if let Some(later) = pulled.replace(*interval).filter(|later| later != interval) {
                self.steps.give_torques(by_torques, later);
            }
            let mut earlier = nothing.clone();
            cost(k, past, &mut earlier)?;
            match link {
                Link::Step => {
                    gradient.start.and(&asked);
                    let size = next.time - past.time;
                    self.steps.take_torques(efforts, *interval);
                    self.steps.evaluate(past, size, &mut self.record);
                    self.steps.pull_back(past, size, &self.record, None, &mut gradient);
                }
                Link::Change(change) => {
                    let efforts = course.efforts(*interval);
                    let costs = AtChange::of(&gradient.start, [&earlier, &asked]);
                    gradient.start.time += asked.time + earlier.time;
                    let rows = costs.later.len();
                    let count = rows + efforts.len() * EffortOf::<S>::COUNT;
                    let mut before = Vec::with_capacity(count + WIDTH);
                    for first in (0..count).step_by(WIDTH) {
                        let at = scene.with_seeds(of_plain(&scene, past)?, first);
                        let loads = still.whole(Values(seeds(efforts, first.wrapping_sub(rows))));
                        let found = again(k, *change, &loads, at)?;
                        before.extend(costs.contracted(&found)?);
                    }
                    // By numbers of what acts on bodies and couples joints.
                    let mut numbers = 0;
                    L::each_number(&mut gradient.law, &mut |_| numbers += 1);
                    for first in (0..numbers).step_by(WIDTH) {
                        let places = (0..).map(|number: usize| number.wrapping_sub(first));
                        let mut seed = places.clone();
                        let seeded = law.lift(&mut |x| Jet::seed(x, seed.next().unwrap_or(WIDTH)));
                        let loads = seeded.whole(Values(seeds(efforts, NO_SEEDS)));
                        let found = again(k, *change, &loads, of_plain(&scene, past)?)?;
                        let (slopes, mut seed) = (costs.contracted(&found)?, places);
                        L::each_number(&mut gradient.law, &mut |sum| {
                            let slope = seed.next().and_then(|place| slopes.get(place));
                            *sum += slope.copied().unwrap_or(S::Scalar::zero());
                        });
                    }
                    let mut list = before.into_iter();
                    for costate in [&mut gradient.start.position, &mut gradient.start.rate] {
                        costate.replace(&mut |x| list.next().unwrap_or(x));
                    }
                    let first = interval * course.joints * EffortOf::<S>::COUNT;
                    of_torques.iter_mut().skip(first).zip(list).for_each(|(sum, more)| *sum += more);
                    past_changes.push((k, costs));
                    earlier = nothing.clone();
                }
                // At a time that hangs on nothing; positions and rates go on.
                Link::Load => gradient.start.and(&asked),
            }
            asked = earlier;
        }
        gradient.start.and(&asked);
        self.steps.give_torques(by_torques, 0);
        // Of all intervals, or summed up over them.
        let mut numbers = of_torques.chunks_exact(EffortOf::<S>::COUNT);
        while !by_torques.is_empty() && numbers.len() > 0 {
            for (torque, more) in by_torques.iter_mut().zip(&mut numbers) {
                *torque = *torque + EffortOf::<S>::of(more);
            }
        }
        self.finish(&states[0], &mut gradient)?;
        Ok(PastGradient { steps: gradient, course, costates: past_changes, method, law, of: PhantomData })
    }
}

impl<S: Reversed, R: Root<S>, C: Element<S>, P: Tip<S>, M: Explicit, L: BodyLaw<S>> PastGradient<'_, S, R, C, P, M, L> {
    /// By the positions of the start, root to tip, as a list.
    pub fn by_position(&self) -> Vec<S::Scalar> {
        self.steps.by_position()
    }

    /// By its rates.
    pub fn by_rate(&self) -> Vec<S::Scalar> {
        self.steps.by_rate()
    }

    /// By the numbers of the law of loads on bodies: [`Gradient::by_loads`](crate::sensitivity::Gradient::by_loads).
    ///
    /// # Errors
    /// As there.
    pub fn by_loads(&self) -> Result<&[S::Scalar], Error> {
        self.steps.by_loads()
    }

    /// What changes of mode do along the seeds of a scene over jets.
    pub(in crate::sensitivity) fn changes_along<X, Y, Z, W, const K: usize>(
        &self,
        scene: &System<X, Y, Z, W>,
    ) -> Result<[S::Scalar; K], Error>
    where
        X: Reversed<Scalar = Jet<S::Scalar, K>>,
        Y: Root<X>,
        Z: Element<X>,
        W: Tip<X>,
        L: Lift<S::Scalar, Jet<S::Scalar, K>, Over: BodyLaw<X>>,
        System<X, Y, Z, W>: Runs<Acting<X, <L as Lift<S::Scalar, Jet<S::Scalar, K>>>::Over>, X, Y, Z, W>,
        EffortOf<S>: OfNumbers<S::Scalar>,
        EffortOf<X>: OfNumbers<Jet<S::Scalar, K>>,
    {
        let mut sum = [S::Scalar::zero(); K];
        for (k, costs) in &self.costates {
            let (Link::Change(change), interval) = self.course.links[*k] else { continue };
            let at = of_plain(scene, &self.course.states[*k])?;
            let efforts = Values(seeds(self.course.efforts(interval), NO_SEEDS));
            let loads = self.law.lift(&mut Jet::of).whole(efforts);
            let found = self.course.changed(*k, change, self.method, scene, &loads, at)?;
            sum.iter_mut().zip(costs.contracted(&found)?).for_each(|(sum, more)| *sum += more);
        }
        Ok(sum)
    }
}

impl<T: Scalar, Q: Position<T>, D: Closures, E: OfNumbers<T>> Course<Motion<T, Q, D>, E, T::Real> {
    /// The change of mode after a state, made once more of a motion over jets under loads over jets.
    fn changed<X, Y, Z, W, M, A, const K: usize>(
        &self,
        k: usize,
        change: Change<T::Real>,
        method: M,
        scene: &System<X, Y, Z, W>,
        loads: &A,
        before: MotionOf<X, Y, Z, W>,
    ) -> Result<ChangedOf<X, Y, Z, W>, Error>
    where
        X: Space<Scalar = Jet<T, K>>,
        Y: Root<X>,
        Z: Element<X>,
        W: Tip<X>,
        M: Explicit,
        A: Loading<X>,
        System<X, Y, Z, W>: Runs<A, X, Y, Z, W>,
    {
        let rule = Rule { method, control: self.control };
        let began = of_plain(scene, &self.states[k.saturating_sub(1)])?;
        let found = scene.simulation(rule).loads(loads).changed(change, &began, before)?;
        let expected = &self.states[k + 1];
        let slack = Elementary::sqrt(T::Real::EPSILON);
        let near = |a: T, b: T| (a - b).real().abs() <= slack * (T::Real::one() + b.real().abs());
        let alike = listed(&found.next).iter().zip(listed(expected)).all(|(a, b)| near(a.re, b));
        let what = "the gradient of a run past a change of mode that hangs on rounding";
        let refused = Error::new(Fault::Unsupported { what }).at_time(expected.time.as_f64());
        if alike && modes(&found.next) == modes(expected) { Ok(found) } else { Err(refused) }
    }
}

/// Numbers of positions, and then of rates, as a list.
fn listed<T: Scalar, Q: Position<T>, D: Closures>(motion: &Motion<T, Q, D>) -> Vec<T> {
    let mut list = Vec::new();
    motion.position.visit(&mut |x| list.push(x));
    motion.rate.visit(&mut |x| list.push(x));
    list
}

/// What joints with modes do, root to tip.
fn modes<T: Scalar, Q: Position<T>, D: Closures>(motion: &Motion<T, Q, D>) -> Vec<Mode> {
    let (mut list, mut motion) = (Vec::new(), motion.clone());
    motion.position.each_mode(&mut motion.rate, &motion.acceleration, &mut |mode, _, _| list.push(*mode));
    list
}

/// A motion of a scene over jets that has no derivatives.
///
/// # Errors
/// [`Fault::Shape`] for that of another scene.
fn of_plain<T, X, Y, Z, W, Q, D, const K: usize>(
    scene: &System<X, Y, Z, W>,
    motion: &Motion<T, Q, D>,
) -> Result<MotionOf<X, Y, Z, W>, Error>
where
    T: Scalar,
    X: Space<Scalar = Jet<T, K>>,
    Y: Root<X>,
    Z: Element<X>,
    W: Tip<X>,
    Q: Position<T>,
    D: Closures,
{
    let mut over = scene.motion();
    let (numbers, of_joints) = (listed(motion), modes(motion));
    if listed(&over).len() != numbers.len() || modes(&over).len() != of_joints.len() {
        return Err(Error::new(Fault::Shape));
    }
    let (mut numbers, mut of_joints) = (numbers.into_iter(), of_joints.into_iter());
    let mut next = |x: Jet<T, K>| numbers.next().map_or(x, Jet::of);
    over.position.replace(&mut next);
    over.rate.replace(&mut next);
    over.position.each_mode(&mut over.rate, &over.acceleration, &mut |mode, _, _| {
        *mode = of_joints.next().unwrap_or_default();
    });
    over.set_time(motion.time);
    Ok(over)
}

/// Numbers of efforts.
fn numbers_of<T, E: OfNumbers<T>>(efforts: &[E]) -> Vec<T> {
    let mut list = Vec::new();
    efforts.iter().for_each(|effort| effort.add_to(&mut list));
    list
}

/// Efforts over jets, of which number `first` is seed 0.
fn seeds<T: Scalar, E: OfNumbers<T>, N: OfNumbers<Jet<T, K>>, const K: usize>(efforts: &[E], first: usize) -> Vec<N> {
    seeded(&numbers_of(efforts), first).chunks_exact(N::COUNT).map(N::of).collect()
}
