//! Every kind of number as scalar, and derivatives forward and backward.

mod assembled;
mod attitudes;
mod backward;
mod derivatives;
mod ensembles;
mod jets;
mod moments;
mod paper;
mod posed_late;
mod robot_sensitivity;
mod scalars;
mod sensitivities;
mod sensitivity;
mod series;
mod series_of_slides;
mod shared_steps;
mod sine;
mod spatial_scalars;
mod spatial_sensitivity;
