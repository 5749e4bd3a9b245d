//! Contacts: how they yield against dense forms, the order of rules through them, energy, and a quadruped that stands.

use catena::Error;
use catena::robot::*;
use catena_oracle::{Noise, has_order, near};
use catena_robots::quadruped;
use nalgebra::{Matrix3, SMatrix, Vector3};

const GRAVITY: f64 = 9.81;

/// A form of six against that of a point, Gᵀ D G with G = (1, −r~).
#[test]
fn blocks_are_those_of_their_points() {
    let mut noise = Noise::new(21);
    for _ in 0..100 {
        let mut vector = || Vector3::new(noise.next(), noise.next(), noise.next());
        let (point, n) = (vector(), vector().normalize());
        let [along, across] = noise.pair();
        let d = Matrix3::identity() * across + n * n.transpose() * (along - across);
        let mut g = SMatrix::<f64, 3, 6>::zeros();
        g.fixed_view_mut::<3, 3>(0, 0).copy_from(&Matrix3::identity());
        g.fixed_view_mut::<3, 3>(0, 3).copy_from(&-point.cross_matrix());
        let whole = g.transpose() * d * g;
        let Block { linear, coupling, angular } = Block::at(point, n, along, across);
        let pairs = [(0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1)];
        for (k, (i, j)) in pairs.into_iter().enumerate() {
            near(linear[k], whole[(i, j)], 1e-14);
            near(angular[k], whole[(3 + i, 3 + j)], 1e-14);
        }
        for i in 0..3 {
            for j in 0..3 {
                near(coupling[i][j], whole[(i, 3 + j)], 1e-14);
            }
        }
    }
}

const MASSES: [f64; 2] = [0.7, 0.5];
const STIFFNESS: f64 = 2000.0; // (N/m)
const DEPTH: f64 = 0.05; // (m)
const DAMPING: f64 = 0.3; // (s/m)
const FRICTION: f64 = 0.4;
const SPEED: f64 = 0.3; // (m/s)
const HEIGHT: f64 = -0.2; // of the ground (m)
const END: f64 = 0.8; // (s)

fn law() -> Contact<f64> {
    Contact::new(STIFFNESS, DEPTH).damped(DAMPING).rubbing(FRICTION, SPEED)
}

type Thrown = System<f64, Base<f64>, (Slide<f64>, Link<f64>, Slide<f64, Quarter<8>>, Link<f64>), Free>;

/// A body that moves up and sideways: along z, then along −x.
fn thrown() -> Result<Thrown, Error> {
    let [first, second] =
        MASSES.map(|mass| Link::general(mass, [0.1, -0.2, 0.05], [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]]));
    let chain = (Slide::level(), first, Slide::level().turned(Quarter::<8>), second);
    Ok(System::new(Base::origin(), chain, Free)?.with_gravity([0.0, 0.0, -GRAVITY]))
}

/// Height, way and rates, thrown sideways and dropped.
const START: [f64; 4] = [0.0, 0.0, 0.0, 1.5];

/// By the equations of a point mass.
fn truth(steps: usize) -> [f64; 4] {
    let whole = MASSES[0] + MASSES[1];
    let slope = |[z, _, u, v]: [f64; 4]| {
        let over = HEIGHT - z;
        let x = (over / DEPTH).clamp(0.0, 1.0);
        let pressed = DEPTH * (x.powi(3) - 0.5 * x.powi(4)) + (over - DEPTH).max(0.0);
        let normal = STIFFNESS * pressed * (1.0 - DAMPING * u).max(0.0);
        let rubbing = FRICTION * normal * v / (v * v + SPEED * SPEED).sqrt();
        [u, v, normal / whole - GRAVITY, -rubbing / MASSES[1]]
    };
    let h = END / steps as f64;
    let moved = |s: [f64; 4], k: [f64; 4], h: f64| core::array::from_fn(|i| s[i] + h * k[i]);
    (0..steps).fold(START, |s, _| {
        let a = slope(s);
        let b = slope(moved(s, a, 0.5 * h));
        let c = slope(moved(s, b, 0.5 * h));
        let d = slope(moved(s, c, h));
        core::array::from_fn(|i| s[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]))
    })
}

