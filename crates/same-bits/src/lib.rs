//! Hashes of the motions of six scenes, whose bits feature `reproducible` makes the same on every machine.
//!
//! Motions are such that a last digit that differs is soon another motion: chains that tumble, loops that close, laws that call
//! elementary functions, steps chosen by error control.

use catena::loading::Loading;
use catena::simulate::{Method, Stepper};
use catena::system::{Element, MotionOf, Root, Runs, Space, System, Tip};
use catena::{Error, Scalar, planar, spatial};

/// Names of the scenes.
pub const NAMES: [&str; 6] = [
    "2 rods on pins, DOP853",
    "20 rods on damped springs, generalised-alpha",
    "four-bar, DOPRI5",
    "network of pins, RK4",
    "3 rods on balls, DOP853",
    "arm with dry friction, Vcabm",
];

/// Hashes of the scenes after a number of steps, by plain numbers.
///
/// # Errors
/// Those of scenes and steps.
pub fn hashes(steps: usize) -> Result<[u64; 6], Error> {
    Ok(all::<f64>(steps)?.map(|lanes| lanes[0]))
}

/// Hashes of the same by lanes of a number, each of which runs the same motion.
///
/// # Errors
/// Those of scenes and steps.
#[cfg(feature = "lanes")]
pub fn hashes_in_lanes(steps: usize) -> Result<[[u64; 4]; 6], Error> {
    Ok(all::<catena::scalar::WideF64x4>(steps)?.map(|lanes| [0, 1, 2, 3].map(|lane| lanes[lane])))
}

/// A run under error control, whose steps depend on powers and roots.
///
/// # Errors
/// Those of scenes and steps.
pub fn controlled(end: f64) -> Result<u64, Error> {
    use planar::*;
    let rod = Rod::uniform(0.5, 0.5);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let mut hash = Hash::new();
    for tolerance in [1e-6, 1e-11] {
        let run = scene.simulate(scene.at_rest(&[0.3, 1.0])?, Dop853::tolerance(tolerance), end, |_| ())?;
        run.motion.coordinates().iter().for_each(|x| hash.add(*x));
        let run = scene.simulate(scene.at_rest(&[0.3, 1.0])?, Vcabm::default().tolerance(tolerance), end, |_| ())?;
        run.motion.coordinates().iter().for_each(|x| hash.add(*x));
    }
    Ok(hash.0)
}

/// A number of one lane or several.
pub trait Lanes: Scalar<Real = f64> {
    fn lanes(self) -> Vec<f64>;
}

impl Lanes for f64 {
    fn lanes(self) -> Vec<f64> {
        vec![self]
    }
}

#[cfg(feature = "lanes")]
impl Lanes for catena::scalar::WideF64x4 {
    fn lanes(self) -> Vec<f64> {
        self.into_arr().into()
    }
}

/// FNV-1a of 64 bits.
struct Hash(u64);

