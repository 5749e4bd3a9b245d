//! Gradients of runs whose joints are coupled: by all numbers of the scene and by the ratios, in chains and arms, by explicit and implicit rules.

use super::loads::Medium;
use super::names::*;

/// Numbers of a rod, a rigid body and a bob.
const BODIES: [f64; 12] = [1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2, 0.6, 0.9];
/// Ratios of an angle to an angle, of a way to an angle (m), and of an angle to one that follows itself.
const RATIOS: [f64; 3] = [-0.7, 0.4, 1.6];
/// Of the first (rad).
const OFFSET: f64 = 0.2;
/// What the numbers are.
const KINDS: [(&str, usize); 6] =
    [("bodies", 12), ("hinge and slide", 4), ("root", 3), ("gravity", 1), ("ratios", 3), ("medium", 5)];
/// Coordinates: crank, arm, hinge, slide, gear, pin; and joints, the root's among them.
const COUNTS: [usize; 2] = [6, 7];

/// A crank, an arm that turns against it, a slide that a hinge winds, and a gear that follows the arm.
macro_rules! geared {
    ($x:expr, $N:ty) => {{
        let x = $x;
        let rod = Rod::<$N>::new(x(0), x(1), x(2), x(3));
        let rigid = RigidBody::<$N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
        let bob = PointMass::<$N>::new(x(10), x(11));
        let turning = Revolute::smooth();
        let hinge = ElasticHinge::rotary(x(12)).damped(x(13));
        let slide = Slider::along(x(14)).with(Spring::new(x(15)));
        let chain = (turning, rigid, Branch((turning, rod)), hinge, rod, slide, rigid, turning, rod, Pin, bob);
        System::new(Clamped::at(x(16), x(17), x(18)), chain, Free).unwrap().with_gravity(x(19))
    }};
}

/// The couplings of its joints.
fn couplings<T: Scalar<Real = f64>>(ratios: [T; 3]) -> [Coupling<'static, T>; 3] {
    let [arm, slide, gear] = ratios;
    let offset = T::constant(OFFSET);
    [Coupling::new(2, 1).ratio(arm).offset(offset), Coupling::new(4, 3).ratio(slide), Coupling::new(5, 2).ratio(gear)]
}

/// The numbers of a run that begins coupled.
fn numbers(seed: u64, steps: usize) -> Vec<f64> {
    let [coordinates, joints] = COUNTS;
    let mut list = BODIES.to_vec();
    list.extend([12.0, 0.3, -0.4, 40.0, 0.2, 0.1, 0.3, 9.81]);
    list.extend(RATIOS);
    list.extend([0.4, 7.0, 0.5, 0.8, 0.05]);
    let mut moving = moving(&mut Noise::new(seed), coordinates, steps * joints);
    let (positions, rates) = moving.split_at_mut(coordinates);
    for (list, offset) in [(positions, OFFSET), (rates, 0.0)] {
        list[1] = RATIOS[0] * list[0] + offset;
        list[3] = RATIOS[1] * list[2];
        list[4] = RATIOS[2] * list[1];
    }
    list.extend(moving);
    list
}

macro_rules! coupled {
    ($name:expr, $seed:expr, $method:expr, $steps:expr) => {
        gradients!(
            $name,
            &with_motion(&KINDS, COUNTS[0], $steps * COUNTS[1]),
            numbers($seed, $steps),
            [COUNTS[0], COUNTS[1]],
            $method,
            $steps,
            0.02,
            |x| { geared!(x, N) },
            coupled(8, |x| {
                let medium = Medium { drag: x(23), stiffness: x(24), anchor: [x(25), x(26)], brake: x(27) };
                (couplings([x(20), x(21), x(22)]), medium)
            })
        )
    };
}

#[test]
fn coupled_joints_have_the_gradients_of_jets() {
    coupled!("coupled, RK4", 71, Rk4, 5);
    coupled!("coupled, DOP853", 72, Dop853, 2);
}

#[test]
fn coupled_joints_have_the_gradients_of_jets_by_implicit_rules() {
    coupled!("coupled, Sdirk4", 75, Sdirk4::new(), 3);
    coupled!("coupled, generalised-α", 74, GeneralizedAlpha::new(0.8), 4);
}

