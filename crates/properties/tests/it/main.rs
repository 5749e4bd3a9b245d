//! Whatever is handed in, there is a typed error or a sound result. `CATENA_CASES` says how many cases each property is tried with.

#[macro_use]
mod probe;
mod data;
mod draws;
mod plane;
mod space;
