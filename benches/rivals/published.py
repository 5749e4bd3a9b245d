"""Functions of ten published robots beside those of Pinocchio: numbers at 100 random states, and nanoseconds a call.

    target/rivals/bin/python benches/rivals/published.py [--again] FOLDER [ROBOT ...]

FOLDER holds the descriptions, which are not ours to ship: iiwa.urdf, hyq.urdf and atlas.urdf of the repository robot-acceleration/GRiDBenchmarks
(urdfs/); ur5.urdf, tiago.urdf, anymal.urdf and talos.urdf of the Python package example-robot-data 6.0.0 (ur_description/urdf/ur5_robot.urdf,
tiago_description/robots/tiago_no_hand.urdf, anymal_b_simple_description/robots/anymal.urdf, talos_data/robots/talos_reduced.urdf); panda.urdf and g1.urdf
of the crate dynibo 0.5.3 (examples/data/franka/franka_fer.urdf, examples/data/unitree-g1/g1_29dof_mode_11.urdf). All are compiled for this machine, by
some minutes each, or with --again used as they were compiled before. Numbers that
differ by more than 1e-11 of the largest are
named, and the script fails. Writes benches/results/published.csv, from which `cargo run -p catena-report` makes a table.
"""

import csv
import os
import pathlib
import subprocess
import sys

import numpy
import pinocchio

from robots import ROOT, SAME, described, model, said
from with_pinocchio import HERE, OUT, compiled

ROBOTS = {
    "iiwa": "fixed", "panda": "fixed", "ur5": "fixed", "tiago": "fixed", "hyq": "fixed", "hyq, floating": "floating",
    "anymal": "floating", "atlas": "fixed", "g1": "floating", "talos": "floating",
}
ROUNDS = 25
TOLERANCE = 1e-11
POINT = numpy.array([0.1, -0.2, 0.3])


def catena(name, description, base, again):
    """The program of a robot, compiled."""
    program = OUT / f"published-{name}"
    if again and program.exists():
        return program
    environment = {**os.environ, "RUSTFLAGS": "-C target-cpu=native", "DESCRIPTION": str(description), "BASE": base}
    folder = OUT / "published"
    command = ["cargo", "build", "--release", "--quiet", "--manifest-path", HERE / "published" / "Cargo.toml"]
    subprocess.run([*command, "--target-dir", folder], env=environment, check=True)
    program.write_bytes((folder / "release" / "catena-published").read_bytes())
    program.chmod(0o755)
    return program


