//! Counting: instructions of a program under callgrind, of the valgrind that the variable `VALGRIND` names, or of the system's.

use std::path::Path;
use std::process::Command;

/// Instructions that a program takes with these words on its command line. The count is exact.
pub fn count(program: &Path, words: &[&str]) -> Result<u64, String> {
    let output = valgrind()
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args(words)
        .output()
        .map_err(|error| format!("valgrind does not start: {error}"))?;
    let text = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(format!("valgrind fails at {words:?}: {text}")); // it may not know an instruction
    }
    let number = text.lines().find_map(|line| line.split_once("Collected :")?.1.trim().parse().ok());
    number.ok_or_else(|| format!("no count for {words:?} from valgrind: {text}"))
}

/// Whether valgrind is there.
#[allow(dead_code)] // not all that count ask
pub fn has_valgrind() -> bool {
    valgrind().arg("--version").output().is_ok_and(|output| output.status.success())
}

fn valgrind() -> Command {
    Command::new(std::env::var_os("VALGRIND").unwrap_or_else(|| "valgrind".into()))
}
