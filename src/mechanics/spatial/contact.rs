//! Points of bodies that touch a surface: unilateral, compliant contact with friction.

use super::body_axes::{Block, Yielding};
use super::surface::Surface;
use super::{BodyMotion, Wrench};
use crate::error::Fault;
use crate::error::checks::{finite, not_negative, positive};
use crate::lift::lift;
use crate::loading::LoadLaw;
use crate::relation::Additive;
use crate::relation::spatial::algebra::{cross, dot};
use crate::scalar::Scalar;
use crate::spring::{Compression, above};
use nalgebra::Vector3;

/// How what touches resists: compliance, damping, friction.
///
/// Pressed in by x (m) a point is pushed out by N = k d(x) (1 + c ẋ), and never pulled (K. H. Hunt and F. R. E. Crossley, 1975), with
/// a stiffness k (N/m) that sets in over a depth w (m) as that of [`Stops`](crate::spatial::Stops), and damping c (s/m). Friction is
/// −μ N v/√(v² + v₀²) of the velocity v along the surface: it has no jump, so that at rest what pulls by P creeps, by about v₀ P/(μ N).
/// On planes energy only falls; on curved [`Heights`](super::Heights) to the order of depth times curvature.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Contact<T> {
    stiffness: T,
    depth: T,
    damping: T,
    friction: T,
    speed: T,
}

impl<T: Scalar> Contact<T> {
    /// Of a stiffness (N/m) that sets in over a depth (m), without damping and friction.
    pub fn new(stiffness: T, depth: T) -> Self {
        Self { stiffness, depth, damping: T::zero(), friction: T::zero(), speed: T::one() }
    }

    /// With damping c (s/m).
    #[must_use]
    pub fn damped(self, damping: T) -> Self {
        Self { damping, ..self }
    }

    /// With a coefficient of friction μ, which sets in over a speed v₀ (m/s).
    #[must_use]
    pub fn rubbing(self, friction: T, speed: T) -> Self {
        Self { friction, speed, ..self }
    }

    fn check(&self) -> Result<(), Fault> {
        not_negative("stiffness of a contact", self.stiffness)?;
        positive("depth over which a contact sets in", self.depth)?;
        not_negative("damping of a contact", self.damping)?;
        not_negative("coefficient of friction", self.friction)?;
        positive("speed over which friction sets in", self.speed)
    }
}

lift!(Contact { stiffness, depth, damping, friction, speed });

/// Points of bodies that may touch a surface, as a load on these: for links of a [`robot`](crate::robot).
///
/// Each point is the number of a body and a place on it (m, body axes from the inboard end). Implicit rules take contacts linearly
/// implicitly, as springs of joints. Slopes leave out how friction grows with the normal force, and how the normal turns, and that friction
/// levels off along the way of sliding, for which they take the secant, μ N/√(v² + v₀²); sweeps converge to the forces themselves, but
/// slowly between v₀ and 3 v₀. By [`Sdirk4`](crate::time::Sdirk4) feet stand at steps that resolve neither the
/// stiffness nor friction at rest; by `GeneralizedAlpha`, which remembers accelerations, they chatter there. Explicit rules are
/// stable below some 2.8 √(m/k) and 2.8 m v₀/(μ N), with the mass m that a point moves. In body axes loads see complete kinematics, which
/// costs a walk more in each sweep.
///
/// On bodies of [`spatial`](crate::spatial) in inertial axes they act as [`plain`](Self::plain) loads only.
///
/// ```
/// use catena::robot::*;
/// let inertia = [[0.01, 0.0, 0.0], [0.0, 0.01, 0.0], [0.0, 0.0, 0.01]];
/// let body = Link::general(1.0_f64, [0.0, 0.0, 0.3], inertia); // slides along the vertical
/// let hopper = System::new(Base::origin(), (Slide::level(), body), Free)?.with_gravity([0.0, 0.0, -9.81]);
/// let law = Contact::new(1e4, 1e-4).damped(2.0).rubbing(0.7, 0.01); // (N/m), (m), (s/m), (m/s)
/// let contacts = Contacts::of([(0, [0.0, 0.0, 0.0])], Plane::level(-0.1), law); // the origin of body 0
/// let rule = Sdirk4::new().tolerance(1e-6);
/// let run = hopper.simulation(rule).loads(&Loads::none().on_bodies_by(contacts)).run(hopper.motion(), 3.0, |_| ())?;
/// let bodies = hopper.body_motions(&run.motion)?;
/// let body = bodies.get(0).unwrap();
/// assert!((contacts.force(0, body)[2] - 9.81).abs() < 1e-2); // it stands
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Contacts<P, G, C> {
    points: P,
    surface: G,
    law: C,
}

/// [`Contacts`] as loads that do not say how they yield: for bodies in inertial axes, too.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct PlainContacts<P, G, C>(Contacts<P, G, C>);

lift!(Contacts<P, G, C> { points, surface, law });
lift!(PlainContacts < P, G, C > { 0 });

impl<P, G, C> Contacts<P, G, C> {
    /// These points, this surface.
    pub const fn of(points: P, surface: G, law: C) -> Self {
        Self { points, surface, law }
    }

