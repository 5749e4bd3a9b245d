//! Macros that make elements of types of other crates.

/// Makes an element of a type that is a [`JointModel`](crate::extend::JointModel), in every space for which it is one. Generics come
/// first: `catena::joint!([T: Scalar, K: Copy + Debug + 'static] Geared<T, K>)`.
#[macro_export]
macro_rules! joint {
    ([$($generics:tt)*] $Joint:ty) => {
        const _: () = {
            use $crate::element::{Condense, Element, Given, InJoint, Posture, Space, Springs, Sweep};
            use $crate::extend::{Driving, JointModel, Jointed, Kinematics, Outboard, model};
            use $crate::relation::Closures;
            use $crate::shape::{self, AsJoint, Field, Inward, JointPosture, Kept, Of, Outward, PerAxes, Shape, Slot};
            use ::core::{option::Option, result::Result};

            type Of_<Spaced, Model> = <Model as JointModel<Spaced>>::Kinematics;

            impl<Spaced: Jointed, $($generics)*> shape::Joint<Spaced> for $Joint
            where
                Self: JointModel<Spaced>,
            {
                type Position = Spaced::Scalar;
                type Rate = Spaced::Scalar;
                type Kept<Closing: Closures> = <Of_<Spaced, Self> as shape::Joint<Spaced>>::Kept<Closing>;
                type Per<Kind: Copy> = <Of_<Spaced, Self> as shape::Joint<Spaced>>::Per<Kind>;

                const LINEAR: bool = <Self as JointModel<Spaced>>::LINEAR;

                fn position() -> Spaced::Scalar {
                    <Of_<Spaced, Self> as shape::Joint<Spaced>>::position()
                }
                fn rate() -> Spaced::Scalar {
                    <Of_<Spaced, Self> as shape::Joint<Spaced>>::rate()
                }
                fn kept<Closing: Closures>() -> Self::Kept<Closing> {
                    <Of_<Spaced, Self> as shape::Joint<Spaced>>::kept::<Closing>()
                }
                fn per<Kind: Copy>(fill: Kind) -> Self::Per<Kind> {
                    <Of_<Spaced, Self> as shape::Joint<Spaced>>::per(fill)
                }
                fn is_finite<Closing: Closures>(kept: &Self::Kept<Closing>) -> bool {
                    <Of_<Spaced, Self> as shape::Joint<Spaced>>::is_finite::<Closing>(kept)
                }
                fn aim(
                    &self,
                    position: &mut Spaced::Scalar,
                    inboard: Spaced::Turn,
                    next: &mut impl FnMut(Spaced::Turn) -> Spaced::Scalar,
                ) -> Spaced::Turn {
                    shape::Joint::aim(JointModel::<Spaced>::kinematics(self), position, inboard, next)
                }
                #[inline(always)]
                fn recover<Closing: Closures, By: Springs<Spaced::Scalar>>(
                    &self,
                    inboard: Spaced::Acceleration,
                    posture: JointPosture<'_, Spaced, Self>,
                    kept: &mut Self::Kept<Closing>,
                    multipliers: &Closing::Each<Spaced::Scalar>,
                    rate: &mut Spaced::Scalar,
                ) -> Spaced::Acceleration {
                    model::recover::<Spaced, Self, Closing>(self, inboard, posture, kept, multipliers, rate)
                }
                #[inline(always)]
                fn respond<Closing: Closures>(
                    &self,
                    inboard: Spaced::Acceleration,
                    posture: JointPosture<'_, Spaced, Self>,
                    kept: &Self::Kept<Closing>,
                    multipliers: &Closing::Each<Spaced::Scalar>,
                    rate: &mut Spaced::Scalar,
                ) -> Spaced::Acceleration {
                    let kinematics = JointModel::<Spaced>::kinematics(self);
                    shape::Joint::respond::<Closing>(kinematics, inboard, posture, kept, multipliers, rate)
                }
                #[inline(always)]
                fn motion(
                    &self,
                    inboard: Spaced::Frame,
                    position: &Spaced::Scalar,
                    rate: &Spaced::Scalar,
                    acceleration: &Spaced::Scalar,
                ) -> (Spaced::JointMotion, Spaced::Frame) {
                    model::motion::<Spaced, Self>(self, inboard, [position, rate, acceleration])
                }
                #[inline(always)]
                fn release(
                    &self,
                    motion: &Spaced::JointMotion,
                    position: &Spaced::Scalar,
                    rate: &Spaced::Scalar,
                ) -> Spaced::Release {
                    model::release::<Spaced, Self>(self, motion, position, rate)
                }
                fn check(&self) -> Result<(), $crate::Fault> {
                    model::check::<Spaced, Self>(self)
                }
            }

            impl<Spaced: Jointed, $($generics)*> Shape<Spaced> for $Joint
            where
                Self: JointModel<Spaced>,
            {
                type Store<Stored: Field<Spaced>> = Stored::InJoint<Self>;

                const BODIES: Option<usize> = Some(0);
                const JOINTS: Option<usize> = Some(1);
                const LINEAR: bool = <Self as JointModel<Spaced>>::LINEAR;

                fn store<Stored: Field<Spaced>>(&self, fill: Stored::Fill) -> Stored::InJoint<Self> {
                    Stored::in_joint(self, fill)
                }
                #[inline(always)]
                fn outward<Walk: Outward<Spaced>>(
                    &self,
                    walk: &mut Walk,
                    carried: Walk::Carried,
                    stores: Of<'_, Spaced, Walk, Self>,
                ) -> Walk::Carried {
                    walk.joint(self, carried, <Walk::Stores as Slot<Spaced>>::joint::<Self>(stores))
                }
                #[inline(always)]
                fn inward<Walk: Inward<Spaced>>(
                    &self,
                    walk: &mut Walk,
                    carried: Walk::Carried,
                    stores: Of<'_, Spaced, Walk, Self>,
                ) -> Walk::Carried {
                    walk.joint(self, carried, <Walk::Stores as Slot<Spaced>>::joint::<Self>(stores))
                }
            }

            impl<Spaced: Jointed, $($generics)*> AsJoint<Spaced> for $Joint
            where
                Self: JointModel<Spaced>,
            {
                #[inline(always)]
                fn entry<Stored: Field<Spaced>>(store: &Stored::InJoint<Self>) -> &Stored::InJoint<Self> {
                    store
                }
                #[inline(always)]
                fn entry_mut<Stored: Field<Spaced>>(store: &mut Stored::InJoint<Self>) -> &mut Stored::InJoint<Self> {
                    store
                }
            }

            impl<Spaced: Jointed, $($generics)*> Element<Spaced> for $Joint
            where
                Self: JointModel<Spaced>,
            {
                type Position = Spaced::Scalar;
                type Rate = Spaced::Scalar;
                const ABSOLUTE: bool = false;

                fn lump(&mut self, mass: Spaced::Scalar) -> Spaced::Scalar {
                    JointModel::<Spaced>::kinematics_mut(self).lump(mass)
                }
                #[inline(always)]
                fn turned(
                    &self,
                    position: &Spaced::Scalar,
                    rate: &Spaced::Scalar,
                    turn: Spaced::Turn,
                ) -> Spaced::Turn {
                    JointModel::<Spaced>::kinematics(self).turned(position, rate, turn)
                }
                #[inline(always)]
                fn orient(
                    &self,
                    position: &Spaced::Scalar,
                    rate: &Spaced::Scalar,
                    turn: Spaced::Turn,
                    x: &mut Self::Store<PerAxes<Spaced::X>>,
                    y: &mut Self::Store<PerAxes<Spaced::Y>>,
                    p: &mut Self::Store<PerAxes<Spaced::P>>,
                    q: &mut Self::Store<PerAxes<Spaced::Q>>,
                ) -> Spaced::Turn {
                    JointModel::<Spaced>::kinematics(self).orient(position, rate, turn, x, y, p, q)
                }
                #[inline(always)]
                fn resolve(
                    _: &Self::Store<PerAxes<Spaced::Size>>,
                    x: &mut Self::Store<PerAxes<Spaced::X>>,
                    y: &mut Self::Store<PerAxes<Spaced::Y>>,
                    p: &mut Self::Store<PerAxes<Spaced::P>>,
                    q: &mut Self::Store<PerAxes<Spaced::Q>>,
                ) {
                    <Of_<Spaced, Self> as Kinematics<Spaced>>::resolve(x, y, p, q);
                }
            }

            impl<Spaced, Outer, Sweeping, $($generics)*> Condense<Spaced, Outer, Sweeping> for $Joint
            where
                Self: JointModel<Spaced>,
                Spaced: Jointed,
                Outer: Outboard<Spaced>,
                Sweeping: Sweep<Spaced, Closures = Outer::Closures>,
                InJoint<Spaced, Sweeping>: Driving<Spaced>,
            {
                type Out = Spaced::Full<Outer::Closures>;

                #[inline(always)]
                fn condense(
                    &self,
                    outer: Outer,
                    posture: Posture<'_, Spaced, Self>,
                    given: Given<'_, Spaced, Self, Sweeping>,
                    kept: &mut Self::Store<Kept<Outer::Closures>>,
                ) -> Self::Out {
                    let Given { in_joints, position, rate, reading, springs, .. } = given;
                    let posture = (posture.x, posture.y, posture.p, posture.q);
                    let sought = ((*position, *rate), reading);
                    model::condense::<Spaced, Self, Sweeping>(
                        self,
                        outer.whole(),
                        posture,
                        *in_joints,
                        sought,
                        springs,
                        kept,
                    )
                }
            }
        };

        impl<$($generics)*> $crate::counts::Counted for $Joint {
            type Bodies = $crate::extend::None;
            type Freedoms = $crate::extend::One;
        }
    };
}
