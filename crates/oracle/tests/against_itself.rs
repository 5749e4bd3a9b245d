//! The dense oracle against closed forms: nothing here touches the crate.

use catena_oracle::plane::{
    Answer, Axes, Body, Coordinates, Elastic, Ground, Joint, Load, Scene, State, Tip, Vector, add, cross, dot,
    extrapolate, perp, rotate, scale, sub,
};

const G: f64 = 9.81;

/// Accelerations and forces here are of the order 1 to 100 and come from a refined dense solve: a few rounding errors
/// of 1e-14 are left, with a margin for other platforms' sines.
const ROUNDING: f64 = 1e-12;

#[track_caller]
fn near(found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(error <= tolerance, "found {found:.16e}, expected {expected:.16e}, error {error:.1e}");
}

#[track_caller]
fn near2(found: Vector, expected: Vector, tolerance: f64) {
    near(found[0], expected[0], tolerance);
    near(found[1], expected[1], tolerance);
}

/// Numbers in -1 .. 1 without any pattern (a 64 bit linear congruential generator, upper bits).
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> Vector {
        [self.next(), self.next()]
    }

    fn body(&mut self) -> Body {
        Body {
            mass: 1.5 + self.next(),
            inertia_c: 0.3 + 0.2 * self.next(),
            centre: scale(0.5, self.vector()),
            outboard: add([1.0, 0.0], scale(0.4, self.vector())),
        }
    }

    fn ground(&mut self) -> Ground {
        Ground {
            position: self.vector(),
            velocity: self.vector(),
            acceleration: self.vector(),
            angle: self.next(),
            rate: self.next(),
            angular_acceleration: self.next(),
        }
    }

    fn coordinates(&mut self, joint: &Joint) -> Coordinates {
        let angle = Coordinates::angle(2.0 * self.next(), 2.0 * self.next());
        match joint {
            Joint::Free | Joint::Elastic(_) => Coordinates { u: self.vector(), u_rate: self.vector(), ..angle },
            Joint::Pin | Joint::Rotary { .. } => angle,
            Joint::Weld => Coordinates::angle(angle.phi, 0.0),
            Joint::Slider { axis, .. } => Coordinates::along(*axis, self.next(), self.next(), angle.phi),
            Joint::Slot { axis } => Coordinates {
                phi_rate: angle.phi_rate,
                ..Coordinates::along(*axis, self.next(), self.next(), angle.phi)
            },
        }
    }

    fn elastic(&mut self, axes: Axes) -> Joint {
        let mut three = |least: f64| [0; 3].map(|_| least + self.next());
        Joint::Elastic(Elastic { stiffness: three(20.0), damping: three(1.2), rest: three(0.0), axes })
    }

    fn load(&mut self, body: usize) -> Load {
        Load { body, point: self.vector(), force: scale(5.0, self.vector()), torque: self.next() }
    }
}

/// A chain with every kind of joint on moving ground, its state, joint torques and loads. The root joint changes with
/// `round`; every other chain has a guided tip.
fn mixed_chain(noise: &mut Noise, round: usize) -> (Scene, State, Vec<f64>, Vec<Load>) {
    let roots = [
        Joint::Slot { axis: noise.vector() },
        Joint::Slider { axis: noise.vector(), spring: [9.0, 0.4, 0.2] },
        noise.elastic(Axes::Inboard),
        noise.elastic(Axes::Fixed),
        noise.elastic(Axes::FixedUnbalanced),
        Joint::Pin,
        Joint::Weld,
        Joint::Free,
    ];
    let joints = vec![
        roots[round / 2 % roots.len()],
        Joint::Rotary { stiffness: 7.0, damping: 0.8, rest: 0.3 },
        noise.elastic(Axes::Inboard),
        Joint::Slider { axis: noise.vector(), spring: [9.0, 0.4, 0.2] },
        Joint::Pin,
        noise.elastic(Axes::Fixed),
        Joint::Weld,
        Joint::Pin,
        Joint::Slot { axis: noise.vector() },
    ];
    let tip = if round.is_multiple_of(2) { Tip::guided(noise.ground(), noise.vector()) } else { Tip::Free };
    let scene = Scene {
        bodies: joints.iter().map(|_| noise.body()).collect(),
        ground: noise.ground(),
        tip,
        gravity: [1.3, -G],
        joints,
    };
    let coordinates: Vec<Coordinates> = scene.joints.iter().map(|j| noise.coordinates(j)).collect();
    let state = scene.project(&scene.place(&coordinates));
    let torques = scene.joints.iter().map(|_| 3.0 * noise.next()).collect();
    let loads = vec![noise.load(0), noise.load(3), noise.load(8), noise.load(3)];
    (scene, state, torques, loads)
}

fn solve(scene: &Scene, state: &State) -> Answer {
    scene.solve(state, &[], &[])
}

// --- single bodies ---

#[test]
fn a_physical_pendulum_with_an_offset_mass_centre_turns_as_its_moment_says() {
    let body = Body { mass: 2.3, inertia_c: 0.17, centre: [0.4, -0.25], outboard: [1.1, 0.2] };
    let scene = Scene::pinned(vec![body]);
    for (angle, rate) in [(0.0, 0.0), (1.1, 2.0), (-2.7, -3.5), (40.0, 1.0)] {
        let a = solve(&scene, &scene.assemble(&[angle], &[rate]));
        let arm = rotate(angle, body.centre);
        let alpha = body.mass * cross(arm, scene.gravity) / (body.inertia_c + body.mass * dot(arm, arm));
        let acceleration_c = sub(scale(alpha, perp(arm)), scale(rate * rate, arm));
        near(a.angular_acceleration[0], alpha, ROUNDING);
        near2(a.acceleration_c[0], acceleration_c, ROUNDING);
        near2(a.acceleration[0], [0.0, 0.0], ROUNDING);
        near2(a.q_inboard[0], scale(body.mass, sub(acceleration_c, scene.gravity)), ROUNDING);
        near(a.m_inboard[0], 0.0, 0.0);
        near2(a.q_outboard[0], [0.0, 0.0], 0.0);
    }
}

