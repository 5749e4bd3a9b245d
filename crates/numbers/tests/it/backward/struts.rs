//! Gradients of runs under struts, alone and beside a law of loads.

use super::loads::Medium;
use super::names::*;
use catena::sensitivity::{Checkpoints, Costate};

/// Numbers of a strut between bodies, of one to the ground, of the laws of both, and of a medium.
const NUMBERS: [f64; 23] = [
    0.3, 0.1, 0.5, -0.2, 9.0, 0.4, 0.6, 0.4, -0.1, 1.5, 1.2, 14.0, 0.3, 0.5, 0.7, 0.06, 1.1, 0.04, 0.4, 7.0, 0.5, 0.8,
    0.05,
];
/// What they are.
const KINDS: [(&str, usize); 8] = [
    ("ends on bodies", 4),
    ("a spring, damper and length", 3),
    ("an end on a body", 2),
    ("an end on the ground", 2),
    ("another spring, damper and length", 3),
    ("laws of struts", 4),
    ("law: drag and spring", 2),
    ("law: anchor and brake", 3),
];

/// Struts between the numbered bodies, and a medium.
#[allow(clippy::type_complexity)] // two in one
fn struts<T: Scalar>(
    bodies: [usize; 3],
    number: impl Fn(usize) -> T,
) -> ([Strut<T, 2, Custom<Stiffening<T>>>; 2], Medium<T>) {
    let point = |k: usize| [number(k), number(k + 1)];
    let with = |strut: Strut<T, 2>, k: usize, law: usize| {
        let strut = strut.with_stiffness(number(k)).with_damping(number(k + 1)).with_length(number(k + 2));
        strut.with_law(Custom(Stiffening { stiffness: number(law), damping: number(law + 1) }))
    };
    let inside = with(Strut::between((bodies[0], point(0)), (bodies[1], point(2))), 4, 14);
    let outside = with(Strut::to_ground((bodies[2], point(7)), point(9)), 11, 16);
    let medium = Medium { drag: number(18), stiffness: number(19), anchor: point(20), brake: number(22) };
    ([inside, outside], medium)
}

/// All bodies and joints, an arm, a clamped root at a place: by all of it, and by the numbers of struts, one of them between arms.
#[test]
fn trees_under_struts_have_the_gradients_of_jets() {
    let (steps, coordinates, joints) = (5, 6, 8);
    let mut noise = Noise::new(17);
    let mut list = TREE.to_vec();
    list.extend(NUMBERS);
    list.extend(moving(&mut noise, coordinates, steps * joints));
    let mut kinds = OF_TREE.to_vec();
    kinds.extend(KINDS);
    kinds.extend([("coordinates", coordinates), ("rates", coordinates), ("efforts", steps * joints)]);
    gradients!(
        "struts",
        &kinds,
        list,
        [coordinates, joints],
        Rk4,
        steps,
        0.02,
        |x| { tree!(N, x) },
        pulled(23, |x| { struts([1, 5, 3], |k| x(22 + k)) })
    );
}

/// A rod, a window, and a rod whose tip is held, crossed by a strut and pulled at by another: by numbers of both, through steps of a rule,
/// against central differences.
#[test]
fn closed_scenes_under_struts_have_the_gradients_of_differences() {
    const STEPS: usize = 4;
    let rod = |length| Rod::uniform(length, length);
    let window = Network::new((Pin, rod(0.5), Pin, rod(0.6)), (Pin, rod(0.55), Pin, rod(0.5)), Pin);
    let tip = Pinned::at(0.9, -0.8);
    let scene = System::new(Pinned::origin(), (rod(0.6), window, Pin, rod(0.9)), tip).unwrap().with_gravity(9.81);
    let guess = scene.at_rest(&[-1.2, -0.4, -1.6, -1.5, -0.5, 0.4]).unwrap();
    let start = scene.assembled(guess, &Unloaded).unwrap();
    let of = |number: &dyn Fn(usize) -> f64| struts([0, 3, 5], number).0;
    macro_rules! closed {
        ($method:expr) => {{
            let (mut backward, mut states) =
                (scene.backward($method).under(Struts::of(of(&|k| NUMBERS[k]))), vec![start; STEPS + 1]);
            backward.run(&start, 0.02, STEPS, &[], &mut states).unwrap();
            let gradient = backward
                .gradient(&[], &states, &mut [], |step, _, by: &mut Costate<_>| match step {
                    STEPS => by.add(&[0.0, 1.0, 0.0, 0.0, 0.0, 0.0], &[0.0, 0.0, 0.5, 0.0, 0.0, 0.0]),
                    _ => Ok(()),
                })
                .unwrap();
            let seeds = struts([0, 3, 5], |k| Jet::<f64, 18>::seed(NUMBERS[k], k)).0;
            let found = gradient.along_struts(&seeds);
            let end = |j: usize, e: f64| {
                let loads = Struts::of(of(&|k| NUMBERS[k] + if k == j { e } else { 0.0 }));
                let (mut now, mut next, mut stepper) = (states[0], start, scene.stepper($method));
                for _ in 0..STEPS {
                    stepper.step(&now, &loads, 0.02, &mut next).unwrap();
                    core::mem::swap(&mut now, &mut next);
                }
                now.coordinates()[1] + 0.5 * now.rates()[2]
            };
            let difference = |j: usize| {
                let e = 1e-4;
                (8.0 * (end(j, e) - end(j, -e)) - (end(j, 2.0 * e) - end(j, -2.0 * e))) / (12.0 * e)
            };
            let expected: Vec<f64> = (0..18).map(difference).collect();
            let name = format!("closed, under struts, {:?}", $method);
            alike(&name, &KINDS[..6], &found, &expected, 1e-6);
        }};
    }
    closed!(Rk4);
    closed!(Dop853);
    closed!(Sdirk4::new());
    closed!(GeneralizedAlpha::new(0.8).with_sweeps(3));
}

