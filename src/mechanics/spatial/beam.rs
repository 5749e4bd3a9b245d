//! Elastic beams in space, as chains of rigid rods and springs.

use super::rotary_spring::{RotaryDamper, RotarySpring};
use super::{ElasticBall, ElasticHinge, Linear, Prismatic, Rod, Spring};
use crate::lift::lift;
use crate::relation::{Absent, Coefficient};
use crate::scalar::{Real, Scalar};
#[cfg(feature = "alloc")]
use alloc::vec::Vec;

/// A uniform elastic beam along x, straight where nothing bends it, to be divided into segments: rigid rods with springs between them.
///
/// A beam is no element. [`segments`](Self::segments) divides it and returns a chain, which is:
///
/// ```
/// use catena::spatial::*;
/// // Length (m), bending stiffness EI about y and z (N·m²), torsional stiffness GJ (N·m²), mass ρA (kg/m) and moment of inertia
/// // ρI_p about its axis (kg·m) per length.
/// let beam = Beam::new(1.0, [2.0, 5.0], 1.5, 0.5, 1e-5);
/// let cantilever = System::new(Clamped::origin(), beam.segments::<20>(), Free)?.with_gravity([0.0, -9.81, 0.0]);
/// let hub = RigidBody::new(3.0, [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]], [0.0; 3], [0.2, 0.0, 0.0]);
/// let blade = System::new(Pinned::origin(), (hub, beam.segments::<20>()), Free)?; // grows out of the hub
/// let bridge = System::new(Pinned::origin(), beam.with_extension(1e5).segments::<20>(), Pinned::at([1.0, 0.0, 0.0]))?;
/// # Ok::<(), catena::Error>(())
/// ```
///
/// # Any end will do
///
/// Each of K segments of length ℓ = L/K bends and twists in its middle, by a spring [GJ, EI_y, EI_z]/ℓ that stands for the whole of
/// it, so a chain begins and ends with half a rod: the ends are rigid, and whatever holds them holds them as it would hold the beam.
/// (See [`planar::Beam`](crate::planar::Beam) for what springs at the ends of segments would cost.)
///
/// # How many segments
///
/// Bending is that of Euler and Bernoulli in any rotation, with the rotary inertia of sections ρI_p/2 about each of y and z
/// (Rayleigh); twist is that of Saint-Venant. At rest under a couple at its end a beam turns it by the angle of
/// the arc with any number of segments; frequencies of a cantilever, in both planes of bending, in torsion and along it, and places
/// under couples and forces converge with 1/K²:
/// the lowest frequency of bending is off by 2.3e-3 with 10 segments and by 1.4e-4 with 40, that of torsion by 1.0e-3 and 6.4e-5.
/// Many segments make a stiff scene, and so does a small ρI_p, by the frequencies of torsion: it asks for
/// [`GeneralizedAlpha`](crate::time::GeneralizedAlpha) or [`Sdirk4`](crate::time::Sdirk4).
///
/// Where a beam stretches and shears, it does so along the axes of the rod inboard of each spring: where it is strongly bent as
/// well, that converges with 1/K.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Beam<T, E = Absent, D = Absent> {
    length: T,
    /// EI about y and z (N·m²).
    bending: [T; 2],
    /// GJ (N·m²).
    torsion: T,
    /// ρA (kg/m).
    density: T,
    /// ρI_p (kg·m).
    polar: T,
    /// EA, or EA and GA along y and z (N).
    extension: E,
    /// Dampers over springs (s).
    damping: D,
}

/// A divided beam: half a rod, and as many links as segments, the last of which ends with half a rod.
pub type Segments<T, Links> = (Rod<T>, Links);

impl<T: Scalar> Beam<T> {
    /// A beam that bends and twists and does not stretch: length (m), bending stiffness EI about y and z (N·m²), torsional stiffness
    /// GJ (N·m²), mass per length ρA (kg/m), moment of inertia about its axis per length ρI_p (kg·m).
    pub fn new(length: T, bending: [T; 2], torsion: T, density: T, polar: T) -> Self {
        Self { length, bending, torsion, density, polar, extension: Absent, damping: Absent }
    }
}

impl<T: Scalar, D> Beam<T, Absent, D> {
    /// This beam as one that stretches too, along itself, with a stiffness EA (N).
    ///
    /// A straight beam that does not stretch cannot be held at both its ends: its length is given twice.
    pub fn with_extension(self, stiffness: T) -> Beam<T, T, D> {
        self.stretching(stiffness)
    }

    /// This beam as one that stretches with a stiffness EA (N), and shears with stiffnesses κGA along y and z (N): Timoshenko's.
    pub fn with_extension_and_shear(self, stiffness: T, [y, z]: [T; 2]) -> Beam<T, [T; 3], D> {
        self.stretching([stiffness, y, z])
    }

    fn stretching<E>(self, extension: E) -> Beam<T, E, D> {
        let Self { length, bending, torsion, density, polar, damping, .. } = self;
        Beam { length, bending, torsion, density, polar, extension, damping }
    }
}

impl<T: Scalar, E> Beam<T, E> {
    /// With dampers in proportion to its springs (Kelvin and Voigt), M = EI (κ + τ κ̇) of the curvature κ, and likewise of twist,
    /// stretch and shear: time τ (s). It damps a mode of frequency ω by a share ω τ / 2 of critical damping.
    pub fn damped(self, time: T) -> Beam<T, E, T> {
        let Self { length, bending, torsion, density, polar, extension, .. } = self;
        Beam { length, bending, torsion, density, polar, extension, damping: time }
    }
}

