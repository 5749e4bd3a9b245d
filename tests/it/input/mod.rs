//! What makes no mechanics is refused by name.

mod plane;
mod space;
