//! Saved runs as data (feature `serde`).

use super::{Progress, Saved};
use crate::data::Shape;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A saved run as it is written.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Saved")]
struct Parts<M, N, K, P> {
    motion: M,
    caused: Option<M>,
    remembered: N,
    memory: K,
    progress: P,
}

impl<M: Serialize, K: Serialize, R: Serialize> Serialize for Saved<M, K, R> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { motion, caused, memory, progress } = self;
        let caused = caused.as_ref();
        Parts { motion, caused, remembered: Shape::<K>::new(), memory, progress }.serialize(serializer)
    }
}

impl<'de, M: Deserialize<'de>, K: Deserialize<'de>, R: Deserialize<'de>> Deserialize<'de> for Saved<M, K, R> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Parts { motion, caused, remembered, memory, progress } = Parts::deserialize(deserializer)?;
        let (_, progress): (Shape<K>, Progress<R>) = (remembered, progress);
        Ok(Self { motion, caused, memory, progress })
    }
}
