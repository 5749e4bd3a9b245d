//! Couplings placed in a scene: joints found and looked at, and the inertia that resists each.

use super::{Coupling, Couplings, Pick, Tie, at, unit};
use crate::element::{Element, RealOf, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault, Place, ensure_finite};
use crate::loading::Unloaded;
use crate::mirror::{Rate, let_all_go};
use crate::motion::Motion;
use crate::names::JointNumbers;
use crate::relation::Way;
use crate::release::Release;
use crate::scalar::{Elementary, Real, Scalar};
use crate::system::{Dynamics, MotionOf, Runs, System, coordinates};
use crate::transfer::FromEfforts;
use crate::visit::Watch;
use crate::walks::travel::show;
use num_traits::{One, Zero};

impl<T: Scalar> Tie<T> {
    /// Knows what is rounding where closures hold both joints, half of the digits of what is left elsewhere: of what a unit of effort does here, if closures
    /// do not hold them here, or of what it does by the inertia that the joints carry where nothing is closed.
    fn know_closed(&mut self, carried: [T::Real; 2], measured: bool) {
        let (small, [follower, leader]) = (T::Real::EPSILON.sqrt(), carried.map(T::Real::recip));
        let leader = (self.ratio * self.ratio).real() * leader;
        // A joint that carries next to nothing says nothing.
        let open = match (follower * T::Real::EPSILON > leader, leader * T::Real::EPSILON > follower) {
            (true, _) => leader,
            (_, true) => follower,
            _ => follower + leader,
        };
        let left = self.inertia.recip();
        if measured && left >= open * small {
            self.rounding = left * small;
        } else if open.is_finite() {
            self.rounding = open * small;
            self.inertia = self.rounding.recip();
        }
    }
}

impl<T: Scalar, const K: usize> Couplings<T, K> {
    /// Couplings of the joints of a scene, and no other loads.
    ///
    /// # Errors
    /// Those of [`System::joint`] for joints that are not there; [`Fault::NotFinite`] for ratios and offsets; [`Fault::Unsupported`] for joints of none or of
    /// several coordinates, or of one that is not relative, and where a joint follows itself.
    pub fn of<'n, S, R, C, P>(scene: &System<S, R, C, P>, couplings: [Coupling<'n, T>; K]) -> Result<Self, Error>
    where
        S: FromEfforts<Scalar = T>,
        R: Root<S>,
        C: Element<S>,
        P: Tip<S>,
        System<S, R, C, P>: Runs<Self, S, R, C, P>,
    {
        let none = [0; 2];
        let ([ratio, offset], [inertia, rounding]) = ([T::one(), T::zero()], [T::Real::one(), T::Real::zero()]);
        let mut ties = [Tie { joints: none, coordinates: none, rates: none, ratio, offset, inertia, rounding }; K];
        for (tie, Coupling { picks, ratio, offset }) in ties.iter_mut().zip(couplings) {
            ensure_finite(ratio.is_finite() && offset.is_finite(), "ratio or offset of a coupling")?;
            let [follower, leader] = picks.map(|pick| picked(scene, pick));
            let numbers = [follower?, leader?];
            let [follower, leader] = numbers.map(|numbers| numbers.joint);
            if follower == leader {
                return Err(Error::new(Fault::Unsupported { what: "a joint that follows itself" }));
            }
            numbers.iter().try_for_each(|numbers| relative(scene, *numbers))?;
            *tie = Tie {
                joints: [follower, leader],
                coordinates: numbers.map(|numbers| numbers.coordinates().start),
                rates: numbers.map(|numbers| numbers.rates().start),
                ratio,
                offset,
                inertia,
                rounding,
            };
        }
        let (forces, counts) = ([T::zero(); K], [scene.bodies(), scene.joints()]);
        let mut couplings = Self { ties, forces, given: false, counts, others: Unloaded };
        couplings.weigh(scene)?;
        Ok(couplings)
    }

    /// Finds the inertia that resists each coupling, where all coordinates are zero.
    fn weigh<S, R, C, P>(&mut self, scene: &System<S, R, C, P>) -> Result<(), Error>
    where
        S: FromEfforts<Scalar = T>,
        R: Root<S>,
        C: Element<S>,
        P: Tip<S>,
        System<S, R, C, P>: Runs<Self, S, R, C, P>,
    {
        scene.admits(self)?;
        let (still, mut workspace) = (moving(scene), scene.workspace());
        let (mut free, mut moved) = (still.rate.clone(), still.rate.clone());
        let Motion { time, position, rate, .. } = &still;
        // Where closures do not hold a scene it says nothing of itself.
        let measured = scene.accelerate(&mut still.clone(), &self.pulling([T::zero(); K]), &mut workspace).is_ok();
        let mut inertias = [T::Real::one(); K];
        if measured {
            scene.accelerations(*time, position, rate, &self.pulling([T::zero(); K]), &mut workspace, &mut free);
            for (k, inertia) in inertias.iter_mut().enumerate() {
                scene.accelerations(
                    *time,
                    position,
                    rate,
                    &self.pulling(unit(k, T::one())),
                    &mut workspace,
                    &mut moved,
                );
                let [free, moved] = [&free, &moved].map(|rate| self.missed(rate)[k].real());
                let found = (moved - free).abs().recip();
                // Of a joint that does not move there nothing is known.
                *inertia = if found.is_finite() { found } else { T::Real::one() };
            }
        }
        for (tie, inertia) in self.ties.iter_mut().zip(inertias) {
            tie.inertia = inertia;
            if const { System::<S, R, C, P>::CLOSED > 0 } {
                tie.know_closed(tie.rates.map(|number| carried(scene, &still, number)), measured);
            }
        }
        Ok(())
    }
}

