//! From links and joints to bodies that move: what is fixed becomes part of what carries it.

use crate::algebra::{IDENTITY, Vector, ZERO, about, cross, scale, unit};
use crate::error::{Error, Fault};
use crate::inertia::{Inertia, LARGEST, ROUNDED};
use crate::model::{Furniture, Joint, Kind, Link, Model, Pose};
use crate::note::{Notes, Remark};
use crate::options::{Base, Options};
use crate::robot::{Body, Carrier, Frame, Robot};
use crate::tree;

/// More joints than any robot has; a Rust type of so many elements takes minutes.
const MOST_JOINTS: usize = 512;

/// What the names of both slides of a planar joint end with; its hinge has the joint's own.
const SLIDES: [&str; 2] = ["/first", "/second"];

/// Lumps a description into a robot.
pub fn robot(model: &Model, options: &Options, notes: &mut Notes) -> Result<Robot, Error> {
    let order = tree::order(model)?;
    for (number, (name, _)) in options.held.iter().enumerate() {
        if options.held[..number].iter().any(|(held, _)| held == name) {
            return Err(Error::new(Fault::HeldTwice { joint: name.clone() }));
        }
        if !model.joints.iter().any(|joint| joint.name == *name) {
            let by = "what is to be held".to_owned();
            return Err(Error::new(Fault::UnknownJoint { by, joint: name.clone() }));
        }
    }
    let becomes = |joint: &Joint| if joint.kind == Kind::Planar { SLIDES.len() + 1 } else { 1 };
    let moving = model.joints.iter().filter(|joint| !joint.stays(options)).map(becomes).sum();
    if moving > MOST_JOINTS {
        return Err(Error::new(Fault::TooLarge { joints: moving, most: MOST_JOINTS }));
    }
    for joint in model.joints.iter().filter(|joint| joint.kind == Kind::Planar) {
        for name in SLIDES.map(|slide| format!("{}{slide}", joint.name)) {
            if let Some(other) = model.joints.iter().find(|other| other.name == name) {
                return Err(Error::at(other.line, Fault::Duplicate { kind: "joint", name, first: joint.line }));
            }
        }
    }
    let floats = floats(model, options, &order);
    let mut lump = Lump { options, notes, base: None, bodies: Vec::new() };
    // Where each link is carried, once it has been reached.
    let mut at = vec![(Carrier::Ground, Pose::IDENTITY); model.links.len()];
    let mut frames = Vec::with_capacity(model.links.len());
    for (link, joint) in order {
        at[link] = match joint.map(|joint| &model.joints[joint]) {
            None if floats == Floats::Root => (Carrier::Base, Pose::IDENTITY),
            None => (Carrier::Ground, Pose::IDENTITY),
            Some(joint) => lump.attach(joint, at[joint.parent], floats)?,
        };
        let (carrier, pose) = at[link];
        lump.add(&model.links[link], carrier, &pose);
        frames.push(Frame { name: model.links[link].name.clone(), carrier, pose });
    }
    let Lump { base, bodies, notes, .. } = lump;
    let base = matches!(floats, Floats::Root | Floats::Child).then(|| base.unwrap_or(Inertia::NONE));
    if bodies.is_empty() && base.is_none() {
        return Err(Error::new(Fault::NothingMoves));
    }
    check(&base, &bodies, &frames, notes)?;
    let (name, gravity, test, elements) = (model.name.clone(), options.gravity, options.test, options.elements);
    Ok(Robot { name, base, bodies, frames, notes: Vec::new(), gravity, test, elements, laws: options.laws })
}

/// Which link floats.
#[derive(Clone, Copy, PartialEq)]
enum Floats {
    None,
    Root,
    /// The only child of a root without mass.
    Child,
    /// A child that would float, but is fixed.
    FixedChild,
}

fn floats(model: &Model, options: &Options, order: &[(usize, Option<usize>)]) -> Floats {
    let Some((root, _)) = order.first() else { return Floats::None };
    let massless = model.links[*root].inertial.as_ref().is_none_or(|inertial| inertial.mass == 0.0);
    let mut joints = model.joints.iter().filter(|joint| joint.parent == *root);
    let only = match (joints.next(), joints.next()) {
        (Some(joint), None) => joint.kind == Kind::Floating,
        _ => false,
    };
    match options.base {
        Base::Fixed if massless && only => Floats::FixedChild,
        Base::Written | Base::Floating if massless && only => Floats::Child,
        Base::Floating => Floats::Root,
        Base::Written | Base::Fixed => Floats::None,
    }
}

struct Lump<'a> {
    options: &'a Options,
    notes: &'a mut Notes,
    base: Option<Inertia>,
    bodies: Vec<Body>,
}

