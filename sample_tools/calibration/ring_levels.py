#!/usr/bin/env python3
"""Fill levels of a ring over the azimuth, mean over the seeds of `diefill compare`, as a measured curve.

    build/bin/diefill compare sample_tools/calibration/ring.toml --seeds 5 --out out/ring
    python3 sample_tools/calibration/ring_levels.py out/ring > sample_tools/calibration/narrow_ring.csv

The deviation is that of the mean: root of the variance over seeds, averaged over the sectors, over their number."""
import json
import pathlib
import statistics
import sys

reports = sorted(pathlib.Path(sys.argv[1]).glob("as_it_is/seed-*/report.json"))
if len(reports) < 2:
    sys.exit("found %d runs in %s; a deviation needs two or more" % (len(reports), sys.argv[1]))
curves = [json.loads(report.read_text())["fill_level"] for report in reports]
sectors = list(zip(*(curve["y"] for curve in curves)))
if any(level is None for levels in sectors for level in levels):
    sys.exit("a sector has no powder: use fewer azimuth_bins in the scene")
deviation = (statistics.fmean(statistics.variance(levels) for levels in sectors) / len(curves)) ** 0.5
print("# ring.toml, mean of %d seeds" % len(curves))
print("azimuth [deg], fill level [mm], deviation [mm]")
for azimuth, levels in zip(curves[0]["x"], sectors):
    print("%g, %.4g, %.3g" % (azimuth, statistics.fmean(levels), deviation))
