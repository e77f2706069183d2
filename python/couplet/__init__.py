"""Certified states and constants of circular masonry arches with finite friction: every digit is proved.

    >>> import couplet
    >>> s = couplet.state(half_opening="80deg", friction="0.25", digits=12)
    >>> s.verdict, s.mode, str(s.thickness)
    ('stands', '[s,r,r]', '0.106436506406')

A number that is given is exact: text ("0.1", "1/3", "pi/2", "80deg"), int, Fraction and Decimal are what they say; **a float
is exactly the double that it is**, so that 0.1 is not one tenth. Every answer has a verdict as a value, and
``'undecided'`` is one of them. An argument that makes no sense, is missing, or does not belong there is a CoupletError, a ValueError, in the
words of the command; one that is no number is a TypeError. Where an answer has no verdict, what is not proved is an UndecidedError.
"""

from __future__ import annotations

from . import _asked, _core, _exact
from ._answers import Answer, Assessment, Checked, Constants, Decision, Found, State, Survey, Tilted, Voussoirs
from ._arches import assess, certify, find, state, tilt, voussoirs
from ._arrays import FOUND, VERDICTS, finds, reasons, states, states_columns, states_frame
from ._certified import Certified
from ._commands import Curve, Judged, Picture, Ran, audit, curve, draw, equation, figure, judge, run, sample, states_of
from ._commands import map as map
from ._core import CoupletError, UndecidedError, __version__
from ._frames import add_states
from ._sweeps import Swept, sweep

TYPE_CHECKING = False
if TYPE_CHECKING:
    import os

    from ._codes import Mode, Verdict
    from ._types import Landmark, LandmarkName, Literal, Sequence

__all__ = [
    "FOUND", "LANDMARKS", "MODES", "VERDICTS", "Answer", "Assessment", "Certified", "Checked", "Constants", "CoupletError",
    "Curve", "Decision", "Found", "Judged", "Mode", "Picture", "Ran", "State", "Survey", "Swept", "Tilted",
    "UndecidedError", "Verdict", "Voussoirs", "__version__", "add_states", "assess", "audit", "certify", "check", "claims",
    "constants", "curve", "draw", "equation", "figure", "find", "finds", "judge", "prove", "reasons", "run", "sample",
    "state", "states", "states_columns", "states_frame", "states_of", "sweep", "tilt", "voussoirs",
]  # fmt: skip

#: The modes of collapse, joints from the shoulder inward; the codes of ``states`` are places in it.
MODES: tuple[str, ...] = tuple(_core.modes())
#: The landmarks.
LANDMARKS: tuple[Landmark, ...] = ("T", "S", "J", "B", "l", "L", "sb")


def __getattr__(name: str) -> object:
    # What has enums is imported by those who want them.
    if name in ("Mode", "Verdict"):
        from . import _codes

        return getattr(_codes, name)
    raise AttributeError(f"module 'couplet' has no attribute {name!r}")


def constants(
    landmark: Landmark | LandmarkName,
    weight: str = "milankovitch",
    *,
    digits: int = 30,
    quantities: str | Sequence[str] = (),
    threads: int = 0,
) -> Constants:
    """The constants of a landmark, each proved to exist, to be unique in a box, and to have the digits shown.

    Args:
        landmark: symbol or name: T triple, S shift, J junction, B border, l rotation-end, L overturning-end, sb widest-joint.
        weight: the model of self-weight, 'heyman' or 'milankovitch'.
        digits: significant digits, 1 to 1,000,000.
        quantities: only these ('thickness', 'friction', ...); all if none is named.
        threads: threads to compute with; 0 for one on each core.

        >>> str(couplet.constants("T", "heyman")["thickness"])
        '0.679604732098885514787534896210'
    """
    names, threads = _asked.words(quantities), _exact.whole(threads)
    told = _asked.asked(_core.constants, landmark, weight, names, _exact.text_of(digits), threads)
    return Constants((("landmark", told["landmark"]), ("weight", told["weight"]), ("digits", digits)), told)


def check(certificate: bytes | bytearray | memoryview | str | os.PathLike[str], *, engine: Literal["astro", "mpfr"] = "astro") -> Checked:
    """Checks a certificate: that the equations have the root claimed, and that every digit is right. Nothing that it says is believed.

    Args:
        certificate: its JSON as bytes or str, or the path of its file (pathlib.Path).
        engine: the arithmetic, 'astro' (pure Rust, shares nothing with MPFR, up to 50,000 digits) or 'mpfr' (up to 1,000,000).

    Raises: CoupletError if there is no such arithmetic here, or a str is a path and no JSON; OSError if a file cannot be read.

        >>> couplet.check(couplet.certify("T", digits=20))
        Checked(verdict='accepted', digits=20)
    """
    if isinstance(certificate, str):
        if "{" not in certificate and (certificate.endswith(".json") or "/" in certificate or "\\" in certificate):
            raise CoupletError(f"{certificate!r} is no JSON; for the file of that name give pathlib.Path({certificate!r})")
        # What is no text is no certificate, which the checker says.
        certificate = certificate.encode(errors="surrogatepass")
    elif hasattr(certificate, "__fspath__"):
        from pathlib import Path

        certificate = _asked.asked(Path(certificate).read_bytes)
    elif not isinstance(certificate, (bytes, bytearray, memoryview)):
        raise TypeError(f"a certificate is bytes, a str or the path of its file, not {type(certificate).__name__}")
    return Checked((), _asked.asked(_core.check, bytes(certificate), engine))


def claims() -> list[tuple[str, str, str]]:
    """The claims of the paper: identifier, place and statement of each."""
    return _core.claims()


def prove(*claims: str, threads: int = 0) -> list[Decision]:
    """Proves or refutes claims of the paper; all of them, which takes minutes, if none is named.

    Args:
        claims: identifiers (``claims`` lists them), or beginnings up to a hyphen: 'eq-7' has 'eq-7-eta'.
        threads: threads to compute with; 0 for one on each core.

    Raises: CoupletError if there is no such claim.

        >>> couplet.prove("eq-8")
        [Decision('eq-8', verdict='proved', as_printed='proved')]
    """
    return [Decision(told) for told in _asked.of_json(_asked.asked(_core.prove, list(claims), _exact.whole(threads)))["claims"]]
