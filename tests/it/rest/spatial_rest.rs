//! Static equilibrium and natural frequencies in space, against closed forms and dense systems that share nothing with the crate.

use catena::loading::Unloaded;
use catena::spatial::*;
use catena::{Error, Fault, planar};
use catena_oracle::near;
use core::f64::consts::{FRAC_PI_2, PI, TAU};
use nalgebra::{DMatrix, DVector, Matrix3, Rotation3, SymmetricEigen, Vector3};
use num_dual::{Dual64, DualNum};

const G: f64 = 9.81;

/// Eigenvalues of K x = ω² M x, ascending.
fn squares(mass: DMatrix<f64>, stiffness: DMatrix<f64>) -> Vec<f64> {
    let lower = mass.cholesky().expect("a mass matrix").l();
    let half = lower.solve_lower_triangular(&stiffness).expect("regular");
    let whole = lower.solve_lower_triangular(&half.transpose()).expect("regular");
    let mut squares: Vec<f64> = SymmetricEigen::new(whole).eigenvalues.iter().copied().collect();
    squares.sort_by(f64::total_cmp);
    squares
}

#[test]
fn two_hanging_rods_swing_alike_in_every_plane_and_spin_freely() -> Result<(), Error> {
    let (l, r, m) = (0.8, 0.05, 1.3);
    let rod = Rod::uniform(l, r, m);
    let pendulum = System::new(Pinned::origin(), (rod, Ball, rod), Free)?.with_gravity([0.0, -G, 0.0]);
    let hanging = pendulum.at_rest(&[0.3, 0.0, -FRAC_PI_2, -0.4, 0.0, -FRAC_PI_2])?;
    let modes = pendulum.modes(&hanging, &Unloaded)?;
    // (J + m l²/4 + m l²) a + m l²/2 b, … : a quadratic equation for ω².
    let across = m * (3.0 * r * r + l * l) / 12.0 + 0.25 * m * l * l;
    let (a, b, c) = (across + m * l * l, across, 0.5 * m * l * l);
    let (k, n) = (1.5 * m * G * l, 0.5 * m * G * l);
    let (p, q, s) = (a * b - c * c, -(a * n + b * k), k * n);
    let root = (q * q - 4.0 * p * s).sqrt();
    let [slow, fast] = [(-q - root) / (2.0 * p), (-q + root) / (2.0 * p)].map(f64::sqrt);
    let expected = [0.0, 0.0, slow, slow, fast, fast];
    let found: Vec<f64> = modes.frequencies().collect();
    println!("found {found:?}, expected {expected:?}");
    assert_eq!(found.len(), 6);
    for (found, expected) in found.iter().zip(expected) {
        // ω² of a free spin is rounding of that of the largest.
        let tolerance = if expected == 0.0 { 1e-6 } else { 1e-12 };
        near(*found, expected, tolerance * fast);
    }
    Ok(())
}

/// A symmetric top whose axis is body y: moments along and across it about the pivot.
fn top(mass: f64, arm: f64, along: f64, across: f64) -> RigidBody<f64> {
    let o = 0.0;
    let own = across - mass * arm * arm;
    RigidBody::new(mass, [[own, o, o], [o, along, o], [o, o, own]], [o, arm, o], [o, arm, o])
}

#[test]
fn a_top_at_rest_swings_or_falls() -> Result<(), Error> {
    let (m, arm, along, across) = (1.5, 0.3, 0.02, 0.2);
    let body = top(m, arm, along, across);
    let free = System::new(Pinned::origin(), body, Free)?.with_gravity([0.0, -G, 0.0]);
    let pull = (m * G * arm / across).sqrt();
    let hanging = free.modes(&free.at_rest(&[PI, 0.0, 0.0])?, &Unloaded)?;
    let standing = free.modes(&free.motion(), &Unloaded)?;
    for (modes, expected) in [(hanging, [0.0, pull, pull]), (standing, [-pull, -pull, 0.0])] {
        let found: Vec<f64> = modes.frequencies().collect();
        println!("found {found:?}, expected {expected:?}");
        for (found, expected) in found.iter().zip(expected) {
            near(*found, expected, if expected == 0.0 { 1e-6 } else { 1e-12 });
        }
    }
    // Springs about x and z hold it up, one about y turns it back.
    let ball = ElasticBall::rotary([20.0, 3.0, 30.0]);
    let o = 0.0;
    let post = Rod::uniform(1.0, 0.1, 1.0);
    let held =
        System::new(Clamped::at([o; 3], Rotation::identity()), (post, ball, body), Free)?.with_gravity([0.0, -G, 0.0]);
    let modes = held.modes(&held.motion(), &Unloaded)?;
    let expected = [3.0 / along, (20.0 - m * G * arm) / across, (30.0 - m * G * arm) / across].map(f64::sqrt);
    let mut expected = expected.to_vec();
    expected.sort_by(f64::total_cmp);
    for (found, expected) in modes.frequencies().zip(expected) {
        near(found, expected, 1e-12 * expected);
    }
    Ok(())
}

