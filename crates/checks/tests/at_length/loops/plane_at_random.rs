//! Accelerations, reactions and closure forces of loops in the plane, of random parameters, against a dense system of Newton-Euler
//! equations with multipliers in which loops are nothing special.

mod grow;

use catena::Error;
use catena::loading::Unloaded;
use catena::planar::*;
use catena::system::Element;
use catena::system::{MotionOf, Runs};
use catena::system::{Position, Rate};
use catena::system::{Root, Tip};
use catena_oracle::space as oracle;
use catena_oracle::space::{Answer, Vector};
use grow::*;

/// Relative to the largest acceleration or reaction: a hundred times what rounding leaves in the dense system.
const TOLERANCE: f64 = 1e-12;
/// By how much ends of loops may miss each other (m, m/s).
const CLOSED: f64 = 1e-13;
/// Scenes of each shape.
const SEEDS: u64 = 20;

/// A scene, and what is to be compared.
struct Case {
    plan: Plan,
    /// The last body of the chain, and how its outboard end is held.
    last: usize,
    tip: oracle::Tip,
    torques: Vec<f64>,
    forces: Vec<[f64; 2]>,
}

/// Forces and torques on bodies, at their inboard ends, and torques in joints.
type Given = Loads<Values<Vec<Wrench<f64>>>, Values<Vec<f64>>>;
const GRAVITY: [f64; 2] = [0.3, -9.81];

impl Case {
    fn of(mut plan: Plan, last: Option<usize>) -> Self {
        let n = plan.bodies.len();
        let noise = &mut plan.noise;
        let torques = (0..plan.joints).map(|_| noise.next()).collect();
        let forces = (0..n).map(|_| noise.pair().map(|x| 3.0 * x)).collect();
        Self { last: last.unwrap_or(n - 1), plan, tip: oracle::Tip::Free, torques, forces }
    }

    fn loads(&self) -> Given {
        let wrench = |force: &[f64; 2]| Wrench { force: (*force).into(), torque: 0.5 };
        Loads::none().wrenches(self.forces.iter().map(wrench).collect()).torques(self.torques.clone())
    }

    /// A motion at random, near which loops are to be closed.
    fn guess<R, C, P>(&mut self, system: &System<f64, R, C, P>) -> Result<MotionOf<Planar<f64>, R, C, P>, Error>
    where
        R: Root<Planar<f64>>,
        C: Element<Planar<f64>>,
        P: Tip<Planar<f64>>,
    {
        let Plan { kinds, noise, .. } = &mut self.plan;
        let turning = kinds.iter().filter(|kind| matches!(kind, Kind::Pin | Kind::Hinge(_))).count();
        let angles: Vec<f64> = (0..turning).map(|_| noise.between(-1.2, 1.2)).collect();
        let mut motion = system.at_rest(&angles)?;
        let mut sliding = kinds.iter().filter(|kind| !matches!(kind, Kind::Fixed(_)));
        motion
            .position_mut()
            .replace(&mut |x| if let Some(Kind::Slider(_)) = sliding.next() { 0.2 * noise.next() } else { x });
        motion.rate_mut().replace(&mut |_| 2.0 * noise.next());
        Ok(motion)
    }

