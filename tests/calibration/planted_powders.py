#!/usr/bin/env python3
"""Planted powders: draws powder parameters, simulates the measurements of a plant with them and other seeds, adds
noise, hides the parameters, and lets `diefill calibrate` find them again.

    tests/calibration/planted_powders.py --trials 10 --out /tmp/planted --csv tests/calibration/planted_two.csv
    tests/calibration/planted_powders.py --parameters 3 --trials 8 --out /tmp/planted --csv ...

Two parameters (friction, work of adhesion) from the discharge through a slit at three shoe speeds and the slope of a
heap; with `--parameters 3` also the damping, and the solid fraction of the powder at rest as a further measurement.
Scenes: slit_discharge and angle_of_repose of sample_tools/tradeoff with coarser, softer grains and less powder. A
truth lies in the 90 % region where the density of the region's samples (Gaussian kernels, Scott's width) is above the
tenth of the samples with the least.

The filled mass of a die (the square of sample_tools/small_dies, the same grains) is not fitted but predicted, as a
measurement with use = "check". Columns, in g: die_planted and die_scatter, mean and standard deviation of runs of the
planted powder; die_best, that of the best powder; die_lower and die_upper, least and largest of runs of the best powder
and of powders from the region's edge. die_within is 1 where that range, widened on both sides by two standard
deviations, holds the planted powder's mean.

One row a draw is added to the CSV as soon as it is known; draws that stand there are not repeated."""
import argparse
import csv
import json
import math
import os
import random
import statistics
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCENES = os.path.join(ROOT, "sample_tools")
SLIT, REPOSE, DIE = "tradeoff/slit_discharge", "tradeoff/angle_of_repose", "small_dies/square"
SPEEDS = [0.3, 0.5, 0.8]  # m/s
WIDTH = 9.6  # mm, periodic length of the slit
FIRST_SEED = 1000  # of the hidden simulations
HEAP = "slope_of_heap_on_the_slider_deg"
BALANCE = 0.01  # g, least noise of a weighed die
COARSE = ["powder.grain_diameter = '2.35 mm'", "powder.reduced_modulus = '4 MPa'",
          "numerics.most_sheared = 0.03"]  # a few of some hundred grains are wedged at the slit's edge
# Less powder; the die's scene has another preset than the slit's, which a calibration takes the powder from.
CHANGES = {SLIT: ["pour.fill_height = '8 mm'"], REPOSE: ["pour.fill_height = '12 mm'"],
           DIE: ["pour.fill_height = '8 mm'", "powder.preset = 'ASC100.29 D2'"]}


class Parameter:
    """Key, unit, range of the calibration and of the draws; all but friction are spread over their logarithm."""

    def __init__(self, key, unit, search, drawn, logarithmic):
        self.key, self.unit, self.search, self.drawn, self.logarithmic = key, unit, search, drawn, logarithmic

    def place(self, value):
        return math.log(value) if self.logarithmic else value

    def draw(self, generator):
        value = generator.uniform(*(self.place(end) for end in self.drawn))
        return math.exp(value) if self.logarithmic else value

    def text(self, value):
        return "%.8g" % value if not self.unit else "'%.8g %s'" % (value, self.unit)


PARAMETERS = [
    Parameter("powder.friction", "", (0.1, 1.0), (0.2, 0.9), False),
    Parameter("powder.work_of_adhesion", "J/m^2", (0.001, 0.1), (0.002, 0.05), True),
    Parameter("powder.damping_over_radius", "Pa s/m", (2e5, 2e6), (3e5, 1.5e6), True),
]


def run(arguments):
    result = subprocess.run(arguments, capture_output=True, text=True)
    if result.returncode != 0:
        raise RuntimeError(" ".join(arguments) + "\n" + result.stdout[-2000:] + result.stderr[-2000:])
    return result.stdout


def scene_file(name):
    return os.path.join(SCENES, name + ".toml")


def planted_scene(name, settings):
    """The scene's text with absolute files and settings such as "powder.friction = 0.4", table by table."""
    wanted = {}
    for setting in settings:
        path, value = setting.split(" = ", 1)
        table, key = path.rsplit(".", 1)
        wanted.setdefault(table.replace("step.1", "step"), {})[key] = value
    lines, table, left = [], "", {}
    for line in open(scene_file(name)).read().splitlines() + ["[end]"]:
        if line.startswith("["):
            lines += ["%s = %s" % item for item in left.items()]
            table = line.split("#")[0].strip().strip("[]")
            left = dict(wanted.pop(table, {}))
        key = line.split("=")[0].strip()
        if key in left:
            line = "%s = %s" % (key, left.pop(key))
        if key == "seed":
            line = "seed = %d" % FIRST_SEED
        if key == "file":
            line = 'file = "%s"' % os.path.normpath(os.path.join(os.path.dirname(scene_file(name)), line.split('"')[1]))
        lines.append(line)
    return "\n".join(lines[:-1]) + "\n"


