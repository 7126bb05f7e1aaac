#!/usr/bin/env python3
"""Planted powders: draws powder parameters, simulates the measurements of a plant with them and other seeds, adds
noise, hides the parameters, and lets `diefill calibrate` find them again.

    tests/calibration/planted_powders.py --trials 3 --out /tmp/planted

Two parameters (friction, work of adhesion); discharge through a slit at three shoe speeds and the solid fraction
of the powder, from the coarse scene sample_tools/tradeoff/slit_discharge.toml with still coarser grains. Prints for
each trial the truth, the intervals, whether the truth lies in the 90 % region (normal approximation of the samples)
and the core minutes; then how many of all did."""
import argparse
import json
import math
import os
import random
import statistics
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCENES = os.path.join(ROOT, "sample_tools", "tradeoff")
SPEEDS = [0.2, 0.4, 0.8]  # m/s
WIDTH = 9.6  # mm, periodic length of the slit
FIRST_SEED = 1000  # of the hidden simulations
FRICTION, ADHESION = (0.1, 1.0), (0.001, 0.1)  # ranges; the second logarithmic, J/m^2
NORMAL_REGION = 4.605  # chi^2 that holds 90 % with two parameters
COARSE = ["powder.grain_diameter = '2.35 mm'", "pour.fill_height = '9 mm'"]


def run(arguments):
    result = subprocess.run(arguments, capture_output=True, text=True)
    if result.returncode != 0:
        sys.exit(" ".join(arguments) + "\n" + result.stdout + result.stderr)
    return result.stdout


def simulated(options, folder, name, speed, truth):
    """Folders of repeats of the slit with the planted powder, at seeds that the calibration does not use."""
    scene = os.path.join(folder, name + ".toml")
    with open(scene, "w") as file:
        file.write(planted_scene(speed, truth))
    out = os.path.join(folder, name)
    run([options.program, "compare", scene, "--seeds", str(options.repeats), "--jobs", str(options.jobs), "--out", out,
         "--quiet"])
    return [os.path.join(out, "as_it_is", "seed-%d" % (FIRST_SEED + k)) for k in range(options.repeats)]


def through_slit(folder):
    """g per mm of slit that had passed it in the end."""
    last = open(os.path.join(folder, "probe_slit.csv")).read().split("\n")[-2]
    return 1e3 * float(last.split(",")[1]) / WIDTH


def planted_scene(speed, truth):
    """The slit's scene with the planted powder and coarser grains, line by line."""
    new = {"seed": str(FIRST_SEED), "grain_diameter": '"2.35 mm"', "fill_height": '"9 mm"', "velocity": '"%g m/s"' % speed}
    lines = []
    for line in open(os.path.join(SCENES, "slit_discharge.toml")).read().splitlines():
        key = line.split("=")[0].strip()
        if key in new:
            line = "%s = %s" % (key, new[key])
        if key == "file":
            line = 'file = "%s"' % os.path.normpath(os.path.join(SCENES, line.split('"')[1]))
        lines.append(line)
        if key == "preset":
            lines += ["friction = %.8g" % truth[0], 'work_of_adhesion = "%.8g J/m^2"' % truth[1]]
    return "\n".join(lines) + "\n"


def noisy(values, share, generator):
    """Mean of simulated repeats with noise of a share of it, and the standard deviation of both."""
    mean = statistics.fmean(values)
    scatter = statistics.stdev(values) / math.sqrt(len(values))
    deviation = math.hypot(share * mean, scatter)
    return mean + share * mean * generator.gauss(0, 1), deviation


