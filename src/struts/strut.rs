//! A spring and damper between two points.

use crate::lift::Lift;
use crate::relation::Absent;
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use nalgebra::SVector;

/// An end of a strut: a point of a body (its number, and the point in its axes from its inboard end), or of the ground (m).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(serialize = "[T; D]: serde::Serialize", deserialize = "[T; D]: serde::Deserialize<'de>"))
)]
pub(crate) enum End<T, const D: usize> {
    Body(usize, [T; D]),
    Ground([T; D]),
}

/// Which way a strut acts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(crate) enum Acts {
    /// A strut that pulls and pushes.
    #[default]
    Both,
    /// A rope: a strut that pulls alone, where it is longer than its length.
    Pulls,
    /// A buffer: a strut that pushes alone, where it is shorter.
    Pushes,
}

/// A massless spring and damper between two points. Its force acts along the line between them: k (ℓ − ℓ₀) + c ℓ̇ pulls the ends
/// together. Where they meet the line has no direction: a strut with a length, a damper or a law must keep them apart, or its force is NaN, which
/// sweeps refuse as [`NonFiniteLoad`](crate::Fault::NonFiniteLoad) at a body where it ends. What else acts between them a [law](Self::with_law) says. [`Struts::readings`](super::Struts::readings) tells lengths, tensions and energies.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0);
/// let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
/// // From the middle of the first rod to the tip of the second, and from there to the ground.
/// let inside = Strut::between((0, [0.5, 0.0]), (1, [1.0, 0.0])).with_stiffness(40.0).with_length(1.0);
/// let outside = Strut::to_ground((1, [1.0, 0.0]), [2.5, 0.0]).with_stiffness(20.0).with_damping(0.5);
/// let loads = Struts::of([inside, outside]);
/// let start = scene.at_rest(&[0.0, 0.3])?;
/// let run = scene.simulation(Dop853::tolerance(1e-10)).loads(&loads).run(start, 1.0, |_| ())?;
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "[T; D]: serde::Serialize, T: serde::Serialize, W: serde::Serialize",
        deserialize = "[T; D]: serde::Deserialize<'de>, T: serde::Deserialize<'de>, W: serde::Deserialize<'de>"
    ))
)]
pub struct Strut<T, const D: usize, W = Absent> {
    pub(crate) ends: [End<T, D>; 2],
    pub(crate) stiffness: T,
    pub(crate) damping: T,
    pub(crate) length: T,
    pub(crate) acts: Acts,
    pub(crate) law: W,
}

impl<T: Scalar, const D: usize> Strut<T, D> {
    /// Between points of two bodies: the number of each, and the point in its axes from its inboard end (m).
    pub fn between((body, at): (usize, [T; D]), (other, there): (usize, [T; D])) -> Self {
        Self::new(End::Body(body, at), End::Body(other, there))
    }

    /// Between a point of a body and a place in inertial axes (m): it stays where it is where the ground of the scene moves.
    pub fn to_ground((body, at): (usize, [T; D]), place: [T; D]) -> Self {
        Self::new(End::Body(body, at), End::Ground(place))
    }

    fn new(from: End<T, D>, to: End<T, D>) -> Self {
        let none = T::zero();
        Self { ends: [from, to], stiffness: none, damping: none, length: none, acts: Acts::Both, law: Absent }
    }

