//! Exported macros expand in other crates, where no build script of this one has said what is optimised.

use super::layers::sources;
use std::error::Error;
use std::fs;
use std::path::Path;

#[test]
fn exported_macros_ask_for_nothing_that_other_crates_do_not_know() -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut files, mut count) = (vec![], 0);
    sources(&root.join("src"), &mut files)?;
    for path in &files {
        let text = fs::read_to_string(path)?;
        if text.contains("#[macro_export]") {
            count += 1;
            assert!(!text.contains("(optimised"), "{}", path.strip_prefix(root)?.display());
        }
    }
    assert!(count > 2, "exported macros are no longer found");
    Ok(())
}
