#!/usr/bin/env python3
"""Runs scenes without a cavity with grains of several sizes and seeds, and tells how their figures move with the size.

    python3 tests/benchmark/open_scene_errors.py run --csv FILE --sizes 0.94,1.41,1.88,2.82 --seeds 1,2,3 SCENE [...]
    python3 tests/benchmark/open_scene_errors.py table --csv FILE

Scenes: those of sample_tools/tradeoff in LENGTHS, sizes in mm. `run` adds a line for each figure of each run: share is
the grain diameter over the length that matters (width of the opening, depth of the powder), seconds processor time of
the run. `table` fits a line over the share to each figure of each scene and powder, and prints the rows of
process/plan/open_scene_trends.cpp. Environment: DIEFILL (program, default build/bin/diefill)."""
import argparse
import csv
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from grain_size_errors import PROGRAM, ROOT, line_through, processor_seconds

LENGTHS = {"slit_discharge": 10, "compressed_bed": 16, "angle_of_repose": 16}  # mm
COLUMNS = ("scene", "powder", "length_mm", "share", "seed", "figure", "value", "seconds")


def figures(folder):
    """Name and value of each figure of a run that is told here."""
    report = json.loads((folder / "report.json").read_text())
    flows = [probe for probe in report.get("probes", []) if probe["quantity"] == "flow"]
    if flows:
        yield "mass through the opening", 1e3 * flows[0]["mass_kg"]
        return
    yield "bulk solid fraction", report["bulk_solid_fraction"]
    if "slope_of_heap_on_the_slider_deg" in report:
        yield "slope of a heap", report["slope_of_heap_on_the_slider_deg"]


def changed_scene(scene, powder, size, seed, folder):
    text = re.sub(r'(?m)^file = "([^"]*)"', lambda m: f'file = "{(scene.parent / m[1]).resolve()}"', scene.read_text())
    for key, value in (("grain_diameter", f'"{size} mm"'), ("seed", seed), ("preset", f'"{powder}"')):
        text = re.sub(rf"(?m)^{key} = [^#\n]*", f"{key} = {value} ", text)
    path = folder / "scene.toml"
    path.write_text(text)
    return path


def lines_of(scene, powder, size, seed):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        path = changed_scene(scene, powder, size, seed, folder)
        began = processor_seconds()
        words = [PROGRAM, "run", str(path), "--out", str(folder / "out"), "--threads", "1", "--no-pictures"]
        done = subprocess.run(words, capture_output=True, text=True)
        if done.returncode != 0:
            print(f"{scene} with {size} mm: {done.stderr[-500:]}", file=sys.stderr)
            return
        seconds = round(processor_seconds() - began, 1)
        length = LENGTHS[scene.stem]
        for figure, value in figures(folder / "out"):
            yield {"scene": os.path.relpath(scene, ROOT), "powder": powder, "length_mm": length,
                   "share": round(size / length, 4), "seed": seed, "figure": figure, "value": round(value, 5),
                   "seconds": seconds}


def run(options):
    for scene in options.scenes:
        for size in options.sizes.split(","):
            for seed in options.seeds.split(","):
                lines = list(lines_of(scene.resolve(), options.powder, float(size), int(seed)))
                new = not options.csv.exists()
                with options.csv.open("a", newline="") as file:
                    writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
                    if new:
                        writer.writeheader()
                    writer.writerows(lines)


def table(path):
    series = {}
    for row in csv.DictReader(path.open()):
        series.setdefault((pathlib.Path(row["scene"]).stem, row["powder"], row["figure"]), []).append(row)
    for (scene, powder, figure), rows in series.items():
        points = [(float(row["share"]), float(row["value"])) for row in rows]
        limit, slope, error, scatter = line_through(points)
        shares = [share for share, _ in points]
        print(f'    {{"{scene}", "{powder}", "{figure}", {slope / limit:.4f}, {error / limit:.4f}, '
              f'{scatter / limit:.4f}, {min(shares):g}, {max(shares):g}, {len(points)}}},')


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("what", choices=("run", "table"))
    parser.add_argument("scenes", nargs="*", metavar="SCENE", type=pathlib.Path)
    parser.add_argument("--csv", required=True, type=pathlib.Path, help="table of runs")
    parser.add_argument("--sizes", help="grain diameters in mm, separated by commas")
    parser.add_argument("--seeds", default="1,2,3")
    parser.add_argument("--powder", help="preset", default="ASC100.29 D2")
    options = parser.parse_intermixed_args()
    run(options) if options.what == "run" else table(options.csv)


if __name__ == "__main__":
    main()
