"""Certified states and constants of circular masonry arches with finite friction: every digit is proved.

    >>> import couplet
    >>> s = couplet.state(half_opening="80deg", friction="0.25", digits=12)
    >>> s.verdict, s.mode, str(s.thickness)
    ('stands', '[s,r,r]', '0.106436506406')

A number that is given is exact: text ("0.1", "1/3", "pi/2", "80deg"), int, Fraction and Decimal are what they say; **a float
is exactly the double that it is**, so that 0.1 is not one tenth. Every answer has a verdict as a value, and
``'undecided'`` is one of them; input that makes no sense is a CoupletError, a ValueError, in the words of the command.
"""

from __future__ import annotations

from . import _core
from ._answers import Answer, Assessment, Checked, Constants, Decision, Found, State
from ._arrays import VERDICTS, states, states_columns
from ._arrays import whole as _whole
from ._asked import asked as _asked
from ._certified import Certified
from ._core import CoupletError, UndecidedError, __version__
from ._exact import exact as _exact
from ._exact import text_of as _text_of
from ._sweeps import Swept, sweep

TYPE_CHECKING = False
if TYPE_CHECKING:
    import os

    from ._exact import Exact

__all__ = [
    "LANDMARKS",
    "MODES",
    "VERDICTS",
    "Answer",
    "Assessment",
    "Certified",
    "Checked",
    "Constants",
    "CoupletError",
    "Decision",
    "Found",
    "State",
    "Swept",
    "UndecidedError",
    "__version__",
    "assess",
    "certify",
    "check",
    "claims",
    "constants",
    "find",
    "prove",
    "state",
    "states",
    "states_columns",
    "sweep",
]

#: The modes of collapse, joints from the shoulder inward; the codes of ``states`` are places in it.
MODES: tuple[str, ...] = tuple(_core.modes())
#: The landmarks.
LANDMARKS: tuple[str, ...] = ("T", "S", "J", "B", "l", "L", "sb")


def constants(
    landmark: str,
    weight: str = "milankovitch",
    *,
    digits: int = 30,
    quantities: str | list[str] | tuple[str, ...] = (),
    threads: int = 0,
) -> Constants:
    """The constants of a landmark, each proved to exist, to be unique in a box, and to have the digits shown.

    Args:
        landmark: symbol or name: T triple, S shift, J junction, B border, l rotation-end, L overturning-end, sb
            widest-joint.
        weight: the model of self-weight, 'heyman' or 'milankovitch'.
        digits: significant digits, 1 to 1,000,000.
        quantities: only these ('thickness', 'friction', ...); all if none is named.
        threads: threads to compute with; 0 for one on each core.

    Raises: CoupletError if an argument makes no sense.

        >>> str(couplet.constants("T", "heyman")["thickness"])
        '0.679604732098885514787534896210'
    """
    names = [quantities] if isinstance(quantities, str) else list(quantities)
    told = _asked(_core.constants, [landmark], weight, names, _text_of(digits), _whole(threads))
    if len(told) != 1:
        raise CoupletError("one weight at a time: heyman or milankovitch")
    given = (("landmark", told[0]["landmark"]), ("weight", told[0]["weight"]), ("digits", digits))
    return Constants(given, told[0])


def state(
    half_opening: Exact,
    friction: Exact,
    *,
    weight: str = "milankovitch",
    digits: int = 30,
    frictions: bool = True,
) -> State:
    """The state of an arch at its least thickness, proved. A float is exactly the double that it is; text is exact.

    Args:
        half_opening: from the crown to the shoulder, between 0 and pi: radians, or text with a unit ('80deg').
        friction: the coefficient, 0 or more, float('inf') for no limit; or text: 'inf', an angle ('31deg').
        weight: the model of self-weight, 'heyman' or 'milankovitch'.
        digits: significant digits, 1 to 10,000. Up to 22 cost about a third of what 30 cost.
        frictions: also the frictions at which the mode changes, and what would be enough for an arch that falls.

    Raises: CoupletError if an argument makes no sense; TypeError if it is no number.

        >>> couplet.state("pi/2", "0.38", weight="heyman", digits=12)
        State(half_opening='pi/2', friction='0.38', weight='heyman', verdict='stands', mode='[s,r,r]', thickness='0.122191586363')
    """
    told = _asked(
        _core.state,
        weight, _exact(half_opening, "half opening"), _exact(friction, "friction"), _text_of(digits), frictions
    )
    given = (("half_opening", half_opening), ("friction", friction), ("weight", told["weight"]))
    return State(given, told)


