//! Motions as plain lists of numbers, and by joint.

use super::Motion;
use crate::error::{Error, Fault, counted, ensure_finite};
use crate::mirror::{Position, Rate};
use crate::names::JointNumbers;
use crate::relation::Closures;
use crate::scalar::Scalar;
#[cfg(feature = "alloc")]
use alloc::vec::Vec;
use core::ops::Range;

/// Copies numbers from place `first` on, and tells how many there are in all.
fn copied<T: Copy>(into: &mut [T], first: usize, visit: impl FnOnce(&mut dyn FnMut(T))) -> usize {
    let mut k = 0_usize;
    visit(&mut |x| {
        if let Some(place) = k.checked_sub(first).and_then(|k| into.get_mut(k)) {
            *place = x;
        }
        k += 1;
    });
    k
}

/// All numbers, for a list as long as they are.
fn all<T: Copy>(into: &mut [T], visit: impl FnOnce(&mut dyn FnMut(T))) -> Result<(), Error> {
    let given = into.len();
    counted("numbers to be copied", copied(into, 0, visit), given)
}

/// The numbers of a joint.
fn part<T: Scalar, const K: usize>(
    range: Range<usize>,
    visit: impl FnOnce(&mut dyn FnMut(T)),
) -> Result<[T; K], Error> {
    counted("numbers of a joint", range.len(), K)?;
    let mut part = [T::zero(); K];
    if copied(&mut part, range.start, visit) < range.end {
        return Err(Error::new(Fault::Shape));
    }
    Ok(part)
}

/// Replaces numbers from place `first` on, and tells how many there are in all.
fn replaced<T: Copy>(by: &[T], first: usize, replace: impl FnOnce(&mut dyn FnMut(T) -> T)) -> usize {
    let mut k = 0_usize;
    replace(&mut |old| {
        let new = k.checked_sub(first).and_then(|k| by.get(k)).copied();
        k += 1;
        new.unwrap_or(old)
    });
    k
}

fn all_finite<T: Scalar>(numbers: &[T], parameter: &'static str) -> Result<(), Error> {
    ensure_finite(numbers.iter().all(|x| x.is_finite()), parameter)
}

/// Reading and setting of one kind of rates.
macro_rules! rates {
    ($what:literal $lower:literal, $field:ident $field_mut:ident, $all:ident $all_into:ident $of:ident, $set_all:ident $set_of:ident) => {
        #[doc = concat!($what, " of all joints, root to tip, as a list.")]
        #[cfg(feature = "alloc")]
        pub fn $all(&self) -> Vec<T> {
            let mut list = Vec::new();
            self.$field.visit(&mut |x| list.push(x));
            list
        }

        #[doc = concat!($what, " of all joints, root to tip, into a list of the caller's.")]
        ///
        /// # Errors
        /// [`Fault::Count`] for a list of another length.
        pub fn $all_into(&self, list: &mut [T]) -> Result<(), Error> {
            all(list, |note| self.$field.visit(&mut |x| note(x)))
        }

        #[doc = concat!($what, " of a joint.")]
        ///
        /// # Errors
        /// [`Fault::Count`] where the joint has another number of them, [`Fault::Shape`] for a motion of another scene.
        pub fn $of<const K: usize>(&self, joint: JointNumbers) -> Result<[T; K], Error> {
            part(joint.rates(), |note| self.$field.visit(&mut |x| note(x)))
        }

        #[doc = concat!("Sets ", $lower, " of all joints, root to tip.")]
        ///
        /// # Errors
        /// [`Fault::Count`] for a list of another length, [`Fault::NotFinite`]; the motion is then as before.
        pub fn $set_all(&mut self, list: &[T]) -> Result<(), Error> {
            all_finite(list, $lower)?;
            counted($lower, self.rate_count(), list.len())?;
            replaced(list, 0, |make| self.$field_mut().replace(&mut |x| make(x)));
            Ok(())
        }

        #[doc = concat!("Sets ", $lower, " of a joint.")]
        ///
        /// # Errors
        /// [`Fault::Count`] where the joint has another number of them, [`Fault::NotFinite`], [`Fault::Shape`] for a motion of another
        /// scene; the motion is then as before.
        pub fn $set_of(&mut self, joint: JointNumbers, list: &[T]) -> Result<(), Error> {
            counted($lower, joint.rates().len(), list.len())?;
            all_finite(list, $lower)?;
            if self.rate_count() < joint.rates[1] {
                return Err(Error::new(Fault::Shape));
            }
            replaced(list, joint.rates[0], |make| self.$field_mut().replace(&mut |x| make(x)));
            Ok(())
        }
    };
}

