//! (47) to (60): overall equations of loops, branches and networks, against the sweep of trees and against multipliers.
//!
//! Matrices are formed at an instant of a motion with its accelerations, so that (1) is exact and nothing is linearised: the states that
//! solve an overall equation must be those of the motion, its forces included.

use catena::loading::Unloaded;
use catena::paper::topology::{branched, closed_loop, free, network, pinned};
use catena::paper::{
    At, Expansion, External, GeneralizedAlpha, Known, Rigid, Rotary, Scheme, Solver, rigid_body, rotary_hinge,
    smooth_pin,
};
use catena::planar::index::{M, ONE, QX, QY, THETA, X, Y};
use catena::planar::{Branch, Free, Inertia, Pin, Pinned, Rod, System};
use catena::{Error, StateVector, TransferMatrix};
use catena_oracle::{has_order, near};
use core::f64::consts::{FRAC_PI_3, FRAC_PI_6};
use nalgebra::{DMatrix, DVector, Vector2};

type Matrix = TransferMatrix<f64, 7>;
const CHI1: f64 = 40.0; // anything: (1) is made exact

/// A rod of an instant: length, mass, angle, rate, angular acceleration; place and acceleration of its inboard end.
#[derive(Clone, Copy, Debug)]
struct Link {
    length: f64,
    mass: f64,
    turn: [f64; 3],
    place: Vector2<f64>,
    acceleration: Vector2<f64>,
}

impl Link {
    fn along(&self) -> Vector2<f64> {
        let (s, c) = self.turn[0].sin_cos();
        Vector2::new(c, s)
    }
    /// Acceleration of a point at a share of the length.
    fn point(&self, share: f64) -> [Vector2<f64>; 2] {
        let (d, [_, rate, angular]) = (self.along() * (share * self.length), self.turn);
        [self.place + d, self.acceleration + Vector2::new(-d.y, d.x) * angular - d * (rate * rate)]
    }
    /// The same rod from its other end.
    fn reversed(&self) -> Self {
        let [place, acceleration] = self.point(1.0);
        let [angle, rate, angular] = self.turn;
        Self { turn: [angle + core::f64::consts::PI, rate, angular], place, acceleration, ..*self }
    }
    /// (32).
    fn matrix(&self, gravity: f64) -> Matrix {
        let inertia = Inertia {
            mass: self.mass,
            centre: [0.5 * self.length, 0.0],
            about_centre: self.mass * self.length * self.length / 12.0,
        };
        let rigid = Rigid { inertia, outboard: [self.length, 0.0] };
        let at = Expansion::about(self.turn[0]);
        let [centre, of_centre] = self.point(0.5);
        let chi2 = |value: f64, second: f64| second - CHI1 * value;
        let known = Known::absolute(
            &rigid,
            &at,
            [
                chi2(self.place.x, self.acceleration.x),
                chi2(self.place.y, self.acceleration.y),
                chi2(centre.x, of_centre.x),
                chi2(centre.y, of_centre.y),
                chi2(self.turn[0], self.turn[2]),
            ],
        );
        rigid_body(&rigid, &at, CHI1, &known, &External { force: [0.0, -gravity * self.mass], torque: 0.0 })
    }
}

/// The product of rods with smooth pins between, whose section reaches to the next pin: the last one ends without torque.
fn pinned_chain(rods: &[Link], gravity: f64) -> Matrix {
    let mut whole = Matrix::identity();
    for (k, rod) in rods.iter().enumerate().rev() {
        let matrix = rod.matrix(gravity);
        whole = matrix.then(&whole);
        if k > 0 {
            whole = smooth_pin(&matrix, [0.0; 2], CHI1).unwrap().then(&whole);
        }
    }
    whole
}

#[track_caller]
fn meets(name: &str, z: &StateVector<f64, 7>, rod: &Link, [qx, qy]: [f64; 2], m: f64) {
    let known = [rod.place.x, rod.place.y, rod.turn[0], m, qx, qy];
    println!("{name}: {:?} {known:?}", z.as_vector().as_slice());
    for (i, known) in known.into_iter().enumerate() {
        near(z[i], known, 1e-10 * (1.0 + known.abs()));
    }
}

