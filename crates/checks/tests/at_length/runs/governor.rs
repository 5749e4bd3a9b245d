//! A flyball governor: two masses on arms that a spindle turns, and a sleeve that stiff struts with dampers hang from them.

use catena::planar::{Strut, Struts};
use catena::spatial::*;
use catena::{Error, spatial};
use catena_oracle::near;
use core::f64::consts::{FRAC_PI_3, PI};

/// Mass (kg) and moments of inertia (kg·m²: along the arm, about its hinge, across both) of an arm; from its hinge to the mass centre
/// and to the strut (m).
const ARM: f64 = 3.0;
const OF_ARM: [f64; 3] = [0.004, 0.03, 0.028];
const CENTRE: f64 = 0.9;
const HOOK: f64 = 0.5;
/// Moments of inertia of the spindle and of the sleeve about the axis (kg·m²), mass of the sleeve (kg), its radius (m).
const OF_SPINDLE: f64 = 0.01;
const OF_SLEEVE: f64 = 0.02;
const SLEEVE: f64 = 5.0;
const RADIUS: f64 = 0.05;
/// Stiffness (N/m), damping (N·s/m) and length (m) of a strut.
const STIFFNESS: f64 = 8e5;
const DAMPING: f64 = 4e4;
const LENGTH: f64 = 0.5;
/// Angular velocity of the spindle (rad/s) and how far the arms hang (rad) at the start, gravity (m/s²), when the run ends (s).
const SPIN: f64 = 2.0 * PI;
const START: f64 = FRAC_PI_3;
const GRAVITY: f64 = 9.81;
const END: f64 = 1.0;

/// Where the sleeve (m) stretches no strut at the start.
fn sleeve() -> f64 {
    let across = HOOK * START.cos() - RADIUS;
    -HOOK * START.sin() - (LENGTH * LENGTH - across * across).sqrt()
}

/// Turn of the spindle, fall of the arms (rad), place of the sleeve (m).
type Found = [f64; 3];

type Turning = (RigidBody<f64>, Branch<(Revolute<f64>, RigidBody<f64>)>, Branch<(Revolute<f64>, RigidBody<f64>)>);
type Governor = spatial::System<
    f64,
    Clamped<[f64; 3], Rotation<f64>>,
    (Revolute<f64>, Turning, Prismatic<f64>, RigidBody<f64>),
    Free,
>;

