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
