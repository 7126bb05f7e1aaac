#!/usr/bin/env python3
"""Speed of one build of `benchmarks` over another's, the two in turns, so that other programs slow both.

    python3 tests/benchmark/race.py build/bin/benchmarks OTHER/benchmarks [--filter model] [--pairs 7] [--at-least 0.9]

Prints for every benchmark the median, the smallest and the largest of the ratios of time, other over this, pair by
pair: above 1 this one is faster. Benchmarks that count wall time are compared by it, others by processor time. Ends with 1
where a median is below --at-least, or where the two have no benchmark in common.
"""
import argparse
import json
import statistics
import subprocess
import sys


def times_of(program, wanted):
    """Time of each benchmark by its name."""
    words = [program, "--benchmark_format=json", "--benchmark_min_time=0.7", "--benchmark_filter=" + wanted]
    output = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    return {row["name"]: row["real_time" if "real_time" in row["name"] else "cpu_time"]
            for row in json.loads(output)["benchmarks"]}


def exit_code(medians, at_least):
    """1 where nothing was compared or a median is too small, which standard error then names; else 0."""
    slow = [name for name, median in medians.items() if median < at_least]
    if not medians:
        print("race: the programs have no benchmark in common", file=sys.stderr)
    for name in slow:
        print(f"race: {name} has {medians[name]:.3f} of the other's speed; at least {at_least} is wanted", file=sys.stderr)
    return 1 if slow or not medians else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("this")
    parser.add_argument("other")
    parser.add_argument("--filter", default=".")
    parser.add_argument("--pairs", type=int, default=7)
    parser.add_argument("--at-least", type=float, default=0, help="smallest median that is no failure")
    arguments = parser.parse_args()
    ratios = {}
    for pair in range(arguments.pairs):
        order = [arguments.this, arguments.other]
        times = {program: times_of(program, arguments.filter) for program in (order if pair % 2 == 0 else order[::-1])}
        for name, time in times[arguments.this].items():
            if name in times[arguments.other]:
                ratios.setdefault(name, []).append(times[arguments.other][name] / time)
    medians = {name: statistics.median(all_of) for name, all_of in ratios.items()}
    for name, all_of in ratios.items():
        print(f"{name:34} {medians[name]:.3f}  ({min(all_of):.3f} to {max(all_of):.3f})")
    return exit_code(medians, arguments.at_least)


if __name__ == "__main__":
    sys.exit(main())
