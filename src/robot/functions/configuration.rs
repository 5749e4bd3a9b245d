//! Configurations: what leads from one to another, where that leads, and one at random.

use super::{FixedBase, S, Tasks, checked, finite};
use crate::element::Element;
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mechanics::spatial::body_axes::Place;
use crate::mechanics::spatial::{Free, Rotation};
use crate::relation::spatial::algebra::vector;
use crate::scalar::{Elementary, Real, Scalar};
use crate::system::System;
use crate::walks::count::station_of_coordinate;
use core::f64::consts::{PI, TAU};
use nalgebra::Vector3;

/// A number between two limits, by a share of their distance.
fn between([lower, upper]: [f64; 2], share: f64) -> f64 {
    // Not lower + share · (upper − lower), which overflows where limits are as large as numbers.
    (lower * (1.0 - share) + upper * share).max(lower).min(upper)
}

/// Refuses what is no number of a generator of random numbers.
fn shares(list: &[f64]) -> Result<(), Error> {
    let Some(&value) = list.iter().find(|share| !(0.0..1.0).contains(*share)) else { return Ok(()) };
    let (parameter, outside) = ("random number", "configurations lie beyond limits");
    Err(Error::new(Fault::OutOfRange { parameter, value, least: 0.0, most: 1.0, outside }))
}

/// Limits of a coordinate that are: those given, or a turn.
fn limits(lower: f64, upper: f64, slides: bool) -> Result<[f64; 2], Fault> {
    let (parameter, value) = ("range between the limits of a joint", upper - lower);
    match [lower.is_finite(), upper.is_finite()] {
        _ if value.is_nan() || value < 0.0 => Err(Fault::Negative { parameter, value }),
        [true, true] => Ok([lower, upper]),
        _ if slides => Err(Fault::NotFinite { parameter: "limit of a slide" }),
        [true, false] => Ok([lower, lower + TAU]),
        [false, true] => Ok([upper - TAU, upper]),
        [false, false] => Ok([-PI, PI]),
    }
}

impl<T: Scalar, R: Root<S<T>>, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, R, C, P> {
    /// What leads from one configuration to another (rad, m), joint by joint: q₁ − q₀, for angles are not wrapped.
    ///
    /// # Errors
    /// [`Fault::Count`] where `N` is not the number of joints, [`Fault::NonFiniteMotion`] where something came out not finite.
    pub fn difference<const N: usize>(&self, from: &[T; N], to: &[T; N]) -> Result<[T; N], Error>
    where
        R: FixedBase<T>,
    {
        self.between_joints(from, to)
    }

    /// Where a step (rad, m) leads from a configuration, joint by joint: q + step. `integrate(q₀, difference(q₀, q₁))` is q₁, to rounding.
    ///
    /// # Errors
    /// As [`difference`](Self::difference).
    pub fn integrate<const N: usize>(&self, q: &[T; N], step: &[T; N]) -> Result<[T; N], Error>
    where
        R: FixedBase<T>,
    {
        self.beyond_joints(q, step)
    }

    fn between_joints<const N: usize>(&self, from: &[T; N], to: &[T; N]) -> Result<[T; N], Error> {
        self.has_joints(N)?;
        let step = core::array::from_fn(|k| to[k] - from[k]);
        finite(&step).map(|()| step)
    }

    fn beyond_joints<const N: usize>(&self, q: &[T; N], step: &[T; N]) -> Result<[T; N], Error> {
        self.has_joints(N)?;
        let moved = core::array::from_fn(|k| q[k] + step[k]);
        finite(&moved).map(|()| moved)
    }

    /// A configuration at random: each joint uniformly between its limits (rad, m; `LOWER` and `UPPER` of modules of descriptions), by numbers
    /// in `0.0..1.0`, one for each joint, from a generator of yours. A hinge without limits (infinite ones) is uniform over a turn,
    /// −π to π; one with a single limit, over the turn that ends there. Joints that follow others (`MIMICS`) are as free as any.
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(3.0_f64, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    /// let chain = (Hinge::level(), link, Slide::at::<4>([0.0, 0.0, 0.4]), link);
    /// let arm = System::new(Base::origin(), chain, Free)?;
    /// let q = arm.random_configuration([&[-f64::INFINITY, 0.1], &[f64::INFINITY, 0.5]], &[0.75, 0.25])?;
    /// assert!((q[0] - 1.5707963267948966).abs() < 1e-15 && (q[1] - 0.2).abs() < 1e-15);
    /// let step = arm.difference(&[0.0; 2], &q)?;
    /// assert_eq!(arm.integrate(&[0.0; 2], &step)?, q);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::Count`] where `N` is not the number of joints; [`Fault::OutOfRange`] for numbers not in `0.0..1.0`; with the station of the
    /// joint [`Fault::Negative`] for a lower limit above the upper one, or none, and [`Fault::NotFinite`] for a slide without limits.
    pub fn random_configuration<const N: usize>(
        &self,
        limits: [&[f64; N]; 2],
        numbers: &[f64; N],
    ) -> Result<[T; N], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.random_joints(limits, numbers)
    }

    fn random_joints<const N: usize>(&self, [lower, upper]: [&[f64; N]; 2], numbers: &[f64; N]) -> Result<[T; N], Error>
    where
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        shares(numbers)?;
        let (slides, mut q) = (self.slides::<N>(), [T::zero(); N]);
        for (k, q) in q.iter_mut().enumerate() {
            let limits = limits(lower[k], upper[k], slides[k])
                .map_err(|fault| Error::new(fault).at_station(station_of_coordinate(self.chain(), k)))?;
            *q = T::literal(between(limits, numbers[k]));
        }
        Ok(q)
    }
}

