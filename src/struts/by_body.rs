//! Which struts are on which bodies.

use super::{End, Strut};

/// How many lists of struts there are.
const LISTS: usize = 64;
/// Of so few struts a body looks at all, or at none: they stay in registers.
const FEW: usize = 4;

/// Struts by the bodies that they are on: a body looks at no others but those of bodies whose numbers differ from its own by a multiple of
/// [`LISTS`].
#[derive(Clone, Copy, Debug)]
pub(super) struct ByBody<const N: usize> {
    /// Bit k is set where a strut ends at such bodies.
    bodies: u64,
    /// The first strut on them, with the end that is there: the number of the strut twice, and one more of the second end.
    first: [u16; LISTS],
    /// After each, the next.
    next: [[u16; 2]; N],
}

impl<const N: usize> ByBody<N> {
    /// Beyond all struts.
    const NONE: u16 = u16::MAX;

    #[inline(always)]
    pub(super) fn of<T, const D: usize, W>(struts: &[Strut<T, D, W>; N]) -> Self {
        let mut lists = Self { bodies: 0, first: [Self::NONE; LISTS], next: [[Self::NONE; 2]; N] };
        for k in (0..N).rev() {
            let [from, to] = struts[k].ends.each_ref().map(|end| match end {
                End::Body(body, _) => Some(body % LISTS),
                End::Ground(_) => None,
            });
            // A strut stands in a list once.
            for (e, list) in [(1, to.filter(|_| from != to)), (0, from)] {
                let Some(list) = list else { continue };
                if const { N <= FEW } {
                    lists.bodies |= 1 << list;
                } else {
                    lists.next[k][e] = core::mem::replace(&mut lists.first[list], (2 * k + e) as u16);
                }
            }
        }
        lists
    }

    /// Numbers of struts that may be on a body.
    #[inline(always)]
    pub(super) fn on(&self, body: usize) -> impl Iterator<Item = usize> {
        let mut all = 0..if self.bodies >> (body % LISTS) & 1 != 0 { N } else { 0 };
        let mut next = self.first[body % LISTS];
        core::iter::from_fn(move || {
            if const { N <= FEW } {
                return all.next();
            }
            let k = usize::from(next / 2);
            next = self.next.get(k)?[usize::from(next % 2)];
            Some(k)
        })
    }
}
