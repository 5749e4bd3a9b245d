//! One scene written as a flat tuple, nested tuples, an array and a vector: the same motion bit by bit, and nothing
//! stored that has no parameters.

use catena::loading::{Loading, Unloaded};
use catena::planar::*;
use catena::system::Counted;
use catena::system::Element;
use catena::system::Root;
use catena::system::{Elements, Runs};
use catena::system::{Position, Rate};
use catena::time::{Explicit, Rule};
use catena::{Error, Motion};
use core::f64::consts::PI;
use core::mem::{size_of, size_of_val};
use typenum::Unsigned;

type Plane = Planar<f64>;

const BODIES: usize = 5;

/// Unequal bodies, so that an exchange of two would show.
fn rod(k: usize) -> Rod<f64> {
    let k = k as f64;
    Rod::new(0.5 + 0.1 * k, 1.0 + 0.3 * k, 0.2 + 0.07 * k, 0.05 + 0.01 * k)
}

/// All numbers of a motion by their bits.
fn bits<P: Position<f64>>(motion: &Motion<f64, P>) -> Vec<u64> {
    let mut bits = vec![motion.time().to_bits()];
    Position::visit(motion.position(), &mut |x| bits.push(x.to_bits()));
    Rate::visit(motion.rate(), &mut |x| bits.push(x.to_bits()));
    Rate::visit(motion.acceleration(), &mut |x| bits.push(x.to_bits()));
    bits
}

/// The motions of a scene at every step.
fn motions<R, C, L, M>(root: R, chain: C, loads: &L, rule: Rule<M, f64>) -> Result<Vec<Vec<u64>>, Error>
where
    R: Root<Plane>,
    C: Element<Plane>,
    L: Loading<Plane>,
    M: Explicit,
    System<f64, R, C, Free>: Runs<L, Plane, R, C, Free> + Runs<Unloaded, Plane, R, C, Free>,
{
    let system = System::new(root, chain, Free)?.with_gravity(9.81);
    assert_eq!(system.bodies(), BODIES);
    let angles: Vec<f64> = (0..BODIES).map(|k| 0.4 * k as f64 - 1.0).collect();
    let start = system.at_rest(&angles)?;
    let mut seen = vec![];
    system.simulation(rule).loads(loads).run(start, 3.0, |now| seen.push(bits(now.motion())))?;
    Ok(seen)
}

/// Calls a function with the scene in every form; `mixed` has arrays and vectors in tuples in an array.
macro_rules! every_form {
    (|$chain:ident| $call:expr) => {{
        let link = |k: usize| (Pin, rod(k));
        let flat = {
            let $chain = (rod(0), Pin, rod(1), Pin, rod(2), Pin, rod(3), Pin, rod(4));
            $call
        };
        let nested = {
            let $chain = (((rod(0),), Pin, (rod(1), (Pin, rod(2), Pin))), (rod(3), (Pin, (rod(4),))));
            $call
        };
        let array = {
            let $chain = (rod(0), [1, 2, 3, 4].map(link));
            $call
        };
        let vector = {
            let $chain = (rod(0), (1..BODIES).map(link).collect::<Vec<_>>());
            $call
        };
        let mixed = {
            let $chain = (rod(0), [([link(1)], vec![link(2)]), ([link(3)], vec![link(4)])]);
            $call
        };
        [flat, nested, array, vector, mixed]
    }};
}

/// Every form moves as the first one, bit by bit, at every step and to the end.
fn the_same(what: &str, forms: [Vec<Vec<u64>>; 5]) {
    println!("{what}: {} steps", forms[0].len() - 1);
    assert!(forms[0].len() > 300);
    assert_ne!(forms[0].first(), forms[0].last());
    for form in &forms[1..] {
        assert_eq!(form.len(), forms[0].len());
        for (step, (found, expected)) in form.iter().zip(&forms[0]).enumerate() {
            assert_eq!(found, expected, "{what}, step {step}");
        }
    }
}

#[test]
fn all_forms_of_a_scene_move_alike_bit_by_bit() -> Result<(), Error> {
    let loads = Loads::none()
        .on_bodies(|time: f64, body, motion: &BodyMotion<f64>| {
            let at = motion.point([0.3, 0.1]).velocity * -0.2;
            motion.force_at([0.3, 0.1], [at.x + time, at.y]) + Wrench::torque(0.1 * body as f64)
        })
        .in_joints(|time: f64, joint, motion: &JointMotion<f64>| {
            (time + joint as f64).sin() - 0.3 * motion.rate() - 2.0 * motion.angle()
        });
    let root = Pinned::<[f64; 2]>::origin();
    the_same("RK4", every_form!(|chain| motions(root, chain, &Unloaded, Rk4::step(0.008))?));
    the_same("DOP853, controlled", every_form!(|chain| motions(root, chain, &Unloaded, Dop853::tolerance(1e-13))?));
    the_same("RK4 under loads", every_form!(|chain| motions(root, chain, &loads, Rk4::step(0.008))?));
    the_same("DOPRI5 under loads", every_form!(|chain| motions(root, chain, &loads, Dopri5::tolerance(1e-8))?));
    the_same("DOP853 under loads", every_form!(|chain| motions(root, chain, &loads, Dop853::step(0.008))?));
    the_same("floating", every_form!(|chain| motions(Free, chain, &Unloaded, Rk4::step(0.008))?));
    Ok(())
}

