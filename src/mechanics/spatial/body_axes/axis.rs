//! Joints of one coordinate, about or along the z axis of the body that they carry.

use super::link::swirl;
use super::number::{Number, Rows, Triple, apply, cross_onto, masked, sum, transposed, triple, values};
use super::relation::{Gains, Local, Outboard};
use super::turns::{Level, Offset};
use crate::counts::Counted;
use crate::element::{Condense, Element, Given, InJoint, Posture, Springs, Sweep};
use crate::error::Fault;
use crate::lift::Lift;
use crate::mechanics::spatial::inertia::{finite, not_negative};
use crate::mechanics::spatial::spring::PivotRule;
use crate::mechanics::spatial::{Acceleration, Drive, Frame, JointMotion, Spatial, Turn};
use crate::relation::spatial::algebra::{Columns, add_scaled, cross};
use crate::relation::{Absent, Closures, Open, Term};
use crate::release::{Freedom, Release, Resistance, Way, slopes};
use crate::scalar::Scalar;
use crate::shape::{Joint, JointPosture};
use crate::spring::{Spring, SpringLaw};
use core::fmt::Debug;
use core::marker::PhantomData;
use nalgebra::Vector3;
use typenum::{U0, U1};

/// How a coordinate moves a body.
pub trait Mode: Copy + Debug + 'static {
    /// Whether it turns the body; else it slides it.
    const TURNS: bool;
}

/// A coordinate that turns a body about its z axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AboutZ;

/// A coordinate that slides a body along its z axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AlongZ;

impl Mode for AboutZ {
    const TURNS: bool = true;
}
impl Mode for AlongZ {
    const TURNS: bool = false;
}

/// A hinge about the z axis of the body that it carries; its coordinate is the angle (rad) relative to the parent.
///
/// Where it sits on its parent and how the body is turned while the coordinate is zero are parts of the joint: `PLACE` has a bit for each
/// of x, y, z (0 to 2) that the place has, and the [`Offset`] is [`Level`] (no turn), a [`Quarter`](super::Quarter), or any other. What
/// is not there costs nothing.
///
/// ```
/// use catena::robot::*;
/// let shoulder = Hinge::level(); // at the origin of its parent, not turned
/// let elbow = Hinge::at::<0b100>([0.0, 0.0, 0.4]).turned(Quarter::<30>).with(Spring::damping(0.5)).geared(0.1);
/// let link = Link::general(3.0, [0.0, 0.0, 0.2], [[0.05, 0.0, 0.0], [0.0, 0.05, 0.0], [0.0, 0.0, 0.01]]);
/// let arm = System::new(Clamped::origin(), (BodyAxes, shoulder, link, elbow, link), Free)?.with_gravity([0.0, 0.0, -9.81]);
/// assert_eq!(arm.forward_dynamics(&[0.1, 0.2], &[0.0, 0.0], &[0.0, 0.0])?.len(), 2);
/// # Ok::<(), catena::Error>(())
/// ```
pub type Hinge<T, C = Level, const PLACE: u8 = 0, L = Spring, A = Absent> = Axis<T, AboutZ, C, PLACE, L, A>;

/// A slide along the z axis of the body that it carries; its coordinate is the way (m) from where it sits on its parent. All else is as for
/// a [`Hinge`].
pub type Slide<T, C = Level, const PLACE: u8 = 0, L = Spring, A = Absent> = Axis<T, AlongZ, C, PLACE, L, A>;

/// A joint of one coordinate about or along the z axis of the body that it carries: a [`Hinge`] or a [`Slide`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis<T, M, C = Level, const PLACE: u8 = 0, L = Spring, A = Absent> {
    place: [T; 3],
    offset: C,
    law: L,
    armature: A,
    mode: PhantomData<M>,
}

impl<T: Scalar, M: Mode> Axis<T, M> {
    /// At the origin of the parent, not turned, without spring, damper and reflected inertia.
    pub fn level() -> Self {
        Axis::sitting([T::zero(); 3])
    }

    /// At a place of the parent (m), in its axes. What `PLACE` leaves out must be zero.
    pub fn at<const PLACE: u8>(place: [T; 3]) -> Axis<T, M, Level, PLACE> {
        Axis::sitting(place)
    }
}

