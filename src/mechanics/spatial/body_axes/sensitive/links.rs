//! Derivatives through kept gains in body axes: what a link does.
//!
//! It hands motions on as they are. At fixed accelerations of the joint coordinates its force and torque about the origin change by
//!
//! ```text
//! dF = m da + dα × σ + d[ω × (ω × σ)]        dM = σ × da + J dα + d[ω × J ω]
//! ```
//!
//! where both brackets are linear in the products of ω.

use super::super::link::Link;
use super::super::number::{Triple, triple, values};
use super::super::relation::Local;
use super::super::through::Solid;
use super::jets;
use super::products::products_varied;
use crate::mechanics::spatial::sensitive::columns::{Vectors, add, none, parts, value};
use crate::mechanics::spatial::sensitive::{Answering, Passing, Pulling};
use crate::mechanics::spatial::{Acceleration, Spatial, Wrench};
use crate::relation::spatial::Full;
use crate::relation::spatial::algebra::zero;
use crate::scalar::{Jet, Scalar, columns};
use crate::sensitive::{At, Derived, Seeds, Sensitive};
use nalgebra::Vector3;

/// What a link keeps: its motion, and its load.
#[derive(Clone, Copy, Debug)]
pub struct LinkStore<T, const K: usize> {
    spin: Vector3<T>,
    acceleration: Acceleration<T>,
    /// Columns of ω, and of the accelerations of the origin and of the link.
    spins: Vectors<T, K>,
    linear: Vectors<T, K>,
    angular: Vectors<T, K>,
    load: Wrench<Jet<T, K>>,
    /// Whether the link's parameters have derivatives.
    seeded: bool,
}

impl<T: Scalar, const MOMENT: u8, const TENSOR: u8> Link<T, MOMENT, TENSOR> {
    /// Force and torque at the origin for accelerations there and for what ω takes.
    #[inline(always)]
    fn forces(&self, p: [[T; 3]; 2], stirred: [Triple<T>; 2]) -> [[T; 3]; 2] {
        self.resisted(p.map(triple), stirred).map(values)
    }
}

impl<T: Scalar, const K: usize, const MOMENT: u8, const TENSOR: u8> Sensitive<Spatial<Jet<T, K>>>
    for Link<Jet<T, K>, MOMENT, TENSOR>
{
    type Plain = Link<T, MOMENT, TENSOR>;
    type Room = LinkStore<T, K>;

    fn room(&self) -> Self::Room {
        let numbers = self.first_moment().into_iter().chain(self.about_origin()).map(|x| x.value());
        let constant = numbers.chain([self.mass()]).all(|x| x.is_constant());
        LinkStore {
            spin: zero(),
            acceleration: Acceleration::zero(),
            spins: none(),
            linear: none(),
            angular: none(),
            load: Wrench::default(),
            seeded: !constant,
        }
    }
    #[inline(always)]
    fn read((): &(), (): &(), (): &mut (), (): &mut ()) {}
    fn load(&self, on_body: &Wrench<Jet<T, K>>, (): &(), store: &mut Self::Room) {
        store.load = *on_body;
    }
    #[cfg_attr(optimised, inline(always))]
    fn factor<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        outer: Full<T>,
        store: &mut Self::Room,
    ) -> Full<T> {
        let [force, torque] = *at.posture.y;
        let relation = Local::of_own(&outer).with(at.plain.alone([force.into(), torque.into()])).full();
        if !N::LOADS {
            return relation;
        }
        let Wrench { force, torque } = &store.load;
        Full { force: relation.force - value(force), torque: relation.torque - value(torque), ..relation }
    }
    #[inline(never)]
    fn vary<N: Seeds>(
        &self,
        _: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Passing<T, K>,
        store: &mut Self::Room,
        (): &mut (),
    ) {
        (store.spin, store.acceleration) = (carried.turn.spin, carried.acceleration);
        (store.spins, store.linear, store.angular) = (carried.spin, carried.linear, carried.angular);
    }
    #[inline(never)]
    fn gather<N: Seeds>(
        &self,
        at: At<'_, Spatial<Jet<T, K>>, Self>,
        carried: &mut Pulling<T, K>,
        store: &mut Self::Room,
        (): &mut (),
    ) {
        let LinkStore { spin, acceleration: Acceleration { linear, angular }, .. } = *store;
        let (link, spin): (_, [T; 3]) = (at.plain, spin.into());
        let [force, torque] = link.forces([linear.into(), angular.into()], link.gyroscopic(spin));
        carried.force += Vector3::from(force);
        carried.torque += Vector3::from(torque);
        if N::PARAMETERS && store.seeded {
            let p = [jets(linear, &store.linear), jets(angular, &store.angular)];
            let [force, torque] = self.forces(p, self.gyroscopic(jets(Vector3::from(spin), &store.spins)));
            add(&mut carried.forces, &parts(&Vector3::from(force)));
            add(&mut carried.torques, &parts(&Vector3::from(torque)));
        } else {
            let ([fx, fy, fz], [tx, ty, tz]) = (&mut carried.forces, &mut carried.torques);
            let ([wx, wy, wz], [ax, ay, az], [bx, by, bz]) = (&store.spins, &store.linear, &store.angular);
            columns!(K; wx = *wx, wy = *wy, wz = *wz, ax = *ax, ay = *ay, az = *az, bx = *bx, by = *by, bz = *bz; k:
                let p = [[ax[k], ay[k], az[k]], [bx[k], by[k], bz[k]]],
                let own = link.forces(p, link.stirred_by(products_varied(spin, [wx[k], wy[k], wz[k]]))),
                mut fx = *fx => fx[k] + own[0][0],
                mut fy = *fy => fy[k] + own[0][1],
                mut fz = *fz => fz[k] + own[0][2],
                mut tx = *tx => tx[k] + own[1][0],
                mut ty = *ty => ty[k] + own[1][1],
                mut tz = *tz => tz[k] + own[1][2]
            );
        }
        if N::LOADS {
            let Wrench { force, torque } = &store.load;
            carried.force -= value(force);
            carried.torque -= value(torque);
            let sums = carried.forces.iter_mut().chain(&mut carried.torques);
            for (sum, load) in sums.zip([force.x, force.y, force.z, torque.x, torque.y, torque.z]) {
                columns!(K; load = load.eps; k: mut sum = *sum => sum[k] - load[k]);
            }
        }
    }
    #[inline(always)]
    fn answer(&self, _: At<'_, Spatial<Jet<T, K>>, Self>, _: &mut Answering<T, K>, _: &Self::Room, (): &mut ()) {}
}
