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

use super::body::{Body, Pose};
use super::loads::Effort;
use super::{Acceleration, Frame, PointMass, RigidBody, Rod, Spatial, Station, Turn, Wrench};
use crate::element::{Load, Space};
use crate::relation::Term;
use crate::relation::space::Full;
use crate::relation::space::algebra::{Columns, cross, cross_onto, dot, zero};
use crate::scalar::{Jet, Scalar, columns};
use crate::sensitive::{At, Seeds, Sensitive, Varied};
use nalgebra::Vector3;

/// Columns of a vector.
pub(super) type Vectors<T, const K: usize> = [[T; K]; 3];

/// No columns.
pub(super) fn none<T: Scalar, const K: usize>() -> Vectors<T, K> {
    [[T::zero(); K]; 3]
}

/// Derivatives of a vector.
#[inline(always)]
pub(super) fn parts<T: Scalar, const K: usize>(v: &Vector3<Jet<T, K>>) -> Vectors<T, K> {
    [v.x.eps, v.y.eps, v.z.eps]
}

/// Value of a vector.
#[inline(always)]
pub(super) fn value<T: Scalar, const K: usize>(v: &Vector3<Jet<T, K>>) -> Vector3<T> {
    Vector3::new(v.x.re, v.y.re, v.z.re)
}

/// v~, so that v~ u = v × u.
#[inline(always)]
pub(super) fn crossed<T: Scalar>(v: Vector3<T>) -> Columns<T> {
    let o = T::zero();
    Columns { x: Vector3::new(o, v.z, -v.y), y: Vector3::new(-v.z, o, v.x), z: Vector3::new(v.y, -v.x, o) }
}

#[inline(always)]
fn minus<T: Scalar>(m: Columns<T>) -> Columns<T> {
    Columns { x: -m.x, y: -m.y, z: -m.z }
}

#[inline(always)]
fn times<T: Scalar>(m: Columns<T>, factor: T) -> Columns<T> {
    Columns { x: m.x * factor, y: m.y * factor, z: m.z * factor }
}

/// `sum += v`.
#[inline(always)]
pub(super) fn add<T: Scalar, const K: usize>(sum: &mut Vectors<T, K>, v: &Vectors<T, K>) {
    let [x, y, z] = sum;
    columns!(K; a = v[0], b = v[1], c = v[2]; k:
        mut x = *x => x[k] + a[k],
        mut y = *y => y[k] + b[k],
        mut z = *z => z[k] + c[k]
    );
}

/// `sum += n f` for columns of a number f.
#[inline(always)]
pub(super) fn add_along<T: Scalar, const K: usize>(sum: &mut Vectors<T, K>, n: Vector3<T>, f: &[T; K]) {
    let [x, y, z] = sum;
    columns!(K; f = *f; k:
        mut x = *x => f[k].mul_add(n.x, x[k]),
        mut y = *y => f[k].mul_add(n.y, y[k]),
        mut z = *z => f[k].mul_add(n.z, z[k])
    );
}

/// `sum += M v`.
#[inline(always)]
pub(super) fn apply<T: Scalar, const K: usize>(sum: &mut Vectors<T, K>, m: &Columns<T>, v: &Vectors<T, K>) {
    let [x, y, z] = sum;
    let Columns { x: p, y: q, z: r } = *m;
    columns!(K; a = v[0], b = v[1], c = v[2]; k:
        mut x = *x => a[k].mul_add(p.x, b[k].mul_add(q.x, c[k].mul_add(r.x, x[k]))),
        mut y = *y => a[k].mul_add(p.y, b[k].mul_add(q.y, c[k].mul_add(r.y, y[k]))),
        mut z = *z => a[k].mul_add(p.z, b[k].mul_add(q.z, c[k].mul_add(r.z, z[k])))
    );
}

/// `sum += n · v`.
#[inline(always)]
pub(super) fn project<T: Scalar, const K: usize>(sum: &mut [T; K], n: Vector3<T>, v: &Vectors<T, K>) {
    columns!(K; a = v[0], b = v[1], c = v[2]; k:
        mut sum = *sum => a[k].mul_add(n.x, b[k].mul_add(n.y, c[k].mul_add(n.z, sum[k])))
    );
}

/// A motion on its way outward.
#[derive(Clone, Copy, Debug)]
pub struct Passing<T, const K: usize> {
    /// Orientation of the body on the inboard side.
    pub(super) turn: Turn<T>,
    /// Acceleration of the station, in a frame that falls freely, and of that body.
    pub(super) acceleration: Acceleration<T>,
    /// Columns of φ.
    pub(super) angle: Vectors<T, K>,
    /// Columns of ω.
    pub(super) spin: Vectors<T, K>,
    /// Columns of the accelerations.
    pub(super) linear: Vectors<T, K>,
    pub(super) angular: Vectors<T, K>,
}

