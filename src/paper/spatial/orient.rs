//! The scheme in space: what stands in the slot of the angles.

use super::algebra::{
    Matrix, Vector, apply, axes, columns, difference, exponential, from_fn, inverse, logarithm, orthonormal, rows, sum,
    tilde, times, transposed,
};
use super::attitude::Attitude;
use super::body::{External, Rigid, Shape, gyration};
use super::increment::Increment;
use super::joints::{elastic_hinge, linear_hinge, smooth_ball};
use super::objective::objective;
use crate::error::{Error, Fault};
use crate::mechanics::spatial::{BodyMotion, Frame, Inertia, Rotation, Turn};
use crate::paper::expansion::At;
use crate::paper::hinge::Linear;
use crate::paper::link::{Given, Law};
use crate::paper::orient::{Bodies, Expanded, Joints, Side, Spring};
use crate::paper::product::Hinges;
use crate::paper::rule::{Coordinate, Linearization};
use crate::paper::scene::Slots;
use crate::scalar::{Real, Scalar};
use crate::state::TransferMatrix;
use nalgebra::Vector3;
use num_traits::Zero;

/// |cos θ₂| below which angles 1-2-3 are refused.
const SINGULAR: f64 = 1e-4;
/// By how much (rad) an angle may turn in a step where |cos θ₂| is less: beyond, its expansion is off by percents.
const FAST: f64 = 0.5;

/// Where a body's orientation is linearised.
#[derive(Clone, Copy, Debug)]
pub enum Slot<T: Scalar> {
    /// Angles 1-2-3.
    Angles(Attitude<T>),
    /// The rotation vector of the step.
    Vector(Increment<T>),
}

/// What a run keeps of an orientation besides coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Base<T> {
    /// What the coordinates are.
    pub slots: Slots,
    /// A(t_{i−1}), for rotation vectors.
    pub attitude: Matrix<T>,
}

/// A body: what (31) reads, and what loads read.
#[derive(Clone, Copy, Debug)]
pub struct Solid<T> {
    /// About the inboard end.
    pub rigid: Rigid<T>,
    /// About the mass centre.
    pub inertia: Inertia<T>,
}

impl<T: Scalar> Hinges<T, 13, 3, 3> for Slot<T> {
    fn elastic(law: &Law<T, 3>) -> TransferMatrix<T, 13> {
        elastic_hinge(law)
    }
    fn sprung(linear: &[Linear<T>; 3]) -> TransferMatrix<T, 13> {
        linear_hinge(linear.map(Some))
    }
    fn smooth(
        section: &TransferMatrix<T, 13>,
        torques: [Vector<T>; 2],
        inertia: T::Real,
    ) -> Result<TransferMatrix<T, 13>, Error> {
        smooth_ball(section, torques, inertia)
    }
}

impl<T: Scalar> Slot<T> {
    /// Ā.
    fn barred(&self) -> &Matrix<T> {
        match self {
            Self::Angles(at) => &at.barred,
            Self::Vector(at) => &at.barred,
        }
    }
}

/// A of angles.
fn attitude_of<T: Scalar>(base: &Base<T>, coordinates: &Vector<T>) -> Matrix<T> {
    match base.slots {
        Slots::Angles => rows(&Rotation::from_angles(*coordinates).matrix()),
        Slots::RotationVectors => times(&base.attitude, &exponential(*coordinates)),
    }
}

fn angles_near<T: Scalar>(attitude: &Matrix<T>, near: &Vector<T>) -> Vector<T> {
    Rotation::from_matrix(&axes(attitude)).angles_near(*near)
}

impl<T: Scalar> Expanded<T, 3, 3> for Slot<T> {
    type Base = Base<T>;

