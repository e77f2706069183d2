"""LMGC90 by compas_lmgc90: contact dynamics of polyhedra, which weigh what their volume says.

A stone is given a ridge on its outer or inner face, of such a height that the centroid of the prism is where the
weight acts. For Heyman's weight a thick stone has none: such a question stays open.
"""

import importlib.metadata
import math

import numpy as np

from assembly import MOVED, SECONDS, prism

NAME = "LMGC90 (compas_lmgc90)"
STEP = 5e-3
RULE = f"{SECONDS:g} s in steps of {STEP:g} s, IQS_CLB_g0; a ridge on each stone puts the centroid of the prism in its place"


def version():
    return importlib.metadata.version("compas_lmgc90")


def area_and_centroid(polygon):
    area = x = y = 0.0
    for (a, b), (c, d) in zip(polygon, polygon[1:] + polygon[:1]):
        cross = a * d - c * b
        area, x, y = area + cross / 2, x + (a + c) * cross / 6, y + (b + d) * cross / 6
    return area, (x / area, y / area)


def ridged(polygon, centroid):
    """The polygon with a corner more, so that its centroid is the given one; nothing where there is none."""
    right, above_right, above_left, left = polygon
    radius = math.hypot(*centroid)
    up = [x / radius for x in centroid]
    along = lambda point: point[0] * up[0] + point[1] * up[1]
    area, own = area_and_centroid(polygon)
    if abs(along(own) - radius) < 1e-15:
        return polygon
    is_outer = along(own) < radius
    chord = (above_right, above_left) if is_outer else (left, right)
    base, wide = along(chord[0]), math.dist(*chord)
    sign = 1 if is_outer else -1
    # wide a/2 (base + sign a/3 - radius) = area (radius - own), a quadratic in the height of the ridge.
    p, q, r = sign * wide / 6, wide * (base - radius) / 2, -area * (radius - along(own))
    height = max((-q + s * math.sqrt(max(q * q - 4 * p * r, 0))) / (2 * p) for s in (1, -1))
    apex = base + sign * height
    # Within the wedge between the joints there is room down to the centre.
    if apex <= 0.02:
        return None
    corner = [apex * x for x in up]
    return [right, above_right, corner, above_left, left] if is_outer else [*polygon, corner]


def stands(assembly):
    stones = [ridged(*stone) for stone in zip(assembly.polygons, assembly.centroids)]
    if None in stones:
        return None
    from compas_lmgc90.solver import Solver

    solver = Solver(dt=STEP, theta=0.5)
    for polygon in [*stones, *assembly.supports]:
        vertices, faces = prism(polygon)
        solver.geometry_from_v_f({"vertices": vertices, "faces": faces})
    for ground in range(len(stones), len(stones) + 2):
        for component in ("Vx", "Vy", "Vz", "Rx", "Ry", "Rz"):
            solver.apply_velocity(ground, component, 0.0)
    solver.contact_law("IQS_CLB_g0", assembly.friction)
    solver.preprocess()
    begun = np.array(solver.init_coor)
    for _ in range(round(SECONDS / STEP)):
        state = solver.lmgc90.compute_one_step()
        moved = np.linalg.norm(np.array(state.bodies) - begun, axis=1).max()
        if not moved <= MOVED:
            return False
    return True
