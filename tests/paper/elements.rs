//! The paper's matrices against the equations they stand for: Newton-Euler for bodies, springs and dampers for hinges.

use catena::paper::*;
use catena::planar::Inertia;
use catena::planar::index::{M, ONE, QX, QY, THETA, X, Y};
use catena::{Fault, StateVector, TransferMatrix};
use catena_oracle::{Noise, slope};

type Matrix = TransferMatrix<f64, 7>;
type State = StateVector<f64, 7>;

/// A body in general position in one step.
struct Case {
    body: Rigid<f64>,
    at: Expansion<f64>,
    chi1: f64,
    /// χ₂ of x_I, y_I, x_C, y_C, θ.
    chi2: [f64; 5],
    external: External<f64>,
    state: State,
}

fn case(noise: &mut Noise, at: At) -> Case {
    let inertia =
        Inertia { mass: noise.between(0.5, 2.0), centre: noise.pair(), about_centre: noise.between(0.1, 0.5) };
    let body = Rigid { inertia, outboard: noise.pair() };
    let (angle, rate, acceleration, dt) = (noise.between(-3.0, 3.0), noise.next(), noise.next(), 0.1);
    let at = match at {
        At::Previous => Expansion::printed(angle, rate, acceleration, dt),
        _ => Expansion::about(angle + rate * dt),
    };
    let chi2 = core::array::from_fn(|_| noise.next());
    let external = External { force: noise.pair(), torque: noise.next() };
    let mut z = StateVector::new([0.0; 7].map(|_: f64| noise.next()));
    (z[THETA], z[ONE]) = (angle + noise.between(-0.1, 0.1), 1.0);
    Case { body, at, chi1: noise.between(1.0, 50.0), chi2, external, state: z }
}

impl Case {
    fn matrix(&self) -> Matrix {
        let known = Known::absolute(&self.body, &self.at, self.chi2);
        rigid_body(&self.body, &self.at, self.chi1, &known, &self.external)
    }

    /// By how much a matrix misses (18), (19) and (20) with (1), (7), (9) and (10), written out here.
    fn residual(&self, u: &Matrix) -> [f64; 6] {
        let (z, o) = (self.state, *u * self.state);
        let Inertia { mass, centre, about_centre } = self.body.inertia;
        let [s, c] = self.at.direction;
        // (7): cosine and sine at t_i, linear in θ.
        let step = z[THETA] - self.at.angle;
        let cos = c - s * step - c * self.at.curvature;
        let sin = s + c * step - s * self.at.curvature;
        let turned = |[x, y]: [f64; 2], [s, c]: [f64; 2]| [x * c - y * s, x * s + y * c];
        let arm = turned(self.body.outboard, [sin, cos]);
        let to_centre = turned(centre, [sin, cos]);
        let [xi, yi, xc, yc, turn] = self.chi2;
        let (k, f) = (self.chi1, self.external.force);
        let of_centre = [k * (z[X] + to_centre[0]) + xc, k * (z[Y] + to_centre[1]) + yc];
        let inboard = [k * z[X] + xi, k * z[Y] + yi];
        // Arms of the products in (20): (9) and (10).
        let [io, ic] = [self.body.outboard, centre].map(|vector| turned(vector, self.at.barred));
        let about_inboard = about_centre + mass * (centre[0] * centre[0] + centre[1] * centre[1]);
        let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
        [
            o[X] - z[X] - arm[0],
            o[Y] - z[Y] - arm[1],
            o[THETA] - z[THETA],
            about_inboard * (k * z[THETA] + turn) - (-z[M] + o[M])
                + cross(io, [o[QX], o[QY]])
                + mass * cross(ic, inboard)
                - self.external.torque
                - cross(ic, f),
            mass * of_centre[0] - (z[QX] - o[QX] + f[0]),
            mass * of_centre[1] - (z[QY] - o[QY] + f[1]),
        ]
    }
}

fn worst(residual: [f64; 6]) -> f64 {
    residual.into_iter().fold(0.0, |worst, x| worst.max(x.abs()))
}

#[test]
fn rigid_body_matrix_meets_newton_and_euler() {
    let mut noise = Noise::new(1);
    for at in [At::Previous, At::Predictor] {
        for _ in 0..200 {
            let case = case(&mut noise, at);
            let residual = worst(case.residual(&case.matrix()));
            assert!(residual < 2e-13, "{residual:e}"); // terms of a few hundred
            let determinant = case.matrix().as_matrix().determinant();
            assert!((determinant - 1.0).abs() < 1e-11, "{determinant}");
        }
    }
}

