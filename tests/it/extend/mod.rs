//! Elements of another crate: those of the examples, against the same things composed of the library's own and against equations by hand.

mod checks;
#[path = "../../../examples/elements/geared.rs"]
mod geared;
#[path = "../../../examples/elements/gimbal.rs"]
mod gimbal;
mod own_body;
mod own_gimbal;
mod own_joint;
#[path = "../../../examples/elements/tank.rs"]
mod tank;

#[test]
fn an_element_of_ones_own_takes_forty_lines() {
    for (name, text) in [
        ("geared", include_str!("../../../examples/elements/geared.rs")),
        ("gimbal", include_str!("../../../examples/elements/gimbal.rs")),
        ("tank", include_str!("../../../examples/elements/tank.rs")),
    ] {
        let lines = text.lines().count();
        println!("{name}: {lines} lines, imports, comments and blank ones among them");
        assert!(lines <= 40, "{name}");
        assert!(text.contains("catena::joint!") || text.contains("catena::compound!"), "{name} is no element");
    }
}
