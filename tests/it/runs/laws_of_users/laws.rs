//! Laws as a user writes them, for joints in the plane and in space alike.

use catena::Fault;
use catena::extend::Springs;
use catena::planar::SpringLaw;

/// −k q − k₃ q³ − c q̇ − c₃ q̇³.
#[derive(Clone, Copy, Debug)]
pub struct Cubic {
    pub stiffness: f64,
    pub cube: f64,
    pub damping: f64,
    pub square: f64,
}

impl Cubic {
    pub fn of(&self, q: f64, v: f64) -> f64 {
        -(self.stiffness + self.cube * q * q) * q - (self.damping + self.square * v * v) * v
    }
    /// Stiffness and damping there.
    fn slopes(&self, q: f64, v: f64) -> [f64; 2] {
        [self.stiffness + 3.0 * self.cube * q * q, self.damping + 3.0 * self.square * v * v]
    }
    fn stored(&self, q: f64) -> f64 {
        0.5 * self.stiffness * q * q + 0.25 * self.cube * q.powi(4)
    }
    fn finite(&self) -> bool {
        [self.stiffness, self.cube, self.damping, self.square].iter().all(|x| x.is_finite())
    }
}

/// Nothing before `at`; a spring and a damper beyond.
#[derive(Clone, Copy, Debug)]
pub struct Stop {
    pub at: f64,
    pub stiffness: f64,
    pub damping: f64,
}

impl Stop {
    pub fn of(&self, q: f64, v: f64) -> f64 {
        if q > self.at { self.touched(q, v) } else { 0.0 }
    }
    pub fn touched(&self, q: f64, v: f64) -> f64 {
        -self.stiffness * (q - self.at) - self.damping * v
    }
    fn slopes(&self, q: f64, _: f64) -> [f64; 2] {
        if q > self.at { [self.stiffness, self.damping] } else { [0.0; 2] }
    }
    fn stored(&self, q: f64) -> f64 {
        0.5 * self.stiffness * (q - self.at).max(0.0).powi(2)
    }
    fn finite(&self) -> bool {
        [self.at, self.stiffness, self.damping].iter().all(|x| x.is_finite())
    }
}

macro_rules! laws {
    ($($Law:ident),*) => {$(
        impl SpringLaw<f64> for $Law {
            fn force(&self, position: f64, rate: f64) -> f64 {
                self.of(position, rate)
            }
            fn energy(&self, position: f64) -> f64 {
                self.stored(position)
            }
            fn pivot(&self, position: f64, rate: f64, springs: impl Springs<f64>) -> f64 {
                let [stiffness, damping] = self.slopes(position, rate);
                springs.pivot(stiffness, damping)
            }
            fn check(&self) -> Result<(), Fault> {
                if self.finite() { Ok(()) } else { Err(Fault::NotFinite { parameter: "law" }) }
            }
        }
    )*};
}
laws!(Cubic, Stop);