#[test]
fn an_accelerated_pivot_is_felt_as_gravity_the_other_way() {
    let mut moving = Scene::pinned(vec![Body::rod(1.2, 0.9), Body::rod(0.7, 1.3)]);
    let mut resting = moving.clone();
    moving.ground.acceleration = [3.0, -2.0];
    resting.gravity = sub(resting.gravity, moving.ground.acceleration);
    let state = moving.assemble(&[0.3, -1.0], &[1.0, 2.0]);
    let (a, b) = (solve(&moving, &state), solve(&resting, &state));
    for k in 0..2 {
        near(a.angular_acceleration[k], b.angular_acceleration[k], ROUNDING);
        near2(a.q_inboard[k], b.q_inboard[k], ROUNDING);
        near2(a.acceleration[k], add(b.acceleration[k], [3.0, -2.0]), ROUNDING);
    }
}

#[test]
fn a_free_floating_body_under_an_off_centre_force_shifts_and_turns() {
    let body = Body { mass: 3.0, inertia_c: 0.5, centre: [0.2, 0.1], outboard: [1.0, 0.0] };
    let mut scene = Scene::pinned(vec![body]);
    scene.joints[0] = Joint::Free;
    scene.gravity = [0.0, 0.0];
    let state = scene.place(&[Coordinates { u: [4.0, 5.0], phi: 0.7, u_rate: [1.0, -1.0], phi_rate: 2.0 }]);
    let load = Load { body: 0, point: [1.0, 0.3], force: [6.0, -9.0], torque: 0.4 };
    let a = scene.solve(&state, &[], &[load]);
    let arm = rotate(0.7, sub(load.point, body.centre));
    let alpha = (0.4 + cross(arm, load.force)) / 0.5;
    let to_inboard = rotate(0.7, scale(-1.0, body.centre));
    near2(a.acceleration_c[0], [2.0, -3.0], ROUNDING);
    near(a.angular_acceleration[0], alpha, ROUNDING);
    near2(a.acceleration[0], add([2.0, -3.0], sub(scale(alpha, perp(to_inboard)), scale(4.0, to_inboard))), ROUNDING);
    near2(a.q_inboard[0], [0.0, 0.0], 0.0);
}

#[test]
fn a_sliding_ladder_falls_as_in_the_textbook() {
    // I at the top on the wall x = 0, O at the foot on the floor y = 0, both smooth; beta is the angle at the foot.
    let (mass, length, beta, beta_rate) = (4.0, 2.5, 0.9_f64, -0.6);
    let mut scene = Scene::pinned(vec![Body::rod(mass, length)]);
    scene.joints[0] = Joint::Slot { axis: [0.0, 3.0] };
    scene.tip = Tip::rolling(Ground::default(), [1.0, 0.0]);
    let (s, c) = beta.sin_cos();
    let top =
        Coordinates { u_rate: [0.0, length * c * beta_rate], ..Coordinates::along([0.0, 1.0], length * s, 0.0, -beta) };
    let state = scene.place(&[Coordinates { phi_rate: -beta_rate, ..top }]);
    let [position, velocity] = scene.violation(&state);
    assert!(position < 1e-15 && velocity < 1e-15); // one rounding of numbers near one
    let a = solve(&scene, &state);
    let beta_acc = -1.5 * G / length * c;
    let a_c = [
        -0.5 * length * (s * beta_acc + c * beta_rate * beta_rate),
        0.5 * length * (c * beta_acc - s * beta_rate * beta_rate),
    ];
    near(a.angular_acceleration[0], -beta_acc, ROUNDING);
    near2(a.acceleration_c[0], a_c, ROUNDING);
    near2(a.q_inboard[0], [mass * a_c[0], 0.0], ROUNDING); // the wall pushes along x only
    near2(a.tip_force, [0.0, mass * (G + a_c[1])], ROUNDING);
    near2(a.q_outboard[0], [0.0, -mass * (G + a_c[1])], ROUNDING);
    near(a.m_outboard[0], 0.0, 0.0);
}

#[test]
fn a_bead_in_a_turning_tube_feels_centrifugal_coriolis_and_euler_forces() {
    // The tube passes the axis of rotation at the distance h.
    let (psi, w, alpha, s, s_rate, h, mass, inertia) = (0.8, 1.7, -2.2, 0.6, 0.9, 0.2, 1.4, 0.05);
    let mut scene = Scene::pinned(vec![Body { mass, inertia_c: inertia, centre: [0.0; 2], outboard: [1.0, 0.0] }]);
    scene.joints[0] = Joint::Slider { axis: [1.0, 0.0], spring: [0.0; 3] };
    scene.ground = Ground { angle: psi, rate: w, angular_acceleration: alpha, ..Ground::default() };
    let state = scene.place(&[Coordinates { u: [s, h], ..Coordinates::along([1.0, 0.0], s, s_rate, 0.4) }]);
    let a = solve(&scene, &state);
    let (e, n) = (rotate(psi, [1.0, 0.0]), rotate(psi, [0.0, 1.0]));
    let s_acc = w * w * s + alpha * h + dot(scene.gravity, e);
    let lateral = mass * (alpha * s + 2.0 * w * s_rate - w * w * h - dot(scene.gravity, n));
    let (u_acc, phi_acc) = scene.coordinate_accelerations(&state, &a)[0];
    near2(u_acc, [s_acc, 0.0], ROUNDING);
    near(phi_acc, 0.0, ROUNDING);
    near2(a.q_inboard[0], scale(lateral, n), ROUNDING);
    near(a.m_inboard[0], -inertia * alpha, ROUNDING);
    // The ground's face is at the ground point: its torque also holds the moment of the lateral force.
    near(a.m_ground, -inertia * alpha - s * lateral, ROUNDING);
}

#[test]
fn a_torsion_spring_a_damper_and_a_motor_add_up_at_a_rotary_root() {
    let mut scene = Scene::pinned(vec![Body::rod(1.0, 2.0)]);
    scene.gravity = [0.0, 0.0];
    scene.joints[0] = Joint::Rotary { stiffness: 5.0, damping: 0.7, rest: 0.2 };
    scene.ground.angle = 0.1;
    scene.ground.rate = 0.5;
    let state = scene.assemble(&[1.3], &[-0.4]);
    let a = scene.solve(&state, &[2.5], &[]);
    let torque = 2.5 - 5.0 * (1.3 - 0.1 - 0.2) - 0.7 * (-0.4 - 0.5);
    near(a.angular_acceleration[0], torque / (4.0 / 3.0), ROUNDING); // m L^2 / 3 about the pin
    near(a.m_inboard[0], -torque, ROUNDING);
    near(a.m_ground, -torque, ROUNDING);
}

