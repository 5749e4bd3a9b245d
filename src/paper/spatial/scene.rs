//! Scenes in space, read.

use super::algebra::{apply, cross, rows, times, transposed};
use super::attitude::Attitude;
use super::body::{External, Rigid};
use super::ends;
use super::orient::{Base, Slot, Solid, angle_accelerations};
use crate::element::{Element, Load, Loading};
use crate::ends::{Pairs, Root, Tip};
use crate::error::{Error, Fault, Place};
use crate::loading::couples;
use crate::mechanics::spatial::{BodyMotion, Drive, Frame, JointMotion, Spatial, Turn};
use crate::paper::link::{End, dot};
use crate::paper::orient::{Axes, Expanded, Joints, Spring};
use crate::paper::parts::{Item, Start};
use crate::paper::plane_scene::list;
use crate::paper::scene::{Chain, Met, Scene, Slots, refuse_others, trace};
use crate::relation::{Closures, Term};
use crate::release::Way;
use crate::scalar::{Real, Scalar};
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
    const ATTITUDES: [bool; 2] = [about_one_axis(R::Pairs::MOTION), P::Pairs::MOTION[3] || P::Pairs::MOTION[4]];

    fn ground(&self, time: T::Real) -> Frame<T> {
        System::ground(self, time)
    }

    fn root(&self, axis: Option<[T; 3]>, ground: &Frame<T>, first: Option<&Axes<T, 3, 3>>, drive: [T; 3]) -> End<T, 6> {
        if let (Some(axis), Some(first)) = (axis, first) {
            return ends::hinged_root(axis, ground, first, drive[0]);
        }
        let none = T::zero();
        // What floats has no torque in its joint.
        let [x, y, z] = drive.map(|torque| if R::Pairs::MOTION[0] { -torque } else { none });
        let known = [none, none, none, x, y, z];
        End::along_axes(core::array::from_fn(|k| R::Pairs::MOTION[k]), known)
    }

    fn tip(&self, time: T::Real, last: Option<&Axes<T, 3, 3>>) -> End<T, 6> {
        if P::Closures::COUNT == 0 {
            return End::free();
        }
        let still = Frame::resting(Vector3::new(T::zero(), T::zero(), T::zero()));
        // Closures of places come first: the residual of a tip at the origin is minus the place.
        let residual = |frame: &Frame<T>| list::<T, P::Closures, 6>(&self.tip_end().linear_residual(time, frame));
        let mut end = End::along_axes(core::array::from_fn(|k| P::Pairs::MOTION[k]), residual(&still).map(|x| -x));
        if let Some(last) = last {
            let pull = |k: usize| {
                let unit = P::Closures::each(|j| if j == k { T::one() } else { T::zero() });
                self.tip_end().internal(time, &unit).torque.into()
            };
            let turned = |attitude| Frame { turn: Turn { attitude, ..still.turn }, ..still };
            ends::hold_attitude(
                &mut end,
                P::Closures::COUNT.saturating_sub(3),
                last,
                |attitude| residual(&turned(attitude)),
                pull,
            );
        }
        end
    }

    fn chain(&self, motion: &Self::Motion, loads: &L, slots: Slots) -> Result<Chain<T, Slot<T>, 13, 3, 3>, Error> {
        let unsupported = |what| Err(Error::new(Fault::Unsupported { what }));
        let loose = R::Pairs::MOTION[3..].iter().filter(|held| !**held).count();
        if loose == 2 {
            return unsupported("a root that turns about two axes").map_err(|error| error.at(Place::Root));
        }
        if L::SURVEYS || couples::<Spatial<T>, L>() {
            return unsupported("loads between bodies or joints");
        }
        let motion = self.with_accelerations(motion.clone(), loads)?;
        let met = trace(self, &motion)?;
        let joint = |k: usize| matches!(met.get(k), Some(Met::Joint(..)));
        let [of_root, of_tip] = <Self as Scene<T, L, 13, 6, 3, 3>>::ATTITUDES;
        if of_root && joint(1) {
            return unsupported("a joint next to a root that turns about one axis")
                .map_err(|error| error.at(Place::Root));
        }
        if of_tip && (P::Closures::COUNT < 5 || P::Pairs::MOTION[..3].contains(&false)) {
            return unsupported("a tip that is neither held fast nor on a hinge").map_err(|error| error.at(Place::Tip));
        }
        if of_tip && joint(met.len().wrapping_sub(1)) {
            return unsupported("a joint next to a tip whose attitude is held").map_err(|error| error.at(Place::Tip));
        }
        let (joints, axis) = laws(self, motion.time())?;
        let mut items = Vec::with_capacity(met.len());
        for (k, (element, law)) in met.iter().zip(joints).enumerate() {
            let station = k.saturating_sub(1);
            items.push(match (element, law) {
                (Met::Body(body), _) => {
                    Item::Body(start(body, slots).map_err(|fault| Error::new(fault).at_station(station))?)
                }
                (Met::Joint(joint, _), Some((turns, spring))) => {
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
                    let near = <Slot<T> as Joints<T, 3, 3>>::angles(&joint.inboard, &[T::zero(); 3]);
                    let far = <Slot<T> as Joints<T, 3, 3>>::angles(&joint.outboard, &near);
                    let elastic = core::array::from_fn(|i| spring.stiffness[i] * (far[i] - near[i]));
                    Item::Joint { turns, ahead, spring, elastic, linear: None }
                }
                (Met::Joint(..), None) => return Err(Error::new(Fault::Shape)),
            });
        }
        Ok(Chain { time: motion.time(), items, guide: axis })
    }

    fn external(&self, loads: &L, time: T::Real, number: usize, body: &BodyMotion<T>) -> External<T> {
        let load = loads.on_body(&loads.unseen(), time, number, body).wrench();
        let force: [T; 3] = load.force.into();
        let moved = cross(body.to_centre.into(), force);
        let total = Vector3::from(force) + System::gravity(self) * body.inertia.mass;
        External { force: total.into(), torque: core::array::from_fn(|i| load.torque[i] - moved[i]) }
    }

    fn effort(
        &self,
        loads: &L,
        time: T::Real,
        number: usize,
        [inner, outer]: [Option<&BodyMotion<T>>; 2],
        ground: &Frame<T>,
        axis: Option<[T; 3]>,
    ) -> [T; 3] {
        if !L::ON {
            return [T::zero(); 3];
        }
        let outboard = outer.map_or(*ground, |body| body.inboard);
        let inboard = inner.map_or(*ground, BodyMotion::outboard);
        let none = [T::zero(); 3];
        let attitude = outboard.turn.attitude;
        let mut rate = attitude.transposed(outboard.turn.spin - inboard.turn.spin).into();
        // The first number of a joint about an axis; in a ball axes of the body.
        let axis = axis.filter(|_| number == 0);
        if let Some(axis) = axis {
            let own = rows(&ground.turn.attitude);
            let spin = (outboard.turn.spin - inboard.turn.spin).into();
            rate = [dot(&apply(&own, axis), &spin), none[1], none[2]];
        }
        let motion =
            JointMotion { inboard, outboard, position: none, rate, effort: none, energy: T::zero(), inertia: none };
        let zero = Vector3::new(T::zero(), T::zero(), T::zero());
        let couple: [T; 3] = loads.in_joint(time, number, &motion).couple(&attitude).add_to(zero).into();
        if axis.is_some() { apply(&transposed(&rows(&attitude)), couple) } else { couple }
    }
}

