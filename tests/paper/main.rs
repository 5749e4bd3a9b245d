//! The formulation of 2005, against the equations it stands for, other integrations and the published figures.

mod elements;
mod roots;
mod scenes;
mod spatial;
mod springs;
mod topology;
