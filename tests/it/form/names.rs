//! Joints and bodies by number and by name, and motions as lists: against the tuples in which motions are kept.

use catena::planar::*;
use catena::{Error, Fault, spatial};
use catena_oracle::Noise;
use std::collections::BTreeSet;

/// One of each composite in the plane: tuples, an array, a vector, an arm, a loop within a loop, names around all of them.
macro_rules! plane {
    () => {{
        let rod = Rod::uniform(0.5, 1.0);
        let hinge = ElasticHinge::rotary(5.0);
        let inner = Network::new((Pin, rod), (Pin.named("inner"), rod), Pin.named("inner lock"));
        let outer = Network::new((inner, Pin.named("knee"), rod), (Pin, rod, Pin, rod), LeastNorm(Pin).named("lock"));
        let chain = (
            rod.named("base"),
            [(Pin, rod); 2],
            vec![(hinge.named("spring one"), rod.named("first")), (hinge.named("spring two"), rod.named("second"))],
            Branch((Pin.named("wrist"), rod.named("hand"))).named("aside"),
            (outer, (Slider::along(0.3), rod).named("drawer")).named("legs"),
            (Pin.named("tail"),),
            rod,
        );
        System::new(Free.named("root"), chain, Free)?
    }};
}

#[test]
fn lists_of_the_plane_are_the_numbers_in_tuples() -> Result<(), Error> {
    let scene = plane!();
    let mut motion = scene.motion();
    let (n, mut noise) = (motion.coordinate_count(), Noise::new(1));
    assert_eq!((n, motion.rate_count()), (15, 15));
    let mut list = || (0..n).map(|_| noise.next()).collect::<Vec<_>>();
    let (q, v, a) = (list(), list(), list());
    motion.set_coordinates(&q)?;
    motion.set_rates(&v)?;
    motion.set_accelerations(&a)?;
    assert_eq!((motion.coordinates(), motion.rates(), motion.accelerations()), (q.clone(), v.clone(), a.clone()));

    // Joint by joint: its number, its name, its numbers in the tuples.
    let read = |joint: usize| -> (Vec<f64>, Vec<f64>) {
        let (p, r) = (motion.position(), motion.rate());
        let (legs, rates) = (&p.1.4.0.arms, &r.1.4.0.arms);
        let (inner, inner_rates) = (&legs.0.0.arms, &rates.0.0.arms);
        let one = |p: f64, r: f64| (vec![p], vec![r]);
        match joint {
            0 => (vec![p.0.0, p.0.1, p.0.2], vec![r.0.0, r.0.1, r.0.2]),
            1 => one(p.1.1[0].0, r.1.1[0].0),
            2 => one(p.1.1[1].0, r.1.1[1].0),
            3 => one(p.1.2[0].0, r.1.2[0].0),
            4 => one(p.1.2[1].0, r.1.2[1].0),
            5 => one(p.1.3.0, r.1.3.0),
            6 => one(inner.0.0, inner_rates.0.0),
            7 => one(inner.1.0, inner_rates.1.0),
            9 => one(legs.0.1, rates.0.1),
            10 => one(legs.1.0, rates.1.0),
            11 => one(legs.1.2, rates.1.2),
            13 => one(p.1.4.1.0, r.1.4.1.0),
            14 => one(p.1.5.0, r.1.5.0),
            _ => (vec![], vec![]), // 8 and 12 close loops
        }
    };
    assert_eq!(scene.joints(), 15);
    let mut met = 0;
    for joint in 0..15 {
        let numbers = scene.joint(joint)?;
        let (position, rate) = read(joint);
        assert_eq!(numbers.joint, joint);
        assert_eq!(&q[numbers.coordinates()], position, "joint {joint}");
        assert_eq!(&v[numbers.rates()], rate, "joint {joint}");
        met += position.len();
    }
    assert_eq!(met, n);
    let names = [
        ("root", 0),
        ("spring one", 3),
        ("spring two", 4),
        ("wrist", 5),
        ("inner", 7),
        ("inner lock", 8),
        ("knee", 9),
        ("lock", 12),
        ("drawer", 13),
        ("tail", 14),
    ];
    for (name, joint) in names {
        assert_eq!(scene.joint(name)?, scene.joint(joint)?, "{name}");
    }
    // What has no name of its own has that of what it is in.
    for (name, body, station) in [("base", 0, 0), ("second", 4, 8), ("hand", 5, 10), ("drawer", 11, 24)] {
        let numbers = scene.body(name)?;
        assert_eq!((numbers.body, numbers.station), (body, station), "{name}");
    }

    // One joint set leaves the others.
    let (knee, root) = (scene.joint("knee")?, scene.joint("root")?);
    motion.set_coordinates_of(knee, &[0.75])?;
    motion.set_rates_of(root, &[1.0, 2.0, 3.0])?;
    motion.set_accelerations_of(knee, &[4.0])?;
    assert_eq!((motion.position().1.4.0.arms.0.1, motion.rate().0), (0.75, (1.0, 2.0, 3.0)));
    assert_eq!(motion.acceleration().1.4.0.arms.0.1, 4.0);
    let changed = |old: &[f64], new: &[f64]| old.iter().zip(new).filter(|(old, new)| old != new).count();
    let counts = [(&q, motion.coordinates()), (&v, motion.rates()), (&a, motion.accelerations())];
    assert_eq!(counts.map(|(old, new)| changed(old, &new)), [1, 3, 1]);
    assert_eq!(motion.coordinates_of(knee)?, [0.75]);
    assert_eq!((motion.rates_of(root)?, motion.accelerations_of(knee)?), ([1.0, 2.0, 3.0], [4.0]));
    Ok(())
}

