//! Macros that make elements of types of other crates.

/// Makes an element of a type that is a [`JointModel`](crate::extend::JointModel), in every space for which it is one. Generics come
/// first: `catena::joint!([T: Scalar, K: Copy + Debug + 'static] Geared<T, K>)`.
#[macro_export]
#[doc(hidden)] // listed in `extend`
macro_rules! joint {
    ([$($generics:tt)*] $Joint:ty) => {
        const _: () = {
            type CatenaKinematics<Spaced, Model> = <Model as $crate::extend::JointModel<Spaced>>::Kinematics;

            impl<Spaced: $crate::internals::element::Space, $($generics)*> $crate::internals::shape::Joint<Spaced> for $Joint
            where
                Self: $crate::extend::JointModel<Spaced>,
            {
                type Position = Spaced::Scalar;
                type Rate = Spaced::Scalar;
                type Kept<Closing: $crate::internals::relation::Closures> = <CatenaKinematics<Spaced, Self> as $crate::internals::shape::Joint<Spaced>>::Kept<Closing>;
                type Per<Kind: Copy> = <CatenaKinematics<Spaced, Self> as $crate::internals::shape::Joint<Spaced>>::Per<Kind>;

                const LINEAR: bool = <Self as $crate::extend::JointModel<Spaced>>::LINEAR;

                fn still() -> (Spaced::Scalar, Spaced::Scalar) {
                    <CatenaKinematics<Spaced, Self> as $crate::internals::shape::Joint<Spaced>>::still()
                }
                fn kept<Closing: $crate::internals::relation::Closures>() -> Self::Kept<Closing> {
                    <CatenaKinematics<Spaced, Self> as $crate::internals::shape::Joint<Spaced>>::kept::<Closing>()
                }
                fn per<Kind: Copy>(fill: Kind) -> Self::Per<Kind> {
                    <CatenaKinematics<Spaced, Self> as $crate::internals::shape::Joint<Spaced>>::per(fill)
                }
                fn is_finite<Closing: $crate::internals::relation::Closures>(kept: &Self::Kept<Closing>) -> bool {
                    <CatenaKinematics<Spaced, Self> as $crate::internals::shape::Joint<Spaced>>::is_finite::<Closing>(kept)
                }
                fn configure(
                    &self,
                    position: &mut Spaced::Scalar,
                    inboard: Spaced::Turn,
                    next: &mut impl FnMut(Spaced::Turn) -> Spaced::Scalar,
                ) -> Spaced::Turn {
                    $crate::internals::shape::Joint::configure($crate::extend::JointModel::<Spaced>::kinematics(self), position, inboard, next)
                }
                #[inline(always)]
                fn recover<Closing: $crate::internals::relation::Closures, By: $crate::internals::element::Springs<Spaced::Scalar>>(
                    &self,
                    inboard: $crate::internals::relation::AccelerationOf<Spaced>,
                    posture: $crate::internals::shape::JointPosture<'_, Spaced, Self>,
                    kept: &mut Self::Kept<Closing>,
                    multipliers: &Closing::Each<Spaced::Scalar>,
                    rate: &mut Spaced::Scalar,
                ) -> $crate::internals::relation::AccelerationOf<Spaced> {
                    $crate::extend::model::recover::<Spaced, Self, Closing>(self, inboard, posture, kept, multipliers, rate)
                }
                #[inline(always)]
                fn respond<Closing: $crate::internals::relation::Closures>(
                    &self,
                    inboard: $crate::internals::relation::AccelerationOf<Spaced>,
                    posture: $crate::internals::shape::JointPosture<'_, Spaced, Self>,
                    kept: &Self::Kept<Closing>,
                    multipliers: &Closing::Each<Spaced::Scalar>,
                    rate: &mut Spaced::Scalar,
                ) -> $crate::internals::relation::AccelerationOf<Spaced> {
                    let kinematics = $crate::extend::JointModel::<Spaced>::kinematics(self);
                    $crate::internals::shape::Joint::respond::<Closing>(kinematics, inboard, posture, kept, multipliers, rate)
                }
                #[inline(always)]
                fn motion(
                    &self,
                    inboard: $crate::internals::space::FrameOf<Spaced>,
                    position: &Spaced::Scalar,
                    rate: &Spaced::Scalar,
                    acceleration: &Spaced::Scalar,
                ) -> (Spaced::JointMotion, $crate::internals::space::FrameOf<Spaced>) {
                    $crate::extend::model::motion::<Spaced, Self>(self, inboard, [position, rate, acceleration])
                }
                #[inline(always)]
                fn release(
                    &self,
                    motion: &Spaced::JointMotion,
                    position: &Spaced::Scalar,
                    rate: &Spaced::Scalar,
                ) -> $crate::extend::Release<Spaced> {
                    $crate::extend::model::release::<Spaced, Self>(self, motion, position, rate)
                }
                fn check(&self) -> ::core::result::Result<(), $crate::Fault> {
                    $crate::extend::model::check::<Spaced, Self>(self)
                }
            }

            impl<Spaced: $crate::internals::element::Space, $($generics)*> $crate::internals::shape::Shape<Spaced> for $Joint
            where
                Self: $crate::extend::JointModel<Spaced>,
            {
                type Store<Stored: $crate::internals::shape::Field<Spaced>> = Stored::InJoint<Self>;

                const BODIES: ::core::option::Option<usize> = Some(0);
                const JOINTS: ::core::option::Option<usize> = Some(1);
                const LINEAR: bool = <Self as $crate::extend::JointModel<Spaced>>::LINEAR;

                fn store<Stored: $crate::internals::shape::Field<Spaced>>(&self, fill: Stored::Fill) -> Stored::InJoint<Self> {
                    Stored::in_joint(self, fill)
                }
                #[inline(always)]
                fn outward<Walk: $crate::internals::shape::Outward<Spaced>>(
                    &self,
                    walk: &mut Walk,
                    carried: Walk::Carried,
                    stores: $crate::internals::shape::Of<'_, Spaced, Walk, Self>,
                ) -> Walk::Carried {
                    walk.joint(self, carried, <Walk::Stores as $crate::internals::shape::Slot<Spaced>>::joint::<Self>(stores))
                }
                #[inline(always)]
                fn inward<Walk: $crate::internals::shape::Inward<Spaced>>(
                    &self,
                    walk: &mut Walk,
                    carried: Walk::Carried,
                    stores: $crate::internals::shape::Of<'_, Spaced, Walk, Self>,
                ) -> Walk::Carried {
                    walk.joint(self, carried, <Walk::Stores as $crate::internals::shape::Slot<Spaced>>::joint::<Self>(stores))
                }
            }

            impl<Spaced: $crate::internals::element::Space, $($generics)*> $crate::internals::shape::AsJoint<Spaced> for $Joint
            where
                Self: $crate::extend::JointModel<Spaced>,
            {
                #[inline(always)]
                fn entry<Stored: $crate::internals::shape::Field<Spaced>>(store: &Stored::InJoint<Self>) -> &Stored::InJoint<Self> {
                    store
                }
                #[inline(always)]
                fn entry_mut<Stored: $crate::internals::shape::Field<Spaced>>(store: &mut Stored::InJoint<Self>) -> &mut Stored::InJoint<Self> {
                    store
                }
            }

            impl<Spaced: $crate::internals::element::Space, $($generics)*> $crate::internals::element::Element<Spaced> for $Joint
            where
                Self: $crate::extend::JointModel<Spaced>,
            {
                type Position = Spaced::Scalar;
                type Rate = Spaced::Scalar;
                const ABSOLUTE: bool = false;

                fn lump(&mut self, mass: Spaced::Scalar) -> Spaced::Scalar {
                    $crate::extend::JointModel::<Spaced>::kinematics_mut(self).lump(mass)
                }
                #[inline(always)]
                fn turned(
                    &self,
                    position: &Spaced::Scalar,
                    rate: &Spaced::Scalar,
                    turn: Spaced::Turn,
                ) -> Spaced::Turn {
                    $crate::extend::JointModel::<Spaced>::kinematics(self).turned(position, rate, turn)
                }
                #[inline(always)]
                fn orient(
                    &self,
                    position: &Spaced::Scalar,
                    rate: &Spaced::Scalar,
                    turn: Spaced::Turn,
                    x: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::X>>,
                    y: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::Y>>,
                    p: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::P>>,
                    q: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::Q>>,
                ) -> Spaced::Turn {
                    $crate::extend::JointModel::<Spaced>::kinematics(self).orient(position, rate, turn, x, y, p, q)
                }
                #[inline(always)]
                fn resolve(
                    _: &Self::Store<$crate::internals::shape::PerAxes<Spaced::Size>>,
                    x: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::X>>,
                    y: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::Y>>,
                    p: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::P>>,
                    q: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::Q>>,
                ) {
                    <CatenaKinematics<Spaced, Self> as $crate::extend::Kinematics<Spaced>>::resolve(x, y, p, q);
                }
            }

            impl<Spaced, Outer, Sweeping, $($generics)*> $crate::internals::element::Condense<Spaced, Outer, Sweeping> for $Joint
            where
                Self: $crate::extend::JointModel<Spaced>,
                Spaced: $crate::internals::element::Space,
                Outer: $crate::extend::Outboard<Spaced>,
                Sweeping: $crate::internals::element::Sweep<Spaced, Closures = Outer::Closures>,
                $crate::internals::element::InJoint<Spaced, Sweeping>: $crate::extend::Driving<Spaced>,
            {
                type Out = $crate::internals::relation::Full<Spaced, Outer::Closures>;

                #[inline(always)]
                fn condense(
                    &self,
                    outer: Outer,
                    posture: $crate::internals::element::Posture<'_, Spaced, Self>,
                    given: $crate::internals::element::Given<'_, Spaced, Self, Sweeping>,
                    kept: &mut Self::Store<$crate::internals::shape::Kept<Outer::Closures>>,
                ) -> Self::Out {
                    let $crate::internals::element::Given { in_joints, position, rate, reading, springs, .. } = given;
                    let posture = (posture.x, posture.y, posture.p, posture.q);
                    let sought = ((*position, *rate), reading);
                    $crate::extend::model::condense::<Spaced, Self, Sweeping>(
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

        impl<$($generics)*> $crate::internals::counts::Counted for $Joint {
            type Bodies = $crate::extend::None;
            type Freedoms = $crate::extend::One;
        }
    };
}
