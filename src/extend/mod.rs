//! The builder's door: joints, bodies, laws and ends of crates that use this one.
//!
//! What is particular of an element is said once, in some ten to forty lines; everything else follows from it: sweeps of all rules,
//! forces, energy, modes, equilibria, transfer matrices, derivatives by jets and dual numbers. Gradients backward and Taylor series go through
//! what is made by [`compound!`](crate::compound) of elements that they know, and through laws of one's own that are lifted.
//!
//! | of one's own | how | example |
//! |---|---|---|
//! | a law along a coordinate | [`SpringLaw`](crate::planar::SpringLaw), and [`spatial::RotaryLaw`](crate::spatial::RotaryLaw), in a joint of this crate, or read by [`Resistance::of`] | a stop, a stiffening spring: there |
//! | a joint | [`JointModel`]: [`Kinematics`] and what acts along their coordinate; [`joint!`](crate::joint) | `examples/own_joint.rs`: a geared motor, 37 lines |
//! | a joint of several coordinates | joints of one in a row; [`compound!`](crate::compound), [the guide](crate::guide::own_elements#joints-of-several-coordinates) | `examples/own_gimbal.rs`: a universal joint of two motors, 25 lines |
//! | a joint that moves in a way of its own | [`Kinematics`]: its motion, and the elimination of its coordinate, free and driven, by relations that stand in the hidden module `internals`, of which no promise is made | |
//! | a body | a struct of bodies, joints and arms; [`compound!`](crate::compound) | `examples/own_body.rs`: a tank in which liquid sloshes, 36 lines |
//! | an end | [`Ground`](crate::planar::Ground): how its ground moves | below |
//! | a walk | [`walks`]: what is done at a body and at a joint | there |
//! | a load | [`LoadLaw`](crate::loading::LoadLaw) | there |
//!
//! [`lift!`](crate::lift!) makes a struct one over dual numbers, jets and lanes as well. [`check_element`] is a test for all of them: it
//! compares what an element says in one way with what it says in another, and names what does not match.
//!
//! # A joint
//!
//! How a joint moves is said apart from what resists it. The kinematics are joints of this crate without springs,
//! `planar::Revolute::smooth()`, `planar::Slider::along(..)`, `spatial::Revolute::about(..)`, `spatial::Prismatic::along(..)`, and a model
//! does not ask which:
//!
//! ```
//! use catena::system::Space;
//! use catena::{Elementary, Scalar};
//! use catena::extend::{JointModel, Kinematics, Resistance, check_element};
//!
//! /// A magnet that holds a coordinate near zero.
//! #[derive(Clone, Copy, Debug)]
//! struct Detent<T, K> {
//!     kinematics: K,
//!     /// Largest torque (N·m) and where it is (rad).
//!     torque: T,
//!     reach: T,
//! }
//! catena::joint!([T: Scalar, K: Copy + core::fmt::Debug + 'static] Detent<T, K>);
//! catena::lift!(Detent<T, K> { kinematics, torque, reach });
//!
//! impl<S: Space, K: Kinematics<S>> JointModel<S> for Detent<S::Scalar, K> {
//!     type Kinematics = K;
//!     fn kinematics(&self) -> &K {
//!         &self.kinematics
//!     }
//!     fn kinematics_mut(&mut self) -> &mut K {
//!         &mut self.kinematics
//!     }
//!     fn resistance(&self, position: S::Scalar, _: S::Scalar) -> Resistance<S::Scalar> {
//!         // −2 τ x / (1 + x²), x = φ / φ₀
//!         let x = position / self.reach;
//!         let (one, square) = (S::Scalar::literal(1.0), x * x);
//!         let (twice, below) = (self.torque + self.torque, one + square);
//!         let slope = twice * (one - square) / (below * below * self.reach);
//!         Resistance { force: -(twice * x / below), stiffness: slope, damping: one - one }
//!     }
//!     fn energy(&self, position: S::Scalar) -> S::Scalar {
//!         let x = position / self.reach;
//!         self.torque * self.reach * (S::Scalar::literal(1.0) + x * x).ln()
//!     }
//! }
//!
//! use catena::planar::*;
//! let rod = Rod::uniform(0.5_f64, 1.0);
//! let detent = Detent { kinematics: Revolute::smooth(), torque: 2.0, reach: 0.3 };
//! let scene = System::new(Pinned::origin(), (rod, detent, rod, Pin, rod), Free)?.with_gravity(9.81);
//! assert_eq!(check_element(&scene, 5), Ok(()));
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! A model may have *reflected inertia*: that of a rotor that turns n times as fast as the joint, I = n² J, with the kinetic energy
//! ½ I q̇². It is what moves with the coordinate alone. What the rotor adds to the body on which it sits belongs to that body; the
//! gyroscopic coupling n J ω q̇ of that body's own rotation, small by 1/n, is left out, as is usual; it is none on the ground, and of
//! pairs of rotors that turn against each other.
//!
//! # An end
//!
//! ```
//! use catena::planar::*;
//!
//! /// A table that shakes along x.
//! struct Shaker {
//!     amplitude: f64,
//!     frequency: f64,
//! }
//!
//! impl Ground<f64, GroundMotion<f64>> for Shaker {
//!     fn at(&self, time: f64) -> GroundMotion<f64> {
//!         let (s, c) = (self.frequency * time).sin_cos();
//!         let [a, w] = [self.amplitude, self.frequency];
//!         GroundMotion { place: [a * s, 0.0], velocity: [a * w * c, 0.0], acceleration: [-a * w * w * s, 0.0] }
//!     }
//! }
//!
//! let table = Shaker { amplitude: 0.02, frequency: 20.0 };
//! let scene = System::new(Pinned::on(table), (Rod::uniform(0.5, 1.0), Pin, Rod::uniform(0.5, 1.0)), Free)?;
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! A root that holds in another way implements [`Root`](crate::system::Root): a joint, and a ground. A tip
//! ([`Tip`](crate::system::Tip)) has the relation of one of this crate, `<Pinned<[f64; 2]> as Tip<_>>::Relation`.

#[cfg(feature = "std")]
mod check;
mod compound;
mod leaf;
pub mod walks;

#[cfg(feature = "std")]
pub use check::{Disagreement, Doubt, check_element};

/// What [`joint!`](crate::joint) calls.
pub mod model {
    pub use crate::ends::{Held, Loose};
    pub use crate::kinematics::{check, condense, motion, recover, release};
    pub use crate::lift::Lift;
    #[doc(inline)]
    pub use crate::{compound, joint, lift};
}
pub use crate::kinematics::{Acting, Driving, JointModel, Kinematics, Outboard, Resistance};
pub use crate::relation::Geometry;
pub use crate::release::{Freedom, Release, Way};
pub use crate::sweep::{Implicit, Springs};
#[doc(hidden)]
pub use typenum::{U0 as None, U1 as One};
