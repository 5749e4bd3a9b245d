//! Functions of a robot at random states: their answers, or what they take.

use catena::robot::{Afloat, Place};
use std::error::Error;
use std::time::{Duration, Instant};

/// States that are gone through, so that no input stays what it was.
pub const STATES: usize = 100;
/// Calls of a batch, and for how long batches are repeated.
const BATCH: usize = 4 * STATES;
const BUDGET: Duration = Duration::from_millis(40);

pub type Outcome = Result<(), Box<dyn Error>>;

/// Numbers in (−1, 1), by the multiplier of L'Ecuyer for 64 bits.
pub struct Noise(pub u64);

impl Noise {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(3_935_559_000_370_003_845).wrapping_add(2_691_343_689_449_507_681);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
    pub fn list<const N: usize>(&mut self, size: f64) -> [f64; N] {
        std::array::from_fn(|_| size * self.next())
    }
}

/// A state of a robot of `N` joints, and of its base where that floats: place and quaternion (scalar first), velocity (inertial axes) and
/// angular velocity (axes of the base), and the same of its acceleration.
pub struct State<const N: usize> {
    pub place: [f64; 7],
    pub base_rates: [f64; 6],
    pub base_seconds: [f64; 6],
    pub q: [f64; N],
    pub v: [f64; N],
    pub torques: [f64; N],
    pub seconds: [f64; N],
}

impl<const N: usize> State<N> {
    pub fn random(noise: &mut Noise) -> Self {
        let mut place = noise.list::<7>(1.0);
        let length = place[3..].iter().map(|x| x * x).sum::<f64>().sqrt();
        place[3..].iter_mut().for_each(|x| *x /= length);
        let (base_rates, base_seconds) = (noise.list(2.0), noise.list(5.0));
        let (q, v, torques, seconds) = (noise.list(3.0), noise.list(3.0), noise.list(20.0), noise.list(5.0));
        Self { place, base_rates, base_seconds, q, v, torques, seconds }
    }

    #[allow(dead_code)] // one that is fixed has none
    pub fn base(&self) -> Afloat<f64> {
        let ([a, b, c, w, x, y, z], [v0, v1, v2, s0, s1, s2]) = (self.place, self.base_rates);
        let columns = [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + w * z), 2.0 * (x * z - w * y)],
            [2.0 * (x * y - w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + w * x)],
            [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), 1.0 - 2.0 * (x * x + y * y)],
        ];
        let [x, y, z] = columns.map(Into::into);
        let place = Place { place: [a, b, c].into(), attitude: catena::robot::Columns { x, y, z } };
        Afloat { place, velocity: [v0, v1, v2].into(), spin: [s0, s1, s2].into() }
    }
}

/// What is done with functions: their answers are written, or they are timed.
#[derive(Clone, Copy)]
pub struct Work(pub bool);

impl Work {
    /// A function of the state of a number: where a list is given, its answer goes there.
    pub fn does(&self, name: &str, mut call: impl FnMut(usize, Option<&mut Vec<f64>>)) {
        if !self.0 {
            for k in 0..STATES {
                let mut list = vec![];
                call(k, Some(&mut list));
                write(name, &list);
            }
            return;
        }
        let (mut times, start) = (vec![], Instant::now());
        while times.len() < 5 || start.elapsed() < BUDGET {
            let now = Instant::now();
            for k in 0..BATCH {
                call(k % STATES, None);
            }
            times.push(now.elapsed().as_secs_f64() * 1e9 / BATCH as f64);
        }
        times.sort_by(f64::total_cmp);
        println!("{name} {:.2}", times[times.len() / 2]);
    }
}

pub fn write(name: &str, list: &[f64]) {
    let words: Vec<String> = list.iter().map(|x| format!("{x:e}")).collect();
    println!("{name} {}", words.join(" "));
}

/// States of a robot, its sweep, and functions of lists; a joint and the place of the description's link in axes of its body, for Jacobians.
macro_rules! robot {
    ($work:expr, $name:ident, $link:expr, $functions:ident) => {{
        const N: usize = $name::JOINTS.len();
        let (work, scene, mut noise) = ($work, $name::scene::<f64>()?, Noise(5));
        let states: Vec<State<N>> = (0..STATES).map(|_| State::random(&mut noise)).collect();
        let floats = scene.motion().coordinates().len() > N;
        let whole = |base: &[f64], joints: &[f64; N]| {
            let base = if floats { base } else { &[] };
            [base, joints].concat()
        };
        if !work.0 {
            println!("joints {}", $name::JOINTS.join(" "));
            println!("of {}", $name::JOINTS[$link.0]);
            for state in &states {
                write("q", &whole(&state.place, &state.q));
                write("v", &whole(&state.base_rates, &state.v));
                write("torques", &whole(&[0.0; 6], &state.torques));
                write("seconds", &whole(&state.base_seconds, &state.seconds));
            }
        }
        let mut motions = vec![];
        for state in &states {
            let mut motion = scene.motion();
            motion.set_coordinates(&whole(&state.place, &state.q))?;
            motions.push(scene.with_rates(motion, &whole(&state.base_rates, &state.v))?);
        }
        let (mut workspace, mut found) = (scene.workspace(), scene.motion().acceleration().clone());
        work.does("sweep", |k, list| {
            let (position, rate) = (motions[k].position(), motions[k].rate());
            scene.accelerations(
                0.0,
                position,
                rate,
                &catena::robot::Torques(states[k].torques),
                &mut workspace,
                &mut found,
            );
            black_box(&found);
            if let Some(list) = list {
                Rate::visit(&found, &mut |x: f64| list.push(x));
            }
        });
        $functions!(work, scene, states, $link);
    }};
}

