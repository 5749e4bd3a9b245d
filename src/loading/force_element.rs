//! Force elements: loads on several bodies that hang on the motions of all of them.

use super::{Function, Load, Loading, Seen, Unloaded, Yields, couples};
use crate::error::Fault;
use crate::lift::Lift;
use crate::relation::{Wrench, WrenchOf};
use crate::scalar::Scalar;
use crate::space::{RealOf, Space};

/// A force element, beside other loads: what acts on some bodies by the time and the motions of all of them, as the gas in a cylinder by the angle of a
/// crank, a magnet, a muscle along several points whose activation is a function of time.
///
/// Its law is told the time (s) and the motions of its bodies, and gives the load on each, as [`Loads::on_bodies`](super::Loads::on_bodies) does. It is evaluated for each of
/// them, and the scene is seen as a whole first, which costs a walk more in each sweep. Rules of all kinds take it as it is: implicit ones do not know
/// its stiffness, so that a step must resolve it ([`Struts`](crate::planar::Struts) says how), and take no [`stiff`](crate::planar::Struts::stiff) struts beside it. Taylor series do not compile. Runs go backward under one whose law is a
/// [`ForceLaw`] of its own ([`by`](Self::by)), by the numbers it is made of.
///
/// ```
/// use catena::planar::*;
/// // A crank, a rod and a piston (0.4 kg), which gas pushes as long as the crank goes one half of each turn.
/// let side = (Slider::along(0.0), RigidBody::new(0.4, 0.01, [0.0; 2], [0.0; 2]));
/// let engine = Network::new((Pin, Rod::uniform(0.1, 1.0), Pin, Rod::uniform(0.3, 0.5)), side, Pin);
/// let scene = System::new(Clamped::origin(), engine, Free)?;
/// let (crank, piston) = (0, 2); // numbers of bodies
/// let gas = ForceElement::between([crank, piston], |_, [crank, piston]: &[BodyMotion<f64>; 2]| {
///     let push = if crank.angle().sin() > 0.0 { -200.0 * crank.angle().sin() } else { 0.0 };
///     [Wrench::default(), piston.force_at([0.0; 2], [push, 0.0])]
/// });
/// let mut guess = scene.motion();
/// guess.set_coordinates(&[1.0, -0.3, 0.35])?;
/// let start = scene.assembled(guess, &gas)?;
/// let end = scene.simulation(Dop853::tolerance(1e-9)).loads(&gas).run(start, 0.05, |_| ())?.motion;
/// assert!(end.rates()[0] > 1.0); // (rad/s)
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ForceElement<F, const N: usize, L = Unloaded> {
    pub(crate) bodies: [usize; N],
    pub(crate) law: F,
    pub(crate) others: L,
}

/// A law of a force element between `N` bodies.
///
/// One that is generic over the scalar and can be lifted ([`lift!`](crate::lift!)) is known to runs that go backward.
pub trait ForceLaw<S: Space, const N: usize> {
    /// The loads on the bodies, at a time (s), by their motions.
    fn loads(&self, time: RealOf<S>, bodies: &[S::BodyMotion; N]) -> [WrenchOf<S>; N];
}

impl<S: Space, F: Fn(RealOf<S>, &[S::BodyMotion; N]) -> [WrenchOf<S>; N], const N: usize> ForceLaw<S, N>
    for Function<F>
{
    fn loads(&self, time: RealOf<S>, bodies: &[S::BodyMotion; N]) -> [WrenchOf<S>; N] {
        (self.0)(time, bodies)
    }
}

impl<F, const N: usize> ForceElement<Function<F>, N> {
    /// A force element between bodies of these numbers, by a function of the time (s) and of their motions, which gives the load on each.
    pub const fn between(bodies: [usize; N], law: F) -> Self {
        Self { bodies, law: Function::new(law), others: Unloaded }
    }
}

impl<F, const N: usize> ForceElement<F, N> {
    /// A force element between bodies of these numbers, by a law.
    pub const fn by(bodies: [usize; N], law: F) -> Self {
        Self { bodies, law, others: Unloaded }
    }

    /// Other loads besides: further force elements, struts, [`Loads`](super::Loads).
    pub fn and<L>(self, others: L) -> ForceElement<F, N, L> {
        let Self { bodies, law, .. } = self;
        ForceElement { bodies, law, others }
    }
}

impl<S, F, L, const N: usize> Loading<S> for ForceElement<F, N, L>
where
    S: Space,
    F: ForceLaw<S, N>,
    L: Loading<S>,
{
    type OnBody = WrenchOf<S>;
    type InJoint = L::InJoint;
    type Seen = ([Option<S::BodyMotion>; N], L::Seen);
    type Responses<V: Clone> = ();
    const ON: bool = true;
    const SURVEYS: bool = true;

    fn nothing() -> (WrenchOf<S>, L::InJoint) {
        const {
            assert!(
                matches!(L::YIELDS, Yields::Never),
                "beside force elements loads do not yield: take contacts as `plain` ones, and struts that are not stiff"
            )
        }
        const { assert!(!couples::<S, L>(), "couplings stand before force elements: `couplings.and(element)`") }
        const {
            assert!(
                !L::BY_COORDINATE,
                "beside force elements joints are numbered from the root's on: take `Loads::efforts`"
            )
        }
        (Wrench::none(), L::nothing().1)
    }
    fn unseen(&self) -> Self::Seen {
        ([const { None }; N], self.others.unseen())
    }
    fn survey(&self, (bodies, others): &mut Self::Seen, body: usize, motion: &S::BodyMotion) {
        for (number, seen) in self.bodies.iter().zip(bodies) {
            if *number == body {
                *seen = Some(motion.unaccelerated());
            }
        }
        if L::SURVEYS {
            self.others.survey(others, body, motion);
        }
    }
    fn on_body(
        &self,
        (bodies, others): &Self::Seen,
        time: RealOf<S>,
        body: usize,
        motion: &S::BodyMotion,
    ) -> WrenchOf<S> {
        let mut sum = if L::ON { self.others.on_body(others, time, body, motion).wrench() } else { Wrench::none() };
        if self.bodies.contains(&body) {
            // All are seen before the first load is asked for.
            let loads = self.law.loads(time, &bodies.map(|seen| seen.unwrap_or(*motion)));
            for (_, load) in self.bodies.iter().zip(loads).filter(|(number, _)| **number == body) {
                sum = sum + load;
            }
        }
        sum
    }
    fn in_joint(&self, time: RealOf<S>, joint: usize, motion: &S::JointMotion) -> L::InJoint {
        self.others.in_joint(time, joint, motion)
    }
    fn check(&self, bodies: usize, joints: usize) -> Result<(), Fault> {
        let beyond = self.bodies.into_iter().find(|body| *body >= bodies);
        beyond.map_or(Ok(()), |body| Err(Fault::NoSuchBody { body, bodies }))?;
        self.others.check(bodies, joints)
    }
}

impl<T: Scalar, U: Scalar, F: Lift<T, U>, L: Lift<T, U>, const N: usize> Lift<T, U> for ForceElement<F, N, L> {
    type Over = ForceElement<F::Over, N, L::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        ForceElement { bodies: self.bodies, law: self.law.lift(number), others: self.others.lift(number) }
    }
}