#[test]
fn lists_of_space_are_the_numbers_in_tuples() -> Result<(), Error> {
    use spatial::{
        Ball, Cylindrical, ElasticHinge, Free, Network, Prismatic, Revolute, Rod, Spring, System, Universal,
    };
    let rod = Rod::uniform(0.5, 0.02, 1.0);
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let spring = Spring::stiffness(10.0);
    let mount = ElasticHinge::rotary([5.0; 3]).with_linear(spring, spring, spring);
    let looped = Network::new((Ball.named("hip"), rod), (Revolute::about(z), rod, Ball, rod), Ball.named("lock"));
    let chain = (
        rod,
        [(Ball, rod); 2],
        Branch((Universal::about(y, z).named("wrist"), rod.named("hand"))),
        looped,
        vec![(mount.named("mount"), rod)],
        (Prismatic::along(x).named("rail"), rod, Cylindrical::on(x).named("bolt"), rod),
    );
    let scene = System::new(Free, chain, Free)?;
    let mut motion = scene.motion();
    assert_eq!(
        (motion.coordinate_count(), motion.rate_count()),
        (7 + 8 + 2 + 4 + 1 + 4 + 7 + 1 + 2, 6 + 6 + 2 + 3 + 1 + 3 + 6 + 1 + 2)
    );

    // Quaternions of any length are brought to length one, the others' numbers stay; then nothing changes any more.
    let mut noise = Noise::new(2);
    let given: Vec<f64> = (0..motion.coordinate_count()).map(|_| noise.between(0.3, 2.0)).collect();
    motion.set_coordinates(&given)?;
    let set = motion.coordinates();
    for (joint, turn) in
        [(0, Some(3)), (1, Some(0)), (2, Some(0)), (3, None), (4, Some(0)), (6, Some(0)), (8, Some(3)), (10, None)]
    {
        let range = scene.joint(joint)?.coordinates();
        let (given, set) = (&given[range.clone()], &set[range]);
        let start = turn.unwrap_or(given.len());
        assert_eq!(given[..start], set[..start], "joint {joint}");
        if turn.is_some() {
            let length = given[start..].iter().map(|x| x * x).sum::<f64>().sqrt();
            for (given, set) in given[start..].iter().zip(&set[start..]) {
                assert!((given / length - set).abs() < 4e-16, "joint {joint}: {given} / {length} != {set}");
            }
        }
    }
    let before = motion.clone();
    motion.set_coordinates(&set)?;
    assert_eq!(motion, before);

    let (p, numbers) = (motion.position(), |name: &str| scene.joint(name));
    assert_eq!(motion.coordinates_of(scene.joint(0)?)?, {
        let ([x, y, z], [a, b, c, d]) = (p.0.0, p.0.1.quaternion());
        [x, y, z, a, b, c, d]
    });
    assert_eq!(motion.coordinates_of(scene.joint(2)?)?, p.1.1[1].0.quaternion());
    assert_eq!(motion.coordinates_of(numbers("wrist")?)?, p.1.2.0);
    assert_eq!(motion.coordinates_of(numbers("hip")?)?, p.1.3.arms.0.0.quaternion());
    assert_eq!(motion.coordinates_of(scene.joint(5)?)?, [p.1.3.arms.1.0]);
    assert_eq!(motion.coordinates_of(numbers("lock")?)?, []);
    assert_eq!(motion.coordinates_of(numbers("rail")?)?, [p.1.5.0]);
    assert_eq!(motion.coordinates_of(numbers("bolt")?)?, p.1.5.2);
    let rates: Vec<f64> = (0..motion.rate_count()).map(|_| noise.next()).collect();
    motion.set_rates(&rates)?;
    let r = motion.rate();
    assert_eq!(motion.rates(), rates);
    assert_eq!(motion.rates_of(numbers("hip")?)?, r.1.3.arms.0.0);
    assert_eq!(motion.rates_of(numbers("mount")?)?, {
        let ([x, y, z], [a, b, c]) = r.1.4[0].0;
        [x, y, z, a, b, c]
    });
    assert_eq!(motion.rates_of(numbers("bolt")?)?, r.1.5.2);
    assert_eq!((scene.body("hand")?.body, scene.body("hand")?.station), (3, 6));
    Ok(())
}

