//! The same outcomes from one process and from two.

use std::process::Command;

/// What a job prints, but for its first numbers, its own count of processes and the time it took.
fn printed(processes: &str) -> Vec<String> {
    // Open MPI asks for leave to run more processes than there are cores, MPICH knows no such word.
    let version = Command::new("mpirun").arg("--version").output().expect("an installed MPI").stdout;
    let leave = String::from_utf8_lossy(&version).contains("Open MPI").then_some("--oversubscribe");
    let job = Command::new("mpirun")
        .args(leave)
        .args(["-n", processes, env!("CARGO_BIN_EXE_catena-processes"), "12"])
        .envs([("OMPI_ALLOW_RUN_AS_ROOT", "1"), ("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1"), ("RAYON_NUM_THREADS", "2")])
        .output()
        .expect("an installed MPI");
    let text = String::from_utf8_lossy(&job.stdout).into_owned();
    assert!(job.status.success(), "{text}{}", String::from_utf8_lossy(&job.stderr));
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let counts: Vec<String> = lines[1].split_whitespace().map(str::to_owned).collect();
    assert_eq!(counts[0], processes);
    lines[1] = counts[1..5].join(" ");
    lines
}

#[test]
fn two_processes_find_what_one_finds() {
    let (one, two, three) = (printed("1"), printed("2"), printed("3"));
    assert!(one[1].starts_with("144 ") && one[3].contains("finite"), "{one:?}");
    assert_eq!(one, two);
    assert_eq!(one, three, "145 starts are shared unevenly");
}
