//! Any text is a robot, written as a module without numbers that are none, or a typed error.
#![no_main]

use catena_urdf::{Base, Frames, Options, module};

libfuzzer_sys::fuzz_target!(|text: &str| {
    for options in [Options::new(), Options::new().base(Base::Floating).snap(1e-3).repair().frames(Frames::Parallel)] {
        match options.read(text) {
            Ok(robot) => assert!(!module(&robot, "robot").contains("f64::NAN")),
            Err(error) => assert!(!error.to_string().is_empty()),
        }
    }
});
