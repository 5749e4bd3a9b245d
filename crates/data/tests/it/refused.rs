//! What is refused: other shapes by their names, parameters that make no mechanics, memories that no run has left.

use crate::record::{bits, read, same};
use catena::planar::*;
use catena::system::MotionOf;
use catena::{Error, Fault, spatial};
use serde::de::DeserializeOwned;

type Place = Pinned<[f64; 2]>;
type Rods = System<f64, Place, (Rod<f64>, Pin, Rod<f64>), Free>;
type Links = System<f64, Place, (Rod<f64>, Vec<(Pin, Rod<f64>)>), Free>;

fn rods() -> Result<Rods, Error> {
    let rod = Rod::uniform(1.0, 2.0);
    Ok(System::new(Pinned::origin(), (rod, Pin, rod), Free)?.with_gravity(9.81))
}

fn links(count: usize) -> Result<Links, Error> {
    let rod = Rod::uniform(1.0, 2.0);
    Ok(System::new(Pinned::origin(), (rod, vec![(Pin, rod); count]), Free)?.with_gravity(9.81))
}

fn reason<X: DeserializeOwned>(text: &str) -> String {
    serde_json::from_str::<X>(text).err().unwrap().to_string()
}

#[test]
fn a_scene_of_another_shape_is_refused_by_name() -> Result<(), Error> {
    type Plates = System<f64, Place, (Rod<f64>, Pin, RigidBody<f64>), Free>;
    type InSpace = spatial::System<f64, spatial::Pinned<[f64; 3]>, (spatial::Rod<f64>, spatial::Ball), spatial::Free>;
    let text = serde_json::to_string(&rods()?).unwrap();
    let shape = "(Planar<f64>, Pinned<[f64; 2]>, (Rod<f64>, Pin, Rod<f64>), Free)";
    assert!(text.starts_with(&format!("{{\"shape\":\"{shape}\",")), "{text}");
    let refused = reason::<Plates>(&text);
    let expected = "(Planar<f64>, Pinned<[f64; 2]>, (Rod<f64>, Pin, RigidBody<f64>), Free) is read";
    assert!(refused.contains(shape) && refused.contains(expected), "{refused}");
    // A format without names tells no rod from a plate, but for the shape.
    let bytes = bits(&rods()?);
    assert!(postcard::from_bytes::<Rods>(&bytes).is_ok());
    assert!(postcard::from_bytes::<Plates>(&bytes).is_err());
    assert!(postcard::from_bytes::<Links>(&bytes).is_err());
    let chain = (spatial::Rod::uniform(1.0, 0.1, 1.0), spatial::Ball, spatial::Rod::uniform(1.0, 0.1, 1.0));
    let space = spatial::System::new(spatial::Pinned::origin(), chain, spatial::Free)?;
    let text = serde_json::to_string(&space.motion()).unwrap();
    assert!(reason::<MotionOf<Planar<f64>, Place, (Rod<f64>, Pin, Rod<f64>), Free>>(&text).contains("another shape"));
    let _: Option<InSpace> = None;
    Ok(())
}

#[test]
fn parameters_that_make_no_mechanics_are_refused() -> Result<(), Error> {
    let text = serde_json::to_string(&rods()?).unwrap();
    for (old, new, why) in [
        ("\"length\":1.0", "\"length\":-1.0", "length must be positive"),
        ("\"length\":1.0", "\"length\":1e999", "out of range"),
        ("\"root\":{\"place\":[0.0,", "\"root\":{\"place\":[null,", "null"),
    ] {
        assert!(text.contains(old), "{text}");
        let refused = reason::<Rods>(&text.replacen(old, new, 1));
        assert!(refused.contains(why), "{refused}");
    }
    // Axes that stretch.
    type Hinged = spatial::System<
        f64,
        spatial::Clamped<[f64; 3], spatial::Rotation<f64>>,
        (spatial::Rod<f64>, spatial::Revolute<f64>, spatial::Rod<f64>),
        spatial::Free,
    >;
    let rod = spatial::Rod::uniform(1.0, 0.1, 1.0);
    let chain = (rod, spatial::Revolute::about([0.0, 0.0, 1.0]), rod);
    let scene: Hinged = spatial::System::new(spatial::Clamped::origin(), chain, spatial::Free)?;
    let text = serde_json::to_string(&scene).unwrap();
    assert!(serde_json::from_str::<Hinged>(&text).is_ok());
    let stretched = text.replacen("\"axis\":[0.0,0.0,1.0]", "\"axis\":[0.0,0.0,1.5]", 1);
    assert!(reason::<Hinged>(&stretched).contains("length of the axis"), "{stretched}");
    let turned = text.replacen("[1.0,0.0,0.0,0.0]", "[1.0,1.0,0.0,0.0]", 1);
    assert!(reason::<Hinged>(&turned).contains("length of the quaternion"), "{turned}");
    Ok(())
}

