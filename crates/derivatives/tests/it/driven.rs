//! Gradients of runs with joints that are driven, to tips that are held and around loops, in the plane, backward: against jets
//! through the same steps, projection included, and central differences.

use super::held::share;
use catena::loading::LoadLaw;
use catena::planar::*;
use catena::scalar::Jet;
use catena::{Error, Fault, Scalar};

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

/// A pivot that rises over a bump, for an eighth of the run.
#[derive(Clone, Copy)]
struct Bump<T> {
    height: T,
}
catena::lift!(Bump { height });

impl<T: Scalar<Real = f64>> Ground<T, GroundMotion<T>> for Bump<T> {
    fn at(&self, time: f64) -> GroundMotion<T> {
        let (zero, width, h) = (T::literal(0.0), 0.12, self.height);
        let s = ((time - 0.48) / width).clamp(0.0, 1.0);
        let r = 1.0 - s;
        let [y, v, a] = [s * r, 3.0 * (r - s), 6.0 * (r * r - 3.0 * s * r + s * s)].map(|x| 64.0 * x);
        let (y, v, a) = (y * (s * r).powi(2), v * (s * r).powi(2) / width, a * s * r / (width * width));
        GroundMotion { place: [zero, h.scale(y)], velocity: [zero, h.scale(v)], acceleration: [zero, h.scale(a)] }
    }
}

/// What moves the ground for a part of the run alone is noticed, and refused where a gradient is asked for along it.
#[test]
fn ground_that_moves_for_a_while_is_noticed() -> Result<(), Error> {
    macro_rules! pendulum {
        ($height:expr, $number:expr) => {{
            let rod = Rod::uniform($number(0.5), $number(1.0));
            System::new(Pinned::on(Bump { height: $height }), (rod, Pin, rod), Free)?.with_gravity($number(9.81))
        }};
    }
    let scene = pendulum!(0.02, |x: f64| x);
    let start = scene.at_rest(&[-1.2, -0.7])?;
    let (mut backward, mut states) = (scene.backward(Rk4), vec![start; 1001]);
    backward.run(&start, 1e-3, 1000, &[], &mut states)?;
    let gradient =
        backward.gradient(
            &[],
            &states,
            &mut [],
            |step, _, by| {
                if step == 1000 { by.add(&[1.0, 0.0], &[0.0; 2]) } else { Ok(()) }
            },
        )?;
    let refused = gradient.along(&pendulum!(Jet::<f64, 1>::seed(0.02, 0), Jet::of)).map_err(|error| error.fault);
    assert!(matches!(refused, Err(Fault::Unsupported { what }) if what.contains("moves the ground")), "{refused:?}");
    let [by_gravity] =
        gradient.along(&pendulum!(Jet::<f64, 1>::of(0.02), |x| Jet::<f64, 1>::seed(x, usize::from(x < 9.0))))?;
    assert!(by_gravity.is_finite() && by_gravity != 0.0);
    Ok(())
}