/// A force on its way inward.
#[derive(Clone, Copy, Debug)]
pub struct Pulling<T, const K: usize> {
    /// Force (N) and torque (N·m) on the outboard part.
    pub(super) force: Vector3<T>,
    pub(super) torque: Vector3<T>,
    /// Their columns.
    pub(super) forces: Vectors<T, K>,
    pub(super) torques: Vectors<T, K>,
}

/// Columns of an acceleration on their way outward.
#[derive(Clone, Copy, Debug)]
pub struct Answering<T, const K: usize> {
    pub(super) linear: Vectors<T, K>,
    pub(super) angular: Vectors<T, K>,
}

impl<T: Scalar, const K: usize> Varied for Spatial<Jet<T, K>> {
    type Number = T;
    type Plain = Spatial<T>;
    type Relation = Full<T>;
    type Outward = Passing<T, K>;
    type Inward = Pulling<T, K>;
    type Response = Answering<T, K>;
    type BodyLoad = Wrench<Jet<T, K>>;
    type JointLoad = Effort<Jet<T, K>>;

    fn plain(number: Jet<T, K>) -> T {
        number.re
    }
    fn is_constant(number: Jet<T, K>) -> bool {
        number.eps.iter().all(|x| *x == T::zero())
    }
    fn seeded(number: Jet<T, K>, k: usize) -> Jet<T, K> {
        Jet::seed(number.re, k)
    }
    #[inline(always)]
    fn ground(frame: &Frame<Jet<T, K>>, gravity: Vector3<Jet<T, K>>) -> Passing<T, K> {
        let Acceleration { linear, angular } = Self::falling(frame, gravity);
        Passing {
            turn: Self::plain_turn(frame),
            acceleration: Acceleration { linear: value(&linear), angular: value(&angular) },
            angle: turned(&frame.turn.attitude),
            spin: parts(&frame.turn.spin),
            linear: parts(&linear),
            angular: parts(&angular),
        }
    }
    fn plain_turn(frame: &Frame<Jet<T, K>>) -> Turn<T> {
        let Columns { x, y, z } = frame.turn.attitude;
        Turn { attitude: Columns { x: value(&x), y: value(&y), z: value(&z) }, spin: value(&frame.turn.spin) }
    }
    fn ground_turns(_: &Frame<Jet<T, K>>) -> bool {
        false // it is carried in any case
    }
    #[inline(always)]
    fn nothing() -> Full<T> {
        Full::massless()
    }
    #[inline(always)]
    fn no_pull() -> Pulling<T, K> {
        Pulling { force: zero(), torque: zero(), forces: none(), torques: none() }
    }
    #[inline(always)]
    fn stillness() -> Answering<T, K> {
        Answering { linear: none(), angular: none() }
    }
    fn no_load() -> (Wrench<Jet<T, K>>, Effort<Jet<T, K>>) {
        (Wrench::default(), Effort::default())
    }
    #[inline(always)]
    fn body_load(load: impl Load<Self>) -> Wrench<Jet<T, K>> {
        let mut station = Station::massless(Frame::resting(zero()));
        load.act(&mut station);
        Wrench { force: -station.inertia_force, torque: -station.inertia_torque }
    }
    #[inline(always)]
    fn join(a: Full<T>, b: Full<T>) -> Full<T> {
        Full {
            linear: a.linear.plus(b.linear),
            coupling: a.coupling.plus(b.coupling),
            angular: a.angular.plus(b.angular),
            force: a.force + b.force,
            torque: a.torque + b.torque,
            cuts: a.cuts,
        }
    }
    #[inline(always)]
    fn pull(chain: &mut Pulling<T, K>, arm: &Pulling<T, K>) {
        chain.force += arm.force;
        chain.torque += arm.torque;
        add(&mut chain.forces, &arm.forces);
        add(&mut chain.torques, &arm.torques);
    }
}

impl<T: Scalar, const K: usize> crate::sensitive::Effort<Spatial<Jet<T, K>>> for Effort<Jet<T, K>> {
    fn effort(self) -> Self {
        self
    }
}

/// Columns of the φ by which axes turn, ½ Σ r × dr over the axes r.
pub(super) fn turned<T: Scalar, const K: usize>(axes: &Columns<Jet<T, K>>) -> Vectors<T, K> {
    let mut angle = none();
    for axis in [&axes.x, &axes.y, &axes.z] {
        apply(&mut angle, &crossed(value(axis) * T::literal(0.5)), &parts(axis));
    }
    angle
}

