//! Why a step failed: a load that is not finite makes all that follows from it look broken.

use super::Run;
use crate::error::{Error, Fault, Place};
use crate::paper::orient::{Bodies, Joints};
use crate::paper::parts::Part;
use crate::paper::rule::{Coordinate, Rule};
use crate::paper::scene::Scene;
use crate::scalar::Scalar;

impl<T, S, L, D, const N: usize, const H: usize, const P: usize, const A: usize> Run<'_, T, S, L, D, N, H, P, A>
where
    T: Scalar,
    S: Scene<T, L, N, H, P, A>,
    D: Rule<T>,
{
    /// The outermost load that is not finite; where there is none, the error as it was.
    #[cold]
    #[inline(never)]
    pub(super) fn failed(
        &self,
        error: Error,
        span: T::Real,
        time: T::Real,
        ground: &<S::Orient as Joints<T, P, A>>::Frame,
    ) -> Error {
        let known =
            |c: &Coordinate<T, D::Memory>| c.value.is_finite() && c.rate.is_finite() && c.acceleration.is_finite();
        let finite = self.parts.bodies.iter().all(|body| {
            body.points[0].iter().chain(&body.angles).all(known) && body.found.iter().all(|x| x.is_finite())
        });
        if !finite {
            return error; // such a motion breaks loads that are sound
        }
        let broken = |part: &Part| match *part {
            Part::Body(number) => self.body(Some(number)).is_some_and(|body| {
                let external = self.scene.external(self.loads, time, number, &body.guessed(span));
                !S::Orient::is_finite(&external)
            }),
            Part::Joint(number) => self.parts.joints.get(number).is_some_and(|joint| {
                let effort = self.effort(number, joint, span, time, ground);
                !effort.iter().all(|x| x.is_finite())
            }),
        };
        non_finite_load(&self.parts.order, broken).unwrap_or(error)
    }
}

/// The outermost part whose load is not finite, as an error.
pub fn non_finite_load(order: &[Part], broken: impl Fn(&Part) -> bool) -> Option<Error> {
    let k = order.iter().rposition(broken)?;
    // Parts are counted from the root's joint, stations from the first element outboard of it.
    Some(Error::new(Fault::NonFiniteLoad).at(k.checked_sub(1).map_or(Place::Root, Place::Station)))
}
