//! Steps in real time: a controller's cycle, with friction, stops and contacts.
//!
//! Time goes by steps of one size, each within a bound, whatever the scene meets. What a scene has decides what is needed:
//!
//! | the scene has | take |
//! |---|---|
//! | nothing stiff, nothing that strikes | `Rk4`: order four, four sweeps a step |
//! | friction, stops or contacts | [`MoreauJean`](crate::time::MoreauJean): order one, a sweep a step, and few more where joints stick or strike |
//! | stiff springs, and digits are wanted | [`Sdirk4`](crate::time::Sdirk4): order four, sixteen sweeps a step |
//!
//! | in a joint or on a body | as it is, for `MoreauJean` and for runs with events | smooth, for any rule of small steps or an implicit one |
//! |---|---|---|
//! | dry friction | [`Coulomb`](crate::planar::Coulomb) around the joint | [`DryFriction`](crate::planar::DryFriction), a law |
//! | ends of a range | [`HardStops`](crate::planar::HardStops) around the joint | [`Stops`](crate::planar::Stops), a law |
//! | both in one joint | [`BoundedCoulomb`](crate::planar::BoundedCoulomb): `Coulomb::new(..).between(..)` | a tuple of both laws |
//! | points that touch a surface | | [`Contacts`](crate::spatial::Contacts), linearly implicit |
//! | torques of a controller | [`Loads::efforts`](crate::loading::Loads::efforts), values that hold for the step | |
//!
//! Contacts are for links of a [`robot`](crate::robot). A robot from its description (URDF) comes with its friction and limits as they are by
//! `catena_urdf::Laws::none().sticking().hard_stops(0.2)`.
//!
//! A leg of two links under a trunk that slides along the vertical, dropped by 0.13 m, its knee held by a motor, its hip by friction, at a kilohertz:
//!
//! ```
//! use catena::robot::*;
//! let inertia = [[0.02, 0.0, 0.0], [0.0, 0.001, 0.0], [0.0, 0.0, 0.02]];
//! let trunk = Link::general(5.0, [0.0; 3], inertia); // slides along the vertical
//! let bone = Link::general(1.0, [0.0, 0.15, 0.0], inertia); // hangs along its y axis
//! let hip = Coulomb::new(Hinge::level().turned(Quarter::<30>), 3.0); // about the horizontal, rubbing by 3 N·m
//! let knee = Hinge::at::<0b010>([0.0, 0.3, 0.0]);
//! let leg = System::new(Base::origin(), (Slide::level(), trunk, hip, bone, knee, bone), Free)?;
//! let leg = leg.with_gravity([0.0, 0.0, -9.81]);
//!
//! let law = Contact::new(5e4, 5e-4).damped(1.0).rubbing(0.8, 1e-3); // (N/m), (m), (s/m), (m/s)
//! let ground = Contacts::of([(2, [0.0, 0.3, 0.0])], Plane::level(0.0), law); // the end of the shank
//! let mut now = leg.motion();
//! now.set_coordinates(&[0.7, 0.3, -0.6])?; // (m), (rad)
//! let (mut next, mut stepper) = (now, leg.stepper(MoreauJean));
//! let (mut q, mut v) = ([0.0_f64; 3], [0.0_f64; 3]);
//! for _ in 0..2000 {
//!     now.coordinates_into(&mut q)?;
//!     now.rates_into(&mut v)?;
//!     let torque = -200.0 * (q[2] + 0.6) - 5.0 * v[2]; // a motor makes a spring and a damper; joint 0 is the root
//!     let efforts = [0.0, 0.0, 0.0, torque].map(|x| Effort([x, 0.0, 0.0]));
//!     let loads = Loads::none().on_bodies_by(ground).efforts(efforts);
//!     stepper.step(&now, &loads, 1e-3, &mut next)?;
//!     core::mem::swap(&mut now, &mut next);
//! }
//! now.rates_into(&mut v)?;
//! println!("at {q:?}, {v:?}");
//! let bodies = leg.body_motions(&now)?;
//! let shank = bodies.get(2).ok_or("no shank")?;
//! assert!((ground.force(0, shank)[2] - 7.0 * 9.81).abs() < 0.1); // it stands
//! assert!(v.iter().all(|rate| rate.abs() < 1e-2));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Controllers that sample, partners in other programs
//!
//! | wanted | take |
//! |---|---|
//! | a step of one size each cycle | `stepper.step(..)`, as above: loads are given to each |
//! | cycles of several steps, by any rule, to a tolerance | [`begin`](crate::simulate::Simulation::begin) a run whose loads read a `Cell` (an atomic, between threads), and [`up_to`](crate::simulate::Running::up_to) the next sample |
//! | loads that jump at known times, as of pulses | the same, up to each edge: error control would hunt for it |
//! | progress, an end before the end | [`step`](crate::simulate::Running::step) by step, and leave the loop |
//! | a process that goes on tomorrow | [`save`](crate::simulate::Running::save), [`resume`](crate::simulate::Simulation::resume) |
//!
//! `step` and a `run` begin each step with what the one before has ended with: what loads are told in between they see a stage late.
//!
//! Neither a step nor a function of lists allocates, and none takes longer than its passes: of a quadruped that stands a step takes 2 µs, of a
//! humanoid that falls 12 µs. For firmware see [`no_std`](super::no_std).
