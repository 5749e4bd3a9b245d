//! Trees with springs and dampers in their joints, by rules whose pivots know these.

use super::loads::{MEDIUM, Medium};
use super::*;

/// A spring that stiffens, with a damper: −k (s + g s³) − c ṡ.
#[derive(Clone, Copy, Debug)]
struct Growing<T> {
    stiffness: T,
    growth: T,
    damping: T,
}
catena::lift!(Growing<T> { stiffness, growth, damping });

impl<T: Scalar> SpringLaw<T> for Growing<T> {
    const LINEAR: bool = false;

    fn force(&self, position: T, rate: T) -> T {
        let Self { stiffness, growth, damping } = *self;
        -(stiffness * (position + growth * position * position * position)) - damping * rate
    }
    fn energy(&self, _: T) -> T {
        T::zero()
    }
    fn pivot(&self, position: T, _: T, springs: impl Springs<T>) -> T {
        let slope = T::one() + T::literal(3.0) * self.growth * position * position;
        springs.pivot(self.stiffness * slope, self.damping)
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

/// A tree on a hinge that is turned, with springs from soft to stiff.
macro_rules! sprung {
    ($method:expr, $stiffness:expr) => {{
        let mut parameters = bodies(2);
        parameters.extend([0.3, 1.0, -0.5, 0.2, 0.1, -0.4]); // an axis, a weld
        parameters.extend([0.7, 0.8, 0.3, 0.02, 0.05]); // a rod
        parameters.extend([$stiffness, 0.01 * $stiffness, 0.2, 3.0]); // springs
        let kinds: Kinds =
            &[("bodies", 26), ("gravity", 3), ("axis", 3), ("weld", 3), ("rod", 5), ("spring", 3), ("other", 1)];
        let name = format!("springs of {} N·m/rad, {:?}", $stiffness, $method);
        gradients!(&name, kinds, parameters, [false; 4], 5, $method, 3, 0.03, |x| {
            let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
            let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
            let (hinge, weld) = (Revolute::about(vector(29)), Weld::at(Rotation::from_angles(vector(32))));
            let sprung = hinge.with(Spring::new(x(40)).damped(x(41)).resting_at(x(42)));
            let rod = Rod::new(x(35), x(36), x(37), x(38), x(39));
            let arm = (hinge.with(Spring::new(x(43))), of(1));
            let ground = Clamped::at([0.0; 3].map(N::constant), Rotation::from_angles(vector(32)));
            let chain = (of(0), Branch(arm), weld, sprung, rod, hinge, of(1));
            System::new(Hinged::on(ground, vector(29)), chain, Free).unwrap().with_gravity(vector(26))
        })
    }};
}

/// Without optimisation too much for the stack of a test.
fn in_a_thread(of: fn()) {
    let thread = std::thread::Builder::new().stack_size(1 << 25).spawn(of).expect("a thread");
    thread.join().expect("gradients of jets");
}

#[test]
fn trees_on_springs_have_the_gradients_of_jets_by_sdirk4() {
    in_a_thread(|| {
        sprung!(Sdirk4::new(), 10.0);
        sprung!(Sdirk4::new(), 1e4);
    });
}

#[test]
fn trees_on_springs_have_the_gradients_of_jets_by_generalized_alpha() {
    in_a_thread(|| {
        sprung!(GeneralizedAlpha::new(0.8), 10.0);
        sprung!(GeneralizedAlpha::new(0.8).with_sweeps(3), 1e4);
    });
}

/// Balls about a hinge with a spring, a law that is not linear in a slide, an arm: on the ground, in a medium, or afloat.
macro_rules! balls {
    ($method:expr, $root:expr, $coordinates:expr, $h:expr) => {{
        let mut parameters = bodies(2);
        parameters.extend([0.3, 1.0, -0.5, 0.7, 0.8, 0.3, 0.02, 0.05]); // an axis, a rod
        parameters.extend([300.0, 5.0, 0.2, 200.0, 0.4, 4.0]); // a spring, a law
        parameters.extend(MEDIUM);
        let kinds: Kinds =
            &[("bodies", 26), ("gravity", 3), ("axis", 3), ("rod", 5), ("spring", 3), ("own law", 3), ("medium", 6)];
        let coordinates = [&$coordinates[..], &[true, false, false, true]].concat();
        let name = format!("balls on {}, {:?}", stringify!($root), $method);
        gradients!(
            &name,
            kinds,
            parameters,
            coordinates,
            5,
            $method,
            3,
            $h,
            |x| {
                let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                let sprung = Revolute::about(vector(29)).with(Spring::new(x(37)).damped(x(38)).resting_at(x(39)));
                let own = Custom(Growing { stiffness: x(40), growth: x(41), damping: x(42) });
                let rod = Rod::new(x(32), x(33), x(34), x(35), x(36));
                let chain = (
                    rod,
                    Branch((Ball, of(0))),
                    sprung,
                    of(1),
                    Prismatic::along(vector(29)).with(own),
                    of(0),
                    Ball,
                    rod,
                );
                System::new($root, chain, Free).unwrap().with_gravity(vector(26))
            },
            under(6, |y| { Medium::of(y, 43) })
        )
    }};
}

#[test]
fn balls_have_the_gradients_of_jets_by_sdirk4() {
    in_a_thread(|| {
        balls!(Sdirk4::new(), Pinned::on([0.0; 3].map(N::constant)), [true], 0.02);
        balls!(Sdirk4::new(), Free, [false, false, false, true], 0.02);
    });
}

#[test]
fn balls_have_the_gradients_of_jets_by_generalized_alpha() {
    in_a_thread(|| {
        balls!(GeneralizedAlpha::new(0.8), Pinned::on([0.0; 3].map(N::constant)), [true], 0.02);
        balls!(GeneralizedAlpha::new(0.8).with_sweeps(3), Free, [false, false, false, true], 0.02);
    });
}

/// A tip on a ball, and a loop that a ball closes.
#[test]
fn balls_in_closed_scenes_have_the_gradients_of_jets() {
    macro_rules! closed {
        ($method:expr) => {{
            let mut parameters = bodies(2);
            parameters.extend([0.3, 1.0, -0.5, 30.0, 1.0, 0.2, 1.4, 0.5, -0.3]); // an axis, a spring, the tip
            let kinds: Kinds = &[("bodies", 26), ("gravity", 3), ("axis", 3), ("spring", 3), ("tip", 3)];
            let coordinates = [true, true, false, true, true, true];
            gradients!(
                &format!("balls in closed scenes, {:?}", $method),
                kinds,
                parameters,
                coordinates,
                7,
                $method,
                2,
                0.02,
                |x| {
                    let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                    let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                    let sprung = Revolute::about(vector(29)).with(Spring::new(x(32)).damped(x(33)).resting_at(x(34)));
                    let main = (Ball, of(0), sprung, of(1));
                    let chain = (of(1), Network::new(main, (Ball, of(1), Ball, of(0)), Ball), Ball, of(0));
                    let root = Pinned::on([0.0; 3].map(N::constant));
                    System::new(root, chain, Pinned::at(vector(35))).unwrap().with_gravity(vector(26))
                }
            )
        }};
    }
    in_a_thread(|| {
        closed!(Sdirk4::new());
        closed!(GeneralizedAlpha::new(0.8));
    });
}
