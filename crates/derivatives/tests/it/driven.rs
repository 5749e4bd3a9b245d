//! Gradients of runs with joints that are driven, to tips that are held and around loops, in the plane, backward: against jets
//! through the same steps, projection included, and central differences.

use super::held::share;
use catena::Scalar;
use catena::loading::LoadLaw;
use catena::planar::*;
use catena::scalar::Jet;

/// Around an offset to and fro, and on: b + u t + a sin (ω t + 0.3).
#[derive(Clone, Copy)]
pub struct Swing<T> {
    pub offset: T,
    pub drift: T,
    pub amplitude: T,
    pub frequency: T,
}
catena::lift!(Swing { offset, drift, amplitude, frequency });

impl<T: Scalar<Real = f64>> MotionLaw<T> for Swing<T> {
    fn at(&self, time: f64) -> [T; 3] {
        let Self { offset, drift, amplitude: a, frequency: w } = *self;
        let (sine, cosine) = (w.scale(time) + T::constant(0.3)).sin_cos();
        [offset + drift.scale(time) + a * sine, drift + a * w * cosine, -(a * w * w * sine)]
    }
}

/// Drag in proportion to the velocity of the outboard end (N·s/m), and to the rate.
#[derive(Clone, Copy)]
struct Medium;
catena::lift!(Medium);

impl<T: Scalar<Real = f64>> LoadLaw<BodyMotion<T>> for Medium {
    type Value = Wrench<T>;
    fn at(&self, _: f64, _: usize, body: &BodyMotion<T>) -> Wrench<T> {
        let force = body.outboard().velocity.map(|x| x.scale(-0.7));
        Wrench { force, torque: body.arm.perp(&force) - body.inboard.turn.rate.scale(0.2) }
    }
}

/// A crank that turns a chain to a pin, and a line in it that is driven, too.
#[test]
fn to_a_held_tip() {
    let kinds = [("lengths", 4), ("masses", 4), ("crank", 4), ("line", 5), ("place", 2), ("gravity", 1)];
    let parameters =
        vec![0.5, 0.8, 0.7, 0.9, 1.0, 0.6, 0.8, 0.5, 0.3, 2.0, 0.2, 5.0, 0.4, 0.05, 0.1, 0.08, 6.0, 1.6, 0.2, 9.81];
    macro_rules! of {
        ($method:expr, $steps:expr, $h:expr $(, under $law:expr)?) => {
            gradients!("driven, held", kinds, parameters.clone(), vec![0.9, -0.4, -1.1], 6, $method, $steps, $h, |x| {
                let rod = |i: usize| Rod::<N>::uniform(x(i), x(4 + i));
                let law = |k: usize| Swing { offset: x(k), drift: x(k + 1), amplitude: x(k + 2), frequency: x(k + 3) };
                let crank = Driven::new(Revolute::smooth(), law(8));
                let line = Driven::new(Slider::along(x(12)), law(13));
                let chain = (crank, rod(0), Pin, rod(1), line, rod(2), Pin, rod(3), Pin, rod(1));
                System::new(Clamped::origin(), chain, Pinned::at(x(17), x(18))).unwrap().with_gravity(x(19))
            } $(, under $law)?)
        };
    }
    of!(Rk4, 6, 0.02);
    of!(Dop853, 3, 0.05);
    of!(GeneralizedAlpha::new(0.8).with_sweeps(3), 6, 0.02);
    of!(Sdirk4::new(), 4, 0.02);
    of!(Rk4, 5, 0.02, under Medium);
}

/// A linkage of five bars, one of them a crank, with a spring in its knee and a rod at it.
#[test]
fn around_a_loop() {
    let kinds = [("lengths", 4), ("masses", 4), ("reach", 2), ("crank", 4), ("spring", 3), ("gravity", 1)];
    let parameters = vec![0.5, 1.2, 0.9, 0.6, 0.6, 1.1, 0.8, 0.5, 1.0, 0.1, 1.0, 3.0, 0.2, 5.0, 8.0, 0.2, 0.4, 9.81];
    macro_rules! of {
        ($method:expr, $steps:expr, $h:expr) => {
            gradients!(
                "driven loop",
                kinds,
                parameters.clone(),
                vec![-0.3, 1.1, 0.6, -1.0],
                7,
                $method,
                $steps,
                $h,
                |x| {
                    let rod = |i: usize| Rod::<N>::uniform(x(i), x(4 + i));
                    let law = Swing { offset: x(10), drift: x(11), amplitude: x(12), frequency: x(13) };
                    let reach = RigidBody::<N>::massless([x(8), x(9)]);
                    let knee = ElasticHinge::rotary(x(14)).damped(x(15)).resting_at(x(16));
                    let main = (Driven::new(Revolute::smooth(), law), rod(0), knee, rod(1));
                    let net = Network::new(main, (reach, Pin, rod(2), Pin, rod(3)), Pin);
                    System::new(Clamped::origin(), (net, Pin, rod(3)), Free).unwrap().with_gravity(x(17))
                }
            )
        };
    }
    of!(Rk4, 6, 0.02);
    of!(Dopri5, 4, 0.03);
    of!(GeneralizedAlpha::new(0.8), 6, 0.02);
    of!(Sdirk4::new(), 4, 0.02);
}
