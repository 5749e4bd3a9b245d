//! `<link>`: mass, mass centre and moments of inertia.

use super::Reader;
use super::element::Element;
use crate::error::{Error, Fault};
use crate::model::{Inertial, Link};
use crate::note::Remark;

impl Reader<'_> {
    pub fn link(&mut self, element: Element) -> Result<Link, Error> {
        let name = element.needed_text("name")?.to_owned();
        element.leaves_out_all_but(&["inertial"], &["name"], self.notes);
        let inertial = match element.child("inertial")? {
            Some(inertial) => Some(self.inertial(inertial, element, &name)?),
            None => None,
        };
        Ok(Link { name, line: element.line(), inertial })
    }

    fn inertial(&mut self, element: Element, link: Element, name: &str) -> Result<Inertial, Error> {
        element.leaves_out_all_but(&["origin", "mass", "inertia"], &[], self.notes);
        let weight = element.needed_child("mass").map_err(|error| of_link(error, link))?;
        weight.leaves_out_all_but(&[], &["value"], self.notes);
        let mass = weight.needed_number("value")?;
        if mass < 0.0 {
            return Err(weight.fail(Fault::NegativeMass { link: name.to_owned(), mass }));
        }
        let moments = element.needed_child("inertia").map_err(|error| of_link(error, link))?;
        moments.leaves_out_all_but(&[], &["ixx", "ixy", "ixz", "iyy", "iyz", "izz"], self.notes);
        let [xx, yy, zz] = ["ixx", "iyy", "izz"].map(|name| moments.needed_number(name));
        let [xy, xz, yz] = ["ixy", "ixz", "iyz"].map(|name| moments.needed_number(name));
        let (xx, yy, zz, xy, xz, yz) = (xx?, yy?, zz?, xy?, xz?, yz?);
        let tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        if mass == 0.0 && tensor.iter().flatten().any(|x| *x != 0.0) {
            self.notes.add(moments.line(), Remark::TensorWithoutMass { link: name.to_owned() });
        }
        Ok(Inertial { line: element.line(), origin: self.origin(element)?, mass, tensor })
    }
}

/// `<inertial>` has no name of its own: the message says which link's it is.
fn of_link(error: Error, link: Element) -> Error {
    let fault = match error.fault {
        Fault::Missing { what, .. } => Fault::Missing { what, of: format!("<inertial> of {}", link.title()) },
        fault => fault,
    };
    Error { fault, ..error }
}
