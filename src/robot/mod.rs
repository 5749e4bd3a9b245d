//! Robots: arms and legged machines of hinges, slides and links, in axes of their bodies.
//!
//! What a description has zeros of, is a type here, and costs nothing: the places of joints, turns between bodies, mass centres and
//! tensors. A seven-joint arm of the usual make takes two fifths of the instructions of the same arm in the elements of
//! [`spatial`](crate::spatial), whose scenes, ends, rules, loads and readings these are.
//!
//! ```
//! use catena::robot::*;
//!
//! // Mass (kg), mass centre (m), inertia tensor about it (kg·m²); of centre and tensor what the masks name.
//! let upper = Link::<f64, 0b100, 0b111>::new(4.0, [0.0, 0.0, 0.2], [[0.06, 0.0, 0.0], [0.0, 0.06, 0.0], [0.0, 0.0, 0.01]]);
//! // A hinge about z of its body; where it sits on the parent (m, only z is there), and how it is turned there.
//! let waist = Hinge::level().grounded(); // on the base
//! let shoulder = Hinge::at::<0b100>([0.0, 0.0, 0.3]).turned(Quarter::<30>);
//! let elbow = Hinge::at::<0b100>([0.0, 0.0, 0.4]).with(Spring::damping(0.1));
//! let chain = (waist, upper, shoulder, upper, elbow, upper);
//! let arm = System::new(Base::origin(), chain, Free)?.with_gravity([0.0, 0.0, -9.81]);
//!
//! // Functions of lists in the order of the joints.
//! let (q, v) = ([0.1, 0.7, -0.4], [0.2, 0.0, 1.0]);
//! let hold = arm.inverse_dynamics(&q, &v, &[0.0; 3])?;
//! assert!(arm.forward_dynamics(&q, &v, &hold)?.iter().all(|second| second.abs() < 1e-12));
//!
//! // And a scene like any other.
//! let start = arm.at_joints(&q, &v)?;
//! let run = arm.simulate(start, Dop853::tolerance(1e-10), 1.0, |now| println!("{:.2} {:?}", now.time(), now.energy()))?;
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! On a [`Base`] a scene is in body axes; else from [`BodyAxes`] on outward: inboard of it elements of [`spatial`](crate::spatial) may come,
//! a root that moves among them, and the root [`Free`] makes a floating base of a [`Link`] that follows. Arms are [`Branch`]es: each sits where its first
//! joint says, and takes no body of its own.
//!
//! | function of lists | what it gives |
//! |---|---|
//! | `forward_dynamics`, `inverse_dynamics`, `bias`, `gravity_torques` | accelerations from torques, torques from accelerations |
//! | `mass_matrix`, `mass_solved`, `mass_inverse` | M, M⁻¹ times a list, M⁻¹ |
//! | `places`, `jacobian` | where bodies are, and points of them ([`Place::point`]); how a point moves with the joints |
//! | `mass_centre`, `joint_energy` | |
//! | `difference`, `integrate`, `random_configuration` | what leads from one configuration to another, where that leads; one within limits |
//! | `inverse_dynamics_derivatives`, `forward_dynamics_derivatives` | by positions, rates and torques |
//! | `forward_dynamics_afloat`, `inverse_dynamics_afloat`, `mass_matrix_afloat`, `mass_solved_afloat`, `mass_inverse_afloat`, `jacobian_afloat` | the same for bases that float, with a wrench on the base |
//! | `inverse_dynamics_derivatives_afloat`, `forward_dynamics_derivatives_afloat` (`_into` a place that is kept) | by turn and angular velocity of the base, positions, rates, wrench and torques |
//! | `operational_compliance`, `operational_inertia`, both also `_afloat` | how a body yields at a point, J M⁻¹ Jᵀ, and the inverse of that |
//! | `impact`, `impact_afloat` | rates after a joint has struck a hard stop |
//! | `impact_of_point`, `impact_of_point_afloat` | rates after a point of a body has struck a plane |
//! | `joint_energy_afloat`, `difference_afloat`, `integrate_afloat`, `random_configuration_afloat` | with place and attitude of the base |
//! | `snapshot`, `snapshot_afloat` | a [`Snapshot`]: points, their velocities and accelerations, Jacobians and their rates, mass matrix, inverse dynamics, centroidal momentum, the regressor; for bases that float, too |
//!
//! Those without `afloat` are for robots whose base is fixed: on other roots they do not compile ([`FixedBase`]); a base
//! that moves is taken at time zero. Those with `afloat` are for the root [`Free`], with velocities of the base in inertial axes, angular ones in its own. Angles out of range (400 000 rad), at which runs stop, are not refused here. None allocates; each is
//! one walk outward, one inward, or both.
//!
//! Lists, and the number of a joint that a function takes, begin with the first joint beyond the base: of an arm on a `Base` that is joint 1 of
//! `describe` and of loads. `scene.joint(name)?.coordinates().start` is the number in lists.
//!
//! Furniture of joints is laws ([`DryFriction`], [`Stops`], a tuple of laws), drives are [`Motor`]s that a controller asks, and a [`Rotor`] behind gears
//! does to the bodies beside its joint all that it does. Scenes, not functions of
//! lists, know joints with modes ([`Coulomb`], [`HardStops`], [`BoundedCoulomb`]) and joints whose coordinate is a function of time ([`Driven`]). Loads on links
//! are those of [`spatial`](crate::spatial), in inertial axes; points that touch the ground are [`Contacts`].
//!
//! From a [`Flange`] on, a place on a link, a scene is in inertial axes again: there the ground holds a tip ([`Pinned`], [`Hinged`], [`Clamped`]), a
//! loop closes, other elements hang. An arm of a [`Network`] begins with [`BodyAxes`] and ends with a `Flange`. Functions of lists know no `Flange`:
//! torques of such robots are [`Torques`].
//!
//! Gradients of runs go [backward](System::backward) through robots, those that float, are held or close loops among them: by starts, masses, mass
//! centres, tensors, places and turns of joints, springs, friction, stops, rotors, gravity, and the torques of every step, which are
//! [`Effort`]s, one for each joint, that of the base included. What a type says to be zero has no derivative, and costs nothing.
//!
//! ```
//! use catena::robot::*;
//! let link = Link::general(4.0, [0.0, 0.0, 0.2], [[0.06, 0.0, 0.0], [0.0, 0.06, 0.0], [0.0, 0.0, 0.01]]);
//! let elbow = Hinge::at::<0b100>([0.0, 0.0, 0.4]).turned(Quarter::<30>);
//! let arm = System::new(Base::origin(), (Hinge::level().grounded(), link, elbow, link), Free)?.with_gravity([0.0, 0.0, -9.81]);
//! let (start, torques) = (arm.at_joints(&[0.1, 0.7], &[0.0; 2])?, [Effort([0.2, 0.0, 0.0]); 3 * 100]);
//! let (mut backward, mut states, mut by_torques) = (arm.backward(Rk4), [start; 101], torques);
//! backward.run(&start, 0.001, 100, &torques, &mut states)?;
//! // Of the angle of the elbow at the end.
//! let gradient = backward.gradient(&torques, &states, &mut by_torques, |step, _, by| {
//!     if step == 100 { by.add(&[0.0, 1.0], &[0.0; 2]) } else { Ok(()) }
//! })?;
//! // By its torque in the first step, and by its angle and its rate at the start.
//! let (by_torque, by_angle, by_rate) = (by_torques[2].0[0], gradient.by_position()[1], gradient.by_rate()[1]);
//! # let end = |angle: f64| -> Result<f64, catena::Error> {
//! #     let (mut now, mut next, mut stepper) = (arm.at_joints(&[0.1, angle], &[0.0; 2])?, start, arm.stepper(Rk4));
//! #     for _ in 0..100 {
//! #         stepper.step(&now, &Loads::none().efforts(&torques[..3]), 0.001, &mut next)?;
//! #         now = next;
//! #     }
//! #     Ok(now.coordinates()[1])
//! # };
//! # assert!(by_torque > 0.0 && by_rate > 0.0 && (by_angle - (end(0.7001)? - end(0.6999)?) / 2e-4).abs() < 1e-7);
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! More than a few derivatives of a run go [`through_gains`](crate::sensitivity), all that the state and the numbers of a robot are, of a base that
//! floats, too: of an arm of seven joints by eight numbers for a third of what jets take by the rule itself. Not beyond a [`Flange`] and through
//! driven joints; Taylor series do not compile.

mod functions;

pub use crate::mechanics::spatial::body_axes::{
    AboutZ, Ahead, AlongZ, Armature, Axis, Base, Bearing, Block, BodyAxes, Flange, Hinge, Leaning, Level, Link, Offset,
    OnBody, OnGround, Place, Quarter, Rotor, Sharing, Slide, Torques, Turned, Upright, Yielding,
};
pub use crate::spatial::*;
pub use functions::{
    Afloat, Blocks, ByState, ByStateAfloat, FixedBase, MassMatrix, Regressor, SixRows, Snapshot, Tasks,
};
