//! Gradients of runs of robots, backward, in axes of their bodies: against jets through the same steps and central differences.

use super::held::share;
use catena::Scalar;
use catena::loading::LoadLaw;
use catena::robot::*;
use catena::scalar::Jet;

/// How one number acts in a joint: as the first of an effort.
pub mod efforts {
    use catena::Scalar;
    use catena::robot::Effort;

    pub fn of<T: Scalar>(torque: T) -> Effort<T> {
        Effort([torque, T::zero(), T::zero()])
    }
    pub fn number<T: Scalar>(Effort([torque, ..]): &Effort<T>) -> T {
        *torque
    }
}

/// Runs what needs more stack than a test's thread has.
pub fn on_a_large_stack(test: fn()) {
    let run = std::thread::Builder::new().stack_size(256 << 20).spawn(test).unwrap().join();
    run.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
}

/// Springs to the origin and drag, in proportion to what the law reads of a body.
#[derive(Clone, Copy)]
pub struct Medium;
catena::lift!(Medium);
impl<T: Scalar> LoadLaw<BodyMotion<T>> for Medium {
    type Value = Wrench<T>;
    fn at(&self, _: T::Real, body: usize, motion: &BodyMotion<T>) -> Wrench<T> {
        let turn = motion.inboard.turn;
        let swept = turn.spin.cross(&motion.to_centre);
        let drag = T::literal(-0.7) * (T::literal(body as f64) + T::one());
        let force = (motion.inboard.velocity + swept) * (drag * motion.inertia.mass) + motion.inboard.place * drag;
        Wrench { force, torque: motion.to_centre.cross(&force) + (turn.spin + turn.attitude.x) * drag }
    }
}

/// Places of joints, turns between bodies, two links, springs, a rotor, gravity.
pub const KINDS: [(&str, usize); 8] = [
    ("places", 6),
    ("offsets", 4),
    ("masses", 2),
    ("mass centres", 6),
    ("tensors", 12),
    ("springs", 3),
    ("rotors", 2),
    ("gravity", 3),
];

pub fn numbers() -> Vec<f64> {
    let mut list = vec![0.1, -0.2, 0.4, 0.05, 0.3, -0.1, 0.3, -0.4, 0.5, 0.7, 1.3, 0.8];
    list.extend([0.05, -0.03, 0.2, 0.02, 0.1, 0.15]);
    list.extend([0.11, 0.09, 0.05, 0.004, -0.003, 0.002, 0.08, 0.07, 0.03, 0.002, 0.003, -0.004]);
    list.extend([6.0, 0.2, 0.3, 0.05, 0.4, 1.0, -0.7, -9.81]);
    list
}

