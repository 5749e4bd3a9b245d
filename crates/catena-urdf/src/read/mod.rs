//! From text to a [`Model`]: what stands there, checked one by one.

mod angles;
mod element;
mod joint;
mod link;
mod transmission;

use crate::Options;
use crate::error::{Error, Fault};
use crate::model::{Joint, Kind, Link, Model};
use crate::note::{Notes, Remark};
use angles::Angles;
use element::{Element, Lines};
use std::collections::HashMap;

/// What the readers of parts share.
struct Reader<'n> {
    angles: Angles,
    notes: &'n mut Notes,
}

/// Reads a description.
pub fn model(text: &str, options: &Options, notes: &mut Notes) -> Result<Model, Error> {
    let document = roxmltree::Document::parse(text)
        .map_err(|error| Error::at(error.pos().row as usize, Fault::Xml(error.to_string())))?;
    let lines = Lines::of(text);
    let root = Element::new(document.root_element(), &lines);
    if !root.is("robot") {
        return Err(root.fail(Fault::NotARobot { element: root.tag() }));
    }
    root.leaves_out_all_but(&["link", "joint", "transmission"], &["name", "version"], notes);
    let mut reader = Reader { angles: Angles { tolerance: options.snap }, notes };

    let mut links = Vec::new();
    let mut numbers = HashMap::new();
    for element in root.children().filter(|child| child.is("link")) {
        let link = reader.link(element)?;
        known_once("link", &link.name, links.len(), element, &mut numbers, |at| {
            links.get(at).map_or(0, |link: &Link| link.line)
        })?;
        links.push(link);
    }
    if links.is_empty() {
        return Err(root.fail(Fault::NoLinks));
    }

    let mut joints: Vec<Joint> = Vec::new();
    let mut names = HashMap::new();
    for element in root.children().filter(|child| child.is("joint")) {
        let joint = reader.joint(element, &numbers)?;
        known_once("joint", &joint.name, joints.len(), element, &mut names, |at| {
            joints.get(at).map_or(0, |joint| joint.line)
        })?;
        joints.push(joint);
    }
    for element in root.children().filter(|child| child.is("transmission")) {
        reader.transmission(element, &mut joints, &names)?;
    }
    check_mimics(&joints, &names)?;
    lead_by_what_moves(&mut joints, &names, options, reader.notes);
    tell_constants(&joints, options, reader.notes);
    Ok(Model { name: root.text("name").unwrap_or("robot").to_owned(), links, joints })
}

/// Notes a name and its number; fails where it is there already.
fn known_once<'a>(
    kind: &'static str,
    name: &str,
    number: usize,
    element: Element<'a>,
    known: &mut HashMap<String, usize>,
    line: impl Fn(usize) -> usize,
) -> Result<(), Error> {
    match known.insert(name.to_owned(), number) {
        Some(first) => Err(element.fail(Fault::Duplicate { kind, name: name.to_owned(), first: line(first) })),
        None => Ok(()),
    }
}

/// Joints that others follow are there, and no joint follows itself by way of others.
fn check_mimics(joints: &[Joint], names: &HashMap<String, usize>) -> Result<(), Error> {
    let mut leader = vec![None; joints.len()];
    for (joint, leader) in joints.iter().zip(&mut leader) {
        if let Some(mimic) = &joint.furniture.mimic {
            let (by, name) = (format!("<mimic> of joint {:?}", joint.name), mimic.joint.clone());
            let unknown = || Error::at(joint.line, Fault::UnknownJoint { by, joint: name });
            *leader = Some(*names.get(&mimic.joint).ok_or_else(unknown)?);
        }
    }
    // Every joint is passed once: those that a walk has left behind end well.
    let mut walk = vec![0; joints.len()];
    for start in 0..joints.len() {
        let mut at = start;
        while walk[at] == 0 {
            walk[at] = start + 1;
            match leader[at] {
                Some(next) if walk[next] == start + 1 => {
                    let fault = Fault::MimicCircle { joint: joints[at].name.clone() };
                    return Err(Error::at(joints[at].line, fault));
                }
                Some(next) => at = next,
                None => break,
            }
        }
    }
    Ok(())
}

/// Lets joints that follow one that does not move go by themselves.
fn lead_by_what_moves(joints: &mut [Joint], names: &HashMap<String, usize>, options: &Options, notes: &mut Notes) {
    let moves: Vec<_> = joints.iter().map(|joint| !joint.stays(options) && joint.kind != Kind::Floating).collect();
    for (Joint { line, name, furniture, .. }, _) in joints.iter_mut().zip(&moves).filter(|(_, moves)| **moves) {
        if let Some(mimic) = furniture.mimic.take_if(|mimic| names.get(&mimic.joint).is_some_and(|of| !moves[*of])) {
            notes.add(*line, Remark::MimicOfFixed { joint: name.clone(), of: mimic.joint });
        }
    }
}

/// Furniture that the scene does not act by.
fn tell_constants(joints: &[Joint], options: &Options, notes: &mut Notes) {
    let laws = options.laws;
    for joint @ Joint { line, name, kind, furniture, .. } in joints {
        let (limits, slides) = (furniture.lower.is_finite() || furniture.upper.is_finite(), *kind == Kind::Prismatic);
        let has = [
            ("a limit of position", limits && !laws.stops_it(furniture, slides)),
            ("a limit of effort or velocity", furniture.effort.is_finite() || furniture.velocity.is_finite()),
            ("damping", furniture.damping != 0.0 && laws.damping_of(furniture).is_none()),
            ("dry friction", furniture.friction != 0.0 && !laws.rubs(furniture, slides)),
            ("a reduction", furniture.reduction.is_some()),
        ];
        let inside = match kind {
            _ if joint.stays(options) && *kind != Kind::Fixed => Some("joint"),
            Kind::Fixed => Some("joint type=\"fixed\""),
            Kind::Planar => Some("joint type=\"planar\""),
            Kind::Floating => Some("joint type=\"floating\""),
            _ => None,
        };
        // What these become has no furniture at all.
        if let Some(inside) = inside {
            let has = [
                ("limit", limits || furniture.effort.is_finite() || furniture.velocity.is_finite()),
                ("dynamics", furniture.damping != 0.0 || furniture.friction != 0.0),
                ("mimic", furniture.mimic.is_some()),
                ("mechanicalReduction", furniture.reduction.is_some()),
            ];
            for (element, _) in has.into_iter().filter(|(_, has)| *has) {
                notes.add(*line, Remark::LeftOut { element: element.to_owned(), inside: inside.to_owned() });
            }
            continue;
        }
        has.into_iter().filter(|(_, has)| *has).for_each(|(what, _)| notes.add(*line, Remark::ConstantOnly { what }));
        if laws.lacks_motor(furniture) {
            notes.add(*line, Remark::NoMotor { joint: name.clone() });
        }
        if furniture.lower > furniture.upper {
            notes.add(*line, Remark::LimitsReversed { joint: name.clone() });
        }
        if let Some(mimic) = &furniture.mimic {
            notes.add(*line, Remark::MimicFree { joint: name.clone(), of: mimic.joint.clone() });
        }
    }
}