/// A rule whose steps are made like those of the others.
struct Explicitly;
impl Explicitly {
    fn step(&self, size: f64) -> catena::time::Rule<Rk4, f64> {
        Rk4::step(size)
    }
}
struct InRealTime;
impl InRealTime {
    fn step(&self, size: f64) -> catena::time::Rule<MoreauJean, f64> {
        MoreauJean::step(size)
    }
}

#[test]
fn rules_keep_their_order() -> Result<(), Error> {
    let (scene, truth) = (thrown()?, truth(100_000));
    println!("truth: {truth:?}");
    let contacts = Contacts::of([(1, [0.0; 3])], Plane::level(HEIGHT), law());
    let loads = Loads::none().on_bodies_by(contacts);
    macro_rules! ladder {
        ($name:literal, $order:literal, $rule:expr, $loads:expr, $counts:expr) => {{
            let mut points = vec![];
            for n in $counts {
                let start = scene.at_joints(&START[..2], &START[2..])?;
                let run = scene.simulation($rule.step(END / n as f64)).loads(&$loads).run(start, END, |_| ())?;
                let mut found = run.motion.coordinates();
                catena::system::Rate::visit(run.motion.rate(), &mut |x: f64| found.push(x));
                let error = found.iter().zip(truth).fold(0.0, |most, (x, y)| f64::max(most, (x - y).abs()));
                points.push((END / n as f64, error));
            }
            has_order($name, $order, 1e-13, &points);
        }};
    }
    ladder!("RK4", 4.0, Explicitly, loads, [200, 400, 800, 1600, 3200]);
    ladder!("SDIRK4", 4.0, Sdirk4::new(), loads, [200, 400, 800, 1600, 3200]);
    ladder!("Moreau and Jean", 1.0, InRealTime, loads, [800, 1600, 3200, 6400]);
    ladder!("generalised alpha", 2.0, GeneralizedAlpha::new(0.8), loads, [400, 800, 1600, 3200]);
    let plain = Loads::none().on_bodies_by(contacts.plain());
    ladder!("RK4, plain", 4.0, Explicitly, plain, [200, 400, 800, 1600, 3200]);
    Ok(())
}

#[test]
fn energy_never_rises() -> Result<(), Error> {
    let scene = thrown()?;
    let contacts = Contacts::of([(1, [0.0; 3])], Plane::level(HEIGHT), law());
    let loads = Loads::none().on_bodies_by(contacts);
    let (mut last, mut rise) = (f64::INFINITY, 0.0_f64);
    let start = scene.at_joints(&START[..2], &START[2..])?;
    scene.simulation(Sdirk4::new().tolerance(1e-9)).loads(&loads).run(start, 3.0, |now| {
        let stored = now.bodies().get(1).map_or(f64::NAN, |body| contacts.energy(0, body));
        let energy = now.energy() + stored;
        rise = rise.max(energy - last);
        last = energy;
    })?;
    println!("energy rises by {rise:e} J at most");
    assert!(rise < 1e-8 && last.is_finite());
    Ok(())
}

#[test]
fn heights_of_a_slope_are_those_of_a_plane() {
    let (slope, up) = (0.3_f64, 1.09_f64.sqrt());
    let plane = Plane::through([0.0, 0.0, 0.1], [-slope / up, 0.0, 1.0 / up]);
    let heights = Heights(|x: f64, _: f64| [0.1 + slope * x, slope, 0.0]);
    let mut noise = Noise::new(22);
    for _ in 0..100 {
        let place = [noise.next(), noise.next(), noise.next()];
        let ((below, n), (other, m)) = (plane.below(place), heights.below(place));
        near(below, other, 1e-14);
        (0..3).for_each(|k| near(n[k], m[k], 1e-14));
    }
}

