//! Values through two formats, and their bits.

use serde::Serialize;
use serde::de::DeserializeOwned;
use std::collections::BTreeSet;

/// Scenes met, and runs resumed.
#[derive(Default)]
pub struct Record {
    pub scenes: BTreeSet<&'static str>,
    pub resumed: usize,
}

/// All bits of a value.
pub fn bits(value: &impl Serialize) -> Vec<u8> {
    postcard::to_allocvec(value).unwrap()
}

/// A value from JSON, and from a binary format without names. Both have all bits of it.
pub fn read<X: Serialize + DeserializeOwned>(value: &X) -> [X; 2] {
    let text = serde_json::to_string(value).unwrap();
    let read = [serde_json::from_str(&text).unwrap(), postcard::from_bytes(&bits(value)).unwrap()];
    assert!(read.iter().all(|read| bits(read) == bits(value)), "{text}");
    read
}

/// Refuses two values whose bits differ.
pub fn same(name: &str, one: &impl Serialize, other: &impl Serialize) {
    assert!(bits(one) == bits(other), "{name} ends elsewhere");
}
