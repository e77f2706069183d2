"""Chipmunk by pymunk: rigid bodies in the plane, impulses."""

import math

import pymunk

from assembly import GRAVITY, MOVED, SECONDS, inertia

NAME = "Chipmunk (pymunk)"
STEP, ITERATIONS = 1e-3, 100
RULE = f"{SECONDS:g} s in steps of {STEP:g} s, {ITERATIONS} iterations"


def version():
    return pymunk.version


def stands(assembly):
    space = pymunk.Space()
    space.gravity = (0, -GRAVITY)
    space.iterations = ITERATIONS
    space.collision_slop = 1e-5
    bodies = []
    for polygon, centroid, weight in zip(assembly.polygons, assembly.centroids, assembly.weights):
        body = pymunk.Body(weight, weight * inertia(polygon, centroid))
        body.position = tuple(centroid)
        shape = pymunk.Poly(body, [(x - centroid[0], y - centroid[1]) for x, y in polygon])
        shape.friction = math.sqrt(assembly.friction)
        space.add(body, shape)
        bodies.append(body)
    for polygon in assembly.supports:
        shape = pymunk.Poly(space.static_body, polygon)
        shape.friction = math.sqrt(assembly.friction)
        space.add(shape)
    for _ in range(round(SECONDS / STEP)):
        space.step(STEP)
        moved = max(
            math.dist(body.position, centroid) for body, centroid in zip(bodies, assembly.centroids)
        )
        if not moved <= MOVED:
            return False
    return True
