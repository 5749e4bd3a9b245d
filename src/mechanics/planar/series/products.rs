//! Taylor series in the plane: products of two series, four at a time.

use crate::scalar::Scalar;

/// The first coefficients of four pairs of series, one pair in each lane, a_j and b_j. Of order k
///
/// ```text
/// c_k = Σ a_j b_{k−j}      j from 0 to k
/// ```
///
/// of which the two products with coefficients that have just been found are formed by whoever finds them, while they are at hand: all
/// others need not wait for these. No four numbers lie across two lines of a cache.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Products<T, const N: usize> {
    /// a₀ and b₀.
    first: [[T; 4]; 2],
    /// a₀ b_k + a_k b₀ of the present order, and all other products of c_k: these are stored for a compiler to keep four in one register.
    newest: [T; 4],
    others: [T; 4],
    /// a_j from j = 1 on.
    turned: [[T; 4]; N],
    /// b_j from j = 1 on, behind as many zeros as a group of three products may miss.
    turning: [[T; 4]; N],
}

impl<T: Scalar, const N: usize> Products<T, N> {
    /// Of nothing.
    pub(super) fn new() -> Self {
        let none = [T::zero(); 4];
        Self { first: [none; 2], newest: none, others: none, turned: [none; N], turning: [none; N] }
    }

    /// Begins with a₀ and b₀.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn begin(&mut self, turned: [T; 4], turning: [T; 4]) {
        self.first = [turned, turning];
        self.newest = core::array::from_fn(|i| turned[i] * turning[i]);
    }

    /// a₀ and b₀.
    #[inline(always)]
    pub(super) fn start(&self) -> [[T; 4]; 2] {
        self.first
    }

    /// Goes on with those of a number, from 1 on.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn keep(&mut self, number: usize, turned: [T; 4], turning: [T; 4]) {
        let [first, last] = self.first;
        let newest = core::array::from_fn(|i| turned[i].mul_add(last[i], first[i] * turning[i]));
        self.keep_with(number, turned, turning, newest);
    }

    /// Goes on with those of a number, of which the newest products are known.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn keep_with(&mut self, number: usize, turned: [T; 4], turning: [T; 4], newest: [T; 4]) {
        self.newest = newest;
        if let (Some(place), Some(room)) = (self.turning.get_mut(number + 1), self.turned.get_mut(number - 1)) {
            (*room, *place) = (turned, turning);
        }
        // Beside these zeros: of a series before there may be anything here.
        if let Some(beyond) = self.turned.get_mut(number) {
            *beyond = [T::zero(); 4];
        }
    }

    /// c_k.
    #[cfg_attr(optimised, inline(always))]
    pub(super) fn of(&mut self, k: usize) -> [T; 4] {
        let zero = [T::zero(); 4];
        let (known, mut sums) = (&self.turning[..N.min(k + 1)], [zero; 3]);
        for (a, b) in self.turned.as_chunks::<3>().0.iter().zip(known.as_rchunks::<3>().1.iter().rev()) {
            for (j, sum) in sums.iter_mut().enumerate() {
                *sum = core::array::from_fn(|i| a[j][i].mul_add(b[2 - j][i], sum[i]));
            }
        }
        let [a, b, c] = sums;
        self.others = core::array::from_fn(|i| a[i] + b[i] + c[i]);
        core::array::from_fn(|i| self.others[i] + self.newest[i])
    }
}
