"""Exceptions, each with the line that the program prints as its error."""
from typing import Dict, Type


class Error(Exception):
    """Anything that stops diefill; str() is one line: file, key, what was found, what is allowed, what to do."""


class BadInput(Error, ValueError):
    """The scene, a CAD file, results or an argument is wrong; nothing was overwritten (exit code 2)."""


class OutOfRange(Error):
    """The run left the range in which the method is valid; its last good checkpoint is kept (exit code 3)."""


class Failed(Error, RuntimeError):
    """Not the scene's fault, such as a full disk (exit code 1, or the program was killed)."""


class UnfinishedWarning(UserWarning):
    """numerics.max_time was reached before the scene ended: results cover the simulated time only (exit code 4)."""


UNFINISHED = 4
_OF_CODE: Dict[int, Type[Error]] = {2: BadInput, 3: OutOfRange}


def error_of(code: int, line: str) -> Error:
    """The exception for an exit code of the program and the line that it printed."""
    return _OF_CODE.get(code, Failed)(line)
