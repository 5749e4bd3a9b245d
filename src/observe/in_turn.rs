//! Readings in turn, each met once: a search for every one of them would cost the square of their number.

#[cfg(feature = "alloc")]
use alloc::vec::Vec;

/// Readings number 0 to `count` − 1 of a scene, some of which may be missing. `get` looks one up, which costs as much as its type is
/// deep where that decides how many bodies and joints there are (`counted`). Where lengths of vectors do, a search would begin at the
/// front, so that `list` walks over all of them first, and what it shows is kept.
pub(super) fn in_turn<'a, X: 'a>(
    counted: bool,
    count: usize,
    get: impl Fn(usize) -> Option<&'a X>,
    list: impl FnOnce(&mut dyn FnMut(Option<&'a X>)),
) -> impl Iterator<Item = &'a X> {
    #[cfg(feature = "alloc")]
    let listed = (!counted).then(|| {
        let mut listed = Vec::with_capacity(count);
        list(&mut |reading| listed.push(reading));
        listed
    });
    #[cfg(feature = "alloc")]
    let get = move |k: usize| listed.as_ref().map_or_else(|| get(k), |listed| listed.get(k).copied().flatten());
    #[cfg(not(feature = "alloc"))]
    let _ = (counted, list); // there are no vectors
    (0..count).filter_map(get)
}
