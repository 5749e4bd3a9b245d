//! Struts with a law of the user's own: against the same law in a slide, as muscles and pads, in lists beside each other.

use catena::scalar::{Jet, Scalar};
use catena::{Error, Fault, planar, spatial};
use catena_oracle::near;
use planar::{SpringLaw, Springs};

/// A spring that stiffens and a damper that does, −k (x + β x³) − c (1 + x²) v with x beyond a rest.
#[derive(Clone, Copy, Debug)]
struct Stiffening<T> {
    stiffness: T,
    more: T,
    damping: T,
    rest: T,
}
catena::lift!(Stiffening<T> { stiffness, more, damping, rest });

impl<T: Scalar> SpringLaw<T> for Stiffening<T> {
    fn force(&self, position: T, rate: T) -> T {
        let x = position - self.rest;
        -self.stiffness * (x + self.more * x * x * x) - self.damping * (T::one() + x * x) * rate
    }
    fn energy(&self, position: T) -> T {
        let square = (position - self.rest) * (position - self.rest);
        self.stiffness * square * (T::literal(0.5) + T::literal(0.25) * self.more * square)
    }
    fn pivot(&self, position: T, rate: T, springs: impl Springs<T>) -> T {
        let x = position - self.rest;
        let slope = self.stiffness * (T::one() + T::literal(3.0) * self.more * x * x);
        let stiffness = slope + T::literal(2.0) * self.damping * x * rate;
        springs.pivot(stiffness, self.damping * (T::one() + x * x))
    }
    fn check(&self) -> Result<(), Fault> {
        if self.stiffness.is_finite() { Ok(()) } else { Err(Fault::NotFinite { parameter: "stiffness of a law" }) }
    }
}

fn stiffening(stiffness: f64, rest: f64) -> Stiffening<f64> {
    Stiffening { stiffness, more: 2.0, damping: 0.01 * stiffness, rest }
}

/// A strut along a track does what its law does in the slide on it: by rules that take its force as it is, and by those that know its slope, step by
/// step.
#[test]
fn a_law_along_a_track_is_that_of_its_slide() -> Result<(), Error> {
    macro_rules! alike {
        ($space:ident, $slide:expr, $block:expr, $gravity:expr, $behind:expr, $D:literal) => {{
            use $space::*;
            for stiffness in [1e2, 1e5] {
                let slide = $slide;
                let free = System::new(Clamped::origin(), (slide, $block), Free)?.with_gravity($gravity);
                let sprung = (slide.with(stiffening(stiffness, 0.3)), $block);
                let sprung = System::new(Clamped::origin(), sprung, Free)?.with_gravity($gravity);
                let (mut one, mut other) = (sprung.motion(), free.motion());
                one.set_coordinates(&[0.5])?;
                other.set_coordinates(&[0.5])?;
                let strut = Strut::to_ground((0, [0.0; $D]), $behind).with_law(stiffening(stiffness, 1.3));
                let struts = Struts::of([strut]);
                let stored = sprung.budget(&one)?.potential - free.budget(&other)?.potential;
                near(struts.readings(&free, &other)?[0].energy, stored, 1e-13 * stored);
                macro_rules! by {
                    ($loads:expr, $rule:expr) => {
                        let expected = sprung.simulation($rule).run(one, 0.2, |_| ())?;
                        let found = free.simulation($rule).loads(&$loads).run(other, 0.2, |_| ())?;
                        near(found.motion.coordinates()[0], expected.motion.coordinates()[0], 1e-12);
                        near(found.motion.rates()[0], expected.motion.rates()[0], 1e-11);
                    };
                }
                by!(struts, Rk4::step(1e-4));
                by!(struts.stiff(), GeneralizedAlpha::new(0.8).step(0.01));
                by!(struts.stiff(), Sdirk4::default().step(0.01));
                by!(struts.stiff(), Sdirk4::default().tolerance(1e-8));
            }
        }};
    }
    let block = planar::RigidBody::new(2.0, 0.1, [0.0; 2], [0.0; 2]);
    alike!(planar, Slider::along(0.3), block, 9.81, [-0.3_f64.cos(), -0.3_f64.sin()], 2);
    let block = spatial::RigidBody::new(2.0, [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]], [0.0; 3], [0.0; 3]);
    alike!(spatial, Prismatic::along([0.6, 0.0, 0.8]), block, [0.0, 0.0, -9.81], [-0.6, 0.0, -0.8], 3);
    Ok(())
}