#[test]
fn a_guided_tip_leaves_one_translation_and_carries_the_rest() {
    // A body on three springs at I = (1.5, 0.5), its O guided along x without turning.
    let (mass, stretch) = (2.0, [0.3, 0.2, 0.1]);
    let body = Body { mass, inertia_c: 0.4, centre: [0.5, 0.0], outboard: [1.0, 0.0] };
    let mut scene = Scene::pinned(vec![body]);
    let rest = [1.5 - stretch[0], 0.5 - stretch[1], -stretch[2]];
    let elastic = Elastic { stiffness: [50.0, 60.0, 70.0], damping: [0.0; 3], rest, axes: Axes::Fixed };
    scene.joints[0] = Joint::Elastic(elastic);
    scene.tip = Tip::guided(Ground::at([0.0, 0.5]), [1.0, 0.0]);
    let state = scene.place(&[Coordinates { u: [1.5, 0.5], u_rate: [0.7, 0.0], ..Coordinates::default() }]);
    let a = solve(&scene, &state);
    let q = [-50.0 * 0.3, -60.0 * 0.2];
    near2(a.acceleration_c[0], [q[0] / mass, 0.0], ROUNDING);
    near2(a.q_inboard[0], q, ROUNDING);
    near2(a.tip_force, [0.0, mass * G - q[1]], ROUNDING);
    // Moments about C: spring torque -70 * 0.1, q at the arm -0.5, the tip force at the arm +0.5.
    let torque = 70.0 * 0.1 + 0.5 * q[1] - 0.5 * (mass * G - q[1]);
    near(a.tip_torque, torque, ROUNDING);
    near(a.m_outboard[0], torque, ROUNDING);
    near(a.tip_ground_torque, -torque - 2.5 * (mass * G - q[1]), ROUNDING); // the ground point is 2.5 before O
}

// --- chains ---

#[test]
fn a_free_chain_falls_without_any_section_load() {
    let mut noise = Noise(1);
    let mut scene = Scene::pinned((0..6).map(|_| noise.body()).collect());
    scene.joints[0] = Joint::Free;
    scene.joints[3] = Joint::Weld;
    scene.joints[5] = Joint::Slider { axis: [1.0, 2.0], spring: [0.0; 3] };
    let state = scene.place(&[Coordinates::angle(0.4, 0.0); 6]); // at rest
    let a = solve(&scene, &state);
    for k in 0..6 {
        near2(a.acceleration[k], [0.0, -G], ROUNDING);
        near(a.angular_acceleration[k], 0.0, ROUNDING);
        near2(a.q_inboard[k], [0.0, 0.0], ROUNDING);
        near(a.m_inboard[k], 0.0, ROUNDING);
    }
}

#[test]
fn two_point_masses_on_a_pinned_beam_move_as_on_an_atwood_machine() {
    // The pin is in the middle between the masses: the lighter one is all of the beam's mass, the heavier one is welded
    // to the beam's other end.
    let (left, right, r) = (2.0, 3.5, 0.8);
    let beam = Body { mass: left, inertia_c: 0.0, centre: [-r, 0.0], outboard: [r, 0.0] };
    let weight = Body { mass: right, inertia_c: 0.0, centre: [0.0; 2], outboard: [0.0; 2] };
    let mut scene = Scene::pinned(vec![beam, weight]);
    scene.joints[1] = Joint::Weld;
    let a = solve(&scene, &scene.assemble(&[0.0, 0.0], &[0.0, 0.0]));
    let sinking = G * (right - left) / (right + left);
    near2(a.acceleration_c[0], [0.0, sinking], ROUNDING);
    near2(a.acceleration_c[1], [0.0, -sinking], ROUNDING);
    near2(a.q_inboard[1], [0.0, right * (G - sinking)], ROUNDING); // the "rope" force 2 m1 m2 g / (m1 + m2)
    near2(a.q_inboard[0], [0.0, 4.0 * left * right * G / (left + right)], ROUNDING);
    near(a.m_inboard[1], 0.0, ROUNDING);
}

#[test]
fn the_double_pendulum_obeys_the_equations_of_lagrange() {
    // With r = R(t0) O_0 and s = R(t1) C_1, T = (J_0 + m_0 |C_0|^2 + m_1 r.r) w0^2 / 2 + (J_1 + m_1 s.s) w1^2 / 2
    // + m_1 r.s w0 w1, where d(r.s)/dt0 = r x s = -d(r.s)/dt1, and the torques are those of the weights and motors.
    let mut noise = Noise(2);
    for _ in 0..50 {
        let (b0, b1) = (noise.body(), noise.body());
        let scene = Scene::pinned(vec![b0, b1]);
        let (t, w, tau) = ([0; 2].map(|_| 3.0 * noise.next()), scale(4.0, noise.vector()), scale(5.0, noise.vector()));
        let a = scene.solve(&scene.assemble(&t, &w), &tau, &[]);

        let (c0, r, s) = (rotate(t[0], b0.centre), rotate(t[0], b0.outboard), rotate(t[1], b1.centre));
        let m00 = b0.inertia_c + b0.mass * dot(c0, c0) + b1.mass * dot(r, r);
        let m11 = b1.inertia_c + b1.mass * dot(s, s);
        let m01 = b1.mass * dot(r, s);
        let g = scene.gravity;
        let f0 = cross(add(scale(b0.mass, c0), scale(b1.mass, r)), g) + tau[0] - tau[1];
        let right0 = f0 + b1.mass * cross(r, s) * w[1] * w[1];
        let right1 = b1.mass * cross(s, g) + tau[1] - b1.mass * cross(r, s) * w[0] * w[0];
        let det = m00 * m11 - m01 * m01;
        // The determinant of the mass matrix may be a tenth of its entries: some more rounding on both sides.
        near(a.angular_acceleration[0], (m11 * right0 - m01 * right1) / det, 10.0 * ROUNDING);
        near(a.angular_acceleration[1], (m00 * right1 - m01 * right0) / det, 10.0 * ROUNDING);
        near(a.m_inboard[0], -tau[0], ROUNDING);
        near(a.m_outboard[0], -tau[1], ROUNDING);
        near(a.m_inboard[1], -tau[1], ROUNDING);
    }
}

