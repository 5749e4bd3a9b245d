//! The costate sweep in the plane: tips, and what holds in general.

use super::{AtJoint, Felt, Kind, OnBody, Outboard, Pulled, Stirred};
use crate::adjoint::{Holds, ReversibleTip, TIP};
use crate::chain::Named;
use crate::element::Level;
use crate::ends::Tip;
use crate::mechanics::planar::{Acceleration, Clamped, Frame, Free, Guided, Pin, Pinned, Planar, Weld, Wrench};
use crate::relation::planar::algebra::{dot, normal};
use crate::relation::{Additive, Closures};
use crate::scalar::Scalar;
use nalgebra::Vector2;

/// A force without a torque.
fn force<T: Scalar>(force: Vector2<T>) -> Wrench<T> {
    Wrench { force, torque: T::zero() }
}

/// What the kinematics of the plane say, whatever is held.
macro_rules! holds {
    ($([$($K:ident)?] $End:ty),*) => {$(
        impl<T: Scalar $(, $K)?> Holds<Planar<T>> for $End {
        fn stirred(stirred: &Stirred<T>) -> Acceleration<T> {
            stirred.velocity
        }
        fn of_body(kept: &OnBody<T>) -> Vector2<T> {
            kept.velocity
        }
        fn of_joint(kept: &AtJoint<T>) -> Vector2<T> {
            kept.velocity
        }
        /// Torques do not turn with the body, and so are not seen.
        fn pulled(weight: Wrench<T>, force: Wrench<T>) -> Pulled<T> {
            Pulled { momentum: weight.force, force: -force.force, ..Pulled::null() }
        }
        fn felt(of_place: Wrench<T>, of_velocity: Wrench<T>) -> Felt<T> {
            let turn = [of_place.torque, of_velocity.torque];
            Felt { place: of_place.force, velocity: of_velocity.force, turn, ..Felt::null() }
        }
        }
    )*};
}
holds!([] Free, [] Pinned<[T; 2]>, [] Clamped<[T; 2], T>, [] Guided<[T; 2], T, T>, [] Pin, [] Weld<T>, [K] Named<K>);

/// What lies beyond the last body where a tip is held: λ acts on the body, and c · A of the body is that of the ground.
macro_rules! beyond {
    ($kind:ident) => {
        fn beyond(&self, still: &Acceleration<T>) -> Outboard<T, <Self as Tip<Planar<T>>>::Closures> {
            let columns = <Self as Tip<Planar<T>>>::Closures::map(&self.columns(), |column| -column);
            Outboard::cut(
                Kind::$kind,
                columns,
                <Self as Tip<Planar<T>>>::Closures::map(&columns, |column| column.work(still)),
            )
        }
    };
}

impl<T: Scalar> ReversibleTip<Planar<T>> for Free {
    fn beyond(&self, _: &Acceleration<T>) -> Outboard<T> {
        Outboard::nothing()
    }
    fn columns(&self) {}
}

impl<T: Scalar> ReversibleTip<Planar<T>> for Pinned<[T; 2]> {
    fn columns(&self) -> [Wrench<T>; 2] {
        let (zero, one) = (T::zero(), T::one());
        [force(Vector2::new(one, zero)), force(Vector2::new(zero, one))]
    }
    beyond!(Point);
    fn numbers(&self) -> [T; TIP] {
        let [x, y] = self.place;
        [x, y, T::zero(), T::zero()]
    }
    fn of_residual(&self, weight: &[T; 2], _: &Frame<T>, level: Level) -> [T; TIP] {
        let zero = T::zero();
        match level {
            Level::Place => [-weight[0], -weight[1], zero, zero],
            Level::Velocity => [zero; TIP],
        }
    }
}

impl<T: Scalar> ReversibleTip<Planar<T>> for Clamped<[T; 2], T> {
    fn columns(&self) -> [Wrench<T>; 3] {
        let [x, y] = Pinned::on(self.place).columns();
        [x, y, Wrench { force: Vector2::null(), torque: T::one() }]
    }
    beyond!(Rigid);
    fn numbers(&self) -> [T; TIP] {
        let [x, y] = self.place;
        [x, y, self.attitude, T::zero()]
    }
    fn of_residual(&self, weight: &[T; 3], _: &Frame<T>, level: Level) -> [T; TIP] {
        match level {
            Level::Place => [-weight[0], -weight[1], -weight[2], T::zero()],
            Level::Velocity => [T::zero(); TIP],
        }
    }
}

/// Numbers of a guide are place, angle, and direction of the line against it, by which the normal n of the line turns: n′ = −ẑ×ᵀ n.
impl<T: Scalar> ReversibleTip<Planar<T>> for Guided<[T; 2], T, T> {
    fn columns(&self) -> [Wrench<T>; 2] {
        [force(self.across()), Wrench { force: Vector2::null(), torque: T::one() }]
    }
    beyond!(Rigid);
    fn numbers(&self) -> [T; TIP] {
        let (Clamped { place: [x, y], attitude }, line) = self.parts();
        [x, y, attitude, line]
    }
    fn of_columns(
        &self,
        (weight, a): (&[T; 2], &Acceleration<T>),
        (force, w): (&[T; 2], &Acceleration<T>),
    ) -> [T; TIP] {
        let turned = normal(self.across());
        let by_angle = force[0] * dot(turned, w.linear) - weight[0] * dot(turned, a.linear);
        [T::zero(), T::zero(), by_angle, by_angle]
    }
    fn of_residual(&self, weight: &[T; 2], frame: &Frame<T>, level: Level) -> [T; TIP] {
        let (n, (Clamped { place, .. }, _)) = (self.across(), self.parts());
        let by_angle = |v: Vector2<T>| weight[0] * dot(normal(n), v);
        match level {
            Level::Place => {
                let turned = by_angle(frame.place - Vector2::from(place));
                [-(weight[0] * n.x), -(weight[0] * n.y), turned - weight[1], turned]
            }
            Level::Velocity => {
                let turned = by_angle(frame.velocity);
                [T::zero(), T::zero(), turned, turned]
            }
        }
    }
}
