//! The condensation of arms in parallel.

use super::closing::CloseOff;
use super::network::{Inside, Network, OwnOf};
use crate::element::{Carrying, Condense, Given, InJoint, Posture, Reading, Space, Sweep};
use crate::relation::{Settle, WrenchOf};
use crate::shape::{Ends, Kept};

/// What a sweep carries into the main arm.
type InMain<S, W, K> =
    Carrying<<W as Sweep<S>>::Loads, <W as Sweep<S>>::Springs, Inside<S, <W as Sweep<S>>::Closures, K>>;
/// What a sweep carries into the side arm.
type InSide<S, W, K> = Carrying<<W as Sweep<S>>::Loads, <W as Sweep<S>>::Springs, OwnOf<S, K>>;

impl<S, R, W, M, A, K> Condense<S, R, W> for Network<M, A, K>
where
    S: Space,
    W: Sweep<S>,
    K: CloseOff<S, R, InJoint<S, W>>,
    M: Condense<S, K::Main, InMain<S, W, K>>,
    A: Condense<S, K::Side, InSide<S, W, K>>,
    M::Out: Settle<WrenchOf<S>, S::Scalar, A::Out, W::Closures, OwnOf<S, K>>,
{
    type Out = <M::Out as Settle<WrenchOf<S>, S::Scalar, A::Out, W::Closures, OwnOf<S, K>>>::Out;

    #[cfg_attr(optimised, inline(always))]
    fn condense(
        &self,
        outer: R,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        Given { on_bodies, in_joints, position, rate, reading, springs }: Given<'_, S, Self, W>,
        kept: &mut Self::Store<Kept<W::Closures>>,
    ) -> Self::Out {
        let (main, side, driven) = self.closing.close_off(
            outer,
            in_joints.closing,
            Ends { x: &x.closing, y: &y.closing, p: &p.closing, q: &q.closing },
        );
        let (position, rate) = (&position.arms, &rate.arms);
        let Reading { position: read, rate: read_rate, acceleration } = reading;
        let in_main = Reading { position: &read.arms.0, rate: &read_rate.arms.0, acceleration: &acceleration.arms.0 };
        let in_side = Reading { position: &read.arms.1, rate: &read_rate.arms.1, acceleration: &acceleration.arms.1 };
        let main = self.main().condense(
            main,
            Posture { x: &x.arms.0, y: &y.arms.0, p: &p.arms.0, q: &q.arms.0 },
            Given {
                on_bodies: &on_bodies.arms.0,
                in_joints: &in_joints.arms.0,
                position: &position.0,
                rate: &rate.0,
                reading: in_main,
                springs,
            },
            &mut kept.arms.0,
        );
        let side = self.side().condense(
            side,
            Posture { x: &x.arms.1, y: &y.arms.1, p: &p.arms.1, q: &q.arms.1 },
            Given {
                on_bodies: &on_bodies.arms.1,
                in_joints: &in_joints.arms.1,
                position: &position.1,
                rate: &rate.1,
                reading: in_side,
                springs,
            },
            &mut kept.arms.1,
        );
        let (relation, gain) = main.settle(side, kept.closing.0.measure());
        kept.closing = (gain, driven);
        relation
    }
}