#[test]
fn what_is_not_there_is_an_error() -> Result<(), Error> {
    let scene = plane!();
    let mut motion = scene.motion();
    let fault = |error: Result<_, Error>| error.map(|_: ()| ()).map_err(|error| error.fault);
    assert_eq!(fault(scene.joint(15).map(|_| ())), Err(Fault::NoSuchJoint { joint: 15, joints: 15 }));
    let bodies = scene.bodies();
    assert_eq!(fault(scene.body(bodies).map(|_| ())), Err(Fault::NoSuchBody { body: bodies, bodies }));
    let message = |error: Result<(), Error>| error.map_err(|error| error.to_string());
    // A body's name is none of a joint, and the other way round.
    for name in ["elbow", "base", ""] {
        assert_eq!(message(scene.joint(name).map(|_| ())), Err(format!("there is no joint named \"{name}\"")));
    }
    for name in ["wrist", "lock"] {
        assert_eq!(message(scene.body(name).map(|_| ())), Err(format!("there is no body named \"{name}\"")));
    }
    let several = message(scene.joint("legs").map(|_| ()));
    assert_eq!(several, Err("\"legs\" names 3 of kind joint: reach them by number".into()));
    let long = message(scene.joint("eine Grübelei über Gelenke").map(|_| ()));
    assert_eq!(long, Err("there is no joint named \"eine Grübelei über Ge...\"".into()));

    let count = |list, expected, given| Err(Fault::Count { list, expected, given });
    let (knee, root, lock) = (scene.joint("knee")?, scene.joint("root")?, scene.joint("lock")?);
    for given in [0, 14, 16] {
        let mut list = vec![0.5; given];
        assert_eq!(fault(motion.set_coordinates(&list)), count("coordinates", 15, given));
        assert_eq!(fault(motion.set_rates(&list)), count("rates", 15, given));
        assert_eq!(fault(motion.set_accelerations(&list)), count("accelerations", 15, given));
        assert_eq!(fault(motion.coordinates_into(&mut list)), count("numbers to be copied", 15, given));
        assert_eq!(fault(motion.rates_into(&mut list)), count("numbers to be copied", 15, given));
        assert_eq!(fault(motion.accelerations_into(&mut list)), count("numbers to be copied", 15, given));
    }
    assert_eq!(fault(motion.set_coordinates_of(knee, &[])), count("coordinates", 1, 0));
    assert_eq!(fault(motion.set_rates_of(root, &[0.5; 4])), count("rates", 3, 4));
    assert_eq!(fault(motion.set_accelerations_of(lock, &[0.5])), count("accelerations", 0, 1));
    assert_eq!(fault(motion.coordinates_of::<2>(knee).map(|_| ())), count("numbers of a joint", 1, 2));
    let nan = |parameter| Err(Fault::NotFinite { parameter });
    assert_eq!(fault(motion.set_coordinates_of(knee, &[f64::NAN])), nan("coordinate"));
    assert_eq!(fault(motion.set_rates(&[f64::INFINITY; 15])), nan("rates"));
    assert_eq!(fault(motion.set_accelerations_of(knee, &[f64::NAN])), nan("accelerations"));
    assert_eq!(motion, scene.motion()); // as it was

    // A joint of a longer scene.
    let chain = |links: usize| {
        let rod = Rod::uniform(1.0, 1.0);
        System::new(Pinned::origin(), (rod, vec![(Pin, rod); links]), Free)
    };
    let (far, mut short) = (chain(3)?.joint(3)?, chain(2)?.motion());
    assert_eq!(fault(short.coordinates_of::<1>(far).map(|_| ())), Err(Fault::Shape));
    assert_eq!(fault(short.set_coordinates_of(far, &[0.5])), Err(Fault::Shape));
    assert_eq!(fault(short.set_rates_of(far, &[0.5])), Err(Fault::Shape));

    // A quaternion without length.
    let pendulum = {
        use spatial::{Pinned, Rod, System};
        System::new(Pinned::origin(), Rod::uniform(1.0, 0.1, 1.0), spatial::Free)?
    };
    let mut hanging = pendulum.motion();
    let none = Err(Fault::NotPositive { parameter: "length of the quaternion", value: 0.0 });
    assert_eq!(fault(hanging.set_coordinates(&[0.0; 4])), none);
    assert_eq!(hanging.coordinates(), [1.0, 0.0, 0.0, 0.0]);
    Ok(())
}

#[test]
fn descriptions_list_each_station_once() -> Result<(), Error> {
    let scene = plane!();
    let table = scene.describe().to_string();
    let rows: Vec<&str> = table.lines().skip(1).collect();
    // The root, each body and joint but the root's, the tip.
    assert_eq!(rows.len(), scene.bodies() + scene.joints() + 1);
    let first = |row: &&str| row.split_whitespace().next().map(str::to_owned);
    let stations: BTreeSet<String> = rows.iter().filter_map(first).collect();
    assert_eq!(stations.len(), rows.len());
    let knee = scene.joint("knee")?;
    let row = rows[knee.station.map_or(0, |station| station + 1)];
    let words: Vec<&str> = row.split_whitespace().collect();
    let coordinate = knee.coordinates().start.to_string();
    assert_eq!(words, ["16", "9", coordinate.as_str(), coordinate.as_str(), "Pin", "knee"]);
    assert!(rows.iter().any(|row| row.ends_with("LeastNorm     lock")), "{table}");
    Ok(())
}