/// Each entry that the paper prints otherwise, put back as printed, breaks the balance it stands in.
#[test]
fn entries_as_printed_fail() {
    let mut noise = Noise::new(2);
    let (mut least_67, mut least_47, mut least_inertia) = (f64::MAX, f64::MAX, f64::MAX);
    for _ in 0..50 {
        let case = case(&mut noise, At::Previous);
        let [g1, g2] = case.at.constants();
        let ([_, yc], mass) = (case.body.inertia.centre, case.body.inertia.mass);
        let [_, y_ic] = case.at.turned_barred(case.body.inertia.centre);
        let [x_io, _] = case.at.turned_barred(case.body.outboard);

        // u67 with x G₂ + y G₂; u47 contains it.
        let mut printed = case.matrix();
        let wrong = -mass * case.chi1 * yc * (g2 - g1);
        printed[(QY, ONE)] += wrong;
        printed[(M, ONE)] += wrong * x_io;
        least_67 = least_67.min(case.residual(&printed)[5].abs() / (mass * case.chi1 * yc * (g2 - g1)).abs());

        // u47 without − [mχ_{2,xI} − f_x] y_IC.
        let mut printed = case.matrix();
        let missing = (mass * case.chi2[0] - case.external.force[0]) * y_ic;
        printed[(M, ONE)] += missing;
        least_47 = least_47.min(case.residual(&printed)[3].abs() / missing.abs());

        // J about the mass centre where (20) needs it about I.
        let mut printed = case.matrix();
        let [x, y] = case.body.inertia.centre;
        let shift = mass * (x * x + y * y);
        printed[(M, THETA)] -= shift * case.chi1;
        printed[(M, ONE)] -= shift * case.chi2[4];
        let missing = shift * (case.chi1 * case.state[THETA] + case.chi2[4]);
        least_inertia = least_inertia.min(case.residual(&printed)[3].abs() / missing.abs());
    }
    println!("left of what is wrong: u67 {least_67:.6}, u47 {least_47:.6}, J_C for J_I {least_inertia:.6}");
    for found in [least_67, least_47, least_inertia] {
        assert!((found - 1.0).abs() < 1e-9, "{found}");
    }
}

/// (7) to (10): what is left out falls with the third power of the step, at t_{i−1} as at the predictor.
#[test]
fn expansions_are_third_order() {
    let (angle, rate, acceleration, jerk) = (0.7_f64, 1.3, -2.1, 0.9);
    for printed in [true, false] {
        let (mut linear, mut barred) = (vec![], vec![]);
        for dt in [0.1_f64, 0.05, 0.025, 0.0125] {
            let later = angle + rate * dt + acceleration * dt * dt / 2.0 + jerk * dt * dt * dt / 6.0;
            let ahead = angle + rate * dt + acceleration * dt * dt / 2.0;
            let at = if printed { Expansion::printed(angle, rate, acceleration, dt) } else { Expansion::about(ahead) };
            let [g1, g2] = at.constants();
            let [s, c] = at.direction;
            let error = (c * later + g2 - later.sin()).abs().max((-s * later + g1 - later.cos()).abs());
            linear.push((dt, error));
            barred.push((dt, (at.barred[0] - later.sin()).abs().max((at.barred[1] - later.cos()).abs())));
            // What is known of the remainder is the remainder.
            let remainder = at.remainder([1.0, 0.0], later);
            assert!((remainder[0] - (-s * later + g1 - later.cos())).abs() < 1e-15);
            assert!((remainder[1] - (c * later + g2 - later.sin())).abs() < 1e-15);
        }
        println!("printed {printed}: orders {:.2} and {:.2}", slope(&linear), slope(&barred));
        assert!((slope(&barred) - 3.0).abs() < 0.2);
        assert!(slope(&linear) > if printed { 2.8 } else { 5.8 }); // the square of what the predictor misses
    }
}

