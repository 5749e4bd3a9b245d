//! A scene to be swept, and its size.

use catena::planar::{Rk4, Unloaded};
use catena::simulate::{Method, Stepper};
use catena::system::{Dynamics, Element, MotionOf, Position, Rate, Root, Runs, Space, System, Tip};
use catena::{Error, Motion};
use std::hint::black_box;

/// `size_of` what a run by RK4 needs.
#[derive(Clone, Copy, PartialEq)]
pub struct Bytes {
    pub scene: usize,
    pub motion: usize,
    pub stepper: usize,
}

/// Something that is counted.
pub trait Case {
    /// Sweeps, or steps, again and again.
    fn sweep(&mut self, times: usize);
    fn bodies(&self) -> usize;
    /// None of a loop by hand.
    fn bytes(&self) -> Option<Bytes>;
}

/// A row of the table.
pub struct Row {
    pub feature: &'static str,
    pub name: &'static str,
    pub make: Make,
}

type Make = Box<dyn Fn() -> Result<Box<dyn Case>, Error>>;

impl Row {
    /// Its name on the command line.
    pub fn word(&self) -> String {
        format!("{}/{}", self.feature, self.name).replace(' ', "-")
    }
}

pub fn row(
    feature: &'static str,
    name: &'static str,
    make: impl Fn() -> Result<Box<dyn Case>, Error> + 'static,
) -> Row {
    Row { feature, name, make: Box::new(make) }
}

/// A scene at one motion, under loads.
pub struct Swept<S, R, C, P, L>
where
    S: Space<Scalar = f64>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    System<S, R, C, P>: Runs<L, S, R, C, P>,
{
    scene: System<S, R, C, P>,
    loads: L,
    motion: MotionOf<S, R, C, P>,
    workspace: <System<S, R, C, P> as Dynamics<L>>::Workspace,
}

impl<S, R, C, P, L> Swept<S, R, C, P, L>
where
    S: Space<Scalar = f64>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    System<S, R, C, P>: Runs<L, S, R, C, P>,
{
    /// Folded and turning, nothing special.
    pub fn new(scene: System<S, R, C, P>, loads: L) -> Self {
        let mut motion = scene.motion();
        let (mut k, mut j) = (0.0, 0.0);
        motion.position_mut().replace(&mut |_| {
            k += 1.0;
            -0.3 + 0.5 * f64::sin(k)
        });
        motion.rate_mut().replace(&mut |_| {
            j += 1.0;
            0.5 * f64::cos(j)
        });
        let workspace = scene.workspace();
        Self { scene, loads, motion, workspace }
    }
}

/// One sweep. Not inlined, so that nothing is known about the arguments.
#[inline(never)]
fn sweep_once<D: Dynamics<L, Scalar = f64>, L>(
    scene: &D,
    position: &D::Position,
    rate: &D::Rate,
    loads: &L,
    workspace: &mut D::Workspace,
    acceleration: &mut D::Rate,
) {
    scene.accelerations(0.0, position, rate, loads, workspace, acceleration);
}

impl<S, R, C, P, L> Case for Swept<S, R, C, P, L>
where
    S: Space<Scalar = f64>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    System<S, R, C, P>: Runs<L, S, R, C, P>,
    for<'s> Rk4: Method<&'s System<S, R, C, P>, L>,
{
    fn sweep(&mut self, times: usize) {
        let mut acceleration = self.motion.rate().clone();
        for _ in 0..times {
            let Self { scene, loads, motion, workspace } = black_box(&mut *self);
            sweep_once(scene, motion.position(), motion.rate(), loads, workspace, &mut acceleration);
            black_box(&mut acceleration);
        }
    }
    fn bodies(&self) -> usize {
        self.scene.bodies()
    }
    fn bytes(&self) -> Option<Bytes> {
        let (scene, motion) = (size_of_val(&self.scene), size_of_val(&self.motion));
        Some(Bytes { scene, motion, stepper: size_of_val(&Method::<_, L>::stepper(&Rk4, &self.scene)) })
    }
}

/// How steps are made.
#[derive(Clone, Copy)]
pub enum Run {
    /// As a run that nobody observes.
    Simulated,
    /// By a stepper alone.
    Stepped,
}

struct Steps(Run);

impl Case for Steps {
    fn sweep(&mut self, times: usize) {
        if let Err(error) = crate::scenes::steps(self.0, times) {
            eprintln!("{error}");
        }
    }
    fn bodies(&self) -> usize {
        4 * 20 // four sweeps a step
    }
    fn bytes(&self) -> Option<Bytes> {
        None
    }
}

pub fn run_row(feature: &'static str, name: &'static str, how: Run) -> Row {
    row(feature, name, move || Ok(Box::new(Steps(how))))
}

/// Steps a scene by RK4.
pub fn steps<S, R, C, P>(
    scene: &System<S, R, C, P>,
    start: MotionOf<S, R, C, P>,
    how: Run,
    times: usize,
) -> Result<(), Error>
where
    S: Space<Scalar = f64>,
    R: Root<S>,
    C: Element<S>,
    P: Tip<S>,
    System<S, R, C, P>: Runs<Unloaded, S, R, C, P>,
    for<'s> Rk4: Method<&'s System<S, R, C, P>, Unloaded>,
    Motion<f64, catena::system::PositionOf<S, R, C>, P::Closures>: Clone,
{
    let dt = 1.0 / 65536.0;
    match how {
        Run::Simulated => {
            let run = scene.simulate(start, Rk4::step(dt), times as f64 * dt, |_| ())?;
            black_box(run.motion);
        }
        Run::Stepped => {
            let mut stepper = scene.stepper(Rk4);
            let (mut now, mut next) = (start.clone(), start);
            for _ in 0..times {
                stepper.advance(&now, &Unloaded, dt, &mut next)?;
                core::mem::swap(&mut now, &mut next);
            }
            black_box(now);
        }
    }
    Ok(())
}
