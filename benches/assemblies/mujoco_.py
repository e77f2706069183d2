"""MuJoCo: convex bodies with soft contacts, prisms of unit depth that move in the plane."""

import mujoco
import numpy as np

from assembly import GRAVITY, MOVED, SECONDS, inertia, prism

NAME = "MuJoCo"
STEP = 2e-3
RULE = f"{SECONDS:g} s in steps of {STEP:g} s, elliptic cones, solimp 0.99 0.999, three joints a stone for the plane"


def version():
    return mujoco.__version__


def text(points):
    return " ".join(f"{x:.17g}" for point in points for x in point)


def model(assembly):
    meshes, bodies = [], []
    for index, polygon in enumerate([*assembly.polygons, *assembly.supports]):
        # At a depth around zero, so that the plane of motion is the middle.
        vertices = [[x, y - 0.5, z] for x, y, z in prism(polygon)[0]]
        is_stone = index < len(assembly.polygons)
        x, z = assembly.centroids[index] if is_stone else (0.0, 0.0)
        local = [[a - x, b, c - z] for a, b, c in vertices]
        meshes.append(f'<mesh name="m{index}" vertex="{text(local)}"/>')
        inside = ""
        if is_stone:
            mass = assembly.weights[index]
            about = mass * inertia(polygon, assembly.centroids[index])
            # Only the moment about y matters; the others are as large.
            inside = (
                f'<inertial pos="0 0 0" mass="{mass:.17g}" diaginertia="{about:.17g} {about:.17g} {about:.17g}"/>'
                '<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/>'
                '<joint type="hinge" axis="0 1 0"/>'
            )
        bodies.append(
            f'<body pos="{x:.17g} 0 {z:.17g}">{inside}<geom type="mesh" mesh="m{index}" '
            f'friction="{assembly.friction:.17g} 0 0" pos="0 0 0"/></body>'
        )
    return (
        f'<mujoco><option timestep="{STEP}" gravity="0 0 -{GRAVITY}" cone="elliptic" impratio="10"/>'
        '<compiler inertiafromgeom="false"/>'
        '<default><geom condim="3" solimp="0.99 0.999 0.001" solref="0.004 1"/></default>'
        f"<asset>{''.join(meshes)}</asset><worldbody>{''.join(bodies)}</worldbody></mujoco>"
    )


def stands(assembly):
    of = mujoco.MjModel.from_xml_string(model(assembly))
    data = mujoco.MjData(of)
    for _ in range(round(SECONDS / STEP)):
        mujoco.mj_step(of, data)
        moved = np.hypot(data.qpos[0::3], data.qpos[1::3]).max()
        if not moved <= MOVED:
            return False
    return True
