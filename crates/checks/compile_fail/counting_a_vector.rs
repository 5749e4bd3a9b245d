//! A vector has as many elements as it has when the program runs.
//@ the number of bodies of `Vec<(Rod<f64>, Pin)>` is not known at compile time

use catena::planar::*;
use catena::system::Counted;

fn bodies_of<C: Counted>() {}

fn main() {
    bodies_of::<Vec<(Rod<f64>, Pin)>>();
}