fn governor() -> Result<(Governor, Struts<f64, 3, 2>), Error> {
    let tensor = |[x, y, z]: [f64; 3]| [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
    let up = [0.0, 0.0, 1.0];
    let spindle = RigidBody::new(2.0, tensor([0.02, 0.02, OF_SPINDLE]), [0.0, 0.0, 0.5], up);
    // One along +x, the other along −x, each about the axis that turns it down.
    let arm = |side: f64| {
        let body = RigidBody::new(ARM, tensor(OF_ARM), [side * CENTRE, 0.0, 0.0], [side, 0.0, 0.0]);
        Branch((Revolute::about([0.0, side, 0.0]), body))
    };
    let slide = RigidBody::new(SLEEVE, tensor([0.015, 0.015, OF_SLEEVE]), [0.0; 3], [0.0, 0.0, -0.1]);
    let chain = (Revolute::about(up), (spindle, arm(1.0), arm(-1.0)), Prismatic::along(up), slide);
    let scene = System::new(Clamped::origin(), chain, Free)?.with_gravity([0.0, 0.0, -GRAVITY]);
    let strut = |arm: usize, side: f64| {
        let strut = Strut::between((arm, [side * HOOK, 0.0, 0.0]), (3, [side * RADIUS, 0.0, 0.0]));
        strut.with_stiffness(STIFFNESS).with_damping(DAMPING).with_length(LENGTH)
    };
    Ok((scene, Struts::of([strut(1, 1.0), strut(2, -1.0)])))
}

/// What a run finds, by how much its arms differ (rad), and its steps.
fn run(fine: bool, tolerance: f64) -> Result<(Found, f64, usize), Error> {
    let (scene, loads) = governor()?;
    let mut start = scene.at_rest(&[0.0, START, START])?;
    // The ground, the spindle with its arms, the sleeve.
    start.position_mut().1.2 = sleeve();
    let start = scene.with_rates(start, &[SPIN, 0.0, 0.0, 0.0])?;
    let run = if fine {
        scene.simulation(Dop853::tolerance(tolerance)).loads(&loads).run(start, END, |_| ())?
    } else {
        scene.simulation(Dopri5::tolerance(tolerance)).loads(&loads).run(start, END, |_| ())?
    };
    let mut found = vec![];
    catena::system::Position::visit(run.motion.position(), &mut |x| found.push(x));
    let [turn, one, other, sleeve] = found[..] else { panic!("{found:?}") };
    Ok(([turn, one, sleeve], (one - other).abs(), run.steps + run.rejected))
}

/// By Lagrange's equations in the turn φ of the spindle, the fall a of both arms and the place s of the sleeve, with
///
/// ```text
/// T = ½ J(a) φ'² + (m d² + I₂) a'² + ½ M s'²      J = J₀ + 2 m d² cos² a + 2 I₁ sin² a + 2 I₃ cos² a
/// V = −2 m g d sin a + M g s                      ℓ² = (b cos a − r)² + (b sin a + s)²
/// ```
///
/// struts that pull with F = k (ℓ − ℓ₀) + c ℓ', and J φ' that stays. The classical rule in so many steps.
fn by_hand(steps: usize) -> Found {
    let [along, about, across] = OF_ARM;
    let turning = |a: f64| {
        let (s, c) = a.sin_cos();
        OF_SPINDLE + OF_SLEEVE + 2.0 * (ARM * CENTRE * CENTRE * c * c + along * s * s + across * c * c)
    };
    let momentum = turning(START) * SPIN;
    let slope = |[_, a, z, u, w]: [f64; 5]| {
        let (s, c) = a.sin_cos();
        let spin = momentum / turning(a);
        let swell = 4.0 * (along - across - ARM * CENTRE * CENTRE) * s * c; // dJ/da
        let [x, y] = [HOOK * c - RADIUS, HOOK * s + z];
        let length = x.hypot(y);
        let [by_fall, by_sleeve] = [HOOK * (c * y - s * x) / length, y / length];
        let pull = STIFFNESS * (length - LENGTH) + DAMPING * (by_fall * u + by_sleeve * w);
        let fall = 0.5 * swell * spin * spin + 2.0 * ARM * GRAVITY * CENTRE * c - 2.0 * pull * by_fall;
        let inertia = 2.0 * (ARM * CENTRE * CENTRE + about);
        [spin, u, w, fall / inertia, -GRAVITY - 2.0 * pull * by_sleeve / SLEEVE]
    };
    let plus = |y: [f64; 5], h: f64, k: [f64; 5]| core::array::from_fn(|i| y[i] + h * k[i]);
    let h = END / steps as f64;
    let mut y = [0.0, START, sleeve(), 0.0, 0.0];
    for _ in 0..steps {
        let k = slope(y);
        let l = slope(plus(y, 0.5 * h, k));
        let m = slope(plus(y, 0.5 * h, l));
        let n = slope(plus(y, h, m));
        y = core::array::from_fn(|i| y[i] + h / 6.0 * (k[i] + 2.0 * (l[i] + m[i]) + n[i]));
    }
    [y[0], y[1], y[2]]
}

/// Dampers this stiff make a trial step that is somewhat too long overflow: it is rejected, and the run goes on.
#[test]
fn a_governor_runs_under_error_control() -> Result<(), Error> {
    let [coarse, expected] = [100_000, 200_000].map(by_hand);
    println!("by hand {expected:?}, {:.1e}", (coarse[1] - expected[1]).abs());
    for (fine, tolerance, most) in [(true, 1e-6, 1e-8), (false, 1e-6, 1e-8), (true, 1e-9, 1e-12)] {
        let (found, apart, trials) = run(fine, tolerance)?;
        let errors: [f64; 3] = core::array::from_fn(|k| (found[k] - expected[k]).abs());
        println!("{fine} {tolerance:e}: {trials} trial steps, errors {errors:?}, arms apart {apart:.1e}");
        (0..3).for_each(|k| near(found[k], expected[k], most));
        near(apart, 0.0, most);
    }
    Ok(())
}
