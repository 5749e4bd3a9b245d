//! Joints that move together: one follows another, q = r q′ + c, as gears, belts and grippers make it.

mod backward;
mod loads;
mod placed;

use crate::lift::Lift;
use crate::loading::{Unloaded, balanced};
use crate::mirror::{Position, Rate};
use crate::motion::Motion;
use crate::names::Which;
use crate::relation::Closures;
use crate::scalar::{Elementary, Real, Scalar};
use num_traits::{One, Zero};

/// What of both numbers that a coupling ties must be left for it to say something.
const LEAST: f64 = 1e-10;

/// The joints of a coupling, as they are named.
#[derive(Clone, Copy, Debug)]
enum Pick<'n> {
    /// By number or name.
    Joint(Which<'n>),
    /// By number among joints of one coordinate.
    Coordinate(usize),
}

/// A joint that follows another one: its coordinate is q = r q′ + c, by the coordinate q′ of its leader, a ratio r (1, rad/m, m/rad) and an
/// offset c (rad, m).
#[derive(Clone, Copy, Debug)]
pub struct Coupling<'n, T = f64> {
    picks: [Pick<'n>; 2],
    ratio: T,
    offset: T,
}

impl<'n, T: Scalar> Coupling<'n, T> {
    /// A joint that follows a leader, both by number (the root's joint is 0) or by name: at first with the ratio one and without an offset.
    pub fn new(follower: impl Into<Which<'n>>, leader: impl Into<Which<'n>>) -> Self {
        Self::of([Pick::Joint(follower.into()), Pick::Joint(leader.into())])
    }

    /// A joint that follows a leader, numbered as [`Torques`](crate::robot::Torques) has them, from 0 on and those of one coordinate alone: as the module of a
    /// robot's description numbers them.
    pub fn by_coordinate(follower: usize, leader: usize) -> Self {
        Self::of([follower, leader].map(Pick::Coordinate))
    }

    fn of(picks: [Pick<'n>; 2]) -> Self {
        Self { picks, ratio: T::one(), offset: T::zero() }
    }

    /// With a ratio: by how much the follower moves where its leader moves by one. Negative where they move against each other.
    #[must_use]
    pub fn ratio(self, ratio: T) -> Self {
        Self { ratio, ..self }
    }

    /// With an offset (rad, m): where the follower is with its leader at zero.
    #[must_use]
    pub fn offset(self, offset: T) -> Self {
        Self { offset, ..self }
    }
}

/// A coupling of a scene: the numbers of follower and leader, of joints, of coordinates and of rates.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "T: serde::Serialize, T::Real: serde::Serialize",
        deserialize = "T: serde::Deserialize<'de>, T::Real: serde::Deserialize<'de>"
    ))
)]
struct Tie<T: Scalar> {
    joints: [usize; 2],
    coordinates: [usize; 2],
    rates: [usize; 2],
    ratio: T,
    offset: T,
    /// An effort (N·m, N) by which the follower accelerates by about one more than the leader asks of it.
    inertia: T::Real,
    /// Response of the follower to a unit of effort that is no more than rounding, as where closures hold both joints.
    rounding: T::Real,
}

impl<T: Scalar> Tie<T> {
    /// By how much two numbers, the follower's and the leader's, miss the ratio.
    fn missed(&self, [follower, leader]: [T; 2]) -> T {
        follower - self.ratio * leader
    }

    /// The size of both numbers, as a follower has them.
    fn reach(&self, [follower, leader]: [T; 2]) -> T::Real {
        follower.real().abs() + (self.ratio * leader).real().abs()
    }

    /// How far both numbers, as a force of a size moves them, must miss the ratio to say anything: less is rounding, where the one follows from the
    /// other anyhow, or closures hold both.
    fn least(&self, moved: [T; 2], size: T::Real) -> T::Real {
        (self.reach(moved) * T::Real::of(LEAST)).max(size * self.rounding)
    }
}

