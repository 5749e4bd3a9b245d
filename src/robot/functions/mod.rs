//! Functions of lists in the order of the joints: dynamics.

mod afloat;
mod configuration;
mod coupled;
mod derivatives;
mod impact;
mod inverse;
mod mass;
mod operational;
mod places;
mod snapshot;
mod strike;

pub use afloat::ByStateAfloat;
pub use derivatives::ByState;
pub use snapshot::{Afloat, Blocks, MassMatrix, Regressor, SixRows, Snapshot};

use crate::element::{Carrying, Condense, Element, Explicit, Given, Posture, Reading};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault, counted};
use crate::mechanics::spatial::axial::orthonormal;
use crate::mechanics::spatial::body_axes::angles::Angles;
use crate::mechanics::spatial::body_axes::composite::Composite;
use crate::mechanics::spatial::body_axes::factor::{Factor, Inward, Outward};
use crate::mechanics::spatial::body_axes::inverse::{Carrying as Load, Loaded, Resisting, Slopes};
use crate::mechanics::spatial::body_axes::places::{Parents, Places, Tally, Way};
use crate::mechanics::spatial::body_axes::solids::Solids;
use crate::mechanics::spatial::body_axes::{Base, Place, Stand, Torques};
use crate::mechanics::spatial::{Acceleration, Clamped, Spatial, Turn};
use crate::mirror::{Position, Rate};
use crate::relation::Open;
use crate::relation::spatial::Empty;
use crate::relation::spatial::algebra::Columns;
use crate::scalar::Scalar;
use crate::shape::{Kept, PerAxes, PerBody, PerJoint, Positions, Rates, Takes};
use crate::space::Space;
use crate::system::{MotionOf, System};
use crate::walks::count::coordinates;
use crate::walks::recover::recover;
use crate::walks::sines::sines;
use crate::walks::spread;
use num_traits::Zero;

/// The space of a robot's scene.
type S<T> = Spatial<T>;
/// A sweep under torques: one of its own, so that it is the only caller of what it calls, which is then inlined, so that a compiler drops
/// what nobody reads: what is left of the relation at the root, a sixth of the sweep of an arm.
type Driven<T, const N: usize> = Carrying<Torques<Own<T, N>>, Explicit, Open>;

/// A list that no load of a user has.
#[derive(Clone, Copy, Debug)]
pub struct Own<T, const N: usize>([T; N]);

impl<T, const N: usize> AsRef<[T]> for Own<T, N> {
    #[inline(always)]
    fn as_ref(&self) -> &[T] {
        &self.0
    }
}

/// A chain that functions of lists know: [`BodyAxes`](super::BodyAxes), hinges, slides and links, in tuples, arrays, vectors and branches,
/// with names or without, `N` joints in all.
#[diagnostic::on_unimplemented(
    message = "functions of lists do not know this chain",
    label = "not a robot in body axes with a fixed base",
    note = "a robot is `BodyAxes`, then `Hinge`, `Slide` and `Link`, in tuples, arrays, vectors and branches"
)]
pub trait Tasks<T: Scalar, const N: usize>:
    Element<S<T>>
    + Condense<S<T>, Empty, Driven<T, N>>
    + Takes<S<T>, Loaded<T, N, true, true>>
    + Takes<S<T>, Loaded<T, N, true, false>>
    + Takes<S<T>, Loaded<T, N, false, false>>
    + Takes<S<T>, Load<T, N>>
    + Takes<S<T>, Angles<T, N>>
    + Takes<S<T>, Resisting<T, N>>
    + Takes<S<T>, Slopes<T, N>>
    + for<'m> Takes<S<T>, Composite<'m, T, N>>
    + Takes<S<T>, Factor<T, N>>
    + Takes<S<T>, Inward<T, N>>
    + Takes<S<T>, Outward<T, N>>
    + Takes<S<T>, Places<T, N>>
    + Takes<S<T>, Parents<N>>
    + Takes<S<T>, Way<T, N>>
    + Takes<S<T>, Tally<T, N>>
    + Takes<S<T>, Solids<T, N>>
{
}

