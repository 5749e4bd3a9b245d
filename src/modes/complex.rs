//! Complex modes: how a scene vibrates about a steady motion, damped, driven or turned as it may be.

use super::eigen::{Pair, pairs};
use super::steady::{Slopes, Steady};
use super::{FAR, KINK, similar};
use crate::dense::Tangent;
use crate::element::{Element, Loading, RealOf};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::{Inertial, MotionOf, Runs, StiffDynamics, System, differenced};
use nalgebra::{Complex, DMatrix, DVector};
use num_traits::Zero;
use std::vec::Vec;

/// Complex modes, by ascending frequency; those that do not swing first, by ascending growth.
#[derive(Clone, Debug, PartialEq)]
pub struct ComplexModes<T = f64> {
    modes: Vec<ComplexMode<T>>,
}

/// One way in which a scene departs from a steady motion or comes back to it: Re (a e^λt) of all coordinates, with λ = σ + iω.
#[derive(Clone, Debug, PartialEq)]
pub struct ComplexMode<T = f64> {
    /// σ (1/s) and ω (rad/s).
    eigenvalue: [f64; 2],
    differentiated: [T; 2],
    shape: Vec<[f64; 2]>,
}

impl<T: Scalar> ComplexMode<T> {
    /// Growth σ (1/s): negative for what decays.
    pub fn growth(&self) -> f64 {
        self.eigenvalue[0]
    }

    /// Angular frequency ω (rad/s) of the damped motion, not negative; zero for what does not swing.
    pub fn frequency(&self) -> f64 {
        self.eigenvalue[1]
    }

    /// Damping ratio −σ / |λ|: between 0 and 1 for a vibration that decays, ±1 for what does not swing.
    pub fn damping_ratio(&self) -> f64 {
        let [growth, frequency] = self.eigenvalue;
        let size = growth.hypot(frequency);
        if size.is_zero() { 0.0 } else { -growth / size }
    }

    /// σ (1/s) and ω (rad/s) with their first derivatives, in the scene's kind of number; parts of higher order are not theirs. Of modes with one
    /// eigenvalue, which may part, they are those along the shapes given, and no numbers where there are fewer shapes than modes.
    pub fn with_derivatives(&self) -> [T; 2] {
        self.differentiated
    }

    /// Real and imaginary part of the displacement of each coordinate (of a ball, turns in axes of its outboard body (rad)), in the order of
    /// [`with_rates`](System::with_rates): (x cos ωt − y sin ωt) e^σt for [x, y]. The largest is 1.
    pub fn shape(&self) -> &[[f64; 2]] {
        &self.shape
    }
}

impl<T: Scalar> ComplexModes<T> {
    /// Number of modes, one for each pair of conjugate eigenvalues, and one for each that is real.
    pub fn len(&self) -> usize {
        self.modes.len()
    }

    /// Whether nothing can move.
    pub fn is_empty(&self) -> bool {
        self.modes.is_empty()
    }

    /// Mode number `k`, counted from 0.
    pub fn get(&self, k: usize) -> Option<&ComplexMode<T>> {
        self.modes.get(k)
    }

    /// All modes.
    pub fn iter(&self) -> impl Iterator<Item = &ComplexMode<T>> {
        self.modes.iter()
    }

    /// The largest growth (1/s): the motion is unstable where it is positive beyond rounding, which is some 1e-7 of the largest |λ| where
    /// a coordinate moves freely.
    pub fn largest_growth(&self) -> f64 {
        self.modes.iter().fold(f64::NEG_INFINITY, |most, mode| most.max(mode.growth()))
    }
}

