//! Ladders of loops: windows in a row, each nested in an arm of the next. Their accelerations against a closed form, and twelve of them
//! against the compiler, whose time must not double with each.

use catena::Error;
use catena::loading::Unloaded;
use catena::system::Rate;
use catena::system::{Dynamics, StiffDynamics};

/// A scene that explicit and implicit rules can step. The compiler proves it; nothing is left to run.
fn steps<D: Dynamics<Unloaded> + StiffDynamics<Unloaded>>(_: &D) {}

/// Windows from right to left: the side arm of each carries all that stand right of it. One `w` for each.
macro_rules! in_side_arms {
    ([] $parts:ident) => {
        $parts.foot()
    };
    ([w $($rest:tt)*] $parts:ident) => {
        Network::new(
            $parts.foot(),
            ($parts.reach(1.0), in_side_arms!([$($rest)*] $parts), $parts.joint, $parts.bar),
            $parts.closing,
        )
    };
}

/// Windows from left to right: the main arm of each carries all that stand left of it.
macro_rules! in_main_arms {
    ([w] $parts:ident $reach:expr) => {
        Network::new(
            ($parts.joint, $parts.bar, $parts.joint, $parts.bar),
            ($parts.reach($reach), $parts.joint, $parts.bar),
            $parts.closing,
        )
    };
    ([w $($rest:tt)*] $parts:ident $reach:expr) => {
        Network::new(
            (in_main_arms!([$($rest)*] $parts $reach - 1.0), $parts.joint, $parts.bar),
            ($parts.reach($reach), $parts.joint, $parts.bar),
            $parts.closing,
        )
    };
}

/// Angular acceleration of the cranks of `n` windows whose rods of 1 m and 1 kg stand at `angle` (rad): couplers do not turn.
fn crank(n: usize, angle: f64) -> f64 {
    let n = n as f64;
    -9.81 * ((n + 1.0) / 2.0 + n) * angle.cos() / ((n + 1.0) / 3.0 + n)
}

mod in_the_plane {
    use super::*;
    use catena::planar::*;

    /// What windows consist of: cranks and couplers are alike.
    struct Parts {
        joint: Pin,
        bar: Rod<f64>,
        closing: Pin,
    }

    const PARTS: fn() -> Parts = || Parts { joint: Pin, bar: Rod::uniform(1.0, 1.0), closing: Pin };

    impl Parts {
        fn foot(&self) -> (Pin, Rod<f64>) {
            (self.joint, self.bar)
        }
        fn reach(&self, x: f64) -> RigidBody<f64> {
            RigidBody::massless([x, 0.0])
        }
    }

    macro_rules! on_ground {
        ($ladder:expr) => {
            System::new(Clamped::at(0.0, 0.0, 0.0), $ladder, Free)?.with_gravity(9.81)
        };
    }

    /// The largest difference from the closed form (rad/s²) with cranks at 1 rad that turn at −1 rad/s; `angles` tells cranks, 1, from
    /// couplers.
    macro_rules! difference {
        ($scene:expr, $windows:expr, $angles:expr) => {{
            let (scene, angles): (_, Vec<f64>) = ($scene, $angles);
            let mut motion = scene.at_rest(&angles)?;
            let mut next = angles.iter();
            let is_crank = |angle: f64| angle == 1.0;
            let rate = |angle: &f64| if is_crank(*angle) { -1.0 } else { 0.0 };
            motion.rate_mut().replace(&mut |_| next.next().map_or(f64::NAN, rate));
            let motion = scene.with_accelerations(motion, &Unloaded)?;
            let (mut worst, mut next) = (0.0_f64, angles.iter());
            motion.acceleration().visit(&mut |found| {
                let angle = next.next().copied().unwrap_or(f64::NAN);
                let expected = if is_crank(angle) { crank($windows, angle) } else { 0.0 };
                let off = (found - expected).abs();
                worst = if off > worst || off.is_nan() { off } else { worst };
            });
            assert!(next.next().is_none(), "more angles than accelerations");
            worst
        }};
    }

    #[test]
    fn windows_fall_as_one_crank_would() -> Result<(), Error> {
        let parts = PARTS();
        let twelve = on_ground!(in_side_arms!([w w w w w w w w w w w w] parts));
        let angles = [vec![1.0; 13], vec![std::f64::consts::PI; 12]].concat();
        let right_to_left = difference!(twelve, 12, angles);
        let four = on_ground!(in_main_arms!([w w w w] parts 4.0));
        let angles = vec![1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0];
        let left_to_right = difference!(four, 4, angles);
        println!("off by {right_to_left:.1e} and {left_to_right:.1e} rad/s²");
        assert!(right_to_left < 1e-12 && left_to_right < 1e-12, "off by {right_to_left:e}, {left_to_right:e}");
        Ok(())
    }

    #[test]
    fn twelve_windows_compile() -> Result<(), Error> {
        let parts = PARTS();
        let from_right = on_ground!(in_side_arms!([w w w w w w w w w w w w] parts));
        let from_left = on_ground!(in_main_arms!([w w w w w w w w w w w w] parts 12.0));
        steps(&from_right);
        steps(&from_left);
        assert_eq!((from_right.bodies(), from_left.bodies()), (25 + 12, 25 + 12)); // with the ground between the feet
        Ok(())
    }
}

mod in_space {
    use super::*;
    use catena::spatial::*;

    struct Parts {
        joint: Revolute<f64>,
        bar: Rod<f64>,
        closing: LeastNorm<Revolute<f64>>,
    }

    impl Parts {
        fn foot(&self) -> (Revolute<f64>, Rod<f64>) {
            (self.joint, self.bar)
        }
        fn reach(&self, x: f64) -> RigidBody<f64> {
            RigidBody::massless([x, 0.0, 0.0])
        }
    }

    #[test]
    fn twelve_windows_compile() -> Result<(), Error> {
        let joint = Revolute::about([0.0, 0.0, 1.0]);
        let parts = Parts { joint, bar: Rod::uniform(1.0, 0.02, 1.0), closing: LeastNorm(joint) };
        let from_right = System::new(Clamped::origin(), in_side_arms!([w w w w w w w w w w w w] parts), Free)?;
        let from_left = System::new(Clamped::origin(), in_main_arms!([w w w w w w w w w w w w] parts 12.0), Free)?;
        steps(&from_right);
        steps(&from_left);
        assert_eq!((from_right.bodies(), from_left.bodies()), (25 + 12, 25 + 12));
        Ok(())
    }
}
