//! Scenes of random parameters from shapes that are types, and their twins for the oracle.

use catena::planar::*;
use catena_oracle::Noise;
use catena_oracle::space as oracle;
use core::marker::PhantomData;
use oracle::Vector;

/// How a body hangs on its parent.
#[derive(Clone, Copy)]
pub enum Kind {
    Fixed(f64),
    Pin,
    /// Stiffness, damping and rest angle.
    Hinge([f64; 3]),
    /// Direction, stiffness, damping and rest length.
    Slider([f64; 4]),
}

/// A closing joint: bodies, torque or angle of the weld, its numbers as a joint and as a station.
pub struct Loop {
    pub main: usize,
    pub side: usize,
    pub welded: bool,
    pub joint: usize,
    pub station: usize,
}

/// What has grown so far.
pub struct Plan {
    pub noise: Noise,
    pub parents: Vec<Option<usize>>,
    pub bodies: Vec<oracle::Body>,
    pub kinds: Vec<Kind>,
    /// The number of the joint of each body that has one, and the station at its inboard end.
    pub joint: Vec<Option<usize>>,
    pub stations: Vec<usize>,
    pub loops: Vec<Loop>,
    pub joints: usize,
    pub elements: usize,
}

impl Plan {
    pub fn new(seed: u64) -> Self {
        let (noise, joints, elements) = (Noise::new(seed), 1, 0);
        let (parents, bodies, kinds, joint) = (vec![], vec![], vec![], vec![]);
        Self { noise, parents, bodies, kinds, joint, stations: vec![], loops: vec![], joints, elements }
    }

    /// The first body stands on the ground's pin.
    pub fn pin_first(&mut self) {
        (self.kinds[0], self.joint[0]) = (Kind::Pin, Some(0));
    }

    /// Notes a body of this shape, and the joint before it unless it is fixed at no angle.
    fn note(&mut self, at: Option<usize>, kind: Kind, body: oracle::Body) -> usize {
        let jointed = !matches!(kind, Kind::Fixed(0.0));
        self.joint.push(jointed.then_some(self.joints));
        self.joints += usize::from(jointed);
        self.stations.push(self.elements + usize::from(jointed));
        self.elements += 1 + usize::from(jointed);
        self.parents.push(at);
        self.kinds.push(kind);
        self.bodies.push(body);
        self.bodies.len() - 1
    }

    fn body(&mut self, at: Option<usize>, kind: Kind) -> (RigidBody<f64>, Option<usize>) {
        let noise = &mut self.noise;
        let (mass, about_centre) = (noise.between(0.5, 2.0), noise.between(0.02, 0.2));
        let centre = [noise.between(0.2, 0.6), noise.between(-0.2, 0.2)];
        let outboard = [noise.between(0.5, 1.0), noise.between(-0.3, 0.3)];
        let number = self.note(at, kind, twin(mass, about_centre, centre, outboard));
        (RigidBody::new(mass, about_centre, centre, outboard), Some(number))
    }
}

fn twin(mass: f64, about_centre: f64, centre: [f64; 2], outboard: [f64; 2]) -> oracle::Body {
    let inertia = oracle::Matrix::from_diagonal(&Vector::new(0.7, 0.8, 1.0)) * about_centre;
    let o = Vector::zeros();
    oracle::Body { mass, inertia, centre: flat(centre), outboard: flat(outboard), force: o, at: o, torque: o }
}

pub fn flat([x, y]: [f64; 2]) -> Vector {
    Vector::new(x, y, 0.0)
}

pub fn axial(z: f64) -> Vector {
    Vector::new(0.0, 0.0, z)
}

/// A shape of elements.
pub trait Grow {
    type Element;
    /// Grows at the outboard end of a body, or of the ground; gives the body at whose end the chain goes on.
    fn grow(plan: &mut Plan, at: Option<usize>) -> (Self::Element, Option<usize>);
}

/// A body that begins at once.
pub struct Bare;
/// A body on a pin.
pub struct Link;
/// A body on a weld.
pub struct Fixed;
/// A body on a hinge with a spring.
pub struct Sprung;
/// A body on a slider with a spring.
pub struct Slid;
/// A rod on a pin.
pub struct Bar;
/// A massless body.
pub struct Reach;
/// Arms in parallel, closed by a pin or a weld.
pub struct Net<M, A, K = Pin>(PhantomData<(M, A, K)>);
/// An arm.
pub struct Arm<A>(PhantomData<A>);
/// A vector of these.
pub struct Many<A, const N: usize>(PhantomData<A>);

impl Grow for Bare {
    type Element = RigidBody<f64>;
    fn grow(plan: &mut Plan, at: Option<usize>) -> (Self::Element, Option<usize>) {
        plan.body(at, Kind::Fixed(0.0))
    }
}

impl Grow for Link {
    type Element = (Pin, RigidBody<f64>);
    fn grow(plan: &mut Plan, at: Option<usize>) -> (Self::Element, Option<usize>) {
        let (body, end) = plan.body(at, Kind::Pin);
        ((Pin, body), end)
    }
}

