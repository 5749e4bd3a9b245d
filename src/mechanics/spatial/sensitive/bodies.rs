//! Derivatives through kept gains in space: what a body does.
//!
//! A body turned by a small vector φ (inertial axes) carries its vectors with it, dd = φ × d. With M = α~ + ω~ ω~, so that a point at d
//! has the acceleration a + M d, and with accelerations of the joint coordinates as they are,
//!
//! ```text
//! da_O = da + M (φ × d) + dω × (ω × d) + ω × (dω × d) + dα × d
//! df = m da_C        dT = d(J α + ω × J ω) + φ × c × f + c × df        f = m a_C
//! d(J α) = J dα + φ × J α − J (φ × α)
//! ```
//!
//! which are products of 3 × 3 matrices, formed once a body, with columns of φ, dω, da and dα.

use super::columns::*;
use super::{Answering, Passing, Pulling};
use crate::mechanics::spatial::body::{Body, Pose};
use crate::mechanics::spatial::{Acceleration, PointMass, RigidBody, Rod, Spatial, Turn, Wrench};
use crate::relation::Term;
use crate::relation::spatial::Full;
use crate::relation::spatial::algebra::{Columns, cross, cross_onto, dot, zero};
use crate::scalar::{Jet, Scalar};
use crate::sensitive::{At, Derived, Seeds, Sensitive};
use nalgebra::Vector3;

/// What a body keeps: its motion on the inboard side, and its load.
#[derive(Clone, Copy, Debug)]
pub struct BodyStore<T, const K: usize> {
    motion: Passing<T, K>,
    load: Wrench<Jet<T, K>>,
    /// Whether the body's parameters have derivatives.
    seeded: bool,
}

impl<T: Scalar, const K: usize> BodyStore<T, K> {
    fn new(body: &impl Body<Jet<T, K>>) -> Self {
        let inertia = body.inertia();
        let vectors = [body.outboard(), inertia.centre].into_iter().chain(inertia.about_centre);
        let constant = vectors.flatten().chain([inertia.mass]).all(Jet::is_constant);
        let turn = Turn { attitude: Columns::identity(), spin: zero() };
        let motion = Passing {
            turn,
            acceleration: Acceleration::zero(),
            angle: none(),
            spin: none(),
            linear: none(),
            angular: none(),
        };
        Self { motion, load: Wrench::default(), seeded: !constant }
    }
}

/// How the acceleration of a point at d follows φ and ω: M = α~ + ω~ ω~, and the matrices of both.
struct Carried<T> {
    per_place: Columns<T>,
    per_angle: Columns<T>,
    per_spin: Columns<T>,
    per_angular: Columns<T>,
}

impl<T: Scalar> Carried<T> {
    /// M d~ = α~ d~ + ω~ ω~ d~ = α~ d~ + (ω × d) ωᵀ − (ω · d) ω~.
    #[cfg_attr(optimised, inline(always))]
    fn of(d: Vector3<T>, spin: Vector3<T>, angular: Vector3<T>) -> Self {
        let (swept, along) = (cross(spin, d), dot(spin, d));
        let across = crossed(angular) + twice_crossed(spin, spin);
        let turned = twice_crossed(angular, d) + outer(swept, spin) + times(crossed(spin), -along);
        Self {
            per_place: across,
            per_angle: minus(turned),
            per_spin: minus(crossed(swept) + twice_crossed(spin, d)),
            per_angular: minus(crossed(d)),
        }
    }
}

/// a bᵀ.
#[inline(always)]
fn outer<T: Scalar>(a: Vector3<T>, b: Vector3<T>) -> Columns<T> {
    Columns { x: a * b.x, y: a * b.y, z: a * b.z }
}