#[test]
fn laws_motors_and_contacts_are_data() -> Result<(), Error> {
    type Hinge = ElasticHinge<Custom<(DryFriction<f64, f64>, Stops<f64, f64>)>>;
    type Leg = System<f64, Place, (Rod<f64>, Hinge, Rod<f64>), Free>;
    let laws = (DryFriction::new(0.2, 0.01).breaking_away(0.3), Stops::between([-0.3, 2.0], 2e3, 0.02).damped(0.5));
    let rod = Rod::uniform(0.5, 1.0);
    let leg: Leg = System::new(Pinned::origin(), (rod, ElasticHinge::with(laws), rod), Free)?;
    let text = serde_json::to_string(&leg).unwrap();
    assert_eq!(bits(&serde_json::from_str::<Leg>(&text).unwrap()), bits(&leg));
    for (old, new, why) in [
        ("\"speed\":0.01", "\"speed\":0.0", "speed over which dry friction sets in must be positive"),
        ("\"depth\":0.02", "\"depth\":-1.0", "depth over which stops set in must be positive"),
    ] {
        assert!(text.contains(old), "{text}");
        assert!(reason::<Leg>(&text.replacen(old, new, 1)).contains(why));
    }
    let motor = Motor::new(2.0, 300.0).stalling_at(3.0).geared(50.0).with_rotor(1e-4);
    assert_eq!(serde_json::from_str::<Motor<f64>>(&serde_json::to_string(&motor).unwrap()).unwrap(), motor);
    let law = spatial::Contact::new(1e4, 1e-4).damped(2.0).rubbing(0.7, 0.01);
    let contacts = spatial::Contacts::of([(0, [0.0, 0.1, 0.2])], spatial::Plane::level(-0.1), law);
    let read = |text: &str| serde_json::from_str::<spatial::Contacts<[(usize, [f64; 3]); 1], _, _>>(text);
    assert_eq!(read(&serde_json::to_string(&contacts).unwrap()).unwrap(), contacts);
    Ok(())
}

/// What is read moves a scene as what was written; a strut without its kind, a rope for example, is none.
#[test]
fn struts_and_couplings_are_data() -> Result<(), Error> {
    let (rod, turn) = (Rod::uniform(0.5, 1.0), Revolute::smooth());
    let scene = System::new(Pinned::<[f64; 2]>::origin(), (rod, turn, rod, turn, rod), Free)?.with_gravity(9.81);
    let rope = Strut::to_ground((2, [0.5, 0.0]), [0.3, 0.4]).with_stiffness(50.0).with_length(0.4).pulling();
    let struts = Struts::of([rope.with_law(Spring::new(3.0).damped(0.2).resting_at(0.1))]);
    let loads = Couplings::of(&scene, [Coupling::new(2, 1).ratio(-0.7).offset(0.1)])?.and(struts);
    let start = loads.joined(scene.at_rest(&[0.3, 0.2, 0.0])?);
    let written = scene.simulation(Dop853::tolerance(1e-9)).loads(&loads).run(start, 0.5, |_| ())?.motion;
    for loads in read(&loads) {
        let found = scene.simulation(Dop853::tolerance(1e-9)).loads(&loads).run(start, 0.5, |_| ())?.motion;
        same("under struts and couplings", &found, &written);
    }
    let text = serde_json::to_string(&struts).unwrap();
    assert!(
        reason::<Struts<f64, 2, 1, Unloaded, Spring<f64, f64, f64>>>(&text.replace("acts", "act")).contains("acts")
    );
    Ok(())
}

