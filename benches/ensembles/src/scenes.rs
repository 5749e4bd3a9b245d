//! Scenes that are run many at once: one batch of starts by RK4, as many as a number has lanes.

use catena::scalar::{Real, Scalar, WideF32x8, WideF32x16, WideF64x4, WideF64x8};
use catena::{Error, planar, spatial};

/// Steps of a run, and their size (s).
pub const STEPS: usize = 1000;
const STEP: f64 = 1e-3;

/// A number of so many lanes.
pub trait Lanes<const N: usize>: Scalar<Real: Real> {
    fn of(lanes: [f64; N]) -> Self;
    fn lanes(self) -> [f64; N];
}

macro_rules! lanes {
    ($($T:ident of $number:ident, $n:literal: $lanes:expr, $wide:expr;)*) => {$(
        impl Lanes<$n> for $T {
            fn of(lanes: [f64; $n]) -> Self {
                $wide(lanes.map(|lane| lane as $number))
            }
            fn lanes(self) -> [f64; $n] {
                let lanes: [$number; $n] = $lanes(self);
                lanes.map(f64::from)
            }
        }
    )*};
}
lanes! {
    f64 of f64, 1: |x| [x], |[x]: [f64; 1]| x;
    f32 of f32, 1: |x| [x], |[x]: [f32; 1]| x;
    WideF64x4 of f64, 4: WideF64x4::into_arr, WideF64x4::from;
    WideF64x8 of f64, 8: WideF64x8::into_arr, WideF64x8::from;
    WideF32x8 of f32, 8: WideF32x8::into_arr, WideF32x8::from;
    WideF32x16 of f32, 16: WideF32x16::into_arr, WideF32x16::from;
}

/// Runs a scene from starts that differ by these angles (rad), and yields a coordinate at the end of each.
pub type Run<const N: usize> = fn([&f64; N]) -> Result<[f64; N], Error>;

/// Where runs end (s).
fn end<T: Scalar<Real: Real>>() -> (T::Real, T::Real) {
    (T::Real::of(STEP), T::Real::of(STEP * STEPS as f64))
}

/// A double pendulum.
pub fn pendulum<T: Lanes<N>, const N: usize>(angles: [&f64; N]) -> Result<[f64; N], Error> {
    use planar::*;
    let (number, (step, end)) = (T::literal, end::<T>());
    let rod = Rod::uniform(number(0.5), number(0.5));
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(number(9.81));
    let start = scene.at_rest(&[number(0.3), T::of(angles.map(|angle| *angle))])?;
    let (_, ((), last, ())) = *scene.simulate(start, Rk4::step(step), end, |_| ())?.motion.position();
    Ok(last.lanes())
}

/// Twenty rods on pins.
pub fn chain<T: Lanes<N>, const N: usize>(angles: [&f64; N]) -> Result<[f64; N], Error> {
    use planar::*;
    let (number, (step, end)) = (T::literal, end::<T>());
    let rod = Rod::uniform(number(0.05), number(0.05));
    let scene = System::new(Pinned::origin(), (rod, [(Pin, rod); 19]), Free)?.with_gravity(number(9.81));
    let start = scene.at_rest(&[T::of(angles.map(|angle| *angle)); 20])?;
    let (first, _) = *scene.simulate(start, Rk4::step(step), end, |_| ())?.motion.position();
    Ok(first.lanes())
}

/// Three rods between two pins on the ground.
pub fn four_bar<T: Lanes<N>, const N: usize>(angles: [&f64; N]) -> Result<[f64; N], Error> {
    use planar::*;
    let (number, (step, end)) = (T::literal, end::<T>());
    let rod = |length: f64| Rod::uniform(number(length), number(length));
    let chain = (rod(0.5), Pin, rod(1.2), Pin, rod(0.9));
    let scene = System::new(Pinned::origin(), chain, Pinned::at(number(1.0), number(0.0)))?.with_gravity(number(9.81));
    let first = number(1.0) + T::of(angles.map(|angle| 0.2 * angle));
    let start = scene.assembled(scene.at_rest(&[first, number(0.3), number(-2.0)])?, &Unloaded)?;
    let (first, _) = *scene.simulate(start, Rk4::step(step), end, |_| ())?.motion.position();
    Ok(first.lanes())
}

/// Three rods on balls.
pub fn balls<T: Lanes<N>, const N: usize>(angles: [&f64; N]) -> Result<[f64; N], Error> {
    use spatial::*;
    let (number, (step, end)) = (T::literal, end::<T>());
    let rod = Rod::uniform(number(1.0 / 3.0), number(0.03), number(1.0 / 3.0));
    let down = [0.0, -9.81, 0.0].map(number);
    let scene = System::new(Pinned::origin(), (rod, Ball, rod, Ball, rod), Free)?.with_gravity(down);
    let mut turns = [T::zero(); 9];
    turns[2] = T::of(angles.map(|angle| *angle));
    let start = scene.with_rates(scene.at_rest(&turns)?, &[1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0].map(number))?;
    let end = scene.simulate(start, Rk4::step(step), end, |_| ())?.motion;
    Ok(end.coordinates()[0].lanes())
}
