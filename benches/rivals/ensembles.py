"""Ensembles beside MuJoCo's `rollout`: what a scene and step cost on one thread and on all cores.

    target/rivals/bin/python benches/rivals/ensembles.py

Catena's ways (`benches/ensembles`, for x86-64-v3) and MuJoCo's (its RK4, constraints off, all steps of all scenes in one call, states of each step
written out, as that call does) run one after the other on the same machine. Writes benches/results/ensembles.csv, from which
`cargo run -p catena-report` makes the table of BENCHMARKS.md.
"""

import os
import pathlib
import statistics
import subprocess
import time

import mujoco
import numpy
from mujoco import rollout
from with_mujoco import chain

ROOT = pathlib.Path(__file__).parent.parent.parent
SCENES = [("2 rods on pins", "pins", 2), ("20 rods on pins", "pins", 20), ("3 rods on balls", "balls", 3)]
STEPS, STEP, STARTS, ROUNDS = 1000, 1e-3, 64, 5


def theirs(kind, bodies, threads):
    """Nanoseconds of a scene and step: the median of rounds."""
    model = chain(kind, bodies)
    model.opt.timestep = STEP
    data = mujoco.MjData(model)
    starts = []
    for k in range(STARTS):
        mujoco.mj_resetData(model, data)
        if kind == "pins":
            data.qpos[0] = -0.5 + k / STARTS
        else:
            data.qvel[0:2], data.qvel[3:5] = (1.0 + k / STARTS, 2.0), (-1.0 - k / STARTS, -2.0)
        state = numpy.empty(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
        mujoco.mj_getState(model, data, state, mujoco.mjtState.mjSTATE_FULLPHYSICS)
        starts.append(state)
    workers = [mujoco.MjData(model) for _ in range(threads)]
    seconds = []
    with rollout.Rollout(nthread=threads if threads > 1 else 0) as rolled:
        for _ in range(ROUNDS):
            clock = time.perf_counter()
            rolled.rollout(model, workers, numpy.array(starts), nstep=STEPS)
            seconds.append(time.perf_counter() - clock)
    return 1e9 * statistics.median(seconds) / (STARTS * STEPS)


def main():
    environment = {**os.environ, "RUSTFLAGS": "-C target-cpu=x86-64-v3"}
    command = ["cargo", "run", "--release", "-p", "catena-ensembles", "--target-dir", str(ROOT / "target" / "ens")]
    lines = subprocess.run(command, cwd=ROOT, env=environment, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    for name, kind, bodies in SCENES:
        alone = theirs(kind, bodies, 1)
        for threads in [1, os.cpu_count()]:
            taken = alone if threads == 1 else theirs(kind, bodies, threads)
            lines.append(f"{name},MuJoCo rollout,f64,1,{threads},{taken:.2f},{taken / alone:.4f}")
    (ROOT / "benches" / "results" / "ensembles.csv").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
