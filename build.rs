//! Tells the sources whether they are optimised for speed (`cfg(optimised)`): what is longer than a few lines is inlined always only there. At level 1
//! a robot's implicit steps then take four to eight times as long to compile, and a third of the time to run.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(optimised)");
    if std::env::var("OPT_LEVEL").is_ok_and(|level| !matches!(&*level, "0" | "1")) {
        println!("cargo::rustc-cfg=optimised");
    }
}