/// Couplings of a scene's joints, beside other loads.
///
/// What ties two joints is a pair of forces in them, λ in the follower and −r λ in its leader, that does no work. It is a load, one that
/// hangs on the accelerations: each sweep is made once without, and once for each coupling, for which bodies are posed already, and λ follows
/// from what these differ by. So `K` couplings cost `K` + 1 sweeps where there was one (counted as one by
/// [`Run`](crate::simulate::Run)), and one more by implicit rules, in closed scenes, and where joints stick or
/// strike stops. (In scenes with vectors they allocate.) All rules know them, implicit ones too, events, dense output and readings: internal forces contain λ. Accelerations are
/// coupled to rounding, and so are motions that begin so, for rules add multiples of accelerations up: what they miss is checked where a
/// run begins, and not put back. Where loops close or a tip is held, couplings and closures are put back together, by no sweep, and
/// accelerations take one sweep more; [`assembled`](crate::system::System::assembled) under couplings finds a start.
///
/// Joints have one coordinate that is relative to the inboard body: `Revolute`, `Slider` and `ElasticHinge` in the plane, `Revolute` and
/// `Prismatic` in space, [`Hinge`](crate::robot::Hinge) and [`Slide`](crate::robot::Slide) of robots, with springs, friction or stops or without, and joints of one's
/// own. The angle of a `Pin` is that of its body, so that it is refused.
///
/// [`Fault::Shape`](crate::Fault::Shape) in a scene with vectors of other lengths; [`Fault::Unsupported`](crate::Fault::Unsupported) in transfer matrices and the scheme of
/// [`paper`](crate::paper). Equilibria and modes know them. Runs go backward [under](crate::sensitivity::Backward::under) couplings, by their
/// [ratios](crate::sensitivity::Gradient::by_ratios), too. Taylor series do not compile with them.
///
/// ```
/// use catena::planar::*;
/// // Two fingers that close on each other, driven by a torque in one of them.
/// let (finger, joint) = (Rod::uniform(0.05, 0.02), Revolute::smooth());
/// let hand = (Branch((joint.named("left"), finger)), joint.named("right"), finger);
/// let scene = System::new(Clamped::origin(), hand, Free)?;
/// let couplings = Couplings::of(&scene, [Coupling::new("right", "left").ratio(-1.0)])?;
/// let start = couplings.joined(scene.at_rest(&[0.3, 0.0])?); // the right one goes to −0.3
/// let loads = couplings.and(Loads::none().torques([0.0, 1e-4, 0.0]));
/// let end = scene.simulation(Dop853::tolerance(1e-9)).loads(&loads).run(start, 0.1, |_| ())?.motion;
/// let [left, right] = end.coordinates()[..] else { unreachable!() };
/// assert!(f64::abs(left + right) < 1e-15);
/// # Ok::<(), catena::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        serialize = "[T; K]: serde::Serialize, T: serde::Serialize, T::Real: serde::Serialize, [Tie<T>; K]: serde::Serialize, L: serde::Serialize",
        deserialize = "[T; K]: serde::Deserialize<'de>, T: serde::Deserialize<'de>, T::Real: serde::Deserialize<'de>, [Tie<T>; K]: serde::Deserialize<'de>, L: serde::Deserialize<'de>"
    ))
)]
pub struct Couplings<T: Scalar, const K: usize, L = Unloaded> {
    ties: [Tie<T>; K],
    /// Forces λ (N·m, N) of a sweep under way.
    forces: [T; K],
    /// Whether sweeps take these forces as they are.
    given: bool,
    /// How many bodies and joints the scene has.
    counts: [usize; 2],
    others: L,
}

impl<T: Scalar, const K: usize> Couplings<T, K> {
    /// Other loads besides. [`Torques`](crate::robot::Torques), which number joints of one coordinate, do not compile here: take
    /// [`Loads::efforts`](crate::loading::Loads::efforts).
    pub fn and<L>(self, others: L) -> Couplings<T, K, L> {
        let Self { ties, forces, given, counts, .. } = self;
        Couplings { ties, forces, given, counts, others }
    }
}

