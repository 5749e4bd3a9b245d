//! Descriptions that must be refused, each with the message that its first line says.

use catena_urdf::{Laws, Options};
use std::error::Error;
use std::fs;

#[test]
fn each_is_refused_with_its_message() -> Result<(), Box<dyn Error>> {
    let mut count = 0;
    for entry in fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/refused"))? {
        let path = entry?.path();
        let text = fs::read_to_string(&path)?;
        let first = text.lines().next().unwrap_or_default();
        let expected = first.strip_prefix("<!-- ").and_then(|line| line.strip_suffix(" -->")).ok_or("no message")?;
        let message = Options::new().read(&text).map_or_else(|error| error.to_string(), |_| "read".to_owned());
        assert_eq!(message, expected, "{}", path.display());
        count += 1;
    }
    assert!(count >= 24, "{count} files");
    Ok(())
}

#[test]
fn laws_that_make_no_mechanics_are_refused() -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/refused/negative_damping.urdf"))?;
    let text = text.replace("-0.1", "0.1");
    let read = |laws: Laws| Options::new().laws(laws).read(&text).map(|_| ()).map_err(|error| error.to_string());
    let (friction, stops) = (|x, y| read(Laws::none().friction([x, y])), |a, b| read(Laws::none().stops(a, b)));
    assert_eq!(friction(0.01, 0.01), Ok(()));
    assert_eq!(stops([0.1, 0.1], [0.0, 0.0]), Ok(()));
    let speed = |value: f64| Err(format!("a speed over which friction sets in must be positive, not {value}"));
    assert_eq!(friction(0.0, 0.01), speed(0.0));
    assert_eq!(friction(0.01, f64::NAN), speed(f64::NAN));
    assert_eq!(stops([0.1, -0.1], [0.0; 2]), Err("a depth of stops must be positive, not -0.1".to_owned()));
    assert_eq!(stops([f64::INFINITY, 0.1], [0.0; 2]), Err("a depth of stops must be positive, not inf".to_owned()));
    assert_eq!(stops([0.1; 2], [0.0, -1.0]), Err("damping of stops must be zero or more, not -1".to_owned()));
    Ok(())
}

#[test]
fn options_that_are_no_numbers_are_refused() -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/refused/negative_damping.urdf"))?;
    let text = text.replace("-0.1", "0.1");
    let read = |options: Options| options.read(&text).map(|_| ()).map_err(|error| error.to_string());
    for (value, said) in [(f64::NAN, "NaN"), (f64::INFINITY, "inf")] {
        let held = format!("where a joint is held must be finite, not {said}");
        assert_eq!(read(Options::new().hold("j", value)), Err(held));
        let gravity = format!("gravity must be finite, not {said}");
        assert_eq!(read(Options::new().gravity([0.0, value, -9.81])), Err(gravity));
        let snap = format!("a tolerance of right angles (rad) must be from 0 to 0.1, not {said}");
        assert_eq!(read(Options::new().snap(value)), Err(snap));
    }
    // A degree, mistaken for a radian: every axis would be along x.
    let snap = "a tolerance of right angles (rad) must be from 0 to 0.1, not 1";
    assert_eq!(read(Options::new().snap(1.0)), Err(snap.to_owned()));
    Ok(())
}

/// A planar joint is three in a scene, whose type is as long.
#[test]
fn joints_are_counted_as_what_they_become() {
    let body = r#"<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>"#;
    let chain = |kind: &str, joints: usize| {
        let links = (1..=joints).map(|k| format!(r#"<link name="l{k}">{body}</link>"#)).collect::<String>();
        let joint = |k: usize| {
            let inboard = k - 1;
            format!(
                r#"<joint name="j{k}" type="{kind}"><parent link="l{inboard}"/><child link="l{k}"/><limit effort="1" velocity="1"/></joint>"#
            )
        };
        let joints = (1..=joints).map(joint).collect::<String>();
        format!(r#"<robot name="r"><link name="l0"/>{links}{joints}</robot>"#)
    };
    let read = |kind: &str, joints: usize| {
        Options::new().read(&chain(kind, joints)).map(|robot| robot.bodies().len()).map_err(|error| error.to_string())
    };
    assert_eq!(read("planar", 20), Ok(60));
    assert_eq!(read("planar", 171), Err("513 moving joints are more than 512".to_owned()));
    assert_eq!(read("continuous", 513), Err("513 moving joints are more than 512".to_owned()));
}
