"""The command, run for an answer: within this process, or in one of its own.

Within this process it sets no handler of signals, and its threads are those of all calls. In a process of its own it runs as in a
shell: Ctrl-C ends it and what it had begun to write.
"""

from __future__ import annotations

import os

from . import _core
from ._asked import asked, spoken, warn
from ._core import CoupletError, UndecidedError
from ._exact import exact, no_text, of_numpy, text_of, whole

TYPE_CHECKING = False
if TYPE_CHECKING:
    from ._types import Any

_PROGRAM = "import sys; sys.path.insert(0, {!r}); from couplet.__main__ import main; sys.exit(main())"
_NAME = "couplet: "
# Widths, of which a float means the decimal that it shows.
_DECIMALS = ("tolerance", "amplitude")


class Done:
    """What a command did: its exit code, what it wrote, what it says went wrong, and the other lines that it said; notes are warnings."""

    def __init__(self, code: int, output: bytes, said: list[str]) -> None:
        self.code, self.output = code, output
        # The last of its own lines is why it failed; those before are notes.
        own = [line.removeprefix(_NAME) for line in said if line.startswith(_NAME)]
        self.sentence = spoken(own.pop()) if code and own else ""
        self.lines = [line for line in said if line and not line.startswith(_NAME)]
        for note in own:
            warn(note)

    def failure(self) -> Exception:
        """The exception for it."""
        if self.code == 1:
            return UndecidedError(self.sentence)
        if self.code == 2:
            return CoupletError(self.sentence)
        return OSError(self.sentence or f"the command ended with {self.code}")


def answer(words: list[str], threads: int = 0) -> bytes:
    """What the command writes within this process; an exception if it fails."""
    done = Done(*asked(_core.command, words, whole(threads)))
    if done.code:
        raise done.failure()
    return done.output


def run(words: list[str], data: bytes = b"") -> Done:
    """Runs the command in a process of its own."""
    import subprocess
    from multiprocessing.spawn import get_executable

    home = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    line = [os.fsdecode(get_executable()), "-I", "-S", "-c", _PROGRAM.format(home), *words]
    if any("\0" in word for word in words):
        raise CoupletError("a text has a character of the code 0")
    try:
        ran = subprocess.run(line, input=data, capture_output=True)
    except UnicodeEncodeError as error:
        raise CoupletError(no_text(error.object)) from None
    return Done(ran.returncode, ran.stdout, ran.stderr.decode(errors="replace").splitlines())


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
    value = of_numpy(value)
    if name in _DECIMALS and not isinstance(value, str):
        return repr(float(value))
    if isinstance(value, (list, tuple)):
        return ",".join(_text(inner, name) for inner in value)
    return text_of(value) if isinstance(value, int) else exact(value, name.replace("_", " "))
