//! Links as a tree: one root, one parent for every other link, no circles.

use crate::error::{Error, Fault};
use crate::model::Model;

/// Links from the root on, each after its parent and before its parent's later children, with the joint that leads to it.
pub fn order(model: &Model) -> Result<Vec<(usize, Option<usize>)>, Error> {
    let mut leads_to: Vec<Option<usize>> = vec![None; model.links.len()];
    let mut children = vec![Vec::new(); model.links.len()];
    for (number, joint) in model.joints.iter().enumerate() {
        if let Some(first) = leads_to[joint.child].replace(number) {
            let (link, first) = (model.links[joint.child].name.clone(), model.joints[first].line);
            return Err(Error::at(joint.line, Fault::SeveralParents { link, first }));
        }
        children[joint.parent].push((joint.child, number));
    }
    let mut roots = (0..model.links.len()).filter(|link| leads_to[*link].is_none());
    let cycle = |link: usize| Error::at(model.links[link].line, Fault::Cycle { link: model.links[link].name.clone() });
    let root = roots.next().ok_or_else(|| cycle(0))?;
    if let Some(second) = roots.next() {
        let [first, name] = [root, second].map(|link| model.links[link].name.clone());
        return Err(Error::at(model.links[second].line, Fault::SeveralRoots { first, second: name }));
    }

    let mut order = Vec::with_capacity(model.links.len());
    let mut reached = vec![false; model.links.len()];
    let mut waiting = vec![(root, None)];
    while let Some((link, joint)) = waiting.pop() {
        reached[link] = true;
        order.push((link, joint));
        waiting.extend(children[link].iter().rev().map(|(child, joint)| (*child, Some(*joint))));
    }
    match reached.iter().position(|reached| !reached) {
        Some(link) => Err(cycle(link)),
        None => Ok(order),
    }
}
