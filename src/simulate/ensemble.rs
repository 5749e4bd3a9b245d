//! Ensembles: one closure for many parameters, on all threads.

use core::sync::atomic::{AtomicUsize, Ordering};
use rayon::prelude::*;
use std::sync::{Mutex, TryLockError};
use std::vec::Vec;

/// Many runs to be made, one for each of a list of parameters: by [`ensemble`].
#[derive(Clone, Copy, Debug)]
#[must_use = "nothing runs before it is told what"]
pub struct Ensemble<'p, P, F = fn(usize)> {
    parameters: &'p [P],
    progress: F,
}

/// Runs for many parameters: what [`run`](Ensemble::run) is given for one of them happens for all, on all threads of rayon's pool.
///
/// The closure makes a scene, runs it and says what is wanted of it; scenes, loads, rules and observers are those of any run. What it
/// returns for a parameter stands in the result at that parameter's place, errors too: no run stops another. The result
/// is that of a serial loop, bit by bit and however many threads there are, if the closure reads nothing but its parameter.
///
/// ```
/// use catena::planar::*;
/// use catena::simulate::ensemble;
///
/// let lengths = [1.0, -1.0, 2.0]; // of rods (m); the second is none
/// let mut seen = 0;
/// let angles = ensemble(&lengths).progress(|done| seen = done).run(|&length| {
///     let pendulum = System::new(Pinned::origin(), Rod::uniform(length, 1.0), Free)?.with_gravity(9.81);
///     let end = pendulum.simulate(pendulum.at_rest(&[-1.0])?, Rk4::step(0.01), 1.0, |_| ())?.motion;
///     let [angle] = end.coordinates_of(pendulum.joint(0)?)?;
///     Ok::<f64, catena::Error>(angle) // (rad)
/// });
/// assert!(angles[0].is_ok() && angles[1].is_err() && angles[2].is_ok());
/// assert_eq!(seen, 3);
/// ```
///
/// Where fewer threads than all are wanted, rayon's own means apply: `RAYON_NUM_THREADS`, or `ThreadPool::install` around the call.
///
/// # Panics
/// Where a closure does: then rayon's rules hold. Runs under way are finished, of the others some may not be begun, and the panic goes
/// on in the thread that called, with nothing returned.
pub fn ensemble<P: Sync>(parameters: &[P]) -> Ensemble<'_, P> {
    Ensemble { parameters, progress: |_| () }
}

