//! Room that steps hand to their own methods and take back.

/// Room that is apart: where there is a heap, it stands there, and a pointer is what moves.
#[cfg(feature = "alloc")]
pub(super) type Apart<X> = alloc::boxed::Box<X>;
#[cfg(not(feature = "alloc"))]
pub(super) use without::Apart;

/// Room where there is no heap.
#[cfg(not(feature = "alloc"))]
mod without {
    use core::ops::{Deref, DerefMut};

    /// Room that moves as it is.
    pub struct Apart<X>(X);

    impl<X> Apart<X> {
        /// Room.
        pub fn new(room: X) -> Self {
            Self(room)
        }
    }
    impl<X> Deref for Apart<X> {
        type Target = X;
        fn deref(&self) -> &X {
            &self.0
        }
    }
    impl<X> DerefMut for Apart<X> {
        fn deref_mut(&mut self) -> &mut X {
            &mut self.0
        }
    }
}
