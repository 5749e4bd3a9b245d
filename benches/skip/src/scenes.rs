//! A general scene, the same with each feature absent, and pairs: a type that could have a feature and does not, beside one that cannot.

use crate::by_hand;
use crate::case::{Bytes, Case, Row, Run, Swept, row, run_row};
use catena::Error;
use catena::planar::*;

/// Bodies of the chains in pairs.
const N: usize = 20;
const GRAVITY: f64 = 9.81;

fn rod() -> Rod<f64> {
    Rod::uniform(1.0 / N as f64, 1.0 / N as f64)
}

/// A body whose mass centre is beside the line between its ends.
fn plate() -> RigidBody<f64> {
    let h = 1.0 / N as f64;
    RigidBody::new(h, 0.1 * h * h * h, [0.4 * h, 0.1 * h], [0.8 * h, -0.3 * h])
}

/// A spring's law that has a stiffness and cannot have anything else.
#[derive(Clone, Copy, Debug)]
struct Only(f64);

impl SpringLaw<f64> for Only {
    const LINEAR: bool = true;
    #[inline(always)]
    fn force(&self, position: f64, _: f64) -> f64 {
        -(self.0 * position)
    }
    fn energy(&self, position: f64) -> f64 {
        0.5 * self.0 * position * position
    }
    #[inline(always)]
    fn pivot(&self, _: f64, _: f64, springs: impl Springs<f64>) -> f64 {
        springs.pivot(self.0, 0.0)
    }
    fn check(&self) -> Result<(), catena::Fault> {
        Ok(())
    }
}

/// Forces on bodies that follow their motion, and torques in joints.
macro_rules! loads {
    (none) => {
        Unloaded
    };
    (bodies) => {
        Loads::none().on_bodies(|_, _, motion: &BodyMotion<f64>| {
            let velocity = motion.outboard().velocity;
            motion.force_at(motion.inertia.centre, [-0.02 * velocity.x, -0.02 * velocity.y])
        })
    };
    (joints) => {
        Loads::none().in_joints(|_, _, motion: &JointMotion<f64>| -0.02 * motion.rate())
    };
    (both) => {
        loads!(bodies).in_joints(|_, _, motion: &JointMotion<f64>| -0.02 * motion.rate())
    };
}

/// The general scene: eighteen links, an arm, a loop, a held tip, loads.
pub fn general() -> Vec<Row> {
    macro_rules! scenes {
        ($($name:literal: $hinge:expr, $body:expr, $arm:expr, $loop:expr, $tip:expr, $loads:ident;)*) => {
            vec![$(row("general scene", $name, move || {
                let (hinge, body) = ($hinge, $body);
                let links = [(hinge, body); 9];
                let chain = (links, $arm, links, $loop);
                let scene = System::new(Clamped::at(0.0, 0.0, 0.0), chain, $tip)?.with_gravity(GRAVITY);
                Ok(Box::new(Swept::new(scene, loads!($loads))))
            })),*]
        };
    }
    let hinge = move || ElasticHinge::rotary(0.5).damped(0.01).resting_at(0.1);
    let arm = move || (Branch((Pin, plate())), Pin, plate());
    let side = move || (Pin, plate(), Pin, plate());
    let closed = move || Network::new(side(), side(), Pin);
    let held = move || Pinned::at(0.5, 0.0);
    scenes! {
        "all": hinge(), plate(), arm(), closed(), held(), both;
        "no rest angle": ElasticHinge::rotary(0.5).damped(0.01), plate(), arm(), closed(), held(), both;
        "no damping": ElasticHinge::rotary(0.5).resting_at(0.1), plate(), arm(), closed(), held(), both;
        "no springs": Pin, plate(), arm(), closed(), held(), both;
        "no centre off the axis": hinge(), rod(), arm(), closed(), held(), both;
        "no loads on bodies": hinge(), plate(), arm(), closed(), held(), joints;
        "no torques": hinge(), plate(), arm(), closed(), held(), bodies;
        "no loads at all": hinge(), plate(), arm(), closed(), held(), none;
        "no held tip": hinge(), plate(), arm(), closed(), Free, both;
        "no arm": hinge(), plate(), (Pin, plate()), closed(), held(), both;
        "no loop": hinge(), plate(), arm(), (side(), side()), held(), both;
    }
}