/// Whether a root turns about one axis.
const fn about_one_axis(motion: &[bool]) -> bool {
    motion[3] as u8 + motion[4] as u8 + motion[5] as u8 == 2
}

/// What each joint is, as it says where it is unturned: whether it turns, and the law of its spring; and the axis, in those of the ground,
/// about which the root turns if it is one.
///
/// # Errors
/// [`Fault::Unsupported`] for joints with axes, whose matrices the paper has not.
#[allow(clippy::type_complexity)] // a list of pairs
fn laws<T, R, C, P>(
    system: &System<Spatial<T>, R, C, P>,
    time: T::Real,
) -> Result<(Vec<Option<(bool, Spring<T, 3>)>>, Option<[T; 3]>), Error>
where
    T: Scalar,
    R: Root<Spatial<T>>,
    C: Element<Spatial<T>>,
    P: Tip<Spatial<T>>,
{
    let mut hinge = None;
    let unturned = trace(system, &system.motion().at_time(time))?;
    let mut laws = Vec::with_capacity(unturned.len());
    for (k, element) in unturned.iter().enumerate() {
        let Met::Joint(joint, release) = element else {
            laws.push(None);
            continue;
        };
        let refused = |fault| Error::new(fault).at_station(k.saturating_sub(1));
        let unsupported = |what| Err(refused(Fault::Unsupported { what }));
        refuse_others(release).map_err(refused)?;
        if release.coordinates.iter().flatten().any(|coordinate| coordinate.preload.real() != T::Real::zero()) {
            return unsupported("a spring with a rest value in space");
        }
        if k > 0 && release.of(Way::Slide).next().is_some() {
            return unsupported(
                "a joint whose points part: (33) to (35) push along inertial axes, no joint in space does",
            );
        }
        let mut spring = Spring::none();
        for (axis, turn) in release.of(Way::Turn).take(3).enumerate() {
            (spring.stiffness[axis], spring.damping[axis]) = (turn.resistance.stiffness, turn.resistance.damping);
        }
        match (release.of(Way::Turn).count(), release.of(Way::Turn).next()) {
            (0, _) => laws.push(Some((false, spring))),
            (3, _) => laws.push(Some((true, spring))),
            (1, Some(turn)) if k == 0 && about_one_axis(R::Pairs::MOTION) => {
                hinge = Some(apply(&transposed(&rows(&joint.inboard.turn.attitude)), turn.axis.into()));
                laws.push(Some((true, Spring::none())));
            }
            _ => return unsupported("a joint with axes in space"),
        }
    }
    Ok((laws, hinge))
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
    let shown = <Slot<T> as Joints<T, 3, 3>>::angles(&body.inboard, &[T::zero(); 3]);
    let angles = match slots {
        Slots::Angles => {
            let still = Attitude::about(shown, [T::zero(); 3]);
            Expanded::<T, 3, 3>::check(&Slot::Angles(still))?;
            let rates = still.rates_of(spin);
            let accelerations = angle_accelerations(&still, rates, angular);
            core::array::from_fn(|k| [shown[k], rates[k], accelerations[k]])
        }
        Slots::RotationVectors => core::array::from_fn(|k| [T::zero(), spin[k], angular[k]]),
    };
    let base = Base { slots, attitude };
    Ok(Start { rigid: Solid { rigid, inertia }, base, points: frames.map(point), angles, shown })
}