    fn first(
        at: At,
        base: &Base<T>,
        past: &[[T; 3]; 3],
        step: &[Linearization<T>; 3],
        span: T::Real,
    ) -> (Self, Vector<T>) {
        let [values, rates, accelerations] = [0, 1, 2].map(|k| past.map(|coordinate| coordinate[k]));
        let half = T::Real::of(0.5);
        let ahead = core::array::from_fn(|k| rates[k].scale(span).add_scaled(half * span * span, accelerations[k]));
        let expansion = match (base.slots, at) {
            (Slots::Angles, At::Previous) => Self::Angles(Attitude::printed(values, rates, accelerations, span)),
            (Slots::Angles, _) => {
                let later = core::array::from_fn(|k| rates[k].add_scaled(span, accelerations[k]));
                Self::Angles(Attitude::about(sum(values, ahead), later))
            }
            (Slots::RotationVectors, At::Previous) => {
                Self::Vector(Increment::printed(&base.attitude, rates, accelerations, span))
            }
            (Slots::RotationVectors, _) => Self::again(base, step, &ahead),
        };
        (expansion, ahead)
    }
    fn again(base: &Base<T>, step: &[Linearization<T>; 3], found: &Vector<T>) -> Self {
        let rates = core::array::from_fn(|k| step[k].rate_at(found[k]));
        match base.slots {
            Slots::Angles => Self::Angles(Attitude::about(core::array::from_fn(|k| step[k].past + found[k]), rates)),
            Slots::RotationVectors => {
                let angular = core::array::from_fn(|k| step[k].acceleration_at(found[k]));
                Self::Vector(Increment::about(&base.attitude, *found, rates, angular))
            }
        }
    }
    fn residual(&self, angles: &Vector<T>) -> T::Real {
        match self {
            Self::Angles(at) => difference(*angles, at.angles).iter().fold(T::Real::zero(), |worst, residual| {
                let residual = residual.real().abs();
                if residual <= worst { worst } else { residual }
            }),
            Self::Vector(at) => at.residual(angles),
        }
    }
    fn check(&self) -> Result<(), Fault> {
        let Self::Angles(at) = self else { return Ok(()) };
        let angle = at.angles[1];
        let (_, cosine) = angle.sin_cos();
        if cosine.real().abs() < T::Real::of(SINGULAR) {
            return Err(Fault::SingularAngles { angle: angle.real().as_f64() });
        }
        Ok(())
    }
    const SINGULAR: bool = true;
    fn follow(past: &Vector<T>, found: &Vector<T>) -> Result<(), Fault> {
        let turned = found.iter().fold(T::Real::zero(), |most, angle| most.max(angle.real().abs()));
        let near = past[1].sin_cos().1.real().abs();
        if turned > T::Real::of(FAST) && near < T::Real::of(FAST) {
            return Err(Fault::SingularAngles { angle: (past[1] + found[1]).real().as_f64() });
        }
        Ok(())
    }
    fn psi(&self, point: Vector<T>) -> Matrix<T> {
        match self {
            Self::Angles(at) => at.psi(point),
            Self::Vector(at) => at.psi_of(point),
        }
    }
    fn phi(&self, point: Vector<T>) -> Vector<T> {
        match self {
            Self::Angles(at) => at.phi(point),
            Self::Vector(at) => at.phi(point),
        }
    }
    fn remainder(&self, base: &Base<T>, point: Vector<T>, angles: &Vector<T>) -> Vector<T> {
        match self {
            Self::Angles(at) => at.remainder(point, *angles),
            Self::Vector(at) => at.remainder(&base.attitude, point, *angles),
        }
    }
    fn turned(base: &Base<T>, point: Vector<T>, angles: &Vector<T>) -> Vector<T> {
        apply(&attitude_of(base, angles), point)
    }
    fn retract<M: Copy>(base: &mut Base<T>, angles: &mut [Coordinate<T, M>; 3]) {
        if base.slots == Slots::RotationVectors {
            let psi = angles.each_ref().map(|angle| angle.value);
            base.attitude = orthonormal(&attitude_of(base, &psi));
            angles.iter_mut().for_each(|angle| angle.value = T::zero());
        }
    }
    fn shown(base: &Base<T>, angles: &Vector<T>, near: &Vector<T>) -> Vector<T> {
        match base.slots {
            Slots::Angles => *angles,
            Slots::RotationVectors => angles_near(&attitude_of(base, angles), near),
        }
    }
}

