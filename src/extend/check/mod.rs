//! A test for elements of one's own: what a scene says in one way against what it says in another.

mod census;
mod parameters;
mod trial;

use crate::element::{Element, Space, SpaceOver, Unloaded};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::lift::Lift;
use crate::mirror::{Position, Rate};
use crate::scalar::Jet;
use crate::system::{Inertial, Runs, StiffDynamics, System};
use crate::transfer::Exact;
use core::fmt;
use trial::Trial;

/// What two ways of saying the same thing disagree about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disagreement {
    /// What was compared, and what is likely to be wrong.
    pub what: &'static str,
    /// What one way says,
    pub found: f64,
    /// and what the other does.
    pub expected: f64,
    /// In which of the random states.
    pub trial: usize,
    /// Of which coordinate, where there are several.
    pub coordinate: usize,
}

impl fmt::Display for Disagreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, found, expected, trial, coordinate } = self;
        write!(f, "{what}: {found:e} instead of {expected:e} (state {trial}, coordinate {coordinate})")
    }
}

impl core::error::Error for Disagreement {}

/// Why a check did not pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Doubt {
    /// Two ways of saying the same thing disagree.
    Disagreement(Disagreement),
    /// A sweep fails.
    Failure(Error),
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Disagreement(disagreement) => disagreement.fmt(f),
            Self::Failure(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for Doubt {}

impl From<Error> for Doubt {
    fn from(error: Error) -> Self {
        Self::Failure(error)
    }
}

/// In so many of the first states derivatives by each number are looked at.
const PARAMETERS: usize = 2;

/// One derivative.
type Dual = Jet<f64, 1>;
/// A scene over numbers with one derivative.
type Over<X> = <X as Lift<f64, Dual>>::Over;
/// The scene over numbers with one derivative.
type Varied<S, R, C, P> = System<<S as SpaceOver<Dual>>::Over, Over<R>, Over<C>, Over<P>>;

/// Compares, at random states of a scene, what its elements say in different ways:
///
/// * accelerations of a sweep with the balance of virtual power, of bodies as they move and joints as they describe themselves: gains
///   that do not match an elimination, forces that are not the law's;
/// * the same after an implicit sweep, whose springs move with the accelerations sought: pivots, but for those of joints with more than
///   two coordinates, which may be no more than near;
/// * an explicit sweep with an implicit one whose springs move with nothing: pivots that do not grow in proportion to what springs move by;
/// * the rate of energy with the power of dampers, where neither ground nor drives move: energies, reflected inertia, velocities that are
///   no derivatives of places;
/// * slopes of laws with derivatives of forces;
/// * the force at the root with that by transfer matrices, where the scene has them;
/// * derivatives by jets with differences: by positions and rates, and, of accelerations and energy, by each number that the scene is made of.
///
/// Put the element into a scene in which all of its sides matter: bodies inboard and outboard of it, a joint beyond, gravity. The tip must
/// be free, and no loop closed: such scenes are refused.
///
/// ```
/// use catena::extend::check_element;
/// use catena::planar::*;
/// let (rod, plate) = (Rod::uniform(0.7_f64, 1.0), RigidBody::new(0.9, 0.05, [0.3, 0.1], [0.7, -0.2]));
/// let hinge = ElasticHinge::rotary(20.0).damped(0.1);
/// let scene = System::new(Pinned::origin(), (plate, hinge, plate, Pin, rod), Free)?.with_gravity(9.81);
/// assert_eq!(check_element(&scene, 10), Ok(()));
/// # Ok::<(), catena::Error>(())
/// ```
///
/// # Errors
/// The first [`Disagreement`], or why a sweep fails; [`Fault::Unsupported`] for a scene that closures hold together, and [`Fault::NotPositive`] for no trials.
pub fn check_element<S, R, C, P, const N: usize>(scene: &System<S, R, C, P>, trials: usize) -> Result<(), Doubt>
where
    S: Inertial + Exact<N> + Space<Scalar = f64> + SpaceOver<Dual>,
    R: Root<S> + Lift<f64, Dual, Over: Root<S::Over>>,
    C: Element<S> + Lift<f64, Dual, Over: Element<S::Over>>,
    P: Tip<S> + Lift<f64, Dual, Over: Tip<S::Over>>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P> + StiffDynamics<Unloaded>,
    Varied<S, R, C, P>: Runs<Unloaded, S::Over, Over<R>, Over<C>, Over<P>>,
{
    if System::<S, R, C, P>::CLOSED > 0 {
        return Err(
            Error::new(Fault::Unsupported { what: "a check of elements whose tip is held, or in a loop" }).into()
        );
    }
    if trials == 0 {
        return Err(Error::new(Fault::NotPositive { parameter: "number of trials", value: 0.0 }).into());
    }
    let varied = scene.lift(Dual::of);
    let mut noise = Noise(0x9e37_79b9_7f4a_7c15);
    for trial in 0..trials {
        let mut motion = scene.motion();
        let mut random = |size: f64| {
            let mut step = motion.rate.clone();
            step.replace(&mut |_| size * noise.next());
            step
        };
        let [step, rate, along] = [0.9, 1.5, 1.0].map(&mut random);
        motion.position.displace(&step);
        motion.rate = rate;
        let motion = scene.with_accelerations(motion, &Unloaded)?;
        let at = Trial { scene, varied: &varied, motion: &motion, trial };
        at.power::<N>(
            "sweep against virtual power: a gain that does not match, or a force that is not the law's",
            None,
        )?;
        at.implicit::<N>()?;
        at.unmoved(&along)?;
        at.energy()?;
        at.slopes()?;
        at.matrices::<N>()?;
        at.derivatives(&along)?;
        if trial < PARAMETERS {
            at.parameters()?;
        }
    }
    Ok(())
}

/// Numbers in −1 .. 1 without any pattern: a linear congruential generator, upper bits.
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}