    fn answer(&self, position: &[f64], rate: &[f64]) -> Answer {
        let Plan { parents, bodies, kinds, joint, loops, .. } = &self.plan;
        let mut next = position.iter().copied().zip(rate.iter().copied());
        let mut bodies = bodies.clone();
        for (twin, force) in bodies.iter_mut().zip(&self.forces) {
            (twin.force, twin.torque) = (flat(*force), axial(0.5));
        }
        let joints: Vec<oracle::Joint> = (0..bodies.len())
            .map(|k| {
                let torque = joint[k].map_or(0.0, |j| self.torques[j]);
                let (z, at) = (Vector::z(), |angle: f64| oracle::about(Vector::z(), angle));
                let mut coordinate = || next.next().unwrap_or((f64::NAN, f64::NAN));
                match kinds[k] {
                    Kind::Fixed(angle) => oracle::Joint::Weld { attitude: at(angle) },
                    Kind::Pin => {
                        let (angle, rate) = coordinate();
                        // A ball in the plane turns about z alone.
                        oracle::Joint::Ball { attitude: at(angle), spin: axial(rate), torque: axial(torque) }
                    }
                    Kind::Hinge([stiffness, damping, rest]) => {
                        let (angle, rate) = coordinate();
                        let torque = torque - stiffness * (angle - rest) - damping * rate;
                        oracle::Joint::Revolute { axis: z, angle, rate, torque }
                    }
                    Kind::Slider([direction, stiffness, damping, rest]) => {
                        let (slide, rate) = coordinate();
                        let force = torque - stiffness * (slide - rest) - damping * rate; // a load along the line
                        let axis = Vector::new(direction.cos(), direction.sin(), 0.0);
                        oracle::Joint::Prismatic { axis, slide, rate, force }
                    }
                }
            })
            .collect();
        let closing = |it: &Loop| {
            let along = vec![Vector::x(), Vector::y()];
            let (about, torque) = if it.welded { (vec![Vector::z()], 0.0) } else { (vec![], self.torques[it.joint]) };
            oracle::Closing { main: it.main, side: it.side, along, about, torque: axial(torque) }
        };
        let closings: Vec<_> = loops.iter().map(closing).collect();
        let (ground, held) = (oracle::Frame::still(), (self.last, self.tip));
        oracle::solve_closed(ground, flat(GRAVITY), parents, &bodies, &joints, held, &closings)
    }

    /// The largest difference of accelerations and reactions from the oracle's, relative to the largest number there.
    fn difference<R, C, P>(&self, system: &System<f64, R, C, P>, motion: &MotionOf<Planar<f64>, R, C, P>) -> f64
    where
        R: Root<Planar<f64>>,
        C: Element<Planar<f64>>,
        P: Tip<Planar<f64>>,
    {
        let (mut position, mut rate) = (vec![], vec![]);
        motion.position().visit(&mut |x| position.push(x));
        motion.rate().visit(&mut |x| rate.push(x));
        let answer = self.answer(&position, &rate);
        assert!(answer.residual < CLOSED, "loops miss by {:.1e}", answer.residual);
        let all = answer.linear.iter().chain(&answer.angular).chain(&answer.forces).chain(&answer.torques);
        let size = all.fold(1.0_f64, |size, v| size.max(v.amax()));

        let bodies = system.body_motions(motion).unwrap();
        let stations = system.stations(motion, &self.loads()).unwrap();
        let parts = |station: &Station<f64>| {
            let place = flat(station.frame.place.into());
            (flat(station.internal.force.into()), axial(station.torque_outboard()), place)
        };
        let at =
            |k: usize| stations.get(k).map_or((Vector::zeros() * f64::NAN, Vector::zeros(), Vector::zeros()), parts);
        let mut worst = 0.0_f64;
        let mut note = |what: &str, k: usize, found: Vector, expected: Vector| {
            let difference = (found - expected).amax() / size;
            assert!(
                difference < TOLERANCE,
                "{what} {k}: {found:?} instead of {expected:?}, {difference:.1e} of {size:.1e}"
            );
            worst = worst.max(difference);
        };
        assert_eq!((bodies.len(), system.joints()), (self.plan.bodies.len(), self.plan.joints));
        let mut foot = [Vector::zeros(); 2];
        for (k, body) in bodies.iter().enumerate() {
            note("acceleration", k, flat(body.centre().acceleration.linear.into()), answer.linear[k]);
            note("turn", k, axial(body.inboard.acceleration.angular), answer.angular[k]);
            let inboard = self.plan.stations[k];
            let (force, torque, place) = at(inboard);
            note("force", k, force, answer.forces[k]);
            note("torque", k, torque, answer.torques[k]);
            // The station before is that of the joint; the root's is none of the chain's.
            let jointed = self.plan.joint[k].is_some_and(|joint| joint > 0);
            let (joint_force, joint_torque, joint_place) = at(inboard - usize::from(jointed));
            note("force of joint", k, joint_force, answer.forces[k]);
            let moved = answer.torques[k] + (place - joint_place).cross(&answer.forces[k]);
            note("torque of joint", k, joint_torque, moved);
            if self.plan.parents[k].is_none() {
                foot[0] += answer.forces[k];
                foot[1] += moved;
            }
        }
        let (force, torque, _) = parts(stations.root());
        note("force of the root", 0, force, foot[0]);
        note("torque of the root", 0, torque, foot[1]);
        let (force, torque, _) = parts(stations.tip());
        note("force of the tip", 0, -force, answer.tip[0]);
        note("torque of the tip", 0, -torque, answer.tip[1]);
        for (number, (it, [force, torque])) in self.plan.loops.iter().zip(&answer.closings).enumerate() {
            let (found, turning, _) = at(it.station);
            note("force of closing", number, found, *force);
            note("torque of closing", number, turning, *torque);
        }
        worst
    }
}

