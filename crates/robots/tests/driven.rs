//! Driven joints: sweeps against dense Newton-Euler and Jacobian formulations that are handed the drive's effort, runs against moving
//! roots under every rule, a slider-crank against its closed form, work of the drive against energy, gradients against differences.

use catena::paper::{Newmark, Scheme};
use catena::planar::*;
use catena::scalar::{Jet, Scalar};
use catena::system::AngularVelocity::Inertial;
use catena::{Error, Fault, Place, spatial};
use catena_oracle::plane::{self, Joint};
use catena_oracle::space::robot::{Part, Robot};
use catena_oracle::{Noise, near, space};

/// a sin(ω t + p), with derivatives.
fn swing([a, w, p]: [f64; 3]) -> impl Fn(f64) -> [f64; 3] + Copy + 'static {
    move |time| {
        let (s, c) = (w * time + p).sin_cos();
        [a * s, a * w * c, -a * w * w * s]
    }
}

const LAWS: [[f64; 3]; 3] = [[0.9, 2.0, 0.3], [0.2, 3.0, -0.4], [0.6, 1.7, 1.1]];
const LINE: f64 = 0.4;

#[test]
fn a_chain_in_the_plane_moves_as_under_the_efforts_of_its_drives() -> Result<(), Error> {
    let [crank, spindle, wrist] = LAWS.map(swing);
    let plate = RigidBody::new(2.0, 0.11, [0.3, 0.1], [0.7, -0.2]);
    let rod = Rod::uniform(0.6, 1.2);
    let crank_joint = Driven::new(Revolute::smooth(), crank).named("crank");
    let spindle_joint = Driven::new(Slider::along(LINE), spindle).named("spindle");
    let wrist_joint = Driven::new(Revolute::smooth(), wrist).named("wrist");
    let chain = (rod, crank_joint, plate, spindle_joint, plate, wrist_joint, rod, Pin, rod);
    let scene = System::new(Pinned::at(0.2, -0.1), chain, Free)?.with_gravity(9.81);

    let (slat, board) = (
        plane::Body::rod(1.2, 0.6),
        plane::Body { mass: 2.0, inertia_c: 0.11, centre: [0.3, 0.1], outboard: [0.7, -0.2] },
    );
    let axis = [LINE.cos(), LINE.sin()];
    let ground = plane::Ground::at([0.2, -0.1]);
    let bodies = vec![slat, board, board, slat, slat];
    let joints = vec![Joint::Pin, Joint::Pin, Joint::Slider { axis, spring: [0.0; 3] }, Joint::Pin, Joint::Pin];
    let mut oracle = plane::Scene { bodies, joints, ground, tip: plane::Tip::Free, gravity: [0.0, -9.81] };

    let mut noise = Noise::new(3);
    for _ in 0..50 {
        let (time, q, v) = (noise.between(0.0, 9.0), noise.pair(), noise.pair());
        let mut start = scene.motion().at_time(time);
        start.set_coordinates(&q)?;
        start.set_rates(&v)?;
        let motion = scene.with_accelerations(start, &Unloaded)?;
        let laws = [crank(time), spindle(time), wrist(time)];
        let (inboard, turning) = (q[0] + laws[0][0], v[0] + laws[0][1]);
        let coordinates = [
            plane::Coordinates::angle(q[0], v[0]),
            plane::Coordinates::angle(laws[0][0], laws[0][1]),
            plane::Coordinates::along(axis, laws[1][0], laws[1][1], 0.0),
            plane::Coordinates::angle(laws[2][0], laws[2][1]),
            plane::Coordinates::angle(q[1] - inboard - laws[2][0], v[1] - turning - laws[2][1]),
        ];
        let state = oracle.place(&coordinates);
        for (k, body) in scene.body_motions(&motion)?.iter().enumerate() {
            near(body.inboard.place.x, state.position[k][0], 1e-14);
            near(body.inboard.velocity.y, state.velocity[k][1], 1e-13);
        }
        let stations = scene.stations(&motion, &Unloaded)?;
        let at = |name| Ok::<_, Error>(stations.joint(scene.joint(name)?).expect("a joint").internal);
        let (line, pushed) = (plane::rotate(inboard, axis), at("spindle")?.force);
        // A spring that pushes as the spindle does.
        let spring = [1.0, 0.0, laws[1][0] + pushed.x * line[0] + pushed.y * line[1]];
        oracle.joints[2] = Joint::Slider { axis, spring };
        let efforts = [0.0, -at("crank")?.torque, 0.0, -at("wrist")?.torque, 0.0];
        let answer = oracle.solve(&state, &efforts, &[]);
        let seconds = oracle.coordinate_accelerations(&state, &answer);
        near(seconds[0].1, motion.accelerations()[0], 1e-10);
        near(seconds[1].1, laws[0][2], 1e-10);
        near(plane::dot(seconds[2].0, axis), laws[1][2], 1e-10);
        near(seconds[3].1, laws[2][2], 1e-10);
        near(answer.angular_acceleration[4], motion.accelerations()[1], 1e-10);
        let root = scene.root_state(&motion, &Unloaded)?;
        near(root[index::QX], stations.root().internal.force.x, 1e-10);
        near(root[index::QY], stations.root().internal.force.y, 1e-10);
    }
    let scheme = Scheme::new(Newmark::new(0.25, 0.5));
    let refused = scheme.start(&scene, &scene.motion(), &Unloaded, 1e-3).map(|_| ());
    assert!(matches!(refused, Err(Error { fault: Fault::Unsupported { what: "a driven joint" }, .. })));
    Ok(())
}

