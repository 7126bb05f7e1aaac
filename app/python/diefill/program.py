"""Finds the program `diefill`, runs it with progress, stops it, and raises its errors as exceptions."""
import os
import re
import shutil
import signal
import subprocess
import tempfile
import warnings
from pathlib import Path
from typing import Callable, List, Optional, Sequence

from .errors import UNFINISHED, Failed, UnfinishedWarning, error_of

Callback = Callable[[float, str], object]
"""Called about twice a second with the share done (0 to 1) and the current task. An exception that it raises stops the
work."""

_PROGRESS = re.compile(r"\s*(\d+) %  (.*)$")
_SECONDS_BETWEEN_CALLS = "0.5"


def find_program() -> str:
    """Path of the program: $DIEFILL_PROGRAM, that of the same installation or build, or that of $PATH."""
    named = os.environ.get("DIEFILL_PROGRAM")
    if named:
        return named
    above = Path(__file__).absolute().parent.parents
    for folder in above[3:4] + above[1:2]:  # of an installation; of a build
        if os.access(folder / "bin" / "diefill", os.X_OK):
            return str(folder / "bin" / "diefill")
    found = shutil.which("diefill")
    if found is None:
        raise Failed("the program diefill is missing: install it, or name it in the environment as DIEFILL_PROGRAM")
    return found


class _Output:
    """Standard error of the program, line by line: progress goes to the callback, the rest is kept."""

    def __init__(self, callback: Optional[Callback]):
        self.callback = callback
        self.lines: List[str] = []

    def take(self, line: str) -> None:
        """A line without its end."""
        progress = _PROGRESS.match(line)
        if progress is None:
            self.lines.append(line)
        elif self.callback is not None:
            self.callback(int(progress[1]) / 100, progress[2])

    def error_message(self) -> str:
        """The line that says why the program failed."""
        said = [line[len("diefill: "):] for line in self.lines if line.startswith("diefill: ")]
        return said[-1] if said else " ".join(self.lines[-3:]) or "the program ended without a message"


def _stop(process: "subprocess.Popen[str]") -> None:
    """Asks the program to end as Ctrl-C does, which leaves a checkpoint, and waits for that."""
    process.send_signal(signal.SIGINT)
    assert process.stderr is not None
    for _ in process.stderr:
        pass
    process.wait()


def call(arguments: Sequence[object], callback: Optional[Callback] = None) -> str:
    """Runs the program; returns its standard output. Raises BadInput, OutOfRange or Failed with its line. On Ctrl-C,
    and when `callback` raises, the program stops with a checkpoint first."""
    command = [find_program()] + [os.fspath(a) if isinstance(a, os.PathLike) else str(a) for a in arguments]
    environment = dict(os.environ, DIEFILL_PROGRESS_SECONDS=_SECONDS_BETWEEN_CALLS)
    output_lines = _Output(callback)
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as output:
        # A session of its own: the terminal's Ctrl-C reaches Python alone, which passes it on.
        process = subprocess.Popen(command, stdout=output, stderr=subprocess.PIPE, env=environment, text=True,
                                   encoding="utf-8", errors="replace", start_new_session=True)
        try:
            assert process.stderr is not None
            for line in process.stderr:
                output_lines.take(line.rstrip("\n"))
            code = process.wait()
        except BaseException:
            _stop(process)
            raise
        finally:
            process.stderr.close()
        if code == UNFINISHED:
            warnings.warn(output_lines.error_message(), UnfinishedWarning, stacklevel=3)
        elif code != 0:
            raise error_of(code, output_lines.error_message())
        output.seek(0)
        return output.read()


def version() -> str:
    """Version of the program, compiler, instruction set and libraries, a line each."""
    return call(["--version"]).strip()
