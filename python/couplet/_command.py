"""The command, run for an answer.

It runs in a process of its own, as it does in a shell: Ctrl-C ends it and what it had begun to write, its threads are not ours, and no
handler of signals is set in Python's process.
"""

from __future__ import annotations

import os

from ._asked import keyed
from ._core import CoupletError, UndecidedError
from ._exact import exact, no_text, text_of

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_PROGRAM = "import sys; sys.path.insert(0, {!r}); from couplet.__main__ import main; sys.exit(main())"
_NAME = "couplet: "


class Done:
    """What a command did: its exit code, what it wrote, what it says went wrong, and the other lines that it said."""

    def __init__(self, code: int, output: bytes, said: str) -> None:
        self.code, self.output = code, output
        lines = [line for line in said.splitlines() if line]
        # The last of its own lines is why it failed; those before are notes.
        own = [line.removeprefix(_NAME) for line in lines if line.startswith(_NAME)]
        self.sentence = keyed(own.pop()) if code and own else ""
        self.notes = [keyed(note) for note in own]
        self.lines = [line for line in lines if not line.startswith(_NAME)]

    def failure(self) -> Exception:
        """The exception for it."""
        if self.code == 1:
            return UndecidedError(self.sentence)
        if self.code == 2:
            return CoupletError(self.sentence)
        return OSError(self.sentence or f"the command ended with {self.code}")


def run(arguments: list[str], data: bytes = b"") -> Done:
    """Runs the command; its notes are warnings."""
    import subprocess
    import warnings
    from multiprocessing.spawn import get_executable

    home = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    line = [os.fsdecode(get_executable()), "-I", "-S", "-c", _PROGRAM.format(home), *arguments]
    if any("\0" in argument for argument in arguments):
        raise CoupletError("a text has a character of the code 0")
    try:
        ran = subprocess.run(line, input=data, capture_output=True)
    except UnicodeEncodeError as error:
        text = error.object.partition("=")[2] or error.object
        raise CoupletError(no_text(text)) from None
    done = Done(ran.returncode, ran.stdout, ran.stderr.decode(errors="replace"))
    for note in done.notes:
        warnings.warn(note, stacklevel=4)
    return done


def answer(arguments: list[str], data: bytes = b"") -> bytes:
    """What the command writes; an exception if it fails."""
    done = run(arguments, data)
    if done.code:
        raise done.failure()
    return done.output


def options(named: dict[str, Any]) -> list[str]:
    """Options of keywords: True is a flag, and of a list there are commas between its members."""
    given = []
    for name, value in named.items():
        option = "--" + name.replace("_", "-")
        if value is True:
            given.append(option)
        elif value is not None and value is not False:
            given.append(f"{option}={_text(value, name)}")
    return given


def _text(value: Any, name: str) -> str:
    if hasattr(value, "tolist"):
        # Of NumPy.
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return ",".join(_text(inner, name) for inner in value)
    return text_of(value) if isinstance(value, int) else exact(value, name.replace("_", " "))