#[test]
fn a_clamped_chain_at_rest_carries_its_loads_to_the_ground() {
    let mut scene = Scene::pinned(vec![Body::rod(2.0, 1.0), Body::rod(3.0, 2.0)]);
    scene.joints = vec![Joint::Weld; 2];
    let (t0, t1) = (0.5_f64, -0.3_f64);
    let state = scene.assemble(&[t0, t1], &[0.0, 0.0]);
    let load = Load { body: 1, point: [2.0, 0.0], force: [7.0, 4.0], torque: 1.5 };
    let a = scene.solve(&state, &[0.9, -0.6], &[load]); // motors at welds change nothing
    let weight = [[0.0, -2.0 * G], [0.0, -3.0 * G]];
    let elbow = rotate(t0, [1.0, 0.0]);
    let (along, tip) = (rotate(t1, [1.0, 0.0]), add(elbow, rotate(t1, [2.0, 0.0])));
    let q1 = scale(-1.0, add(weight[1], load.force));
    let moment_at_elbow = cross(along, weight[1]) + cross(sub(tip, elbow), load.force) + load.torque;
    let moment_at_root = cross(scale(0.5, elbow), weight[0])
        + cross(add(elbow, along), weight[1])
        + cross(tip, load.force)
        + load.torque;
    near(a.angular_acceleration[0], 0.0, ROUNDING);
    near(a.angular_acceleration[1], 0.0, ROUNDING);
    near2(a.q_inboard[1], q1, ROUNDING);
    near2(a.q_outboard[0], q1, ROUNDING);
    near2(a.q_inboard[0], sub(q1, weight[0]), ROUNDING);
    // The ground holds with the torque -moment, and m is minus the torque that the inboard side gives.
    near(a.m_inboard[1], moment_at_elbow, ROUNDING);
    near(a.m_outboard[0], moment_at_elbow, ROUNDING);
    near(a.m_inboard[0], moment_at_root, ROUNDING);
    near(a.m_ground, moment_at_root, ROUNDING);
}

#[test]
fn a_three_hinged_arch_thrusts_with_half_a_weight_over_the_tangent() {
    let (mass, length, beta) = (5.0, 2.0, 0.6_f64);
    let mut scene = Scene::pinned(vec![Body::rod(mass, length); 2]);
    scene.tip = Tip::pinned(Ground::at([2.0 * length * beta.cos(), 0.0]));
    let a = solve(&scene, &scene.assemble(&[beta, -beta], &[0.0, 0.0]));
    let thrust = 0.5 * mass * G / beta.tan();
    near(a.angular_acceleration[0], 0.0, ROUNDING);
    near2(a.q_inboard[0], [thrust, mass * G], 10.0 * ROUNDING); // forces of the order 50
    near2(a.q_inboard[1], [thrust, 0.0], 10.0 * ROUNDING);
    near2(a.tip_force, [-thrust, mass * G], 10.0 * ROUNDING);
    near2(a.q_outboard[1], [thrust, -mass * G], 10.0 * ROUNDING);
}

#[test]
fn a_parallelogram_linkage_swings_as_one_pendulum() {
    // Cranks of length r, a coupler of length d that only translates: (2 m r^2 / 3 + m_c r^2) t'' = weights' moment.
    let (crank, coupler, r, d) = (Body::rod(1.1, 0.7), Body::rod(2.6, 1.5), 0.7, 1.5);
    let mut scene = Scene::pinned(vec![crank, coupler, crank]);
    scene.tip = Tip::pinned(Ground::at([d, 0.0]));
    let (t, w) = (0.8_f64, -1.9);
    let state = scene.assemble(&[t, 0.0, t + std::f64::consts::PI], &[w, 0.0, w]);
    let a = solve(&scene, &state);
    let alpha = -G * r * t.cos() * (crank.mass + coupler.mass) / (r * r * (2.0 / 3.0 * crank.mass + coupler.mass));
    near(a.angular_acceleration[0], alpha, 10.0 * ROUNDING); // near the fold of the linkage the condition grows
    near(a.angular_acceleration[1], 0.0, 10.0 * ROUNDING);
    near(a.angular_acceleration[2], alpha, 10.0 * ROUNDING);
}

#[test]
fn a_spring_pendulum_follows_its_polar_equations() {
    // A mass slides on a pinned rod, tied to the pin by a spring k (r - l), which enters as a pair of loads:
    // m (r'' - r w^2) = m g.e - k (r - l), (J + m r^2) w' + 2 m r r' w = moments of the weights.
    let (k, l, m, t, w, r, r_rate) = (30.0, 0.8, 1.7, -1.2, 2.1, 1.1, -0.4);
    let rod = Body { mass: 0.9, inertia_c: 0.2, centre: [0.6, 0.1], outboard: [0.0, 0.0] };
    let bead = Body { mass: m, inertia_c: 0.03, centre: [0.0; 2], outboard: [0.0; 2] };
    let mut scene = Scene::pinned(vec![rod, bead]);
    scene.joints[1] = Joint::Slider { axis: [2.0, 0.0], spring: [0.0; 3] };
    let state = scene.place(&[Coordinates::angle(t, w), Coordinates::along([1.0, 0.0], r, r_rate, 0.0)]);
    let e = rotate(t, [1.0, 0.0]);
    let pull = scale(-k * (r - l), e);
    let loads = [
        Load { body: 1, point: [0.0, 0.0], force: pull, torque: 0.0 },
        Load { body: 0, point: [r, 0.0], force: scale(-1.0, pull), torque: 0.0 },
    ];
    let a = scene.solve(&state, &[], &loads);
    let arm = rotate(t, rod.centre);
    let moment = rod.mass * cross(arm, scene.gravity) + m * r * cross(e, scene.gravity);
    let inertia = 0.2 + rod.mass * dot(arm, arm) + 0.03 + m * r * r;
    let alpha = (moment - 2.0 * m * r * r_rate * w) / inertia;
    let second = scene.coordinate_accelerations(&state, &a);
    near(a.angular_acceleration[0], alpha, ROUNDING);
    near(second[1].0[0], r * w * w + dot(scene.gravity, e) - k * (r - l) / m, ROUNDING);
    near(second[1].0[1], 0.0, ROUNDING);
}

