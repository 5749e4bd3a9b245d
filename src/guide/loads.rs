//! Loads by example: friction, a motor, wind, a stop, contact with the ground.
//!
//! A load is a function of time and of the motion of a body or joint. In a joint it gives a torque on the outboard body (N·m; a force, N, where
//! the joint slides), on a body a force at a point (inertial axes) and a torque.
//!
//! ```
//! use catena::Scalar;
//! use catena::planar::*;
//! let rod = Rod::uniform(1.0, 1.0); // (m), (kg)
//! let arm = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
//! let (shoulder, elbow) = (0, 1); // numbers of joints
//!
//! let loads = Loads::none()
//!     .in_joints(|time: f64, joint, motion: &JointMotion<f64>| {
//!         // Dry friction, a sign without a jump, which rules like, and viscous friction.
//!         let friction = -0.2 * (50.0 * motion.rate()).tanh() - 0.05 * motion.rate();
//!         match joint {
//!             _ if joint == shoulder => friction + 2.0 * (3.0 * time).sin(), // a motor (N·m)
//!             _ if joint == elbow => {
//!                 // A stop at an elbow of 2 rad: a spring that acts beyond it.
//!                 let beyond = (motion.angle().abs() - 2.0).max(0.0);
//!                 friction - 500.0 * beyond * motion.angle().signum()
//!             }
//!             _ => friction,
//!         }
//!     })
//!     .on_bodies(|_, _, motion: &BodyMotion<f64>| {
//!         let end = motion.point([1.0, 0.0]); // the rod's end: place (m), velocity (m/s)
//!         // Wind along x, and a ground 1.8 m below that pushes back and damps.
//!         let wind = 0.1 * (4.0 - end.velocity.x);
//!         let depth = (-1.8 - end.place.y).max(0.0);
//!         let ground = (1e4 * depth - 20.0 * end.velocity.y * f64::from(depth > 0.0)).max(0.0);
//!         motion.force_at([1.0, 0.0], [wind, ground])
//!     });
//! let start = arm.at_rest(&[-0.3, -0.2])?;
//! let run = arm.simulation(Dop853::tolerance(1e-6)).loads(&loads).run(start, 1.0, |_| ())?;
//! assert!(run.steps < 2000);
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! | wanted | take |
//! |---|---|
//! | torques that are known numbers, as from a controller | `Loads::none().torques([..])`: one for each joint, no walk |
//! | a spring or damper in a joint | `ElasticHinge`, `Slider::with`: implicit rules know its stiffness, loads they do not |
//! | dry friction and stops in a joint, known to implicit rules | [`DryFriction`](crate::planar::DryFriction), [`Stops`](crate::planar::Stops): laws for `ElasticHinge::with`, several as a tuple |
//! | dry friction that sticks, and breaks away, at instants that a run finds | [`Coulomb`](crate::planar::Coulomb) around a joint |
//! | hard stops that a joint strikes, bounces off and rests against | [`HardStops`](crate::planar::HardStops) around a joint |
//! | both | [`BoundedCoulomb`](crate::planar::BoundedCoulomb): `Coulomb::new(joint, ..).between(..)` |
//! | a crank that turns as it is told, whatever it takes | [`Driven`](crate::planar::Driven) around a joint |
//! | a joint that follows another one: gears, belts, grippers | [`Couplings`](crate::planar::Couplings) |
//! | what a geared motor can give of a torque asked for | [`Motor`](crate::planar::Motor) |
//! | forces on bodies that are known numbers | `Loads::none().wrenches([..])`: one for each body |
//! | a law on bodies that [`Taylor`](crate::planar::Taylor) knows | [`Loads::on_bodies_over_time`](crate::planar::Loads::on_bodies_over_time) |
//! | feet on the ground, in space | [`Contacts`](crate::spatial::Contacts) |
//! | a law of one's own in a joint, known to implicit rules | [`SpringLaw`](crate::planar::SpringLaw) |
//! | a spring between two points of bodies | [`Strut`](crate::planar::Strut) |
//! | a law of length and rate of one's own between them: an absorber, a muscle of one excitation | [`Strut::with_law`](crate::planar::Strut::with_law) |
//! | a load that hangs on the motions of several bodies: gas by the angle of a crank, a muscle along points that is excited over time | [`ForceElement`](crate::planar::ForceElement) |
//! | a rope that hangs slack, a buffer | [`Strut::pulling`](crate::planar::Strut::pulling), [`pushing`](crate::planar::Strut::pushing) |
//! | such struts, so stiff that steps are longer than its vibration | [`Struts::stiff`](crate::planar::Struts::stiff), by implicit rules |
//! | limits, thresholds, buffers: loads with a kink, by rules that keep their order | [`kinks`](crate::simulate::Simulation::kinks) of a run |
//! | the instant of touching | an [event](crate::simulate::Simulation::event), then a new start |
//!
//! A function that gives loads names what they are made of: `impl Loading<Planar<f64>, OnBody = Wrench<f64>, InJoint = Absent>` for a load on bodies alone,
//! `OnBody = Absent, InJoint = f64` for one in joints.
//!
//! Contact by a spring is stiff: explicit rules shorten their steps while it lasts. What is proportional to a sign jumps, and error control
//! then hunts for the jump: smooth it, as above, or give it a joint with modes.
//!
//! # Currents, pressures, integrals
//!
//! What obeys an equation of first order beside the mechanics is a rate of a slider of its own, on an arm that leads nowhere, and a
//! [`ForceElement`](crate::planar::ForceElement) couples it: every rule steps it to its own order, and derivatives, lanes and saved runs know it. A motor of
//! inductance L and resistance R, L i′ = u − R i − k ω with the torque k i on its rotor:
//!
//! ```
//! use catena::planar::*;
//! let (inductance, resistance, k, voltage) = (4e-3, 1.2, 0.35, 6.0); // (H), (Ω), (V·s), (V)
//! // Its charge slides; its "mass" is the inductance, and what rubs is the resistance, which implicit rules know there.
//! let winding = (Slider::along(0.0).with(Spring::damping(resistance)), RigidBody::new(inductance, 1.0, [0.0; 2], [0.0; 2]));
//! let rotor = RigidBody::new(1.0, 0.015, [0.0; 2], [0.0; 2]);
//! let motor = System::new(Clamped::origin(), (Branch(winding), Revolute::smooth(), rotor), Free)?;
//! let law = ForceElement::between([0, 1], move |_: f64, [winding, rotor]: &[BodyMotion<f64>; 2]| {
//!     let (current, speed) = (winding.inboard.velocity.x, rotor.rate());
//!     let voltages = Wrench { force: [voltage - k * speed, 0.0].into(), torque: 0.0 };
//!     [voltages, Wrench::torque(k * current)]
//! });
//! let run = motor.simulation(Dop853::tolerance(1e-9)).loads(&law).run(motor.motion(), 4.0, |_| ())?;
//! let [current, speed] = [run.motion.rates()[0], run.motion.rates()[1]];
//! assert!(current.abs() < 1e-6 && (speed - voltage / k).abs() < 1e-6); // it idles
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! So energies count ½ L i²; of an integral or a filter with a "mass" of 1, and of pressures, they count what is none. Implicit rules read what a force
//! element does where the sweep before has led: where that couples what is stiffly damped (an inductance of 1e-6 H in steps of 1 ms) `Sdirk4` falls
//! to order 2 and `GeneralizedAlpha` to order 1.
