//! A law of the user's own goes backward by jets of its numbers: it has to say which these are.
//@ the numbers in `Stiffening<
//@ cannot be replaced by others, with derivatives say
//@ catena::lift!(Name { field, other })

use catena::planar::*;
use catena::{Fault, Scalar};

#[derive(Clone, Copy, Debug)]
struct Stiffening<T> {
    stiffness: T,
}

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
    let _ = scene.backward(Sdirk4::new());
    Ok(())
}
