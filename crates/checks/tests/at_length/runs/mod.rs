//! Motion in time where a run takes long.

mod governor;
mod stops;
