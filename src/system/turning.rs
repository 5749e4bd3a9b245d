//! Motions set by what bodies do: orientations and angular velocities, absolute or relative, in the plane and in space.

use super::start::Feed;
use crate::element::{Element, Turning};
use crate::ends::{Root, Tip};
use crate::error::{Error, Fault, counted, ensure_finite};
use crate::mechanics::planar::Planar;
use crate::mechanics::spatial::{Rotation, Spatial};
use crate::names::Which;
use crate::scalar::Scalar;
use crate::system::{MotionOf, System};
use crate::turning::plus;
use crate::walks::carrier::{Carrier, carrier};
use crate::walks::steer::{Swivel, Wanted, steer};
use num_traits::Zero;

/// An angular velocity (rad/s), and against what and in which axes it is measured: a number in the plane, a vector in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AngularVelocity<V> {
    /// Absolute, in inertial axes.
    Inertial(V),
    /// Absolute, in axes of the body.
    Body(V),
    /// Against the body inboard of the joint that turns the body, in axes of the body.
    Relative(V),
}

impl<V> AngularVelocity<V> {
    /// The angular velocity (rad/s) as a vector in inertial axes.
    fn inertial<S: Turning<Spin = V>>(self, inboard: &S::Turn, body: &S::Turn) -> [S::Scalar; 3] {
        match self {
            Self::Inertial(spin) => S::in_inertial_axes(spin),
            Self::Body(spin) => S::in_axes_of(body, spin),
            Self::Relative(spin) => plus(S::spin(inboard), S::in_axes_of(body, spin)),
        }
    }
}

