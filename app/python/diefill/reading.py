"""Results of runs from their directory, and what their figures mean."""
import difflib
import os
from typing import Tuple

from . import _results
from .errors import BadInput
from .paths import PathLike, path_text


def read(directory: PathLike) -> _results.Results:
    """The results in `directory`, as `diefill run` wrote them. Raises BadInput where they are missing, damaged or of
    a version that cannot be read, and where the run has not ended."""
    folder = path_text(directory, "directory")
    try:
        return _results.read(os.fsencode(folder))
    except _results.ResultError as error:  # without a text where its path is not UTF-8
        raise BadInput(str(error) or f"directory: found {folder!r}, whose name is not UTF-8, without readable results; "
                                     "check its files or rename it") from None


def figure_meaning(name: str) -> Tuple[str, str]:
    """Unit of a figure of report.json ("1": a plain number), and how it is formed. Raises BadInput for a name that no
    figure has."""
    if not isinstance(name, str):
        raise BadInput(f"figure_meaning: found a value of type {type(name).__name__}, expected the name of a figure as "
                       "a text")
    meaning = _results.figure_meaning(name.encode(errors="replace"))
    if meaning is not None:
        return meaning
    near = difflib.get_close_matches(name, _results.figure_names(), n=1)
    hint = f"did you mean {near[0]!r}?" if near else "the names are the keys of Results.figures"
    raise BadInput(f"figure_meaning: found {name[:80]!r}, which is no figure of report.json; {hint}")