#[test]
fn a_tree_in_space_moves_as_under_the_efforts_of_its_drives() -> Result<(), Error> {
    use spatial::{Branch, Clamped, Free, Prismatic, Revolute, RigidBody, Rotation, System, Weld};
    let [crank, spindle, wrist] = LAWS.map(swing);
    let z = [0.0, 0.0, 1.0];
    let (tensor, centre, outboard) =
        ([[0.3, 0.02, -0.01], [0.02, 0.25, 0.03], [-0.01, 0.03, 0.4]], [0.2, 0.1, -0.1], [0.4, 0.1, 0.05]);
    let body = RigidBody::new(1.5, tensor, centre, outboard);
    let turns = [[0.3, -0.5, 0.2], [1.1, 0.4, -0.3], [-0.7, 0.2, 0.9], [0.1, 1.3, -0.2], [0.5, 0.6, 0.7]];
    let weld = |k: usize| Weld::at(Rotation::from_angles(turns[k]));
    let hinge = |law| Driven::new(Revolute::about(z), law);
    let free = Revolute::about(z);
    let arm = Branch((weld(2), Driven::new(Revolute::about(z), wrist).named("wrist"), body, weld(3), free, body));
    let spindle_joint = Driven::new(Prismatic::along(z), spindle).named("spindle");
    let chain = (weld(0), hinge(crank).named("crank"), body, weld(1), spindle_joint, body, arm, weld(4), free, body);
    let scene = System::new(Clamped::origin(), chain, Free)?.with_gravity([1.0, -2.0, -9.0]);

    let part = |k: usize, parent: Option<usize>, slides| Part {
        parent,
        slides,
        place: if parent.is_some() { outboard.into() } else { [0.0; 3].into() },
        turn: matrix(Rotation::from_angles(turns[k])),
        mass: 1.5,
        centre: centre.into(),
        tensor: space::Matrix::from_fn(|i, j| tensor[i][j]),
        armature: 0.0,
        damping: 0.0,
    };
    let parts = vec![
        part(0, None, false),
        part(1, Some(0), true),
        part(2, Some(1), false),
        part(3, Some(2), false),
        part(4, Some(1), false),
    ];
    let oracle = Robot { base: None, parts, gravity: [1.0, -2.0, -9.0].into() };

    let mut noise = Noise::new(4);
    for _ in 0..50 {
        let (time, q, v) = (noise.between(0.0, 9.0), noise.pair(), noise.pair());
        let mut start = scene.motion().at_time(time);
        start.set_coordinates(&q)?;
        start.set_rates(&v)?;
        let motion = scene.with_accelerations(start, &spatial::Unloaded)?;
        let laws = [crank(time), spindle(time), wrist(time)];
        let (all_q, all_v) =
            ([laws[0][0], laws[1][0], laws[2][0], q[0], q[1]], [laws[0][1], laws[1][1], laws[2][1], v[0], v[1]]);
        let instant = oracle.at(&all_q, &all_v);
        let stations = scene.stations(&motion, &spatial::Unloaded)?;
        let at = |name| Ok::<_, Error>(stations.joint(scene.joint(name)?).expect("a joint").internal);
        let (line, torque) = (instant.bodies[1].of_place.column(1), |name, k: usize| {
            Ok::<_, Error>(-instant.bodies[k].of_turn.column(k).dot(&vector(at(name)?.torque)))
        });
        let efforts = [torque("crank", 0)?, line.dot(&vector(at("spindle")?.force)), torque("wrist", 2)?, 0.0, 0.0];
        let seconds = oracle.forward_dynamics(&all_q, &all_v, &efforts);
        let own = motion.accelerations();
        for (k, expected) in [laws[0][2], laws[1][2], laws[2][2], own[0], own[1]].into_iter().enumerate() {
            near(seconds[k], expected, 1e-10);
        }
        let (kinetic, potential) = (scene.budget(&motion)?.kinetic, scene.budget(&motion)?.potential);
        near(kinetic, instant.kinetic, 1e-12 * (1.0 + kinetic));
        near(potential, instant.potential, 1e-11);
    }
    Ok(())
}

