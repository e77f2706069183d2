"""Statics by HiGHS: forces at the ends of every joint that hold all stones, or none."""

import importlib.metadata

import highspy
import numpy as np

NAME = "HiGHS, statics"
RULE = "a linear programme: two normal forces and a shear force a joint, three equations a stone"


def version():
    return importlib.metadata.version("highspy")


def programme(assembly):
    """Rows of the equilibrium of each stone, then of the friction at each joint, and their bounds."""
    joints, stones = assembly.joints, assembly.polygons
    columns = 3 * len(joints)
    rows, lower, upper = [], [], []
    infinity = highspy.kHighsInf

    def forces(joint, sign, about, rows):
        (xi, yi), (xe, ye) = joints[joint]
        length = np.hypot(xe - xi, ye - yi)
        along = ((xe - xi) / length, (ye - yi) / length)
        # On the stone to the right of the joint, which the joint pushes to the right.
        normal = (along[1], -along[0])
        for column, (point, direction) in enumerate(
            [((xi, yi), normal), ((xe, ye), normal), ((xi, yi), along)]
        ):
            dx, dy = (sign * d for d in direction)
            arm = (point[0] - about[0], point[1] - about[1])
            for row, value in zip(rows, (dx, dy, arm[0] * dy - arm[1] * dx)):
                row[3 * joint + column] += value

    for stone, (weight, about) in enumerate(zip(assembly.weights, assembly.centroids)):
        three = np.zeros((3, columns))
        forces(stone, 1, about, three)
        forces(stone + 1, -1, about, three)
        rows.extend(three)
        lower += [0.0, weight, 0.0]
        upper += [0.0, weight, 0.0]
    for joint in range(len(joints)):
        for sign in (1, -1):
            row = np.zeros(columns)
            row[3 * joint : 3 * joint + 3] = [assembly.friction, assembly.friction, sign]
            rows.append(row)
            lower.append(0.0)
            upper.append(infinity)
    return np.array(rows), lower, upper


def stands(assembly):
    rows, lower, upper = programme(assembly)
    infinity = highspy.kHighsInf
    solver = highspy.Highs()
    solver.setOptionValue("output_flag", False)
    for column in range(rows.shape[1]):
        solver.addVar(-infinity if column % 3 == 2 else 0.0, infinity)
    for row, low, high in zip(rows, lower, upper):
        at = np.flatnonzero(row)
        solver.addRow(low, high, len(at), at.astype(np.int32), row[at])
    solver.run()
    status = solver.getModelStatus()
    return {
        highspy.HighsModelStatus.kOptimal: True,
        highspy.HighsModelStatus.kInfeasible: False,
    }.get(status)
