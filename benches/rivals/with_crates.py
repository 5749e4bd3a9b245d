"""Crates for Rust: phyz's own RK4, and ode_solvers over equations written by hand with a dense mass matrix, compiled for the default target."""

import pathlib
import subprocess

CRATE = pathlib.Path(__file__).parent / "crates"


def runs(kind, bodies, end, reference):
    if kind != "pins":
        return
    target = CRATE.parents[2] / "target" / "rivals-crates"
    command = ["cargo", "run", "--release", "--manifest-path", CRATE / "Cargo.toml", "--target-dir", target, "--bin", "catena-rivals", "--"]
    found = subprocess.run([*command, str(bodies), str(end), str(reference)], check=True, text=True, stdout=subprocess.PIPE)
    for line in found.stdout.splitlines():
        library, rule, setting, error, seconds = line.split(",")
        yield library, rule, float(setting), float(error), float(seconds)
