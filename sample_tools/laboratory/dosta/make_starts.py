#!/usr/bin/env python3
"""Makes start files of diefill (pour.grains_file) from those of Dosta et al. 2024 (Zenodo 10.5281/zenodo.8252892).

    make_starts.py FOLDER

FOLDER holds Case2_Drum_PartCoordinates.txt.gz and Case3_PenetrationTest_{25000,50000}_Particles.txt.gz. Writes
impact_25000.csv, impact_50000.csv and drum.csv beside this script. The ball, which the files of case 3 have as a last
grain, is a tool of the scene. 41 and 102 grains of case 3 have lost their y (the lines have x, z and NaN): they are
put where the others leave a hole between 0.9 and 2.1 mm, as all of them have one there and hardly elsewhere.
"""
import gzip
import math
import pathlib
import sys

RADIUS = 1e-3  # m, of all grains of case 3


def rows(file):
    with gzip.open(file, "rt") as lines:
        for line in lines:
            if line.strip() and not line.startswith("#"):
                yield [float(word) for word in line.split()]


def hole(x, z, grains):
    """y (m) at which the overlaps with all others are least, by their energy of Hertz springs."""
    near = [g for g in grains if abs(g[0] - x) < 2 * RADIUS and abs(g[2] - z) < 2 * RADIUS and g[1] < 6e-3 and
            g[1] > -3e-3]

    def energy(y):
        overlaps = (2 * RADIUS - math.dist((x, y, z), g) for g in near)
        return sum(h ** 2.5 for h in overlaps if h > 0)

    best = min((0.9e-3 + 1e-6 * k for k in range(1201)), key=energy)
    return min((best + 1e-8 * k for k in range(-100, 101)), key=energy)


def impact(file):
    grains, lost = [], []
    for row in rows(file):
        if math.isnan(row[2]):
            lost.append((row[0], row[1]))
        elif row[3] == RADIUS:
            grains.append(tuple(row[:3]))
    for x, z in lost:
        grains.append((x, hole(x, z, grains), z))
    return [(*grain, RADIUS) for grain in grains]


def write(name, spheres):
    target = pathlib.Path(__file__).parent / name
    with open(target, "w", encoding="ascii") as table:
        table.write("x [um], y [um], z [um], radius [um]\n")
        for sphere in spheres:
            table.write(",".join(f"{1e6 * value:.3f}".rstrip("0").rstrip(".") for value in sphere) + "\n")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1])
    for count in (25000, 50000):
        write(f"impact_{count}.csv", impact(folder / f"Case3_PenetrationTest_{count}_Particles.txt.gz"))
    write("drum.csv", rows(folder / "Case2_Drum_PartCoordinates.txt.gz"))


main()
