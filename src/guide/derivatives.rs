//! Derivatives: of what, by what, and which way is cheapest.
//!
//! | wanted | take | costs |
//! |---|---|---|
//! | anything by one or a few numbers | the same program over [`Jet`](crate::scalar::Jet)s or dual numbers | a run for each derivative, about |
//! | the end of a run by many initial values | a rule [`through_gains`](crate::sensitivity) | less: only values are eliminated |
//! | one number by everything (tuning, identification, optimal control) | [`System::backward`](crate::system::System::backward) | three runs, four to nine by implicit rules, where a tip is held or loops are closed and in robots, however many derivatives |
//! | one number of a run whose joints stick, slip and strike stops | [`Backward::course`](crate::sensitivity::Backward::course) | three runs, however many derivatives |
//! | outputs by inputs, either way, whichever costs less; products with the Hessian | [`differentiable!`](crate::differentiable!) | it says |
//! | Jacobians of single steps (iterative LQR, filters) | [`linearised_step`](crate::sensitivity::Backward::linearised_step), [`linearised_step_in_rows`](crate::sensitivity::Backward::linearised_step_in_rows) | less, several rows at a time |
//! | stiffness and mass about a rest | [`System::modes`](crate::system::System::modes), which has shapes and frequencies | |
//!
//! Forward, a scene is built over another number, and nothing else changes:
//!
//! ```
//! use catena::planar::*;
//! use catena::scalar::{Jet, Scalar};
//! type Number = Jet<f64, 1>;
//! /// Angle of a rod (rad) after a second, for its length (m).
//! fn angle<T: Scalar<Real = f64>>(length: T) -> Result<T, catena::Error> {
//!     let [mass, gravity] = [1.0, 9.81].map(T::literal); // (kg), (m/s²)
//!     let rod = System::new(Pinned::origin(), Rod::uniform(length, mass), Free)?;
//!     let rod = rod.with_gravity(gravity);
//!     let run = rod.simulate(rod.at_rest(&[T::literal(-1.0)])?, Rk4::step(1e-3), 1.0, |_| ())?;
//!     Ok(run.motion.coordinates()[0])
//! }
//! let slope = angle(Number::seed(1.0, 0))?.eps[0];
//! let difference = (angle(1.0 + 1e-6)? - angle(1.0 - 1e-6)?) / 2e-6;
//! assert!((slope - difference).abs() < 1e-6);
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! Backward, a run keeps its states, and a cost says what it gains by each:
//!
//! ```
//! use catena::planar::*;
//! let rod = Rod::uniform(1.0, 1.0);
//! let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
//! let start = pendulum.at_rest(&[-1.0, -0.5])?;
//! // Torques in both pins at each step (N·m).
//! let (torques, mut by_torques) = ([0.0; 2 * 100], [0.0; 2 * 100]);
//! let mut states = vec![start.clone(); 101];
//! let mut backward = pendulum.backward(Rk4);
//! backward.run(&start, 0.01, 100, &torques, &mut states)?;
//! let cost = |step: usize, _: &_, by: &mut catena::sensitivity::Costate<_>| match step {
//!     100 => by.add(&[0.0, 1.0], &[0.0, 0.0]), // the second angle at the end
//!     _ => Ok(()),
//! };
//! let gradient = backward.gradient(&torques, &states, &mut by_torques, cost)?;
//! assert!(gradient.by_position().len() == 2 && by_torques.iter().all(|x| x.is_finite()));
//! # Ok::<(), catena::Error>(())
//! ```
//!
//! Compare derivative parts explicitly: `==` of dual numbers sees the real part only. Over many times that it takes a perturbation to grow,
//! derivatives are exact and huge.
