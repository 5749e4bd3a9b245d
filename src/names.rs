//! Numbers and names by which joints and bodies of a scene are reached.

use core::fmt;
use core::ops::Range;

/// A joint or a body: its number, counted from 0 at the root, or its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which<'n> {
    /// The one with this number.
    Number(usize),
    /// The only one with this name.
    Name(&'n str),
}

impl From<usize> for Which<'_> {
    fn from(number: usize) -> Self {
        Self::Number(number)
    }
}

impl<'n> From<&'n str> for Which<'n> {
    fn from(name: &'n str) -> Self {
        Self::Name(name)
    }
}

/// The numbers of a joint: by which loads, readings and motions know it. They are the same for all scenes of its scene's type, but for
/// lengths of vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JointNumbers {
    /// Number of the joint among joints, the root's being 0: that of loads in joints.
    pub joint: usize,
    /// Station of the joint: that of readings and of errors; none of the root's joint, whose station is the root.
    pub station: Option<usize>,
    pub(crate) coordinates: [usize; 2],
    pub(crate) rates: [usize; 2],
}

impl JointNumbers {
    /// Where the joint's coordinates are in the list of all ([`Motion::coordinates`](crate::Motion::coordinates)).
    pub fn coordinates(&self) -> Range<usize> {
        self.coordinates[0]..self.coordinates[1]
    }

    /// Where the joint's rates and accelerations are in the lists of all ([`Motion::rates`](crate::Motion::rates)).
    pub fn rates(&self) -> Range<usize> {
        self.rates[0]..self.rates[1]
    }
}

/// The numbers of a body: by which loads, struts and readings know it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodyNumbers {
    /// Number of the body among bodies: that of loads on bodies, of struts, and of readings such as angles.
    pub body: usize,
    /// The station of the body's inboard end: that of readings of forces, and of errors.
    pub station: usize,
}

/// A name in an error: the first 23 bytes of it.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Label {
    text: [u8; 23],
    /// Number of these bytes that are the name's, and in the highest bit whether it is longer.
    length: u8,
}

impl Label {
    /// The label of a name.
    pub(crate) fn of(name: &str) -> Self {
        let mut text = [0; 23];
        let kept = (0..=name.len().min(text.len())).rev().find(|end| name.is_char_boundary(*end)).unwrap_or(0);
        text[..kept].copy_from_slice(&name.as_bytes()[..kept]);
        let cut = if kept < name.len() { 0x80 } else { 0 };
        Self { text, length: cut | kept as u8 }
    }
}

impl fmt::Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kept = self.text.get(..usize::from(self.length & 0x7f)).unwrap_or(&[]);
        f.write_str(core::str::from_utf8(kept).unwrap_or(""))?;
        if self.length & 0x80 == 0 { Ok(()) } else { f.write_str("...") }
    }
}

impl fmt::Debug for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{self}\"")
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Label {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// The text of the label: three dots after as many bytes as a label has room for are those of a name that is longer.
#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Label {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_str(Text)
    }
}

/// Formats may own a text, as where it was escaped.
#[cfg(feature = "serde")]
struct Text;

#[cfg(feature = "serde")]
impl serde::de::Visitor<'_> for Text {
    type Value = Label;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a name")
    }

    fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<Label, E> {
        let cut = text.strip_suffix("...").filter(|_| text.len() > 23);
        let label = Label::of(cut.unwrap_or(text));
        Ok(if cut.is_some() { Label { length: label.length | 0x80, ..label } } else { label })
    }
}
