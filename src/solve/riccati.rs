//! The Riccati sweep: a scene's accelerations in one walk inward and one outward.
//!
//! Symmetric at acceleration level, so one triangle of S is stored and no pivot is ever needed: every pivot is the inertia
//! of what lies outboard about a joint.

use crate::element::{
    Close, Condense, Coordinates, Element, Given, InJoint, Level, Loading, OnBody, Posture, Reading, RealOf, Space,
    Springs, Sweep, Watch,
};
use crate::ends::{Root, Tip};
use crate::loading::couples;
use crate::relation::{Acceleration, Closures, Part, Solvable};
use crate::shape::{Kept, PerAxes, PerBody, PerJoint, Rates};
use crate::space::FrameOf;
use crate::visit::{Visit, survey, survey_posed};
use crate::walks::apart::apart;
use crate::walks::entries::{Entry, entries};
use crate::walks::exert::Exert;
use crate::walks::faced::faced;
use crate::walks::measure::gains;
use crate::walks::posed::travel_posed;
use crate::walks::recover::recover;
use crate::walks::respond::respond;
use crate::walks::restore::restore;
use crate::walks::sines::sines;
use crate::walks::size::sizes;
use crate::walks::spread;
use crate::walks::travel::{show, travel};
use num_traits::Zero;

/// What couplings move.
type ResponsesOf<S, E, W> = <<W as Sweep<S>>::Loads as Loading<S>>::Responses<<E as Element<S>>::Rate>;

/// Room for the sweeps of one scene: reused, never reallocated.
#[derive(Clone)]
pub struct Workspace<S: Space, E: Element<S>, W: Sweep<S>> {
    sizes: E::Store<PerAxes<S::Size>>,
    x: E::Store<PerAxes<S::X>>,
    y: E::Store<PerAxes<S::Y>>,
    p: E::Store<PerAxes<S::P>>,
    q: E::Store<PerAxes<S::Q>>,
    on_bodies: E::Store<PerBody<OnBody<S, W>>>,
    in_joints: E::Store<PerJoint<InJoint<S, W>>>,
    pub(crate) kept: E::Store<Kept<W::Closures>>,
    /// Closure forces λ of the last sweep, and Λ.
    pub(crate) multipliers: <W::Closures as Closures>::Each<S::Scalar>,
    compliance: <W::Closures as Closures>::Pairs<S::Scalar>,
    /// What forces of couplings moved in the last sweeps, where there are closures to correct for.
    pub(crate) responses: ResponsesOf<S, E, W>,
    /// A correction of the coordinates, where there are closures to correct for.
    correction: Option<E::Rate>,
}

impl<S: Space, E: Element<S>, W: Sweep<S>> Workspace<S, E, W> {
    /// Room for the sweeps of `chain`.
    pub fn new(chain: &E) -> Self {
        let (x, y, p, q) = S::blank();
        let (on_body, in_joint) = W::Loads::nothing();
        Self {
            sizes: sizes(chain),
            x: chain.store::<PerAxes<_>>(x),
            y: chain.store::<PerAxes<_>>(y),
            p: chain.store::<PerAxes<_>>(p),
            q: chain.store::<PerAxes<_>>(q),
            on_bodies: chain.store::<PerBody<_>>(on_body),
            in_joints: chain.store::<PerJoint<_>>(in_joint),
            kept: gains(chain),
            multipliers: W::Closures::each(|_| S::Scalar::zero()),
            compliance: W::Closures::no_pairs(),
            responses: Default::default(),
            correction: (W::Closures::COUNT + E::LOOPS > 0).then(|| chain.store::<Rates>(())),
        }
    }
}

impl<S: Space, E: Element<S>, W: Sweep<S>> Workspace<S, E, W> {
    /// Λ of the last sweep.
    pub(crate) fn compliance(&self) -> &<W::Closures as Closures>::Pairs<S::Scalar> {
        &self.compliance
    }
}

