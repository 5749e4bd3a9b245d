//! What of the furniture of joints becomes laws of a scene's joints.

use crate::error::Error;
use crate::model::Furniture;
use crate::options::fits;
use crate::robot::{Body, Robot};

/// Which furniture of joints the scene acts by; the default is none. Limits, damping and friction of the description are constants of
/// the module in any case.
///
/// ```
/// use catena_urdf::Laws;
/// // Friction sets in over 0.01 rad/s (or m/s); stops over 0.02 rad (2 mm), with damping 1 s/rad (10 s/m).
/// let laws = Laws::none().damping().friction([0.01, 0.01]).stops([0.02, 0.002], [1.0, 10.0]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[must_use]
pub struct Laws {
    damping: bool,
    friction: Option<[f64; 2]>,
    sticking: bool,
    stops: Option<[[f64; 2]; 2]>,
    hard_stops: Option<f64>,
    motors: bool,
}

/// A compliant stop at both limits of a joint.
pub(crate) struct Stops {
    pub range: [f64; 2],
    pub stiffness: f64,
    pub depth: f64,
    pub damping: f64,
}

/// A motor behind a gear.
pub(crate) struct Motor {
    /// Largest torque of the motor (N·m, N), velocity without load and torque at rest, were that not limited.
    pub peak: f64,
    pub free: f64,
    pub stall: f64,
    pub ratio: f64,
}

/// Whether something is there of which laws are made.
fn is_some(x: f64) -> bool {
    x.is_finite() && x > 0.0
}

impl Laws {
    /// None.
    pub fn none() -> Self {
        Self::default()
    }

    /// Viscous damping acts: `Spring::damping`.
    pub fn damping(self) -> Self {
        Self { damping: true, ..self }
    }

    /// Dry friction acts, `DryFriction`, and sets in over a speed: of hinges (rad/s), of slides (m/s).
    pub fn friction(self, speeds: [f64; 2]) -> Self {
        Self { friction: Some(speeds), sticking: false, ..self }
    }

    /// Dry friction acts as it is, `Coulomb`: joints stick and slip, by `MoreauJean` in real time or in runs that end steps there. Functions of
    /// lists do not know such joints.
    pub fn sticking(self) -> Self {
        Self { friction: None, sticking: true, ..self }
    }

    /// Limits act, as compliant `Stops` that bear the joint's largest effort at a depth beyond them: of hinges (rad), of slides (m); with
    /// damping (s/rad, s/m). A joint without both limits or without a limit of effort has none.
    pub fn stops(self, depths: [f64; 2], dampings: [f64; 2]) -> Self {
        Self { stops: Some([depths, dampings]), hard_stops: None, ..self }
    }

    /// Limits act as they are, `HardStops`, and `BoundedCoulomb` where friction acts as it is, too: joints strike them, get back a share of their
    /// rate (from 0 to 1) and rest against them, by `MoreauJean` in real time or in runs that end steps there. A joint without both limits has
    /// none. Functions of lists do not know such joints.
    pub fn hard_stops(self, restitution: f64) -> Self {
        Self { hard_stops: Some(restitution), stops: None, ..self }
    }

    /// Limits of effort and velocity, and reductions, become a function `motors()` of the module: a `Motor` for each joint with both limits
    /// and a reduction (one where none is written, without its sign), for a controller to ask; a note where they make no motor. Its torque
    /// falls to zero over the last tenth of the velocity.
    pub fn motors(self) -> Self {
        Self { motors: true, ..self }
    }

    /// Rejects numbers that make no mechanics.
    pub(crate) fn check(self) -> Result<(), Error> {
        let [depths, dampings] = self.stops.unwrap_or([[1.0; 2], [0.0; 2]]);
        fits("a speed over which friction sets in must be positive", self.friction.unwrap_or([1.0; 2]), |x| x > 0.0)?;
        fits("a depth of stops must be positive", depths, |x| x > 0.0)?;
        fits("damping of stops must be zero or more", dampings, |x| x >= 0.0)?;
        let restitution = [self.hard_stops.unwrap_or(0.0); 2];
        fits("restitution of stops must be from zero to one", restitution, |x| (0.0..=1.0).contains(&x))
    }

    /// Whether the module has motors.
    pub(crate) fn has_motors(self) -> bool {
        self.motors
    }

