//! What exported macros expand to, and what tests and benchmarks look into. No promise is made about any of it: users find what they need
//! in the other modules.

pub mod counts {
    pub use crate::counts::Counted;
}
pub mod element {
    pub use crate::element::{Condense, Element, Given, InJoint, Posture, Space, Springs, Sweep};
    pub use crate::sweep::{Implicit, Reading};
}
#[cfg(all(feature = "alloc", any(feature = "std", feature = "libm")))]
pub mod front {
    pub use crate::sensitivity::front::parts::{
        NO_SEEDS, OfNumbers, efforts, goes_on, held, keeps_modes, known, seeded, shown, split, state, time_after,
    };
    pub use alloc::vec::Vec;
}
pub mod planar {
    pub use crate::mechanics::planar::{Body, Joint};
}
pub mod relation {
    pub use crate::relation::{AccelerationOf, Closures, Cut, Full, planar, spatial};
}
pub mod shape {
    pub use crate::shape::{
        AsJoint, Field, Inward, Joint, JointPosture, Kept, Member, Of, Outward, PerAxes, Selective, Shape, Slot, Takes,
    };
}
pub mod space {
    pub use crate::space::FrameOf;
}
pub mod spatial {
    pub use crate::mechanics::spatial::{Body, Joint};
}
pub mod transfer {
    pub use crate::transfer::Efforts;
}
pub mod walks {
    pub use crate::walks::check;
}