#[test]
fn hinge_matrices_meet_the_laws_of_springs_and_dampers() {
    let mut noise = Noise::new(3);
    let state = |noise: &mut Noise| {
        let mut z = StateVector::new([0.0; 7].map(|_: f64| noise.next()));
        z[ONE] = 1.0;
        z
    };
    for _ in 0..50 {
        let z = state(&mut noise);
        let (k, c, chi3) = (noise.between(1.0, 50.0), noise.between(0.0, 2.0), noise.between(1.0, 200.0));
        let (chi4, rest) = (noise.pair(), noise.next());
        // (34) with (2), and a rest angle.
        let o = rotary_hinge(&Rotary { slope: k + c * chi3, offset: c * (chi4[1] - chi4[0]) - k * rest }) * z;
        let rate = |angle: f64, chi4: f64| chi3 * angle + chi4;
        let law = -o[M] + k * (o[THETA] - z[THETA] - rest) + c * (rate(o[THETA], chi4[1]) - rate(z[THETA], chi4[0]));
        assert!(law.abs() < 1e-12, "{law:e}"); // terms of a few hundred
        assert!((0..7).all(|i| i == THETA || o[i] == z[i]));

        // (33) with (2).
        let known = [(noise.pair(), noise.next()), (noise.pair(), noise.next())];
        let axes =
            known.map(|(chi4, rest)| Some(Linear { slope: k + c * chi3, offset: c * (chi4[1] - chi4[0]) - k * rest }));
        let o = linear_hinge(axes) * z;
        for ((chi4, rest), (r, q)) in known.into_iter().zip([(X, QX), (Y, QY)]) {
            let law = o[q] + k * (o[r] - z[r] - rest) + c * (rate(o[r], chi4[1]) - rate(z[r], chi4[0]));
            assert!(law.abs() < 1e-12, "{law:e}");
        }
        assert_eq!(o[M], z[M]); // as printed
        // Rigid axes do not give.
        assert_eq!(linear_hinge::<f64>([None, None]), Matrix::identity());
    }
}

#[test]
fn lumped_mass_is_a_body_without_extent() {
    let inertia = Inertia { mass: 1.3, centre: [0.0; 2], about_centre: 0.0 };
    let body = Rigid { inertia, outboard: [0.0; 2] };
    let (at, chi1, chi2) = (Expansion::about(0.4), 30.0, [0.2, -0.7]);
    let [x, y] = chi2;
    let external = External { force: [0.3, -1.0], torque: 0.0 };
    let known = Known::absolute(&body, &at, [x, y, x, y, 0.0]);
    assert_eq!(lumped_mass(1.3, chi1, chi2, external.force), rigid_body(&body, &at, chi1, &known, &external));
}

/// (36) to (40): whatever comes in, the section passes the torque known at its outboard end.
#[test]
fn pin_matrix_lets_no_torque_through_its_section() {
    let mut noise = Noise::new(4);
    for _ in 0..50 {
        let first = case(&mut noise, At::Previous);
        let second = case(&mut noise, At::Previous);
        let hinge = rotary_hinge(&Rotary { slope: 20.0, offset: 0.3 });
        for section in [first.matrix(), second.matrix() * hinge * first.matrix()] {
            let torques = noise.pair();
            let pin = smooth_pin(&section, torques, 1.0).unwrap();
            let mut z = first.state;
            z[M] = torques[0];
            let (inner, outer) = (pin * z, section * (pin * z));
            let scale = section.as_matrix().amax();
            assert!((outer[M] - torques[1]).abs() < 1e-13 * scale, "{:e}", outer[M] - torques[1]);
            assert!((0..7).all(|i| i == THETA || inner[i] == z[i]));
            assert!(pin.as_matrix().determinant() == 0.0); // rank 6
        }
    }
}

/// Where the outboard end is the centre of percussion of the pin there is no matrix: two thirds down a uniform rod, or at a point mass.
#[test]
fn pin_matrix_does_not_exist_at_the_centre_of_percussion() {
    let rod = Inertia { mass: 1.0, centre: [0.5, 0.0], about_centre: 1.0 / 12.0 };
    let bob = Inertia { mass: 1.0, centre: [1.0, 0.0], about_centre: 0.0 };
    for (inertia, outboard) in [(rod, 2.0 / 3.0), (bob, 1.0)] {
        let body = Rigid { inertia, outboard: [outboard, 0.0] };
        assert!(is_percussive(&body));
        let (at, chi1) = (Expansion::about(0.4), 4e4);
        let known = Known::absolute(&body, &at, [0.1; 5]);
        let u = rigid_body(&body, &at, chi1, &known, &External { force: [0.0, -9.81], torque: 0.0 });
        let error = smooth_pin(&u, [0.0; 2], chi1).unwrap_err();
        assert_eq!(error.fault, Fault::CentreOfPercussion);
    }
    assert!(!is_percussive(&Rigid { inertia: rod, outboard: [1.0, 0.0] }));
}

