//! Several laws along one coordinate: a tuple of laws is a law.

use super::SpringLaw;
use crate::element::Springs;
use crate::error::Fault;
use crate::scalar::Scalar;

/// Makes tuples of laws a law: forces, energies and slopes add up.
macro_rules! laws {
    ($($Law:ident $i:tt),*) => {
        impl<T: Scalar, $($Law: SpringLaw<T>),*> SpringLaw<T> for ($($Law,)*) {
            const LINEAR: bool = true $(&& $Law::LINEAR)*;
            const ANALYTIC: bool = true $(&& $Law::ANALYTIC)*;

            #[cfg_attr(optimised, inline(always))]
            fn force(&self, position: T, rate: T) -> T {
                let mut sum = T::zero();
                $(sum = self.$i.force(position, rate) + sum;)*
                sum
            }
            fn energy(&self, position: T) -> T {
                let mut sum = T::zero();
                $(sum = self.$i.energy(position) + sum;)*
                sum
            }
            #[cfg_attr(optimised, inline(always))]
            fn pivot(&self, position: T, rate: T, springs: impl Springs<T>) -> T {
                let mut sum = T::zero();
                $(sum = self.$i.pivot(position, rate, springs) + sum;)*
                sum
            }
            fn check(&self) -> Result<(), Fault> {
                $(self.$i.check()?;)*
                Ok(())
            }
        }
    };
}
laws!(A 0, B 1);
laws!(A 0, B 1, C 2);
laws!(A 0, B 1, C 2, D 3);
laws!(A 0, B 1, C 2, D 3, E 4);
