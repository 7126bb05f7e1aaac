"""diefill: how powder fills a die.

    import diefill
    scene = diefill.Scene("my_die.toml")
    slow = scene.changed({"step.1.velocity": "0.1 m/s"})
    results = slow.run("out/slow", callback=print)
    results.figures["fill_ratio"]        # numbers of report.json, SI units
    results.powder.position              # (n, 3) array, m, no copy

Scenes are run by the program `diefill` in a process of its own, so that Ctrl-C leaves a checkpoint and a failed run
does not end Python. Results are read by this package itself. All quantities are in SI units.
"""
from ._results import (Cavity, ContactStress, Field, Instant, Powder, Probe, Profile, Results, Section,
                       SolidFraction, Stage, Summary, Tool, ToolCheck, figure_meaning)
from .comparison import Comparison, Measure
from .errors import BadInput, Error, Failed, OutOfRange, UnfinishedWarning
from .program import version
from .reading import read
from .scene import Scene, new

__all__ = ["BadInput", "Cavity", "Comparison", "ContactStress", "Error", "Failed", "Field", "Instant", "Measure",
           "OutOfRange", "Powder", "Probe", "Profile", "Results", "Scene", "Section", "SolidFraction", "Stage",
           "Summary", "Tool", "ToolCheck", "UnfinishedWarning", "figure_meaning", "new", "read", "version"]