impl Lump<'_> {
    /// What carries the child of a joint, and where: a new body if the joint moves.
    fn attach(
        &mut self,
        joint: &Joint,
        (carrier, pose): (Carrier, Pose),
        floats: Floats,
    ) -> Result<(Carrier, Pose), Error> {
        let pose = pose.then(&joint.origin);
        if let Some((_, value)) = self.options.held.iter().find(|(name, _)| *name == joint.name) {
            let moved = match joint.kind {
                Kind::Revolute | Kind::Continuous => Pose { place: ZERO, turn: about(joint.axis, *value) },
                Kind::Prismatic => Pose { place: scale(*value, joint.axis), turn: IDENTITY },
                Kind::Fixed | Kind::Floating | Kind::Planar => {
                    return Err(Error::at(joint.line, Fault::CannotHold { joint: joint.name.clone() }));
                }
            };
            return Ok((carrier, pose.then(&moved)));
        }
        Ok(match joint.kind {
            Kind::Fixed => (carrier, pose),
            Kind::Revolute | Kind::Continuous => self.body(joint, "", false, joint.axis, carrier, pose),
            Kind::Prismatic => self.body(joint, "", true, joint.axis, carrier, pose),
            Kind::Planar => {
                let (one, other) = across(joint.axis);
                self.notes.add(joint.line, Remark::PlanarSplit { joint: joint.name.clone() });
                let [first, second] = SLIDES;
                let (carrier, _) = self.body(joint, first, true, one, carrier, pose);
                let (carrier, _) = self.body(joint, second, true, other, carrier, Pose::IDENTITY);
                self.body(joint, "", false, joint.axis, carrier, Pose::IDENTITY)
            }
            Kind::Floating if floats == Floats::FixedChild && carrier == Carrier::Ground => (carrier, pose),
            // The coordinates of the base are its place and attitude in axes of the ground, wherever the joint puts it.
            Kind::Floating if floats == Floats::Child && carrier == Carrier::Ground => {
                if joint.origin != Pose::IDENTITY {
                    let (element, inside) = ("origin".to_owned(), "joint type=\"floating\"".to_owned());
                    self.notes.add(joint.line, Remark::LeftOut { element, inside });
                }
                (Carrier::Base, Pose::IDENTITY)
            }
            Kind::Floating => {
                return Err(Error::at(joint.line, Fault::FloatingInside { joint: joint.name.clone() }));
            }
        })
    }

    fn body(
        &mut self,
        joint: &Joint,
        suffix: &str,
        slides: bool,
        axis: Vector,
        carrier: Carrier,
        pose: Pose,
    ) -> (Carrier, Pose) {
        let parent = match carrier {
            Carrier::Body(parent) => Some(parent),
            Carrier::Base | Carrier::Ground => None,
        };
        let furniture = if joint.kind == Kind::Planar { Furniture::default() } else { joint.furniture.clone() };
        let name = format!("{}{suffix}", joint.name);
        let inertia = Inertia::NONE;
        self.bodies.push(Body { joint: name, line: joint.line, slides, axis, parent, pose, inertia, furniture });
        (Carrier::Body(self.bodies.len() - 1), Pose::IDENTITY)
    }

    /// Adds a link's mass to what carries it.
    fn add(&mut self, link: &Link, carrier: Carrier, pose: &Pose) {
        let Some(inertial) = &link.inertial else { return };
        let mut inertia =
            Inertia { mass: inertial.mass, centre: ZERO, tensor: inertial.tensor }.seen_from(&inertial.origin);
        if carrier == Carrier::Ground {
            if inertia.mass != 0.0 {
                self.notes.add(inertial.line, Remark::MassOfGround);
            }
            return;
        }
        // Without repair, less than rounding of files is no remark; with it each change is.
        let whole = if self.options.repair { inertia.repaired() } else { inertia };
        let (repaired, deficit) = (whole != inertia, inertia.deficit());
        if repaired || deficit < ROUNDED {
            self.notes.add(inertial.line, Remark::Impossible { of: link.name.clone(), deficit, repaired });
        }
        inertia = whole;
        let inertia = inertia.seen_from(pose);
        match carrier {
            Carrier::Body(body) => self.bodies[body].inertia = self.bodies[body].inertia.with(&inertia),
            _ => self.base = Some(self.base.unwrap_or(Inertia::NONE).with(&inertia)),
        }
    }
}

/// Two directions across a unit vector and each other; coordinate axes across a coordinate axis.
fn across(axis: Vector) -> (Vector, Vector) {
    let most = (0..3).fold(0, |most, k| if axis[k].abs() > axis[most].abs() { k } else { most });
    let mut next = ZERO;
    next[(most + 1) % 3] = 1.0;
    let second = unit(cross(axis, next)).unwrap_or(next);
    (cross(second, axis), second)
}

/// Whether no number is too large, and which bodies no distribution of mass has.
fn check(base: &Option<Inertia>, bodies: &[Body], frames: &[Frame], notes: &mut Notes) -> Result<(), Error> {
    let name = |carrier| frames.iter().find(|frame| frame.carrier == carrier).map(|frame| frame.name.clone());
    let carried = |carrier| name(carrier).unwrap_or_default();
    let mut inertia = |inertia: &Inertia, line: Option<usize>, carrier| {
        if !inertia.can_be_added() {
            let of = format!("the body of {:?}", carried(carrier));
            return Err(Error { line, ..Error::new(Fault::Overflow { of }) });
        }
        if !inertia.is_possible() {
            notes.add(line.unwrap_or(1), Remark::Doubtful { of: carried(carrier) });
        }
        Ok(())
    };
    if let Some(base) = base {
        inertia(base, None, Carrier::Base)?;
    }
    for (number, body) in bodies.iter().enumerate() {
        inertia(&body.inertia, Some(body.line), Carrier::Body(number))?;
    }
    let poses = bodies.iter().map(|body| (&body.joint, body.pose)).chain(frames.iter().map(|f| (&f.name, f.pose)));
    for (name, pose) in poses {
        if !pose.place.iter().all(|x| x.abs() <= LARGEST) {
            return Err(Error::new(Fault::Overflow { of: format!("the place of {name:?}") }));
        }
    }
    Ok(())
}
