"""Run time against error of what a user could pick instead, on the yardsticks of BENCHMARKS.md.

    python3 -m venv target/rivals && target/rivals/bin/pip install -r benches/rivals/requirements.txt
    target/rivals/bin/python benches/rivals/rivals.py

Builds pinocchio.cpp against the package `pin` (a C++ compiler and Eigen 3 have to be there), runs Pinocchio and MuJoCo, and writes
benches/results/rivals.csv. `cargo run --release -p catena-precision --bin chains` draws what it finds there beside Catena's own runs.
"""

import csv
import math
import pathlib
import statistics
import subprocess
import sys
import time

import mujoco
from scipy.integrate._ivp import dop853_coefficients

HERE = pathlib.Path(__file__).parent
OUT = HERE.parent.parent / "target" / "bench"
# Name, kind, bodies, end (s), reference: the angle of the last rod (rad), or the height of the tip (m).
SCENES = [
    ("2 rods on pins", "pins", 2, 2.0, -0.9071302549910606),
    ("20 rods on pins", "pins", 20, 0.5, -3.0330002988365),
    ("3 rods on balls", "balls", 3, 2.0, -0.28230043053974),
]
PREFIX = pathlib.Path(sys.prefix) / "lib" / f"python3.{sys.version_info.minor}" / "site-packages" / "cmeel.prefix"


def build():
    """Compiles the C++ program, DOP853's coefficients taken from SciPy."""

    def row(values):
        return "{" + ", ".join(repr(float(x)) for x in values) + "}"

    table = dop853_coefficients
    lines = ["static const double A[12][12] = {" + ",\n".join(row(table.A[i][:12]) for i in range(12)) + "};"]
    for name, values in [("B", table.B), ("E3", table.E3[:12]), ("E5", table.E5[:12])]:
        lines.append(f"static const double {name}[12] = {row(values)};")
    OUT.mkdir(parents=True, exist_ok=True)
    (OUT / "dop853.hpp").write_text("#pragma once\n" + "\n".join(lines) + "\n")
    binary, source = OUT / "pinocchio", HERE / "pinocchio.cpp"
    if binary.exists() and binary.stat().st_mtime > source.stat().st_mtime:
        return binary
    flags = ["-std=c++17", "-O3", "-DNDEBUG", "-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS"]
    where = [f"-I{OUT}", f"-I{PREFIX}/include", "-I/usr/include/eigen3", f"-L{PREFIX}/lib", f"-Wl,-rpath,{PREFIX}/lib"]
    print("compiling (some minutes) ...", file=sys.stderr)
    subprocess.run(["g++", *flags, *where, str(source), "-lpinocchio_default", "-o", str(binary)], check=True)
    return binary


def pinocchio(binary, kind, bodies, end, reference):
    """Runs of Pinocchio's articulated-body algorithm under RK4 and DOP853."""
    command = [str(binary), kind, str(bodies), repr(end), repr(reference)]
    for line in subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines():
        rule, parameter, _, error, seconds, _ = line.split(",")
        yield "Pinocchio", rule, float(parameter), float(error), float(seconds)


def chain(kind, bodies):
    """A yardstick for MuJoCo, without damping, contact or limits."""
    length = mass = 1.0 / bodies
    if kind == "pins":
        joint, along, across = 'type="hinge" axis="0 0 1"', 1e-6, 1.0 / 12.0  # about its axis a rod does not turn
    else:
        joint, along, across = 'type="ball"', 1.0 / 200.0, 1.0 / 12.0 + 1.0 / 400.0
    inertia = " ".join(str(mass * length**2 * share) for share in (along, across, across))
    text = ""
    for k in range(bodies):
        text += f'''<body pos="{length if k else 0.0} 0 0"><joint {joint}/>
            <inertial pos="{length / 2} 0 0" mass="{mass}" diaginertia="{inertia}"/>'''
    return mujoco.MjModel.from_xml_string(f'''<mujoco><compiler balanceinertia="false" boundmass="0" boundinertia="0"/>
        <option gravity="0 -9.81 0" integrator="RK4"><flag contact="disable" constraint="disable"/></option>
        <worldbody>{text}{"</body>" * bodies}</worldbody></mujoco>''')


def run_mujoco(kind, bodies, end, reference):
    """Runs of MuJoCo's RK4. All steps of a run are one call into its library."""
    model = chain(kind, bodies)
    data = mujoco.MjData(model)
    step = 0.004 if bodies > 10 else 0.02
    for _ in range(16):
        count = round(end / step)
        model.opt.timestep = end / count
        seconds, begin = [], time.perf_counter()
        while len(seconds) < 3 or time.perf_counter() - begin < 0.03:
            mujoco.mj_resetData(model, data)
            if kind == "balls":  # the first body alone turns; rates of joints are relative
                data.qvel[0:2], data.qvel[3:5] = (1.0, 2.0), (-1.0, -2.0)
            start = time.perf_counter()
            mujoco.mj_step(model, data, nstep=count)
            seconds.append(time.perf_counter() - start)
        mujoco.mj_kinematics(model, data)
        tip = data.xpos[-1] + data.xmat[-1].reshape(3, 3) @ [1.0 / bodies, 0.0, 0.0]
        found = float(sum(data.qpos)) if kind == "pins" else float(tip[1])
        yield "MuJoCo", "RK4", step, abs(found - reference), statistics.median(seconds)
        step *= math.sqrt(0.5)


def main():
    binary = build()
    rows = []
    for name, kind, bodies, end, reference in SCENES:
        rows += [(name, *run) for run in pinocchio(binary, kind, bodies, end, reference)]
        rows += [(name, *run) for run in run_mujoco(kind, bodies, end, reference)]
    with open(HERE.parent / "results" / "rivals.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["scene", "library", "rule", "step_or_tolerance", "error", "seconds"])
        writer.writerows(rows)
    print("milliseconds to an error of 1e-3, 1e-6 and 1e-9 rad (balls: m)")
    for scene, library, rule in dict.fromkeys(row[:3] for row in rows):
        points = [row[4:] for row in rows if row[:3] == (scene, library, rule)]
        times = [min((s for e, s in points if e <= level), default=None) for level in (1e-3, 1e-6, 1e-9)]
        print(f"{scene}, {library} with {rule}: " + " / ".join("–" if t is None else f"{t * 1e3:.2f}" for t in times))


if __name__ == "__main__":
    main()
