//! Gradients of runs in space under loads on bodies that depend on the motion.

use super::*;
use catena::Real;
use catena::loading::LoadLaw;
use catena::nalgebra::Vector3;

/// Drag at the outboard ends of all bodies, −c √(v² + 0.01) v, a field that pulls every second one, by its mass, to a point, and a torque that brakes
/// turning, −b ω² L of the angular momentum L, and slackens with time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Medium<T> {
    drag: T,
    pull: T,
    anchor: [T; 3],
    brake: T,
}
catena::lift!(Medium<T> { drag, pull, anchor, brake });

impl<T: Scalar> LoadLaw<BodyMotion<T>> for Medium<T> {
    type Value = Wrench<T>;

    fn at(&self, time: T::Real, body: usize, motion: &BodyMotion<T>) -> Wrench<T> {
        let v = motion.outboard().velocity;
        let drag = v * -(self.drag * (v.dot(&v) + T::literal(0.01)).sqrt());
        let field = match body % 2 {
            0 => v * T::zero(),
            _ => (motion.centre().place - Vector3::from(self.anchor)) * -(self.pull * motion.inertia.mass),
        };
        let slack = T::Real::of(1.0) / (T::Real::of(1.0) + time);
        let spin = motion.inboard.turn.spin;
        let brake = motion.spin_momentum() * -(self.brake * spin.dot(&spin)).scale(slack);
        Wrench { force: drag + field, torque: motion.arm.cross(&drag) + motion.to_centre.cross(&field) + brake }
    }
}

/// Numbers of a medium.
pub(super) const MEDIUM: [f64; 6] = [0.4, 3.0, 0.5, 0.8, -0.3, 0.2];

impl<T: Scalar> Medium<T> {
    /// From numbers after the first.
    pub(super) fn of(number: impl Fn(usize) -> T, first: usize) -> Self {
        let at = |k: usize| number(first + k);
        Self { drag: at(0), pull: at(1), anchor: [at(2), at(3), at(4)], brake: at(5) }
    }
}

/// All bodies and joints, a ball after a ball, an arm, a clamped root at a place: by all of it, and by the numbers of the law.
#[test]
fn trees_under_loads_have_the_gradients_of_jets() {
    with_room(trees);
}

fn trees() {
    let mut parameters = bodies(2);
    parameters.extend([0.3, 1.0, -0.5, 0.2, 0.1, -0.4]); // an axis, a weld
    parameters.extend([0.7, 0.8, 0.3, 0.02, 0.05, 0.4, 0.3]); // a rod, a bob
    parameters.extend([3.0, 0.4, 0.2]); // a spring
    parameters.extend([0.3, -0.2, 0.1, 0.4, 0.2, -0.6]); // the root
    parameters.extend(MEDIUM);
    let kinds: Kinds = &[
        ("bodies", 26),
        ("gravity", 3),
        ("axis", 3),
        ("weld", 3),
        ("rod", 5),
        ("bob", 2),
        ("springs", 3),
        ("place of the root", 3),
        ("its attitude", 3),
        ("law", 6),
    ];
    let balls = [false, true, false, true, false, true, false];
    macro_rules! tree {
        ($method:expr, $steps:expr, $h:expr) => {
            gradients!(
                &format!("a tree under loads, {:?}", $method),
                kinds,
                parameters.clone(),
                balls,
                8,
                $method,
                $steps,
                $h,
                |x| {
                    let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                    let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                    let hinge = Revolute::about(vector(29));
                    let spring = Spring::new(x(42)).damped(x(43)).resting_at(x(44));
                    let weld = Weld::at(Rotation::from_angles(vector(32)));
                    let rod = Rod::new(x(35), x(36), x(37), x(38), x(39));
                    let bob = PointMass::new(x(40), x(41));
                    let arm = (Ball, rod, hinge, bob);
                    let chain =
                        (of(0), Branch(arm), Ball, of(1), weld, rod, hinge.with(spring), of(0), Ball, rod, hinge, bob);
                    let root = Clamped::at(vector(45), Rotation::from_angles(vector(48)));
                    let root = Hinged::on(root, vector(29));
                    System::new(root, chain, Free).unwrap().with_gravity(vector(26))
                },
                under(6, |y| { Medium::of(y, 51) })
            );
        };
    }
    tree!(Rk4, 4, 0.05);
    tree!(Dop853, 2, 0.1);
}

