//! What a gradient backward costs beside its plain run, on chains of rods on pins: phyz's adjoint, by the inertias of all bodies, and Catena's, by
//! those, lengths, gravity, all initial values and torques. A line a chain: library, bodies, seconds of the plain run, of the gradient.
//!
//! phyz has its adjoint of semi-implicit Euler steps of order 1, one evaluation each; Catena's are of RK4, four.

use catena::planar::*;
use catena_rivals::{GRAVITY, phyz_chain, timed};
use phyz::diff::{AdjointRollout, FinalStateObjective, adjoint_rollout_gradient, rollout_objective};

const STEPS: usize = 200;
const STEP: f64 = 1e-3;

fn of_phyz(bodies: usize) {
    let model = phyz_chain(bodies, STEP);
    let none = |_| phyz::DVec::zeros(bodies);
    let rollout = AdjointRollout {
        model: &model,
        contact: None,
        q0: vec![0.0; bodies],
        v0: vec![0.0; bodies],
        steps: STEPS,
        ctrl: &none,
    };
    let objective = FinalStateObjective {
        value: &|q, _| q.iter().sum(),
        gradient: &|q, v| (vec![1.0; q.len()], vec![0.0; v.len()]),
    };
    let (plain, seconds) = timed(|| rollout_objective(&rollout, &objective));
    let (found, whole) = timed(|| adjoint_rollout_gradient(&rollout, &objective));
    assert_eq!(found.objective, plain);
    println!("phyz,{bodies},{seconds:e},{whole:e}");
}

macro_rules! of_catena {
    ($($bodies:literal)*) => {$({
        let rod = Rod::uniform(1.0 / f64::from($bodies), 1.0 / f64::from($bodies));
        let scene = System::new(Pinned::origin(), (rod, [(Pin, rod); $bodies - 1]), Free).unwrap().with_gravity(GRAVITY);
        let start = scene.with_accelerations(scene.at_rest(&[0.0; $bodies]).unwrap(), &Unloaded).unwrap();
        let torques = vec![0.0; STEPS * scene.joints()];
        let (mut by_torques, mut states) = (torques.clone(), vec![start.clone(); STEPS + 1]);
        let (mut past, mut next) = (start.clone(), start.clone());
        let (mut stepper, mut backward) = (scene.stepper(Rk4), scene.backward(Rk4));
        let (_, seconds) = timed(|| {
            past.clone_from(&start);
            for _ in 0..STEPS {
                stepper.advance(&past, &Unloaded, STEP, &mut next).unwrap();
                core::mem::swap(&mut past, &mut next);
            }
            past.rates()[0]
        });
        let (_, whole) = timed(|| {
            backward.run(&start, STEP, STEPS, &torques, &mut states).unwrap();
            let gradient = backward.gradient(&torques, &states, &mut by_torques, |step, _, by| {
                if step == STEPS { by.add(&[1.0; $bodies], &[0.0; $bodies]) } else { Ok(()) }
            });
            gradient.unwrap().by_position()[0]
        });
        println!("Catena,{},{seconds:e},{whole:e}", $bodies);
    })*};
}

fn main() {
    println!("library,bodies,plain,gradient");
    [1, 4, 8, 16].into_iter().for_each(of_phyz);
    of_catena!(1 4 8 16);
}
