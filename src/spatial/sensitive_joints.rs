//! Derivatives through kept gains in space: what joints do.

use super::axial::{Axial, Listed, Relative};
use super::loads::Effort;
use super::sensitive::{
    Answering, Passing, Pulling, Vectors, add, add_along, add_scaled_vectors, apply, crossed, none, parts, project,
    turned, value,
};
use super::spring::Law;
use super::{Acceleration, Ball, Revolute, Rotation, Spatial, Turn, Universal, Weld};
use crate::lift::Lift;
use crate::relation::space::algebra::{Columns, add_scaled, dot, zero};
use crate::relation::space::{Couple, Full, Gain, Pivot, Point, Way};
use crate::relation::{Absent, Term};
use crate::scalar::{Jet, Scalar, columns};
use crate::sensitive::{At, Seeds, Sensitive};
use nalgebra::Vector3;
use num_traits::Zero;

/// What a ball keeps.
#[derive(Clone, Copy)]
pub struct BallStore<T: Scalar, const K: usize> {
    gain: Gain<T>,
    /// −H⁻¹.
    minus_inverse: Columns<T>,
    /// Columns of φ.
    angle: Vectors<T, K>,
    load: Effort<Jet<T, K>>,
}

/// The φ of a quaternion's derivatives, 2 dq ∘ q̄.
#[inline(always)]
fn angle_of<T: Scalar, const K: usize>(rotation: &Rotation<Jet<T, K>>) -> Vectors<T, K> {
    let two = T::literal(2.0);
    let (w, v) = (rotation.w.re * two, value(&rotation.v) * two);
    let mut angle = none();
    let Columns { x, y, z } = crossed(v);
    let turn = Columns {
        x: x + Vector3::new(w, T::zero(), T::zero()),
        y: y + Vector3::new(T::zero(), w, T::zero()),
        z: z + Vector3::new(T::zero(), T::zero(), w),
    };
    apply(&mut angle, &turn, &parts(&rotation.v));
    add_along(&mut angle, -v, &rotation.w.eps);
    angle
}

fn full<T: Scalar>(point: Point<T, impl Term<Vector3<T>>>) -> Full<T> {
    Full { linear: point.stiffness, force: point.offset, torque: point.torque.add_to(zero()), ..Full::massless() }
}

impl<T: Scalar, const K: usize> Sensitive<Spatial<Jet<T, K>>> for Ball {
    type Plain = Self;
    type Store = BallStore<T, K>;

