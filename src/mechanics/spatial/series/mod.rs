//! Taylor series in space: what is carried and kept.
//!
//! Whatever turns with a body is a vector v with v̇ = ω × v, so that v̈ = α × v₀ + p of each order, with p = (k + 1) Σ ω_{k+1−j} × v_j of
//! what is known, j from 1 on. All are in inertial axes. Convolutions of two series of numbers, for each coefficient:
//!
//! | | turning | forces | |
//! |---|---|---|---|
//! | rod, point mass | 6: the arm | 6: moment about the inboard end | 12 |
//! | rigid body | 18: three axes | 18: moments of what acts along each | 36 |
//! | ball | 12: the attitude | 15 under a torque in axes of the body | 12 or 27 |
//! | revolute | 6: the axis | 3: torque about it, 3: rate along it | 12 |
//! | prismatic joint | 9: the axis, the place along it | 9: force along it, moment of the arm | 18 |
//! | weld | | | 0 |
//!
//! They are taken four at a time from three rows of coefficients, so that each takes a quarter of k products.

mod ball;
mod loops;
mod motion;
mod prismatic;
mod products;
mod revolute;
mod rigid_body;
mod rods;
mod tips;
mod weld;

use super::{Acceleration, Internal, Spatial, Turn};
use crate::relation::spatial::algebra::{Columns, Factor3, Symmetric3, add_scaled, zero};
use crate::relation::spatial::{Full, Gain, Pivot};
use crate::relation::{Additive, Closures, Cuts, Geometry, Join, Symmetric};
use crate::scalar::Scalar;
use crate::series::{Expandable, Strain};
use nalgebra::Vector3;
use products::Rows;

/// What a body keeps, or a joint of the vectors that turn with its bodies.
#[derive(Clone, Copy, Debug)]
pub struct AxesSeries<T, const N: usize> {
    /// The vectors that turn, where the series begins: an arm; an axis; an axis, with the coordinate beside its entries, and the arm along it; three
    /// axes, of a body side by side, entries as rows.
    axes: Rows<T>,
    /// Second moments of a body; shares of its axes in its arm and in its first moment.
    moments: Rows<T>,
    shares: [[T; 4]; 2],
    /// What accelerations and angular accelerations of the inboard end do to the force that is convolved; in a joint that turns, to force
    /// and torque.
    linear: Symmetric3<T>,
    coupling: Columns<T>,
    angular: Symmetric3<T>,
    /// Of the present order: p of each vector, and what is known of that force.
    curls: Rows<T>,
    force: Vector3<T>,
    /// What is convolved: vectors that turn, from number 1 on,
    turned: [Rows<T>; N],
    /// and angular velocities beside forces of the order before.
    turning: [Rows<T>; N],
}

/// What a joint keeps.
#[derive(Clone, Copy)]
pub struct JointSeries<T: Copy, const N: usize> {
    /// How a ball's angular acceleration depends on the acceleration of its station, and the factors of its pivot.
    gain: Gain<T>,
    factor: Factor3<T>,
    /// How the acceleration of one coordinate depends on those of its station, and −1 / D.
    pivot: Pivot<T>,
    minus_inverse: T,
    /// What is known of the present order: angular acceleration and torque.
    bias: Vector3<T>,
    torque: Vector3<T>,
    /// What spring and damper make of the coordinate.
    strain: Strain<T, N>,
}

/// The acceleration of a station.
#[derive(Clone, Copy, Debug)]
pub enum Swung<T> {
    /// No acceleration: nothing is multiplied by it.
    Still,
    /// An angular acceleration alone.
    Turning(Vector3<T>),
    /// Any acceleration.
    At(Acceleration<T>),
}

impl<T: Scalar> Swung<T> {
    /// The acceleration.
    #[inline(always)]
    fn acceleration(self) -> Acceleration<T> {
        match self {
            Self::Still => Acceleration::zero(),
            Self::Turning(angular) => Acceleration { angular, ..Acceleration::zero() },
            Self::At(at) => at,
        }
    }
    /// The acceleration of a station in the same place that turns otherwise.
    #[inline(always)]
    fn turning(self, angular: Vector3<T>) -> Self {
        match self {
            Self::Still | Self::Turning(_) => Self::Turning(angular),
            Self::At(at) => Self::At(Acceleration { angular, ..at }),
        }
    }
}