/// Beside a spring and damper of the strut itself what a law does adds up; a muscle pulls alone, a pad pushes alone.
#[test]
fn a_law_adds_to_a_strut_and_is_cut_where_that_does_not_act() -> Result<(), Error> {
    use planar::*;
    let rod = Rod::uniform(1.0_f64, 1.0);
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81);
    let mut start = scene.at_rest(&[-0.3, 0.4])?;
    start.set_rates(&[0.5, -0.8])?;
    let plain =
        Strut::between((0, [0.2, 0.1]), (1, [0.6, 0.0])).with_stiffness(40.0).with_damping(3.0).with_length(0.7);
    let law = Stiffening { stiffness: 25.0, more: 0.5, damping: 2.0, rest: 0.9 };
    let with = |strut| Ok::<_, Error>(scene.with_accelerations(start, &Struts::of([strut]))?.accelerations());
    // The same by a strut with the force that it has there.
    let [reading] = Struts::of([plain]).readings(&scene, &start)?;
    let of_law = -law.force(reading.length, reading.rate);
    let [whole] = Struts::of([plain.with_law(law)]).readings(&scene, &start)?;
    near(whole.tension, reading.tension + of_law, 1e-14);
    near(whole.energy, reading.energy + law.energy(reading.length), 1e-14);
    // One list beside another.
    let alone = Strut::between((0, [0.2, 0.1]), (1, [0.6, 0.0])).with_law(law);
    let both = Struts::of([plain]).and(Struts::of([alone]));
    let both = scene.with_accelerations(start, &both)?.accelerations();
    let one = with(plain.with_law(law))?;
    one.iter().zip(both).for_each(|(a, b)| near(*a, b, 1e-12));
    // At a distance at which it pulls, and at one at which it would push.
    let none = scene.with_accelerations(start, &Unloaded)?.accelerations();
    for (rest, pulls) in [(0.3, true), (3.0, false)] {
        let strut = Strut::between((0, [0.2, 0.1]), (1, [0.6, 0.0])).with_law(Stiffening { rest, ..law });
        let [both, pulling, pushing] = [strut, strut.pulling(), strut.with_length(9.0).pushing()];
        let [both, pulling, pushing] = [with(both)?, with(pulling)?, with(pushing)?];
        let (acts, rests) = if pulls { (pulling, pushing) } else { (pushing, pulling) };
        assert_eq!(acts, both);
        rests.iter().zip(&none).for_each(|(a, b)| near(*a, *b, 1e-12));
    }
    let broken = Struts::of([plain.with_law(Stiffening { stiffness: f64::NAN, ..law })]);
    let found = scene.with_accelerations(start, &broken).unwrap_err();
    assert_eq!(found.fault, Fault::NotFinite { parameter: "stiffness of a law" });
    Ok(())
}

/// Over jets, by the numbers of the law: a plain run and an implicit one that knows its slope, against each other.
#[test]
fn derivatives_follow_the_law() -> Result<(), Error> {
    use planar::*;
    let numbers = [80.0, 1.5, 1.0, 0.9];
    let of = Jet::<f64, 4>::of;
    let rod = Rod::uniform(of(1.0), of(1.0));
    let scene = System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(of(9.81));
    let [stiffness, more, damping, rest] = core::array::from_fn(|k| Jet::seed(numbers[k], k));
    let law = Stiffening { stiffness, more, damping, rest };
    let struts = Struts::of([Strut::to_ground((1, [of(0.6), of(0.0)]), [of(1.8), of(0.4)]).with_law(law)]);
    let start = scene.at_rest(&[of(-0.3), of(0.4)])?;
    let plain = scene.simulation(Dop853::tolerance(1e-11)).loads(&struts).run(start, 0.5, |_| ())?.motion.coordinates();
    let stiff = scene.simulation(Sdirk4::new().step(1e-3)).loads(&struts.stiff()).run(start, 0.5, |_| ())?;
    for (a, b) in plain.iter().zip(stiff.motion.coordinates()) {
        near(a.re, b.re, 1e-9);
        a.eps.iter().zip(b.eps).for_each(|(a, b)| near(*a, b, 1e-7 * a.abs()));
    }
    Ok(())
}