/// What the rules say of ξ̈ and ξ̇ at the end of a step along a polynomial: exact up to their order.
#[test]
fn rules_are_exact_on_parabolas() {
    fn check<R: Rule<f64>>(name: &str, rule: R) {
        let (a, v, x, dt) = (0.7, -0.4, 1.9, 0.1);
        let at = |t: f64| [x + v * t + 0.5 * a * t * t, v + a * t, a];
        let mut coordinate = rule.start(x, v, a, dt);
        for step in 0..5 {
            let past = step as f64 * dt;
            let linear = rule.linearize(&coordinate, dt);
            let mut balance = at(past + rule.balance() * dt);
            if rule.balance() < 1.0 {
                balance[0] = 0.5 * (at(past)[0] + at(past + dt)[0]); // the midpoint rule's mean of both ends
            }
            let increment = balance[0] - coordinate.value;
            assert!((linear.acceleration_at(increment) - a).abs() < 1e-11, "{name}");
            assert!((linear.rate_at(increment) - balance[1]).abs() < 1e-12, "{name}");
            // (1) and (2) as printed
            assert!((linear.chi1 * balance[0] + linear.chi2() - a).abs() < 1e-11, "{name}");
            assert!((linear.chi3 * balance[0] + linear.chi4() - balance[1]).abs() < 1e-12, "{name}");
            rule.advance(&mut coordinate, dt, increment);
            let now = at(past + dt);
            let errors = [coordinate.value - now[0], coordinate.rate - now[1], coordinate.acceleration - now[2]];
            assert!(errors.iter().all(|e| e.abs() < 1e-11), "{name}: {errors:?}");
        }
        rule.check().unwrap();
    }
    check("Newmark 1/2", Newmark::new(0.25, 0.5));
    check("Newmark 0.6", Newmark::damped(0.6));
    check("linear acceleration", Newmark::new(1.0 / 6.0, 0.5));
    check("generalised-alpha", GeneralizedAlpha::new(0.8));
    check("HHT", hht_alpha(0.2));
    check("Houbolt", Multistep::HOUBOLT);
    check("Park", Multistep::PARK);
    check("BDF2", Multistep::BDF2);
    check("Wilson", Wilson::new(1.42));
    check("midpoint", Midpoint);
}

/// (3) and (4), to the letter.
#[test]
fn newmark_is_as_printed() {
    let (x, v, a, dt, beta, gamma) = (1.3, -0.7, 2.2, 0.05, 0.3, 0.6);
    let rule = Newmark::new(beta, gamma);
    let linear = rule.linearize(&rule.start(x, v, a, dt), dt);
    let chi1 = 1.0 / (beta * dt * dt);
    let chi2 = -chi1 * (x + v * dt + (0.5 - beta) * a * dt * dt);
    let chi4 = gamma * chi2 * dt + v + (1.0 - gamma) * a * dt;
    for (found, printed) in
        [linear.chi1, linear.chi2(), linear.chi3, linear.chi4()].into_iter().zip([chi1, chi2, gamma * chi1 * dt, chi4])
    {
        assert!((found / printed - 1.0_f64).abs() < 1e-14, "{found} {printed}");
    }
}

#[test]
fn parameters_that_make_no_rule_are_refused_with_a_reason() {
    let not_positive = |value| Err(Fault::NotPositive { parameter: "beta", value });
    assert_eq!(Rule::<f64>::check(&Newmark::new(0.0, 0.5)), not_positive(0.0));
    assert_eq!(Rule::<f64>::check(&Newmark::new(-1.0, 0.5)), not_positive(-1.0));
    assert!(Rule::<f64>::check(&Newmark::new(f64::NAN, 0.5)).is_err());
    let below = Rule::<f64>::check(&Newmark::new(0.25, 0.49)).map_err(|fault| catena::Error::new(fault).to_string());
    let reason = "gamma must be finite and at least 0.5, but is 0.49: below, every vibration grows";
    assert_eq!(below, Err(reason.to_owned()));
    assert!(Rule::<f64>::check(&Newmark::new(0.25, f64::NAN)).is_err());
    assert!(Rule::<f64>::check(&Wilson::new(1.3)).is_err());
    assert!(Rule::<f64>::check(&hht_alpha(0.5)).is_err());
    assert!(Rule::<f64>::check(&GeneralizedAlpha::new(1.5)).is_err());
    // Allowed, but marked.
    fn weak(rule: impl Rule<f64>) -> bool {
        rule.is_weak_on_rigid_joints()
    }
    assert!(weak(Newmark::new(0.25, 0.5)));
    assert!(weak(Midpoint));
    assert!(weak(GeneralizedAlpha::new(1.0)));
    assert!(!weak(GeneralizedAlpha::new(0.8)));
    assert!(!weak(Newmark::damped(0.6)));
    assert!(!weak(Multistep::BDF2));
}
