"""Scenes: to change, check, estimate, plan, run and compare."""
import json
import os
import re
import tempfile
from pathlib import Path
from typing import Any, Dict, List, Mapping, Optional, Sequence, Union

from . import _results
from .comparison import Comparison, read_comparison
from .errors import BadInput
from .paths import PathLike, path_argument, path_text, require_passable
from .program import Callback, call, call_for_json
from .reading import read

Value = Union[str, bool, int, float, Sequence[Any], Mapping[str, Any]]
"""Value of a key. Quantities are strings with a unit, such as "0.1 m/s". NumPy numbers and arrays are accepted as
well; a mapping is a table, such as one step."""
Changes = Mapping[str, Value]
"""Value by key, such as {"step.1.velocity": "0.1 m/s", 'tool."core rod".position': ["0 mm", "0 mm", "1 mm"]}."""

_NAME = r"""(?:[\w-]+|"(?:[^"\\\n]|\\.)*"|'[^'\n]*')"""
_KEY = re.compile(rf"[ \t]*{_NAME}(?:[ \t]*\.[ \t]*{_NAME})*[ \t]*")
_WRITTEN = "# Written by diefill.Scene.compare"


def _toml(value: Any) -> str:
    """The value as TOML writes it. Raises TypeError where TOML has no such type."""
    if hasattr(value, "tolist"):  # NumPy numbers are neither int nor bool, and NumPy 2 prints them in another way
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(str.__str__(value), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, int):
        return str(int(value))
    if isinstance(value, float):
        return repr(float(value))
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_toml(str(key))} = {_toml(one)}" for key, one in value.items()) + "}"
    if isinstance(value, Sequence) and not isinstance(value, (bytes, bytearray)):
        return "[" + ", ".join(_toml(one) for one in value) + "]"
    raise TypeError(f"{value!r} is of type {type(value).__name__}")


def _line(key: str, value: Value) -> str:
    if not isinstance(key, str) or not _KEY.fullmatch(key):
        raise BadInput(f"changes: found the key {key!r}, expected names joined by dots, such as 'step.1.velocity' or "
                       "'tool.\"core rod\".position'")
    try:
        line = f"{key} = {_toml(value)}"
    except TypeError as error:
        raise BadInput(f"{key}: {error}; allowed: strings, numbers, True and False, and lists and mappings of "
                       "these") from None
    except RecursionError:
        raise BadInput(f"{key}: found a list or mapping that holds itself or is nested too deep") from None
    require_passable(line, key)
    return line


def _lines(changes: Changes) -> List[str]:
    return [_line(key, value) for key, value in changes.items()]


def _checked(changes: Changes, what: str) -> Changes:
    """The changes. Raises BadInput, which begins with `what`, where they are no mapping."""
    if not isinstance(changes, Mapping):
        raise BadInput(f"{what}: found {changes!r}, expected a mapping of keys to values, such as "
                       '{"step.1.velocity": "0.1 m/s"}')
    return changes


def _variant_tables(variants: Mapping[str, Changes]) -> str:
    """The variants as TOML. Raises BadInput where there is none, or one has no name or no changes."""
    if not isinstance(variants, Mapping) or not variants:
        raise BadInput(f"variants: found {variants!r}, expected at least one name with its changed keys, such as "
                       '{"slow": {"step.1.velocity": "0.1 m/s"}}')
    for name in variants:
        if not isinstance(name, str):
            raise BadInput(f"variants: found the name {name!r}, expected a text, such as {str(name)!r}")
    return "".join(f"\n[[variant]]\nname = {_toml(name)}\n" +
                   "\n".join(_lines(_checked(changes, f"variant {name!r}"))) + "\n"
                   for name, changes in variants.items())


def _scene_file_beside(out: str) -> Path:
    """`out`.toml, which compare writes. Raises BadInput where it has another origin."""
    if Path(out).name in ("", os.pardir):
        raise BadInput(f"out: found {out!r}, expected a folder with a name, such as 'out/speeds'")
    file = Path(f"{Path(out)}.toml")
    if os.path.lexists(file) and not (file.is_file() and file.read_bytes().startswith(_WRITTEN.encode())):
        raise BadInput(f"{file}: found a file that compare has not written and would replace; choose another folder as "
                       "out")
    return file


def _write_whole(file: Path, text: str) -> None:
    """Writes the complete file or nothing."""
    temporary = file.with_name(f"{file.name}.{os.getpid()}.tmp")
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        temporary.write_text(text, encoding="utf-8")
        os.replace(temporary, file)
    except OSError as error:
        raise BadInput(f"{file}: cannot be written: {error.strerror}; choose another folder as out") from None


