//! `<joint>`: what moves, where, about which axis, and its furniture.

use super::Reader;
use super::element::Element;
use crate::error::{Error, Fault};
use crate::model::{Furniture, Joint, Kind, Mimic};
use crate::note::Remark;
use std::collections::HashMap;

impl Reader<'_> {
    pub fn joint(&mut self, element: Element, links: &HashMap<String, usize>) -> Result<Joint, Error> {
        let name = element.needed_text("name")?.to_owned();
        let parts = ["origin", "parent", "child", "axis", "limit", "dynamics", "mimic"];
        element.leaves_out_all_but(&parts, &["name", "type"], self.notes);
        let kind = match element.needed_text("type")? {
            "revolute" => Kind::Revolute,
            "continuous" => Kind::Continuous,
            "prismatic" => Kind::Prismatic,
            "fixed" => Kind::Fixed,
            "floating" => Kind::Floating,
            "planar" => Kind::Planar,
            kind => return Err(element.fail(Fault::UnknownKind { joint: name, kind: kind.to_owned() })),
        };
        let mut link = |role| {
            let end = element.needed_child(role)?;
            end.leaves_out_all_but(&[], &["link"], self.notes);
            let link = end.needed_text("link")?;
            let fault = || Fault::UnknownLink { joint: name.clone(), link: link.to_owned() };
            links.get(link).copied().ok_or_else(|| end.fail(fault()))
        };
        let (parent, child) = (link("parent")?, link("child")?);
        let origin = self.origin(element)?;
        // The axis of a joint that has none is read by nobody, whatever it says.
        let axis = match kind {
            Kind::Fixed | Kind::Floating => [1.0, 0.0, 0.0],
            _ => self.axis(element, &name)?,
        };
        let furniture = self.furniture(element, kind, &name)?;
        Ok(Joint { line: element.line(), name, kind, parent, child, origin, axis, furniture })
    }

    fn furniture(&mut self, element: Element, kind: Kind, name: &str) -> Result<Furniture, Error> {
        let mut furniture = Furniture::default();
        let bounded = matches!(kind, Kind::Revolute | Kind::Prismatic);
        match element.child("limit")? {
            Some(limit) => {
                limit.leaves_out_all_but(&[], &["lower", "upper", "effort", "velocity"], self.notes);
                let (lower, upper) = (limit.number("lower")?, limit.number("upper")?);
                // Where URDF asks for both, the one that is not written is zero, as it says.
                if bounded {
                    (furniture.lower, furniture.upper) = (lower.unwrap_or(0.0), upper.unwrap_or(0.0));
                } else if lower.or(upper).is_some() {
                    let attribute = "lower or upper".to_owned();
                    self.notes.add(limit.line(), Remark::AttributeLeftOut { attribute, of: limit.tag() });
                }
                furniture.effort = limit.not_negative("effort")?.unwrap_or(f64::INFINITY);
                furniture.velocity = limit.not_negative("velocity")?.unwrap_or(f64::INFINITY);
            }
            None if bounded => self.notes.add(element.line(), Remark::NoLimits { joint: name.to_owned() }),
            None => (),
        }
        if let Some(dynamics) = element.child("dynamics")? {
            dynamics.leaves_out_all_but(&[], &["damping", "friction"], self.notes);
            furniture.damping = dynamics.not_negative("damping")?.unwrap_or(0.0);
            furniture.friction = dynamics.not_negative("friction")?.unwrap_or(0.0);
        }
        if let Some(mimic) = element.child("mimic")? {
            mimic.leaves_out_all_but(&[], &["joint", "multiplier", "offset"], self.notes);
            furniture.mimic = Some(Mimic {
                joint: mimic.needed_text("joint")?.to_owned(),
                multiplier: mimic.number("multiplier")?.unwrap_or(1.0),
                offset: mimic.number("offset")?.unwrap_or(0.0),
            });
        }
        Ok(furniture)
    }
}