#[test]
fn an_elastic_hinge_pulls_in_the_axes_of_the_inboard_body_and_reacts_at_the_same_point() {
    // Body 0 is pinned at the origin, where also its O is, so that d is the position of body 1, whose C is at I.
    let base = Body { mass: 1.3, inertia_c: 0.4, centre: [0.3, -0.2], outboard: [0.0; 2] };
    let mass = Body { mass: 0.8, inertia_c: 0.05, centre: [0.0; 2], outboard: [1.0, 0.0] };
    let (k, c, rest) = ([40.0, 90.0, 6.0], [0.5, 0.9, 0.3], [0.7, 0.1, 0.2]);
    let (t, w, motor) = (0.6, -1.4, 1.1);
    let link = Coordinates { u: [0.9, 0.25], phi: 0.5, u_rate: [0.3, -0.8], phi_rate: 2.0 };
    for axes in [Axes::Inboard, Axes::Fixed, Axes::FixedUnbalanced] {
        let mut scene = Scene::pinned(vec![base, mass]);
        scene.joints[1] = Joint::Elastic(Elastic { stiffness: k, damping: c, rest, axes });
        let state = scene.place(&[Coordinates::angle(t, w), link]);
        let a = scene.solve(&state, &[0.0, motor], &[]);
        let turn = if axes == Axes::Inboard { t } else { 0.0 };
        let d = rotate(turn, link.u);
        let pull = |i: usize| -k[i] * (link.u[i] - rest[i]) - c[i] * link.u_rate[i];
        let force = rotate(turn, [pull(0), pull(1)]);
        let torque = motor - k[2] * (link.phi - rest[2]) - c[2] * link.phi_rate;
        let moment = if axes == Axes::FixedUnbalanced { 0.0 } else { cross(d, force) };
        let arm = rotate(t, base.centre);
        let inertia = base.inertia_c + base.mass * dot(arm, arm);
        near2(state.position[1], d, ROUNDING);
        near2(a.acceleration_c[1], add(scale(1.0 / 0.8, force), scene.gravity), ROUNDING);
        near(a.angular_acceleration[1], torque / 0.05, 10.0 * ROUNDING); // of the order 50
        let on_base = base.mass * cross(arm, scene.gravity) - torque - moment;
        near(a.angular_acceleration[0], on_base / inertia, 10.0 * ROUNDING);
        near2(a.q_inboard[1], force, ROUNDING);
        near2(a.q_outboard[0], force, ROUNDING);
        near(a.m_inboard[1], -torque, ROUNDING);
        near(a.m_outboard[0], -torque - moment, ROUNDING); // so m behind the joint = m before it + d x q
    }
}

#[test]
fn a_beam_clamped_at_both_ends_is_solved_by_singular_values() {
    let mut scene = Scene::pinned(vec![Body::rod(2.0, 1.0); 2]);
    scene.joints = vec![Joint::Weld; 2];
    scene.tip = Tip::clamped(Ground::at([2.0, 0.0]));
    let state = scene.assemble(&[0.0, 0.0], &[0.0, 0.0]);
    let a = scene.solve_redundant(&state, &[], &[]);
    for k in 0..2 {
        near2(a.acceleration_c[k], [0.0, 0.0], ROUNDING);
        near(a.angular_acceleration[k], 0.0, ROUNDING);
    }
    near2(add(a.q_inboard[0], a.tip_force), [0.0, 4.0 * G], 10.0 * ROUNDING);
    assert!(scene.balance_defect(&state, &[], &a) < 10.0 * ROUNDING); // forces of the order 50
}

#[test]
fn singular_values_and_elimination_agree_where_nothing_is_redundant() {
    let (scene, state, torques, loads) = mixed_chain(&mut Noise(5), 0);
    let (a, b) = (scene.solve(&state, &torques, &loads), scene.solve_redundant(&state, &torques, &loads));
    for k in 0..scene.bodies.len() {
        // Singular values see the unscaled matrix of condition some thousand and values of the order 100.
        near2(a.acceleration[k], b.acceleration[k], 1e-10);
        near(a.angular_acceleration[k], b.angular_acceleration[k], 1e-10);
        near2(a.q_inboard[k], b.q_inboard[k], 1e-10);
        near(a.m_inboard[k], b.m_inboard[k], 1e-10);
    }
}

#[test]
#[should_panic(expected = "singular system")]
fn elimination_refuses_redundant_constraints() {
    let mut scene = Scene::pinned(vec![Body::rod(2.0, 1.0)]);
    scene.joints[0] = Joint::Weld;
    scene.tip = Tip::clamped(Ground::at([1.0, 0.0]));
    solve(&scene, &scene.assemble(&[0.0], &[0.0]));
}

// --- laws that hold for every chain ---

#[test]
fn every_body_and_the_whole_chain_obey_the_laws_of_momentum() {
    let mut noise = Noise(3);
    for round in 0..40 {
        let (scene, state, torques, loads) = mixed_chain(&mut noise, round);
        let a = scene.solve(&state, &torques, &loads);
        assert!(a.residual < 1e-14, "{:e}", a.residual); // refined: some units of the last place
        let big = a.q_inboard.iter().chain(&a.acceleration_c).flatten().fold(100.0, |m: f64, x| m.max(x.abs()));
        let tolerance = 1e-14 * 10.0 * big; // sums of ten terms of the size of the largest force
        assert!(scene.balance_defect(&state, &loads, &a) < tolerance);

        let last = scene.bodies.len() - 1;
        let tip = scene.tip_point(&state).0;
        let mut force = sub(a.q_inboard[0], a.q_outboard[last]);
        let mut moment = cross(state.position[0], a.q_inboard[0]) - a.m_inboard[0];
        moment += a.m_outboard[last] - cross(tip, a.q_outboard[last]);
        for (k, body) in scene.bodies.iter().enumerate() {
            let weight = scale(body.mass, scene.gravity);
            force = add(force, weight);
            moment += cross(scene.centre(&state, k).0, weight);
        }
        for load in &loads {
            let point = add(state.position[load.body], rotate(state.angle[load.body], load.point));
            force = add(force, load.force);
            moment += cross(point, load.force) + load.torque;
        }
        near2(scene.linear_momentum_rate(&a), force, 10.0 * tolerance);
        near(scene.angular_momentum_rate(&state, &a), moment, 100.0 * tolerance); // arms of some metres
    }
}

