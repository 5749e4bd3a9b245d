//! Laws of users.

use super::SpringLaw;
use crate::element::Springs;
use crate::error::Fault;
use crate::lift::lift;
use crate::scalar::Scalar;

/// A law of the user's own in a joint, or between the ends of a [strut](crate::planar::Strut::with_law): through it runs go backward as soon as it is generic
/// over the scalar and can be lifted ([`lift!`](crate::lift!)). See [`ElasticHinge::with`](crate::planar::ElasticHinge::with).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Custom<L>(pub L);

impl<T: Scalar, L: SpringLaw<T>> SpringLaw<T> for Custom<L> {
    const LINEAR: bool = L::LINEAR;
    const ANALYTIC: bool = L::ANALYTIC;

    #[inline(always)]
    fn force(&self, position: T, rate: T) -> T {
        self.0.force(position, rate)
    }
    fn energy(&self, position: T) -> T {
        self.0.energy(position)
    }
    #[inline(always)]
    fn pivot(&self, position: T, rate: T, springs: impl Springs<T>) -> T {
        self.0.pivot(position, rate, springs)
    }
    fn check(&self) -> Result<(), Fault> {
        self.0.check()
    }
}

lift!(Custom<L> { 0 });
