#!/usr/bin/env python3
"""The bed that both codes collapse, and what they make of it. Standard library only.

collapse.py make STATE.csv LAMMPS.data           the loose lattice, for diefill and for LAMMPS
collapse.py compare OURS_FOLDER LAMMPS_FOLDER    solid fraction, coordination number, kinetic energy; exit code 1 when
                                                 they differ by more than 0.5 %, 2 % and 5 %
"""
import csv, math, os, random, sys

RADIUS, DENSITY = 1.5e-4, 5400.0
ACROSS, LAYERS, SPACING, SPEED = 14, 26, 2.2 * RADIUS, 0.3
WIDTH = ACROSS * SPACING


def make(state, data):
    chance = random.Random(5)
    grains = []
    for layer in range(LAYERS):
        for k in range(ACROSS):
            for i in range(ACROSS):
                place = [(i + 0.5) * SPACING, (k + 0.5) * SPACING, (layer + 0.55) * SPACING]
                grains.append(([x + chance.uniform(-0.05, 0.05) * RADIUS for x in place],
                               [chance.uniform(-SPEED, SPEED) for _ in range(3)]))
    with open(state, 'w') as f:
        f.write('id,x,y,z,vx,vy,vz,wx,wy,wz\n')
        for n, (place, velocity) in enumerate(grains):
            f.write('%d,%.12e,%.12e,%.12e,%.12e,%.12e,%.12e,0,0,0\n' % (n, *place, *velocity))
    with open(data, 'w') as f:
        f.write('loose lattice\n\n%d atoms\n1 atom types\n\n0 %.12g xlo xhi\n0 %.12g ylo yhi\n-4e-4 0.03 zlo zhi\n\nAtoms\n\n'
                % (len(grains), WIDTH, WIDTH))
        for n, (place, _) in enumerate(grains):
            f.write('%d 1 %.9e %.9e %.12e %.12e %.12e\n' % (n + 1, 2 * RADIUS, DENSITY, *place))
        f.write('\nVelocities\n\n')
        for n, (_, velocity) in enumerate(grains):
            f.write('%d %.12e %.12e %.12e 0 0 0\n' % (n + 1, *velocity))


def read_places(folder):
    dump = os.path.join(folder, 'grains.dump')
    if os.path.exists(dump):
        lines = open(dump).read().split('\n')
        rows = lines[next(k for k, line in enumerate(lines) if line.startswith('ITEM: ATOMS')) + 1:]
        return [tuple(map(float, row.split()[1:4])) for row in rows if row]
    with open(os.path.join(folder, 'grains.csv')) as f:
        return [(float(r['x']), float(r['y']), float(r['z'])) for r in csv.DictReader(f)]


def slab_volume(z, low, high):
    """Of a sphere at height z, what lies between the heights."""
    below = lambda height: (lambda s: math.pi * s * s * (3 * RADIUS - s) / 3)(min(max(height - z + RADIUS, 0), 2 * RADIUS))
    return below(high) - below(low)


def figures(places):
    top = sorted(z for _, _, z in places)[int(0.98 * len(places))]
    low, high = 0.2 * top, 0.7 * top
    fraction = sum(slab_volume(z, low, high) for _, _, z in places) / (WIDTH * WIDTH * (high - low))
    cells = {}
    size = WIDTH / math.floor(WIDTH / (2.001 * RADIUS))
    count = round(WIDTH / size)
    for n, (x, y, z) in enumerate(places):
        cells.setdefault((math.floor(x / size) % count, math.floor(y / size) % count, math.floor(z / size)), []).append(n)
    near = lambda d: d - WIDTH * round(d / WIDTH)
    touching, inside = 0, 0
    for (i, k, layer), members in cells.items():
        around = [m for a in (-1, 0, 1) for b in (-1, 0, 1) for c in (-1, 0, 1)
                  for m in cells.get(((i + a) % count, (k + b) % count, layer + c), [])]
        for n in members:
            x, y, z = places[n]
            if not low < z < high:
                continue
            inside += 1
            touching += sum(1 for m in around if m != n and near(places[m][0] - x) ** 2 + near(places[m][1] - y) ** 2 +
                            (places[m][2] - z) ** 2 < 4 * RADIUS * RADIUS)
    return fraction, touching / inside


def energies(folder):
    with open(os.path.join(folder, 'energy.csv')) as f:
        rows = [[float(x) for x in row] for row in list(csv.reader(f))[1:]]
    return {round(1e6 * row[0]): row[1] + row[2] for row in rows}


def compare(ours, theirs):
    good = True

    def line(name, a, b, allowed):
        nonlocal good
        off = abs(a / b - 1)
        good = good and off <= allowed
        print('%s: diefill %.4f, LAMMPS %.4f, %.2f %% apart (%.1f %% allowed)' % (name, a, b, 100 * off, 100 * allowed))

    (fraction, contacts), (their_fraction, their_contacts) = figures(read_places(ours)), figures(read_places(theirs))
    line('solid fraction', fraction, their_fraction, 0.005)
    line('coordination number', contacts, their_contacts, 0.02)
    a, b = energies(ours), energies(theirs)
    times = sorted(t for t in a if t in b and 0 < t <= 20000)
    if len(times) < 10:
        sys.exit('collapse: the two histories have hardly an instant in common')
    worst = max(times, key=lambda t: abs(a[t] / b[t] - 1))
    line('kinetic energy in uJ where they differ most in the first 20 ms, at %.1f ms' % (worst / 1000),
         1e6 * a[worst], 1e6 * b[worst], 0.05)
    return 0 if good else 1


if len(sys.argv) == 4 and sys.argv[1] == 'make':
    make(*sys.argv[2:])
elif len(sys.argv) == 4 and sys.argv[1] == 'compare':
    sys.exit(compare(*sys.argv[2:]))
elif sys.argv[1:] == ['width']:
    print('%.12g' % (1e3 * WIDTH))
else:
    sys.exit(__doc__)
