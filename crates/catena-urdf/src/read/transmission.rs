//! `<transmission>`: the reduction between a motor and its joint.

use super::Reader;
use super::element::Element;
use crate::error::Error;
use crate::model::Joint;
use crate::note::Remark;
use std::collections::HashMap;

impl Reader<'_> {
    pub fn transmission(
        &mut self,
        element: Element,
        joints: &mut [Joint],
        names: &HashMap<String, usize>,
    ) -> Result<(), Error> {
        let reduction = ["mechanicalReduction", "mechanical_reduction"];
        let [one, other] = reduction;
        element.leaves_out_all_but(&["type", "joint", "actuator", one, other], &["name", "type"], self.notes);
        for end in element.children().filter(|child| child.is("joint") || child.is("actuator")) {
            end.leaves_out_all_but(&reduction, &["name"], self.notes);
        }
        let mut found = element.children().filter(|child| child.is("joint"));
        let joint = match (found.next(), found.next()) {
            (Some(joint), None) => joint.text("name").and_then(|name| names.get(name)),
            _ => None,
        };
        let mut reductions = Vec::new();
        for inner in element.descendants() {
            if reduction.iter().any(|name| inner.is(name)) {
                reductions.push(inner.parse("mechanicalReduction", inner.content())?);
            }
        }
        // One reduction may be written twice, for the joint and for the actuator.
        let agree = reductions.windows(2).all(|pair| pair[0] == pair[1]);
        match joint.and_then(|joint| joints.get_mut(*joint)) {
            Some(joint) if agree && joint.furniture.reduction.is_none() => {
                joint.furniture.reduction = reductions.first().copied();
            }
            _ => {
                let name = element.text("name").unwrap_or_default().to_owned();
                self.notes.add(element.line(), Remark::Transmission { name });
            }
        }
        Ok(())
    }
}
