//! Natural frequencies and modes of vibration of a scene about a position of rest, and complex modes about steady motions.
//!
//! ```
//! use catena::loading::Unloaded;
//! use catena::planar::*;
//! use core::f64::consts::FRAC_PI_2;
//!
//! let bob = PointMass::new(1.0, 1.0); // length (m), mass (kg)
//! let pendulum = System::new(Pinned::origin(), (bob, Pin, bob), Free)?.with_gravity(9.81);
//! let rest = pendulum.at_rest(&[-FRAC_PI_2; 2])?;
//! let modes = pendulum.modes(&rest, &Unloaded)?;
//! let expected = [2.0 - 2f64.sqrt(), 2.0 + 2f64.sqrt()].map(|square| (9.81 * square).sqrt());
//! for (found, expected) in modes.frequencies().zip(expected) {
//!     assert!((found - expected).abs() < 1e-12 * expected); // rad/s
//! }
//! # Ok::<(), catena::Error>(())
//! ```

mod carried;
mod complex;
mod derivatives;
mod eigen;
mod steady;

pub use complex::{ComplexMode, ComplexModes};

use crate::dense::{Matrix, Tangent};
use crate::element::{Element, Loading, RealOf};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mirror::Rate;
use crate::scalar::{Real, Scalar};
use crate::system::{Dynamics, GRAVITY, Inertial, MotionOf, Runs, StiffDynamics, System, differenced, numbers, step};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use num_traits::Zero;
use std::vec::Vec;

/// What rounding by ε leaves of a result.
struct Limits {
    /// A position of rest may be off by this much (rad, m), and a stiffness asymmetric by this much of its size.
    off: f64,
    /// Squared frequencies below this share of the largest are rounding. 1e-11 of `f64`.
    flat: f64,
    /// Accelerations (rad/s², m/s²) below this share of the largest squared frequency, and of what gravity makes, are rounding.
    pull: f64,
    /// Squared frequencies below this share of the same are rounding, too.
    noise: f64,
}

impl Limits {
    fn of<R: Real>() -> Self {
        let epsilon = R::EPSILON.as_f64();
        Self {
            off: differenced::<R>().as_f64(),
            flat: epsilon.powf(0.7),
            pull: 1e3 * epsilon,
            noise: ROUNDINGS * epsilon / step::<R>().as_f64(),
        }
    }
}

impl Limits {
    /// What rounding is measured by along a direction, by the root of the mass matrix and the largest squared frequency: a light coordinate takes more from
    /// that of the forces that heavy ones bear.
    fn share(&self, root: &DMatrix<f64>, along: &DVector<f64>, stiffest: f64) -> f64 {
        (root.amax() * along.amax()).powi(2).max(1.0) * stiffest.max(GRAVITY)
    }
}

/// Differences that disagree by more than this share, and by so many times what they leave, are of a force that has a kink.
const KINK: f64 = 0.1;
const FAR: f64 = 1e4;
/// So many roundings are left of what pulls.
const ROUNDINGS: f64 = 16.0;

/// Natural frequencies, ascending, and their modes.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes<T = f64> {
    modes: Vec<Mode<T>>,
}

/// A mode of vibration.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode<T = f64> {
    /// ω² (rad²/s²), and with the derivatives of the scene's numbers.
    square: f64,
    differentiated: T,
    shape: Vec<f64>,
}

impl<T: Scalar> Mode<T> {
    /// Angular frequency ω (rad/s). A negative number −κ stands for a mode that does not swing but departs as exp(κ t): rest is
    /// unstable. Where nothing drives back it is zero but for rounding.
    pub fn frequency(&self) -> f64 {
        self.square.abs().sqrt().copysign(self.square)
    }

    /// ω² (rad²/s²), negative for a mode that departs.
    pub fn square(&self) -> f64 {
        self.square
    }

    /// ω² (rad²/s²) with its first derivatives, in the scene's kind of number; parts of higher order are not those of ω². Of modes that have one
    /// frequency, which may part, they are those along the shapes given.
    ///
    /// ```
    /// use catena::loading::Unloaded;
    /// use catena::planar::*;
    /// use catena::scalar::{Jet, Scalar};
    /// let (length, gravity) = (Jet::<f64, 2>::seed(0.5, 0), Jet::seed(9.81, 1));
    /// let pendulum = System::new(Pinned::origin(), PointMass::new(length, Jet::of(1.0)), Free)?.with_gravity(gravity);
    /// let rest = pendulum.at_rest(&[Jet::of(-core::f64::consts::FRAC_PI_2)])?;
    /// let modes = pendulum.modes(&rest, &Unloaded)?;
    /// let square = modes.get(0).map_or(Jet::of(f64::NAN), |mode| mode.square_with_derivatives()); // g / l
    /// assert!((square.eps[0] + 9.81 / 0.25).abs() < 1e-9 && (square.eps[1] - 2.0).abs() < 1e-9);
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn square_with_derivatives(&self) -> T {
        self.differentiated
    }