impl<T: Scalar, M: Mode, const PLACE: u8> Axis<T, M, Level, PLACE> {
    fn sitting(place: [T; 3]) -> Self {
        Self { place, offset: Level, law: Spring::none(), armature: Absent, mode: PhantomData }
    }
}

impl<T: Scalar, M: Mode, C, const PLACE: u8, L, A> Axis<T, M, C, PLACE, L, A> {
    /// With the body turned against its parent while the coordinate is zero.
    pub fn turned<N: Offset<T>>(self, offset: N) -> Axis<T, M, N, PLACE, L, A> {
        let Self { place, law, armature, mode, .. } = self;
        Axis { place, offset, law, armature, mode }
    }

    /// With a spring, a damper, or another law.
    pub fn with<N: SpringLaw<T>>(self, law: N) -> Axis<T, M, C, PLACE, N, A> {
        let Self { place, offset, armature, mode, .. } = self;
        Axis { place, offset, law, armature, mode }
    }

    /// With reflected inertia (kg·m², or kg of a slide): a rotor's times the square of its ratio. It counts along the coordinate alone; how a
    /// spinning rotor turns with its parent is left out, as usual.
    pub fn geared(self, inertia: T) -> Axis<T, M, C, PLACE, L, T> {
        let Self { place, offset, law, mode, .. } = self;
        Axis { place, offset, law, armature: inertia, mode }
    }

    /// Where the joint sits on its parent (m), in axes of that.
    pub fn place(&self) -> [T; 3]
    where
        T: Copy,
    {
        self.place
    }
}

/// What a coordinate makes of a joint: sine and cosine of an angle, or zero and the way.
pub type Stand<T> = [T; 2];

/// All that a joint has besides: what its methods need.
pub trait Standing<T: Scalar>: Copy {
    /// Whether the coordinate turns.
    const TURNS: bool;
    /// Where it sits.
    fn arm(&self) -> Triple<T>;
    /// Axes of the body, while the coordinate is zero, in those of the parent.
    fn offset(&self) -> Rows<T>;
    /// Reflected inertia.
    fn inertia(&self) -> Number<T>;
    /// What spring and damper exert.
    fn law(&self, position: T, rate: T) -> T;
    /// Energy of the spring.
    fn energy(&self, position: T) -> T;

    /// What the coordinate makes of it.
    #[inline(always)]
    fn stand(&self, position: T) -> Stand<T> {
        if const { Self::TURNS } {
            let (sine, cosine) = position.sin_cos();
            [sine, cosine]
        } else {
            [T::zero(), position]
        }
    }

    /// A vector of the parent's axes in those of the body.
    #[inline(always)]
    fn inward(&self, [sine, cosine]: Stand<T>, vector: Triple<T>) -> Triple<T> {
        let [x, y, z] = apply(&transposed(&self.offset()), vector);
        if const { Self::TURNS } {
            let (s, c) = (Number::of(sine), Number::of(cosine));
            [s.times_onto(y, c.times(x)), s.times_off(x, c.times(y)), z]
        } else {
            [x, y, z]
        }
    }

    /// A vector of the body's axes in those of the parent.
    #[inline(always)]
    fn outward(&self, [sine, cosine]: Stand<T>, [x, y, z]: Triple<T>) -> Triple<T> {
        let turned = if const { Self::TURNS } {
            let (s, c) = (Number::of(sine), Number::of(cosine));
            [s.times_off(y, c.times(x)), s.times_onto(x, c.times(y)), z]
        } else {
            [x, y, z]
        };
        apply(&self.offset(), turned)
    }

    /// Angular velocity of the body, from that of the parent, each in its own axes.
    #[inline(always)]
    fn spun(&self, stand: Stand<T>, rate: T, spin: [T; 3]) -> [T; 3] {
        let [x, y, z] = values(self.inward(stand, triple(spin)));
        if const { Self::TURNS } { [x, y, z + rate] } else { [x, y, z] }
    }

    /// What accelerates the joint's place besides the parent's origin, in axes of the parent.
    #[inline(always)]
    fn swung(&self, spin: [T; 3]) -> Triple<T> {
        apply(&swirl(spin), self.arm())
    }

