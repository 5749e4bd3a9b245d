//! Compliance that sets in over a depth.

use crate::scalar::{Real, Scalar};

/// How far something is pressed in, as a share of a depth (0 to 1) and by how much beyond that: the stiffness rises over the depth as
/// 3 s² − 2 s³ and is whole beyond it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Compression<T> {
    share: T,
    deeper: T,
    depth: T,
}

impl<T: Scalar> Compression<T> {
    /// Of what is pressed in by some way, which is negative where nothing touches.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn of(way: T, depth: T) -> Self {
        let over = above(way);
        let deeper = above(over - depth);
        Self { share: (over - deeper) / depth, deeper, depth }
    }

    /// Force of a stiffness of one.
    #[cfg_attr(optimised, inline(always))]
    pub(crate) fn force(self) -> T {
        let Self { share, deeper, depth } = self;
        let cubed = share * share * share;
        (cubed * depth).mul_add(share.mul_add(T::literal(-0.5), T::one()), deeper)
    }

    /// Share of the stiffness that has set in.
    #[inline(always)]
    pub(crate) fn stiffness(self) -> T {
        self.share * self.share * self.share.mul_add(T::literal(-2.0), T::literal(3.0))
    }

    /// Energy by a stiffness of one: over the depth w it is w² (s⁴/4 − s⁵/10), beyond it a parabola.
    pub(crate) fn energy(self) -> T {
        let Self { share, deeper, depth } = self;
        let fourth = share * share * share * share;
        let early = fourth * (T::literal(0.25) - share.scale(T::Real::of(0.1))) * depth * depth;
        early + deeper * (deeper + depth).scale(T::Real::of(0.5))
    }
}

/// What is above zero, or zero, without a branch.
#[inline(always)]
pub(crate) fn above<T: Scalar>(x: T) -> T {
    (x + x.abs()).scale(T::Real::of(0.5))
}
