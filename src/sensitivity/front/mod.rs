//! Derivatives of a run by whatever it is made of: forward or backward, whichever costs less.

pub mod parts;
mod runs;

use crate::error::{Error, Fault, counted};
use crate::scalar::{Jet, Scalar};
use alloc::vec::Vec;

/// Derivatives that go forward at once.
pub(super) const WIDTH: usize = 8;
/// What a run over so many derivatives costs, in runs without (2 to 20 rods on pins, x86-64-v3: 4.5 to 7.6).
const FORWARD: f64 = 6.0;
/// What pulling the costates of one output back through a run costs (plane 1.7 to 1.9, space 2.0 to 2.7).
const BACKWARD: f64 = 1.9;

/// A number over which a run is built for derivatives that go forward.
pub type Seeded<T> = Jet<T, WIDTH>;

/// The steps of a run, and what it is a function of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan<M> {
    /// The explicit method.
    pub method: M,
    /// Size of a step (s).
    pub step: f64,
    /// Number of steps.
    pub steps: usize,
    /// How many of the inputs, the last ones, are torques in all joints, the root's first, held over the first step, then over the second,
    /// and so on; or over all steps; or none. A joint in space takes three.
    pub torques: usize,
    /// Number of outputs.
    pub outputs: usize,
}

/// Which way derivatives went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// Runs over jets of eight derivatives, as many as there are eights of inputs.
    Forward,
    /// One run, and costates pulled back through it for each output.
    Backward,
}

/// Outputs of a run, and their derivatives.
#[derive(Clone, Debug, PartialEq)]
pub struct Derivatives<T = f64> {
    /// Each output.
    pub values: Vec<T>,
    /// Derivatives of each output by all inputs.
    pub rows: Vec<Vec<T>>,
    /// Which way they went.
    pub way: Way,
    /// What that costs in runs without derivatives, as expected of open chains in the plane, without what outputs cost ([`Way::cheaper`]).
    pub runs: f64,
}

impl Way {
    /// The cheaper way for so many inputs and outputs, and what it costs in runs without derivatives: six for each eight inputs forward, 1.9
    /// for each output backward, and one, without what outputs cost: forward they are read once at each step for each eight inputs, backward for each eight
    /// coordinates, rates and inputs. Ten rods, eight inputs and the place of the tip at each of 200 steps take 11.5 runs backward, and 4.9 forward. That is estimated for open chains in the plane, whatever the scene. Backward, an output costs 2.0
    /// to 2.7 in space, and 4 to 8 where a tip is held or loops are closed (see [`Backward`](super::Backward#what-it-costs)): where both ways are near
    /// each other, and where outputs are read at many steps, [`jacobian_by`](Differentiable::jacobian_by) takes the one that the caller has measured to be cheaper.
    pub fn cheaper(inputs: usize, outputs: usize) -> (Self, f64) {
        let forward = FORWARD * inputs.div_ceil(WIDTH).max(1) as f64;
        let backward = 1.0 + BACKWARD * outputs as f64;
        if forward < backward { (Self::Forward, forward) } else { (Self::Backward, backward) }
    }
}

/// A run as a function of numbers, with derivatives: what [`differentiable!`](crate::differentiable!) makes.
///
/// Derivatives go forward or backward, whichever is expected to cost less ([`Way::cheaper`]), and results say which it was. Either way they
/// are those of the steps made.
#[derive(Clone, Copy, Debug)]
pub struct Differentiable<F, B, F2, B2> {
    outputs: usize,
    /// Whether there is a way back.
    both: bool,
    forward: F,
    backward: B,
    second_forward: F2,
    second_backward: B2,
}

/// A way back that there is not.
type NoWay<T> = fn(&[T]) -> Result<Rows<T>, Error>;

impl<F, F2> Differentiable<F, NoWay<f64>, F2, NoWay<Jet<f64, 1>>> {
    #[doc(hidden)]
    pub fn forward(outputs: usize, forward: F, second_forward: F2) -> Self {
        Self { outputs, both: false, forward, backward: no_way, second_forward, second_backward: no_way }
    }
}

fn no_way<T>(_: &[T]) -> Result<Rows<T>, Error> {
    let what = "derivatives backward of what `differentiable!` was told to go `forward`";
    Err(Error::new(Fault::Unsupported { what }))
}