    /// What accelerates the body besides, in its own axes, at its angular velocity: angular for a hinge (z is zero), linear for a slide.
    #[inline(always)]
    fn bias(&self, [_, way]: Stand<T>, rate: T, [x, y, z]: [T; 3]) -> [T; 3] {
        if const { Self::TURNS } {
            [rate * y, -(rate * x), T::zero()]
        } else {
            // 2 q̇ ω × z + q ω × (ω × z)
            let twice = rate + rate;
            let radial = way * z;
            [x.mul_add(radial, twice * y), y.mul_add(radial, -(twice * x)), -(way * x.mul_add(x, y * y))]
        }
    }

    /// Acceleration of the body's origin but for the coordinate, and of the body, from that of the parent.
    #[inline(always)]
    fn accelerated(
        &self,
        stand: Stand<T>,
        [swung, bias]: [Triple<T>; 2],
        [a, angular]: [Triple<T>; 2],
    ) -> [Triple<T>; 2] {
        let at_joint = cross_onto(angular, self.arm(), sum(a, swung));
        let (a, angular) = (self.inward(stand, at_joint), self.inward(stand, angular));
        if const { Self::TURNS } {
            [a, [angular[0].plus(bias[0]), angular[1].plus(bias[1]), angular[2]]]
        } else {
            let out = [Number::zero(), Number::zero(), Number::of(stand[1])];
            [cross_onto(angular, out, sum(a, bias)), angular]
        }
    }

    /// With the coordinate's own acceleration or rate.
    #[inline(always)]
    fn moved(&self, second: T, [mut a, mut angular]: [Triple<T>; 2]) -> [Triple<T>; 2] {
        let moved = if const { Self::TURNS } { &mut angular[2] } else { &mut a[2] };
        *moved = moved.plus(Number::of(second));
        [a, angular]
    }

    /// Force and torque at the parent's origin, from those at the body's.
    #[inline(always)]
    fn carried(&self, stand: Stand<T>, [force, torque]: [Triple<T>; 2]) -> [Triple<T>; 2] {
        let torque = if const { Self::TURNS } {
            torque
        } else {
            cross_onto([Number::zero(), Number::zero(), Number::of(stand[1])], force, torque)
        };
        let (force, torque) = (self.outward(stand, force), self.outward(stand, torque));
        [force, cross_onto(self.arm(), force, torque)]
    }

    /// Generalised force of a force and torque at the body's origin.
    #[inline(always)]
    fn along(&self, [force, torque]: [Triple<T>; 2]) -> T {
        if const { Self::TURNS } { torque[2].value() } else { force[2].value() }
    }
}

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>> Standing<T>
    for Axis<T, M, C, PLACE, L, A>
{
    const TURNS: bool = M::TURNS;

    #[inline(always)]
    fn arm(&self) -> Triple<T> {
        masked(PLACE, self.place)
    }
    #[inline(always)]
    fn offset(&self) -> Rows<T> {
        self.offset.rows()
    }
    #[inline(always)]
    fn inertia(&self) -> Number<T> {
        self.armature.number()
    }
    #[inline(always)]
    fn law(&self, position: T, rate: T) -> T {
        self.law.force(position, rate)
    }
    #[inline(always)]
    fn energy(&self, position: T) -> T {
        self.law.energy(position)
    }
}

/// Reflected inertia of a joint, or [`Absent`].
pub trait Armature<T: Scalar>: Term<T> + 'static {
    /// Whether there is any.
    const ON: bool;
    /// The inertia, known to be zero where there is none.
    fn number(self) -> Number<T>;
}

impl<T: Scalar> Armature<T> for Absent {
    const ON: bool = false;
    #[inline(always)]
    fn number(self) -> Number<T> {
        Number::zero()
    }
}

impl<T: Scalar> Armature<T> for T {
    const ON: bool = true;
    #[inline(always)]
    fn number(self) -> Number<T> {
        Number::of(self)
    }
}

