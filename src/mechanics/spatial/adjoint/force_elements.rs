//! The costate sweep in space: force elements.

use super::felt::Felt;
use super::read::{BODY, READ, Read, add_numbers, felt_by, read, slope, still, value};
use crate::adjoint::force_elements::{FORCE, OfForce, force_elements};
use crate::adjoint::jets::seeded;
use crate::adjoint::laws::count;
use crate::adjoint::{ActsOnBodies, BodyLaw, OfLaw, ReversibleLoads, felt_beside};
use crate::error::Fault;
use crate::lift::Lift;
use crate::loading::{ForceElement, ForceLaw, Load, LoadLaw, Loading, Loads};
use crate::mechanics::spatial::{BodyMotion, Frame, JointMotion, Spatial, Wrench};
use crate::relation::Additive;
use crate::scalar::{Jet, Scalar};
use crate::walks::pull_loads::PullLoads;
use nalgebra::Vector3;

type Vector<T> = Vector3<T>;
type Angular<T> = Vector3<T>;

force_elements!(Spatial);
