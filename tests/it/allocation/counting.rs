//! A global allocator that counts, for the thread that allocates, and the system's allocator behind it.

use std::alloc::{GlobalAlloc, Layout, System as Heap};
use std::cell::Cell;

struct Counting;

thread_local! {
    /// Allocations so far.
    static COUNT: Cell<usize> = const { Cell::new(0) };
    /// Bytes in use.
    static HELD: Cell<usize> = const { Cell::new(0) };
}

/// A block of this size is new.
fn note(size: usize) {
    COUNT.set(COUNT.get() + 1);
    HELD.set(HELD.get().wrapping_add(size));
}

// SAFETY: everything is handed on to the system's allocator; a counter without destructor needs no memory of its own.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        note(layout.size());
        // SAFETY: the caller's promise.
        unsafe { Heap.alloc(layout) }
    }
    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        note(layout.size());
        // SAFETY: the caller's promise.
        unsafe { Heap.alloc_zeroed(layout) }
    }
    unsafe fn realloc(&self, old: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        note(size.wrapping_sub(layout.size()));
        // SAFETY: the caller's promise.
        unsafe { Heap.realloc(old, layout, size) }
    }
    unsafe fn dealloc(&self, old: *mut u8, layout: Layout) {
        HELD.set(HELD.get().wrapping_sub(layout.size()));
        // SAFETY: the caller's promise.
        unsafe { Heap.dealloc(old, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// Allocations of this thread so far.
pub fn count() -> usize {
    COUNT.get()
}

/// Bytes that this thread holds.
pub fn held() -> usize {
    HELD.get()
}

/// Allocations of this thread while something is done.
pub fn allocations<X>(what: impl FnOnce() -> X) -> (usize, X) {
    let before = count();
    let result = what();
    (count() - before, result)
}

#[test]
fn the_allocator_counts() {
    assert_eq!(allocations(|| vec![0_u8; 10]).0, 1);
    assert_eq!(allocations(|| Vec::<u8>::with_capacity(10).push(1)).0, 1);
    assert_eq!(allocations(|| [0_u8; 10]).0, 0);
}
