//! Robots with friction, stops, motors and contacts: this package holds tests only.
