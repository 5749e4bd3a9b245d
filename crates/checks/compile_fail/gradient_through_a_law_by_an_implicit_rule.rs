//! The costate sweep of an implicit rule does not know laws that are not linear.
//@ no gradient of a run by an implicit rule goes backward through the law `
//@ Stiffening

use catena::planar::*;
use catena::{Fault, Scalar};

#[derive(Clone, Copy, Debug)]
struct Stiffening<T> {
    stiffness: T,
}
catena::lift!(Stiffening { stiffness });

impl<T: Scalar> SpringLaw<T> for Stiffening<T> {
    fn force(&self, position: T, _: T) -> T {
        -self.stiffness * position * position * position
    }
    fn energy(&self, position: T) -> T {
        (self.stiffness * position * position * position * position).scale(num(0.25))
    }
    fn pivot(&self, position: T, _: T, springs: impl Springs<T>) -> T {
        springs.pivot((self.stiffness * position * position).scale(num(3.0)), T::zero())
    }
    fn check(&self) -> Result<(), Fault> {
        Ok(())
    }
}

fn num<R: catena::Real>(x: f64) -> R {
    R::of(x)
}

fn main() -> Result<(), catena::Error> {
    let (rod, hinge) = (Rod::uniform(1.0, 1.0), ElasticHinge::with(Stiffening { stiffness: 1.0 }));
    let scene = System::new(Pinned::origin(), (rod, hinge, rod), Free)?;
    let _ = scene.backward(Rk4);
    let _ = scene.backward(Sdirk4::new());
    Ok(())
}