/// What a scene is made of, from its numbers.
macro_rules! of {
    ($x:ident, |$link:ident, $other:ident, $at:ident, $turned:ident, $spring:ident| $scene:expr) => {{
        let vector = |first: usize| [0, 1, 2].map(|k| $x(first + k));
        let tensor = |first: usize| {
            let [xx, yy, zz, yz, xz, xy] = [0, 1, 2, 3, 4, 5].map(|k| $x(first + k));
            [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
        };
        let $link = Link::<N>::general($x(10), vector(12), tensor(18));
        // Of this one some numbers are zero by type.
        let o = N::constant(0.0);
        let [_, y, z] = vector(15);
        let sparse = [[$x(24), o, o], [o, $x(25), o], [o, o, $x(26)]];
        let $other = (
            Link::<N, 0b110, 0b1111>::new($x(11), [o, y, z], sparse),
            Link::<N>::general($x(11), vector(15), tensor(24)),
        );
        let $at = [vector(0), [o, $x(3), o], [$x(4), o, $x(5)]];
        let $turned = (Turned::by(Rotation::from_angles(vector(6))), Leaning::by($x(9)));
        let $spring = Spring::new($x(30)).damped($x(31)).resting_at($x(32));
        $scene.with_gravity(vector(35))
    }};
}

#[test]
fn arms() {
    on_a_large_stack(arm);
}

/// Hinges and slides on a base, turned by all kinds of offsets, with springs and rotors, and an arm that branches off.
fn arm() {
    macro_rules! by {
        ($name:expr, $method:expr, $steps:expr $(, under $law:expr)?) => {
            gradients!(super::robots::efforts, $name, KINDS, numbers(), vec![0.3, -0.4, 0.5, 0.2, -0.6, 0.1], 7, $method, $steps, 0.01, |x| {
                of!(x, |link, other, at, turned, spring| {
                    let forked = Hinge::at::<0b101>(at[2]).turned(turned.1).ahead(x(9)).geared(x(34));
                    let branch = (forked, other.1, Slide::at::<7>(at[0]).with(spring), link);
                    let elbow = Hinge::at::<7>(at[0]).turned(turned.0).ahead(x(8));
                    let (upper, elbow, fore) = Rotor::new(x(33), x(34)).between(link, elbow, other.1).unwrap();
                    let chain = (
                        Hinge::level().with(spring).grounded(),
                        upper,
                        elbow,
                        fore,
                        Branch(branch),
                        Slide::at::<0b10>(at[1]).turned(Quarter::<30>).with(spring).geared(x(34)),
                        link,
                        Hinge::at::<7>(at[0]).turned(Quarter::<1>).ahead(x(6)).named("wrist"),
                        other.0,
                    );
                    System::new(Base::at([0.0, 0.1, 0.2].map(N::constant)), chain, Free).unwrap()
                })
            } $(, under $law)?);
        };
    }
    by!("arm, RK4", Rk4, 4);
    by!("arm, DOP853", Dop853, 2);
    by!("arm, generalised-α", GeneralizedAlpha::new(0.8), 4);
    by!("arm, SDIRK4", Sdirk4::new(), 3);
    by!("arm in a medium, RK4", Rk4, 4, under Medium);
}

#[test]
fn held_tips() {
    on_a_large_stack(held);
}

/// A tilted robot whose tip the ground holds, beyond a flange, a rod on a ball in one, and by directions in another.
fn held() {
    let mut parameters = numbers();
    parameters.extend([0.3, 0.1, -0.2, 0.2, 0.3, 0.1, 0.5, 0.05, 0.9]);
    let kinds = [&KINDS[..], &[("flange", 3), ("root", 3), ("rod", 3)]].concat();
    let angles = vec![0.3, -0.4, 0.5, 0.2, -0.6, 0.4, 0.7];
    macro_rules! by {
        ($name:expr, $method:expr, $tip:expr, $joints:literal, |$flange:ident, $rod:ident| $beyond:expr) => {
            gradients!(
                super::robots::efforts,
                $name,
                kinds,
                parameters.clone(),
                angles.clone(),
                $joints,
                $method,
                3,
                0.01,
                |x| {
                    of!(x, |link, other, at, turned, spring| {
                        let upper = (
                            Hinge::level().with(spring).geared(x(33)).grounded(),
                            link,
                            Hinge::at::<7>(at[0]).turned(turned.0),
                            other.1,
                        );
                        let middle = (
                            Slide::at::<7>(at[1]).turned(Quarter::<30>).with(spring).geared(x(34)),
                            link,
                            Hinge::at::<7>(at[0]).turned(turned.1),
                            other.1,
                        );
                        let lower = (
                            Hinge::at::<7>(at[0]).turned(Quarter::<30>),
                            link,
                            Hinge::at::<7>(at[0]).turned(Quarter::<1>).named("wrist"),
                            other.1,
                            Hinge::at::<4>([N::constant(0.0), N::constant(0.0), x(5)]).turned(Quarter::<30>),
                            link,
                        );
                        let $flange = Flange::at([x(38), x(39), x(40)]);
                        let $rod = Rod::<N>::uniform(x(44), x(45), x(46));
                        let root =
                            Clamped::at([0.0, 0.1, 0.2].map(N::constant), Rotation::from_angles([x(41), x(42), x(43)]));
                        let _ = (spring, other.0);
                        System::new(root, (BodyAxes, upper, middle, lower, $beyond), $tip).unwrap()
                    })
                }
            );
        };
    }
    macro_rules! both {
        ($name:literal, $method:expr) => {
            by!(
                concat!("pinned, ", $name),
                $method,
                Pinned::on([0.3, 0.2, 0.9].map(N::constant)),
                10,
                |flange, rod| (flange, rod)
            );
            by!(
                concat!("hinged, ", $name),
                $method,
                Hinged::at([0.3, 0.2, 0.9].map(N::constant), [0.6, 0.0, 0.8].map(N::constant)),
                10,
                |flange, rod| (flange, rod)
            );
        };
    }
    both!("RK4", Rk4);
    both!("SDIRK4", Sdirk4::new());
}

#[test]
fn loops() {
    on_a_large_stack(loop_of_two_arms);
}

/// Two arms of a robot that a ball or a revolute joint closes, on a link, with a robot beyond.
fn loop_of_two_arms() {
    let mut parameters = numbers();
    parameters.extend([0.3, 0.1, -0.2]);
    let kinds = [&KINDS[..], &[("flanges", 3)]].concat();
    macro_rules! by {
        ($name:expr, $method:expr, $closing:expr) => {
            let angles = vec![0.3, -0.4, 0.5, 0.2, -0.6, 0.4, 0.7, 0.3, 0.2, -0.1];
            gradients!(super::robots::efforts, $name, kinds, parameters.clone(), angles, 18, $method, 3, 0.01, |x| {
                of!(x, |link, other, at, turned, spring| {
                    let flange = Flange::at([x(38), x(39), x(40)]);
                    let (hinge, leaning) =
                        (Hinge::at::<7>(at[0]).turned(turned.0), Hinge::at::<7>(at[0]).turned(turned.1));
                    let quarter = Hinge::at::<7>(at[0]).turned(Quarter::<30>).with(spring).geared(x(33));
                    let main = (BodyAxes, hinge, link, quarter, other.1, leaning, link, hinge, link, flange);
                    let side = (
                        BodyAxes,
                        leaning,
                        other.1,
                        Slide::at::<0b10>(at[1]).turned(Quarter::<1>),
                        link,
                        quarter,
                        link,
                        hinge,
                        link,
                        flange,
                    );
                    let beyond = (BodyAxes, quarter, other.0);
                    let first = (Hinge::level().geared(x(34)).grounded(), link, flange);
                    let chain = (first, Network::new(main, side, $closing), beyond);
                    System::new(Base::origin(), chain, Free).unwrap()
                })
            });
        };
    }
    by!("ball, RK4", Rk4, Ball);
    by!("ball, generalised-α", GeneralizedAlpha::new(0.8), Ball);
    by!("revolute, RK4", Rk4, Revolute::about([0.6, 0.0, 0.8].map(N::constant)));
}

#[test]
fn furniture() {
    on_a_large_stack(laws_in_tuples);
}

/// Several laws along one coordinate: a spring and friction, a damper and stops, one of which is met.
fn laws_in_tuples() {
    let mut parameters = numbers();
    parameters.extend([0.4, 0.3, -0.5, 0.25, 60.0, 0.1]);
    let kinds = [&KINDS[..], &[("friction", 2), ("stops", 4)]].concat();
    macro_rules! by {
        ($name:expr, $method:expr) => {
            gradients!(
                super::robots::efforts,
                $name,
                kinds,
                parameters.clone(),
                vec![0.3, 0.4, 0.5],
                4,
                $method,
                4,
                0.01,
                |x| {
                    of!(x, |link, other, at, turned, spring| {
                        let friction = DryFriction::new(x(38), x(39));
                        let stops = Stops::between([x(40), x(41)], x(42), x(43));
                        let first = Hinge::level().with((spring, friction)).geared(x(33)).grounded();
                        let second =
                            Hinge::at::<7>(at[0]).turned(turned.0).with((Spring::damping(x(31)), stops)).geared(x(34));
                        let third = Slide::at::<7>(at[2]).turned(turned.1).with(friction);
                        let _ = other.0;
                        System::new(
                            Base::at([0.0; 3].map(N::constant)),
                            (first, link, second, other.1, third, link),
                            Free,
                        )
                        .unwrap()
                    })
                }
            );
        };
    }
    by!("furniture, RK4", Rk4);
    by!("furniture, SDIRK4", Sdirk4::new());
    by!("furniture, generalised-α", GeneralizedAlpha::new(0.8));
}
