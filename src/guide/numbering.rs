//! Which number is whose: bodies, joints, stations and coordinates count from 0 at the root, in the order in which the scene is written.
//!
//! ```text
//!            joint 0        joint 1        joint 2
//!            (the root's)
//!   ground ────●──────────────●──────────────●────────────── tip
//!                  body 0         body 1         body 2
//!   station  root │0          │1  2          │3  4          │5
//! ```
//!
//! A station is the inboard end of a body or joint; the joint of the root has none but the root itself. `describe` prints all of them:
//!
//! ```
//! use catena::planar::*;
//! let rod = Rod::uniform(1.0, 1.0);
//! let arm = (rod, Pin.named("elbow"), rod.named("forearm"));
//! let scene = System::new(Pinned::origin().named("shoulder"), arm, Free)?;
//! let table = "
//! station  joint  body  coordinates  rates  kind  name
//!    root      0                  0      0  Pin   shoulder
//!       0            0                      Rod
//!       1      1                  1      1  Pin   elbow
//!       2            1                      Rod   forearm
//!       3  the tip";
//! assert_eq!(scene.describe().to_string(), table.trim_start());
//! // Names stand for all of a joint's or body's numbers.
//! let (elbow, forearm) = (scene.joint("elbow")?, scene.body("forearm")?);
//! assert_eq!((elbow.joint, elbow.coordinates(), forearm.body), (1, 1..2, 1));
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! Arms come before what follows them: in `(rod, Branch((Pin, rod)), Pin, rod)` the arm's rod is body 1. Of a network the main arm comes
//! first, then the side arm, then the joint that closes it. In a vector `vec![(Pin, rod); n]` each link's pin comes before its rod.
//!
//! | asked for by | number |
//! |---|---|
//! | loads in joints, torques | joint |
//! | loads on bodies, struts, angles | body |
//! | forces, errors | station |
//! | [`Motion::coordinates`](crate::Motion::coordinates), `rates` | coordinates, rates: four and three of a turn in space |
//! | [functions of lists](crate::robot) of robots | the coordinate: joints from 0 at the first beyond the base |
