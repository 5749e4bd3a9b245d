//! The costate sweep in the plane: force elements.

use super::loads::{BODY, Felt, READ, Read, add_numbers, felt_by, read, slope, still, value};
use crate::adjoint::forces::{FORCE, OfForce, force_elements, seeded_from};
use crate::adjoint::laws::count;
use crate::adjoint::{ActsOnBodies, BodyLaw, OfLaw, ReversibleLoads};
use crate::error::Fault;
use crate::lift::Lift;
use crate::loading::{ForceElement, ForceLaw, Load, LoadLaw, Loading, Loads};
use crate::mechanics::planar::{BodyMotion, Frame, JointMotion, Planar, Wrench};
use crate::relation::{Absent, Additive};
use crate::scalar::{Jet, Scalar};
use crate::walks::pull_loads::PullLoads;
use nalgebra::Vector2;

type Vector<T> = Vector2<T>;
type Angular<T> = T;

force_elements!(Planar);
