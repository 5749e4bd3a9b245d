//! Choosing a rule of time: by what the scene is, then by the error that it may have.
//!
//! | the scene | the rule | why |
//! |---|---|---|
//! | anything, to begin with | `Dop853::tolerance(1e-9)` | order 8, dense output, twelve sweeps a step |
//! | what you do not know, stiff or not | `Auto::tolerance(1e-6)` | it tries, and tells what it chose |
//! | the same, where `Taylor::<24>::knows(&scene)` compiles | `AutoTaylor::<24>::tolerance(1e-6)` | up to 2.6 times less time than `Auto` |
//! | rods, bodies, pins, sliders and springs in the plane, torques over time | `Taylor::<24>::tolerance(1e-12)` | one sweep's gains for all orders: 1.2 to 2.8 times less time than DOP853 where no joint slides; joints that are [driven](crate::planar::Driven) it does not know |
//! | rods on balls in space, to many digits | `Taylor::<24>::tolerance(1e-12)` | likewise: 1.2 to 1.5 times less time than DOP853 at 1e-9, 1.4 to 2.4 times at 1e-12 |
//! | many bodies, costly loads | `Vcabm::new().tolerance(1e-9)` | one sweep a step |
//! | a controller's step of fixed size | `Rk4::step(1e-3)` | four sweeps, the same time always |
//! | real time, with contacts, friction or stops | `MoreauJean::step(1e-3)` | one sweep a step, stable at any stiffness, order one |
//! | stiff springs, vibration not of interest | `GeneralizedAlpha::new(0.8)` `.step(1e-2)` | steps as long as the motion, whatever the stiffness |
//! | stiff springs, to more digits | `Sdirk4::new().step(1e-2)` | order 4 at any stiffness of springs and dampers |
//! | thousands of runs from near starts | `Rk4::step(..)` in lanes | lanes share their steps: see [`lanes_and_threads`](super::lanes_and_threads) |
//!
//! All are in [`planar`](crate::planar) and in [`spatial`](crate::spatial); [`time`](crate::time) has what each is made of.
//!
//! # What an error costs
//!
#![doc = concat!("<div>\n", include_str!("../../docs/pictures/work_precision.svg"), "\n</div>")]
//!
//! Each rule under error control, RK4 with fixed steps; the motions are not stiff, and implicit rules pay without gain. A higher order wins
//! sooner than one thinks: what an error of 1e-9 costs by order 8 an order of 4 pays for 1e-6.
//!
//! ```
//! use catena::planar::*;
//! let rod = Rod::uniform(1.0, 1.0);
//! let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
//! let start = || pendulum.at_rest(&[-1.0, -0.5]);
//! let exact = pendulum.simulate(start()?, Taylor::<20>::tolerance(1e-15), 2.0, |_| ())?.motion;
//! let error = |rates: Vec<f64>| (rates[1] - exact.rates()[1]).abs(); // (rad/s)
//!
//! let by_rk4 = pendulum.simulate(start()?, Rk4::step(2e-3), 2.0, |_| ())?;
//! let by_dop853 = pendulum.simulate(start()?, Dop853::tolerance(1e-10), 2.0, |_| ())?;
//! assert!(error(by_dop853.motion.rates()) < error(by_rk4.motion.rates()));
//! assert!(by_dop853.sweeps < by_rk4.sweeps / 3);
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! # Tolerances
//!
//! A tolerance is that of each step, absolute (rad, m, and these per second) and relative; by `GeneralizedAlpha` of positions alone, so that
//! rates, and what else stands in rates, may be far off. Errors of a run add up, and where the motion is chaotic they grow. Halve what you ask for and compare: two runs that agree to six digits have them. Below rounding
//! (2.2e-16) a tolerance is refused.
//!
//! # Stiffness
//!
//! An explicit rule needs steps below some 2.8 / ω (RK4) of the fastest vibration, seen or not. If a run takes far more steps
//! than its motion has turns, ask [`modes`](crate::system::System::modes) for the highest frequency, and take an implicit rule. On taut
//! ropes the stiffness is that of tension, which implicit rules do not know: see their pages; nor do they know what loads and force elements
//! make of positions and rates, which they read where the sweep before has led: a load that goes with the rate of a stiffly damped joint costs them
//! one order or two, and beyond that damping the run. Laws of joints, stiff struts and contacts they know. `Auto` finds the fastest rate of springs by itself.
//!
//! # Single precision
//!
//! Over `f32` long chains at rest have motions so small that their products are subnormal, and slow: up to half as much time again. Where a
//! program may set its processor's flush-to-zero mode, they take what `f64` takes.
