"""diefill: how powder fills a die.

    import diefill
    scene = diefill.Scene("my_die.toml")
    slow = scene.changed({"step.1.velocity": "0.1 m/s"})
    results = slow.run("out/slow", callback=print)
    results.figures["fill_ratio"]        # numbers of report.json, SI units
    results.powder.position              # (n, 3) array, m, no copy

Scenes are run by the program `diefill` in a process of its own, so that Ctrl-C leaves a checkpoint and a failed run
does not end Python. Results are read by this package itself. Quantities are in SI units unless their name ends in
another; a Comparison states the unit of each. Wrong input raises BadInput, a ValueError.
"""
import sys as _sys
from importlib import import_module as _import_module
from pathlib import Path as _Path

try:
    _import_module("numpy")  # the compiled module loads it when it makes its first array
    _import_module("diefill._results")
except ImportError as _error:
    _folder = _Path(__file__).parent
    _built = [_file.name for _file in _folder.glob("_results.*.so")]
    if not _built:
        raise ImportError(f"diefill: the compiled module is missing in {_folder}; build it with: sh app/build.sh "
                          "--target _results") from None
    raise ImportError(
        f"diefill: {_sys.executable} (Python {_sys.version_info[0]}.{_sys.version_info[1]}) cannot load {_built[0]}: "
        f"{_error}; use the Python that it was built for, with NumPy: on Debian /usr/bin/python3 with "
        "python3-numpy") from None

from ._results import (Cavity, ContactStress, Field, Instant, Powder, Probe, Profile, Results, Section,
                       SolidFraction, Stage, Summary, Tool, ToolCheck)
from .comparison import Comparison, Measure, read_comparison
from .errors import BadInput, Error, Failed, OutOfRange, UnfinishedWarning
from .program import version
from .reading import figure_meaning, read
from .scene import Scene, new

__all__ = ["BadInput", "Cavity", "Comparison", "ContactStress", "Error", "Failed", "Field", "Instant", "Measure",
           "OutOfRange", "Powder", "Probe", "Profile", "Results", "Scene", "Section", "SolidFraction", "Stage",
           "Summary", "Tool", "ToolCheck", "UnfinishedWarning", "figure_meaning", "new", "read", "read_comparison",
           "version"]
