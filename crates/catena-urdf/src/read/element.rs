//! An element of the text with its line, and what is left out of it.

use crate::algebra::Vector;
use crate::error::{Error, Fault};
use crate::note::{Notes, Remark};
use roxmltree::Node;

/// Where lines of a text begin: looking a line up takes the logarithm of their number.
pub struct Lines(Vec<usize>);

impl Lines {
    pub fn of(text: &str) -> Self {
        Self(text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n').map(|(at, _)| at).collect())
    }

    fn at(&self, byte: usize) -> usize {
        1 + self.0.partition_point(|end| *end < byte)
    }
}

/// An element.
#[derive(Clone, Copy)]
pub struct Element<'a> {
    node: Node<'a, 'a>,
    lines: &'a Lines,
}

impl<'a> Element<'a> {
    pub fn new(node: Node<'a, 'a>, lines: &'a Lines) -> Self {
        Self { node, lines }
    }

    /// Name of the element; with the prefix before it where it comes from another vocabulary, so that it is none of ours.
    pub fn tag(&self) -> String {
        self.name(self.node.tag_name().namespace(), self.node.tag_name().name())
    }

    /// A name as it is written: with the prefix of its vocabulary, if it has one.
    fn name(&self, space: Option<&str>, name: &str) -> String {
        match space.and_then(|space| self.node.lookup_prefix(space)) {
            Some(prefix) => format!("{prefix}:{name}"),
            None => name.to_owned(),
        }
    }

    pub fn is(&self, name: &str) -> bool {
        let tag = self.node.tag_name();
        // A vocabulary without a prefix is that of the description, whatever it is called.
        tag.name() == name && tag.namespace().is_none_or(|space| self.node.lookup_prefix(space).is_none())
    }

    /// The line where the element begins.
    pub fn line(&self) -> usize {
        self.lines.at(self.node.range().start)
    }

    /// For messages: `joint "elbow"`.
    pub fn title(&self) -> String {
        match self.text("name") {
            Some(name) => format!("{} {name:?}", self.tag()),
            None => format!("<{}>", self.tag()),
        }
    }

    pub fn fail(&self, fault: Fault) -> Error {
        Error::at(self.line(), fault)
    }

    pub fn children(self) -> impl Iterator<Item = Self> {
        let lines = self.lines;
        self.node.children().filter(Node::is_element).map(move |node| Self { node, lines })
    }

    pub fn descendants(self) -> impl Iterator<Item = Self> {
        let lines = self.lines;
        self.node.descendants().filter(Node::is_element).map(move |node| Self { node, lines })
    }

    /// The child of this name, of which there may be one.
    pub fn child(&self, name: &'static str) -> Result<Option<Self>, Error> {
        let mut found = self.children().filter(|child| child.is(name));
        let first = found.next();
        match found.next() {
            Some(second) => Err(second.fail(Fault::Repeated { element: name, of: self.title() })),
            None => Ok(first),
        }
    }

    pub fn needed_child(&self, name: &'static str) -> Result<Self, Error> {
        self.child(name)?.ok_or_else(|| self.fail(Fault::Missing { what: name, of: self.title() }))
    }

    /// An attribute, of no other vocabulary.
    pub fn text(&self, attribute: &str) -> Option<&'a str> {
        let mut own = self.node.attributes().filter(|own| own.namespace().is_none());
        own.find(|own| own.name() == attribute).map(|own| own.value())
    }

    /// The text inside the element.
    pub fn content(&self) -> &'a str {
        self.node.text().unwrap_or_default().trim()
    }

    pub fn needed_text(&self, attribute: &'static str) -> Result<&'a str, Error> {
        self.text(attribute).ok_or_else(|| self.fail(Fault::Missing { what: attribute, of: self.title() }))
    }

    pub fn number(&self, attribute: &'static str) -> Result<Option<f64>, Error> {
        self.text(attribute).map(|text| self.parse(attribute, text.trim())).transpose()
    }

    /// A number that must not be negative.
    pub fn not_negative(&self, attribute: &'static str) -> Result<Option<f64>, Error> {
        match self.number(attribute)? {
            Some(value) if value < 0.0 => Err(self.fail(Fault::Negative { attribute, value })),
            number => Ok(number),
        }
    }

    pub fn needed_number(&self, attribute: &'static str) -> Result<f64, Error> {
        self.parse(attribute, self.needed_text(attribute)?.trim())
    }

    pub fn vector(&self, attribute: &'static str) -> Result<Option<Vector>, Error> {
        let Some(text) = self.text(attribute) else { return Ok(None) };
        let given = text.split_ascii_whitespace().count();
        if given != 3 {
            return Err(self.fail(Fault::Count { attribute, expected: 3, given }));
        }
        let mut numbers = [0.0; 3];
        for (number, text) in numbers.iter_mut().zip(text.split_ascii_whitespace()) {
            *number = self.parse(attribute, text)?;
        }
        Ok(Some(numbers))
    }

    pub fn parse(&self, attribute: &'static str, text: &str) -> Result<f64, Error> {
        let number: f64 =
            text.parse().map_err(|_| self.fail(Fault::NotANumber { attribute, text: text.to_owned() }))?;
        let fault = || self.fail(Fault::NotFinite { attribute, text: text.to_owned() });
        if number.is_finite() { Ok(number) } else { Err(fault()) }
    }

    /// Notes all children and attributes but those named.
    pub fn leaves_out_all_but(&self, children: &[&str], attributes: &[&str], notes: &mut Notes) {
        for child in self.children().filter(|child| !children.iter().any(|name| child.is(name))) {
            notes.add(child.line(), Remark::LeftOut { element: child.tag(), inside: self.tag() });
        }
        for attribute in self.node.attributes() {
            let attribute = self.name(attribute.namespace(), attribute.name());
            if !attributes.contains(&attribute.as_str()) {
                notes.add(self.line(), Remark::AttributeLeftOut { attribute, of: self.tag() });
            }
        }
    }
}