impl<'p, P: Sync, F: FnMut(usize) + Send> Ensemble<'p, P, F> {
    /// Tells how many runs are done: 1, 2 and so on to their number, each once and in order, by whichever thread has the time, at the
    /// latest before the result is returned. A call that takes long keeps one thread from its runs, no other.
    pub fn progress<G: FnMut(usize) + Send>(self, progress: G) -> Ensemble<'p, P, G> {
        Ensemble { parameters: self.parameters, progress }
    }

    /// What the closure returns for each parameter, in their order.
    pub fn run<T: Send>(self, run: impl Fn(&P) -> T + Sync) -> Vec<T> {
        let done = Done::new(self.progress);
        // Runs differ in what they cost, and each costs far more than its share of a list: none waits for its neighbour.
        let each = self.parameters.par_iter().with_max_len(1);
        let results = each
            .map(|parameter| {
                let result = run(parameter);
                done.add(1);
                result
            })
            .collect();
        done.tell();
        results
    }

    /// What the closure returns for each parameter, in their order, where it runs `N` of them at once: one scene of numbers that are
    /// lanes (feature `simd`), threads outside and lanes inside. Where parameters are left over, the first of them fills the rest.
    ///
    /// Lanes share their steps. At fixed steps each is its own run, with the bits of plain numbers (in loops to rounding: the lane that
    /// closes last sets the passes of all; a start that is [assembled](crate::system::System::assembled) from afar may be another one than alone); under error control the lane that errs most sets the steps of all, so a result depends, within
    /// the tolerance, on its neighbours in the batch, and on nothing else: it is the same in each run. Event functions are refused, for each lane would have its own events: [`run`](Self::run) is for these.
    ///
    /// An error is that of one lane, nobody knows which. Then the runs of the batch are made anew, each alone in all lanes, so that
    /// errors stand where they belong and stop no other run. Parameters are checked in each lane, but for inertia tensors in space, of which
    /// each entry is checked in the lane where it is largest (and all for being finite).
    ///
    /// ```
    /// # #[cfg(feature = "simd")]
    /// # fn main() {
    /// use catena::planar::*;
    /// use catena::scalar::{Scalar, WideF64x4 as Lanes};
    /// use catena::simulate::ensemble;
    ///
    /// let starts = [-1.0, -0.5, 0.0, 0.5, 1.0]; // (rad)
    /// let ends = ensemble(&starts).run_in_lanes(|starts: [&f64; 4]| {
    ///     let start = Lanes::from(starts.map(|start| *start));
    ///     let rod = Rod::uniform(Lanes::literal(1.0), Lanes::literal(1.0));
    ///     let pendulum = System::new(Pinned::origin(), rod, Free)?.with_gravity(Lanes::literal(9.81));
    ///     let end = pendulum.simulate(pendulum.at_rest(&[start])?, Rk4::step(0.01), 1.0, |_| ())?.motion;
    ///     let [angle] = end.coordinates_of(pendulum.joint(0)?)?;
    ///     Ok::<[f64; 4], catena::Error>(angle.into_arr()) // (rad)
    /// });
    /// assert_eq!(ends.len(), 5);
    /// # }
    /// # #[cfg(not(feature = "simd"))]
    /// # fn main() {}
    /// ```
    pub fn run_in_lanes<const N: usize, T: Send, E: Send>(
        self,
        run: impl Fn([&P; N]) -> Result<[T; N], E> + Sync,
    ) -> Vec<Result<T, E>> {
        const { assert!(N > 0, "a batch has at least one lane") }
        let done = Done::new(self.progress);
        let batches = self.parameters.par_chunks(N).with_max_len(1);
        let results = batches
            .flat_map_iter(|batch| {
                let results = in_lanes(batch, &run);
                done.add(batch.len());
                results
            })
            .collect();
        done.tell();
        results
    }
}

/// What comes of a batch of at most `N` parameters.
fn in_lanes<P, const N: usize, T, E>(batch: &[P], run: &impl Fn([&P; N]) -> Result<[T; N], E>) -> Vec<Result<T, E>> {
    let Some(first) = batch.first() else { return Vec::new() };
    match run(core::array::from_fn(|lane| batch.get(lane).unwrap_or(first))) {
        Ok(results) => results.into_iter().take(batch.len()).map(Ok).collect(),
        Err(error) if batch.len() == 1 => Vec::from([Err(error)]),
        Err(_) => batch.iter().flat_map(|parameter| in_lanes(core::slice::from_ref(parameter), run)).collect(),
    }
}

/// How many runs are done, and who is told.
struct Done<F> {
    count: AtomicUsize,
    /// Whom to tell, and the number told last. Never waited for: who holds it tells for all, and may itself do something of rayon's
    /// that takes up another run in the same thread.
    told: Mutex<(F, usize)>,
}

impl<F: FnMut(usize)> Done<F> {
    fn new(progress: F) -> Self {
        Self { count: AtomicUsize::new(0), told: Mutex::new((progress, 0)) }
    }

    fn add(&self, runs: usize) {
        self.count.fetch_add(runs, Ordering::Relaxed);
        self.tell();
    }

    fn tell(&self) {
        let mut guard = match self.told.try_lock() {
            Ok(guard) => guard,
            Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
            Err(TryLockError::WouldBlock) => return,
        };
        let (progress, told) = &mut *guard;
        while *told < self.count.load(Ordering::Relaxed) {
            *told += 1;
            progress(*told);
        }
    }
}
