//! Scenes in space, read.

use super::algebra::{apply, cross, rows, times, transposed};
use super::attitude::Attitude;
use super::body::{External, Rigid};
use super::orient::{Base, Slot, Solid, angle_accelerations};
use crate::element::{Element, Load, Loading, Space};
use crate::ends::{Pairs, Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::mirror::{Position, Rate};
use crate::paper::link::{End, dot};
use crate::paper::orient::{Orient, Spring};
use crate::paper::parts::{Item, Start};
use crate::paper::plane_scene::list;
use crate::paper::scene::{Chain, Met, Scene, Slots, trace};
use crate::relation::{Closures, Term};
use crate::scalar::{Real, Scalar};
use crate::spatial::{BodyMotion, Drive, Frame, JointMotion, Spatial};
use crate::system::{MotionOf, Runs, System};
use alloc::vec::Vec;
use nalgebra::Vector3;
use num_traits::Zero;

impl<T, R, C, P, L> Scene<T, L, 13, 6, 3, 3> for System<Spatial<T>, R, C, P>
where
    T: Scalar,
    R: Root<Spatial<T>>,
    C: Element<Spatial<T>>,
    P: Tip<Spatial<T>>,
    L: Loading<Spatial<T>, InJoint: Drive<T>>,
    Self: Runs<L, Spatial<T>, R, C, P>,
{
    type Motion = MotionOf<Spatial<T>, R, C, P>;
    type Orient = Slot<T>;
    const HELD: bool = R::Pairs::MOTION[0];
    const GUIDED: bool = false;

    fn ground(&self, time: T::Real) -> Frame<T> {
        System::ground(self, time)
    }

    fn root(&self, _: Option<[T; 3]>, _: &Frame<T>) -> End<T, 6> {
        End::along_axes(core::array::from_fn(|k| R::Pairs::MOTION[k]), [T::zero(); 6])
    }

    fn tip(&self, time: T::Real) -> End<T, 6> {
        if P::Closures::COUNT == 0 {
            return End::free();
        }
        // Pinned: by how much a tip at the origin misses is minus the place.
        let still = Frame::resting(Vector3::new(T::zero(), T::zero(), T::zero()));
        let miss: [T; 6] = list::<T, P::Closures, 6>(&self.tip_end().miss(time, &still)[0]);
        End::along_axes(core::array::from_fn(|k| P::Pairs::MOTION[k]), miss.map(|x| -x))
    }

    fn chain(&self, motion: &Self::Motion, loads: &L, slots: Slots) -> Result<Chain<T, Slot<T>, 13, 3, 3>, Error> {
        let unsupported = |what| Err(Error::new(Fault::Unsupported { what }));
        if R::Pairs::MOTION[3..].iter().any(|held| *held != R::Pairs::MOTION[3]) {
            return unsupported("a root that turns about one axis").map_err(|error| error.at(Place::Root));
        }
        if P::Pairs::MOTION[3..].iter().any(|held| *held) {
            return unsupported("a tip whose attitude is held").map_err(|error| error.at(Place::Tip));
        }
        if L::SURVEYS {
            return Err(Error::new(Fault::Unsupported { what: "loads between bodies" }));
        }
        let motion = self.with_accelerations(motion.clone(), loads)?;
        let met = trace(self, &motion)?;
        let joints = laws(self, &motion, &met)?;
        let mut items = Vec::with_capacity(met.len());
        for (k, (element, law)) in met.iter().zip(joints).enumerate() {
            let station = k.saturating_sub(1);
            items.push(match (element, law) {
                (Met::Body(body), _) => {
                    Item::Body(start(body, slots).map_err(|fault| Error::new(fault).at_station(station))?)
                }
                (Met::Joint(joint), Some((turns, spring))) => {
                    let [inner, outer] = [&joint.inboard, &joint.outboard].map(|frame| rows(&frame.turn.attitude));
                    let ahead = times(&transposed(&inner), &outer);
                    let off = (0..3).flat_map(|i| (0..3).map(move |j| (i, j))).fold(T::Real::zero(), |off, (i, j)| {
                        let one = if i == j { T::one() } else { T::zero() };
                        off.max((ahead[i][j] - one).real().abs())
                    });
                    if slots == Slots::Angles && !turns && k > 0 && off > T::Real::EPSILON * T::Real::of(16.0) {
                        let what = "a weld at an angle, by angles 1-2-3: let rotation vectors stand in their slot";
                        return unsupported(what).map_err(|error| error.at_station(station));
                    }
                    let near = <Slot<T> as Orient<T, 13, 3, 3>>::angles(&joint.inboard, &[T::zero(); 3]);
                    let far = <Slot<T> as Orient<T, 13, 3, 3>>::angles(&joint.outboard, &near);
                    let elastic = core::array::from_fn(|i| spring.stiffness[i] * (far[i] - near[i]));
                    Item::Joint { turns, ahead, spring, elastic, linear: None }
                }
                (Met::Joint(_), None) => return Err(Error::new(Fault::Shape)),
            });
        }
        Ok(Chain { time: motion.time(), items, guide: None })
    }

    fn external(&self, loads: &L, time: T::Real, number: usize, body: &BodyMotion<T>) -> External<T> {
        let nothing = Spatial::<T>::no_force();
        let mut station = Spatial::end_station(&body.inboard, nothing);
        loads.on_body(&L::unseen(), time, number, body).act(&mut station);
        // The balance of a station without mass shows what acts there: −f, and the torque about the inboard end.
        let shown = Spatial::balance(&mut station, nothing);
        let force: [T; 3] = (-shown.force).into();
        let moved = cross(body.to_centre.into(), force);
        let total = Vector3::from(force) + System::gravity(self) * body.inertia.mass;
        External { force: total.into(), torque: core::array::from_fn(|i| shown.torque[i] - moved[i]) }
    }

    fn effort(
        &self,
        loads: &L,
        time: T::Real,
        number: usize,
        [inner, outer]: [Option<&BodyMotion<T>>; 2],
        ground: &Frame<T>,
    ) -> [T; 3] {
        if !L::ON {
            return [T::zero(); 3];
        }
        let outboard = outer.map_or(*ground, |body| body.inboard);
        let inboard = Frame { turn: inner.map_or(ground.turn, |body| body.inboard.turn), ..outboard };
        let none = [T::zero(); 3];
        let attitude = outboard.turn.attitude;
        let rate = attitude.transposed(outboard.turn.spin - inboard.turn.spin).into();
        let motion = JointMotion { inboard, outboard, position: none, rate, effort: none, energy: T::zero() };
        let zero = Vector3::new(T::zero(), T::zero(), T::zero());
        loads.in_joint(time, number, &motion).couple(&attitude).add_to(zero).into()
    }
}

/// What each joint is, by looks at the scene: whether it turns, and the law of its spring.
///
/// # Errors
/// [`Fault::Unsupported`] for joints with axes, whose matrices the paper has not.
#[allow(clippy::type_complexity)] // a list of pairs
fn laws<T, R, C, P>(
    system: &System<Spatial<T>, R, C, P>,
    motion: &MotionOf<Spatial<T>, R, C, P>,
    met: &[Met<Spatial<T>>],
) -> Result<Vec<Option<(bool, Spring<T, 3>)>>, Error>
where
    T: Scalar,
    R: Root<Spatial<T>>,
    C: Element<Spatial<T>>,
    P: Tip<Spatial<T>>,
{
    // Balls have three coordinates, welds none: every third number is of the same axis. Sizes differ from joint to joint, for the rates of
    // smooth balls are absolute.
    let along = |axis: Option<usize>| {
        let mut count = 0_usize;
        move |_: T| {
            let (joint, own) = (count / 3, count % 3);
            count += 1;
            let share = joint as f64 * 0.618_033_988_749_895;
            if axis == Some(own) { T::literal(0.3 + 0.5 * (share - share as usize as f64)) } else { T::zero() }
        }
    };
    let look = |turned: Option<usize>, turning: Option<usize>| {
        let mut probe = motion.clone();
        let mut step = motion.rate().clone();
        step.replace(&mut along(turned));
        let mut position = system.motion();
        position.position_mut().displace(&step);
        *probe.position_mut() = position.position().clone();
        probe.rate_mut().replace(&mut along(turning));
        trace(system, &probe)
    };
    let unturned = look(None, None)?;
    let mut turned = Vec::new();
    let mut turning = Vec::new();
    for axis in 0..3 {
        turned.push(look(Some(axis), None)?);
        turning.push(look(None, Some(axis))?);
    }
    let mut laws = Vec::with_capacity(met.len());
    for (k, element) in met.iter().enumerate() {
        let Met::Joint(_) = element else {
            laws.push(None);
            continue;
        };
        let unsupported = |what| Err(Error::new(Fault::Unsupported { what }).at_station(k.saturating_sub(1)));
        if let Met::Joint(joint) = &unturned[k]
            && joint.effort.iter().any(|x| x.real() != T::Real::zero())
        {
            return unsupported("a spring with a rest value in space");
        }
        let mut spring = Spring::none();
        let mut spins = [[T::zero(); 3]; 3];
        for axis in 0..3 {
            let (Met::Joint(swung), Met::Joint(spun)) = (&turned[axis][k], &turning[axis][k]) else {
                return Err(Error::new(Fault::Shape));
            };
            let apart = swung.outboard.place - swung.inboard.place;
            if k > 0 && apart.iter().any(|x| x.real().abs() > T::Real::zero()) {
                return unsupported(
                    "a joint whose points part: (33) to (35) push along inertial axes, no joint in space does",
                );
            }
            spins[axis] = (spun.outboard.turn.spin - spun.inboard.turn.spin).into();
            if spun.rate[axis].real() != T::Real::zero() {
                spring.damping[axis] = -(spun.effort[axis] / spun.rate[axis]);
            }
            if swung.position[axis].real() != T::Real::zero() {
                spring.stiffness[axis] = -(swung.effort[axis] / swung.position[axis]);
            }
        }
        // Of how many axes relative angular velocities can be.
        let size = spins.iter().flatten().fold(T::Real::zero(), |size, x| size.max(x.real().abs()));
        let volume = dot(&cross(spins[0], spins[1]), &spins[2]).real().abs();
        if size == T::Real::zero() {
            laws.push(Some((false, spring)));
        } else if volume > T::Real::of(1e-6) * size * size * size {
            laws.push(Some((true, spring)));
        } else {
            return unsupported("a joint with axes in space");
        }
    }
    Ok(laws)
}

fn start<T: Scalar>(body: &BodyMotion<T>, slots: Slots) -> Result<Start<T, Solid<T>, Base<T>, 3, 3>, Fault> {
    let frames = [body.inboard, body.centre(), body.outboard()];
    let point =
        |frame: Frame<T>| core::array::from_fn(|i| [frame.place[i], frame.velocity[i], frame.acceleration.linear[i]]);
    let attitude = rows(&body.inboard.turn.attitude);
    let back = transposed(&attitude);
    let of = |v: Vector3<T>| apply(&back, v.into());
    let inertia = body.inertia;
    let about = inertia.about_inboard();
    let rigid = Rigid {
        mass: inertia.mass,
        centre: of(body.to_centre),
        outboard: of(body.arm),
        about_inboard: rows(&about.columns()),
    };
    let [spin, angular] = [body.inboard.turn.spin, body.inboard.acceleration.angular].map(of);
    let shown = <Slot<T> as Orient<T, 13, 3, 3>>::angles(&body.inboard, &[T::zero(); 3]);
    let angles = match slots {
        Slots::Angles => {
            let still = Attitude::about(shown, [T::zero(); 3]);
            Orient::<T, 13, 3, 3>::check(&Slot::Angles(still))?;
            let rates = still.rates_of(spin);
            let accelerations = angle_accelerations(&still, rates, angular);
            core::array::from_fn(|k| [shown[k], rates[k], accelerations[k]])
        }
        Slots::RotationVectors => core::array::from_fn(|k| [T::zero(), spin[k], angular[k]]),
    };
    let base = Base { slots, attitude };
    Ok(Start { rigid: Solid { rigid, inertia }, base, points: frames.map(point), angles, shown })
}
