//! Joints at which nothing moves: what walks of the costate sweep that read no attitudes do there.

/// Passes on what elimination, recovery of accelerations and solution with another right-hand side carry, as it is.
macro_rules! passes {
    ($Space:ident, $Joint:ty) => {
        passes!($Space, $Joint, Factor<C, By>, [By: Springs<T>]);
        passes!($Space, $Joint, Reach<T, C>, []);
        passes!($Space, $Joint, Meet<T, C>, []);
    };
    ($Space:ident, $Joint:ty, $Walk:ty, [$($Bounds:tt)*]) => {
        impl<T: Scalar, C: Closures, $($Bounds)*> Takes<$Space<T>, $Walk> for $Joint {
            #[cfg_attr(optimised, inline(always))]
            fn take(
                &self,
                _: &mut $Walk,
                carried: <$Walk as Walk<$Space<T>>>::Carried,
                _: Of<'_, $Space<T>, $Walk, Self>,
            ) -> <$Walk as Walk<$Space<T>>>::Carried {
                carried
            }
        }
    };
}
pub(crate) use passes;
