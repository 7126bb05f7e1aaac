"""Finds the program `diefill`, runs it with progress, stops it, and raises its errors as exceptions."""
import errno
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import warnings
from pathlib import Path
from typing import IO, Any, Callable, List, Optional, Sequence

from .errors import UNFINISHED, BadInput, Failed, UnfinishedWarning, error_of
from .paths import require_passable

Callback = Callable[[float, str], object]
"""Called about twice a second with the share done (0 to 1) and the current task. An exception that it raises stops the
work."""

_PROGRESS = re.compile(r"\s*(\d+) %  (.*)$")
_FAILED_RUN = re.compile(r'".*", seed \d+ failed: ')  # of a comparison, which prints no other error
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

    def error_message(self, code: int) -> str:
        """The line that says why the program ended with `code`."""
        said = [line[len("diefill: "):] for line in self.lines if line.startswith("diefill: ")]
        failed = [line for line in self.lines if _FAILED_RUN.match(line)]
        if said:
            return said[-1]
        if code < 0:
            return f"the program was ended by {_signal_name(-code)}; " + (
                "memory may have run out: use larger grains" if code == -signal.SIGKILL else "run it again")
        if failed:
            return failed[0] + ("" if len(failed) == 1 else f"; {len(failed) - 1} more failed: see comparison.json")
        return self.lines[-1] if self.lines else f"the program ended with exit code {code} and without a message"


def _signal_name(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


def _started(command: Sequence[str], output: IO[str]) -> "subprocess.Popen[str]":
    """Starts the program. Raises Failed where it cannot be started, BadInput where its arguments are too long."""
    environment = dict(os.environ, DIEFILL_PROGRESS_SECONDS=_SECONDS_BETWEEN_CALLS)
    try:
        # A session of its own: the terminal's Ctrl-C reaches Python alone, which passes it on.
        return subprocess.Popen(command, stdout=output, stderr=subprocess.PIPE, env=environment, text=True,
                                encoding="utf-8", errors="replace", start_new_session=True)
    except OSError as error:
        if error.errno == errno.E2BIG:
            raise BadInput("changes: longer than a command line may be; write them into the scene file") from None
        raise Failed(f"{command[0]}: cannot be started: {error.strerror}; install diefill, or name the program in the "
                     "environment as DIEFILL_PROGRAM") from None


def _stop(process: "subprocess.Popen[str]") -> None:
    """Asks the program to end as Ctrl-C does, which leaves a checkpoint, and waits for that."""
    process.send_signal(signal.SIGINT)
    assert process.stderr is not None
    for _ in process.stderr:
        pass
    process.wait()


def _exit_code(process: "subprocess.Popen[str]", output_lines: _Output) -> int:
    """Reads what the program says until it ends. Where an exception comes in between, the program stops first."""
    assert process.stderr is not None
    try:
        for line in process.stderr:
            output_lines.take(line.rstrip("\n"))
        return process.wait()
    except BaseException:
        _stop(process)
        raise
    finally:
        process.stderr.close()


def call(arguments: Sequence[object], callback: Optional[Callback] = None) -> str:
    """Runs the program; returns its standard output. Raises BadInput, OutOfRange or Failed with its line. On Ctrl-C,
    and when `callback` raises, the program stops with a checkpoint first."""
    if callback is not None and not callable(callback):
        raise BadInput(f"callback: found {callback!r}, expected a function of the share done (0 to 1) and the task")
    command = [find_program()] + [str(argument) for argument in arguments]
    for argument in command:
        require_passable(argument, "argument")
    output_lines = _Output(callback)
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as output:
        code = _exit_code(_started(command, output), output_lines)
        if code == UNFINISHED:
            warnings.warn(output_lines.error_message(code), UnfinishedWarning, stacklevel=3)
        elif code != 0:
            raise error_of(code, output_lines.error_message(code))
        output.seek(0)
        return output.read()


def call_for_json(arguments: Sequence[object], callback: Optional[Callback] = None) -> Any:
    """What `call` returns, read as JSON. Raises Failed where it is none."""
    output = call([*arguments, "--json"], callback)
    try:
        return json.loads(output)
    except ValueError:
        raise Failed(f"{find_program()}: printed no JSON; is it diefill, of the version of this package?") from None


def version() -> str:
    """Version of the program, compiler, instruction set and libraries, a line each."""
    return call(["--version"]).strip()