/// A rod that hangs on another rod's end or on the ground, and what is known of it.
fn link(length: f64, mass: f64, turn: [f64; 3], place: Vector2<f64>, acceleration: Vector2<f64>) -> Link {
    Link { length, mass, turn, place, acceleration }
}

/// The tree of (50) to (55) against the sweep with a branch; II has a pin inside, where (55) as printed has no inverse.
#[test]
fn branched_equation_meets_the_sweep_of_a_tree() -> Result<(), Error> {
    let [a, b, c, d] =
        [(1.0, 1.0), (0.7, 0.8), (0.5, 0.6), (0.4, 0.3)].map(|(length, mass)| Rod::uniform(length, mass));
    let scene = System::new(Pinned::origin(), (a, Branch((Pin, c)), Pin, b, Pin, d), Free)?.with_gravity(9.81);
    // Bodies in the order of the scene: a, the arm c, b, d.
    let angles = [-1.0, -2.3, -0.5, 0.2];
    let rates = [0.7, -0.9, 1.3, 0.4];
    let motion = scene.with_accelerations(scene.with_rates(scene.at_rest(&angles)?, &rates)?, &Unloaded)?;
    let stations = scene.stations(&motion, &Unloaded)?;
    let sizes = [(1.0, 1.0), (0.5, 0.6), (0.7, 0.8), (0.4, 0.3)];
    let rods: Vec<Link> = (scene.body_motions(&motion)?.iter().zip(sizes))
        .map(|(body, (length, mass))| {
            let frame = body.inboard;
            let turn = [body.angle(), frame.turn.rate, frame.acceleration.angular];
            link(length, mass, turn, frame.place, frame.acceleration.linear)
        })
        .collect();
    let [one, arm, two, last] = [rods[0], rods[1], rods[2], rods[3]];
    let matrices =
        [pinned_chain(&[one], 9.81), pinned_chain(&[two, last], 9.81), pinned_chain(&[arm.reversed()], 9.81)];
    let [first, second, third] = &matrices;
    let [root, out, tip] = branched([first, second, third], [&pinned(0.0, 0.0), &free(), &free()])?;
    let ground = stations.root().internal.force;
    meets("root", &root, &one, [ground.x, ground.y], 0.0);
    meets("tip of III", &tip, &arm.reversed(), [0.0; 2], 0.0);
    // The force that II takes: what its two rods need.
    let need = |rod: &Link| (rod.point(0.5)[1] + Vector2::new(0.0, 9.81)) * rod.mass;
    let force = need(&two) + need(&last);
    meets("start of II", &out, &two, [force.x, force.y], 0.0);
    // As printed with U_II⁻¹: II has a smooth pin inside, whose matrix has rank 6.
    assert!(second.as_matrix().determinant().abs() < 1e-9 * second.as_matrix().amax());
    Ok(())
}

/// A rod, and 0 or 1 for its inboard or outboard end.
type RodEnd = (usize, f64);

/// Rods held together by pins: accelerations and forces by multipliers, in the coordinates x_C, y_C, θ of all rods.
struct Multipliers {
    rods: Vec<(f64, f64)>,
    angles: Vec<f64>,
    rates: Vec<f64>,
    /// Places of the inboard ends.
    places: Vec<Vector2<f64>>,
    /// Ends that coincide: a rod and 0 or 1 for its inboard or outboard end, and another, or the ground.
    pins: Vec<(RodEnd, Option<RodEnd>)>,
    /// Torques on the rods.
    torques: Vec<f64>,
    gravity: f64,
}

