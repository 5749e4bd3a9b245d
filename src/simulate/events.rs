//! What a run looks for: zeros of an event function, and of functions at whose zeros loads have kinks.

/// Functions of the motion whose zeros are located.
pub trait EventFunction<N: ?Sized, T> {
    /// Whether there is one that is shown.
    const ON: bool;
    /// Value of that function; none where there is none.
    fn value(&mut self, now: &N) -> Option<T>;

    /// Number of functions at whose zeros steps end.
    const KINKS: usize;
    /// Tells the values of these, in their order.
    fn kinks(&mut self, now: &N, tell: &mut dyn FnMut(T));
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

/// A function that gives as many values as there are kinks.
pub struct Kinks<F, const COUNT: usize>(pub(super) F);

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

/// [`EventFunction::kinks`] of one function or none.
pub trait MayBend<N: ?Sized, T> {
    /// Number of its values.
    const COUNT: usize = 0;
    /// Tells them.
    fn each(&mut self, now: &N, tell: &mut dyn FnMut(T)) {
        let _ = (now, tell);
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

impl<N: ?Sized, T, F: FnMut(&N) -> [T; COUNT], const COUNT: usize> MayBend<N, T> for Kinks<F, COUNT> {
    const COUNT: usize = COUNT;
    fn each(&mut self, now: &N, tell: &mut dyn FnMut(T)) {
        self.0(now).into_iter().for_each(tell);
    }
}

impl<N: ?Sized, T, E: MayCross<N, T>, K: MayBend<N, T>> EventFunction<N, T> for Watched<E, K> {
    const ON: bool = E::ON;
    fn value(&mut self, now: &N) -> Option<T> {
        self.event.value(now)
    }

    const KINKS: usize = K::COUNT;
    fn kinks(&mut self, now: &N, tell: &mut dyn FnMut(T)) {
        self.kinks.each(now, tell);
    }
}
