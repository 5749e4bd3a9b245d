//! The costate sweep in space: loads on bodies among the gains of joints, and bodies and joints without a law.
//!
//! What joints eliminate of a costate they eliminate of a load.

use crate::adjoint::laws::ReversibleLaw;
use crate::mechanics::spatial::{Ball, Floating, PointMass, Revolute, RigidBody, Rod, Spatial, Weld, Wrench};
use crate::relation::Closures;
use crate::scalar::Scalar;
use crate::shape::{Of, Takes};
use crate::walks::{Burden, Strain};
use nalgebra::Vector3;

macro_rules! bodies {
    ($($Body:ident),*) => {$(
        impl<T: Scalar, C: Closures> Takes<Spatial<T>, Burden<T, C>> for $Body<T> {
            fn take(
                &self,
                walk: &mut Burden<T, C>,
                outer: Wrench<T>,
                (x, y, p, q, (_, load), ..): Of<'_, Spatial<T>, Burden<T, C>, Self>,
            ) -> Wrench<T> {
                let inner = self.take(&mut walk.0, outer, (x, y, p, q, &(), &(), &mut (), &mut ()));
                inner - *load
            }
        }
    )*};
}
bodies!(Rod, RigidBody, PointMass);

impl<T: Scalar, C: Closures> Takes<Spatial<T>, Burden<T, C>> for Ball {
    fn take(
        &self,
        walk: &mut Burden<T, C>,
        outer: Wrench<T>,
        (x, y, p, q, (), gain, pivot): Of<'_, Spatial<T>, Burden<T, C>, Self>,
    ) -> Wrench<T> {
        let mut more = [T::zero(); 3];
        let inner = self.take(&mut walk.0, outer, (x, y, p, q, gain, pivot, &mut more, &mut ()));
        gain.free += Vector3::from(more);
        inner
    }
}

impl<T: Scalar, C: Closures, L: ReversibleLaw<T>> Takes<Spatial<T>, Burden<T, C>> for Revolute<T, L> {
    fn take(
        &self,
        walk: &mut Burden<T, C>,
        outer: Wrench<T>,
        (x, y, p, q, (), gain, pivot): Of<'_, Spatial<T>, Burden<T, C>, Self>,
    ) -> Wrench<T> {
        let mut more = T::zero();
        let inner = self.take(&mut walk.0, outer, (x, y, p, q, &*gain, pivot, &mut more, &mut ()));
        gain[0].free += more;
        inner
    }
}

impl<T: Scalar, C: Closures> Takes<Spatial<T>, Burden<T, C>> for Weld<T> {
    fn take(&self, _: &mut Burden<T, C>, outer: Wrench<T>, _: Of<'_, Spatial<T>, Burden<T, C>, Self>) -> Wrench<T> {
        outer
    }
}

/// What has no law.
macro_rules! lawless {
    ($($Element:ty),*) => {$(
        impl<T: Scalar> Takes<Spatial<T>, Strain<T>> for $Element {
            #[inline(always)]
            fn take(&self, _: &mut Strain<T>, (): (), _: Of<'_, Spatial<T>, Strain<T>, Self>) {}
        }
    )*};
}
lawless!(Rod<T>, RigidBody<T>, PointMass<T>, Ball, Floating<T>, Weld<T>);