impl Multipliers {
    /// Rods with their accelerations, and for each pin the force on its first rod.
    fn solve(&self) -> (Vec<Link>, Vec<Vector2<f64>>) {
        let (n, pins) = (self.rods.len(), self.pins.len());
        let arm = |(k, end): (usize, f64)| {
            let (s, c) = self.angles[k].sin_cos();
            Vector2::new(c, s) * ((end - 0.5) * self.rods[k].0)
        };
        let mut jacobian = DMatrix::<f64>::zeros(2 * pins, 3 * n);
        for (row, (one, other)) in self.pins.iter().enumerate() {
            for (end, sign) in core::iter::once((*one, 1.0)).chain(other.iter().map(|other| (*other, -1.0))) {
                let d = arm(end);
                jacobian[(2 * row, 3 * end.0)] += sign;
                jacobian[(2 * row + 1, 3 * end.0 + 1)] += sign;
                jacobian[(2 * row, 3 * end.0 + 2)] -= sign * d.y;
                jacobian[(2 * row + 1, 3 * end.0 + 2)] += sign * d.x;
            }
        }
        // Rates that the pins allow, nearest to those asked for; places drop out.
        let asked = DVector::from_fn(3 * n, |i, _| if i % 3 == 2 { self.rates[i / 3] } else { 0.0 });
        let square = &jacobian * jacobian.transpose();
        let excess = square.clone().svd(true, true).solve(&(&jacobian * &asked), 1e-12).unwrap();
        let rates = &asked - jacobian.transpose() * excess;
        let omega: Vec<f64> = (0..n).map(|k| rates[3 * k + 2]).collect();

        let size = 3 * n + 2 * pins;
        let (mut a, mut b) = (DMatrix::zeros(size, size), DVector::zeros(size));
        for (k, (length, mass)) in self.rods.iter().enumerate() {
            for (i, inertia) in [*mass, *mass, mass * length * length / 12.0].into_iter().enumerate() {
                a[(3 * k + i, 3 * k + i)] = inertia;
            }
            b[3 * k + 1] = -mass * self.gravity;
            b[3 * k + 2] = self.torques[k];
        }
        a.view_mut((3 * n, 0), (2 * pins, 3 * n)).copy_from(&jacobian);
        a.view_mut((0, 3 * n), (3 * n, 2 * pins)).copy_from(&(-jacobian.transpose()));
        for (row, (one, other)) in self.pins.iter().enumerate() {
            let mut centripetal = arm(*one) * omega[one.0].powi(2);
            if let Some(other) = other {
                centripetal -= arm(*other) * omega[other.0].powi(2);
            }
            (b[3 * n + 2 * row], b[3 * n + 2 * row + 1]) = (centripetal.x, centripetal.y);
        }
        let found = a.lu().solve(&b).unwrap();
        let rods = (0..n).map(|k| {
            let turn = [self.angles[k], omega[k], found[3 * k + 2]];
            let d = arm((k, 0.0));
            let of_end = Vector2::new(found[3 * k], found[3 * k + 1]) + Vector2::new(-d.y, d.x) * turn[2]
                - d * (turn[1] * turn[1]);
            link(self.rods[k].0, self.rods[k].1, turn, self.places[k], of_end)
        });
        let forces = (0..pins).map(|k| Vector2::new(found[3 * n + 2 * k], found[3 * n + 2 * k + 1]));
        (rods.collect(), forces.collect())
    }
}

/// Ends of rods one after the other.
fn places(start: Vector2<f64>, rods: &[(f64, f64)], angles: &[f64]) -> Vec<Vector2<f64>> {
    let mut place = start;
    rods.iter()
        .zip(angles)
        .map(|((length, _), angle)| {
            let here = place;
            place += Vector2::new(angle.cos(), angle.sin()) * *length;
            here
        })
        .collect()
}

/// A four-bar that floats: four rods in a ring.
fn four_bar(torques: Vec<f64>) -> Multipliers {
    let rods = vec![(0.5, 0.5), (1.2, 1.2), (0.9, 0.9), (1.0, 0.7)];
    // The last rod closes the ring from the end of the third to the start of the first.
    let angles = vec![FRAC_PI_3, 0.321105014831, -2.017338833372];
    let ends = places(Vector2::zeros(), &rods, &[angles.as_slice(), &[0.0]].concat());
    let back = -ends[3];
    let mut rods = rods;
    rods[3].0 = back.norm();
    let angles = [angles.as_slice(), &[back.y.atan2(back.x)]].concat();
    let places = places(Vector2::new(0.1, -0.2), &rods, &angles);
    // Each inboard end on the outboard end before it.
    let pins = (0..4).map(|k| ((k, 0.0), Some(((k + 3) % 4, 1.0)))).collect();
    Multipliers { rods, angles, rates: vec![0.6, -0.8, 1.1, 0.3], places, pins, torques, gravity: 9.81 }
}

