"""Paths of users, checked before the program or the compiled module gets them."""
import os
from typing import Union

from .errors import BadInput

PathLike = Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]


def path_text(path: PathLike, what: str) -> str:
    """The path as a text. Raises BadInput, which begins with `what`, for anything that names no file or folder."""
    try:
        text = os.fsdecode(path)
    except TypeError:
        raise BadInput(f"{what}: found {path!r} of type {type(path).__name__}, expected a path: a text or a "
                       "pathlib.Path") from None
    if not text:
        raise BadInput(f"{what}: found an empty text, expected a path")
    require_passable(text, what)
    return text


def path_argument(path: PathLike, what: str) -> str:
    """The path as an argument of the program, which takes what begins with a hyphen for an option."""
    text = path_text(path, what)
    return os.path.join(os.curdir, text) if text.startswith("-") else text


def require_passable(text: str, what: str) -> None:
    """Raises BadInput for a text that the system cannot pass to a program."""
    try:
        wrong = b"\0" in os.fsencode(text)
    except UnicodeEncodeError:
        wrong = True
    if wrong:
        raise BadInput(f"{what}: found {text[:80]!r} with a character that no path or command line can hold (NUL, or "
                       "half of a surrogate pair); leave it out")