/// A ω² cos ϑ − C ω₃ Ω + m g s = 0: a top spins about its axis with ω₃ and precesses at a constant tilt ϑ with Ω.
#[test]
fn a_heavy_top_precesses_steadily() -> Result<(), Error> {
    let (m, arm, along, across) = (1.5, 0.3, 0.02, 0.2);
    let (tilt, spin) = (0.9_f64, 90.0);
    let scene = System::new(Pinned::origin(), top(m, arm, along, across), Free)?.with_gravity([0.0, -G, 0.0]);
    let (a, b, c) = (across * tilt.cos(), -along * spin, m * G * arm);
    let root = (b * b - 4.0 * a * c).sqrt();
    for precession in [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)] {
        // The axis leans from the vertical towards −x, and goes round about +y.
        let lean = Rotation::from_angles([0.0, 0.0, tilt]);
        let up = lean.inverse().turned([0.0, precession, 0.0]); // body axes
        let rates = [up[0], spin, up[2]];
        let mut start = scene.motion();
        start.position_mut().0 = lean;
        start.rate_mut().0 = rates;
        let period = TAU / precession;
        let mut nutation = 0.0_f64;
        let run = scene.simulation(Dop853::tolerance(1e-12)).every(period / 50.0).run(start, period, |now| {
            let axis = now.motion().position().0.turned([0.0, 1.0, 0.0]);
            nutation = nutation.max((axis[1] - tilt.cos()).abs());
        })?;
        let axis = Vector3::from(run.motion.position().0.turned([0.0, 1.0, 0.0]));
        let closed = (axis - Vector3::from(lean.turned([0.0, 1.0, 0.0]))).amax();
        println!("precession {precession:.6} rad/s: nutation {nutation:.1e}, off by {closed:.1e} after a turn");
        assert!(nutation < 1e-10 && closed < 1e-9); // a tolerance of 1e-12 over some hundred steps
    }
    Ok(())
}

/// A straight chain of rods on elastic balls twists like rotors on a shaft and bends alike in two planes.
#[test]
fn a_chain_of_elastic_balls_twists_and_bends() -> Result<(), Error> {
    const N: usize = 6;
    let (l, r, m, twist, bend) = (0.2, 0.02, 0.3, 4.0, 15.0);
    let (rod, ball) = (Rod::uniform(l, r, m), ElasticBall::rotary([twist, bend, bend]));
    let post = Rod::uniform(0.1, 0.02, 1.0);
    let chain = System::new(Clamped::origin(), (post, [(ball, rod); N]), Free)?;
    let modes = chain.modes(&chain.motion(), &Unloaded)?;

    let axial = 0.5 * m * r * r;
    let shaft = |k: usize| 2.0 * (twist / axial).sqrt() * (PI * (2 * k - 1) as f64 / (2 * (2 * N + 1)) as f64).sin();
    let mut expected: Vec<f64> = (1..=N).map(shaft).collect();
    // Slopes θ_k as coordinates: a centre moves by Σ_{j<k} l θ_j + l θ_k / 2.
    let own = m * (3.0 * r * r + l * l) / 12.0;
    let (mut mass, mut stiffness) = (DMatrix::zeros(N, N), DMatrix::zeros(N, N));
    for k in 0..N {
        let lever = DVector::from_fn(N, |j, _| {
            if j < k {
                l
            } else if j == k {
                0.5 * l
            } else {
                0.0
            }
        });
        mass += &lever * lever.transpose() * m;
        mass[(k, k)] += own;
        stiffness[(k, k)] += bend;
        if k > 0 {
            stiffness[(k - 1, k - 1)] += bend;
            stiffness[(k, k - 1)] -= bend;
            stiffness[(k - 1, k)] -= bend;
        }
    }
    for square in squares(mass, stiffness) {
        expected.extend([square.sqrt(); 2]);
    }
    expected.sort_by(f64::total_cmp);
    let largest = expected[3 * N - 1];
    let mut worst = 0.0_f64;
    for (found, expected) in modes.frequencies().zip(&expected) {
        worst = worst.max((found - expected).abs() / largest);
    }
    println!(
        "{} frequencies from {:.3} to {largest:.3} rad/s, off by {worst:.1e} of the largest",
        modes.len(),
        expected[0]
    );
    assert!(modes.len() == 3 * N && worst < 1e-11); // 1e-15 of the largest ω², the span of which is 1e3
    Ok(())
}

