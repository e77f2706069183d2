"""COMPAS: rigid-block equilibrium with a penalty on tension, which is there where a solution needs glue."""

import contextlib
import io

from compas_cra.equilibrium import rbe_solve

from cra import compas, version  # noqa: F401

NAME = "compas_cra, RBE"
# Parts of a stone's weight.
GLUE = 1e-4
RULE = f"rbe_solve: tension above {GLUE} of a stone's weight falls"


def stands(assembly):
    of = compas(assembly)
    with contextlib.redirect_stdout(io.StringIO()):
        try:
            rbe_solve(of, mu=assembly.friction, density=1.0)
        except ValueError:
            return None
    faces = [face for edge in of.graph.edges() for face in of.graph.edge_attribute(edge, "interfaces")]
    return all(force["c_nn"] <= GLUE * assembly.area for face in faces for force in face.forces)
