//! The costate sweep: joints whose coordinate is a given function of time.
//!
//! Such a joint moves by its law, whatever acts: there is no virtual velocity in it, and nothing is eliminated. With q̄ and q̇⁻ those of
//! the joint inside, and the numbers p of the law,
//!
//! ```text
//! p̄ = q̄ ∂q/∂p + q̇⁻ ∂q̇/∂p + q̈⁻ ∂q̈/∂p        q̈⁻ = −∂P/∂q̈
//! ```
//!
//! where ∂P/∂q̈ is the momentum of the virtual motion along the coordinate: of G along a line, of H about an axis.

use super::{Driven, MotionLaw};
use crate::adjoint::jets::seeded;
use crate::adjoint::laws::NUMBERS;
use crate::lift::Lift;
use crate::mirror::Clock;
use crate::scalar::{Jet, Scalar};

/// A number with derivatives by those of a law.
type Read<T> = Jet<T, NUMBERS>;

/// A law of motion through which costates go backward.
#[diagnostic::on_unimplemented(
    message = "no gradient of a run goes backward through a joint that is driven by `{Self}`",
    label = "not a law of motion that the costate sweep knows",
    note = "it knows structs that are generic over the scalar, implement `MotionLaw` and can be lifted: `catena::lift!`; numbers of closures are hidden",
    note = "run the same scene over jets or dual numbers instead"
)]
pub trait ReversibleMotion<T: Scalar>: MotionLaw<T> {
    /// Adds to costates of the law's numbers, in the order in which [`Lift`] meets them, from those of the coordinate and its derivatives.
    fn pull_back(&self, clock: &Clock<T::Real>, costates: [T; 3], of_numbers: &mut [T]);
}

impl<T: Scalar, F> ReversibleMotion<T> for F
where
    F: MotionLaw<T> + Lift<T, Read<T>, Over: MotionLaw<Read<T>>>,
{
    fn pull_back(&self, clock: &Clock<T::Real>, costates: [T; 3], of_numbers: &mut [T]) {
        let law = Driven::new((), seeded(self, 0).0);
        for (costate, told) in costates.into_iter().zip(law.told::<Read<T>>(clock)) {
            of_numbers.iter_mut().zip(told.eps).for_each(|(sum, slope)| *sum += costate * slope);
        }
    }
}

/// What a driven joint does in the walks of the costate sweep around a joint inside: how that is driven, where the costates of the law's
/// numbers stand, and the momentum of what is carried along its coordinate.
macro_rules! driven {
    ($Space:ident, [$($bounds:tt)*] $Joint:ty, |$joint:ident, $x:ident, $y:ident, $p:ident, $q:ident| {
        drive: |$outer:ident, $acceleration:ident, $gains:ident| $drive:expr,
        numbers: |$sums:ident| $numbers:expr,
        momentum: |$pulled:ident, $met:ident| $momentum:expr $(,)?
    }) => {
        driven!(@ $Space, [C: Closures, By: Springs<T>, $($bounds)*] $Joint, Factor<C, By>,
            |driven, _walk, $outer: Outboard<T, C>, ($x, $y, $p, $q, (clock, ..), _, $gains, _)| {
                let ([.., $acceleration], $joint) = (driven.told(clock), driven.joint());
                Outboard::rigid($drive)
            });
        driven!(@ $Space, [C: Closures, $($bounds)*] $Joint, Reach<T, C>,
            |driven, walk, inner: Acceleration<T>, (x, y, p, q, gains, _, reached)| {
                driven.joint().take(walk, inner, (x, y, p, q, gains, &mut T::zero(), reached))
            });
        driven!(@ $Space, [C: Closures, $($bounds)*] $Joint, Meet<T, C>,
            |driven, walk, outer: Wrench<T>, (x, y, p, q, gains, pivot, _, _)| {
                driven.joint().take(walk, outer, (x, y, p, q, gains, pivot, &mut T::zero(), &mut ()))
            });
        driven!(@ $Space, [C: Closures, $($bounds)*] $Joint, Burden<T, C>,
            |driven, walk, outer: Wrench<T>, (x, y, p, q, (), gains, pivot)| {
                driven.take(&mut walk.0, outer, (x, y, p, q, &*gains, pivot, &mut (), &mut ()))
            });
        driven!(@ $Space, [C: Closures, $($bounds)*] $Joint, Stir<T, C>,
            |driven, walk, inner: Stirred<T>, (x, y, p, q, gains, (clock, ..), kept, _)| {
                let ([position, rate, acceleration], mut none) = (driven.told(clock), T::zero());
                // What a torque in the joint does to the cost is nothing: it is not added up.
                let motion = (&position, &rate, &acceleration, &mut none);
                driven.joint().take(walk, inner, (x, y, p, q, gains, motion, kept, &mut Additive::null()))
            });
        driven!(@ $Space, [$($bounds)*] $Joint, PullBack,
            |driven, walk, outer: Pulled<T>, ($x, $y, $p, $q, (clock, ..), seen, (none, $sums), _)| {
                let [position, rate, acceleration] = driven.told(clock);
                let [mut of_position, mut of_rate, still] = [T::zero(); 3];
                let of_acceleration = {
                    let ($joint, $pulled, $met) = (driven.joint(), &outer, seen.3);
                    -$momentum
                };
                let motion = (&position, &rate, &acceleration, &still);
                let of_motion = (&mut of_position, &mut of_rate);
                let inner = driven.joint().take(walk, outer, ($x, $y, $p, $q, motion, seen, (none, &mut *$sums), of_motion));
                driven.law().pull_back(clock, [of_position, of_rate, of_acceleration], $numbers);
                inner
            });
        driven!(@ $Space, [N: BodyLaw<$Space<T>>, $($bounds)*] $Joint, PullLoads<N, $Space<T>>,
            |driven, walk, outer: Felt<T>, (x, y, p, q, (clock, ..), seen, (none, $sums), _)| {
                let [position, rate, _] = driven.told(clock);
                let [mut of_position, mut of_rate, still] = [T::zero(); 3];
                let (motion, of_motion) = ((&position, &rate, &still), (&mut of_position, &mut of_rate));
                let inner = driven.joint().take(walk, outer, (x, y, p, q, motion, seen, (none, &mut *$sums), of_motion));
                driven.law().pull_back(clock, [of_position, of_rate, still], $numbers);
                inner
            });
        driven!(@ $Space, [$($bounds)*] $Joint, Strain<T>, |_driven, _walk, _carried: (), _stores| {});
    };
    (@ $Space:ident, [$($bounds:tt)*] $Joint:ty, $Walk:ty,
        |$driven:ident, $walk:ident, $carried:ident: $Carried:ty, $stores:pat_param| $does:expr) => {
        impl<T: Scalar, Law: ReversibleMotion<T>, $($bounds)*> Takes<$Space<T>, $Walk> for Driven<$Joint, Law> {
            #[allow(unused_variables)] // of what one joint or another reads
            fn take(&self, $walk: &mut $Walk, $carried: $Carried, $stores: Of<'_, $Space<T>, $Walk, Self>) -> $Carried {
                let $driven = self;
                $does
            }
        }
    };
}
pub(crate) use driven;
