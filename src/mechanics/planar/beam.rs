//! Elastic beams, as chains of rigid rods and springs.

use super::{ElasticHinge, Rod, Slider, Spring};
use crate::lift::lift;
use crate::relation::{Absent, Coefficient};
use crate::scalar::{Real, Scalar};
#[cfg(feature = "alloc")]
use alloc::vec::Vec;

/// A uniform elastic beam, straight where nothing bends it, to be divided into segments: rigid rods with springs between them.
///
/// A beam is no element. [`segments`](Self::segments) divides it and returns a chain, which is:
///
/// ```
/// use catena::planar::*;
/// let beam = Beam::new(1.0, 2.0, 0.5); // length (m), bending stiffness EI (N·m²), mass per length ρA (kg/m)
/// let cantilever = System::new(Clamped::at(0.0, 0.0, 0.0), beam.segments::<20>(), Free)?;
/// let swing = System::new(Pinned::origin(), beam.segments::<20>(), Free)?.with_gravity(9.81);
/// let hub = RigidBody::new(3.0, 0.1, [0.0; 2], [0.2, 0.0]);
/// let blade = System::new(Pinned::origin(), (hub, beam.segments::<20>()), Free)?; // grows out of the hub
/// let bridge = System::new(Pinned::origin(), beam.with_extension(1e5).segments::<20>(), Pinned::at(1.0, 0.0))?;
/// # Ok::<(), catena::Error>(())
/// ```
///
/// # Any end will do
///
/// Each of K segments of length ℓ = L/K bends in its middle, by a spring EI/ℓ that stands for the whole of it, so a chain begins
/// and ends with half a rod. The ends are rigid, and whatever holds them (a clamp, a pin, a body, nothing) holds them as it would
/// hold the beam. Springs at the ends of segments would not do: one at a clamp stands for half a segment and needs 2EI/ℓ. With
/// EI/ℓ, as inside, frequencies converge at first order only; and a spring at a clamped tip is one that no inertia resists.
///
/// # How many segments
///
/// Bending is that of Euler and Bernoulli, without shear, in any rotation. At rest under a couple at its end a beam is exact with
/// any number of segments (an arc); under a force at the end of a cantilever it is stiffer by 1 part in 4K². Errors of the lowest
/// frequency, with 10, 20 and 40 segments:
///
/// | ends | order | | | |
/// |---|---|---|---|---|
/// | clamped, free | 2 | +2.3e-3 | +5.7e-4 | +1.4e-4 |
/// | pinned, free | 4 | −1.6e-5 | −1.0e-6 | −6.4e-8 |
/// | clamped, clamped | 2 | +1.6e-2 | +3.9e-3 | +9.7e-4 |
/// | stretching, one end held | 2 | −1.0e-3 | −2.6e-4 | −6.4e-5 |
///
/// The highest frequency of a cantilever is 8.87 K² √(EI/ρA)/L², that of a stretching one 2K √(EA/ρA)/L if it is more: many segments
/// make a stiff scene, which asks for [`GeneralizedAlpha`](crate::time::GeneralizedAlpha) or [`Sdirk4`](crate::time::Sdirk4).
///
/// # Source
///
/// X. Rui et al. 2005 have elastic beams in the library of elements from which a system is assembled (highlight 6), and divide
/// the beams of their Examples 2 and 3 into rigid bodies with rotary springs between them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Beam<T, E = Absent, D = Absent> {
    length: T,
    /// EI (N·m²).
    bending: T,
    /// ρA (kg/m).
    density: T,
    /// EA (N).
    extension: E,
    /// Dampers over springs (s).
    damping: D,
}

/// A divided beam: half a rod, and as many links as segments, the last of which ends with half a rod.
pub type Segments<T, Links> = (Rod<T>, Links);

impl<T: Scalar> Beam<T> {
    /// A beam that bends and does not stretch: length (m), bending stiffness EI (N·m²), mass per length ρA (kg/m).
    pub fn new(length: T, bending: T, density: T) -> Self {
        Self { length, bending, density, extension: Absent, damping: Absent }
    }
}

