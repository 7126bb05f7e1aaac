#!/usr/bin/env python3
"""Processor time of compiling the program, without a compiler cache, of one or several build directories.

    python3 tests/benchmark/build_time.py build [OTHER_BUILD ...] [--sample 60] [--csv FILE]

Every source whose own time may matter (--always, by the beginning of its path) and a random sample of the others are
compiled, those of the build directories in turns; the sum of the sample is scaled to the number of sources. Precompiled
headers must exist. Linking is not counted. Prints the sum of each directory with its standard error, and the largest costs.
"""
import argparse
import csv
import json
import math
import os
import random
import re
import resource
import shlex
import subprocess
import sys
import tempfile

ALWAYS = "engine/contact/,cmake_pch"  # kernels, and headers compiled once a target
LEFT_OUT = re.compile(r"(^|/)(tests|app/python)/")


def sources_of(build):
    """Commands of the program's sources by their path below the tree."""
    with open(os.path.join(build, "compile_commands.json")) as file:
        commands = json.load(file)
    tree = os.path.dirname(os.path.abspath(build))
    found = {}
    for entry in commands:
        path = os.path.relpath(entry["file"], tree)
        if not LEFT_OUT.search(path):
            found[path] = entry
    return found


def seconds_of(entry):
    """Processor time, s, of one compilation; the object is thrown away."""
    words = shlex.split(entry["command"])
    while not os.path.basename(words[0]).startswith(("c++", "g++", "cc", "gcc", "clang")) or words[0].endswith("ccache"):
        words.pop(0)
    place = words.index("-o")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:  # the compiler writes no precompiled header to /dev/null
        words[place + 1] = os.path.join(folder, "object")
        done = subprocess.run(words, cwd=entry["directory"], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{entry['file']}: {done.stderr[-500:]}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def chosen(sources, always, sample, seed):
    certain = [path for path in sources if any(part in path for part in always)]
    others = sorted(set(sources) - set(certain))
    return certain, random.Random(seed).sample(others, min(sample, len(others))), len(others)


def sum_of(certain, sampled, others, seconds):
    """Sum over all sources, s, and its standard error."""
    total = sum(seconds[path] for path in certain)
    if not sampled:
        return total, 0.0
    values = [seconds[path] for path in sampled]
    mean = sum(values) / len(values)
    spread = math.sqrt(sum((value - mean) ** 2 for value in values) / max(1, len(values) - 1))
    left = math.sqrt(1 - len(values) / others)  # a complete sample has no error
    return total + others * mean, others * left * spread / math.sqrt(len(values))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("builds", nargs="+", help="build directories, configured; precompiled headers built")
    parser.add_argument("--sample", type=int, default=60, help="sources of each that are compiled")
    parser.add_argument("--always", default=ALWAYS, help="parts of paths that are compiled in any case")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--csv", help="table: build, source, seconds")
    options = parser.parse_args()
    plans = []
    for build in options.builds:
        sources = sources_of(build)
        plans.append((build, sources, *chosen(sources, options.always.split(","), options.sample, options.seed), {}))
    lengths = [len(certain) + len(sampled) for _, _, certain, sampled, _, _ in plans]
    for n in range(max(lengths)):
        for _, sources, certain, sampled, _, seconds in plans:
            paths = certain + sampled
            if n < len(paths):
                seconds[paths[n]] = seconds_of(sources[paths[n]])
    for build, sources, certain, sampled, others, seconds in plans:
        total, error = sum_of(certain, sampled, others, seconds)
        print(f"{build}: {len(sources)} sources, {total:.0f} +- {error:.0f} s of processor time")
        for path in sorted(seconds, key=seconds.get, reverse=True)[:10]:
            print(f"  {seconds[path]:7.1f} s  {path}")
    if options.csv:
        with open(options.csv, "w", newline="") as file:
            lines = csv.writer(file, lineterminator="\n")
            lines.writerow(["build", "source", "seconds"])
            for build, _, _, _, _, seconds in plans:
                lines.writerows([build, path, f"{value:.2f}"] for path, value in sorted(seconds.items()))


if __name__ == "__main__":
    main()