/// (47) to (49), all pins smooth: the row of m vanishes, and m = 0 does in its place.
#[test]
fn closed_loop_of_smooth_pins_meets_multipliers() -> Result<(), Error> {
    let (rods, forces) = four_bar(vec![0.0; 4]).solve();
    // From the inboard end of the first rod round, the closing pin last; its section is the first rod.
    let closing = smooth_pin(&rods[0].matrix(9.81), [0.0; 2], CHI1)?;
    let around = pinned_chain(&rods, 9.81).then(&closing);
    let z = closed_loop(&around, true)?;
    meets("four-bar", &z, &rods[0], [forces[0].x, forces[0].y], 0.0);
    // Cut on the other side of that pin, U passes m as it is: a row of U − I vanishes, and (47) as printed has no one solution.
    let across = closing.then(&pinned_chain(&rods, 9.81));
    assert!((0..7).all(|k| (across[(M, k)] - if k == M { 1.0 } else { 0.0 }).abs() < 1e-10), "{across:?}");
    let z = closed_loop(&across, true)?;
    let end = rods[3].point(1.0)[0];
    let found =
        [z[X] - end.x, z[Y] - end.y, z[THETA] - rods[3].turn[0], z[M], z[QX] - forces[0].x, z[QY] - forces[0].y];
    assert!(found.iter().all(|x| x.abs() < 1e-10), "{found:?}");
    let printed = closed_loop(&across, false);
    assert!(printed.map_or(true, |z| z[M].abs() > 1e-3 || (z[QX] - forces[0].x).abs() > 1e-3));
    Ok(())
}

/// The same with elastic hinges, for which U − I is regular as printed.
#[test]
fn closed_loop_of_elastic_hinges_meets_multipliers() -> Result<(), Error> {
    let (stiffness, still) = (3.0, four_bar(vec![0.0; 4]));
    // Relative angles less rest angles, of the hinge inboard of each rod; the last one comes round by a turn.
    let rest = [0.4, -0.9, -2.1, 2.0];
    let angle = |k: usize| still.angles[k];
    let m: Vec<f64> = (0..4).map(|k| stiffness * (angle(k) - angle((k + 3) % 4) - rest[k])).collect();
    // m acts as −m on the outboard rod and as +m on the inboard one.
    let torques = (0..4).map(|k| -m[k] + m[(k + 1) % 4]).collect();
    let (rods, forces) = four_bar(torques).solve();
    let hinge = |k: usize| rotary_hinge(&Rotary { slope: stiffness, offset: -stiffness * rest[k] });
    let around = rods
        .iter()
        .enumerate()
        .fold(Matrix::identity(), |whole, (k, rod)| whole.then(&rod.matrix(9.81)).then(&hinge((k + 1) % 4)));
    let z = closed_loop(&around, false)?;
    meets("elastic ring", &z, &rods[0], [forces[0].x, forces[0].y], m[0]);
    Ok(())
}

