//! A scene read element by element: what section 2.2 calls the discretisation of a system.

use super::body::{External, Rigid};
use crate::element::{Coordinates, Element, Loading, Space, Visit};
use crate::ends::{Pairs, Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::mirror::{Position, Rate};
use crate::planar::{BodyMotion, Frame, JointMotion, Planar};
use crate::relation::{Open, Term};
use crate::scalar::{Real, Scalar};
use crate::system::{MotionOf, Runs, System};
use alloc::vec::Vec;
use nalgebra::Vector2;
use num_traits::Zero;

/// A body or a joint of a scene, and how it moves at the start.
#[derive(Clone, Copy, Debug)]
pub enum Item<T> {
    /// A body.
    Body(BodyMotion<T>),
    /// A joint and the law of its spring.
    Joint(JointMotion<T>, Spring<T>),
}

/// The law of a linear rotary spring and damper: m = k′φ − k′φ₀ + c′φ̇.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring<T> {
    /// k′ (N·m/rad).
    pub stiffness: T,
    /// c′ (N·m·s/rad).
    pub damping: T,
    /// k′φ₀ (N·m).
    pub preload: T,
}

/// A planar scene that this formulation can run: a chain with a free tip. One implementor, [`System`], whose bounds are long.
pub trait Scene<T: Scalar, L> {
    /// Its motion.
    type Motion;
    /// Whether the ground holds the root.
    const HELD: bool;

    /// The ground at the root.
    fn ground(&self, time: T::Real) -> Frame<T>;
    /// Gravity (m/s²).
    fn gravity(&self) -> Vector2<T>;
    /// Time (s) and elements of a motion, the root's joint first, with the accelerations that positions, rates and loads cause: a start
    /// from zero accelerations would not be one.
    ///
    /// # Errors
    /// As [`System::with_accelerations`]; [`Fault::Unsupported`] for elements that the paper's matrices cannot say.
    fn items(&self, motion: &Self::Motion, loads: &L) -> Result<(T::Real, Vec<Item<T>>), Error>;
}

impl<T, R, C, P, L> Scene<T, L> for System<Planar<T>, R, C, P>
where
    T: Scalar,
    R: Root<Planar<T>>,
    C: Element<Planar<T>>,
    P: Tip<Planar<T>, Closures = Open>,
    L: Loading<Planar<T>>,
    Self: Runs<L, Planar<T>, R, C, P>,
{
    type Motion = MotionOf<Planar<T>, R, C, P>;
    // Plane ends that hold a place are pins and clamps: what they leave free, their joint lets go.
    const HELD: bool = R::Pairs::MOTION[0];

    fn ground(&self, time: T::Real) -> Frame<T> {
        System::ground(self, time)
    }

    fn gravity(&self) -> Vector2<T> {
        System::gravity(self)
    }

    fn items(&self, motion: &Self::Motion, loads: &L) -> Result<(T::Real, Vec<Item<T>>), Error> {
        if R::Pairs::MOTION.first() != R::Pairs::MOTION.get(1) {
            return Err(Error::new(Fault::Unsupported { what: "a root that is guided" }).at(Place::Root));
        }
        if L::SURVEYS {
            return Err(Error::new(Fault::Unsupported { what: "loads between bodies" }));
        }
        let motion = self.with_accelerations(motion.clone(), loads)?;
        // A spring is linear, so three looks tell its law.
        let look = |angle: T, rate: T| {
            let mut probe = motion.clone();
            probe.position_mut().replace(&mut |_| angle);
            probe.rate_mut().replace(&mut |_| rate);
            trace(self, &probe)
        };
        let (zero, one) = (T::zero(), T::one());
        let (rest, turned, turning) = (look(zero, zero), look(one, zero), look(zero, one));
        let mut items = trace(self, &motion);
        check(&items, &turned)?;
        for (item, looks) in items.iter_mut().zip(rest.iter().zip(turned.iter().zip(&turning))) {
            if let (Item::Joint(_, law), (Item::Joint(rest, _), (Item::Joint(turned, _), Item::Joint(turning, _)))) =
                (item, looks)
            {
                let preload = rest.spring.torque;
                *law = Spring {
                    stiffness: preload - turned.spring.torque,
                    damping: preload - turning.spring.torque,
                    preload,
                };
            }
        }
        Ok((motion.time(), items))
    }
}

