//! The Riccati transform of section 5.5: f = S p + e, with p = (r, θ) and f = (m, q).
//!
//! Tip to root each link turns the relation at its outboard end into one at its inboard end; root to tip p is recovered, and f from
//! it. Nothing is ever multiplied up, so nothing overflows, and no force is propagated. Worked in increments it keeps three to
//! five digits more than in absolute coordinates.

use super::hinge::Linear;
use super::link::{End, Law, Link, conjugate, dot};
use super::relation::{Outward, Relation, Slides};
use crate::error::{Error, Fault, Place};
use crate::scalar::Scalar;
use crate::state::StateVector;
use crate::transfer::solve_dense;
use alloc::{vec, vec::Vec};

/// How many links the transform asks for at a time: few enough to stay in the cache next to the processor.
pub const BLOCK: usize = 16;

/// What a walk inward leaves for the walk outward: all that is kept of a chain. Links may come block by block and be gone after.
#[derive(Clone, Debug)]
pub struct Room<T, const H: usize, const P: usize, const A: usize> {
    /// At the outboard end of each body. Joints hand on m and q as they are.
    relations: Vec<Relation<T, H, P, A>>,
    outward: Vec<Outward<T, H, P, A>>,
    /// Of the joints whose points part.
    slides: Vec<Slides<T, H, P, A>>,
    /// Where the walk inward has come to, and how many bodies are left.
    reached: Relation<T, H, P, A>,
    left: usize,
    /// How many joints whose points part are left.
    parting: usize,
    /// f at the tip.
    pull: [T; H],
}

impl<T: Scalar, const H: usize, const P: usize, const A: usize> Room<T, H, P, A> {
    /// For so many links, and among them bodies, and joints whose points part.
    pub fn new(links: usize, bodies: usize, parting: usize) -> Self {
        let pull = [T::zero(); H];
        let free = Relation::pulled(pull);
        Self {
            relations: vec![free; bodies],
            outward: vec![Outward::blank(); links],
            slides: vec![Slides::blank(); parting],
            reached: free,
            left: bodies,
            parting,
            pull,
        }
    }

    /// Begins at a tip that is not held.
    pub fn begin(&mut self, tip: &End<T, H>) {
        self.pull_by(tip, &tip.known);
    }

    /// Begins at a tip with forces along its directions.
    fn pull_by(&mut self, tip: &End<T, H>, forces: &[T; H]) {
        self.pull = [T::zero(); H];
        for (axis, force) in tip.pulls.iter().zip(forces) {
            for (i, along) in axis.iter().enumerate() {
                self.pull[conjugate::<P, A>(i)] += *along * *force;
            }
        }
        self.reached = Relation::pulled(self.pull);
        self.left = self.relations.len();
        self.parting = self.slides.len();
    }

    /// Inward through links that end where the walk is, the first of them number `first` of the chain.
    ///
    /// # Errors
    /// [`Fault::SingularJoint`] at a joint in which nothing resists rotation, or parting.
    pub fn inward<const N: usize>(&mut self, first: usize, links: &[Link<T, N, P, A>]) -> Result<(), Error> {
        match self.slides.is_empty() {
            true => self.walk_inward::<N, false>(first, links),
            false => self.walk_inward::<N, true>(first, links),
        }
    }

    /// Eliminates links from the tip inward, with or without joints whose points part.
    #[cfg_attr(optimised, inline(always))]
    fn walk_inward<const N: usize, const PARTING: bool>(
        &mut self,
        first: usize,
        links: &[Link<T, N, P, A>],
    ) -> Result<(), Error> {
        for (k, link) in links.iter().enumerate().rev().map(|(k, link)| (first + k, link)) {
            if PARTING && let Link::Parting { law, linear, .. } = link {
                self.part(k, law, linear)?;
                continue;
            }
            let Self { relations, outward, reached, left, .. } = self;
            let (inner, way) = reached.through(link);
            if !way.is_finite() {
                return Err(reached.singular(k));
            }
            if let Link::Body { .. } = link {
                *left -= 1;
                relations[*left] = *reached;
            }
            *reached = inner;
            outward[k] = way;
        }
        Ok(())
    }

