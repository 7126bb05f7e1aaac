#!/usr/bin/env python3
"""Compares what `diefill estimate` says with runs of the same scenes at several shoe speeds, a line for each opening.

    python3 tests/benchmark/estimate_against_runs.py [--csv FILE] --speeds 0.1,0.2,0.4 SCENE [SCENE ...]
    python3 tests/benchmark/estimate_against_runs.py --csv FILE --again

Shares are of what a cavity holds at the density of the powder in the shoe; for slits, discharged volume over width,
length and shoe length. `offered` is what the openings would let through if the cavities had no floor, `estimate` what
the program says they hold; within: the run lies in the range that the estimate states; source: "this script", or the
page that has the run (fill height over depth; mass through a slit). `--again` estimates the runs of FILE once more,
with the program as it is, and simulates nothing. Environment: DIEFILL (program, default build/bin/diefill)."""
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

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("DIEFILL", str(ROOT / "build/bin/diefill"))
RUN = ("scene", "opening", "powder", "grain_mm", "speed_m_s", "passages", "seed", "dem", "source")
FOUND = ("width_mm", "felt_mm", "offered", "estimate", "lowest", "highest", "estimate_over_dem", "within", "estimate_s")
SOLID_DENSITY = 7.63e-8 / (7 * 4 / 3 * math.pi * 7.84e-5 ** 3)  # kg/m^3 of model D (Bierwisch 2009, Table C.4)


def changed_scene(scene, run, folder):
    """The scene with the powder, grains, shoe speed, passages and seed of `run`, in a folder of its own."""
    text = scene.read_text()
    text = re.sub(r'(?m)^file = "([^"]*)"', lambda m: f'file = "{(scene.parent / m[1]).resolve()}"', text)
    for key, value in (("velocity", f'"{run["speed_m_s"]} m/s"'), ("seed", run["seed"]), ("passages", run["passages"]),
                       ("preset", f'"{run["powder"]}"'), ("grain_diameter", f'"{run["grain_mm"]} mm"')):
        text = re.sub(rf"(?m)^{key} = [^#\n]*", f"{key} = {value} ", text)
    path = folder / "scene.toml"
    path.write_text(text)
    return path


def estimate(path):
    words = [PROGRAM, "estimate", str(path), "--json"]
    return json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)


def run(path, threads, folder):
    words = [PROGRAM, "run", str(path), "--out", str(folder / "out"), "--threads", str(threads), "--no-pictures"]
    done = subprocess.run(words, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"estimate_against_runs: {path} ended with {done.returncode}:\n{done.stderr[-2000:]}")
    return json.loads((folder / "out/report.json").read_text())


def measured_share(found, report, number):
    """What the run has in opening `number`."""
    opening = found["openings"][number]
    if opening["is_cavity"]:
        return report["fill_ratio" if number == 0 else f"cavity_{number + 1}_fill_ratio"]
    whole = opening["mouth_area_m2"] * found["shoe"]["length_m"]  # m^3
    return report["mass_left_kg"] / (SOLID_DENSITY * report["bulk_solid_fraction"]) / whole


def estimated(found, number, dem):
    """Columns FOUND of one opening."""
    opening = found["openings"][number]
    if opening["is_cavity"]:
        whole = opening["full_mass_kg"]
    else:
        whole = opening["mouth_area_m2"] * found["shoe"]["length_m"] * found["powder"]["apparent_density_kg_m3"]
    share = opening["mass_kg"][-1] / whole
    lowest, highest = (value / whole for value in opening.get("mass_range_kg", (0, math.inf)))
    values = (1e3 * opening["mean_width_m"], 1e3 * opening["mean_width_as_felt_m"], sum(opening["offered_kg"]) / whole,
              share, lowest, highest, share / dem)
    return dict(zip(FOUND, [round(value, 4) for value in values] +
                    [int(lowest <= dem <= highest), round(found["estimating_seconds"], 3)]))


def preset_and_grain(scene):
    text = scene.read_text()
    preset = re.search(r'(?m)^preset = "([^"]*)"', text)
    grain = re.search(r'(?m)^grain_diameter = "([\d.]+) mm"', text)
    passages = re.search(r"(?m)^passages = (\d+)", text)
    return preset[1], float(grain[1]), int(passages[1]) if passages else 1


def lines_of(scene, one, threads):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        path = changed_scene(scene, one, folder)
        found = estimate(path)
        report = run(path, threads, folder)
    lines = []
    for number in range(len(found["openings"])):
        dem = round(measured_share(found, report, number), 4)
        lines.append({**one, "opening": number + 1, "dem": dem, **estimated(found, number, dem)})
    return lines


def again(rows):
    """The rows of a table with new estimates."""
    known = {}
    for row in rows:
        key = tuple(row[name] for name in ("scene", "powder", "grain_mm", "speed_m_s", "passages"))
        if key not in known:
            with tempfile.TemporaryDirectory() as name:
                known[key] = estimate(changed_scene(ROOT / row["scene"], row, pathlib.Path(name)))
        row.update(estimated(known[key], int(row["opening"]) - 1, float(row["dem"])))
    return rows


def summary(rows):
    ratios = sorted(float(row["estimate_over_dem"]) for row in rows)
    within = sum(int(row["within"]) for row in rows)
    return (f"{len(rows)} openings: estimate over run {ratios[0]:.2f} to {ratios[-1]:.2f}, median "
            f"{ratios[len(ratios) // 2]:.2f}; {within} within the stated range ({100 * within / len(rows):.0f} %)")


def write(path, rows):
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, RUN + FOUND, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scenes", nargs="*", metavar="SCENE", type=pathlib.Path)
    parser.add_argument("--speeds", help="m/s, separated by commas")
    parser.add_argument("--seeds", default="1")
    parser.add_argument("--powder", help="preset in place of the scenes' own")
    parser.add_argument("--grain", type=float, help="mm, in place of the scenes' own")
    parser.add_argument("--passages", type=int, help="in place of the scenes' own")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--csv", type=pathlib.Path, help="table that lines are added to")
    parser.add_argument("--again", action="store_true", help="only estimate the runs of the table once more")
    options = parser.parse_intermixed_args()
    rows = list(csv.DictReader(options.csv.open())) if options.csv and options.csv.exists() else []
    if options.again:
        rows = again(rows)
        write(options.csv, rows)
        print(summary(rows))
        return
    print(",".join(RUN + FOUND), flush=True)
    for scene in options.scenes:
        preset, grain, passages = preset_and_grain(scene)
        for speed in options.speeds.split(","):
            for seed in options.seeds.split(","):
                one = {"scene": os.path.relpath(scene.resolve(), ROOT), "powder": options.powder or preset,
                       "grain_mm": options.grain or grain, "speed_m_s": float(speed),
                       "passages": options.passages or passages, "seed": int(seed), "source": "this script"}
                for line in lines_of(scene.resolve(), one, options.threads):
                    print(",".join(str(line[name]) for name in RUN + FOUND), flush=True)
                    if options.csv:
                        new = not options.csv.exists()
                        with options.csv.open("a", newline="") as file:
                            writer = csv.DictWriter(file, RUN + FOUND, lineterminator="\n")
                            if new:
                                writer.writeheader()
                            writer.writerow(line)


if __name__ == "__main__":
    main()