impl<S: Inertial, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Complex modes about a steady motion, in which no coordinate accelerates: at rest, or at constant rates, or where the ground and drives move
    /// on at theirs. Springs and dampers, gravity and loads as they depend on positions and rates, gyroscopic and centrifugal forces count:
    /// for damping ratios, the whirl of rotors, blades on a hub that a drive turns, and where a motion becomes unstable (flutter).
    ///
    /// ```
    /// use catena::loading::Unloaded;
    /// use catena::planar::*;
    /// // A blade in a plane across a hub of 0.2 m that turns at 30 rad/s: a pendulum under centrifugal forces.
    /// let (hub, blade) = (Rod::uniform(0.2, 1.0), Rod::uniform(1.0, 2.0));
    /// let turn = Driven::new(Revolute::smooth(), |t: f64| [30.0 * t, 30.0, 0.0]);
    /// let lag = ElasticHinge::rotary(100.0).damped(0.4);
    /// let rotor = System::new(Clamped::origin(), (turn, hub, lag, blade), Free)?;
    /// let modes = rotor.complex_modes(&rotor.motion(), &Unloaded)?;
    /// let mode = modes.get(0).ok_or("no mode")?;
    /// let inertia = 2.0 / 3.0; // about the hinge
    /// let square: f64 = 100.0 / inertia + 1.5 * 0.2 * 30.0 * 30.0; // k/J + Ω² e S/J
    /// let growth = -0.5 * 0.4 / inertia;
    /// assert!((mode.growth() - growth).abs() < 1e-9);
    /// assert!((mode.frequency() - (square - growth * growth).sqrt()).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// For a motion x of all coordinates and rates, x′ = A x by 32 sweeps or more for each (differences of eighth order, springs apart from the rest),
    /// once more a while later, and the eigenvalues of A by QR, each led on by inverse iteration. What swings undamped at rest swings here
    /// with the frequencies of [`modes`](Self::modes), which are more precise and have real shapes.
    /// A drive turns joints that are measured against the body inboard of them ([`Revolute`](crate::planar::Revolute)), with the rates of others, as of pins,
    /// which are absolute, given in the motion. [`equilibrium`](Self::equilibrium) finds where what is driven is steady.
    ///
    /// # Errors
    /// [`Fault::NotSteady`] where coordinates accelerate, then or a while later: a ball that precesses does, in the axes of its body, and three
    /// hinges in its place do not; [`Fault::Unsupported`] where the scene is another one a while later, as a rotor with two blades on
    /// supports that are not alike, what spins about an axis of inertia of its own and is coupled to a root that floats, whose coordinates do not turn with it,
    /// or under loads over time, where a force has a kink that makes accelerations others by a fifth, where joints stick or have hard stops, and over lanes;
    /// [`Fault::NotClosed`] and others of [`assembled`](Self::assembled) where closures do not let it go on; those of a sweep.
    pub fn complex_modes<L: Loading<S>>(
        &self,
        steady: &MotionOf<S, R, C, P>,
        loads: &L,
    ) -> Result<ComplexModes<S::Scalar>, Error>
    where
        Self: Runs<L, S, R, C, P> + StiffDynamics<L>,
    {
        Self::rests_alone()?;
        let error = |fault| Error::new(fault).at_time(steady.time.as_f64());
        self.suited(steady, loads)?;
        let Steady { tangent, slopes, root } = self.steadily(steady, loads)?;
        if tangent.dimension() == 0 {
            return Ok(ComplexModes { modes: Vec::new() });
        }
        if slopes.kink > RealOf::<S>::of(KINK).min(differenced::<RealOf<S>>() * RealOf::<S>::of(FAR)) {
            let what = "modes of vibration where a force has a kink, and another stiffness on each side";
            return Err(error(Fault::Unsupported { what }));
        }
        let weighted = Weighted::of(&root, &slopes).ok_or_else(|| error(Fault::SingularJoint))?;
        let what = "complex modes whose eigenvalues QR does not find";
        let pairs = pairs(&weighted.matrix).ok_or_else(|| error(Fault::Unsupported { what }))?;
        Ok(ComplexModes { modes: pairs.iter().map(|pair| weighted.mode(&tangent, &slopes, pair)).collect() })
    }
}

