//! Scenes in the plane, read.

use super::body::{External, Rigid};
use super::expansion::Expansion;
use super::link::{End, dot};
use super::orient::{Axes, Spring};
use super::parts::{Item, Start};
use super::scene::{Chain, Met, Scene, Slots, refuse_others, trace};
use crate::element::{Element, Load, Loading};
use crate::ends::{Pairs, Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::loading::couples;
use crate::mechanics::planar::{BodyMotion, Frame, JointMotion, Planar, SpringState, Turn};
use crate::relation::{Closures, Term};
use crate::release::{Freedom, Release, Resistance, Way};
use crate::scalar::Scalar;
use crate::system::{MotionOf, Runs, System};
use alloc::vec::Vec;
use nalgebra::Vector2;

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
            let (line, normal) = ([c * x - s * y, s * x + c * y, o], [-(s * x + c * y), c * x - s * y, o]);
            let mut end = End::holding(&[normal, [o, o, one]], &[o; 2]);
            // The direction left is the line, one way or the other.
            end.known[2] = drive * dot(&end.pulls[2], &line);
            return end;
        }
        End::along_axes(core::array::from_fn(|k| R::Pairs::MOTION[k]), [o, o, -drive])
    }

    fn tip(&self, time: T::Real, _: Option<&Axes<T, 2, 1>>) -> End<T, 3> {
        if P::Closures::COUNT == 0 {
            return End::free();
        }
        // The tip's residual is linear in place and angle.
        let residual = |[x, y, angle]: [T; 3]| {
            let still = Frame::resting(Vector2::new(x, y));
            let frame = Frame { turn: Turn { angle, ..still.turn }, ..still };
            list::<T, P::Closures, 3>(&self.tip_end().residual(time, &frame)[0])
        };
        let unit = |k: usize| core::array::from_fn(|i| if i == k { T::one() } else { T::zero() });
        let (none, moved) = (residual([T::zero(); 3]), [0, 1, 2].map(|k| residual(unit(k))));
        let directions: [[T; 3]; 3] = core::array::from_fn(|row| core::array::from_fn(|k| moved[k][row] - none[row]));
        let count = P::Closures::COUNT;
        End::holding(&directions[..count], &none.map(|x| -x)[..count])
    }

    fn chain(&self, motion: &Self::Motion, loads: &L, _: Slots) -> Result<Chain<T, Expansion<T>, 7, 2, 1>, Error> {
        if L::SURVEYS || couples::<Planar<T>, L>() {
            return Err(Error::new(Fault::Unsupported { what: "loads between bodies or joints" }));
        }
        let motion = self.with_accelerations(motion.clone(), loads)?;
        let mut items = Vec::new();
        let mut guide = None;
        let met = trace(self, &motion)?;
        if P::Pairs::MOTION[2] && matches!(met.last(), Some(Met::Joint(..))) {
            let what = "a joint next to a tip whose attitude is held";
            return Err(Error::new(Fault::Unsupported { what }).at(Place::Tip));
        }
        for (k, element) in met.iter().enumerate() {
            items.push(match element {
                Met::Joint(joint, release) => {
                    let refused = |fault| Error::new(fault).at_station(k.saturating_sub(1));
                    refuse_others(release).map_err(refused)?;
                    let mut linear = None;
                    if let Some(slide) = release.of(Way::Slide).next() {
                        if k > 0 {
                            // In the chain's own joints: between two bodies, or on ground that holds the root fast.
                            let fast = R::Pairs::MOTION.iter().all(|held| *held);
                            let body = |at: usize| matches!(met.get(at), Some(Met::Body(_)));
                            let between = body(k + 1) && (body(k - 1) || k == 1 && fast);
                            refuse_sliding(release, between).map_err(refused)?;
                            linear = Some(sprung(joint, release));
                        }
                        let (s, c) = joint.inboard.turn.angle.sin_cos();
                        let [x, y] = slide.axis.into();
                        if k == 0 {
                            guide = <Self as Scene<T, L, 7, 3, 2, 1>>::GUIDED.then_some([c * x + s * y, c * y - s * x]);
                        }
                    }
                    let spring = release.of(Way::Turn).next().map_or(Spring::none(), law);
                    Item::Joint {
                        turns: joint.turns,
                        ahead: joint.angle(),
                        spring,
                        // The torque of the spring alone, on the outboard body the other way round.
                        elastic: [-(joint.spring.torque + spring.damping[0] * joint.rate())],
                        linear,
                    }
                }
                Met::Body(body) => Item::Body(start(body)),
            });
        }
        Ok(Chain { time: motion.time(), items, guide })
    }

    fn external(&self, loads: &L, time: T::Real, number: usize, body: &BodyMotion<T>) -> External<T> {
        let load = loads.on_body(&loads.unseen(), time, number, body).wrench();
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
        guide: Option<[T; 2]>,
    ) -> [T; 1] {
        if !L::ON {
            return [T::zero()];
        }
        let outboard = outer.map_or(*ground, |body| body.inboard);
        let inboard = inner.map_or(*ground, BodyMotion::outboard);
        let spring = SpringState { torque: T::zero(), force: [T::zero(); 2], energy: T::zero() };
        let arm = Vector2::new(T::zero(), T::zero());
        let none = [T::zero(); 2];
        let mut motion =
            JointMotion { inboard, outboard, arm, spring, turns: true, slide: none, sliding: none, inertia: T::zero() };
        if let (0, Some(guide)) = (number, guide) {
            motion = guided(motion, guide);
        }
        [loads.in_joint(time, number, &motion).add_to(T::zero())]
    }
}

