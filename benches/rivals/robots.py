"""Functions of the shipped robots beside those of Pinocchio and of dynibo, a crate for Rust, in nanoseconds a call.

    python3 -m venv target/rivals && target/rivals/bin/pip install -r benches/rivals/requirements.txt
    target/rivals/bin/python benches/rivals/robots.py

All read the descriptions in crates/catena-urdf/robots, compiled for the default target and for this machine (native), and are run in turns at the
same random states; where others have several ways, the fastest counts. dynibo has no planar joints. Numbers that differ end the script. Writes
benches/results/robots.csv, from which `cargo run -p catena-report` makes the table of BENCHMARKS.md. Building takes some ten minutes, and
timing one.
"""

import csv
import json
import os
import re
import statistics
import subprocess
import sys
import xml.etree.ElementTree as tree

import numpy
import pinocchio

from with_pinocchio import HERE, OUT, compiled

ROOT = HERE.parent.parent
# Robot, description, whether its base is made to float.
ROBOTS = [
    ("arm7", "arm7", False),
    ("cart", "cart", False),
    ("quadruped, fixed", "quadruped", False),
    ("quadruped", "quadruped", False),
    ("humanoid", "humanoid", True),
]
TARGETS = {"default": [], "native": ["-march=native"]}
ROUNDS = 9
# The same by others.
SAME = {
    "sweep": ["aba_local", "aba_world", "dynibo_aba"],
    "forward_dynamics": ["aba_local", "aba_world", "dynibo_aba"],
    "inverse_dynamics": ["rnea", "dynibo_rnea"],
    "mass_matrix": ["crba_local", "crba_world", "dynibo_crba"],
    "jacobian": ["jacobian_frame", "jacobian_joints", "dynibo_jacobian"],
    "forward_dynamics_derivatives": ["aba_derivatives"],
}
TOLERANCE = 1e-9  # of numbers, relative to the largest


def catena(target):
    """The program of this repository, compiled."""
    flags = " ".join([os.environ.get("RUSTFLAGS", ""), "-C target-cpu=native" if target == "native" else ""]).strip()
    command = ["cargo", "bench", "--no-run", "-p", "catena-urdf-robots", "--bench", "times", "--message-format=json"]
    command += ["--target-dir", str(OUT / target)]
    environment = {**os.environ, "RUSTFLAGS": flags}
    output = subprocess.run(command, cwd=ROOT, env=environment, check=True, stdout=subprocess.PIPE, text=True).stdout
    found = [message.get("executable") for message in map(json.loads, output.splitlines())]
    return next(path for path in reversed(found) if path)


def crate(target):
    """The program of dynibo, compiled."""
    flags = " ".join([os.environ.get("RUSTFLAGS", ""), "-C target-cpu=native" if target == "native" else ""]).strip()
    folder = OUT / f"crates-{target}"
    command = ["cargo", "build", "--release", "--quiet", "--bin", "robots", "--manifest-path", HERE / "crates" / "Cargo.toml"]
    subprocess.run([*command, "--target-dir", folder], env={**os.environ, "RUSTFLAGS": flags}, check=True)
    return folder / "release" / "robots"


def without_a_stand(text):
    """A description whose base floats by itself: without the floating joint and what that stands on."""
    root = tree.fromstring(text)
    for joint in root.findall("joint"):
        if joint.get("type") == "floating":
            stand = joint.find("parent").get("link")
            root.remove(joint)
            for link in root.findall("link"):
                if link.get("name") == stand:
                    root.remove(link)
    return tree.tostring(root, encoding="unicode")


def described(path, snap=1e-4, fixed=False):
    """A description as it is meant where the library was asked to repair it: right angles right, bodies possible, no floating joint on a stand."""
    root = tree.parse(path).getroot()
    for place in root.iter("origin"):
        turns = [float(word) for word in place.get("rpy", "0 0 0").split()]
        right = [round(turn / (numpy.pi / 2)) * (numpy.pi / 2) for turn in turns]
        place.set("rpy", " ".join(repr(float(b if abs(a - b) < snap else a)) for a, b in zip(turns, right)))
    for inertia in root.iter("inertia"):
        names = [["ixx", "ixy", "ixz"], ["ixy", "iyy", "iyz"], ["ixz", "iyz", "izz"]]
        tensor = numpy.array([[float(inertia.get(name)) for name in row] for row in names])
        values, axes = numpy.linalg.eigh(0.5 * numpy.trace(tensor) * numpy.eye(3) - tensor)
        if values[0] < -1e-6 * numpy.trace(tensor):
            moments = axes @ numpy.diag(values.clip(0.0)) @ axes.T
            tensor = numpy.trace(moments) * numpy.eye(3) - moments
            for row, numbers in zip(names, tensor):
                for name, number in zip(row, numbers):
                    inertia.set(name, repr(float(number)))
    for joint in root.iter("joint"):
        if fixed and joint.get("type") == "floating":
            joint.set("type", "fixed")
    return tree.tostring(root, encoding="unicode")


