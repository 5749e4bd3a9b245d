//! Derivatives through kept gains in the plane: what bodies do.
//!
//! A body turned by θ carries the point O at d from I, n = ẑ × d, a point mass μ there, a first moment σ and a moment of inertia J about
//! I. With p_d = −ω² d and F_O the force at O
//!
//! ```text
//! a_O = a + α n + p_d       q = F + α ẑ × σ − ω² σ       −m = −m_O + n · F + (ẑ × σ) · a + J α       F = F_O + μ a_O
//! ```
//!
//! and where θ and ω change while accelerations of the joint coordinates stay, d changes by n dθ, so that
//!
//! ```text
//! da_O = da + (ẑ × p_d − α d) dθ − 2 ω d dω        d(−m) = n · dF − (d · F + σ · a) dθ + (ẑ × σ) · da
//! ```
//!
//! α itself does not change then, but with the ground: a sum of accelerations of coordinates has no directions.

use super::{Answering, Passing, Pulling};
use crate::mechanics::planar::body::{Base, Pose};
use crate::mechanics::planar::{Acceleration, Body, Planar, PointMass, RigidBody, Rod, Wrench};
use crate::relation::Term;
use crate::relation::planar::Full;
use crate::relation::planar::algebra::{add_scaled, dot, normal};
use crate::scalar::{Jet, Scalar, columns};
use crate::sensitive::{At, Derived, Seeds, Sensitive};
use nalgebra::Vector2;

/// What a body keeps: `A` is 3 where it has a first moment.
#[derive(Clone, Copy, Debug)]
pub struct BodyStore<T, const K: usize, const A: usize> {
    /// Accelerations of I and O.
    inner: Vector2<T>,
    outer: Vector2<T>,
    angular: T,
    rate: T,
    load: Wrench<Jet<T, K>>,
    /// Whether the body's parameters have derivatives.
    seeded: bool,
    /// Whether more than the body's angle and angular velocity has derivatives.
    varied: bool,
    /// Columns of the angle.
    angle: [T; K],
    /// Columns of the acceleration of O.
    x: [T; K],
    y: [T; K],
    /// Columns of the angular acceleration, for parameters.
    turn: [T; K],
    /// Columns of the acceleration of I and of the angular velocity, for a first moment.
    aside: [[T; K]; A],
}

impl<T: Scalar, const K: usize, const A: usize> BodyStore<T, K, A> {
    fn new(body: &impl Body<Jet<T, K>>) -> Self {
        let Base { outboard: [o_x, o_y], moment: [m_x, m_y], inertia, lumped } = body.base();
        let constant = [o_x, o_y, m_x, m_y, inertia, lumped].into_iter().all(Jet::is_constant);
        let (zero, none) = (T::zero(), [T::zero(); K]);
        let still = Vector2::new(zero, zero);
        Self {
            inner: still,
            outer: still,
            angular: zero,
            rate: zero,
            load: Wrench::default(),
            seeded: !constant,
            varied: false,
            angle: none,
            x: none,
            y: none,
            turn: none,
            aside: [none; A],
        }
    }
}

/// A vector of body axes in inertial axes.
#[inline(always)]
fn turned<T: Scalar>([x, y]: [T; 2], direction: Vector2<T>) -> Vector2<T> {
    let (c, s) = (direction.x, direction.y);
    Vector2::new(c.mul_add(x, -(s * y)), s.mul_add(x, c * y))
}

