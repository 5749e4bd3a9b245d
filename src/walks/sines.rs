//! Sines of all joints at once, before bodies are posed one after the other.

use crate::scalar::Elementary;
use crate::shape::{AtBody, AtJoint, Body, Joint, Mut, Outward, PerAxes, Positions, Ref, Shape, Walk, alike};
use crate::space::Space;
use num_traits::Zero;

/// As many angles as are worked on together.
const MOST: usize = 64;

/// Stores sine and cosine of each angle that a joint asks for ([`Joint::SINES`]): where the type of the chain says how many there are, in
/// one loop, which vectorises.
#[cfg_attr(optimised, inline(always))]
pub fn sines<S: Space, E: Shape<S>>(chain: &E, positions: &E::Store<Positions>, x: &mut E::Store<PerAxes<S::X>>) {
    if const { E::SINES == 0 } {
        return;
    }
    if const { E::SINES > MOST } {
        chain.outward(&mut Each, (), (positions, x));
    } else if const { E::SINES > MOST / 2 } {
        together::<S, E, MOST>(chain, positions, x);
    } else if const { E::SINES > MOST / 4 } {
        together::<S, E, { MOST / 2 }>(chain, positions, x);
    } else {
        together::<S, E, { MOST / 4 }>(chain, positions, x);
    }
}

/// Stores sines and cosines by way of lists that have room for all: to clear more takes time.
#[cfg_attr(optimised, inline(always))]
fn together<S: Space, E: Shape<S>, const ROOM: usize>(
    chain: &E,
    positions: &E::Store<Positions>,
    x: &mut E::Store<PerAxes<S::X>>,
) {
    let (mut angles, mut list) = ([S::Scalar::zero(); ROOM], [[S::Scalar::zero(); 2]; ROOM]);
    chain.outward(&mut Gather { angles: &mut angles, next: 0 }, (), (positions,));
    // This constant is evaluated for every chain, those included whose type does not say how many there are.
    let count = const { if E::SINES > ROOM { 0 } else { E::SINES.next_multiple_of(4) } };
    for (angle, pair) in angles.iter().zip(&mut list).take(count) {
        let (sine, cosine) = angle.sin_cos();
        *pair = [sine, cosine];
    }
    chain.outward(&mut Spread { list: &list, next: 0 }, (), (x,));
}

/// Finds sines where it meets a joint.
struct Each;

impl<S: Space> Walk<S> for Each {
    type Carried = ();
    type Stores = (Ref<Positions>, Mut<PerAxes<S::X>>);
}

impl<S: Space> Outward<S> for Each {
    alike!();

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    #[cfg_attr(optimised, inline(always))]
    fn joint<J: Joint<S>>(&mut self, joint: &J, (): (), (position, x): AtJoint<'_, S, Self, J>) {
        if const { J::SINES > 0 } {
            let (sine, cosine) = joint.angle(position).sin_cos();
            joint.set_sine(x, [sine, cosine]);
        }
    }
}

/// Lists angles.
struct Gather<'l, T, const ROOM: usize> {
    angles: &'l mut [T; ROOM],
    next: usize,
}

impl<S: Space, const ROOM: usize> Walk<S> for Gather<'_, S::Scalar, ROOM> {
    type Carried = ();
    type Stores = (Ref<Positions>,);
}

impl<S: Space, const ROOM: usize> Outward<S> for Gather<'_, S::Scalar, ROOM> {
    alike!();

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    #[cfg_attr(optimised, inline(always))]
    fn joint<J: Joint<S>>(&mut self, joint: &J, (): (), (position,): AtJoint<'_, S, Self, J>) {
        if const { J::SINES > 0 } {
            if let Some(angle) = self.angles.get_mut(self.next) {
                *angle = joint.angle(position);
            }
            self.next += 1;
        }
    }
}

/// Hands sines and cosines to joints.
struct Spread<'l, T, const ROOM: usize> {
    list: &'l [[T; 2]; ROOM],
    next: usize,
}

impl<S: Space, const ROOM: usize> Walk<S> for Spread<'_, S::Scalar, ROOM> {
    type Carried = ();
    type Stores = (Mut<PerAxes<S::X>>,);
}

impl<S: Space, const ROOM: usize> Outward<S> for Spread<'_, S::Scalar, ROOM> {
    alike!();

    #[inline(always)]
    fn body<B: Body<S>>(&mut self, _: &B, (): (), _: AtBody<'_, S, Self, B>) {}
    #[cfg_attr(optimised, inline(always))]
    fn joint<J: Joint<S>>(&mut self, joint: &J, (): (), (x,): AtJoint<'_, S, Self, J>) {
        if const { J::SINES > 0 } {
            if let Some(pair) = self.list.get(self.next) {
                joint.set_sine(x, *pair);
            }
            self.next += 1;
        }
    }
}