/// The logarithm's transposed inverse tangent, applied: (1 + ½ φ × + c φ × φ ×) K φ.
fn couple(phi: Vector3<f64>, stiffness: Vector3<f64>) -> Vector3<f64> {
    let angle = phi.norm();
    let c = (1.0 - 0.5 * angle / (0.5 * angle).tan()) / (angle * angle);
    let force = phi.component_mul(&stiffness);
    force + phi.cross(&force) * 0.5 + phi.cross(&phi.cross(&force)) * c
}

const BALLS: usize = 4;
const STIFFNESS: [f64; 3] = [2.0, 5.0, 3.0];

/// Torques that are left in the balls of a chain along x, clamped at the origin, for rotation vectors of the balls.
fn left_over(phi: &DVector<f64>, pull: Vector3<f64>) -> DVector<f64> {
    let (l, m) = (0.3, 0.4);
    let (mut turn, mut place) = (Matrix3::identity(), Vector3::new(l, 0.0, 0.0));
    let (mut balls, mut centres, mut springs) = (vec![], vec![], vec![]);
    for k in 0..BALLS {
        let own = Vector3::new(phi[3 * k], phi[3 * k + 1], phi[3 * k + 2]);
        springs.push(turn * couple(own, Vector3::from(STIFFNESS)));
        turn *= Rotation3::from_scaled_axis(own).into_inner();
        balls.push(place);
        centres.push(place + turn * Vector3::new(0.5 * l, 0.0, 0.0));
        place += turn * Vector3::new(l, 0.0, 0.0);
    }
    let mut left = DVector::zeros(3 * BALLS);
    for k in 0..BALLS {
        let moment = (k..BALLS).fold(Vector3::zeros(), |sum, j| sum + (centres[j] - balls[k]).cross(&(pull * m)));
        left.fixed_rows_mut::<3>(3 * k).copy_from(&(moment - springs[k]));
    }
    left
}

#[test]
fn a_chain_of_elastic_balls_sags_like_a_dense_newton_iteration() -> Result<(), Error> {
    let rod = Rod::uniform(0.3, 0.02, 0.4);
    let pull = Vector3::new(1.0, -G, 3.0);
    let ball = ElasticBall::rotary(STIFFNESS);
    let chain = System::new(Clamped::origin(), (rod, [(ball, rod); BALLS]), Free)?.with_gravity_vector(pull);
    let rest = chain.equilibrium(chain.motion(), &Unloaded)?;

    let mut phi = DVector::from_element(3 * BALLS, 0.01);
    for step in 0..60 {
        let left = left_over(&phi, pull);
        let mut jacobian = DMatrix::zeros(3 * BALLS, 3 * BALLS);
        for j in 0..3 * BALLS {
            let at = |h: f64| {
                let mut phi = phi.clone();
                phi[j] += h;
                left_over(&phi, pull)
            };
            jacobian.set_column(j, &((at(1e-5) - at(-1e-5)) / 2e-5));
        }
        let full = jacobian.lu().solve(&left).expect("regular");
        let length = full.amax();
        phi -= full * if length > 0.2 { 0.2 / length } else { 1.0 };
        if length < 1e-14 {
            println!("{step} steps, torque left {:.1e} N·m", left_over(&phi, pull).amax());
            break;
        }
    }
    assert!(left_over(&phi, pull).amax() < 1e-13);
    let mut worst = 0.0_f64;
    for (k, link) in rest.position().1.1.iter().enumerate() {
        let found = link.0.log();
        (0..3).for_each(|i| worst = worst.max((found[i] - phi[3 * k + i]).abs()));
    }
    println!("balls turn by up to {:.3} rad, rotation vectors differ by {worst:.1e}", phi.amax());
    assert!(worst < 1e-13 && phi.amax() > 0.3); // rounding
    Ok(())
}

