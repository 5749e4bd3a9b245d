//! What a joint says of itself at an instant: what it lets move, and what resists it there.

pub use crate::relation::Way;
use crate::relation::{Additive, VectorSpace};
use crate::scalar::Scalar;
use crate::space::Space;
use crate::spring::SpringLaw;
use crate::sweep::Implicit;
use num_traits::{One, Zero};

/// What acts along the coordinate of a joint at an instant, ON the outboard body, and how that changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resistance<T> {
    /// Generalised force (N·m, N).
    pub force: T,
    /// −∂force/∂position (N·m/rad, N/m).
    pub stiffness: T,
    /// −∂force/∂rate (N·m·s/rad, N·s/m).
    pub damping: T,
}

impl<T: Scalar> Resistance<T> {
    /// Nothing acts.
    pub fn none() -> Self {
        Self { force: T::zero(), stiffness: T::zero(), damping: T::zero() }
    }

    /// What a law does at a position and rate.
    pub fn of(law: &impl SpringLaw<T>, position: T, rate: T) -> Self {
        let [stiffness, damping] = slopes::<T, _>(|springs| law.pivot(position, rate, springs));
        Self { force: law.force(position, rate), stiffness, damping }
    }

    /// A viscous damper (N·m·s/rad, N·s/m).
    pub fn viscous(damping: T, rate: T) -> Self {
        Self { force: -(damping * rate), stiffness: T::zero(), damping }
    }

    /// A linear spring (N·m/rad, N/m) at a distance from its rest.
    pub fn elastic(stiffness: T, strain: T) -> Self {
        Self { force: -(stiffness * strain), stiffness, damping: T::zero() }
    }
}

/// The slopes of a law, ∂/∂position and ∂/∂rate, by what it adds to pivots.
pub(crate) fn slopes<T: Scalar, X>(pivot: impl Fn(Implicit<T::Real>) -> X) -> [X; 2] {
    let (zero, one) = (T::Real::zero(), T::Real::one());
    [(one, zero), (zero, one)].map(|(position, rate)| pivot(Implicit { position, rate }))
}

/// A coordinate of a joint at an instant: how it moves, about or along which axis, and what resists it there.
#[derive(Clone, Copy, Debug)]
pub struct Freedom<S: Space> {
    /// Whether the coordinate turns or slides.
    pub way: Way,
    /// Axis n of the coordinate, inertial axes: a unit vector, but zero for a turn in the plane, which is about ẑ.
    pub axis: S::Vector,
    /// What springs, dampers and laws exert on the coordinate.
    pub resistance: Resistance<S::Scalar>,
    /// What springs and laws exert on the coordinate where position and rate are zero: k φ₀ of a linear spring with the rest value φ₀.
    pub preload: S::Scalar,
    /// Reflected inertia I (kg·m², kg): of what moves with this coordinate alone, ½ I q̇².
    pub inertia: S::Scalar,
    /// Whether loads in the joint act on it, in order.
    pub driven: bool,
    /// Whether what resists is affine in position and rate.
    pub linear: bool,
}

impl<S: Space> Freedom<S> {
    /// A coordinate that nothing resists.
    pub fn smooth(way: Way, axis: S::Vector) -> Self {
        let zero = Additive::null();
        Self { way, axis, resistance: Resistance::none(), preload: zero, inertia: zero, driven: true, linear: true }
    }

    /// This coordinate against the law of a spring.
    #[must_use]
    pub fn sprung<L: SpringLaw<S::Scalar>>(self, law: &L, [position, rate]: [S::Scalar; 2]) -> Self {
        let preload = law.force(Additive::null(), Additive::null());
        Self { linear: L::LINEAR, ..self.against(Resistance::of(law, position, rate), preload) }
    }

    /// This coordinate, but no loads in the joint act on it.
    #[must_use]
    pub fn undriven(self) -> Self {
        Self { driven: false, ..self }
    }

    /// This coordinate against a law.
    #[must_use]
    pub fn against(self, resistance: Resistance<S::Scalar>, preload: S::Scalar) -> Self {
        Self { resistance, preload, ..self }
    }
}

/// What a joint lets move at an instant, in inertial axes: p_O = X p_I + c + Φ q̈, Φᵀ F = τ − I q̈.
#[derive(Clone, Copy, Debug)]
pub struct Release<S: Space> {
    /// Coordinates of the joint, in the order of its rates.
    pub coordinates: [Option<Freedom<S>>; 6],
    /// Whether the outboard body turns with the inboard one. Coordinates of pins and balls are absolute.
    pub carries: bool,
    /// Whether the outboard point swings about the inboard one with the inboard body.
    pub swings: bool,
    /// Whether the moments on the joint's sides differ by that of its force, m_O = m_I + d × q.
    pub balanced: bool,
    /// Whether a drive moves the joint, whose acceleration is part of c then.
    pub driven: bool,
    /// c: what the outboard point accelerates by besides the inboard body (m/s²).
    pub linear: S::Vector,
    /// c: angular acceleration of the outboard body besides the inboard one (rad/s²).
    pub angular: S::Angular,
}

impl<S: Space> Release<S> {
    /// A joint that lets nothing move.
    pub fn nothing() -> Self {
        let (linear, angular) = (Additive::null(), Additive::null());
        Self { coordinates: [None; 6], carries: true, swings: true, balanced: true, driven: false, linear, angular }
    }

    /// With another coordinate.
    #[must_use]
    pub fn with(mut self, freedom: Freedom<S>) -> Self {
        if let Some(free) = self.coordinates.iter_mut().find(|coordinate| coordinate.is_none()) {
            *free = Some(freedom);
        }
        self
    }

    /// With its coordinate driven at a second derivative: no freedom, but part of c.
    #[must_use]
    pub(crate) fn driven(self, second: S::Scalar) -> Self {
        let Self { coordinates: [freedom, ..], linear, angular, .. } = self;
        let still = Self { coordinates: [None; 6], driven: true, ..self };
        match freedom {
            Some(Freedom { way: Way::Slide, axis, .. }) => Self { linear: linear.plus_scaled(second, axis), ..still },
            Some(Freedom { way: Way::Turn, axis, .. }) => Self { angular: angular + S::about(axis, second), ..still },
            None => still,
        }
    }

    /// Coordinates of the joint, and the effort of a load on each.
    pub fn under(self, efforts: [S::Scalar; 3]) -> impl Iterator<Item = (Freedom<S>, S::Scalar)> {
        let mut efforts = efforts.into_iter();
        self.coordinates.into_iter().flatten().map(move |freedom| {
            let effort = if freedom.driven { efforts.next() } else { None };
            (freedom, effort.unwrap_or(Additive::null()))
        })
    }

    /// Coordinates that turn, or that slide.
    pub fn of(&self, way: Way) -> impl Iterator<Item = &Freedom<S>> {
        self.coordinates.iter().flatten().filter(move |freedom| freedom.way == way)
    }
}
