#!/usr/bin/env python3
"""The least thickness of an arch of n stones: `couplet voussoirs` beside a linear programme and COMPAS CRA.

    stones.py [COUPLET]      the command, target/release/couplet unless another is named; a table to standard output

- HiGHS, by scipy: at a thickness the largest room in all conditions at all joints of the half arch is a linear programme in the thrust,
  the crown moment and the room; the thickness at which that is zero is bracketed by scipy's brentq.
- COMPAS CRA: blocks with faces of eight chords, a support at each springing; the thickness from which its solver finds an equilibrium,
  halved to a thousandth. Whatever it does not solve counts as no equilibrium.

Both are wheels of PyPI (pip install scipy==1.17.1 compas_cra==0.8.0). The error is the distance to couplet's certified value. CPU time of one thread; couplet's is that of the whole command.
"""

import contextlib
import io
import json
import math
import os
import resource
import subprocess
import sys
import warnings
from pathlib import Path
from time import process_time

COUPLET = Path(__file__).resolve().parent.parent.parent / "target/release/couplet"
ARCHES = [
    ("pi/2", math.pi / 2, "0.6", 7),
    ("pi/2", math.pi / 2, "0.6", 11),
    ("pi/2", math.pi / 2, "0.6", 50),
    ("pi/2", math.pi / 2, "0.35", 21),
    ("2.45", 2.45, "1.35", 200),
    ("2.57", 2.57, "2.2", 2000),
    ("pi/2", math.pi / 2, "0.6", 100_000),
]
FEW = 7  # stones that CRA is asked for at most
ONE = dict(os.environ, RAYON_NUM_THREADS="1", OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")


def couplet(program, alpha, mu, stones):
    words = ["voussoirs", "--half-opening", alpha, "--friction", mu, "--stones", str(stones)]
    words += ["--digits", "20", "--format", "json"]
    best = math.inf
    for _ in range(20):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        printed = subprocess.run([program, *words], env=ONE, check=True, stdout=subprocess.PIPE).stdout
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        best = min(best, spent)
    return float(json.loads(printed)["thickness"]["value"]), best


def programme(alpha, mu, stones):
    """The least thickness by HiGHS."""
    import numpy as np
    from scipy.optimize import brentq, linprog

    joints = alpha * (2 * np.arange(stones // 2 + 1) + stones % 2) / stones
    sin, cos = np.sin(joints), np.cos(joints)
    one, zero = np.ones_like(joints), np.zeros_like(joints)

    def room(eta):
        fac, outer, inner = 1 + eta**2 / 12, 1 + eta / 2, 1 - eta / 2
        rows = [
            (-outer * cos, one, outer * joints * sin - fac * (1 - cos)),
            (inner * cos, -one, fac * (1 - cos) - inner * joints * sin),
            (-sin - mu * cos, zero, joints * (mu * sin - cos)),
            (sin - mu * cos, zero, joints * (mu * sin + cos)),
        ]
        left = np.vstack([np.column_stack([h, p, one]) for h, p, _ in rows])
        right = np.concatenate([load for *_, load in rows])
        found = linprog([0, 0, -1], A_ub=left, b_ub=right, bounds=[(None, None)] * 3, method="highs")
        return found.x[2]

    return brentq(room, 1e-3, 2, xtol=1e-15, rtol=1e-14)


def cra(alpha, mu, stones):
    """The least thickness by COMPAS CRA."""
    import numpy as np
    from compas_assembly.datastructures import Block
    from compas_cra.algorithms import assembly_interfaces_numpy
    from compas_cra.datastructures import CRA_Assembly
    from compas_cra.equilibrium import cra_solve

    def block(start, end, eta):
        angles = np.linspace(start, end, 9)
        outer, inner = 1 + eta / 2, 1 - eta / 2
        ring = [(outer * math.sin(a), outer * math.cos(a)) for a in angles]
        ring += [(inner * math.sin(a), inner * math.cos(a)) for a in reversed(angles)]
        n = len(ring)
        points = [(x, -0.5, z) for x, z in ring] + [(x, 0.5, z) for x, z in ring]
        faces = [list(reversed(range(n))), list(range(n, 2 * n))]
        faces += [[i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n)]
        return Block.from_vertices_and_faces(points, faces)

    def stands(eta):
        assembly = CRA_Assembly()
        step = 2 * alpha / stones
        # The supports are stones beyond the springings.
        for index in range(-1, stones + 1):
            start = -alpha + index * step
            assembly.add_block(block(start, start + step, eta), node=index + 1)
        assembly.set_boundary_conditions([0, stones + 1])
        with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                assembly_interfaces_numpy(assembly, amin=1e-6)
                cra_solve(assembly, mu=mu, density=1)
            except Exception:  # it says by many kinds that it found none
                return False
        return True

    low, high = 0.05, 0.25
    if not stands(high):
        return math.nan
    while high - low > 1e-3:
        middle = (low + high) / 2
        low, high = (low, middle) if stands(middle) else (middle, high)
    return high


def timed(job):
    start = process_time()
    value = job()
    return value, process_time() - start


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else COUPLET
    print("| half opening, friction, stones | couplet, 20 digits, **proved** | HiGHS: error, time | COMPAS CRA: error, time |")
    print("|---|---|---|---|")
    programme(1.5, 0.6, 7)  # imports and warms up
    for text, alpha, mu, stones in ARCHES:
        exact, seconds = couplet(program, text, mu, stones)
        value, spent = timed(lambda: programme(alpha, float(mu), stones))
        peer = "not tried"
        if stones <= FEW:
            try:
                other, taken = timed(lambda: cra(alpha, float(mu), stones))
                peer = f"{abs(other - exact):.1e}, {taken:.1f} s" if other == other else "no equilibrium found"
            except ImportError as error:
                peer = f"not installed: {error}"
        print(f"| {text}, {mu}, {stones:,} | {1e3 * seconds:.1f} ms | {abs(value - exact):.1e}, {spent:.2g} s | {peer} |", flush=True)


if __name__ == "__main__":
    main()