crate::shape::leaf!(joint [T: Scalar, M: Mode, C: Offset<T>, L: SpringLaw<T>, A: Armature<T>, const PLACE: u8] Axis<T, M, C, PLACE, L, A>: Spatial<T>);

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>> Axis<T, M, C, PLACE, L, A> {
    /// What a posture holds: sine and cosine (or zero and the way), the acceleration of its place, that of the body.
    #[inline(always)]
    fn posture(x: &Columns<T>, y: &[Vector3<T>; 2]) -> (Stand<T>, [Triple<T>; 2]) {
        ([x.x.x, x.x.y], [triple(y[0].into()), triple(y[1].into())])
    }

    /// The place's acceleration as stored, with what is known of it.
    #[inline(always)]
    fn known_swung(swung: Triple<T>) -> Triple<T> {
        if const { PLACE & 7 == 0 } { [Number::zero(); 3] } else { swung }
    }

    /// The attitude of the body on a parent of an attitude.
    fn attitude(&self, position: T, parent: &Columns<T>) -> Columns<T> {
        let stand = self.stand(position);
        let axis = |k: usize| {
            let mut unit = [T::zero(); 3];
            unit[k] = T::one();
            parent.apply(Vector3::from(values(self.outward(stand, triple(unit)))))
        };
        Columns { x: axis(0), y: axis(1), z: axis(2) }
    }

    /// From the parent's origin to the body's, and the joint's axis, in inertial axes.
    fn reach(&self, position: T, parent: &Columns<T>) -> [Vector3<T>; 2] {
        let o = T::zero();
        let axis = values(apply(&self.offset.rows(), triple([o, o, T::one()])));
        let (arm, axis) = (parent.apply(Vector3::from(values(self.arm()))), parent.apply(Vector3::from(axis)));
        [if M::TURNS { arm } else { add_scaled(arm, position, axis) }, axis]
    }
}

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>> Joint<Spatial<T>>
    for Axis<T, M, C, PLACE, L, A>
{
    type Position = T;
    type Rate = T;
    type Kept<X: Closures> = Gains<T>;
    type Per<X: Copy> = X;

    const LINEAR: bool = L::LINEAR;
    const SINES: usize = M::TURNS as usize;

    #[inline(always)]
    fn angle(&self, position: &T) -> T {
        *position
    }
    #[inline(always)]
    fn set_sine(&self, x: &mut Columns<T>, [sine, cosine]: [T; 2]) {
        (x.x.x, x.x.y) = (sine, cosine);
    }

    fn position() -> T {
        T::zero()
    }
    fn rate() -> T {
        T::zero()
    }
    fn kept<X: Closures>() -> Gains<T> {
        Gains::blank()
    }
    fn per<X: Copy>(fill: X) -> X {
        fill
    }
    fn is_finite<X: Closures>(kept: &Gains<T>) -> bool {
        kept.is_finite()
    }
    /// The angle of the joint; its way stays.
    fn configure(&self, position: &mut T, inboard: Turn<T>, next: &mut impl FnMut(Turn<T>) -> T) -> Turn<T> {
        if M::TURNS {
            *position = next(inboard);
        }
        Turn { attitude: self.attitude(*position, &inboard.attitude), ..inboard }
    }
    #[inline(always)]
    fn recover<X: Closures, By: Springs<T>>(
        &self,
        inboard: Acceleration<T>,
        (x, y, _, _): JointPosture<'_, Spatial<T>, Self>,
        kept: &mut Gains<T>,
        _: &X::Each<T>,
        rate: &mut T,
    ) -> Acceleration<T> {
        let (stand, [swung, bias]) = Self::posture(x, y);
        let p = [triple(inboard.linear.into()), triple(inboard.angular.into())];
        let p = self.accelerated(stand, [Self::known_swung(swung), bias], p);
        self.released(p, kept, kept.free, const { A::ON || By::STIFF }, rate)
    }
    #[inline(always)]
    fn respond<X: Closures>(
        &self,
        inboard: Acceleration<T>,
        (x, y, _, _): JointPosture<'_, Spatial<T>, Self>,
        kept: &Gains<T>,
        _: &X::Each<T>,
        rate: &mut T,
    ) -> Acceleration<T> {
        let (stand, _) = Self::posture(x, y);
        let p = [triple(inboard.linear.into()), triple(inboard.angular.into())];
        let p = self.accelerated(stand, [[Number::zero(); 3]; 2], p);
        self.released(p, kept, T::zero(), true, rate)
    }
    fn motion(&self, inboard: Frame<T>, position: &T, rate: &T, acceleration: &T) -> (JointMotion<T>, Frame<T>) {
        let (q, v, turn) = (*position, *rate, inboard.turn);
        let [arm, n] = self.reach(q, &turn.attitude);
        let mut outboard = inboard.shifted(arm);
        outboard.turn.attitude = self.attitude(q, &turn.attitude);
        let swept = cross(turn.spin, n);
        if M::TURNS {
            outboard.turn.spin = add_scaled(turn.spin, v, n);
            let angular = &mut outboard.acceleration.angular;
            *angular = add_scaled(add_scaled(*angular, v, swept), *acceleration, n);
        } else {
            outboard.velocity = add_scaled(outboard.velocity, v, n);
            let linear = &mut outboard.acceleration.linear;
            *linear = add_scaled(add_scaled(*linear, v + v, swept), *acceleration, n);
        }
        let only = |x| [x, T::zero(), T::zero()];
        let motion = JointMotion {
            inboard,
            outboard,
            position: only(q),
            rate: only(v),
            effort: only(self.law.force(q, v)),
            energy: self.law.energy(q),
            inertia: only(self.armature.number().value()),
        };
        (motion, outboard)
    }
    fn release(&self, motion: &JointMotion<T>, position: &T, rate: &T) -> Release<Spatial<T>> {
        let (q, v, turn) = (*position, *rate, motion.inboard.turn);
        let [arm, n] = self.reach(q, &turn.attitude);
        let centripetal = cross(turn.spin, cross(turn.spin, arm));
        let swept = cross(turn.spin, n);
        let none = Release::nothing();
        let (release, way) = if M::TURNS {
            (Release { linear: centripetal, angular: swept * v, ..none }, Way::Turn)
        } else {
            (Release { linear: add_scaled(centripetal, v + v, swept), ..none }, Way::Slide)
        };
        let [stiffness, damping] = slopes::<T, _>(|springs| self.law.pivot(q, v, springs));
        let resistance = Resistance { force: self.law.force(q, v), stiffness, damping };
        let preload = self.law.force(T::zero(), T::zero());
        let freedom = Freedom::smooth(way, n).against(resistance, preload);
        release.with(Freedom { inertia: self.armature.number().value(), ..freedom })
    }
    fn check(&self) -> Result<(), Fault> {
        finite("place of a joint", &self.place)?;
        if (0..3).any(|k| PLACE >> k & 1 == 0 && self.place[k] != T::zero()) {
            return Err(Fault::NotZero { parameter: "place of a joint, where its mask says so" });
        }
        not_negative("reflected inertia", self.armature.add_to(T::zero()))?;
        self.offset.check()?;
        self.law.check()
    }
}

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>> Axis<T, M, C, PLACE, L, A> {
    /// The coordinate's acceleration, and that of the body: where nothing adds to the pivot, the share of its own axis is one.
    #[inline(always)]
    fn released(&self, p: [Triple<T>; 2], kept: &Gains<T>, free: T, stiffened: bool, rate: &mut T) -> Acceleration<T> {
        let (a, angular) = (values(p[0]), values(p[1]));
        let (la, ga) = (kept.linear, kept.angular);
        let mut total = free;
        for k in 0..3 {
            if M::TURNS || k < 2 || stiffened {
                total = (-la[k]).mul_add(a[k], total);
            }
            if !M::TURNS || k < 2 || stiffened {
                total = (-ga[k]).mul_add(angular[k], total);
            }
        }
        let own = if M::TURNS { angular[2] } else { a[2] };
        // Without, what is left is the acceleration along the axis itself.
        let (second, whole) = if stiffened { (total, total + own) } else { (total - own, total) };
        *rate = second;
        let (mut linear, mut angular) = (Vector3::from(a), Vector3::from(angular));
        if M::TURNS {
            angular.z = whole
        } else {
            linear.z = whole
        }
        Acceleration { linear, angular }
    }
}

