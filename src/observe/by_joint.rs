//! Readings by the numbers of a joint.

use super::Stations;
use crate::element::{Element, Space};
use crate::names::JointNumbers;

impl<S: Space, E: Element<S>> Stations<'_, S, E> {
    /// The station of a joint, the root for the root's: its force and torque are what the joint passes on, −m the torque ON the outboard
    /// body.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0_f64, 2.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin.named("elbow"), rod), Free)?.with_gravity(9.81);
    /// let hanging = pendulum.at_rest(&[-std::f64::consts::FRAC_PI_2; 2])?;
    /// let stations = pendulum.stations(&hanging, &Unloaded)?;
    /// let pull = stations.joint(pendulum.joint("elbow")?).map(|station| station.internal.force.y);
    /// assert!(pull.is_some_and(|pull| (pull - 2.0 * 9.81).abs() < 1e-14)); // the weight of one rod
    /// # Ok::<(), catena::Error>(())
    /// ```
    pub fn joint(&self, joint: JointNumbers) -> Option<&S::Station> {
        joint.station.map_or(Some(self.root()), |station| self.get(station))
    }
}
