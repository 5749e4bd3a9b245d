//! Ties between joints in runs that go backward: rows C, one for each, and their forces λ beside the equations of motion.
//!
//! With what a unit of each force causes, r = M⁻¹ Cᵀ, and G = C r, a sweep and its costates are
//!
//! ```text
//! M a + c = τ + Cᵀλ,  C a = 0:           λ = −G⁻¹ C a₀         a = a₀ + r λ
//! M w + Cᵀν = λ_a,    C w = 0:           ν = G⁻¹ C w₀         w = w₀ − r ν
//! by the ratio of a follower f to its leader l:               ν a_l − λ w_l
//! ```
//!
//! where a₀ are accelerations without, and w₀ = M⁻¹ λ_a, so that C w₀ = rᵀ λ_a.
//!
//! Where something is held or closed M⁻¹ is that of what closures leave free, and a correction that closes, x₀, puts followers back, too, by what
//! they miss, m: by their offsets as well, which else stand in the start alone.
//!
//! ```text
//! x = x₀ + r λ        λ = −G⁻¹ (m + C x₀)        x̄₀ = x̄ + Cᵀμ        m̄ = μ = −G⁻¹ rᵀ x̄
//! ```

use crate::error::Fault;
use crate::loading::EffortOf;
use crate::mirror::{Position, Rate};
use crate::space::Space;
use crate::visit::Level;

/// Ties between joints, decided by type: [`Couplings`](crate::planar::Couplings), or none.
pub trait Ties<S: Space>: Copy {
    /// One `X` for each tie.
    type Each<X: Clone>: AsRef<[X]> + AsMut<[X]> + Clone;
    /// Number of ties.
    const COUNT: usize;

    /// Copies of a value.
    fn each<X: Clone>(value: &X) -> Self::Each<X>;
    /// Adds a share of each row to costates of rates: Cᵀ times shares.
    fn add_rows<V: Rate<S::Scalar>>(&self, shares: &Self::Each<S::Scalar>, costates: &mut V);
    /// λ = −G⁻¹ C a₀.
    fn balanced<V: Rate<S::Scalar>>(&self, responses: &Self::Each<V>, free: &V) -> Self::Each<S::Scalar>;
    /// −ν = −G⁻¹ rᵀ λ_a.
    fn minus_weights<V: Rate<S::Scalar>>(&self, responses: &Self::Each<V>, costates: &V) -> Self::Each<S::Scalar>;
    /// Adds to a correction of positions, or of rates, what puts followers back; gives λ.
    fn rejoin<P: Position<S::Scalar>>(
        &self,
        responses: &Self::Each<P::Rate>,
        level: Level,
        motion: (&P, &P::Rate),
        correction: &mut P::Rate,
    ) -> Self::Each<S::Scalar>;
    /// Adds costates of positions, or of rates, of ratios and of offsets, by μ, where a motion with its correction is put back.
    fn weigh_missed<P: Position<S::Scalar>>(
        &self,
        level: Level,
        motion: (&P, &P::Rate, &P::Rate),
        minus_weights: &Self::Each<S::Scalar>,
        costates: &mut P::Rate,
        of_ties: [&mut [S::Scalar]; 2],
    );
    /// Adds what forces λ exert in a joint.
    fn exert(&self, joint: usize, forces: &Self::Each<S::Scalar>, effort: &mut EffortOf<S>);
    /// Adds costates of ratios, by λ and −ν, a and w.
    fn weigh<V: Rate<S::Scalar>>(
        &self,
        forces: [&Self::Each<S::Scalar>; 2],
        motions: [&V; 2],
        of_ratios: &mut [S::Scalar],
    );
    /// Refuses a scene whose joints are not those of the ties.
    fn check(&self, bodies: usize, joints: usize) -> Result<(), Fault>;
    /// Refuses a motion that is not tied, with the number of a joint.
    fn suits<P: Position<S::Scalar>>(&self, position: &P, rate: &P::Rate) -> Result<(), (Fault, usize)>;
}

impl<S: Space> Ties<S> for () {
    type Each<X: Clone> = [X; 0];
    const COUNT: usize = 0;

    fn each<X: Clone>(_: &X) -> [X; 0] {
        []
    }
    fn add_rows<V: Rate<S::Scalar>>(&self, _: &[S::Scalar; 0], _: &mut V) {}
    fn balanced<V: Rate<S::Scalar>>(&self, _: &[V; 0], _: &V) -> [S::Scalar; 0] {
        []
    }
    fn minus_weights<V: Rate<S::Scalar>>(&self, _: &[V; 0], _: &V) -> [S::Scalar; 0] {
        []
    }
    fn rejoin<P: Position<S::Scalar>>(
        &self,
        _: &[P::Rate; 0],
        _: Level,
        _: (&P, &P::Rate),
        _: &mut P::Rate,
    ) -> [S::Scalar; 0] {
        []
    }
    fn weigh_missed<P: Position<S::Scalar>>(
        &self,
        _: Level,
        _: (&P, &P::Rate, &P::Rate),
        _: &[S::Scalar; 0],
        _: &mut P::Rate,
        _: [&mut [S::Scalar]; 2],
    ) {
    }
    fn exert(&self, _: usize, _: &[S::Scalar; 0], _: &mut EffortOf<S>) {}
    fn weigh<V: Rate<S::Scalar>>(&self, _: [&[S::Scalar; 0]; 2], _: [&V; 2], _: &mut [S::Scalar]) {}
    fn check(&self, _: usize, _: usize) -> Result<(), Fault> {
        Ok(())
    }
    fn suits<P: Position<S::Scalar>>(&self, _: &P, _: &P::Rate) -> Result<(), (Fault, usize)> {
        Ok(())
    }
}
