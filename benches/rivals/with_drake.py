"""Drake's MultibodyPlant under its Runge-Kutta pairs of order 3 and 5 with error control."""

import sys

from pydrake.math import RigidTransform
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import BallRpyJoint, FixedOffsetFrame, RevoluteJoint, SpatialInertia, UnitInertia
from pydrake.systems.analysis import ResetIntegratorFromFlags, Simulator
from timing import timed

# Accuracies are of weighted norms: errors are larger, so they go below what others are asked for.
ACCURACIES = [10.0**-k for k in range(2, 14)]


def chain(kind, bodies):
    """A yardstick, continuous in time."""
    length = mass = 1.0 / bodies
    along, across = (1e-6, length**2 / 3.0) if kind == "pins" else (length**2 / 200.0, length**2 * (1.0 / 3.0 + 1.0 / 400.0))
    plant = MultibodyPlant(0.0)
    end = plant.world_frame()
    for k in range(bodies):
        body = plant.AddRigidBody(f"body{k}", SpatialInertia(mass, [length / 2, 0, 0], UnitInertia(along, across, across)))
        if kind == "pins":
            plant.AddJoint(RevoluteJoint(f"joint{k}", end, body.body_frame(), [0, 0, 1]))
        else:
            plant.AddJoint(BallRpyJoint(f"joint{k}", end, body.body_frame()))
        end = plant.AddFrame(FixedOffsetFrame(f"end{k}", body.body_frame(), RigidTransform([length, 0, 0])))
    plant.mutable_gravity_field().set_gravity_vector([0, -9.81, 0])
    plant.Finalize()
    return plant, end


def runs(kind, bodies, end, reference):
    plant, tip = chain(kind, bodies)
    simulator = Simulator(plant)
    context = simulator.get_mutable_context()
    rates = [0.0] * plant.num_velocities()
    if kind == "balls":
        rates[0:2], rates[3:5] = (1.0, 2.0), (-1.0, -2.0)

    def begin():
        context.SetTime(0.0)
        plant.SetPositions(context, [0.0] * plant.num_positions())
        plant.SetVelocities(context, rates)
        simulator.Initialize()

    for rule in ["runge_kutta3", "runge_kutta5"]:
        ResetIntegratorFromFlags(simulator, rule, 0.1)
        integrator = simulator.get_mutable_integrator()
        integrator.set_fixed_step_mode(False)
        for accuracy in ACCURACIES:
            integrator.set_target_accuracy(accuracy)
            try:
                seconds = timed(begin, lambda: simulator.AdvanceTo(end))
            except RuntimeError as error:  # a ball of three angles whose second one comes too near a right angle
                print(f"{rule} at {accuracy} stops: {str(error)[:120]}", file=sys.stderr)
                continue
            place = tip.CalcPoseInWorld(context).translation()
            found = sum(plant.GetPositions(context)) if kind == "pins" else place[1]
            yield "Drake", rule, accuracy, abs(found - reference), seconds
            if seconds > 2.0:
                break
