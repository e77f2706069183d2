"""Rapier: rigid bodies in the plane, by the program in `rapier/`, which `cargo build --release` makes."""

import json
import pathlib
import re
import subprocess

from assembly import GRAVITY, MOVED, SECONDS, inertia

NAME = "Rapier (rapier2d-f64)"
STEP, ITERATIONS, ERROR, FREQUENCY = 1e-3, 32, 1e-5, 300.0
RULE = f"{SECONDS:g} s in steps of {STEP:g} s, {ITERATIONS} iterations, allowed linear error {ERROR:g}, contacts of {FREQUENCY:g} Hz"
FOLDER = pathlib.Path(__file__).parent / "rapier"


def version():
    lock = (FOLDER / "Cargo.lock").read_text()
    return re.search(r'name = "rapier2d-f64"\nversion = "(.*)"', lock)[1]


def stands(assembly):
    bodies = zip(assembly.weights, assembly.polygons, assembly.centroids)
    asked = {
        "friction": assembly.friction,
        "polygons": assembly.polygons,
        "centroids": assembly.centroids,
        "weights": assembly.weights,
        "inertias": [weight * inertia(polygon, at) for weight, polygon, at in bodies],
        "supports": assembly.supports,
        "gravity": GRAVITY,
        "seconds": SECONDS,
        "step": STEP,
        "iterations": ITERATIONS,
        "error": ERROR,
        "frequency": FREQUENCY,
        "moved": MOVED,
    }
    program = FOLDER / "target" / "release" / "couplet-rapier"
    done = subprocess.run([program], input=json.dumps(asked), capture_output=True, text=True)
    return {"true\n": True, "false\n": False}.get(done.stdout)