class Other:
    """The robot as Pinocchio has it, and its coordinates from ours."""

    def __init__(self, text, floats, names):
        self.model = pinocchio.buildModelFromXML(text, *([pinocchio.JointModelFreeFlyer()] if floats else []))
        self.data, self.floats = self.model.createData(), floats
        self.ids = [self.model.getJointId(name) for name in names]

    def state(self, q, v):
        """Positions and rates, T with our rates = T theirs, and what our accelerations have beyond T theirs."""
        model, base = self.model, 6 if self.floats else 0
        here, across, swept = numpy.zeros(model.nq), numpy.zeros((model.nv, model.nv)), numpy.zeros(model.nv)
        if base:
            w, x, y, z = q[3:7]
            here[:3], here[3:7] = q[:3], (x, y, z, w)
            across[:3, :3], across[3:6, 3:6] = pinocchio.Quaternion(w, x, y, z).toRotationMatrix(), numpy.eye(3)
        for k, joint in enumerate(self.ids):
            own, angle = model.joints[joint], q[k + base + (1 if base else 0)]
            here[own.idx_q : own.idx_q + own.nq] = [numpy.cos(angle), numpy.sin(angle)] if own.nq == 2 else [angle]
            across[base + k, own.idx_v] = 1.0
        rates = across.T @ v
        if base:
            swept[:3] = numpy.cross(rates[3:6], rates[:3])
        return here, rates, across, swept

    def answers(self, lists, k):
        """What Pinocchio says at state k, in our coordinates, by our names."""
        model, data, n = self.model, self.data, self.model.nv
        q, v, t, swept = self.state(lists["q"][k], lists["v"][k])
        back, kind = t.T, pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED
        tau, seconds = back @ lists["torques"][k], back @ lists["seconds"][k] - swept
        said = {}
        said["sweep"] = said["forward_dynamics"] = t @ (pinocchio.aba(model, data, q, v, tau) + swept)
        said["inverse_dynamics"] = t @ pinocchio.rnea(model, data, q, v, seconds)
        said["snapshot_inverse_dynamics"] = said["regressor"] = said["inverse_dynamics"]
        said["bias"] = t @ pinocchio.nonLinearEffects(model, data, q, v)
        said["gravity_torques"] = t @ pinocchio.computeGeneralizedGravity(model, data, q)
        mass = pinocchio.crba(model, data, q)
        mass = numpy.triu(mass) + numpy.triu(mass, 1).T
        said["mass_matrix"] = t @ mass @ back
        # Its own M⁻¹ errs by 2e-10 of the largest number for TIAGo, and 4e-12 for G1; scaled, M is inverted to rounding.
        size = 1.0 / numpy.sqrt(numpy.diag(mass))
        own = size[:, None] * numpy.linalg.inv(size[:, None] * mass * size) * size
        inverse = t @ own @ back
        said["mass_inverse"], said["mass_solved"] = inverse, inverse @ lists["torques"][k]
        last = self.ids[-1]
        said["jacobian"] = t @ pinocchio.computeFrameJacobian(model, data, q, self.frame(last), kind).T
        if not self.floats:
            by_q, by_v, _ = pinocchio.computeRNEADerivatives(model, data, q, v, pinocchio.aba(model, data, q, v, tau))
            said["forward_dynamics_derivatives"] = numpy.concatenate([t @ x @ back for x in (-own @ by_q, -own @ by_v, own)])
            by_q, by_v, _ = pinocchio.computeRNEADerivatives(model, data, q, v, seconds)
            said["inverse_dynamics_derivatives"] = numpy.concatenate([t @ x @ back for x in (by_q, by_v)])
        # Of a point of the last body, in the axes of the URDF's joint, which need not be ours: found by where it is.
        pinocchio.forwardKinematics(model, data, q, v, seconds)
        pinocchio.computeJointJacobians(model, data, q)
        pinocchio.computeJointJacobiansTimeVariation(model, data, q, v)
        own, place = data.oMi[last], lists["point"][k][:3]
        arm = place - own.translation
        said["place"] = own.translation
        move = pinocchio.getFrameVelocity(model, data, self.frame(last), kind)
        spin, origin = move.angular, move.linear
        said["point"] = numpy.concatenate([place, origin + numpy.cross(spin, arm)])
        gain = pinocchio.getFrameClassicalAcceleration(model, data, self.frame(last), kind)
        turn = gain.angular
        linear = gain.linear + numpy.cross(turn, arm) + numpy.cross(spin, numpy.cross(spin, arm))
        said["point_acceleration"] = numpy.concatenate([linear, turn])
        jacobian = pinocchio.getJointJacobian(model, data, last, kind)
        rate = pinocchio.getJointJacobianTimeVariation(model, data, last, kind)
        moved = jacobian.copy()
        moved[:3] -= numpy.cross(arm, jacobian[3:].T).T
        moving = rate.copy()
        moving[:3] -= numpy.cross(arm, rate[3:].T).T + numpy.cross(numpy.cross(spin, arm), jacobian[3:].T).T
        said["snapshot_jacobian"] = t @ moved.T
        if self.floats:  # J theirs = J ours T
            turning = numpy.zeros((n, n))
            turning[:3, :3] = t[:3, :3] @ pinocchio.skew(v[3:6])
            moving = moving - (moved @ back) @ turning
        said["jacobian_rate"] = t @ moving.T
        said["compliance"] = (moved @ back) @ inverse @ (moved @ back).T
        map_, momentum = pinocchio.computeCentroidalMap(model, data, q), pinocchio.computeCentroidalMomentum(model, data, q, v)
        said["momentum_matrix"] = t @ map_.T
        said["centroidal_momentum"] = momentum.vector
        centre = pinocchio.centerOfMass(model, data, q)
        said["mass_centre"] = numpy.append(centre, pinocchio.computeTotalMass(model))
        said["mass_centre_jacobian"] = t @ pinocchio.jacobianCenterOfMass(model, data, q).T
        kinetic = pinocchio.computeKineticEnergy(model, data, q, v)
        said["energy"] = numpy.array([kinetic, pinocchio.computePotentialEnergy(model, data, q)])
        return said

    def frame(self, joint):
        return self.model.getFrameId(self.model.names[joint])


