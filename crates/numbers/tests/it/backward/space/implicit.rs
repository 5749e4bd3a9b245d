//! Trees on revolute joints with springs and dampers, by rules whose pivots know these.

use super::*;

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
