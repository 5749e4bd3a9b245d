//! The robots of `catena-urdf`, as its modules say them. Their own tests run with those of this crate.

include!(concat!(env!("OUT_DIR"), "/arm7.rs"));
include!(concat!(env!("OUT_DIR"), "/quadruped.rs"));
include!(concat!(env!("OUT_DIR"), "/humanoid.rs"));
include!(concat!(env!("OUT_DIR"), "/cart.rs"));
include!(concat!(env!("OUT_DIR"), "/odd.names.rs"));
include!(concat!(env!("OUT_DIR"), "/arm7_local.rs"));
include!(concat!(env!("OUT_DIR"), "/arm7_general.rs"));
include!(concat!(env!("OUT_DIR"), "/quadruped_local.rs"));
include!(concat!(env!("OUT_DIR"), "/quadruped_general.rs"));
include!(concat!(env!("OUT_DIR"), "/humanoid_local.rs"));
include!(concat!(env!("OUT_DIR"), "/humanoid_general.rs"));
include!(concat!(env!("OUT_DIR"), "/cart_local.rs"));
include!(concat!(env!("OUT_DIR"), "/cart_general.rs"));
include!(concat!(env!("OUT_DIR"), "/quadruped_fixed.rs"));