fn vector(v: catena::nalgebra::Vector3<f64>) -> space::Vector {
    [v.x, v.y, v.z].into()
}

fn matrix(rotation: spatial::Rotation<f64>) -> space::Matrix {
    let columns = rotation.matrix();
    space::Matrix::from_columns(&[vector(columns.x), vector(columns.y), vector(columns.z)])
}

/// Coordinates and rates at the end of runs of two scenes by a rule, and the ground's force and torque (if it has the same lever): they
/// must agree.
macro_rules! agree {
    ($rule:expr, $time:expr, $tolerance:expr, $lever:expr, [$($scene:expr),*]) => {{
        let ends = [$({
            let scene = &$scene;
            let start = scene.at_rest(&[-1.2, 0.3])?.at_time($time);
            let end = scene.simulation($rule).run(start, $time + 1.0, |_| ())?.motion;
            let end = scene.with_accelerations(end, &Unloaded)?;
            let root = scene.stations(&end, &Unloaded)?.root().internal;
            [end.coordinates(), end.rates(), end.accelerations(), vec![root.force.x, root.force.y, $lever * root.torque]].concat()
        }),*];
        for (found, expected) in ends[0].iter().zip(&ends[1]) {
            near(*found, *expected, $tolerance * (1.0 + expected.abs()));
        }
    }};
}

#[test]
fn runs_agree_with_a_root_that_turns() -> Result<(), Box<dyn std::error::Error>> {
    let law = swing(LAWS[0]);
    let (rod, light) = (Rod::uniform(0.5, 1.0), Rod::uniform(0.4, 0.3));
    let hinge = ElasticHinge::rotary(4.0);
    let rest = (rod, Pin, rod, hinge, light);
    let driven = System::new(
        Clamped::at(0.0, 0.0, 0.0),
        (Driven::new(Revolute::smooth(), law), rod, Pin, rod, hinge, light),
        Free,
    )?
    .with_gravity(9.81);
    let moving = System::new(Clamped::on([0.0, 0.0], Turning(law)), rest, Free)?.with_gravity(9.81);
    for time in [0.0, 2.5] {
        agree!(Rk4::step(0.01), time, 1e-12, 1.0, [driven, moving]);
        agree!(Dop853::tolerance(1e-8), time, 1e-10, 1.0, [driven, moving]);
        agree!(Sdirk4::new().step(0.01), time, 1e-10, 1.0, [driven, moving]);
        agree!(GeneralizedAlpha::new(0.8).step(0.005), time, 1e-10, 1.0, [driven, moving]);
        agree!(Vcabm::new().tolerance(1e-8), time, 1e-9, 1.0, [driven, moving]);
        agree!(Adams::step(0.01), time, 1e-12, 1.0, [driven, moving]);
        agree!(Auto::tolerance(1e-6), time, 1e-8, 1.0, [driven, moving]);
    }
    Ok(())
}

