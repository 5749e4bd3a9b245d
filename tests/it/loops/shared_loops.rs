//! Loops in space that are held more often than they can move, one inside the other, while the body that carries them tumbles: against
//! the same mechanism without redundant closures, and reactions against the least norm of a dense solution.

use catena::loading::Unloaded;
use catena::spatial::{self, *};
use catena::system::Element;
use catena::system::MotionOf;
use catena::system::Root;
use catena::{Error, Scalar};
use catena_oracle::near;
use nalgebra::{DMatrix, DVector, SymmetricEigen, Vector3};

/// Places of the joints in the plane of the linkages (m), from the end of the base: crank A-B, coupler B-C-E, rocker D-C, and F-G-E.
const A: [f64; 2] = [0.0, 0.0];
const B: [f64; 2] = [0.3, 0.5];
const C: [f64; 2] = [1.1, 0.8];
const D: [f64; 2] = [1.0, 0.0];
const F: [f64; 2] = [1.8, -0.1];
const G: [f64; 2] = [2.0, 0.5];
/// How far beyond C the coupler reaches, as a share of B-C.
const BEYOND: f64 = 0.4;

fn end() -> [f64; 2] {
    [0, 1].map(|k| C[k] + BEYOND * (C[k] - B[k]))
}

/// Length and angle of the line from one place to another.
fn line(from: [f64; 2], to: [f64; 2]) -> (f64, f64) {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    (x.hypot(y), y.atan2(x))
}

fn rod<T: Scalar>(from: [f64; 2], to: [f64; 2]) -> Rod<T> {
    let (length, _) = line(from, to);
    Rod::uniform(T::literal(length), T::literal(0.02), T::literal(length))
}

fn hinge<T: Scalar>() -> Revolute<T> {
    Revolute::about([0.0, 0.0, 1.0].map(T::literal))
}

/// The base is a general body whose axes are not those of the linkage.
fn base<T: Scalar>() -> RigidBody<T> {
    let tensor = [[0.3, 0.02, -0.01], [0.02, 0.25, 0.03], [-0.01, 0.03, 0.4]].map(|row| row.map(T::literal));
    RigidBody::new(T::literal(1.5), tensor, [0.2, 0.1, -0.1].map(T::literal), [0.4, 0.1, 0.05].map(T::literal))
}

fn reach<T: Scalar>([x, y]: [f64; 2]) -> RigidBody<T> {
    RigidBody::massless([x, y, 0.0].map(T::literal))
}

/// The mechanism: `turn` stands at B and at G, `closing` at C and at E.
macro_rules! linkage {
    ($root:expr, $turn:expr, $closing:expr) => {{
        let inner = Network::new((hinge(), rod(A, B), $turn, rod(B, C)), (reach(D), hinge(), rod(D, C)), $closing);
        let side = (reach(F), hinge(), rod(F, G), $turn, rod(G, end()));
        let net = Network::new((inner, rod(C, end())), side, $closing);
        System::new($root, (base(), net), Free)?.with_gravity_vector(Vector3::new(0.5, -2.0, -9.0).map(Scalar::literal))
    }};
}

/// Angles of the linkage's joints: the numbers in a gap are those of a universal joint's second axis.
fn angles(base: [f64; 3], gap: &[f64]) -> Vec<f64> {
    let (ab, bc, dc, fg, ge) = (line(A, B).1, line(B, C).1, line(D, C).1, line(F, G).1, line(G, end()).1);
    [&base[..], &[ab, bc - ab], gap, &[dc, fg, ge - fg], gap].concat()
}

/// Attitude of the base at first (angles 1-2-3), and rates of its rotation (rad/s).
const BASE: [f64; 3] = [0.4, -0.3, 0.7];

