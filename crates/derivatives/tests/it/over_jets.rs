//! Gradients of runs backward against the same steps over jets, which go forward by the rule itself, and against central differences of these steps.
//!
//! Bounds are shares of the largest of all derivatives: jets differ by rounding alone, some thousand roundings; differences of order four by steps of 2e-4
//! of a number err by 1e-6.

use catena::scalar::Jet;

/// So many derivatives at a time.
pub const WIDTH: usize = 4;
pub type Many = Jet<f64, WIDTH>;

/// What a cost weighs coordinates and rates by, at the end.
pub fn weights(count: usize) -> [Vec<f64>; 2] {
    [0.3, 1.1].map(|phase| (0..count).map(|k| (phase + 1.7 * k as f64).sin()).collect())
}

/// By all numbers of which a scene, a start and loads are made: `$made` makes these, and the parts of the loads that numbers make, and `$more` is the
/// gradient by such parts.
macro_rules! as_jets {
    ($rule:expr, $h:expr, $steps:expr, $numbers:expr, $made:ident, |$gradient:ident, $parts:ident| $more:expr) => {{
        use $crate::over_jets::{Many, WIDTH, weights};
        let numbers: &[f64] = &$numbers;
        let (scene, start, loads, _) = $made!(numbers, f64);
        let [mut of_q, of_v] = weights(start.rates().len());
        if start.coordinates().len() != of_q.len() {
            of_q.fill(0.0); // coordinates of balls are others than their derivatives are by
        }
        // The weighed sum of a run's end, by steps.
        macro_rules! cost {
            ($list:expr, $T:ty) => {{
                let (scene, start, loads, _) = $made!($list, $T);
                let (mut now, mut next, mut stepper) = (start.clone(), start, scene.stepper($rule));
                for _ in 0..$steps {
                    stepper.step(&now, &loads, $h, &mut next)?;
                    core::mem::swap(&mut now, &mut next);
                }
                let ends = now.coordinates().into_iter().zip(&of_q).chain(now.rates().into_iter().zip(&of_v));
                ends.fold(<$T as Scalar>::literal(0.0), |sum, (x, weight)| sum + x.scale(*weight))
            }};
        }
        let (mut backward, mut states) = (scene.backward($rule).under(loads), vec![start.clone(); $steps + 1]);
        backward.run(&start, $h, $steps, &[], &mut states)?;
        let add = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_, f64>| {
            if step == $steps { by.add(&of_q, &of_v) } else { Ok(()) }
        };
        let $gradient = backward.gradient(&[], &states, &mut [], add)?;
        let mut found = vec![];
        let mut expected = vec![];
        for first in (0..numbers.len()).step_by(WIDTH) {
            let seeded = (0..).zip(numbers).map(|(k, x)| Many::seed(*x, usize::wrapping_sub(k, first)));
            let seeded: Vec<Many> = seeded.collect();
            let (over, start, _, $parts) = $made!(&seeded, Many);
            let parts = [$gradient.along(&over)?, $gradient.along_start(&start)?, $more];
            let count = WIDTH.min(numbers.len() - first);
            found.extend((0..count).map(|k| parts.iter().map(|part: &[f64; WIDTH]| part[k]).sum::<f64>()));
            expected.extend(cost!(&seeded, Many).eps.into_iter().take(count));
        }
        let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        println!("{}, {}: {found:?} {expected:?}", stringify!($made), stringify!($rule));
        assert!(expected.iter().all(|x| *x != 0.0), "{expected:?}");
        for (k, (found, expected)) in found.iter().zip(&expected).enumerate() {
            assert!((found - expected).abs() < 1e-12 * size, "{k}: {found} {expected}");
            let changed = |by: f64| -> Result<f64, Error> {
                let mut list = numbers.to_vec();
                list[k] += by;
                Ok(cost!(&list, f64))
            };
            let h = 2e-4 * numbers[k].abs().max(0.1);
            let difference = catena_oracle::derivative(h, |by| changed(by).expect("a run of other numbers"));
            assert!((found - difference).abs() < 1e-6 * size, "{k}: {found} {difference}");
        }
    }};
}