impl<T: Scalar, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, Free, C, P> {
    /// What leads from one configuration of a robot whose base floats to another: of the base its way (m, inertial axes) and its rotation
    /// vector ψ (rad, its axes) with A₁ = A₀ exp ψ, of at most half a turn; of the joints q₁ − q₀. A small difference over a time is the
    /// velocity of base and joints, in axes as all functions have it.
    ///
    /// ```
    /// use catena::robot::*;
    /// let link = Link::general(3.0_f64, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
    /// let robot = System::new(Free, (BodyAxes, link, Hinge::at::<4>([0.0, 0.0, 0.4]), link), Free)?;
    /// let place = |place: [f64; 3], angles| Place { place: place.into(), attitude: Rotation::from_angles(angles).matrix() };
    /// let (from, to) = (place([0.0; 3], [0.1, 0.2, 0.3]), place([0.3, 0.0, 1.0], [-1.0, 0.5, 2.0]));
    /// let (of_base, of_joints) = robot.difference_afloat((from, &[0.5]), (to, &[-0.1]))?;
    /// let (base, q) = robot.integrate_afloat((from, &[0.5]), (&of_base, &of_joints))?;
    /// assert!((base.place - to.place).norm() < 1e-15 && (base.attitude.x - to.attitude.x).norm() < 1e-15);
    /// assert!((q[0] + 0.1).abs() < 1e-15);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`forward_dynamics_afloat`](Self::forward_dynamics_afloat).
    pub fn difference_afloat<const N: usize>(
        &self,
        (from, q): (Place<T>, &[T; N]),
        (to, other): (Place<T>, &[T; N]),
    ) -> Result<([T; 6], [T; N]), Error> {
        let of_joints = self.between_joints(q, other)?;
        checked(&from).and(checked(&to))?;
        let way = to.place - from.place;
        let turn = Rotation::from_matrix(&to.attitude).relative_to(&Rotation::from_matrix(&from.attitude));
        let [a, b, c] = turn.shortest().log();
        let of_base = [way.x, way.y, way.z, a, b, c];
        finite(&of_base).map(|()| (of_base, of_joints))
    }

    /// Where a step of base and joints leads, as [`difference_afloat`](Self::difference_afloat) has it: exact on the group of rotations, for a
    /// steady angular velocity over any time, as far as the digits of its turn (rad) go. Axes come out orthonormal to rounding, however many steps
    /// follow each other.
    ///
    /// # Errors
    /// As [`forward_dynamics_afloat`](Self::forward_dynamics_afloat).
    pub fn integrate_afloat<const N: usize>(
        &self,
        (base, q): (Place<T>, &[T; N]),
        (of_base, of_joints): (&[T; 6], &[T; N]),
    ) -> Result<(Place<T>, [T; N]), Error> {
        let q = self.beyond_joints(q, of_joints)?;
        checked(&base)?;
        finite(of_base)?;
        let [x, y, z, a, b, c] = *of_base;
        let turned = Rotation::from_matrix(&base.attitude).after(&Rotation::exp([a, b, c]));
        let attitude = Rotation::from_quaternion(turned.quaternion())?;
        let place = base.place + Vector3::new(x, y, z);
        finite(place.as_slice()).map(|()| (Place { place, attitude: attitude.matrix() }, q))
    }

    /// A configuration at random of a robot whose base floats: its place uniformly between two corners of a box (m), its attitude uniformly among
    /// all, by six numbers in `0.0..1.0`; joints as in [`random_configuration`](Self::random_configuration).
    ///
    /// Attitudes are by K. Shoemake, *Uniform random rotations*, Graphics Gems III, 1992.
    ///
    /// # Errors
    /// As [`random_configuration`](Self::random_configuration); of a box without station.
    pub fn random_configuration_afloat<const N: usize>(
        &self,
        corners: [[f64; 3]; 2],
        limits: [&[f64; N]; 2],
        of_base: &[f64; 6],
        of_joints: &[f64; N],
    ) -> Result<(Place<T>, [T; N]), Error>
    where
        C: Tasks<T, N>,
    {
        let q = self.random_joints(limits, of_joints)?;
        shares(of_base)?;
        let ([first, second], mut place) = (corners, [T::zero(); 3]);
        for (k, place) in place.iter_mut().enumerate() {
            let parameter = "range between the corners of a box";
            let (lower, upper) = (first[k], second[k]);
            if !(lower.is_finite() && upper.is_finite()) {
                return Err(Error::new(Fault::NotFinite { parameter: "corner of a box" }));
            }
            if lower > upper {
                return Err(Error::new(Fault::Negative { parameter, value: upper - lower }));
            }
            *place = T::literal(between([lower, upper], of_base[k]));
        }
        // Two circles, whose radii share one.
        let [.., share, one, two] = *of_base;
        let circle = |square: f64, turn: f64| {
            let radius = T::constant(T::Real::of(square).sqrt());
            let (sine, cosine) = T::literal(TAU * turn).sin_cos();
            [radius * sine, radius * cosine]
        };
        let ([x, y], [z, w]) = (circle(1.0 - share, one), circle(share, two));
        let attitude = Rotation::from_quaternion([w, x, y, z])?.matrix();
        Ok((Place { place: vector(place), attitude }, q))
    }
}