/// a~ b~ = b aᵀ − (a · b) 1.
#[cfg_attr(optimised, inline(always))]
fn twice_crossed<T: Scalar>(a: Vector3<T>, b: Vector3<T>) -> Columns<T> {
    let Columns { x, y, z } = outer(b, a);
    let along = dot(a, b);
    Columns {
        x: Vector3::new(x.x - along, x.y, x.z),
        y: Vector3::new(y.x, y.y - along, y.z),
        z: Vector3::new(z.x, z.y, z.z - along),
    }
}

/// J a~, for a symmetric J: its rows are J's rows × a.
#[inline(always)]
fn times_crossed<T: Scalar>(j: &Columns<T>, a: Vector3<T>) -> Columns<T> {
    Columns { x: j.y * a.z - j.z * a.y, y: j.z * a.x - j.x * a.z, z: j.x * a.y - j.y * a.x }
}

/// a~ M.
#[inline(always)]
fn crossed_times<T: Scalar>(a: Vector3<T>, m: &Columns<T>) -> Columns<T> {
    Columns { x: cross(a, m.x), y: cross(a, m.y), z: cross(a, m.z) }
}

#[cfg_attr(optimised, inline(always))]
fn vary_body<N: Seeds, T: Scalar, const K: usize>(
    body: &impl Body<T>,
    jets: &impl Body<Jet<T, K>>,
    carried: &mut Passing<T, K>,
    store: &mut BodyStore<T, K>,
) {
    store.motion = *carried;
    let Passing { turn, acceleration, .. } = *carried;
    let d = turn.attitude.apply(Vector3::from(body.outboard()));
    let matrices = Carried::of(d, turn.spin, acceleration.angular);
    carried.acceleration.linear = matrices.per_place.apply_onto(d, acceleration.linear);
    apply(&mut carried.linear, &matrices.per_angle, &store.motion.angle);
    apply(&mut carried.linear, &matrices.per_spin, &store.motion.spin);
    apply(&mut carried.linear, &matrices.per_angular, &store.motion.angular);
    if N::PARAMETERS && store.seeded {
        let outboard = Vector3::from(jets.outboard());
        apply(&mut carried.linear, &matrices.per_place.times(&turn.attitude), &parts(&outboard));
    }
}

