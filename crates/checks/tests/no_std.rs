//! Without std and without an allocator: the crate in no_std becomes a static library, and a C program steps it.
//!
//! It is a crate of its own, so that it gets the features it asks for and no others.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Runs a command and gives what it printed; `None` where there is no such program.
fn run(command: &mut Command) -> Result<Option<String>, Box<dyn Error>> {
    let output = match command.output() {
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            println!("skipped, for want of {:?}", command.get_program());
            return Ok(None);
        }
        output => output?,
    };
    if !output.status.success() {
        return Err(format!("{command:?}:\n{}", String::from_utf8_lossy(&output.stderr)).into());
    }
    Ok(Some(String::from_utf8(output.stdout)?))
}

#[test]
fn links_and_steps_without_std_or_alloc() -> Result<(), Box<dyn Error>> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = here.join("../..");
    let embedded = here.join("no_std");
    if !embedded.join("Cargo.toml").exists() {
        println!("skipped: packages leave nested crates out");
        return Ok(());
    }
    // The versions that are tested here anyway, so that nothing new is looked up.
    if root.join("Cargo.lock").exists() {
        std::fs::copy(root.join("Cargo.lock"), embedded.join("Cargo.lock"))?;
    }
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("no_std");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--release", "--target-dir"]).arg(&folder).arg("--manifest-path");
    run(cargo.arg(embedded.join("Cargo.toml")).env_remove("CARGO_BUILD_TARGET"))?;
    if cfg!(not(target_os = "linux")) {
        println!("skipped the rest: names of libraries and symbols are those of Linux");
        return Ok(());
    }

    let library = folder.join("release/libcatena_no_std.a");
    if let Some(symbols) = run(Command::new("nm").arg(&library))? {
        assert!(symbols.contains(" T double_pendulum"));
        let allocating: Vec<_> = symbols.lines().filter(|line| line.contains("rust_alloc")).collect();
        assert!(allocating.is_empty(), "{allocating:?}");
    }

    let program = folder.join("double_pendulum");
    let mut cc = Command::new("cc");
    if run(cc.arg("-o").arg(&program).arg(embedded.join("main.c")).arg(&library))?.is_some() {
        let printed = run(&mut Command::new(&program))?.ok_or("the program was just made")?;
        let angles: Vec<f64> = printed.split_whitespace().map(str::parse).collect::<Result<_, _>>()?;
        println!("angles {angles:?}");
        let off = [angles[0] + 1.3564198519106136, angles[1] + 1.1306522396578225];
        assert!(off.iter().all(|off| off.abs() < 1e-10), "{off:?}"); // RK4 with steps of 1 ms
    }
    Ok(())
}