impl<T: Scalar, const N: usize, C> Tasks<T, N> for C where
    C: Element<S<T>>
        + Condense<S<T>, Empty, Driven<T, N>>
        + Takes<S<T>, Loaded<T, N, true, true>>
        + Takes<S<T>, Loaded<T, N, true, false>>
        + Takes<S<T>, Loaded<T, N, false, false>>
        + Takes<S<T>, Load<T, N>>
        + Takes<S<T>, Angles<T, N>>
        + Takes<S<T>, Resisting<T, N>>
        + Takes<S<T>, Slopes<T, N>>
        + for<'m> Takes<S<T>, Composite<'m, T, N>>
        + Takes<S<T>, Factor<T, N>>
        + Takes<S<T>, Inward<T, N>>
        + Takes<S<T>, Outward<T, N>>
        + Takes<S<T>, Places<T, N>>
        + Takes<S<T>, Parents<N>>
        + Takes<S<T>, Way<T, N>>
        + Takes<S<T>, Tally<T, N>>
        + Takes<S<T>, Solids<T, N>>
{
}

/// A root that functions of lists know: one that leaves no coordinate to what stands on it.
#[diagnostic::on_unimplemented(
    message = "functions of lists do not know the root `{Self}`",
    label = "not a fixed base",
    note = "they know `Base`, and `Clamped` where `BodyAxes` comes first in the chain",
    note = "a robot that floats or hangs from a joint is a scene: `System::with_accelerations`"
)]
pub trait FixedBase<T: Scalar>: Root<S<T>> {}

impl<T: Scalar> FixedBase<T> for Base<T> {}
impl<T: Scalar, G, A> FixedBase<T> for Clamped<G, A> where Self: Root<S<T>> {}

/// Sines and cosines of all positions, in one loop.
#[cfg_attr(optimised, inline(always))]
fn stands<T: Scalar, const N: usize, C: Tasks<T, N>>(chain: &C, q: &[T; N]) -> [Stand<T>; N] {
    let mut angles = Angles { list: *q, next: 0 };
    Takes::<S<T>, Angles<T, N>>::take(chain, &mut angles, (), ());
    let mut list = [[T::zero(); 2]; N];
    for (stand, angle) in list.iter_mut().zip(&angles.list) {
        let (sine, cosine) = angle.sin_cos();
        *stand = [sine, cosine];
    }
    list
}

/// A robot at an instant: what its joints' own laws say, and how they stand.
#[cfg_attr(optimised, inline(always))]
fn resisting<T: Scalar, const N: usize, C: Tasks<T, N>>(chain: &C, q: &[T; N], v: &[T; N]) -> Resisting<T, N> {
    let none = [T::zero(); N];
    let mut walk = Resisting {
        positions: *q,
        rates: *v,
        stands: stands(chain, q),
        laws: none,
        inertias: none,
        energies: none,
        next: 0,
    };
    Takes::<S<T>, Resisting<T, N>>::take(chain, &mut walk, (), ());
    walk
}

/// Refuses numbers that are not finite.
#[inline(always)]
fn finite<T: Scalar>(list: &[T]) -> Result<(), Error> {
    let finite = list.iter().fold(true, |all, x| all & x.is_finite()); // without branches
    if finite { Ok(()) } else { Err(Error::new(Fault::NonFiniteMotion)) }
}

/// Refuses places of a base that are none: numbers that are not finite, axes that stretch, shear or mirror.
#[cfg_attr(optimised, inline(always))]
fn checked<T: Scalar>(Place { place, attitude }: &Place<T>) -> Result<(), Error> {
    let Columns { x, y, z } = attitude;
    [place, x, y, z].iter().try_for_each(|vector| finite(vector.as_slice()))?;
    let parameter = "what the axes of a base miss to be orthonormal and right-handed";
    if orthonormal(attitude) { Ok(()) } else { Err(Error::new(Fault::NotZero { parameter })) }
}

impl<T: Scalar, R: Root<S<T>>, C: Element<S<T>>, P: Tip<S<T>>> System<S<T>, R, C, P> {
    /// A motion with these coordinates and rates of all joints of a robot whose base is fixed, in their order.
    ///
    /// # Errors
    /// [`Fault::Count`] for lists of another length, [`Fault::NotFinite`].
    pub fn at_joints(&self, q: &[T], v: &[T]) -> Result<MotionOf<S<T>, R, C, P>, Error> {
        let mut motion = self.motion();
        motion.set_coordinates(q)?;
        self.with_rates(motion, v)
    }