#[test]
fn a_driven_slide_is_ground_that_moves_along_a_line() -> Result<(), Box<dyn std::error::Error>> {
    let law = swing([0.3, 4.0, 0.2]);
    let (rod, end) = (Rod::uniform(0.5, 1.0), PointMass::new(0.2, 2.0));
    let (sine, cosine) = LINE.sin_cos();
    let place = move |time: f64| {
        let [place, velocity, acceleration] = law(time).map(|x| [x * cosine, x * sine]);
        GroundMotion { place, velocity, acceleration }
    };
    let slide = Driven::new(Slider::along(LINE), law);
    // A body without mass between the slide and the pin.
    let driven = System::new(
        Clamped::at(0.0, 0.0, 0.0),
        (slide, RigidBody::massless([0.0, 0.0]), Pin, rod, Pin, rod, end),
        Free,
    )?;
    let moving = System::new(Pinned::on(Moving(place)), (rod, Pin, rod, end), Free)?;
    let (driven, moving) = (driven.with_gravity(9.81), moving.with_gravity(9.81));
    agree!(Dop853::tolerance(1e-10), 0.4, 1e-9, 0.0, [driven, moving]);
    agree!(GeneralizedAlpha::new(0.8).step(0.005), 0.4, 1e-9, 0.0, [driven, moving]);
    Ok(())
}

const CRANK: f64 = 0.3; // (m)
const CONROD: f64 = 0.8; // (m)
const MASSES: [f64; 3] = [1.0, 1.5, 2.0]; // crank, connecting rod, piston (kg)
const RATE: f64 = 7.0; // of the crank (rad/s)

/// Kinetic energy of a slider-crank over ½ ω², a function of the crank's angle: by the velocities of mass centres for ω = 1.
fn inertia(angle: f64) -> f64 {
    let (s, c) = angle.sin_cos();
    let (sine, span) = (CRANK * s / CONROD, (CONROD * CONROD - CRANK * CRANK * s * s).sqrt());
    let turning = -CRANK * c / span; // of the connecting rod, whose angle is −asin(sine)
    let piston = -CRANK * s + CONROD * sine * turning;
    let centre = [-CRANK * s + 0.5 * CONROD * sine * turning, CRANK * c + 0.5 * span * turning];
    MASSES[0] * CRANK * CRANK / 3.0
        + MASSES[1] * (centre[0] * centre[0] + centre[1] * centre[1] + CONROD * CONROD / 12.0 * turning * turning)
        + MASSES[2] * piston * piston
}

#[test]
fn a_slider_crank_at_constant_speed_is_its_closed_form() -> Result<(), Box<dyn std::error::Error>> {
    let crank = Driven::new(Revolute::smooth(), |time: f64| [RATE * time, RATE, 0.0]).named("crank");
    let piston = RigidBody::new(MASSES[2], 0.02, [0.0; 2], [0.0; 2]);
    let chain = (crank, Rod::uniform(CRANK, MASSES[0]), Pin, Rod::uniform(CONROD, MASSES[1]), Pin, piston);
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Guided::at(0.0, 0.0, 0.0))?;
    let joint = scene.joint("crank")?;
    let start = scene.with_rates(scene.at_rest(&[0.0, 0.0])?, &[-RATE * CRANK / CONROD, 0.0])?;
    let (mut places, mut torques, mut seen) = (0.0_f64, 0.0_f64, 0);
    scene.simulation(Dop853::tolerance(1e-11)).every(0.01).run(start, 2.0, |now| {
        let angle = RATE * now.time();
        let (s, c) = angle.sin_cos();
        let place = CRANK * c + (CONROD * CONROD - CRANK * CRANK * s * s).sqrt();
        let h = 1e-3;
        let slope = (8.0 * (inertia(angle + h) - inertia(angle - h)) - inertia(angle + 2.0 * h)
            + inertia(angle - 2.0 * h))
            / (12.0 * h);
        let stations = now.stations();
        let torque = stations.joint(joint).map_or(f64::NAN, |station| -station.internal.torque);
        let found = now.bodies().get(2).map_or(f64::NAN, |body| body.inboard.place.x);
        places = places.max((found - place).abs());
        torques = torques.max((torque - 0.5 * RATE * RATE * slope).abs());
        seen += 1;
    })?;
    println!(
        "slider-crank: place to {places:.1e} m, torque to {torques:.1e} N·m of {:.0}",
        MASSES[2] * RATE * RATE * CRANK * CRANK
    );
    assert!(seen == 201 && places < 1e-12 && torques < 1e-8);
    Ok(())
}