    /// With a law between its ends besides, one of the user's own for example: the coordinate of the [`SpringLaw`] is their distance ℓ (m), its rate ℓ̇ (m/s) how
    /// fast they part, and its force (N) pushes them apart. A strut that only pulls or pushes does so by the
    /// sum of all that acts in it, on its side of its [length](Self::with_length). Struts of one array have laws of one type; where they differ, take an enum, or
    /// one array beside another: `Struts::of(..).and(Struts::of(..))`. Gradients backward, and struts that are [stiff](super::Struts::stiff), take one array; gradients know [`Spring`](crate::planar::Spring),
    /// [`Stops`](crate::planar::Stops), tuples of such, and laws of the user's own as [`Custom`](crate::planar::Custom).
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::{Fault, Scalar};
    ///
    /// /// A shock absorber that resists less where it is pressed together: −c ℓ̇ with one damping (N·s/m) for each way.
    /// #[derive(Clone, Copy, Debug)]
    /// struct Absorber<T> {
    ///     pressed: T,
    ///     drawn: T,
    /// }
    /// catena::lift!(Absorber<T> { pressed, drawn });
    ///
    /// impl<T: Scalar> SpringLaw<T> for Absorber<T> {
    ///     fn force(&self, _: T, rate: T) -> T {
    ///         -rate.if_negative(self.pressed, self.drawn) * rate
    ///     }
    ///     fn energy(&self, _: T) -> T {
    ///         T::zero()
    ///     }
    ///     fn pivot(&self, _: T, rate: T, springs: impl Springs<T>) -> T {
    ///         springs.pivot(T::zero(), rate.if_negative(self.pressed, self.drawn))
    ///     }
    ///     fn check(&self) -> Result<(), Fault> {
    ///         if self.pressed.is_finite() && self.drawn.is_finite() { Ok(()) } else { Err(Fault::NotFinite { parameter: "absorber" }) }
    ///     }
    /// }
    ///
    /// let arm = Rod::uniform(0.4, 12.0);
    /// let scene = System::new(Pinned::origin(), arm, Free)?.with_gravity(9.81);
    /// let leg = Strut::to_ground((0, [0.35, 0.0]), [0.3, 0.5]).with_stiffness(8e3).with_length(0.45);
    /// let struts = Struts::of([leg.with_law(Absorber { pressed: 300.0, drawn: 900.0 })]);
    /// let run = scene.simulation(Dop853::tolerance(1e-9)).loads(&struts).run(scene.at_rest(&[0.2])?, 2.0, |_| ())?;
    /// let rest = scene.equilibrium(run.motion, &struts)?;
    /// assert!((run.motion.coordinates()[0] - rest.coordinates()[0]).abs() < 1e-4);
    /// # Ok::<(), catena::Error>(())
    /// ```
    #[must_use]
    pub fn with_law<W: SpringLaw<T>>(self, law: W) -> Strut<T, D, W> {
        let Self { ends, stiffness, damping, length, acts, .. } = self;
        Strut { ends, stiffness, damping, length, acts, law }
    }
}

impl<T: Scalar, const D: usize, W: SpringLaw<T>> Strut<T, D, W> {
    /// With a stiffness (N/m).
    #[must_use]
    pub fn with_stiffness(self, stiffness: T) -> Self {
        Self { stiffness, ..self }
    }

    /// With a damping (N·s/m).
    #[must_use]
    pub fn with_damping(self, damping: T) -> Self {
        Self { damping, ..self }
    }

    /// With a length (m) at which the spring does not pull; else it always does.
    #[must_use]
    pub fn with_length(self, length: T) -> Self {
        Self { length, ..self }
    }

    /// This strut as a rope: it only pulls, its damper too, and hangs slack where it is shorter than its length. Where it becomes taut its force has a
    /// kink, and with a damper a jump, by c ℓ̇. Error control shortens steps there, but may overlook a vibration that is over within a step: then errors are
    /// thousands of times the tolerance, once in ten to a hundred runs of a block that bounces. [`kinks`](crate::simulate::Simulation::kinks) of a run tell
    /// it. A damper that brings the tension to zero lets go before the rope is short, which is another kink. Derivatives do not know how the instant
    /// of a jump changes: gradients backward through one are refused, and those over jets wrong; so they are where a law begins with a force. Steps of a fixed size that are
    /// longer than the vibration of a [stiff](super::Struts::stiff) rope throw back what it catches; `MoreauJean`, and `Sdirk4` under error control, catch
    /// it: a block of 2 kg that falls by half a metre into 1e8 N/m and 1e5 N·s/m takes 42 steps for 2 s to 1e-4, where `Dop853` takes 11 395.
    ///
    /// ```
    /// use catena::planar::*;
    /// // A block on a rope, above where that is taut: it falls freely.
    /// let block = RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
    /// let scene = System::new(Clamped::origin(), (Slider::along(core::f64::consts::FRAC_PI_2), block), Free)?.with_gravity(9.81);
    /// let rope = Struts::of([Strut::to_ground((0, [0.0; 2]), [0.0, 1.0]).with_stiffness(1e4).with_length(2.0).pulling()]);
    /// let run = scene.simulation(Dop853::tolerance(1e-10)).loads(&rope).run(scene.motion(), 0.3, |_| ())?;
    /// let expected: f64 = -0.5 * 9.81 * 0.09;
    /// assert!((run.motion.coordinates()[0] - expected).abs() < 1e-12);
    /// # Ok::<(), catena::Error>(())
    /// ```
    #[must_use]
    pub fn pulling(self) -> Self {
        Self { acts: Acts::Pulls, ..self }
    }

