//! The costate sweep: joints with modes.
//!
//! A joint that moves is the joint inside, under its law and the friction of its slip: −F sgn q̇, of which F̄ = −w sgn q̇. One that does not move has
//! no virtual velocity, and nothing is eliminated; what its coordinate does to all others it does all the same. How modes change, and what that
//! does to costates, stands elsewhere ([`sensitivity`](crate::sensitivity)).

/// What a joint with modes does in the walks of the costate sweep around a joint inside: how that is driven, and its inverse pivot made zero, while it is
/// held still; a torque in it with a force along its coordinate; where the costates of friction and of the law's numbers stand, friction first.
macro_rules! guarded {
    ($Space:ident, [$($bounds:tt)*] $Joint:ty, |$joint:ident, $x:ident, $y:ident, $p:ident, $q:ident| {
        drive: |$outer:ident, $acceleration:ident, $gains:ident| $drive:expr,
        hold: |$pivot:ident| $hold:expr,
        under: |$torque:ident, $force:ident| $under:expr,
        numbers: |$sums:ident| $numbers:expr $(,)?
    }) => {
        guarded!(@ $Space, [C: Closures, By: Springs<T>, $($bounds)*] $Joint, Factor<C, By>,
            |guarded, walk, $outer: Outboard<T, C>, ($x, $y, $p, $q, (position, rate, led), $torque, kept, $pivot)| {
                let ($joint, mode, $gains) = (guarded.joint(), position.mode_at(rate), &mut kept.own);
                if mode.is_locked() {
                    let $acceleration = T::zero();
                    $hold;
                    return Outboard::rigid($drive);
                }
                // Gains of a joint that did not move say so where those of one that does are taken for granted.
                *$gains = <$Joint as Joint<$Space<T>>>::kept::<C>();
                let $force = guarded.law().force(position.coordinate, rate.rate) - guarded.guard().resists(mode);
                let led = (&led.0.coordinate, &led.1.rate, &led.2.rate);
                let (at, effort) = ((&position.coordinate, &rate.rate, led), $under);
                $joint.take(walk, $outer, ($x, $y, $p, $q, at, &effort, $gains, $pivot))
            });
        guarded!(@ $Space, [C: Closures, $($bounds)*] $Joint, Reach<T, C>,
            |guarded, walk, inner: Acceleration<T>, (x, y, p, q, kept, acceleration, reached)| {
                guarded.joint().take(walk, inner, (x, y, p, q, &kept.own, &mut acceleration.rate, reached))
            });
        guarded!(@ $Space, [C: Closures, $($bounds)*] $Joint, Meet<T, C>,
            |guarded, walk, outer: Wrench<T>, (x, y, p, q, kept, pivot, costate, _)| {
                guarded.joint().take(walk, outer, (x, y, p, q, &kept.own, pivot, &mut costate.rate, &mut ()))
            });
        guarded!(@ $Space, [C: Closures, $($bounds)*] $Joint, Burden<T, C>,
            |guarded, walk, outer: Wrench<T>, (x, y, p, q, (), kept, pivot)| {
                guarded.joint().take(walk, outer, (x, y, p, q, &(), &mut kept.own, pivot))
            });
        guarded!(@ $Space, [C: Closures, $($bounds)*] $Joint, Stir<T, C>,
            |guarded, walk, inner: Stirred<T>, (x, y, p, q, kept, (position, rate, acceleration, free), at, torque)| {
                let motion = (&position.coordinate, &rate.rate, &acceleration.rate, &mut free.rate);
                guarded.joint().take(walk, inner, (x, y, p, q, &kept.own, motion, at, torque))
            });
        guarded!(@ $Space, [$($bounds)*] $Joint, PullBack,
            |guarded, walk, outer: Pulled<T>,
                (x, y, p, q, (position, rate, acceleration, w), seen, (none, $sums), (of_position, of_rate))| {
                let motion = (&position.coordinate, &rate.rate, &acceleration.rate, &w.rate);
                let of_motion = (&mut of_position.rate, &mut of_rate.rate);
                let inner = guarded.joint().take(walk, outer, (x, y, p, q, motion, seen, (none, &mut *$sums), of_motion));
                let mode = position.mode_at(rate);
                if walk.laws && !mode.is_locked() {
                    let (friction, of_law) = $numbers.split_at_mut(1);
                    friction[0] -= mode.sign::<T>() * w.rate;
                    let more = guarded.law().pull_back(position.coordinate, rate.rate, w.rate, of_law);
                    of_position.rate += more[0];
                    of_rate.rate += more[1];
                }
                inner
            });
        guarded!(@ $Space, [N: BodyLaw<$Space<T>>, $($bounds)*] $Joint, PullLoads<N, $Space<T>>,
            |guarded, walk, outer: Felt<T>, (x, y, p, q, (position, rate, w), seen, sums, (of_position, of_rate))| {
                let motion = (&position.coordinate, &rate.rate, &w.rate);
                let of_motion = (&mut of_position.rate, &mut of_rate.rate);
                guarded.joint().take(walk, outer, (x, y, p, q, motion, seen, sums, of_motion))
            });
        // Implicit rules are refused.
        guarded!(@ $Space, [$($bounds)*] $Joint, Strain<T>, |_guarded, _walk, _carried: (), _stores| {});
    };
    (@ $Space:ident, [$($bounds:tt)*] $Joint:ty, $Walk:ty,
        |$guarded:ident, $walk:ident, $carried:ident: $Carried:ty, $stores:pat_param| $does:expr) => {
        impl<T: Scalar, Stay: Guard<T>, Law: ReversibleLaw<T>, $($bounds)*> Takes<$Space<T>, $Walk>
            for Guarded<$Joint, Stay, Law>
        {
            #[allow(unused_variables)] // of what one joint or another reads
            fn take(&self, $walk: &mut $Walk, $carried: $Carried, $stores: Of<'_, $Space<T>, $Walk, Self>) -> $Carried {
                let $guarded = self;
                $does
            }
        }
    };
}
pub(crate) use guarded;