impl<T: Scalar, M: Mode, C: Offset<T>, const PLACE: u8, L: SpringLaw<T>, A: Armature<T>> Element<Spatial<T>>
    for Axis<T, M, C, PLACE, L, A>
{
    type Position = T;
    type Rate = T;

    const ABSOLUTE: bool = false;

    fn lump(&mut self, _: T) -> T {
        T::zero() // links hand on none
    }
    #[inline(always)]
    fn turned(&self, position: &T, rate: &T, turn: Turn<T>) -> Turn<T> {
        Turn { spin: Vector3::from(self.spun(self.stand(*position), *rate, turn.spin.into())), ..turn }
    }
    #[inline(always)]
    fn orient(
        &self,
        position: &T,
        rate: &T,
        turn: Turn<T>,
        x: &mut Columns<T>,
        y: &mut [Vector3<T>; 2],
        _: &mut Vector3<T>,
        _: &mut Vector3<T>,
    ) -> Turn<T> {
        if const { !M::TURNS } {
            [x.x.x, x.x.y] = self.stand(*position);
        }
        let stand = [x.x.x, x.x.y];
        if const { PLACE & 7 != 0 } {
            y[0] = Vector3::from(values(self.swung(turn.spin.into())));
        }
        let spin = self.spun(stand, *rate, turn.spin.into());
        let bias = self.bias(stand, *rate, spin);
        (y[1].x, y[1].y) = (bias[0], bias[1]);
        if const { !M::TURNS } {
            y[1].z = bias[2];
        }
        Turn { spin: Vector3::from(spin), ..turn }
    }
    #[inline(always)]
    fn resolve((): &(), _: &mut Columns<T>, _: &mut [Vector3<T>; 2], _: &mut Vector3<T>, _: &mut Vector3<T>) {}
}

