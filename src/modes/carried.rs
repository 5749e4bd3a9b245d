//! What the ground or drives carry along otherwise at each place: its modes are not real.

use super::dense;
use crate::element::{Coordinates, Element, RealOf};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::mirror::Position;
use crate::observe::each_body;
use crate::scalar::{Real, Scalar};
use crate::system::{Inertial, Linear, MotionOf, PositionOf, System, coordinates, set, step, unit};
use nalgebra::DVector;
use std::vec::Vec;

impl<S: Inertial, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// Refuses what the ground or a drive moves where all rates are zero, if that motion changes with the coordinates: forces in their rates
    /// go with it. A change of less than the root of `flat` (rad²/s²) is none.
    pub(super) fn carried_alike(
        &self,
        still: &MotionOf<S, R, C, P>,
        near: &Linear<RealOf<S>>,
        flat: f64,
    ) -> Result<(), Error> {
        let refuse = |what| Error::new(Fault::Unsupported { what });
        if self.drift(still).iter().any(|x| x.real().as_f64() * x.real().as_f64() > flat) {
            return Err(refuse("modes of vibration of what is held where the ground or a drive moves"));
        }
        // Of each body: velocities in its axes, by roots of what resists them, and the angular momentum in inertial axes.
        let carried = |position: &PositionOf<S, R, C>| {
            let (mut weighted, mut angular) = (Vec::new(), Vec::new());
            each_body(
                self.elements(),
                self.ground(still.time),
                Coordinates { position, ..coordinates(still) },
                |body| {
                    let mut own = Vec::new();
                    S::weighted(body, &mut |x| own.push(x.as_f64()));
                    weighted.push(DVector::from_vec(own));
                    angular.push(S::carried(body).angular.map(|x| x.as_f64()));
                },
            );
            (weighted, angular)
        };
        let (mut direction, step, root) = (still.rate.clone(), step::<RealOf<S>>(), dense(&near.root));
        for k in 0..near.tangent.dimension() {
            let along: Vec<_> = unit(near.tangent.dimension(), k).collect();
            set(&mut direction, near.tangent.vector(&along).iter().map(|x| S::Scalar::constant(*x)));
            let [ahead, behind] = [step, -step].map(|reach| {
                let mut place = still.position.clone();
                place.drift_0(&still.position, (reach, &direction));
                place.set_clocks(still.time);
                carried(&place)
            });
            let (inertia, reach) = (root.column(k).norm_squared(), 4.0 * flat * (step * step).as_f64());
            let weighted = ahead.0.iter().zip(&behind.0).map(|(a, b)| (a - b).norm_squared() > reach * inertia);
            let angular =
                ahead.1.iter().zip(&behind.1).map(|(a, b)| (a - b).norm_squared() > reach * inertia * inertia);
            if let Some(body) = weighted.zip(angular).position(|(weighted, angular)| weighted || angular) {
                let what = "modes of vibration of a body that the ground or a drive moves as the coordinates say";
                return Err(refuse(what).at_station(self.body(body)?.station));
            }
        }
        Ok(())
    }
}
