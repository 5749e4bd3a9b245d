//! The seal: a trait that nothing outside of this crate can name, required by traits that nothing outside of it implements.

/// A supertrait of traits whose implementations are all here.
pub trait Sealed {}