/// Numbers of seeds tried and closed, and the largest difference.
#[derive(Default)]
struct Tally {
    tried: usize,
    closed: usize,
    worst: f64,
}

impl Tally {
    fn count(&mut self, outcome: Result<f64, Error>) {
        self.tried += 1;
        if let Ok(difference) = outcome {
            self.closed += 1;
            self.worst = self.worst.max(difference);
        }
    }

    #[track_caller]
    fn conclude(&self, name: &str) {
        let Self { tried, closed, worst } = self;
        println!("{name}: {closed} of {tried} closed, largest relative difference {worst:.1e}");
        assert!(2 * closed >= *tried, "{name}: only {closed} of {tried} closed");
    }
}

/// Closes a scene and compares it; an error where it cannot be closed. A number of coordinates to be moved, or none for a guess of its
/// own.
fn compare<R, C, P>(
    case: &mut Case,
    system: Result<System<f64, R, C, P>, Error>,
    near: Option<&[Vec<f64>; 2]>,
) -> Result<f64, Error>
where
    R: Root<Planar<f64>>,
    C: Element<Planar<f64>>,
    P: Tip<Planar<f64>>,
    System<f64, R, C, P>: Runs<Given, Planar<f64>, R, C, P>,
{
    let system = system?.with_gravity_vector(GRAVITY.into());
    let mut guess = case.guess(&system)?;
    if let Some([position, rate]) = near {
        let (mut x, mut v) = (position.iter(), rate.iter());
        let noise = &mut case.plan.noise;
        guess.position_mut().replace(&mut |old| x.next().map_or(old, |x| x + 0.1 * noise.next()));
        guess.rate_mut().replace(&mut |old| v.next().copied().unwrap_or(old));
    }
    let motion = system.assembled(guess, &case.loads())?;
    Ok(case.difference(&system, &motion))
}

/// Coordinates and rates of a closed motion with a free tip, and the place, velocity, angle and rate of that.
fn freely<C>(case: &mut Case, chain: C) -> Result<([Vec<f64>; 2], Frame<f64>), Error>
where
    C: Element<Planar<f64>>,
    System<f64, Pinned<[f64; 2]>, C, Free>:
        Runs<Unloaded, Planar<f64>, Pinned<[f64; 2]>, C, Free> + Runs<Given, Planar<f64>, Pinned<[f64; 2]>, C, Free>,
{
    let (system, loads) = (System::new(Pinned::origin(), chain, Free)?, case.loads());
    let guess = case.guess(&system)?;
    let closed = system.assembled(guess, &loads)?;
    let mut coordinates = [vec![], vec![]];
    closed.position().visit(&mut |x| coordinates[0].push(x));
    closed.rate().visit(&mut |x| coordinates[1].push(x));
    Ok((coordinates, system.stations(&closed, &loads).unwrap().tip().frame))
}

