//! Rules whose runs go backward.

use super::steps::ROWS;
use crate::element::{self, Springs};
use crate::error::Fault;
use crate::scalar::{Real, Scalar};
use crate::time::sdirk4::{GAMMA, STAGES, TABLE};
use crate::time::{Dop853, Dopri5, Explicit, GeneralizedAlpha, Rk4, Sdirk4};
use core::fmt::Debug;
use num_traits::Zero;

/// A rule through whose steps costates go backward: by rows of a tableau, each with an acceleration that is found by one sweep or several.
#[diagnostic::on_unimplemented(
    message = "no gradient of a run goes backward through the rule `{Self}`",
    label = "not a rule that goes backward",
    note = "`Rk4`, `Dopri5`, `Dop853`, `Sdirk4` and `GeneralizedAlpha` do",
    note = "it takes a method alone, `Rk4`: the size of steps is told to `run`, the tolerance to `run_adaptive`, the rule `Rk4::step(0.001)` to a simulation and to `course`",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait Staged: Copy + Debug {
    /// Accelerations found in a step: rows 1 to `STAGES`, of which the last is the step itself.
    const STAGES: usize;
    /// Whether rows depend on their own accelerations.
    const IMPLICIT: bool;
    /// Whether a step depends on what the step before it has left besides positions and rates.
    const REMEMBERS: bool = false;
    /// Whether geometries of sweeps are put back where something is held or closed.
    const RESTORES: bool = false;
    /// Values for rows, and for those of stages alone.
    type Rows<X>: AsRef<[X]> + AsMut<[X]>;
    type Stages<X>: AsRef<[X]> + AsMut<[X]>;
    /// How springs enter sweeps.
    type Springs<T: Scalar>: Springs<T>;

    /// Copies of a value, for rows, and for stages.
    fn rows<X: Clone>(value: &X) -> Self::Rows<X>;
    fn stages<X: Clone>(value: &X) -> Self::Stages<X>;
    /// c of a row.
    fn node(row: usize) -> f64;
    /// Weights of the accelerations before it in positions and rates of a row.
    fn weights(row: usize) -> (&'static [f64], &'static [f64]);
    /// How many accelerations dense output reads; none of a rule that makes shorter steps instead.
    const SLOPES: usize = 0;
    /// Weights of the rows in positions and rates at a share of a step.
    fn dense(share: f64) -> [[f64; ROWS]; 2] {
        let _ = share;
        [[0.0; ROWS]; 2]
    }
    /// Sweeps of a row.
    fn sweeps(&self, row: usize) -> usize;
    /// How springs enter sweeps of a row in a step (s).
    fn springs<T: Scalar>(&self, row: usize, step: T::Real) -> Self::Springs<T>;
    /// Weights of its own acceleration in positions and rates of a row, in a step (s), and their derivatives by its size.
    fn own<T: Scalar>(&self, step: T::Real) -> [[T::Real; 2]; 2] {
        let _ = step;
        [[T::Real::zero(); 2]; 2]
    }
    /// The family of a rule that remembers.
    fn family(&self) -> Option<&GeneralizedAlpha> {
        None
    }
    /// What is wrong with its parameters.
    fn fault(&self) -> Option<Fault> {
        None
    }
}

macro_rules! explicit {
    ($($Rule:ty: $STAGES:literal of $SLOPES:literal),*) => {$(
        impl Staged for $Rule {
            const STAGES: usize = $STAGES;
            const IMPLICIT: bool = false;
            type Rows<X> = <Self as Explicit>::Rows<X>;
            type Stages<X> = [X; $STAGES];
            type Springs<T: Scalar> = element::Explicit;

            fn rows<X: Clone>(value: &X) -> <Self as Explicit>::Rows<X> {
                <Self as Explicit>::rows(value)
            }
            fn stages<X: Clone>(value: &X) -> [X; $STAGES] {
                core::array::from_fn(|_| value.clone())
            }
            #[inline(always)]
            fn node(row: usize) -> f64 {
                <Self as Explicit>::node(row)
            }
            #[inline(always)]
            fn weights(row: usize) -> (&'static [f64], &'static [f64]) {
                (&Self::position(row)[..row], &Self::rate(row)[..row])
            }
            const SLOPES: usize = $SLOPES;
            fn dense(share: f64) -> [[f64; ROWS]; 2] {
                let (mut in_position, mut in_rate) = ([0.0; ROWS], [0.0; ROWS]);
                <Self as Explicit>::dense(share, &mut in_rate[..<Self as Explicit>::ROWS]);
                for (row, weight) in in_rate[..$SLOPES].iter().enumerate() {
                    in_position.iter_mut().zip(Self::rate(row)).for_each(|(sum, a)| *sum += weight * a);
                }
                [in_position, in_rate]
            }
            fn sweeps(&self, _: usize) -> usize {
                1
            }
            fn springs<T: Scalar>(&self, _: usize, _: T::Real) -> element::Explicit {
                element::Explicit
            }
        }
    )*};
}
explicit!(Rk4: 4 of 4, Dopri5: 6 of 7, Dop853: 12 of 16);

