//! Robots of `catena-urdf` with the furniture of their joints as laws. The tests in their modules run with those of this package.

include!(concat!(env!("OUT_DIR"), "/arm7.rs"));
include!(concat!(env!("OUT_DIR"), "/arm7_bare.rs"));
include!(concat!(env!("OUT_DIR"), "/sticking_arm7.rs"));
include!(concat!(env!("OUT_DIR"), "/bounded_arm7.rs"));
include!(concat!(env!("OUT_DIR"), "/striking_arm7.rs"));
include!(concat!(env!("OUT_DIR"), "/quadruped.rs"));
include!(concat!(env!("OUT_DIR"), "/sticking_quadruped.rs"));
include!(concat!(env!("OUT_DIR"), "/humanoid.rs"));
include!(concat!(env!("OUT_DIR"), "/cart.rs"));
