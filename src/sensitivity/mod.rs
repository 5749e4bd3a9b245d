//! Derivatives of a run for a few operations a body and derivative: through gains that a sweep keeps.
//!
//! A scene over [`Jet`](crate::scalar::Jet)s is differentiated under any rule. Under one that goes [`through_gains`](Rule::through_gains) the same
//! derivatives cost a fraction, because only values are eliminated: `src/sensitive.rs` says how.
//!
//! ```
//! use catena::planar::*;
//! use catena::scalar::{Jet, Scalar};
//!
//! // Seeds 0 and 1: the length of both rods (m), gravity (m/s²).
//! type Number = Jet<f64, 2>;
//! let rod = Rod::uniform(Number::seed(1.0, 0), Number::of(1.0));
//! let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(Number::seed(9.81, 1));
//! let start = pendulum.at_rest(&[Number::of(-1.0), Number::of(-0.5)])?;
//! let run = pendulum.simulate(start, Rk4::step(1e-3).through_gains(), 1.0, |_| ())?;
//! let tip = pendulum.stations(&run.motion, &Unloaded)?.tip().frame.place;
//! println!("tip at x = {} m, which moves by {} m for each metre of length", tip.x.re, tip.x.eps[0]);
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! # What going through gains saves
//!
//! In the plane, instructions of a step of RK4 with derivatives are 2.4 to 5 times fewer than over `num-dual`'s numbers for chains of
//! twenty, and for all initial values 1.6 to 2.9 times fewer than over jets by the rule itself; more columns at a time
//! are better than several runs. For few derivatives of short chains, and in space for fewer than about ten, jets by the rule itself cost
//! as little or less. BENCHMARKS.md has the figures.
//!
//! # What goes through gains
//!
//! Tuples, arrays and vectors of elements, and branches, with a free tip; in the plane all bodies, `Pin`, `Weld`, `Slider` and `ElasticHinge` with a
//! rotary spring; in space all bodies, `Ball`, `Weld`, `Revolute`, `Universal` and `Prismatic`, with springs; roots of these, and in space
//! `Free`; of [`robot`](crate::robot) hinges, slides and links on bases of all kinds. Loads may depend on
//! seeds and on the motion, and couple joints. Explicit rules, with error control (of the values) and dense output.
//!
//! # Backward
//!
//! One number, the cost, by all that a run depends on, lengths, masses, gravity, initial values, torques of every step, is cheaper backward:
//! [`System::backward`](crate::system::System::backward) and [`Backward`], some 2.8 plain runs in the plane and three to four in space, by
//! implicit rules more, however many derivatives there are.
//!
//! Second derivatives need nothing else: [`Backward`] of a scene over `Jet<f64, 1>`, with the parts `eps` of its numbers, start and torques
//! those of a direction, gives the gradient in the parts `re` and the product of the Hessian with the direction in the parts `eps`, for three
//! to four gradients.
//!
//! # Either way
//!
//! [`differentiable!`](crate::differentiable!) makes a function of numbers of a run: [gradient](Differentiable::gradient),
//! [Jacobian](Differentiable::jacobian), [products with the Hessian](Differentiable::hessian_times), the linearisation of a step. It goes forward
//! or backward, whichever costs less for so many numbers, and says which. It allocates (feature `alloc`).
//!
//! # Shocks and friction
//!
//! Where joints strike [hard stops](crate::planar::HardStops), stick and slip ([`Coulomb`](crate::planar::Coulomb)), modes change at times that hang
//! on what is differentiated. Runs over jets and dual numbers take that into account: their derivatives are those of the motion, shocks
//! included. They go by the rule itself; backward goes a [`course`](Backward::course).
//!
//! # What does not go through gains
//!
//! What a rule [`through_gains`](Rule::through_gains) does not know is an error of the compiler: held tips and loops (which go
//! [backward](Backward)), `Cylindrical` joints, linear springs of hinges, springs of balls, `Flange`, driven joints, and
//! implicit rules. Such scenes are differentiated by the rule itself.
//!
//! ```compile_fail,E0277
//! use catena::planar::*;
//! use catena::scalar::Jet;
//! let rod = Rod::uniform(1.0, 1.0);
//! // Its tip is held.
//! let system = System::new(Pinned::origin(), (rod, Pin, rod), Pinned::at(1.0, 0.0))?.lift(Jet::<f64, 4>::of);
//! let start = system.at_rest(&[Jet::of(1.0), Jet::of(-1.0)])?;
//! let run = system.simulate(start, Rk4::step(1e-3).through_gains(), 1.0, |_| ())?;
//! # Ok::<(), catena::Error>(())
//! ```

mod along;
mod along_in_space;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
mod along_past;
mod along_robots;
mod backward;
mod couplings;
mod force_elements;
mod forward;
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub(crate) mod front;
mod gradient;
mod lifted;
mod stepper;
mod struts;

pub use crate::adjoint::by_strut::ByStrut;
pub use backward::{Backward, Checkpoints, Tape};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use backward::{Course, PastGradient};
pub use forward::{SensitiveWorkspace, Sensitivity};
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub use front::{Derivatives, Differentiable, Plan, Seeded, Way};
pub use gradient::{Costate, Gradient};
pub use stepper::SensitiveStepper;

use crate::time::{Explicit, Rule};

/// An explicit method whose derivatives go through kept gains.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ThroughGains<M>(pub M);

impl<M: Explicit, R> Rule<M, R> {
    /// This rule for a scene over [`Jet`](crate::scalar::Jet)s: the derivatives of this very rule through kept gains, exact but for
    /// rounding.
    pub fn through_gains(self) -> Rule<ThroughGains<M>, R> {
        Rule { method: ThroughGains(self.method), control: self.control }
    }
}