/// A chain on balls hangs in the vertical plane of its ends, as a chain on pins hangs in the plane; its rods may spin as they like.
#[test]
fn a_hanging_chain_stays_in_the_plane_of_its_ends() -> Result<(), Error> {
    const N: usize = 12;
    let (l, m) = (0.1, 0.2);
    let (x, y, z) = (0.6, 0.1, 0.5);
    let span = f64::hypot(x, z);
    let slopes: [f64; N] = core::array::from_fn(|k| 1.2 * ((2 * k + 1) as f64 / N as f64 - 1.0));
    let flat = {
        use planar::*;
        let rod = Rod::new(l, m, 0.5 * l, m * l * l / 12.0);
        let chain = System::new(Pinned::origin(), (rod, [(Pin, rod); N - 1]), Pinned::at(span, y))?.with_gravity(G);
        let rest = chain.equilibrium(chain.at_rest(&slopes)?, &Unloaded)?;
        (chain.angles(&rest)?.iter().copied().collect::<Vec<f64>>(), *rest.multipliers())
    };
    let rod = Rod::uniform(l, 0.01, m);
    let chain =
        System::new(Pinned::origin(), (rod, [(Ball, rod); N - 1]), Pinned::at([x, y, z]))?.with_gravity([0.0, -G, 0.0]);
    let heading = (-z).atan2(x); // about y
    let mut guess = vec![];
    for (k, slope) in slopes.iter().enumerate() {
        // A rotation about y after one about z; every rod bulges and spins a little besides.
        let up = Rotation::from_angles([0.0, heading + 0.05 * (k as f64).sin(), 0.0]);
        let tilt = up.after(&Rotation::from_angles([0.2 * k as f64, 0.0, *slope]));
        guess.extend(tilt.angles());
    }
    let rest = chain.equilibrium(chain.at_rest(&guess)?, &Unloaded)?;
    let (across, along) = (Vector3::new(-z, 0.0, x) / span, Vector3::new(x, 0.0, z) / span);
    let mut worst = [0.0_f64; 2];
    for (body, angle) in chain.body_motions(&rest)?.iter().zip(&flat.0) {
        let direction = body.arm / l;
        worst[0] = worst[0].max(direction.dot(&across).abs());
        worst[1] = worst[1].max((direction.dot(&along) - angle.cos()).abs()).max((direction.y - angle.sin()).abs());
    }
    let force = Vector3::from(*rest.multipliers());
    let off = (force.dot(&along) - flat.1[0]).abs().max((force.y - flat.1[1]).abs());
    println!(
        "out of the plane by {:.1e}, against the plane's chain {:.1e}, force at the tip {off:.1e} N",
        worst[0], worst[1]
    );
    assert!(worst[0] < 1e-12 && worst[1] < 1e-12 && off < 1e-11); // rounding of twelve rods
    Ok(())
}

/// A scene of joints of all kinds swings with the frequency that its linearisation has.
#[test]
fn a_small_swing_takes_the_period_of_its_mode() -> Result<(), Error> {
    let tensor = [[0.02, 0.001, 0.002], [0.001, 0.09, 0.003], [0.002, 0.003, 0.1]];
    let body = RigidBody::new(1.0, tensor, [0.2, 0.03, -0.02], [0.4, 0.1, 0.0]);
    let chain = (
        body,
        Revolute::about([0.0, 1.0, 0.3]).with(Spring::stiffness(30.0)),
        body,
        Universal::about([1.0, 0.0, 0.0], [0.0, 0.4, 1.0]).with(Spring::stiffness(8.0), Spring::stiffness(20.0)),
        body,
        Cylindrical::on([1.0, 0.2, 0.0]).with(Spring::stiffness(200.0), Spring::stiffness(5.0)),
        body,
    );
    let pull = Vector3::new(0.5, -G, 1.0);
    let scene = System::new(Hinged::at([0.0; 3], [0.3, 0.1, 1.0]), chain, Free)?.with_gravity_vector(pull);
    let rest = scene.equilibrium(scene.motion(), &Unloaded)?;
    let modes = scene.modes(&rest, &Unloaded)?;
    let squares = |size: f64| -> Result<Vec<f64>, Error> {
        let mut errors = vec![];
        for mode in modes.iter() {
            let mut start = rest;
            let mut shape = start.rate().to_owned();
            let mut numbers = mode.shape().iter();
            catena::system::Rate::replace(&mut shape, &mut |_: f64| size * numbers.next().copied().unwrap_or(0.0));
            catena::system::Position::displace(start.position_mut(), &shape);
            let run = scene.simulate(start, Dop853::tolerance(1e-13), TAU / mode.frequency(), |_| ())?;
            let mut off = shape;
            catena::system::Position::apart(run.motion.position(), start.position(), &mut off);
            let mut most = 0.0_f64;
            catena::system::Rate::visit(&off, &mut |x: f64| most = most.max(x.abs()));
            errors.push(most / size);
        }
        Ok(errors)
    };
    // What is left is of second order in the size of the swing.
    let (large, small) = (squares(1e-4)?, squares(1e-5)?);
    for ((mode, large), small) in modes.iter().zip(large).zip(small) {
        println!("{:8.4} rad/s: off by {large:.1e} and {small:.1e} of the swing", mode.frequency());
        assert!(small < 0.2 * large && small < 1e-2);
    }
    Ok(())
}

