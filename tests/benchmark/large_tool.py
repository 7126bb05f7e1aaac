#!/usr/bin/env python3
"""Writes a scene with a round die of millions of triangles: how long does `diefill check` take, and how much memory?

    python3 tests/benchmark/large_tool.py out/large 10 && /usr/bin/time -v build/bin/diefill check out/large/fill.toml

The die is a tube of 20 mm inner and 40 mm outer radius, 30 mm high, cut evenly into the given number of millions of
triangles; wall spheres of 0.054 mm cover it with about a million where powder can come."""
import math
import os
import struct
import sys

SCENE = """title = "Large die"
[powder]
preset = "Distaloy AE"
grain_diameter = "1.88 mm"
[walls]
sphere_radius = "0.054 mm"
[[tool]]
name = "die"
role = "die"
file = "die.stl"
length_unit = "mm"
[[tool]]
name = "punch"
role = "punch"
file = "punch.stl"
length_unit = "mm"
sphere_radius = "0.15 mm"
[[tool]]
name = "shoe"
role = "shoe"
file = "shoe.stl"
length_unit = "mm"
sphere_radius = "0.15 mm"
[pour]
from = ["-10 mm", "-10 mm", "0 mm"]
to = ["10 mm", "10 mm", "20 mm"]
fill_height = "5 mm"
[[step]]
kind = "settle"
[measure]
fill_plane = "0 mm"
"""


def outline(corners, pieces):
    """The closed outline (radius, height) cut into about `pieces` equal pieces."""
    sides = [(a, b, math.dist(a, b)) for a, b in zip(corners, corners[1:] + corners[:1])]
    whole = sum(length for _, _, length in sides)
    points = []
    for (r, z), (r_end, z_end), length in sides:
        cuts = max(1, round(pieces * length / whole))
        points += [(r + (r_end - r) * k / cuts, z + (z_end - z) * k / cuts) for k in range(cuts)]
    return points


def write_turned(path, corners, pieces, around):
    """Turns an outline that runs clockwise in the (radius, height) plane about z: two triangles a piece and step."""
    points = outline(corners, pieces)
    turns = [(math.cos(2 * math.pi * k / around), math.sin(2 * math.pi * k / around)) for k in range(around)]
    rows = [[struct.pack("<3f", r * c, r * s, z) for c, s in turns] for r, z in points]
    normal, end = struct.pack("<3f", 0, 0, 0), b"\0\0"
    with open(path, "wb") as file:
        file.write(b"\0" * 80 + struct.pack("<I", 2 * len(points) * around))
        for here, there in zip(rows, rows[1:] + rows[:1]):
            pieces_of_row = []
            for k in range(around):
                a, b, c, d = here[k], here[k - 1], there[k - 1], there[k]
                pieces_of_row += [normal, a, b, c, end, normal, a, c, d, end]
            file.write(b"".join(pieces_of_row))


def main():
    folder, millions = sys.argv[1], float(sys.argv[2])
    os.makedirs(folder, exist_ok=True)
    # Pieces about as long as wide at the inner radius.
    around = round(math.sqrt(millions * 5e5 * 2 * math.pi * 20 / 100))
    pieces = round(millions * 5e5 / around)
    write_turned(folder + "/die.stl", [(20, -30), (20, 0), (40, 0), (40, -30)], pieces, around)
    write_turned(folder + "/punch.stl", [(1, -40), (1, -30), (19.95, -30), (19.95, -40)], 8, 96)
    write_turned(folder + "/shoe.stl", [(22, 0), (22, 30), (25, 30), (25, 0)], 8, 96)
    with open(folder + "/fill.toml", "w", encoding="utf-8") as file:
        file.write(SCENE)


main()
