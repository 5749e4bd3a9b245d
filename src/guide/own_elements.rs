//! Elements, laws and loads of one's own.
//!
//! | wanted | take | lines |
//! |---|---|---|
//! | a law along a coordinate: a stiffening spring, a magnet | [`SpringLaw`](crate::planar::SpringLaw) in `ElasticHinge::with`, `Slider::with` | 15 |
//! | a joint: a geared motor, a magnet | [`extend::JointModel`](crate::extend::JointModel) | 40 |
//! | a body with something inside | a struct of elements, [`compound!`](crate::compound) | 40 |
//! | a root that moves as a function says | [`Moving`](crate::planar::Moving) | 5 |
//! | a walk over all bodies and joints | [`extend::walks`](crate::extend::walks) | 20 |
//!
//! A law says force and, for implicit rules, slope; rules of every kind know it then, energy and modes too:
//!
//! ```
//! use catena::planar::*;
//! use catena::Fault;
//!
//! /// τ = −k φ − c φ³: a spring that stiffens.
//! #[derive(Clone, Copy, Debug)]
//! struct Stiffening(f64, f64);
//!
//! impl SpringLaw<f64> for Stiffening {
//!     fn force(&self, angle: f64, _: f64) -> f64 {
//!         -self.0 * angle - self.1 * angle * angle * angle
//!     }
//!     fn pivot(&self, angle: f64, _: f64, springs: impl Springs<f64>) -> f64 {
//!         springs.pivot(self.0 + 3.0 * self.1 * angle * angle, Absent) // slope, no damping
//!     }
//!     fn energy(&self, angle: f64) -> f64 {
//!         0.5 * self.0 * angle * angle + 0.25 * self.1 * angle.powi(4)
//!     }
//!     fn check(&self) -> Result<(), Fault> {
//!         let fault = Fault::Negative { parameter: "stiffness", value: self.0 };
//!         if self.0 >= 0.0 { Ok(()) } else { Err(fault) }
//!     }
//! }
//!
//! let rod = Rod::uniform(0.5, 1.0);
//! let hinge = ElasticHinge::with(Stiffening(10.0, 40.0));
//! let scene = System::new(Clamped::at(0.0, 0.0, 0.0), (hinge, rod), Free)?;
//! let start = scene.at_rest(&[0.4])?;
//! let energy = scene.budget(&start)?.energy();
//! let run = scene.simulate(start, Dop853::tolerance(1e-10), 1.0, |_| ())?;
//! assert!((scene.budget(&run.motion)?.energy() - energy).abs() < 1e-8);
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! [`check_element`](crate::extend::check_element) compares what an element says in one way with what it says in another: make it the
//! first test of yours.