/// The inertia (kg·m², kg) of all that a joint carries, by the number of its rate, where the others are at rest and nothing is closed: twice its
/// kinetic energy at a rate of one.
fn carried<S, R, C, P>(scene: &System<S, R, C, P>, still: &MotionOf<S, R, C, P>, number: usize) -> RealOf<S>
where
    S: Space,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
{
    let mut moving = still.clone();
    let mut energy = |rate: f64| {
        moving.rate.replace(&mut |_| S::Scalar::zero());
        moving.rate.replace(&mut at(number, S::Scalar::literal(rate)));
        scene.budget_of(&moving).kinetic.real()
    };
    let still = energy(0.0);
    energy(1.0) + energy(-1.0) - still - still
}

/// A motion in which no joint sticks.
fn moving<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>>(scene: &System<S, R, C, P>) -> MotionOf<S, R, C, P> {
    let mut motion = scene.motion();
    let mut rate = motion.rate.clone();
    let_all_go(&mut motion.position, &mut rate, &motion.acceleration);
    motion
}

/// The numbers of a joint.
fn picked<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>>(
    scene: &System<S, R, C, P>,
    pick: Pick<'_>,
) -> Result<JointNumbers, Error> {
    let number = match pick {
        Pick::Joint(which) => return scene.joint(which),
        Pick::Coordinate(number) => number,
    };
    let mut joints = 0;
    for joint in 0..scene.joints() {
        let numbers = scene.joint(joint)?;
        if numbers.coordinates().len() == 1 {
            if joints == number {
                return Ok(numbers);
            }
            joints += 1;
        }
    }
    Err(Error::new(Fault::NoSuchJoint { joint: number, joints }))
}

/// Refuses a joint whose one coordinate is not one of its outboard body relative to its inboard one.
fn relative<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>>(
    scene: &System<S, R, C, P>,
    numbers: JointNumbers,
) -> Result<(), Error> {
    let motion = moving(scene);
    let mut look = Look { sought: numbers.joint, next: 0, found: false };
    show(scene.elements(), scene.ground(motion.time), coordinates::<S, _, P::Closures>(&motion), &mut look);
    let (what, error) = ("a coupling of joints but those of one relative coordinate that nothing drives", Error::new);
    match (look.found, numbers.station) {
        (true, _) => Ok(()),
        (false, Some(station)) => Err(error(Fault::Unsupported { what }).at_station(station)),
        (false, None) => Err(error(Fault::Unsupported { what }).at(Place::Root)),
    }
}

/// Looks at a joint.
struct Look {
    sought: usize,
    next: usize,
    found: bool,
}

impl<S: Space> Watch<S> for Look {
    fn joint(&mut self, _: &S::JointMotion) {
        self.next += 1;
    }
    fn joint_with(&mut self, _: &S::JointMotion, release: &dyn Fn() -> Release<S>) {
        if self.next == self.sought {
            let release = release();
            let [freedom, second, ..] = release.coordinates;
            let one = freedom.filter(|_| second.is_none() && !release.driven);
            self.found = one.is_some_and(|freedom| freedom.driven && (freedom.way == Way::Slide || release.carries));
        }
        self.next += 1;
    }
}