/// A tree on stiff and soft springs, by rules whose pivots know these.
#[test]
fn implicit_rules_under_loads_have_the_gradients_of_jets() {
    macro_rules! sprung {
        ($method:expr, $stiffness:expr) => {{
            let mut parameters = bodies(2);
            parameters.extend([0.3, 1.0, -0.5, 0.2, 0.1, -0.4]); // an axis, a weld
            parameters.extend([$stiffness, 0.01 * $stiffness, 0.2]); // a spring
            parameters.extend(MEDIUM);
            let kinds: Kinds = &[("bodies", 26), ("gravity", 3), ("axis", 3), ("weld", 3), ("spring", 3), ("law", 6)];
            let name = format!("springs of {} N·m/rad under loads, {:?}", $stiffness, $method);
            gradients!(
                &name,
                kinds,
                parameters,
                [false; 4],
                5,
                $method,
                3,
                0.03,
                |x| {
                    let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                    let vector = |first: usize| [0, 1, 2].map(|k| x(first + k));
                    let (hinge, weld) = (Revolute::about(vector(29)), Weld::at(Rotation::from_angles(vector(32))));
                    let sprung = hinge.with(Spring::new(x(35)).damped(x(36)).resting_at(x(37)));
                    let ground = Clamped::at([0.0; 3].map(N::constant), Rotation::from_angles(vector(32)));
                    let chain = (of(0), Branch((sprung, of(1))), weld, of(1), sprung, of(0), hinge, of(1));
                    System::new(Hinged::on(ground, vector(29)), chain, Free).unwrap().with_gravity(vector(26))
                },
                under(6, |y| { Medium::of(y, 38) })
            );
        }};
    }
    with_room(|| {
        sprung!(Sdirk4::new(), 10.0);
        sprung!(Sdirk4::new(), 1e4);
        sprung!(GeneralizedAlpha::new(0.8).with_sweeps(3), 1e4);
    });
}

/// A window that a hinge closes, behind a body on a ball, and a tip that is held.
#[test]
fn closed_scenes_under_loads_have_the_gradients_of_jets() {
    with_room(|| {
        let mut parameters = bodies(2);
        parameters.extend(CLOSED);
        parameters.extend(MEDIUM);
        let mut kinds = OF_CLOSED.to_vec();
        kinds.push(("law", 6));
        gradients!(
            "closed, under loads",
            kinds,
            parameters,
            [true; 6],
            7,
            Rk4,
            2,
            0.02,
            |x| { closed!(N, x) },
            under(6, |y| { Medium::of(y, 35) })
        );
    });
}

/// Balls at the root, which lies at a place.
#[test]
fn balls_under_loads_have_the_gradients_of_jets() {
    with_room(on_balls);
}

fn on_balls() {
    let mut parameters = bodies(3);
    parameters.extend([0.3, -0.2, 0.1]);
    parameters.extend(MEDIUM);
    let kinds: Kinds = &[("bodies", 39), ("gravity", 3), ("place of the root", 3), ("law", 6)];
    gradients!(
        "balls under loads",
        kinds,
        parameters,
        [true; 3],
        3,
        Rk4,
        4,
        0.05,
        |x| {
            let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
            let root = Pinned::on([0, 1, 2].map(|k| x(42 + k)));
            System::new(root, (of(0), Ball, of(1), Ball, of(2)), Free)
                .unwrap()
                .with_gravity([0, 1, 2].map(|k| x(39 + k)))
        },
        under(6, |y| { Medium::of(y, 45) })
    );
}

/// A force in proportion to mass is gravity, and has its gradient.
#[test]
fn a_uniform_field_has_the_gradient_of_gravity() {
    #[derive(Clone, Copy, Debug)]
    struct Field<T>([T; 3]);
    impl<T: Scalar, U: Scalar> catena::Lift<T, U> for Field<T> {
        type Over = Field<U>;
        fn lift(&self, number: &mut impl FnMut(T) -> U) -> Field<U> {
            Field(self.0.map(number))
        }
    }
    impl<T: Scalar> LoadLaw<BodyMotion<T>> for Field<T> {
        type Value = Wrench<T>;
        fn at(&self, _: T::Real, _: usize, motion: &BodyMotion<T>) -> Wrench<T> {
            motion.force_at(motion.inertia.centre, self.0.map(|g| g * motion.inertia.mass))
        }
    }
    let (list, gravity) = (bodies(3), [0.5, -9.0, 1.0]);
    let [one, two, three] = [0, 1, 2].map(|i| body::<f64>(core::array::from_fn(|k| list[13 * i + k])));
    let chain = (one, Branch((Ball, two)), Revolute::about([0.3, 1.0, -0.5]), three, Ball, Rod::uniform(0.5, 0.1, 0.8));
    let system = System::new(Pinned::origin(), chain, Free).unwrap();
    let mut noise = Noise::new(3);
    let mut random = || (0..10).map(|_| noise.next()).collect::<Vec<_>>();
    let start = system.with_rates(system.at_rest(&random()).unwrap(), &random()).unwrap();
    macro_rules! gradient {
        ($system:expr, $law:expr) => {{
            let system = $system;
            let mut states = [start; 11];
            let mut backward = system.backward(Rk4).under($law);
            backward.run(&start, 0.05, 10, &[], &mut states).unwrap();
            let end = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| match step {
                10 => by.add(&[1.0; 10], &core::array::from_fn::<_, 10, _>(|k| 1.0 + 0.1 * k as f64)),
                _ => Ok(()),
            };
            backward.gradient(&[], &states, &mut [], end).unwrap()
        }};
    }
    let pulled = gradient!(system.clone(), Field(gravity));
    let falling = gradient!(system.clone().with_gravity(gravity), Absent);
    let list = |by: Vector3<f64>| <[f64; 3]>::from(by);
    alike("a field", &[("field", 3)], pulled.by_loads().unwrap(), &list(falling.by_gravity()), ROUNDING);
    alike("a field", &[("attitudes", 10)], &pulled.by_position(), &falling.by_position(), ROUNDING);
    alike("a field", &[("rates", 10)], &pulled.by_rate(), &falling.by_rate(), ROUNDING);
}