/// A body at an instant, as Newton and Euler see it about the origin: m (a − g), and c × m (a − g) + J α + ω × J ω.
fn needs(body: &BodyMotion<f64>, gravity: Vector3<f64>) -> [Vector3<f64>; 2] {
    let (frame, inertia) = (body.inboard, &body.inertia);
    let (spin, turning) = (frame.turn.spin, frame.acceleration.angular);
    let axes =
        nalgebra::Matrix3::from_columns(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|e| body.turned(e)));
    let rows = inertia.about_centre.map(|row| nalgebra::RowVector3::from_row_slice(&row));
    let tensor = axes * nalgebra::Matrix3::from_rows(&rows) * axes.transpose();
    let centre = axes * Vector3::from(inertia.centre);
    let acceleration = frame.acceleration.linear + turning.cross(&centre) + spin.cross(&spin.cross(&centre));
    let force = inertia.mass * (acceleration - gravity);
    [force, (frame.place + centre).cross(&force) + tensor * turning + spin.cross(&(tensor * spin))]
}

/// The least numbers x of which A x = b in the rows that are given, and a basis of what is left undetermined.
fn least(matrix: &DMatrix<f64>, right: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>) {
    let SymmetricEigen { eigenvectors: directions, eigenvalues: squares } =
        (matrix.transpose() * matrix).symmetric_eigen();
    let floor = 1e-10 * squares.max();
    let (mut solved, mut loose) = (DVector::zeros(matrix.ncols()), vec![]);
    for (direction, square) in directions.column_iter().zip(&squares) {
        if *square > floor {
            solved += direction * ((matrix * direction).dot(right) / square);
        } else {
            loose.push(direction.into_owned());
        }
    }
    let basis = if loose.is_empty() { DMatrix::zeros(matrix.ncols(), 0) } else { DMatrix::from_columns(&loose) };
    (solved, basis)
}

/// Forces and torques in the joints that close the outer and the inner loop, ON the bodies of their main arms: of all that move
/// bodies like this, the least in the outer one, and the least in the inner one then. Bodies that are one are balanced as one.
fn reactions(bodies: &[BodyMotion<f64>]) -> [[Vector3<f64>; 2]; 2] {
    let gravity = Vector3::new(0.5, -2.0, -9.0);
    // 0 base, 1 crank, 2 coupler, (3 massless), 4 rocker, 5 what reaches beyond, (6 massless), 7 and 8 the outer side arm.
    let parts = [&[0, 3, 6][..], &[1], &[2, 5], &[4], &[7], &[8]];
    let normal = bodies[0].turned([0.0, 0.0, 1.0]);
    let along = bodies[0].turned([1.0, 0.0, 0.0]);
    let across = normal.cross(&along);
    let unit = [Vector3::x(), Vector3::y(), Vector3::z()];
    // Closing joints come first.
    let (tilts, none) = ([along, across], []);
    /// Parts on either side, the place, and the directions of torques.
    type Joint<'a> = (Option<usize>, usize, Vector3<f64>, &'a [Vector3<f64>]);
    let joints: [Joint<'_>; 8] = [
        (Some(5), 2, bodies[5].outboard().place, &tilts),
        (Some(3), 2, bodies[2].outboard().place, &tilts),
        (None, 0, bodies[0].inboard.place, &none),
        (Some(0), 1, bodies[1].inboard.place, &tilts),
        (Some(1), 2, bodies[2].inboard.place, &tilts),
        (Some(0), 3, bodies[4].inboard.place, &tilts),
        (Some(0), 4, bodies[7].inboard.place, &tilts),
        (Some(4), 5, bodies[8].inboard.place, &tilts),
    ];
    let mut columns = vec![];
    for (from, to, place, torques) in joints {
        let wrenches =
            unit.map(|e| [e, place.cross(&e)]).into_iter().chain(torques.iter().map(|e| [Vector3::zeros(), *e]));
        for [force, torque] in wrenches {
            let mut column = DVector::zeros(36);
            for (part, sign) in [(Some(to), 1.0), (from, -1.0)] {
                let Some(part) = part else { continue };
                column.fixed_rows_mut::<3>(6 * part).copy_from(&(sign * force));
                column.fixed_rows_mut::<3>(6 * part + 3).copy_from(&(sign * torque));
            }
            columns.push(column);
        }
    }
    let mut right = DVector::<f64>::zeros(36);
    for (part, members) in parts.into_iter().enumerate() {
        for body in members {
            let [force, torque] = needs(&bodies[*body], gravity);
            let mut rows = right.fixed_rows_mut::<3>(6 * part);
            rows += force;
            let mut rows = right.fixed_rows_mut::<3>(6 * part + 3);
            rows += torque;
        }
    }
    let matrix = DMatrix::from_columns(&columns);
    let (mut all, mut loose) = least(&matrix, &right);
    // Newton and Euler hold: the motion is one, and what is undetermined are three closures of each loop.
    let residual = (&matrix * &all - &right).amax();
    assert!(residual < 1e-9 * right.amax(), "{residual:.1e}");
    assert_eq!(loose.ncols(), 6);
    for first in [0, 5] {
        let (share, rest) = least(&loose.rows(first, 5).into_owned(), &-all.rows(first, 5));
        all += &loose * share;
        loose = &loose * rest;
    }
    assert_eq!(loose.ncols(), 0);
    [0, 5].map(|k| [all.fixed_rows::<3>(k).into_owned(), along * all[k + 3] + across * all[k + 4]])
}