/// # Plain lists
///
/// Coordinates, rates and accelerations as lists, joint after joint from the root to the tip, in the order in which the scene is
/// written. [`System::describe`](crate::system::System::describe) shows whose they are, and
/// [`System::joint`](crate::system::System::joint) finds those of a joint by its number or name:
///
/// ```
/// use catena::planar::*;
/// let rod = Rod::uniform(1.0, 1.0);
/// let arm = System::new(Pinned::origin(), (rod, Pin.named("elbow"), rod), Free)?;
/// let mut motion = arm.at_rest(&[0.3, -0.2])?;
/// let elbow = arm.joint("elbow")?;
/// motion.set_rates_of(elbow, &[1.5])?;
/// let [angle] = motion.coordinates_of(elbow)?;
/// assert_eq!((angle, motion.coordinates(), motion.rates()), (-0.2, vec![0.3, -0.2], vec![0.0, 1.5]));
/// # Ok::<(), catena::Error>(())
/// ```
///
/// A turn in space (a ball, an elastic hinge, a root that floats) has four coordinates, the quaternion `[w, x, y, z]` as it is stored,
/// and three rates. What is read and set again is the same to the last bit; a quaternion of another length is brought to length one.
/// The spring of an elastic hinge tells q from −q, which has turned by a whole turn more or less: see
/// [`ElasticHinge`](crate::spatial::ElasticHinge). A ball does not.
///
/// Accelerations no longer belong to coordinates or rates that were set until they are found anew
/// ([`with_accelerations`](crate::system::System::with_accelerations); a run does so by itself).
impl<T: Scalar, P: Position<T>, C: Closures> Motion<T, P, C> {
    /// How many numbers the list of coordinates has.
    pub fn coordinate_count(&self) -> usize {
        let mut count = 0;
        self.position.visit(&mut |_| count += 1);
        count
    }

    /// How many numbers the lists of rates and of accelerations have.
    pub fn rate_count(&self) -> usize {
        let mut count = 0;
        self.rate.visit(&mut |_| count += 1);
        count
    }

    /// Coordinates of all joints, root to tip, as a list.
    #[cfg(feature = "alloc")]
    pub fn coordinates(&self) -> Vec<T> {
        let mut list = Vec::new();
        self.position.visit(&mut |x| list.push(x));
        list
    }

    /// Coordinates of all joints, root to tip, into a list of the caller's.
    ///
    /// # Errors
    /// [`Fault::Count`] for a list of another length.
    pub fn coordinates_into(&self, list: &mut [T]) -> Result<(), Error> {
        all(list, |note| self.position.visit(&mut |x| note(x)))
    }

    /// Coordinates of a joint.
    ///
    /// # Errors
    /// [`Fault::Count`] where the joint has another number of them, [`Fault::Shape`] for a motion of another scene.
    pub fn coordinates_of<const K: usize>(&self, joint: JointNumbers) -> Result<[T; K], Error> {
        part(joint.coordinates(), |note| self.position.visit(&mut |x| note(x)))
    }

    /// Sets coordinates of all joints, root to tip.
    ///
    /// # Errors
    /// [`Fault::Count`] for a list of another length, [`Fault::NotFinite`], [`Fault::NotPositive`] for a quaternion without length; the
    /// motion is then as before.
    pub fn set_coordinates(&mut self, list: &[T]) -> Result<(), Error> {
        counted("coordinates", self.coordinate_count(), list.len())?;
        self.place(list, 0)
    }

    /// Sets coordinates of a joint.
    ///
    /// # Errors
    /// [`Fault::Count`] where the joint has another number of them, [`Fault::NotFinite`], [`Fault::NotPositive`] for a quaternion
    /// without length, [`Fault::Shape`] for a motion of another scene; the motion is then as before.
    pub fn set_coordinates_of(&mut self, joint: JointNumbers, list: &[T]) -> Result<(), Error> {
        counted("coordinates", joint.coordinates().len(), list.len())?;
        if self.coordinate_count() < joint.coordinates[1] {
            return Err(Error::new(Fault::Shape));
        }
        self.place(list, joint.coordinates[0])
    }

    /// Sets coordinates from place `first` on.
    fn place(&mut self, list: &[T], first: usize) -> Result<(), Error> {
        all_finite(list, "coordinate")?;
        let mut position = self.position.clone();
        replaced(list, first, |make| position.replace(&mut |x| make(x)));
        if !position.normalise() {
            return Err(Error::new(Fault::NotPositive { parameter: "length of the quaternion", value: 0.0 }));
        }
        self.position = position;
        Ok(())
    }

    rates!("Rates" "rates", rate rate_mut, rates rates_into rates_of, set_rates set_rates_of);
    rates!("Accelerations" "accelerations", acceleration acceleration_mut, accelerations accelerations_into accelerations_of, set_accelerations set_accelerations_of);
}
