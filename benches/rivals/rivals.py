"""Run time against error of what a user could pick instead, on the yardsticks of BENCHMARKS.md.

    python3 -m venv target/rivals && target/rivals/bin/pip install -r benches/rivals/requirements.txt
    target/rivals/bin/python benches/rivals/rivals.py [crates drake exudyn heyoka mujoco pinocchio]

Runs each on the scenes that it can have and writes benches/results/rivals.csv, where runs of those not named stay as they are. `cargo run --release -p catena-precision --bin chains` puts
what it finds there beside Catena's own runs. Pinocchio is compiled against the package `pin`: a C++ compiler and Eigen 3 have to be there.
"""

import csv
import importlib
import pathlib
import sys

# Name, kind, bodies, end (s), reference: the angle of the last rod (rad), or the height of the tip (m).
SCENES = [
    ("2 rods on pins", "pins", 2, 2.0, -0.9071302549910606),
    ("20 rods on pins", "pins", 20, 0.5, -3.0330002988365),
    ("3 rods on balls", "balls", 3, 2.0, -0.28230043053974),
]
LIBRARIES = ["crates", "drake", "exudyn", "heyoka", "mujoco", "pinocchio"]


def main():
    rows = []
    for library in sys.argv[1:] or LIBRARIES:
        own = importlib.import_module(f"with_{library}")
        for name, kind, bodies, end, reference in SCENES:
            print(f"{library}: {name}", file=sys.stderr)
            rows += [(name, *run) for run in own.runs(kind, bodies, end, reference)]
    results = pathlib.Path(__file__).parent.parent / "results" / "rivals.csv"
    made, order = [[name, library.replace(",", ""), *rest] for name, library, *rest in rows], [name for name, *_ in SCENES]
    with open(results, newline="") as file:
        head, *others = csv.reader(file)
    made += [row for row in others if row[1] not in {run[1] for run in made}]
    with open(results, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(head)
        writer.writerows(sorted(made, key=lambda row: (order.index(row[0]), row[1])))
    print("milliseconds to an error of 1e-3, 1e-6, 1e-9 and 1e-12 rad (balls: m)")
    for scene, library, rule in dict.fromkeys(row[:3] for row in rows):
        points = [row[4:] for row in rows if row[:3] == (scene, library, rule)]
        times = [min((s for e, s in points if e <= level), default=None) for level in (1e-3, 1e-6, 1e-9, 1e-12)]
        print(f"{scene}, {library} with {rule}: " + " / ".join("–" if t is None else f"{t * 1e3:.3f}" for t in times))


if __name__ == "__main__":
    main()
