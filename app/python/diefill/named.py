"""Entries of results by their names, with a message that helps where a name is not there."""
import difflib
from typing import Dict, Mapping, TypeVar

Entry = TypeVar("Entry")

_MOST_LISTED = 12


class Named(Dict[str, Entry]):
    """A dict whose KeyError says which name was probably meant, or which there are."""

    def __init__(self, what: str, entries: Mapping[str, Entry]):
        super().__init__(entries)
        self.what = what
        """What an entry is, in messages."""

    def __missing__(self, name: object) -> Entry:
        near = difflib.get_close_matches(name, self, n=1) if isinstance(name, str) else []
        names = list(self)
        if near:
            hint = f"did you mean {near[0]!r}?"
        elif not names:
            hint = "there is none"
        else:
            more = f" and {len(names) - _MOST_LISTED} more" if len(names) > _MOST_LISTED else ""
            hint = "allowed: " + ", ".join(map(repr, names[:_MOST_LISTED])) + more
        raise KeyError(f"{str(name)[:80]!r}: no such {self.what}; {hint}")