    /// This strut as a buffer: it only pushes, its damper too, where it is shorter than its length, which it needs. Its force has a kink as that of a [rope](Self::pulling).
    #[must_use]
    pub fn pushing(self) -> Self {
        Self { acts: Acts::Pushes, ..self }
    }

    /// A number, or zero where a strut with this stretch (m) and tension (N) does not act.
    pub(crate) fn acting(&self, stretch: T, tension: T, x: T) -> T {
        match self.acts {
            Acts::Both => x,
            Acts::Pulls => stretch.if_negative(T::zero(), tension.if_negative(T::zero(), x)),
            Acts::Pushes => (-stretch).if_negative(T::zero(), (-tension).if_negative(T::zero(), x)),
        }
    }

    /// The last body that it ends at.
    pub(super) fn last_body(&self) -> Option<usize> {
        let body = |end: &End<T, D>| if let End::Body(k, _) = end { Some(*k) } else { None };
        let [from, to] = self.ends.each_ref().map(body);
        from.max(to)
    }

    /// Energy stored (J), for the places of its ends (m); none where a rope is slack, or a buffer is not pressed.
    pub fn energy(&self, from: SVector<T, D>, to: SVector<T, D>) -> T {
        let (apart, half) = (to - from, crate::scalar::Real::of(0.5));
        if !W::ON && is_absent(self.length) && self.acts == Acts::Both {
            return (self.stiffness * dot(apart, apart)).scale(half);
        }
        let stretch = norm(apart) - self.length;
        let energy = (self.stiffness * stretch * stretch).scale(half);
        let energy = if W::ON { energy + self.law.energy(norm(apart)) } else { energy };
        let tension = if W::ON { self.tension(norm(apart), T::zero()) } else { stretch };
        self.acting(stretch, tension, energy)
    }

    /// Force (N) on the strut's first end, for place and velocity of both.
    pub(crate) fn force(&self, ends: [[SVector<T, D>; 2]; 2]) -> SVector<T, D> {
        // A spring without length and a damper that is not there have no need of a direction: their ends may meet.
        if self.has_no_direction() {
            return (ends[1][0] - ends[0][0]) * self.stiffness;
        }
        let (direction, far, rate) = line(ends);
        let tension = self.tension(far, rate);
        direction * self.acting(far - self.length, tension, tension)
    }

    /// Force (N) that draws its ends together at a distance (m) and a rate (m/s) of them, if it acts.
    pub(crate) fn tension(&self, far: T, rate: T) -> T {
        let tension = self.damping.mul_add(rate, self.stiffness * (far - self.length));
        if W::ON { tension - self.law.force(far, rate) } else { tension }
    }

    /// Whether the force of this strut is in proportion to how far its ends are apart, so that they may meet.
    pub(crate) fn has_no_direction(&self) -> bool {
        !W::ON
            && is_absent(self.damping)
            && (is_absent(self.stiffness) || (is_absent(self.length) && self.acts != Acts::Pushes))
    }
}

/// The line between two ends, for place and velocity of both: its direction, its length (m) and how fast that grows (m/s).
pub(super) fn line<T: Scalar, const D: usize>([from, to]: [[SVector<T, D>; 2]; 2]) -> (SVector<T, D>, T, T) {
    let apart = to[0] - from[0];
    let far = norm(apart);
    let direction = apart * far.recip();
    (direction, far, dot(direction, to[1] - from[1]))
}

/// Whether a parameter is zero, and all its derivatives: one that is zero where something is differentiated by it acts.
pub(crate) fn is_absent<T: Scalar>(x: T) -> bool {
    x.is_identical(T::zero())
}

pub(crate) fn dot<T: Scalar, const D: usize>(a: SVector<T, D>, b: SVector<T, D>) -> T {
    a.iter().zip(b.iter()).fold(T::zero(), |sum, (a, b)| a.mul_add(*b, sum))
}

pub(crate) fn norm<T: Scalar, const D: usize>(a: SVector<T, D>) -> T {
    dot(a, a).sqrt()
}

impl<T: Scalar, U: Scalar, const D: usize, W: Lift<T, U>> Lift<T, U> for Strut<T, D, W> {
    type Over = Strut<U, D, W::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        let ends = self.ends.map(|end| match end {
            End::Body(k, at) => End::Body(k, at.map(&mut *number)),
            End::Ground(place) => End::Ground(place.map(&mut *number)),
        });
        let [stiffness, damping, length] = [self.stiffness, self.damping, self.length].map(&mut *number);
        Strut { ends, stiffness, damping, length, acts: self.acts, law: self.law.lift(number) }
    }
}