impl<T: Scalar> Bodies<T, 13, 3, 3> for Slot<T> {
    type Rigid = Solid<T>;
    type Motion = BodyMotion<T>;
    type External = External<T>;

    fn arms(solid: &Solid<T>) -> [Vector<T>; 2] {
        [solid.rigid.centre, solid.rigid.outboard]
    }
    fn inertia(solid: &Solid<T>) -> T::Real {
        let size = |v: Vector<T>| v.iter().fold(T::Real::zero(), |size, x| size + x.real().abs());
        let rigid = &solid.rigid;
        super::algebra::size(&rigid.about_inboard) + rigid.mass.real().abs() * size(rigid.centre) * size(rigid.outboard)
    }
    fn is_percussive(solid: &Solid<T>) -> bool {
        // (31) mixes Ā with A, so Ū₃₂ of such a body is only nearly singular: J_I + m r̃_O r̃_C tells.
        let rigid = &solid.rigid;
        let moved = times(&tilde(rigid.outboard), &tilde(rigid.centre));
        let pivot = from_fn(|i, j| rigid.about_inboard[i][j] + rigid.mass * moved[i][j]);
        inverse(&pivot, Self::inertia(solid) * T::Real::EPSILON.powf(T::Real::of(-0.5))).is_none()
    }
    fn matrix(
        &self,
        solid: &Solid<T>,
        step: &Linearization<T>,
        given: &Given<T, 3, 3>,
        external: &External<T>,
    ) -> TransferMatrix<T, 13> {
        let (rigid, chi) = (&solid.rigid, [step.chi1, step.chi3]);
        let gyration = match self {
            Self::Angles(at) => gyration(rigid, at, chi, given),
            Self::Vector(at) => at.gyration(rigid, chi, given),
        };
        let shape = Shape { psi: Self::arms(solid).map(|arm| self.psi(arm)), barred: *self.barred(), gyration };
        shape.matrix(rigid, step.chi1, given, external)
    }
    fn is_finite(external: &External<T>) -> bool {
        external.force.iter().chain(&external.torque).all(|x| x.is_finite())
    }
    fn motion(&self, solid: &Solid<T>, place: Vector<T>, velocity: Vector<T>, turn: [[T; 2]; 3]) -> BodyMotion<T> {
        let barred = self.barred();
        let spin = match self {
            Self::Angles(at) => apply(&at.spin(), turn.map(|[_, rate]| rate)),
            Self::Vector(at) => apply(barred, at.spin),
        };
        let still = Frame::resting(Vector3::from(place));
        let turn = Turn { attitude: axes(barred), spin: Vector3::from(spin) };
        let inboard = Frame { velocity: Vector3::from(velocity), turn, ..still };
        let [to_centre, arm] = Self::arms(solid).map(|arm| Vector3::from(apply(barred, arm)));
        BodyMotion { inboard, arm, to_centre, inertia: solid.inertia }
    }
}

impl<T: Scalar> Joints<T, 3, 3> for Slot<T> {
    type Ahead = Matrix<T>;
    type Frame = Frame<T>;

