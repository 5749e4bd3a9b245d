//! What a chain consists of: kinds, names and numbers of coordinates of its bodies and joints.

use crate::mirror::{Position, Rate};
use crate::shape::{AtBody, AtClosing, AtJoint, Body, Closing, Joint, Outward, Shape, Walk, alike};
use crate::space::Space;
use core::any::type_name;

/// A body or a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Type of the body or joint, without modules and parameters.
    pub kind: &'static str,
    /// Name of the body or joint, if it has one.
    pub name: Option<&'static str>,
    /// Body or joint.
    pub sort: Sort,
}

/// Body or joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sort {
    /// A body.
    Body,
    /// A joint.
    Joint {
        /// Number of coordinates of the joint: those of a turn in space are four.
        coordinates: usize,
        /// Number of rates of the joint.
        rates: usize,
    },
}

/// Tells all bodies and joints of a chain, root to tip.
pub fn parts<S: Space, E: Shape<S>>(chain: &E, report: &mut impl FnMut(Part)) {
    chain.outward(&mut Parts { name: None, report }, (), ());
}

/// Reports what it meets.
struct Parts<'t, F> {
    /// The name of the innermost that has one.
    name: Option<&'static str>,
    report: &'t mut F,
}

impl<F: FnMut(Part)> Parts<'_, F> {
    fn report(&mut self, kind: &'static str, sort: Sort) {
        let name = self.name;
        (self.report)(Part { kind: short(kind), name, sort });
    }

    /// Goes on under a name, if there is one, and comes back.
    fn named_as<X>(&mut self, name: Option<&'static str>, go: impl FnOnce(&mut Self) -> X) -> X {
        let outer = self.name;
        self.name = name.or(outer);
        let out = go(self);
        self.name = outer;
        out
    }
}

/// A type without its modules and parameters.
fn short(kind: &'static str) -> &'static str {
    let kind = kind.split('<').next().unwrap_or(kind);
    kind.rsplit("::").next().unwrap_or(kind)
}

impl<S: Space, F: FnMut(Part)> Walk<S> for Parts<'_, F> {
    type Carried = ();
    type Stores = ();
}

impl<S: Space, F: FnMut(Part)> Outward<S> for Parts<'_, F> {
    alike!();

    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {
        self.report(type_name::<B>(), Sort::Body);
    }
    fn joint<J: Joint<S>>(&mut self, _: &J, (): (), _: AtJoint<'_, S, Self, J>) {
        let (mut coordinates, mut rates) = (0, 0);
        Position::visit(&J::still().0, &mut |_: S::Scalar| coordinates += 1);
        Rate::visit(&J::still().1, &mut |_: S::Scalar| rates += 1);
        self.report(J::kind(), Sort::Joint { coordinates, rates });
    }
    fn closing<K: Closing<S>>(&mut self, closing: &K, _: [(); 2], _: AtClosing<'_, S, Self, K>) {
        let (kind, own) = closing.label();
        self.named_as(own, |parts| parts.report(kind, Sort::Joint { coordinates: 0, rates: 0 }));
    }
    fn named<X>(&mut self, name: &'static str, go: impl FnOnce(&mut Self) -> X) -> X {
        self.named_as(Some(name), go)
    }
}