#[cfg_attr(optimised, inline(always))]
fn gather_body<N: Seeds, T: Scalar, const K: usize>(
    body: &impl Body<T>,
    jets: &impl Body<Jet<T, K>>,
    carried: &mut Pulling<T, K>,
    store: &BodyStore<T, K>,
) {
    let BodyStore { motion: Passing { turn, acceleration, angle, spin, linear, angular }, load, seeded } = store;
    let inertia = body.inertia();
    let mass = inertia.mass;
    let (attitude, w) = (turn.attitude, turn.spin);
    let d = attitude.apply(Vector3::from(body.outboard()));
    let c = attitude.apply(Vector3::from(inertia.centre));
    let matrices = Carried::of(c, w, acceleration.angular);
    let accelerated = matrices.per_place.apply_onto(c, acceleration.linear);
    let (f, beyond) = (accelerated * mass, carried.force);

    // J in inertial axes, A J Aᵀ: (J Aᵀ)ᵀ = A J, as J is symmetric.
    let half = attitude.times(&inertia.matrix());
    let j = attitude.times(&transposed(&half));
    let momentum = j.apply(w);
    let change = j.apply(acceleration.angular);
    let of_momentum = times_crossed(&j, w) + crossed(-momentum);
    let (c_across, d_across) = (crossed(c), crossed(d));
    let torque_per_angle = times_crossed(&j, acceleration.angular)
        + crossed(-change)
        + crossed_times(w, &of_momentum)
        + twice_crossed(beyond, d)
        + twice_crossed(f, c);
    let torque_per_spin = crossed_times(w, &j) + crossed(-momentum);

    apply(&mut carried.torques, &d_across, &{ carried.forces });
    let mut own = none();
    add_scaled_vectors(&mut own, mass, linear);
    apply(&mut own, &times(matrices.per_angle, mass), angle);
    apply(&mut own, &times(matrices.per_spin, mass), spin);
    apply(&mut own, &times(matrices.per_angular, mass), angular);
    if N::PARAMETERS && *seeded {
        let of = jets.inertia();
        let centre = Vector3::from(of.centre);
        add_along(&mut own, accelerated, &of.mass.eps);
        apply(&mut own, &times(matrices.per_place.times(&attitude), mass), &parts(&centre));
        // What lengths do to moments: dd × F.
        let outboard = Vector3::from(jets.outboard());
        apply(&mut carried.torques, &minus(crossed(beyond)).times(&attitude), &parts(&outboard));
        apply(&mut carried.torques, &minus(crossed(f)).times(&attitude), &parts(&centre));
        // dJ α + ω × dJ ω.
        let (u, v) = (attitude.transposed(acceleration.angular), attitude.transposed(w));
        let turning = crossed_times(w, &attitude);
        for (i, [a, b]) in [[u.x, v.x], [u.y, v.y], [u.z, v.z]].into_iter().enumerate() {
            let column = Vector3::from(of.about_centre[i]);
            apply(&mut carried.torques, &(times(attitude, a) + times(turning, b)), &parts(&column));
        }
    }
    add(&mut carried.forces, &own);
    apply(&mut carried.torques, &c_across, &own);
    apply(&mut carried.torques, &torque_per_angle, angle);
    apply(&mut carried.torques, &torque_per_spin, spin);
    apply(&mut carried.torques, &j, angular);
    carried.torque = cross_onto(c, f, cross_onto(d, beyond, carried.torque + change + cross(w, momentum)));
    carried.force = beyond + f;
    if N::LOADS {
        let Wrench { force, torque } = load;
        let minus_one = minus(Columns::identity());
        apply(&mut carried.forces, &minus_one, &parts(force));
        apply(&mut carried.torques, &minus_one, &parts(torque));
        carried.force -= value(force);
        carried.torque -= value(torque);
    }
}

macro_rules! bodies {
    ($($Body:ident),*) => {$(
        impl<T: Scalar, const K: usize> Sensitive<Spatial<Jet<T, K>>> for $Body<Jet<T, K>> {
            type Plain = $Body<T>;
            type Room = BodyStore<T, K>;

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
                at: At<'_, Spatial<Jet<T, K>>, Self>,
                outer: Full<T>,
                store: &mut Self::Room,
            ) -> Full<T> {
                let posture = at.posture;
                let pose = Pose { attitude: *posture.x, turning: posture.y[0], arm: *posture.p, centripetal: *posture.q };
                let relation = Body::condense(at.plain, outer, &pose);
                if !N::LOADS {
                    return relation;
                }
                let Wrench { force, torque } = &store.load;
                Wrench { force: value(force), torque: value(torque) }.take_from(relation)
            }
            #[cfg_attr(optimised, inline(always))]
            fn vary<N: Seeds>(
                &self,
                at: At<'_, Spatial<Jet<T, K>>, Self>,
                carried: &mut Passing<T, K>,
                store: &mut Self::Room,
                (): &mut (),
            ) {
                vary_body::<N, T, K>(at.plain, self, carried, store);
            }
            #[cfg_attr(optimised, inline(always))]
            fn gather<N: Seeds>(
                &self,
                at: At<'_, Spatial<Jet<T, K>>, Self>,
                carried: &mut Pulling<T, K>,
                store: &mut Self::Room,
                (): &mut (),
            ) {
                gather_body::<N, T, K>(at.plain, self, carried, store);
            }
            #[cfg_attr(optimised, inline(always))]
            fn answer(
                &self,
                at: At<'_, Spatial<Jet<T, K>>, Self>,
                carried: &mut Answering<T, K>,
                _: &Self::Room,
                (): &mut (),
            ) {
                apply(&mut carried.linear, &minus(crossed(*at.posture.p)), &carried.angular);
            }
        }
    )*};
}
bodies!(Rod, RigidBody, PointMass);
