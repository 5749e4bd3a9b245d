"""A step in real time of a quadruped that stands on its feet, beside MuJoCo's.

    python3 -m venv target/rivals && target/rivals/bin/pip install -r benches/rivals/requirements.txt
    target/rivals/bin/python benches/rivals/real_time.py

Both read crates/catena-urdf/robots/quadruped.urdf, with its damping, friction and limits, step by 2 ms, hold the same stance by springs and dampers of
300 N·m/rad and 6 N·m·s/rad in each joint, and touch level ground by four points; Catena by `MoreauJean` (crates/robots/benches/real_time.rs), MuJoCo
by each of its integrators with each of its solvers. Run in turns; the least of all blocks of a thousand steps counts. Writes
benches/results/real_time.csv.
"""

import csv
import json
import os
import subprocess
import time
from pathlib import Path

import mujoco

ROOT = Path(__file__).resolve().parent.parent.parent
STANCE = [0.0, 0.7, -1.4, 0.0, 0.7, -1.4, 0.0, 0.7, -1.4, 0.0, -0.7, -1.4]
BLOCK, BLOCKS, ROUNDS = 1000, 10, 5
TARGETS = {"default": "", "native": "-C target-cpu=native"}


def catena(target):
    """The program of this repository, compiled."""
    command = ["cargo", "bench", "--no-run", "-p", "catena-robots", "--bench", "real_time", "--message-format=json"]
    command += ["--target-dir", str(ROOT / "target" / "rivals" / target)]
    environment = {**os.environ, "RUSTFLAGS": TARGETS[target]}
    output = subprocess.run(command, cwd=ROOT, env=environment, check=True, stdout=subprocess.PIPE, text=True).stdout
    found = [message.get("executable") for message in map(json.loads, output.splitlines())]
    return next(path for path in reversed(found) if path)


def scene():
    """The quadruped for MuJoCo: feet are spheres of a millimetre."""
    text = (ROOT / "crates" / "catena-urdf" / "robots" / "quadruped.urdf").read_text()
    compiler = '<mujoco><compiler fusestatic="false" balanceinertia="true"/></mujoco>'
    spec = mujoco.MjSpec.from_string(text.replace('<robot name="quadruped">', '<robot name="quadruped">' + compiler))
    for shape in list(spec.geoms):
        spec.delete(shape)
    friction = [0.8, 0.005, 0.0001]
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[5, 5, 0.1], friction=friction)
    for body in spec.bodies:
        if body.name.endswith("foot"):
            body.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[0.001, 0, 0], friction=friction)
    spec.option.timestep = 2e-3
    model = spec.compile()
    model.jnt_stiffness[1:] = 300.0
    model.dof_damping[6:] += 6.0
    model.qpos_spring[7:] = STANCE
    return model


def stood(model):
    """Microseconds of a step of MuJoCo, and the height of the trunk."""
    data = mujoco.MjData(model)
    data.qpos[2], data.qpos[3], data.qpos[7:] = 0.42, 1.0, STANCE
    mujoco.mj_step(model, data, nstep=BLOCK)
    least = float("inf")
    for _ in range(BLOCKS):
        start = time.perf_counter()
        mujoco.mj_step(model, data, nstep=BLOCK)
        least = min(least, 1e6 * (time.perf_counter() - start) / BLOCK)
    return least, float(data.qpos[2])


def main():
    own, model, least = {target: catena(target) for target in TARGETS}, scene(), {}

    def note(key, microseconds, height):
        before, _ = least.get(key, (float("inf"), 0.0))
        least[key] = (min(before, microseconds), height)

    for _ in range(ROUNDS):
        for target, program in own.items():
            said = subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True).stdout
            numbers = dict(line.split() for line in said.splitlines())
            note(("Catena", "MoreauJean", target), float(numbers["step"]), float(numbers["height"]))
        for integrator in ["EULER", "IMPLICIT", "IMPLICITFAST"]:
            for solver in ["NEWTON", "CG", "PGS"]:
                model.opt.integrator = getattr(mujoco.mjtIntegrator, "mjINT_" + integrator)
                model.opt.solver = getattr(mujoco.mjtSolver, "mjSOL_" + solver)
                note(("MuJoCo", f"{integrator} {solver}", "wheel"), *stood(model))
    with open(ROOT / "benches" / "results" / "real_time.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["library", "way", "target", "microseconds", "height"])
        for (library, way, target), (microseconds, height) in least.items():
            writer.writerow([library, way, target, f"{microseconds:.2f}", f"{height:.4f}"])
            print(f"{library}, {way}, {target}: {microseconds:.2f} µs, trunk at {height:.4f} m")


if __name__ == "__main__":
    main()