/// Of a law of more numbers than there is room for no derivative would be told: refused.
#[test]
fn laws_of_many_numbers_are_refused() -> Result<(), catena::Error> {
    #[derive(Clone, Copy, Debug)]
    struct Many<T> {
        numbers: [T; 7],
    }
    catena::lift!(Many<T> { numbers });
    impl<T: Scalar> SpringLaw<T> for Many<T> {
        fn force(&self, position: T, _: T) -> T {
            -self.numbers[6] * position
        }
        fn energy(&self, position: T) -> T {
            self.numbers[6] * position * position * T::literal(0.5)
        }
        fn pivot(&self, _: T, _: T, springs: impl Springs<T>) -> T {
            springs.pivot(self.numbers[6], T::zero())
        }
        fn check(&self) -> Result<(), catena::Fault> {
            Ok(())
        }
    }
    let scene = System::new(Pinned::origin(), Rod::uniform(1.0, 1.0), Free)?;
    let strut = Strut::to_ground((0, [0.5, 0.0]), [0.5, 1.0]).with_law(Custom(Many { numbers: [1.0; 7] }));
    let (start, struts) = (scene.at_rest(&[0.3])?, Struts::of([strut]));
    let mut states = [start; 3];
    let mut backward = scene.backward(Rk4).under(struts.and(Loads::none()));
    backward.run(&start, 0.1, 2, &[], &mut states)?;
    let refused = backward.gradient(&[], &states, &mut [], |_, _, _| Ok(())).map(|_| ()).unwrap_err().fault;
    assert_eq!(refused, catena::Fault::Count { list: "numbers of a law of a strut", expected: 6, given: 7 });
    Ok(())
}