const BARS: [f64; 4] = [0.2, 0.5, 0.4, 0.55]; // crank, coupler, rocker, ground (m), of as many kilogrammes

/// Angles of coupler and rocker of a four-bar whose crank has an angle: where two circles meet, above.
fn four_bar(crank: f64) -> [f64; 2] {
    let [a, b, c, d] = BARS;
    let (x, y) = (a * crank.cos() - d, a * crank.sin()); // from the rocker's pin to the crank's end
    let far = x.hypot(y);
    let rocker = y.atan2(x) - ((far * far + c * c - b * b) / (2.0 * far * c)).acos();
    [(c * rocker.sin() - y).atan2(c * rocker.cos() - x), rocker]
}

/// Slope by differences of fourth order.
fn slope_of(f: &dyn Fn(f64) -> f64, at: f64, h: f64) -> f64 {
    (8.0 * (f(at + h) - f(at - h)) - f(at + 2.0 * h) + f(at - 2.0 * h)) / (12.0 * h)
}

/// Its inertia, as of the slider-crank, and its energy of place.
fn four_bar_energies(crank: f64) -> [f64; 2] {
    let [a, b, c, d] = BARS;
    let centres: [&dyn Fn(f64) -> [f64; 3]; 3] = [
        &|at| [0.5 * a * at.cos(), 0.5 * a * at.sin(), at],
        &|at| {
            let coupler = four_bar(at)[0];
            [a * at.cos() + 0.5 * b * coupler.cos(), a * at.sin() + 0.5 * b * coupler.sin(), coupler]
        },
        &|at| {
            let rocker = four_bar(at)[1];
            [d + 0.5 * c * rocker.cos(), 0.5 * c * rocker.sin(), rocker]
        },
    ];
    let (mut inertia, mut place) = (0.0, 0.0);
    for (centre, mass) in centres.into_iter().zip(BARS) {
        let [x, y, turn] = [0, 1, 2].map(|k| slope_of(&|at| centre(at)[k], crank, 1e-3));
        inertia += mass * (x * x + y * y + mass * mass / 12.0 * turn * turn); // as long as heavy
        place += 9.81 * mass * centre(crank)[1];
    }
    [inertia, place]
}

#[test]
fn a_driven_crank_leads_a_loop() -> Result<(), Box<dyn std::error::Error>> {
    let [crank, coupler, rocker, ground] = BARS;
    let rod = |length: f64| Rod::uniform(length, length);
    let drive = Driven::new(Revolute::smooth(), |time: f64| [0.4 + RATE * time, RATE, 0.0]).named("crank");
    let main = (drive, rod(crank), Pin, rod(coupler));
    let side = (RigidBody::massless([ground, 0.0]), Pin, rod(rocker));
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), Network::new(main, side, Pin), Free)?.with_gravity(9.81);
    let angles = |time: f64| four_bar(0.4 + RATE * time);
    let rates = [0, 1].map(|k| slope_of(&|time| angles(time)[k], 0.0, 1e-4));
    let start = scene.with_rates(scene.at_rest(&angles(0.0))?, &rates)?;
    let joint = scene.joint("crank")?;
    let (mut places, mut torques) = (0.0_f64, 0.0_f64);
    scene.simulation(Dop853::tolerance(1e-11)).every(0.05).run(start, 2.0, |now| {
        let (angle, found) = (0.4 + RATE * now.time(), now.motion().coordinates());
        for (found, expected) in found.iter().zip(four_bar(angle)) {
            places = places.max((found.sin() - expected.sin()).abs().max((found.cos() - expected.cos()).abs()));
        }
        let [inertia, weight] = [0, 1].map(|k| slope_of(&|at| four_bar_energies(at)[k], angle, 2e-3));
        let torque = now.stations().joint(joint).map_or(f64::NAN, |station| -station.internal.torque);
        torques = torques.max((torque - 0.5 * RATE * RATE * inertia - weight).abs());
    })?;
    println!("four-bar: angles to {places:.1e}, torque to {torques:.1e} N·m");
    assert!(places < 1e-9 && torques < 1e-6);
    Ok(())
}