impl<T: Scalar, const K: usize, L> Couplings<T, K, L> {
    /// Ratios and offsets of the couplings.
    pub(crate) fn numbers(&self) -> impl Iterator<Item = [T; 2]> {
        self.ties.iter().map(|tie| [tie.ratio, tie.offset])
    }

    /// A motion with followers where their leaders have them, and as fast.
    #[must_use]
    pub fn joined<P: Position<T>, C: Closures>(&self, mut motion: Motion<T, P, C>) -> Motion<T, P, C> {
        // A leader may follow another one: as often as there may be such.
        for Tie { coordinates: [to, from], rates: [to_rate, from_rate], ratio, offset, .. } in
            self.ties.iter().cycle().take(K * K)
        {
            let [mut position, mut rate] = [T::zero(); 2];
            motion.position.visit(&mut numbered(*from, |x| position = *ratio * x + *offset));
            motion.rate.visit(&mut numbered(*from_rate, |x| rate = *ratio * x));
            motion.position.replace(&mut at(*to, position));
            motion.rate.replace(&mut at(*to_rate, rate));
        }
        motion
    }

    /// What a unit of the force of each coupling exerts in joints of one coordinate each.
    pub(crate) fn rows<const N: usize>(&self) -> [[T; N]; K] {
        self.ties.each_ref().map(|Tie { rates: [follower, leader], ratio, .. }| {
            core::array::from_fn(|joint| match joint {
                joint if joint == *follower => T::one(),
                joint if joint == *leader => -*ratio,
                _ => T::zero(),
            })
        })
    }

    /// Forces λ of couplings, from accelerations without them and by a unit of each.
    pub(crate) fn balancing<const N: usize>(&self, free: &[T; N], responses: &[[T; N]; K]) -> [T; K] {
        let pairs = |list: &[T; N]| {
            self.ties.each_ref().map(|tie| tie.rates.map(|place| list.get(place).copied().unwrap_or(T::zero())))
        };
        self.balanced_by(&responses.each_ref().map(pairs), [T::Real::one(); K], self.missing(pairs(free)))
    }

    /// The shares of responses to forces of these sizes, by the numbers of followers and leaders in each, that undo what is missed.
    fn balanced_by(&self, responses: &[[[T; 2]; K]; K], sizes: [T::Real; K], missed: [T; K]) -> [T; K] {
        let columns = responses.map(|pairs| [self.missing(pairs).map(|missed| [missed])]);
        let least = |k: usize| self.ties[k].least(responses[k][k], sizes[k]);
        balanced(columns, least, missed.map(|missed| [-missed])).map(|[share]| share)
    }

    /// Shares of such responses that undo what accelerations without miss. What misses much, more than rounding leaves where closures hold it, is
    /// moved however little a force does there, as against stiff springs by implicit rules.
    fn balanced_at(&self, responses: &[[[T; 2]; K]; K], sizes: [T::Real; K], free: [[T; 2]; K]) -> [T; K] {
        let (missed, small) = (self.missing(free), Elementary::sqrt(Elementary::sqrt(T::Real::EPSILON)));
        let sizes = core::array::from_fn(|k| {
            let held = missed[k].real().abs() <= self.ties[k].reach(free[k]) * small;
            if held { sizes[k] } else { Zero::zero() }
        });
        self.balanced_by(responses, sizes, missed)
    }

    /// Positions of followers and leaders.
    fn places<P: Position<T>>(&self, position: &P) -> [[T; 2]; K] {
        let mut pairs = Pairs::of(&self.ties, |tie| tie.coordinates);
        position.visit(&mut |x| pairs.show(x));
        pairs.found
    }