def simulated(options, folder, name, scene, settings, repeats):
    """Folders of repeats of a scene with the planted powder, at seeds that the calibration does not use."""
    path, out = os.path.join(folder, name + ".toml"), os.path.join(folder, name)
    with open(path, "w") as file:
        file.write(planted_scene(scene, COARSE + CHANGES[scene] + settings))
    run([options.program, "compare", path, "--seeds", str(repeats), "--jobs", str(options.jobs), "--out", out,
         "--quiet"])
    return [os.path.join(out, "as_it_is", "seed-%d" % (FIRST_SEED + k)) for k in range(repeats)]


def through_slit(folder):
    """g per mm of slit that had passed it in the end."""
    last = open(os.path.join(folder, "probe_slit.csv")).read().split("\n")[-2]
    return 1e3 * float(last.split(",")[1]) / WIDTH


def figure(folder, name):
    return json.load(open(os.path.join(folder, "report.json")))[name]


def slopes(options, folder, powder):
    """Of heaps with the planted powder: a plant forms another where a slope cannot be measured."""
    for heaps in range(options.repeats, 4 * options.repeats + 1, options.repeats):
        folders = simulated(options, folder, "heap", REPOSE, powder, heaps)
        reports = [json.load(open(os.path.join(each, "report.json"))) for each in folders]
        found = [report[HEAP] for report in reports if HEAP in report]
        if len(found) > 1:
            return found
    raise RuntimeError("fewer than two heaps of %d have a slope: %s" % (heaps, folder))


def noisy(values, noise, generator):
    """Mean of simulated repeats with noise of a plant, and the standard deviation of both."""
    mean = statistics.fmean(values)
    deviation = math.hypot(noise, statistics.stdev(values) / math.sqrt(len(values)))
    return mean + noise * generator.gauss(0, 1), deviation


def measurement(name, scene, figure_name, settings=()):
    return '\n[[measurement]]\nname = "%s"\nfigure = "%s"\nscene = "%s"\nset = %s\n' % (
        name, figure_name, scene_file(scene), json.dumps(COARSE + CHANGES[scene] + list(settings)))


def write_calibration(path, parameters, options, masses, slope, fraction, die):
    text = 'title = "Planted powder"\nseed = 1\n'
    for each in parameters:
        text += "\n[[parameter]]\nkey = \"%s\"\nfrom = %s\nto = %s\n" % (
            each.key, each.text(each.search[0]), each.text(each.search[1]))
        text += 'scale = "logarithmic"\n' if each.logarithmic else ""
    text += measurement("slit", SLIT, "mass_through_slit") + 'over = "step.1.velocity"\n'
    text += "at = [%s]\n" % ", ".join('"%g m/s"' % speed for speed in SPEEDS)
    text += "values = [%s]\n" % ", ".join('"%.6g g/mm"' % mass for mass, _ in masses)
    text += "deviations = [%s]\n" % ", ".join('"%.3g g/mm"' % deviation for _, deviation in masses)
    text += measurement("heap", REPOSE, HEAP)
    text += 'value = "%.6g deg"\ndeviation = "%.3g deg"\n' % slope
    if fraction:
        text += measurement("powder at rest", SLIT, "bulk_solid_fraction",
                            ["step.1.velocity = '%g m/s'" % SPEEDS[0]])
        text += 'value = "%.6g"\ndeviation = "%.3g"\n' % fraction
    text += measurement("die", DIE, "filled_mass_kg")
    text += 'use = "check"\nvalue = "%.6g g"\ndeviation = "%.3g g"\n' % die
    text += "\n[search]\nseeds = %d\nstart_points = %d\nmost_points = %d\n" % (
        options.seeds, 4 + 2 * len(parameters), 6 + 5 * len(parameters))
    open(path, "w").write(text)