/// Behind a hinge with springs along axes that do not turn: its virtual velocities are not those of its coordinates.
#[test]
fn coupled_joints_behind_fixed_axes_have_the_gradients_of_jets() {
    let (steps, coordinates, joints) = (5, 6, 5);
    let mut list = vec![1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2];
    list.extend([24.0, 0.6, 18.0, 0.1, 9.81]);
    list.extend(&RATIOS[..1]);
    let mut moving = moving(&mut Noise::new(77), coordinates, steps * joints);
    let (positions, rates) = moving.split_at_mut(coordinates);
    for (list, offset) in [(positions, OFFSET), (rates, 0.0)] {
        list[5] = RATIOS[0] * list[0] + offset;
    }
    list.extend(moving);
    let kinds = [("bodies", 10), ("springs", 4), ("gravity", 1), ("ratio", 1)];
    gradients!(
        "coupled behind fixed axes",
        &with_motion(&kinds, coordinates, steps * joints),
        list,
        [coordinates, joints],
        Rk4,
        steps,
        0.02,
        |x| {
            let rod = Rod::<N>::new(x(0), x(1), x(2), x(3));
            let rigid = RigidBody::<N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
            let spring = Spring::new(x(10)).damped(x(11));
            let fixed = ElasticHinge::rotary(x(12)).damped(x(13)).with_linear(spring, spring).in_fixed_axes();
            let turning = Revolute::smooth();
            let chain = (turning, rigid, fixed, rod, Pin, rigid, turning, rod);
            System::new(Clamped::origin(), chain, Free).unwrap().with_gravity(x(14))
        },
        coupled(1, |x| {
            let follows = Coupling::new(4, 1).ratio(x(15)).offset(N::constant(OFFSET));
            ([follows], Absent)
        })
    );
}

/// A strut from the last rod to the ground.
fn strut<T: Scalar>([a, b, x, y, stiffness, damping, length]: [T; 7]) -> [Strut<T, 2>; 1] {
    [Strut::to_ground((2, [a, b]), [x, y]).with_stiffness(stiffness).with_damping(damping).with_length(length)]
}

/// Struts beside couplings: by their numbers and by the ratios, against central differences.
#[test]
fn coupled_joints_under_struts_have_the_gradients_of_differences() {
    const STEPS: usize = 10;
    /// Seven numbers of a strut to the ground, and a ratio.
    const NUMBERS: [f64; 8] = [0.6, 0.1, 1.5, 1.2, 9.0, 0.4, 0.8, -0.7];
    let (rod, turning) = (Rod::uniform(1.0, 1.0), Revolute::smooth());
    let chain = (turning, rod, turning, rod, turning, rod);
    let scene = System::new(Clamped::origin(), chain, Free).unwrap().with_gravity(9.81);
    let mut start = scene.motion();
    start.set_coordinates(&[-0.5, 0.35, 0.2]).unwrap();
    start.set_rates(&[0.4, -0.28, 0.1]).unwrap();
    let loads = |x: &dyn Fn(usize) -> f64| {
        let couplings = Couplings::of(&scene, [Coupling::new(2, 1).ratio(x(7))]).unwrap();
        couplings.and(Struts::of(strut(core::array::from_fn(x))))
    };
    let end = |x: &dyn Fn(usize) -> f64| {
        let (mut now, mut next, mut stepper) = (start, start, scene.stepper(Rk4));
        for _ in 0..STEPS {
            stepper.step(&now, &loads(x), 0.02, &mut next).unwrap();
            core::mem::swap(&mut now, &mut next);
        }
        now.coordinates()[2] + 0.5 * now.rates()[0]
    };
    let (mut states, mut backward) = ([start; STEPS + 1], scene.backward(Rk4).under(loads(&|k| NUMBERS[k])));
    backward.run(&start, 0.02, STEPS, &[], &mut states).unwrap();
    let gradient = backward
        .gradient(&[], &states, &mut [], |step, _, by| match step {
            STEPS => by.add(&[0.0, 0.0, 1.0], &[0.5, 0.0, 0.0]),
            _ => Ok(()),
        })
        .unwrap();
    let mut found =
        gradient.along_struts(&strut(core::array::from_fn(|k| Jet::<f64, 7>::seed(NUMBERS[k], k)))).to_vec();
    found.extend(gradient.by_ratios());
    let expected: Vec<f64> = (0..8)
        .map(|j| {
            let at = |e: f64| end(&|k| NUMBERS[k] + if k == j { e } else { 0.0 });
            let e = 1e-4;
            derivative(e, at)
        })
        .collect();
    alike("coupled, under a strut", &[("strut", 7), ("ratio", 1)], &found, &expected, 1e-6);
}

/// Runs that begin apart.
#[test]
fn what_couplings_do_not_go_backward_through_is_refused() -> Result<(), catena::Error> {
    let (rod, turning) = (Rod::uniform(1.0, 1.0), Revolute::smooth());
    let chain = (turning, rod, turning, rod, turning, rod);
    let scene = System::new(Clamped::origin(), chain, Free)?;
    let couplings = Couplings::of(&scene, [Coupling::new(2, 1)])?;
    let mut states = [scene.at_rest(&[0.1, 0.3, 0.4])?; 2]; // relative angles 0.1 and 0.2
    let (start, mut backward) = (states[0], scene.backward(Rk4).under(couplings));
    let fault = backward.run(&start, 0.01, 1, &[], &mut states).err().map(|error| error.fault);
    let Some(catena::Fault::NotAssembled { residual }) = fault else { panic!("{fault:?}") };
    near(residual, 0.1, 1e-15);
    Ok(())
}
