#!/usr/bin/env python3
"""Runs scenes with grains of several sizes and seeds, and tells how figures move with the size.

    python3 tests/benchmark/grain_size_errors.py run --csv FILE --shares 0.42,0.33,0.25 --seeds 1,2,3 SCENE [SCENE ...]
    python3 tests/benchmark/grain_size_errors.py table --csv FILE

`run` pours powder over the cavity of each scene until it is heaped, moves nothing, measures the powder below the fill
plane, and adds a line for each run to the table: share is the grain diameter over the narrowest width of the cavity,
filled the volume of grains over that of the cavity, mean the mean solid fraction of grains two diameters deep,
unevenness the standard deviation of the field of solid fraction, seconds processor time. Wall spheres of the small
dies are 2.4 radii apart: grains finer than a quarter of the width pass between them and need `--walls mesh`. `table` fits a line over the share to each figure of each cavity and powder, and prints the rows
of process/plan/grain_size_trends.cpp. Figures of too few grains are empty. Environment: DIEFILL (program, default
build/bin/diefill)."""
import argparse
import csv
import json
import math
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("DIEFILL", str(ROOT / "build/bin/diefill"))
# name in the table, figure of report.json, figure in process/plan/grain_size_trends.cpp
FIGURES = (("filled", "cavity_solid_fraction", "mass of a full cavity"),
           ("mean", "solid_fraction_mean", "mean solid fraction"),
           ("unevenness", "solid_fraction_field_std", "unevenness"))
COLUMNS = ("scene", "powder", "width_mm", "share", "seed", "grains", "filled", "unevenness", "seconds", "mean", "walls")


# mm, half the lengths of the cavities along x and y; all are 10 mm deep
CAVITIES = {"square": (4, 4), "slot": (3, 8), "ring_6mm": (11, 11)}
FILL_HEIGHT = 14  # mm of settled powder over that area, so that it heaps above the fill plane


def processor_seconds():
    """s that the programs that this one has run to their end have computed."""
    use = resource.getrusage(resource.RUSAGE_CHILDREN)
    return use.ru_utime + use.ru_stime


def narrowest_width(scene):
    words = [PROGRAM, "plan", str(scene), "--no-benchmark", "--json"]
    found = json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)
    return found["needs"]["narrowest_width_m"]


def poured(text, half):
    """The scene with powder poured over the cavity, of half these lengths (mm), instead of brought by the shoe."""
    text = re.sub(r"(?ms)^\[\[step\]\].*?(?=^\[)", "", text)
    x, y = (length - 0.05 for length in half)
    pour = (f'[pour]\nfrom = ["{-x} mm", "{-y} mm", "-10 mm"]\nto = ["{x} mm", "{y} mm", "10 mm"]\n'
            f'fill_height = "{FILL_HEIGHT} mm"\naround_tools = true\n\n')
    return re.sub(r"(?ms)^\[pour\].*?(?=^\[)", pour, text)


def changed_scene(scene, powder, walls, grain, seed, folder):
    text = poured(scene.read_text(), CAVITIES[scene.stem])
    text = re.sub(r'(?m)^file = "([^"]*)"', lambda m: f'file = "{(scene.parent / m[1]).resolve()}"', text)
    for key, value in (("grain_diameter", f'"{1e3 * grain:.4f} mm"'), ("seed", seed), ("preset", f'"{powder}"')):
        text = re.sub(rf"(?m)^{key} = [^#\n]*", f"{key} = {value} ", text)
    text = re.sub(r"(?m)^\[walls\]$", f'[walls]\nkind = "{walls}"', text)
    path = folder / "scene.toml"
    path.write_text(text)
    return path


def line_of(scene, powder, walls, width, share, seed, threads):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        path = changed_scene(scene, powder, walls, share * width, seed, folder)
        words = [PROGRAM, "run", str(path), "--out", str(folder / "out"), "--threads", str(threads), "--no-pictures"]
        began = processor_seconds()
        done = subprocess.run(words, capture_output=True, text=True)
        if done.returncode != 0:
            print(f"{scene} at {share}: {done.stderr[-500:]}", file=sys.stderr)
            return None
        report = json.loads((folder / "out/report.json").read_text())
    report["solid_fraction_mean"] = report["solid_fraction"]["mean"]
    line = {"scene": os.path.relpath(scene, ROOT), "powder": powder, "width_mm": round(1e3 * width, 3), "share": share,
            "seed": seed, "grains": report["grains"], "seconds": round(processor_seconds() - began, 1), "walls": walls}
    for name, key, _ in FIGURES:
        line[name] = round(report[key], 5) if report.get(key) is not None else ""
    return line


def run(options):
    for scene in options.scenes:
        width = narrowest_width(scene)
        preset = options.powder or re.search(r'(?m)^preset = "([^"]*)"', scene.read_text())[1]
        for share in options.shares.split(","):
            for seed in options.seeds.split(","):
                line = line_of(scene.resolve(), preset, options.walls, width, float(share), int(seed), options.threads)
                if line is None:
                    continue
                new = not options.csv.exists()
                with options.csv.open("a", newline="") as file:
                    writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
                    if new:
                        writer.writeheader()
                    writer.writerow(line)


def line_through(points):
    """Limit, slope, its standard error and the scatter of points (x, y) about their line."""
    count = len(points)
    middle = sum(x for x, _ in points) / count
    height = sum(y for _, y in points) / count
    spread = sum((x - middle) ** 2 for x, _ in points)
    slope = sum((x - middle) * (y - height) for x, y in points) / spread
    limit = height - slope * middle
    scatter = math.sqrt(sum((y - limit - slope * x) ** 2 for x, y in points) / (count - 2))
    return limit, slope, scatter / math.sqrt(spread), scatter


def trends(path):
    """Cavity, powder, figure, slope, its error, scatter, finest and coarsest share, runs."""
    series = {}
    for row in csv.DictReader(path.open()):
        series.setdefault((pathlib.Path(row["scene"]).stem, row["powder"], row["walls"]), []).append(row)
    for (cavity, powder, walls), rows in series.items():
        points = {name: [(float(row["share"]), float(row[name])) for row in rows if row[name]]
                  for name, _, _ in FIGURES}
        for name, _, title in FIGURES:
            shares = [share for share, _ in points[name]]
            if len(set(shares)) < 2 or len(shares) < 4:
                continue
            over = line_through(points["filled"])[0]
            _, slope, error, scatter = line_through(points[name])
            yield (cavity + (" (mesh)" if walls == "mesh" else ""), powder, title, slope / over, error / over,
                   scatter / over, min(shares), max(shares), len(shares))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("what", choices=("run", "table"))
    parser.add_argument("scenes", nargs="*", metavar="SCENE", type=pathlib.Path)
    parser.add_argument("--csv", required=True, type=pathlib.Path, help="table of runs")
    parser.add_argument("--shares", help="grain diameters over the narrowest width, separated by commas")
    parser.add_argument("--seeds", default="1,2,3")
    parser.add_argument("--powder", help="preset in place of the scenes' own")
    parser.add_argument("--walls", choices=("spheres", "mesh"), default="spheres", help="kind of the tools' surface")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    options = parser.parse_intermixed_args()
    if options.what == "run":
        run(options)
        return
    for cavity, powder, title, slope, error, scatter, finest, coarsest, runs in trends(options.csv):
        print(f'    {{"{cavity}", "{powder}", "{title}", {slope:.4f}, {error:.4f}, {scatter:.4f}, {finest:g}, '
              f'{coarsest:g}, {runs}}},')


if __name__ == "__main__":
    main()