/// The joint of a root that is guided along a direction of the ground's axes.
fn guided<T: Scalar>(motion: JointMotion<T>, guide: [T; 2]) -> JointMotion<T> {
    let (ground, body) = (motion.inboard, motion.outboard);
    let (s, c) = ground.turn.angle.sin_cos();
    let [x, y] = guide;
    let line = Vector2::new(c * x - s * y, s * x + c * y);
    let along = |of: Vector2<T>| [line.x * of.x + line.y * of.y, T::zero()];
    // That the line turns with the ground moves points across it.
    let (arm, velocity) = (body.place - ground.place, body.velocity - ground.velocity);
    JointMotion { turns: false, arm, slide: along(arm), sliding: along(velocity), ..motion }
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
fn refuse_sliding<T: Scalar>(release: &Release<Planar<T>>, between: bool) -> Result<(), Fault> {
    let what = if release.of(Way::Turn).next().is_none() {
        "a joint that slides"
    } else if release.balanced {
        "linear springs whose force has a moment: let them push `in_unbalanced_axes`, as (33) to (35) have it"
    } else if !between {
        "linear springs next to another joint or to the tip: put a body between"
    } else {
        return Ok(());
    };
    Err(Fault::Unsupported { what })
}

/// The law of one coordinate.
fn law<T: Scalar>(coordinate: &Freedom<Planar<T>>) -> Spring<T, 1> {
    let Resistance { stiffness, damping, .. } = coordinate.resistance;
    Spring { stiffness: [stiffness], damping: [damping], preload: [coordinate.preload] }
}

/// The linear springs of a joint, and its displacement.
#[allow(clippy::type_complexity)] // a pair
fn sprung<T: Scalar>(joint: &JointMotion<T>, release: &Release<Planar<T>>) -> (Spring<T, 2>, [[T; 3]; 2]) {
    let mut spring = Spring::none();
    for (k, slide) in release.of(Way::Slide).take(2).enumerate() {
        let Resistance { stiffness, damping, .. } = slide.resistance;
        (spring.stiffness[k], spring.damping[k], spring.preload[k]) = (stiffness, damping, slide.preload);
    }
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