#[test]
fn runs_of_other_scenes_and_of_none_do_not_go_on() -> Result<(), Error> {
    let (three, four) = (links(2)?, links(3)?);
    let start = |scene: &Links| scene.at_rest(&vec![-0.5; scene.bodies()]);
    // Three bodies remembered, four moving.
    let run = three.simulation(Adams::step(0.01)).begin(start(&three)?, 1.0, |_| ()).unwrap();
    let mut saved = run.save();
    saved.motion = start(&four)?;
    let refused = four.simulation(Adams::step(0.01)).resume(saved, 1.0, |_| ()).err().unwrap();
    assert_eq!(refused.error.fault, Fault::Shape);
    // Places in a ring that it does not have.
    let run = three.simulation(Vcabm::new().tolerance(1e-6)).begin(start(&three)?, 1.0, |_| ()).unwrap();
    let text = serde_json::to_string(&run.save()).unwrap();
    for (old, new) in
        [("\"newest\":0", "\"newest\":99"), ("\"order\":1", "\"order\":13"), ("\"known\":0", "\"known\":1000")]
    {
        assert!(text.contains(old), "{text}");
        let saved = serde_json::from_str(&text.replacen(old, new, 1)).unwrap();
        let refused = three.simulation(Vcabm::new().tolerance(1e-6)).resume(saved, 1.0, |_| ()).err().unwrap();
        assert_eq!(refused.error.fault, Fault::Shape);
    }
    // Gains of hinges that a vector does not have.
    let link = (ElasticHinge::rotary(10.0), Rod::uniform(1.0, 2.0));
    let sprung = |count| System::new(Clamped::at(0.0, 0.0, 0.0), vec![link; count], Free);
    let (two, three_links) = (sprung(2)?, sprung(3)?);
    let mut saved = two.simulation(Sdirk4::new().step(0.01)).begin(two.motion(), 1.0, |_| ()).unwrap().save();
    saved.motion = three_links.motion();
    let refused = three_links.simulation(Sdirk4::new().step(0.01)).resume(saved, 1.0, |_| ()).err().unwrap();
    assert_eq!(refused.error.fault, Fault::Shape);
    // More samples than can be counted.
    let text = serde_json::to_string(&run.save()).unwrap();
    let longer = text.replacen("\"samples\":1", &format!("\"samples\":{}", u64::MAX), 1);
    let saved = serde_json::from_str(&longer).unwrap();
    let refused = three.simulation(Vcabm::new().tolerance(1e-6)).resume(saved, 1.0, |_| ()).err().unwrap();
    assert_eq!(refused.error.fault, Fault::NotFinite { parameter: "progress of a run" });
    Ok(())
}

#[test]
fn runs_go_on_by_other_steps_and_samples() -> Result<(), Error> {
    let scene = rods()?;
    let mut run = scene.simulation(Rk4::step(0.01)).begin(scene.at_rest(&[-1.0, -0.5])?, 2.0, |_| ()).unwrap();
    run.until(1.0)?;
    let saved = run.save();
    let whole = run.finish().unwrap().motion;
    let mut times = vec![];
    let shorter = scene.simulation(Rk4::step(0.002)).every(0.25);
    let end = shorter.resume(saved, 2.0, |now| times.push(now.time())).unwrap().finish().unwrap();
    assert_eq!((end.steps, times), (100 + 500, vec![1.25, 1.5, 1.75, 2.0]));
    let apart =
        end.motion.coordinates().iter().zip(whole.coordinates()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart < 1e-5, "{apart:e}"); // of order four: 2e-7 found
    Ok(())
}
