#!/usr/bin/env python3
"""Speed of one build of `benchmarks` over another's, the two in turns, so that other programs slow both.

    python3 tests/benchmark/race.py build/bin/benchmarks OTHER/bin/benchmarks [--filter model] [--pairs 7]

Prints for every benchmark the median, the smallest and the largest of the ratios of time, other over this, pair by
pair: above 1 this one is faster. Benchmarks that count wall time are compared by it, others by processor time.
"""
import argparse
import json
import statistics
import subprocess


def times_of(program, wanted):
    """Time of each benchmark by its name."""
    words = [program, "--benchmark_format=json", "--benchmark_min_time=0.7", "--benchmark_filter=" + wanted]
    output = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    return {row["name"]: row["real_time" if "real_time" in row["name"] else "cpu_time"]
            for row in json.loads(output)["benchmarks"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("this")
    parser.add_argument("other")
    parser.add_argument("--filter", default=".")
    parser.add_argument("--pairs", type=int, default=7)
    arguments = parser.parse_args()
    ratios = {}
    for pair in range(arguments.pairs):
        order = [arguments.this, arguments.other]
        times = {program: times_of(program, arguments.filter) for program in (order if pair % 2 == 0 else order[::-1])}
        for name, time in times[arguments.this].items():
            if name in times[arguments.other]:
                ratios.setdefault(name, []).append(times[arguments.other][name] / time)
    for name, all_of in ratios.items():
        print(f"{name:34} {statistics.median(all_of):.3f}  ({min(all_of):.3f} to {max(all_of):.3f})")


if __name__ == "__main__":
    main()
