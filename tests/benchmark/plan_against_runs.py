#!/usr/bin/env python3
"""Compares what `diefill plan` predicts with runs: spheres, steps, memory and wall time, a line for each scene.

    python3 tests/benchmark/plan_against_runs.py [--threads N] [--minutes M] [--csv FILE] SCENE [SCENE ...]

Plans a scene, then runs it on as many threads, before it turns to the next one. A run is stopped after M minutes of
computing (default 60): its line then says up to which simulated time it came, and compares that part with what the
plan has for it. Environment: DIEFILL (program, default build/bin/diefill)."""
import argparse
import csv
import json
import math
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("DIEFILL", str(ROOT / "build/bin/diefill"))
COLUMNS = ("scene", "threads", "simulated_s", "whole", "spheres_plan", "spheres_run", "steps_plan", "steps_run",
           "memory_mb_plan", "memory_mb_run", "wall_s_plan", "wall_s_run", "run_over_plan")


def plan(scene, threads):
    """The plan of the scene as it stands."""
    words = [PROGRAM, "plan", str(scene), "--threads", str(threads), "--json"]
    text = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    return json.loads(text)["choices"][0]


def first_part(choice, seconds):
    """Steps and wall seconds that the plan has for the first `seconds` of simulated time."""
    steps = wall = 0.0
    for phase in choice["phases"]:
        share = min(1.0, max(0.0, seconds / phase["simulated_s"])) if phase["simulated_s"] > 0 else 1.0
        steps += share * phase["steps"]
        wall += share * phase["wall_seconds"]
        seconds -= phase["simulated_s"]
    return steps, wall


def ended(process):
    """Peak memory in bytes of a process that has ended, and its exit status; nothing while it runs."""
    pid, status, usage = os.wait4(process.pid, os.WNOHANG)
    if pid == 0:
        return None
    process.returncode = os.waitstatus_to_exitcode(status)
    return 1024 * usage.ru_maxrss, process.returncode


def run(scene, threads, minutes, folder):
    """Runs the scene for `minutes` at most; its report with peak memory (bytes), or
    the simulated time it came to with the wall seconds until then."""
    log = folder / "log.txt"
    words = [PROGRAM, "run", str(scene), "--out", str(folder / "out"), "--threads", str(threads)]
    began = None
    with log.open("w") as output:
        process = subprocess.Popen(words, stdout=output, stderr=output)
        while (end := ended(process)) is None:
            time.sleep(0.2)
            if began is None and "t = " in log.read_text():
                began = time.monotonic()
            if began is not None and time.monotonic() - began > 60 * minutes:
                os.kill(process.pid, signal.SIGINT)  # Popen would reap it and its peak memory
                minutes = math.inf  # asked once
    memory, status = end
    came_to = re.findall(r"stopped at t = ([0-9.]+) s", log.read_text())
    if came_to:
        return {"simulated_s": float(came_to[-1]), "wall_seconds": time.monotonic() - began, "whole": False}
    if status != 0:
        sys.exit(f"plan_against_runs: {scene} ended with {status}:\n{log.read_text()[-2000:]}")
    report = json.loads((folder / "out/report.json").read_text())
    return {**report, "memory": memory, "whole": True}


def line_of(scene, threads, minutes):
    choice = plan(scene, threads)
    with tempfile.TemporaryDirectory() as folder:
        result = run(scene, threads, minutes, pathlib.Path(folder))
    whole = result["whole"]
    steps, wall = (choice["steps"], choice["wall_seconds"]) if whole else first_part(choice, result["simulated_s"])
    return dict(zip(COLUMNS, (
        os.path.relpath(scene, ROOT), threads, round(result["simulated_s"], 4), "yes" if whole else "no",
        choice["spheres"], int(result["spheres"]) if whole else "", round(steps), int(result["steps"]) if whole else "",
        round(choice["memory_bytes"] / 1e6), round(result["memory"] / 1e6) if whole else "", round(wall, 1),
        round(result["wall_seconds"], 1), round(result["wall_seconds"] / wall, 3))))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("scenes", nargs="+", metavar="SCENE", type=pathlib.Path)
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--minutes", type=float, default=60)
    parser.add_argument("--csv", type=pathlib.Path, help="file that lines are added to")
    options = parser.parse_args()
    print(",".join(COLUMNS), flush=True)
    for scene in options.scenes:
        line = line_of(scene.resolve(), options.threads, options.minutes)
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