    /// Whether limits are written of which no motor comes, though motors are wanted.
    pub(crate) fn lacks_motor(self, furniture: &Furniture) -> bool {
        let limited = furniture.effort.is_finite() || furniture.velocity.is_finite();
        self.motors && limited && self.motor_of(furniture).is_none()
    }

    pub(crate) fn damping_of(self, furniture: &Furniture) -> Option<f64> {
        (self.damping && furniture.damping != 0.0).then_some(furniture.damping)
    }

    /// Force of sliding, and speed.
    pub(crate) fn friction_of(self, furniture: &Furniture, slides: bool) -> Option<[f64; 2]> {
        let speeds = self.friction.filter(|_| furniture.friction != 0.0)?;
        Some([furniture.friction, speeds[usize::from(slides)]])
    }

    /// Whether dry friction acts.
    pub(crate) fn rubs(self, furniture: &Furniture, slides: bool) -> bool {
        self.friction_of(furniture, slides).is_some() || self.sticking_of(furniture).is_some()
    }

    /// Force of sliding, of a joint that sticks.
    pub(crate) fn sticking_of(self, furniture: &Furniture) -> Option<f64> {
        (self.sticking && furniture.friction != 0.0).then_some(furniture.friction)
    }

    pub(crate) fn stops_of(self, furniture: &Furniture, slides: bool) -> Option<Stops> {
        let [depth, damping] = self.stops?.map(|each| each[usize::from(slides)]);
        let Furniture { lower, upper, effort, .. } = *furniture;
        // Over its depth a stop gives way by half of that.
        let stiffness = 2.0 * effort / depth;
        // Limits as large as numbers are written for none.
        let bounded = is_some(upper - lower) && is_some(effort) && is_some(stiffness);
        bounded.then_some(Stops { range: [lower, upper], stiffness, depth, damping })
    }

    /// Hard stops, and the share of a rate that they give back.
    pub(crate) fn hard_stops_of(self, furniture: &Furniture) -> Option<([f64; 2], f64)> {
        let Furniture { lower, upper, .. } = *furniture;
        self.hard_stops.filter(|_| is_some(upper - lower)).map(|restitution| ([lower, upper], restitution))
    }

    /// Whether limits act.
    pub(crate) fn stops_it(self, furniture: &Furniture, slides: bool) -> bool {
        self.stops_of(furniture, slides).is_some() || self.hard_stops_of(furniture).is_some()
    }

    pub(crate) fn motor_of(self, furniture: &Furniture) -> Option<Motor> {
        let Furniture { effort, velocity, reduction, .. } = *furniture;
        // A motor that turns the other way gives as much.
        let ratio = reduction.map_or(1.0, f64::abs);
        let (peak, free, stall) = (effort / ratio, velocity * ratio, 10.0 * effort / ratio);
        let whole = [ratio, effort, velocity, peak, free, stall].into_iter().all(is_some);
        (self.motors && whole).then_some(Motor { peak, free, stall, ratio })
    }
}

/// The force of stops, end by end.
fn pushed(Stops { range: [lower, upper], stiffness, depth, damping }: &Stops, q: f64, rate: f64) -> f64 {
    let push = |over: f64, speed: f64| {
        let x = (over / depth).clamp(0.0, 1.0);
        let compressed = depth * (x.powi(3) - 0.5 * x.powi(4)) + (over - depth).max(0.0);
        stiffness * compressed * (1.0 + damping * speed).max(0.0)
    };
    push(lower - q, -rate) - push(q - upper, rate)
}

impl Robot {
    /// What the laws of the joints exert (N·m, N) at coordinates and rates: zeros where the module has none. Inverse dynamics is without.
    pub fn law_forces(&self, q: &[f64], rates: &[f64]) -> Vec<f64> {
        let of = |(body, (q, rate)): (&Body, (&f64, &f64))| {
            let damping = self.laws.damping_of(&body.furniture).map_or(0.0, |damping| damping * rate);
            let friction = self.laws.friction_of(&body.furniture, body.slides);
            let friction = friction.map_or(0.0, |[force, speed]| force * (rate / speed).tanh());
            let sign = if *rate == 0.0 { 0.0 } else { rate.signum() };
            let friction = friction + self.laws.sticking_of(&body.furniture).map_or(0.0, |force| force * sign);
            let stops = self.laws.stops_of(&body.furniture, body.slides);
            stops.map_or(0.0, |stops| pushed(&stops, *q, *rate)) - damping - friction
        };
        self.bodies.iter().zip(q.iter().zip(rates)).map(of).collect()
    }
}
