//! Nothing is left out or changed without a note, and a module imports what it uses.

use catena_urdf::{Base, Elements, Laws, Options, Robot, module};

const ROBOTS: [&str; 4] = [
    include_str!("../robots/arm7.urdf"),
    include_str!("../robots/quadruped.urdf"),
    include_str!("../robots/humanoid.urdf"),
    include_str!("../robots/cart.urdf"),
];

/// Joints a and b in a chain, b follows a; what a has in it, and what else stands in the robot.
fn pair(kind: &str, inside: &str, more: &str) -> String {
    let body = r#"<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>"#;
    format!(
        r#"<robot name="r"><link name="ground"/><link name="one">{body}</link><link name="two">{body}</link>
        <joint name="a" type="{kind}"><parent link="ground"/><child link="one"/>{inside}</joint>
        <joint name="b" type="continuous"><parent link="one"/><child link="two"/><mimic joint="a"/></joint>{more}</robot>"#
    )
}

fn read(text: &str, options: Options) -> Robot {
    options.read(text).expect("a robot")
}

fn notes(robot: &Robot) -> Vec<String> {
    robot.notes().iter().map(|note| note.remark.to_string()).collect()
}

const FURNITURE: &str = r#"<limit effort="5" velocity="1"/><dynamics damping="1" friction="1"/>"#;

#[test]
fn furniture_of_joints_that_do_not_move_is_left_out_with_a_note() {
    let held = read(&pair("continuous", FURNITURE, ""), Options::new().hold("a", 0.3));
    let fixed = read(&pair("fixed", FURNITURE, ""), Options::new());
    for (robot, inside) in [(held, "joint"), (fixed, "joint type=\"fixed\"")] {
        let found = notes(&robot);
        let left_out = |element: &str| format!("<{element}> in <{inside}> is left out");
        let follows =
            "joint \"b\" follows \"a\", which has no coordinate of its own: left out, it moves by itself unless it is held, too".to_owned();
        assert_eq!(found[..3], [follows, left_out("limit"), left_out("dynamics")]);
        assert!(!module(&robot, "r").contains("MIMICS"));
    }
    let free = read(&pair("continuous", FURNITURE, ""), Options::new());
    assert!(module(&free, "r").contains("of: \"a\""));
}

#[test]
fn a_joint_is_held_once() {
    let text = pair("continuous", "", "");
    let error = Options::new().hold("a", 0.1).hold("a", 0.2).read(&text).expect_err("two places");
    assert_eq!(error.to_string(), "joint \"a\" is to be held twice");
}

#[test]
fn what_stands_inside_a_transmission_is_noted() {
    let transmission = r#"<transmission name="t"><type>simple</type><joint name="a"/>
        <actuator name="m"><mechanicalReduction>50</mechanicalReduction><motorInertia>1e-4</motorInertia></actuator></transmission>
        <transmission name="u"><mechanical_reduction>3</mechanical_reduction><joint name="b"><offset>1</offset></joint></transmission>"#;
    let robot = read(&pair("continuous", "", transmission), Options::new());
    let found = notes(&robot);
    for note in ["<motorInertia> in <actuator> is left out", "<offset> in <joint> is left out"] {
        assert!(found.iter().any(|found| found == note), "{note}: {found:?}");
    }
    assert!(!found.iter().any(|note| note.contains("eduction> in")), "{found:?}");
    assert_eq!([0, 1].map(|k| robot.bodies()[k].furniture.reduction), [Some(50.0), Some(3.0)]);
}

#[test]
fn a_vocabulary_without_a_prefix_is_that_of_the_description() {
    let text = pair("continuous", FURNITURE, "");
    let named = text.replace("<robot ", "<robot xmlns=\"http://www.ros.org\" xmlns:x=\"http://x\" x:name=\"other\" ");
    let (robot, expected) = (read(&named, Options::new()), read(&text, Options::new()));
    assert_eq!((robot.name(), robot.bodies()), (expected.name(), expected.bodies()));
    assert!(notes(&robot).contains(&"x:name of <robot> is left out".to_owned()), "{:?}", notes(&robot));
    let foreign = text.replace("<robot ", "<robot xmlns:x=\"http://x\" ").replace("<limit ", "<x:limit ");
    assert!(read(&foreign, Options::new()).bodies()[0].furniture.effort.is_infinite());
}