    fn law(spring: &Spring<T, 3>, elastic: &Vector<T>, sides: [&Side<T, Self, 3>; 2], absolute: bool) -> Law<T, 3> {
        match [&sides[0].expansion, &sides[1].expansion] {
            [Self::Vector(inner), Self::Vector(outer)] => {
                objective(spring, [(inner, &sides[0].step), (outer, &sides[1].step)])
            }
            [Self::Angles(inner), Self::Angles(outer)] => {
                // (34) as printed, along inertial axes.
                let spins = [inner, outer].map(|at| {
                    let spin = at.spin();
                    from_fn(|i, j| spring.damping[i] * spin[i][j])
                });
                let chi3 = sides[1].step[0].chi3;
                let slope = |damper: &Matrix<T>| {
                    from_fn(|i, j| damper[i][j].scale(chi3) + if i == j { spring.stiffness[i] } else { T::zero() })
                };
                let rates =
                    sides.map(|side| side.step.each_ref().map(|step| if absolute { step.chi4() } else { step.rate }));
                let damped = difference(apply(&spins[1], rates[1]), apply(&spins[0], rates[0]));
                let carried: Vector<T> =
                    core::array::from_fn(|k| if absolute { -spring.preload[k] } else { elastic[k] });
                Law { outer: slope(&spins[1]), inner: slope(&spins[0]), offset: sum(damped, carried) }
            }
            _ => Law::smooth([T::zero(); 3]), // a chain has one kind
        }
    }
    fn ground(base: &Base<T>, [before, now]: [&Frame<T>; 2], step: &Linearization<T>) -> Side<T, Self, 3> {
        let [past, coordinates] = Self::grounded(base, [before, now]);
        let attitude = rows(&now.turn.attitude);
        let spin = apply(&transposed(&attitude), now.turn.spin.into());
        let Linearization { chi1, chi3, .. } = *step;
        let side = |rates: Vector<T>, expansion: Self| Side {
            expansion,
            step: core::array::from_fn(|k| Linearization {
                past: past[k],
                chi1,
                chi3,
                acceleration: T::zero(),
                rate: rates[k] - (coordinates[k] - past[k]).scale(chi3),
            }),
        };
        match base.slots {
            Slots::Angles => {
                let still = Attitude::about(coordinates, [T::zero(); 3]);
                let rates = still.rates_of(spin);
                side(rates, Self::Angles(Attitude::about(coordinates, rates)))
            }
            Slots::RotationVectors => {
                let from = rows(&before.turn.attitude);
                side(spin, Self::Vector(Increment::about(&from, coordinates, spin, [T::zero(); 3])))
            }
        }
    }
    fn grounded(base: &Base<T>, [before, now]: [&Frame<T>; 2]) -> [Vector<T>; 2] {
        let [from, to] = [before, now].map(|frame| rows(&frame.turn.attitude));
        match base.slots {
            Slots::Angles => {
                let past = angles_near(&from, &[T::zero(); 3]);
                [past, angles_near(&to, &past)]
            }
            Slots::RotationVectors => [[T::zero(); 3], logarithm(&times(&transposed(&from), &to))],
        }
    }
    fn rigid(ahead: &Matrix<T>) -> (Option<Matrix<T>>, Vector<T>) {
        // ψ_O = Rᵀψ_I; angles are alike where R is one, and refused where it is not.
        (Some(transposed(ahead)), [T::zero(); 3])
    }
    fn clamped(base: &Base<T>, past: &Vector<T>, ahead: &Matrix<T>, ground: &Frame<T>) -> Vector<T> {
        let attitude = times(&rows(&ground.turn.attitude), ahead);
        match base.slots {
            Slots::Angles => angles_near(&attitude, past),
            Slots::RotationVectors => logarithm(&times(&transposed(&base.attitude), &attitude)),
        }
    }
    fn place(frame: &Frame<T>) -> Vector<T> {
        frame.place.into()
    }
    fn angles(frame: &Frame<T>, near: &Vector<T>) -> Vector<T> {
        angles_near(&rows(&frame.turn.attitude), near)
    }
}

/// θ̈ of angles whose θ̇ and ω̇ (body axes) are known.
pub fn angle_accelerations<T: Scalar>(at: &Attitude<T>, rates: Vector<T>, angular: Vector<T>) -> Vector<T> {
    let [v1, v2, v3] = rates;
    let [t12, t23, t31] = at.barred_bends;
    let bend = columns([t12, t23, t31]);
    at.rates_of(difference(angular, apply(&bend, [v1 * v2, v2 * v3, v3 * v1])))
}
