//! Joints turned, or made to turn, so that their outboard bodies have orientations and angular velocities wanted.

use crate::error::{Error, Fault};
use crate::mirror::Position;
use crate::scalar::{Elementary, Real};
use crate::shape::{
    AtBody, AtClosing, AtJoint, Body, Closing, Joint, Mut, Outward, Positions, Rates, Shape, Walk, alike,
};
use crate::space::{RealOf, Space};
use crate::turning::{Axes, Turning, length, minus, outboard, plus};

/// A joint that turns its outboard body.
pub struct Swivel<S: Space> {
    /// Number of the joint among joints.
    pub joint: usize,
    /// Number of coordinates by which the joint turns.
    pub freedoms: usize,
    /// The body inboard of the joint.
    pub inboard: S::Turn,
    /// The body outboard of the joint, as it moves so far.
    pub outboard: S::Turn,
}

/// What is wanted of a joint.
pub enum Wanted<S: Turning> {
    /// Nothing.
    Any,
    /// Angular velocity of the outboard body (rad/s), inertial axes.
    Spin([S::Scalar; 3]),
    /// Rates that the joint's turning coordinates would have on an inboard body at rest (rad/s), as many as there are.
    Relative([S::Scalar; 3]),
    /// Orientation of the outboard body.
    Orientation(S::Orientation),
}

/// Asks for each joint that turns what is wanted, root to tip, and gives it coordinates or rates for that. Other joints and other
/// coordinates stay as they are.
///
/// # Errors
/// [`Fault::ImpossibleTurn`] where a joint cannot do so, at its station counted from the root's joint on.
pub fn steer<S: Turning, E: Shape<S>>(
    chain: &E,
    ground: S::Turn,
    position: &mut E::Store<Positions>,
    rate: &mut E::Store<Rates>,
    wanted: &mut impl FnMut(&Swivel<S>) -> Wanted<S>,
) -> Result<(), Error> {
    let mut steer = Steer { wanted, entries: 0, joints: 0, outcome: Ok(()) };
    chain.outward(&mut steer, ground, (position, rate));
    steer.outcome
}

/// Asks, and counts what it has met.
struct Steer<'w, F> {
    wanted: &'w mut F,
    entries: usize,
    joints: usize,
    outcome: Result<(), Error>,
}

impl<F> Steer<'_, F> {
    fn note<T: Real>(&mut self, residual: T, tolerance: T) {
        if self.outcome.is_ok() && (residual > tolerance || residual.as_f64().is_nan()) {
            let fault = Fault::ImpossibleTurn { residual: residual.as_f64() };
            self.outcome = Err(Error::new(fault).at_station(self.entries));
        }
    }
}

impl<S: Turning, F: FnMut(&Swivel<S>) -> Wanted<S>> Walk<S> for Steer<'_, F> {
    type Carried = S::Turn;
    type Stores = (Mut<Positions>, Mut<Rates>);
}

impl<S: Turning, F: FnMut(&Swivel<S>) -> Wanted<S>> Outward<S> for Steer<'_, F> {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, turn: S::Turn, _: AtBody<'_, S, Self, B>) -> S::Turn {
        self.entries += 1;
        turn
    }
    fn joint<J: Joint<S>>(
        &mut self,
        joint: &J,
        inboard: S::Turn,
        (position, rate): AtJoint<'_, S, Self, J>,
    ) -> S::Turn {
        let axes = Axes::of::<S, J>(joint, inboard, position);
        if axes.count() > 0 {
            let turned = outboard(joint, inboard, position, rate);
            let swivel = Swivel { joint: self.joints, freedoms: axes.count(), inboard, outboard: turned };
            // What the joint gives its outboard body without rates of its own: that of the inboard one, or nothing.
            let given = || S::spin(&outboard(joint, inboard, position, &J::still().1));
            let small = RealOf::<S>::EPSILON.powf(RealOf::<S>::of(0.7));
            match (self.wanted)(&swivel) {
                Wanted::Any => (),
                Wanted::Spin(spin) => {
                    let rates = axes.rates_for(&minus(spin, given()));
                    let residual = length(&minus(plus(axes.spin_of(&rates), given()), spin));
                    self.note(residual, small * (length(&spin) + length(&given())));
                    axes.put(&rates, rate);
                }
                Wanted::Relative(own) => {
                    let carried = axes.rates_for(&minus(S::spin(&inboard), given()));
                    axes.put(&plus(carried, own), rate);
                }
                Wanted::Orientation(there) => {
                    let residual = turn_to::<S, J>(joint, inboard, position, &there);
                    self.note(residual, small);
                }
            }
        }
        self.entries += 1;
        self.joints += 1;
        outboard(joint, inboard, position, rate)
    }
    fn closing<K: Closing<S>>(&mut self, _: &K, _: [S::Turn; 2], _: AtClosing<'_, S, Self, K>) {
        self.entries += 1;
        self.joints += 1;
    }
}

/// Turns a joint until its outboard body has an orientation, by Newton's method; gives the residual in the end (rad).
fn turn_to<S: Turning, J: Joint<S>>(
    joint: &J,
    inboard: S::Turn,
    position: &mut J::Position,
    there: &S::Orientation,
) -> RealOf<S> {
    /// Enough from anywhere, a radian at a time.
    const STEPS: usize = 60;
    let away = |position: &J::Position| S::towards(&outboard(joint, inboard, position, &J::still().1), there);
    let mut near = false;
    for _ in 0..STEPS {
        let axes = Axes::of::<S, J>(joint, inboard, position);
        let (step, size) = axes.step_for(&away(position));
        let mut displacement = J::still().1;
        axes.put(&step, &mut displacement);
        position.displace(&displacement);
        // One more from near: it squares what is missed, and derivatives follow.
        if near {
            break;
        }
        near = size <= RealOf::<S>::EPSILON.sqrt();
    }
    length(&away(position))
}