#[test]
fn a_hinge_without_the_balancing_moment_creates_angular_momentum() {
    let mut noise = Noise(4);
    let mut scene = Scene::pinned(vec![noise.body(), noise.body()]);
    scene.gravity = [0.0, 0.0];
    for (axes, share) in [(Axes::Inboard, 0.0), (Axes::Fixed, 0.0), (Axes::FixedUnbalanced, 1.0)] {
        scene.joints = vec![Joint::Free, noise.elastic(axes)];
        let coordinates: Vec<Coordinates> = scene.joints.iter().map(|j| noise.coordinates(j)).collect();
        let state = scene.place(&coordinates);
        let a = solve(&scene, &state);
        let d = sub(state.position[1], add(state.position[0], rotate(state.angle[0], scene.bodies[0].outboard)));
        near2(scene.linear_momentum_rate(&a), [0.0, 0.0], 10.0 * ROUNDING); // forces of the order 50
        near(scene.angular_momentum_rate(&state, &a), share * cross(d, a.q_inboard[1]), 10.0 * ROUNDING);
    }
}

#[test]
fn the_rate_of_the_energy_is_the_power_of_all_that_acts() {
    let mut noise = Noise(6);
    for round in 0..40 {
        let (scene, state, torques, loads) = mixed_chain(&mut noise, round);
        let a = scene.solve(&state, &torques, &loads);
        let power = scene.power(&state, &torques, &loads) + scene.ground_power(&a) + scene.axes_power(&state)
            - scene.dissipation(&state);
        let big = a.q_inboard.iter().chain(&a.acceleration_c).flatten().fold(100.0, |m: f64, x| m.max(x.abs()));
        // Terms of the size force times velocity, velocities of the order 10, some ten of them; and the projection of a
        // held tip leaves velocity errors of 1e-15 at which the constraint forces do work.
        near(scene.energy_rate(&state, &a), power, 1e-12 * big);
    }
}

#[test]
fn energy_and_momenta_of_a_turning_rod_are_those_of_the_textbook() {
    let mut scene = Scene::pinned(vec![Body::rod(3.0, 2.0)]);
    scene.joints[0] = Joint::Free;
    let state = scene.place(&[Coordinates { u: [1.0, 2.0], phi: 0.0, u_rate: [0.5, 0.0], phi_rate: 4.0 }]);
    // C at (2, 2) with velocity (0.5, 4); J_C = 1.
    near(scene.kinetic_energy(&state), 1.5 * (0.25 + 16.0) + 0.5 * 16.0, ROUNDING);
    near(scene.potential_energy(&state), 3.0 * G * 2.0, ROUNDING);
    near2(scene.linear_momentum(&state), [1.5, 12.0], ROUNDING);
    near(scene.angular_momentum(&state), 3.0 * (2.0 * 4.0 - 2.0 * 0.5) + 4.0, ROUNDING);
}

// --- states ---

#[test]
fn placed_chains_meet_their_constraints_and_give_their_coordinates_back() {
    let mut noise = Noise(7);
    for round in 0..8 {
        let (scene, state, ..) = mixed_chain(&mut noise, 2 * round + 1);
        let [position, velocity] = scene.violation(&state);
        assert!(position < 1e-14 && velocity < 1e-13, "{position:e} {velocity:e}"); // positions of 5, velocities of 20
        let again = scene.place(&scene.coordinates(&state));
        for k in 0..scene.bodies.len() {
            near2(again.position[k], state.position[k], 1e-13);
            near2(again.velocity[k], state.velocity[k], 1e-12);
            near(again.angle[k], state.angle[k], 1e-14);
        }
    }
}

#[test]
fn second_derivatives_of_the_joint_coordinates_fit_the_accelerations_of_the_bodies() {
    let mut noise = Noise(8);
    for round in 0..8 {
        let (scene, state, torques, loads) = mixed_chain(&mut noise, 2 * round + 1);
        let a = scene.solve(&state, &torques, &loads);
        let (now, second) = (scene.coordinates(&state), scene.coordinate_accelerations(&state, &a));
        // Where the bodies are at the time t if all second derivatives stay.
        let places = |t: f64| {
            let along = |x: Vector, v: Vector, a: Vector| add(x, add(scale(t, v), scale(0.5 * t * t, a)));
            let mut scene = scene.clone();
            let g = &mut scene.ground;
            g.position = along(g.position, g.velocity, g.acceleration);
            g.angle += t * g.rate + 0.5 * t * t * g.angular_acceleration;
            let step = |(c, (u, phi)): (&Coordinates, &(Vector, f64))| {
                let turn = c.phi + t * c.phi_rate + 0.5 * t * t * phi;
                Coordinates { u: along(c.u, c.u_rate, *u), phi: turn, ..*c }
            };
            let then: Vec<Coordinates> = now.iter().zip(&second).map(step).collect();
            scene.place(&then)
        };
        let h = 2e-4;
        let [b2, b1, f1, f2] = [-2.0 * h, -h, h, 2.0 * h].map(places);
        let difference = |x: &dyn Fn(&State) -> f64| {
            (16.0 * (x(&f1) + x(&b1)) - x(&f2) - x(&b2) - 30.0 * x(&state)) / (12.0 * h * h)
        };
        for k in 0..scene.bodies.len() {
            // Truncation: h^4 / 90 = 2e-17 times a sixth derivative of some 1e9, which rates of 10 and accelerations of
            // 100 make; rounding: 1e-15 / h^2 times values of 10. Together some 3e-7, while a lost term is above 0.1.
            for i in 0..2 {
                near(difference(&|s| s.position[k][i]), a.acceleration[k][i], 1e-5);
            }
            near(difference(&|s| s.angle[k]), a.angular_acceleration[k], 1e-5);
        }
    }
}

