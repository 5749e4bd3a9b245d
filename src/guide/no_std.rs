//! Without an operating system, and on time.
//!
//! `default-features = false, features = ["libm"]`: no `std`, no allocator, 12 kB of machine code for a
//! double pendulum. What needs an allocator is behind `alloc` (vectors as chains, statics), modes behind `std`.
//!
//! A controller steps by hand: a step reads one motion and writes another, allocates nothing, and costs the same every time.
//!
//! ```
//! use catena::Error;
//! use catena::planar::*;
//! use catena::simulate::Stepper;
//!
//! fn control() -> Result<f64, Error> {
//!     let rod = Rod::uniform(1.0, 1.0);
//!     let plant = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
//!     let mut stepper = plant.stepper(Rk4);
//!     let mut now = plant.at_rest(&[-1.5, -1.5])?;
//!     let mut next = now.clone();
//!     for _ in 0..1000 {
//!         let [shoulder, elbow] = [now.rate().0, now.rate().1.1];
//!         let torques = [-0.5 * shoulder, -0.5 * (elbow - shoulder)]; // (N·m)
//!         // A step that fails leaves `now` as it was.
//!         stepper.step(&now, &Loads::none().torques(torques), 1e-3, &mut next)?;
//!         core::mem::swap(&mut now, &mut next);
//!     }
//!     Ok(now.rate().0)
//! }
//! assert!(control()?.is_finite());
//! # Ok::<(), Error>(())
//! ```
//!
//! Scenes are types, so a struct that keeps one names it, or is generic over it: [`StepperOf`](crate::simulate::StepperOf) names the stepper
//! of a scene, [`into_stepper`](crate::system::System::into_stepper) puts the scene inside. A closure in a scene has no name; a law or load as
//! a struct has.
//!
//! Only explicit rules with fixed steps take the same time always. Angles beyond 4e5 rad are refused: wrap them now and then.
