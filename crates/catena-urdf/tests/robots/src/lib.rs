//! The robots of `catena-urdf`, as its modules say them. Their own tests run with those of this crate.

macro_rules! robots {
    ($($name:ident),*) => {$(
        #[allow(missing_docs)]
        pub mod $name {
            include!(concat!(env!("OUT_DIR"), "/", stringify!($name), ".rs"));
        }
    )*};
}
robots!(arm7, quadruped, humanoid, cart);
