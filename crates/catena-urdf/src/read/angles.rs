//! Angles of a description as turns, right angles snapped: R = Rz(yaw) Ry(pitch) Rx(roll).

use super::Reader;
use super::element::Element;
use crate::algebra::{Matrix, Vector, times, unit};
use crate::error::{Error, Fault};
use crate::model::Pose;
use crate::note::Remark;
use std::f64::consts::FRAC_PI_2;

/// How right angles are read.
pub struct Angles {
    /// Angles that differ by this from a right one are right (rad).
    pub tolerance: f64,
}

impl Angles {
    /// Sine and cosine of an angle, and by how much it was moved. Right angles as doubles are right angles: their cosine
    /// is 0, not 6e-17.
    fn sine_cosine(&self, angle: f64) -> (f64, f64, f64) {
        let quarters = (angle / FRAC_PI_2).round();
        let moved = quarters * FRAC_PI_2 - angle;
        let rounding = 2.0 * f64::EPSILON * angle.abs();
        if moved.abs() > self.tolerance.max(rounding) {
            return (angle.sin(), angle.cos(), 0.0);
        }
        let (sine, cosine) = match quarters.rem_euclid(4.0) as u8 {
            0 => (0.0, 1.0),
            1 => (1.0, 0.0),
            2 => (0.0, -1.0),
            _ => (-1.0, 0.0),
        };
        (sine, cosine, if moved.abs() > rounding { moved } else { 0.0 })
    }

    /// The turn, and the largest angle moved.
    pub fn turn(&self, [roll, pitch, yaw]: Vector) -> (Matrix, f64) {
        let [(sr, cr, a), (sp, cp, b), (sy, cy, c)] = [roll, pitch, yaw].map(|angle| self.sine_cosine(angle));
        let x = [[1.0, 0.0, 0.0], [0.0, cr, -sr], [0.0, sr, cr]];
        let y = [[cp, 0.0, sp], [0.0, 1.0, 0.0], [-sp, 0.0, cp]];
        let z = [[cy, -sy, 0.0], [sy, cy, 0.0], [0.0, 0.0, 1.0]];
        (times(&z, &times(&y, &x)), a.abs().max(b.abs()).max(c.abs()))
    }

    /// The coordinate axis that a unit vector is within tolerance of, else the vector; and by how much it was moved.
    fn axis(&self, axis: Vector) -> (Vector, f64) {
        for k in 0..3 {
            let aside = axis[(k + 1) % 3].hypot(axis[(k + 2) % 3]);
            if aside <= self.tolerance.max(f64::EPSILON) {
                let mut along = [0.0; 3];
                along[k] = axis[k].signum();
                return (along, if aside > f64::EPSILON { aside } else { 0.0 });
            }
        }
        (axis, 0.0)
    }
}

impl Reader<'_> {
    /// The place and turn of `<origin>` in an element; where there is none, the identity.
    pub fn origin(&mut self, of: Element) -> Result<Pose, Error> {
        let Some(origin) = of.child("origin")? else { return Ok(Pose::IDENTITY) };
        origin.leaves_out_all_but(&[], &["xyz", "rpy"], self.notes);
        let place = origin.vector("xyz")?.unwrap_or_default();
        let (turn, moved) = self.angles.turn(origin.vector("rpy")?.unwrap_or_default());
        if moved > 0.0 {
            let of = format!("<origin> of {}", of.title());
            self.notes.add(origin.line(), Remark::Snapped { of, by: moved });
        }
        Ok(Pose { place, turn })
    }

    /// The unit vector of `<axis>` in a joint; where there is none, x, as URDF says.
    pub fn axis(&mut self, of: Element, name: &str) -> Result<Vector, Error> {
        let Some(axis) = of.child("axis")? else { return Ok([1.0, 0.0, 0.0]) };
        axis.leaves_out_all_but(&[], &["xyz"], self.notes);
        let vector = axis.vector("xyz")?.unwrap_or([1.0, 0.0, 0.0]);
        let unit = unit(vector).ok_or_else(|| axis.fail(Fault::ZeroAxis { joint: name.to_owned() }))?;
        let (snapped, moved) = self.angles.axis(unit);
        if moved > 0.0 {
            self.notes.add(axis.line(), Remark::Snapped { of: format!("<axis> of {}", of.title()), by: moved });
        }
        Ok(snapped)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_angles_as_doubles_are_exact() {
        let (turn, moved) = Angles { tolerance: 0.0 }.turn([FRAC_PI_2, -FRAC_PI_2, 2.0 * FRAC_PI_2]);
        assert_eq!(moved, 0.0);
        assert!(turn.iter().flatten().all(|x| [0.0, 1.0, -1.0].contains(x)), "{turn:?}");
    }

    #[test]
    fn what_is_near_a_right_angle_stays_unless_told() {
        let near = FRAC_PI_2 + 4e-6;
        let (turn, moved) = Angles { tolerance: 0.0 }.turn([near, 0.0, 0.0]);
        assert_eq!((moved, turn[1][1]), (0.0, near.cos()));
        let (turn, moved) = Angles { tolerance: 1e-5 }.turn([near, 0.0, 0.3]);
        assert!((moved - 4e-6).abs() < 1e-15);
        assert_eq!((turn[2][1], turn[2][2]), (1.0, 0.0));
    }
}
