//! First lines of documentation name their subject: lists of items and tips of editors show them alone.

use super::layers::sources;
use std::error::Error;
use std::fs;
use std::path::Path;

/// First words that lean on the item above.
const BARE: [&str; 11] =
    ["The same", "It", "Its", "They", "Their", "Them", "Those", "That of", "This is", "One that", "One of them"];

/// Words before a pronoun that still leaves the subject open: "Whether it turns".
const QUESTIONS: [&str; 7] = ["What", "Whether", "Where", "How", "When", "Which", "By how much"];

fn starts_with_words(line: &str, words: &str) -> bool {
    line.strip_prefix(words).is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric()))
}

fn names_no_subject(line: &str) -> bool {
    let asks = |words: &&str| {
        let rest = line.strip_prefix(*words).map(str::trim_start);
        rest.is_some_and(|rest| ["it", "they", "its", "their"].iter().any(|word| starts_with_words(rest, word)))
    };
    BARE.iter().any(|words| starts_with_words(line, words)) || QUESTIONS.iter().any(asks)
}

/// First lines of doc comments, with their numbers, counted from 1.
fn first_lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut inside = false;
    text.lines().enumerate().filter_map(move |(k, line)| {
        let line = line.trim_start();
        let doc = line.strip_prefix("///").or_else(|| line.strip_prefix("//!"));
        let first = doc.filter(|_| !inside);
        inside = doc.is_some();
        first.map(|doc| (k + 1, doc.trim_start()))
    })
}

#[test]
fn lines_without_a_subject_are_seen() {
    let text = "//! It.\n\n/// Rate of the driven coordinate (rad/s).\n/// Its sign is that of the force.\n    /// Whether it turns.\n\
                fn f() {} // It is no documentation.\n/// That of a name.\n/// Items in a list.\n/// The same, turned.\nlet x;\n\
                /// Whether items are left.\nlet y;\n/// The same, turned.\n";
    let lines: Vec<usize> = first_lines(text).map(|(k, _)| k).collect();
    assert_eq!(lines, [1, 3, 7, 11, 13]);
    let bare: Vec<usize> = first_lines(text).filter(|(_, line)| names_no_subject(line)).map(|(k, _)| k).collect();
    assert_eq!(bare, [1, 7, 13]);
    assert!(names_no_subject("Whether it turns.") && names_no_subject("By how much it misses (m)."));
    assert!(!names_no_subject("Whether items turn.") && !names_no_subject("Itself, as a list."));
}

#[test]
fn first_doc_lines_name_their_subject() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut files, mut wrong, mut count) = (vec![], vec![], 0);
    for folder in ["src", "crates/catena-urdf/src"] {
        sources(&root.join(folder), &mut files)?;
    }
    files.sort();
    for path in &files {
        let text = fs::read_to_string(path)?;
        for (number, line) in first_lines(&text) {
            count += 1;
            if names_no_subject(line) {
                wrong.push(format!("{}:{number}: {line}", path.strip_prefix(root)?.display()));
            }
        }
    }
    println!("{count} first lines in {} files", files.len());
    assert!(wrong.is_empty(), "no subject in\n{}", wrong.join("\n"));
    assert!(count > 3000, "documentation is no longer found");
    Ok(())
}
