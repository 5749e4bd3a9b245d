//! What a run as a function of numbers is put together from: seeds, efforts, states.

use super::Seeded;
use crate::element::{Element, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault, counted, ensure_finite};
use crate::loading::EffortOf;
use crate::mechanics::spatial::Effort;
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::relation::{Additive, Closures};
use crate::scalar::{Jet, Scalar};
use crate::sensitive::Varied;
use crate::stepper::{Stepper, advances};
use crate::system::{Dynamics, MotionOf, System};
use alloc::vec::Vec;

/// As the number that is the first seed: none is.
pub const NO_SEEDS: usize = usize::MAX / 2;

/// Numbers with seeds: input `first` is seed 0.
pub fn seeded<T: Scalar, const K: usize>(x: &[T], first: usize) -> Vec<Jet<T, K>> {
    x.iter().enumerate().map(|(k, x)| Jet::seed(*x, k.wrapping_sub(first))).collect()
}

/// An effort in a joint, from numbers.
pub trait OfNumbers<T>: Sized {
    /// How many.
    const COUNT: usize;
    /// Takes them.
    fn of(numbers: &[T]) -> Self;
    /// Gives them.
    fn add_to(&self, list: &mut Vec<T>);
}

impl<T: Scalar> OfNumbers<T> for T {
    const COUNT: usize = 1;
    fn of(numbers: &[T]) -> T {
        numbers[0]
    }
    fn add_to(&self, list: &mut Vec<T>) {
        list.push(*self);
    }
}

impl<T: Scalar> OfNumbers<T> for Effort<T> {
    const COUNT: usize = 3;
    fn of(numbers: &[T]) -> Self {
        Self([numbers[0], numbers[1], numbers[2]])
    }
    fn add_to(&self, list: &mut Vec<T>) {
        list.extend(self.0);
    }
}

/// Inputs of a scene, and torques, which are the last ones.
pub fn split<T>(numbers: &[T], torques: usize) -> Result<(&[T], &[T]), Error> {
    let given = numbers.len();
    let parts = given.checked_sub(torques).and_then(|inputs| numbers.split_at_checked(inputs));
    parts.ok_or(Error::new(Fault::Count { list: "inputs", expected: torques, given }))
}

/// Refuses steps that do not go on.
pub fn goes_on(step: f64) -> Result<(), Error> {
    advances(step)
}

/// The time after so many steps of a size, without the rounding of a running sum.
pub fn time_after(start: f64, size: f64, steps: usize) -> f64 {
    start + size * steps as f64
}

/// A motion as outputs may read it: accelerations, and the forces that hold its tip, are NaN, for costates know nothing of them.
pub fn shown<T: Scalar, P: Position<T>, C: Closures>(mut motion: Motion<T, P, C>) -> Motion<T, P, C> {
    let unknown = T::literal(f64::NAN);
    motion.acceleration.replace(&mut |_| unknown);
    motion.multipliers = C::each(|_| unknown);
    motion
}

/// Refuses outputs that are no numbers.
pub fn known<T: Scalar>(outputs: &[T]) -> Result<(), Error> {
    ensure_finite(outputs.iter().all(|y| y.is_finite()), "output of a run (of positions and rates)")
}

/// Refuses steps of a scene whose joints have modes that the method does not change.
///
/// # Errors
/// [`Fault::Unsupported`].
pub fn keeps_modes<D: Dynamics<L>, L, K: Stepper<D, L>>(_: &K) -> Result<(), Error> {
    let what = "`differentiable!` where joints have modes, but by `MoreauJean`: `Backward::course`";
    if const { D::Position::MODES && !K::SWITCHES } { Err(Error::new(Fault::Unsupported { what })) } else { Ok(()) }
}

/// Efforts in the joints of a scene over one step or all steps, or none, from a list of numbers.
pub fn efforts<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>>(
    scene: &System<S, R, C, P>,
    numbers: &[S::Scalar],
    steps: usize,
) -> Result<Vec<EffortOf<S>>, Error>
where
    EffortOf<S>: OfNumbers<S::Scalar>,
{
    let (count, given) = (EffortOf::<S>::COUNT, numbers.len());
    let all = count * scene.joints();
    if given > 0 && given != all {
        counted("torques of all steps (or of one, or none)", all.saturating_mul(steps), given)?;
    }
    Ok(numbers.chunks_exact(count).map(EffortOf::<S>::of).collect())
}

/// The efforts held over a step.
pub fn held<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>>(
    scene: &System<S, R, C, P>,
    efforts: &[EffortOf<S>],
    step: usize,
) -> Vec<EffortOf<S>>
where
{
    let joints = scene.joints();
    let from = if efforts.len() == joints { 0 } else { step * joints };
    efforts.get(from..from + joints).map_or_else(|| alloc::vec![EffortOf::<S>::null(); joints], <[_]>::to_vec)
}

/// A motion of plain numbers as one of a scene over jets, with seeds in its state from number `first` on.
pub fn state<T: Scalar, S, R, C, P>(
    scene: &System<S, R, C, P>,
    (time, coordinates, rates): (RealOf<S>, &[T], &[T]),
    first: usize,
) -> Result<MotionOf<S, R, C, P>, Error>
where
    S: Varied<Scalar = Seeded<T>> + Space<Scalar = Seeded<T>>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
{
    let lifted = |list: &[T]| list.iter().map(|x| Jet::of(*x)).collect::<Vec<_>>();
    let mut motion = scene.motion().at_time(time);
    motion.set_coordinates(&lifted(coordinates))?;
    motion.set_rates(&lifted(rates))?;
    Ok(shown(scene.with_seeds(motion, first)))
}
