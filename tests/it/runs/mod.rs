//! Motion in time: references, orders, conservation.

mod adams;
mod auto;
mod by_series;
mod double_pendulum;
mod driven_sliders;
mod endless_runs;
mod from_events;
mod implicit_forces;
mod laws_of_users;
mod loads_that_set_in;
mod named_runs;
mod references;
mod series;
mod series_closed_in_space;
mod series_held;
mod series_in_space;
mod series_loops;
mod series_of_laws;
mod series_under_loads;
mod spatial_orders;
mod spatial_references;
mod spatial_runs;
mod start;
mod through_time;
mod turned;
mod vcabm;