impl<T: Scalar, const N: usize> AxesSeries<T, N> {
    /// The force that is convolved, of the acceleration of the inboard end and of what is known of it.
    #[cfg_attr(optimised, inline(always))]
    fn pulled(&self, inboard: Swung<T>, known: Vector3<T>) -> Vector3<T> {
        match inboard {
            Swung::Still => known,
            Swung::Turning(angular) => self.coupling.apply_onto(angular, known),
            Swung::At(Acceleration { linear, angular }) => {
                self.coupling.apply_onto(angular, self.linear.apply_onto(linear, known))
            }
        }
    }
}

impl<T: Scalar> Expandable for Spatial<T> {
    /// Without what velocities and forces contribute.
    type Articulated = Full<T>;
    type AxesSeries<const N: usize> = AxesSeries<T, N>;
    type JointSeries<const N: usize> = JointSeries<T, N>;
    /// The angular velocity (rad/s), inertial axes.
    type Begun = Vector3<T>;
    type Pushed = Internal<T>;
    type Swung = Swung<T>;

    #[inline(always)]
    fn nothing() -> Full<T> {
        Full::massless()
    }
    #[inline(always)]
    fn join(chain: Full<T>, arm: Full<T>) -> Full<T> {
        Join::join(chain, arm)
    }
    #[cfg_attr(optimised, inline(always))]
    fn closed(open: Full<T>, wrench: Internal<T>, inverse: T) -> Full<T> {
        let (Internal { force, torque }, share) = (wrench, wrench.torque * inverse);
        Full {
            linear: open.linear.plus_outer(force, force * inverse),
            coupling: Spatial::plus_outer(open.coupling, force, share),
            angular: open.angular.plus_outer(torque, share),
            ..open
        }
    }
    #[inline(always)]
    fn begun(ground: Turn<T>) -> Vector3<T> {
        ground.spin
    }
    #[inline(always)]
    fn unpushed() -> Internal<T> {
        Internal::none()
    }
    #[inline(always)]
    fn pushed(felt: Internal<T>) -> Internal<T> {
        felt
    }
    #[inline(always)]
    fn relieved(pushed: Internal<T>, load: Internal<T>) -> Internal<T> {
        pushed - load
    }
    #[inline(always)]
    fn felt(pushed: Internal<T>) -> Internal<T> {
        pushed
    }
    #[inline(always)]
    fn accelerated(acceleration: Acceleration<T>) -> Swung<T> {
        Swung::At(acceleration)
    }
    #[inline(always)]
    fn still() -> Swung<T> {
        Swung::Still
    }
    #[inline(always)]
    fn acceleration(swung: Swung<T>) -> Acceleration<T> {
        swung.acceleration()
    }
    fn untouched<const N: usize>() -> (AxesSeries<T, N>, JointSeries<T, N>) {
        let (none, matrix, symmetric) = ([products::none(); N], Columns::null(), Symmetric3::null());
        let axes = AxesSeries {
            axes: products::none(),
            moments: products::none(),
            shares: [[T::zero(); 4]; 2],
            linear: symmetric,
            coupling: matrix,
            angular: symmetric,
            curls: products::none(),
            force: zero(),
            turned: none,
            turning: none,
        };
        let joint = JointSeries {
            gain: Gain::blank(),
            factor: Symmetric3::diagonal(T::one()).factor(),
            pivot: Pivot::blank(),
            minus_inverse: T::zero(),
            bias: zero(),
            torque: zero(),
            strain: Strain::none(),
        };
        (axes, joint)
    }
}

/// What lies outboard without closure forces; these go into the cuts.
#[cfg_attr(optimised, inline(always))]
fn parted<T: Scalar, C: Closures>(full: Full<T, C>, cuts: &mut Cuts<Internal<T>, T, C>) -> Full<T> {
    let Full { linear, coupling, angular, force, torque, cuts: found } = full;
    *cuts = found;
    Full { linear, coupling, angular, force, torque, cuts: Cuts::none() }
}

/// A force with those that closure forces cause by their columns.
#[cfg_attr(optimised, inline(always))]
fn pulled<T: Scalar, C: Closures>(
    force: Vector3<T>,
    columns: &C::Each<Internal<T>>,
    forces: &C::Each<T>,
) -> Vector3<T> {
    let mut sum = force;
    C::zip(columns, forces, |w, by| sum = add_scaled(sum, by, w.force));
    sum
}