impl Grow for Fixed {
    type Element = (Weld<f64>, RigidBody<f64>);
    fn grow(plan: &mut Plan, at: Option<usize>) -> (Self::Element, Option<usize>) {
        let angle = plan.noise.between(0.2, 1.0);
        let (body, end) = plan.body(at, Kind::Fixed(angle));
        ((Weld::at(angle), body), end)
    }
}

impl Grow for Sprung {
    type Element = (ElasticHinge<Spring<f64, f64, f64>>, RigidBody<f64>);
    fn grow(plan: &mut Plan, at: Option<usize>) -> (Self::Element, Option<usize>) {
        let law = [plan.noise.between(3.0, 9.0), plan.noise.between(0.1, 0.5), plan.noise.next()];
        let (body, end) = plan.body(at, Kind::Hinge(law));
        ((ElasticHinge::rotary(law[0]).damped(law[1]).resting_at(law[2]), body), end)
    }
}

impl Grow for Slid {
    type Element = (Slider<f64, Spring<f64, f64, f64>>, RigidBody<f64>);
    fn grow(plan: &mut Plan, at: Option<usize>) -> (Self::Element, Option<usize>) {
        let noise = &mut plan.noise;
        let law = [noise.next(), noise.between(20.0, 50.0), noise.between(1.0, 3.0), 0.1 * noise.next()];
        let (body, end) = plan.body(at, Kind::Slider(law));
        let spring = Spring::new(law[1]).damped(law[2]).resting_at(law[3]);
        ((Slider::along(law[0]).with(spring), body), end)
    }
}

impl Grow for Bar {
    type Element = (Pin, Rod<f64>);
    fn grow(plan: &mut Plan, at: Option<usize>) -> (Self::Element, Option<usize>) {
        let (length, mass) = (plan.noise.between(0.5, 1.0), plan.noise.between(0.5, 2.0));
        let body = twin(mass, mass * length * length / 12.0, [0.5 * length, 0.0], [length, 0.0]);
        let number = plan.note(at, Kind::Pin, body);
        ((Pin, Rod::uniform(length, mass)), Some(number))
    }
}

impl Grow for Reach {
    type Element = RigidBody<f64>;
    fn grow(plan: &mut Plan, at: Option<usize>) -> (Self::Element, Option<usize>) {
        let outboard = [plan.noise.between(0.5, 0.9), plan.noise.between(-0.3, 0.3)];
        let number = plan.note(at, Kind::Fixed(0.0), twin(0.0, 0.0, [0.0; 2], outboard));
        (RigidBody::massless(outboard), Some(number))
    }
}

/// What closes a loop.
pub trait Close: Sized {
    const WELDED: bool;
    fn close(noise: &mut Noise) -> Self;
}
impl Close for Pin {
    const WELDED: bool = false;
    fn close(_: &mut Noise) -> Self {
        Self
    }
}
impl Close for Weld<f64> {
    const WELDED: bool = true;
    fn close(noise: &mut Noise) -> Self {
        Self::at(noise.next())
    }
}

impl<M: Grow, A: Grow, K: Close> Grow for Net<M, A, K> {
    type Element = Network<M::Element, A::Element, K>;
    fn grow(plan: &mut Plan, at: Option<usize>) -> (Self::Element, Option<usize>) {
        let (main, main_end) = M::grow(plan, at);
        let (side, side_end) = A::grow(plan, at);
        let (main_body, side_body) = (main_end.unwrap_or(0), side_end.unwrap_or(0));
        let (joint, station) = (plan.joints, plan.elements);
        plan.joints += 1;
        plan.elements += 1;
        plan.loops.push(Loop { main: main_body, side: side_body, welded: K::WELDED, joint, station });
        (Network::new(main, side, K::close(&mut plan.noise)), main_end)
    }
}

impl<A: Grow> Grow for Arm<A> {
    type Element = Branch<A::Element>;
    fn grow(plan: &mut Plan, at: Option<usize>) -> (Self::Element, Option<usize>) {
        (Branch(A::grow(plan, at).0), at)
    }
}

impl<A: Grow, const N: usize> Grow for [A; N] {
    type Element = [A::Element; N];
    fn grow(plan: &mut Plan, at: Option<usize>) -> (Self::Element, Option<usize>) {
        let mut end = at;
        let items = core::array::from_fn(|_| {
            let (item, next) = A::grow(plan, end);
            end = next;
            item
        });
        (items, end)
    }
}

impl<A: Grow, const N: usize> Grow for Many<A, N> {
    type Element = Vec<A::Element>;
    fn grow(plan: &mut Plan, at: Option<usize>) -> (Self::Element, Option<usize>) {
        let (items, end) = <[A; N]>::grow(plan, at);
        (items.into(), end)
    }
}

macro_rules! grow_tuples {
    ($($($part:ident)+;)+) => {$(
        impl<$($part: Grow),+> Grow for ($($part,)+) {
            type Element = ($($part::Element,)+);
            fn grow(plan: &mut Plan, end: Option<usize>) -> (Self::Element, Option<usize>) {
                $(#[allow(non_snake_case)] let ($part, end) = $part::grow(plan, end);)+
                (($($part,)+), end)
            }
        }
    )+};
}
grow_tuples!(A B; A B C; A B C D; A B C D E; A B C D E F;);