/// Values and rows.
type Rows<T> = (Vec<T>, Vec<Vec<T>>);

impl<F, B, F2, B2> Differentiable<F, B, F2, B2>
where
    F: Fn(&[f64], usize) -> Result<Vec<Seeded<f64>>, Error>,
    B: Fn(&[f64]) -> Result<Rows<f64>, Error>,
    F2: Fn(&[Jet<f64, 1>], usize) -> Result<Vec<Seeded<Jet<f64, 1>>>, Error>,
    B2: Fn(&[Jet<f64, 1>]) -> Result<Rows<Jet<f64, 1>>, Error>,
{
    #[doc(hidden)]
    pub fn new(outputs: usize, forward: F, backward: B, second_forward: F2, second_backward: B2) -> Self {
        Self { outputs, both: true, forward, backward, second_forward, second_backward }
    }

    /// The way that derivatives by so many inputs go.
    fn way(&self, inputs: usize) -> Way {
        if self.both { Way::cheaper(inputs, self.outputs).0 } else { Way::Forward }
    }

    /// All outputs, and their derivatives by all inputs.
    ///
    /// A step is linearised as a run of one step, whose outputs are its coordinates and rates, with as many inputs and the torques:
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::sensitivity::{Plan, Way};
    /// let plan = Plan { method: Rk4, step: 0.01, steps: 1, torques: 2, outputs: 4 };
    /// let step = catena::differentiable!(Number, plan, |x| {
    ///     let rod = Rod::uniform(Number::literal(1.0), Number::literal(1.0));
    ///     let arm = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(Number::literal(9.81));
    ///     let start = arm.with_rates(arm.at_rest(&x[..2])?, &x[2..4])?;
    ///     (arm, start)
    /// }, |step, _arm, now, y| if step == 1 {
    ///     y.copy_from_slice(&[now.coordinates(), now.rates()].concat());
    /// });
    /// let found = step.jacobian(&[-1.0, -0.5, 0.0, 0.0, 0.3, -0.1])?; // angles, rates, torques
    /// let (a, b) = (&found.rows[1][..4], &found.rows[1][4..]); // of the second angle
    /// assert!((a[3] - 0.01).abs() < 1e-4 && b[0] < 0.0 && found.way == Way::Forward);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// Backward, what outputs read of states is kept until their gradients meet it: two numbers a freedom for each output and state that it
    /// reads. Sums over all steps of many outputs are better run on by the scene, or asked for some at a time.
    ///
    /// # Errors
    /// Those of the scene's constructor, of the run, and of [`Backward`](super::Backward); [`Fault::Count`](crate::Fault::Count) where the
    /// plan's torques are more than the inputs, or fit neither one step nor all; [`Fault::NotFinite`](crate::Fault::NotFinite) where an output
    /// is no number, as are those that read accelerations.
    pub fn jacobian(&self, x: &[f64]) -> Result<Derivatives, Error> {
        self.jacobian_by(x, self.way(x.len()))
    }

    /// All outputs and their derivatives, by a way that the caller has chosen.
    ///
    /// # Errors
    /// As [`jacobian`](Self::jacobian).
    pub fn jacobian_by(&self, x: &[f64], way: Way) -> Result<Derivatives, Error> {
        derivatives(x, self.outputs, way, &self.forward, &self.backward)
    }

    /// The first output, and its derivatives by all inputs.
    ///
    /// ```
    /// use catena::planar::*;
    /// use catena::sensitivity::{Plan, Way};
    /// let plan = Plan { method: Rk4, step: 0.01, steps: 100, torques: 0, outputs: 1 };
    /// let swing = catena::differentiable!(Number, plan, |x| {
    ///     let rod = Rod::uniform(x[0], Number::literal(1.0)); // a length (m)
    ///     let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(x[1]);
    ///     let start = pendulum.at_rest(&x[2..])?;
    ///     (pendulum, start)
    /// }, |step, pendulum, now, y| if step == 100 {
    ///     y[0] = pendulum.stations(now, &Unloaded).map_or(y[0], |stations| stations.tip().frame.place.x);
    /// });
    /// let (value, by) = swing.gradient(&[1.0, 9.81, -1.0, -0.5])?;
    /// # let at = |length: f64| swing.gradient(&[length, 9.81, -1.0, -0.5]).map(|found| found.0);
    /// # assert!((by.rows[0][0] - (at(1.00001)? - at(0.99999)?) / 2e-5).abs() < 1e-7);
    /// assert!(value == by.values[0] && by.rows[0].len() == 4 && by.way == Way::Backward);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`jacobian`](Self::jacobian); [`Fault::Count`](crate::Fault::Count) where there is no output.
    pub fn gradient(&self, x: &[f64]) -> Result<(f64, Derivatives), Error> {
        let found = self.jacobian(x)?;
        let value = found.values.first().copied().ok_or(Error::new(crate::Fault::Count {
            list: "outputs",
            expected: 1,
            given: 0,
        }))?;
        Ok((value, found))
    }

    /// Each output, and its second derivatives times a direction, in rows: how the [Jacobian](Self::jacobian) changes along it. One product costs
    /// some three Jacobians, however many inputs there are: it is found the same way, on jets of one derivative along the direction.
    ///
    /// ```
    /// # use catena::planar::*;
    /// # use catena::sensitivity::Plan;
    /// let plan = Plan { method: Rk4, step: 0.01, steps: 50, torques: 100, outputs: 1 };
    /// let effort = catena::differentiable!(Number, plan, |x| {
    ///     let rod = Rod::uniform(Number::literal(1.0), Number::literal(1.0));
    ///     let arm = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(Number::literal(9.81));
    ///     let start = arm.at_rest(&x[..2])?;
    ///     (arm, start)
    /// }, |step, _arm, now, y| if step == 50 {
    ///     y[0] = now.coordinates()[1] * now.coordinates()[1];
    /// });
    /// let (mut x, mut direction) = ([0.1; 102], [0.0; 102]); // two angles, two torques at each of 50 steps
    /// (x[0], direction[7]) = (-1.0, 1.0);
    /// let column = effort.hessian_times(&x, &direction)?; // of the Hessian: by the torque x[7], and by each input
    /// # let slope = |x7: f64| { x[7] = x7; effort.gradient(&x).map(|found| found.1.rows[0][0]) };
    /// # let mut slope = slope;
    /// # assert!((column.rows[0][0] - (slope(0.101)? - slope(0.099)?) / 2e-3).abs() < 1e-9);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// Where inputs displace attitudes in space, second derivatives are those of the displacements that the scene's constructor makes.
    ///
    /// # Errors
    /// As [`jacobian`](Self::jacobian); [`Fault::Count`](crate::Fault::Count) for a direction of another length.
    pub fn hessian_times(&self, x: &[f64], direction: &[f64]) -> Result<Derivatives, Error> {
        counted("numbers of a direction", x.len(), direction.len())?;
        let along: Vec<_> = x.iter().zip(direction).map(|(re, eps)| Jet { re: *re, eps: [*eps] }).collect();
        let way = self.way(x.len());
        let found = derivatives(&along, self.outputs, way, &self.second_forward, &self.second_backward)?;
        let rows = found.rows.into_iter().map(|row| row.into_iter().map(|jet| jet.eps[0]).collect()).collect();
        let values = found.values.into_iter().map(|jet| jet.re).collect();
        Ok(Derivatives { values, rows, way, runs: 3.0 * found.runs })
    }
}

/// By either way.
fn derivatives<T: Scalar>(
    x: &[T],
    outputs: usize,
    way: Way,
    forward: &impl Fn(&[T], usize) -> Result<Vec<Seeded<T>>, Error>,
    backward: &impl Fn(&[T]) -> Result<Rows<T>, Error>,
) -> Result<Derivatives<T>, Error> {
    let blocks = x.len().div_ceil(WIDTH).max(1);
    let (values, rows) = match way {
        Way::Backward => backward(x)?,
        Way::Forward => {
            let (mut values, mut rows) = (Vec::new(), alloc::vec![Vec::with_capacity(x.len()); outputs]);
            for block in 0..blocks {
                let found = forward(x, WIDTH * block)?;
                let width = (x.len() - WIDTH * block).min(WIDTH);
                rows.iter_mut().zip(&found).for_each(|(row, y)| row.extend_from_slice(&y.eps[..width]));
                values = found.into_iter().map(|y| y.re).collect();
            }
            (values, rows)
        }
    };
    let runs = match way {
        Way::Forward => FORWARD * blocks as f64,
        Way::Backward => 1.0 + BACKWARD * outputs as f64,
    };
    Ok(Derivatives { values, rows, way, runs })
}