def trial(options, parameters, number):
    generator = random.Random(1000 * options.seed + number)
    truth = [each.draw(generator) for each in parameters]
    powder = ["%s = %s" % (each.key, each.text(value)) for each, value in zip(parameters, truth)]
    folder = os.path.join(options.out, "%d-parameters-trial-%02d" % (len(parameters), number))
    os.makedirs(folder, exist_ok=True)
    masses, fraction = [], None
    for k, speed in enumerate(SPEEDS):
        runs = simulated(options, folder, "slit-%d" % k, SLIT, powder + ["step.1.velocity = '%g m/s'" % speed],
                         options.repeats)
        values = [through_slit(each) for each in runs]
        masses.append(noisy(values, options.noise * statistics.fmean(values), generator))
        if k == 0 and len(parameters) > 2:
            fraction = noisy([figure(each, "bulk_solid_fraction") for each in runs], 0.003, generator)
    slope = noisy(slopes(options, folder, powder), options.angle_noise, generator)
    dies = simulated(options, folder, "die", DIE, powder, options.die_repeats)
    filled = [1e3 * figure(each, "filled_mass_kg") for each in dies]
    die = noisy(filled, max(options.noise * statistics.fmean(filled), BALANCE), generator)
    path, found = os.path.join(folder, "calibration.toml"), os.path.join(folder, "found")
    write_calibration(path, parameters, options, masses, slope, fraction, die)
    again = ["--resume"] if os.path.exists(found) else []
    run([options.program, "calibrate", path, "--out", found, "--jobs", str(options.jobs), "--quiet"] + again)
    return truth, filled, json.load(open(os.path.join(found, "calibration.json")))


def inside(truth, account, parameters):
    """Whether the truth lies in the region that holds 90 % of the samples."""
    places = [[each.place(value) for each, value in zip(parameters, sample)] for sample in account["samples"]]
    spread = [statistics.stdev(column) for column in zip(*places)]
    width = len(places) ** (-1 / (len(spread) + 4))  # Scott 1992

    def density(place):
        return sum(math.exp(-0.5 * sum(((a - b) / (width * s)) ** 2 for a, b, s in zip(place, other, spread)))
                   for other in places)

    least = sorted(density(place) for place in places)[len(places) // 10]
    return density([each.place(value) for each, value in zip(parameters, truth)]) >= least


def predicted_die(filled, account):
    """Columns of the die's mass: planted, with its scatter over seeds, and predicted."""
    planted, scatter = statistics.fmean(filled), statistics.stdev(filled)
    found = next(each for each in account["measurements"] if each["name"] == "die")["data"][0]
    best, lower, upper = (found[key] for key in ("simulated", "lower_90", "upper_90"))
    within = lower is not None and lower - 2 * scatter <= planted <= upper + 2 * scatter
    columns = {"planted": planted, "scatter": scatter, "best": best, "lower": lower, "upper": upper}
    row = {"die_" + name: "" if value is None else "%.4g" % value for name, value in columns.items()}
    return {**row, "die_within": int(within)}


def row_of(number, truth, filled, account, parameters):
    row = {"trial": number, "in_region": int(inside(truth, account, parameters)),
           "chi_square": "%.3g" % account["chi_square"], "values": account["fitted_values"],
           "points": len(account["points"]),
           "core_minutes": "%.2f" % (sum(point["core_seconds"] or 0 for point in account["points"]) / 60)}
    for value, found in zip(truth, account["parameters"]):
        key = found["key"].split(".")[1]
        for name, number in (("planted", value), ("best", found["best"]), ("lower_90", found["lower_90"]),
                             ("upper_90", found["upper_90"])):
            row["%s_%s" % (key, name)] = "%.4g" % number
    return {**row, **predicted_die(filled, account)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "bin", "diefill"))
    parser.add_argument("--parameters", type=int, default=2, choices=(2, 3))
    parser.add_argument("--trials", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--repeats", type=int, default=3, help="simulated repeats of each measurement")
    parser.add_argument("--die-repeats", type=int, default=5, help="the same of the die, for its scatter over seeds")
    parser.add_argument("--seeds", type=int, default=1, help="runs of each set of parameters in the calibration")
    parser.add_argument("--noise", type=float, default=0.03, help="relative noise added to the masses")
    parser.add_argument("--angle-noise", type=float, default=1, help="noise of the slope, deg")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--out", required=True)
    parser.add_argument("--csv", required=True)
    options = parser.parse_args()
    parameters = PARAMETERS[:options.parameters]
    rows = list(csv.DictReader(open(options.csv))) if os.path.exists(options.csv) else []
    for number in range(1, options.trials + 1):
        if any(int(row["trial"]) == number for row in rows):
            continue
        row = row_of(number, *trial(options, parameters, number), parameters)
        print(", ".join("%s %s" % item for item in row.items()), flush=True)
        rows.append(row)
        with open(options.csv, "w", newline="") as file:
            writer = csv.DictWriter(file, row.keys())
            writer.writeheader()
            writer.writerows(rows)
    held = sum(int(row["in_region"]) for row in rows)
    predicted = [int(row["die_within"]) for row in rows if row.get("die_within") not in (None, "")]
    print("%d of %d planted powders lie in the 90 %% region; the mass of the die is predicted within scatter for %d of "
          "%d; at most %s core minutes" %
          (held, len(rows), sum(predicted), len(predicted), max((row["core_minutes"] for row in rows), key=float)))


if __name__ == "__main__":
    sys.exit(main())
