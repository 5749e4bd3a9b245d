//! Scenes over jets whose sweeps go through the gains that a sweep over values keeps.

use crate::element::{Coordinates, Element, Load, Loading, Posture, RealOf, Space, Visit};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::lift::Lift;
use crate::loading::{EffortOf, couples};
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::relation::{Additive, Open, Wrench, WrenchOf};
use crate::sensitive::{At, Columns, Derived, Effort, RelationOf, Seeds, Sensitive, Varied};
use crate::shape::{Body, PerAxes, PerBody, PerJoint, Positions, Rates, Shape};
use crate::space::FrameOf;
use crate::system::{Dynamics, Elements, MotionOf, PositionOf, RateOf, Runs, System};
use crate::visit::survey;
use crate::walks::exert::Exert;
use crate::walks::fits::fits;
use crate::walks::sines::sines;
use crate::walks::size::sizes;
use crate::walks::spread;
use crate::walks::travel::travel;

/// The elements of a scene over plain numbers.
type Plain<S, E> = <E as Sensitive<S>>::Plain;
/// One `X` for each set of axes in them.
type Axes<S, E, X> = <Plain<S, E> as Shape<<S as Varied>::Plain>>::Store<PerAxes<X>>;

/// A scene over jets whose sweeps go through kept gains.
pub struct Sensitivity<'s, S: Varied, R: Root<S>, C: Element<S>, P>
where
    Elements<S, R, C>: Sensitive<S>,
{
    scene: &'s System<S, R, C, P>,
    plain: Plain<S, Elements<S, R, C>>,
    /// Whether any parameter has derivatives.
    seeded: bool,
}

/// Room for sweeps through kept gains.
pub struct SensitiveWorkspace<S: Varied, E: Sensitive<S>> {
    position: <E::Plain as Element<S::Plain>>::Position,
    rate: <E::Plain as Element<S::Plain>>::Rate,
    sizes: Axes<S, E, <S::Plain as Space>::Size>,
    x: Axes<S, E, <S::Plain as Space>::X>,
    y: Axes<S, E, <S::Plain as Space>::Y>,
    p: Axes<S, E, <S::Plain as Space>::P>,
    q: Axes<S, E, <S::Plain as Space>::Q>,
    store: E::Room,
    on_bodies: E::Store<PerBody<WrenchOf<S>>>,
    in_joints: E::Store<PerJoint<EffortOf<S>>>,
}

impl<S: Varied, E: Sensitive<S>> SensitiveWorkspace<S, E> {
    fn new(elements: &E, plain: &E::Plain) -> Self {
        let (x, y, p, q) = S::Plain::blank();
        let (on_body, in_joint) = (Wrench::none(), Additive::null());
        Self {
            position: plain.store::<Positions>(()),
            rate: plain.store::<Rates>(()),
            sizes: sizes(plain),
            x: plain.store::<PerAxes<_>>(x),
            y: plain.store::<PerAxes<_>>(y),
            p: plain.store::<PerAxes<_>>(p),
            q: plain.store::<PerAxes<_>>(q),
            store: elements.room(),
            on_bodies: elements.store::<PerBody<_>>(on_body),
            in_joints: elements.store::<PerJoint<_>>(in_joint),
        }
    }
}

impl<S: Varied, R: Root<S>, C: Element<S>, P: Tip<S, Closures = Open>> System<S, R, C, P>
where
    Elements<S, R, C>: Sensitive<S> + Lift<S::Scalar, S::Number, Over = <Elements<S, R, C> as Sensitive<S>>::Plain>,
{
    /// The scene with sweeps that go through kept gains.
    pub fn sensitivity(&self) -> Sensitivity<'_, S, R, C, P> {
        let mut seeded = false;
        let mut number = |x: S::Scalar| {
            seeded |= !x.is_constant();
            x.plain()
        };
        let plain = self.elements().lift(&mut number);
        S::lift_vector(self.gravity(), &mut number);
        Sensitivity { scene: self, plain, seeded }
    }
}