#[test]
fn a_pin_takes_no_space() -> Result<(), Error> {
    assert_eq!((size_of::<Pin>(), align_of::<Pin>()), (0, 1));
    assert_eq!(size_of::<[(Pin, Rod<f64>); 6]>(), size_of::<[Rod<f64>; 6]>());
    assert_eq!(size_of::<(Rod<f64>, Pin, Rod<f64>, Pin, Rod<f32>)>(), size_of::<(Rod<f64>, Rod<f64>, Rod<f32>)>());
    let pinned = System::new(Pinned::origin(), (rod(0), Pin, rod(1), [(Pin, rod(2)), (Pin, rod(3))]), Free)?;
    let welded = System::new(Pinned::origin(), (rod(0), rod(1), [rod(2), rod(3)]), Free)?;
    assert_eq!(size_of_val(&pinned), size_of_val(&welded));
    // Four rods, the place of the root and gravity; ends and the root's joint are types.
    assert_eq!(size_of_val(&pinned), 4 * size_of::<Rod<f64>>() + 2 * size_of::<[f64; 2]>());
    // A motion has a number for each pin, and nothing for a body: time, and position, rate and acceleration.
    assert_eq!(size_of_val(&pinned.motion()), (1 + 3 * 4) * size_of::<f64>());
    Ok(())
}

/// Bodies and degrees of freedom of a chain by its type, and what its value says of bodies.
fn counts<C: Counted + Element<Plane>>(chain: &C) -> (usize, usize) {
    assert_eq!((C::Bodies::USIZE, C::Freedoms::USIZE), (chain.bodies(), chain.joints()));
    (C::Bodies::USIZE, C::Freedoms::USIZE)
}

#[test]
fn types_count_bodies_and_freedoms_of_composed_scenes() -> Result<(), Error> {
    let link = |k: usize| (Pin, rod(k));
    assert_eq!(counts(&rod(0)), (1, 0));
    assert_eq!(counts(&(rod(0),)), (1, 0));
    assert_eq!(counts(&(rod(0), Pin, rod(1))), (2, 1));
    assert_eq!(counts(&(rod(0), Pin, rod(1), PointMass::new(1.0, 1.0))), (3, 1));
    assert_eq!(counts(&(rod(0), [link(1); 4])), (5, 4));
    assert_eq!(counts(&((rod(0), [link(1); 4]), (Pin, RigidBody::new(1.0, 1.0, [0.0; 2], [1.0, 0.0])))), (6, 5));
    assert_eq!(counts(&(rod(0), [([link(1); 3], link(2), [(link(3), link(4)); 2]); 5])), (1 + 5 * 8, 5 * 8));
    assert_eq!(counts(&[(rod(0), rod(1), rod(2)); 7]), (21, 0));
    let e = link(2);
    assert_eq!(counts(&(rod(0), e, e, e, e, e, e, e, e, e, e, e, e, e, e, e)), (16, 15));
    assert_eq!(<Elements<Plane, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>)> as Counted>::Freedoms::USIZE, 2);
    assert_eq!(<Elements<Plane, Free, (Rod<f64>, Pin, Rod<f64>)> as Counted>::Freedoms::USIZE, 4);

    let system = System::new(Pinned::origin(), (rod(0), [link(1), link(2)], Pin, rod(3)), Free)?;
    let motion = system.at_rest(&[0.1, 0.2, 0.3, 0.4])?;
    let angles = system.angles(&motion)?;
    let by_type = [angles.body::<0>(), angles.body::<1>(), angles.body::<2>(), angles.body::<3>()];
    assert_eq!(by_type, [0, 1, 2, 3].map(|k| angles.get(k)));
    assert_eq!(by_type.map(|angle| *angle.unwrap()), [0.1, 0.2, 0.3, 0.4]);
    assert_eq!((angles.len(), angles.get(4)), (4, None));
    Ok(())
}

/// Links without a joint inside hand on a full relation, whatever they meet.
#[test]
fn arrays_of_welded_bodies_meet_a_pin() -> Result<(), Error> {
    let rod = Rod::uniform(0.4, 0.7);
    let array = System::new(Pinned::origin(), ([rod; 3], Pin, rod), Free)?.with_gravity(9.81);
    let tuple = System::new(Pinned::origin(), (rod, rod, rod, Pin, rod), Free)?.with_gravity(9.81);
    let array = array.with_accelerations(array.at_rest(&[0.3, -0.8])?, &Unloaded)?;
    let tuple = tuple.with_accelerations(tuple.at_rest(&[0.3, -0.8])?, &Unloaded)?;
    assert_eq!(numbers(array.acceleration()), numbers(tuple.acceleration()));
    Ok(())
}

