//! Names of a description as names of Rust, each once.

use std::collections::HashSet;

/// What the module itself uses.
const RESERVED: [&str; 54] = [
    "Base",
    "Absent",
    "OnGround",
    "Spring",
    "BodyAxes",
    "Hinge",
    "Slide",
    "Link",
    "Level",
    "Quarter",
    "Turned",
    "Branch",
    "Clamped",
    "Coupling",
    "couplings",
    "Effort",
    "Free",
    "Prismatic",
    "Revolute",
    "RigidBody",
    "Rotation",
    "System",
    "Weld",
    "Scalar",
    "Error",
    "Result",
    "Ok",
    "Err",
    "Some",
    "None",
    "Option",
    "Self",
    "Chain",
    "Scene",
    "Frame",
    "Limits",
    "Mimic",
    "Sized",
    "T",
    "chain",
    "scene",
    "efforts",
    "joint",
    "frame",
    "tests",
    "vector",
    "tensor",
    "Motor",
    "BoundedCoulomb",
    "Coulomb",
    "DryFriction",
    "HardStops",
    "Stops",
    "motors",
];

/// Words of the language that a function cannot be named after.
const WORDS: [&str; 52] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do", "dyn", "else",
    "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod",
    "move", "mut", "override", "priv", "pub", "ref", "return", "self", "static", "struct", "super", "trait", "true",
    "try", "type", "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield", "catena",
];

/// Names given out in one scope.
pub struct Scope(HashSet<String>);

impl Scope {
    /// Inside a module.
    pub fn new() -> Self {
        let Self(mut names) = Self::of_language();
        names.extend(RESERVED.map(str::to_owned));
        Self(names)
    }

    /// Where a module stands.
    pub fn of_language() -> Self {
        Self(WORDS.map(str::to_owned).into())
    }

    /// `LfHaa`.
    pub fn of_type(&mut self, name: &str) -> String {
        let camel = words(name).into_iter().map(|word| {
            let (first, rest) = word.split_at(1);
            first.to_ascii_uppercase() + &rest.to_ascii_lowercase()
        });
        self.once(&camel.collect::<String>(), "Arm", "")
    }

    /// `lf_haa`.
    pub fn of_function(&mut self, name: &str) -> String {
        self.once(&words(name).join("_").to_ascii_lowercase(), "arm", "_")
    }

    /// `LF_HAA`.
    pub fn of_constant(&mut self, name: &str) -> String {
        self.once(&words(name).join("_").to_ascii_uppercase(), "N", "_")
    }

    /// The name, or the first of `name_2`, `name_3`, … that is free.
    fn once(&mut self, name: &str, prefix: &str, joiner: &str) -> String {
        let first = if name.starts_with(|c: char| c.is_ascii_alphabetic()) {
            name.to_owned()
        } else {
            format!("{prefix}{}{name}", if name.is_empty() { "" } else { joiner })
        };
        let mut candidate = first.clone();
        let mut count = 1;
        while !self.0.insert(candidate.clone()) {
            count += 1;
            candidate =
                format!("{first}{}{count}", if first.ends_with(|c: char| c.is_ascii_digit()) { "_" } else { joiner });
        }
        candidate
    }
}

/// Runs of letters and digits, `LF_hipJoint2` as LF, hip, Joint2.
fn words(name: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut before = ' ';
    for c in name.chars() {
        let c = if c.is_ascii_alphanumeric() { c } else { ' ' };
        if c != ' ' {
            let begins = before == ' ' || (before.is_ascii_lowercase() && c.is_ascii_uppercase());
            match words.last_mut() {
                Some(word) if !begins => word.push(c),
                _ => words.push(c.to_string()),
            }
        }
        before = c;
    }
    words
}

/// Text for a comment: on one line and in one direction, whatever stands in it.
pub fn comment(name: &str) -> String {
    let leads = |c: char| matches!(c, '\u{2028}' | '\u{2029}' | '\u{202A}'..='\u{202E}' | '\u{2066}'..='\u{2069}');
    name.chars().map(|c| if c.is_control() || leads(c) { ' ' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_names_of_rust_and_given_once() {
        let mut scope = Scope::new();
        assert_eq!(scope.of_type("lf_haa"), "LfHaa");
        assert_eq!(scope.of_type("LF-HAA"), "LfHaa2");
        assert_eq!(scope.of_type("revolute"), "Revolute2");
        assert_eq!(scope.of_type("1st joint"), "Arm1stJoint");
        assert_eq!(scope.of_type("été"), "T2");
        assert_eq!(scope.of_function("loop"), "loop_2");
        assert_eq!(scope.of_constant("leftArmPitch"), "LEFT_ARM_PITCH");
        assert_eq!(scope.of_constant("ねじ"), "N");
        assert_eq!(scope.of_constant("*"), "N_2");
        assert_eq!(scope.of_type("dry friction"), "DryFriction2");
        assert_eq!(scope.of_function("motors"), "motors_2");
    }

    #[test]
    fn comments_are_one_line_that_reads_as_it_is_written() {
        assert_eq!(comment("a\nb\u{2028}c\u{202E}d\u{2066}e\u{2069}f é"), "a b c d e f é");
    }
}
