//! Rules that advance a motion in time: coefficients only, no mechanics.

mod adams;
mod auto;
mod control;
mod dop853;
mod dop853_table;
mod dopri5;
mod generalized_alpha;
mod moreau_jean;
mod rk4;
pub(crate) mod sdirk4;
mod tableau;
mod taylor;
pub(crate) mod vcabm;

pub use adams::Adams;
pub(crate) use adams::Weights;
pub use auto::{Auto, AutoTaylor};
pub use control::{Control, IntoRule, Rule};
pub use dop853::Dop853;
pub use dopri5::Dopri5;
pub use generalized_alpha::GeneralizedAlpha;
pub(crate) use generalized_alpha::feeding;
pub use moreau_jean::MoreauJean;
pub use rk4::Rk4;
pub use sdirk4::Sdirk4;
pub use tableau::{ErrorWeights, Explicit, Tableau};
pub use taylor::Taylor;
pub use vcabm::Vcabm;

/// So many sweeps a step or stage may take at most: more no motion asks for, and a step should end.
const MOST_SWEEPS: usize = 1000;
