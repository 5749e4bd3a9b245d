//! Gradients of runs of robots with hinges and slides that are driven, backward.

use super::driven::Swing;
use super::held::share;
use super::robots::{KINDS, Medium, numbers, on_a_large_stack};
use catena::Scalar;
use catena::robot::*;
use catena::scalar::Jet;

/// Beside those of an arm, numbers of the laws of a hinge and of a slide.
const LAWS: [f64; 8] = [0.4, -0.7, 0.5, 3.1, 0.1, 0.2, 0.3, 4.0];

#[test]
fn driven_arms() {
    on_a_large_stack(arm);
}

/// Driven hinges at the root and in an arm, a driven slide; hinges and slides of all kinds of offsets between them.
fn arm() {
    let mut parameters = numbers();
    parameters.extend(LAWS);
    let kinds = [&KINDS[..], &[("laws", 8)]].concat();
    macro_rules! by {
        ($name:expr, $method:expr, $steps:expr $(, under $law:expr)?) => {
            gradients!(super::robots::efforts, $name, kinds, parameters.clone(), vec![0.3, -0.4, 0.5, 0.2], 8, $method, $steps, 0.01, |x| {
                of!(x, |link, other, at, turned, spring| {
                    let law = |k: usize| Swing { offset: x(k), drift: x(k + 1), amplitude: x(k + 2), frequency: x(k + 3) };
                    let crank = Driven::new(Hinge::at::<0b101>(at[2]).turned(turned.1).geared(x(34)), law(38));
                    let line = Driven::new(Slide::at::<0b10>(at[1]).turned(turned.0), law(42));
                    let branch = (crank, other.1, Slide::at::<7>(at[0]).with(spring).geared(x(33)), link);
                    let chain = (
                        Driven::new(Hinge::level().grounded(), law(38)),
                        link,
                        Hinge::at::<7>(at[0]).turned(turned.0).with(spring),
                        other.1,
                        Branch(branch),
                        line,
                        link,
                        Hinge::at::<7>(at[0]).turned(Quarter::<1>),
                        other.0,
                        Hinge::at::<7>(at[0]),
                        link,
                    );
                    System::new(Base::at([0.0, 0.1, 0.2].map(N::constant)), chain, Free).unwrap()
                })
            } $(, under $law)?);
        };
    }
    by!("driven arm, RK4", Rk4, 4);
    by!("driven arm, generalised-α", GeneralizedAlpha::new(0.8), 3);
    by!("driven arm in a medium, RK4", Rk4, 4, under Medium);
}