/// A chain that floats and whose tip is pinned is a pendulum seen from its other end.
/// Arrays and vectors of links that hand on less than what lies outboard of them.
#[test]
fn links_on_pins_meet_springs_and_torques() -> Result<(), Error> {
    let hinge = ElasticHinge::rotary(7.0).damped(0.2);
    let (link, outer) = (|k: usize| (Pin, rod(k)), (hinge, rod(3), Pin, rod(4)));
    let torques = Loads::none().in_joints(|time: f64, k, _: &JointMotion<f64>| 0.3 * time + k as f64);
    macro_rules! alike {
        ($loads:expr) => {{
            let flat = (rod(0), Pin, rod(1), Pin, rod(2), hinge, rod(3), Pin, rod(4));
            let expected = motions(Pinned::origin(), flat, $loads, Dop853::step(0.05))?;
            let array = (rod(0), [link(1), link(2)], outer);
            assert_eq!(motions(Pinned::origin(), array, $loads, Dop853::step(0.05))?, expected);
            let vector = (rod(0), vec![link(1), link(2)], outer);
            assert_eq!(motions(Pinned::origin(), vector, $loads, Dop853::step(0.05))?, expected);
            let none = (rod(0), Pin, rod(1), Pin, rod(2), Vec::<(Pin, Rod<f64>)>::new(), outer);
            assert_eq!(motions(Pinned::origin(), none, $loads, Dop853::step(0.05))?, expected);
        }};
    }
    alike!(&Unloaded);
    alike!(&torques);
    Ok(())
}

#[test]
fn links_on_balls_meet_springs() -> Result<(), Error> {
    use catena::spatial;
    let rod = |k: usize| spatial::Rod::uniform(0.3 + 0.1 * k as f64, 0.05, 0.5 + 0.2 * k as f64);
    let (link, spring) =
        (|k: usize| (spatial::Ball, rod(k)), spatial::ElasticBall::rotary([3.0, 4.0, 5.0]).damped(0.1));
    macro_rules! run {
        ($chain:expr) => {{
            let system =
                spatial::System::new(spatial::Pinned::origin(), $chain, spatial::Free)?.with_gravity([0.0, -9.81, 0.0]);
            let angles: Vec<f64> = (0..12).map(|k| 0.1 * f64::from(k) - 0.5).collect();
            bits(&system.simulate(system.at_rest(&angles)?, spatial::Rk4::step(0.01), 0.5, |_| ())?.motion)
        }};
    }
    let flat = run!((rod(0), spatial::Ball, rod(1), spatial::Ball, rod(2), spring, rod(3)));
    assert_eq!(run!((rod(0), [link(1), link(2)], spring, rod(3))), flat);
    assert_eq!(run!((rod(0), vec![link(1), link(2)], spring, rod(3))), flat);
    assert_eq!(
        run!((rod(0), link(1), link(2), Vec::<(spatial::Ball, spatial::Rod<f64>)>::new(), spring, rod(3))),
        flat
    );
    Ok(())
}

#[test]
fn a_floating_root_with_a_held_tip_is_the_chain_turned_round() -> Result<(), Error> {
    let (long, short) = (Rod::uniform(0.7_f64, 1.1), Rod::uniform(0.4, 0.5));
    let angles = [0.3, -0.9];
    let hanging = System::new(Pinned::origin(), (long, Pin, short), Free)?.with_gravity(9.81);
    let motion = hanging.with_rates(hanging.at_rest(&angles)?, &[1.2, -0.7])?;
    let motion = hanging.with_accelerations(motion, &Unloaded)?;
    // The same bodies from the free end: directions are opposite.
    let floating = System::new(Free, (short, Pin, long), Pinned::at(0.0, 0.0))?.with_gravity(9.81);
    let mut turned = floating.at_rest(&[angles[1] + PI, angles[0] + PI])?;
    let tip = hanging.stations(&motion, &Unloaded)?.tip().frame;
    (turned.position_mut().0.0, turned.position_mut().0.1) = (tip.place.x, tip.place.y);
    *turned.rate_mut() = ((tip.velocity.x, tip.velocity.y, -0.7), ((), 1.2, ()));
    let turned = floating.with_accelerations(turned, &Unloaded)?;
    let [a, b] = [numbers(motion.acceleration()), numbers(turned.acceleration())];
    for (found, expected) in [(b[3], a[0]), (b[2], a[1]), (b[0], tip.acceleration.linear.x)] {
        assert!((found - expected).abs() < 1e-12, "{found} instead of {expected}");
    }
    let force = hanging.stations(&motion, &Unloaded)?.root().internal.force;
    assert!((turned.multipliers()[0] - force.x).abs() < 1e-12 && (turned.multipliers()[1] - force.y).abs() < 1e-12);
    Ok(())
}

fn numbers(rate: &impl Rate<f64>) -> Vec<f64> {
    let mut all = vec![];
    rate.visit(&mut |x| all.push(x));
    all
}
