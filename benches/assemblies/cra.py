"""COMPAS: the assembly in its data classes, and coupled rigid-block analysis on it."""

import contextlib
import importlib.metadata
import io

from compas.datastructures import Mesh
from compas.geometry import Frame, Polygon
from compas_assembly.datastructures import Block
from compas_cra.datastructures import CRA_Assembly
from compas_cra.equilibrium import cra_solve

from assembly import prism

NAME = "compas_cra, CRA"
# Larger ones take seconds to minutes each.
STONES = 12
RULE = f"at most {STONES} stones; cra_solve at unit density: a solution stands, none by its own word falls, other ends of the search leave it open"


def version():
    return importlib.metadata.version("compas_cra")


class Stone(Block):
    """A block with a weight and a centroid of its own, which are not those of its mesh."""

    def weighing(self, weight, centroid):
        self.given = (weight, [centroid[0], 0.5, centroid[1]])
        return self

    def volume(self):
        return self.given[0]

    def center(self):
        return self.given[1]


def compas(assembly):
    """The assembly of COMPAS: stones, then the two supports, with an interface a joint."""
    of = CRA_Assembly()
    # Its tolerances are for stones that weigh their volume.
    weights = [assembly.area * weight for weight in [*assembly.weights, 1.0, 1.0]]
    middle = lambda polygon: [sum(x) / len(polygon) for x in zip(*polygon)]
    centroids = [*assembly.centroids, *map(middle, assembly.supports)]
    bodies = [*assembly.polygons, *assembly.supports]
    for key, (polygon, weight, centroid) in enumerate(zip(bodies, weights, centroids)):
        mesh = Mesh.from_vertices_and_faces(*prism(polygon))
        of.add_block(mesh.copy(cls=Stone).weighing(weight, centroid), node=key)
    count = len(assembly.polygons)
    of.set_boundary_conditions([count, count + 1])
    for joint, (intrados, extrados) in enumerate(assembly.joints):
        left = count if joint == 0 else joint - 1
        right = count + 1 if joint == count else joint
        (x, y), (u, v) = intrados, extrados
        points = [[x, 0.0, y], [u, 0.0, v], [u, 1.0, v], [x, 1.0, y]]
        length = ((u - x) ** 2 + (v - y) ** 2) ** 0.5
        # Its normal is from the left stone to the right one.
        frame = Frame([x, 0.0, y], [(u - x) / length, 0.0, (v - y) / length], [0.0, -1.0, 0.0])
        of.add_to_interfaces(left, right, length, points, frame)
    return of


def stands(assembly):
    if len(assembly.polygons) > STONES:
        return None
    with contextlib.redirect_stdout(io.StringIO()):
        try:
            cra_solve(compas(assembly), mu=assembly.friction, density=1.0)
        except ValueError as error:
            return False if "infeasible" in str(error) else None
    return True