/// Bodies of a motion.
fn bodies<R, C>(
    scene: &spatial::System<f64, R, C, Free>,
    motion: &MotionOf<Spatial<f64>, R, C, Free>,
) -> Vec<BodyMotion<f64>>
where
    R: Root<Spatial<f64>>,
    C: Element<Spatial<f64>>,
{
    scene.body_motions(motion).unwrap().iter().copied().collect()
}

/// By how much places, velocities and accelerations of two motions differ, relative to their size.
fn apart(some: &[BodyMotion<f64>], others: &[BodyMotion<f64>]) -> f64 {
    let numbers = |body: &BodyMotion<f64>| {
        let end = body.outboard();
        [end.place, end.velocity, end.turn.spin, end.acceleration.linear, end.acceleration.angular]
    };
    let pairs = some.iter().zip(others).flat_map(|(a, b)| numbers(a).into_iter().zip(numbers(b)));
    pairs.fold(0.0, |most, (a, b)| ((a - b).norm() / (1.0 + b.norm())).max(most))
}

#[test]
fn nested_loops_of_revolutes_tumble_as_without_redundant_closures() -> Result<(), Error> {
    let root = Pinned::<[f64; 3]>::origin;
    let shared = linkage!(root(), hinge(), LeastNorm(hinge()));
    let free = linkage!(root(), Universal::about([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]), Ball);
    let spin = [1.0, -0.7, 2.0];
    let shared_rates = [&spin[..], &[0.0; 5]].concat();
    let free_rates = [&spin[..], &[0.0; 7]].concat();
    let mut one =
        shared.with_accelerations(shared.with_rates(shared.at_rest(&angles(BASE, &[]))?, &shared_rates)?, &Unloaded)?;
    let mut two =
        free.with_accelerations(free.with_rates(free.at_rest(&angles(BASE, &[0.0]))?, &free_rates)?, &Unloaded)?;
    for time in [0.0, 0.25, 0.5, 0.75, 1.0] {
        one = shared.simulate(one, Dop853::tolerance(1e-12), time, |_| ())?.motion;
        two = free.simulate(two, Dop853::tolerance(1e-12), time, |_| ())?.motion;
        let (found, expected) = (bodies(&shared, &one), bodies(&free, &two));
        let off = apart(&found, &expected);
        let stations = shared.stations(&one, &Unloaded)?;
        let mut worst = 0.0_f64;
        // Stations of the closing joints: what the side arm passes on to the main arm.
        for (station, [force, torque]) in [15, 8].into_iter().zip(reactions(&expected)) {
            let internal = stations.get(station).map(|station| station.internal).expect("a closing joint");
            worst = worst.max((internal.force - force).norm()).max((-internal.torque - torque).norm());
        }
        println!("t = {time}: motions differ by {off:.1e}, reactions by {worst:.1e} N, N m");
        assert!(off < 1e-9, "t = {time}: {off:.1e}");
        assert!(worst < 1e-9, "t = {time}: {worst:.1e}");
    }
    let mut told = vec![];
    shared.shared_forces(&one, &Unloaded, |station, _| told.push(station))?;
    told.sort();
    assert_eq!(told, [[8; 5], [15; 5]].concat()); // in axes of the ground, none of them is decided
    Ok(())
}

