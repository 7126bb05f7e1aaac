"""Results of `diefill compare`: filling strategies and how they differ."""
import json
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional

from .errors import BadInput
from .paths import PathLike, path_text


class Measure(NamedTuple):
    """One measure of one variant over its seeds; None: no value. The numbers are in the unit that Comparison.units
    states for the measure, such as kg for "filled_mass_kg"."""

    mean: Optional[float]
    """Over the seeds."""
    scatter: Optional[float]
    """Standard deviation over seeds."""
    seeds: int
    """Number of seeds with a value."""
    difference: Optional[float]
    """Mean less that of the first variant."""
    interval_95: Optional[float]
    """Half width of the 95 % interval of the difference (Welch)."""
    verdict: str
    """"reference", "none", "different", "scatter unknown" or "no value"."""


class Comparison:
    """What comparison.json holds. Raises BadInput for a document of another kind."""

    def __init__(self, document: Dict[str, Any]):
        try:
            self.title: str = document["title"]
            """Of the scene."""
            self.variants: List[str] = document["variants"]
            """Their names; the first is the reference."""
            self.runs: List[Dict[str, Any]] = document["runs"]
            """One for each variant and seed, also those that failed, with their state and message."""
            self.units: Dict[str, str] = {one["key"]: one["unit"] for one in document["measures"]}
            """Unit of each measure, by key such as "filled_mass_kg"; "1": a plain number."""
        except (KeyError, TypeError):
            raise BadInput("comparison: found no document of diefill compare, expected the contents of its "
                           "comparison.json") from None
        self.document = document
        """All of comparison.json."""

    def __repr__(self) -> str:
        return f"<diefill.Comparison {self.title}: {len(self.variants)} variants, {len(self.runs)} runs>"

    def measure(self, key: str) -> Dict[str, Measure]:
        """One measure of all variants, by their names. Raises KeyError for an unknown key; `units` lists all."""
        for one in self.document["measures"]:
            if one["key"] == key:
                return {value["variant"]: Measure(**{name: value[name] for name in Measure._fields})
                        for value in one["variants"]}
        raise KeyError(f"{key!r}: no such measure; allowed: {', '.join(self.units)}")


def read_comparison(directory: PathLike) -> Comparison:
    """The comparison in `directory`, as `diefill compare` wrote it. Raises BadInput where it is missing or damaged."""
    file = Path(path_text(directory, "directory")) / "comparison.json"
    try:
        return Comparison(json.loads(file.read_text(encoding="utf-8")))
    except OSError as error:
        raise BadInput(f"{file}: {error.strerror}; run the comparison first or give another directory") from None
    except (ValueError, RecursionError):  # BadInput, wrong UTF-8 and wrong JSON are ValueErrors
        raise BadInput(f"{file}: damaged, or not of diefill compare; run the comparison again") from None
