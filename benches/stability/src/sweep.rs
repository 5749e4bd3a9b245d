//! One sweep (accelerations of all coordinates) in `f64` and `f32` against the same sweep in double-double arithmetic.
//!
//! Base scenes: 20 rods of 0.05 m and 0.05 kg, folded, turning at about 1 rad/s, on pins, on springs of 20 N·m/rad, on pins with a held
//! tip, on balls, and bodies on revolute joints. Errors are shares of the largest acceleration.

use crate::table::Table;
use crate::twice::Twice;
use catena::{Scalar, planar, spatial};

/// What is varied.
#[derive(Clone, Copy)]
struct Chain {
    bodies: usize,
    stiffness: f64,
    /// Mass of every other body, as a multiple of that of its neighbours.
    mass: f64,
    /// Length of every other body, as a multiple of that of its neighbours.
    share: f64,
    /// Length of the chain (m).
    length: f64,
    /// Rates (rad/s).
    rate: f64,
}

const BASE: Chain = Chain { bodies: 20, stiffness: 20.0, mass: 1.0, share: 1.0, length: 1.0, rate: 1.0 };

type Found = Result<Vec<f64>, String>;

/// A number with the digits of `f32`, so that all scalars sweep the same scene.
fn number<T: Scalar>(x: f64) -> T {
    T::literal(f64::from(x as f32))
}

fn say(error: catena::Error) -> String {
    error.to_string()
}

fn list<T: Scalar>(accelerations: Vec<T>) -> Vec<f64> {
    use catena::Real;
    accelerations.into_iter().map(|x| x.real().as_f64()).collect()
}

impl Chain {
    /// Length and mass of a body.
    fn body<T: Scalar>(&self, k: usize) -> (T, T) {
        let n = self.bodies as f64;
        let other = |share: f64| if k % 2 == 1 { share } else { 1.0 };
        (number(self.length / n * other(self.share)), number(other(self.mass) / n))
    }
    fn angles<T: Scalar>(&self) -> Vec<T> {
        (0..self.bodies).map(|k| number(-0.3 + 0.5 * (k as f64).sin())).collect()
    }
    fn rates<T: Scalar>(&self, count: usize) -> Vec<T> {
        (0..count).map(|k| number(self.rate * (k as f64).cos())).collect()
    }
}

/// A planar chain of rods on joints that are all alike.
macro_rules! planar {
    ($name:ident, |$chain:ident| $joint:expr, $tip:expr) => {
        fn $name<T: Scalar>($chain: Chain) -> Found {
            use planar::*;
            let rod = |k| {
                let (length, mass) = $chain.body::<T>(k);
                Rod::uniform(length, mass)
            };
            let links: Vec<_> = (1..$chain.bodies).map(|k| ($joint, rod(k))).collect();
            let scene =
                System::new(Pinned::origin(), (rod(0), links), $tip).map_err(say)?.with_gravity(number::<T>(9.81));
            let start = scene.at_rest(&$chain.angles()).map_err(say)?;
            let start = scene.with_rates(start, &$chain.rates($chain.bodies)).map_err(say)?;
            Ok(list(scene.with_accelerations(start, &Unloaded).map_err(say)?.accelerations()))
        }
    };
}
planar!(pins, |chain| Pin, Free);
planar!(springs, |chain| ElasticHinge::rotary(number::<T>(chain.stiffness)), Free);
// Where the tip is does not enter: accelerations are asked for at a motion, not closed.
planar!(held, |chain| Pin, Pinned::at(number::<T>(0.9 * chain.length), number::<T>(0.0)));

fn balls<T: Scalar>(chain: Chain) -> Found {
    use spatial::*;
    let rod = |k| {
        let (length, mass) = chain.body::<T>(k);
        Rod::uniform(length, length * number::<T>(0.1), mass)
    };
    let links: Vec<_> = (1..chain.bodies).map(|k| (Ball, rod(k))).collect();
    let scene = System::new(Pinned::origin(), (rod(0), links), Free).map_err(say)?;
    let scene = scene.with_gravity([number::<T>(0.0), number(0.0), number(-9.81)]);
    let angles: Vec<T> = (0..3 * chain.bodies).map(|k| number(0.5 * (k as f64).sin())).collect();
    let start = scene.at_rest(&angles).map_err(say)?;
    let start = scene.with_rates(start, &chain.rates(3 * chain.bodies)).map_err(say)?;
    Ok(list(scene.with_accelerations(start, &Unloaded).map_err(say)?.accelerations()))
}

