//! Starts that are assembled: where a start closes for whatever a scene is made of.
//!
//! Of a start q, v that is closed, [`assembled`](crate::system::System::assembled) makes q ⊕ x and v + y with M x = Γᵀκ, M y = Γᵀκ′, which
//! meet φ(q ⊕ x, p) = 0 and Γ (v + y) = 0: nothing there, and to first order by all parameters p what the implicit function theorem says
//!
//! ```text
//! x̄ ↦ q̄ = x̄ − Γᵀν        p̄ = −ν φ_p        ν = (Γ M⁻¹ Γᵀ)⁻¹ Γ M⁻¹ x̄
//! ```
//!
//! and likewise of rates. It is the [projection](super::projection) at the end of a step, at the start, by the gains of a sweep there.

use super::record::Record;
use super::rules::Staged;
use super::steps::Steps;
use super::{Backward, GradientOf};
use crate::adjoint::{BodyLaw, Burdened, Reversed, Reversible, ReversibleTip};
use crate::element::{Element, Level, RealOf, Unloaded};
use crate::ends::Root;
use crate::error::{Error, Fault};
use crate::mirror::{Rate, let_all_go};
use crate::scalar::{Real, Scalar};
use crate::system::{Elements, MotionOf, Runs, System};
use crate::walks::complete::complete;
use num_traits::{One, Zero};

impl<S, R, C, P, M, L> Backward<'_, S, R, C, P, M, L>
where
    S: Reversed,
    R: Root<S>,
    C: Element<S>,
    P: ReversibleTip<S>,
    M: Staged,
    L: BodyLaw<S>,
    Elements<S, R, C>: Reversible<S, P::Closures, M::Springs<S::Scalar>> + Burdened<S, L, P::Closures>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
{
    /// Runs whose starts are assembled: gradients take a start, which must be closed, for what [`assembled`](System::assembled) makes of itself.
    /// Without this initial coordinates stand alone, and a length that changes opens a loop, which the first step closes; with it the start closes as
    /// the length changes, by the least change as measured by the inertia of the scene. Derivatives by initial positions and rates are then
    /// those by a guess, of which only what does not open anything counts.
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::scalar::{Jet, Scalar};
    /// /// A four-bar linkage with a crank of a length: over plain numbers, and over jets.
    /// macro_rules! four_bar {
    ///     ($crank:expr, $number:expr) => {{
    ///         let [crank, coupler, rocker] = [$crank, $number(1.2), $number(0.9)].map(|length| Rod::uniform(length, $number(1.0)));
    ///         let tip = Pinned::at($number(1.0), $number(0.0));
    ///         System::new(Pinned::at($number(0.0), $number(0.0)), (crank, Pin, coupler, Pin, rocker), tip)?.with_gravity($number(9.81))
    ///     }};
    /// }
    /// let scene = four_bar!(0.5, |x: f64| x);
    /// let start = scene.assembled(scene.at_rest(&[1.0, 0.3, -2.0])?, &Unloaded)?;
    /// let (mut backward, mut states) = (scene.backward(Rk4).assembled(), [start; 11]);
    /// backward.run(&start, 0.01, 10, &[], &mut states)?;
    /// let gradient = backward.gradient(&[], &states, &mut [], |step, _, by| {
    ///     if step == 10 { by.add(&[1.0, 0.0, 0.0], &[0.0; 3]) } else { Ok(()) }
    /// })?;
    /// let [by_crank] = gradient.along(&four_bar!(Jet::<f64, 1>::seed(0.5, 0), Jet::of))?;
    /// # let end_of = |crank: f64| -> Result<f64, catena::Error> {
    /// #     let scene = four_bar!(crank, |x: f64| x);
    /// #     let start = scene.assembled(start, &Unloaded)?;
    /// #     Ok(scene.simulate(start, Rk4::step(0.01), 0.1, |_| ())?.motion.coordinates()[0])
    /// # };
    /// # assert!((by_crank - (end_of(0.5001)? - end_of(0.4999)?) / 2e-4).abs() < 1e-6);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// From afar a guess is led to a start by corrections that are no part of this: assemble first, or make start and scene over jets
    /// ([`Gradient::along_start`](crate::sensitivity::Gradient::along_start)), which also knows coordinates that are [held](System::assembled_holding).
    ///
    /// Gradients of such runs are refused where the start is not closed: [`Fault::NotClosed`]; and where joints are coupled but nothing is closed. Steps [linearised](Self::linearised_step) and
    /// scenes with nothing to be closed are as without.
    #[must_use]
    pub fn assembled(mut self) -> Self {
        self.assembled = true;
        self
    }

    /// Pulls the costate of the start back through its assembly, if it is assembled, and completes the gradient.
    pub(super) fn finish(
        &mut self,
        start: &MotionOf<S, R, C, P>,
        gradient: &mut GradientOf<S, R, C, L>,
    ) -> Result<(), Error> {
        if self.assembled && System::<S, R, C, P>::CLOSED > 0 {
            self.pull_back_assembly(start, gradient)?;
        } else if self.assembled && Steps::<S, R, C, P, M, L>::TIED {
            let what = "the gradient through a start that is assembled to have joints coupled, where nothing is held or closed: make it over jets, `along_start`";
            return Err(Error::new(Fault::Unsupported { what }).at_time(start.time.as_f64()));
        }
        complete::<S, _>(self.steps.scene.elements(), &mut gradient.bodies);
        self.steps.loads.law.known(&gradient.law).map_err(Error::new)?;
        let mut finite = true;
        let mut meet = |x: S::Scalar| finite &= x.is_finite();
        gradient.start.position.visit(&mut meet);
        gradient.start.rate.visit(&mut meet);
        if finite { Ok(()) } else { Err(Error::new(Fault::NotFinite { parameter: "gradient" })) }
    }

    fn pull_back_assembly(
        &mut self,
        start: &MotionOf<S, R, C, P>,
        gradient: &mut GradientOf<S, R, C, L>,
    ) -> Result<(), Error> {
        let scene = self.steps.scene;
        let mut size = RealOf::<S>::one();
        start.rate.visit(&mut |x| size = size.max(x.real().abs()));
        for (level, size) in [(Level::Place, RealOf::<S>::one()), (Level::Velocity, size)] {
            let (residual, place) = scene.largest_residual(start, level);
            if !residual.is_finite() || residual > System::<S, R, C, P>::tolerances().0 * size {
                let fault = Fault::NotClosed { residual: residual.as_f64() };
                return Err(Error::new(fault).at(place).at_time(start.time.as_f64()));
            }
        }
        let Record { stages, accelerations, projection } = &mut self.record;
        let ([stage, ..], [slope, ..], Some(projection)) = (stages.as_mut(), accelerations.as_mut(), projection) else {
            return Ok(());
        };
        // Springs do not enter a step of no size.
        let (none, time) = (RealOf::<S>::zero(), start.time);
        stage.position.clone_from(&start.position);
        stage.rate.set(&start.rate);
        // As starts are assembled, with joints that stick or rest let go.
        let_all_go(&mut stage.position, &mut stage.rate, &start.acceleration);
        projection.places[0].clone_from(&stage.position);
        projection.rates[0].set(&start.rate);
        self.steps.sweep(None, None, self.steps.rule.springs::<S::Scalar>(0, none), time, stage, slope);
        self.steps.project(time, stage, projection);
        self.steps.pull_back_projection((time, none), (stage, &stage.position, None), projection, gradient);
        if let Some(room) = &self.steps.room {
            gradient.start.position.add(&room.of_stage);
        }
        Ok(())
    }
}
