//! Gradients by implicit rules of laws that are not linear, which sweeps read where the last one has led.

use super::names::*;

/// Hinges and a slider under such laws, a hinge with a spring, an arm: stiff and soft, by a rule.
macro_rules! stiffening {
    ($method:expr, $stiffness:expr) => {{
        let (steps, coordinates, joints, stiffness): (_, _, _, f64) = (3, 5, 6, $stiffness);
        let mut noise = Noise::new(29);
        let mut list = vec![1.0, 0.8, 0.35, 0.07, 1.3, 0.2, 0.4, 0.1, 0.8, -0.2, 0.6, 0.9]; // a rod, a rigid body, a bob
        list.extend([stiffness, 0.02 * stiffness, 2.0 * stiffness, 0.01 * stiffness, 0.3]); // a law, a spring
        list.extend([0.4, 9.81]); // a line, gravity
        list.extend((0..coordinates).map(|_| 0.4 * noise.next()));
        list.extend((0..coordinates).map(|_| noise.next()));
        list.extend((0..steps * joints).map(|_| noise.next()));
        let kinds = [
            ("bodies", 12),
            ("laws", 5),
            ("line", 1),
            ("gravity", 1),
            ("coordinates", coordinates),
            ("rates", coordinates),
            ("efforts", steps * joints),
        ];
        gradients!(
            &format!("laws of {stiffness} N·m/rad, {:?}", $method),
            &kinds,
            list,
            [coordinates, joints],
            $method,
            steps,
            0.03,
            |x| {
                let rod = Rod::<N>::new(x(0), x(1), x(2), x(3));
                let rigid = RigidBody::<N>::new(x(4), x(5), [x(6), x(7)], [x(8), x(9)]);
                let bob = PointMass::<N>::new(x(10), x(11));
                let law = Stiffening { stiffness: x(12), damping: x(13) };
                let spring = ElasticHinge::rotary(x(14)).damped(x(15)).resting_at(x(16));
                let piston = Slider::along(x(17)).with(Custom(law));
                let chain = (
                    ElasticHinge::with(law),
                    rod,
                    Branch((spring, bob)),
                    piston,
                    rigid,
                    spring,
                    rod,
                    ElasticHinge::with((law, Spring::new(x(14)))),
                    rigid,
                );
                System::new(Clamped::at(N::constant(0.0), N::constant(0.0), N::constant(0.2)), chain, Free).unwrap().with_gravity(x(18))
            }
        );
    }};
}

#[test]
fn laws_have_the_gradients_of_jets_by_sdirk4() {
    stiffening!(Sdirk4::new(), 10.0);
    stiffening!(Sdirk4::new().with_sweeps(2), 1e3);
}

#[test]
fn laws_have_the_gradients_of_jets_by_generalized_alpha() {
    stiffening!(GeneralizedAlpha::new(0.8).with_sweeps(3), 1e3);
    stiffening!(GeneralizedAlpha::new(0.8).with_sweeps(1), 10.0);
}
