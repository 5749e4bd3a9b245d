//! The condensation of arms in parallel.

use super::closing::{CloseOff, Ends};
use super::network::{Inside, Network, OwnOf};
use crate::element::{Carrying, Condense, Given, InJoint, Posture, Reading, Space, Sweep};
use crate::relation::Settle;

/// What a sweep carries into the main arm.
type InMain<S, W, K> =
    Carrying<<W as Sweep<S>>::Loads, <W as Sweep<S>>::Springs, Inside<S, <W as Sweep<S>>::Closures, K>>;
/// What it carries into the side arm.
type InSide<S, W, K> = Carrying<<W as Sweep<S>>::Loads, <W as Sweep<S>>::Springs, OwnOf<S, K>>;

impl<S, R, W, M, A, K> Condense<S, R, W> for Network<M, A, K>
where
    S: Space,
    W: Sweep<S>,
    K: CloseOff<S, R, InJoint<S, W>>,
    M: Condense<S, K::Main, InMain<S, W, K>>,
    A: Condense<S, K::Side, InSide<S, W, K>>,
    M::Out: Settle<S::Column, S::Scalar, A::Out, W::Closures, OwnOf<S, K>>,
{
    type Out = <M::Out as Settle<S::Column, S::Scalar, A::Out, W::Closures, OwnOf<S, K>>>::Out;

    #[inline(always)]
    fn condense(
        &self,
        outer: R,
        Posture { x, y, p, q }: Posture<'_, S, Self>,
        Given { on_bodies, in_joints, position, rate, reading, springs }: Given<'_, S, Self, W>,
        kept: &mut Self::Kept<W::Closures>,
    ) -> Self::Out {
        let (main, side, driven) =
            self.closing.close_off(outer, in_joints.2, Ends { x: &x.2, y: &y.2, p: &p.2, q: &q.2 });
        let (position, rate) = (&position.arms, &rate.arms);
        let Reading { position: read, rate: read_rate, acceleration } = reading;
        let in_main = Reading { position: &read.arms.0, rate: &read_rate.arms.0, acceleration: &acceleration.arms.0 };
        let in_side = Reading { position: &read.arms.1, rate: &read_rate.arms.1, acceleration: &acceleration.arms.1 };
        let main = self.main().condense(
            main,
            Posture { x: &x.0, y: &y.0, p: &p.0, q: &q.0 },
            Given {
                on_bodies: &on_bodies.0,
                in_joints: &in_joints.0,
                position: &position.0,
                rate: &rate.0,
                reading: in_main,
                springs,
            },
            &mut kept.0,
        );
        let side = self.side().condense(
            side,
            Posture { x: &x.1, y: &y.1, p: &p.1, q: &q.1 },
            Given {
                on_bodies: &on_bodies.1,
                in_joints: &in_joints.1,
                position: &position.1,
                rate: &rate.1,
                reading: in_side,
                springs,
            },
            &mut kept.1,
        );
        let (relation, gain) = main.settle(side, kept.2.measure());
        (kept.2, kept.3) = (gain, driven);
        relation
    }
}