def write_calibration(path, masses, fraction):
    text = 'title = "Planted powder"\nseed = 1\n'
    text += '\n[[parameter]]\nkey = "powder.friction"\nfrom = %g\nto = %g\n' % FRICTION
    text += '\n[[parameter]]\nkey = "powder.work_of_adhesion"\nfrom = "%g J/m^2"\nto = "%g J/m^2"\nscale = "logarithmic"\n' % ADHESION
    head = 'scene = "%s"\nset = %s\n'
    slit = os.path.join(SCENES, "slit_discharge.toml")
    text += '\n[[measurement]]\nname = "slit"\nfigure = "mass_through_slit"\nover = "step.1.velocity"\n' + head % (slit, json.dumps(COARSE))
    text += "at = [%s]\n" % ", ".join('"%g m/s"' % speed for speed in SPEEDS)
    text += "values = [%s]\n" % ", ".join('"%.6g g/mm"' % mass for mass, _ in masses)
    text += "deviations = [%s]\n" % ", ".join('"%.3g g/mm"' % deviation for _, deviation in masses)
    text += '\n[[measurement]]\nname = "apparent density"\nfigure = "bulk_solid_fraction"\n'
    text += head % (slit, json.dumps(COARSE + ["step.1.velocity = '%g m/s'" % SPEEDS[0]]))
    text += 'value = "%.6g"\ndeviation = "%.3g"\n' % fraction
    open(path, "w").write(text)


def trial(options, number, generator):
    truth = (generator.uniform(0.2, 0.9), math.exp(generator.uniform(math.log(0.002), math.log(0.05))))
    folder = os.path.join(options.out, "trial-%02d" % number)
    os.makedirs(folder, exist_ok=True)
    masses, fractions = [], []
    for k, speed in enumerate(SPEEDS):
        runs = simulated(options, folder, "truth-%d" % k, speed, truth)
        masses.append(noisy([through_slit(run) for run in runs], options.noise, generator))
        if k == 0:
            reports = [json.load(open(os.path.join(run, "report.json"))) for run in runs]
            fractions = noisy([report["bulk_solid_fraction"] for report in reports], 0.01, generator)
    path = os.path.join(folder, "calibration.toml")
    write_calibration(path, masses, fractions)
    run([options.program, "calibrate", path, "--out", os.path.join(folder, "found"), "--jobs", str(options.jobs), "--quiet"])
    account = json.load(open(os.path.join(folder, "found", "calibration.json")))
    return truth, account


def inside(truth, account):
    """Whether the truth lies in the region: distance in the samples' covariance, adhesion by its logarithm."""
    samples = [(a, math.log(b)) for a, b in account["samples"]]
    place = (truth[0], math.log(truth[1]))
    mean = [statistics.fmean(column) for column in zip(*samples)]
    off = [[value - m for value, m in zip(sample, mean)] for sample in samples]
    count = len(samples) - 1
    xx = sum(a * a for a, _ in off) / count
    yy = sum(b * b for _, b in off) / count
    xy = sum(a * b for a, b in off) / count
    dx, dy = place[0] - mean[0], place[1] - mean[1]
    determinant = xx * yy - xy * xy
    return (dx * dx * yy - 2 * dx * dy * xy + dy * dy * xx) / determinant < NORMAL_REGION


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "bin", "diefill"))
    parser.add_argument("--trials", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--repeats", type=int, default=5, help="simulated repeats of each measurement")
    parser.add_argument("--noise", type=float, default=0.03, help="relative noise added to the masses")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--out", required=True)
    options = parser.parse_args()
    held = 0
    for number in range(1, options.trials + 1):
        generator = random.Random(1000 * options.seed + number)
        truth, account = trial(options, number, generator)
        holds = inside(truth, account)
        held += holds
        minutes = sum(point["core_seconds"] or 0 for point in account["points"]) / 60
        print("trial %d: %s, chi^2 %.3g of %d, %d points, %.1f core minutes" %
              (number, "in the region" if holds else "NOT in the region", account["chi_square"],
               account["fitted_values"], len(account["points"]), minutes))
        for value, parameter in zip(truth, account["parameters"]):
            print("  %-28s planted %.4g, found %.4g, 90 %% interval %.4g to %.4g" %
                  (parameter["key"], value, parameter["best"], parameter["lower_90"], parameter["upper_90"]))
        for sentence in account["insights"]:
            print("  " + sentence)
        sys.stdout.flush()
    print("%d of %d planted powders lie in the 90 %% region" % (held, options.trials))


if __name__ == "__main__":
    main()