#[test]
fn work_of_drives_is_energy_and_what_dampers_take() -> Result<(), Box<dyn std::error::Error>> {
    const STEP: f64 = 2e-3;
    let [crank, _, wrist] = LAWS.map(swing);
    let drive = |law| Driven::new(Revolute::smooth(), law);
    let (rod, damping) = (Rod::uniform(0.5, 1.0), 0.3);
    let damped = ElasticHinge::rotary(5.0).damped(damping);
    let arm = Branch((Driven::new(Revolute::smooth(), wrist).named("wrist"), rod));
    let chain = (drive(crank).named("crank"), rod, damped, rod, arm, Pin, rod);
    let scene = System::new(Clamped::at(0.0, 0.0, 0.0), chain, Free)?.with_gravity(9.81);
    let joints = [scene.joint("crank")?, scene.joint("wrist")?];
    let mut samples = vec![];
    scene.simulation(Dop853::tolerance(1e-12)).every(STEP).run(scene.at_rest(&[0.2, -1.0])?, 2.0, |now| {
        let (time, stations) = (now.time(), now.stations());
        let effort = |k: usize| stations.joint(joints[k]).map_or(f64::NAN, |station| -station.internal.torque);
        let [bend, _] = now.motion().rates()[..] else { return };
        let power = effort(0) * crank(time)[1] + effort(1) * wrist(time)[1] - damping * bend * bend;
        samples.push((now.energy(), power));
    })?;
    // Simpson's rule.
    let n = samples.len() - 1;
    let weight = |k: usize| {
        if k == 0 || k == n {
            1.0
        } else if k % 2 == 1 {
            4.0
        } else {
            2.0
        }
    };
    let work: f64 = samples.iter().enumerate().map(|(k, (_, power))| weight(k) * power * STEP / 3.0).sum();
    let change = samples[n].0 - samples[0].0;
    println!("work {work:.12} J, change of energy {change:.12} J");
    assert!(n == 1000 && change.abs() > 0.1);
    near(work, change, 1e-9);
    Ok(())
}

/// The place of the tip of an arm whose crank swings with an amplitude, after a second, and the torque of the crank.
fn arm<T: Scalar<Real = f64>>(amplitude: T, length: T) -> Result<[T; 3], Box<dyn std::error::Error>> {
    let of = T::literal;
    let law = move |time: f64| {
        let (s, c) = (2.0 * time).sin_cos();
        [amplitude * of(s), amplitude * of(2.0 * c), amplitude * of(-4.0 * s)]
    };
    let rod = Rod::uniform(length, of(1.0));
    let chain = (rod, Driven::new(Revolute::smooth(), law).named("crank"), rod, Pin, rod);
    let scene = System::new(Pinned::origin(), chain, Free)?.with_gravity(of(9.81));
    let start = scene.at_rest(&[of(-1.0), of(0.4)])?;
    let end = scene.simulation(Rk4::step(0.005)).run(start, 1.0, |_| ()).map_err(|end| end.error)?.motion;
    let end = scene.with_accelerations(end, &Unloaded)?;
    let stations = scene.stations(&end, &Unloaded)?;
    let torque = stations.joint(scene.joint("crank")?).ok_or("no crank")?.internal.torque;
    let tip = stations.tip().frame.place;
    Ok([tip.x, tip.y, torque])
}

#[test]
fn derivatives_pass_through_a_drive() -> Result<(), Box<dyn std::error::Error>> {
    let found = arm(Jet::<f64, 2>::seed(0.7, 0), Jet::seed(0.5, 1))?;
    let h = 2e-4;
    for (seed, by) in [[1.0, 0.0], [0.0, 1.0]].into_iter().enumerate() {
        let at = |x: f64| arm(0.7 + x * by[0], 0.5 + x * by[1]);
        let [a, b, c, d] = [at(2.0 * h)?, at(h)?, at(-h)?, at(-2.0 * h)?];
        for k in 0..3 {
            let expected = (8.0 * (b[k] - c[k]) - a[k] + d[k]) / (12.0 * h);
            assert!(expected.abs() > 1e-3);
            near(found[k].eps[seed], expected, 1e-8 * (1.0 + expected.abs()));
        }
    }
    Ok(())
}

