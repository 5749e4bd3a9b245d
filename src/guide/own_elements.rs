//! Elements, laws and loads of one's own.
//!
//! | wanted | take | lines |
//! |---|---|---|
//! | a law along a coordinate: a stiffening spring, a magnet | [`SpringLaw`](crate::planar::SpringLaw) in `ElasticHinge::with`, `Slider::with` | 15 |
//! | a joint: a geared motor, a magnet | [`extend::JointModel`](crate::extend::JointModel) | 40 |
//! | a joint of several coordinates: a gimbal of motors, a pin in a slot | joints of one in a row, [below](#joints-of-several-coordinates) | 25 |
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
//! # Joints of several coordinates
//!
//! A joint of several coordinates is joints of one in a row, between them bodies without mass or extent. Each may be one of your own,
//! with a force, slopes, energy and reflected inertia along its coordinate: what a joint of this crate with the same axes would do, under
//! every rule, in forces, energy, equilibria, modes and derivatives by jets. `examples/elements/gimbal.rs` is a universal joint of two
//! geared motors, in 25 lines; `compound!` makes it one element. This is a pin in a slot, with friction along the slot and about the pin:
//!
//! ```
//! use catena::extend::{JointModel, Kinematics, Resistance, check_element};
//! use catena::planar::*;
//! use catena::{Elementary, Scalar};
//! use core::fmt::Debug;
//!
//! /// Friction of c tanh(q̇ / v).
//! #[derive(Clone, Copy, Debug)]
//! struct Rubbing<T, K> {
//!     kinematics: K,
//!     /// c (N, N·m) and v (m/s, rad/s).
//!     size: T,
//!     soft: T,
//! }
//! catena::joint!([T: Scalar, K: Copy + Debug + 'static] Rubbing<T, K>);
//! catena::lift!(Rubbing<T, K> { kinematics, size, soft });
//!
//! impl<S: catena::system::Space, K: Kinematics<S>> JointModel<S> for Rubbing<S::Scalar, K> {
//!     type Kinematics = K;
//!     fn kinematics(&self) -> &K {
//!         &self.kinematics
//!     }
//!     fn kinematics_mut(&mut self) -> &mut K {
//!         &mut self.kinematics
//!     }
//!     fn resistance(&self, _: S::Scalar, rate: S::Scalar) -> Resistance<S::Scalar> {
//!         let share = (rate / self.soft).tanh();
//!         let damping = self.size * (S::Scalar::literal(1.0) - share * share) / self.soft;
//!         Resistance { force: -(self.size * share), damping, ..Resistance::none() }
//!     }
//! }
//!
//! /// The slot, along x of the inboard body, and the pin that slides in it.
//! #[derive(Clone, Copy, Debug)]
//! struct PinInSlot<T> {
//!     parts: Parts<T>,
//! }
//! type Parts<T> = (Rubbing<T, Slider<T>>, RigidBody<T>, Rubbing<T, Revolute>);
//! catena::compound!([T: Scalar] PinInSlot<T> { parts: Parts<T> });
//! catena::lift!(PinInSlot<T> { parts });
//!
//! let slot = Rubbing { kinematics: Slider::along(0.0), size: 2.0, soft: 0.5 };
//! let pin = Rubbing { kinematics: Revolute::smooth(), size: 0.1, soft: 0.5 };
//! let joint = PinInSlot { parts: (slot, RigidBody::massless([0.0; 2]), pin) };
//! let (rod, plate) = (Rod::uniform(0.7_f64, 1.0), RigidBody::new(0.9, 0.05, [0.3, 0.1], [0.7, -0.2]));
//! let scene = System::new(Pinned::origin(), (plate, joint, plate, Pin, rod), Free)?.with_gravity(9.81);
//! assert_eq!(check_element(&scene, 5), Ok(()));
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! Such an element has the numbers of its parts: two joints, one body, a coordinate each. What it does not do:
//!
//! * A force along one coordinate does not depend on the other. What couples them acts between the bodies on both sides: a
//!   [`Strut`](crate::spatial::Strut) across the joint, whose force depends on all coordinates. Statics and modes know that; implicit rules do of
//!   struts that are made [`stiff`](crate::spatial::Struts::stiff). Potential energy in a budget is without loads'.
//! * An inertia is of one coordinate, ½ I q̇². A differential, whose rotor turns by q₁ ± q₂, is not.
//! * Derivatives backward, as of all joints of your own, are not there; a shipped joint with a [`SpringLaw`](crate::planar::SpringLaw) of your
//!   own for each coordinate (`Universal::with`, `Cylindrical::with`) has them. A ball takes a [`RotaryLaw`](crate::spatial::RotaryLaw),
//!   which does depend on all three: `ElasticHinge::with`.
//!
//! [`check_element`](crate::extend::check_element) compares what an element says in one way with what it says in another: make it the
//! first test of yours.
