"""Questions of `couplet sample --assemblies --format json`, as every reader here takes them."""

import json
from dataclasses import dataclass

GRAVITY = 9.81
# An arch of radius 1 m that moves has passed this part of its radius by then, s; one that settles has not.
SECONDS = 5.0
MOVED = 0.02


@dataclass
class Assembly:
    """A question with its proved answer, scaled to a radius of 1."""

    id: str
    stands: bool
    mode: str
    friction: float
    polygons: list
    centroids: list
    weights: list
    # Of one stone.
    area: float
    supports: list
    joints: list


def read(path):
    """All questions of a file."""
    with open(path) as file:
        return [scaled(question) for question in json.load(file)]


def scaled(question):
    r = question["radius"]
    points = lambda all: [[x / r, y / r] for x, y in all]
    blocks = question["blocks"]
    return Assembly(
        id=question["id"],
        stands=question["stands"],
        mode=question["mode"] or "other",
        friction=question["friction_double"],
        polygons=[points(block["polygon"]) for block in blocks],
        centroids=points([block["centroid"] for block in blocks]),
        # All stones are of one size.
        weights=[block["weight"] / blocks[0]["weight"] for block in blocks],
        area=blocks[0]["weight"] / r**2,
        supports=[points(ground) for ground in question["supports"]],
        joints=[points(joint) for joint in question["joints"]],
    )


def inertia(polygon, centroid):
    """Moment of inertia about the centroid for unit mass: of the polygon, about a point that may not be its own."""
    cx, cy = centroid
    area = second = 0.0
    for (x, y), (u, v) in zip(polygon, polygon[1:] + polygon[:1]):
        x, y, u, v = x - cx, y - cy, u - cx, v - cy
        cross = x * v - y * u
        area += cross / 2
        second += cross * (x * x + x * u + u * u + y * y + y * v + v * v) / 12
    return second / area


def prism(polygon):
    """Vertices and faces of a prism of unit depth, `z` up and `y` across, seen from outside."""
    vertices = [[x, depth, y] for depth in (0.0, 1.0) for x, y in polygon]
    n = len(polygon)
    sides = [[i, i + n, (i + 1) % n + n, (i + 1) % n] for i in range(n)]
    return vertices, [list(range(n)), list(range(2 * n - 1, n - 1, -1)), *sides]