/// A function of a state, and how its answer is a list.
macro_rules! function {
    ($work:ident, $states:ident, $name:literal, |$state:ident| $call:expr, |$answer:ident| $list:expr) => {
        $work.does($name, |k, list| {
            let $state = &$states[k];
            let answer = black_box($call);
            if let (Some(list), Ok($answer)) = (list, answer) {
                list.extend($list);
            }
        })
    };
}

/// Functions of lists, for bases that are fixed.
#[allow(unused_macros)] // a robot is either
macro_rules! fixed {
    ($work:ident, $scene:ident, $states:ident, $link:expr) => {
        function!($work, $states, "forward_dynamics", |s| $scene.forward_dynamics(&s.q, &s.v, &s.torques), |x| x);
        function!($work, $states, "inverse_dynamics", |s| $scene.inverse_dynamics(&s.q, &s.v, &s.seconds), |x| x);
        // Large answers go into places that are kept.
        let mut mass = $scene.mass_matrix(&$states[0].q)?;
        let mut found = (catena::robot::ByState::zero(), mass);
        function!(
            $work,
            $states,
            "mass_matrix",
            |s| $scene.mass_matrix_into(&s.q, &mut mass).map(|()| black_box(&mass)),
            |x| x.iter().flatten()
        );
        function!($work, $states, "jacobian", |s| $scene.jacobian(&s.q, $link.0, $link.1), |x| x.into_iter().flatten());
        function!(
            $work,
            $states,
            "forward_dynamics_derivatives",
            |s| $scene
                .forward_dynamics_derivatives_into(&s.q, &s.v, &s.torques, &mut found)
                .map(|()| black_box(&found)),
            |x| {
                let (catena::robot::ByState { positions, rates }, torques) = x;
                [positions, rates, torques].into_iter().flatten().flatten()
            }
        );
    };
}

/// Functions for bases that float.
#[allow(unused_macros)] // a robot is either
macro_rules! floating {
    ($work:ident, $scene:ident, $states:ident, $link:expr) => {
        function!(
            $work,
            $states,
            "inverse_dynamics",
            |s| $scene.inverse_dynamics_afloat(s.base(), &s.q, &s.v, &s.base_seconds, &s.seconds),
            |x| x.0.into_iter().chain(x.1)
        );
        let mut mass = catena::robot::MassMatrix::zero();
        function!(
            $work,
            $states,
            "mass_matrix",
            |s| $scene.mass_matrix_afloat_into(s.base().place, &s.q, &mut mass).map(|()| black_box(&mass)),
            |x| {
                let catena::robot::MassMatrix { base, coupling, joints } = x;
                let mut list = vec![];
                for (i, row) in base.iter().enumerate() {
                    list.extend(row.iter().copied().chain(coupling.iter().map(|column| column[i])));
                }
                for (column, row) in coupling.iter().zip(joints) {
                    list.extend(column.iter().chain(row));
                }
                list
            }
        );
        function!(
            $work,
            $states,
            "jacobian",
            |s| $scene.jacobian_afloat(s.base().place, &s.q, Some($link.0), $link.1),
            |x| {
                let catena::robot::SixRows { base, joints } = x;
                base.into_iter().flatten().chain(joints.into_iter().flatten())
            }
        );
        function!(
            $work,
            $states,
            "forward_dynamics",
            |s| $scene.forward_dynamics_afloat(s.base(), &s.q, &s.v, &[0.0; 6], &s.torques),
            |x| x.0.into_iter().chain(x.1)
        );
        let mut found = (catena::robot::ByStateAfloat::zero(), catena::robot::Blocks::zero());
        function!(
            $work,
            $states,
            "forward_dynamics_derivatives",
            |s| $scene
                .forward_dynamics_derivatives_afloat_into(s.base(), &s.q, &s.v, &[0.0; 6], &s.torques, &mut found)
                .map(|()| black_box(&found)),
            |x| {
                let (catena::robot::ByStateAfloat { positions, rates }, torques) = x;
                let mut list = vec![];
                for catena::robot::Blocks { base, base_by_joints, joints_by_base, joints } in
                    [positions, rates, torques]
                {
                    base.iter().zip(base_by_joints).for_each(|(a, b)| list.extend(a.iter().chain(b).copied()));
                    joints_by_base.iter().zip(joints).for_each(|(a, b)| list.extend(a.iter().chain(b).copied()));
                }
                list
            }
        );
    };
}
