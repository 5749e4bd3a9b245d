//! Reading and setting coordinates: by joint, by body, as lists.
//!
//! A [`Motion`](crate::Motion) is a value: time, coordinates, rates, accelerations. Which coordinates a joint stores, absolute or relative, its
//! page says; nobody has to know.
//!
//! ```
//! use catena::planar::*;
//! let rod = Rod::uniform(1.0, 1.0);
//! let arm = (rod.named("upper arm"), Pin.named("elbow"), rod.named("forearm"));
//! let scene = System::new(Pinned::origin(), arm, Free)?.with_gravity(9.81);
//!
//! // By bodies: absolute angles from +x, absolute angular velocities.
//! let start = scene.at_rest(&[-1.0, -0.5])?; // (rad)
//! let start = scene.with_body_rates(start, &[0.0, 2.0])?; // (rad/s)
//! // By joints: what each body does against the one inboard of it.
//! let bent = scene.with_joint_rates(start.clone(), &[1.0, -1.0])?;
//! assert_eq!(bent.rates(), [1.0, 0.0]); // pins store absolute rates
//! // As lists, or the part of a joint.
//! let elbow = scene.joint("elbow")?;
//! let mut moved = start.clone();
//! moved.set_coordinates_of(elbow, &[0.3])?;
//! assert_eq!((moved.coordinates(), moved.coordinates_of(elbow)?), (vec![-1.0, 0.3], [0.3]));
//!
//! // What is read: angles, places and velocities of bodies, forces at stations.
//! let moving = scene.with_accelerations(start, &Unloaded)?;
//! let angles = scene.angles(&moving)?;
//! assert_eq!(angles.get(1), Some(&-0.5));
//! let forearm = scene.body("forearm")?;
//! let bodies = scene.body_motions(&moving)?;
//! let tip = bodies.get(forearm.body).map(|body| body.point([1.0, 0.0]).velocity);
//! let stations = scene.stations(&moving, &Unloaded)?;
//! let pivot = stations.root().internal.force; // of the ground on the arm (N)
//! assert!(tip.is_some() && pivot.y > 0.0);
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! During a run the same readings are methods of [`Now`](crate::simulate::Now). In space attitudes are unit quaternions; angles 1-2-3 serve
//! for input and output ([`Rotation`](crate::spatial::Rotation)), rates of balls are angular velocities in axes of the body.
