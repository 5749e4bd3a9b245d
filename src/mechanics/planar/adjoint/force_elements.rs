//! The costate sweep in the plane: force elements.

use super::loads::{BODY, Felt, READ, Read, add_numbers, felt_by, read, slope, still, value};
use crate::adjoint::force_elements::{FORCE, OfForce, force_elements};
use crate::adjoint::jets::seeded;
use crate::adjoint::laws::count;
use crate::adjoint::{ActsOnBodies, BodyLaw, OfLaw, ReversibleLoads, felt_beside};
use crate::error::Fault;
use crate::lift::Lift;
use crate::loading::{ForceElement, ForceLaw, Load, LoadLaw, Loading, Loads};
use crate::mechanics::planar::{BodyMotion, Frame, JointMotion, Planar, Wrench};
use crate::relation::Additive;
use crate::scalar::{Jet, Scalar};
use crate::walks::pull_loads::PullLoads;
use nalgebra::Vector2;

type Vector<T> = Vector2<T>;
type Angular<T> = T;

force_elements!(Planar);