def compared(text, floats, states):
    """By how much numbers of functions differ at most, relative to the largest of each answer."""
    lists, names = {}, []
    for line in open(states):
        name, *words = line.split()
        if name == "joints":
            names = words
        elif name != "of":
            lists.setdefault(name, []).append(numpy.array([float(word) for word in words]))
    other, worst = Other(text, floats, names), {}
    for k in range(len(lists["q"])):
        for name, expected in other.answers(lists, k).items():
            if name in lists:
                found, expected = lists[name][k], numpy.ravel(expected)
                if name == "forward_dynamics_derivatives" and len(found) > len(expected):
                    continue
                off = abs(found - expected).max() / max(abs(expected).max(), 1e-300) if len(found) == len(expected) else numpy.inf
                worst[name] = max(worst.get(name, 0.0), off if off == off else numpy.inf)
    return worst


def main():
    again = "--again" in sys.argv
    folder, *wanted = [word for word in sys.argv[1:] if word != "--again"]
    folder, wanted = pathlib.Path(folder), wanted or list(ROBOTS)
    OUT.mkdir(parents=True, exist_ok=True)
    other = compiled("robots-native", "robots.cpp", ["-march=native"])
    programs, wrong, rows = {}, [], []
    for robot in wanted:
        floats, name = ROBOTS[robot] == "floating", robot.replace(", ", "-")
        text = described(folder / f"{robot.split(',')[0]}.urdf", snap=1e-6)
        files = [OUT / f"{name}.joints", OUT / f"{name}.states"]
        program = catena(name, (folder / f"{robot.split(',')[0]}.urdf").resolve(), ROBOTS[robot], again)
        with open(files[1], "w") as states:
            subprocess.run([program, "states"], check=True, stdout=states)
        off = compared(text, floats, files[1])
        print(f"{robot}: " + ", ".join(f"{name} {most:.0e}" for name, most in off.items()), file=sys.stderr, flush=True)
        wrong += [f"{robot}: {name} {most:.1e}" for name, most in off.items() if not most < TOLERANCE]
        model(files[0], text, floats)
        programs[robot] = ([program, "time"], [other, "time", *files], max(off.values()))
    if wrong:
        print("not the same: " + ", ".join(wrong), file=sys.stderr)
    times = {}
    for _ in range(ROUNDS):
        for robot, (own, others, _) in programs.items():
            for command in (own, others):
                for name, nanoseconds in said(*command).items():
                    times.setdefault((robot, name), []).append(nanoseconds)
    least = {key: min(list_) for key, list_ in times.items()}  # what else runs on a machine only adds
    for robot, (_, _, most) in programs.items():
        for function, ways in SAME.items():
            known = [(least[robot, way], way) for way in ways if (robot, way) in least]
            if (robot, function) in least and known:
                ours, (theirs, way) = least[robot, function], min(known)
                rows.append([robot.replace(",", ";"), function, f"{ours:.1f}", f"{theirs:.1f}", way, f"{most:.1e}"])
                print(f"{robot}: {function} {ours:.0f} ns, {way} {theirs:.0f} ns, {theirs / ours:.2f}", flush=True)
    with open(ROOT / "benches" / "results" / "published.csv", "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["robot", "function", "Catena", "Pinocchio", "way", "off"])
        writer.writerows(rows)
    if wrong:
        sys.exit(1)


if __name__ == "__main__":
    main()