/// (56) to (60): an arm from the ground, and a ring of four rods at its end.
#[test]
fn network_equation_meets_multipliers() -> Result<(), Error> {
    // In the order arm, J→P1, P1→P2, P2→P3, P3→J: the two last turned about to run round the ring.
    let turned = core::f64::consts::PI;
    let mut rods = vec![(0.8, 0.8), (0.6, 0.6), (0.5, 0.5), (0.55, 0.55), (0.45, 0.45)];
    let mut angles = vec![-FRAC_PI_3, -FRAC_PI_6, -2.0 * FRAC_PI_3, -0.620259990849 + turned, -1.977311259432 + turned];
    // The angles are known to twelve digits: the last rod closes the ring.
    let ends = places(Vector2::zeros(), &rods, &angles);
    let back = ends[1] - ends[4];
    (rods[4].0, angles[4]) = (back.norm(), back.y.atan2(back.x));
    let places = places(Vector2::zeros(), &rods, &angles);
    let pins = vec![
        ((0, 0.0), None),
        ((1, 0.0), Some((0, 1.0))),
        ((2, 0.0), Some((1, 1.0))),
        ((3, 0.0), Some((2, 1.0))),
        ((4, 0.0), Some((3, 1.0))),
        ((4, 1.0), Some((0, 1.0))),
    ];
    let torques = vec![0.0; 5];
    let rates = vec![0.5, -0.4, 0.9, 0.2, -0.7];
    let system = Multipliers { rods, angles, rates, places, pins, torques, gravity: 9.81 };
    let (rods, forces) = system.solve();
    let matrices = [pinned_chain(&rods[..1], 9.81), pinned_chain(&rods[1..], 9.81)];
    let [first, second] = &matrices;
    let [root, out] = network([first, second], &pinned(0.0, 0.0))?;
    meets("root", &root, &rods[0], [forces[0].x, forces[0].y], 0.0);
    meets("start of the ring", &out, &rods[1], [forces[1].x, forces[1].y], 0.0);
    // (60) as printed: with (I − U_II) the true states miss the balance of forces by twice what goes through the pin.
    let (arm, ring) = ((*first * root), (*second * out));
    let corrected = (0..2).fold(0.0_f64, |worst, i| worst.max((arm[QX + i] + ring[QX + i] - out[QX + i]).abs()));
    let printed = (0..2).fold(0.0_f64, |worst, i| worst.max((arm[QX + i] - ring[QX + i] + out[QX + i]).abs()));
    println!("(60): balance of forces at the pin missed by {corrected:.1e} N, as printed by {printed:.1} N");
    assert!(corrected < 1e-9 && printed > 1.0);
    assert!((arm[X] - out[X]).abs() < 1e-10 && (arm[Y] - out[Y]).abs() < 1e-10 && arm[ONE] == 1.0 && out[THETA] != 0.0);
    Ok(())
}

/// A four-bar on the ground as a chain with a tip held by a pin, by the scheme itself, against angles of an order-8 integration of a
/// multiplier system at 1e-13, which agrees with an independent crank-angle formulation to 5e-11.
#[test]
fn four_bar_on_the_ground_runs_in_the_scheme() -> Result<(), Error> {
    let rod = |length: f64| Rod::uniform(length, length);
    let chain = (rod(0.5), Pin, rod(1.2), Pin, rod(0.9));
    let scene = System::new(Pinned::origin(), chain, Pinned::at(1.0, 0.0))?.with_gravity(9.81);
    let start = scene.at_rest(&[FRAC_PI_3, 0.321105014831, -2.017338833372])?;
    let start = scene.assembled(start, &Unloaded)?;
    let known = [0.642899885450, 0.371974374104, -2.184234809797];
    let (root, held) = ([-9.029701078803, -6.306329530730], [7.817492762157, 16.943805449834]);
    let scheme = Scheme::new(GeneralizedAlpha::new(0.8)).linearized(At::Predictor).solved_by(Solver::Riccati);
    let (mut angles, mut forces) = (vec![], vec![]);
    for dt in [0.002, 0.001, 0.0005] {
        let mut run = scheme.start(&scene, &start, &Unloaded, dt)?;
        run.run_to(0.25)?;
        angles.push((dt, run.angles().zip(known).fold(0.0_f64, |worst, (a, b)| worst.max((a - b).abs()))));
        let (first, last) = (run.stations()[0], run.stations()[6]);
        // The ground's force on the last rod is −q.
        let off = [first[QX] - root[0], first[QY] - root[1], -last[QX] - held[0], -last[QY] - held[1]];
        forces.push((dt, off.iter().fold(0.0_f64, |worst, x| worst.max(x.abs()))));
    }
    has_order("four-bar, angles", 2.0, 1e-9, &angles);
    has_order("four-bar, forces", 2.0, 1e-8, &forces);
    Ok(())
}
