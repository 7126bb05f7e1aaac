"""Results of runs from their directory."""
import os

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
