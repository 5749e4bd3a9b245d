//! What the target `data` reads, and its seeds are made of: a scene in the plane, runs of it that stand in the middle, a scene in space.

use catena::planar::*;
use catena::simulate::{AdamsMemory, Saved, VcabmMemory};
use catena::system::{MotionOf, RateOf};
use catena::{Error, spatial};

type Chain = (Rod<f64>, Vec<(ElasticHinge<Spring<f64>>, RigidBody<f64>)>);
type Root = Pinned<[f64; 2]>;
type Moves = MotionOf<Planar<f64>, Root, Chain, Free>;
type Arm = (spatial::Rod<f64>, spatial::Ball, spatial::RigidBody<f64>, spatial::Revolute<f64>, spatial::Rod<f64>);

pub type Scene = System<f64, Root, Chain, Free>;
pub type ByAdams = Saved<Moves, AdamsMemory<Moves>, f64>;
pub type ByVcabm = Saved<Moves, VcabmMemory<Moves, RateOf<Planar<f64>, Root, Chain>, f64>, f64>;
pub type InSpace =
    spatial::System<f64, spatial::Clamped<[f64; 3], spatial::Rotation<f64>>, (spatial::Weld<f64>, Arm), spatial::Free>;

/// A rod and so many bodies on hinges with springs.
pub fn in_plane(bodies: usize) -> Result<Scene, Error> {
    let body = RigidBody::new(1.0, 0.2, [0.5, 0.1], [1.0, 0.0]);
    let chain = (Rod::uniform(1.0, 1.0), vec![(ElasticHinge::rotary(5.0), body); bodies]);
    Ok(System::new(Pinned::origin(), chain, Free)?.with_gravity(9.81))
}