/// Where a sweep takes place: what does not depend on the chain. The root is here by its type, so that scenes which differ in nothing
/// else do not share a sweep: it is inlined where it is the only one, and then knows how the ground moves. By way of a call a chain of
/// rods costs five instructions a body more.
pub struct Site<'a, S: Space, R, P, L> {
    /// What holds the root.
    pub root: &'a R,
    /// Gravity. It enters as an acceleration of the ground: the sweep takes place in a frame that falls freely.
    pub gravity: S::Vector,
    /// What the last element meets.
    pub tip: &'a P,
    /// Loads.
    pub loads: &'a L,
    /// Time (s).
    pub time: RealOf<S>,
    /// Whether the sweep before was here, at the same positions and rates, so that bodies are posed: where loads are coupled.
    pub again: bool,
}

/// How springs enter a sweep, and where they are.
pub struct Spring<'a, P, V, K> {
    /// Positions for springs.
    pub position: &'a P,
    /// Rates for dampers.
    pub rate: &'a V,
    /// Where laws that are not linear are read.
    pub reading: Reading<'a, P, V>,
    /// How springs and dampers enter.
    pub springs: K,
}

/// One sweep: the accelerations of all joint coordinates, from their positions and rates.
#[inline]
pub fn sweep<S: Space, E, W, R, P>(
    chain: &E,
    site: &Site<'_, S, R, P, W::Loads>,
    position: &E::Position,
    rate: &E::Rate,
    spring: &Spring<'_, E::Position, E::Rate, W::Springs>,
    workspace: &mut Workspace<S, E, W>,
    acceleration: &mut E::Rate,
) where
    W: Sweep<S>,
    R: Root<S>,
    P: Tip<S>,
    E: Condense<S, P::Relation, W, Out: Close<S, W::Closures>>,
{
    let Site { root, gravity, tip, loads, time, again } = site;
    let ground = &root.ground(*time);
    let Workspace { sizes, x, y, p, q, on_bodies, in_joints, kept, multipliers, compliance, .. } = workspace;
    // What a load reads of the motion is posed before.
    let late = const { E::POSED_LATE && !W::Loads::ON && !<W::Springs as Springs<S::Scalar>>::STIFF };
    // A free tip does not ask how it is turned.
    let turn =
        if const { (couples::<S, W::Loads>() || W::Loads::YIELDS.together()) && W::Closures::COUNT == 0 } && *again {
            ground.turn
        } else {
            sines(chain, position, x);
            faced(chain, *ground, position, rate, x);
            if late {
                chain.turned(position, rate, ground.turn)
            } else {
                chain.pose(position, rate, ground.turn, sizes, x, y, p, q)
            }
        };
    if const { E::SHARES } {
        apart::<S, E, W::Closures>(chain, *ground, position, rate, kept);
    }
    if const { W::Loads::ON && spread::is_listed::<S, E, W::Loads>() } {
        spread::loads(chain, *loads, (|x| x, |x| x), on_bodies, in_joints);
    } else if W::Loads::ON {
        if const { <W::Springs as Springs<S::Scalar>>::STIFF && W::Loads::YIELDS.each() } {
            // As laws of joints that are not linear: where the last sweep has led, with the accelerations that led there.
            let Reading { position, rate, acceleration } = spring.reading;
            let motion = Coordinates { position, rate, acceleration };
            let fallen = FrameOf::<S> { acceleration: ground.falling(*gravity), ..*ground };
            let seen = survey(chain, fallen, motion, *loads);
            travel(chain, fallen, motion, Exert::new(*loads, *time, &seen), on_bodies, in_joints);
        } else {
            let motion = Coordinates { position, rate, acceleration };
            let posture = Posture { x, y, p, q };
            let seen = survey_posed(chain, *ground, posture, motion, *loads);
            travel_posed(chain, *ground, posture, motion, Exert::new(*loads, *time, &seen), on_bodies, in_joints);
        }
    }
    // Chains of hinges are inlined as a whole: what was stored is then better read from where it stands than kept beside it, for registers
    // do not suffice for a copy: 5 % of an arm's sweep.
    let (x, y) = if const { E::SINES > 0 } { core::hint::black_box((x, y)) } else { (x, y) };
    let &Spring { position, rate, reading, springs } = spring;
    let given = Given { on_bodies, in_joints, position, rate, reading, springs };
    let (root, outer) = (ground.falling(*gravity), tip.relation(*time, *gravity, &turn));
    let relation = if late {
        chain.pose_and_condense(outer, ground.turn, sizes, x, y, p, q, given, kept)
    } else {
        chain.condense(outer, Posture { x, y, p, q }, given, kept)
    };
    let posture = Posture { x, y, p, q };
    *multipliers = relation.multipliers(&root);
    *compliance = relation.compliance();
    recover::<S, E, W::Closures, W::Springs>(chain, root, posture, kept, *multipliers, acceleration);
}

