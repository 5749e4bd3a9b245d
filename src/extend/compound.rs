//! The macro that makes one element of several.

/// Makes an element of a type that consists of elements: `catena::compound!([T: Scalar] Tank<T> { parts: Parts<T> })` for a struct with
/// the field `parts` of that type, a tuple of bodies, joints and arms. It is an element of every space of which its parts are.
///
/// Its bodies, joints and coordinates are those of its parts, in their order: loads, readings and motions reach all of them.
#[macro_export]
macro_rules! compound {
    ([$($generics:tt)*] $Whole:ty { $parts:ident: $Parts:ty }) => {
        const _: () = {
            /// Where the parts are in the stores: these are those of the parts.
            #[derive(Clone, Copy)]
            struct CatenaParts;

            impl<Spaced: $crate::element::Space, $($generics)*> $crate::shape::Member<Spaced, $Whole> for CatenaParts
            where
                $Parts: $crate::shape::Shape<Spaced>,
            {
                type Item = $Parts;

                #[inline(always)]
                fn get<Stored: $crate::shape::Field<Spaced>>(
                    store: &<$Parts as $crate::shape::Shape<Spaced>>::Store<Stored>,
                ) -> &<$Parts as $crate::shape::Shape<Spaced>>::Store<Stored> {
                    store
                }
                #[inline(always)]
                fn get_mut<Stored: $crate::shape::Field<Spaced>>(
                    store: &mut <$Parts as $crate::shape::Shape<Spaced>>::Store<Stored>,
                ) -> &mut <$Parts as $crate::shape::Shape<Spaced>>::Store<Stored> {
                    store
                }
            }

            impl<Spaced: $crate::element::Space, $($generics)*> $crate::shape::Shape<Spaced> for $Whole
            where
                $Parts: $crate::shape::Shape<Spaced>,
            {
                type Store<Stored: $crate::shape::Field<Spaced>> = <$Parts as $crate::shape::Shape<Spaced>>::Store<Stored>;

                const BODIES: ::core::option::Option<usize> = <$Parts as $crate::shape::Shape<Spaced>>::BODIES;
                const JOINTS: ::core::option::Option<usize> = <$Parts as $crate::shape::Shape<Spaced>>::JOINTS;
                const LOOPS: usize = <$Parts as $crate::shape::Shape<Spaced>>::LOOPS;
                const LINEAR: bool = <$Parts as $crate::shape::Shape<Spaced>>::LINEAR;

                fn store<Stored: $crate::shape::Field<Spaced>>(&self, fill: Stored::Fill) -> Self::Store<Stored> {
                    $crate::shape::Shape::<Spaced>::store::<Stored>(&self.$parts, fill)
                }
                #[inline(always)]
                fn outward<Walk: $crate::shape::Outward<Spaced>>(
                    &self,
                    walk: &mut Walk,
                    carried: Walk::Carried,
                    mut stores: $crate::shape::Of<'_, Spaced, Walk, Self>,
                ) -> Walk::Carried {
                    let stores = <Walk::Stores as $crate::shape::Slot<Spaced>>::member::<Self, _>(&mut stores, CatenaParts);
                    $crate::shape::Shape::<Spaced>::outward(&self.$parts, walk, carried, stores)
                }
                #[inline(always)]
                fn inward<Walk: $crate::shape::Inward<Spaced>>(
                    &self,
                    walk: &mut Walk,
                    carried: Walk::Carried,
                    mut stores: $crate::shape::Of<'_, Spaced, Walk, Self>,
                ) -> Walk::Carried {
                    let stores = <Walk::Stores as $crate::shape::Slot<Spaced>>::member::<Self, _>(&mut stores, CatenaParts);
                    $crate::shape::Shape::<Spaced>::inward(&self.$parts, walk, carried, stores)
                }
            }

            impl<Spaced: $crate::element::Space, $($generics)*> $crate::element::Element<Spaced> for $Whole
            where
                $Parts: $crate::element::Element<Spaced>,
            {
                type Position = <$Parts as $crate::element::Element<Spaced>>::Position;
                type Rate = <$Parts as $crate::element::Element<Spaced>>::Rate;
                const ABSOLUTE: bool = <$Parts as $crate::element::Element<Spaced>>::ABSOLUTE;

                fn lump(&mut self, mass: Spaced::Scalar) -> Spaced::Scalar {
                    $crate::element::Element::<Spaced>::lump(&mut self.$parts, mass)
                }
                #[inline(always)]
                fn turned(&self, position: &Self::Position, rate: &Self::Rate, turn: Spaced::Turn) -> Spaced::Turn {
                    $crate::element::Element::<Spaced>::turned(&self.$parts, position, rate, turn)
                }
                #[inline(always)]
                fn orient(
                    &self,
                    position: &Self::Position,
                    rate: &Self::Rate,
                    turn: Spaced::Turn,
                    x: &mut Self::Store<$crate::shape::PerAxes<Spaced::X>>,
                    y: &mut Self::Store<$crate::shape::PerAxes<Spaced::Y>>,
                    p: &mut Self::Store<$crate::shape::PerAxes<Spaced::P>>,
                    q: &mut Self::Store<$crate::shape::PerAxes<Spaced::Q>>,
                ) -> Spaced::Turn {
                    $crate::element::Element::<Spaced>::orient(&self.$parts, position, rate, turn, x, y, p, q)
                }
                #[inline(always)]
                fn resolve(
                    sizes: &Self::Store<$crate::shape::PerAxes<Spaced::Size>>,
                    x: &mut Self::Store<$crate::shape::PerAxes<Spaced::X>>,
                    y: &mut Self::Store<$crate::shape::PerAxes<Spaced::Y>>,
                    p: &mut Self::Store<$crate::shape::PerAxes<Spaced::P>>,
                    q: &mut Self::Store<$crate::shape::PerAxes<Spaced::Q>>,
                ) {
                    <$Parts as $crate::element::Element<Spaced>>::resolve(sizes, x, y, p, q);
                }
                #[inline(always)]
                fn pose(
                    &self,
                    position: &Self::Position,
                    rate: &Self::Rate,
                    turn: Spaced::Turn,
                    sizes: &Self::Store<$crate::shape::PerAxes<Spaced::Size>>,
                    x: &mut Self::Store<$crate::shape::PerAxes<Spaced::X>>,
                    y: &mut Self::Store<$crate::shape::PerAxes<Spaced::Y>>,
                    p: &mut Self::Store<$crate::shape::PerAxes<Spaced::P>>,
                    q: &mut Self::Store<$crate::shape::PerAxes<Spaced::Q>>,
                ) -> Spaced::Turn {
                    $crate::element::Element::<Spaced>::pose(&self.$parts, position, rate, turn, sizes, x, y, p, q)
                }
            }

            impl<Spaced, Outer, Sweeping, $($generics)*> $crate::element::Condense<Spaced, Outer, Sweeping> for $Whole
            where
                Spaced: $crate::element::Space,
                Sweeping: $crate::element::Sweep<Spaced>,
                $Parts: $crate::element::Condense<Spaced, Outer, Sweeping>,
            {
                type Out = <$Parts as $crate::element::Condense<Spaced, Outer, Sweeping>>::Out;

                #[inline(always)]
                fn condense(
                    &self,
                    outer: Outer,
                    $crate::element::Posture { x, y, p, q }: $crate::element::Posture<'_, Spaced, Self>,
                    given: $crate::element::Given<'_, Spaced, Self, Sweeping>,
                    kept: &mut Self::Store<$crate::shape::Kept<Sweeping::Closures>>,
                ) -> Self::Out {
                    let $crate::element::Given { on_bodies, in_joints, position, rate, reading, springs } = given;
                    let given = $crate::element::Given { on_bodies, in_joints, position, rate, reading, springs };
                    $crate::element::Condense::<Spaced, Outer, Sweeping>::condense(
                        &self.$parts,
                        outer,
                        $crate::element::Posture { x, y, p, q },
                        given,
                        kept,
                    )
                }
            }

            impl<$($generics)*> $crate::counts::Counted for $Whole
            where
                $Parts: $crate::counts::Counted,
            {
                type Bodies = <$Parts as $crate::counts::Counted>::Bodies;
                type Freedoms = <$Parts as $crate::counts::Counted>::Freedoms;
            }
        };
    };
}
