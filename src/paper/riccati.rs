//! The Riccati transform of section 5.5: f = S p + e, with p = (r, θ) and f = (m, q).
//!
//! Tip to root each link turns the relation at its outboard end into one at its inboard end; root to tip p is recovered, and f from
//! it. Nothing is ever multiplied up, so nothing overflows, and no force is propagated. Worked in increments it keeps three to
//! five digits more than in absolute coordinates.
//!
//! At displacement level S is not symmetric. In the plane (32) mixes c̄ with c; in space rates enter by χ₃, whose torques
//! ω × Jω are gyroscopic, and the slot of the angles is not conjugate to torques about fixed axes. All its entries are kept.

use super::link::{End, Law, Link, conjugate, dot, inverse};
use crate::error::{Error, Fault, Place};
use crate::scalar::Scalar;
use crate::state::{StateVector, TransferMatrix};
use crate::transfer::solve_dense;

/// f = S p + e at a station.
#[derive(Clone, Copy, Debug)]
pub struct Relation<T, const H: usize, const P: usize, const A: usize> {
    /// S: rows m, q; columns r, θ.
    pub matrix: [[T; H]; H],
    /// e.
    pub offset: [T; H],
}

/// θ_O = b (r, θ_I) + b₀ in a joint.
#[derive(Clone, Copy, Debug)]
pub struct Gain<T, const H: usize, const A: usize> {
    slope: [[T; H]; A],
    free: [T; A],
}

impl<T: Scalar, const H: usize, const P: usize, const A: usize> Relation<T, H, P, A> {
    /// A free tip: f = 0.
    pub fn free() -> Self {
        Self::pulled([T::zero(); H])
    }

    /// A tip with force and torque f.
    pub fn pulled(offset: [T; H]) -> Self {
        Self { matrix: [[T::zero(); H]; H], offset }
    }

    /// f for p.
    pub fn force(&self, p: &[T; H]) -> [T; H] {
        core::array::from_fn(|i| {
            self.matrix[i].iter().zip(p).fold(T::zero(), |sum, (s, p)| sum + *s * *p) + self.offset[i]
        })
    }

    /// Inward through a body: D f_I = (S A − C) p_I + S a + e − d, with the blocks of its matrix [A B; C D] and B = 0.
    #[must_use]
    pub fn through_body<const N: usize>(&self, u: &TransferMatrix<T, N>) -> Self {
        let (one, torque, force) = (N - 1, H, H + A);
        let mut s = self.matrix;
        let mut e = self.offset;
        for (row, offset) in s.iter_mut().zip(&mut e) {
            for i in 0..P {
                *offset += row[i] * u[(i, one)];
                for k in P..H {
                    row[k] += row[i] * u[(i, k)];
                }
            }
        }
        for i in A..H {
            for j in 0..H {
                s[i][j] -= u[(H + i, j)];
            }
            e[i] -= u[(H + i, one)];
        }
        // D⁻¹: the sign of r_IO~ changes.
        for a in 0..A {
            for j in 0..H {
                let arms = (0..P).fold(u[(torque + a, j)], |sum, i| sum + u[(torque + a, force + i)] * s[A + i][j]);
                s[a][j] -= arms;
            }
            e[a] -= (0..P).fold(u[(torque + a, one)], |sum, i| sum + u[(torque + a, force + i)] * e[A + i]);
        }
        Self { matrix: s, offset: e }
    }

    /// Inward through a joint with m = K_O θ_O − K_I θ_I + μ. A smooth joint has K = 0; its pivot −S_mθ is the inertia outboard about
    /// it, times χ₁.
    #[must_use]
    pub fn through_joint(&self, law: &Law<T, A>) -> (Self, Gain<T, H, A>) {
        let s_m = |a: usize, c: usize| self.matrix[a][P + c];
        let pivot = inverse(&core::array::from_fn(|a| core::array::from_fn(|c| law.outer[a][c] - s_m(a, c))));
        let times =
            |row: &[T; A], column: &dyn Fn(usize) -> T| (0..A).fold(T::zero(), |sum, c| sum + row[c] * column(c));
        let slope: [[T; H]; A] = core::array::from_fn(|a| {
            core::array::from_fn(|j| times(&pivot[a], &|c| if j < P { self.matrix[c][j] } else { law.inner[c][j - P] }))
        });
        let free: [T; A] = core::array::from_fn(|a| times(&pivot[a], &|c| self.offset[c] - law.offset[c]));
        let mut s = self.matrix;
        let mut e = self.offset;
        for i in A..H {
            let turned: [T; A] = core::array::from_fn(|c| self.matrix[i][P + c]);
            for j in 0..H {
                let by = times(&turned, &|c| slope[c][j]);
                s[i][j] = if j < P { s[i][j] + by } else { by };
            }
            e[i] += times(&turned, &|c| free[c]);
        }
        for a in 0..A {
            let own: [T; A] = core::array::from_fn(|c| s_m(a, c));
            for j in 0..H {
                // (K_O b − K_I) of the angles is S_mθ b, for K_O = (K_O − S_mθ) + S_mθ.
                s[a][j] = times(if j < P { &law.outer[a] } else { &own }, &|c| slope[c][j]);
            }
            e[a] = times(&law.outer[a], &|c| free[c]) + law.offset[a];
        }
        (Self { matrix: s, offset: e }, Gain { slope, free })
    }