/// Scenes of a shape with a free tip, on a pin.
macro_rules! shapes {
    ($($name:ident: $shape:ty;)+) => {$(
        #[test]
        fn $name() {
            let mut tally = Tally::default();
            for seed in 0..SEEDS {
                let mut plan = Plan::new(seed);
                let (chain, last) = <$shape>::grow(&mut plan, None);
                plan.pin_first();
                let mut case = Case::of(plan, last);
                tally.count(compare(&mut case, System::new(Pinned::origin(), chain, Free), None));
            }
            tally.conclude(stringify!($name));
        }
    )+};
}

shapes! {
    a_loop: (Bare, Net<(Link, Link), (Link, Link)>);
    a_loop_of_rods: (Bare, Net<(Bar, Bar), (Bar, Bar)>, Bar);
    a_chain_goes_on: (Bare, Net<(Link, Link), (Link, Bar)>, Link, Bar);
    a_loop_closed_by_a_weld: (Bare, Net<(Link, Link, Link), (Link, Link), Weld<f64>>, Link);
    loops_in_branches: (Bare, Arm<Net<(Link, Link), (Bar, Link)>>, Link, Arm<(Link, Net<(Link, Link), (Link, Link)>, Link)>, Link);
    a_loop_in_a_branch_of_a_loop: (Bare, Net<(Link, Arm<(Link, Net<(Link, Link), (Link, Link)>)>, Link), (Link, Link)>, Link);
    a_network_in_a_main_arm: (Bare, Net<(Link, Net<(Link, Link), (Link, Link)>, Link), (Link, Link, Link, Link)>, Link);
    a_network_in_a_side_arm: (Bare, Net<(Link, Link, Link), (Link, Net<(Link, Link), (Link, Link)>)>, Link);
    three_arms: (Bare, Net<Net<(Link, Link), (Link, Link)>, (Link, Link)>, Link);
    three_arms_at_the_side: (Bare, Net<(Link, Link), Net<(Link, Link), (Link, Link)>>, Link);
    four_arms: (Bare, Net<Net<Net<(Link, Link), (Link, Link)>, (Link, Link)>, (Link, Link)>, Link);
    two_pairs_of_arms: (Bare, Net<Net<(Link, Link), (Link, Link)>, Net<(Link, Link), (Link, Link)>>);
    springs_in_arms: (Bare, Net<(Sprung, Link), (Link, Sprung)>, Link);
    springs_everywhere: (Bare, Net<(Sprung, Sprung, Sprung), (Sprung, Sprung), Weld<f64>>, Sprung);
    springs_in_nested_arms: (Bare, Net<(Sprung, Net<(Link, Sprung), (Sprung, Link)>, Link), (Link, Link, Sprung)>);
    sliders_in_arms: (Bare, Net<(Slid, Link), (Link, Link)>, Slid);
    a_slider_within_an_arm: (Bare, Net<(Link, Slid, Link), (Link, Bar)>, Link);
    welds_in_arms: (Bare, Net<(Link, Fixed, Link), (Link, Link, Fixed)>, Fixed, Link);
    arms_that_begin_with_bodies: (Bare, Net<(Bare, Link), (Link, Link)>, Link);
    a_side_arm_that_begins_with_a_body: (Bare, Net<(Link, Link, Link), (Bare, Link)>, Bare);
    loops_on_their_own_body: (Bare, Arm<Net<Reach, (Link, Link, Link)>>, Link, Arm<Net<Reach, (Link, Link, Link, Link), Weld<f64>>>);
    an_array_of_loops: (Bare, [(Link, Net<(Link, Link), (Link, Link)>); 3]);
    a_vector_of_loops: (Bare, Many<(Link, Net<(Link, Link), (Link, Link)>), 4>, Link);
    a_vector_of_bare_loops: (Bare, Many<Net<(Link, Link), (Link, Link)>, 3>);
    an_arm_that_is_a_vector: (Bare, Net<Many<Link, 3>, Many<Bar, 2>>, Link);
}