def assess(
    half_opening: Exact,
    friction: Exact,
    thickness: Exact,
    *,
    weight: str = "milankovitch",
    digits: int = 30,
) -> Assessment:
    """Whether an arch of a given thickness stands, its safety factors, and the thrusts it can bear, proved. A float is
    exactly the double that it is; text is exact.

    Args:
        half_opening, friction, weight, digits: as for ``state``.
        thickness: t/r, above 0 and at most 2.

    Raises: CoupletError if an argument makes no sense; TypeError if it is no number.

        >>> a = couplet.assess("80deg", "0.6", "0.12", digits=8)
        >>> a.verdict, str(a.geometric_safety), a.least_thrust.limited_by
        ('stands', '1.7479853', 'intrados at the haunch')
    """
    texts = (_exact(half_opening, "half opening"), _exact(friction, "friction"), _exact(thickness, "thickness"))
    told = _asked(_core.assess, weight, *texts, _text_of(digits))
    given = (("half_opening", half_opening), ("friction", friction), ("thickness", thickness), ("weight", weight))
    return Assessment(given, told)


def find(
    what: str,
    modes: str | list[str] | tuple[str, ...] | None = None,
    *,
    half_opening: Exact | None = None,
    friction: Exact | None = None,
    thickness: Exact | None = None,
    weight: str = "milankovitch",
    digits: int = 30,
) -> Found:
    """A question the other way round: the one answer, with the proof that there is no other. A float is exactly the double
    that it is; text is exact.

    Args:
        what: 'half_opening', the widest that stands with a ``friction``; 'friction', the least with which a
            ``half_opening`` stands; 'boundary', where one mode becomes another, at either.
        modes: the two modes of a boundary ('rrs/rsr'), also as ``Found.modes`` has them: ('[r,r,s]', '[r,s,r]').
        thickness: t/r, above 0 and at most 2; any if it is not given. Not of a boundary.
        weight, digits: as for ``state``.

    Raises: CoupletError if an argument makes no sense, is missing, or does not belong there.

        >>> couplet.find("friction", half_opening="80deg", thickness="0.1", digits=10).value
        Certified('friction', '0.2573157331')
    """
    kind = {"alpha": "half_opening", "mu": "friction"}.get(what, str(what)).replace("-", "_").replace(" ", "_").lower()
    needs = {"half_opening": "friction", "friction": "half_opening", "boundary": None}
    if kind not in needs:
        raise CoupletError("what is found is one of half_opening, friction, boundary")
    if isinstance(modes, (list, tuple)):
        modes = "/".join(map(str, modes))
    given = {"modes": modes, "half_opening": half_opening, "friction": friction, "thickness": thickness}
    useless = ("thickness",) if kind == "boundary" else ("modes", kind)
    for name in useless:
        if given[name] is not None:
            raise CoupletError(f"{name} does not belong here")
    if kind == "boundary" and modes is None:
        raise CoupletError("the pair of modes is missing; for example: couplet.find('boundary', 'rrs/rsr', friction='1.6')")
    need = needs[kind]
    if need is not None and given[need] is None:
        raise CoupletError(f"{need} is missing")
    told = _asked(
        _core.find,
        weight,
        modes,
        None if half_opening is None else _exact(half_opening, "half opening"),
        None if friction is None else _exact(friction, "friction"),
        None if thickness is None else _exact(thickness, "thickness"),
        _text_of(digits),
    )
    return Found((*given.items(), ("weight", weight)), told)