    /// As loads of which implicit rules know no slope. They are read where the geometry of a sweep is, and steps must resolve them.
    pub fn plain(self) -> PlainContacts<P, G, C> {
        PlainContacts(self)
    }
}

/// What a point meets.
struct Touch<T> {
    force: Vector3<T>,
    normal: Vector3<T>,
    stiffness: T,
    /// Along the normal, and across it.
    damping: [T; 2],
}

impl<P, G, T: Scalar> Contacts<P, G, Contact<T>>
where
    P: AsRef<[(usize, [T; 3])]>,
    G: Surface<T>,
{
    /// The force (N, inertial axes) on a point, from the motion of the body that it is on; zero where there is no such point.
    pub fn force(&self, point: usize, body: &BodyMotion<T>) -> [T; 3] {
        let of = |(_, at): &(usize, [T; 3])| self.touch(*at, body).force.into();
        self.points.as_ref().get(point).map_or([T::zero(); 3], of)
    }

    /// The energy (J) stored at a point; zero where there is no such point. On planes it is the potential of the force without damping and
    /// friction; on curved [`Heights`](super::Heights) to the order of depth times curvature.
    pub fn energy(&self, point: usize, body: &BodyMotion<T>) -> T {
        let of = |(_, at): &(usize, [T; 3])| {
            let (below, _) = self.surface.below(body.point(*at).place.into());
            self.law.stiffness * Compression::of(below, self.law.depth).energy()
        };
        self.points.as_ref().get(point).map_or(T::zero(), of)
    }

    /// The points.
    pub fn points(&self) -> &[(usize, [T; 3])] {
        self.points.as_ref()
    }

    #[cfg_attr(optimised, inline(always))]
    fn touch(&self, at: [T; 3], body: &BodyMotion<T>) -> Touch<T> {
        let Contact { stiffness, depth, damping, friction, speed } = self.law;
        // Of a point only place and velocity are asked for.
        let arm = body.turned(at);
        let velocity = body.inboard.velocity + cross(body.inboard.turn.spin, arm);
        let (below, normal) = self.surface.below((body.inboard.place + arm).into());
        let normal = Vector3::from(normal);
        let (pressed, closing) = (Compression::of(below, depth), -dot(velocity, normal));
        let push = above(damping.mul_add(closing, T::one()));
        let elastic = stiffness * pressed.force();
        let whole = elastic * push;
        let sliding = velocity + normal * closing;
        let across = friction * whole / (dot(sliding, sliding) + speed * speed).sqrt();
        Touch {
            force: normal * whole - sliding * across,
            normal,
            stiffness: stiffness * pressed.stiffness() * push,
            damping: [elastic * damping * push.sign(), across],
        }
    }

    /// Sums up what the points of a body meet.
    #[inline(always)]
    fn each<X: Additive>(&self, number: usize, each: impl Fn([T; 3]) -> X) -> X {
        let own = self.points.as_ref().iter().filter(|(body, _)| *body == number);
        own.fold(X::null(), |sum, (_, at)| sum + each(*at))
    }

    fn fits(&self, bodies: usize) -> Result<(), Fault> {
        self.law.check()?;
        self.surface.check()?;
        self.points.as_ref().iter().try_for_each(|(_, at)| finite("point of a contact", at))?;
        match self.points.as_ref().iter().find(|(body, _)| *body >= bodies) {
            Some((body, _)) => Err(Fault::NoSuchBody { body: *body, bodies }),
            None => Ok(()),
        }
    }
}

impl<P, G, T: Scalar> LoadLaw<BodyMotion<T>> for Contacts<P, G, Contact<T>>
where
    P: AsRef<[(usize, [T; 3])]>,
    G: Surface<T>,
{
    type Value = Yielding<T>;

    #[cfg_attr(optimised, inline(always))]
    fn at(&self, _: T::Real, number: usize, body: &BodyMotion<T>) -> Yielding<T> {
        self.each(number, |at| {
            let Touch { force, normal, stiffness, damping: [along, across] } = self.touch(at, body);
            let (point, normal) = (Vector3::from(at), body.inboard.turn.attitude.transposed(normal));
            let stiffness = Block::at(point, normal, stiffness, T::zero());
            Yielding::new(body.force_at(at, force.into()), stiffness, Block::at(point, normal, along, across))
        })
    }
    fn check(&self, bodies: usize) -> Result<(), Fault> {
        self.fits(bodies)
    }
}

impl<P, G, T: Scalar> LoadLaw<BodyMotion<T>> for PlainContacts<P, G, Contact<T>>
where
    P: AsRef<[(usize, [T; 3])]>,
    G: Surface<T>,
{
    type Value = Wrench<T>;

    #[inline(always)]
    fn at(&self, _: T::Real, number: usize, body: &BodyMotion<T>) -> Wrench<T> {
        self.0.each(number, |at| body.force_at(at, self.0.touch(at, body).force.into()))
    }
    fn check(&self, bodies: usize) -> Result<(), Fault> {
        self.0.fits(bodies)
    }
}
