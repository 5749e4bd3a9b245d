//! A scene read element by element: what section 2.2 calls the discretisation of a system.

use super::link::End;
use super::orient::{Axes, Bodies, Joints, Orient};
use super::parts::Item;
use crate::element::{Coordinates, Element, Space, Watch};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::release::Release;
use crate::scalar::Scalar;
use crate::system::{MotionOf, System};
use crate::walks::travel::show;
use alloc::vec::Vec;
use num_traits::Zero;

/// What a scene is read as.
#[derive(Clone, Debug)]
pub struct Chain<T: Scalar, E: Orient<T, N, P, A>, const N: usize, const P: usize, const A: usize> {
    /// Time (s) of the motion it was read from.
    pub time: T::Real,
    /// Elements of the chain, the root's joint first.
    pub items: Vec<Item<T, E, N, P, A>>,
    /// The direction, in axes of the ground, along which the root is guided in the plane, or about which it turns in space.
    pub guide: Option<[T; P]>,
}

/// A scene that this formulation can run: a chain whose places at the ends are held, guided or free. One implementor, the
/// [`System`](crate::system::System) of either space, whose bounds are long.
pub trait Scene<T: Scalar, L, const N: usize, const H: usize, const P: usize, const A: usize> {
    /// Motion of the scene.
    type Motion;
    /// Orientations of the scene's bodies.
    type Orient: Orient<T, N, P, A>;
    /// Whether the ground holds the root, and where it does not guide it.
    const HELD: bool;
    /// Whether the ground holds the root along some directions of a plane and lets it go along others.
    const GUIDED: bool;

    /// The ground at the root.
    fn ground(&self, time: T::Real) -> <Self::Orient as Joints<T, P, A>>::Frame;
    /// Whether the root, and the tip, hold some directions of the attitude of a body, so that its axes are asked for.
    const ATTITUDES: [bool; 2];

    /// The root's directions, what is known of the forces along them (`drive` is the torque applied there) and of a body's axes.
    fn root(
        &self,
        guide: Option<[T; P]>,
        ground: &<Self::Orient as Joints<T, P, A>>::Frame,
        first: Option<&Axes<T, P, A>>,
        drive: [T; A],
    ) -> End<T, H>;
    /// What is known at the tip, in absolute coordinates, but of the axes of the last body in those of its axes.
    fn tip(&self, time: T::Real, last: Option<&Axes<T, P, A>>) -> End<T, H>;
    /// Elements of a motion with the accelerations that positions, rates and loads cause: a start from zero accelerations would not be
    /// one.
    ///
    /// # Errors
    /// As [`System::with_accelerations`](crate::system::System::with_accelerations);
    /// [`Fault::Unsupported`](crate::Fault::Unsupported) for what the paper's matrices cannot say.
    fn chain(&self, motion: &Self::Motion, loads: &L, slots: Slots) -> Result<Chain<T, Self::Orient, N, P, A>, Error>;
    /// f_C and m_C of a body, gravity among them.
    fn external(
        &self,
        loads: &L,
        time: T::Real,
        number: usize,
        body: &<Self::Orient as Bodies<T, N, P, A>>::Motion,
    ) -> <Self::Orient as Bodies<T, N, P, A>>::External;
    /// The torque applied in a joint, ON the outboard body (N·m), between two bodies or the ground and one.
    fn effort(
        &self,
        loads: &L,
        time: T::Real,
        number: usize,
        sides: [Option<&<Self::Orient as Bodies<T, N, P, A>>::Motion>; 2],
        ground: &<Self::Orient as Joints<T, P, A>>::Frame,
        guide: Option<[T; P]>,
    ) -> [T; A];
}

/// What stands in the slot of the angles in space. In the plane both are the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Slots {
    /// The space-three-angles 1-2-3 of section 2.1, as printed: singular at θ₂ = ±90°.
    #[default]
    Angles,
    /// The rotation vector of the step, A(t_i) = A(t_{i−1}) exp ψ̃, with ω = χ₃ψ + χ₄ and ω̇ = χ₁ψ + χ₂ in body axes: (3) and (4) hold
    /// as printed with ψ(t_{i−1}) = 0, and no orientation is singular. Rules of several steps take the ψ of earlier steps as these found them:
    /// each is ω ΔT in body axes amid its step but for terms of third order, so they keep order 2.
    RotationVectors,
}

/// A body, or a joint and what it lets move, that a walk met.
#[derive(Clone, Copy, Debug)]
pub(super) enum Met<S: Space> {
    Body(S::BodyMotion),
    Joint(S::JointMotion, Release<S>),
}

/// Refuses what stands in no matrix of the paper: drives, reflected inertia, and laws whose slopes change.
pub(super) fn refuse_others<S: Space>(release: &Release<S>) -> Result<(), Fault> {
    if release.driven {
        return Err(Fault::Unsupported { what: "a driven joint" });
    }
    let mut coordinates = release.coordinates.iter().flatten();
    if coordinates.clone().any(|coordinate| coordinate.inertia.real() > Zero::zero()) {
        return Err(Fault::Unsupported { what: "reflected inertia in a joint" });
    }
    if coordinates.all(|coordinate| coordinate.linear) {
        return Ok(());
    }
    Err(Fault::Unsupported { what: "a law that is not linear" })
}

/// The elements of a motion, the root's joint first.
///
/// # Errors
/// [`Fault::Unsupported`] where an arm leaves the chain.
pub(super) fn trace<S, R, C, P>(
    system: &System<S, R, C, P>,
    motion: &MotionOf<S, R, C, P>,
) -> Result<Vec<Met<S>>, Error>
where
    S: Space,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
{
    let chain = system.elements();
    let (position, rate, acceleration) = (motion.position(), motion.rate(), motion.acceleration());
    let mut list = List::<S> { met: Vec::with_capacity(chain.bodies() + chain.joints()), arm: None };
    let coordinates = Coordinates { position, rate, acceleration };
    let ground = system.ground(motion.time());
    show(chain, ground, coordinates, &mut list);
    match list.arm {
        Some(station) => Err(Error::new(Fault::Unsupported { what: "a chain that branches" }).at_station(station)),
        None => Ok(list.met),
    }
}

/// Writes down what it meets.
struct List<S: Space> {
    met: Vec<Met<S>>,
    /// The station where an arm leaves.
    arm: Option<usize>,
}

impl<S: Space> Watch<S> for List<S> {
    fn body(&mut self, body: &S::BodyMotion) {
        self.met.push(Met::Body(*body));
    }
    fn joint_with(&mut self, joint: &S::JointMotion, release: &dyn Fn() -> Release<S>) {
        self.met.push(Met::Joint(*joint, release()));
    }
    fn enter_arm(&mut self) {
        // Stations are counted from the first element outboard of the root's joint.
        self.arm = self.arm.or(Some(self.met.len().saturating_sub(1)));
    }
}
