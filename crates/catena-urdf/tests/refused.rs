//! Descriptions that must be refused, each with the message that its first line says.

use catena_urdf::Options;
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
