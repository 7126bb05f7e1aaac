"""Results of runs from their directory."""
import os
from typing import Union

from . import _results
from .errors import BadInput

Path = Union[str, "os.PathLike[str]"]


def read(directory: Path) -> _results.Results:
    """The results in `directory`, as `diefill run` wrote them. Raises BadInput where they are missing, damaged or of
    a version that cannot be read."""
    try:
        return _results.read(os.fspath(directory))
    except _results.ResultError as error:
        raise BadInput(str(error)) from None
