//! f = S p + e in increments, and what each link makes of it on the way inward.
//!
//! At displacement level S is not symmetric. In the plane (32) mixes c̄ with c; in space rates enter by χ₃, whose torques
//! ω × Jω are gyroscopic, and the slot of the angles is not conjugate to torques about fixed axes. All its entries are kept.

use super::hinge::Linear;
use super::link::{Law, Link, dot, inverse};
use crate::error::{Error, Fault};
use crate::scalar::Scalar;
use crate::state::TransferMatrix;

/// f = S p + e at a station.
#[derive(Clone, Copy, Debug)]
pub struct Relation<T, const H: usize, const P: usize, const A: usize> {
    /// S: rows m, q; columns r, θ.
    pub matrix: [[T; H]; H],
    /// e.
    pub offset: [T; H],
}

/// How p at the outboard end of a link follows from p at its inboard end: what the walk outward needs of a link, a tenth of its matrix.
#[derive(Clone, Copy, Debug)]
pub enum Outward<T, const H: usize, const P: usize, const A: usize> {
    /// r_O = r_I + B θ + b in a body.
    Body {
        /// B (m/rad).
        arm: [[T; A]; P],
        /// b (m).
        ahead: [T; P],
    },
    /// θ_O = b (r, θ_I) + b₀ in a joint that turns.
    Turning {
        /// b.
        slope: [[T; H]; A],
        /// b₀.
        free: [T; A],
    },
    /// What a joint whose points part does is in [`Slides`].
    Parting,
    /// θ_O = R θ_I in one that does not.
    Rigid {
        /// R; none where it is one.
        turn: Option<[[T; A]; A]>,
    },
}

/// How p beyond a joint with linear springs follows: r_O = b (r, θ) + b₀ axis by axis, the last first, of r_O for the axes before and of r_I
/// for the others; then its rotation.
#[derive(Clone, Copy, Debug)]
pub struct Slides<T, const H: usize, const P: usize, const A: usize> {
    slope: [[T; H]; P],
    free: [T; P],
    turning: Outward<T, H, P, A>,
}

impl<T: Scalar, const H: usize, const P: usize, const A: usize> Slides<T, H, P, A> {
    /// Room.
    pub fn blank() -> Self {
        Self { slope: [[T::zero(); H]; P], free: [T::zero(); P], turning: Outward::blank() }
    }

    /// Whether each axis, and the rotation, had something to push against.
    pub fn is_finite(&self) -> bool {
        self.turning.is_finite() && self.slope.iter().flatten().chain(&self.free).all(|x| x.is_finite())
    }

    /// p at the outboard end.
    #[cold]
    #[inline(never)]
    pub fn follow(&self, p: &[T; H]) -> [T; H] {
        let mut p = *p;
        for i in (0..P).rev() {
            p[i] = dot(&self.slope[i], &p) + self.free[i];
        }
        self.turning.follow(&p)
    }
}

impl<T: Scalar, const H: usize, const P: usize, const A: usize> Relation<T, H, P, A> {
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

    /// What is wrong with joint `k` of a chain, through which the way is not finite.
    #[cold]
    pub fn singular(&self, k: usize) -> Error {
        let known = self.matrix.iter().flatten().chain(&self.offset).all(|x| x.is_finite());
        let fault = if known { Fault::SingularJoint } else { Fault::NonFiniteMotion };
        // Links are counted from the root's joint, stations from the first element outboard of it.
        Error::new(fault).at_station(k.saturating_sub(1))
    }

    /// Inward through a link whose points coincide, and the way back.
    #[cfg_attr(optimised, inline(always))]
    pub fn through<const N: usize>(&self, link: &Link<T, N, P, A>) -> (Self, Outward<T, H, P, A>) {
        match link {
            Link::Body { matrix, .. } => self.through_body(matrix),
            Link::Turning { law, .. } => self.through_joint(law),
            Link::Rigid { turn, .. } => (self.through_rigid(turn.as_ref()), Outward::Rigid { turn: *turn }),
            Link::Parting { .. } => (*self, Outward::Parting), // see `through_parting`
        }
    }

