//! What a scene consists of, by number and by name.

use crate::element::{Element, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::names::{BodyNumbers, JointNumbers, Label, Which};
use crate::system::{Elements, System};
use crate::walks::parts::{Part, Sort, parts};
use core::fmt;
use core::marker::PhantomData;

/// A scene in a table: see [`System::describe`].
pub struct Description<'s, S, E> {
    elements: &'s E,
    space: PhantomData<S>,
}

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// A table of all stations, bodies and joints with their numbers, kinds and names, to be printed.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(0.5, 1.0);
    /// let coupled = Network::new((Pin.named("crank"), rod), (Pin, rod.named("rocker")), Pin.named("coupling"));
    /// let scene = System::new(Pinned::origin(), (rod, coupled, (Pin, rod).named("tail")), Free)?;
    /// let table = "
    /// station  joint  body  coordinates  rates  kind  name
    ///    root      0                  0      0  Pin
    ///       0            0                      Rod
    ///       1      1                  1      1  Pin   crank
    ///       2            1                      Rod
    ///       3      2                  2      2  Pin
    ///       4            2                      Rod   rocker
    ///       5      3                            Pin   coupling
    ///       6      4                  3      3  Pin   tail
    ///       7            3                      Rod   tail
    ///       8  the tip";
    /// assert_eq!(scene.describe().to_string(), table.trim_start());
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Which number is whose
    ///
    /// All count from 0 at the root, in the order in which the scene is written: an arm before what follows it, of a network the main
    /// arm, the side arm, the joint that closes it.
    ///
    /// | number | counts | is asked for by |
    /// |---|---|---|
    /// | joint | joints, that of the root among them and first, and those that close loops | loads in joints, torques and efforts; [`joint`](Self::joint) |
    /// | body | bodies | loads on bodies, struts, [`angles`](Self::angles), [`body_motions`](Self::body_motions); [`body`](Self::body) |
    /// | station | bodies and joints together, at their inboard ends, without the joint of the root; the last is the tip | [`stations`](Self::stations), errors |
    /// | coordinates | numbers by which joints are placed: four for a turn in space | [`Motion::coordinates`](crate::Motion::coordinates) and what goes with it |
    /// | rates | their rates, and accelerations: three for a turn in space | [`Motion::rates`](crate::Motion::rates), [`with_rates`](Self::with_rates) |
    ///
    /// [`joint`](Self::joint) and [`body`](Self::body) find all numbers of a joint and of a body from one of them or from a name.
    pub fn describe(&self) -> Description<'_, S, Elements<S, R, C>> {
        Description { elements: self.elements(), space: PhantomData }
    }

    /// The numbers of a joint, by its number (that of the root is 0) or its name.
    ///
    /// # Errors
    /// [`Fault::NoSuchJoint`], [`Fault::NoSuchName`]; [`Fault::AmbiguousName`] where several joints have this name.
    pub fn joint<'n>(&self, joint: impl Into<Which<'n>>) -> Result<JointNumbers, Error> {
        let mut search = Search::of("joint", joint.into());
        each(self.elements(), &mut |part, numbers| {
            if let Numbers::Joint(numbers) = numbers {
                search.meet(part, numbers.joint, numbers);
            }
        });
        search.end(|joint, joints| Fault::NoSuchJoint { joint, joints })
    }

    /// The numbers of a body, by its number or its name.
    ///
    /// # Errors
    /// [`Fault::NoSuchBody`], [`Fault::NoSuchName`]; [`Fault::AmbiguousName`] where several bodies have this name.
    pub fn body<'n>(&self, body: impl Into<Which<'n>>) -> Result<BodyNumbers, Error> {
        let mut search = Search::of("body", body.into());
        each(self.elements(), &mut |part, numbers| {
            if let Numbers::Body(numbers) = numbers {
                search.meet(part, numbers.body, numbers);
            }
        });
        search.end(|body, bodies| Fault::NoSuchBody { body, bodies })
    }
}

/// The numbers of a body or a joint.
#[derive(Clone, Copy)]
enum Numbers {
    Body(BodyNumbers),
    Joint(JointNumbers),
}

