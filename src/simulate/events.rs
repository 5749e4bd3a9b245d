//! What a run looks for: zeros of an event function, and of functions at whose zeros loads have kinks.

use crate::scalar::{Real, Scalar};

/// Functions of the motion whose zeros are located.
pub trait EventFunction<N: ?Sized, T> {
    /// Whether there is one that is shown.
    const ON: bool;
    /// Value of that function; none where there is none.
    fn value(&mut self, now: &N) -> Option<T>;

    /// Number of functions at whose zeros steps end.
    const KINKS: usize;
    /// Finds the values of these functions at one of three motions.
    fn look(&mut self, now: &N, at: usize);
    /// The value of one function that was found there.
    fn kink(&self, number: usize, at: usize) -> f64;
}

/// An event function and one of kinks, or none of them.
pub struct Watched<E, K> {
    pub(super) event: E,
    pub(super) kinks: K,
}

/// No function.
pub struct Unwatched;

/// A function that is an event's.
pub struct Event<F>(pub(super) F);

/// A function that gives as many values as there are kinks, and those of three motions.
pub struct Kinks<F, const COUNT: usize> {
    functions: F,
    values: [[f64; COUNT]; 3],
}

impl<F, const COUNT: usize> Kinks<F, COUNT> {
    pub(super) fn of(functions: F) -> Self {
        Self { functions, values: [[f64::NAN; COUNT]; 3] }
    }
}

/// [`EventFunction::value`] of one function or none.
pub trait MayCross<N: ?Sized, T> {
    /// Whether there is one.
    const ON: bool = false;
    /// Value of the function, if there is one.
    fn value(&mut self, now: &N) -> Option<T> {
        let _ = now;
        None
    }
}

/// [`EventFunction::kink`] of one function or none.
pub trait MayBend<N: ?Sized, T> {
    /// Number of its values.
    const COUNT: usize = 0;
    /// Finds all values.
    fn look(&mut self, now: &N, at: usize) {
        let _ = (now, at);
    }
    /// A value that was found.
    fn value(&self, number: usize, at: usize) -> f64 {
        let _ = (number, at);
        f64::NAN
    }
}

impl<N: ?Sized, T> MayCross<N, T> for Unwatched {}
impl<N: ?Sized, T> MayBend<N, T> for Unwatched {}

impl<N: ?Sized, T, F: FnMut(&N) -> T> MayCross<N, T> for Event<F> {
    const ON: bool = true;
    fn value(&mut self, now: &N) -> Option<T> {
        Some(self.0(now))
    }
}

impl<N: ?Sized, T: Scalar, F: FnMut(&N) -> [T; COUNT], const COUNT: usize> MayBend<N, T> for Kinks<F, COUNT> {
    const COUNT: usize = COUNT;
    fn look(&mut self, now: &N, at: usize) {
        self.values[at] = (self.functions)(now).map(|value| value.real().as_f64());
    }
    fn value(&self, number: usize, at: usize) -> f64 {
        self.values[at][number]
    }
}

impl<N: ?Sized, T, E: MayCross<N, T>, K: MayBend<N, T>> EventFunction<N, T> for Watched<E, K> {
    const ON: bool = E::ON;
    fn value(&mut self, now: &N) -> Option<T> {
        self.event.value(now)
    }

    const KINKS: usize = K::COUNT;
    fn look(&mut self, now: &N, at: usize) {
        self.kinks.look(now, at);
    }
    fn kink(&self, number: usize, at: usize) -> f64 {
        self.kinks.value(number, at)
    }
}