/// A spring without length, whose ends meet on the way: its force is that of a law of loads, and so is its gradient.
#[test]
fn a_spring_without_length_has_the_gradient_of_a_law() {
    /// A spring from the outboard end of the second body to a place.
    #[derive(Clone, Copy, Debug)]
    struct Pull<T>([T; 2], T);
    impl<T: Scalar, U: Scalar> catena::Lift<T, U> for Pull<T> {
        type Over = Pull<U>;
        fn lift(&self, number: &mut impl FnMut(T) -> U) -> Pull<U> {
            Pull(self.0.map(&mut *number), number(self.1))
        }
    }
    impl<T: Scalar> catena::loading::LoadLaw<BodyMotion<T>> for Pull<T> {
        type Value = Wrench<T>;
        fn at(&self, _: T::Real, body: usize, motion: &BodyMotion<T>) -> Wrench<T> {
            let force = catena::nalgebra::Vector2::from(self.0) - motion.outboard().place;
            let force = if body == 1 { force * self.1 } else { force * T::zero() };
            Wrench { force, torque: motion.arm.perp(&force) }
        }
    }
    let rod = Rod::uniform(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free).unwrap().with_gravity(9.81);
    let start = scene.at_rest(&[0.0, 0.5]).unwrap();
    // Where the tip is in the beginning.
    let place = [1.0 + 0.5_f64.cos(), 0.5_f64.sin()];
    macro_rules! gradient {
        ($loads:expr) => {{
            let (mut backward, mut states) = (scene.backward(Rk4).under($loads), [start; 21]);
            backward.run(&start, 0.02, 20, &[], &mut states).unwrap();
            let cost = |_: usize, _: &_, by: &mut Costate<_>| by.add(&[0.0, 1.0], &[0.5, 0.0]);
            backward.gradient(&[], &states, &mut [], cost).unwrap()
        }};
    }
    let law = gradient!(Pull(place, 30.0));
    let strut = gradient!(Struts::of([Strut::to_ground((1, [1.0, 0.0]), place).with_stiffness(30.0)]));
    let [by] = strut.by_struts();
    assert!(by.ends.iter().flatten().chain([&by.damping, &by.length]).all(|x| x.is_finite()), "{by:?}");
    let found: Vec<f64> = by.ends[1].iter().copied().chain([by.stiffness]).collect();
    alike("a spring", &[("place", 2), ("stiffness", 1)], &found, law.by_loads().unwrap(), ROUNDING);
    alike("a spring", &[("angles", 2)], &strut.by_position(), &law.by_position(), ROUNDING);
    alike("a spring", &[("gravity", 1)], &[strut.by_gravity().y], &[law.by_gravity().y], ROUNDING);
}

/// Runs up to an event, under error control; on a tape and from few states as from all, bit for bit; a strut to a body that is not there is
/// refused.
#[test]
fn runs_under_struts_are_runs_as_all() {
    let rod = Rod::uniform(1.0, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free).unwrap().with_gravity(9.81);
    let start = scene.at_rest(&[-1.0, -0.5]).unwrap();
    let cable = |stiffness: f64| {
        Struts::of([Strut::to_ground((1, [1.0, 0.0]), [2.0, 1.0]).with_stiffness(stiffness).with_length(0.5)])
    };
    // When has the first rod swung to 1.2 rad below the horizontal?
    let swung = |angle: f64| angle + 1.2;
    let mut backward = scene.backward(Dopri5).under(cable(10.0));
    let mut states = vec![start; 400];
    let steps = backward.run_adaptive(&start, 1e-9, 2.0, &[], &mut states).unwrap();
    let last = backward.cut(&[], &mut states[..=steps], |state| swung(state.coordinates()[0])).unwrap().unwrap();
    let time = |step: usize, _: &_, by: &mut Costate<_>| {
        by.time += if step == last { 1.0 } else { 0.0 };
        Ok(())
    };
    let gradient = backward
        .gradient_to_event(&[], &states[..=last], &mut [], time, |_, by| by.add(&[1.0, 0.0], &[0.0, 0.0]))
        .unwrap();
    let when = |stiffness: f64| {
        let loads = cable(stiffness);
        let run = scene
            .simulation(Dop853::tolerance(1e-13))
            .loads(&loads)
            .event(|now| swung(now.motion().coordinates()[0]))
            .stopping();
        run.run(start, 2.0, |_| ()).unwrap().motion.time()
    };
    let expected = (when(10.001) - when(9.999)) / 0.002;
    let found = gradient.by_struts()[0].stiffness;
    near(found, expected, 1e-6 * expected.abs());

    let plan = Checkpoints { step: 0.05, steps: 4, every: 3 };
    let mut backward = scene.backward(Rk4).under(cable(10.0));
    let (mut all, mut few) = ([start; 5], vec![start; plan.states()]);
    let (mut tape, mut end) = (vec![backward.tape(); 4], start);
    let cost =
        |step: usize, _: &_, by: &mut Costate<_>| if step == 4 { by.add(&[1.0, 0.5], &[0.2; 2]) } else { Ok(()) };
    backward.run(&start, plan.step, plan.steps, &[], &mut all).unwrap();
    let whole = backward.gradient(&[], &all, &mut [], cost).unwrap();
    backward.run_on_tape(&start, plan.step, plan.steps, &[], &mut tape, &mut end).unwrap();
    let taped = backward.gradient_on_tape(4, &tape, &end, &mut [], cost).unwrap();
    backward.run_between(&start, plan, &[], &mut few).unwrap();
    let between = backward.gradient_between(plan, &[], &few, &mut tape, &mut [], cost).unwrap();
    assert!(whole.by_struts()[0].stiffness != 0.0);
    for other in [taped, between] {
        assert_eq!(other.by_struts(), whole.by_struts());
        assert_eq!(other.by_position(), whole.by_position());
    }

    let nowhere = Struts::of([Strut::to_ground((2, [1.0, 0.0]), [2.0, 1.0]).with_stiffness(1.0)]);
    let fault = scene.backward(Rk4).under(nowhere).run(&start, 0.01, 1, &[], &mut states).unwrap_err().fault;
    assert!(matches!(fault, catena::Fault::NoSuchBody { body: 2, bodies: 2 }), "{fault:?}");
}