/// Pairs of chains of twenty links: a type that does without a feature, and one that cannot have it.
pub fn pairs() -> Vec<[Row; 2]> {
    macro_rules! chain {
        ($feature:literal, $name:literal, $link:expr, $loads:expr) => {
            row($feature, $name, move || {
                let scene = System::new(Clamped::at(0.0, 0.0, 0.0), $link, Free)?.with_gravity(GRAVITY);
                Ok(Box::new(Swept::new(scene, $loads)))
            })
        };
    }
    vec![
        [
            chain!("dampers, rest values", "spring", [(ElasticHinge::rotary(0.5), rod()); N], Unloaded),
            chain!("dampers, rest values", "law of a stiffness", [(ElasticHinge::with(Only(0.5)), rod()); N], Unloaded),
        ],
        [
            chain!("springs (a relative angle is left)", "hinge", [(Revolute::smooth(), rod()); N], Unloaded),
            chain!("springs (a relative angle is left)", "pin", [(Pin, rod()); N], Unloaded),
        ],
        [
            chain!("loads", "Loads::none()", [(Pin, rod()); N], Loads::none()),
            chain!("loads", "Unloaded", [(Pin, rod()); N], Unloaded),
        ],
        [
            chain!("names", "named", [(Pin.named("elbow"), rod().named("bone")); N], Unloaded),
            chain!("names", "without", [(Pin, rod()); N], Unloaded),
        ],
        [
            run_row("observers, events, output", "a run", Run::Simulated),
            run_row("observers, events, output", "a stepper", Run::Stepped),
        ],
    ]
}

/// Furniture of a robot's joints, on an arm of seven: laws that are none beside none, and reflected inertia beside none, which two instructions a joint
/// may tell apart.
pub fn furniture() -> Vec<[Row; 2]> {
    use catena::robot::{Free, Hinge, Link, Quarter, System};
    macro_rules! arm {
        ($feature:literal, $name:literal, |$hinge:ident| $furnished:expr) => {
            row($feature, $name, || {
                let tensor = [[0.05, 0.002, 0.001], [0.002, 0.04, 0.003], [0.001, 0.003, 0.02]];
                let link = Link::<f64>::general(1.3, [0.02, -0.03, 0.2], tensor);
                let $hinge = Hinge::at::<0b100>([0.0, 0.0, 0.4]).turned(Quarter::<30>);
                let joint = $furnished;
                let chain = [(joint, link); 7];
                let scene = System::new(catena::robot::Base::origin(), chain, Free)?.with_gravity([0.0, 0.0, -GRAVITY]);
                Ok(Box::new(Swept::new(scene, Unloaded)))
            })
        };
    }
    vec![
        [
            arm!("laws of a robot's joint", "laws that are none", |hinge| hinge.with((Spring::none(), Spring::none()))),
            arm!("laws of a robot's joint", "none", |hinge| hinge),
        ],
        [
            arm!("armature (left in the first)", "geared", |hinge| hinge.geared(0.02)),
            arm!("armature (left in the first)", "no armature", |hinge| hinge),
        ],
    ]
}

struct Plain;
impl by_hand::Scene for Plain {}
struct OffAxis;
impl by_hand::Scene for OffAxis {
    const OFF_AXIS: bool = true;
}

impl<S: by_hand::Scene> Case for by_hand::Chain<S, [f64; N]> {
    fn sweep(&mut self, times: usize) {
        for _ in 0..times {
            std::hint::black_box(&mut *self).sweep();
        }
    }
    fn bodies(&self) -> usize {
        N
    }
    fn bytes(&self) -> Option<Bytes> {
        None
    }
}

fn by_hand_chain<S: by_hand::Scene>() -> by_hand::Chain<S, [f64; N]> {
    let mut chain = by_hand::Chain::new(&[0.0; N]);
    let share = 1.0 / N as f64;
    // A rod is half its mass at either end, and −1/6 of that for its inertia.
    chain.gravity = GRAVITY;
    chain.length = [share; N];
    chain.mass = [share; N];
    chain.tip = 0.5 * share;
    chain.inertia = [-share * share * share / 6.0; N];
    chain.beside = [0.1 * share; N];
    for (i, (angle, rate)) in chain.angle.iter_mut().zip(&mut chain.rate).enumerate() {
        (*angle, *rate) = (-0.3 + 0.5 * (i as f64).sin(), 0.5 * (i as f64).cos());
    }
    chain
}

/// The least by hand, and chains of rods and of general bodies with a free tip that nothing is loaded by: no springs, no
/// closures, no arms, no loads.
pub fn least() -> Vec<[Row; 2]> {
    macro_rules! chain {
        ($name:literal, $body:expr, $Hand:ident) => {
            [
                row("all of these", $name, || {
                    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), [(Pin, $body); N], Free)?;
                    Ok(Box::new(Swept::new(scene.with_gravity(GRAVITY), Unloaded)))
                }),
                row("all of these", concat!($name, " by hand"), || Ok(Box::new(by_hand_chain::<$Hand>()))),
            ]
        };
    }
    vec![chain!("rods", rod(), Plain), chain!("general bodies", plate(), OffAxis)]
}

/// Steps of a run and of a bare stepper: twenty rods by RK4, nothing observed.
pub fn steps(how: Run, times: usize) -> Result<(), Error> {
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), [(Pin, rod()); N], Free)?.with_gravity(GRAVITY);
    let start = scene.with_accelerations(scene.at_rest(&[-0.3; N])?, &Unloaded)?;
    crate::case::steps(&scene, start, how, times)
}
