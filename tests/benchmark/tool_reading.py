#!/usr/bin/env python3
"""Processor time of reading, checking and covering the tools of a scene over the number of its wall spheres, with the
exponent between neighbouring sizes.

    python3 tests/benchmark/tool_reading.py build/bin/diefill [--scene FILE] [--csv OUT] RADIUS...

The radii (mm) replace [walls] sphere_radius; default: 0.3 0.2 0.15 0.1 0.075 on the narrow ring of 0.47 mm."""
import argparse
import csv
import math
import pathlib
import re
import resource
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def check(program, scene):
    """Wall spheres and processor seconds of one `diefill check`."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, "check", str(scene)], capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spheres = re.search(r"(\d+) wall spheres", done.stdout)
    if done.returncode != 0 or not spheres:
        sys.exit(f"{scene}: check failed: {done.stderr.strip().splitlines()[-1:]}")
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return int(spheres[1]), seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("radii", nargs="*", type=float, default=[0.3, 0.2, 0.15, 0.1, 0.075])
    parser.add_argument("--scene", type=pathlib.Path, default=ROOT / "sample_tools/narrow_ring/fill_d0.47.toml")
    parser.add_argument("--csv", type=pathlib.Path)
    arguments = parser.parse_args()
    text = arguments.scene.read_text()
    rows = []
    for radius in arguments.radii:
        changed, count = re.subn(r'(?m)^sphere_radius = "[^"]*"', f'sphere_radius = "{radius} mm"', text, count=1)
        if count != 1:
            sys.exit(f"{arguments.scene}: no sphere_radius in [walls]")
        scene = arguments.scene.with_name(f".reading_{radius}.toml")  # tools are named from the scene's folder
        scene.write_text(changed)
        try:
            spheres, seconds = check(arguments.program, scene)
        finally:
            scene.unlink()
        exponent = ""
        if rows:
            exponent = round(math.log(seconds / rows[-1][2]) / math.log(spheres / rows[-1][1]), 2)
        rows.append([radius, spheres, round(seconds, 1), exponent])
        print(f"radius {radius} mm: {spheres} wall spheres, {seconds:.1f} s of processor time, exponent {exponent or '-'}")
    if arguments.csv:
        with open(arguments.csv, "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(["radius_mm", "wall_spheres", "cpu_s", "exponent"])
            writer.writerows(rows)


if __name__ == "__main__":
    main()
