//! Scenes as data (feature `serde`): their elements in the order in which they are written, checked as new ones are.

use super::{Runs, System};
use crate::data::Shape;
use crate::element::{Element, Space, Unloaded};
use crate::ends::{Root, Tip};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A scene as it is written. The shape comes first: it is compared before the elements are read.
#[derive(Serialize, Deserialize)]
#[serde(rename = "System")]
struct Parts<N, R, C, P, V> {
    shape: N,
    root: R,
    chain: C,
    tip: P,
    gravity: V,
}

impl<S, R, C, P> Serialize for System<S, R, C, P>
where
    S: Space<Vector: Serialize>,
    R: Root<S> + Serialize,
    C: Serialize,
    P: Serialize,
{
    fn serialize<W: Serializer>(&self, serializer: W) -> Result<W::Ok, W::Error> {
        let Self { root, chain: (_, chain), tip, gravity } = self;
        Parts { shape: Shape::<(S, R, C, P)>::new(), root, chain, tip, gravity }.serialize(serializer)
    }
}

impl<'de, S, R, C, P> Deserialize<'de> for System<S, R, C, P>
where
    S: Space<Vector: Deserialize<'de>>,
    R: Root<S> + Deserialize<'de>,
    C: Element<S> + Deserialize<'de>,
    P: Tip<S> + Deserialize<'de>,
    Self: Runs<Unloaded, S, R, C, P>,
{
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Parts { shape, root, chain, tip, gravity } = Parts::deserialize(deserializer)?;
        let _: Shape<(S, R, C, P)> = shape;
        let scene = Self::new(root, chain, tip).map_err(D::Error::custom)?;
        Ok(scene.with_gravity_vector(gravity))
    }
}