impl Hash {
    fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
    fn add(&mut self, number: f64) {
        for byte in number.to_bits().to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

/// Steps a scene and hashes its coordinates and rates, a hundred times on the way and at the end, lane by lane.
fn run<T, S, R, C, P, L, M>(
    scene: &System<S, R, C, P>,
    start: MotionOf<S, R, C, P>,
    loads: &L,
    method: M,
    dt: f64,
    steps: usize,
) -> Result<Vec<u64>, Error>
where
    T: Lanes,
    S: Space<Scalar = T>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    L: Loading<S>,
    System<S, R, C, P>: Runs<L, S, R, C, P>,
    M: for<'s> Method<&'s System<S, R, C, P>, L>,
{
    let mut stepper = method.stepper(scene);
    let (mut now, mut next) = (start.clone(), start);
    let mut hashes: Vec<Hash> = T::zero().lanes().iter().map(|_| Hash::new()).collect();
    for step in 1..=steps {
        stepper.step(&now, loads, dt, &mut next)?;
        core::mem::swap(&mut now, &mut next);
        if step % (steps / 100).max(1) == 0 || step == steps {
            for number in now.coordinates().into_iter().chain(now.rates()) {
                hashes.iter_mut().zip(number.lanes()).for_each(|(hash, lane)| hash.add(lane));
            }
        }
    }
    Ok(hashes.into_iter().map(|hash| hash.0).collect())
}

fn all<T: Lanes>(steps: usize) -> Result<[Vec<u64>; 6], Error> {
    let [a, b, c, d] = plane::<T>(steps)?;
    let [e, f] = space::<T>(steps)?;
    Ok([a, b, c, d, e, f])
}

fn numbers<T: Scalar, const N: usize>(list: [f64; N]) -> [T; N] {
    list.map(T::literal)
}

fn plane<T: Lanes>(steps: usize) -> Result<[Vec<u64>; 4], Error> {
    use planar::*;
    let number = T::literal;
    let rod = |length: f64| Rod::uniform(number(length), number(length));
    let gravity = number(9.81);

    let scene = System::new(Pinned::origin(), (rod(0.5), Pin, rod(0.5)), Free)?.with_gravity(gravity);
    let start = scene.at_rest(&numbers::<T, 2>([0.3, 1.0]))?;
    let pins = run::<T, _, _, _, _, _, _>(&scene, start, &Unloaded, Dop853, 5e-3, steps)?;

    let spring = ElasticHinge::rotary(number(2.0)).damped(number(1e-4));
    let scene = System::new(Pinned::origin(), (rod(0.05), [(spring, rod(0.05)); 19]), Free)?.with_gravity(gravity);
    let start = scene.at_rest(&numbers::<T, 20>([0.5; 20]))?;
    let springs = run::<T, _, _, _, _, _, _>(&scene, start, &Unloaded, GeneralizedAlpha::new(0.9), 1e-3, steps / 4)?;

    let chain = (rod(0.5), Pin, rod(1.2), Pin, rod(0.9));
    let scene = System::new(Pinned::origin(), chain, Pinned::at(number(1.0), number(0.0)))?.with_gravity(gravity);
    let start = scene.assembled(scene.at_rest(&numbers::<T, 3>([1.0, 0.3, -2.0]))?, &Unloaded)?;
    let bars = run::<T, _, _, _, _, _, _>(&scene, start, &Unloaded, Dopri5, 2e-3, steps)?;

    let arm = || (Pin, rod(0.5), Pin, rod(0.5));
    let chain = (rod(0.4), Network::new(arm(), arm(), Pin), Pin, rod(0.4));
    let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(gravity);
    let start = scene.at_rest(&numbers::<T, 6>([-1.0, -0.6, -1.9, -1.9, -0.6, -1.0]))?;
    let start = scene.assembled(start, &Unloaded)?;
    let network = run::<T, _, _, _, _, _, _>(&scene, start, &Unloaded, Rk4, 1e-3, steps)?;
    Ok([pins, springs, bars, network])
}

fn space<T: Lanes>(steps: usize) -> Result<[Vec<u64>; 2], Error> {
    use spatial::*;
    let number = T::literal;
    let down = numbers::<T, 3>([0.0, 0.0, -9.81]);
    let rod = Rod::uniform(number(0.5), number(0.05), number(0.5));

    let scene = System::new(Pinned::origin(), (rod, [(Ball, rod); 2]), Free)?.with_gravity(down);
    let start = scene.at_rest(&numbers::<T, 9>([0.0, 0.5, 0.0, 0.0, 0.8, 0.3, 0.0, 0.2, 0.9]))?;
    let start = scene.with_rates(start, &numbers::<T, 9>([1.0, 2.0, 0.5, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]))?;
    let balls = run::<T, _, _, _, _, _, _>(&scene, start, &Unloaded, Dop853, 2e-3, steps)?;

    let joint = |axis: [f64; 3]| Revolute::about(numbers::<T, 3>(axis));
    let chain = (
        (joint([0.0, 0.0, 1.0]), rod, joint([0.0, 1.0, 0.0]), rod),
        (joint([1.0, 0.0, 0.0]), rod, joint([0.0, 1.0, 0.2]), rod),
    );
    let scene = System::new(Clamped::origin(), chain, Free)?.with_gravity(down);
    let start = scene.at_rest(&numbers::<T, 4>([0.3, -0.5, 0.8, 1.0]))?;
    // A sign without a jump, a spring that hardens, a drive that fades.
    let loads = Loads::none().in_joints(move |time: f64, _, joint: &JointMotion<T>| {
        let (rate, angle) = (joint.rate[0], joint.position[0]);
        let friction = (rate * number(50.0)).tanh() * number(-0.02);
        let spring = angle.atan2(number(2.0)) * number(-0.5);
        Effort([friction + spring + number(-0.1 * time).exp() * number(0.3), T::zero(), T::zero()])
    });
    let arm = run::<T, _, _, _, _, _, _>(&scene, start, &loads, Vcabm::default(), 1e-3, steps)?;
    Ok([balls, arm])
}
