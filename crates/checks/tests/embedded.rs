//! One step of an arm of seven joints on a microcontroller: linked for thumbv7em-none-eabihf in f32, its code counted, and no panic in it.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

const TARGET: &str = "thumbv7em-none-eabihf";
/// Most that the step may take, and the whole program, which makes the scene and checks it first (bytes of code).
const MOST: [usize; 2] = [20_000, 23_000];

/// Little-endian numbers of an ELF file.
struct Elf(Vec<u8>);

impl Elf {
    fn number(&self, at: usize, bytes: usize) -> usize {
        self.0[at..at + bytes].iter().rev().fold(0, |sum, byte| 256 * sum + usize::from(*byte))
    }

    fn text(&self, at: usize) -> String {
        let bytes = self.0[at..].iter().take_while(|byte| **byte != 0);
        bytes.map(|byte| char::from(*byte)).collect()
    }

    /// Section headers of 32 bits: name, type, flags, address, offset, size, link, info, alignment, size of an entry.
    fn sections(&self) -> Vec<[usize; 10]> {
        let (start, size, count) = (self.number(32, 4), self.number(46, 2), self.number(48, 2));
        (0..count).map(|k| core::array::from_fn(|word| self.number(start + k * size + 4 * word, 4))).collect()
    }

    /// Names and sizes of functions.
    fn functions(&self) -> Vec<(String, usize)> {
        const SYMBOLS: usize = 2;
        const FUNCTION: usize = 2;
        let (sections, mut found) = (self.sections(), vec![]);
        for [_, kind, _, _, offset, size, link, ..] in &sections {
            if *kind != SYMBOLS {
                continue;
            }
            for at in (*offset..offset + size).step_by(16) {
                if self.0[at + 12] & 15 == FUNCTION as u8 {
                    found.push((self.text(sections[*link][4] + self.number(at, 4)), self.number(at + 8, 4)));
                }
            }
        }
        found
    }

    /// Bytes of code.
    fn code(&self) -> usize {
        const EXECUTABLE: usize = 4;
        self.sections().iter().filter(|section| section[2] & EXECUTABLE != 0).map(|section| section[5]).sum()
    }
}

#[test]
fn a_step_of_an_arm_is_small_and_does_not_panic() -> Result<(), Box<dyn Error>> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (root, embedded) = (here.join("../.."), here.join("../embedded"));
    if !embedded.join("Cargo.toml").exists() {
        println!("skipped: packages leave nested crates out");
        return Ok(());
    }
    let library = Command::new("rustc").args(["--print", "target-libdir", "--target", TARGET]).output();
    let there = library.is_ok_and(|output| Path::new(String::from_utf8_lossy(&output.stdout).trim()).exists());
    if !there {
        println!("skipped, for want of the target: rustup target add {TARGET}");
        return Ok(());
    }
    // The versions that are tested here anyway, so that nothing new is looked up.
    if root.join("Cargo.lock").exists() {
        std::fs::copy(root.join("Cargo.lock"), embedded.join("Cargo.lock"))?;
    }
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("embedded");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--release", "--target", TARGET, "--target-dir"]).arg(&folder).arg("--manifest-path");
    // Flags of the machine at hand are none of the other's.
    cargo.arg(embedded.join("Cargo.toml")).env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS");
    let output = cargo.output()?;
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));

    let elf = Elf(std::fs::read(folder.join(TARGET).join("release/catena-embedded"))?);
    let functions = elf.functions();
    let size = |name: &str| functions.iter().filter(|(own, _)| own.contains(name)).map(|(_, size)| size).sum::<usize>();
    let (code, start) = (elf.code(), size("_start"));
    println!("{code} bytes of code, {start} of which make the scene and check it");
    functions.iter().filter(|(_, size)| *size > 500).for_each(|(name, size)| println!("{size:6} {name}"));
    let panics: Vec<_> = functions.iter().filter(|(name, _)| name.contains("panic")).collect();
    assert!(panics.is_empty(), "{panics:?}");
    assert!(start > 0 && size("swept") > 0);
    assert!(code - start <= MOST[0] && code <= MOST[1], "{code} bytes, {start} at the start");
    Ok(())
}