fn revolutes<T: Scalar>(chain: Chain) -> Found {
    use spatial::*;
    let joint = |k: usize| {
        let axes = [[1.0, 0.2, 0.0], [0.0, 1.0, 0.3], [0.2, 0.0, 1.0]];
        Revolute::about(axes[k % 3].map(number::<T>))
    };
    let body = |k| {
        let (length, mass) = chain.body::<T>(k);
        let square = mass * length * length;
        let own = |share: f64| square * number::<T>(share);
        let tensor =
            [[own(0.1), own(0.01), own(0.02)], [own(0.01), own(0.2), own(0.0)], [own(0.02), own(0.0), own(0.25)]];
        let at = |share: f64| length * number::<T>(share);
        RigidBody::new(mass, tensor, [at(0.4), at(0.1), at(0.0)], [at(1.0), at(0.0), at(0.2)])
    };
    let links: Vec<_> = (0..chain.bodies).map(|k| (joint(k), body(k))).collect();
    let scene = System::new(Clamped::origin(), links, Free).map_err(say)?;
    let scene = scene.with_gravity([number::<T>(0.0), number(0.0), number(-9.81)]);
    let start = scene.at_rest(&chain.angles()).map_err(say)?;
    let start = scene.with_rates(start, &chain.rates(chain.bodies)).map_err(say)?;
    Ok(list(scene.with_accelerations(start, &Unloaded).map_err(say)?.accelerations()))
}

/// A scene over three scalars.
struct Scene {
    name: &'static str,
    double: fn(Chain) -> Found,
    single: fn(Chain) -> Found,
    exact: fn(Chain) -> Found,
}

const SCENES: [Scene; 5] = [
    Scene { name: "pins", double: pins::<f64>, single: pins::<f32>, exact: pins::<Twice> },
    Scene { name: "springs", double: springs::<f64>, single: springs::<f32>, exact: springs::<Twice> },
    Scene { name: "pins, tip held", double: held::<f64>, single: held::<f32>, exact: held::<Twice> },
    Scene { name: "balls", double: balls::<f64>, single: balls::<f32>, exact: balls::<Twice> },
    Scene { name: "revolutes", double: revolutes::<f64>, single: revolutes::<f32>, exact: revolutes::<Twice> },
];

fn error(found: Found, exact: &Found) -> Result<f64, String> {
    let (found, exact) = (found?, exact.as_ref().map_err(|text| format!("no reference: {text}"))?);
    if found.iter().any(|x| !x.is_finite()) {
        return Err("not finite, and no error returned".to_owned());
    }
    let size = exact.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    Ok(found.iter().zip(exact).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs())) / size)
}

pub fn run(table: &mut Table, quick: bool) {
    for scene in &SCENES {
        let mut case = |axis: &'static str, value: f64, chain: Chain| {
            crate::progress(&format!("sweep of {}, {axis} {value:.0e}", scene.name));
            let exact = (scene.exact)(chain);
            table.add("sweep", scene.name, axis, value, "a sweep", "f64", error((scene.double)(chain), &exact));
            table.add("sweep", scene.name, axis, value, "a sweep", "f32", error((scene.single)(chain), &exact));
        };
        let most = if quick { 1000.0 } else { 1e6 };
        for bodies in [2.0, 5.0, 20.0, 100.0, 1e3, 1e4, 1e5, 1e6].into_iter().filter(|n| *n <= most) {
            case("bodies", bodies, Chain { bodies: bodies as usize, ..BASE });
        }
        for mass in [1e-12, 1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9, 1e12] {
            case("mass of every other body", mass, Chain { mass, ..BASE });
        }
        for share in [1e-6, 1e-3, 1.0, 1e3, 1e6] {
            case("length of every other body", share, Chain { share, ..BASE });
        }
        for length in [1e-6, 1e-3, 1.0, 1e3, 1e6] {
            case("length (m)", length, Chain { length, ..BASE });
        }
        for rate in [1.0, 1e2, 1e4, 1e6] {
            case("rate (rad/s)", rate, Chain { rate, ..BASE });
        }
        if scene.name == "springs" {
            for stiffness in [1.0, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14] {
                case("stiffness (N·m/rad)", stiffness, Chain { stiffness, ..BASE });
            }
        }
    }
}
