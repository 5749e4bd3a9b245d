//! Names of types, written before values and compared when these are read (feature `serde`).

use core::any::type_name;
use core::fmt::{self, Display};
use core::marker::PhantomData;
use serde::de::{Error, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// The name of the type `X` without its modules: what formats without names could not tell apart, and those with names would tell in
/// their own words.
pub(crate) struct Shape<X>(PhantomData<X>);

impl<X> Shape<X> {
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

/// A path character by character, so that what stands before the last `::` of each name can be left out.
fn short(name: &str) -> impl Iterator<Item = char> + Clone + '_ {
    let part = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    name.split_inclusive(move |c| !part(c)).flat_map(|path| path.rsplit("::").next().unwrap_or(path).chars())
}

impl<X> Display for Shape<X> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        short(type_name::<X>()).try_for_each(|c| fmt::Write::write_char(f, c))
    }
}

impl<X> Serialize for Shape<X> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de, X> Deserialize<'de> for Shape<X> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_str(Self::new())
    }
}

impl<X> Visitor<'_> for Shape<X> {
    type Value = Self;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the shape {self}")
    }

    fn visit_str<E: Error>(self, written: &str) -> Result<Self, E> {
        if short(type_name::<X>()).eq(written.chars()) {
            return Ok(self);
        }
        Err(E::custom(format_args!("another shape: {written} was written, and {self} is read")))
    }
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn names_lose_their_modules_and_nothing_else() {
        let name = |text: &str| short(text).collect::<std::string::String>();
        assert_eq!(
            name("(a::b::Rod<f64>, [(a::Pin, c_d::e::Rod<f64>); 6], &str, ())"),
            "(Rod<f64>, [(Pin, Rod<f64>); 6], &str, ())"
        );
        assert_eq!(name("f64"), "f64");
        assert_eq!(name(""), "");
    }
}
