//! A cart on a track that carries a double pendulum.

use catena::Error;
use catena::planar::*;
use catena::simulate::MotionIn;
use nalgebra::{RowVector6, SMatrix, Vector6};

pub type Square = SMatrix<f64, 6, 6>;
/// Place of the cart (m), absolute angles of the rods (rad), and their rates.
pub type State = Vector6<f64>;

pub const H: f64 = 0.01; // size of a step (s)
pub const LENGTHS: [f64; 2] = [0.5, 0.4]; // (m)

pub type Chain = (Slider<f64, Spring<Absent, f64>>, RigidBody<f64>, Pin, Rod<f64>, Pin, Rod<f64>);
pub type Scene = System<f64, Clamped<[f64; 2], f64>, Chain, Free>;
pub type Motion = MotionIn<Scene, Unloaded>;

pub fn scene() -> Result<Scene, Error> {
    let cart = RigidBody::new(1.0, 0.1, [0.0; 2], [0.0; 2]);
    let [lower, upper] = [Rod::uniform(LENGTHS[0], 0.3), Rod::uniform(LENGTHS[1], 0.2)];
    let track = Slider::along(0.0).with(Spring::damping(0.1));
    Ok(System::new(Clamped::origin(), (track, cart, Pin, lower, Pin, upper), Free)?.with_gravity(9.81))
}

pub fn state_of(motion: &Motion) -> Result<State, Error> {
    let mut state = State::zeros();
    let (positions, rates) = state.as_mut_slice().split_at_mut(3);
    motion.coordinates_into(positions)?;
    motion.rates_into(rates)?;
    Ok(state)
}

pub fn motion_of(scene: &Scene, state: &State) -> Result<Motion, Error> {
    let mut motion = scene.motion();
    motion.set_coordinates(&state.as_slice()[..3])?;
    motion.set_rates(&state.as_slice()[3..])?;
    Ok(motion)
}

/// Efforts in the joints: root, track, two pins.
pub fn push(force: f64) -> [f64; 4] {
    [0.0, force, 0.0, 0.0]
}

/// A = ∂x′/∂x and B = ∂x′/∂F of a step.
pub fn linearised(scene: &Scene, state: &State, force: f64) -> Result<(Square, State), Error> {
    let now = motion_of(scene, state)?;
    let (mut next, mut a, mut b) = (now, [0.0; 36], [0.0; 24]);
    scene.backward(Rk4).linearised_step(&now, H, &push(force), &mut next, &mut a, &mut b)?;
    Ok((Square::from_row_slice(&a), State::from_fn(|row, _| b[4 * row + 1])))
}

/// Gains of a regulator about a state of rest, by weights of the force (1/N²) and of what the state is off by: what a recursion backward through
/// steps that are all alike comes to.
pub fn regulator(scene: &Scene, rest: &State, force: f64, off: &State) -> Result<RowVector6<f64>, Error> {
    let ((a, b), mut bend) = (linearised(scene, rest, 0.0)?, Square::from_diagonal(off));
    let mut gain = RowVector6::zeros();
    for _ in 0..2000 {
        gain = -(b.transpose() * bend * a) / (b.dot(&(bend * b)) + H * force);
        let closed = a + b * gain;
        bend =
            closed.transpose() * bend * closed + gain.transpose() * gain * (H * force) + Square::from_diagonal(off) * H;
    }
    Ok(gain)
}
