//! The costate sweep in the plane: struts.

use super::loads::{BODY, Felt};
use crate::adjoint::by_strut::ByStrut;
use crate::adjoint::laws::ReversibleLaw;
use crate::adjoint::struts::{EndsStirred, OfStruts, ReversiblePoints, felt, stir, struts};
use crate::adjoint::{ActsOnBodies, BodyLaw, OfLaw, ReversibleLoads, felt_beside};
use crate::error::Fault;
use crate::lift::Lift;
use crate::loading::{Load, LoadLaw, Loading, Loads};
use crate::mechanics::planar::{BodyMotion, Frame, JointMotion, Planar};
use crate::relation::Additive;
use crate::relation::planar::algebra::{add_scaled, dot, normal};
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use crate::struts::Struts;
use crate::walks::pull_loads::PullLoads;
use nalgebra::{SVector, Vector2};

type Vector<T> = Vector2<T>;
type Angular<T> = T;

struts!(Planar, 2);

impl<T: Scalar> ReversiblePoints<2> for Planar<T> {
    fn stirred_at(frame: &Frame<T>, at: [T; 2], (velocity, stirring): (Vector2<T>, T)) -> Vector2<T> {
        add_scaled(velocity, stirring, normal(turned(&axis(frame), at)))
    }
    fn felt_at(
        frame: &Frame<T>,
        at: [T; 2],
        w: T,
        [place, velocity, stirring]: [Vector2<T>; 3],
    ) -> (Felt<T>, Vector2<T>) {
        let direction = axis(frame);
        let across = normal(turned(&direction, at));
        // What the arm to the point is weighed by.
        let lever = add_scaled(add_scaled(place, -frame.turn.rate, normal(velocity)), -w, normal(stirring));
        let turn = [dot(across, lever), dot(across, velocity)];
        let of_point = Vector2::new(dot(direction, lever), dot(normal(direction), lever));
        (Felt { place, velocity, stirring, turn }, of_point)
    }
}

/// The first axis of a body.
fn axis<T: Scalar>(frame: &Frame<T>) -> Vector2<T> {
    let (sine, cosine) = frame.turn.angle.sin_cos();
    Vector2::new(cosine, sine)
}

/// A vector of a body with such an axis.
fn turned<T: Scalar>(direction: &Vector2<T>, [x, y]: [T; 2]) -> Vector2<T> {
    add_scaled(*direction * x, y, normal(*direction))
}