#[test]
fn a_chain_of_pins_is_placed_alike_from_absolute_and_from_relative_angles() {
    let mut scene = Scene::pinned(vec![Body::rod(1.0, 1.0), Body::rod(1.0, 0.5), Body::rod(1.0, 0.7)]);
    scene.ground = Ground { position: [1.0, 2.0], velocity: [3.0, 4.0], angle: 0.5, rate: 0.2, ..Ground::default() };
    let (angles, rates) = ([0.3, 1.0, -0.8], [1.0, -2.0, 0.6]);
    let state = scene.assemble(&angles, &rates);
    let relative = |v: &[f64], root: f64, k: usize| v[k] - if k == 0 { root } else { v[k - 1] };
    let coordinates: Vec<Coordinates> =
        (0..3).map(|k| Coordinates::angle(relative(&angles, 0.5, k), relative(&rates, 0.2, k))).collect();
    let placed = scene.place(&coordinates);
    for k in 0..3 {
        near2(placed.position[k], state.position[k], 1e-14); // a few roundings of numbers near five
        near2(placed.velocity[k], state.velocity[k], 1e-14);
    }
    near2(
        scene.tip_point(&state).0,
        {
            let reach = |k: usize| rotate(angles[k], scene.bodies[k].outboard);
            (0..3).map(reach).fold([1.0, 2.0], add)
        },
        1e-14,
    );
}

#[test]
fn projection_closes_a_loop_and_keeps_the_joints() {
    let mut scene = Scene::pinned(vec![Body::rod(1.0, 1.0), Body::rod(1.0, 1.5), Body::rod(1.0, 1.2)]);
    scene.tip = Tip::pinned(Ground { velocity: [0.1, -0.2], ..Ground::at([1.4, 0.2]) });
    let state = scene.project(&scene.assemble(&[1.2, 0.1, -1.4], &[1.0, 0.0, 0.0]));
    let [position, velocity] = scene.violation(&state);
    assert!(position < 1e-15 && velocity < 1e-14, "{position:e} {velocity:e}"); // roundings of numbers near one
}

// --- motion ---

#[test]
fn extrapolation_solves_a_time_dependent_scalar_equation() {
    // y' = -2 t y, y = exp(-t^2), there and back.
    let end = extrapolate(|t, y| vec![-2.0 * t * y[0]], 0.0, 2.0, &[1.0], 1e-14);
    near(end[0], (-4.0_f64).exp(), 1e-15); // the error bound, on the way down
    let start = extrapolate(|t, y| vec![-2.0 * t * y[0]], 2.0, 0.0, &[(-4.0_f64).exp()], 1e-14);
    near(start[0], 1.0, 1e-13); // errors at the start grow by exp(4)
}

fn two_rods() -> (Scene, [f64; 2]) {
    (Scene::pinned(vec![Body::rod(1.0, 1.0); 2]), [-std::f64::consts::FRAC_PI_3; 2])
}

#[test]
fn two_falling_rods_are_after_two_seconds_where_the_table_says() {
    let (scene, start) = two_rods();
    let (angles, rates) = scene.integrate(&start, &[0.0; 2], 2.0, 1e-13);
    let q = solve(&scene, &scene.assemble(&angles, &rates)).q_inboard[0];
    // The table has twelve decimals, so half a unit of its last place is 5e-13; the integration adds some 1e-14, and
    // the force multiplies errors of the angles by about 20.
    for (found, table) in angles.iter().zip([-1.356419851911, -1.130652239658]) {
        near(*found, table, 6e-13);
    }
    for (found, table) in rates.iter().zip([0.849162636804, 1.857340220784]) {
        near(*found, table, 6e-13);
    }
    near2(q, [-3.354922171594, 20.855383568488], 1.5e-12);
    // The same motion by Taylor series in arithmetic with thirty digits.
    let digits = [-1.3564198519106136, -1.1306522396578225, 0.8491626368041695, 1.8573402207843194];
    for (found, exact) in angles.iter().chain(&rates).zip(digits) {
        near(*found, exact, 2e-13); // the tolerance asked for, twice
    }
    near2(q, [-3.354922171594491, 20.855383568488572], 1e-12);
}

#[test]
fn absolute_and_joint_coordinates_lead_to_the_same_motion() {
    let (scene, start) = two_rods();
    let (angles, rates) = scene.integrate(&start, &[0.0; 2], 2.0, 1e-13);
    let coordinates = scene.coordinates(&scene.assemble(&start, &[0.0; 2]));
    let end = scene.integrate_driven(&coordinates, 2.0, 1e-13, |_, _| {}, |_, _| (vec![], vec![]));
    let end = scene.place(&end);
    for k in 0..2 {
        near(end.angle[k], angles[k], 2e-12); // twice the error of one integration, see the table
        near(end.rate[k], rates[k], 2e-12);
    }
}

#[test]
fn a_motion_run_backwards_ends_where_it_began_with_the_same_energy() {
    let scene = Scene::pinned(vec![Body::rod(1.0, 0.8), Body::rod(0.5, 1.1), Body::rod(1.5, 0.6)]);
    let (start, rates) = ([0.2, -0.5, 0.9], [1.0, 0.0, -2.0]);
    let (angles, end_rates) = scene.integrate(&start, &rates, 1.5, 1e-13);
    let before = scene.energy(&scene.assemble(&start, &rates));
    near(scene.energy(&scene.assemble(&angles, &end_rates)), before, 1e-11); // 30 J, rates of 10 with errors of 1e-13
    let (angles, rates_back) = scene.integrate(&angles, &end_rates, -1.5, 1e-13);
    for k in 0..3 {
        near(angles[k], start[k], 1e-11); // errors of 1e-13 grow along a chaotic motion by some tens both ways
        near(rates_back[k], rates[k], 1e-10);
    }
}