/// The matrix A over coordinates in which mass is one, and positions are as large as their rates.
struct Weighted {
    matrix: DMatrix<f64>,
    /// What makes of displacements and rates these coordinates, an upper triangle.
    weights: DMatrix<f64>,
}

impl Weighted {
    /// Over weights made of the root of the mass matrix, an upper triangle, if that is not singular.
    fn of<T: Scalar>(root: &DMatrix<f64>, slopes: &Slopes<T>) -> Option<Self> {
        let n = root.nrows();
        let matrix = DMatrix::from_fn(2 * n, 2 * n, |i, j| slopes.columns[j][i].real().as_f64());
        let alike = Self::weighed(root, 1.0, &matrix)?;
        let stiffest = alike.matrix.view((n, 0), (n, n)).amax();
        if stiffest > 0.0 { Self::weighed(root, stiffest.sqrt(), &matrix) } else { Some(alike) }
    }

    /// Over positions that count so many times as much as their rates.
    fn weighed(root: &DMatrix<f64>, times: f64, matrix: &DMatrix<f64>) -> Option<Self> {
        let n = root.nrows();
        let mut weights = DMatrix::zeros(2 * n, 2 * n);
        weights.view_mut((0, 0), (n, n)).copy_from(&(root * times));
        weights.view_mut((n, n), (n, n)).copy_from(root);
        let matrix = similar(&weights, matrix).filter(|matrix| matrix.iter().all(|x| x.is_finite()))?;
        Some(Self { matrix, weights })
    }

    fn mode<T: Scalar>(&self, tangent: &Tangent<T::Real>, slopes: &Slopes<T>, pair: &Pair) -> ComplexMode<T> {
        let n = tangent.dimension();
        let part = |of: fn(&Complex<f64>) -> f64| {
            let part: DVector<f64> = pair.right.map(|x| of(&x));
            self.weights.solve_upper_triangular(&part).unwrap_or(part)
        };
        let (real, imaginary) = (part(|x| x.re), part(|x| x.im));
        let [real_shape, imaginary_shape] = [&real, &imaginary].map(|part| {
            let along: Vec<T::Real> = part.iter().take(n).map(|x| Real::of(*x)).collect();
            tangent.vector(&along)
        });
        let shape = real_shape.iter().zip(&imaginary_shape).map(|(x, y)| Complex::new(x.as_f64(), y.as_f64()));
        let shape: Vec<Complex<f64>> = shape.collect();
        let largest = shape
            .iter()
            .fold(Complex::from(0.0), |most: Complex<f64>, x| if x.norm() > most.norm() { *x } else { most });
        let eigenvalue = [pair.value.re, pair.value.im];
        let mut differentiated = eigenvalue.map(|x| T::constant(Real::of(x)));
        if size_of::<T>() > size_of::<T::Real>() {
            let right = real.zip_map(&imaginary, Complex::new);
            let left = self.weights.transpose().map(Complex::from) * &pair.left;
            let derivatives = slopes.derivatives(&left, &right);
            differentiated.iter_mut().zip(derivatives).for_each(|(sum, more)| *sum += more);
        }
        ComplexMode {
            eigenvalue,
            differentiated,
            shape: shape.iter().map(|x| x / largest).map(|x| [x.re, x.im]).collect(),
        }
    }
}

impl<T: Scalar> Slopes<T> {
    /// uᵀ (dA) x, real and imaginary part, of which nothing but derivatives is left.
    fn derivatives(&self, left: &DVector<Complex<f64>>, right: &DVector<Complex<f64>>) -> [T; 2] {
        let mut sums = [T::zero(); 2];
        for (column, right) in self.columns.iter().zip(right.iter()) {
            for (entry, left) in column.iter().zip(left.iter()) {
                let (own, weight) = (*entry - T::constant(entry.real()), left * right);
                sums[0] += own.scale(Real::of(weight.re));
                sums[1] += own.scale(Real::of(weight.im));
            }
        }
        sums
    }
}