#[test]
fn contacts_of_no_body_are_refused() -> Result<(), Error> {
    let contacts = Contacts::of([(2, [0.0; 3])], Plane::level(0.0), law());
    let scene = thrown()?;
    let refused = scene.with_accelerations(scene.motion(), &Loads::none().on_bodies_by(contacts));
    assert!(matches!(refused.map_err(|error| error.fault), Err(catena::Fault::NoSuchBody { body: 2, bodies: 2 })));
    Ok(())
}

/// Angles at which the quadruped stands: hip, thigh and knee of each leg; the last knee turns the other way.
const STANCE: [f64; 12] = [0.0, 0.7, -1.4, 0.0, 0.7, -1.4, 0.0, 0.7, -1.4, 0.0, -0.7, -1.4];
const FEET: [quadruped::Frame; 4] =
    [quadruped::frame::LF_FOOT, quadruped::frame::RF_FOOT, quadruped::frame::LH_FOOT, quadruped::frame::RH_FOOT];

/// It falls by some millimetres onto its feet, and stands by springs and dampers that a controller makes of its motors at 500 Hz.
#[test]
fn a_quadruped_stands() -> Result<(), Error> {
    let scene = quadruped::scene::<f64>()?;
    let points = FEET.map(|foot| (foot.body.unwrap_or(usize::MAX), foot.place));
    let law = Contact::new(1e5, 2e-4).damped(1.0).rubbing(0.8, 1e-4);
    let contacts = Contacts::of(points, Plane::level(0.0), law);
    let mut now = scene.motion();
    let list: Vec<f64> = [0.0, 0.0, 0.41, 1.0, 0.0, 0.0, 0.0].into_iter().chain(STANCE).collect();
    now.set_coordinates(&list)?;
    let (mut next, mut stepper) = (now, scene.stepper(Sdirk4::new()));
    let feet = |now: &_| -> Result<[[f64; 3]; 4], Error> {
        let bodies = scene.body_motions(now)?;
        Ok(points.map(|(body, at)| bodies.get(body).map_or([f64::NAN; 3], |body| body.point(at).place.into())))
    };
    let mass: f64 = scene.body_motions(&now)?.iter().map(|body| body.inertia.mass).sum();
    let (mut landed, mut drift) = (None, 0.0_f64);
    for cycle in 0..5000 {
        let q = now.coordinates();
        let mut rates = vec![];
        catena::system::Rate::visit(now.rate(), &mut |x: f64| rates.push(x));
        let torques = core::array::from_fn(|k| -300.0 * (q[7 + k] - STANCE[k]) - 6.0 * rates[6 + k]);
        let loads = Loads::none().on_bodies_by(contacts).efforts(quadruped::efforts(torques));
        stepper.step(&now, &loads, 2e-3, &mut next)?;
        core::mem::swap(&mut now, &mut next);
        if cycle == 500 {
            landed = Some(feet(&now)?);
        }
        if let Some(landed) = landed {
            for (foot, place) in landed.iter().zip(feet(&now)?) {
                drift = (0..2).fold(drift, |most, k| most.max((foot[k] - place[k]).abs()));
            }
        }
    }
    let bodies = scene.body_motions(&now)?;
    let each = (0..4).map(|k| bodies.get(points[k].0).map_or([f64::NAN; 3], |body| contacts.force(k, body)));
    let sum = each.fold([0.0; 3], |sum, force| core::array::from_fn(|k| sum[k] + force[k]));
    let weight = mass * GRAVITY;
    println!("feet drift by {drift:e} m after the first second; forces sum to {sum:?} of {weight} N");
    println!("trunk at {:?}", &now.coordinates()[..3]);
    assert!(drift < 1e-3, "{drift:e}");
    near(sum[2], weight, 1e-6 * weight);
    Ok(())
}
