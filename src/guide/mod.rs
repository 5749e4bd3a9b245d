//! Chapters for users: how to do what, with examples that run.
//!
//! | chapter | answers |
//! |---|---|
//! | [`choosing_a_rule`] | which rule of time, what step or tolerance |
//! | [`numbering`] | which number is whose: bodies, joints, stations, coordinates |
//! | [`loads`] | friction, motors, wind, stops, contact |
//! | [`coordinates`] | how motions are set and read |
//! | [`loops`] | how arms meet again, and what to do if they do not |
//! | [`derivatives`] | of what, by what, and which way is cheapest |
//! | [`lanes_and_threads`] | many scenes at once |
//! | [`real_time`] | a controller's cycle, with friction, stops and contacts |
//! | [`no_std`] | firmware, and steps that must be on time |
//! | [`own_elements`] | what the library does not have |
//! | [`method`] | how it works, in three pages |

pub mod choosing_a_rule;
pub mod coordinates;
pub mod derivatives;
pub mod lanes_and_threads;
pub mod loads;
pub mod loops;
pub mod method;
pub mod no_std;
pub mod numbering;
pub mod own_elements;
pub mod real_time;
