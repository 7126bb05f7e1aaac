#!/usr/bin/env python3
"""Holds what `diefill estimate` says against runs of the same scenes at several shoe speeds, a line for each run.

    python3 tests/benchmark/estimate_against_runs.py [--threads N] [--csv FILE] --speeds 0.1,0.2,0.4 SCENE [SCENE ...]

Shares are of what a cavity holds at the density of the powder in the shoe; for slits, discharged volume over width,
length and shoe length. `estimate` is what the formula offers, full cavity or not: only where a cavity stays below full
does it stand against the run. Environment: DIEFILL (program, default build/bin/diefill)."""
import argparse
import csv
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("DIEFILL", str(ROOT / "build/bin/diefill"))
COLUMNS = ("scene", "powder", "grain_mm", "width_mm", "felt_mm", "speed_m_s", "crossings", "seed", "estimate", "dem",
           "estimate_over_dem", "estimate_s", "dem_s")
SOLID_DENSITY = 7.63e-8 / (7 * 4 / 3 * math.pi * 7.84e-5 ** 3)  # kg/m^3 of model D (Bierwisch 2009, Table C.4)


def scene_at(scene, speed, seed, folder):
    """The scene with another shoe speed and seed, in a folder of its own."""
    text = scene.read_text()
    text = re.sub(r'(?m)^velocity = "[^"]*"', f'velocity = "{speed} m/s"', text)
    text = re.sub(r"(?m)^seed = \d+", f"seed = {seed}", text)
    text = re.sub(r'(?m)^file = "([^"]*)"', lambda m: f'file = "{(scene.parent / m[1]).resolve()}"', text)
    path = folder / "scene.toml"
    path.write_text(text)
    return path


def estimate(path):
    words = [PROGRAM, "estimate", str(path), "--json"]
    return json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)


def run(path, threads, folder):
    words = [PROGRAM, "run", str(path), "--out", str(folder / "out"), "--threads", str(threads)]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"estimate_against_runs: {path} ended with {done.returncode}:\n{done.stderr[-2000:]}")
    return json.loads((folder / "out/report.json").read_text())


def shares(found, report):
    """What the estimate offers and what the run has, for the first opening."""
    opening = found["openings"][0]
    if opening["is_cavity"]:
        return sum(opening["offered_kg"]) / opening["full_mass_kg"], report["fill_ratio"]
    whole = opening["mouth_area_m2"] * found["shoe"]["length_m"]  # m^3
    discharged = report["mass_left_kg"] / (SOLID_DENSITY * report["bulk_solid_fraction"])
    offered = sum(opening["offered_kg"]) / found["powder"]["apparent_density_kg_m3"]
    return offered / whole, discharged / whole


def line_of(scene, speed, seed, threads):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        path = scene_at(scene, speed, seed, folder)
        found = estimate(path)
        began = time.monotonic()
        report = run(path, threads, folder)
        took = time.monotonic() - began
    guess, truth = shares(found, report)
    opening = found["openings"][0]
    preset = re.search(r'(?m)^preset = "([^"]*)"', scene.read_text())
    return dict(zip(COLUMNS, (
        os.path.relpath(scene, ROOT), preset[1] if preset else "custom",
        round(1e3 * found["powder"]["grain_diameter_m"], 4), round(1e3 * opening["mean_width_m"], 3),
        round(1e3 * opening["mean_width_as_felt_m"], 3), speed, found["shoe"]["crossings"], seed, round(guess, 4),
        round(truth, 4), round(guess / truth, 3), round(found["estimating_seconds"], 3), round(took, 1))))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scenes", nargs="+", metavar="SCENE", type=pathlib.Path)
    parser.add_argument("--speeds", required=True, help="m/s, separated by commas")
    parser.add_argument("--seeds", default="1")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--csv", type=pathlib.Path, help="file that lines are added to")
    options = parser.parse_args()
    print(",".join(COLUMNS), flush=True)
    for scene in options.scenes:
        for speed in options.speeds.split(","):
            for seed in options.seeds.split(","):
                line = line_of(scene.resolve(), float(speed), int(seed), options.threads)
                print(",".join(str(value) for value in line.values()), flush=True)
                if options.csv:
                    new = not options.csv.exists()
                    with options.csv.open("a", newline="") as file:
                        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
                        if new:
                            writer.writeheader()
                        writer.writerow(line)


if __name__ == "__main__":
    main()