class Scene:
    """A scene file and changes to it; the file itself stays as it is. It is read and checked at each use; BadInput then
    names file, line and key."""

    def __init__(self, file: PathLike, changes: Optional[Changes] = None):
        self.file = Path(path_text(file, "file"))
        """Path of the scene file."""
        self.changes: Dict[str, Value] = {} if changes is None else dict(_checked(changes, "changes"))
        """Changed keys with their values."""

    def __repr__(self) -> str:
        return f"diefill.Scene({str(self.file)!r}, {self.changes!r})"

    def changed(self, changes: Changes) -> "Scene":
        """The same scene with these keys changed as well."""
        return Scene(self.file, {**self.changes, **_checked(changes, "changes")})

    def _arguments(self) -> List[str]:
        return [path_argument(self.file, "file")] + [f"--set={line}" for line in _lines(self.changes)]

    def check(self) -> Dict[str, Any]:
        """What `diefill check` finds: meshes, fit of the tools, wall spheres, cavity, set-up. Lengths are in m."""
        return call_for_json(["check", *self._arguments()])

    def estimate(self) -> Dict[str, Any]:
        """By formula, without grains, in about a second: mass and share filled, critical shoe speed, crossings, air.
        SI units; `diefill estimate --json` has the same entries."""
        return call_for_json(["estimate", *self._arguments()])

    def plan(self, *, minutes: Optional[float] = None, threads: Optional[int] = None, pilot: bool = True,
             callback: Optional[Callback] = None) -> Dict[str, Any]:
        """Grains, steps, memory and wall time as written and with each setting; SI units. `minutes`: also the finest
        grains that fit this wall time, as "within_minutes". `threads`: of the planned run, default all cores.
        `pilot`: run a pilot of about ten seconds, without which wall times are unknown."""
        arguments: List[object] = ["plan", *self._arguments()]
        arguments += [] if minutes is None else ["--minutes", minutes]
        arguments += [] if threads is None else ["--threads", threads]
        arguments += [] if pilot else ["--no-benchmark"]
        return call_for_json(arguments, callback)

    def run(self, out: PathLike, *, threads: Optional[int] = None, resume: bool = False,
            setting: Optional[str] = None, pictures: bool = False,
            callback: Optional[Callback] = None) -> _results.Results:
        """Runs the scene; results go to the folder `out`, earlier ones in it to previous-1 and so on. `threads`: of
        the run, default all cores. `resume`: continues from a checkpoint. `setting`: "quick", "working" or "reference".
        `pictures`: draws maps as well. `callback`: see Callback. Ctrl-C leaves a checkpoint. Raises OutOfRange where
        the run leaves the method's range; warns with UnfinishedWarning where numerics.max_time ended it."""
        arguments: List[object] = ["run", *self._arguments(), "--out", path_argument(out, "out")]
        arguments += [] if threads is None else ["--threads", threads]
        arguments += [] if setting is None else ["--setting", setting]
        arguments += ["--resume"] if resume else []
        arguments += [] if pictures else ["--no-pictures"]
        call(arguments, callback)
        return read(out)

    def compare(self, variants: Mapping[str, Changes], out: PathLike, *, seeds: int = 1, jobs: int = 1,
                callback: Optional[Callback] = None) -> Comparison:
        """Runs the scene once for each of `variants` (name: changed keys) and seed, `jobs` at a time, and reports what
        differs from the first variant by more than the scatter over seeds. Continues where it was stopped. Writes the
        scene with its variants to `out`.toml. Raises the error of the first run that failed; read_comparison(out)
        then has the others."""
        tables = _variant_tables(variants)
        folder = path_argument(out, "out")
        file = _scene_file_beside(folder)
        with tempfile.TemporaryDirectory() as temporary:
            text = self.write(Path(temporary) / "scene").read_text(encoding="utf-8")
        _write_whole(file, f"{_WRITTEN}\n{text}{tables}")
        call(["compare", path_argument(file, "out"), "--out", folder, "--seeds", seeds, "--jobs", jobs], callback)
        return read_comparison(out)

    def write(self, folder: PathLike) -> Path:
        """Writes the scene with its changes to `folder`/fill.toml, which refers to the CAD files where they are now.
        Raises BadInput if the folder exists."""
        call(["new", path_argument(folder, "folder"), "--from", *self._arguments()])
        return Path(path_text(folder, "folder")) / "fill.toml"


def new(folder: PathLike, kind: str = "rectangular_die") -> Scene:
    """Writes a commented scene with tools to start from and returns it. `kind`: "rectangular_die", "ring" or "gear".
    Raises BadInput where the folder exists."""
    call(["new", path_argument(folder, "folder"), "--kind", kind])
    return Scene(Path(path_text(folder, "folder")) / "fill.toml")