/// What a body keeps: its motion on the inboard side, and its load.
#[derive(Clone, Copy, Debug)]
pub struct BodyStore<T, const K: usize> {
    motion: Passing<T, K>,
    load: Wrench<Jet<T, K>>,
    /// Whether its parameters have derivatives.
    seeded: bool,
}

impl<T: Scalar, const K: usize> BodyStore<T, K> {
    fn new(body: &impl Body<Jet<T, K>>) -> Self {
        let inertia = body.inertia();
        let vectors = [body.outboard(), inertia.centre].into_iter().chain(inertia.about_centre);
        let constant = vectors.flatten().chain([inertia.mass]).all(Spatial::is_constant);
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
    #[inline(always)]
    fn of(d: Vector3<T>, spin: Vector3<T>, angular: Vector3<T>) -> Self {
        let (swept, along) = (cross(spin, d), dot(spin, d));
        let across = crossed(angular).plus(twice_crossed(spin, spin));
        let turned = twice_crossed(angular, d).plus(outer(swept, spin)).plus(times(crossed(spin), -along));
        Self {
            per_place: across,
            per_angle: minus(turned),
            per_spin: minus(crossed(swept).plus(twice_crossed(spin, d))),
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
#[inline(always)]
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

#[inline(always)]
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

#[inline(always)]
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
    let transpose = |m: &Columns<T>| Columns {
        x: Vector3::new(m.x.x, m.y.x, m.z.x),
        y: Vector3::new(m.x.y, m.y.y, m.z.y),
        z: Vector3::new(m.x.z, m.y.z, m.z.z),
    };
    let j = attitude.times(&transpose(&half));
    let momentum = j.apply(w);
    let change = j.apply(acceleration.angular);
    let of_momentum = times_crossed(&j, w).plus(crossed(-momentum));
    let (c_across, d_across) = (crossed(c), crossed(d));
    let torque_per_angle = times_crossed(&j, acceleration.angular)
        .plus(crossed(-change))
        .plus(crossed_times(w, &of_momentum))
        .plus(twice_crossed(beyond, d))
        .plus(twice_crossed(f, c));
    let torque_per_spin = crossed_times(w, &j).plus(crossed(-momentum));

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
            apply(&mut carried.torques, &times(attitude, a).plus(times(turning, b)), &parts(&column));
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

/// `sum += factor · v`.
#[inline(always)]
pub(super) fn add_scaled_vectors<T: Scalar, const K: usize>(sum: &mut Vectors<T, K>, factor: T, v: &Vectors<T, K>) {
    let [x, y, z] = sum;
    columns!(K; a = v[0], b = v[1], c = v[2]; k:
        mut x = *x => a[k].mul_add(factor, x[k]),
        mut y = *y => b[k].mul_add(factor, y[k]),
        mut z = *z => c[k].mul_add(factor, z[k])
    );
}

macro_rules! bodies {
    ($($Body:ident),*) => {$(
        impl<T: Scalar, const K: usize> Sensitive<Spatial<Jet<T, K>>> for $Body<Jet<T, K>> {
            type Plain = $Body<T>;
            type Store = BodyStore<T, K>;

            fn store(&self) -> Self::Store {
                BodyStore::new(self)
            }
            #[inline(always)]
            fn read((): &(), (): &(), (): &mut (), (): &mut ()) {}
            fn load(&self, on_body: &Wrench<Jet<T, K>>, (): &(), store: &mut Self::Store) {
                store.load = *on_body;
            }
            #[inline(always)]
            fn factor<N: Seeds>(
                &self,
                at: At<'_, Spatial<Jet<T, K>>, Self>,
                outer: Full<T>,
                store: &mut Self::Store,
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
            #[inline(always)]
            fn vary<N: Seeds>(
                &self,
                at: At<'_, Spatial<Jet<T, K>>, Self>,
                carried: &mut Passing<T, K>,
                store: &mut Self::Store,
                (): &mut (),
            ) {
                vary_body::<N, T, K>(at.plain, self, carried, store);
            }
            #[inline(always)]
            fn gather<N: Seeds>(
                &self,
                at: At<'_, Spatial<Jet<T, K>>, Self>,
                carried: &mut Pulling<T, K>,
                store: &mut Self::Store,
                (): &mut (),
            ) {
                gather_body::<N, T, K>(at.plain, self, carried, store);
            }
            #[inline(always)]
            fn answer(
                &self,
                at: At<'_, Spatial<Jet<T, K>>, Self>,
                carried: &mut Answering<T, K>,
                _: &Self::Store,
                (): &mut (),
            ) {
                apply(&mut carried.linear, &minus(crossed(*at.posture.p)), &carried.angular);
            }
        }
    )*};
}
bodies!(Rod, RigidBody, PointMass);