impl<T: Scalar, D> Beam<T, Absent, D> {
    /// This beam as one that stretches too, along itself, with a stiffness EA (N).
    ///
    /// A straight beam that does not stretch cannot be held at both its ends: its length is given twice.
    pub fn with_extension(self, stiffness: T) -> Beam<T, T, D> {
        let Self { length, bending, density, damping, .. } = self;
        Beam { length, bending, density, extension: stiffness, damping }
    }
}

impl<T: Scalar, E> Beam<T, E> {
    /// With dampers in proportion to its springs (Kelvin and Voigt), M = EI (κ + τ κ̇) of the curvature κ, and likewise along it:
    /// time τ (s). It damps a mode of frequency ω by a share ω τ / 2 of critical damping.
    pub fn damped(self, time: T) -> Beam<T, E, T> {
        let Self { length, bending, density, extension, .. } = self;
        Beam { length, bending, density, extension, damping: time }
    }
}

impl<T: Scalar, E: Stretch<T, D>, D: Coefficient<T>> Beam<T, E, D> {
    /// Divided into `K` segments of equal length; none make a rigid rod.
    ///
    /// It has K + 1 bodies. The coordinates of each segment are its angle (rad), after its stretch (m) if it has one.
    pub fn segments<const K: usize>(&self) -> Segments<T, [E::Link; K]> {
        (self.first(K), core::array::from_fn(|k| self.link(K, k)))
    }

    /// Divided into a number of segments that is known when the program runs.
    #[cfg(feature = "alloc")]
    pub fn segments_in_vec(&self, count: usize) -> Segments<T, Vec<E::Link>> {
        (self.first(count), (0..count).map(|k| self.link(count, k)).collect())
    }

    /// A rod that is a share of the beam.
    fn rod(&self, share: f64) -> Rod<T> {
        let length = self.length.scale(T::Real::of(share));
        Rod::uniform(length, self.density * length)
    }

    /// Before the spring of the first segment: half of it.
    fn first(&self, count: usize) -> Rod<T> {
        self.rod(if count == 0 { 1.0 } else { 0.5 / count as f64 })
    }

    /// From the spring of segment `k` to that of the next one, or to the end.
    fn link(&self, count: usize, k: usize) -> E::Link {
        let segments = count as f64;
        let per_segment = |stiffness: T| {
            let stiffness = stiffness.scale(T::Real::of(segments)) / self.length;
            Spring::proportional(stiffness, self.damping)
        };
        let rod = self.rod(if k + 1 < count { 1.0 } else { 0.5 } / segments);
        self.extension.link(per_segment, self.bending, rod)
    }
}

/// Whether a beam stretches: EA, or [`Absent`].
pub trait Stretch<T: Scalar, D>: Copy {
    /// Springs of a segment and the rod outboard of them.
    type Link;
    /// Makes one, from what makes the springs of a segment of stiffnesses, and EI.
    fn link(self, spring: impl Fn(T) -> Spring<T, D>, bending: T, rod: Rod<T>) -> Self::Link;
}

impl<T: Scalar, D> Stretch<T, D> for Absent {
    type Link = (ElasticHinge<Spring<T, D>>, Rod<T>);

    fn link(self, spring: impl Fn(T) -> Spring<T, D>, bending: T, rod: Rod<T>) -> Self::Link {
        (ElasticHinge { rotary: spring(bending), linear: Absent }, rod)
    }
}

/// The slider is along the rod inboard of it.
impl<T: Scalar, D: Coefficient<T>> Stretch<T, D> for T {
    type Link = (Slider<T, Spring<T, D>>, ElasticHinge<Spring<T, D>>, Rod<T>);

    fn link(self, spring: impl Fn(T) -> Spring<T, D>, bending: T, rod: Rod<T>) -> Self::Link {
        let hinge = ElasticHinge { rotary: spring(bending), linear: Absent };
        (Slider::along(T::zero()).with(spring(self)), hinge, rod)
    }
}

lift!(Beam<T, E, D> { length, bending, density, extension, damping });