    fn store(&self) -> Self::Store {
        BallStore { gain: Gain::blank(), minus_inverse: Columns::zero(), angle: none(), load: Effort::default() }
    }
    #[inline(always)]
    fn read(
        position: &Rotation<Jet<T, K>>,
        rate: &[Jet<T, K>; 3],
        plain_position: &mut Rotation<T>,
        plain_rate: &mut [T; 3],
    ) {
        *plain_position = position.lift(&mut |x: Jet<T, K>| x.re);
        *plain_rate = rate.map(|x| x.re);
    }
    fn load(&self, (): &(), in_joint: &Effort<Jet<T, K>>, store: &mut Self::Store) {
        store.load = *in_joint;
    }
    #[inline(always)]
    fn factor<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        outer: Full<T>,
        store: &mut Self::Store,
    ) -> Full<T> {
        let factor = outer.angular.factor();
        let Columns { x, y, z } = Columns::identity();
        store.minus_inverse = Columns { x: -factor.solve(x), y: -factor.solve(y), z: -factor.solve(z) };
        if N::LOADS {
            let Effort(torque) = store.load;
            let couple = at.posture.x.apply(Vector3::from(torque.map(|x| x.re)));
            let (relation, gain) = outer.balled(Couple(couple));
            store.gain = gain;
            return full(relation);
        }
        let (relation, gain) = outer.balled(Absent);
        store.gain = gain;
        full(relation)
    }
    #[inline(always)]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        store: &mut Self::Store,
        acceleration: &mut [Jet<T, K>; 3],
    ) {
        let attitude = *at.posture.x;
        let rate = Vector3::from(*at.rate);
        let spin = attitude.apply(value(&rate));
        let angular = store.gain.angular(carried.acceleration.linear, &());
        let own: [T; 3] = attitude.transposed(angular).into();
        for (to, from) in acceleration.iter_mut().zip(own) {
            to.re = from;
        }
        carried.turn = Turn { attitude, spin };
        carried.acceleration.angular = angular;
        let angle = angle_of(at.position);
        carried.spin = none();
        apply(&mut carried.spin, &crossed(-spin), &angle);
        apply(&mut carried.spin, &attitude, &parts(&rate));
        carried.angular = none();
        apply(&mut carried.angular, &crossed(-angular), &angle);
        carried.angle = angle;
        store.angle = angle;
    }
    #[inline(always)]
    fn gather<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Pulling<T, K>,
        store: &mut Self::Store,
        acceleration: &mut [Jet<T, K>; 3],
    ) {
        let mut applied = none();
        if N::LOADS {
            let torque = Vector3::from(store.load.0);
            let attitude = at.posture.x;
            apply(&mut applied, attitude, &parts(&torque));
            apply(&mut applied, &crossed(-attitude.apply(value(&torque))), &store.angle);
            for (missed, applied) in carried.torques.iter_mut().zip(&applied) {
                columns!(K; applied = *applied; k: mut missed = *missed => missed[k] - applied[k]);
            }
        }
        let Columns { x, y, z } = store.gain.per_acceleration;
        let transposed =
            Columns { x: Vector3::new(x.x, y.x, z.x), y: Vector3::new(x.y, y.y, z.y), z: Vector3::new(x.z, y.z, z.z) };
        apply(&mut carried.forces, &transposed, &carried.torques);
        let mut free = none();
        apply(&mut free, &store.minus_inverse, &carried.torques);
        for (to, from) in acceleration.iter_mut().zip(free) {
            to.eps = from;
        }
        carried.torques = applied;
    }
    #[inline(always)]
    fn answer(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Answering<T, K>,
        store: &Self::Store,
        acceleration: &mut [Jet<T, K>; 3],
    ) {
        carried.angular = acceleration.map(|x| x.eps);
        apply(&mut carried.angular, &store.gain.per_acceleration, &carried.linear);
        let Columns { x, y, z } = *at.posture.x;
        for (to, axis) in acceleration.iter_mut().zip([x, y, z]) {
            to.eps = [T::zero(); K];
            project(&mut to.eps, axis, &carried.angular);
        }
    }
}

impl<T: Scalar, const K: usize> Sensitive<Spatial<Jet<T, K>>> for Weld<Jet<T, K>> {
    type Plain = Weld<T>;
    type Store = ();