#[test]
fn a_mass_on_three_dampened_springs_rings_as_three_oscillators() {
    // With C at I all three directions are apart; gravity shifts the rest position of y.
    let (mass, inertia) = (1.6, 0.3);
    let (k, c, rest) = ([40.0, 25.0, 9.0], [0.8, 0.0, 0.1], [0.2, -0.1, 0.4]);
    let mut scene = Scene::pinned(vec![Body { mass, inertia_c: inertia, centre: [0.0; 2], outboard: [1.0, 0.0] }]);
    scene.joints[0] = Joint::Elastic(Elastic { stiffness: k, damping: c, rest, axes: Axes::Inboard });
    let start = Coordinates { u: [0.5, 0.3], phi: -0.6, u_rate: [1.0, -2.0], phi_rate: 0.5 };
    let t = 3.0;
    let end = scene.integrate_driven(&[start], t, 1e-13, |_, _| {}, |_, _| (vec![], vec![]));
    let ringing = |i: usize, m: f64, x0: f64, v0: f64, middle: f64| {
        let decay = 0.5 * c[i] / m;
        let w = (k[i] / m - decay * decay).sqrt();
        let (s, co) = (w * t).sin_cos();
        middle + (-decay * t).exp() * ((x0 - middle) * co + (v0 + decay * (x0 - middle)) / w * s)
    };
    // Some twenty steps, each within 1e-13.
    near(end[0].u[0], ringing(0, mass, 0.5, 1.0, rest[0]), 1e-12);
    near(end[0].u[1], ringing(1, mass, 0.3, -2.0, rest[1] - mass * G / k[1]), 1e-12);
    near(end[0].phi, ringing(2, inertia, -0.6, 0.5, rest[2]), 1e-12);
}

#[test]
fn a_bead_leaves_a_steadily_turning_tube_along_a_hyperbolic_cosine() {
    let w = 1.5;
    let mut scene = Scene::pinned(vec![Body { mass: 0.7, inertia_c: 0.1, centre: [0.0; 2], outboard: [1.0, 0.0] }]);
    scene.gravity = [0.0, 0.0];
    scene.joints[0] = Joint::Slider { axis: [0.0, 1.0], spring: [0.0; 3] };
    let turn = |t: f64, scene: &mut Scene| scene.ground = Ground { angle: w * t, rate: w, ..Ground::default() };
    let start = [Coordinates::along([0.0, 1.0], 0.3, 0.0, 0.0)];
    let end = scene.integrate_driven(&start, 1.2, 1e-13, turn, |_, _| (vec![], vec![]));
    near(end[0].u[1], 0.3 * (w * 1.2).cosh(), 1e-12); // errors grow by cosh(1.8) = 3
    near(end[0].u_rate[1], 0.3 * w * (w * 1.2).sinh(), 1e-12);
}

/// A swinging, turning ground point: position, velocity and acceleration belong together.
fn swinging(centre: Vector, size: f64, pace: f64, t: f64) -> Ground {
    let (s, c) = (pace * t).sin_cos();
    Ground {
        position: add(centre, scale(size, [c, 0.5 * s])),
        velocity: scale(size * pace, [-s, 0.5 * c]),
        acceleration: scale(-size * pace * pace, [c, 0.5 * s]),
        angle: 0.4 * s,
        rate: 0.4 * pace * c,
        angular_acceleration: -0.4 * pace * pace * s,
    }
}

#[test]
fn accelerations_alone_keep_every_kind_of_tip_on_its_moving_ground() {
    // The only test of the right hand sides of all constraints that does not repeat their derivation: if a term were
    // wrong, the tip would leave its place at once.
    let axis = [1.0, 0.3];
    let tips = [
        Tip::pinned(Ground::default()),
        Tip::clamped(Ground::default()),
        Tip::guided(Ground::default(), axis),
        Tip::rolling(Ground::default(), axis),
    ];
    for tip in tips {
        let mut scene = Scene::pinned(vec![Body::rod(1.0, 1.0); 5]);
        scene.joints[0] = Joint::Slot { axis: [0.2, 1.0] };
        scene.joints[3] = Joint::Slider { axis: [1.0, 0.5], spring: [0.0; 3] };
        scene.tip = tip;
        let prepare = |t: f64, scene: &mut Scene| {
            scene.ground = swinging([0.0, 0.0], 0.2, 2.0, t);
            if let Tip::Held { ground, .. } = &mut scene.tip {
                *ground = swinging([2.0, 0.5], 0.3, 1.7, t);
            }
        };
        prepare(0.0, &mut scene);
        let state = scene.project(&scene.assemble(&[1.3, 0.2, -0.3, -0.2, -1.0], &[0.0; 5]));
        let [position, velocity] = scene.violation(&state);
        assert!(position < 1e-14 && velocity < 1e-14, "{position:e} {velocity:e}"); // projected to the rounding
        let end = scene.integrate_driven(&scene.coordinates(&state), 0.6, 1e-12, prepare, |_, _| (vec![], vec![]));
        prepare(0.6, &mut scene);
        let end = scene.place(&end);
        let moved = sub(scene.tip_point(&end).0, scene.tip_point(&state).0);
        assert!(moved[0].hypot(moved[1]) > 0.1);
        let [position, velocity] = scene.violation(&end);
        // The integration errors of 1e-12 per step; a lost term would show as 1e-2 and more.
        assert!(position < 1e-10 && velocity < 1e-10, "{position:e} {velocity:e} {tip:?}");
    }
}

#[test]
fn a_driven_chain_gains_the_work_done_on_it() {
    // The work is integrated in closed form by a load that is a weight: the same as more gravity on that body.
    let scene = Scene::pinned(vec![Body::rod(1.0, 1.0), Body::rod(2.0, 0.7)]);
    let coordinates = [Coordinates::angle(-0.4, 0.3), Coordinates::angle(0.8, -1.0)];
    let force = [1.5, -2.5];
    let load = Load { body: 1, point: [0.7, 0.0], force, torque: 0.0 };
    let torques = vec![0.6, -0.4]; // constant torques do the work torque times relative angle
    let end = scene.integrate_driven(&coordinates, 1.0, 1e-13, |_, _| {}, |_, _| (torques.clone(), vec![load]));
    let (before, after) = (scene.place(&coordinates), scene.place(&end));
    let shift = sub(scene.tip_point(&after).0, scene.tip_point(&before).0);
    let work = dot(force, shift) + (0..2).map(|k| torques[k] * (end[k].phi - coordinates[k].phi)).sum::<f64>();
    near(scene.energy(&after) - scene.energy(&before), work, 1e-11); // errors of 1e-13 at 30 J and rates of 10
}