fn trace<T, R, C, P>(system: &System<Planar<T>, R, C, P>, motion: &MotionOf<Planar<T>, R, C, P>) -> Vec<Item<T>>
where
    T: Scalar,
    R: Root<Planar<T>>,
    C: Element<Planar<T>>,
    P: Tip<Planar<T>>,
{
    let chain = system.elements();
    let (position, rate, acceleration) = (motion.position(), motion.rate(), motion.acceleration());
    let mut list = List(Vec::with_capacity(chain.bodies() + chain.joints()));
    let coordinates = Coordinates { position, rate, acceleration };
    chain.travel(
        system.ground(motion.time()),
        coordinates,
        &mut list,
        &mut chain.per_body(()),
        &mut chain.per_joint(()),
    );
    list.0
}

/// Refuses what (32) to (40) cannot say: elements that do not follow each other, and joints whose points part.
fn check<T: Scalar>(items: &[Item<T>], turned: &[Item<T>]) -> Result<(), Error> {
    let unsupported = |what, k: usize| Err(Error::new(Fault::Unsupported { what }).at_station(k.saturating_sub(1)));
    let mut last = None;
    for (k, (item, turned)) in items.iter().zip(turned).enumerate() {
        let (inboard, outboard) = match item {
            Item::Body(body) => (body.inboard, body.outboard()),
            Item::Joint(joint, _) => (joint.inboard, joint.outboard),
        };
        if last.is_some_and(|place: Vector2<T>| place != inboard.place) {
            return unsupported("a chain that branches", k);
        }
        last = Some(outboard.place);
        if let Item::Joint(joint, _) = turned {
            // Not finite where a long chain was turned beyond the range of sines, which says nothing.
            let apart = joint.outboard.place - joint.inboard.place;
            if k > 0 && (apart.x.real().abs() > T::Real::zero() || apart.y.real().abs() > T::Real::zero()) {
                return unsupported("a joint whose points part", k);
            }
        }
    }
    Ok(())
}

/// Writes down what it meets.
struct List<T>(Vec<Item<T>>);

impl<T: Scalar> Visit<Planar<T>> for List<T> {
    type OnBody = ();
    type InJoint = ();

    fn body(&mut self, body: &BodyMotion<T>) {
        self.0.push(Item::Body(*body));
    }
    fn joint(&mut self, joint: &JointMotion<T>) {
        let none = T::zero();
        self.0.push(Item::Joint(*joint, Spring { stiffness: none, damping: none, preload: none }));
    }
}

impl<T: Scalar> Rigid<T> {
    /// What is constant in a body that moves.
    pub fn of(body: &BodyMotion<T>) -> Self {
        // The arm in body axes.
        let (arm, [c, s]) = (body.arm, [body.direction.x, body.direction.y]);
        Self { inertia: body.inertia, outboard: [c * arm.x + s * arm.y, c * arm.y - s * arm.x] }
    }

    /// This body with its inboard end at `frame`, its axes along (`s`, `c`).
    pub(super) fn moving(&self, frame: Frame<T>, [s, c]: [T; 2]) -> BodyMotion<T> {
        let zero = Vector2::new(T::zero(), T::zero());
        let inertia = self.inertia;
        let still = BodyMotion { inboard: frame, arm: zero, to_centre: zero, direction: Vector2::new(c, s), inertia };
        BodyMotion { arm: still.turned(self.outboard), to_centre: still.turned(inertia.centre), ..still }
    }
}

/// f_C and m_C of a body under a load and gravity.
pub(super) fn external<T: Scalar, L: Loading<Planar<T>>>(
    body: &BodyMotion<T>,
    gravity: Vector2<T>,
    load: L::OnBody,
) -> External<T> {
    use crate::element::Load;
    let nothing = Planar::<T>::no_force();
    let mut station = Planar::end_station(&body.inboard, nothing);
    load.act(&mut station);
    // The balance of a station without mass shows what acts there: −f, and the torque about the inboard end.
    let shown = Planar::balance(&mut station, nothing);
    let force = -shown.force;
    let torque = shown.torque - (body.to_centre.x * force.y - body.to_centre.y * force.x);
    let total = force + gravity * body.inertia.mass;
    External { force: [total.x, total.y], torque }
}

/// The torque applied in a joint, ON the outboard body (N·m).
pub(super) fn applied<T: Scalar, L: Loading<Planar<T>>>(torque: L::InJoint) -> T
where
    L::InJoint: Term<T>,
{
    torque.add_to(T::zero())
}
