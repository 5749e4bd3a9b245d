//! A second opinion on chains too long for a dense system: Newton and Euler for each body, and for the forces of the joints the
//! banded equations A M⁻¹ Aᵀ l = b − A M⁻¹ f, by Cholesky and one refinement.

use super::chains::{DRIFT, End, Link};
use nalgebra::DMatrix;

const GRAVITY: [f64; 3] = [0.0, -9.81, 0.0];
/// Rows further apart than this share no body.
const BAND: usize = 4;

/// A demand on the accelerations (x and y of the mass centre, angle) of one or two bodies.
struct Row {
    parts: Vec<(usize, [f64; 3])>,
    demand: f64,
}

/// The equations of a chain and their factors.
pub struct Banded {
    masses: Vec<[f64; 3]>,
    rows: Vec<Row>,
    /// Number of rows at the tip, which are the last ones.
    held: usize,
    /// Lower triangle, [row][row − column].
    factor: Vec<[f64; BAND + 1]>,
}

/// The acceleration of the end of a body along a direction: its factors, and its part without unknowns.
fn end(link: &Link, side: f64, direction: [f64; 2]) -> ([f64; 3], f64) {
    let half = 0.5 * side * link.length;
    let [x, y] = [half * link.angle.cos(), half * link.angle.sin()];
    let bias = -link.rate * link.rate * (direction[0] * x + direction[1] * y);
    ([direction[0], direction[1], direction[1] * x - direction[0] * y], bias)
}

/// Rows of a body held by the ground.
fn hold(body: usize, link: &Link, side: f64, held: End, ground: [f64; 2]) -> Vec<Row> {
    let place = |direction: [f64; 2]| {
        let (factors, bias) = end(link, side, direction);
        let demand = direction[0] * ground[0] + direction[1] * ground[1] - bias;
        Row { parts: vec![(body, factors)], demand }
    };
    let angle = || Row { parts: vec![(body, [0.0, 0.0, 1.0])], demand: 0.0 };
    match held {
        End::Pinned => vec![place([1.0, 0.0]), place([0.0, 1.0])],
        End::Clamped => vec![place([1.0, 0.0]), place([0.0, 1.0]), angle()],
        End::Guided(line) => {
            let (sine, cosine) = (link.angle + line).sin_cos();
            vec![place([-sine, cosine]), angle()]
        }
    }
}

impl Banded {
    pub fn new(links: &[Link], [root, tip]: [End; 2]) -> Self {
        let mut rows = hold(0, &links[0], -1.0, root, [0.0; 2]);
        for (k, pair) in links.windows(2).enumerate() {
            for direction in [[1.0, 0.0], [0.0, 1.0]] {
                let ((inner, before), (outer, after)) = (end(&pair[0], 1.0, direction), end(&pair[1], -1.0, direction));
                rows.push(Row { parts: vec![(k, inner.map(|x| -x)), (k + 1, outer)], demand: before - after });
            }
        }
        let last = links.len() - 1;
        let at_tip = hold(last, &links[last], 1.0, tip, DRIFT[1]);
        let held = at_tip.len();
        rows.extend(at_tip);
        let mass = |l: &Link| [l.mass, l.mass, l.inertia()];
        let mut this = Self { masses: links.iter().map(mass).collect(), rows, held, factor: vec![] };
        this.factorise();
        this
    }

    fn factorise(&mut self) {
        let mut factor: Vec<[f64; BAND + 1]> = vec![];
        for (i, row) in self.rows.iter().enumerate() {
            factor.push([0.0; BAND + 1]);
            for back in (0..=BAND.min(i)).rev() {
                let j = i - back;
                let mut entry = 0.0;
                for (body, a) in &row.parts {
                    for (_, b) in self.rows[j].parts.iter().filter(|(other, _)| other == body) {
                        entry += (0..3).map(|c| a[c] * b[c] / self.masses[*body][c]).sum::<f64>();
                    }
                }
                for k in i.saturating_sub(BAND)..j {
                    if j - k <= BAND {
                        entry -= factor[i][i - k] * factor[j][j - k];
                    }
                }
                factor[i][back] = if back == 0 { entry.sqrt() } else { entry / factor[j][0] };
            }
        }
        self.factor = factor;
    }

    /// The solution of A M⁻¹ Aᵀ x = right.
    fn solve(&self, mut right: Vec<f64>) -> Vec<f64> {
        let (n, factor) = (right.len(), &self.factor);
        for i in 0..n {
            for j in i.saturating_sub(BAND)..i {
                right[i] -= factor[i][i - j] * right[j];
            }
            right[i] /= factor[i][0];
        }
        for i in (0..n).rev() {
            for j in i + 1..n.min(i + BAND + 1) {
                right[i] -= factor[j][j - i] * right[j];
            }
            right[i] /= factor[i][0];
        }
        right
    }

    /// What the accelerations under gravity and joint forces leave of the demands.
    fn missing(&self, forces: &[f64]) -> Vec<f64> {
        let accelerations = self.accelerations(forces);
        let of = |(body, a): &(usize, [f64; 3])| (0..3).map(|c| a[c] * accelerations[*body][c]).sum::<f64>();
        self.rows.iter().map(|row| row.demand - row.parts.iter().map(of).sum::<f64>()).collect()
    }

    fn accelerations(&self, forces: &[f64]) -> Vec<[f64; 3]> {
        let mut accelerations = vec![GRAVITY; self.masses.len()];
        for (row, force) in self.rows.iter().zip(forces) {
            for (body, a) in &row.parts {
                (0..3).for_each(|c| accelerations[*body][c] += a[c] * force / self.masses[*body][c]);
            }
        }
        accelerations
    }

    /// Number of forces of the ground on the tip.
    pub fn held(&self) -> usize {
        self.held
    }

    /// The forces of all joints on their outboard sides, those of the ground on the tip last, and the accelerations of all bodies (x and y of the mass centre, angle).
    pub fn answer(&self) -> (Vec<f64>, Vec<[f64; 3]>) {
        let first = self.solve(self.missing(&vec![0.0; self.rows.len()]));
        let correction = self.solve(self.missing(&first));
        let forces: Vec<f64> = first.iter().zip(correction).map(|(x, y)| x + y).collect();
        let accelerations = self.accelerations(&forces);
        (forces, accelerations)
    }

    /// The condition of Λ, scaled to a unit diagonal: the rows and columns of the tip in the inverse of A M⁻¹ Aᵀ are Λ⁻¹.
    pub fn condition(&self) -> f64 {
        let n = self.rows.len();
        let unit = |j: usize| (0..n).map(|i| if i + self.held == n + j { 1.0 } else { 0.0 }).collect();
        let columns: Vec<Vec<f64>> = (0..self.held).map(|j| self.solve(unit(j))).collect();
        let inverse = DMatrix::from_fn(self.held, self.held, |i, j| columns[j][n - self.held + i]);
        let compliance = inverse.try_inverse().expect("independent closures");
        let scale = compliance.diagonal().map(|x| x.sqrt().recip());
        let scaled = DMatrix::from_fn(self.held, self.held, |i, j| scale[i] * compliance[(i, j)] * scale[j]);
        let values = scaled.symmetric_eigenvalues();
        values.max() / values.min()
    }
}