/// A rod that spins about its axis against a torque −b ω: ω = ω₀ exp(−b t / J).
#[test]
fn a_spin_that_is_braked_has_the_gradient_of_an_exponential() {
    #[derive(Clone, Copy, Debug)]
    struct Brake<T> {
        brake: T,
    }
    catena::lift!(Brake { brake });
    impl<T: Scalar> LoadLaw<BodyMotion<T>> for Brake<T> {
        type Value = Wrench<T>;
        fn at(&self, _: T::Real, _: usize, motion: &BodyMotion<T>) -> Wrench<T> {
            Wrench::torque((motion.inboard.turn.spin * -self.brake).into())
        }
    }
    let rod = Rod::uniform(1.0, 0.2, 1.5);
    let (spin, brake, inertia, end) = (3.0, 0.04, rod.inertia().about_centre[0][0], 0.5);
    let system = System::new(Pinned::origin(), (rod,), Free).unwrap();
    let start = system.with_rates(system.at_rest(&[0.3, -0.4, 0.2]).unwrap(), &[spin, 0.0, 0.0]).unwrap();
    let (mut states, mut backward) = ([start; 51], system.backward(Dop853).under(Brake { brake }));
    backward.run(&start, end / 50.0, 50, &[], &mut states).unwrap();
    let of_end = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| match step {
        50 => by.add(&[0.0; 3], &[1.0, 0.0, 0.0]),
        _ => Ok(()),
    };
    let gradient = backward.gradient(&[], &states, &mut [], of_end).unwrap();
    let left = (-brake * end / inertia).exp();
    near(gradient.by_rate()[0], left, 1e-13);
    near(gradient.by_loads().unwrap()[0], -end / inertia * spin * left, 1e-12);
}

/// Feet on a slope, and wrenches as values: more numbers than are told one by one, of which all else has derivatives.
#[test]
fn contacts_and_values_have_the_gradients_of_jets() {
    with_room(|| {
        let kinds: Kinds = &[("bodies", 26), ("gravity", 3)];
        macro_rules! under {
            ($name:expr, $law:expr) => {
                gradients!(
                    $name,
                    kinds,
                    bodies(2),
                    [true; 2],
                    2,
                    Rk4,
                    4,
                    0.02,
                    |x| {
                        let of = |i: usize| body(core::array::from_fn(|k| x(13 * i + k)));
                        let root = Pinned::on([0.0; 3].map(N::constant));
                        System::new(root, (of(0), Ball, of(1)), Free)
                            .unwrap()
                            .with_gravity([0, 1, 2].map(|k| x(26 + k)))
                    },
                    under(0, |y| { $law(y(0)) })
                )
            };
        }
        under!("feet", feet);
        under!("values", values);
    });
}

/// Two points on a plane.
type Feet<T> = PlainContacts<[(usize, [T; 3]); 2], Plane<T>, Contact<T>>;

/// Points of both bodies on a slope that they are pressed into.
fn feet<T: Scalar>(_: T) -> Feet<T> {
    let of = |list: [f64; 3]| list.map(T::literal);
    let points = [(0, of([0.7, -0.1, 0.1])), (1, of([0.6, 0.1, -0.2]))];
    let law = Contact::new(T::literal(300.0), T::literal(0.05)).damped(T::literal(0.3));
    let slope = Plane::through(of([0.0, 0.0, 1.0]), of([-0.6, 0.0, 0.8]));
    Contacts::of(points, slope, law.rubbing(T::literal(0.4), T::literal(0.2))).plain()
}

/// A force and a torque on each body.
fn values<T: Scalar>(_: T) -> catena::loading::Values<[Wrench<T>; 2]> {
    let of = |x: f64, y: f64, z: f64| Vector3::new(T::literal(x), T::literal(y), T::literal(z));
    let wrench = |x: f64| Wrench { force: of(x, 0.5, -0.3), torque: of(0.2, x, 0.4) };
    catena::loading::Values([wrench(0.7), wrench(-0.4)])
}