    /// |ω| (rad/s) with its first derivatives, as [`square_with_derivatives`](Self::square_with_derivatives); they are no numbers where it is zero.
    pub fn frequency_with_derivatives(&self) -> T {
        self.differentiated.abs().sqrt()
    }

    /// Displacements of the joint coordinates (of a ball, turns in axes of its outboard body (rad)), in the order of
    /// [`with_rates`](System::with_rates), scaled to unit modal mass:
    /// as rates they have a kinetic energy of ½ J. The largest is positive.
    pub fn shape(&self) -> &[f64] {
        &self.shape
    }
}

impl<T: Scalar> Modes<T> {
    /// Number of modes: coordinates less independent conditions of closures and couplings.
    pub fn len(&self) -> usize {
        self.modes.len()
    }

    /// Whether nothing can move.
    pub fn is_empty(&self) -> bool {
        self.modes.is_empty()
    }

    /// Mode number `k`, counted from 0 at the lowest frequency.
    pub fn get(&self, k: usize) -> Option<&Mode<T>> {
        self.modes.get(k)
    }

    /// All modes, by ascending frequency.
    pub fn iter(&self) -> impl Iterator<Item = &Mode<T>> {
        self.modes.iter()
    }

    /// All angular frequencies, ascending (rad/s).
    pub fn frequencies(&self) -> impl Iterator<Item = f64> {
        self.modes.iter().map(Mode::frequency)
    }
}

