//! Scenes in the plane, read.

use super::body::{External, Rigid};
use super::expansion::Expansion;
use super::link::End;
use super::orient::{Axes, Spring};
use super::parts::{Item, Start};
use super::scene::{Chain, Met, Scene, Slots, trace};
use crate::element::{Element, Load, Loading};
use crate::ends::{Pairs, Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::mirror::{Position, Rate};
use crate::planar::{BodyMotion, Frame, JointMotion, Planar, SpringState, Turn};
use crate::relation::{Closures, Term};
use crate::scalar::Scalar;
use crate::system::{MotionOf, Runs, System};
use alloc::vec::Vec;
use nalgebra::Vector2;
use num_traits::Zero;

impl<T, R, C, P, L> Scene<T, L, 7, 3, 2, 1> for System<Planar<T>, R, C, P>
where
    T: Scalar,
    R: Root<Planar<T>>,
    C: Element<Planar<T>>,
    P: Tip<Planar<T>>,
    L: Loading<Planar<T>, InJoint: Term<T>>,
    Self: Runs<L, Planar<T>, R, C, P>,
{
    type Motion = MotionOf<Planar<T>, R, C, P>;
    type Orient = Expansion<T>;
    const HELD: bool = R::Pairs::MOTION[1];
    const GUIDED: bool = R::Pairs::MOTION[0] != R::Pairs::MOTION[1];
    const ATTITUDES: [bool; 2] = [false; 2];

    fn ground(&self, time: T::Real) -> Frame<T> {
        System::ground(self, time)
    }

    fn root(&self, guide: Option<[T; 2]>, ground: &Frame<T>, _: Option<&Axes<T, 2, 1>>, [drive]: [T; 1]) -> End<T, 3> {
        let (o, one) = (T::zero(), T::one());
        if let Some([x, y]) = guide {
            let (s, c) = ground.turn.angle.sin_cos();
            let normal = [-(s * x + c * y), c * x - s * y, o];
            return End::holding(&[normal, [o, o, one]], &[o; 2]);
        }
        End::along_axes(core::array::from_fn(|k| R::Pairs::MOTION[k]), [o, o, -drive])
    }

    fn tip(&self, time: T::Real, _: Option<&Axes<T, 2, 1>>) -> End<T, 3> {
        if P::Closures::COUNT == 0 {
            return End::free();
        }
        // How much the tip misses is linear in place and angle.
        let miss = |[x, y, angle]: [T; 3]| {
            let still = Frame::resting(Vector2::new(x, y));
            let frame = Frame { turn: Turn { angle, ..still.turn }, ..still };
            list::<T, P::Closures, 3>(&self.tip_end().miss(time, &frame)[0])
        };
        let unit = |k: usize| core::array::from_fn(|i| if i == k { T::one() } else { T::zero() });
        let (none, moved) = (miss([T::zero(); 3]), [0, 1, 2].map(|k| miss(unit(k))));
        let directions: [[T; 3]; 3] = core::array::from_fn(|row| core::array::from_fn(|k| moved[k][row] - none[row]));
        let count = P::Closures::COUNT;
        End::holding(&directions[..count], &none.map(|x| -x)[..count])
    }

    fn chain(&self, motion: &Self::Motion, loads: &L, _: Slots) -> Result<Chain<T, Expansion<T>, 7, 2, 1>, Error> {
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
        let (rest, turned, turning) = (look(zero, zero)?, look(one, zero)?, look(zero, one)?);
        let mut items = Vec::with_capacity(rest.len());
        let mut guide = None;
        let met = trace(self, &motion)?;
        if P::Pairs::MOTION[2] && matches!(met.last(), Some(Met::Joint(_))) {
            let what = "a joint next to a tip whose attitude is held";
            return Err(Error::new(Fault::Unsupported { what }).at(Place::Tip));
        }
        for (k, element) in met.iter().enumerate() {
            items.push(match (element, &rest[k], &turned[k], &turning[k]) {
                (Met::Joint(joint), Met::Joint(rest), Met::Joint(turned), Met::Joint(turning)) => {
                    let apart = turned.outboard.place - turned.inboard.place;
                    let mut linear = None;
                    // Not finite where a long chain was turned beyond the range of sines, which says nothing.
                    if apart.x.real().abs() > T::Real::zero() || apart.y.real().abs() > T::Real::zero() {
                        if k > 0 {
                            // In the chain's own joints: between two bodies, or on ground that holds the root fast.
                            let fast = R::Pairs::MOTION.iter().all(|held| *held);
                            let body = |at: usize| matches!(met.get(at), Some(Met::Body(_)));
                            let between = body(k + 1) && (body(k - 1) || k == 1 && fast);
                            refuse_sliding(turned, between).map_err(|fault| Error::new(fault).at_station(k - 1))?;
                            linear = Some(sprung(joint, [rest, turned, turning]));
                        }
                        let (s, c) = turned.inboard.turn.angle.sin_cos();
                        let along = [c * apart.x + s * apart.y, c * apart.y - s * apart.x];
                        if k == 0 {
                            guide = <Self as Scene<T, L, 7, 3, 2, 1>>::GUIDED.then_some(along);
                        }
                    }
                    let preload = rest.spring.torque;
                    let damping = preload - turning.spring.torque;
                    Item::Joint {
                        turns: joint.turns,
                        ahead: joint.angle(),
                        spring: Spring {
                            stiffness: [preload - turned.spring.torque],
                            damping: [damping],
                            preload: [preload],
                        },
                        // The torque of the spring alone, on the outboard body the other way round.
                        elastic: [-(joint.spring.torque + damping * joint.rate())],
                        linear,
                    }
                }
                (Met::Body(body), ..) => Item::Body(start(body)),
                _ => return Err(Error::new(Fault::Shape)),
            });
        }
        Ok(Chain { time: motion.time(), items, guide })
    }

    fn external(&self, loads: &L, time: T::Real, number: usize, body: &BodyMotion<T>) -> External<T> {
        let load = loads.on_body(&L::unseen(), time, number, body).wrench();
        let force = load.force;
        let torque = load.torque - (body.to_centre.x * force.y - body.to_centre.y * force.x);
        let total = force + System::gravity(self) * body.inertia.mass;
        External { force: [total.x, total.y], torque }
    }

    fn effort(
        &self,
        loads: &L,
        time: T::Real,
        number: usize,
        [inner, outer]: [Option<&BodyMotion<T>>; 2],
        ground: &Frame<T>,
        _: Option<[T; 2]>,
    ) -> [T; 1] {
        if !L::ON {
            return [T::zero()];
        }
        let outboard = outer.map_or(*ground, |body| body.inboard);
        let inboard = Frame { turn: inner.map_or(ground.turn, |body| body.inboard.turn), ..outboard };
        let spring = SpringState { torque: T::zero(), force: [T::zero(); 2], energy: T::zero() };
        let arm = Vector2::new(T::zero(), T::zero());
        let none = [T::zero(); 2];
        let motion = JointMotion { inboard, outboard, arm, spring, turns: true, slide: none, sliding: none };
        [loads.in_joint(time, number, &motion).add_to(T::zero())]
    }
}

/// Closures one after the other.
pub(super) fn list<T: Scalar, C: Closures, const K: usize>(each: &C::Each<T>) -> [T; K] {
    let (mut found, mut count) = ([T::zero(); K], 0);
    C::map(each, |x| {
        if let Some(slot) = found.get_mut(count) {
            *slot = x;
        }
        count += 1;
    });
    found
}

/// Refuses joints whose points part, but for linear springs as (33) to (35) have them.
fn refuse_sliding<T: Scalar>(turned: &JointMotion<T>, between: bool) -> Result<(), Fault> {
    let what = if !turned.turns {
        "a joint that slides"
    } else if turned.arm.iter().any(|x| x.real().abs() > T::Real::zero()) {
        "linear springs whose force has a moment: let them push `in_unbalanced_axes`, as (33) to (35) have it"
    } else if !between {
        "linear springs next to another joint or to the tip: put a body between"
    } else {
        return Ok(());
    };
    Err(Fault::Unsupported { what })
}

/// The linear springs of a joint, from looks at it unmoved, displaced and moving by one, and its displacement now.
#[allow(clippy::type_complexity)] // a pair
fn sprung<T: Scalar>(
    joint: &JointMotion<T>,
    [rest, displaced, moving]: [&JointMotion<T>; 3],
) -> (Spring<T, 2>, [[T; 3]; 2]) {
    let preload = rest.spring.force;
    let less = |look: &JointMotion<T>| core::array::from_fn(|i| preload[i] - look.spring.force[i]);
    let spring = Spring { stiffness: less(displaced), damping: less(moving), preload };
    let (inner, outer) = (&joint.inboard, &joint.outboard);
    let place = outer.place - inner.place;
    let velocity = outer.velocity - inner.velocity;
    let linear = outer.acceleration.linear - inner.acceleration.linear;
    (spring, [0, 1].map(|i| [place[i], velocity[i], linear[i]]))
}

fn start<T: Scalar>(body: &BodyMotion<T>) -> Start<T, Rigid<T>, (), 2, 1> {
    let point = |frame: Frame<T>| {
        let (place, velocity, linear) = (frame.place, frame.velocity, frame.acceleration.linear);
        [[place.x, velocity.x, linear.x], [place.y, velocity.y, linear.y]]
    };
    let Turn { angle, rate } = body.inboard.turn;
    Start {
        rigid: Rigid::of(body),
        base: (),
        points: [body.inboard, body.centre(), body.outboard()].map(point),
        angles: [[angle, rate, body.inboard.acceleration.angular]],
        shown: [angle],
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