impl<T, M, C, const PLACE: u8, L, A> Counted for Axis<T, M, C, PLACE, L, A> {
    type Bodies = U0;
    type Freedoms = U1;
}

impl<T, M, C, const PLACE: u8, L, A, R, W> Condense<Spatial<T>, R, W> for Axis<T, M, C, PLACE, L, A>
where
    T: Scalar,
    M: Mode,
    C: Offset<T>,
    L: SpringLaw<T>,
    A: Armature<T>,
    R: Outboard<T>,
    W: Sweep<Spatial<T>, Springs: PivotRule<T>, Closures = Open>,
    InJoint<Spatial<T>, W>: Drive<T>,
{
    type Out = Local<T>;

    #[inline(always)]
    fn condense(
        &self,
        outer: R,
        posture: Posture<'_, Spatial<T>, Self>,
        given: Given<'_, Spatial<T>, Self, W>,
        kept: &mut Gains<T>,
    ) -> Local<T> {
        // Laws that are not linear are read where the last sweep has led.
        let stiff = const { <W::Springs as Springs<T>>::STIFF };
        let follows = const { !L::LINEAR && <W::Springs as Springs<T>>::STIFF };
        let (position, rate) = match follows {
            true => (*given.reading.position, *given.reading.rate),
            false => (*given.position, *given.rate),
        };
        let mut effort = given.in_joints.onto(0, self.law.force(position, rate));
        let mut more = self.inertia();
        if stiff {
            let stiffness = given.springs.stiffness(|springs| self.law.pivot(position, rate, springs));
            let stiffness = stiffness.add_to(T::zero());
            if follows {
                effort = stiffness.mul_add(*given.reading.acceleration, effort);
            }
            more = more.plus(Number::of(stiffness));
        }
        let stiffened = const { A::ON || <W::Springs as Springs<T>>::STIFF };
        let (stand, [swung, bias]) = Self::posture(posture.x, posture.y);
        let relation = outer.sparse();
        let relation = if const { M::TURNS } {
            let (relation, gains) = relation.hinged(effort, more, [bias[0].value(), bias[1].value()]);
            kept.set(gains, true, stiffened);
            relation.turned_about_z(stand[0], stand[1])
        } else {
            let (relation, gains) = relation.slid(effort, more, values(bias));
            kept.set(gains, false, stiffened);
            let o = Number::zero();
            relation.shifted([o, o, Number::of(stand[1])], [o; 3])
        };
        relation.turned(&self.offset.rows()).shifted(self.arm(), Self::known_swung(swung)).dense()
    }
}

impl<T, U, M, C, const PLACE: u8, L, A> Lift<T, U> for Axis<T, M, C, PLACE, L, A>
where
    T: Scalar,
    U: Scalar,
    C: Lift<T, U>,
    L: Lift<T, U>,
    A: Lift<T, U>,
{
    type Over = Axis<U, M, C::Over, PLACE, L::Over, A::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        Axis {
            place: self.place.lift(number),
            offset: self.offset.lift(number),
            law: self.law.lift(number),
            armature: self.armature.lift(number),
            mode: PhantomData,
        }
    }
}