impl<S: Turning, R: Root<S>, C: Element<S>, P: Tip<S>> System<S, R, C, P> {
    /// This motion with one body turned to an absolute orientation: an angle (rad) in the plane, a
    /// [`Rotation`] in space. The joint that turns the body does so: the last one that turns at all on the way
    /// from the root. All other coordinates, and all rates, stay as they are stored (see [`Motion`](crate::Motion#what-rates-are)); loops
    /// and held tips are for [`assembled`](Self::assembled) to close again.
    ///
    /// ```
    /// use catena::spatial::*;
    /// let rod = Rod::uniform(0.5_f64, 0.02, 1.0);
    /// let hinge = Revolute::about([0.0, 0.0, 1.0]);
    /// let arm = System::new(Pinned::origin(), (rod, hinge, rod.named("forearm")), Free)?;
    /// let raised = arm.with_body_orientation(arm.motion(), "forearm", Rotation::exp([0.0, 0.0, 0.7]))?;
    /// let [angle] = raised.coordinates_of(arm.joint(1)?)?;
    /// assert!((angle - 0.7).abs() < 1e-15);
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::ImpossibleTurn`] where the joint cannot turn it so, as a revolute about another axis; [`Fault::NotFinite`]; those of
    /// [`body`](Self::body); [`Fault::Shape`] for a motion of another scene.
    pub fn with_body_orientation<'n>(
        &self,
        mut motion: MotionOf<S, R, C, P>,
        body: impl Into<Which<'n>>,
        orientation: S::Orientation,
    ) -> Result<MotionOf<S, R, C, P>, Error> {
        ensure_finite(S::orientation_is_finite(&orientation), "orientation")?;
        let Carrier { joint, outboard, body, .. } = self.carrier(&motion, body.into())?;
        let there = S::carrying(orientation, &outboard, &body);
        let turn = |swivel: &Swivel<S>| if swivel.joint == joint { Wanted::Orientation(there) } else { Wanted::Any };
        self.steered(&mut motion, turn)?;
        Ok(motion)
    }

    /// This motion with one body turning at an angular velocity, absolute or relative, in axes that its type names. The joint that
    /// turns the body does so: the last one that turns at all on the way from the root. All coordinates, and all other rates, stay as
    /// they are stored (see [`Motion`](crate::Motion#what-rates-are)).
    ///
    /// ```
    /// use catena::spatial::*;
    /// use catena::system::AngularVelocity::*;
    /// let rod = Rod::uniform(0.5_f64, 0.02, 1.0);
    /// let arm = System::new(Free, (rod.named("base"), Ball, rod.named("outer")), Free)?;
    /// let spun = arm.with_body_spin(arm.motion(), "base", Inertial([0.0, 0.0, 2.0]))?;
    /// let spun = arm.with_body_spin(spun, "outer", Relative([1.0, 0.0, 0.5]))?;
    /// assert_eq!(spun.rates_of(arm.joint(1)?)?, [1.0, 0.0, 2.5]); // a ball's rates are absolute
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::ImpossibleTurn`] where the joint cannot turn it so; [`Fault::NotFinite`]; those of [`body`](Self::body); [`Fault::Shape`]
    /// for a motion of another scene.
    pub fn with_body_spin<'n>(
        &self,
        mut motion: MotionOf<S, R, C, P>,
        body: impl Into<Which<'n>>,
        spin: AngularVelocity<S::Spin>,
    ) -> Result<MotionOf<S, R, C, P>, Error> {
        let Carrier { joint, inboard, outboard, body } = self.carrier(&motion, body.into())?;
        // Drives in between turn the body against the one that the joint turns.
        let behind = plus(S::spin(&outboard), S::spin(&body).map(|x| -x));
        let spin = plus(spin.inertial::<S>(&inboard, &body), behind);
        ensure_finite(spin.iter().all(|x| x.is_finite()), "angular velocity")?;
        let turn = |swivel: &Swivel<S>| if swivel.joint == joint { Wanted::Spin(spin) } else { Wanted::Any };
        self.steered(&mut motion, turn)?;
        Ok(motion)
    }

    /// This motion with these joint rates (rad/s), one for each rotary coordinate, root to tip: the angular velocity of the
    /// body outboard of the joint relative to the one inboard of it (for the root's joint, relative to the ground). In space a joint
    /// about axes takes their rates; a ball, an elastic hinge or a root that floats three numbers, in axes of the outboard body. Rates of
    /// other coordinates are left as they are.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0_f64, 1.0);
    /// let pendulum = System::new(Pinned::origin(), (rod, Pin, rod), Free)?;
    /// let start = pendulum.with_joint_rates(pendulum.at_rest(&[0.0, 0.0])?, &[1.0, 2.0])?;
    /// assert_eq!(start, pendulum.with_rates(pendulum.at_rest(&[0.0, 0.0])?, &[1.0, 3.0])?); // a pin's rate is absolute
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::Count`] when there are more or fewer numbers than rotary coordinates, [`Fault::NotFinite`]; [`Fault::Shape`] for a
    /// motion of another scene.
    pub fn with_joint_rates(
        &self,
        mut motion: MotionOf<S, R, C, P>,
        rates: &[S::Scalar],
    ) -> Result<MotionOf<S, R, C, P>, Error> {
        let mut feed = Feed::of(rates);
        self.steered(&mut motion, |swivel| {
            let mut own = [S::Scalar::zero(); 3];
            own.iter_mut().take(swivel.freedoms).for_each(|rate| *rate = feed.next());
            Wanted::Relative(own)
        })?;
        feed.check("rates", "rate")?;
        Ok(motion)
    }

    /// Turns joints.
    fn steered(
        &self,
        motion: &mut MotionOf<S, R, C, P>,
        mut wanted: impl FnMut(&Swivel<S>) -> Wanted<S>,
    ) -> Result<(), Error> {
        self.fits(motion)?;
        motion.forget_modes();
        let ground = self.ground(motion.time).turn;
        steer(self.elements(), ground, &mut motion.position, &mut motion.rate, &mut wanted).map_err(Error::beyond_root)
    }

    /// What turns a body.
    fn carrier(&self, motion: &MotionOf<S, R, C, P>, body: Which<'_>) -> Result<Carrier<S>, Error> {
        self.fits(motion)?;
        let (numbers, ground) = (self.body(body)?, self.ground(motion.time).turn);
        let nothing = Error::new(Fault::Unsupported { what: "a turn of a body that no joint turns" });
        carrier(self.elements(), ground, &motion.position, &motion.rate, numbers.body)
            .ok_or(nothing.at_station(numbers.station))
    }
}