def certify(
    landmark: str | None = None,
    *,
    half_opening: Exact | None = None,
    friction: Exact | None = None,
    thickness: Exact | None = None,
    asymmetric: bool | str = False,
    weight: str = "milankovitch",
    digits: int = 30,
    threads: int = 0,
) -> str:
    """A certificate that ``check`` accepts without trusting the solver, as JSON (``couplet.certificate/1``). A float is
    exactly the double that it is; text is exact.

    Args:
        landmark: of a landmark; or
        half_opening, friction: of the state of an arch at its least thickness, or why it stands at none; with
        thickness: that the arch stands with it, or does not; or with
        asymmetric: of its asymmetric solution of the complementarity problem (19). True for the one that there is, or how its
            mechanism closes: 'inner_sliding', 'shoulder_opening', 'shoulder_sliding'.
        weight, digits: as for ``state``; of a landmark up to 1,000,000.
        threads: threads to compute a landmark with; 0 for one on each core.

    Raises: CoupletError if an argument makes no sense; UndecidedError if the proof does not succeed.

        >>> made = couplet.certify(half_opening="2.3", friction="1.05", asymmetric=True, digits=12)
        >>> couplet.check(made, engine="mpfr").verdict
        'accepted'
    """
    if landmark is not None:
        if half_opening is not None or friction is not None or thickness is not None or asymmetric is not False:
            raise CoupletError("a half opening, a friction, a thickness and asymmetric belong to an arch, not to a landmark")
        return _asked(_core.certify_landmark, landmark, weight, _text_of(digits), _whole(threads))
    if half_opening is None or friction is None:
        raise CoupletError("a landmark, or a half opening and a friction, are missing")
    arch = (weight, _exact(half_opening, "half opening"), _exact(friction, "friction"))
    if asymmetric is False:
        return _asked(
            _core.certify_arch, *arch, None if thickness is None else _exact(thickness, "thickness"), _text_of(digits)
        )
    if thickness is not None:
        raise CoupletError("an asymmetric solution has its own thickness: leave it out")
    return _asked(_core.certify_asymmetric, *arch, None if asymmetric is True else str(asymmetric), _text_of(digits))


def check(certificate: bytes | bytearray | memoryview | str | os.PathLike[str], *, engine: str = "astro") -> Checked:
    """Checks a certificate: that the equations have the root claimed, and that every digit is right. Nothing that it says
    is believed.

    Args:
        certificate: its JSON as bytes or str, or the path of its file (pathlib.Path).
        engine: the arithmetic, 'astro' (pure Rust, shares nothing with MPFR, up to 50,000 digits) or 'mpfr' (up to
            1,000,000). The command's malachite, which is no witness beside mpfr, is not in the package.

    Raises: CoupletError if there is no such arithmetic here, or a str is a path and no JSON; OSError if a file cannot be
        read.

        >>> couplet.check(couplet.certify("T", digits=20))
        Checked(verdict='accepted', digits=20)
        >>> couplet.check(b"{}").verdict
        'refused'
    """
    if isinstance(certificate, str):
        if "{" not in certificate and (certificate.endswith(".json") or "/" in certificate or "\\" in certificate):
            raise CoupletError(f"{certificate!r} is no JSON; for the file of that name give pathlib.Path({certificate!r})")
        # What is no text is no certificate, which the checker says.
        certificate = certificate.encode(errors="surrogatepass")
    elif isinstance(certificate, (bytearray, memoryview)):
        certificate = bytes(certificate)
    elif not isinstance(certificate, bytes):
        if not hasattr(certificate, "__fspath__"):
            kind = type(certificate).__name__
            raise TypeError(f"a certificate is bytes, a str or the path of its file, not {kind}")
        from pathlib import Path

        certificate = Path(certificate).read_bytes()
    return Checked((), _asked(_core.check, certificate, engine))


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
    import json

    return [Decision(told) for told in json.loads(_asked(_core.prove, list(claims), _whole(threads)))["claims"]]
