//! Bent chains of rods that the tests of this directory share.

use catena::planar::*;

/// One rod: length (m), mass (kg), angle (rad), rate (rad/s).
#[derive(Clone, Copy, Debug)]
pub struct Link {
    pub length: f64,
    pub mass: f64,
    pub angle: f64,
    pub rate: f64,
}

impl Link {
    /// Moment of inertia of a uniform rod about its mass centre.
    pub fn inertia(&self) -> f64 {
        self.mass * self.length * self.length / 12.0
    }
}

/// A bent chain of n different rods in motion.
pub fn bent(n: usize) -> Vec<Link> {
    let link = |k: usize| Link {
        length: 0.5 + 0.1 * (k % 5) as f64,
        mass: 1.0 + 0.3 * (k % 3) as f64,
        angle: 0.4 + 1.1 * (1.7 * k as f64).sin(),
        rate: 0.8 * (2.3 * k as f64).cos(),
    };
    (0..n).map(link).collect()
}

/// The rods joined by pins.
pub fn rods(links: &[Link]) -> (Rod<f64>, Vec<(Pin, Rod<f64>)>) {
    let make = |link: &Link| Rod::uniform(link.length, link.mass);
    (make(&links[0]), links[1..].iter().map(|link| (Pin, make(link))).collect())
}

/// Angles of links.
pub fn angles(links: &[Link]) -> Vec<f64> {
    links.iter().map(|link| link.angle).collect()
}

/// Rates of links.
pub fn rates(links: &[Link]) -> Vec<f64> {
    links.iter().map(|link| link.rate).collect()
}

/// How an end of the chain is held. A clamp and a guide keep the angle of their body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum End {
    Pinned,
    Clamped,
    /// On a line in this direction (rad) from the axes of the body.
    Guided(f64),
}

/// Motion of the ground at the tip, which does not turn: velocity and acceleration.
pub const DRIFT: [[f64; 2]; 2] = [[0.3, 0.5], [-0.7, 0.4]];
/// Where on its line a guided root is (m), and its rate (m/s).
pub const ON_LINE: [f64; 2] = [0.4, 1.3];

/// The links, held as these ends say, as they may be: a body that is held does not turn.
pub fn held(n: usize, [root, tip]: [End; 2]) -> Vec<Link> {
    let mut links = bent(n);
    if root != End::Pinned {
        links[0].rate = 0.0;
    }
    if tip != End::Pinned {
        links[n - 1].rate = 0.0;
    }
    links
}

/// The ground under the tip, moving; where on the ground does not matter to accelerations.
pub fn drifting() -> Moving<fn(f64) -> GroundMotion<f64>> {
    Moving(|_| GroundMotion { place: [0.0; 2], velocity: DRIFT[0], acceleration: DRIFT[1] })
}

/// Builds the scene of links between two ends, and its motion with accelerations; then does something with both.
macro_rules! between {
    ($ends:expr, $links:expr, |$scene:ident, $motion:ident| $what:expr) => {{
        use super::chains::{End, ON_LINE, angles, drifting, rates, rods};
        use catena::loading::Unloaded;
        let (links, last) = ($links, $links[$links.len() - 1].angle);
        let first = links[0].angle;
        let (chain, angles, rates) = (rods(links), angles(links), rates(links));
        macro_rules! with_tip {
            ($root:expr, $from:expr, $place:expr, |$motion_of:ident| $rates:expr) => {{
                macro_rules! run {
                    ($tip:expr) => {{
                        let $scene = System::new($root, chain.clone(), $tip)?.with_gravity(9.81);
                        #[allow(unused_mut)]
                        let mut $motion_of = $scene.at_rest(&angles[$from..])?;
                        $place;
                        let $motion = $scene.with_accelerations($scene.with_rates($motion_of, &$rates)?, &Unloaded)?;
                        $what
                    }};
                }
                match $ends[1] {
                    End::Pinned => run!(Pinned::on(drifting())),
                    End::Clamped => run!(Clamped { place: drifting(), attitude: last }),
                    End::Guided(line) => run!(Guided::on(Clamped { place: drifting(), attitude: last }, line)),
                }
            }};
        }
        match $ends[0] {
            End::Pinned => with_tip!(Pinned::origin(), 0, (), |start| rates),
            End::Clamped => with_tip!(Clamped::at(0.0, 0.0, first), 1, (), |start| rates[1..]),
            End::Guided(line) => {
                let along = [&[ON_LINE[1]], &rates[1..]].concat();
                with_tip!(
                    Guided::on(Clamped::at(0.0, 0.0, first), line),
                    1,
                    start.position_mut().0 = ON_LINE[0],
                    |start| along
                )
            }
        }
    }};
}
pub(crate) use between;