/// The same with arms that begin at the ground.
macro_rules! grounded {
    ($($name:ident: $shape:ty;)+) => {$(
        #[test]
        fn $name() {
            let mut tally = Tally::default();
            for seed in 0..SEEDS {
                let mut plan = Plan::new(seed);
                let (chain, last) = <$shape>::grow(&mut plan, None);
                let mut case = Case::of(plan, last);
                tally.count(compare(&mut case, System::new(Clamped::at(0.0, 0.0, 0.0), chain, Free), None));
            }
            tally.conclude(stringify!($name));
        }
    )+};
}

grounded! {
    a_linkage: Net<(Link, Link), (Reach, Link)>;
    a_linkage_with_a_chain: (Net<(Link, Link, Link), (Reach, Link, Link)>, Link);
    a_linkage_closed_by_a_weld: Net<(Link, Link), (Reach, Link, Link), Weld<f64>>;
    three_arms_of_a_platform: Net<Net<(Link, Link, Link), (Reach, Link, Link), Weld<f64>>, (Reach, Link, Link)>;
}

/// The same with the tip held, by a pin or a clamp that moves.
macro_rules! held {
    ($($name:ident: $shape:ty;)+) => {$(
        #[test]
        fn $name() {
            let [mut pinned, mut clamped] = [Tally::default(), Tally::default()];
            for seed in 0..SEEDS {
                let mut plan = Plan::new(seed);
                let (chain, last) = <$shape>::grow(&mut plan, None);
                plan.pin_first();
                let mut case = Case::of(plan, last);
                let Ok((near, tip)) = freely(&mut case, chain.clone()) else {
                    pinned.tried += 1;
                    continue;
                };
                let (place, velocity) = (tip.place.into(), tip.velocity.into());
                let (acceleration, angular) = (case.plan.noise.pair(), case.plan.noise.next());
                let moving = Moving(move |_: f64| GroundMotion { place, velocity, acceleration });
                case.tip = oracle::Tip::Pinned(flat(acceleration));
                let scene = System::new(Pinned::origin(), chain.clone(), Pinned::on(moving));
                pinned.count(compare(&mut case, scene, Some(&near)));
                let turning = Turning(move |_: f64| [tip.turn.angle, tip.turn.rate, angular]);
                case.tip = oracle::Tip::Clamped(flat(acceleration), axial(angular));
                let scene = System::new(Pinned::origin(), chain, Clamped { place: moving, attitude: turning });
                clamped.count(compare(&mut case, scene, Some(&near)));
            }
            pinned.conclude(concat!(stringify!($name), ", pinned"));
            clamped.conclude(concat!(stringify!($name), ", clamped"));
        }
    )+};
}

held! {
    a_loop_before_a_held_tip: (Bare, Net<(Link, Link), (Link, Link)>, Link, Link, Link);
    a_tip_held_where_a_loop_ends: (Bare, Link, Net<(Link, Link, Link), (Link, Link, Link)>);
    a_tip_held_beyond_three_arms: (Bare, Net<Net<(Link, Link, Link), (Link, Link)>, (Link, Link, Link)>, Link, Bar);
    loops_in_branches_of_a_held_chain: (Bare, Arm<(Link, Net<(Link, Link), (Link, Link)>)>, Link, Net<(Link, Link), (Link, Link)>, Link);
    springs_in_loops_before_a_held_tip: (Bare, Net<(Sprung, Sprung), (Link, Sprung), Weld<f64>>, Sprung, Link, Link, Link);
    a_vector_of_loops_before_a_held_tip: (Bare, Many<(Link, Net<(Link, Link), (Link, Link)>), 3>, Link, Bar);
}
