//! What is read, what is lumped, what is noted, and at which lines.

use catena_urdf::{Base, Carrier, Frames, Laws, Options, Remark, Robot, module};

const ARM: &str = include_str!("../robots/arm7.urdf");
const QUADRUPED: &str = include_str!("../robots/quadruped.urdf");
const HUMANOID: &str = include_str!("../robots/humanoid.urdf");
const CART: &str = include_str!("../robots/cart.urdf");

fn read(text: &str, options: Options) -> Robot {
    options.read(text).expect("a robot")
}

/// The line of a text where a piece of it stands.
fn line(text: &str, piece: &str) -> usize {
    1 + text.lines().position(|line| line.contains(piece)).expect("a line")
}

#[test]
fn fixed_links_are_lumped_and_stay_as_frames() {
    let robot = read(ARM, Options::new().frames(Frames::AsWritten));
    let flange = robot.bodies().last().expect("bodies");
    assert!((flange.inertia.mass - (0.32 + 0.75 + 0.12)).abs() < 1e-15);
    // The common mass centre along the axis; the camera's axes lean, its centre 10 mm along its own z.
    let camera = 0.02 + 0.01 * 0.1_f64.cos() * 0.35_f64.cos();
    let along = (0.32 * 0.018 + 0.75 * (0.045 + 0.06) + 0.12 * camera) / 1.19;
    assert!((flange.inertia.centre[2] - along).abs() < 1e-15);
    let tip = robot.frames().iter().find(|frame| frame.name == "tool_tip").expect("a frame");
    assert_eq!(tip.carrier, Carrier::Body(6));
    assert!((tip.pose.place[2] - 0.185).abs() < 1e-15);
    assert!((tip.pose.turn[1][0] - 0.5_f64.sqrt()).abs() < 1e-15);
}

