#!/usr/bin/env python3
"""Writes s6: a sphereflake, nine spheres of a third of the radius on each (Haines, "A Proposal for Standard Graphics
Environments", IEEE CG&A 1987). Four levels are 7,381 spheres.

    make_sphereflake.py [LEVELS] > s6.toml
"""
import math
import sys

HEAD = """title = "benchmark s6"

[camera]
eye = [2.1, 1.7, 1.3]
target = [1.399610787, 1.133018256, 0.866425725]
up = [0.0, 1.0, 0.0]
vertical_fov = 45.0
size = [1024, 768]

[trace]
max_depth = 8

[materials.M0]
color = [1.0, 0.9, 0.7]
mirror = 0.5

[materials.floor]
color = [0.8, 0.6, 0.3]

[[plane]]
point = [0.0, -0.5, 0.0]
normal = [0.0, 1.0, 0.0]
material = "floor"
checker = { color = [0.4, 0.3, 0.15], size = 0.5 }

[[light]]
position = [4.0, 2.0, -3.0]
color = [9.0, 9.0, 9.0]

[[light]]
position = [1.0, 4.0, 4.0]
color = [14.0, 14.0, 14.0]
"""

# Six around the equator of the parent's frame, three above.
HEIGHT, RING = math.sqrt(2 / 3), math.sqrt(1 / 3)
CHILDREN = [(math.cos(k * math.pi / 3), 0, -math.sin(k * math.pi / 3)) for k in range(6)]
CHILDREN += [(RING * math.cos(a), HEIGHT, -RING * math.sin(a)) for a in (math.pi / 6, 5 * math.pi / 6, 3 * math.pi / 2)]


def cross(a, b):
    return tuple(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3))


def grow(center, radius, up, levels):
    print(f'\n[[sphere]]\ncenter = [{", ".join(f"{round(c, 9) + 0.0}" for c in center)}]\nradius = {round(radius, 9)}\nmaterial = "M0"')
    if levels == 0:
        return
    axis = (1, 0, 0) if abs(up[0]) < 0.9 else (0, 1, 0)
    along = sum(a * b for a, b in zip(axis, up))
    x = tuple(a - along * b for a, b in zip(axis, up))
    x = tuple(a / math.hypot(*x) for a in x)
    frame = (x, up, cross(x, up))
    for child in CHILDREN:
        way = tuple(sum(child[k] * frame[k][i] for k in range(3)) for i in range(3))
        grow(tuple(c + radius * 4 / 3 * w for c, w in zip(center, way)), radius / 3, way, levels - 1)


print(HEAD, end="")
grow((0, 0, 0), 0.5, (0, 1, 0), int(sys.argv[1]) if len(sys.argv) > 1 else 4)
