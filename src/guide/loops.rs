//! Loops: arms that meet again, tips that the ground holds, and what to do if they do not close.
//!
//! | the mechanism | how it is written |
//! |---|---|
//! | its last body is held by the ground | the tip: `Pinned::at(0.8, 0.0)` instead of `Free` |
//! | two arms meet in a joint | `Network::new(main, side, Pin)` in the chain |
//! | an arm comes back to its own body | `ClosedLoop` |
//! | loops in a row | networks within side arms of networks |
//! | robots in axes of their bodies | arms that begin with `BodyAxes` and end with a [`Flange`](crate::robot::Flange) |
//! | the ground holds several arms | a `Clamped` root, arms that begin with `RigidBody::massless` |
//!
//! A platform on legs is best written with its pose as coordinates: a main arm of three [`Prismatic`](crate::spatial::Prismatic) with massless bodies between,
//! a [`Ball`](crate::spatial::Ball) and the platform, and the legs as side arms, each closed at its end. Then `assembled_holding` the pose is inverse kinematics.
//!
//! A guess does not have to close: `assembled` closes it by the least change of coordinates, or says by how much it cannot. Where the guess is far off,
//! what is least is not the same on all sides (by inertia near, by angles from afar), so that the start may jump where lengths or the guess change a
//! little, and with it a cost that an optimisation follows: there say which coordinates stay, by `assembled_holding`.
//!
//! ```
//! use catena::planar::*;
//! let bar = |length: f64| Rod::uniform(length, length);
//! let chain = (bar(0.3), Pin, bar(0.9), Pin, bar(0.6));
//! let four_bar = System::new(Pinned::origin(), chain, Pinned::at(0.8, 0.0))?;
//! let four_bar = four_bar.with_gravity(9.81);
//! let guess = four_bar.at_rest(&[1.0, 0.2, -1.5])?; // (rad)
//! let start = four_bar.assembled(guess, &Unloaded)?;
//! let run = four_bar.simulate(start, Dop853::tolerance(1e-9), 1.0, |_| ())?;
//! let tip = four_bar.stations(&run.motion, &Unloaded)?.tip().frame.place;
//! assert!((tip.x - 0.8).abs() < 1e-12 && tip.y.abs() < 1e-12); // closed to rounding
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! A run begins from what is nearly closed, as from angles of six digits: its first steps close it. Anything else is refused,
//! [`NotAssembled`](crate::Fault::NotAssembled), rather than drawn together as if by a blow. Rates that miss what closures allow by more than 1e-2 of the
//! largest are taken to the nearest that they allow, by the inertia of the scene, before the first step, as when links are caught and as `assembled`
//! does; others, and by steps of a [`Stepper`](crate::simulate::Stepper) of one's own all, in the first step, whose size the motion then depends on. Over jets and dual numbers assemble the start over these: of one whose numbers are closed
//! and whose derivatives are not, a first step closes the derivatives.
//!
//! [`assembled_holding`](crate::system::System::assembled_holding) keeps coordinates that are given, a crank's angle for one.
//!
//! **Redundant closures.** Loops in space often close more than they have to: a flat four-bar of revolutes holds each of three things twice.
//! That is [`RedundantClosures`](crate::Fault::RedundantClosures), with the name of one; make one of its joints a
//! [`Universal`](crate::spatial::Universal) and close it by a [`Ball`](crate::spatial::Ball), or close it by
//! [`LeastNorm`](crate::planar::LeastNorm), which shares the forces out, and refuses loops that do not close for all that
//! ([`NotClosed`](crate::Fault::NotClosed)), at the start or on the way. Some mechanisms meet places where closures become dependent
//! for an instant (dead points): steps are taken over these, by [`Taylor`](crate::planar::Taylor) as by others, for which stages of `Dop853` lead over them.
//! Where a step of a given size, or one to a tolerance of many digits, falls on such a place so that the motion is lost in rounding, the run ends in an
//! error that names the closure: `Dop853` at steps of 1 ms under error control, and `Sdirk4` below a tolerance of 1e-9, do so in a parallelogram of 1 m.
//!
//! **What it takes to move as planned.** Of a chain that is open [`stations`](crate::system::System::stations) is inverse dynamics: accelerations of one's own, forces
//! of all joints. Where something is closed or held these do not follow from accelerations alone, for drives and closures share them; what `stations` adds
//! there are the closure forces that the motion has. So let the joints that do it be [`Driven`](crate::planar::Driven) along the plan, and read their stations:
//!
//! ```
//! use catena::planar::*;
//! let bar = |length: f64| Rod::uniform(length, length);
//! let held = |angle: f64| {
//!     let crank = Driven::new(Revolute::smooth(), move |_: f64| [angle, 0.0, 0.0]); // (rad), (rad/s), (rad/s²)
//!     let chain = (crank, bar(0.3), Pin, bar(0.9), Pin, bar(0.6));
//!     let scene = System::new(Clamped::origin(), chain, Pinned::at(0.8, 0.0))?.with_gravity(9.81);
//!     let motion = scene.assembled(scene.at_rest(&[0.2, -1.5])?, &Unloaded)?;
//!     let torque = scene.stations(&motion, &Unloaded)?.root().torque_outboard(); // all of it is the drive's
//!     Ok::<_, catena::Error>((torque, scene.budget(&motion)?.potential))
//! };
//! let (torque, _) = held(1.0)?;
//! let (ahead, behind) = (held(1.0 + 1e-5)?.1, held(1.0 - 1e-5)?.1);
//! assert!((torque - (ahead - behind) / 2e-5).abs() < 1e-8); // the slope of the potential (N·m)
//! # Ok::<(), catena::Error>(())
//! ```