impl<S: Varied, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// This motion with seeds in its state: the numbers of the state are the displacements of the joint coordinates, root to tip, and
    /// after these their rates; number `first` is seed 0, the one after it seed 1, as far as there are seeds. Derivatives that it had are
    /// lost.
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::scalar::{Jet, Scalar};
    /// let rod = Rod::uniform(1.0, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81).lift(Jet::<f64, 4>::of);
    /// let start = pendulum.with_seeds(pendulum.at_rest(&[Jet::of(-1.0), Jet::of(-0.5)])?, 0);
    /// assert_eq!(start.rate().1.1.eps, [0.0, 0.0, 0.0, 1.0]);
    /// # Ok::<(), catena::Error>(())
    /// ```
    #[must_use]
    pub fn with_seeds(&self, mut motion: MotionOf<S, R, C, P>, first: usize) -> MotionOf<S, R, C, P> {
        let mut number = 0;
        let mut seed = |x: S::Scalar| {
            let k = usize::wrapping_sub(number, first); // before the first it is beyond the last
            number += 1;
            x.seeded(k)
        };
        motion.position.replace(&mut |x| x.seeded(usize::MAX));
        let mut step = motion.rate.clone();
        step.replace(&mut |_| seed(num_traits::Zero::zero()));
        motion.position.displace(&step);
        motion.rate.replace(&mut seed);
        motion
    }
}

impl<S, R, C, P> Sensitivity<'_, S, R, C, P>
where
    S: Varied,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S, Closures = Open>,
    Elements<S, R, C>: Sensitive<S>,
{
    /// Accelerations of a motion and their derivatives.
    ///
    /// # Errors
    /// As [`System::accelerate`].
    pub fn accelerate<L>(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        loads: &L,
        workspace: &mut <Self as Dynamics<L>>::Workspace,
    ) -> Result<(), Error>
    where
        L: Loading<S, InJoint: Effort<S>>,
        System<S, R, C, P>: Runs<L, S, R, C, P>,
    {
        let elements = self.scene.elements();
        let Motion { time, position, rate, acceleration, .. } = motion;
        if !(fits(elements, position, rate) && fits(elements, position, acceleration)) {
            return Err(Error::new(Fault::Shape));
        }
        self.admits(loads)?;
        self.accelerations(*time, position, rate, loads, workspace, acceleration);
        if motion.is_finite() { Ok(()) } else { Err(self.diagnose(motion, loads, workspace)) }
    }

    /// The walks.
    #[cfg_attr(optimised, inline(always))]
    fn walk<N: Seeds>(
        &self,
        ground: &FrameOf<S>,
        (position, rate): (&PositionOf<S, R, C>, &RateOf<S, R, C>),
        workspace: &mut SensitiveWorkspace<S, Elements<S, R, C>>,
        acceleration: &mut RateOf<S, R, C>,
    ) {
        let elements = self.scene.elements();
        let SensitiveWorkspace { x, y, p, q, store, .. } = workspace;
        let at = At { plain: &self.plain, posture: Posture { x, y, p, q }, position, rate };
        elements.factor::<N>(at, RelationOf::<S>::massless(), store);
        elements.vary::<N>(at, &mut S::ground(ground, self.scene.gravity()), store, acceleration);
        elements.gather::<N>(at, &mut S::no_pull(), store, acceleration);
        elements.answer(at, &mut S::stillness(), store, acceleration);
    }
}

/// Evaluates loads as wrenches and efforts.
struct Loads<'a, S: Varied, L: Loading<S>>(Exert<'a, S, L>);

impl<S: Varied, L: Loading<S, InJoint: Effort<S>>> Visit<S> for Loads<'_, S, L> {
    type OnBody = WrenchOf<S>;
    type InJoint = EffortOf<S>;

    fn body(&mut self, motion: &S::BodyMotion) -> WrenchOf<S> {
        self.0.body(motion).wrench()
    }
    fn body_with<B: Body<S>>(&mut self, motion: &S::BodyMotion) -> WrenchOf<S> {
        self.0.body_with::<B>(motion).wrench()
    }
    fn joint(&mut self, motion: &S::JointMotion) -> EffortOf<S> {
        self.0.joint(motion).effort()
    }
}