impl<S: Inertial, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Natural frequencies and modes about a position of rest under gravity, springs and loads. Dampers do not enter ([`complex_modes`](Self::complex_modes) knows them), nor do the
    /// rates of `rest`; loads that depend on rates count as they are at none. Forces that hold a tip do their part: modes obey
    /// its closure, and the pull in a held chain makes it stiff.
    ///
    /// M q̈ = −K q in joint coordinates: M from the velocities of all bodies, K from sixteen sweeps for each coordinate
    /// (differences of eighth order, springs apart from the rest; where they reach beyond a kink, as of a rope that is taut by a millimetre, more of them, by
    /// smaller steps), and a dense symmetric eigenvalue problem. An error of ω² is
    /// some 1e-16 to 1e-15 of the largest ω² of the scene. Measured: ω of hanging chains of 10, 20 and 40 point masses to 5e-15,
    /// 5e-14 and 8e-14, of a catenary of 30 rods to 2e-12, and of a beam of 80 stiff rods, whose frequencies span four decades,
    /// to 1e-9.
    ///
    /// Over jets and dual numbers [`square_with_derivatives`](Mode::square_with_derivatives) has first derivatives, φᵀ (dK − ω² dM) φ of a mode with
    /// φᵀ M φ = 1, for as many sweeps again; the `rest` should have its own, as [`equilibrium`](Self::equilibrium) finds them. Over `f32` ω² errs by some 1e-6 of the
    /// largest: a rope of 100 rods has its lowest frequency to 0.1 %, and the lowest ones of 60 stiff rods as a beam drown, and may come out negative.
    ///
    /// # Errors
    /// [`Fault::NotAssembled`] where joints that follow others do not; [`Fault::NotAtRest`] with the distance to rest if it is more than 1e-6
    /// (over `f32` 2e-3), infinite for a scene that falls freely;
    /// [`Fault::NotConservative`] for loads without a potential; [`Fault::Unsupported`] where joints stick, where a force has a kink right at the rest, over lanes, and where the ground
    /// or a drive moves a body so that its velocity changes with the coordinates (a rotor: its modes are [complex](Self::complex_modes)), with the station of
    /// the body, or of what is held there, without one; those of a sweep.
    pub fn modes<L: Loading<S>>(&self, rest: &MotionOf<S, R, C, P>, loads: &L) -> Result<Modes<S::Scalar>, Error>
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        Self::rests_alone()?;
        let error = |fault| Error::new(fault).at_time(rest.time.as_f64());
        let mut workspace = self.workspace();
        let mut still = rest.clone();
        still.rate.replace(&mut |_| S::Scalar::zero());
        self.suited(&still, loads)?;
        self.accelerate(&mut still, loads, &mut workspace)?;
        let near = self.linearise(&still, loads, &mut self.stiff_workspace());
        let n = near.tangent.dimension();
        if n == 0 {
            return Ok(Modes { modes: Vec::new() });
        }
        if near.kink > RealOf::<S>::of(KINK).min(differenced::<RealOf<S>>() * RealOf::<S>::of(FAR)) {
            let what = "modes of vibration where a force has a kink, and another stiffness on each side";
            return Err(error(Fault::Unsupported { what }));
        }
        // Coordinates in which the mass matrix is one: y = R q with weighted velocities Q R.
        let root = dense(&near.root).qr().r();
        let singular = || error(Fault::SingularJoint);
        let stiffness = -similar(&root, &dense(&near.response)).ok_or_else(singular)?;
        let asymmetry = (&stiffness - stiffness.transpose()).amax() / stiffness.amax().max(f64::MIN_POSITIVE);
        if !stiffness.iter().all(|x| x.is_finite()) {
            return Err(self.diagnose(&still, loads, &mut workspace));
        }
        let symmetric = (&stiffness + stiffness.transpose()) * 0.5;
        let limit = 1000 * n;
        let eigen =
            SymmetricEigen::try_new(symmetric, f64::EPSILON, limit).ok_or_else(|| error(Fault::NonFiniteMotion))?;

        let pull: Vec<S::Scalar> = near.tangent.components(&numbers(&still.acceleration));
        let pull = &root * DVector::from_iterator(n, pull.iter().map(|x| x.real().as_f64()));
        let stiffest = eigen.eigenvalues.amax();
        let limits = Limits::of::<RealOf<S>>();
        let flat = limits.flat * stiffest;
        self.carried_alike(&still, &near, flat).map_err(|error| error.at_time(rest.time.as_f64()))?;
        let mut way = DVector::zeros(n);
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
        let mut modes = Vec::with_capacity(n);
        for k in order {
            let (square, vector) = (eigen.eigenvalues[k], eigen.eigenvectors.column(k));
            let along = root.solve_upper_triangular(&vector).ok_or_else(singular)?;
            let share = limits.share(&root, &along, stiffest);
            if square.abs() > flat.max(limits.noise * share) {
                way.axpy(vector.dot(&pull) / square, &vector, 1.0);
            } else if (vector.dot(&pull) * along.amax()).abs() > limits.pull * share {
                return Err(error(Fault::NotAtRest { distance: f64::INFINITY }));
            }
            let differentiated = S::Scalar::constant(Real::of(square));
            modes.push(Mode { square, differentiated, shape: shape::<S::Scalar>(&near.tangent, along.as_slice()) });
        }
        let way = root.solve_upper_triangular(&way).ok_or_else(singular)?;
        let distance = way.amax();
        if distance > limits.off {
            return Err(error(Fault::NotAtRest { distance }));
        }
        // Forces without a potential only then: away from rest the inertia forces are asymmetric too.
        if asymmetry > limits.off {
            return Err(error(Fault::NotConservative { asymmetry }));
        }
        if size_of::<S::Scalar>() > size_of::<RealOf<S>>() {
            let shapes: Vec<&[f64]> = modes.iter().map(|mode: &Mode<_>| mode.shape()).collect();
            let squares = self.squares(&still, &shapes, near.tangent.is_redundant(), loads);
            let squares = squares.map_err(|error| error.at_time(rest.time.as_f64()))?;
            modes.iter_mut().zip(squares).for_each(|(mode, square)| {
                mode.differentiated += square - S::Scalar::constant(square.real());
            });
        }
        Ok(Modes { modes })
    }
}

/// A matrix for nalgebra.
fn dense<R: Real>(matrix: &Matrix<R>) -> DMatrix<f64> {
    let entries: Vec<f64> = matrix.rows().flatten().map(|x| x.as_f64()).collect();
    DMatrix::from_row_slice(entries.len() / matrix.columns(), matrix.columns(), &entries)
}

/// T A T⁻¹ of an upper triangle T, if that has an inverse.
fn similar(triangle: &DMatrix<f64>, matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let image = (triangle * matrix).transpose();
    Some(triangle.tr_solve_upper_triangular(&image)?.transpose())
}

/// The coordinates of a shape given along tangent directions, its largest positive.
fn shape<T: Scalar>(tangent: &Tangent<T::Real>, along: &[f64]) -> Vec<f64> {
    let along: Vec<T::Real> = along.iter().map(|x| T::Real::of(*x)).collect();
    let mut shape: Vec<f64> = tangent.vector(&along).iter().map(|x| x.as_f64()).collect();
    let largest = shape.iter().fold(0.0_f64, |most, x| if x.abs() > most.abs() { *x } else { most });
    if largest < 0.0 {
        shape.iter_mut().for_each(|x| *x = -*x);
    }
    shape
}