    /// Refuses lists of another length than the robot has joints.
    #[inline(always)]
    pub(super) fn has_joints(&self, count: usize) -> Result<(), Error> {
        counted("numbers of joints", coordinates(self.chain()), count)
    }

    /// Accelerations q̈ of the joints (rad/s², m/s²) from positions, rates and torques (N·m, N): those of the scene at time zero, in
    /// gravity, with the springs and dampers of the joints.
    ///
    /// # Errors
    /// [`Fault::Count`] where `N` is not the number of joints; [`Fault::NonFiniteMotion`] where something came out not finite.
    pub fn forward_dynamics<const N: usize>(&self, q: &[T; N], v: &[T; N], torques: &[T; N]) -> Result<[T; N], Error>
    where
        R: FixedBase<T>,
        C: Tasks<T, N>,
    {
        self.has_joints(N)?;
        // Found inside, where a compiler knows the axes of a `Base` to be inertial ones.
        let ground = || self.ground(T::Real::zero());
        let seconds = self.swept(|| ground().turn, q, v, torques, |_| ground().falling(self.gravity()));
        finite(&seconds).map(|()| seconds)
    }

    /// A sweep whose stores live no longer than itself, of a robot on a base that is turned like this and accelerates, in a frame that falls
    /// freely, as follows from the relation there.
    #[inline(never)]
    fn swept<const N: usize>(
        &self,
        base: impl FnOnce() -> Turn<T>,
        q: &[T; N],
        v: &[T; N],
        torques: &[T; N],
        accelerated: impl FnOnce(<C as Condense<S<T>, Empty, Driven<T, N>>>::Out) -> Acceleration<T>,
    ) -> [T; N]
    where
        C: Tasks<T, N>,
    {
        let chain = self.chain();
        let (mut position, mut rate) = (chain.store::<Positions>(()), chain.store::<Rates>(()));
        let (mut k, mut i) = (0, 0);
        Position::replace(&mut position, &mut |_| {
            k += 1;
            q.get(k - 1).copied().unwrap_or(T::zero())
        });
        Rate::replace(&mut rate, &mut |_| {
            i += 1;
            v.get(i - 1).copied().unwrap_or(T::zero())
        });
        let (x, y, p, r) = <S<T> as Space>::blank();
        let (mut x, mut y) = (chain.store::<PerAxes<_>>(x), chain.store::<PerAxes<_>>(y));
        let (mut p, mut r) = (chain.store::<PerAxes<_>>(p), chain.store::<PerAxes<_>>(r));
        let sizes = chain.store::<PerAxes<()>>(());
        let mut in_joints = chain.store::<PerJoint<T>>(T::zero());
        let on_bodies = chain.store::<PerBody<_>>(crate::relation::Absent);
        let mut kept = chain.store::<Kept<Open>>(());
        sines(chain, &position, &mut x);
        chain.pose(&position, &rate, base(), &sizes, &mut x, &mut y, &mut p, &mut r);
        spread::to_coordinates(chain, torques, |x| x, &mut in_joints);
        let posture = Posture { x: &x, y: &y, p: &p, q: &r };
        let given: Given<'_, S<T>, C, Driven<T, N>> = Given {
            on_bodies: &on_bodies,
            in_joints: &in_joints,
            position: &position,
            rate: &rate,
            reading: Reading { position: &position, rate: &rate, acceleration: &rate },
            springs: Explicit,
        };
        let root = accelerated(chain.condense(Empty, posture, given, &mut kept));
        let mut acceleration = chain.store::<Rates>(());
        recover::<S<T>, C, Open, Explicit>(chain, root, posture, &mut kept, (), &mut acceleration);
        let (mut found, mut k) = ([T::zero(); N], 0);
        Rate::visit(&acceleration, &mut |second| {
            if let Some(entry) = found.get_mut(k) {
                *entry = second;
            }
            k += 1;
        });
        found
    }
}