/// In single precision, and with the root clamped askew.
#[test]
fn shared_loops_stand_askew_in_every_precision() -> Result<(), Error> {
    let askew = Clamped::at([0.1, 0.2, 0.3], Rotation::from_angles([0.4, -0.3, 0.7]));
    let double = linkage!(askew, hinge(), LeastNorm(hinge()));
    let start = double.at_rest(&angles(BASE, &[])[3..])?;
    let start = double.with_accelerations(start, &Unloaded)?;
    let energy = double.budget(&start)?.energy();
    let end = double.simulate(start, Dop853::tolerance(1e-12), 0.5, |_| ())?.motion;
    near(double.budget(&end)?.energy(), energy, 1e-10);
    let askew = Clamped::at([0.1_f32, 0.2, 0.3], Rotation::from_angles([0.4, -0.3, 0.7]));
    let single = linkage!(askew, hinge::<f32>(), LeastNorm(hinge::<f32>()));
    let numbers: Vec<f32> = angles(BASE, &[])[3..].iter().map(|x| *x as f32).collect();
    let found = single.simulate(single.at_rest(&numbers)?, Rk4::step(1e-3), 0.5, |_| ())?.motion;
    let places =
        bodies(&double, &end).into_iter().zip(single.body_motions(&found)?.iter().copied().collect::<Vec<_>>());
    for (exact, single) in places {
        near((exact.outboard().place - single.outboard().place.map(f64::from)).norm(), 0.0, 1e-4);
    }
    Ok(())
}

/// What lies beyond the last mass is no body of its own: closures are measured by the body that carries it.
#[test]
fn tips_and_loops_may_end_beyond_the_last_mass() -> Result<(), Error> {
    use catena::planar::{Free, Network, Pin, Pinned, RigidBody, Rod, System};
    let (rod, beyond) = (Rod::uniform(1.0, 1.0), RigidBody::massless([0.25, 0.1]));
    // The same body, whose end is that point.
    let whole = RigidBody::new(1.0, 1.0 / 12.0, [0.5, 0.0], [1.25, 0.1]);
    let angles = [1.0, 0.0, -1.0];
    let tip = Pinned::at(2.2, 0.1);
    let parted = System::new(Pinned::origin(), (rod, Pin, rod, Pin, rod, beyond), tip)?.with_gravity(9.81);
    let joined = System::new(Pinned::origin(), (rod, Pin, rod, Pin, whole), tip)?.with_gravity(9.81);
    let parted = parted.assembled(parted.at_rest(&angles)?, &Unloaded)?;
    let joined = joined.assembled(joined.at_rest(&angles)?, &Unloaded)?;
    for (found, expected) in parted.multipliers().iter().zip(joined.multipliers()) {
        near(*found, *expected, 1e-12);
    }
    // A loop that both arms leave so.
    let net = Network::new((Pin, rod, Pin, rod, beyond), (Pin, rod, beyond), LeastNorm(Pin));
    let scene = System::new(Pinned::origin(), (rod, net), Free)?.with_gravity(9.81);
    let start = scene.assembled(scene.at_rest(&[0.1, 1.0, -0.8, 0.1])?, &Unloaded)?;
    let mut shared = 0;
    scene.shared_forces(&start, &Unloaded, |_, _| shared += 1)?;
    assert_eq!(shared, 0);
    Ok(())
}
