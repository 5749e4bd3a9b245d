//! Mass, first moment and second moments of a body: added, moved, turned, and what to do where no body has them.

use crate::algebra::{
    IDENTITY, Matrix, Vector, ZERO, add, apply, dot, eigen, matrix, plus, scale, subtract, trace, transpose, turned,
};
use crate::model::Pose;

/// The largest number (SI) of a body or place that a robot may have: masses times squares of lengths of all bodies are to be finite.
pub(crate) const LARGEST: f64 = 1e60;

/// Mass (kg), mass centre (m) and inertia tensor about it (kg·m²).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertia {
    /// Mass (kg).
    pub mass: f64,
    /// Mass centre (m).
    pub centre: Vector,
    /// Inertia tensor about the mass centre (kg·m²).
    pub tensor: Matrix,
}

/// m (|r|² 1 − r rᵀ): what a point mass has about a point that lies −r away.
fn of_point(mass: f64, r: Vector) -> Matrix {
    matrix(|i, k| mass * (if i == k { dot(r, r) } else { 0.0 } - r[i] * r[k]))
}

/// The least second moment ∫ (x·n)² dm, relative to the tensor's trace, below which a body is impossible by more than rounding
/// of six digits, which is what files have.
pub(crate) const ROUNDED: f64 = -1e-6;

impl Inertia {
    pub(crate) const NONE: Self = Self { mass: 0.0, centre: ZERO, tensor: [ZERO; 3] };

    /// The inertia as seen from where its axes stand at a pose.
    pub(crate) fn seen_from(&self, pose: &Pose) -> Self {
        let Self { mass, centre, tensor } = self;
        let centre = if *mass == 0.0 { ZERO } else { add(pose.place, apply(&pose.turn, *centre)) };
        Self { mass: *mass, centre, tensor: turned(&pose.turn, tensor) }
    }

    /// The two as one body, in the same axes.
    pub(crate) fn with(&self, other: &Self) -> Self {
        let mass = self.mass + other.mass;
        let tensor = plus(&self.tensor, &other.tensor);
        match (self.mass == 0.0, other.mass == 0.0) {
            (_, true) => return Self { tensor, ..*self },
            (true, _) => return Self { tensor, ..*other },
            _ => (),
        }
        let (own, others) = (self.mass / mass, other.mass / mass);
        let centre = add(scale(own, self.centre), scale(others, other.centre));
        // Two points on a line, by their reduced mass.
        let apart = of_point(self.mass * others, subtract(self.centre, other.centre));
        Self { mass, centre, tensor: plus(&tensor, &apart) }
    }

    /// Whether sums of products of these numbers are finite, as dynamics form them.
    pub(crate) fn can_be_added(&self) -> bool {
        [self.mass].iter().chain(&self.centre).chain(self.tensor.iter().flatten()).all(|x| x.abs() <= LARGEST)
    }

    /// Second moments ∫ x xᵀ dm = ½ tr J 1 − J about the mass centre, by principal directions. None of a body is negative; then
    /// no moment is, and none exceeds the sum of the two others.
    fn second_moments(&self) -> (Vector, Matrix) {
        let half = 0.5 * trace(&self.tensor);
        eigen(&matrix(|i, k| half * IDENTITY[i][k] - self.tensor[i][k]))
    }

    /// The least second moment relative to the tensor's trace.
    pub(crate) fn deficit(&self) -> f64 {
        let size = self.tensor.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        let (moments, _) = self.second_moments();
        moments.into_iter().fold(f64::INFINITY, f64::min) / trace(&self.tensor).abs().max(size)
    }

    /// Whether `catena` takes it: second moments negative by no more than rounding of doubles.
    pub(crate) fn is_possible(&self) -> bool {
        let size = self.tensor.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        let (moments, _) = self.second_moments();
        moments.iter().all(|moment| *moment >= -4.0 * f64::EPSILON * size)
    }

    /// The nearest body (in second moments): negative ones become zero, the others and their directions stay.
    pub(crate) fn repaired(&self) -> Self {
        if self.is_possible() {
            return *self;
        }
        let (moments, directions) = self.second_moments();
        let moments = moments.map(|moment| moment.max(0.0));
        let diagonal = matrix(|i, k| if i == k { moments[i] } else { 0.0 });
        let second = turned(&directions, &diagonal);
        let sum = trace(&second);
        Self { tensor: matrix(|i, k| sum * IDENTITY[i][k] - second[i][k]), ..*self }
    }

    /// In axes whose columns, in the present ones, are those of a turn.
    pub(crate) fn in_axes(&self, turn: &Matrix) -> Self {
        self.seen_from(&Pose { place: ZERO, turn: transpose(turn) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::about;

    #[test]
    fn repair_takes_away_the_negative_moment_alone() {
        // Second moments 0.03, 0.02 and −0.01 along turned directions.
        let turn = about([0.6, 0.0, 0.8], 0.4);
        let second = turned(&turn, &[[0.03, 0.0, 0.0], [0.0, 0.02, 0.0], [0.0, 0.0, -0.01]]);
        let tensor = matrix(|i, k| 0.04 * IDENTITY[i][k] - second[i][k]);
        let body = Inertia { mass: 1.0, centre: ZERO, tensor };
        assert!((body.deficit() + 0.01 / 0.08).abs() < 1e-12);
        let repaired = body.repaired();
        assert!(repaired.is_possible());
        let right = turned(&turn, &[[0.02, 0.0, 0.0], [0.0, 0.03, 0.0], [0.0, 0.0, 0.05]]);
        for i in 0..9 {
            assert!((repaired.tensor[i / 3][i % 3] - right[i / 3][i % 3]).abs() < 1e-16);
        }
    }

    #[test]
    fn two_bodies_are_one() {
        let one = Inertia { mass: 2.0, centre: [0.1, 0.2, -0.3], tensor: IDENTITY };
        let other = Inertia { mass: 3.0, centre: [-0.5, 0.1, 0.4], tensor: IDENTITY };
        let about_origin = |body: &Inertia| plus(&body.tensor, &of_point(body.mass, body.centre));
        let (sum, both) = (plus(&about_origin(&one), &about_origin(&other)), about_origin(&one.with(&other)));
        for i in 0..9 {
            assert!((sum[i / 3][i % 3] - both[i / 3][i % 3]).abs() < 1e-15);
        }
    }
}