    /// Inward through a joint with θ_O = R θ_I + `ahead`.
    #[must_use]
    fn through_rigid(&self, turn: Option<&[[T; A]; A]>, ahead: &[T; A]) -> Self {
        let Some(turn) = turn else { return *self };
        let mut relation = *self;
        for i in 0..H {
            for k in 0..A {
                relation.matrix[i][P + k] = (0..A).fold(T::zero(), |sum, c| sum + self.matrix[i][P + c] * turn[c][k]);
                relation.offset[i] += self.matrix[i][P + k] * ahead[k];
            }
        }
        relation
    }
}

impl<T: Scalar, const H: usize, const A: usize> Gain<T, H, A> {
    /// Room.
    pub fn blank() -> Self {
        Self { slope: [[T::zero(); H]; A], free: [T::zero(); A] }
    }

    fn is_finite(&self) -> bool {
        self.slope.iter().flatten().chain(&self.free).all(|x| x.is_finite())
    }
}

/// Room for the transform.
#[derive(Clone, Debug)]
pub struct Room<T, const H: usize, const P: usize, const A: usize> {
    relations: alloc::vec::Vec<Relation<T, H, P, A>>,
    gains: alloc::vec::Vec<Gain<T, H, A>>,
}

impl<T: Scalar, const H: usize, const P: usize, const A: usize> Room<T, H, P, A> {
    /// For so many links.
    pub fn new(links: usize) -> Self {
        Self { relations: alloc::vec![Relation::free(); links], gains: alloc::vec![Gain::blank(); links] }
    }

    /// Solves a chain: writes the states of all stations, the inboard ends of all links and the tip.
    ///
    /// A tip that is held is held by forces λ. p at the tip is linear in them, so it is looked at for none and for one at a time: S does
    /// not change, nor does the stability of the sweep.
    ///
    /// # Errors
    /// [`Fault::SingularJoint`] at a joint in which nothing resists rotation, or at a root that nothing holds and no mass resists;
    /// [`Fault::SingularTransfer`] at a tip that cannot be held so.
    pub fn solve<const N: usize>(
        &mut self,
        links: &[Link<T, N, A>],
        [root, tip]: [&End<T, H>; 2],
        states: &mut [StateVector<T, N>],
    ) -> Result<(), Error> {
        let pulled = |forces: &[T; H]| {
            let mut f = [T::zero(); H];
            for (axis, force) in tip.axes.iter().zip(forces) {
                for (i, along) in axis.iter().enumerate() {
                    f[conjugate::<P, A>(i)] += *along * *force;
                }
            }
            f
        };
        let known = |k: usize| if tip.held[k] { T::zero() } else { tip.known[k] };
        let mut forces: [T; H] = core::array::from_fn(known);
        let reached = self.sweep(links, root, pulled(&forces), states)?;
        if !tip.is_held() {
            return Ok(());
        }
        // What a force of one does to the tip.
        let mut yields = [[T::zero(); H]; H];
        for k in 0..H {
            yields[k][k] = T::one();
            if tip.held[k] {
                let mut one = forces;
                one[k] += T::one();
                let moved = self.sweep(links, root, pulled(&one), states)?;
                for (row, axis) in tip.axes.iter().enumerate().filter(|(row, _)| tip.held[*row]) {
                    yields[row][k] = dot(axis, &moved) - dot(axis, &reached);
                }
            }
        }
        // A second time for what rounding left.
        let mut at = reached;
        for _ in 0..2 {
            let left =
                core::array::from_fn(|k| if tip.held[k] { tip.known[k] - dot(&tip.axes[k], &at) } else { T::zero() });
            let more = solve_dense(yields, left).ok_or(Error::new(Fault::SingularTransfer).at(Place::Tip))?;
            forces = core::array::from_fn(|k| forces[k] + more[k]);
            at = self.sweep(links, root, pulled(&forces), states)?;
        }
        Ok(())
    }

