//! Digits that the paper's solvers keep: one step of the chain of its section 5.5, bent and moving at the start, against the same step in
//! double-double arithmetic.
//!
//! `cargo bench --bench paper_digits` prints errors of the increments Δθ of the step, as shares of the largest: by the plain product, by the
//! Riccati transform of the same matrices in absolute coordinates, and by the transform in increments. Increments are read from rates,
//! θ̇ = χ₃Δθ + .., for differences of angles near 1 rad round to 1e-16 by themselves.
//!
//! Read like this the errors are those of another implementation to an order of magnitude (n = 2, 5, 10 at 1 ms, by the product: 9e-10, 4e-4,
//! 0.7 here, 5.5e-9, 2.4e-3, 0.07 there). What is left is of the bend and the rates at the start, which the paper does not say: they set by
//! how much entries of U grow, here 4 to 25 times more than there.

#[path = "parts/transformed.rs"]
mod transformed;
#[path = "parts/twice.rs"]
mod twice;

use catena::loading::Unloaded;
use catena::paper::*;
use catena::planar::{ElasticHinge, Free, Pinned, Rod, System};
use catena::{Real, Scalar, TransferMatrix};
use transformed::transformed;
use twice::Twice;

/// The increments of all angles in a step, by a solver and by [`transformed`] of its matrices, and the largest entry of the overall
/// matrix (0 without a product).
macro_rules! step {
    ($T:ty, $n:expr, $dt:expr, $solver:expr) => {{
        let n: usize = $n;
        let number = |x: f64| <$T as Scalar>::literal(x);
        let real = |x: f64| <<$T as Scalar>::Real as Real>::of(x);
        let size = number(1.0) / number(n as f64);
        let rod = Rod::uniform(size, size);
        let links = vec![(ElasticHinge::rotary(number(20.0)), rod); n - 1];
        let scene = System::new(Pinned::origin(), (rod, links), Free)?.with_gravity(number(9.81));
        // Numbers of f32, so that every number starts from the same motion.
        let single = |x: f64| number(f64::from(x as f32));
        let angles: Vec<$T> = (0..n).map(|k| single(-1.0 + 0.3 * k as f64 / n as f64)).collect();
        let mut rates = vec![single(1.0)];
        rates.extend((1..n).map(|k| single(0.5 / n as f64 * (k as f64).cos())));
        let start = scene.with_rates(scene.at_rest(&angles)?, &rates)?;
        let rule = Newmark::new(0.25, 0.5);
        let mut run = Scheme::new(rule).solved_by($solver).start(&scene, &start, &Unloaded, real($dt))?;
        let before: Vec<[$T; 3]> = run.turns().collect();
        let outcome = run.step();
        // (2) the other way round.
        let increment = |([value, rate, acceleration], [_, now, _]): ([$T; 3], [$T; 3])| {
            let linear = Rule::<$T>::linearize(&rule, &rule.start(value, rate, acceleration, real($dt)), real($dt));
            wide((now - linear.rate) / number(2.0) * number($dt))
        };
        let lost = vec![Twice(f64::NAN, 0.0); n];
        let steps = outcome.map_or(lost.clone(), |()| before.into_iter().zip(run.turns()).map(increment).collect());
        let matrices = run.matrices();
        let (mut whole, mut absolute) = (TransferMatrix::<$T, 7>::identity(), lost);
        for matrix in matrices.iter().skip(1) {
            whole = whole.then(matrix);
        }
        if matrices.len() > 1 {
            let found = transformed(&matrices[1..]);
            absolute = found.iter().step_by(2).zip(&angles).map(|(after, before)| wide(*after - *before)).collect();
        }
        // Where it overflows entries are infinite, or NaN.
        let sizes = whole.as_matrix().iter().map(|x| x.real().as_f64().abs());
        let largest = sizes.fold(0.0_f64, |largest, x| if x.is_nan() { f64::INFINITY } else { largest.max(x) });
        Ok::<_, catena::Error>((steps, absolute, largest))
    }};
}

fn wide<T: Scalar>(x: T) -> Twice {
    Twice(x.real().as_f64(), 0.0)
}

fn main() -> Result<(), catena::Error> {
    println!(
        "Errors of Δθ in one step of the printed scheme, chain of section 5.5, as shares of the largest Δθ (rad); lost: more than one.\n"
    );
    println!("                              f64                              f32");
    println!(
        "     step        n   max |U|  product  absolute increments     product  absolute increments   largest Δθ"
    );
    for dt in [1e-2, 1e-3, 1e-4] {
        for n in [2, 5, 10, 20, 100, 1000, 100_000] {
            let (exact, ..) = step!(Twice, n, dt, Solver::Riccati)?;
            let size = exact.iter().fold(0.0_f64, |size, x| size.max(x.0.abs()));
            let error = |found: &[Twice]| {
                let worst = found.iter().zip(&exact).fold(0.0_f64, |worst, (a, b)| worst.max((*a - *b).0.abs())) / size;
                let finite = found.iter().all(|x| x.0.is_finite());
                if !finite {
                    "NaN".to_owned()
                } else if worst > 1.0 {
                    "lost".to_owned()
                } else {
                    format!("{worst:.0e}")
                }
            };
            let (product, absolute, largest) = step!(f64, n, dt, Solver::Product)?;
            let (increments, ..) = step!(f64, n, dt, Solver::Riccati)?;
            let (short_product, short_absolute, _) = step!(f32, n, dt, Solver::Product)?;
            let (short_increments, ..) = step!(f32, n, dt, Solver::Riccati)?;
            let [a, b, c] = [&product, &absolute, &increments].map(|found| error(found));
            let [d, e, f] = [&short_product, &short_absolute, &short_increments].map(|found| error(found));
            println!("  {dt:7.0e} {n:8} {largest:9.0e} {a:>8} {b:>9} {c:>10}    {d:>8} {e:>9} {f:>10} {size:12.0e}");
        }
    }
    Ok(())
}