#[test]
fn each_repair_is_noted() {
    // A second moment of −1e-8 of 4: less than rounding in files, and more than of numbers.
    let text = pair("continuous", "", "").replacen("izz=\"1\"", "izz=\"2.00000002\"", 1);
    assert!(!notes(&read(&text, Options::new())).iter().any(|note| note.contains("no body has")));
    let repaired = notes(&read(&text, Options::new().repair()));
    let note = "no body has the moments of inertia of \"one\": a second moment is -2.5e-7 % of the trace; it became zero, the others stay";
    assert!(repaired.iter().any(|found| found == note), "{repaired:?}");
}

/// What exporters write for "unlimited": numbers whose difference, stiffness or torque is none any more.
#[test]
fn limits_as_large_as_numbers_make_no_laws() {
    let laws = Laws::none().stops([0.02, 0.002], [1.0, 10.0]).motors();
    let (huge, joint) = ("1.79769e308", |range: &str, limit: &str| {
        let text = pair("revolute", &format!("<limit {range} {limit}/>"), "");
        read(&text, Options::new().laws(laws))
    });
    let ordinary = joint("lower=\"-1\" upper=\"1\"", "effort=\"10\" velocity=\"1\"");
    let says = |robot: &Robot, note: &str| notes(robot).iter().any(|found| found.starts_with(note));
    let (constant, no_motor) = ("a limit of position is among the constants", "joint \"a\" has no motor");
    assert!(!says(&ordinary, constant) && !says(&ordinary, no_motor) && module(&ordinary, "r").contains("Stops"));
    let far = joint(&format!("lower=\"-{huge}\" upper=\"{huge}\""), "effort=\"10\" velocity=\"1\"");
    assert!(says(&far, constant) && !says(&far, no_motor));
    let strong = joint("lower=\"-1\" upper=\"1\"", &format!("effort=\"{huge}\" velocity=\"1\""));
    assert!(says(&strong, constant) && says(&strong, no_motor));
    for robot in [far, strong] {
        let text = module(&robot, "r");
        assert!(!text.contains("Stops") && !text.contains("literal(f64::"), "{text}");
    }
}

/// A joint turned about one axis says which entries of its turn are zero and one; one that is turned anyhow does not.
#[test]
fn turns_are_written_with_what_is_known_of_them() {
    let of = |angles: &str| {
        let inside = format!(r#"<origin rpy="{angles}"/><axis xyz="1 0 0"/>"#);
        module(&read(&pair("continuous", &inside, ""), Options::new().elements(Elements::Local)), "r")
    };
    let (about_one, anyhow) = (of("0 0 0.4"), of("0.1 0.2 0.4"));
    assert!(about_one.contains("Hinge<T, Turned<T, ") && about_one.contains(".known::<"), "{about_one}");
    assert!(anyhow.contains("Hinge<T, Turned<T>, "), "{anyhow}");
}

#[test]
fn modules_import_what_they_use() {
    let all = Laws::none().damping().friction([0.1; 2]).stops([0.02; 2], [1.0; 2]).motors();
    let sticking = [Laws::none().sticking(), all.sticking()];
    let some = [Laws::none(), Laws::none().damping(), Laws::none().friction([0.1; 2]), all, sticking[0], sticking[1]];
    let striking = [Laws::none(), all, sticking[0], sticking[1]].map(|laws| laws.hard_stops(0.3));
    let (pair, mut modules) = (pair("continuous", FURNITURE, ""), 0);
    for text in ROBOTS.into_iter().chain([pair.as_str()]) {
        for elements in [Elements::Inertial, Elements::Local, Elements::LocalGeneral] {
            for (laws, base) in some
                .into_iter()
                .chain(striking)
                .flat_map(|laws| [Base::Written, Base::Floating].map(|base| (laws, base)))
            {
                // Without an inertia the base does not float.
                let options = Options::new().repair().elements(elements).laws(laws).base(base);
                let Ok(robot) = options.read(text) else { continue };
                modules += 1;
                let text = module(&robot, "r");
                let (imports, rest) = text.split_once("};").expect("imports");
                let list = imports.split_once('{').and_then(|(_, list)| list.split_once('{')).expect("a list").1;
                for name in list.split(", ") {
                    let word = |c: char| c.is_alphanumeric() || c == '_';
                    assert!(rest.split(|c| !word(c)).any(|found| found == name), "{name}: {elements:?}, {laws:?}");
                }
            }
        }
    }
    assert!(modules > 80, "{modules} modules");
}