impl<S, R, C, P, L> Dynamics<L> for Sensitivity<'_, S, R, C, P>
where
    S: Varied,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S, Closures = Open>,
    L: Loading<S, InJoint: Effort<S>>,
    Elements<S, R, C>: Sensitive<S>,
    System<S, R, C, P>: Runs<L, S, R, C, P>,
{
    type Space = S;
    type Scalar = S::Scalar;
    type Position = PositionOf<S, R, C>;
    type Rate = RateOf<S, R, C>;
    type Closures = Open;
    type Workspace = SensitiveWorkspace<S, Elements<S, R, C>>;

    fn workspace(&self) -> Self::Workspace {
        SensitiveWorkspace::new(self.scene.elements(), &self.plain)
    }

    fn still(&self) -> MotionOf<S, R, C, P> {
        self.scene.motion()
    }

    fn admits(&self, loads: &L) -> Result<(), Error> {
        self.scene.admits(loads)
    }

    #[inline(never)]
    fn accelerations(
        &self,
        time: RealOf<S>,
        position: &Self::Position,
        rate: &Self::Rate,
        loads: &L,
        workspace: &mut Self::Workspace,
        acceleration: &mut Self::Rate,
    ) {
        let mut swept = |loads: &L, _: bool, acceleration: &mut Self::Rate| {
            let elements = self.scene.elements();
            let ground = self.scene.ground(time);
            if L::ON {
                let SensitiveWorkspace { on_bodies, in_joints, store, .. } = workspace;
                if const { spread::is_listed::<S, Elements<S, R, C>, L>() } {
                    spread::loads(elements, loads, (L::OnBody::wrench, L::InJoint::effort), on_bodies, in_joints);
                } else {
                    let motion = Coordinates { position, rate, acceleration };
                    let seen = survey(elements, ground, motion, loads);
                    travel(elements, ground, motion, Loads(Exert::new(loads, time, &seen)), on_bodies, in_joints);
                }
                elements.load(on_bodies, in_joints, store);
            }
            {
                let SensitiveWorkspace { position: plain_position, rate: plain_rate, sizes, x, y, p, q, .. } =
                    workspace;
                Elements::<S, R, C>::read(position, rate, plain_position, plain_rate);
                sines(&self.plain, plain_position, x);
                self.plain.pose(plain_position, plain_rate, S::plain_turn(&ground), sizes, x, y, p, q);
            }
            let at = (position, rate);
            match (self.seeded || S::ground_turns(&ground), L::ON) {
                (false, false) => self.walk::<Columns<false, false>>(&ground, at, workspace, acceleration),
                (false, true) => self.walk::<Columns<false, true>>(&ground, at, workspace, acceleration),
                (true, false) => self.walk::<Columns<true, false>>(&ground, at, workspace, acceleration),
                (true, true) => self.walk::<Columns<true, true>>(&ground, at, workspace, acceleration),
            }
        };
        if const { couples::<S, L>() } {
            loads.accelerated(PositionOf::<S, R, C>::MODES, None, acceleration, swept);
        } else {
            swept(loads, false, acceleration);
        }
    }

    fn project(&self, _: &mut MotionOf<S, R, C, P>, _: &L, _: &mut Self::Workspace) {}

    fn assembly_step(&self, _: &mut MotionOf<S, R, C, P>, _: &L, _: &mut Self::Workspace) {}

    fn independent(
        &self,
        _: &MotionOf<S, R, C, P>,
        _: &Self::Workspace,
        _: f64,
        _: &mut impl FnMut(usize, &'static str),
    ) -> Result<(), Error> {
        Ok(())
    }

    fn accept(&self, motion: &MotionOf<S, R, C, P>) -> Result<(), Error> {
        Dynamics::<L>::accept(self.scene, motion)
    }

    fn diagnose(&self, motion: &MotionOf<S, R, C, P>, loads: &L, _: &mut Self::Workspace) -> Error {
        self.scene.diagnose(motion, loads, &mut Dynamics::<L>::workspace(self.scene))
    }
}
