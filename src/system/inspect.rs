//! The method as the paper has it, on a scene: transfer matrices and their product, to look at and to check sweeps with.

use crate::element::{Coordinates, Element, Loading, Space};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault};
use crate::loading::couples;
use crate::solve::product::product;
use crate::state::{StateVector, TransferMatrix};
use crate::system::{MotionOf, System};
use crate::transfer::{Efforts, Exact, Whole, close};

impl<S: Space, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// The overall transfer matrix at acceleration level, (16) and (17): z at the tip = U z at the inboard end of the chain,
    /// with exact matrices of bodies (32) and pins (40), in space (20)-(31) and (40) generalised to all joints. `each` is shown the matrices of the elements and their numbers, from
    /// the tip inward.
    ///
    /// A view for short chains: the product loses all digits beyond some tens of bodies.
    ///
    /// ```
    /// use catena::loading::Unloaded;
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
    /// [`Fault::SingularTransfer`] where a joint is a centre of percussion of what lies outboard;
    /// [`Fault::Unsupported`] for arms; [`Fault::Shape`] for a motion of another scene; [`Fault::Count`] for a list of loads of another
    /// length.
    pub fn transfer_matrix<L: Loading<S>, const N: usize>(
        &self,
        motion: &MotionOf<S, R, C, P>,
        loads: &L,
        mut each: impl FnMut(usize, &TransferMatrix<S::Scalar, N>),
    ) -> Result<TransferMatrix<S::Scalar, N>, Error>
    where
        S: Exact<N>,
        L::InJoint: Efforts<S>,
    {
        self.product(motion, loads, &mut each).map(|(whole, _)| whole)
    }

    fn product<L: Loading<S>, const N: usize>(
        &self,
        motion: &MotionOf<S, R, C, P>,
        loads: &L,
        each: &mut impl FnMut(usize, &TransferMatrix<S::Scalar, N>),
    ) -> Result<Whole<S, N>, Error>
    where
        S: Exact<N>,
        L::InJoint: Efforts<S>,
    {
        self.fits(motion)?;
        self.loadable(loads)?;
        if const { couples::<S, L>() } {
            return Err(Error::new(Fault::Unsupported { what: "couplings of joints, by matrices" }));
        }
        let (position, rate, acceleration) = (motion.position(), motion.rate(), motion.acceleration());
        let coordinates = Coordinates { position, rate, acceleration };
        let ground = self.ground(motion.time());
        product(self.elements(), &ground, self.gravity(), loads, motion.time(), coordinates, each)
    }

    /// The acceleration state at the inboard end of the chain, from the plain product and the boundary conditions: what a
    /// sweep finds by other means.
    ///
    /// # Errors
    /// Those of [`transfer_matrix`](Self::transfer_matrix).
    pub fn root_state<L: Loading<S>, const N: usize>(
        &self,
        motion: &MotionOf<S, R, C, P>,
        loads: &L,
    ) -> Result<StateVector<S::Scalar, N>, Error>
    where
        S: Exact<N>,
        L::InJoint: Efforts<S>,
    {
        let (whole, root) = self.product(motion, loads, &mut |_, _| ())?;
        let ground = S::acceleration_state(&self.ground(motion.time()));
        close(&whole, &root, ground).ok_or(Error::new(Fault::SingularTransfer))
    }
}
