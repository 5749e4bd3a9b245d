//! Equilibrium and vibration of beams and ropes of many segments.

mod beam;
mod far_guesses;
mod ropes_at_rest;
mod spatial_beam;
mod statics;
