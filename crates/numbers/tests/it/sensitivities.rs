//! What tests of derivatives through kept gains share: the same run over dual numbers, compared part by part.

#![allow(unused_macros)]

use catena::internals::relation::Closures;
use catena::scalar::Jet;
use catena::system::{Position, Rate};
use catena::{Motion, Scalar};
use nalgebra::{Const, U1};
use num_dual::DualSVec64;

/// A number with derivatives, taken apart.
pub trait Parts: Scalar<Real = f64> {
    /// With derivative 1 by seed `k`, if there is one.
    fn with_seed(value: f64, k: usize) -> Self;
    /// The value and its derivatives.
    fn parts(self) -> Vec<f64>;
}

impl<const K: usize> Parts for Jet<f64, K> {
    fn with_seed(value: f64, k: usize) -> Self {
        Self::seed(value, k)
    }
    fn parts(self) -> Vec<f64> {
        [self.re].into_iter().chain(self.eps).collect()
    }
}

impl<const K: usize> Parts for DualSVec64<K> {
    fn with_seed(value: f64, k: usize) -> Self {
        let constant = Self::from_re(value);
        if k < K { constant.derivative(k) } else { constant }
    }
    fn parts(self) -> Vec<f64> {
        [self.re].into_iter().chain(self.eps.unwrap_generic(Const::<K>, U1).iter().copied()).collect()
    }
}

/// All parts of all numbers of a motion, coordinate by coordinate.
pub fn parts<T: Parts, P: Position<T>, C: Closures>(motion: &Motion<T, P, C>) -> Vec<Vec<f64>> {
    let mut found = vec![];
    motion.position().visit(&mut |x| found.push(x.parts()));
    motion.rate().visit(&mut |x| found.push(x.parts()));
    motion.acceleration().visit(&mut |x| found.push(x.parts()));
    found
}

/// Each part agrees to a share of the largest one of its kind.
#[track_caller]
pub fn alike(name: &str, found: &[Vec<f64>], expected: &[Vec<f64>], seeds: usize, tolerance: f64) {
    assert_eq!((found.len(), found[0].len()), (expected.len(), expected[0].len()));
    let mut worst = 0.0_f64;
    for k in 0..found[0].len().min(seeds + 1) {
        let size = expected.iter().fold(0.0_f64, |size, x| size.max(x[k].abs()));
        assert!(size > 0.0, "{name}: seed {k} does nothing");
        for (i, (found, expected)) in found.iter().zip(expected).enumerate() {
            let error = (found[k] - expected[k]).abs() / size;
            worst = worst.max(error);
            assert!(error <= tolerance, "{name}, number {i}, part {k}: {} not {}", found[k], expected[k]);
        }
    }
    println!("{name}: largest deviation {worst:.1e}");
}

/// Runs a scene over jets through gains and over dual numbers by the rule itself, four seeds at a time; both end alike.
macro_rules! as_dual_numbers {
    ($name:expr, $seeds:literal seeds, $rule:expr, $end:expr, |$x:ident| $scene:block) => {
        for first in (0..$seeds).step_by(4) {
            macro_rules! run {
                ($N:ty, $way:expr) => {{
                    #[allow(unused)]
                    type N = $N;
                    #[allow(unused)]
                    let $x = |value: f64, k: usize| N::with_seed(value, usize::wrapping_sub(k, first));
                    let (system, start, loads) = $scene;
                    parts(&system.simulation($way).loads(&loads).run(start, $end, |_| ())?.motion)
                }};
            }
            let jets = run!(Jet<f64, 4>, $rule.through_gains());
            let duals = run!(DualSVec64<4>, $rule);
            alike($name, &jets, &duals, $seeds - first, ROUNDING);
        }
    };
}
pub(crate) use as_dual_numbers;

/// No seed.
pub const FIXED: usize = usize::MAX;
/// Some thousand roundings.
pub const ROUNDING: f64 = 1e-12;
