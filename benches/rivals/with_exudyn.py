"""Exudyn's kinematic tree in minimal coordinates under DOPRI5 and RK44. It has no joints of balls there."""

import math
import sys

import exudyn
import numpy
from exudyn.itemInterface import NodeGenericODE2, ObjectKinematicTree
from timing import timed


def chain(bodies):
    length = mass = 1.0 / bodies
    across = mass * length**2 / 12.0
    system = exudyn.SystemContainer().AddSystem()
    rest = [0.0] * bodies
    node = system.AddNode(
        NodeGenericODE2(
            referenceCoordinates=rest, initialCoordinates=rest, initialCoordinates_t=rest, numberOfODE2Coordinates=bodies
        )
    )
    turns, inertias, centres, places = exudyn.Matrix3DList(), exudyn.Matrix3DList(), exudyn.Vector3DList(), exudyn.Vector3DList()
    for k in range(bodies):
        turns.Append(numpy.eye(3))
        inertias.Append(numpy.diag([1e-9, across, across]))
        centres.Append([length / 2, 0, 0])
        places.Append([length if k else 0.0, 0, 0])
    system.AddObject(
        ObjectKinematicTree(
            nodeNumber=node,
            gravity=[0, -9.81, 0],
            jointTypes=[exudyn.JointType.RevoluteZ] * bodies,
            linkParents=list(range(-1, bodies - 1)),
            jointTransformations=turns,
            jointOffsets=places,
            linkInertiasCOM=inertias,
            linkCOMs=centres,
            linkMasses=[mass] * bodies,
        )
    )
    system.Assemble()
    return system, node


def runs(kind, bodies, end, reference):
    if kind != "pins":
        return
    system, node = chain(bodies)
    settings = exudyn.SimulationSettings()
    settings.timeIntegration.endTime = end
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = end
    types = exudyn.DynamicSolverType

    def run(solver):
        def whole():
            if not exudyn.SolveDynamic(system, settings, solverType=solver, updateInitialValues=False):
                raise ArithmeticError

        try:
            seconds = timed(lambda: None, whole)
        except (ArithmeticError, ValueError, RuntimeError) as error:
            print(f"Exudyn gives up: {error}", file=sys.stderr)
            return math.inf, math.inf
        found = sum(system.GetNodeOutput(node, exudyn.OutputVariableType.Coordinates))
        return abs(found - reference), seconds

    settings.timeIntegration.automaticStepSize = True
    settings.timeIntegration.numberOfSteps = 1
    settings.timeIntegration.initialStepSize, settings.timeIntegration.minimumStepSize = 1e-3, 1e-6
    for k in range(3, 12):
        settings.timeIntegration.absoluteTolerance = settings.timeIntegration.relativeTolerance = 10.0**-k
        yield "Exudyn", "DOPRI5", 10.0**-k, *run(types.DOPRI5)
    settings.timeIntegration.automaticStepSize = False
    step = 0.004 if bodies > 10 else 0.02
    for _ in range(14):
        settings.timeIntegration.numberOfSteps = round(end / step)
        yield "Exudyn", "RK44", step, *run(types.RK44)
        step *= math.sqrt(0.5)
