"""What is compiled: every argument is text, every answer texts and doubles. Private; the package is the door."""

from os import PathLike
from pathlib import Path
from typing import Any, Final

__all__ = [
    "CoupletError",
    "UndecidedError",
    "__version__",
    "assess",
    "certify_arch",
    "certify_asymmetric",
    "certify_landmark",
    "check",
    "claims",
    "constants",
    "drawing",
    "fields",
    "find",
    "finds",
    "modes",
    "prove",
    "quantity",
    "run",
    "state",
    "states",
    "surveyed",
    "sweep_begin",
    "sweep_part",
    "sweep_survey",
    "sweep_verify",
    "table",
    "tilted",
    "voussoirs",
]

__version__: Final[str]

#: The half opening and the friction of an arch, and what else there is.
_Texts = tuple[str | None, str | None, list[str | None] | None]

class CoupletError(ValueError): ...
class UndecidedError(ArithmeticError): ...

def modes() -> list[str]: ...
def quantity(name: str) -> str: ...
def constants(
    landmarks: list[str], weight: str, names: list[str], digits: str, threads: int
) -> list[dict[str, Any]]: ...
def fields() -> list[str]: ...
def state(weight: str, texts: _Texts, digits: str, frictions: bool) -> dict[str, Any]: ...
def assess(weight: str, texts: _Texts, digits: str) -> dict[str, Any]: ...
def surveyed(question: str, weight: str, texts: _Texts, digits: str) -> str | None: ...
def voussoirs(
    question: str, weight: str, texts: _Texts, digits: str
) -> tuple[str, list[list[dict[str, Any]]]]: ...
def tilted(weight: str, texts: _Texts, digits: str) -> tuple[str, dict[str, Any]]: ...
def find(
    target: tuple[str, str | None], weight: str, texts: _Texts, digits: str
) -> dict[str, Any]: ...
def finds(
    target: tuple[str, str | None], weight: str, rows: list[list[str | None]], threads: int
) -> list[tuple[int, list[float], str | None]]: ...
def certify_landmark(landmark: str, weight: str, digits: str, threads: int) -> str: ...
def certify_arch(weight: str, texts: _Texts, digits: str, threads: int) -> str: ...
def certify_asymmetric(weight: str, texts: _Texts, mode: str | None, digits: str) -> str: ...
def check(certificate: bytes, engine: str) -> dict[str, Any]: ...
def claims() -> list[tuple[str, str, str]]: ...
def prove(names: list[str], threads: int) -> str: ...
def drawing(weight: str, texts: _Texts, command: str) -> str | None: ...
def run(arguments: list[str]) -> int: ...
def states(
    weight: str, arrays: tuple[bytes, bytes, bytes | None], names: list[str], threads: int
) -> tuple[bytes, bytes, list[list[bytes]]]: ...
def table(
    weight: str, columns: list[str], cells: list[bytes | list[str]], names: list[str], threads: int
) -> tuple[bytes, bytes, list[tuple[bytes, bytes]], list[tuple[int, str]]]: ...
def sweep_begin(
    plan: bytes, base: str | PathLike[str], output: str | PathLike[str]
) -> tuple[Path, list[str], list[str], list[str]]: ...
def sweep_part(
    folder: str | PathLike[str], base: str | PathLike[str], part: int, threads: int
) -> tuple[int, int, int, int]: ...
def sweep_survey(
    folder: str | PathLike[str], base: str | PathLike[str], share: tuple[int, int], threads: int
) -> list[tuple[int, int, tuple[int, int, int, int] | None]]: ...
def sweep_verify(
    folder: str | PathLike[str], base: str | PathLike[str], share: tuple[int, int], sample: int, threads: int
) -> tuple[int, int, int, int, list[str]]: ...
