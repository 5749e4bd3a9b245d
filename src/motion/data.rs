//! Motions as data (feature `serde`): coordinates, rates and accelerations in the shape of their scene.

use super::Motion;
use crate::data::Shape;
use crate::mirror::Position;
use crate::relation::Closures;
use crate::scalar::Scalar;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A motion as it is written.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Motion")]
struct Parts<N, R, P, V, A, M> {
    shape: N,
    time: R,
    position: P,
    rate: V,
    acceleration: A,
    multipliers: M,
}

impl<T, P, C> Serialize for Motion<T, P, C>
where
    T: Scalar<Real: Serialize>,
    P: Position<T, Rate: Serialize> + Serialize,
    C: Closures<Each<T>: Serialize>,
{
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { time, position, rate, acceleration, multipliers } = self;
        Parts { shape: Shape::<(P, C)>::new(), time, position, rate, acceleration, multipliers }.serialize(serializer)
    }
}

impl<'de, T, P, C> Deserialize<'de> for Motion<T, P, C>
where
    T: Scalar<Real: Deserialize<'de>>,
    P: Position<T, Rate: Deserialize<'de>> + Deserialize<'de>,
    C: Closures<Each<T>: Deserialize<'de>>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Parts { shape, time, position, rate, acceleration, multipliers } = Parts::deserialize(deserializer)?;
        let _: Shape<(P, C)> = shape;
        let mut motion = Self { time, position, rate, acceleration, multipliers };
        motion.set_time(time);
        Ok(motion)
    }
}