/// Tells all bodies and joints of a scene with their numbers. The first is the root's joint.
fn each<S: Space, E: Element<S>>(elements: &E, report: &mut impl FnMut(Part, Numbers)) {
    let (mut entries, mut bodies, mut joints, mut coordinates, mut rates) = (0_usize, 0, 0, 0, 0);
    parts(elements, &mut |part| {
        let station = entries.checked_sub(1);
        entries += 1;
        match part.sort {
            Sort::Body => {
                report(part, Numbers::Body(BodyNumbers { body: bodies, station: station.unwrap_or(0) }));
                bodies += 1;
            }
            Sort::Joint { coordinates: own, rates: own_rates } => {
                let next = (coordinates + own, rates + own_rates);
                report(
                    part,
                    Numbers::Joint(JointNumbers {
                        joint: joints,
                        station,
                        coordinates: [coordinates, next.0],
                        rates: [rates, next.1],
                    }),
                );
                joints += 1;
                (coordinates, rates) = next;
            }
        }
    });
}

/// A search among joints or among bodies.
struct Search<'n, X> {
    what: &'static str,
    which: Which<'n>,
    found: Option<X>,
    /// How many were found, and how many there are.
    count: [usize; 2],
}

impl<'n, X> Search<'n, X> {
    fn of(what: &'static str, which: Which<'n>) -> Self {
        Self { what, which, found: None, count: [0; 2] }
    }

    fn meet(&mut self, part: Part, number: usize, numbers: X) {
        self.count[1] += 1;
        let found = match self.which {
            Which::Number(wanted) => wanted == number,
            Which::Name(name) => part.name == Some(name),
        };
        if found {
            self.count[0] += 1;
            self.found = Some(numbers);
        }
    }

    fn end(self, no_number: impl FnOnce(usize, usize) -> Fault) -> Result<X, Error> {
        let Self { what, which, found, count: [count, of] } = self;
        let fault = match (found, which) {
            (Some(found), _) if count == 1 => return Ok(found),
            (_, Which::Number(number)) => no_number(number, of),
            (None, Which::Name(name)) => Fault::NoSuchName { what, name: Label::of(name) },
            (Some(_), Which::Name(name)) => Fault::AmbiguousName { what, name: Label::of(name), count },
        };
        Err(Error::new(fault))
    }
}

impl<S: Space, E: Element<S>> fmt::Display for Description<'_, S, E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut kinds = 4; // as wide as the widest
        parts(self.elements, &mut |part| kinds = kinds.max(part.kind.len()));
        write!(f, "station  joint  body  coordinates  rates  {:kinds$}  name", "kind")?;
        let mut outcome = Ok(());
        let mut stations = 0;
        each(self.elements, &mut |part, numbers| {
            let mut row = || -> fmt::Result {
                match numbers {
                    Numbers::Body(BodyNumbers { body, station }) => {
                        stations = station + 1;
                        write!(f, "\n{station:7}  {:5}  {body:4}  {:11}  {:5}  ", "", "", "")?;
                    }
                    Numbers::Joint(JointNumbers { joint, station, coordinates, rates }) => {
                        stations = station.map_or(0, |station| station + 1);
                        match station {
                            Some(station) => write!(f, "\n{station:7}")?,
                            None => write!(f, "\n{:>7}", "root")?,
                        }
                        write!(f, "  {joint:5}  {:4}  ", "")?;
                        span(f, coordinates, 11)?;
                        span(f, rates, 5)?;
                    }
                }
                match part.name {
                    Some(name) => write!(f, "{:kinds$}  {name}", part.kind),
                    None => write!(f, "{}", part.kind),
                }
            };
            if outcome.is_ok() {
                outcome = row();
            }
        });
        outcome?;
        write!(f, "\n{stations:7}  the tip")
    }
}

/// Numbers from one to before another, in a column.
fn span(f: &mut fmt::Formatter<'_>, [start, end]: [usize; 2], width: usize) -> fmt::Result {
    match end - start {
        0 => write!(f, "{:width$}  ", ""),
        1 => write!(f, "{start:width$}  "),
        _ => {
            let digits = |n: usize| n.checked_ilog10().unwrap_or(0) as usize + 1;
            let used = digits(start) + 2 + digits(end);
            write!(f, "{:pad$}{start}..{end}  ", "", pad = width.saturating_sub(used))
        }
    }
}
