//! Taylor series in the plane: what lies outboard.

mod bodies;
mod joints;
mod loops;
mod motion;
mod products;
mod slider;
mod tips;

use crate::mechanics::planar::{Acceleration, Internal, Planar, Turn};
use crate::relation::planar::algebra::{Symmetric2, add_scaled, plus_dot};
use crate::relation::{Additive, Closures, Symmetric};
use crate::scalar::Scalar;
use crate::series::Expandable;
use bodies::AxesSeries;
use joints::JointSeries;
use nalgebra::Vector2;

/// Inertia of what lies outboard of a point, as it is felt there: force (f, τ) = S (a, α).
#[derive(Clone, Copy, Debug)]
pub struct Articulated<T> {
    /// f of a.
    pub(super) linear: Symmetric2<T>,
    /// f of α, and its mirror.
    pub(super) coupling: Vector2<T>,
    /// τ of α.
    pub(super) angular: T,
    /// Of a body that begins here: by what its other end moves as it turns.
    pub(super) lever: Option<Vector2<T>>,
}

/// Force and torque on what lies outboard, as far as they are known. A joint that turns needs both from a body outboard of it at once: one after
/// the other, each body and order would wait for three products instead of two.
#[derive(Clone, Copy, Debug)]
pub enum Pushed<T> {
    /// None: there is nothing outboard.
    None,
    /// As they are.
    Felt(Internal<T>),
    /// Where a body begins: known + (F, lever · F).
    Levered {
        /// What the body adds.
        known: Internal<T>,
        /// F, the force where the body ends.
        force: Vector2<T>,
        /// Torque about the inboard end, of forces where the body ends.
        lever: Vector2<T>,
    },
}

impl<T: Scalar> Pushed<T> {
    /// Force and torque.
    #[inline(always)]
    fn felt(self) -> Internal<T> {
        match self {
            Self::None => Internal::none(),
            Self::Felt(felt) => felt,
            Self::Levered { known, force, lever } => {
                Internal { force: known.force + force, torque: plus_dot(known.torque, lever, force) }
            }
        }
    }
}

/// The acceleration of a station.
#[derive(Clone, Copy, Debug)]
pub enum Swung<T> {
    /// No acceleration: nothing is multiplied by it.
    Still,
    /// Any acceleration.
    At(Acceleration<T>),
    /// Where a body begins, outboard of a joint that turns: its other end need not wait for its angular acceleration.
    Turned {
        /// a, α.
        at: Acceleration<T>,
        /// α if a were zero.
        free: T,
        /// a + (α − free) lever as a matrix before a, by columns.
        through: [Vector2<T>; 2],
    },
}

impl<T: Scalar> Swung<T> {
    /// The acceleration.
    #[inline(always)]
    fn acceleration(self) -> Acceleration<T> {
        match self {
            Self::Still => Acceleration::zero(),
            Self::At(at) | Self::Turned { at, .. } => at,
        }
    }
    /// a + moved + α lever.
    #[cfg_attr(optimised, inline(always))]
    fn beyond(self, moved: Vector2<T>, lever: Vector2<T>) -> Vector2<T> {
        match self {
            Self::Still => moved,
            Self::At(Acceleration { linear, angular }) => add_scaled(linear + moved, angular, lever),
            Self::Turned { at, free, through } => applied_onto(through, at.linear, add_scaled(moved, free, lever)),
        }
    }
}

/// `sum` + a matrix, by columns, times v.
#[inline(always)]
fn applied_onto<T: Scalar>([x, y]: [Vector2<T>; 2], v: Vector2<T>, sum: Vector2<T>) -> Vector2<T> {
    add_scaled(add_scaled(sum, v.x, x), v.y, y)
}

impl<T: Scalar> Expandable for Planar<T> {
    type Articulated = Articulated<T>;
    type AxesSeries<const N: usize> = AxesSeries<T, N>;
    type JointSeries<const N: usize> = JointSeries<T, N>;
    type Begun = Turn<T>;
    type Pushed = Pushed<T>;
    type Swung = Swung<T>;

    #[inline(always)]
    fn nothing() -> Articulated<T> {
        Articulated { linear: Symmetric2::null(), coupling: Vector2::null(), angular: T::zero(), lever: None }
    }
    #[inline(always)]
    fn join(a: Articulated<T>, b: Articulated<T>) -> Articulated<T> {
        Articulated {
            linear: a.linear + b.linear,
            coupling: a.coupling + b.coupling,
            angular: a.angular + b.angular,
            lever: None,
        }
    }
    #[cfg_attr(optimised, inline(always))]
    fn closed(open: Articulated<T>, wrench: Internal<T>, inverse: T) -> Articulated<T> {
        let (Internal { force, torque }, Articulated { linear, coupling, angular, .. }) = (wrench, open);
        let share = torque * inverse;
        Articulated {
            linear: linear.plus_outer(force, force * inverse),
            coupling: add_scaled(coupling, share, force),
            angular: torque.mul_add(share, angular),
            lever: None,
        }
    }
    #[inline(always)]
    fn begun(ground: Turn<T>) -> Turn<T> {
        ground
    }
    #[inline(always)]
    fn unpushed() -> Pushed<T> {
        Pushed::None
    }
    #[inline(always)]
    fn pushed(felt: Internal<T>) -> Pushed<T> {
        Pushed::Felt(felt)
    }
    #[inline(always)]
    fn relieved(pushed: Pushed<T>, load: Internal<T>) -> Pushed<T> {
        match pushed {
            Pushed::None => Pushed::Felt(-load),
            Pushed::Felt(felt) => Pushed::Felt(felt - load),
            Pushed::Levered { known, force, lever } => Pushed::Levered { known: known - load, force, lever },
        }
    }
    #[inline(always)]
    fn felt(pushed: Pushed<T>) -> Internal<T> {
        pushed.felt()
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
    #[inline(always)]
    fn untouched<const N: usize>() -> (AxesSeries<T, N>, JointSeries<T, N>) {
        (AxesSeries::new(), JointSeries::new())
    }
}

/// A force with those that closure forces cause by their columns.
#[cfg_attr(optimised, inline(always))]
fn pulled<T: Scalar, C: Closures>(
    force: Vector2<T>,
    columns: &C::Each<Internal<T>>,
    forces: &C::Each<T>,
) -> Vector2<T> {
    let mut sum = force;
    C::zip(columns, forces, |w, by| sum = add_scaled(sum, by, w.force));
    sum
}