    /// One sweep for a force f at the tip; gives p there.
    fn sweep<const N: usize>(
        &mut self,
        links: &[Link<T, N, A>],
        root: &End<T, H>,
        pull: [T; H],
        states: &mut [StateVector<T, N>],
    ) -> Result<[T; H], Error> {
        let Self { relations, gains } = self;
        let mut relation = Relation::pulled(pull);
        for (k, link) in links.iter().enumerate().rev() {
            match link {
                Link::Body { matrix, .. } => relation = relation.through_body(matrix),
                Link::Turning { law, .. } => {
                    let (inner, gain) = relation.through_joint(law);
                    if !gain.is_finite() {
                        let known = relation.matrix.iter().flatten().chain(&relation.offset).all(|x| x.is_finite());
                        let fault = if known { Fault::SingularJoint } else { Fault::NonFiniteMotion };
                        // Links are counted from the root's joint, stations from the first element outboard of it.
                        return Err(Error::new(fault).at_station(k.saturating_sub(1)));
                    }
                    relation = inner;
                    gains[k] = gain;
                }
                Link::Rigid { turn, ahead } => relation = relation.through_rigid(turn.as_ref(), ahead),
            }
            relations[k] = relation;
        }
        let mut p = at_root(&relation, root)?;
        for (k, link) in links.iter().enumerate() {
            states[k] = state(&p, &relations[k].force(&p));
            p = match link {
                Link::Body { matrix: u, .. } => core::array::from_fn(|i| {
                    if i >= P { p[i] } else { (P..H).fold(p[i], |sum, j| sum + u[(i, j)] * p[j]) + u[(i, N - 1)] }
                }),
                Link::Turning { .. } => {
                    let Gain { slope, free } = &gains[k];
                    core::array::from_fn(|i| if i < P { p[i] } else { dot(&slope[i - P], &p) + free[i - P] })
                }
                Link::Rigid { turn: Some(turn), ahead } => core::array::from_fn(|i| {
                    if i < P { p[i] } else { (0..A).fold(ahead[i - P], |sum, c| sum + turn[i - P][c] * p[P + c]) }
                }),
                Link::Rigid { turn: None, .. } => p,
            };
        }
        states[links.len()] = state(&p, &pull);
        Ok(p)
    }
}

/// p at the root: along each direction its motion is known, or its force.
fn at_root<T: Scalar, const H: usize, const P: usize, const A: usize>(
    relation: &Relation<T, H, P, A>,
    root: &End<T, H>,
) -> Result<[T; H], Error> {
    let along = |axis: &[T; H], f: &dyn Fn(usize) -> T| {
        (0..H).fold(T::zero(), |sum, i| sum + axis[i] * f(conjugate::<P, A>(i)))
    };
    let mut a = [[T::zero(); H]; H];
    let mut b = root.known;
    for (k, axis) in root.axes.iter().enumerate() {
        if root.held[k] {
            a[k][k] = T::one();
            continue;
        }
        for (l, other) in root.axes.iter().enumerate() {
            a[k][l] = along(axis, &|i| dot(&relation.matrix[i], other));
        }
        b[k] -= along(axis, &|i| relation.offset[i]);
    }
    if !a.iter().flatten().chain(&b).all(|x| x.is_finite()) {
        return Err(Error::new(Fault::NonFiniteMotion).at(Place::Root));
    }
    let found = solve_dense(a, b).ok_or(Error::new(Fault::SingularJoint).at(Place::Root))?;
    Ok(core::array::from_fn(|i| (0..H).fold(T::zero(), |sum, k| sum + found[k] * root.axes[k][i])))
}

fn state<T: Scalar, const N: usize, const H: usize>(p: &[T; H], f: &[T; H]) -> StateVector<T, N> {
    StateVector::new(core::array::from_fn(|i| match i {
        i if i < H => p[i],
        i if i < 2 * H => f[i - H],
        _ => T::one(),
    }))
}
