"""Results of `diefill compare`: filling strategies and how they differ."""
import json
import os
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Union


class Measure(NamedTuple):
    """One measure of one variant over its seeds; None: no value."""

    mean: Any
    """In the comparison's unit of the measure."""
    scatter: Any
    """Standard deviation over seeds."""
    seeds: int
    difference: Any
    """Mean less that of the first variant."""
    interval_95: Any
    """Half width of the 95 % interval of the difference (Welch)."""
    verdict: str
    """"reference", "none", "different", "scatter unknown" or "no value"."""


class Comparison:
    """What comparison.json holds."""

    def __init__(self, document: Dict[str, Any]):
        self.document = document
        self.title: str = document["title"]
        self.variants: List[str] = document["variants"]
        self.runs: List[Dict[str, Any]] = document["runs"]
        self.units: Dict[str, str] = {one["key"]: one["unit"] for one in document["measures"]}
        """Unit of each measure, by key such as "filled_mass_kg"."""

    def measure(self, key: str) -> Dict[str, Measure]:
        """One measure of all variants, by their names. Raises KeyError for an unknown key; `units` lists all."""
        for one in self.document["measures"]:
            if one["key"] == key:
                return {value["variant"]: Measure(**{name: value[name] for name in Measure._fields})
                        for value in one["variants"]}
        raise KeyError(key)


def read_comparison(directory: Union[str, "os.PathLike[str]"]) -> Comparison:
    """The comparison in `directory`."""
    return Comparison(json.loads((Path(directory) / "comparison.json").read_text(encoding="utf-8")))