impl Staged for Sdirk4 {
    const STAGES: usize = STAGES;
    const IMPLICIT: bool = true;
    const RESTORES: bool = true;
    type Rows<X> = [X; STAGES + 1];
    type Stages<X> = [X; STAGES];
    type Springs<T: Scalar> = element::Implicit<T::Real>;

    fn rows<X: Clone>(value: &X) -> [X; STAGES + 1] {
        core::array::from_fn(|_| value.clone())
    }
    fn stages<X: Clone>(value: &X) -> [X; STAGES] {
        core::array::from_fn(|_| value.clone())
    }
    #[inline(always)]
    fn node(row: usize) -> f64 {
        TABLE.nodes[row.min(STAGES - 1)]
    }
    /// The step is where its last stage ends.
    #[inline(always)]
    fn weights(row: usize) -> (&'static [f64], &'static [f64]) {
        let stage = row.min(STAGES - 1);
        (&TABLE.position[stage][..row], &TABLE.rate[stage][..row])
    }
    fn sweeps(&self, row: usize) -> usize {
        self.sweeps + usize::from(row == 0)
    }
    fn springs<T: Scalar>(&self, _: usize, step: T::Real) -> element::Implicit<T::Real> {
        let own = T::Real::of(GAMMA) * step;
        element::Implicit { position: own * own, rate: own }
    }
    fn own<T: Scalar>(&self, step: T::Real) -> [[T::Real; 2]; 2] {
        let gamma = T::Real::of(GAMMA);
        let own = gamma * step;
        [[own * own, own], [(gamma + gamma) * own, gamma]]
    }
}

/// Row 0 is where a step begins, row 1 its end.
impl Staged for GeneralizedAlpha {
    const STAGES: usize = 2;
    const IMPLICIT: bool = true;
    const REMEMBERS: bool = true;
    type Rows<X> = [X; 3];
    type Stages<X> = [X; 2];
    type Springs<T: Scalar> = element::Implicit<T::Real>;

    fn rows<X: Clone>(value: &X) -> [X; 3] {
        core::array::from_fn(|_| value.clone())
    }
    fn stages<X: Clone>(value: &X) -> [X; 2] {
        core::array::from_fn(|_| value.clone())
    }
    fn node(row: usize) -> f64 {
        if row > 0 { 1.0 } else { 0.0 }
    }
    /// Weights here are the parameters', and stand in [`memory`](super::memory).
    fn weights(row: usize) -> (&'static [f64], &'static [f64]) {
        let none: &[f64] = &[0.0; 2][..row];
        (none, none)
    }
    fn sweeps(&self, row: usize) -> usize {
        if row > 0 { self.sweeps } else { 1 }
    }
    /// A step begins with accelerations that are found by an explicit sweep.
    fn springs<T: Scalar>(&self, row: usize, step: T::Real) -> element::Implicit<T::Real> {
        let [[position, rate], _] = self.own::<T>(if row > 0 { step } else { T::Real::zero() });
        element::Implicit { position, rate }
    }
    fn own<T: Scalar>(&self, step: T::Real) -> [[T::Real; 2]; 2] {
        let [kappa, ..] = self.recurrence();
        let [position, rate] = [self.beta * kappa, self.gamma * kappa].map(T::Real::of);
        [[position * (step * step), rate * step], [(position + position) * step, rate]]
    }
    fn family(&self) -> Option<&GeneralizedAlpha> {
        Some(self)
    }
    fn fault(&self) -> Option<Fault> {
        self.fault
    }
}