    /// Inward through a joint whose points part, link `k`. Most chains have none.
    #[cold]
    fn part(&mut self, k: usize, law: &Law<T, A>, linear: &[Linear<T>; P]) -> Result<(), Error> {
        let (inner, slides) = self.reached.through_parting(law, linear);
        if !slides.is_finite() {
            return Err(self.reached.singular(k));
        }
        self.parting -= 1;
        self.slides[self.parting] = slides;
        self.reached = inner;
        self.outward[k] = Outward::Parting;
        Ok(())
    }

    /// Outward again: writes the states of all stations, the inboard ends of all links and the tip; gives p at the tip.
    ///
    /// # Errors
    /// [`Fault::SingularJoint`] at a root that nothing holds and no mass resists; [`Fault::NonFiniteMotion`].
    pub fn outward<const N: usize>(&self, root: &End<T, H>, states: &mut [StateVector<T, N>]) -> Result<[T; H], Error> {
        match self.slides.is_empty() {
            true => self.walk_outward::<N, false>(root, states),
            false => self.walk_outward::<N, true>(root, states),
        }
    }

    /// Finds the states of links from the root outward, with or without joints whose points part.
    #[cfg_attr(optimised, inline(always))]
    fn walk_outward<const N: usize, const PARTING: bool>(
        &self,
        root: &End<T, H>,
        states: &mut [StateVector<T, N>],
    ) -> Result<[T; H], Error> {
        let mut p = at_root(&self.reached, root)?;
        let mut f = self.reached.force(&p);
        let (mut relations, mut slides) = (self.relations.iter(), self.slides.iter());
        let mut finite = true;
        let mut state = |p: &[T; H], f: &[T; H]| {
            finite &= p.iter().chain(f).all(|x| x.is_finite());
            StateVector::new(core::array::from_fn(|i| match i {
                i if i < H => p[i],
                i if i < 2 * H => f[i - H],
                _ => T::one(),
            }))
        };
        for (outward, z) in self.outward.iter().zip(&mut *states) {
            *z = state(&p, &f);
            p = match outward {
                Outward::Parting if PARTING => slides.next().map_or(p, |slides| slides.follow(&p)),
                _ => outward.follow(&p),
            };
            if let Outward::Body { .. } = outward
                && let Some(relation) = relations.next()
            {
                f = relation.force(&p);
            }
        }
        if let Some(tip) = states.last_mut() {
            *tip = state(&p, &f);
        }
        if finite { Ok(p) } else { Err(Error::new(Fault::NonFiniteMotion)) }
    }

    /// Solves a chain whose links are all there.
    ///
    /// A tip that is held is held by forces λ. p at the tip is linear in them, so it is looked at for none and for one at a time: S does
    /// not change, nor does the stability of the sweep.
    ///
    /// # Errors
    /// Those of [`inward`](Self::inward) and [`outward`](Self::outward); [`Fault::SingularTransfer`] at a tip that cannot be held so.
    pub fn solve<const N: usize>(
        &mut self,
        links: &[Link<T, N, P, A>],
        [root, tip]: [&End<T, H>; 2],
        states: &mut [StateVector<T, N>],
    ) -> Result<(), Error> {
        let mut sweep = |forces: &[T; H]| {
            self.pull_by(tip, forces);
            self.inward(0, links)?;
            self.outward(root, states)
        };
        let mut forces: [T; H] = core::array::from_fn(|k| if tip.held[k] { T::zero() } else { tip.known[k] });
        let reached = sweep(&forces)?;
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
                let moved = sweep(&one)?;
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
            at = sweep(&forces)?;
        }
        Ok(())
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
    for (k, axis) in root.pulls.iter().enumerate() {
        if root.held[k] {
            a[k][k] = T::one();
            continue;
        }
        for (l, other) in root.bases.iter().enumerate() {
            a[k][l] = along(axis, &|i| dot(&relation.matrix[i], other));
        }
        b[k] -= along(axis, &|i| relation.offset[i]);
    }
    if !a.iter().flatten().chain(&b).all(|x| x.is_finite()) {
        return Err(Error::new(Fault::NonFiniteMotion).at(Place::Root));
    }
    let found = solve_dense(a, b).ok_or(Error::new(Fault::SingularJoint).at(Place::Root))?;
    Ok(core::array::from_fn(|i| (0..H).fold(T::zero(), |sum, k| sum + found[k] * root.bases[k][i])))
}
