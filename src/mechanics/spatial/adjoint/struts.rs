//! The costate sweep in space: struts.

use super::Turning;
use super::felt::Felt;
use super::read::BODY;
use crate::adjoint::by_strut::ByStrut;
use crate::adjoint::laws::ReversibleLaw;
use crate::adjoint::struts::{EndsStirred, OfStruts, ReversiblePoints, felt, stir, struts};
use crate::adjoint::{ActsOnBodies, BodyLaw, OfLaw, ReversibleLoads, felt_beside};
use crate::error::Fault;
use crate::lift::Lift;
use crate::loading::{Load, LoadLaw, Loading, Loads};
use crate::mechanics::spatial::{BodyMotion, Frame, JointMotion, Spatial, Turn};
use crate::relation::Additive;
use crate::relation::spatial::algebra::{cross_onto, zero};
use crate::scalar::Scalar;
use crate::spring::SpringLaw;
use crate::struts::Struts;
use crate::walks::pull_loads::PullLoads;
use nalgebra::{SVector, Vector3};

type Vector<T> = Vector3<T>;
type Angular<T> = Vector3<T>;

struts!(Spatial, 3);

impl<T: Scalar> ReversiblePoints<3> for Spatial<T> {
    fn stirred_at(frame: &Frame<T>, at: [T; 3], (velocity, stirring): (Vector3<T>, Vector3<T>)) -> Vector3<T> {
        cross_onto(stirring, frame.turn.attitude.apply(Vector3::from(at)), velocity)
    }
    fn felt_at(
        frame: &Frame<T>,
        at: [T; 3],
        stirring: Vector3<T>,
        [place, velocity, force]: [Vector3<T>; 3],
    ) -> (Felt<T>, Vector3<T>) {
        let Turn { attitude, spin } = &frame.turn;
        let turning = Turning { spin: *spin, acceleration: zero(), stirring };
        let (arm, mut of_arm) = (attitude.apply(Vector3::from(at)), zero());
        let at_point = Felt { place, velocity, stirring: force, ..Felt::null() };
        let felt = at_point.over(arm, &turning, &mut of_arm);
        (felt, attitude.transposed(of_arm))
    }
}