impl<T: Scalar, R: Root<Planar<T>>, C: Element<Planar<T>>, P: Tip<Planar<T>>> System<Planar<T>, R, C, P> {
    /// This motion with these absolute angular velocities (rad/s), one for each rotary coordinate, root to tip: that of the
    /// body outboard of the joint. Rates of other coordinates are left as they are.
    ///
    /// ```
    /// use catena::planar::*;
    /// let rod = Rod::uniform(1.0_f64, 1.0);
    /// let blade = System::new(Pinned::origin(), (rod, ElasticHinge::rotary(5.0), rod), Free)?;
    /// let start = blade.with_body_rates(blade.at_rest(&[0.0, 0.0])?, &[1.0, 3.0])?;
    /// assert_eq!(start, blade.with_rates(blade.at_rest(&[0.0, 0.0])?, &[1.0, 2.0])?); // a hinge's rate is relative
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::Count`] when there are more or fewer numbers than rotary coordinates, [`Fault::NotFinite`]; [`Fault::Shape`] for a
    /// motion of another scene.
    pub fn with_body_rates(
        &self,
        mut motion: MotionOf<Planar<T>, R, C, P>,
        rates: &[T],
    ) -> Result<MotionOf<Planar<T>, R, C, P>, Error> {
        self.fits(&motion)?;
        let mut feed = Feed::of(rates);
        let outcome = self.steered(&mut motion, |_| Wanted::Spin(Planar::in_inertial_axes(feed.next())));
        feed.check("rates", "rate")?;
        outcome?;
        Ok(motion)
    }
}

impl<T: Scalar, R: Root<Spatial<T>>, C: Element<Spatial<T>>, P: Tip<Spatial<T>>> System<Spatial<T>, R, C, P> {
    /// A motion at rest with these absolute attitudes, one for each joint that turns, root to tip: that of the body outboard of it.
    /// ([`at_rest`](Self::at_rest) takes angles.)
    ///
    /// ```
    /// use catena::spatial::*;
    /// let rod = Rod::uniform(0.5_f64, 0.02, 1.0);
    /// let arm = System::new(Pinned::origin(), (rod, Revolute::about([0.0, 0.0, 1.0]), rod), Free)?;
    /// let about_z = |angle| Rotation::exp([0.0, 0.0, angle]);
    /// let start = arm.at_attitudes(&[about_z(0.5), about_z(0.75)])?;
    /// assert!((start.coordinates()[4] - 0.25).abs() < 1e-15); // after the quaternion of the ball
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::Count`] when there are more or fewer attitudes than joints that turn, [`Fault::NotFinite`]; [`Fault::ImpossibleTurn`] where
    /// a joint cannot turn its body so.
    pub fn at_attitudes(&self, attitudes: &[Rotation<T>]) -> Result<MotionOf<Spatial<T>, R, C, P>, Error> {
        let is_finite = attitudes.iter().all(Spatial::<T>::orientation_is_finite);
        ensure_finite(is_finite, "attitude")?;
        let (mut motion, mut turning) = (self.motion(), 0);
        let outcome = self.steered(&mut motion, |_| {
            turning += 1;
            attitudes.get(turning - 1).map_or(Wanted::Any, |attitude| Wanted::Orientation(*attitude))
        });
        counted("attitudes", turning, attitudes.len())?;
        outcome?;
        Ok(motion)
    }

    /// This motion with these angular velocities (rad/s), one for each joint that turns, root to tip: that of the body outboard of it,
    /// measured as `axes` says. Rates of other coordinates are left as they are.
    ///
    /// ```
    /// use catena::spatial::*;
    /// use catena::system::AngularVelocity;
    /// let rod = Rod::uniform(0.5_f64, 0.02, 1.0);
    /// let arm = System::new(Pinned::origin(), (rod, Revolute::about([0.0, 0.0, 1.0]), rod), Free)?;
    /// let rates = [[0.1, 0.0, 2.0], [0.1, 0.0, 3.5]];
    /// let start = arm.with_body_rates(arm.motion(), &rates, AngularVelocity::Inertial)?;
    /// assert_eq!(start.rates(), [0.1, 0.0, 2.0, 1.5]); // a revolute's rate is relative
    /// # Ok::<(), catena::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Fault::Count`] when there are more or fewer vectors than joints that turn, [`Fault::NotFinite`]; [`Fault::ImpossibleTurn`] where a
    /// joint cannot turn its body so; [`Fault::Shape`] for a motion of another scene.
    pub fn with_body_rates(
        &self,
        mut motion: MotionOf<Spatial<T>, R, C, P>,
        rates: &[[T; 3]],
        axes: impl Fn([T; 3]) -> AngularVelocity<[T; 3]>,
    ) -> Result<MotionOf<Spatial<T>, R, C, P>, Error> {
        self.fits(&motion)?;
        ensure_finite(rates.iter().flatten().all(|x| x.is_finite()), "angular velocity")?;
        let mut turning = 0;
        let outcome = self.steered(&mut motion, |swivel| {
            turning += 1;
            let rate = rates.get(turning - 1);
            rate.map_or(Wanted::Any, |rate| {
                Wanted::Spin(axes(*rate).inertial::<Spatial<T>>(&swivel.inboard, &swivel.outboard))
            })
        });
        counted("rates", turning, rates.len())?;
        outcome?;
        Ok(motion)
    }
}
