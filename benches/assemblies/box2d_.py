"""Box2D: rigid bodies in the plane, impulses."""

import importlib.metadata
import math

import Box2D

from assembly import GRAVITY, MOVED, SECONDS, inertia

NAME = "Box2D"
STEP, ITERATIONS = 1e-3, 100
# Its bodies have a skin of a hundredth, so that the arch is larger.
RADIUS = 10.0
RULE = f"{SECONDS:g} s of a radius of 1 m in steps of {STEP:g} s, a model of {RADIUS:g} m, {ITERATIONS} iterations"


def version():
    return importlib.metadata.version("box2d")


def stands(assembly):
    large = lambda points: [(RADIUS * x, RADIUS * y) for x, y in points]
    world = Box2D.b2World(gravity=(0, -GRAVITY * RADIUS), doSleep=False)
    bodies = []
    for polygon, centroid, weight in zip(assembly.polygons, assembly.centroids, assembly.weights):
        at = large([centroid])[0]
        body = world.CreateDynamicBody(position=at)
        local = [(x - at[0], y - at[1]) for x, y in large(polygon)]
        body.CreatePolygonFixture(vertices=local, friction=assembly.friction, density=1)
        about = weight * inertia(polygon, centroid) * RADIUS**2
        body.massData = Box2D.b2MassData(mass=weight, center=(0, 0), I=about)
        bodies.append(body)
    for polygon in assembly.supports:
        world.CreateStaticBody().CreatePolygonFixture(vertices=large(polygon), friction=assembly.friction)
    for _ in range(round(SECONDS / STEP)):
        world.Step(STEP, ITERATIONS, ITERATIONS)
        moved = max(math.dist(body.worldCenter, at) for body, at in zip(bodies, large(assembly.centroids)))
        if not moved <= MOVED * RADIUS:
            return False
    return True
