//! Holds tests only: see `tests/it`.