#[test]
fn a_drive_that_stands_is_a_weld() -> Result<(), Box<dyn std::error::Error>> {
    let rod = Rod::uniform(0.5, 1.0);
    let hinge = ElasticHinge::rotary(20.0);
    let chain = |at: f64| (rod, Driven::new(Revolute::smooth(), move |_: f64| [at, 0.0, 0.0]), rod, hinge, rod);
    let welded = System::new(Pinned::origin(), (rod, Weld::at(0.5), rod, hinge, rod), Free)?.with_gravity(9.81);
    let held = System::new(Pinned::origin(), chain(0.5), Free)?.with_gravity(9.81);
    macro_rules! modes {
        ($scene:expr) => {{
            let rest = $scene.equilibrium($scene.at_rest(&[-1.8, -1.3])?, &Unloaded)?;
            $scene.modes(&rest, &Unloaded)?.frequencies().collect::<Vec<f64>>()
        }};
    }
    let expected = modes!(welded);
    let found = modes!(held);
    assert_eq!(found.len(), 2);
    found.iter().zip(&expected).for_each(|(found, expected)| near(*found, *expected, 1e-9));
    // Bodies beyond a drive take the spin asked for.
    let spinning =
        System::new(Pinned::origin(), (rod, Driven::new(Revolute::smooth(), swing(LAWS[0])), rod, Pin, rod), Free)?;
    let motion = spinning.with_body_spin(spinning.motion().at_time(0.3), 2_usize, Inertial(4.0))?;
    near(spinning.body_motions(&motion)?.get(2).map_or(f64::NAN, |body| body.rate()), 4.0, 1e-14);
    // Also where a drive turns them against the joint that does.
    let crank = Driven::new(Revolute::smooth(), |t: f64| [3.0 * t, 3.0, 0.0]);
    let spinning = System::new(Pinned::origin(), (rod, crank, rod), Free)?;
    let motion = spinning.with_body_spin(spinning.motion(), 1_usize, Inertial(2.0))?;
    near(spinning.body_motions(&motion)?.get(1).map_or(f64::NAN, |body| body.rate()), 2.0, 1e-14);
    assert_eq!(motion.rates(), [-1.0]);
    Ok(())
}

#[test]
fn laws_that_are_not_finite_are_told_where_and_when() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 1.0);
    let crank = Driven::new(Revolute::smooth(), |t: f64| [t.recip(), -t.powi(-2), 2.0 * t.powi(-3)]);
    let scene = System::new(Pinned::origin(), (rod, crank, rod), Free)?.with_gravity(9.81);
    let run = |time| {
        let end = scene.simulation(Dop853::tolerance(1e-9)).run(scene.motion().at_time(time), time + 0.5, |_| ());
        end.map(|_| ()).map_err(|end| end.error)
    };
    let refused = run(0.0);
    let Err(Error { fault: Fault::NotFinite { parameter: "driven coordinate" }, time: Some(0.0), place }) = refused
    else {
        panic!("{refused:?}")
    };
    assert_eq!(place, Some(Place::Station(1)));
    assert!(run(2.0).is_ok());
    Ok(())
}

#[test]
fn positions_of_another_motion_take_the_time_of_theirs() -> Result<(), Error> {
    let rod = Rod::uniform(0.5, 1.0);
    let crank = Driven::new(Revolute::smooth(), swing(LAWS[0]));
    let scene = System::new(Pinned::origin(), (rod, crank, rod), Free)?.with_gravity(9.81);
    let mut mixed = scene.motion().at_time(0.7);
    mixed.position_mut().clone_from(scene.motion().at_time(0.2).position());
    let whole = scene.motion().at_time(0.7);
    let accelerations = |motion| Ok::<_, Error>(scene.with_accelerations(motion, &Unloaded)?.accelerations());
    assert_eq!(accelerations(mixed)?, accelerations(whole)?);
    let end = |start| Ok::<_, Error>(scene.simulation(Rk4::step(0.01)).run(start, 0.9, |_| ())?.motion.coordinates());
    assert_eq!(end(mixed)?, end(whole)?);
    Ok(())
}
