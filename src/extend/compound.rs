//! The macro that makes one element of several.

/// Makes an element of a type that consists of elements: `catena::compound!([T: Scalar] Tank<T> { parts: Parts<T> })` for a struct with
/// the field `parts` of that type, a tuple of bodies, joints and arms. It is an element of every space of which its parts are.
///
/// Its bodies, joints and coordinates are those of its parts, in their order: loads, readings and motions reach all of them. What goes through
/// its parts goes through it: gradients [backward](crate::sensitivity::Backward), Taylor series.
#[macro_export]
#[doc(hidden)] // listed in `extend`
macro_rules! compound {
    ([$($generics:tt)*] $Whole:ty { $parts:ident: $Parts:ty }) => {
        const _: () = {
            /// Where the parts are in the stores: these are those of the parts.
            #[derive(Clone, Copy)]
            struct CatenaParts;

            impl<Spaced: $crate::internals::element::Space, $($generics)*> $crate::internals::shape::Member<Spaced, $Whole> for CatenaParts
            where
                $Parts: $crate::internals::shape::Shape<Spaced>,
            {
                type Item = $Parts;

                #[inline(always)]
                fn get<Stored: $crate::internals::shape::Field<Spaced>>(
                    store: &<$Parts as $crate::internals::shape::Shape<Spaced>>::Store<Stored>,
                ) -> &<$Parts as $crate::internals::shape::Shape<Spaced>>::Store<Stored> {
                    store
                }
                #[inline(always)]
                fn get_mut<Stored: $crate::internals::shape::Field<Spaced>>(
                    store: &mut <$Parts as $crate::internals::shape::Shape<Spaced>>::Store<Stored>,
                ) -> &mut <$Parts as $crate::internals::shape::Shape<Spaced>>::Store<Stored> {
                    store
                }
            }

            impl<Spaced: $crate::internals::element::Space, $($generics)*> $crate::internals::shape::Shape<Spaced> for $Whole
            where
                $Parts: $crate::internals::shape::Shape<Spaced>,
            {
                type Store<Stored: $crate::internals::shape::Field<Spaced>> = <$Parts as $crate::internals::shape::Shape<Spaced>>::Store<Stored>;

                const BODIES: ::core::option::Option<usize> = <$Parts as $crate::internals::shape::Shape<Spaced>>::BODIES;
                const JOINTS: ::core::option::Option<usize> = <$Parts as $crate::internals::shape::Shape<Spaced>>::JOINTS;
                const LOOPS: usize = <$Parts as $crate::internals::shape::Shape<Spaced>>::LOOPS;
                const SHARES: bool = <$Parts as $crate::internals::shape::Shape<Spaced>>::SHARES;
                const LINEAR: bool = <$Parts as $crate::internals::shape::Shape<Spaced>>::LINEAR;
                const ROTARY: bool = <$Parts as $crate::internals::shape::Shape<Spaced>>::ROTARY;
                const OWN_AXES: bool = <$Parts as $crate::internals::shape::Shape<Spaced>>::OWN_AXES;
                const SINES: usize = <$Parts as $crate::internals::shape::Shape<Spaced>>::SINES;
                const FLANGED: bool = <$Parts as $crate::internals::shape::Shape<Spaced>>::FLANGED;

                fn store<Stored: $crate::internals::shape::Field<Spaced>>(&self, fill: Stored::Fill) -> Self::Store<Stored> {
                    $crate::internals::shape::Shape::<Spaced>::store::<Stored>(&self.$parts, fill)
                }
                #[inline(always)]
                fn outward<Walk: $crate::internals::shape::Outward<Spaced>>(
                    &self,
                    walk: &mut Walk,
                    carried: Walk::Carried,
                    mut stores: $crate::internals::shape::Of<'_, Spaced, Walk, Self>,
                ) -> Walk::Carried {
                    let stores = <Walk::Stores as $crate::internals::shape::Slot<Spaced>>::member::<Self, _>(&mut stores, CatenaParts);
                    $crate::internals::shape::Shape::<Spaced>::outward(&self.$parts, walk, carried, stores)
                }
                #[inline(always)]
                fn inward<Walk: $crate::internals::shape::Inward<Spaced>>(
                    &self,
                    walk: &mut Walk,
                    carried: Walk::Carried,
                    mut stores: $crate::internals::shape::Of<'_, Spaced, Walk, Self>,
                ) -> Walk::Carried {
                    let stores = <Walk::Stores as $crate::internals::shape::Slot<Spaced>>::member::<Self, _>(&mut stores, CatenaParts);
                    $crate::internals::shape::Shape::<Spaced>::inward(&self.$parts, walk, carried, stores)
                }
            }

            impl<Spaced: $crate::internals::element::Space, $($generics)*> $crate::internals::element::Element<Spaced> for $Whole
            where
                $Parts: $crate::internals::element::Element<Spaced>,
            {
                type Position = <$Parts as $crate::internals::element::Element<Spaced>>::Position;
                type Rate = <$Parts as $crate::internals::element::Element<Spaced>>::Rate;
                const ABSOLUTE: bool = <$Parts as $crate::internals::element::Element<Spaced>>::ABSOLUTE;
                const TURNS_ANEW: bool = <$Parts as $crate::internals::element::Element<Spaced>>::TURNS_ANEW;

                fn lump(&mut self, mass: Spaced::Scalar) -> Spaced::Scalar {
                    $crate::internals::element::Element::<Spaced>::lump(&mut self.$parts, mass)
                }
                #[inline(always)]
                fn turned(&self, position: &Self::Position, rate: &Self::Rate, turn: Spaced::Turn) -> Spaced::Turn {
                    $crate::internals::element::Element::<Spaced>::turned(&self.$parts, position, rate, turn)
                }
                #[inline(always)]
                fn orient(
                    &self,
                    position: &Self::Position,
                    rate: &Self::Rate,
                    turn: Spaced::Turn,
                    x: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::X>>,
                    y: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::Y>>,
                    p: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::P>>,
                    q: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::Q>>,
                ) -> Spaced::Turn {
                    $crate::internals::element::Element::<Spaced>::orient(&self.$parts, position, rate, turn, x, y, p, q)
                }
                #[inline(always)]
                fn resolve(
                    sizes: &Self::Store<$crate::internals::shape::PerAxes<Spaced::Size>>,
                    x: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::X>>,
                    y: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::Y>>,
                    p: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::P>>,
                    q: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::Q>>,
                ) {
                    <$Parts as $crate::internals::element::Element<Spaced>>::resolve(sizes, x, y, p, q);
                }
                #[inline(always)]
                fn pose(
                    &self,
                    position: &Self::Position,
                    rate: &Self::Rate,
                    turn: Spaced::Turn,
                    sizes: &Self::Store<$crate::internals::shape::PerAxes<Spaced::Size>>,
                    x: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::X>>,
                    y: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::Y>>,
                    p: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::P>>,
                    q: &mut Self::Store<$crate::internals::shape::PerAxes<Spaced::Q>>,
                ) -> Spaced::Turn {
                    $crate::internals::element::Element::<Spaced>::pose(&self.$parts, position, rate, turn, sizes, x, y, p, q)
                }
            }

            impl<Spaced, Outer, Sweeping, $($generics)*> $crate::internals::element::Condense<Spaced, Outer, Sweeping> for $Whole
            where
                Spaced: $crate::internals::element::Space,
                Sweeping: $crate::internals::element::Sweep<Spaced>,
                $Parts: $crate::internals::element::Condense<Spaced, Outer, Sweeping>,
            {
                type Out = <$Parts as $crate::internals::element::Condense<Spaced, Outer, Sweeping>>::Out;

                #[inline(always)]
                fn condense(
                    &self,
                    outer: Outer,
                    $crate::internals::element::Posture { x, y, p, q }: $crate::internals::element::Posture<'_, Spaced, Self>,
                    given: $crate::internals::element::Given<'_, Spaced, Self, Sweeping>,
                    kept: &mut Self::Store<$crate::internals::shape::Kept<Sweeping::Closures>>,
                ) -> Self::Out {
                    let $crate::internals::element::Given { on_bodies, in_joints, position, rate, reading, springs } = given;
                    let given = $crate::internals::element::Given { on_bodies, in_joints, position, rate, reading, springs };
                    $crate::internals::element::Condense::<Spaced, Outer, Sweeping>::condense(
                        &self.$parts,
                        outer,
                        $crate::internals::element::Posture { x, y, p, q },
                        given,
                        kept,
                    )
                }
            }

            impl<Spaced, Walk, $($generics)*> $crate::internals::shape::Takes<Spaced, Walk> for $Whole
            where
                Spaced: $crate::internals::element::Space,
                Walk: $crate::internals::shape::Selective<Spaced>,
                $Parts: $crate::internals::shape::Takes<Spaced, Walk>,
            {
                #[inline(always)]
                fn take(
                    &self,
                    walk: &mut Walk,
                    carried: Walk::Carried,
                    mut stores: $crate::internals::shape::Of<'_, Spaced, Walk, Self>,
                ) -> Walk::Carried {
                    let stores = <Walk::Stores as $crate::internals::shape::Slot<Spaced>>::member::<Self, _>(&mut stores, CatenaParts);
                    $crate::internals::shape::Takes::<Spaced, Walk>::take(&self.$parts, walk, carried, stores)
                }
            }

            impl<$($generics)*> $crate::internals::counts::Counted for $Whole
            where
                $Parts: $crate::internals::counts::Counted,
            {
                type Bodies = <$Parts as $crate::internals::counts::Counted>::Bodies;
                type Freedoms = <$Parts as $crate::internals::counts::Counted>::Freedoms;
            }
        };
    };
}
