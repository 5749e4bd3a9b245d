//! Gradients by implicit rules of laws that are not linear, in open scenes and where a tip is held.

use super::*;

/// Revolutes, a slide and a cylinder under such laws, an arm; the tip free or held.
macro_rules! stiffening {
    ($method:expr, $stiffness:expr, $tip:expr) => {{
        let mut parameters = bodies(2);
        parameters.extend([0.3, 1.0, -0.5, 0.9, -0.2, 0.4]); // axes
        parameters.extend([$stiffness, 0.02 * $stiffness, 2.0 * $stiffness, 0.01 * $stiffness, 0.3]); // a law, a spring
        let kinds: Kinds = &[("bodies", 26), ("gravity", 3), ("axes", 6), ("laws", 5)];
        let name = format!("laws of {} N·m/rad, {:?}", $stiffness, $method);
        gradients!(&name, kinds, parameters, [false; 7], 6, $method, 3, 0.03, |x| {
            let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
            let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
            let law = Custom(Stiffening { stiffness: x(35), damping: x(36) });
            let spring = Spring::new(x(37)).damped(x(38)).resting_at(x(39));
            let (hinge, other) = (Revolute::about(vector(29)), Revolute::about(vector(32)));
            let slide = Prismatic::along(vector(32)).with(law);
            let cylinder = Cylindrical::on(vector(29)).with(spring, law);
            let arm = (other.with(law), of(1));
            let chain =
                (of(0), Branch(arm), hinge.with(law), of(1), slide, of(0), cylinder, of(1), other.with(spring), of(0));
            let ground =
                Clamped::at([0.0; 3].map(N::constant), Rotation::from_angles([0.2, -0.1, 0.3].map(N::constant)));
            System::new(Hinged::on(ground, vector(29)), chain, $tip).unwrap().with_gravity(vector(26))
        })
    }};
}

/// A place for a tip, near where it is.
fn held<T: Scalar>() -> Pinned<[T; 3]> {
    Pinned::at([1.9, -0.2, 0.6].map(T::literal))
}

/// Without optimisation too much for the stack of a test.
fn in_a_thread(of: fn()) {
    let thread = std::thread::Builder::new().stack_size(1 << 26).spawn(of).expect("a thread");
    thread.join().expect("gradients of jets");
}

#[test]
fn laws_have_the_gradients_of_jets() {
    in_a_thread(|| stiffening!(Sdirk4::new(), 1e2, Free));
}

#[test]
fn laws_of_held_scenes_have_the_gradients_of_jets() {
    in_a_thread(|| {
        stiffening!(Sdirk4::new(), 1e2, held());
        stiffening!(GeneralizedAlpha::new(0.8).with_sweeps(3), 1e2, held());
    });
}