def model(path, text, floating):
    """Writes what Pinocchio reads, a joint a line."""
    base = [pinocchio.JointModelFreeFlyer()] if floating else []
    robot = pinocchio.buildModelFromXML(text, *base)
    lines = []
    for k in range(1, robot.njoints):
        joint, place, body = robot.joints[k], robot.jointPlacements[k], robot.inertias[k]
        own = joint.extract() if hasattr(joint, "extract") else joint
        axis = getattr(own, "axis", numpy.zeros(3))
        arrays = [place.translation, place.rotation, axis, numpy.array([body.mass]), body.lever, body.inertia]
        numbers = numpy.concatenate([numpy.ravel(array) for array in arrays])
        words = [joint.shortname(), str(robot.parents[k]), robot.names[k], *(repr(float(x)) for x in numbers)]
        lines.append(" ".join(words))
    path.write_text("\n".join(lines) + "\n")


def said(*command):
    """What a program prints: numbers by names."""
    output = subprocess.run([str(word) for word in command], check=True, stdout=subprocess.PIPE, text=True).stdout
    return {name: float(number) for name, number in (line.split() for line in output.splitlines())}


def main():
    OUT.mkdir(parents=True, exist_ok=True)
    own = {target: catena(target) for target in TARGETS}
    other = {target: compiled(f"robots-{target}", "robots.cpp", flags) for target, flags in TARGETS.items()}
    third = {target: crate(target) for target in TARGETS}
    files, plain, rows, wrong = {}, {}, [], []
    for robot, file, floating in ROBOTS:
        name = re.sub(r"\W+", "-", robot)
        files[robot] = [OUT / f"{name}.joints", OUT / f"{name}.states"]
        path = ROOT / "crates" / "catena-urdf" / "robots" / f"{file}.urdf"
        text = described(path, fixed=robot.endswith("fixed"))
        model(files[robot][0], text, floating)
        if "type=\"planar\"" not in text:
            plain[robot] = [OUT / f"{name}.urdf", files[robot][1]]
            plain[robot][0].write_text(without_a_stand(text))
        for target in TARGETS:
            with open(files[robot][1], "w") as states:
                subprocess.run([own[target], "states", robot], check=True, stdout=states)
            off = said(other[target], "check", *files[robot])
            if robot in plain:
                off |= said(third[target], "check", *plain[robot])
            print(f"{robot}, {target}: " + ", ".join(f"{name} {most:.0e}" for name, most in off.items()), file=sys.stderr)
            wrong += [f"{robot}: {name}" for name, most in off.items() if not most < TOLERANCE]
    if wrong:
        sys.exit("not the same: " + ", ".join(wrong))
    times = {}
    for _ in range(ROUNDS):
        for robot in files:
            for target in TARGETS:
                commands = [("Catena", [own[target], "time", robot]), ("others", [other[target], "time", *files[robot]])]
                if robot in plain:
                    commands.append(("others", [third[target], "time", *plain[robot]]))
                for library, command in commands:
                    for name, nanoseconds in said(*command).items():
                        times.setdefault((robot, library, target, name), []).append(nanoseconds)
    middle = {key: statistics.median(list_) for key, list_ in times.items()}
    for robot in files:
        for target in TARGETS:
            for function, ways in SAME.items():
                ours = middle.get((robot, "Catena", target, function))
                known = [(middle[key], way) for way in ways if (key := (robot, "others", target, way)) in middle]
                theirs, way = min(known)
                if ours is not None:
                    rows.append([robot.replace(",", ";"), function, "Catena", function, target, f"{ours:.1f}"])
                    print(f"{robot}, {target}: {function} {ours:.0f} ns, {way} {theirs:.0f} ns, {theirs / ours:.2f}")
                for library, its in [("Pinocchio", [pair for pair in known if "dynibo" not in pair[1]]),
                                     ("dynibo", [pair for pair in known if "dynibo" in pair[1]])]:
                    if its:
                        nanoseconds, way = min(its)
                        rows.append([robot.replace(",", ";"), function, library, way, target, f"{nanoseconds:.1f}"])
    with open(ROOT / "benches" / "results" / "robots.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["robot", "function", "library", "way", "target", "nanoseconds"])
        writer.writerows(rows)


if __name__ == "__main__":
    main()
