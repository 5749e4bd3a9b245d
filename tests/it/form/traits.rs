//! Traits stay small: one with many items is a wall for whoever builds or reads. Items are what stands in a trait itself, required or provided;
//! those of supertraits are theirs.

use super::layers::sources;
use std::error::Error;
use std::fs;
use std::path::Path;

/// Most items of a public trait.
const MOST: usize = 20;

/// Names of public traits, with their numbers of items.
fn traits(text: &str) -> Vec<(String, usize)> {
    let code: String = text.lines().flat_map(|line| [line.split("//").next().unwrap_or_default(), "\n"]).collect();
    let name = |text: &str| text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect::<String>();
    let body = |text: &str| text.find('{').map_or(0, |start| items(&text[start + 1..]));
    code.split("pub trait ").skip(1).map(|rest| (name(rest), body(rest))).collect()
}

/// How many items there are up to the brace that closes them.
fn items(text: &str) -> usize {
    let (mut depth, mut start, mut count) = (0_usize, 0, 0);
    for (at, c) in text.char_indices() {
        match c {
            '{' | '(' | '[' => depth += 1,
            '}' if depth == 0 => break,
            '}' | ')' | ']' => depth -= 1,
            _ => (),
        }
        if depth == 0 && (c == ';' || c == '}') {
            let item = &text[start..at];
            count += usize::from(item.split_whitespace().any(|word| ["fn", "type", "const"].contains(&word)));
            start = at + c.len_utf8();
        }
    }
    count
}

#[test]
fn items_of_traits_are_counted() {
    let text = "/// A pub trait of words; fn none.\npub trait Empty {}\npub trait Two<const N: usize>: Sized {\n    type Of<X: Copy>: Clone;\n\
                \n    fn list(&self) -> [f64; 2] {\n        let x = [0.0; 2]; // ; }\n        if true { x } else { x }\n    }\n}\n\
                trait Own {\n    fn own();\n}\npub trait Three: Two<2>\nwhere\n    Self: Copy,\n{\n    const ON: bool = if true { true } else { false };\n\
                    #[inline]\n    fn a<T>(self, f: impl Fn(T) -> T);\n    fn b() {}\n}\n";
    let found: Vec<(String, usize)> = traits(text);
    let found: Vec<(&str, usize)> = found.iter().map(|(name, count)| (name.as_str(), *count)).collect();
    assert_eq!(found, [("Empty", 0), ("Two", 2), ("Three", 3)]);
}

#[test]
fn public_traits_have_few_items() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut files, mut found) = (vec![], vec![]);
    sources(&root.join("src"), &mut files)?;
    for path in &files {
        let file = path.strip_prefix(root)?.display().to_string();
        found.extend(traits(&fs::read_to_string(path)?).into_iter().map(|(name, count)| (count, name, file.clone())));
    }
    found.sort();
    println!("{} public traits, the largest {:?}", found.len(), found.last());
    assert!(found.len() > 100, "traits are no longer found");
    let large: Vec<_> = found.iter().filter(|(count, ..)| *count > MOST).collect();
    assert!(large.is_empty(), "more than {MOST} items: {large:?}");
    Ok(())
}

/// Traits that users implement: laws, joints, grounds, loads, surfaces, walks. All others are implemented by this crate alone, by its macros, or by
/// numbers.
const OF_USERS: [&str; 13] = [
    "ForceLaw",
    "Ground",
    "Inward",
    "JointModel",
    "Kinematics",
    "LoadLaw",
    "MotionLaw",
    "Outward",
    "RotaryLaw",
    "SpringLaw",
    "Surface",
    "TimeLaw",
    "Walk",
];

/// Names of traits that a text implements for something.
fn implemented(text: &str) -> Vec<String> {
    let mut found = vec![];
    for rest in text.split("impl").skip(1) {
        let Some(head) = rest.split_once(" for ").map(|(head, _)| head).filter(|head| !head.contains(['{', ';']))
        else {
            continue;
        };
        // Parameters of the implementation, then the path of the trait and its own.
        let (mut depth, mut path) = (0_i32, String::new());
        for c in head.chars() {
            match c {
                '<' => depth += 1,
                '>' => depth -= 1,
                c if depth == 0 => path.push(c),
                _ => (),
            }
        }
        found.extend(path.trim().rsplit("::").next().map(str::to_owned));
    }
    found
}

#[test]
fn users_implement_few_traits() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut files, mut names) = (vec![], vec![]);
    sources(&root.join("src"), &mut files)?;
    let mut texts = vec![];
    for path in &files {
        let text = fs::read_to_string(path)?;
        names.extend(traits(&text).into_iter().map(|(name, _)| name));
        let doc = text.lines().filter_map(|line| line.trim_start().strip_prefix("//"));
        texts.push(doc.map(|line| line.trim_start_matches(['/', '!', ' ', '#'])).collect::<Vec<_>>().join("\n"));
    }
    let mut examples = vec![];
    sources(&root.join("examples"), &mut examples)?;
    for path in &examples {
        texts.push(fs::read_to_string(path)?);
    }
    let mut found: Vec<String> =
        texts.iter().flat_map(|text| implemented(text)).filter(|name| names.contains(name)).collect();
    found.sort();
    found.dedup();
    println!("documentation and examples implement {found:?}");
    assert!(found.len() >= 8, "implementations are no longer found: {found:?}");
    assert!(found.iter().all(|name| OF_USERS.contains(&name.as_str())), "{found:?}");
    assert!(OF_USERS.iter().all(|name| names.iter().any(|other| other == name)), "one of these is no trait any more");
    Ok(())
}
