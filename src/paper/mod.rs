//! The formulation of 2005, equation by equation.

mod body;
mod collocation;
mod expansion;
mod hinge;
#[cfg(feature = "alloc")]
mod joints;
#[cfg(feature = "alloc")]
mod link;
mod multistep;
mod newmark;
#[cfg(feature = "alloc")]
mod parts;
mod pin;
#[cfg(feature = "alloc")]
mod product;
#[cfg(feature = "alloc")]
mod riccati;
mod rule;
#[cfg(feature = "alloc")]
mod scene;
#[cfg(feature = "alloc")]
mod scheme;

pub use crate::time::GeneralizedAlpha;
pub use body::{External, Known, Rigid, lumped_mass, rigid_body};
pub use collocation::{Midpoint, Wilson};
pub use expansion::{At, Expansion};
pub use hinge::{Linear, Rotary, linear_hinge, rotary_hinge};
#[cfg(feature = "alloc")]
pub use joints::{JointRun, JointScheme};
pub use multistep::{Earlier, Multistep};
pub use newmark::{Newmark, hht_alpha};
pub use pin::{is_percussive, smooth_pin};
pub use rule::{Coordinate, Linearization, Rule};
#[cfg(feature = "alloc")]
pub use scene::{Item, Scene, Spring};
#[cfg(feature = "alloc")]
pub use scheme::{Run, Scheme, Solver};