    fn store(&self) {}
    #[inline(always)]
    fn read((): &(), (): &(), (): &mut (), (): &mut ()) {}
    fn load(&self, (): &(), _: &Effort<Jet<T, K>>, (): &mut ()) {}
    #[inline(always)]
    fn factor<N: Seeds>(&self, _: At<'_, Spatial<Jet<T, K>>, Self>, outer: Full<T>, (): &mut ()) -> Full<T> {
        outer
    }
    #[inline(always)]
    fn vary<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        (): &mut (),
        (): &mut (),
    ) {
        if N::PARAMETERS {
            apply(&mut carried.angle, &{ carried.turn.attitude }, &turned(self.attitude()));
        }
        carried.turn.attitude = *at.posture.x;
    }
    #[inline(always)]
    fn gather<N: Seeds>(&self, _: At<'_, Spatial<Jet<T, K>>, Self>, _: &mut Pulling<T, K>, (): &mut (), (): &mut ()) {}
    #[inline(always)]
    fn answer(&self, _: At<'_, Spatial<Jet<T, K>>, Self>, _: &mut Answering<T, K>, (): &(), (): &mut ()) {}
}

/// What a joint that turns about `D` axes keeps.
#[derive(Clone, Copy)]
pub struct AxialStore<T: Scalar, const K: usize, const D: usize> {
    pivots: [Pivot<T>; D],
    /// −1 / Δ of each.
    minus_inverse: [T; D],
    axes: [Vector3<T>; D],
    /// Columns of the axes.
    turned: [Vectors<T, K>; D],
    load: Effort<Jet<T, K>>,
}

/// Derivatives of joints that turn about axes.
macro_rules! axial {
    ($Joint:ident<$($Law:ident $Over:ident),*>, $D:literal) => {
        impl<T: Scalar, $($Law, $Over,)* const K: usize> Sensitive<Spatial<Jet<T, K>>> for $Joint<Jet<T, K>, $($Law),*>
        where
            $($Law: Law<Jet<T, K>> + Lift<Jet<T, K>, T, Over = $Over>, $Over: Law<T>,)*
        {
            type Plain = $Joint<T, $($Over),*>;
            type Store = AxialStore<T, K, $D>;

            fn store(&self) -> Self::Store {
                AxialStore {
                    pivots: [Pivot::blank(); $D],
                    minus_inverse: [T::zero(); $D],
                    axes: [zero(); $D],
                    turned: [none(); $D],
                    load: Effort::default(),
                }
            }
            #[inline(always)]
            fn read(
                position: &<Self as Axial<Jet<T, K>, $D>>::Coordinates,
                rate: &<Self as Axial<Jet<T, K>, $D>>::Coordinates,
                plain_position: &mut <Self::Plain as Axial<T, $D>>::Coordinates,
                plain_rate: &mut <Self::Plain as Axial<T, $D>>::Coordinates,
            ) {
                let of = |jets: &<Self as Axial<Jet<T, K>, $D>>::Coordinates| {
                    Listed::<T, $D>::from_list(Listed::<Jet<T, K>, $D>::list(jets).map(|x| x.re))
                };
                (*plain_position, *plain_rate) = (of(position), of(rate));
            }
            fn load(&self, (): &(), in_joint: &Effort<Jet<T, K>>, store: &mut Self::Store) {
                store.load = *in_joint;
            }
            #[inline(always)]
            fn factor<N: Seeds>(
                &self,
                at: At<'_, Spatial<Jet<T, K>>, Self>,
                outer: Full<T>,
                store: &mut Self::Store,
            ) -> Full<T> {
                let (position, rate) = (at.position.list(), at.rate.list());
                let stored = at.posture.x;
                let mut relation = outer;
                for i in (0..$D).rev() {
                    let axis = if i == 0 { stored.x } else { stored.y };
                    let load = if N::LOADS { store.load.0[i].re } else { T::zero() };
                    let force = at.plain.force_onto(i, position[i].re, rate[i].re, load);
                    // The same quotient as in the elimination.
                    store.minus_inverse[i] = -dot(axis, relation.angular.apply(axis)).recip();
                    (relation, store.pivots[i]) = relation.released(Way::Turn, axis, force, Absent);
                    store.axes[i] = axis;
                }
                relation.turning(at.posture.y[1])
            }
            #[inline(always)]
            fn vary<N: Seeds>(
                &self,
                at: At<'_, Spatial<Jet<T, K>>, Self>,
                carried: &mut Passing<T, K>,
                store: &mut Self::Store,
                acceleration: &mut <Self as Axial<Jet<T, K>, $D>>::Coordinates,
            ) {
                let (position, rate) = (at.position.list(), at.rate.list());
                let inboard = carried.turn;
                let relative = at.plain.relative(&inboard, position.map(|x| x.re), rate.map(|x| x.re));
                // What seeds in the axes do besides.
                let seeded: Option<Relative<Jet<T, K>, $D>> = match N::PARAMETERS {
                    true => {
                        let Turn { attitude: Columns { x, y, z }, spin } = inboard;
                        let of = |v: Vector3<T>| v.map(Jet::of);
                        let turn = Turn { attitude: Columns { x: of(x), y: of(y), z: of(z) }, spin: of(spin) };
                        Some(self.relative(&turn, position, rate))
                    }
                    false => None,
                };
                carried.acceleration.angular += at.posture.y[1];
                let mut list = acceleration.list();
                let mut turn = carried.angle;
                for i in 0..$D {
                    let (n, s) = (store.axes[i], rate[i].re);
                    let Acceleration { linear, angular } = carried.acceleration;
                    let second = store.pivots[i].acceleration(linear, angular, &());
                    list[i].re = second;
                    carried.acceleration.angular = add_scaled(angular, second, n);
                    let mut of_axis = none();
                    match &seeded {
                        Some(relative) => {
                            of_axis = parts(&relative.axes[i]);
                            apply(&mut of_axis, &crossed(-n), &carried.angle);
                        }
                        None => apply(&mut of_axis, &crossed(-n), &turn),
                    }
                    // Of n q̈ + ω × n q̇.
                    let mut swept = none();
                    add_along(&mut swept, n, &rate[i].eps);
                    add_scaled_vectors(&mut swept, s, &of_axis);
                    apply(&mut carried.angular, &crossed(carried.turn.spin), &swept);
                    apply(&mut carried.angular, &crossed(-(n * s)), &{ carried.spin });
                    add_scaled_vectors(&mut carried.angular, second, &of_axis);
                    add(&mut carried.spin, &swept);
                    add_along(&mut turn, n, &position[i].eps);
                    carried.turn.spin = add_scaled(carried.turn.spin, s, n);
                    store.turned[i] = of_axis;
                }
                if let Some(relative) = &seeded {
                    turn = carried.angle;
                    add(&mut turn, &turned(&relative.attitude));
                }
                *acceleration = Listed::from_list(list);
                carried.angle = turn;
                carried.turn.attitude = relative.attitude;
            }
            #[inline(always)]
            fn gather<N: Seeds>(
                &self,
                at: At<'_, Spatial<Jet<T, K>>, Self>,
                carried: &mut Pulling<T, K>,
                store: &mut Self::Store,
                acceleration: &mut <Self as Axial<Jet<T, K>, $D>>::Coordinates,
            ) {
                let (position, rate) = (at.position.list(), at.rate.list());
                let mut list = acceleration.list();
                for i in (0..$D).rev() {
                    let load = if N::LOADS { store.load.0[i] } else { Jet::zero() };
                    let force = self.force_onto(i, position[i], rate[i], load);
                    let mut missed = force.eps.map(|x| -x);
                    project(&mut missed, store.axes[i], &carried.torques);
                    project(&mut missed, carried.torque, &store.turned[i]);
                    let Pivot { per_linear, per_angular, .. } = store.pivots[i];
                    add_along(&mut carried.forces, per_linear, &missed);
                    add_along(&mut carried.torques, per_angular, &missed);
                    let minus_inverse = store.minus_inverse[i];
                    list[i].eps = missed.map(|x| x * minus_inverse);
                }
                *acceleration = Listed::from_list(list);
            }
            #[inline(always)]
            fn answer(
                &self,
                _: At<'_, Spatial<Jet<T, K>>, Self>,
                carried: &mut Answering<T, K>,
                store: &Self::Store,
                acceleration: &mut <Self as Axial<Jet<T, K>, $D>>::Coordinates,
            ) {
                let mut list = acceleration.list();
                for i in 0..$D {
                    let Pivot { per_linear, per_angular, .. } = store.pivots[i];
                    project(&mut list[i].eps, per_linear, &carried.linear);
                    project(&mut list[i].eps, per_angular, &carried.angular);
                    add_along(&mut carried.angular, store.axes[i], &list[i].eps);
                }
                *acceleration = Listed::from_list(list);
            }
        }
    };
}
axial!(Revolute<L P>, 1);
axial!(Universal<L P, M Q>, 2);