/// The correction of joint coordinates that moves the tip by −`residual` and closes loops, through the gains and the Λ of the last sweep:
/// the least one, measured by the inertia (and the stiffness, if the sweep was implicit) that those stand for. A loop closes without moving
/// the station where it begins.
pub fn correction<'w, S: Space, E: Element<S>, W: Sweep<S, Closures: Solvable>>(
    chain: &E,
    ground: FrameOf<S>,
    motion: Coordinates<'_, S, E>,
    level: Level,
    residual: &<W::Closures as Closures>::Each<S::Scalar>,
    workspace: &'w mut Workspace<S, E, W>,
) -> Option<&'w mut E::Rate> {
    let Workspace { x, y, p, q, kept, compliance, correction, .. } = workspace;
    let correction = correction.as_mut()?;
    let force = W::Closures::solve(compliance, &W::Closures::map(residual, |residual| -residual));
    let (still, posture) = (Acceleration::zero(), Posture { x, y, p, q });
    if const { E::LOOPS == 0 } {
        respond::<S, E, W::Closures>(chain, still, posture, kept, force, correction);
    } else {
        restore::<S, E, W::Closures>(chain, ground, motion, level, still, posture, kept, force, correction);
    }
    Some(correction)
}

/// The outermost body or joint (counted together from the root) with a load that is not finite.
pub(crate) fn broken_load<S: Space, E: Element<S>, L: Loading<S>>(
    chain: &E,
    ground: &FrameOf<S>,
    loads: &L,
    time: RealOf<S>,
    motion: Coordinates<'_, S, E>,
) -> Option<usize> {
    // A constant, so that a compiler does not even look at what follows where there are no loads.
    if const { !L::ON } {
        return None;
    }
    if const { L::BY_COORDINATE } {
        let mut joints = chain.store::<PerJoint<_>>(L::nothing().1);
        spread::to_coordinates(chain, loads.listed().1, |x| x, &mut joints);
        let (mut count, mut broken) = (0_usize, None);
        entries(chain, &chain.store::<PerBody<()>>(()), &joints, &mut |entry| {
            broken = if matches!(entry, Entry::Joint(torque) if !torque.is_finite()) { Some(count) } else { broken };
            count += 1;
        });
        return broken;
    }
    let seen = survey(chain, *ground, motion, loads);
    let mut check = LoadCheck { pass: Exert::new(loads, time, &seen), broken: None };
    show(chain, *ground, motion, &mut check);
    check.broken
}

struct LoadCheck<'a, S: Space, L: Loading<S>> {
    pass: Exert<'a, S, L>,
    broken: Option<usize>,
}

impl<S: Space, L: Loading<S>> LoadCheck<'_, S, L> {
    fn note(&mut self, finite: bool) {
        if !finite {
            self.broken = Some(self.pass.met() - 1);
        }
    }
}

impl<S: Space, L: Loading<S>> Watch<S> for LoadCheck<'_, S, L> {
    fn body(&mut self, motion: &S::BodyMotion) {
        let load = self.pass.body(motion);
        self.note(load.is_finite());
    }
    fn joint(&mut self, motion: &S::JointMotion) {
        let torque = self.pass.joint(motion);
        self.note(torque.is_finite());
    }
}
