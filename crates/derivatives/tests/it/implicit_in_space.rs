//! Gradients of runs by implicit rules in space, backward: revolutes with springs, against jets through the same steps and central differences.

use super::held::share;
use catena::Scalar;
use catena::scalar::Jet;
use catena::spatial::*;

/// How one number acts in a joint of space: as the first of an effort, in a revolute the torque about its axis.
mod efforts {
    use catena::Scalar;
    use catena::spatial::Effort;

    pub fn of<T: Scalar>(torque: T) -> Effort<T> {
        Effort([torque, T::zero(), T::zero()])
    }
    pub fn number<T: Scalar>(Effort([torque, ..]): &Effort<T>) -> T {
        *torque
    }
}

/// Lengths, radii and masses of three kinds of rods, axes, gravity, a spring.
fn numbers(stiffness: f64) -> Vec<f64> {
    let mut list = vec![0.5, 0.4, 0.6, 0.05, 0.04, 0.06, 1.2, 0.7, 0.9];
    list.extend([0.1, 0.3, 1.0, 0.4, 1.0, -0.2, 0.2, -0.6, 0.8, 0.5, 0.1, -9.81]);
    list.extend([stiffness, 0.02 * stiffness, 0.2]);
    list
}

const KINDS: [(&str, usize); 6] =
    [("lengths", 3), ("radii", 3), ("masses", 3), ("axes", 9), ("gravity", 3), ("springs", 3)];

/// Runs what needs more stack than a test's thread has: jets of eight derivatives in arrays of all sweeps of a step.
fn on_a_large_stack(test: fn()) {
    let run = std::thread::Builder::new().stack_size(256 << 20).spawn(test).unwrap().join();
    run.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
}

#[test]
fn chains() {
    on_a_large_stack(chain_and_arm);
}

#[test]
fn tip_on_a_ball() {
    on_a_large_stack(tip_held_by_a_ball);
}

#[test]
fn loops() {
    on_a_large_stack(arms_that_meet);
}

/// A chain and an arm on revolutes, with a weld.
fn chain_and_arm() {
    macro_rules! of {
        ($name:expr, $stiffness:literal, $method:expr) => {
            let kinds = [&KINDS[..], &[("weld", 3)]].concat();
            let mut parameters = numbers($stiffness);
            parameters.extend([0.2, -0.3, 0.4]);
            gradients!(
                super::implicit_in_space::efforts,
                $name,
                kinds,
                parameters,
                vec![0.3, -0.4, 0.5, 0.2, -0.6],
                7,
                $method,
                4,
                0.02,
                |x| {
                    let rod = |i: usize| Rod::<N>::uniform(x(i), x(3 + i), x(6 + i));
                    let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                    let spring = Spring::new(x(21)).damped(x(22)).resting_at(x(23));
                    let (a, b, c) =
                        (Revolute::about(vector(9)), Revolute::about(vector(12)), Revolute::about(vector(15)));
                    let weld = Weld::at(Rotation::from_angles(vector(24)));
                    let arm = (b.with(spring), rod(0), c, rod(1));
                    let chain = (a, rod(0), b.with(spring), rod(1), Branch(arm), weld, rod(1), c.with(spring), rod(2));
                    let root = Clamped::at([0.0; 3].map(N::constant), Rotation::from_angles([0.0; 3].map(N::constant)));
                    System::new(root, chain, Free).unwrap().with_gravity(vector(18))
                }
            );
        };
    }
    of!("Sdirk4", 10.0, Sdirk4::new());
    of!("generalised alpha", 10.0, GeneralizedAlpha::new(0.8));
    of!("generalised alpha, three sweeps", 300.0, GeneralizedAlpha::new(0.8).with_sweeps(3));
}

/// Six revolutes between the ground and a ball that holds the tip.
fn tip_held_by_a_ball() {
    macro_rules! of {
        ($name:expr, $method:expr) => {
            let kinds = [&KINDS[..], &[("tip", 3)]].concat();
            let mut parameters = numbers(10.0);
            parameters.extend([1.2, 0.9, 0.6]);
            let angles = vec![0.3, -0.4, 0.5, 0.8, -0.6, 0.4];
            gradients!(super::implicit_in_space::efforts, $name, kinds, parameters, angles, 7, $method, 3, 0.01, |x| {
                let rod = |i: usize| Rod::<N>::uniform(x(i), x(3 + i), x(6 + i));
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let spring = Spring::new(x(21)).damped(x(22)).resting_at(x(23));
                let (a, b, c) = (Revolute::about(vector(9)), Revolute::about(vector(12)), Revolute::about(vector(15)));
                let root = Clamped::at([0.0; 3].map(N::constant), Rotation::from_angles([0.0; 3].map(N::constant)));
                let chain =
                    (a, rod(0), b.with(spring), rod(1), c, rod(2), a, rod(0), b.with(spring), rod(1), c, rod(2));
                System::new(root, chain, Pinned::on(vector(24))).unwrap().with_gravity(vector(18))
            });
        };
    }
    of!("Sdirk4", Sdirk4::new());
    of!("generalised alpha", GeneralizedAlpha::new(0.8));
}

/// Two arms on revolutes that meet in a ball.
fn arms_that_meet() {
    macro_rules! of {
        ($name:expr, $method:expr) => {
            let angles = vec![0.2, 0.6, -0.4, 0.3, -0.5, 0.4, -0.6];
            gradients!(
                super::implicit_in_space::efforts,
                $name,
                KINDS,
                numbers(10.0),
                angles,
                9,
                $method,
                3,
                0.01,
                |x| {
                    let rod = |i: usize| Rod::<N>::uniform(x(i), x(3 + i), x(6 + i));
                    let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                    let spring = Spring::new(x(21)).damped(x(22)).resting_at(x(23));
                    let (a, b, c) =
                        (Revolute::about(vector(9)), Revolute::about(vector(12)), Revolute::about(vector(15)));
                    let root = Clamped::at([0.0; 3].map(N::constant), Rotation::from_angles([0.0; 3].map(N::constant)));
                    let main = (a, rod(0), b.with(spring), rod(1), c, rod(2));
                    let side = (c, rod(0), a.with(spring), rod(1), b, rod(2));
                    System::new(root, (b, rod(0), Network::new(main, side, Ball)), Free)
                        .unwrap()
                        .with_gravity(vector(18))
                }
            );
        };
    }
    of!("Sdirk4", Sdirk4::new());
    of!("generalised alpha", GeneralizedAlpha::new(0.8));
}