/// Carries a motion over a body.
#[cfg_attr(optimised, inline(always))]
fn vary_body<N: Seeds, T: Scalar, const K: usize, const A: usize>(
    body: &impl Body<T>,
    jets: &impl Body<Jet<T, K>>,
    pose: Pose<T>,
    carried: &mut Passing<T, K>,
    store: &mut BodyStore<T, K, A>,
) {
    let [d, centripetal] = body.arm(pose);
    let Acceleration { linear, angular } = carried.acceleration;
    let rate = carried.rate;
    let per_angle = normal(centripetal) - d * angular;
    let per_rate = d * -(rate + rate);
    carried.acceleration = carried.acceleration.shifted(d, centripetal);
    (store.inner, store.outer) = (linear, carried.acceleration.linear);
    (store.angular, store.rate) = (angular, rate);
    if A == 3 {
        store.aside[0] = carried.x;
        store.aside[1] = carried.y;
        store.aside[2] = carried.spin;
    }
    columns!(K; angle = carried.angle, spin = carried.spin; k:
        let a_x = spin[k].mul_add(per_rate.x, angle[k].mul_add(per_angle.x, x[k])),
        let a_y = spin[k].mul_add(per_rate.y, angle[k].mul_add(per_angle.y, y[k])),
        mut x = carried.x => a_x,
        mut y = carried.y => a_y,
        mut kept_x = store.x => a_x,
        mut kept_y = store.y => a_y,
        mut kept_angle = store.angle => angle[k]
    );
    store.varied = store.seeded || carried.turning;
    if N::PARAMETERS && store.varied {
        let (n, minus_spin2) = (normal(d), -(rate * rate));
        let (base, direction) = (jets.base(), body.direction(pose));
        let [out_x, out_y] = base.outboard;
        columns!(K; out_x = out_x.eps, out_y = out_y.eps, turn = carried.turn; k:
            let longer = turned([out_x[k], out_y[k]], direction),
            let more = add_scaled(add_scaled(n * turn[k], angular, normal(longer)), minus_spin2, longer),
            mut x = carried.x => x[k] + more.x,
            mut y = carried.y => y[k] + more.y
        );
        store.x = carried.x;
        store.y = carried.y;
        store.turn = carried.turn;
    }
}

/// Carries a force over a body.
#[cfg_attr(optimised, inline(always))]
fn gather_body<N: Seeds, T: Scalar, const K: usize, const A: usize>(
    body: &impl Body<T>,
    jets: &impl Body<Jet<T, K>>,
    pose: Pose<T>,
    carried: &mut Pulling<T, K>,
    store: &mut BodyStore<T, K, A>,
) {
    let [d, _] = body.arm(pose);
    let Base { moment, lumped, inertia, .. } = body.base();
    let n = normal(d);
    let (a, angular, minus_spin2) = (store.inner, store.angular, -(store.rate * store.rate));
    let force = add_scaled(carried.force, lumped, store.outer);
    if N::PARAMETERS && store.varied {
        let base = jets.base();
        let outer = store.outer;
        columns!(K; lumped = base.lumped.eps; k:
            mut x = carried.x => lumped[k].mul_add(outer.x, x[k]),
            mut y = carried.y => lumped[k].mul_add(outer.y, y[k])
        );
    }
    let mut per_angle = -dot(d, force);
    carried.force = force;
    if A == 3 {
        let moment = turned(moment, body.direction(pose));
        per_angle -= dot(moment, a);
        carried.force = add_scaled(add_scaled(force, angular, normal(moment)), minus_spin2, moment);
    }
    columns!(K; angle = store.angle, a_x = store.x, a_y = store.y; k:
        let q_x = a_x[k].mul_add(lumped, x[k]),
        let q_y = a_y[k].mul_add(lumped, y[k]),
        mut x = carried.x => q_x,
        mut y = carried.y => q_y,
        mut torque = carried.torque => angle[k].mul_add(per_angle, n.x.mul_add(q_x, n.y.mul_add(q_y, torque[k])))
    );
    if A == 3 {
        let moment = turned(moment, body.direction(pose));
        let normal_moment = normal(moment);
        let per_angle = normal_moment * minus_spin2 - moment * angular;
        let per_rate = moment * -(store.rate + store.rate);
        columns!(K; angle = store.angle, a_x = store.aside[0], a_y = store.aside[1], spin = store.aside[2]; k:
            mut x = carried.x => spin[k].mul_add(per_rate.x, angle[k].mul_add(per_angle.x, x[k])),
            mut y = carried.y => spin[k].mul_add(per_rate.y, angle[k].mul_add(per_angle.y, y[k])),
            mut torque = carried.torque =>
                normal_moment.x.mul_add(a_x[k], normal_moment.y.mul_add(a_y[k], torque[k]))
        );
    }
    if N::PARAMETERS && store.varied {
        let (base, direction) = (jets.base(), body.direction(pose));
        let normal_moment = normal(turned(moment, direction));
        let ([out_x, out_y], of_inertia) = (base.outboard, base.inertia.eps);
        columns!(K; out_x = out_x.eps, out_y = out_y.eps, of_inertia = of_inertia, turn = store.turn; k:
            let longer = normal(turned([out_x[k], out_y[k]], direction)),
            mut torque = carried.torque =>
                dot(longer, force) + of_inertia[k].mul_add(angular, turn[k].mul_add(inertia, torque[k]))
        );
        if A == 3 {
            let [m_x, m_y] = base.moment;
            columns!(K; m_x = m_x.eps, m_y = m_y.eps, turn = store.turn; k:
                let moment = turned([m_x[k], m_y[k]], direction),
                let across = normal(moment),
                let more = add_scaled(add_scaled(normal_moment * turn[k], angular, across), minus_spin2, moment),
                mut x = carried.x => x[k] + more.x,
                mut y = carried.y => y[k] + more.y,
                mut torque = carried.torque => torque[k] + dot(across, a)
            );
        }
    }
    if N::LOADS {
        let Wrench { force, torque } = store.load;
        columns!(K; f_x = force.x.eps, f_y = force.y.eps, m = torque.eps; k:
            mut x = carried.x => x[k] - f_x[k],
            mut y = carried.y => y[k] - f_y[k],
            mut torque = carried.torque => torque[k] - m[k]
        );
        carried.force -= force.map(|x| x.re);
    }
}

