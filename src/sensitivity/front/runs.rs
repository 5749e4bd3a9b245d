//! A macro that makes functions of numbers of runs.

/// Makes a [`Differentiable`](crate::sensitivity::Differentiable) of a run: a function of a list of numbers, the inputs, to some others,
/// the outputs.
///
/// It is given a name for the type of numbers, a [`Plan`](crate::sensitivity::Plan), a block that makes a scene and the motion in which
/// the run begins, a pair, from the inputs that are no torques (it may use `?` on this crate's errors), and one that is met before the
/// first step and after each step: it may change `y`, zeros each time, by what it reads of the scene, of the time and of positions and rates.
/// An output is the sum of what is left in its place over all these times. Accelerations, and the forces that hold a tip, are NaN there, and
/// outputs that are not finite an error ([`Fault::NotFinite`](crate::Fault::NotFinite)).
///
/// The scene is one of those that [`Backward`](crate::sensitivity::Backward#what-it-knows) knows, for its run goes both ways. Loads are the
/// plan's torques alone; what else acts stands in the scene, as springs and laws in joints, and all else does not compile.
///
/// Told to go `forward`, it takes all scenes, elements of your own and closures among them, and all methods, implicit ones too; derivatives then
/// cost a run over jets for each eight inputs. The method is that of a [`Stepper`](crate::simulate::Stepper): joints with dry
/// friction change their modes by [`MoreauJean`](crate::time::MoreauJean); those with hard stops are refused, for derivatives of its steps are not
/// those of shocks.
///
/// ```
/// use catena::planar::*;
/// use catena::sensitivity::{Plan, Way};
/// // Two rods, a stiff hinge between them, hence an implicit rule; a crank drives them by a function.
/// let plan = Plan { method: Sdirk4::new(), step: 0.01, steps: 20, torques: 0, outputs: 1 };
/// let driven = catena::differentiable!(forward Number, plan, |x| {
///     let speed = x[0];
///     let crank = Driven::new(Revolute::smooth(), move |time: f64| [speed.scale(time), speed, Number::literal(0.0)]);
///     let (rod, joint) = (Rod::uniform(x[1], Number::literal(1.0)), ElasticHinge::rotary(x[2]));
///     let arm = System::new(Clamped::origin(), (crank, rod, joint, rod), Free)?.with_gravity(Number::literal(9.81));
///     let start = arm.motion();
///     (arm, start)
/// }, |step, arm, now, y| if step == 20 {
///     // What the drive exerts (N·m): forces are found at positions and rates.
///     let now = arm.with_accelerations(*now, &Unloaded);
///     y[0] = now.and_then(|now| Ok(-arm.stations(&now, &Unloaded)?.root().internal.torque)).unwrap_or(y[0]);
/// });
/// let found = driven.jacobian(&[2.0, 0.5, 1e4])?; // rate, length, stiffness
/// # let at = |x: [f64; 3]| driven.jacobian(&x).map(|found| found.values[0]);
/// # for (k, by) in [1e-5, 1e-5, 1.0].into_iter().enumerate() {
/// #     let [mut above, mut below] = [[2.0, 0.5, 1e4]; 2];
/// #     (above[k], below[k]) = (above[k] + by, below[k] - by);
/// #     let expected = (at(above)? - at(below)?) / (2.0 * by);
/// #     assert!((found.rows[0][k] - expected).abs() < 1e-5 * (1.0 + expected.abs()), "{k}: {} {expected}", found.rows[0][k]);
/// # }
/// assert_eq!(found.way, Way::Forward);
/// # Ok::<(), catena::Error>(())
/// ```
///
/// Both are compiled for several kinds of numbers: constants in them are `Number::literal(1.0)`. An example:
/// [`gradient`](crate::sensitivity::Differentiable::gradient).
#[macro_export]
macro_rules! differentiable {
    (forward $Number:ident, $plan:expr, |$x:ident| $scene:expr, |$step:pat_param, $of:pat_param, $now:pat_param, $y:ident| $outputs:expr $(,)?) => {{
        #[allow(unused_imports)]
        use $crate::scalar::Scalar as _;
        let plan: $crate::sensitivity::Plan<_> = $plan;
        macro_rules! way {
            ($T:ty, $N:ty) => {
                $crate::differentiable!(@forward $T, $N, $Number, plan, |$x| $scene, |$step, $of, $now, $y| $outputs)
            };
        }
        let first = way!(f64, $crate::sensitivity::Seeded<f64>);
        let second = way!($crate::scalar::Jet<f64, 1>, $crate::sensitivity::Seeded<$crate::scalar::Jet<f64, 1>>);
        $crate::sensitivity::Differentiable::forward(plan.outputs, first, second)
    }};
    ($Number:ident, $plan:expr, |$x:ident| $scene:expr, |$step:pat_param, $of:pat_param, $now:pat_param, $y:ident| $outputs:expr $(,)?) => {{
        #[allow(unused_imports)]
        use $crate::scalar::Scalar as _;
        let plan: $crate::sensitivity::Plan<_> = $plan;
        macro_rules! ways {
            ($T:ty, $N:ty) => {(
                $crate::differentiable!(@forward $T, $N, $Number, plan, |$x| $scene, |$step, $of, $now, $y| $outputs),
                $crate::differentiable!(@backward $T, $N, $Number, plan, |$x| $scene, |$step, $of, $now, $y| $outputs),
            )};
        }
        let first = ways!(f64, $crate::sensitivity::Seeded<f64>);
        let second = ways!($crate::scalar::Jet<f64, 1>, $crate::sensitivity::Seeded<$crate::scalar::Jet<f64, 1>>);
        $crate::sensitivity::Differentiable::new(plan.outputs, first.0, first.1, second.0, second.1)
    }};
    (@forward $T:ty, $N:ty, $Number:ident, $plan:ident, |$x:ident| $scene:expr, |$step:pat_param, $of:pat_param, $now:pat_param, $y:ident| $outputs:expr) => {
        move |x: &[$T], first: usize| -> ::core::result::Result<_, $crate::Error> {
            use $crate::internals::front;
            #[allow(dead_code)]
            type $Number = $N;
            let (numbers, none) = (front::seeded(x, first), <$N>::literal(0.0));
            let (inputs, torques) = front::split(&numbers, $plan.torques)?;
            let make = |$x: &[$N]| -> ::core::result::Result<_, $crate::Error> { Ok($scene) };
            let (system, mut now) = make(inputs)?;
            front::goes_on($plan.step)?;
            let efforts = front::efforts(&system, torques, $plan.steps)?;
            let (begin, mut next, mut stepper) = (now.time(), now.clone(), system.stepper($plan.method));
            front::keeps_modes(&stepper)?;
            let mut list = front::Vec::new();
            list.resize($plan.outputs, none);
            for step in 0..=$plan.steps {
                let (shown, mut part) = (front::shown(now.clone()), front::Vec::new());
                part.resize($plan.outputs, none);
                {
                    let ($step, $of, $now, $y) = (step, &system, &shown, &mut part[..]);
                    $outputs;
                }
                front::known(&part)?;
                list.iter_mut().zip(part).for_each(|(sum, y)| *sum += y);
                if step < $plan.steps {
                    let held = front::held(&system, &efforts, step);
                    let end = front::time_after(begin, $plan.step, step + 1);
                    stepper.step(&now, &$crate::loading::Loads::none().efforts(held), end - now.time(), &mut next)?;
                    ::core::mem::swap(&mut now, &mut next);
                    now = now.at_time(end);
                }
            }
            Ok(list)
        }
    };
    (@backward $T:ty, $N:ty, $Number:ident, $plan:ident, |$x:ident| $scene:expr, |$step:pat_param, $of:pat_param, $now:pat_param, $y:ident| $outputs:expr) => {
        move |x: &[$T]| -> ::core::result::Result<_, $crate::Error> {
            use $crate::internals::front;
            let (inputs, torques) = front::split(x, $plan.torques)?;
            let (system, start) = {
                #[allow(dead_code)]
                type $Number = $T;
                let make = |$x: &[$T]| -> ::core::result::Result<_, $crate::Error> { Ok($scene) };
                make(inputs)?
            };
            #[allow(dead_code)]
            type $Number = $N;
            let make = |$x: &[$N]| -> ::core::result::Result<_, $crate::Error> { Ok($scene) };
            // Without seeds, and with eight of them each.
            let (still, _) = make(&front::seeded(inputs, front::NO_SEEDS))?;
            let mut scenes = front::Vec::new();
            for first in (0..inputs.len()).step_by(8) {
                scenes.push(make(&front::seeded(inputs, first))?);
            }
            let efforts = front::efforts(&system, torques, $plan.steps)?;
            let (mut by_efforts, mut states) = (efforts.clone(), front::Vec::new());
            states.resize($plan.steps + 1, start.clone());
            let mut run = system.backward($plan.method);
            run.run(&start, $plan.step, $plan.steps, &efforts, &mut states)?;
            let (rates, none) = (start.rate_count(), <$N>::literal(0.0));
            let (mut values, mut rows) = (front::Vec::new(), front::Vec::new());
            let (mut row, mut by_states) = (front::Vec::new(), front::Vec::new());
            row.resize(8 * scenes.len(), none.re);
            values.resize($plan.outputs, none.re);
            rows.resize($plan.outputs, row);
            by_states.resize($plan.outputs, front::Vec::new());
            // What outputs read of each state, the last first, which is how gradients meet them.
            for (step, state) in states.iter().enumerate().rev() {
                let numbers = (state.coordinates(), state.rates());
                let mut slopes = front::Vec::new();
                slopes.resize($plan.outputs, front::Vec::new());
                // By the state, and the value, of no coordinates too; then by what the outputs read of the scene itself.
                let by_state = (0..(2 * rates).max(1)).step_by(8).map(|first| (&still, first, None));
                let by_inputs = scenes.iter().enumerate().map(|(k, made)| (&made.0, front::NO_SEEDS, Some(k)));
                for (scene, first, block) in by_state.chain(by_inputs) {
                    let now = front::state(scene, (state.time(), &numbers.0, &numbers.1), first)?;
                    let mut list = front::Vec::new();
                    list.resize($plan.outputs, none);
                    {
                        let ($step, $of, $now, $y) = (step, scene, &now, &mut list[..]);
                        $outputs;
                    }
                    front::known(&list)?;
                    for (output, found) in list.into_iter().enumerate() {
                        if let Some(k) = block {
                            rows[output][8 * k..].iter_mut().zip(found.eps).for_each(|(sum, slope)| *sum += slope);
                        } else {
                            slopes[output].extend(found.eps);
                            values[output] += if first == 0 { found.re } else { none.re };
                        }
                    }
                }
                for (list, slopes) in by_states.iter_mut().zip(slopes) {
                    if slopes.iter().any(|slope| !slope.is_identical(none.re)) {
                        list.push((step, slopes));
                    }
                }
            }
            for (row, by_states) in rows.iter_mut().zip(by_states) {
                let mut by_states = by_states.into_iter().peekable();
                let gradient = run.gradient(&efforts, &states, &mut by_efforts, |step, _, by| {
                    by_states.next_if(|(of, _)| *of == step).map_or(Ok(()), |(_, slopes)| {
                        by.add(&slopes[..rates], &slopes[rates..2 * rates])
                    })
                })?;
                for ((scene, start), part) in scenes.iter().zip(row.chunks_exact_mut(8)) {
                    let (along, by) = (gradient.along(scene)?, gradient.along_start(start)?);
                    part.iter_mut().zip(along).zip(by).for_each(|((sum, a), b)| *sum += a + b);
                }
                row.truncate(inputs.len());
                by_efforts.iter().for_each(|effort| front::OfNumbers::add_to(effort, row));
            }
            Ok((values, rows))
        }
    };
}
