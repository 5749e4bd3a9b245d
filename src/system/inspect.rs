//! The method as the paper has it, on a scene: transfer matrices and their product, to look at and to check sweeps with.

use crate::element::{Coordinates, Element, Loading, Space};
use crate::ends::{Pairs, Root, Tip};
use crate::error::Error;
use crate::planar::index::{M, THETA};
use crate::relation::Term;
use crate::solve::product::{close, product};
use crate::state::{StateVector, TransferMatrix};
use crate::system::{MotionOf, System};
use crate::transfer::Exact;
use num_traits::Zero;

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// The overall transfer matrix at acceleration level, (16) and (17): z at the tip = U z at the inboard end of the chain,
    /// with exact matrices of bodies (32) and pins (40). `each` is shown the matrices of the elements and their numbers, from
    /// the tip inward.
    ///
    /// A view for short chains: the product loses all digits beyond some tens of bodies.
    ///
    /// ```
    /// use catena::element::Unloaded;
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0_f64, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    /// let motion = pendulum.at_rest(&[-1.0, -0.5])?;
    /// let tip = pendulum.transfer_matrix(&motion, &Unloaded, |_, _| ())? * pendulum.root_state(&motion, &Unloaded)?;
    /// assert!(tip[index::QX].abs() < 1e-13 && tip[index::QY].abs() < 1e-13); // nothing pulls at the tip
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::SingularTransfer`](crate::Fault::SingularTransfer) where a pin is the centre of percussion of what lies outboard.
    pub fn transfer_matrix<L: Loading<S>, const N: usize>(
        &self,
        motion: &MotionOf<S, R, C, P>,
        loads: &L,
        mut each: impl FnMut(usize, &TransferMatrix<S::Scalar, N>),
    ) -> Result<TransferMatrix<S::Scalar, N>, Error>
    where
        S: Exact<N>,
        L::InJoint: Term<S::Scalar>,
    {
        self.product(motion, loads, &mut each).map(|(whole, _)| whole)
    }

    fn product<L: Loading<S>, const N: usize>(
        &self,
        motion: &MotionOf<S, R, C, P>,
        loads: &L,
        each: &mut impl FnMut(usize, &TransferMatrix<S::Scalar, N>),
    ) -> Result<(TransferMatrix<S::Scalar, N>, S::Scalar), Error>
    where
        S: Exact<N>,
        L::InJoint: Term<S::Scalar>,
    {
        let (position, rate, acceleration) = (motion.position(), motion.rate(), motion.acceleration());
        let coordinates = Coordinates { position, rate, acceleration };
        let ground = self.ground(motion.time());
        product(self.elements(), &ground, self.gravity(), loads, motion.time(), coordinates, each)
    }

    /// The acceleration state at the inboard end of the chain, from the plain product and the boundary conditions: what a
    /// sweep finds by other means.
    ///
    /// # Errors
    /// [`Fault::SingularTransfer`](crate::Fault::SingularTransfer) at a centre of percussion.
    pub fn root_state<L: Loading<S>>(
        &self,
        motion: &MotionOf<S, R, C, P>,
        loads: &L,
    ) -> Result<StateVector<S::Scalar, 7>, Error>
    where
        S: Exact<7>,
        L::InJoint: Term<S::Scalar>,
    {
        let (whole, torque) = self.product(motion, loads, &mut |_, _| ())?;
        let mut known = S::acceleration_state(&self.ground(motion.time()));
        known[M] = -torque;
        known[THETA] = S::Scalar::zero();
        close(&whole, known, R::Pairs::MOTION)
    }
}
