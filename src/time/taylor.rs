//! Taylor series of a motion.

use super::{Control, Rule};

/// Taylor series of order up to `P`, from 8 to 30, through kept gains: for chains and trees that move smoothly.
///
/// Coefficients of all orders satisfy the linear equations of accelerations with other right-hand sides. So a step takes one sine, one
/// elimination and one division a body, and then two short walks for each order; it tells how long it may be before it is made, and is
/// hardly ever rejected. A series counts as one sweep; where a tip is held or a loop closed, one more goes to each projection.
///
/// It knows rods, rigid bodies, point masses, pins, welds, sliders and rotary springs and dampers of the plane, and rods, rigid bodies, point
/// masses, balls, welds, revolute and prismatic joints with springs and dampers of space, in tuples, arrays, vectors and branches, on ground that
/// rests, with a free tip or one that `Pinned` or `Clamped`, in the plane `Guided`, in space `Hinged` holds to ground that rests, and around
/// loops that a `Pin` or a `Weld` of the plane closes, or of space a `Weld`, or a `Ball` where no efforts act; under gravity and efforts in
/// joints: values held over a step ([`Loads::efforts`](crate::loading::Loads::efforts)), or functions of time
/// ([`TimeLaw`](crate::loading::TimeLaw)). Laws along these coordinates may be [`DryFriction`](crate::planar::DryFriction) or of the user's own
/// if they are [analytic](crate::planar::SpringLaw::ANALYTIC) and written for any number. What it does not know does not compile: loops that others close, `LeastNorm` among them, tips
/// held to ground that moves, linear springs of hinges, elastic balls, loads that see the motion other than by laws along coordinates.
/// [`Taylor::knows`] makes the compiler say which of these it is.
///
/// Positions within a step are polynomials of an order one higher, and so is what is sampled.
///
/// `P` is the order of steps of a fixed size. Under error control it is the highest: the tolerance chooses the order, 8 at 1e-3, 11 at
/// 1e-5, 14 at 1e-7, 17 at 1e-9, 21 at 1e-11, 24 at 1e-13, so that `Taylor::<24>` suits any. Orders not taken cost room, no time.
///
/// In space a stepper has room for 24 `P` numbers for each body and joint: 0.2 MB for twenty rods on balls at `P` = 24. Vectors have it on
/// the heap, arrays on the stack, of which builds that are not optimised take many times as much.
///
/// In space steps are also so short that no ball turns by half a turn in one of them, where [coordinates of steps](crate::spatial::Rotation)
/// end: a fast top takes some four steps a turn. One of a given size that may turn farther, by the sum of the sizes of all terms (from 100° of
/// a steady turn on), is refused as not finite.
///
/// Where closures come to depend on each other (dead points) series lose what stages keep: steps over such places are made by those of
/// [`Dop853`](super::Dop853), of the same size where it is given. One that they cannot make is refused by the name of a closure.
///
/// Orders within three of these cost a tenth more time at most; 12 instead of 24 at 1e-13 costs 60 %. Steps of a given size that are longer
/// than the series reaches diverge.
///
/// How many times the time of a run by [`Dop853`](super::Dop853) is that of one by this rule, for the same error of the last coordinate
/// (x86-64-v3; all in one run of one program):
///
/// | error (rad, m) | 1e-3 | 1e-6 | 1e-9 | 1e-12 |
/// |---|---|---|---|---|
/// | two rods on pins, a tuple, released from the horizontal, 2 s | 1.2 | 1.2 | 1.9 | |
/// | twenty rods, an array, 0.5 s | 1.4 | 1.5 | 2.0 | 2.8 |
/// | four sliders and pins in a tree of four bodies, 1 s | 1.1 | 0.8 | 1.2 | 1.3 |
/// | the two rods, driven by a sine of time in each joint | 0.4 | 0.6 | 0.8 | 1.1 |
/// | three rods on balls, an array, 1 s | 1.2 | 1.2 | 1.5 | 2.4 |
/// | the three rods, driven by sines of time about all axes | 1.0 | 1.2 | 1.6 | 1.7 |
/// | twenty rods on balls, an array, 0.5 s | | 1.1 | 1.2 | 1.4 |
/// | three rigid bodies on balls, an array, 1 s | 0.9 | 0.9 | 1.3 | 1.6 |
/// | six rigid bodies on revolute joints, an array, 1 s | 0.7 | 0.9 | 1.0 | 1.4 |
/// | the six, driven by a sine of time in each joint | | 0.5 | 0.7 | 1.0 |
/// | a four-bar linkage, 1 s (error of all coordinates) | | 1.2 | 1.5 | 2.1 |
/// | three rods on balls to a tip that is held, 1 s (likewise) | | 1.8 | 1.7 | 2.4 |
///
/// Functions of time are dear: each of their operations is one on series, in every joint, at every step; those on polynomials of time,
/// a phase `w * t` among them, take few products. Laws that are not linear are dearer, for what they make of the motion is found anew for every
/// order: with one cubic spring between the two rods 0.2 to 0.4 instead of 1.2 to 1.9, with friction there a sixth. Sliders have twice the
/// convolutions of pins, rigid bodies in space three times those of rods: on the default target they take 1.3 to 2.4 times
/// the time of a run by `Dop853`, while rods on balls keep their gain.
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0_f64, 1.0);
/// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
/// let start = pendulum.at_rest(&[-1.0, -0.5])?;
/// let series = pendulum.simulate(start, Taylor::<24>::tolerance(1e-11), 1.0, |_| ())?;
/// let other = pendulum.simulate(start, Dop853::tolerance(1e-11), 1.0, |_| ())?;
/// let differ = series.motion.position().1.1 - other.motion.position().1.1;
/// assert!(differ.abs() < 1e-9 && series.rejected == 0);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// A law with cases has no series, and a run does not compile:
///
/// ```compile_fail,E0080
/// use catena::planar::*;
/// let (rod, stops) = (Rod::uniform(0.5, 1.0), Stops::between([-0.3, 2.0], 2e3, 0.02));
/// let leg = System::new(Pinned::origin(), (rod, ElasticHinge::with(stops), rod), Free)?;
/// let run = leg.simulate(leg.at_rest(&[0.0, 0.2])?, Taylor::<12>::tolerance(1e-6), 2.0, |_| ())?;
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Taylor<const P: usize>;

impl<const P: usize> Taylor<P> {
    /// Whether there is such an order: fewer coefficients tell no radius, more are lost in rounding.
    pub(crate) const KNOWN: () = assert!(P >= 8 && P <= 30, "a Taylor series has an order from 8 to 30");

    /// Steps of a fixed size (s), of order `P`.
    pub fn step<R>(size: R) -> Rule<Self, R> {
        const { Self::KNOWN };
        Rule { method: Self, control: Control::Fixed(size) }
    }
    /// Steps that keep the error of each within a tolerance, absolute (rad, m) and relative, of the order that it asks for, up to `P`.
    pub fn tolerance<R>(tolerance: R) -> Rule<Self, R> {
        const { Self::KNOWN };
        Rule { method: Self, control: Control::Tolerance(tolerance) }
    }
}
