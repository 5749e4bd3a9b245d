//! How inertia forces change with position where accelerations stay as they are: (∂M/∂q) a.
//!
//! What a sweep finds are accelerations, and away from rest M ∂a/∂q is no stiffness: forces Q = M a change by M ∂a/∂q + (∂M/∂q) a.
//! Of the second term this is the symmetric part, which is all of it that a potential knows. It follows from velocities v_j of each
//! mass centre and angular velocities ω_j for unit rates, and from momenta p and h for the rates a. What lies inboard has lower numbers,
//! so that for k < j
//!
//! ```text
//! ∂v_j/∂q_k = ∂v_k/∂q_j = ω_k × v_j        ∂ω_j/∂q_k = ω_k × ω_j        ∂ω_k/∂q_j = 0
//! ```
//!
//! Axes of a ball turn with it: among its coordinates what holds for k < j holds both ways.

use super::inertial::{Carried, Inertial};
use super::lists::{set, unit};
use super::{Coordinates, MotionOf, PositionOf, RateOf, System, coordinates};
use crate::dense::{Matrix, Tangent};
use crate::element::{Element, RealOf};
use crate::ends::{Root, Tip};
use crate::mirror::{Position, Rate, Retraction};
use crate::observe::each_body;
use crate::scalar::{Real, Scalar};
use alloc::vec;
use alloc::vec::Vec;
use num_traits::{One, Zero};

/// How far coordinates are displaced to see whether displacements commute (rad, m), and by how much those of a ball do not.
const DISPLACED: f64 = 0.125;
const APART: f64 = 1e-3;

impl<S: Inertial, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// The symmetric part of (∂M/∂q) a at a motion at rest with these accelerations, and the inertia that coordinates have one by one
    /// (those of a ball their sum), in the directions that closures leave open; `root` is that of the mass matrix there.
    pub(super) fn inertial_forces(
        &self,
        still: &MotionOf<S, R, C, P>,
        tangent: &Tangent<RealOf<S>>,
        root: &Matrix<RealOf<S>>,
    ) -> [Matrix<RealOf<S>>; 2] {
        let n = tangent.freedoms();
        let half = RealOf::<S>::of(0.5);
        let forces = self.carried(still, &still.acceleration);
        let [mut twists, mut levers] = [(); 2].map(|()| Matrix::zeros(6 * forces.len(), n));
        let mut inertia = vec![RealOf::<S>::zero(); n];
        let mut rate = still.rate.clone();
        for (j, own) in inertia.iter_mut().enumerate() {
            set(&mut rate, unit(n, j));
            let (mut twist, mut lever) = (vec![], vec![]);
            for (body, force) in self.carried(still, &rate).iter().zip(&forces) {
                *own += body.momentum.dot(&body.velocity) + body.angular.dot(&body.spin);
                twist.extend(body.velocity.iter().chain(&body.spin));
                lever.extend(force.momentum.cross(&body.spin).iter());
                lever.extend(force.angular.cross(&body.spin).iter().map(|x| *x * half));
            }
            *own = self.reflected(still, &rate).iter().fold(*own, |sum, x| sum + *x * *x);
            twists.set_column(j, &twist);
            levers.set_column(j, &lever);
        }
        let balls = self.balls(still, n);
        let [mut change, mut metric] = [levers.transposed().times(&twists), Matrix::zeros(n, n)];
        for j in 0..n {
            for k in 0..j {
                let [inboard, outboard] = [change.get(k, j), change.get(j, k)];
                let both = if balls[j] == balls[k] { (inboard + outboard) * half } else { inboard };
                change.put(k, j, both);
                change.put(j, k, both);
            }
            let of_ball = |sum, (ball, own): (&usize, &RealOf<S>)| if *ball == balls[j] { sum + *own } else { sum };
            metric.put(j, j, balls.iter().zip(&inertia).fold(RealOf::<S>::zero(), of_ball));
        }
        let momenta = root.transposed().times(&tangent.restrict(&self.momenta(still, n)));
        [tangent.reduce(&change).plus(RealOf::<S>::one(), &momenta), tangent.reduce(&metric)]
    }

    /// How weighted velocities for the rates a change with each coordinate, by differences: where those are small, so is what is
    /// wrong with these.
    fn momenta(&self, still: &MotionOf<S, R, C, P>, n: usize) -> Matrix<RealOf<S>> {
        let step = RealOf::<S>::EPSILON.powf(RealOf::<S>::of(1.0 / 3.0));
        let (mut direction, mut there) = (still.rate.clone(), still.clone());
        let mut changes = Matrix::zeros(0, n);
        for j in 0..n {
            set(&mut direction, unit(n, j));
            let mut at = |reach| {
                there.position.drift_0(&still.position, (reach, &direction));
                there.position.set_clocks(still.time);
                self.weighted(&there, &still.acceleration)
            };
            let (ahead, back) = (at(step), at(-step));
            let column: Vec<_> = ahead.iter().zip(&back).map(|(a, b)| (*a - *b) / (step + step)).collect();
            if j == 0 {
                changes = Matrix::zeros(column.len(), n);
            }
            changes.set_column(j, &column);
        }
        changes
    }

    /// For each coordinate the first of the ball that it belongs to (itself, if to none): turns about two axes do not commute.
    fn balls(&self, still: &MotionOf<S, R, C, P>, n: usize) -> Vec<usize> {
        let mut first: Vec<usize> = (0..n).collect();
        if !PositionOf::<S, R, C>::CURVED {
            return first;
        }
        let mut direction = still.rate.clone();
        let mut moved = |by: [usize; 2]| {
            let mut place = still.position.clone();
            for j in by {
                set(&mut direction, unit::<S::Scalar>(n, j).map(|x| x.scale(RealOf::<S>::of(DISPLACED))));
                place.displace(&direction);
            }
            place
        };
        for j in 1..n {
            let (one, other) = (moved([j - 1, j]), moved([j, j - 1]));
            let (mut apart, mut most) = (still.rate.clone(), RealOf::<S>::zero());
            one.apart(&other, &mut apart);
            apart.visit(&mut |x| most = most.max(x.real().abs()));
            if most > RealOf::<S>::of(APART) {
                first[j] = first[j - 1];
            }
        }
        first
    }

    /// What bodies carry where the coordinates of a motion at rest move at a rate, less what the ground does.
    fn carried(&self, still: &MotionOf<S, R, C, P>, rate: &RateOf<S, R, C>) -> Vec<Carried<RealOf<S>>> {
        let mut all = vec![];
        let moving = Coordinates { rate, ..coordinates(still) };
        each_body(self.elements(), self.ground(still.time), moving, |body| all.push(S::carried(body)));
        let mut bodies = all.iter_mut();
        each_body(self.elements(), self.ground(still.time), coordinates(still), |body| {
            if let Some(with) = bodies.next() {
                with.less(S::carried(body));
            }
        });
        all
    }
}