macro_rules! bodies {
    ($($Body:ident $aside:literal),*) => {$(
        impl<T: Scalar, const K: usize> Sensitive<Planar<Jet<T, K>>> for $Body<Jet<T, K>> {
            type Plain = $Body<T>;
            type Room = BodyStore<T, K, $aside>;

            fn room(&self) -> Self::Room {
                BodyStore::new(self)
            }
            #[inline(always)]
            fn read((): &(), (): &(), (): &mut (), (): &mut ()) {}
            fn load(&self, on_body: &Wrench<Jet<T, K>>, (): &(), store: &mut Self::Room) {
                store.load = *on_body;
            }
            #[cfg_attr(optimised, inline(always))]
            fn factor<N: Seeds>(
                &self,
                at: At<'_, Planar<Jet<T, K>>, Self>,
                outer: Full<T>,
                store: &mut Self::Room,
            ) -> Full<T> {
                let relation = Body::condense(at.plain, outer, Pose::of(at.posture));
                if !N::LOADS {
                    return relation;
                }
                let Wrench { force, torque } = store.load;
                Wrench { force: force.map(|x| x.re), torque: torque.re }.take_from(relation)
            }
            #[cfg_attr(optimised, inline(always))]
            fn vary<N: Seeds>(
                &self,
                at: At<'_, Planar<Jet<T, K>>, Self>,
                carried: &mut Passing<T, K>,
                store: &mut Self::Room,
                (): &mut (),
            ) {
                vary_body::<N, T, K, $aside>(at.plain, self, Pose::of(at.posture), carried, store);
            }
            #[cfg_attr(optimised, inline(always))]
            fn gather<N: Seeds>(
                &self,
                at: At<'_, Planar<Jet<T, K>>, Self>,
                carried: &mut Pulling<T, K>,
                store: &mut Self::Room,
                (): &mut (),
            ) {
                gather_body::<N, T, K, $aside>(at.plain, self, Pose::of(at.posture), carried, store);
            }
            #[cfg_attr(optimised, inline(always))]
            fn answer(
                &self,
                at: At<'_, Planar<Jet<T, K>>, Self>,
                carried: &mut Answering<T, K>,
                _: &Self::Room,
                (): &mut (),
            ) {
                let n = normal(at.plain.arm(Pose::of(at.posture))[0]);
                columns!(K; angular = carried.angular; k:
                    mut x = carried.x => angular[k].mul_add(n.x, x[k]),
                    mut y = carried.y => angular[k].mul_add(n.y, y[k])
                );
            }
        }
    )*};
}
bodies!(Rod 0, RigidBody 3, PointMass 0);