#[test]
fn hinges_lie_along_coordinate_axes_and_turn_nothing_between() {
    for text in [ARM, QUADRUPED] {
        let robot = read(text, Options::new().snap(1e-4));
        for body in robot.bodies() {
            assert!(body.axis.iter().filter(|x| **x == 0.0).count() == 2, "{}: {:?}", body.joint, body.axis);
            assert_eq!(body.pose.turn, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        }
    }
    // Hips, ankles and shoulders lean, each in a coordinate plane: what is left turns about one axis alone.
    let robot = read(HUMANOID, Options::new());
    let mut left = vec![];
    for body in robot.bodies() {
        let turn = body.pose.turn;
        match (0..3).filter(|k| turn[*k][*k] == 1.0).collect::<Vec<_>>()[..] {
            [_, _, _] => (),
            [axis] => left.push((body.joint.as_str(), axis)),
            _ => panic!("{}: {turn:?}", body.joint),
        }
    }
    let legs = |side: &[&'static str; 3]| side.map(|joint| (joint, 1)).to_vec();
    let arms = |side: &[&'static str; 2]| side.map(|joint| (joint, 0)).to_vec();
    let expected = [
        legs(&["left_hip_roll", "left_hip_yaw", "left_ankle_roll"]),
        legs(&["right_hip_roll", "right_hip_yaw", "right_ankle_roll"]),
        arms(&["left_shoulder_pitch", "left_shoulder_yaw"]),
        arms(&["right_shoulder_pitch", "right_shoulder_yaw"]),
    ];
    assert_eq!(left, expected.concat());
}

#[test]
fn right_angles_are_snapped_on_request_and_reported() {
    let snapped = |robot: &Robot| -> Vec<_> {
        let notes = robot.notes().iter().filter(|note| matches!(note.remark, Remark::Snapped { .. }));
        notes.flat_map(|note| note.lines.clone()).collect()
    };
    assert!(snapped(&read(QUADRUPED, Options::new())).is_empty());
    let lines = [line(QUADRUPED, "rpy=\"3.14159 0 0\""), line(QUADRUPED, "rpy=\"0 0 1.5708\"")];
    assert_eq!(snapped(&read(QUADRUPED, Options::new().snap(1e-4))), lines);
    // 1.5708 is 3.7e-6 too much.
    assert_eq!(snapped(&read(QUADRUPED, Options::new().snap(3e-6))), lines[..1]);
}

#[test]
fn what_is_left_out_is_noted_with_its_lines() {
    let notes: Vec<_> = read(ARM, Options::new()).notes().iter().map(ToString::to_string).collect();
    let visual = format!("line {}: <visual> in <link> is left out", line(ARM, "<visual>"));
    assert!(notes.contains(&visual), "{notes:#?}");
    assert!(notes.iter().any(|note| note.ends_with("the mass of what is fixed to the ground is left out")));
    let notes: Vec<_> = read(QUADRUPED, Options::new()).notes().iter().map(ToString::to_string).collect();
    let gazebo = format!("line {}: <gazebo> in <robot> is left out", line(QUADRUPED, "<gazebo"));
    assert!(notes.contains(&gazebo), "{notes:#?}");
}

#[test]
fn impossible_inertias_are_reported_and_repaired_on_request() {
    let finger = line(CART, "<link name=\"left_finger\">") + 1;
    let found = |robot: &Robot| -> Vec<_> {
        let remark = |remark: &Remark| match remark {
            Remark::Impossible { deficit, repaired, .. } => Some((*deficit, *repaired)),
            _ => None,
        };
        robot.notes().iter().filter_map(|note| Some((note.lines.clone(), remark(&note.remark)?))).collect()
    };
    // (1 + 1 − 2.4)/2 of 4.4.
    let [(lines, (deficit, repaired))] = &found(&read(CART, Options::new()))[..] else { panic!("one note") };
    assert_eq!((lines.as_slice(), *repaired), ([finger].as_slice(), false));
    assert!((deficit + 0.2 / 4.4).abs() < 1e-12);
    assert!(read(CART, Options::new()).notes().iter().any(|note| matches!(note.remark, Remark::Doubtful { .. })));

    let repaired = read(CART, Options::new().repair().frames(Frames::AsWritten));
    assert!(found(&repaired)[0].1.1);
    assert!(!repaired.notes().iter().any(|note| matches!(note.remark, Remark::Doubtful { .. })));
    let finger = repaired.bodies().iter().find(|body| body.joint == "left_grip").expect("a finger");
    // Second moments 1.2, 1.2 and −0.2 became 1.2, 1.2 and 0.
    let [[xx, ..], [_, yy, _], [.., zz]] = finger.inertia.tensor;
    let off = [xx - 1.2e-5, yy - 1.2e-5, zz - 2.4e-5];
    assert!(off.iter().all(|off| off.abs() < 1e-19), "{xx} {yy} {zz}");
}

#[test]
fn the_base_floats_where_written_or_wanted() {
    assert!(read(QUADRUPED, Options::new()).base().is_some());
    assert!(read(HUMANOID, Options::new()).base().is_none());
    let pelvis = read(HUMANOID, Options::new().base(Base::Floating));
    assert_eq!(pelvis.base().map(|base| base.mass), Some(5.2));
}

#[test]
fn a_floating_joint_of_a_fixed_base_is_a_fixed_one() {
    let still = QUADRUPED.replace("type=\"floating\"", "type=\"fixed\"");
    let fixed = read(QUADRUPED, Options::new().base(Base::Fixed));
    let expected = read(&still, Options::new());
    assert!(fixed.base().is_none());
    assert_eq!((fixed.bodies(), fixed.frames()), (expected.bodies(), expected.frames()));
}

#[test]
fn each_joint_with_limits_has_a_motor_or_a_note() {
    let joint = |name: &str, limit: &str, reduction: &str| {
        format!(
            r#"<link name="{name}"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
            <joint name="{name}" type="continuous"><parent link="ground"/><child link="{name}"/>{limit}</joint>
            <transmission name="{name}"><type>simple</type><joint name="{name}"/><actuator name="{name}">
            <mechanicalReduction>{reduction}</mechanicalReduction></actuator></transmission>"#
        )
    };
    let limit = r#"<limit effort="50" velocity="3"/>"#;
    let text = [
        joint("geared", limit, "79.2"),
        joint("reversed", limit, "-79.2"),
        joint("without", limit, "0"),
        joint("weak", r#"<limit effort="0" velocity="3"/>"#, "1"),
        joint("slow", r#"<limit effort="50"/>"#, "1"),
        joint("free", "", "1"),
    ];
    let text = format!("<robot name=\"r\"><link name=\"ground\"/>{}</robot>", text.concat());
    let robot = read(&text, Options::new().laws(Laws::none().motors()));
    let written = module(&robot, "r");
    let motors: Vec<_> = written.lines().map(str::trim).skip_while(|line| !line.contains("pub fn motors")).collect();
    assert!(motors[2].starts_with("Some(Motor::new(") && motors[2].ends_with(".geared(T::literal(79.2))),"));
    assert_eq!(motors[2], motors[3]);
    assert_eq!(motors[4..8], ["None,"; 4]);
    let without = robot.notes().iter().filter_map(|note| match &note.remark {
        Remark::NoMotor { joint } => Some(joint.as_str()),
        _ => None,
    });
    assert_eq!(without.collect::<Vec<_>>(), ["without", "weak", "slow"]);
    let remarks = read(&text, Options::new());
    assert!(!remarks.notes().iter().any(|note| matches!(note.remark, Remark::NoMotor { .. })));
}

#[test]
fn a_held_joint_is_a_fixed_one() {
    let free = read(CART, Options::new().repair());
    let held = read(CART, Options::new().repair().hold("left_grip", 0.01).hold("swing", 0.3));
    assert_eq!(held.bodies().len(), free.bodies().len() - 2);
    let q = |robot: &Robot, of: &dyn Fn(&str) -> f64| {
        let mut state = catena_urdf::State::zero(robot);
        state.q = robot.bodies().iter().map(|body| of(&body.joint)).collect();
        state
    };
    let angle = |joint: &str| match joint {
        "left_grip" => 0.01,
        "swing" => 0.3,
        other => 0.05 * other.len() as f64,
    };
    let (all, some) = (free.mass_matrix(&q(&free, &angle)), held.mass_matrix(&q(&held, &angle)));
    let kept: Vec<_> =
        (0..all.len()).filter(|k| !["left_grip", "swing"].contains(&&*free.bodies()[*k].joint)).collect();
    for (row, i) in some.iter().zip(&kept) {
        for (x, k) in row.iter().zip(&kept) {
            assert!((x - all[*i][*k]).abs() < 1e-13);
        }
    }
    let error = Options::new().hold("nobody", 0.0).read(CART).expect_err("no such joint");
    assert_eq!(error.to_string(), "what is to be held names joint \"nobody\", which is not there");
}

#[test]
fn furniture_stands_among_the_constants() {
    let text = module(&read(CART, Options::new().repair()), "cart");
    for piece in [
        "pub const JOINTS: [&str; 8] = [\"drive/first\", \"drive/second\", \"drive\", \"lift\", \"swing\", \"nod\", \"left_grip\", \"right_grip\"];",
        "pub const RIGHT_GRIP: usize = 7;",
        "pub const DAMPING: [f64; 8] = [0.0, 0.0, 0.0, 120.0, 0.4, 0.1, 2.0, 2.0];",
        "pub const REDUCTION: [Option<f64>; 8] = [None, None, None, Some(40.0), Some(50.0), None, None, None];",
        "    Mimic { joint: \"right_grip\", of: \"left_grip\", multiplier: 1.0, offset: 0.0 },",
        "Clamped::at(vector([0.0, 0.0, 0.0]), Rotation::identity())",
    ] {
        assert!(text.contains(piece), "{piece}");
    }
}

#[test]
fn a_module_has_no_test_where_none_is_wanted() {
    assert!(module(&read(ARM, Options::new()), "arm").contains("#[cfg(test)]"));
    assert!(!module(&read(ARM, Options::new().without_test()), "arm").contains("#[cfg(test)]"));
}

#[test]
fn furniture_of_planar_joints_is_left_out_with_a_note() {
    let dynamics =
        "<dynamics damping=\"3.0\" friction=\"0.5\"/>\n    <limit effort=\"10\" velocity=\"1\"/>\n  </joint>";
    let planar = CART.find("  <joint name=\"drive\"").expect("the drive");
    let end = planar + CART[planar..].find("</joint>").expect("its end");
    let text = format!("{}{dynamics}{}", &CART[..end], &CART[end + "</joint>".len()..]);
    for laws in [Laws::none(), Laws::none().damping().friction([0.01; 2]).stops([0.1; 2], [0.0; 2])] {
        let robot = Options::new().repair().laws(laws).read(&text).expect("a cart");
        let notes: Vec<_> = robot.notes().iter().map(|note| note.remark.to_string()).collect();
        for element in ["limit", "dynamics"] {
            let note = format!("<{element}> in <joint type=\"planar\"> is left out");
            assert!(notes.contains(&note), "{note}: {notes:?}");
        }
    }
}

/// A trolley on a jib: what turns the jib resists by 100 q² wherever the trolley may be, and not at q = 0, where it may not.
#[test]
fn inertia_is_looked_at_within_limits_however_far_from_zero() {
    let crane = |limit: &str| {
        format!(
            r#"<robot name="crane"><link name="ground"/><link name="jib"/><link name="trolley"><inertial><mass value="100"/>
            <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
            <joint name="slew" type="continuous"><parent link="ground"/><child link="jib"/><axis xyz="0 0 1"/></joint>
            <joint name="travel" type="prismatic"><parent link="jib"/><child link="trolley"/><axis xyz="1 0 0"/>
            <limit {limit} effort="1" velocity="1"/></joint></robot>"#
        )
    };
    for limit in [r#"lower="2" upper="30""#, r#"lower="-30" upper="-2""#, r#"lower="2" upper="2.1""#] {
        let robot = read(&crane(limit), Options::new());
        let text = module(&robot, "crane");
        let positions = text.split_once("POSITIONS: [f64; 2] = [").and_then(|(_, rest)| rest.split_once(']'));
        let travel: f64 = positions.and_then(|(list, _)| list.split(", ").nth(1)?.parse().ok()).expect("two numbers");
        let limits = &robot.bodies()[1].furniture;
        assert!(limits.lower < travel && travel < limits.upper && (2.0..2.5).contains(&travel.abs()), "{travel}");
    }
    assert!(Options::new().read(&crane(r#"lower="0" upper="0""#)).is_err());
}

#[test]
fn modules_have_names_of_rust_and_else_their_own() {
    let robot = read(ARM, Options::new());
    let named = |name: &str, module_is: &str| {
        assert!(module(&robot, name).contains(&format!("\npub mod {module_is} {{\n")), "{name}: {module_is}");
    };
    for name in ["chain", "scene", "frame", "joint", "vector", "tensor", "tests", "efforts", "motors", "arm7"] {
        named(name, name);
    }
    named("loop", "loop_2");
    named("2dof", "arm_2dof");
    named("leftArm-2", "left_arm_2");
}

/// What joints leave open of their bodies' axes leaves but four numbers of six (Denavit and Hartenberg), and where axes meet fewer: of an arm whose
/// shoulder, elbow and wrist are points three lengths along axes are left, and no turn but those of a cube.
#[test]
fn zeros_of_an_arm_show_in_body_axes() {
    let robot = read(ARM, Options::new().elements(catena_urdf::Elements::Local));
    let lengths: Vec<_> = robot.bodies().iter().map(|body| body.pose.place).collect();
    let (o, along) = ([0.0; 3], |z| [0.0, 0.0, z]);
    assert_eq!(lengths, [along(0.35), o, o, along(0.42), o, along(0.4), o]);
    let text = module(&robot, "arm");
    assert!(!text.contains("Turned") && text.matches("Ahead<").count() == 1, "{text}"); // the flange's mass centre is brought into a plane
}

/// A hinge that leans in a plane of its parent's, and one after it that does not: the parent's axes lean with the first.
#[test]
fn turns_about_the_axis_of_a_hinge_become_angles() {
    let inertial = "<inertial><origin xyz=\"0.1 0.2 0.3\"/><mass value=\"1\"/>\
        <inertia ixx=\"1\" ixy=\"0.1\" ixz=\"0.2\" iyy=\"1\" iyz=\"0.3\" izz=\"1\"/></inertial>";
    let joint = |k: usize, axis: &str, rpy: &str| {
        format!(
            "<link name=\"l{k}\">{inertial}</link><joint name=\"j{k}\" type=\"continuous\"><origin xyz=\"0 0 0\" rpy=\"{rpy}\"/>\
             <axis xyz=\"{axis}\"/><parent link=\"l{}\"/><child link=\"l{k}\"/></joint>",
            k - 1
        )
    };
    let joints = [joint(1, "0 1 0", "0 0 0"), joint(2, "1 0 0", "0 0.3 0"), joint(3, "0 0 1", "0 0 0")].concat();
    let text = format!("<robot name=\"leaning\"><link name=\"l0\"/>{joints}</robot>");
    let robot = read(&text, Options::new().elements(catena_urdf::Elements::Local));
    let text = module(&robot, "leaning");
    assert!(!text.contains("Turned"), "{text}");
    let angle = text.split(".ahead(T::literal(").nth(1).and_then(|rest| rest.split(')').next()).expect("an angle");
    assert!((angle.parse::<f64>().expect("a number") - 0.3).abs() < 1e-15, "{angle}");
}

/// A library without `std` has no `vec!` in its tests.
#[test]
fn tests_of_modules_need_no_allocator() {
    for elements in [catena_urdf::Elements::Inertial, catena_urdf::Elements::Local] {
        let text = module(&read(QUADRUPED, Options::new().elements(elements).base(Base::Floating)), "quadruped");
        assert!(text.contains("wrenches") && !text.contains("vec!"));
    }
}
