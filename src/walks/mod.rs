//! Walks over chains, one a file: a value that says what is done at a body and at a joint.
//!
//! No composite, body or joint names a walk. So a new one is a file here, a line below and a call where it is used;
//! [`extend::walks`](crate::extend::walks) shows one, and what is easily done wrong. And, within this crate:
//!
//! * A walk in which closure forces act is another one in each arm of a loop. It overrides
//!   [`Outward::parallel`](crate::shape::Outward::parallel), finds the forces there, and sends walks of its own into both arms
//!   ([`respond`], [`restore`], [`recover`]).
//!
//! Walks that ask of bodies and joints more than all of them have to say are [selective](crate::shape::Selective): [`orient`], [`factor`], [`reach`],
//! [`meet`], [`stir`] and [`pull_back`], with [`burden`] and [`pull_loads`] under loads, the [costate sweep](crate::adjoint); those of [`series`], the [Taylor series](crate::series). A chain with an element that does not know them does not compile.
//!
//! Not yet walks: the condensation, whose arguments could be a bundle once it is known why chains in space would then cost more on
//! targets without wide registers; poses; lumping of point masses, which changes elements; and the walks of derivatives
//! ([`Sensitive`](crate::sensitive::Sensitive)), for which the plain element has to become a store.

pub mod apart;
pub mod broken;
pub mod burden;
pub mod carrier;
pub mod check;
pub mod complete;
pub mod configure;
pub mod copy;
pub mod count;
pub mod entries;
pub mod exert;
pub mod faced;
pub mod factor;
pub mod find;
pub mod fits;
pub mod gather;
pub mod independent;
pub mod look;
pub mod loose;
pub mod measure;
pub mod meet;
pub mod missed;
pub mod orient;
pub mod parts;
pub mod posed;
pub mod pull_back;
pub mod pull_loads;
pub mod reach;
pub mod recover;
pub mod respond;
pub mod restore;
pub mod series;
pub mod sines;
pub mod singled;
pub mod size;
pub mod spread;
pub mod steer;
pub mod stir;
pub mod strain;
pub mod swept;
pub mod travel;
pub mod unspread;

pub use burden::Burden;
pub use factor::Factor;
pub use meet::Meet;
pub use orient::Orient;
pub use pull_back::PullBack;
pub use pull_loads::{LAW, PullLoads};
pub use reach::Reach;
pub use stir::Stir;
pub use strain::{Led, Strain};
