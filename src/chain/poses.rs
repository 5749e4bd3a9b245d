//! Postures of the items of arrays and vectors: loops that vectorise.

use crate::element::{Element, Space};
use crate::shape::PerAxes;

/// Binds slices that march together, and leaves where they differ in length: then loops over them need no bounds checks.
/// Stores are made by the chain that walks them, and motions are compared with their scene before, so they do not differ.
macro_rules! march {
    ($n:ident: $first:ident $($slice:ident)*; mut $($change:ident)*; else $($otherwise:expr)?) => {
        let $n = $first.len();
        $(let $slice = &$slice[..];)*
        $(let $change = &mut $change[..];)*
        if false $(|| $slice.len() != $n)* $(|| $change.len() != $n)* {
            return $($otherwise)?;
        }
    };
}
pub(super) use march;

/// `Element::turned` by items: by the last one where what lies inboard of it does not matter.
#[cfg_attr(optimised, inline(always))]
pub(super) fn turned_by_items<S: Space, A: Element<S>>(
    items: &[A],
    position: &[A::Position],
    rate: &[A::Rate],
    turn: S::Turn,
) -> S::Turn {
    let from = if A::TURNS_ANEW { items.len().saturating_sub(1) } else { 0 };
    let items = items.iter().zip(position).zip(rate).skip(from);
    items.fold(turn, |turn, ((item, position), rate)| item.turned(position, rate, turn))
}

/// `Element::orient` of items. Slices are arguments: of these alone the compiler knows that they do not overlap.
#[cfg_attr(optimised, inline(always))]
#[allow(clippy::too_many_arguments)] // slices that march together
pub(super) fn orient_items<S: Space, A: Element<S>>(
    items: &[A],
    position: &[A::Position],
    rate: &[A::Rate],
    mut turn: S::Turn,
    x: &mut [A::Store<PerAxes<S::X>>],
    y: &mut [A::Store<PerAxes<S::Y>>],
    p: &mut [A::Store<PerAxes<S::P>>],
    q: &mut [A::Store<PerAxes<S::Q>>],
) -> S::Turn {
    march!(n: items position rate; mut x y p q; else turn);
    for i in 0..n {
        let (x, y, p, q) = (&mut x[i], &mut y[i], &mut p[i], &mut q[i]);
        turn = items[i].orient(&position[i], &rate[i], turn, x, y, p, q);
    }
    turn
}

/// `Element::resolve` of items.
#[cfg_attr(optimised, inline(always))]
pub(super) fn resolve_items<S: Space, A: Element<S>>(
    sizes: &[A::Store<PerAxes<S::Size>>],
    x: &mut [A::Store<PerAxes<S::X>>],
    y: &mut [A::Store<PerAxes<S::Y>>],
    p: &mut [A::Store<PerAxes<S::P>>],
    q: &mut [A::Store<PerAxes<S::Q>>],
) {
    march!(n: sizes; mut x y p q; else);
    for i in 0..n {
        A::resolve(&sizes[i], &mut x[i], &mut y[i], &mut p[i], &mut q[i]);
    }
}

/// `Element::pose` of items in one loop, where the order does not matter. What turn they hand on it does not say: a loop that
/// brought out the last one would keep registers for it.
#[cfg_attr(optimised, inline(always))]
#[allow(clippy::too_many_arguments)]
pub(super) fn pose_items<S: Space, A: Element<S>>(
    items: &[A],
    position: &[A::Position],
    rate: &[A::Rate],
    turn: S::Turn,
    sizes: &[A::Store<PerAxes<S::Size>>],
    x: &mut [A::Store<PerAxes<S::X>>],
    y: &mut [A::Store<PerAxes<S::Y>>],
    p: &mut [A::Store<PerAxes<S::P>>],
    q: &mut [A::Store<PerAxes<S::Q>>],
) {
    march!(n: items position rate sizes; mut x y p q; else);
    for i in 0..n {
        let (x, y, p, q) = (&mut x[i], &mut y[i], &mut p[i], &mut q[i]);
        items[i].pose(&position[i], &rate[i], turn, &sizes[i], x, y, p, q);
    }
}

/// `Element::pose` of items in two loops, of which only the first has to go in order.
#[cfg_attr(optimised, inline(always))]
#[allow(clippy::too_many_arguments)]
pub(super) fn pose_items_in_order<S: Space, A: Element<S>>(
    items: &[A],
    position: &[A::Position],
    rate: &[A::Rate],
    turn: S::Turn,
    sizes: &[A::Store<PerAxes<S::Size>>],
    x: &mut [A::Store<PerAxes<S::X>>],
    y: &mut [A::Store<PerAxes<S::Y>>],
    p: &mut [A::Store<PerAxes<S::P>>],
    q: &mut [A::Store<PerAxes<S::Q>>],
) -> S::Turn {
    let turn = orient_items(items, position, rate, turn, x, y, p, q);
    resolve_items::<S, A>(sizes, x, y, p, q);
    turn
}

/// [`pose_items`] as a function of its own: it costs a call and saves to ask whether slices overlap.
#[cfg(feature = "alloc")]
#[inline(never)]
#[allow(clippy::too_many_arguments)]
pub(super) fn pose_slices<S: Space, A: Element<S>>(
    items: &[A],
    position: &[A::Position],
    rate: &[A::Rate],
    turn: S::Turn,
    sizes: &[A::Store<PerAxes<S::Size>>],
    x: &mut [A::Store<PerAxes<S::X>>],
    y: &mut [A::Store<PerAxes<S::Y>>],
    p: &mut [A::Store<PerAxes<S::P>>],
    q: &mut [A::Store<PerAxes<S::Q>>],
) {
    pose_items(items, position, rate, turn, sizes, x, y, p, q);
}

/// [`pose_items_in_order`] as a function of its own.
#[cfg(feature = "alloc")]
#[inline(never)]
#[allow(clippy::too_many_arguments)]
pub(super) fn pose_slices_in_order<S: Space, A: Element<S>>(
    items: &[A],
    position: &[A::Position],
    rate: &[A::Rate],
    turn: S::Turn,
    sizes: &[A::Store<PerAxes<S::Size>>],
    x: &mut [A::Store<PerAxes<S::X>>],
    y: &mut [A::Store<PerAxes<S::Y>>],
    p: &mut [A::Store<PerAxes<S::P>>],
    q: &mut [A::Store<PerAxes<S::Q>>],
) -> S::Turn {
    pose_items_in_order(items, position, rate, turn, sizes, x, y, p, q)
}
