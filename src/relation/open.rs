//! A station that nothing closes: its elimination is none.

use super::Absent;
use super::closure::{Closures, Cuts, Open};
use super::looped::{LoopGain, Looped, Own};
use crate::scalar::Scalar;

impl Own for Open {
    type Measure<T: Scalar> = Absent;
    #[inline(always)]
    fn measure<T: Scalar>(_: impl FnOnce()) -> Absent {
        Absent
    }
    #[inline(always)]
    fn plus_pairs<T: Scalar>((): &(), (): &()) {}
    #[cfg_attr(optimised, inline(always))]
    fn eliminate<V: Copy, T: Scalar, C: Closures>(
        cuts: Cuts<V, T, Looped<C, Self>>,
        measure: Absent,
        _: impl Fn(V, T, V) -> V,
        _: impl FnMut(V, T, T),
    ) -> (Cuts<V, T, C>, LoopGain<V, T, C, Self>) {
        let Cuts { columns: (columns, ()), compliance: (compliance, (), ()), gap: (gap, ()) } = cuts;
        let gain = LoopGain { columns: (), inverse: (), riding: (), factors: (), gap: (), compliance: (), measure };
        (Cuts { columns, compliance, gap }, gain)
    }
    #[inline(always)]
    fn reduced<V: Copy, T: Scalar, C: Closures>(_: &LoopGain<V, T, C, Self>, (): &()) {}
    #[cfg_attr(optimised, inline(always))]
    fn forces<V: Copy, T: Scalar, C: Closures>(
        _: &LoopGain<V, T, C, Self>,
        _: impl Fn(V) -> T,
        _: &C::Each<T>,
        (): &(),
    ) {
    }
}
