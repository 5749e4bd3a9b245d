"""MuJoCo's RK4, without damping, contact or limits."""

import math

import mujoco
from timing import timed


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


def runs(kind, bodies, end, reference):
    """Runs of MuJoCo's RK4. All steps of a run are one call into its library."""
    model = chain(kind, bodies)
    data = mujoco.MjData(model)
    step = 0.004 if bodies > 10 else 0.02
    for _ in range(16):
        count = round(end / step)
        model.opt.timestep = end / count

        def begin():
            mujoco.mj_resetData(model, data)
            if kind == "balls":  # the first body alone turns; rates of joints are relative
                data.qvel[0:2], data.qvel[3:5] = (1.0, 2.0), (-1.0, -2.0)

        seconds = timed(begin, lambda: mujoco.mj_step(model, data, nstep=count))
        mujoco.mj_kinematics(model, data)
        tip = data.xpos[-1] + data.xmat[-1].reshape(3, 3) @ [1.0 / bodies, 0.0, 0.0]
        found = float(sum(data.qpos)) if kind == "pins" else float(tip[1])
        yield "MuJoCo", "RK4", step, abs(found - reference), seconds
        step *= math.sqrt(0.5)