    /// Rates, or accelerations, of followers and leaders.
    #[inline]
    fn rates<V: Rate<T>>(&self, rate: &V) -> [[T; 2]; K] {
        let mut pairs = Pairs::of(&self.ties, |tie| tie.rates);
        rate.visit(&mut |x| pairs.show(x));
        pairs.found
    }

    /// By how much followers are not where their leaders have them.
    fn apart<P: Position<T>>(&self, position: &P) -> [T; K] {
        let missed = self.missing(self.places(position));
        core::array::from_fn(|k| missed[k] - self.ties[k].offset)
    }

    /// By how much the rates, or accelerations, of followers miss those that their leaders ask of them.
    fn missed<V: Rate<T>>(&self, rate: &V) -> [T; K] {
        self.missing(self.rates(rate))
    }

    /// Lets followers of what does not move, and what leads such followers, be still to the last digit, where without forces they miss so much.
    fn still<V: Rate<T>>(&self, acceleration: &mut V, missed: [T; K]) {
        let pairs = self.rates(acceleration);
        for ((tie, pair), missed) in self.ties.iter().zip(pairs).zip(missed) {
            let rounding = Elementary::sqrt(T::Real::EPSILON) * (T::Real::one() + missed.real().abs());
            for (place, [moves, other]) in tie.rates.into_iter().zip([pair, [pair[1], pair[0]]]) {
                if other.is_zero() && moves.real().abs() <= rounding {
                    acceleration.replace(&mut at(place, T::zero()));
                }
            }
        }
    }

    /// By how much numbers of followers miss r times those of their leaders.
    fn missing(&self, pairs: [[T; 2]; K]) -> [T; K] {
        core::array::from_fn(|k| self.ties[k].missed(pairs[k]))
    }
}

impl<T: Scalar, U: Scalar<Real = T::Real>, const K: usize, L: Lift<T, U>> Lift<T, U> for Couplings<T, K, L> {
    type Over = Couplings<U, K, L::Over>;
    fn lift(&self, number: &mut impl FnMut(T) -> U) -> Self::Over {
        let none = U::zero();
        let ties = self.ties.map(|Tie { joints, coordinates, rates, ratio, offset, inertia, rounding }| {
            let [ratio, offset] = [ratio, offset].map(&mut *number);
            Tie { joints, coordinates, rates, ratio, offset, inertia, rounding }
        });
        Couplings { ties, forces: [none; K], given: false, counts: self.counts, others: self.others.lift(number) }
    }
}

/// Numbers of followers and leaders, as they are met in a list.
struct Pairs<T, const K: usize> {
    found: [[T; 2]; K],
    places: [[usize; 2]; K],
    next: usize,
}

impl<T: Scalar, const K: usize> Pairs<T, K> {
    fn of(ties: &[Tie<T>; K], places: impl Fn(&Tie<T>) -> [usize; 2]) -> Self {
        Self { found: [[T::zero(); 2]; K], places: ties.each_ref().map(places), next: 0 }
    }

    /// The next number of the list.
    #[inline(always)]
    fn show(&mut self, x: T) {
        for (pair, places) in self.found.iter_mut().zip(&self.places) {
            for (entry, place) in pair.iter_mut().zip(places) {
                if *place == self.next {
                    *entry = x;
                }
            }
        }
        self.next += 1;
    }
}

/// A list that is zero but for one entry.
fn unit<T: Scalar, const K: usize>(place: usize, entry: T) -> [T; K] {
    core::array::from_fn(|k| if k == place { entry } else { T::zero() })
}

/// Shows one entry of a list.
fn numbered<T>(number: usize, mut show: impl FnMut(T)) -> impl FnMut(T) {
    let mut next = 0;
    move |x| {
        if next == number {
            show(x);
        }
        next += 1;
    }
}

/// Replaces one entry of a list.
fn at<T: Copy>(number: usize, entry: T) -> impl FnMut(T) -> T {
    let mut next = 0;
    move |x| {
        next += 1;
        if next == number + 1 { entry } else { x }
    }
}
