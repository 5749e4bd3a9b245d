//! What a spatial joint stores of its posture: one set of axes or two, and vectors beside them.

use super::Joint;
use crate::relation::spatial::algebra::Columns;
use nalgebra::Vector3;

/// What a joint with one set of axes stores of its posture: axes and arm, and the accelerations that rates alone cause.
pub type Stored<T> = (Columns<T>, [Vector3<T>; 2]);

/// How many sets of axes a joint stores.
pub trait Sets {
    /// One `X` for each set.
    type Per<X: Copy>: Copy;
    /// `fill` for each set.
    fn per<X: Copy>(fill: X) -> Self::Per<X>;
}

/// One set of axes.
#[derive(Clone, Copy, Debug)]
pub struct One;

/// Two sets of axes: those of the outboard body and those of the inboard one.
#[derive(Clone, Copy, Debug)]
pub struct Two;

impl Sets for One {
    type Per<X: Copy> = X;
    fn per<X: Copy>(fill: X) -> X {
        fill
    }
}

impl Sets for Two {
    type Per<X: Copy> = [X; 2];
    fn per<X: Copy>(fill: X) -> [X; 2] {
        [fill; 2]
    }
}

/// Axes that a joint stores.
pub type Axes<T, J> = <<J as Joint<T>>::Sets as Sets>::Per<Columns<T>>;
/// Vectors that a joint stores beside its axes.
pub type Biases<T, J> = <<J as Joint<T>>::Sets as Sets>::Per<[Vector3<T>; 2]>;
/// Axes and vectors that a joint stores.
pub type StoredIn<T, J> = (Axes<T, J>, Biases<T, J>);