    /// Inward through a body: D f_I = (S A − C) p_I + S a + e − d, with the blocks of its matrix [A B; C D] and B = 0.
    #[cfg_attr(optimised, inline(always))]
    fn through_body<const N: usize>(&self, u: &TransferMatrix<T, N>) -> (Self, Outward<T, H, P, A>) {
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
        let arm = core::array::from_fn(|i| core::array::from_fn(|k| u[(i, P + k)]));
        (Self { matrix: s, offset: e }, Outward::Body { arm, ahead: core::array::from_fn(|i| u[(i, one)]) })
    }

    /// Inward through a joint with m = K_O θ_O − K_I θ_I + μ. A smooth joint has K = 0; its pivot −S_mθ is the inertia outboard about
    /// it, times χ₁.
    #[cfg_attr(optimised, inline(always))]
    fn through_joint(&self, law: &Law<T, A>) -> (Self, Outward<T, H, P, A>) {
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
        (Self { matrix: s, offset: e }, Outward::Turning { slope, free })
    }

    /// Inward through a joint whose points part: its rotation, then linear springs, q = −κ (r_O − r_I) − ν axis by axis. The pivot κ + S_qr is
    /// a stiffness and the mass outboard, times χ₁; κ may be zero. Most chains have no such joint.
    #[cold]
    #[inline(never)]
    pub fn through_parting(&self, law: &Law<T, A>, linear: &[Linear<T>; P]) -> (Self, Slides<T, H, P, A>) {
        let (mut relation, turning) = self.through_joint(law);
        let mut slides = Slides { turning, ..Slides::blank() };
        for (i, Linear { slope: kappa, offset }) in linear.iter().enumerate() {
            let Self { matrix: s, offset: e } = &mut relation;
            let (own, rest) = (s[A + i], e[A + i]);
            let pivot = (*kappa + own[i]).recip();
            let slope: [T; H] = core::array::from_fn(|j| (if j == i { *kappa } else { -own[j] }) * pivot);
            let free = -((rest + *offset) * pivot);
            for (row, e) in s.iter_mut().zip(e.iter_mut()) {
                let by = row[i];
                for j in 0..H {
                    row[j] = if j == i { by * slope[j] } else { row[j] + by * slope[j] };
                }
                *e += by * free;
            }
            // Without differences of what is stiff: −κ (r_O − r_I) − ν.
            s[A + i] = core::array::from_fn(|j| if j == i { own[i] * slope[i] } else { -(*kappa * slope[j]) });
            e[A + i] = (*kappa * rest - own[i] * *offset) * pivot;
            (slides.slope[i], slides.free[i]) = (slope, free);
        }
        (relation, slides)
    }

    /// Inward through a joint with θ_O = R θ_I.
    #[cfg_attr(optimised, inline(always))]
    fn through_rigid(&self, turn: Option<&[[T; A]; A]>) -> Self {
        let Some(turn) = turn else { return *self };
        let mut relation = *self;
        for (row, own) in relation.matrix.iter_mut().zip(&self.matrix) {
            for (k, entry) in row[P..].iter_mut().enumerate() {
                *entry = (0..A).fold(T::zero(), |sum, c| sum + own[P + c] * turn[c][k]);
            }
        }
        relation
    }
}

impl<T: Scalar, const H: usize, const P: usize, const A: usize> Outward<T, H, P, A> {
    /// Room.
    pub fn blank() -> Self {
        Self::Rigid { turn: None }
    }

    /// Whether a joint had something to push against.
    pub fn is_finite(&self) -> bool {
        match self {
            Self::Turning { slope, free } => slope.iter().flatten().chain(free).all(|x| x.is_finite()),
            _ => true,
        }
    }

    /// p at the outboard end.
    #[cfg_attr(optimised, inline(always))]
    pub fn follow(&self, p: &[T; H]) -> [T; H] {
        match self {
            Self::Body { arm, ahead } => core::array::from_fn(|i| {
                if i >= P { p[i] } else { (0..A).fold(p[i], |sum, k| sum + arm[i][k] * p[P + k]) + ahead[i] }
            }),
            Self::Turning { slope, free } => {
                core::array::from_fn(|i| if i < P { p[i] } else { dot(&slope[i - P], p) + free[i - P] })
            }
            Self::Rigid { turn: Some(turn) } => core::array::from_fn(|i| {
                if i < P { p[i] } else { (0..A).fold(T::zero(), |sum, c| sum + turn[i - P][c] * p[P + c]) }
            }),
            Self::Rigid { turn: None } | Self::Parting => *p,
        }
    }
}