/// Equilibria differentiate: the sag over dual numbers against differences.
#[test]
fn equilibria_have_derivatives() -> Result<(), Error> {
    let tip = |g: Dual64| -> Result<[Dual64; 2], Error> {
        let number = Dual64::from;
        let rod = Rod::uniform(number(0.3), number(0.02), number(0.4));
        let ball = ElasticBall::rotary([2.0, 5.0, 3.0].map(number));
        let pull = Vector3::new(number(1.0), -g, number(3.0));
        let chain = System::new(Clamped::origin(), (rod, ball, rod, ball, rod), Free)?.with_gravity_vector(pull);
        let rest = chain.equilibrium(chain.motion(), &Unloaded)?;
        let place = chain.stations(&rest, &Unloaded).unwrap().tip().frame.place;
        Ok([place.y, place.z])
    };
    let own = tip(Dual64::from(G).derivative())?;
    let value = |g: f64| tip(Dual64::from(g)).map(|place| place.map(|x| x.re));
    let h = 1e-3;
    let [a, b, c, d] = [value(G - 2.0 * h)?, value(G - h)?, value(G + h)?, value(G + 2.0 * h)?];
    for k in 0..2 {
        let difference = (a[k] - 8.0 * b[k] + 8.0 * c[k] - d[k]) / (12.0 * h);
        println!("derivative {:.12}, difference {difference:.12}", own[k].eps);
        near(own[k].eps, difference, 1e-11); // h⁴ and 1e-16 / h
    }
    Ok(())
}

/// Without springs a chain that floats has nowhere to rest.
#[test]
fn what_falls_has_no_equilibrium() -> Result<(), Error> {
    let rod = Rod::uniform(1.0, 0.1, 1.0);
    let falling = System::new(Free, (rod, Ball, rod), Free)?.with_gravity([0.0, -G, 0.0]);
    let fault = falling.equilibrium(falling.motion(), &Unloaded).err().map(|error| error.fault);
    println!("{fault:?}");
    assert!(matches!(fault, Some(Fault::NoEquilibrium { .. })));
    let tilted = System::new(Pinned::origin(), (rod, Ball, rod), Free)?.with_gravity([0.0, -G, 0.0]);
    let fault = tilted.modes(&tilted.at_rest(&[0.0, 0.0, -1.5, 0.0, 0.0, -1.5])?, &Unloaded).err().map(|e| e.fault);
    println!("{fault:?}");
    assert!(matches!(fault, Some(Fault::NotAtRest { .. })));
    Ok(())
}

/// Thin rods turn about themselves so easily that rounding of what pulls them is large there: the planar chain has each frequency that swings, twice.
#[test]
fn rods_on_balls_rest_and_swing_however_thin() -> Result<(), Error> {
    let pull = [3.0, -4.0, 5.0_f64];
    let gravity = pull.iter().map(|x| x * x).sum::<f64>().sqrt();
    for radius in [2e-2, 5e-3, 4e-3, 1e-3] {
        let rod = Rod::uniform(1.0, radius, 1.0);
        let scene = System::new(Pinned::origin(), (rod, Ball, rod), Free)?.with_gravity(pull);
        let rest = scene.equilibrium(scene.at_rest(&[0.0, 0.1, -1.2, 0.1, 0.0, -1.0])?, &Unloaded)?;
        let found: Vec<f64> = scene.modes(&rest, &Unloaded)?.frequencies().collect();
        let bar = planar::RigidBody::new(1.0, 1.0 / 12.0 + radius * radius / 4.0, [0.5, 0.0], [1.0, 0.0]);
        let flat = planar::System::new(planar::Pinned::origin(), (bar, planar::Pin, bar), planar::Free)?;
        let flat = flat.with_gravity(gravity);
        let expected = flat.modes(&flat.at_rest(&[-std::f64::consts::FRAC_PI_2; 2])?, &Unloaded)?;
        // Each about itself, freely, and then both ways across.
        found[..2].iter().for_each(|spin| assert!(spin.abs() < 2e-3, "{radius}: {found:?}"));
        for (pair, expected) in found[2..].chunks(2).zip(expected.frequencies()) {
            pair.iter().for_each(|found| near(*found, expected, 1e-9));
        }
    }
    Ok(())
}
