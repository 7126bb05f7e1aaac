#!/usr/bin/env python3
"""Runs scenes with grains of several sizes and seeds, and tells how far coarse grains are off the finest.

    python3 tests/benchmark/grain_size_errors.py run --csv FILE --shares 0.42,0.33,0.25 --seeds 1,2,3 SCENE [SCENE ...]
    python3 tests/benchmark/grain_size_errors.py sum --csv FILE

`run` adds a line for each run to the table: share is the grain diameter over the narrowest width of the cavity; `sum`
prints, for each scene and powder, the means over seeds over those of the finest grains of the same series less 1, and
their scatter (standard deviation over seeds of one run). Environment: DIEFILL (program, default build/bin/diefill)."""
import argparse
import csv
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("DIEFILL", str(ROOT / "build/bin/diefill"))
# name in the table, figure of report.json
FIGURES = (("filled", "cavity_solid_fraction"), ("fraction", "solid_fraction_mean"),
           ("unevenness", "solid_fraction_field_std"))
COLUMNS = ("scene", "powder", "width_mm", "share", "seed", "grains") + tuple(name for name, _ in FIGURES) + ("seconds",)


def narrowest_width(scene):
    words = [PROGRAM, "plan", str(scene), "--no-benchmark", "--json"]
    found = json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)
    return found["needs"]["narrowest_width_m"]


def changed_scene(scene, powder, grain, seed, folder):
    text = scene.read_text()
    text = re.sub(r'(?m)^file = "([^"]*)"', lambda m: f'file = "{(scene.parent / m[1]).resolve()}"', text)
    for key, value in (("grain_diameter", f'"{1e3 * grain:.4f} mm"'), ("seed", seed), ("preset", f'"{powder}"')):
        text = re.sub(rf"(?m)^{key} = [^#\n]*", f"{key} = {value} ", text)
    path = folder / "scene.toml"
    path.write_text(text)
    return path


def line_of(scene, powder, width, share, seed, threads):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        path = changed_scene(scene, powder, share * width, seed, folder)
        words = [PROGRAM, "run", str(path), "--out", str(folder / "out"), "--threads", str(threads), "--no-pictures"]
        began = time.monotonic()
        done = subprocess.run(words, capture_output=True, text=True)
        if done.returncode != 0:
            print(f"{scene} at {share}: {done.stderr[-500:]}", file=sys.stderr)
            return None
        report = json.loads((folder / "out/report.json").read_text())
    figures = [round(report[key], 5) if report.get(key) is not None else "" for _, key in FIGURES]
    return dict(zip(COLUMNS, [os.path.relpath(scene, ROOT), powder, round(1e3 * width, 3), share, seed,
                              report["grains"]] + figures + [round(time.monotonic() - began, 1)]))


def run(options):
    for scene in options.scenes:
        width = narrowest_width(scene)
        preset = options.powder or re.search(r'(?m)^preset = "([^"]*)"', scene.read_text())[1]
        for share in options.shares.split(","):
            for seed in options.seeds.split(","):
                line = line_of(scene.resolve(), preset, width, float(share), int(seed), options.threads)
                if line is None:
                    continue
                new = not options.csv.exists()
                with options.csv.open("a", newline="") as file:
                    writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
                    if new:
                        writer.writeheader()
                    writer.writerow(line)


def mean_and_scatter(rows, name):
    values = [float(row[name]) for row in rows if row[name] != ""]
    if not values:
        return None, None
    return statistics.mean(values), statistics.stdev(values) if len(values) > 1 else None


def summed(path):
    """Lines of scene, powder, share, runs, reference share, then error and scatter of every figure."""
    series = {}
    for row in csv.DictReader(path.open()):
        series.setdefault((row["scene"], row["powder"]), {}).setdefault(float(row["share"]), []).append(row)
    for (scene, powder), shares in sorted(series.items()):
        finest = min(shares)
        for share in sorted(shares):
            line = [scene, powder, share, len(shares[share]), finest]
            for name, _ in FIGURES:
                reference, _ = mean_and_scatter(shares[finest], name)
                mean, scatter = mean_and_scatter(shares[share], name)
                if reference is None or mean is None:
                    line += ["", ""]
                    continue
                line += [round(mean / reference - 1, 4), "" if scatter is None else round(scatter / reference, 4)]
            yield line


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("what", choices=("run", "sum"))
    parser.add_argument("scenes", nargs="*", metavar="SCENE", type=pathlib.Path)
    parser.add_argument("--csv", required=True, type=pathlib.Path, help="table of runs")
    parser.add_argument("--shares", help="grain diameters over the narrowest width, separated by commas")
    parser.add_argument("--seeds", default="1,2,3")
    parser.add_argument("--powder", help="preset in place of the scenes' own")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    options = parser.parse_args()
    if options.what == "run":
        run(options)
        return
    heading = ["scene", "powder", "share", "runs", "reference_share"]
    for name, _ in FIGURES:
        heading += [f"{name}_error", f"{name}_scatter"]
    print(",".join(heading))
    for line in summed(options.csv):
        print(",".join(str(value) for value in line))


if __name__ == "__main__":
    main()