/// A rope that hangs slack for more than half of a run, and a buffer that is pressed for a part of it: by all their numbers, against jets.
#[test]
fn ropes_and_buffers_have_the_gradients_of_jets() -> Result<(), catena::Error> {
    macro_rules! arm {
        ($x:expr, $T:ty) => {{
            let (x, of): (&[$T], _) = (&$x, <$T as Scalar>::literal);
            let rod = Rod::uniform(of(1.0), of(1.0));
            let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(of(9.81));
            let rope = Strut::to_ground((1, [of(0.9), of(0.05)]), [x[3], of(0.6)]).with_stiffness(x[0]);
            let buffer = Strut::between((0, [of(0.3), x[7]]), (1, [of(0.6), of(0.0)])).with_stiffness(x[4]);
            let (rope, buffer) =
                (rope.with_damping(x[1]).with_length(x[2]), buffer.with_damping(x[5]).with_length(x[6]));
            let start = scene.at_rest(&[of(0.4), of(-0.3)])?;
            (scene, start, [rope.pulling(), buffer.pushing()])
        }};
    }
    // Without dampers, whose forces would jump.
    let x = [300.0, 0.0, 0.8, 1.6, 500.0, 0.0, 1.2, 0.02];
    let (scene, start, struts) = arm!(x, f64);
    let (loads, mut states) = (Struts::of(struts), vec![start; 301]);
    let mut backward = scene.backward(Rk4).under(loads);
    backward.run(&start, 0.005, 300, &[], &mut states)?;
    let gradient =
        backward.gradient(
            &[],
            &states,
            &mut [],
            |step, _, by| {
                if step == 300 { by.add(&[0.0, 1.0], &[0.0; 2]) } else { Ok(()) }
            },
        )?;
    for k in 0..2 {
        let acts =
            states.iter().filter(|state| loads.readings(&scene, state).is_ok_and(|found| found[k].tension != 0.0));
        let acts = acts.count();
        assert!((10..290).contains(&acts), "strut {k} acts in {acts} states");
    }
    let seeds: Vec<_> = (0..).zip(x).map(|(k, x)| Jet::<f64, 8>::seed(x, k)).collect();
    let (scene, start, struts) = arm!(seeds, Jet<f64, 8>);
    let found = gradient.along_struts(&struts);
    let loads = Struts::of(struts);
    let run =
        scene.simulation(Rk4::step(0.005)).loads(&loads).run(start, 1.5, |_| ()).map_err(|stopped| stopped.error)?;
    let expected = run.motion.coordinates()[1].eps;
    let largest = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (found, expected) in found.iter().zip(expected) {
        near(*found, expected, ROUNDING * largest);
    }
    // With a force that sets in: refused, for costates do not know how its instant changes.
    let (scene, start, [rope, buffer]) = arm!(x, f64);
    let gradient = |struts: &dyn Fn(&mut Vec<_>) -> Result<(), catena::Error>| {
        let mut states = vec![start; 301];
        struts(&mut states)
    };
    macro_rules! jumps {
        ($struts:expr) => {
            gradient(&|states| {
                let mut backward = scene.backward(Rk4).under(Struts::of($struts));
                backward.run(&start, 0.005, 300, &[], states)?;
                backward.gradient(&[], states, &mut [], |_, _, _| Ok(())).map(|_| ())
            })
            .is_err_and(|error| matches!(error.fault, catena::Fault::Unsupported { what } if what.contains("jumps")))
        };
    }
    assert!(jumps!([rope.with_damping(4.0), buffer]) && jumps!([rope, buffer.with_damping(3.0)]));
    assert!(jumps!([rope.with_law(Spring::damping(4.0)), buffer.with_law(Spring::damping(0.0))]));
    // One that is zero at the length does not jump.
    let soft = Spring::new(20.0).damped(0.0).resting_at(0.8);
    assert!(!jumps!([rope.with_law(soft), buffer.with_law(Spring::new(0.0).damped(0.0).resting_at(0.0))]));
    Ok(())
}