impl<T: Scalar, E: Stretch<T, D>, D: Retardation<T>> Beam<T, E, D> {
    /// Divided into `K` segments of equal length; none make a rigid rod.
    ///
    /// It has K + 1 bodies. The coordinates of each segment are the relative attitude of its halves, after its stretch (m) or its
    /// displacements along x, y and z (m) if it has any.
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
        let (mass, axial) = (self.density * length, self.polar * length);
        let half = T::Real::of(0.5);
        let across = (mass * length * length).scale(T::Real::of(1.0 / 12.0)) + axial.scale(half);
        Rod::new(length, mass, length.scale(half), axial, across)
    }

    /// Before the spring of the first segment: half of it.
    fn first(&self, count: usize) -> Rod<T> {
        self.rod(if count == 0 { 1.0 } else { 0.5 / count as f64 })
    }

    /// From the spring of segment `k` to that of the next one, or to the end.
    fn link(&self, count: usize, k: usize) -> E::Link {
        let segments = count as f64;
        let per_segment = |stiffness: T| stiffness.scale(T::Real::of(segments)) / self.length;
        let stiffness = [self.torsion, self.bending[0], self.bending[1]].map(per_segment);
        let rotary = RotarySpring { stiffness, damping: self.damping.rotary(stiffness), rest: Absent };
        let linear = |stiffness: T| self.damping.linear(per_segment(stiffness));
        let rod = self.rod(if k + 1 < count { 1.0 } else { 0.5 } / segments);
        self.extension.link(ElasticHinge { rotary, linear: Absent }, linear, rod)
    }
}

/// How a beam is damped: by a time (s), or [`Absent`].
pub trait Retardation<T: Scalar>: Copy {
    /// Dampers of rotary springs.
    type Rotary: RotaryDamper<T>;
    /// Dampers of linear springs.
    type Linear: Coefficient<T>;
    /// Dampers beside rotary springs of these stiffnesses.
    fn rotary(self, stiffness: [T; 3]) -> Self::Rotary;
    /// A spring of a stiffness with its damper.
    fn linear(self, stiffness: T) -> Spring<T, Self::Linear>;
}

impl<T: Scalar> Retardation<T> for Absent {
    type Rotary = Absent;
    type Linear = Absent;
    fn rotary(self, _: [T; 3]) -> Absent {
        Absent
    }
    fn linear(self, stiffness: T) -> Spring<T> {
        Spring::stiffness(stiffness)
    }
}

impl<T: Scalar> Retardation<T> for T {
    type Rotary = [T; 3];
    type Linear = T;
    fn rotary(self, stiffness: [T; 3]) -> [T; 3] {
        stiffness.map(|k| k * self)
    }
    fn linear(self, stiffness: T) -> Spring<T, T> {
        Spring::stiffness(stiffness).damped(stiffness * self)
    }
}

/// Whether a beam stretches and shears: EA, EA and GA, or [`Absent`].
pub trait Stretch<T: Scalar, D: Retardation<T>>: Copy {
    /// Springs of a segment and the rod outboard of them.
    type Link;
    /// Makes a link, from its rotary springs and what makes linear ones of stiffnesses EA or GA.
    fn link(
        self,
        hinge: ElasticBall<T, D::Rotary>,
        linear: impl Fn(T) -> Spring<T, D::Linear>,
        rod: Rod<T>,
    ) -> Self::Link;
}

impl<T: Scalar, D: Retardation<T>> Stretch<T, D> for Absent {
    type Link = (ElasticBall<T, D::Rotary>, Rod<T>);

    fn link(self, hinge: ElasticBall<T, D::Rotary>, _: impl Fn(T) -> Spring<T, D::Linear>, rod: Rod<T>) -> Self::Link {
        (hinge, rod)
    }
}

/// The slider is along the rod inboard of it.
impl<T: Scalar, D: Retardation<T>> Stretch<T, D> for T {
    type Link = (Prismatic<T, Spring<T, D::Linear>>, ElasticBall<T, D::Rotary>, Rod<T>);

    fn link(
        self,
        hinge: ElasticBall<T, D::Rotary>,
        linear: impl Fn(T) -> Spring<T, D::Linear>,
        rod: Rod<T>,
    ) -> Self::Link {
        let along = [T::one(), T::zero(), T::zero()];
        (Prismatic::along(along).with(linear(self)), hinge, rod)
    }
}

/// A spring of a beam along one axis.
type Along<T, D> = Spring<T, <D as Retardation<T>>::Linear>;

impl<T: Scalar, D: Retardation<T>> Stretch<T, D> for [T; 3] {
    type Link = (ElasticHinge<RotarySpring<T, D::Rotary>, Linear<T, Along<T, D>, Along<T, D>, Along<T, D>>>, Rod<T>);

    fn link(
        self,
        hinge: ElasticBall<T, D::Rotary>,
        linear: impl Fn(T) -> Spring<T, D::Linear>,
        rod: Rod<T>,
    ) -> Self::Link {
        let [x, y, z] = self.map(linear);
        (hinge.with_linear(x, y, z), rod)
    }
}

lift!(Beam<T, E, D> { length, bending, torsion, density, polar, extension, damping });
